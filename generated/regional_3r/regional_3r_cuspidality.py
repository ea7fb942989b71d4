"""cuspidality of regional_3r, in NumPy.

Made from templates/kernel.py.j2; inputs 78be43b1a0d511aa9824a6283190700902ab4b3144ab5bd4f7980d7fe4dc8de5.
6368 operations. Do not edit: change the derivation and regenerate.

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
    """how many postures reach a target; in double precision certainly so where the margin exceeds 1: 286 operations.

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
    t27 = t20 / t26
    t28 = t27 * t27
    t29 = t22 / t26
    t30 = t24 / t26
    t31 = t29 * t29 + t30 * t30
    t32 = t21 / t26
    t33 = t32 * t32
    t34 = t25 / t26
    t35 = t34 * t34
    t36 = t33 + t35
    t37 = np.where(t26 != 0.0, np.where(t26 != 0.0, t28 + 3 * t31, 0.0), 0.0) - np.where(t26 != 0.0, np.where(t26 != 0.0, 3 * t36, 0.0), 0.0)
    t38 = t37 * t37
    t39 = t29 * (np.where(t26 != 0.0, np.where(t26 != 0.0, t33, 0.0), 0.0) - np.where(t26 != 0.0, np.where(t26 != 0.0, t35, 0.0), 0.0)) + np.where(t26 != 0.0, np.where(t26 != 0.0, t34 * (t30 * (t32 + t32)), 0.0), 0.0)
    t40 = np.where(t26 != 0.0, np.where(t26 != 0.0, t28 + t28, 0.0), 0.0) - np.where(t26 != 0.0, np.where(t26 != 0.0, 18 * t31, 0.0), 0.0)
    t41 = 27 * t39 + t27 * (t40 - np.where(t26 != 0.0, np.where(t26 != 0.0, 9 * t36, 0.0), 0.0))
    t42 = 4 * t37 * t38 - np.where(t26 != 0.0, np.where(t26 != 0.0, t41 * t41, 0.0), 0.0)
    t43 = 0.5 + 0.5 * np.copysign(1, t42)
    t44 = np.maximum(d2, -d2)
    t45 = np.maximum(ca2, -ca2)
    t46 = t45 + t45
    t47 = t44 * t46
    t48 = np.maximum(r2, -r2)
    t49 = np.maximum(ca3, -ca3)
    t50 = np.maximum(r3, -r3)
    t51 = (t44 + t44) * np.maximum(z, -z) + t47 * t48 + t44 * (t46 * t49) * t50
    t52 = np.maximum(d4, -d4)
    t53 = np.maximum(sa3, -sa3)
    t54 = t51 + t47 * t52 * t53
    t55 = np.maximum(sa2, -sa2)
    t56 = t2 * t55 + t3 * t55 + t4 * t55 + t5 * t55
    t57 = t56 + t6 * t55 + t1 * t55 + t55 * np.maximum(rho_squared, -rho_squared)
    t58 = np.maximum(d3, -d3)
    t59 = t57 + t55 * (t52 * (t58 + t58)) + t55 * (t50 * (t48 * (t49 + t49)))
    t60 = t59 + t53 * (t55 * (t48 * (t52 + t52)))
    t61 = t49 * t52 + t50 * t53
    t62 = t52 + t58
    t63 = t54 * t54 + t60 * t60 + t17 * (t61 * t61 + t62 * t62)
    t64 = 3.552713678800501e-15 / t26 * t63
    t65 = -0.3333333333333333 * t37
    t66 = np.where(t26 != 0.0, np.where(t26 != 0.0, t31 + t36, 0.0), 0.0) - np.where(t26 != 0.0, np.where(t26 != 0.0, 0.5555555555555556 * t28, 0.0), 0.0)
    t67 = 1.3333333333333333 * t27
    t68 = t65 * t65 + 3 * (t66 * t66) + np.where(t26 != 0.0, np.where(t26 != 0.0, t65 * (t67 * t67), 0.0), 0.0)
    t69 = t68 + np.where(t26 != 0.0, np.where(t26 != 0.0, t67 * (0.1111111111111111 * t41), 0.0), 0.0) - t66 * (-1.3333333333333333 * t37)
    t70 = 0.016666666666666666 / np.where(t26 != 0.0, t64, 0.0) * np.minimum(t69, 3 * (3 * t66 - -0.6666666666666666 * t37))
    t71 = np.where(t26 != 0.0, t41, 0.0)
    t72 = 72 * t38 + 120 * np.maximum(t71, -t71) + np.where(t26 != 0.0, 5000 * t64, 0.0)
    t73 = np.maximum(t42, -t42) / np.where(t26 != 0.0, t64 * t72, 0.0)

    # results
    number = np.empty((*_leading, 1), _real)
    margin = np.empty((*_leading, 1), _real)
    number[..., 0] = 2 + t43 * np.copysign(2, t70)
    margin[..., 0] = np.minimum(t73, t73 * (1 - t43) + np.maximum(t70, -t70))
    return number.reshape(_leading), margin.reshape(_leading)


