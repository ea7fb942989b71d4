"""kinematics of sanchez_8r, in NumPy.

Made from templates/kernel.py.j2; inputs ea1915cebf250136869b75260a5279fbcc7811012321df8ff8d574ba7e264fc3.
1102 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def position(q):
    """position of the tip, in the base frame: 113 operations.

    in   q[8]
    out  position[3]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s2 = np.sin(q2)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s1 = np.sin(q1)
    s3 = np.sin(q3)
    s4 = np.sin(q4)
    s5 = np.sin(q5)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    q7 = q[..., 6]
    c7 = np.cos(q7)
    s7 = np.sin(q7)

    # terms
    t1 = c1 * c2
    t2 = c1 * s2
    t3 = t1 * c3 - s1 * s3
    t4 = c5 * (c4 * t3 + t2 * s4) - s5 * (c3 * s1 + t1 * s3)
    t5 = t2 * c4 - t3 * s4
    t6 = t4 * c6 - s6 * t5
    t7 = 0.25 * t1 + 0.2 * t2 + 0.2 * t4 + 0.2 * t6
    t8 = 0.125 * (c7 * (c6 * t5 + t4 * s6) + t6 * s7)
    t9 = s2 * c3
    t10 = c5 * (c2 * s4 - c4 * t9) + s5 * (s2 * s3)
    t11 = c2 * c4 + s4 * t9
    t12 = c6 * t10 - s6 * t11
    t13 = 0.2 * c2 - 0.25 * s2 + 0.2 * t10 + 0.2 * t12
    t14 = 0.125 * (c7 * (c6 * t11 + s6 * t10) + s7 * t12)
    t15 = c2 * s1
    t16 = c3 * t15 + c1 * s3
    t17 = s2 * s1
    t18 = s5 * (s3 * t15 - c1 * c3) - c5 * (c4 * t16 + s4 * t17)
    t19 = s4 * t16 - c4 * t17
    t20 = c6 * t18 - s6 * t19
    t21 = 0.2 * t18 - (0.25 * t15 + 0.2 * t17) + 0.2 * t20
    t22 = 0.125 * (c7 * (c6 * t19 + s6 * t18) + s7 * t20)

    # results
    position = np.empty((*_leading, 3), _real)
    position[..., 0] = t7 - t8
    position[..., 1] = t13 - t14
    position[..., 2] = t21 - t22
    return position.reshape(_leading + (3,))


