"""manipulability (position) of gofa5, in NumPy.

Made from templates/kernel.py.j2; inputs 19a46f4830bd55b319121950d891878cb2720671f096ba4458529eee0f50857c.
1045 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_position(q):
    """manipulability H = sqrt(det(J J^T)) of the position Jacobian: 146 operations.

    in   q[6]
    out  manipulability (one number)
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)

    # terms
    t1 = 0.444 * s2
    t2 = c2 * c3 - s2 * s3
    t3 = c2 * s3 + s2 * c3
    t4 = t1 + 0.47 * t2 + 0.11 * t3
    t5 = t3 * c4
    t6 = t4 + 0.101 * (t2 * c5 - s5 * t5) + 0.08 * (c5 * t5 + t2 * s5)
    t7 = t6 - t1
    t8 = t6 * t7
    t9 = 0.444 * c2
    t10 = t9 - 0.47 * t3 + 0.11 * t2
    t11 = t2 * c4
    t12 = t10 - 0.101 * (t3 * c5 + s5 * t11) + 0.08 * (c5 * t11 - t3 * s5)
    t13 = t6 * t6
    t14 = t12 - t9
    t15 = t8 * t12 - t13 * t14
    t16 = t6 - t4
    t17 = t12 - t10
    t18 = t3 * t16 + t2 * t17
    t19 = t6 * t18
    t20 = 0.101 * (s5 * s4) - 0.08 * (c5 * s4)
    t21 = t3 * t20
    t22 = t2 * t20
    t23 = t6 * t22
    t24 = t19 * t20 - (t13 * t21 + t12 * t23)
    t25 = t2 * s4
    t26 = c4 * t17 - t20 * t25
    t27 = t3 * s4
    t28 = t20 * t27 - c4 * t16
    t29 = t6 * t28
    t30 = t16 * t25 - t17 * t27
    t31 = t6 * t30
    t32 = t13 * t26 + t12 * t29 + t20 * t31
    t33 = t7 * t18
    t34 = t20 * t33 - (t8 * t21 + t14 * t23)
    t35 = t15 * t15 + t24 * t24 + t32 * t32 + t34 * t34
    t36 = t7 * t30
    t37 = t8 * t26 + t14 * t29 + t20 * t36
    t38 = t18 * t28 + t22 * t30
    t39 = t23 * t26 - t21 * t29 + t20 * t38
    t40 = t14 * t19 - t12 * t33
    t41 = t12 * t36 - t14 * t31
    t42 = t35 + t37 * t37 + t39 * t39 + t40 * t40 + t41 * t41
    t43 = t19 * t26 + t12 * t38 + t21 * t31
    t44 = t26 * t33 + t14 * t38 + t21 * t36

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.sqrt((t42 + t43 * t43 + t44 * t44))
    return manipulability.reshape(_leading)


