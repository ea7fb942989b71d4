"""manipulability (position) of puma560, in NumPy.

Made from templates/kernel.py.j2; inputs 9c5263d0a335170a00b1a4b41977fae67b8eb34dc3618159050b7d905fdd6b83.
298 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_position(q):
    """manipulability H = sqrt(det(J J^T)) of the position Jacobian: 28 operations.

    in   q[6]
    out  manipulability (one number)
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)

    # terms
    t1 = 0.4318 * c2
    t2 = c2 * c3 - s2 * s3
    t3 = c2 * s3 + c3 * s2
    t4 = t1 + 0.0203 * t2 - 0.4318 * t3
    t5 = 0.4318 * s2
    t6 = t5 + 0.0203 * t3 + 0.4318 * t2
    t7 = t4 * (t4 - t1) * t6 - t4 * t4 * (t6 - t5)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.abs(t7)
    return manipulability.reshape(_leading)


def manipulability_gradient_position(q):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in lexicographic order: 92 operations.

    in   q[6]
    out  manipulability (one number)
    out  gradient[6]
    out  inverse_gradient[6]
    out  inverse_root_gradient[6]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)

    # terms
    t1 = 0.4318 * c2
    t2 = c2 * c3 - s2 * s3
    t3 = c2 * s3 + c3 * s2
    t4 = t1 + 0.0203 * t2 - 0.4318 * t3
    t5 = t4 - t1
    t6 = t4 * t5
    t7 = 0.4318 * s2
    t8 = t7 + 0.0203 * t3 + 0.4318 * t2
    t9 = t4 * t4
    t10 = t8 - t7
    t11 = t6 * t8 - t9 * t10
    t12 = np.abs(t11)
    t13 = t11 / t12
    t14 = t6 * t13
    t15 = t14 - t9 * t13
    t16 = 0.0203 * t15
    t17 = t8 * t13
    t18 = t5 * t17 - (t4 + t4) * (t10 * t13)
    t19 = t18 + t4 * t17
    t20 = 0.4318 * t19
    t21 = 0.4318 * t15 + 0.0203 * t19
    t22 = c3 * t16 + 0.4318 * t14 - c3 * t20 - s3 * t21
    t23 = s3 * t16 - s3 * t20 + c3 * t21 + 0.4318 * t18
    t24 = c2 * t22 - s2 * t23
    t25 = c3 * (c2 * t16 - c2 * t20 - s2 * t21) - s3 * (s2 * t16 - s2 * t20 + c2 * t21)
    t26 = 1 / t12
    t27 = t26 * t26
    t28 = -0.5 / t12 * np.sqrt(t26)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 6), _real)
    inverse_gradient = np.empty((*_leading, 6), _real)
    inverse_root_gradient = np.empty((*_leading, 6), _real)
    manipulability[..., 0] = t12
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t12 != 0.0, t24, 0.0)
    gradient[..., 2] = np.where(t12 != 0.0, t25, 0.0)
    gradient[..., 3] = 0.0
    gradient[..., 4] = 0.0
    gradient[..., 5] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t12 != 0.0, -(t24 * t27), 0.0)
    inverse_gradient[..., 2] = np.where(t12 != 0.0, -(t25 * t27), 0.0)
    inverse_gradient[..., 3] = 0.0
    inverse_gradient[..., 4] = 0.0
    inverse_gradient[..., 5] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t12 != 0.0, t24 * t28, 0.0)
    inverse_root_gradient[..., 2] = np.where(t12 != 0.0, t25 * t28, 0.0)
    inverse_root_gradient[..., 3] = 0.0
    inverse_root_gradient[..., 4] = 0.0
    inverse_root_gradient[..., 5] = 0.0
    return manipulability.reshape(_leading), gradient.reshape(_leading + (6,)), inverse_gradient.reshape(_leading + (6,)), inverse_root_gradient.reshape(_leading + (6,))


