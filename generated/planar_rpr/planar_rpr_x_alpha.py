"""manipulability (x_alpha) of planar_rpr, in NumPy.

Made from templates/kernel.py.j2; inputs 4fcb78b149cbfbd383ed1fce592dc846fb23a4be4aaeb9a8d013ae51b9937058.
327 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_x_alpha(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the x_alpha Jacobian: 19 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
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
    heading2 = parameters[..., 3]
    sin_heading2 = np.sin(heading2)
    cos_heading2 = np.cos(heading2)
    l2 = parameters[..., 1]
    q2 = q[..., 1]

    # terms
    t1 = l1 * s1 + (c1 * sin_heading2 + s1 * cos_heading2) * (l2 + q2)
    t2 = c1 * cos_heading2 - s1 * sin_heading2
    t3 = t2 * t2

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.sqrt((t1 * t1 + (t3 + t3)))
    return manipulability.reshape(leading)


def manipulability_gradient_x_alpha(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the x_alpha Jacobian, columns in lexicographic order: 52 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
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
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = t1 * t1
    t3 = c1 * sin_heading2 + cos_heading2 * s1
    t4 = l2 + q2
    t5 = s1 * l1 + t3 * t4
    t6 = np.sqrt((t2 + (t2 + t5 * t5)))
    t7 = t5 / t6
    t8 = t4 * t7
    t9 = t1 / t6
    t10 = t9 + t9
    t11 = c1 * (cos_heading2 * t8 + l1 * t7 - sin_heading2 * t10) - s1 * (sin_heading2 * t8 + cos_heading2 * t10)
    t12 = t3 * t7
    t13 = 1.0 / t6
    t14 = t13 * t13
    t15 = -0.5 / t6 * np.sqrt(t13)

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = t6
    gradient[..., 0] = np.where(t6 != 0.0, t11, 0.0)
    gradient[..., 1] = np.where(t6 != 0.0, t12, 0.0)
    gradient[..., 2] = 0.0
    inverse_gradient[..., 0] = np.where(t6 != 0.0, -(t11 * t14), 0.0)
    inverse_gradient[..., 1] = np.where(t6 != 0.0, -(t12 * t14), 0.0)
    inverse_gradient[..., 2] = 0.0
    inverse_root_gradient[..., 0] = np.where(t6 != 0.0, t11 * t15, 0.0)
    inverse_root_gradient[..., 1] = np.where(t6 != 0.0, t12 * t15, 0.0)
    inverse_root_gradient[..., 2] = 0.0
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_x_alpha(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the x_alpha Jacobian, columns in lexicographic order: 65 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
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
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = t1 * t1
    t3 = c1 * sin_heading2 + cos_heading2 * s1
    t4 = l2 + q2
    t5 = s1 * l1 + t3 * t4
    t6 = t5 + t5
    t7 = t4 * t6
    t8 = 4.0 * t1
    t9 = cos_heading2 * t7 + l1 * t6 - sin_heading2 * t8
    t10 = sin_heading2 * t7 + cos_heading2 * t8
    t11 = c1 * l1 + t1 * t4
    t12 = t11 + t11
    t13 = t4 * t12
    t14 = 4.0 * t3
    t15 = c1 * (cos_heading2 * t13 + l1 * t12 + sin_heading2 * t14) - s1 * t9
    t16 = t15 - (c1 * t10 + s1 * (sin_heading2 * t13 - cos_heading2 * t14))
    t17 = t3 + t3
    t18 = t6 + t4 * t17
    t19 = c1 * (cos_heading2 * t18 + l1 * t17) - s1 * (sin_heading2 * t18)

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = t2 + (t2 + t5 * t5)
    gradient[..., 0] = c1 * t9 - s1 * t10
    gradient[..., 1] = t3 * t6
    gradient[..., 2] = 0.0
    hessian[..., 0] = t16
    hessian[..., 1] = t19
    hessian[..., 2] = 0.0
    hessian[..., 3] = t19
    hessian[..., 4] = t3 * t17
    hessian[..., 5] = 0.0
    hessian[..., 6] = 0.0
    hessian[..., 7] = 0.0
    hessian[..., 8] = 0.0
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_x_alpha(q, parameters):
    """maximal minors of the x_alpha Jacobian, columns in lexicographic order: 16 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
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
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = s1 * l1 + (c1 * sin_heading2 + cos_heading2 * s1) * (l2 + q2)

    # results
    minors = np.empty((*leading, 3), real)
    minors[..., 0] = -t1
    minors[..., 1] = -t2
    minors[..., 2] = t1
    return minors.reshape(leading + (3,))


