"""manipulability (position) of planar_rpr, in NumPy.

Made from templates/kernel.py.j2; inputs 4fcb78b149cbfbd383ed1fce592dc846fb23a4be4aaeb9a8d013ae51b9937058.
455 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_position(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the position Jacobian: 33 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l2 + q2
    t2 = (cos_heading2 * c3 - sin_heading2 * s3) * l3
    t3 = l1 + cos_heading2 * t1 + t2
    t4 = l3 * (cos_heading2 * s3 + c3 * sin_heading2)
    t5 = t1 * sin_heading2 + t4
    t6 = cos_heading2 * t3 + sin_heading2 * t5
    t7 = t3 * t4 - t2 * t5
    t8 = cos_heading2 * t2 + sin_heading2 * t4

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.sqrt((t6 * t6 + t7 * t7 + t8 * t8))
    return manipulability.reshape(leading)


def manipulability_gradient_position(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in lexicographic order: 81 operations.

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
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l2 + q2
    t2 = (cos_heading2 * c3 - sin_heading2 * s3) * l3
    t3 = l1 + cos_heading2 * t1 + t2
    t4 = l3 * (cos_heading2 * s3 + c3 * sin_heading2)
    t5 = t1 * sin_heading2 + t4
    t6 = cos_heading2 * t3 + sin_heading2 * t5
    t7 = t3 * t4 - t2 * t5
    t8 = cos_heading2 * t2 + sin_heading2 * t4
    t9 = np.sqrt((t6 * t6 + t7 * t7 + t8 * t8))
    t10 = t6 / t9
    t11 = t7 / t9
    t12 = sin_heading2 * t10 - t2 * t11
    t13 = t4 * t11 + cos_heading2 * t10
    t14 = sin_heading2 * t12 + cos_heading2 * t13
    t15 = t8 / t9
    t16 = l3 * (t12 + (sin_heading2 * t15 + t3 * t11))
    t17 = l3 * (t13 + (cos_heading2 * t15 - t5 * t11))
    t18 = c3 * (cos_heading2 * t16 - sin_heading2 * t17) - s3 * (sin_heading2 * t16 + cos_heading2 * t17)
    t19 = 1.0 / t9
    t20 = t19 * t19
    t21 = -0.5 / t9 * np.sqrt(t19)

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = t9
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t9 != 0.0, t14, 0.0)
    gradient[..., 2] = np.where(t9 != 0.0, t18, 0.0)
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t9 != 0.0, -(t14 * t20), 0.0)
    inverse_gradient[..., 2] = np.where(t9 != 0.0, -(t18 * t20), 0.0)
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t9 != 0.0, t14 * t21, 0.0)
    inverse_root_gradient[..., 2] = np.where(t9 != 0.0, t18 * t21, 0.0)
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_position(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the position Jacobian, columns in lexicographic order: 120 operations.

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
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l2 + q2
    t2 = (cos_heading2 * c3 - sin_heading2 * s3) * l3
    t3 = l1 + cos_heading2 * t1 + t2
    t4 = l3 * (cos_heading2 * s3 + c3 * sin_heading2)
    t5 = t1 * sin_heading2 + t4
    t6 = cos_heading2 * t3 + sin_heading2 * t5
    t7 = t3 * t4 - t2 * t5
    t8 = cos_heading2 * t2 + sin_heading2 * t4
    t9 = t6 + t6
    t10 = t7 + t7
    t11 = t2 * t10
    t12 = sin_heading2 * t9 - t11
    t13 = t4 * t10
    t14 = t13 + cos_heading2 * t9
    t15 = t8 + t8
    t16 = l3 * (t12 + (sin_heading2 * t15 + t3 * t10))
    t17 = l3 * (t14 + (cos_heading2 * t15 - t5 * t10))
    t18 = cos_heading2 * t16 - sin_heading2 * t17
    t19 = sin_heading2 * t16 + cos_heading2 * t17
    t20 = cos_heading2 * t4
    t21 = sin_heading2 * t2
    t22 = t20 - t21
    t23 = t22 + t22
    t24 = sin_heading2 * (sin_heading2 + sin_heading2 - t2 * t23) + cos_heading2 * (t4 * t23 + (cos_heading2 + cos_heading2))
    t25 = t21 - t20
    t26 = t25 + t25
    t27 = sin_heading2 * t26
    t28 = t2 * t3 - t4 * t4 - (t2 * t2 - t4 * t5)
    t29 = t28 + t28
    t30 = t27 - (t2 * t29 - t13)
    t31 = cos_heading2 * t26
    t32 = t11 + t4 * t29 + t31
    t33 = sin_heading2 * t30 + cos_heading2 * t32
    t34 = l3 * (t30 + (t27 + (t3 * t29 - t13)))
    t35 = l3 * (t32 + (t31 - (t11 + t5 * t29)))
    t36 = c3 * (cos_heading2 * t34 - sin_heading2 * t35) - s3 * t18 - (c3 * t19 + s3 * (sin_heading2 * t34 + cos_heading2 * t35))

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = t6 * t6 + t7 * t7 + t8 * t8
    gradient[..., 0] = 0.0
    gradient[..., 1] = sin_heading2 * t12 + cos_heading2 * t14
    gradient[..., 2] = c3 * t18 - s3 * t19
    hessian[..., 0] = 0.0
    hessian[..., 1] = 0.0
    hessian[..., 2] = 0.0
    hessian[..., 3] = 0.0
    hessian[..., 4] = t24
    hessian[..., 5] = t33
    hessian[..., 6] = 0.0
    hessian[..., 7] = t33
    hessian[..., 8] = t36
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_position(q, parameters):
    """maximal minors of the position Jacobian, columns in lexicographic order: 28 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l2 + q2
    t2 = (cos_heading2 * c3 - sin_heading2 * s3) * l3
    t3 = l1 + cos_heading2 * t1 + t2
    t4 = l3 * (cos_heading2 * s3 + c3 * sin_heading2)
    t5 = t1 * sin_heading2 + t4

    # results
    minors = np.empty((*leading, 3), real)
    minors[..., 0] = -(cos_heading2 * t3 + sin_heading2 * t5)
    minors[..., 1] = t3 * t4 - t2 * t5
    minors[..., 2] = cos_heading2 * t2 + sin_heading2 * t4
    return minors.reshape(leading + (3,))


