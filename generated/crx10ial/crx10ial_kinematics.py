"""kinematics of crx10ial, in NumPy.

Made from templates/kernel.py.j2; inputs 5a1a4d8d015b476139cb7d9600556a7808a6b8fef2eeb067156f636f0edb0dbb.
698 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def position(q):
    """position of the tip, in the base frame: 76 operations.

    in   q[6]
    out  position[3]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    c2 = np.cos(q2)
    s3 = np.sin(q3)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s1 = np.sin(q1)
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)

    # terms
    t1 = c1 * s2
    t2 = c1 * c2
    t3 = c3 * t2 + t1 * s3
    t4 = t1 * c3 - t2 * s3
    t5 = 0.71 * t1 + 0.54 * t3 + 0.15 * (c4 * s1 + s4 * t4)
    t6 = 0.16 * (t3 * c5 + s5 * (c4 * t4 - s1 * s4))
    t7 = s2 * s1
    t8 = c2 * s1
    t9 = c3 * t8 + s3 * t7
    t10 = c3 * t7 - s3 * t8
    t11 = 0.71 * t7 + 0.54 * t9 - 0.15 * (c1 * c4 - s4 * t10)
    t12 = 0.16 * (c5 * t9 + s5 * (c1 * s4 + c4 * t10))
    t13 = s2 * c3 - c2 * s3
    t14 = c3 * c2 + s2 * s3
    t15 = 0.71 * c2 - 0.54 * t13 + 0.15 * (s4 * t14) - 0.16 * (c5 * t13 - s5 * (c4 * t14))

    # results
    position = np.empty((*_leading, 3), _real)
    position[..., 0] = t5 + t6
    position[..., 1] = t11 + t12
    position[..., 2] = t15
    return position.reshape(_leading + (3,))


def pose(q):
    """pose of the tip, in the base frame: 109 operations.

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
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s4 = np.sin(q4)
    s5 = np.sin(q5)
    s6 = np.sin(q6)

    # terms
    t1 = c1 * s2
    t2 = c1 * c2
    t3 = c3 * t1 - s3 * t2
    t4 = c4 * t3 - s1 * s4
    t5 = c3 * t2 + t1 * s3
    t6 = c5 * t4 - s5 * t5
    t7 = c4 * s1 + t3 * s4
    t8 = c5 * t5 + t4 * s5
    t9 = 0.71 * t1 + 0.54 * t5 + 0.15 * t7 + 0.16 * t8
    t10 = s2 * s1
    t11 = c2 * s1
    t12 = c3 * t10 - s3 * t11
    t13 = c1 * s4 + c4 * t12
    t14 = c3 * t11 + s3 * t10
    t15 = c5 * t13 - s5 * t14
    t16 = c4 * c1 - s4 * t12
    t17 = c5 * t14 + s5 * t13
    t18 = 0.71 * t10 + 0.54 * t14 - 0.15 * t16 + 0.16 * t17
    t19 = c3 * c2 + s2 * s3
    t20 = c4 * t19
    t21 = c3 * s2 - s3 * c2
    t22 = c5 * t20 + s5 * t21
    t23 = s4 * t19
    t24 = c5 * t21 - s5 * t20
    t25 = 0.71 * c2 - 0.54 * t21 + 0.15 * t23 - 0.16 * t24

    # results
    pose = np.empty((*_leading, 16), _real)
    pose[..., 0] = c6 * t6 - s6 * t7
    pose[..., 1] = -(c6 * t7 + t6 * s6)
    pose[..., 2] = -t8
    pose[..., 3] = t9
    pose[..., 4] = c6 * t15 + s6 * t16
    pose[..., 5] = c6 * t16 - s6 * t15
    pose[..., 6] = -t17
    pose[..., 7] = t18
    pose[..., 8] = c6 * t22 - s6 * t23
    pose[..., 9] = -(c6 * t23 + s6 * t22)
    pose[..., 10] = t24
    pose[..., 11] = t25
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    return pose.reshape(_leading + (4, 4))


def jacobian_position(q):
    """Jacobian of the position, in the base frame: 117 operations.

    in   q[6]
    out  jacobian[3][6]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    s1 = np.sin(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    c2 = np.cos(q2)
    s3 = np.sin(q3)
    c1 = np.cos(q1)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)

    # terms
    t1 = s1 * s2
    t2 = 0.71 * t1
    t3 = s1 * c2
    t4 = c3 * t3 + t1 * s3
    t5 = t2 + 0.54 * t4
    t6 = t1 * c3 - t3 * s3
    t7 = c1 * c4 - s4 * t6
    t8 = 0.16 * (t4 * c5 + s5 * (c1 * s4 + c4 * t6))
    t9 = t5 - 0.15 * t7 + t8
    t10 = 0.71 * c2
    t11 = s2 * c3 - c2 * s3
    t12 = t10 - 0.54 * t11
    t13 = c3 * c2 + s2 * s3
    t14 = s4 * t13
    t15 = t12 + 0.15 * t14
    t16 = t15 - 0.16 * (c5 * t11 - s5 * (c4 * t13))
    t17 = t16 - t10
    t18 = t16 - t12
    t19 = t9 - t5
    t20 = t16 - t15
    t21 = s2 * c1
    t22 = 0.71 * t21
    t23 = c2 * c1
    t24 = c3 * t23 + s3 * t21
    t25 = t22 + 0.54 * t24
    t26 = c3 * t21 - s3 * t23
    t27 = s1 * c4 + s4 * t26
    t28 = 0.16 * (c5 * t24 + s5 * (c4 * t26 - s1 * s4))
    t29 = t25 + 0.15 * t27 + t28
    t30 = t29 - t25

    # results
    jacobian = np.empty((*_leading, 18), _real)
    jacobian[..., 0] = -t9
    jacobian[..., 1] = c1 * t16
    jacobian[..., 2] = -(c1 * t17)
    jacobian[..., 3] = -(t4 * t18 + t11 * t19)
    jacobian[..., 4] = -(t8 * t14 + t7 * t20)
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t29
    jacobian[..., 7] = s1 * t16
    jacobian[..., 8] = -(s1 * t17)
    jacobian[..., 9] = t11 * t30 + t18 * t24
    jacobian[..., 10] = t14 * t28 - t20 * t27
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = -(c1 * t29 + s1 * t9)
    jacobian[..., 14] = c1 * (t29 - t22) + s1 * (t9 - t2)
    jacobian[..., 15] = t4 * t30 - t19 * t24
    jacobian[..., 16] = t7 * t28 + t8 * t27
    jacobian[..., 17] = 0.0
    return jacobian.reshape(_leading + (3, 6))


