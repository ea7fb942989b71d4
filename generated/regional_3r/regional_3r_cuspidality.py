"""cuspidality of regional_3r, in NumPy.

Made from templates/kernel.py.j2; inputs 8d193ae39ce211c69348e917a1b03f05ad981f63f6f63d7069e554f45f496e9c.
3500 operations. Do not edit: change the derivation and regenerate.

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
    """two pairs of postures at a point, the room of each (real if positive), the distances left, the slopes of E: 1549 operations.

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
    t13 = t11 * sa2
    t14 = t12 * sa2
    t15 = 4 * t6 * (sa2 * sa2)
    t16 = t13 * t14 - 0.5 * (d4 * (d3 + d3)) * t15
    t17 = z - r2 * ca2 - r3 * (ca3 * ca2)
    t18 = t1 * t17
    t19 = 0.5 * (t14 * t14)
    t20 = r2 * (-2 * d4)
    t21 = sa2 * t20 * sa3
    t22 = 0.5 * (t21 * t21)
    t23 = sa3 * (d4 * (d2 * (-2 * ca2)))
    t24 = 0.5 * (t23 * t23)
    t25 = ca3 * ca3
    t26 = t13 * t13 + t18 * t18 + t19 + t22 + t24 - t15 * (t7 + t8 * t25 + t10 * (sa3 * sa3))
    t27 = t15 * (0.5 * (t8 * (1 - t25)))
    t28 = t26 - t27
    t29 = t19 - t22 - t24 - t27
    t30 = np.maximum(t28, -t28) + np.maximum(t16, -t16) + np.maximum(t29, -t29)
    t31 = t14 * t21
    t32 = t13 * t21 + t18 * t23 - t15 * (0.5 * (sa3 * (r3 * (d4 * (-2 * ca3)))))
    t33 = t30 + np.maximum(t31, -t31) + np.maximum(t32, -t32)
    t34 = np.where(t33 != 0.0, 1, 0.0)
    t35 = t34 / (t33 + (1 - t34))
    t36 = t16 * t35
    t37 = t29 * t35
    t38 = t37 + np.copysign(1e-17, t37)
    t39 = 0.5 + 0.5 * np.copysign(1, t38)
    t40 = t31 * t35
    t41 = t40 * t40
    t42 = np.sqrt((t38 * t38 + t41))
    t43 = 0.7071067811865476 * np.sqrt(((t42 + np.maximum(t38, -t38)) / t42))
    t44 = 1 - t39
    t45 = 0.5 * t40 / t43 / t42
    t46 = np.where(t39 != 0.0, t43, 0.0) + np.where(t44 != 0.0, t45, 0.0)
    t47 = t32 * t35
    t48 = np.where(t39 != 0.0, t45, 0.0) + np.where(t44 != 0.0, t43, 0.0)
    t49 = t36 * t46 + t47 * t48
    t50 = t46 * t47 - t36 * t48
    t51 = t28 * t35
    t52 = 0.5 * np.copysign(1, t49 * t49 - t50 * t50 - t42 * t51)
    t53 = 0.5 + t52
    t54 = 0.5 / t42
    t55 = t42 + t42
    t56 = 1 - t53
    t57 = np.where(t53 != 0.0, t49, 0.0) + np.where(t56 != 0.0, -t50, 0.0)
    t58 = np.where(t53 != 0.0, t50, 0.0) + np.where(t56 != 0.0, -t49, 0.0)
    t59 = t58 * t58
    t60 = t42 * (t59 + t59)
    t61 = t57 * t57
    t62 = t51 * (t53 + t53 - 1)
    t63 = t59 + t61 - t55 * (t62 - t42)
    t64 = t62 - 3 * t42
    t65 = t42 * (t63 + t42 * (t42 + t64))
    t66 = np.where(t65 != 0.0, 1, 0.0)
    t67 = np.minimum(t42, t42 * t60 * (t66 / (t65 + (1 - t66))))
    t68 = t67 * (t63 + t67 * (t64 + t67)) - t60
    t69 = t64 + t64
    t70 = t63 + t67 * (t69 + 3 * t67)
    t71 = np.where(t70 != 0.0, 1, 0.0)
    t72 = t67 - t68 * (t71 / (t70 + (1 - t71)))
    t73 = 0.5 + 0.5 * np.copysign(1, t68)
    t74 = 1 - t73
    t75 = np.where(t73 != 0.0, t67, 0.0) + np.where(t74 != 0.0, t42, 0.0)
    t76 = np.where(t74 != 0.0, t67, 0.0)
    t77 = np.where((t72 - np.minimum(t75, np.maximum(t72, t76))) != 0.0, 1, 0.0)
    t78 = np.where(t77 != 0.0, 0.5 * t75 + np.where(t74 != 0.0, 0.5 * t67, 0.0), 0.0) + np.where((1 - t77) != 0.0, t72, 0.0)
    t79 = t78 * (t63 + t78 * (t64 + t78)) - t60
    t80 = t63 + t78 * (t69 + 3 * t78)
    t81 = np.where(t80 != 0.0, 1, 0.0)
    t82 = t78 - t79 * (t81 / (t80 + (1 - t81)))
    t83 = 0.5 + 0.5 * np.copysign(1, t79)
    t84 = 1 - t83
    t85 = np.where(t83 != 0.0, t78, 0.0) + np.where(t84 != 0.0, t75, 0.0)
    t86 = np.where(t83 != 0.0, t76, 0.0) + np.where(t84 != 0.0, t78, 0.0)
    t87 = np.where((t82 - np.minimum(t85, np.maximum(t82, t86))) != 0.0, 1, 0.0)
    t88 = np.where(t87 != 0.0, 0.5 * t85 + 0.5 * t86, 0.0) + np.where((1 - t87) != 0.0, t82, 0.0)
    t89 = t88 * (t63 + t88 * (t64 + t88)) - t60
    t90 = t63 + t88 * (t69 + 3 * t88)
    t91 = np.where(t90 != 0.0, 1, 0.0)
    t92 = t88 - t89 * (t91 / (t90 + (1 - t91)))
    t93 = 0.5 + 0.5 * np.copysign(1, t89)
    t94 = 1 - t93
    t95 = np.where(t93 != 0.0, t88, 0.0) + np.where(t94 != 0.0, t85, 0.0)
    t96 = np.where(t93 != 0.0, t86, 0.0) + np.where(t94 != 0.0, t88, 0.0)
    t97 = np.where((t92 - np.minimum(t95, np.maximum(t92, t96))) != 0.0, 1, 0.0)
    t98 = np.where(t97 != 0.0, 0.5 * t95 + 0.5 * t96, 0.0) + np.where((1 - t97) != 0.0, t92, 0.0)
    t99 = t98 * (t63 + t98 * (t64 + t98)) - t60
    t100 = t63 + t98 * (t69 + 3 * t98)
    t101 = np.where(t100 != 0.0, 1, 0.0)
    t102 = t98 - t99 * (t101 / (t100 + (1 - t101)))
    t103 = 0.5 + 0.5 * np.copysign(1, t99)
    t104 = 1 - t103
    t105 = np.where(t103 != 0.0, t98, 0.0) + np.where(t104 != 0.0, t95, 0.0)
    t106 = np.where(t103 != 0.0, t96, 0.0) + np.where(t104 != 0.0, t98, 0.0)
    t107 = np.where((t102 - np.minimum(t105, np.maximum(t102, t106))) != 0.0, 1, 0.0)
    t108 = np.where(t107 != 0.0, 0.5 * t105 + 0.5 * t106, 0.0) + np.where((1 - t107) != 0.0, t102, 0.0)
    t109 = t108 * (t63 + t108 * (t64 + t108)) - t60
    t110 = t63 + t108 * (t69 + 3 * t108)
    t111 = np.where(t110 != 0.0, 1, 0.0)
    t112 = t108 - t109 * (t111 / (t110 + (1 - t111)))
    t113 = 0.5 + 0.5 * np.copysign(1, t109)
    t114 = 1 - t113
    t115 = np.where(t113 != 0.0, t108, 0.0) + np.where(t114 != 0.0, t105, 0.0)
    t116 = np.where(t113 != 0.0, t106, 0.0) + np.where(t114 != 0.0, t108, 0.0)
    t117 = np.where((t112 - np.minimum(t115, np.maximum(t112, t116))) != 0.0, 1, 0.0)
    t118 = np.where(t117 != 0.0, 0.5 * t115 + 0.5 * t116, 0.0) + np.where((1 - t117) != 0.0, t112, 0.0)
    t119 = t118 * (t63 + t118 * (t64 + t118)) - t60
    t120 = t63 + t118 * (t69 + 3 * t118)
    t121 = np.where(t120 != 0.0, 1, 0.0)
    t122 = t118 - t119 * (t121 / (t120 + (1 - t121)))
    t123 = 0.5 + 0.5 * np.copysign(1, t119)
    t124 = 1 - t123
    t125 = np.where(t123 != 0.0, t118, 0.0) + np.where(t124 != 0.0, t115, 0.0)
    t126 = np.where(t123 != 0.0, t116, 0.0) + np.where(t124 != 0.0, t118, 0.0)
    t127 = np.where((t122 - np.minimum(t125, np.maximum(t122, t126))) != 0.0, 1, 0.0)
    t128 = np.where(t127 != 0.0, 0.5 * t125 + 0.5 * t126, 0.0) + np.where((1 - t127) != 0.0, t122, 0.0)
    t129 = t128 * (t63 + t128 * (t64 + t128)) - t60
    t130 = t63 + t128 * (t69 + 3 * t128)
    t131 = np.where(t130 != 0.0, 1, 0.0)
    t132 = t128 - t129 * (t131 / (t130 + (1 - t131)))
    t133 = 0.5 + 0.5 * np.copysign(1, t129)
    t134 = 1 - t133
    t135 = np.where(t133 != 0.0, t128, 0.0) + np.where(t134 != 0.0, t125, 0.0)
    t136 = np.where(t133 != 0.0, t126, 0.0) + np.where(t134 != 0.0, t128, 0.0)
    t137 = np.where((t132 - np.minimum(t135, np.maximum(t132, t136))) != 0.0, 1, 0.0)
    t138 = np.where(t137 != 0.0, 0.5 * t135 + 0.5 * t136, 0.0) + np.where((1 - t137) != 0.0, t132, 0.0)
    t139 = t138 * (t63 + t138 * (t64 + t138)) - t60
    t140 = t63 + t138 * (t69 + 3 * t138)
    t141 = np.where(t140 != 0.0, 1, 0.0)
    t142 = t138 - t139 * (t141 / (t140 + (1 - t141)))
    t143 = 0.5 + 0.5 * np.copysign(1, t139)
    t144 = 1 - t143
    t145 = np.where(t143 != 0.0, t138, 0.0) + np.where(t144 != 0.0, t135, 0.0)
    t146 = np.where(t143 != 0.0, t136, 0.0) + np.where(t144 != 0.0, t138, 0.0)
    t147 = np.where((t142 - np.minimum(t145, np.maximum(t142, t146))) != 0.0, 1, 0.0)
    t148 = np.where(t147 != 0.0, 0.5 * t145 + 0.5 * t146, 0.0) + np.where((1 - t147) != 0.0, t142, 0.0)
    t149 = t148 * (t63 + t148 * (t64 + t148)) - t60
    t150 = t63 + t148 * (t69 + 3 * t148)
    t151 = np.where(t150 != 0.0, 1, 0.0)
    t152 = t148 - t149 * (t151 / (t150 + (1 - t151)))
    t153 = 0.5 + 0.5 * np.copysign(1, t149)
    t154 = 1 - t153
    t155 = np.where(t153 != 0.0, t148, 0.0) + np.where(t154 != 0.0, t145, 0.0)
    t156 = np.where(t153 != 0.0, t146, 0.0) + np.where(t154 != 0.0, t148, 0.0)
    t157 = np.where((t152 - np.minimum(t155, np.maximum(t152, t156))) != 0.0, 1, 0.0)
    t158 = np.where(t157 != 0.0, 0.5 * t155 + 0.5 * t156, 0.0) + np.where((1 - t157) != 0.0, t152, 0.0)
    t159 = t158 * (t63 + t158 * (t64 + t158)) - t60
    t160 = t63 + t158 * (t69 + 3 * t158)
    t161 = np.where(t160 != 0.0, 1, 0.0)
    t162 = t158 - t159 * (t161 / (t160 + (1 - t161)))
    t163 = 0.5 + 0.5 * np.copysign(1, t159)
    t164 = 1 - t163
    t165 = np.where(t163 != 0.0, t158, 0.0) + np.where(t164 != 0.0, t155, 0.0)
    t166 = np.where(t163 != 0.0, t156, 0.0) + np.where(t164 != 0.0, t158, 0.0)
    t167 = np.where((t162 - np.minimum(t165, np.maximum(t162, t166))) != 0.0, 1, 0.0)
    t168 = np.where(t167 != 0.0, 0.5 * t165 + 0.5 * t166, 0.0) + np.where((1 - t167) != 0.0, t162, 0.0)
    t169 = t168 * (t63 + t168 * (t64 + t168)) - t60
    t170 = t63 + t168 * (t69 + 3 * t168)
    t171 = np.where(t170 != 0.0, 1, 0.0)
    t172 = t168 - t169 * (t171 / (t170 + (1 - t171)))
    t173 = 0.5 + 0.5 * np.copysign(1, t169)
    t174 = 1 - t173
    t175 = np.where(t173 != 0.0, t168, 0.0) + np.where(t174 != 0.0, t165, 0.0)
    t176 = np.where(t173 != 0.0, t166, 0.0) + np.where(t174 != 0.0, t168, 0.0)
    t177 = np.where((t172 - np.minimum(t175, np.maximum(t172, t176))) != 0.0, 1, 0.0)
    t178 = np.where(t177 != 0.0, 0.5 * t175 + 0.5 * t176, 0.0) + np.where((1 - t177) != 0.0, t172, 0.0)
    t179 = t178 * (t63 + t178 * (t64 + t178)) - t60
    t180 = t63 + t178 * (t69 + 3 * t178)
    t181 = np.where(t180 != 0.0, 1, 0.0)
    t182 = t178 - t179 * (t181 / (t180 + (1 - t181)))
    t183 = 0.5 + 0.5 * np.copysign(1, t179)
    t184 = 1 - t183
    t185 = np.where(t183 != 0.0, t178, 0.0) + np.where(t184 != 0.0, t175, 0.0)
    t186 = np.where(t183 != 0.0, t176, 0.0) + np.where(t184 != 0.0, t178, 0.0)
    t187 = np.where((t182 - np.minimum(t185, np.maximum(t182, t186))) != 0.0, 1, 0.0)
    t188 = np.where(t187 != 0.0, 0.5 * t185 + 0.5 * t186, 0.0) + np.where((1 - t187) != 0.0, t182, 0.0)
    t189 = t55 - t188
    t190 = np.sqrt(t189)
    t191 = t57 / t190
    t192 = 0.5 + 0.5 * np.copysign(1, t188 - 1e-25)
    t193 = np.sqrt(t188)
    t194 = np.where(t193 != 0.0, 1, 0.0)
    t195 = np.copysign(np.sqrt(np.maximum(0.0, t42 + t61 / t189 - t62 - t188)), t58)
    t196 = np.where(t192 != 0.0, t58 * (t194 / (t193 + (1 - t194))), 0.0) + np.where((1 - t192) != 0.0, t195, 0.0)
    t197 = t191 + t196
    t198 = t55 - t197 * t197
    t199 = np.sqrt(np.maximum(0.0, t198))
    t200 = t193 * t199
    t201 = t190 * t197
    t202 = t54 * (t200 - t201)
    t203 = t193 * t197
    t204 = t190 * t199
    t205 = t54 * (t203 + t204)
    t206 = np.where(t53 != 0.0, t202, 0.0) + np.where(t56 != 0.0, t205, 0.0)
    t207 = np.where(t53 != 0.0, t205, 0.0) + np.where(t56 != 0.0, t202, 0.0)
    t208 = t46 * t206 - t48 * t207
    t209 = t48 * t206 + t46 * t207
    t210 = t208 + t209
    t211 = t208 - t209
    t212 = t208 + t208
    t213 = t47 * t208 + t40 * t210 * t211 - t36 * t209 - t209 * (t37 * t212)
    t214 = t213 * t213
    t215 = t36 + t36
    t216 = t47 + t47
    t217 = t51 + t208 * t215 + t209 * t216 + t211 * (t37 * t210)
    t218 = t213 / (2e-18 + (t214 + t214)) * (t217 + t209 * (t40 * t212))
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
    t230 = t47 * t225 + t40 * t227 * t228 - t36 * t226 - t226 * (t37 * t229)
    t231 = t230 * t230
    t232 = t51 + t215 * t225 + t216 * t226 + t228 * (t37 * t227)
    t233 = t230 / (2e-18 + (t231 + t231)) * (t232 + t226 * (t40 * t229))
    t234 = np.maximum((-0.001), np.minimum(0.001, -t233))
    t235 = t225 - t226 * t234
    t236 = t226 + t225 * t234
    t237 = np.sqrt((t235 * t235 + t236 * t236))
    t238 = np.where(t237 != 0.0, 1, 0.0)
    t239 = t238 / (t237 + (1 - t238))
    t240 = t235 * t239
    t241 = t20 * sa3
    t242 = t236 * t239
    t243 = t3 * (t11 + t12 * t240 + t241 * t242)
    t244 = d3 + d4 * t240
    t245 = np.where(sa2 != 0.0, 1, 0.0)
    t246 = t245 / (sa2 + (1 - t245))
    t247 = sa3 * (d4 * ca2)
    t248 = t246 * (t17 - t242 * t247)
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
    t264 = np.arctan2((y * t259 - x * t263), x * t259 + y * t263)
    t265 = -(t54 * (t200 + t201))
    t266 = t54 * (t203 - t204)
    t267 = np.where(t53 != 0.0, t265, 0.0) + np.where(t56 != 0.0, t266, 0.0)
    t268 = np.where(t53 != 0.0, t266, 0.0) + np.where(t56 != 0.0, t265, 0.0)
    t269 = t46 * t267 - t48 * t268
    t270 = t48 * t267 + t46 * t268
    t271 = t269 + t270
    t272 = t269 - t270
    t273 = t269 + t269
    t274 = t47 * t269 + t40 * t271 * t272 - t36 * t270 - t270 * (t37 * t273)
    t275 = t274 * t274
    t276 = t51 + t215 * t269 + t216 * t270 + t272 * (t37 * t271)
    t277 = t274 / (2e-18 + (t275 + t275)) * (t276 + t270 * (t40 * t273))
    t278 = np.maximum((-0.001), np.minimum(0.001, -t277))
    t279 = t269 - t270 * t278
    t280 = t270 + t269 * t278
    t281 = np.sqrt((t279 * t279 + t280 * t280))
    t282 = np.where(t281 != 0.0, 1, 0.0)
    t283 = t282 / (t281 + (1 - t282))
    t284 = t279 * t283
    t285 = t280 * t283
    t286 = t284 + t285
    t287 = t284 - t285
    t288 = t284 + t284
    t289 = t47 * t284 + t40 * t286 * t287 - t36 * t285 - t285 * (t37 * t288)
    t290 = t289 * t289
    t291 = t51 + t215 * t284 + t216 * t285 + t287 * (t37 * t286)
    t292 = t289 / (2e-18 + (t290 + t290)) * (t291 + t285 * (t40 * t288))
    t293 = np.maximum((-0.001), np.minimum(0.001, -t292))
    t294 = t284 - t285 * t293
    t295 = t285 + t284 * t293
    t296 = np.sqrt((t294 * t294 + t295 * t295))
    t297 = np.where(t296 != 0.0, 1, 0.0)
    t298 = t297 / (t296 + (1 - t297))
    t299 = t294 * t298
    t300 = t295 * t298
    t301 = t3 * (t11 + t12 * t299 + t241 * t300)
    t302 = d3 + d4 * t299
    t303 = t246 * (t17 - t247 * t300)
    t304 = t249 * t300 - t250
    t305 = t301 * t302 + t303 * t304
    t306 = t302 * t303 - t301 * t304
    t307 = np.sqrt((t305 * t305 + t306 * t306))
    t308 = np.where(t307 != 0.0, 1, 0.0)
    t309 = t308 / (t307 + (1 - t308))
    t310 = t305 * t309
    t311 = t306 * t309
    t312 = d2 + (t302 * t310 - t304 * t311)
    t313 = t304 * t310 + t302 * t311
    t314 = r2 + (t261 + sa3 * (d4 * t300))
    t315 = ca2 * t313 - sa2 * t314
    t316 = np.arctan2((y * t312 - x * t315), x * t312 + y * t315)
    t317 = t191 - t196
    t318 = t190 * t317
    t319 = t55 - t317 * t317
    t320 = np.sqrt(np.maximum(0.0, t319))
    t321 = t193 * t320
    t322 = -(t54 * (t318 + t321))
    t323 = t190 * t320
    t324 = t193 * t317
    t325 = t54 * (t323 - t324)
    t326 = np.where(t53 != 0.0, t322, 0.0) + np.where(t56 != 0.0, t325, 0.0)
    t327 = np.where(t53 != 0.0, t325, 0.0) + np.where(t56 != 0.0, t322, 0.0)
    t328 = t46 * t326 - t48 * t327
    t329 = t48 * t326 + t46 * t327
    t330 = t328 + t329
    t331 = t328 - t329
    t332 = t328 + t328
    t333 = t47 * t328 + t40 * t330 * t331 - t36 * t329 - t329 * (t37 * t332)
    t334 = t333 * t333
    t335 = t51 + t215 * t328 + t216 * t329 + t331 * (t37 * t330)
    t336 = t333 / (2e-18 + (t334 + t334)) * (t335 + t329 * (t40 * t332))
    t337 = np.maximum((-0.001), np.minimum(0.001, -t336))
    t338 = t328 - t329 * t337
    t339 = t329 + t328 * t337
    t340 = np.sqrt((t338 * t338 + t339 * t339))
    t341 = np.where(t340 != 0.0, 1, 0.0)
    t342 = t341 / (t340 + (1 - t341))
    t343 = t338 * t342
    t344 = t339 * t342
    t345 = t343 + t344
    t346 = t343 - t344
    t347 = t343 + t343
    t348 = t47 * t343 + t40 * t345 * t346 - t36 * t344 - t344 * (t37 * t347)
    t349 = t348 * t348
    t350 = t51 + t215 * t343 + t216 * t344 + t346 * (t37 * t345)
    t351 = t348 / (2e-18 + (t349 + t349)) * (t350 + t344 * (t40 * t347))
    t352 = np.maximum((-0.001), np.minimum(0.001, -t351))
    t353 = t343 - t344 * t352
    t354 = t344 + t343 * t352
    t355 = np.sqrt((t353 * t353 + t354 * t354))
    t356 = np.where(t355 != 0.0, 1, 0.0)
    t357 = t356 / (t355 + (1 - t356))
    t358 = t353 * t357
    t359 = t354 * t357
    t360 = t3 * (t11 + t12 * t358 + t241 * t359)
    t361 = d3 + d4 * t358
    t362 = t246 * (t17 - t247 * t359)
    t363 = t249 * t359 - t250
    t364 = t360 * t361 + t362 * t363
    t365 = t361 * t362 - t360 * t363
    t366 = np.sqrt((t364 * t364 + t365 * t365))
    t367 = np.where(t366 != 0.0, 1, 0.0)
    t368 = t367 / (t366 + (1 - t367))
    t369 = t364 * t368
    t370 = t365 * t368
    t371 = d2 + (t361 * t369 - t363 * t370)
    t372 = t363 * t369 + t361 * t370
    t373 = r2 + (t261 + sa3 * (d4 * t359))
    t374 = ca2 * t372 - sa2 * t373
    t375 = np.arctan2((y * t371 - x * t374), x * t371 + y * t374)
    t376 = t54 * (t321 - t318)
    t377 = -(t54 * (t323 + t324))
    t378 = np.where(t53 != 0.0, t376, 0.0) + np.where(t56 != 0.0, t377, 0.0)
    t379 = np.where(t53 != 0.0, t377, 0.0) + np.where(t56 != 0.0, t376, 0.0)
    t380 = t46 * t378 - t48 * t379
    t381 = t48 * t378 + t46 * t379
    t382 = t380 + t381
    t383 = t380 - t381
    t384 = t380 + t380
    t385 = t47 * t380 + t40 * t382 * t383 - t36 * t381 - t381 * (t37 * t384)
    t386 = t385 * t385
    t387 = t51 + t215 * t380 + t216 * t381 + t383 * (t37 * t382)
    t388 = t385 / (2e-18 + (t386 + t386)) * (t387 + t381 * (t40 * t384))
    t389 = np.maximum((-0.001), np.minimum(0.001, -t388))
    t390 = t380 - t381 * t389
    t391 = t381 + t380 * t389
    t392 = np.sqrt((t390 * t390 + t391 * t391))
    t393 = np.where(t392 != 0.0, 1, 0.0)
    t394 = t393 / (t392 + (1 - t393))
    t395 = t390 * t394
    t396 = t391 * t394
    t397 = t395 + t396
    t398 = t395 - t396
    t399 = t395 + t395
    t400 = t47 * t395 + t40 * t397 * t398 - t36 * t396 - t396 * (t37 * t399)
    t401 = t400 * t400
    t402 = t51 + t215 * t395 + t216 * t396 + t398 * (t37 * t397)
    t403 = t400 / (2e-18 + (t401 + t401)) * (t402 + t396 * (t40 * t399))
    t404 = np.maximum((-0.001), np.minimum(0.001, -t403))
    t405 = t395 - t396 * t404
    t406 = t396 + t395 * t404
    t407 = np.sqrt((t405 * t405 + t406 * t406))
    t408 = np.where(t407 != 0.0, 1, 0.0)
    t409 = t408 / (t407 + (1 - t408))
    t410 = t405 * t409
    t411 = t406 * t409
    t412 = t3 * (t11 + t12 * t410 + t241 * t411)
    t413 = d3 + d4 * t410
    t414 = t246 * (t17 - t247 * t411)
    t415 = t249 * t411 - t250
    t416 = t412 * t413 + t414 * t415
    t417 = t413 * t414 - t412 * t415
    t418 = np.sqrt((t416 * t416 + t417 * t417))
    t419 = np.where(t418 != 0.0, 1, 0.0)
    t420 = t419 / (t418 + (1 - t419))
    t421 = t416 * t420
    t422 = t417 * t420
    t423 = d2 + (t413 * t421 - t415 * t422)
    t424 = t415 * t421 + t413 * t422
    t425 = r2 + (t261 + sa3 * (d4 * t411))
    t426 = ca2 * t424 - sa2 * t425
    t427 = np.arctan2((y * t423 - x * t426), x * t423 + y * t426)
    t428 = np.sqrt(t4)
    t429 = np.sqrt((t259 * t259 + t263 * t263)) - t428
    t430 = sa2 * t260 + ca2 * t262 - z
    t431 = np.sqrt((t312 * t312 + t315 * t315)) - t428
    t432 = sa2 * t313 + ca2 * t314 - z
    t433 = np.sqrt((t371 * t371 + t374 * t374)) - t428
    t434 = sa2 * t372 + ca2 * t373 - z
    t435 = np.sqrt((t423 * t423 + t426 * t426)) - t428
    t436 = sa2 * t424 + ca2 * t425 - z
    t437 = t47 * t240 + t40 * (t240 + t242) * (t240 - t242) - t36 * t242
    t438 = t47 * t299 + t40 * (t299 + t300) * (t299 - t300) - t36 * t300
    t439 = t47 * t358 + t40 * (t358 + t359) * (t358 - t359) - t36 * t359
    t440 = t47 * t410 + t40 * (t410 + t411) * (t410 - t411) - t36 * t411
    t441 = t51 * t51
    t442 = t41 + t37 * t37
    t443 = t36 * t36
    t444 = t47 * t47
    t445 = t443 + t444
    t446 = t441 + 3 * t442 - 3 * t445
    t447 = t446 * t446
    t448 = 27 * (t37 * (t443 - t444) + t47 * (t40 * t215)) + t51 * (t441 + t441 - 18 * t442 - 9 * t445)
    t449 = 4 * t446 * t447 - t448 * t448
    t450 = 0.5 + 0.5 * np.copysign(1, t449)
    t451 = np.maximum(d2, -d2)
    t452 = np.maximum(ca2, -ca2)
    t453 = t452 + t452
    t454 = t451 * t453
    t455 = np.maximum(r2, -r2)
    t456 = np.maximum(ca3, -ca3)
    t457 = np.maximum(r3, -r3)
    t458 = (t451 + t451) * np.maximum(z, -z) + t454 * t455 + t451 * (t453 * t456) * t457
    t459 = np.maximum(d4, -d4)
    t460 = np.maximum(sa3, -sa3)
    t461 = t458 + t454 * t459 * t460
    t462 = np.maximum(sa2, -sa2)
    t463 = t6 * t462 + t7 * t462 + t8 * t462 + t9 * t462
    t464 = t463 + t10 * t462 + t5 * t462 + t462 * np.maximum(t4, -t4)
    t465 = np.maximum(d3, -d3)
    t466 = t464 + t462 * (t459 * (t465 + t465)) + t462 * (t457 * (t455 * (t456 + t456)))
    t467 = t466 + t460 * (t462 * (t455 * (t459 + t459)))
    t468 = t456 * t459 + t457 * t460
    t469 = t459 + t465
    t470 = t461 * t461 + t467 * t467 + t15 * (t468 * t468 + t469 * t469)
    t471 = 3.552713678800501e-15 * t35 * t470
    t472 = -0.3333333333333333 * t446
    t473 = t442 + t445 - 0.5555555555555556 * t441
    t474 = 1.3333333333333333 * t51
    t475 = t472 * t472 + 3 * (t473 * t473) + t472 * (t474 * t474)
    t476 = np.minimum((t475 + t474 * (0.1111111111111111 * t448) - t473 * (-1.3333333333333333 * t446)), 3 * (3 * t473 - -0.6666666666666666 * t446))
    t477 = 0.016666666666666666 / t471 * t476
    t478 = 72 * t447 + 120 * np.maximum(t448, -t448) + 5000 * t471
    t479 = np.maximum(t449, -t449) / (t471 * t478)

    # results
    angles = np.empty((*_leading, 12), _real)
    room = np.empty((*_leading, 2), _real)
    closure = np.empty((*_leading, 4), _real)
    slope = np.empty((*_leading, 4), _real)
    number = np.empty((*_leading, 1), _real)
    margin = np.empty((*_leading, 1), _real)
    angles[..., 0] = t264
    angles[..., 1] = np.arctan2(t258, t257)
    angles[..., 2] = np.arctan2(t242, t240)
    angles[..., 3] = t316
    angles[..., 4] = np.arctan2(t311, t310)
    angles[..., 5] = np.arctan2(t300, t299)
    angles[..., 6] = t375
    angles[..., 7] = np.arctan2(t370, t369)
    angles[..., 8] = np.arctan2(t359, t358)
    angles[..., 9] = t427
    angles[..., 10] = np.arctan2(t422, t421)
    angles[..., 11] = np.arctan2(t411, t410)
    room[..., 0] = t198
    room[..., 1] = t319
    closure[..., 0] = np.sqrt((t429 * t429 + t430 * t430))
    closure[..., 1] = np.sqrt((t431 * t431 + t432 * t432))
    closure[..., 2] = np.sqrt((t433 * t433 + t434 * t434))
    closure[..., 3] = np.sqrt((t435 * t435 + t436 * t436))
    slope[..., 0] = t437 - t242 * (t37 * (t240 + t240))
    slope[..., 1] = t438 - t300 * (t37 * (t299 + t299))
    slope[..., 2] = t439 - t359 * (t37 * (t358 + t358))
    slope[..., 3] = t440 - t411 * (t37 * (t410 + t410))
    number[..., 0] = 2 + t450 * np.copysign(2, t477)
    margin[..., 0] = np.minimum(t479, t479 * (1 - t450) + np.maximum(t477, -t477))
    return angles.reshape(_leading + (4, 3)), room.reshape(_leading + (2,)), closure.reshape(_leading + (4,)), slope.reshape(_leading + (4,)), number.reshape(_leading), margin.reshape(_leading)