def null_vector_position(q, parameters):
    """null vector of the position Jacobian from its signed minors, |N| = H: 29 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
    out  null_vector[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]

    # terms
    t1 = (cos_heading2 * c3 - sin_heading2 * s3) * l3
    t2 = l3 * (cos_heading2 * s3 + c3 * sin_heading2)
    t3 = l2 + q2
    t4 = t1 + (l1 + cos_heading2 * t3)
    t5 = t2 + sin_heading2 * t3

    # results
    null_vector = np.empty((*leading, 3), real)
    null_vector[..., 0] = cos_heading2 * t1 + sin_heading2 * t2
    null_vector[..., 1] = -(t2 * t4 - t1 * t5)
    null_vector[..., 2] = -(cos_heading2 * t4 + sin_heading2 * t5)
    return null_vector.reshape(leading + (3,))


def null_projector_position(q, parameters):
    """projector I - J^+ J onto the null space of the position Jacobian: 164 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
    out  null_projector[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)
    sin_heading2 = np.sin(heading2)
    l3 = parameters[..., 2]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    l1 = parameters[..., 0]

    # terms
    t1 = (cos_heading2 * s3 + c3 * sin_heading2) * l3
    t2 = l2 + q2
    t3 = t1 + sin_heading2 * t2
    t4 = np.sqrt((cos_heading2 * cos_heading2 + t1 * t1 + t3 * t3))
    t5 = np.where(t4 != 0.0, t3 / t4, 0.0)
    t6 = cos_heading2 / t4
    t7 = np.where(t4 != 0.0, t1 / t4, 0.0)
    t8 = t5 * t5 + np.where(t4 != 0.0, np.where(t4 != 0.0, t6 * t6, 0.0), 0.0) + t7 * t7
    t9 = np.sqrt(t8)
    t10 = t5 / t9
    t11 = l3 * (cos_heading2 * c3 - s3 * sin_heading2)
    t12 = l1 + cos_heading2 * t2 + t11
    t13 = t7 / t9
    t14 = t6 / t9
    t15 = np.where(t9 != 0.0, -(t11 * t13), 0.0) + np.where(t4 != 0.0, np.where(t9 != 0.0, sin_heading2 * t14, 0.0), 0.0)
    t16 = t15 + np.where(t9 != 0.0, -(t10 * t12), 0.0)
    t17 = t12 - np.where(t9 != 0.0, -(t10 * t16), 0.0)
    t18 = sin_heading2 - np.where(t4 != 0.0, np.where(t9 != 0.0, t14 * t16, 0.0), 0.0)
    t19 = t11 - np.where(t9 != 0.0, -(t13 * t16), 0.0)
    t20 = np.sqrt((t17 * t17 + t18 * t18 + t19 * t19))
    t21 = t17 / t20
    t22 = t18 / t20
    t23 = np.where(t9 != 0.0, -(t10 * t21), 0.0) + np.where(t4 != 0.0, np.where(t9 != 0.0, t14 * t22, 0.0), 0.0)
    t24 = t19 / t20
    t25 = t23 + np.where(t9 != 0.0, -(t13 * t24), 0.0)
    t26 = np.where(t20 != 0.0, t21, 0.0) - np.where(t9 != 0.0, np.where(t20 != 0.0, -(t10 * t25), 0.0), 0.0)
    t27 = np.where(t20 != 0.0, t22, 0.0) - np.where(t4 != 0.0, np.where(t9 != 0.0, np.where(t20 != 0.0, t14 * t25, 0.0), 0.0), 0.0)
    t28 = np.where(t20 != 0.0, t24, 0.0) - np.where(t9 != 0.0, np.where(t20 != 0.0, -(t13 * t25), 0.0), 0.0)
    t29 = np.sqrt((t26 * t26 + t27 * t27 + t28 * t28))
    t30 = t26 / t29
    t31 = 1.0 - np.where(t9 != 0.0, np.where(t9 != 0.0, t10 * t10, 0.0), 0.0) - np.where(t29 != 0.0, np.where(t29 != 0.0, t30 * t30, 0.0), 0.0)
    t32 = t27 / t29
    t33 = np.where(t4 != 0.0, np.where(t9 != 0.0, np.where(t9 != 0.0, -(t10 * t14), 0.0), 0.0), 0.0) + np.where(t29 != 0.0, np.where(t29 != 0.0, t30 * t32, 0.0), 0.0)
    t34 = -t33
    t35 = t28 / t29
    t36 = np.where(t9 != 0.0, np.where(t9 != 0.0, t10 * t13, 0.0), 0.0) + np.where(t29 != 0.0, np.where(t29 != 0.0, t30 * t35, 0.0), 0.0)
    t37 = -t36
    t38 = 1.0 - np.where(t4 != 0.0, np.where(t9 != 0.0, np.where(t4 != 0.0, np.where(t9 != 0.0, t14 * t14, 0.0), 0.0), 0.0), 0.0) - np.where(t29 != 0.0, np.where(t29 != 0.0, t32 * t32, 0.0), 0.0)
    t39 = np.where(t9 != 0.0, np.where(t4 != 0.0, np.where(t9 != 0.0, -(t13 * t14), 0.0), 0.0), 0.0) + np.where(t29 != 0.0, np.where(t29 != 0.0, t32 * t35, 0.0), 0.0)
    t40 = -t39
    t41 = 1.0 - np.where(t9 != 0.0, np.where(t9 != 0.0, t13 * t13, 0.0), 0.0) - np.where(t29 != 0.0, np.where(t29 != 0.0, t35 * t35, 0.0), 0.0)

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