def jacobian_pose(q):
    """Jacobian of the pose, in the base frame: 124 operations.

    in   q[6]
    out  jacobian[6][6]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    s1 = np.sin(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    c2 = np.cos(q2)
    s3 = np.sin(q3)
    c1 = np.cos(q1)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)

    # terms
    t1 = s1 * s2
    t2 = 0.71 * t1
    t3 = s1 * c2
    t4 = c3 * t3 + t1 * s3
    t5 = t2 + 0.54 * t4
    t6 = t1 * c3 - t3 * s3
    t7 = c1 * c4 - s4 * t6
    t8 = t4 * c5 + s5 * (c1 * s4 + c4 * t6)
    t9 = 0.16 * t8
    t10 = t5 - 0.15 * t7 + t9
    t11 = 0.71 * c2
    t12 = s2 * c3 - c2 * s3
    t13 = t11 - 0.54 * t12
    t14 = c3 * c2 + s2 * s3
    t15 = s4 * t14
    t16 = t13 + 0.15 * t15
    t17 = c5 * t12 - s5 * (c4 * t14)
    t18 = t16 - 0.16 * t17
    t19 = t18 - t11
    t20 = t18 - t13
    t21 = t10 - t5
    t22 = t18 - t16
    t23 = s2 * c1
    t24 = 0.71 * t23
    t25 = c2 * c1
    t26 = c3 * t25 + s3 * t23
    t27 = t24 + 0.54 * t26
    t28 = c3 * t23 - s3 * t25
    t29 = s1 * c4 + s4 * t28
    t30 = c5 * t26 + s5 * (c4 * t28 - s1 * s4)
    t31 = 0.16 * t30
    t32 = t27 + 0.15 * t29 + t31
    t33 = t32 - t27

    # results
    jacobian = np.empty((*_leading, 36), _real)
    jacobian[..., 0] = -t10
    jacobian[..., 1] = c1 * t18
    jacobian[..., 2] = -(c1 * t19)
    jacobian[..., 3] = -(t4 * t20 + t12 * t21)
    jacobian[..., 4] = -(t9 * t15 + t7 * t22)
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t32
    jacobian[..., 7] = s1 * t18
    jacobian[..., 8] = -(s1 * t19)
    jacobian[..., 9] = t12 * t33 + t20 * t26
    jacobian[..., 10] = t15 * t31 - t22 * t29
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = -(c1 * t32 + s1 * t10)
    jacobian[..., 14] = c1 * (t32 - t24) + s1 * (t10 - t2)
    jacobian[..., 15] = t4 * t33 - t21 * t26
    jacobian[..., 16] = t7 * t31 + t9 * t29
    jacobian[..., 17] = 0.0
    jacobian[..., 18] = 0.0
    jacobian[..., 19] = -s1
    jacobian[..., 20] = s1
    jacobian[..., 21] = -t26
    jacobian[..., 22] = t29
    jacobian[..., 23] = -t30
    jacobian[..., 24] = 0.0
    jacobian[..., 25] = c1
    jacobian[..., 26] = -c1
    jacobian[..., 27] = -t4
    jacobian[..., 28] = -t7
    jacobian[..., 29] = -t8
    jacobian[..., 30] = 1
    jacobian[..., 31] = 0.0
    jacobian[..., 32] = 0.0
    jacobian[..., 33] = t12
    jacobian[..., 34] = t15
    jacobian[..., 35] = t17
    return jacobian.reshape(_leading + (6, 6))


def kinematics_position(q):
    """position and its Jacobian, in the base frame: 117 operations.

    in   q[6]
    out  position[3]
    out  jacobian[3][6]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    c2 = np.cos(q2)
    s3 = np.sin(q3)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s1 = np.sin(q1)
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)

    # terms
    t1 = c1 * s2
    t2 = 0.71 * t1
    t3 = c1 * c2
    t4 = c3 * t3 + t1 * s3
    t5 = t2 + 0.54 * t4
    t6 = t1 * c3 - t3 * s3
    t7 = c4 * s1 + s4 * t6
    t8 = 0.16 * (t4 * c5 + s5 * (c4 * t6 - s1 * s4))
    t9 = t5 + 0.15 * t7 + t8
    t10 = s2 * s1
    t11 = 0.71 * t10
    t12 = c2 * s1
    t13 = c3 * t12 + s3 * t10
    t14 = t11 + 0.54 * t13
    t15 = c3 * t10 - s3 * t12
    t16 = c1 * c4 - s4 * t15
    t17 = 0.16 * (c5 * t13 + s5 * (c1 * s4 + c4 * t15))
    t18 = t14 - 0.15 * t16 + t17
    t19 = 0.71 * c2
    t20 = s2 * c3 - c2 * s3
    t21 = t19 - 0.54 * t20
    t22 = c3 * c2 + s2 * s3
    t23 = s4 * t22
    t24 = t21 + 0.15 * t23
    t25 = t24 - 0.16 * (c5 * t20 - s5 * (c4 * t22))
    t26 = t25 - t19
    t27 = t25 - t21
    t28 = t18 - t14
    t29 = t25 - t24
    t30 = t9 - t5

    # results
    position = np.empty((*_leading, 3), _real)
    jacobian = np.empty((*_leading, 18), _real)
    position[..., 0] = t9
    position[..., 1] = t18
    position[..., 2] = t25
    jacobian[..., 0] = -t18
    jacobian[..., 1] = c1 * t25
    jacobian[..., 2] = -(c1 * t26)
    jacobian[..., 3] = -(t13 * t27 + t20 * t28)
    jacobian[..., 4] = -(t17 * t23 + t16 * t29)
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t9
    jacobian[..., 7] = s1 * t25
    jacobian[..., 8] = -(s1 * t26)
    jacobian[..., 9] = t20 * t30 + t4 * t27
    jacobian[..., 10] = t8 * t23 - t7 * t29
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = -(c1 * t9 + s1 * t18)
    jacobian[..., 14] = c1 * (t9 - t2) + s1 * (t18 - t11)
    jacobian[..., 15] = t13 * t30 - t4 * t28
    jacobian[..., 16] = t8 * t16 + t7 * t17
    jacobian[..., 17] = 0.0
    return position.reshape(_leading + (3,)), jacobian.reshape(_leading + (3, 6))