def postures_intersecting(parameters, point):
    """the postures of an arm with axes 1 and 2 intersecting, the distance each leaves, and W: 300 operations.

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
    t50 = np.arctan2((y * t44 - x * t49), x * t44 + y * t49)
    t51 = np.arctan2(t23, t20)
    t52 = t34 - t33
    t53 = t36 + t37
    t54 = np.sqrt((t52 * t52 + t53 * t53))
    t55 = np.where(t54 != 0.0, 1, 0.0)
    t56 = t55 / (t54 + (1 - t55))
    t57 = t52 * t56
    t58 = t53 * t56
    t59 = d2 + (t21 * t57 - t25 * t58)
    t60 = t25 * t57 + t21 * t58
    t61 = ca2 * t60 - t48
    t62 = np.arctan2((y * t59 - x * t61), x * t59 + y * t61)
    t63 = t5 - t6 * (t10 - t12)
    t64 = t6 * (t14 + t15)
    t65 = np.sqrt((t63 * t63 + t64 * t64))
    t66 = np.where(t65 != 0.0, 1, 0.0)
    t67 = t66 / (t65 + (1 - t66))
    t68 = t63 * t67
    t69 = d3 + d4 * t68
    t70 = t64 * t67
    t71 = t24 + t22 * t70
    t72 = t69 * t69 + t71 * t71
    t73 = t28 * (t29 + t30 * t70)
    t74 = np.sqrt(np.maximum(0.0, t72 - t73 * t73))
    t75 = t69 * t74
    t76 = t71 * t73
    t77 = t75 - t76
    t78 = t69 * t73
    t79 = t71 * t74
    t80 = t78 + t79
    t81 = np.sqrt((t77 * t77 + t80 * t80))
    t82 = np.where(t81 != 0.0, 1, 0.0)
    t83 = t82 / (t81 + (1 - t82))
    t84 = t77 * t83
    t85 = t80 * t83
    t86 = d2 + (t69 * t84 + t71 * t85)
    t87 = t69 * t85 - t71 * t84
    t88 = r2 + (t46 - sa3 * (d4 * t70))
    t89 = sa2 * t88
    t90 = ca2 * t87 - t89
    t91 = np.arctan2((y * t86 - x * t90), x * t86 + y * t90)
    t92 = np.arctan2((-t70), t68)
    t93 = t75 + t76
    t94 = t78 - t79
    t95 = np.sqrt((t93 * t93 + t94 * t94))
    t96 = np.where(t95 != 0.0, 1, 0.0)
    t97 = t96 / (t95 + (1 - t96))
    t98 = t94 * t97
    t99 = t93 * t97
    t100 = d2 + (t71 * t98 - t69 * t99)
    t101 = t71 * t99 + t69 * t98
    t102 = ca2 * t101 - t89
    t103 = np.arctan2((y * t100 - x * t102), x * t100 + y * t102)
    t104 = np.sqrt(t7)
    t105 = np.sqrt((t44 * t44 + t49 * t49)) - t104
    t106 = ca2 * t47
    t107 = sa2 * t45 + t106 - z
    t108 = np.sqrt((t59 * t59 + t61 * t61)) - t104
    t109 = t106 + sa2 * t60 - z
    t110 = np.sqrt((t86 * t86 + t90 * t90)) - t104
    t111 = ca2 * t88
    t112 = sa2 * t87 + t111 - z
    t113 = np.sqrt((t100 * t100 + t102 * t102)) - t104
    t114 = t111 + sa2 * t101 - z

    # results
    angles = np.empty((*_leading, 12), _real)
    closure = np.empty((*_leading, 4), _real)
    width = np.empty((*_leading, 4), _real)
    angles[..., 0] = t50
    angles[..., 1] = np.arctan2(t43, t42)
    angles[..., 2] = t51
    angles[..., 3] = t62
    angles[..., 4] = np.arctan2(t58, t57)
    angles[..., 5] = t51
    angles[..., 6] = t91
    angles[..., 7] = np.arctan2(t85, t84)
    angles[..., 8] = t92
    angles[..., 9] = t103
    angles[..., 10] = np.arctan2(t98, -t99)
    angles[..., 11] = t92
    closure[..., 0] = np.sqrt((t105 * t105 + t107 * t107))
    closure[..., 1] = np.sqrt((t108 * t108 + t109 * t109))
    closure[..., 2] = np.sqrt((t110 * t110 + t112 * t112))
    closure[..., 3] = np.sqrt((t113 * t113 + t114 * t114))
    width[..., 0] = t26
    width[..., 1] = t26
    width[..., 2] = t72
    width[..., 3] = t72
    return angles.reshape(_leading + (4, 3)), closure.reshape(_leading + (4,)), width.reshape(_leading + (4,))


def postures_parallel(parameters, point):
    """the postures of an arm with axes 1 and 2 parallel, the distance each leaves, and W: 294 operations.

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
    t48 = np.arctan2((y * t42 - x * t47), x * t42 + y * t47)
    t49 = np.arctan2(t24, t14)
    t50 = t26 - t32
    t51 = t34 + t35
    t52 = np.sqrt((t50 * t50 + t51 * t51))
    t53 = np.where(t52 != 0.0, 1, 0.0)
    t54 = t53 / (t52 + (1 - t53))
    t55 = t50 * t54
    t56 = t51 * t54
    t57 = d2 + (t15 * t55 + t29 * t56)
    t58 = t29 * t55 - t15 * t56
    t59 = ca2 * t58 - t46
    t60 = np.arctan2((y * t57 - x * t59), x * t57 + y * t59)
    t61 = t4 - t7
    t62 = np.sqrt((t10 + t61 * t61))
    t63 = np.where(t62 != 0.0, 1, 0.0)
    t64 = t63 / (t62 + (1 - t63))
    t65 = t61 * t64
    t66 = d3 + d4 * t65
    t67 = t9 * t64
    t68 = t18 * (t21 + t22 * t65 + t23 * t67)
    t69 = t66 * t68
    t70 = t27 * t67 - t28
    t71 = t66 * t66 + t70 * t70
    t72 = np.sqrt(np.maximum(0.0, t71 - t68 * t68))
    t73 = t70 * t72
    t74 = t69 + t73
    t75 = t66 * t72
    t76 = t68 * t70
    t77 = t75 - t76
    t78 = np.sqrt((t74 * t74 + t77 * t77))
    t79 = np.where(t78 != 0.0, 1, 0.0)
    t80 = t79 / (t78 + (1 - t79))
    t81 = t74 * t80
    t82 = t77 * t80
    t83 = d2 + (t66 * t81 - t70 * t82)
    t84 = t70 * t81 + t66 * t82
    t85 = r2 + (t44 + sa3 * (d4 * t67))
    t86 = sa2 * t85
    t87 = ca2 * t84 - t86
    t88 = np.arctan2((y * t83 - x * t87), x * t83 + y * t87)
    t89 = np.arctan2(t67, t65)
    t90 = t69 - t73
    t91 = t75 + t76
    t92 = np.sqrt((t90 * t90 + t91 * t91))
    t93 = np.where(t92 != 0.0, 1, 0.0)
    t94 = t93 / (t92 + (1 - t93))
    t95 = t90 * t94
    t96 = t91 * t94
    t97 = d2 + (t66 * t95 + t70 * t96)
    t98 = t70 * t95 - t66 * t96
    t99 = ca2 * t98 - t86
    t100 = np.arctan2((y * t97 - x * t99), x * t97 + y * t99)
    t101 = np.sqrt(t19)
    t102 = np.sqrt((t42 * t42 + t47 * t47)) - t101
    t103 = ca2 * t45
    t104 = t43 * sa2 + t103 - z
    t105 = np.sqrt((t57 * t57 + t59 * t59)) - t101
    t106 = t103 + sa2 * t58 - z
    t107 = np.sqrt((t83 * t83 + t87 * t87)) - t101
    t108 = ca2 * t85
    t109 = sa2 * t84 + t108 - z
    t110 = np.sqrt((t97 * t97 + t99 * t99)) - t101
    t111 = t108 + sa2 * t98 - z

    # results
    angles = np.empty((*_leading, 12), _real)
    closure = np.empty((*_leading, 4), _real)
    width = np.empty((*_leading, 4), _real)
    angles[..., 0] = t48
    angles[..., 1] = np.arctan2(t41, t40)
    angles[..., 2] = t49
    angles[..., 3] = t60
    angles[..., 4] = np.arctan2((-t56), t55)
    angles[..., 5] = t49
    angles[..., 6] = t88
    angles[..., 7] = np.arctan2(t82, t81)
    angles[..., 8] = t89
    angles[..., 9] = t100
    angles[..., 10] = np.arctan2((-t96), t95)
    angles[..., 11] = t89
    closure[..., 0] = np.sqrt((t102 * t102 + t104 * t104))
    closure[..., 1] = np.sqrt((t105 * t105 + t106 * t106))
    closure[..., 2] = np.sqrt((t107 * t107 + t109 * t109))
    closure[..., 3] = np.sqrt((t110 * t110 + t111 * t111))
    width[..., 0] = t30
    width[..., 1] = t30
    width[..., 2] = t71
    width[..., 3] = t71
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
