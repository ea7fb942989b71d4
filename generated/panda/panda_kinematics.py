"""kinematics of panda, in NumPy.

Made from templates/kernel.py.j2; inputs 3d75968c9b8709666685fb83d25a26b653448fa96f52cdbdae90d2c2a8257563.
1030 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def position(q):
    """position of the tip, in the base frame: 109 operations.

    in   q[7]
    out  position[3]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

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
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    s6 = np.sin(q6)

    # terms
    t1 = c1 * c2
    t2 = c3 * t1 - s1 * s3
    t3 = c1 * s2
    t4 = t3 * c4 - t2 * s4
    t5 = t2 * c4 + t3 * s4
    t6 = 0.0825 * t2 - -0.316 * t3 + 0.384 * t4 - 0.0825 * t5
    t7 = t5 * c5 - s5 * (c3 * s1 + t1 * s3)
    t8 = t6 + 0.088 * (c6 * t7 + t4 * s6) - 0.107 * (t4 * c6 - t7 * s6)
    t9 = c2 * s1
    t10 = c1 * s3 + c3 * t9
    t11 = s1 * s2
    t12 = c4 * t11 - s4 * t10
    t13 = c4 * t10 + s4 * t11
    t14 = 0.0825 * t10 - -0.316 * t11 + 0.384 * t12 - 0.0825 * t13
    t15 = c5 * t13 + s5 * (c3 * c1 - s3 * t9)
    t16 = t14 + 0.088 * (c6 * t15 + s6 * t12) - 0.107 * (c6 * t12 - s6 * t15)
    t17 = c3 * s2
    t18 = c2 * c4 + s4 * t17
    t19 = c2 * s4 - c4 * t17
    t20 = 0.333 + 0.316 * c2 - 0.0825 * t17 + 0.384 * t18 - 0.0825 * t19
    t21 = c5 * t19 + s5 * (s3 * s2)
    t22 = t20 + 0.088 * (c6 * t21 + s6 * t18) - 0.107 * (c6 * t18 - s6 * t21)

    # results
    position = np.empty((*_leading, 3), _real)
    position[..., 0] = t8
    position[..., 1] = t16
    position[..., 2] = t22
    return position.reshape(_leading + (3,))


