"""manipulability (x_alpha) of planar_rrr, in NumPy.

Made from templates/kernel.py.j2; inputs 2015c547c4b653d0a768ae988d6c31027bb4c3d4b095f6dfe5de0b9130c064d2.
256 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_x_alpha(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the x_alpha Jacobian: 29 operations.

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
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l1 * s1
    t2 = c1 * s2 + s1 * c2
    t3 = t1 + t2 * l2
    t4 = (t2 * c3 + (c1 * c2 - s1 * s2) * s3) * l3
    t5 = t3 + t4
    t6 = t5 - t1
    t7 = t6 - t5
    t8 = t4 - t6

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.sqrt((t7 * t7 + t3 * t3 + t8 * t8))
    return manipulability.reshape(_leading)


def manipulability_gradient_x_alpha(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the x_alpha Jacobian, columns in lexicographic order: 90 operations.

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
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l1 * s1
    t2 = c1 * s2 + s1 * c2
    t3 = t1 + t2 * l2
    t4 = c1 * c2 - s1 * s2
    t5 = (t2 * c3 + t4 * s3) * l3
    t6 = t3 + t5
    t7 = t6 - t1
    t8 = t7 - t6
    t9 = t5 - t7
    t10 = np.sqrt((t8 * t8 + t3 * t3 + t9 * t9))
    t11 = t9 / t10
    t12 = t8 / t10
    t13 = t12 - t11
    t14 = t13 - t12
    t15 = l3 * (t11 + t14)
    t16 = t14 + t3 / t10
    t17 = c3 * t15 + l2 * t16
    t18 = s3 * t15
    t19 = c1 * (c2 * t17 - s2 * t18 + l1 * (t16 - t13))
    t20 = t19 - s1 * (c2 * t18 + s2 * t17)
    t21 = c2 * (c1 * t17 - s1 * t18) - s2 * (c1 * t18 + s1 * t17)
    t22 = c3 * (t4 * t15) - s3 * (t2 * t15)
    t23 = 1 / t10
    t24 = t23 * t23
    t25 = -0.5 / t10 * np.sqrt(t23)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 3), _real)
    inverse_gradient = np.empty((*_leading, 3), _real)
    inverse_root_gradient = np.empty((*_leading, 3), _real)
    manipulability[..., 0] = t10
    gradient[..., 0] = np.where(t10 != 0.0, t20, 0.0)
    gradient[..., 1] = np.where(t10 != 0.0, t21, 0.0)
    gradient[..., 2] = np.where(t10 != 0.0, t22, 0.0)
    inverse_gradient[..., 0] = np.where(t10 != 0.0, -(t20 * t24), 0.0)
    inverse_gradient[..., 1] = np.where(t10 != 0.0, -(t21 * t24), 0.0)
    inverse_gradient[..., 2] = np.where(t10 != 0.0, -(t22 * t24), 0.0)
    inverse_root_gradient[..., 0] = np.where(t10 != 0.0, t20 * t25, 0.0)
    inverse_root_gradient[..., 1] = np.where(t10 != 0.0, t21 * t25, 0.0)
    inverse_root_gradient[..., 2] = np.where(t10 != 0.0, t22 * t25, 0.0)
    return manipulability.reshape(_leading), gradient.reshape(_leading + (3,)), inverse_gradient.reshape(_leading + (3,)), inverse_root_gradient.reshape(_leading + (3,))


def minors_x_alpha(q, parameters):
    """maximal minors of the x_alpha Jacobian, columns in lexicographic order: 24 operations.

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
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l1 * s1
    t2 = c1 * s2 + s1 * c2
    t3 = t1 + t2 * l2
    t4 = (t2 * c3 + (c1 * c2 - s1 * s2) * s3) * l3
    t5 = t3 + t4
    t6 = t5 - t1

    # results
    minors = np.empty((*_leading, 3), _real)
    minors[..., 0] = t6 - t5
    minors[..., 1] = -t3
    minors[..., 2] = t4 - t6
    return minors.reshape(_leading + (3,))


def null_vector_x_alpha(q, parameters):
    """null vector of the x_alpha Jacobian from its signed minors, |N| = H: 23 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
    out  null_vector[3]
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
    t2 = (c3 * t1 + (c1 * c2 - s2 * s1) * s3) * l3
    t3 = s1 * l1
    t4 = t3 + t1 * l2
    t5 = t2 + t4
    t6 = t5 - t3

    # results
    null_vector = np.empty((*_leading, 3), _real)
    null_vector[..., 0] = t2 - t6
    null_vector[..., 1] = t4
    null_vector[..., 2] = t6 - t5
    return null_vector.reshape(_leading + (3,))


def null_projector_x_alpha(q, parameters):
    """projector I - J^+ J onto the null space of the x_alpha Jacobian: 90 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
    out  null_projector[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l1 * s1
    t2 = c1 * s2 + s1 * c2
    t3 = (t2 * c3 + (c1 * c2 - s1 * s2) * s3) * l3
    t4 = t1 + t2 * l2 + t3
    t5 = t4 - t1
    t6 = np.sqrt((t5 * t5 + t3 * t3 + t4 * t4))
    t7 = np.where(t6 != 0.0, 1, 0.0)
    t8 = t7 / (t6 + (1 - t7))
    t9 = t4 * t8
    t10 = t5 * t8
    t11 = t3 * t8
    t12 = t9 + t10 + t11
    t13 = 1 - t9 * t12
    t14 = 1 - t10 * t12
    t15 = 1 - t11 * t12
    t16 = t9 * t13 + t10 * t14 + t11 * t15
    t17 = t13 - t9 * t16
    t18 = t14 - t10 * t16
    t19 = t15 - t11 * t16
    t20 = np.sqrt((t17 * t17 + t18 * t18 + t19 * t19))
    t21 = np.where(t20 != 0.0, 1, 0.0)
    t22 = t21 / (t20 + (1 - t21))
    t23 = t17 * t22
    t24 = t18 * t22
    t25 = -(t9 * t10 + t23 * t24)
    t26 = t19 * t22
    t27 = -(t9 * t11 + t23 * t26)
    t28 = -(t10 * t11 + t24 * t26)

    # results
    null_projector = np.empty((*_leading, 9), _real)
    null_projector[..., 0] = 1 - t9 * t9 - t23 * t23
    null_projector[..., 1] = t25
    null_projector[..., 2] = t27
    null_projector[..., 3] = t25
    null_projector[..., 4] = 1 - t10 * t10 - t24 * t24
    null_projector[..., 5] = t28
    null_projector[..., 6] = t27
    null_projector[..., 7] = t28
    null_projector[..., 8] = 1 - t11 * t11 - t26 * t26
    return null_projector.reshape(_leading + (3, 3))
