"""continuation pose of panda, in NumPy.

Made from templates/kernel.py.j2; inputs ffe24ac4057667bc0fdb3af44247cd0fc4e294e285c56b3e8e7834d10a9992fb.
911 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def continuation_pose(q, held):
    """error of the pose, its Jacobian, and the null vector from its signed minors: 412 operations.

    in   q[7]
    in   held[4][4] = (target_00, target_01, target_02, target_03, target_10, target_11, target_12, target_13, target_20, target_21, target_22, target_23, target_30, target_31, target_32, target_33)
    out  error[6]
    out  jacobian[6][7]
    out  null_vector[7]
    """
    q = np.asarray(q)
    held = np.asarray(held)
    held = held.reshape(held.shape[:-2] + (16,))
    _leading = np.broadcast_shapes(q.shape[:-1], held.shape[:-1])
    _real = np.result_type(q, held, np.float32)

    # inputs, sines and cosines
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s3 = np.sin(q3)
    s2 = np.sin(q2)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    s6 = np.sin(q6)
    target_03 = held[..., 3]
    target_13 = held[..., 7]
    target_23 = held[..., 11]
    target_10 = held[..., 4]
    q7 = q[..., 6]
    c7 = np.cos(q7)
    s7 = np.sin(q7)
    target_11 = held[..., 5]
    target_22 = held[..., 10]
    target_12 = held[..., 6]
    target_20 = held[..., 8]
    target_21 = held[..., 9]
    target_02 = held[..., 2]
    target_00 = held[..., 0]
    target_01 = held[..., 1]

    # terms
    t1 = c1 * c2
    t2 = c3 * t1 - s1 * s3
    t3 = c1 * s2
    t4 = -0.316 * t3
    t5 = 0.0825 * t2 - t4
    t6 = t3 * c4 - t2 * s4
    t7 = t2 * c4 + t3 * s4
    t8 = t5 + 0.384 * t6 - 0.0825 * t7
    t9 = c3 * s1 + t1 * s3
    t10 = t7 * c5 - s5 * t9
    t11 = c6 * t10 + t6 * s6
    t12 = t8 + 0.088 * t11
    t13 = t6 * c6 - t10 * s6
    t14 = t12 - 0.107 * t13
    t15 = c2 * s1
    t16 = c1 * s3 + c3 * t15
    t17 = s1 * s2
    t18 = -0.316 * t17
    t19 = 0.0825 * t16 - t18
    t20 = c4 * t17 - s4 * t16
    t21 = c4 * t16 + s4 * t17
    t22 = t19 + 0.384 * t20 - 0.0825 * t21
    t23 = c3 * c1 - s3 * t15
    t24 = c5 * t21 + s5 * t23
    t25 = c6 * t24 + s6 * t20
    t26 = t22 + 0.088 * t25
    t27 = c6 * t20 - s6 * t24
    t28 = t26 - 0.107 * t27
    t29 = 0.333 + 0.316 * c2
    t30 = c3 * s2
    t31 = t29 - 0.0825 * t30
    t32 = c2 * c4 + s4 * t30
    t33 = c2 * s4 - c4 * t30
    t34 = t31 + 0.384 * t32 - 0.0825 * t33
    t35 = s3 * s2
    t36 = c5 * t33 + s5 * t35
    t37 = c6 * t36 + s6 * t32
    t38 = t34 + 0.088 * t37
    t39 = c6 * t32 - s6 * t36
    t40 = t38 - 0.107 * t39
    t41 = 0.5 * target_10
    t42 = c5 * t35 - s5 * t33
    t43 = t37 * c7 - s7 * t42
    t44 = 0.5 * target_11
    t45 = c7 * t42 + t37 * s7
    t46 = 0.5 * target_22
    t47 = 0.5 * target_12
    t48 = t41 * t43 - t44 * t45 + t27 * t46 - t39 * t47
    t49 = 0.5 * target_20
    t50 = c5 * t23 - s5 * t21
    t51 = t25 * c7 - s7 * t50
    t52 = 0.5 * target_21
    t53 = c7 * t50 + t25 * s7
    t54 = 0.5 * target_02
    t55 = c5 * t9 + t7 * s5
    t56 = t11 * c7 + s7 * t55
    t57 = c7 * t55 - t11 * s7
    t58 = 0.5 * target_00
    t59 = t39 * t54 + t49 * t56 + t52 * t57 - t43 * t58
    t60 = 0.5 * target_01
    t61 = t51 * t58 - t53 * t60 + t13 * t47 - t27 * t54
    t62 = t40 - 0.333
    t63 = t40 - t29
    t64 = t18 + t28
    t65 = t28 - t19
    t66 = t40 - t31
    t67 = t40 - t34
    t68 = t28 - t22
    t69 = t28 - t26
    t70 = t40 - t38
    t71 = t4 + t14
    t72 = t14 - t5
    t73 = t14 - t8
    t74 = t14 - t12
    t75 = 0.0825 * s3
    t76 = s3 * s4
    t77 = s3 * c4
    t78 = t75 - 0.384 * t76 - 0.0825 * t77
    t79 = 0.0825 * s4 - 0.316 - 0.384 * c4
    t80 = c4 * t78 - t76 * t79
    t81 = 0.0825 * c3
    t82 = c3 * s4
    t83 = c3 * c4
    t84 = t81 - 0.384 * t82 - 0.0825 * t83
    t85 = c3 * c5 - s5 * t77
    t86 = s3 * c5 + s5 * t83
    t87 = t84 * t85 + t78 * t86
    t88 = t76 * t84 - t78 * t82
    t89 = s4 * s5
    t90 = t78 * t89 - t79 * t85
    t91 = t80 * t87 - t88 * t90
    t92 = 0.316 * s3
    t93 = 0.316 * c3
    t94 = c3 * t81 + s3 * t75
    t95 = t88 * t93 - t80 * t94
    t96 = t79 * t86 + t84 * t89
    t97 = t87 * t93 - t90 * t94
    t98 = t79 * t82 - c4 * t84
    t99 = t91 * t92 - t95 * t96 - t97 * t98
    t100 = c5 * t83 - s3 * s5
    t101 = c6 * t82 + s6 * t100
    t102 = c3 * s5 + c5 * t77
    t103 = t78 + 0.088 * (c6 * t102 - s6 * t76)
    t104 = t84 + 0.088 * (c6 * t100 - s6 * t82)
    t105 = c6 * t76 + s6 * t102
    t106 = t101 * t103 - t104 * t105
    t107 = s4 * c5
    t108 = s6 * t107 - c4 * c6
    t109 = t79 - 0.088 * (c6 * t107 + c4 * s6)
    t110 = t103 * t108 + t105 * t109
    t111 = t80 * t106 - t88 * t110
    t112 = t101 * t109 + t104 * t108
    t113 = t93 * t106 - t94 * t110
    t114 = t92 * t111 - t95 * t112 - t98 * t113
    t115 = t90 * t106 - t87 * t110
    t116 = t92 * t115 - t97 * t112 + t96 * t113
    t117 = t98 * t115 - t91 * t112 + t96 * t111
    t118 = t99 * t101 - (t86 * t114 + t82 * t116) - s3 * t117
    t119 = s2 * t117
    t120 = s2 * t114
    t121 = s2 * t116
    t122 = s2 * t99
    t123 = c3 * t119 + t85 * t120 - t76 * t121 + t105 * t122
    t124 = t89 * t120 - c2 * t118 - c4 * t121 - t108 * t122

    # results
    error = np.empty((*_leading, 6), _real)
    jacobian = np.empty((*_leading, 42), _real)
    null_vector = np.empty((*_leading, 7), _real)
    error[..., 0] = t14 - target_03
    error[..., 1] = t28 - target_13
    error[..., 2] = t40 - target_23
    error[..., 3] = t48 - t49 * t51 + t52 * t53
    error[..., 4] = t59 + t45 * t60 - t13 * t46
    error[..., 5] = t61 - t41 * t56 - t44 * t57
    jacobian[..., 0] = -t28
    jacobian[..., 1] = c1 * t62
    jacobian[..., 2] = t17 * t63 - c2 * t64
    jacobian[..., 3] = t35 * t65 - t23 * t66
    jacobian[..., 4] = t20 * t67 - t32 * t68
    jacobian[..., 5] = t42 * t68 - t50 * t67
    jacobian[..., 6] = t39 * t69 - t27 * t70
    jacobian[..., 7] = t14
    jacobian[..., 8] = s1 * t62
    jacobian[..., 9] = c2 * t71 - t3 * t63
    jacobian[..., 10] = -(t9 * t66 + t35 * t72)
    jacobian[..., 11] = t32 * t73 - t6 * t67
    jacobian[..., 12] = -(t55 * t67 + t42 * t73)
    jacobian[..., 13] = t13 * t70 - t39 * t74
    jacobian[..., 14] = 0.0
    jacobian[..., 15] = -(c1 * t14 + s1 * t28)
    jacobian[..., 16] = t3 * t64 - t17 * t71
    jacobian[..., 17] = t23 * t72 + t9 * t65
    jacobian[..., 18] = t6 * t68 - t20 * t73
    jacobian[..., 19] = t50 * t73 + t55 * t68
    jacobian[..., 20] = t27 * t74 - t13 * t69
    jacobian[..., 21] = 0.0
    jacobian[..., 22] = -s1
    jacobian[..., 23] = t3
    jacobian[..., 24] = t9
    jacobian[..., 25] = t6
    jacobian[..., 26] = t55
    jacobian[..., 27] = -t13
    jacobian[..., 28] = 0.0
    jacobian[..., 29] = c1
    jacobian[..., 30] = t17
    jacobian[..., 31] = -t23
    jacobian[..., 32] = t20
    jacobian[..., 33] = -t50
    jacobian[..., 34] = -t27
    jacobian[..., 35] = 1
    jacobian[..., 36] = 0.0
    jacobian[..., 37] = c2
    jacobian[..., 38] = -t35
    jacobian[..., 39] = t32
    jacobian[..., 40] = -t42
    jacobian[..., 41] = -t39
    null_vector[..., 0] = t118
    null_vector[..., 1] = -t123
    null_vector[..., 2] = t124
    null_vector[..., 3] = -t119
    null_vector[..., 4] = t121
    null_vector[..., 5] = -t120
    null_vector[..., 6] = t122
    return error.reshape(_leading + (6,)), jacobian.reshape(_leading + (6, 7)), null_vector.reshape(_leading + (7,))


def continuation_pose_bending(q):
    """null vector of the pose Jacobian, and its derivative along itself: 499 operations.

    in   q[7]
    out  null_vector[7]
    out  bending[7]
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
    t51 = c4 * t45
    t52 = s3 * t50
    t53 = c3 * t51 + s4 * t52
    t54 = c3 * t50
    t55 = 0.0825 * t54
    t56 = s3 * t51 - s4 * t54
    t57 = s4 * t45
    t58 = c4 * t54 + s3 * t57
    t59 = t55 + 0.384 * t56 - 0.0825 * t58
    t60 = 0.0825 * t51 + 0.384 * t57
    t61 = c4 * t59 + t4 * t57 + t2 * t60 + t5 * t56
    t62 = s6 * t46
    t63 = c6 * t46
    t64 = c5 * t47
    t65 = s5 * t47
    t66 = c3 * t64 + c5 * t58 - s5 * t52 - t3 * t65
    t67 = c6 * t56 - t2 * t62 + t28 * t63 - s6 * t66
    t68 = 0.0825 * t52
    t69 = c3 * t57 - c4 * t52
    t70 = 0.384 * t53 - t68 - 0.0825 * t69
    t71 = c5 * t69 - t9 * t65 - s5 * t54 - s3 * t64
    t72 = c6 * t71 + t26 * t62 + t8 * t63 + s6 * t53
    t73 = t70 + 0.088 * t72
    t74 = c6 * t66 + t28 * t62 + t2 * t63 + s6 * t56
    t75 = t59 + 0.088 * t74
    t76 = c6 * t53 - t8 * t62 + t26 * t63 - s6 * t71
    t77 = t30 * t67 - t31 * t73 + t27 * t75 - t29 * t76
    t78 = t4 * t53 - t8 * t59 + t2 * t70 - t10 * t56
    t79 = c5 * t51 + s4 * t65
    t80 = c4 * t62 + c6 * t57 + t33 * t63 + s6 * t79
    t81 = c6 * t79 - t33 * t62 + c4 * t63 - s6 * t57
    t82 = 0.088 * t81 - t60
    t83 = t34 * t75 - t29 * t80 + t31 * t82 - t35 * t67
    t84 = t32 * t61 + t6 * t77 - t36 * t78 - t14 * t83
    t85 = 0.316 * t52
    t86 = s3 * t55 - (c3 * t68 + t7 * t52) + t1 * t54
    t87 = t19 * t78 - t14 * t85 - t6 * t86 - t20 * t61
    t88 = 0.316 * t54
    t89 = t35 * t76 - t27 * t82 - t34 * t73 + t30 * t80
    t90 = t18 * t84 - t38 * t87 + t37 * t88 + t21 * t89
    t91 = t19 * t77 - t32 * t85 - t36 * t86 - t20 * t83
    t92 = c4 * t70 + t10 * t57 + t8 * t60 + t5 * t53
    t93 = t90 - t24 * t91 + t39 * t92
    t94 = s4 * t64 - s5 * t51
    t95 = c3 * t65 + c5 * t52 + t3 * t64 + s5 * t58
    t96 = t15 * t59 + t4 * t94 + t11 * t60 + t5 * t95
    t97 = s3 * t65 - c5 * t54 - t9 * t64 - s5 * t69
    t98 = t11 * t70 - t10 * t95 + t12 * t59 - t4 * t97
    t99 = t32 * t96 + t16 * t77 - t36 * t98 - t13 * t83
    t100 = t19 * t98 - t13 * t85 - t16 * t86 - t20 * t96
    t101 = t18 * t99 - t38 * t100 + t41 * t88 + t23 * t89
    t102 = t12 * t60 + t5 * t97 - t15 * t70 - t10 * t94
    t103 = t101 + t22 * t91 - t39 * t102
    t104 = t42 * t53 - (t12 * t93 + t8 * t103) + t40 * t97
    t105 = t13 * t61 + t6 * t98 - t16 * t78 - t14 * t96
    t106 = t18 * t105 - t22 * t87 + t17 * t88 + t21 * t102
    t107 = t106 - t24 * t100 + t23 * t92
    t108 = t24 * t99 - t38 * t105 - t41 * t92 + t17 * t89
    t109 = t108 + t22 * t84 - t37 * t102
    t110 = t104 + t27 * t107 - s3 * t109 - t43 * t54 - t25 * t76
    t111 = t49 * c2
    t112 = s2 * t109 - t43 * t111
    t113 = s2 * t93 - t40 * t111
    t114 = s2 * t103 - t42 * t111
    t115 = c3 * t112 - t45 * t52 + t11 * t113 - t2 * t114
    t116 = s2 * t107 - t25 * t111
    t117 = t115 + t47 * t56 - t46 * t95 + t31 * t116 - t48 * t67
    t118 = t15 * t113 + t46 * t94 - c2 * t110 - c4 * t114
    t119 = t118 - t44 * (s2 * t49) - t47 * t57 - t34 * t116

    # results
    null_vector = np.empty((*_leading, 7), _real)
    bending = np.empty((*_leading, 7), _real)
    null_vector[..., 0] = t44
    null_vector[..., 1] = -t49
    null_vector[..., 2] = t50
    null_vector[..., 3] = -t45
    null_vector[..., 4] = t47
    null_vector[..., 5] = -t46
    null_vector[..., 6] = t48
    bending[..., 0] = t110
    bending[..., 1] = -t117
    bending[..., 2] = t119 + t48 * t80
    bending[..., 3] = -t112
    bending[..., 4] = t114
    bending[..., 5] = -t113
    bending[..., 6] = t116
    return null_vector.reshape(_leading + (7,)), bending.reshape(_leading + (7,))