def pose(q):
    """pose of the tip, in the base frame: 143 operations.

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
    t8 = c6 * t6 + s6 * t7
    t9 = c5 * t5 + t4 * s5
    t10 = c6 * t7 - t6 * s6
    t11 = 0.0825 * t2 - -0.316 * t3 + 0.384 * t7 - 0.0825 * t4
    t12 = c2 * s1
    t13 = c1 * s3 + c3 * t12
    t14 = s1 * s2
    t15 = c4 * t13 + s4 * t14
    t16 = c3 * c1 - s3 * t12
    t17 = c5 * t15 + s5 * t16
    t18 = c4 * t14 - s4 * t13
    t19 = c6 * t17 + s6 * t18
    t20 = c5 * t16 - s5 * t15
    t21 = c6 * t18 - s6 * t17
    t22 = 0.0825 * t13 - -0.316 * t14 + 0.384 * t18 - 0.0825 * t15
    t23 = c3 * s2
    t24 = c2 * s4 - c4 * t23
    t25 = s3 * s2
    t26 = c5 * t24 + s5 * t25
    t27 = c4 * c2 + s4 * t23
    t28 = c6 * t26 + s6 * t27
    t29 = c5 * t25 - s5 * t24
    t30 = c6 * t27 - s6 * t26
    t31 = 0.333 + 0.316 * c2 - 0.0825 * t23 + 0.384 * t27 - 0.0825 * t24

    # results
    pose = np.empty((*_leading, 16), _real)
    pose[..., 0] = c7 * t8 + s7 * t9
    pose[..., 1] = c7 * t9 - t8 * s7
    pose[..., 2] = -t10
    pose[..., 3] = t11 + 0.088 * t8 - 0.107 * t10
    pose[..., 4] = c7 * t19 - s7 * t20
    pose[..., 5] = -(c7 * t20 + s7 * t19)
    pose[..., 6] = -t21
    pose[..., 7] = t22 + 0.088 * t19 - 0.107 * t21
    pose[..., 8] = c7 * t28 - s7 * t29
    pose[..., 9] = -(c7 * t29 + s7 * t28)
    pose[..., 10] = -t30
    pose[..., 11] = t31 + 0.088 * t28 - 0.107 * t30
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    return pose.reshape(_leading + (4, 4))


def jacobian_position(q):
    """Jacobian of the position, in the base frame: 185 operations.

    in   q[7]
    out  jacobian[3][7]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    s6 = np.sin(q6)

    # terms
    t1 = c2 * s1
    t2 = c1 * s3 + c3 * t1
    t3 = s1 * s2
    t4 = -0.316 * t3
    t5 = 0.0825 * t2 - t4
    t6 = t3 * c4 - t2 * s4
    t7 = t2 * c4 + t3 * s4
    t8 = t5 + 0.384 * t6 - 0.0825 * t7
    t9 = c1 * c3 - s3 * t1
    t10 = t7 * c5 + s5 * t9
    t11 = t8 + 0.088 * (c6 * t10 + t6 * s6)
    t12 = t6 * c6 - t10 * s6
    t13 = t11 - 0.107 * t12
    t14 = 0.333 + 0.316 * c2
    t15 = c3 * s2
    t16 = t14 - 0.0825 * t15
    t17 = c2 * c4 + s4 * t15
    t18 = c2 * s4 - c4 * t15
    t19 = t16 + 0.384 * t17 - 0.0825 * t18
    t20 = s3 * s2
    t21 = c5 * t18 + s5 * t20
    t22 = t19 + 0.088 * (c6 * t21 + s6 * t17)
    t23 = c6 * t17 - s6 * t21
    t24 = t22 - 0.107 * t23
    t25 = t24 - 0.333
    t26 = t24 - t14
    t27 = t4 + t13
    t28 = t13 - t5
    t29 = t24 - t16
    t30 = t24 - t19
    t31 = t13 - t8
    t32 = c5 * t20 - s5 * t18
    t33 = c5 * t9 - t7 * s5
    t34 = t13 - t11
    t35 = t24 - t22
    t36 = c1 * c2
    t37 = c3 * t36 - s3 * s1
    t38 = c1 * s2
    t39 = -0.316 * t38
    t40 = 0.0825 * t37 - t39
    t41 = c4 * t38 - s4 * t37
    t42 = c4 * t37 + s4 * t38
    t43 = t40 + 0.384 * t41 - 0.0825 * t42
    t44 = c3 * s1 + s3 * t36
    t45 = c5 * t42 - s5 * t44
    t46 = t43 + 0.088 * (c6 * t45 + s6 * t41)
    t47 = c6 * t41 - s6 * t45
    t48 = t46 - 0.107 * t47
    t49 = t39 + t48
    t50 = t48 - t40
    t51 = t48 - t43
    t52 = c5 * t44 + s5 * t42
    t53 = t48 - t46

    # results
    jacobian = np.empty((*_leading, 21), _real)
    jacobian[..., 0] = -t13
    jacobian[..., 1] = c1 * t25
    jacobian[..., 2] = t3 * t26 - c2 * t27
    jacobian[..., 3] = t20 * t28 - t9 * t29
    jacobian[..., 4] = t6 * t30 - t17 * t31
    jacobian[..., 5] = t31 * t32 - t30 * t33
    jacobian[..., 6] = t23 * t34 - t12 * t35
    jacobian[..., 7] = t48
    jacobian[..., 8] = s1 * t25
    jacobian[..., 9] = c2 * t49 - t26 * t38
    jacobian[..., 10] = -(t29 * t44 + t20 * t50)
    jacobian[..., 11] = t17 * t51 - t30 * t41
    jacobian[..., 12] = -(t30 * t52 + t32 * t51)
    jacobian[..., 13] = t35 * t47 - t23 * t53
    jacobian[..., 14] = 0.0
    jacobian[..., 15] = -(c1 * t48 + s1 * t13)
    jacobian[..., 16] = t27 * t38 - t3 * t49
    jacobian[..., 17] = t9 * t50 + t28 * t44
    jacobian[..., 18] = t31 * t41 - t6 * t51
    jacobian[..., 19] = t33 * t51 + t31 * t52
    jacobian[..., 20] = t12 * t53 - t34 * t47
    return jacobian.reshape(_leading + (3, 7))


