"""kinematics of iiwa14, in NumPy.

Made from templates/kernel.py.j2; inputs ef4e01d1cda97e55e2643a34b278d96d99713179d8788b08f5ad0b6dde005d6b.
801 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def position(q):
    """position of the tip, in the base frame: 82 operations.

    in   q[7]
    out  position[3]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    s4 = np.sin(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s3 = np.sin(q3)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)

    # terms
    t1 = c1 * s2
    t2 = c1 * c2
    t3 = c3 * t2 - s1 * s3
    t4 = c4 * t1 - s4 * t3
    t5 = c5 * (c4 * t3 + t1 * s4) - s5 * (c3 * s1 + t2 * s3)
    t6 = 0.4 * t4 - -0.42 * t1 + 0.126 * (t4 * c6 + s6 * t5)
    t7 = s2 * s1
    t8 = c2 * s1
    t9 = c1 * s3 + c3 * t8
    t10 = c4 * t7 - s4 * t9
    t11 = c5 * (c4 * t9 + s4 * t7) + s5 * (c1 * c3 - s3 * t8)
    t12 = 0.4 * t10 - -0.42 * t7 + 0.126 * (c6 * t10 + s6 * t11)
    t13 = s2 * c3
    t14 = c4 * c2 + s4 * t13
    t15 = c5 * (s4 * c2 - c4 * t13) + s5 * (s2 * s3)
    t16 = 0.36 + 0.42 * c2 + 0.4 * t14 + 0.126 * (c6 * t14 + s6 * t15)

    # results
    position = np.empty((*_leading, 3), _real)
    position[..., 0] = t6
    position[..., 1] = t12
    position[..., 2] = t16
    return position.reshape(_leading + (3,))


