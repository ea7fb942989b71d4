"""kinematics of gofa5, in NumPy.

Made from templates/kernel.py.j2; inputs 77ec5af2bde83c10512a434926d3132b7399245fe89b083418efb2418b8906e7.
756 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def position(q):
    """position of the tip, in the base frame: 85 operations.

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
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s1 = np.sin(q1)
    s4 = np.sin(q4)

    # terms
    t1 = c1 * s2
    t2 = c1 * c2
    t3 = c3 * t2 - t1 * s3
    t4 = t1 * c3 + t2 * s3
    t5 = t4 * c4 + s1 * s4
    t6 = 0.444 * t1 + 0.47 * t3 + 0.11 * t4 + 0.101 * (t3 * c5 - s5 * t5)
    t7 = s2 * s1
    t8 = c2 * s1
    t9 = c3 * t8 - s3 * t7
    t10 = c3 * t7 + s3 * t8
    t11 = c4 * t10 - c1 * s4
    t12 = 0.444 * t7 + 0.47 * t9 + 0.11 * t10 + 0.101 * (c5 * t9 - s5 * t11)
    t13 = c2 * s3 + s2 * c3
    t14 = c3 * c2 - s2 * s3
    t15 = c4 * t14
    t16 = 0.265 + 0.444 * c2 - 0.47 * t13 + 0.11 * t14 - 0.101 * (c5 * t13 + s5 * t15)

    # results
    position = np.empty((*_leading, 3), _real)
    position[..., 0] = t6 + 0.08 * (c5 * t5 + t3 * s5)
    position[..., 1] = t12 + 0.08 * (c5 * t11 + s5 * t9)
    position[..., 2] = t16 + 0.08 * (c5 * t15 - s5 * t13)
    return position.reshape(_leading + (3,))


def pose(q):
    """pose of the tip, in the base frame: 114 operations.

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
    t3 = c3 * t1 + s3 * t2
    t4 = c4 * t3 + s1 * s4
    t5 = c3 * t2 - t1 * s3
    t6 = c5 * t4 + s5 * t5
    t7 = c4 * s1 - t3 * s4
    t8 = c5 * t5 - t4 * s5
    t9 = 0.444 * t1 + 0.47 * t5 + 0.11 * t3 + 0.101 * t8
    t10 = s2 * s1
    t11 = c2 * s1
    t12 = c3 * t10 + s3 * t11
    t13 = c4 * c1 + s4 * t12
    t14 = c4 * t12 - c1 * s4
    t15 = c3 * t11 - s3 * t10
    t16 = c5 * t14 + s5 * t15
    t17 = c5 * t15 - s5 * t14
    t18 = 0.444 * t10 + 0.47 * t15 + 0.11 * t12 + 0.101 * t17
    t19 = c3 * c2 - s2 * s3
    t20 = s4 * t19
    t21 = c4 * t19
    t22 = s3 * c2 + c3 * s2
    t23 = c5 * t21 - s5 * t22
    t24 = c5 * t22 + s5 * t21
    t25 = 0.265 + 0.444 * c2 - 0.47 * t22 + 0.11 * t19 - 0.101 * t24

    # results
    pose = np.empty((*_leading, 16), _real)
    pose[..., 0] = -(c6 * t6 + s6 * t7)
    pose[..., 1] = t6 * s6 - c6 * t7
    pose[..., 2] = t8
    pose[..., 3] = t9 + 0.08 * t6
    pose[..., 4] = s6 * t13 - c6 * t16
    pose[..., 5] = s6 * t16 + c6 * t13
    pose[..., 6] = t17
    pose[..., 7] = t18 + 0.08 * t16
    pose[..., 8] = s6 * t20 - c6 * t23
    pose[..., 9] = s6 * t23 + c6 * t20
    pose[..., 10] = -t24
    pose[..., 11] = t25 + 0.08 * t23
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    return pose.reshape(_leading + (4, 4))


def jacobian_position(q):
    """Jacobian of the position, in the base frame: 132 operations.

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
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    c1 = np.cos(q1)
    s4 = np.sin(q4)

    # terms
    t1 = s1 * s2
    t2 = 0.444 * t1
    t3 = s1 * c2
    t4 = c3 * t3 - t1 * s3
    t5 = t1 * c3 + t3 * s3
    t6 = t2 + 0.47 * t4 + 0.11 * t5
    t7 = t5 * c4 - c1 * s4
    t8 = t6 + 0.101 * (t4 * c5 - s5 * t7) + 0.08 * (c5 * t7 + t4 * s5)
    t9 = 0.265 + 0.444 * c2
    t10 = c2 * s3 + s2 * c3
    t11 = c3 * c2 - s2 * s3
    t12 = t9 - 0.47 * t10 + 0.11 * t11
    t13 = c4 * t11
    t14 = t12 - 0.101 * (c5 * t10 + s5 * t13) + 0.08 * (c5 * t13 - s5 * t10)
    t15 = t14 - 0.265
    t16 = t14 - t9
    t17 = t14 - t12
    t18 = t8 - t6
    t19 = c4 * c1 + t5 * s4
    t20 = s4 * t11
    t21 = s2 * c1
    t22 = 0.444 * t21
    t23 = c2 * c1
    t24 = c3 * t23 - s3 * t21
    t25 = c3 * t21 + s3 * t23
    t26 = t22 + 0.47 * t24 + 0.11 * t25
    t27 = c4 * t25 + s1 * s4
    t28 = t26 + 0.101 * (c5 * t24 - s5 * t27) + 0.08 * (c5 * t27 + s5 * t24)
    t29 = t28 - t26
    t30 = s1 * c4 - s4 * t25

    # results
    jacobian = np.empty((*_leading, 18), _real)
    jacobian[..., 0] = -t8
    jacobian[..., 1] = c1 * t15
    jacobian[..., 2] = c1 * t16
    jacobian[..., 3] = t4 * t17 + t10 * t18
    jacobian[..., 4] = t17 * t19 - t18 * t20
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t28
    jacobian[..., 7] = s1 * t15
    jacobian[..., 8] = s1 * t16
    jacobian[..., 9] = -(t10 * t29 + t17 * t24)
    jacobian[..., 10] = t17 * t30 + t20 * t29
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = -(c1 * t28 + s1 * t8)
    jacobian[..., 14] = -(c1 * (t28 - t22) + s1 * (t8 - t2))
    jacobian[..., 15] = t18 * t24 - t4 * t29
    jacobian[..., 16] = -(t19 * t29 + t18 * t30)
    jacobian[..., 17] = 0.0
    return jacobian.reshape(_leading + (3, 6))


