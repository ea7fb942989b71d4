"""kinematics of ur5e, in NumPy.

Made from templates/kernel.py.j2; inputs 95b3eaf6da9600783965b004b6713c6e10ce165a315e7cbe37703d414cb2318a.
730 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def position(q):
    """position of the tip, in the base frame: 83 operations.

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
    c2 = np.cos(q2)
    s1 = np.sin(q1)
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
    t1 = c1 * c2
    t2 = c1 * s2
    t3 = t1 * c3 - s3 * t2
    t4 = c3 * t2 + t1 * s3
    t5 = -0.425 * t1 + 0.1333 * s1 - 0.3922 * t3 + 0.0997 * (c4 * t4 + t3 * s4)
    t6 = 0.0996 * (s1 * c5 - s5 * (t3 * c4 - t4 * s4))
    t7 = c2 * s1
    t8 = s1 * s2
    t9 = c3 * t7 - s3 * t8
    t10 = c3 * t8 + s3 * t7
    t11 = -0.425 * t7 - 0.1333 * c1 - 0.3922 * t9 + 0.0997 * (c4 * t10 + s4 * t9)
    t12 = 0.0996 * (c1 * c5 + s5 * (c4 * t9 - s4 * t10))
    t13 = c2 * s3 + c3 * s2
    t14 = c2 * c3 - s3 * s2
    t15 = 0.1625 - 0.425 * s2 - 0.3922 * t13 - 0.0997 * (c4 * t14 - s4 * t13)

    # results
    position = np.empty((*_leading, 3), _real)
    position[..., 0] = t5 + t6
    position[..., 1] = t11 - t12
    position[..., 2] = t15 - 0.0996 * (s5 * (c4 * t13 + s4 * t14))
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
    c2 = np.cos(q2)
    s3 = np.sin(q3)
    s2 = np.sin(q2)
    s4 = np.sin(q4)
    s1 = np.sin(q1)
    s5 = np.sin(q5)
    s6 = np.sin(q6)

    # terms
    t1 = c1 * c2
    t2 = c1 * s2
    t3 = c3 * t1 - s3 * t2
    t4 = c3 * t2 + t1 * s3
    t5 = c4 * t3 - s4 * t4
    t6 = c5 * t5 + s1 * s5
    t7 = c4 * t4 + t3 * s4
    t8 = c5 * s1 - t5 * s5
    t9 = -0.425 * t1 + 0.1333 * s1 - 0.3922 * t3 + 0.0997 * t7
    t10 = c2 * s1
    t11 = s2 * s1
    t12 = c3 * t10 - s3 * t11
    t13 = c3 * t11 + s3 * t10
    t14 = c4 * t12 - s4 * t13
    t15 = c5 * t14 - c1 * s5
    t16 = c4 * t13 + s4 * t12
    t17 = c5 * c1 + s5 * t14
    t18 = -0.425 * t10 - 0.1333 * c1 - 0.3922 * t12 + 0.0997 * t16
    t19 = c2 * s3 + c3 * s2
    t20 = c3 * c2 - s3 * s2
    t21 = c4 * t19 + s4 * t20
    t22 = c5 * t21
    t23 = c4 * t20 - s4 * t19
    t24 = s5 * t21
    t25 = 0.1625 - 0.425 * s2 - 0.3922 * t19 - 0.0997 * t23 - 0.0996 * t24

    # results
    pose = np.empty((*_leading, 16), _real)
    pose[..., 0] = c6 * t6 - s6 * t7
    pose[..., 1] = -(c6 * t7 + t6 * s6)
    pose[..., 2] = t8
    pose[..., 3] = t9 + 0.0996 * t8
    pose[..., 4] = c6 * t15 - s6 * t16
    pose[..., 5] = -(c6 * t16 + s6 * t15)
    pose[..., 6] = -t17
    pose[..., 7] = t18 - 0.0996 * t17
    pose[..., 8] = c6 * t22 + s6 * t23
    pose[..., 9] = c6 * t23 - s6 * t22
    pose[..., 10] = -t24
    pose[..., 11] = t25
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    return pose.reshape(_leading + (4, 4))


