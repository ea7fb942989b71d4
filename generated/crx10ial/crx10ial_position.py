"""manipulability (position) of crx10ial, in NumPy.

Made from templates/kernel.py.j2; inputs 55b7d4c84e96f27e355e50e23bd9f9ce934c7a2e6ebc0ad64c63cdd103d17a6c.
984 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_position(q):
    """manipulability H = sqrt(det(J J^T)) of the position Jacobian: 136 operations.

    in   q[6]
    out  manipulability (one number)
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    q4 = q[..., 3]
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    c4 = np.cos(q4)

    # terms
    t1 = 0.71 * s2
    t2 = c2 * c3 + s2 * s3
    t3 = t1 + 0.54 * t2
    t4 = s2 * c3 - c2 * s3
    t5 = s4 * t4
    t6 = 0.16 * (t2 * c5 + s5 * (t4 * c4))
    t7 = t3 + 0.15 * t5 + t6
    t8 = t7 * t7
    t9 = 0.71 * c2
    t10 = t9 - 0.54 * t4
    t11 = t2 * s4
    t12 = t10 + 0.15 * t11
    t13 = t12 - 0.16 * (t4 * c5 - s5 * (t2 * c4))
    t14 = t13 - t9
    t15 = t7 - t1
    t16 = t7 * t15
    t17 = t8 * t14 - t13 * t16
    t18 = 0.16 * (s4 * s5)
    t19 = -0.15 * c4 + t18
    t20 = t4 * t19
    t21 = t2 * t19
    t22 = t7 * t21
    t23 = t4 * (t7 - t3) + t2 * (t13 - t10)
    t24 = t7 * t23
    t25 = t8 * t20 + t13 * t22 - t19 * t24
    t26 = t13 - t12
    t27 = t11 * t18 + c4 * t26
    t28 = c4 * t6 + t5 * t18
    t29 = t7 * t28
    t30 = t6 * t11 - t5 * t26
    t31 = t7 * t30
    t32 = t8 * t27 - t13 * t29 - t19 * t31
    t33 = t15 * t23
    t34 = t19 * t33 - (t16 * t20 + t14 * t22)
    t35 = t17 * t17 + t25 * t25 + t32 * t32 + t34 * t34
    t36 = t15 * t30
    t37 = t14 * t29 - t16 * t27 + t19 * t36
    t38 = t23 * t28 + t21 * t30
    t39 = t22 * t27 + t20 * t29 - t19 * t38
    t40 = t14 * t24 - t13 * t33
    t41 = t14 * t31 - t13 * t36
    t42 = t35 + t37 * t37 + t39 * t39 + t40 * t40 + t41 * t41
    t43 = t13 * t38 - t24 * t27 + t20 * t31
    t44 = t27 * t33 - t20 * t36 - t14 * t38

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.sqrt((t42 + t43 * t43 + t44 * t44))
    return manipulability.reshape(_leading)


