"""kinematics of jaco2, in NumPy.

Made from templates/kernel.py.j2; inputs 877d116cceea710cb04a9dcc8e044e2a80fc3ec6eac77bc800d6c1992b0822ea.
949 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def position(q):
    """position of the tip, in the base frame: 111 operations.

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
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)

    # terms
    t1 = c1 * c2
    t2 = c1 * s2
    t3 = c3 * t2 - t1 * s3
    t4 = 0.0098 * s1 + 0.41 * t1 + 0.2500816549469513 * t3 + 0.04278165494695127 * t3
    t5 = t1 * c3 + t2 * s3
    t6 = s1 * c4 + s4 * t5
    t7 = c5 * (0.5000000000000001 * t6 + 0.8660254037844386 * t3) + s5 * (c4 * t5 - s1 * s4)
    t8 = t4 - 0.07409999999999999 * t6 - 0.17561406460551018 * t7 - 0.10139082747347566 * (-0.5000000000000001 * t3 + 0.8660254037844386 * t6)
    t9 = s1 * c2
    t10 = s1 * s2
    t11 = c3 * t10 - s3 * t9
    t12 = 0.41 * t9 - 0.0098 * c1 + 0.2500816549469513 * t11 + 0.04278165494695127 * t11
    t13 = c3 * t9 + s3 * t10
    t14 = c1 * c4 - s4 * t13
    t15 = c5 * (0.5000000000000001 * t14 - 0.8660254037844386 * t11) - s5 * (c1 * s4 + c4 * t13)
    t16 = t12 + 0.07409999999999999 * t14 + 0.17561406460551018 * t15 - 0.10139082747347566 * (-0.5000000000000001 * t11 - 0.8660254037844386 * t14)
    t17 = c2 * c3 + s2 * s3
    t18 = c3 * s2 - c2 * s3
    t19 = s4 * t18
    t20 = 0.2755 + 0.41 * s2 - 0.2500816549469513 * t17 - 0.04278165494695127 * t17 - 0.07409999999999999 * t19
    t21 = c5 * (0.8660254037844386 * t17 - 0.5000000000000001 * t19) - s5 * (c4 * t18)
    t22 = t20 + 0.17561406460551018 * t21 - 0.10139082747347566 * (0.8660254037844386 * t19 - -0.5000000000000001 * t17)

    # results
    position = np.empty((*_leading, 3), _real)
    position[..., 0] = t8
    position[..., 1] = t16
    position[..., 2] = t22
    return position.reshape(_leading + (3,))