def kinematics_pose(q):
    """pose and its Jacobian, in the base frame: 155 operations.

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
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s4 = np.sin(q4)
    s5 = np.sin(q5)
    s6 = np.sin(q6)

    # terms
    t1 = c1 * s2
    t2 = c1 * c2
    t3 = c3 * t1 - s3 * t2
    t4 = c4 * t3 - s1 * s4
    t5 = c3 * t2 + t1 * s3
    t6 = c5 * t4 - s5 * t5
    t7 = c4 * s1 + t3 * s4
    t8 = c5 * t5 + t4 * s5
    t9 = -t8
    t10 = 0.71 * t1
    t11 = t10 + 0.54 * t5
    t12 = 0.16 * t8
    t13 = t11 + 0.15 * t7 + t12
    t14 = s2 * s1
    t15 = c2 * s1
    t16 = c3 * t14 - s3 * t15
    t17 = c1 * s4 + c4 * t16
    t18 = c3 * t15 + s3 * t14
    t19 = c5 * t17 - s5 * t18
    t20 = c4 * c1 - s4 * t16
    t21 = c5 * t18 + s5 * t17
    t22 = -t21
    t23 = 0.71 * t14
    t24 = t23 + 0.54 * t18
    t25 = 0.16 * t21
    t26 = t24 - 0.15 * t20 + t25
    t27 = c3 * c2 + s2 * s3
    t28 = c4 * t27
    t29 = c3 * s2 - s3 * c2
    t30 = c5 * t28 + s5 * t29
    t31 = s4 * t27
    t32 = c5 * t29 - s5 * t28
    t33 = 0.71 * c2
    t34 = t33 - 0.54 * t29
    t35 = t34 + 0.15 * t31
    t36 = t35 - 0.16 * t32
    t37 = t36 - t33
    t38 = t36 - t34
    t39 = t26 - t24
    t40 = t36 - t35
    t41 = t13 - t11

    # results
    pose = np.empty((*_leading, 16), _real)
    jacobian = np.empty((*_leading, 36), _real)
    pose[..., 0] = c6 * t6 - s6 * t7
    pose[..., 1] = -(c6 * t7 + t6 * s6)
    pose[..., 2] = t9
    pose[..., 3] = t13
    pose[..., 4] = c6 * t19 + s6 * t20
    pose[..., 5] = c6 * t20 - s6 * t19
    pose[..., 6] = t22
    pose[..., 7] = t26
    pose[..., 8] = c6 * t30 - s6 * t31
    pose[..., 9] = -(c6 * t31 + s6 * t30)
    pose[..., 10] = t32
    pose[..., 11] = t36
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    jacobian[..., 0] = -t26
    jacobian[..., 1] = c1 * t36
    jacobian[..., 2] = -(c1 * t37)
    jacobian[..., 3] = -(t18 * t38 + t29 * t39)
    jacobian[..., 4] = -(t25 * t31 + t20 * t40)
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t13
    jacobian[..., 7] = s1 * t36
    jacobian[..., 8] = -(s1 * t37)
    jacobian[..., 9] = t29 * t41 + t5 * t38
    jacobian[..., 10] = t12 * t31 - t7 * t40
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = -(c1 * t13 + s1 * t26)
    jacobian[..., 14] = c1 * (t13 - t10) + s1 * (t26 - t23)
    jacobian[..., 15] = t18 * t41 - t5 * t39
    jacobian[..., 16] = t12 * t20 + t7 * t25
    jacobian[..., 17] = 0.0
    jacobian[..., 18] = 0.0
    jacobian[..., 19] = -s1
    jacobian[..., 20] = s1
    jacobian[..., 21] = -t5
    jacobian[..., 22] = t7
    jacobian[..., 23] = t9
    jacobian[..., 24] = 0.0
    jacobian[..., 25] = c1
    jacobian[..., 26] = -c1
    jacobian[..., 27] = -t18
    jacobian[..., 28] = -t20
    jacobian[..., 29] = t22
    jacobian[..., 30] = 1
    jacobian[..., 31] = 0.0
    jacobian[..., 32] = 0.0
    jacobian[..., 33] = t29
    jacobian[..., 34] = t31
    jacobian[..., 35] = t32
    return pose.reshape(_leading + (4, 4)), jacobian.reshape(_leading + (6, 6))
