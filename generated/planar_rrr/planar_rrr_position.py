"""manipulability (position) of planar_rrr, in NumPy.

Made from templates/kernel.py.j2; inputs 2015c547c4b653d0a768ae988d6c31027bb4c3d4b095f6dfe5de0b9130c064d2.
204 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_position(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the position Jacobian: 23 operations.

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
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    s2 = np.sin(q2)
    l3 = parameters[..., 2]
    c2 = np.cos(q2)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)

    # terms
    t1 = c2 * s3 + s2 * c3
    t2 = l1 * (l2 * s2 + l3 * t1)
    t3 = l3 * (l1 * t1 + l2 * s3)
    t4 = s3 * (l2 * l3)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.sqrt((t2 * t2 + t3 * t3 + t4 * t4))
    return manipulability.reshape(_leading)


def manipulability_gradient_position(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the minors (1,2), (1,3), (2,3) of the position Jacobian, in closed form: 64 operations.

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
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    s2 = np.sin(q2)
    l3 = parameters[..., 2]
    c2 = np.cos(q2)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)

    # terms
    t1 = c2 * s3 + s2 * c3
    t2 = l1 * (l2 * s2 + l3 * t1)
    t3 = l3 * (l1 * t1 + l2 * s3)
    t4 = l2 * l3
    t5 = s3 * t4
    t6 = np.sqrt((t2 * t2 + t3 * t3 + t5 * t5))
    t7 = l3 * (t3 / t6)
    t8 = l1 * (t2 / t6)
    t9 = l1 * t7 + l3 * t8
    t10 = c2 * (c3 * t9 + l2 * t8) - s2 * (s3 * t9)
    t11 = c3 * (t4 * (t5 / t6) + l2 * t7 + c2 * t9)
    t12 = t11 - s3 * (s2 * t9)
    t13 = 1 / t6
    t14 = t13 * t13
    t15 = -0.5 / t6 * np.sqrt(t13)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 3), _real)
    inverse_gradient = np.empty((*_leading, 3), _real)
    inverse_root_gradient = np.empty((*_leading, 3), _real)
    manipulability[..., 0] = t6
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t6 != 0.0, t10, 0.0)
    gradient[..., 2] = np.where(t6 != 0.0, t12, 0.0)
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t6 != 0.0, -(t10 * t14), 0.0)
    inverse_gradient[..., 2] = np.where(t6 != 0.0, -(t12 * t14), 0.0)
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t6 != 0.0, t10 * t15, 0.0)
    inverse_root_gradient[..., 2] = np.where(t6 != 0.0, t12 * t15, 0.0)
    return manipulability.reshape(_leading), gradient.reshape(_leading + (3,)), inverse_gradient.reshape(_leading + (3,)), inverse_root_gradient.reshape(_leading + (3,))


def minors_position(q, parameters):
    """minors (1,2), (1,3), (2,3) of the position Jacobian, in closed form: 17 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
    out  minors[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    s2 = np.sin(q2)
    l3 = parameters[..., 2]
    c2 = np.cos(q2)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)

    # terms
    t1 = c2 * s3 + s2 * c3

    # results
    minors = np.empty((*_leading, 3), _real)
    minors[..., 0] = l1 * (l2 * s2 + l3 * t1)
    minors[..., 1] = l3 * (l1 * t1 + l2 * s3)
    minors[..., 2] = s3 * (l2 * l3)
    return minors.reshape(_leading + (3,))


def null_vector_position(q, parameters):
    """null vector of the position Jacobian from its signed minors, |N| = H: 18 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
    out  null_vector[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    s3 = np.sin(q3)
    l1 = parameters[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    c3 = np.cos(q3)
    s2 = np.sin(q2)

    # terms
    t1 = s3 * c2 + c3 * s2

    # results
    null_vector = np.empty((*_leading, 3), _real)
    null_vector[..., 0] = l2 * l3 * s3
    null_vector[..., 1] = -(l3 * (l1 * t1 + l2 * s3))
    null_vector[..., 2] = l1 * (l2 * s2 + l3 * t1)
    return null_vector.reshape(_leading + (3,))


def null_projector_position(q, parameters):
    """projector I - J^+ J onto the null space of the position Jacobian: 82 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
    out  null_projector[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    l3 = parameters[..., 2]
    l2 = parameters[..., 1]
    l1 = parameters[..., 0]

    # terms
    t1 = (c2 * s3 + c3 * s2) * l3
    t2 = t1 + s2 * l2
    t3 = t2 * t2
    t4 = np.sqrt((t1 * t1 + (t3 + t3)))
    t5 = np.where(t4 != 0.0, 1, 0.0)
    t6 = t5 / (t4 + (1 - t5))
    t7 = t2 * t6
    t8 = t7 * t7
    t9 = 1 - t8
    t10 = l3 * (c2 * c3 - s3 * s2)
    t11 = l1 + c2 * l2 + t10
    t12 = t11 - l1
    t13 = t1 * t6
    t14 = t7 * t12 + t10 * t13 + t7 * t11
    t15 = t7 * t14
    t16 = t11 - t15
    t17 = t12 - t15
    t18 = t10 - t13 * t14
    t19 = t7 * t16 + t7 * t17 + t13 * t18
    t20 = t7 * t19
    t21 = t16 - t20
    t22 = t17 - t20
    t23 = t18 - t13 * t19
    t24 = np.sqrt((t21 * t21 + t22 * t22 + t23 * t23))
    t25 = np.where(t24 != 0.0, 1, 0.0)
    t26 = t25 / (t24 + (1 - t25))
    t27 = t21 * t26
    t28 = t22 * t26
    t29 = -(t8 + t27 * t28)
    t30 = t7 * t13
    t31 = t23 * t26
    t32 = -(t30 + t27 * t31)
    t33 = -(t30 + t28 * t31)

    # results
    null_projector = np.empty((*_leading, 9), _real)
    null_projector[..., 0] = t9 - t27 * t27
    null_projector[..., 1] = t29
    null_projector[..., 2] = t32
    null_projector[..., 3] = t29
    null_projector[..., 4] = t9 - t28 * t28
    null_projector[..., 5] = t33
    null_projector[..., 6] = t32
    null_projector[..., 7] = t33
    null_projector[..., 8] = 1 - t13 * t13 - t31 * t31
    return null_projector.reshape(_leading + (3, 3))
