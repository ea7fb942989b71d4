"""manipulability (position) of panda, in NumPy.

Made from templates/kernel.py.j2; inputs e6c4c77e8f404cf284ca42a0ff2b6a23389b6d8d94d0eb61c7056142a3802c50.
1522 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_position(q):
    """manipulability H = sqrt(det(J J^T)) of the position Jacobian: 237 operations.

    in   q[7]
    out  manipulability (one number)
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q5 = q[..., 4]
    s5 = np.sin(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    q6 = q[..., 5]
    s6 = np.sin(q6)
    c3 = np.cos(q3)
    c5 = np.cos(q5)
    c6 = np.cos(q6)
    c2 = np.cos(q2)

    # terms
    t1 = 0.0825 * s5
    t2 = s5 * c4
    t3 = t1 - 0.0825 * t2
    t4 = s5 * s4
    t5 = t3 - 0.316 * t4
    t6 = s5 * s6
    t7 = s6 * c5
    t8 = c4 * t7 + s4 * c6
    t9 = c4 * c6 - s4 * t7
    t10 = s2 * (s3 * t6 - c3 * t8) - c2 * t9
    t11 = 0.0825 * t7 + 0.384 * c6
    t12 = 0.0825 * t8 - t11
    t13 = -0.107 - (t12 - 0.316 * t9)
    t14 = s2 * (t2 * c3 + s3 * c5) - t4 * c2
    t15 = t5 * t10 + t13 * t14
    t16 = s5 * c6
    t17 = c5 * c6
    t18 = c4 * t17 - s4 * s6
    t19 = c3 * t16 + s3 * t18
    t20 = 0.0825 * t17 - 0.384 * s6
    t21 = t20 - 0.0825 * t18
    t22 = c4 * s6 + s4 * t17
    t23 = 0.088 - (t21 - 0.316 * t22)
    t24 = t2 * s3 - c3 * c5
    t25 = t5 * t19 + t23 * t24
    t26 = s2 * (c3 * t18 - s3 * t16) - c2 * t22
    t27 = t5 * t26 + t14 * t23
    t28 = t6 * c3 + s3 * t8
    t29 = t5 * t28 - t13 * t24
    t30 = t15 * t25 + t27 * t29
    t31 = -0.107 - t12
    t32 = 0.088 - t21
    t33 = t22 * t31 - t9 * t32
    t34 = t3 * t22 + t4 * t32
    t35 = t3 * t9 + t4 * t31
    t36 = t29 * t34 + t25 * t35
    t37 = t10 * t23 - t13 * t26
    t38 = t15 * t34 - t27 * t35
    t39 = t13 * t19 + t23 * t28
    t40 = t30 * t33 + t36 * t37 - t38 * t39
    t41 = 0.088 - t20
    t42 = c5 * t41 - t1 * t16
    t43 = -0.107 + t11
    t44 = t1 * t6 + c5 * t43
    t45 = t29 * t42 + t25 * t44
    t46 = t6 * t41 + t16 * t43
    t47 = t15 * t42 - t27 * t44
    t48 = t37 * t45 - t30 * t46 - t39 * t47
    t49 = -0.107 * s6 - 0.088 * c6
    t50 = t30 * t49
    t51 = 0.088 * t29 - 0.107 * t25
    t52 = 0.088 * t15 + 0.107 * t27
    t53 = t37 * t51 - t39 * t52
    t54 = t40 * t40 + t48 * t48 + t50 * t50 + t53 * t53
    t55 = t34 * t44 - t35 * t42
    t56 = t37 * t55 - t38 * t46 - t33 * t47
    t57 = t38 * t49
    t58 = 0.088 * t35 + 0.107 * t34
    t59 = t37 * t58 + t33 * t52
    t60 = t47 * t49
    t61 = t54 + t56 * t56 + t57 * t57 + t59 * t59 + t60 * t60
    t62 = 0.088 * t44 + 0.107 * t42
    t63 = t46 * t52 - t37 * t62
    t64 = t49 * t52
    t65 = t39 * t55 - t36 * t46 - t33 * t45
    t66 = t36 * t49
    t67 = t61 + t63 * t63 + t64 * t64 + t65 * t65 + t66 * t66
    t68 = t39 * t58 + t33 * t51
    t69 = t45 * t49
    t70 = t46 * t51 - t39 * t62
    t71 = t49 * t51
    t72 = t67 + t68 * t68 + t69 * t69 + t70 * t70 + t71 * t71
    t73 = t49 * t55
    t74 = t33 * t62 + t46 * t58
    t75 = t49 * t58
    t76 = t49 * t62
    t77 = t72 + t73 * t73 + t74 * t74 + t75 * t75 + t76 * t76

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.sqrt(t77)
    return manipulability.reshape(_leading)


def manipulability_gradient_position(q):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in lexicographic order: 702 operations.

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
    q5 = q[..., 4]
    s5 = np.sin(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    q6 = q[..., 5]
    s6 = np.sin(q6)
    c3 = np.cos(q3)
    c5 = np.cos(q5)
    c6 = np.cos(q6)
    c2 = np.cos(q2)

    # terms
    t1 = 0.0825 * s5
    t2 = s5 * c4
    t3 = t1 - 0.0825 * t2
    t4 = s5 * s4
    t5 = t3 - 0.316 * t4
    t6 = s5 * s6
    t7 = s6 * c5
    t8 = c4 * t7 + s4 * c6
    t9 = s3 * t6 - c3 * t8
    t10 = c4 * c6 - s4 * t7
    t11 = s2 * t9 - c2 * t10
    t12 = 0.0825 * t7 + 0.384 * c6
    t13 = 0.0825 * t8 - t12
    t14 = -0.107 - (t13 - 0.316 * t10)
    t15 = t2 * c3 + s3 * c5
    t16 = s2 * t15 - t4 * c2
    t17 = t5 * t11 + t14 * t16
    t18 = s5 * c6
    t19 = c5 * c6
    t20 = c4 * t19 - s4 * s6
    t21 = c3 * t18 + s3 * t20
    t22 = 0.0825 * t19 - 0.384 * s6
    t23 = t22 - 0.0825 * t20
    t24 = c4 * s6 + s4 * t19
    t25 = 0.088 - (t23 - 0.316 * t24)
    t26 = t2 * s3 - c3 * c5
    t27 = t5 * t21 + t25 * t26
    t28 = c3 * t20 - s3 * t18
    t29 = s2 * t28 - c2 * t24
    t30 = t5 * t29 + t16 * t25
    t31 = t6 * c3 + s3 * t8
    t32 = t5 * t31 - t14 * t26
    t33 = t17 * t27 + t30 * t32
    t34 = -0.107 - t13
    t35 = 0.088 - t23
    t36 = t24 * t34 - t10 * t35
    t37 = t3 * t24 + t4 * t35
    t38 = t3 * t10 + t4 * t34
    t39 = t32 * t37 + t27 * t38
    t40 = t11 * t25 - t14 * t29
    t41 = t17 * t37 - t30 * t38
    t42 = t14 * t21 + t25 * t31
    t43 = t33 * t36 + t39 * t40 - t41 * t42
    t44 = 0.088 - t22
    t45 = c5 * t44 - t1 * t18
    t46 = -0.107 + t12
    t47 = t1 * t6 + c5 * t46
    t48 = t32 * t45 + t27 * t47
    t49 = t6 * t44 + t18 * t46
    t50 = t17 * t45 - t30 * t47
    t51 = t40 * t48 - t33 * t49 - t42 * t50
    t52 = -0.107 * s6 - 0.088 * c6
    t53 = t33 * t52
    t54 = 0.088 * t32 - 0.107 * t27
    t55 = 0.088 * t17 + 0.107 * t30
    t56 = t40 * t54 - t42 * t55
    t57 = t43 * t43 + t51 * t51 + t53 * t53 + t56 * t56
    t58 = t37 * t47 - t38 * t45
    t59 = t40 * t58 - t41 * t49 - t36 * t50
    t60 = t41 * t52
    t61 = 0.088 * t38 + 0.107 * t37
    t62 = t40 * t61 + t36 * t55
    t63 = t50 * t52
    t64 = t57 + t59 * t59 + t60 * t60 + t62 * t62 + t63 * t63
    t65 = 0.088 * t47 + 0.107 * t45
    t66 = t49 * t55 - t40 * t65
    t67 = t52 * t55
    t68 = t42 * t58 - t39 * t49 - t36 * t48
    t69 = t39 * t52
    t70 = t64 + t66 * t66 + t67 * t67 + t68 * t68 + t69 * t69
    t71 = t42 * t61 + t36 * t54
    t72 = t48 * t52
    t73 = t49 * t54 - t42 * t65
    t74 = t52 * t54
    t75 = t70 + t71 * t71 + t72 * t72 + t73 * t73 + t74 * t74
    t76 = t52 * t58
    t77 = t36 * t65 + t49 * t61
    t78 = t52 * t61
    t79 = t52 * t65
    t80 = t75 + t76 * t76 + t77 * t77 + t78 * t78 + t79 * t79
    t81 = np.sqrt(t80)
    t82 = t67 / t81
    t83 = t66 / t81
    t84 = t62 / t81
    t85 = t56 / t81
    t86 = t52 * t82 + t49 * t83 + t36 * t84 - t42 * t85
    t87 = t63 / t81
    t88 = t59 / t81
    t89 = t51 / t81
    t90 = t52 * t87 - t36 * t88 - t42 * t89
    t91 = t60 / t81
    t92 = t43 / t81
    t93 = t52 * t91 - t49 * t88 - t42 * t92
    t94 = t53 / t81
    t95 = t52 * t94 - t49 * t89 + t36 * t92
    t96 = 0.107 * t86 - t47 * t90 - t38 * t93 + t32 * t95
    t97 = t61 * t84 - t65 * t83 + t58 * t88 + t54 * t85
    t98 = t97 + t48 * t89 + t39 * t92
    t99 = t5 * t96 - t14 * t98
    t100 = 0.088 * t86 + t45 * t90 + t37 * t93 + t27 * t95
    t101 = t25 * t96 + t14 * t100
    t102 = t25 * t98 + t5 * t100
    t103 = s2 * (t24 * t99 + t4 * t101 + t10 * t102) + c2 * (t28 * t99 + t15 * t101 + t9 * t102)
    t104 = t71 / t81
    t105 = t73 / t81
    t106 = t68 / t81
    t107 = t61 * t104 - t65 * t105 + t58 * t106 - t55 * t85
    t108 = t107 - t50 * t89 - t41 * t92
    t109 = t74 / t81
    t110 = t52 * t109 + t49 * t105 + t36 * t104 + t40 * t85
    t111 = t72 / t81
    t112 = t52 * t111 - t36 * t106 + t40 * t89
    t113 = t69 / t81
    t114 = t52 * t113 - t49 * t106 + t40 * t92
    t115 = 0.088 * t110 + t45 * t112 + t37 * t114 + t30 * t95
    t116 = t25 * t108 + t5 * t115
    t117 = s2 * t99
    t118 = t47 * t112 - 0.107 * t110 + t38 * t114 + t17 * t95
    t119 = t25 * t118 - t14 * t115
    t120 = t14 * t108 + t5 * t118
    t121 = t8 * t116 - t18 * t117 + t2 * t119 + t20 * t120
    t122 = s2 * t101
    t123 = s2 * t102
    t124 = t6 * t116 + t20 * t117 - c5 * t119 + t18 * t120
    t125 = c3 * (t121 + c5 * t122 + t6 * t123) - s3 * (t124 + t2 * t122 - t8 * t123)
    t126 = t78 / t81
    t127 = t77 / t81
    t128 = t52 * t126 + t49 * t127 + t42 * t104 + t40 * t84
    t129 = t76 / t81
    t130 = t52 * t129 + t42 * t106 + t40 * t88
    t131 = 0.107 * t128 + t47 * t130 + t17 * t93 + t32 * t114
    t132 = t65 * t127 + t54 * t104 - t48 * t106 + t55 * t84
    t133 = t132 - t50 * t88 + t33 * t92
    t134 = t31 * t108 + t11 * t98 + t16 * t96 + t26 * t118
    t135 = t3 * t131 + t34 * t133 - c2 * t99 + 0.316 * t134
    t136 = t134 + (t4 * t131 - t10 * t133)
    t137 = c3 * t117 + 0.0825 * t136 + s3 * t120
    t138 = 0.088 * t128 - t45 * t130 - t30 * t93 + t27 * t114
    t139 = t21 * t108 - t29 * t98 - t26 * t115 + t16 * t100
    t140 = t3 * t138 - t35 * t133 + 0.316 * t139 - c2 * t102
    t141 = t139 + (t4 * t138 + t24 * t133)
    t142 = s3 * t116 - 0.0825 * t141 - c3 * t123
    t143 = t19 * t135 - s6 * t137 - t7 * t140 + c6 * t142
    t144 = t31 * t115 + t29 * t96 + t21 * t118 + t11 * t100
    t145 = t34 * t138 + t35 * t131 - c2 * t101 - 0.316 * t144
    t146 = s6 * t135 + t19 * t137 + c6 * t140 + t7 * t142
    t147 = t144 + (t10 * t138 + t24 * t131)
    t148 = s3 * t119 + c3 * t122 - 0.0825 * t147
    t149 = c4 * (t143 + s5 * t145) - s4 * (t146 + s5 * t148)
    t150 = t61 * t127 + t54 * t105 - t39 * t106 + t55 * t83
    t151 = t150 - t41 * t88 - t33 * t89
    t152 = t79 / t81
    t153 = t52 * t152 + t36 * t127 - t42 * t105 - t40 * t83
    t154 = 0.107 * t153 - t38 * t130 + t17 * t90 + t32 * t112
    t155 = t46 * t151 - t1 * t154 - s3 * t117 + c3 * t120
    t156 = 0.088 * t153 + t37 * t130 - t30 * t90 + t27 * t112
    t157 = t44 * t151 + t1 * t156 + c3 * t116 + s3 * t123
    t158 = c6 * t155 + s6 * t157 + s4 * t145 + c4 * t148
    t159 = c5 * (t158 + 0.0825 * (t147 + (t6 * t156 - t18 * t154)))
    t160 = t136 + (t6 * t151 + c5 * t154)
    t161 = s4 * t135 - 0.0825 * t160 + c4 * t137
    t162 = t46 * t156 + t44 * t154 - c3 * t119 + c6 * t161
    t163 = t141 + (t18 * t151 + c5 * t156)
    t164 = 0.0825 * t163 - s4 * t140 + c4 * t142
    t165 = t159 - s5 * (t162 + s3 * t122 + s6 * t164)
    t166 = t65 * t152 + t61 * t126 + t58 * t129 + t54 * t109
    t167 = t166 + t48 * t111 + t39 * t113 + t55 * t82 + t50 * t87
    t168 = t167 + t41 * t91 + t33 * t94
    t169 = -0.107 * t168 + c4 * t135 + 0.384 * t160 - s4 * t137
    t170 = c5 * t161 - 0.088 * t168 + s5 * t155 + 0.384 * t163
    t171 = c6 * (t169 + c5 * t164 + s5 * t157) - s6 * (t170 + c4 * t140 + s4 * t142)
    t172 = 1 / t81
    t173 = t172 * t172
    t174 = -0.5 / t81 * np.sqrt(t172)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 7), _real)
    inverse_gradient = np.empty((*_leading, 7), _real)
    inverse_root_gradient = np.empty((*_leading, 7), _real)
    manipulability[..., 0] = t81
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t81 != 0.0, t103, 0.0)
    gradient[..., 2] = np.where(t81 != 0.0, t125, 0.0)
    gradient[..., 3] = np.where(t81 != 0.0, t149, 0.0)
    gradient[..., 4] = np.where(t81 != 0.0, t165, 0.0)
    gradient[..., 5] = np.where(t81 != 0.0, t171, 0.0)
    gradient[..., 6] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t81 != 0.0, -(t103 * t173), 0.0)
    inverse_gradient[..., 2] = np.where(t81 != 0.0, -(t125 * t173), 0.0)
    inverse_gradient[..., 3] = np.where(t81 != 0.0, -(t149 * t173), 0.0)
    inverse_gradient[..., 4] = np.where(t81 != 0.0, -(t165 * t173), 0.0)
    inverse_gradient[..., 5] = np.where(t81 != 0.0, -(t171 * t173), 0.0)
    inverse_gradient[..., 6] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t81 != 0.0, t103 * t174, 0.0)
    inverse_root_gradient[..., 2] = np.where(t81 != 0.0, t125 * t174, 0.0)
    inverse_root_gradient[..., 3] = np.where(t81 != 0.0, t149 * t174, 0.0)
    inverse_root_gradient[..., 4] = np.where(t81 != 0.0, t165 * t174, 0.0)
    inverse_root_gradient[..., 5] = np.where(t81 != 0.0, t171 * t174, 0.0)
    inverse_root_gradient[..., 6] = 0.0
    return manipulability.reshape(_leading), gradient.reshape(_leading + (7,)), inverse_gradient.reshape(_leading + (7,)), inverse_root_gradient.reshape(_leading + (7,))


