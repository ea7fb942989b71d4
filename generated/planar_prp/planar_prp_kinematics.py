"""kinematics of planar_prp, in NumPy.

Made from templates/kernel.py.j2; inputs e778a0d236fe4f69708dd80ffd322bfc9dde84eceaa5151ab8cf4193d1484fd5.
254 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def position(q, parameters):
    """position of the tip, in the base frame: 30 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  position[2]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    sin_heading1 = np.sin(heading1)
    s2 = np.sin(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = l1 + q1
    t2 = cos_heading1 * c2 - sin_heading1 * s2
    t3 = cos_heading1 * s2 + c2 * sin_heading1
    t4 = l3 + q3
    t5 = cos_heading1 * t1 + t2 * l2 + (t2 * cos_heading3 - t3 * sin_heading3) * t4
    t6 = t1 * sin_heading1 + l2 * t3 + t4 * (cos_heading3 * t3 + t2 * sin_heading3)

    # results
    position = np.empty((*_leading, 2), _real)
    position[..., 0] = t5
    position[..., 1] = t6
    return position.reshape(_leading + (2,))


def pose(q, parameters):
    """pose of the tip, in the base frame: 31 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  pose[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

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
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = cos_heading1 * c2 - sin_heading1 * s2
    t2 = cos_heading1 * s2 + c2 * sin_heading1
    t3 = cos_heading3 * t1 - t2 * sin_heading3
    t4 = cos_heading3 * t2 + t1 * sin_heading3
    t5 = l1 + q1
    t6 = l3 + q3

    # results
    pose = np.empty((*_leading, 9), _real)
    pose[..., 0] = t3
    pose[..., 1] = -t4
    pose[..., 2] = cos_heading1 * t5 + t1 * l2 + t3 * t6
    pose[..., 3] = t4
    pose[..., 4] = t3
    pose[..., 5] = sin_heading1 * t5 + t2 * l2 + t4 * t6
    pose[..., 6] = 0.0
    pose[..., 7] = 0.0
    pose[..., 8] = 1
    return pose.reshape(_leading + (3, 3))


def jacobian_position(q, parameters):
    """Jacobian of the position task, in the base frame: 33 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  jacobian[2][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    sin_heading1 = np.sin(heading1)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = l1 + q1
    t2 = sin_heading1 * t1
    t3 = cos_heading1 * s2 + sin_heading1 * c2
    t4 = cos_heading1 * c2 - sin_heading1 * s2
    t5 = t3 * cos_heading3 + t4 * sin_heading3
    t6 = l3 + q3
    t7 = cos_heading3 * t4 - t3 * sin_heading3
    t8 = cos_heading1 * t1

    # results
    jacobian = np.empty((*_leading, 6), _real)
    jacobian[..., 0] = cos_heading1
    jacobian[..., 1] = -(t2 + t3 * l2 + t5 * t6 - t2)
    jacobian[..., 2] = t7
    jacobian[..., 3] = sin_heading1
    jacobian[..., 4] = t8 + l2 * t4 + t6 * t7 - t8
    jacobian[..., 5] = t5
    return jacobian.reshape(_leading + (2, 3))


def jacobian_x_alpha(q, parameters):
    """Jacobian of the x_alpha task, in the base frame: 27 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  jacobian[2][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    sin_heading1 = np.sin(heading1)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = sin_heading1 * (l1 + q1)
    t2 = cos_heading1 * s2 + sin_heading1 * c2
    t3 = cos_heading1 * c2 - sin_heading1 * s2
    t4 = t1 + t2 * l2 + (t2 * cos_heading3 + t3 * sin_heading3) * (l3 + q3)

    # results
    jacobian = np.empty((*_leading, 6), _real)
    jacobian[..., 0] = cos_heading1
    jacobian[..., 1] = -(t4 - t1)
    jacobian[..., 2] = cos_heading3 * t3 - t2 * sin_heading3
    jacobian[..., 3] = 0.0
    jacobian[..., 4] = 1
    jacobian[..., 5] = 0.0
    return jacobian.reshape(_leading + (2, 3))


def jacobian_pose(q, parameters):
    """Jacobian of the pose task, in the base frame: 33 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  jacobian[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    sin_heading1 = np.sin(heading1)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = l1 + q1
    t2 = sin_heading1 * t1
    t3 = cos_heading1 * s2 + sin_heading1 * c2
    t4 = cos_heading1 * c2 - sin_heading1 * s2
    t5 = t3 * cos_heading3 + t4 * sin_heading3
    t6 = l3 + q3
    t7 = cos_heading3 * t4 - t3 * sin_heading3
    t8 = cos_heading1 * t1

    # results
    jacobian = np.empty((*_leading, 9), _real)
    jacobian[..., 0] = cos_heading1
    jacobian[..., 1] = -(t2 + t3 * l2 + t5 * t6 - t2)
    jacobian[..., 2] = t7
    jacobian[..., 3] = sin_heading1
    jacobian[..., 4] = t8 + l2 * t4 + t6 * t7 - t8
    jacobian[..., 5] = t5
    jacobian[..., 6] = 0.0
    jacobian[..., 7] = 1
    jacobian[..., 8] = 0.0
    return jacobian.reshape(_leading + (3, 3))


def kinematics_position(q, parameters):
    """position and the Jacobian of the position task: 33 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  position[2]
    out  jacobian[2][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    sin_heading1 = np.sin(heading1)
    s2 = np.sin(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = l1 + q1
    t2 = cos_heading1 * t1
    t3 = cos_heading1 * c2 - sin_heading1 * s2
    t4 = cos_heading1 * s2 + c2 * sin_heading1
    t5 = t3 * cos_heading3 - t4 * sin_heading3
    t6 = l3 + q3
    t7 = t2 + t3 * l2 + t5 * t6
    t8 = t1 * sin_heading1
    t9 = cos_heading3 * t4 + t3 * sin_heading3
    t10 = t8 + l2 * t4 + t6 * t9

    # results
    position = np.empty((*_leading, 2), _real)
    jacobian = np.empty((*_leading, 6), _real)
    position[..., 0] = t7
    position[..., 1] = t10
    jacobian[..., 0] = cos_heading1
    jacobian[..., 1] = -(t10 - t8)
    jacobian[..., 2] = t5
    jacobian[..., 3] = sin_heading1
    jacobian[..., 4] = t7 - t2
    jacobian[..., 5] = t9
    return position.reshape(_leading + (2,)), jacobian.reshape(_leading + (2, 3))


def kinematics_x_alpha(q, parameters):
    """pose and the Jacobian of the x_alpha task: 33 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  pose[3][3]
    out  jacobian[2][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

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
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = cos_heading1 * c2 - sin_heading1 * s2
    t2 = cos_heading1 * s2 + c2 * sin_heading1
    t3 = cos_heading3 * t1 - t2 * sin_heading3
    t4 = cos_heading3 * t2 + t1 * sin_heading3
    t5 = l1 + q1
    t6 = l3 + q3
    t7 = sin_heading1 * t5
    t8 = t7 + t2 * l2 + t4 * t6

    # results
    pose = np.empty((*_leading, 9), _real)
    jacobian = np.empty((*_leading, 6), _real)
    pose[..., 0] = t3
    pose[..., 1] = -t4
    pose[..., 2] = cos_heading1 * t5 + t1 * l2 + t3 * t6
    pose[..., 3] = t4
    pose[..., 4] = t3
    pose[..., 5] = t8
    pose[..., 6] = 0.0
    pose[..., 7] = 0.0
    pose[..., 8] = 1
    jacobian[..., 0] = cos_heading1
    jacobian[..., 1] = -(t8 - t7)
    jacobian[..., 2] = t3
    jacobian[..., 3] = 0.0
    jacobian[..., 4] = 1
    jacobian[..., 5] = 0.0
    return pose.reshape(_leading + (3, 3)), jacobian.reshape(_leading + (2, 3))


def kinematics_pose(q, parameters):
    """pose and the Jacobian of the pose task: 34 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    out  pose[3][3]
    out  jacobian[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

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
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = cos_heading1 * c2 - sin_heading1 * s2
    t2 = cos_heading1 * s2 + c2 * sin_heading1
    t3 = cos_heading3 * t1 - t2 * sin_heading3
    t4 = cos_heading3 * t2 + t1 * sin_heading3
    t5 = l1 + q1
    t6 = cos_heading1 * t5
    t7 = l3 + q3
    t8 = t6 + t1 * l2 + t3 * t7
    t9 = sin_heading1 * t5
    t10 = t9 + t2 * l2 + t4 * t7

    # results
    pose = np.empty((*_leading, 9), _real)
    jacobian = np.empty((*_leading, 9), _real)
    pose[..., 0] = t3
    pose[..., 1] = -t4
    pose[..., 2] = t8
    pose[..., 3] = t4
    pose[..., 4] = t3
    pose[..., 5] = t10
    pose[..., 6] = 0.0
    pose[..., 7] = 0.0
    pose[..., 8] = 1
    jacobian[..., 0] = cos_heading1
    jacobian[..., 1] = -(t10 - t9)
    jacobian[..., 2] = t3
    jacobian[..., 3] = sin_heading1
    jacobian[..., 4] = t8 - t6
    jacobian[..., 5] = t4
    jacobian[..., 6] = 0.0
    jacobian[..., 7] = 1
    jacobian[..., 8] = 0.0
    return pose.reshape(_leading + (3, 3)), jacobian.reshape(_leading + (3, 3))