def manipulability_gradient_position(q):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in lexicographic order: 453 operations.

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
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)

    # terms
    t1 = 0.444 * s2
    t2 = c2 * c3 - s2 * s3
    t3 = c2 * s3 + s2 * c3
    t4 = t1 + 0.47 * t2 + 0.11 * t3
    t5 = t3 * c4
    t6 = t4 + 0.101 * (t2 * c5 - s5 * t5) + 0.08 * (c5 * t5 + t2 * s5)
    t7 = t6 - t1
    t8 = t6 * t7
    t9 = 0.444 * c2
    t10 = t9 - 0.47 * t3 + 0.11 * t2
    t11 = t2 * c4
    t12 = t10 - 0.101 * (t3 * c5 + s5 * t11) + 0.08 * (c5 * t11 - t3 * s5)
    t13 = t6 * t6
    t14 = t12 - t9
    t15 = t8 * t12 - t13 * t14
    t16 = t6 - t4
    t17 = t12 - t10
    t18 = t3 * t16 + t2 * t17
    t19 = t6 * t18
    t20 = 0.101 * (s5 * s4) - 0.08 * (c5 * s4)
    t21 = t3 * t20
    t22 = t2 * t20
    t23 = t6 * t22
    t24 = t19 * t20 - (t13 * t21 + t12 * t23)
    t25 = t2 * s4
    t26 = c4 * t17 - t20 * t25
    t27 = t3 * s4
    t28 = t20 * t27 - c4 * t16
    t29 = t6 * t28
    t30 = t16 * t25 - t17 * t27
    t31 = t6 * t30
    t32 = t13 * t26 + t12 * t29 + t20 * t31
    t33 = t7 * t18
    t34 = t20 * t33 - (t8 * t21 + t14 * t23)
    t35 = t15 * t15 + t24 * t24 + t32 * t32 + t34 * t34
    t36 = t7 * t30
    t37 = t8 * t26 + t14 * t29 + t20 * t36
    t38 = t18 * t28 + t22 * t30
    t39 = t23 * t26 - t21 * t29 + t20 * t38
    t40 = t14 * t19 - t12 * t33
    t41 = t12 * t36 - t14 * t31
    t42 = t35 + t37 * t37 + t39 * t39 + t40 * t40 + t41 * t41
    t43 = t19 * t26 + t12 * t38 + t21 * t31
    t44 = t26 * t33 + t14 * t38 + t21 * t36
    t45 = np.sqrt((t42 + t43 * t43 + t44 * t44))
    t46 = t44 / t45
    t47 = t43 / t45
    t48 = t39 / t45
    t49 = t34 / t45
    t50 = t36 * t46 + t31 * t47 - t29 * t48 - t8 * t49
    t51 = t24 / t45
    t52 = t50 - t13 * t51
    t53 = t14 * t46 + t12 * t47 + t20 * t48
    t54 = t40 / t45
    t55 = t26 * t46 - t12 * t54 + t20 * t49
    t56 = t26 * t47 + t14 * t54 + t20 * t51
    t57 = t28 * t53 + t7 * t55 + t6 * t56
    t58 = t41 / t45
    t59 = t32 / t45
    t60 = t38 * t47 + t36 * t58 - t33 * t54 + t29 * t59
    t61 = t37 / t45
    t62 = t33 * t46 + t19 * t47 + t23 * t48 + t8 * t61
    t63 = t62 + t13 * t59
    t64 = t21 * t46 + t12 * t58 + t20 * t61
    t65 = t21 * t47 - t14 * t58 + t20 * t59
    t66 = t22 * t53 + t7 * t64 + t6 * t65
    t67 = c4 * t63 - t27 * t66 + t2 * t57
    t68 = t38 * t46 - t31 * t58 + t19 * t54 + t29 * t61
    t69 = t15 / t45
    t70 = t68 - t23 * t49 - t13 * t69
    t71 = t60 - t23 * t51 + t67 + t70 + t8 * t69
    t72 = 0.08 * t71
    t73 = 0.101 * t71
    t74 = t20 * t52 + t16 * t57 - s5 * t72 - c5 * t73
    t75 = t71 - t67
    t76 = t74 - 0.47 * t75
    t77 = t14 * t61 - t21 * t48 + t12 * t59
    t78 = t18 * t53 + t6 * t77
    t79 = t20 * t78 - t17 * t66
    t80 = t26 * t48 - t14 * t49 - t12 * t51
    t81 = t30 * t65 + t28 * t77 + t22 * t80 + t18 * t56
    t82 = t25 * t66 - c4 * t78 + t3 * t57
    t83 = (t6 + t6) * (t26 * t59 - t21 * t51 - t14 * t69)
    t84 = t26 * t61 - t21 * t49 + t12 * t69
    t85 = t30 * t64 + t18 * t55 + t6 * t84
    t86 = t81 + t82 + t83 + t7 * t84 + t85
    t87 = 0.08 * t86
    t88 = 0.101 * t86
    t89 = c5 * t87 - s5 * t88
    t90 = t86 - t82
    t91 = s4 * t79 + c4 * t89 + 0.11 * t90
    t92 = t16 * t66 - t20 * t63
    t93 = t30 * t53 + t6 * t80
    t94 = c5 * t72 - s5 * t73
    t95 = s4 * t92 + t20 * t93 + t17 * t57 + c4 * t94
    t96 = t95 + 0.11 * t75 + s5 * t87 + c5 * t88 + 0.47 * t90
    t97 = c3 * t76 + c3 * t91 - s3 * t96 + 0.444 * (t90 - t85)
    t98 = s3 * t76 + 0.444 * (t75 - t70) + s3 * t91 + c3 * t96
    t99 = c2 * t97 - s2 * t98
    t100 = c3 * (c2 * t76 + c2 * t91 - s2 * t96) - s3 * (s2 * t76 + s2 * t91 + c2 * t96)
    t101 = t38 * t48 + t36 * t61 + t33 * t49 + t31 * t59
    t102 = t101 + t27 * t78 - t25 * t63 + t2 * t93 + t3 * t52
    t103 = t102 + t19 * t51
    t104 = 0.08 * t103
    t105 = 0.101 * t103
    t106 = t3 * t79 + t2 * t92 - c5 * t104 + s5 * t105
    t107 = t17 * t63 - t16 * t78 + t2 * t94 + t3 * t89
    t108 = c4 * t106 - s4 * t107
    t109 = s4 * t105 - t3 * t72 - t11 * t73 + t2 * t87
    t110 = t11 * t72 - s4 * t104 - t3 * t73 + t5 * t87
    t111 = c5 * (t109 - t5 * t88) - s5 * (t110 + t2 * t88)
    t112 = 1 / t45
    t113 = t112 * t112
    t114 = -0.5 / t45 * np.sqrt(t112)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 6), _real)
    inverse_gradient = np.empty((*_leading, 6), _real)
    inverse_root_gradient = np.empty((*_leading, 6), _real)
    manipulability[..., 0] = t45
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t45 != 0.0, t99, 0.0)
    gradient[..., 2] = np.where(t45 != 0.0, t100, 0.0)
    gradient[..., 3] = np.where(t45 != 0.0, t108, 0.0)
    gradient[..., 4] = np.where(t45 != 0.0, t111, 0.0)
    gradient[..., 5] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t45 != 0.0, -(t99 * t113), 0.0)
    inverse_gradient[..., 2] = np.where(t45 != 0.0, -(t100 * t113), 0.0)
    inverse_gradient[..., 3] = np.where(t45 != 0.0, -(t108 * t113), 0.0)
    inverse_gradient[..., 4] = np.where(t45 != 0.0, -(t111 * t113), 0.0)
    inverse_gradient[..., 5] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t45 != 0.0, t99 * t114, 0.0)
    inverse_root_gradient[..., 2] = np.where(t45 != 0.0, t100 * t114, 0.0)
    inverse_root_gradient[..., 3] = np.where(t45 != 0.0, t108 * t114, 0.0)
    inverse_root_gradient[..., 4] = np.where(t45 != 0.0, t111 * t114, 0.0)
    inverse_root_gradient[..., 5] = 0.0
    return manipulability.reshape(_leading), gradient.reshape(_leading + (6,)), inverse_gradient.reshape(_leading + (6,)), inverse_root_gradient.reshape(_leading + (6,))


