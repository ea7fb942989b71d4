"""kinematics of orthogonal_3r, in NumPy.

Made from templates/kernel.py.j2; inputs acb2265402e52b72edd2dd46636047fbec5ba872b074bc2fa364e334504a1dbe.
310 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def position(q, parameters):
    """position of the tip, in the base frame: 33 operations.

    in   q[3]
    in   parameters[4] = (d2, d3, d4, r2)
    out  position[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    d2 = parameters[..., 0]
    r2 = parameters[..., 3]
    s1 = np.sin(q1)
    d3 = parameters[..., 1]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    d4 = parameters[..., 2]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    s2 = np.sin(q2)

    # terms
    t1 = c1 * c2
    t2 = c1 * d2 - r2 * s1 + d3 * t1 + d4 * (t1 * c3 - s1 * s3)
    t3 = s1 * c2
    t4 = c1 * r2 + d2 * s1 + d3 * t3 + d4 * (c1 * s3 + c3 * t3)

    # results
    position = np.empty((*_leading, 3), _real)
    position[..., 0] = t2
    position[..., 1] = t4
    position[..., 2] = -(d3 * s2 + d4 * (c3 * s2))
    return position.reshape(_leading + (3,))


def pose(q, parameters):
    """pose of the tip, in the base frame: 44 operations.

    in   q[3]
    in   parameters[4] = (d2, d3, d4, r2)
    out  pose[4][4]
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
    s3 = np.sin(q3)
    s2 = np.sin(q2)
    d2 = parameters[..., 0]
    r2 = parameters[..., 3]
    d3 = parameters[..., 1]
    d4 = parameters[..., 2]

    # terms
    t1 = c1 * c2
    t2 = c3 * t1 - s1 * s3
    t3 = c1 * d2 - s1 * r2 + t1 * d3 + t2 * d4
    t4 = c2 * s1
    t5 = c1 * s3 + c3 * t4
    t6 = c1 * r2 + s1 * d2 + d3 * t4 + d4 * t5
    t7 = c3 * s2

    # results
    pose = np.empty((*_leading, 16), _real)
    pose[..., 0] = t2
    pose[..., 1] = -(c3 * s1 + t1 * s3)
    pose[..., 2] = c1 * s2
    pose[..., 3] = t3
    pose[..., 4] = t5
    pose[..., 5] = c3 * c1 - s3 * t4
    pose[..., 6] = s1 * s2
    pose[..., 7] = t6
    pose[..., 8] = -t7
    pose[..., 9] = s3 * s2
    pose[..., 10] = c2
    pose[..., 11] = -(s2 * d3 + d4 * t7)
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    return pose.reshape(_leading + (4, 4))


def jacobian_position(q, parameters):
    """Jacobian of the position, in the base frame: 55 operations.

    in   q[3]
    in   parameters[4] = (d2, d3, d4, r2)
    out  jacobian[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    r2 = parameters[..., 3]
    d2 = parameters[..., 0]
    s1 = np.sin(q1)
    d3 = parameters[..., 1]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    d4 = parameters[..., 2]
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)
    s2 = np.sin(q2)

    # terms
    t1 = c1 * r2 + d2 * s1
    t2 = s1 * c2
    t3 = d4 * (c1 * s3 + t2 * c3)
    t4 = t1 + d3 * t2 + t3
    t5 = d4 * (c3 * s2)
    t6 = d3 * s2 + t5
    t7 = s1 * s2
    t8 = c1 * d2 - r2 * s1
    t9 = c1 * c2
    t10 = d4 * (c3 * t9 - s1 * s3)
    t11 = t8 + d3 * t9 + t10
    t12 = c1 * s2

    # results
    jacobian = np.empty((*_leading, 9), _real)
    jacobian[..., 0] = -t4
    jacobian[..., 1] = -(c1 * t6)
    jacobian[..., 2] = -(c2 * t3 + t5 * t7)
    jacobian[..., 3] = t11
    jacobian[..., 4] = -(s1 * t6)
    jacobian[..., 5] = c2 * t10 + t5 * t12
    jacobian[..., 6] = 0.0
    jacobian[..., 7] = -(c1 * (t11 - t8) + s1 * (t4 - t1))
    jacobian[..., 8] = t3 * t12 - t7 * t10
    return jacobian.reshape(_leading + (3, 3))


def jacobian_pose(q, parameters):
    """Jacobian of the pose, in the base frame: 56 operations.

    in   q[3]
    in   parameters[4] = (d2, d3, d4, r2)
    out  jacobian[6][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    r2 = parameters[..., 3]
    d2 = parameters[..., 0]
    s1 = np.sin(q1)
    d3 = parameters[..., 1]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    d4 = parameters[..., 2]
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)
    s2 = np.sin(q2)

    # terms
    t1 = c1 * r2 + d2 * s1
    t2 = s1 * c2
    t3 = d4 * (c1 * s3 + t2 * c3)
    t4 = t1 + d3 * t2 + t3
    t5 = d4 * (c3 * s2)
    t6 = d3 * s2 + t5
    t7 = s1 * s2
    t8 = c1 * d2 - r2 * s1
    t9 = c1 * c2
    t10 = d4 * (c3 * t9 - s1 * s3)
    t11 = t8 + d3 * t9 + t10
    t12 = c1 * s2

    # results
    jacobian = np.empty((*_leading, 18), _real)
    jacobian[..., 0] = -t4
    jacobian[..., 1] = -(c1 * t6)
    jacobian[..., 2] = -(c2 * t3 + t5 * t7)
    jacobian[..., 3] = t11
    jacobian[..., 4] = -(s1 * t6)
    jacobian[..., 5] = c2 * t10 + t5 * t12
    jacobian[..., 6] = 0.0
    jacobian[..., 7] = -(c1 * (t11 - t8) + s1 * (t4 - t1))
    jacobian[..., 8] = t3 * t12 - t7 * t10
    jacobian[..., 9] = 0.0
    jacobian[..., 10] = -s1
    jacobian[..., 11] = t12
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = c1
    jacobian[..., 14] = t7
    jacobian[..., 15] = 1
    jacobian[..., 16] = 0.0
    jacobian[..., 17] = c2
    return jacobian.reshape(_leading + (6, 3))


def kinematics_position(q, parameters):
    """position and its Jacobian, in the base frame: 56 operations.

    in   q[3]
    in   parameters[4] = (d2, d3, d4, r2)
    out  position[3]
    out  jacobian[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    d2 = parameters[..., 0]
    r2 = parameters[..., 3]
    s1 = np.sin(q1)
    d3 = parameters[..., 1]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    d4 = parameters[..., 2]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    s2 = np.sin(q2)

    # terms
    t1 = c1 * d2 - r2 * s1
    t2 = c1 * c2
    t3 = d4 * (t2 * c3 - s1 * s3)
    t4 = t1 + d3 * t2 + t3
    t5 = c1 * r2 + d2 * s1
    t6 = s1 * c2
    t7 = d4 * (c1 * s3 + c3 * t6)
    t8 = t5 + d3 * t6 + t7
    t9 = d4 * (c3 * s2)
    t10 = d3 * s2 + t9
    t11 = s1 * s2
    t12 = c1 * s2

    # results
    position = np.empty((*_leading, 3), _real)
    jacobian = np.empty((*_leading, 9), _real)
    position[..., 0] = t4
    position[..., 1] = t8
    position[..., 2] = -t10
    jacobian[..., 0] = -t8
    jacobian[..., 1] = -(c1 * t10)
    jacobian[..., 2] = -(c2 * t7 + t9 * t11)
    jacobian[..., 3] = t4
    jacobian[..., 4] = -(s1 * t10)
    jacobian[..., 5] = c2 * t3 + t9 * t12
    jacobian[..., 6] = 0.0
    jacobian[..., 7] = -(c1 * (t4 - t1) + s1 * (t8 - t5))
    jacobian[..., 8] = t7 * t12 - t3 * t11
    return position.reshape(_leading + (3,)), jacobian.reshape(_leading + (3, 3))


def kinematics_pose(q, parameters):
    """pose and its Jacobian, in the base frame: 66 operations.

    in   q[3]
    in   parameters[4] = (d2, d3, d4, r2)
    out  pose[4][4]
    out  jacobian[6][3]
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
    s3 = np.sin(q3)
    s2 = np.sin(q2)
    d2 = parameters[..., 0]
    r2 = parameters[..., 3]
    d3 = parameters[..., 1]
    d4 = parameters[..., 2]

    # terms
    t1 = c1 * c2
    t2 = c3 * t1 - s1 * s3
    t3 = c1 * s2
    t4 = c1 * d2 - s1 * r2
    t5 = t2 * d4
    t6 = t4 + t1 * d3 + t5
    t7 = c2 * s1
    t8 = c1 * s3 + c3 * t7
    t9 = s1 * s2
    t10 = c1 * r2 + s1 * d2
    t11 = d4 * t8
    t12 = t10 + d3 * t7 + t11
    t13 = c3 * s2
    t14 = d4 * t13
    t15 = s2 * d3 + t14

    # results
    pose = np.empty((*_leading, 16), _real)
    jacobian = np.empty((*_leading, 18), _real)
    pose[..., 0] = t2
    pose[..., 1] = -(c3 * s1 + t1 * s3)
    pose[..., 2] = t3
    pose[..., 3] = t6
    pose[..., 4] = t8
    pose[..., 5] = c3 * c1 - s3 * t7
    pose[..., 6] = t9
    pose[..., 7] = t12
    pose[..., 8] = -t13
    pose[..., 9] = s3 * s2
    pose[..., 10] = c2
    pose[..., 11] = -t15
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    jacobian[..., 0] = -t12
    jacobian[..., 1] = -(c1 * t15)
    jacobian[..., 2] = -(c2 * t11 + t9 * t14)
    jacobian[..., 3] = t6
    jacobian[..., 4] = -(s1 * t15)
    jacobian[..., 5] = c2 * t5 + t3 * t14
    jacobian[..., 6] = 0.0
    jacobian[..., 7] = -(c1 * (t6 - t4) + s1 * (t12 - t10))
    jacobian[..., 8] = t3 * t11 - t5 * t9
    jacobian[..., 9] = 0.0
    jacobian[..., 10] = -s1
    jacobian[..., 11] = t3
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = c1
    jacobian[..., 14] = t9
    jacobian[..., 15] = 1
    jacobian[..., 16] = 0.0
    jacobian[..., 17] = c2
    return pose.reshape(_leading + (4, 4)), jacobian.reshape(_leading + (6, 3))
