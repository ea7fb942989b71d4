"""manipulability (position) of planar_rrp, in NumPy.

Made from templates/kernel.py.j2; inputs 344b4b168ed342733b5f1410e172a4a80bf5e563dd5ee354ff76601a21772d4c.
521 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_position(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the position Jacobian: 33 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
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
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = c2 * cos_heading3 - s2 * sin_heading3
    t2 = l3 + q3
    t3 = l1 + c2 * l2 + t1 * t2
    t4 = c2 * sin_heading3 + cos_heading3 * s2
    t5 = l2 * s2 + t2 * t4
    t6 = t3 - l1
    t7 = t3 * t5 - t5 * t6
    t8 = t4 * t5
    t9 = t1 * t3 + t8
    t10 = t8 + t1 * t6

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.sqrt((t7 * t7 + t9 * t9 + t10 * t10))
    return manipulability.reshape(leading)


def manipulability_gradient_position(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in lexicographic order: 92 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
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
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = c2 * cos_heading3 - s2 * sin_heading3
    t2 = l3 + q3
    t3 = l1 + c2 * l2 + t1 * t2
    t4 = c2 * sin_heading3 + cos_heading3 * s2
    t5 = l2 * s2 + t2 * t4
    t6 = t3 - l1
    t7 = t3 * t5 - t5 * t6
    t8 = t4 * t5
    t9 = t1 * t3 + t8
    t10 = t8 + t1 * t6
    t11 = np.sqrt((t7 * t7 + t9 * t9 + t10 * t10))
    t12 = t10 / t11
    t13 = t9 / t11
    t14 = t7 / t11
    t15 = t4 * t12 + t4 * t13 - t6 * t14 + t3 * t14
    t16 = t5 * t12 + t5 * t13 + t2 * t15
    t17 = t5 * t14
    t18 = t17 + (t1 * t13 + (t1 * t12 - t17))
    t19 = t6 * t12 + t3 * t13 + t2 * t18
    t20 = c2 * (cos_heading3 * t16 + l2 * t15 - sin_heading3 * t19) - s2 * (sin_heading3 * t16 + cos_heading3 * t19 + l2 * t18)
    t21 = t4 * t15 + t1 * t18
    t22 = 1.0 / t11
    t23 = t22 * t22
    t24 = -0.5 / t11 * np.sqrt(t22)

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = t11
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t11 != 0.0, t20, 0.0)
    gradient[..., 2] = np.where(t11 != 0.0, t21, 0.0)
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t11 != 0.0, -(t20 * t23), 0.0)
    inverse_gradient[..., 2] = np.where(t11 != 0.0, -(t21 * t23), 0.0)
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t11 != 0.0, t20 * t24, 0.0)
    inverse_root_gradient[..., 2] = np.where(t11 != 0.0, t21 * t24, 0.0)
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_position(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the position Jacobian, columns in lexicographic order: 200 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
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
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = c2 * l2
    t2 = c2 * cos_heading3 - s2 * sin_heading3
    t3 = l3 + q3
    t4 = t2 * t3
    t5 = l1 + t1 + t4
    t6 = c2 * sin_heading3 + cos_heading3 * s2
    t7 = l2 * s2 + t3 * t6
    t8 = t5 - l1
    t9 = t5 * t7 - t7 * t8
    t10 = t6 * t7
    t11 = t2 * t5 + t10
    t12 = t10 + t2 * t8
    t13 = t12 + t12
    t14 = t7 * t13
    t15 = t11 + t11
    t16 = t7 * t15
    t17 = t6 * t13
    t18 = t6 * t15
    t19 = t9 + t9
    t20 = t17 + t18 - t8 * t19 + t5 * t19
    t21 = t14 + t16 + t3 * t20
    t22 = t2 * t15
    t23 = t2 * t13
    t24 = t7 * t19
    t25 = t24 + (t22 + (t23 - t24))
    t26 = t8 * t13 + t5 * t15 + t3 * t25
    t27 = cos_heading3 * t21 + l2 * t20 - sin_heading3 * t26
    t28 = sin_heading3 * t21 + cos_heading3 * t26 + l2 * t25
    t29 = t1 + t4
    t30 = t2 * t7
    t31 = t30 + t6 * t29
    t32 = t30 + t6 * t8
    t33 = t31 - t32
    t34 = t33 + t33
    t35 = t30 + t5 * t6
    t36 = t31 - t35
    t37 = t36 + t36
    t38 = t13 * t29 + t7 * t34 + (t15 * t29 + t7 * t37)
    t39 = t7 * t7
    t40 = t5 * t29 - t39 - (t8 * t29 - t39)
    t41 = t40 + t40
    t42 = t23 + t6 * t34 + (t22 + t6 * t37) - (t8 * t41 - t24)
    t43 = t42 + (t5 * t41 - t24)
    t44 = t38 + t3 * t43
    t45 = t19 * t29 + t7 * t41
    t46 = t45 + (t2 * t37 - t18 + (t2 * t34 - t17 - t45))
    t47 = t8 * t34 - t14 + (t5 * t37 - t16) + t3 * t46
    t48 = c2 * (cos_heading3 * t44 + l2 * t43 - sin_heading3 * t47) - s2 * t27
    t49 = c2 * t28 + s2 * (sin_heading3 * t44 + cos_heading3 * t47 + l2 * t46)
    t50 = t2 * t2 + t6 * t6
    t51 = t50 + t50
    t52 = t7 * t51
    t53 = t6 * t51
    t54 = t2 * t19
    t55 = t35 - t32
    t56 = t55 + t55
    t57 = t53 + t53 - (t54 + t8 * t56) + (t54 + t5 * t56)
    t58 = t17 + t52 + (t18 + t52) + (t20 + t3 * t57)
    t59 = t2 * t51
    t60 = t6 * t19 + t7 * t56
    t61 = t60 + (t59 + (t59 - t60))
    t62 = t23 + t8 * t51 + (t22 + t5 * t51) + (t25 + t3 * t61)
    t63 = c2 * (cos_heading3 * t58 + l2 * t57 - sin_heading3 * t62) - s2 * (sin_heading3 * t58 + cos_heading3 * t62 + l2 * t61)

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = t9 * t9 + t11 * t11 + t12 * t12
    gradient[..., 0] = 0.0
    gradient[..., 1] = c2 * t27 - s2 * t28
    gradient[..., 2] = t6 * t20 + t2 * t25
    hessian[..., 0] = 0.0
    hessian[..., 1] = 0.0
    hessian[..., 2] = 0.0
    hessian[..., 3] = 0.0
    hessian[..., 4] = t48 - t49
    hessian[..., 5] = t63
    hessian[..., 6] = 0.0
    hessian[..., 7] = t63
    hessian[..., 8] = t6 * t57 + t2 * t61
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_position(q, parameters):
    """maximal minors of the position Jacobian, columns in lexicographic order: 29 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
    out  minors[3]
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
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = c2 * cos_heading3 - s2 * sin_heading3
    t2 = l3 + q3
    t3 = l1 + c2 * l2 + t1 * t2
    t4 = c2 * sin_heading3 + cos_heading3 * s2
    t5 = l2 * s2 + t2 * t4
    t6 = t3 - l1
    t7 = t4 * t5

    # results
    minors = np.empty((*leading, 3), real)
    minors[..., 0] = t3 * t5 - t5 * t6
    minors[..., 1] = -(t1 * t3 + t7)
    minors[..., 2] = -(t7 + t1 * t6)
    return minors.reshape(leading + (3,))


