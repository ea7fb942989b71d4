"""manipulability (x_alpha) of planar_rrr, in NumPy.

Made from templates/kernel.py.j2; inputs 9573552b51a736ea3c3fe09399dd0856a2fca307fd2bc3f675f8c1f525a6b9e3.
311 operations. Do not edit: change the derivation and regenerate.

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
    """projector I - J^+ J onto the null space of the x_alpha Jacobian: 145 operations.

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
    t7 = np.where(t6 != 0.0, t4 / t6, 0.0)
    t8 = np.where(t6 != 0.0, t5 / t6, 0.0)
    t9 = np.where(t6 != 0.0, t3 / t6, 0.0)
    t10 = np.sqrt((t7 * t7 + t8 * t8 + t9 * t9))
    t11 = t7 / t10
    t12 = t8 / t10
    t13 = t9 / t10
    t14 = t11 + t12 + t13
    t15 = 1 - np.where(t10 != 0.0, np.where(t10 != 0.0, t11 * t14, 0.0), 0.0)
    t16 = 1 - np.where(t10 != 0.0, np.where(t10 != 0.0, t12 * t14, 0.0), 0.0)
    t17 = 1 - np.where(t10 != 0.0, np.where(t10 != 0.0, t13 * t14, 0.0), 0.0)
    t18 = np.sqrt((t15 * t15 + t16 * t16 + t17 * t17))
    t19 = t15 / t18
    t20 = t16 / t18
    t21 = t17 / t18
    t22 = t11 * t19 + t12 * t20 + t13 * t21
    t23 = np.where(t18 != 0.0, t19, 0.0) - np.where(t10 != 0.0, np.where(t18 != 0.0, np.where(t10 != 0.0, t11 * t22, 0.0), 0.0), 0.0)
    t24 = np.where(t18 != 0.0, t20, 0.0) - np.where(t10 != 0.0, np.where(t18 != 0.0, np.where(t10 != 0.0, t12 * t22, 0.0), 0.0), 0.0)
    t25 = np.where(t18 != 0.0, t21, 0.0) - np.where(t10 != 0.0, np.where(t18 != 0.0, np.where(t10 != 0.0, t13 * t22, 0.0), 0.0), 0.0)
    t26 = np.sqrt((t23 * t23 + t24 * t24 + t25 * t25))
    t27 = t23 / t26
    t28 = 1 - np.where(t10 != 0.0, np.where(t10 != 0.0, t11 * t11, 0.0), 0.0) - np.where(t26 != 0.0, np.where(t26 != 0.0, t27 * t27, 0.0), 0.0)
    t29 = t24 / t26
    t30 = np.where(t10 != 0.0, np.where(t10 != 0.0, t11 * t12, 0.0), 0.0) + np.where(t26 != 0.0, np.where(t26 != 0.0, t27 * t29, 0.0), 0.0)
    t31 = -t30
    t32 = t25 / t26
    t33 = np.where(t10 != 0.0, np.where(t10 != 0.0, t11 * t13, 0.0), 0.0) + np.where(t26 != 0.0, np.where(t26 != 0.0, t27 * t32, 0.0), 0.0)
    t34 = -t33
    t35 = 1 - np.where(t10 != 0.0, np.where(t10 != 0.0, t12 * t12, 0.0), 0.0) - np.where(t26 != 0.0, np.where(t26 != 0.0, t29 * t29, 0.0), 0.0)
    t36 = np.where(t10 != 0.0, np.where(t10 != 0.0, t12 * t13, 0.0), 0.0) + np.where(t26 != 0.0, np.where(t26 != 0.0, t29 * t32, 0.0), 0.0)
    t37 = -t36
    t38 = 1 - np.where(t10 != 0.0, np.where(t10 != 0.0, t13 * t13, 0.0), 0.0) - np.where(t26 != 0.0, np.where(t26 != 0.0, t32 * t32, 0.0), 0.0)

    # results
    null_projector = np.empty((*_leading, 9), _real)
    null_projector[..., 0] = t28
    null_projector[..., 1] = t31
    null_projector[..., 2] = t34
    null_projector[..., 3] = t31
    null_projector[..., 4] = t35
    null_projector[..., 5] = t37
    null_projector[..., 6] = t34
    null_projector[..., 7] = t37
    null_projector[..., 8] = t38
    return null_projector.reshape(_leading + (3, 3))
