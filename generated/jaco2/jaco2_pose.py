"""manipulability (pose) of jaco2, in NumPy.

Made from templates/kernel.py.j2; inputs 1ad93e3c11b867e4c607122d6c1c8fda72f2a60d9e7231f3d78e1cc06c98b3ce.
624 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_pose(q):
    """manipulability H = sqrt(det(J J^T)) of the pose Jacobian: 126 operations.

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
    q4 = q[..., 3]
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    c4 = np.cos(q4)

    # terms
    t1 = 0.41 * s2
    t2 = c2 * c3 + s2 * s3
    t3 = t1 - 0.2500816549469513 * t2
    t4 = s2 * c3 - c2 * s3
    t5 = s4 * t4
    t6 = t3 - 0.04278165494695127 * t2 - 0.07409999999999999 * t5
    t7 = c5 * (0.8660254037844386 * t2 - 0.5000000000000001 * t5) - s5 * (t4 * c4)
    t8 = 0.8660254037844386 * t5 - -0.5000000000000001 * t2
    t9 = t6 + 0.17561406460551018 * t7 - 0.10139082747347566 * t8
    t10 = t2 * s4
    t11 = -0.5000000000000001 * t4 + 0.8660254037844386 * t10
    t12 = c5 * (0.5000000000000001 * t10 + 0.8660254037844386 * t4) + s5 * (t2 * c4)
    t13 = 0.5000000000000001 * t11 + 0.8660254037844386 * t12
    t14 = 0.41 * c2
    t15 = t14 + 0.2500816549469513 * t4
    t16 = t15 + 0.04278165494695127 * t4 - 0.07409999999999999 * t10
    t17 = t16 - 0.17561406460551018 * t12 - 0.10139082747347566 * t11
    t18 = 0.5000000000000001 * t8 - 0.8660254037844386 * t7
    t19 = t9 * t13 - t17 * t18
    t20 = t2 * t15 + t3 * t4
    t21 = t4 * t19 - t13 * t20
    t22 = -0.8660254037844386 * c4
    t23 = 0.07409999999999999 * c4 - 0.0098
    t24 = t6 * t11 - t8 * t16
    t25 = t4 * t24 - t11 * t20
    t26 = c5 * (0.5000000000000001 * c4) - s4 * s5
    t27 = -0.4330127018922194 * c4 - 0.8660254037844386 * t26
    t28 = t23 + 0.17561406460551018 * t26 - -0.0878070323027551 * c4
    t29 = t13 * t24 - t11 * t19
    t30 = t1 * t25 * (t17 * t27 - t13 * t28) + t1 * t29 * (-0.0098 * t4)
    t31 = t25 * (t18 * t28 - t9 * t27) - t29 * (0.0098 * t2)
    t32 = t1 * t21 * (t16 * t22 - t11 * t23) - t30 - t14 * (t31 - t21 * (t8 * t23 - t6 * t22))

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.abs(t32)
    return manipulability.reshape(_leading)


