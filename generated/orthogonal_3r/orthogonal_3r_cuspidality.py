"""cuspidality of orthogonal_3r, in NumPy.

Made from templates/kernel.py.j2; inputs c8fabad8c3d83fdc1e4020a27e913ee796bebda111423e57414edca53d447656.
2258 operations. Do not edit: change the derivation and regenerate.

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
    """how many postures reach a target; in double precision certainly so where the margin exceeds 1: 198 operations.

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
    t22 = t15 / t21
    t23 = t22 * t22
    t24 = t17 / t21
    t25 = t19 / t21
    t26 = t24 * t24 + t25 * t25
    t27 = t16 / t21
    t28 = t27 * t27
    t29 = t20 / t21
    t30 = t29 * t29
    t31 = t28 + t30
    t32 = np.where(t21 != 0.0, np.where(t21 != 0.0, t23 + 3 * t26, 0.0), 0.0) - np.where(t21 != 0.0, np.where(t21 != 0.0, 3 * t31, 0.0), 0.0)
    t33 = t32 * t32
    t34 = t24 * (np.where(t21 != 0.0, np.where(t21 != 0.0, t28, 0.0), 0.0) - np.where(t21 != 0.0, np.where(t21 != 0.0, t30, 0.0), 0.0)) + np.where(t21 != 0.0, np.where(t21 != 0.0, t29 * (t25 * (t27 + t27)), 0.0), 0.0)
    t35 = np.where(t21 != 0.0, np.where(t21 != 0.0, t23 + t23, 0.0), 0.0) - np.where(t21 != 0.0, np.where(t21 != 0.0, 18 * t26, 0.0), 0.0)
    t36 = 27 * t34 + t22 * (t35 - np.where(t21 != 0.0, np.where(t21 != 0.0, 9 * t31, 0.0), 0.0))
    t37 = 4 * t32 * t33 - np.where(t21 != 0.0, np.where(t21 != 0.0, t36 * t36, 0.0), 0.0)
    t38 = 0.5 + 0.5 * np.copysign(1, t37)
    t39 = np.maximum(d3, -d3)
    t40 = np.maximum(d4, -d4)
    t41 = t4 + t5 + (t39 + t39) * t40 + (t40 + t40) * np.maximum(r2, -r2)
    t42 = t41 + np.maximum(rho_squared, -rho_squared)
    t43 = t39 + t40
    t44 = np.maximum(d2, -d2)
    t45 = np.maximum(z, -z)
    t46 = t42 * t42 + t12 * (t43 * t43) + 4 * (t44 * t44) * (t45 * t45)
    t47 = 3.552713678800501e-15 / t21 * t46
    t48 = -0.3333333333333333 * t32
    t49 = np.where(t21 != 0.0, np.where(t21 != 0.0, t26 + t31, 0.0), 0.0) - np.where(t21 != 0.0, np.where(t21 != 0.0, 0.5555555555555556 * t23, 0.0), 0.0)
    t50 = 1.3333333333333333 * t22
    t51 = t48 * t48 + 3 * (t49 * t49) + np.where(t21 != 0.0, np.where(t21 != 0.0, t48 * (t50 * t50), 0.0), 0.0)
    t52 = t51 + np.where(t21 != 0.0, np.where(t21 != 0.0, t50 * (0.1111111111111111 * t36), 0.0), 0.0) - t49 * (-1.3333333333333333 * t32)
    t53 = 0.016666666666666666 / np.where(t21 != 0.0, t47, 0.0) * np.minimum(t52, 3 * (3 * t49 - -0.6666666666666666 * t32))
    t54 = np.where(t21 != 0.0, t36, 0.0)
    t55 = 72 * t33 + 120 * np.maximum(t54, -t54) + np.where(t21 != 0.0, 5000 * t47, 0.0)
    t56 = np.maximum(t37, -t37) / np.where(t21 != 0.0, t47 * t55, 0.0)

    # results
    number = np.empty((*_leading, 1), _real)
    margin = np.empty((*_leading, 1), _real)
    number[..., 0] = 2 + t38 * np.copysign(2, t53)
    margin[..., 0] = np.minimum(t56, t56 * (1 - t38) + np.maximum(t53, -t53))
    return number.reshape(_leading), margin.reshape(_leading)


