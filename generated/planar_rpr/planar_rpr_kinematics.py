"""kinematics of planar_rpr, in NumPy.

Made from templates/kernel.py.j2; inputs 9d6112ab29294fae694127dde152f0e87b3d761327100ba186f357511b22bf98.
239 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def position(q, parameters):
    """position of the tip, in the base frame: 29 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
    out  position[2]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    l1 = parameters[..., 0]
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    s1 = np.sin(q1)
    sin_heading2 = np.sin(heading2)
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = l2 + q2
    t3 = c1 * sin_heading2 + cos_heading2 * s1
    t4 = c1 * l1 + t1 * t2 + (t1 * c3 - t3 * s3) * l3
    t5 = l1 * s1 + t2 * t3 + l3 * (c3 * t3 + t1 * s3)

    # results
    position = np.empty((*_leading, 2), _real)
    position[..., 0] = t4
    position[..., 1] = t5
    return position.reshape(_leading + (2,))


def pose(q, parameters):
    """pose of the tip, in the base frame: 30 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
    out  pose[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q1 = q[..., 0]
    c1 = np.cos(q1)
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    s1 = np.sin(q1)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    l3 = parameters[..., 2]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = c1 * sin_heading2 + cos_heading2 * s1
    t3 = c3 * t1 - t2 * s3
    t4 = c3 * t2 + t1 * s3
    t5 = l2 + q2

    # results
    pose = np.empty((*_leading, 9), _real)
    pose[..., 0] = t3
    pose[..., 1] = -t4
    pose[..., 2] = c1 * l1 + t1 * t5 + t3 * l3
    pose[..., 3] = t4
    pose[..., 4] = t3
    pose[..., 5] = s1 * l1 + t2 * t5 + t4 * l3
    pose[..., 6] = 0.0
    pose[..., 7] = 0.0
    pose[..., 8] = 1
    return pose.reshape(_leading + (3, 3))


def jacobian_position(q, parameters):
    """Jacobian of the position task, in the base frame: 31 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
    out  jacobian[2][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    heading2 = parameters[..., 3]
    sin_heading2 = np.sin(heading2)
    cos_heading2 = np.cos(heading2)
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = c1 * sin_heading2 + s1 * cos_heading2
    t2 = l2 + q2
    t3 = c1 * cos_heading2 - s1 * sin_heading2
    t4 = (t1 * c3 + t3 * s3) * l3
    t5 = l3 * (c3 * t3 - t1 * s3)

    # results
    jacobian = np.empty((*_leading, 6), _real)
    jacobian[..., 0] = -(l1 * s1 + t1 * t2 + t4)
    jacobian[..., 1] = t3
    jacobian[..., 2] = -t4
    jacobian[..., 3] = l1 * c1 + t2 * t3 + t5
    jacobian[..., 4] = t1
    jacobian[..., 5] = t5
    return jacobian.reshape(_leading + (2, 3))


def jacobian_x_alpha(q, parameters):
    """Jacobian of the x_alpha task, in the base frame: 23 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
    out  jacobian[2][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    heading2 = parameters[..., 3]
    sin_heading2 = np.sin(heading2)
    cos_heading2 = np.cos(heading2)
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = c1 * sin_heading2 + s1 * cos_heading2
    t2 = c1 * cos_heading2 - s1 * sin_heading2
    t3 = (t1 * c3 + t2 * s3) * l3

    # results
    jacobian = np.empty((*_leading, 6), _real)
    jacobian[..., 0] = -(l1 * s1 + t1 * (l2 + q2) + t3)
    jacobian[..., 1] = t2
    jacobian[..., 2] = -t3
    jacobian[..., 3] = 1
    jacobian[..., 4] = 0.0
    jacobian[..., 5] = 1
    return jacobian.reshape(_leading + (2, 3))


def jacobian_pose(q, parameters):
    """Jacobian of the pose task, in the base frame: 31 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
    out  jacobian[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    heading2 = parameters[..., 3]
    sin_heading2 = np.sin(heading2)
    cos_heading2 = np.cos(heading2)
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = c1 * sin_heading2 + s1 * cos_heading2
    t2 = l2 + q2
    t3 = c1 * cos_heading2 - s1 * sin_heading2
    t4 = (t1 * c3 + t3 * s3) * l3
    t5 = l3 * (c3 * t3 - t1 * s3)

    # results
    jacobian = np.empty((*_leading, 9), _real)
    jacobian[..., 0] = -(l1 * s1 + t1 * t2 + t4)
    jacobian[..., 1] = t3
    jacobian[..., 2] = -t4
    jacobian[..., 3] = l1 * c1 + t2 * t3 + t5
    jacobian[..., 4] = t1
    jacobian[..., 5] = t5
    jacobian[..., 6] = 1
    jacobian[..., 7] = 0.0
    jacobian[..., 8] = 1
    return jacobian.reshape(_leading + (3, 3))


def kinematics_position(q, parameters):
    """position and the Jacobian of the position task: 31 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
    out  position[2]
    out  jacobian[2][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    l1 = parameters[..., 0]
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    s1 = np.sin(q1)
    sin_heading2 = np.sin(heading2)
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = l2 + q2
    t3 = c1 * sin_heading2 + cos_heading2 * s1
    t4 = (t1 * c3 - t3 * s3) * l3
    t5 = c1 * l1 + t1 * t2 + t4
    t6 = l3 * (c3 * t3 + t1 * s3)
    t7 = l1 * s1 + t2 * t3 + t6

    # results
    position = np.empty((*_leading, 2), _real)
    jacobian = np.empty((*_leading, 6), _real)
    position[..., 0] = t5
    position[..., 1] = t7
    jacobian[..., 0] = -t7
    jacobian[..., 1] = t1
    jacobian[..., 2] = -t6
    jacobian[..., 3] = t5
    jacobian[..., 4] = t3
    jacobian[..., 5] = t4
    return position.reshape(_leading + (2,)), jacobian.reshape(_leading + (2, 3))


def kinematics_x_alpha(q, parameters):
    """pose and the Jacobian of the x_alpha task: 32 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
    out  pose[3][3]
    out  jacobian[2][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q1 = q[..., 0]
    c1 = np.cos(q1)
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    s1 = np.sin(q1)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    l3 = parameters[..., 2]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = c1 * sin_heading2 + cos_heading2 * s1
    t3 = c3 * t1 - t2 * s3
    t4 = c3 * t2 + t1 * s3
    t5 = l2 + q2
    t6 = t4 * l3
    t7 = s1 * l1 + t2 * t5 + t6

    # results
    pose = np.empty((*_leading, 9), _real)
    jacobian = np.empty((*_leading, 6), _real)
    pose[..., 0] = t3
    pose[..., 1] = -t4
    pose[..., 2] = c1 * l1 + t1 * t5 + t3 * l3
    pose[..., 3] = t4
    pose[..., 4] = t3
    pose[..., 5] = t7
    pose[..., 6] = 0.0
    pose[..., 7] = 0.0
    pose[..., 8] = 1
    jacobian[..., 0] = -t7
    jacobian[..., 1] = t1
    jacobian[..., 2] = -t6
    jacobian[..., 3] = 1
    jacobian[..., 4] = 0.0
    jacobian[..., 5] = 1
    return pose.reshape(_leading + (3, 3)), jacobian.reshape(_leading + (2, 3))


def kinematics_pose(q, parameters):
    """pose and the Jacobian of the pose task: 32 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
    out  pose[3][3]
    out  jacobian[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q1 = q[..., 0]
    c1 = np.cos(q1)
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    s1 = np.sin(q1)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    l3 = parameters[..., 2]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = c1 * sin_heading2 + cos_heading2 * s1
    t3 = c3 * t1 - t2 * s3
    t4 = c3 * t2 + t1 * s3
    t5 = l2 + q2
    t6 = t3 * l3
    t7 = c1 * l1 + t1 * t5 + t6
    t8 = t4 * l3
    t9 = s1 * l1 + t2 * t5 + t8

    # results
    pose = np.empty((*_leading, 9), _real)
    jacobian = np.empty((*_leading, 9), _real)
    pose[..., 0] = t3
    pose[..., 1] = -t4
    pose[..., 2] = t7
    pose[..., 3] = t4
    pose[..., 4] = t3
    pose[..., 5] = t9
    pose[..., 6] = 0.0
    pose[..., 7] = 0.0
    pose[..., 8] = 1
    jacobian[..., 0] = -t9
    jacobian[..., 1] = t1
    jacobian[..., 2] = -t8
    jacobian[..., 3] = t7
    jacobian[..., 4] = t2
    jacobian[..., 5] = t6
    jacobian[..., 6] = 1
    jacobian[..., 7] = 0.0
    jacobian[..., 8] = 1
    return pose.reshape(_leading + (3, 3)), jacobian.reshape(_leading + (3, 3))
