"""manipulability (position) of jaco2, in NumPy.

Made from templates/kernel.py.j2; inputs 1ad93e3c11b867e4c607122d6c1c8fda72f2a60d9e7231f3d78e1cc06c98b3ce.
1134 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_position(q):
    """manipulability H = sqrt(det(J J^T)) of the position Jacobian: 166 operations.

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
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    c4 = np.cos(q4)

    # terms
    t1 = 0.41 * c2
    t2 = c3 * s2 - c2 * s3
    t3 = t1 + 0.2500816549469513 * t2
    t4 = c2 * c3 + s2 * s3
    t5 = s4 * t4
    t6 = t3 + 0.04278165494695127 * t2 - 0.07409999999999999 * t5
    t7 = c5 * (0.5000000000000001 * t5 + 0.8660254037844386 * t2) + s5 * (t4 * c4)
    t8 = -0.5000000000000001 * t2 + 0.8660254037844386 * t5
    t9 = t6 - 0.17561406460551018 * t7 - 0.10139082747347566 * t8
    t10 = t9 * t9
    t11 = 0.41 * s2
    t12 = t11 - 0.2500816549469513 * t4
    t13 = t2 * s4
    t14 = t12 - 0.04278165494695127 * t4 - 0.07409999999999999 * t13
    t15 = c5 * (0.8660254037844386 * t4 - 0.5000000000000001 * t13) - s5 * (t2 * c4)
    t16 = 0.8660254037844386 * t13 - -0.5000000000000001 * t4
    t17 = t14 + 0.17561406460551018 * t15 - 0.10139082747347566 * t16
    t18 = t17 - t11
    t19 = t9 - t1
    t20 = t9 * t19
    t21 = t10 * t18 - t17 * t20
    t22 = t2 * (t17 - t12) + t4 * (t9 - t3)
    t23 = t9 * t22
    t24 = 0.07409999999999999 * c4 - 0.0098
    t25 = t24 + 0.17561406460551018 * (c5 * (0.5000000000000001 * c4) - s4 * s5) - -0.0878070323027551 * c4
    t26 = 0.0098 + t25
    t27 = t4 * t26
    t28 = t2 * t26
    t29 = t9 * t28
    t30 = t23 * t25 - (t10 * t27 + t17 * t29)
    t31 = t17 - t14
    t32 = -0.8660254037844386 * c4
    t33 = t25 - t24
    t34 = t31 * t32 - t16 * t33
    t35 = t9 - t6
    t36 = t8 * t33 - t32 * t35
    t37 = t9 * t36
    t38 = t16 * t35 - t8 * t31
    t39 = t9 * t38
    t40 = t10 * t34 + t17 * t37 + t25 * t39
    t41 = t19 * t22
    t42 = t20 * t27 + t18 * t29 - t25 * t41
    t43 = t21 * t21 + t30 * t30 + t40 * t40 + t42 * t42
    t44 = t19 * t38
    t45 = t20 * t34 + t18 * t37 + t25 * t44
    t46 = t22 * t36 + t28 * t38
    t47 = t27 * t37 - t29 * t34 - t25 * t46
    t48 = t18 * t23 - t17 * t41
    t49 = t18 * t39 - t17 * t44
    t50 = t43 + t45 * t45 + t47 * t47 + t48 * t48 + t49 * t49
    t51 = t23 * t34 + t27 * t39 + t17 * t46
    t52 = t34 * t41 + t18 * t46 + t27 * t44

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.sqrt((t50 + t51 * t51 + t52 * t52))
    return manipulability.reshape(_leading)


