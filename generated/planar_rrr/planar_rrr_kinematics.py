"""kinematics of planar_rrr, in NumPy.

Made from templates/kernel.py.j2; inputs 2015c547c4b653d0a768ae988d6c31027bb4c3d4b095f6dfe5de0b9130c064d2.
337 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def position(q, parameters):
    """position of the tip, in the base frame: 28 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
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
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = c1 * c2 - s1 * s2
    t2 = c1 * s2 + c2 * s1
    t3 = c1 * l1 + t1 * l2 + (t1 * c3 - t2 * s3) * l3
    t4 = l1 * s1 + l2 * t2 + l3 * (c3 * t2 + t1 * s3)

    # results
    position = np.empty((*_leading, 2), _real)
    position[..., 0] = t3
    position[..., 1] = t4
    return position.reshape(_leading + (2,))


def pose(q, parameters):
    """pose of the tip, in the base frame: 29 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
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
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]

    # terms
    t1 = c1 * c2 - s1 * s2
    t2 = c1 * s2 + c2 * s1
    t3 = c3 * t1 - t2 * s3
    t4 = c3 * t2 + t1 * s3

    # results
    pose = np.empty((*_leading, 9), _real)
    pose[..., 0] = t3
    pose[..., 1] = -t4
    pose[..., 2] = c1 * l1 + t1 * l2 + t3 * l3
    pose[..., 3] = t4
    pose[..., 4] = t3
    pose[..., 5] = s1 * l1 + t2 * l2 + t4 * l3
    pose[..., 6] = 0.0
    pose[..., 7] = 0.0
    pose[..., 8] = 1
    return pose.reshape(_leading + (3, 3))


def jacobian_position(q, parameters):
    """Jacobian of the position task, in the base frame: 33 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
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
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l1 * s1
    t2 = c1 * s2 + s1 * c2
    t3 = c1 * c2 - s1 * s2
    t4 = (t2 * c3 + t3 * s3) * l3
    t5 = t1 + t2 * l2 + t4
    t6 = l1 * c1
    t7 = l3 * (c3 * t3 - t2 * s3)
    t8 = t6 + l2 * t3 + t7

    # results
    jacobian = np.empty((*_leading, 6), _real)
    jacobian[..., 0] = -t5
    jacobian[..., 1] = -(t5 - t1)
    jacobian[..., 2] = -t4
    jacobian[..., 3] = t8
    jacobian[..., 4] = t8 - t6
    jacobian[..., 5] = t7
    return jacobian.reshape(_leading + (2, 3))


def jacobian_x_alpha(q, parameters):
    """Jacobian of the x_alpha task, in the base frame: 24 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
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
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l1 * s1
    t2 = c1 * s2 + s1 * c2
    t3 = (t2 * c3 + (c1 * c2 - s1 * s2) * s3) * l3
    t4 = t1 + t2 * l2 + t3

    # results
    jacobian = np.empty((*_leading, 6), _real)
    jacobian[..., 0] = -t4
    jacobian[..., 1] = -(t4 - t1)
    jacobian[..., 2] = -t3
    jacobian[..., 3] = 1
    jacobian[..., 4] = 1
    jacobian[..., 5] = 1
    return jacobian.reshape(_leading + (2, 3))


def jacobian_pose(q, parameters):
    """Jacobian of the pose task, in the base frame: 33 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
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
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l1 * s1
    t2 = c1 * s2 + s1 * c2
    t3 = c1 * c2 - s1 * s2
    t4 = (t2 * c3 + t3 * s3) * l3
    t5 = t1 + t2 * l2 + t4
    t6 = l1 * c1
    t7 = l3 * (c3 * t3 - t2 * s3)
    t8 = t6 + l2 * t3 + t7

    # results
    jacobian = np.empty((*_leading, 9), _real)
    jacobian[..., 0] = -t5
    jacobian[..., 1] = -(t5 - t1)
    jacobian[..., 2] = -t4
    jacobian[..., 3] = t8
    jacobian[..., 4] = t8 - t6
    jacobian[..., 5] = t7
    jacobian[..., 6] = 1
    jacobian[..., 7] = 1
    jacobian[..., 8] = 1
    return jacobian.reshape(_leading + (3, 3))


def kinematics_position(q, parameters):
    """position and the Jacobian of the position task: 33 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
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
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = c1 * l1
    t2 = c1 * c2 - s1 * s2
    t3 = c1 * s2 + c2 * s1
    t4 = (t2 * c3 - t3 * s3) * l3
    t5 = t1 + t2 * l2 + t4
    t6 = l1 * s1
    t7 = l3 * (c3 * t3 + t2 * s3)
    t8 = t6 + l2 * t3 + t7

    # results
    position = np.empty((*_leading, 2), _real)
    jacobian = np.empty((*_leading, 6), _real)
    position[..., 0] = t5
    position[..., 1] = t8
    jacobian[..., 0] = -t8
    jacobian[..., 1] = -(t8 - t6)
    jacobian[..., 2] = -t7
    jacobian[..., 3] = t5
    jacobian[..., 4] = t5 - t1
    jacobian[..., 5] = t4
    return position.reshape(_leading + (2,)), jacobian.reshape(_leading + (2, 3))


def kinematics_x_alpha(q, parameters):
    """pose and the Jacobian of the x_alpha task: 33 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
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
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]

    # terms
    t1 = c1 * c2 - s1 * s2
    t2 = c1 * s2 + c2 * s1
    t3 = c3 * t1 - t2 * s3
    t4 = c3 * t2 + t1 * s3
    t5 = s1 * l1
    t6 = t4 * l3
    t7 = t5 + t2 * l2 + t6

    # results
    pose = np.empty((*_leading, 9), _real)
    jacobian = np.empty((*_leading, 6), _real)
    pose[..., 0] = t3
    pose[..., 1] = -t4
    pose[..., 2] = c1 * l1 + t1 * l2 + t3 * l3
    pose[..., 3] = t4
    pose[..., 4] = t3
    pose[..., 5] = t7
    pose[..., 6] = 0.0
    pose[..., 7] = 0.0
    pose[..., 8] = 1
    jacobian[..., 0] = -t7
    jacobian[..., 1] = -(t7 - t5)
    jacobian[..., 2] = -t6
    jacobian[..., 3] = 1
    jacobian[..., 4] = 1
    jacobian[..., 5] = 1
    return pose.reshape(_leading + (3, 3)), jacobian.reshape(_leading + (2, 3))


