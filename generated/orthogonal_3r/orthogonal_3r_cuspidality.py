"""cuspidality of orthogonal_3r, in NumPy.

Made from templates/kernel.py.j2; inputs 5115df605f1fdc3d6f77f19223b735215dc80e9e1f9a9d3ac278a83f3c8911a8.
707 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def quartic(parameters, target):
    """coefficients, lowest power of tan(theta3/2) first, of the quartic whose roots are the postures at a target: 48 operations.

    in   parameters[4] = (d2, d3, d4, r2)
    in   target[2] = (rho_squared, z)
    out  quartic[5]
    """
    parameters = np.asarray(parameters)
    target = np.asarray(target)
    _leading = np.broadcast_shapes(parameters.shape[:-1], target.shape[:-1])
    _real = np.result_type(parameters, target, np.float32)

    # inputs, sines and cosines
    rho_squared = target[..., 0]
    z = target[..., 1]
    d2 = parameters[..., 0]
    d3 = parameters[..., 1]
    d4 = parameters[..., 2]
    r2 = parameters[..., 3]

    # terms
    t1 = z * z
    t2 = d2 * d2
    t3 = d3 * d3
    t4 = d4 * d4
    t5 = rho_squared + t1 - t2 - t3 - t4 - r2 * r2
    t6 = d4 * (-2 * d3)
    t7 = t5 + t6
    t8 = 4 * t2
    t9 = t1 * t8
    t10 = d4 * (d3 + d3)
    t11 = t7 + t7
    t12 = r2 * (-2 * d4)
    t13 = t12 + t12
    t14 = t5 - t6
    t15 = t13 * t13 + t1 * (8 * t2) + t11 * t14 - t8 * (t3 + t3 - (t4 + t4))

    # results
    quartic = np.empty((*_leading, 5), _real)
    quartic[..., 0] = t7 * t7 + t9 - t8 * (t4 + (t3 + t10))
    quartic[..., 1] = t11 * t13
    quartic[..., 2] = t15
    quartic[..., 3] = t14 * (4 * t12)
    quartic[..., 4] = t9 + t14 * t14 - t8 * (t3 + t4 - t10)
    return quartic.reshape(_leading + (5,))


def cusp_polynomial(parameters):
    """coefficients, lowest power first, of the polynomial in tan(theta3/2) whose roots are the cusps, for alpha2 = +-90 deg: those with z^2 >= 0: 36 operations.

    in   parameters[4] = (d2, d3, d4, r2)
    out  polynomial[7]
    """
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(parameters.shape[:-1])
    _real = np.result_type(parameters, np.float32)

    # inputs, sines and cosines
    d3 = parameters[..., 1]
    d2 = parameters[..., 0]
    r2 = parameters[..., 3]
    d4 = parameters[..., 2]

    # terms
    t1 = d2 * d2
    t2 = d3 * t1 * r2
    t3 = d3 * d3
    t4 = r2 * (3 * d4) * t3
    t5 = r2 * r2
    t6 = r2 * d4 * (t1 + t5 - 3 * t3)
    t7 = d3 * d4
    t8 = t7 * (t3 - t1 - 3 * t5)
    t9 = t7 * (t1 - t3)
    t10 = t8 + t8 + (t9 + t9)
    t11 = 3 * t2
    t12 = 3 * t6

    # results
    polynomial = np.empty((*_leading, 7), _real)
    polynomial[..., 0] = t2 + t4 + t6
    polynomial[..., 1] = t10
    polynomial[..., 2] = t4 + t11 - t12
    polynomial[..., 3] = 4 * t9 - 4 * t8
    polynomial[..., 4] = t11 + t12 - t4
    polynomial[..., 5] = t10
    polynomial[..., 6] = t2 - t4 - t6
    return polynomial.reshape(_leading + (7,))


def aspect_polynomial(parameters):
    """coefficients, lowest power first, of the polynomial in tan(theta3/2) that is (a^2 + b^2 - c^2)/d4^2, divided by (d3 + d4 c3)^2: 14 operations.

    in   parameters[4] = (d2, d3, d4, r2)
    out  polynomial[5]
    """
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(parameters.shape[:-1])
    _real = np.result_type(parameters, np.float32)

    # inputs, sines and cosines
    d3 = parameters[..., 1]
    d2 = parameters[..., 0]
    r2 = parameters[..., 3]

    # terms
    t1 = d3 * d3
    t2 = d2 * d2
    t3 = t1 - t2
    t4 = t2 + r2 * r2 - t1
    t5 = t3 + t4
    t6 = r2 * (-2 * d3)

    # results
    polynomial = np.empty((*_leading, 5), _real)
    polynomial[..., 0] = t5
    polynomial[..., 1] = t6 + t6
    polynomial[..., 2] = t3 + t3 - (t4 + t4)
    polynomial[..., 3] = -2 * t6
    polynomial[..., 4] = t5
    return polynomial.reshape(_leading + (5,))


def determinant_terms(parameters, elbow):
    """a, b, c of det J = a cos(theta2) + b sin(theta2) + c, from cos(theta3) and sin(theta3): 12 operations.

    in   parameters[4] = (d2, d3, d4, r2)
    in   elbow[2] = (c3, s3)
    out  terms[3]
    """
    parameters = np.asarray(parameters)
    elbow = np.asarray(elbow)
    _leading = np.broadcast_shapes(parameters.shape[:-1], elbow.shape[:-1])
    _real = np.result_type(parameters, elbow, np.float32)

    # inputs, sines and cosines
    d4 = parameters[..., 2]
    d3 = parameters[..., 1]
    c3 = elbow[..., 0]
    r2 = parameters[..., 3]
    s3 = elbow[..., 1]
    d2 = parameters[..., 0]

    # terms
    t1 = d4 * c3
    t2 = d3 * s3

    # results
    terms = np.empty((*_leading, 3), _real)
    terms[..., 0] = -(d4 * (d3 + t1) * (c3 * r2 - t2))
    terms[..., 1] = 0.0
    terms[..., 2] = d4 * d2 * (t2 + t1 * s3)
    return terms.reshape(_leading + (3,))


def determinant(parameters, shoulder, elbow):
    """det J, the determinant of the position Jacobian: 13 operations.

    in   parameters[4] = (d2, d3, d4, r2)
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
    d2 = parameters[..., 0]
    d4 = parameters[..., 2]
    d3 = parameters[..., 1]
    s3 = elbow[..., 1]
    c3 = elbow[..., 0]
    c2 = shoulder[..., 0]
    r2 = parameters[..., 3]

    # terms
    t1 = d3 * s3
    t2 = d4 * c3
    t3 = d2 * d4 * (t1 + s3 * t2) - d4 * c2 * (d3 + t2) * (c3 * r2 - t1)

    # results
    determinant = np.empty((*_leading, 1), _real)
    determinant[..., 0] = t3
    return determinant.reshape(_leading)


