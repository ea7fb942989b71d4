"""manipulability (pose) of panda, in NumPy.

Made from templates/kernel.py.j2; inputs c2772a1907e41fab35b97a73cff4ca9a37da49c766b9ce8c1d3508df9f38ba3b.
2020 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_pose(q):
    """manipulability H = sqrt(det(J J^T)) of the pose Jacobian: 175 operations.

    in   q[7]
    out  manipulability (one number)
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    q4 = q[..., 3]
    s4 = np.sin(q4)
    c4 = np.cos(q4)
    q5 = q[..., 4]
    s5 = np.sin(q5)
    c5 = np.cos(q5)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)

    # terms
    t1 = 0.0825 * s3
    t2 = s3 * s4
    t3 = s3 * c4
    t4 = t1 - 0.384 * t2 - 0.0825 * t3
    t5 = s4 * s5
    t6 = 0.0825 * s4 - 0.316 - 0.384 * c4
    t7 = c3 * c5 - t3 * s5
    t8 = t4 * t5 - t6 * t7
    t9 = c3 * s5 + t3 * c5
    t10 = t4 + 0.088 * (c6 * t9 - t2 * s6)
    t11 = c3 * s4
    t12 = c3 * c4
    t13 = c5 * t12 - s3 * s5
    t14 = c6 * t11 + s6 * t13
    t15 = 0.0825 * c3
    t16 = t15 - 0.384 * t11 - 0.0825 * t12
    t17 = t16 + 0.088 * (c6 * t13 - s6 * t11)
    t18 = t2 * c6 + t9 * s6
    t19 = t10 * t14 - t17 * t18
    t20 = s3 * c5 + s5 * t12
    t21 = t7 * t16 + t4 * t20
    t22 = s4 * c5
    t23 = s6 * t22 - c4 * c6
    t24 = t6 - 0.088 * (c6 * t22 + c4 * s6)
    t25 = t10 * t23 + t18 * t24
    t26 = t8 * t19 - t21 * t25
    t27 = t6 * t11 - c4 * t16
    t28 = c4 * t4 - t2 * t6
    t29 = t2 * t16 - t4 * t11
    t30 = t21 * t28 - t8 * t29
    t31 = t14 * t24 + t17 * t23
    t32 = t19 * t28 - t25 * t29
    t33 = t6 * t20 + t5 * t16
    t34 = t26 * t27 - t30 * t31 + t32 * t33
    t35 = t34 * s2
    t36 = 0.316 * s3
    t37 = 0.316 * c3
    t38 = c3 * t15 + s3 * t1
    t39 = t29 * t37 - t28 * t38
    t40 = t19 * t37 - t25 * t38
    t41 = t32 * t36 - t31 * t39 - t27 * t40
    t42 = s2 * t41
    t43 = t21 * t37 - t8 * t38
    t44 = t26 * t36 - t31 * t43 + t33 * t40
    t45 = s2 * t44
    t46 = t30 * t36 - t33 * t39 - t27 * t43
    t47 = s2 * t46
    t48 = c3 * t35 + t7 * t42 - t2 * t45 + t18 * t47
    t49 = t14 * t46 - (t20 * t41 + t11 * t44) - s3 * t34
    t50 = t5 * t42 - c2 * t49 - c4 * t45 - t23 * t47
    t51 = t48 * t48 + t47 * t47 + t50 * t50 + t42 * t42
    t52 = np.sqrt((t51 + t45 * t45 + t35 * t35 + t49 * t49))

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = t52
    return manipulability.reshape(_leading)


