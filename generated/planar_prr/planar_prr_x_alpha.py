"""manipulability (x_alpha) of planar_prr, in NumPy.

Made from templates/kernel.py.j2; inputs f7751c7cae58eb7884348987627a3ed0ab2d2451fe63dcf71fb85cecfbd612a9.
339 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_x_alpha(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the x_alpha Jacobian: 28 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
    out  manipulability (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    sin_heading1 = np.sin(heading1)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    cos_heading1 = np.cos(heading1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = sin_heading1 * (l1 + q1)
    t2 = cos_heading1 * s2 + sin_heading1 * c2
    t3 = (t2 * c3 + (cos_heading1 * c2 - sin_heading1 * s2) * s3) * l3
    t4 = t1 + t2 * l2 + t3 - t1 - t3
    t5 = cos_heading1 * cos_heading1

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.sqrt((t4 * t4 + (t5 + t5)))
    return manipulability.reshape(leading)


def manipulability_gradient_x_alpha(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the x_alpha Jacobian, columns in lexicographic order: 46 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
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
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    sin_heading1 = np.sin(heading1)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = cos_heading1 * cos_heading1
    t2 = sin_heading1 * (l1 + q1)
    t3 = cos_heading1 * s2 + sin_heading1 * c2
    t4 = (t3 * c3 + (cos_heading1 * c2 - sin_heading1 * s2) * s3) * l3
    t5 = t2 + t3 * l2 + t4 - t2 - t4
    t6 = np.sqrt((t1 + t1 + t5 * t5))
    t7 = l2 * (t5 / t6)
    t8 = c2 * (cos_heading1 * t7) - s2 * (sin_heading1 * t7)
    t9 = 1.0 / t6

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = t6
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t6 != 0.0, t8, 0.0)
    gradient[..., 2] = 0.0
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t6 != 0.0, -(t8 * (t9 * t9)), 0.0)
    inverse_gradient[..., 2] = 0.0
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t6 != 0.0, t8 * (-0.5 / t6 * np.sqrt(t9)), 0.0)
    inverse_root_gradient[..., 2] = 0.0
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_x_alpha(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the x_alpha Jacobian, columns in lexicographic order: 55 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
    out  square (one number)
    out  gradient[3]
    out  hessian[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    sin_heading1 = np.sin(heading1)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = cos_heading1 * cos_heading1
    t2 = sin_heading1 * (l1 + q1)
    t3 = cos_heading1 * s2 + sin_heading1 * c2
    t4 = cos_heading1 * c2 - sin_heading1 * s2
    t5 = (t3 * c3 + t4 * s3) * l3
    t6 = t2 + t3 * l2 + t5 - t2 - t5
    t7 = l2 * (t6 + t6)
    t8 = cos_heading1 * t7
    t9 = sin_heading1 * t7
    t10 = c3 * t4 - t3 * s3
    t11 = l3 * (t10 + t10)
    t12 = sin_heading1 + l2 * t4 + t11 - sin_heading1 - t11
    t13 = l2 * (t12 + t12)
    t14 = c2 * (cos_heading1 * t13) - s2 * t8 - (c2 * t9 + s2 * (sin_heading1 * t13))

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = t1 + t1 + t6 * t6
    gradient[..., 0] = 0.0
    gradient[..., 1] = c2 * t8 - s2 * t9
    gradient[..., 2] = 0.0
    hessian[..., 0] = 0.0
    hessian[..., 1] = 0.0
    hessian[..., 2] = 0.0
    hessian[..., 3] = 0.0
    hessian[..., 4] = t14
    hessian[..., 5] = 0.0
    hessian[..., 6] = 0.0
    hessian[..., 7] = 0.0
    hessian[..., 8] = 0.0
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_x_alpha(q, parameters):
    """maximal minors of the x_alpha Jacobian, columns in lexicographic order: 24 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
    out  minors[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    sin_heading1 = np.sin(heading1)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = sin_heading1 * (l1 + q1)
    t2 = cos_heading1 * s2 + sin_heading1 * c2
    t3 = (t2 * c3 + (cos_heading1 * c2 - sin_heading1 * s2) * s3) * l3

    # results
    minors = np.empty((*leading, 3), real)
    minors[..., 0] = cos_heading1
    minors[..., 1] = cos_heading1
    minors[..., 2] = -(t1 + t2 * l2 + t3 - t1 - t3)
    return minors.reshape(leading + (3,))


def null_vector_x_alpha(q, parameters):
    """null vector of the x_alpha Jacobian from its signed minors, |N| = H: 25 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
    out  null_vector[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    sin_heading1 = np.sin(heading1)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    cos_heading1 = np.cos(heading1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = sin_heading1 * (l1 + q1)
    t2 = cos_heading1 * s2 + sin_heading1 * c2
    t3 = (t2 * c3 + (cos_heading1 * c2 - sin_heading1 * s2) * s3) * l3

    # results
    null_vector = np.empty((*leading, 3), real)
    null_vector[..., 0] = -(t1 + t2 * l2 + t3 - t1 - t3)
    null_vector[..., 1] = -cos_heading1
    null_vector[..., 2] = cos_heading1
    return null_vector.reshape(leading + (3,))


def null_projector_x_alpha(q, parameters):
    """projector I - J^+ J onto the null space of the x_alpha Jacobian: 161 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
    out  null_projector[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    sin_heading1 = np.sin(heading1)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = sin_heading1 * (l1 + q1)
    t2 = cos_heading1 * s2 + sin_heading1 * c2
    t3 = (t2 * c3 + (cos_heading1 * c2 - sin_heading1 * s2) * s3) * l3
    t4 = t1 + t2 * l2 + t3 - t1
    t5 = np.sqrt((cos_heading1 * cos_heading1 + t4 * t4 + t3 * t3))
    t6 = cos_heading1 / t5
    t7 = np.where(t5 != 0.0, t4 / t5, 0.0)
    t8 = np.where(t5 != 0.0, t3 / t5, 0.0)
    t9 = np.where(t5 != 0.0, np.where(t5 != 0.0, t6 * t6, 0.0), 0.0) + t7 * t7 + t8 * t8
    t10 = np.sqrt(t9)
    t11 = t6 / t10
    t12 = t7 / t10
    t13 = t8 / t10
    t14 = t12 + t13
    t15 = np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t10 != 0.0, -(t11 * t14), 0.0), 0.0), 0.0)
    t16 = 1.0 - np.where(t10 != 0.0, np.where(t10 != 0.0, t12 * t14, 0.0), 0.0)
    t17 = 1.0 - np.where(t10 != 0.0, np.where(t10 != 0.0, t13 * t14, 0.0), 0.0)
    t18 = np.sqrt((t15 * t15 + t16 * t16 + t17 * t17))
    t19 = t15 / t18
    t20 = t16 / t18
    t21 = np.where(t5 != 0.0, np.where(t10 != 0.0, -(t11 * t19), 0.0), 0.0) + np.where(t10 != 0.0, -(t12 * t20), 0.0)
    t22 = t17 / t18
    t23 = t21 + np.where(t10 != 0.0, -(t13 * t22), 0.0)
    t24 = np.where(t18 != 0.0, -t19, 0.0) - np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t18 != 0.0, t11 * t23, 0.0), 0.0), 0.0)
    t25 = np.where(t18 != 0.0, t20, 0.0) - np.where(t10 != 0.0, np.where(t18 != 0.0, -(t12 * t23), 0.0), 0.0)
    t26 = np.where(t18 != 0.0, t22, 0.0) - np.where(t10 != 0.0, np.where(t18 != 0.0, -(t13 * t23), 0.0), 0.0)
    t27 = np.sqrt((t24 * t24 + t25 * t25 + t26 * t26))
    t28 = t24 / t27
    t29 = 1.0 - np.where(t5 != 0.0, np.where(t10 != 0.0, np.where(t5 != 0.0, np.where(t10 != 0.0, t11 * t11, 0.0), 0.0), 0.0), 0.0) - np.where(t27 != 0.0, np.where(t27 != 0.0, t28 * t28, 0.0), 0.0)
    t30 = t25 / t27
    t31 = np.where(t10 != 0.0, np.where(t5 != 0.0, np.where(t10 != 0.0, -(t11 * t12), 0.0), 0.0), 0.0) + np.where(t27 != 0.0, np.where(t27 != 0.0, t28 * t30, 0.0), 0.0)
    t32 = -t31
    t33 = t26 / t27
    t34 = np.where(t10 != 0.0, np.where(t5 != 0.0, np.where(t10 != 0.0, -(t11 * t13), 0.0), 0.0), 0.0) + np.where(t27 != 0.0, np.where(t27 != 0.0, t28 * t33, 0.0), 0.0)
    t35 = -t34
    t36 = 1.0 - np.where(t10 != 0.0, np.where(t10 != 0.0, t12 * t12, 0.0), 0.0) - np.where(t27 != 0.0, np.where(t27 != 0.0, t30 * t30, 0.0), 0.0)
    t37 = np.where(t10 != 0.0, np.where(t10 != 0.0, t12 * t13, 0.0), 0.0) + np.where(t27 != 0.0, np.where(t27 != 0.0, t30 * t33, 0.0), 0.0)
    t38 = -t37
    t39 = 1.0 - np.where(t10 != 0.0, np.where(t10 != 0.0, t13 * t13, 0.0), 0.0) - np.where(t27 != 0.0, np.where(t27 != 0.0, t33 * t33, 0.0), 0.0)

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
