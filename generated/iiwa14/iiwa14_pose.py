"""manipulability (pose) of iiwa14, in NumPy.

Made from templates/kernel.py.j2; inputs c6db263e52e711de824a841e0cf7d4dac729e4067b9db13ba00a68cb33877c90.
2462 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_pose(q):
    """manipulability H = sqrt(det(J J^T)) of the pose Jacobian: 147 operations.

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
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    q6 = q[..., 5]
    c6 = np.cos(q6)
    s6 = np.sin(q6)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)

    # terms
    t1 = s3 * s4
    t2 = 0.4 * t1
    t3 = c3 * s4
    t4 = 0.4 * t3
    t5 = t2 * t3 - t1 * t4
    t6 = -0.42 - 0.4 * c4
    t7 = s3 * c4
    t8 = c3 * c5 - s5 * t7
    t9 = s4 * s5
    t10 = t6 * t8 + t2 * t9
    t11 = t2 * c4 + t1 * t6
    t12 = c3 * c4
    t13 = s3 * c5 + s5 * t12
    t14 = t2 * t13 + t4 * t8
    t15 = t5 * t10 + t11 * t14
    t16 = c4 * c6 + s6 * (s4 * c5)
    t17 = t6 - 0.126 * t16
    t18 = t3 * c6 - s6 * (c5 * t12 - s3 * s5)
    t19 = t4 + 0.126 * t18
    t20 = t17 * t18 + t16 * t19
    t21 = t1 * c6 - s6 * (c3 * s5 + c5 * t7)
    t22 = t2 + 0.126 * t21
    t23 = t16 * t22 + t17 * t21
    t24 = t18 * t22 - t19 * t21
    t25 = t14 * t23 + t10 * t24
    t26 = t4 * c4 + t3 * t6
    t27 = t11 * t24 - t5 * t23
    t28 = t6 * t13 - t4 * t9
    t29 = t15 * t20 - t25 * t26 - t27 * t28
    t30 = t29 * s2
    t31 = 0.42 * c3
    t32 = t24 * t31
    t33 = t14 * t31
    t34 = 0.42 * s3
    t35 = t28 * t32 - (t20 * t33 + t25 * t34)
    t36 = s2 * t35
    t37 = t5 * t31
    t38 = t15 * t34 - t28 * t37 + t26 * t33
    t39 = s2 * t38
    t40 = t27 * t34 - t20 * t37 + t26 * t32
    t41 = s2 * t40
    t42 = c3 * t30 - t1 * t36 - t21 * t39 - t8 * t41
    t43 = t13 * t40 - (t3 * t35 + t18 * t38) - s3 * t29
    t44 = c2 * t43 + c4 * t36 + t16 * t39 + t9 * t41
    t45 = t42 * t42 + t39 * t39 + t44 * t44 + t41 * t41
    t46 = np.sqrt((t45 + t36 * t36 + t30 * t30 + t43 * t43))

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = t46
    return manipulability.reshape(_leading)


