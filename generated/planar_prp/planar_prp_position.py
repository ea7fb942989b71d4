"""manipulability (position) of planar_prp, in NumPy.

Made from templates/kernel.py.j2; inputs 8faeb40d9c6642a7751b893456ee31cf9e47d22e5ca615f046e21e50f66d5563.
454 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_position(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the position Jacobian: 29 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  manipulability (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    heading3 = parameters[..., 4]
    sin_heading3 = np.sin(heading3)
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = c2 * sin_heading3 + cos_heading3 * s2
    t2 = c2 * cos_heading3 - sin_heading3 * s2
    t3 = l1 + q1
    t4 = l3 + q3
    t5 = t3 + c2 * l2 + t2 * t4 - t3
    t6 = t2 * t5 + t1 * (s2 * l2 + t1 * t4)

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.sqrt((t1 * t1 + t6 * t6 + t5 * t5))
    return manipulability.reshape(leading)


def manipulability_gradient_position(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in lexicographic order: 75 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  manipulability (one number)
    out  gradient[3]
    out  inverse_gradient[3]
    out  inverse_root_gradient[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = l1 + q1
    t2 = c2 * cos_heading3 - s2 * sin_heading3
    t3 = l3 + q3
    t4 = t1 + c2 * l2 + t2 * t3 - t1
    t5 = c2 * sin_heading3 + cos_heading3 * s2
    t6 = l2 * s2 + t3 * t5
    t7 = t2 * t4 + t5 * t6
    t8 = np.sqrt((t4 * t4 + t5 * t5 + t7 * t7))
    t9 = t7 / t8
    t10 = t5 * t9
    t11 = t6 * t9 + t3 * t10 + t5 / t8
    t12 = t2 * t9 + t4 / t8
    t13 = t4 * t9 + t3 * t12
    t14 = c2 * (l2 * t10 + cos_heading3 * t11 - sin_heading3 * t13) - s2 * (sin_heading3 * t11 + cos_heading3 * t13 + l2 * t12)
    t15 = t5 * t10 + t2 * t12
    t16 = 1.0 / t8
    t17 = t16 * t16
    t18 = -0.5 / t8 * np.sqrt(t16)

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = t8
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t8 != 0.0, t14, 0.0)
    gradient[..., 2] = np.where(t8 != 0.0, t15, 0.0)
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t8 != 0.0, -(t14 * t17), 0.0)
    inverse_gradient[..., 2] = np.where(t8 != 0.0, -(t15 * t17), 0.0)
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t8 != 0.0, t14 * t18, 0.0)
    inverse_root_gradient[..., 2] = np.where(t8 != 0.0, t15 * t18, 0.0)
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_position(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the position Jacobian, columns in lexicographic order: 136 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  square (one number)
    out  gradient[3]
    out  hessian[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = l1 + q1
    t2 = c2 * l2
    t3 = c2 * cos_heading3 - s2 * sin_heading3
    t4 = l3 + q3
    t5 = t3 * t4
    t6 = t1 + t2 + t5 - t1
    t7 = c2 * sin_heading3 + cos_heading3 * s2
    t8 = t7 * t7
    t9 = l2 * s2
    t10 = t4 * t7
    t11 = t9 + t10
    t12 = t3 * t6 + t7 * t11
    t13 = t12 + t12
    t14 = t7 * t13
    t15 = t11 * t13 + t4 * t14 + (t7 + t7)
    t16 = t3 * t13
    t17 = t16 + (t6 + t6)
    t18 = t6 * t13 + t4 * t17
    t19 = l2 * t14 + cos_heading3 * t15 - sin_heading3 * t18
    t20 = sin_heading3 * t15 + cos_heading3 * t18 + l2 * t17
    t21 = -1.0 + (1.0 - t9 - t10)
    t22 = t2 + t5
    t23 = t3 * t21 - t6 * t7 + (t3 * t11 + t7 * t22)
    t24 = t23 + t23
    t25 = t16 + t7 * t24
    t26 = t3 + t3
    t27 = t13 * t22 + t11 * t24 + t4 * t25 + t26
    t28 = t3 * t24 - t14 + (t21 + t21)
    t29 = t13 * t21 + t6 * t24 + t4 * t28
    t30 = c2 * (l2 * t25 + cos_heading3 * t27 - sin_heading3 * t29) - s2 * t19
    t31 = c2 * t20 + s2 * (sin_heading3 * t27 + cos_heading3 * t29 + l2 * t28)
    t32 = t8 + t3 * t3
    t33 = t32 + t32
    t34 = t7 * t33
    t35 = t14 + t11 * t33 + (t14 + t4 * t34)
    t36 = t26 + t3 * t33
    t37 = t16 + t6 * t33 + (t17 + t4 * t36)
    t38 = c2 * (l2 * t34 + cos_heading3 * t35 - sin_heading3 * t37) - s2 * (sin_heading3 * t35 + cos_heading3 * t37 + l2 * t36)

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = t6 * t6 + t8 + t12 * t12
    gradient[..., 0] = 0.0
    gradient[..., 1] = c2 * t19 - s2 * t20
    gradient[..., 2] = t7 * t14 + t3 * t17
    hessian[..., 0] = 0.0
    hessian[..., 1] = 0.0
    hessian[..., 2] = 0.0
    hessian[..., 3] = 0.0
    hessian[..., 4] = t30 - t31
    hessian[..., 5] = t38
    hessian[..., 6] = 0.0
    hessian[..., 7] = t38
    hessian[..., 8] = t7 * t34 + t3 * t36
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_position(q, parameters):
    """maximal minors of the position Jacobian, columns in lexicographic order: 24 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  minors[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = l1 + q1
    t2 = c2 * cos_heading3 - s2 * sin_heading3
    t3 = l3 + q3
    t4 = t1 + c2 * l2 + t2 * t3 - t1
    t5 = c2 * sin_heading3 + cos_heading3 * s2
    t6 = -(t2 * t4 + t5 * (l2 * s2 + t3 * t5))

    # results
    minors = np.empty((*leading, 3), real)
    minors[..., 0] = t4
    minors[..., 1] = t5
    minors[..., 2] = t6
    return minors.reshape(leading + (3,))


def null_vector_position(q, parameters):
    """null vector of the position Jacobian from its signed minors, |N| = H: 25 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  null_vector[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = c2 * cos_heading3 - s2 * sin_heading3
    t2 = l1 + q1
    t3 = l3 + q3
    t4 = t2 + c2 * l2 + t1 * t3 - t2
    t5 = c2 * sin_heading3 + cos_heading3 * s2
    t6 = -(t1 * t4 + t5 * (s2 * l2 + t3 * t5))

    # results
    null_vector = np.empty((*leading, 3), real)
    null_vector[..., 0] = t6
    null_vector[..., 1] = -t5
    null_vector[..., 2] = t4
    return null_vector.reshape(leading + (3,))


def null_projector_position(q, parameters):
    """projector I - J^+ J onto the null space of the position Jacobian: 165 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  null_projector[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    l1 = parameters[..., 0]
    q1 = q[..., 0]

    # terms
    t1 = c2 * cos_heading3 - s2 * sin_heading3
    t2 = c2 * sin_heading3 + cos_heading3 * s2
    t3 = l3 + q3
    t4 = s2 * l2 + t2 * t3
    t5 = np.sqrt((1.0 + t1 * t1 + t4 * t4))
    t6 = 1.0 / t5
    t7 = np.where(t5 != 0.0, t4 / t5, 0.0)
    t8 = t1 / t5
    t9 = np.where(t5 != 0.0, np.where(t5 != 0.0, t6 * t6, 0.0), 0.0) + t7 * t7 + np.where(t5 != 0.0, np.where(t5 != 0.0, t8 * t8, 0.0), 0.0)
    t10 = np.sqrt(t9)
    t11 = t6 / t10
    t12 = t8 / t10
    t13 = l1 + q1
    t14 = t13 + c2 * l2 + t1 * t3 - t13
    t15 = t7 / t10
    t16 = np.where(t5 != 0.0, np.where(t10 != 0.0, t2 * t12, 0.0), 0.0) + np.where(t10 != 0.0, -(t14 * t15), 0.0)
    t17 = np.where(t10 != 0.0, np.where(t5 != 0.0, t11 * t16, 0.0), 0.0)
    t18 = t14 - np.where(t10 != 0.0, -(t15 * t16), 0.0)
    t19 = t2 - np.where(t5 != 0.0, np.where(t10 != 0.0, t12 * t16, 0.0), 0.0)
    t20 = np.sqrt((t17 * t17 + t18 * t18 + t19 * t19))
    t21 = t17 / t20
    t22 = t18 / t20
    t23 = t19 / t20
    t24 = np.where(t10 != 0.0, np.where(t5 != 0.0, -(t11 * t21), 0.0) - t15 * t22, 0.0) + np.where(t5 != 0.0, np.where(t10 != 0.0, t12 * t23, 0.0), 0.0)
    t25 = np.where(t20 != 0.0, -t21, 0.0) - np.where(t10 != 0.0, np.where(t5 != 0.0, np.where(t20 != 0.0, t11 * t24, 0.0), 0.0), 0.0)
    t26 = np.where(t20 != 0.0, t22, 0.0) - np.where(t10 != 0.0, np.where(t20 != 0.0, -(t15 * t24), 0.0), 0.0)
    t27 = np.where(t20 != 0.0, t23, 0.0) - np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t20 != 0.0, t12 * t24, 0.0), 0.0), 0.0)
    t28 = np.sqrt((t25 * t25 + t26 * t26 + t27 * t27))
    t29 = t25 / t28
    t30 = 1.0 - np.where(t10 != 0.0, np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t5 != 0.0, t11 * t11, 0.0), 0.0), 0.0), 0.0) - np.where(t28 != 0.0, np.where(t28 != 0.0, t29 * t29, 0.0), 0.0)
    t31 = t26 / t28
    t32 = np.where(t10 != 0.0, np.where(t10 != 0.0, np.where(t5 != 0.0, -(t11 * t15), 0.0), 0.0), 0.0) + np.where(t28 != 0.0, np.where(t28 != 0.0, t29 * t31, 0.0), 0.0)
    t33 = -t32
    t34 = t27 / t28
    t35 = np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t10 != 0.0, np.where(t5 != 0.0, t11 * t12, 0.0), 0.0), 0.0), 0.0) + np.where(t28 != 0.0, np.where(t28 != 0.0, t29 * t34, 0.0), 0.0)
    t36 = -t35
    t37 = 1.0 - np.where(t10 != 0.0, np.where(t10 != 0.0, t15 * t15, 0.0), 0.0) - np.where(t28 != 0.0, np.where(t28 != 0.0, t31 * t31, 0.0), 0.0)
    t38 = np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t10 != 0.0, -(t12 * t15), 0.0), 0.0), 0.0) + np.where(t28 != 0.0, np.where(t28 != 0.0, t31 * t34, 0.0), 0.0)
    t39 = -t38
    t40 = 1.0 - np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t5 != 0.0, np.where(t10 != 0.0, t12 * t12, 0.0), 0.0), 0.0), 0.0) - np.where(t28 != 0.0, np.where(t28 != 0.0, t34 * t34, 0.0), 0.0)

    # results
    null_projector = np.empty((*leading, 9), real)
    null_projector[..., 0] = t30
    null_projector[..., 1] = t33
    null_projector[..., 2] = t36
    null_projector[..., 3] = t33
    null_projector[..., 4] = t37
    null_projector[..., 5] = t39
    null_projector[..., 6] = t36
    null_projector[..., 7] = t39
    null_projector[..., 8] = t40
    return null_projector.reshape(leading + (3, 3))
