"""continuation position of planar_rrr, in NumPy.

Made from templates/kernel.py.j2; inputs f29b1b245621ebe2effe4dc47543535c5f273522534b650aa5e0573e5f938bfd.
123 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def continuation_position(q, held, parameters):
    """error of the position, its Jacobian, and the null vector from its signed minors: 58 operations.

    in   q[3]
    in   held[2] = (target_x, target_y)
    in   parameters[3] = (l1, l2, l3)
    out  error[2]
    out  jacobian[2][3]
    out  null_vector[3]
    """
    q = np.asarray(q)
    held = np.asarray(held)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], held.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, held, parameters, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    l1 = parameters[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    target_x = held[..., 0]
    target_y = held[..., 1]

    # terms
    t1 = c1 * l1
    t2 = c1 * c2 - s1 * s2
    t3 = c1 * s2 + c2 * s1
    t4 = (t2 * c3 - t3 * s3) * l3
    t5 = t1 + t2 * l2 + t4
    t6 = l1 * s1
    t7 = l3 * (c3 * t3 + t2 * s3)
    t8 = t6 + l2 * t3 + t7
    t9 = l3 * (c2 * c3 - s2 * s3)
    t10 = l1 + c2 * l2 + t9
    t11 = t10 - l1
    t12 = l3 * (c2 * s3 + s2 * c3)
    t13 = t12 + s2 * l2
    t14 = t9 * t13

    # results
    error = np.empty((*_leading, 2), _real)
    jacobian = np.empty((*_leading, 6), _real)
    null_vector = np.empty((*_leading, 3), _real)
    error[..., 0] = t5 - target_x
    error[..., 1] = t8 - target_y
    jacobian[..., 0] = -t8
    jacobian[..., 1] = -(t8 - t6)
    jacobian[..., 2] = -t7
    jacobian[..., 3] = t5
    jacobian[..., 4] = t5 - t1
    jacobian[..., 5] = t4
    null_vector[..., 0] = t11 * t12 - t14
    null_vector[..., 1] = -(t10 * t12 - t14)
    null_vector[..., 2] = t10 * t13 - t11 * t13
    return error.reshape(_leading + (2,)), jacobian.reshape(_leading + (2, 3)), null_vector.reshape(_leading + (3,))


def continuation_position_bending(q, parameters):
    """null vector of the position Jacobian, and its derivative along itself: 65 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
    out  null_vector[3]
    out  bending[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    l1 = parameters[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = (c2 * c3 - s2 * s3) * l3
    t2 = l1 + c2 * l2 + t1
    t3 = t2 - l1
    t4 = l3 * (c2 * s3 + c3 * s2)
    t5 = t4 + l2 * s2
    t6 = t1 * t5
    t7 = t2 * t4 - t6
    t8 = t2 * t5 - t3 * t5
    t9 = c3 * t8
    t10 = c2 * t7
    t11 = s2 * t7
    t12 = s3 * t8
    t13 = c2 * t9 - c3 * t10 + s3 * t11 - s2 * t12
    t14 = l3 * t13
    t15 = c3 * t11 - c2 * t12 + s3 * t10 - s2 * t9
    t16 = l3 * t15
    t17 = t4 * (l2 * t11 + t16)
    t18 = t5 * t16
    t19 = t14 - l2 * t10
    t20 = t1 * t19

    # results
    null_vector = np.empty((*_leading, 3), _real)
    bending = np.empty((*_leading, 3), _real)
    null_vector[..., 0] = t3 * t4 - t6
    null_vector[..., 1] = -t7
    null_vector[..., 2] = t8
    bending[..., 0] = t3 * t14 + t17 - t18 - t20
    bending[..., 1] = -(t17 + t2 * t14 - t18 - t20)
    bending[..., 2] = t19 * (t2 - t3)
    return null_vector.reshape(_leading + (3,)), bending.reshape(_leading + (3,))