def manipulability_gradient_pose(q):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in lexicographic order: 372 operations.

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
    q4 = q[..., 3]
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    c4 = np.cos(q4)

    # terms
    t1 = 0.41 * s2
    t2 = c2 * c3 + s2 * s3
    t3 = t1 - 0.2500816549469513 * t2
    t4 = s2 * c3 - c2 * s3
    t5 = s4 * t4
    t6 = t3 - 0.04278165494695127 * t2 - 0.07409999999999999 * t5
    t7 = 0.8660254037844386 * t2 - 0.5000000000000001 * t5
    t8 = t4 * c4
    t9 = c5 * t7 - s5 * t8
    t10 = 0.8660254037844386 * t5 - -0.5000000000000001 * t2
    t11 = t6 + 0.17561406460551018 * t9 - 0.10139082747347566 * t10
    t12 = t2 * s4
    t13 = -0.5000000000000001 * t4 + 0.8660254037844386 * t12
    t14 = 0.5000000000000001 * t12 + 0.8660254037844386 * t4
    t15 = t2 * c4
    t16 = c5 * t14 + s5 * t15
    t17 = 0.5000000000000001 * t13 + 0.8660254037844386 * t16
    t18 = 0.41 * c2
    t19 = t18 + 0.2500816549469513 * t4
    t20 = t19 + 0.04278165494695127 * t4 - 0.07409999999999999 * t12
    t21 = t20 - 0.17561406460551018 * t16 - 0.10139082747347566 * t13
    t22 = 0.5000000000000001 * t10 - 0.8660254037844386 * t9
    t23 = t11 * t17 - t21 * t22
    t24 = t2 * t19 + t3 * t4
    t25 = t4 * t23 - t17 * t24
    t26 = t1 * t25
    t27 = -0.8660254037844386 * c4
    t28 = 0.07409999999999999 * c4 - 0.0098
    t29 = t20 * t27 - t13 * t28
    t30 = t6 * t13 - t10 * t20
    t31 = t4 * t30 - t13 * t24
    t32 = t1 * t31
    t33 = 0.5000000000000001 * c4
    t34 = c5 * t33 - s4 * s5
    t35 = -0.4330127018922194 * c4 - 0.8660254037844386 * t34
    t36 = t28 + 0.17561406460551018 * t34 - -0.0878070323027551 * c4
    t37 = t21 * t35 - t17 * t36
    t38 = t17 * t30 - t13 * t23
    t39 = t1 * t38
    t40 = -0.0098 * t4
    t41 = t22 * t36 - t11 * t35
    t42 = 0.0098 * t2
    t43 = t10 * t28 - t6 * t27
    t44 = t31 * t41 - t38 * t42 - t25 * t43
    t45 = t26 * t29 - (t32 * t37 + t39 * t40) - t18 * t44
    t46 = np.abs(t45)
    t47 = t45 / t46
    t48 = t32 * t47
    t49 = t18 * t47
    t50 = t29 * t47
    t51 = t43 * t49 + t1 * t50
    t52 = t40 * t47
    t53 = t42 * t49 - t1 * t52
    t54 = t4 * t51 - t13 * t53
    t55 = t35 * t48 + t22 * t54
    t56 = t30 * t53 + t36 * t48 - t24 * t51 + t11 * t54
    t57 = 0.17561406460551018 * t55 + 0.8660254037844386 * t56
    t58 = s5 * t57
    t59 = c5 * t57
    t60 = t26 * t47
    t61 = t37 * t47
    t62 = t41 * t49 + t1 * t61
    t63 = t17 * t53 - t4 * t62
    t64 = t27 * t60 - t10 * t63 - t55
    t65 = t24 * t62 - t23 * t53 + t6 * t63 - t28 * t60
    t66 = t65 + 0.10139082747347566 * t55 + 0.5000000000000001 * t56
    t67 = 0.5000000000000001 * t59 - 0.07409999999999999 * t64 + 0.8660254037844386 * t66
    t68 = c4 * t58 + s4 * t67
    t69 = t13 * t62 - t17 * t51
    t70 = t3 * t69 - (-0.0098 * (t39 * t47) + t30 * t62) + t23 * t51
    t71 = t64 + t2 * t69
    t72 = t70 + 0.04278165494695127 * t64 + 0.2500816549469513 * t71 + 0.8660254037844386 * t59 + -0.5000000000000001 * t66
    t73 = t31 * t49
    t74 = t36 * t73 + t21 * t54
    t75 = t35 * t73 + t17 * t54
    t76 = 0.8660254037844386 * t74 + 0.17561406460551018 * t75
    t77 = s5 * t76
    t78 = t25 * t49
    t79 = t28 * t78 - t20 * t63 - 0.5000000000000001 * t74 - 0.10139082747347566 * t75
    t80 = c5 * t76
    t81 = t75 + (t13 * t63 - t27 * t78)
    t82 = 0.8660254037844386 * t79 - 0.5000000000000001 * t80 - 0.07409999999999999 * t81
    t83 = t72 - c4 * t77 + s4 * t82
    t84 = 0.0098 * (t38 * t49) + t19 * t69 - -0.5000000000000001 * t79 + 0.8660254037844386 * t80
    t85 = t81 + t4 * t69
    t86 = t84 - 0.04278165494695127 * t81 - 0.2500816549469513 * t85
    t87 = 0.41 * (t85 + (t25 * t50 - (t38 * t52 + t31 * t61)))
    t88 = c2 * (s3 * t68 + c3 * t83 + s3 * t86 + t87)
    t89 = 0.41 * (t71 - t44 * t47) + c3 * t68 - s3 * t83
    t90 = t88 - s2 * (t89 + c3 * t86)
    t91 = c3 * (s2 * t68 - c2 * t83 + s2 * t86) - s3 * (c2 * t68 + s2 * t83 + c2 * t86)
    t92 = t17 * t48 - t22 * t73
    t93 = t11 * t73 - t21 * t48
    t94 = 0.17561406460551018 * t92 - 0.8660254037844386 * t93
    t95 = 0.5000000000000001 * (c5 * t94) - -0.0878070323027551 * t92 + -0.4330127018922194 * t93 + 0.07409999999999999 * (t92 + t10 * t78 - t13 * t60)
    t96 = t95 + -0.8660254037844386 * (t20 * t60 - t6 * t78) + t2 * t58
    t97 = c4 * (t2 * t67 - s5 * t94 + t4 * t82) - s4 * (t96 - t4 * t77)
    t98 = c5 * (t15 * t57 - s4 * t94 - t8 * t76) - s5 * (t33 * t94 + t14 * t57 + t7 * t76)
    t99 = 1 / t46
    t100 = t99 * t99
    t101 = -0.5 / t46 * np.sqrt(t99)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 6), _real)
    inverse_gradient = np.empty((*_leading, 6), _real)
    inverse_root_gradient = np.empty((*_leading, 6), _real)
    manipulability[..., 0] = t46
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t46 != 0.0, t90, 0.0)
    gradient[..., 2] = np.where(t46 != 0.0, t91, 0.0)
    gradient[..., 3] = np.where(t46 != 0.0, t97, 0.0)
    gradient[..., 4] = np.where(t46 != 0.0, t98, 0.0)
    gradient[..., 5] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t46 != 0.0, -(t90 * t100), 0.0)
    inverse_gradient[..., 2] = np.where(t46 != 0.0, -(t91 * t100), 0.0)
    inverse_gradient[..., 3] = np.where(t46 != 0.0, -(t97 * t100), 0.0)
    inverse_gradient[..., 4] = np.where(t46 != 0.0, -(t98 * t100), 0.0)
    inverse_gradient[..., 5] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t46 != 0.0, t90 * t101, 0.0)
    inverse_root_gradient[..., 2] = np.where(t46 != 0.0, t91 * t101, 0.0)
    inverse_root_gradient[..., 3] = np.where(t46 != 0.0, t97 * t101, 0.0)
    inverse_root_gradient[..., 4] = np.where(t46 != 0.0, t98 * t101, 0.0)
    inverse_root_gradient[..., 5] = 0.0
    return manipulability.reshape(_leading), gradient.reshape(_leading + (6,)), inverse_gradient.reshape(_leading + (6,)), inverse_root_gradient.reshape(_leading + (6,))