def minors_position(q):
    """maximal minors of the position Jacobian, columns in lexicographic order: 27 operations.

    in   q[6]
    out  minors[20]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)

    # terms
    t1 = 0.4318 * c2
    t2 = c2 * c3 - s2 * s3
    t3 = c2 * s3 + c3 * s2
    t4 = t1 + 0.0203 * t2 - 0.4318 * t3
    t5 = 0.4318 * s2
    t6 = t5 + 0.0203 * t3 + 0.4318 * t2
    t7 = t4 * (t4 - t1) * t6 - t4 * t4 * (t6 - t5)

    # results
    minors = np.empty((*_leading, 20), _real)
    minors[..., 0] = t7
    minors[..., 1] = 0.0
    minors[..., 2] = 0.0
    minors[..., 3] = 0.0
    minors[..., 4] = 0.0
    minors[..., 5] = 0.0
    minors[..., 6] = 0.0
    minors[..., 7] = 0.0
    minors[..., 8] = 0.0
    minors[..., 9] = 0.0
    minors[..., 10] = 0.0
    minors[..., 11] = 0.0
    minors[..., 12] = 0.0
    minors[..., 13] = 0.0
    minors[..., 14] = 0.0
    minors[..., 15] = 0.0
    minors[..., 16] = 0.0
    minors[..., 17] = 0.0
    minors[..., 18] = 0.0
    minors[..., 19] = 0.0
    return minors.reshape(_leading + (20,))


def null_projector_position(q):
    """projector I - J^+ J onto the null space of the position Jacobian: 151 operations.

    in   q[6]
    out  null_projector[6][6]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)

    # terms
    t1 = 0.4318 * s2
    t2 = c2 * s3 + s2 * c3
    t3 = c2 * c3 - s2 * s3
    t4 = t1 + 0.0203 * t2 + 0.4318 * t3
    t5 = t4 - t1
    t6 = np.sqrt((0.022515002499999996 + t4 * t4 + t5 * t5))
    t7 = np.where(t6 != 0.0, 1, 0.0)
    t8 = t7 / (t6 + (1 - t7))
    t9 = 0.15005 * t8
    t10 = 0.4318 * c2
    t11 = t10 + 0.0203 * t3 - 0.4318 * t2
    t12 = t9 * t11
    t13 = t11 - t9 * t12
    t14 = t4 * t8
    t15 = t12 * t14
    t16 = t5 * t8
    t17 = t12 * t16
    t18 = t9 * t13 - t14 * t15 - t16 * t17
    t19 = t13 - t9 * t18
    t20 = t15 + t14 * t18
    t21 = t17 + t16 * t18
    t22 = np.sqrt((t19 * t19 + t20 * t20 + t21 * t21))
    t23 = np.where(t22 != 0.0, 1, 0.0)
    t24 = t23 / (t22 + (1 - t23))
    t25 = t19 * t24
    t26 = t11 - t10
    t27 = t11 * t14 + t16 * t26
    t28 = t9 * t27
    t29 = t11 - t14 * t27
    t30 = t20 * t24
    t31 = t26 - t16 * t27
    t32 = t21 * t24
    t33 = t25 * t28 + t29 * t30 + t31 * t32
    t34 = t28 - t25 * t33
    t35 = t29 - t30 * t33
    t36 = t31 - t32 * t33
    t37 = t9 * t34 - t14 * t35 - t16 * t36
    t38 = t34 - t9 * t37
    t39 = t35 + t14 * t37
    t40 = t36 + t16 * t37
    t41 = t25 * t38 + t30 * t39 + t32 * t40
    t42 = t38 - t25 * t41
    t43 = t39 - t30 * t41
    t44 = t40 - t32 * t41
    t45 = np.sqrt((t42 * t42 + t43 * t43 + t44 * t44))
    t46 = np.where(t45 != 0.0, 1, 0.0)
    t47 = t46 / (t45 + (1 - t46))
    t48 = t42 * t47
    t49 = t43 * t47
    t50 = t9 * t14 - t25 * t30 - t48 * t49
    t51 = t44 * t47
    t52 = t9 * t16 - t25 * t32 - t48 * t51
    t53 = -(t14 * t16 + t30 * t32 + t49 * t51)

    # results
    null_projector = np.empty((*_leading, 36), _real)
    null_projector[..., 0] = 1 - t9 * t9 - t25 * t25 - t48 * t48
    null_projector[..., 1] = t50
    null_projector[..., 2] = t52
    null_projector[..., 3] = 0.0
    null_projector[..., 4] = 0.0
    null_projector[..., 5] = 0.0
    null_projector[..., 6] = t50
    null_projector[..., 7] = 1 - t14 * t14 - t30 * t30 - t49 * t49
    null_projector[..., 8] = t53
    null_projector[..., 9] = 0.0
    null_projector[..., 10] = 0.0
    null_projector[..., 11] = 0.0
    null_projector[..., 12] = t52
    null_projector[..., 13] = t53
    null_projector[..., 14] = 1 - t16 * t16 - t32 * t32 - t51 * t51
    null_projector[..., 15] = 0.0
    null_projector[..., 16] = 0.0
    null_projector[..., 17] = 0.0
    null_projector[..., 18] = 0.0
    null_projector[..., 19] = 0.0
    null_projector[..., 20] = 0.0
    null_projector[..., 21] = 1
    null_projector[..., 22] = 0.0
    null_projector[..., 23] = 0.0
    null_projector[..., 24] = 0.0
    null_projector[..., 25] = 0.0
    null_projector[..., 26] = 0.0
    null_projector[..., 27] = 0.0
    null_projector[..., 28] = 1
    null_projector[..., 29] = 0.0
    null_projector[..., 30] = 0.0
    null_projector[..., 31] = 0.0
    null_projector[..., 32] = 0.0
    null_projector[..., 33] = 0.0
    null_projector[..., 34] = 0.0
    null_projector[..., 35] = 1
    return null_projector.reshape(_leading + (6, 6))
