"""manipulability (pose) of planar_rrr, in NumPy.

Made from templates/kernel.py.j2; inputs 2015c547c4b653d0a768ae988d6c31027bb4c3d4b095f6dfe5de0b9130c064d2.
138 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_pose(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the pose Jacobian: 29 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
    out  manipulability (one number)
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
    t3 = l3 * (c2 * s3 + c3 * s2)
    t4 = l2 * s2 + t3
    t5 = t2 - l1
    t6 = t1 * t4
    t7 = t2 * t4 - t4 * t5 + (t3 * t5 - t6) - (t2 * t3 - t6)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.abs(t7)
    return manipulability.reshape(_leading)


def manipulability_gradient_pose(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in lexicographic order: 81 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
    out  manipulability (one number)
    out  gradient[3]
    out  inverse_gradient[3]
    out  inverse_root_gradient[3]
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
    t3 = l3 * (c2 * s3 + c3 * s2)
    t4 = l2 * s2 + t3
    t5 = t2 - l1
    t6 = t1 * t4
    t7 = t2 * t4 - t4 * t5 + (t3 * t5 - t6) - (t2 * t3 - t6)
    t8 = np.abs(t7)
    t9 = t7 / t8
    t10 = t5 * t9
    t11 = t2 * t9
    t12 = t11 - t10
    t13 = l3 * (t10 - t11 + t12)
    t14 = t3 * t9
    t15 = t4 * t9
    t16 = t15 + (t14 - t15 - t14)
    t17 = l3 * t16
    t18 = c2 * (c3 * t13 + l2 * t12 - s3 * t17) - s2 * (s3 * t13 + c3 * t17 + l2 * t16)
    t19 = c3 * (c2 * t13 - s2 * t17) - s3 * (s2 * t13 + c2 * t17)
    t20 = 1 / t8
    t21 = t20 * t20
    t22 = -0.5 / t8 * np.sqrt(t20)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 3), _real)
    inverse_gradient = np.empty((*_leading, 3), _real)
    inverse_root_gradient = np.empty((*_leading, 3), _real)
    manipulability[..., 0] = t8
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t8 != 0.0, t18, 0.0)
    gradient[..., 2] = np.where(t8 != 0.0, t19, 0.0)
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t8 != 0.0, -(t18 * t21), 0.0)
    inverse_gradient[..., 2] = np.where(t8 != 0.0, -(t19 * t21), 0.0)
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t8 != 0.0, t18 * t22, 0.0)
    inverse_root_gradient[..., 2] = np.where(t8 != 0.0, t19 * t22, 0.0)
    return manipulability.reshape(_leading), gradient.reshape(_leading + (3,)), inverse_gradient.reshape(_leading + (3,)), inverse_root_gradient.reshape(_leading + (3,))


def minors_pose(q, parameters):
    """maximal minors of the pose Jacobian, columns in lexicographic order: 28 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
    out  minors[1]
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
    t3 = l3 * (c2 * s3 + c3 * s2)
    t4 = l2 * s2 + t3
    t5 = t2 - l1
    t6 = t1 * t4
    t7 = t2 * t4 - t4 * t5 + (t3 * t5 - t6) - (t2 * t3 - t6)

    # results
    minors = np.empty((*_leading, 1), _real)
    minors[..., 0] = t7
    return minors.reshape(_leading + (1,))