def manipulability_gradient_pose(q):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in lexicographic order: 551 operations.

    in   q[7]
    out  manipulability (one number)
    out  gradient[7]
    out  inverse_gradient[7]
    out  inverse_root_gradient[7]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    s4 = np.sin(q4)
    c3 = np.cos(q3)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    c2 = np.cos(q2)

    # terms
    t1 = 0.0825 * s3
    t2 = s3 * s4
    t3 = c4 * s3
    t4 = t1 - 0.384 * t2 - 0.0825 * t3
    t5 = 0.0825 * s4 - 0.316 - 0.384 * c4
    t6 = c4 * t4 - t2 * t5
    t7 = 0.0825 * c3
    t8 = s4 * c3
    t9 = c4 * c3
    t10 = t7 - 0.384 * t8 - 0.0825 * t9
    t11 = c3 * c5 - t3 * s5
    t12 = s3 * c5 + t9 * s5
    t13 = t10 * t11 + t4 * t12
    t14 = t2 * t10 - t4 * t8
    t15 = s4 * s5
    t16 = t4 * t15 - t5 * t11
    t17 = t6 * t13 - t14 * t16
    t18 = 0.316 * s3
    t19 = 0.316 * c3
    t20 = c3 * t7 + s3 * t1
    t21 = t14 * t19 - t6 * t20
    t22 = t5 * t12 + t10 * t15
    t23 = t13 * t19 - t16 * t20
    t24 = t5 * t8 - c4 * t10
    t25 = t17 * t18 - t21 * t22 - t23 * t24
    t26 = t25 * s2
    t27 = c3 * s5 + t3 * c5
    t28 = t4 + 0.088 * (c6 * t27 - t2 * s6)
    t29 = t9 * c5 - s3 * s5
    t30 = t8 * c6 + s6 * t29
    t31 = t10 + 0.088 * (c6 * t29 - t8 * s6)
    t32 = t2 * c6 + t27 * s6
    t33 = t28 * t30 - t31 * t32
    t34 = s4 * c5
    t35 = s6 * t34 - c4 * c6
    t36 = t5 - 0.088 * (c6 * t34 + c4 * s6)
    t37 = t28 * t35 + t32 * t36
    t38 = t6 * t33 - t14 * t37
    t39 = t30 * t36 + t31 * t35
    t40 = t19 * t33 - t20 * t37
    t41 = t18 * t38 - t21 * t39 - t24 * t40
    t42 = s2 * t41
    t43 = t16 * t33 - t13 * t37
    t44 = t18 * t43 - t23 * t39 + t22 * t40
    t45 = s2 * t44
    t46 = t24 * t43 - t17 * t39 + t22 * t38
    t47 = s2 * t46
    t48 = t26 * t26 + t42 * t42 + t45 * t45 + t47 * t47
    t49 = t25 * t30 - (t12 * t41 + t8 * t44) - s3 * t46
    t50 = t15 * t42 - c2 * t49 - c4 * t45 - t26 * t35
    t51 = c3 * t47 + t11 * t42 - t2 * t45 + t26 * t32
    t52 = np.sqrt((t48 + t50 * t50 + t51 * t51 + t49 * t49))
    t53 = t50 / t52
    t54 = t51 / t52
    t55 = c3 * t54 + t47 / t52
    t56 = t45 / t52 - (t2 * t54 + c4 * t53)
    t57 = t11 * t54 + t15 * t53 + t42 / t52
    t58 = t32 * t54 - t35 * t53 + t26 / t52
    t59 = t46 * t55 + t44 * t56 + t41 * t57 + t25 * t58
    t60 = s2 * (t49 * t53) + c2 * t59
    t61 = t49 / t52 - c2 * t53
    t62 = s2 * t56 - t8 * t61
    t63 = t30 * t61 + s2 * t58
    t64 = t39 * t62 + t24 * t63
    t65 = s2 * t57 - t12 * t61
    t66 = t22 * t62 - t24 * t65
    t67 = t39 * t65 + t22 * t63
    t68 = t16 * t64 - t37 * t66 + t6 * t67
    t69 = s2 * t55 - s3 * t61
    t70 = t17 * t69 + t23 * t62 + t21 * t65
    t71 = t24 * t69 + t18 * t62
    t72 = t22 * t69 + t18 * t65
    t73 = t16 * t71 + t19 * t66 + t6 * t72
    t74 = t25 * t61 - t36 * t70 + t28 * t73
    t75 = t35 * t70 + t32 * t73
    t76 = 0.088 * t75
    t77 = s6 * t74 - c6 * t76
    t78 = t1 * t68 - (t46 * t61 + s5 * t77) + 0.316 * (t43 * t62 + t38 * t65 + t17 * t63)
    t79 = t38 * t69 + t40 * t62 - t21 * t63
    t80 = t18 * t63 - t39 * t69
    t81 = t6 * t80 - (t37 * t71 + t19 * t64)
    t82 = t5 * t79 - t41 * t61 + t4 * t81
    t83 = t13 * t71 + t20 * t66 + t14 * t72
    t84 = t26 * t54 - t36 * t83 - t31 * t73
    t85 = t30 * t73 - t35 * t83
    t86 = 0.088 * t85
    t87 = s6 * t84 + c6 * t86
    t88 = t33 * t71 + t20 * t64 - t14 * t80
    t89 = t42 * t54 - t5 * t88 + t10 * t81
    t90 = t37 * t72 + t19 * t67 + t16 * t80
    t91 = t33 * t72 + t20 * t67 + t13 * t80
    t92 = t85 + t15 * t88 + t8 * t90 + t12 * t81 + c4 * t91
    t93 = c5 * t87 - s5 * t89 - 0.0825 * t92
    t94 = c6 * t84 - t45 * t54 - s6 * t86 - t10 * t90
    t95 = t94 - t5 * t91 - 0.384 * t92
    t96 = t78 + c5 * t82 + c4 * t93 + s4 * t95 + 0.0825 * (t92 + s3 * t68)
    t97 = t47 * t54 + s5 * t87 + t7 * t68 + 0.316 * (t33 * t66 - t13 * t64 - t14 * t67)
    t98 = t43 * t69 - t40 * t65 - t23 * t63
    t99 = t15 * t79 - (t75 + c4 * t98) - t2 * t90 + t11 * t81
    t100 = c5 * t77 + s5 * t82 - 0.0825 * t99
    t101 = s6 * t76 - t44 * t61 + c6 * t74 + t5 * t98
    t102 = t101 + t4 * t90 - 0.384 * t99
    t103 = t97 + c5 * t89 + c4 * t100 + s4 * t102 + 0.0825 * (t99 + c3 * t68)
    t104 = c3 * t96 - s3 * t103
    t105 = t30 * t70 + t32 * t83
    t106 = 0.088 * t105
    t107 = t26 * t53 + t31 * t70 + t28 * t83
    t108 = c6 * t106 - s6 * t107
    t109 = t42 * t53 + t10 * t79 + t4 * t88
    t110 = t8 * t98 - t105 + t12 * t79 - t11 * t88 - t2 * t91
    t111 = c5 * t108 + s5 * t109 + c3 * t102 + 0.0825 * t110
    t112 = s6 * t106 - t45 * t53 + c6 * t107 - t10 * t98
    t113 = t112 + c3 * t100 - 0.384 * t110 + t4 * t91 + s3 * t93
    t114 = c4 * (t111 + s3 * t95) - s4 * t113
    t115 = c3 * t87 - s3 * t77 + s4 * t109 + t9 * t82
    t116 = s4 * t108 + t9 * t77 + t3 * t87 + s3 * t82
    t117 = c5 * (t115 - t3 * t89) - s5 * (t116 + c3 * t89)
    t118 = c4 * t106 - t34 * t107 + t27 * t84 + t8 * t76
    t119 = t34 * t106 + c4 * t107 + t2 * t84 - t29 * t76
    t120 = c6 * (t118 + t29 * t74 - t2 * t86) - s6 * (t119 + t8 * t74 + t27 * t86)
    t121 = 1 / t52
    t122 = t121 * t121
    t123 = -0.5 / t52 * np.sqrt(t121)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 7), _real)
    inverse_gradient = np.empty((*_leading, 7), _real)
    inverse_root_gradient = np.empty((*_leading, 7), _real)
    manipulability[..., 0] = t52
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t52 != 0.0, t60, 0.0)
    gradient[..., 2] = np.where(t52 != 0.0, t104, 0.0)
    gradient[..., 3] = np.where(t52 != 0.0, t114, 0.0)
    gradient[..., 4] = np.where(t52 != 0.0, t117, 0.0)
    gradient[..., 5] = np.where(t52 != 0.0, t120, 0.0)
    gradient[..., 6] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t52 != 0.0, -(t60 * t122), 0.0)
    inverse_gradient[..., 2] = np.where(t52 != 0.0, -(t104 * t122), 0.0)
    inverse_gradient[..., 3] = np.where(t52 != 0.0, -(t114 * t122), 0.0)
    inverse_gradient[..., 4] = np.where(t52 != 0.0, -(t117 * t122), 0.0)
    inverse_gradient[..., 5] = np.where(t52 != 0.0, -(t120 * t122), 0.0)
    inverse_gradient[..., 6] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t52 != 0.0, t60 * t123, 0.0)
    inverse_root_gradient[..., 2] = np.where(t52 != 0.0, t104 * t123, 0.0)
    inverse_root_gradient[..., 3] = np.where(t52 != 0.0, t114 * t123, 0.0)
    inverse_root_gradient[..., 4] = np.where(t52 != 0.0, t117 * t123, 0.0)
    inverse_root_gradient[..., 5] = np.where(t52 != 0.0, t120 * t123, 0.0)
    inverse_root_gradient[..., 6] = 0.0
    return manipulability.reshape(_leading), gradient.reshape(_leading + (7,)), inverse_gradient.reshape(_leading + (7,)), inverse_root_gradient.reshape(_leading + (7,))