def minors_pose(q):
    """maximal minors of the pose Jacobian, columns in lexicographic order: 126 operations.

    in   q[6]
    out  minors[1]
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
    q4 = q[..., 3]
    s4 = np.sin(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    c4 = np.cos(q4)

    # terms
    t1 = 0.41 * s2
    t2 = c2 * c3 + s2 * s3
    t3 = t1 - 0.2500816549469513 * t2
    t4 = s2 * c3 - c2 * s3
    t5 = s4 * t4
    t6 = t3 - 0.04278165494695127 * t2 - 0.07409999999999999 * t5
    t7 = c5 * (0.8660254037844386 * t2 - 0.5000000000000001 * t5) - s5 * (t4 * c4)
    t8 = 0.8660254037844386 * t5 - -0.5000000000000001 * t2
    t9 = t6 + 0.17561406460551018 * t7 - 0.10139082747347566 * t8
    t10 = t2 * s4
    t11 = -0.5000000000000001 * t4 + 0.8660254037844386 * t10
    t12 = c5 * (0.5000000000000001 * t10 + 0.8660254037844386 * t4) + s5 * (t2 * c4)
    t13 = 0.5000000000000001 * t11 + 0.8660254037844386 * t12
    t14 = 0.41 * c2
    t15 = t14 + 0.2500816549469513 * t4
    t16 = t15 + 0.04278165494695127 * t4 - 0.07409999999999999 * t10
    t17 = t16 - 0.17561406460551018 * t12 - 0.10139082747347566 * t11
    t18 = 0.5000000000000001 * t8 - 0.8660254037844386 * t7
    t19 = t9 * t13 - t17 * t18
    t20 = t2 * t15 + t3 * t4
    t21 = t4 * t19 - t13 * t20
    t22 = -0.8660254037844386 * c4
    t23 = 0.07409999999999999 * c4 - 0.0098
    t24 = t6 * t11 - t8 * t16
    t25 = t4 * t24 - t11 * t20
    t26 = c5 * (0.5000000000000001 * c4) - s4 * s5
    t27 = -0.4330127018922194 * c4 - 0.8660254037844386 * t26
    t28 = t23 + 0.17561406460551018 * t26 - -0.0878070323027551 * c4
    t29 = t13 * t24 - t11 * t19
    t30 = t1 * t25 * (t17 * t27 - t13 * t28) + t1 * t29 * (-0.0098 * t4)
    t31 = t25 * (t18 * t28 - t9 * t27) - t29 * (0.0098 * t2)
    t32 = t1 * t21 * (t16 * t22 - t11 * t23) - t30 - t14 * (t31 - t21 * (t8 * t23 - t6 * t22))

    # results
    minors = np.empty((*_leading, 1), _real)
    minors[..., 0] = -t32
    return minors.reshape(_leading + (1,))
