"""manipulability (pose) of crx10ial, in NumPy.

Made from templates/kernel.py.j2; inputs 55b7d4c84e96f27e355e50e23bd9f9ce934c7a2e6ebc0ad64c63cdd103d17a6c.
319 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_pose(q):
    """manipulability H = sqrt(det(J J^T)) of the pose Jacobian: 60 operations.

    in   q[6]
    out  manipulability (one number)
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s3 = np.sin(q3)
    s4 = np.sin(q4)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    q5 = q[..., 4]
    s5 = np.sin(q5)
    c5 = np.cos(q5)

    # terms
    t1 = -0.71 * c3
    t2 = 0.71 * s3
    t3 = 0.15 * c4
    t4 = 0.15 * s4
    t5 = t1 * (-0.54 * c4) + t2 * (t3 * s4 - c4 * t4)
    t6 = c3 * c2 + s3 * s2
    t7 = t1 * (c3 * s2 - s3 * c2) - t2 * t6
    t8 = c4 * s5
    t9 = s4 * s5
    t10 = t3 - 0.16 * t9
    t11 = t4 + 0.16 * t8
    t12 = -0.54 - 0.16 * c5
    t13 = t2 * (t8 * t10 + t9 * t11) - t1 * (t9 * t12 - t10 * c5)
    t14 = t5 * (t11 * c5 + t8 * t12) + t13 * (0.54 * s4)
    t15 = t5 * t7 * t8 - s4 * (t7 * t13) + t6 * t14

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.abs(t15)
    return manipulability.reshape(_leading)


def manipulability_gradient_pose(q):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in lexicographic order: 199 operations.

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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s3 = np.sin(q3)
    s4 = np.sin(q4)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    q5 = q[..., 4]
    s5 = np.sin(q5)
    c5 = np.cos(q5)

    # terms
    t1 = -0.71 * c3
    t2 = -0.54 * c4
    t3 = 0.71 * s3
    t4 = 0.15 * c4
    t5 = 0.15 * s4
    t6 = t4 * s4 - c4 * t5
    t7 = t1 * t2 + t3 * t6
    t8 = c3 * s2 - s3 * c2
    t9 = c3 * c2 + s3 * s2
    t10 = t1 * t8 - t3 * t9
    t11 = t7 * t10
    t12 = c4 * s5
    t13 = s4 * s5
    t14 = t4 - 0.16 * t13
    t15 = t5 + 0.16 * t12
    t16 = t12 * t14 + t13 * t15
    t17 = -0.54 - 0.16 * c5
    t18 = t13 * t17 - t14 * c5
    t19 = t3 * t16 - t1 * t18
    t20 = t10 * t19
    t21 = t15 * c5 + t12 * t17
    t22 = 0.54 * s4
    t23 = t7 * t21 + t19 * t22
    t24 = t11 * t12 - s4 * t20 + t9 * t23
    t25 = np.abs(t24)
    t26 = t24 / t25
    t27 = t12 * t26
    t28 = s4 * t26
    t29 = t7 * t27 - t19 * t28
    t30 = t23 * t26 - t3 * t29
    t31 = t1 * t29
    t32 = c2 * (s3 * t30 + c3 * t31) - s2 * (c3 * t30 - s3 * t31)
    t33 = t9 * t26
    t34 = t22 * t33 - t10 * t28
    t35 = t21 * t33 + t10 * t27
    t36 = s2 * t30 - c2 * t31 + 0.71 * (t16 * t34 - t9 * t29 + t6 * t35)
    t37 = c2 * t30 + s2 * t31 + -0.71 * (t8 * t29 - t18 * t34 + t2 * t35)
    t38 = c3 * t36 - s3 * t37
    t39 = t3 * t34
    t40 = t1 * t34
    t41 = c5 * t40 + t12 * t39
    t42 = t15 * t39 - t17 * t40 - 0.16 * t41
    t43 = t7 * t33
    t44 = c5 * t43 + t13 * t39
    t45 = t3 * t35
    t46 = 0.54 * (t19 * t33) - t20 * t26 + s5 * t42 + 0.15 * (t44 - c4 * t45)
    t47 = t17 * t43 + 0.16 * t44 + t14 * t39 + t11 * t26
    t48 = s5 * t47 - t5 * t45 + 0.15 * (t41 + s4 * t45)
    t49 = c4 * (t46 + t4 * t45) - s4 * (t48 + -0.54 * (t1 * t35))
    t50 = t15 * t43 + t14 * t40 - 0.16 * (t12 * t43 - t13 * t40)
    t51 = c5 * (s4 * t42 + c4 * t47) - s5 * t50
    t52 = 1 / t25
    t53 = t52 * t52
    t54 = -0.5 / t25 * np.sqrt(t52)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 6), _real)
    inverse_gradient = np.empty((*_leading, 6), _real)
    inverse_root_gradient = np.empty((*_leading, 6), _real)
    manipulability[..., 0] = t25
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t25 != 0.0, t32, 0.0)
    gradient[..., 2] = np.where(t25 != 0.0, t38, 0.0)
    gradient[..., 3] = np.where(t25 != 0.0, t49, 0.0)
    gradient[..., 4] = np.where(t25 != 0.0, t51, 0.0)
    gradient[..., 5] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t25 != 0.0, -(t32 * t53), 0.0)
    inverse_gradient[..., 2] = np.where(t25 != 0.0, -(t38 * t53), 0.0)
    inverse_gradient[..., 3] = np.where(t25 != 0.0, -(t49 * t53), 0.0)
    inverse_gradient[..., 4] = np.where(t25 != 0.0, -(t51 * t53), 0.0)
    inverse_gradient[..., 5] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t25 != 0.0, t32 * t54, 0.0)
    inverse_root_gradient[..., 2] = np.where(t25 != 0.0, t38 * t54, 0.0)
    inverse_root_gradient[..., 3] = np.where(t25 != 0.0, t49 * t54, 0.0)
    inverse_root_gradient[..., 4] = np.where(t25 != 0.0, t51 * t54, 0.0)
    inverse_root_gradient[..., 5] = 0.0
    return manipulability.reshape(_leading), gradient.reshape(_leading + (6,)), inverse_gradient.reshape(_leading + (6,)), inverse_root_gradient.reshape(_leading + (6,))


def minors_pose(q):
    """maximal minors of the pose Jacobian, columns in lexicographic order: 60 operations.

    in   q[6]
    out  minors[1]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    s3 = np.sin(q3)
    s4 = np.sin(q4)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    q5 = q[..., 4]
    s5 = np.sin(q5)
    c5 = np.cos(q5)

    # terms
    t1 = -0.71 * c3
    t2 = 0.71 * s3
    t3 = 0.15 * c4
    t4 = 0.15 * s4
    t5 = t1 * (-0.54 * c4) + t2 * (t3 * s4 - c4 * t4)
    t6 = c3 * c2 + s3 * s2
    t7 = t1 * (c3 * s2 - s3 * c2) - t2 * t6
    t8 = c4 * s5
    t9 = s4 * s5
    t10 = t3 - 0.16 * t9
    t11 = t4 + 0.16 * t8
    t12 = -0.54 - 0.16 * c5
    t13 = t2 * (t8 * t10 + t9 * t11) - t1 * (t9 * t12 - t10 * c5)
    t14 = t5 * (t11 * c5 + t8 * t12) + t13 * (0.54 * s4)
    t15 = t5 * t7 * t8 - s4 * (t7 * t13) + t6 * t14

    # results
    minors = np.empty((*_leading, 1), _real)
    minors[..., 0] = -t15
    return minors.reshape(_leading + (1,))
