"""manipulability (pose) of gofa5, in NumPy.

Made from templates/kernel.py.j2; inputs 19a46f4830bd55b319121950d891878cb2720671f096ba4458529eee0f50857c.
507 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_pose(q):
    """manipulability H = sqrt(det(J J^T)) of the pose Jacobian: 95 operations.

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
    s3 = np.sin(q3)
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    s4 = np.sin(q4)

    # terms
    t1 = 0.444 * c2
    t2 = c2 * s3 + c3 * s2
    t3 = c2 * c3 - s3 * s2
    t4 = t1 - 0.47 * t2 + 0.11 * t3
    t5 = 0.444 * s2
    t6 = t5 + 0.47 * t3 + 0.11 * t2
    t7 = t3 * t4 + t2 * t6
    t8 = t4 * c4
    t9 = t1 * t7
    t10 = t6 * c4
    t11 = t2 * c4
    t12 = t3 * c5 - s5 * t11
    t13 = s5 * s4
    t14 = 0.101 * t13 - 0.08 * (c5 * s4)
    t15 = t3 * c4
    t16 = t2 * c5 + s5 * t15
    t17 = t4 - 0.101 * t16 + 0.08 * (c5 * t15 - t2 * s5)
    t18 = t14 * t16 + t13 * t17
    t19 = t6 + 0.101 * t12 + 0.08 * (c5 * t11 + t3 * s5)
    t20 = t13 * t19 - t12 * t14
    t21 = t2 * s4
    t22 = (t5 * (t7 * t8) - t9 * t10) * t12 - (t5 * (t7 * t18) - t9 * t20) * t21
    t23 = t4 * t21 - t6 * (t3 * s4)
    t24 = t12 * t17 + t16 * t19
    t25 = t5 * (t18 * t23 - t8 * t24) - t20 * (t1 * t23)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.abs((t22 + t3 * (t25 + t10 * (t1 * t24))))
    return manipulability.reshape(_leading)