def jacobian_position(q):
    """Jacobian of the position, in the base frame: 124 operations.

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
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)

    # terms
    t1 = c2 * s1
    t2 = -0.425 * t1
    t3 = s1 * s2
    t4 = t1 * c3 - s3 * t3
    t5 = t2 - 0.1333 * c1 - 0.3922 * t4
    t6 = c3 * t3 + t1 * s3
    t7 = c4 * t6 + t4 * s4
    t8 = t5 + 0.0997 * t7
    t9 = 0.0996 * (c1 * c5 + s5 * (t4 * c4 - t6 * s4))
    t10 = t8 - t9
    t11 = 0.1625 - 0.425 * s2
    t12 = c2 * s3 + c3 * s2
    t13 = t11 - 0.3922 * t12
    t14 = c2 * c3 - s3 * s2
    t15 = c4 * t14 - s4 * t12
    t16 = t13 - 0.0997 * t15
    t17 = t16 - 0.0996 * (s5 * (c4 * t12 + s4 * t14))
    t18 = t17 - 0.1625
    t19 = t17 - t11
    t20 = t17 - t13
    t21 = t10 - t8
    t22 = t17 - t16
    t23 = c2 * c1
    t24 = -0.425 * t23
    t25 = c1 * s2
    t26 = c3 * t23 - s3 * t25
    t27 = t24 + 0.1333 * s1 - 0.3922 * t26
    t28 = c3 * t25 + s3 * t23
    t29 = c4 * t28 + s4 * t26
    t30 = 0.0996 * (s1 * c5 - s5 * (c4 * t26 - s4 * t28))
    t31 = t27 + 0.0997 * t29 + t30

    # results
    jacobian = np.empty((*_leading, 18), _real)
    jacobian[..., 0] = -t10
    jacobian[..., 1] = -(c1 * t18)
    jacobian[..., 2] = -(c1 * t19)
    jacobian[..., 3] = -(c1 * t20)
    jacobian[..., 4] = t15 * t21 + t7 * t22
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t31
    jacobian[..., 7] = -(s1 * t18)
    jacobian[..., 8] = -(s1 * t19)
    jacobian[..., 9] = -(s1 * t20)
    jacobian[..., 10] = -(t22 * t29 + t15 * t30)
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = c1 * t31 + s1 * t10
    jacobian[..., 14] = c1 * (t31 - t24) + s1 * (t10 - t2)
    jacobian[..., 15] = c1 * (t31 - t27) + s1 * (t10 - t5)
    jacobian[..., 16] = t21 * t29 - t7 * t30
    jacobian[..., 17] = 0.0
    return jacobian.reshape(_leading + (3, 6))


def jacobian_pose(q):
    """Jacobian of the pose, in the base frame: 128 operations.

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
    t2 = -0.425 * t1
    t3 = s1 * s2
    t4 = t1 * c3 - s3 * t3
    t5 = t2 - 0.1333 * c1 - 0.3922 * t4
    t6 = c3 * t3 + t1 * s3
    t7 = c4 * t6 + t4 * s4
    t8 = t5 + 0.0997 * t7
    t9 = c1 * c5 + s5 * (t4 * c4 - t6 * s4)
    t10 = t8 - 0.0996 * t9
    t11 = 0.1625 - 0.425 * s2
    t12 = c2 * s3 + c3 * s2
    t13 = t11 - 0.3922 * t12
    t14 = c2 * c3 - s3 * s2
    t15 = c4 * t14 - s4 * t12
    t16 = t13 - 0.0997 * t15
    t17 = s5 * (c4 * t12 + s4 * t14)
    t18 = t16 - 0.0996 * t17
    t19 = t18 - 0.1625
    t20 = t18 - t11
    t21 = t18 - t13
    t22 = t10 - t8
    t23 = t18 - t16
    t24 = c2 * c1
    t25 = -0.425 * t24
    t26 = c1 * s2
    t27 = c3 * t24 - s3 * t26
    t28 = t25 + 0.1333 * s1 - 0.3922 * t27
    t29 = c3 * t26 + s3 * t24
    t30 = c4 * t29 + s4 * t27
    t31 = s1 * c5 - s5 * (c4 * t27 - s4 * t29)
    t32 = 0.0996 * t31
    t33 = t28 + 0.0997 * t30 + t32
    t34 = -c1

    # results
    jacobian = np.empty((*_leading, 36), _real)
    jacobian[..., 0] = -t10
    jacobian[..., 1] = -(c1 * t19)
    jacobian[..., 2] = -(c1 * t20)
    jacobian[..., 3] = -(c1 * t21)
    jacobian[..., 4] = t15 * t22 + t7 * t23
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t33
    jacobian[..., 7] = -(s1 * t19)
    jacobian[..., 8] = -(s1 * t20)
    jacobian[..., 9] = -(s1 * t21)
    jacobian[..., 10] = -(t23 * t30 + t15 * t32)
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = c1 * t33 + s1 * t10
    jacobian[..., 14] = c1 * (t33 - t25) + s1 * (t10 - t2)
    jacobian[..., 15] = c1 * (t33 - t28) + s1 * (t10 - t5)
    jacobian[..., 16] = t22 * t30 - t7 * t32
    jacobian[..., 17] = 0.0
    jacobian[..., 18] = 0.0
    jacobian[..., 19] = s1
    jacobian[..., 20] = s1
    jacobian[..., 21] = s1
    jacobian[..., 22] = t30
    jacobian[..., 23] = t31
    jacobian[..., 24] = 0.0
    jacobian[..., 25] = t34
    jacobian[..., 26] = t34
    jacobian[..., 27] = t34
    jacobian[..., 28] = t7
    jacobian[..., 29] = -t9
    jacobian[..., 30] = 1
    jacobian[..., 31] = 0.0
    jacobian[..., 32] = 0.0
    jacobian[..., 33] = 0.0
    jacobian[..., 34] = -t15
    jacobian[..., 35] = -t17
    return jacobian.reshape(_leading + (6, 6))


