"""cuspidality of regional_3r, in NumPy.

Made from templates/kernel.py.j2; inputs 75e033e629be7085bf11ded7e3a5804c34f745dda6e84345d76a89b262b8c17c.
5743 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def quartic(parameters, target):
    """coefficients, lowest power of tan(theta3/2) first, of the quartic whose roots are the postures at a target: 95 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    in   target[2] = (rho_squared, z)
    out  quartic[5]
    """
    parameters = np.asarray(parameters)
    target = np.asarray(target)
    _leading = np.broadcast_shapes(parameters.shape[:-1], target.shape[:-1])
    _real = np.result_type(parameters, target, np.float32)

    # inputs, sines and cosines
    d2 = parameters[..., 4]
    z = target[..., 1]
    ca2 = parameters[..., 0]
    r2 = parameters[..., 7]
    ca3 = parameters[..., 2]
    r3 = parameters[..., 8]
    sa2 = parameters[..., 1]
    rho_squared = target[..., 0]
    d3 = parameters[..., 5]
    d4 = parameters[..., 6]
    sa3 = parameters[..., 3]

    # terms
    t1 = d2 * d2
    t2 = 4 * t1
    t3 = z - ca2 * r2 - ca2 * ca3 * r3
    t4 = t3 * t3
    t5 = t2 * t4
    t6 = sa2 * sa2
    t7 = d3 * d3
    t8 = d4 * d4
    t9 = rho_squared + z * z - t1 - t7 - t8 - r2 * r2
    t10 = r3 * r3
    t11 = t9 - t10 - r3 * (r2 * (ca3 + ca3))
    t12 = d4 * (-2 * d3)
    t13 = t11 + t12
    t14 = t2 * t6
    t15 = ca3 * ca3
    t16 = t7 + t8 * t15 + t10 * (sa3 * sa3)
    t17 = d4 * (d3 + d3)
    t18 = t8 * (1 - t15)
    t19 = t5 + t6 * (t13 * t13) - t14 * (t16 + t17 + t18)
    t20 = sa3 * (ca2 * d4)
    t21 = -t20 - t20
    t22 = t2 * (t3 + t3) * t21
    t23 = t6 + t6
    t24 = sa3 * (r2 * (-2 * d4))
    t25 = t24 + t24
    t26 = sa3 * (r3 * (d4 * (-2 * ca3)))
    t27 = t14 * (t26 + t26)
    t28 = t11 - t12
    t29 = t2 * (t21 * t21 + (t4 + t4)) + t6 * (t25 * t25 + (t13 + t13) * t28)
    t30 = t5 + t6 * (t28 * t28) - t14 * (t16 + t18 - t17)

    # results
    quartic = np.empty((*_leading, 5), _real)
    quartic[..., 0] = t19
    quartic[..., 1] = t22 + t13 * t23 * t25 - t27
    quartic[..., 2] = t29 - t14 * (t16 + t16 - (t18 + t18))
    quartic[..., 3] = t22 + t28 * (t23 * t25) - t27
    quartic[..., 4] = t30
    return quartic.reshape(_leading + (5,))


def cusp_polynomial(parameters):
    """coefficients, lowest power first, of the polynomial in tan(theta3/2) whose roots are the cusps: 246 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    out  polynomial[13]
    """
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(parameters.shape[:-1])
    _real = np.result_type(parameters, np.float32)

    # inputs, sines and cosines
    d2 = parameters[..., 4]
    ca2 = parameters[..., 0]
    sa3 = parameters[..., 3]
    d3 = parameters[..., 5]
    sa2 = parameters[..., 1]
    r2 = parameters[..., 7]
    ca3 = parameters[..., 2]
    r3 = parameters[..., 8]
    d4 = parameters[..., 6]

    # terms
    t1 = d2 * d2
    t2 = ca2 * sa3
    t3 = sa2 * sa2
    t4 = t1 * d3 * t3
    t5 = t2 * t4
    t6 = sa3 * r2
    t7 = t4 * t6 + d3 * (t3 * (t1 * (sa3 * (ca3 * r3))))
    t8 = d3 * d3
    t9 = sa3 * sa3
    t10 = d4 * t9
    t11 = t1 * t10
    t12 = t3 * (d4 * t8 - t11)
    t13 = d3 * t12
    t14 = t3 * (t13 * t13)
    t15 = ca3 * ca3
    t16 = d4 * d4
    t17 = t9 * (t8 * (ca2 * ca2) * (t1 * t1)) * (t3 * t3)
    t18 = t1 * (t5 * t5) + t3 * (t7 * t7) + t14 - (t8 + t15 * t16 + t9 * (r3 * r3)) * t17
    t19 = t7 + t7
    t20 = t3 * t11
    t21 = t6 * t20
    t22 = t3 * (t6 * (d4 * (-2 * d3)))
    t23 = d3 * t22
    t24 = t21 + t6 * t12 - t23
    t25 = t2 * (t12 + t20)
    t26 = t3 * (t19 * t24) - t1 * ((-t5 - t5) * t25)
    t27 = t26 - t17 * (d4 * (d3 + d3))
    t28 = t3 * d4
    t29 = t1 * d4 * (t2 * t2) + t28 * (t6 * t6) - t8 * t28
    t30 = t29 + t3 * (t10 * (t1 + t1))
    t31 = d3 * t20 + t6 * t22 - d3 * t30
    t32 = t3 * (t13 * (t31 + t31))
    t33 = t1 * (t25 * t25) + t3 * (t24 * t24) - t32 - t17 * (t16 * (1 - t15))
    t34 = t33 - t14
    t35 = t23 + t6 * t30 - t21
    t36 = t2 * (t20 - t30)
    t37 = t3 * (t7 * t35) - t1 * (t5 * t36)
    t38 = t37 + t37
    t39 = t2 * t22
    t40 = t1 * (t39 * t39)
    t41 = t3 * (t31 * t31)
    t42 = t40 + t41 + t1 * (t36 * (-t25 - t25)) + t3 * (t35 * (t24 + t24))
    t43 = t32 + t42
    t44 = t1 * (t36 * t36) + t3 * (t35 * t35) - t40 - t41
    t45 = t3 * (t31 * t35) - t1 * (t36 * t39)
    t46 = 4 * t45
    t47 = t1 * (t25 * t39) + t3 * (t24 * t31) - t3 * (t13 * t35)
    t48 = 4 * t47
    t49 = t1 * (t5 * t39) + t3 * (t7 * t31)
    t50 = 4 * t49
    t51 = t3 * (t13 * t24)
    t52 = 4 * t51
    t53 = t3 * (t13 * t19) + t17 * (sa3 * (r3 * (d4 * (-2 * ca3))))
    t54 = -t53 - t53
    t55 = t34 + t34
    t56 = 4 * t27
    t57 = 6 * t18
    t58 = 6 * t44
    t59 = t43 + t43
    t60 = 12 * t51
    t61 = 10 * t53
    t62 = 20 * t45
    t63 = 5 * t27
    t64 = 15 * t18
    t65 = 15 * t44
    t66 = 6 * t37
    t67 = 40 * t45
    t68 = 8 * t51
    t69 = 20 * t53
    t70 = 8 * t47
    t71 = 8 * t49
    t72 = 4 * t43 + 20 * t18 - 20 * t44 - 4 * t34

    # results
    polynomial = np.empty((*_leading, 13), _real)
    polynomial[..., 0] = t18 + t27 + t34 + t38 + t43 + t44
    polynomial[..., 1] = t46 + t48 + t50 - t52 + t54
    polynomial[..., 2] = t55 + t56 + t57 - t58 - t59
    polynomial[..., 3] = t50 - t60 - t61 - t62 - t48
    polynomial[..., 4] = t63 + t64 + t65 - t34 - t43 - t66
    polynomial[..., 5] = t67 - t68 - t69 - t70 - t71
    polynomial[..., 6] = t72
    polynomial[..., 7] = t68 + (t70 - t69 - t67 - t71)
    polynomial[..., 8] = t65 + (t64 + t66) - t34 - t43 - t63
    polynomial[..., 9] = t60 + (t62 + (t48 + t50) - t61)
    polynomial[..., 10] = t55 + t57 - t58 - t56 - t59
    polynomial[..., 11] = t52 + (t50 + t54 - t46 - t48)
    polynomial[..., 12] = t44 + (t43 + (t18 + t34)) - t27 - t38
    return polynomial.reshape(_leading + (13,))


def cusp_polynomial_right_angle(parameters):
    """coefficients, lowest power first, of the polynomial in tan(theta3/2) whose roots are the cusps, for alpha2 = +-90 deg: those with z^2 >= 0: 44 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    out  polynomial[7]
    """
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(parameters.shape[:-1])
    _real = np.result_type(parameters, np.float32)

    # inputs, sines and cosines
    d3 = parameters[..., 5]
    d2 = parameters[..., 4]
    r2 = parameters[..., 7]
    sa3 = parameters[..., 3]
    ca3 = parameters[..., 2]
    r3 = parameters[..., 8]
    d4 = parameters[..., 6]

    # terms
    t1 = d2 * d2
    t2 = r2 * sa3
    t3 = d3 * t1 * (t2 + sa3 * (ca3 * r3))
    t4 = 3 * d4
    t5 = d3 * d3
    t6 = t2 * t4 * t5
    t7 = t2 * t2
    t8 = t1 * (d4 * (sa3 * sa3))
    t9 = t2 * (d4 * t7 + t8 - t4 * t5)
    t10 = d4 * t5 - t8
    t11 = d3 * (t10 - t4 * t7)
    t12 = d3 * t10
    t13 = t11 + t11 + (-t12 - t12)
    t14 = 3 * t3
    t15 = 3 * t9

    # results
    polynomial = np.empty((*_leading, 7), _real)
    polynomial[..., 0] = t3 + t6 + t9
    polynomial[..., 1] = t13
    polynomial[..., 2] = t6 + t14 - t15
    polynomial[..., 3] = -(4 * t12 + 4 * t11)
    polynomial[..., 4] = t14 + t15 - t6
    polynomial[..., 5] = t13
    polynomial[..., 6] = t3 - t6 - t9
    return polynomial.reshape(_leading + (7,))


def aspect_polynomial(parameters):
    """coefficients, lowest power first, of the polynomial in tan(theta3/2) that is (a^2 + b^2 - c^2)/d4^2: 115 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    out  polynomial[9]
    """
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(parameters.shape[:-1])
    _real = np.result_type(parameters, np.float32)

    # inputs, sines and cosines
    d3 = parameters[..., 5]
    ca3 = parameters[..., 2]
    d4 = parameters[..., 6]
    r3 = parameters[..., 8]
    sa3 = parameters[..., 3]
    sa2 = parameters[..., 1]
    d2 = parameters[..., 4]
    r2 = parameters[..., 7]
    ca2 = parameters[..., 0]

    # terms
    t1 = d3 * d3
    t2 = ca3 * ca3
    t3 = d4 * d4
    t4 = sa3 * sa3
    t5 = t1 + t2 * t3 + r3 * r3 * t4
    t6 = sa2 * sa2
    t7 = t1 * t6
    t8 = d2 * d2
    t9 = t6 * t8
    t10 = t1 * t9
    t11 = t5 * t7 - t10
    t12 = d3 + d3
    t13 = d4 * t12
    t14 = sa3 * (r3 * (d4 * (-2 * ca3)))
    t15 = sa3 * r2
    t16 = t6 * (-2 * d3 * t15)
    t17 = t14 * t16
    t18 = t8 * t12
    t19 = d4 * t4
    t20 = t6 * (t18 * t19)
    t21 = t7 * t13 + t17 - t20
    t22 = sa3 * ca2
    t23 = t8 * (t22 * t22) + t6 * (t15 * t15) - t7
    t24 = t3 * (1 - t2)
    t25 = sa3 * (ca3 * r3)
    t26 = t10 + (t5 * t23 + t7 * t24) - t9 * (t25 * t25)
    t27 = t9 * (t19 * t19)
    t28 = t26 - t27
    t29 = t20 + (t13 * t23 - t17)
    t30 = t27 + t23 * t24
    t31 = t16 * t24
    t32 = t31 + t31
    t33 = t13 * t16 + t14 * t23 - t6 * (t19 * (t25 * (t8 + t8)))
    t34 = t33 + t33
    t35 = t5 * t16 - t6 * (t18 * t25)
    t36 = t35 + t35
    t37 = t7 * t14
    t38 = t37 + t37
    t39 = t21 + t21
    t40 = 4 * t11
    t41 = 4 * t30
    t42 = t29 + t29
    t43 = 6 * t37
    t44 = 6 * t31

    # results
    polynomial = np.empty((*_leading, 9), _real)
    polynomial[..., 0] = t11 + t21 + t28 + t29 + t30
    polynomial[..., 1] = t32 + t34 + t36 + t38
    polynomial[..., 2] = t39 + t40 - t41 - t42
    polynomial[..., 3] = t36 + t43 - t44 - t34
    polynomial[..., 4] = 6 * t11 + 6 * t30 - (t28 + t28)
    polynomial[..., 5] = t43 + t44 - t34 - t36
    polynomial[..., 6] = t40 + t42 - t41 - t39
    polynomial[..., 7] = t34 + t38 - t32 - t36
    polynomial[..., 8] = t30 + (t11 + t28) - t21 - t29
    return polynomial.reshape(_leading + (9,))


def determinant_terms(parameters, elbow):
    """a, b, c of det J = a cos(theta2) + b sin(theta2) + c, from cos(theta3) and sin(theta3): 36 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    in   elbow[2] = (c3, s3)
    out  terms[3]
    """
    parameters = np.asarray(parameters)
    elbow = np.asarray(elbow)
    _leading = np.broadcast_shapes(parameters.shape[:-1], elbow.shape[:-1])
    _real = np.result_type(parameters, elbow, np.float32)

    # inputs, sines and cosines
    d4 = parameters[..., 6]
    d2 = parameters[..., 4]
    ca3 = parameters[..., 2]
    s3 = elbow[..., 1]
    r3 = parameters[..., 8]
    sa3 = parameters[..., 3]
    c3 = elbow[..., 0]
    ca2 = parameters[..., 0]
    d3 = parameters[..., 5]
    r2 = parameters[..., 7]
    sa2 = parameters[..., 1]

    # terms
    t1 = d4 * ca3 * s3 - r3 * sa3
    t2 = sa3 * (c3 * ca2)
    t3 = d4 * c3
    t4 = d3 + t3
    t5 = s3 * d3
    t6 = sa3 * (c3 * r2) - t5
    t7 = t5 + sa3 * (r3 * (ca3 * c3)) + s3 * t3 * (sa3 * sa3)

    # results
    terms = np.empty((*_leading, 3), _real)
    terms[..., 0] = d4 * (d2 * t1 * t2 + t4 * t6 * sa2)
    terms[..., 1] = d4 * (t2 * (d2 * t4) - sa2 * (t1 * t6))
    terms[..., 2] = -(sa2 * (d4 * d2 * t7))
    return terms.reshape(_leading + (3,))


def determinant(parameters, shoulder, elbow):
    """det J, the determinant of the position Jacobian: 39 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    in   shoulder[2] = (c2, s2)
    in   elbow[2] = (c3, s3)
    out  determinant (one number)
    """
    parameters = np.asarray(parameters)
    shoulder = np.asarray(shoulder)
    elbow = np.asarray(elbow)
    _leading = np.broadcast_shapes(parameters.shape[:-1], shoulder.shape[:-1], elbow.shape[:-1])
    _real = np.result_type(parameters, shoulder, elbow, np.float32)

    # inputs, sines and cosines
    c2 = shoulder[..., 0]
    d4 = parameters[..., 6]
    d2 = parameters[..., 4]
    ca3 = parameters[..., 2]
    s3 = elbow[..., 1]
    r3 = parameters[..., 8]
    sa3 = parameters[..., 3]
    c3 = elbow[..., 0]
    ca2 = parameters[..., 0]
    d3 = parameters[..., 5]
    r2 = parameters[..., 7]
    sa2 = parameters[..., 1]
    s2 = shoulder[..., 1]

    # terms
    t1 = d4 * ca3 * s3 - r3 * sa3
    t2 = sa3 * (c3 * ca2)
    t3 = d4 * c3
    t4 = d3 + t3
    t5 = s3 * d3
    t6 = sa3 * (c3 * r2) - t5
    t7 = c2 * d4 * (d2 * t1 * t2 + t4 * t6 * sa2)
    t8 = d4 * s2 * (t2 * (d2 * t4) - sa2 * (t1 * t6))
    t9 = t5 + sa3 * (r3 * (ca3 * c3)) + s3 * t3 * (sa3 * sa3)

    # results
    determinant = np.empty((*_leading, 1), _real)
    determinant[..., 0] = t7 + t8 - sa2 * (d4 * d2 * t9)
    return determinant.reshape(_leading)


def second_axis(parameters):
    """coefficients of 1 and t^2 in (1 + t^2) f1, t = tan(theta3/2), which is 0 where the point is on axis 2: 2 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    out  polynomial[2]
    """
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(parameters.shape[:-1])
    _real = np.result_type(parameters, np.float32)

    # inputs, sines and cosines
    d3 = parameters[..., 5]
    d4 = parameters[..., 6]

    # terms

    # results
    polynomial = np.empty((*_leading, 2), _real)
    polynomial[..., 0] = d3 + d4
    polynomial[..., 1] = d3 - d4
    return polynomial.reshape(_leading + (2,))


def quartic_invariants(coefficients):
    """invariants I, J of a quartic, 27 times its discriminant, and what tells four real roots from none: 53 operations.

    in   coefficients[5] = (e0, e1, e2, e3, e4)
    out  invariants[2]
    out  discriminating[3]
    """
    coefficients = np.asarray(coefficients)
    _leading = np.broadcast_shapes(coefficients.shape[:-1])
    _real = np.result_type(coefficients, np.float32)

    # inputs, sines and cosines
    e2 = coefficients[..., 2]
    e0 = coefficients[..., 0]
    e4 = coefficients[..., 4]
    e1 = coefficients[..., 1]
    e3 = coefficients[..., 3]

    # terms
    t1 = e2 * e2
    t2 = t1 + 12 * e0 * e4 - 3 * e1 * e3
    t3 = e3 * (e2 * (9 * e1)) + e4 * (e2 * (72 * e0))
    t4 = e2 * t1
    t5 = e3 * e3
    t6 = t3 - (t4 + t4) - 27 * e0 * t5 - 27 * e4 * (e1 * e1)
    t7 = e4 * e4
    t8 = 64 * e0 * (e4 * t7) + t5 * (e4 * (16 * e2))
    t9 = t8 - 3 * (e3 * (e3 * t5)) - t7 * (16 * t1)

    # results
    invariants = np.empty((*_leading, 2), _real)
    discriminating = np.empty((*_leading, 3), _real)
    invariants[..., 0] = t2
    invariants[..., 1] = t6
    discriminating[..., 0] = 4 * (t2 * (t2 * t2)) - t6 * t6
    discriminating[..., 1] = e4 * (8 * e2) - 3 * t5
    discriminating[..., 2] = t9 - t7 * (e3 * (16 * e1))
    return invariants.reshape(_leading + (2,)), discriminating.reshape(_leading + (3,))


def triple_point(parameters, elbow):
    """numerators of rho^2 and of z of the cusp at a root of the cusp polynomial, and their denominator: 92 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    in   elbow[2] = (c3, s3)
    out  cusp[3]
    """
    parameters = np.asarray(parameters)
    elbow = np.asarray(elbow)
    _leading = np.broadcast_shapes(parameters.shape[:-1], elbow.shape[:-1])
    _real = np.result_type(parameters, elbow, np.float32)

    # inputs, sines and cosines
    d2 = parameters[..., 4]
    d3 = parameters[..., 5]
    d4 = parameters[..., 6]
    r2 = parameters[..., 7]
    r3 = parameters[..., 8]
    c3 = elbow[..., 0]
    s3 = elbow[..., 1]
    sa3 = parameters[..., 3]
    ca3 = parameters[..., 2]
    sa2 = parameters[..., 1]
    ca2 = parameters[..., 0]

    # terms
    t1 = d2 * d2
    t2 = t1 + d3 * d3 + d4 * d4 + r2 * r2 + r3 * r3
    t3 = d3 * c3 + r2 * s3 * sa3
    t4 = t2 + (d4 + d4) * t3 + r3 * (r2 * (ca3 + ca3))
    t5 = sa2 * sa2
    t6 = t1 * t1
    t7 = sa3 * (d3 * ca2)
    t8 = t5 * t6 * (t7 * t7)
    t9 = t1 * t5
    t10 = d3 * s3
    t11 = d4 * c3
    t12 = sa3 * sa3
    t13 = t10 + sa3 * (r3 * (c3 * ca3)) + s3 * t11 * t12
    t14 = t9 * t13
    t15 = sa3 * (r2 * c3) - t10
    t16 = t5 * (t15 * t15) + t12 * (t1 * (c3 * c3 * (ca2 * ca2)))
    t17 = r3 * ca3
    t18 = d4 * s3
    t19 = s3 * (sa3 * t17 + t12 * t18) - c3 * (d3 + t11 * t12)
    t20 = d4 * t16 - t9 * t19
    t21 = sa3 * (s3 * ca2) * t14 + sa3 * (c3 * ca2) * t20
    t22 = t15 * t20 + t7 * (t1 * (ca2 * (r2 + t17 + sa3 * t18)))
    t23 = t22 + t3 * t14
    t24 = t4 * t8 + t6 * (t7 * (-t21 - t21)) - t5 * (t23 * t23)

    # results
    cusp = np.empty((*_leading, 3), _real)
    cusp[..., 0] = t24
    cusp[..., 1] = t23 * (t5 * (t1 * t7))
    cusp[..., 2] = t8
    return cusp.reshape(_leading + (3,))


def triple_point_right_angle(parameters, elbow):
    """numerators of rho^2 and of z^2 of the cusp at a root of the cusp polynomial, and their denominator: 77 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    in   elbow[2] = (c3, s3)
    out  cusp[3]
    """
    parameters = np.asarray(parameters)
    elbow = np.asarray(elbow)
    _leading = np.broadcast_shapes(parameters.shape[:-1], elbow.shape[:-1])
    _real = np.result_type(parameters, elbow, np.float32)

    # inputs, sines and cosines
    d2 = parameters[..., 4]
    d3 = parameters[..., 5]
    d4 = parameters[..., 6]
    r2 = parameters[..., 7]
    r3 = parameters[..., 8]
    c3 = elbow[..., 0]
    s3 = elbow[..., 1]
    sa3 = parameters[..., 3]
    ca3 = parameters[..., 2]
    sa2 = parameters[..., 1]

    # terms
    t1 = d2 * d2
    t2 = d3 * d3
    t3 = r2 * r2
    t4 = d3 * c3 + r2 * s3 * sa3
    t5 = t1 + t2 + d4 * d4 + t3 + r3 * r3 + (d4 + d4) * t4
    t6 = sa2 * sa2
    t7 = sa3 * sa3
    t8 = t6 * (t2 + t3 * t7)
    t9 = t1 * (t8 * t8)
    t10 = d3 * s3
    t11 = sa3 * (r2 * c3) - t10
    t12 = t1 * t6
    t13 = d4 * c3
    t14 = t10 + sa3 * (r3 * (c3 * ca3)) + t7 * (s3 * t13)
    t15 = s3 * (sa3 * (r3 * ca3) + t7 * (d4 * s3)) - c3 * (d3 + t7 * t13)
    t16 = t11 * (t12 * t14) - t4 * (d4 * t6 * (t11 * t11) - t12 * t15)
    t17 = (t5 + r3 * (r2 * (ca3 + ca3))) * t9 + t8 * ((t1 + t1) * t16)
    t18 = d3 + t13
    t19 = s3 * (d4 * ca3) - r3 * sa3
    t20 = t6 * (t9 * (t18 * t18 + t19 * t19) - t16 * t16)

    # results
    cusp = np.empty((*_leading, 3), _real)
    cusp[..., 0] = t17 - t20
    cusp[..., 1] = t20
    cusp[..., 2] = t9
    return cusp.reshape(_leading + (3,))


def image(parameters, shoulder, elbow):
    """rho^2 and z of the point, from the cosines and sines of theta2 and theta3: 27 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    in   shoulder[2] = (c2, s2)
    in   elbow[2] = (c3, s3)
    out  target[2]
    """
    parameters = np.asarray(parameters)
    shoulder = np.asarray(shoulder)
    elbow = np.asarray(elbow)
    _leading = np.broadcast_shapes(parameters.shape[:-1], shoulder.shape[:-1], elbow.shape[:-1])
    _real = np.result_type(parameters, shoulder, elbow, np.float32)

    # inputs, sines and cosines
    c2 = shoulder[..., 0]
    d3 = parameters[..., 5]
    c3 = elbow[..., 0]
    d4 = parameters[..., 6]
    ca3 = parameters[..., 2]
    s3 = elbow[..., 1]
    r3 = parameters[..., 8]
    sa3 = parameters[..., 3]
    s2 = shoulder[..., 1]
    d2 = parameters[..., 4]
    ca2 = parameters[..., 0]
    sa2 = parameters[..., 1]
    r2 = parameters[..., 7]

    # terms
    t1 = d3 + c3 * d4
    t2 = d4 * ca3 * s3 - r3 * sa3
    t3 = c2 * t1 - t2 * s2 + d2
    t4 = c2 * t2 + t1 * s2
    t5 = ca3 * r3 + sa3 * (d4 * s3) + r2
    t6 = t4 * ca2 - sa2 * t5

    # results
    target = np.empty((*_leading, 2), _real)
    target[..., 0] = t3 * t3 + t6 * t6
    target[..., 1] = t4 * sa2 + ca2 * t5
    return target.reshape(_leading + (2,))


def conic_terms(parameters):
    """the conic E whose double contact with the unit circle is a node, by powers of R and z: 188 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    out  conic[6][5]
    """
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(parameters.shape[:-1])
    _real = np.result_type(parameters, np.float32)

    # inputs, sines and cosines
    d4 = parameters[..., 6]
    sa2 = parameters[..., 1]
    d3 = parameters[..., 5]
    d2 = parameters[..., 4]
    r2 = parameters[..., 7]
    sa3 = parameters[..., 3]
    ca2 = parameters[..., 0]
    ca3 = parameters[..., 2]
    r3 = parameters[..., 8]

    # terms
    t1 = d4 * d4
    t2 = 4 * t1
    t3 = sa2 * sa2
    t4 = d3 * d3
    t5 = d2 * d2
    t6 = ca2 * ca2
    t7 = sa3 * sa3
    t8 = r2 * r2
    t9 = ca3 * ca3
    t10 = t5 * t6 * t7 + t7 * (t3 * t8) - t3 * (t5 * t9)
    t11 = r3 * r3
    t12 = ca3 + ca3
    t13 = r3 * (r2 * t12)
    t14 = t3 * (d4 * (d3 + d3)) * (t8 + (t1 + t4) + t11 + t13 - t5)
    t15 = r2 * t8
    t16 = t3 * t15 + t3 * (t5 * r2) + t3 * (t4 * r2)
    t17 = t16 + t3 * (t1 * r2) + t3 * (r2 * t11) + t5 * (t6 * (r2 + r2))
    t18 = r3 * t12
    t19 = t17 + t5 * (t6 * t18) + t3 * (t5 * t18) + t3 * (t8 * t18)
    t20 = t3 * (d2 * (d2 * t5)) + t3 * (d3 * (d3 * t4))
    t21 = t20 + t3 * (d4 * (d4 * t1)) + t3 * (r2 * t15)
    t22 = r3 * t11
    t23 = t5 + t5
    t24 = t21 + t3 * (r3 * t22) + t3 * (t1 * t23) + t3 * (t8 * t23)
    t25 = t4 + t4
    t26 = t24 + t3 * (t11 * t23) + t3 * (t1 * t25) + t3 * (t8 * t25)
    t27 = t1 + t1
    t28 = t26 + t3 * (t11 * t25) + t3 * (t8 * t27) + t3 * (t11 * t27)
    t29 = 4 * t6
    t30 = t28 + t3 * (t11 * (t8 + t8)) + t8 * (t5 * t29)
    t31 = 4 * ca3
    t32 = r2 * t31
    t33 = t30 + t3 * (t22 * t32) + t3 * (t15 * (r3 * t31))
    t34 = t33 + t11 * (t5 * (t9 * t29)) + t3 * (t11 * (t8 * (4 * t9)))
    t35 = r3 * t32
    t36 = t34 + t3 * (t5 * t35) + t3 * (t4 * t35) + t3 * (t1 * t35)
    t37 = t36 + t5 * (t6 * (r3 * (r2 * (8 * ca3)))) - t3 * (t4 * t23)
    t38 = 4 * t5
    t39 = -2 * t3 * (t13 + (t11 + (t8 + (t1 + (t4 + t5)))))

    # results
    conic = np.empty((*_leading, 30), _real)
    conic[..., 0] = t2 * t3 * (t4 - t5)
    conic[..., 1] = 0.0
    conic[..., 2] = 0.0
    conic[..., 3] = 0.0
    conic[..., 4] = 0.0
    conic[..., 5] = t3 * (t1 * (4 * d3 * r2 * sa3))
    conic[..., 6] = 0.0
    conic[..., 7] = 0.0
    conic[..., 8] = 0.0
    conic[..., 9] = 0.0
    conic[..., 10] = t2 * t10
    conic[..., 11] = 0.0
    conic[..., 12] = 0.0
    conic[..., 13] = 0.0
    conic[..., 14] = 0.0
    conic[..., 15] = t14
    conic[..., 16] = t3 * (d4 * (-2 * d3))
    conic[..., 17] = 0.0
    conic[..., 18] = 0.0
    conic[..., 19] = 0.0
    conic[..., 20] = sa3 * (d4 + d4) * t19
    conic[..., 21] = t3 * (sa3 * (r2 * (-2 * d4)))
    conic[..., 22] = t5 * (sa3 * (d4 * (-4 * ca2)))
    conic[..., 23] = 0.0
    conic[..., 24] = 0.0
    conic[..., 25] = t37 - t7 * (t3 * (t11 * t38))
    conic[..., 26] = t39
    conic[..., 27] = t5 * (-8 * ca2) * (r2 + ca3 * r3)
    conic[..., 28] = t3
    conic[..., 29] = t38
    return conic.reshape(_leading + (6, 5))


def shoulder(parameters, target, elbow):
    """numbers in the ratio of cos(theta2) and sin(theta2) of a posture at a target, and W: 51 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    in   target[2] = (rho_squared, z)
    in   elbow[2] = (c3, s3)
    out  ratio[3]
    """
    parameters = np.asarray(parameters)
    target = np.asarray(target)
    elbow = np.asarray(elbow)
    _leading = np.broadcast_shapes(parameters.shape[:-1], target.shape[:-1], elbow.shape[:-1])
    _real = np.result_type(parameters, target, elbow, np.float32)

    # inputs, sines and cosines
    rho_squared = target[..., 0]
    z = target[..., 1]
    d2 = parameters[..., 4]
    d3 = parameters[..., 5]
    d4 = parameters[..., 6]
    r2 = parameters[..., 7]
    r3 = parameters[..., 8]
    c3 = elbow[..., 0]
    s3 = elbow[..., 1]
    sa3 = parameters[..., 3]
    ca3 = parameters[..., 2]
    sa2 = parameters[..., 1]
    ca2 = parameters[..., 0]

    # terms
    t1 = d2 * d2
    t2 = rho_squared + z * z - t1 - d3 * d3 - d4 * d4
    t3 = t2 - r2 * r2 - r3 * r3 - (d4 + d4) * (d3 * c3 + r2 * s3 * sa3)
    t4 = d2 * (t3 - r3 * (r2 * (ca3 + ca3))) * (sa2 * sa2)
    t5 = d3 + d4 * c3
    t6 = z - ca2 * (r2 + r3 * ca3 + sa3 * (d4 * s3))
    t7 = t1 * (sa2 * (t6 + t6))
    t8 = s3 * (d4 * ca3) - r3 * sa3

    # results
    ratio = np.empty((*_leading, 3), _real)
    ratio[..., 0] = t4 * t5 + t7 * t8
    ratio[..., 1] = t5 * t7 - t4 * t8
    ratio[..., 2] = t5 * t5 + t8 * t8
    return ratio.reshape(_leading + (3,))


def unturned(parameters, shoulder, elbow):
    """the point at theta1 = 0, from the cosines and sines of theta2 and theta3: 24 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    in   shoulder[2] = (c2, s2)
    in   elbow[2] = (c3, s3)
    out  point[3]
    """
    parameters = np.asarray(parameters)
    shoulder = np.asarray(shoulder)
    elbow = np.asarray(elbow)
    _leading = np.broadcast_shapes(parameters.shape[:-1], shoulder.shape[:-1], elbow.shape[:-1])
    _real = np.result_type(parameters, shoulder, elbow, np.float32)

    # inputs, sines and cosines
    c2 = shoulder[..., 0]
    d3 = parameters[..., 5]
    c3 = elbow[..., 0]
    d4 = parameters[..., 6]
    ca3 = parameters[..., 2]
    s3 = elbow[..., 1]
    r3 = parameters[..., 8]
    sa3 = parameters[..., 3]
    s2 = shoulder[..., 1]
    d2 = parameters[..., 4]
    ca2 = parameters[..., 0]
    sa2 = parameters[..., 1]
    r2 = parameters[..., 7]

    # terms
    t1 = d3 + c3 * d4
    t2 = d4 * ca3 * s3 - r3 * sa3
    t3 = c2 * t2 + t1 * s2
    t4 = ca3 * r3 + sa3 * (d4 * s3) + r2

    # results
    point = np.empty((*_leading, 3), _real)
    point[..., 0] = c2 * t1 - t2 * s2 + d2
    point[..., 1] = t3 * ca2 - sa2 * t4
    point[..., 2] = t3 * sa2 + ca2 * t4
    return point.reshape(_leading + (3,))


def number_of_postures(parameters, target):
    """how many postures reach a target; in double precision certainly so where the margin exceeds 1: 260 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    in   target[2] = (rho_squared, z)
    out  number (one number)
    out  margin (one number)
    """
    parameters = np.asarray(parameters)
    target = np.asarray(target)
    _leading = np.broadcast_shapes(parameters.shape[:-1], target.shape[:-1])
    _real = np.result_type(parameters, target, np.float32)

    # inputs, sines and cosines
    sa2 = parameters[..., 1]
    rho_squared = target[..., 0]
    z = target[..., 1]
    d2 = parameters[..., 4]
    d3 = parameters[..., 5]
    d4 = parameters[..., 6]
    r2 = parameters[..., 7]
    r3 = parameters[..., 8]
    ca3 = parameters[..., 2]
    ca2 = parameters[..., 0]
    sa3 = parameters[..., 3]

    # terms
    t1 = z * z
    t2 = d2 * d2
    t3 = d3 * d3
    t4 = d4 * d4
    t5 = r2 * r2
    t6 = r3 * r3
    t7 = rho_squared + t1 - t2 - t3 - t4 - t5 - t6 - r3 * (r2 * (ca3 + ca3))
    t8 = sa2 * t7
    t9 = (d2 + d2) * (z - r2 * ca2 - r3 * (ca3 * ca2))
    t10 = sa2 * (d4 * (-2 * d3))
    t11 = 0.5 * (t10 * t10)
    t12 = sa2 * (r2 * (-2 * d4)) * sa3
    t13 = 0.5 * (t12 * t12)
    t14 = sa3 * (d4 * (d2 * (-2 * ca2)))
    t15 = 0.5 * (t14 * t14)
    t16 = ca3 * ca3
    t17 = 4 * t2 * (sa2 * sa2)
    t18 = t8 * t8 + t9 * t9 + t11 + t13 + t15 - (t3 + t4 * t16 + t6 * (sa3 * sa3)) * t17
    t19 = t17 * (0.5 * (t4 * (1 - t16)))
    t20 = t18 - t19
    t21 = t8 * t10 - t17 * (0.5 * (d4 * (d3 + d3)))
    t22 = t11 - t13 - t15 - t19
    t23 = np.maximum(t20, -t20) + np.maximum(t21, -t21) + np.maximum(t22, -t22)
    t24 = t10 * t12
    t25 = t8 * t12 + t9 * t14 - t17 * (0.5 * (sa3 * (r3 * (d4 * (-2 * ca3)))))
    t26 = t23 + np.maximum(t24, -t24) + np.maximum(t25, -t25)
    t27 = np.where(t26 != 0.0, 1, 0.0)
    t28 = t27 / (t26 + (1 - t27))
    t29 = t20 * t28
    t30 = t29 * t29
    t31 = t22 * t28
    t32 = t24 * t28
    t33 = t31 * t31 + t32 * t32
    t34 = t21 * t28
    t35 = t34 * t34
    t36 = t25 * t28
    t37 = t36 * t36
    t38 = t35 + t37
    t39 = t30 + 3 * t33 - 3 * t38
    t40 = t39 * t39
    t41 = 27 * (t31 * (t35 - t37) + t36 * (t32 * (t34 + t34)))
    t42 = t41 + t29 * (t30 + t30 - 18 * t33 - 9 * t38)
    t43 = 4 * t39 * t40 - t42 * t42
    t44 = 0.5 + 0.5 * np.copysign(1, t43)
    t45 = np.maximum(d2, -d2)
    t46 = np.maximum(ca2, -ca2)
    t47 = t46 + t46
    t48 = t45 * t47
    t49 = np.maximum(r2, -r2)
    t50 = np.maximum(ca3, -ca3)
    t51 = np.maximum(r3, -r3)
    t52 = (t45 + t45) * np.maximum(z, -z) + t48 * t49 + t45 * (t47 * t50) * t51
    t53 = np.maximum(d4, -d4)
    t54 = np.maximum(sa3, -sa3)
    t55 = t52 + t48 * t53 * t54
    t56 = np.maximum(sa2, -sa2)
    t57 = t2 * t56 + t3 * t56 + t4 * t56 + t5 * t56
    t58 = t57 + t6 * t56 + t1 * t56 + t56 * np.maximum(rho_squared, -rho_squared)
    t59 = np.maximum(d3, -d3)
    t60 = t58 + t56 * (t53 * (t59 + t59)) + t56 * (t51 * (t49 * (t50 + t50)))
    t61 = t60 + t54 * (t56 * (t49 * (t53 + t53)))
    t62 = t50 * t53 + t51 * t54
    t63 = t53 + t59
    t64 = t55 * t55 + t61 * t61 + t17 * (t62 * t62 + t63 * t63)
    t65 = 3.552713678800501e-15 * t28 * t64
    t66 = -0.3333333333333333 * t39
    t67 = t33 + t38 - 0.5555555555555556 * t30
    t68 = 1.3333333333333333 * t29
    t69 = t66 * t66 + 3 * (t67 * t67) + t66 * (t68 * t68)
    t70 = np.minimum((t69 + t68 * (0.1111111111111111 * t42) - t67 * (-1.3333333333333333 * t39)), 3 * (3 * t67 - -0.6666666666666666 * t39))
    t71 = 0.016666666666666666 / t65 * t70
    t72 = 72 * t40 + 120 * np.maximum(t42, -t42) + 5000 * t65
    t73 = np.maximum(t43, -t43) / (t65 * t72)

    # results
    number = np.empty((*_leading, 1), _real)
    margin = np.empty((*_leading, 1), _real)
    number[..., 0] = 2 + t44 * np.copysign(2, t71)
    margin[..., 0] = np.minimum(t73, t73 * (1 - t44) + np.maximum(t71, -t71))
    return number.reshape(_leading), margin.reshape(_leading)


def postures(parameters, point):
    """two pairs of postures at a point, the room of each (real if positive), the distances left, the slopes of E: 2243 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    in   point[3] = (x, y, z)
    out  angles[4][3]
    out  room[2]
    out  closure[4]
    out  slope[4]
    out  number (one number)
    out  margin (one number)
    """
    parameters = np.asarray(parameters)
    point = np.asarray(point)
    _leading = np.broadcast_shapes(parameters.shape[:-1], point.shape[:-1])
    _real = np.result_type(parameters, point, np.float32)

    # inputs, sines and cosines
    d2 = parameters[..., 4]
    x = point[..., 0]
    y = point[..., 1]
    z = point[..., 2]
    d3 = parameters[..., 5]
    d4 = parameters[..., 6]
    r2 = parameters[..., 7]
    r3 = parameters[..., 8]
    ca3 = parameters[..., 2]
    sa2 = parameters[..., 1]
    sa3 = parameters[..., 3]
    ca2 = parameters[..., 0]

    # terms
    t1 = d2 + d2
    t2 = np.where(t1 != 0.0, 1, 0.0)
    t3 = t2 / (t1 + (1 - t2))
    t4 = x * x + y * y
    t5 = z * z
    t6 = d2 * d2
    t7 = d3 * d3
    t8 = d4 * d4
    t9 = r2 * r2
    t10 = r3 * r3
    t11 = t4 + t5 - t6 - t7 - t8 - t9 - t10 - r3 * (r2 * (ca3 + ca3))
    t12 = d4 * (-2 * d3)
    t13 = t12 * sa2
    t14 = 0.5 * (t13 * t13)
    t15 = r2 * (-2 * d4)
    t16 = sa2 * t15 * sa3
    t17 = 0.5 * (t16 * t16)
    t18 = sa3 * (d4 * (d2 * (-2 * ca2)))
    t19 = 0.5 * (t18 * t18)
    t20 = ca3 * ca3
    t21 = 4 * t6 * (sa2 * sa2)
    t22 = 0.5 * (t8 * (1 - t20)) * t21
    t23 = t14 - t17 - t19 - t22
    t24 = t11 * sa2
    t25 = z - r2 * ca2 - r3 * (ca3 * ca2)
    t26 = t1 * t25
    t27 = t19 + (t17 + (t14 + (t24 * t24 + t26 * t26))) - t21 * (t7 + t8 * t20 + t10 * (sa3 * sa3))
    t28 = t27 - t22
    t29 = t13 * t24 - t21 * (0.5 * (d4 * (d3 + d3)))
    t30 = np.maximum(t28, -t28) + np.maximum(t29, -t29) + np.maximum(t23, -t23)
    t31 = t13 * t16
    t32 = t16 * t24 + t18 * t26 - t21 * (0.5 * (sa3 * (r3 * (d4 * (-2 * ca3)))))
    t33 = t30 + np.maximum(t31, -t31) + np.maximum(t32, -t32)
    t34 = np.where(t33 != 0.0, 1, 0.0)
    t35 = t34 / (t33 + (1 - t34))
    t36 = t23 * t35
    t37 = t36 + np.copysign(1e-17, t36)
    t38 = t31 * t35
    t39 = t38 * t38
    t40 = np.sqrt((t37 * t37 + t39))
    t41 = 0.5 / t40
    t42 = t40 + t40
    t43 = t29 * t35
    t44 = 0.5 + 0.5 * np.copysign(1, t37)
    t45 = 0.7071067811865476 * np.sqrt(((t40 + np.maximum(t37, -t37)) / t40))
    t46 = 0.5 * t38 / t45 / t40
    t47 = 1 - t44
    t48 = t44 * t45 + t46 * t47
    t49 = t32 * t35
    t50 = t44 * t46 + t45 * t47
    t51 = t43 * t48 + t49 * t50
    t52 = t48 * t49 - t43 * t50
    t53 = t28 * t35
    t54 = 0.5 * np.copysign(1, t51 * t51 - t52 * t52 - t40 * t53)
    t55 = 0.5 + t54
    t56 = 1 - t55
    t57 = t51 * t55 - t52 * t56
    t58 = t52 * t55 - t51 * t56
    t59 = t58 * t58
    t60 = t40 * (t59 + t59)
    t61 = t57 * t57
    t62 = t53 * (t55 + t55 - 1)
    t63 = t59 + t61 - t42 * (t62 - t40)
    t64 = t62 - 3 * t40
    t65 = t40 * (t63 + t40 * (t40 + t64))
    t66 = np.where(t65 != 0.0, 1, 0.0)
    t67 = np.minimum(t40, t40 * t60 * (t66 / (t65 + (1 - t66))))
    t68 = t67 * (t63 + t67 * (t64 + t67)) - t60
    t69 = t64 + t64
    t70 = t63 + t67 * (t69 + 3 * t67)
    t71 = np.where(t70 != 0.0, 1, 0.0)
    t72 = t67 - t68 * (t71 / (t70 + (1 - t71)))
    t73 = 0.5 + 0.5 * np.copysign(1, t68)
    t74 = 1 - t73
    t75 = t67 * t73 + t40 * t74
    t76 = t67 * t74
    t77 = t72 - np.minimum(t75, np.maximum(t72, t76))
    t78 = t72 * (1 - np.where(t77 != 0.0, 1, 0.0)) + np.where(t77 != 0.0, 0.5 * t75 + 0.5 * t76, 0.0)
    t79 = t78 * (t63 + t78 * (t64 + t78)) - t60
    t80 = t63 + t78 * (t69 + 3 * t78)
    t81 = np.where(t80 != 0.0, 1, 0.0)
    t82 = t78 - t79 * (t81 / (t80 + (1 - t81)))
    t83 = 0.5 + 0.5 * np.copysign(1, t79)
    t84 = 1 - t83
    t85 = t78 * t83 + t75 * t84
    t86 = t76 * t83 + t78 * t84
    t87 = t82 - np.minimum(t85, np.maximum(t82, t86))
    t88 = t82 * (1 - np.where(t87 != 0.0, 1, 0.0)) + np.where(t87 != 0.0, 0.5 * t85 + 0.5 * t86, 0.0)
    t89 = t88 * (t63 + t88 * (t64 + t88)) - t60
    t90 = t63 + t88 * (t69 + 3 * t88)
    t91 = np.where(t90 != 0.0, 1, 0.0)
    t92 = t88 - t89 * (t91 / (t90 + (1 - t91)))
    t93 = 0.5 + 0.5 * np.copysign(1, t89)
    t94 = 1 - t93
    t95 = t88 * t93 + t85 * t94
    t96 = t86 * t93 + t88 * t94
    t97 = t92 - np.minimum(t95, np.maximum(t92, t96))
    t98 = t92 * (1 - np.where(t97 != 0.0, 1, 0.0)) + np.where(t97 != 0.0, 0.5 * t95 + 0.5 * t96, 0.0)
    t99 = t98 * (t63 + t98 * (t64 + t98)) - t60
    t100 = t63 + t98 * (t69 + 3 * t98)
    t101 = np.where(t100 != 0.0, 1, 0.0)
    t102 = t98 - t99 * (t101 / (t100 + (1 - t101)))
    t103 = 0.5 + 0.5 * np.copysign(1, t99)
    t104 = 1 - t103
    t105 = t98 * t103 + t95 * t104
    t106 = t96 * t103 + t98 * t104
    t107 = t102 - np.minimum(t105, np.maximum(t102, t106))
    t108 = t102 * (1 - np.where(t107 != 0.0, 1, 0.0)) + np.where(t107 != 0.0, 0.5 * t105 + 0.5 * t106, 0.0)
    t109 = t108 * (t63 + t108 * (t64 + t108)) - t60
    t110 = t63 + t108 * (t69 + 3 * t108)
    t111 = np.where(t110 != 0.0, 1, 0.0)
    t112 = t108 - t109 * (t111 / (t110 + (1 - t111)))
    t113 = 0.5 + 0.5 * np.copysign(1, t109)
    t114 = 1 - t113
    t115 = t108 * t113 + t105 * t114
    t116 = t106 * t113 + t108 * t114
    t117 = t112 - np.minimum(t115, np.maximum(t112, t116))
    t118 = t112 * (1 - np.where(t117 != 0.0, 1, 0.0)) + np.where(t117 != 0.0, 0.5 * t115 + 0.5 * t116, 0.0)
    t119 = t118 * (t63 + t118 * (t64 + t118)) - t60
    t120 = t63 + t118 * (t69 + 3 * t118)
    t121 = np.where(t120 != 0.0, 1, 0.0)
    t122 = t118 - t119 * (t121 / (t120 + (1 - t121)))
    t123 = 0.5 + 0.5 * np.copysign(1, t119)
    t124 = 1 - t123
    t125 = t118 * t123 + t115 * t124
    t126 = t116 * t123 + t118 * t124
    t127 = t122 - np.minimum(t125, np.maximum(t122, t126))
    t128 = t122 * (1 - np.where(t127 != 0.0, 1, 0.0)) + np.where(t127 != 0.0, 0.5 * t125 + 0.5 * t126, 0.0)
    t129 = t128 * (t63 + t128 * (t64 + t128)) - t60
    t130 = t63 + t128 * (t69 + 3 * t128)
    t131 = np.where(t130 != 0.0, 1, 0.0)
    t132 = t128 - t129 * (t131 / (t130 + (1 - t131)))
    t133 = 0.5 + 0.5 * np.copysign(1, t129)
    t134 = 1 - t133
    t135 = t128 * t133 + t125 * t134
    t136 = t126 * t133 + t128 * t134
    t137 = t132 - np.minimum(t135, np.maximum(t132, t136))
    t138 = t132 * (1 - np.where(t137 != 0.0, 1, 0.0)) + np.where(t137 != 0.0, 0.5 * t135 + 0.5 * t136, 0.0)
    t139 = t138 * (t63 + t138 * (t64 + t138)) - t60
    t140 = t63 + t138 * (t69 + 3 * t138)
    t141 = np.where(t140 != 0.0, 1, 0.0)
    t142 = t138 - t139 * (t141 / (t140 + (1 - t141)))
    t143 = 0.5 + 0.5 * np.copysign(1, t139)
    t144 = 1 - t143
    t145 = t138 * t143 + t135 * t144
    t146 = t136 * t143 + t138 * t144
    t147 = t142 - np.minimum(t145, np.maximum(t142, t146))
    t148 = t142 * (1 - np.where(t147 != 0.0, 1, 0.0)) + np.where(t147 != 0.0, 0.5 * t145 + 0.5 * t146, 0.0)
    t149 = t148 * (t63 + t148 * (t64 + t148)) - t60
    t150 = t63 + t148 * (t69 + 3 * t148)
    t151 = np.where(t150 != 0.0, 1, 0.0)
    t152 = t148 - t149 * (t151 / (t150 + (1 - t151)))
    t153 = 0.5 + 0.5 * np.copysign(1, t149)
    t154 = 1 - t153
    t155 = t148 * t153 + t145 * t154
    t156 = t146 * t153 + t148 * t154
    t157 = t152 - np.minimum(t155, np.maximum(t152, t156))
    t158 = t152 * (1 - np.where(t157 != 0.0, 1, 0.0)) + np.where(t157 != 0.0, 0.5 * t155 + 0.5 * t156, 0.0)
    t159 = t158 * (t63 + t158 * (t64 + t158)) - t60
    t160 = t63 + t158 * (t69 + 3 * t158)
    t161 = np.where(t160 != 0.0, 1, 0.0)
    t162 = t158 - t159 * (t161 / (t160 + (1 - t161)))
    t163 = 0.5 + 0.5 * np.copysign(1, t159)
    t164 = 1 - t163
    t165 = t158 * t163 + t155 * t164
    t166 = t156 * t163 + t158 * t164
    t167 = t162 - np.minimum(t165, np.maximum(t162, t166))
    t168 = t162 * (1 - np.where(t167 != 0.0, 1, 0.0)) + np.where(t167 != 0.0, 0.5 * t165 + 0.5 * t166, 0.0)
    t169 = t168 * (t63 + t168 * (t64 + t168)) - t60
    t170 = t63 + t168 * (t69 + 3 * t168)
    t171 = np.where(t170 != 0.0, 1, 0.0)
    t172 = t168 - t169 * (t171 / (t170 + (1 - t171)))
    t173 = 0.5 + 0.5 * np.copysign(1, t169)
    t174 = 1 - t173
    t175 = t168 * t173 + t165 * t174
    t176 = t166 * t173 + t168 * t174
    t177 = t172 - np.minimum(t175, np.maximum(t172, t176))
    t178 = t172 * (1 - np.where(t177 != 0.0, 1, 0.0)) + np.where(t177 != 0.0, 0.5 * t175 + 0.5 * t176, 0.0)
    t179 = t178 * (t63 + t178 * (t64 + t178)) - t60
    t180 = t63 + t178 * (t69 + 3 * t178)
    t181 = np.where(t180 != 0.0, 1, 0.0)
    t182 = t178 - t179 * (t181 / (t180 + (1 - t181)))
    t183 = 0.5 + 0.5 * np.copysign(1, t179)
    t184 = 1 - t183
    t185 = t178 * t183 + t175 * t184
    t186 = t176 * t183 + t178 * t184
    t187 = t182 - np.minimum(t185, np.maximum(t182, t186))
    t188 = t182 * (1 - np.where(t187 != 0.0, 1, 0.0)) + np.where(t187 != 0.0, 0.5 * t185 + 0.5 * t186, 0.0)
    t189 = t42 - t188
    t190 = np.sqrt(t189)
    t191 = t57 / t190
    t192 = 0.5 + 0.5 * np.copysign(1, t188 - 1e-25)
    t193 = np.copysign(np.sqrt(np.maximum(0.0, t40 + t61 / t189 - t62 - t188)), t58)
    t194 = np.sqrt(t188)
    t195 = np.where(t194 != 0.0, 1, 0.0)
    t196 = (1 - t192) * t193 + t58 * t192 * (t195 / (t194 + (1 - t195)))
    t197 = t191 + t196
    t198 = t42 - t197 * t197
    t199 = np.sqrt(np.maximum(0.0, t198))
    t200 = t194 * t199
    t201 = t190 * t197
    t202 = t41 * (t200 - t201)
    t203 = t194 * t197
    t204 = t190 * t199
    t205 = t41 * (t203 + t204)
    t206 = t55 * t202 + t56 * t205
    t207 = t56 * t202 + t55 * t205
    t208 = t48 * t206 - t50 * t207
    t209 = t50 * t206 + t48 * t207
    t210 = t208 + t209
    t211 = t208 - t209
    t212 = t208 + t208
    t213 = t49 * t208 + t38 * t210 * t211 - t43 * t209 - t209 * (t36 * t212)
    t214 = t213 * t213
    t215 = t43 + t43
    t216 = t49 + t49
    t217 = t53 + t208 * t215 + t209 * t216 + t211 * (t36 * t210)
    t218 = t213 / (2e-18 + (t214 + t214)) * (t217 + t209 * (t38 * t212))
    t219 = np.maximum((-0.001), np.minimum(0.001, -t218))
    t220 = t208 - t209 * t219
    t221 = t209 + t208 * t219
    t222 = np.sqrt((t220 * t220 + t221 * t221))
    t223 = np.where(t222 != 0.0, 1, 0.0)
    t224 = t223 / (t222 + (1 - t223))
    t225 = t220 * t224
    t226 = t221 * t224
    t227 = t225 + t226
    t228 = t225 - t226
    t229 = t225 + t225
    t230 = t49 * t225 + t38 * t227 * t228 - t43 * t226 - t226 * (t36 * t229)
    t231 = t230 * t230
    t232 = t53 + t215 * t225 + t216 * t226 + t228 * (t36 * t227)
    t233 = t230 / (2e-18 + (t231 + t231)) * (t232 + t226 * (t38 * t229))
    t234 = np.maximum((-0.001), np.minimum(0.001, -t233))
    t235 = t225 - t226 * t234
    t236 = t226 + t225 * t234
    t237 = np.sqrt((t235 * t235 + t236 * t236))
    t238 = np.where(t237 != 0.0, 1, 0.0)
    t239 = t238 / (t237 + (1 - t238))
    t240 = t235 * t239
    t241 = t15 * sa3
    t242 = t236 * t239
    t243 = t3 * (t11 + t12 * t240 + t241 * t242)
    t244 = d3 + d4 * t240
    t245 = np.where(sa2 != 0.0, 1, 0.0)
    t246 = t245 / (sa2 + (1 - t245))
    t247 = sa3 * (d4 * ca2)
    t248 = t246 * (t25 - t242 * t247)
    t249 = d4 * ca3
    t250 = r3 * sa3
    t251 = t242 * t249 - t250
    t252 = t243 * t244 + t248 * t251
    t253 = t244 * t248 - t243 * t251
    t254 = np.sqrt((t252 * t252 + t253 * t253))
    t255 = np.where(t254 != 0.0, 1, 0.0)
    t256 = t255 / (t254 + (1 - t255))
    t257 = t252 * t256
    t258 = t253 * t256
    t259 = d2 + (t244 * t257 - t251 * t258)
    t260 = t251 * t257 + t244 * t258
    t261 = r3 * ca3
    t262 = r2 + (t261 + sa3 * (d4 * t242))
    t263 = ca2 * t260 - sa2 * t262
    t264 = x * t259 + y * t263
    t265 = y * t259 - x * t263
    t266 = -t264
    t267 = np.maximum(t264, t266)
    t268 = np.maximum(t265, -t265)
    t269 = np.sqrt((t264 * t264 + t265 * t265)) + np.maximum(t267, t268)
    t270 = np.where(t269 != 0.0, 1, 0.0)
    t271 = t270 / (t269 + (1 - t270)) * np.minimum(t267, t268)
    t272 = t271 / (1 + np.sqrt((1 + t271 * t271)))
    t273 = t272 * t272
    t274 = t273 * (t273 * (0.058823529411764705 + t273 * (0.047619047619047616 * t273 - 0.05263157894736842)) - 0.06666666666666667)
    t275 = t273 * (0.1111111111111111 + t273 * (t273 * (0.07692307692307693 + t274) - 0.09090909090909091)) - 0.14285714285714285
    t276 = 4 * t272 * (1 + t273 * (t273 * (0.2 + t273 * t275) - 0.3333333333333333))
    t277 = 0.5 * np.copysign(1, t268 - t267)
    t278 = t276 * (0.5 - t277) + (0.5 + t277) * (1.5707963267948966 - t276)
    t279 = 0.5 * np.copysign(1, t266)
    t280 = np.copysign((t278 * (0.5 - t279) + (0.5 + t279) * (3.141592653589793 - t278)), t265)
    t281 = -t257
    t282 = np.maximum(t257, t281)
    t283 = np.maximum(t258, -t258)
    t284 = 1 + np.maximum(t282, t283)
    t285 = np.where(t284 != 0.0, 1, 0.0)
    t286 = t285 / (t284 + (1 - t285)) * np.minimum(t282, t283)
    t287 = t286 / (1 + np.sqrt((1 + t286 * t286)))
    t288 = t287 * t287
    t289 = t288 * (t288 * (0.058823529411764705 + t288 * (0.047619047619047616 * t288 - 0.05263157894736842)) - 0.06666666666666667)
    t290 = t288 * (0.1111111111111111 + t288 * (t288 * (0.07692307692307693 + t289) - 0.09090909090909091)) - 0.14285714285714285
    t291 = 4 * t287 * (1 + t288 * (t288 * (0.2 + t288 * t290) - 0.3333333333333333))
    t292 = 0.5 * np.copysign(1, t283 - t282)
    t293 = t291 * (0.5 - t292) + (0.5 + t292) * (1.5707963267948966 - t291)
    t294 = 0.5 * np.copysign(1, t281)
    t295 = np.copysign((t293 * (0.5 - t294) + (0.5 + t294) * (3.141592653589793 - t293)), t258)
    t296 = -t240
    t297 = np.maximum(t240, t296)
    t298 = np.maximum(t242, -t242)
    t299 = 1 + np.maximum(t297, t298)
    t300 = np.where(t299 != 0.0, 1, 0.0)
    t301 = t300 / (t299 + (1 - t300)) * np.minimum(t297, t298)
    t302 = t301 / (1 + np.sqrt((1 + t301 * t301)))
    t303 = t302 * t302
    t304 = t303 * (t303 * (0.058823529411764705 + t303 * (0.047619047619047616 * t303 - 0.05263157894736842)) - 0.06666666666666667)
    t305 = t303 * (0.1111111111111111 + t303 * (t303 * (0.07692307692307693 + t304) - 0.09090909090909091)) - 0.14285714285714285
    t306 = 4 * t302 * (1 + t303 * (t303 * (0.2 + t303 * t305) - 0.3333333333333333))
    t307 = 0.5 * np.copysign(1, t298 - t297)
    t308 = t306 * (0.5 - t307) + (0.5 + t307) * (1.5707963267948966 - t306)
    t309 = 0.5 * np.copysign(1, t296)
    t310 = np.copysign((t308 * (0.5 - t309) + (0.5 + t309) * (3.141592653589793 - t308)), t242)
    t311 = t41 * (t203 - t204)
    t312 = t41 * (t200 + t201)
    t313 = t56 * t311 - t55 * t312
    t314 = t55 * t311 - t56 * t312
    t315 = t48 * t313 - t50 * t314
    t316 = t50 * t313 + t48 * t314
    t317 = t315 + t316
    t318 = t315 - t316
    t319 = t315 + t315
    t320 = t49 * t315 + t38 * t317 * t318 - t43 * t316 - t316 * (t36 * t319)
    t321 = t320 * t320
    t322 = t53 + t215 * t315 + t216 * t316 + t318 * (t36 * t317)
    t323 = t320 / (2e-18 + (t321 + t321)) * (t322 + t316 * (t38 * t319))
    t324 = np.maximum((-0.001), np.minimum(0.001, -t323))
    t325 = t315 - t316 * t324
    t326 = t316 + t315 * t324
    t327 = np.sqrt((t325 * t325 + t326 * t326))
    t328 = np.where(t327 != 0.0, 1, 0.0)
    t329 = t328 / (t327 + (1 - t328))
    t330 = t325 * t329
    t331 = t326 * t329
    t332 = t330 + t331
    t333 = t330 - t331
    t334 = t330 + t330
    t335 = t49 * t330 + t38 * t332 * t333 - t43 * t331 - t331 * (t36 * t334)
    t336 = t335 * t335
    t337 = t53 + t215 * t330 + t216 * t331 + t333 * (t36 * t332)
    t338 = t335 / (2e-18 + (t336 + t336)) * (t337 + t331 * (t38 * t334))
    t339 = np.maximum((-0.001), np.minimum(0.001, -t338))
    t340 = t330 - t331 * t339
    t341 = t331 + t330 * t339
    t342 = np.sqrt((t340 * t340 + t341 * t341))
    t343 = np.where(t342 != 0.0, 1, 0.0)
    t344 = t343 / (t342 + (1 - t343))
    t345 = t340 * t344
    t346 = t341 * t344
    t347 = t3 * (t11 + t12 * t345 + t241 * t346)
    t348 = d3 + d4 * t345
    t349 = t246 * (t25 - t247 * t346)
    t350 = t249 * t346 - t250
    t351 = t347 * t348 + t349 * t350
    t352 = t348 * t349 - t347 * t350
    t353 = np.sqrt((t351 * t351 + t352 * t352))
    t354 = np.where(t353 != 0.0, 1, 0.0)
    t355 = t354 / (t353 + (1 - t354))
    t356 = t351 * t355
    t357 = t352 * t355
    t358 = d2 + (t348 * t356 - t350 * t357)
    t359 = t350 * t356 + t348 * t357
    t360 = r2 + (t261 + sa3 * (d4 * t346))
    t361 = ca2 * t359 - sa2 * t360
    t362 = x * t358 + y * t361
    t363 = y * t358 - x * t361
    t364 = -t362
    t365 = np.maximum(t362, t364)
    t366 = np.maximum(t363, -t363)
    t367 = np.sqrt((t362 * t362 + t363 * t363)) + np.maximum(t365, t366)
    t368 = np.where(t367 != 0.0, 1, 0.0)
    t369 = t368 / (t367 + (1 - t368)) * np.minimum(t365, t366)
    t370 = t369 / (1 + np.sqrt((1 + t369 * t369)))
    t371 = t370 * t370
    t372 = t371 * (t371 * (0.058823529411764705 + t371 * (0.047619047619047616 * t371 - 0.05263157894736842)) - 0.06666666666666667)
    t373 = t371 * (0.1111111111111111 + t371 * (t371 * (0.07692307692307693 + t372) - 0.09090909090909091)) - 0.14285714285714285
    t374 = 4 * t370 * (1 + t371 * (t371 * (0.2 + t371 * t373) - 0.3333333333333333))
    t375 = 0.5 * np.copysign(1, t366 - t365)
    t376 = t374 * (0.5 - t375) + (0.5 + t375) * (1.5707963267948966 - t374)
    t377 = 0.5 * np.copysign(1, t364)
    t378 = np.copysign((t376 * (0.5 - t377) + (0.5 + t377) * (3.141592653589793 - t376)), t363)
    t379 = -t356
    t380 = np.maximum(t356, t379)
    t381 = np.maximum(t357, -t357)
    t382 = 1 + np.maximum(t380, t381)
    t383 = np.where(t382 != 0.0, 1, 0.0)
    t384 = t383 / (t382 + (1 - t383)) * np.minimum(t380, t381)
    t385 = t384 / (1 + np.sqrt((1 + t384 * t384)))
    t386 = t385 * t385
    t387 = t386 * (t386 * (0.058823529411764705 + t386 * (0.047619047619047616 * t386 - 0.05263157894736842)) - 0.06666666666666667)
    t388 = t386 * (0.1111111111111111 + t386 * (t386 * (0.07692307692307693 + t387) - 0.09090909090909091)) - 0.14285714285714285
    t389 = 4 * t385 * (1 + t386 * (t386 * (0.2 + t386 * t388) - 0.3333333333333333))
    t390 = 0.5 * np.copysign(1, t381 - t380)
    t391 = t389 * (0.5 - t390) + (0.5 + t390) * (1.5707963267948966 - t389)
    t392 = 0.5 * np.copysign(1, t379)
    t393 = np.copysign((t391 * (0.5 - t392) + (0.5 + t392) * (3.141592653589793 - t391)), t357)
    t394 = -t345
    t395 = np.maximum(t345, t394)
    t396 = np.maximum(t346, -t346)
    t397 = 1 + np.maximum(t395, t396)
    t398 = np.where(t397 != 0.0, 1, 0.0)
    t399 = t398 / (t397 + (1 - t398)) * np.minimum(t395, t396)
    t400 = t399 / (1 + np.sqrt((1 + t399 * t399)))
    t401 = t400 * t400
    t402 = t401 * (t401 * (0.058823529411764705 + t401 * (0.047619047619047616 * t401 - 0.05263157894736842)) - 0.06666666666666667)
    t403 = t401 * (0.1111111111111111 + t401 * (t401 * (0.07692307692307693 + t402) - 0.09090909090909091)) - 0.14285714285714285
    t404 = 4 * t400 * (1 + t401 * (t401 * (0.2 + t401 * t403) - 0.3333333333333333))
    t405 = 0.5 * np.copysign(1, t396 - t395)
    t406 = t404 * (0.5 - t405) + (0.5 + t405) * (1.5707963267948966 - t404)
    t407 = 0.5 * np.copysign(1, t394)
    t408 = np.copysign((t406 * (0.5 - t407) + (0.5 + t407) * (3.141592653589793 - t406)), t346)
    t409 = t191 - t196
    t410 = t42 - t409 * t409
    t411 = np.sqrt(np.maximum(0.0, t410))
    t412 = t190 * t411
    t413 = t194 * t409
    t414 = t41 * (t412 - t413)
    t415 = t190 * t409
    t416 = t194 * t411
    t417 = t41 * (t415 + t416)
    t418 = t56 * t414 - t55 * t417
    t419 = t55 * t414 - t56 * t417
    t420 = t48 * t418 - t50 * t419
    t421 = t50 * t418 + t48 * t419
    t422 = t420 + t421
    t423 = t420 - t421
    t424 = t420 + t420
    t425 = t49 * t420 + t38 * t422 * t423 - t43 * t421 - t421 * (t36 * t424)
    t426 = t425 * t425
    t427 = t53 + t215 * t420 + t216 * t421 + t423 * (t36 * t422)
    t428 = t425 / (2e-18 + (t426 + t426)) * (t427 + t421 * (t38 * t424))
    t429 = np.maximum((-0.001), np.minimum(0.001, -t428))
    t430 = t420 - t421 * t429
    t431 = t421 + t420 * t429
    t432 = np.sqrt((t430 * t430 + t431 * t431))
    t433 = np.where(t432 != 0.0, 1, 0.0)
    t434 = t433 / (t432 + (1 - t433))
    t435 = t430 * t434
    t436 = t431 * t434
    t437 = t435 + t436
    t438 = t435 - t436
    t439 = t435 + t435
    t440 = t49 * t435 + t38 * t437 * t438 - t43 * t436 - t436 * (t36 * t439)
    t441 = t440 * t440
    t442 = t53 + t215 * t435 + t216 * t436 + t438 * (t36 * t437)
    t443 = t440 / (2e-18 + (t441 + t441)) * (t442 + t436 * (t38 * t439))
    t444 = np.maximum((-0.001), np.minimum(0.001, -t443))
    t445 = t435 - t436 * t444
    t446 = t436 + t435 * t444
    t447 = np.sqrt((t445 * t445 + t446 * t446))
    t448 = np.where(t447 != 0.0, 1, 0.0)
    t449 = t448 / (t447 + (1 - t448))
    t450 = t445 * t449
    t451 = t446 * t449
    t452 = t3 * (t11 + t12 * t450 + t241 * t451)
    t453 = d3 + d4 * t450
    t454 = t246 * (t25 - t247 * t451)
    t455 = t249 * t451 - t250
    t456 = t452 * t453 + t454 * t455
    t457 = t453 * t454 - t452 * t455
    t458 = np.sqrt((t456 * t456 + t457 * t457))
    t459 = np.where(t458 != 0.0, 1, 0.0)
    t460 = t459 / (t458 + (1 - t459))
    t461 = t456 * t460
    t462 = t457 * t460
    t463 = d2 + (t453 * t461 - t455 * t462)
    t464 = t455 * t461 + t453 * t462
    t465 = r2 + (t261 + sa3 * (d4 * t451))
    t466 = ca2 * t464 - sa2 * t465
    t467 = x * t463 + y * t466
    t468 = y * t463 - x * t466
    t469 = -t467
    t470 = np.maximum(t467, t469)
    t471 = np.maximum(t468, -t468)
    t472 = np.sqrt((t467 * t467 + t468 * t468)) + np.maximum(t470, t471)
    t473 = np.where(t472 != 0.0, 1, 0.0)
    t474 = t473 / (t472 + (1 - t473)) * np.minimum(t470, t471)
    t475 = t474 / (1 + np.sqrt((1 + t474 * t474)))
    t476 = t475 * t475
    t477 = t476 * (t476 * (0.058823529411764705 + t476 * (0.047619047619047616 * t476 - 0.05263157894736842)) - 0.06666666666666667)
    t478 = t476 * (0.1111111111111111 + t476 * (t476 * (0.07692307692307693 + t477) - 0.09090909090909091)) - 0.14285714285714285
    t479 = 4 * t475 * (1 + t476 * (t476 * (0.2 + t476 * t478) - 0.3333333333333333))
    t480 = 0.5 * np.copysign(1, t471 - t470)
    t481 = t479 * (0.5 - t480) + (0.5 + t480) * (1.5707963267948966 - t479)
    t482 = 0.5 * np.copysign(1, t469)
    t483 = np.copysign((t481 * (0.5 - t482) + (0.5 + t482) * (3.141592653589793 - t481)), t468)
    t484 = -t461
    t485 = np.maximum(t461, t484)
    t486 = np.maximum(t462, -t462)
    t487 = 1 + np.maximum(t485, t486)
    t488 = np.where(t487 != 0.0, 1, 0.0)
    t489 = t488 / (t487 + (1 - t488)) * np.minimum(t485, t486)
    t490 = t489 / (1 + np.sqrt((1 + t489 * t489)))
    t491 = t490 * t490
    t492 = t491 * (t491 * (0.058823529411764705 + t491 * (0.047619047619047616 * t491 - 0.05263157894736842)) - 0.06666666666666667)
    t493 = t491 * (0.1111111111111111 + t491 * (t491 * (0.07692307692307693 + t492) - 0.09090909090909091)) - 0.14285714285714285
    t494 = 4 * t490 * (1 + t491 * (t491 * (0.2 + t491 * t493) - 0.3333333333333333))
    t495 = 0.5 * np.copysign(1, t486 - t485)
    t496 = t494 * (0.5 - t495) + (0.5 + t495) * (1.5707963267948966 - t494)
    t497 = 0.5 * np.copysign(1, t484)
    t498 = np.copysign((t496 * (0.5 - t497) + (0.5 + t497) * (3.141592653589793 - t496)), t462)
    t499 = -t450
    t500 = np.maximum(t450, t499)
    t501 = np.maximum(t451, -t451)
    t502 = 1 + np.maximum(t500, t501)
    t503 = np.where(t502 != 0.0, 1, 0.0)
    t504 = t503 / (t502 + (1 - t503)) * np.minimum(t500, t501)
    t505 = t504 / (1 + np.sqrt((1 + t504 * t504)))
    t506 = t505 * t505
    t507 = t506 * (t506 * (0.058823529411764705 + t506 * (0.047619047619047616 * t506 - 0.05263157894736842)) - 0.06666666666666667)
    t508 = t506 * (0.1111111111111111 + t506 * (t506 * (0.07692307692307693 + t507) - 0.09090909090909091)) - 0.14285714285714285
    t509 = 4 * t505 * (1 + t506 * (t506 * (0.2 + t506 * t508) - 0.3333333333333333))
    t510 = 0.5 * np.copysign(1, t501 - t500)
    t511 = t509 * (0.5 - t510) + (0.5 + t510) * (1.5707963267948966 - t509)
    t512 = 0.5 * np.copysign(1, t499)
    t513 = np.copysign((t511 * (0.5 - t512) + (0.5 + t512) * (3.141592653589793 - t511)), t451)
    t514 = t41 * (t416 - t415)
    t515 = t41 * (t412 + t413)
    t516 = t55 * t514 - t56 * t515
    t517 = t56 * t514 - t55 * t515
    t518 = t48 * t516 - t50 * t517
    t519 = t50 * t516 + t48 * t517
    t520 = t518 + t519
    t521 = t518 - t519
    t522 = t518 + t518
    t523 = t49 * t518 + t38 * t520 * t521 - t43 * t519 - t519 * (t36 * t522)
    t524 = t523 * t523
    t525 = t53 + t215 * t518 + t216 * t519 + t521 * (t36 * t520)
    t526 = t523 / (2e-18 + (t524 + t524)) * (t525 + t519 * (t38 * t522))
    t527 = np.maximum((-0.001), np.minimum(0.001, -t526))
    t528 = t518 - t519 * t527
    t529 = t519 + t518 * t527
    t530 = np.sqrt((t528 * t528 + t529 * t529))
    t531 = np.where(t530 != 0.0, 1, 0.0)
    t532 = t531 / (t530 + (1 - t531))
    t533 = t528 * t532
    t534 = t529 * t532
    t535 = t533 + t534
    t536 = t533 - t534
    t537 = t533 + t533
    t538 = t49 * t533 + t38 * t535 * t536 - t43 * t534 - t534 * (t36 * t537)
    t539 = t538 * t538
    t540 = t53 + t215 * t533 + t216 * t534 + t536 * (t36 * t535)
    t541 = t538 / (2e-18 + (t539 + t539)) * (t540 + t534 * (t38 * t537))
    t542 = np.maximum((-0.001), np.minimum(0.001, -t541))
    t543 = t533 - t534 * t542
    t544 = t534 + t533 * t542
    t545 = np.sqrt((t543 * t543 + t544 * t544))
    t546 = np.where(t545 != 0.0, 1, 0.0)
    t547 = t546 / (t545 + (1 - t546))
    t548 = t543 * t547
    t549 = t544 * t547
    t550 = t3 * (t11 + t12 * t548 + t241 * t549)
    t551 = d3 + d4 * t548
    t552 = t246 * (t25 - t247 * t549)
    t553 = t249 * t549 - t250
    t554 = t550 * t551 + t552 * t553
    t555 = t551 * t552 - t550 * t553
    t556 = np.sqrt((t554 * t554 + t555 * t555))
    t557 = np.where(t556 != 0.0, 1, 0.0)
    t558 = t557 / (t556 + (1 - t557))
    t559 = t554 * t558
    t560 = t555 * t558
    t561 = d2 + (t551 * t559 - t553 * t560)
    t562 = t553 * t559 + t551 * t560
    t563 = r2 + (t261 + sa3 * (d4 * t549))
    t564 = ca2 * t562 - sa2 * t563
    t565 = x * t561 + y * t564
    t566 = y * t561 - x * t564
    t567 = -t565
    t568 = np.maximum(t565, t567)
    t569 = np.maximum(t566, -t566)
    t570 = np.sqrt((t565 * t565 + t566 * t566)) + np.maximum(t568, t569)
    t571 = np.where(t570 != 0.0, 1, 0.0)
    t572 = t571 / (t570 + (1 - t571)) * np.minimum(t568, t569)
    t573 = t572 / (1 + np.sqrt((1 + t572 * t572)))
    t574 = t573 * t573
    t575 = t574 * (t574 * (0.058823529411764705 + t574 * (0.047619047619047616 * t574 - 0.05263157894736842)) - 0.06666666666666667)
    t576 = t574 * (0.1111111111111111 + t574 * (t574 * (0.07692307692307693 + t575) - 0.09090909090909091)) - 0.14285714285714285
    t577 = 4 * t573 * (1 + t574 * (t574 * (0.2 + t574 * t576) - 0.3333333333333333))
    t578 = 0.5 * np.copysign(1, t569 - t568)
    t579 = t577 * (0.5 - t578) + (0.5 + t578) * (1.5707963267948966 - t577)
    t580 = 0.5 * np.copysign(1, t567)
    t581 = np.copysign((t579 * (0.5 - t580) + (0.5 + t580) * (3.141592653589793 - t579)), t566)
    t582 = -t559
    t583 = np.maximum(t559, t582)
    t584 = np.maximum(t560, -t560)
    t585 = 1 + np.maximum(t583, t584)
    t586 = np.where(t585 != 0.0, 1, 0.0)
    t587 = t586 / (t585 + (1 - t586)) * np.minimum(t583, t584)
    t588 = t587 / (1 + np.sqrt((1 + t587 * t587)))
    t589 = t588 * t588
    t590 = t589 * (t589 * (0.058823529411764705 + t589 * (0.047619047619047616 * t589 - 0.05263157894736842)) - 0.06666666666666667)
    t591 = t589 * (0.1111111111111111 + t589 * (t589 * (0.07692307692307693 + t590) - 0.09090909090909091)) - 0.14285714285714285
    t592 = 4 * t588 * (1 + t589 * (t589 * (0.2 + t589 * t591) - 0.3333333333333333))
    t593 = 0.5 * np.copysign(1, t584 - t583)
    t594 = t592 * (0.5 - t593) + (0.5 + t593) * (1.5707963267948966 - t592)
    t595 = 0.5 * np.copysign(1, t582)
    t596 = np.copysign((t594 * (0.5 - t595) + (0.5 + t595) * (3.141592653589793 - t594)), t560)
    t597 = -t548
    t598 = np.maximum(t548, t597)
    t599 = np.maximum(t549, -t549)
    t600 = 1 + np.maximum(t598, t599)
    t601 = np.where(t600 != 0.0, 1, 0.0)
    t602 = t601 / (t600 + (1 - t601)) * np.minimum(t598, t599)
    t603 = t602 / (1 + np.sqrt((1 + t602 * t602)))
    t604 = t603 * t603
    t605 = t604 * (t604 * (0.058823529411764705 + t604 * (0.047619047619047616 * t604 - 0.05263157894736842)) - 0.06666666666666667)
    t606 = t604 * (0.1111111111111111 + t604 * (t604 * (0.07692307692307693 + t605) - 0.09090909090909091)) - 0.14285714285714285
    t607 = 4 * t603 * (1 + t604 * (t604 * (0.2 + t604 * t606) - 0.3333333333333333))
    t608 = 0.5 * np.copysign(1, t599 - t598)
    t609 = t607 * (0.5 - t608) + (0.5 + t608) * (1.5707963267948966 - t607)
    t610 = 0.5 * np.copysign(1, t597)
    t611 = np.copysign((t609 * (0.5 - t610) + (0.5 + t610) * (3.141592653589793 - t609)), t549)
    t612 = np.sqrt(t4)
    t613 = np.sqrt((t259 * t259 + t263 * t263)) - t612
    t614 = sa2 * t260 + ca2 * t262 - z
    t615 = np.sqrt((t358 * t358 + t361 * t361)) - t612
    t616 = sa2 * t359 + ca2 * t360 - z
    t617 = np.sqrt((t463 * t463 + t466 * t466)) - t612
    t618 = sa2 * t464 + ca2 * t465 - z
    t619 = np.sqrt((t561 * t561 + t564 * t564)) - t612
    t620 = sa2 * t562 + ca2 * t563 - z
    t621 = t49 * t240 + t38 * (t240 + t242) * (t240 - t242) - t43 * t242
    t622 = t49 * t345 + t38 * (t345 + t346) * (t345 - t346) - t43 * t346
    t623 = t49 * t450 + t38 * (t450 + t451) * (t450 - t451) - t43 * t451
    t624 = t49 * t548 + t38 * (t548 + t549) * (t548 - t549) - t43 * t549
    t625 = t53 * t53
    t626 = t39 + t36 * t36
    t627 = t43 * t43
    t628 = t49 * t49
    t629 = t627 + t628
    t630 = t625 + 3 * t626 - 3 * t629
    t631 = t630 * t630
    t632 = 27 * (t36 * (t627 - t628) + t49 * (t38 * t215)) + t53 * (t625 + t625 - 18 * t626 - 9 * t629)
    t633 = 4 * t630 * t631 - t632 * t632
    t634 = 0.5 + 0.5 * np.copysign(1, t633)
    t635 = np.maximum(d2, -d2)
    t636 = np.maximum(ca2, -ca2)
    t637 = t636 + t636
    t638 = t635 * t637
    t639 = np.maximum(r2, -r2)
    t640 = np.maximum(ca3, -ca3)
    t641 = np.maximum(r3, -r3)
    t642 = (t635 + t635) * np.maximum(z, -z) + t638 * t639 + t635 * (t637 * t640) * t641
    t643 = np.maximum(d4, -d4)
    t644 = np.maximum(sa3, -sa3)
    t645 = t642 + t638 * t643 * t644
    t646 = np.maximum(sa2, -sa2)
    t647 = t6 * t646 + t7 * t646 + t8 * t646 + t9 * t646
    t648 = t647 + t10 * t646 + t5 * t646 + t646 * np.maximum(t4, -t4)
    t649 = np.maximum(d3, -d3)
    t650 = t648 + t646 * (t643 * (t649 + t649)) + t646 * (t641 * (t639 * (t640 + t640)))
    t651 = t650 + t644 * (t646 * (t639 * (t643 + t643)))
    t652 = t640 * t643 + t641 * t644
    t653 = t643 + t649
    t654 = t645 * t645 + t651 * t651 + t21 * (t652 * t652 + t653 * t653)
    t655 = 3.552713678800501e-15 * t35 * t654
    t656 = -0.3333333333333333 * t630
    t657 = t626 + t629 - 0.5555555555555556 * t625
    t658 = 1.3333333333333333 * t53
    t659 = t656 * t656 + 3 * (t657 * t657) + t656 * (t658 * t658)
    t660 = np.minimum((t659 + t658 * (0.1111111111111111 * t632) - t657 * (-1.3333333333333333 * t630)), 3 * (3 * t657 - -0.6666666666666666 * t630))
    t661 = 0.016666666666666666 / t655 * t660
    t662 = 72 * t631 + 120 * np.maximum(t632, -t632) + 5000 * t655
    t663 = np.maximum(t633, -t633) / (t655 * t662)

    # results
    angles = np.empty((*_leading, 12), _real)
    room = np.empty((*_leading, 2), _real)
    closure = np.empty((*_leading, 4), _real)
    slope = np.empty((*_leading, 4), _real)
    number = np.empty((*_leading, 1), _real)
    margin = np.empty((*_leading, 1), _real)
    angles[..., 0] = t280
    angles[..., 1] = t295
    angles[..., 2] = t310
    angles[..., 3] = t378
    angles[..., 4] = t393
    angles[..., 5] = t408
    angles[..., 6] = t483
    angles[..., 7] = t498
    angles[..., 8] = t513
    angles[..., 9] = t581
    angles[..., 10] = t596
    angles[..., 11] = t611
    room[..., 0] = t198
    room[..., 1] = t410
    closure[..., 0] = np.sqrt((t613 * t613 + t614 * t614))
    closure[..., 1] = np.sqrt((t615 * t615 + t616 * t616))
    closure[..., 2] = np.sqrt((t617 * t617 + t618 * t618))
    closure[..., 3] = np.sqrt((t619 * t619 + t620 * t620))
    slope[..., 0] = t621 - t242 * (t36 * (t240 + t240))
    slope[..., 1] = t622 - t346 * (t36 * (t345 + t345))
    slope[..., 2] = t623 - t451 * (t36 * (t450 + t450))
    slope[..., 3] = t624 - t549 * (t36 * (t548 + t548))
    number[..., 0] = 2 + t634 * np.copysign(2, t661)
    margin[..., 0] = np.minimum(t663, t663 * (1 - t634) + np.maximum(t661, -t661))
    return angles.reshape(_leading + (4, 3)), room.reshape(_leading + (2,)), closure.reshape(_leading + (4,)), slope.reshape(_leading + (4,)), number.reshape(_leading), margin.reshape(_leading)


def postures_intersecting(parameters, point):
    """the postures of an arm with axes 1 and 2 intersecting, the distance each leaves, and W: 884 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    in   point[3] = (x, y, z)
    out  angles[4][3]
    out  closure[4]
    out  width[4]
    """
    parameters = np.asarray(parameters)
    point = np.asarray(point)
    _leading = np.broadcast_shapes(parameters.shape[:-1], point.shape[:-1])
    _real = np.result_type(parameters, point, np.float32)

    # inputs, sines and cosines
    d3 = parameters[..., 5]
    d4 = parameters[..., 6]
    r2 = parameters[..., 7]
    sa3 = parameters[..., 3]
    x = point[..., 0]
    y = point[..., 1]
    z = point[..., 2]
    d2 = parameters[..., 4]
    r3 = parameters[..., 8]
    ca3 = parameters[..., 2]
    sa2 = parameters[..., 1]
    ca2 = parameters[..., 0]

    # terms
    t1 = -2 * d3 * d4
    t2 = -2 * d4 * r2 * sa3
    t3 = t1 * t1 + t2 * t2
    t4 = np.where(t3 != 0.0, 1, 0.0)
    t5 = 1 - t4
    t6 = t4 / (t3 + t5)
    t7 = x * x + y * y
    t8 = t7 + z * z - d2 * d2 - d3 * d3 - d4 * d4
    t9 = t8 - r2 * r2 - r3 * r3 - r3 * (r2 * (ca3 + ca3))
    t10 = t1 * t9
    t11 = np.sqrt(np.maximum(0.0, t3 - t9 * t9))
    t12 = t2 * t11
    t13 = t5 - t6 * (t10 + t12)
    t14 = t1 * t11
    t15 = t2 * t9
    t16 = t6 * (t14 - t15)
    t17 = np.sqrt((t13 * t13 + t16 * t16))
    t18 = np.where(t17 != 0.0, 1, 0.0)
    t19 = t18 / (t17 + (1 - t18))
    t20 = t13 * t19
    t21 = d3 + d4 * t20
    t22 = d4 * ca3
    t23 = t16 * t19
    t24 = sa3 * r3
    t25 = t22 * t23 - t24
    t26 = t21 * t21 + t25 * t25
    t27 = np.where(sa2 != 0.0, 1, 0.0)
    t28 = t27 / (sa2 + (1 - t27))
    t29 = z - r2 * ca2 - r3 * (ca3 * ca2)
    t30 = sa3 * (d4 * ca2)
    t31 = t28 * (t29 - t23 * t30)
    t32 = np.sqrt(np.maximum(0.0, t26 - t31 * t31))
    t33 = t21 * t32
    t34 = t25 * t31
    t35 = t33 + t34
    t36 = t21 * t31
    t37 = t25 * t32
    t38 = t36 - t37
    t39 = np.sqrt((t35 * t35 + t38 * t38))
    t40 = np.where(t39 != 0.0, 1, 0.0)
    t41 = t40 / (t39 + (1 - t40))
    t42 = t35 * t41
    t43 = t38 * t41
    t44 = d2 + (t21 * t42 - t25 * t43)
    t45 = t25 * t42 + t21 * t43
    t46 = r3 * ca3
    t47 = r2 + (t46 + sa3 * (d4 * t23))
    t48 = sa2 * t47
    t49 = ca2 * t45 - t48
    t50 = x * t44 + y * t49
    t51 = y * t44 - x * t49
    t52 = -t50
    t53 = np.maximum(t50, t52)
    t54 = np.maximum(t51, -t51)
    t55 = np.sqrt((t50 * t50 + t51 * t51)) + np.maximum(t53, t54)
    t56 = np.where(t55 != 0.0, 1, 0.0)
    t57 = t56 / (t55 + (1 - t56)) * np.minimum(t53, t54)
    t58 = t57 / (1 + np.sqrt((1 + t57 * t57)))
    t59 = t58 * t58
    t60 = t59 * (t59 * (0.058823529411764705 + t59 * (0.047619047619047616 * t59 - 0.05263157894736842)) - 0.06666666666666667)
    t61 = t59 * (0.1111111111111111 + t59 * (t59 * (0.07692307692307693 + t60) - 0.09090909090909091)) - 0.14285714285714285
    t62 = 4 * t58 * (1 + t59 * (t59 * (0.2 + t59 * t61) - 0.3333333333333333))
    t63 = 0.5 * np.copysign(1, t54 - t53)
    t64 = t62 * (0.5 - t63) + (0.5 + t63) * (1.5707963267948966 - t62)
    t65 = 0.5 * np.copysign(1, t52)
    t66 = np.copysign((t64 * (0.5 - t65) + (0.5 + t65) * (3.141592653589793 - t64)), t51)
    t67 = -t42
    t68 = np.maximum(t42, t67)
    t69 = np.maximum(t43, -t43)
    t70 = 1 + np.maximum(t68, t69)
    t71 = np.where(t70 != 0.0, 1, 0.0)
    t72 = t71 / (t70 + (1 - t71)) * np.minimum(t68, t69)
    t73 = t72 / (1 + np.sqrt((1 + t72 * t72)))
    t74 = t73 * t73
    t75 = t74 * (t74 * (0.058823529411764705 + t74 * (0.047619047619047616 * t74 - 0.05263157894736842)) - 0.06666666666666667)
    t76 = t74 * (0.1111111111111111 + t74 * (t74 * (0.07692307692307693 + t75) - 0.09090909090909091)) - 0.14285714285714285
    t77 = 4 * t73 * (1 + t74 * (t74 * (0.2 + t74 * t76) - 0.3333333333333333))
    t78 = 0.5 * np.copysign(1, t69 - t68)
    t79 = t77 * (0.5 - t78) + (0.5 + t78) * (1.5707963267948966 - t77)
    t80 = 0.5 * np.copysign(1, t67)
    t81 = np.copysign((t79 * (0.5 - t80) + (0.5 + t80) * (3.141592653589793 - t79)), t43)
    t82 = -t20
    t83 = np.maximum(t20, t82)
    t84 = np.maximum(t23, -t23)
    t85 = 1 + np.maximum(t83, t84)
    t86 = np.where(t85 != 0.0, 1, 0.0)
    t87 = t86 / (t85 + (1 - t86)) * np.minimum(t83, t84)
    t88 = t87 / (1 + np.sqrt((1 + t87 * t87)))
    t89 = t88 * t88
    t90 = t89 * (t89 * (0.058823529411764705 + t89 * (0.047619047619047616 * t89 - 0.05263157894736842)) - 0.06666666666666667)
    t91 = t89 * (0.1111111111111111 + t89 * (t89 * (0.07692307692307693 + t90) - 0.09090909090909091)) - 0.14285714285714285
    t92 = 4 * t88 * (1 + t89 * (t89 * (0.2 + t89 * t91) - 0.3333333333333333))
    t93 = 0.5 * np.copysign(1, t84 - t83)
    t94 = t92 * (0.5 - t93) + (0.5 + t93) * (1.5707963267948966 - t92)
    t95 = 0.5 * np.copysign(1, t82)
    t96 = np.copysign((t94 * (0.5 - t95) + (0.5 + t95) * (3.141592653589793 - t94)), t23)
    t97 = t34 - t33
    t98 = t36 + t37
    t99 = np.sqrt((t97 * t97 + t98 * t98))
    t100 = np.where(t99 != 0.0, 1, 0.0)
    t101 = t100 / (t99 + (1 - t100))
    t102 = t97 * t101
    t103 = t98 * t101
    t104 = d2 + (t21 * t102 - t25 * t103)
    t105 = t25 * t102 + t21 * t103
    t106 = ca2 * t105 - t48
    t107 = x * t104 + y * t106
    t108 = y * t104 - x * t106
    t109 = -t107
    t110 = np.maximum(t107, t109)
    t111 = np.maximum(t108, -t108)
    t112 = np.sqrt((t107 * t107 + t108 * t108)) + np.maximum(t110, t111)
    t113 = np.where(t112 != 0.0, 1, 0.0)
    t114 = t113 / (t112 + (1 - t113)) * np.minimum(t110, t111)
    t115 = t114 / (1 + np.sqrt((1 + t114 * t114)))
    t116 = t115 * t115
    t117 = t116 * (t116 * (0.058823529411764705 + t116 * (0.047619047619047616 * t116 - 0.05263157894736842)) - 0.06666666666666667)
    t118 = t116 * (0.1111111111111111 + t116 * (t116 * (0.07692307692307693 + t117) - 0.09090909090909091)) - 0.14285714285714285
    t119 = 4 * t115 * (1 + t116 * (t116 * (0.2 + t116 * t118) - 0.3333333333333333))
    t120 = 0.5 * np.copysign(1, t111 - t110)
    t121 = t119 * (0.5 - t120) + (0.5 + t120) * (1.5707963267948966 - t119)
    t122 = 0.5 * np.copysign(1, t109)
    t123 = np.copysign((t121 * (0.5 - t122) + (0.5 + t122) * (3.141592653589793 - t121)), t108)
    t124 = -t102
    t125 = np.maximum(t102, t124)
    t126 = np.maximum(t103, -t103)
    t127 = 1 + np.maximum(t125, t126)
    t128 = np.where(t127 != 0.0, 1, 0.0)
    t129 = t128 / (t127 + (1 - t128)) * np.minimum(t125, t126)
    t130 = t129 / (1 + np.sqrt((1 + t129 * t129)))
    t131 = t130 * t130
    t132 = t131 * (t131 * (0.058823529411764705 + t131 * (0.047619047619047616 * t131 - 0.05263157894736842)) - 0.06666666666666667)
    t133 = t131 * (0.1111111111111111 + t131 * (t131 * (0.07692307692307693 + t132) - 0.09090909090909091)) - 0.14285714285714285
    t134 = 4 * t130 * (1 + t131 * (t131 * (0.2 + t131 * t133) - 0.3333333333333333))
    t135 = 0.5 * np.copysign(1, t126 - t125)
    t136 = t134 * (0.5 - t135) + (0.5 + t135) * (1.5707963267948966 - t134)
    t137 = 0.5 * np.copysign(1, t124)
    t138 = np.copysign((t136 * (0.5 - t137) + (0.5 + t137) * (3.141592653589793 - t136)), t103)
    t139 = t5 - t6 * (t10 - t12)
    t140 = t6 * (t14 + t15)
    t141 = np.sqrt((t139 * t139 + t140 * t140))
    t142 = np.where(t141 != 0.0, 1, 0.0)
    t143 = t142 / (t141 + (1 - t142))
    t144 = t139 * t143
    t145 = d3 + d4 * t144
    t146 = t140 * t143
    t147 = t24 + t22 * t146
    t148 = t145 * t145 + t147 * t147
    t149 = t28 * (t29 + t30 * t146)
    t150 = np.sqrt(np.maximum(0.0, t148 - t149 * t149))
    t151 = t145 * t150
    t152 = t147 * t149
    t153 = t151 - t152
    t154 = t145 * t149
    t155 = t147 * t150
    t156 = t154 + t155
    t157 = np.sqrt((t153 * t153 + t156 * t156))
    t158 = np.where(t157 != 0.0, 1, 0.0)
    t159 = t158 / (t157 + (1 - t158))
    t160 = t153 * t159
    t161 = t156 * t159
    t162 = d2 + (t145 * t160 + t147 * t161)
    t163 = t145 * t161 - t147 * t160
    t164 = r2 + (t46 - sa3 * (d4 * t146))
    t165 = sa2 * t164
    t166 = ca2 * t163 - t165
    t167 = x * t162 + y * t166
    t168 = y * t162 - x * t166
    t169 = -t167
    t170 = np.maximum(t167, t169)
    t171 = np.maximum(t168, -t168)
    t172 = np.sqrt((t167 * t167 + t168 * t168)) + np.maximum(t170, t171)
    t173 = np.where(t172 != 0.0, 1, 0.0)
    t174 = t173 / (t172 + (1 - t173)) * np.minimum(t170, t171)
    t175 = t174 / (1 + np.sqrt((1 + t174 * t174)))
    t176 = t175 * t175
    t177 = t176 * (t176 * (0.058823529411764705 + t176 * (0.047619047619047616 * t176 - 0.05263157894736842)) - 0.06666666666666667)
    t178 = t176 * (0.1111111111111111 + t176 * (t176 * (0.07692307692307693 + t177) - 0.09090909090909091)) - 0.14285714285714285
    t179 = 4 * t175 * (1 + t176 * (t176 * (0.2 + t176 * t178) - 0.3333333333333333))
    t180 = 0.5 * np.copysign(1, t171 - t170)
    t181 = t179 * (0.5 - t180) + (0.5 + t180) * (1.5707963267948966 - t179)
    t182 = 0.5 * np.copysign(1, t169)
    t183 = np.copysign((t181 * (0.5 - t182) + (0.5 + t182) * (3.141592653589793 - t181)), t168)
    t184 = -t160
    t185 = np.maximum(t160, t184)
    t186 = np.maximum(t161, -t161)
    t187 = 1 + np.maximum(t185, t186)
    t188 = np.where(t187 != 0.0, 1, 0.0)
    t189 = t188 / (t187 + (1 - t188)) * np.minimum(t185, t186)
    t190 = t189 / (1 + np.sqrt((1 + t189 * t189)))
    t191 = t190 * t190
    t192 = t191 * (t191 * (0.058823529411764705 + t191 * (0.047619047619047616 * t191 - 0.05263157894736842)) - 0.06666666666666667)
    t193 = t191 * (0.1111111111111111 + t191 * (t191 * (0.07692307692307693 + t192) - 0.09090909090909091)) - 0.14285714285714285
    t194 = 4 * t190 * (1 + t191 * (t191 * (0.2 + t191 * t193) - 0.3333333333333333))
    t195 = 0.5 * np.copysign(1, t186 - t185)
    t196 = t194 * (0.5 - t195) + (0.5 + t195) * (1.5707963267948966 - t194)
    t197 = 0.5 * np.copysign(1, t184)
    t198 = np.copysign((t196 * (0.5 - t197) + (0.5 + t197) * (3.141592653589793 - t196)), t161)
    t199 = -t144
    t200 = np.maximum(t144, t199)
    t201 = -t146
    t202 = np.maximum(t146, t201)
    t203 = 1 + np.maximum(t200, t202)
    t204 = np.where(t203 != 0.0, 1, 0.0)
    t205 = t204 / (t203 + (1 - t204)) * np.minimum(t200, t202)
    t206 = t205 / (1 + np.sqrt((1 + t205 * t205)))
    t207 = t206 * t206
    t208 = t207 * (t207 * (0.058823529411764705 + t207 * (0.047619047619047616 * t207 - 0.05263157894736842)) - 0.06666666666666667)
    t209 = t207 * (0.1111111111111111 + t207 * (t207 * (0.07692307692307693 + t208) - 0.09090909090909091)) - 0.14285714285714285
    t210 = 4 * t206 * (1 + t207 * (t207 * (0.2 + t207 * t209) - 0.3333333333333333))
    t211 = 0.5 * np.copysign(1, t202 - t200)
    t212 = t210 * (0.5 - t211) + (0.5 + t211) * (1.5707963267948966 - t210)
    t213 = 0.5 * np.copysign(1, t199)
    t214 = np.copysign((t212 * (0.5 - t213) + (0.5 + t213) * (3.141592653589793 - t212)), t201)
    t215 = t151 + t152
    t216 = t154 - t155
    t217 = np.sqrt((t215 * t215 + t216 * t216))
    t218 = np.where(t217 != 0.0, 1, 0.0)
    t219 = t218 / (t217 + (1 - t218))
    t220 = t216 * t219
    t221 = t215 * t219
    t222 = d2 + (t147 * t220 - t145 * t221)
    t223 = t147 * t221 + t145 * t220
    t224 = ca2 * t223 - t165
    t225 = x * t222 + y * t224
    t226 = y * t222 - x * t224
    t227 = -t225
    t228 = np.maximum(t225, t227)
    t229 = np.maximum(t226, -t226)
    t230 = np.sqrt((t225 * t225 + t226 * t226)) + np.maximum(t228, t229)
    t231 = np.where(t230 != 0.0, 1, 0.0)
    t232 = t231 / (t230 + (1 - t231)) * np.minimum(t228, t229)
    t233 = t232 / (1 + np.sqrt((1 + t232 * t232)))
    t234 = t233 * t233
    t235 = t234 * (t234 * (0.058823529411764705 + t234 * (0.047619047619047616 * t234 - 0.05263157894736842)) - 0.06666666666666667)
    t236 = t234 * (0.1111111111111111 + t234 * (t234 * (0.07692307692307693 + t235) - 0.09090909090909091)) - 0.14285714285714285
    t237 = 4 * t233 * (1 + t234 * (t234 * (0.2 + t234 * t236) - 0.3333333333333333))
    t238 = 0.5 * np.copysign(1, t229 - t228)
    t239 = t237 * (0.5 - t238) + (0.5 + t238) * (1.5707963267948966 - t237)
    t240 = 0.5 * np.copysign(1, t227)
    t241 = np.copysign((t239 * (0.5 - t240) + (0.5 + t240) * (3.141592653589793 - t239)), t226)
    t242 = np.maximum(t221, -t221)
    t243 = np.maximum(t220, -t220)
    t244 = 1 + np.maximum(t242, t243)
    t245 = np.where(t244 != 0.0, 1, 0.0)
    t246 = t245 / (t244 + (1 - t245)) * np.minimum(t242, t243)
    t247 = t246 / (1 + np.sqrt((1 + t246 * t246)))
    t248 = t247 * t247
    t249 = t248 * (t248 * (0.058823529411764705 + t248 * (0.047619047619047616 * t248 - 0.05263157894736842)) - 0.06666666666666667)
    t250 = t248 * (0.1111111111111111 + t248 * (t248 * (0.07692307692307693 + t249) - 0.09090909090909091)) - 0.14285714285714285
    t251 = 4 * t247 * (1 + t248 * (t248 * (0.2 + t248 * t250) - 0.3333333333333333))
    t252 = 0.5 * np.copysign(1, t243 - t242)
    t253 = t251 * (0.5 - t252) + (0.5 + t252) * (1.5707963267948966 - t251)
    t254 = 0.5 * np.copysign(1, t221)
    t255 = np.copysign((t253 * (0.5 - t254) + (0.5 + t254) * (3.141592653589793 - t253)), t220)
    t256 = np.sqrt(t7)
    t257 = np.sqrt((t44 * t44 + t49 * t49)) - t256
    t258 = ca2 * t47
    t259 = sa2 * t45 + t258 - z
    t260 = np.sqrt((t104 * t104 + t106 * t106)) - t256
    t261 = t258 + sa2 * t105 - z
    t262 = np.sqrt((t162 * t162 + t166 * t166)) - t256
    t263 = ca2 * t164
    t264 = sa2 * t163 + t263 - z
    t265 = np.sqrt((t222 * t222 + t224 * t224)) - t256
    t266 = t263 + sa2 * t223 - z

    # results
    angles = np.empty((*_leading, 12), _real)
    closure = np.empty((*_leading, 4), _real)
    width = np.empty((*_leading, 4), _real)
    angles[..., 0] = t66
    angles[..., 1] = t81
    angles[..., 2] = t96
    angles[..., 3] = t123
    angles[..., 4] = t138
    angles[..., 5] = t96
    angles[..., 6] = t183
    angles[..., 7] = t198
    angles[..., 8] = t214
    angles[..., 9] = t241
    angles[..., 10] = t255
    angles[..., 11] = t214
    closure[..., 0] = np.sqrt((t257 * t257 + t259 * t259))
    closure[..., 1] = np.sqrt((t260 * t260 + t261 * t261))
    closure[..., 2] = np.sqrt((t262 * t262 + t264 * t264))
    closure[..., 3] = np.sqrt((t265 * t265 + t266 * t266))
    width[..., 0] = t26
    width[..., 1] = t26
    width[..., 2] = t148
    width[..., 3] = t148
    return angles.reshape(_leading + (4, 3)), closure.reshape(_leading + (4,)), width.reshape(_leading + (4,))


def postures_parallel(parameters, point):
    """the postures of an arm with axes 1 and 2 parallel, the distance each leaves, and W: 878 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    in   point[3] = (x, y, z)
    out  angles[4][3]
    out  closure[4]
    out  width[4]
    """
    parameters = np.asarray(parameters)
    point = np.asarray(point)
    _leading = np.broadcast_shapes(parameters.shape[:-1], point.shape[:-1])
    _real = np.result_type(parameters, point, np.float32)

    # inputs, sines and cosines
    d3 = parameters[..., 5]
    ca2 = parameters[..., 0]
    d4 = parameters[..., 6]
    sa3 = parameters[..., 3]
    z = point[..., 2]
    r2 = parameters[..., 7]
    ca3 = parameters[..., 2]
    r3 = parameters[..., 8]
    d2 = parameters[..., 4]
    x = point[..., 0]
    y = point[..., 1]
    sa2 = parameters[..., 1]

    # terms
    t1 = ca2 * d4 * sa3
    t2 = t1 * t1
    t3 = np.where(t2 != 0.0, 1, 0.0)
    t4 = 1 - t3
    t5 = t3 / (t2 + t4)
    t6 = z - ca2 * r2 - ca2 * ca3 * r3
    t7 = t1 * t5 * np.sqrt(np.maximum(0.0, t2 - t6 * t6))
    t8 = t4 + t7
    t9 = t5 * (t1 * t6)
    t10 = t9 * t9
    t11 = np.sqrt((t8 * t8 + t10))
    t12 = np.where(t11 != 0.0, 1, 0.0)
    t13 = t12 / (t11 + (1 - t12))
    t14 = t8 * t13
    t15 = d3 + d4 * t14
    t16 = d2 + d2
    t17 = np.where(t16 != 0.0, 1, 0.0)
    t18 = t17 / (t16 + (1 - t17))
    t19 = x * x + y * y
    t20 = t19 + z * z - d2 * d2 - d3 * d3 - d4 * d4
    t21 = t20 - r2 * r2 - r3 * r3 - r3 * (r2 * (ca3 + ca3))
    t22 = d4 * (-2 * d3)
    t23 = sa3 * (r2 * (-2 * d4))
    t24 = t9 * t13
    t25 = t18 * (t21 + t14 * t22 + t23 * t24)
    t26 = t15 * t25
    t27 = d4 * ca3
    t28 = sa3 * r3
    t29 = t24 * t27 - t28
    t30 = t15 * t15 + t29 * t29
    t31 = np.sqrt(np.maximum(0.0, t30 - t25 * t25))
    t32 = t29 * t31
    t33 = t26 + t32
    t34 = t15 * t31
    t35 = t25 * t29
    t36 = t34 - t35
    t37 = np.sqrt((t33 * t33 + t36 * t36))
    t38 = np.where(t37 != 0.0, 1, 0.0)
    t39 = t38 / (t37 + (1 - t38))
    t40 = t33 * t39
    t41 = t36 * t39
    t42 = d2 + (t15 * t40 - t29 * t41)
    t43 = t29 * t40 + t15 * t41
    t44 = ca3 * r3
    t45 = r2 + (t44 + sa3 * (d4 * t24))
    t46 = sa2 * t45
    t47 = ca2 * t43 - t46
    t48 = x * t42 + y * t47
    t49 = y * t42 - x * t47
    t50 = -t48
    t51 = np.maximum(t48, t50)
    t52 = np.maximum(t49, -t49)
    t53 = np.sqrt((t48 * t48 + t49 * t49)) + np.maximum(t51, t52)
    t54 = np.where(t53 != 0.0, 1, 0.0)
    t55 = t54 / (t53 + (1 - t54)) * np.minimum(t51, t52)
    t56 = t55 / (1 + np.sqrt((1 + t55 * t55)))
    t57 = t56 * t56
    t58 = t57 * (t57 * (0.058823529411764705 + t57 * (0.047619047619047616 * t57 - 0.05263157894736842)) - 0.06666666666666667)
    t59 = t57 * (0.1111111111111111 + t57 * (t57 * (0.07692307692307693 + t58) - 0.09090909090909091)) - 0.14285714285714285
    t60 = 4 * t56 * (1 + t57 * (t57 * (0.2 + t57 * t59) - 0.3333333333333333))
    t61 = 0.5 * np.copysign(1, t52 - t51)
    t62 = t60 * (0.5 - t61) + (0.5 + t61) * (1.5707963267948966 - t60)
    t63 = 0.5 * np.copysign(1, t50)
    t64 = np.copysign((t62 * (0.5 - t63) + (0.5 + t63) * (3.141592653589793 - t62)), t49)
    t65 = -t40
    t66 = np.maximum(t40, t65)
    t67 = np.maximum(t41, -t41)
    t68 = 1 + np.maximum(t66, t67)
    t69 = np.where(t68 != 0.0, 1, 0.0)
    t70 = t69 / (t68 + (1 - t69)) * np.minimum(t66, t67)
    t71 = t70 / (1 + np.sqrt((1 + t70 * t70)))
    t72 = t71 * t71
    t73 = t72 * (t72 * (0.058823529411764705 + t72 * (0.047619047619047616 * t72 - 0.05263157894736842)) - 0.06666666666666667)
    t74 = t72 * (0.1111111111111111 + t72 * (t72 * (0.07692307692307693 + t73) - 0.09090909090909091)) - 0.14285714285714285
    t75 = 4 * t71 * (1 + t72 * (t72 * (0.2 + t72 * t74) - 0.3333333333333333))
    t76 = 0.5 * np.copysign(1, t67 - t66)
    t77 = t75 * (0.5 - t76) + (0.5 + t76) * (1.5707963267948966 - t75)
    t78 = 0.5 * np.copysign(1, t65)
    t79 = np.copysign((t77 * (0.5 - t78) + (0.5 + t78) * (3.141592653589793 - t77)), t41)
    t80 = -t14
    t81 = np.maximum(t14, t80)
    t82 = np.maximum(t24, -t24)
    t83 = 1 + np.maximum(t81, t82)
    t84 = np.where(t83 != 0.0, 1, 0.0)
    t85 = t84 / (t83 + (1 - t84)) * np.minimum(t81, t82)
    t86 = t85 / (1 + np.sqrt((1 + t85 * t85)))
    t87 = t86 * t86
    t88 = t87 * (t87 * (0.058823529411764705 + t87 * (0.047619047619047616 * t87 - 0.05263157894736842)) - 0.06666666666666667)
    t89 = t87 * (0.1111111111111111 + t87 * (t87 * (0.07692307692307693 + t88) - 0.09090909090909091)) - 0.14285714285714285
    t90 = 4 * t86 * (1 + t87 * (t87 * (0.2 + t87 * t89) - 0.3333333333333333))
    t91 = 0.5 * np.copysign(1, t82 - t81)
    t92 = t90 * (0.5 - t91) + (0.5 + t91) * (1.5707963267948966 - t90)
    t93 = 0.5 * np.copysign(1, t80)
    t94 = np.copysign((t92 * (0.5 - t93) + (0.5 + t93) * (3.141592653589793 - t92)), t24)
    t95 = t26 - t32
    t96 = t34 + t35
    t97 = np.sqrt((t95 * t95 + t96 * t96))
    t98 = np.where(t97 != 0.0, 1, 0.0)
    t99 = t98 / (t97 + (1 - t98))
    t100 = t95 * t99
    t101 = t96 * t99
    t102 = d2 + (t15 * t100 + t29 * t101)
    t103 = t29 * t100 - t15 * t101
    t104 = ca2 * t103 - t46
    t105 = x * t102 + y * t104
    t106 = y * t102 - x * t104
    t107 = -t105
    t108 = np.maximum(t105, t107)
    t109 = np.maximum(t106, -t106)
    t110 = np.sqrt((t105 * t105 + t106 * t106)) + np.maximum(t108, t109)
    t111 = np.where(t110 != 0.0, 1, 0.0)
    t112 = t111 / (t110 + (1 - t111)) * np.minimum(t108, t109)
    t113 = t112 / (1 + np.sqrt((1 + t112 * t112)))
    t114 = t113 * t113
    t115 = t114 * (t114 * (0.058823529411764705 + t114 * (0.047619047619047616 * t114 - 0.05263157894736842)) - 0.06666666666666667)
    t116 = t114 * (0.1111111111111111 + t114 * (t114 * (0.07692307692307693 + t115) - 0.09090909090909091)) - 0.14285714285714285
    t117 = 4 * t113 * (1 + t114 * (t114 * (0.2 + t114 * t116) - 0.3333333333333333))
    t118 = 0.5 * np.copysign(1, t109 - t108)
    t119 = t117 * (0.5 - t118) + (0.5 + t118) * (1.5707963267948966 - t117)
    t120 = 0.5 * np.copysign(1, t107)
    t121 = np.copysign((t119 * (0.5 - t120) + (0.5 + t120) * (3.141592653589793 - t119)), t106)
    t122 = -t100
    t123 = np.maximum(t100, t122)
    t124 = -t101
    t125 = np.maximum(t101, t124)
    t126 = 1 + np.maximum(t123, t125)
    t127 = np.where(t126 != 0.0, 1, 0.0)
    t128 = t127 / (t126 + (1 - t127)) * np.minimum(t123, t125)
    t129 = t128 / (1 + np.sqrt((1 + t128 * t128)))
    t130 = t129 * t129
    t131 = t130 * (t130 * (0.058823529411764705 + t130 * (0.047619047619047616 * t130 - 0.05263157894736842)) - 0.06666666666666667)
    t132 = t130 * (0.1111111111111111 + t130 * (t130 * (0.07692307692307693 + t131) - 0.09090909090909091)) - 0.14285714285714285
    t133 = 4 * t129 * (1 + t130 * (t130 * (0.2 + t130 * t132) - 0.3333333333333333))
    t134 = 0.5 * np.copysign(1, t125 - t123)
    t135 = t133 * (0.5 - t134) + (0.5 + t134) * (1.5707963267948966 - t133)
    t136 = 0.5 * np.copysign(1, t122)
    t137 = np.copysign((t135 * (0.5 - t136) + (0.5 + t136) * (3.141592653589793 - t135)), t124)
    t138 = t4 - t7
    t139 = np.sqrt((t10 + t138 * t138))
    t140 = np.where(t139 != 0.0, 1, 0.0)
    t141 = t140 / (t139 + (1 - t140))
    t142 = t138 * t141
    t143 = d3 + d4 * t142
    t144 = t9 * t141
    t145 = t18 * (t21 + t22 * t142 + t23 * t144)
    t146 = t143 * t145
    t147 = t27 * t144 - t28
    t148 = t143 * t143 + t147 * t147
    t149 = np.sqrt(np.maximum(0.0, t148 - t145 * t145))
    t150 = t147 * t149
    t151 = t146 + t150
    t152 = t143 * t149
    t153 = t145 * t147
    t154 = t152 - t153
    t155 = np.sqrt((t151 * t151 + t154 * t154))
    t156 = np.where(t155 != 0.0, 1, 0.0)
    t157 = t156 / (t155 + (1 - t156))
    t158 = t151 * t157
    t159 = t154 * t157
    t160 = d2 + (t143 * t158 - t147 * t159)
    t161 = t147 * t158 + t143 * t159
    t162 = r2 + (t44 + sa3 * (d4 * t144))
    t163 = sa2 * t162
    t164 = ca2 * t161 - t163
    t165 = x * t160 + y * t164
    t166 = y * t160 - x * t164
    t167 = -t165
    t168 = np.maximum(t165, t167)
    t169 = np.maximum(t166, -t166)
    t170 = np.sqrt((t165 * t165 + t166 * t166)) + np.maximum(t168, t169)
    t171 = np.where(t170 != 0.0, 1, 0.0)
    t172 = t171 / (t170 + (1 - t171)) * np.minimum(t168, t169)
    t173 = t172 / (1 + np.sqrt((1 + t172 * t172)))
    t174 = t173 * t173
    t175 = t174 * (t174 * (0.058823529411764705 + t174 * (0.047619047619047616 * t174 - 0.05263157894736842)) - 0.06666666666666667)
    t176 = t174 * (0.1111111111111111 + t174 * (t174 * (0.07692307692307693 + t175) - 0.09090909090909091)) - 0.14285714285714285
    t177 = 4 * t173 * (1 + t174 * (t174 * (0.2 + t174 * t176) - 0.3333333333333333))
    t178 = 0.5 * np.copysign(1, t169 - t168)
    t179 = t177 * (0.5 - t178) + (0.5 + t178) * (1.5707963267948966 - t177)
    t180 = 0.5 * np.copysign(1, t167)
    t181 = np.copysign((t179 * (0.5 - t180) + (0.5 + t180) * (3.141592653589793 - t179)), t166)
    t182 = -t158
    t183 = np.maximum(t158, t182)
    t184 = np.maximum(t159, -t159)
    t185 = 1 + np.maximum(t183, t184)
    t186 = np.where(t185 != 0.0, 1, 0.0)
    t187 = t186 / (t185 + (1 - t186)) * np.minimum(t183, t184)
    t188 = t187 / (1 + np.sqrt((1 + t187 * t187)))
    t189 = t188 * t188
    t190 = t189 * (t189 * (0.058823529411764705 + t189 * (0.047619047619047616 * t189 - 0.05263157894736842)) - 0.06666666666666667)
    t191 = t189 * (0.1111111111111111 + t189 * (t189 * (0.07692307692307693 + t190) - 0.09090909090909091)) - 0.14285714285714285
    t192 = 4 * t188 * (1 + t189 * (t189 * (0.2 + t189 * t191) - 0.3333333333333333))
    t193 = 0.5 * np.copysign(1, t184 - t183)
    t194 = t192 * (0.5 - t193) + (0.5 + t193) * (1.5707963267948966 - t192)
    t195 = 0.5 * np.copysign(1, t182)
    t196 = np.copysign((t194 * (0.5 - t195) + (0.5 + t195) * (3.141592653589793 - t194)), t159)
    t197 = -t142
    t198 = np.maximum(t142, t197)
    t199 = np.maximum(t144, -t144)
    t200 = 1 + np.maximum(t198, t199)
    t201 = np.where(t200 != 0.0, 1, 0.0)
    t202 = t201 / (t200 + (1 - t201)) * np.minimum(t198, t199)
    t203 = t202 / (1 + np.sqrt((1 + t202 * t202)))
    t204 = t203 * t203
    t205 = t204 * (t204 * (0.058823529411764705 + t204 * (0.047619047619047616 * t204 - 0.05263157894736842)) - 0.06666666666666667)
    t206 = t204 * (0.1111111111111111 + t204 * (t204 * (0.07692307692307693 + t205) - 0.09090909090909091)) - 0.14285714285714285
    t207 = 4 * t203 * (1 + t204 * (t204 * (0.2 + t204 * t206) - 0.3333333333333333))
    t208 = 0.5 * np.copysign(1, t199 - t198)
    t209 = t207 * (0.5 - t208) + (0.5 + t208) * (1.5707963267948966 - t207)
    t210 = 0.5 * np.copysign(1, t197)
    t211 = np.copysign((t209 * (0.5 - t210) + (0.5 + t210) * (3.141592653589793 - t209)), t144)
    t212 = t146 - t150
    t213 = t152 + t153
    t214 = np.sqrt((t212 * t212 + t213 * t213))
    t215 = np.where(t214 != 0.0, 1, 0.0)
    t216 = t215 / (t214 + (1 - t215))
    t217 = t212 * t216
    t218 = t213 * t216
    t219 = d2 + (t143 * t217 + t147 * t218)
    t220 = t147 * t217 - t143 * t218
    t221 = ca2 * t220 - t163
    t222 = x * t219 + y * t221
    t223 = y * t219 - x * t221
    t224 = -t222
    t225 = np.maximum(t222, t224)
    t226 = np.maximum(t223, -t223)
    t227 = np.sqrt((t222 * t222 + t223 * t223)) + np.maximum(t225, t226)
    t228 = np.where(t227 != 0.0, 1, 0.0)
    t229 = t228 / (t227 + (1 - t228)) * np.minimum(t225, t226)
    t230 = t229 / (1 + np.sqrt((1 + t229 * t229)))
    t231 = t230 * t230
    t232 = t231 * (t231 * (0.058823529411764705 + t231 * (0.047619047619047616 * t231 - 0.05263157894736842)) - 0.06666666666666667)
    t233 = t231 * (0.1111111111111111 + t231 * (t231 * (0.07692307692307693 + t232) - 0.09090909090909091)) - 0.14285714285714285
    t234 = 4 * t230 * (1 + t231 * (t231 * (0.2 + t231 * t233) - 0.3333333333333333))
    t235 = 0.5 * np.copysign(1, t226 - t225)
    t236 = t234 * (0.5 - t235) + (0.5 + t235) * (1.5707963267948966 - t234)
    t237 = 0.5 * np.copysign(1, t224)
    t238 = np.copysign((t236 * (0.5 - t237) + (0.5 + t237) * (3.141592653589793 - t236)), t223)
    t239 = -t217
    t240 = np.maximum(t217, t239)
    t241 = -t218
    t242 = np.maximum(t218, t241)
    t243 = 1 + np.maximum(t240, t242)
    t244 = np.where(t243 != 0.0, 1, 0.0)
    t245 = t244 / (t243 + (1 - t244)) * np.minimum(t240, t242)
    t246 = t245 / (1 + np.sqrt((1 + t245 * t245)))
    t247 = t246 * t246
    t248 = t247 * (t247 * (0.058823529411764705 + t247 * (0.047619047619047616 * t247 - 0.05263157894736842)) - 0.06666666666666667)
    t249 = t247 * (0.1111111111111111 + t247 * (t247 * (0.07692307692307693 + t248) - 0.09090909090909091)) - 0.14285714285714285
    t250 = 4 * t246 * (1 + t247 * (t247 * (0.2 + t247 * t249) - 0.3333333333333333))
    t251 = 0.5 * np.copysign(1, t242 - t240)
    t252 = t250 * (0.5 - t251) + (0.5 + t251) * (1.5707963267948966 - t250)
    t253 = 0.5 * np.copysign(1, t239)
    t254 = np.copysign((t252 * (0.5 - t253) + (0.5 + t253) * (3.141592653589793 - t252)), t241)
    t255 = np.sqrt(t19)
    t256 = np.sqrt((t42 * t42 + t47 * t47)) - t255
    t257 = ca2 * t45
    t258 = t43 * sa2 + t257 - z
    t259 = np.sqrt((t102 * t102 + t104 * t104)) - t255
    t260 = t257 + sa2 * t103 - z
    t261 = np.sqrt((t160 * t160 + t164 * t164)) - t255
    t262 = ca2 * t162
    t263 = sa2 * t161 + t262 - z
    t264 = np.sqrt((t219 * t219 + t221 * t221)) - t255
    t265 = t262 + sa2 * t220 - z

    # results
    angles = np.empty((*_leading, 12), _real)
    closure = np.empty((*_leading, 4), _real)
    width = np.empty((*_leading, 4), _real)
    angles[..., 0] = t64
    angles[..., 1] = t79
    angles[..., 2] = t94
    angles[..., 3] = t121
    angles[..., 4] = t137
    angles[..., 5] = t94
    angles[..., 6] = t181
    angles[..., 7] = t196
    angles[..., 8] = t211
    angles[..., 9] = t238
    angles[..., 10] = t254
    angles[..., 11] = t211
    closure[..., 0] = np.sqrt((t256 * t256 + t258 * t258))
    closure[..., 1] = np.sqrt((t259 * t259 + t260 * t260))
    closure[..., 2] = np.sqrt((t261 * t261 + t263 * t263))
    closure[..., 3] = np.sqrt((t264 * t264 + t265 * t265))
    width[..., 0] = t30
    width[..., 1] = t30
    width[..., 2] = t148
    width[..., 3] = t148
    return angles.reshape(_leading + (4, 3)), closure.reshape(_leading + (4,)), width.reshape(_leading + (4,))


def sweep_conditions(parameters, target):
    """coefficients, lowest power of t = tan(theta3/2) first, of (1 + t^2) U, (1 + t^2) V and (1 + t^2)^2 W: 57 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    in   target[2] = (rho_squared, z)
    out  U[3]
    out  V[3]
    out  W[5]
    """
    parameters = np.asarray(parameters)
    target = np.asarray(target)
    _leading = np.broadcast_shapes(parameters.shape[:-1], target.shape[:-1])
    _real = np.result_type(parameters, target, np.float32)

    # inputs, sines and cosines
    rho_squared = target[..., 0]
    z = target[..., 1]
    d2 = parameters[..., 4]
    d3 = parameters[..., 5]
    d4 = parameters[..., 6]
    r2 = parameters[..., 7]
    r3 = parameters[..., 8]
    ca3 = parameters[..., 2]
    sa3 = parameters[..., 3]
    ca2 = parameters[..., 0]

    # terms
    t1 = rho_squared + z * z
    t2 = d2 * d2
    t3 = d3 * d3
    t4 = d4 * d4
    t5 = r2 * r2
    t6 = r3 * r3
    t7 = d4 * (d3 + d3)
    t8 = r3 * (r2 * (ca3 + ca3))
    t9 = t1 - t2 - t3 - t4 - t5 - t6 - t7 - t8
    t10 = t1 + t7 - t2 - t3 - t4 - t5 - t6 - t8
    t11 = z - r2 * ca2 - r3 * (ca3 * ca2)
    t12 = sa3 * sa3
    t13 = t3 + t4 + t6 * t12
    t14 = sa3 * (r3 * (d4 * (-4 * ca3)))
    t15 = t3 + t3 + t12 * (t6 + t6) + t4 * (4 * (ca3 * ca3))

    # results
    U = np.empty((*_leading, 3), _real)
    V = np.empty((*_leading, 3), _real)
    W = np.empty((*_leading, 5), _real)
    U[..., 0] = t9
    U[..., 1] = r2 * (-4 * d4) * sa3
    U[..., 2] = t10
    V[..., 0] = t11
    V[..., 1] = sa3 * (d4 * (-2 * ca2))
    V[..., 2] = t11
    W[..., 0] = t7 + t13
    W[..., 1] = t14
    W[..., 2] = t15 - (t4 + t4)
    W[..., 3] = t14
    W[..., 4] = t13 - t7
    return U.reshape(_leading + (3,)), V.reshape(_leading + (3,)), W.reshape(_leading + (5,))


def sweep_elbow(parameters, elbow, target):
    """U and V, and f1 and f2, the point in the frame of joint 2, from cos(theta3), sin(theta3) and a target: 36 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    in   elbow[2] = (c3, s3)
    in   target[2] = (rho_squared, z)
    out  mismatch[2]
    out  point[2]
    """
    parameters = np.asarray(parameters)
    elbow = np.asarray(elbow)
    target = np.asarray(target)
    _leading = np.broadcast_shapes(parameters.shape[:-1], elbow.shape[:-1], target.shape[:-1])
    _real = np.result_type(parameters, elbow, target, np.float32)

    # inputs, sines and cosines
    rho_squared = target[..., 0]
    z = target[..., 1]
    d2 = parameters[..., 4]
    d3 = parameters[..., 5]
    d4 = parameters[..., 6]
    r2 = parameters[..., 7]
    r3 = parameters[..., 8]
    c3 = elbow[..., 0]
    s3 = elbow[..., 1]
    sa3 = parameters[..., 3]
    ca3 = parameters[..., 2]
    ca2 = parameters[..., 0]

    # terms
    t1 = rho_squared + z * z - d2 * d2 - d3 * d3 - d4 * d4
    t2 = t1 - r2 * r2 - r3 * r3 - (d4 + d4) * (d3 * c3 + r2 * s3 * sa3)
    t3 = z - ca2 * (r2 + r3 * ca3 + sa3 * (d4 * s3))

    # results
    mismatch = np.empty((*_leading, 2), _real)
    point = np.empty((*_leading, 2), _real)
    mismatch[..., 0] = t2 - r3 * (r2 * (ca3 + ca3))
    mismatch[..., 1] = t3
    point[..., 0] = d3 + d4 * c3
    point[..., 1] = s3 * (d4 * ca3) - r3 * sa3
    return mismatch.reshape(_leading + (2,)), point.reshape(_leading + (2,))


def sweep_base(parameters, elbow, turned):
    """x and y of the point at theta1 = 0, from A, B and cos(theta3), sin(theta3): 9 operations.

    in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
    in   elbow[2] = (c3, s3)
    in   turned[2] = (A, B)
    out  xy[2]
    """
    parameters = np.asarray(parameters)
    elbow = np.asarray(elbow)
    turned = np.asarray(turned)
    _leading = np.broadcast_shapes(parameters.shape[:-1], elbow.shape[:-1], turned.shape[:-1])
    _real = np.result_type(parameters, elbow, turned, np.float32)

    # inputs, sines and cosines
    A = turned[..., 0]
    d2 = parameters[..., 4]
    B = turned[..., 1]
    ca2 = parameters[..., 0]
    sa2 = parameters[..., 1]
    r2 = parameters[..., 7]
    ca3 = parameters[..., 2]
    r3 = parameters[..., 8]
    d4 = parameters[..., 6]
    s3 = elbow[..., 1]
    sa3 = parameters[..., 3]

    # terms
    t1 = B * ca2 - sa2 * (r2 + ca3 * r3 + d4 * s3 * sa3)

    # results
    xy = np.empty((*_leading, 2), _real)
    xy[..., 0] = A + d2
    xy[..., 1] = t1
    return xy.reshape(_leading + (2,))


def spherical_orientations(second, third, wanted):
    """angles a, b, c with Rz(a) second Rz(b) third Rz(c) = wanted, in two ways; real where |share| <= 1: 230 operations.

    in   second[3][3] = (second_11, second_12, second_13, second_21, second_22, second_23, second_31, second_32, second_33)
    in   third[3][3] = (third_11, third_12, third_13, third_21, third_22, third_23, third_31, third_32, third_33)
    in   wanted[3][3] = (wanted_11, wanted_12, wanted_13, wanted_21, wanted_22, wanted_23, wanted_31, wanted_32, wanted_33)
    out  angles[2][3]
    out  share[1]
    """
    second = np.asarray(second)
    second = second.reshape(second.shape[:-2] + (9,))
    third = np.asarray(third)
    third = third.reshape(third.shape[:-2] + (9,))
    wanted = np.asarray(wanted)
    wanted = wanted.reshape(wanted.shape[:-2] + (9,))
    _leading = np.broadcast_shapes(second.shape[:-1], third.shape[:-1], wanted.shape[:-1])
    _real = np.result_type(second, third, wanted, np.float32)

    # inputs, sines and cosines
    second_31 = second[..., 6]
    third_13 = third[..., 2]
    second_32 = second[..., 7]
    third_23 = third[..., 5]
    wanted_33 = wanted[..., 8]
    second_33 = second[..., 8]
    third_33 = third[..., 8]
    second_11 = second[..., 0]
    second_12 = second[..., 1]
    second_13 = second[..., 2]
    wanted_13 = wanted[..., 2]
    second_21 = second[..., 3]
    second_22 = second[..., 4]
    second_23 = second[..., 5]
    wanted_23 = wanted[..., 5]
    third_12 = third[..., 1]
    third_22 = third[..., 4]
    third_32 = third[..., 7]
    wanted_31 = wanted[..., 6]
    wanted_11 = wanted[..., 0]
    wanted_21 = wanted[..., 3]
    third_11 = third[..., 0]
    third_21 = third[..., 3]
    third_31 = third[..., 6]

    # terms
    t1 = second_31 * third_13 + second_32 * third_23
    t2 = third_13 * second_32 - second_31 * third_23
    t3 = np.sqrt((t1 * t1 + t2 * t2))
    t4 = np.where(t3 != 0.0, 1, 0.0)
    t5 = t4 / (t3 + (1 - t4))
    t6 = t5 * (wanted_33 - second_33 * third_33)
    t7 = np.maximum((-1), np.minimum(1, t6))
    t8 = t1 * t7
    t9 = np.sqrt(np.maximum(0.0, (1 + t7) * (1 - t7)))
    t10 = t2 * t9
    t11 = t5 * (t8 - t10)
    t12 = t2 * t7
    t13 = t1 * t9
    t14 = t5 * (t12 + t13)
    t15 = third_13 * t11 - third_23 * t14
    t16 = third_23 * t11 + third_13 * t14
    t17 = third_33 * second_13
    t18 = t15 * second_11 + t16 * second_12 + t17
    t19 = third_33 * second_23
    t20 = t15 * second_21 + t16 * second_22 + t19
    t21 = t18 * wanted_13 + t20 * wanted_23
    t22 = t18 * wanted_23 - wanted_13 * t20
    t23 = np.sqrt((t21 * t21 + t22 * t22))
    t24 = np.where(t23 != 0.0, 1, 0.0)
    t25 = t24 / (t23 + (1 - t24))
    t26 = t22 * t25
    t27 = 1 + t21 * t25 - t24
    t28 = t11 * third_12 - t14 * third_22
    t29 = t11 * third_22 + t14 * third_12
    t30 = second_33 * third_32
    t31 = second_13 * third_32
    t32 = second_11 * t28 + second_12 * t29 + t31
    t33 = second_23 * third_32
    t34 = second_21 * t28 + second_22 * t29 + t33
    t35 = (second_31 * t28 + second_32 * t29 + t30) * wanted_31 + wanted_11 * (t27 * t32 - t26 * t34)
    t36 = t11 * third_11 - t14 * third_21
    t37 = t11 * third_21 + t14 * third_11
    t38 = second_33 * third_31
    t39 = second_13 * third_31
    t40 = second_11 * t36 + second_12 * t37 + t39
    t41 = second_23 * third_31
    t42 = second_21 * t36 + second_22 * t37 + t41
    t43 = wanted_31 * (second_31 * t36 + second_32 * t37 + t38) + wanted_11 * (t27 * t40 - t26 * t42)
    t44 = np.arctan2((t35 + wanted_21 * (t27 * t34 + t26 * t32)), t43 + wanted_21 * (t27 * t42 + t26 * t40))
    t45 = t5 * (t8 + t10)
    t46 = t5 * (t12 - t13)
    t47 = third_23 * t45 + third_13 * t46
    t48 = third_13 * t45 - third_23 * t46
    t49 = t17 + (second_12 * t47 + second_11 * t48)
    t50 = t19 + (second_22 * t47 + second_21 * t48)
    t51 = wanted_13 * t49 + wanted_23 * t50
    t52 = wanted_23 * t49 - wanted_13 * t50
    t53 = np.sqrt((t51 * t51 + t52 * t52))
    t54 = np.where(t53 != 0.0, 1, 0.0)
    t55 = t54 / (t53 + (1 - t54))
    t56 = t52 * t55
    t57 = 1 + t51 * t55 - t54
    t58 = third_22 * t45 + third_12 * t46
    t59 = third_12 * t45 - third_22 * t46
    t60 = t31 + (second_12 * t58 + second_11 * t59)
    t61 = t33 + (second_22 * t58 + second_21 * t59)
    t62 = wanted_31 * (t30 + (second_32 * t58 + second_31 * t59)) + wanted_11 * (t57 * t60 - t56 * t61)
    t63 = third_11 * t45 - third_21 * t46
    t64 = third_21 * t45 + third_11 * t46
    t65 = t39 + (second_11 * t63 + second_12 * t64)
    t66 = t41 + (second_21 * t63 + second_22 * t64)
    t67 = wanted_31 * (t38 + (second_31 * t63 + second_32 * t64)) + wanted_11 * (t57 * t65 - t56 * t66)
    t68 = np.arctan2((t62 + wanted_21 * (t57 * t61 + t56 * t60)), t67 + wanted_21 * (t57 * t66 + t56 * t65))

    # results
    angles = np.empty((*_leading, 6), _real)
    share = np.empty((*_leading, 1), _real)
    angles[..., 0] = np.arctan2(t26, t27)
    angles[..., 1] = np.arctan2(t14, t11)
    angles[..., 2] = t44
    angles[..., 3] = np.arctan2(t56, t57)
    angles[..., 4] = np.arctan2(t46, t45)
    angles[..., 5] = t68
    share[..., 0] = t6
    return angles.reshape(_leading + (2, 3)), share.reshape(_leading + (1,))


def spherical_elbow(before, behind, square):
    """angles of a joint, in two ways, at which a point behind it is sqrt(square) from one before it: 57 operations.

    in   before[3] = (s1, s2, s3)
    in   behind[3] = (w1, w2, w3)
    in   square[1] = (distance_squared)
    out  angles[2]
    out  share[1]
    """
    before = np.asarray(before)
    behind = np.asarray(behind)
    square = np.asarray(square)
    _leading = np.broadcast_shapes(before.shape[:-1], behind.shape[:-1], square.shape[:-1])
    _real = np.result_type(before, behind, square, np.float32)

    # inputs, sines and cosines
    s1 = before[..., 0]
    w1 = behind[..., 0]
    s2 = before[..., 1]
    w2 = behind[..., 1]
    s3 = before[..., 2]
    w3 = behind[..., 2]
    distance_squared = square[..., 0]

    # terms
    t1 = s1 * w1 + s2 * w2
    t2 = w1 * s2 - s1 * w2
    t3 = np.sqrt((t1 * t1 + t2 * t2))
    t4 = np.where(t3 != 0.0, 1, 0.0)
    t5 = t4 / (t3 + (1 - t4))
    t6 = 0.5 * (s1 * s1) + 0.5 * (s2 * s2) + 0.5 * (s3 * s3)
    t7 = t6 + 0.5 * (w1 * w1) + 0.5 * (w2 * w2) + 0.5 * (w3 * w3)
    t8 = t5 * (t7 - 0.5 * distance_squared - s3 * w3)
    t9 = np.maximum((-1), np.minimum(1, t8))
    t10 = t2 * t9
    t11 = np.sqrt(np.maximum(0.0, (1 + t9) * (1 - t9)))
    t12 = t1 * t11
    t13 = t1 * t9
    t14 = t2 * t11

    # results
    angles = np.empty((*_leading, 2), _real)
    share = np.empty((*_leading, 1), _real)
    angles[..., 0] = np.arctan2((t5 * (t10 + t12)), t5 * (t13 - t14))
    angles[..., 1] = np.arctan2((t5 * (t10 - t12)), t5 * (t13 + t14))
    share[..., 0] = t8
    return angles.reshape(_leading + (2,)), share.reshape(_leading + (1,))
