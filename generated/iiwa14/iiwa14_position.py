"""manipulability (position) of iiwa14, in NumPy.

Made from templates/kernel.py.j2; inputs c651bc750b16194a69b4fb16a3147b4955beefc4951f117b4404890e4ed85dd7.
1362 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_position(q):
    """manipulability H = sqrt(det(J J^T)) of the position Jacobian: 203 operations.

    in   q[7]
    out  manipulability (one number)
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q6 = q[..., 5]
    s6 = np.sin(q6)
    q4 = q[..., 3]
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    c6 = np.cos(q6)
    c4 = np.cos(q4)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s5 = np.sin(q5)
    s2 = np.sin(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)

    # terms
    t1 = 0.4 * s6
    t2 = c5 * c6
    t3 = s4 * t2 - s6 * c4
    t4 = t1 - 0.42 * t3
    t5 = s4 * s5
    t6 = c4 * s5
    t7 = c2 * t5 - s2 * (c3 * t6 + c5 * s3)
    t8 = -0.42 * t5
    t9 = t2 * c4 + s6 * s4
    t10 = c6 * s5
    t11 = s2 * (c3 * t9 - s3 * t10) - t3 * c2
    t12 = t4 * t7 + t8 * t11
    t13 = s6 * c5
    t14 = s4 * c6 - c4 * t13
    t15 = s6 * s5
    t16 = s3 * t14 - c3 * t15
    t17 = 0.4 * c6
    t18 = s4 * t13 + c6 * c4
    t19 = -0.126 - (t17 + 0.42 * t18)
    t20 = c5 * c3 - t6 * s3
    t21 = t8 * t16 - t19 * t20
    t22 = s2 * (c3 * t14 + s3 * t15) + c2 * t18
    t23 = t7 * t19 - t8 * t22
    t24 = c3 * t10 + s3 * t9
    t25 = t8 * t24 + t4 * t20
    t26 = t12 * t21 + t23 * t25
    t27 = -0.126 - t17
    t28 = t3 * t27 - t1 * t18
    t29 = t5 * t27
    t30 = t1 * t5
    t31 = t25 * t29 + t21 * t30
    t32 = t4 * t22 + t11 * t19
    t33 = t12 * t29 - t23 * t30
    t34 = t4 * t16 + t19 * t24
    t35 = t26 * t28 + t31 * t32 - t33 * t34
    t36 = t1 * t15 - t10 * t27
    t37 = c5 * t27
    t38 = t1 * c5
    t39 = t25 * t37 + t21 * t38
    t40 = t12 * t37 - t23 * t38
    t41 = t26 * t36 + t32 * t39 - t34 * t40
    t42 = 0.126 * s6
    t43 = t26 * t42
    t44 = 0.126 * t25
    t45 = 0.126 * t12
    t46 = t32 * t44 - t34 * t45
    t47 = t35 * t35 + t41 * t41 + t43 * t43 + t46 * t46
    t48 = t30 * t37 - t29 * t38
    t49 = t33 * t36 - t32 * t48 - t28 * t40
    t50 = t33 * t42
    t51 = 0.126 * t30
    t52 = t32 * t51 + t28 * t45
    t53 = t40 * t42
    t54 = t47 + t49 * t49 + t50 * t50 + t52 * t52 + t53 * t53
    t55 = 0.126 * t38
    t56 = t32 * t55 + t36 * t45
    t57 = t42 * t45
    t58 = t34 * t48 - t31 * t36 + t28 * t39
    t59 = t31 * t42
    t60 = t54 + t56 * t56 + t57 * t57 + t58 * t58 + t59 * t59
    t61 = t34 * t51 + t28 * t44
    t62 = t39 * t42
    t63 = t34 * t55 + t36 * t44
    t64 = t42 * t44
    t65 = t60 + t61 * t61 + t62 * t62 + t63 * t63 + t64 * t64
    t66 = t42 * t48
    t67 = t28 * t55 - t36 * t51
    t68 = t42 * t51
    t69 = t42 * t55
    t70 = t65 + t66 * t66 + t67 * t67 + t68 * t68 + t69 * t69

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.sqrt(t70)
    return manipulability.reshape(_leading)