def jacobian_pose(q):
    """Jacobian of the pose, in the base frame: 193 operations.

    in   q[7]
    out  jacobian[6][7]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    s6 = np.sin(q6)

    # terms
    t1 = c2 * s1
    t2 = c1 * s3 + c3 * t1
    t3 = s1 * s2
    t4 = -0.316 * t3
    t5 = 0.0825 * t2 - t4
    t6 = t3 * c4 - t2 * s4
    t7 = t2 * c4 + t3 * s4
    t8 = t5 + 0.384 * t6 - 0.0825 * t7
    t9 = c1 * c3 - s3 * t1
    t10 = t7 * c5 + s5 * t9
    t11 = t8 + 0.088 * (c6 * t10 + t6 * s6)
    t12 = t6 * c6 - t10 * s6
    t13 = t11 - 0.107 * t12
    t14 = 0.333 + 0.316 * c2
    t15 = c3 * s2
    t16 = t14 - 0.0825 * t15
    t17 = c2 * c4 + s4 * t15
    t18 = c2 * s4 - c4 * t15
    t19 = t16 + 0.384 * t17 - 0.0825 * t18
    t20 = s3 * s2
    t21 = c5 * t18 + s5 * t20
    t22 = t19 + 0.088 * (c6 * t21 + s6 * t17)
    t23 = c6 * t17 - s6 * t21
    t24 = t22 - 0.107 * t23
    t25 = t24 - 0.333
    t26 = t24 - t14
    t27 = t4 + t13
    t28 = t13 - t5
    t29 = t24 - t16
    t30 = t24 - t19
    t31 = t13 - t8
    t32 = c5 * t20 - s5 * t18
    t33 = c5 * t9 - t7 * s5
    t34 = t13 - t11
    t35 = t24 - t22
    t36 = c1 * c2
    t37 = c3 * t36 - s3 * s1
    t38 = c1 * s2
    t39 = -0.316 * t38
    t40 = 0.0825 * t37 - t39
    t41 = c4 * t38 - s4 * t37
    t42 = c4 * t37 + s4 * t38
    t43 = t40 + 0.384 * t41 - 0.0825 * t42
    t44 = c3 * s1 + s3 * t36
    t45 = c5 * t42 - s5 * t44
    t46 = t43 + 0.088 * (c6 * t45 + s6 * t41)
    t47 = c6 * t41 - s6 * t45
    t48 = t46 - 0.107 * t47
    t49 = t39 + t48
    t50 = t48 - t40
    t51 = t48 - t43
    t52 = c5 * t44 + s5 * t42
    t53 = t48 - t46

    # results
    jacobian = np.empty((*_leading, 42), _real)
    jacobian[..., 0] = -t13
    jacobian[..., 1] = c1 * t25
    jacobian[..., 2] = t3 * t26 - c2 * t27
    jacobian[..., 3] = t20 * t28 - t9 * t29
    jacobian[..., 4] = t6 * t30 - t17 * t31
    jacobian[..., 5] = t31 * t32 - t30 * t33
    jacobian[..., 6] = t23 * t34 - t12 * t35
    jacobian[..., 7] = t48
    jacobian[..., 8] = s1 * t25
    jacobian[..., 9] = c2 * t49 - t26 * t38
    jacobian[..., 10] = -(t29 * t44 + t20 * t50)
    jacobian[..., 11] = t17 * t51 - t30 * t41
    jacobian[..., 12] = -(t30 * t52 + t32 * t51)
    jacobian[..., 13] = t35 * t47 - t23 * t53
    jacobian[..., 14] = 0.0
    jacobian[..., 15] = -(c1 * t48 + s1 * t13)
    jacobian[..., 16] = t27 * t38 - t3 * t49
    jacobian[..., 17] = t9 * t50 + t28 * t44
    jacobian[..., 18] = t31 * t41 - t6 * t51
    jacobian[..., 19] = t33 * t51 + t31 * t52
    jacobian[..., 20] = t12 * t53 - t34 * t47
    jacobian[..., 21] = 0.0
    jacobian[..., 22] = -s1
    jacobian[..., 23] = t38
    jacobian[..., 24] = t44
    jacobian[..., 25] = t41
    jacobian[..., 26] = t52
    jacobian[..., 27] = -t47
    jacobian[..., 28] = 0.0
    jacobian[..., 29] = c1
    jacobian[..., 30] = t3
    jacobian[..., 31] = -t9
    jacobian[..., 32] = t6
    jacobian[..., 33] = -t33
    jacobian[..., 34] = -t12
    jacobian[..., 35] = 1
    jacobian[..., 36] = 0.0
    jacobian[..., 37] = c2
    jacobian[..., 38] = -t20
    jacobian[..., 39] = t17
    jacobian[..., 40] = -t32
    jacobian[..., 41] = -t23
    return jacobian.reshape(_leading + (6, 7))


def kinematics_position(q):
    """position and its Jacobian, in the base frame: 185 operations.

    in   q[7]
    out  position[3]
    out  jacobian[3][7]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

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
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    s6 = np.sin(q6)

    # terms
    t1 = c1 * c2
    t2 = c3 * t1 - s1 * s3
    t3 = c1 * s2
    t4 = -0.316 * t3
    t5 = 0.0825 * t2 - t4
    t6 = t3 * c4 - t2 * s4
    t7 = t2 * c4 + t3 * s4
    t8 = t5 + 0.384 * t6 - 0.0825 * t7
    t9 = c3 * s1 + t1 * s3
    t10 = t7 * c5 - s5 * t9
    t11 = t8 + 0.088 * (c6 * t10 + t6 * s6)
    t12 = t6 * c6 - t10 * s6
    t13 = t11 - 0.107 * t12
    t14 = c2 * s1
    t15 = c1 * s3 + c3 * t14
    t16 = s1 * s2
    t17 = -0.316 * t16
    t18 = 0.0825 * t15 - t17
    t19 = c4 * t16 - s4 * t15
    t20 = c4 * t15 + s4 * t16
    t21 = t18 + 0.384 * t19 - 0.0825 * t20
    t22 = c3 * c1 - s3 * t14
    t23 = c5 * t20 + s5 * t22
    t24 = t21 + 0.088 * (c6 * t23 + s6 * t19)
    t25 = c6 * t19 - s6 * t23
    t26 = t24 - 0.107 * t25
    t27 = 0.333 + 0.316 * c2
    t28 = c3 * s2
    t29 = t27 - 0.0825 * t28
    t30 = c2 * c4 + s4 * t28
    t31 = c2 * s4 - c4 * t28
    t32 = t29 + 0.384 * t30 - 0.0825 * t31
    t33 = s3 * s2
    t34 = c5 * t31 + s5 * t33
    t35 = t32 + 0.088 * (c6 * t34 + s6 * t30)
    t36 = c6 * t30 - s6 * t34
    t37 = t35 - 0.107 * t36
    t38 = t37 - 0.333
    t39 = t37 - t27
    t40 = t17 + t26
    t41 = t26 - t18
    t42 = t37 - t29
    t43 = t37 - t32
    t44 = t26 - t21
    t45 = c5 * t33 - s5 * t31
    t46 = c5 * t22 - s5 * t20
    t47 = t26 - t24
    t48 = t37 - t35
    t49 = t4 + t13
    t50 = t13 - t5
    t51 = t13 - t8
    t52 = c5 * t9 + t7 * s5
    t53 = t13 - t11

    # results
    position = np.empty((*_leading, 3), _real)
    jacobian = np.empty((*_leading, 21), _real)
    position[..., 0] = t13
    position[..., 1] = t26
    position[..., 2] = t37
    jacobian[..., 0] = -t26
    jacobian[..., 1] = c1 * t38
    jacobian[..., 2] = t16 * t39 - c2 * t40
    jacobian[..., 3] = t33 * t41 - t22 * t42
    jacobian[..., 4] = t19 * t43 - t30 * t44
    jacobian[..., 5] = t44 * t45 - t43 * t46
    jacobian[..., 6] = t36 * t47 - t25 * t48
    jacobian[..., 7] = t13
    jacobian[..., 8] = s1 * t38
    jacobian[..., 9] = c2 * t49 - t3 * t39
    jacobian[..., 10] = -(t9 * t42 + t33 * t50)
    jacobian[..., 11] = t30 * t51 - t6 * t43
    jacobian[..., 12] = -(t43 * t52 + t45 * t51)
    jacobian[..., 13] = t12 * t48 - t36 * t53
    jacobian[..., 14] = 0.0
    jacobian[..., 15] = -(c1 * t13 + s1 * t26)
    jacobian[..., 16] = t3 * t40 - t16 * t49
    jacobian[..., 17] = t22 * t50 + t9 * t41
    jacobian[..., 18] = t6 * t44 - t19 * t51
    jacobian[..., 19] = t46 * t51 + t44 * t52
    jacobian[..., 20] = t25 * t53 - t12 * t47
    return position.reshape(_leading + (3,)), jacobian.reshape(_leading + (3, 7))