def manipulability_gradient_position(q):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in lexicographic order: 484 operations.

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
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    c4 = np.cos(q4)

    # terms
    t1 = 0.41 * c2
    t2 = c3 * s2 - c2 * s3
    t3 = t1 + 0.2500816549469513 * t2
    t4 = c2 * c3 + s2 * s3
    t5 = s4 * t4
    t6 = t3 + 0.04278165494695127 * t2 - 0.07409999999999999 * t5
    t7 = 0.5000000000000001 * t5 + 0.8660254037844386 * t2
    t8 = t4 * c4
    t9 = -0.5000000000000001 * t2 + 0.8660254037844386 * t5
    t10 = t6 - 0.17561406460551018 * (c5 * t7 + s5 * t8) - 0.10139082747347566 * t9
    t11 = t10 * t10
    t12 = 0.41 * s2
    t13 = t12 - 0.2500816549469513 * t4
    t14 = t2 * s4
    t15 = t13 - 0.04278165494695127 * t4 - 0.07409999999999999 * t14
    t16 = 0.8660254037844386 * t4 - 0.5000000000000001 * t14
    t17 = t2 * c4
    t18 = 0.8660254037844386 * t14 - -0.5000000000000001 * t4
    t19 = t15 + 0.17561406460551018 * (c5 * t16 - s5 * t17) - 0.10139082747347566 * t18
    t20 = t19 - t12
    t21 = t10 - t1
    t22 = t10 * t21
    t23 = t11 * t20 - t19 * t22
    t24 = t19 - t13
    t25 = t10 - t3
    t26 = t2 * t24 + t4 * t25
    t27 = t10 * t26
    t28 = 0.07409999999999999 * c4 - 0.0098
    t29 = 0.5000000000000001 * c4
    t30 = t28 + 0.17561406460551018 * (c5 * t29 - s4 * s5) - -0.0878070323027551 * c4
    t31 = 0.0098 + t30
    t32 = t4 * t31
    t33 = t2 * t31
    t34 = t10 * t33
    t35 = t27 * t30 - (t11 * t32 + t19 * t34)
    t36 = t19 - t15
    t37 = -0.8660254037844386 * c4
    t38 = t30 - t28
    t39 = t36 * t37 - t18 * t38
    t40 = t10 - t6
    t41 = t9 * t38 - t37 * t40
    t42 = t10 * t41
    t43 = t18 * t40 - t9 * t36
    t44 = t10 * t43
    t45 = t11 * t39 + t19 * t42 + t30 * t44
    t46 = t21 * t26
    t47 = t22 * t32 + t20 * t34 - t30 * t46
    t48 = t23 * t23 + t35 * t35 + t45 * t45 + t47 * t47
    t49 = t21 * t43
    t50 = t22 * t39 + t20 * t42 + t30 * t49
    t51 = t26 * t41 + t33 * t43
    t52 = t32 * t42 - t34 * t39 - t30 * t51
    t53 = t20 * t27 - t19 * t46
    t54 = t20 * t44 - t19 * t49
    t55 = t48 + t50 * t50 + t52 * t52 + t53 * t53 + t54 * t54
    t56 = t27 * t39 + t32 * t44 + t19 * t51
    t57 = t39 * t46 + t20 * t51 + t32 * t49
    t58 = np.sqrt((t55 + t56 * t56 + t57 * t57))
    t59 = t57 / t58
    t60 = t56 / t58
    t61 = t52 / t58
    t62 = t47 / t58
    t63 = t49 * t59 + t44 * t60 + t42 * t61 + t22 * t62
    t64 = t35 / t58
    t65 = t63 - t11 * t64
    t66 = t20 * t59 + t19 * t60 - t30 * t61
    t67 = t53 / t58
    t68 = t39 * t59 - t19 * t67 - t30 * t62
    t69 = t39 * t60 + t20 * t67 + t30 * t64
    t70 = t41 * t66 + t21 * t68 + t10 * t69
    t71 = t54 / t58
    t72 = t50 / t58
    t73 = t32 * t59 - t19 * t71 + t30 * t72
    t74 = t45 / t58
    t75 = t32 * t60 + t20 * t71 + t30 * t74
    t76 = t33 * t66 + t21 * t73 + t10 * t75
    t77 = t46 * t59 + t27 * t60 - t34 * t61 + t22 * t72
    t78 = t77 + t11 * t74
    t79 = t51 * t60 - t49 * t71 - t46 * t67 + t42 * t74
    t80 = t37 * t78 - t9 * t76
    t81 = t2 * t70
    t82 = t23 / t58
    t83 = t51 * t59 + t44 * t71 + t27 * t67 + t42 * t72
    t84 = t83 + t34 * t62 + t11 * t82
    t85 = t79 + t80 - t34 * t64 + t81 - t22 * t82 + t84
    t86 = t40 * t76 - t38 * t78 - 0.10139082747347566 * t85
    t87 = 0.17561406460551018 * t85
    t88 = c5 * t87
    t89 = t31 * t65 + t25 * t70 - -0.5000000000000001 * t86 + 0.8660254037844386 * t88
    t90 = t85 - t80
    t91 = t90 - t81
    t92 = t89 - 0.04278165494695127 * t90 - 0.2500816549469513 * t91
    t93 = t32 * t61 + t20 * t72 + t19 * t74
    t94 = t26 * t66 + t10 * t93
    t95 = t18 * t76 - t37 * t94
    t96 = t20 * t62 - t39 * t61 - t19 * t64
    t97 = t43 * t75 + t41 * t93 + t95 + t33 * t96 + t26 * t69
    t98 = t4 * t70
    t99 = t39 * t72 + t32 * t62 - t19 * t82
    t100 = t43 * t73 + t26 * t68 + t10 * t99
    t101 = (t10 + t10) * (t39 * t74 - t32 * t64 + t20 * t82)
    t102 = t97 + t98 + t21 * t99 + t100 + t101
    t103 = t38 * t94 - t36 * t76 - 0.10139082747347566 * t102
    t104 = 0.17561406460551018 * t102
    t105 = c5 * t104
    t106 = t102 - t95
    t107 = 0.8660254037844386 * t103 - 0.5000000000000001 * t105 - 0.07409999999999999 * t106
    t108 = s5 * t104
    t109 = s4 * t107 - c4 * t108
    t110 = t43 * t66 + t10 * t96
    t111 = s5 * t87
    t112 = 0.8660254037844386 * t86 - 0.5000000000000001 * t88 - 0.07409999999999999 * t90
    t113 = t31 * t110 + t24 * t70 - c4 * t111 + s4 * t112
    t114 = t106 - t98
    t115 = t113 + -0.5000000000000001 * t103 - 0.8660254037844386 * t105 + 0.04278165494695127 * t106 + 0.2500816549469513 * t114
    t116 = s3 * t92 + 0.41 * (t91 - t84) + s3 * t109 + c3 * t115
    t117 = c3 * t92 + c3 * t109 - s3 * t115 + 0.41 * (t114 - t100)
    t118 = c2 * t116 - s2 * t117
    t119 = c3 * (s2 * t92 + s2 * t109 - c2 * t115) - s3 * (c2 * t92 + c2 * t109 + s2 * t115)
    t120 = t49 * t72 - t51 * t61 - t46 * t62 + t44 * t74
    t121 = t9 * t94 - t18 * t78
    t122 = t120 + t121 + (t2 * t110 + t4 * t65) + t27 * t64
    t123 = 0.17561406460551018 * t122
    t124 = -0.8660254037844386 * (t36 * t78 - t40 * t94) - -0.0878070323027551 * t122 + 0.5000000000000001 * (c5 * t123)
    t125 = t124 + 0.07409999999999999 * (t122 - t121) - t2 * t111 - t4 * t108
    t126 = c4 * (t2 * t112 - s5 * t123 + t4 * t107) - s4 * t125
    t127 = c5 * (s4 * t123 + t17 * t87 + t8 * t104) + s5 * (t29 * t123 + t16 * t87 - t7 * t104)
    t128 = 1 / t58
    t129 = t128 * t128
    t130 = -0.5 / t58 * np.sqrt(t128)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 6), _real)
    inverse_gradient = np.empty((*_leading, 6), _real)
    inverse_root_gradient = np.empty((*_leading, 6), _real)
    manipulability[..., 0] = t58
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t58 != 0.0, t118, 0.0)
    gradient[..., 2] = np.where(t58 != 0.0, t119, 0.0)
    gradient[..., 3] = np.where(t58 != 0.0, t126, 0.0)
    gradient[..., 4] = np.where(t58 != 0.0, -t127, 0.0)
    gradient[..., 5] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t58 != 0.0, -(t118 * t129), 0.0)
    inverse_gradient[..., 2] = np.where(t58 != 0.0, -(t119 * t129), 0.0)
    inverse_gradient[..., 3] = np.where(t58 != 0.0, -(t126 * t129), 0.0)
    inverse_gradient[..., 4] = np.where(t58 != 0.0, t127 * t129, 0.0)
    inverse_gradient[..., 5] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t58 != 0.0, t118 * t130, 0.0)
    inverse_root_gradient[..., 2] = np.where(t58 != 0.0, t119 * t130, 0.0)
    inverse_root_gradient[..., 3] = np.where(t58 != 0.0, t126 * t130, 0.0)
    inverse_root_gradient[..., 4] = np.where(t58 != 0.0, -(t127 * t130), 0.0)
    inverse_root_gradient[..., 5] = 0.0
    return manipulability.reshape(_leading), gradient.reshape(_leading + (6,)), inverse_gradient.reshape(_leading + (6,)), inverse_root_gradient.reshape(_leading + (6,))