def manipulability_gradient_position(q):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in lexicographic order: 630 operations.

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
    q6 = q[..., 5]
    s6 = np.sin(q6)
    q4 = q[..., 3]
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    c6 = np.cos(q6)
    c4 = np.cos(q4)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s5 = np.sin(q5)
    s2 = np.sin(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)

    # terms
    t1 = 0.4 * s6
    t2 = c5 * c6
    t3 = s4 * t2 - s6 * c4
    t4 = t1 - 0.42 * t3
    t5 = s4 * s5
    t6 = c4 * s5
    t7 = c3 * t6 + c5 * s3
    t8 = c2 * t5 - s2 * t7
    t9 = -0.42 * t5
    t10 = t2 * c4 + s6 * s4
    t11 = c6 * s5
    t12 = c3 * t10 - s3 * t11
    t13 = s2 * t12 - t3 * c2
    t14 = t4 * t8 + t9 * t13
    t15 = s6 * c5
    t16 = s4 * c6 - c4 * t15
    t17 = s6 * s5
    t18 = s3 * t16 - c3 * t17
    t19 = 0.4 * c6
    t20 = s4 * t15 + c6 * c4
    t21 = -0.126 - (t19 + 0.42 * t20)
    t22 = c5 * c3 - t6 * s3
    t23 = t9 * t18 - t21 * t22
    t24 = c3 * t16 + s3 * t17
    t25 = s2 * t24 + c2 * t20
    t26 = t8 * t21 - t9 * t25
    t27 = c3 * t11 + s3 * t10
    t28 = t9 * t27 + t4 * t22
    t29 = t14 * t23 + t26 * t28
    t30 = -0.126 - t19
    t31 = t3 * t30 - t1 * t20
    t32 = t5 * t30
    t33 = t1 * t5
    t34 = t28 * t32 + t23 * t33
    t35 = t4 * t25 + t13 * t21
    t36 = t14 * t32 - t26 * t33
    t37 = t4 * t18 + t21 * t27
    t38 = t29 * t31 + t34 * t35 - t36 * t37
    t39 = t1 * t17 - t11 * t30
    t40 = c5 * t30
    t41 = t1 * c5
    t42 = t28 * t40 + t23 * t41
    t43 = t14 * t40 - t26 * t41
    t44 = t29 * t39 + t35 * t42 - t37 * t43
    t45 = 0.126 * s6
    t46 = t29 * t45
    t47 = 0.126 * t28
    t48 = 0.126 * t14
    t49 = t35 * t47 - t37 * t48
    t50 = t38 * t38 + t44 * t44 + t46 * t46 + t49 * t49
    t51 = t33 * t40 - t32 * t41
    t52 = t36 * t39 - t35 * t51 - t31 * t43
    t53 = t36 * t45
    t54 = 0.126 * t33
    t55 = t35 * t54 + t31 * t48
    t56 = t43 * t45
    t57 = t50 + t52 * t52 + t53 * t53 + t55 * t55 + t56 * t56
    t58 = 0.126 * t41
    t59 = t35 * t58 + t39 * t48
    t60 = t45 * t48
    t61 = t37 * t51 - t34 * t39 + t31 * t42
    t62 = t34 * t45
    t63 = t57 + t59 * t59 + t60 * t60 + t61 * t61 + t62 * t62
    t64 = t37 * t54 + t31 * t47
    t65 = t42 * t45
    t66 = t37 * t58 + t39 * t47
    t67 = t45 * t47
    t68 = t63 + t64 * t64 + t65 * t65 + t66 * t66 + t67 * t67
    t69 = t45 * t51
    t70 = t31 * t58 - t39 * t54
    t71 = t45 * t54
    t72 = t45 * t58
    t73 = t68 + t69 * t69 + t70 * t70 + t71 * t71 + t72 * t72
    t74 = np.sqrt(t73)
    t75 = t59 / t74
    t76 = t55 / t74
    t77 = t52 / t74
    t78 = t49 / t74
    t79 = t58 * t75 + t54 * t76 - t51 * t77 + t47 * t78
    t80 = t44 / t74
    t81 = t38 / t74
    t82 = t79 + t42 * t80 + t34 * t81
    t83 = t46 / t74
    t84 = t45 * t83 + t39 * t80 + t31 * t81
    t85 = t56 / t74
    t86 = t45 * t85 - t31 * t77 - t37 * t80
    t87 = t53 / t74
    t88 = t45 * t87 + t39 * t77 - t37 * t81
    t89 = t28 * t84 - (t41 * t86 + t33 * t88)
    t90 = t4 * t82 - t9 * t89
    t91 = t60 / t74
    t92 = t45 * t91 + t39 * t75 + t31 * t76 - t37 * t78
    t93 = 0.126 * t92 + t40 * t86 + t32 * t88 + t23 * t84
    t94 = t21 * t82 + t9 * t93
    t95 = t21 * t89 + t4 * t93
    t96 = c2 * (t24 * t90 + t12 * t94 - t7 * t95) - s2 * (t20 * t90 - t3 * t94 + t5 * t95)
    t97 = t66 / t74
    t98 = t64 / t74
    t99 = t61 / t74
    t100 = t58 * t97 + t54 * t98 + t51 * t99 - t48 * t78
    t101 = t100 - t43 * t80 - t36 * t81
    t102 = t67 / t74
    t103 = t45 * t102 + t39 * t97 + t31 * t98 + t35 * t78
    t104 = t65 / t74
    t105 = t45 * t104 + t31 * t99 + t35 * t80
    t106 = t62 / t74
    t107 = t45 * t106 - t39 * t99 + t35 * t81
    t108 = 0.126 * t103 + t40 * t105 + t32 * t107 + t26 * t84
    t109 = t21 * t101 + t9 * t108
    t110 = s2 * t90
    t111 = t41 * t105 + t33 * t107 + t14 * t84
    t112 = t4 * t108 - t21 * t111
    t113 = t4 * t101 + t9 * t111
    t114 = t10 * t109 + t17 * t110 - t6 * t112 + t16 * t113
    t115 = s2 * t94
    t116 = s2 * t95
    t117 = t11 * t109 + t16 * t110 + c5 * t112 - t17 * t113
    t118 = c3 * (t114 - t11 * t115 - c5 * t116) - s3 * (t117 + t10 * t115 - t6 * t116)
    t119 = t70 / t74
    t120 = t58 * t119 + t47 * t98 + t42 * t99 + t48 * t76
    t121 = t120 - t43 * t77 + t29 * t81
    t122 = t27 * t101 + t13 * t82 + t8 * t89 - t22 * t111
    t123 = c2 * t90 - t1 * t121 - 0.42 * t122
    t124 = c3 * t110 + s3 * t113
    t125 = s3 * t109 + c3 * t115
    t126 = t71 / t74
    t127 = t45 * t126 - t39 * t119 + t37 * t98 + t35 * t76
    t128 = t69 / t74
    t129 = t45 * t128 + t37 * t99 - t35 * t77
    t130 = 0.126 * t127 + t40 * t129 - t26 * t88 + t23 * t107
    t131 = t14 * t88 - t41 * t129 + t28 * t107
    t132 = t27 * t108 - t25 * t89 + t18 * t111 + t13 * t93
    t133 = t1 * t130 + t30 * t131 + -0.42 * t132 + c2 * t95
    t134 = t15 * t123 + c6 * t124 + s6 * t125 + s5 * t133
    t135 = t18 * t101 + t25 * t82 + t22 * t108 + t8 * t93
    t136 = t30 * t121 - c2 * t94 - 0.42 * t135
    t137 = s3 * t112 + c3 * t116
    t138 = c6 * t123 - t15 * t124 + t2 * t125 - s5 * t137
    t139 = c4 * (t134 + t2 * t136) - s4 * (t138 - s6 * t136)
    t140 = t47 * t97 - t54 * t119 - t34 * t99 + t48 * t75
    t141 = t140 + t36 * t77 + t29 * t80
    t142 = t1 * t141 + s3 * t110 - c3 * t113
    t143 = c3 * t109 - t30 * t141 - s3 * t115
    t144 = s6 * t142 + c6 * t143 - c4 * t137 + s4 * t133
    t145 = t72 / t74
    t146 = t45 * t145 + t31 * t119 + t37 * t97 + t35 * t75
    t147 = 0.126 * t146 - t32 * t129 - t26 * t86 + t23 * t105
    t148 = t33 * t129 + t14 * t86 + t28 * t105
    t149 = s4 * t123 - c4 * t124
    t150 = t1 * t147 + t30 * t148 + c3 * t112 + s6 * t149
    t151 = c4 * t125 + s4 * t136
    t152 = c5 * t144 - s5 * (t150 - s3 * t116 + c6 * t151)
    t153 = t58 * t145 + t54 * t126 + t51 * t128 + t47 * t102
    t154 = t153 + t42 * t104 + t34 * t106 + t48 * t91 + t43 * t85
    t155 = 0.126 * (t154 + t36 * t87 + t29 * t83) + s5 * t142
    t156 = c5 * t147 + t17 * t141 + t5 * t130 - t20 * t121
    t157 = t155 + c5 * t149 + s4 * t125 - c4 * t136 + 0.4 * (t135 + t156)
    t158 = c5 * t148 - t11 * t141 + t5 * t131 + t3 * t121
    t159 = c4 * t123 - 0.4 * (t122 + t158) + s4 * t124 + s5 * t143
    t160 = c6 * t157 - s6 * (t159 + c5 * t151)
    t161 = 1 / t74
    t162 = t161 * t161
    t163 = -0.5 / t74 * np.sqrt(t161)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 7), _real)
    inverse_gradient = np.empty((*_leading, 7), _real)
    inverse_root_gradient = np.empty((*_leading, 7), _real)
    manipulability[..., 0] = t74
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t74 != 0.0, t96, 0.0)
    gradient[..., 2] = np.where(t74 != 0.0, t118, 0.0)
    gradient[..., 3] = np.where(t74 != 0.0, t139, 0.0)
    gradient[..., 4] = np.where(t74 != 0.0, t152, 0.0)
    gradient[..., 5] = np.where(t74 != 0.0, t160, 0.0)
    gradient[..., 6] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t74 != 0.0, -(t96 * t162), 0.0)
    inverse_gradient[..., 2] = np.where(t74 != 0.0, -(t118 * t162), 0.0)
    inverse_gradient[..., 3] = np.where(t74 != 0.0, -(t139 * t162), 0.0)
    inverse_gradient[..., 4] = np.where(t74 != 0.0, -(t152 * t162), 0.0)
    inverse_gradient[..., 5] = np.where(t74 != 0.0, -(t160 * t162), 0.0)
    inverse_gradient[..., 6] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t74 != 0.0, t96 * t163, 0.0)
    inverse_root_gradient[..., 2] = np.where(t74 != 0.0, t118 * t163, 0.0)
    inverse_root_gradient[..., 3] = np.where(t74 != 0.0, t139 * t163, 0.0)
    inverse_root_gradient[..., 4] = np.where(t74 != 0.0, t152 * t163, 0.0)
    inverse_root_gradient[..., 5] = np.where(t74 != 0.0, t160 * t163, 0.0)
    inverse_root_gradient[..., 6] = 0.0
    return manipulability.reshape(_leading), gradient.reshape(_leading + (7,)), inverse_gradient.reshape(_leading + (7,)), inverse_root_gradient.reshape(_leading + (7,))


