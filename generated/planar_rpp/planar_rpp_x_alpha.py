"""manipulability (x_alpha) of planar_rpp, in NumPy.

Made from templates/kernel.py.j2; inputs 2c4b7f604c2520d4429cf7db48c2bb6981ca2a4fd070aa2a796b28fdad172f86.
311 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_x_alpha(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the x_alpha Jacobian: 19 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
    out  manipulability (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    s1 = np.sin(q1)
    sin_heading2 = np.sin(heading2)
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = t1 * cos_heading3 - (c1 * sin_heading2 + cos_heading2 * s1) * sin_heading3

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.sqrt((t1 * t1 + t2 * t2))
    return manipulability.reshape(leading)


def manipulability_gradient_x_alpha(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the x_alpha Jacobian, columns in lexicographic order: 45 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
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
    q1 = q[..., 0]
    c1 = np.cos(q1)
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    s1 = np.sin(q1)
    sin_heading2 = np.sin(heading2)
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = t1 * cos_heading3 - (c1 * sin_heading2 + cos_heading2 * s1) * sin_heading3
    t3 = np.sqrt((t1 * t1 + t2 * t2))
    t4 = t2 / t3
    t5 = sin_heading3 * t4
    t6 = cos_heading3 * t4 + t1 / t3
    t7 = c1 * (cos_heading2 * t5 + sin_heading2 * t6) + s1 * (cos_heading2 * t6 - sin_heading2 * t5)
    t8 = 1.0 / t3

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = t3
    gradient[..., 0] = np.where(t3 != 0.0, -t7, 0.0)
    gradient[..., 1] = 0.0
    gradient[..., 2] = 0.0
    inverse_gradient[..., 0] = np.where(t3 != 0.0, t7 * (t8 * t8), 0.0)
    inverse_gradient[..., 1] = 0.0
    inverse_gradient[..., 2] = 0.0
    inverse_root_gradient[..., 0] = np.where(t3 != 0.0, -(t7 * (-0.5 / t3 * np.sqrt(t8))), 0.0)
    inverse_root_gradient[..., 1] = 0.0
    inverse_root_gradient[..., 2] = 0.0
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_x_alpha(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the x_alpha Jacobian, columns in lexicographic order: 57 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
    out  square (one number)
    out  gradient[3]
    out  hessian[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    s1 = np.sin(q1)
    sin_heading2 = np.sin(heading2)
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = c1 * sin_heading2 + cos_heading2 * s1
    t3 = t1 * cos_heading3 - t2 * sin_heading3
    t4 = t3 + t3
    t5 = sin_heading3 * t4
    t6 = cos_heading3 * t4 + (t1 + t1)
    t7 = cos_heading2 * t5 + sin_heading2 * t6
    t8 = cos_heading2 * t6 - sin_heading2 * t5
    t9 = cos_heading3 * t2 + t1 * sin_heading3
    t10 = -t9 - t9
    t11 = sin_heading3 * t10
    t12 = cos_heading3 * t10 + (-t2 - t2)
    t13 = c1 * (cos_heading2 * t11 + sin_heading2 * t12) - s1 * t7 + (c1 * t8 + s1 * (cos_heading2 * t12 - sin_heading2 * t11))

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = t1 * t1 + t3 * t3
    gradient[..., 0] = -(c1 * t7 + s1 * t8)
    gradient[..., 1] = 0.0
    gradient[..., 2] = 0.0
    hessian[..., 0] = -t13
    hessian[..., 1] = 0.0
    hessian[..., 2] = 0.0
    hessian[..., 3] = 0.0
    hessian[..., 4] = 0.0
    hessian[..., 5] = 0.0
    hessian[..., 6] = 0.0
    hessian[..., 7] = 0.0
    hessian[..., 8] = 0.0
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_x_alpha(q, parameters):
    """maximal minors of the x_alpha Jacobian, columns in lexicographic order: 17 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
    out  minors[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    s1 = np.sin(q1)
    sin_heading2 = np.sin(heading2)
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = -(t1 * cos_heading3 - (c1 * sin_heading2 + cos_heading2 * s1) * sin_heading3)

    # results
    minors = np.empty((*leading, 3), real)
    minors[..., 0] = -t1
    minors[..., 1] = t2
    minors[..., 2] = 0.0
    return minors.reshape(leading + (3,))


def null_vector_x_alpha(q, parameters):
    """null vector of the x_alpha Jacobian from its signed minors, |N| = H: 16 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
    out  null_vector[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    q1 = q[..., 0]
    c1 = np.cos(q1)
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    s1 = np.sin(q1)
    sin_heading2 = np.sin(heading2)
    sin_heading3 = np.sin(heading3)

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2

    # results
    null_vector = np.empty((*leading, 3), real)
    null_vector[..., 0] = 0.0
    null_vector[..., 1] = cos_heading3 * t1 - (c1 * sin_heading2 + cos_heading2 * s1) * sin_heading3
    null_vector[..., 2] = -t1
    return null_vector.reshape(leading + (3,))


def null_projector_x_alpha(q, parameters):
    """projector I - J^+ J onto the null space of the x_alpha Jacobian: 157 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
    out  null_projector[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q1 = q[..., 0]
    c1 = np.cos(q1)
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    s1 = np.sin(q1)
    sin_heading2 = np.sin(heading2)
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = c1 * sin_heading2 + cos_heading2 * s1
    t3 = t1 * cos_heading3 - t2 * sin_heading3
    t4 = s1 * l1 + t2 * (l2 + q2) + (cos_heading3 * t2 + t1 * sin_heading3) * (l3 + q3)
    t5 = np.sqrt((t1 * t1 + t3 * t3 + t4 * t4))
    t6 = np.where(t5 != 0.0, t4 / t5, 0.0)
    t7 = t1 / t5
    t8 = t3 / t5
    t9 = t6 * t6 + np.where(t5 != 0.0, np.where(t5 != 0.0, t7 * t7, 0.0), 0.0) + np.where(t5 != 0.0, np.where(t5 != 0.0, t8 * t8, 0.0), 0.0)
    t10 = np.sqrt(t9)
    t11 = t6 / t10
    t12 = 1.0 - np.where(t10 != 0.0, np.where(t10 != 0.0, t11 * t11, 0.0), 0.0)
    t13 = t7 / t10
    t14 = np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t10 != 0.0, -(t11 * t13), 0.0), 0.0), 0.0)
    t15 = t8 / t10
    t16 = np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t10 != 0.0, -(t11 * t15), 0.0), 0.0), 0.0)
    t17 = np.sqrt((t12 * t12 + t14 * t14 + t16 * t16))
    t18 = t12 / t17
    t19 = t14 / t17
    t20 = np.where(t10 != 0.0, -(t11 * t18), 0.0) + np.where(t5 != 0.0, np.where(t10 != 0.0, -(t13 * t19), 0.0), 0.0)
    t21 = t16 / t17
    t22 = t20 + np.where(t5 != 0.0, np.where(t10 != 0.0, -(t15 * t21), 0.0), 0.0)
    t23 = np.where(t17 != 0.0, t18, 0.0) - np.where(t10 != 0.0, np.where(t17 != 0.0, -(t11 * t22), 0.0), 0.0)
    t24 = np.where(t17 != 0.0, -t19, 0.0) - np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t17 != 0.0, t13 * t22, 0.0), 0.0), 0.0)
    t25 = np.where(t17 != 0.0, -t21, 0.0) - np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t17 != 0.0, t15 * t22, 0.0), 0.0), 0.0)
    t26 = np.sqrt((t23 * t23 + t24 * t24 + t25 * t25))
    t27 = t23 / t26
    t28 = t24 / t26
    t29 = -(t14 + np.where(t26 != 0.0, np.where(t26 != 0.0, t27 * t28, 0.0), 0.0))
    t30 = t25 / t26
    t31 = -(t16 + np.where(t26 != 0.0, np.where(t26 != 0.0, t27 * t30, 0.0), 0.0))
    t32 = 1.0 - np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t5 != 0.0, np.where(t10 != 0.0, t13 * t13, 0.0), 0.0), 0.0), 0.0) - np.where(t26 != 0.0, np.where(t26 != 0.0, t28 * t28, 0.0), 0.0)
    t33 = np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t5 != 0.0, np.where(t10 != 0.0, t13 * t15, 0.0), 0.0), 0.0), 0.0) + np.where(t26 != 0.0, np.where(t26 != 0.0, t28 * t30, 0.0), 0.0)
    t34 = -t33
    t35 = 1.0 - np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t5 != 0.0, np.where(t10 != 0.0, t15 * t15, 0.0), 0.0), 0.0), 0.0) - np.where(t26 != 0.0, np.where(t26 != 0.0, t30 * t30, 0.0), 0.0)

    # results
    null_projector = np.empty((*leading, 9), real)
    null_projector[..., 0] = t12 - np.where(t26 != 0.0, np.where(t26 != 0.0, t27 * t27, 0.0), 0.0)
    null_projector[..., 1] = t29
    null_projector[..., 2] = t31
    null_projector[..., 3] = t29
    null_projector[..., 4] = t32
    null_projector[..., 5] = t34
    null_projector[..., 6] = t31
    null_projector[..., 7] = t34
    null_projector[..., 8] = t35
    return null_projector.reshape(leading + (3, 3))