def manipulability_gradient_pose(q):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in lexicographic order: 473 operations.

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
    q3 = q[..., 2]
    s3 = np.sin(q3)
    q4 = q[..., 3]
    s4 = np.sin(q4)
    c3 = np.cos(q3)
    c4 = np.cos(q4)
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
    t1 = s3 * s4
    t2 = 0.4 * t1
    t3 = s4 * c3
    t4 = 0.4 * t3
    t5 = t2 * t3 - t1 * t4
    t6 = -0.42 - 0.4 * c4
    t7 = s3 * c4
    t8 = c3 * c5 - s5 * t7
    t9 = s4 * s5
    t10 = t6 * t8 + t2 * t9
    t11 = t2 * c4 + t1 * t6
    t12 = c3 * c4
    t13 = s3 * c5 + s5 * t12
    t14 = t2 * t13 + t4 * t8
    t15 = t5 * t10 + t11 * t14
    t16 = 0.42 * s3
    t17 = 0.42 * c3
    t18 = t5 * t17
    t19 = t6 * t13 - t4 * t9
    t20 = t14 * t17
    t21 = t4 * c4 + t3 * t6
    t22 = t15 * t16 - t18 * t19 + t20 * t21
    t23 = t22 * s2
    t24 = c3 * s5 + c5 * t7
    t25 = t1 * c6 - s6 * t24
    t26 = t2 + 0.126 * t25
    t27 = c5 * t12 - s3 * s5
    t28 = t3 * c6 - s6 * t27
    t29 = t4 + 0.126 * t28
    t30 = t26 * t28 - t25 * t29
    t31 = s4 * c5
    t32 = c4 * c6 + s6 * t31
    t33 = t6 - 0.126 * t32
    t34 = t26 * t32 + t25 * t33
    t35 = t11 * t30 - t5 * t34
    t36 = t28 * t33 + t29 * t32
    t37 = t17 * t30
    t38 = t16 * t35 - t18 * t36 + t21 * t37
    t39 = s2 * t38
    t40 = t14 * t34 + t10 * t30
    t41 = t19 * t37 - (t20 * t36 + t16 * t40)
    t42 = s2 * t41
    t43 = t15 * t36 - t21 * t40 - t19 * t35
    t44 = s2 * t43
    t45 = t23 * t23 + t39 * t39 + t42 * t42 + t44 * t44
    t46 = t13 * t38 - (t3 * t41 + t22 * t28) - s3 * t43
    t47 = c2 * t46 + c4 * t42 + t23 * t32 + t9 * t39
    t48 = c3 * t44 - t1 * t42 - t23 * t25 - t8 * t39
    t49 = np.sqrt((t45 + t47 * t47 + t48 * t48 + t46 * t46))
    t50 = t48 / t49
    t51 = c3 * t50 + t44 / t49
    t52 = t47 / t49
    t53 = c4 * t52 - t1 * t50 + t42 / t49
    t54 = t9 * t52 - t8 * t50 + t39 / t49
    t55 = t32 * t52 - t25 * t50 + t23 / t49
    t56 = t43 * t51 + t41 * t53 + t38 * t54 + t22 * t55
    t57 = c2 * t56 - s2 * (t46 * t52)
    t58 = t46 / t49 + c2 * t52
    t59 = s2 * t51 - s3 * t58
    t60 = s2 * t53 - t3 * t58
    t61 = t13 * t58 + s2 * t54
    t62 = t15 * t59 - t20 * t60 - t18 * t61
    t63 = t19 * t60 + t21 * t61
    t64 = t21 * t59 + t16 * t60
    t65 = t16 * t61 - t19 * t59
    t66 = t17 * t63 - t10 * t64 + t11 * t65
    t67 = t32 * t62 - t25 * t66
    t68 = t33 * t62 - t22 * t58 + 0.126 * t67 + t26 * t66
    t69 = s6 * t68
    t70 = s2 * t55 - t28 * t58
    t71 = s5 * t69 - t43 * t58 + 0.42 * (t35 * t61 - t40 * t60 + t15 * t70)
    t72 = t37 * t60 - t35 * t59 - t18 * t70
    t73 = t21 * t70 - t36 * t60
    t74 = t36 * t59 + t16 * t70
    t75 = t17 * t73 - t34 * t64 + t11 * t74
    t76 = t38 * t58 + t6 * t72 + t2 * t75
    t77 = t14 * t64 + t5 * t65
    t78 = t28 * t66 - t32 * t77
    t79 = 0.126 * t78 - (t23 * t50 + t33 * t77 + t29 * t66)
    t80 = s6 * t79
    t81 = t5 * t74 - t30 * t64
    t82 = t4 * t75 - t39 * t50 + t6 * t81
    t83 = c5 * t80 + s5 * t82
    t84 = t30 * t65 + t14 * t74
    t85 = t36 * t61 + t19 * t70
    t86 = t10 * t74 - (t34 * t65 + t17 * t85)
    t87 = c6 * t79 - t42 * t50 + t6 * t84 - t4 * t86
    t88 = t78 + t13 * t75 + c4 * t84 + t9 * t81 + t3 * t86
    t89 = t87 + 0.4 * t88
    t90 = c3 * (t71 + c5 * t76 - c4 * t83 + s4 * t89)
    t91 = t44 * t50 - s5 * t80 + 0.42 * (t30 * t63 + t14 * t73 - t5 * t85)
    t92 = s5 * t76 - c5 * t69
    t93 = t37 * t61 - t40 * t59 + t20 * t70
    t94 = t67 + c4 * t93 - t9 * t72 + t8 * t75 - t1 * t86
    t95 = c6 * t68 - t41 * t58 + t6 * t93 + 0.4 * t94
    t96 = t95 + t2 * t86
    t97 = s3 * (t91 + c4 * t92 + c5 * t82 + s4 * t96)
    t98 = t90 - t97
    t99 = t28 * t62 - t25 * t77
    t100 = t23 * t52 + t29 * t62 - 0.126 * t99 - t26 * t77
    t101 = s6 * t100
    t102 = t39 * t52 - t4 * t72 + t2 * t81
    t103 = c5 * t101 + s5 * t102 + c3 * t96 + s3 * t89
    t104 = t42 * t52 + c6 * t100 + t4 * t93 + c3 * t92
    t105 = t99 + t3 * t93 + t13 * t72 + t1 * t84 + t8 * t81
    t106 = s4 * (t104 + t2 * t84 - s3 * t83 - 0.4 * t105)
    t107 = c4 * t103 - t106
    t108 = s3 * t69 - c3 * t80 + t12 * t76 + s4 * t102
    t109 = s4 * t101 - t12 * t69 - t7 * t80 + s3 * t76
    t110 = c5 * (t108 - t7 * t82) - s5 * (t109 + c3 * t82)
    t111 = c6 * (t31 * t100 - t27 * t68 - t24 * t79) - s6 * (c4 * t100 + t3 * t68 + t1 * t79)
    t112 = 1 / t49
    t113 = t112 * t112
    t114 = -0.5 / t49 * np.sqrt(t112)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 7), _real)
    inverse_gradient = np.empty((*_leading, 7), _real)
    inverse_root_gradient = np.empty((*_leading, 7), _real)
    manipulability[..., 0] = t49
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t49 != 0.0, t57, 0.0)
    gradient[..., 2] = np.where(t49 != 0.0, t98, 0.0)
    gradient[..., 3] = np.where(t49 != 0.0, t107, 0.0)
    gradient[..., 4] = np.where(t49 != 0.0, t110, 0.0)
    gradient[..., 5] = np.where(t49 != 0.0, t111, 0.0)
    gradient[..., 6] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t49 != 0.0, -(t57 * t113), 0.0)
    inverse_gradient[..., 2] = np.where(t49 != 0.0, -(t98 * t113), 0.0)
    inverse_gradient[..., 3] = np.where(t49 != 0.0, -(t107 * t113), 0.0)
    inverse_gradient[..., 4] = np.where(t49 != 0.0, -(t110 * t113), 0.0)
    inverse_gradient[..., 5] = np.where(t49 != 0.0, -(t111 * t113), 0.0)
    inverse_gradient[..., 6] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t49 != 0.0, t57 * t114, 0.0)
    inverse_root_gradient[..., 2] = np.where(t49 != 0.0, t98 * t114, 0.0)
    inverse_root_gradient[..., 3] = np.where(t49 != 0.0, t107 * t114, 0.0)
    inverse_root_gradient[..., 4] = np.where(t49 != 0.0, t110 * t114, 0.0)
    inverse_root_gradient[..., 5] = np.where(t49 != 0.0, t111 * t114, 0.0)
    inverse_root_gradient[..., 6] = 0.0
    return manipulability.reshape(_leading), gradient.reshape(_leading + (7,)), inverse_gradient.reshape(_leading + (7,)), inverse_root_gradient.reshape(_leading + (7,))