def minors_position(q):
    """maximal minors of the position Jacobian, columns in lexicographic order: 176 operations.

    in   q[7]
    out  minors[35]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q6 = q[..., 5]
    s6 = np.sin(q6)
    q4 = q[..., 3]
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    c6 = np.cos(q6)
    c4 = np.cos(q4)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s5 = np.sin(q5)
    s2 = np.sin(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)

    # terms
    t1 = 0.4 * s6
    t2 = c5 * c6
    t3 = s4 * t2 - s6 * c4
    t4 = t1 - 0.42 * t3
    t5 = s4 * s5
    t6 = c4 * s5
    t7 = c2 * t5 - s2 * (c3 * t6 + c5 * s3)
    t8 = -0.42 * t5
    t9 = t2 * c4 + s6 * s4
    t10 = c6 * s5
    t11 = s2 * (c3 * t9 - s3 * t10) - t3 * c2
    t12 = t4 * t7 + t8 * t11
    t13 = s6 * c5
    t14 = s4 * c6 - c4 * t13
    t15 = s6 * s5
    t16 = s3 * t14 - c3 * t15
    t17 = 0.4 * c6
    t18 = s4 * t13 + c6 * c4
    t19 = -0.126 - (t17 + 0.42 * t18)
    t20 = c5 * c3 - t6 * s3
    t21 = t8 * t16 - t19 * t20
    t22 = s2 * (c3 * t14 + s3 * t15) + c2 * t18
    t23 = t7 * t19 - t8 * t22
    t24 = c3 * t10 + s3 * t9
    t25 = t8 * t24 + t4 * t20
    t26 = t12 * t21 + t23 * t25
    t27 = -0.126 - t17
    t28 = t3 * t27 - t1 * t18
    t29 = t5 * t27
    t30 = t1 * t5
    t31 = t25 * t29 + t21 * t30
    t32 = t4 * t22 + t11 * t19
    t33 = t12 * t29 - t23 * t30
    t34 = t4 * t16 + t19 * t24
    t35 = t1 * t15 - t10 * t27
    t36 = c5 * t27
    t37 = t1 * c5
    t38 = t25 * t36 + t21 * t37
    t39 = t12 * t36 - t23 * t37
    t40 = 0.126 * s6
    t41 = 0.126 * t25
    t42 = 0.126 * t12
    t43 = t30 * t36 - t29 * t37
    t44 = 0.126 * t30
    t45 = 0.126 * t37

    # results
    minors = np.empty((*_leading, 35), _real)
    minors[..., 0] = -(t26 * t28 + t31 * t32 - t33 * t34)
    minors[..., 1] = -(t26 * t35 + t32 * t38 - t34 * t39)
    minors[..., 2] = -(t26 * t40)
    minors[..., 3] = -(t32 * t41 - t34 * t42)
    minors[..., 4] = 0.0
    minors[..., 5] = -(t33 * t35 - t32 * t43 - t28 * t39)
    minors[..., 6] = -(t33 * t40)
    minors[..., 7] = t32 * t44 + t28 * t42
    minors[..., 8] = 0.0
    minors[..., 9] = -(t39 * t40)
    minors[..., 10] = t32 * t45 + t35 * t42
    minors[..., 11] = 0.0
    minors[..., 12] = t40 * t42
    minors[..., 13] = 0.0
    minors[..., 14] = 0.0
    minors[..., 15] = -(t34 * t43 - t31 * t35 + t28 * t38)
    minors[..., 16] = t31 * t40
    minors[..., 17] = -(t34 * t44 + t28 * t41)
    minors[..., 18] = 0.0
    minors[..., 19] = t38 * t40
    minors[..., 20] = -(t34 * t45 + t35 * t41)
    minors[..., 21] = 0.0
    minors[..., 22] = -(t40 * t41)
    minors[..., 23] = 0.0
    minors[..., 24] = 0.0
    minors[..., 25] = -(t40 * t43)
    minors[..., 26] = -(t28 * t45 - t35 * t44)
    minors[..., 27] = 0.0
    minors[..., 28] = t40 * t44
    minors[..., 29] = 0.0
    minors[..., 30] = 0.0
    minors[..., 31] = t40 * t45
    minors[..., 32] = 0.0
    minors[..., 33] = 0.0
    minors[..., 34] = 0.0
    return minors.reshape(_leading + (35,))


def null_projector_position(q):
    """projector I - J^+ J onto the null space of the position Jacobian: 353 operations.

    in   q[7]
    out  null_projector[7][7]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q6 = q[..., 5]
    c6 = np.cos(q6)
    q4 = q[..., 3]
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s6 = np.sin(q6)
    c4 = np.cos(q4)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s5 = np.sin(q5)
    s2 = np.sin(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)

    # terms
    t1 = 0.4 * c6
    t2 = c5 * s6
    t3 = s4 * t2 + c6 * c4
    t4 = -0.126 - (t1 + 0.42 * t3)
    t5 = s4 * s5
    t6 = c4 * s5
    t7 = c2 * t5 - s2 * (c3 * t6 + c5 * s3)
    t8 = -0.42 * t5
    t9 = c6 * s4 - t2 * c4
    t10 = s6 * s5
    t11 = s2 * (c3 * t9 + s3 * t10) + t3 * c2
    t12 = t4 * t7 - t8 * t11
    t13 = s3 * t9 - c3 * t10
    t14 = c5 * c3 - t6 * s3
    t15 = t8 * t13 - t4 * t14
    t16 = -0.126 - t1
    t17 = t5 * t16
    t18 = c5 * t16
    t19 = 0.015876 + t12 * t12 + t15 * t15 + t17 * t17 + t18 * t18
    t20 = np.sqrt(t19)
    t21 = np.where(t20 != 0.0, 1, 0.0)
    t22 = t21 / (t20 + (1 - t21))
    t23 = t12 * t22
    t24 = 0.4 * s6
    t25 = c6 * c5
    t26 = s4 * t25 - s6 * c4
    t27 = t24 - 0.42 * t26
    t28 = c4 * t25 + s4 * s6
    t29 = c6 * s5
    t30 = s2 * (c3 * t28 - s3 * t29) - c2 * t26
    t31 = t7 * t27 + t8 * t30
    t32 = t15 * t22
    t33 = c3 * t29 + s3 * t28
    t34 = t8 * t33 + t14 * t27
    t35 = t17 * t22
    t36 = t5 * t24
    t37 = t18 * t22
    t38 = c5 * t24
    t39 = t23 * t31 - t32 * t34 + t35 * t36 + t37 * t38
    t40 = t31 - t23 * t39
    t41 = t34 + t32 * t39
    t42 = t36 - t35 * t39
    t43 = t38 - t37 * t39
    t44 = t23 * t40 - t32 * t41 + t35 * t42 + t37 * t43
    t45 = 0.126 * t22
    t46 = t39 * t45
    t47 = t44 - t45 * t46
    t48 = t40 - t23 * t47
    t49 = t41 + t32 * t47
    t50 = t42 - t35 * t47
    t51 = t43 - t37 * t47
    t52 = t48 * t48 + t49 * t49 + t50 * t50 + t51 * t51
    t53 = t46 + t45 * t47
    t54 = np.sqrt((t52 + t53 * t53))
    t55 = np.where(t54 != 0.0, 1, 0.0)
    t56 = t55 / (t54 + (1 - t55))
    t57 = t48 * t56
    t58 = t11 * t27 + t4 * t30
    t59 = t13 * t27 + t4 * t33
    t60 = t16 * t26 - t3 * t24
    t61 = t10 * t24 - t16 * t29
    t62 = t32 * t59 - t23 * t58 + t35 * t60 + t37 * t61
    t63 = t58 + t23 * t62
    t64 = t60 - t35 * t62
    t65 = t50 * t56
    t66 = t59 - t32 * t62
    t67 = t49 * t56
    t68 = t61 - t37 * t62
    t69 = t51 * t56
    t70 = t64 * t65 - (t57 * t63 + t66 * t67) + t68 * t69
    t71 = t45 * t62
    t72 = t53 * t56
    t73 = t70 + t71 * t72
    t74 = t63 + t57 * t73
    t75 = t66 + t67 * t73
    t76 = t64 - t65 * t73
    t77 = t68 - t69 * t73
    t78 = t32 * t75 - t23 * t74 + t35 * t76 + t37 * t77
    t79 = t72 * t73 - t71
    t80 = t78 + t45 * t79
    t81 = t74 + t23 * t80
    t82 = t76 - t35 * t80
    t83 = t75 - t32 * t80
    t84 = t77 - t37 * t80
    t85 = t65 * t82 - (t57 * t81 + t67 * t83) + t69 * t84
    t86 = t79 - t45 * t80
    t87 = t85 - t72 * t86
    t88 = t81 + t57 * t87
    t89 = t83 + t67 * t87
    t90 = t82 - t65 * t87
    t91 = t84 - t69 * t87
    t92 = t88 * t88 + t89 * t89 + t90 * t90 + t91 * t91
    t93 = t86 + t72 * t87
    t94 = 0.126 * s6
    t95 = np.sqrt((t92 + t93 * t93 + t94 * t94))
    t96 = np.where(t95 != 0.0, 1, 0.0)
    t97 = t96 / (t95 + (1 - t96))
    t98 = t88 * t97
    t99 = t89 * t97
    t100 = t57 * t67 - t23 * t32 + t98 * t99
    t101 = t90 * t97
    t102 = t98 * t101 - (t23 * t35 + t57 * t65)
    t103 = t91 * t97
    t104 = t98 * t103 - (t23 * t37 + t57 * t69)
    t105 = t94 * t97
    t106 = t98 * t105
    t107 = t93 * t97
    t108 = t57 * t72 - t23 * t45 + t98 * t107
    t109 = t65 * t67 - t32 * t35 - t99 * t101
    t110 = t67 * t69 - t32 * t37 - t99 * t103
    t111 = -(t99 * t105)
    t112 = -(t32 * t45 + t67 * t72 + t99 * t107)
    t113 = -(t35 * t37 + t65 * t69 + t101 * t103)
    t114 = -(t101 * t105)
    t115 = t65 * t72 - t35 * t45 - t101 * t107
    t116 = -(t103 * t105)
    t117 = t69 * t72 - t37 * t45 - t103 * t107
    t118 = -(t105 * t107)

    # results
    null_projector = np.empty((*_leading, 49), _real)
    null_projector[..., 0] = 1 - t23 * t23 - t57 * t57 - t98 * t98
    null_projector[..., 1] = t100
    null_projector[..., 2] = t102
    null_projector[..., 3] = t104
    null_projector[..., 4] = t106
    null_projector[..., 5] = t108
    null_projector[..., 6] = 0.0
    null_projector[..., 7] = t100
    null_projector[..., 8] = 1 - t32 * t32 - t67 * t67 - t99 * t99
    null_projector[..., 9] = t109
    null_projector[..., 10] = t110
    null_projector[..., 11] = t111
    null_projector[..., 12] = t112
    null_projector[..., 13] = 0.0
    null_projector[..., 14] = t102
    null_projector[..., 15] = t109
    null_projector[..., 16] = 1 - t35 * t35 - t65 * t65 - t101 * t101
    null_projector[..., 17] = t113
    null_projector[..., 18] = t114
    null_projector[..., 19] = t115
    null_projector[..., 20] = 0.0
    null_projector[..., 21] = t104
    null_projector[..., 22] = t110
    null_projector[..., 23] = t113
    null_projector[..., 24] = 1 - t37 * t37 - t69 * t69 - t103 * t103
    null_projector[..., 25] = t116
    null_projector[..., 26] = t117
    null_projector[..., 27] = 0.0
    null_projector[..., 28] = t106
    null_projector[..., 29] = t111
    null_projector[..., 30] = t114
    null_projector[..., 31] = t116
    null_projector[..., 32] = 1 - t105 * t105
    null_projector[..., 33] = t118
    null_projector[..., 34] = 0.0
    null_projector[..., 35] = t108
    null_projector[..., 36] = t112
    null_projector[..., 37] = t115
    null_projector[..., 38] = t117
    null_projector[..., 39] = t118
    null_projector[..., 40] = 1 - t45 * t45 - t72 * t72 - t107 * t107
    null_projector[..., 41] = 0.0
    null_projector[..., 42] = 0.0
    null_projector[..., 43] = 0.0
    null_projector[..., 44] = 0.0
    null_projector[..., 45] = 0.0
    null_projector[..., 46] = 0.0
    null_projector[..., 47] = 0.0
    null_projector[..., 48] = 1
    return null_projector.reshape(_leading + (7, 7))