def pose(q):
    """pose of the tip, in the base frame: 121 operations.

    in   q[7]
    out  pose[4][4]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q7 = q[..., 6]
    c7 = np.cos(q7)
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
    s1 = np.sin(q1)
    s3 = np.sin(q3)
    s4 = np.sin(q4)
    s2 = np.sin(q2)
    s5 = np.sin(q5)
    s6 = np.sin(q6)
    s7 = np.sin(q7)

    # terms
    t1 = c1 * c2
    t2 = c3 * t1 - s1 * s3
    t3 = c1 * s2
    t4 = c4 * t2 + s4 * t3
    t5 = c3 * s1 + t1 * s3
    t6 = c5 * t4 - s5 * t5
    t7 = c4 * t3 - t2 * s4
    t8 = c6 * t6 - s6 * t7
    t9 = c5 * t5 + t4 * s5
    t10 = c6 * t7 + t6 * s6
    t11 = c2 * s1
    t12 = c1 * s3 + c3 * t11
    t13 = s1 * s2
    t14 = c4 * t12 + s4 * t13
    t15 = c3 * c1 - s3 * t11
    t16 = c5 * t14 + s5 * t15
    t17 = c4 * t13 - s4 * t12
    t18 = c6 * t16 - s6 * t17
    t19 = c5 * t15 - s5 * t14
    t20 = c6 * t17 + s6 * t16
    t21 = c3 * s2
    t22 = c2 * s4 - c4 * t21
    t23 = s3 * s2
    t24 = c5 * t22 + s5 * t23
    t25 = c4 * c2 + s4 * t21
    t26 = c6 * t24 - s6 * t25
    t27 = c5 * t23 - s5 * t22
    t28 = c6 * t25 + s6 * t24

    # results
    pose = np.empty((*_leading, 16), _real)
    pose[..., 0] = c7 * t8 - s7 * t9
    pose[..., 1] = -(c7 * t9 + t8 * s7)
    pose[..., 2] = t10
    pose[..., 3] = 0.4 * t7 - -0.42 * t3 + 0.126 * t10
    pose[..., 4] = c7 * t18 + s7 * t19
    pose[..., 5] = c7 * t19 - s7 * t18
    pose[..., 6] = t20
    pose[..., 7] = 0.4 * t17 - -0.42 * t13 + 0.126 * t20
    pose[..., 8] = c7 * t26 + s7 * t27
    pose[..., 9] = c7 * t27 - s7 * t26
    pose[..., 10] = t28
    pose[..., 11] = 0.36 + 0.42 * c2 + 0.4 * t25 + 0.126 * t28
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    return pose.reshape(_leading + (4, 4))


def jacobian_position(q):
    """Jacobian of the position, in the base frame: 140 operations.

    in   q[7]
    out  jacobian[3][7]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q1 = q[..., 0]
    s1 = np.sin(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    s4 = np.sin(q4)
    c1 = np.cos(q1)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)
    c2 = np.cos(q2)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)

    # terms
    t1 = s1 * s2
    t2 = s1 * c2
    t3 = c1 * s3 + c3 * t2
    t4 = c4 * t1 - s4 * t3
    t5 = -0.42 * t1
    t6 = c4 * t3 + t1 * s4
    t7 = c1 * c3 - s3 * t2
    t8 = 0.126 * (t4 * c6 + s6 * (c5 * t6 + s5 * t7))
    t9 = 0.4 * t4 - t5 + t8
    t10 = 0.36 + 0.42 * c2
    t11 = s2 * c3
    t12 = c4 * c2 + s4 * t11
    t13 = s4 * c2 - c4 * t11
    t14 = s2 * s3
    t15 = 0.126 * (c6 * t12 + s6 * (c5 * t13 + s5 * t14))
    t16 = t10 + 0.4 * t12 + t15
    t17 = t16 - 0.36
    t18 = t16 - t10
    t19 = t5 + t9
    t20 = c5 * t7 - t6 * s5
    t21 = c5 * t14 - s5 * t13
    t22 = s2 * c1
    t23 = c1 * c2
    t24 = c3 * t23 - s1 * s3
    t25 = c4 * t22 - s4 * t24
    t26 = -0.42 * t22
    t27 = c4 * t24 + s4 * t22
    t28 = s1 * c3 + s3 * t23
    t29 = 0.126 * (c6 * t25 + s6 * (c5 * t27 - s5 * t28))
    t30 = 0.4 * t25 - t26 + t29
    t31 = t26 + t30
    t32 = c5 * t28 + s5 * t27

    # results
    jacobian = np.empty((*_leading, 21), _real)
    jacobian[..., 0] = -t9
    jacobian[..., 1] = c1 * t17
    jacobian[..., 2] = t1 * t18 - c2 * t19
    jacobian[..., 3] = t14 * t19 - t7 * t18
    jacobian[..., 4] = t4 * t15 - t8 * t12
    jacobian[..., 5] = t15 * t20 - t8 * t21
    jacobian[..., 6] = 0.0
    jacobian[..., 7] = t30
    jacobian[..., 8] = s1 * t17
    jacobian[..., 9] = c2 * t31 - t18 * t22
    jacobian[..., 10] = -(t18 * t28 + t14 * t31)
    jacobian[..., 11] = t12 * t29 - t15 * t25
    jacobian[..., 12] = t21 * t29 + t15 * t32
    jacobian[..., 13] = 0.0
    jacobian[..., 14] = 0.0
    jacobian[..., 15] = -(c1 * t30 + s1 * t9)
    jacobian[..., 16] = t19 * t22 - t1 * t31
    jacobian[..., 17] = t7 * t31 + t19 * t28
    jacobian[..., 18] = t8 * t25 - t4 * t29
    jacobian[..., 19] = -(t8 * t32 + t20 * t29)
    jacobian[..., 20] = 0.0
    return jacobian.reshape(_leading + (3, 7))


