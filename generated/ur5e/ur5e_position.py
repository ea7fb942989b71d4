"""manipulability (position) of ur5e, in NumPy.

Made from templates/kernel.py.j2; inputs 5dc07d78cae81427f9819e91aec98e9750a25de159f348f4edc3813203ea2520.
1082 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_position(q):
    """manipulability H = sqrt(det(J J^T)) of the position Jacobian: 108 operations.

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
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q5 = q[..., 4]
    s5 = np.sin(q5)
    c5 = np.cos(q5)

    # terms
    t1 = -0.425 * c2
    t2 = c2 * c3 - s2 * s3
    t3 = t1 - 0.3922 * t2
    t4 = c2 * s3 + c3 * s2
    t5 = c4 * t4 + t2 * s4
    t6 = t3 + 0.0997 * t5
    t7 = t2 * c4 - t4 * s4
    t8 = t6 - 0.0996 * (s5 * t7)
    t9 = t8 - t1
    t10 = t8 * t9
    t11 = -0.425 * s2
    t12 = t11 - 0.3922 * t4
    t13 = t12 - 0.0997 * t7
    t14 = t13 - 0.0996 * (t5 * s5)
    t15 = t8 * t8
    t16 = t14 - t11
    t17 = t10 * t14 - t15 * t16
    t18 = t8 - t3
    t19 = t8 * t18
    t20 = t14 - t12
    t21 = t14 * t19 - t15 * t20
    t22 = -0.1333 - 0.0996 * c5
    t23 = 0.1333 + t22
    t24 = t7 * t23
    t25 = t8 * (t5 * t23)
    t26 = t5 * (t14 - t13) + t7 * (t8 - t6)
    t27 = t8 * t26
    t28 = t15 * t24 + t14 * t25 - t22 * t27
    t29 = t16 * t19 - t10 * t20
    t30 = t17 * t17 + t21 * t21 + t28 * t28 + t29 * t29
    t31 = t9 * t26
    t32 = t10 * t24 + t16 * t25 - t22 * t31
    t33 = t18 * t26
    t34 = t19 * t24 + t20 * t25 - t22 * t33
    t35 = t16 * t27 - t14 * t31
    t36 = t20 * t27 - t14 * t33
    t37 = t30 + t32 * t32 + t34 * t34 + t35 * t35 + t36 * t36
    t38 = t20 * t31 - t16 * t33

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.sqrt((t37 + t38 * t38))
    return manipulability.reshape(_leading)