def pose(q):
    """pose of the tip, in the base frame: 158 operations.

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
    t3 = c3 * t1 + s3 * t2
    t4 = c4 * t3 - s1 * s4
    t5 = c4 * s1 + t3 * s4
    t6 = c3 * t2 - t1 * s3
    t7 = 0.5000000000000001 * t5 + 0.8660254037844386 * t6
    t8 = c5 * t4 - s5 * t7
    t9 = -0.5000000000000001 * t6 + 0.8660254037844386 * t5
    t10 = c5 * t7 + t4 * s5
    t11 = 0.8660254037844386 * t9 - 0.5000000000000001 * t10
    t12 = 0.0098 * s1 + 0.41 * t1 + 0.2500816549469513 * t6 + 0.04278165494695127 * t6
    t13 = c2 * s1
    t14 = s2 * s1
    t15 = c3 * t13 + s3 * t14
    t16 = c1 * s4 + c4 * t15
    t17 = c4 * c1 - s4 * t15
    t18 = c3 * t14 - s3 * t13
    t19 = 0.5000000000000001 * t17 - 0.8660254037844386 * t18
    t20 = c5 * t16 + s5 * t19
    t21 = -0.5000000000000001 * t18 - 0.8660254037844386 * t17
    t22 = c5 * t19 - s5 * t16
    t23 = 0.8660254037844386 * t21 + 0.5000000000000001 * t22
    t24 = 0.41 * t13 - 0.0098 * c1 + 0.2500816549469513 * t18 + 0.04278165494695127 * t18
    t25 = c3 * s2 - c2 * s3
    t26 = c4 * t25
    t27 = c3 * c2 + s3 * s2
    t28 = s4 * t25
    t29 = 0.8660254037844386 * t27 - 0.5000000000000001 * t28
    t30 = c5 * t26 + s5 * t29
    t31 = 0.8660254037844386 * t28 - -0.5000000000000001 * t27
    t32 = c5 * t29 - s5 * t26
    t33 = 0.8660254037844386 * t31 + 0.5000000000000001 * t32
    t34 = 0.2755 + 0.41 * s2 - 0.2500816549469513 * t27 - 0.04278165494695127 * t27 - 0.07409999999999999 * t28

    # results
    pose = np.empty((*_leading, 16), _real)
    pose[..., 0] = c6 * t8 + s6 * t11
    pose[..., 1] = c6 * t11 - t8 * s6
    pose[..., 2] = 0.5000000000000001 * t9 + 0.8660254037844386 * t10
    pose[..., 3] = t12 - 0.07409999999999999 * t5 - 0.17561406460551018 * t10 - 0.10139082747347566 * t9
    pose[..., 4] = c6 * t20 + s6 * t23
    pose[..., 5] = c6 * t23 - s6 * t20
    pose[..., 6] = 0.5000000000000001 * t21 - 0.8660254037844386 * t22
    pose[..., 7] = t24 + 0.07409999999999999 * t17 + 0.17561406460551018 * t22 - 0.10139082747347566 * t21
    pose[..., 8] = c6 * t30 + s6 * t33
    pose[..., 9] = c6 * t33 - s6 * t30
    pose[..., 10] = 0.5000000000000001 * t31 - 0.8660254037844386 * t32
    pose[..., 11] = t34 + 0.17561406460551018 * t32 - 0.10139082747347566 * t31
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    return pose.reshape(_leading + (4, 4))


def jacobian_position(q):
    """Jacobian of the position, in the base frame: 154 operations.

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
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)

    # terms
    t1 = c2 * s1
    t2 = 0.41 * t1 - 0.0098 * c1
    t3 = s1 * s2
    t4 = c3 * t3 - t1 * s3
    t5 = t2 + 0.2500816549469513 * t4
    t6 = t1 * c3 + t3 * s3
    t7 = c1 * c4 - s4 * t6
    t8 = t5 + 0.04278165494695127 * t4 + 0.07409999999999999 * t7
    t9 = c5 * (0.5000000000000001 * t7 - 0.8660254037844386 * t4) - s5 * (c1 * s4 + c4 * t6)
    t10 = -0.5000000000000001 * t4 - 0.8660254037844386 * t7
    t11 = t8 + 0.17561406460551018 * t9 - 0.10139082747347566 * t10
    t12 = 0.2755 + 0.41 * s2
    t13 = c2 * c3 + s2 * s3
    t14 = t12 - 0.2500816549469513 * t13
    t15 = c3 * s2 - c2 * s3
    t16 = s4 * t15
    t17 = t14 - 0.04278165494695127 * t13 - 0.07409999999999999 * t16
    t18 = c5 * (0.8660254037844386 * t13 - 0.5000000000000001 * t16) - s5 * (c4 * t15)
    t19 = 0.8660254037844386 * t16 - -0.5000000000000001 * t13
    t20 = t17 + 0.17561406460551018 * t18 - 0.10139082747347566 * t19
    t21 = t20 - 0.2755
    t22 = t20 - t12
    t23 = t11 - t5
    t24 = t20 - t14
    t25 = t20 - t17
    t26 = t11 - t8
    t27 = c2 * c1
    t28 = 0.0098 * s1 + 0.41 * t27
    t29 = c1 * s2
    t30 = c3 * t29 - s3 * t27
    t31 = t28 + 0.2500816549469513 * t30
    t32 = c3 * t27 + s3 * t29
    t33 = s1 * c4 + s4 * t32
    t34 = t31 + 0.04278165494695127 * t30 - 0.07409999999999999 * t33
    t35 = c5 * (0.5000000000000001 * t33 + 0.8660254037844386 * t30) + s5 * (c4 * t32 - s1 * s4)
    t36 = -0.5000000000000001 * t30 + 0.8660254037844386 * t33
    t37 = t34 - 0.17561406460551018 * t35 - 0.10139082747347566 * t36
    t38 = t37 - t31
    t39 = t37 - t34

    # results
    jacobian = np.empty((*_leading, 18), _real)
    jacobian[..., 0] = -t11
    jacobian[..., 1] = -(c1 * t21)
    jacobian[..., 2] = c1 * t22
    jacobian[..., 3] = -(t13 * t23 + t4 * t24)
    jacobian[..., 4] = t10 * t25 - t19 * t26
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t37
    jacobian[..., 7] = -(s1 * t21)
    jacobian[..., 8] = s1 * t22
    jacobian[..., 9] = t24 * t30 + t13 * t38
    jacobian[..., 10] = t19 * t39 - t25 * t36
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = c1 * t37 + s1 * t11
    jacobian[..., 14] = -(c1 * (t37 - t28) + s1 * (t11 - t2))
    jacobian[..., 15] = t4 * t38 - t23 * t30
    jacobian[..., 16] = t26 * t36 - t10 * t39
    jacobian[..., 17] = 0.0
    return jacobian.reshape(_leading + (3, 6))