def second_axis(parameters):
    """coefficients of 1 and t^2 in (1 + t^2) f1, t = tan(theta3/2), which is 0 where the point is on axis 2: 2 operations.

    in   parameters[4] = (d2, d3, d4, r2)
    out  polynomial[2]
    """
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(parameters.shape[:-1])
    _real = np.result_type(parameters, np.float32)

    # inputs, sines and cosines
    d3 = parameters[..., 1]
    d4 = parameters[..., 2]

    # terms

    # results
    polynomial = np.empty((*_leading, 2), _real)
    polynomial[..., 0] = d3 + d4
    polynomial[..., 1] = d3 - d4
    return polynomial.reshape(_leading + (2,))


def triple_point(parameters, elbow):
    """numerators of rho^2 and of z^2 of the cusp at a root of the cusp polynomial, and their denominator: 45 operations.

    in   parameters[4] = (d2, d3, d4, r2)
    in   elbow[2] = (c3, s3)
    out  cusp[3]
    """
    parameters = np.asarray(parameters)
    elbow = np.asarray(elbow)
    _leading = np.broadcast_shapes(parameters.shape[:-1], elbow.shape[:-1])
    _real = np.result_type(parameters, elbow, np.float32)

    # inputs, sines and cosines
    d2 = parameters[..., 0]
    d3 = parameters[..., 1]
    d4 = parameters[..., 2]
    r2 = parameters[..., 3]
    c3 = elbow[..., 0]
    s3 = elbow[..., 1]

    # terms
    t1 = d2 * d2
    t2 = d3 * d3
    t3 = r2 * r2
    t4 = d3 * c3 + r2 * s3
    t5 = t1 + t2 + d4 * d4 + t3 + (d4 + d4) * t4
    t6 = t2 + t3
    t7 = t1 * (t6 * t6)
    t8 = d3 * s3
    t9 = r2 * c3 - t8
    t10 = d4 * c3
    t11 = d3 + t10
    t12 = d4 * (t9 * t9) - t1 * (d4 * (s3 * s3) - c3 * t11)
    t13 = t9 * (t1 * (t8 + s3 * t10)) - t4 * t12
    t14 = t7 * (t11 * t11) - t13 * t13

    # results
    cusp = np.empty((*_leading, 3), _real)
    cusp[..., 0] = t5 * t7 + t6 * ((t1 + t1) * t13) - t14
    cusp[..., 1] = t14
    cusp[..., 2] = t7
    return cusp.reshape(_leading + (3,))