def jacobian_pose(q):
    """Jacobian of the pose, in the base frame: 136 operations.

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
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    c1 = np.cos(q1)
    s4 = np.sin(q4)

    # terms
    t1 = s1 * s2
    t2 = 0.444 * t1
    t3 = s1 * c2
    t4 = c3 * t3 - t1 * s3
    t5 = t1 * c3 + t3 * s3
    t6 = t2 + 0.47 * t4 + 0.11 * t5
    t7 = t5 * c4 - c1 * s4
    t8 = t4 * c5 - s5 * t7
    t9 = t6 + 0.101 * t8 + 0.08 * (c5 * t7 + t4 * s5)
    t10 = 0.265 + 0.444 * c2
    t11 = c2 * s3 + s2 * c3
    t12 = c3 * c2 - s2 * s3
    t13 = t10 - 0.47 * t11 + 0.11 * t12
    t14 = c4 * t12
    t15 = c5 * t11 + s5 * t14
    t16 = t13 - 0.101 * t15 + 0.08 * (c5 * t14 - s5 * t11)
    t17 = t16 - 0.265
    t18 = t16 - t10
    t19 = t16 - t13
    t20 = t9 - t6
    t21 = c4 * c1 + t5 * s4
    t22 = s4 * t12
    t23 = s2 * c1
    t24 = 0.444 * t23
    t25 = c2 * c1
    t26 = c3 * t25 - s3 * t23
    t27 = c3 * t23 + s3 * t25
    t28 = t24 + 0.47 * t26 + 0.11 * t27
    t29 = c4 * t27 + s1 * s4
    t30 = c5 * t26 - s5 * t29
    t31 = t28 + 0.101 * t30 + 0.08 * (c5 * t29 + s5 * t26)
    t32 = t31 - t28
    t33 = s1 * c4 - s4 * t27
    t34 = -s1

    # results
    jacobian = np.empty((*_leading, 36), _real)
    jacobian[..., 0] = -t9
    jacobian[..., 1] = c1 * t17
    jacobian[..., 2] = c1 * t18
    jacobian[..., 3] = t4 * t19 + t11 * t20
    jacobian[..., 4] = t19 * t21 - t20 * t22
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t31
    jacobian[..., 7] = s1 * t17
    jacobian[..., 8] = s1 * t18
    jacobian[..., 9] = -(t11 * t32 + t19 * t26)
    jacobian[..., 10] = t19 * t33 + t22 * t32
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = -(c1 * t31 + s1 * t9)
    jacobian[..., 14] = -(c1 * (t31 - t24) + s1 * (t9 - t2))
    jacobian[..., 15] = t20 * t26 - t4 * t32
    jacobian[..., 16] = -(t21 * t32 + t20 * t33)
    jacobian[..., 17] = 0.0
    jacobian[..., 18] = 0.0
    jacobian[..., 19] = t34
    jacobian[..., 20] = t34
    jacobian[..., 21] = t26
    jacobian[..., 22] = -t33
    jacobian[..., 23] = t30
    jacobian[..., 24] = 0.0
    jacobian[..., 25] = c1
    jacobian[..., 26] = c1
    jacobian[..., 27] = t4
    jacobian[..., 28] = t21
    jacobian[..., 29] = t8
    jacobian[..., 30] = 1
    jacobian[..., 31] = 0.0
    jacobian[..., 32] = 0.0
    jacobian[..., 33] = -t11
    jacobian[..., 34] = t22
    jacobian[..., 35] = -t15
    return jacobian.reshape(_leading + (6, 6))


def kinematics_position(q):
    """position and its Jacobian, in the base frame: 132 operations.

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
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s1 = np.sin(q1)
    s4 = np.sin(q4)

    # terms
    t1 = c1 * s2
    t2 = 0.444 * t1
    t3 = c1 * c2
    t4 = c3 * t3 - t1 * s3
    t5 = t1 * c3 + t3 * s3
    t6 = t2 + 0.47 * t4 + 0.11 * t5
    t7 = t5 * c4 + s1 * s4
    t8 = t6 + 0.101 * (t4 * c5 - s5 * t7) + 0.08 * (c5 * t7 + t4 * s5)
    t9 = s2 * s1
    t10 = 0.444 * t9
    t11 = c2 * s1
    t12 = c3 * t11 - s3 * t9
    t13 = c3 * t9 + s3 * t11
    t14 = t10 + 0.47 * t12 + 0.11 * t13
    t15 = c4 * t13 - c1 * s4
    t16 = t14 + 0.101 * (c5 * t12 - s5 * t15) + 0.08 * (c5 * t15 + s5 * t12)
    t17 = 0.265 + 0.444 * c2
    t18 = c2 * s3 + s2 * c3
    t19 = c3 * c2 - s2 * s3
    t20 = t17 - 0.47 * t18 + 0.11 * t19
    t21 = c4 * t19
    t22 = t20 - 0.101 * (c5 * t18 + s5 * t21) + 0.08 * (c5 * t21 - s5 * t18)
    t23 = t22 - 0.265
    t24 = t22 - t17
    t25 = t22 - t20
    t26 = t16 - t14
    t27 = c1 * c4 + s4 * t13
    t28 = s4 * t19
    t29 = t8 - t6
    t30 = c4 * s1 - t5 * s4

    # results
    position = np.empty((*_leading, 3), _real)
    jacobian = np.empty((*_leading, 18), _real)
    position[..., 0] = t8
    position[..., 1] = t16
    position[..., 2] = t22
    jacobian[..., 0] = -t16
    jacobian[..., 1] = c1 * t23
    jacobian[..., 2] = c1 * t24
    jacobian[..., 3] = t12 * t25 + t18 * t26
    jacobian[..., 4] = t25 * t27 - t26 * t28
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t8
    jacobian[..., 7] = s1 * t23
    jacobian[..., 8] = s1 * t24
    jacobian[..., 9] = -(t18 * t29 + t4 * t25)
    jacobian[..., 10] = t25 * t30 + t28 * t29
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = -(c1 * t8 + s1 * t16)
    jacobian[..., 14] = -(c1 * (t8 - t2) + s1 * (t16 - t10))
    jacobian[..., 15] = t4 * t26 - t12 * t29
    jacobian[..., 16] = -(t27 * t29 + t26 * t30)
    jacobian[..., 17] = 0.0
    return position.reshape(_leading + (3,)), jacobian.reshape(_leading + (3, 6))


