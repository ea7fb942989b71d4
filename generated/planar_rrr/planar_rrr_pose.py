"""manipulability (pose) of planar_rrr, in NumPy.

Made from templates/kernel.py.j2; inputs 3cd3f71b8a6bed5a3692a040540ce1d8b4578eba9eb09a91cfdaaf6b1a82c30a.
313 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_pose(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the pose Jacobian: 29 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
    out  manipulability (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    l1 = parameters[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = (c2 * c3 - s2 * s3) * l3
    t2 = l1 + c2 * l2 + t1
    t3 = l3 * (c2 * s3 + c3 * s2)
    t4 = l2 * s2 + t3
    t5 = t2 - l1
    t6 = t1 * t4
    t7 = t2 * t4 - t4 * t5 + (t3 * t5 - t6) - (t2 * t3 - t6)

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.abs(t7)
    return manipulability.reshape(leading)


def manipulability_gradient_pose(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in lexicographic order: 81 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
    out  manipulability (one number)
    out  gradient[3]
    out  inverse_gradient[3]
    out  inverse_root_gradient[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    l1 = parameters[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = (c2 * c3 - s2 * s3) * l3
    t2 = l1 + c2 * l2 + t1
    t3 = l3 * (c2 * s3 + c3 * s2)
    t4 = l2 * s2 + t3
    t5 = t2 - l1
    t6 = t1 * t4
    t7 = t2 * t4 - t4 * t5 + (t3 * t5 - t6) - (t2 * t3 - t6)
    t8 = np.abs(t7)
    t9 = t7 / t8
    t10 = t5 * t9
    t11 = t2 * t9
    t12 = t11 - t10
    t13 = l3 * (t10 - t11 + t12)
    t14 = t3 * t9
    t15 = t4 * t9
    t16 = t15 + (t14 - t15 - t14)
    t17 = l3 * t16
    t18 = c2 * (c3 * t13 + l2 * t12 - s3 * t17) - s2 * (s3 * t13 + c3 * t17 + l2 * t16)
    t19 = c3 * (c2 * t13 - s2 * t17) - s3 * (s2 * t13 + c2 * t17)
    t20 = 1.0 / t8
    t21 = t20 * t20
    t22 = -0.5 / t8 * np.sqrt(t20)

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = t8
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t8 != 0.0, t18, 0.0)
    gradient[..., 2] = np.where(t8 != 0.0, t19, 0.0)
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t8 != 0.0, -(t18 * t21), 0.0)
    inverse_gradient[..., 2] = np.where(t8 != 0.0, -(t19 * t21), 0.0)
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t8 != 0.0, t18 * t22, 0.0)
    inverse_root_gradient[..., 2] = np.where(t8 != 0.0, t19 * t22, 0.0)
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_pose(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the pose Jacobian, columns in lexicographic order: 175 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
    out  square (one number)
    out  gradient[3]
    out  hessian[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    l1 = parameters[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = c2 * l2
    t2 = (c2 * c3 - s2 * s3) * l3
    t3 = l1 + t1 + t2
    t4 = l3 * (c2 * s3 + c3 * s2)
    t5 = l2 * s2 + t4
    t6 = t3 - l1
    t7 = t2 * t5
    t8 = t3 * t5 - t5 * t6 + (t4 * t6 - t7) - (t3 * t4 - t7)
    t9 = t8 + t8
    t10 = t6 * t9
    t11 = t3 * t9
    t12 = t11 - t10
    t13 = l3 * (t10 - t11 + t12)
    t14 = c3 * t13
    t15 = t4 * t9
    t16 = t5 * t9
    t17 = t16 + (t15 - t16 - t15)
    t18 = l3 * t17
    t19 = s3 * t18
    t20 = t14 + l2 * t12 - t19
    t21 = s3 * t13
    t22 = c3 * t18
    t23 = t21 + t22 + l2 * t17
    t24 = c2 * t13 - s2 * t18
    t25 = s2 * t13 + c2 * t18
    t26 = t1 + t2
    t27 = t5 * t5
    t28 = t2 * t6
    t29 = t4 * t5
    t30 = t28 - t29
    t31 = t2 * t26 - t29
    t32 = t3 * t26 - t27 - (t6 * t26 - t27) + (t30 - t31)
    t33 = t2 * t3
    t34 = t33 - t29
    t35 = t32 - (t34 - t31)
    t36 = t35 + t35
    t37 = t6 * t36 - t16
    t38 = t3 * t36 - t16
    t39 = t38 - t37
    t40 = l3 * (t37 - t38 + t39)
    t41 = t2 * t9
    t42 = t41 + t4 * t36
    t43 = t9 * t26 + t5 * t36
    t44 = t43 + (t42 - t43 - t42)
    t45 = l3 * t44
    t46 = c2 * (c3 * t40 + l2 * t39 - s3 * t45) - s2 * t20
    t47 = c2 * t23 + s2 * (s3 * t40 + c3 * t45 + l2 * t44)
    t48 = t4 * t4
    t49 = t2 * t2 - t29
    t50 = t34 - t30 + (t28 - t48 - t49) - (t33 - t48 - t49)
    t51 = t50 + t50
    t52 = t6 * t51 - t15
    t53 = t3 * t51 - t15
    t54 = t53 - t52
    t55 = l3 * (t52 - t53 + t54)
    t56 = t41 + t4 * t51
    t57 = t41 + t5 * t51
    t58 = t57 + (t56 - t57 - t56)
    t59 = l3 * t58
    t60 = c3 * t55 - t21 + l2 * t54 - (t22 + s3 * t59)
    t61 = t14 + s3 * t55 + (c3 * t59 - t19) + l2 * t58
    t62 = c2 * t60 - s2 * t61
    t63 = c3 * (c2 * t55 - s2 * t59) - s3 * t24 - (c3 * t25 + s3 * (s2 * t55 + c2 * t59))

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = t8 * t8
    gradient[..., 0] = 0.0
    gradient[..., 1] = c2 * t20 - s2 * t23
    gradient[..., 2] = c3 * t24 - s3 * t25
    hessian[..., 0] = 0.0
    hessian[..., 1] = 0.0
    hessian[..., 2] = 0.0
    hessian[..., 3] = 0.0
    hessian[..., 4] = t46 - t47
    hessian[..., 5] = t62
    hessian[..., 6] = 0.0
    hessian[..., 7] = t62
    hessian[..., 8] = t63
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_pose(q, parameters):
    """maximal minors of the pose Jacobian, columns in lexicographic order: 28 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
    out  minors[1]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    l1 = parameters[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = (c2 * c3 - s2 * s3) * l3
    t2 = l1 + c2 * l2 + t1
    t3 = l3 * (c2 * s3 + c3 * s2)
    t4 = l2 * s2 + t3
    t5 = t2 - l1
    t6 = t1 * t4
    t7 = t2 * t4 - t4 * t5 + (t3 * t5 - t6) - (t2 * t3 - t6)

    # results
    minors = np.empty((*leading, 1), real)
    minors[..., 0] = t7
    return minors.reshape(leading + (1,))