def image(parameters, shoulder, elbow):
    """rho^2 and z of the point, from the cosines and sines of theta2 and theta3: 11 operations.

    in   parameters[4] = (d2, d3, d4, r2)
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
    d3 = parameters[..., 1]
    c3 = elbow[..., 0]
    d4 = parameters[..., 2]
    d2 = parameters[..., 0]
    s3 = elbow[..., 1]
    r2 = parameters[..., 3]
    s2 = shoulder[..., 1]

    # terms
    t1 = d3 + c3 * d4
    t2 = c2 * t1 + d2
    t3 = d4 * s3 + r2

    # results
    target = np.empty((*_leading, 2), _real)
    target[..., 0] = t2 * t2 + t3 * t3
    target[..., 1] = -(t1 * s2)
    return target.reshape(_leading + (2,))


def conic_terms(parameters):
    """the conic E whose double contact with the unit circle is a node, by powers of R and z: 55 operations.

    in   parameters[4] = (d2, d3, d4, r2)
    out  conic[6][5]
    """
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(parameters.shape[:-1])
    _real = np.result_type(parameters, np.float32)

    # inputs, sines and cosines
    d4 = parameters[..., 2]
    d3 = parameters[..., 1]
    d2 = parameters[..., 0]
    r2 = parameters[..., 3]

    # terms
    t1 = d4 * d4
    t2 = 4 * t1
    t3 = d3 * d3
    t4 = d2 * d2
    t5 = r2 * r2
    t6 = t5 + (t1 + (t3 + t4))
    t7 = d2 * (d2 * t4) + d3 * (d3 * t3) + d4 * (d4 * t1)
    t8 = t4 + t4
    t9 = t7 + r2 * (r2 * t5) + t1 * t8 + t5 * t8
    t10 = t3 + t3
    t11 = t9 + t1 * t10 + t5 * t10 + t5 * (t1 + t1)

    # results
    conic = np.empty((*_leading, 30), _real)
    conic[..., 0] = t2 * (t3 - t4)
    conic[..., 1] = 0.0
    conic[..., 2] = 0.0
    conic[..., 3] = 0.0
    conic[..., 4] = 0.0
    conic[..., 5] = t1 * (4 * d3 * r2)
    conic[..., 6] = 0.0
    conic[..., 7] = 0.0
    conic[..., 8] = 0.0
    conic[..., 9] = 0.0
    conic[..., 10] = t2 * t5
    conic[..., 11] = 0.0
    conic[..., 12] = 0.0
    conic[..., 13] = 0.0
    conic[..., 14] = 0.0
    conic[..., 15] = d4 * (d3 + d3) * (t5 + (t1 + t3) - t4)
    conic[..., 16] = d4 * (-2 * d3)
    conic[..., 17] = 0.0
    conic[..., 18] = 0.0
    conic[..., 19] = 0.0
    conic[..., 20] = r2 * (d4 + d4) * t6
    conic[..., 21] = r2 * (-2 * d4)
    conic[..., 22] = 0.0
    conic[..., 23] = 0.0
    conic[..., 24] = 0.0
    conic[..., 25] = t11 - t3 * t8
    conic[..., 26] = -2 * t6
    conic[..., 27] = 0.0
    conic[..., 28] = 1
    conic[..., 29] = 4 * t4
    return conic.reshape(_leading + (6, 5))


def shoulder(parameters, target, elbow):
    """numbers in the ratio of cos(theta2) and sin(theta2) of a posture at a target, and W: 24 operations.

    in   parameters[4] = (d2, d3, d4, r2)
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
    d2 = parameters[..., 0]
    d3 = parameters[..., 1]
    d4 = parameters[..., 2]
    r2 = parameters[..., 3]
    c3 = elbow[..., 0]
    s3 = elbow[..., 1]

    # terms
    t1 = d2 * d2
    t2 = rho_squared + z * z - t1 - d3 * d3 - d4 * d4
    t3 = t2 - r2 * r2 - (d4 + d4) * (d3 * c3 + r2 * s3)
    t4 = d3 + d4 * c3

    # results
    ratio = np.empty((*_leading, 3), _real)
    ratio[..., 0] = d2 * t3 * t4
    ratio[..., 1] = t4 * (t1 * (-2 * z))
    ratio[..., 2] = t4 * t4
    return ratio.reshape(_leading + (3,))


