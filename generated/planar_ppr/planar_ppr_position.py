"""manipulability (position) of planar_ppr, in NumPy.

Made from templates/kernel.py.j2; inputs e3929abbec5b8cc1e390d2c1acf8188eb58b4f4fe88268b9b7a88b27a42db7ae.
317 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_position(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the position Jacobian: 21 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
    out  manipulability (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading2 = parameters[..., 4]
    cos_heading2 = np.cos(heading2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = (cos_heading2 * c3 - sin_heading2 * s3) * l3
    t2 = cos_heading2 * t1 + sin_heading2 * (l3 * (cos_heading2 * s3 + c3 * sin_heading2))

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.sqrt((t2 * t2 + t1 * t1 + sin_heading2 * sin_heading2))
    return manipulability.reshape(leading)


def manipulability_gradient_position(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in lexicographic order: 48 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
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
    heading2 = parameters[..., 4]
    sin_heading2 = np.sin(heading2)
    cos_heading2 = np.cos(heading2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = (cos_heading2 * c3 - sin_heading2 * s3) * l3
    t2 = cos_heading2 * t1 + sin_heading2 * (l3 * (cos_heading2 * s3 + sin_heading2 * c3))
    t3 = np.sqrt((sin_heading2 * sin_heading2 + t1 * t1 + t2 * t2))
    t4 = t2 / t3
    t5 = l3 * (sin_heading2 * t4)
    t6 = l3 * (cos_heading2 * t4 + t1 / t3)
    t7 = c3 * (cos_heading2 * t5 - sin_heading2 * t6) - s3 * (sin_heading2 * t5 + cos_heading2 * t6)
    t8 = 1.0 / t3

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = t3
    gradient[..., 0] = 0.0
    gradient[..., 1] = 0.0
    gradient[..., 2] = np.where(t3 != 0.0, t7, 0.0)
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = 0.0
    inverse_gradient[..., 2] = np.where(t3 != 0.0, -(t7 * (t8 * t8)), 0.0)
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = 0.0
    inverse_root_gradient[..., 2] = np.where(t3 != 0.0, t7 * (-0.5 / t3 * np.sqrt(t8)), 0.0)
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_position(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the position Jacobian, columns in lexicographic order: 60 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
    out  square (one number)
    out  gradient[3]
    out  hessian[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading2 = parameters[..., 4]
    sin_heading2 = np.sin(heading2)
    cos_heading2 = np.cos(heading2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = (cos_heading2 * c3 - sin_heading2 * s3) * l3
    t2 = l3 * (cos_heading2 * s3 + sin_heading2 * c3)
    t3 = cos_heading2 * t1 + sin_heading2 * t2
    t4 = t3 + t3
    t5 = l3 * (sin_heading2 * t4)
    t6 = l3 * (cos_heading2 * t4 + (t1 + t1))
    t7 = cos_heading2 * t5 - sin_heading2 * t6
    t8 = sin_heading2 * t5 + cos_heading2 * t6
    t9 = sin_heading2 * t1 - cos_heading2 * t2
    t10 = t9 + t9
    t11 = l3 * (sin_heading2 * t10)
    t12 = l3 * (cos_heading2 * t10 + (-t2 - t2))
    t13 = c3 * (cos_heading2 * t11 - sin_heading2 * t12) - s3 * t7 - (c3 * t8 + s3 * (sin_heading2 * t11 + cos_heading2 * t12))

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = sin_heading2 * sin_heading2 + t1 * t1 + t3 * t3
    gradient[..., 0] = 0.0
    gradient[..., 1] = 0.0
    gradient[..., 2] = c3 * t7 - s3 * t8
    hessian[..., 0] = 0.0
    hessian[..., 1] = 0.0
    hessian[..., 2] = 0.0
    hessian[..., 3] = 0.0
    hessian[..., 4] = 0.0
    hessian[..., 5] = 0.0
    hessian[..., 6] = 0.0
    hessian[..., 7] = 0.0
    hessian[..., 8] = t13
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_position(q, parameters):
    """maximal minors of the position Jacobian, columns in lexicographic order: 15 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
    out  minors[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading2 = parameters[..., 4]
    sin_heading2 = np.sin(heading2)
    cos_heading2 = np.cos(heading2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = (cos_heading2 * c3 - sin_heading2 * s3) * l3
    t2 = cos_heading2 * t1 + sin_heading2 * (l3 * (cos_heading2 * s3 + sin_heading2 * c3))

    # results
    minors = np.empty((*leading, 3), real)
    minors[..., 0] = sin_heading2
    minors[..., 1] = t1
    minors[..., 2] = t2
    return minors.reshape(leading + (3,))


def null_vector_position(q, parameters):
    """null vector of the position Jacobian from its signed minors, |N| = H: 16 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
    out  null_vector[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading2 = parameters[..., 4]
    cos_heading2 = np.cos(heading2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = (cos_heading2 * c3 - sin_heading2 * s3) * l3
    t2 = cos_heading2 * t1 + sin_heading2 * (l3 * (cos_heading2 * s3 + c3 * sin_heading2))

    # results
    null_vector = np.empty((*leading, 3), real)
    null_vector[..., 0] = t2
    null_vector[..., 1] = -t1
    null_vector[..., 2] = sin_heading2
    return null_vector.reshape(leading + (3,))


def null_projector_position(q, parameters):
    """projector I - J^+ J onto the null space of the position Jacobian: 157 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
    out  null_projector[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading2 = parameters[..., 4]
    cos_heading2 = np.cos(heading2)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)
    sin_heading2 = np.sin(heading2)
    l3 = parameters[..., 2]

    # terms
    t1 = (cos_heading2 * s3 + c3 * sin_heading2) * l3
    t2 = np.sqrt((1.0 + cos_heading2 * cos_heading2 + t1 * t1))
    t3 = 1.0 / t2
    t4 = cos_heading2 / t2
    t5 = np.where(t2 != 0.0, t1 / t2, 0.0)
    t6 = np.where(t2 != 0.0, np.where(t2 != 0.0, t3 * t3 + t4 * t4, 0.0), 0.0) + t5 * t5
    t7 = np.sqrt(t6)
    t8 = t3 / t7
    t9 = l3 * (cos_heading2 * c3 - s3 * sin_heading2)
    t10 = t5 / t7
    t11 = t4 / t7
    t12 = np.where(t7 != 0.0, -(t9 * t10), 0.0) + np.where(t2 != 0.0, np.where(t7 != 0.0, sin_heading2 * t11, 0.0), 0.0)
    t13 = np.where(t7 != 0.0, np.where(t2 != 0.0, t8 * t12, 0.0), 0.0)
    t14 = sin_heading2 - np.where(t2 != 0.0, np.where(t7 != 0.0, t11 * t12, 0.0), 0.0)
    t15 = t9 - np.where(t7 != 0.0, -(t10 * t12), 0.0)
    t16 = np.sqrt((t13 * t13 + t14 * t14 + t15 * t15))
    t17 = t13 / t16
    t18 = t14 / t16
    t19 = np.where(t7 != 0.0, np.where(t2 != 0.0, -(t8 * t17), 0.0), 0.0) + np.where(t2 != 0.0, np.where(t7 != 0.0, t11 * t18, 0.0), 0.0)
    t20 = t15 / t16
    t21 = t19 + np.where(t7 != 0.0, -(t10 * t20), 0.0)
    t22 = np.where(t16 != 0.0, -t17, 0.0) - np.where(t7 != 0.0, np.where(t2 != 0.0, np.where(t16 != 0.0, t8 * t21, 0.0), 0.0), 0.0)
    t23 = np.where(t16 != 0.0, t18, 0.0) - np.where(t2 != 0.0, np.where(t7 != 0.0, np.where(t16 != 0.0, t11 * t21, 0.0), 0.0), 0.0)
    t24 = np.where(t16 != 0.0, t20, 0.0) - np.where(t7 != 0.0, np.where(t16 != 0.0, -(t10 * t21), 0.0), 0.0)
    t25 = np.sqrt((t22 * t22 + t23 * t23 + t24 * t24))
    t26 = t22 / t25
    t27 = 1.0 - np.where(t7 != 0.0, np.where(t2 != 0.0, np.where(t7 != 0.0, np.where(t2 != 0.0, t8 * t8, 0.0), 0.0), 0.0), 0.0) - np.where(t25 != 0.0, np.where(t25 != 0.0, t26 * t26, 0.0), 0.0)
    t28 = t23 / t25
    t29 = np.where(t2 != 0.0, np.where(t7 != 0.0, np.where(t7 != 0.0, np.where(t2 != 0.0, t8 * t11, 0.0), 0.0), 0.0), 0.0) + np.where(t25 != 0.0, np.where(t25 != 0.0, t26 * t28, 0.0), 0.0)
    t30 = -t29
    t31 = t24 / t25
    t32 = np.where(t7 != 0.0, np.where(t7 != 0.0, np.where(t2 != 0.0, -(t8 * t10), 0.0), 0.0), 0.0) + np.where(t25 != 0.0, np.where(t25 != 0.0, t26 * t31, 0.0), 0.0)
    t33 = -t32
    t34 = 1.0 - np.where(t2 != 0.0, np.where(t7 != 0.0, np.where(t2 != 0.0, np.where(t7 != 0.0, t11 * t11, 0.0), 0.0), 0.0), 0.0) - np.where(t25 != 0.0, np.where(t25 != 0.0, t28 * t28, 0.0), 0.0)
    t35 = np.where(t7 != 0.0, np.where(t2 != 0.0, np.where(t7 != 0.0, -(t10 * t11), 0.0), 0.0), 0.0) + np.where(t25 != 0.0, np.where(t25 != 0.0, t28 * t31, 0.0), 0.0)
    t36 = -t35
    t37 = 1.0 - np.where(t7 != 0.0, np.where(t7 != 0.0, t10 * t10, 0.0), 0.0) - np.where(t25 != 0.0, np.where(t25 != 0.0, t31 * t31, 0.0), 0.0)

    # results
    null_projector = np.empty((*leading, 9), real)
    null_projector[..., 0] = t27
    null_projector[..., 1] = t30
    null_projector[..., 2] = t33
    null_projector[..., 3] = t30
    null_projector[..., 4] = t34
    null_projector[..., 5] = t36
    null_projector[..., 6] = t33
    null_projector[..., 7] = t36
    null_projector[..., 8] = t37
    return null_projector.reshape(leading + (3, 3))