def null_vector_x_alpha(q, parameters):
    """null vector of the x_alpha Jacobian from its signed minors, |N| = H: 15 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
    out  null_vector[3]
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
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = s1 * l1 + (c1 * sin_heading2 + cos_heading2 * s1) * (l2 + q2)

    # results
    null_vector = np.empty((*leading, 3), real)
    null_vector[..., 0] = t1
    null_vector[..., 1] = t2
    null_vector[..., 2] = -t1
    return null_vector.reshape(leading + (3,))


def null_projector_x_alpha(q, parameters):
    """projector I - J^+ J onto the null space of the x_alpha Jacobian: 160 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = c1 * sin_heading2 + cos_heading2 * s1
    t3 = (c3 * t2 + t1 * s3) * l3
    t4 = t3 + (s1 * l1 + t2 * (l2 + q2))
    t5 = np.sqrt((t1 * t1 + t3 * t3 + t4 * t4))
    t6 = np.where(t5 != 0.0, t4 / t5, 0.0)
    t7 = t1 / t5
    t8 = np.where(t5 != 0.0, t3 / t5, 0.0)
    t9 = t6 * t6 + np.where(t5 != 0.0, np.where(t5 != 0.0, t7 * t7, 0.0), 0.0) + t8 * t8
    t10 = np.sqrt(t9)
    t11 = t6 / t10
    t12 = t8 / t10
    t13 = t11 + t12
    t14 = 1.0 - np.where(t10 != 0.0, np.where(t10 != 0.0, t11 * t13, 0.0), 0.0)
    t15 = t7 / t10
    t16 = np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t10 != 0.0, -(t13 * t15), 0.0), 0.0), 0.0)
    t17 = 1.0 - np.where(t10 != 0.0, np.where(t10 != 0.0, t12 * t13, 0.0), 0.0)
    t18 = np.sqrt((t14 * t14 + t16 * t16 + t17 * t17))
    t19 = t14 / t18
    t20 = t16 / t18
    t21 = np.where(t10 != 0.0, -(t11 * t19), 0.0) + np.where(t5 != 0.0, np.where(t10 != 0.0, -(t15 * t20), 0.0), 0.0)
    t22 = t17 / t18
    t23 = t21 + np.where(t10 != 0.0, -(t12 * t22), 0.0)
    t24 = np.where(t18 != 0.0, t19, 0.0) - np.where(t10 != 0.0, np.where(t18 != 0.0, -(t11 * t23), 0.0), 0.0)
    t25 = np.where(t18 != 0.0, -t20, 0.0) - np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t18 != 0.0, t15 * t23, 0.0), 0.0), 0.0)
    t26 = np.where(t18 != 0.0, t22, 0.0) - np.where(t10 != 0.0, np.where(t18 != 0.0, -(t12 * t23), 0.0), 0.0)
    t27 = np.sqrt((t24 * t24 + t25 * t25 + t26 * t26))
    t28 = t24 / t27
    t29 = 1.0 - np.where(t10 != 0.0, np.where(t10 != 0.0, t11 * t11, 0.0), 0.0) - np.where(t27 != 0.0, np.where(t27 != 0.0, t28 * t28, 0.0), 0.0)
    t30 = t25 / t27
    t31 = np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t10 != 0.0, -(t11 * t15), 0.0), 0.0), 0.0) + np.where(t27 != 0.0, np.where(t27 != 0.0, t28 * t30, 0.0), 0.0)
    t32 = -t31
    t33 = t26 / t27
    t34 = np.where(t10 != 0.0, np.where(t10 != 0.0, t11 * t12, 0.0), 0.0) + np.where(t27 != 0.0, np.where(t27 != 0.0, t28 * t33, 0.0), 0.0)
    t35 = -t34
    t36 = 1.0 - np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t5 != 0.0, np.where(t10 != 0.0, t15 * t15, 0.0), 0.0), 0.0), 0.0) - np.where(t27 != 0.0, np.where(t27 != 0.0, t30 * t30, 0.0), 0.0)
    t37 = np.where(t10 != 0.0, np.where(t5 != 0.0, np.where(t10 != 0.0, -(t12 * t15), 0.0), 0.0), 0.0) + np.where(t27 != 0.0, np.where(t27 != 0.0, t30 * t33, 0.0), 0.0)
    t38 = -t37
    t39 = 1.0 - np.where(t10 != 0.0, np.where(t10 != 0.0, t12 * t12, 0.0), 0.0) - np.where(t27 != 0.0, np.where(t27 != 0.0, t33 * t33, 0.0), 0.0)

    # results
    null_projector = np.empty((*leading, 9), real)
    null_projector[..., 0] = t29
    null_projector[..., 1] = t32
    null_projector[..., 2] = t35
    null_projector[..., 3] = t32
    null_projector[..., 4] = t36
    null_projector[..., 5] = t38
    null_projector[..., 6] = t35
    null_projector[..., 7] = t38
    null_projector[..., 8] = t39
    return null_projector.reshape(leading + (3, 3))
