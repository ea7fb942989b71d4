"""manipulability (position) of puma560, in NumPy.

Made from templates/kernel.py.j2; inputs 403484bd98dcf16f8dc620165ff2764dae3cc55184b0b2bedf98c94c41e3888d.
435 operations. Do not edit: change the derivation and regenerate.

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
    """projector I - J^+ J onto the null space of the position Jacobian: 288 operations.

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
    t7 = 0.15005 / t6
    t8 = np.where(t6 != 0.0, t4 / t6, 0.0)
    t9 = np.where(t6 != 0.0, t5 / t6, 0.0)
    t10 = np.where(t6 != 0.0, np.where(t6 != 0.0, t7 * t7, 0.0), 0.0) + t8 * t8 + t9 * t9
    t11 = np.sqrt(t10)
    t12 = t7 / t11
    t13 = 0.4318 * c2
    t14 = t13 + 0.0203 * t3 - 0.4318 * t2
    t15 = t12 * t14
    t16 = t14 - np.where(t6 != 0.0, np.where(t11 != 0.0, np.where(t6 != 0.0, np.where(t11 != 0.0, t12 * t15, 0.0), 0.0), 0.0), 0.0)
    t17 = t8 / t11
    t18 = np.where(t11 != 0.0, np.where(t6 != 0.0, np.where(t11 != 0.0, -(t15 * t17), 0.0), 0.0), 0.0)
    t19 = t9 / t11
    t20 = np.where(t11 != 0.0, np.where(t6 != 0.0, np.where(t11 != 0.0, -(t15 * t19), 0.0), 0.0), 0.0)
    t21 = np.sqrt((t16 * t16 + t18 * t18 + t20 * t20))
    t22 = t16 / t21
    t23 = t18 / t21
    t24 = t20 / t21
    t25 = np.where(t6 != 0.0, np.where(t11 != 0.0, t12 * t22, 0.0), 0.0) + np.where(t11 != 0.0, t17 * t23, 0.0) + np.where(t11 != 0.0, t19 * t24, 0.0)
    t26 = np.where(t21 != 0.0, t22, 0.0) - np.where(t6 != 0.0, np.where(t11 != 0.0, np.where(t21 != 0.0, t12 * t25, 0.0), 0.0), 0.0)
    t27 = np.where(t21 != 0.0, -t23, 0.0) - np.where(t11 != 0.0, np.where(t21 != 0.0, -(t17 * t25), 0.0), 0.0)
    t28 = np.where(t21 != 0.0, -t24, 0.0) - np.where(t11 != 0.0, np.where(t21 != 0.0, -(t19 * t25), 0.0), 0.0)
    t29 = np.sqrt((t26 * t26 + t27 * t27 + t28 * t28))
    t30 = t26 / t29
    t31 = 1 - np.where(t6 != 0.0, np.where(t11 != 0.0, np.where(t6 != 0.0, np.where(t11 != 0.0, t12 * t12, 0.0), 0.0), 0.0), 0.0) - np.where(t29 != 0.0, np.where(t29 != 0.0, t30 * t30, 0.0), 0.0)
    t32 = t14 - t13
    t33 = t14 * t17 + t19 * t32
    t34 = t12 * t33
    t35 = t14 - np.where(t11 != 0.0, np.where(t11 != 0.0, t17 * t33, 0.0), 0.0)
    t36 = t27 / t29
    t37 = t35 * t36 - np.where(t6 != 0.0, np.where(t11 != 0.0, np.where(t11 != 0.0, -(t30 * t34), 0.0), 0.0), 0.0)
    t38 = t32 - np.where(t11 != 0.0, np.where(t11 != 0.0, t19 * t33, 0.0), 0.0)
    t39 = t28 / t29
    t40 = t37 + t38 * t39
    t41 = np.where(t6 != 0.0, np.where(t11 != 0.0, np.where(t11 != 0.0, -t34, 0.0), 0.0), 0.0) + np.where(t29 != 0.0, np.where(t29 != 0.0, t30 * t40, 0.0), 0.0)
    t42 = t35 - np.where(t29 != 0.0, np.where(t29 != 0.0, t36 * t40, 0.0), 0.0)
    t43 = t38 - np.where(t29 != 0.0, np.where(t29 != 0.0, t39 * t40, 0.0), 0.0)
    t44 = np.sqrt((t41 * t41 + t42 * t42 + t43 * t43))
    t45 = t41 / t44
    t46 = t42 / t44
    t47 = np.where(t6 != 0.0, np.where(t11 != 0.0, -(t12 * t45), 0.0), 0.0) + np.where(t11 != 0.0, -(t17 * t46), 0.0)
    t48 = t43 / t44
    t49 = t47 + np.where(t11 != 0.0, -(t19 * t48), 0.0)
    t50 = np.where(t44 != 0.0, -t45, 0.0) - np.where(t6 != 0.0, np.where(t11 != 0.0, np.where(t44 != 0.0, t12 * t49, 0.0), 0.0), 0.0)
    t51 = np.where(t44 != 0.0, t46, 0.0) - np.where(t11 != 0.0, np.where(t44 != 0.0, -(t17 * t49), 0.0), 0.0)
    t52 = np.where(t44 != 0.0, t48, 0.0) - np.where(t11 != 0.0, np.where(t44 != 0.0, -(t19 * t49), 0.0), 0.0)
    t53 = t30 * t50 + t36 * t51 + t39 * t52
    t54 = t50 - np.where(t29 != 0.0, np.where(t29 != 0.0, t30 * t53, 0.0), 0.0)
    t55 = t51 - np.where(t29 != 0.0, np.where(t29 != 0.0, t36 * t53, 0.0), 0.0)
    t56 = t52 - np.where(t29 != 0.0, np.where(t29 != 0.0, t39 * t53, 0.0), 0.0)
    t57 = np.sqrt((t54 * t54 + t55 * t55 + t56 * t56))
    t58 = t54 / t57
    t59 = np.where(t11 != 0.0, np.where(t6 != 0.0, np.where(t11 != 0.0, -(t12 * t17), 0.0), 0.0), 0.0) + np.where(t29 != 0.0, np.where(t29 != 0.0, t30 * t36, 0.0), 0.0)
    t60 = t55 / t57
    t61 = -(t59 + np.where(t57 != 0.0, np.where(t57 != 0.0, t58 * t60, 0.0), 0.0))
    t62 = np.where(t11 != 0.0, np.where(t6 != 0.0, np.where(t11 != 0.0, -(t12 * t19), 0.0), 0.0), 0.0) + np.where(t29 != 0.0, np.where(t29 != 0.0, t30 * t39, 0.0), 0.0)
    t63 = t56 / t57
    t64 = -(t62 + np.where(t57 != 0.0, np.where(t57 != 0.0, t58 * t63, 0.0), 0.0))
    t65 = 1 - np.where(t11 != 0.0, np.where(t11 != 0.0, t17 * t17, 0.0), 0.0) - np.where(t29 != 0.0, np.where(t29 != 0.0, t36 * t36, 0.0), 0.0)
    t66 = np.where(t11 != 0.0, np.where(t11 != 0.0, t17 * t19, 0.0), 0.0) + np.where(t29 != 0.0, np.where(t29 != 0.0, t36 * t39, 0.0), 0.0)
    t67 = -(t66 + np.where(t57 != 0.0, np.where(t57 != 0.0, t60 * t63, 0.0), 0.0))
    t68 = 1 - np.where(t11 != 0.0, np.where(t11 != 0.0, t19 * t19, 0.0), 0.0) - np.where(t29 != 0.0, np.where(t29 != 0.0, t39 * t39, 0.0), 0.0)

    # results
    null_projector = np.empty((*_leading, 36), _real)
    null_projector[..., 0] = t31 - np.where(t57 != 0.0, np.where(t57 != 0.0, t58 * t58, 0.0), 0.0)
    null_projector[..., 1] = t61
    null_projector[..., 2] = t64
    null_projector[..., 3] = 0.0
    null_projector[..., 4] = 0.0
    null_projector[..., 5] = 0.0
    null_projector[..., 6] = t61
    null_projector[..., 7] = t65 - np.where(t57 != 0.0, np.where(t57 != 0.0, t60 * t60, 0.0), 0.0)
    null_projector[..., 8] = t67
    null_projector[..., 9] = 0.0
    null_projector[..., 10] = 0.0
    null_projector[..., 11] = 0.0
    null_projector[..., 12] = t64
    null_projector[..., 13] = t67
    null_projector[..., 14] = t68 - np.where(t57 != 0.0, np.where(t57 != 0.0, t63 * t63, 0.0), 0.0)
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