def postures(parameters, point):
    """two pairs of postures at a point, the room of each (real if positive), the distances left, the slopes of E: 1540 operations.

    in   parameters[4] = (d2, d3, d4, r2)
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
    d2 = parameters[..., 0]
    x = point[..., 0]
    y = point[..., 1]
    z = point[..., 2]
    d3 = parameters[..., 1]
    d4 = parameters[..., 2]
    r2 = parameters[..., 3]

    # terms
    t1 = d2 + d2
    t2 = x * x + y * y
    t3 = z * z
    t4 = d2 * d2
    t5 = d3 * d3
    t6 = d4 * d4
    t7 = r2 * r2
    t8 = t2 + t3 - t4 - t5 - t6 - t7
    t9 = t7 + (t6 + (t4 + t5))
    t10 = t9 - t2 - t3
    t11 = t1 * z
    t12 = d4 * (d3 + d3)
    t13 = 0.5 * (t12 * t12)
    t14 = r2 * (d4 + d4)
    t15 = 0.5 * (t14 * t14)
    t16 = 4 * t4
    t17 = t10 * t10 + t11 * t11 + t13 + t15 - t5 * t16
    t18 = t16 * (0.5 * t6)
    t19 = t17 - t18
    t20 = t10 * t12 - t16 * (0.5 * t12)
    t21 = t13 - t15 - t18
    t22 = np.maximum(t19, -t19) + np.maximum(t20, -t20) + np.maximum(t21, -t21)
    t23 = t12 * t14
    t24 = t10 * t14
    t25 = t22 + np.maximum(t23, -t23) + np.maximum(t24, -t24)
    t26 = t20 / t25
    t27 = t21 / t25
    t28 = np.where(t25 != 0.0, t27, 0.0)
    t29 = t28 + np.copysign(1e-17, t28)
    t30 = 0.5 + 0.5 * np.copysign(1, t29)
    t31 = t23 / t25
    t32 = t31 * t31
    t33 = np.sqrt((t29 * t29 + np.where(t25 != 0.0, np.where(t25 != 0.0, t32, 0.0), 0.0)))
    t34 = 0.7071067811865476 * np.sqrt(((t33 + np.maximum(t29, -t29)) / t33))
    t35 = 1 - t30
    t36 = np.where(t25 != 0.0, 0.5 * t31 / t34 / t33, 0.0)
    t37 = np.where(t30 != 0.0, t34, 0.0) + np.where(t35 != 0.0, t36, 0.0)
    t38 = t24 / t25
    t39 = np.where(t30 != 0.0, t36, 0.0) + np.where(t35 != 0.0, t34, 0.0)
    t40 = t26 * t37 + t38 * t39
    t41 = np.where(t25 != 0.0, t37 * t38, 0.0) - np.where(t25 != 0.0, t26 * t39, 0.0)
    t42 = t19 / t25
    t43 = np.where(t25 != 0.0, np.where(t25 != 0.0, t40 * t40, 0.0), 0.0) - t41 * t41 - np.where(t25 != 0.0, t33 * t42, 0.0)
    t44 = 0.5 + 0.5 * np.copysign(1, t43)
    t45 = 0.5 / t33
    t46 = t33 + t33
    t47 = np.where(t25 != 0.0, t40, 0.0)
    t48 = 1 - t44
    t49 = np.where(t44 != 0.0, t47, 0.0) + np.where(t48 != 0.0, -t41, 0.0)
    t50 = np.where(t44 != 0.0, t41, 0.0) + np.where(t48 != 0.0, -t47, 0.0)
    t51 = t50 * t50
    t52 = t49 * t49
    t53 = np.where(t25 != 0.0, t42 * (t44 + t44 - 1), 0.0)
    t54 = t51 + t52 - t46 * (t53 - t33)
    t55 = t53 - 3 * t33
    t56 = t33 * (t54 + t33 * (t33 + t55))
    t57 = t33 * (t51 + t51)
    t58 = np.minimum(t33, np.where(t56 != 0.0, t33 * t57 / t56, 0.0))
    t59 = t55 + t55
    t60 = t54 + t58 * (t59 + 3 * t58)
    t61 = t58 * (t54 + t58 * (t55 + t58)) - t57
    t62 = t58 - np.where(t60 != 0.0, t61 / t60, 0.0)
    t63 = 0.5 + 0.5 * np.copysign(1, t61)
    t64 = 1 - t63
    t65 = np.where(t63 != 0.0, t58, 0.0) + np.where(t64 != 0.0, t33, 0.0)
    t66 = np.where(t64 != 0.0, t58, 0.0)
    t67 = np.where((t62 - np.minimum(t65, np.maximum(t62, t66))) != 0.0, 1, 0.0)
    t68 = np.where(t67 != 0.0, 0.5 * t65 + np.where(t64 != 0.0, 0.5 * t58, 0.0), 0.0) + np.where((1 - t67) != 0.0, t62, 0.0)
    t69 = t54 + t68 * (t59 + 3 * t68)
    t70 = t68 * (t54 + t68 * (t55 + t68)) - t57
    t71 = t68 - np.where(t69 != 0.0, t70 / t69, 0.0)
    t72 = 0.5 + 0.5 * np.copysign(1, t70)
    t73 = 1 - t72
    t74 = np.where(t72 != 0.0, t68, 0.0) + np.where(t73 != 0.0, t65, 0.0)
    t75 = np.where(t72 != 0.0, t66, 0.0) + np.where(t73 != 0.0, t68, 0.0)
    t76 = np.where((t71 - np.minimum(t74, np.maximum(t71, t75))) != 0.0, 1, 0.0)
    t77 = np.where(t76 != 0.0, 0.5 * t74 + 0.5 * t75, 0.0) + np.where((1 - t76) != 0.0, t71, 0.0)
    t78 = t54 + t77 * (t59 + 3 * t77)
    t79 = t77 * (t54 + t77 * (t55 + t77)) - t57
    t80 = t77 - np.where(t78 != 0.0, t79 / t78, 0.0)
    t81 = 0.5 + 0.5 * np.copysign(1, t79)
    t82 = 1 - t81
    t83 = np.where(t81 != 0.0, t77, 0.0) + np.where(t82 != 0.0, t74, 0.0)
    t84 = np.where(t81 != 0.0, t75, 0.0) + np.where(t82 != 0.0, t77, 0.0)
    t85 = np.where((t80 - np.minimum(t83, np.maximum(t80, t84))) != 0.0, 1, 0.0)
    t86 = np.where(t85 != 0.0, 0.5 * t83 + 0.5 * t84, 0.0) + np.where((1 - t85) != 0.0, t80, 0.0)
    t87 = t54 + t86 * (t59 + 3 * t86)
    t88 = t86 * (t54 + t86 * (t55 + t86)) - t57
    t89 = t86 - np.where(t87 != 0.0, t88 / t87, 0.0)
    t90 = 0.5 + 0.5 * np.copysign(1, t88)
    t91 = 1 - t90
    t92 = np.where(t90 != 0.0, t86, 0.0) + np.where(t91 != 0.0, t83, 0.0)
    t93 = np.where(t90 != 0.0, t84, 0.0) + np.where(t91 != 0.0, t86, 0.0)
    t94 = np.where((t89 - np.minimum(t92, np.maximum(t89, t93))) != 0.0, 1, 0.0)
    t95 = np.where(t94 != 0.0, 0.5 * t92 + 0.5 * t93, 0.0) + np.where((1 - t94) != 0.0, t89, 0.0)
    t96 = t54 + t95 * (t59 + 3 * t95)
    t97 = t95 * (t54 + t95 * (t55 + t95)) - t57
    t98 = t95 - np.where(t96 != 0.0, t97 / t96, 0.0)
    t99 = 0.5 + 0.5 * np.copysign(1, t97)
    t100 = 1 - t99
    t101 = np.where(t99 != 0.0, t95, 0.0) + np.where(t100 != 0.0, t92, 0.0)
    t102 = np.where(t99 != 0.0, t93, 0.0) + np.where(t100 != 0.0, t95, 0.0)
    t103 = np.where((t98 - np.minimum(t101, np.maximum(t98, t102))) != 0.0, 1, 0.0)
    t104 = np.where(t103 != 0.0, 0.5 * t101 + 0.5 * t102, 0.0) + np.where((1 - t103) != 0.0, t98, 0.0)
    t105 = t54 + t104 * (t59 + 3 * t104)
    t106 = t104 * (t54 + t104 * (t55 + t104)) - t57
    t107 = t104 - np.where(t105 != 0.0, t106 / t105, 0.0)
    t108 = 0.5 + 0.5 * np.copysign(1, t106)
    t109 = 1 - t108
    t110 = np.where(t108 != 0.0, t104, 0.0) + np.where(t109 != 0.0, t101, 0.0)
    t111 = np.where(t108 != 0.0, t102, 0.0) + np.where(t109 != 0.0, t104, 0.0)
    t112 = np.where((t107 - np.minimum(t110, np.maximum(t107, t111))) != 0.0, 1, 0.0)
    t113 = np.where(t112 != 0.0, 0.5 * t110 + 0.5 * t111, 0.0) + np.where((1 - t112) != 0.0, t107, 0.0)
    t114 = t54 + t113 * (t59 + 3 * t113)
    t115 = t113 * (t54 + t113 * (t55 + t113)) - t57
    t116 = t113 - np.where(t114 != 0.0, t115 / t114, 0.0)
    t117 = 0.5 + 0.5 * np.copysign(1, t115)
    t118 = 1 - t117
    t119 = np.where(t117 != 0.0, t113, 0.0) + np.where(t118 != 0.0, t110, 0.0)
    t120 = np.where(t117 != 0.0, t111, 0.0) + np.where(t118 != 0.0, t113, 0.0)
    t121 = np.where((t116 - np.minimum(t119, np.maximum(t116, t120))) != 0.0, 1, 0.0)
    t122 = np.where(t121 != 0.0, 0.5 * t119 + 0.5 * t120, 0.0) + np.where((1 - t121) != 0.0, t116, 0.0)
    t123 = t54 + t122 * (t59 + 3 * t122)
    t124 = t122 * (t54 + t122 * (t55 + t122)) - t57
    t125 = t122 - np.where(t123 != 0.0, t124 / t123, 0.0)
    t126 = 0.5 + 0.5 * np.copysign(1, t124)
    t127 = 1 - t126
    t128 = np.where(t126 != 0.0, t122, 0.0) + np.where(t127 != 0.0, t119, 0.0)
    t129 = np.where(t126 != 0.0, t120, 0.0) + np.where(t127 != 0.0, t122, 0.0)
    t130 = np.where((t125 - np.minimum(t128, np.maximum(t125, t129))) != 0.0, 1, 0.0)
    t131 = np.where(t130 != 0.0, 0.5 * t128 + 0.5 * t129, 0.0) + np.where((1 - t130) != 0.0, t125, 0.0)
    t132 = t54 + t131 * (t59 + 3 * t131)
    t133 = t131 * (t54 + t131 * (t55 + t131)) - t57
    t134 = t131 - np.where(t132 != 0.0, t133 / t132, 0.0)
    t135 = 0.5 + 0.5 * np.copysign(1, t133)
    t136 = 1 - t135
    t137 = np.where(t135 != 0.0, t131, 0.0) + np.where(t136 != 0.0, t128, 0.0)
    t138 = np.where(t135 != 0.0, t129, 0.0) + np.where(t136 != 0.0, t131, 0.0)
    t139 = np.where((t134 - np.minimum(t137, np.maximum(t134, t138))) != 0.0, 1, 0.0)
    t140 = np.where(t139 != 0.0, 0.5 * t137 + 0.5 * t138, 0.0) + np.where((1 - t139) != 0.0, t134, 0.0)
    t141 = t54 + t140 * (t59 + 3 * t140)
    t142 = t140 * (t54 + t140 * (t55 + t140)) - t57
    t143 = t140 - np.where(t141 != 0.0, t142 / t141, 0.0)
    t144 = 0.5 + 0.5 * np.copysign(1, t142)
    t145 = 1 - t144
    t146 = np.where(t144 != 0.0, t140, 0.0) + np.where(t145 != 0.0, t137, 0.0)
    t147 = np.where(t144 != 0.0, t138, 0.0) + np.where(t145 != 0.0, t140, 0.0)
    t148 = np.where((t143 - np.minimum(t146, np.maximum(t143, t147))) != 0.0, 1, 0.0)
    t149 = np.where(t148 != 0.0, 0.5 * t146 + 0.5 * t147, 0.0) + np.where((1 - t148) != 0.0, t143, 0.0)
    t150 = t54 + t149 * (t59 + 3 * t149)
    t151 = t149 * (t54 + t149 * (t55 + t149)) - t57
    t152 = t149 - np.where(t150 != 0.0, t151 / t150, 0.0)
    t153 = 0.5 + 0.5 * np.copysign(1, t151)
    t154 = 1 - t153
    t155 = np.where(t153 != 0.0, t149, 0.0) + np.where(t154 != 0.0, t146, 0.0)
    t156 = np.where(t153 != 0.0, t147, 0.0) + np.where(t154 != 0.0, t149, 0.0)
    t157 = np.where((t152 - np.minimum(t155, np.maximum(t152, t156))) != 0.0, 1, 0.0)
    t158 = np.where(t157 != 0.0, 0.5 * t155 + 0.5 * t156, 0.0) + np.where((1 - t157) != 0.0, t152, 0.0)
    t159 = t54 + t158 * (t59 + 3 * t158)
    t160 = t158 * (t54 + t158 * (t55 + t158)) - t57
    t161 = t158 - np.where(t159 != 0.0, t160 / t159, 0.0)
    t162 = 0.5 + 0.5 * np.copysign(1, t160)
    t163 = 1 - t162
    t164 = np.where(t162 != 0.0, t158, 0.0) + np.where(t163 != 0.0, t155, 0.0)
    t165 = np.where(t162 != 0.0, t156, 0.0) + np.where(t163 != 0.0, t158, 0.0)
    t166 = np.where((t161 - np.minimum(t164, np.maximum(t161, t165))) != 0.0, 1, 0.0)
    t167 = np.where(t166 != 0.0, 0.5 * t164 + 0.5 * t165, 0.0) + np.where((1 - t166) != 0.0, t161, 0.0)
    t168 = t46 - t167
    t169 = np.sqrt(t168)
    t170 = t49 / t169
    t171 = 0.5 + 0.5 * np.copysign(1, t167 - 1e-25)
    t172 = np.sqrt(t167)
    t173 = np.copysign(np.sqrt(np.maximum(0.0, t33 + t52 / t168 - t53 - t167)), t50)
    t174 = np.where(t171 != 0.0, np.where(t172 != 0.0, t50 / t172, 0.0), 0.0) + np.where((1 - t171) != 0.0, t173, 0.0)
    t175 = t170 + t174
    t176 = t46 - t175 * t175
    t177 = np.sqrt(np.maximum(0.0, t176))
    t178 = t172 * t177
    t179 = t169 * t175
    t180 = t45 * (t178 - t179)
    t181 = t172 * t175
    t182 = t169 * t177
    t183 = t45 * (t181 + t182)
    t184 = np.where(t44 != 0.0, t180, 0.0) + np.where(t48 != 0.0, t183, 0.0)
    t185 = np.where(t44 != 0.0, t183, 0.0) + np.where(t48 != 0.0, t180, 0.0)
    t186 = t37 * t184 - t39 * t185
    t187 = t39 * t184 + t37 * t185
    t188 = t186 + t187
    t189 = t186 - t187
    t190 = np.where(t25 != 0.0, t38 * t186 + t31 * t188 * t189, 0.0) - np.where(t25 != 0.0, t26 * t187, 0.0)
    t191 = t186 + t186
    t192 = t190 - np.where(t25 != 0.0, t187 * (t27 * t191), 0.0)
    t193 = t192 * t192
    t194 = t26 + t26
    t195 = t38 + t38
    t196 = t42 + t186 * t194 + t187 * t195 + t189 * (t27 * t188)
    t197 = t192 / (2e-18 + (t193 + t193)) * (t196 + t187 * (t31 * t191))
    t198 = np.maximum((-0.001), np.minimum(0.001, -np.where(t25 != 0.0, t197, 0.0)))
    t199 = t186 - t187 * t198
    t200 = t187 + t186 * t198
    t201 = np.sqrt((t199 * t199 + t200 * t200))
    t202 = t199 / t201
    t203 = np.where(t201 != 0.0, t202, 0.0)
    t204 = t200 / t201
    t205 = t202 + t204
    t206 = t203 - np.where(t201 != 0.0, t204, 0.0)
    t207 = np.where(t25 != 0.0, np.where(t201 != 0.0, t38 * t202, 0.0), 0.0) + np.where(t201 != 0.0, np.where(t25 != 0.0, t31 * t205 * t206, 0.0), 0.0)
    t208 = t202 + t202
    t209 = t207 - np.where(t201 != 0.0, np.where(t25 != 0.0, t26 * t204, 0.0), 0.0) - np.where(t201 != 0.0, np.where(t25 != 0.0, np.where(t201 != 0.0, t204 * (t27 * t208), 0.0), 0.0), 0.0)
    t210 = t209 * t209
    t211 = np.where(t25 != 0.0, t42, 0.0)
    t212 = t211 + np.where(t201 != 0.0, np.where(t25 != 0.0, t194 * t202, 0.0), 0.0) + np.where(t201 != 0.0, np.where(t25 != 0.0, t195 * t204, 0.0), 0.0)
    t213 = t212 + np.where(t201 != 0.0, np.where(t25 != 0.0, t206 * (t27 * t205), 0.0), 0.0) + np.where(t201 != 0.0, np.where(t25 != 0.0, np.where(t201 != 0.0, t204 * (t31 * t208), 0.0), 0.0), 0.0)
    t214 = np.maximum((-0.001), np.minimum(0.001, -(t209 / (2e-18 + (t210 + t210)) * t213)))
    t215 = t203 - np.where(t201 != 0.0, t204 * t214, 0.0)
    t216 = t204 + t202 * t214
    t217 = np.sqrt((t215 * t215 + np.where(t201 != 0.0, np.where(t201 != 0.0, t216 * t216, 0.0), 0.0)))
    t218 = d4 * (-2 * d3)
    t219 = t215 / t217
    t220 = r2 * (-2 * d4)
    t221 = t216 / t217
    t222 = t8 + np.where(t217 != 0.0, t218 * t219, 0.0) + np.where(t201 != 0.0, np.where(t217 != 0.0, t220 * t221, 0.0), 0.0)
    t223 = d3 + np.where(t217 != 0.0, d4 * t219, 0.0)
    t224 = t222 / t1 * t223
    t225 = z * t223
    t226 = np.sqrt((np.where(t1 != 0.0, np.where(t1 != 0.0, t224 * t224, 0.0), 0.0) + t225 * t225))
    t227 = t224 / t226
    t228 = d2 + np.where(t226 != 0.0, np.where(t1 != 0.0, t223 * t227, 0.0), 0.0)
    t229 = r2 + np.where(t201 != 0.0, np.where(t217 != 0.0, d4 * t221, 0.0), 0.0)
    t230 = np.arctan2((y * t228 - x * t229), x * t228 + y * t229)
    t231 = t225 / t226
    t232 = np.where(t201 != 0.0, np.where(t217 != 0.0, t221, 0.0), 0.0)
    t233 = np.where(t217 != 0.0, t219, 0.0)
    t234 = -(t45 * (t178 + t179))
    t235 = t45 * (t181 - t182)
    t236 = np.where(t44 != 0.0, t234, 0.0) + np.where(t48 != 0.0, t235, 0.0)
    t237 = np.where(t44 != 0.0, t235, 0.0) + np.where(t48 != 0.0, t234, 0.0)
    t238 = t37 * t236 - t39 * t237
    t239 = t39 * t236 + t37 * t237
    t240 = t238 + t239
    t241 = t238 - t239
    t242 = np.where(t25 != 0.0, t38 * t238 + t31 * t240 * t241, 0.0) - np.where(t25 != 0.0, t26 * t239, 0.0)
    t243 = t238 + t238
    t244 = t242 - np.where(t25 != 0.0, t239 * (t27 * t243), 0.0)
    t245 = t244 * t244
    t246 = t42 + t194 * t238 + t195 * t239 + t241 * (t27 * t240)
    t247 = t244 / (2e-18 + (t245 + t245)) * (t246 + t239 * (t31 * t243))
    t248 = np.maximum((-0.001), np.minimum(0.001, -np.where(t25 != 0.0, t247, 0.0)))
    t249 = t238 - t239 * t248
    t250 = t239 + t238 * t248
    t251 = np.sqrt((t249 * t249 + t250 * t250))
    t252 = t249 / t251
    t253 = np.where(t251 != 0.0, t252, 0.0)
    t254 = t250 / t251
    t255 = t252 + t254
    t256 = t253 - np.where(t251 != 0.0, t254, 0.0)
    t257 = np.where(t25 != 0.0, np.where(t251 != 0.0, t38 * t252, 0.0), 0.0) + np.where(t251 != 0.0, np.where(t25 != 0.0, t31 * t255 * t256, 0.0), 0.0)
    t258 = t252 + t252
    t259 = t257 - np.where(t251 != 0.0, np.where(t25 != 0.0, t26 * t254, 0.0), 0.0) - np.where(t251 != 0.0, np.where(t25 != 0.0, np.where(t251 != 0.0, t254 * (t27 * t258), 0.0), 0.0), 0.0)
    t260 = t259 * t259
    t261 = t211 + np.where(t251 != 0.0, np.where(t25 != 0.0, t194 * t252, 0.0), 0.0) + np.where(t251 != 0.0, np.where(t25 != 0.0, t195 * t254, 0.0), 0.0)
    t262 = t261 + np.where(t251 != 0.0, np.where(t25 != 0.0, t256 * (t27 * t255), 0.0), 0.0) + np.where(t251 != 0.0, np.where(t25 != 0.0, np.where(t251 != 0.0, t254 * (t31 * t258), 0.0), 0.0), 0.0)
    t263 = np.maximum((-0.001), np.minimum(0.001, -(t259 / (2e-18 + (t260 + t260)) * t262)))
    t264 = t253 - np.where(t251 != 0.0, t254 * t263, 0.0)
    t265 = t254 + t252 * t263
    t266 = np.sqrt((t264 * t264 + np.where(t251 != 0.0, np.where(t251 != 0.0, t265 * t265, 0.0), 0.0)))
    t267 = t264 / t266
    t268 = t265 / t266
    t269 = t8 + np.where(t266 != 0.0, t218 * t267, 0.0) + np.where(t251 != 0.0, np.where(t266 != 0.0, t220 * t268, 0.0), 0.0)
    t270 = d3 + np.where(t266 != 0.0, d4 * t267, 0.0)
    t271 = t269 / t1 * t270
    t272 = z * t270
    t273 = np.sqrt((np.where(t1 != 0.0, np.where(t1 != 0.0, t271 * t271, 0.0), 0.0) + t272 * t272))
    t274 = t271 / t273
    t275 = d2 + np.where(t273 != 0.0, np.where(t1 != 0.0, t270 * t274, 0.0), 0.0)
    t276 = r2 + np.where(t251 != 0.0, np.where(t266 != 0.0, d4 * t268, 0.0), 0.0)
    t277 = np.arctan2((y * t275 - x * t276), x * t275 + y * t276)
    t278 = t272 / t273
    t279 = np.where(t251 != 0.0, np.where(t266 != 0.0, t268, 0.0), 0.0)
    t280 = np.where(t266 != 0.0, t267, 0.0)
    t281 = t170 - t174
    t282 = t169 * t281
    t283 = t46 - t281 * t281
    t284 = np.sqrt(np.maximum(0.0, t283))
    t285 = t172 * t284
    t286 = -(t45 * (t282 + t285))
    t287 = t169 * t284
    t288 = t172 * t281
    t289 = t45 * (t287 - t288)
    t290 = np.where(t44 != 0.0, t286, 0.0) + np.where(t48 != 0.0, t289, 0.0)
    t291 = np.where(t44 != 0.0, t289, 0.0) + np.where(t48 != 0.0, t286, 0.0)
    t292 = t37 * t290 - t39 * t291
    t293 = t39 * t290 + t37 * t291
    t294 = t292 + t293
    t295 = t292 - t293
    t296 = np.where(t25 != 0.0, t38 * t292 + t31 * t294 * t295, 0.0) - np.where(t25 != 0.0, t26 * t293, 0.0)
    t297 = t292 + t292
    t298 = t296 - np.where(t25 != 0.0, t293 * (t27 * t297), 0.0)
    t299 = t298 * t298
    t300 = t42 + t194 * t292 + t195 * t293 + t295 * (t27 * t294)
    t301 = t298 / (2e-18 + (t299 + t299)) * (t300 + t293 * (t31 * t297))
    t302 = np.maximum((-0.001), np.minimum(0.001, -np.where(t25 != 0.0, t301, 0.0)))
    t303 = t292 - t293 * t302
    t304 = t293 + t292 * t302
    t305 = np.sqrt((t303 * t303 + t304 * t304))
    t306 = t303 / t305
    t307 = np.where(t305 != 0.0, t306, 0.0)
    t308 = t304 / t305
    t309 = t306 + t308
    t310 = t307 - np.where(t305 != 0.0, t308, 0.0)
    t311 = np.where(t25 != 0.0, np.where(t305 != 0.0, t38 * t306, 0.0), 0.0) + np.where(t305 != 0.0, np.where(t25 != 0.0, t31 * t309 * t310, 0.0), 0.0)
    t312 = t306 + t306
    t313 = t311 - np.where(t305 != 0.0, np.where(t25 != 0.0, t26 * t308, 0.0), 0.0) - np.where(t305 != 0.0, np.where(t25 != 0.0, np.where(t305 != 0.0, t308 * (t27 * t312), 0.0), 0.0), 0.0)
    t314 = t313 * t313
    t315 = t211 + np.where(t305 != 0.0, np.where(t25 != 0.0, t194 * t306, 0.0), 0.0) + np.where(t305 != 0.0, np.where(t25 != 0.0, t195 * t308, 0.0), 0.0)
    t316 = t315 + np.where(t305 != 0.0, np.where(t25 != 0.0, t310 * (t27 * t309), 0.0), 0.0) + np.where(t305 != 0.0, np.where(t25 != 0.0, np.where(t305 != 0.0, t308 * (t31 * t312), 0.0), 0.0), 0.0)
    t317 = np.maximum((-0.001), np.minimum(0.001, -(t313 / (2e-18 + (t314 + t314)) * t316)))
    t318 = t307 - np.where(t305 != 0.0, t308 * t317, 0.0)
    t319 = t308 + t306 * t317
    t320 = np.sqrt((t318 * t318 + np.where(t305 != 0.0, np.where(t305 != 0.0, t319 * t319, 0.0), 0.0)))
    t321 = t318 / t320
    t322 = t319 / t320
    t323 = t8 + np.where(t320 != 0.0, t218 * t321, 0.0) + np.where(t305 != 0.0, np.where(t320 != 0.0, t220 * t322, 0.0), 0.0)
    t324 = d3 + np.where(t320 != 0.0, d4 * t321, 0.0)
    t325 = t323 / t1 * t324
    t326 = z * t324
    t327 = np.sqrt((np.where(t1 != 0.0, np.where(t1 != 0.0, t325 * t325, 0.0), 0.0) + t326 * t326))
    t328 = t325 / t327
    t329 = d2 + np.where(t327 != 0.0, np.where(t1 != 0.0, t324 * t328, 0.0), 0.0)
    t330 = r2 + np.where(t305 != 0.0, np.where(t320 != 0.0, d4 * t322, 0.0), 0.0)
    t331 = np.arctan2((y * t329 - x * t330), x * t329 + y * t330)
    t332 = t326 / t327
    t333 = np.where(t305 != 0.0, np.where(t320 != 0.0, t322, 0.0), 0.0)
    t334 = np.where(t320 != 0.0, t321, 0.0)
    t335 = t45 * (t285 - t282)
    t336 = -(t45 * (t287 + t288))
    t337 = np.where(t44 != 0.0, t335, 0.0) + np.where(t48 != 0.0, t336, 0.0)
    t338 = np.where(t44 != 0.0, t336, 0.0) + np.where(t48 != 0.0, t335, 0.0)
    t339 = t37 * t337 - t39 * t338
    t340 = t39 * t337 + t37 * t338
    t341 = t339 + t340
    t342 = t339 - t340
    t343 = np.where(t25 != 0.0, t38 * t339 + t31 * t341 * t342, 0.0) - np.where(t25 != 0.0, t26 * t340, 0.0)
    t344 = t339 + t339
    t345 = t343 - np.where(t25 != 0.0, t340 * (t27 * t344), 0.0)
    t346 = t345 * t345
    t347 = t42 + t194 * t339 + t195 * t340 + t342 * (t27 * t341)
    t348 = t345 / (2e-18 + (t346 + t346)) * (t347 + t340 * (t31 * t344))
    t349 = np.maximum((-0.001), np.minimum(0.001, -np.where(t25 != 0.0, t348, 0.0)))
    t350 = t339 - t340 * t349
    t351 = t340 + t339 * t349
    t352 = np.sqrt((t350 * t350 + t351 * t351))
    t353 = t350 / t352
    t354 = np.where(t352 != 0.0, t353, 0.0)
    t355 = t351 / t352
    t356 = t353 + t355
    t357 = t354 - np.where(t352 != 0.0, t355, 0.0)
    t358 = np.where(t25 != 0.0, np.where(t352 != 0.0, t38 * t353, 0.0), 0.0) + np.where(t352 != 0.0, np.where(t25 != 0.0, t31 * t356 * t357, 0.0), 0.0)
    t359 = t353 + t353
    t360 = t358 - np.where(t352 != 0.0, np.where(t25 != 0.0, t26 * t355, 0.0), 0.0) - np.where(t352 != 0.0, np.where(t25 != 0.0, np.where(t352 != 0.0, t355 * (t27 * t359), 0.0), 0.0), 0.0)
    t361 = t360 * t360
    t362 = t211 + np.where(t352 != 0.0, np.where(t25 != 0.0, t194 * t353, 0.0), 0.0) + np.where(t352 != 0.0, np.where(t25 != 0.0, t195 * t355, 0.0), 0.0)
    t363 = t362 + np.where(t352 != 0.0, np.where(t25 != 0.0, t357 * (t27 * t356), 0.0), 0.0) + np.where(t352 != 0.0, np.where(t25 != 0.0, np.where(t352 != 0.0, t355 * (t31 * t359), 0.0), 0.0), 0.0)
    t364 = np.maximum((-0.001), np.minimum(0.001, -(t360 / (2e-18 + (t361 + t361)) * t363)))
    t365 = t354 - np.where(t352 != 0.0, t355 * t364, 0.0)
    t366 = t355 + t353 * t364
    t367 = np.sqrt((t365 * t365 + np.where(t352 != 0.0, np.where(t352 != 0.0, t366 * t366, 0.0), 0.0)))
    t368 = t365 / t367
    t369 = t366 / t367
    t370 = t8 + np.where(t367 != 0.0, t218 * t368, 0.0) + np.where(t352 != 0.0, np.where(t367 != 0.0, t220 * t369, 0.0), 0.0)
    t371 = d3 + np.where(t367 != 0.0, d4 * t368, 0.0)
    t372 = t370 / t1 * t371
    t373 = z * t371
    t374 = np.sqrt((np.where(t1 != 0.0, np.where(t1 != 0.0, t372 * t372, 0.0), 0.0) + t373 * t373))
    t375 = t372 / t374
    t376 = d2 + np.where(t374 != 0.0, np.where(t1 != 0.0, t371 * t375, 0.0), 0.0)
    t377 = r2 + np.where(t352 != 0.0, np.where(t367 != 0.0, d4 * t369, 0.0), 0.0)
    t378 = np.arctan2((y * t376 - x * t377), x * t376 + y * t377)
    t379 = t373 / t374
    t380 = np.where(t352 != 0.0, np.where(t367 != 0.0, t369, 0.0), 0.0)
    t381 = np.where(t367 != 0.0, t368, 0.0)
    t382 = np.sqrt(t2)
    t383 = np.sqrt((t228 * t228 + t229 * t229)) - t382
    t384 = z + np.where(t226 != 0.0, -(t223 * t231), 0.0)
    t385 = np.sqrt((t275 * t275 + t276 * t276)) - t382
    t386 = z + np.where(t273 != 0.0, -(t270 * t278), 0.0)
    t387 = np.sqrt((t329 * t329 + t330 * t330)) - t382
    t388 = z + np.where(t327 != 0.0, -(t324 * t332), 0.0)
    t389 = np.sqrt((t376 * t376 + t377 * t377)) - t382
    t390 = z + np.where(t374 != 0.0, -(t371 * t379), 0.0)
    t391 = np.where(t217 != 0.0, t38 * t219, 0.0) + t31 * (t232 + t233) * (t233 - t232)
    t392 = np.where(t201 != 0.0, np.where(t217 != 0.0, np.where(t25 != 0.0, np.where(t217 != 0.0, t221 * (t27 * (t219 + t219)), 0.0), 0.0), 0.0), 0.0)
    t393 = np.where(t25 != 0.0, t391, 0.0) - np.where(t201 != 0.0, np.where(t217 != 0.0, np.where(t25 != 0.0, t26 * t221, 0.0), 0.0), 0.0) - t392
    t394 = np.where(t266 != 0.0, t38 * t267, 0.0) + t31 * (t279 + t280) * (t280 - t279)
    t395 = np.where(t251 != 0.0, np.where(t266 != 0.0, np.where(t25 != 0.0, np.where(t266 != 0.0, t268 * (t27 * (t267 + t267)), 0.0), 0.0), 0.0), 0.0)
    t396 = np.where(t25 != 0.0, t394, 0.0) - np.where(t251 != 0.0, np.where(t266 != 0.0, np.where(t25 != 0.0, t26 * t268, 0.0), 0.0), 0.0) - t395
    t397 = np.where(t320 != 0.0, t38 * t321, 0.0) + t31 * (t333 + t334) * (t334 - t333)
    t398 = np.where(t305 != 0.0, np.where(t320 != 0.0, np.where(t25 != 0.0, np.where(t320 != 0.0, t322 * (t27 * (t321 + t321)), 0.0), 0.0), 0.0), 0.0)
    t399 = np.where(t25 != 0.0, t397, 0.0) - np.where(t305 != 0.0, np.where(t320 != 0.0, np.where(t25 != 0.0, t26 * t322, 0.0), 0.0), 0.0) - t398
    t400 = np.where(t367 != 0.0, t38 * t368, 0.0) + t31 * (t380 + t381) * (t381 - t380)
    t401 = np.where(t352 != 0.0, np.where(t367 != 0.0, np.where(t25 != 0.0, np.where(t367 != 0.0, t369 * (t27 * (t368 + t368)), 0.0), 0.0), 0.0), 0.0)
    t402 = np.where(t25 != 0.0, t400, 0.0) - np.where(t352 != 0.0, np.where(t367 != 0.0, np.where(t25 != 0.0, t26 * t369, 0.0), 0.0), 0.0) - t401
    t403 = t42 * t42
    t404 = t32 + t27 * t27
    t405 = t26 * t26
    t406 = t38 * t38
    t407 = t405 + t406
    t408 = np.where(t25 != 0.0, np.where(t25 != 0.0, t403 + 3 * t404, 0.0), 0.0) - np.where(t25 != 0.0, np.where(t25 != 0.0, 3 * t407, 0.0), 0.0)
    t409 = t408 * t408
    t410 = t27 * (np.where(t25 != 0.0, np.where(t25 != 0.0, t405, 0.0), 0.0) - np.where(t25 != 0.0, np.where(t25 != 0.0, t406, 0.0), 0.0)) + np.where(t25 != 0.0, np.where(t25 != 0.0, t38 * (t31 * t194), 0.0), 0.0)
    t411 = np.where(t25 != 0.0, np.where(t25 != 0.0, t403 + t403, 0.0), 0.0) - np.where(t25 != 0.0, np.where(t25 != 0.0, 18 * t404, 0.0), 0.0)
    t412 = 27 * t410 + t42 * (t411 - np.where(t25 != 0.0, np.where(t25 != 0.0, 9 * t407, 0.0), 0.0))
    t413 = 4 * t408 * t409 - np.where(t25 != 0.0, np.where(t25 != 0.0, t412 * t412, 0.0), 0.0)
    t414 = 0.5 + 0.5 * np.copysign(1, t413)
    t415 = np.maximum(d3, -d3)
    t416 = np.maximum(d4, -d4)
    t417 = t3 + t9 + (t415 + t415) * t416 + (t416 + t416) * np.maximum(r2, -r2)
    t418 = t417 + np.maximum(t2, -t2)
    t419 = t415 + t416
    t420 = np.maximum(d2, -d2)
    t421 = np.maximum(z, -z)
    t422 = t418 * t418 + t16 * (t419 * t419) + 4 * (t420 * t420) * (t421 * t421)
    t423 = 3.552713678800501e-15 / t25 * t422
    t424 = -0.3333333333333333 * t408
    t425 = np.where(t25 != 0.0, np.where(t25 != 0.0, t404 + t407, 0.0), 0.0) - np.where(t25 != 0.0, np.where(t25 != 0.0, 0.5555555555555556 * t403, 0.0), 0.0)
    t426 = 1.3333333333333333 * t42
    t427 = t424 * t424 + 3 * (t425 * t425) + np.where(t25 != 0.0, np.where(t25 != 0.0, t424 * (t426 * t426), 0.0), 0.0)
    t428 = t427 + np.where(t25 != 0.0, np.where(t25 != 0.0, t426 * (0.1111111111111111 * t412), 0.0), 0.0) - t425 * (-1.3333333333333333 * t408)
    t429 = 0.016666666666666666 / np.where(t25 != 0.0, t423, 0.0) * np.minimum(t428, 3 * (3 * t425 - -0.6666666666666666 * t408))
    t430 = np.where(t25 != 0.0, t412, 0.0)
    t431 = 72 * t409 + 120 * np.maximum(t430, -t430) + np.where(t25 != 0.0, 5000 * t423, 0.0)
    t432 = np.maximum(t413, -t413) / np.where(t25 != 0.0, t423 * t431, 0.0)

    # results
    angles = np.empty((*_leading, 12), _real)
    room = np.empty((*_leading, 2), _real)
    closure = np.empty((*_leading, 4), _real)
    slope = np.empty((*_leading, 4), _real)
    number = np.empty((*_leading, 1), _real)
    margin = np.empty((*_leading, 1), _real)
    angles[..., 0] = t230
    angles[..., 1] = np.arctan2(np.where(t226 != 0.0, -t231, 0.0), np.where(t226 != 0.0, np.where(t1 != 0.0, t227, 0.0), 0.0))
    angles[..., 2] = np.arctan2(t232, t233)
    angles[..., 3] = t277
    angles[..., 4] = np.arctan2(np.where(t273 != 0.0, -t278, 0.0), np.where(t273 != 0.0, np.where(t1 != 0.0, t274, 0.0), 0.0))
    angles[..., 5] = np.arctan2(t279, t280)
    angles[..., 6] = t331
    angles[..., 7] = np.arctan2(np.where(t327 != 0.0, -t332, 0.0), np.where(t327 != 0.0, np.where(t1 != 0.0, t328, 0.0), 0.0))
    angles[..., 8] = np.arctan2(t333, t334)
    angles[..., 9] = t378
    angles[..., 10] = np.arctan2(np.where(t374 != 0.0, -t379, 0.0), np.where(t374 != 0.0, np.where(t1 != 0.0, t375, 0.0), 0.0))
    angles[..., 11] = np.arctan2(t380, t381)
    room[..., 0] = t176
    room[..., 1] = t283
    closure[..., 0] = np.sqrt((t383 * t383 + t384 * t384))
    closure[..., 1] = np.sqrt((t385 * t385 + t386 * t386))
    closure[..., 2] = np.sqrt((t387 * t387 + t388 * t388))
    closure[..., 3] = np.sqrt((t389 * t389 + t390 * t390))
    slope[..., 0] = t393
    slope[..., 1] = t396
    slope[..., 2] = t399
    slope[..., 3] = t402
    number[..., 0] = 2 + t414 * np.copysign(2, t429)
    margin[..., 0] = np.minimum(t432, t432 * (1 - t414) + np.maximum(t429, -t429))
    return angles.reshape(_leading + (4, 3)), room.reshape(_leading + (2,)), closure.reshape(_leading + (4,)), slope.reshape(_leading + (4,)), number.reshape(_leading), margin.reshape(_leading)


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
