"""manipulability (x_alpha) of planar_prp, in NumPy.

Made from templates/kernel.py.j2; inputs 8faeb40d9c6642a7751b893456ee31cf9e47d22e5ca615f046e21e50f66d5563.
304 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_x_alpha(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the x_alpha Jacobian: 19 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  manipulability (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    sin_heading1 = np.sin(heading1)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)

    # terms
    t1 = cos_heading3 * (cos_heading1 * c2 - sin_heading1 * s2) - (cos_heading1 * s2 + c2 * sin_heading1) * sin_heading3

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.sqrt((cos_heading1 * cos_heading1 + t1 * t1))
    return manipulability.reshape(leading)


def manipulability_gradient_x_alpha(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the x_alpha Jacobian, columns in lexicographic order: 43 operations.

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
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    sin_heading1 = np.sin(heading1)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)

    # terms
    t1 = cos_heading3 * (cos_heading1 * c2 - sin_heading1 * s2) - (cos_heading1 * s2 + c2 * sin_heading1) * sin_heading3
    t2 = np.sqrt((cos_heading1 * cos_heading1 + t1 * t1))
    t3 = t1 / t2
    t4 = sin_heading3 * t3
    t5 = cos_heading3 * t3
    t6 = c2 * (cos_heading1 * t4 + sin_heading1 * t5) + s2 * (cos_heading1 * t5 - sin_heading1 * t4)
    t7 = 1.0 / t2

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = t2
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t2 != 0.0, -t6, 0.0)
    gradient[..., 2] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t2 != 0.0, t6 * (t7 * t7), 0.0)
    inverse_gradient[..., 2] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t2 != 0.0, -(t6 * (-0.5 / t2 * np.sqrt(t7))), 0.0)
    inverse_root_gradient[..., 2] = 0.0
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_x_alpha(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the x_alpha Jacobian, columns in lexicographic order: 52 operations.

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
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    sin_heading1 = np.sin(heading1)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)

    # terms
    t1 = cos_heading1 * c2 - sin_heading1 * s2
    t2 = cos_heading1 * s2 + c2 * sin_heading1
    t3 = cos_heading3 * t1 - t2 * sin_heading3
    t4 = t3 + t3
    t5 = sin_heading3 * t4
    t6 = cos_heading3 * t4
    t7 = cos_heading1 * t5 + sin_heading1 * t6
    t8 = cos_heading1 * t6 - sin_heading1 * t5
    t9 = cos_heading3 * t2 + t1 * sin_heading3
    t10 = -t9 - t9
    t11 = sin_heading3 * t10
    t12 = cos_heading3 * t10
    t13 = c2 * (cos_heading1 * t11 + sin_heading1 * t12) - s2 * t7 + (c2 * t8 + s2 * (cos_heading1 * t12 - sin_heading1 * t11))

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = cos_heading1 * cos_heading1 + t3 * t3
    gradient[..., 0] = 0.0
    gradient[..., 1] = -(c2 * t7 + s2 * t8)
    gradient[..., 2] = 0.0
    hessian[..., 0] = 0.0
    hessian[..., 1] = 0.0
    hessian[..., 2] = 0.0
    hessian[..., 3] = 0.0
    hessian[..., 4] = -t13
    hessian[..., 5] = 0.0
    hessian[..., 6] = 0.0
    hessian[..., 7] = 0.0
    hessian[..., 8] = 0.0
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_x_alpha(q, parameters):
    """maximal minors of the x_alpha Jacobian, columns in lexicographic order: 16 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  minors[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    sin_heading1 = np.sin(heading1)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)

    # terms
    t1 = cos_heading3 * (cos_heading1 * c2 - sin_heading1 * s2) - (cos_heading1 * s2 + c2 * sin_heading1) * sin_heading3

    # results
    minors = np.empty((*leading, 3), real)
    minors[..., 0] = cos_heading1
    minors[..., 1] = 0.0
    minors[..., 2] = -t1
    return minors.reshape(leading + (3,))


