"""manipulability (pose) of sanchez_8r, in NumPy.

Made from templates/kernel.py.j2; inputs d39850215ba62f6359711b34f92574fc21ceb4e15f0e03e3d97abaca5a15255b.
3779 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_pose(q):
    """manipulability H = sqrt(det(J J^T)) of the pose Jacobian: 410 operations.

    in   q[8]
    out  manipulability (one number)
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q5 = q[..., 4]
    c5 = np.cos(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s4 = np.sin(q4)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s5 = np.sin(q5)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    q7 = q[..., 6]
    s7 = np.sin(q7)
    c7 = np.cos(q7)

    # terms
    t1 = c3 * s4
    t2 = -0.2 * c4 + 0.25 * t1
    t3 = s4 * s5
    t4 = c4 * s5
    t5 = c3 * t4 + c5 * s3
    t6 = c2 * t3 - s2 * t5
    t7 = 0.25 * t5 - -0.2 * t3
    t8 = t1 * s2 + c4 * c2
    t9 = t2 * t6 + t7 * t8
    t10 = c5 * c4
    t11 = c3 * s5 + s3 * t10
    t12 = c5 * s4
    t13 = c3 * t10 - s5 * s3
    t14 = -0.2 * t12 - 0.25 * t13
    t15 = s4 * s3
    t16 = t2 * t11 + t14 * t15
    t17 = s2 * t13 - c2 * t12
    t18 = t8 * t14 + t2 * t17
    t19 = c5 * c3 - t4 * s3
    t20 = t7 * t15 + t2 * t19
    t21 = t9 * t16 - t18 * t20
    t22 = 0.2 * t21
    t23 = t12 * t22
    t24 = s5 * t22
    t25 = c5 * t23 + t3 * t24
    t26 = 0.2 + 0.2 * c6
    t27 = -0.2 * s6
    t28 = t16 * t27
    t29 = t7 * t17 - t6 * t14
    t30 = t18 * t27
    t31 = t14 * t19 - t7 * t11
    t32 = t21 * t26 + t28 * t29 + t30 * t31
    t33 = t12 * t32
    t34 = s5 * t32
    t35 = c5 * t33 + t3 * t34
    t36 = c6 * s7 + s6 * c7
    t37 = s6 * s7 - c6 * c7
    t38 = t27 * t36 + t26 * t37
    t39 = t20 * t38
    t40 = t9 * t38
    t41 = t29 * t39 + t31 * t40
    t42 = t12 * t41
    t43 = s5 * t41
    t44 = c5 * t42 + t3 * t43
    t45 = -0.2 * t30
    t46 = s5 * t45
    t47 = -0.2 * t28
    t48 = s5 * t47
    t49 = c4 * t24 - t19 * (c4 * t46) + t6 * (c4 * t48)
    t50 = t17 * t47 - t11 * t45
    t51 = t12 * t45
    t52 = t12 * t47
    t53 = t49 - c4 * t34 - c5 * (c4 * t50 - t15 * t51 + t8 * t52)
    t54 = t53 + t3 * (t15 * t46 - t8 * t48)
    t55 = t25 * t25 + t35 * t35 + t44 * t44 + t54 * t54
    t56 = -0.2 * t39
    t57 = s5 * t56
    t58 = c4 * t57
    t59 = -0.2 * t40
    t60 = s5 * t59
    t61 = c4 * t60
    t62 = c4 * t43
    t63 = t17 * t56 - (t22 * t36 + t11 * t59)
    t64 = t12 * t59
    t65 = t12 * t56
    t66 = c4 * t63 - t23 * t37 - t15 * t64 + t8 * t65
    t67 = t24 * t37 + t15 * t60 - t8 * t57
    t68 = t6 * t58 - t19 * t61 - t62 - c5 * t66 + t3 * t67
    t69 = t27 * t38
    t70 = t29 * t69 + t26 * t40
    t71 = s5 * t70
    t72 = c4 * t71
    t73 = t31 * t69 - t26 * t39
    t74 = s5 * t73
    t75 = c4 * t74
    t76 = t11 * t70 - t32 * t36 + t17 * t73
    t77 = t12 * t70
    t78 = t12 * t73
    t79 = c4 * t76 - t33 * t37 + t15 * t77 + t8 * t78
    t80 = t34 * t37 - t15 * t71 - t8 * t74
    t81 = t19 * t72 + t6 * t75 - t62 - c5 * t79 + t3 * t80
    t82 = t23 + (t6 * t52 - (t33 + t19 * t51)) + t3 * t50
    t83 = t6 * t65 - (t42 + t19 * t64) + t3 * t63
    t84 = t55 + t68 * t68 + t81 * t81 + t82 * t82 + t83 * t83
    t85 = t19 * t77 - t42 + t6 * t78 + t3 * t76
    t86 = 0.2 * t69
    t87 = t36 * t45 + t17 * t86
    t88 = t12 * t86
    t89 = t37 * t51 + c4 * t87 + t8 * t88
    t90 = t36 * t47 + t11 * t86
    t91 = t37 * t52 + t15 * t88 + c4 * t90
    t92 = t37 * t50 + t15 * t87 - t8 * t90
    t93 = t79 - t19 * t89 + t6 * t91 - t66 + t3 * t92
    t94 = t34 + c5 * t50 + t19 * t46 - t6 * t48 - t24
    t95 = t43 + c5 * t63 + t19 * t60 - t6 * t57
    t96 = t84 + t85 * t85 + t93 * t93 + t94 * t94 + t95 * t95
    t97 = t43 + c5 * t76 - t19 * t71 - t6 * t74
    t98 = s5 * t86
    t99 = t37 * t46 + t8 * t98
    t100 = t37 * t48 + t15 * t98
    t101 = t80 + c5 * t92 + t19 * t99 - t6 * t100 - t67
    t102 = t76 - t63 - t19 * t87 + t6 * t90
    t103 = c5 * t51 + t3 * t46
    t104 = t96 + t97 * t97 + t101 * t101 + t102 * t102 + t103 * t103
    t105 = c5 * t64 + t3 * t60
    t106 = c5 * t77 + t3 * t71
    t107 = c4 * t98
    t108 = t61 + (t72 - c5 * t89 - t3 * t99 + t6 * t107)
    t109 = t64 + t77 + t3 * t87 + t6 * t88
    t110 = t104 + t105 * t105 + t106 * t106 + t108 * t108 + t109 * t109
    t111 = c5 * t87 - t71 - t60 - t6 * t98
    t112 = c5 * t52 + t3 * t48
    t113 = c5 * t65 + t3 * t57
    t114 = c5 * t78 + t3 * t74
    t115 = t110 + t111 * t111 + t112 * t112 + t113 * t113 + t114 * t114
    t116 = t75 + c5 * t91 + t3 * t100 - t58 - t19 * t107
    t117 = t78 - t19 * t88 - t65 - t3 * t90
    t118 = t57 + (t19 * t98 - (t74 + c5 * t90))
    t119 = c5 * t88 + t3 * t98
    t120 = t115 + t116 * t116 + t117 * t117 + t118 * t118 + t119 * t119

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.sqrt(t120)
    return manipulability.reshape(_leading)


def manipulability_gradient_pose(q):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in lexicographic order: 1253 operations.

    in   q[8]
    out  manipulability (one number)
    out  gradient[8]
    out  inverse_gradient[8]
    out  inverse_root_gradient[8]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q5 = q[..., 4]
    c5 = np.cos(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s4 = np.sin(q4)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s5 = np.sin(q5)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    q7 = q[..., 6]
    s7 = np.sin(q7)
    c7 = np.cos(q7)

    # terms
    t1 = c3 * s4
    t2 = -0.2 * c4 + 0.25 * t1
    t3 = s4 * s5
    t4 = c4 * s5
    t5 = c3 * t4 + c5 * s3
    t6 = c2 * t3 - s2 * t5
    t7 = 0.25 * t5 - -0.2 * t3
    t8 = t1 * s2 + c4 * c2
    t9 = t2 * t6 + t7 * t8
    t10 = c5 * c4
    t11 = c3 * s5 + s3 * t10
    t12 = c5 * s4
    t13 = c3 * t10 - s5 * s3
    t14 = -0.2 * t12 - 0.25 * t13
    t15 = s4 * s3
    t16 = t2 * t11 + t14 * t15
    t17 = s2 * t13 - c2 * t12
    t18 = t8 * t14 + t2 * t17
    t19 = c5 * c3 - t4 * s3
    t20 = t7 * t15 + t2 * t19
    t21 = t9 * t16 - t18 * t20
    t22 = 0.2 * t21
    t23 = t12 * t22
    t24 = s5 * t22
    t25 = c5 * t23 + t3 * t24
    t26 = 0.2 + 0.2 * c6
    t27 = -0.2 * s6
    t28 = t16 * t27
    t29 = t7 * t17 - t6 * t14
    t30 = t18 * t27
    t31 = t14 * t19 - t7 * t11
    t32 = t21 * t26 + t28 * t29 + t30 * t31
    t33 = t12 * t32
    t34 = s5 * t32
    t35 = c5 * t33 + t3 * t34
    t36 = c6 * s7 + s6 * c7
    t37 = s6 * s7 - c6 * c7
    t38 = t27 * t36 + t26 * t37
    t39 = t20 * t38
    t40 = t9 * t38
    t41 = t29 * t39 + t31 * t40
    t42 = t12 * t41
    t43 = s5 * t41
    t44 = c5 * t42 + t3 * t43
    t45 = -0.2 * t30
    t46 = s5 * t45
    t47 = c4 * t46
    t48 = -0.2 * t28
    t49 = s5 * t48
    t50 = c4 * t49
    t51 = c4 * t24 - t19 * t47 + t6 * t50 - c4 * t34
    t52 = t17 * t48 - t11 * t45
    t53 = t12 * t45
    t54 = t12 * t48
    t55 = c4 * t52 - t15 * t53 + t8 * t54
    t56 = t15 * t46 - t8 * t49
    t57 = t51 - c5 * t55 + t3 * t56
    t58 = t25 * t25 + t35 * t35 + t44 * t44 + t57 * t57
    t59 = -0.2 * t39
    t60 = s5 * t59
    t61 = c4 * t60
    t62 = -0.2 * t40
    t63 = s5 * t62
    t64 = c4 * t63
    t65 = c4 * t43
    t66 = t17 * t59 - (t22 * t36 + t11 * t62)
    t67 = t12 * t62
    t68 = t12 * t59
    t69 = c4 * t66 - t23 * t37 - t15 * t67 + t8 * t68
    t70 = t24 * t37 + t15 * t63 - t8 * t60
    t71 = t6 * t61 - t19 * t64 - t65 - c5 * t69 + t3 * t70
    t72 = t27 * t38
    t73 = t29 * t72 + t26 * t40
    t74 = s5 * t73
    t75 = c4 * t74
    t76 = t31 * t72 - t26 * t39
    t77 = s5 * t76
    t78 = c4 * t77
    t79 = t11 * t73 - t32 * t36 + t17 * t76
    t80 = t12 * t73
    t81 = t12 * t76
    t82 = c4 * t79 - t33 * t37 + t15 * t80 + t8 * t81
    t83 = t34 * t37 - t15 * t74 - t8 * t77
    t84 = t19 * t75 + t6 * t78 - t65 - c5 * t82 + t3 * t83
    t85 = t23 + (t6 * t54 - (t33 + t19 * t53)) + t3 * t52
    t86 = t6 * t68 - (t42 + t19 * t67) + t3 * t66
    t87 = t58 + t71 * t71 + t84 * t84 + t85 * t85 + t86 * t86
    t88 = t19 * t80 - t42 + t6 * t81 + t3 * t79
    t89 = 0.2 * t72
    t90 = t36 * t45 + t17 * t89
    t91 = t12 * t89
    t92 = t37 * t53 + c4 * t90 + t8 * t91
    t93 = t36 * t48 + t11 * t89
    t94 = t37 * t54 + t15 * t91 + c4 * t93
    t95 = t37 * t52 + t15 * t90 - t8 * t93
    t96 = t82 - t19 * t92 + t6 * t94 - t69 + t3 * t95
    t97 = t34 + c5 * t52 + t19 * t46 - t6 * t49 - t24
    t98 = t43 + c5 * t66 + t19 * t63 - t6 * t60
    t99 = t87 + t88 * t88 + t96 * t96 + t97 * t97 + t98 * t98
    t100 = t43 + c5 * t79 - t19 * t74 - t6 * t77
    t101 = s5 * t89
    t102 = t37 * t46 + t8 * t101
    t103 = t37 * t49 + t15 * t101
    t104 = t83 + c5 * t95 + t19 * t102 - t6 * t103 - t70
    t105 = t79 - t66 - t19 * t90 + t6 * t93
    t106 = c5 * t53 + t3 * t46
    t107 = t99 + t100 * t100 + t104 * t104 + t105 * t105 + t106 * t106
    t108 = c5 * t67 + t3 * t63
    t109 = c5 * t80 + t3 * t74
    t110 = c4 * t101
    t111 = t64 + (t75 - c5 * t92 - t3 * t102 + t6 * t110)
    t112 = t67 + t80 + t3 * t90 + t6 * t91
    t113 = t107 + t108 * t108 + t109 * t109 + t111 * t111 + t112 * t112
    t114 = c5 * t90 - t74 - t63 - t6 * t101
    t115 = c5 * t54 + t3 * t49
    t116 = c5 * t68 + t3 * t60
    t117 = c5 * t81 + t3 * t77
    t118 = t113 + t114 * t114 + t115 * t115 + t116 * t116 + t117 * t117
    t119 = t78 + c5 * t94 + t3 * t103 - t61 - t19 * t110
    t120 = t81 - t19 * t91 - t68 - t3 * t93
    t121 = t60 + (t19 * t101 - (t77 + c5 * t93))
    t122 = c5 * t91 + t3 * t101
    t123 = t118 + t119 * t119 + t120 * t120 + t121 * t121 + t122 * t122
    t124 = np.sqrt(t123)
    t125 = t114 / t124
    t126 = t112 / t124
    t127 = t105 / t124
    t128 = t104 / t124
    t129 = t96 / t124
    t130 = c5 * t128 + t3 * t129
    t131 = c5 * t125 + t3 * t126 - t19 * t127 + t15 * t130
    t132 = t111 / t124
    t133 = c5 * t132 + t19 * t129
    t134 = t131 - c4 * t133
    t135 = t100 / t124
    t136 = t88 / t124
    t137 = t84 / t124
    t138 = t129 - c5 * t137
    t139 = t127 + c5 * t135 + t3 * t136 + c4 * t138
    t140 = t98 / t124
    t141 = t86 / t124
    t142 = t71 / t124
    t143 = t129 + c5 * t142
    t144 = c5 * t140 - t127 + t3 * t141 - c4 * t143
    t145 = t97 / t124
    t146 = t85 / t124
    t147 = t57 / t124
    t148 = c5 * t147
    t149 = c5 * t145 + t37 * t130 + t3 * t146 - c4 * t148
    t150 = t89 * t134 + t76 * t139 + t59 * t144 + t48 * t149
    t151 = t109 / t124
    t152 = t126 + c5 * t151 + t19 * t136 + t15 * t138
    t153 = t128 + t3 * t137
    t154 = t132 + t19 * t137
    t155 = t3 * t151 - t125 - t19 * t135 - t15 * t153 + c4 * t154
    t156 = t12 * t152 + t11 * t139 + s5 * t155
    t157 = t137 + t142
    t158 = t44 / t124
    t159 = t135 + t140 - c4 * t157 + t3 * t158
    t160 = c5 * t158 - (t136 + t141)
    t161 = s5 * t159 + t12 * t160
    t162 = c4 * t147
    t163 = t35 / t124
    t164 = t145 + t37 * t153 - t162 + t3 * t163
    t165 = c5 * t163 - (t146 + t37 * t138)
    t166 = s5 * t164 - t36 * t139 + t12 * t165
    t167 = t72 * t156 + t39 * t161 + t28 * t166
    t168 = t106 / t124
    t169 = c5 * t168 - t37 * t133 - t19 * t146 + t15 * t148
    t170 = t19 * t128 - t3 * t132
    t171 = t3 * t147
    t172 = t3 * t168 + t37 * t170 + t19 * t145 + t15 * t171
    t173 = t19 * t147
    t174 = t172 - c4 * t173
    t175 = t36 * t134 + t12 * t169 - t11 * t149 + s5 * t174
    t176 = -0.2 * t175 + t31 * t166
    t177 = t3 * t142 - t128
    t178 = t25 / t124
    t179 = t162 + (t37 * t177 - t145) + t3 * t178
    t180 = t146 + t37 * t143 + c5 * t178
    t181 = t26 * t166 + 0.2 * (s5 * t179 - t36 * t144 + t12 * t180)
    t182 = t27 * t176 - t20 * t181
    t183 = t150 + t7 * t167 + t2 * t182
    t184 = t101 * t170 - t93 * t130 - t91 * t133 - t77 * t153
    t185 = t184 + t81 * t138 - t60 * t177 - t68 * t143 - t49 * t171
    t186 = t108 / t124
    t187 = t126 + c5 * t186 - t19 * t141 + t15 * t143
    t188 = t132 - t19 * t142
    t189 = t3 * t186 - t125 + t19 * t140 + t15 * t177 + c4 * t188
    t190 = t26 * t156 + -0.2 * (t12 * t187 - t11 * t144 + s5 * t189)
    t191 = t190 + t31 * t161
    t192 = t38 * t191 + t16 * t181
    t193 = t185 - t54 * t148 + t14 * t182 + t7 * t192
    t194 = t91 * t126 - t101 * t125 + t110 * t132 + t93 * t127
    t195 = t194 - t103 * t128 - t77 * t135 - t60 * t140 - t49 * t145
    t196 = t195 + t94 * t129 + t81 * t136 + t68 * t141 + t54 * t146
    t197 = t196 + t78 * t137 + t61 * t142 + t50 * t147 - t14 * t167
    t198 = t197 + t2 * t192
    t199 = c2 * (t13 * t183 + t1 * t193 - t5 * t198) - s2 * (c4 * t193 - t12 * t183 + t3 * t198)
    t200 = t119 / t124
    t201 = t3 * t200 - t6 * t128
    t202 = c5 * t200 + t6 * t129
    t203 = t101 * t201 + t90 * t130 + t91 * t202 - t74 * t153
    t204 = t203 + t80 * t138 + t63 * t177 + t67 * t143 + t46 * t171
    t205 = t116 / t124
    t206 = t120 / t124
    t207 = c5 * t205 - t206 + t6 * t141 - t8 * t143
    t208 = t121 / t124
    t209 = t6 * t142 - t200
    t210 = t208 + t3 * t205 - t6 * t140 - t8 * t177 + c4 * t209
    t211 = t117 / t124
    t212 = t206 + c5 * t211 + t6 * t136 + t8 * t138
    t213 = t200 + t6 * t137
    t214 = t3 * t211 - t208 - t6 * t135 - t8 * t153 + c4 * t213
    t215 = t12 * t212 + t17 * t139 + s5 * t214
    t216 = -0.2 * (t12 * t207 + t17 * t144 + s5 * t210) - t26 * t215
    t217 = t216 + t29 * t161
    t218 = t38 * t217 - t18 * t181
    t219 = t6 * t127 - (c5 * t208 + t3 * t206) - t8 * t130
    t220 = t219 + c4 * t202
    t221 = t115 / t124
    t222 = c5 * t221 + t37 * t202 + t6 * t146 - t8 * t148
    t223 = t3 * t221 + t37 * t201 - t6 * t145 - t8 * t171
    t224 = t6 * t147
    t225 = t223 + c4 * t224
    t226 = t36 * t220 + t12 * t222 + t17 * t149 + s5 * t225
    t227 = -0.2 * t226 + t29 * t166
    t228 = t27 * t227 + t9 * t181
    t229 = t204 + t53 * t148 + t7 * t218 + t14 * t228
    t230 = t101 * t208 - t91 * t206 - t110 * t200 - t90 * t127
    t231 = t230 + t102 * t128 - t74 * t135 + t63 * t140 + t46 * t145
    t232 = t231 - t92 * t129 + t80 * t136 - t67 * t141 - t53 * t146
    t233 = t72 * t215 + t40 * t161 + t30 * t166
    t234 = t232 + t75 * t137 - t64 * t142 - t47 * t147 + t14 * t233
    t235 = t234 + t2 * t218
    t236 = t19 * t233 - t6 * t167 + t8 * t182 + t15 * t228
    t237 = s2 * t183 - 0.25 * t236
    t238 = t89 * t220 + t73 * t139 - t62 * t144 - t45 * t149
    t239 = t238 - t7 * t233 + t2 * t228
    t240 = s4 * t229 - t4 * t235 - s5 * t237 + t10 * t239
    t241 = t17 * t167 - t11 * t233 + t15 * t218 + t8 * t192
    t242 = 0.25 * t241 - s2 * t198
    t243 = c5 * t235 + t10 * t237 + s5 * t239 + t4 * t242
    t244 = t19 * t218 + t17 * t182 + t11 * t228 + t6 * t192
    t245 = s2 * t193 + 0.25 * t244
    t246 = c3 * (t240 + c5 * t242) - s3 * (t243 + s4 * t245)
    t247 = t122 / t124
    t248 = c5 * t247 - t19 * t206 + t6 * t126 + t15 * t202
    t249 = t248 - t8 * t133
    t250 = t89 * t249 + t76 * t212 + t73 * t152 + t59 * t207
    t251 = t250 + t62 * t187 + t48 * t222 + t45 * t169 + t41 * t160
    t252 = t251 + t32 * t165 + t22 * t180 - c2 * t183 + -0.2 * t236
    t253 = t101 * t247 - t93 * t206 + t103 * t200 + t77 * t211
    t254 = t253 + t60 * t205 + t49 * t221 + t90 * t126 - t102 * t132
    t255 = t254 + t74 * t151 + t63 * t186 + t46 * t168 + t95 * t129
    t256 = t255 + t79 * t136 + t66 * t141 + t52 * t146 + t83 * t137
    t257 = t256 + t70 * t142 + t56 * t147 + t43 * t158 + t34 * t163
    t258 = t257 + t24 * t178 - -0.2 * t241 + c2 * t198
    t259 = s3 * t229 + c5 * t252 + s5 * t258 + c3 * t245
    t260 = t6 * t132 - t19 * t200
    t261 = t101 * t260 + t93 * t202 - t90 * t133 + t79 * t138
    t262 = t261 + t77 * t213 + t74 * t154 - t66 * t143 - t43 * t157
    t263 = t262 + t63 * t188 + t60 * t209 - t52 * t148 - t34 * t147
    t264 = c3 * t237 + s3 * t239
    t265 = t263 + t49 * t224 - t46 * t173 + t24 * t147 + c5 * t264
    t266 = c3 * t242 - s3 * t235
    t267 = s4 * (t265 + c2 * t193 + s5 * t266 + -0.2 * t244)
    t268 = c4 * t259 - t267
    t269 = t3 * t247 + t19 * t208 - t6 * t125 + c4 * t260
    t270 = t269 + t15 * t201 + t8 * t170
    t271 = t89 * t270 + t76 * t214 + t73 * t155 + t62 * t189
    t272 = t271 + t59 * t210 + t48 * t225 + t45 * t174 + t41 * t159
    t273 = t272 + t32 * t164 + t22 * t179 - s3 * t237 + c3 * t239
    t274 = t91 * t247 - t93 * t208 + t94 * t200 + t81 * t211
    t275 = t274 + t68 * t205 + t54 * t221 + t90 * t125 - t92 * t132
    t276 = t275 + t80 * t151 + t67 * t186 + t53 * t168 + t95 * t128
    t277 = t276 + t79 * t135 + t66 * t140 + t52 * t145 - t82 * t137
    t278 = t277 - t69 * t142 - t55 * t147 + t42 * t158 + t33 * t163
    t279 = t278 + t23 * t178 + c3 * t235 + s4 * t252 + c4 * t264
    t280 = c5 * (t273 + c4 * t266 + s4 * t258) - s5 * (t279 + s3 * t242)
    t281 = t49 * t201 + t46 * t170 + t52 * t130 + t54 * t202
    t282 = t281 - t53 * t133 + t34 * t153 - t33 * t138 + t24 * t177
    t283 = s5 * t270 + t11 * t220 + t12 * t249 + t17 * t134
    t284 = 0.2 * t283 + t31 * t215 + t29 * t156
    t285 = t27 * t284 + t9 * t191 + t20 * t217
    t286 = t282 + t23 * t143 + t26 * t285
    t287 = t48 * t220 + t45 * t134 - t32 * t139 - t22 * t144
    t288 = t287 + t27 * t285
    t289 = t38 * t284 + t36 * t285 + t18 * t176 + t16 * t227
    t290 = t40 * t156 - t39 * t215 + t37 * t285 + t21 * t166
    t291 = c6 * (s7 * t286 + c7 * t288 + -0.2 * t289) - s6 * (s7 * t288 - c7 * t286 + 0.2 * t290)
    t292 = c7 * (s6 * t286 + c6 * t288) - s7 * (s6 * t288 - c6 * t286)
    t293 = 1 / t124
    t294 = t293 * t293
    t295 = -0.5 / t124 * np.sqrt(t293)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 8), _real)
    inverse_gradient = np.empty((*_leading, 8), _real)
    inverse_root_gradient = np.empty((*_leading, 8), _real)
    manipulability[..., 0] = t124
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t124 != 0.0, t199, 0.0)
    gradient[..., 2] = np.where(t124 != 0.0, t246, 0.0)
    gradient[..., 3] = np.where(t124 != 0.0, t268, 0.0)
    gradient[..., 4] = np.where(t124 != 0.0, t280, 0.0)
    gradient[..., 5] = np.where(t124 != 0.0, t291, 0.0)
    gradient[..., 6] = np.where(t124 != 0.0, t292, 0.0)
    gradient[..., 7] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t124 != 0.0, -(t199 * t294), 0.0)
    inverse_gradient[..., 2] = np.where(t124 != 0.0, -(t246 * t294), 0.0)
    inverse_gradient[..., 3] = np.where(t124 != 0.0, -(t268 * t294), 0.0)
    inverse_gradient[..., 4] = np.where(t124 != 0.0, -(t280 * t294), 0.0)
    inverse_gradient[..., 5] = np.where(t124 != 0.0, -(t291 * t294), 0.0)
    inverse_gradient[..., 6] = np.where(t124 != 0.0, -(t292 * t294), 0.0)
    inverse_gradient[..., 7] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t124 != 0.0, t199 * t295, 0.0)
    inverse_root_gradient[..., 2] = np.where(t124 != 0.0, t246 * t295, 0.0)
    inverse_root_gradient[..., 3] = np.where(t124 != 0.0, t268 * t295, 0.0)
    inverse_root_gradient[..., 4] = np.where(t124 != 0.0, t280 * t295, 0.0)
    inverse_root_gradient[..., 5] = np.where(t124 != 0.0, t291 * t295, 0.0)
    inverse_root_gradient[..., 6] = np.where(t124 != 0.0, t292 * t295, 0.0)
    inverse_root_gradient[..., 7] = 0.0
    return manipulability.reshape(_leading), gradient.reshape(_leading + (8,)), inverse_gradient.reshape(_leading + (8,)), inverse_root_gradient.reshape(_leading + (8,))


