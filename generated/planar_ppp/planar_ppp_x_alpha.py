"""manipulability (x_alpha) of planar_ppp, in NumPy.

Made from templates/kernel.py.j2; inputs e8de7972500fc2ac9db48b6896fe5887084ff24da5b5799e1f4b1aac4902d217.
71 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_x_alpha(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the x_alpha Jacobian: 0 operations.

    in   q[3]
    in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
    out  manipulability (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines

    # terms

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = 0.0
    return manipulability.reshape(leading)


def manipulability_gradient_x_alpha(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the x_alpha Jacobian, columns in lexicographic order: 0 operations.

    in   q[3]
    in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
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

    # terms

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = 0.0
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
    """H^2, its gradient and its Hessian, through the maximal minors of the x_alpha Jacobian, columns in lexicographic order: 0 operations.

    in   q[3]
    in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
    out  square (one number)
    out  gradient[3]
    out  hessian[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines

    # terms

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = 0.0
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
    """maximal minors of the x_alpha Jacobian, columns in lexicographic order: 0 operations.

    in   q[3]
    in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
    out  minors[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines

    # terms

    # results
    minors = np.empty((*leading, 3), real)
    minors[..., 0] = 0.0
    minors[..., 1] = 0.0
    minors[..., 2] = 0.0
    return minors.reshape(leading + (3,))


def null_vector_x_alpha(q, parameters):
    """null vector of the x_alpha Jacobian from its signed minors, |N| = H: 0 operations.

    in   q[3]
    in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
    out  null_vector[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines

    # terms

    # results
    null_vector = np.empty((*leading, 3), real)
    null_vector[..., 0] = 0.0
    null_vector[..., 1] = 0.0
    null_vector[..., 2] = 0.0
    return null_vector.reshape(leading + (3,))


def null_projector_x_alpha(q, parameters):
    """projector I - J^+ J onto the null space of the x_alpha Jacobian: 71 operations.

    in   q[3]
    in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
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
    heading3 = parameters[..., 5]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)

    # terms
    t1 = cos_heading1 * cos_heading2 - sin_heading1 * sin_heading2
    t2 = t1 * cos_heading3 - (cos_heading1 * sin_heading2 + cos_heading2 * sin_heading1) * sin_heading3
    t3 = np.sqrt((cos_heading1 * cos_heading1 + t1 * t1 + t2 * t2))
    t4 = cos_heading1 / t3
    t5 = t1 / t3
    t6 = t2 / t3
    t7 = np.where(t3 != 0.0, np.where(t3 != 0.0, t4 * t4 + t5 * t5 + t6 * t6, 0.0), 0.0)
    t8 = np.sqrt(t7)
    t9 = t4 / t8
    t10 = t5 / t8
    t11 = -np.where(t3 != 0.0, np.where(t8 != 0.0, np.where(t3 != 0.0, np.where(t8 != 0.0, t9 * t10, 0.0), 0.0), 0.0), 0.0)
    t12 = t6 / t8
    t13 = -np.where(t3 != 0.0, np.where(t8 != 0.0, np.where(t3 != 0.0, np.where(t8 != 0.0, t9 * t12, 0.0), 0.0), 0.0), 0.0)
    t14 = -np.where(t3 != 0.0, np.where(t8 != 0.0, np.where(t3 != 0.0, np.where(t8 != 0.0, t10 * t12, 0.0), 0.0), 0.0), 0.0)

    # results
    null_projector = np.empty((*leading, 9), real)
    null_projector[..., 0] = 1.0 - np.where(t3 != 0.0, np.where(t8 != 0.0, np.where(t3 != 0.0, np.where(t8 != 0.0, t9 * t9, 0.0), 0.0), 0.0), 0.0)
    null_projector[..., 1] = t11
    null_projector[..., 2] = t13
    null_projector[..., 3] = t11
    null_projector[..., 4] = 1.0 - np.where(t3 != 0.0, np.where(t8 != 0.0, np.where(t3 != 0.0, np.where(t8 != 0.0, t10 * t10, 0.0), 0.0), 0.0), 0.0)
    null_projector[..., 5] = t14
    null_projector[..., 6] = t13
    null_projector[..., 7] = t14
    null_projector[..., 8] = 1.0 - np.where(t3 != 0.0, np.where(t8 != 0.0, np.where(t3 != 0.0, np.where(t8 != 0.0, t12 * t12, 0.0), 0.0), 0.0), 0.0)
    return null_projector.reshape(leading + (3, 3))