def manipulability_gradient_position(q):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in lexicographic order: 343 operations.

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
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q5 = q[..., 4]
    s5 = np.sin(q5)
    c5 = np.cos(q5)

    # terms
    t1 = -0.425 * c2
    t2 = c2 * c3 - s2 * s3
    t3 = t1 - 0.3922 * t2
    t4 = c2 * s3 + c3 * s2
    t5 = c4 * t4 + t2 * s4
    t6 = t3 + 0.0997 * t5
    t7 = t2 * c4 - t4 * s4
    t8 = t6 - 0.0996 * (s5 * t7)
    t9 = t8 - t1
    t10 = t8 * t9
    t11 = -0.425 * s2
    t12 = t11 - 0.3922 * t4
    t13 = t12 - 0.0997 * t7
    t14 = t13 - 0.0996 * (t5 * s5)
    t15 = t8 * t8
    t16 = t14 - t11
    t17 = t10 * t14 - t15 * t16
    t18 = t8 - t3
    t19 = t8 * t18
    t20 = t14 - t12
    t21 = t14 * t19 - t15 * t20
    t22 = -0.1333 - 0.0996 * c5
    t23 = 0.1333 + t22
    t24 = t7 * t23
    t25 = t5 * t23
    t26 = t8 * t25
    t27 = t14 - t13
    t28 = t8 - t6
    t29 = t5 * t27 + t7 * t28
    t30 = t8 * t29
    t31 = t15 * t24 + t14 * t26 - t22 * t30
    t32 = t16 * t19 - t10 * t20
    t33 = t17 * t17 + t21 * t21 + t31 * t31 + t32 * t32
    t34 = t9 * t29
    t35 = t10 * t24 + t16 * t26 - t22 * t34
    t36 = t18 * t29
    t37 = t19 * t24 + t20 * t26 - t22 * t36
    t38 = t16 * t30 - t14 * t34
    t39 = t20 * t30 - t14 * t36
    t40 = t33 + t35 * t35 + t37 * t37 + t38 * t38 + t39 * t39
    t41 = t20 * t34 - t16 * t36
    t42 = np.sqrt((t40 + t41 * t41))
    t43 = t41 / t42
    t44 = t38 / t42
    t45 = t35 / t42
    t46 = t20 * t43 - t14 * t44 - t22 * t45
    t47 = t39 / t42
    t48 = t37 / t42
    t49 = t16 * t43 + t14 * t47 + t22 * t48
    t50 = t31 / t42
    t51 = t20 * t47 + t16 * t44 - t22 * t50
    t52 = t9 * t46 - t18 * t49 + t8 * t51
    t53 = t5 * t52
    t54 = t32 / t42
    t55 = t34 * t43 + t30 * t47 + t26 * t48 - t10 * t54
    t56 = t21 / t42
    t57 = t55 - t15 * t56
    t58 = t53 - (t36 * t47 + t34 * t44) + t26 * t50 + t57
    t59 = t30 * t44 - t36 * t43 + t26 * t45 + t19 * t54
    t60 = t17 / t42
    t61 = t59 - t15 * t60
    t62 = t58 + t19 * t56 + t61 + t10 * t60
    t63 = t62 - t53
    t64 = t63 - t57
    t65 = 0.0996 * t62
    t66 = s5 * t65
    t67 = t19 * t48 + t10 * t45 + t15 * t50
    t68 = t28 * t52 + t23 * t67 - 0.0997 * t63
    t69 = c4 * t66 + s4 * t68 + 0.3922 * t64
    t70 = t7 * t52
    t71 = t20 * t48 + t16 * t45 + t14 * t50
    t72 = t24 * t48 + t16 * t54 + t14 * t56
    t73 = t8 * t72 - t29 * t49
    t74 = t29 * t51 + t70 + t25 * t71 + t18 * t72 + t73
    t75 = (t8 + t8) * (t24 * t50 - t20 * t56 - t16 * t60)
    t76 = t24 * t45 - t20 * t54 + t14 * t60
    t77 = t29 * t46 + t8 * t76
    t78 = t74 + t75 + t9 * t76 + t77
    t79 = 0.0996 * t78
    t80 = s5 * t79
    t81 = t8 * t71
    t82 = t78 - t70
    t83 = t27 * t52 + t23 * t81 + 0.0997 * t82
    t84 = s4 * t80 + c4 * t83
    t85 = c4 * t68 - s4 * t66 - c4 * t80 + s4 * t83
    t86 = t82 - t73
    t87 = t85 - 0.3922 * t86
    t88 = -0.425 * (t64 - t61) - c3 * t69 + c3 * t84 - s3 * t87
    t89 = s3 * t84 - s3 * t69 + c3 * t87 + -0.425 * (t86 - t77)
    t90 = c2 * t88 - s2 * t89
    t91 = c3 * (c2 * t84 - c2 * t69 - s2 * t87) - s3 * (s2 * t84 - s2 * t69 + c2 * t87)
    t92 = t4 * t80 - (t2 * t66 + t4 * t68) + t2 * t83
    t93 = t2 * t68 - t4 * t66 - t2 * t80 + t4 * t83
    t94 = c4 * t92 - s4 * t93
    t95 = t5 * t81 + t7 * t67 - (t36 * t48 + t34 * t45 + t30 * t50)
    t96 = s5 * (0.0996 * t95) - c5 * (t5 * t65 + t7 * t79)
    t97 = 1 / t42
    t98 = t97 * t97
    t99 = -0.5 / t42 * np.sqrt(t97)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 6), _real)
    inverse_gradient = np.empty((*_leading, 6), _real)
    inverse_root_gradient = np.empty((*_leading, 6), _real)
    manipulability[..., 0] = t42
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t42 != 0.0, t90, 0.0)
    gradient[..., 2] = np.where(t42 != 0.0, t91, 0.0)
    gradient[..., 3] = np.where(t42 != 0.0, t94, 0.0)
    gradient[..., 4] = np.where(t42 != 0.0, t96, 0.0)
    gradient[..., 5] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t42 != 0.0, -(t90 * t98), 0.0)
    inverse_gradient[..., 2] = np.where(t42 != 0.0, -(t91 * t98), 0.0)
    inverse_gradient[..., 3] = np.where(t42 != 0.0, -(t94 * t98), 0.0)
    inverse_gradient[..., 4] = np.where(t42 != 0.0, -(t96 * t98), 0.0)
    inverse_gradient[..., 5] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t42 != 0.0, t90 * t99, 0.0)
    inverse_root_gradient[..., 2] = np.where(t42 != 0.0, t91 * t99, 0.0)
    inverse_root_gradient[..., 3] = np.where(t42 != 0.0, t94 * t99, 0.0)
    inverse_root_gradient[..., 4] = np.where(t42 != 0.0, t96 * t99, 0.0)
    inverse_root_gradient[..., 5] = 0.0
    return manipulability.reshape(_leading), gradient.reshape(_leading + (6,)), inverse_gradient.reshape(_leading + (6,)), inverse_root_gradient.reshape(_leading + (6,))


