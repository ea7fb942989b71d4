"""kinematics of puma560, in NumPy.

Made from templates/kernel.py.j2; inputs dca842d5303801c628e150dba0d9bdac62d1af990563b94c54821f0df2a04558.
511 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def position(q):
    """position of the tip, in the base frame: 47 operations.

    in   q[6]
    out  position[3]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    s2 = np.sin(q2)

    # terms
    t1 = c1 * c2
    t2 = c1 * s2
    t3 = 0.15005 * s1 + 0.4318 * t1 + 0.0203 * (t1 * c3 - s3 * t2)
    t4 = s1 * c2
    t5 = s1 * s2
    t6 = 0.4318 * t4 - 0.15005 * c1 + 0.0203 * (c3 * t4 - s3 * t5)
    t7 = 0.4318 * s2 + 0.0203 * (c2 * s3 + c3 * s2) + 0.4318 * (c2 * c3 - s3 * s2)

    # results
    position = np.empty((*_leading, 3), _real)
    position[..., 0] = t3 - 0.4318 * (c3 * t2 + t1 * s3)
    position[..., 1] = t6 - 0.4318 * (c3 * t5 + s3 * t4)
    position[..., 2] = t7
    return position.reshape(_leading + (3,))


def pose(q):
    """pose of the tip, in the base frame: 107 operations.

    in   q[6]
    out  pose[4][4]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q6 = q[..., 5]
    c6 = np.cos(q6)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s3 = np.sin(q3)
    s2 = np.sin(q2)
    s1 = np.sin(q1)
    s4 = np.sin(q4)
    s5 = np.sin(q5)
    s6 = np.sin(q6)

    # terms
    t1 = c1 * c2
    t2 = c1 * s2
    t3 = c3 * t1 - s3 * t2
    t4 = c4 * t3 - s1 * s4
    t5 = c3 * t2 + t1 * s3
    t6 = c5 * t4 - s5 * t5
    t7 = c4 * s1 + t3 * s4
    t8 = 0.15005 * s1 + 0.4318 * t1 + 0.0203 * t3 - 0.4318 * t5
    t9 = c2 * s1
    t10 = s2 * s1
    t11 = c3 * t9 - s3 * t10
    t12 = c1 * s4 + c4 * t11
    t13 = c3 * t10 + s3 * t9
    t14 = c5 * t12 - s5 * t13
    t15 = c4 * c1 - s4 * t11
    t16 = 0.4318 * t9 - 0.15005 * c1 + 0.0203 * t11 - 0.4318 * t13
    t17 = c2 * s3 + c3 * s2
    t18 = c4 * t17
    t19 = c3 * c2 - s3 * s2
    t20 = c5 * t18 + s5 * t19
    t21 = s4 * t17

    # results
    pose = np.empty((*_leading, 16), _real)
    pose[..., 0] = c6 * t6 - s6 * t7
    pose[..., 1] = -(c6 * t7 + t6 * s6)
    pose[..., 2] = -(c5 * t5 + t4 * s5)
    pose[..., 3] = t8
    pose[..., 4] = c6 * t14 + s6 * t15
    pose[..., 5] = c6 * t15 - s6 * t14
    pose[..., 6] = -(c5 * t13 + s5 * t12)
    pose[..., 7] = t16
    pose[..., 8] = c6 * t20 - s6 * t21
    pose[..., 9] = -(c6 * t21 + s6 * t20)
    pose[..., 10] = c5 * t19 - s5 * t18
    pose[..., 11] = 0.4318 * s2 + 0.0203 * t17 + 0.4318 * t19
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    return pose.reshape(_leading + (4, 4))


def jacobian_position(q):
    """Jacobian of the position, in the base frame: 65 operations.

    in   q[6]
    out  jacobian[3][6]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    s2 = np.sin(q2)

    # terms
    t1 = c2 * s1
    t2 = 0.4318 * t1 - 0.15005 * c1
    t3 = s1 * s2
    t4 = t2 + 0.0203 * (t1 * c3 - s3 * t3) - 0.4318 * (c3 * t3 + t1 * s3)
    t5 = 0.4318 * s2
    t6 = t5 + 0.0203 * (c2 * s3 + c3 * s2) + 0.4318 * (c2 * c3 - s3 * s2)
    t7 = t6 - t5
    t8 = c2 * c1
    t9 = 0.15005 * s1 + 0.4318 * t8
    t10 = c1 * s2
    t11 = t9 + 0.0203 * (c3 * t8 - s3 * t10) - 0.4318 * (c3 * t10 + s3 * t8)

    # results
    jacobian = np.empty((*_leading, 18), _real)
    jacobian[..., 0] = -t4
    jacobian[..., 1] = -(c1 * t6)
    jacobian[..., 2] = -(c1 * t7)
    jacobian[..., 3] = 0.0
    jacobian[..., 4] = 0.0
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t11
    jacobian[..., 7] = -(s1 * t6)
    jacobian[..., 8] = -(s1 * t7)
    jacobian[..., 9] = 0.0
    jacobian[..., 10] = 0.0
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = c1 * t11 + s1 * t4
    jacobian[..., 14] = c1 * (t11 - t9) + s1 * (t4 - t2)
    jacobian[..., 15] = 0.0
    jacobian[..., 16] = 0.0
    jacobian[..., 17] = 0.0
    return jacobian.reshape(_leading + (3, 6))