def kinematics_position(q):
    """position and its Jacobian, in the base frame: 124 operations.

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
    c2 = np.cos(q2)
    s1 = np.sin(q1)
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
    t1 = c1 * c2
    t2 = -0.425 * t1
    t3 = c1 * s2
    t4 = t1 * c3 - s3 * t3
    t5 = t2 + 0.1333 * s1 - 0.3922 * t4
    t6 = c3 * t3 + t1 * s3
    t7 = c4 * t6 + t4 * s4
    t8 = 0.0996 * (s1 * c5 - s5 * (t4 * c4 - t6 * s4))
    t9 = t5 + 0.0997 * t7 + t8
    t10 = c2 * s1
    t11 = -0.425 * t10
    t12 = s1 * s2
    t13 = c3 * t10 - s3 * t12
    t14 = t11 - 0.1333 * c1 - 0.3922 * t13
    t15 = c3 * t12 + s3 * t10
    t16 = c4 * t15 + s4 * t13
    t17 = t14 + 0.0997 * t16
    t18 = 0.0996 * (c1 * c5 + s5 * (c4 * t13 - s4 * t15))
    t19 = t17 - t18
    t20 = 0.1625 - 0.425 * s2
    t21 = c2 * s3 + c3 * s2
    t22 = t20 - 0.3922 * t21
    t23 = c2 * c3 - s3 * s2
    t24 = c4 * t23 - s4 * t21
    t25 = t22 - 0.0997 * t24
    t26 = t25 - 0.0996 * (s5 * (c4 * t21 + s4 * t23))
    t27 = t26 - 0.1625
    t28 = t26 - t20
    t29 = t26 - t22
    t30 = t19 - t17
    t31 = t26 - t25

    # results
    position = np.empty((*_leading, 3), _real)
    jacobian = np.empty((*_leading, 18), _real)
    position[..., 0] = t9
    position[..., 1] = t19
    position[..., 2] = t26
    jacobian[..., 0] = -t19
    jacobian[..., 1] = -(c1 * t27)
    jacobian[..., 2] = -(c1 * t28)
    jacobian[..., 3] = -(c1 * t29)
    jacobian[..., 4] = t24 * t30 + t16 * t31
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t9
    jacobian[..., 7] = -(s1 * t27)
    jacobian[..., 8] = -(s1 * t28)
    jacobian[..., 9] = -(s1 * t29)
    jacobian[..., 10] = -(t7 * t31 + t8 * t24)
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = c1 * t9 + s1 * t19
    jacobian[..., 14] = c1 * (t9 - t2) + s1 * (t19 - t11)
    jacobian[..., 15] = c1 * (t9 - t5) + s1 * (t19 - t14)
    jacobian[..., 16] = t7 * t30 - t8 * t16
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
    c2 = np.cos(q2)
    s3 = np.sin(q3)
    s2 = np.sin(q2)
    s4 = np.sin(q4)
    s1 = np.sin(q1)
    s5 = np.sin(q5)
    s6 = np.sin(q6)

    # terms
    t1 = c1 * c2
    t2 = c1 * s2
    t3 = c3 * t1 - s3 * t2
    t4 = c3 * t2 + t1 * s3
    t5 = c4 * t3 - s4 * t4
    t6 = c5 * t5 + s1 * s5
    t7 = c4 * t4 + t3 * s4
    t8 = c5 * s1 - t5 * s5
    t9 = -0.425 * t1
    t10 = t9 + 0.1333 * s1 - 0.3922 * t3
    t11 = 0.0996 * t8
    t12 = t10 + 0.0997 * t7 + t11
    t13 = c2 * s1
    t14 = s2 * s1
    t15 = c3 * t13 - s3 * t14
    t16 = c3 * t14 + s3 * t13
    t17 = c4 * t15 - s4 * t16
    t18 = c5 * t17 - c1 * s5
    t19 = c4 * t16 + s4 * t15
    t20 = c5 * c1 + s5 * t17
    t21 = -t20
    t22 = -0.425 * t13
    t23 = t22 - 0.1333 * c1 - 0.3922 * t15
    t24 = t23 + 0.0997 * t19
    t25 = t24 - 0.0996 * t20
    t26 = c2 * s3 + c3 * s2
    t27 = c3 * c2 - s3 * s2
    t28 = c4 * t26 + s4 * t27
    t29 = c5 * t28
    t30 = c4 * t27 - s4 * t26
    t31 = s5 * t28
    t32 = -t31
    t33 = 0.1625 - 0.425 * s2
    t34 = t33 - 0.3922 * t26
    t35 = t34 - 0.0997 * t30
    t36 = t35 - 0.0996 * t31
    t37 = t36 - 0.1625
    t38 = t36 - t33
    t39 = t36 - t34
    t40 = t25 - t24
    t41 = t36 - t35
    t42 = -c1

    # results
    pose = np.empty((*_leading, 16), _real)
    jacobian = np.empty((*_leading, 36), _real)
    pose[..., 0] = c6 * t6 - s6 * t7
    pose[..., 1] = -(c6 * t7 + t6 * s6)
    pose[..., 2] = t8
    pose[..., 3] = t12
    pose[..., 4] = c6 * t18 - s6 * t19
    pose[..., 5] = -(c6 * t19 + s6 * t18)
    pose[..., 6] = t21
    pose[..., 7] = t25
    pose[..., 8] = c6 * t29 + s6 * t30
    pose[..., 9] = c6 * t30 - s6 * t29
    pose[..., 10] = t32
    pose[..., 11] = t36
    pose[..., 12] = 0.0
    pose[..., 13] = 0.0
    pose[..., 14] = 0.0
    pose[..., 15] = 1
    jacobian[..., 0] = -t25
    jacobian[..., 1] = -(c1 * t37)
    jacobian[..., 2] = -(c1 * t38)
    jacobian[..., 3] = -(c1 * t39)
    jacobian[..., 4] = t30 * t40 + t19 * t41
    jacobian[..., 5] = 0.0
    jacobian[..., 6] = t12
    jacobian[..., 7] = -(s1 * t37)
    jacobian[..., 8] = -(s1 * t38)
    jacobian[..., 9] = -(s1 * t39)
    jacobian[..., 10] = -(t7 * t41 + t11 * t30)
    jacobian[..., 11] = 0.0
    jacobian[..., 12] = 0.0
    jacobian[..., 13] = c1 * t12 + s1 * t25
    jacobian[..., 14] = c1 * (t12 - t9) + s1 * (t25 - t22)
    jacobian[..., 15] = c1 * (t12 - t10) + s1 * (t25 - t23)
    jacobian[..., 16] = t7 * t40 - t11 * t19
    jacobian[..., 17] = 0.0
    jacobian[..., 18] = 0.0
    jacobian[..., 19] = s1
    jacobian[..., 20] = s1
    jacobian[..., 21] = s1
    jacobian[..., 22] = t7
    jacobian[..., 23] = t8
    jacobian[..., 24] = 0.0
    jacobian[..., 25] = t42
    jacobian[..., 26] = t42
    jacobian[..., 27] = t42
    jacobian[..., 28] = t19
    jacobian[..., 29] = t21
    jacobian[..., 30] = 1
    jacobian[..., 31] = 0.0
    jacobian[..., 32] = 0.0
    jacobian[..., 33] = 0.0
    jacobian[..., 34] = -t30
    jacobian[..., 35] = t32
    return pose.reshape(_leading + (4, 4)), jacobian.reshape(_leading + (6, 6))
