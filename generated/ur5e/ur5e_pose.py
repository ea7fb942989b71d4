"""manipulability (pose) of ur5e, in NumPy.

Made from templates/kernel.py.j2; inputs aadd4c9853b241c514ca27ae82a3f2cb598febefd9711612d9090fdace4c3025.
217 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_pose(q):
    """manipulability H = sqrt(det(J J^T)) of the pose Jacobian: 38 operations.

    in   q[6]
    out  manipulability (one number)
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q5 = q[..., 4]
    s5 = np.sin(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    s4 = np.sin(q4)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s2 = np.sin(q2)

    # terms
    t1 = 0.3922 * c4
    t2 = c4 * c3 - s3 * s4
    t3 = t1 + 0.425 * t2
    t4 = c3 * s4 + c4 * s3
    t5 = -0.3922 * s4
    t6 = t5 - 0.425 * t4
    t7 = c2 * t4 + t2 * s2
    t8 = s5 * (t3 * (t2 * c2 - s2 * t4) - t6 * t7)
    t9 = t8 + t7 * (-0.0997 * s5)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.abs((t1 * (t6 * t9) - t3 * (t5 * t9)))
    return manipulability.reshape(_leading)


def manipulability_gradient_pose(q):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in lexicographic order: 142 operations.

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
    q5 = q[..., 4]
    s5 = np.sin(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    s4 = np.sin(q4)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s2 = np.sin(q2)
    c5 = np.cos(q5)

    # terms
    t1 = 0.3922 * c4
    t2 = c4 * c3 - s3 * s4
    t3 = t1 + 0.425 * t2
    t4 = c3 * s4 + c4 * s3
    t5 = t2 * c2 - s2 * t4
    t6 = -0.3922 * s4
    t7 = t6 - 0.425 * t4
    t8 = c2 * t4 + t2 * s2
    t9 = t3 * t5 - t7 * t8
    t10 = -0.0997 * s5
    t11 = s5 * t9 + t8 * t10
    t12 = t7 * t11
    t13 = t6 * t11
    t14 = t1 * t12 - t3 * t13
    t15 = np.abs(t14)
    t16 = t14 / t15
    t17 = t1 * t16
    t18 = t3 * t16
    t19 = t7 * t17 - t6 * t18
    t20 = s5 * t19
    t21 = t10 * t19 - t7 * t20
    t22 = t3 * t20
    t23 = c2 * (t2 * t21 - t4 * t22) - s2 * (t4 * t21 + t2 * t22)
    t24 = c2 * t21
    t25 = t11 * t17 - t8 * t20
    t26 = 0.425 * t25 + s2 * t22
    t27 = t5 * t20 - t13 * t16
    t28 = s2 * t21 + c2 * t22 + 0.425 * t27
    t29 = c3 * (c4 * t24 - c4 * t26 - s4 * t28) - s3 * (s4 * t24 - s4 * t26 + c4 * t28)
    t30 = c3 * t24 + -0.3922 * (t25 - t11 * t18) - c3 * t26
    t31 = s3 * t24 - s3 * t26 + c3 * t28 + 0.3922 * (t27 + t12 * t16)
    t32 = c4 * (t30 - s3 * t28) - s4 * t31
    t33 = c5 * (-0.0997 * (t8 * t19) + t9 * t19)
    t34 = 1 / t15
    t35 = t34 * t34
    t36 = -0.5 / t15 * np.sqrt(t34)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 6), _real)
    inverse_gradient = np.empty((*_leading, 6), _real)
    inverse_root_gradient = np.empty((*_leading, 6), _real)
    manipulability[..., 0] = t15
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t15 != 0.0, t23, 0.0)
    gradient[..., 2] = np.where(t15 != 0.0, t29, 0.0)
    gradient[..., 3] = np.where(t15 != 0.0, t32, 0.0)
    gradient[..., 4] = np.where(t15 != 0.0, t33, 0.0)
    gradient[..., 5] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t15 != 0.0, -(t23 * t35), 0.0)
    inverse_gradient[..., 2] = np.where(t15 != 0.0, -(t29 * t35), 0.0)
    inverse_gradient[..., 3] = np.where(t15 != 0.0, -(t32 * t35), 0.0)
    inverse_gradient[..., 4] = np.where(t15 != 0.0, -(t33 * t35), 0.0)
    inverse_gradient[..., 5] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t15 != 0.0, t23 * t36, 0.0)
    inverse_root_gradient[..., 2] = np.where(t15 != 0.0, t29 * t36, 0.0)
    inverse_root_gradient[..., 3] = np.where(t15 != 0.0, t32 * t36, 0.0)
    inverse_root_gradient[..., 4] = np.where(t15 != 0.0, t33 * t36, 0.0)
    inverse_root_gradient[..., 5] = 0.0
    return manipulability.reshape(_leading), gradient.reshape(_leading + (6,)), inverse_gradient.reshape(_leading + (6,)), inverse_root_gradient.reshape(_leading + (6,))


def minors_pose(q):
    """maximal minors of the pose Jacobian, columns in lexicographic order: 37 operations.

    in   q[6]
    out  minors[1]
    """
    q = np.asarray(q)
    _leading = np.broadcast_shapes(q.shape[:-1])
    _real = np.result_type(q, np.float32)

    # inputs, sines and cosines
    q5 = q[..., 4]
    s5 = np.sin(q5)
    q4 = q[..., 3]
    c4 = np.cos(q4)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    s4 = np.sin(q4)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s2 = np.sin(q2)

    # terms
    t1 = 0.3922 * c4
    t2 = c4 * c3 - s3 * s4
    t3 = t1 + 0.425 * t2
    t4 = c3 * s4 + c4 * s3
    t5 = -0.3922 * s4
    t6 = t5 - 0.425 * t4
    t7 = c2 * t4 + t2 * s2
    t8 = s5 * (t3 * (t2 * c2 - s2 * t4) - t6 * t7)
    t9 = t8 + t7 * (-0.0997 * s5)

    # results
    minors = np.empty((*_leading, 1), _real)
    minors[..., 0] = t1 * (t6 * t9) - t3 * (t5 * t9)
    return minors.reshape(_leading + (1,))