def jacobian_pose(q):
    """Jacobian of the pose, in the base frame: 98 operations.

    in   q[6]
    out  jacobian[6][6]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    s2 = np.sin(q2)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)

    # terms
    t1 = c2 * s1
    t2 = 0.4318 * t1 - 0.15005 * c1
    t3 = s1 * s2
    t4 = t1 * c3 - s3 * t3
    t5 = c3 * t3 + t1 * s3
    t6 = t2 + 0.0203 * t4 - 0.4318 * t5
    t7 = 0.4318 * s2
    t8 = c2 * s3 + c3 * s2
    t9 = c2 * c3 - s3 * s2
    t10 = t7 + 0.0203 * t8 + 0.4318 * t9
    t11 = t10 - t7
    t12 = c2 * c1
    t13 = 0.15005 * s1 + 0.4318 * t12
    t14 = c1 * s2
    t15 = c3 * t12 - s3 * t14
    t16 = c3 * t14 + s3 * t12
    t17 = t13 + 0.0203 * t15 - 0.4318 * t16
    t18 = -(t16 * c5 + s5 * (t15 * c4 - s1 * s4))
    t19 = -c1
    t20 = -(t5 * c5 + s5 * (c1 * s4 + t4 * c4))

    # results
    jacobian = np.empty((*_leading, 36), _real)
    jacobian[..., 0] = -t6
    jacobian[..., 1] = -(c1 * t10)
    jacobian[..., 2] = -(c1 * t11)
    jacobian[..., 3] = 0.0
    jacobian[..., 4] = 0.0
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t17
    jacobian[..., 7] = -(s1 * t10)
    jacobian[..., 8] = -(s1 * t11)
    jacobian[..., 9] = 0.0
    jacobian[..., 10] = 0.0
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = c1 * t17 + s1 * t6
    jacobian[..., 14] = c1 * (t17 - t13) + s1 * (t6 - t2)
    jacobian[..., 15] = 0.0
    jacobian[..., 16] = 0.0
    jacobian[..., 17] = 0.0
    jacobian[..., 18] = 0.0
    jacobian[..., 19] = s1
    jacobian[..., 20] = s1
    jacobian[..., 21] = -t16
    jacobian[..., 22] = s1 * c4 + t15 * s4
    jacobian[..., 23] = t18
    jacobian[..., 24] = 0.0
    jacobian[..., 25] = t19
    jacobian[..., 26] = t19
    jacobian[..., 27] = -t5
    jacobian[..., 28] = -(c1 * c4 - t4 * s4)
    jacobian[..., 29] = t20
    jacobian[..., 30] = 1
    jacobian[..., 31] = 0.0
    jacobian[..., 32] = 0.0
    jacobian[..., 33] = t9
    jacobian[..., 34] = t8 * s4
    jacobian[..., 35] = t9 * c5 - s5 * (t8 * c4)
    return jacobian.reshape(_leading + (6, 6))


def kinematics_position(q):
    """position and its Jacobian, in the base frame: 65 operations.

    in   q[6]
    out  position[3]
    out  jacobian[3][6]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    s2 = np.sin(q2)

    # terms
    t1 = c1 * c2
    t2 = 0.15005 * s1 + 0.4318 * t1
    t3 = c1 * s2
    t4 = t2 + 0.0203 * (t1 * c3 - s3 * t3) - 0.4318 * (c3 * t3 + t1 * s3)
    t5 = s1 * c2
    t6 = 0.4318 * t5 - 0.15005 * c1
    t7 = s1 * s2
    t8 = t6 + 0.0203 * (c3 * t5 - s3 * t7) - 0.4318 * (c3 * t7 + s3 * t5)
    t9 = 0.4318 * s2
    t10 = t9 + 0.0203 * (c2 * s3 + c3 * s2) + 0.4318 * (c2 * c3 - s3 * s2)
    t11 = t10 - t9

    # results
    position = np.empty((*_leading, 3), _real)
    jacobian = np.empty((*_leading, 18), _real)
    position[..., 0] = t4
    position[..., 1] = t8
    position[..., 2] = t10
    jacobian[..., 0] = -t8
    jacobian[..., 1] = -(c1 * t10)
    jacobian[..., 2] = -(c1 * t11)
    jacobian[..., 3] = 0.0
    jacobian[..., 4] = 0.0
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t4
    jacobian[..., 7] = -(s1 * t10)
    jacobian[..., 8] = -(s1 * t11)
    jacobian[..., 9] = 0.0
    jacobian[..., 10] = 0.0
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = c1 * t4 + s1 * t8
    jacobian[..., 14] = c1 * (t4 - t2) + s1 * (t8 - t6)
    jacobian[..., 15] = 0.0
    jacobian[..., 16] = 0.0
    jacobian[..., 17] = 0.0
    return position.reshape(_leading + (3,)), jacobian.reshape(_leading + (3, 6))


