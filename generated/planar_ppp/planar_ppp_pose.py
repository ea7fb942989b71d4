"""manipulability (pose) of planar_ppp, in NumPy.

Made from templates/kernel.py.j2; inputs e8de7972500fc2ac9db48b6896fe5887084ff24da5b5799e1f4b1aac4902d217.
0 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_pose(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the pose Jacobian: 0 operations.

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


def manipulability_gradient_pose(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in lexicographic order: 0 operations.

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


def manipulability_hessian_pose(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the pose Jacobian, columns in lexicographic order: 0 operations.

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


def minors_pose(q, parameters):
    """maximal minors of the pose Jacobian, columns in lexicographic order: 0 operations.

    in   q[3]
    in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
    out  minors[1]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines

    # terms

    # results
    minors = np.empty((*leading, 1), real)
    minors[..., 0] = 0.0
    return minors.reshape(leading + (1,))