def minors_pose(q):
    """maximal minors of the pose Jacobian, columns in lexicographic order: 139 operations.

    in   q[7]
    out  minors[7]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q3 = q[..., 2]
    s3 = np.sin(q3)
    q4 = q[..., 3]
    s4 = np.sin(q4)
    c3 = np.cos(q3)
    c4 = np.cos(q4)
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
    t1 = s3 * s4
    t2 = 0.4 * t1
    t3 = s4 * c3
    t4 = 0.4 * t3
    t5 = t2 * t3 - t1 * t4
    t6 = -0.42 - 0.4 * c4
    t7 = s3 * c4
    t8 = c3 * c5 - s5 * t7
    t9 = s4 * s5
    t10 = t6 * t8 + t2 * t9
    t11 = t2 * c4 + t1 * t6
    t12 = c3 * c4
    t13 = s3 * c5 + s5 * t12
    t14 = t2 * t13 + t4 * t8
    t15 = t5 * t10 + t11 * t14
    t16 = 0.42 * s3
    t17 = 0.42 * c3
    t18 = t5 * t17
    t19 = t6 * t13 - t4 * t9
    t20 = t14 * t17
    t21 = t4 * c4 + t3 * t6
    t22 = t15 * t16 - t18 * t19 + t20 * t21
    t23 = t22 * s2
    t24 = t1 * c6 - s6 * (c3 * s5 + c5 * t7)
    t25 = t2 + 0.126 * t24
    t26 = t3 * c6 - s6 * (c5 * t12 - s3 * s5)
    t27 = t4 + 0.126 * t26
    t28 = t25 * t26 - t24 * t27
    t29 = c4 * c6 + s6 * (s4 * c5)
    t30 = t6 - 0.126 * t29
    t31 = t25 * t29 + t24 * t30
    t32 = t11 * t28 - t5 * t31
    t33 = t26 * t30 + t27 * t29
    t34 = t17 * t28
    t35 = t16 * t32 - t18 * t33 + t21 * t34
    t36 = s2 * t35
    t37 = t14 * t31 + t10 * t28
    t38 = t19 * t34 - (t20 * t33 + t16 * t37)
    t39 = s2 * t38
    t40 = t15 * t33 - t21 * t37 - t19 * t32
    t41 = s2 * t40
    t42 = t13 * t35 - (t3 * t38 + t22 * t26) - s3 * t40
    t43 = c2 * t42 + c4 * t39 + t23 * t29 + t9 * t36
    t44 = c3 * t41 - t1 * t39 - t23 * t24 - t8 * t36

    # results
    minors = np.empty((*_leading, 7), _real)
    minors[..., 0] = -t23
    minors[..., 1] = -t36
    minors[..., 2] = -t39
    minors[..., 3] = -t41
    minors[..., 4] = t43
    minors[..., 5] = -t44
    minors[..., 6] = -t42
    return minors.reshape(_leading + (7,))


def null_vector_pose(q):
    """null vector of the pose Jacobian from its signed minors, |N| = H: 136 operations.

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
    t6 = t1 * c6 - s6 * (c3 * s5 + c5 * t5)
    t7 = t2 + 0.126 * t6
    t8 = s4 * c3
    t9 = c4 * c3
    t10 = c6 * t8 - s6 * (c5 * t9 - s3 * s5)
    t11 = 0.4 * t8
    t12 = t11 + 0.126 * t10
    t13 = t7 * t10 - t6 * t12
    t14 = t2 * t8 - t1 * t11
    t15 = c4 * c6 + s6 * (s4 * c5)
    t16 = t3 - 0.126 * t15
    t17 = t7 * t15 + t6 * t16
    t18 = t4 * t13 - t14 * t17
    t19 = 0.42 * s3
    t20 = 0.42 * c3
    t21 = t14 * t20
    t22 = t10 * t16 + t12 * t15
    t23 = t13 * t20
    t24 = c4 * t11 + t3 * t8
    t25 = t18 * t19 - t21 * t22 + t23 * t24
    t26 = s3 * c5 + s5 * t9
    t27 = s4 * s5
    t28 = t3 * t26 - t11 * t27
    t29 = c3 * c5 - s5 * t5
    t30 = t2 * t26 + t11 * t29
    t31 = t20 * t30
    t32 = t3 * t29 + t2 * t27
    t33 = t17 * t30 + t13 * t32
    t34 = t23 * t28 - (t22 * t31 + t19 * t33)
    t35 = t14 * t32 + t4 * t30
    t36 = t19 * t35 - t21 * t28 + t24 * t31
    t37 = t22 * t35 - t24 * t33 - t18 * t28
    t38 = t25 * t26 - (t8 * t34 + t10 * t36) - s3 * t37
    t39 = t37 * s2
    t40 = t34 * s2
    t41 = t36 * s2
    t42 = t25 * s2
    t43 = c3 * t39 - t1 * t40 - t6 * t41 - t29 * t42
    t44 = t38 * c2 + c4 * t40 + t15 * t41 + t27 * t42

    # results
    null_vector = np.empty((*_leading, 7), _real)
    null_vector[..., 0] = -t38
    null_vector[..., 1] = t43
    null_vector[..., 2] = t44
    null_vector[..., 3] = t39
    null_vector[..., 4] = -t40
    null_vector[..., 5] = t42
    null_vector[..., 6] = -t41
    return null_vector.reshape(_leading + (7,))