def jacobian_pose(q):
    """Jacobian of the pose, in the base frame: 144 operations.

    in   q[7]
    out  jacobian[6][7]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q1 = q[..., 0]
    s1 = np.sin(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    s4 = np.sin(q4)
    c1 = np.cos(q1)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)
    c2 = np.cos(q2)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)

    # terms
    t1 = s1 * s2
    t2 = s1 * c2
    t3 = c1 * s3 + c3 * t2
    t4 = c4 * t1 - s4 * t3
    t5 = -0.42 * t1
    t6 = c4 * t3 + t1 * s4
    t7 = c1 * c3 - s3 * t2
    t8 = t4 * c6 + s6 * (c5 * t6 + s5 * t7)
    t9 = 0.126 * t8
    t10 = 0.4 * t4 - t5 + t9
    t11 = 0.36 + 0.42 * c2
    t12 = s2 * c3
    t13 = c4 * c2 + s4 * t12
    t14 = s4 * c2 - c4 * t12
    t15 = s2 * s3
    t16 = c6 * t13 + s6 * (c5 * t14 + s5 * t15)
    t17 = 0.126 * t16
    t18 = t11 + 0.4 * t13 + t17
    t19 = t18 - 0.36
    t20 = t18 - t11
    t21 = t5 + t10
    t22 = c5 * t7 - t6 * s5
    t23 = c5 * t15 - s5 * t14
    t24 = s2 * c1
    t25 = c1 * c2
    t26 = c3 * t25 - s1 * s3
    t27 = c4 * t24 - s4 * t26
    t28 = -0.42 * t24
    t29 = c4 * t26 + s4 * t24
    t30 = s1 * c3 + s3 * t25
    t31 = c6 * t27 + s6 * (c5 * t29 - s5 * t30)
    t32 = 0.126 * t31
    t33 = 0.4 * t27 - t28 + t32
    t34 = t28 + t33
    t35 = c5 * t30 + s5 * t29

    # results
    jacobian = np.empty((*_leading, 42), _real)
    jacobian[..., 0] = -t10
    jacobian[..., 1] = c1 * t19
    jacobian[..., 2] = t1 * t20 - c2 * t21
    jacobian[..., 3] = t15 * t21 - t7 * t20
    jacobian[..., 4] = t4 * t17 - t9 * t13
    jacobian[..., 5] = t17 * t22 - t9 * t23
    jacobian[..., 6] = 0.0
    jacobian[..., 7] = t33
    jacobian[..., 8] = s1 * t19
    jacobian[..., 9] = c2 * t34 - t20 * t24
    jacobian[..., 10] = -(t20 * t30 + t15 * t34)
    jacobian[..., 11] = t13 * t32 - t17 * t27
    jacobian[..., 12] = t23 * t32 + t17 * t35
    jacobian[..., 13] = 0.0
    jacobian[..., 14] = 0.0
    jacobian[..., 15] = -(c1 * t33 + s1 * t10)
    jacobian[..., 16] = t21 * t24 - t1 * t34
    jacobian[..., 17] = t7 * t34 + t21 * t30
    jacobian[..., 18] = t9 * t27 - t4 * t32
    jacobian[..., 19] = -(t9 * t35 + t22 * t32)
    jacobian[..., 20] = 0.0
    jacobian[..., 21] = 0.0
    jacobian[..., 22] = -s1
    jacobian[..., 23] = t24
    jacobian[..., 24] = t30
    jacobian[..., 25] = t27
    jacobian[..., 26] = -t35
    jacobian[..., 27] = t31
    jacobian[..., 28] = 0.0
    jacobian[..., 29] = c1
    jacobian[..., 30] = t1
    jacobian[..., 31] = -t7
    jacobian[..., 32] = t4
    jacobian[..., 33] = t22
    jacobian[..., 34] = t8
    jacobian[..., 35] = 1
    jacobian[..., 36] = 0.0
    jacobian[..., 37] = c2
    jacobian[..., 38] = -t15
    jacobian[..., 39] = t13
    jacobian[..., 40] = t23
    jacobian[..., 41] = t16
    return jacobian.reshape(_leading + (6, 7))


def kinematics_position(q):
    """position and its Jacobian, in the base frame: 140 operations.

    in   q[7]
    out  position[3]
    out  jacobian[3][7]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    s4 = np.sin(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s3 = np.sin(q3)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)

    # terms
    t1 = c1 * s2
    t2 = c1 * c2
    t3 = c3 * t2 - s1 * s3
    t4 = c4 * t1 - s4 * t3
    t5 = -0.42 * t1
    t6 = c4 * t3 + t1 * s4
    t7 = c3 * s1 + t2 * s3
    t8 = 0.126 * (t4 * c6 + s6 * (c5 * t6 - s5 * t7))
    t9 = 0.4 * t4 - t5 + t8
    t10 = s2 * s1
    t11 = c2 * s1
    t12 = c1 * s3 + c3 * t11
    t13 = c4 * t10 - s4 * t12
    t14 = -0.42 * t10
    t15 = c4 * t12 + s4 * t10
    t16 = c1 * c3 - s3 * t11
    t17 = 0.126 * (c6 * t13 + s6 * (c5 * t15 + s5 * t16))
    t18 = 0.4 * t13 - t14 + t17
    t19 = 0.36 + 0.42 * c2
    t20 = s2 * c3
    t21 = c4 * c2 + s4 * t20
    t22 = s4 * c2 - c4 * t20
    t23 = s2 * s3
    t24 = 0.126 * (c6 * t21 + s6 * (c5 * t22 + s5 * t23))
    t25 = t19 + 0.4 * t21 + t24
    t26 = t25 - 0.36
    t27 = t25 - t19
    t28 = t14 + t18
    t29 = c5 * t16 - s5 * t15
    t30 = c5 * t23 - s5 * t22
    t31 = t5 + t9
    t32 = c5 * t7 + t6 * s5

    # results
    position = np.empty((*_leading, 3), _real)
    jacobian = np.empty((*_leading, 21), _real)
    position[..., 0] = t9
    position[..., 1] = t18
    position[..., 2] = t25
    jacobian[..., 0] = -t18
    jacobian[..., 1] = c1 * t26
    jacobian[..., 2] = t10 * t27 - c2 * t28
    jacobian[..., 3] = t23 * t28 - t16 * t27
    jacobian[..., 4] = t13 * t24 - t17 * t21
    jacobian[..., 5] = t24 * t29 - t17 * t30
    jacobian[..., 6] = 0.0
    jacobian[..., 7] = t9
    jacobian[..., 8] = s1 * t26
    jacobian[..., 9] = c2 * t31 - t1 * t27
    jacobian[..., 10] = -(t7 * t27 + t23 * t31)
    jacobian[..., 11] = t8 * t21 - t4 * t24
    jacobian[..., 12] = t8 * t30 + t24 * t32
    jacobian[..., 13] = 0.0
    jacobian[..., 14] = 0.0
    jacobian[..., 15] = -(c1 * t9 + s1 * t18)
    jacobian[..., 16] = t1 * t28 - t10 * t31
    jacobian[..., 17] = t16 * t31 + t7 * t28
    jacobian[..., 18] = t4 * t17 - t8 * t13
    jacobian[..., 19] = -(t17 * t32 + t8 * t29)
    jacobian[..., 20] = 0.0
    return position.reshape(_leading + (3,)), jacobian.reshape(_leading + (3, 7))