def kinematics_pose(q):
    """pose and its Jacobian, in the base frame: 157 operations.

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
    t3 = c3 * t1 + s3 * t2
    t4 = c4 * t3 + s1 * s4
    t5 = c3 * t2 - t1 * s3
    t6 = c5 * t4 + s5 * t5
    t7 = c4 * s1 - t3 * s4
    t8 = c5 * t5 - t4 * s5
    t9 = 0.444 * t1
    t10 = t9 + 0.47 * t5 + 0.11 * t3
    t11 = t10 + 0.101 * t8 + 0.08 * t6
    t12 = s2 * s1
    t13 = c2 * s1
    t14 = c3 * t12 + s3 * t13
    t15 = c4 * c1 + s4 * t14
    t16 = c4 * t14 - c1 * s4
    t17 = c3 * t13 - s3 * t12
    t18 = c5 * t16 + s5 * t17
    t19 = c5 * t17 - s5 * t16
    t20 = 0.444 * t12
    t21 = t20 + 0.47 * t17 + 0.11 * t14
    t22 = t21 + 0.101 * t19 + 0.08 * t18
    t23 = c3 * c2 - s2 * s3
    t24 = s4 * t23
    t25 = c4 * t23
    t26 = s3 * c2 + c3 * s2
    t27 = c5 * t25 - s5 * t26
    t28 = c5 * t26 + s5 * t25
    t29 = -t28
    t30 = 0.265 + 0.444 * c2
    t31 = t30 - 0.47 * t26 + 0.11 * t23
    t32 = t31 - 0.101 * t28 + 0.08 * t27
    t33 = t32 - 0.265
    t34 = t32 - t30
    t35 = t32 - t31
    t36 = t22 - t21
    t37 = t11 - t10
    t38 = -s1

    # results
    pose = np.empty((*_leading, 16), _real)
    jacobian = np.empty((*_leading, 36), _real)
    pose[..., 0] = -(c6 * t6 + s6 * t7)
    pose[..., 1] = t6 * s6 - c6 * t7
    pose[..., 2] = t8
    pose[..., 3] = t11
    pose[..., 4] = s6 * t15 - c6 * t18
    pose[..., 5] = s6 * t18 + c6 * t15
    pose[..., 6] = t19
    pose[..., 7] = t22
    pose[..., 8] = s6 * t24 - c6 * t27
    pose[..., 9] = s6 * t27 + c6 * t24
    pose[..., 10] = t29
    pose[..., 11] = t32
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    jacobian[..., 0] = -t22
    jacobian[..., 1] = c1 * t33
    jacobian[..., 2] = c1 * t34
    jacobian[..., 3] = t17 * t35 + t26 * t36
    jacobian[..., 4] = t15 * t35 - t24 * t36
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t11
    jacobian[..., 7] = s1 * t33
    jacobian[..., 8] = s1 * t34
    jacobian[..., 9] = -(t26 * t37 + t5 * t35)
    jacobian[..., 10] = t7 * t35 + t24 * t37
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = -(c1 * t11 + s1 * t22)
    jacobian[..., 14] = -(c1 * (t11 - t9) + s1 * (t22 - t20))
    jacobian[..., 15] = t5 * t36 - t17 * t37
    jacobian[..., 16] = -(t15 * t37 + t7 * t36)
    jacobian[..., 17] = 0.0
    jacobian[..., 18] = 0.0
    jacobian[..., 19] = t38
    jacobian[..., 20] = t38
    jacobian[..., 21] = t5
    jacobian[..., 22] = -t7
    jacobian[..., 23] = t8
    jacobian[..., 24] = 0.0
    jacobian[..., 25] = c1
    jacobian[..., 26] = c1
    jacobian[..., 27] = t17
    jacobian[..., 28] = t15
    jacobian[..., 29] = t19
    jacobian[..., 30] = 1
    jacobian[..., 31] = 0.0
    jacobian[..., 32] = 0.0
    jacobian[..., 33] = -t26
    jacobian[..., 34] = t24
    jacobian[..., 35] = t29
    return pose.reshape(_leading + (4, 4)), jacobian.reshape(_leading + (6, 6))
