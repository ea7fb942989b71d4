"""manipulability (pose) of planar_rpp, in NumPy.

Made from templates/kernel.py.j2; inputs 2c4b7f604c2520d4429cf7db48c2bb6981ca2a4fd070aa2a796b28fdad172f86.
55 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_pose(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the pose Jacobian: 14 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
    out  manipulability (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    heading3 = parameters[..., 4]
    sin_heading3 = np.sin(heading3)
    cos_heading3 = np.cos(heading3)
    sin_heading2 = np.sin(heading2)

    # terms
    t1 = cos_heading2 * (cos_heading2 * sin_heading3 + cos_heading3 * sin_heading2) - sin_heading2 * (cos_heading2 * cos_heading3 - sin_heading3 * sin_heading2)

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.abs(t1)
    return manipulability.reshape(leading)


def manipulability_gradient_pose(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in lexicographic order: 14 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
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
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    heading3 = parameters[..., 4]
    sin_heading3 = np.sin(heading3)
    cos_heading3 = np.cos(heading3)
    sin_heading2 = np.sin(heading2)

    # terms
    t1 = cos_heading2 * (cos_heading2 * sin_heading3 + cos_heading3 * sin_heading2) - sin_heading2 * (cos_heading2 * cos_heading3 - sin_heading3 * sin_heading2)

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = np.abs(t1)
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


def manipulability_hessian_pose(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the pose Jacobian, columns in lexicographic order: 14 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
    out  square (one number)
    out  gradient[3]
    out  hessian[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    heading3 = parameters[..., 4]
    sin_heading3 = np.sin(heading3)
    cos_heading3 = np.cos(heading3)
    sin_heading2 = np.sin(heading2)

    # terms
    t1 = cos_heading2 * (cos_heading2 * sin_heading3 + cos_heading3 * sin_heading2) - sin_heading2 * (cos_heading2 * cos_heading3 - sin_heading3 * sin_heading2)

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = t1 * t1
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


def minors_pose(q, parameters):
    """maximal minors of the pose Jacobian, columns in lexicographic order: 13 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
    out  minors[1]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    heading3 = parameters[..., 4]
    sin_heading3 = np.sin(heading3)
    cos_heading3 = np.cos(heading3)
    sin_heading2 = np.sin(heading2)

    # terms
    t1 = cos_heading2 * (cos_heading2 * sin_heading3 + cos_heading3 * sin_heading2) - sin_heading2 * (cos_heading2 * cos_heading3 - sin_heading3 * sin_heading2)

    # results
    minors = np.empty((*leading, 1), real)
    minors[..., 0] = t1
    return minors.reshape(leading + (1,))
