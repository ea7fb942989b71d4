"""manipulability (pose) of puma560, in NumPy.

Made from templates/kernel.py.j2; inputs 9c5263d0a335170a00b1a4b41977fae67b8eb34dc3618159050b7d905fdd6b83.
357 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_pose(q):
    """manipulability H = sqrt(det(J J^T)) of the pose Jacobian: 67 operations.

    in   q[6]
    out  manipulability (one number)
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q4 = q[..., 3]
    s4 = np.sin(q4)
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    q5 = q[..., 4]
    s5 = np.sin(q5)

    # terms
    t1 = 0.0203 * s4
    t2 = s4 * c3
    t3 = t1 + 0.15005 * c4 + 0.4318 * t2
    t4 = c3 * c2 - s2 * s3
    t5 = 0.4318 * s3 - 0.4318
    t6 = c2 * (s4 * s3) + t2 * s2
    t7 = t3 * t4 + t5 * t6
    t8 = s4 * t5
    t9 = c4 * c3
    t10 = c2 * (c4 * s3) + s2 * t9
    t11 = -0.0203 * c4
    t12 = t11 + 0.15005 * s4 - 0.4318 * t9
    t13 = t5 * t10 - t4 * t12
    t14 = c4 * t5
    t15 = (t7 * t8 + t13 * t14) * (s4 * t1 - c4 * t11)
    t16 = 0.4318 * s4
    t17 = -0.4318 * c4
    t18 = (t14 * t16 + t8 * t17) * (t6 * t12 + t3 * t10)
    t19 = (t7 * t16 - t13 * t17) * (s4 * t3 - c4 * t12)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.abs(((t15 + t18 + t19) * s5))
    return manipulability.reshape(_leading)


