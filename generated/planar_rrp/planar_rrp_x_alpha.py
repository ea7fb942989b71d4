"""manipulability (x_alpha) of planar_rrp, in NumPy.

Made from templates/kernel.py.j2; inputs 344b4b168ed342733b5f1410e172a4a80bf5e563dd5ee354ff76601a21772d4c.
428 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_x_alpha(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the x_alpha Jacobian: 31 operations.

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
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = l1 * s1
    t2 = c1 * s2 + s1 * c2
    t3 = c1 * c2 - s1 * s2
    t4 = t1 + t2 * l2 + (t2 * cos_heading3 + t3 * sin_heading3) * (l3 + q3)
    t5 = t4 - (t4 - t1)
    t6 = cos_heading3 * t3 - t2 * sin_heading3
    t7 = t6 * t6

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.sqrt((t5 * t5 + (t7 + t7)))
    return manipulability.reshape(leading)


def manipulability_gradient_x_alpha(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the x_alpha Jacobian, columns in lexicographic order: 74 operations.

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
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = l1 * s1
    t2 = c1 * s2 + s1 * c2
    t3 = c1 * c2 - s1 * s2
    t4 = t1 + t2 * l2 + (t2 * cos_heading3 + t3 * sin_heading3) * (l3 + q3)
    t5 = t4 - (t4 - t1)
    t6 = cos_heading3 * t3 - t2 * sin_heading3
    t7 = t6 * t6
    t8 = np.sqrt((t7 + (t5 * t5 + t7)))
    t9 = t6 / t8
    t10 = t9 + t9
    t11 = cos_heading3 * t10
    t12 = sin_heading3 * t10
    t13 = c1 * (l1 * (t5 / t8) - (s2 * t11 + c2 * t12))
    t14 = t13 - s1 * (c2 * t11 - s2 * t12)
    t15 = s2 * (c1 * t11 - s1 * t12) + c2 * (s1 * t11 + c1 * t12)
    t16 = 1.0 / t8
    t17 = t16 * t16
    t18 = -0.5 / t8 * np.sqrt(t16)

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = t8
    gradient[..., 0] = np.where(t8 != 0.0, t14, 0.0)
    gradient[..., 1] = np.where(t8 != 0.0, -t15, 0.0)
    gradient[..., 2] = 0.0
    inverse_gradient[..., 0] = np.where(t8 != 0.0, -(t14 * t17), 0.0)
    inverse_gradient[..., 1] = np.where(t8 != 0.0, t15 * t17, 0.0)
    inverse_gradient[..., 2] = 0.0
    inverse_root_gradient[..., 0] = np.where(t8 != 0.0, t14 * t18, 0.0)
    inverse_root_gradient[..., 1] = np.where(t8 != 0.0, -(t15 * t18), 0.0)
    inverse_root_gradient[..., 2] = 0.0
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_x_alpha(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the x_alpha Jacobian, columns in lexicographic order: 105 operations.

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
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = l1 * s1
    t2 = c1 * s2 + s1 * c2
    t3 = c1 * c2 - s1 * s2
    t4 = t2 * cos_heading3 + t3 * sin_heading3
    t5 = l3 + q3
    t6 = t1 + t2 * l2 + t4 * t5
    t7 = t6 - (t6 - t1)
    t8 = cos_heading3 * t3 - t2 * sin_heading3
    t9 = t8 * t8
    t10 = 4.0 * t8
    t11 = cos_heading3 * t10
    t12 = s2 * t11
    t13 = sin_heading3 * t10
    t14 = c2 * t13
    t15 = l1 * (t7 + t7) - (t12 + t14)
    t16 = c2 * t11
    t17 = s2 * t13
    t18 = t16 - t17
    t19 = c1 * t11 - s1 * t13
    t20 = s1 * t11 + c1 * t13
    t21 = l1 * c1
    t22 = t21 + l2 * t3 + (t4 + t5 * t8)
    t23 = t22 - (t22 - t21)
    t24 = 4.0 * t4
    t25 = cos_heading3 * t24
    t26 = s2 * t25
    t27 = sin_heading3 * t24
    t28 = c2 * t27
    t29 = c1 * (l1 * (t23 + t23) + (t26 + t28)) - s1 * t15
    t30 = s2 * t27
    t31 = c2 * t25
    t32 = s1 * (t12 + t31 + (t14 - t30)) - c1 * (t16 - t26 - (t17 + t28))
    t33 = c2 * t19 + s2 * (s1 * t27 - c1 * t25) - (s2 * t20 + c2 * (s1 * t25 + c1 * t27))

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = t9 + (t7 * t7 + t9)
    gradient[..., 0] = c1 * t15 - s1 * t18
    gradient[..., 1] = -(s2 * t19 + c2 * t20)
    gradient[..., 2] = 0.0
    hessian[..., 0] = t29 - (c1 * t18 + s1 * (t30 - t31))
    hessian[..., 1] = t32
    hessian[..., 2] = 0.0
    hessian[..., 3] = t32
    hessian[..., 4] = -t33
    hessian[..., 5] = 0.0
    hessian[..., 6] = 0.0
    hessian[..., 7] = 0.0
    hessian[..., 8] = 0.0
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_x_alpha(q, parameters):
    """maximal minors of the x_alpha Jacobian, columns in lexicographic order: 28 operations.

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
    q1 = q[..., 0]
    s1 = np.sin(q1)
    c1 = np.cos(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = l1 * s1
    t2 = c1 * s2 + s1 * c2
    t3 = c1 * c2 - s1 * s2
    t4 = t1 + t2 * l2 + (t2 * cos_heading3 + t3 * sin_heading3) * (l3 + q3)
    t5 = -(cos_heading3 * t3 - t2 * sin_heading3)

    # results
    minors = np.empty((*leading, 3), real)
    minors[..., 0] = -(t4 - (t4 - t1))
    minors[..., 1] = t5
    minors[..., 2] = t5
    return minors.reshape(leading + (3,))


def null_vector_x_alpha(q, parameters):
    """null vector of the x_alpha Jacobian from its signed minors, |N| = H: 28 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
    out  null_vector[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = c1 * c2 - s1 * s2
    t2 = c1 * s2 + c2 * s1
    t3 = cos_heading3 * t1 - t2 * sin_heading3
    t4 = s1 * l1
    t5 = t4 + t2 * l2 + (cos_heading3 * t2 + t1 * sin_heading3) * (l3 + q3)

    # results
    null_vector = np.empty((*leading, 3), real)
    null_vector[..., 0] = -t3
    null_vector[..., 1] = t3
    null_vector[..., 2] = -(t5 - (t5 - t4))
    return null_vector.reshape(leading + (3,))


def null_projector_x_alpha(q, parameters):
    """projector I - J^+ J onto the null space of the x_alpha Jacobian: 162 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
    out  null_projector[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    sin_heading3 = np.sin(heading3)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = c1 * c2 - s1 * s2
    t2 = c1 * s2 + c2 * s1
    t3 = cos_heading3 * t1 - t2 * sin_heading3
    t4 = s1 * l1
    t5 = t4 + t2 * l2 + (cos_heading3 * t2 + t1 * sin_heading3) * (l3 + q3)
    t6 = t5 - t4
    t7 = np.sqrt((t3 * t3 + t6 * t6 + t5 * t5))
    t8 = np.where(t7 != 0.0, t5 / t7, 0.0)
    t9 = np.where(t7 != 0.0, t6 / t7, 0.0)
    t10 = t3 / t7
    t11 = t8 * t8 + t9 * t9 + np.where(t7 != 0.0, np.where(t7 != 0.0, t10 * t10, 0.0), 0.0)
    t12 = np.sqrt(t11)
    t13 = t8 / t12
    t14 = t9 / t12
    t15 = t13 + t14
    t16 = 1.0 - np.where(t12 != 0.0, np.where(t12 != 0.0, t13 * t15, 0.0), 0.0)
    t17 = 1.0 - np.where(t12 != 0.0, np.where(t12 != 0.0, t14 * t15, 0.0), 0.0)
    t18 = t10 / t12
    t19 = np.where(t7 != 0.0, np.where(t12 != 0.0, np.where(t12 != 0.0, -(t15 * t18), 0.0), 0.0), 0.0)
    t20 = np.sqrt((t16 * t16 + t17 * t17 + t19 * t19))
    t21 = t16 / t20
    t22 = t17 / t20
    t23 = t19 / t20
    t24 = np.where(t12 != 0.0, -(t13 * t21 + t14 * t22), 0.0) + np.where(t7 != 0.0, np.where(t12 != 0.0, -(t18 * t23), 0.0), 0.0)
    t25 = np.where(t20 != 0.0, t21, 0.0) - np.where(t12 != 0.0, np.where(t20 != 0.0, -(t13 * t24), 0.0), 0.0)
    t26 = np.where(t20 != 0.0, t22, 0.0) - np.where(t12 != 0.0, np.where(t20 != 0.0, -(t14 * t24), 0.0), 0.0)
    t27 = np.where(t20 != 0.0, -t23, 0.0) - np.where(t7 != 0.0, np.where(t12 != 0.0, np.where(t20 != 0.0, t18 * t24, 0.0), 0.0), 0.0)
    t28 = np.sqrt((t25 * t25 + t26 * t26 + t27 * t27))
    t29 = t25 / t28
    t30 = 1.0 - np.where(t12 != 0.0, np.where(t12 != 0.0, t13 * t13, 0.0), 0.0) - np.where(t28 != 0.0, np.where(t28 != 0.0, t29 * t29, 0.0), 0.0)
    t31 = t26 / t28
    t32 = np.where(t12 != 0.0, np.where(t12 != 0.0, t13 * t14, 0.0), 0.0) + np.where(t28 != 0.0, np.where(t28 != 0.0, t29 * t31, 0.0), 0.0)
    t33 = -t32
    t34 = t27 / t28
    t35 = np.where(t7 != 0.0, np.where(t12 != 0.0, np.where(t12 != 0.0, -(t13 * t18), 0.0), 0.0), 0.0) + np.where(t28 != 0.0, np.where(t28 != 0.0, t29 * t34, 0.0), 0.0)
    t36 = -t35
    t37 = 1.0 - np.where(t12 != 0.0, np.where(t12 != 0.0, t14 * t14, 0.0), 0.0) - np.where(t28 != 0.0, np.where(t28 != 0.0, t31 * t31, 0.0), 0.0)
    t38 = np.where(t7 != 0.0, np.where(t12 != 0.0, np.where(t12 != 0.0, -(t14 * t18), 0.0), 0.0), 0.0) + np.where(t28 != 0.0, np.where(t28 != 0.0, t31 * t34, 0.0), 0.0)
    t39 = -t38
    t40 = 1.0 - np.where(t7 != 0.0, np.where(t12 != 0.0, np.where(t7 != 0.0, np.where(t12 != 0.0, t18 * t18, 0.0), 0.0), 0.0), 0.0) - np.where(t28 != 0.0, np.where(t28 != 0.0, t34 * t34, 0.0), 0.0)

    # results
    null_projector = np.empty((*leading, 9), real)
    null_projector[..., 0] = t30
    null_projector[..., 1] = t33
    null_projector[..., 2] = t36
    null_projector[..., 3] = t33
    null_projector[..., 4] = t37
    null_projector[..., 5] = t39
    null_projector[..., 6] = t36
    null_projector[..., 7] = t39
    null_projector[..., 8] = t40
    return null_projector.reshape(leading + (3, 3))