def minors_position(q):
    """maximal minors of the position Jacobian, columns in lexicographic order: 90 operations.

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
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q5 = q[..., 4]
    s5 = np.sin(q5)
    c5 = np.cos(q5)

    # terms
    t1 = -0.425 * c2
    t2 = c2 * c3 - s2 * s3
    t3 = t1 - 0.3922 * t2
    t4 = c2 * s3 + c3 * s2
    t5 = c4 * t4 + t2 * s4
    t6 = t3 + 0.0997 * t5
    t7 = t2 * c4 - t4 * s4
    t8 = t6 - 0.0996 * (s5 * t7)
    t9 = t8 - t1
    t10 = t8 * t9
    t11 = -0.425 * s2
    t12 = t11 - 0.3922 * t4
    t13 = t12 - 0.0997 * t7
    t14 = t13 - 0.0996 * (t5 * s5)
    t15 = t8 * t8
    t16 = t14 - t11
    t17 = t8 - t3
    t18 = t8 * t17
    t19 = t14 - t12
    t20 = -0.1333 - 0.0996 * c5
    t21 = 0.1333 + t20
    t22 = t7 * t21
    t23 = t8 * (t5 * t21)
    t24 = t5 * (t14 - t13) + t7 * (t8 - t6)
    t25 = t8 * t24
    t26 = t9 * t24
    t27 = t17 * t24

    # results
    minors = np.empty((*_leading, 20), _real)
    minors[..., 0] = t10 * t14 - t15 * t16
    minors[..., 1] = t14 * t18 - t15 * t19
    minors[..., 2] = t15 * t22 + t14 * t23 - t20 * t25
    minors[..., 3] = 0.0
    minors[..., 4] = t16 * t18 - t10 * t19
    minors[..., 5] = t10 * t22 + t16 * t23 - t20 * t26
    minors[..., 6] = 0.0
    minors[..., 7] = t18 * t22 + t19 * t23 - t20 * t27
    minors[..., 8] = 0.0
    minors[..., 9] = 0.0
    minors[..., 10] = 0.0
    minors[..., 11] = t16 * t25 - t14 * t26
    minors[..., 12] = 0.0
    minors[..., 13] = t19 * t25 - t14 * t27
    minors[..., 14] = 0.0
    minors[..., 15] = 0.0
    minors[..., 16] = t19 * t26 - t16 * t27
    minors[..., 17] = 0.0
    minors[..., 18] = 0.0
    minors[..., 19] = 0.0
    return minors.reshape(_leading + (20,))


def null_projector_position(q):
    """projector I - J^+ J onto the null space of the position Jacobian: 541 operations.

    in   q[6]
    out  null_projector[6][6]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q5 = q[..., 4]
    c5 = np.cos(q5)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    s5 = np.sin(q5)

    # terms
    t1 = -0.1333 - 0.0996 * c5
    t2 = -0.425 * s2
    t3 = c2 * s3 + s2 * c3
    t4 = t2 - 0.3922 * t3
    t5 = c2 * c3 - s2 * s3
    t6 = c4 * t5 - t3 * s4
    t7 = t4 - 0.0997 * t6
    t8 = t3 * c4 + t5 * s4
    t9 = t7 - 0.0996 * (s5 * t8)
    t10 = t9 - t2
    t11 = t9 - t4
    t12 = t1 * t1 + t9 * t9 + t10 * t10 + t11 * t11
    t13 = 0.1333 + t1
    t14 = t6 * t13
    t15 = np.sqrt((t12 + t14 * t14))
    t16 = np.where(t15 != 0.0, t1 / t15, 0.0)
    t17 = np.where(t15 != 0.0, t9 / t15, 0.0)
    t18 = np.where(t15 != 0.0, t10 / t15, 0.0)
    t19 = np.where(t15 != 0.0, t11 / t15, 0.0)
    t20 = t16 * t16 + t17 * t17 + t18 * t18 + t19 * t19
    t21 = t14 / t15
    t22 = np.sqrt((t20 + np.where(t15 != 0.0, np.where(t15 != 0.0, t21 * t21, 0.0), 0.0)))
    t23 = t16 / t22
    t24 = -0.425 * c2
    t25 = t24 - 0.3922 * t5
    t26 = t25 + 0.0997 * t8
    t27 = t26 - 0.0996 * (t6 * s5)
    t28 = t21 / t22
    t29 = t8 * (t9 - t7) + t6 * (t27 - t26)
    t30 = np.where(t22 != 0.0, -(t23 * t27), 0.0) + np.where(t15 != 0.0, np.where(t22 != 0.0, -(t28 * t29), 0.0), 0.0)
    t31 = t27 - np.where(t22 != 0.0, -(t23 * t30), 0.0)
    t32 = t17 / t22
    t33 = np.where(t22 != 0.0, -(t30 * t32), 0.0)
    t34 = t18 / t22
    t35 = np.where(t22 != 0.0, -(t30 * t34), 0.0)
    t36 = t19 / t22
    t37 = np.where(t22 != 0.0, -(t30 * t36), 0.0)
    t38 = t31 * t31 + t33 * t33 + t35 * t35 + t37 * t37
    t39 = t29 + np.where(t15 != 0.0, np.where(t22 != 0.0, t28 * t30, 0.0), 0.0)
    t40 = np.sqrt((t38 + t39 * t39))
    t41 = t31 / t40
    t42 = t33 / t40
    t43 = t35 / t40
    t44 = t37 / t40
    t45 = t32 * t42 - t23 * t41 + t34 * t43 + t36 * t44
    t46 = t39 / t40
    t47 = np.where(t22 != 0.0, t45, 0.0) + np.where(t15 != 0.0, np.where(t22 != 0.0, -(t28 * t46), 0.0), 0.0)
    t48 = np.where(t40 != 0.0, t41, 0.0) - np.where(t22 != 0.0, np.where(t40 != 0.0, -(t23 * t47), 0.0), 0.0)
    t49 = np.where(t40 != 0.0, -t42, 0.0) - np.where(t22 != 0.0, np.where(t40 != 0.0, -(t32 * t47), 0.0), 0.0)
    t50 = np.where(t40 != 0.0, -t43, 0.0) - np.where(t22 != 0.0, np.where(t40 != 0.0, -(t34 * t47), 0.0), 0.0)
    t51 = np.where(t40 != 0.0, -t44, 0.0) - np.where(t22 != 0.0, np.where(t40 != 0.0, -(t36 * t47), 0.0), 0.0)
    t52 = t48 * t48 + t49 * t49 + t50 * t50 + t51 * t51
    t53 = np.where(t40 != 0.0, -t46, 0.0) - np.where(t15 != 0.0, np.where(t22 != 0.0, np.where(t40 != 0.0, t28 * t47, 0.0), 0.0), 0.0)
    t54 = np.sqrt((t52 + t53 * t53))
    t55 = t48 / t54
    t56 = 1 - np.where(t22 != 0.0, np.where(t22 != 0.0, t23 * t23, 0.0), 0.0) - np.where(t54 != 0.0, np.where(t54 != 0.0, t55 * t55, 0.0), 0.0)
    t57 = t27 - t24
    t58 = t27 - t25
    t59 = np.where(t22 != 0.0, -(t27 * t32 + t34 * t57 + t36 * t58), 0.0)
    t60 = t8 * t13
    t61 = t59 + np.where(t15 != 0.0, np.where(t22 != 0.0, t28 * t60, 0.0), 0.0)
    t62 = t23 * t61
    t63 = t27 - np.where(t22 != 0.0, -(t32 * t61), 0.0)
    t64 = t49 / t54
    t65 = t57 - np.where(t22 != 0.0, -(t34 * t61), 0.0)
    t66 = t50 / t54
    t67 = t63 * t64 - np.where(t22 != 0.0, -(t55 * t62), 0.0) + t65 * t66
    t68 = t58 - np.where(t22 != 0.0, -(t36 * t61), 0.0)
    t69 = t51 / t54
    t70 = t60 - np.where(t15 != 0.0, np.where(t22 != 0.0, t28 * t61, 0.0), 0.0)
    t71 = t53 / t54
    t72 = t67 + t68 * t69 + t70 * t71
    t73 = np.where(t22 != 0.0, -t62, 0.0) + np.where(t54 != 0.0, np.where(t54 != 0.0, t55 * t72, 0.0), 0.0)
    t74 = t63 - np.where(t54 != 0.0, np.where(t54 != 0.0, t64 * t72, 0.0), 0.0)
    t75 = t65 - np.where(t54 != 0.0, np.where(t54 != 0.0, t66 * t72, 0.0), 0.0)
    t76 = t68 - np.where(t54 != 0.0, np.where(t54 != 0.0, t69 * t72, 0.0), 0.0)
    t77 = t73 * t73 + t74 * t74 + t75 * t75 + t76 * t76
    t78 = t70 - np.where(t54 != 0.0, np.where(t54 != 0.0, t71 * t72, 0.0), 0.0)
    t79 = np.sqrt((t77 + t78 * t78))
    t80 = t73 / t79
    t81 = t74 / t79
    t82 = t75 / t79
    t83 = t76 / t79
    t84 = t23 * t80 - t32 * t81 - t34 * t82 - t36 * t83
    t85 = t78 / t79
    t86 = np.where(t22 != 0.0, t84, 0.0) + np.where(t15 != 0.0, np.where(t22 != 0.0, t28 * t85, 0.0), 0.0)
    t87 = np.where(t79 != 0.0, -t80, 0.0) - np.where(t22 != 0.0, np.where(t79 != 0.0, -(t23 * t86), 0.0), 0.0)
    t88 = np.where(t79 != 0.0, t81, 0.0) - np.where(t22 != 0.0, np.where(t79 != 0.0, -(t32 * t86), 0.0), 0.0)
    t89 = np.where(t79 != 0.0, t82, 0.0) - np.where(t22 != 0.0, np.where(t79 != 0.0, -(t34 * t86), 0.0), 0.0)
    t90 = np.where(t79 != 0.0, t83, 0.0) - np.where(t22 != 0.0, np.where(t79 != 0.0, -(t36 * t86), 0.0), 0.0)
    t91 = t55 * t87 + t64 * t88 + t66 * t89 + t69 * t90
    t92 = np.where(t79 != 0.0, t85, 0.0) - np.where(t15 != 0.0, np.where(t22 != 0.0, np.where(t79 != 0.0, t28 * t86, 0.0), 0.0), 0.0)
    t93 = t91 + t71 * t92
    t94 = t87 - np.where(t54 != 0.0, np.where(t54 != 0.0, t55 * t93, 0.0), 0.0)
    t95 = t88 - np.where(t54 != 0.0, np.where(t54 != 0.0, t64 * t93, 0.0), 0.0)
    t96 = t89 - np.where(t54 != 0.0, np.where(t54 != 0.0, t66 * t93, 0.0), 0.0)
    t97 = t90 - np.where(t54 != 0.0, np.where(t54 != 0.0, t69 * t93, 0.0), 0.0)
    t98 = t94 * t94 + t95 * t95 + t96 * t96 + t97 * t97
    t99 = t92 - np.where(t54 != 0.0, np.where(t54 != 0.0, t71 * t93, 0.0), 0.0)
    t100 = np.sqrt((t98 + t99 * t99))
    t101 = t94 / t100
    t102 = np.where(t22 != 0.0, np.where(t22 != 0.0, t23 * t32, 0.0), 0.0) + np.where(t54 != 0.0, np.where(t54 != 0.0, t55 * t64, 0.0), 0.0)
    t103 = t95 / t100
    t104 = -(t102 + np.where(t100 != 0.0, np.where(t100 != 0.0, t101 * t103, 0.0), 0.0))
    t105 = np.where(t22 != 0.0, np.where(t22 != 0.0, t23 * t34, 0.0), 0.0) + np.where(t54 != 0.0, np.where(t54 != 0.0, t55 * t66, 0.0), 0.0)
    t106 = t96 / t100
    t107 = -(t105 + np.where(t100 != 0.0, np.where(t100 != 0.0, t101 * t106, 0.0), 0.0))
    t108 = np.where(t22 != 0.0, np.where(t22 != 0.0, t23 * t36, 0.0), 0.0) + np.where(t54 != 0.0, np.where(t54 != 0.0, t55 * t69, 0.0), 0.0)
    t109 = t97 / t100
    t110 = -(t108 + np.where(t100 != 0.0, np.where(t100 != 0.0, t101 * t109, 0.0), 0.0))
    t111 = np.where(t15 != 0.0, np.where(t22 != 0.0, np.where(t22 != 0.0, -(t23 * t28), 0.0), 0.0), 0.0) + np.where(t54 != 0.0, np.where(t54 != 0.0, t55 * t71, 0.0), 0.0)
    t112 = t99 / t100
    t113 = -(t111 + np.where(t100 != 0.0, np.where(t100 != 0.0, t101 * t112, 0.0), 0.0))
    t114 = 1 - np.where(t22 != 0.0, np.where(t22 != 0.0, t32 * t32, 0.0), 0.0) - np.where(t54 != 0.0, np.where(t54 != 0.0, t64 * t64, 0.0), 0.0)
    t115 = np.where(t22 != 0.0, np.where(t22 != 0.0, t32 * t34, 0.0), 0.0) + np.where(t54 != 0.0, np.where(t54 != 0.0, t64 * t66, 0.0), 0.0)
    t116 = -(t115 + np.where(t100 != 0.0, np.where(t100 != 0.0, t103 * t106, 0.0), 0.0))
    t117 = np.where(t22 != 0.0, np.where(t22 != 0.0, t32 * t36, 0.0), 0.0) + np.where(t54 != 0.0, np.where(t54 != 0.0, t64 * t69, 0.0), 0.0)
    t118 = -(t117 + np.where(t100 != 0.0, np.where(t100 != 0.0, t103 * t109, 0.0), 0.0))
    t119 = np.where(t15 != 0.0, np.where(t22 != 0.0, np.where(t22 != 0.0, -(t28 * t32), 0.0), 0.0), 0.0) + np.where(t54 != 0.0, np.where(t54 != 0.0, t64 * t71, 0.0), 0.0)
    t120 = -(t119 + np.where(t100 != 0.0, np.where(t100 != 0.0, t103 * t112, 0.0), 0.0))
    t121 = 1 - np.where(t22 != 0.0, np.where(t22 != 0.0, t34 * t34, 0.0), 0.0) - np.where(t54 != 0.0, np.where(t54 != 0.0, t66 * t66, 0.0), 0.0)
    t122 = np.where(t22 != 0.0, np.where(t22 != 0.0, t34 * t36, 0.0), 0.0) + np.where(t54 != 0.0, np.where(t54 != 0.0, t66 * t69, 0.0), 0.0)
    t123 = -(t122 + np.where(t100 != 0.0, np.where(t100 != 0.0, t106 * t109, 0.0), 0.0))
    t124 = np.where(t15 != 0.0, np.where(t22 != 0.0, np.where(t22 != 0.0, -(t28 * t34), 0.0), 0.0), 0.0) + np.where(t54 != 0.0, np.where(t54 != 0.0, t66 * t71, 0.0), 0.0)
    t125 = -(t124 + np.where(t100 != 0.0, np.where(t100 != 0.0, t106 * t112, 0.0), 0.0))
    t126 = 1 - np.where(t22 != 0.0, np.where(t22 != 0.0, t36 * t36, 0.0), 0.0) - np.where(t54 != 0.0, np.where(t54 != 0.0, t69 * t69, 0.0), 0.0)
    t127 = np.where(t15 != 0.0, np.where(t22 != 0.0, np.where(t22 != 0.0, -(t28 * t36), 0.0), 0.0), 0.0) + np.where(t54 != 0.0, np.where(t54 != 0.0, t69 * t71, 0.0), 0.0)
    t128 = -(t127 + np.where(t100 != 0.0, np.where(t100 != 0.0, t109 * t112, 0.0), 0.0))
    t129 = 1 - np.where(t15 != 0.0, np.where(t22 != 0.0, np.where(t15 != 0.0, np.where(t22 != 0.0, t28 * t28, 0.0), 0.0), 0.0), 0.0) - np.where(t54 != 0.0, np.where(t54 != 0.0, t71 * t71, 0.0), 0.0)

    # results
    null_projector = np.empty((*_leading, 36), _real)
    null_projector[..., 0] = t56 - np.where(t100 != 0.0, np.where(t100 != 0.0, t101 * t101, 0.0), 0.0)
    null_projector[..., 1] = t104
    null_projector[..., 2] = t107
    null_projector[..., 3] = t110
    null_projector[..., 4] = t113
    null_projector[..., 5] = 0.0
    null_projector[..., 6] = t104
    null_projector[..., 7] = t114 - np.where(t100 != 0.0, np.where(t100 != 0.0, t103 * t103, 0.0), 0.0)
    null_projector[..., 8] = t116
    null_projector[..., 9] = t118
    null_projector[..., 10] = t120
    null_projector[..., 11] = 0.0
    null_projector[..., 12] = t107
    null_projector[..., 13] = t116
    null_projector[..., 14] = t121 - np.where(t100 != 0.0, np.where(t100 != 0.0, t106 * t106, 0.0), 0.0)
    null_projector[..., 15] = t123
    null_projector[..., 16] = t125
    null_projector[..., 17] = 0.0
    null_projector[..., 18] = t110
    null_projector[..., 19] = t118
    null_projector[..., 20] = t123
    null_projector[..., 21] = t126 - np.where(t100 != 0.0, np.where(t100 != 0.0, t109 * t109, 0.0), 0.0)
    null_projector[..., 22] = t128
    null_projector[..., 23] = 0.0
    null_projector[..., 24] = t113
    null_projector[..., 25] = t120
    null_projector[..., 26] = t125
    null_projector[..., 27] = t128
    null_projector[..., 28] = t129 - np.where(t100 != 0.0, np.where(t100 != 0.0, t112 * t112, 0.0), 0.0)
    null_projector[..., 29] = 0.0
    null_projector[..., 30] = 0.0
    null_projector[..., 31] = 0.0
    null_projector[..., 32] = 0.0
    null_projector[..., 33] = 0.0
    null_projector[..., 34] = 0.0
    null_projector[..., 35] = 1
    return null_projector.reshape(_leading + (6, 6))
