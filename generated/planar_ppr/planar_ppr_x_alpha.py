"""manipulability (x_alpha) of planar_ppr, in NumPy.

Made from templates/kernel.py.j2; inputs e3929abbec5b8cc1e390d2c1acf8188eb58b4f4fe88268b9b7a88b27a42db7ae.
190 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_x_alpha(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the x_alpha Jacobian: 11 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
    out  manipulability (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    heading2 = parameters[..., 4]
    cos_heading2 = np.cos(heading2)
    sin_heading1 = np.sin(heading1)
    sin_heading2 = np.sin(heading2)

    # terms
    t1 = cos_heading1 * cos_heading2 - sin_heading1 * sin_heading2

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.sqrt((cos_heading1 * cos_heading1 + t1 * t1))
    return manipulability.reshape(leading)


def manipulability_gradient_x_alpha(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the x_alpha Jacobian, columns in lexicographic order: 11 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
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
    heading2 = parameters[..., 4]
    cos_heading2 = np.cos(heading2)
    sin_heading1 = np.sin(heading1)
    sin_heading2 = np.sin(heading2)

    # terms
    t1 = cos_heading1 * cos_heading2 - sin_heading1 * sin_heading2

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = np.sqrt((cos_heading1 * cos_heading1 + t1 * t1))
    gradient[..., 0] = 0.0
    gradient[..., 1] = 0.0
    gradient[..., 2] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = 0.0
    inverse_gradient[..., 2] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = 0.0
    inverse_root_gradient[..., 2] = 0.0
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_x_alpha(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the x_alpha Jacobian, columns in lexicographic order: 10 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
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
    heading2 = parameters[..., 4]
    cos_heading2 = np.cos(heading2)
    sin_heading1 = np.sin(heading1)
    sin_heading2 = np.sin(heading2)

    # terms
    t1 = cos_heading1 * cos_heading2 - sin_heading1 * sin_heading2

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = cos_heading1 * cos_heading1 + t1 * t1
    gradient[..., 0] = 0.0
    gradient[..., 1] = 0.0
    gradient[..., 2] = 0.0
    hessian[..., 0] = 0.0
    hessian[..., 1] = 0.0
    hessian[..., 2] = 0.0
    hessian[..., 3] = 0.0
    hessian[..., 4] = 0.0
    hessian[..., 5] = 0.0
    hessian[..., 6] = 0.0
    hessian[..., 7] = 0.0
    hessian[..., 8] = 0.0
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_x_alpha(q, parameters):
    """maximal minors of the x_alpha Jacobian, columns in lexicographic order: 7 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
    out  minors[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    heading2 = parameters[..., 4]
    cos_heading2 = np.cos(heading2)
    sin_heading1 = np.sin(heading1)
    sin_heading2 = np.sin(heading2)

    # terms

    # results
    minors = np.empty((*leading, 3), real)
    minors[..., 0] = 0.0
    minors[..., 1] = cos_heading1
    minors[..., 2] = cos_heading1 * cos_heading2 - sin_heading1 * sin_heading2
    return minors.reshape(leading + (3,))


def null_vector_x_alpha(q, parameters):
    """null vector of the x_alpha Jacobian from its signed minors, |N| = H: 8 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
    out  null_vector[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    heading2 = parameters[..., 4]
    cos_heading2 = np.cos(heading2)
    sin_heading1 = np.sin(heading1)
    sin_heading2 = np.sin(heading2)

    # terms

    # results
    null_vector = np.empty((*leading, 3), real)
    null_vector[..., 0] = cos_heading1 * cos_heading2 - sin_heading1 * sin_heading2
    null_vector[..., 1] = -cos_heading1
    null_vector[..., 2] = 0.0
    return null_vector.reshape(leading + (3,))


def null_projector_x_alpha(q, parameters):
    """projector I - J^+ J onto the null space of the x_alpha Jacobian: 143 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
    out  null_projector[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    heading2 = parameters[..., 4]
    cos_heading2 = np.cos(heading2)
    sin_heading1 = np.sin(heading1)
    sin_heading2 = np.sin(heading2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = cos_heading1 * cos_heading2 - sin_heading1 * sin_heading2
    t2 = (c3 * (cos_heading1 * sin_heading2 + cos_heading2 * sin_heading1) + t1 * s3) * l3
    t3 = np.sqrt((cos_heading1 * cos_heading1 + t1 * t1 + t2 * t2))
    t4 = cos_heading1 / t3
    t5 = t1 / t3
    t6 = np.where(t3 != 0.0, t2 / t3, 0.0)
    t7 = np.where(t3 != 0.0, np.where(t3 != 0.0, t4 * t4 + t5 * t5, 0.0), 0.0) + t6 * t6
    t8 = np.sqrt(t7)
    t9 = t4 / t8
    t10 = t6 / t8
    t11 = np.where(t8 != 0.0, np.where(t3 != 0.0, np.where(t8 != 0.0, -(t9 * t10), 0.0), 0.0), 0.0)
    t12 = t5 / t8
    t13 = np.where(t8 != 0.0, np.where(t3 != 0.0, np.where(t8 != 0.0, -(t10 * t12), 0.0), 0.0), 0.0)
    t14 = 1.0 - np.where(t8 != 0.0, np.where(t8 != 0.0, t10 * t10, 0.0), 0.0)
    t15 = np.sqrt((t11 * t11 + t13 * t13 + t14 * t14))
    t16 = t11 / t15
    t17 = t13 / t15
    t18 = t14 / t15
    t19 = np.where(t3 != 0.0, np.where(t8 != 0.0, -(t9 * t16 + t12 * t17), 0.0), 0.0) + np.where(t8 != 0.0, -(t10 * t18), 0.0)
    t20 = np.where(t15 != 0.0, -t16, 0.0) - np.where(t3 != 0.0, np.where(t8 != 0.0, np.where(t15 != 0.0, t9 * t19, 0.0), 0.0), 0.0)
    t21 = np.where(t15 != 0.0, -t17, 0.0) - np.where(t3 != 0.0, np.where(t8 != 0.0, np.where(t15 != 0.0, t12 * t19, 0.0), 0.0), 0.0)
    t22 = np.where(t15 != 0.0, t18, 0.0) - np.where(t8 != 0.0, np.where(t15 != 0.0, -(t10 * t19), 0.0), 0.0)
    t23 = np.sqrt((t20 * t20 + t21 * t21 + t22 * t22))
    t24 = t20 / t23
    t25 = 1.0 - np.where(t3 != 0.0, np.where(t8 != 0.0, np.where(t3 != 0.0, np.where(t8 != 0.0, t9 * t9, 0.0), 0.0), 0.0), 0.0) - np.where(t23 != 0.0, np.where(t23 != 0.0, t24 * t24, 0.0), 0.0)
    t26 = t21 / t23
    t27 = np.where(t3 != 0.0, np.where(t8 != 0.0, np.where(t3 != 0.0, np.where(t8 != 0.0, t9 * t12, 0.0), 0.0), 0.0), 0.0) + np.where(t23 != 0.0, np.where(t23 != 0.0, t24 * t26, 0.0), 0.0)
    t28 = -t27
    t29 = t22 / t23
    t30 = -(t11 + np.where(t23 != 0.0, np.where(t23 != 0.0, t24 * t29, 0.0), 0.0))
    t31 = 1.0 - np.where(t3 != 0.0, np.where(t8 != 0.0, np.where(t3 != 0.0, np.where(t8 != 0.0, t12 * t12, 0.0), 0.0), 0.0), 0.0) - np.where(t23 != 0.0, np.where(t23 != 0.0, t26 * t26, 0.0), 0.0)
    t32 = -(t13 + np.where(t23 != 0.0, np.where(t23 != 0.0, t26 * t29, 0.0), 0.0))

    # results
    null_projector = np.empty((*leading, 9), real)
    null_projector[..., 0] = t25
    null_projector[..., 1] = t28
    null_projector[..., 2] = t30
    null_projector[..., 3] = t28
    null_projector[..., 4] = t31
    null_projector[..., 5] = t32
    null_projector[..., 6] = t30
    null_projector[..., 7] = t32
    null_projector[..., 8] = t14 - np.where(t23 != 0.0, np.where(t23 != 0.0, t29 * t29, 0.0), 0.0)
    return null_projector.reshape(leading + (3, 3))
