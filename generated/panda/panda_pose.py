"""manipulability (pose) of panda, in NumPy.

Made from templates/kernel.py.j2; inputs e6c4c77e8f404cf284ca42a0ff2b6a23389b6d8d94d0eb61c7056142a3802c50.
1906 operations. Do not edit: change the derivation and regenerate.

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
    """projector I - J^+ J onto the null space of the pose Jacobian: 855 operations.

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
    t26 = c3 * s4
    t27 = t12 * t23
    t28 = t19 * t23
    t29 = c5 * t1 - s3 * s5
    t30 = c6 * t26 + s6 * t29
    t31 = s3 * t24 - t25 * t26 + t2 * t27 + t28 * t30
    t32 = t2 - t27 * t31
    t33 = s3 - t24 * t31
    t34 = 0.0825 * c3
    t35 = c3 * t34 + s3 * t4
    t36 = t34 - 0.384 * t26 - 0.0825 * t1
    t37 = t5 * t36 - t7 * t26
    t38 = t11 * t36 + t2 * t7
    t39 = t36 + 0.088 * (c6 * t29 - s6 * t26)
    t40 = t14 * t30 - t18 * t39
    t41 = t24 * t35 + t25 * t37 + t27 * t38 + t28 * t40
    t42 = t35 - t24 * t41
    t43 = t37 - t25 * t41
    t44 = t38 - t27 * t41
    t45 = t40 - t28 * t41
    t46 = t24 * t42 + t25 * t43 + t27 * t44 + t28 * t45
    t47 = t42 - t24 * t46
    t48 = t43 - t25 * t46
    t49 = t44 - t27 * t46
    t50 = t45 - t28 * t46
    t51 = t47 * t47 + t48 * t48 + t49 * t49 + t50 * t50
    t52 = np.sqrt(t51)
    t53 = np.where(t52 != 0.0, 1, 0.0)
    t54 = t53 / (t52 + (1 - t53))
    t55 = t47 * t54
    t56 = t26 + t25 * t31
    t57 = t48 * t54
    t58 = t49 * t54
    t59 = t30 - t28 * t31
    t60 = t50 * t54
    t61 = t33 * t55 - t56 * t57 + t32 * t58 + t59 * t60
    t62 = t32 - t58 * t61
    t63 = t33 - t55 * t61
    t64 = 0.316 * s3
    t65 = t8 * t26 - c4 * t36
    t66 = t2 * t8 + t10 * t36
    t67 = t17 * t30 + t16 * t39
    t68 = t24 * t64 + t25 * t65 - t27 * t66 - t28 * t67
    t69 = t64 - t24 * t68
    t70 = t65 - t25 * t68
    t71 = t66 + t27 * t68
    t72 = t67 + t28 * t68
    t73 = t55 * t69 + t57 * t70 - t58 * t71 - t60 * t72
    t74 = t69 - t55 * t73
    t75 = t70 - t57 * t73
    t76 = t71 + t58 * t73
    t77 = t72 + t60 * t73
    t78 = t24 * t74 + t25 * t75 - t27 * t76 - t28 * t77
    t79 = t74 - t24 * t78
    t80 = t75 - t25 * t78
    t81 = t76 + t27 * t78
    t82 = t77 + t28 * t78
    t83 = t55 * t79 + t57 * t80 - t58 * t81 - t60 * t82
    t84 = t79 - t55 * t83
    t85 = t80 - t57 * t83
    t86 = t81 + t58 * t83
    t87 = t82 + t60 * t83
    t88 = t84 * t84 + t85 * t85 + t86 * t86 + t87 * t87
    t89 = np.sqrt(t88)
    t90 = np.where(t89 != 0.0, 1, 0.0)
    t91 = t90 / (t89 + (1 - t90))
    t92 = t84 * t91
    t93 = t56 + t57 * t61
    t94 = t85 * t91
    t95 = t86 * t91
    t96 = t59 - t60 * t61
    t97 = t87 * t91
    t98 = t63 * t92 - t93 * t94 - t62 * t95 - t96 * t97
    t99 = t62 + t95 * t98
    t100 = t96 + t97 * t98
    t101 = t63 - t92 * t98
    t102 = t93 + t94 * t98
    t103 = t27 * t99 + t28 * t100 + t24 * t101 - t25 * t102
    t104 = t99 - t27 * t103
    t105 = t101 - t24 * t103
    t106 = t102 + t25 * t103
    t107 = t100 - t28 * t103
    t108 = t55 * t105 - t57 * t106 + t58 * t104 + t60 * t107
    t109 = t104 - t58 * t108
    t110 = t105 - t55 * t108
    t111 = t106 + t57 * t108
    t112 = t107 - t60 * t108
    t113 = t92 * t110 - t94 * t111 - t95 * t109 - t97 * t112
    t114 = t109 + t95 * t113
    t115 = t112 + t97 * t113
    t116 = t110 - t92 * t113
    t117 = t111 + t94 * t113
    t118 = t114 * t114 + t115 * t115 + t116 * t116 + t117 * t117
    t119 = np.sqrt((t118 + s2 * s2))
    t120 = np.where(t119 != 0.0, 1, 0.0)
    t121 = t120 / (t119 + (1 - t120))
    t122 = s2 * t121
    t123 = c4 * t25 + t10 * t27 + t16 * t28
    t124 = t27 * t123 - t10
    t125 = t24 * t123
    t126 = t25 * t123 - c4
    t127 = t28 * t123 - t16
    t128 = t55 * t125 + t57 * t126 + t58 * t124 + t60 * t127
    t129 = t124 - t58 * t128
    t130 = t125 - t55 * t128
    t131 = t126 - t57 * t128
    t132 = t127 - t60 * t128
    t133 = t92 * t130 + t94 * t131 - t95 * t129 - t97 * t132
    t134 = t129 + t95 * t133
    t135 = t114 * t121
    t136 = t132 + t97 * t133
    t137 = t115 * t121
    t138 = t130 - t92 * t133
    t139 = t116 * t121
    t140 = t131 - t94 * t133
    t141 = t117 * t121
    t142 = t134 * t135 + t136 * t137 + t138 * t139 - t140 * t141
    t143 = t142 + t122 * c2
    t144 = t122 * t143 - c2
    t145 = t134 - t135 * t143
    t146 = t138 - t139 * t143
    t147 = t140 + t141 * t143
    t148 = t136 - t137 * t143
    t149 = t24 * t146 + t25 * t147 + t27 * t145 + t28 * t148
    t150 = t145 - t27 * t149
    t151 = t146 - t24 * t149
    t152 = t147 - t25 * t149
    t153 = t148 - t28 * t149
    t154 = t55 * t151 + t57 * t152 + t58 * t150 + t60 * t153
    t155 = t150 - t58 * t154
    t156 = t151 - t55 * t154
    t157 = t152 - t57 * t154
    t158 = t153 - t60 * t154
    t159 = t92 * t156 + t94 * t157 - t95 * t155 - t97 * t158
    t160 = t155 + t95 * t159
    t161 = t158 + t97 * t159
    t162 = t156 - t92 * t159
    t163 = t135 * t160 - t122 * t144 + t137 * t161 + t139 * t162
    t164 = t157 - t94 * t159
    t165 = t163 - t141 * t164
    t166 = t144 + t122 * t165
    t167 = t162 - t139 * t165
    t168 = t164 + t141 * t165
    t169 = t160 - t135 * t165
    t170 = 1 + t166 * t166 + t167 * t167 + t168 * t168 + t169 * t169
    t171 = t161 - t137 * t165
    t172 = np.sqrt((t170 + t171 * t171))
    t173 = np.where(t172 != 0.0, 1, 0.0)
    t174 = t173 / (t172 + (1 - t173))
    t175 = t166 * t174
    t176 = t18 * t28 - (t5 * t25 + c3 * t24 + t11 * t27)
    t177 = t11 + t27 * t176
    t178 = t18 - t28 * t176
    t179 = c3 + t24 * t176
    t180 = t5 + t25 * t176
    t181 = t60 * t178 - (t55 * t179 + t57 * t180 + t58 * t177)
    t182 = t177 + t58 * t181
    t183 = t179 + t55 * t181
    t184 = t180 + t57 * t181
    t185 = t178 - t60 * t181
    t186 = t95 * t182 - (t92 * t183 + t94 * t184) - t97 * t185
    t187 = t95 * t186 - t182
    t188 = t185 + t97 * t186
    t189 = t183 + t92 * t186
    t190 = t184 + t94 * t186
    t191 = t135 * t187 + t137 * t188 - t139 * t189 + t141 * t190
    t192 = t122 * t191
    t193 = t189 + t139 * t191
    t194 = t167 * t174
    t195 = t141 * t191 - t190
    t196 = t168 * t174
    t197 = t187 - t135 * t191
    t198 = t169 * t174
    t199 = t175 * t192 - t193 * t194 + t195 * t196 + t197 * t198
    t200 = t188 - t137 * t191
    t201 = t171 * t174
    t202 = t199 + t200 * t201
    t203 = t192 - t175 * t202
    t204 = t197 - t198 * t202
    t205 = t195 - t196 * t202
    t206 = t193 + t194 * t202
    t207 = t200 - t201 * t202
    t208 = t25 * t205 - t24 * t206 + t27 * t204 + t28 * t207
    t209 = t204 - t27 * t208
    t210 = t205 - t25 * t208
    t211 = t206 + t24 * t208
    t212 = t207 - t28 * t208
    t213 = t57 * t210 - t55 * t211 + t58 * t209 + t60 * t212
    t214 = t209 - t58 * t213
    t215 = t210 - t57 * t213
    t216 = t211 + t55 * t213
    t217 = t212 - t60 * t213
    t218 = t94 * t215 - t92 * t216 - t95 * t214 - t97 * t217
    t219 = t214 + t95 * t218
    t220 = t217 + t97 * t218
    t221 = t216 + t92 * t218
    t222 = t135 * t219 - t122 * t203 + t137 * t220 - t139 * t221
    t223 = t215 - t94 * t218
    t224 = t222 - t141 * t223
    t225 = t203 + t122 * t224
    t226 = t221 + t139 * t224
    t227 = t223 + t141 * t224
    t228 = t219 - t135 * t224
    t229 = t175 * t225 - t194 * t226 + t196 * t227 + t198 * t228
    t230 = t220 - t137 * t224
    t231 = t174 * t202
    t232 = t229 + t201 * t230 - t174 * t231
    t233 = t225 - t175 * t232
    t234 = t231 + t174 * t232
    t235 = t226 + t194 * t232
    t236 = t227 - t196 * t232
    t237 = 1 + t233 * t233 + t234 * t234 + t235 * t235 + t236 * t236
    t238 = t228 - t198 * t232
    t239 = t230 - t201 * t232
    t240 = np.sqrt((t237 + t238 * t238 + t239 * t239))
    t241 = np.where(t240 != 0.0, 1, 0.0)
    t242 = t241 / (t240 + (1 - t241))
    t243 = t233 * t242
    t244 = -(t242 * t243)
    t245 = t234 * t242
    t246 = t174 * t175 - t243 * t245
    t247 = t235 * t242
    t248 = t122 * t139 - t175 * t194 + t243 * t247
    t249 = t236 * t242
    t250 = -(t122 * t141 + t175 * t196 + t243 * t249)
    t251 = t238 * t242
    t252 = t122 * t135 - t175 * t198 - t243 * t251
    t253 = t239 * t242
    t254 = t122 * t137 - t175 * t201 - t243 * t253
    t255 = -(t242 * t245)
    t256 = t242 * t247
    t257 = -(t242 * t249)
    t258 = -(t242 * t251)
    t259 = -(t242 * t253)
    t260 = t174 * t194 + t245 * t247
    t261 = t174 * t196 - t245 * t249
    t262 = t174 * t198 - t245 * t251
    t263 = t174 * t201 - t245 * t253
    t264 = 1 - t24 * t24 - t55 * t55 - t92 * t92 - t139 * t139
    t265 = t139 * t141 - (t24 * t25 + t55 * t57 + t92 * t94)
    t266 = t265 - t194 * t196 + t247 * t249
    t267 = t92 * t95 - (t24 * t27 + t55 * t58) - t135 * t139
    t268 = t267 - t194 * t198 + t247 * t251
    t269 = t92 * t97 - (t24 * t28 + t55 * t60) - t137 * t139
    t270 = t269 - t194 * t201 + t247 * t253
    t271 = 1 - t25 * t25 - t57 * t57 - t94 * t94 - t141 * t141
    t272 = t94 * t95 - (t25 * t27 + t57 * t58) + t135 * t141
    t273 = t272 - t196 * t198 - t249 * t251
    t274 = t94 * t97 - (t25 * t28 + t57 * t60) + t137 * t141
    t275 = t274 - t196 * t201 - t249 * t253
    t276 = 1 - t27 * t27 - t58 * t58 - t95 * t95 - t135 * t135
    t277 = t27 * t28 + t58 * t60 + t95 * t97 + t135 * t137
    t278 = -(t277 + t198 * t201 + t251 * t253)
    t279 = 1 - t28 * t28 - t60 * t60 - t97 * t97 - t137 * t137

    # results
    null_projector = np.empty((*_leading, 49), _real)
    null_projector[..., 0] = 1 - t122 * t122 - t175 * t175 - t243 * t243
    null_projector[..., 1] = t244
    null_projector[..., 2] = t246
    null_projector[..., 3] = t248
    null_projector[..., 4] = t250
    null_projector[..., 5] = t252
    null_projector[..., 6] = t254
    null_projector[..., 7] = t244
    null_projector[..., 8] = 1 - t242 * t242
    null_projector[..., 9] = t255
    null_projector[..., 10] = t256
    null_projector[..., 11] = t257
    null_projector[..., 12] = t258
    null_projector[..., 13] = t259
    null_projector[..., 14] = t246
    null_projector[..., 15] = t255
    null_projector[..., 16] = 1 - t174 * t174 - t245 * t245
    null_projector[..., 17] = t260
    null_projector[..., 18] = t261
    null_projector[..., 19] = t262
    null_projector[..., 20] = t263
    null_projector[..., 21] = t248
    null_projector[..., 22] = t256
    null_projector[..., 23] = t260
    null_projector[..., 24] = t264 - t194 * t194 - t247 * t247
    null_projector[..., 25] = t266
    null_projector[..., 26] = t268
    null_projector[..., 27] = t270
    null_projector[..., 28] = t250
    null_projector[..., 29] = t257
    null_projector[..., 30] = t261
    null_projector[..., 31] = t266
    null_projector[..., 32] = t271 - t196 * t196 - t249 * t249
    null_projector[..., 33] = t273
    null_projector[..., 34] = t275
    null_projector[..., 35] = t252
    null_projector[..., 36] = t258
    null_projector[..., 37] = t262
    null_projector[..., 38] = t268
    null_projector[..., 39] = t273
    null_projector[..., 40] = t276 - t198 * t198 - t251 * t251
    null_projector[..., 41] = t278
    null_projector[..., 42] = t254
    null_projector[..., 43] = t259
    null_projector[..., 44] = t263
    null_projector[..., 45] = t270
    null_projector[..., 46] = t275
    null_projector[..., 47] = t278
    null_projector[..., 48] = t279 - t201 * t201 - t253 * t253
    return null_projector.reshape(_leading + (7, 7))