def jacobian_pose(q):
    """Jacobian of the pose, in the base frame: 167 operations.

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
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)

    # terms
    t1 = c2 * s1
    t2 = 0.41 * t1 - 0.0098 * c1
    t3 = s1 * s2
    t4 = c3 * t3 - t1 * s3
    t5 = t2 + 0.2500816549469513 * t4
    t6 = t1 * c3 + t3 * s3
    t7 = c1 * c4 - s4 * t6
    t8 = t5 + 0.04278165494695127 * t4 + 0.07409999999999999 * t7
    t9 = c5 * (0.5000000000000001 * t7 - 0.8660254037844386 * t4) - s5 * (c1 * s4 + c4 * t6)
    t10 = -0.5000000000000001 * t4 - 0.8660254037844386 * t7
    t11 = t8 + 0.17561406460551018 * t9 - 0.10139082747347566 * t10
    t12 = 0.2755 + 0.41 * s2
    t13 = c2 * c3 + s2 * s3
    t14 = t12 - 0.2500816549469513 * t13
    t15 = c3 * s2 - c2 * s3
    t16 = s4 * t15
    t17 = t14 - 0.04278165494695127 * t13 - 0.07409999999999999 * t16
    t18 = c5 * (0.8660254037844386 * t13 - 0.5000000000000001 * t16) - s5 * (c4 * t15)
    t19 = 0.8660254037844386 * t16 - -0.5000000000000001 * t13
    t20 = t17 + 0.17561406460551018 * t18 - 0.10139082747347566 * t19
    t21 = t20 - 0.2755
    t22 = t20 - t12
    t23 = t11 - t5
    t24 = t20 - t14
    t25 = t20 - t17
    t26 = t11 - t8
    t27 = c2 * c1
    t28 = 0.0098 * s1 + 0.41 * t27
    t29 = c1 * s2
    t30 = c3 * t29 - s3 * t27
    t31 = t28 + 0.2500816549469513 * t30
    t32 = c3 * t27 + s3 * t29
    t33 = s1 * c4 + s4 * t32
    t34 = t31 + 0.04278165494695127 * t30 - 0.07409999999999999 * t33
    t35 = c5 * (0.5000000000000001 * t33 + 0.8660254037844386 * t30) + s5 * (c4 * t32 - s1 * s4)
    t36 = -0.5000000000000001 * t30 + 0.8660254037844386 * t33
    t37 = t34 - 0.17561406460551018 * t35 - 0.10139082747347566 * t36
    t38 = t37 - t31
    t39 = t37 - t34

    # results
    jacobian = np.empty((*_leading, 36), _real)
    jacobian[..., 0] = -t11
    jacobian[..., 1] = -(c1 * t21)
    jacobian[..., 2] = c1 * t22
    jacobian[..., 3] = -(t13 * t23 + t4 * t24)
    jacobian[..., 4] = t10 * t25 - t19 * t26
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t37
    jacobian[..., 7] = -(s1 * t21)
    jacobian[..., 8] = s1 * t22
    jacobian[..., 9] = t24 * t30 + t13 * t38
    jacobian[..., 10] = t19 * t39 - t25 * t36
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = c1 * t37 + s1 * t11
    jacobian[..., 14] = -(c1 * (t37 - t28) + s1 * (t11 - t2))
    jacobian[..., 15] = t4 * t38 - t23 * t30
    jacobian[..., 16] = t26 * t36 - t10 * t39
    jacobian[..., 17] = 0.0
    jacobian[..., 18] = 0.0
    jacobian[..., 19] = s1
    jacobian[..., 20] = -s1
    jacobian[..., 21] = -t30
    jacobian[..., 22] = t36
    jacobian[..., 23] = 0.5000000000000001 * t36 + 0.8660254037844386 * t35
    jacobian[..., 24] = 0.0
    jacobian[..., 25] = -c1
    jacobian[..., 26] = c1
    jacobian[..., 27] = -t4
    jacobian[..., 28] = t10
    jacobian[..., 29] = 0.5000000000000001 * t10 - 0.8660254037844386 * t9
    jacobian[..., 30] = 1
    jacobian[..., 31] = 0.0
    jacobian[..., 32] = 0.0
    jacobian[..., 33] = t13
    jacobian[..., 34] = t19
    jacobian[..., 35] = 0.5000000000000001 * t19 - 0.8660254037844386 * t18
    return jacobian.reshape(_leading + (6, 6))


def kinematics_position(q):
    """position and its Jacobian, in the base frame: 154 operations.

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
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)

    # terms
    t1 = c1 * c2
    t2 = 0.0098 * s1 + 0.41 * t1
    t3 = c1 * s2
    t4 = c3 * t3 - t1 * s3
    t5 = t2 + 0.2500816549469513 * t4
    t6 = t1 * c3 + t3 * s3
    t7 = s1 * c4 + s4 * t6
    t8 = t5 + 0.04278165494695127 * t4 - 0.07409999999999999 * t7
    t9 = c5 * (0.5000000000000001 * t7 + 0.8660254037844386 * t4) + s5 * (c4 * t6 - s1 * s4)
    t10 = -0.5000000000000001 * t4 + 0.8660254037844386 * t7
    t11 = t8 - 0.17561406460551018 * t9 - 0.10139082747347566 * t10
    t12 = s1 * c2
    t13 = 0.41 * t12 - 0.0098 * c1
    t14 = s1 * s2
    t15 = c3 * t14 - s3 * t12
    t16 = t13 + 0.2500816549469513 * t15
    t17 = c3 * t12 + s3 * t14
    t18 = c1 * c4 - s4 * t17
    t19 = t16 + 0.04278165494695127 * t15 + 0.07409999999999999 * t18
    t20 = c5 * (0.5000000000000001 * t18 - 0.8660254037844386 * t15) - s5 * (c1 * s4 + c4 * t17)
    t21 = -0.5000000000000001 * t15 - 0.8660254037844386 * t18
    t22 = t19 + 0.17561406460551018 * t20 - 0.10139082747347566 * t21
    t23 = 0.2755 + 0.41 * s2
    t24 = c2 * c3 + s2 * s3
    t25 = t23 - 0.2500816549469513 * t24
    t26 = c3 * s2 - c2 * s3
    t27 = s4 * t26
    t28 = t25 - 0.04278165494695127 * t24 - 0.07409999999999999 * t27
    t29 = c5 * (0.8660254037844386 * t24 - 0.5000000000000001 * t27) - s5 * (c4 * t26)
    t30 = 0.8660254037844386 * t27 - -0.5000000000000001 * t24
    t31 = t28 + 0.17561406460551018 * t29 - 0.10139082747347566 * t30
    t32 = t31 - 0.2755
    t33 = t31 - t23
    t34 = t22 - t16
    t35 = t31 - t25
    t36 = t31 - t28
    t37 = t22 - t19
    t38 = t11 - t5
    t39 = t11 - t8

    # results
    position = np.empty((*_leading, 3), _real)
    jacobian = np.empty((*_leading, 18), _real)
    position[..., 0] = t11
    position[..., 1] = t22
    position[..., 2] = t31
    jacobian[..., 0] = -t22
    jacobian[..., 1] = -(c1 * t32)
    jacobian[..., 2] = c1 * t33
    jacobian[..., 3] = -(t24 * t34 + t15 * t35)
    jacobian[..., 4] = t21 * t36 - t30 * t37
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t11
    jacobian[..., 7] = -(s1 * t32)
    jacobian[..., 8] = s1 * t33
    jacobian[..., 9] = t4 * t35 + t24 * t38
    jacobian[..., 10] = t30 * t39 - t10 * t36
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = c1 * t11 + s1 * t22
    jacobian[..., 14] = -(c1 * (t11 - t2) + s1 * (t22 - t13))
    jacobian[..., 15] = t15 * t38 - t4 * t34
    jacobian[..., 16] = t10 * t37 - t21 * t39
    jacobian[..., 17] = 0.0
    return position.reshape(_leading + (3,)), jacobian.reshape(_leading + (3, 6))