def kinematics_pose(q, parameters):
    """pose and the Jacobian of the pose task: 34 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
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
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]

    # terms
    t1 = c1 * c2 - s1 * s2
    t2 = c1 * s2 + c2 * s1
    t3 = c3 * t1 - t2 * s3
    t4 = c3 * t2 + t1 * s3
    t5 = c1 * l1
    t6 = t3 * l3
    t7 = t5 + t1 * l2 + t6
    t8 = s1 * l1
    t9 = t4 * l3
    t10 = t8 + t2 * l2 + t9

    # results
    pose = np.empty((*_leading, 9), _real)
    jacobian = np.empty((*_leading, 9), _real)
    pose[..., 0] = t3
    pose[..., 1] = -t4
    pose[..., 2] = t7
    pose[..., 3] = t4
    pose[..., 4] = t3
    pose[..., 5] = t10
    pose[..., 6] = 0.0
    pose[..., 7] = 0.0
    pose[..., 8] = 1
    jacobian[..., 0] = -t10
    jacobian[..., 1] = -(t10 - t8)
    jacobian[..., 2] = -t9
    jacobian[..., 3] = t7
    jacobian[..., 4] = t7 - t5
    jacobian[..., 5] = t6
    jacobian[..., 6] = 1
    jacobian[..., 7] = 1
    jacobian[..., 8] = 1
    return pose.reshape(_leading + (3, 3)), jacobian.reshape(_leading + (3, 3))


def survey_position(q, parameters):
    """position, Jacobian and manipulability H together: 52 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
    out  position[2]
    out  jacobian[2][3]
    out  manipulability (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    l1 = parameters[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = c1 * l1
    t2 = c1 * c2 - s1 * s2
    t3 = c1 * s2 + c2 * s1
    t4 = (t2 * c3 - t3 * s3) * l3
    t5 = t1 + t2 * l2 + t4
    t6 = l1 * s1
    t7 = l3 * (c3 * t3 + t2 * s3)
    t8 = t6 + l2 * t3 + t7
    t9 = c2 * s3 + s2 * c3
    t10 = l1 * (s2 * l2 + l3 * t9)
    t11 = l3 * (l1 * t9 + l2 * s3)
    t12 = s3 * (l2 * l3)

    # results
    position = np.empty((*_leading, 2), _real)
    jacobian = np.empty((*_leading, 6), _real)
    manipulability = np.empty((*_leading, 1), _real)
    position[..., 0] = t5
    position[..., 1] = t8
    jacobian[..., 0] = -t8
    jacobian[..., 1] = -(t8 - t6)
    jacobian[..., 2] = -t7
    jacobian[..., 3] = t5
    jacobian[..., 4] = t5 - t1
    jacobian[..., 5] = t4
    manipulability[..., 0] = np.sqrt((t10 * t10 + t11 * t11 + t12 * t12))
    return position.reshape(_leading + (2,)), jacobian.reshape(_leading + (2, 3)), manipulability.reshape(_leading)


def postures(target, parameters):
    """both postures of a pose (x, y, alpha), and the radicand, negative where there are none: 38 operations.

    in   target[3] = (x, y, alpha)
    in   parameters[3] = (l1, l2, l3)
    out  q[2][3]
    out  radicand (one number)
    """
    target = np.asarray(target)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(target.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(target, parameters, np.float32)

    # inputs, sines and cosines
    y = target[..., 1]
    l3 = parameters[..., 2]
    alpha = target[..., 2]
    sin_alpha = np.sin(alpha)
    x = target[..., 0]
    cos_alpha = np.cos(alpha)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]

    # terms
    t1 = y - l3 * sin_alpha
    t2 = x - l3 * cos_alpha
    t3 = np.arctan2(t1, t2)
    t4 = t2 * t2 + t1 * t1
    t5 = np.sqrt(t4)
    t6 = t5 + l1
    t7 = (t6 - l2) * (t5 + l2 - l1) * ((t6 + l2) * (l1 + l2 - t5))
    t8 = np.sqrt(np.maximum(0.0, t7))
    t9 = l1 * l1
    t10 = t4 - t9 - l2 * l2
    t11 = np.arctan2(t8, t10 + (t9 + t9))
    t12 = t3 - t11
    t13 = np.arctan2(t8, t10)
    t14 = t3 + t11

    # results
    q = np.empty((*_leading, 6), _real)
    radicand = np.empty((*_leading, 1), _real)
    q[..., 0] = t12
    q[..., 1] = t13
    q[..., 2] = alpha - t13 - t12
    q[..., 3] = t14
    q[..., 4] = -t13
    q[..., 5] = alpha + t13 - t14
    radicand[..., 0] = t7
    return q.reshape(_leading + (2, 3)), radicand.reshape(_leading)
