"""manipulability (pose) of planar_rpr, in NumPy.

Made from templates/kernel.py.j2; inputs 4fcb78b149cbfbd383ed1fce592dc846fb23a4be4aaeb9a8d013ae51b9937058.
118 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_pose(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the pose Jacobian: 19 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
    out  manipulability (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]

    # terms
    t1 = (cos_heading2 * c3 - sin_heading2 * s3) * l3
    t2 = l2 + q2
    t3 = cos_heading2 * t1 - cos_heading2 * (t1 + (l1 + cos_heading2 * t2)) - sin_heading2 * (sin_heading2 * t2)

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.abs(t3)
    return manipulability.reshape(leading)


def manipulability_gradient_pose(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in lexicographic order: 37 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]

    # terms
    t1 = (cos_heading2 * c3 - sin_heading2 * s3) * l3
    t2 = l2 + q2
    t3 = cos_heading2 * t1 - cos_heading2 * (t1 + (l1 + cos_heading2 * t2)) - sin_heading2 * (sin_heading2 * t2)
    t4 = np.abs(t3)
    t5 = t3 / t4
    t6 = sin_heading2 * (sin_heading2 * t5) + cos_heading2 * (cos_heading2 * t5)
    t7 = 1.0 / t4

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = t4
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t4 != 0.0, -t6, 0.0)
    gradient[..., 2] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t4 != 0.0, t6 * (t7 * t7), 0.0)
    inverse_gradient[..., 2] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t4 != 0.0, -(t6 * (-0.5 / t4 * np.sqrt(t7))), 0.0)
    inverse_root_gradient[..., 2] = 0.0
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_pose(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the pose Jacobian, columns in lexicographic order: 44 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]

    # terms
    t1 = (cos_heading2 * c3 - sin_heading2 * s3) * l3
    t2 = l2 + q2
    t3 = cos_heading2 * t1 - cos_heading2 * (t1 + (l1 + cos_heading2 * t2)) - sin_heading2 * (sin_heading2 * t2)
    t4 = t3 + t3
    t5 = l3 * (cos_heading2 * s3 + c3 * sin_heading2)
    t6 = cos_heading2 * t5 + cos_heading2 * (cos_heading2 - t5) + sin_heading2 * sin_heading2
    t7 = -t6 - t6

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = t3 * t3
    gradient[..., 0] = 0.0
    gradient[..., 1] = -(sin_heading2 * (sin_heading2 * t4) + cos_heading2 * (cos_heading2 * t4))
    gradient[..., 2] = 0.0
    hessian[..., 0] = 0.0
    hessian[..., 1] = 0.0
    hessian[..., 2] = 0.0
    hessian[..., 3] = 0.0
    hessian[..., 4] = -(sin_heading2 * (sin_heading2 * t7) + cos_heading2 * (cos_heading2 * t7))
    hessian[..., 5] = 0.0
    hessian[..., 6] = 0.0
    hessian[..., 7] = 0.0
    hessian[..., 8] = 0.0
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_pose(q, parameters):
    """maximal minors of the pose Jacobian, columns in lexicographic order: 18 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
    out  minors[1]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]

    # terms
    t1 = (cos_heading2 * c3 - sin_heading2 * s3) * l3
    t2 = l2 + q2
    t3 = cos_heading2 * t1 - cos_heading2 * (t1 + (l1 + cos_heading2 * t2)) - sin_heading2 * (sin_heading2 * t2)

    # results
    minors = np.empty((*leading, 1), real)
    minors[..., 0] = t3
    return minors.reshape(leading + (1,))
