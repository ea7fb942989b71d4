"""cuspidality of regional_3r, in NumPy.

Made from templates/kernel.py.j2; inputs 15308f4c0a7ecb4ee0a448257c5114c77c112baf28c1d526ffec029d8481cf69.
4089 operations. Do not edit: change the derivation and regenerate.

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
    """two pairs of postures at a point, the room of each (real if positive), the distances left, the slopes of E: 1729 operations.

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
    t32 = t26 / t31
    t33 = t27 / t31
    t34 = np.where(t31 != 0.0, t33, 0.0)
    t35 = t34 + np.copysign(1e-17, t34)
    t36 = 0.5 + 0.5 * np.copysign(1, t35)
    t37 = t29 / t31
    t38 = t37 * t37
    t39 = np.sqrt((t35 * t35 + np.where(t31 != 0.0, np.where(t31 != 0.0, t38, 0.0), 0.0)))
    t40 = 0.7071067811865476 * np.sqrt(((t39 + np.maximum(t35, -t35)) / t39))
    t41 = 1 - t36
    t42 = np.where(t31 != 0.0, 0.5 * t37 / t40 / t39, 0.0)
    t43 = np.where(t36 != 0.0, t40, 0.0) + np.where(t41 != 0.0, t42, 0.0)
    t44 = t30 / t31
    t45 = np.where(t36 != 0.0, t42, 0.0) + np.where(t41 != 0.0, t40, 0.0)
    t46 = t32 * t43 + t44 * t45
    t47 = np.where(t31 != 0.0, t43 * t44, 0.0) - np.where(t31 != 0.0, t32 * t45, 0.0)
    t48 = t25 / t31
    t49 = np.where(t31 != 0.0, np.where(t31 != 0.0, t46 * t46, 0.0), 0.0) - t47 * t47 - np.where(t31 != 0.0, t39 * t48, 0.0)
    t50 = 0.5 + 0.5 * np.copysign(1, t49)
    t51 = 0.5 / t39
    t52 = t39 + t39
    t53 = np.where(t31 != 0.0, t46, 0.0)
    t54 = 1 - t50
    t55 = np.where(t50 != 0.0, t53, 0.0) + np.where(t54 != 0.0, -t47, 0.0)
    t56 = np.where(t50 != 0.0, t47, 0.0) + np.where(t54 != 0.0, -t53, 0.0)
    t57 = t56 * t56
    t58 = t55 * t55
    t59 = np.where(t31 != 0.0, t48 * (t50 + t50 - 1), 0.0)
    t60 = t57 + t58 - t52 * (t59 - t39)
    t61 = t59 - 3 * t39
    t62 = t39 * (t60 + t39 * (t39 + t61))
    t63 = t39 * (t57 + t57)
    t64 = np.minimum(t39, np.where(t62 != 0.0, t39 * t63 / t62, 0.0))
    t65 = t61 + t61
    t66 = t60 + t64 * (t65 + 3 * t64)
    t67 = t64 * (t60 + t64 * (t61 + t64)) - t63
    t68 = t64 - np.where(t66 != 0.0, t67 / t66, 0.0)
    t69 = 0.5 + 0.5 * np.copysign(1, t67)
    t70 = 1 - t69
    t71 = np.where(t69 != 0.0, t64, 0.0) + np.where(t70 != 0.0, t39, 0.0)
    t72 = np.where(t70 != 0.0, t64, 0.0)
    t73 = np.where((t68 - np.minimum(t71, np.maximum(t68, t72))) != 0.0, 1, 0.0)
    t74 = np.where(t73 != 0.0, 0.5 * t71 + np.where(t70 != 0.0, 0.5 * t64, 0.0), 0.0) + np.where((1 - t73) != 0.0, t68, 0.0)
    t75 = t60 + t74 * (t65 + 3 * t74)
    t76 = t74 * (t60 + t74 * (t61 + t74)) - t63
    t77 = t74 - np.where(t75 != 0.0, t76 / t75, 0.0)
    t78 = 0.5 + 0.5 * np.copysign(1, t76)
    t79 = 1 - t78
    t80 = np.where(t78 != 0.0, t74, 0.0) + np.where(t79 != 0.0, t71, 0.0)
    t81 = np.where(t78 != 0.0, t72, 0.0) + np.where(t79 != 0.0, t74, 0.0)
    t82 = np.where((t77 - np.minimum(t80, np.maximum(t77, t81))) != 0.0, 1, 0.0)
    t83 = np.where(t82 != 0.0, 0.5 * t80 + 0.5 * t81, 0.0) + np.where((1 - t82) != 0.0, t77, 0.0)
    t84 = t60 + t83 * (t65 + 3 * t83)
    t85 = t83 * (t60 + t83 * (t61 + t83)) - t63
    t86 = t83 - np.where(t84 != 0.0, t85 / t84, 0.0)
    t87 = 0.5 + 0.5 * np.copysign(1, t85)
    t88 = 1 - t87
    t89 = np.where(t87 != 0.0, t83, 0.0) + np.where(t88 != 0.0, t80, 0.0)
    t90 = np.where(t87 != 0.0, t81, 0.0) + np.where(t88 != 0.0, t83, 0.0)
    t91 = np.where((t86 - np.minimum(t89, np.maximum(t86, t90))) != 0.0, 1, 0.0)
    t92 = np.where(t91 != 0.0, 0.5 * t89 + 0.5 * t90, 0.0) + np.where((1 - t91) != 0.0, t86, 0.0)
    t93 = t60 + t92 * (t65 + 3 * t92)
    t94 = t92 * (t60 + t92 * (t61 + t92)) - t63
    t95 = t92 - np.where(t93 != 0.0, t94 / t93, 0.0)
    t96 = 0.5 + 0.5 * np.copysign(1, t94)
    t97 = 1 - t96
    t98 = np.where(t96 != 0.0, t92, 0.0) + np.where(t97 != 0.0, t89, 0.0)
    t99 = np.where(t96 != 0.0, t90, 0.0) + np.where(t97 != 0.0, t92, 0.0)
    t100 = np.where((t95 - np.minimum(t98, np.maximum(t95, t99))) != 0.0, 1, 0.0)
    t101 = np.where(t100 != 0.0, 0.5 * t98 + 0.5 * t99, 0.0) + np.where((1 - t100) != 0.0, t95, 0.0)
    t102 = t60 + t101 * (t65 + 3 * t101)
    t103 = t101 * (t60 + t101 * (t61 + t101)) - t63
    t104 = t101 - np.where(t102 != 0.0, t103 / t102, 0.0)
    t105 = 0.5 + 0.5 * np.copysign(1, t103)
    t106 = 1 - t105
    t107 = np.where(t105 != 0.0, t101, 0.0) + np.where(t106 != 0.0, t98, 0.0)
    t108 = np.where(t105 != 0.0, t99, 0.0) + np.where(t106 != 0.0, t101, 0.0)
    t109 = np.where((t104 - np.minimum(t107, np.maximum(t104, t108))) != 0.0, 1, 0.0)
    t110 = np.where(t109 != 0.0, 0.5 * t107 + 0.5 * t108, 0.0) + np.where((1 - t109) != 0.0, t104, 0.0)
    t111 = t60 + t110 * (t65 + 3 * t110)
    t112 = t110 * (t60 + t110 * (t61 + t110)) - t63
    t113 = t110 - np.where(t111 != 0.0, t112 / t111, 0.0)
    t114 = 0.5 + 0.5 * np.copysign(1, t112)
    t115 = 1 - t114
    t116 = np.where(t114 != 0.0, t110, 0.0) + np.where(t115 != 0.0, t107, 0.0)
    t117 = np.where(t114 != 0.0, t108, 0.0) + np.where(t115 != 0.0, t110, 0.0)
    t118 = np.where((t113 - np.minimum(t116, np.maximum(t113, t117))) != 0.0, 1, 0.0)
    t119 = np.where(t118 != 0.0, 0.5 * t116 + 0.5 * t117, 0.0) + np.where((1 - t118) != 0.0, t113, 0.0)
    t120 = t60 + t119 * (t65 + 3 * t119)
    t121 = t119 * (t60 + t119 * (t61 + t119)) - t63
    t122 = t119 - np.where(t120 != 0.0, t121 / t120, 0.0)
    t123 = 0.5 + 0.5 * np.copysign(1, t121)
    t124 = 1 - t123
    t125 = np.where(t123 != 0.0, t119, 0.0) + np.where(t124 != 0.0, t116, 0.0)
    t126 = np.where(t123 != 0.0, t117, 0.0) + np.where(t124 != 0.0, t119, 0.0)
    t127 = np.where((t122 - np.minimum(t125, np.maximum(t122, t126))) != 0.0, 1, 0.0)
    t128 = np.where(t127 != 0.0, 0.5 * t125 + 0.5 * t126, 0.0) + np.where((1 - t127) != 0.0, t122, 0.0)
    t129 = t60 + t128 * (t65 + 3 * t128)
    t130 = t128 * (t60 + t128 * (t61 + t128)) - t63
    t131 = t128 - np.where(t129 != 0.0, t130 / t129, 0.0)
    t132 = 0.5 + 0.5 * np.copysign(1, t130)
    t133 = 1 - t132
    t134 = np.where(t132 != 0.0, t128, 0.0) + np.where(t133 != 0.0, t125, 0.0)
    t135 = np.where(t132 != 0.0, t126, 0.0) + np.where(t133 != 0.0, t128, 0.0)
    t136 = np.where((t131 - np.minimum(t134, np.maximum(t131, t135))) != 0.0, 1, 0.0)
    t137 = np.where(t136 != 0.0, 0.5 * t134 + 0.5 * t135, 0.0) + np.where((1 - t136) != 0.0, t131, 0.0)
    t138 = t60 + t137 * (t65 + 3 * t137)
    t139 = t137 * (t60 + t137 * (t61 + t137)) - t63
    t140 = t137 - np.where(t138 != 0.0, t139 / t138, 0.0)
    t141 = 0.5 + 0.5 * np.copysign(1, t139)
    t142 = 1 - t141
    t143 = np.where(t141 != 0.0, t137, 0.0) + np.where(t142 != 0.0, t134, 0.0)
    t144 = np.where(t141 != 0.0, t135, 0.0) + np.where(t142 != 0.0, t137, 0.0)
    t145 = np.where((t140 - np.minimum(t143, np.maximum(t140, t144))) != 0.0, 1, 0.0)
    t146 = np.where(t145 != 0.0, 0.5 * t143 + 0.5 * t144, 0.0) + np.where((1 - t145) != 0.0, t140, 0.0)
    t147 = t60 + t146 * (t65 + 3 * t146)
    t148 = t146 * (t60 + t146 * (t61 + t146)) - t63
    t149 = t146 - np.where(t147 != 0.0, t148 / t147, 0.0)
    t150 = 0.5 + 0.5 * np.copysign(1, t148)
    t151 = 1 - t150
    t152 = np.where(t150 != 0.0, t146, 0.0) + np.where(t151 != 0.0, t143, 0.0)
    t153 = np.where(t150 != 0.0, t144, 0.0) + np.where(t151 != 0.0, t146, 0.0)
    t154 = np.where((t149 - np.minimum(t152, np.maximum(t149, t153))) != 0.0, 1, 0.0)
    t155 = np.where(t154 != 0.0, 0.5 * t152 + 0.5 * t153, 0.0) + np.where((1 - t154) != 0.0, t149, 0.0)
    t156 = t60 + t155 * (t65 + 3 * t155)
    t157 = t155 * (t60 + t155 * (t61 + t155)) - t63
    t158 = t155 - np.where(t156 != 0.0, t157 / t156, 0.0)
    t159 = 0.5 + 0.5 * np.copysign(1, t157)
    t160 = 1 - t159
    t161 = np.where(t159 != 0.0, t155, 0.0) + np.where(t160 != 0.0, t152, 0.0)
    t162 = np.where(t159 != 0.0, t153, 0.0) + np.where(t160 != 0.0, t155, 0.0)
    t163 = np.where((t158 - np.minimum(t161, np.maximum(t158, t162))) != 0.0, 1, 0.0)
    t164 = np.where(t163 != 0.0, 0.5 * t161 + 0.5 * t162, 0.0) + np.where((1 - t163) != 0.0, t158, 0.0)
    t165 = t60 + t164 * (t65 + 3 * t164)
    t166 = t164 * (t60 + t164 * (t61 + t164)) - t63
    t167 = t164 - np.where(t165 != 0.0, t166 / t165, 0.0)
    t168 = 0.5 + 0.5 * np.copysign(1, t166)
    t169 = 1 - t168
    t170 = np.where(t168 != 0.0, t164, 0.0) + np.where(t169 != 0.0, t161, 0.0)
    t171 = np.where(t168 != 0.0, t162, 0.0) + np.where(t169 != 0.0, t164, 0.0)
    t172 = np.where((t167 - np.minimum(t170, np.maximum(t167, t171))) != 0.0, 1, 0.0)
    t173 = np.where(t172 != 0.0, 0.5 * t170 + 0.5 * t171, 0.0) + np.where((1 - t172) != 0.0, t167, 0.0)
    t174 = t52 - t173
    t175 = np.sqrt(t174)
    t176 = t55 / t175
    t177 = 0.5 + 0.5 * np.copysign(1, t173 - 1e-25)
    t178 = np.sqrt(t173)
    t179 = np.copysign(np.sqrt(np.maximum(0.0, t39 + t58 / t174 - t59 - t173)), t56)
    t180 = np.where(t177 != 0.0, np.where(t178 != 0.0, t56 / t178, 0.0), 0.0) + np.where((1 - t177) != 0.0, t179, 0.0)
    t181 = t176 + t180
    t182 = t52 - t181 * t181
    t183 = np.sqrt(np.maximum(0.0, t182))
    t184 = t178 * t183
    t185 = t175 * t181
    t186 = t51 * (t184 - t185)
    t187 = t178 * t181
    t188 = t175 * t183
    t189 = t51 * (t187 + t188)
    t190 = np.where(t50 != 0.0, t186, 0.0) + np.where(t54 != 0.0, t189, 0.0)
    t191 = np.where(t50 != 0.0, t189, 0.0) + np.where(t54 != 0.0, t186, 0.0)
    t192 = t43 * t190 - t45 * t191
    t193 = t45 * t190 + t43 * t191
    t194 = t192 + t193
    t195 = t192 - t193
    t196 = np.where(t31 != 0.0, t44 * t192 + t37 * t194 * t195, 0.0) - np.where(t31 != 0.0, t32 * t193, 0.0)
    t197 = t192 + t192
    t198 = t196 - np.where(t31 != 0.0, t193 * (t33 * t197), 0.0)
    t199 = t198 * t198
    t200 = t32 + t32
    t201 = t44 + t44
    t202 = t48 + t192 * t200 + t193 * t201 + t195 * (t33 * t194)
    t203 = t198 / (2e-18 + (t199 + t199)) * (t202 + t193 * (t37 * t197))
    t204 = np.maximum((-0.001), np.minimum(0.001, -np.where(t31 != 0.0, t203, 0.0)))
    t205 = t192 - t193 * t204
    t206 = t193 + t192 * t204
    t207 = np.sqrt((t205 * t205 + t206 * t206))
    t208 = t205 / t207
    t209 = np.where(t207 != 0.0, t208, 0.0)
    t210 = t206 / t207
    t211 = t208 + t210
    t212 = t209 - np.where(t207 != 0.0, t210, 0.0)
    t213 = np.where(t31 != 0.0, np.where(t207 != 0.0, t44 * t208, 0.0), 0.0) + np.where(t207 != 0.0, np.where(t31 != 0.0, t37 * t211 * t212, 0.0), 0.0)
    t214 = t208 + t208
    t215 = t213 - np.where(t207 != 0.0, np.where(t31 != 0.0, t32 * t210, 0.0), 0.0) - np.where(t207 != 0.0, np.where(t31 != 0.0, np.where(t207 != 0.0, t210 * (t33 * t214), 0.0), 0.0), 0.0)
    t216 = t215 * t215
    t217 = np.where(t31 != 0.0, t48, 0.0)
    t218 = t217 + np.where(t207 != 0.0, np.where(t31 != 0.0, t200 * t208, 0.0), 0.0) + np.where(t207 != 0.0, np.where(t31 != 0.0, t201 * t210, 0.0), 0.0)
    t219 = t218 + np.where(t207 != 0.0, np.where(t31 != 0.0, t212 * (t33 * t211), 0.0), 0.0) + np.where(t207 != 0.0, np.where(t31 != 0.0, np.where(t207 != 0.0, t210 * (t37 * t214), 0.0), 0.0), 0.0)
    t220 = np.maximum((-0.001), np.minimum(0.001, -(t215 / (2e-18 + (t216 + t216)) * t219)))
    t221 = t209 - np.where(t207 != 0.0, t210 * t220, 0.0)
    t222 = t210 + t208 * t220
    t223 = np.sqrt((t221 * t221 + np.where(t207 != 0.0, np.where(t207 != 0.0, t222 * t222, 0.0), 0.0)))
    t224 = t221 / t223
    t225 = t16 * sa3
    t226 = t222 / t223
    t227 = t9 + np.where(t223 != 0.0, t13 * t224, 0.0) + np.where(t207 != 0.0, np.where(t223 != 0.0, t225 * t226, 0.0), 0.0)
    t228 = t227 / t1
    t229 = d3 + np.where(t223 != 0.0, d4 * t224, 0.0)
    t230 = sa3 * (d4 * ca2)
    t231 = (t11 + np.where(t207 != 0.0, np.where(t223 != 0.0, -(t226 * t230), 0.0), 0.0)) / sa2
    t232 = d4 * ca3
    t233 = r3 * sa3
    t234 = np.where(t207 != 0.0, np.where(t223 != 0.0, t226 * t232, 0.0), 0.0) - t233
    t235 = np.where(t1 != 0.0, t228 * t229, 0.0) + np.where(sa2 != 0.0, t231 * t234, 0.0)
    t236 = np.where(sa2 != 0.0, t229 * t231, 0.0) - np.where(t1 != 0.0, t228 * t234, 0.0)
    t237 = np.sqrt((t235 * t235 + t236 * t236))
    t238 = t235 / t237
    t239 = t236 / t237
    t240 = d2 + (np.where(t237 != 0.0, t229 * t238, 0.0) - np.where(t237 != 0.0, t234 * t239, 0.0))
    t241 = t234 * t238 + t229 * t239
    t242 = r3 * ca3
    t243 = r2 + (t242 + np.where(t207 != 0.0, np.where(t223 != 0.0, sa3 * (d4 * t226), 0.0), 0.0))
    t244 = np.where(t237 != 0.0, ca2 * t241, 0.0) - sa2 * t243
    t245 = np.arctan2((y * t240 - x * t244), x * t240 + y * t244)
    t246 = np.where(t207 != 0.0, np.where(t223 != 0.0, t226, 0.0), 0.0)
    t247 = np.where(t223 != 0.0, t224, 0.0)
    t248 = -(t51 * (t184 + t185))
    t249 = t51 * (t187 - t188)
    t250 = np.where(t50 != 0.0, t248, 0.0) + np.where(t54 != 0.0, t249, 0.0)
    t251 = np.where(t50 != 0.0, t249, 0.0) + np.where(t54 != 0.0, t248, 0.0)
    t252 = t43 * t250 - t45 * t251
    t253 = t45 * t250 + t43 * t251
    t254 = t252 + t253
    t255 = t252 - t253
    t256 = np.where(t31 != 0.0, t44 * t252 + t37 * t254 * t255, 0.0) - np.where(t31 != 0.0, t32 * t253, 0.0)
    t257 = t252 + t252
    t258 = t256 - np.where(t31 != 0.0, t253 * (t33 * t257), 0.0)
    t259 = t258 * t258
    t260 = t48 + t200 * t252 + t201 * t253 + t255 * (t33 * t254)
    t261 = t258 / (2e-18 + (t259 + t259)) * (t260 + t253 * (t37 * t257))
    t262 = np.maximum((-0.001), np.minimum(0.001, -np.where(t31 != 0.0, t261, 0.0)))
    t263 = t252 - t253 * t262
    t264 = t253 + t252 * t262
    t265 = np.sqrt((t263 * t263 + t264 * t264))
    t266 = t263 / t265
    t267 = np.where(t265 != 0.0, t266, 0.0)
    t268 = t264 / t265
    t269 = t266 + t268
    t270 = t267 - np.where(t265 != 0.0, t268, 0.0)
    t271 = np.where(t31 != 0.0, np.where(t265 != 0.0, t44 * t266, 0.0), 0.0) + np.where(t265 != 0.0, np.where(t31 != 0.0, t37 * t269 * t270, 0.0), 0.0)
    t272 = t266 + t266
    t273 = t271 - np.where(t265 != 0.0, np.where(t31 != 0.0, t32 * t268, 0.0), 0.0) - np.where(t265 != 0.0, np.where(t31 != 0.0, np.where(t265 != 0.0, t268 * (t33 * t272), 0.0), 0.0), 0.0)
    t274 = t273 * t273
    t275 = t217 + np.where(t265 != 0.0, np.where(t31 != 0.0, t200 * t266, 0.0), 0.0) + np.where(t265 != 0.0, np.where(t31 != 0.0, t201 * t268, 0.0), 0.0)
    t276 = t275 + np.where(t265 != 0.0, np.where(t31 != 0.0, t270 * (t33 * t269), 0.0), 0.0) + np.where(t265 != 0.0, np.where(t31 != 0.0, np.where(t265 != 0.0, t268 * (t37 * t272), 0.0), 0.0), 0.0)
    t277 = np.maximum((-0.001), np.minimum(0.001, -(t273 / (2e-18 + (t274 + t274)) * t276)))
    t278 = t267 - np.where(t265 != 0.0, t268 * t277, 0.0)
    t279 = t268 + t266 * t277
    t280 = np.sqrt((t278 * t278 + np.where(t265 != 0.0, np.where(t265 != 0.0, t279 * t279, 0.0), 0.0)))
    t281 = t278 / t280
    t282 = t279 / t280
    t283 = t9 + np.where(t280 != 0.0, t13 * t281, 0.0) + np.where(t265 != 0.0, np.where(t280 != 0.0, t225 * t282, 0.0), 0.0)
    t284 = t283 / t1
    t285 = d3 + np.where(t280 != 0.0, d4 * t281, 0.0)
    t286 = (t11 + np.where(t265 != 0.0, np.where(t280 != 0.0, -(t230 * t282), 0.0), 0.0)) / sa2
    t287 = np.where(t265 != 0.0, np.where(t280 != 0.0, t232 * t282, 0.0), 0.0) - t233
    t288 = np.where(t1 != 0.0, t284 * t285, 0.0) + np.where(sa2 != 0.0, t286 * t287, 0.0)
    t289 = np.where(sa2 != 0.0, t285 * t286, 0.0) - np.where(t1 != 0.0, t284 * t287, 0.0)
    t290 = np.sqrt((t288 * t288 + t289 * t289))
    t291 = t288 / t290
    t292 = t289 / t290
    t293 = d2 + (np.where(t290 != 0.0, t285 * t291, 0.0) - np.where(t290 != 0.0, t287 * t292, 0.0))
    t294 = t287 * t291 + t285 * t292
    t295 = r2 + (t242 + np.where(t265 != 0.0, np.where(t280 != 0.0, sa3 * (d4 * t282), 0.0), 0.0))
    t296 = np.where(t290 != 0.0, ca2 * t294, 0.0) - sa2 * t295
    t297 = np.arctan2((y * t293 - x * t296), x * t293 + y * t296)
    t298 = np.where(t265 != 0.0, np.where(t280 != 0.0, t282, 0.0), 0.0)
    t299 = np.where(t280 != 0.0, t281, 0.0)
    t300 = t176 - t180
    t301 = t175 * t300
    t302 = t52 - t300 * t300
    t303 = np.sqrt(np.maximum(0.0, t302))
    t304 = t178 * t303
    t305 = -(t51 * (t301 + t304))
    t306 = t175 * t303
    t307 = t178 * t300
    t308 = t51 * (t306 - t307)
    t309 = np.where(t50 != 0.0, t305, 0.0) + np.where(t54 != 0.0, t308, 0.0)
    t310 = np.where(t50 != 0.0, t308, 0.0) + np.where(t54 != 0.0, t305, 0.0)
    t311 = t43 * t309 - t45 * t310
    t312 = t45 * t309 + t43 * t310
    t313 = t311 + t312
    t314 = t311 - t312
    t315 = np.where(t31 != 0.0, t44 * t311 + t37 * t313 * t314, 0.0) - np.where(t31 != 0.0, t32 * t312, 0.0)
    t316 = t311 + t311
    t317 = t315 - np.where(t31 != 0.0, t312 * (t33 * t316), 0.0)
    t318 = t317 * t317
    t319 = t48 + t200 * t311 + t201 * t312 + t314 * (t33 * t313)
    t320 = t317 / (2e-18 + (t318 + t318)) * (t319 + t312 * (t37 * t316))
    t321 = np.maximum((-0.001), np.minimum(0.001, -np.where(t31 != 0.0, t320, 0.0)))
    t322 = t311 - t312 * t321
    t323 = t312 + t311 * t321
    t324 = np.sqrt((t322 * t322 + t323 * t323))
    t325 = t322 / t324
    t326 = np.where(t324 != 0.0, t325, 0.0)
    t327 = t323 / t324
    t328 = t325 + t327
    t329 = t326 - np.where(t324 != 0.0, t327, 0.0)
    t330 = np.where(t31 != 0.0, np.where(t324 != 0.0, t44 * t325, 0.0), 0.0) + np.where(t324 != 0.0, np.where(t31 != 0.0, t37 * t328 * t329, 0.0), 0.0)
    t331 = t325 + t325
    t332 = t330 - np.where(t324 != 0.0, np.where(t31 != 0.0, t32 * t327, 0.0), 0.0) - np.where(t324 != 0.0, np.where(t31 != 0.0, np.where(t324 != 0.0, t327 * (t33 * t331), 0.0), 0.0), 0.0)
    t333 = t332 * t332
    t334 = t217 + np.where(t324 != 0.0, np.where(t31 != 0.0, t200 * t325, 0.0), 0.0) + np.where(t324 != 0.0, np.where(t31 != 0.0, t201 * t327, 0.0), 0.0)
    t335 = t334 + np.where(t324 != 0.0, np.where(t31 != 0.0, t329 * (t33 * t328), 0.0), 0.0) + np.where(t324 != 0.0, np.where(t31 != 0.0, np.where(t324 != 0.0, t327 * (t37 * t331), 0.0), 0.0), 0.0)
    t336 = np.maximum((-0.001), np.minimum(0.001, -(t332 / (2e-18 + (t333 + t333)) * t335)))
    t337 = t326 - np.where(t324 != 0.0, t327 * t336, 0.0)
    t338 = t327 + t325 * t336
    t339 = np.sqrt((t337 * t337 + np.where(t324 != 0.0, np.where(t324 != 0.0, t338 * t338, 0.0), 0.0)))
    t340 = t337 / t339
    t341 = t338 / t339
    t342 = t9 + np.where(t339 != 0.0, t13 * t340, 0.0) + np.where(t324 != 0.0, np.where(t339 != 0.0, t225 * t341, 0.0), 0.0)
    t343 = t342 / t1
    t344 = d3 + np.where(t339 != 0.0, d4 * t340, 0.0)
    t345 = (t11 + np.where(t324 != 0.0, np.where(t339 != 0.0, -(t230 * t341), 0.0), 0.0)) / sa2
    t346 = np.where(t324 != 0.0, np.where(t339 != 0.0, t232 * t341, 0.0), 0.0) - t233
    t347 = np.where(t1 != 0.0, t343 * t344, 0.0) + np.where(sa2 != 0.0, t345 * t346, 0.0)
    t348 = np.where(sa2 != 0.0, t344 * t345, 0.0) - np.where(t1 != 0.0, t343 * t346, 0.0)
    t349 = np.sqrt((t347 * t347 + t348 * t348))
    t350 = t347 / t349
    t351 = t348 / t349
    t352 = d2 + (np.where(t349 != 0.0, t344 * t350, 0.0) - np.where(t349 != 0.0, t346 * t351, 0.0))
    t353 = t346 * t350 + t344 * t351
    t354 = r2 + (t242 + np.where(t324 != 0.0, np.where(t339 != 0.0, sa3 * (d4 * t341), 0.0), 0.0))
    t355 = np.where(t349 != 0.0, ca2 * t353, 0.0) - sa2 * t354
    t356 = np.arctan2((y * t352 - x * t355), x * t352 + y * t355)
    t357 = np.where(t324 != 0.0, np.where(t339 != 0.0, t341, 0.0), 0.0)
    t358 = np.where(t339 != 0.0, t340, 0.0)
    t359 = t51 * (t304 - t301)
    t360 = -(t51 * (t306 + t307))
    t361 = np.where(t50 != 0.0, t359, 0.0) + np.where(t54 != 0.0, t360, 0.0)
    t362 = np.where(t50 != 0.0, t360, 0.0) + np.where(t54 != 0.0, t359, 0.0)
    t363 = t43 * t361 - t45 * t362
    t364 = t45 * t361 + t43 * t362
    t365 = t363 + t364
    t366 = t363 - t364
    t367 = np.where(t31 != 0.0, t44 * t363 + t37 * t365 * t366, 0.0) - np.where(t31 != 0.0, t32 * t364, 0.0)
    t368 = t363 + t363
    t369 = t367 - np.where(t31 != 0.0, t364 * (t33 * t368), 0.0)
    t370 = t369 * t369
    t371 = t48 + t200 * t363 + t201 * t364 + t366 * (t33 * t365)
    t372 = t369 / (2e-18 + (t370 + t370)) * (t371 + t364 * (t37 * t368))
    t373 = np.maximum((-0.001), np.minimum(0.001, -np.where(t31 != 0.0, t372, 0.0)))
    t374 = t363 - t364 * t373
    t375 = t364 + t363 * t373
    t376 = np.sqrt((t374 * t374 + t375 * t375))
    t377 = t374 / t376
    t378 = np.where(t376 != 0.0, t377, 0.0)
    t379 = t375 / t376
    t380 = t377 + t379
    t381 = t378 - np.where(t376 != 0.0, t379, 0.0)
    t382 = np.where(t31 != 0.0, np.where(t376 != 0.0, t44 * t377, 0.0), 0.0) + np.where(t376 != 0.0, np.where(t31 != 0.0, t37 * t380 * t381, 0.0), 0.0)
    t383 = t377 + t377
    t384 = t382 - np.where(t376 != 0.0, np.where(t31 != 0.0, t32 * t379, 0.0), 0.0) - np.where(t376 != 0.0, np.where(t31 != 0.0, np.where(t376 != 0.0, t379 * (t33 * t383), 0.0), 0.0), 0.0)
    t385 = t384 * t384
    t386 = t217 + np.where(t376 != 0.0, np.where(t31 != 0.0, t200 * t377, 0.0), 0.0) + np.where(t376 != 0.0, np.where(t31 != 0.0, t201 * t379, 0.0), 0.0)
    t387 = t386 + np.where(t376 != 0.0, np.where(t31 != 0.0, t381 * (t33 * t380), 0.0), 0.0) + np.where(t376 != 0.0, np.where(t31 != 0.0, np.where(t376 != 0.0, t379 * (t37 * t383), 0.0), 0.0), 0.0)
    t388 = np.maximum((-0.001), np.minimum(0.001, -(t384 / (2e-18 + (t385 + t385)) * t387)))
    t389 = t378 - np.where(t376 != 0.0, t379 * t388, 0.0)
    t390 = t379 + t377 * t388
    t391 = np.sqrt((t389 * t389 + np.where(t376 != 0.0, np.where(t376 != 0.0, t390 * t390, 0.0), 0.0)))
    t392 = t389 / t391
    t393 = t390 / t391
    t394 = t9 + np.where(t391 != 0.0, t13 * t392, 0.0) + np.where(t376 != 0.0, np.where(t391 != 0.0, t225 * t393, 0.0), 0.0)
    t395 = t394 / t1
    t396 = d3 + np.where(t391 != 0.0, d4 * t392, 0.0)
    t397 = (t11 + np.where(t376 != 0.0, np.where(t391 != 0.0, -(t230 * t393), 0.0), 0.0)) / sa2
    t398 = np.where(t376 != 0.0, np.where(t391 != 0.0, t232 * t393, 0.0), 0.0) - t233
    t399 = np.where(t1 != 0.0, t395 * t396, 0.0) + np.where(sa2 != 0.0, t397 * t398, 0.0)
    t400 = np.where(sa2 != 0.0, t396 * t397, 0.0) - np.where(t1 != 0.0, t395 * t398, 0.0)
    t401 = np.sqrt((t399 * t399 + t400 * t400))
    t402 = t399 / t401
    t403 = t400 / t401
    t404 = d2 + (np.where(t401 != 0.0, t396 * t402, 0.0) - np.where(t401 != 0.0, t398 * t403, 0.0))
    t405 = t398 * t402 + t396 * t403
    t406 = r2 + (t242 + np.where(t376 != 0.0, np.where(t391 != 0.0, sa3 * (d4 * t393), 0.0), 0.0))
    t407 = np.where(t401 != 0.0, ca2 * t405, 0.0) - sa2 * t406
    t408 = np.arctan2((y * t404 - x * t407), x * t404 + y * t407)
    t409 = np.where(t376 != 0.0, np.where(t391 != 0.0, t393, 0.0), 0.0)
    t410 = np.where(t391 != 0.0, t392, 0.0)
    t411 = np.sqrt(t2)
    t412 = np.sqrt((t240 * t240 + t244 * t244)) - t411
    t413 = np.where(t237 != 0.0, sa2 * t241, 0.0) + ca2 * t243 - z
    t414 = np.sqrt((t293 * t293 + t296 * t296)) - t411
    t415 = np.where(t290 != 0.0, sa2 * t294, 0.0) + ca2 * t295 - z
    t416 = np.sqrt((t352 * t352 + t355 * t355)) - t411
    t417 = np.where(t349 != 0.0, sa2 * t353, 0.0) + ca2 * t354 - z
    t418 = np.sqrt((t404 * t404 + t407 * t407)) - t411
    t419 = np.where(t401 != 0.0, sa2 * t405, 0.0) + ca2 * t406 - z
    t420 = np.where(t223 != 0.0, t44 * t224, 0.0) + t37 * (t246 + t247) * (t247 - t246)
    t421 = np.where(t207 != 0.0, np.where(t223 != 0.0, np.where(t31 != 0.0, np.where(t223 != 0.0, t226 * (t33 * (t224 + t224)), 0.0), 0.0), 0.0), 0.0)
    t422 = np.where(t31 != 0.0, t420, 0.0) - np.where(t207 != 0.0, np.where(t223 != 0.0, np.where(t31 != 0.0, t32 * t226, 0.0), 0.0), 0.0) - t421
    t423 = np.where(t280 != 0.0, t44 * t281, 0.0) + t37 * (t298 + t299) * (t299 - t298)
    t424 = np.where(t265 != 0.0, np.where(t280 != 0.0, np.where(t31 != 0.0, np.where(t280 != 0.0, t282 * (t33 * (t281 + t281)), 0.0), 0.0), 0.0), 0.0)
    t425 = np.where(t31 != 0.0, t423, 0.0) - np.where(t265 != 0.0, np.where(t280 != 0.0, np.where(t31 != 0.0, t32 * t282, 0.0), 0.0), 0.0) - t424
    t426 = np.where(t339 != 0.0, t44 * t340, 0.0) + t37 * (t357 + t358) * (t358 - t357)
    t427 = np.where(t324 != 0.0, np.where(t339 != 0.0, np.where(t31 != 0.0, np.where(t339 != 0.0, t341 * (t33 * (t340 + t340)), 0.0), 0.0), 0.0), 0.0)
    t428 = np.where(t31 != 0.0, t426, 0.0) - np.where(t324 != 0.0, np.where(t339 != 0.0, np.where(t31 != 0.0, t32 * t341, 0.0), 0.0), 0.0) - t427
    t429 = np.where(t391 != 0.0, t44 * t392, 0.0) + t37 * (t409 + t410) * (t410 - t409)
    t430 = np.where(t376 != 0.0, np.where(t391 != 0.0, np.where(t31 != 0.0, np.where(t391 != 0.0, t393 * (t33 * (t392 + t392)), 0.0), 0.0), 0.0), 0.0)
    t431 = np.where(t31 != 0.0, t429, 0.0) - np.where(t376 != 0.0, np.where(t391 != 0.0, np.where(t31 != 0.0, t32 * t393, 0.0), 0.0), 0.0) - t430
    t432 = t48 * t48
    t433 = t38 + t33 * t33
    t434 = t32 * t32
    t435 = t44 * t44
    t436 = t434 + t435
    t437 = np.where(t31 != 0.0, np.where(t31 != 0.0, t432 + 3 * t433, 0.0), 0.0) - np.where(t31 != 0.0, np.where(t31 != 0.0, 3 * t436, 0.0), 0.0)
    t438 = t437 * t437
    t439 = t33 * (np.where(t31 != 0.0, np.where(t31 != 0.0, t434, 0.0), 0.0) - np.where(t31 != 0.0, np.where(t31 != 0.0, t435, 0.0), 0.0)) + np.where(t31 != 0.0, np.where(t31 != 0.0, t44 * (t37 * t200), 0.0), 0.0)
    t440 = np.where(t31 != 0.0, np.where(t31 != 0.0, t432 + t432, 0.0), 0.0) - np.where(t31 != 0.0, np.where(t31 != 0.0, 18 * t433, 0.0), 0.0)
    t441 = 27 * t439 + t48 * (t440 - np.where(t31 != 0.0, np.where(t31 != 0.0, 9 * t436, 0.0), 0.0))
    t442 = 4 * t437 * t438 - np.where(t31 != 0.0, np.where(t31 != 0.0, t441 * t441, 0.0), 0.0)
    t443 = 0.5 + 0.5 * np.copysign(1, t442)
    t444 = np.maximum(d2, -d2)
    t445 = np.maximum(ca2, -ca2)
    t446 = t445 + t445
    t447 = t444 * t446
    t448 = np.maximum(r2, -r2)
    t449 = np.maximum(ca3, -ca3)
    t450 = np.maximum(r3, -r3)
    t451 = (t444 + t444) * np.maximum(z, -z) + t447 * t448 + t444 * (t446 * t449) * t450
    t452 = np.maximum(d4, -d4)
    t453 = np.maximum(sa3, -sa3)
    t454 = t451 + t447 * t452 * t453
    t455 = np.maximum(sa2, -sa2)
    t456 = t4 * t455 + t5 * t455 + t6 * t455 + t7 * t455
    t457 = t456 + t8 * t455 + t3 * t455 + t455 * np.maximum(t2, -t2)
    t458 = np.maximum(d3, -d3)
    t459 = t457 + t455 * (t452 * (t458 + t458)) + t455 * (t450 * (t448 * (t449 + t449)))
    t460 = t459 + t453 * (t455 * (t448 * (t452 + t452)))
    t461 = t449 * t452 + t450 * t453
    t462 = t452 + t458
    t463 = t454 * t454 + t460 * t460 + t22 * (t461 * t461 + t462 * t462)
    t464 = 3.552713678800501e-15 / t31 * t463
    t465 = -0.3333333333333333 * t437
    t466 = np.where(t31 != 0.0, np.where(t31 != 0.0, t433 + t436, 0.0), 0.0) - np.where(t31 != 0.0, np.where(t31 != 0.0, 0.5555555555555556 * t432, 0.0), 0.0)
    t467 = 1.3333333333333333 * t48
    t468 = t465 * t465 + 3 * (t466 * t466) + np.where(t31 != 0.0, np.where(t31 != 0.0, t465 * (t467 * t467), 0.0), 0.0)
    t469 = t468 + np.where(t31 != 0.0, np.where(t31 != 0.0, t467 * (0.1111111111111111 * t441), 0.0), 0.0) - t466 * (-1.3333333333333333 * t437)
    t470 = 0.016666666666666666 / np.where(t31 != 0.0, t464, 0.0) * np.minimum(t469, 3 * (3 * t466 - -0.6666666666666666 * t437))
    t471 = np.where(t31 != 0.0, t441, 0.0)
    t472 = 72 * t438 + 120 * np.maximum(t471, -t471) + np.where(t31 != 0.0, 5000 * t464, 0.0)
    t473 = np.maximum(t442, -t442) / np.where(t31 != 0.0, t464 * t472, 0.0)

    # results
    angles = np.empty((*_leading, 12), _real)
    room = np.empty((*_leading, 2), _real)
    closure = np.empty((*_leading, 4), _real)
    slope = np.empty((*_leading, 4), _real)
    number = np.empty((*_leading, 1), _real)
    margin = np.empty((*_leading, 1), _real)
    angles[..., 0] = t245
    angles[..., 1] = np.arctan2(np.where(t237 != 0.0, t239, 0.0), np.where(t237 != 0.0, t238, 0.0))
    angles[..., 2] = np.arctan2(t246, t247)
    angles[..., 3] = t297
    angles[..., 4] = np.arctan2(np.where(t290 != 0.0, t292, 0.0), np.where(t290 != 0.0, t291, 0.0))
    angles[..., 5] = np.arctan2(t298, t299)
    angles[..., 6] = t356
    angles[..., 7] = np.arctan2(np.where(t349 != 0.0, t351, 0.0), np.where(t349 != 0.0, t350, 0.0))
    angles[..., 8] = np.arctan2(t357, t358)
    angles[..., 9] = t408
    angles[..., 10] = np.arctan2(np.where(t401 != 0.0, t403, 0.0), np.where(t401 != 0.0, t402, 0.0))
    angles[..., 11] = np.arctan2(t409, t410)
    room[..., 0] = t182
    room[..., 1] = t302
    closure[..., 0] = np.sqrt((t412 * t412 + t413 * t413))
    closure[..., 1] = np.sqrt((t414 * t414 + t415 * t415))
    closure[..., 2] = np.sqrt((t416 * t416 + t417 * t417))
    closure[..., 3] = np.sqrt((t418 * t418 + t419 * t419))
    slope[..., 0] = t422
    slope[..., 1] = t425
    slope[..., 2] = t428
    slope[..., 3] = t431
    number[..., 0] = 2 + t443 * np.copysign(2, t470)
    margin[..., 0] = np.minimum(t473, t473 * (1 - t443) + np.maximum(t470, -t470))
    return angles.reshape(_leading + (4, 3)), room.reshape(_leading + (2,)), closure.reshape(_leading + (4,)), slope.reshape(_leading + (4,)), number.reshape(_leading), margin.reshape(_leading)