def manipulability_gradient_pose(q):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in lexicographic order: 317 operations.

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
    s3 = np.sin(q3)
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    s4 = np.sin(q4)

    # terms
    t1 = 0.444 * c2
    t2 = c2 * s3 + c3 * s2
    t3 = c2 * c3 - s3 * s2
    t4 = t1 - 0.47 * t2 + 0.11 * t3
    t5 = 0.444 * s2
    t6 = t5 + 0.47 * t3 + 0.11 * t2
    t7 = t3 * t4 + t2 * t6
    t8 = t4 * c4
    t9 = t7 * t8
    t10 = t1 * t7
    t11 = t6 * c4
    t12 = t5 * t9 - t10 * t11
    t13 = t2 * c4
    t14 = t3 * c5 - s5 * t13
    t15 = s5 * s4
    t16 = 0.101 * t15 - 0.08 * (c5 * s4)
    t17 = t3 * c4
    t18 = t2 * c5 + s5 * t17
    t19 = t4 - 0.101 * t18 + 0.08 * (c5 * t17 - t2 * s5)
    t20 = t16 * t18 + t15 * t19
    t21 = t7 * t20
    t22 = t6 + 0.101 * t14 + 0.08 * (c5 * t13 + t3 * s5)
    t23 = t15 * t22 - t14 * t16
    t24 = t5 * t21 - t10 * t23
    t25 = t2 * s4
    t26 = t3 * s4
    t27 = t4 * t25 - t6 * t26
    t28 = t14 * t19 + t18 * t22
    t29 = t20 * t27 - t8 * t28
    t30 = t1 * t27
    t31 = t1 * t28
    t32 = t5 * t29 - t23 * t30 + t11 * t31
    t33 = t12 * t14 - t24 * t25 + t3 * t32
    t34 = np.abs(t33)
    t35 = t33 / t34
    t36 = t3 * t35
    t37 = t5 * t36
    t38 = t23 * t36
    t39 = t20 * t37 - t1 * t38
    t40 = t4 * t39 - t24 * t35
    t41 = t11 * t36
    t42 = t1 * t41 - t8 * t37
    t43 = t25 * t35
    t44 = t10 * t43 - t30 * t36
    t45 = t18 * t42 + t15 * t44
    t46 = 0.08 * t45
    t47 = t19 * t42 - t16 * t44 + 0.101 * t45 + t12 * t35
    t48 = c5 * t46 - s5 * t47
    t49 = t14 * t35
    t50 = t31 * t36 - t10 * t49
    t51 = t23 * t43 - t11 * t49
    t52 = t5 * t43
    t53 = t5 * t49
    t54 = t1 * t51 - t20 * t52 + t8 * t53
    t55 = t45 - t26 * t39 + c4 * t50 + t2 * t54
    t56 = s4 * t40 + c4 * t48 + 0.11 * t55
    t57 = 0.444 * (t55 + (t29 * t36 - t21 * t43 + t9 * t49))
    t58 = t6 * t39
    t59 = t27 * t37 - t7 * t52
    t60 = t14 * t42 + t15 * t59
    t61 = 0.08 * t60
    t62 = t22 * t42 - 0.101 * t60 + t16 * t59
    t63 = c5 * t61 + s5 * t62
    t64 = t32 * t35 - s4 * t58 + s5 * t46 + c4 * t63
    t65 = t7 * t53 - t28 * t37
    t66 = t60 + t25 * t39 + c4 * t65 + t3 * t54
    t67 = t64 + c5 * t47 + 0.47 * t55 + t4 * t54 + 0.11 * t66
    t68 = c5 * t62 - s5 * t61 + t6 * t54 - 0.47 * t66
    t69 = c2 * (c3 * t56 + t57 - s3 * t67 + c3 * t68)
    t70 = 0.444 * (t66 + (t28 * t41 - t27 * t38 + t7 * t51))
    t71 = s2 * (s3 * t56 + c3 * t67 + s3 * t68 + t70)
    t72 = t69 - t71
    t73 = c3 * (c2 * t56 - s2 * t67 + c2 * t68) - s3 * (s2 * t56 + c2 * t67 + s2 * t68)
    t74 = t18 * t59 - t14 * t44
    t75 = 0.08 * t74
    t76 = t22 * t44 + t19 * t59 + 0.101 * t74
    t77 = t2 * t40 - t3 * t58 - c5 * t75 + s5 * t76
    t78 = t3 * t63 + t2 * t48 + t6 * t50 + t4 * t65
    t79 = c4 * t77 - s4 * t78
    t80 = t3 * t46 - t2 * t61 + t17 * t62 + s4 * t76
    t81 = t13 * t46 + t17 * t61 + t2 * t62 - s4 * t75
    t82 = c5 * (t80 - t13 * t47) - s5 * (t81 + t3 * t47)
    t83 = 1 / t34
    t84 = t83 * t83
    t85 = -0.5 / t34 * np.sqrt(t83)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 6), _real)
    inverse_gradient = np.empty((*_leading, 6), _real)
    inverse_root_gradient = np.empty((*_leading, 6), _real)
    manipulability[..., 0] = t34
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t34 != 0.0, t72, 0.0)
    gradient[..., 2] = np.where(t34 != 0.0, t73, 0.0)
    gradient[..., 3] = np.where(t34 != 0.0, t79, 0.0)
    gradient[..., 4] = np.where(t34 != 0.0, t82, 0.0)
    gradient[..., 5] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t34 != 0.0, -(t72 * t84), 0.0)
    inverse_gradient[..., 2] = np.where(t34 != 0.0, -(t73 * t84), 0.0)
    inverse_gradient[..., 3] = np.where(t34 != 0.0, -(t79 * t84), 0.0)
    inverse_gradient[..., 4] = np.where(t34 != 0.0, -(t82 * t84), 0.0)
    inverse_gradient[..., 5] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t34 != 0.0, t72 * t85, 0.0)
    inverse_root_gradient[..., 2] = np.where(t34 != 0.0, t73 * t85, 0.0)
    inverse_root_gradient[..., 3] = np.where(t34 != 0.0, t79 * t85, 0.0)
    inverse_root_gradient[..., 4] = np.where(t34 != 0.0, t82 * t85, 0.0)
    inverse_root_gradient[..., 5] = 0.0
    return manipulability.reshape(_leading), gradient.reshape(_leading + (6,)), inverse_gradient.reshape(_leading + (6,)), inverse_root_gradient.reshape(_leading + (6,))


def minors_pose(q):
    """maximal minors of the pose Jacobian, columns in lexicographic order: 95 operations.

    in   q[6]
    out  minors[1]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q5 = q[..., 4]
    c5 = np.cos(q5)
    s5 = np.sin(q5)
    s4 = np.sin(q4)

    # terms
    t1 = 0.444 * c2
    t2 = c2 * s3 + c3 * s2
    t3 = c2 * c3 - s3 * s2
    t4 = t1 - 0.47 * t2 + 0.11 * t3
    t5 = 0.444 * s2
    t6 = t5 + 0.47 * t3 + 0.11 * t2
    t7 = t3 * t4 + t2 * t6
    t8 = t4 * c4
    t9 = t1 * t7
    t10 = t6 * c4
    t11 = t2 * c4
    t12 = t3 * c5 - s5 * t11
    t13 = s5 * s4
    t14 = 0.101 * t13 - 0.08 * (c5 * s4)
    t15 = t3 * c4
    t16 = t2 * c5 + s5 * t15
    t17 = t4 - 0.101 * t16 + 0.08 * (c5 * t15 - t2 * s5)
    t18 = t14 * t16 + t13 * t17
    t19 = t6 + 0.101 * t12 + 0.08 * (c5 * t11 + t3 * s5)
    t20 = t13 * t19 - t12 * t14
    t21 = t2 * s4
    t22 = (t5 * (t7 * t8) - t9 * t10) * t12 - (t5 * (t7 * t18) - t9 * t20) * t21
    t23 = t4 * t21 - t6 * (t3 * s4)
    t24 = t12 * t17 + t16 * t19
    t25 = t5 * (t18 * t23 - t8 * t24) - t20 * (t1 * t23)

    # results
    minors = np.empty((*_leading, 1), _real)
    minors[..., 0] = -(t22 + t3 * (t25 + t10 * (t1 * t24)))
    return minors.reshape(_leading + (1,))
