"""manipulability (pose) of iiwa14, in NumPy.

Made from templates/kernel.py.j2; inputs c651bc750b16194a69b4fb16a3147b4955beefc4951f117b4404890e4ed85dd7.
1726 operations. Do not edit: change the derivation and regenerate.

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
    """projector I - J^+ J onto the null space of the pose Jacobian: 831 operations.

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
    t23 = c3 * s4
    t24 = t11 * t20
    t25 = t16 * t20
    t26 = c6 * t23 - s6 * (c5 * t1 - s3 * s5)
    t27 = s3 * t21 + t22 * t23 - t2 * t24 + t25 * t26
    t28 = t2 + t24 * t27
    t29 = t22 * t27 - t23
    t30 = 0.4 * t23
    t31 = t2 * t5 + t9 * t30
    t32 = t5 * t23 - t4 * t30
    t33 = t30 + 0.126 * t26
    t34 = t13 * t26 - t12 * t33
    t35 = t24 * t31 - t22 * t32 - t25 * t34
    t36 = t21 * t35
    t37 = t31 - t24 * t35
    t38 = t32 + t22 * t35
    t39 = t34 + t25 * t35
    t40 = t24 * t37 - (t21 * t36 + t22 * t38) - t25 * t39
    t41 = t36 + t21 * t40
    t42 = t38 + t22 * t40
    t43 = t37 - t24 * t40
    t44 = t39 + t25 * t40
    t45 = t41 * t41 + t42 * t42 + t43 * t43 + t44 * t44
    t46 = np.sqrt(t45)
    t47 = np.where(t46 != 0.0, 1, 0.0)
    t48 = t47 / (t46 + (1 - t47))
    t49 = t42 * t48
    t50 = s3 - t21 * t27
    t51 = t41 * t48
    t52 = t43 * t48
    t53 = t25 * t27 - t26
    t54 = t44 * t48
    t55 = t29 * t49 - t50 * t51 - t28 * t52 + t53 * t54
    t56 = t28 + t52 * t55
    t57 = t50 + t51 * t55
    t58 = 0.42 * s3
    t59 = c4 * t30 + t6 * t23
    t60 = t2 * t6 - t10 * t30
    t61 = t15 * t26 + t14 * t33
    t62 = t21 * t58 - t22 * t59 + t24 * t60 - t25 * t61
    t63 = t58 - t21 * t62
    t64 = t59 + t22 * t62
    t65 = t60 - t24 * t62
    t66 = t61 + t25 * t62
    t67 = t49 * t64 - t51 * t63 + t52 * t65 + t54 * t66
    t68 = t63 + t51 * t67
    t69 = t64 - t49 * t67
    t70 = t65 - t52 * t67
    t71 = t66 - t54 * t67
    t72 = t21 * t68 - t22 * t69 + t24 * t70 - t25 * t71
    t73 = t68 - t21 * t72
    t74 = t69 + t22 * t72
    t75 = t70 - t24 * t72
    t76 = t71 + t25 * t72
    t77 = t49 * t74 - t51 * t73 + t52 * t75 + t54 * t76
    t78 = t73 + t51 * t77
    t79 = t74 - t49 * t77
    t80 = t75 - t52 * t77
    t81 = t76 - t54 * t77
    t82 = t78 * t78 + t79 * t79 + t80 * t80 + t81 * t81
    t83 = np.sqrt(t82)
    t84 = np.where(t83 != 0.0, 1, 0.0)
    t85 = t84 / (t83 + (1 - t84))
    t86 = t78 * t85
    t87 = t29 - t49 * t55
    t88 = t79 * t85
    t89 = t80 * t85
    t90 = t53 - t54 * t55
    t91 = t81 * t85
    t92 = t57 * t86 + t87 * t88 - t56 * t89 + t90 * t91
    t93 = t56 + t89 * t92
    t94 = t57 - t86 * t92
    t95 = t90 - t91 * t92
    t96 = t87 - t88 * t92
    t97 = t21 * t94 - (t24 * t93 + t25 * t95) - t22 * t96
    t98 = t93 + t24 * t97
    t99 = t96 + t22 * t97
    t100 = t94 - t21 * t97
    t101 = t95 + t25 * t97
    t102 = t49 * t99 - t51 * t100 - t52 * t98 + t54 * t101
    t103 = t98 + t52 * t102
    t104 = t100 + t51 * t102
    t105 = t99 - t49 * t102
    t106 = t101 - t54 * t102
    t107 = t86 * t104 + t88 * t105 - t89 * t103 + t91 * t106
    t108 = t103 + t89 * t107
    t109 = t106 - t91 * t107
    t110 = t104 - t86 * t107
    t111 = t105 - t88 * t107
    t112 = t108 * t108 + t109 * t109 + t110 * t110 + t111 * t111
    t113 = np.sqrt((t112 + s2 * s2))
    t114 = np.where(t113 != 0.0, 1, 0.0)
    t115 = t114 / (t113 + (1 - t114))
    t116 = s2 * t115
    t117 = t10 * t24 + c4 * t22 + t14 * t25
    t118 = t25 * t117 - t14
    t119 = t21 * t117
    t120 = t22 * t117 - c4
    t121 = t10 - t24 * t117
    t122 = t51 * t119 + t49 * t120 + t52 * t121 + t54 * t118
    t123 = t118 - t54 * t122
    t124 = t51 * t122 - t119
    t125 = t120 - t49 * t122
    t126 = t121 - t52 * t122
    t127 = t86 * t124 + t88 * t125 + t89 * t126 + t91 * t123
    t128 = t123 - t91 * t127
    t129 = t109 * t115
    t130 = t126 - t89 * t127
    t131 = t108 * t115
    t132 = t124 - t86 * t127
    t133 = t110 * t115
    t134 = t125 - t88 * t127
    t135 = t111 * t115
    t136 = t128 * t129 - t130 * t131 + t132 * t133 + t134 * t135
    t137 = t136 + t116 * c2
    t138 = t116 * t137 - c2
    t139 = t128 - t129 * t137
    t140 = t132 - t133 * t137
    t141 = t134 - t135 * t137
    t142 = t130 + t131 * t137
    t143 = t21 * t140 - t22 * t141 + t24 * t142 - t25 * t139
    t144 = t139 + t25 * t143
    t145 = t141 + t22 * t143
    t146 = t140 - t21 * t143
    t147 = t142 - t24 * t143
    t148 = t49 * t145 - t51 * t146 + t52 * t147 + t54 * t144
    t149 = t144 - t54 * t148
    t150 = t146 + t51 * t148
    t151 = t145 - t49 * t148
    t152 = t147 - t52 * t148
    t153 = t86 * t150 + t88 * t151 + t89 * t152 + t91 * t149
    t154 = t149 - t91 * t153
    t155 = t152 - t89 * t153
    t156 = t150 - t86 * t153
    t157 = t129 * t154 - (t116 * t138 + t131 * t155) + t133 * t156
    t158 = t151 - t88 * t153
    t159 = t157 + t135 * t158
    t160 = t138 + t116 * t159
    t161 = t156 - t133 * t159
    t162 = t158 - t135 * t159
    t163 = t155 + t131 * t159
    t164 = 1 + t160 * t160 + t161 * t161 + t162 * t162 + t163 * t163
    t165 = t154 - t129 * t159
    t166 = np.sqrt((t164 + t165 * t165))
    t167 = np.where(t166 != 0.0, 1, 0.0)
    t168 = t167 / (t166 + (1 - t167))
    t169 = t160 * t168
    t170 = t4 * t22 + t9 * t24 - c3 * t21 + t12 * t25
    t171 = t25 * t170 - t12
    t172 = c3 + t21 * t170
    t173 = t22 * t170 - t4
    t174 = t9 - t24 * t170
    t175 = t51 * t172 + t49 * t173 + t52 * t174 + t54 * t171
    t176 = t171 - t54 * t175
    t177 = t51 * t175 - t172
    t178 = t173 - t49 * t175
    t179 = t174 - t52 * t175
    t180 = t86 * t177 + t88 * t178 + t89 * t179 + t91 * t176
    t181 = t176 - t91 * t180
    t182 = t179 - t89 * t180
    t183 = t177 - t86 * t180
    t184 = t178 - t88 * t180
    t185 = t129 * t181 - t131 * t182 + t133 * t183 + t135 * t184
    t186 = t116 * t185
    t187 = t183 - t133 * t185
    t188 = t161 * t168
    t189 = t184 - t135 * t185
    t190 = t162 * t168
    t191 = t182 + t131 * t185
    t192 = t163 * t168
    t193 = t169 * t186 + t187 * t188 + t189 * t190 + t191 * t192
    t194 = t181 - t129 * t185
    t195 = t165 * t168
    t196 = t193 + t194 * t195
    t197 = t186 - t169 * t196
    t198 = t194 - t195 * t196
    t199 = t187 - t188 * t196
    t200 = t189 - t190 * t196
    t201 = t191 - t192 * t196
    t202 = t21 * t199 - t22 * t200 + t24 * t201 - t25 * t198
    t203 = t198 + t25 * t202
    t204 = t200 + t22 * t202
    t205 = t199 - t21 * t202
    t206 = t201 - t24 * t202
    t207 = t49 * t204 - t51 * t205 + t52 * t206 + t54 * t203
    t208 = t203 - t54 * t207
    t209 = t205 + t51 * t207
    t210 = t204 - t49 * t207
    t211 = t206 - t52 * t207
    t212 = t86 * t209 + t88 * t210 + t89 * t211 + t91 * t208
    t213 = t208 - t91 * t212
    t214 = t211 - t89 * t212
    t215 = t209 - t86 * t212
    t216 = t129 * t213 - (t116 * t197 + t131 * t214) + t133 * t215
    t217 = t210 - t88 * t212
    t218 = t216 + t135 * t217
    t219 = t197 + t116 * t218
    t220 = t215 - t133 * t218
    t221 = t217 - t135 * t218
    t222 = t214 + t131 * t218
    t223 = t169 * t219 + t188 * t220 + t190 * t221 + t192 * t222
    t224 = t213 - t129 * t218
    t225 = t168 * t196
    t226 = t223 + t195 * t224 - t168 * t225
    t227 = t219 - t169 * t226
    t228 = t225 + t168 * t226
    t229 = t220 - t188 * t226
    t230 = t221 - t190 * t226
    t231 = 1 + t227 * t227 + t228 * t228 + t229 * t229 + t230 * t230
    t232 = t222 - t192 * t226
    t233 = t224 - t195 * t226
    t234 = np.sqrt((t231 + t232 * t232 + t233 * t233))
    t235 = np.where(t234 != 0.0, 1, 0.0)
    t236 = t235 / (t234 + (1 - t235))
    t237 = t227 * t236
    t238 = -(t236 * t237)
    t239 = t228 * t236
    t240 = t168 * t169 - t237 * t239
    t241 = t229 * t236
    t242 = t116 * t133 - t169 * t188 - t237 * t241
    t243 = t230 * t236
    t244 = t116 * t135 - t169 * t190 - t237 * t243
    t245 = t232 * t236
    t246 = -(t116 * t131 + t169 * t192 + t237 * t245)
    t247 = t233 * t236
    t248 = t116 * t129 - t169 * t195 - t237 * t247
    t249 = -(t236 * t239)
    t250 = -(t236 * t241)
    t251 = -(t236 * t243)
    t252 = -(t236 * t245)
    t253 = -(t236 * t247)
    t254 = t168 * t188 - t239 * t241
    t255 = t168 * t190 - t239 * t243
    t256 = t168 * t192 - t239 * t245
    t257 = t168 * t195 - t239 * t247
    t258 = 1 - t21 * t21 - t51 * t51 - t86 * t86 - t133 * t133
    t259 = t21 * t22 + t49 * t51 - t86 * t88 - t133 * t135
    t260 = t259 - t188 * t190 - t241 * t243
    t261 = t51 * t52 - t21 * t24 - t86 * t89 + t131 * t133
    t262 = t261 - t188 * t192 - t241 * t245
    t263 = t21 * t25 + t51 * t54 - t86 * t91 - t129 * t133
    t264 = t263 - t188 * t195 - t241 * t247
    t265 = 1 - t22 * t22 - t49 * t49 - t88 * t88 - t135 * t135
    t266 = t22 * t24 - t49 * t52 - t88 * t89 + t131 * t135
    t267 = t266 - t190 * t192 - t243 * t245
    t268 = t22 * t25 + t49 * t54 + t88 * t91 + t129 * t135
    t269 = -(t268 + t190 * t195 + t243 * t247)
    t270 = 1 - t24 * t24 - t52 * t52 - t89 * t89 - t131 * t131
    t271 = t24 * t25 - t52 * t54 - t89 * t91 + t129 * t131
    t272 = t271 - t192 * t195 - t245 * t247
    t273 = 1 - t25 * t25 - t54 * t54 - t91 * t91 - t129 * t129

    # results
    null_projector = np.empty((*_leading, 49), _real)
    null_projector[..., 0] = 1 - t116 * t116 - t169 * t169 - t237 * t237
    null_projector[..., 1] = t238
    null_projector[..., 2] = t240
    null_projector[..., 3] = t242
    null_projector[..., 4] = t244
    null_projector[..., 5] = t246
    null_projector[..., 6] = t248
    null_projector[..., 7] = t238
    null_projector[..., 8] = 1 - t236 * t236
    null_projector[..., 9] = t249
    null_projector[..., 10] = t250
    null_projector[..., 11] = t251
    null_projector[..., 12] = t252
    null_projector[..., 13] = t253
    null_projector[..., 14] = t240
    null_projector[..., 15] = t249
    null_projector[..., 16] = 1 - t168 * t168 - t239 * t239
    null_projector[..., 17] = t254
    null_projector[..., 18] = t255
    null_projector[..., 19] = t256
    null_projector[..., 20] = t257
    null_projector[..., 21] = t242
    null_projector[..., 22] = t250
    null_projector[..., 23] = t254
    null_projector[..., 24] = t258 - t188 * t188 - t241 * t241
    null_projector[..., 25] = t260
    null_projector[..., 26] = t262
    null_projector[..., 27] = t264
    null_projector[..., 28] = t244
    null_projector[..., 29] = t251
    null_projector[..., 30] = t255
    null_projector[..., 31] = t260
    null_projector[..., 32] = t265 - t190 * t190 - t243 * t243
    null_projector[..., 33] = t267
    null_projector[..., 34] = t269
    null_projector[..., 35] = t246
    null_projector[..., 36] = t252
    null_projector[..., 37] = t256
    null_projector[..., 38] = t262
    null_projector[..., 39] = t267
    null_projector[..., 40] = t270 - t192 * t192 - t245 * t245
    null_projector[..., 41] = t272
    null_projector[..., 42] = t248
    null_projector[..., 43] = t253
    null_projector[..., 44] = t257
    null_projector[..., 45] = t264
    null_projector[..., 46] = t269
    null_projector[..., 47] = t272
    null_projector[..., 48] = t273 - t195 * t195 - t247 * t247
    return null_projector.reshape(_leading + (7, 7))
