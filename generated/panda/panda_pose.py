"""manipulability (pose) of panda, in NumPy.

Made from templates/kernel.py.j2; inputs 1768599b615dec895cc045d4e3d496b96131cfaed335c61f8c29f03016acd38a.
2645 operations. Do not edit: change the derivation and regenerate.

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
    """projector I - J^+ J onto the null space of the pose Jacobian: 1594 operations.

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
    t22 = t3 / t21
    t23 = t9 / t21
    t24 = t12 / t21
    t25 = t19 / t21
    t26 = t22 * t22 + t23 * t23 + t24 * t24 + t25 * t25
    t27 = np.sqrt(np.where(t21 != 0.0, np.where(t21 != 0.0, t26, 0.0), 0.0))
    t28 = t22 / t27
    t29 = t23 / t27
    t30 = c3 * s4
    t31 = t24 / t27
    t32 = np.where(t21 != 0.0, np.where(t27 != 0.0, s3 * t28 - t29 * t30, 0.0), 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, -(t2 * t31), 0.0), 0.0)
    t33 = t25 / t27
    t34 = c5 * t1 - s3 * s5
    t35 = c6 * t30 + s6 * t34
    t36 = t32 - np.where(t21 != 0.0, np.where(t27 != 0.0, -(t33 * t35), 0.0), 0.0)
    t37 = t2 - np.where(t21 != 0.0, np.where(t27 != 0.0, t31 * t36, 0.0), 0.0)
    t38 = 0.0825 * c3
    t39 = c3 * t38 + s3 * t4
    t40 = t38 - 0.384 * t30 - 0.0825 * t1
    t41 = t5 * t40 - t7 * t30
    t42 = t11 * t40 + t2 * t7
    t43 = t40 + 0.088 * (c6 * t34 - s6 * t30)
    t44 = t14 * t35 - t18 * t43
    t45 = t28 * t39 + t29 * t41 + t31 * t42 + t33 * t44
    t46 = t39 - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t28 * t45, 0.0), 0.0), 0.0), 0.0)
    t47 = t41 - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t29 * t45, 0.0), 0.0), 0.0), 0.0)
    t48 = t42 - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t31 * t45, 0.0), 0.0), 0.0), 0.0)
    t49 = t44 - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t33 * t45, 0.0), 0.0), 0.0), 0.0)
    t50 = t46 * t46 + t47 * t47 + t48 * t48 + t49 * t49
    t51 = np.sqrt(t50)
    t52 = t46 / t51
    t53 = t47 / t51
    t54 = t48 / t51
    t55 = t49 / t51
    t56 = t28 * t52 + t29 * t53 + t31 * t54 + t33 * t55
    t57 = np.where(t51 != 0.0, t52, 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t51 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t28 * t56, 0.0), 0.0), 0.0), 0.0), 0.0)
    t58 = np.where(t51 != 0.0, t53, 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t51 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t29 * t56, 0.0), 0.0), 0.0), 0.0), 0.0)
    t59 = np.where(t51 != 0.0, t54, 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t51 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t31 * t56, 0.0), 0.0), 0.0), 0.0), 0.0)
    t60 = np.where(t51 != 0.0, t55, 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t51 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t33 * t56, 0.0), 0.0), 0.0), 0.0), 0.0)
    t61 = t57 * t57 + t58 * t58 + t59 * t59 + t60 * t60
    t62 = np.sqrt(t61)
    t63 = s3 - np.where(t21 != 0.0, np.where(t27 != 0.0, t28 * t36, 0.0), 0.0)
    t64 = t57 / t62
    t65 = t30 + np.where(t21 != 0.0, np.where(t27 != 0.0, t29 * t36, 0.0), 0.0)
    t66 = t58 / t62
    t67 = t59 / t62
    t68 = t35 - np.where(t21 != 0.0, np.where(t27 != 0.0, t33 * t36, 0.0), 0.0)
    t69 = t60 / t62
    t70 = t63 * t64 - t65 * t66 + t37 * t67 + t68 * t69
    t71 = t37 - np.where(t62 != 0.0, np.where(t62 != 0.0, t67 * t70, 0.0), 0.0)
    t72 = 0.316 * s3
    t73 = t8 * t30 - c4 * t40
    t74 = t2 * t8 + t10 * t40
    t75 = t17 * t35 + t16 * t43
    t76 = t28 * t72 + t29 * t73 - t31 * t74 - t33 * t75
    t77 = t72 - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t28 * t76, 0.0), 0.0), 0.0), 0.0)
    t78 = t73 - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t29 * t76, 0.0), 0.0), 0.0), 0.0)
    t79 = t74 + np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t31 * t76, 0.0), 0.0), 0.0), 0.0)
    t80 = t75 + np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t33 * t76, 0.0), 0.0), 0.0), 0.0)
    t81 = t64 * t77 + t66 * t78 - t67 * t79 - t69 * t80
    t82 = t77 - np.where(t62 != 0.0, np.where(t62 != 0.0, t64 * t81, 0.0), 0.0)
    t83 = t78 - np.where(t62 != 0.0, np.where(t62 != 0.0, t66 * t81, 0.0), 0.0)
    t84 = t79 + np.where(t62 != 0.0, np.where(t62 != 0.0, t67 * t81, 0.0), 0.0)
    t85 = t80 + np.where(t62 != 0.0, np.where(t62 != 0.0, t69 * t81, 0.0), 0.0)
    t86 = t82 * t82 + t83 * t83 + t84 * t84 + t85 * t85
    t87 = np.sqrt(t86)
    t88 = t82 / t87
    t89 = t83 / t87
    t90 = t84 / t87
    t91 = t85 / t87
    t92 = t28 * t88 + t29 * t89 - t31 * t90 - t33 * t91
    t93 = np.where(t87 != 0.0, t88, 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t87 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t28 * t92, 0.0), 0.0), 0.0), 0.0), 0.0)
    t94 = np.where(t87 != 0.0, t89, 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t87 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t29 * t92, 0.0), 0.0), 0.0), 0.0), 0.0)
    t95 = np.where(t87 != 0.0, -t90, 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t87 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t31 * t92, 0.0), 0.0), 0.0), 0.0), 0.0)
    t96 = np.where(t87 != 0.0, -t91, 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t87 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t33 * t92, 0.0), 0.0), 0.0), 0.0), 0.0)
    t97 = t64 * t93 + t66 * t94 + t67 * t95 + t69 * t96
    t98 = t93 - np.where(t62 != 0.0, np.where(t62 != 0.0, t64 * t97, 0.0), 0.0)
    t99 = t94 - np.where(t62 != 0.0, np.where(t62 != 0.0, t66 * t97, 0.0), 0.0)
    t100 = t95 - np.where(t62 != 0.0, np.where(t62 != 0.0, t67 * t97, 0.0), 0.0)
    t101 = t96 - np.where(t62 != 0.0, np.where(t62 != 0.0, t69 * t97, 0.0), 0.0)
    t102 = t98 * t98 + t99 * t99 + t100 * t100 + t101 * t101
    t103 = np.sqrt(t102)
    t104 = t63 - np.where(t62 != 0.0, np.where(t62 != 0.0, t64 * t70, 0.0), 0.0)
    t105 = t98 / t103
    t106 = t65 + np.where(t62 != 0.0, np.where(t62 != 0.0, t66 * t70, 0.0), 0.0)
    t107 = t99 / t103
    t108 = t100 / t103
    t109 = t68 - np.where(t62 != 0.0, np.where(t62 != 0.0, t69 * t70, 0.0), 0.0)
    t110 = t101 / t103
    t111 = t104 * t105 - t106 * t107 + t71 * t108 + t109 * t110
    t112 = t71 - np.where(t103 != 0.0, np.where(t103 != 0.0, t108 * t111, 0.0), 0.0)
    t113 = t109 - np.where(t103 != 0.0, np.where(t103 != 0.0, t110 * t111, 0.0), 0.0)
    t114 = t104 - np.where(t103 != 0.0, np.where(t103 != 0.0, t105 * t111, 0.0), 0.0)
    t115 = t106 + np.where(t103 != 0.0, np.where(t103 != 0.0, t107 * t111, 0.0), 0.0)
    t116 = t112 * t112 + t113 * t113 + t114 * t114 + t115 * t115
    t117 = np.sqrt((t116 + s2 * s2))
    t118 = t112 / t117
    t119 = t114 / t117
    t120 = t115 / t117
    t121 = t113 / t117
    t122 = t28 * t119 - t29 * t120 + t31 * t118 + t33 * t121
    t123 = np.where(t117 != 0.0, t118, 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t117 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t31 * t122, 0.0), 0.0), 0.0), 0.0), 0.0)
    t124 = np.where(t117 != 0.0, t119, 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t117 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t28 * t122, 0.0), 0.0), 0.0), 0.0), 0.0)
    t125 = np.where(t117 != 0.0, -t120, 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t117 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t29 * t122, 0.0), 0.0), 0.0), 0.0), 0.0)
    t126 = np.where(t117 != 0.0, t121, 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t117 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t33 * t122, 0.0), 0.0), 0.0), 0.0), 0.0)
    t127 = t64 * t124 + t66 * t125 + t67 * t123 + t69 * t126
    t128 = t123 - np.where(t62 != 0.0, np.where(t62 != 0.0, t67 * t127, 0.0), 0.0)
    t129 = t124 - np.where(t62 != 0.0, np.where(t62 != 0.0, t64 * t127, 0.0), 0.0)
    t130 = t125 - np.where(t62 != 0.0, np.where(t62 != 0.0, t66 * t127, 0.0), 0.0)
    t131 = t126 - np.where(t62 != 0.0, np.where(t62 != 0.0, t69 * t127, 0.0), 0.0)
    t132 = t105 * t129 + t107 * t130 + t108 * t128 + t110 * t131
    t133 = t128 - np.where(t103 != 0.0, np.where(t103 != 0.0, t108 * t132, 0.0), 0.0)
    t134 = t131 - np.where(t103 != 0.0, np.where(t103 != 0.0, t110 * t132, 0.0), 0.0)
    t135 = t129 - np.where(t103 != 0.0, np.where(t103 != 0.0, t105 * t132, 0.0), 0.0)
    t136 = t130 - np.where(t103 != 0.0, np.where(t103 != 0.0, t107 * t132, 0.0), 0.0)
    t137 = t133 * t133 + t134 * t134 + t135 * t135 + t136 * t136
    t138 = np.where(t117 != 0.0, s2 / t117, 0.0)
    t139 = np.sqrt((t137 + t138 * t138))
    t140 = t138 / t139
    t141 = c4 * t29 + t10 * t31 + t16 * t33
    t142 = t10 + np.where(t21 != 0.0, np.where(t27 != 0.0, -np.where(t21 != 0.0, np.where(t27 != 0.0, t31 * t141, 0.0), 0.0), 0.0), 0.0)
    t143 = t28 * t141
    t144 = c4 + np.where(t21 != 0.0, np.where(t27 != 0.0, -np.where(t21 != 0.0, np.where(t27 != 0.0, t29 * t141, 0.0), 0.0), 0.0), 0.0)
    t145 = np.where(t21 != 0.0, np.where(t27 != 0.0, -np.where(t21 != 0.0, np.where(t27 != 0.0, t64 * t143, 0.0), 0.0), 0.0), 0.0) + t66 * t144
    t146 = t16 + np.where(t21 != 0.0, np.where(t27 != 0.0, -np.where(t21 != 0.0, np.where(t27 != 0.0, t33 * t141, 0.0), 0.0), 0.0), 0.0)
    t147 = t145 + t67 * t142 + t69 * t146
    t148 = t142 + np.where(t62 != 0.0, np.where(t62 != 0.0, -(t67 * t147), 0.0), 0.0)
    t149 = np.where(t21 != 0.0, np.where(t27 != 0.0, -np.where(t21 != 0.0, np.where(t27 != 0.0, t143, 0.0), 0.0), 0.0), 0.0) + np.where(t62 != 0.0, np.where(t62 != 0.0, -(t64 * t147), 0.0), 0.0)
    t150 = t144 + np.where(t62 != 0.0, np.where(t62 != 0.0, -(t66 * t147), 0.0), 0.0)
    t151 = t146 + np.where(t62 != 0.0, np.where(t62 != 0.0, -(t69 * t147), 0.0), 0.0)
    t152 = t105 * t149 + t107 * t150 + t108 * t148 + t110 * t151
    t153 = t148 + np.where(t103 != 0.0, np.where(t103 != 0.0, -(t108 * t152), 0.0), 0.0)
    t154 = t133 / t139
    t155 = t151 + np.where(t103 != 0.0, np.where(t103 != 0.0, -(t110 * t152), 0.0), 0.0)
    t156 = t134 / t139
    t157 = t149 + np.where(t103 != 0.0, np.where(t103 != 0.0, -(t105 * t152), 0.0), 0.0)
    t158 = t135 / t139
    t159 = t150 + np.where(t103 != 0.0, np.where(t103 != 0.0, -(t107 * t152), 0.0), 0.0)
    t160 = t136 / t139
    t161 = t153 * t154 + t155 * t156 + t157 * t158 + t159 * t160
    t162 = np.where(t139 != 0.0, -t161, 0.0) - np.where(t139 != 0.0, -(t140 * c2), 0.0)
    t163 = c2 + np.where(t139 != 0.0, -(t140 * t162), 0.0)
    t164 = t157 + np.where(t139 != 0.0, t158 * t162, 0.0)
    t165 = t159 + np.where(t139 != 0.0, t160 * t162, 0.0)
    t166 = t153 + np.where(t139 != 0.0, t154 * t162, 0.0)
    t167 = 1 + t163 * t163 + t164 * t164 + t165 * t165 + t166 * t166
    t168 = t155 + np.where(t139 != 0.0, t156 * t162, 0.0)
    t169 = np.sqrt((t167 + t168 * t168))
    t170 = 1 / t169
    t171 = t163 / t169
    t172 = t166 / t169
    t173 = t164 / t169
    t174 = t165 / t169
    t175 = t168 / t169
    t176 = t28 * t173 + t29 * t174 + t31 * t172 + t33 * t175
    t177 = np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t169 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, -(t31 * t176), 0.0), 0.0), 0.0), 0.0), 0.0)
    t178 = np.where(t169 != 0.0, -t172, 0.0) - t177
    t179 = np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t169 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, -(t28 * t176), 0.0), 0.0), 0.0), 0.0), 0.0)
    t180 = np.where(t169 != 0.0, -t173, 0.0) - t179
    t181 = np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t169 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, -(t29 * t176), 0.0), 0.0), 0.0), 0.0), 0.0)
    t182 = np.where(t169 != 0.0, -t174, 0.0) - t181
    t183 = np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t169 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, -(t33 * t176), 0.0), 0.0), 0.0), 0.0), 0.0)
    t184 = np.where(t169 != 0.0, -t175, 0.0) - t183
    t185 = t64 * t180 + t66 * t182 + t67 * t178 + t69 * t184
    t186 = t178 - np.where(t62 != 0.0, np.where(t62 != 0.0, t67 * t185, 0.0), 0.0)
    t187 = t180 - np.where(t62 != 0.0, np.where(t62 != 0.0, t64 * t185, 0.0), 0.0)
    t188 = t182 - np.where(t62 != 0.0, np.where(t62 != 0.0, t66 * t185, 0.0), 0.0)
    t189 = t184 - np.where(t62 != 0.0, np.where(t62 != 0.0, t69 * t185, 0.0), 0.0)
    t190 = t105 * t187 + t107 * t188 + t108 * t186 + t110 * t189
    t191 = t186 - np.where(t103 != 0.0, np.where(t103 != 0.0, t108 * t190, 0.0), 0.0)
    t192 = t189 - np.where(t103 != 0.0, np.where(t103 != 0.0, t110 * t190, 0.0), 0.0)
    t193 = t187 - np.where(t103 != 0.0, np.where(t103 != 0.0, t105 * t190, 0.0), 0.0)
    t194 = t188 - np.where(t103 != 0.0, np.where(t103 != 0.0, t107 * t190, 0.0), 0.0)
    t195 = t154 * t191 + t156 * t192 + t158 * t193 + t160 * t194
    t196 = np.where(t139 != 0.0, t195, 0.0) + np.where(t169 != 0.0, np.where(t139 != 0.0, t140 * t171, 0.0), 0.0)
    t197 = np.where(t169 != 0.0, -t171, 0.0) - np.where(t139 != 0.0, -(t140 * t196), 0.0)
    t198 = t193 - np.where(t139 != 0.0, t158 * t196, 0.0)
    t199 = np.where(t169 != 0.0, np.where(t169 != 0.0, t170 * t170, 0.0), 0.0) + t197 * t197 + t198 * t198
    t200 = t194 - np.where(t139 != 0.0, t160 * t196, 0.0)
    t201 = t191 - np.where(t139 != 0.0, t154 * t196, 0.0)
    t202 = t192 - np.where(t139 != 0.0, t156 * t196, 0.0)
    t203 = np.sqrt((t199 + t200 * t200 + t201 * t201 + t202 * t202))
    t204 = t197 / t203
    t205 = 1 - np.where(t139 != 0.0, np.where(t139 != 0.0, t140 * t140, 0.0), 0.0) - np.where(t203 != 0.0, np.where(t203 != 0.0, t204 * t204, 0.0), 0.0)
    t206 = np.where(t21 != 0.0, np.where(t27 != 0.0, -(t5 * t29), 0.0), 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, c3 * t28, 0.0), 0.0)
    t207 = t206 - np.where(t21 != 0.0, np.where(t27 != 0.0, t11 * t31, 0.0), 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, -(t18 * t33), 0.0), 0.0)
    t208 = t18 - np.where(t21 != 0.0, np.where(t27 != 0.0, t33 * t207, 0.0), 0.0)
    t209 = c3 + np.where(t21 != 0.0, np.where(t27 != 0.0, t28 * t207, 0.0), 0.0)
    t210 = t5 + np.where(t21 != 0.0, np.where(t27 != 0.0, t29 * t207, 0.0), 0.0)
    t211 = t11 + np.where(t21 != 0.0, np.where(t27 != 0.0, t31 * t207, 0.0), 0.0)
    t212 = t69 * t208 - (t64 * t209 + t66 * t210 + t67 * t211)
    t213 = t208 - np.where(t62 != 0.0, np.where(t62 != 0.0, t69 * t212, 0.0), 0.0)
    t214 = t209 + np.where(t62 != 0.0, np.where(t62 != 0.0, t64 * t212, 0.0), 0.0)
    t215 = t210 + np.where(t62 != 0.0, np.where(t62 != 0.0, t66 * t212, 0.0), 0.0)
    t216 = t211 + np.where(t62 != 0.0, np.where(t62 != 0.0, t67 * t212, 0.0), 0.0)
    t217 = t110 * t213 - (t105 * t214 + t107 * t215 + t108 * t216)
    t218 = t213 - np.where(t103 != 0.0, np.where(t103 != 0.0, t110 * t217, 0.0), 0.0)
    t219 = t216 + np.where(t103 != 0.0, np.where(t103 != 0.0, t108 * t217, 0.0), 0.0)
    t220 = t214 + np.where(t103 != 0.0, np.where(t103 != 0.0, t105 * t217, 0.0), 0.0)
    t221 = t215 + np.where(t103 != 0.0, np.where(t103 != 0.0, t107 * t217, 0.0), 0.0)
    t222 = t156 * t218 - t154 * t219 - t158 * t220 - t160 * t221
    t223 = t140 * t222
    t224 = t218 - np.where(t139 != 0.0, np.where(t139 != 0.0, t156 * t222, 0.0), 0.0)
    t225 = t202 / t203
    t226 = t220 + np.where(t139 != 0.0, np.where(t139 != 0.0, t158 * t222, 0.0), 0.0)
    t227 = t198 / t203
    t228 = t221 + np.where(t139 != 0.0, np.where(t139 != 0.0, t160 * t222, 0.0), 0.0)
    t229 = t200 / t203
    t230 = np.where(t139 != 0.0, np.where(t139 != 0.0, -(t204 * t223), 0.0), 0.0) + t226 * t227 + t228 * t229
    t231 = t219 + np.where(t139 != 0.0, np.where(t139 != 0.0, t154 * t222, 0.0), 0.0)
    t232 = t201 / t203
    t233 = t224 * t225 - (t230 + t231 * t232)
    t234 = np.where(t139 != 0.0, np.where(t139 != 0.0, -t223, 0.0), 0.0) + np.where(t203 != 0.0, np.where(t203 != 0.0, t204 * t233, 0.0), 0.0)
    t235 = t170 / t203
    t236 = np.where(t203 != 0.0, -np.where(t203 != 0.0, np.where(t169 != 0.0, t233 * t235, 0.0), 0.0), 0.0)
    t237 = t226 + np.where(t203 != 0.0, np.where(t203 != 0.0, t227 * t233, 0.0), 0.0)
    t238 = t228 + np.where(t203 != 0.0, np.where(t203 != 0.0, t229 * t233, 0.0), 0.0)
    t239 = 1 + t234 * t234 + t236 * t236 + t237 * t237 + t238 * t238
    t240 = t231 + np.where(t203 != 0.0, np.where(t203 != 0.0, t232 * t233, 0.0), 0.0)
    t241 = t224 - np.where(t203 != 0.0, np.where(t203 != 0.0, t225 * t233, 0.0), 0.0)
    t242 = np.sqrt((t239 + t240 * t240 + t241 * t241))
    t243 = 1 / t242
    t244 = t234 / t242
    t245 = t240 / t242
    t246 = t241 / t242
    t247 = t237 / t242
    t248 = t238 / t242
    t249 = t33 * t246 - (t28 * t247 + t29 * t248 + t31 * t245)
    t250 = np.where(t242 != 0.0, -t245, 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t242 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t31 * t249, 0.0), 0.0), 0.0), 0.0), 0.0)
    t251 = np.where(t242 != 0.0, -t247, 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t242 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t28 * t249, 0.0), 0.0), 0.0), 0.0), 0.0)
    t252 = np.where(t242 != 0.0, -t248, 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t242 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t29 * t249, 0.0), 0.0), 0.0), 0.0), 0.0)
    t253 = np.where(t242 != 0.0, t246, 0.0) - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t242 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t33 * t249, 0.0), 0.0), 0.0), 0.0), 0.0)
    t254 = t64 * t251 + t66 * t252 + t67 * t250 + t69 * t253
    t255 = t250 - np.where(t62 != 0.0, np.where(t62 != 0.0, t67 * t254, 0.0), 0.0)
    t256 = t251 - np.where(t62 != 0.0, np.where(t62 != 0.0, t64 * t254, 0.0), 0.0)
    t257 = t252 - np.where(t62 != 0.0, np.where(t62 != 0.0, t66 * t254, 0.0), 0.0)
    t258 = t253 - np.where(t62 != 0.0, np.where(t62 != 0.0, t69 * t254, 0.0), 0.0)
    t259 = t105 * t256 + t107 * t257 + t108 * t255 + t110 * t258
    t260 = t255 - np.where(t103 != 0.0, np.where(t103 != 0.0, t108 * t259, 0.0), 0.0)
    t261 = t258 - np.where(t103 != 0.0, np.where(t103 != 0.0, t110 * t259, 0.0), 0.0)
    t262 = t256 - np.where(t103 != 0.0, np.where(t103 != 0.0, t105 * t259, 0.0), 0.0)
    t263 = t257 - np.where(t103 != 0.0, np.where(t103 != 0.0, t107 * t259, 0.0), 0.0)
    t264 = t154 * t260 + t156 * t261 + t158 * t262 + t160 * t263
    t265 = np.where(t139 != 0.0, t264, 0.0) + np.where(t242 != 0.0, np.where(t139 != 0.0, t140 * t244, 0.0), 0.0)
    t266 = np.where(t242 != 0.0, -t244, 0.0) - np.where(t139 != 0.0, -(t140 * t265), 0.0)
    t267 = t262 - np.where(t139 != 0.0, t158 * t265, 0.0)
    t268 = t263 - np.where(t139 != 0.0, t160 * t265, 0.0)
    t269 = t260 - np.where(t139 != 0.0, t154 * t265, 0.0)
    t270 = t204 * t266 + t227 * t267 + t229 * t268 + t232 * t269
    t271 = t261 - np.where(t139 != 0.0, t156 * t265, 0.0)
    t272 = t236 / t242
    t273 = np.where(t203 != 0.0, t270 + t225 * t271, 0.0) + np.where(t242 != 0.0, -np.where(t203 != 0.0, np.where(t169 != 0.0, -(t235 * t272), 0.0), 0.0), 0.0)
    t274 = t266 - np.where(t203 != 0.0, t204 * t273, 0.0)
    t275 = np.where(t242 != 0.0, -t272, 0.0) + np.where(t203 != 0.0, np.where(t169 != 0.0, t235 * t273, 0.0), 0.0)
    t276 = np.where(t242 != 0.0, np.where(t242 != 0.0, t243 * t243, 0.0), 0.0) + t274 * t274 + t275 * t275
    t277 = t267 - np.where(t203 != 0.0, t227 * t273, 0.0)
    t278 = t268 - np.where(t203 != 0.0, t229 * t273, 0.0)
    t279 = t269 - np.where(t203 != 0.0, t232 * t273, 0.0)
    t280 = t271 - np.where(t203 != 0.0, t225 * t273, 0.0)
    t281 = t276 + t277 * t277 + t278 * t278 + t279 * t279 + t280 * t280
    t282 = np.sqrt(t281)
    t283 = t274 / t282
    t284 = t243 / t282
    t285 = -np.where(t282 != 0.0, np.where(t242 != 0.0, np.where(t282 != 0.0, t283 * t284, 0.0), 0.0), 0.0)
    t286 = t275 / t282
    t287 = np.where(t203 != 0.0, -np.where(t203 != 0.0, np.where(t169 != 0.0, t204 * t235, 0.0), 0.0), 0.0) + np.where(t282 != 0.0, np.where(t282 != 0.0, t283 * t286, 0.0), 0.0)
    t288 = -t287
    t289 = np.where(t139 != 0.0, np.where(t139 != 0.0, -(t140 * t158), 0.0), 0.0) + np.where(t203 != 0.0, np.where(t203 != 0.0, t204 * t227, 0.0), 0.0)
    t290 = t277 / t282
    t291 = -(t289 + np.where(t282 != 0.0, np.where(t282 != 0.0, t283 * t290, 0.0), 0.0))
    t292 = np.where(t139 != 0.0, np.where(t139 != 0.0, -(t140 * t160), 0.0), 0.0) + np.where(t203 != 0.0, np.where(t203 != 0.0, t204 * t229, 0.0), 0.0)
    t293 = t278 / t282
    t294 = -(t292 + np.where(t282 != 0.0, np.where(t282 != 0.0, t283 * t293, 0.0), 0.0))
    t295 = np.where(t139 != 0.0, np.where(t139 != 0.0, -(t140 * t154), 0.0), 0.0) + np.where(t203 != 0.0, np.where(t203 != 0.0, t204 * t232, 0.0), 0.0)
    t296 = t279 / t282
    t297 = -(t295 + np.where(t282 != 0.0, np.where(t282 != 0.0, t283 * t296, 0.0), 0.0))
    t298 = np.where(t139 != 0.0, np.where(t139 != 0.0, -(t140 * t156), 0.0), 0.0) + np.where(t203 != 0.0, np.where(t203 != 0.0, t204 * t225, 0.0), 0.0)
    t299 = t280 / t282
    t300 = -(t298 + np.where(t282 != 0.0, np.where(t282 != 0.0, t283 * t299, 0.0), 0.0))
    t301 = -np.where(t282 != 0.0, np.where(t282 != 0.0, np.where(t242 != 0.0, t284 * t286, 0.0), 0.0), 0.0)
    t302 = -np.where(t282 != 0.0, np.where(t282 != 0.0, np.where(t242 != 0.0, t284 * t290, 0.0), 0.0), 0.0)
    t303 = -np.where(t282 != 0.0, np.where(t282 != 0.0, np.where(t242 != 0.0, t284 * t293, 0.0), 0.0), 0.0)
    t304 = -np.where(t282 != 0.0, np.where(t282 != 0.0, np.where(t242 != 0.0, t284 * t296, 0.0), 0.0), 0.0)
    t305 = -np.where(t282 != 0.0, np.where(t282 != 0.0, np.where(t242 != 0.0, t284 * t299, 0.0), 0.0), 0.0)
    t306 = np.where(t203 != 0.0, np.where(t169 != 0.0, t235, 0.0), 0.0)
    t307 = np.where(t203 != 0.0, -np.where(t203 != 0.0, np.where(t169 != 0.0, t227 * t235, 0.0), 0.0), 0.0) + np.where(t282 != 0.0, np.where(t282 != 0.0, t286 * t290, 0.0), 0.0)
    t308 = -t307
    t309 = np.where(t203 != 0.0, -np.where(t203 != 0.0, np.where(t169 != 0.0, t229 * t235, 0.0), 0.0), 0.0) + np.where(t282 != 0.0, np.where(t282 != 0.0, t286 * t293, 0.0), 0.0)
    t310 = -t309
    t311 = np.where(t203 != 0.0, -np.where(t203 != 0.0, np.where(t169 != 0.0, t232 * t235, 0.0), 0.0), 0.0) + np.where(t282 != 0.0, np.where(t282 != 0.0, t286 * t296, 0.0), 0.0)
    t312 = -t311
    t313 = np.where(t203 != 0.0, -np.where(t203 != 0.0, np.where(t169 != 0.0, t225 * t235, 0.0), 0.0), 0.0) + np.where(t282 != 0.0, np.where(t282 != 0.0, t286 * t299, 0.0), 0.0)
    t314 = -t313
    t315 = 1 - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t28 * t28, 0.0), 0.0), 0.0), 0.0) - np.where(t62 != 0.0, np.where(t62 != 0.0, t64 * t64, 0.0), 0.0)
    t316 = t315 - np.where(t103 != 0.0, np.where(t103 != 0.0, t105 * t105, 0.0), 0.0) - np.where(t139 != 0.0, np.where(t139 != 0.0, t158 * t158, 0.0), 0.0)
    t317 = t316 - np.where(t203 != 0.0, np.where(t203 != 0.0, t227 * t227, 0.0), 0.0) - np.where(t282 != 0.0, np.where(t282 != 0.0, t290 * t290, 0.0), 0.0)
    t318 = np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t28 * t29, 0.0), 0.0), 0.0), 0.0) + np.where(t62 != 0.0, np.where(t62 != 0.0, t64 * t66, 0.0), 0.0)
    t319 = t318 + np.where(t103 != 0.0, np.where(t103 != 0.0, t105 * t107, 0.0), 0.0) + np.where(t139 != 0.0, np.where(t139 != 0.0, t158 * t160, 0.0), 0.0)
    t320 = t319 + np.where(t203 != 0.0, np.where(t203 != 0.0, t227 * t229, 0.0), 0.0) + np.where(t282 != 0.0, np.where(t282 != 0.0, t290 * t293, 0.0), 0.0)
    t321 = -t320
    t322 = np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t28 * t31, 0.0), 0.0), 0.0), 0.0) + np.where(t62 != 0.0, np.where(t62 != 0.0, t64 * t67, 0.0), 0.0)
    t323 = t322 + np.where(t103 != 0.0, np.where(t103 != 0.0, t105 * t108, 0.0), 0.0) + np.where(t139 != 0.0, np.where(t139 != 0.0, t154 * t158, 0.0), 0.0)
    t324 = t323 + np.where(t203 != 0.0, np.where(t203 != 0.0, t227 * t232, 0.0), 0.0) + np.where(t282 != 0.0, np.where(t282 != 0.0, t290 * t296, 0.0), 0.0)
    t325 = -t324
    t326 = np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t28 * t33, 0.0), 0.0), 0.0), 0.0) + np.where(t62 != 0.0, np.where(t62 != 0.0, t64 * t69, 0.0), 0.0)
    t327 = t326 + np.where(t103 != 0.0, np.where(t103 != 0.0, t105 * t110, 0.0), 0.0) + np.where(t139 != 0.0, np.where(t139 != 0.0, t156 * t158, 0.0), 0.0)
    t328 = t327 + np.where(t203 != 0.0, np.where(t203 != 0.0, t225 * t227, 0.0), 0.0) + np.where(t282 != 0.0, np.where(t282 != 0.0, t290 * t299, 0.0), 0.0)
    t329 = -t328
    t330 = 1 - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t29 * t29, 0.0), 0.0), 0.0), 0.0) - np.where(t62 != 0.0, np.where(t62 != 0.0, t66 * t66, 0.0), 0.0)
    t331 = t330 - np.where(t103 != 0.0, np.where(t103 != 0.0, t107 * t107, 0.0), 0.0) - np.where(t139 != 0.0, np.where(t139 != 0.0, t160 * t160, 0.0), 0.0)
    t332 = t331 - np.where(t203 != 0.0, np.where(t203 != 0.0, t229 * t229, 0.0), 0.0) - np.where(t282 != 0.0, np.where(t282 != 0.0, t293 * t293, 0.0), 0.0)
    t333 = np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t29 * t31, 0.0), 0.0), 0.0), 0.0) + np.where(t62 != 0.0, np.where(t62 != 0.0, t66 * t67, 0.0), 0.0)
    t334 = t333 + np.where(t103 != 0.0, np.where(t103 != 0.0, t107 * t108, 0.0), 0.0) + np.where(t139 != 0.0, np.where(t139 != 0.0, t154 * t160, 0.0), 0.0)
    t335 = t334 + np.where(t203 != 0.0, np.where(t203 != 0.0, t229 * t232, 0.0), 0.0) + np.where(t282 != 0.0, np.where(t282 != 0.0, t293 * t296, 0.0), 0.0)
    t336 = -t335
    t337 = np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t29 * t33, 0.0), 0.0), 0.0), 0.0) + np.where(t62 != 0.0, np.where(t62 != 0.0, t66 * t69, 0.0), 0.0)
    t338 = t337 + np.where(t103 != 0.0, np.where(t103 != 0.0, t107 * t110, 0.0), 0.0) + np.where(t139 != 0.0, np.where(t139 != 0.0, t156 * t160, 0.0), 0.0)
    t339 = t338 + np.where(t203 != 0.0, np.where(t203 != 0.0, t225 * t229, 0.0), 0.0) + np.where(t282 != 0.0, np.where(t282 != 0.0, t293 * t299, 0.0), 0.0)
    t340 = -t339
    t341 = 1 - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t31 * t31, 0.0), 0.0), 0.0), 0.0) - np.where(t62 != 0.0, np.where(t62 != 0.0, t67 * t67, 0.0), 0.0)
    t342 = t341 - np.where(t103 != 0.0, np.where(t103 != 0.0, t108 * t108, 0.0), 0.0) - np.where(t139 != 0.0, np.where(t139 != 0.0, t154 * t154, 0.0), 0.0)
    t343 = t342 - np.where(t203 != 0.0, np.where(t203 != 0.0, t232 * t232, 0.0), 0.0) - np.where(t282 != 0.0, np.where(t282 != 0.0, t296 * t296, 0.0), 0.0)
    t344 = np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t31 * t33, 0.0), 0.0), 0.0), 0.0) + np.where(t62 != 0.0, np.where(t62 != 0.0, t67 * t69, 0.0), 0.0)
    t345 = t344 + np.where(t103 != 0.0, np.where(t103 != 0.0, t108 * t110, 0.0), 0.0) + np.where(t139 != 0.0, np.where(t139 != 0.0, t154 * t156, 0.0), 0.0)
    t346 = t345 + np.where(t203 != 0.0, np.where(t203 != 0.0, t225 * t232, 0.0), 0.0) + np.where(t282 != 0.0, np.where(t282 != 0.0, t296 * t299, 0.0), 0.0)
    t347 = -t346
    t348 = 1 - np.where(t21 != 0.0, np.where(t27 != 0.0, np.where(t21 != 0.0, np.where(t27 != 0.0, t33 * t33, 0.0), 0.0), 0.0), 0.0) - np.where(t62 != 0.0, np.where(t62 != 0.0, t69 * t69, 0.0), 0.0)
    t349 = t348 - np.where(t103 != 0.0, np.where(t103 != 0.0, t110 * t110, 0.0), 0.0) - np.where(t139 != 0.0, np.where(t139 != 0.0, t156 * t156, 0.0), 0.0)
    t350 = t349 - np.where(t203 != 0.0, np.where(t203 != 0.0, t225 * t225, 0.0), 0.0) - np.where(t282 != 0.0, np.where(t282 != 0.0, t299 * t299, 0.0), 0.0)

    # results
    null_projector = np.empty((*_leading, 49), _real)
    null_projector[..., 0] = t205 - np.where(t282 != 0.0, np.where(t282 != 0.0, t283 * t283, 0.0), 0.0)
    null_projector[..., 1] = t285
    null_projector[..., 2] = t288
    null_projector[..., 3] = t291
    null_projector[..., 4] = t294
    null_projector[..., 5] = t297
    null_projector[..., 6] = t300
    null_projector[..., 7] = t285
    null_projector[..., 8] = 1 - np.where(t282 != 0.0, np.where(t242 != 0.0, np.where(t282 != 0.0, np.where(t242 != 0.0, t284 * t284, 0.0), 0.0), 0.0), 0.0)
    null_projector[..., 9] = t301
    null_projector[..., 10] = t302
    null_projector[..., 11] = t303
    null_projector[..., 12] = t304
    null_projector[..., 13] = t305
    null_projector[..., 14] = t288
    null_projector[..., 15] = t301
    null_projector[..., 16] = 1 - t306 * t306 - np.where(t282 != 0.0, np.where(t282 != 0.0, t286 * t286, 0.0), 0.0)
    null_projector[..., 17] = t308
    null_projector[..., 18] = t310
    null_projector[..., 19] = t312
    null_projector[..., 20] = t314
    null_projector[..., 21] = t291
    null_projector[..., 22] = t302
    null_projector[..., 23] = t308
    null_projector[..., 24] = t317
    null_projector[..., 25] = t321
    null_projector[..., 26] = t325
    null_projector[..., 27] = t329
    null_projector[..., 28] = t294
    null_projector[..., 29] = t303
    null_projector[..., 30] = t310
    null_projector[..., 31] = t321
    null_projector[..., 32] = t332
    null_projector[..., 33] = t336
    null_projector[..., 34] = t340
    null_projector[..., 35] = t297
    null_projector[..., 36] = t304
    null_projector[..., 37] = t312
    null_projector[..., 38] = t325
    null_projector[..., 39] = t336
    null_projector[..., 40] = t343
    null_projector[..., 41] = t347
    null_projector[..., 42] = t300
    null_projector[..., 43] = t305
    null_projector[..., 44] = t314
    null_projector[..., 45] = t329
    null_projector[..., 46] = t340
    null_projector[..., 47] = t347
    null_projector[..., 48] = t350
    return null_projector.reshape(_leading + (7, 7))
