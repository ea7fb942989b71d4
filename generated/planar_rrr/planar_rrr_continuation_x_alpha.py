"""continuation x alpha of planar_rrr, in NumPy.

Made from templates/kernel.py.j2; inputs f29b1b245621ebe2effe4dc47543535c5f273522534b650aa5e0573e5f938bfd.
102 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def continuation_x_alpha(q, held, parameters):
    """error of the x_alpha, its Jacobian, and the null vector from its signed minors: 44 operations.

    in   q[3]
    in   held[2] = (target_x, target_alpha)
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
    target_alpha = held[..., 1]
    cos_target_alpha = np.cos(target_alpha)
    sin_target_alpha = np.sin(target_alpha)

    # terms
    t1 = c1 * c2 - s1 * s2
    t2 = c1 * s2 + c2 * s1
    t3 = t1 * c3 - t2 * s3
    t4 = c3 * t2 + t1 * s3
    t5 = np.arctan2((cos_target_alpha * t4 - t3 * sin_target_alpha), t3 * cos_target_alpha + t4 * sin_target_alpha)
    t6 = l1 * s1
    t7 = t6 + l2 * t2
    t8 = l3 * t4
    t9 = t7 + t8
    t10 = t9 - t6

    # results
    error = np.empty((*_leading, 2), _real)
    jacobian = np.empty((*_leading, 6), _real)
    null_vector = np.empty((*_leading, 3), _real)
    error[..., 0] = c1 * l1 + t1 * l2 + t3 * l3 - target_x
    error[..., 1] = t5
    jacobian[..., 0] = -t9
    jacobian[..., 1] = -t10
    jacobian[..., 2] = -t8
    jacobian[..., 3] = 1
    jacobian[..., 4] = 1
    jacobian[..., 5] = 1
    null_vector[..., 0] = t8 - t10
    null_vector[..., 1] = t7
    null_vector[..., 2] = t10 - t9
    return error.reshape(_leading + (2,)), jacobian.reshape(_leading + (2, 3)), null_vector.reshape(_leading + (3,))


def continuation_x_alpha_bending(q, parameters):
    """null vector of the x_alpha Jacobian, and its derivative along itself: 58 operations.

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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]

    # terms
    t1 = c1 * s2 + c2 * s1
    t2 = c1 * c2 - s2 * s1
    t3 = (c3 * t1 + t2 * s3) * l3
    t4 = s1 * l1
    t5 = t4 + t1 * l2
    t6 = t3 + t5
    t7 = t6 - t4
    t8 = t3 - t7
    t9 = t7 - t6
    t10 = c2 * t5
    t11 = c1 * t8
    t12 = s1 * t8
    t13 = s2 * t5
    t14 = c1 * t10 + c2 * t11 - s2 * t12 - s1 * t13
    t15 = c1 * t13 + c2 * t12 + s2 * t11 + s1 * t10
    t16 = c3 * t14 - t1 * (s3 * t9) - s3 * t15 + t2 * (c3 * t9)
    t17 = l3 * t16
    t18 = l1 * t11
    t19 = t18 + l2 * t14
    t20 = t17 + t19
    t21 = t20 - t18

    # results
    null_vector = np.empty((*_leading, 3), _real)
    bending = np.empty((*_leading, 3), _real)
    null_vector[..., 0] = t8
    null_vector[..., 1] = t5
    null_vector[..., 2] = t9
    bending[..., 0] = t17 - t21
    bending[..., 1] = t19
    bending[..., 2] = t21 - t20
    return null_vector.reshape(_leading + (3,)), bending.reshape(_leading + (3,))