def null_vector_x_alpha(q, parameters):
    """null vector of the x_alpha Jacobian from its signed minors, |N| = H: 16 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  null_vector[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    sin_heading1 = np.sin(heading1)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)

    # terms
    t1 = cos_heading3 * (cos_heading1 * c2 - sin_heading1 * s2) - (cos_heading1 * s2 + c2 * sin_heading1) * sin_heading3

    # results
    null_vector = np.empty((*leading, 3), real)
    null_vector[..., 0] = -t1
    null_vector[..., 1] = 0.0
    null_vector[..., 2] = cos_heading1
    return null_vector.reshape(leading + (3,))


def null_projector_x_alpha(q, parameters):
    """projector I - J^+ J onto the null space of the x_alpha Jacobian: 158 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  null_projector[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    sin_heading1 = np.sin(heading1)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = cos_heading1 * c2 - sin_heading1 * s2
    t2 = cos_heading1 * s2 + c2 * sin_heading1
    t3 = cos_heading3 * t1 - t2 * sin_heading3
    t4 = sin_heading1 * (l1 + q1)
    t5 = t4 + t2 * l2 + (cos_heading3 * t2 + t1 * sin_heading3) * (l3 + q3)
    t6 = t5 - t4
    t7 = np.sqrt((cos_heading1 * cos_heading1 + t3 * t3 + t6 * t6))
    t8 = cos_heading1 / t7
    t9 = np.where(t7 != 0.0, t6 / t7, 0.0)
    t10 = t3 / t7
    t11 = np.where(t7 != 0.0, np.where(t7 != 0.0, t8 * t8, 0.0), 0.0) + t9 * t9 + np.where(t7 != 0.0, np.where(t7 != 0.0, t10 * t10, 0.0), 0.0)
    t12 = np.sqrt(t11)
    t13 = t8 / t12
    t14 = t9 / t12
    t15 = np.where(t12 != 0.0, np.where(t7 != 0.0, np.where(t12 != 0.0, -(t13 * t14), 0.0), 0.0), 0.0)
    t16 = 1.0 - np.where(t12 != 0.0, np.where(t12 != 0.0, t14 * t14, 0.0), 0.0)
    t17 = t10 / t12
    t18 = np.where(t7 != 0.0, np.where(t12 != 0.0, np.where(t12 != 0.0, -(t14 * t17), 0.0), 0.0), 0.0)
    t19 = np.sqrt((t15 * t15 + t16 * t16 + t18 * t18))
    t20 = t15 / t19
    t21 = t16 / t19
    t22 = np.where(t7 != 0.0, np.where(t12 != 0.0, -(t13 * t20), 0.0), 0.0) + np.where(t12 != 0.0, -(t14 * t21), 0.0)
    t23 = t18 / t19
    t24 = t22 + np.where(t7 != 0.0, np.where(t12 != 0.0, -(t17 * t23), 0.0), 0.0)
    t25 = np.where(t19 != 0.0, -t20, 0.0) - np.where(t7 != 0.0, np.where(t12 != 0.0, np.where(t19 != 0.0, t13 * t24, 0.0), 0.0), 0.0)
    t26 = np.where(t19 != 0.0, t21, 0.0) - np.where(t12 != 0.0, np.where(t19 != 0.0, -(t14 * t24), 0.0), 0.0)
    t27 = np.where(t19 != 0.0, -t23, 0.0) - np.where(t7 != 0.0, np.where(t12 != 0.0, np.where(t19 != 0.0, t17 * t24, 0.0), 0.0), 0.0)
    t28 = np.sqrt((t25 * t25 + t26 * t26 + t27 * t27))
    t29 = t25 / t28
    t30 = 1.0 - np.where(t7 != 0.0, np.where(t12 != 0.0, np.where(t7 != 0.0, np.where(t12 != 0.0, t13 * t13, 0.0), 0.0), 0.0), 0.0) - np.where(t28 != 0.0, np.where(t28 != 0.0, t29 * t29, 0.0), 0.0)
    t31 = t26 / t28
    t32 = -(t15 + np.where(t28 != 0.0, np.where(t28 != 0.0, t29 * t31, 0.0), 0.0))
    t33 = t27 / t28
    t34 = np.where(t7 != 0.0, np.where(t12 != 0.0, np.where(t7 != 0.0, np.where(t12 != 0.0, t13 * t17, 0.0), 0.0), 0.0), 0.0) + np.where(t28 != 0.0, np.where(t28 != 0.0, t29 * t33, 0.0), 0.0)
    t35 = -t34
    t36 = -(t18 + np.where(t28 != 0.0, np.where(t28 != 0.0, t31 * t33, 0.0), 0.0))
    t37 = 1.0 - np.where(t7 != 0.0, np.where(t12 != 0.0, np.where(t7 != 0.0, np.where(t12 != 0.0, t17 * t17, 0.0), 0.0), 0.0), 0.0) - np.where(t28 != 0.0, np.where(t28 != 0.0, t33 * t33, 0.0), 0.0)

    # results
    null_projector = np.empty((*leading, 9), real)
    null_projector[..., 0] = t30
    null_projector[..., 1] = t32
    null_projector[..., 2] = t35
    null_projector[..., 3] = t32
    null_projector[..., 4] = t16 - np.where(t28 != 0.0, np.where(t28 != 0.0, t31 * t31, 0.0), 0.0)
    null_projector[..., 5] = t36
    null_projector[..., 6] = t35
    null_projector[..., 7] = t36
    null_projector[..., 8] = t37
    return null_projector.reshape(leading + (3, 3))