def kinematics_pose(q):
    """pose and its Jacobian, in the base frame: 129 operations.

    in   q[6]
    out  pose[4][4]
    out  jacobian[6][6]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q6 = q[..., 5]
    c6 = np.cos(q6)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s3 = np.sin(q3)
    s2 = np.sin(q2)
    s1 = np.sin(q1)
    s4 = np.sin(q4)
    s5 = np.sin(q5)
    s6 = np.sin(q6)

    # terms
    t1 = c1 * c2
    t2 = c1 * s2
    t3 = c3 * t1 - s3 * t2
    t4 = c4 * t3 - s1 * s4
    t5 = c3 * t2 + t1 * s3
    t6 = c5 * t4 - s5 * t5
    t7 = c4 * s1 + t3 * s4
    t8 = -(c5 * t5 + t4 * s5)
    t9 = 0.15005 * s1 + 0.4318 * t1
    t10 = t9 + 0.0203 * t3 - 0.4318 * t5
    t11 = c2 * s1
    t12 = s2 * s1
    t13 = c3 * t11 - s3 * t12
    t14 = c1 * s4 + c4 * t13
    t15 = c3 * t12 + s3 * t11
    t16 = c5 * t14 - s5 * t15
    t17 = c4 * c1 - s4 * t13
    t18 = -(c5 * t15 + s5 * t14)
    t19 = 0.4318 * t11 - 0.15005 * c1
    t20 = t19 + 0.0203 * t13 - 0.4318 * t15
    t21 = c2 * s3 + c3 * s2
    t22 = c4 * t21
    t23 = c3 * c2 - s3 * s2
    t24 = c5 * t22 + s5 * t23
    t25 = s4 * t21
    t26 = c5 * t23 - s5 * t22
    t27 = 0.4318 * s2
    t28 = t27 + 0.0203 * t21 + 0.4318 * t23
    t29 = t28 - t27
    t30 = -c1

    # results
    pose = np.empty((*_leading, 16), _real)
    jacobian = np.empty((*_leading, 36), _real)
    pose[..., 0] = c6 * t6 - s6 * t7
    pose[..., 1] = -(c6 * t7 + t6 * s6)
    pose[..., 2] = t8
    pose[..., 3] = t10
    pose[..., 4] = c6 * t16 + s6 * t17
    pose[..., 5] = c6 * t17 - s6 * t16
    pose[..., 6] = t18
    pose[..., 7] = t20
    pose[..., 8] = c6 * t24 - s6 * t25
    pose[..., 9] = -(c6 * t25 + s6 * t24)
    pose[..., 10] = t26
    pose[..., 11] = t28
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    jacobian[..., 0] = -t20
    jacobian[..., 1] = -(c1 * t28)
    jacobian[..., 2] = -(c1 * t29)
    jacobian[..., 3] = 0.0
    jacobian[..., 4] = 0.0
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t10
    jacobian[..., 7] = -(s1 * t28)
    jacobian[..., 8] = -(s1 * t29)
    jacobian[..., 9] = 0.0
    jacobian[..., 10] = 0.0
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = c1 * t10 + s1 * t20
    jacobian[..., 14] = c1 * (t10 - t9) + s1 * (t20 - t19)
    jacobian[..., 15] = 0.0
    jacobian[..., 16] = 0.0
    jacobian[..., 17] = 0.0
    jacobian[..., 18] = 0.0
    jacobian[..., 19] = s1
    jacobian[..., 20] = s1
    jacobian[..., 21] = -t5
    jacobian[..., 22] = t7
    jacobian[..., 23] = t8
    jacobian[..., 24] = 0.0
    jacobian[..., 25] = t30
    jacobian[..., 26] = t30
    jacobian[..., 27] = -t15
    jacobian[..., 28] = -t17
    jacobian[..., 29] = t18
    jacobian[..., 30] = 1
    jacobian[..., 31] = 0.0
    jacobian[..., 32] = 0.0
    jacobian[..., 33] = t23
    jacobian[..., 34] = t25
    jacobian[..., 35] = t26
    return pose.reshape(_leading + (4, 4)), jacobian.reshape(_leading + (6, 6))
