"""manipulability (position) of planar_rpp, in NumPy.

Made from templates/kernel.py.j2; inputs 2c4b7f604c2520d4429cf7db48c2bb6981ca2a4fd070aa2a796b28fdad172f86.
402 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_position(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the position Jacobian: 34 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
    out  manipulability (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading2 = np.sin(heading2)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = l2 + q2
    t2 = cos_heading2 * cos_heading3 - sin_heading2 * sin_heading3
    t3 = l3 + q3
    t4 = l1 + cos_heading2 * t1 + t2 * t3
    t5 = cos_heading2 * sin_heading3 + cos_heading3 * sin_heading2
    t6 = t1 * sin_heading2 + t3 * t5
    t7 = cos_heading2 * t4 + sin_heading2 * t6
    t8 = t2 * t4 + t5 * t6
    t9 = cos_heading2 * t5 - sin_heading2 * t2

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.sqrt((t7 * t7 + t8 * t8 + t9 * t9))
    return manipulability.reshape(leading)


def manipulability_gradient_position(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in lexicographic order: 65 operations.

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
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading2 = np.sin(heading2)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = l2 + q2
    t2 = cos_heading2 * cos_heading3 - sin_heading2 * sin_heading3
    t3 = l3 + q3
    t4 = l1 + cos_heading2 * t1 + t2 * t3
    t5 = cos_heading2 * sin_heading3 + cos_heading3 * sin_heading2
    t6 = t1 * sin_heading2 + t3 * t5
    t7 = cos_heading2 * t4 + sin_heading2 * t6
    t8 = t2 * t4 + t5 * t6
    t9 = cos_heading2 * t5 - sin_heading2 * t2
    t10 = np.sqrt((t7 * t7 + t8 * t8 + t9 * t9))
    t11 = t8 / t10
    t12 = t7 / t10
    t13 = t5 * t11 + sin_heading2 * t12
    t14 = t2 * t11 + cos_heading2 * t12
    t15 = sin_heading2 * t13 + cos_heading2 * t14
    t16 = t5 * t13 + t2 * t14
    t17 = 1.0 / t10
    t18 = t17 * t17
    t19 = -0.5 / t10 * np.sqrt(t17)

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = t10
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t10 != 0.0, t15, 0.0)
    gradient[..., 2] = np.where(t10 != 0.0, t16, 0.0)
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t10 != 0.0, -(t15 * t18), 0.0)
    inverse_gradient[..., 2] = np.where(t10 != 0.0, -(t16 * t18), 0.0)
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t10 != 0.0, t15 * t19, 0.0)
    inverse_root_gradient[..., 2] = np.where(t10 != 0.0, t16 * t19, 0.0)
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_position(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the position Jacobian, columns in lexicographic order: 76 operations.

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
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading2 = np.sin(heading2)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = l2 + q2
    t2 = cos_heading2 * cos_heading3 - sin_heading2 * sin_heading3
    t3 = l3 + q3
    t4 = l1 + cos_heading2 * t1 + t2 * t3
    t5 = cos_heading2 * sin_heading3 + cos_heading3 * sin_heading2
    t6 = t1 * sin_heading2 + t3 * t5
    t7 = cos_heading2 * t4 + sin_heading2 * t6
    t8 = t2 * t4 + t5 * t6
    t9 = cos_heading2 * t5 - sin_heading2 * t2
    t10 = t8 + t8
    t11 = t7 + t7
    t12 = t5 * t10 + sin_heading2 * t11
    t13 = t2 * t10 + cos_heading2 * t11
    t14 = cos_heading2 * t2 + sin_heading2 * t5
    t15 = t14 + t14
    t16 = sin_heading2 * (t5 * t15 + (sin_heading2 + sin_heading2)) + cos_heading2 * (t2 * t15 + (cos_heading2 + cos_heading2))
    t17 = t2 * t2 + t5 * t5
    t18 = t17 + t17
    t19 = t5 * t18 + sin_heading2 * t15
    t20 = t2 * t18 + cos_heading2 * t15
    t21 = sin_heading2 * t19 + cos_heading2 * t20

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = t7 * t7 + t8 * t8 + t9 * t9
    gradient[..., 0] = 0.0
    gradient[..., 1] = sin_heading2 * t12 + cos_heading2 * t13
    gradient[..., 2] = t5 * t12 + t2 * t13
    hessian[..., 0] = 0.0
    hessian[..., 1] = 0.0
    hessian[..., 2] = 0.0
    hessian[..., 3] = 0.0
    hessian[..., 4] = t16
    hessian[..., 5] = t21
    hessian[..., 6] = 0.0
    hessian[..., 7] = t21
    hessian[..., 8] = t5 * t19 + t2 * t20
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_position(q, parameters):
    """maximal minors of the position Jacobian, columns in lexicographic order: 30 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
    out  minors[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading2 = np.sin(heading2)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = l2 + q2
    t2 = cos_heading2 * cos_heading3 - sin_heading2 * sin_heading3
    t3 = l3 + q3
    t4 = l1 + cos_heading2 * t1 + t2 * t3
    t5 = cos_heading2 * sin_heading3 + cos_heading3 * sin_heading2
    t6 = t1 * sin_heading2 + t3 * t5

    # results
    minors = np.empty((*leading, 3), real)
    minors[..., 0] = -(cos_heading2 * t4 + sin_heading2 * t6)
    minors[..., 1] = -(t2 * t4 + t5 * t6)
    minors[..., 2] = cos_heading2 * t5 - sin_heading2 * t2
    return minors.reshape(leading + (3,))


def null_vector_position(q, parameters):
    """null vector of the position Jacobian from its signed minors, |N| = H: 29 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
    out  null_vector[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    heading3 = parameters[..., 4]
    sin_heading3 = np.sin(heading3)
    cos_heading3 = np.cos(heading3)
    sin_heading2 = np.sin(heading2)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = cos_heading2 * sin_heading3 + cos_heading3 * sin_heading2
    t2 = cos_heading2 * cos_heading3 - sin_heading3 * sin_heading2
    t3 = l2 + q2
    t4 = l3 + q3
    t5 = l1 + cos_heading2 * t3 + t2 * t4
    t6 = sin_heading2 * t3 + t1 * t4

    # results
    null_vector = np.empty((*leading, 3), real)
    null_vector[..., 0] = cos_heading2 * t1 - sin_heading2 * t2
    null_vector[..., 1] = t2 * t5 + t1 * t6
    null_vector[..., 2] = -(cos_heading2 * t5 + sin_heading2 * t6)
    return null_vector.reshape(leading + (3,))


def null_projector_position(q, parameters):
    """projector I - J^+ J onto the null space of the position Jacobian: 168 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
    out  null_projector[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading2 = np.sin(heading2)
    sin_heading3 = np.sin(heading3)
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    l1 = parameters[..., 0]

    # terms
    t1 = cos_heading2 * cos_heading3 - sin_heading2 * sin_heading3
    t2 = l2 + q2
    t3 = cos_heading2 * sin_heading3 + cos_heading3 * sin_heading2
    t4 = l3 + q3
    t5 = sin_heading2 * t2 + t3 * t4
    t6 = np.sqrt((cos_heading2 * cos_heading2 + t1 * t1 + t5 * t5))
    t7 = np.where(t6 != 0.0, t5 / t6, 0.0)
    t8 = cos_heading2 / t6
    t9 = t1 / t6
    t10 = t7 * t7 + np.where(t6 != 0.0, np.where(t6 != 0.0, t8 * t8, 0.0), 0.0) + np.where(t6 != 0.0, np.where(t6 != 0.0, t9 * t9, 0.0), 0.0)
    t11 = np.sqrt(t10)
    t12 = t7 / t11
    t13 = l1 + cos_heading2 * t2 + t1 * t4
    t14 = t9 / t11
    t15 = t8 / t11
    t16 = np.where(t6 != 0.0, np.where(t11 != 0.0, t3 * t14 + sin_heading2 * t15, 0.0), 0.0) + np.where(t11 != 0.0, -(t12 * t13), 0.0)
    t17 = t13 - np.where(t11 != 0.0, -(t12 * t16), 0.0)
    t18 = sin_heading2 - np.where(t6 != 0.0, np.where(t11 != 0.0, t15 * t16, 0.0), 0.0)
    t19 = t3 - np.where(t6 != 0.0, np.where(t11 != 0.0, t14 * t16, 0.0), 0.0)
    t20 = np.sqrt((t17 * t17 + t18 * t18 + t19 * t19))
    t21 = t17 / t20
    t22 = t18 / t20
    t23 = np.where(t11 != 0.0, -(t12 * t21), 0.0) + np.where(t6 != 0.0, np.where(t11 != 0.0, t15 * t22, 0.0), 0.0)
    t24 = t19 / t20
    t25 = t23 + np.where(t6 != 0.0, np.where(t11 != 0.0, t14 * t24, 0.0), 0.0)
    t26 = np.where(t20 != 0.0, t21, 0.0) - np.where(t11 != 0.0, np.where(t20 != 0.0, -(t12 * t25), 0.0), 0.0)
    t27 = np.where(t20 != 0.0, t22, 0.0) - np.where(t6 != 0.0, np.where(t11 != 0.0, np.where(t20 != 0.0, t15 * t25, 0.0), 0.0), 0.0)
    t28 = np.where(t20 != 0.0, t24, 0.0) - np.where(t6 != 0.0, np.where(t11 != 0.0, np.where(t20 != 0.0, t14 * t25, 0.0), 0.0), 0.0)
    t29 = np.sqrt((t26 * t26 + t27 * t27 + t28 * t28))
    t30 = t26 / t29
    t31 = 1.0 - np.where(t11 != 0.0, np.where(t11 != 0.0, t12 * t12, 0.0), 0.0) - np.where(t29 != 0.0, np.where(t29 != 0.0, t30 * t30, 0.0), 0.0)
    t32 = t27 / t29
    t33 = np.where(t6 != 0.0, np.where(t11 != 0.0, np.where(t11 != 0.0, -(t12 * t15), 0.0), 0.0), 0.0) + np.where(t29 != 0.0, np.where(t29 != 0.0, t30 * t32, 0.0), 0.0)
    t34 = -t33
    t35 = t28 / t29
    t36 = np.where(t6 != 0.0, np.where(t11 != 0.0, np.where(t11 != 0.0, -(t12 * t14), 0.0), 0.0), 0.0) + np.where(t29 != 0.0, np.where(t29 != 0.0, t30 * t35, 0.0), 0.0)
    t37 = -t36
    t38 = 1.0 - np.where(t6 != 0.0, np.where(t11 != 0.0, np.where(t6 != 0.0, np.where(t11 != 0.0, t15 * t15, 0.0), 0.0), 0.0), 0.0) - np.where(t29 != 0.0, np.where(t29 != 0.0, t32 * t32, 0.0), 0.0)
    t39 = np.where(t6 != 0.0, np.where(t11 != 0.0, np.where(t6 != 0.0, np.where(t11 != 0.0, t14 * t15, 0.0), 0.0), 0.0), 0.0) + np.where(t29 != 0.0, np.where(t29 != 0.0, t32 * t35, 0.0), 0.0)
    t40 = -t39
    t41 = 1.0 - np.where(t6 != 0.0, np.where(t11 != 0.0, np.where(t6 != 0.0, np.where(t11 != 0.0, t14 * t14, 0.0), 0.0), 0.0), 0.0) - np.where(t29 != 0.0, np.where(t29 != 0.0, t35 * t35, 0.0), 0.0)

    # results
    null_projector = np.empty((*leading, 9), real)
    null_projector[..., 0] = t31
    null_projector[..., 1] = t34
    null_projector[..., 2] = t37
    null_projector[..., 3] = t34
    null_projector[..., 4] = t38
    null_projector[..., 5] = t40
    null_projector[..., 6] = t37
    null_projector[..., 7] = t40
    null_projector[..., 8] = t41
    return null_projector.reshape(leading + (3, 3))
