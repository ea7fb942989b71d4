"""manipulability (position) of gofa5, in NumPy.

Made from templates/kernel.py.j2; inputs 49137681f7b57bcd2db580dcc707520c3198081602814f45610f40f491fd7aae.
1337 operations. Do not edit: change the derivation and regenerate.

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
    """projector I - J^+ J onto the null space of the position Jacobian: 608 operations.

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
    t15 = np.where(t14 != 0.0, t1 / t14, 0.0)
    t16 = t7 / t14
    t17 = t8 / t14
    t18 = t15 * t15 + np.where(t14 != 0.0, np.where(t14 != 0.0, t16 * t16, 0.0), 0.0) + np.where(t14 != 0.0, np.where(t14 != 0.0, t17 * t17, 0.0), 0.0)
    t19 = t9 / t14
    t20 = t13 / t14
    t21 = t18 + np.where(t14 != 0.0, np.where(t14 != 0.0, t19 * t19, 0.0), 0.0) + np.where(t14 != 0.0, np.where(t14 != 0.0, t20 * t20, 0.0), 0.0)
    t22 = np.sqrt(t21)
    t23 = t15 / t22
    t24 = 0.444 * s2
    t25 = t24 + 0.47 * t4 + 0.11 * t3
    t26 = t3 * c4
    t27 = t25 + 0.101 * (c5 * t4 - s5 * t26) + 0.08 * (c5 * t26 + s5 * t4)
    t28 = t19 / t22
    t29 = t27 - t25
    t30 = t3 * t29 + t4 * t11
    t31 = np.where(t22 != 0.0, -(t23 * t27), 0.0) + np.where(t14 != 0.0, np.where(t22 != 0.0, -(t28 * t30), 0.0), 0.0)
    t32 = t20 / t22
    t33 = s4 * t3
    t34 = t12 * t29 - t11 * t33
    t35 = t31 + np.where(t14 != 0.0, np.where(t22 != 0.0, t32 * t34, 0.0), 0.0)
    t36 = t27 - np.where(t22 != 0.0, -(t23 * t35), 0.0)
    t37 = t16 / t22
    t38 = np.where(t14 != 0.0, np.where(t22 != 0.0, t35 * t37, 0.0), 0.0)
    t39 = t17 / t22
    t40 = np.where(t14 != 0.0, np.where(t22 != 0.0, t35 * t39, 0.0), 0.0)
    t41 = t30 + np.where(t14 != 0.0, np.where(t22 != 0.0, t28 * t35, 0.0), 0.0)
    t42 = t36 * t36 + t38 * t38 + t40 * t40 + t41 * t41
    t43 = t34 - np.where(t14 != 0.0, np.where(t22 != 0.0, t32 * t35, 0.0), 0.0)
    t44 = np.sqrt((t42 + t43 * t43))
    t45 = t36 / t44
    t46 = t38 / t44
    t47 = np.where(t22 != 0.0, -(t23 * t45), 0.0) + np.where(t14 != 0.0, np.where(t22 != 0.0, -(t37 * t46), 0.0), 0.0)
    t48 = t40 / t44
    t49 = t41 / t44
    t50 = t47 + np.where(t14 != 0.0, np.where(t22 != 0.0, -(t39 * t48), 0.0), 0.0) + np.where(t14 != 0.0, np.where(t22 != 0.0, -(t28 * t49), 0.0), 0.0)
    t51 = t43 / t44
    t52 = t50 + np.where(t14 != 0.0, np.where(t22 != 0.0, t32 * t51, 0.0), 0.0)
    t53 = np.where(t44 != 0.0, t45, 0.0) - np.where(t22 != 0.0, np.where(t44 != 0.0, -(t23 * t52), 0.0), 0.0)
    t54 = np.where(t44 != 0.0, -t46, 0.0) - np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t44 != 0.0, t37 * t52, 0.0), 0.0), 0.0)
    t55 = np.where(t44 != 0.0, -t48, 0.0) - np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t44 != 0.0, t39 * t52, 0.0), 0.0), 0.0)
    t56 = np.where(t44 != 0.0, -t49, 0.0) - np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t44 != 0.0, t28 * t52, 0.0), 0.0), 0.0)
    t57 = t53 * t53 + t54 * t54 + t55 * t55 + t56 * t56
    t58 = np.where(t44 != 0.0, t51, 0.0) - np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t44 != 0.0, t32 * t52, 0.0), 0.0), 0.0)
    t59 = np.sqrt((t57 + t58 * t58))
    t60 = t53 / t59
    t61 = 1 - np.where(t22 != 0.0, np.where(t22 != 0.0, t23 * t23, 0.0), 0.0) - np.where(t59 != 0.0, np.where(t59 != 0.0, t60 * t60, 0.0), 0.0)
    t62 = t1 * t4
    t63 = t1 * t33 - c4 * t29
    t64 = np.where(t14 != 0.0, np.where(t22 != 0.0, t28 * t62 + t32 * t63, 0.0), 0.0) - np.where(t14 != 0.0, np.where(t22 != 0.0, t27 * t37, 0.0), 0.0)
    t65 = t27 - t24
    t66 = t64 - np.where(t14 != 0.0, np.where(t22 != 0.0, t39 * t65, 0.0), 0.0)
    t67 = t23 * t66
    t68 = t62 - np.where(t14 != 0.0, np.where(t22 != 0.0, t28 * t66, 0.0), 0.0)
    t69 = t56 / t59
    t70 = t27 + np.where(t14 != 0.0, np.where(t22 != 0.0, t37 * t66, 0.0), 0.0)
    t71 = t54 / t59
    t72 = t65 + np.where(t14 != 0.0, np.where(t22 != 0.0, t39 * t66, 0.0), 0.0)
    t73 = t55 / t59
    t74 = np.where(t22 != 0.0, -(t60 * t67), 0.0) + t70 * t71 + t72 * t73
    t75 = t63 - np.where(t14 != 0.0, np.where(t22 != 0.0, t32 * t66, 0.0), 0.0)
    t76 = t58 / t59
    t77 = t68 * t69 - t74 + t75 * t76
    t78 = np.where(t22 != 0.0, -t67, 0.0) + np.where(t59 != 0.0, np.where(t59 != 0.0, t60 * t77, 0.0), 0.0)
    t79 = t70 + np.where(t59 != 0.0, np.where(t59 != 0.0, t71 * t77, 0.0), 0.0)
    t80 = t72 + np.where(t59 != 0.0, np.where(t59 != 0.0, t73 * t77, 0.0), 0.0)
    t81 = t68 - np.where(t59 != 0.0, np.where(t59 != 0.0, t69 * t77, 0.0), 0.0)
    t82 = t78 * t78 + t79 * t79 + t80 * t80 + t81 * t81
    t83 = t75 - np.where(t59 != 0.0, np.where(t59 != 0.0, t76 * t77, 0.0), 0.0)
    t84 = np.sqrt((t82 + t83 * t83))
    t85 = t78 / t84
    t86 = t79 / t84
    t87 = np.where(t22 != 0.0, t23 * t85, 0.0) + np.where(t14 != 0.0, np.where(t22 != 0.0, -(t37 * t86), 0.0), 0.0)
    t88 = t80 / t84
    t89 = t81 / t84
    t90 = t87 + np.where(t14 != 0.0, np.where(t22 != 0.0, -(t39 * t88), 0.0), 0.0) + np.where(t14 != 0.0, np.where(t22 != 0.0, t28 * t89, 0.0), 0.0)
    t91 = t83 / t84
    t92 = t90 + np.where(t14 != 0.0, np.where(t22 != 0.0, t32 * t91, 0.0), 0.0)
    t93 = np.where(t84 != 0.0, -t85, 0.0) - np.where(t22 != 0.0, np.where(t84 != 0.0, -(t23 * t92), 0.0), 0.0)
    t94 = np.where(t84 != 0.0, -t86, 0.0) - np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t84 != 0.0, t37 * t92, 0.0), 0.0), 0.0)
    t95 = np.where(t84 != 0.0, -t88, 0.0) - np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t84 != 0.0, t39 * t92, 0.0), 0.0), 0.0)
    t96 = np.where(t84 != 0.0, t89, 0.0) - np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t84 != 0.0, t28 * t92, 0.0), 0.0), 0.0)
    t97 = t60 * t93 + t71 * t94 + t73 * t95 + t69 * t96
    t98 = np.where(t84 != 0.0, t91, 0.0) - np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t84 != 0.0, t32 * t92, 0.0), 0.0), 0.0)
    t99 = t97 + t76 * t98
    t100 = t93 - np.where(t59 != 0.0, np.where(t59 != 0.0, t60 * t99, 0.0), 0.0)
    t101 = t94 - np.where(t59 != 0.0, np.where(t59 != 0.0, t71 * t99, 0.0), 0.0)
    t102 = t95 - np.where(t59 != 0.0, np.where(t59 != 0.0, t73 * t99, 0.0), 0.0)
    t103 = t96 - np.where(t59 != 0.0, np.where(t59 != 0.0, t69 * t99, 0.0), 0.0)
    t104 = t100 * t100 + t101 * t101 + t102 * t102 + t103 * t103
    t105 = t98 - np.where(t59 != 0.0, np.where(t59 != 0.0, t76 * t99, 0.0), 0.0)
    t106 = np.sqrt((t104 + t105 * t105))
    t107 = t100 / t106
    t108 = np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t22 != 0.0, -(t23 * t37), 0.0), 0.0), 0.0) + np.where(t59 != 0.0, np.where(t59 != 0.0, t60 * t71, 0.0), 0.0)
    t109 = t101 / t106
    t110 = -(t108 + np.where(t106 != 0.0, np.where(t106 != 0.0, t107 * t109, 0.0), 0.0))
    t111 = np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t22 != 0.0, -(t23 * t39), 0.0), 0.0), 0.0) + np.where(t59 != 0.0, np.where(t59 != 0.0, t60 * t73, 0.0), 0.0)
    t112 = t102 / t106
    t113 = -(t111 + np.where(t106 != 0.0, np.where(t106 != 0.0, t107 * t112, 0.0), 0.0))
    t114 = np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t22 != 0.0, -(t23 * t28), 0.0), 0.0), 0.0) + np.where(t59 != 0.0, np.where(t59 != 0.0, t60 * t69, 0.0), 0.0)
    t115 = t103 / t106
    t116 = -(t114 + np.where(t106 != 0.0, np.where(t106 != 0.0, t107 * t115, 0.0), 0.0))
    t117 = np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t22 != 0.0, -(t23 * t32), 0.0), 0.0), 0.0) + np.where(t59 != 0.0, np.where(t59 != 0.0, t60 * t76, 0.0), 0.0)
    t118 = t105 / t106
    t119 = -(t117 + np.where(t106 != 0.0, np.where(t106 != 0.0, t107 * t118, 0.0), 0.0))
    t120 = 1 - np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t14 != 0.0, np.where(t22 != 0.0, t37 * t37, 0.0), 0.0), 0.0), 0.0) - np.where(t59 != 0.0, np.where(t59 != 0.0, t71 * t71, 0.0), 0.0)
    t121 = np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t14 != 0.0, np.where(t22 != 0.0, t37 * t39, 0.0), 0.0), 0.0), 0.0) + np.where(t59 != 0.0, np.where(t59 != 0.0, t71 * t73, 0.0), 0.0)
    t122 = -(t121 + np.where(t106 != 0.0, np.where(t106 != 0.0, t109 * t112, 0.0), 0.0))
    t123 = np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t14 != 0.0, np.where(t22 != 0.0, t28 * t37, 0.0), 0.0), 0.0), 0.0) + np.where(t59 != 0.0, np.where(t59 != 0.0, t69 * t71, 0.0), 0.0)
    t124 = -(t123 + np.where(t106 != 0.0, np.where(t106 != 0.0, t109 * t115, 0.0), 0.0))
    t125 = np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t14 != 0.0, np.where(t22 != 0.0, t32 * t37, 0.0), 0.0), 0.0), 0.0) + np.where(t59 != 0.0, np.where(t59 != 0.0, t71 * t76, 0.0), 0.0)
    t126 = -(t125 + np.where(t106 != 0.0, np.where(t106 != 0.0, t109 * t118, 0.0), 0.0))
    t127 = 1 - np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t14 != 0.0, np.where(t22 != 0.0, t39 * t39, 0.0), 0.0), 0.0), 0.0) - np.where(t59 != 0.0, np.where(t59 != 0.0, t73 * t73, 0.0), 0.0)
    t128 = np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t14 != 0.0, np.where(t22 != 0.0, t28 * t39, 0.0), 0.0), 0.0), 0.0) + np.where(t59 != 0.0, np.where(t59 != 0.0, t69 * t73, 0.0), 0.0)
    t129 = -(t128 + np.where(t106 != 0.0, np.where(t106 != 0.0, t112 * t115, 0.0), 0.0))
    t130 = np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t14 != 0.0, np.where(t22 != 0.0, t32 * t39, 0.0), 0.0), 0.0), 0.0) + np.where(t59 != 0.0, np.where(t59 != 0.0, t73 * t76, 0.0), 0.0)
    t131 = -(t130 + np.where(t106 != 0.0, np.where(t106 != 0.0, t112 * t118, 0.0), 0.0))
    t132 = 1 - np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t14 != 0.0, np.where(t22 != 0.0, t28 * t28, 0.0), 0.0), 0.0), 0.0) - np.where(t59 != 0.0, np.where(t59 != 0.0, t69 * t69, 0.0), 0.0)
    t133 = np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t14 != 0.0, np.where(t22 != 0.0, t28 * t32, 0.0), 0.0), 0.0), 0.0) + np.where(t59 != 0.0, np.where(t59 != 0.0, t69 * t76, 0.0), 0.0)
    t134 = -(t133 + np.where(t106 != 0.0, np.where(t106 != 0.0, t115 * t118, 0.0), 0.0))
    t135 = 1 - np.where(t14 != 0.0, np.where(t22 != 0.0, np.where(t14 != 0.0, np.where(t22 != 0.0, t32 * t32, 0.0), 0.0), 0.0), 0.0) - np.where(t59 != 0.0, np.where(t59 != 0.0, t76 * t76, 0.0), 0.0)

    # results
    null_projector = np.empty((*_leading, 36), _real)
    null_projector[..., 0] = t61 - np.where(t106 != 0.0, np.where(t106 != 0.0, t107 * t107, 0.0), 0.0)
    null_projector[..., 1] = t110
    null_projector[..., 2] = t113
    null_projector[..., 3] = t116
    null_projector[..., 4] = t119
    null_projector[..., 5] = 0.0
    null_projector[..., 6] = t110
    null_projector[..., 7] = t120 - np.where(t106 != 0.0, np.where(t106 != 0.0, t109 * t109, 0.0), 0.0)
    null_projector[..., 8] = t122
    null_projector[..., 9] = t124
    null_projector[..., 10] = t126
    null_projector[..., 11] = 0.0
    null_projector[..., 12] = t113
    null_projector[..., 13] = t122
    null_projector[..., 14] = t127 - np.where(t106 != 0.0, np.where(t106 != 0.0, t112 * t112, 0.0), 0.0)
    null_projector[..., 15] = t129
    null_projector[..., 16] = t131
    null_projector[..., 17] = 0.0
    null_projector[..., 18] = t116
    null_projector[..., 19] = t124
    null_projector[..., 20] = t129
    null_projector[..., 21] = t132 - np.where(t106 != 0.0, np.where(t106 != 0.0, t115 * t115, 0.0), 0.0)
    null_projector[..., 22] = t134
    null_projector[..., 23] = 0.0
    null_projector[..., 24] = t119
    null_projector[..., 25] = t126
    null_projector[..., 26] = t131
    null_projector[..., 27] = t134
    null_projector[..., 28] = t135 - np.where(t106 != 0.0, np.where(t106 != 0.0, t118 * t118, 0.0), 0.0)
    null_projector[..., 29] = 0.0
    null_projector[..., 30] = 0.0
    null_projector[..., 31] = 0.0
    null_projector[..., 32] = 0.0
    null_projector[..., 33] = 0.0
    null_projector[..., 34] = 0.0
    null_projector[..., 35] = 1
    return null_projector.reshape(_leading + (6, 6))
