"""manipulability (pose) of planar_prp, in NumPy.

Made from templates/kernel.py.j2; inputs 8faeb40d9c6642a7751b893456ee31cf9e47d22e5ca615f046e21e50f66d5563.
68 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_pose(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the pose Jacobian: 8 operations.

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

    # terms

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.abs((c2 * sin_heading3 + cos_heading3 * s2))
    return manipulability.reshape(leading)


def manipulability_gradient_pose(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in lexicographic order: 25 operations.

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
    q2 = q[..., 1]
    c2 = np.cos(q2)
    heading3 = parameters[..., 4]
    sin_heading3 = np.sin(heading3)
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)

    # terms
    t1 = c2 * sin_heading3 + cos_heading3 * s2
    t2 = np.abs(t1)
    t3 = t1 / t2
    t4 = c2 * (cos_heading3 * t3) - s2 * (sin_heading3 * t3)
    t5 = 1.0 / t2

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = t2
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t2 != 0.0, t4, 0.0)
    gradient[..., 2] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t2 != 0.0, -(t4 * (t5 * t5)), 0.0)
    inverse_gradient[..., 2] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t2 != 0.0, t4 * (-0.5 / t2 * np.sqrt(t5)), 0.0)
    inverse_root_gradient[..., 2] = 0.0
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_pose(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the pose Jacobian, columns in lexicographic order: 27 operations.

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
    q2 = q[..., 1]
    c2 = np.cos(q2)
    heading3 = parameters[..., 4]
    sin_heading3 = np.sin(heading3)
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)

    # terms
    t1 = c2 * sin_heading3 + cos_heading3 * s2
    t2 = t1 + t1
    t3 = cos_heading3 * t2
    t4 = sin_heading3 * t2
    t5 = c2 * cos_heading3 - sin_heading3 * s2
    t6 = t5 + t5
    t7 = c2 * (cos_heading3 * t6) - s2 * t3 - (c2 * t4 + s2 * (sin_heading3 * t6))

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = t1 * t1
    gradient[..., 0] = 0.0
    gradient[..., 1] = c2 * t3 - s2 * t4
    gradient[..., 2] = 0.0
    hessian[..., 0] = 0.0
    hessian[..., 1] = 0.0
    hessian[..., 2] = 0.0
    hessian[..., 3] = 0.0
    hessian[..., 4] = t7
    hessian[..., 5] = 0.0
    hessian[..., 6] = 0.0
    hessian[..., 7] = 0.0
    hessian[..., 8] = 0.0
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_pose(q, parameters):
    """maximal minors of the pose Jacobian, columns in lexicographic order: 8 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  minors[1]
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

    # terms

    # results
    minors = np.empty((*leading, 1), real)
    minors[..., 0] = -(c2 * sin_heading3 + cos_heading3 * s2)
    return minors.reshape(leading + (1,))