def unturned(parameters, shoulder, elbow):
    """the point at theta1 = 0, from the cosines and sines of theta2 and theta3: 8 operations.

    in   parameters[4] = (d2, d3, d4, r2)
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
    d3 = parameters[..., 1]
    c3 = elbow[..., 0]
    d4 = parameters[..., 2]
    d2 = parameters[..., 0]
    s3 = elbow[..., 1]
    r2 = parameters[..., 3]
    s2 = shoulder[..., 1]

    # terms
    t1 = d3 + c3 * d4

    # results
    point = np.empty((*_leading, 3), _real)
    point[..., 0] = c2 * t1 + d2
    point[..., 1] = d4 * s3 + r2
    point[..., 2] = -(t1 * s2)
    return point.reshape(_leading + (3,))


def number_of_postures(parameters, target):
    """how many postures reach a target; in double precision certainly so where the margin exceeds 1: 172 operations.

    in   parameters[4] = (d2, d3, d4, r2)
    in   target[2] = (rho_squared, z)
    out  number (one number)
    out  margin (one number)
    """
    parameters = np.asarray(parameters)
    target = np.asarray(target)
    _leading = np.broadcast_shapes(parameters.shape[:-1], target.shape[:-1])
    _real = np.result_type(parameters, target, np.float32)

    # inputs, sines and cosines
    d2 = parameters[..., 0]
    d3 = parameters[..., 1]
    d4 = parameters[..., 2]
    r2 = parameters[..., 3]
    rho_squared = target[..., 0]
    z = target[..., 1]

    # terms
    t1 = d2 * d2
    t2 = d3 * d3
    t3 = d4 * d4
    t4 = t1 + t2 + t3 + r2 * r2
    t5 = z * z
    t6 = t4 - rho_squared - t5
    t7 = z * (d2 + d2)
    t8 = d4 * (d3 + d3)
    t9 = 0.5 * (t8 * t8)
    t10 = r2 * (d4 + d4)
    t11 = 0.5 * (t10 * t10)
    t12 = 4 * t1
    t13 = t6 * t6 + t7 * t7 + t9 + t11 - t2 * t12
    t14 = t12 * (0.5 * t3)
    t15 = t13 - t14
    t16 = t6 * t8 - t12 * (0.5 * t8)
    t17 = t9 - t11 - t14
    t18 = np.maximum(t15, -t15) + np.maximum(t16, -t16) + np.maximum(t17, -t17)
    t19 = t8 * t10
    t20 = t6 * t10
    t21 = t18 + np.maximum(t19, -t19) + np.maximum(t20, -t20)
    t22 = np.where(t21 != 0.0, 1, 0.0)
    t23 = t22 / (t21 + (1 - t22))
    t24 = t15 * t23
    t25 = t24 * t24
    t26 = t17 * t23
    t27 = t19 * t23
    t28 = t26 * t26 + t27 * t27
    t29 = t16 * t23
    t30 = t29 * t29
    t31 = t20 * t23
    t32 = t31 * t31
    t33 = t30 + t32
    t34 = t25 + 3 * t28 - 3 * t33
    t35 = t34 * t34
    t36 = 27 * (t26 * (t30 - t32) + t31 * (t27 * (t29 + t29)))
    t37 = t36 + t24 * (t25 + t25 - 18 * t28 - 9 * t33)
    t38 = 4 * t34 * t35 - t37 * t37
    t39 = 0.5 + 0.5 * np.copysign(1, t38)
    t40 = np.maximum(d3, -d3)
    t41 = np.maximum(d4, -d4)
    t42 = t4 + t5 + (t40 + t40) * t41 + (t41 + t41) * np.maximum(r2, -r2)
    t43 = t42 + np.maximum(rho_squared, -rho_squared)
    t44 = t40 + t41
    t45 = np.maximum(d2, -d2)
    t46 = np.maximum(z, -z)
    t47 = t43 * t43 + t12 * (t44 * t44) + 4 * (t45 * t45) * (t46 * t46)
    t48 = 3.552713678800501e-15 * t23 * t47
    t49 = -0.3333333333333333 * t34
    t50 = t28 + t33 - 0.5555555555555556 * t25
    t51 = 1.3333333333333333 * t24
    t52 = t49 * t49 + 3 * (t50 * t50) + t49 * (t51 * t51)
    t53 = np.minimum((t52 + t51 * (0.1111111111111111 * t37) - t50 * (-1.3333333333333333 * t34)), 3 * (3 * t50 - -0.6666666666666666 * t34))
    t54 = 0.016666666666666666 / t48 * t53
    t55 = 72 * t35 + 120 * np.maximum(t37, -t37) + 5000 * t48
    t56 = np.maximum(t38, -t38) / (t48 * t55)

    # results
    number = np.empty((*_leading, 1), _real)
    margin = np.empty((*_leading, 1), _real)
    number[..., 0] = 2 + t39 * np.copysign(2, t54)
    margin[..., 0] = np.minimum(t56, t56 * (1 - t39) + np.maximum(t54, -t54))
    return number.reshape(_leading), margin.reshape(_leading)


def classify(parameters):
    """the domain 1 to 5 and the topology 1 to 9 of a design, each 0 where rounding would decide it: 161 operations.

    in   parameters[4] = (d2, d3, d4, r2)
    out  domain (one number)
    out  topology (one number)
    """
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(parameters.shape[:-1])
    _real = np.result_type(parameters, np.float32)

    # inputs, sines and cosines
    d2 = parameters[..., 0]
    d3 = parameters[..., 1]
    d4 = parameters[..., 2]
    r2 = parameters[..., 3]

    # terms
    t1 = np.maximum(d3, -d3)
    t2 = np.maximum(d2, -d2)
    t3 = np.maximum(d4, -d4)
    t4 = np.maximum(r2, -r2)
    t5 = t1 + t2 + t3 + t4
    t6 = t1 / t5
    t7 = t4 / t5
    t8 = t7 * t7
    t9 = t6 * t6 + t8
    t10 = t9 * t9
    t11 = t2 / t5
    t12 = t11 * t11
    t13 = t6 + t11
    t14 = np.sqrt((t8 + t13 * t13))
    t15 = t6 - t11
    t16 = np.sqrt((t8 + t15 * t15))
    t17 = t14 * t16
    t18 = t3 / t5
    t19 = t18 * t18
    t20 = t19 + t19
    t21 = t10 - t12 * (t6 + t7) * (t6 - t7) + t17 * (t20 - t9)
    t22 = t21 / (t10 + t17 * (t9 + t20) + t9 * t12)
    t23 = t13 * t18
    t24 = t6 * t14
    t25 = (t23 - t24) / (t23 + t24)
    t26 = t18 * np.maximum(t15, t11 - t6)
    t27 = t6 * t16
    t28 = (t26 - t27) / (t26 + t27)
    t29 = np.minimum(np.minimum(np.maximum(t22, -t22), np.maximum(t25, -t25)), np.maximum(t28, -t28))
    t30 = 0.5 + 0.5 * np.copysign(1, t29 - 7.105427357601002e-15)
    t31 = 0.5 + 0.5 * np.copysign(1, t22)
    t32 = 0.5 + 0.5 * np.copysign(1, t25)
    t33 = 0.5 + 0.5 * np.copysign(1, t28)
    t34 = 0.5 + 0.5 * np.copysign(1, t2 - t1)
    t35 = 1 + t31 * (1 + t32 * (1 + t33 * (1 + t34)))
    t36 = t33 * (1 - t34)
    t37 = t31 * (1 - t32)
    t38 = t18 + t18
    t39 = t14 + t16
    t40 = t6 * (4 * t11) / t39
    t41 = (t38 - t40) / (t38 + t40)
    t42 = (t18 - t6) / (t6 + t18)
    t43 = 0.9999999999999929 + t36 + t37 * np.minimum(np.maximum(t41, -t41), np.maximum(t42, -t42))
    t44 = (t38 - t14 - t16) / (t38 + t39)
    t45 = t33 * t34
    t46 = t32 * (1 - t33)
    t47 = np.copysign(1, t43 + np.maximum(t44, -t44) * (t45 + t46) - t31)
    t48 = 0.5 + 0.5 * np.copysign(1, t44)
    t49 = 1 + 6 * t36 + t45 * (7 + t48) + t46 * (4 + t48)
    t50 = (0.5 + 0.5 * np.copysign(1, t41)) * (1 + (0.5 + 0.5 * np.copysign(1, t42)))
    t51 = t30 * (0.5 + 0.5 * t47) * (t49 + t37 * (1 + t50))

    # results
    domain = np.empty((*_leading, 1), _real)
    topology = np.empty((*_leading, 1), _real)
    domain[..., 0] = np.where(d2 != 0.0, np.where(d3 != 0.0, np.where(d4 != 0.0, np.where(r2 != 0.0, t30 * t35, 0.0), 0.0), 0.0), 0.0)
    topology[..., 0] = np.where(d2 != 0.0, np.where(d3 != 0.0, np.where(d4 != 0.0, np.where(r2 != 0.0, t51, 0.0), 0.0), 0.0), 0.0)
    return domain.reshape(_leading), topology.reshape(_leading)


def sides(parameters):
    """on which side of C1, C2, C3 or C4, E1, E2, E3 a design lies: above is positive, at most 1: 72 operations.

    in   parameters[4] = (d2, d3, d4, r2)
    out  sides[6]
    """
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(parameters.shape[:-1])
    _real = np.result_type(parameters, np.float32)

    # inputs, sines and cosines
    d3 = parameters[..., 1]
    d2 = parameters[..., 0]
    d4 = parameters[..., 2]
    r2 = parameters[..., 3]

    # terms
    t1 = np.maximum(d3, -d3)
    t2 = np.maximum(d2, -d2)
    t3 = np.maximum(d4, -d4)
    t4 = np.maximum(r2, -r2)
    t5 = t1 + t2 + t3 + t4
    t6 = t1 / t5
    t7 = t4 / t5
    t8 = t7 * t7
    t9 = t6 * t6 + t8
    t10 = t9 * t9
    t11 = t2 / t5
    t12 = t11 * t11
    t13 = t6 + t11
    t14 = np.sqrt((t8 + t13 * t13))
    t15 = t6 - t11
    t16 = np.sqrt((t8 + t15 * t15))
    t17 = t14 * t16
    t18 = t3 / t5
    t19 = t18 * t18
    t20 = t19 + t19
    t21 = t10 - t12 * (t6 + t7) * (t6 - t7) + t17 * (t20 - t9)
    t22 = t13 * t18
    t23 = t6 * t14
    t24 = t18 * np.maximum(t15, t11 - t6)
    t25 = t6 * t16
    t26 = t18 + t18
    t27 = t14 + t16
    t28 = t6 * (4 * t11) / t27

    # results
    sides = np.empty((*_leading, 6), _real)
    sides[..., 0] = t21 / (t10 + t17 * (t9 + t20) + t9 * t12)
    sides[..., 1] = (t22 - t23) / (t22 + t23)
    sides[..., 2] = (t24 - t25) / (t24 + t25)
    sides[..., 3] = (t26 - t28) / (t26 + t28)
    sides[..., 4] = (t18 - t6) / (t6 + t18)
    sides[..., 5] = (t26 - t14 - t16) / (t26 + t27)
    return sides.reshape(_leading + (6,))


def exact_sides(parameters):
    """polynomials whose signs tell on which side of the surfaces a design lies: C1_whole, C1_factor, C1_radicand, C2, C3, E, middle, E2, gap: 34 operations.

    in   parameters[4] = (d2, d3, d4, r2)
    out  sides[9]
    """
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(parameters.shape[:-1])
    _real = np.result_type(parameters, np.float32)

    # inputs, sines and cosines
    d3 = parameters[..., 1]
    r2 = parameters[..., 3]
    d2 = parameters[..., 0]
    d4 = parameters[..., 2]

    # terms
    t1 = d3 * d3
    t2 = r2 * r2
    t3 = t1 + t2
    t4 = d2 * d2
    t5 = d4 * d4
    t6 = d3 + d2
    t7 = t6 * t6
    t8 = t2 + t7
    t9 = d3 - d2
    t10 = t9 * t9
    t11 = t2 + t10

    # results
    sides = np.empty((*_leading, 9), _real)
    sides[..., 0] = t3 * t3 - t4 * (t1 - t2)
    sides[..., 1] = t5 + t5 - t1 - t2
    sides[..., 2] = t8 * t11
    sides[..., 3] = t5 * t7 - t1 * t8
    sides[..., 4] = t5 * t10 - t1 * t11
    sides[..., 5] = t1 * t4 + t5 * (t5 - t4 - t1 - t2)
    sides[..., 6] = t5 - d3 * d2
    sides[..., 7] = d4 - d3
    sides[..., 8] = t9
    return sides.reshape(_leading + (9,))