def kinematics_pose(q):
    """pose and its Jacobian, in the base frame: 215 operations.

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
    t8 = c6 * t6 + s6 * t7
    t9 = c5 * t5 + t4 * s5
    t10 = c6 * t7 - t6 * s6
    t11 = -t10
    t12 = -0.316 * t3
    t13 = 0.0825 * t2 - t12
    t14 = t13 + 0.384 * t7 - 0.0825 * t4
    t15 = t14 + 0.088 * t8
    t16 = t15 - 0.107 * t10
    t17 = c2 * s1
    t18 = c1 * s3 + c3 * t17
    t19 = s1 * s2
    t20 = c4 * t18 + s4 * t19
    t21 = c3 * c1 - s3 * t17
    t22 = c5 * t20 + s5 * t21
    t23 = c4 * t19 - s4 * t18
    t24 = c6 * t22 + s6 * t23
    t25 = c5 * t21 - s5 * t20
    t26 = c6 * t23 - s6 * t22
    t27 = -t26
    t28 = -0.316 * t19
    t29 = 0.0825 * t18 - t28
    t30 = t29 + 0.384 * t23 - 0.0825 * t20
    t31 = t30 + 0.088 * t24
    t32 = t31 - 0.107 * t26
    t33 = c3 * s2
    t34 = c2 * s4 - c4 * t33
    t35 = s3 * s2
    t36 = c5 * t34 + s5 * t35
    t37 = c4 * c2 + s4 * t33
    t38 = c6 * t36 + s6 * t37
    t39 = c5 * t35 - s5 * t34
    t40 = c6 * t37 - s6 * t36
    t41 = -t40
    t42 = 0.333 + 0.316 * c2
    t43 = t42 - 0.0825 * t33
    t44 = t43 + 0.384 * t37 - 0.0825 * t34
    t45 = t44 + 0.088 * t38
    t46 = t45 - 0.107 * t40
    t47 = t46 - 0.333
    t48 = t46 - t42
    t49 = t28 + t32
    t50 = t32 - t29
    t51 = t46 - t43
    t52 = t46 - t44
    t53 = t32 - t30
    t54 = t32 - t31
    t55 = t46 - t45
    t56 = t12 + t16
    t57 = t16 - t13
    t58 = t16 - t14
    t59 = t16 - t15

    # results
    pose = np.empty((*_leading, 16), _real)
    jacobian = np.empty((*_leading, 42), _real)
    pose[..., 0] = c7 * t8 + s7 * t9
    pose[..., 1] = c7 * t9 - t8 * s7
    pose[..., 2] = t11
    pose[..., 3] = t16
    pose[..., 4] = c7 * t24 - s7 * t25
    pose[..., 5] = -(c7 * t25 + s7 * t24)
    pose[..., 6] = t27
    pose[..., 7] = t32
    pose[..., 8] = c7 * t38 - s7 * t39
    pose[..., 9] = -(c7 * t39 + s7 * t38)
    pose[..., 10] = t41
    pose[..., 11] = t46
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    jacobian[..., 0] = -t32
    jacobian[..., 1] = c1 * t47
    jacobian[..., 2] = t19 * t48 - c2 * t49
    jacobian[..., 3] = t35 * t50 - t21 * t51
    jacobian[..., 4] = t23 * t52 - t37 * t53
    jacobian[..., 5] = t39 * t53 - t25 * t52
    jacobian[..., 6] = t40 * t54 - t26 * t55
    jacobian[..., 7] = t16
    jacobian[..., 8] = s1 * t47
    jacobian[..., 9] = c2 * t56 - t3 * t48
    jacobian[..., 10] = -(t5 * t51 + t35 * t57)
    jacobian[..., 11] = t37 * t58 - t7 * t52
    jacobian[..., 12] = -(t9 * t52 + t39 * t58)
    jacobian[..., 13] = t10 * t55 - t40 * t59
    jacobian[..., 14] = 0.0
    jacobian[..., 15] = -(c1 * t16 + s1 * t32)
    jacobian[..., 16] = t3 * t49 - t19 * t56
    jacobian[..., 17] = t21 * t57 + t5 * t50
    jacobian[..., 18] = t7 * t53 - t23 * t58
    jacobian[..., 19] = t25 * t58 + t9 * t53
    jacobian[..., 20] = t26 * t59 - t10 * t54
    jacobian[..., 21] = 0.0
    jacobian[..., 22] = -s1
    jacobian[..., 23] = t3
    jacobian[..., 24] = t5
    jacobian[..., 25] = t7
    jacobian[..., 26] = t9
    jacobian[..., 27] = t11
    jacobian[..., 28] = 0.0
    jacobian[..., 29] = c1
    jacobian[..., 30] = t19
    jacobian[..., 31] = -t21
    jacobian[..., 32] = t23
    jacobian[..., 33] = -t25
    jacobian[..., 34] = t27
    jacobian[..., 35] = 1
    jacobian[..., 36] = 0.0
    jacobian[..., 37] = c2
    jacobian[..., 38] = -t35
    jacobian[..., 39] = t37
    jacobian[..., 40] = -t39
    jacobian[..., 41] = t41
    return pose.reshape(_leading + (4, 4)), jacobian.reshape(_leading + (6, 7))