def minors_pose(q):
    """maximal minors of the pose Jacobian, columns in lexicographic order: 161 operations.

    in   q[7]
    out  minors[7]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    s4 = np.sin(q4)
    c3 = np.cos(q3)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    c2 = np.cos(q2)

    # terms
    t1 = 0.0825 * s3
    t2 = s3 * s4
    t3 = c4 * s3
    t4 = t1 - 0.384 * t2 - 0.0825 * t3
    t5 = 0.0825 * s4 - 0.316 - 0.384 * c4
    t6 = c4 * t4 - t2 * t5
    t7 = 0.0825 * c3
    t8 = s4 * c3
    t9 = c4 * c3
    t10 = t7 - 0.384 * t8 - 0.0825 * t9
    t11 = c3 * c5 - t3 * s5
    t12 = s3 * c5 + t9 * s5
    t13 = t10 * t11 + t4 * t12
    t14 = t2 * t10 - t4 * t8
    t15 = s4 * s5
    t16 = t4 * t15 - t5 * t11
    t17 = t6 * t13 - t14 * t16
    t18 = 0.316 * s3
    t19 = 0.316 * c3
    t20 = c3 * t7 + s3 * t1
    t21 = t14 * t19 - t6 * t20
    t22 = t5 * t12 + t10 * t15
    t23 = t13 * t19 - t16 * t20
    t24 = t5 * t8 - c4 * t10
    t25 = t17 * t18 - t21 * t22 - t23 * t24
    t26 = t25 * s2
    t27 = c3 * s5 + t3 * c5
    t28 = t4 + 0.088 * (c6 * t27 - t2 * s6)
    t29 = t9 * c5 - s3 * s5
    t30 = t8 * c6 + s6 * t29
    t31 = t10 + 0.088 * (c6 * t29 - t8 * s6)
    t32 = t2 * c6 + t27 * s6
    t33 = t28 * t30 - t31 * t32
    t34 = s4 * c5
    t35 = s6 * t34 - c4 * c6
    t36 = t5 - 0.088 * (c6 * t34 + c4 * s6)
    t37 = t28 * t35 + t32 * t36
    t38 = t6 * t33 - t14 * t37
    t39 = t30 * t36 + t31 * t35
    t40 = t19 * t33 - t20 * t37
    t41 = t18 * t38 - t21 * t39 - t24 * t40
    t42 = s2 * t41
    t43 = t16 * t33 - t13 * t37
    t44 = t18 * t43 - t23 * t39 + t22 * t40
    t45 = s2 * t44
    t46 = t24 * t43 - t17 * t39 + t22 * t38
    t47 = s2 * t46
    t48 = t25 * t30 - (t12 * t41 + t8 * t44) - s3 * t46
    t49 = t15 * t42 - c2 * t48 - c4 * t45 - t26 * t35
    t50 = c3 * t47 + t11 * t42 - t2 * t45 + t26 * t32

    # results
    minors = np.empty((*_leading, 7), _real)
    minors[..., 0] = t26
    minors[..., 1] = t42
    minors[..., 2] = t45
    minors[..., 3] = t47
    minors[..., 4] = t49
    minors[..., 5] = t50
    minors[..., 6] = t48
    return minors.reshape(_leading + (7,))


def null_vector_pose(q):
    """null vector of the pose Jacobian from its signed minors, |N| = H: 164 operations.

    in   q[7]
    out  null_vector[7]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    s4 = np.sin(q4)
    c3 = np.cos(q3)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)

    # terms
    t1 = 0.0825 * s3
    t2 = s3 * s4
    t3 = c4 * s3
    t4 = t1 - 0.384 * t2 - 0.0825 * t3
    t5 = 0.0825 * s4 - 0.316 - 0.384 * c4
    t6 = c4 * t4 - t2 * t5
    t7 = 0.0825 * c3
    t8 = s4 * c3
    t9 = c4 * c3
    t10 = t7 - 0.384 * t8 - 0.0825 * t9
    t11 = c3 * c5 - t3 * s5
    t12 = s3 * c5 + t9 * s5
    t13 = t10 * t11 + t4 * t12
    t14 = t2 * t10 - t4 * t8
    t15 = s4 * s5
    t16 = t4 * t15 - t5 * t11
    t17 = t6 * t13 - t14 * t16
    t18 = 0.316 * s3
    t19 = 0.316 * c3
    t20 = c3 * t7 + s3 * t1
    t21 = t14 * t19 - t6 * t20
    t22 = t5 * t12 + t10 * t15
    t23 = t13 * t19 - t16 * t20
    t24 = t5 * t8 - c4 * t10
    t25 = t17 * t18 - t21 * t22 - t23 * t24
    t26 = t9 * c5 - s3 * s5
    t27 = t8 * c6 + s6 * t26
    t28 = c3 * s5 + t3 * c5
    t29 = t4 + 0.088 * (c6 * t28 - t2 * s6)
    t30 = t10 + 0.088 * (c6 * t26 - t8 * s6)
    t31 = t2 * c6 + s6 * t28
    t32 = t27 * t29 - t30 * t31
    t33 = s4 * c5
    t34 = s6 * t33 - c4 * c6
    t35 = t5 - 0.088 * (c6 * t33 + c4 * s6)
    t36 = t29 * t34 + t31 * t35
    t37 = t6 * t32 - t14 * t36
    t38 = t27 * t35 + t30 * t34
    t39 = t19 * t32 - t20 * t36
    t40 = t18 * t37 - t21 * t38 - t24 * t39
    t41 = t16 * t32 - t13 * t36
    t42 = t18 * t41 - t23 * t38 + t22 * t39
    t43 = t24 * t41 - t17 * t38 + t22 * t37
    t44 = t25 * t27 - (t12 * t40 + t8 * t42) - s3 * t43
    t45 = t43 * s2
    t46 = t40 * s2
    t47 = t42 * s2
    t48 = t25 * s2
    t49 = c3 * t45 + t11 * t46 - t2 * t47 + t31 * t48
    t50 = t15 * t46 - t44 * c2 - c4 * t47 - t34 * t48

    # results
    null_vector = np.empty((*_leading, 7), _real)
    null_vector[..., 0] = t44
    null_vector[..., 1] = -t49
    null_vector[..., 2] = t50
    null_vector[..., 3] = -t45
    null_vector[..., 4] = t47
    null_vector[..., 5] = -t46
    null_vector[..., 6] = t48
    return null_vector.reshape(_leading + (7,))