def null_projector_pose(q):
    """projector I - J^+ J onto the null space of the pose Jacobian: 1567 operations.

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
    t3 = 0.42 * c3
    t4 = s3 * s4
    t5 = 0.4 * t4
    t6 = -0.42 - 0.4 * c4
    t7 = c4 * t5 + t4 * t6
    t8 = s3 * c4
    t9 = c5 * c3 - s5 * t8
    t10 = s5 * s4
    t11 = t6 * t9 + t5 * t10
    t12 = t4 * c6 - s6 * (s5 * c3 + c5 * t8)
    t13 = t5 + 0.126 * t12
    t14 = c4 * c6 + s6 * (c5 * s4)
    t15 = t6 - 0.126 * t14
    t16 = t13 * t14 + t12 * t15
    t17 = t3 * t3 + t7 * t7 + t11 * t11 + t16 * t16
    t18 = np.sqrt(t17)
    t19 = t3 / t18
    t20 = t7 / t18
    t21 = t11 / t18
    t22 = t16 / t18
    t23 = t19 * t19 + t20 * t20 + t21 * t21 + t22 * t22
    t24 = np.sqrt(np.where(t18 != 0.0, np.where(t18 != 0.0, t23, 0.0), 0.0))
    t25 = t19 / t24
    t26 = t20 / t24
    t27 = c3 * s4
    t28 = t21 / t24
    t29 = np.where(t18 != 0.0, np.where(t24 != 0.0, s3 * t25 + t26 * t27 - t2 * t28, 0.0), 0.0)
    t30 = t22 / t24
    t31 = c6 * t27 - s6 * (c5 * t1 - s3 * s5)
    t32 = t29 - np.where(t18 != 0.0, np.where(t24 != 0.0, -(t30 * t31), 0.0), 0.0)
    t33 = t2 + np.where(t18 != 0.0, np.where(t24 != 0.0, t28 * t32, 0.0), 0.0)
    t34 = 0.4 * t27
    t35 = t2 * t5 + t9 * t34
    t36 = t5 * t27 - t4 * t34
    t37 = t34 + 0.126 * t31
    t38 = t13 * t31 - t12 * t37
    t39 = t28 * t35 - t26 * t36 - t30 * t38
    t40 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t25 * t39, 0.0), 0.0), 0.0), 0.0)
    t41 = t36 - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t26 * t39), 0.0), 0.0), 0.0), 0.0)
    t42 = t35 - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t28 * t39, 0.0), 0.0), 0.0), 0.0)
    t43 = t38 - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t30 * t39), 0.0), 0.0), 0.0), 0.0)
    t44 = t40 * t40 + t41 * t41 + t42 * t42 + t43 * t43
    t45 = np.sqrt(t44)
    t46 = t40 / t45
    t47 = t42 / t45
    t48 = t41 / t45
    t49 = t43 / t45
    t50 = t28 * t47 - (t25 * t46 + t26 * t48) - t30 * t49
    t51 = np.where(t45 != 0.0, -t46, 0.0) - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t45 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t25 * t50, 0.0), 0.0), 0.0), 0.0), 0.0)
    t52 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t45 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t26 * t50), 0.0), 0.0), 0.0), 0.0), 0.0)
    t53 = np.where(t45 != 0.0, t48, 0.0) - t52
    t54 = np.where(t45 != 0.0, t47, 0.0) - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t45 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t28 * t50, 0.0), 0.0), 0.0), 0.0), 0.0)
    t55 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t45 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t30 * t50), 0.0), 0.0), 0.0), 0.0), 0.0)
    t56 = np.where(t45 != 0.0, t49, 0.0) - t55
    t57 = t51 * t51 + t53 * t53 + t54 * t54 + t56 * t56
    t58 = np.sqrt(t57)
    t59 = s3 - np.where(t18 != 0.0, np.where(t24 != 0.0, t25 * t32, 0.0), 0.0)
    t60 = t51 / t58
    t61 = t27 + np.where(t18 != 0.0, np.where(t24 != 0.0, -(t26 * t32), 0.0), 0.0)
    t62 = t53 / t58
    t63 = t54 / t58
    t64 = t31 + np.where(t18 != 0.0, np.where(t24 != 0.0, -(t30 * t32), 0.0), 0.0)
    t65 = t56 / t58
    t66 = t59 * t60 - t61 * t62 - t33 * t63 - t64 * t65
    t67 = t33 + np.where(t58 != 0.0, np.where(t58 != 0.0, t63 * t66, 0.0), 0.0)
    t68 = 0.42 * s3
    t69 = c4 * t34 + t6 * t27
    t70 = t2 * t6 - t10 * t34
    t71 = t15 * t31 + t14 * t37
    t72 = t25 * t68 - t26 * t69 + t28 * t70 - t30 * t71
    t73 = t68 - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t25 * t72, 0.0), 0.0), 0.0), 0.0)
    t74 = t69 - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t26 * t72), 0.0), 0.0), 0.0), 0.0)
    t75 = t70 - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t28 * t72, 0.0), 0.0), 0.0), 0.0)
    t76 = t71 - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t30 * t72), 0.0), 0.0), 0.0), 0.0)
    t77 = t60 * t73 + t62 * t74 + t63 * t75 + t65 * t76
    t78 = t73 - np.where(t58 != 0.0, np.where(t58 != 0.0, t60 * t77, 0.0), 0.0)
    t79 = t74 - np.where(t58 != 0.0, np.where(t58 != 0.0, t62 * t77, 0.0), 0.0)
    t80 = t75 - np.where(t58 != 0.0, np.where(t58 != 0.0, t63 * t77, 0.0), 0.0)
    t81 = t76 - np.where(t58 != 0.0, np.where(t58 != 0.0, t65 * t77, 0.0), 0.0)
    t82 = t78 * t78 + t79 * t79 + t80 * t80 + t81 * t81
    t83 = np.sqrt(t82)
    t84 = t78 / t83
    t85 = t79 / t83
    t86 = t80 / t83
    t87 = t81 / t83
    t88 = t25 * t84 - t26 * t85 + t28 * t86 - t30 * t87
    t89 = np.where(t83 != 0.0, t84, 0.0) - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t83 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t25 * t88, 0.0), 0.0), 0.0), 0.0), 0.0)
    t90 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t83 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t26 * t88), 0.0), 0.0), 0.0), 0.0), 0.0)
    t91 = np.where(t83 != 0.0, t85, 0.0) - t90
    t92 = np.where(t83 != 0.0, t86, 0.0) - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t83 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t28 * t88, 0.0), 0.0), 0.0), 0.0), 0.0)
    t93 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t83 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t30 * t88), 0.0), 0.0), 0.0), 0.0), 0.0)
    t94 = np.where(t83 != 0.0, t87, 0.0) - t93
    t95 = t60 * t89 + t62 * t91 + t63 * t92 + t65 * t94
    t96 = t89 - np.where(t58 != 0.0, np.where(t58 != 0.0, t60 * t95, 0.0), 0.0)
    t97 = t91 - np.where(t58 != 0.0, np.where(t58 != 0.0, t62 * t95, 0.0), 0.0)
    t98 = t92 - np.where(t58 != 0.0, np.where(t58 != 0.0, t63 * t95, 0.0), 0.0)
    t99 = t94 - np.where(t58 != 0.0, np.where(t58 != 0.0, t65 * t95, 0.0), 0.0)
    t100 = t96 * t96 + t97 * t97 + t98 * t98 + t99 * t99
    t101 = np.sqrt(t100)
    t102 = t59 - np.where(t58 != 0.0, np.where(t58 != 0.0, t60 * t66, 0.0), 0.0)
    t103 = t96 / t101
    t104 = t61 + np.where(t58 != 0.0, np.where(t58 != 0.0, t62 * t66, 0.0), 0.0)
    t105 = t97 / t101
    t106 = t98 / t101
    t107 = t64 + np.where(t58 != 0.0, np.where(t58 != 0.0, t65 * t66, 0.0), 0.0)
    t108 = t99 / t101
    t109 = t102 * t103 - t104 * t105 - t67 * t106 - t107 * t108
    t110 = t67 + np.where(t101 != 0.0, np.where(t101 != 0.0, t106 * t109, 0.0), 0.0)
    t111 = t107 + np.where(t101 != 0.0, np.where(t101 != 0.0, t108 * t109, 0.0), 0.0)
    t112 = t102 - np.where(t101 != 0.0, np.where(t101 != 0.0, t103 * t109, 0.0), 0.0)
    t113 = t104 + np.where(t101 != 0.0, np.where(t101 != 0.0, t105 * t109, 0.0), 0.0)
    t114 = t110 * t110 + t111 * t111 + t112 * t112 + t113 * t113
    t115 = np.sqrt((t114 + s2 * s2))
    t116 = t110 / t115
    t117 = t112 / t115
    t118 = t113 / t115
    t119 = t111 / t115
    t120 = t25 * t117 + t26 * t118 - t28 * t116 + t30 * t119
    t121 = np.where(t115 != 0.0, -t116, 0.0) - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t115 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t28 * t120, 0.0), 0.0), 0.0), 0.0), 0.0)
    t122 = np.where(t115 != 0.0, t117, 0.0) - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t115 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t25 * t120, 0.0), 0.0), 0.0), 0.0), 0.0)
    t123 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t115 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t26 * t120), 0.0), 0.0), 0.0), 0.0), 0.0)
    t124 = np.where(t115 != 0.0, -t118, 0.0) - t123
    t125 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t115 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t30 * t120), 0.0), 0.0), 0.0), 0.0), 0.0)
    t126 = np.where(t115 != 0.0, -t119, 0.0) - t125
    t127 = t60 * t122 + t62 * t124 + t63 * t121 + t65 * t126
    t128 = t121 - np.where(t58 != 0.0, np.where(t58 != 0.0, t63 * t127, 0.0), 0.0)
    t129 = t122 - np.where(t58 != 0.0, np.where(t58 != 0.0, t60 * t127, 0.0), 0.0)
    t130 = t124 - np.where(t58 != 0.0, np.where(t58 != 0.0, t62 * t127, 0.0), 0.0)
    t131 = t126 - np.where(t58 != 0.0, np.where(t58 != 0.0, t65 * t127, 0.0), 0.0)
    t132 = t103 * t129 + t105 * t130 + t106 * t128 + t108 * t131
    t133 = t128 - np.where(t101 != 0.0, np.where(t101 != 0.0, t106 * t132, 0.0), 0.0)
    t134 = t131 - np.where(t101 != 0.0, np.where(t101 != 0.0, t108 * t132, 0.0), 0.0)
    t135 = t129 - np.where(t101 != 0.0, np.where(t101 != 0.0, t103 * t132, 0.0), 0.0)
    t136 = t130 - np.where(t101 != 0.0, np.where(t101 != 0.0, t105 * t132, 0.0), 0.0)
    t137 = t133 * t133 + t134 * t134 + t135 * t135 + t136 * t136
    t138 = np.where(t115 != 0.0, s2 / t115, 0.0)
    t139 = np.sqrt((t137 + t138 * t138))
    t140 = t138 / t139
    t141 = np.where(t18 != 0.0, np.where(t24 != 0.0, t10 * t28, 0.0), 0.0) - np.where(t18 != 0.0, np.where(t24 != 0.0, -(c4 * t26), 0.0), 0.0)
    t142 = t141 - np.where(t18 != 0.0, np.where(t24 != 0.0, -(t14 * t30), 0.0), 0.0)
    t143 = t10 - np.where(t18 != 0.0, np.where(t24 != 0.0, t28 * t142, 0.0), 0.0)
    t144 = t25 * t142
    t145 = c4 + np.where(t18 != 0.0, np.where(t24 != 0.0, -(t26 * t142), 0.0), 0.0)
    t146 = t63 * t143 - (np.where(t18 != 0.0, np.where(t24 != 0.0, t60 * t144, 0.0), 0.0) + t62 * t145)
    t147 = t14 + np.where(t18 != 0.0, np.where(t24 != 0.0, -(t30 * t142), 0.0), 0.0)
    t148 = t146 - t65 * t147
    t149 = t143 - np.where(t58 != 0.0, np.where(t58 != 0.0, t63 * t148, 0.0), 0.0)
    t150 = np.where(t18 != 0.0, np.where(t24 != 0.0, t144, 0.0), 0.0) + np.where(t58 != 0.0, np.where(t58 != 0.0, t60 * t148, 0.0), 0.0)
    t151 = t145 + np.where(t58 != 0.0, np.where(t58 != 0.0, t62 * t148, 0.0), 0.0)
    t152 = t147 + np.where(t58 != 0.0, np.where(t58 != 0.0, t65 * t148, 0.0), 0.0)
    t153 = t106 * t149 - (t103 * t150 + t105 * t151) - t108 * t152
    t154 = t149 - np.where(t101 != 0.0, np.where(t101 != 0.0, t106 * t153, 0.0), 0.0)
    t155 = t133 / t139
    t156 = t152 + np.where(t101 != 0.0, np.where(t101 != 0.0, t108 * t153, 0.0), 0.0)
    t157 = t134 / t139
    t158 = t150 + np.where(t101 != 0.0, np.where(t101 != 0.0, t103 * t153, 0.0), 0.0)
    t159 = t135 / t139
    t160 = t151 + np.where(t101 != 0.0, np.where(t101 != 0.0, t105 * t153, 0.0), 0.0)
    t161 = t136 / t139
    t162 = t154 * t155 - t156 * t157 - t158 * t159 - t160 * t161
    t163 = np.where(t139 != 0.0, t162, 0.0) - np.where(t139 != 0.0, -(t140 * c2), 0.0)
    t164 = c2 + np.where(t139 != 0.0, -(t140 * t163), 0.0)
    t165 = t158 + np.where(t139 != 0.0, t159 * t163, 0.0)
    t166 = t160 + np.where(t139 != 0.0, t161 * t163, 0.0)
    t167 = t154 - np.where(t139 != 0.0, t155 * t163, 0.0)
    t168 = 1 + t164 * t164 + t165 * t165 + t166 * t166 + t167 * t167
    t169 = t156 + np.where(t139 != 0.0, t157 * t163, 0.0)
    t170 = np.sqrt((t168 + t169 * t169))
    t171 = 1 / t170
    t172 = t164 / t170
    t173 = t167 / t170
    t174 = t166 / t170
    t175 = t165 / t170
    t176 = t169 / t170
    t177 = t26 * t174 - t25 * t175 + t28 * t173 + t30 * t176
    t178 = np.where(t170 != 0.0, t173, 0.0) - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t170 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t28 * t177, 0.0), 0.0), 0.0), 0.0), 0.0)
    t179 = np.where(t170 != 0.0, -t175, 0.0) - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t170 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t25 * t177, 0.0), 0.0), 0.0), 0.0), 0.0)
    t180 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t170 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t26 * t177), 0.0), 0.0), 0.0), 0.0), 0.0)
    t181 = np.where(t170 != 0.0, -t174, 0.0) - t180
    t182 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t170 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t30 * t177), 0.0), 0.0), 0.0), 0.0), 0.0)
    t183 = np.where(t170 != 0.0, -t176, 0.0) - t182
    t184 = t60 * t179 + t62 * t181 + t63 * t178 + t65 * t183
    t185 = t178 - np.where(t58 != 0.0, np.where(t58 != 0.0, t63 * t184, 0.0), 0.0)
    t186 = t179 - np.where(t58 != 0.0, np.where(t58 != 0.0, t60 * t184, 0.0), 0.0)
    t187 = t181 - np.where(t58 != 0.0, np.where(t58 != 0.0, t62 * t184, 0.0), 0.0)
    t188 = t183 - np.where(t58 != 0.0, np.where(t58 != 0.0, t65 * t184, 0.0), 0.0)
    t189 = t103 * t186 + t105 * t187 + t106 * t185 + t108 * t188
    t190 = t185 - np.where(t101 != 0.0, np.where(t101 != 0.0, t106 * t189, 0.0), 0.0)
    t191 = t188 - np.where(t101 != 0.0, np.where(t101 != 0.0, t108 * t189, 0.0), 0.0)
    t192 = t186 - np.where(t101 != 0.0, np.where(t101 != 0.0, t103 * t189, 0.0), 0.0)
    t193 = t187 - np.where(t101 != 0.0, np.where(t101 != 0.0, t105 * t189, 0.0), 0.0)
    t194 = t155 * t190 + t157 * t191 + t159 * t192 + t161 * t193
    t195 = np.where(t139 != 0.0, t194, 0.0) + np.where(t170 != 0.0, np.where(t139 != 0.0, t140 * t172, 0.0), 0.0)
    t196 = np.where(t170 != 0.0, -t172, 0.0) - np.where(t139 != 0.0, -(t140 * t195), 0.0)
    t197 = t192 - np.where(t139 != 0.0, t159 * t195, 0.0)
    t198 = np.where(t170 != 0.0, np.where(t170 != 0.0, t171 * t171, 0.0), 0.0) + t196 * t196 + t197 * t197
    t199 = t193 - np.where(t139 != 0.0, t161 * t195, 0.0)
    t200 = t190 - np.where(t139 != 0.0, t155 * t195, 0.0)
    t201 = t191 - np.where(t139 != 0.0, t157 * t195, 0.0)
    t202 = np.sqrt((t198 + t199 * t199 + t200 * t200 + t201 * t201))
    t203 = t196 / t202
    t204 = 1 - np.where(t139 != 0.0, np.where(t139 != 0.0, t140 * t140, 0.0), 0.0) - np.where(t202 != 0.0, np.where(t202 != 0.0, t203 * t203, 0.0), 0.0)
    t205 = np.where(t18 != 0.0, np.where(t24 != 0.0, t4 * t26 + t9 * t28, 0.0), 0.0) - np.where(t18 != 0.0, np.where(t24 != 0.0, c3 * t25, 0.0), 0.0)
    t206 = t205 - np.where(t18 != 0.0, np.where(t24 != 0.0, -(t12 * t30), 0.0), 0.0)
    t207 = t9 - np.where(t18 != 0.0, np.where(t24 != 0.0, t28 * t206, 0.0), 0.0)
    t208 = c3 + np.where(t18 != 0.0, np.where(t24 != 0.0, t25 * t206, 0.0), 0.0)
    t209 = t4 + np.where(t18 != 0.0, np.where(t24 != 0.0, -(t26 * t206), 0.0), 0.0)
    t210 = t12 + np.where(t18 != 0.0, np.where(t24 != 0.0, -(t30 * t206), 0.0), 0.0)
    t211 = t63 * t207 - (t60 * t208 + t62 * t209) - t65 * t210
    t212 = t207 - np.where(t58 != 0.0, np.where(t58 != 0.0, t63 * t211, 0.0), 0.0)
    t213 = t208 + np.where(t58 != 0.0, np.where(t58 != 0.0, t60 * t211, 0.0), 0.0)
    t214 = t209 + np.where(t58 != 0.0, np.where(t58 != 0.0, t62 * t211, 0.0), 0.0)
    t215 = t210 + np.where(t58 != 0.0, np.where(t58 != 0.0, t65 * t211, 0.0), 0.0)
    t216 = t106 * t212 - (t103 * t213 + t105 * t214) - t108 * t215
    t217 = t212 - np.where(t101 != 0.0, np.where(t101 != 0.0, t106 * t216, 0.0), 0.0)
    t218 = t215 + np.where(t101 != 0.0, np.where(t101 != 0.0, t108 * t216, 0.0), 0.0)
    t219 = t213 + np.where(t101 != 0.0, np.where(t101 != 0.0, t103 * t216, 0.0), 0.0)
    t220 = t214 + np.where(t101 != 0.0, np.where(t101 != 0.0, t105 * t216, 0.0), 0.0)
    t221 = t155 * t217 - t157 * t218 - t159 * t219 - t161 * t220
    t222 = t140 * t221
    t223 = t217 - np.where(t139 != 0.0, np.where(t139 != 0.0, t155 * t221, 0.0), 0.0)
    t224 = t200 / t202
    t225 = t219 + np.where(t139 != 0.0, np.where(t139 != 0.0, t159 * t221, 0.0), 0.0)
    t226 = t197 / t202
    t227 = t220 + np.where(t139 != 0.0, np.where(t139 != 0.0, t161 * t221, 0.0), 0.0)
    t228 = t199 / t202
    t229 = np.where(t139 != 0.0, np.where(t139 != 0.0, -(t203 * t222), 0.0), 0.0) + t225 * t226 + t227 * t228
    t230 = t218 + np.where(t139 != 0.0, np.where(t139 != 0.0, t157 * t221, 0.0), 0.0)
    t231 = t201 / t202
    t232 = t223 * t224 - t229 - t230 * t231
    t233 = np.where(t139 != 0.0, np.where(t139 != 0.0, -t222, 0.0), 0.0) + np.where(t202 != 0.0, np.where(t202 != 0.0, t203 * t232, 0.0), 0.0)
    t234 = t171 / t202
    t235 = np.where(t202 != 0.0, -np.where(t202 != 0.0, np.where(t170 != 0.0, t232 * t234, 0.0), 0.0), 0.0)
    t236 = t225 + np.where(t202 != 0.0, np.where(t202 != 0.0, t226 * t232, 0.0), 0.0)
    t237 = t227 + np.where(t202 != 0.0, np.where(t202 != 0.0, t228 * t232, 0.0), 0.0)
    t238 = 1 + t233 * t233 + t235 * t235 + t236 * t236 + t237 * t237
    t239 = t223 - np.where(t202 != 0.0, np.where(t202 != 0.0, t224 * t232, 0.0), 0.0)
    t240 = t230 + np.where(t202 != 0.0, np.where(t202 != 0.0, t231 * t232, 0.0), 0.0)
    t241 = np.sqrt((t238 + t239 * t239 + t240 * t240))
    t242 = 1 / t241
    t243 = t233 / t241
    t244 = t239 / t241
    t245 = t237 / t241
    t246 = t236 / t241
    t247 = t240 / t241
    t248 = t26 * t245 - t25 * t246 + t28 * t244 + t30 * t247
    t249 = np.where(t241 != 0.0, t244, 0.0) - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t241 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t28 * t248, 0.0), 0.0), 0.0), 0.0), 0.0)
    t250 = np.where(t241 != 0.0, -t246, 0.0) - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t241 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t25 * t248, 0.0), 0.0), 0.0), 0.0), 0.0)
    t251 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t241 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t26 * t248), 0.0), 0.0), 0.0), 0.0), 0.0)
    t252 = np.where(t241 != 0.0, -t245, 0.0) - t251
    t253 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t241 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t30 * t248), 0.0), 0.0), 0.0), 0.0), 0.0)
    t254 = np.where(t241 != 0.0, -t247, 0.0) - t253
    t255 = t60 * t250 + t62 * t252 + t63 * t249 + t65 * t254
    t256 = t249 - np.where(t58 != 0.0, np.where(t58 != 0.0, t63 * t255, 0.0), 0.0)
    t257 = t250 - np.where(t58 != 0.0, np.where(t58 != 0.0, t60 * t255, 0.0), 0.0)
    t258 = t252 - np.where(t58 != 0.0, np.where(t58 != 0.0, t62 * t255, 0.0), 0.0)
    t259 = t254 - np.where(t58 != 0.0, np.where(t58 != 0.0, t65 * t255, 0.0), 0.0)
    t260 = t103 * t257 + t105 * t258 + t106 * t256 + t108 * t259
    t261 = t256 - np.where(t101 != 0.0, np.where(t101 != 0.0, t106 * t260, 0.0), 0.0)
    t262 = t259 - np.where(t101 != 0.0, np.where(t101 != 0.0, t108 * t260, 0.0), 0.0)
    t263 = t257 - np.where(t101 != 0.0, np.where(t101 != 0.0, t103 * t260, 0.0), 0.0)
    t264 = t258 - np.where(t101 != 0.0, np.where(t101 != 0.0, t105 * t260, 0.0), 0.0)
    t265 = t155 * t261 + t157 * t262 + t159 * t263 + t161 * t264
    t266 = np.where(t139 != 0.0, t265, 0.0) + np.where(t241 != 0.0, np.where(t139 != 0.0, t140 * t243, 0.0), 0.0)
    t267 = np.where(t241 != 0.0, -t243, 0.0) - np.where(t139 != 0.0, -(t140 * t266), 0.0)
    t268 = t263 - np.where(t139 != 0.0, t159 * t266, 0.0)
    t269 = t264 - np.where(t139 != 0.0, t161 * t266, 0.0)
    t270 = t261 - np.where(t139 != 0.0, t155 * t266, 0.0)
    t271 = t203 * t267 + t226 * t268 + t228 * t269 + t224 * t270
    t272 = t262 - np.where(t139 != 0.0, t157 * t266, 0.0)
    t273 = t235 / t241
    t274 = np.where(t202 != 0.0, t271 + t231 * t272, 0.0) + np.where(t241 != 0.0, -np.where(t202 != 0.0, np.where(t170 != 0.0, -(t234 * t273), 0.0), 0.0), 0.0)
    t275 = t267 - np.where(t202 != 0.0, t203 * t274, 0.0)
    t276 = np.where(t241 != 0.0, -t273, 0.0) + np.where(t202 != 0.0, np.where(t170 != 0.0, t234 * t274, 0.0), 0.0)
    t277 = np.where(t241 != 0.0, np.where(t241 != 0.0, t242 * t242, 0.0), 0.0) + t275 * t275 + t276 * t276
    t278 = t268 - np.where(t202 != 0.0, t226 * t274, 0.0)
    t279 = t269 - np.where(t202 != 0.0, t228 * t274, 0.0)
    t280 = t270 - np.where(t202 != 0.0, t224 * t274, 0.0)
    t281 = t272 - np.where(t202 != 0.0, t231 * t274, 0.0)
    t282 = t277 + t278 * t278 + t279 * t279 + t280 * t280 + t281 * t281
    t283 = np.sqrt(t282)
    t284 = t275 / t283
    t285 = t242 / t283
    t286 = -np.where(t283 != 0.0, np.where(t241 != 0.0, np.where(t283 != 0.0, t284 * t285, 0.0), 0.0), 0.0)
    t287 = t276 / t283
    t288 = np.where(t202 != 0.0, -np.where(t202 != 0.0, np.where(t170 != 0.0, t203 * t234, 0.0), 0.0), 0.0) + np.where(t283 != 0.0, np.where(t283 != 0.0, t284 * t287, 0.0), 0.0)
    t289 = -t288
    t290 = np.where(t139 != 0.0, np.where(t139 != 0.0, -(t140 * t159), 0.0), 0.0) + np.where(t202 != 0.0, np.where(t202 != 0.0, t203 * t226, 0.0), 0.0)
    t291 = t278 / t283
    t292 = -(t290 + np.where(t283 != 0.0, np.where(t283 != 0.0, t284 * t291, 0.0), 0.0))
    t293 = np.where(t139 != 0.0, np.where(t139 != 0.0, -(t140 * t161), 0.0), 0.0) + np.where(t202 != 0.0, np.where(t202 != 0.0, t203 * t228, 0.0), 0.0)
    t294 = t279 / t283
    t295 = -(t293 + np.where(t283 != 0.0, np.where(t283 != 0.0, t284 * t294, 0.0), 0.0))
    t296 = np.where(t139 != 0.0, np.where(t139 != 0.0, -(t140 * t155), 0.0), 0.0) + np.where(t202 != 0.0, np.where(t202 != 0.0, t203 * t224, 0.0), 0.0)
    t297 = t280 / t283
    t298 = -(t296 + np.where(t283 != 0.0, np.where(t283 != 0.0, t284 * t297, 0.0), 0.0))
    t299 = np.where(t139 != 0.0, np.where(t139 != 0.0, -(t140 * t157), 0.0), 0.0) + np.where(t202 != 0.0, np.where(t202 != 0.0, t203 * t231, 0.0), 0.0)
    t300 = t281 / t283
    t301 = -(t299 + np.where(t283 != 0.0, np.where(t283 != 0.0, t284 * t300, 0.0), 0.0))
    t302 = -np.where(t283 != 0.0, np.where(t283 != 0.0, np.where(t241 != 0.0, t285 * t287, 0.0), 0.0), 0.0)
    t303 = -np.where(t283 != 0.0, np.where(t283 != 0.0, np.where(t241 != 0.0, t285 * t291, 0.0), 0.0), 0.0)
    t304 = -np.where(t283 != 0.0, np.where(t283 != 0.0, np.where(t241 != 0.0, t285 * t294, 0.0), 0.0), 0.0)
    t305 = -np.where(t283 != 0.0, np.where(t283 != 0.0, np.where(t241 != 0.0, t285 * t297, 0.0), 0.0), 0.0)
    t306 = -np.where(t283 != 0.0, np.where(t283 != 0.0, np.where(t241 != 0.0, t285 * t300, 0.0), 0.0), 0.0)
    t307 = np.where(t202 != 0.0, np.where(t170 != 0.0, t234, 0.0), 0.0)
    t308 = np.where(t202 != 0.0, -np.where(t202 != 0.0, np.where(t170 != 0.0, t226 * t234, 0.0), 0.0), 0.0) + np.where(t283 != 0.0, np.where(t283 != 0.0, t287 * t291, 0.0), 0.0)
    t309 = -t308
    t310 = np.where(t202 != 0.0, -np.where(t202 != 0.0, np.where(t170 != 0.0, t228 * t234, 0.0), 0.0), 0.0) + np.where(t283 != 0.0, np.where(t283 != 0.0, t287 * t294, 0.0), 0.0)
    t311 = -t310
    t312 = np.where(t202 != 0.0, -np.where(t202 != 0.0, np.where(t170 != 0.0, t224 * t234, 0.0), 0.0), 0.0) + np.where(t283 != 0.0, np.where(t283 != 0.0, t287 * t297, 0.0), 0.0)
    t313 = -t312
    t314 = np.where(t202 != 0.0, -np.where(t202 != 0.0, np.where(t170 != 0.0, t231 * t234, 0.0), 0.0), 0.0) + np.where(t283 != 0.0, np.where(t283 != 0.0, t287 * t300, 0.0), 0.0)
    t315 = -t314
    t316 = 1 - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t25 * t25, 0.0), 0.0), 0.0), 0.0) - np.where(t58 != 0.0, np.where(t58 != 0.0, t60 * t60, 0.0), 0.0)
    t317 = t316 - np.where(t101 != 0.0, np.where(t101 != 0.0, t103 * t103, 0.0), 0.0) - np.where(t139 != 0.0, np.where(t139 != 0.0, t159 * t159, 0.0), 0.0)
    t318 = t317 - np.where(t202 != 0.0, np.where(t202 != 0.0, t226 * t226, 0.0), 0.0) - np.where(t283 != 0.0, np.where(t283 != 0.0, t291 * t291, 0.0), 0.0)
    t319 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t25 * t26), 0.0), 0.0), 0.0), 0.0) + np.where(t58 != 0.0, np.where(t58 != 0.0, t60 * t62, 0.0), 0.0)
    t320 = t319 + np.where(t101 != 0.0, np.where(t101 != 0.0, t103 * t105, 0.0), 0.0) + np.where(t139 != 0.0, np.where(t139 != 0.0, t159 * t161, 0.0), 0.0)
    t321 = t320 + np.where(t202 != 0.0, np.where(t202 != 0.0, t226 * t228, 0.0), 0.0) + np.where(t283 != 0.0, np.where(t283 != 0.0, t291 * t294, 0.0), 0.0)
    t322 = -t321
    t323 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t25 * t28, 0.0), 0.0), 0.0), 0.0) + np.where(t58 != 0.0, np.where(t58 != 0.0, t60 * t63, 0.0), 0.0)
    t324 = t323 + np.where(t101 != 0.0, np.where(t101 != 0.0, t103 * t106, 0.0), 0.0) + np.where(t139 != 0.0, np.where(t139 != 0.0, t155 * t159, 0.0), 0.0)
    t325 = t324 + np.where(t202 != 0.0, np.where(t202 != 0.0, t224 * t226, 0.0), 0.0) + np.where(t283 != 0.0, np.where(t283 != 0.0, t291 * t297, 0.0), 0.0)
    t326 = -t325
    t327 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t25 * t30), 0.0), 0.0), 0.0), 0.0) + np.where(t58 != 0.0, np.where(t58 != 0.0, t60 * t65, 0.0), 0.0)
    t328 = t327 + np.where(t101 != 0.0, np.where(t101 != 0.0, t103 * t108, 0.0), 0.0) + np.where(t139 != 0.0, np.where(t139 != 0.0, t157 * t159, 0.0), 0.0)
    t329 = t328 + np.where(t202 != 0.0, np.where(t202 != 0.0, t226 * t231, 0.0), 0.0) + np.where(t283 != 0.0, np.where(t283 != 0.0, t291 * t300, 0.0), 0.0)
    t330 = -t329
    t331 = 1 - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t26 * t26, 0.0), 0.0), 0.0), 0.0) - np.where(t58 != 0.0, np.where(t58 != 0.0, t62 * t62, 0.0), 0.0)
    t332 = t331 - np.where(t101 != 0.0, np.where(t101 != 0.0, t105 * t105, 0.0), 0.0) - np.where(t139 != 0.0, np.where(t139 != 0.0, t161 * t161, 0.0), 0.0)
    t333 = t332 - np.where(t202 != 0.0, np.where(t202 != 0.0, t228 * t228, 0.0), 0.0) - np.where(t283 != 0.0, np.where(t283 != 0.0, t294 * t294, 0.0), 0.0)
    t334 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t26 * t28), 0.0), 0.0), 0.0), 0.0) + np.where(t58 != 0.0, np.where(t58 != 0.0, t62 * t63, 0.0), 0.0)
    t335 = t334 + np.where(t101 != 0.0, np.where(t101 != 0.0, t105 * t106, 0.0), 0.0) + np.where(t139 != 0.0, np.where(t139 != 0.0, t155 * t161, 0.0), 0.0)
    t336 = t335 + np.where(t202 != 0.0, np.where(t202 != 0.0, t224 * t228, 0.0), 0.0) + np.where(t283 != 0.0, np.where(t283 != 0.0, t294 * t297, 0.0), 0.0)
    t337 = -t336
    t338 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t26 * t30, 0.0), 0.0), 0.0), 0.0) + np.where(t58 != 0.0, np.where(t58 != 0.0, t62 * t65, 0.0), 0.0)
    t339 = t338 + np.where(t101 != 0.0, np.where(t101 != 0.0, t105 * t108, 0.0), 0.0) + np.where(t139 != 0.0, np.where(t139 != 0.0, t157 * t161, 0.0), 0.0)
    t340 = t339 + np.where(t202 != 0.0, np.where(t202 != 0.0, t228 * t231, 0.0), 0.0) + np.where(t283 != 0.0, np.where(t283 != 0.0, t294 * t300, 0.0), 0.0)
    t341 = -t340
    t342 = 1 - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t28 * t28, 0.0), 0.0), 0.0), 0.0) - np.where(t58 != 0.0, np.where(t58 != 0.0, t63 * t63, 0.0), 0.0)
    t343 = t342 - np.where(t101 != 0.0, np.where(t101 != 0.0, t106 * t106, 0.0), 0.0) - np.where(t139 != 0.0, np.where(t139 != 0.0, t155 * t155, 0.0), 0.0)
    t344 = t343 - np.where(t202 != 0.0, np.where(t202 != 0.0, t224 * t224, 0.0), 0.0) - np.where(t283 != 0.0, np.where(t283 != 0.0, t297 * t297, 0.0), 0.0)
    t345 = np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, -(t28 * t30), 0.0), 0.0), 0.0), 0.0) + np.where(t58 != 0.0, np.where(t58 != 0.0, t63 * t65, 0.0), 0.0)
    t346 = t345 + np.where(t101 != 0.0, np.where(t101 != 0.0, t106 * t108, 0.0), 0.0) + np.where(t139 != 0.0, np.where(t139 != 0.0, t155 * t157, 0.0), 0.0)
    t347 = t346 + np.where(t202 != 0.0, np.where(t202 != 0.0, t224 * t231, 0.0), 0.0) + np.where(t283 != 0.0, np.where(t283 != 0.0, t297 * t300, 0.0), 0.0)
    t348 = -t347
    t349 = 1 - np.where(t18 != 0.0, np.where(t24 != 0.0, np.where(t18 != 0.0, np.where(t24 != 0.0, t30 * t30, 0.0), 0.0), 0.0), 0.0) - np.where(t58 != 0.0, np.where(t58 != 0.0, t65 * t65, 0.0), 0.0)
    t350 = t349 - np.where(t101 != 0.0, np.where(t101 != 0.0, t108 * t108, 0.0), 0.0) - np.where(t139 != 0.0, np.where(t139 != 0.0, t157 * t157, 0.0), 0.0)
    t351 = t350 - np.where(t202 != 0.0, np.where(t202 != 0.0, t231 * t231, 0.0), 0.0) - np.where(t283 != 0.0, np.where(t283 != 0.0, t300 * t300, 0.0), 0.0)

    # results
    null_projector = np.empty((*_leading, 49), _real)
    null_projector[..., 0] = t204 - np.where(t283 != 0.0, np.where(t283 != 0.0, t284 * t284, 0.0), 0.0)
    null_projector[..., 1] = t286
    null_projector[..., 2] = t289
    null_projector[..., 3] = t292
    null_projector[..., 4] = t295
    null_projector[..., 5] = t298
    null_projector[..., 6] = t301
    null_projector[..., 7] = t286
    null_projector[..., 8] = 1 - np.where(t283 != 0.0, np.where(t241 != 0.0, np.where(t283 != 0.0, np.where(t241 != 0.0, t285 * t285, 0.0), 0.0), 0.0), 0.0)
    null_projector[..., 9] = t302
    null_projector[..., 10] = t303
    null_projector[..., 11] = t304
    null_projector[..., 12] = t305
    null_projector[..., 13] = t306
    null_projector[..., 14] = t289
    null_projector[..., 15] = t302
    null_projector[..., 16] = 1 - t307 * t307 - np.where(t283 != 0.0, np.where(t283 != 0.0, t287 * t287, 0.0), 0.0)
    null_projector[..., 17] = t309
    null_projector[..., 18] = t311
    null_projector[..., 19] = t313
    null_projector[..., 20] = t315
    null_projector[..., 21] = t292
    null_projector[..., 22] = t303
    null_projector[..., 23] = t309
    null_projector[..., 24] = t318
    null_projector[..., 25] = t322
    null_projector[..., 26] = t326
    null_projector[..., 27] = t330
    null_projector[..., 28] = t295
    null_projector[..., 29] = t304
    null_projector[..., 30] = t311
    null_projector[..., 31] = t322
    null_projector[..., 32] = t333
    null_projector[..., 33] = t337
    null_projector[..., 34] = t341
    null_projector[..., 35] = t298
    null_projector[..., 36] = t305
    null_projector[..., 37] = t313
    null_projector[..., 38] = t326
    null_projector[..., 39] = t337
    null_projector[..., 40] = t344
    null_projector[..., 41] = t348
    null_projector[..., 42] = t301
    null_projector[..., 43] = t306
    null_projector[..., 44] = t315
    null_projector[..., 45] = t330
    null_projector[..., 46] = t341
    null_projector[..., 47] = t348
    null_projector[..., 48] = t351
    return null_projector.reshape(_leading + (7, 7))
