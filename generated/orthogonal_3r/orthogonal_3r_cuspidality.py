"""cuspidality of orthogonal_3r, in NumPy.

Made from templates/kernel.py.j2; inputs d2ab704a0c66ffe13e4beaab0ab6e0b2f1af15e2b39f5717fa9483ff1be54810.
2072 operations. Do not edit: change the derivation and regenerate.

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


def postures(parameters, point):
    """two pairs of postures at a point, the room of each (real if positive), the distances left, the slopes of E: 1380 operations.

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
    t2 = np.where(t1 != 0.0, 1, 0.0)
    t3 = t2 / (t1 + (1 - t2))
    t4 = x * x + y * y
    t5 = z * z
    t6 = d2 * d2
    t7 = d3 * d3
    t8 = d4 * d4
    t9 = r2 * r2
    t10 = t4 + t5 - t6 - t7 - t8 - t9
    t11 = d4 * (-2 * d3)
    t12 = t9 + (t8 + (t6 + t7))
    t13 = t12 - t4 - t5
    t14 = d4 * (d3 + d3)
    t15 = 4 * t6
    t16 = t13 * t14 - 0.5 * t14 * t15
    t17 = t1 * z
    t18 = 0.5 * (t14 * t14)
    t19 = r2 * (d4 + d4)
    t20 = 0.5 * (t19 * t19)
    t21 = t13 * t13 + t17 * t17 + t18 + t20 - t7 * t15
    t22 = t15 * (0.5 * t8)
    t23 = t21 - t22
    t24 = t18 - t20 - t22
    t25 = np.maximum(t23, -t23) + np.maximum(t16, -t16) + np.maximum(t24, -t24)
    t26 = t14 * t19
    t27 = t13 * t19
    t28 = t25 + np.maximum(t26, -t26) + np.maximum(t27, -t27)
    t29 = np.where(t28 != 0.0, 1, 0.0)
    t30 = t29 / (t28 + (1 - t29))
    t31 = t16 * t30
    t32 = t24 * t30
    t33 = t32 + np.copysign(1e-17, t32)
    t34 = 0.5 + 0.5 * np.copysign(1, t33)
    t35 = t26 * t30
    t36 = t35 * t35
    t37 = np.sqrt((t33 * t33 + t36))
    t38 = 0.7071067811865476 * np.sqrt(((t37 + np.maximum(t33, -t33)) / t37))
    t39 = 1 - t34
    t40 = 0.5 * t35 / t38 / t37
    t41 = np.where(t34 != 0.0, t38, 0.0) + np.where(t39 != 0.0, t40, 0.0)
    t42 = t27 * t30
    t43 = np.where(t34 != 0.0, t40, 0.0) + np.where(t39 != 0.0, t38, 0.0)
    t44 = t31 * t41 + t42 * t43
    t45 = t41 * t42 - t31 * t43
    t46 = t23 * t30
    t47 = 0.5 * np.copysign(1, t44 * t44 - t45 * t45 - t37 * t46)
    t48 = 0.5 + t47
    t49 = 0.5 / t37
    t50 = t37 + t37
    t51 = 1 - t48
    t52 = np.where(t48 != 0.0, t44, 0.0) + np.where(t51 != 0.0, -t45, 0.0)
    t53 = np.where(t48 != 0.0, t45, 0.0) + np.where(t51 != 0.0, -t44, 0.0)
    t54 = t53 * t53
    t55 = t37 * (t54 + t54)
    t56 = t52 * t52
    t57 = t46 * (t48 + t48 - 1)
    t58 = t54 + t56 - t50 * (t57 - t37)
    t59 = t57 - 3 * t37
    t60 = t37 * (t58 + t37 * (t37 + t59))
    t61 = np.where(t60 != 0.0, 1, 0.0)
    t62 = np.minimum(t37, t37 * t55 * (t61 / (t60 + (1 - t61))))
    t63 = t62 * (t58 + t62 * (t59 + t62)) - t55
    t64 = t59 + t59
    t65 = t58 + t62 * (t64 + 3 * t62)
    t66 = np.where(t65 != 0.0, 1, 0.0)
    t67 = t62 - t63 * (t66 / (t65 + (1 - t66)))
    t68 = 0.5 + 0.5 * np.copysign(1, t63)
    t69 = 1 - t68
    t70 = np.where(t68 != 0.0, t62, 0.0) + np.where(t69 != 0.0, t37, 0.0)
    t71 = np.where(t69 != 0.0, t62, 0.0)
    t72 = np.where((t67 - np.minimum(t70, np.maximum(t67, t71))) != 0.0, 1, 0.0)
    t73 = np.where(t72 != 0.0, 0.5 * t70 + np.where(t69 != 0.0, 0.5 * t62, 0.0), 0.0) + np.where((1 - t72) != 0.0, t67, 0.0)
    t74 = t73 * (t58 + t73 * (t59 + t73)) - t55
    t75 = t58 + t73 * (t64 + 3 * t73)
    t76 = np.where(t75 != 0.0, 1, 0.0)
    t77 = t73 - t74 * (t76 / (t75 + (1 - t76)))
    t78 = 0.5 + 0.5 * np.copysign(1, t74)
    t79 = 1 - t78
    t80 = np.where(t78 != 0.0, t73, 0.0) + np.where(t79 != 0.0, t70, 0.0)
    t81 = np.where(t78 != 0.0, t71, 0.0) + np.where(t79 != 0.0, t73, 0.0)
    t82 = np.where((t77 - np.minimum(t80, np.maximum(t77, t81))) != 0.0, 1, 0.0)
    t83 = np.where(t82 != 0.0, 0.5 * t80 + 0.5 * t81, 0.0) + np.where((1 - t82) != 0.0, t77, 0.0)
    t84 = t83 * (t58 + t83 * (t59 + t83)) - t55
    t85 = t58 + t83 * (t64 + 3 * t83)
    t86 = np.where(t85 != 0.0, 1, 0.0)
    t87 = t83 - t84 * (t86 / (t85 + (1 - t86)))
    t88 = 0.5 + 0.5 * np.copysign(1, t84)
    t89 = 1 - t88
    t90 = np.where(t88 != 0.0, t83, 0.0) + np.where(t89 != 0.0, t80, 0.0)
    t91 = np.where(t88 != 0.0, t81, 0.0) + np.where(t89 != 0.0, t83, 0.0)
    t92 = np.where((t87 - np.minimum(t90, np.maximum(t87, t91))) != 0.0, 1, 0.0)
    t93 = np.where(t92 != 0.0, 0.5 * t90 + 0.5 * t91, 0.0) + np.where((1 - t92) != 0.0, t87, 0.0)
    t94 = t93 * (t58 + t93 * (t59 + t93)) - t55
    t95 = t58 + t93 * (t64 + 3 * t93)
    t96 = np.where(t95 != 0.0, 1, 0.0)
    t97 = t93 - t94 * (t96 / (t95 + (1 - t96)))
    t98 = 0.5 + 0.5 * np.copysign(1, t94)
    t99 = 1 - t98
    t100 = np.where(t98 != 0.0, t93, 0.0) + np.where(t99 != 0.0, t90, 0.0)
    t101 = np.where(t98 != 0.0, t91, 0.0) + np.where(t99 != 0.0, t93, 0.0)
    t102 = np.where((t97 - np.minimum(t100, np.maximum(t97, t101))) != 0.0, 1, 0.0)
    t103 = np.where(t102 != 0.0, 0.5 * t100 + 0.5 * t101, 0.0) + np.where((1 - t102) != 0.0, t97, 0.0)
    t104 = t103 * (t58 + t103 * (t59 + t103)) - t55
    t105 = t58 + t103 * (t64 + 3 * t103)
    t106 = np.where(t105 != 0.0, 1, 0.0)
    t107 = t103 - t104 * (t106 / (t105 + (1 - t106)))
    t108 = 0.5 + 0.5 * np.copysign(1, t104)
    t109 = 1 - t108
    t110 = np.where(t108 != 0.0, t103, 0.0) + np.where(t109 != 0.0, t100, 0.0)
    t111 = np.where(t108 != 0.0, t101, 0.0) + np.where(t109 != 0.0, t103, 0.0)
    t112 = np.where((t107 - np.minimum(t110, np.maximum(t107, t111))) != 0.0, 1, 0.0)
    t113 = np.where(t112 != 0.0, 0.5 * t110 + 0.5 * t111, 0.0) + np.where((1 - t112) != 0.0, t107, 0.0)
    t114 = t113 * (t58 + t113 * (t59 + t113)) - t55
    t115 = t58 + t113 * (t64 + 3 * t113)
    t116 = np.where(t115 != 0.0, 1, 0.0)
    t117 = t113 - t114 * (t116 / (t115 + (1 - t116)))
    t118 = 0.5 + 0.5 * np.copysign(1, t114)
    t119 = 1 - t118
    t120 = np.where(t118 != 0.0, t113, 0.0) + np.where(t119 != 0.0, t110, 0.0)
    t121 = np.where(t118 != 0.0, t111, 0.0) + np.where(t119 != 0.0, t113, 0.0)
    t122 = np.where((t117 - np.minimum(t120, np.maximum(t117, t121))) != 0.0, 1, 0.0)
    t123 = np.where(t122 != 0.0, 0.5 * t120 + 0.5 * t121, 0.0) + np.where((1 - t122) != 0.0, t117, 0.0)
    t124 = t123 * (t58 + t123 * (t59 + t123)) - t55
    t125 = t58 + t123 * (t64 + 3 * t123)
    t126 = np.where(t125 != 0.0, 1, 0.0)
    t127 = t123 - t124 * (t126 / (t125 + (1 - t126)))
    t128 = 0.5 + 0.5 * np.copysign(1, t124)
    t129 = 1 - t128
    t130 = np.where(t128 != 0.0, t123, 0.0) + np.where(t129 != 0.0, t120, 0.0)
    t131 = np.where(t128 != 0.0, t121, 0.0) + np.where(t129 != 0.0, t123, 0.0)
    t132 = np.where((t127 - np.minimum(t130, np.maximum(t127, t131))) != 0.0, 1, 0.0)
    t133 = np.where(t132 != 0.0, 0.5 * t130 + 0.5 * t131, 0.0) + np.where((1 - t132) != 0.0, t127, 0.0)
    t134 = t133 * (t58 + t133 * (t59 + t133)) - t55
    t135 = t58 + t133 * (t64 + 3 * t133)
    t136 = np.where(t135 != 0.0, 1, 0.0)
    t137 = t133 - t134 * (t136 / (t135 + (1 - t136)))
    t138 = 0.5 + 0.5 * np.copysign(1, t134)
    t139 = 1 - t138
    t140 = np.where(t138 != 0.0, t133, 0.0) + np.where(t139 != 0.0, t130, 0.0)
    t141 = np.where(t138 != 0.0, t131, 0.0) + np.where(t139 != 0.0, t133, 0.0)
    t142 = np.where((t137 - np.minimum(t140, np.maximum(t137, t141))) != 0.0, 1, 0.0)
    t143 = np.where(t142 != 0.0, 0.5 * t140 + 0.5 * t141, 0.0) + np.where((1 - t142) != 0.0, t137, 0.0)
    t144 = t143 * (t58 + t143 * (t59 + t143)) - t55
    t145 = t58 + t143 * (t64 + 3 * t143)
    t146 = np.where(t145 != 0.0, 1, 0.0)
    t147 = t143 - t144 * (t146 / (t145 + (1 - t146)))
    t148 = 0.5 + 0.5 * np.copysign(1, t144)
    t149 = 1 - t148
    t150 = np.where(t148 != 0.0, t143, 0.0) + np.where(t149 != 0.0, t140, 0.0)
    t151 = np.where(t148 != 0.0, t141, 0.0) + np.where(t149 != 0.0, t143, 0.0)
    t152 = np.where((t147 - np.minimum(t150, np.maximum(t147, t151))) != 0.0, 1, 0.0)
    t153 = np.where(t152 != 0.0, 0.5 * t150 + 0.5 * t151, 0.0) + np.where((1 - t152) != 0.0, t147, 0.0)
    t154 = t153 * (t58 + t153 * (t59 + t153)) - t55
    t155 = t58 + t153 * (t64 + 3 * t153)
    t156 = np.where(t155 != 0.0, 1, 0.0)
    t157 = t153 - t154 * (t156 / (t155 + (1 - t156)))
    t158 = 0.5 + 0.5 * np.copysign(1, t154)
    t159 = 1 - t158
    t160 = np.where(t158 != 0.0, t153, 0.0) + np.where(t159 != 0.0, t150, 0.0)
    t161 = np.where(t158 != 0.0, t151, 0.0) + np.where(t159 != 0.0, t153, 0.0)
    t162 = np.where((t157 - np.minimum(t160, np.maximum(t157, t161))) != 0.0, 1, 0.0)
    t163 = np.where(t162 != 0.0, 0.5 * t160 + 0.5 * t161, 0.0) + np.where((1 - t162) != 0.0, t157, 0.0)
    t164 = t163 * (t58 + t163 * (t59 + t163)) - t55
    t165 = t58 + t163 * (t64 + 3 * t163)
    t166 = np.where(t165 != 0.0, 1, 0.0)
    t167 = t163 - t164 * (t166 / (t165 + (1 - t166)))
    t168 = 0.5 + 0.5 * np.copysign(1, t164)
    t169 = 1 - t168
    t170 = np.where(t168 != 0.0, t163, 0.0) + np.where(t169 != 0.0, t160, 0.0)
    t171 = np.where(t168 != 0.0, t161, 0.0) + np.where(t169 != 0.0, t163, 0.0)
    t172 = np.where((t167 - np.minimum(t170, np.maximum(t167, t171))) != 0.0, 1, 0.0)
    t173 = np.where(t172 != 0.0, 0.5 * t170 + 0.5 * t171, 0.0) + np.where((1 - t172) != 0.0, t167, 0.0)
    t174 = t173 * (t58 + t173 * (t59 + t173)) - t55
    t175 = t58 + t173 * (t64 + 3 * t173)
    t176 = np.where(t175 != 0.0, 1, 0.0)
    t177 = t173 - t174 * (t176 / (t175 + (1 - t176)))
    t178 = 0.5 + 0.5 * np.copysign(1, t174)
    t179 = 1 - t178
    t180 = np.where(t178 != 0.0, t173, 0.0) + np.where(t179 != 0.0, t170, 0.0)
    t181 = np.where(t178 != 0.0, t171, 0.0) + np.where(t179 != 0.0, t173, 0.0)
    t182 = np.where((t177 - np.minimum(t180, np.maximum(t177, t181))) != 0.0, 1, 0.0)
    t183 = np.where(t182 != 0.0, 0.5 * t180 + 0.5 * t181, 0.0) + np.where((1 - t182) != 0.0, t177, 0.0)
    t184 = t50 - t183
    t185 = np.sqrt(t184)
    t186 = t52 / t185
    t187 = 0.5 + 0.5 * np.copysign(1, t183 - 1e-25)
    t188 = np.sqrt(t183)
    t189 = np.where(t188 != 0.0, 1, 0.0)
    t190 = np.copysign(np.sqrt(np.maximum(0.0, t37 + t56 / t184 - t57 - t183)), t53)
    t191 = np.where(t187 != 0.0, t53 * (t189 / (t188 + (1 - t189))), 0.0) + np.where((1 - t187) != 0.0, t190, 0.0)
    t192 = t186 + t191
    t193 = t50 - t192 * t192
    t194 = np.sqrt(np.maximum(0.0, t193))
    t195 = t188 * t194
    t196 = t185 * t192
    t197 = t49 * (t195 - t196)
    t198 = t188 * t192
    t199 = t185 * t194
    t200 = t49 * (t198 + t199)
    t201 = np.where(t48 != 0.0, t197, 0.0) + np.where(t51 != 0.0, t200, 0.0)
    t202 = np.where(t48 != 0.0, t200, 0.0) + np.where(t51 != 0.0, t197, 0.0)
    t203 = t41 * t201 - t43 * t202
    t204 = t43 * t201 + t41 * t202
    t205 = t203 + t204
    t206 = t203 - t204
    t207 = t203 + t203
    t208 = t42 * t203 + t35 * t205 * t206 - t31 * t204 - t204 * (t32 * t207)
    t209 = t208 * t208
    t210 = t31 + t31
    t211 = t42 + t42
    t212 = t46 + t203 * t210 + t204 * t211 + t206 * (t32 * t205)
    t213 = t208 / (2e-18 + (t209 + t209)) * (t212 + t204 * (t35 * t207))
    t214 = np.maximum((-0.001), np.minimum(0.001, -t213))
    t215 = t203 - t204 * t214
    t216 = t204 + t203 * t214
    t217 = np.sqrt((t215 * t215 + t216 * t216))
    t218 = np.where(t217 != 0.0, 1, 0.0)
    t219 = t218 / (t217 + (1 - t218))
    t220 = t215 * t219
    t221 = t216 * t219
    t222 = t220 + t221
    t223 = t220 - t221
    t224 = t220 + t220
    t225 = t42 * t220 + t35 * t222 * t223 - t31 * t221 - t221 * (t32 * t224)
    t226 = t225 * t225
    t227 = t46 + t210 * t220 + t211 * t221 + t223 * (t32 * t222)
    t228 = t225 / (2e-18 + (t226 + t226)) * (t227 + t221 * (t35 * t224))
    t229 = np.maximum((-0.001), np.minimum(0.001, -t228))
    t230 = t220 - t221 * t229
    t231 = t221 + t220 * t229
    t232 = np.sqrt((t230 * t230 + t231 * t231))
    t233 = np.where(t232 != 0.0, 1, 0.0)
    t234 = t233 / (t232 + (1 - t233))
    t235 = t230 * t234
    t236 = r2 * (-2 * d4)
    t237 = t231 * t234
    t238 = d3 + d4 * t235
    t239 = t3 * (t10 + t11 * t235 + t236 * t237) * t238
    t240 = z * t238
    t241 = np.sqrt((t239 * t239 + t240 * t240))
    t242 = np.where(t241 != 0.0, 1, 0.0)
    t243 = t242 / (t241 + (1 - t242))
    t244 = t239 * t243
    t245 = d2 + t238 * t244
    t246 = r2 + d4 * t237
    t247 = np.arctan2((y * t245 - x * t246), x * t245 + y * t246)
    t248 = t240 * t243
    t249 = -(t49 * (t195 + t196))
    t250 = t49 * (t198 - t199)
    t251 = np.where(t48 != 0.0, t249, 0.0) + np.where(t51 != 0.0, t250, 0.0)
    t252 = np.where(t48 != 0.0, t250, 0.0) + np.where(t51 != 0.0, t249, 0.0)
    t253 = t41 * t251 - t43 * t252
    t254 = t43 * t251 + t41 * t252
    t255 = t253 + t254
    t256 = t253 - t254
    t257 = t253 + t253
    t258 = t42 * t253 + t35 * t255 * t256 - t31 * t254 - t254 * (t32 * t257)
    t259 = t258 * t258
    t260 = t46 + t210 * t253 + t211 * t254 + t256 * (t32 * t255)
    t261 = t258 / (2e-18 + (t259 + t259)) * (t260 + t254 * (t35 * t257))
    t262 = np.maximum((-0.001), np.minimum(0.001, -t261))
    t263 = t253 - t254 * t262
    t264 = t254 + t253 * t262
    t265 = np.sqrt((t263 * t263 + t264 * t264))
    t266 = np.where(t265 != 0.0, 1, 0.0)
    t267 = t266 / (t265 + (1 - t266))
    t268 = t263 * t267
    t269 = t264 * t267
    t270 = t268 + t269
    t271 = t268 - t269
    t272 = t268 + t268
    t273 = t42 * t268 + t35 * t270 * t271 - t31 * t269 - t269 * (t32 * t272)
    t274 = t273 * t273
    t275 = t46 + t210 * t268 + t211 * t269 + t271 * (t32 * t270)
    t276 = t273 / (2e-18 + (t274 + t274)) * (t275 + t269 * (t35 * t272))
    t277 = np.maximum((-0.001), np.minimum(0.001, -t276))
    t278 = t268 - t269 * t277
    t279 = t269 + t268 * t277
    t280 = np.sqrt((t278 * t278 + t279 * t279))
    t281 = np.where(t280 != 0.0, 1, 0.0)
    t282 = t281 / (t280 + (1 - t281))
    t283 = t278 * t282
    t284 = t279 * t282
    t285 = d3 + d4 * t283
    t286 = t3 * (t10 + t11 * t283 + t236 * t284) * t285
    t287 = z * t285
    t288 = np.sqrt((t286 * t286 + t287 * t287))
    t289 = np.where(t288 != 0.0, 1, 0.0)
    t290 = t289 / (t288 + (1 - t289))
    t291 = t286 * t290
    t292 = d2 + t285 * t291
    t293 = r2 + d4 * t284
    t294 = np.arctan2((y * t292 - x * t293), x * t292 + y * t293)
    t295 = t287 * t290
    t296 = t186 - t191
    t297 = t185 * t296
    t298 = t50 - t296 * t296
    t299 = np.sqrt(np.maximum(0.0, t298))
    t300 = t188 * t299
    t301 = -(t49 * (t297 + t300))
    t302 = t185 * t299
    t303 = t188 * t296
    t304 = t49 * (t302 - t303)
    t305 = np.where(t48 != 0.0, t301, 0.0) + np.where(t51 != 0.0, t304, 0.0)
    t306 = np.where(t48 != 0.0, t304, 0.0) + np.where(t51 != 0.0, t301, 0.0)
    t307 = t41 * t305 - t43 * t306
    t308 = t43 * t305 + t41 * t306
    t309 = t307 + t308
    t310 = t307 - t308
    t311 = t307 + t307
    t312 = t42 * t307 + t35 * t309 * t310 - t31 * t308 - t308 * (t32 * t311)
    t313 = t312 * t312
    t314 = t46 + t210 * t307 + t211 * t308 + t310 * (t32 * t309)
    t315 = t312 / (2e-18 + (t313 + t313)) * (t314 + t308 * (t35 * t311))
    t316 = np.maximum((-0.001), np.minimum(0.001, -t315))
    t317 = t307 - t308 * t316
    t318 = t308 + t307 * t316
    t319 = np.sqrt((t317 * t317 + t318 * t318))
    t320 = np.where(t319 != 0.0, 1, 0.0)
    t321 = t320 / (t319 + (1 - t320))
    t322 = t317 * t321
    t323 = t318 * t321
    t324 = t322 + t323
    t325 = t322 - t323
    t326 = t322 + t322
    t327 = t42 * t322 + t35 * t324 * t325 - t31 * t323 - t323 * (t32 * t326)
    t328 = t327 * t327
    t329 = t46 + t210 * t322 + t211 * t323 + t325 * (t32 * t324)
    t330 = t327 / (2e-18 + (t328 + t328)) * (t329 + t323 * (t35 * t326))
    t331 = np.maximum((-0.001), np.minimum(0.001, -t330))
    t332 = t322 - t323 * t331
    t333 = t323 + t322 * t331
    t334 = np.sqrt((t332 * t332 + t333 * t333))
    t335 = np.where(t334 != 0.0, 1, 0.0)
    t336 = t335 / (t334 + (1 - t335))
    t337 = t332 * t336
    t338 = t333 * t336
    t339 = d3 + d4 * t337
    t340 = t3 * (t10 + t11 * t337 + t236 * t338) * t339
    t341 = z * t339
    t342 = np.sqrt((t340 * t340 + t341 * t341))
    t343 = np.where(t342 != 0.0, 1, 0.0)
    t344 = t343 / (t342 + (1 - t343))
    t345 = t340 * t344
    t346 = d2 + t339 * t345
    t347 = r2 + d4 * t338
    t348 = np.arctan2((y * t346 - x * t347), x * t346 + y * t347)
    t349 = t341 * t344
    t350 = t49 * (t300 - t297)
    t351 = -(t49 * (t302 + t303))
    t352 = np.where(t48 != 0.0, t350, 0.0) + np.where(t51 != 0.0, t351, 0.0)
    t353 = np.where(t48 != 0.0, t351, 0.0) + np.where(t51 != 0.0, t350, 0.0)
    t354 = t41 * t352 - t43 * t353
    t355 = t43 * t352 + t41 * t353
    t356 = t354 + t355
    t357 = t354 - t355
    t358 = t354 + t354
    t359 = t42 * t354 + t35 * t356 * t357 - t31 * t355 - t355 * (t32 * t358)
    t360 = t359 * t359
    t361 = t46 + t210 * t354 + t211 * t355 + t357 * (t32 * t356)
    t362 = t359 / (2e-18 + (t360 + t360)) * (t361 + t355 * (t35 * t358))
    t363 = np.maximum((-0.001), np.minimum(0.001, -t362))
    t364 = t354 - t355 * t363
    t365 = t355 + t354 * t363
    t366 = np.sqrt((t364 * t364 + t365 * t365))
    t367 = np.where(t366 != 0.0, 1, 0.0)
    t368 = t367 / (t366 + (1 - t367))
    t369 = t364 * t368
    t370 = t365 * t368
    t371 = t369 + t370
    t372 = t369 - t370
    t373 = t369 + t369
    t374 = t42 * t369 + t35 * t371 * t372 - t31 * t370 - t370 * (t32 * t373)
    t375 = t374 * t374
    t376 = t46 + t210 * t369 + t211 * t370 + t372 * (t32 * t371)
    t377 = t374 / (2e-18 + (t375 + t375)) * (t376 + t370 * (t35 * t373))
    t378 = np.maximum((-0.001), np.minimum(0.001, -t377))
    t379 = t369 - t370 * t378
    t380 = t370 + t369 * t378
    t381 = np.sqrt((t379 * t379 + t380 * t380))
    t382 = np.where(t381 != 0.0, 1, 0.0)
    t383 = t382 / (t381 + (1 - t382))
    t384 = t379 * t383
    t385 = t380 * t383
    t386 = d3 + d4 * t384
    t387 = t3 * (t10 + t11 * t384 + t236 * t385) * t386
    t388 = z * t386
    t389 = np.sqrt((t387 * t387 + t388 * t388))
    t390 = np.where(t389 != 0.0, 1, 0.0)
    t391 = t390 / (t389 + (1 - t390))
    t392 = t387 * t391
    t393 = d2 + t386 * t392
    t394 = r2 + d4 * t385
    t395 = np.arctan2((y * t393 - x * t394), x * t393 + y * t394)
    t396 = t388 * t391
    t397 = np.sqrt(t4)
    t398 = np.sqrt((t245 * t245 + t246 * t246)) - t397
    t399 = t238 * t248 - z
    t400 = np.sqrt((t292 * t292 + t293 * t293)) - t397
    t401 = t285 * t295 - z
    t402 = np.sqrt((t346 * t346 + t347 * t347)) - t397
    t403 = t339 * t349 - z
    t404 = np.sqrt((t393 * t393 + t394 * t394)) - t397
    t405 = t386 * t396 - z
    t406 = t42 * t235 + t35 * (t235 + t237) * (t235 - t237) - t31 * t237
    t407 = t42 * t283 + t35 * (t283 + t284) * (t283 - t284) - t31 * t284
    t408 = t42 * t337 + t35 * (t337 + t338) * (t337 - t338) - t31 * t338
    t409 = t42 * t384 + t35 * (t384 + t385) * (t384 - t385) - t31 * t385
    t410 = t46 * t46
    t411 = t36 + t32 * t32
    t412 = t31 * t31
    t413 = t42 * t42
    t414 = t412 + t413
    t415 = t410 + 3 * t411 - 3 * t414
    t416 = t415 * t415
    t417 = 27 * (t32 * (t412 - t413) + t42 * (t35 * t210)) + t46 * (t410 + t410 - 18 * t411 - 9 * t414)
    t418 = 4 * t415 * t416 - t417 * t417
    t419 = 0.5 + 0.5 * np.copysign(1, t418)
    t420 = np.maximum(d3, -d3)
    t421 = np.maximum(d4, -d4)
    t422 = t5 + t12 + (t420 + t420) * t421 + (t421 + t421) * np.maximum(r2, -r2)
    t423 = t422 + np.maximum(t4, -t4)
    t424 = t420 + t421
    t425 = np.maximum(d2, -d2)
    t426 = np.maximum(z, -z)
    t427 = t423 * t423 + t15 * (t424 * t424) + 4 * (t425 * t425) * (t426 * t426)
    t428 = 3.552713678800501e-15 * t30 * t427
    t429 = -0.3333333333333333 * t415
    t430 = t411 + t414 - 0.5555555555555556 * t410
    t431 = 1.3333333333333333 * t46
    t432 = t429 * t429 + 3 * (t430 * t430) + t429 * (t431 * t431)
    t433 = np.minimum((t432 + t431 * (0.1111111111111111 * t417) - t430 * (-1.3333333333333333 * t415)), 3 * (3 * t430 - -0.6666666666666666 * t415))
    t434 = 0.016666666666666666 / t428 * t433
    t435 = 72 * t416 + 120 * np.maximum(t417, -t417) + 5000 * t428
    t436 = np.maximum(t418, -t418) / (t428 * t435)

    # results
    angles = np.empty((*_leading, 12), _real)
    room = np.empty((*_leading, 2), _real)
    closure = np.empty((*_leading, 4), _real)
    slope = np.empty((*_leading, 4), _real)
    number = np.empty((*_leading, 1), _real)
    margin = np.empty((*_leading, 1), _real)
    angles[..., 0] = t247
    angles[..., 1] = np.arctan2((-t248), t244)
    angles[..., 2] = np.arctan2(t237, t235)
    angles[..., 3] = t294
    angles[..., 4] = np.arctan2((-t295), t291)
    angles[..., 5] = np.arctan2(t284, t283)
    angles[..., 6] = t348
    angles[..., 7] = np.arctan2((-t349), t345)
    angles[..., 8] = np.arctan2(t338, t337)
    angles[..., 9] = t395
    angles[..., 10] = np.arctan2((-t396), t392)
    angles[..., 11] = np.arctan2(t385, t384)
    room[..., 0] = t193
    room[..., 1] = t298
    closure[..., 0] = np.sqrt((t398 * t398 + t399 * t399))
    closure[..., 1] = np.sqrt((t400 * t400 + t401 * t401))
    closure[..., 2] = np.sqrt((t402 * t402 + t403 * t403))
    closure[..., 3] = np.sqrt((t404 * t404 + t405 * t405))
    slope[..., 0] = t406 - t237 * (t32 * (t235 + t235))
    slope[..., 1] = t407 - t284 * (t32 * (t283 + t283))
    slope[..., 2] = t408 - t338 * (t32 * (t337 + t337))
    slope[..., 3] = t409 - t385 * (t32 * (t384 + t384))
    number[..., 0] = 2 + t419 * np.copysign(2, t434)
    margin[..., 0] = np.minimum(t436, t436 * (1 - t419) + np.maximum(t434, -t434))
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