def pose(q):
    """pose of the tip, in the base frame: 156 operations.

    in   q[8]
    out  pose[4][4]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q8 = q[..., 7]
    c8 = np.cos(q8)
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
    s8 = np.sin(q8)

    # terms
    t1 = c1 * c2
    t2 = c3 * t1 - s1 * s3
    t3 = c1 * s2
    t4 = c4 * t2 + s4 * t3
    t5 = c3 * s1 + t1 * s3
    t6 = c5 * t4 - s5 * t5
    t7 = c4 * t3 - t2 * s4
    t8 = c6 * t6 - s6 * t7
    t9 = c6 * t7 + t6 * s6
    t10 = c7 * t8 - s7 * t9
    t11 = c5 * t5 + t4 * s5
    t12 = c7 * t9 + t8 * s7
    t13 = 0.25 * t1 + 0.2 * t3 + 0.2 * t6 + 0.2 * t8
    t14 = c3 * s2
    t15 = c2 * s4 - c4 * t14
    t16 = s3 * s2
    t17 = c5 * t15 + s5 * t16
    t18 = c4 * c2 + s4 * t14
    t19 = c6 * t17 - s6 * t18
    t20 = c6 * t18 + s6 * t17
    t21 = c7 * t19 - s7 * t20
    t22 = c5 * t16 - s5 * t15
    t23 = c7 * t20 + s7 * t19
    t24 = 0.2 * c2 - 0.25 * s2 + 0.2 * t17 + 0.2 * t19
    t25 = c2 * s1
    t26 = s3 * t25 - c3 * c1
    t27 = c3 * t25 + c1 * s3
    t28 = s1 * s2
    t29 = c4 * t27 + s4 * t28
    t30 = s5 * t26 - c5 * t29
    t31 = s4 * t27 - c4 * t28
    t32 = c6 * t30 - s6 * t31
    t33 = c6 * t31 + s6 * t30
    t34 = c7 * t32 - s7 * t33
    t35 = c5 * t26 + s5 * t29
    t36 = c7 * t33 + s7 * t32
    t37 = 0.2 * t30 - (0.25 * t25 + 0.2 * t28) + 0.2 * t32

    # results
    pose = np.empty((*_leading, 16), _real)
    pose[..., 0] = c8 * t10 + s8 * t11
    pose[..., 1] = c8 * t11 - t10 * s8
    pose[..., 2] = -t12
    pose[..., 3] = t13 - 0.125 * t12
    pose[..., 4] = c8 * t21 - s8 * t22
    pose[..., 5] = -(c8 * t22 + s8 * t21)
    pose[..., 6] = -t23
    pose[..., 7] = t24 - 0.125 * t23
    pose[..., 8] = c8 * t34 - s8 * t35
    pose[..., 9] = -(c8 * t35 + s8 * t34)
    pose[..., 10] = -t36
    pose[..., 11] = t37 - 0.125 * t36
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    return pose.reshape(_leading + (4, 4))


def jacobian_position(q):
    """Jacobian of the position, in the base frame: 196 operations.

    in   q[8]
    out  jacobian[3][8]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q5 = q[..., 4]
    s5 = np.sin(q5)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    c3 = np.cos(q3)
    c5 = np.cos(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    s2 = np.sin(q2)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    q7 = q[..., 6]
    c7 = np.cos(q7)
    s7 = np.sin(q7)

    # terms
    t1 = c2 * s1
    t2 = s3 * t1 - c1 * c3
    t3 = t1 * c3 + s3 * c1
    t4 = s1 * s2
    t5 = c4 * t3 + s4 * t4
    t6 = s5 * t2 - c5 * t5
    t7 = 0.25 * t1 + 0.2 * t4
    t8 = 0.2 * t6 - t7
    t9 = t3 * s4 - c4 * t4
    t10 = t6 * c6 - s6 * t9
    t11 = t8 + 0.2 * t10
    t12 = c7 * (c6 * t9 + t6 * s6) + t10 * s7
    t13 = t11 - 0.125 * t12
    t14 = 0.2 * c2 - 0.25 * s2
    t15 = c3 * s2
    t16 = c2 * s4 - c4 * t15
    t17 = s3 * s2
    t18 = c5 * t16 + s5 * t17
    t19 = t14 + 0.2 * t18
    t20 = c2 * c4 + s4 * t15
    t21 = c6 * t18 - s6 * t20
    t22 = t19 + 0.2 * t21
    t23 = c7 * (c6 * t20 + s6 * t18) + s7 * t21
    t24 = t22 - 0.125 * t23
    t25 = t7 + t13
    t26 = t24 - t14
    t27 = t13 - t8
    t28 = c5 * t17 - s5 * t16
    t29 = t24 - t19
    t30 = t2 * c5 + s5 * t5
    t31 = t13 - t11
    t32 = t24 - t22
    t33 = c2 * c1
    t34 = c1 * s2
    t35 = 0.25 * t33 + 0.2 * t34
    t36 = c3 * t33 - s3 * s1
    t37 = c4 * t36 + s4 * t34
    t38 = s1 * c3 + s3 * t33
    t39 = c5 * t37 - s5 * t38
    t40 = t35 + 0.2 * t39
    t41 = c4 * t34 - s4 * t36
    t42 = c6 * t39 - s6 * t41
    t43 = t40 + 0.2 * t42
    t44 = c7 * (c6 * t41 + s6 * t39) + s7 * t42
    t45 = t43 - 0.125 * t44
    t46 = t45 - t35
    t47 = t45 - t40
    t48 = c5 * t38 + s5 * t37
    t49 = t45 - t43

    # results
    jacobian = np.empty((*_leading, 24), _real)
    jacobian[..., 0] = t13
    jacobian[..., 1] = c1 * t24
    jacobian[..., 2] = c2 * t25 + t4 * t26
    jacobian[..., 3] = t2 * t26 - t17 * t25
    jacobian[..., 4] = t20 * t25 - t9 * t26
    jacobian[..., 5] = t27 * t28 - t29 * t30
    jacobian[..., 6] = t28 * t31 - t30 * t32
    jacobian[..., 7] = t12 * t32 - t23 * t31
    jacobian[..., 8] = 0.0
    jacobian[..., 9] = s1 * t13 - c1 * t45
    jacobian[..., 10] = -(t25 * t34 + t4 * t46)
    jacobian[..., 11] = -(t25 * t38 + t2 * t46)
    jacobian[..., 12] = t9 * t46 - t25 * t41
    jacobian[..., 13] = t30 * t47 + t27 * t48
    jacobian[..., 14] = t30 * t49 + t31 * t48
    jacobian[..., 15] = t31 * t44 - t12 * t49
    jacobian[..., 16] = -t45
    jacobian[..., 17] = -(s1 * t24)
    jacobian[..., 18] = t26 * t34 - c2 * t46
    jacobian[..., 19] = t17 * t46 + t26 * t38
    jacobian[..., 20] = t26 * t41 - t20 * t46
    jacobian[..., 21] = -(t29 * t48 + t28 * t47)
    jacobian[..., 22] = -(t32 * t48 + t28 * t49)
    jacobian[..., 23] = t23 * t49 - t32 * t44
    return jacobian.reshape(_leading + (3, 8))


def jacobian_pose(q):
    """Jacobian of the pose, in the base frame: 205 operations.

    in   q[8]
    out  jacobian[6][8]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q5 = q[..., 4]
    s5 = np.sin(q5)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    c3 = np.cos(q3)
    c5 = np.cos(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    s2 = np.sin(q2)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    q7 = q[..., 6]
    c7 = np.cos(q7)
    s7 = np.sin(q7)

    # terms
    t1 = c2 * s1
    t2 = s3 * t1 - c1 * c3
    t3 = t1 * c3 + s3 * c1
    t4 = s1 * s2
    t5 = c4 * t3 + s4 * t4
    t6 = s5 * t2 - c5 * t5
    t7 = 0.25 * t1 + 0.2 * t4
    t8 = 0.2 * t6 - t7
    t9 = t3 * s4 - c4 * t4
    t10 = t6 * c6 - s6 * t9
    t11 = t8 + 0.2 * t10
    t12 = c7 * (c6 * t9 + t6 * s6) + t10 * s7
    t13 = t11 - 0.125 * t12
    t14 = 0.2 * c2 - 0.25 * s2
    t15 = c3 * s2
    t16 = c2 * s4 - c4 * t15
    t17 = s3 * s2
    t18 = c5 * t16 + s5 * t17
    t19 = t14 + 0.2 * t18
    t20 = c2 * c4 + s4 * t15
    t21 = c6 * t18 - s6 * t20
    t22 = t19 + 0.2 * t21
    t23 = c7 * (c6 * t20 + s6 * t18) + s7 * t21
    t24 = t22 - 0.125 * t23
    t25 = t7 + t13
    t26 = t24 - t14
    t27 = t13 - t8
    t28 = c5 * t17 - s5 * t16
    t29 = t24 - t19
    t30 = t2 * c5 + s5 * t5
    t31 = t13 - t11
    t32 = t24 - t22
    t33 = c2 * c1
    t34 = c1 * s2
    t35 = 0.25 * t33 + 0.2 * t34
    t36 = c3 * t33 - s3 * s1
    t37 = c4 * t36 + s4 * t34
    t38 = s1 * c3 + s3 * t33
    t39 = c5 * t37 - s5 * t38
    t40 = t35 + 0.2 * t39
    t41 = c4 * t34 - s4 * t36
    t42 = c6 * t39 - s6 * t41
    t43 = t40 + 0.2 * t42
    t44 = c7 * (c6 * t41 + s6 * t39) + s7 * t42
    t45 = t43 - 0.125 * t44
    t46 = t45 - t35
    t47 = t45 - t40
    t48 = c5 * t38 + s5 * t37
    t49 = t45 - t43
    t50 = -t48

    # results
    jacobian = np.empty((*_leading, 48), _real)
    jacobian[..., 0] = t13
    jacobian[..., 1] = c1 * t24
    jacobian[..., 2] = c2 * t25 + t4 * t26
    jacobian[..., 3] = t2 * t26 - t17 * t25
    jacobian[..., 4] = t20 * t25 - t9 * t26
    jacobian[..., 5] = t27 * t28 - t29 * t30
    jacobian[..., 6] = t28 * t31 - t30 * t32
    jacobian[..., 7] = t12 * t32 - t23 * t31
    jacobian[..., 8] = 0.0
    jacobian[..., 9] = s1 * t13 - c1 * t45
    jacobian[..., 10] = -(t25 * t34 + t4 * t46)
    jacobian[..., 11] = -(t25 * t38 + t2 * t46)
    jacobian[..., 12] = t9 * t46 - t25 * t41
    jacobian[..., 13] = t30 * t47 + t27 * t48
    jacobian[..., 14] = t30 * t49 + t31 * t48
    jacobian[..., 15] = t31 * t44 - t12 * t49
    jacobian[..., 16] = -t45
    jacobian[..., 17] = -(s1 * t24)
    jacobian[..., 18] = t26 * t34 - c2 * t46
    jacobian[..., 19] = t17 * t46 + t26 * t38
    jacobian[..., 20] = t26 * t41 - t20 * t46
    jacobian[..., 21] = -(t29 * t48 + t28 * t47)
    jacobian[..., 22] = -(t32 * t48 + t28 * t49)
    jacobian[..., 23] = t23 * t49 - t32 * t44
    jacobian[..., 24] = 0.0
    jacobian[..., 25] = -s1
    jacobian[..., 26] = t34
    jacobian[..., 27] = t38
    jacobian[..., 28] = t41
    jacobian[..., 29] = t50
    jacobian[..., 30] = t50
    jacobian[..., 31] = -t44
    jacobian[..., 32] = 1
    jacobian[..., 33] = 0.0
    jacobian[..., 34] = c2
    jacobian[..., 35] = -t17
    jacobian[..., 36] = t20
    jacobian[..., 37] = t28
    jacobian[..., 38] = t28
    jacobian[..., 39] = -t23
    jacobian[..., 40] = 0.0
    jacobian[..., 41] = -c1
    jacobian[..., 42] = -t4
    jacobian[..., 43] = -t2
    jacobian[..., 44] = t9
    jacobian[..., 45] = t30
    jacobian[..., 46] = t30
    jacobian[..., 47] = -t12
    return jacobian.reshape(_leading + (6, 8))


def kinematics_position(q):
    """position and its Jacobian, in the base frame: 196 operations.

    in   q[8]
    out  position[3]
    out  jacobian[3][8]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s2 = np.sin(q2)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s1 = np.sin(q1)
    s3 = np.sin(q3)
    s4 = np.sin(q4)
    s5 = np.sin(q5)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    q7 = q[..., 6]
    c7 = np.cos(q7)
    s7 = np.sin(q7)

    # terms
    t1 = c1 * c2
    t2 = c1 * s2
    t3 = 0.25 * t1 + 0.2 * t2
    t4 = t1 * c3 - s1 * s3
    t5 = c4 * t4 + t2 * s4
    t6 = c3 * s1 + t1 * s3
    t7 = c5 * t5 - s5 * t6
    t8 = t3 + 0.2 * t7
    t9 = t2 * c4 - t4 * s4
    t10 = t7 * c6 - s6 * t9
    t11 = t8 + 0.2 * t10
    t12 = c7 * (c6 * t9 + t7 * s6) + t10 * s7
    t13 = t11 - 0.125 * t12
    t14 = 0.2 * c2 - 0.25 * s2
    t15 = s2 * c3
    t16 = c2 * s4 - c4 * t15
    t17 = s2 * s3
    t18 = c5 * t16 + s5 * t17
    t19 = t14 + 0.2 * t18
    t20 = c2 * c4 + s4 * t15
    t21 = c6 * t18 - s6 * t20
    t22 = t19 + 0.2 * t21
    t23 = c7 * (c6 * t20 + s6 * t18) + s7 * t21
    t24 = t22 - 0.125 * t23
    t25 = c2 * s1
    t26 = s3 * t25 - c1 * c3
    t27 = c3 * t25 + c1 * s3
    t28 = s2 * s1
    t29 = c4 * t27 + s4 * t28
    t30 = s5 * t26 - c5 * t29
    t31 = 0.25 * t25 + 0.2 * t28
    t32 = 0.2 * t30 - t31
    t33 = s4 * t27 - c4 * t28
    t34 = c6 * t30 - s6 * t33
    t35 = t32 + 0.2 * t34
    t36 = c7 * (c6 * t33 + s6 * t30) + s7 * t34
    t37 = t35 - 0.125 * t36
    t38 = t31 + t37
    t39 = t24 - t14
    t40 = t37 - t32
    t41 = c5 * t17 - s5 * t16
    t42 = t24 - t19
    t43 = c5 * t26 + s5 * t29
    t44 = t37 - t35
    t45 = t24 - t22
    t46 = t13 - t3
    t47 = t13 - t8
    t48 = c5 * t6 + t5 * s5
    t49 = t13 - t11

    # results
    position = np.empty((*_leading, 3), _real)
    jacobian = np.empty((*_leading, 24), _real)
    position[..., 0] = t13
    position[..., 1] = t24
    position[..., 2] = t37
    jacobian[..., 0] = t37
    jacobian[..., 1] = c1 * t24
    jacobian[..., 2] = c2 * t38 + t28 * t39
    jacobian[..., 3] = t26 * t39 - t17 * t38
    jacobian[..., 4] = t20 * t38 - t33 * t39
    jacobian[..., 5] = t40 * t41 - t42 * t43
    jacobian[..., 6] = t41 * t44 - t43 * t45
    jacobian[..., 7] = t36 * t45 - t23 * t44
    jacobian[..., 8] = 0.0
    jacobian[..., 9] = s1 * t37 - c1 * t13
    jacobian[..., 10] = -(t2 * t38 + t28 * t46)
    jacobian[..., 11] = -(t6 * t38 + t26 * t46)
    jacobian[..., 12] = t33 * t46 - t9 * t38
    jacobian[..., 13] = t43 * t47 + t40 * t48
    jacobian[..., 14] = t43 * t49 + t44 * t48
    jacobian[..., 15] = t12 * t44 - t36 * t49
    jacobian[..., 16] = -t13
    jacobian[..., 17] = -(s1 * t24)
    jacobian[..., 18] = t2 * t39 - c2 * t46
    jacobian[..., 19] = t17 * t46 + t6 * t39
    jacobian[..., 20] = t9 * t39 - t20 * t46
    jacobian[..., 21] = -(t42 * t48 + t41 * t47)
    jacobian[..., 22] = -(t45 * t48 + t41 * t49)
    jacobian[..., 23] = t23 * t49 - t12 * t45
    return position.reshape(_leading + (3,)), jacobian.reshape(_leading + (3, 8))


def kinematics_pose(q):
    """pose and its Jacobian, in the base frame: 236 operations.

    in   q[8]
    out  pose[4][4]
    out  jacobian[6][8]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q8 = q[..., 7]
    c8 = np.cos(q8)
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
    s8 = np.sin(q8)

    # terms
    t1 = c1 * c2
    t2 = c3 * t1 - s1 * s3
    t3 = c1 * s2
    t4 = c4 * t2 + s4 * t3
    t5 = c3 * s1 + t1 * s3
    t6 = c5 * t4 - s5 * t5
    t7 = c4 * t3 - t2 * s4
    t8 = c6 * t6 - s6 * t7
    t9 = c6 * t7 + t6 * s6
    t10 = c7 * t8 - s7 * t9
    t11 = c5 * t5 + t4 * s5
    t12 = c7 * t9 + t8 * s7
    t13 = -t12
    t14 = 0.25 * t1 + 0.2 * t3
    t15 = t14 + 0.2 * t6
    t16 = t15 + 0.2 * t8
    t17 = t16 - 0.125 * t12
    t18 = c3 * s2
    t19 = c2 * s4 - c4 * t18
    t20 = s3 * s2
    t21 = c5 * t19 + s5 * t20
    t22 = c4 * c2 + s4 * t18
    t23 = c6 * t21 - s6 * t22
    t24 = c6 * t22 + s6 * t21
    t25 = c7 * t23 - s7 * t24
    t26 = c5 * t20 - s5 * t19
    t27 = c7 * t24 + s7 * t23
    t28 = -t27
    t29 = 0.2 * c2 - 0.25 * s2
    t30 = t29 + 0.2 * t21
    t31 = t30 + 0.2 * t23
    t32 = t31 - 0.125 * t27
    t33 = c2 * s1
    t34 = s3 * t33 - c3 * c1
    t35 = c3 * t33 + c1 * s3
    t36 = s1 * s2
    t37 = c4 * t35 + s4 * t36
    t38 = s5 * t34 - c5 * t37
    t39 = s4 * t35 - c4 * t36
    t40 = c6 * t38 - s6 * t39
    t41 = c6 * t39 + s6 * t38
    t42 = c7 * t40 - s7 * t41
    t43 = c5 * t34 + s5 * t37
    t44 = c7 * t41 + s7 * t40
    t45 = -t44
    t46 = 0.25 * t33 + 0.2 * t36
    t47 = 0.2 * t38 - t46
    t48 = t47 + 0.2 * t40
    t49 = t48 - 0.125 * t44
    t50 = t46 + t49
    t51 = t32 - t29
    t52 = t49 - t47
    t53 = t32 - t30
    t54 = t49 - t48
    t55 = t32 - t31
    t56 = t17 - t14
    t57 = t17 - t15
    t58 = t17 - t16
    t59 = -t11

    # results
    pose = np.empty((*_leading, 16), _real)
    jacobian = np.empty((*_leading, 48), _real)
    pose[..., 0] = c8 * t10 + s8 * t11
    pose[..., 1] = c8 * t11 - t10 * s8
    pose[..., 2] = t13
    pose[..., 3] = t17
    pose[..., 4] = c8 * t25 - s8 * t26
    pose[..., 5] = -(c8 * t26 + s8 * t25)
    pose[..., 6] = t28
    pose[..., 7] = t32
    pose[..., 8] = c8 * t42 - s8 * t43
    pose[..., 9] = -(c8 * t43 + s8 * t42)
    pose[..., 10] = t45
    pose[..., 11] = t49
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    jacobian[..., 0] = t49
    jacobian[..., 1] = c1 * t32
    jacobian[..., 2] = c2 * t50 + t36 * t51
    jacobian[..., 3] = t34 * t51 - t20 * t50
    jacobian[..., 4] = t22 * t50 - t39 * t51
    jacobian[..., 5] = t26 * t52 - t43 * t53
    jacobian[..., 6] = t26 * t54 - t43 * t55
    jacobian[..., 7] = t44 * t55 - t27 * t54
    jacobian[..., 8] = 0.0
    jacobian[..., 9] = s1 * t49 - c1 * t17
    jacobian[..., 10] = -(t3 * t50 + t36 * t56)
    jacobian[..., 11] = -(t5 * t50 + t34 * t56)
    jacobian[..., 12] = t39 * t56 - t7 * t50
    jacobian[..., 13] = t43 * t57 + t11 * t52
    jacobian[..., 14] = t43 * t58 + t11 * t54
    jacobian[..., 15] = t12 * t54 - t44 * t58
    jacobian[..., 16] = -t17
    jacobian[..., 17] = -(s1 * t32)
    jacobian[..., 18] = t3 * t51 - c2 * t56
    jacobian[..., 19] = t20 * t56 + t5 * t51
    jacobian[..., 20] = t7 * t51 - t22 * t56
    jacobian[..., 21] = -(t11 * t53 + t26 * t57)
    jacobian[..., 22] = -(t11 * t55 + t26 * t58)
    jacobian[..., 23] = t27 * t58 - t12 * t55
    jacobian[..., 24] = 0.0
    jacobian[..., 25] = -s1
    jacobian[..., 26] = t3
    jacobian[..., 27] = t5
    jacobian[..., 28] = t7
    jacobian[..., 29] = t59
    jacobian[..., 30] = t59
    jacobian[..., 31] = t13
    jacobian[..., 32] = 1
    jacobian[..., 33] = 0.0
    jacobian[..., 34] = c2
    jacobian[..., 35] = -t20
    jacobian[..., 36] = t22
    jacobian[..., 37] = t26
    jacobian[..., 38] = t26
    jacobian[..., 39] = t28
    jacobian[..., 40] = 0.0
    jacobian[..., 41] = -c1
    jacobian[..., 42] = -t36
    jacobian[..., 43] = -t34
    jacobian[..., 44] = t39
    jacobian[..., 45] = t43
    jacobian[..., 46] = t43
    jacobian[..., 47] = t45
    return pose.reshape(_leading + (4, 4)), jacobian.reshape(_leading + (6, 8))