def minors_position(q):
    """maximal minors of the position Jacobian, columns in lexicographic order: 130 operations.

    in   q[6]
    out  minors[20]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s4 = np.sin(q4)

    # terms
    t1 = 0.444 * s2
    t2 = c2 * c3 - s2 * s3
    t3 = c2 * s3 + s2 * c3
    t4 = t1 + 0.47 * t2 + 0.11 * t3
    t5 = t3 * c4
    t6 = t4 + 0.101 * (t2 * c5 - s5 * t5) + 0.08 * (c5 * t5 + t2 * s5)
    t7 = t6 - t1
    t8 = t6 * t7
    t9 = 0.444 * c2
    t10 = t9 - 0.47 * t3 + 0.11 * t2
    t11 = t2 * c4
    t12 = t10 - 0.101 * (t3 * c5 + s5 * t11) + 0.08 * (c5 * t11 - t3 * s5)
    t13 = t6 * t6
    t14 = t12 - t9
    t15 = t6 - t4
    t16 = t12 - t10
    t17 = t3 * t15 + t2 * t16
    t18 = t6 * t17
    t19 = 0.101 * (s5 * s4) - 0.08 * (c5 * s4)
    t20 = t3 * t19
    t21 = t2 * t19
    t22 = t6 * t21
    t23 = t2 * s4
    t24 = c4 * t16 - t19 * t23
    t25 = t3 * s4
    t26 = t19 * t25 - c4 * t15
    t27 = t6 * t26
    t28 = t15 * t23 - t16 * t25
    t29 = t6 * t28
    t30 = t7 * t17
    t31 = t7 * t28
    t32 = t17 * t26 + t21 * t28

    # results
    minors = np.empty((*_leading, 20), _real)
    minors[..., 0] = t8 * t12 - t13 * t14
    minors[..., 1] = t18 * t19 - (t13 * t20 + t12 * t22)
    minors[..., 2] = -(t13 * t24 + t12 * t27 + t19 * t29)
    minors[..., 3] = 0.0
    minors[..., 4] = t19 * t30 - (t8 * t20 + t14 * t22)
    minors[..., 5] = -(t8 * t24 + t14 * t27 + t19 * t31)
    minors[..., 6] = 0.0
    minors[..., 7] = t22 * t24 - t20 * t27 + t19 * t32
    minors[..., 8] = 0.0
    minors[..., 9] = 0.0
    minors[..., 10] = t14 * t18 - t12 * t30
    minors[..., 11] = t12 * t31 - t14 * t29
    minors[..., 12] = 0.0
    minors[..., 13] = -(t18 * t24 + t12 * t32 + t20 * t29)
    minors[..., 14] = 0.0
    minors[..., 15] = 0.0
    minors[..., 16] = -(t24 * t30 + t14 * t32 + t20 * t31)
    minors[..., 17] = 0.0
    minors[..., 18] = 0.0
    minors[..., 19] = 0.0
    return minors.reshape(_leading + (20,))


def null_projector_position(q):
    """projector I - J^+ J onto the null space of the position Jacobian: 316 operations.

    in   q[6]
    out  null_projector[6][6]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q4 = q[..., 3]
    s4 = np.sin(q4)
    q5 = q[..., 4]
    s5 = np.sin(q5)
    c5 = np.cos(q5)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    c4 = np.cos(q4)

    # terms
    t1 = 0.101 * (s4 * s5) - 0.08 * (s4 * c5)
    t2 = 0.444 * c2
    t3 = c2 * s3 + c3 * s2
    t4 = c2 * c3 - s3 * s2
    t5 = t2 - 0.47 * t3 + 0.11 * t4
    t6 = t4 * c4
    t7 = t5 - 0.101 * (c5 * t3 + s5 * t6) + 0.08 * (c5 * t6 - s5 * t3)
    t8 = t7 - t2
    t9 = t1 * t3
    t10 = t1 * t1 + t7 * t7 + t8 * t8 + t9 * t9
    t11 = t7 - t5
    t12 = s4 * t4
    t13 = c4 * t11 - t1 * t12
    t14 = np.sqrt((t10 + t13 * t13))
    t15 = np.where(t14 != 0.0, 1, 0.0)
    t16 = t15 / (t14 + (1 - t15))
    t17 = t1 * t16
    t18 = 0.444 * s2
    t19 = t18 + 0.47 * t4 + 0.11 * t3
    t20 = t3 * c4
    t21 = t19 + 0.101 * (c5 * t4 - s5 * t20) + 0.08 * (c5 * t20 + s5 * t4)
    t22 = t13 * t16
    t23 = t21 - t19
    t24 = s4 * t3
    t25 = t12 * t23 - t11 * t24
    t26 = t9 * t16
    t27 = t3 * t23 + t4 * t11
    t28 = t22 * t25 - (t17 * t21 + t26 * t27)
    t29 = t21 + t17 * t28
    t30 = t25 - t22 * t28
    t31 = t7 * t16
    t32 = t28 * t31
    t33 = t8 * t16
    t34 = t28 * t33
    t35 = t27 + t26 * t28
    t36 = t17 * t29 + t31 * t32 + t33 * t34 + t26 * t35
    t37 = t22 * t30 - t36
    t38 = t29 + t17 * t37
    t39 = t32 + t31 * t37
    t40 = t34 + t33 * t37
    t41 = t35 + t26 * t37
    t42 = t38 * t38 + t39 * t39 + t40 * t40 + t41 * t41
    t43 = t30 - t22 * t37
    t44 = np.sqrt((t42 + t43 * t43))
    t45 = np.where(t44 != 0.0, 1, 0.0)
    t46 = t45 / (t44 + (1 - t45))
    t47 = t38 * t46
    t48 = t1 * t4
    t49 = t1 * t24 - c4 * t23
    t50 = t21 - t18
    t51 = t26 * t48 + t22 * t49 - t21 * t31 - t33 * t50
    t52 = t17 * t51
    t53 = t21 + t31 * t51
    t54 = t39 * t46
    t55 = t50 + t33 * t51
    t56 = t40 * t46
    t57 = t48 - t26 * t51
    t58 = t41 * t46
    t59 = t47 * t52 + t53 * t54 + t55 * t56 - t57 * t58
    t60 = t49 - t22 * t51
    t61 = t43 * t46
    t62 = t59 + t60 * t61
    t63 = t52 - t47 * t62
    t64 = t54 * t62 - t53
    t65 = t56 * t62 - t55
    t66 = t57 + t58 * t62
    t67 = t31 * t64 - t17 * t63 + t33 * t65 + t26 * t66
    t68 = t60 - t61 * t62
    t69 = t67 + t22 * t68
    t70 = t63 + t17 * t69
    t71 = t64 - t31 * t69
    t72 = t65 - t33 * t69
    t73 = t66 - t26 * t69
    t74 = t47 * t70 - t54 * t71 - t56 * t72 - t58 * t73
    t75 = t68 - t22 * t69
    t76 = t74 + t61 * t75
    t77 = t70 - t47 * t76
    t78 = t71 + t54 * t76
    t79 = t72 + t56 * t76
    t80 = t73 + t58 * t76
    t81 = t77 * t77 + t78 * t78 + t79 * t79 + t80 * t80
    t82 = t75 - t61 * t76
    t83 = np.sqrt((t81 + t82 * t82))
    t84 = np.where(t83 != 0.0, 1, 0.0)
    t85 = t84 / (t83 + (1 - t84))
    t86 = t77 * t85
    t87 = t78 * t85
    t88 = t17 * t31 + t47 * t54 - t86 * t87
    t89 = t79 * t85
    t90 = t17 * t33 + t47 * t56 - t86 * t89
    t91 = t80 * t85
    t92 = t17 * t26 + t47 * t58 - t86 * t91
    t93 = t82 * t85
    t94 = t17 * t22 - t47 * t61 - t86 * t93
    t95 = -(t31 * t33 + t54 * t56 + t87 * t89)
    t96 = -(t26 * t31 + t54 * t58 + t87 * t91)
    t97 = t54 * t61 - t22 * t31 - t87 * t93
    t98 = -(t26 * t33 + t56 * t58 + t89 * t91)
    t99 = t56 * t61 - t22 * t33 - t89 * t93
    t100 = t58 * t61 - t22 * t26 - t91 * t93

    # results
    null_projector = np.empty((*_leading, 36), _real)
    null_projector[..., 0] = 1 - t17 * t17 - t47 * t47 - t86 * t86
    null_projector[..., 1] = t88
    null_projector[..., 2] = t90
    null_projector[..., 3] = t92
    null_projector[..., 4] = t94
    null_projector[..., 5] = 0.0
    null_projector[..., 6] = t88
    null_projector[..., 7] = 1 - t31 * t31 - t54 * t54 - t87 * t87
    null_projector[..., 8] = t95
    null_projector[..., 9] = t96
    null_projector[..., 10] = t97
    null_projector[..., 11] = 0.0
    null_projector[..., 12] = t90
    null_projector[..., 13] = t95
    null_projector[..., 14] = 1 - t33 * t33 - t56 * t56 - t89 * t89
    null_projector[..., 15] = t98
    null_projector[..., 16] = t99
    null_projector[..., 17] = 0.0
    null_projector[..., 18] = t92
    null_projector[..., 19] = t96
    null_projector[..., 20] = t98
    null_projector[..., 21] = 1 - t26 * t26 - t58 * t58 - t91 * t91
    null_projector[..., 22] = t100
    null_projector[..., 23] = 0.0
    null_projector[..., 24] = t94
    null_projector[..., 25] = t97
    null_projector[..., 26] = t99
    null_projector[..., 27] = t100
    null_projector[..., 28] = 1 - t22 * t22 - t61 * t61 - t93 * t93
    null_projector[..., 29] = 0.0
    null_projector[..., 30] = 0.0
    null_projector[..., 31] = 0.0
    null_projector[..., 32] = 0.0
    null_projector[..., 33] = 0.0
    null_projector[..., 34] = 0.0
    null_projector[..., 35] = 1
    return null_projector.reshape(_leading + (6, 6))