def manipulability_gradient_pose(q):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in lexicographic order: 224 operations.

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
    q4 = q[..., 3]
    s4 = np.sin(q4)
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    q5 = q[..., 4]
    s5 = np.sin(q5)
    c5 = np.cos(q5)

    # terms
    t1 = 0.0203 * s4
    t2 = s4 * c3
    t3 = t1 + 0.15005 * c4 + 0.4318 * t2
    t4 = c3 * c2 - s2 * s3
    t5 = 0.4318 * s3 - 0.4318
    t6 = s4 * s3
    t7 = c2 * t6 + t2 * s2
    t8 = t3 * t4 + t5 * t7
    t9 = s4 * t5
    t10 = c4 * s3
    t11 = c4 * c3
    t12 = c2 * t10 + s2 * t11
    t13 = -0.0203 * c4
    t14 = t13 + 0.15005 * s4 - 0.4318 * t11
    t15 = t5 * t12 - t4 * t14
    t16 = c4 * t5
    t17 = t8 * t9 + t15 * t16
    t18 = s4 * t1 - c4 * t13
    t19 = 0.4318 * s4
    t20 = -0.4318 * c4
    t21 = t16 * t19 + t9 * t20
    t22 = t7 * t14 + t3 * t12
    t23 = t8 * t19 - t15 * t20
    t24 = s4 * t3 - c4 * t14
    t25 = t17 * t18 + t21 * t22 + t23 * t24
    t26 = t25 * s5
    t27 = np.abs(t26)
    t28 = t26 / t27
    t29 = s5 * t28
    t30 = t21 * t29
    t31 = t18 * t29
    t32 = t24 * t29
    t33 = t16 * t31 - t20 * t32
    t34 = t3 * t30 + t5 * t33
    t35 = t19 * t32 + t9 * t31
    t36 = t14 * t30 + t5 * t35
    t37 = t3 * t35 - t14 * t33
    t38 = c2 * (t11 * t34 + t2 * t36 - s3 * t37) - s2 * (t10 * t34 + t6 * t36 + c3 * t37)
    t39 = c2 * t34
    t40 = c2 * t36
    t41 = t22 * t29
    t42 = t19 * t41 + t15 * t31
    t43 = t20 * t41 + t8 * t31
    t44 = c4 * t42 + t12 * t33 + s4 * t43 + t7 * t35
    t45 = c4 * t39 + s4 * t40 + 0.4318 * t44 - s2 * t37
    t46 = t23 * t29
    t47 = t7 * t30 - c4 * t46 - t4 * t33
    t48 = s2 * t34 - 0.4318 * t47
    t49 = s4 * t46 + t12 * t30 + t4 * t35
    t50 = s2 * t36 + 0.4318 * t49
    t51 = c3 * t45 - s3 * (c4 * t48 + c2 * t37 + s4 * t50)
    t52 = t17 * t29
    t53 = t3 * t46 + 0.4318 * (t8 * t32 + t16 * t41) + t1 * t52
    t54 = t53 + 0.15005 * t47 + t5 * t43 + s3 * t40 + c3 * t50
    t55 = -0.4318 * (t9 * t41 - t15 * t32) - t14 * t46 - t13 * t52
    t56 = t55 + t5 * t42 + -0.0203 * (t47 - c4 * t52) + c3 * t48
    t57 = c4 * (t54 + 0.0203 * (t49 + s4 * t52)) - s4 * (t56 + s3 * t39 + 0.15005 * t49)
    t58 = c5 * (t25 * t28)
    t59 = 1 / t27
    t60 = t59 * t59
    t61 = -0.5 / t27 * np.sqrt(t59)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 6), _real)
    inverse_gradient = np.empty((*_leading, 6), _real)
    inverse_root_gradient = np.empty((*_leading, 6), _real)
    manipulability[..., 0] = t27
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t27 != 0.0, t38, 0.0)
    gradient[..., 2] = np.where(t27 != 0.0, t51, 0.0)
    gradient[..., 3] = np.where(t27 != 0.0, t57, 0.0)
    gradient[..., 4] = np.where(t27 != 0.0, t58, 0.0)
    gradient[..., 5] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t27 != 0.0, -(t38 * t60), 0.0)
    inverse_gradient[..., 2] = np.where(t27 != 0.0, -(t51 * t60), 0.0)
    inverse_gradient[..., 3] = np.where(t27 != 0.0, -(t57 * t60), 0.0)
    inverse_gradient[..., 4] = np.where(t27 != 0.0, -(t58 * t60), 0.0)
    inverse_gradient[..., 5] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t27 != 0.0, t38 * t61, 0.0)
    inverse_root_gradient[..., 2] = np.where(t27 != 0.0, t51 * t61, 0.0)
    inverse_root_gradient[..., 3] = np.where(t27 != 0.0, t57 * t61, 0.0)
    inverse_root_gradient[..., 4] = np.where(t27 != 0.0, t58 * t61, 0.0)
    inverse_root_gradient[..., 5] = 0.0
    return manipulability.reshape(_leading), gradient.reshape(_leading + (6,)), inverse_gradient.reshape(_leading + (6,)), inverse_root_gradient.reshape(_leading + (6,))


def minors_pose(q):
    """maximal minors of the pose Jacobian, columns in lexicographic order: 66 operations.

    in   q[6]
    out  minors[1]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q4 = q[..., 3]
    s4 = np.sin(q4)
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    q5 = q[..., 4]
    s5 = np.sin(q5)

    # terms
    t1 = 0.0203 * s4
    t2 = s4 * c3
    t3 = t1 + 0.15005 * c4 + 0.4318 * t2
    t4 = c3 * c2 - s2 * s3
    t5 = 0.4318 * s3 - 0.4318
    t6 = c2 * (s4 * s3) + t2 * s2
    t7 = t3 * t4 + t5 * t6
    t8 = s4 * t5
    t9 = c4 * c3
    t10 = c2 * (c4 * s3) + s2 * t9
    t11 = -0.0203 * c4
    t12 = t11 + 0.15005 * s4 - 0.4318 * t9
    t13 = t5 * t10 - t4 * t12
    t14 = c4 * t5
    t15 = (t7 * t8 + t13 * t14) * (s4 * t1 - c4 * t11)
    t16 = 0.4318 * s4
    t17 = -0.4318 * c4
    t18 = (t14 * t16 + t8 * t17) * (t6 * t12 + t3 * t10)
    t19 = (t7 * t16 - t13 * t17) * (s4 * t3 - c4 * t12)

    # results
    minors = np.empty((*_leading, 1), _real)
    minors[..., 0] = (t15 + t18 + t19) * s5
    return minors.reshape(_leading + (1,))