def postures(parameters, point):
    """two pairs of postures at a point, the room of each (real if positive), the distances left, the slopes of E: 2665 operations.

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
    ca2 = parameters[..., 0]
    sa3 = parameters[..., 3]

    # terms
    t1 = d2 + d2
    t2 = x * x + y * y
    t3 = z * z
    t4 = d2 * d2
    t5 = d3 * d3
    t6 = d4 * d4
    t7 = r2 * r2
    t8 = r3 * r3
    t9 = t2 + t3 - t4 - t5 - t6 - t7 - t8 - r3 * (r2 * (ca3 + ca3))
    t10 = t9 * sa2
    t11 = z - r2 * ca2 - r3 * (ca3 * ca2)
    t12 = t1 * t11
    t13 = d4 * (-2 * d3)
    t14 = sa2 * t13
    t15 = 0.5 * (t14 * t14)
    t16 = r2 * (-2 * d4)
    t17 = sa2 * t16 * sa3
    t18 = 0.5 * (t17 * t17)
    t19 = sa3 * (d4 * (d2 * (-2 * ca2)))
    t20 = 0.5 * (t19 * t19)
    t21 = ca3 * ca3
    t22 = 4 * t4 * (sa2 * sa2)
    t23 = t10 * t10 + t12 * t12 + t15 + t18 + t20 - (t5 + t6 * t21 + t8 * (sa3 * sa3)) * t22
    t24 = t22 * (0.5 * (t6 * (1 - t21)))
    t25 = t23 - t24
    t26 = t10 * t14 - t22 * (0.5 * (d4 * (d3 + d3)))
    t27 = t15 - t18 - t20 - t24
    t28 = np.maximum(t25, -t25) + np.maximum(t26, -t26) + np.maximum(t27, -t27)
    t29 = t14 * t17
    t30 = t10 * t17 + t12 * t19 - t22 * (0.5 * (sa3 * (r3 * (d4 * (-2 * ca3)))))
    t31 = t28 + np.maximum(t29, -t29) + np.maximum(t30, -t30)
    t32 = t27 / t31
    t33 = np.where(t31 != 0.0, t32, 0.0)
    t34 = t33 + np.copysign(1e-17, t33)
    t35 = t29 / t31
    t36 = t35 * t35
    t37 = np.sqrt((t34 * t34 + np.where(t31 != 0.0, np.where(t31 != 0.0, t36, 0.0), 0.0)))
    t38 = 0.5 / t37
    t39 = t37 + t37
    t40 = t26 / t31
    t41 = 0.5 + 0.5 * np.copysign(1, t34)
    t42 = 0.7071067811865476 * np.sqrt(((t37 + np.maximum(t34, -t34)) / t37))
    t43 = 0.5 * t35 / t42 / t37
    t44 = 1 - t41
    t45 = t41 * t42 + np.where(t31 != 0.0, t43 * t44, 0.0)
    t46 = t30 / t31
    t47 = np.where(t31 != 0.0, t41 * t43, 0.0) + t42 * t44
    t48 = t40 * t45 + t46 * t47
    t49 = np.where(t31 != 0.0, t45 * t46, 0.0) - np.where(t31 != 0.0, t40 * t47, 0.0)
    t50 = t25 / t31
    t51 = np.where(t31 != 0.0, np.where(t31 != 0.0, t48 * t48, 0.0), 0.0) - t49 * t49 - np.where(t31 != 0.0, t37 * t50, 0.0)
    t52 = 0.5 + 0.5 * np.copysign(1, t51)
    t53 = 1 - t52
    t54 = np.where(t31 != 0.0, t48 * t52, 0.0) - t49 * t53
    t55 = t49 * t52 - np.where(t31 != 0.0, t48 * t53, 0.0)
    t56 = t55 * t55
    t57 = t54 * t54
    t58 = np.where(t31 != 0.0, t50 * (t52 + t52 - 1), 0.0)
    t59 = t56 + t57 - t39 * (t58 - t37)
    t60 = t58 - 3 * t37
    t61 = t37 * (t59 + t37 * (t37 + t60))
    t62 = t37 * (t56 + t56)
    t63 = np.minimum(t37, np.where(t61 != 0.0, t37 * t62 / t61, 0.0))
    t64 = t60 + t60
    t65 = t59 + t63 * (t64 + 3 * t63)
    t66 = t63 * (t59 + t63 * (t60 + t63)) - t62
    t67 = t63 - np.where(t65 != 0.0, t66 / t65, 0.0)
    t68 = 0.5 + 0.5 * np.copysign(1, t66)
    t69 = 1 - t68
    t70 = t63 * t68 + t37 * t69
    t71 = t63 * t69
    t72 = t67 - np.minimum(t70, np.maximum(t67, t71))
    t73 = t67 * (1 - np.where(t72 != 0.0, 1, 0.0)) + np.where(t72 != 0.0, 0.5 * t70 + 0.5 * t71, 0.0)
    t74 = t59 + t73 * (t64 + 3 * t73)
    t75 = t73 * (t59 + t73 * (t60 + t73)) - t62
    t76 = t73 - np.where(t74 != 0.0, t75 / t74, 0.0)
    t77 = 0.5 + 0.5 * np.copysign(1, t75)
    t78 = 1 - t77
    t79 = t73 * t77 + t70 * t78
    t80 = t71 * t77 + t73 * t78
    t81 = t76 - np.minimum(t79, np.maximum(t76, t80))
    t82 = t76 * (1 - np.where(t81 != 0.0, 1, 0.0)) + np.where(t81 != 0.0, 0.5 * t79 + 0.5 * t80, 0.0)
    t83 = t59 + t82 * (t64 + 3 * t82)
    t84 = t82 * (t59 + t82 * (t60 + t82)) - t62
    t85 = t82 - np.where(t83 != 0.0, t84 / t83, 0.0)
    t86 = 0.5 + 0.5 * np.copysign(1, t84)
    t87 = 1 - t86
    t88 = t82 * t86 + t79 * t87
    t89 = t80 * t86 + t82 * t87
    t90 = t85 - np.minimum(t88, np.maximum(t85, t89))
    t91 = t85 * (1 - np.where(t90 != 0.0, 1, 0.0)) + np.where(t90 != 0.0, 0.5 * t88 + 0.5 * t89, 0.0)
    t92 = t59 + t91 * (t64 + 3 * t91)
    t93 = t91 * (t59 + t91 * (t60 + t91)) - t62
    t94 = t91 - np.where(t92 != 0.0, t93 / t92, 0.0)
    t95 = 0.5 + 0.5 * np.copysign(1, t93)
    t96 = 1 - t95
    t97 = t91 * t95 + t88 * t96
    t98 = t89 * t95 + t91 * t96
    t99 = t94 - np.minimum(t97, np.maximum(t94, t98))
    t100 = t94 * (1 - np.where(t99 != 0.0, 1, 0.0)) + np.where(t99 != 0.0, 0.5 * t97 + 0.5 * t98, 0.0)
    t101 = t59 + t100 * (t64 + 3 * t100)
    t102 = t100 * (t59 + t100 * (t60 + t100)) - t62
    t103 = t100 - np.where(t101 != 0.0, t102 / t101, 0.0)
    t104 = 0.5 + 0.5 * np.copysign(1, t102)
    t105 = 1 - t104
    t106 = t100 * t104 + t97 * t105
    t107 = t98 * t104 + t100 * t105
    t108 = t103 - np.minimum(t106, np.maximum(t103, t107))
    t109 = t103 * (1 - np.where(t108 != 0.0, 1, 0.0)) + np.where(t108 != 0.0, 0.5 * t106 + 0.5 * t107, 0.0)
    t110 = t59 + t109 * (t64 + 3 * t109)
    t111 = t109 * (t59 + t109 * (t60 + t109)) - t62
    t112 = t109 - np.where(t110 != 0.0, t111 / t110, 0.0)
    t113 = 0.5 + 0.5 * np.copysign(1, t111)
    t114 = 1 - t113
    t115 = t109 * t113 + t106 * t114
    t116 = t107 * t113 + t109 * t114
    t117 = t112 - np.minimum(t115, np.maximum(t112, t116))
    t118 = t112 * (1 - np.where(t117 != 0.0, 1, 0.0)) + np.where(t117 != 0.0, 0.5 * t115 + 0.5 * t116, 0.0)
    t119 = t59 + t118 * (t64 + 3 * t118)
    t120 = t118 * (t59 + t118 * (t60 + t118)) - t62
    t121 = t118 - np.where(t119 != 0.0, t120 / t119, 0.0)
    t122 = 0.5 + 0.5 * np.copysign(1, t120)
    t123 = 1 - t122
    t124 = t118 * t122 + t115 * t123
    t125 = t116 * t122 + t118 * t123
    t126 = t121 - np.minimum(t124, np.maximum(t121, t125))
    t127 = t121 * (1 - np.where(t126 != 0.0, 1, 0.0)) + np.where(t126 != 0.0, 0.5 * t124 + 0.5 * t125, 0.0)
    t128 = t59 + t127 * (t64 + 3 * t127)
    t129 = t127 * (t59 + t127 * (t60 + t127)) - t62
    t130 = t127 - np.where(t128 != 0.0, t129 / t128, 0.0)
    t131 = 0.5 + 0.5 * np.copysign(1, t129)
    t132 = 1 - t131
    t133 = t127 * t131 + t124 * t132
    t134 = t125 * t131 + t127 * t132
    t135 = t130 - np.minimum(t133, np.maximum(t130, t134))
    t136 = t130 * (1 - np.where(t135 != 0.0, 1, 0.0)) + np.where(t135 != 0.0, 0.5 * t133 + 0.5 * t134, 0.0)
    t137 = t59 + t136 * (t64 + 3 * t136)
    t138 = t136 * (t59 + t136 * (t60 + t136)) - t62
    t139 = t136 - np.where(t137 != 0.0, t138 / t137, 0.0)
    t140 = 0.5 + 0.5 * np.copysign(1, t138)
    t141 = 1 - t140
    t142 = t136 * t140 + t133 * t141
    t143 = t134 * t140 + t136 * t141
    t144 = t139 - np.minimum(t142, np.maximum(t139, t143))
    t145 = t139 * (1 - np.where(t144 != 0.0, 1, 0.0)) + np.where(t144 != 0.0, 0.5 * t142 + 0.5 * t143, 0.0)
    t146 = t59 + t145 * (t64 + 3 * t145)
    t147 = t145 * (t59 + t145 * (t60 + t145)) - t62
    t148 = t145 - np.where(t146 != 0.0, t147 / t146, 0.0)
    t149 = 0.5 + 0.5 * np.copysign(1, t147)
    t150 = 1 - t149
    t151 = t145 * t149 + t142 * t150
    t152 = t143 * t149 + t145 * t150
    t153 = t148 - np.minimum(t151, np.maximum(t148, t152))
    t154 = t148 * (1 - np.where(t153 != 0.0, 1, 0.0)) + np.where(t153 != 0.0, 0.5 * t151 + 0.5 * t152, 0.0)
    t155 = t59 + t154 * (t64 + 3 * t154)
    t156 = t154 * (t59 + t154 * (t60 + t154)) - t62
    t157 = t154 - np.where(t155 != 0.0, t156 / t155, 0.0)
    t158 = 0.5 + 0.5 * np.copysign(1, t156)
    t159 = 1 - t158
    t160 = t154 * t158 + t151 * t159
    t161 = t152 * t158 + t154 * t159
    t162 = t157 - np.minimum(t160, np.maximum(t157, t161))
    t163 = t157 * (1 - np.where(t162 != 0.0, 1, 0.0)) + np.where(t162 != 0.0, 0.5 * t160 + 0.5 * t161, 0.0)
    t164 = t59 + t163 * (t64 + 3 * t163)
    t165 = t163 * (t59 + t163 * (t60 + t163)) - t62
    t166 = t163 - np.where(t164 != 0.0, t165 / t164, 0.0)
    t167 = 0.5 + 0.5 * np.copysign(1, t165)
    t168 = 1 - t167
    t169 = t163 * t167 + t160 * t168
    t170 = t161 * t167 + t163 * t168
    t171 = t166 - np.minimum(t169, np.maximum(t166, t170))
    t172 = t166 * (1 - np.where(t171 != 0.0, 1, 0.0)) + np.where(t171 != 0.0, 0.5 * t169 + 0.5 * t170, 0.0)
    t173 = t39 - t172
    t174 = np.sqrt(t173)
    t175 = t54 / t174
    t176 = 0.5 + 0.5 * np.copysign(1, t172 - 1e-25)
    t177 = np.copysign(np.sqrt(np.maximum(0.0, t37 + t57 / t173 - t58 - t172)), t55)
    t178 = np.sqrt(t172)
    t179 = (1 - t176) * t177 + np.where(t178 != 0.0, t55 * t176 / t178, 0.0)
    t180 = t175 + t179
    t181 = t39 - t180 * t180
    t182 = np.sqrt(np.maximum(0.0, t181))
    t183 = t178 * t182
    t184 = t174 * t180
    t185 = t38 * (t183 - t184)
    t186 = t178 * t180
    t187 = t174 * t182
    t188 = t38 * (t186 + t187)
    t189 = t52 * t185 + t53 * t188
    t190 = t53 * t185 + t52 * t188
    t191 = t45 * t189 - t47 * t190
    t192 = t47 * t189 + t45 * t190
    t193 = t191 + t192
    t194 = t191 - t192
    t195 = np.where(t31 != 0.0, t46 * t191 + t35 * t193 * t194, 0.0) - np.where(t31 != 0.0, t40 * t192, 0.0)
    t196 = t191 + t191
    t197 = t195 - np.where(t31 != 0.0, t192 * (t32 * t196), 0.0)
    t198 = t197 * t197
    t199 = t40 + t40
    t200 = t46 + t46
    t201 = t50 + t191 * t199 + t192 * t200 + t194 * (t32 * t193)
    t202 = t197 / (2e-18 + (t198 + t198)) * (t201 + t192 * (t35 * t196))
    t203 = np.maximum((-0.001), np.minimum(0.001, -np.where(t31 != 0.0, t202, 0.0)))
    t204 = t191 - t192 * t203
    t205 = t192 + t191 * t203
    t206 = np.sqrt((t204 * t204 + t205 * t205))
    t207 = t204 / t206
    t208 = np.where(t206 != 0.0, t207, 0.0)
    t209 = t205 / t206
    t210 = t207 + t209
    t211 = t208 - np.where(t206 != 0.0, t209, 0.0)
    t212 = np.where(t31 != 0.0, np.where(t206 != 0.0, t46 * t207, 0.0), 0.0) + np.where(t206 != 0.0, np.where(t31 != 0.0, t35 * t210 * t211, 0.0), 0.0)
    t213 = t207 + t207
    t214 = t212 - np.where(t206 != 0.0, np.where(t31 != 0.0, t40 * t209, 0.0), 0.0) - np.where(t206 != 0.0, np.where(t31 != 0.0, np.where(t206 != 0.0, t209 * (t32 * t213), 0.0), 0.0), 0.0)
    t215 = t214 * t214
    t216 = np.where(t31 != 0.0, t50, 0.0)
    t217 = t216 + np.where(t206 != 0.0, np.where(t31 != 0.0, t199 * t207, 0.0), 0.0) + np.where(t206 != 0.0, np.where(t31 != 0.0, t200 * t209, 0.0), 0.0)
    t218 = t217 + np.where(t206 != 0.0, np.where(t31 != 0.0, t211 * (t32 * t210), 0.0), 0.0) + np.where(t206 != 0.0, np.where(t31 != 0.0, np.where(t206 != 0.0, t209 * (t35 * t213), 0.0), 0.0), 0.0)
    t219 = np.maximum((-0.001), np.minimum(0.001, -(t214 / (2e-18 + (t215 + t215)) * t218)))
    t220 = t208 - np.where(t206 != 0.0, t209 * t219, 0.0)
    t221 = t209 + t207 * t219
    t222 = np.sqrt((t220 * t220 + np.where(t206 != 0.0, np.where(t206 != 0.0, t221 * t221, 0.0), 0.0)))
    t223 = t220 / t222
    t224 = t16 * sa3
    t225 = t221 / t222
    t226 = t9 + np.where(t222 != 0.0, t13 * t223, 0.0) + np.where(t206 != 0.0, np.where(t222 != 0.0, t224 * t225, 0.0), 0.0)
    t227 = t226 / t1
    t228 = d3 + np.where(t222 != 0.0, d4 * t223, 0.0)
    t229 = sa3 * (d4 * ca2)
    t230 = (t11 + np.where(t206 != 0.0, np.where(t222 != 0.0, -(t225 * t229), 0.0), 0.0)) / sa2
    t231 = d4 * ca3
    t232 = r3 * sa3
    t233 = np.where(t206 != 0.0, np.where(t222 != 0.0, t225 * t231, 0.0), 0.0) - t232
    t234 = np.where(t1 != 0.0, t227 * t228, 0.0) + np.where(sa2 != 0.0, t230 * t233, 0.0)
    t235 = np.where(sa2 != 0.0, t228 * t230, 0.0) - np.where(t1 != 0.0, t227 * t233, 0.0)
    t236 = np.sqrt((t234 * t234 + t235 * t235))
    t237 = t234 / t236
    t238 = t235 / t236
    t239 = d2 + (np.where(t236 != 0.0, t228 * t237, 0.0) - np.where(t236 != 0.0, t233 * t238, 0.0))
    t240 = t233 * t237 + t228 * t238
    t241 = r3 * ca3
    t242 = r2 + (t241 + np.where(t206 != 0.0, np.where(t222 != 0.0, sa3 * (d4 * t225), 0.0), 0.0))
    t243 = np.where(t236 != 0.0, ca2 * t240, 0.0) - sa2 * t242
    t244 = x * t239 + y * t243
    t245 = y * t239 - x * t243
    t246 = -t244
    t247 = np.maximum(t244, t246)
    t248 = np.maximum(t245, -t245)
    t249 = np.sqrt((t244 * t244 + t245 * t245)) + np.maximum(t247, t248)
    t250 = np.minimum(t247, t248) / t249
    t251 = t250 / (1 + np.sqrt((1 + np.where(t249 != 0.0, np.where(t249 != 0.0, t250 * t250, 0.0), 0.0))))
    t252 = t251 * t251
    t253 = np.where(t249 != 0.0, np.where(t249 != 0.0, t252 * (np.where(t249 != 0.0, np.where(t249 != 0.0, 0.047619047619047616 * t252, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t254 = np.where(t249 != 0.0, t252 * (np.where(t249 != 0.0, np.where(t249 != 0.0, t252 * (0.058823529411764705 + t253), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t255 = t252 * (np.where(t249 != 0.0, np.where(t249 != 0.0, t252 * (0.07692307692307693 + np.where(t249 != 0.0, t254, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t256 = np.where(t249 != 0.0, np.where(t249 != 0.0, t252 * (0.1111111111111111 + np.where(t249 != 0.0, np.where(t249 != 0.0, t255, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t257 = np.where(t249 != 0.0, np.where(t249 != 0.0, t252 * (0.2 + np.where(t249 != 0.0, np.where(t249 != 0.0, t252 * t256, 0.0), 0.0)), 0.0), 0.0)
    t258 = 4 * t251 * (1 + np.where(t249 != 0.0, np.where(t249 != 0.0, t252 * (t257 - 0.3333333333333333), 0.0), 0.0))
    t259 = 0.5 * np.copysign(1, t248 - t247)
    t260 = np.where(t249 != 0.0, t258 * (0.5 - t259), 0.0) + (0.5 + t259) * (1.5707963267948966 - np.where(t249 != 0.0, t258, 0.0))
    t261 = 0.5 * np.copysign(1, t246)
    t262 = np.copysign((t260 * (0.5 - t261) + (0.5 + t261) * (3.141592653589793 - t260)), t245)
    t263 = np.where(t236 != 0.0, t237, 0.0)
    t264 = -t263
    t265 = np.maximum(t263, t264)
    t266 = np.where(t236 != 0.0, t238, 0.0)
    t267 = np.maximum(t266, -t266)
    t268 = 1 + np.maximum(t265, t267)
    t269 = np.minimum(t265, t267) / t268
    t270 = t269 / (1 + np.sqrt((1 + np.where(t268 != 0.0, np.where(t268 != 0.0, t269 * t269, 0.0), 0.0))))
    t271 = t270 * t270
    t272 = np.where(t268 != 0.0, np.where(t268 != 0.0, t271 * (np.where(t268 != 0.0, np.where(t268 != 0.0, 0.047619047619047616 * t271, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t273 = np.where(t268 != 0.0, t271 * (np.where(t268 != 0.0, np.where(t268 != 0.0, t271 * (0.058823529411764705 + t272), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t274 = t271 * (np.where(t268 != 0.0, np.where(t268 != 0.0, t271 * (0.07692307692307693 + np.where(t268 != 0.0, t273, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t275 = np.where(t268 != 0.0, np.where(t268 != 0.0, t271 * (0.1111111111111111 + np.where(t268 != 0.0, np.where(t268 != 0.0, t274, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t276 = np.where(t268 != 0.0, np.where(t268 != 0.0, t271 * (0.2 + np.where(t268 != 0.0, np.where(t268 != 0.0, t271 * t275, 0.0), 0.0)), 0.0), 0.0)
    t277 = 4 * t270 * (1 + np.where(t268 != 0.0, np.where(t268 != 0.0, t271 * (t276 - 0.3333333333333333), 0.0), 0.0))
    t278 = 0.5 * np.copysign(1, t267 - t265)
    t279 = np.where(t268 != 0.0, t277 * (0.5 - t278), 0.0) + (0.5 + t278) * (1.5707963267948966 - np.where(t268 != 0.0, t277, 0.0))
    t280 = 0.5 * np.copysign(1, t264)
    t281 = np.copysign((t279 * (0.5 - t280) + (0.5 + t280) * (3.141592653589793 - t279)), t266)
    t282 = np.where(t222 != 0.0, t223, 0.0)
    t283 = -t282
    t284 = np.maximum(t282, t283)
    t285 = np.where(t206 != 0.0, np.where(t222 != 0.0, t225, 0.0), 0.0)
    t286 = np.maximum(t285, -t285)
    t287 = 1 + np.maximum(t284, t286)
    t288 = np.minimum(t284, t286) / t287
    t289 = t288 / (1 + np.sqrt((1 + np.where(t287 != 0.0, np.where(t287 != 0.0, t288 * t288, 0.0), 0.0))))
    t290 = t289 * t289
    t291 = np.where(t287 != 0.0, np.where(t287 != 0.0, t290 * (np.where(t287 != 0.0, np.where(t287 != 0.0, 0.047619047619047616 * t290, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t292 = np.where(t287 != 0.0, t290 * (np.where(t287 != 0.0, np.where(t287 != 0.0, t290 * (0.058823529411764705 + t291), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t293 = t290 * (np.where(t287 != 0.0, np.where(t287 != 0.0, t290 * (0.07692307692307693 + np.where(t287 != 0.0, t292, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t294 = np.where(t287 != 0.0, np.where(t287 != 0.0, t290 * (0.1111111111111111 + np.where(t287 != 0.0, np.where(t287 != 0.0, t293, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t295 = np.where(t287 != 0.0, np.where(t287 != 0.0, t290 * (0.2 + np.where(t287 != 0.0, np.where(t287 != 0.0, t290 * t294, 0.0), 0.0)), 0.0), 0.0)
    t296 = 4 * t289 * (1 + np.where(t287 != 0.0, np.where(t287 != 0.0, t290 * (t295 - 0.3333333333333333), 0.0), 0.0))
    t297 = 0.5 * np.copysign(1, t286 - t284)
    t298 = np.where(t287 != 0.0, t296 * (0.5 - t297), 0.0) + (0.5 + t297) * (1.5707963267948966 - np.where(t287 != 0.0, t296, 0.0))
    t299 = 0.5 * np.copysign(1, t283)
    t300 = np.copysign((t298 * (0.5 - t299) + (0.5 + t299) * (3.141592653589793 - t298)), t285)
    t301 = t38 * (t186 - t187)
    t302 = t38 * (t183 + t184)
    t303 = t53 * t301 - t52 * t302
    t304 = t52 * t301 - t53 * t302
    t305 = t45 * t303 - t47 * t304
    t306 = t47 * t303 + t45 * t304
    t307 = t305 + t306
    t308 = t305 - t306
    t309 = np.where(t31 != 0.0, t46 * t305 + t35 * t307 * t308, 0.0) - np.where(t31 != 0.0, t40 * t306, 0.0)
    t310 = t305 + t305
    t311 = t309 - np.where(t31 != 0.0, t306 * (t32 * t310), 0.0)
    t312 = t311 * t311
    t313 = t50 + t199 * t305 + t200 * t306 + t308 * (t32 * t307)
    t314 = t311 / (2e-18 + (t312 + t312)) * (t313 + t306 * (t35 * t310))
    t315 = np.maximum((-0.001), np.minimum(0.001, -np.where(t31 != 0.0, t314, 0.0)))
    t316 = t305 - t306 * t315
    t317 = t306 + t305 * t315
    t318 = np.sqrt((t316 * t316 + t317 * t317))
    t319 = t316 / t318
    t320 = np.where(t318 != 0.0, t319, 0.0)
    t321 = t317 / t318
    t322 = t319 + t321
    t323 = t320 - np.where(t318 != 0.0, t321, 0.0)
    t324 = np.where(t31 != 0.0, np.where(t318 != 0.0, t46 * t319, 0.0), 0.0) + np.where(t318 != 0.0, np.where(t31 != 0.0, t35 * t322 * t323, 0.0), 0.0)
    t325 = t319 + t319
    t326 = t324 - np.where(t318 != 0.0, np.where(t31 != 0.0, t40 * t321, 0.0), 0.0) - np.where(t318 != 0.0, np.where(t31 != 0.0, np.where(t318 != 0.0, t321 * (t32 * t325), 0.0), 0.0), 0.0)
    t327 = t326 * t326
    t328 = t216 + np.where(t318 != 0.0, np.where(t31 != 0.0, t199 * t319, 0.0), 0.0) + np.where(t318 != 0.0, np.where(t31 != 0.0, t200 * t321, 0.0), 0.0)
    t329 = t328 + np.where(t318 != 0.0, np.where(t31 != 0.0, t323 * (t32 * t322), 0.0), 0.0) + np.where(t318 != 0.0, np.where(t31 != 0.0, np.where(t318 != 0.0, t321 * (t35 * t325), 0.0), 0.0), 0.0)
    t330 = np.maximum((-0.001), np.minimum(0.001, -(t326 / (2e-18 + (t327 + t327)) * t329)))
    t331 = t320 - np.where(t318 != 0.0, t321 * t330, 0.0)
    t332 = t321 + t319 * t330
    t333 = np.sqrt((t331 * t331 + np.where(t318 != 0.0, np.where(t318 != 0.0, t332 * t332, 0.0), 0.0)))
    t334 = t331 / t333
    t335 = t332 / t333
    t336 = t9 + np.where(t333 != 0.0, t13 * t334, 0.0) + np.where(t318 != 0.0, np.where(t333 != 0.0, t224 * t335, 0.0), 0.0)
    t337 = t336 / t1
    t338 = d3 + np.where(t333 != 0.0, d4 * t334, 0.0)
    t339 = (t11 + np.where(t318 != 0.0, np.where(t333 != 0.0, -(t229 * t335), 0.0), 0.0)) / sa2
    t340 = np.where(t318 != 0.0, np.where(t333 != 0.0, t231 * t335, 0.0), 0.0) - t232
    t341 = np.where(t1 != 0.0, t337 * t338, 0.0) + np.where(sa2 != 0.0, t339 * t340, 0.0)
    t342 = np.where(sa2 != 0.0, t338 * t339, 0.0) - np.where(t1 != 0.0, t337 * t340, 0.0)
    t343 = np.sqrt((t341 * t341 + t342 * t342))
    t344 = t341 / t343
    t345 = t342 / t343
    t346 = d2 + (np.where(t343 != 0.0, t338 * t344, 0.0) - np.where(t343 != 0.0, t340 * t345, 0.0))
    t347 = t340 * t344 + t338 * t345
    t348 = r2 + (t241 + np.where(t318 != 0.0, np.where(t333 != 0.0, sa3 * (d4 * t335), 0.0), 0.0))
    t349 = np.where(t343 != 0.0, ca2 * t347, 0.0) - sa2 * t348
    t350 = x * t346 + y * t349
    t351 = y * t346 - x * t349
    t352 = -t350
    t353 = np.maximum(t350, t352)
    t354 = np.maximum(t351, -t351)
    t355 = np.sqrt((t350 * t350 + t351 * t351)) + np.maximum(t353, t354)
    t356 = np.minimum(t353, t354) / t355
    t357 = t356 / (1 + np.sqrt((1 + np.where(t355 != 0.0, np.where(t355 != 0.0, t356 * t356, 0.0), 0.0))))
    t358 = t357 * t357
    t359 = np.where(t355 != 0.0, np.where(t355 != 0.0, t358 * (np.where(t355 != 0.0, np.where(t355 != 0.0, 0.047619047619047616 * t358, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t360 = np.where(t355 != 0.0, t358 * (np.where(t355 != 0.0, np.where(t355 != 0.0, t358 * (0.058823529411764705 + t359), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t361 = t358 * (np.where(t355 != 0.0, np.where(t355 != 0.0, t358 * (0.07692307692307693 + np.where(t355 != 0.0, t360, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t362 = np.where(t355 != 0.0, np.where(t355 != 0.0, t358 * (0.1111111111111111 + np.where(t355 != 0.0, np.where(t355 != 0.0, t361, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t363 = np.where(t355 != 0.0, np.where(t355 != 0.0, t358 * (0.2 + np.where(t355 != 0.0, np.where(t355 != 0.0, t358 * t362, 0.0), 0.0)), 0.0), 0.0)
    t364 = 4 * t357 * (1 + np.where(t355 != 0.0, np.where(t355 != 0.0, t358 * (t363 - 0.3333333333333333), 0.0), 0.0))
    t365 = 0.5 * np.copysign(1, t354 - t353)
    t366 = np.where(t355 != 0.0, t364 * (0.5 - t365), 0.0) + (0.5 + t365) * (1.5707963267948966 - np.where(t355 != 0.0, t364, 0.0))
    t367 = 0.5 * np.copysign(1, t352)
    t368 = np.copysign((t366 * (0.5 - t367) + (0.5 + t367) * (3.141592653589793 - t366)), t351)
    t369 = np.where(t343 != 0.0, t344, 0.0)
    t370 = -t369
    t371 = np.maximum(t369, t370)
    t372 = np.where(t343 != 0.0, t345, 0.0)
    t373 = np.maximum(t372, -t372)
    t374 = 1 + np.maximum(t371, t373)
    t375 = np.minimum(t371, t373) / t374
    t376 = t375 / (1 + np.sqrt((1 + np.where(t374 != 0.0, np.where(t374 != 0.0, t375 * t375, 0.0), 0.0))))
    t377 = t376 * t376
    t378 = np.where(t374 != 0.0, np.where(t374 != 0.0, t377 * (np.where(t374 != 0.0, np.where(t374 != 0.0, 0.047619047619047616 * t377, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t379 = np.where(t374 != 0.0, t377 * (np.where(t374 != 0.0, np.where(t374 != 0.0, t377 * (0.058823529411764705 + t378), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t380 = t377 * (np.where(t374 != 0.0, np.where(t374 != 0.0, t377 * (0.07692307692307693 + np.where(t374 != 0.0, t379, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t381 = np.where(t374 != 0.0, np.where(t374 != 0.0, t377 * (0.1111111111111111 + np.where(t374 != 0.0, np.where(t374 != 0.0, t380, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t382 = np.where(t374 != 0.0, np.where(t374 != 0.0, t377 * (0.2 + np.where(t374 != 0.0, np.where(t374 != 0.0, t377 * t381, 0.0), 0.0)), 0.0), 0.0)
    t383 = 4 * t376 * (1 + np.where(t374 != 0.0, np.where(t374 != 0.0, t377 * (t382 - 0.3333333333333333), 0.0), 0.0))
    t384 = 0.5 * np.copysign(1, t373 - t371)
    t385 = np.where(t374 != 0.0, t383 * (0.5 - t384), 0.0) + (0.5 + t384) * (1.5707963267948966 - np.where(t374 != 0.0, t383, 0.0))
    t386 = 0.5 * np.copysign(1, t370)
    t387 = np.copysign((t385 * (0.5 - t386) + (0.5 + t386) * (3.141592653589793 - t385)), t372)
    t388 = np.where(t333 != 0.0, t334, 0.0)
    t389 = -t388
    t390 = np.maximum(t388, t389)
    t391 = np.where(t318 != 0.0, np.where(t333 != 0.0, t335, 0.0), 0.0)
    t392 = np.maximum(t391, -t391)
    t393 = 1 + np.maximum(t390, t392)
    t394 = np.minimum(t390, t392) / t393
    t395 = t394 / (1 + np.sqrt((1 + np.where(t393 != 0.0, np.where(t393 != 0.0, t394 * t394, 0.0), 0.0))))
    t396 = t395 * t395
    t397 = np.where(t393 != 0.0, np.where(t393 != 0.0, t396 * (np.where(t393 != 0.0, np.where(t393 != 0.0, 0.047619047619047616 * t396, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t398 = np.where(t393 != 0.0, t396 * (np.where(t393 != 0.0, np.where(t393 != 0.0, t396 * (0.058823529411764705 + t397), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t399 = t396 * (np.where(t393 != 0.0, np.where(t393 != 0.0, t396 * (0.07692307692307693 + np.where(t393 != 0.0, t398, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t400 = np.where(t393 != 0.0, np.where(t393 != 0.0, t396 * (0.1111111111111111 + np.where(t393 != 0.0, np.where(t393 != 0.0, t399, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t401 = np.where(t393 != 0.0, np.where(t393 != 0.0, t396 * (0.2 + np.where(t393 != 0.0, np.where(t393 != 0.0, t396 * t400, 0.0), 0.0)), 0.0), 0.0)
    t402 = 4 * t395 * (1 + np.where(t393 != 0.0, np.where(t393 != 0.0, t396 * (t401 - 0.3333333333333333), 0.0), 0.0))
    t403 = 0.5 * np.copysign(1, t392 - t390)
    t404 = np.where(t393 != 0.0, t402 * (0.5 - t403), 0.0) + (0.5 + t403) * (1.5707963267948966 - np.where(t393 != 0.0, t402, 0.0))
    t405 = 0.5 * np.copysign(1, t389)
    t406 = np.copysign((t404 * (0.5 - t405) + (0.5 + t405) * (3.141592653589793 - t404)), t391)
    t407 = t175 - t179
    t408 = t39 - t407 * t407
    t409 = np.sqrt(np.maximum(0.0, t408))
    t410 = t174 * t409
    t411 = t178 * t407
    t412 = t38 * (t410 - t411)
    t413 = t174 * t407
    t414 = t178 * t409
    t415 = t38 * (t413 + t414)
    t416 = t53 * t412 - t52 * t415
    t417 = t52 * t412 - t53 * t415
    t418 = t45 * t416 - t47 * t417
    t419 = t47 * t416 + t45 * t417
    t420 = t418 + t419
    t421 = t418 - t419
    t422 = np.where(t31 != 0.0, t46 * t418 + t35 * t420 * t421, 0.0) - np.where(t31 != 0.0, t40 * t419, 0.0)
    t423 = t418 + t418
    t424 = t422 - np.where(t31 != 0.0, t419 * (t32 * t423), 0.0)
    t425 = t424 * t424
    t426 = t50 + t199 * t418 + t200 * t419 + t421 * (t32 * t420)
    t427 = t424 / (2e-18 + (t425 + t425)) * (t426 + t419 * (t35 * t423))
    t428 = np.maximum((-0.001), np.minimum(0.001, -np.where(t31 != 0.0, t427, 0.0)))
    t429 = t418 - t419 * t428
    t430 = t419 + t418 * t428
    t431 = np.sqrt((t429 * t429 + t430 * t430))
    t432 = t429 / t431
    t433 = np.where(t431 != 0.0, t432, 0.0)
    t434 = t430 / t431
    t435 = t432 + t434
    t436 = t433 - np.where(t431 != 0.0, t434, 0.0)
    t437 = np.where(t31 != 0.0, np.where(t431 != 0.0, t46 * t432, 0.0), 0.0) + np.where(t431 != 0.0, np.where(t31 != 0.0, t35 * t435 * t436, 0.0), 0.0)
    t438 = t432 + t432
    t439 = t437 - np.where(t431 != 0.0, np.where(t31 != 0.0, t40 * t434, 0.0), 0.0) - np.where(t431 != 0.0, np.where(t31 != 0.0, np.where(t431 != 0.0, t434 * (t32 * t438), 0.0), 0.0), 0.0)
    t440 = t439 * t439
    t441 = t216 + np.where(t431 != 0.0, np.where(t31 != 0.0, t199 * t432, 0.0), 0.0) + np.where(t431 != 0.0, np.where(t31 != 0.0, t200 * t434, 0.0), 0.0)
    t442 = t441 + np.where(t431 != 0.0, np.where(t31 != 0.0, t436 * (t32 * t435), 0.0), 0.0) + np.where(t431 != 0.0, np.where(t31 != 0.0, np.where(t431 != 0.0, t434 * (t35 * t438), 0.0), 0.0), 0.0)
    t443 = np.maximum((-0.001), np.minimum(0.001, -(t439 / (2e-18 + (t440 + t440)) * t442)))
    t444 = t433 - np.where(t431 != 0.0, t434 * t443, 0.0)
    t445 = t434 + t432 * t443
    t446 = np.sqrt((t444 * t444 + np.where(t431 != 0.0, np.where(t431 != 0.0, t445 * t445, 0.0), 0.0)))
    t447 = t444 / t446
    t448 = t445 / t446
    t449 = t9 + np.where(t446 != 0.0, t13 * t447, 0.0) + np.where(t431 != 0.0, np.where(t446 != 0.0, t224 * t448, 0.0), 0.0)
    t450 = t449 / t1
    t451 = d3 + np.where(t446 != 0.0, d4 * t447, 0.0)
    t452 = (t11 + np.where(t431 != 0.0, np.where(t446 != 0.0, -(t229 * t448), 0.0), 0.0)) / sa2
    t453 = np.where(t431 != 0.0, np.where(t446 != 0.0, t231 * t448, 0.0), 0.0) - t232
    t454 = np.where(t1 != 0.0, t450 * t451, 0.0) + np.where(sa2 != 0.0, t452 * t453, 0.0)
    t455 = np.where(sa2 != 0.0, t451 * t452, 0.0) - np.where(t1 != 0.0, t450 * t453, 0.0)
    t456 = np.sqrt((t454 * t454 + t455 * t455))
    t457 = t454 / t456
    t458 = t455 / t456
    t459 = d2 + (np.where(t456 != 0.0, t451 * t457, 0.0) - np.where(t456 != 0.0, t453 * t458, 0.0))
    t460 = t453 * t457 + t451 * t458
    t461 = r2 + (t241 + np.where(t431 != 0.0, np.where(t446 != 0.0, sa3 * (d4 * t448), 0.0), 0.0))
    t462 = np.where(t456 != 0.0, ca2 * t460, 0.0) - sa2 * t461
    t463 = x * t459 + y * t462
    t464 = y * t459 - x * t462
    t465 = -t463
    t466 = np.maximum(t463, t465)
    t467 = np.maximum(t464, -t464)
    t468 = np.sqrt((t463 * t463 + t464 * t464)) + np.maximum(t466, t467)
    t469 = np.minimum(t466, t467) / t468
    t470 = t469 / (1 + np.sqrt((1 + np.where(t468 != 0.0, np.where(t468 != 0.0, t469 * t469, 0.0), 0.0))))
    t471 = t470 * t470
    t472 = np.where(t468 != 0.0, np.where(t468 != 0.0, t471 * (np.where(t468 != 0.0, np.where(t468 != 0.0, 0.047619047619047616 * t471, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t473 = np.where(t468 != 0.0, t471 * (np.where(t468 != 0.0, np.where(t468 != 0.0, t471 * (0.058823529411764705 + t472), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t474 = t471 * (np.where(t468 != 0.0, np.where(t468 != 0.0, t471 * (0.07692307692307693 + np.where(t468 != 0.0, t473, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t475 = np.where(t468 != 0.0, np.where(t468 != 0.0, t471 * (0.1111111111111111 + np.where(t468 != 0.0, np.where(t468 != 0.0, t474, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t476 = np.where(t468 != 0.0, np.where(t468 != 0.0, t471 * (0.2 + np.where(t468 != 0.0, np.where(t468 != 0.0, t471 * t475, 0.0), 0.0)), 0.0), 0.0)
    t477 = 4 * t470 * (1 + np.where(t468 != 0.0, np.where(t468 != 0.0, t471 * (t476 - 0.3333333333333333), 0.0), 0.0))
    t478 = 0.5 * np.copysign(1, t467 - t466)
    t479 = np.where(t468 != 0.0, t477 * (0.5 - t478), 0.0) + (0.5 + t478) * (1.5707963267948966 - np.where(t468 != 0.0, t477, 0.0))
    t480 = 0.5 * np.copysign(1, t465)
    t481 = np.copysign((t479 * (0.5 - t480) + (0.5 + t480) * (3.141592653589793 - t479)), t464)
    t482 = np.where(t456 != 0.0, t457, 0.0)
    t483 = -t482
    t484 = np.maximum(t482, t483)
    t485 = np.where(t456 != 0.0, t458, 0.0)
    t486 = np.maximum(t485, -t485)
    t487 = 1 + np.maximum(t484, t486)
    t488 = np.minimum(t484, t486) / t487
    t489 = t488 / (1 + np.sqrt((1 + np.where(t487 != 0.0, np.where(t487 != 0.0, t488 * t488, 0.0), 0.0))))
    t490 = t489 * t489
    t491 = np.where(t487 != 0.0, np.where(t487 != 0.0, t490 * (np.where(t487 != 0.0, np.where(t487 != 0.0, 0.047619047619047616 * t490, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t492 = np.where(t487 != 0.0, t490 * (np.where(t487 != 0.0, np.where(t487 != 0.0, t490 * (0.058823529411764705 + t491), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t493 = t490 * (np.where(t487 != 0.0, np.where(t487 != 0.0, t490 * (0.07692307692307693 + np.where(t487 != 0.0, t492, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t494 = np.where(t487 != 0.0, np.where(t487 != 0.0, t490 * (0.1111111111111111 + np.where(t487 != 0.0, np.where(t487 != 0.0, t493, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t495 = np.where(t487 != 0.0, np.where(t487 != 0.0, t490 * (0.2 + np.where(t487 != 0.0, np.where(t487 != 0.0, t490 * t494, 0.0), 0.0)), 0.0), 0.0)
    t496 = 4 * t489 * (1 + np.where(t487 != 0.0, np.where(t487 != 0.0, t490 * (t495 - 0.3333333333333333), 0.0), 0.0))
    t497 = 0.5 * np.copysign(1, t486 - t484)
    t498 = np.where(t487 != 0.0, t496 * (0.5 - t497), 0.0) + (0.5 + t497) * (1.5707963267948966 - np.where(t487 != 0.0, t496, 0.0))
    t499 = 0.5 * np.copysign(1, t483)
    t500 = np.copysign((t498 * (0.5 - t499) + (0.5 + t499) * (3.141592653589793 - t498)), t485)
    t501 = np.where(t446 != 0.0, t447, 0.0)
    t502 = -t501
    t503 = np.maximum(t501, t502)
    t504 = np.where(t431 != 0.0, np.where(t446 != 0.0, t448, 0.0), 0.0)
    t505 = np.maximum(t504, -t504)
    t506 = 1 + np.maximum(t503, t505)
    t507 = np.minimum(t503, t505) / t506
    t508 = t507 / (1 + np.sqrt((1 + np.where(t506 != 0.0, np.where(t506 != 0.0, t507 * t507, 0.0), 0.0))))
    t509 = t508 * t508
    t510 = np.where(t506 != 0.0, np.where(t506 != 0.0, t509 * (np.where(t506 != 0.0, np.where(t506 != 0.0, 0.047619047619047616 * t509, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t511 = np.where(t506 != 0.0, t509 * (np.where(t506 != 0.0, np.where(t506 != 0.0, t509 * (0.058823529411764705 + t510), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t512 = t509 * (np.where(t506 != 0.0, np.where(t506 != 0.0, t509 * (0.07692307692307693 + np.where(t506 != 0.0, t511, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t513 = np.where(t506 != 0.0, np.where(t506 != 0.0, t509 * (0.1111111111111111 + np.where(t506 != 0.0, np.where(t506 != 0.0, t512, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t514 = np.where(t506 != 0.0, np.where(t506 != 0.0, t509 * (0.2 + np.where(t506 != 0.0, np.where(t506 != 0.0, t509 * t513, 0.0), 0.0)), 0.0), 0.0)
    t515 = 4 * t508 * (1 + np.where(t506 != 0.0, np.where(t506 != 0.0, t509 * (t514 - 0.3333333333333333), 0.0), 0.0))
    t516 = 0.5 * np.copysign(1, t505 - t503)
    t517 = np.where(t506 != 0.0, t515 * (0.5 - t516), 0.0) + (0.5 + t516) * (1.5707963267948966 - np.where(t506 != 0.0, t515, 0.0))
    t518 = 0.5 * np.copysign(1, t502)
    t519 = np.copysign((t517 * (0.5 - t518) + (0.5 + t518) * (3.141592653589793 - t517)), t504)
    t520 = t38 * (t414 - t413)
    t521 = t38 * (t410 + t411)
    t522 = t52 * t520 - t53 * t521
    t523 = t53 * t520 - t52 * t521
    t524 = t45 * t522 - t47 * t523
    t525 = t47 * t522 + t45 * t523
    t526 = t524 + t525
    t527 = t524 - t525
    t528 = np.where(t31 != 0.0, t46 * t524 + t35 * t526 * t527, 0.0) - np.where(t31 != 0.0, t40 * t525, 0.0)
    t529 = t524 + t524
    t530 = t528 - np.where(t31 != 0.0, t525 * (t32 * t529), 0.0)
    t531 = t530 * t530
    t532 = t50 + t199 * t524 + t200 * t525 + t527 * (t32 * t526)
    t533 = t530 / (2e-18 + (t531 + t531)) * (t532 + t525 * (t35 * t529))
    t534 = np.maximum((-0.001), np.minimum(0.001, -np.where(t31 != 0.0, t533, 0.0)))
    t535 = t524 - t525 * t534
    t536 = t525 + t524 * t534
    t537 = np.sqrt((t535 * t535 + t536 * t536))
    t538 = t535 / t537
    t539 = np.where(t537 != 0.0, t538, 0.0)
    t540 = t536 / t537
    t541 = t538 + t540
    t542 = t539 - np.where(t537 != 0.0, t540, 0.0)
    t543 = np.where(t31 != 0.0, np.where(t537 != 0.0, t46 * t538, 0.0), 0.0) + np.where(t537 != 0.0, np.where(t31 != 0.0, t35 * t541 * t542, 0.0), 0.0)
    t544 = t538 + t538
    t545 = t543 - np.where(t537 != 0.0, np.where(t31 != 0.0, t40 * t540, 0.0), 0.0) - np.where(t537 != 0.0, np.where(t31 != 0.0, np.where(t537 != 0.0, t540 * (t32 * t544), 0.0), 0.0), 0.0)
    t546 = t545 * t545
    t547 = t216 + np.where(t537 != 0.0, np.where(t31 != 0.0, t199 * t538, 0.0), 0.0) + np.where(t537 != 0.0, np.where(t31 != 0.0, t200 * t540, 0.0), 0.0)
    t548 = t547 + np.where(t537 != 0.0, np.where(t31 != 0.0, t542 * (t32 * t541), 0.0), 0.0) + np.where(t537 != 0.0, np.where(t31 != 0.0, np.where(t537 != 0.0, t540 * (t35 * t544), 0.0), 0.0), 0.0)
    t549 = np.maximum((-0.001), np.minimum(0.001, -(t545 / (2e-18 + (t546 + t546)) * t548)))
    t550 = t539 - np.where(t537 != 0.0, t540 * t549, 0.0)
    t551 = t540 + t538 * t549
    t552 = np.sqrt((t550 * t550 + np.where(t537 != 0.0, np.where(t537 != 0.0, t551 * t551, 0.0), 0.0)))
    t553 = t550 / t552
    t554 = t551 / t552
    t555 = t9 + np.where(t552 != 0.0, t13 * t553, 0.0) + np.where(t537 != 0.0, np.where(t552 != 0.0, t224 * t554, 0.0), 0.0)
    t556 = t555 / t1
    t557 = d3 + np.where(t552 != 0.0, d4 * t553, 0.0)
    t558 = (t11 + np.where(t537 != 0.0, np.where(t552 != 0.0, -(t229 * t554), 0.0), 0.0)) / sa2
    t559 = np.where(t537 != 0.0, np.where(t552 != 0.0, t231 * t554, 0.0), 0.0) - t232
    t560 = np.where(t1 != 0.0, t556 * t557, 0.0) + np.where(sa2 != 0.0, t558 * t559, 0.0)
    t561 = np.where(sa2 != 0.0, t557 * t558, 0.0) - np.where(t1 != 0.0, t556 * t559, 0.0)
    t562 = np.sqrt((t560 * t560 + t561 * t561))
    t563 = t560 / t562
    t564 = t561 / t562
    t565 = d2 + (np.where(t562 != 0.0, t557 * t563, 0.0) - np.where(t562 != 0.0, t559 * t564, 0.0))
    t566 = t559 * t563 + t557 * t564
    t567 = r2 + (t241 + np.where(t537 != 0.0, np.where(t552 != 0.0, sa3 * (d4 * t554), 0.0), 0.0))
    t568 = np.where(t562 != 0.0, ca2 * t566, 0.0) - sa2 * t567
    t569 = x * t565 + y * t568
    t570 = y * t565 - x * t568
    t571 = -t569
    t572 = np.maximum(t569, t571)
    t573 = np.maximum(t570, -t570)
    t574 = np.sqrt((t569 * t569 + t570 * t570)) + np.maximum(t572, t573)
    t575 = np.minimum(t572, t573) / t574
    t576 = t575 / (1 + np.sqrt((1 + np.where(t574 != 0.0, np.where(t574 != 0.0, t575 * t575, 0.0), 0.0))))
    t577 = t576 * t576
    t578 = np.where(t574 != 0.0, np.where(t574 != 0.0, t577 * (np.where(t574 != 0.0, np.where(t574 != 0.0, 0.047619047619047616 * t577, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t579 = np.where(t574 != 0.0, t577 * (np.where(t574 != 0.0, np.where(t574 != 0.0, t577 * (0.058823529411764705 + t578), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t580 = t577 * (np.where(t574 != 0.0, np.where(t574 != 0.0, t577 * (0.07692307692307693 + np.where(t574 != 0.0, t579, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t581 = np.where(t574 != 0.0, np.where(t574 != 0.0, t577 * (0.1111111111111111 + np.where(t574 != 0.0, np.where(t574 != 0.0, t580, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t582 = np.where(t574 != 0.0, np.where(t574 != 0.0, t577 * (0.2 + np.where(t574 != 0.0, np.where(t574 != 0.0, t577 * t581, 0.0), 0.0)), 0.0), 0.0)
    t583 = 4 * t576 * (1 + np.where(t574 != 0.0, np.where(t574 != 0.0, t577 * (t582 - 0.3333333333333333), 0.0), 0.0))
    t584 = 0.5 * np.copysign(1, t573 - t572)
    t585 = np.where(t574 != 0.0, t583 * (0.5 - t584), 0.0) + (0.5 + t584) * (1.5707963267948966 - np.where(t574 != 0.0, t583, 0.0))
    t586 = 0.5 * np.copysign(1, t571)
    t587 = np.copysign((t585 * (0.5 - t586) + (0.5 + t586) * (3.141592653589793 - t585)), t570)
    t588 = np.where(t562 != 0.0, t563, 0.0)
    t589 = -t588
    t590 = np.maximum(t588, t589)
    t591 = np.where(t562 != 0.0, t564, 0.0)
    t592 = np.maximum(t591, -t591)
    t593 = 1 + np.maximum(t590, t592)
    t594 = np.minimum(t590, t592) / t593
    t595 = t594 / (1 + np.sqrt((1 + np.where(t593 != 0.0, np.where(t593 != 0.0, t594 * t594, 0.0), 0.0))))
    t596 = t595 * t595
    t597 = np.where(t593 != 0.0, np.where(t593 != 0.0, t596 * (np.where(t593 != 0.0, np.where(t593 != 0.0, 0.047619047619047616 * t596, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t598 = np.where(t593 != 0.0, t596 * (np.where(t593 != 0.0, np.where(t593 != 0.0, t596 * (0.058823529411764705 + t597), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t599 = t596 * (np.where(t593 != 0.0, np.where(t593 != 0.0, t596 * (0.07692307692307693 + np.where(t593 != 0.0, t598, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t600 = np.where(t593 != 0.0, np.where(t593 != 0.0, t596 * (0.1111111111111111 + np.where(t593 != 0.0, np.where(t593 != 0.0, t599, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t601 = np.where(t593 != 0.0, np.where(t593 != 0.0, t596 * (0.2 + np.where(t593 != 0.0, np.where(t593 != 0.0, t596 * t600, 0.0), 0.0)), 0.0), 0.0)
    t602 = 4 * t595 * (1 + np.where(t593 != 0.0, np.where(t593 != 0.0, t596 * (t601 - 0.3333333333333333), 0.0), 0.0))
    t603 = 0.5 * np.copysign(1, t592 - t590)
    t604 = np.where(t593 != 0.0, t602 * (0.5 - t603), 0.0) + (0.5 + t603) * (1.5707963267948966 - np.where(t593 != 0.0, t602, 0.0))
    t605 = 0.5 * np.copysign(1, t589)
    t606 = np.copysign((t604 * (0.5 - t605) + (0.5 + t605) * (3.141592653589793 - t604)), t591)
    t607 = np.where(t552 != 0.0, t553, 0.0)
    t608 = -t607
    t609 = np.maximum(t607, t608)
    t610 = np.where(t537 != 0.0, np.where(t552 != 0.0, t554, 0.0), 0.0)
    t611 = np.maximum(t610, -t610)
    t612 = 1 + np.maximum(t609, t611)
    t613 = np.minimum(t609, t611) / t612
    t614 = t613 / (1 + np.sqrt((1 + np.where(t612 != 0.0, np.where(t612 != 0.0, t613 * t613, 0.0), 0.0))))
    t615 = t614 * t614
    t616 = np.where(t612 != 0.0, np.where(t612 != 0.0, t615 * (np.where(t612 != 0.0, np.where(t612 != 0.0, 0.047619047619047616 * t615, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t617 = np.where(t612 != 0.0, t615 * (np.where(t612 != 0.0, np.where(t612 != 0.0, t615 * (0.058823529411764705 + t616), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t618 = t615 * (np.where(t612 != 0.0, np.where(t612 != 0.0, t615 * (0.07692307692307693 + np.where(t612 != 0.0, t617, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t619 = np.where(t612 != 0.0, np.where(t612 != 0.0, t615 * (0.1111111111111111 + np.where(t612 != 0.0, np.where(t612 != 0.0, t618, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t620 = np.where(t612 != 0.0, np.where(t612 != 0.0, t615 * (0.2 + np.where(t612 != 0.0, np.where(t612 != 0.0, t615 * t619, 0.0), 0.0)), 0.0), 0.0)
    t621 = 4 * t614 * (1 + np.where(t612 != 0.0, np.where(t612 != 0.0, t615 * (t620 - 0.3333333333333333), 0.0), 0.0))
    t622 = 0.5 * np.copysign(1, t611 - t609)
    t623 = np.where(t612 != 0.0, t621 * (0.5 - t622), 0.0) + (0.5 + t622) * (1.5707963267948966 - np.where(t612 != 0.0, t621, 0.0))
    t624 = 0.5 * np.copysign(1, t608)
    t625 = np.copysign((t623 * (0.5 - t624) + (0.5 + t624) * (3.141592653589793 - t623)), t610)
    t626 = np.sqrt(t2)
    t627 = np.sqrt((t239 * t239 + t243 * t243)) - t626
    t628 = np.where(t236 != 0.0, sa2 * t240, 0.0) + ca2 * t242 - z
    t629 = np.sqrt((t346 * t346 + t349 * t349)) - t626
    t630 = np.where(t343 != 0.0, sa2 * t347, 0.0) + ca2 * t348 - z
    t631 = np.sqrt((t459 * t459 + t462 * t462)) - t626
    t632 = np.where(t456 != 0.0, sa2 * t460, 0.0) + ca2 * t461 - z
    t633 = np.sqrt((t565 * t565 + t568 * t568)) - t626
    t634 = np.where(t562 != 0.0, sa2 * t566, 0.0) + ca2 * t567 - z
    t635 = np.where(t222 != 0.0, t46 * t223, 0.0) + t35 * (t282 + t285) * (t282 - t285)
    t636 = np.where(t206 != 0.0, np.where(t222 != 0.0, np.where(t31 != 0.0, np.where(t222 != 0.0, t225 * (t32 * (t223 + t223)), 0.0), 0.0), 0.0), 0.0)
    t637 = np.where(t31 != 0.0, t635, 0.0) - np.where(t206 != 0.0, np.where(t222 != 0.0, np.where(t31 != 0.0, t40 * t225, 0.0), 0.0), 0.0) - t636
    t638 = np.where(t333 != 0.0, t46 * t334, 0.0) + t35 * (t388 + t391) * (t388 - t391)
    t639 = np.where(t318 != 0.0, np.where(t333 != 0.0, np.where(t31 != 0.0, np.where(t333 != 0.0, t335 * (t32 * (t334 + t334)), 0.0), 0.0), 0.0), 0.0)
    t640 = np.where(t31 != 0.0, t638, 0.0) - np.where(t318 != 0.0, np.where(t333 != 0.0, np.where(t31 != 0.0, t40 * t335, 0.0), 0.0), 0.0) - t639
    t641 = np.where(t446 != 0.0, t46 * t447, 0.0) + t35 * (t501 + t504) * (t501 - t504)
    t642 = np.where(t431 != 0.0, np.where(t446 != 0.0, np.where(t31 != 0.0, np.where(t446 != 0.0, t448 * (t32 * (t447 + t447)), 0.0), 0.0), 0.0), 0.0)
    t643 = np.where(t31 != 0.0, t641, 0.0) - np.where(t431 != 0.0, np.where(t446 != 0.0, np.where(t31 != 0.0, t40 * t448, 0.0), 0.0), 0.0) - t642
    t644 = np.where(t552 != 0.0, t46 * t553, 0.0) + t35 * (t607 + t610) * (t607 - t610)
    t645 = np.where(t537 != 0.0, np.where(t552 != 0.0, np.where(t31 != 0.0, np.where(t552 != 0.0, t554 * (t32 * (t553 + t553)), 0.0), 0.0), 0.0), 0.0)
    t646 = np.where(t31 != 0.0, t644, 0.0) - np.where(t537 != 0.0, np.where(t552 != 0.0, np.where(t31 != 0.0, t40 * t554, 0.0), 0.0), 0.0) - t645
    t647 = t50 * t50
    t648 = t36 + t32 * t32
    t649 = t40 * t40
    t650 = t46 * t46
    t651 = t649 + t650
    t652 = np.where(t31 != 0.0, np.where(t31 != 0.0, t647 + 3 * t648, 0.0), 0.0) - np.where(t31 != 0.0, np.where(t31 != 0.0, 3 * t651, 0.0), 0.0)
    t653 = t652 * t652
    t654 = t32 * (np.where(t31 != 0.0, np.where(t31 != 0.0, t649, 0.0), 0.0) - np.where(t31 != 0.0, np.where(t31 != 0.0, t650, 0.0), 0.0)) + np.where(t31 != 0.0, np.where(t31 != 0.0, t46 * (t35 * t199), 0.0), 0.0)
    t655 = np.where(t31 != 0.0, np.where(t31 != 0.0, t647 + t647, 0.0), 0.0) - np.where(t31 != 0.0, np.where(t31 != 0.0, 18 * t648, 0.0), 0.0)
    t656 = 27 * t654 + t50 * (t655 - np.where(t31 != 0.0, np.where(t31 != 0.0, 9 * t651, 0.0), 0.0))
    t657 = 4 * t652 * t653 - np.where(t31 != 0.0, np.where(t31 != 0.0, t656 * t656, 0.0), 0.0)
    t658 = 0.5 + 0.5 * np.copysign(1, t657)
    t659 = np.maximum(d2, -d2)
    t660 = np.maximum(ca2, -ca2)
    t661 = t660 + t660
    t662 = t659 * t661
    t663 = np.maximum(r2, -r2)
    t664 = np.maximum(ca3, -ca3)
    t665 = np.maximum(r3, -r3)
    t666 = (t659 + t659) * np.maximum(z, -z) + t662 * t663 + t659 * (t661 * t664) * t665
    t667 = np.maximum(d4, -d4)
    t668 = np.maximum(sa3, -sa3)
    t669 = t666 + t662 * t667 * t668
    t670 = np.maximum(sa2, -sa2)
    t671 = t4 * t670 + t5 * t670 + t6 * t670 + t7 * t670
    t672 = t671 + t8 * t670 + t3 * t670 + t670 * np.maximum(t2, -t2)
    t673 = np.maximum(d3, -d3)
    t674 = t672 + t670 * (t667 * (t673 + t673)) + t670 * (t665 * (t663 * (t664 + t664)))
    t675 = t674 + t668 * (t670 * (t663 * (t667 + t667)))
    t676 = t664 * t667 + t665 * t668
    t677 = t667 + t673
    t678 = t669 * t669 + t675 * t675 + t22 * (t676 * t676 + t677 * t677)
    t679 = 3.552713678800501e-15 / t31 * t678
    t680 = -0.3333333333333333 * t652
    t681 = np.where(t31 != 0.0, np.where(t31 != 0.0, t648 + t651, 0.0), 0.0) - np.where(t31 != 0.0, np.where(t31 != 0.0, 0.5555555555555556 * t647, 0.0), 0.0)
    t682 = 1.3333333333333333 * t50
    t683 = t680 * t680 + 3 * (t681 * t681) + np.where(t31 != 0.0, np.where(t31 != 0.0, t680 * (t682 * t682), 0.0), 0.0)
    t684 = t683 + np.where(t31 != 0.0, np.where(t31 != 0.0, t682 * (0.1111111111111111 * t656), 0.0), 0.0) - t681 * (-1.3333333333333333 * t652)
    t685 = 0.016666666666666666 / np.where(t31 != 0.0, t679, 0.0) * np.minimum(t684, 3 * (3 * t681 - -0.6666666666666666 * t652))
    t686 = np.where(t31 != 0.0, t656, 0.0)
    t687 = 72 * t653 + 120 * np.maximum(t686, -t686) + np.where(t31 != 0.0, 5000 * t679, 0.0)
    t688 = np.maximum(t657, -t657) / np.where(t31 != 0.0, t679 * t687, 0.0)

    # results
    angles = np.empty((*_leading, 12), _real)
    room = np.empty((*_leading, 2), _real)
    closure = np.empty((*_leading, 4), _real)
    slope = np.empty((*_leading, 4), _real)
    number = np.empty((*_leading, 1), _real)
    margin = np.empty((*_leading, 1), _real)
    angles[..., 0] = t262
    angles[..., 1] = t281
    angles[..., 2] = t300
    angles[..., 3] = t368
    angles[..., 4] = t387
    angles[..., 5] = t406
    angles[..., 6] = t481
    angles[..., 7] = t500
    angles[..., 8] = t519
    angles[..., 9] = t587
    angles[..., 10] = t606
    angles[..., 11] = t625
    room[..., 0] = t181
    room[..., 1] = t408
    closure[..., 0] = np.sqrt((t627 * t627 + t628 * t628))
    closure[..., 1] = np.sqrt((t629 * t629 + t630 * t630))
    closure[..., 2] = np.sqrt((t631 * t631 + t632 * t632))
    closure[..., 3] = np.sqrt((t633 * t633 + t634 * t634))
    slope[..., 0] = t637
    slope[..., 1] = t640
    slope[..., 2] = t643
    slope[..., 3] = t646
    number[..., 0] = 2 + t658 * np.copysign(2, t685)
    margin[..., 0] = np.minimum(t688, t688 * (1 - t658) + np.maximum(t685, -t685))
    return angles.reshape(_leading + (4, 3)), room.reshape(_leading + (2,)), closure.reshape(_leading + (4,)), slope.reshape(_leading + (4,)), number.reshape(_leading), margin.reshape(_leading)


def postures_intersecting(parameters, point):
    """the postures of an arm with axes 1 and 2 intersecting, the distance each leaves, and W: 1116 operations.

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
    t4 = 1 - np.where(t3 != 0.0, 1, 0.0)
    t5 = x * x + y * y
    t6 = t5 + z * z - d2 * d2 - d3 * d3 - d4 * d4
    t7 = t6 - r2 * r2 - r3 * r3 - r3 * (r2 * (ca3 + ca3))
    t8 = t1 * t7
    t9 = np.sqrt(np.maximum(0.0, t3 - t7 * t7))
    t10 = t2 * t9
    t11 = t4 - np.where(t3 != 0.0, (t8 + t10) / t3, 0.0)
    t12 = t1 * t9
    t13 = t2 * t7
    t14 = (t12 - t13) / t3
    t15 = np.sqrt((t11 * t11 + np.where(t3 != 0.0, np.where(t3 != 0.0, t14 * t14, 0.0), 0.0)))
    t16 = t11 / t15
    t17 = d3 + np.where(t15 != 0.0, d4 * t16, 0.0)
    t18 = d4 * ca3
    t19 = t14 / t15
    t20 = sa3 * r3
    t21 = np.where(t15 != 0.0, np.where(t3 != 0.0, t18 * t19, 0.0), 0.0) - t20
    t22 = t17 * t17 + t21 * t21
    t23 = z - r2 * ca2 - r3 * (ca3 * ca2)
    t24 = sa3 * (d4 * ca2)
    t25 = (t23 + np.where(t15 != 0.0, np.where(t3 != 0.0, -(t19 * t24), 0.0), 0.0)) / sa2
    t26 = np.sqrt(np.maximum(0.0, t22 - np.where(sa2 != 0.0, np.where(sa2 != 0.0, t25 * t25, 0.0), 0.0)))
    t27 = t17 * t26
    t28 = np.where(sa2 != 0.0, t21 * t25, 0.0)
    t29 = t27 + t28
    t30 = np.where(sa2 != 0.0, t17 * t25, 0.0)
    t31 = t21 * t26
    t32 = t30 - t31
    t33 = np.sqrt((t29 * t29 + t32 * t32))
    t34 = t29 / t33
    t35 = t32 / t33
    t36 = d2 + (np.where(t33 != 0.0, t17 * t34, 0.0) - np.where(t33 != 0.0, t21 * t35, 0.0))
    t37 = t21 * t34 + t17 * t35
    t38 = r3 * ca3
    t39 = r2 + (t38 + np.where(t15 != 0.0, np.where(t3 != 0.0, sa3 * (d4 * t19), 0.0), 0.0))
    t40 = sa2 * t39
    t41 = np.where(t33 != 0.0, ca2 * t37, 0.0) - t40
    t42 = x * t36 + y * t41
    t43 = y * t36 - x * t41
    t44 = -t42
    t45 = np.maximum(t42, t44)
    t46 = np.maximum(t43, -t43)
    t47 = np.sqrt((t42 * t42 + t43 * t43)) + np.maximum(t45, t46)
    t48 = np.minimum(t45, t46) / t47
    t49 = t48 / (1 + np.sqrt((1 + np.where(t47 != 0.0, np.where(t47 != 0.0, t48 * t48, 0.0), 0.0))))
    t50 = t49 * t49
    t51 = np.where(t47 != 0.0, np.where(t47 != 0.0, t50 * (np.where(t47 != 0.0, np.where(t47 != 0.0, 0.047619047619047616 * t50, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t52 = np.where(t47 != 0.0, t50 * (np.where(t47 != 0.0, np.where(t47 != 0.0, t50 * (0.058823529411764705 + t51), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t53 = t50 * (np.where(t47 != 0.0, np.where(t47 != 0.0, t50 * (0.07692307692307693 + np.where(t47 != 0.0, t52, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t54 = np.where(t47 != 0.0, np.where(t47 != 0.0, t50 * (0.1111111111111111 + np.where(t47 != 0.0, np.where(t47 != 0.0, t53, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t55 = np.where(t47 != 0.0, np.where(t47 != 0.0, t50 * (0.2 + np.where(t47 != 0.0, np.where(t47 != 0.0, t50 * t54, 0.0), 0.0)), 0.0), 0.0)
    t56 = 4 * t49 * (1 + np.where(t47 != 0.0, np.where(t47 != 0.0, t50 * (t55 - 0.3333333333333333), 0.0), 0.0))
    t57 = 0.5 * np.copysign(1, t46 - t45)
    t58 = np.where(t47 != 0.0, t56 * (0.5 - t57), 0.0) + (0.5 + t57) * (1.5707963267948966 - np.where(t47 != 0.0, t56, 0.0))
    t59 = 0.5 * np.copysign(1, t44)
    t60 = np.copysign((t58 * (0.5 - t59) + (0.5 + t59) * (3.141592653589793 - t58)), t43)
    t61 = np.where(t33 != 0.0, t34, 0.0)
    t62 = -t61
    t63 = np.maximum(t61, t62)
    t64 = np.where(t33 != 0.0, t35, 0.0)
    t65 = np.maximum(t64, -t64)
    t66 = 1 + np.maximum(t63, t65)
    t67 = np.minimum(t63, t65) / t66
    t68 = t67 / (1 + np.sqrt((1 + np.where(t66 != 0.0, np.where(t66 != 0.0, t67 * t67, 0.0), 0.0))))
    t69 = t68 * t68
    t70 = np.where(t66 != 0.0, np.where(t66 != 0.0, t69 * (np.where(t66 != 0.0, np.where(t66 != 0.0, 0.047619047619047616 * t69, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t71 = np.where(t66 != 0.0, t69 * (np.where(t66 != 0.0, np.where(t66 != 0.0, t69 * (0.058823529411764705 + t70), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t72 = t69 * (np.where(t66 != 0.0, np.where(t66 != 0.0, t69 * (0.07692307692307693 + np.where(t66 != 0.0, t71, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t73 = np.where(t66 != 0.0, np.where(t66 != 0.0, t69 * (0.1111111111111111 + np.where(t66 != 0.0, np.where(t66 != 0.0, t72, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t74 = np.where(t66 != 0.0, np.where(t66 != 0.0, t69 * (0.2 + np.where(t66 != 0.0, np.where(t66 != 0.0, t69 * t73, 0.0), 0.0)), 0.0), 0.0)
    t75 = 4 * t68 * (1 + np.where(t66 != 0.0, np.where(t66 != 0.0, t69 * (t74 - 0.3333333333333333), 0.0), 0.0))
    t76 = 0.5 * np.copysign(1, t65 - t63)
    t77 = np.where(t66 != 0.0, t75 * (0.5 - t76), 0.0) + (0.5 + t76) * (1.5707963267948966 - np.where(t66 != 0.0, t75, 0.0))
    t78 = 0.5 * np.copysign(1, t62)
    t79 = np.copysign((t77 * (0.5 - t78) + (0.5 + t78) * (3.141592653589793 - t77)), t64)
    t80 = np.where(t15 != 0.0, t16, 0.0)
    t81 = -t80
    t82 = np.maximum(t80, t81)
    t83 = np.where(t15 != 0.0, np.where(t3 != 0.0, t19, 0.0), 0.0)
    t84 = np.maximum(t83, -t83)
    t85 = 1 + np.maximum(t82, t84)
    t86 = np.minimum(t82, t84) / t85
    t87 = t86 / (1 + np.sqrt((1 + np.where(t85 != 0.0, np.where(t85 != 0.0, t86 * t86, 0.0), 0.0))))
    t88 = t87 * t87
    t89 = np.where(t85 != 0.0, np.where(t85 != 0.0, t88 * (np.where(t85 != 0.0, np.where(t85 != 0.0, 0.047619047619047616 * t88, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t90 = np.where(t85 != 0.0, t88 * (np.where(t85 != 0.0, np.where(t85 != 0.0, t88 * (0.058823529411764705 + t89), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t91 = t88 * (np.where(t85 != 0.0, np.where(t85 != 0.0, t88 * (0.07692307692307693 + np.where(t85 != 0.0, t90, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t92 = np.where(t85 != 0.0, np.where(t85 != 0.0, t88 * (0.1111111111111111 + np.where(t85 != 0.0, np.where(t85 != 0.0, t91, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t93 = np.where(t85 != 0.0, np.where(t85 != 0.0, t88 * (0.2 + np.where(t85 != 0.0, np.where(t85 != 0.0, t88 * t92, 0.0), 0.0)), 0.0), 0.0)
    t94 = 4 * t87 * (1 + np.where(t85 != 0.0, np.where(t85 != 0.0, t88 * (t93 - 0.3333333333333333), 0.0), 0.0))
    t95 = 0.5 * np.copysign(1, t84 - t82)
    t96 = np.where(t85 != 0.0, t94 * (0.5 - t95), 0.0) + (0.5 + t95) * (1.5707963267948966 - np.where(t85 != 0.0, t94, 0.0))
    t97 = 0.5 * np.copysign(1, t81)
    t98 = np.copysign((t96 * (0.5 - t97) + (0.5 + t97) * (3.141592653589793 - t96)), t83)
    t99 = t28 - t27
    t100 = t30 + t31
    t101 = np.sqrt((t99 * t99 + t100 * t100))
    t102 = t99 / t101
    t103 = t100 / t101
    t104 = d2 + (np.where(t101 != 0.0, t17 * t102, 0.0) - np.where(t101 != 0.0, t21 * t103, 0.0))
    t105 = t21 * t102 + t17 * t103
    t106 = np.where(t101 != 0.0, ca2 * t105, 0.0) - t40
    t107 = x * t104 + y * t106
    t108 = y * t104 - x * t106
    t109 = -t107
    t110 = np.maximum(t107, t109)
    t111 = np.maximum(t108, -t108)
    t112 = np.sqrt((t107 * t107 + t108 * t108)) + np.maximum(t110, t111)
    t113 = np.minimum(t110, t111) / t112
    t114 = t113 / (1 + np.sqrt((1 + np.where(t112 != 0.0, np.where(t112 != 0.0, t113 * t113, 0.0), 0.0))))
    t115 = t114 * t114
    t116 = np.where(t112 != 0.0, np.where(t112 != 0.0, t115 * (np.where(t112 != 0.0, np.where(t112 != 0.0, 0.047619047619047616 * t115, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t117 = np.where(t112 != 0.0, t115 * (np.where(t112 != 0.0, np.where(t112 != 0.0, t115 * (0.058823529411764705 + t116), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t118 = t115 * (np.where(t112 != 0.0, np.where(t112 != 0.0, t115 * (0.07692307692307693 + np.where(t112 != 0.0, t117, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t119 = np.where(t112 != 0.0, np.where(t112 != 0.0, t115 * (0.1111111111111111 + np.where(t112 != 0.0, np.where(t112 != 0.0, t118, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t120 = np.where(t112 != 0.0, np.where(t112 != 0.0, t115 * (0.2 + np.where(t112 != 0.0, np.where(t112 != 0.0, t115 * t119, 0.0), 0.0)), 0.0), 0.0)
    t121 = 4 * t114 * (1 + np.where(t112 != 0.0, np.where(t112 != 0.0, t115 * (t120 - 0.3333333333333333), 0.0), 0.0))
    t122 = 0.5 * np.copysign(1, t111 - t110)
    t123 = np.where(t112 != 0.0, t121 * (0.5 - t122), 0.0) + (0.5 + t122) * (1.5707963267948966 - np.where(t112 != 0.0, t121, 0.0))
    t124 = 0.5 * np.copysign(1, t109)
    t125 = np.copysign((t123 * (0.5 - t124) + (0.5 + t124) * (3.141592653589793 - t123)), t108)
    t126 = np.where(t101 != 0.0, t102, 0.0)
    t127 = -t126
    t128 = np.maximum(t126, t127)
    t129 = np.where(t101 != 0.0, t103, 0.0)
    t130 = np.maximum(t129, -t129)
    t131 = 1 + np.maximum(t128, t130)
    t132 = np.minimum(t128, t130) / t131
    t133 = t132 / (1 + np.sqrt((1 + np.where(t131 != 0.0, np.where(t131 != 0.0, t132 * t132, 0.0), 0.0))))
    t134 = t133 * t133
    t135 = np.where(t131 != 0.0, np.where(t131 != 0.0, t134 * (np.where(t131 != 0.0, np.where(t131 != 0.0, 0.047619047619047616 * t134, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t136 = np.where(t131 != 0.0, t134 * (np.where(t131 != 0.0, np.where(t131 != 0.0, t134 * (0.058823529411764705 + t135), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t137 = t134 * (np.where(t131 != 0.0, np.where(t131 != 0.0, t134 * (0.07692307692307693 + np.where(t131 != 0.0, t136, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t138 = np.where(t131 != 0.0, np.where(t131 != 0.0, t134 * (0.1111111111111111 + np.where(t131 != 0.0, np.where(t131 != 0.0, t137, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t139 = np.where(t131 != 0.0, np.where(t131 != 0.0, t134 * (0.2 + np.where(t131 != 0.0, np.where(t131 != 0.0, t134 * t138, 0.0), 0.0)), 0.0), 0.0)
    t140 = 4 * t133 * (1 + np.where(t131 != 0.0, np.where(t131 != 0.0, t134 * (t139 - 0.3333333333333333), 0.0), 0.0))
    t141 = 0.5 * np.copysign(1, t130 - t128)
    t142 = np.where(t131 != 0.0, t140 * (0.5 - t141), 0.0) + (0.5 + t141) * (1.5707963267948966 - np.where(t131 != 0.0, t140, 0.0))
    t143 = 0.5 * np.copysign(1, t127)
    t144 = np.copysign((t142 * (0.5 - t143) + (0.5 + t143) * (3.141592653589793 - t142)), t129)
    t145 = t4 - np.where(t3 != 0.0, (t8 - t10) / t3, 0.0)
    t146 = (t12 + t13) / t3
    t147 = np.sqrt((t145 * t145 + np.where(t3 != 0.0, np.where(t3 != 0.0, t146 * t146, 0.0), 0.0)))
    t148 = t145 / t147
    t149 = d3 + np.where(t147 != 0.0, d4 * t148, 0.0)
    t150 = t146 / t147
    t151 = np.where(t147 != 0.0, np.where(t3 != 0.0, -(t18 * t150), 0.0), 0.0) - t20
    t152 = t149 * t149 + t151 * t151
    t153 = (t23 + np.where(t147 != 0.0, np.where(t3 != 0.0, t24 * t150, 0.0), 0.0)) / sa2
    t154 = np.sqrt(np.maximum(0.0, t152 - np.where(sa2 != 0.0, np.where(sa2 != 0.0, t153 * t153, 0.0), 0.0)))
    t155 = t149 * t154
    t156 = np.where(sa2 != 0.0, t151 * t153, 0.0)
    t157 = t155 + t156
    t158 = np.where(sa2 != 0.0, t149 * t153, 0.0)
    t159 = t151 * t154
    t160 = t158 - t159
    t161 = np.sqrt((t157 * t157 + t160 * t160))
    t162 = t157 / t161
    t163 = t160 / t161
    t164 = d2 + (np.where(t161 != 0.0, t149 * t162, 0.0) - np.where(t161 != 0.0, t151 * t163, 0.0))
    t165 = t151 * t162 + t149 * t163
    t166 = r2 + (t38 + np.where(t147 != 0.0, np.where(t3 != 0.0, -(sa3 * (d4 * t150)), 0.0), 0.0))
    t167 = sa2 * t166
    t168 = np.where(t161 != 0.0, ca2 * t165, 0.0) - t167
    t169 = x * t164 + y * t168
    t170 = y * t164 - x * t168
    t171 = -t169
    t172 = np.maximum(t169, t171)
    t173 = np.maximum(t170, -t170)
    t174 = np.sqrt((t169 * t169 + t170 * t170)) + np.maximum(t172, t173)
    t175 = np.minimum(t172, t173) / t174
    t176 = t175 / (1 + np.sqrt((1 + np.where(t174 != 0.0, np.where(t174 != 0.0, t175 * t175, 0.0), 0.0))))
    t177 = t176 * t176
    t178 = np.where(t174 != 0.0, np.where(t174 != 0.0, t177 * (np.where(t174 != 0.0, np.where(t174 != 0.0, 0.047619047619047616 * t177, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t179 = np.where(t174 != 0.0, t177 * (np.where(t174 != 0.0, np.where(t174 != 0.0, t177 * (0.058823529411764705 + t178), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t180 = t177 * (np.where(t174 != 0.0, np.where(t174 != 0.0, t177 * (0.07692307692307693 + np.where(t174 != 0.0, t179, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t181 = np.where(t174 != 0.0, np.where(t174 != 0.0, t177 * (0.1111111111111111 + np.where(t174 != 0.0, np.where(t174 != 0.0, t180, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t182 = np.where(t174 != 0.0, np.where(t174 != 0.0, t177 * (0.2 + np.where(t174 != 0.0, np.where(t174 != 0.0, t177 * t181, 0.0), 0.0)), 0.0), 0.0)
    t183 = 4 * t176 * (1 + np.where(t174 != 0.0, np.where(t174 != 0.0, t177 * (t182 - 0.3333333333333333), 0.0), 0.0))
    t184 = 0.5 * np.copysign(1, t173 - t172)
    t185 = np.where(t174 != 0.0, t183 * (0.5 - t184), 0.0) + (0.5 + t184) * (1.5707963267948966 - np.where(t174 != 0.0, t183, 0.0))
    t186 = 0.5 * np.copysign(1, t171)
    t187 = np.copysign((t185 * (0.5 - t186) + (0.5 + t186) * (3.141592653589793 - t185)), t170)
    t188 = np.where(t161 != 0.0, t162, 0.0)
    t189 = -t188
    t190 = np.maximum(t188, t189)
    t191 = np.where(t161 != 0.0, t163, 0.0)
    t192 = np.maximum(t191, -t191)
    t193 = 1 + np.maximum(t190, t192)
    t194 = np.minimum(t190, t192) / t193
    t195 = t194 / (1 + np.sqrt((1 + np.where(t193 != 0.0, np.where(t193 != 0.0, t194 * t194, 0.0), 0.0))))
    t196 = t195 * t195
    t197 = np.where(t193 != 0.0, np.where(t193 != 0.0, t196 * (np.where(t193 != 0.0, np.where(t193 != 0.0, 0.047619047619047616 * t196, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t198 = np.where(t193 != 0.0, t196 * (np.where(t193 != 0.0, np.where(t193 != 0.0, t196 * (0.058823529411764705 + t197), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t199 = t196 * (np.where(t193 != 0.0, np.where(t193 != 0.0, t196 * (0.07692307692307693 + np.where(t193 != 0.0, t198, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t200 = np.where(t193 != 0.0, np.where(t193 != 0.0, t196 * (0.1111111111111111 + np.where(t193 != 0.0, np.where(t193 != 0.0, t199, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t201 = np.where(t193 != 0.0, np.where(t193 != 0.0, t196 * (0.2 + np.where(t193 != 0.0, np.where(t193 != 0.0, t196 * t200, 0.0), 0.0)), 0.0), 0.0)
    t202 = 4 * t195 * (1 + np.where(t193 != 0.0, np.where(t193 != 0.0, t196 * (t201 - 0.3333333333333333), 0.0), 0.0))
    t203 = 0.5 * np.copysign(1, t192 - t190)
    t204 = np.where(t193 != 0.0, t202 * (0.5 - t203), 0.0) + (0.5 + t203) * (1.5707963267948966 - np.where(t193 != 0.0, t202, 0.0))
    t205 = 0.5 * np.copysign(1, t189)
    t206 = np.copysign((t204 * (0.5 - t205) + (0.5 + t205) * (3.141592653589793 - t204)), t191)
    t207 = np.where(t147 != 0.0, t148, 0.0)
    t208 = -t207
    t209 = np.maximum(t207, t208)
    t210 = np.where(t147 != 0.0, np.where(t3 != 0.0, -t150, 0.0), 0.0)
    t211 = np.maximum(t210, -t210)
    t212 = 1 + np.maximum(t209, t211)
    t213 = np.minimum(t209, t211) / t212
    t214 = t213 / (1 + np.sqrt((1 + np.where(t212 != 0.0, np.where(t212 != 0.0, t213 * t213, 0.0), 0.0))))
    t215 = t214 * t214
    t216 = np.where(t212 != 0.0, np.where(t212 != 0.0, t215 * (np.where(t212 != 0.0, np.where(t212 != 0.0, 0.047619047619047616 * t215, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t217 = np.where(t212 != 0.0, t215 * (np.where(t212 != 0.0, np.where(t212 != 0.0, t215 * (0.058823529411764705 + t216), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t218 = t215 * (np.where(t212 != 0.0, np.where(t212 != 0.0, t215 * (0.07692307692307693 + np.where(t212 != 0.0, t217, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t219 = np.where(t212 != 0.0, np.where(t212 != 0.0, t215 * (0.1111111111111111 + np.where(t212 != 0.0, np.where(t212 != 0.0, t218, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t220 = np.where(t212 != 0.0, np.where(t212 != 0.0, t215 * (0.2 + np.where(t212 != 0.0, np.where(t212 != 0.0, t215 * t219, 0.0), 0.0)), 0.0), 0.0)
    t221 = 4 * t214 * (1 + np.where(t212 != 0.0, np.where(t212 != 0.0, t215 * (t220 - 0.3333333333333333), 0.0), 0.0))
    t222 = 0.5 * np.copysign(1, t211 - t209)
    t223 = np.where(t212 != 0.0, t221 * (0.5 - t222), 0.0) + (0.5 + t222) * (1.5707963267948966 - np.where(t212 != 0.0, t221, 0.0))
    t224 = 0.5 * np.copysign(1, t208)
    t225 = np.copysign((t223 * (0.5 - t224) + (0.5 + t224) * (3.141592653589793 - t223)), t210)
    t226 = t156 - t155
    t227 = t158 + t159
    t228 = np.sqrt((t226 * t226 + t227 * t227))
    t229 = t226 / t228
    t230 = t227 / t228
    t231 = d2 + (np.where(t228 != 0.0, t149 * t229, 0.0) - np.where(t228 != 0.0, t151 * t230, 0.0))
    t232 = t151 * t229 + t149 * t230
    t233 = np.where(t228 != 0.0, ca2 * t232, 0.0) - t167
    t234 = x * t231 + y * t233
    t235 = y * t231 - x * t233
    t236 = -t234
    t237 = np.maximum(t234, t236)
    t238 = np.maximum(t235, -t235)
    t239 = np.sqrt((t234 * t234 + t235 * t235)) + np.maximum(t237, t238)
    t240 = np.minimum(t237, t238) / t239
    t241 = t240 / (1 + np.sqrt((1 + np.where(t239 != 0.0, np.where(t239 != 0.0, t240 * t240, 0.0), 0.0))))
    t242 = t241 * t241
    t243 = np.where(t239 != 0.0, np.where(t239 != 0.0, t242 * (np.where(t239 != 0.0, np.where(t239 != 0.0, 0.047619047619047616 * t242, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t244 = np.where(t239 != 0.0, t242 * (np.where(t239 != 0.0, np.where(t239 != 0.0, t242 * (0.058823529411764705 + t243), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t245 = t242 * (np.where(t239 != 0.0, np.where(t239 != 0.0, t242 * (0.07692307692307693 + np.where(t239 != 0.0, t244, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t246 = np.where(t239 != 0.0, np.where(t239 != 0.0, t242 * (0.1111111111111111 + np.where(t239 != 0.0, np.where(t239 != 0.0, t245, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t247 = np.where(t239 != 0.0, np.where(t239 != 0.0, t242 * (0.2 + np.where(t239 != 0.0, np.where(t239 != 0.0, t242 * t246, 0.0), 0.0)), 0.0), 0.0)
    t248 = 4 * t241 * (1 + np.where(t239 != 0.0, np.where(t239 != 0.0, t242 * (t247 - 0.3333333333333333), 0.0), 0.0))
    t249 = 0.5 * np.copysign(1, t238 - t237)
    t250 = np.where(t239 != 0.0, t248 * (0.5 - t249), 0.0) + (0.5 + t249) * (1.5707963267948966 - np.where(t239 != 0.0, t248, 0.0))
    t251 = 0.5 * np.copysign(1, t236)
    t252 = np.copysign((t250 * (0.5 - t251) + (0.5 + t251) * (3.141592653589793 - t250)), t235)
    t253 = np.where(t228 != 0.0, t229, 0.0)
    t254 = -t253
    t255 = np.maximum(t253, t254)
    t256 = np.where(t228 != 0.0, t230, 0.0)
    t257 = np.maximum(t256, -t256)
    t258 = 1 + np.maximum(t255, t257)
    t259 = np.minimum(t255, t257) / t258
    t260 = t259 / (1 + np.sqrt((1 + np.where(t258 != 0.0, np.where(t258 != 0.0, t259 * t259, 0.0), 0.0))))
    t261 = t260 * t260
    t262 = np.where(t258 != 0.0, np.where(t258 != 0.0, t261 * (np.where(t258 != 0.0, np.where(t258 != 0.0, 0.047619047619047616 * t261, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t263 = np.where(t258 != 0.0, t261 * (np.where(t258 != 0.0, np.where(t258 != 0.0, t261 * (0.058823529411764705 + t262), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t264 = t261 * (np.where(t258 != 0.0, np.where(t258 != 0.0, t261 * (0.07692307692307693 + np.where(t258 != 0.0, t263, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t265 = np.where(t258 != 0.0, np.where(t258 != 0.0, t261 * (0.1111111111111111 + np.where(t258 != 0.0, np.where(t258 != 0.0, t264, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t266 = np.where(t258 != 0.0, np.where(t258 != 0.0, t261 * (0.2 + np.where(t258 != 0.0, np.where(t258 != 0.0, t261 * t265, 0.0), 0.0)), 0.0), 0.0)
    t267 = 4 * t260 * (1 + np.where(t258 != 0.0, np.where(t258 != 0.0, t261 * (t266 - 0.3333333333333333), 0.0), 0.0))
    t268 = 0.5 * np.copysign(1, t257 - t255)
    t269 = np.where(t258 != 0.0, t267 * (0.5 - t268), 0.0) + (0.5 + t268) * (1.5707963267948966 - np.where(t258 != 0.0, t267, 0.0))
    t270 = 0.5 * np.copysign(1, t254)
    t271 = np.copysign((t269 * (0.5 - t270) + (0.5 + t270) * (3.141592653589793 - t269)), t256)
    t272 = np.sqrt(t5)
    t273 = np.sqrt((t36 * t36 + t41 * t41)) - t272
    t274 = ca2 * t39
    t275 = np.where(t33 != 0.0, sa2 * t37, 0.0) + t274 - z
    t276 = np.sqrt((t104 * t104 + t106 * t106)) - t272
    t277 = t274 + np.where(t101 != 0.0, sa2 * t105, 0.0) - z
    t278 = np.sqrt((t164 * t164 + t168 * t168)) - t272
    t279 = ca2 * t166
    t280 = np.where(t161 != 0.0, sa2 * t165, 0.0) + t279 - z
    t281 = np.sqrt((t231 * t231 + t233 * t233)) - t272
    t282 = t279 + np.where(t228 != 0.0, sa2 * t232, 0.0) - z

    # results
    angles = np.empty((*_leading, 12), _real)
    closure = np.empty((*_leading, 4), _real)
    width = np.empty((*_leading, 4), _real)
    angles[..., 0] = t60
    angles[..., 1] = t79
    angles[..., 2] = t98
    angles[..., 3] = t125
    angles[..., 4] = t144
    angles[..., 5] = t98
    angles[..., 6] = t187
    angles[..., 7] = t206
    angles[..., 8] = t225
    angles[..., 9] = t252
    angles[..., 10] = t271
    angles[..., 11] = t225
    closure[..., 0] = np.sqrt((t273 * t273 + t275 * t275))
    closure[..., 1] = np.sqrt((t276 * t276 + t277 * t277))
    closure[..., 2] = np.sqrt((t278 * t278 + t280 * t280))
    closure[..., 3] = np.sqrt((t281 * t281 + t282 * t282))
    width[..., 0] = t22
    width[..., 1] = t22
    width[..., 2] = t152
    width[..., 3] = t152
    return angles.reshape(_leading + (4, 3)), closure.reshape(_leading + (4,)), width.reshape(_leading + (4,))


def postures_parallel(parameters, point):
    """the postures of an arm with axes 1 and 2 parallel, the distance each leaves, and W: 1110 operations.

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
    d2 = parameters[..., 4]
    d3 = parameters[..., 5]
    ca2 = parameters[..., 0]
    d4 = parameters[..., 6]
    sa3 = parameters[..., 3]
    z = point[..., 2]
    r2 = parameters[..., 7]
    ca3 = parameters[..., 2]
    r3 = parameters[..., 8]
    x = point[..., 0]
    y = point[..., 1]
    sa2 = parameters[..., 1]

    # terms
    t1 = d2 + d2
    t2 = ca2 * d4 * sa3
    t3 = t2 * t2
    t4 = 1 - np.where(t3 != 0.0, 1, 0.0)
    t5 = z - ca2 * r2 - ca2 * ca3 * r3
    t6 = -(t2 / t3 * np.sqrt(np.maximum(0.0, t3 - t5 * t5)))
    t7 = np.where(t3 != 0.0, t6, 0.0)
    t8 = t4 - t7
    t9 = np.where(t3 != 0.0, -(t2 * t5 / t3), 0.0)
    t10 = t9 * t9
    t11 = np.sqrt((t8 * t8 + t10))
    t12 = t8 / t11
    t13 = d3 + np.where(t11 != 0.0, d4 * t12, 0.0)
    t14 = x * x + y * y
    t15 = t14 + z * z - d2 * d2 - d3 * d3 - d4 * d4
    t16 = t15 - r2 * r2 - r3 * r3 - r3 * (r2 * (ca3 + ca3))
    t17 = d4 * (-2 * d3)
    t18 = sa3 * (r2 * (-2 * d4))
    t19 = t9 / t11
    t20 = t16 + np.where(t11 != 0.0, t12 * t17, 0.0) + np.where(t11 != 0.0, -(t18 * t19), 0.0)
    t21 = t20 / t1
    t22 = np.where(t1 != 0.0, t13 * t21, 0.0)
    t23 = d4 * ca3
    t24 = sa3 * r3
    t25 = np.where(t11 != 0.0, -(t19 * t23), 0.0) - t24
    t26 = t13 * t13 + t25 * t25
    t27 = np.sqrt(np.maximum(0.0, t26 - np.where(t1 != 0.0, np.where(t1 != 0.0, t21 * t21, 0.0), 0.0)))
    t28 = t25 * t27
    t29 = t22 + t28
    t30 = t13 * t27
    t31 = np.where(t1 != 0.0, t21 * t25, 0.0)
    t32 = t30 - t31
    t33 = np.sqrt((t29 * t29 + t32 * t32))
    t34 = t29 / t33
    t35 = t32 / t33
    t36 = d2 + (np.where(t33 != 0.0, t13 * t34, 0.0) - np.where(t33 != 0.0, t25 * t35, 0.0))
    t37 = t25 * t34 + t13 * t35
    t38 = ca3 * r3
    t39 = r2 + (t38 + np.where(t11 != 0.0, -(sa3 * (d4 * t19)), 0.0))
    t40 = sa2 * t39
    t41 = np.where(t33 != 0.0, ca2 * t37, 0.0) - t40
    t42 = x * t36 + y * t41
    t43 = y * t36 - x * t41
    t44 = -t42
    t45 = np.maximum(t42, t44)
    t46 = np.maximum(t43, -t43)
    t47 = np.sqrt((t42 * t42 + t43 * t43)) + np.maximum(t45, t46)
    t48 = np.minimum(t45, t46) / t47
    t49 = t48 / (1 + np.sqrt((1 + np.where(t47 != 0.0, np.where(t47 != 0.0, t48 * t48, 0.0), 0.0))))
    t50 = t49 * t49
    t51 = np.where(t47 != 0.0, np.where(t47 != 0.0, t50 * (np.where(t47 != 0.0, np.where(t47 != 0.0, 0.047619047619047616 * t50, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t52 = np.where(t47 != 0.0, t50 * (np.where(t47 != 0.0, np.where(t47 != 0.0, t50 * (0.058823529411764705 + t51), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t53 = t50 * (np.where(t47 != 0.0, np.where(t47 != 0.0, t50 * (0.07692307692307693 + np.where(t47 != 0.0, t52, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t54 = np.where(t47 != 0.0, np.where(t47 != 0.0, t50 * (0.1111111111111111 + np.where(t47 != 0.0, np.where(t47 != 0.0, t53, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t55 = np.where(t47 != 0.0, np.where(t47 != 0.0, t50 * (0.2 + np.where(t47 != 0.0, np.where(t47 != 0.0, t50 * t54, 0.0), 0.0)), 0.0), 0.0)
    t56 = 4 * t49 * (1 + np.where(t47 != 0.0, np.where(t47 != 0.0, t50 * (t55 - 0.3333333333333333), 0.0), 0.0))
    t57 = 0.5 * np.copysign(1, t46 - t45)
    t58 = np.where(t47 != 0.0, t56 * (0.5 - t57), 0.0) + (0.5 + t57) * (1.5707963267948966 - np.where(t47 != 0.0, t56, 0.0))
    t59 = 0.5 * np.copysign(1, t44)
    t60 = np.copysign((t58 * (0.5 - t59) + (0.5 + t59) * (3.141592653589793 - t58)), t43)
    t61 = np.where(t33 != 0.0, t34, 0.0)
    t62 = -t61
    t63 = np.maximum(t61, t62)
    t64 = np.where(t33 != 0.0, t35, 0.0)
    t65 = np.maximum(t64, -t64)
    t66 = 1 + np.maximum(t63, t65)
    t67 = np.minimum(t63, t65) / t66
    t68 = t67 / (1 + np.sqrt((1 + np.where(t66 != 0.0, np.where(t66 != 0.0, t67 * t67, 0.0), 0.0))))
    t69 = t68 * t68
    t70 = np.where(t66 != 0.0, np.where(t66 != 0.0, t69 * (np.where(t66 != 0.0, np.where(t66 != 0.0, 0.047619047619047616 * t69, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t71 = np.where(t66 != 0.0, t69 * (np.where(t66 != 0.0, np.where(t66 != 0.0, t69 * (0.058823529411764705 + t70), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t72 = t69 * (np.where(t66 != 0.0, np.where(t66 != 0.0, t69 * (0.07692307692307693 + np.where(t66 != 0.0, t71, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t73 = np.where(t66 != 0.0, np.where(t66 != 0.0, t69 * (0.1111111111111111 + np.where(t66 != 0.0, np.where(t66 != 0.0, t72, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t74 = np.where(t66 != 0.0, np.where(t66 != 0.0, t69 * (0.2 + np.where(t66 != 0.0, np.where(t66 != 0.0, t69 * t73, 0.0), 0.0)), 0.0), 0.0)
    t75 = 4 * t68 * (1 + np.where(t66 != 0.0, np.where(t66 != 0.0, t69 * (t74 - 0.3333333333333333), 0.0), 0.0))
    t76 = 0.5 * np.copysign(1, t65 - t63)
    t77 = np.where(t66 != 0.0, t75 * (0.5 - t76), 0.0) + (0.5 + t76) * (1.5707963267948966 - np.where(t66 != 0.0, t75, 0.0))
    t78 = 0.5 * np.copysign(1, t62)
    t79 = np.copysign((t77 * (0.5 - t78) + (0.5 + t78) * (3.141592653589793 - t77)), t64)
    t80 = np.where(t11 != 0.0, t12, 0.0)
    t81 = -t80
    t82 = np.maximum(t80, t81)
    t83 = np.where(t11 != 0.0, -t19, 0.0)
    t84 = np.maximum(t83, -t83)
    t85 = 1 + np.maximum(t82, t84)
    t86 = np.minimum(t82, t84) / t85
    t87 = t86 / (1 + np.sqrt((1 + np.where(t85 != 0.0, np.where(t85 != 0.0, t86 * t86, 0.0), 0.0))))
    t88 = t87 * t87
    t89 = np.where(t85 != 0.0, np.where(t85 != 0.0, t88 * (np.where(t85 != 0.0, np.where(t85 != 0.0, 0.047619047619047616 * t88, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t90 = np.where(t85 != 0.0, t88 * (np.where(t85 != 0.0, np.where(t85 != 0.0, t88 * (0.058823529411764705 + t89), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t91 = t88 * (np.where(t85 != 0.0, np.where(t85 != 0.0, t88 * (0.07692307692307693 + np.where(t85 != 0.0, t90, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t92 = np.where(t85 != 0.0, np.where(t85 != 0.0, t88 * (0.1111111111111111 + np.where(t85 != 0.0, np.where(t85 != 0.0, t91, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t93 = np.where(t85 != 0.0, np.where(t85 != 0.0, t88 * (0.2 + np.where(t85 != 0.0, np.where(t85 != 0.0, t88 * t92, 0.0), 0.0)), 0.0), 0.0)
    t94 = 4 * t87 * (1 + np.where(t85 != 0.0, np.where(t85 != 0.0, t88 * (t93 - 0.3333333333333333), 0.0), 0.0))
    t95 = 0.5 * np.copysign(1, t84 - t82)
    t96 = np.where(t85 != 0.0, t94 * (0.5 - t95), 0.0) + (0.5 + t95) * (1.5707963267948966 - np.where(t85 != 0.0, t94, 0.0))
    t97 = 0.5 * np.copysign(1, t81)
    t98 = np.copysign((t96 * (0.5 - t97) + (0.5 + t97) * (3.141592653589793 - t96)), t83)
    t99 = t22 - t28
    t100 = t30 + t31
    t101 = np.sqrt((t99 * t99 + t100 * t100))
    t102 = t99 / t101
    t103 = t100 / t101
    t104 = d2 + (np.where(t101 != 0.0, t13 * t102, 0.0) - np.where(t101 != 0.0, -(t25 * t103), 0.0))
    t105 = t25 * t102 - t13 * t103
    t106 = np.where(t101 != 0.0, ca2 * t105, 0.0) - t40
    t107 = x * t104 + y * t106
    t108 = y * t104 - x * t106
    t109 = -t107
    t110 = np.maximum(t107, t109)
    t111 = np.maximum(t108, -t108)
    t112 = np.sqrt((t107 * t107 + t108 * t108)) + np.maximum(t110, t111)
    t113 = np.minimum(t110, t111) / t112
    t114 = t113 / (1 + np.sqrt((1 + np.where(t112 != 0.0, np.where(t112 != 0.0, t113 * t113, 0.0), 0.0))))
    t115 = t114 * t114
    t116 = np.where(t112 != 0.0, np.where(t112 != 0.0, t115 * (np.where(t112 != 0.0, np.where(t112 != 0.0, 0.047619047619047616 * t115, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t117 = np.where(t112 != 0.0, t115 * (np.where(t112 != 0.0, np.where(t112 != 0.0, t115 * (0.058823529411764705 + t116), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t118 = t115 * (np.where(t112 != 0.0, np.where(t112 != 0.0, t115 * (0.07692307692307693 + np.where(t112 != 0.0, t117, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t119 = np.where(t112 != 0.0, np.where(t112 != 0.0, t115 * (0.1111111111111111 + np.where(t112 != 0.0, np.where(t112 != 0.0, t118, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t120 = np.where(t112 != 0.0, np.where(t112 != 0.0, t115 * (0.2 + np.where(t112 != 0.0, np.where(t112 != 0.0, t115 * t119, 0.0), 0.0)), 0.0), 0.0)
    t121 = 4 * t114 * (1 + np.where(t112 != 0.0, np.where(t112 != 0.0, t115 * (t120 - 0.3333333333333333), 0.0), 0.0))
    t122 = 0.5 * np.copysign(1, t111 - t110)
    t123 = np.where(t112 != 0.0, t121 * (0.5 - t122), 0.0) + (0.5 + t122) * (1.5707963267948966 - np.where(t112 != 0.0, t121, 0.0))
    t124 = 0.5 * np.copysign(1, t109)
    t125 = np.copysign((t123 * (0.5 - t124) + (0.5 + t124) * (3.141592653589793 - t123)), t108)
    t126 = np.where(t101 != 0.0, t102, 0.0)
    t127 = -t126
    t128 = np.maximum(t126, t127)
    t129 = np.where(t101 != 0.0, -t103, 0.0)
    t130 = np.maximum(t129, -t129)
    t131 = 1 + np.maximum(t128, t130)
    t132 = np.minimum(t128, t130) / t131
    t133 = t132 / (1 + np.sqrt((1 + np.where(t131 != 0.0, np.where(t131 != 0.0, t132 * t132, 0.0), 0.0))))
    t134 = t133 * t133
    t135 = np.where(t131 != 0.0, np.where(t131 != 0.0, t134 * (np.where(t131 != 0.0, np.where(t131 != 0.0, 0.047619047619047616 * t134, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t136 = np.where(t131 != 0.0, t134 * (np.where(t131 != 0.0, np.where(t131 != 0.0, t134 * (0.058823529411764705 + t135), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t137 = t134 * (np.where(t131 != 0.0, np.where(t131 != 0.0, t134 * (0.07692307692307693 + np.where(t131 != 0.0, t136, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t138 = np.where(t131 != 0.0, np.where(t131 != 0.0, t134 * (0.1111111111111111 + np.where(t131 != 0.0, np.where(t131 != 0.0, t137, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t139 = np.where(t131 != 0.0, np.where(t131 != 0.0, t134 * (0.2 + np.where(t131 != 0.0, np.where(t131 != 0.0, t134 * t138, 0.0), 0.0)), 0.0), 0.0)
    t140 = 4 * t133 * (1 + np.where(t131 != 0.0, np.where(t131 != 0.0, t134 * (t139 - 0.3333333333333333), 0.0), 0.0))
    t141 = 0.5 * np.copysign(1, t130 - t128)
    t142 = np.where(t131 != 0.0, t140 * (0.5 - t141), 0.0) + (0.5 + t141) * (1.5707963267948966 - np.where(t131 != 0.0, t140, 0.0))
    t143 = 0.5 * np.copysign(1, t127)
    t144 = np.copysign((t142 * (0.5 - t143) + (0.5 + t143) * (3.141592653589793 - t142)), t129)
    t145 = t4 + t7
    t146 = np.sqrt((t10 + t145 * t145))
    t147 = t145 / t146
    t148 = d3 + np.where(t146 != 0.0, d4 * t147, 0.0)
    t149 = t9 / t146
    t150 = t16 + np.where(t146 != 0.0, t17 * t147, 0.0) + np.where(t146 != 0.0, -(t18 * t149), 0.0)
    t151 = t150 / t1
    t152 = np.where(t1 != 0.0, t148 * t151, 0.0)
    t153 = np.where(t146 != 0.0, -(t23 * t149), 0.0) - t24
    t154 = t148 * t148 + t153 * t153
    t155 = np.sqrt(np.maximum(0.0, t154 - np.where(t1 != 0.0, np.where(t1 != 0.0, t151 * t151, 0.0), 0.0)))
    t156 = t153 * t155
    t157 = t152 + t156
    t158 = t148 * t155
    t159 = np.where(t1 != 0.0, t151 * t153, 0.0)
    t160 = t158 - t159
    t161 = np.sqrt((t157 * t157 + t160 * t160))
    t162 = t157 / t161
    t163 = t160 / t161
    t164 = d2 + (np.where(t161 != 0.0, t148 * t162, 0.0) - np.where(t161 != 0.0, t153 * t163, 0.0))
    t165 = t153 * t162 + t148 * t163
    t166 = r2 + (t38 + np.where(t146 != 0.0, -(sa3 * (d4 * t149)), 0.0))
    t167 = sa2 * t166
    t168 = np.where(t161 != 0.0, ca2 * t165, 0.0) - t167
    t169 = x * t164 + y * t168
    t170 = y * t164 - x * t168
    t171 = -t169
    t172 = np.maximum(t169, t171)
    t173 = np.maximum(t170, -t170)
    t174 = np.sqrt((t169 * t169 + t170 * t170)) + np.maximum(t172, t173)
    t175 = np.minimum(t172, t173) / t174
    t176 = t175 / (1 + np.sqrt((1 + np.where(t174 != 0.0, np.where(t174 != 0.0, t175 * t175, 0.0), 0.0))))
    t177 = t176 * t176
    t178 = np.where(t174 != 0.0, np.where(t174 != 0.0, t177 * (np.where(t174 != 0.0, np.where(t174 != 0.0, 0.047619047619047616 * t177, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t179 = np.where(t174 != 0.0, t177 * (np.where(t174 != 0.0, np.where(t174 != 0.0, t177 * (0.058823529411764705 + t178), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t180 = t177 * (np.where(t174 != 0.0, np.where(t174 != 0.0, t177 * (0.07692307692307693 + np.where(t174 != 0.0, t179, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t181 = np.where(t174 != 0.0, np.where(t174 != 0.0, t177 * (0.1111111111111111 + np.where(t174 != 0.0, np.where(t174 != 0.0, t180, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t182 = np.where(t174 != 0.0, np.where(t174 != 0.0, t177 * (0.2 + np.where(t174 != 0.0, np.where(t174 != 0.0, t177 * t181, 0.0), 0.0)), 0.0), 0.0)
    t183 = 4 * t176 * (1 + np.where(t174 != 0.0, np.where(t174 != 0.0, t177 * (t182 - 0.3333333333333333), 0.0), 0.0))
    t184 = 0.5 * np.copysign(1, t173 - t172)
    t185 = np.where(t174 != 0.0, t183 * (0.5 - t184), 0.0) + (0.5 + t184) * (1.5707963267948966 - np.where(t174 != 0.0, t183, 0.0))
    t186 = 0.5 * np.copysign(1, t171)
    t187 = np.copysign((t185 * (0.5 - t186) + (0.5 + t186) * (3.141592653589793 - t185)), t170)
    t188 = np.where(t161 != 0.0, t162, 0.0)
    t189 = -t188
    t190 = np.maximum(t188, t189)
    t191 = np.where(t161 != 0.0, t163, 0.0)
    t192 = np.maximum(t191, -t191)
    t193 = 1 + np.maximum(t190, t192)
    t194 = np.minimum(t190, t192) / t193
    t195 = t194 / (1 + np.sqrt((1 + np.where(t193 != 0.0, np.where(t193 != 0.0, t194 * t194, 0.0), 0.0))))
    t196 = t195 * t195
    t197 = np.where(t193 != 0.0, np.where(t193 != 0.0, t196 * (np.where(t193 != 0.0, np.where(t193 != 0.0, 0.047619047619047616 * t196, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t198 = np.where(t193 != 0.0, t196 * (np.where(t193 != 0.0, np.where(t193 != 0.0, t196 * (0.058823529411764705 + t197), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t199 = t196 * (np.where(t193 != 0.0, np.where(t193 != 0.0, t196 * (0.07692307692307693 + np.where(t193 != 0.0, t198, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t200 = np.where(t193 != 0.0, np.where(t193 != 0.0, t196 * (0.1111111111111111 + np.where(t193 != 0.0, np.where(t193 != 0.0, t199, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t201 = np.where(t193 != 0.0, np.where(t193 != 0.0, t196 * (0.2 + np.where(t193 != 0.0, np.where(t193 != 0.0, t196 * t200, 0.0), 0.0)), 0.0), 0.0)
    t202 = 4 * t195 * (1 + np.where(t193 != 0.0, np.where(t193 != 0.0, t196 * (t201 - 0.3333333333333333), 0.0), 0.0))
    t203 = 0.5 * np.copysign(1, t192 - t190)
    t204 = np.where(t193 != 0.0, t202 * (0.5 - t203), 0.0) + (0.5 + t203) * (1.5707963267948966 - np.where(t193 != 0.0, t202, 0.0))
    t205 = 0.5 * np.copysign(1, t189)
    t206 = np.copysign((t204 * (0.5 - t205) + (0.5 + t205) * (3.141592653589793 - t204)), t191)
    t207 = np.where(t146 != 0.0, t147, 0.0)
    t208 = -t207
    t209 = np.maximum(t207, t208)
    t210 = np.where(t146 != 0.0, -t149, 0.0)
    t211 = np.maximum(t210, -t210)
    t212 = 1 + np.maximum(t209, t211)
    t213 = np.minimum(t209, t211) / t212
    t214 = t213 / (1 + np.sqrt((1 + np.where(t212 != 0.0, np.where(t212 != 0.0, t213 * t213, 0.0), 0.0))))
    t215 = t214 * t214
    t216 = np.where(t212 != 0.0, np.where(t212 != 0.0, t215 * (np.where(t212 != 0.0, np.where(t212 != 0.0, 0.047619047619047616 * t215, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t217 = np.where(t212 != 0.0, t215 * (np.where(t212 != 0.0, np.where(t212 != 0.0, t215 * (0.058823529411764705 + t216), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t218 = t215 * (np.where(t212 != 0.0, np.where(t212 != 0.0, t215 * (0.07692307692307693 + np.where(t212 != 0.0, t217, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t219 = np.where(t212 != 0.0, np.where(t212 != 0.0, t215 * (0.1111111111111111 + np.where(t212 != 0.0, np.where(t212 != 0.0, t218, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t220 = np.where(t212 != 0.0, np.where(t212 != 0.0, t215 * (0.2 + np.where(t212 != 0.0, np.where(t212 != 0.0, t215 * t219, 0.0), 0.0)), 0.0), 0.0)
    t221 = 4 * t214 * (1 + np.where(t212 != 0.0, np.where(t212 != 0.0, t215 * (t220 - 0.3333333333333333), 0.0), 0.0))
    t222 = 0.5 * np.copysign(1, t211 - t209)
    t223 = np.where(t212 != 0.0, t221 * (0.5 - t222), 0.0) + (0.5 + t222) * (1.5707963267948966 - np.where(t212 != 0.0, t221, 0.0))
    t224 = 0.5 * np.copysign(1, t208)
    t225 = np.copysign((t223 * (0.5 - t224) + (0.5 + t224) * (3.141592653589793 - t223)), t210)
    t226 = t152 - t156
    t227 = t158 + t159
    t228 = np.sqrt((t226 * t226 + t227 * t227))
    t229 = t226 / t228
    t230 = t227 / t228
    t231 = d2 + (np.where(t228 != 0.0, t148 * t229, 0.0) - np.where(t228 != 0.0, -(t153 * t230), 0.0))
    t232 = t153 * t229 - t148 * t230
    t233 = np.where(t228 != 0.0, ca2 * t232, 0.0) - t167
    t234 = x * t231 + y * t233
    t235 = y * t231 - x * t233
    t236 = -t234
    t237 = np.maximum(t234, t236)
    t238 = np.maximum(t235, -t235)
    t239 = np.sqrt((t234 * t234 + t235 * t235)) + np.maximum(t237, t238)
    t240 = np.minimum(t237, t238) / t239
    t241 = t240 / (1 + np.sqrt((1 + np.where(t239 != 0.0, np.where(t239 != 0.0, t240 * t240, 0.0), 0.0))))
    t242 = t241 * t241
    t243 = np.where(t239 != 0.0, np.where(t239 != 0.0, t242 * (np.where(t239 != 0.0, np.where(t239 != 0.0, 0.047619047619047616 * t242, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t244 = np.where(t239 != 0.0, t242 * (np.where(t239 != 0.0, np.where(t239 != 0.0, t242 * (0.058823529411764705 + t243), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t245 = t242 * (np.where(t239 != 0.0, np.where(t239 != 0.0, t242 * (0.07692307692307693 + np.where(t239 != 0.0, t244, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t246 = np.where(t239 != 0.0, np.where(t239 != 0.0, t242 * (0.1111111111111111 + np.where(t239 != 0.0, np.where(t239 != 0.0, t245, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t247 = np.where(t239 != 0.0, np.where(t239 != 0.0, t242 * (0.2 + np.where(t239 != 0.0, np.where(t239 != 0.0, t242 * t246, 0.0), 0.0)), 0.0), 0.0)
    t248 = 4 * t241 * (1 + np.where(t239 != 0.0, np.where(t239 != 0.0, t242 * (t247 - 0.3333333333333333), 0.0), 0.0))
    t249 = 0.5 * np.copysign(1, t238 - t237)
    t250 = np.where(t239 != 0.0, t248 * (0.5 - t249), 0.0) + (0.5 + t249) * (1.5707963267948966 - np.where(t239 != 0.0, t248, 0.0))
    t251 = 0.5 * np.copysign(1, t236)
    t252 = np.copysign((t250 * (0.5 - t251) + (0.5 + t251) * (3.141592653589793 - t250)), t235)
    t253 = np.where(t228 != 0.0, t229, 0.0)
    t254 = -t253
    t255 = np.maximum(t253, t254)
    t256 = np.where(t228 != 0.0, -t230, 0.0)
    t257 = np.maximum(t256, -t256)
    t258 = 1 + np.maximum(t255, t257)
    t259 = np.minimum(t255, t257) / t258
    t260 = t259 / (1 + np.sqrt((1 + np.where(t258 != 0.0, np.where(t258 != 0.0, t259 * t259, 0.0), 0.0))))
    t261 = t260 * t260
    t262 = np.where(t258 != 0.0, np.where(t258 != 0.0, t261 * (np.where(t258 != 0.0, np.where(t258 != 0.0, 0.047619047619047616 * t261, 0.0), 0.0) - 0.05263157894736842), 0.0), 0.0)
    t263 = np.where(t258 != 0.0, t261 * (np.where(t258 != 0.0, np.where(t258 != 0.0, t261 * (0.058823529411764705 + t262), 0.0), 0.0) - 0.06666666666666667), 0.0)
    t264 = t261 * (np.where(t258 != 0.0, np.where(t258 != 0.0, t261 * (0.07692307692307693 + np.where(t258 != 0.0, t263, 0.0)), 0.0), 0.0) - 0.09090909090909091)
    t265 = np.where(t258 != 0.0, np.where(t258 != 0.0, t261 * (0.1111111111111111 + np.where(t258 != 0.0, np.where(t258 != 0.0, t264, 0.0), 0.0)), 0.0), 0.0) - 0.14285714285714285
    t266 = np.where(t258 != 0.0, np.where(t258 != 0.0, t261 * (0.2 + np.where(t258 != 0.0, np.where(t258 != 0.0, t261 * t265, 0.0), 0.0)), 0.0), 0.0)
    t267 = 4 * t260 * (1 + np.where(t258 != 0.0, np.where(t258 != 0.0, t261 * (t266 - 0.3333333333333333), 0.0), 0.0))
    t268 = 0.5 * np.copysign(1, t257 - t255)
    t269 = np.where(t258 != 0.0, t267 * (0.5 - t268), 0.0) + (0.5 + t268) * (1.5707963267948966 - np.where(t258 != 0.0, t267, 0.0))
    t270 = 0.5 * np.copysign(1, t254)
    t271 = np.copysign((t269 * (0.5 - t270) + (0.5 + t270) * (3.141592653589793 - t269)), t256)
    t272 = np.sqrt(t14)
    t273 = np.sqrt((t36 * t36 + t41 * t41)) - t272
    t274 = ca2 * t39
    t275 = np.where(t33 != 0.0, t37 * sa2, 0.0) + t274 - z
    t276 = np.sqrt((t104 * t104 + t106 * t106)) - t272
    t277 = t274 + np.where(t101 != 0.0, sa2 * t105, 0.0) - z
    t278 = np.sqrt((t164 * t164 + t168 * t168)) - t272
    t279 = ca2 * t166
    t280 = np.where(t161 != 0.0, sa2 * t165, 0.0) + t279 - z
    t281 = np.sqrt((t231 * t231 + t233 * t233)) - t272
    t282 = t279 + np.where(t228 != 0.0, sa2 * t232, 0.0) - z

    # results
    angles = np.empty((*_leading, 12), _real)
    closure = np.empty((*_leading, 4), _real)
    width = np.empty((*_leading, 4), _real)
    angles[..., 0] = t60
    angles[..., 1] = t79
    angles[..., 2] = t98
    angles[..., 3] = t125
    angles[..., 4] = t144
    angles[..., 5] = t98
    angles[..., 6] = t187
    angles[..., 7] = t206
    angles[..., 8] = t225
    angles[..., 9] = t252
    angles[..., 10] = t271
    angles[..., 11] = t225
    closure[..., 0] = np.sqrt((t273 * t273 + t275 * t275))
    closure[..., 1] = np.sqrt((t276 * t276 + t277 * t277))
    closure[..., 2] = np.sqrt((t278 * t278 + t280 * t280))
    closure[..., 3] = np.sqrt((t281 * t281 + t282 * t282))
    width[..., 0] = t26
    width[..., 1] = t26
    width[..., 2] = t154
    width[..., 3] = t154
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