def kinematics_pose(q):
    """pose and its Jacobian, in the base frame: 174 operations.

    in   q[7]
    out  pose[4][4]
    out  jacobian[6][7]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q7 = q[..., 6]
    c7 = np.cos(q7)
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
    s1 = np.sin(q1)
    s3 = np.sin(q3)
    s4 = np.sin(q4)
    s2 = np.sin(q2)
    s5 = np.sin(q5)
    s6 = np.sin(q6)
    s7 = np.sin(q7)

    # terms
    t1 = c1 * c2
    t2 = c3 * t1 - s1 * s3
    t3 = c1 * s2
    t4 = c4 * t2 + s4 * t3
    t5 = c3 * s1 + t1 * s3
    t6 = c5 * t4 - s5 * t5
    t7 = c4 * t3 - t2 * s4
    t8 = c6 * t6 - s6 * t7
    t9 = c5 * t5 + t4 * s5
    t10 = c6 * t7 + t6 * s6
    t11 = -0.42 * t3
    t12 = 0.126 * t10
    t13 = 0.4 * t7 - t11 + t12
    t14 = c2 * s1
    t15 = c1 * s3 + c3 * t14
    t16 = s1 * s2
    t17 = c4 * t15 + s4 * t16
    t18 = c3 * c1 - s3 * t14
    t19 = c5 * t17 + s5 * t18
    t20 = c4 * t16 - s4 * t15
    t21 = c6 * t19 - s6 * t20
    t22 = c5 * t18 - s5 * t17
    t23 = c6 * t20 + s6 * t19
    t24 = -0.42 * t16
    t25 = 0.126 * t23
    t26 = 0.4 * t20 - t24 + t25
    t27 = c3 * s2
    t28 = c2 * s4 - c4 * t27
    t29 = s3 * s2
    t30 = c5 * t28 + s5 * t29
    t31 = c4 * c2 + s4 * t27
    t32 = c6 * t30 - s6 * t31
    t33 = c5 * t29 - s5 * t28
    t34 = c6 * t31 + s6 * t30
    t35 = 0.36 + 0.42 * c2
    t36 = 0.126 * t34
    t37 = t35 + 0.4 * t31 + t36
    t38 = t37 - 0.36
    t39 = t37 - t35
    t40 = t24 + t26
    t41 = t11 + t13

    # results
    pose = np.empty((*_leading, 16), _real)
    jacobian = np.empty((*_leading, 42), _real)
    pose[..., 0] = c7 * t8 - s7 * t9
    pose[..., 1] = -(c7 * t9 + t8 * s7)
    pose[..., 2] = t10
    pose[..., 3] = t13
    pose[..., 4] = c7 * t21 + s7 * t22
    pose[..., 5] = c7 * t22 - s7 * t21
    pose[..., 6] = t23
    pose[..., 7] = t26
    pose[..., 8] = c7 * t32 + s7 * t33
    pose[..., 9] = c7 * t33 - s7 * t32
    pose[..., 10] = t34
    pose[..., 11] = t37
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    jacobian[..., 0] = -t26
    jacobian[..., 1] = c1 * t38
    jacobian[..., 2] = t16 * t39 - c2 * t40
    jacobian[..., 3] = t29 * t40 - t18 * t39
    jacobian[..., 4] = t20 * t36 - t25 * t31
    jacobian[..., 5] = t22 * t36 - t25 * t33
    jacobian[..., 6] = 0.0
    jacobian[..., 7] = t13
    jacobian[..., 8] = s1 * t38
    jacobian[..., 9] = c2 * t41 - t3 * t39
    jacobian[..., 10] = -(t5 * t39 + t29 * t41)
    jacobian[..., 11] = t12 * t31 - t7 * t36
    jacobian[..., 12] = t12 * t33 + t9 * t36
    jacobian[..., 13] = 0.0
    jacobian[..., 14] = 0.0
    jacobian[..., 15] = -(c1 * t13 + s1 * t26)
    jacobian[..., 16] = t3 * t40 - t16 * t41
    jacobian[..., 17] = t18 * t41 + t5 * t40
    jacobian[..., 18] = t7 * t25 - t12 * t20
    jacobian[..., 19] = -(t9 * t25 + t12 * t22)
    jacobian[..., 20] = 0.0
    jacobian[..., 21] = 0.0
    jacobian[..., 22] = -s1
    jacobian[..., 23] = t3
    jacobian[..., 24] = t5
    jacobian[..., 25] = t7
    jacobian[..., 26] = -t9
    jacobian[..., 27] = t10
    jacobian[..., 28] = 0.0
    jacobian[..., 29] = c1
    jacobian[..., 30] = t16
    jacobian[..., 31] = -t18
    jacobian[..., 32] = t20
    jacobian[..., 33] = t22
    jacobian[..., 34] = t23
    jacobian[..., 35] = 1
    jacobian[..., 36] = 0.0
    jacobian[..., 37] = c2
    jacobian[..., 38] = -t29
    jacobian[..., 39] = t31
    jacobian[..., 40] = t33
    jacobian[..., 41] = t34
    return pose.reshape(_leading + (4, 4)), jacobian.reshape(_leading + (6, 7))