def minors_position(q):
    """maximal minors of the position Jacobian, columns in lexicographic order: 148 operations.

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
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    c4 = np.cos(q4)

    # terms
    t1 = 0.41 * c2
    t2 = c3 * s2 - c2 * s3
    t3 = t1 + 0.2500816549469513 * t2
    t4 = c2 * c3 + s2 * s3
    t5 = s4 * t4
    t6 = t3 + 0.04278165494695127 * t2 - 0.07409999999999999 * t5
    t7 = c5 * (0.5000000000000001 * t5 + 0.8660254037844386 * t2) + s5 * (t4 * c4)
    t8 = -0.5000000000000001 * t2 + 0.8660254037844386 * t5
    t9 = t6 - 0.17561406460551018 * t7 - 0.10139082747347566 * t8
    t10 = t9 * t9
    t11 = 0.41 * s2
    t12 = t11 - 0.2500816549469513 * t4
    t13 = t2 * s4
    t14 = t12 - 0.04278165494695127 * t4 - 0.07409999999999999 * t13
    t15 = c5 * (0.8660254037844386 * t4 - 0.5000000000000001 * t13) - s5 * (t2 * c4)
    t16 = 0.8660254037844386 * t13 - -0.5000000000000001 * t4
    t17 = t14 + 0.17561406460551018 * t15 - 0.10139082747347566 * t16
    t18 = t17 - t11
    t19 = t9 - t1
    t20 = t9 * t19
    t21 = t2 * (t17 - t12) + t4 * (t9 - t3)
    t22 = t9 * t21
    t23 = 0.07409999999999999 * c4 - 0.0098
    t24 = t23 + 0.17561406460551018 * (c5 * (0.5000000000000001 * c4) - s4 * s5) - -0.0878070323027551 * c4
    t25 = 0.0098 + t24
    t26 = t4 * t25
    t27 = t2 * t25
    t28 = t9 * t27
    t29 = t17 - t14
    t30 = -0.8660254037844386 * c4
    t31 = t24 - t23
    t32 = t29 * t30 - t16 * t31
    t33 = t9 - t6
    t34 = t8 * t31 - t30 * t33
    t35 = t9 * t34
    t36 = t16 * t33 - t8 * t29
    t37 = t9 * t36
    t38 = t19 * t21
    t39 = t19 * t36
    t40 = t21 * t34 + t27 * t36

    # results
    minors = np.empty((*_leading, 20), _real)
    minors[..., 0] = t10 * t18 - t17 * t20
    minors[..., 1] = t22 * t24 - (t10 * t26 + t17 * t28)
    minors[..., 2] = t10 * t32 + t17 * t35 + t24 * t37
    minors[..., 3] = 0.0
    minors[..., 4] = t20 * t26 + t18 * t28 - t24 * t38
    minors[..., 5] = -(t20 * t32 + t18 * t35 + t24 * t39)
    minors[..., 6] = 0.0
    minors[..., 7] = t26 * t35 - t28 * t32 - t24 * t40
    minors[..., 8] = 0.0
    minors[..., 9] = 0.0
    minors[..., 10] = t18 * t22 - t17 * t38
    minors[..., 11] = t18 * t37 - t17 * t39
    minors[..., 12] = 0.0
    minors[..., 13] = -(t22 * t32 + t26 * t37 + t17 * t40)
    minors[..., 14] = 0.0
    minors[..., 15] = 0.0
    minors[..., 16] = t32 * t38 + t18 * t40 + t26 * t39
    minors[..., 17] = 0.0
    minors[..., 18] = 0.0
    minors[..., 19] = 0.0
    return minors.reshape(_leading + (20,))


def null_projector_position(q):
    """projector I - J^+ J onto the null space of the position Jacobian: 336 operations.

    in   q[6]
    out  null_projector[6][6]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s4 = np.sin(q4)
    s5 = np.sin(q5)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)

    # terms
    t1 = 0.07409999999999999 * c4 - 0.0098
    t2 = t1 + 0.17561406460551018 * (c5 * (0.5000000000000001 * c4) - s4 * s5) - -0.0878070323027551 * c4
    t3 = 0.41 * s2
    t4 = c2 * c3 + s2 * s3
    t5 = t3 - 0.2500816549469513 * t4
    t6 = s2 * c3 - c2 * s3
    t7 = s4 * t6
    t8 = t5 - 0.04278165494695127 * t4 - 0.07409999999999999 * t7
    t9 = c5 * (0.8660254037844386 * t4 - 0.5000000000000001 * t7) - s5 * (c4 * t6)
    t10 = 0.8660254037844386 * t7 - -0.5000000000000001 * t4
    t11 = t8 + 0.17561406460551018 * t9 - 0.10139082747347566 * t10
    t12 = t11 - t3
    t13 = 0.0098 + t2
    t14 = t4 * t13
    t15 = t2 * t2 + t11 * t11 + t12 * t12 + t14 * t14
    t16 = t11 - t8
    t17 = -0.8660254037844386 * c4
    t18 = t2 - t1
    t19 = t16 * t17 - t10 * t18
    t20 = np.sqrt((t15 + t19 * t19))
    t21 = np.where(t20 != 0.0, 1, 0.0)
    t22 = t21 / (t20 + (1 - t21))
    t23 = t2 * t22
    t24 = 0.41 * c2
    t25 = t24 + 0.2500816549469513 * t6
    t26 = s4 * t4
    t27 = t25 + 0.04278165494695127 * t6 - 0.07409999999999999 * t26
    t28 = c5 * (0.5000000000000001 * t26 + 0.8660254037844386 * t6) + s5 * (c4 * t4)
    t29 = -0.5000000000000001 * t6 + 0.8660254037844386 * t26
    t30 = t27 - 0.17561406460551018 * t28 - 0.10139082747347566 * t29
    t31 = t19 * t22
    t32 = t30 - t27
    t33 = t10 * t32 - t16 * t29
    t34 = t14 * t22
    t35 = t6 * (t11 - t5) + t4 * (t30 - t25)
    t36 = t31 * t33 - (t23 * t30 + t34 * t35)
    t37 = t30 + t23 * t36
    t38 = t33 - t31 * t36
    t39 = t11 * t22
    t40 = t36 * t39
    t41 = t12 * t22
    t42 = t36 * t41
    t43 = t35 + t34 * t36
    t44 = t23 * t37 + t39 * t40 + t41 * t42 + t34 * t43
    t45 = t31 * t38 - t44
    t46 = t37 + t23 * t45
    t47 = t40 + t39 * t45
    t48 = t42 + t41 * t45
    t49 = t43 + t34 * t45
    t50 = t46 * t46 + t47 * t47 + t48 * t48 + t49 * t49
    t51 = t38 - t31 * t45
    t52 = np.sqrt((t50 + t51 * t51))
    t53 = np.where(t52 != 0.0, 1, 0.0)
    t54 = t53 / (t52 + (1 - t53))
    t55 = t46 * t54
    t56 = t6 * t13
    t57 = t18 * t29 - t17 * t32
    t58 = t30 - t24
    t59 = t34 * t56 - t30 * t39 + t31 * t57 - t41 * t58
    t60 = t23 * t59
    t61 = t30 + t39 * t59
    t62 = t47 * t54
    t63 = t58 + t41 * t59
    t64 = t48 * t54
    t65 = t34 * t59 - t56
    t66 = t49 * t54
    t67 = t55 * t60 + t61 * t62 + t63 * t64 + t65 * t66
    t68 = t57 - t31 * t59
    t69 = t51 * t54
    t70 = t67 + t68 * t69
    t71 = t60 - t55 * t70
    t72 = t64 * t70 - t63
    t73 = t61 - t62 * t70
    t74 = t65 - t66 * t70
    t75 = t41 * t72 - (t23 * t71 + t39 * t73) - t34 * t74
    t76 = t68 - t69 * t70
    t77 = t75 + t31 * t76
    t78 = t71 + t23 * t77
    t79 = t73 + t39 * t77
    t80 = t72 - t41 * t77
    t81 = t74 + t34 * t77
    t82 = t55 * t78 + t62 * t79 - t64 * t80 + t66 * t81
    t83 = t76 - t31 * t77
    t84 = t82 + t69 * t83
    t85 = t78 - t55 * t84
    t86 = t79 - t62 * t84
    t87 = t80 + t64 * t84
    t88 = t81 - t66 * t84
    t89 = t85 * t85 + t86 * t86 + t87 * t87 + t88 * t88
    t90 = t83 - t69 * t84
    t91 = np.sqrt((t89 + t90 * t90))
    t92 = np.where(t91 != 0.0, 1, 0.0)
    t93 = t92 / (t91 + (1 - t92))
    t94 = t85 * t93
    t95 = t86 * t93
    t96 = -(t23 * t39 + t55 * t62 + t94 * t95)
    t97 = t87 * t93
    t98 = t23 * t41 + t55 * t64 - t94 * t97
    t99 = t88 * t93
    t100 = -(t23 * t34 + t55 * t66 + t94 * t99)
    t101 = t90 * t93
    t102 = t23 * t31 - t55 * t69 - t94 * t101
    t103 = t39 * t41 + t62 * t64 - t95 * t97
    t104 = -(t34 * t39 + t62 * t66 + t95 * t99)
    t105 = t31 * t39 - t62 * t69 - t95 * t101
    t106 = t34 * t41 + t64 * t66 - t97 * t99
    t107 = t64 * t69 - t31 * t41 - t97 * t101
    t108 = t31 * t34 - t66 * t69 - t99 * t101

    # results
    null_projector = np.empty((*_leading, 36), _real)
    null_projector[..., 0] = 1 - t23 * t23 - t55 * t55 - t94 * t94
    null_projector[..., 1] = t96
    null_projector[..., 2] = t98
    null_projector[..., 3] = t100
    null_projector[..., 4] = t102
    null_projector[..., 5] = 0.0
    null_projector[..., 6] = t96
    null_projector[..., 7] = 1 - t39 * t39 - t62 * t62 - t95 * t95
    null_projector[..., 8] = t103
    null_projector[..., 9] = t104
    null_projector[..., 10] = t105
    null_projector[..., 11] = 0.0
    null_projector[..., 12] = t98
    null_projector[..., 13] = t103
    null_projector[..., 14] = 1 - t41 * t41 - t64 * t64 - t97 * t97
    null_projector[..., 15] = t106
    null_projector[..., 16] = t107
    null_projector[..., 17] = 0.0
    null_projector[..., 18] = t100
    null_projector[..., 19] = t104
    null_projector[..., 20] = t106
    null_projector[..., 21] = 1 - t34 * t34 - t66 * t66 - t99 * t99
    null_projector[..., 22] = t108
    null_projector[..., 23] = 0.0
    null_projector[..., 24] = t102
    null_projector[..., 25] = t105
    null_projector[..., 26] = t107
    null_projector[..., 27] = t108
    null_projector[..., 28] = 1 - t31 * t31 - t69 * t69 - t101 * t101
    null_projector[..., 29] = 0.0
    null_projector[..., 30] = 0.0
    null_projector[..., 31] = 0.0
    null_projector[..., 32] = 0.0
    null_projector[..., 33] = 0.0
    null_projector[..., 34] = 0.0
    null_projector[..., 35] = 1
    return null_projector.reshape(_leading + (6, 6))