def minors_position(q):
    """maximal minors of the position Jacobian, columns in lexicographic order: 202 operations.

    in   q[7]
    out  minors[35]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q5 = q[..., 4]
    s5 = np.sin(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    q6 = q[..., 5]
    s6 = np.sin(q6)
    c3 = np.cos(q3)
    c5 = np.cos(q5)
    c6 = np.cos(q6)
    c2 = np.cos(q2)

    # terms
    t1 = 0.0825 * s5
    t2 = s5 * c4
    t3 = t1 - 0.0825 * t2
    t4 = s5 * s4
    t5 = t3 - 0.316 * t4
    t6 = s5 * s6
    t7 = s6 * c5
    t8 = c4 * t7 + s4 * c6
    t9 = c4 * c6 - s4 * t7
    t10 = s2 * (s3 * t6 - c3 * t8) - c2 * t9
    t11 = 0.0825 * t7 + 0.384 * c6
    t12 = 0.0825 * t8 - t11
    t13 = -0.107 - (t12 - 0.316 * t9)
    t14 = s2 * (t2 * c3 + s3 * c5) - t4 * c2
    t15 = t5 * t10 + t13 * t14
    t16 = s5 * c6
    t17 = c5 * c6
    t18 = c4 * t17 - s4 * s6
    t19 = c3 * t16 + s3 * t18
    t20 = 0.0825 * t17 - 0.384 * s6
    t21 = t20 - 0.0825 * t18
    t22 = c4 * s6 + s4 * t17
    t23 = 0.088 - (t21 - 0.316 * t22)
    t24 = t2 * s3 - c3 * c5
    t25 = t5 * t19 + t23 * t24
    t26 = s2 * (c3 * t18 - s3 * t16) - c2 * t22
    t27 = t5 * t26 + t14 * t23
    t28 = t6 * c3 + s3 * t8
    t29 = t5 * t28 - t13 * t24
    t30 = t15 * t25 + t27 * t29
    t31 = -0.107 - t12
    t32 = 0.088 - t21
    t33 = t22 * t31 - t9 * t32
    t34 = t3 * t22 + t4 * t32
    t35 = t3 * t9 + t4 * t31
    t36 = t29 * t34 + t25 * t35
    t37 = t10 * t23 - t13 * t26
    t38 = t15 * t34 - t27 * t35
    t39 = t13 * t19 + t23 * t28
    t40 = 0.088 - t20
    t41 = c5 * t40 - t1 * t16
    t42 = -0.107 + t11
    t43 = t1 * t6 + c5 * t42
    t44 = t29 * t41 + t25 * t43
    t45 = t6 * t40 + t16 * t42
    t46 = t15 * t41 - t27 * t43
    t47 = -0.107 * s6 - 0.088 * c6
    t48 = 0.088 * t29 - 0.107 * t25
    t49 = 0.088 * t15 + 0.107 * t27
    t50 = t34 * t43 - t35 * t41
    t51 = 0.088 * t35 + 0.107 * t34
    t52 = 0.088 * t43 + 0.107 * t41

    # results
    minors = np.empty((*_leading, 35), _real)
    minors[..., 0] = t30 * t33 + t36 * t37 - t38 * t39
    minors[..., 1] = t37 * t44 - t30 * t45 - t39 * t46
    minors[..., 2] = t30 * t47
    minors[..., 3] = t37 * t48 - t39 * t49
    minors[..., 4] = 0.0
    minors[..., 5] = t37 * t50 - t38 * t45 - t33 * t46
    minors[..., 6] = t38 * t47
    minors[..., 7] = -(t37 * t51 + t33 * t49)
    minors[..., 8] = 0.0
    minors[..., 9] = t46 * t47
    minors[..., 10] = t45 * t49 - t37 * t52
    minors[..., 11] = 0.0
    minors[..., 12] = -(t47 * t49)
    minors[..., 13] = 0.0
    minors[..., 14] = 0.0
    minors[..., 15] = t39 * t50 - t36 * t45 - t33 * t44
    minors[..., 16] = t36 * t47
    minors[..., 17] = -(t39 * t51 + t33 * t48)
    minors[..., 18] = 0.0
    minors[..., 19] = t44 * t47
    minors[..., 20] = t45 * t48 - t39 * t52
    minors[..., 21] = 0.0
    minors[..., 22] = -(t47 * t48)
    minors[..., 23] = 0.0
    minors[..., 24] = 0.0
    minors[..., 25] = t47 * t50
    minors[..., 26] = -(t33 * t52 + t45 * t51)
    minors[..., 27] = 0.0
    minors[..., 28] = t47 * t51
    minors[..., 29] = 0.0
    minors[..., 30] = 0.0
    minors[..., 31] = t47 * t52
    minors[..., 32] = 0.0
    minors[..., 33] = 0.0
    minors[..., 34] = 0.0
    return minors.reshape(_leading + (35,))


def null_projector_position(q):
    """projector I - J^+ J onto the null space of the position Jacobian: 381 operations.

    in   q[7]
    out  null_projector[7][7]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q5 = q[..., 4]
    s5 = np.sin(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    q6 = q[..., 5]
    s6 = np.sin(q6)
    c3 = np.cos(q3)
    c5 = np.cos(q5)
    c6 = np.cos(q6)
    c2 = np.cos(q2)

    # terms
    t1 = 0.0825 * s5
    t2 = s5 * c4
    t3 = t1 - 0.0825 * t2
    t4 = s5 * s4
    t5 = t3 - 0.316 * t4
    t6 = s5 * s6
    t7 = s6 * c5
    t8 = c4 * t7 + s4 * c6
    t9 = c4 * c6 - s4 * t7
    t10 = s2 * (s3 * t6 - c3 * t8) - c2 * t9
    t11 = 0.0825 * t7 + 0.384 * c6
    t12 = 0.0825 * t8 - t11
    t13 = -0.107 - (t12 - 0.316 * t9)
    t14 = s2 * (t2 * c3 + s3 * c5) - t4 * c2
    t15 = t5 * t10 + t13 * t14
    t16 = t6 * c3 + s3 * t8
    t17 = t2 * s3 - c3 * c5
    t18 = t5 * t16 - t13 * t17
    t19 = -0.107 - t12
    t20 = t3 * t9 + t4 * t19
    t21 = -0.107 + t11
    t22 = t1 * t6 + c5 * t21
    t23 = 0.011448999999999999 + t15 * t15 + t18 * t18 + t20 * t20 + t22 * t22
    t24 = np.sqrt(t23)
    t25 = np.where(t24 != 0.0, 1, 0.0)
    t26 = t25 / (t24 + (1 - t25))
    t27 = t15 * t26
    t28 = c5 * c6
    t29 = c4 * t28 - s4 * s6
    t30 = s5 * c6
    t31 = c4 * s6 + s4 * t28
    t32 = s2 * (c3 * t29 - s3 * t30) - c2 * t31
    t33 = 0.0825 * t28 - 0.384 * s6
    t34 = t33 - 0.0825 * t29
    t35 = 0.088 - (t34 - 0.316 * t31)
    t36 = t5 * t32 + t14 * t35
    t37 = t18 * t26
    t38 = c3 * t30 + s3 * t29
    t39 = t5 * t38 + t17 * t35
    t40 = t20 * t26
    t41 = 0.088 - t34
    t42 = t3 * t31 + t4 * t41
    t43 = 0.009415999999999999 * t26 - t27 * t36 + t37 * t39 - t40 * t42
    t44 = t22 * t26
    t45 = 0.088 - t33
    t46 = c5 * t45 - t1 * t30
    t47 = t43 - t44 * t46
    t48 = t36 + t27 * t47
    t49 = t39 - t37 * t47
    t50 = t42 + t40 * t47
    t51 = t46 + t44 * t47
    t52 = t37 * t49 - t27 * t48 - t40 * t50 - t44 * t51
    t53 = 0.107 * t26
    t54 = 0.088 - t47 * t53
    t55 = t52 + t53 * t54
    t56 = t48 + t27 * t55
    t57 = t49 - t37 * t55
    t58 = t50 + t40 * t55
    t59 = t51 + t44 * t55
    t60 = t56 * t56 + t57 * t57 + t58 * t58 + t59 * t59
    t61 = t54 - t53 * t55
    t62 = np.sqrt((t60 + t61 * t61))
    t63 = np.where(t62 != 0.0, 1, 0.0)
    t64 = t63 / (t62 + (1 - t63))
    t65 = t56 * t64
    t66 = t10 * t35 - t13 * t32
    t67 = t13 * t38 + t16 * t35
    t68 = t19 * t31 - t9 * t41
    t69 = t6 * t45 + t21 * t30
    t70 = t27 * t66 + t37 * t67 - t40 * t68 + t44 * t69
    t71 = t66 - t27 * t70
    t72 = t67 - t37 * t70
    t73 = t57 * t64
    t74 = t68 + t40 * t70
    t75 = t58 * t64
    t76 = t44 * t70 - t69
    t77 = t59 * t64
    t78 = t72 * t73 - t65 * t71 + t74 * t75 + t76 * t77
    t79 = t53 * t70
    t80 = t61 * t64
    t81 = t78 - t79 * t80
    t82 = t71 + t65 * t81
    t83 = t72 - t73 * t81
    t84 = t74 - t75 * t81
    t85 = t76 - t77 * t81
    t86 = t27 * t82 + t37 * t83 - t40 * t84 - t44 * t85
    t87 = t79 + t80 * t81
    t88 = t86 - t53 * t87
    t89 = t82 - t27 * t88
    t90 = t83 - t37 * t88
    t91 = t84 + t40 * t88
    t92 = t85 + t44 * t88
    t93 = t73 * t90 - t65 * t89 + t75 * t91 + t77 * t92
    t94 = t87 + t53 * t88
    t95 = t93 - t80 * t94
    t96 = t89 + t65 * t95
    t97 = t90 - t73 * t95
    t98 = t91 - t75 * t95
    t99 = t92 - t77 * t95
    t100 = t96 * t96 + t97 * t97 + t98 * t98 + t99 * t99
    t101 = t94 + t80 * t95
    t102 = -0.107 * s6 - 0.088 * c6
    t103 = np.sqrt((t100 + t101 * t101 + t102 * t102))
    t104 = np.where(t103 != 0.0, 1, 0.0)
    t105 = t104 / (t103 + (1 - t104))
    t106 = t96 * t105
    t107 = t97 * t105
    t108 = t65 * t73 - t27 * t37 - t106 * t107
    t109 = t98 * t105
    t110 = t27 * t40 + t65 * t75 - t106 * t109
    t111 = t99 * t105
    t112 = t27 * t44 + t65 * t77 - t106 * t111
    t113 = t102 * t105
    t114 = -(t106 * t113)
    t115 = t101 * t105
    t116 = t65 * t80 - t27 * t53 + t106 * t115
    t117 = t37 * t40 - t73 * t75 - t107 * t109
    t118 = t37 * t44 - t73 * t77 - t107 * t111
    t119 = -(t107 * t113)
    t120 = t107 * t115 - (t37 * t53 + t73 * t80)
    t121 = -(t40 * t44 + t75 * t77 + t109 * t111)
    t122 = -(t109 * t113)
    t123 = t40 * t53 - t75 * t80 + t109 * t115
    t124 = -(t111 * t113)
    t125 = t44 * t53 - t77 * t80 + t111 * t115
    t126 = t113 * t115

    # results
    null_projector = np.empty((*_leading, 49), _real)
    null_projector[..., 0] = 1 - t27 * t27 - t65 * t65 - t106 * t106
    null_projector[..., 1] = t108
    null_projector[..., 2] = t110
    null_projector[..., 3] = t112
    null_projector[..., 4] = t114
    null_projector[..., 5] = t116
    null_projector[..., 6] = 0.0
    null_projector[..., 7] = t108
    null_projector[..., 8] = 1 - t37 * t37 - t73 * t73 - t107 * t107
    null_projector[..., 9] = t117
    null_projector[..., 10] = t118
    null_projector[..., 11] = t119
    null_projector[..., 12] = t120
    null_projector[..., 13] = 0.0
    null_projector[..., 14] = t110
    null_projector[..., 15] = t117
    null_projector[..., 16] = 1 - t40 * t40 - t75 * t75 - t109 * t109
    null_projector[..., 17] = t121
    null_projector[..., 18] = t122
    null_projector[..., 19] = t123
    null_projector[..., 20] = 0.0
    null_projector[..., 21] = t112
    null_projector[..., 22] = t118
    null_projector[..., 23] = t121
    null_projector[..., 24] = 1 - t44 * t44 - t77 * t77 - t111 * t111
    null_projector[..., 25] = t124
    null_projector[..., 26] = t125
    null_projector[..., 27] = 0.0
    null_projector[..., 28] = t114
    null_projector[..., 29] = t119
    null_projector[..., 30] = t122
    null_projector[..., 31] = t124
    null_projector[..., 32] = 1 - t113 * t113
    null_projector[..., 33] = t126
    null_projector[..., 34] = 0.0
    null_projector[..., 35] = t116
    null_projector[..., 36] = t120
    null_projector[..., 37] = t123
    null_projector[..., 38] = t125
    null_projector[..., 39] = t126
    null_projector[..., 40] = 1 - t53 * t53 - t80 * t80 - t115 * t115
    null_projector[..., 41] = 0.0
    null_projector[..., 42] = 0.0
    null_projector[..., 43] = 0.0
    null_projector[..., 44] = 0.0
    null_projector[..., 45] = 0.0
    null_projector[..., 46] = 0.0
    null_projector[..., 47] = 0.0
    null_projector[..., 48] = 1
    return null_projector.reshape(_leading + (7, 7))