def minors_pose(q):
    """maximal minors of the pose Jacobian, columns in lexicographic order: 376 operations.

    in   q[8]
    out  minors[28]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q5 = q[..., 4]
    c5 = np.cos(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s4 = np.sin(q4)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s5 = np.sin(q5)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    q7 = q[..., 6]
    s7 = np.sin(q7)
    c7 = np.cos(q7)

    # terms
    t1 = c3 * s4
    t2 = -0.2 * c4 + 0.25 * t1
    t3 = s4 * s5
    t4 = c4 * s5
    t5 = c3 * t4 + c5 * s3
    t6 = c2 * t3 - s2 * t5
    t7 = 0.25 * t5 - -0.2 * t3
    t8 = t1 * s2 + c4 * c2
    t9 = t2 * t6 + t7 * t8
    t10 = c5 * c4
    t11 = c3 * s5 + s3 * t10
    t12 = c5 * s4
    t13 = c3 * t10 - s5 * s3
    t14 = -0.2 * t12 - 0.25 * t13
    t15 = s4 * s3
    t16 = t2 * t11 + t14 * t15
    t17 = s2 * t13 - c2 * t12
    t18 = t8 * t14 + t2 * t17
    t19 = c5 * c3 - t4 * s3
    t20 = t7 * t15 + t2 * t19
    t21 = t9 * t16 - t18 * t20
    t22 = 0.2 * t21
    t23 = t12 * t22
    t24 = s5 * t22
    t25 = 0.2 + 0.2 * c6
    t26 = -0.2 * s6
    t27 = t16 * t26
    t28 = t7 * t17 - t6 * t14
    t29 = t18 * t26
    t30 = t14 * t19 - t7 * t11
    t31 = t21 * t25 + t27 * t28 + t29 * t30
    t32 = t12 * t31
    t33 = s5 * t31
    t34 = c6 * s7 + s6 * c7
    t35 = s6 * s7 - c6 * c7
    t36 = t26 * t34 + t25 * t35
    t37 = t20 * t36
    t38 = t9 * t36
    t39 = t28 * t37 + t30 * t38
    t40 = t12 * t39
    t41 = s5 * t39
    t42 = -0.2 * t29
    t43 = s5 * t42
    t44 = -0.2 * t27
    t45 = s5 * t44
    t46 = c4 * t24 - t19 * (c4 * t43) + t6 * (c4 * t45)
    t47 = t17 * t44 - t11 * t42
    t48 = t12 * t42
    t49 = t12 * t44
    t50 = t46 - c4 * t33 - c5 * (c4 * t47 - t15 * t48 + t8 * t49)
    t51 = -0.2 * t37
    t52 = s5 * t51
    t53 = c4 * t52
    t54 = -0.2 * t38
    t55 = s5 * t54
    t56 = c4 * t55
    t57 = c4 * t41
    t58 = t17 * t51 - (t22 * t34 + t11 * t54)
    t59 = t12 * t54
    t60 = t12 * t51
    t61 = c4 * t58 - t23 * t35 - t15 * t59 + t8 * t60
    t62 = t24 * t35 + t15 * t55 - t8 * t52
    t63 = t6 * t53 - t19 * t56 - t57 - c5 * t61 + t3 * t62
    t64 = t26 * t36
    t65 = t28 * t64 + t25 * t38
    t66 = s5 * t65
    t67 = c4 * t66
    t68 = t30 * t64 - t25 * t37
    t69 = s5 * t68
    t70 = c4 * t69
    t71 = t11 * t65 - t31 * t34 + t17 * t68
    t72 = t12 * t65
    t73 = t12 * t68
    t74 = c4 * t71 - t32 * t35 + t15 * t72 + t8 * t73
    t75 = t33 * t35 - t15 * t66 - t8 * t69
    t76 = t19 * t67 + t6 * t70 - t57 - c5 * t74 + t3 * t75
    t77 = t23 + (t6 * t49 - (t32 + t19 * t48)) + t3 * t47
    t78 = -(t6 * t60 - (t40 + t19 * t59) + t3 * t58)
    t79 = -(t19 * t72 - t40 + t6 * t73 + t3 * t71)
    t80 = 0.2 * t64
    t81 = t34 * t42 + t17 * t80
    t82 = t12 * t80
    t83 = t35 * t48 + c4 * t81 + t8 * t82
    t84 = t34 * t44 + t11 * t80
    t85 = t35 * t49 + t15 * t82 + c4 * t84
    t86 = t35 * t47 + t15 * t81 - t8 * t84
    t87 = t74 - t19 * t83 + t6 * t85 - t61 + t3 * t86
    t88 = t33 + c5 * t47 + t19 * t43 - t6 * t45 - t24
    t89 = -(t41 + c5 * t58 + t19 * t55 - t6 * t52)
    t90 = -(t41 + c5 * t71 - t19 * t66 - t6 * t69)
    t91 = s5 * t80
    t92 = t35 * t43 + t8 * t91
    t93 = t35 * t45 + t15 * t91
    t94 = t75 + c5 * t86 + t19 * t92 - t6 * t93 - t62
    t95 = c4 * t91
    t96 = t56 + (t67 - c5 * t83 - t3 * t92 + t6 * t95)
    t97 = t70 + c5 * t85 + t3 * t93 - t53 - t19 * t95

    # results
    minors = np.empty((*_leading, 28), _real)
    minors[..., 0] = c5 * t23 + t3 * t24
    minors[..., 1] = c5 * t32 + t3 * t33
    minors[..., 2] = c5 * t40 + t3 * t41
    minors[..., 3] = -(t50 + t3 * (t15 * t43 - t8 * t45))
    minors[..., 4] = -t63
    minors[..., 5] = -t76
    minors[..., 6] = -t77
    minors[..., 7] = t78
    minors[..., 8] = t79
    minors[..., 9] = -t87
    minors[..., 10] = -t88
    minors[..., 11] = t89
    minors[..., 12] = t90
    minors[..., 13] = -t94
    minors[..., 14] = -(t71 - t58 - t19 * t81 + t6 * t84)
    minors[..., 15] = c5 * t48 + t3 * t43
    minors[..., 16] = c5 * t59 + t3 * t55
    minors[..., 17] = -(c5 * t72 + t3 * t66)
    minors[..., 18] = -t96
    minors[..., 19] = -(t59 + t72 + t3 * t81 + t6 * t82)
    minors[..., 20] = -(c5 * t81 - t66 - t55 - t6 * t91)
    minors[..., 21] = -(c5 * t49 + t3 * t45)
    minors[..., 22] = -(c5 * t60 + t3 * t52)
    minors[..., 23] = -(c5 * t73 + t3 * t69)
    minors[..., 24] = -t97
    minors[..., 25] = -(t73 - t19 * t82 - t60 - t3 * t84)
    minors[..., 26] = -(t52 + (t19 * t91 - (t69 + c5 * t84)))
    minors[..., 27] = c5 * t82 + t3 * t91
    return minors.reshape(_leading + (28,))


def null_projector_pose(q):
    """projector I - J^+ J onto the null space of the pose Jacobian: 1740 operations.

    in   q[8]
    out  null_projector[8][8]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q6 = q[..., 5]
    s6 = np.sin(q6)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s4 = np.sin(q4)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q5 = q[..., 4]
    s5 = np.sin(q5)
    s2 = np.sin(q2)
    c5 = np.cos(q5)
    s3 = np.sin(q3)
    c6 = np.cos(q6)
    q7 = q[..., 6]
    s7 = np.sin(q7)
    c7 = np.cos(q7)

    # terms
    t1 = -0.2 * s6
    t2 = c3 * s4
    t3 = -0.2 * c4 + 0.25 * t2
    t4 = s4 * s5
    t5 = c4 * s5
    t6 = c3 * t5 + c5 * s3
    t7 = c2 * t4 - s2 * t6
    t8 = 0.25 * t6 - -0.2 * t4
    t9 = t2 * s2 + c4 * c2
    t10 = t3 * t7 + t8 * t9
    t11 = s4 * s3
    t12 = c3 * c5 - t5 * s3
    t13 = t8 * t11 + t3 * t12
    t14 = np.sqrt((t1 * t1 + t10 * t10 + t13 * t13))
    t15 = t10 / t14
    t16 = t13 / t14
    t17 = np.where(t14 != 0.0, t1 / t14, 0.0)
    t18 = np.where(t14 != 0.0, np.where(t14 != 0.0, t15 * t15 + t16 * t16, 0.0), 0.0) + t17 * t17
    t19 = np.sqrt(t18)
    t20 = t15 / t19
    t21 = s4 * c5
    t22 = c4 * c5
    t23 = c3 * t22 - s5 * s3
    t24 = -0.2 * t21 - 0.25 * t23
    t25 = s2 * t23 - c2 * t21
    t26 = t9 * t24 + t3 * t25
    t27 = t16 / t19
    t28 = c3 * s5 + s3 * t22
    t29 = t3 * t28 + t11 * t24
    t30 = t20 * t26 + t27 * t29
    t31 = t26 + np.where(t14 != 0.0, np.where(t19 != 0.0, np.where(t14 != 0.0, np.where(t19 != 0.0, -(t20 * t30), 0.0), 0.0), 0.0), 0.0)
    t32 = t29 - np.where(t14 != 0.0, np.where(t19 != 0.0, np.where(t14 != 0.0, np.where(t19 != 0.0, t27 * t30, 0.0), 0.0), 0.0), 0.0)
    t33 = t17 / t19
    t34 = np.where(t19 != 0.0, np.where(t14 != 0.0, np.where(t19 != 0.0, t30 * t33, 0.0), 0.0), 0.0)
    t35 = c6 * s7 + s6 * c7
    t36 = 0.2 + 0.2 * c6
    t37 = s6 * s7 - c6 * c7
    t38 = t1 * t35 + t36 * t37
    t39 = t31 * t31 + t32 * t32 + t34 * t34 + t38 * t38
    t40 = np.sqrt(t39)
    t41 = t31 / t40
    t42 = t32 / t40
    t43 = t34 / t40
    t44 = np.where(t14 != 0.0, np.where(t19 != 0.0, -(t20 * t41 + t27 * t42), 0.0), 0.0) + np.where(t19 != 0.0, t33 * t43, 0.0)
    t45 = np.where(t40 != 0.0, -t41, 0.0) - np.where(t14 != 0.0, np.where(t19 != 0.0, np.where(t40 != 0.0, t20 * t44, 0.0), 0.0), 0.0)
    t46 = np.where(t40 != 0.0, t42, 0.0) - np.where(t14 != 0.0, np.where(t19 != 0.0, np.where(t40 != 0.0, -(t27 * t44), 0.0), 0.0), 0.0)
    t47 = np.where(t40 != 0.0, -t43, 0.0) - np.where(t19 != 0.0, np.where(t40 != 0.0, -(t33 * t44), 0.0), 0.0)
    t48 = t38 / t40
    t49 = t45 * t45 + t46 * t46 + t47 * t47 + np.where(t40 != 0.0, np.where(t40 != 0.0, t48 * t48, 0.0), 0.0)
    t50 = np.sqrt(t49)
    t51 = t45 / t50
    t52 = 1 - np.where(t14 != 0.0, np.where(t19 != 0.0, np.where(t14 != 0.0, np.where(t19 != 0.0, t20 * t20, 0.0), 0.0), 0.0), 0.0) - np.where(t50 != 0.0, np.where(t50 != 0.0, t51 * t51, 0.0), 0.0)
    t53 = t8 * t25 - t7 * t24
    t54 = np.where(t19 != 0.0, -(t33 * t36), 0.0) + np.where(t14 != 0.0, np.where(t19 != 0.0, t20 * t53, 0.0), 0.0)
    t55 = t12 * t24 - t8 * t28
    t56 = t54 + np.where(t14 != 0.0, np.where(t19 != 0.0, -(t27 * t55), 0.0), 0.0)
    t57 = t53 - np.where(t14 != 0.0, np.where(t19 != 0.0, t20 * t56, 0.0), 0.0)
    t58 = t55 - np.where(t14 != 0.0, np.where(t19 != 0.0, -(t27 * t56), 0.0), 0.0)
    t59 = t46 / t50
    t60 = t36 - np.where(t19 != 0.0, -(t33 * t56), 0.0)
    t61 = t47 / t50
    t62 = t51 * t57 + t58 * t59 + t60 * t61
    t63 = t57 - np.where(t50 != 0.0, np.where(t50 != 0.0, t51 * t62, 0.0), 0.0)
    t64 = t58 - np.where(t50 != 0.0, np.where(t50 != 0.0, t59 * t62, 0.0), 0.0)
    t65 = t60 - np.where(t50 != 0.0, np.where(t50 != 0.0, t61 * t62, 0.0), 0.0)
    t66 = t48 / t50
    t67 = np.where(t40 != 0.0, np.where(t50 != 0.0, np.where(t50 != 0.0, -(t62 * t66), 0.0), 0.0), 0.0)
    t68 = 0.04000000000000001 + t63 * t63 + t64 * t64 + t65 * t65 + t67 * t67
    t69 = np.sqrt(t68)
    t70 = t63 / t69
    t71 = t64 / t69
    t72 = t65 / t69
    t73 = np.where(t14 != 0.0, np.where(t19 != 0.0, t20 * t70 - t27 * t71, 0.0), 0.0) + np.where(t19 != 0.0, -(t33 * t72), 0.0)
    t74 = np.where(t69 != 0.0, t70, 0.0) - np.where(t14 != 0.0, np.where(t19 != 0.0, np.where(t69 != 0.0, t20 * t73, 0.0), 0.0), 0.0)
    t75 = np.where(t69 != 0.0, t71, 0.0) - np.where(t14 != 0.0, np.where(t19 != 0.0, np.where(t69 != 0.0, -(t27 * t73), 0.0), 0.0), 0.0)
    t76 = np.where(t69 != 0.0, t72, 0.0) - np.where(t19 != 0.0, np.where(t69 != 0.0, -(t33 * t73), 0.0), 0.0)
    t77 = t67 / t69
    t78 = np.where(t50 != 0.0, t51 * t74 + t59 * t75 + t61 * t76, 0.0) + np.where(t69 != 0.0, np.where(t40 != 0.0, np.where(t50 != 0.0, t66 * t77, 0.0), 0.0), 0.0)
    t79 = t74 - np.where(t50 != 0.0, t51 * t78, 0.0)
    t80 = t75 - np.where(t50 != 0.0, t59 * t78, 0.0)
    t81 = t76 - np.where(t50 != 0.0, t61 * t78, 0.0)
    t82 = np.where(t69 != 0.0, -t77, 0.0) - np.where(t40 != 0.0, np.where(t50 != 0.0, -(t66 * t78), 0.0), 0.0)
    t83 = t79 * t79 + t80 * t80 + t81 * t81 + t82 * t82
    t84 = 0.2 / t69
    t85 = np.sqrt((t83 + np.where(t69 != 0.0, np.where(t69 != 0.0, t84 * t84, 0.0), 0.0)))
    t86 = t79 / t85
    t87 = np.where(t14 != 0.0, np.where(t19 != 0.0, -(t27 * t28), 0.0), 0.0) - np.where(t14 != 0.0, np.where(t19 != 0.0, t20 * t25, 0.0), 0.0)
    t88 = t33 * t87
    t89 = t28 - np.where(t14 != 0.0, np.where(t19 != 0.0, -(t27 * t87), 0.0), 0.0)
    t90 = t25 + np.where(t14 != 0.0, np.where(t19 != 0.0, t20 * t87, 0.0), 0.0)
    t91 = t59 * t89 - t51 * t90 - np.where(t19 != 0.0, -(t61 * t88), 0.0)
    t92 = np.where(t50 != 0.0, t91, 0.0) + np.where(t40 != 0.0, np.where(t50 != 0.0, t35 * t66, 0.0), 0.0)
    t93 = np.where(t19 != 0.0, -t88, 0.0) + np.where(t50 != 0.0, t61 * t92, 0.0)
    t94 = t89 - np.where(t50 != 0.0, t59 * t92, 0.0)
    t95 = t80 / t85
    t96 = t90 + np.where(t50 != 0.0, t51 * t92, 0.0)
    t97 = t81 / t85
    t98 = t35 + np.where(t40 != 0.0, np.where(t50 != 0.0, -(t66 * t92), 0.0), 0.0)
    t99 = t82 / t85
    t100 = t94 * t95 - t86 * t96 - t93 * t97 - t98 * t99
    t101 = t93 + np.where(t85 != 0.0, np.where(t85 != 0.0, t97 * t100, 0.0), 0.0)
    t102 = t98 + np.where(t85 != 0.0, np.where(t85 != 0.0, t99 * t100, 0.0), 0.0)
    t103 = t96 + np.where(t85 != 0.0, np.where(t85 != 0.0, t86 * t100, 0.0), 0.0)
    t104 = t94 - np.where(t85 != 0.0, np.where(t85 != 0.0, t95 * t100, 0.0), 0.0)
    t105 = t101 * t101 + t102 * t102 + t103 * t103 + t104 * t104
    t106 = t84 / t85
    t107 = np.where(t69 != 0.0, np.where(t85 != 0.0, np.where(t85 != 0.0, t100 * t106, 0.0), 0.0), 0.0)
    t108 = np.sqrt((t105 + t107 * t107 + s5 * s5 + t21 * t21))
    t109 = t101 / t108
    t110 = t103 / t108
    t111 = t104 / t108
    t112 = np.where(t14 != 0.0, np.where(t19 != 0.0, -(t20 * t110 + t27 * t111), 0.0), 0.0) + np.where(t19 != 0.0, t33 * t109, 0.0)
    t113 = np.where(t108 != 0.0, -t109, 0.0) - np.where(t19 != 0.0, np.where(t108 != 0.0, -(t33 * t112), 0.0), 0.0)
    t114 = np.where(t108 != 0.0, -t110, 0.0) - np.where(t14 != 0.0, np.where(t19 != 0.0, np.where(t108 != 0.0, t20 * t112, 0.0), 0.0), 0.0)
    t115 = np.where(t108 != 0.0, t111, 0.0) - np.where(t14 != 0.0, np.where(t19 != 0.0, np.where(t108 != 0.0, -(t27 * t112), 0.0), 0.0), 0.0)
    t116 = t102 / t108
    t117 = np.where(t50 != 0.0, t51 * t114 + t59 * t115 + t61 * t113, 0.0) + np.where(t108 != 0.0, np.where(t40 != 0.0, np.where(t50 != 0.0, t66 * t116, 0.0), 0.0), 0.0)
    t118 = t113 - np.where(t50 != 0.0, t61 * t117, 0.0)
    t119 = t114 - np.where(t50 != 0.0, t51 * t117, 0.0)
    t120 = t115 - np.where(t50 != 0.0, t59 * t117, 0.0)
    t121 = np.where(t108 != 0.0, -t116, 0.0) - np.where(t40 != 0.0, np.where(t50 != 0.0, -(t66 * t117), 0.0), 0.0)
    t122 = t86 * t119 + t95 * t120 + t97 * t118 + t99 * t121
    t123 = t107 / t108
    t124 = np.where(t85 != 0.0, t122, 0.0) + np.where(t108 != 0.0, np.where(t69 != 0.0, np.where(t85 != 0.0, -(t106 * t123), 0.0), 0.0), 0.0)
    t125 = t118 - np.where(t85 != 0.0, t97 * t124, 0.0)
    t126 = t121 - np.where(t85 != 0.0, t99 * t124, 0.0)
    t127 = t119 - np.where(t85 != 0.0, t86 * t124, 0.0)
    t128 = t120 - np.where(t85 != 0.0, t95 * t124, 0.0)
    t129 = t125 * t125 + t126 * t126 + t127 * t127 + t128 * t128
    t130 = np.where(t108 != 0.0, -t123, 0.0) - np.where(t69 != 0.0, np.where(t85 != 0.0, t106 * t124, 0.0), 0.0)
    t131 = t21 / t108
    t132 = np.where(t108 != 0.0, s5 / t108, 0.0)
    t133 = t129 + t130 * t130 + np.where(t108 != 0.0, np.where(t108 != 0.0, t131 * t131, 0.0), 0.0) + t132 * t132
    t134 = np.sqrt(t133)
    t135 = t127 / t134
    t136 = t52 - np.where(t85 != 0.0, np.where(t85 != 0.0, t86 * t86, 0.0), 0.0) - np.where(t134 != 0.0, np.where(t134 != 0.0, t135 * t135, 0.0), 0.0)
    t137 = np.where(t19 != 0.0, -t33, 0.0) + np.where(t14 != 0.0, np.where(t19 != 0.0, -(t12 * t27), 0.0), 0.0)
    t138 = t137 - np.where(t14 != 0.0, np.where(t19 != 0.0, t7 * t20, 0.0), 0.0)
    t139 = t7 + np.where(t14 != 0.0, np.where(t19 != 0.0, t20 * t138, 0.0), 0.0)
    t140 = t12 - np.where(t14 != 0.0, np.where(t19 != 0.0, -(t27 * t138), 0.0), 0.0)
    t141 = 1 - np.where(t19 != 0.0, -(t33 * t138), 0.0)
    t142 = t59 * t140 - t51 * t139 + t61 * t141
    t143 = t139 + np.where(t50 != 0.0, np.where(t50 != 0.0, t51 * t142, 0.0), 0.0)
    t144 = t140 - np.where(t50 != 0.0, np.where(t50 != 0.0, t59 * t142, 0.0), 0.0)
    t145 = np.where(t69 != 0.0, np.where(t85 != 0.0, t106, 0.0), 0.0) + np.where(t85 != 0.0, -(t86 * t143), 0.0) + np.where(t85 != 0.0, t95 * t144, 0.0)
    t146 = t141 - np.where(t50 != 0.0, np.where(t50 != 0.0, t61 * t142, 0.0), 0.0)
    t147 = t66 * t142
    t148 = np.where(t85 != 0.0, -np.where(t40 != 0.0, np.where(t50 != 0.0, np.where(t50 != 0.0, -(t99 * t147), 0.0), 0.0), 0.0), 0.0)
    t149 = t145 + np.where(t85 != 0.0, t97 * t146, 0.0) + t148
    t150 = t143 + np.where(t85 != 0.0, t86 * t149, 0.0)
    t151 = t146 - np.where(t85 != 0.0, t97 * t149, 0.0)
    t152 = t125 / t134
    t153 = np.where(t40 != 0.0, np.where(t50 != 0.0, np.where(t50 != 0.0, -t147, 0.0), 0.0), 0.0) + np.where(t85 != 0.0, t99 * t149, 0.0)
    t154 = t126 / t134
    t155 = t144 - np.where(t85 != 0.0, t95 * t149, 0.0)
    t156 = t128 / t134
    t157 = t151 * t152 - t153 * t154 - t135 * t150 + t155 * t156
    t158 = 1 - np.where(t69 != 0.0, np.where(t85 != 0.0, t106 * t149, 0.0), 0.0)
    t159 = t130 / t134
    t160 = t131 / t134
    t161 = np.where(t134 != 0.0, t157 + t158 * t159, 0.0) + np.where(t108 != 0.0, np.where(t134 != 0.0, -(t4 * t160), 0.0), 0.0)
    t162 = t132 / t134
    t163 = t161 - np.where(t134 != 0.0, -(c5 * t162), 0.0)
    t164 = t150 + np.where(t134 != 0.0, t135 * t163, 0.0)
    t165 = t155 - np.where(t134 != 0.0, t156 * t163, 0.0)
    t166 = t4 + np.where(t108 != 0.0, np.where(t134 != 0.0, t160 * t163, 0.0), 0.0)
    t167 = c5 + np.where(t134 != 0.0, -(t162 * t163), 0.0)
    t168 = t164 * t164 + t165 * t165 + t166 * t166 + t167 * t167
    t169 = t158 - np.where(t134 != 0.0, t159 * t163, 0.0)
    t170 = t151 - np.where(t134 != 0.0, t152 * t163, 0.0)
    t171 = t153 + np.where(t134 != 0.0, t154 * t163, 0.0)
    t172 = np.sqrt((t168 + t169 * t169 + t170 * t170 + t171 * t171))
    t173 = t164 / t172
    t174 = t165 / t172
    t175 = t170 / t172
    t176 = np.where(t14 != 0.0, np.where(t19 != 0.0, -(t20 * t173 + t27 * t174), 0.0), 0.0) + np.where(t19 != 0.0, -(t33 * t175), 0.0)
    t177 = np.where(t172 != 0.0, -t173, 0.0) - np.where(t14 != 0.0, np.where(t19 != 0.0, np.where(t172 != 0.0, t20 * t176, 0.0), 0.0), 0.0)
    t178 = np.where(t172 != 0.0, t174, 0.0) - np.where(t14 != 0.0, np.where(t19 != 0.0, np.where(t172 != 0.0, -(t27 * t176), 0.0), 0.0), 0.0)
    t179 = np.where(t172 != 0.0, t175, 0.0) - np.where(t19 != 0.0, np.where(t172 != 0.0, -(t33 * t176), 0.0), 0.0)
    t180 = t171 / t172
    t181 = np.where(t50 != 0.0, t51 * t177 + t59 * t178 + t61 * t179, 0.0) + np.where(t172 != 0.0, np.where(t40 != 0.0, np.where(t50 != 0.0, t66 * t180, 0.0), 0.0), 0.0)
    t182 = t177 - np.where(t50 != 0.0, t51 * t181, 0.0)
    t183 = t178 - np.where(t50 != 0.0, t59 * t181, 0.0)
    t184 = t179 - np.where(t50 != 0.0, t61 * t181, 0.0)
    t185 = np.where(t172 != 0.0, -t180, 0.0) - np.where(t40 != 0.0, np.where(t50 != 0.0, -(t66 * t181), 0.0), 0.0)
    t186 = t86 * t182 + t95 * t183 + t97 * t184 + t99 * t185
    t187 = t169 / t172
    t188 = np.where(t85 != 0.0, t186, 0.0) + np.where(t172 != 0.0, np.where(t69 != 0.0, np.where(t85 != 0.0, t106 * t187, 0.0), 0.0), 0.0)
    t189 = t182 - np.where(t85 != 0.0, t86 * t188, 0.0)
    t190 = t184 - np.where(t85 != 0.0, t97 * t188, 0.0)
    t191 = t185 - np.where(t85 != 0.0, t99 * t188, 0.0)
    t192 = t183 - np.where(t85 != 0.0, t95 * t188, 0.0)
    t193 = t152 * t190 + t154 * t191 + t135 * t189 + t156 * t192
    t194 = np.where(t172 != 0.0, t187, 0.0) - np.where(t69 != 0.0, np.where(t85 != 0.0, t106 * t188, 0.0), 0.0)
    t195 = t166 / t172
    t196 = np.where(t134 != 0.0, t193 + t159 * t194, 0.0) + np.where(t172 != 0.0, np.where(t108 != 0.0, np.where(t134 != 0.0, -(t160 * t195), 0.0), 0.0), 0.0)
    t197 = t167 / t172
    t198 = t196 + np.where(t172 != 0.0, np.where(t134 != 0.0, t162 * t197, 0.0), 0.0)
    t199 = t189 - np.where(t134 != 0.0, t135 * t198, 0.0)
    t200 = t192 - np.where(t134 != 0.0, t156 * t198, 0.0)
    t201 = np.where(t172 != 0.0, -t195, 0.0) - np.where(t108 != 0.0, np.where(t134 != 0.0, t160 * t198, 0.0), 0.0)
    t202 = np.where(t172 != 0.0, -t197, 0.0) - np.where(t134 != 0.0, -(t162 * t198), 0.0)
    t203 = t199 * t199 + t200 * t200 + t201 * t201 + t202 * t202
    t204 = t194 - np.where(t134 != 0.0, t159 * t198, 0.0)
    t205 = t190 - np.where(t134 != 0.0, t152 * t198, 0.0)
    t206 = t191 - np.where(t134 != 0.0, t154 * t198, 0.0)
    t207 = np.sqrt((t203 + t204 * t204 + t205 * t205 + t206 * t206))
    t208 = t199 / t207
    t209 = np.where(t14 != 0.0, np.where(t19 != 0.0, t11 * t27, 0.0), 0.0) - np.where(t14 != 0.0, np.where(t19 != 0.0, -(t9 * t20), 0.0), 0.0)
    t210 = t9 - np.where(t14 != 0.0, np.where(t19 != 0.0, t20 * t209, 0.0), 0.0)
    t211 = t11 + np.where(t14 != 0.0, np.where(t19 != 0.0, -(t27 * t209), 0.0), 0.0)
    t212 = t33 * t209
    t213 = t51 * t210 - t59 * t211 - np.where(t19 != 0.0, -(t61 * t212), 0.0)
    t214 = np.where(t50 != 0.0, t213, 0.0) + np.where(t40 != 0.0, np.where(t50 != 0.0, -(t37 * t66), 0.0), 0.0)
    t215 = t210 - np.where(t50 != 0.0, t51 * t214, 0.0)
    t216 = t211 + np.where(t50 != 0.0, t59 * t214, 0.0)
    t217 = np.where(t19 != 0.0, -t212, 0.0) + np.where(t50 != 0.0, t61 * t214, 0.0)
    t218 = t37 - np.where(t40 != 0.0, np.where(t50 != 0.0, -(t66 * t214), 0.0), 0.0)
    t219 = t86 * t215 - t95 * t216 - t97 * t217 + t99 * t218
    t220 = t215 - np.where(t85 != 0.0, np.where(t85 != 0.0, t86 * t219, 0.0), 0.0)
    t221 = t217 + np.where(t85 != 0.0, np.where(t85 != 0.0, t97 * t219, 0.0), 0.0)
    t222 = np.where(t108 != 0.0, np.where(t134 != 0.0, c4 * t160, 0.0), 0.0) + np.where(t134 != 0.0, -(t152 * t221), 0.0)
    t223 = t218 - np.where(t85 != 0.0, np.where(t85 != 0.0, t99 * t219, 0.0), 0.0)
    t224 = t216 + np.where(t85 != 0.0, np.where(t85 != 0.0, t95 * t219, 0.0), 0.0)
    t225 = t222 + np.where(t134 != 0.0, t154 * t223, 0.0) + np.where(t134 != 0.0, t135 * t220, 0.0) + np.where(t134 != 0.0, -(t156 * t224), 0.0)
    t226 = t106 * t219
    t227 = t225 + np.where(t134 != 0.0, -np.where(t69 != 0.0, np.where(t85 != 0.0, np.where(t85 != 0.0, t159 * t226, 0.0), 0.0), 0.0), 0.0)
    t228 = t220 - np.where(t134 != 0.0, t135 * t227, 0.0)
    t229 = t224 + np.where(t134 != 0.0, t156 * t227, 0.0)
    t230 = t200 / t207
    t231 = c4 - np.where(t108 != 0.0, np.where(t134 != 0.0, t160 * t227, 0.0), 0.0)
    t232 = t201 / t207
    t233 = t162 * t227
    t234 = t202 / t207
    t235 = t208 * t228 - t229 * t230 + t231 * t232 - np.where(t134 != 0.0, -(t233 * t234), 0.0)
    t236 = np.where(t69 != 0.0, np.where(t85 != 0.0, np.where(t85 != 0.0, t226, 0.0), 0.0), 0.0) + np.where(t134 != 0.0, t159 * t227, 0.0)
    t237 = t204 / t207
    t238 = t221 + np.where(t134 != 0.0, t152 * t227, 0.0)
    t239 = t205 / t207
    t240 = t223 - np.where(t134 != 0.0, t154 * t227, 0.0)
    t241 = t206 / t207
    t242 = t235 - t236 * t237 - t238 * t239 + t240 * t241
    t243 = t228 - np.where(t207 != 0.0, np.where(t207 != 0.0, t208 * t242, 0.0), 0.0)
    t244 = t229 + np.where(t207 != 0.0, np.where(t207 != 0.0, t230 * t242, 0.0), 0.0)
    t245 = t231 - np.where(t207 != 0.0, np.where(t207 != 0.0, t232 * t242, 0.0), 0.0)
    t246 = np.where(t134 != 0.0, -t233, 0.0) + np.where(t207 != 0.0, np.where(t207 != 0.0, t234 * t242, 0.0), 0.0)
    t247 = 1 + t243 * t243 + t244 * t244 + t245 * t245 + t246 * t246
    t248 = t236 + np.where(t207 != 0.0, np.where(t207 != 0.0, t237 * t242, 0.0), 0.0)
    t249 = t238 + np.where(t207 != 0.0, np.where(t207 != 0.0, t239 * t242, 0.0), 0.0)
    t250 = t240 - np.where(t207 != 0.0, np.where(t207 != 0.0, t241 * t242, 0.0), 0.0)
    t251 = np.sqrt((t247 + t248 * t248 + t249 * t249 + t250 * t250))
    t252 = 1 / t251
    t253 = t243 / t251
    t254 = t244 / t251
    t255 = t249 / t251
    t256 = np.where(t14 != 0.0, np.where(t19 != 0.0, t20 * t253 + t27 * t254, 0.0), 0.0) + np.where(t19 != 0.0, t33 * t255, 0.0)
    t257 = np.where(t251 != 0.0, t253, 0.0) - np.where(t14 != 0.0, np.where(t19 != 0.0, np.where(t251 != 0.0, t20 * t256, 0.0), 0.0), 0.0)
    t258 = np.where(t251 != 0.0, -t254, 0.0) - np.where(t14 != 0.0, np.where(t19 != 0.0, np.where(t251 != 0.0, -(t27 * t256), 0.0), 0.0), 0.0)
    t259 = np.where(t251 != 0.0, -t255, 0.0) - np.where(t19 != 0.0, np.where(t251 != 0.0, -(t33 * t256), 0.0), 0.0)
    t260 = t250 / t251
    t261 = np.where(t50 != 0.0, t51 * t257 + t59 * t258 + t61 * t259, 0.0) + np.where(t251 != 0.0, np.where(t40 != 0.0, np.where(t50 != 0.0, -(t66 * t260), 0.0), 0.0), 0.0)
    t262 = t257 - np.where(t50 != 0.0, t51 * t261, 0.0)
    t263 = t258 - np.where(t50 != 0.0, t59 * t261, 0.0)
    t264 = t259 - np.where(t50 != 0.0, t61 * t261, 0.0)
    t265 = np.where(t251 != 0.0, t260, 0.0) - np.where(t40 != 0.0, np.where(t50 != 0.0, -(t66 * t261), 0.0), 0.0)
    t266 = t86 * t262 + t95 * t263 + t97 * t264 + t99 * t265
    t267 = t248 / t251
    t268 = np.where(t85 != 0.0, t266, 0.0) + np.where(t251 != 0.0, np.where(t69 != 0.0, np.where(t85 != 0.0, -(t106 * t267), 0.0), 0.0), 0.0)
    t269 = t262 - np.where(t85 != 0.0, t86 * t268, 0.0)
    t270 = t264 - np.where(t85 != 0.0, t97 * t268, 0.0)
    t271 = t265 - np.where(t85 != 0.0, t99 * t268, 0.0)
    t272 = t263 - np.where(t85 != 0.0, t95 * t268, 0.0)
    t273 = t152 * t270 + t154 * t271 + t135 * t269 + t156 * t272
    t274 = np.where(t251 != 0.0, -t267, 0.0) - np.where(t69 != 0.0, np.where(t85 != 0.0, t106 * t268, 0.0), 0.0)
    t275 = t245 / t251
    t276 = np.where(t134 != 0.0, t273 + t159 * t274, 0.0) + np.where(t251 != 0.0, np.where(t108 != 0.0, np.where(t134 != 0.0, t160 * t275, 0.0), 0.0), 0.0)
    t277 = t246 / t251
    t278 = t276 + np.where(t251 != 0.0, np.where(t134 != 0.0, t162 * t277, 0.0), 0.0)
    t279 = t269 - np.where(t134 != 0.0, t135 * t278, 0.0)
    t280 = t272 - np.where(t134 != 0.0, t156 * t278, 0.0)
    t281 = np.where(t251 != 0.0, t275, 0.0) - np.where(t108 != 0.0, np.where(t134 != 0.0, t160 * t278, 0.0), 0.0)
    t282 = np.where(t251 != 0.0, -t277, 0.0) - np.where(t134 != 0.0, -(t162 * t278), 0.0)
    t283 = t208 * t279 + t230 * t280 + t232 * t281 + t234 * t282
    t284 = t274 - np.where(t134 != 0.0, t159 * t278, 0.0)
    t285 = t270 - np.where(t134 != 0.0, t152 * t278, 0.0)
    t286 = t271 - np.where(t134 != 0.0, t154 * t278, 0.0)
    t287 = t283 + t237 * t284 + t239 * t285 + t241 * t286
    t288 = t279 - np.where(t207 != 0.0, np.where(t207 != 0.0, t208 * t287, 0.0), 0.0)
    t289 = t280 - np.where(t207 != 0.0, np.where(t207 != 0.0, t230 * t287, 0.0), 0.0)
    t290 = np.where(t251 != 0.0, np.where(t251 != 0.0, t252 * t252, 0.0), 0.0) + t288 * t288 + t289 * t289
    t291 = t281 - np.where(t207 != 0.0, np.where(t207 != 0.0, t232 * t287, 0.0), 0.0)
    t292 = t282 - np.where(t207 != 0.0, np.where(t207 != 0.0, t234 * t287, 0.0), 0.0)
    t293 = t284 - np.where(t207 != 0.0, np.where(t207 != 0.0, t237 * t287, 0.0), 0.0)
    t294 = t285 - np.where(t207 != 0.0, np.where(t207 != 0.0, t239 * t287, 0.0), 0.0)
    t295 = t290 + t291 * t291 + t292 * t292 + t293 * t293 + t294 * t294
    t296 = t286 - np.where(t207 != 0.0, np.where(t207 != 0.0, t241 * t287, 0.0), 0.0)
    t297 = np.sqrt((t295 + t296 * t296))
    t298 = t288 / t297
    t299 = t136 - np.where(t207 != 0.0, np.where(t207 != 0.0, t208 * t208, 0.0), 0.0) - np.where(t297 != 0.0, np.where(t297 != 0.0, t298 * t298, 0.0), 0.0)
    t300 = np.where(t14 != 0.0, np.where(t19 != 0.0, np.where(t14 != 0.0, np.where(t19 != 0.0, -(t20 * t27), 0.0), 0.0), 0.0), 0.0) + np.where(t50 != 0.0, np.where(t50 != 0.0, t51 * t59, 0.0), 0.0)
    t301 = t300 + np.where(t85 != 0.0, np.where(t85 != 0.0, t86 * t95, 0.0), 0.0) + np.where(t134 != 0.0, np.where(t134 != 0.0, t135 * t156, 0.0), 0.0)
    t302 = t289 / t297
    t303 = t301 + np.where(t207 != 0.0, np.where(t207 != 0.0, t208 * t230, 0.0), 0.0) + np.where(t297 != 0.0, np.where(t297 != 0.0, t298 * t302, 0.0), 0.0)
    t304 = -t303
    t305 = np.where(t108 != 0.0, np.where(t134 != 0.0, np.where(t134 != 0.0, t135 * t160, 0.0), 0.0), 0.0) + np.where(t207 != 0.0, np.where(t207 != 0.0, t208 * t232, 0.0), 0.0)
    t306 = t291 / t297
    t307 = -(t305 + np.where(t297 != 0.0, np.where(t297 != 0.0, t298 * t306, 0.0), 0.0))
    t308 = np.where(t134 != 0.0, np.where(t134 != 0.0, -(t135 * t162), 0.0), 0.0) + np.where(t207 != 0.0, np.where(t207 != 0.0, t208 * t234, 0.0), 0.0)
    t309 = t292 / t297
    t310 = -(t308 + np.where(t297 != 0.0, np.where(t297 != 0.0, t298 * t309, 0.0), 0.0))
    t311 = t252 / t297
    t312 = -np.where(t297 != 0.0, np.where(t251 != 0.0, np.where(t297 != 0.0, t298 * t311, 0.0), 0.0), 0.0)
    t313 = np.where(t69 != 0.0, np.where(t85 != 0.0, np.where(t85 != 0.0, t86 * t106, 0.0), 0.0), 0.0) + np.where(t134 != 0.0, np.where(t134 != 0.0, t135 * t159, 0.0), 0.0)
    t314 = t293 / t297
    t315 = t313 + np.where(t207 != 0.0, np.where(t207 != 0.0, t208 * t237, 0.0), 0.0) + np.where(t297 != 0.0, np.where(t297 != 0.0, t298 * t314, 0.0), 0.0)
    t316 = -t315
    t317 = np.where(t19 != 0.0, np.where(t14 != 0.0, np.where(t19 != 0.0, -(t20 * t33), 0.0), 0.0), 0.0) + np.where(t50 != 0.0, np.where(t50 != 0.0, t51 * t61, 0.0), 0.0)
    t318 = t317 + np.where(t85 != 0.0, np.where(t85 != 0.0, t86 * t97, 0.0), 0.0) + np.where(t134 != 0.0, np.where(t134 != 0.0, t135 * t152, 0.0), 0.0)
    t319 = t294 / t297
    t320 = t318 + np.where(t207 != 0.0, np.where(t207 != 0.0, t208 * t239, 0.0), 0.0) + np.where(t297 != 0.0, np.where(t297 != 0.0, t298 * t319, 0.0), 0.0)
    t321 = -t320
    t322 = np.where(t40 != 0.0, np.where(t50 != 0.0, np.where(t50 != 0.0, -(t51 * t66), 0.0), 0.0), 0.0) + np.where(t85 != 0.0, np.where(t85 != 0.0, t86 * t99, 0.0), 0.0)
    t323 = t322 + np.where(t134 != 0.0, np.where(t134 != 0.0, t135 * t154, 0.0), 0.0) + np.where(t207 != 0.0, np.where(t207 != 0.0, t208 * t241, 0.0), 0.0)
    t324 = t296 / t297
    t325 = -(t323 + np.where(t297 != 0.0, np.where(t297 != 0.0, t298 * t324, 0.0), 0.0))
    t326 = 1 - np.where(t14 != 0.0, np.where(t19 != 0.0, np.where(t14 != 0.0, np.where(t19 != 0.0, t27 * t27, 0.0), 0.0), 0.0), 0.0) - np.where(t50 != 0.0, np.where(t50 != 0.0, t59 * t59, 0.0), 0.0)
    t327 = t326 - np.where(t85 != 0.0, np.where(t85 != 0.0, t95 * t95, 0.0), 0.0) - np.where(t134 != 0.0, np.where(t134 != 0.0, t156 * t156, 0.0), 0.0)
    t328 = t327 - np.where(t207 != 0.0, np.where(t207 != 0.0, t230 * t230, 0.0), 0.0) - np.where(t297 != 0.0, np.where(t297 != 0.0, t302 * t302, 0.0), 0.0)
    t329 = np.where(t108 != 0.0, np.where(t134 != 0.0, np.where(t134 != 0.0, t156 * t160, 0.0), 0.0), 0.0) + np.where(t207 != 0.0, np.where(t207 != 0.0, t230 * t232, 0.0), 0.0)
    t330 = -(t329 + np.where(t297 != 0.0, np.where(t297 != 0.0, t302 * t306, 0.0), 0.0))
    t331 = np.where(t134 != 0.0, np.where(t134 != 0.0, -(t156 * t162), 0.0), 0.0) + np.where(t207 != 0.0, np.where(t207 != 0.0, t230 * t234, 0.0), 0.0)
    t332 = -(t331 + np.where(t297 != 0.0, np.where(t297 != 0.0, t302 * t309, 0.0), 0.0))
    t333 = -np.where(t297 != 0.0, np.where(t251 != 0.0, np.where(t297 != 0.0, t302 * t311, 0.0), 0.0), 0.0)
    t334 = np.where(t69 != 0.0, np.where(t85 != 0.0, np.where(t85 != 0.0, t95 * t106, 0.0), 0.0), 0.0) + np.where(t134 != 0.0, np.where(t134 != 0.0, t156 * t159, 0.0), 0.0)
    t335 = t334 + np.where(t207 != 0.0, np.where(t207 != 0.0, t230 * t237, 0.0), 0.0) + np.where(t297 != 0.0, np.where(t297 != 0.0, t302 * t314, 0.0), 0.0)
    t336 = -t335
    t337 = np.where(t19 != 0.0, np.where(t14 != 0.0, np.where(t19 != 0.0, t27 * t33, 0.0), 0.0), 0.0) + np.where(t50 != 0.0, np.where(t50 != 0.0, t59 * t61, 0.0), 0.0)
    t338 = t337 + np.where(t85 != 0.0, np.where(t85 != 0.0, t95 * t97, 0.0), 0.0) + np.where(t134 != 0.0, np.where(t134 != 0.0, t152 * t156, 0.0), 0.0)
    t339 = t338 + np.where(t207 != 0.0, np.where(t207 != 0.0, t230 * t239, 0.0), 0.0) + np.where(t297 != 0.0, np.where(t297 != 0.0, t302 * t319, 0.0), 0.0)
    t340 = -t339
    t341 = np.where(t40 != 0.0, np.where(t50 != 0.0, np.where(t50 != 0.0, -(t59 * t66), 0.0), 0.0), 0.0) + np.where(t85 != 0.0, np.where(t85 != 0.0, t95 * t99, 0.0), 0.0)
    t342 = t341 + np.where(t134 != 0.0, np.where(t134 != 0.0, t154 * t156, 0.0), 0.0) + np.where(t207 != 0.0, np.where(t207 != 0.0, t230 * t241, 0.0), 0.0)
    t343 = -(t342 + np.where(t297 != 0.0, np.where(t297 != 0.0, t302 * t324, 0.0), 0.0))
    t344 = 1 - np.where(t108 != 0.0, np.where(t134 != 0.0, np.where(t108 != 0.0, np.where(t134 != 0.0, t160 * t160, 0.0), 0.0), 0.0), 0.0) - np.where(t207 != 0.0, np.where(t207 != 0.0, t232 * t232, 0.0), 0.0)
    t345 = np.where(t134 != 0.0, np.where(t108 != 0.0, np.where(t134 != 0.0, -(t160 * t162), 0.0), 0.0), 0.0) + np.where(t207 != 0.0, np.where(t207 != 0.0, t232 * t234, 0.0), 0.0)
    t346 = -(t345 + np.where(t297 != 0.0, np.where(t297 != 0.0, t306 * t309, 0.0), 0.0))
    t347 = -np.where(t297 != 0.0, np.where(t251 != 0.0, np.where(t297 != 0.0, t306 * t311, 0.0), 0.0), 0.0)
    t348 = np.where(t134 != 0.0, np.where(t108 != 0.0, np.where(t134 != 0.0, t159 * t160, 0.0), 0.0), 0.0) + np.where(t207 != 0.0, np.where(t207 != 0.0, t232 * t237, 0.0), 0.0)
    t349 = -(t348 + np.where(t297 != 0.0, np.where(t297 != 0.0, t306 * t314, 0.0), 0.0))
    t350 = np.where(t134 != 0.0, np.where(t108 != 0.0, np.where(t134 != 0.0, t152 * t160, 0.0), 0.0), 0.0) + np.where(t207 != 0.0, np.where(t207 != 0.0, t232 * t239, 0.0), 0.0)
    t351 = -(t350 + np.where(t297 != 0.0, np.where(t297 != 0.0, t306 * t319, 0.0), 0.0))
    t352 = np.where(t134 != 0.0, np.where(t108 != 0.0, np.where(t134 != 0.0, t154 * t160, 0.0), 0.0), 0.0) + np.where(t207 != 0.0, np.where(t207 != 0.0, t232 * t241, 0.0), 0.0)
    t353 = -(t352 + np.where(t297 != 0.0, np.where(t297 != 0.0, t306 * t324, 0.0), 0.0))
    t354 = 1 - np.where(t134 != 0.0, np.where(t134 != 0.0, t162 * t162, 0.0), 0.0) - np.where(t207 != 0.0, np.where(t207 != 0.0, t234 * t234, 0.0), 0.0)
    t355 = -np.where(t297 != 0.0, np.where(t251 != 0.0, np.where(t297 != 0.0, t309 * t311, 0.0), 0.0), 0.0)
    t356 = np.where(t134 != 0.0, np.where(t134 != 0.0, -(t159 * t162), 0.0), 0.0) + np.where(t207 != 0.0, np.where(t207 != 0.0, t234 * t237, 0.0), 0.0)
    t357 = -(t356 + np.where(t297 != 0.0, np.where(t297 != 0.0, t309 * t314, 0.0), 0.0))
    t358 = np.where(t134 != 0.0, np.where(t134 != 0.0, -(t152 * t162), 0.0), 0.0) + np.where(t207 != 0.0, np.where(t207 != 0.0, t234 * t239, 0.0), 0.0)
    t359 = -(t358 + np.where(t297 != 0.0, np.where(t297 != 0.0, t309 * t319, 0.0), 0.0))
    t360 = np.where(t134 != 0.0, np.where(t134 != 0.0, -(t154 * t162), 0.0), 0.0) + np.where(t207 != 0.0, np.where(t207 != 0.0, t234 * t241, 0.0), 0.0)
    t361 = -(t360 + np.where(t297 != 0.0, np.where(t297 != 0.0, t309 * t324, 0.0), 0.0))
    t362 = -np.where(t297 != 0.0, np.where(t297 != 0.0, np.where(t251 != 0.0, t311 * t314, 0.0), 0.0), 0.0)
    t363 = -np.where(t297 != 0.0, np.where(t297 != 0.0, np.where(t251 != 0.0, t311 * t319, 0.0), 0.0), 0.0)
    t364 = -np.where(t297 != 0.0, np.where(t297 != 0.0, np.where(t251 != 0.0, t311 * t324, 0.0), 0.0), 0.0)
    t365 = 1 - np.where(t69 != 0.0, np.where(t85 != 0.0, np.where(t69 != 0.0, np.where(t85 != 0.0, t106 * t106, 0.0), 0.0), 0.0), 0.0) - np.where(t134 != 0.0, np.where(t134 != 0.0, t159 * t159, 0.0), 0.0)
    t366 = t365 - np.where(t207 != 0.0, np.where(t207 != 0.0, t237 * t237, 0.0), 0.0) - np.where(t297 != 0.0, np.where(t297 != 0.0, t314 * t314, 0.0), 0.0)
    t367 = np.where(t85 != 0.0, np.where(t69 != 0.0, np.where(t85 != 0.0, t97 * t106, 0.0), 0.0), 0.0) + np.where(t134 != 0.0, np.where(t134 != 0.0, t152 * t159, 0.0), 0.0)
    t368 = t367 + np.where(t207 != 0.0, np.where(t207 != 0.0, t237 * t239, 0.0), 0.0) + np.where(t297 != 0.0, np.where(t297 != 0.0, t314 * t319, 0.0), 0.0)
    t369 = -t368
    t370 = np.where(t85 != 0.0, np.where(t69 != 0.0, np.where(t85 != 0.0, t99 * t106, 0.0), 0.0), 0.0) + np.where(t134 != 0.0, np.where(t134 != 0.0, t154 * t159, 0.0), 0.0)
    t371 = t370 + np.where(t207 != 0.0, np.where(t207 != 0.0, t237 * t241, 0.0), 0.0) + np.where(t297 != 0.0, np.where(t297 != 0.0, t314 * t324, 0.0), 0.0)
    t372 = -t371
    t373 = 1 - np.where(t19 != 0.0, np.where(t19 != 0.0, t33 * t33, 0.0), 0.0) - np.where(t50 != 0.0, np.where(t50 != 0.0, t61 * t61, 0.0), 0.0)
    t374 = t373 - np.where(t85 != 0.0, np.where(t85 != 0.0, t97 * t97, 0.0), 0.0) - np.where(t134 != 0.0, np.where(t134 != 0.0, t152 * t152, 0.0), 0.0)
    t375 = t374 - np.where(t207 != 0.0, np.where(t207 != 0.0, t239 * t239, 0.0), 0.0) - np.where(t297 != 0.0, np.where(t297 != 0.0, t319 * t319, 0.0), 0.0)
    t376 = np.where(t40 != 0.0, np.where(t50 != 0.0, np.where(t50 != 0.0, -(t61 * t66), 0.0), 0.0), 0.0) + np.where(t85 != 0.0, np.where(t85 != 0.0, t97 * t99, 0.0), 0.0)
    t377 = t376 + np.where(t134 != 0.0, np.where(t134 != 0.0, t152 * t154, 0.0), 0.0) + np.where(t207 != 0.0, np.where(t207 != 0.0, t239 * t241, 0.0), 0.0)
    t378 = -(t377 + np.where(t297 != 0.0, np.where(t297 != 0.0, t319 * t324, 0.0), 0.0))
    t379 = 1 - np.where(t40 != 0.0, np.where(t50 != 0.0, np.where(t40 != 0.0, np.where(t50 != 0.0, t66 * t66, 0.0), 0.0), 0.0), 0.0) - np.where(t85 != 0.0, np.where(t85 != 0.0, t99 * t99, 0.0), 0.0)
    t380 = t379 - np.where(t134 != 0.0, np.where(t134 != 0.0, t154 * t154, 0.0), 0.0) - np.where(t207 != 0.0, np.where(t207 != 0.0, t241 * t241, 0.0), 0.0)

    # results
    null_projector = np.empty((*_leading, 64), _real)
    null_projector[..., 0] = t299
    null_projector[..., 1] = t304
    null_projector[..., 2] = t307
    null_projector[..., 3] = t310
    null_projector[..., 4] = t312
    null_projector[..., 5] = t316
    null_projector[..., 6] = t321
    null_projector[..., 7] = t325
    null_projector[..., 8] = t304
    null_projector[..., 9] = t328
    null_projector[..., 10] = t330
    null_projector[..., 11] = t332
    null_projector[..., 12] = t333
    null_projector[..., 13] = t336
    null_projector[..., 14] = t340
    null_projector[..., 15] = t343
    null_projector[..., 16] = t307
    null_projector[..., 17] = t330
    null_projector[..., 18] = t344 - np.where(t297 != 0.0, np.where(t297 != 0.0, t306 * t306, 0.0), 0.0)
    null_projector[..., 19] = t346
    null_projector[..., 20] = t347
    null_projector[..., 21] = t349
    null_projector[..., 22] = t351
    null_projector[..., 23] = t353
    null_projector[..., 24] = t310
    null_projector[..., 25] = t332
    null_projector[..., 26] = t346
    null_projector[..., 27] = t354 - np.where(t297 != 0.0, np.where(t297 != 0.0, t309 * t309, 0.0), 0.0)
    null_projector[..., 28] = t355
    null_projector[..., 29] = t357
    null_projector[..., 30] = t359
    null_projector[..., 31] = t361
    null_projector[..., 32] = t312
    null_projector[..., 33] = t333
    null_projector[..., 34] = t347
    null_projector[..., 35] = t355
    null_projector[..., 36] = 1 - np.where(t297 != 0.0, np.where(t251 != 0.0, np.where(t297 != 0.0, np.where(t251 != 0.0, t311 * t311, 0.0), 0.0), 0.0), 0.0)
    null_projector[..., 37] = t362
    null_projector[..., 38] = t363
    null_projector[..., 39] = t364
    null_projector[..., 40] = t316
    null_projector[..., 41] = t336
    null_projector[..., 42] = t349
    null_projector[..., 43] = t357
    null_projector[..., 44] = t362
    null_projector[..., 45] = t366
    null_projector[..., 46] = t369
    null_projector[..., 47] = t372
    null_projector[..., 48] = t321
    null_projector[..., 49] = t340
    null_projector[..., 50] = t351
    null_projector[..., 51] = t359
    null_projector[..., 52] = t363
    null_projector[..., 53] = t369
    null_projector[..., 54] = t375
    null_projector[..., 55] = t378
    null_projector[..., 56] = t325
    null_projector[..., 57] = t343
    null_projector[..., 58] = t353
    null_projector[..., 59] = t361
    null_projector[..., 60] = t364
    null_projector[..., 61] = t372
    null_projector[..., 62] = t378
    null_projector[..., 63] = t380 - np.where(t297 != 0.0, np.where(t297 != 0.0, t324 * t324, 0.0), 0.0)
    return null_projector.reshape(_leading + (8, 8))
