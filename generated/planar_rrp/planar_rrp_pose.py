"""manipulability (pose) of planar_rrp, in NumPy.

Made from templates/kernel.py.j2; inputs 344b4b168ed342733b5f1410e172a4a80bf5e563dd5ee354ff76601a21772d4c.
128 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_pose(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the pose Jacobian: 17 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
    out  manipulability (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = c2 * cos_heading3 - s2 * sin_heading3
    t2 = l1 + c2 * l2 + t1 * (l3 + q3)

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.abs((t1 * t2 - t1 * (t2 - l1)))
    return manipulability.reshape(leading)


def manipulability_gradient_pose(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in lexicographic order: 38 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
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
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = c2 * cos_heading3 - s2 * sin_heading3
    t2 = l1 + c2 * l2 + t1 * (l3 + q3)
    t3 = t2 - l1
    t4 = t1 * t2 - t1 * t3
    t5 = np.abs(t4)
    t6 = t4 / t5
    t7 = t2 * t6 - t3 * t6
    t8 = c2 * (sin_heading3 * t7) + s2 * (cos_heading3 * t7)
    t9 = 1.0 / t5

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = t5
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t5 != 0.0, -t8, 0.0)
    gradient[..., 2] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t5 != 0.0, t8 * (t9 * t9), 0.0)
    inverse_gradient[..., 2] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t5 != 0.0, -(t8 * (-0.5 / t5 * np.sqrt(t9))), 0.0)
    inverse_root_gradient[..., 2] = 0.0
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_pose(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the pose Jacobian, columns in lexicographic order: 57 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
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
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = c2 * cos_heading3 - s2 * sin_heading3
    t2 = l3 + q3
    t3 = l1 + c2 * l2 + t1 * t2
    t4 = t3 - l1
    t5 = t1 * t3 - t1 * t4
    t6 = t5 + t5
    t7 = t3 * t6 - t4 * t6
    t8 = sin_heading3 * t7
    t9 = cos_heading3 * t7
    t10 = cos_heading3 * s2 + c2 * sin_heading3
    t11 = t1 - t2 * t10 - s2 * l2
    t12 = t6 * t11
    t13 = t1 * t11
    t14 = t13 - t3 * t10 - (t13 - t4 * t10)
    t15 = t14 + t14
    t16 = t12 + t3 * t15 - (t12 + t4 * t15)
    t17 = c2 * (sin_heading3 * t16) - s2 * t8 + (c2 * t9 + s2 * (cos_heading3 * t16))

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = t5 * t5
    gradient[..., 0] = 0.0
    gradient[..., 1] = -(c2 * t8 + s2 * t9)
    gradient[..., 2] = 0.0
    hessian[..., 0] = 0.0
    hessian[..., 1] = 0.0
    hessian[..., 2] = 0.0
    hessian[..., 3] = 0.0
    hessian[..., 4] = -t17
    hessian[..., 5] = 0.0
    hessian[..., 6] = 0.0
    hessian[..., 7] = 0.0
    hessian[..., 8] = 0.0
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_pose(q, parameters):
    """maximal minors of the pose Jacobian, columns in lexicographic order: 16 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
    out  minors[1]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = c2 * cos_heading3 - s2 * sin_heading3
    t2 = l1 + c2 * l2 + t1 * (l3 + q3)

    # results
    minors = np.empty((*leading, 1), real)
    minors[..., 0] = t1 * t2 - t1 * (t2 - l1)
    return minors.reshape(leading + (1,))