def manipulability_gradient_position(q):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in lexicographic order: 423 operations.

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
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    q4 = q[..., 3]
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    c4 = np.cos(q4)

    # terms
    t1 = 0.71 * s2
    t2 = c2 * c3 + s2 * s3
    t3 = t1 + 0.54 * t2
    t4 = s2 * c3 - c2 * s3
    t5 = s4 * t4
    t6 = t4 * c4
    t7 = 0.16 * (t2 * c5 + s5 * t6)
    t8 = t3 + 0.15 * t5 + t7
    t9 = t8 * t8
    t10 = 0.71 * c2
    t11 = t10 - 0.54 * t4
    t12 = t2 * s4
    t13 = t11 + 0.15 * t12
    t14 = t2 * c4
    t15 = t13 - 0.16 * (t4 * c5 - s5 * t14)
    t16 = t15 - t10
    t17 = t8 - t1
    t18 = t8 * t17
    t19 = t9 * t16 - t15 * t18
    t20 = 0.16 * (s4 * s5)
    t21 = -0.15 * c4 + t20
    t22 = t4 * t21
    t23 = t2 * t21
    t24 = t8 * t23
    t25 = t8 - t3
    t26 = t15 - t11
    t27 = t4 * t25 + t2 * t26
    t28 = t8 * t27
    t29 = t9 * t22 + t15 * t24 - t21 * t28
    t30 = t15 - t13
    t31 = t12 * t20 + c4 * t30
    t32 = c4 * t7 + t5 * t20
    t33 = t8 * t32
    t34 = t7 * t12 - t5 * t30
    t35 = t8 * t34
    t36 = t9 * t31 - t15 * t33 - t21 * t35
    t37 = t17 * t27
    t38 = t21 * t37 - (t18 * t22 + t16 * t24)
    t39 = t19 * t19 + t29 * t29 + t36 * t36 + t38 * t38
    t40 = t17 * t34
    t41 = t16 * t33 - t18 * t31 + t21 * t40
    t42 = t27 * t32 + t23 * t34
    t43 = t24 * t31 + t22 * t33 - t21 * t42
    t44 = t16 * t28 - t15 * t37
    t45 = t16 * t35 - t15 * t40
    t46 = t39 + t41 * t41 + t43 * t43 + t44 * t44 + t45 * t45
    t47 = t15 * t42 - t28 * t31 + t22 * t35
    t48 = t31 * t37 - t22 * t40 - t16 * t42
    t49 = np.sqrt((t46 + t47 * t47 + t48 * t48))
    t50 = t47 / t49
    t51 = t45 / t49
    t52 = t44 / t49
    t53 = t36 / t49
    t54 = t42 * t50 - t40 * t51 - t37 * t52 - t33 * t53
    t55 = t48 / t49
    t56 = t43 / t49
    t57 = t41 / t49
    t58 = t37 * t55 - t28 * t50 + t24 * t56 - t18 * t57
    t59 = t58 + t9 * t53
    t60 = t15 * t50 - t16 * t55 - t21 * t56
    t61 = t21 * t57 - (t22 * t55 + t15 * t51)
    t62 = t22 * t50 + t16 * t51 - t21 * t53
    t63 = t23 * t60 + t17 * t61 + t8 * t62
    t64 = c4 * t59 - t5 * t63
    t65 = t38 / t49
    t66 = t31 * t55 - t15 * t52 + t21 * t65
    t67 = t29 / t49
    t68 = t16 * t52 - t31 * t50 - t21 * t67
    t69 = t32 * t60 + t17 * t66 + t8 * t68
    t70 = t2 * t69
    t71 = t19 / t49
    t72 = t35 * t51 - t42 * t55 + t28 * t52 + t33 * t57
    t73 = t72 - t24 * t65 + t9 * t71
    t74 = t54 + t64 + t70 + t24 * t67 - t18 * t71 + t73
    t75 = 0.16 * t74
    t76 = s5 * t75
    t77 = t74 - t64
    t78 = t7 * t63 + t20 * t59 + 0.15 * t77
    t79 = c4 * t76 + s4 * t78
    t80 = t35 * t50 - t40 * t55 + t33 * t56 - t18 * t65
    t81 = t80 + t9 * t67
    t82 = t77 - t70
    t83 = t25 * t69 + t21 * t81 - c5 * t75 - 0.54 * t82
    t84 = t22 * t56 + t16 * t57 - t15 * t53
    t85 = t27 * t60 + t8 * t84
    t86 = t4 * t69
    t87 = t31 * t56 - t16 * t65 + t15 * t67
    t88 = t34 * t62 + t32 * t84 + t27 * t68 + t86 + t23 * t87
    t89 = t31 * t57 + t22 * t65 + t15 * t71
    t90 = t34 * t61 + t27 * t66 - t8 * t89
    t91 = (t8 + t8) * (t31 * t53 + t22 * t67 + t16 * t71)
    t92 = t88 - t17 * t89 + t90 + t91
    t93 = 0.16 * (t12 * t63 + c4 * t85 + t92)
    t94 = s5 * t93
    t95 = t20 * t85 - t30 * t63 + 0.15 * t92
    t96 = t83 + c4 * t94 + s4 * t95
    t97 = t34 * t60 + t8 * t87
    t98 = t92 - t86
    t99 = t26 * t69 + t21 * t97 + c5 * t93 + 0.54 * t98
    t100 = s3 * t79 + c3 * t96 + s3 * t99 + 0.71 * (t98 - t90)
    t101 = c3 * t79 + 0.71 * (t82 - t73) - s3 * t96 + c3 * t99
    t102 = c2 * t100 - s2 * t101
    t103 = c3 * (s2 * t79 - c2 * t96 + s2 * t99) - s3 * (c2 * t79 + s2 * t96 + c2 * t99)
    t104 = t40 * t57 - t42 * t56 + t37 * t65 - t35 * t53
    t105 = t104 - t28 * t67 + t2 * t97 + t4 * t81
    t106 = 0.16 * (t5 * t85 + t12 * t59 + t105)
    t107 = t7 * t85 + t30 * t59 + -0.15 * t105 + t2 * t76
    t108 = c4 * (s5 * t106 + t2 * t78 + t4 * t95) - s4 * (t107 + t4 * t94)
    t109 = c5 * (s4 * t106 + t14 * t75 + t6 * t93) - s5 * (t2 * t93 - t4 * t75)
    t110 = 1 / t49
    t111 = t110 * t110
    t112 = -0.5 / t49 * np.sqrt(t110)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 6), _real)
    inverse_gradient = np.empty((*_leading, 6), _real)
    inverse_root_gradient = np.empty((*_leading, 6), _real)
    manipulability[..., 0] = t49
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t49 != 0.0, t102, 0.0)
    gradient[..., 2] = np.where(t49 != 0.0, t103, 0.0)
    gradient[..., 3] = np.where(t49 != 0.0, t108, 0.0)
    gradient[..., 4] = np.where(t49 != 0.0, t109, 0.0)
    gradient[..., 5] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t49 != 0.0, -(t102 * t111), 0.0)
    inverse_gradient[..., 2] = np.where(t49 != 0.0, -(t103 * t111), 0.0)
    inverse_gradient[..., 3] = np.where(t49 != 0.0, -(t108 * t111), 0.0)
    inverse_gradient[..., 4] = np.where(t49 != 0.0, -(t109 * t111), 0.0)
    inverse_gradient[..., 5] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t49 != 0.0, t102 * t112, 0.0)
    inverse_root_gradient[..., 2] = np.where(t49 != 0.0, t103 * t112, 0.0)
    inverse_root_gradient[..., 3] = np.where(t49 != 0.0, t108 * t112, 0.0)
    inverse_root_gradient[..., 4] = np.where(t49 != 0.0, t109 * t112, 0.0)
    inverse_root_gradient[..., 5] = 0.0
    return manipulability.reshape(_leading), gradient.reshape(_leading + (6,)), inverse_gradient.reshape(_leading + (6,)), inverse_root_gradient.reshape(_leading + (6,))


