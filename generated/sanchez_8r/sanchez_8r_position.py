"""manipulability (position) of sanchez_8r, in NumPy.

Made from templates/kernel.py.j2; inputs eeb6e159f30e282be02ccef25caa4195473462c7ef4cbbe95e0e7e7759cff87a.
1893 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_position(q):
    """manipulability H = sqrt(det(J J^T)) of the position Jacobian: 306 operations.

    in   q[8]
    out  manipulability (one number)
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q7 = q[..., 6]
    c7 = np.cos(q7)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    s7 = np.sin(q7)
    q4 = q[..., 3]
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    s5 = np.sin(q5)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s2 = np.sin(q2)

    # terms
    t1 = -0.2 * c7
    t2 = c7 * c6 - s6 * s7
    t3 = t1 - 0.2 * t2
    t4 = t2 * c5
    t5 = c6 * s7 + c7 * s6
    t6 = s4 * t4 - c4 * t5
    t7 = t4 * c4 + s4 * t5
    t8 = t2 * s5
    t9 = c3 * t7 - s3 * t8
    t10 = t3 - 0.2 * t6 - 0.25 * t9
    t11 = s4 * s5
    t12 = c4 * s5
    t13 = c3 * t12 + c5 * s3
    t14 = c2 * t11 - s2 * t13
    t15 = 0.25 * t13 - -0.2 * t11
    t16 = t9 * s2 - t6 * c2
    t17 = t10 * t14 - t15 * t16
    t18 = c5 * t5
    t19 = t2 * s4 - c4 * t18
    t20 = t5 * s5
    t21 = s3 * t19 - c3 * t20
    t22 = 0.2 * s7
    t23 = t22 + 0.2 * t5
    t24 = s4 * t18 + t2 * c4
    t25 = c3 * t19 + s3 * t20
    t26 = 0.125 - (t23 + 0.2 * t24 - 0.25 * t25)
    t27 = c3 * t8 + t7 * s3
    t28 = t10 * t21 + t26 * t27
    t29 = s2 * t25 + c2 * t24
    t30 = t10 * t29 + t16 * t26
    t31 = c5 * c3 - s3 * t12
    t32 = t15 * t27 - t10 * t31
    t33 = t17 * t28 + t30 * t32
    t34 = 0.125 - t23
    t35 = t11 * t34
    t36 = t6 * t34 - t3 * t24
    t37 = t3 * t11
    t38 = t32 * t36 - t28 * t37
    t39 = t15 * t29 + t14 * t26
    t40 = t17 * t36 + t30 * t37
    t41 = t15 * t21 + t26 * t31
    t42 = t33 * t35 + t38 * t39 + t40 * t41
    t43 = c5 * t34
    t44 = t3 * t20 - t8 * t34
    t45 = t3 * c5
    t46 = t32 * t44 - t28 * t45
    t47 = t17 * t44 + t30 * t45
    t48 = t33 * t43 + t39 * t46 + t41 * t47
    t49 = t2 * t3 + t5 * t34
    t50 = t32 * t49
    t51 = t17 * t49
    t52 = t39 * t50 + t41 * t51
    t53 = t1 * t28
    t54 = 0.125 - t22
    t55 = t1 * t30
    t56 = t39 * t53 - t33 * t54 - t41 * t55
    t57 = t42 * t42 + t48 * t48 + t52 * t52 + t56 * t56
    t58 = -0.125 * t33
    t59 = t37 * t44 - t36 * t45
    t60 = t40 * t43 + t39 * t59 - t35 * t47
    t61 = t37 * t49
    t62 = t35 * t51 - t39 * t61
    t63 = t1 * t36
    t64 = t39 * t63 - t40 * t54 + t35 * t55
    t65 = t57 + t58 * t58 + t60 * t60 + t62 * t62 + t64 * t64
    t66 = -0.125 * t40
    t67 = t45 * t49
    t68 = t43 * t51 - t39 * t67
    t69 = t1 * t44
    t70 = t39 * t69 - t47 * t54 + t43 * t55
    t71 = -0.125 * t47
    t72 = t65 + t66 * t66 + t68 * t68 + t70 * t70 + t71 * t71
    t73 = t1 * t49
    t74 = t51 * t54 - t39 * t73
    t75 = -0.125 * t51
    t76 = -0.125 * t55
    t77 = t38 * t43 - t41 * t59 - t35 * t46
    t78 = t72 + t74 * t74 + t75 * t75 + t76 * t76 + t77 * t77
    t79 = t41 * t61 + t35 * t50
    t80 = t41 * t63 + t38 * t54 + t35 * t53
    t81 = -0.125 * t38
    t82 = t41 * t67 + t43 * t50
    t83 = t78 + t79 * t79 + t80 * t80 + t81 * t81 + t82 * t82
    t84 = t41 * t69 + t46 * t54 + t43 * t53
    t85 = -0.125 * t46
    t86 = t41 * t73 + t50 * t54
    t87 = -0.125 * t50
    t88 = t83 + t84 * t84 + t85 * t85 + t86 * t86 + t87 * t87
    t89 = -0.125 * t53
    t90 = t43 * t61 - t35 * t67
    t91 = t35 * t69 - t54 * t59 - t43 * t63
    t92 = -0.125 * t59
    t93 = t88 + t89 * t89 + t90 * t90 + t91 * t91 + t92 * t92
    t94 = t54 * t61 - t35 * t73
    t95 = -0.125 * t61
    t96 = -0.125 * t63
    t97 = t54 * t67 - t43 * t73
    t98 = t93 + t94 * t94 + t95 * t95 + t96 * t96 + t97 * t97
    t99 = -0.125 * t67
    t100 = -0.125 * t69
    t101 = -0.125 * t73
    t102 = np.sqrt((t98 + t99 * t99 + t100 * t100 + t101 * t101))

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = t102
    return manipulability.reshape(_leading)