def kinematics_pose(q):
    """pose and its Jacobian, in the base frame: 205 operations.

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
    t3 = c3 * t1 + s3 * t2
    t4 = c4 * t3 - s1 * s4
    t5 = c4 * s1 + t3 * s4
    t6 = c3 * t2 - t1 * s3
    t7 = 0.5000000000000001 * t5 + 0.8660254037844386 * t6
    t8 = c5 * t4 - s5 * t7
    t9 = -0.5000000000000001 * t6 + 0.8660254037844386 * t5
    t10 = c5 * t7 + t4 * s5
    t11 = 0.8660254037844386 * t9 - 0.5000000000000001 * t10
    t12 = 0.5000000000000001 * t9 + 0.8660254037844386 * t10
    t13 = 0.0098 * s1 + 0.41 * t1
    t14 = t13 + 0.2500816549469513 * t6
    t15 = t14 + 0.04278165494695127 * t6 - 0.07409999999999999 * t5
    t16 = t15 - 0.17561406460551018 * t10 - 0.10139082747347566 * t9
    t17 = c2 * s1
    t18 = s2 * s1
    t19 = c3 * t17 + s3 * t18
    t20 = c1 * s4 + c4 * t19
    t21 = c4 * c1 - s4 * t19
    t22 = c3 * t18 - s3 * t17
    t23 = 0.5000000000000001 * t21 - 0.8660254037844386 * t22
    t24 = c5 * t20 + s5 * t23
    t25 = -0.5000000000000001 * t22 - 0.8660254037844386 * t21
    t26 = c5 * t23 - s5 * t20
    t27 = 0.8660254037844386 * t25 + 0.5000000000000001 * t26
    t28 = 0.5000000000000001 * t25 - 0.8660254037844386 * t26
    t29 = 0.41 * t17 - 0.0098 * c1
    t30 = t29 + 0.2500816549469513 * t22
    t31 = t30 + 0.04278165494695127 * t22 + 0.07409999999999999 * t21
    t32 = t31 + 0.17561406460551018 * t26 - 0.10139082747347566 * t25
    t33 = c3 * s2 - c2 * s3
    t34 = c4 * t33
    t35 = c3 * c2 + s3 * s2
    t36 = s4 * t33
    t37 = 0.8660254037844386 * t35 - 0.5000000000000001 * t36
    t38 = c5 * t34 + s5 * t37
    t39 = 0.8660254037844386 * t36 - -0.5000000000000001 * t35
    t40 = c5 * t37 - s5 * t34
    t41 = 0.8660254037844386 * t39 + 0.5000000000000001 * t40
    t42 = 0.5000000000000001 * t39 - 0.8660254037844386 * t40
    t43 = 0.2755 + 0.41 * s2
    t44 = t43 - 0.2500816549469513 * t35
    t45 = t44 - 0.04278165494695127 * t35 - 0.07409999999999999 * t36
    t46 = t45 + 0.17561406460551018 * t40 - 0.10139082747347566 * t39
    t47 = t46 - 0.2755
    t48 = t46 - t43
    t49 = t32 - t30
    t50 = t46 - t44
    t51 = t46 - t45
    t52 = t32 - t31
    t53 = t16 - t14
    t54 = t16 - t15

    # results
    pose = np.empty((*_leading, 16), _real)
    jacobian = np.empty((*_leading, 36), _real)
    pose[..., 0] = c6 * t8 + s6 * t11
    pose[..., 1] = c6 * t11 - t8 * s6
    pose[..., 2] = t12
    pose[..., 3] = t16
    pose[..., 4] = c6 * t24 + s6 * t27
    pose[..., 5] = c6 * t27 - s6 * t24
    pose[..., 6] = t28
    pose[..., 7] = t32
    pose[..., 8] = c6 * t38 + s6 * t41
    pose[..., 9] = c6 * t41 - s6 * t38
    pose[..., 10] = t42
    pose[..., 11] = t46
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    jacobian[..., 0] = -t32
    jacobian[..., 1] = -(c1 * t47)
    jacobian[..., 2] = c1 * t48
    jacobian[..., 3] = -(t35 * t49 + t22 * t50)
    jacobian[..., 4] = t25 * t51 - t39 * t52
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t16
    jacobian[..., 7] = -(s1 * t47)
    jacobian[..., 8] = s1 * t48
    jacobian[..., 9] = t6 * t50 + t35 * t53
    jacobian[..., 10] = t39 * t54 - t9 * t51
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = c1 * t16 + s1 * t32
    jacobian[..., 14] = -(c1 * (t16 - t13) + s1 * (t32 - t29))
    jacobian[..., 15] = t22 * t53 - t6 * t49
    jacobian[..., 16] = t9 * t52 - t25 * t54
    jacobian[..., 17] = 0.0
    jacobian[..., 18] = 0.0
    jacobian[..., 19] = s1
    jacobian[..., 20] = -s1
    jacobian[..., 21] = -t6
    jacobian[..., 22] = t9
    jacobian[..., 23] = t12
    jacobian[..., 24] = 0.0
    jacobian[..., 25] = -c1
    jacobian[..., 26] = c1
    jacobian[..., 27] = -t22
    jacobian[..., 28] = t25
    jacobian[..., 29] = t28
    jacobian[..., 30] = 1
    jacobian[..., 31] = 0.0
    jacobian[..., 32] = 0.0
    jacobian[..., 33] = t35
    jacobian[..., 34] = t39
    jacobian[..., 35] = t42
    return pose.reshape(_leading + (4, 4)), jacobian.reshape(_leading + (6, 6))
