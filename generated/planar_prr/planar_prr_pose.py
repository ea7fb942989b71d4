"""manipulability (pose) of planar_prr, in NumPy.

Made from templates/kernel.py.j2; inputs f7751c7cae58eb7884348987627a3ed0ab2d2451fe63dcf71fb85cecfbd612a9.
94 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_pose(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the pose Jacobian: 15 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
    out  manipulability (one number)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l1 + q1
    t2 = (c2 * c3 - s2 * s3) * l3

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.abs((t1 + c2 * l2 + t2 - t1 - t2))
    return manipulability.reshape(leading)


def manipulability_gradient_pose(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in lexicographic order: 30 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l1 + q1
    t2 = (c2 * c3 - s2 * s3) * l3
    t3 = t1 + c2 * l2 + t2 - t1 - t2
    t4 = np.abs(t3)
    t5 = s2 * (l2 * (t3 / t4))
    t6 = 1.0 / t4

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = t4
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t4 != 0.0, -t5, 0.0)
    gradient[..., 2] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t4 != 0.0, t5 * (t6 * t6), 0.0)
    inverse_gradient[..., 2] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t4 != 0.0, -(t5 * (-0.5 / t4 * np.sqrt(t6))), 0.0)
    inverse_root_gradient[..., 2] = 0.0
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_pose(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the pose Jacobian, columns in lexicographic order: 35 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l1 + q1
    t2 = (c2 * c3 - s2 * s3) * l3
    t3 = t1 + c2 * l2 + t2 - t1 - t2
    t4 = l2 * (t3 + t3)
    t5 = c3 * s2 + c2 * s3
    t6 = l3 * (t5 + t5)
    t7 = t6 + (-1.0 + (1.0 - l2 * s2 - t6))

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = t3 * t3
    gradient[..., 0] = 0.0
    gradient[..., 1] = -(s2 * t4)
    gradient[..., 2] = 0.0
    hessian[..., 0] = 0.0
    hessian[..., 1] = 0.0
    hessian[..., 2] = 0.0
    hessian[..., 3] = 0.0
    hessian[..., 4] = -(c2 * t4 + s2 * (l2 * (t7 + t7)))
    hessian[..., 5] = 0.0
    hessian[..., 6] = 0.0
    hessian[..., 7] = 0.0
    hessian[..., 8] = 0.0
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_pose(q, parameters):
    """maximal minors of the pose Jacobian, columns in lexicographic order: 14 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
    out  minors[1]
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l1 + q1
    t2 = (c2 * c3 - s2 * s3) * l3

    # results
    minors = np.empty((*leading, 1), real)
    minors[..., 0] = t1 + c2 * l2 + t2 - t1 - t2
    return minors.reshape(leading + (1,))