def manipulability_gradient_position(q):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in lexicographic order: 909 operations.

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
    q7 = q[..., 6]
    c7 = np.cos(q7)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    s7 = np.sin(q7)
    q4 = q[..., 3]
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    s5 = np.sin(q5)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s2 = np.sin(q2)

    # terms
    t1 = -0.2 * c7
    t2 = c7 * c6 - s6 * s7
    t3 = t1 - 0.2 * t2
    t4 = t2 * c5
    t5 = c6 * s7 + c7 * s6
    t6 = s4 * t4 - c4 * t5
    t7 = t4 * c4 + s4 * t5
    t8 = t2 * s5
    t9 = c3 * t7 - s3 * t8
    t10 = t3 - 0.2 * t6 - 0.25 * t9
    t11 = s4 * s5
    t12 = c4 * s5
    t13 = c3 * t12 + c5 * s3
    t14 = c2 * t11 - s2 * t13
    t15 = 0.25 * t13 - -0.2 * t11
    t16 = t9 * s2 - t6 * c2
    t17 = t10 * t14 - t15 * t16
    t18 = c5 * t5
    t19 = t2 * s4 - c4 * t18
    t20 = t5 * s5
    t21 = s3 * t19 - c3 * t20
    t22 = 0.2 * s7
    t23 = t22 + 0.2 * t5
    t24 = s4 * t18 + t2 * c4
    t25 = c3 * t19 + s3 * t20
    t26 = 0.125 - (t23 + 0.2 * t24 - 0.25 * t25)
    t27 = c3 * t8 + t7 * s3
    t28 = t10 * t21 + t26 * t27
    t29 = s2 * t25 + c2 * t24
    t30 = t10 * t29 + t16 * t26
    t31 = c5 * c3 - s3 * t12
    t32 = t15 * t27 - t10 * t31
    t33 = t17 * t28 + t30 * t32
    t34 = 0.125 - t23
    t35 = t11 * t34
    t36 = t6 * t34 - t3 * t24
    t37 = t3 * t11
    t38 = t32 * t36 - t28 * t37
    t39 = t15 * t29 + t14 * t26
    t40 = t17 * t36 + t30 * t37
    t41 = t15 * t21 + t26 * t31
    t42 = t33 * t35 + t38 * t39 + t40 * t41
    t43 = c5 * t34
    t44 = t3 * t20 - t8 * t34
    t45 = t3 * c5
    t46 = t32 * t44 - t28 * t45
    t47 = t17 * t44 + t30 * t45
    t48 = t33 * t43 + t39 * t46 + t41 * t47
    t49 = t2 * t3 + t5 * t34
    t50 = t32 * t49
    t51 = t17 * t49
    t52 = t39 * t50 + t41 * t51
    t53 = t1 * t28
    t54 = 0.125 - t22
    t55 = t1 * t30
    t56 = t39 * t53 - t33 * t54 - t41 * t55
    t57 = t42 * t42 + t48 * t48 + t52 * t52 + t56 * t56
    t58 = -0.125 * t33
    t59 = t37 * t44 - t36 * t45
    t60 = t40 * t43 + t39 * t59 - t35 * t47
    t61 = t37 * t49
    t62 = t35 * t51 - t39 * t61
    t63 = t1 * t36
    t64 = t39 * t63 - t40 * t54 + t35 * t55
    t65 = t57 + t58 * t58 + t60 * t60 + t62 * t62 + t64 * t64
    t66 = -0.125 * t40
    t67 = t45 * t49
    t68 = t43 * t51 - t39 * t67
    t69 = t1 * t44
    t70 = t39 * t69 - t47 * t54 + t43 * t55
    t71 = -0.125 * t47
    t72 = t65 + t66 * t66 + t68 * t68 + t70 * t70 + t71 * t71
    t73 = t1 * t49
    t74 = t51 * t54 - t39 * t73
    t75 = -0.125 * t51
    t76 = -0.125 * t55
    t77 = t38 * t43 - t41 * t59 - t35 * t46
    t78 = t72 + t74 * t74 + t75 * t75 + t76 * t76 + t77 * t77
    t79 = t41 * t61 + t35 * t50
    t80 = t41 * t63 + t38 * t54 + t35 * t53
    t81 = -0.125 * t38
    t82 = t41 * t67 + t43 * t50
    t83 = t78 + t79 * t79 + t80 * t80 + t81 * t81 + t82 * t82
    t84 = t41 * t69 + t46 * t54 + t43 * t53
    t85 = -0.125 * t46
    t86 = t41 * t73 + t50 * t54
    t87 = -0.125 * t50
    t88 = t83 + t84 * t84 + t85 * t85 + t86 * t86 + t87 * t87
    t89 = -0.125 * t53
    t90 = t43 * t61 - t35 * t67
    t91 = t35 * t69 - t54 * t59 - t43 * t63
    t92 = -0.125 * t59
    t93 = t88 + t89 * t89 + t90 * t90 + t91 * t91 + t92 * t92
    t94 = t54 * t61 - t35 * t73
    t95 = -0.125 * t61
    t96 = -0.125 * t63
    t97 = t54 * t67 - t43 * t73
    t98 = t93 + t94 * t94 + t95 * t95 + t96 * t96 + t97 * t97
    t99 = -0.125 * t67
    t100 = -0.125 * t69
    t101 = -0.125 * t73
    t102 = np.sqrt((t98 + t99 * t99 + t100 * t100 + t101 * t101))
    t103 = t70 / t102
    t104 = t74 / t102
    t105 = t68 / t102
    t106 = t64 / t102
    t107 = t69 * t103 - t73 * t104 - t67 * t105 + t63 * t106
    t108 = t62 / t102
    t109 = t60 / t102
    t110 = t56 / t102
    t111 = t52 / t102
    t112 = t107 - t61 * t108 + t59 * t109 + t53 * t110 + t50 * t111
    t113 = t48 / t102
    t114 = t42 / t102
    t115 = t112 + t46 * t113 + t38 * t114
    t116 = -0.125 * (t76 / t102) + t43 * t103 + t35 * t106 - t41 * t110
    t117 = -0.125 * (t71 / t102) - t54 * t103 - t35 * t109 + t41 * t113
    t118 = -0.125 * (t66 / t102) - t54 * t106 + t43 * t109 + t41 * t114
    t119 = -0.125 * (t58 / t102) - t54 * t110 + t43 * t113 + t35 * t114
    t120 = t1 * t116 + t45 * t117 + t37 * t118 + t32 * t119
    t121 = t15 * t115 + t10 * t120
    t122 = -0.125 * (t75 / t102) + t54 * t104 + t43 * t105 + t35 * t108
    t123 = t122 + t41 * t111
    t124 = t49 * t123 + t44 * t117 + t36 * t118 + t28 * t119
    t125 = t26 * t120 - t15 * t124
    t126 = t26 * t115 + t10 * t124
    t127 = c2 * (t25 * t121 + t9 * t125 - t13 * t126) - s2 * (t24 * t121 - t6 * t125 + t11 * t126)
    t128 = t86 / t102
    t129 = t82 / t102
    t130 = t79 / t102
    t131 = -0.125 * (t87 / t102) + t54 * t128 + t43 * t129 + t35 * t130
    t132 = t131 + t39 * t111
    t133 = t84 / t102
    t134 = t77 / t102
    t135 = -0.125 * (t85 / t102) + t54 * t133 - t35 * t134 + t39 * t113
    t136 = t80 / t102
    t137 = -0.125 * (t81 / t102) + t54 * t136 + t43 * t134 + t39 * t114
    t138 = t49 * t132 + t44 * t135 + t36 * t137 + t30 * t119
    t139 = -0.125 * (t89 / t102) + t43 * t133 + t35 * t136 + t39 * t110
    t140 = t1 * t139 - t45 * t135 - t37 * t137 + t17 * t119
    t141 = t15 * t138 + t26 * t140
    t142 = t73 * t128 + t69 * t133 + t67 * t129 + t63 * t136
    t143 = t142 + t61 * t130 - t59 * t134 - t55 * t110 + t51 * t111
    t144 = t143 + t47 * t113 + t40 * t114
    t145 = t26 * t144 - t10 * t138
    t146 = t31 * t144 + t14 * t115 + t16 * t120 + t27 * t140
    t147 = s2 * t121 + 0.25 * t146
    t148 = t15 * t144 + t10 * t140
    t149 = t7 * t141 - t12 * t145 + t20 * t147 + t19 * t148
    t150 = t21 * t144 + t29 * t115 + t27 * t138 - t16 * t124
    t151 = 0.25 * t150 - s2 * t126
    t152 = t29 * t120 - t31 * t138 + t21 * t140 + t14 * t124
    t153 = s2 * t125 - 0.25 * t152
    t154 = c5 * t145 + t8 * t141 + t19 * t147 - t20 * t148
    t155 = c3 * (t149 + c5 * t151 - t8 * t153) - s3 * (t154 + t12 * t151 + t7 * t153)
    t156 = t91 / t102
    t157 = -0.125 * (t96 / t102) - t43 * t156 + t41 * t136 + t39 * t106
    t158 = -0.125 * (t92 / t102) - t54 * t156 - t41 * t134 + t39 * t109
    t159 = t1 * t157 - t45 * t158 + t17 * t118 + t32 * t137
    t160 = c2 * t121 - t3 * t159 - 0.2 * t146
    t161 = c3 * t147 + s3 * t148
    t162 = t94 / t102
    t163 = t90 / t102
    t164 = -0.125 * (t95 / t102) + t54 * t162 + t43 * t163 + t41 * t130
    t165 = t164 - t39 * t108
    t166 = t49 * t165 + t44 * t158 + t30 * t118 - t28 * t137
    t167 = t69 * t156 - t73 * t162 - t67 * t163 + t53 * t136
    t168 = t167 + t50 * t130 - t46 * t134 + t55 * t106 + t51 * t108
    t169 = t168 - t47 * t109 + t33 * t114
    t170 = t3 * t166 + t34 * t169 - -0.2 * t150 + c2 * t126
    t171 = s3 * t141 + c3 * t153
    t172 = t18 * t160 + t2 * t161 + s5 * t170 + t5 * t171
    t173 = t34 * t159 - c2 * t125 - 0.2 * t152
    t174 = c3 * t151 - s3 * t145
    t175 = t2 * t160 - t18 * t161 + s5 * t174 + t4 * t171
    t176 = c4 * (t172 + t4 * t173) - s4 * (t175 - t5 * t173)
    t177 = -0.125 * (t100 / t102) + t35 * t156 + t41 * t133 + t39 * t103
    t178 = t1 * t177 + t37 * t158 + t17 * t117 + t32 * t135
    t179 = t3 * t178 + s3 * t147 - c3 * t148
    t180 = c3 * t141 - t34 * t178 - s3 * t153
    t181 = t5 * t179 + c4 * t174 + s4 * t170 + t2 * t180
    t182 = t97 / t102
    t183 = -0.125 * (t99 / t102) + t54 * t182 - t35 * t163 + t41 * t129
    t184 = t183 - t39 * t105
    t185 = t49 * t184 - t36 * t158 + t30 * t117 - t28 * t135
    t186 = t61 * t163 - (t73 * t182 + t63 * t156) + t53 * t133
    t187 = t186 + t50 * t129 + t38 * t134 + t55 * t103 + t51 * t105
    t188 = t187 + t40 * t109 + t33 * t113
    t189 = s4 * t160 - c4 * t161
    t190 = t3 * t185 + t34 * t188 + c3 * t145 + t5 * t189
    t191 = c4 * t171 + s4 * t173
    t192 = c5 * t181 - s5 * (t190 + s3 * t151 + t2 * t191)
    t193 = -0.125 * (t101 / t102) - t43 * t182 - t35 * t162 + t41 * t128
    t194 = t193 - t39 * t104
    t195 = t1 * t194 + t45 * t184 + t37 * t165 + t17 * t123
    t196 = t195 + t32 * t132
    t197 = t5 * t196 - t8 * t178 + c5 * t188 + t6 * t159
    t198 = t146 + (t197 + t11 * t169)
    t199 = s5 * t179 - 0.2 * t198 + c5 * t189
    t200 = t34 * t196 + s4 * t171 - c4 * t173
    t201 = t3 * t196 + c4 * t160 + s4 * t161 + s5 * t180
    t202 = t2 * t196 + c5 * t185 + t20 * t178 + t11 * t166
    t203 = t152 + (t202 - t24 * t159)
    t204 = t201 + c5 * t191 - 0.2 * t203
    t205 = c6 * (c7 * t199 + c7 * t200 - s7 * t204) - s6 * (s7 * t199 + s7 * t200 + c7 * t204)
    t206 = t67 * t182 + t61 * t162 - t59 * t156 + t50 * t128
    t207 = t206 + t46 * t133 + t38 * t136 + t51 * t104 - t47 * t103
    t208 = c6 * t199 - 0.2 * (t198 + (t207 - t40 * t106 - t33 * t110))
    t209 = t49 * t194 + t44 * t177 + t36 * t157 + t30 * t116
    t210 = s6 * t199 + s6 * t200 + c6 * t204 + -0.2 * (t203 + (t209 + t28 * t139))
    t211 = c7 * (t208 + c6 * t200 - s6 * t204) - s7 * t210
    t212 = 1 / t102
    t213 = t212 * t212
    t214 = -0.5 / t102 * np.sqrt(t212)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 8), _real)
    inverse_gradient = np.empty((*_leading, 8), _real)
    inverse_root_gradient = np.empty((*_leading, 8), _real)
    manipulability[..., 0] = t102
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t102 != 0.0, t127, 0.0)
    gradient[..., 2] = np.where(t102 != 0.0, t155, 0.0)
    gradient[..., 3] = np.where(t102 != 0.0, t176, 0.0)
    gradient[..., 4] = np.where(t102 != 0.0, t192, 0.0)
    gradient[..., 5] = np.where(t102 != 0.0, t205, 0.0)
    gradient[..., 6] = np.where(t102 != 0.0, t211, 0.0)
    gradient[..., 7] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t102 != 0.0, -(t127 * t213), 0.0)
    inverse_gradient[..., 2] = np.where(t102 != 0.0, -(t155 * t213), 0.0)
    inverse_gradient[..., 3] = np.where(t102 != 0.0, -(t176 * t213), 0.0)
    inverse_gradient[..., 4] = np.where(t102 != 0.0, -(t192 * t213), 0.0)
    inverse_gradient[..., 5] = np.where(t102 != 0.0, -(t205 * t213), 0.0)
    inverse_gradient[..., 6] = np.where(t102 != 0.0, -(t211 * t213), 0.0)
    inverse_gradient[..., 7] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t102 != 0.0, t127 * t214, 0.0)
    inverse_root_gradient[..., 2] = np.where(t102 != 0.0, t155 * t214, 0.0)
    inverse_root_gradient[..., 3] = np.where(t102 != 0.0, t176 * t214, 0.0)
    inverse_root_gradient[..., 4] = np.where(t102 != 0.0, t192 * t214, 0.0)
    inverse_root_gradient[..., 5] = np.where(t102 != 0.0, t205 * t214, 0.0)
    inverse_root_gradient[..., 6] = np.where(t102 != 0.0, t211 * t214, 0.0)
    inverse_root_gradient[..., 7] = 0.0
    return manipulability.reshape(_leading), gradient.reshape(_leading + (8,)), inverse_gradient.reshape(_leading + (8,)), inverse_root_gradient.reshape(_leading + (8,))


