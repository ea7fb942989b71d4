"""manipulability (pose) of iiwa14, in NumPy.

Made from templates/kernel.py.j2; inputs 18013a5257f898e076f8226d048c962ff8a75ded3e5c12dbcb54b824fc1eca47.
1840 operations. Do not edit: change the derivation and regenerate.

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
    """projector I - J^+ J onto the null space of the pose Jacobian: 945 operations.

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
    t19 = np.where(t18 != 0.0, 1, 0.0)
    t20 = t19 / (t18 + (1 - t19))
    t21 = t3 * t20
    t22 = t7 * t20
    t23 = t11 * t20
    t24 = t16 * t20
    t25 = t21 * t21 + t22 * t22 + t23 * t23 + t24 * t24
    t26 = np.sqrt(t25)
    t27 = np.where(t26 != 0.0, 1, 0.0)
    t28 = t27 / (t26 + (1 - t27))
    t29 = t21 * t28
    t30 = t22 * t28
    t31 = c3 * s4
    t32 = t23 * t28
    t33 = t24 * t28
    t34 = c6 * t31 - s6 * (c5 * t1 - s3 * s5)
    t35 = s3 * t29 + t30 * t31 - t2 * t32 + t33 * t34
    t36 = t2 + t32 * t35
    t37 = t30 * t35 - t31
    t38 = 0.4 * t31
    t39 = t2 * t5 + t9 * t38
    t40 = t5 * t31 - t4 * t38
    t41 = t38 + 0.126 * t34
    t42 = t13 * t34 - t12 * t41
    t43 = t32 * t39 - t30 * t40 - t33 * t42
    t44 = t29 * t43
    t45 = t40 + t30 * t43
    t46 = t39 - t32 * t43
    t47 = t42 + t33 * t43
    t48 = t44 * t44 + t45 * t45 + t46 * t46 + t47 * t47
    t49 = np.sqrt(t48)
    t50 = np.where(t49 != 0.0, 1, 0.0)
    t51 = t50 / (t49 + (1 - t50))
    t52 = t44 * t51
    t53 = t46 * t51
    t54 = t45 * t51
    t55 = t47 * t51
    t56 = t32 * t53 - (t29 * t52 + t30 * t54) - t33 * t55
    t57 = t52 + t29 * t56
    t58 = t54 + t30 * t56
    t59 = t53 - t32 * t56
    t60 = t55 + t33 * t56
    t61 = t57 * t57 + t58 * t58 + t59 * t59 + t60 * t60
    t62 = np.sqrt(t61)
    t63 = np.where(t62 != 0.0, 1, 0.0)
    t64 = t63 / (t62 + (1 - t63))
    t65 = t58 * t64
    t66 = s3 - t29 * t35
    t67 = t57 * t64
    t68 = t59 * t64
    t69 = t33 * t35 - t34
    t70 = t60 * t64
    t71 = t37 * t65 - t66 * t67 - t36 * t68 + t69 * t70
    t72 = t36 + t68 * t71
    t73 = t66 + t67 * t71
    t74 = 0.42 * s3
    t75 = c4 * t38 + t6 * t31
    t76 = t2 * t6 - t10 * t38
    t77 = t15 * t34 + t14 * t41
    t78 = t29 * t74 - t30 * t75 + t32 * t76 - t33 * t77
    t79 = t74 - t29 * t78
    t80 = t75 + t30 * t78
    t81 = t76 - t32 * t78
    t82 = t77 + t33 * t78
    t83 = t65 * t80 - t67 * t79 + t68 * t81 + t70 * t82
    t84 = t79 + t67 * t83
    t85 = t80 - t65 * t83
    t86 = t81 - t68 * t83
    t87 = t82 - t70 * t83
    t88 = t84 * t84 + t85 * t85 + t86 * t86 + t87 * t87
    t89 = np.sqrt(t88)
    t90 = np.where(t89 != 0.0, 1, 0.0)
    t91 = t90 / (t89 + (1 - t90))
    t92 = t84 * t91
    t93 = t85 * t91
    t94 = t86 * t91
    t95 = t87 * t91
    t96 = t29 * t92 - t30 * t93 + t32 * t94 - t33 * t95
    t97 = t92 - t29 * t96
    t98 = t93 + t30 * t96
    t99 = t94 - t32 * t96
    t100 = t95 + t33 * t96
    t101 = t65 * t98 - t67 * t97 + t68 * t99 + t70 * t100
    t102 = t97 + t67 * t101
    t103 = t98 - t65 * t101
    t104 = t99 - t68 * t101
    t105 = t100 - t70 * t101
    t106 = t102 * t102 + t103 * t103 + t104 * t104 + t105 * t105
    t107 = np.sqrt(t106)
    t108 = np.where(t107 != 0.0, 1, 0.0)
    t109 = t108 / (t107 + (1 - t108))
    t110 = t102 * t109
    t111 = t37 - t65 * t71
    t112 = t103 * t109
    t113 = t104 * t109
    t114 = t69 - t70 * t71
    t115 = t105 * t109
    t116 = t73 * t110 + t111 * t112 - t72 * t113 + t114 * t115
    t117 = t72 + t113 * t116
    t118 = t114 - t115 * t116
    t119 = t73 - t110 * t116
    t120 = t111 - t112 * t116
    t121 = t117 * t117 + t118 * t118 + t119 * t119 + t120 * t120
    t122 = np.sqrt((t121 + s2 * s2))
    t123 = np.where(t122 != 0.0, 1, 0.0)
    t124 = t123 / (t122 + (1 - t123))
    t125 = t117 * t124
    t126 = t119 * t124
    t127 = t120 * t124
    t128 = t118 * t124
    t129 = t29 * t126 - t30 * t127 - t32 * t125 - t33 * t128
    t130 = t125 + t32 * t129
    t131 = t127 + t30 * t129
    t132 = t126 - t29 * t129
    t133 = t128 + t33 * t129
    t134 = t65 * t131 - t67 * t132 - t68 * t130 + t70 * t133
    t135 = t130 + t68 * t134
    t136 = t132 + t67 * t134
    t137 = t131 - t65 * t134
    t138 = t133 - t70 * t134
    t139 = t110 * t136 + t112 * t137 - t113 * t135 + t115 * t138
    t140 = t135 + t113 * t139
    t141 = t138 - t115 * t139
    t142 = t136 - t110 * t139
    t143 = t137 - t112 * t139
    t144 = t140 * t140 + t141 * t141 + t142 * t142 + t143 * t143
    t145 = s2 * t124
    t146 = np.sqrt((t144 + t145 * t145))
    t147 = np.where(t146 != 0.0, 1, 0.0)
    t148 = t147 / (t146 + (1 - t147))
    t149 = t145 * t148
    t150 = t10 * t32 + c4 * t30 + t14 * t33
    t151 = t33 * t150 - t14
    t152 = t29 * t150
    t153 = t30 * t150 - c4
    t154 = t10 - t32 * t150
    t155 = t67 * t152 + t65 * t153 + t68 * t154 + t70 * t151
    t156 = t151 - t70 * t155
    t157 = t67 * t155 - t152
    t158 = t153 - t65 * t155
    t159 = t154 - t68 * t155
    t160 = t110 * t157 + t112 * t158 + t113 * t159 + t115 * t156
    t161 = t156 - t115 * t160
    t162 = t141 * t148
    t163 = t159 - t113 * t160
    t164 = t140 * t148
    t165 = t157 - t110 * t160
    t166 = t142 * t148
    t167 = t158 - t112 * t160
    t168 = t143 * t148
    t169 = t161 * t162 - t163 * t164 + t165 * t166 + t167 * t168
    t170 = t169 + t149 * c2
    t171 = t149 * t170 - c2
    t172 = t165 - t166 * t170
    t173 = t167 - t168 * t170
    t174 = t163 + t164 * t170
    t175 = 1 + t171 * t171 + t172 * t172 + t173 * t173 + t174 * t174
    t176 = t161 - t162 * t170
    t177 = np.sqrt((t175 + t176 * t176))
    t178 = np.where(t177 != 0.0, 1, 0.0)
    t179 = t178 / (t177 + (1 - t178))
    t180 = t171 * t179
    t181 = t176 * t179
    t182 = t172 * t179
    t183 = t173 * t179
    t184 = t174 * t179
    t185 = t29 * t182 - t30 * t183 + t32 * t184 - t33 * t181
    t186 = t181 + t33 * t185
    t187 = t183 + t30 * t185
    t188 = t182 - t29 * t185
    t189 = t184 - t32 * t185
    t190 = t65 * t187 - t67 * t188 + t68 * t189 + t70 * t186
    t191 = t186 - t70 * t190
    t192 = t188 + t67 * t190
    t193 = t187 - t65 * t190
    t194 = t189 - t68 * t190
    t195 = t110 * t192 + t112 * t193 + t113 * t194 + t115 * t191
    t196 = t191 - t115 * t195
    t197 = t194 - t113 * t195
    t198 = t192 - t110 * t195
    t199 = t193 - t112 * t195
    t200 = t162 * t196 - t164 * t197 + t166 * t198 + t168 * t199
    t201 = t200 - t149 * t180
    t202 = t180 + t149 * t201
    t203 = t198 - t166 * t201
    t204 = t199 - t168 * t201
    t205 = t179 * t179 + t202 * t202 + t203 * t203 + t204 * t204
    t206 = t197 + t164 * t201
    t207 = t196 - t162 * t201
    t208 = np.sqrt((t205 + t206 * t206 + t207 * t207))
    t209 = np.where(t208 != 0.0, 1, 0.0)
    t210 = t209 / (t208 + (1 - t209))
    t211 = t202 * t210
    t212 = t4 * t30 + t9 * t32 - c3 * t29 + t12 * t33
    t213 = t33 * t212 - t12
    t214 = c3 + t29 * t212
    t215 = t30 * t212 - t4
    t216 = t9 - t32 * t212
    t217 = t67 * t214 + t65 * t215 + t68 * t216 + t70 * t213
    t218 = t213 - t70 * t217
    t219 = t67 * t217 - t214
    t220 = t215 - t65 * t217
    t221 = t216 - t68 * t217
    t222 = t110 * t219 + t112 * t220 + t113 * t221 + t115 * t218
    t223 = t218 - t115 * t222
    t224 = t221 - t113 * t222
    t225 = t219 - t110 * t222
    t226 = t220 - t112 * t222
    t227 = t162 * t223 - t164 * t224 + t166 * t225 + t168 * t226
    t228 = t149 * t227
    t229 = t225 - t166 * t227
    t230 = t203 * t210
    t231 = t226 - t168 * t227
    t232 = t204 * t210
    t233 = t224 + t164 * t227
    t234 = t206 * t210
    t235 = t211 * t228 + t229 * t230 + t231 * t232 + t233 * t234
    t236 = t223 - t162 * t227
    t237 = t207 * t210
    t238 = t235 + t236 * t237
    t239 = t228 - t211 * t238
    t240 = t179 * t210
    t241 = t238 * t240
    t242 = t229 - t230 * t238
    t243 = t231 - t232 * t238
    t244 = 1 + t239 * t239 + t241 * t241 + t242 * t242 + t243 * t243
    t245 = t233 - t234 * t238
    t246 = t236 - t237 * t238
    t247 = np.sqrt((t244 + t245 * t245 + t246 * t246))
    t248 = np.where(t247 != 0.0, 1, 0.0)
    t249 = t248 / (t247 + (1 - t248))
    t250 = t239 * t249
    t251 = t246 * t249
    t252 = t242 * t249
    t253 = t243 * t249
    t254 = t245 * t249
    t255 = t29 * t252 - t30 * t253 + t32 * t254 - t33 * t251
    t256 = t251 + t33 * t255
    t257 = t253 + t30 * t255
    t258 = t252 - t29 * t255
    t259 = t254 - t32 * t255
    t260 = t65 * t257 - t67 * t258 + t68 * t259 + t70 * t256
    t261 = t256 - t70 * t260
    t262 = t258 + t67 * t260
    t263 = t257 - t65 * t260
    t264 = t259 - t68 * t260
    t265 = t110 * t262 + t112 * t263 + t113 * t264 + t115 * t261
    t266 = t261 - t115 * t265
    t267 = t264 - t113 * t265
    t268 = t262 - t110 * t265
    t269 = t263 - t112 * t265
    t270 = t162 * t266 - t164 * t267 + t166 * t268 + t168 * t269
    t271 = t270 - t149 * t250
    t272 = t250 + t149 * t271
    t273 = t268 - t166 * t271
    t274 = t269 - t168 * t271
    t275 = t267 + t164 * t271
    t276 = t211 * t272 + t230 * t273 + t232 * t274 + t234 * t275
    t277 = t266 - t162 * t271
    t278 = t241 * t249
    t279 = t276 + t237 * t277 - t240 * t278
    t280 = t272 - t211 * t279
    t281 = t278 + t240 * t279
    t282 = t273 - t230 * t279
    t283 = t249 * t249 + t280 * t280 + t281 * t281 + t282 * t282
    t284 = t274 - t232 * t279
    t285 = t275 - t234 * t279
    t286 = t277 - t237 * t279
    t287 = np.sqrt((t283 + t284 * t284 + t285 * t285 + t286 * t286))
    t288 = np.where(t287 != 0.0, 1, 0.0)
    t289 = t288 / (t287 + (1 - t288))
    t290 = t280 * t289
    t291 = t249 * t289
    t292 = -(t290 * t291)
    t293 = t281 * t289
    t294 = t211 * t240 - t290 * t293
    t295 = t282 * t289
    t296 = t149 * t166 - t211 * t230 - t290 * t295
    t297 = t284 * t289
    t298 = t149 * t168 - t211 * t232 - t290 * t297
    t299 = t285 * t289
    t300 = -(t149 * t164 + t211 * t234 + t290 * t299)
    t301 = t286 * t289
    t302 = t149 * t162 - t211 * t237 - t290 * t301
    t303 = -(t291 * t293)
    t304 = -(t291 * t295)
    t305 = -(t291 * t297)
    t306 = -(t291 * t299)
    t307 = -(t291 * t301)
    t308 = t230 * t240 - t293 * t295
    t309 = t232 * t240 - t293 * t297
    t310 = t234 * t240 - t293 * t299
    t311 = t237 * t240 - t293 * t301
    t312 = 1 - t29 * t29 - t67 * t67 - t110 * t110 - t166 * t166
    t313 = t29 * t30 + t65 * t67 - t110 * t112 - t166 * t168
    t314 = t313 - t230 * t232 - t295 * t297
    t315 = t67 * t68 - t29 * t32 - t110 * t113 + t164 * t166
    t316 = t315 - t230 * t234 - t295 * t299
    t317 = t29 * t33 + t67 * t70 - t110 * t115 - t162 * t166
    t318 = t317 - t230 * t237 - t295 * t301
    t319 = 1 - t30 * t30 - t65 * t65 - t112 * t112 - t168 * t168
    t320 = t30 * t32 - t65 * t68 - t112 * t113 + t164 * t168
    t321 = t320 - t232 * t234 - t297 * t299
    t322 = t30 * t33 + t65 * t70 + t112 * t115 + t162 * t168
    t323 = -(t322 + t232 * t237 + t297 * t301)
    t324 = 1 - t32 * t32 - t68 * t68 - t113 * t113 - t164 * t164
    t325 = t32 * t33 - t68 * t70 - t113 * t115 + t162 * t164
    t326 = t325 - t234 * t237 - t299 * t301
    t327 = 1 - t33 * t33 - t70 * t70 - t115 * t115 - t162 * t162

    # results
    null_projector = np.empty((*_leading, 49), _real)
    null_projector[..., 0] = 1 - t149 * t149 - t211 * t211 - t290 * t290
    null_projector[..., 1] = t292
    null_projector[..., 2] = t294
    null_projector[..., 3] = t296
    null_projector[..., 4] = t298
    null_projector[..., 5] = t300
    null_projector[..., 6] = t302
    null_projector[..., 7] = t292
    null_projector[..., 8] = 1 - t291 * t291
    null_projector[..., 9] = t303
    null_projector[..., 10] = t304
    null_projector[..., 11] = t305
    null_projector[..., 12] = t306
    null_projector[..., 13] = t307
    null_projector[..., 14] = t294
    null_projector[..., 15] = t303
    null_projector[..., 16] = 1 - t240 * t240 - t293 * t293
    null_projector[..., 17] = t308
    null_projector[..., 18] = t309
    null_projector[..., 19] = t310
    null_projector[..., 20] = t311
    null_projector[..., 21] = t296
    null_projector[..., 22] = t304
    null_projector[..., 23] = t308
    null_projector[..., 24] = t312 - t230 * t230 - t295 * t295
    null_projector[..., 25] = t314
    null_projector[..., 26] = t316
    null_projector[..., 27] = t318
    null_projector[..., 28] = t298
    null_projector[..., 29] = t305
    null_projector[..., 30] = t309
    null_projector[..., 31] = t314
    null_projector[..., 32] = t319 - t232 * t232 - t297 * t297
    null_projector[..., 33] = t321
    null_projector[..., 34] = t323
    null_projector[..., 35] = t300
    null_projector[..., 36] = t306
    null_projector[..., 37] = t310
    null_projector[..., 38] = t316
    null_projector[..., 39] = t321
    null_projector[..., 40] = t324 - t234 * t234 - t299 * t299
    null_projector[..., 41] = t326
    null_projector[..., 42] = t302
    null_projector[..., 43] = t307
    null_projector[..., 44] = t311
    null_projector[..., 45] = t318
    null_projector[..., 46] = t323
    null_projector[..., 47] = t326
    null_projector[..., 48] = t327 - t237 * t237 - t301 * t301
    return null_projector.reshape(_leading + (7, 7))