def null_vector_position(q, parameters):
    """null vector of the position Jacobian from its signed minors, |N| = H: 28 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
    out  null_vector[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = c2 * cos_heading3 - s2 * sin_heading3
    t2 = l3 + q3
    t3 = l1 + c2 * l2 + t1 * t2
    t4 = t3 - l1
    t5 = c2 * sin_heading3 + cos_heading3 * s2
    t6 = s2 * l2 + t2 * t5
    t7 = t5 * t6

    # results
    null_vector = np.empty((*leading, 3), real)
    null_vector[..., 0] = -(t1 * t4 + t7)
    null_vector[..., 1] = t7 + t1 * t3
    null_vector[..., 2] = t3 * t6 - t4 * t6
    return null_vector.reshape(leading + (3,))


def null_projector_position(q, parameters):
    """projector I - J^+ J onto the null space of the position Jacobian: 139 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
    out  null_projector[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    l1 = parameters[..., 0]

    # terms
    t1 = c2 * cos_heading3 - s2 * sin_heading3
    t2 = c2 * sin_heading3 + cos_heading3 * s2
    t3 = l3 + q3
    t4 = s2 * l2 + t2 * t3
    t5 = t4 * t4
    t6 = np.sqrt((t1 * t1 + (t5 + t5)))
    t7 = t1 / t6
    t8 = np.where(t6 != 0.0, t4 / t6, 0.0)
    t9 = t8 * t8
    t10 = np.sqrt((np.where(t6 != 0.0, np.where(t6 != 0.0, t7 * t7, 0.0), 0.0) + (t9 + t9)))
    t11 = t8 / t10
    t12 = np.where(t10 != 0.0, np.where(t10 != 0.0, t11 * t11, 0.0), 0.0)
    t13 = 1.0 - t12
    t14 = l1 + c2 * l2 + t1 * t3
    t15 = t7 / t10
    t16 = t14 - l1
    t17 = np.where(t6 != 0.0, np.where(t10 != 0.0, t2 * t15, 0.0), 0.0) + np.where(t10 != 0.0, -(t11 * t16), 0.0)
    t18 = t17 + np.where(t10 != 0.0, -(t11 * t14), 0.0)
    t19 = np.where(t10 != 0.0, -(t11 * t18), 0.0)
    t20 = t14 - t19
    t21 = t16 - t19
    t22 = t2 - np.where(t6 != 0.0, np.where(t10 != 0.0, t15 * t18, 0.0), 0.0)
    t23 = np.sqrt((t20 * t20 + t21 * t21 + t22 * t22))
    t24 = t20 / t23
    t25 = t21 / t23
    t26 = t22 / t23
    t27 = np.where(t10 != 0.0, -(t11 * t24 + t11 * t25), 0.0) + np.where(t6 != 0.0, np.where(t10 != 0.0, t15 * t26, 0.0), 0.0)
    t28 = np.where(t10 != 0.0, np.where(t23 != 0.0, -(t11 * t27), 0.0), 0.0)
    t29 = np.where(t23 != 0.0, t24, 0.0) - t28
    t30 = np.where(t23 != 0.0, t25, 0.0) - t28
    t31 = np.where(t23 != 0.0, t26, 0.0) - np.where(t6 != 0.0, np.where(t10 != 0.0, np.where(t23 != 0.0, t15 * t27, 0.0), 0.0), 0.0)
    t32 = np.sqrt((t29 * t29 + t30 * t30 + t31 * t31))
    t33 = t29 / t32
    t34 = t30 / t32
    t35 = -(t12 + np.where(t32 != 0.0, np.where(t32 != 0.0, t33 * t34, 0.0), 0.0))
    t36 = np.where(t6 != 0.0, np.where(t10 != 0.0, np.where(t10 != 0.0, -(t11 * t15), 0.0), 0.0), 0.0)
    t37 = t31 / t32
    t38 = -(t36 + np.where(t32 != 0.0, np.where(t32 != 0.0, t33 * t37, 0.0), 0.0))
    t39 = -(t36 + np.where(t32 != 0.0, np.where(t32 != 0.0, t34 * t37, 0.0), 0.0))
    t40 = 1.0 - np.where(t6 != 0.0, np.where(t10 != 0.0, np.where(t6 != 0.0, np.where(t10 != 0.0, t15 * t15, 0.0), 0.0), 0.0), 0.0) - np.where(t32 != 0.0, np.where(t32 != 0.0, t37 * t37, 0.0), 0.0)

    # results
    null_projector = np.empty((*leading, 9), real)
    null_projector[..., 0] = t13 - np.where(t32 != 0.0, np.where(t32 != 0.0, t33 * t33, 0.0), 0.0)
    null_projector[..., 1] = t35
    null_projector[..., 2] = t38
    null_projector[..., 3] = t35
    null_projector[..., 4] = t13 - np.where(t32 != 0.0, np.where(t32 != 0.0, t34 * t34, 0.0), 0.0)
    null_projector[..., 5] = t39
    null_projector[..., 6] = t38
    null_projector[..., 7] = t39
    null_projector[..., 8] = t40
    return null_projector.reshape(leading + (3, 3))