def minors_position(q):
    """maximal minors of the position Jacobian, columns in lexicographic order: 245 operations.

    in   q[8]
    out  minors[56]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q7 = q[..., 6]
    c7 = np.cos(q7)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    s7 = np.sin(q7)
    q4 = q[..., 3]
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    s5 = np.sin(q5)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s2 = np.sin(q2)

    # terms
    t1 = -0.2 * c7
    t2 = c7 * c6 - s6 * s7
    t3 = t1 - 0.2 * t2
    t4 = t2 * c5
    t5 = c6 * s7 + c7 * s6
    t6 = s4 * t4 - c4 * t5
    t7 = t4 * c4 + s4 * t5
    t8 = t2 * s5
    t9 = c3 * t7 - s3 * t8
    t10 = t3 - 0.2 * t6 - 0.25 * t9
    t11 = s4 * s5
    t12 = c4 * s5
    t13 = c3 * t12 + c5 * s3
    t14 = c2 * t11 - s2 * t13
    t15 = 0.25 * t13 - -0.2 * t11
    t16 = t9 * s2 - t6 * c2
    t17 = t10 * t14 - t15 * t16
    t18 = c5 * t5
    t19 = t2 * s4 - c4 * t18
    t20 = t5 * s5
    t21 = s3 * t19 - c3 * t20
    t22 = 0.2 * s7
    t23 = t22 + 0.2 * t5
    t24 = s4 * t18 + t2 * c4
    t25 = c3 * t19 + s3 * t20
    t26 = 0.125 - (t23 + 0.2 * t24 - 0.25 * t25)
    t27 = c3 * t8 + t7 * s3
    t28 = t10 * t21 + t26 * t27
    t29 = s2 * t25 + c2 * t24
    t30 = t10 * t29 + t16 * t26
    t31 = c5 * c3 - s3 * t12
    t32 = t15 * t27 - t10 * t31
    t33 = t17 * t28 + t30 * t32
    t34 = 0.125 - t23
    t35 = t11 * t34
    t36 = t6 * t34 - t3 * t24
    t37 = t3 * t11
    t38 = t32 * t36 - t28 * t37
    t39 = t15 * t29 + t14 * t26
    t40 = t17 * t36 + t30 * t37
    t41 = t15 * t21 + t26 * t31
    t42 = c5 * t34
    t43 = t3 * t20 - t8 * t34
    t44 = t3 * c5
    t45 = t32 * t43 - t28 * t44
    t46 = t17 * t43 + t30 * t44
    t47 = t2 * t3 + t5 * t34
    t48 = t32 * t47
    t49 = t17 * t47
    t50 = t1 * t28
    t51 = 0.125 - t22
    t52 = t1 * t30
    t53 = t37 * t43 - t36 * t44
    t54 = t37 * t47
    t55 = t1 * t36
    t56 = t44 * t47
    t57 = t1 * t43
    t58 = t1 * t47

    # results
    minors = np.empty((*_leading, 56), _real)
    minors[..., 0] = t33 * t35 + t38 * t39 + t40 * t41
    minors[..., 1] = t33 * t42 + t39 * t45 + t41 * t46
    minors[..., 2] = -(t39 * t48 + t41 * t49)
    minors[..., 3] = t39 * t50 - t33 * t51 - t41 * t52
    minors[..., 4] = -0.125 * t33
    minors[..., 5] = 0.0
    minors[..., 6] = t40 * t42 + t39 * t53 - t35 * t46
    minors[..., 7] = t35 * t49 - t39 * t54
    minors[..., 8] = t39 * t55 - t40 * t51 + t35 * t52
    minors[..., 9] = -0.125 * t40
    minors[..., 10] = 0.0
    minors[..., 11] = t42 * t49 - t39 * t56
    minors[..., 12] = t39 * t57 - t46 * t51 + t42 * t52
    minors[..., 13] = -0.125 * t46
    minors[..., 14] = 0.0
    minors[..., 15] = t49 * t51 - t39 * t58
    minors[..., 16] = -(-0.125 * t49)
    minors[..., 17] = 0.0
    minors[..., 18] = -(-0.125 * t52)
    minors[..., 19] = 0.0
    minors[..., 20] = 0.0
    minors[..., 21] = t38 * t42 - t41 * t53 - t35 * t45
    minors[..., 22] = t41 * t54 + t35 * t48
    minors[..., 23] = -(t41 * t55 + t38 * t51 + t35 * t50)
    minors[..., 24] = -0.125 * t38
    minors[..., 25] = 0.0
    minors[..., 26] = t41 * t56 + t42 * t48
    minors[..., 27] = -(t41 * t57 + t45 * t51 + t42 * t50)
    minors[..., 28] = -0.125 * t45
    minors[..., 29] = 0.0
    minors[..., 30] = t41 * t58 + t48 * t51
    minors[..., 31] = -(-0.125 * t48)
    minors[..., 32] = 0.0
    minors[..., 33] = -0.125 * t50
    minors[..., 34] = 0.0
    minors[..., 35] = 0.0
    minors[..., 36] = t42 * t54 - t35 * t56
    minors[..., 37] = t35 * t57 - t51 * t53 - t42 * t55
    minors[..., 38] = -0.125 * t53
    minors[..., 39] = 0.0
    minors[..., 40] = t51 * t54 - t35 * t58
    minors[..., 41] = -(-0.125 * t54)
    minors[..., 42] = 0.0
    minors[..., 43] = -0.125 * t55
    minors[..., 44] = 0.0
    minors[..., 45] = 0.0
    minors[..., 46] = t51 * t56 - t42 * t58
    minors[..., 47] = -(-0.125 * t56)
    minors[..., 48] = 0.0
    minors[..., 49] = -0.125 * t57
    minors[..., 50] = 0.0
    minors[..., 51] = 0.0
    minors[..., 52] = -(-0.125 * t58)
    minors[..., 53] = 0.0
    minors[..., 54] = 0.0
    minors[..., 55] = 0.0
    return minors.reshape(_leading + (56,))


def null_projector_position(q):
    """projector I - J^+ J onto the null space of the position Jacobian: 433 operations.

    in   q[8]
    out  null_projector[8][8]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q7 = q[..., 6]
    s7 = np.sin(q7)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q5 = q[..., 4]
    s5 = np.sin(q5)
    c5 = np.cos(q5)
    s3 = np.sin(q3)
    s4 = np.sin(q4)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    c7 = np.cos(q7)
    s6 = np.sin(q6)
    c2 = np.cos(q2)

    # terms
    t1 = 0.2 * s7
    t2 = 0.125 - t1
    t3 = c4 * s5
    t4 = c3 * t3 + c5 * s3
    t5 = s5 * s4
    t6 = 0.25 * t4 - -0.2 * t5
    t7 = c6 * c7 - s7 * s6
    t8 = s7 * c6 + c7 * s6
    t9 = c5 * t8
    t10 = s4 * t7 - c4 * t9
    t11 = s5 * t8
    t12 = c3 * t10 + s3 * t11
    t13 = s4 * t9 + c4 * t7
    t14 = s2 * t12 + c2 * t13
    t15 = t1 + 0.2 * t8
    t16 = 0.125 - (t15 + 0.2 * t13 - 0.25 * t12)
    t17 = t5 * c2 - t4 * s2
    t18 = t6 * t14 + t16 * t17
    t19 = s3 * t10 - c3 * t11
    t20 = c3 * c5 - t3 * s3
    t21 = t6 * t19 + t16 * t20
    t22 = 0.125 - t15
    t23 = t5 * t22
    t24 = 0.015625 + t2 * t2 + t18 * t18 + t21 * t21 + t23 * t23
    t25 = c5 * t22
    t26 = np.sqrt((t24 + t25 * t25))
    t27 = np.where(t26 != 0.0, 1, 0.0)
    t28 = t27 / (t26 + (1 - t27))
    t29 = t18 * t28
    t30 = -0.2 * c7
    t31 = t30 - 0.2 * t7
    t32 = c5 * t7
    t33 = s4 * t32 - c4 * t8
    t34 = c4 * t32 + s4 * t8
    t35 = s5 * t7
    t36 = c3 * t34 - s3 * t35
    t37 = t31 - 0.2 * t33 - 0.25 * t36
    t38 = s2 * t36 - c2 * t33
    t39 = t17 * t37 - t6 * t38
    t40 = t21 * t28
    t41 = c3 * t35 + s3 * t34
    t42 = t6 * t41 - t20 * t37
    t43 = t23 * t28
    t44 = t5 * t31
    t45 = t25 * t28
    t46 = c5 * t31
    t47 = t29 * t39 - t40 * t42 + t43 * t44 + t45 * t46
    t48 = t2 * t28
    t49 = t47 + t30 * t48
    t50 = t39 - t29 * t49
    t51 = t42 + t40 * t49
    t52 = t44 - t43 * t49
    t53 = t46 - t45 * t49
    t54 = t29 * t50 - t40 * t51 + t43 * t52 + t45 * t53
    t55 = t48 * t49 - t30
    t56 = -0.125 * t28
    t57 = t49 * t56
    t58 = t54 - t48 * t55 - t56 * t57
    t59 = t50 - t29 * t58
    t60 = t51 + t40 * t58
    t61 = t52 - t43 * t58
    t62 = t53 - t45 * t58
    t63 = t59 * t59 + t60 * t60 + t61 * t61 + t62 * t62
    t64 = t55 + t48 * t58
    t65 = t57 + t56 * t58
    t66 = np.sqrt((t63 + t64 * t64 + t65 * t65))
    t67 = np.where(t66 != 0.0, 1, 0.0)
    t68 = t67 / (t66 + (1 - t67))
    t69 = t59 * t68
    t70 = t22 * t33 - t13 * t31
    t71 = t14 * t37 + t16 * t38
    t72 = t19 * t37 + t16 * t41
    t73 = t11 * t31 - t22 * t35
    t74 = t43 * t70 - (t29 * t71 + t40 * t72) + t45 * t73
    t75 = t48 * t74
    t76 = t72 + t40 * t74
    t77 = t60 * t68
    t78 = t71 + t29 * t74
    t79 = t70 - t43 * t74
    t80 = t61 * t68
    t81 = t73 - t45 * t74
    t82 = t62 * t68
    t83 = t76 * t77 - t69 * t78 + t79 * t80 + t81 * t82
    t84 = t64 * t68
    t85 = t56 * t74
    t86 = t65 * t68
    t87 = t83 + t75 * t84 + t85 * t86
    t88 = t75 - t84 * t87
    t89 = t86 * t87 - t85
    t90 = t78 + t69 * t87
    t91 = t76 - t77 * t87
    t92 = t56 * t89 - t48 * t88 - t29 * t90 - t40 * t91
    t93 = t79 - t80 * t87
    t94 = t81 - t82 * t87
    t95 = t92 + t43 * t93 + t45 * t94
    t96 = t88 + t48 * t95
    t97 = t91 + t40 * t95
    t98 = t90 + t29 * t95
    t99 = t93 - t43 * t95
    t100 = t94 - t45 * t95
    t101 = t77 * t97 - t69 * t98 + t80 * t99 + t82 * t100
    t102 = t89 - t56 * t95
    t103 = t101 + t84 * t96 - t86 * t102
    t104 = t96 - t84 * t103
    t105 = t102 + t86 * t103
    t106 = t98 + t69 * t103
    t107 = t97 - t77 * t103
    t108 = t104 * t104 + t105 * t105 + t106 * t106 + t107 * t107
    t109 = t99 - t80 * t103
    t110 = t100 - t82 * t103
    t111 = t7 * t31 + t8 * t22
    t112 = np.sqrt((t108 + t109 * t109 + t110 * t110 + t111 * t111))
    t113 = np.where(t112 != 0.0, 1, 0.0)
    t114 = t113 / (t112 + (1 - t113))
    t115 = t106 * t114
    t116 = t107 * t114
    t117 = t29 * t40 - t69 * t77 + t115 * t116
    t118 = t109 * t114
    t119 = t115 * t118 - (t29 * t43 + t69 * t80)
    t120 = t110 * t114
    t121 = t115 * t120 - (t29 * t45 + t69 * t82)
    t122 = t111 * t114
    t123 = -(t115 * t122)
    t124 = t104 * t114
    t125 = t29 * t48 - t69 * t84 + t115 * t124
    t126 = t105 * t114
    t127 = t69 * t86 - t29 * t56 + t115 * t126
    t128 = t40 * t43 - t77 * t80 - t116 * t118
    t129 = t40 * t45 - t77 * t82 - t116 * t120
    t130 = t116 * t122
    t131 = -(t40 * t48 + t77 * t84 + t116 * t124)
    t132 = t40 * t56 + t77 * t86 - t116 * t126
    t133 = -(t43 * t45 + t80 * t82 + t118 * t120)
    t134 = t118 * t122
    t135 = t43 * t48 - t80 * t84 - t118 * t124
    t136 = t80 * t86 - t43 * t56 - t118 * t126
    t137 = t120 * t122
    t138 = t45 * t48 - t82 * t84 - t120 * t124
    t139 = t82 * t86 - t45 * t56 - t120 * t126
    t140 = t122 * t124
    t141 = t122 * t126
    t142 = t48 * t56 + t84 * t86 - t124 * t126

    # results
    null_projector = np.empty((*_leading, 64), _real)
    null_projector[..., 0] = 1 - t29 * t29 - t69 * t69 - t115 * t115
    null_projector[..., 1] = t117
    null_projector[..., 2] = t119
    null_projector[..., 3] = t121
    null_projector[..., 4] = t123
    null_projector[..., 5] = t125
    null_projector[..., 6] = t127
    null_projector[..., 7] = 0.0
    null_projector[..., 8] = t117
    null_projector[..., 9] = 1 - t40 * t40 - t77 * t77 - t116 * t116
    null_projector[..., 10] = t128
    null_projector[..., 11] = t129
    null_projector[..., 12] = t130
    null_projector[..., 13] = t131
    null_projector[..., 14] = t132
    null_projector[..., 15] = 0.0
    null_projector[..., 16] = t119
    null_projector[..., 17] = t128
    null_projector[..., 18] = 1 - t43 * t43 - t80 * t80 - t118 * t118
    null_projector[..., 19] = t133
    null_projector[..., 20] = t134
    null_projector[..., 21] = t135
    null_projector[..., 22] = t136
    null_projector[..., 23] = 0.0
    null_projector[..., 24] = t121
    null_projector[..., 25] = t129
    null_projector[..., 26] = t133
    null_projector[..., 27] = 1 - t45 * t45 - t82 * t82 - t120 * t120
    null_projector[..., 28] = t137
    null_projector[..., 29] = t138
    null_projector[..., 30] = t139
    null_projector[..., 31] = 0.0
    null_projector[..., 32] = t123
    null_projector[..., 33] = t130
    null_projector[..., 34] = t134
    null_projector[..., 35] = t137
    null_projector[..., 36] = 1 - t122 * t122
    null_projector[..., 37] = t140
    null_projector[..., 38] = t141
    null_projector[..., 39] = 0.0
    null_projector[..., 40] = t125
    null_projector[..., 41] = t131
    null_projector[..., 42] = t135
    null_projector[..., 43] = t138
    null_projector[..., 44] = t140
    null_projector[..., 45] = 1 - t48 * t48 - t84 * t84 - t124 * t124
    null_projector[..., 46] = t142
    null_projector[..., 47] = 0.0
    null_projector[..., 48] = t127
    null_projector[..., 49] = t132
    null_projector[..., 50] = t136
    null_projector[..., 51] = t139
    null_projector[..., 52] = t141
    null_projector[..., 53] = t142
    null_projector[..., 54] = 1 - t56 * t56 - t86 * t86 - t126 * t126
    null_projector[..., 55] = 0.0
    null_projector[..., 56] = 0.0
    null_projector[..., 57] = 0.0
    null_projector[..., 58] = 0.0
    null_projector[..., 59] = 0.0
    null_projector[..., 60] = 0.0
    null_projector[..., 61] = 0.0
    null_projector[..., 62] = 0.0
    null_projector[..., 63] = 1
    return null_projector.reshape(_leading + (8, 8))