def postures_intersecting(parameters, point):
    """the postures of an arm with axes 1 and 2 intersecting, the distance each leaves, and W: 330 operations.

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
    t42 = np.arctan2((y * t36 - x * t41), x * t36 + y * t41)
    t43 = np.arctan2(np.where(t15 != 0.0, np.where(t3 != 0.0, t19, 0.0), 0.0), np.where(t15 != 0.0, t16, 0.0))
    t44 = t28 - t27
    t45 = t30 + t31
    t46 = np.sqrt((t44 * t44 + t45 * t45))
    t47 = t44 / t46
    t48 = t45 / t46
    t49 = d2 + (np.where(t46 != 0.0, t17 * t47, 0.0) - np.where(t46 != 0.0, t21 * t48, 0.0))
    t50 = t21 * t47 + t17 * t48
    t51 = np.where(t46 != 0.0, ca2 * t50, 0.0) - t40
    t52 = np.arctan2((y * t49 - x * t51), x * t49 + y * t51)
    t53 = t4 - np.where(t3 != 0.0, (t8 - t10) / t3, 0.0)
    t54 = (t12 + t13) / t3
    t55 = np.sqrt((t53 * t53 + np.where(t3 != 0.0, np.where(t3 != 0.0, t54 * t54, 0.0), 0.0)))
    t56 = t53 / t55
    t57 = d3 + np.where(t55 != 0.0, d4 * t56, 0.0)
    t58 = t54 / t55
    t59 = np.where(t55 != 0.0, np.where(t3 != 0.0, -(t18 * t58), 0.0), 0.0) - t20
    t60 = t57 * t57 + t59 * t59
    t61 = (t23 + np.where(t55 != 0.0, np.where(t3 != 0.0, t24 * t58, 0.0), 0.0)) / sa2
    t62 = np.sqrt(np.maximum(0.0, t60 - np.where(sa2 != 0.0, np.where(sa2 != 0.0, t61 * t61, 0.0), 0.0)))
    t63 = t57 * t62
    t64 = np.where(sa2 != 0.0, t59 * t61, 0.0)
    t65 = t63 + t64
    t66 = np.where(sa2 != 0.0, t57 * t61, 0.0)
    t67 = t59 * t62
    t68 = t66 - t67
    t69 = np.sqrt((t65 * t65 + t68 * t68))
    t70 = t65 / t69
    t71 = t68 / t69
    t72 = d2 + (np.where(t69 != 0.0, t57 * t70, 0.0) - np.where(t69 != 0.0, t59 * t71, 0.0))
    t73 = t59 * t70 + t57 * t71
    t74 = r2 + (t38 + np.where(t55 != 0.0, np.where(t3 != 0.0, -(sa3 * (d4 * t58)), 0.0), 0.0))
    t75 = sa2 * t74
    t76 = np.where(t69 != 0.0, ca2 * t73, 0.0) - t75
    t77 = np.arctan2((y * t72 - x * t76), x * t72 + y * t76)
    t78 = np.arctan2(np.where(t55 != 0.0, np.where(t3 != 0.0, -t58, 0.0), 0.0), np.where(t55 != 0.0, t56, 0.0))
    t79 = t64 - t63
    t80 = t66 + t67
    t81 = np.sqrt((t79 * t79 + t80 * t80))
    t82 = t79 / t81
    t83 = t80 / t81
    t84 = d2 + (np.where(t81 != 0.0, t57 * t82, 0.0) - np.where(t81 != 0.0, t59 * t83, 0.0))
    t85 = t59 * t82 + t57 * t83
    t86 = np.where(t81 != 0.0, ca2 * t85, 0.0) - t75
    t87 = np.arctan2((y * t84 - x * t86), x * t84 + y * t86)
    t88 = np.sqrt(t5)
    t89 = np.sqrt((t36 * t36 + t41 * t41)) - t88
    t90 = ca2 * t39
    t91 = np.where(t33 != 0.0, sa2 * t37, 0.0) + t90 - z
    t92 = np.sqrt((t49 * t49 + t51 * t51)) - t88
    t93 = t90 + np.where(t46 != 0.0, sa2 * t50, 0.0) - z
    t94 = np.sqrt((t72 * t72 + t76 * t76)) - t88
    t95 = ca2 * t74
    t96 = np.where(t69 != 0.0, sa2 * t73, 0.0) + t95 - z
    t97 = np.sqrt((t84 * t84 + t86 * t86)) - t88
    t98 = t95 + np.where(t81 != 0.0, sa2 * t85, 0.0) - z

    # results
    angles = np.empty((*_leading, 12), _real)
    closure = np.empty((*_leading, 4), _real)
    width = np.empty((*_leading, 4), _real)
    angles[..., 0] = t42
    angles[..., 1] = np.arctan2(np.where(t33 != 0.0, t35, 0.0), np.where(t33 != 0.0, t34, 0.0))
    angles[..., 2] = t43
    angles[..., 3] = t52
    angles[..., 4] = np.arctan2(np.where(t46 != 0.0, t48, 0.0), np.where(t46 != 0.0, t47, 0.0))
    angles[..., 5] = t43
    angles[..., 6] = t77
    angles[..., 7] = np.arctan2(np.where(t69 != 0.0, t71, 0.0), np.where(t69 != 0.0, t70, 0.0))
    angles[..., 8] = t78
    angles[..., 9] = t87
    angles[..., 10] = np.arctan2(np.where(t81 != 0.0, t83, 0.0), np.where(t81 != 0.0, t82, 0.0))
    angles[..., 11] = t78
    closure[..., 0] = np.sqrt((t89 * t89 + t91 * t91))
    closure[..., 1] = np.sqrt((t92 * t92 + t93 * t93))
    closure[..., 2] = np.sqrt((t94 * t94 + t96 * t96))
    closure[..., 3] = np.sqrt((t97 * t97 + t98 * t98))
    width[..., 0] = t22
    width[..., 1] = t22
    width[..., 2] = t60
    width[..., 3] = t60
    return angles.reshape(_leading + (4, 3)), closure.reshape(_leading + (4,)), width.reshape(_leading + (4,))


def postures_parallel(parameters, point):
    """the postures of an arm with axes 1 and 2 parallel, the distance each leaves, and W: 324 operations.

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
    t42 = np.arctan2((y * t36 - x * t41), x * t36 + y * t41)
    t43 = np.arctan2(np.where(t11 != 0.0, -t19, 0.0), np.where(t11 != 0.0, t12, 0.0))
    t44 = t22 - t28
    t45 = t30 + t31
    t46 = np.sqrt((t44 * t44 + t45 * t45))
    t47 = t44 / t46
    t48 = t45 / t46
    t49 = d2 + (np.where(t46 != 0.0, t13 * t47, 0.0) - np.where(t46 != 0.0, -(t25 * t48), 0.0))
    t50 = t25 * t47 - t13 * t48
    t51 = np.where(t46 != 0.0, ca2 * t50, 0.0) - t40
    t52 = np.arctan2((y * t49 - x * t51), x * t49 + y * t51)
    t53 = t4 + t7
    t54 = np.sqrt((t10 + t53 * t53))
    t55 = t53 / t54
    t56 = d3 + np.where(t54 != 0.0, d4 * t55, 0.0)
    t57 = t9 / t54
    t58 = t16 + np.where(t54 != 0.0, t17 * t55, 0.0) + np.where(t54 != 0.0, -(t18 * t57), 0.0)
    t59 = t58 / t1
    t60 = np.where(t1 != 0.0, t56 * t59, 0.0)
    t61 = np.where(t54 != 0.0, -(t23 * t57), 0.0) - t24
    t62 = t56 * t56 + t61 * t61
    t63 = np.sqrt(np.maximum(0.0, t62 - np.where(t1 != 0.0, np.where(t1 != 0.0, t59 * t59, 0.0), 0.0)))
    t64 = t61 * t63
    t65 = t60 + t64
    t66 = t56 * t63
    t67 = np.where(t1 != 0.0, t59 * t61, 0.0)
    t68 = t66 - t67
    t69 = np.sqrt((t65 * t65 + t68 * t68))
    t70 = t65 / t69
    t71 = t68 / t69
    t72 = d2 + (np.where(t69 != 0.0, t56 * t70, 0.0) - np.where(t69 != 0.0, t61 * t71, 0.0))
    t73 = t61 * t70 + t56 * t71
    t74 = r2 + (t38 + np.where(t54 != 0.0, -(sa3 * (d4 * t57)), 0.0))
    t75 = sa2 * t74
    t76 = np.where(t69 != 0.0, ca2 * t73, 0.0) - t75
    t77 = np.arctan2((y * t72 - x * t76), x * t72 + y * t76)
    t78 = np.arctan2(np.where(t54 != 0.0, -t57, 0.0), np.where(t54 != 0.0, t55, 0.0))
    t79 = t60 - t64
    t80 = t66 + t67
    t81 = np.sqrt((t79 * t79 + t80 * t80))
    t82 = t79 / t81
    t83 = t80 / t81
    t84 = d2 + (np.where(t81 != 0.0, t56 * t82, 0.0) - np.where(t81 != 0.0, -(t61 * t83), 0.0))
    t85 = t61 * t82 - t56 * t83
    t86 = np.where(t81 != 0.0, ca2 * t85, 0.0) - t75
    t87 = np.arctan2((y * t84 - x * t86), x * t84 + y * t86)
    t88 = np.sqrt(t14)
    t89 = np.sqrt((t36 * t36 + t41 * t41)) - t88
    t90 = ca2 * t39
    t91 = np.where(t33 != 0.0, t37 * sa2, 0.0) + t90 - z
    t92 = np.sqrt((t49 * t49 + t51 * t51)) - t88
    t93 = t90 + np.where(t46 != 0.0, sa2 * t50, 0.0) - z
    t94 = np.sqrt((t72 * t72 + t76 * t76)) - t88
    t95 = ca2 * t74
    t96 = np.where(t69 != 0.0, sa2 * t73, 0.0) + t95 - z
    t97 = np.sqrt((t84 * t84 + t86 * t86)) - t88
    t98 = t95 + np.where(t81 != 0.0, sa2 * t85, 0.0) - z

    # results
    angles = np.empty((*_leading, 12), _real)
    closure = np.empty((*_leading, 4), _real)
    width = np.empty((*_leading, 4), _real)
    angles[..., 0] = t42
    angles[..., 1] = np.arctan2(np.where(t33 != 0.0, t35, 0.0), np.where(t33 != 0.0, t34, 0.0))
    angles[..., 2] = t43
    angles[..., 3] = t52
    angles[..., 4] = np.arctan2(np.where(t46 != 0.0, -t48, 0.0), np.where(t46 != 0.0, t47, 0.0))
    angles[..., 5] = t43
    angles[..., 6] = t77
    angles[..., 7] = np.arctan2(np.where(t69 != 0.0, t71, 0.0), np.where(t69 != 0.0, t70, 0.0))
    angles[..., 8] = t78
    angles[..., 9] = t87
    angles[..., 10] = np.arctan2(np.where(t81 != 0.0, -t83, 0.0), np.where(t81 != 0.0, t82, 0.0))
    angles[..., 11] = t78
    closure[..., 0] = np.sqrt((t89 * t89 + t91 * t91))
    closure[..., 1] = np.sqrt((t92 * t92 + t93 * t93))
    closure[..., 2] = np.sqrt((t94 * t94 + t96 * t96))
    closure[..., 3] = np.sqrt((t97 * t97 + t98 * t98))
    width[..., 0] = t26
    width[..., 1] = t26
    width[..., 2] = t62
    width[..., 3] = t62
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
    """angles a, b, c with Rz(a) second Rz(b) third Rz(c) = wanted, in two ways; real where |share| <= 1: 265 operations.

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
    t4 = np.where(t3 != 0.0, (wanted_33 - second_33 * third_33) / t3, 0.0)
    t5 = np.maximum((-1), np.minimum(1, t4))
    t6 = t1 * t5
    t7 = np.sqrt(np.maximum(0.0, (1 + t5) * (1 - t5)))
    t8 = t2 * t7
    t9 = (t6 - t8) / t3
    t10 = t2 * t5
    t11 = t1 * t7
    t12 = (t10 + t11) / t3
    t13 = np.where(t3 != 0.0, third_13 * t9, 0.0) - np.where(t3 != 0.0, third_23 * t12, 0.0)
    t14 = third_23 * t9 + third_13 * t12
    t15 = third_33 * second_13
    t16 = t13 * second_11 + np.where(t3 != 0.0, t14 * second_12, 0.0) + t15
    t17 = third_33 * second_23
    t18 = t13 * second_21 + np.where(t3 != 0.0, t14 * second_22, 0.0) + t17
    t19 = t16 * wanted_13 + t18 * wanted_23
    t20 = t16 * wanted_23 - wanted_13 * t18
    t21 = np.sqrt((t19 * t19 + t20 * t20))
    t22 = t20 / t21
    t23 = 1 + np.where(t21 != 0.0, t19 / t21, 0.0) - np.where(t21 != 0.0, 1, 0.0)
    t24 = np.where(t3 != 0.0, t9 * third_12, 0.0) - np.where(t3 != 0.0, t12 * third_22, 0.0)
    t25 = t9 * third_22 + t12 * third_12
    t26 = second_33 * third_32
    t27 = second_13 * third_32
    t28 = second_11 * t24 + np.where(t3 != 0.0, second_12 * t25, 0.0) + t27
    t29 = second_23 * third_32
    t30 = second_21 * t24 + np.where(t3 != 0.0, second_22 * t25, 0.0) + t29
    t31 = (second_31 * t24 + np.where(t3 != 0.0, second_32 * t25, 0.0) + t26) * wanted_31 + wanted_11 * (t23 * t28 - np.where(t21 != 0.0, t22 * t30, 0.0))
    t32 = np.where(t3 != 0.0, t9 * third_11, 0.0) - np.where(t3 != 0.0, t12 * third_21, 0.0)
    t33 = t9 * third_21 + t12 * third_11
    t34 = second_33 * third_31
    t35 = second_13 * third_31
    t36 = second_11 * t32 + np.where(t3 != 0.0, second_12 * t33, 0.0) + t35
    t37 = second_23 * third_31
    t38 = second_21 * t32 + np.where(t3 != 0.0, second_22 * t33, 0.0) + t37
    t39 = wanted_31 * (second_31 * t32 + np.where(t3 != 0.0, second_32 * t33, 0.0) + t34) + wanted_11 * (t23 * t36 - np.where(t21 != 0.0, t22 * t38, 0.0))
    t40 = np.arctan2((t31 + wanted_21 * (t23 * t30 + np.where(t21 != 0.0, t22 * t28, 0.0))), t39 + wanted_21 * (t23 * t38 + np.where(t21 != 0.0, t22 * t36, 0.0)))
    t41 = (t6 + t8) / t3
    t42 = (t10 - t11) / t3
    t43 = third_23 * t41 + third_13 * t42
    t44 = np.where(t3 != 0.0, third_13 * t41, 0.0) - np.where(t3 != 0.0, third_23 * t42, 0.0)
    t45 = t15 + (np.where(t3 != 0.0, second_12 * t43, 0.0) + second_11 * t44)
    t46 = t17 + (np.where(t3 != 0.0, second_22 * t43, 0.0) + second_21 * t44)
    t47 = wanted_13 * t45 + wanted_23 * t46
    t48 = wanted_23 * t45 - wanted_13 * t46
    t49 = np.sqrt((t47 * t47 + t48 * t48))
    t50 = t48 / t49
    t51 = 1 + np.where(t49 != 0.0, t47 / t49, 0.0) - np.where(t49 != 0.0, 1, 0.0)
    t52 = third_22 * t41 + third_12 * t42
    t53 = np.where(t3 != 0.0, third_12 * t41, 0.0) - np.where(t3 != 0.0, third_22 * t42, 0.0)
    t54 = t27 + (np.where(t3 != 0.0, second_12 * t52, 0.0) + second_11 * t53)
    t55 = t29 + (np.where(t3 != 0.0, second_22 * t52, 0.0) + second_21 * t53)
    t56 = wanted_31 * (t26 + (np.where(t3 != 0.0, second_32 * t52, 0.0) + second_31 * t53)) + wanted_11 * (t51 * t54 - np.where(t49 != 0.0, t50 * t55, 0.0))
    t57 = np.where(t3 != 0.0, third_11 * t41, 0.0) - np.where(t3 != 0.0, third_21 * t42, 0.0)
    t58 = third_21 * t41 + third_11 * t42
    t59 = t35 + (second_11 * t57 + np.where(t3 != 0.0, second_12 * t58, 0.0))
    t60 = t37 + (second_21 * t57 + np.where(t3 != 0.0, second_22 * t58, 0.0))
    t61 = wanted_31 * (t34 + (second_31 * t57 + np.where(t3 != 0.0, second_32 * t58, 0.0))) + wanted_11 * (t51 * t59 - np.where(t49 != 0.0, t50 * t60, 0.0))
    t62 = np.arctan2((t56 + wanted_21 * (t51 * t55 + np.where(t49 != 0.0, t50 * t54, 0.0))), t61 + wanted_21 * (t51 * t60 + np.where(t49 != 0.0, t50 * t59, 0.0)))

    # results
    angles = np.empty((*_leading, 6), _real)
    share = np.empty((*_leading, 1), _real)
    angles[..., 0] = np.arctan2(np.where(t21 != 0.0, t22, 0.0), t23)
    angles[..., 1] = np.arctan2(np.where(t3 != 0.0, t12, 0.0), np.where(t3 != 0.0, t9, 0.0))
    angles[..., 2] = t40
    angles[..., 3] = np.arctan2(np.where(t49 != 0.0, t50, 0.0), t51)
    angles[..., 4] = np.arctan2(np.where(t3 != 0.0, t42, 0.0), np.where(t3 != 0.0, t41, 0.0))
    angles[..., 5] = t62
    share[..., 0] = t4
    return angles.reshape(_leading + (2, 3)), share.reshape(_leading + (1,))


def spherical_elbow(before, behind, square):
    """angles of a joint, in two ways, at which a point behind it is sqrt(square) from one before it: 58 operations.

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
    t4 = 0.5 * (s1 * s1) + 0.5 * (s2 * s2) + 0.5 * (s3 * s3)
    t5 = t4 + 0.5 * (w1 * w1) + 0.5 * (w2 * w2) + 0.5 * (w3 * w3)
    t6 = np.where(t3 != 0.0, (t5 - 0.5 * distance_squared - s3 * w3) / t3, 0.0)
    t7 = np.maximum((-1), np.minimum(1, t6))
    t8 = t2 * t7
    t9 = np.sqrt(np.maximum(0.0, (1 + t7) * (1 - t7)))
    t10 = t1 * t9
    t11 = t1 * t7
    t12 = t2 * t9
    t13 = np.arctan2(np.where(t3 != 0.0, (t8 + t10) / t3, 0.0), np.where(t3 != 0.0, (t11 - t12) / t3, 0.0))
    t14 = np.arctan2(np.where(t3 != 0.0, (t8 - t10) / t3, 0.0), np.where(t3 != 0.0, (t11 + t12) / t3, 0.0))

    # results
    angles = np.empty((*_leading, 2), _real)
    share = np.empty((*_leading, 1), _real)
    angles[..., 0] = t13
    angles[..., 1] = t14
    share[..., 0] = t6
    return angles.reshape(_leading + (2,)), share.reshape(_leading + (1,))