def null_projector_pose(q):
    """projector I - J^+ J onto the null space of the pose Jacobian: 969 operations.

    in   q[7]
    out  null_projector[7][7]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q5 = q[..., 4]
    c5 = np.cos(q5)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    s5 = np.sin(q5)
    c3 = np.cos(q3)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)

    # terms
    t1 = c3 * c4
    t2 = c5 * s3 + s5 * t1
    t3 = 0.316 * c3
    t4 = 0.0825 * s3
    t5 = s3 * s4
    t6 = s3 * c4
    t7 = t4 - 0.384 * t5 - 0.0825 * t6
    t8 = 0.0825 * s4 - 0.316 - 0.384 * c4
    t9 = c4 * t7 - t5 * t8
    t10 = s5 * s4
    t11 = c5 * c3 - s5 * t6
    t12 = t7 * t10 - t8 * t11
    t13 = s5 * c3 + c5 * t6
    t14 = t7 + 0.088 * (c6 * t13 - t5 * s6)
    t15 = c5 * s4
    t16 = s6 * t15 - c4 * c6
    t17 = t8 - 0.088 * (c6 * t15 + c4 * s6)
    t18 = t5 * c6 + t13 * s6
    t19 = t14 * t16 + t17 * t18
    t20 = t3 * t3 + t9 * t9 + t12 * t12 + t19 * t19
    t21 = np.sqrt(t20)
    t22 = np.where(t21 != 0.0, 1, 0.0)
    t23 = t22 / (t21 + (1 - t22))
    t24 = t3 * t23
    t25 = t9 * t23
    t26 = t12 * t23
    t27 = t19 * t23
    t28 = t24 * t24 + t25 * t25 + t26 * t26 + t27 * t27
    t29 = np.sqrt(t28)
    t30 = np.where(t29 != 0.0, 1, 0.0)
    t31 = t30 / (t29 + (1 - t30))
    t32 = t24 * t31
    t33 = t25 * t31
    t34 = c3 * s4
    t35 = t26 * t31
    t36 = t27 * t31
    t37 = c5 * t1 - s3 * s5
    t38 = c6 * t34 + s6 * t37
    t39 = s3 * t32 - t33 * t34 + t2 * t35 + t36 * t38
    t40 = t2 - t35 * t39
    t41 = s3 - t32 * t39
    t42 = 0.0825 * c3
    t43 = c3 * t42 + s3 * t4
    t44 = t42 - 0.384 * t34 - 0.0825 * t1
    t45 = t5 * t44 - t7 * t34
    t46 = t11 * t44 + t2 * t7
    t47 = t44 + 0.088 * (c6 * t37 - s6 * t34)
    t48 = t14 * t38 - t18 * t47
    t49 = t32 * t43 + t33 * t45 + t35 * t46 + t36 * t48
    t50 = t43 - t32 * t49
    t51 = t45 - t33 * t49
    t52 = t46 - t35 * t49
    t53 = t48 - t36 * t49
    t54 = t50 * t50 + t51 * t51 + t52 * t52 + t53 * t53
    t55 = np.sqrt(t54)
    t56 = np.where(t55 != 0.0, 1, 0.0)
    t57 = t56 / (t55 + (1 - t56))
    t58 = t50 * t57
    t59 = t51 * t57
    t60 = t52 * t57
    t61 = t53 * t57
    t62 = t32 * t58 + t33 * t59 + t35 * t60 + t36 * t61
    t63 = t58 - t32 * t62
    t64 = t59 - t33 * t62
    t65 = t60 - t35 * t62
    t66 = t61 - t36 * t62
    t67 = t63 * t63 + t64 * t64 + t65 * t65 + t66 * t66
    t68 = np.sqrt(t67)
    t69 = np.where(t68 != 0.0, 1, 0.0)
    t70 = t69 / (t68 + (1 - t69))
    t71 = t63 * t70
    t72 = t34 + t33 * t39
    t73 = t64 * t70
    t74 = t65 * t70
    t75 = t38 - t36 * t39
    t76 = t66 * t70
    t77 = t41 * t71 - t72 * t73 + t40 * t74 + t75 * t76
    t78 = t40 - t74 * t77
    t79 = t41 - t71 * t77
    t80 = 0.316 * s3
    t81 = t8 * t34 - c4 * t44
    t82 = t2 * t8 + t10 * t44
    t83 = t17 * t38 + t16 * t47
    t84 = t32 * t80 + t33 * t81 - t35 * t82 - t36 * t83
    t85 = t80 - t32 * t84
    t86 = t81 - t33 * t84
    t87 = t82 + t35 * t84
    t88 = t83 + t36 * t84
    t89 = t71 * t85 + t73 * t86 - t74 * t87 - t76 * t88
    t90 = t85 - t71 * t89
    t91 = t86 - t73 * t89
    t92 = t87 + t74 * t89
    t93 = t88 + t76 * t89
    t94 = t90 * t90 + t91 * t91 + t92 * t92 + t93 * t93
    t95 = np.sqrt(t94)
    t96 = np.where(t95 != 0.0, 1, 0.0)
    t97 = t96 / (t95 + (1 - t96))
    t98 = t90 * t97
    t99 = t91 * t97
    t100 = t92 * t97
    t101 = t93 * t97
    t102 = t32 * t98 + t33 * t99 - t35 * t100 - t36 * t101
    t103 = t98 - t32 * t102
    t104 = t99 - t33 * t102
    t105 = t100 + t35 * t102
    t106 = t101 + t36 * t102
    t107 = t71 * t103 + t73 * t104 - t74 * t105 - t76 * t106
    t108 = t103 - t71 * t107
    t109 = t104 - t73 * t107
    t110 = t105 + t74 * t107
    t111 = t106 + t76 * t107
    t112 = t108 * t108 + t109 * t109 + t110 * t110 + t111 * t111
    t113 = np.sqrt(t112)
    t114 = np.where(t113 != 0.0, 1, 0.0)
    t115 = t114 / (t113 + (1 - t114))
    t116 = t108 * t115
    t117 = t72 + t73 * t77
    t118 = t109 * t115
    t119 = t110 * t115
    t120 = t75 - t76 * t77
    t121 = t111 * t115
    t122 = t79 * t116 - t117 * t118 - t78 * t119 - t120 * t121
    t123 = t78 + t119 * t122
    t124 = t120 + t121 * t122
    t125 = t79 - t116 * t122
    t126 = t117 + t118 * t122
    t127 = t123 * t123 + t124 * t124 + t125 * t125 + t126 * t126
    t128 = np.sqrt((t127 + s2 * s2))
    t129 = np.where(t128 != 0.0, 1, 0.0)
    t130 = t129 / (t128 + (1 - t129))
    t131 = t123 * t130
    t132 = t125 * t130
    t133 = t126 * t130
    t134 = t124 * t130
    t135 = t32 * t132 - t33 * t133 + t35 * t131 + t36 * t134
    t136 = t131 - t35 * t135
    t137 = t132 - t32 * t135
    t138 = t133 + t33 * t135
    t139 = t134 - t36 * t135
    t140 = t71 * t137 - t73 * t138 + t74 * t136 + t76 * t139
    t141 = t136 - t74 * t140
    t142 = t137 - t71 * t140
    t143 = t138 + t73 * t140
    t144 = t139 - t76 * t140
    t145 = t116 * t142 - t118 * t143 - t119 * t141 - t121 * t144
    t146 = t141 + t119 * t145
    t147 = t144 + t121 * t145
    t148 = t142 - t116 * t145
    t149 = t143 + t118 * t145
    t150 = t146 * t146 + t147 * t147 + t148 * t148 + t149 * t149
    t151 = s2 * t130
    t152 = np.sqrt((t150 + t151 * t151))
    t153 = np.where(t152 != 0.0, 1, 0.0)
    t154 = t153 / (t152 + (1 - t153))
    t155 = t151 * t154
    t156 = c4 * t33 + t10 * t35 + t16 * t36
    t157 = t35 * t156 - t10
    t158 = t32 * t156
    t159 = t33 * t156 - c4
    t160 = t36 * t156 - t16
    t161 = t71 * t158 + t73 * t159 + t74 * t157 + t76 * t160
    t162 = t157 - t74 * t161
    t163 = t158 - t71 * t161
    t164 = t159 - t73 * t161
    t165 = t160 - t76 * t161
    t166 = t116 * t163 + t118 * t164 - t119 * t162 - t121 * t165
    t167 = t162 + t119 * t166
    t168 = t146 * t154
    t169 = t165 + t121 * t166
    t170 = t147 * t154
    t171 = t163 - t116 * t166
    t172 = t148 * t154
    t173 = t164 - t118 * t166
    t174 = t149 * t154
    t175 = t167 * t168 + t169 * t170 + t171 * t172 - t173 * t174
    t176 = t175 + t155 * c2
    t177 = t155 * t176 - c2
    t178 = t171 - t172 * t176
    t179 = t173 + t174 * t176
    t180 = t167 - t168 * t176
    t181 = 1 + t177 * t177 + t178 * t178 + t179 * t179 + t180 * t180
    t182 = t169 - t170 * t176
    t183 = np.sqrt((t181 + t182 * t182))
    t184 = np.where(t183 != 0.0, 1, 0.0)
    t185 = t184 / (t183 + (1 - t184))
    t186 = t177 * t185
    t187 = t180 * t185
    t188 = t178 * t185
    t189 = t179 * t185
    t190 = t182 * t185
    t191 = t32 * t188 + t33 * t189 + t35 * t187 + t36 * t190
    t192 = t187 - t35 * t191
    t193 = t188 - t32 * t191
    t194 = t189 - t33 * t191
    t195 = t190 - t36 * t191
    t196 = t71 * t193 + t73 * t194 + t74 * t192 + t76 * t195
    t197 = t192 - t74 * t196
    t198 = t193 - t71 * t196
    t199 = t194 - t73 * t196
    t200 = t195 - t76 * t196
    t201 = t116 * t198 + t118 * t199 - t119 * t197 - t121 * t200
    t202 = t197 + t119 * t201
    t203 = t200 + t121 * t201
    t204 = t198 - t116 * t201
    t205 = t199 - t118 * t201
    t206 = t168 * t202 + t170 * t203 + t172 * t204 - t174 * t205
    t207 = t206 - t155 * t186
    t208 = t186 + t155 * t207
    t209 = t204 - t172 * t207
    t210 = t205 + t174 * t207
    t211 = t185 * t185 + t208 * t208 + t209 * t209 + t210 * t210
    t212 = t202 - t168 * t207
    t213 = t203 - t170 * t207
    t214 = np.sqrt((t211 + t212 * t212 + t213 * t213))
    t215 = np.where(t214 != 0.0, 1, 0.0)
    t216 = t215 / (t214 + (1 - t215))
    t217 = t208 * t216
    t218 = t18 * t36 - (t5 * t33 + c3 * t32 + t11 * t35)
    t219 = t11 + t35 * t218
    t220 = t18 - t36 * t218
    t221 = c3 + t32 * t218
    t222 = t5 + t33 * t218
    t223 = t76 * t220 - (t71 * t221 + t73 * t222 + t74 * t219)
    t224 = t219 + t74 * t223
    t225 = t221 + t71 * t223
    t226 = t222 + t73 * t223
    t227 = t220 - t76 * t223
    t228 = t119 * t224 - (t116 * t225 + t118 * t226) - t121 * t227
    t229 = t119 * t228 - t224
    t230 = t227 + t121 * t228
    t231 = t225 + t116 * t228
    t232 = t226 + t118 * t228
    t233 = t168 * t229 + t170 * t230 - t172 * t231 + t174 * t232
    t234 = t155 * t233
    t235 = t231 + t172 * t233
    t236 = t209 * t216
    t237 = t174 * t233 - t232
    t238 = t210 * t216
    t239 = t229 - t168 * t233
    t240 = t212 * t216
    t241 = t217 * t234 - t235 * t236 + t237 * t238 + t239 * t240
    t242 = t230 - t170 * t233
    t243 = t213 * t216
    t244 = t241 + t242 * t243
    t245 = t234 - t217 * t244
    t246 = t185 * t216
    t247 = t244 * t246
    t248 = t235 + t236 * t244
    t249 = t237 - t238 * t244
    t250 = 1 + t245 * t245 + t247 * t247 + t248 * t248 + t249 * t249
    t251 = t239 - t240 * t244
    t252 = t242 - t243 * t244
    t253 = np.sqrt((t250 + t251 * t251 + t252 * t252))
    t254 = np.where(t253 != 0.0, 1, 0.0)
    t255 = t254 / (t253 + (1 - t254))
    t256 = t245 * t255
    t257 = t251 * t255
    t258 = t249 * t255
    t259 = t248 * t255
    t260 = t252 * t255
    t261 = t33 * t258 - t32 * t259 + t35 * t257 + t36 * t260
    t262 = t257 - t35 * t261
    t263 = t258 - t33 * t261
    t264 = t259 + t32 * t261
    t265 = t260 - t36 * t261
    t266 = t73 * t263 - t71 * t264 + t74 * t262 + t76 * t265
    t267 = t262 - t74 * t266
    t268 = t263 - t73 * t266
    t269 = t264 + t71 * t266
    t270 = t265 - t76 * t266
    t271 = t118 * t268 - t116 * t269 - t119 * t267 - t121 * t270
    t272 = t267 + t119 * t271
    t273 = t270 + t121 * t271
    t274 = t269 + t116 * t271
    t275 = t268 - t118 * t271
    t276 = t168 * t272 + t170 * t273 - t172 * t274 - t174 * t275
    t277 = t276 - t155 * t256
    t278 = t256 + t155 * t277
    t279 = t274 + t172 * t277
    t280 = t275 + t174 * t277
    t281 = t272 - t168 * t277
    t282 = t217 * t278 - t236 * t279 + t238 * t280 + t240 * t281
    t283 = t273 - t170 * t277
    t284 = t247 * t255
    t285 = t282 + t243 * t283 - t246 * t284
    t286 = t278 - t217 * t285
    t287 = t284 + t246 * t285
    t288 = t279 + t236 * t285
    t289 = t255 * t255 + t286 * t286 + t287 * t287 + t288 * t288
    t290 = t280 - t238 * t285
    t291 = t281 - t240 * t285
    t292 = t283 - t243 * t285
    t293 = np.sqrt((t289 + t290 * t290 + t291 * t291 + t292 * t292))
    t294 = np.where(t293 != 0.0, 1, 0.0)
    t295 = t294 / (t293 + (1 - t294))
    t296 = t286 * t295
    t297 = t255 * t295
    t298 = -(t296 * t297)
    t299 = t287 * t295
    t300 = t217 * t246 - t296 * t299
    t301 = t288 * t295
    t302 = t155 * t172 - t217 * t236 + t296 * t301
    t303 = t290 * t295
    t304 = -(t155 * t174 + t217 * t238 + t296 * t303)
    t305 = t291 * t295
    t306 = t155 * t168 - t217 * t240 - t296 * t305
    t307 = t292 * t295
    t308 = t155 * t170 - t217 * t243 - t296 * t307
    t309 = -(t297 * t299)
    t310 = t297 * t301
    t311 = -(t297 * t303)
    t312 = -(t297 * t305)
    t313 = -(t297 * t307)
    t314 = t236 * t246 + t299 * t301
    t315 = t238 * t246 - t299 * t303
    t316 = t240 * t246 - t299 * t305
    t317 = t243 * t246 - t299 * t307
    t318 = 1 - t32 * t32 - t71 * t71 - t116 * t116 - t172 * t172
    t319 = t172 * t174 - (t32 * t33 + t71 * t73 + t116 * t118)
    t320 = t319 - t236 * t238 + t301 * t303
    t321 = t116 * t119 - (t32 * t35 + t71 * t74) - t168 * t172
    t322 = t321 - t236 * t240 + t301 * t305
    t323 = t116 * t121 - (t32 * t36 + t71 * t76) - t170 * t172
    t324 = t323 - t236 * t243 + t301 * t307
    t325 = 1 - t33 * t33 - t73 * t73 - t118 * t118 - t174 * t174
    t326 = t118 * t119 - (t33 * t35 + t73 * t74) + t168 * t174
    t327 = t326 - t238 * t240 - t303 * t305
    t328 = t118 * t121 - (t33 * t36 + t73 * t76) + t170 * t174
    t329 = t328 - t238 * t243 - t303 * t307
    t330 = 1 - t35 * t35 - t74 * t74 - t119 * t119 - t168 * t168
    t331 = t35 * t36 + t74 * t76 + t119 * t121 + t168 * t170
    t332 = -(t331 + t240 * t243 + t305 * t307)
    t333 = 1 - t36 * t36 - t76 * t76 - t121 * t121 - t170 * t170

    # results
    null_projector = np.empty((*_leading, 49), _real)
    null_projector[..., 0] = 1 - t155 * t155 - t217 * t217 - t296 * t296
    null_projector[..., 1] = t298
    null_projector[..., 2] = t300
    null_projector[..., 3] = t302
    null_projector[..., 4] = t304
    null_projector[..., 5] = t306
    null_projector[..., 6] = t308
    null_projector[..., 7] = t298
    null_projector[..., 8] = 1 - t297 * t297
    null_projector[..., 9] = t309
    null_projector[..., 10] = t310
    null_projector[..., 11] = t311
    null_projector[..., 12] = t312
    null_projector[..., 13] = t313
    null_projector[..., 14] = t300
    null_projector[..., 15] = t309
    null_projector[..., 16] = 1 - t246 * t246 - t299 * t299
    null_projector[..., 17] = t314
    null_projector[..., 18] = t315
    null_projector[..., 19] = t316
    null_projector[..., 20] = t317
    null_projector[..., 21] = t302
    null_projector[..., 22] = t310
    null_projector[..., 23] = t314
    null_projector[..., 24] = t318 - t236 * t236 - t301 * t301
    null_projector[..., 25] = t320
    null_projector[..., 26] = t322
    null_projector[..., 27] = t324
    null_projector[..., 28] = t304
    null_projector[..., 29] = t311
    null_projector[..., 30] = t315
    null_projector[..., 31] = t320
    null_projector[..., 32] = t325 - t238 * t238 - t303 * t303
    null_projector[..., 33] = t327
    null_projector[..., 34] = t329
    null_projector[..., 35] = t306
    null_projector[..., 36] = t312
    null_projector[..., 37] = t316
    null_projector[..., 38] = t322
    null_projector[..., 39] = t327
    null_projector[..., 40] = t330 - t240 * t240 - t305 * t305
    null_projector[..., 41] = t332
    null_projector[..., 42] = t308
    null_projector[..., 43] = t313
    null_projector[..., 44] = t317
    null_projector[..., 45] = t324
    null_projector[..., 46] = t329
    null_projector[..., 47] = t332
    null_projector[..., 48] = t333 - t243 * t243 - t307 * t307
    return null_projector.reshape(_leading + (7, 7))
