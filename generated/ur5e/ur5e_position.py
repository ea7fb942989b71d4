"""manipulability (position) of ur5e, in NumPy.

Made from templates/kernel.py.j2; inputs aadd4c9853b241c514ca27ae82a3f2cb598febefd9711612d9090fdace4c3025.
836 operations. Do not edit: change the derivation and regenerate.

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
    """projector I - J^+ J onto the null space of the position Jacobian: 295 operations.

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
    t16 = np.where(t15 != 0.0, 1, 0.0)
    t17 = t16 / (t15 + (1 - t16))
    t18 = t1 * t17
    t19 = -0.425 * c2
    t20 = t19 - 0.3922 * t5
    t21 = t20 + 0.0997 * t8
    t22 = t21 - 0.0996 * (t6 * s5)
    t23 = t14 * t17
    t24 = t8 * (t9 - t7) + t6 * (t22 - t21)
    t25 = t18 * t22 + t23 * t24
    t26 = t22 - t18 * t25
    t27 = t9 * t17
    t28 = t25 * t27
    t29 = t10 * t17
    t30 = t25 * t29
    t31 = t11 * t17
    t32 = t25 * t31
    t33 = t27 * t28 - t18 * t26 + t29 * t30 + t31 * t32
    t34 = t23 * t25 - t24
    t35 = t33 + t23 * t34
    t36 = t26 + t18 * t35
    t37 = t27 * t35 - t28
    t38 = t29 * t35 - t30
    t39 = t31 * t35 - t32
    t40 = t36 * t36 + t37 * t37 + t38 * t38 + t39 * t39
    t41 = t34 - t23 * t35
    t42 = np.sqrt((t40 + t41 * t41))
    t43 = np.where(t42 != 0.0, 1, 0.0)
    t44 = t43 / (t42 + (1 - t43))
    t45 = t36 * t44
    t46 = t8 * t13
    t47 = t22 - t19
    t48 = t22 - t20
    t49 = t23 * t46 - (t22 * t27 + t29 * t47 + t31 * t48)
    t50 = t18 * t49
    t51 = t22 + t27 * t49
    t52 = t37 * t44
    t53 = t47 + t29 * t49
    t54 = t38 * t44
    t55 = t48 + t31 * t49
    t56 = t39 * t44
    t57 = t45 * t50 + t51 * t52 + t53 * t54 + t55 * t56
    t58 = t46 - t23 * t49
    t59 = t41 * t44
    t60 = t57 + t58 * t59
    t61 = t50 - t45 * t60
    t62 = t58 - t59 * t60
    t63 = t51 - t52 * t60
    t64 = t53 - t54 * t60
    t65 = t55 - t56 * t60
    t66 = t18 * t61 + t27 * t63 + t29 * t64 + t31 * t65
    t67 = t23 * t62 - t66
    t68 = t61 + t18 * t67
    t69 = t63 + t27 * t67
    t70 = t64 + t29 * t67
    t71 = t65 + t31 * t67
    t72 = t45 * t68 + t52 * t69 + t54 * t70 + t56 * t71
    t73 = t62 - t23 * t67
    t74 = t72 + t59 * t73
    t75 = t68 - t45 * t74
    t76 = t69 - t52 * t74
    t77 = t70 - t54 * t74
    t78 = t71 - t56 * t74
    t79 = t75 * t75 + t76 * t76 + t77 * t77 + t78 * t78
    t80 = t73 - t59 * t74
    t81 = np.sqrt((t79 + t80 * t80))
    t82 = np.where(t81 != 0.0, 1, 0.0)
    t83 = t82 / (t81 + (1 - t82))
    t84 = t75 * t83
    t85 = t76 * t83
    t86 = -(t18 * t27 + t45 * t52 + t84 * t85)
    t87 = t77 * t83
    t88 = -(t18 * t29 + t45 * t54 + t84 * t87)
    t89 = t78 * t83
    t90 = -(t18 * t31 + t45 * t56 + t84 * t89)
    t91 = t80 * t83
    t92 = t18 * t23 - t45 * t59 - t84 * t91
    t93 = -(t27 * t29 + t52 * t54 + t85 * t87)
    t94 = -(t27 * t31 + t52 * t56 + t85 * t89)
    t95 = t23 * t27 - t52 * t59 - t85 * t91
    t96 = -(t29 * t31 + t54 * t56 + t87 * t89)
    t97 = t23 * t29 - t54 * t59 - t87 * t91
    t98 = t23 * t31 - t56 * t59 - t89 * t91

    # results
    null_projector = np.empty((*_leading, 36), _real)
    null_projector[..., 0] = 1 - t18 * t18 - t45 * t45 - t84 * t84
    null_projector[..., 1] = t86
    null_projector[..., 2] = t88
    null_projector[..., 3] = t90
    null_projector[..., 4] = t92
    null_projector[..., 5] = 0.0
    null_projector[..., 6] = t86
    null_projector[..., 7] = 1 - t27 * t27 - t52 * t52 - t85 * t85
    null_projector[..., 8] = t93
    null_projector[..., 9] = t94
    null_projector[..., 10] = t95
    null_projector[..., 11] = 0.0
    null_projector[..., 12] = t88
    null_projector[..., 13] = t93
    null_projector[..., 14] = 1 - t29 * t29 - t54 * t54 - t87 * t87
    null_projector[..., 15] = t96
    null_projector[..., 16] = t97
    null_projector[..., 17] = 0.0
    null_projector[..., 18] = t90
    null_projector[..., 19] = t94
    null_projector[..., 20] = t96
    null_projector[..., 21] = 1 - t31 * t31 - t56 * t56 - t89 * t89
    null_projector[..., 22] = t98
    null_projector[..., 23] = 0.0
    null_projector[..., 24] = t92
    null_projector[..., 25] = t95
    null_projector[..., 26] = t97
    null_projector[..., 27] = t98
    null_projector[..., 28] = 1 - t23 * t23 - t59 * t59 - t91 * t91
    null_projector[..., 29] = 0.0
    null_projector[..., 30] = 0.0
    null_projector[..., 31] = 0.0
    null_projector[..., 32] = 0.0
    null_projector[..., 33] = 0.0
    null_projector[..., 34] = 0.0
    null_projector[..., 35] = 1
    return null_projector.reshape(_leading + (6, 6))
