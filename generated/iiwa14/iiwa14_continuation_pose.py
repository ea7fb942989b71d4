"""continuation pose of iiwa14, in NumPy.

Made from templates/kernel.py.j2; inputs 52afdf81e06041abada4d18d0b5430b44c7119945475fc1d6222f9f0024c56ba.
766 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def continuation_pose(q, held):
    """error of the pose, its Jacobian, and the null vector from its signed minors: 344 operations.

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
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    s4 = np.sin(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s3 = np.sin(q3)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
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
    t1 = c1 * s2
    t2 = c1 * c2
    t3 = c3 * t2 - s1 * s3
    t4 = c4 * t1 - s4 * t3
    t5 = -0.42 * t1
    t6 = c4 * t3 + t1 * s4
    t7 = c3 * s1 + t2 * s3
    t8 = c5 * t6 - s5 * t7
    t9 = t4 * c6 + s6 * t8
    t10 = 0.126 * t9
    t11 = 0.4 * t4 - t5 + t10
    t12 = s2 * s1
    t13 = c2 * s1
    t14 = c1 * s3 + c3 * t13
    t15 = c4 * t12 - s4 * t14
    t16 = -0.42 * t12
    t17 = c4 * t14 + s4 * t12
    t18 = c1 * c3 - s3 * t13
    t19 = c5 * t17 + s5 * t18
    t20 = c6 * t15 + s6 * t19
    t21 = 0.126 * t20
    t22 = 0.4 * t15 - t16 + t21
    t23 = 0.36 + 0.42 * c2
    t24 = s2 * c3
    t25 = c4 * c2 + s4 * t24
    t26 = s4 * c2 - c4 * t24
    t27 = s2 * s3
    t28 = c5 * t26 + s5 * t27
    t29 = c6 * t25 + s6 * t28
    t30 = 0.126 * t29
    t31 = t23 + 0.4 * t25 + t30
    t32 = 0.5 * target_10
    t33 = c6 * t28 - s6 * t25
    t34 = c5 * t27 - s5 * t26
    t35 = c7 * t33 + s7 * t34
    t36 = 0.5 * target_11
    t37 = c7 * t34 - t33 * s7
    t38 = 0.5 * target_22
    t39 = 0.5 * target_12
    t40 = t32 * t35 + t36 * t37 - t20 * t38 + t29 * t39
    t41 = 0.5 * target_20
    t42 = c6 * t19 - s6 * t15
    t43 = c5 * t18 - s5 * t17
    t44 = c7 * t42 + s7 * t43
    t45 = 0.5 * target_21
    t46 = c7 * t43 - s7 * t42
    t47 = c6 * t8 - t4 * s6
    t48 = c5 * t7 + t6 * s5
    t49 = c7 * t47 - s7 * t48
    t50 = 0.5 * target_02
    t51 = c7 * t48 + s7 * t47
    t52 = 0.5 * target_00
    t53 = t41 * t49 - t29 * t50 - t45 * t51 - t35 * t52
    t54 = 0.5 * target_01
    t55 = t44 * t52 + t46 * t54 - t9 * t39 + t20 * t50
    t56 = t31 - 0.36
    t57 = t31 - t23
    t58 = t16 + t22
    t59 = t5 + t11
    t60 = s4 * s3
    t61 = 0.4 * t60
    t62 = -0.42 - 0.4 * c4
    t63 = c4 * t61 + t60 * t62
    t64 = c4 * s3
    t65 = c6 * t60 - s6 * (c3 * s5 + c5 * t64)
    t66 = t61 + 0.126 * t65
    t67 = s4 * c3
    t68 = c4 * c3
    t69 = c6 * t67 - s6 * (c5 * t68 - s3 * s5)
    t70 = 0.4 * t67
    t71 = t70 + 0.126 * t69
    t72 = t66 * t69 - t65 * t71
    t73 = t61 * t67 - t60 * t70
    t74 = c4 * c6 + s6 * (s4 * c5)
    t75 = t62 - 0.126 * t74
    t76 = t66 * t74 + t65 * t75
    t77 = t63 * t72 - t73 * t76
    t78 = 0.42 * s3
    t79 = 0.42 * c3
    t80 = t73 * t79
    t81 = t69 * t75 + t71 * t74
    t82 = t72 * t79
    t83 = c4 * t70 + t62 * t67
    t84 = t77 * t78 - t80 * t81 + t82 * t83
    t85 = s3 * c5 + s5 * t68
    t86 = s4 * s5
    t87 = t62 * t85 - t70 * t86
    t88 = c3 * c5 - s5 * t64
    t89 = t61 * t85 + t70 * t88
    t90 = t79 * t89
    t91 = t62 * t88 + t61 * t86
    t92 = t76 * t89 + t72 * t91
    t93 = t82 * t87 - (t81 * t90 + t78 * t92)
    t94 = t73 * t91 + t63 * t89
    t95 = t78 * t94 - t80 * t87 + t83 * t90
    t96 = t81 * t94 - t83 * t92 - t77 * t87
    t97 = t84 * t85 - (t67 * t93 + t69 * t95) - s3 * t96
    t98 = s2 * t96
    t99 = s2 * t93
    t100 = s2 * t95
    t101 = s2 * t84
    t102 = c3 * t98 - t60 * t99 - t65 * t100 - t88 * t101
    t103 = c2 * t97 + c4 * t99 + t74 * t100 + t86 * t101

    # results
    error = np.empty((*_leading, 6), _real)
    jacobian = np.empty((*_leading, 42), _real)
    null_vector = np.empty((*_leading, 7), _real)
    error[..., 0] = t11 - target_03
    error[..., 1] = t22 - target_13
    error[..., 2] = t31 - target_23
    error[..., 3] = t40 - t41 * t44 - t45 * t46
    error[..., 4] = t53 - t37 * t54 + t9 * t38
    error[..., 5] = t55 - t32 * t49 + t36 * t51
    jacobian[..., 0] = -t22
    jacobian[..., 1] = c1 * t56
    jacobian[..., 2] = t12 * t57 - c2 * t58
    jacobian[..., 3] = t27 * t58 - t18 * t57
    jacobian[..., 4] = t15 * t30 - t21 * t25
    jacobian[..., 5] = t30 * t43 - t21 * t34
    jacobian[..., 6] = 0.0
    jacobian[..., 7] = t11
    jacobian[..., 8] = s1 * t56
    jacobian[..., 9] = c2 * t59 - t1 * t57
    jacobian[..., 10] = -(t7 * t57 + t27 * t59)
    jacobian[..., 11] = t10 * t25 - t4 * t30
    jacobian[..., 12] = t10 * t34 + t30 * t48
    jacobian[..., 13] = 0.0
    jacobian[..., 14] = 0.0
    jacobian[..., 15] = -(c1 * t11 + s1 * t22)
    jacobian[..., 16] = t1 * t58 - t12 * t59
    jacobian[..., 17] = t18 * t59 + t7 * t58
    jacobian[..., 18] = t4 * t21 - t10 * t15
    jacobian[..., 19] = -(t21 * t48 + t10 * t43)
    jacobian[..., 20] = 0.0
    jacobian[..., 21] = 0.0
    jacobian[..., 22] = -s1
    jacobian[..., 23] = t1
    jacobian[..., 24] = t7
    jacobian[..., 25] = t4
    jacobian[..., 26] = -t48
    jacobian[..., 27] = t9
    jacobian[..., 28] = 0.0
    jacobian[..., 29] = c1
    jacobian[..., 30] = t12
    jacobian[..., 31] = -t18
    jacobian[..., 32] = t15
    jacobian[..., 33] = t43
    jacobian[..., 34] = t20
    jacobian[..., 35] = 1
    jacobian[..., 36] = 0.0
    jacobian[..., 37] = c2
    jacobian[..., 38] = -t27
    jacobian[..., 39] = t25
    jacobian[..., 40] = t34
    jacobian[..., 41] = t29
    null_vector[..., 0] = -t97
    null_vector[..., 1] = t102
    null_vector[..., 2] = t103
    null_vector[..., 3] = t98
    null_vector[..., 4] = -t99
    null_vector[..., 5] = t101
    null_vector[..., 6] = -t100
    return error.reshape(_leading + (6,)), jacobian.reshape(_leading + (6, 7)), null_vector.reshape(_leading + (7,))


def continuation_pose_bending(q):
    """null vector of the pose Jacobian, and its derivative along itself: 422 operations.

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
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    c3 = np.cos(q3)
    q5 = q[..., 4]
    s5 = np.sin(q5)
    c5 = np.cos(q5)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)

    # terms
    t1 = s3 * s4
    t2 = 0.4 * t1
    t3 = -0.42 - 0.4 * c4
    t4 = c4 * t2 + t1 * t3
    t5 = c4 * s3
    t6 = c3 * s5 + c5 * t5
    t7 = t1 * c6 - s6 * t6
    t8 = t2 + 0.126 * t7
    t9 = s4 * c3
    t10 = c4 * c3
    t11 = c5 * t10 - s3 * s5
    t12 = c6 * t9 - s6 * t11
    t13 = 0.4 * t9
    t14 = t13 + 0.126 * t12
    t15 = t8 * t12 - t7 * t14
    t16 = t2 * t9 - t1 * t13
    t17 = s4 * c5
    t18 = c4 * c6 + s6 * t17
    t19 = t3 - 0.126 * t18
    t20 = t8 * t18 + t7 * t19
    t21 = t4 * t15 - t16 * t20
    t22 = 0.42 * s3
    t23 = 0.42 * c3
    t24 = t16 * t23
    t25 = t12 * t19 + t14 * t18
    t26 = t15 * t23
    t27 = c4 * t13 + t3 * t9
    t28 = t21 * t22 - t24 * t25 + t26 * t27
    t29 = s3 * c5 + s5 * t10
    t30 = s4 * s5
    t31 = t3 * t29 - t13 * t30
    t32 = c3 * c5 - s5 * t5
    t33 = t2 * t29 + t13 * t32
    t34 = t23 * t33
    t35 = t3 * t32 + t2 * t30
    t36 = t20 * t33 + t15 * t35
    t37 = t26 * t31 - (t25 * t34 + t22 * t36)
    t38 = t16 * t35 + t4 * t33
    t39 = t22 * t38 - t24 * t31 + t27 * t34
    t40 = t25 * t38 - t27 * t36 - t21 * t31
    t41 = t28 * t29 - (t9 * t37 + t12 * t39) - s3 * t40
    t42 = t40 * s2
    t43 = t37 * s2
    t44 = t39 * s2
    t45 = t28 * s2
    t46 = c3 * t42 - t1 * t43 - t7 * t44 - t32 * t45
    t47 = t41 * c2 + c4 * t43 + t18 * t44 + t30 * t45
    t48 = s3 * t47
    t49 = c4 * t42
    t50 = s4 * t48 - c3 * t49
    t51 = 0.42 * t48
    t52 = c3 * t47
    t53 = s4 * t52 + s3 * t49
    t54 = 0.4 * t53
    t55 = c5 * t43
    t56 = s5 * t43
    t57 = s4 * t42
    t58 = c3 * t57 + c4 * t48
    t59 = t10 * t55 - (c5 * t52 + s3 * t56) + s5 * t58
    t60 = 0.4 * t50
    t61 = c4 * t52 - s3 * t57
    t62 = c3 * t56 - c5 * t48 + t5 * t55 - s5 * t61
    t63 = t29 * t54 - t2 * t59 - t32 * t60 + t13 * t62
    t64 = t33 * t51 - t23 * t63
    t65 = -0.4 * t57
    t66 = c6 * t45
    t67 = s6 * t45
    t68 = t17 * t66 - (c4 * t67 + c6 * t57) + s6 * (c5 * t49 + s4 * t56)
    t69 = t65 + 0.126 * t68
    t70 = c5 * t61 - c3 * t55 - s5 * t48 + t5 * t56
    t71 = c6 * t53 - t1 * t67 - t6 * t66 - s6 * t70
    t72 = t54 + 0.126 * t71
    t73 = t7 * t69 - (t18 * t72 + t8 * t68) - t19 * t71
    t74 = s5 * t49 - s4 * t55
    t75 = t3 * t62 - t32 * t65 + t30 * t54 + t2 * t74
    t76 = t10 * t56 - c5 * t58 - s5 * t52 + s3 * t55
    t77 = c6 * t50 + t9 * t67 + t11 * t66 + s6 * t76
    t78 = t60 + 0.126 * t77
    t79 = t7 * t78 - t14 * t71 + t12 * t72 - t8 * t77
    t80 = t33 * t73 - t20 * t63 - t15 * t75 - t35 * t79
    t81 = 0.42 * t52
    t82 = t14 * t68 - (t12 * t69 + t19 * t77 + t18 * t78)
    t83 = t25 * t64 + t22 * t80 - t36 * t81 - t34 * t82
    t84 = t15 * t51 - t23 * t79
    t85 = t30 * t60 - t13 * t74 - t29 * t65 - t3 * t59
    t86 = t83 - t31 * t84 + t26 * t85
    t87 = t9 * t54 - t2 * t50 + t1 * t60 - t13 * t53
    t88 = t16 * t51 - t23 * t87
    t89 = t2 * t57 - c4 * t54 + t1 * t65 - t3 * t53
    t90 = t35 * t87 + t16 * t75 - t33 * t89 + t4 * t63
    t91 = t31 * t88 + t22 * t90 + t38 * t81 - t24 * t85
    t92 = c4 * t60 + t13 * t57 + t9 * t65 + t3 * t50
    t93 = t91 - t27 * t64 - t34 * t92
    t94 = t16 * t73 - t20 * t87 - t15 * t89 + t4 * t79
    t95 = t25 * t88 + t22 * t94 + t21 * t81 - t24 * t82
    t96 = t95 - t27 * t84 - t26 * t92
    t97 = t37 * t50 - t9 * t86 - t12 * t93 + t29 * t96
    t98 = t25 * t90 + t27 * t80 + t36 * t92 + t38 * t82
    t99 = t98 - t31 * t94 - t21 * t85
    t100 = t97 - s3 * t99 - t40 * t52 - t28 * t59 + t39 * t77
    t101 = t46 * c2
    t102 = s2 * t99 + t40 * t101
    t103 = s2 * t86 + t37 * t101
    t104 = c3 * t102 - t42 * t48 - t1 * t103 - t43 * t53
    t105 = s2 * t93 + t39 * t101
    t106 = s2 * t96 + t28 * t101
    t107 = t104 - t7 * t105 - t32 * t106 - t45 * t62 - t44 * t71
    t108 = t41 * (s2 * t46) - (c2 * t100 + c4 * t103) + t43 * t57
    t109 = t108 - t18 * t105 - t30 * t106 - t45 * t74 - t44 * t68

    # results
    null_vector = np.empty((*_leading, 7), _real)
    bending = np.empty((*_leading, 7), _real)
    null_vector[..., 0] = -t41
    null_vector[..., 1] = t46
    null_vector[..., 2] = t47
    null_vector[..., 3] = t42
    null_vector[..., 4] = -t43
    null_vector[..., 5] = t45
    null_vector[..., 6] = -t44
    bending[..., 0] = -t100
    bending[..., 1] = t107
    bending[..., 2] = -t109
    bending[..., 3] = t102
    bending[..., 4] = -t103
    bending[..., 5] = t106
    bending[..., 6] = -t105
    return null_vector.reshape(_leading + (7,)), bending.reshape(_leading + (7,))