def minors_position(q):
    """maximal minors of the position Jacobian, columns in lexicographic order: 116 operations.

    in   q[6]
    out  minors[20]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    q4 = q[..., 3]
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    c4 = np.cos(q4)

    # terms
    t1 = 0.71 * s2
    t2 = c2 * c3 + s2 * s3
    t3 = t1 + 0.54 * t2
    t4 = s2 * c3 - c2 * s3
    t5 = s4 * t4
    t6 = 0.16 * (t2 * c5 + s5 * (t4 * c4))
    t7 = t3 + 0.15 * t5 + t6
    t8 = t7 * t7
    t9 = 0.71 * c2
    t10 = t9 - 0.54 * t4
    t11 = t2 * s4
    t12 = t10 + 0.15 * t11
    t13 = t12 - 0.16 * (t4 * c5 - s5 * (t2 * c4))
    t14 = t13 - t9
    t15 = t7 - t1
    t16 = t7 * t15
    t17 = 0.16 * (s4 * s5)
    t18 = -0.15 * c4 + t17
    t19 = t4 * t18
    t20 = t2 * t18
    t21 = t7 * t20
    t22 = t4 * (t7 - t3) + t2 * (t13 - t10)
    t23 = t7 * t22
    t24 = t13 - t12
    t25 = t11 * t17 + c4 * t24
    t26 = c4 * t6 + t5 * t17
    t27 = t7 * t26
    t28 = t6 * t11 - t5 * t24
    t29 = t7 * t28
    t30 = t15 * t22
    t31 = t15 * t28
    t32 = t22 * t26 + t20 * t28

    # results
    minors = np.empty((*_leading, 20), _real)
    minors[..., 0] = t8 * t14 - t13 * t16
    minors[..., 1] = t8 * t19 + t13 * t21 - t18 * t23
    minors[..., 2] = t8 * t25 - t13 * t27 - t18 * t29
    minors[..., 3] = 0.0
    minors[..., 4] = t18 * t30 - (t16 * t19 + t14 * t21)
    minors[..., 5] = t14 * t27 - t16 * t25 + t18 * t31
    minors[..., 6] = 0.0
    minors[..., 7] = t21 * t25 + t19 * t27 - t18 * t32
    minors[..., 8] = 0.0
    minors[..., 9] = 0.0
    minors[..., 10] = t14 * t23 - t13 * t30
    minors[..., 11] = t14 * t29 - t13 * t31
    minors[..., 12] = 0.0
    minors[..., 13] = t13 * t32 - t23 * t25 + t19 * t29
    minors[..., 14] = 0.0
    minors[..., 15] = 0.0
    minors[..., 16] = t25 * t30 - t19 * t31 - t14 * t32
    minors[..., 17] = 0.0
    minors[..., 18] = 0.0
    minors[..., 19] = 0.0
    return minors.reshape(_leading + (20,))


def null_projector_position(q):
    """projector I - J^+ J onto the null space of the position Jacobian: 309 operations.

    in   q[6]
    out  null_projector[6][6]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q5 = q[..., 4]
    s5 = np.sin(q5)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    c5 = np.cos(q5)

    # terms
    t1 = 0.16 * (s4 * s5)
    t2 = -0.15 * c4 + t1
    t3 = 0.71 * c2
    t4 = c3 * s2 - c2 * s3
    t5 = t3 - 0.54 * t4
    t6 = c2 * c3 + s2 * s3
    t7 = s4 * t6
    t8 = t5 + 0.15 * t7
    t9 = t8 - 0.16 * (t4 * c5 - s5 * (c4 * t6))
    t10 = t9 - t3
    t11 = t2 * t4
    t12 = t2 * t2 + t9 * t9 + t10 * t10 + t11 * t11
    t13 = t9 - t8
    t14 = t1 * t7 + c4 * t13
    t15 = np.sqrt((t12 + t14 * t14))
    t16 = np.where(t15 != 0.0, 1, 0.0)
    t17 = t16 / (t15 + (1 - t16))
    t18 = t2 * t17
    t19 = 0.71 * s2
    t20 = t19 + 0.54 * t6
    t21 = s4 * t4
    t22 = 0.16 * (t6 * c5 + s5 * (c4 * t4))
    t23 = t20 + 0.15 * t21 + t22
    t24 = t11 * t17
    t25 = t4 * (t23 - t20) + t6 * (t9 - t5)
    t26 = t14 * t17
    t27 = t7 * t22 - t13 * t21
    t28 = t18 * t23 + t24 * t25 + t26 * t27
    t29 = t23 - t18 * t28
    t30 = t9 * t17
    t31 = t28 * t30
    t32 = t10 * t17
    t33 = t28 * t32
    t34 = t25 - t24 * t28
    t35 = t30 * t31 - t18 * t29 + t32 * t33 - t24 * t34
    t36 = t27 - t26 * t28
    t37 = t35 - t26 * t36
    t38 = t29 + t18 * t37
    t39 = t31 - t30 * t37
    t40 = t32 * t37 - t33
    t41 = t34 + t24 * t37
    t42 = t38 * t38 + t39 * t39 + t40 * t40 + t41 * t41
    t43 = t36 + t26 * t37
    t44 = np.sqrt((t42 + t43 * t43))
    t45 = np.where(t44 != 0.0, 1, 0.0)
    t46 = t45 / (t44 + (1 - t45))
    t47 = t38 * t46
    t48 = t2 * t6
    t49 = t23 - t19
    t50 = c4 * t22 + t1 * t21
    t51 = t24 * t48 - t32 * t49 - t26 * t50 - t23 * t30
    t52 = t18 * t51
    t53 = t23 + t30 * t51
    t54 = t39 * t46
    t55 = t49 + t32 * t51
    t56 = t40 * t46
    t57 = t24 * t51 - t48
    t58 = t41 * t46
    t59 = t47 * t52 - t53 * t54 + t55 * t56 + t57 * t58
    t60 = t50 + t26 * t51
    t61 = t43 * t46
    t62 = t59 + t60 * t61
    t63 = t52 - t47 * t62
    t64 = t53 + t54 * t62
    t65 = t55 - t56 * t62
    t66 = t57 - t58 * t62
    t67 = t18 * t63 + t30 * t64 + t32 * t65 + t24 * t66
    t68 = t60 - t61 * t62
    t69 = t67 + t26 * t68
    t70 = t63 - t18 * t69
    t71 = t30 * t69 - t64
    t72 = t65 - t32 * t69
    t73 = t66 - t24 * t69
    t74 = t47 * t70 + t54 * t71 + t56 * t72 + t58 * t73
    t75 = t68 - t26 * t69
    t76 = t74 + t61 * t75
    t77 = t70 - t47 * t76
    t78 = t71 - t54 * t76
    t79 = t72 - t56 * t76
    t80 = t73 - t58 * t76
    t81 = t77 * t77 + t78 * t78 + t79 * t79 + t80 * t80
    t82 = t75 - t61 * t76
    t83 = np.sqrt((t81 + t82 * t82))
    t84 = np.where(t83 != 0.0, 1, 0.0)
    t85 = t84 / (t83 + (1 - t84))
    t86 = t77 * t85
    t87 = t78 * t85
    t88 = t18 * t30 - t47 * t54 - t86 * t87
    t89 = t79 * t85
    t90 = -(t18 * t32 + t47 * t56 + t86 * t89)
    t91 = t80 * t85
    t92 = -(t18 * t24 + t47 * t58 + t86 * t91)
    t93 = t82 * t85
    t94 = -(t18 * t26 + t47 * t61 + t86 * t93)
    t95 = t30 * t32 - t54 * t56 - t87 * t89
    t96 = t24 * t30 - t54 * t58 - t87 * t91
    t97 = t26 * t30 - t54 * t61 - t87 * t93
    t98 = -(t24 * t32 + t56 * t58 + t89 * t91)
    t99 = -(t26 * t32 + t56 * t61 + t89 * t93)
    t100 = -(t24 * t26 + t58 * t61 + t91 * t93)

    # results
    null_projector = np.empty((*_leading, 36), _real)
    null_projector[..., 0] = 1 - t18 * t18 - t47 * t47 - t86 * t86
    null_projector[..., 1] = t88
    null_projector[..., 2] = t90
    null_projector[..., 3] = t92
    null_projector[..., 4] = t94
    null_projector[..., 5] = 0.0
    null_projector[..., 6] = t88
    null_projector[..., 7] = 1 - t30 * t30 - t54 * t54 - t87 * t87
    null_projector[..., 8] = t95
    null_projector[..., 9] = t96
    null_projector[..., 10] = t97
    null_projector[..., 11] = 0.0
    null_projector[..., 12] = t90
    null_projector[..., 13] = t95
    null_projector[..., 14] = 1 - t32 * t32 - t56 * t56 - t89 * t89
    null_projector[..., 15] = t98
    null_projector[..., 16] = t99
    null_projector[..., 17] = 0.0
    null_projector[..., 18] = t92
    null_projector[..., 19] = t96
    null_projector[..., 20] = t98
    null_projector[..., 21] = 1 - t24 * t24 - t58 * t58 - t91 * t91
    null_projector[..., 22] = t100
    null_projector[..., 23] = 0.0
    null_projector[..., 24] = t94
    null_projector[..., 25] = t97
    null_projector[..., 26] = t99
    null_projector[..., 27] = t100
    null_projector[..., 28] = 1 - t26 * t26 - t61 * t61 - t93 * t93
    null_projector[..., 29] = 0.0
    null_projector[..., 30] = 0.0
    null_projector[..., 31] = 0.0
    null_projector[..., 32] = 0.0
    null_projector[..., 33] = 0.0
    null_projector[..., 34] = 0.0
    null_projector[..., 35] = 1
    return null_projector.reshape(_leading + (6, 6))
