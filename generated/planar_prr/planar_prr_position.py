"""manipulability (position) of planar_prr, in NumPy.

Made from templates/kernel.py.j2; inputs f7751c7cae58eb7884348987627a3ed0ab2d2451fe63dcf71fb85cecfbd612a9.
471 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_position(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the position Jacobian: 28 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
    out  manipulability (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    l2 = parameters[..., 1]
    l1 = parameters[..., 0]
    q1 = q[..., 0]

    # terms
    t1 = (c2 * c3 - s2 * s3) * l3
    t2 = l3 * (c2 * s3 + c3 * s2)
    t3 = l1 + q1
    t4 = t1 + (t3 + c2 * l2) - t3
    t5 = t1 * (s2 * l2 + t2) - t2 * t4

    # results
    manipulability = np.empty((*leading, 1), real)
    manipulability[..., 0] = np.sqrt((t5 * t5 + t4 * t4 + t1 * t1))
    return manipulability.reshape(leading)


def manipulability_gradient_position(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in lexicographic order: 80 operations.

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
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l1 + q1
    t2 = (c2 * c3 - s2 * s3) * l3
    t3 = t1 + c2 * l2 + t2 - t1
    t4 = l3 * (c2 * s3 + c3 * s2)
    t5 = l2 * s2 + t4
    t6 = t2 * t5 - t3 * t4
    t7 = np.sqrt((t3 * t3 + t2 * t2 + t6 * t6))
    t8 = t6 / t7
    t9 = t2 * t8
    t10 = l3 * (t9 - t3 * t8)
    t11 = t3 / t7 - t4 * t8
    t12 = l3 * (t5 * t8 + t2 / t7 + t11)
    t13 = c2 * (c3 * t10 + l2 * t9 - s3 * t12) - s2 * (s3 * t10 + c3 * t12 + l2 * t11)
    t14 = c3 * (c2 * t10 - s2 * t12) - s3 * (s2 * t10 + c2 * t12)
    t15 = 1.0 / t7
    t16 = t15 * t15
    t17 = -0.5 / t7 * np.sqrt(t15)

    # results
    manipulability = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    inverse_gradient = np.empty((*leading, 3), real)
    inverse_root_gradient = np.empty((*leading, 3), real)
    manipulability[..., 0] = t7
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t7 != 0.0, t13, 0.0)
    gradient[..., 2] = np.where(t7 != 0.0, t14, 0.0)
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t7 != 0.0, -(t13 * t16), 0.0)
    inverse_gradient[..., 2] = np.where(t7 != 0.0, -(t14 * t16), 0.0)
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t7 != 0.0, t13 * t17, 0.0)
    inverse_root_gradient[..., 2] = np.where(t7 != 0.0, t14 * t17, 0.0)
    return manipulability.reshape(leading), gradient.reshape(leading + (3,)), inverse_gradient.reshape(leading + (3,)), inverse_root_gradient.reshape(leading + (3,))


def manipulability_hessian_position(q, parameters):
    """H^2, its gradient and its Hessian, through the maximal minors of the position Jacobian, columns in lexicographic order: 159 operations.

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
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l1 + q1
    t2 = c2 * l2
    t3 = (c2 * c3 - s2 * s3) * l3
    t4 = t1 + t2 + t3 - t1
    t5 = t3 * t3
    t6 = l2 * s2
    t7 = l3 * (c2 * s3 + c3 * s2)
    t8 = t6 + t7
    t9 = t3 * t8 - t4 * t7
    t10 = t9 + t9
    t11 = t3 * t10
    t12 = l3 * (t11 - t4 * t10)
    t13 = c3 * t12
    t14 = t7 * t10
    t15 = t4 + t4 - t14
    t16 = l3 * (t8 * t10 + (t3 + t3) + t15)
    t17 = s3 * t16
    t18 = t13 + l2 * t11 - t17
    t19 = s3 * t12
    t20 = c3 * t16
    t21 = t19 + t20 + l2 * t15
    t22 = c2 * t12 - s2 * t16
    t23 = s2 * t12 + c2 * t16
    t24 = t2 + t3
    t25 = t7 * t8
    t26 = -1.0 + (1.0 - t6 - t7)
    t27 = t3 * t4
    t28 = t3 * t24 - t25 - (t7 * t26 + t27)
    t29 = t28 + t28
    t30 = t3 * t29 - t14
    t31 = l3 * (t30 - (t10 * t26 + t4 * t29))
    t32 = -t7 - t7
    t33 = t26 + t26 - (t11 + t7 * t29)
    t34 = l3 * (t10 * t24 + t8 * t29 + t32 + t33)
    t35 = c2 * (c3 * t31 + l2 * t30 - s3 * t34) - s2 * t18
    t36 = c2 * t21 + s2 * (s3 * t31 + c3 * t34 + l2 * t33)
    t37 = t5 - t25 - (t27 - t7 * t7)
    t38 = t37 + t37
    t39 = t3 * t38 - t14
    t40 = l3 * (t39 - (t4 * t38 - t14))
    t41 = t32 - (t11 + t7 * t38)
    t42 = l3 * (t32 + (t11 + t8 * t38) + t41)
    t43 = c3 * t40 - t19 + l2 * t39 - (t20 + s3 * t42)
    t44 = t13 + s3 * t40 + (c3 * t42 - t17) + l2 * t41
    t45 = c2 * t43 - s2 * t44
    t46 = c3 * (c2 * t40 - s2 * t42) - s3 * t22 - (c3 * t23 + s3 * (s2 * t40 + c2 * t42))

    # results
    square = np.empty((*leading, 1), real)
    gradient = np.empty((*leading, 3), real)
    hessian = np.empty((*leading, 9), real)
    square[..., 0] = t4 * t4 + t5 + t9 * t9
    gradient[..., 0] = 0.0
    gradient[..., 1] = c2 * t18 - s2 * t21
    gradient[..., 2] = c3 * t22 - s3 * t23
    hessian[..., 0] = 0.0
    hessian[..., 1] = 0.0
    hessian[..., 2] = 0.0
    hessian[..., 3] = 0.0
    hessian[..., 4] = t35 - t36
    hessian[..., 5] = t45
    hessian[..., 6] = 0.0
    hessian[..., 7] = t45
    hessian[..., 8] = t46
    return square.reshape(leading), gradient.reshape(leading + (3,)), hessian.reshape(leading + (3, 3))


def minors_position(q, parameters):
    """maximal minors of the position Jacobian, columns in lexicographic order: 23 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
    out  minors[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    l2 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]

    # terms
    t1 = l1 + q1
    t2 = (c2 * c3 - s2 * s3) * l3
    t3 = t1 + c2 * l2 + t2 - t1
    t4 = l3 * (c2 * s3 + c3 * s2)

    # results
    minors = np.empty((*leading, 3), real)
    minors[..., 0] = t3
    minors[..., 1] = t2
    minors[..., 2] = -(t2 * (l2 * s2 + t4) - t3 * t4)
    return minors.reshape(leading + (3,))


def null_vector_position(q, parameters):
    """null vector of the position Jacobian from its signed minors, |N| = H: 24 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
    out  null_vector[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    l2 = parameters[..., 1]
    l1 = parameters[..., 0]
    q1 = q[..., 0]

    # terms
    t1 = (c2 * c3 - s2 * s3) * l3
    t2 = l3 * (c2 * s3 + c3 * s2)
    t3 = l1 + q1
    t4 = t1 + (t3 + c2 * l2) - t3

    # results
    null_vector = np.empty((*leading, 3), real)
    null_vector[..., 0] = -(t1 * (s2 * l2 + t2) - t2 * t4)
    null_vector[..., 1] = -t1
    null_vector[..., 2] = t4
    return null_vector.reshape(leading + (3,))


def null_projector_position(q, parameters):
    """projector I - J^+ J onto the null space of the position Jacobian: 157 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
    out  null_projector[3][3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    q2 = q[..., 1]
    c2 = np.cos(q2)
    q3 = q[..., 2]
    s3 = np.sin(q3)
    c3 = np.cos(q3)
    s2 = np.sin(q2)
    l3 = parameters[..., 2]
    l2 = parameters[..., 1]
    l1 = parameters[..., 0]
    q1 = q[..., 0]

    # terms
    t1 = (c2 * s3 + c3 * s2) * l3
    t2 = t1 + s2 * l2
    t3 = np.sqrt((1.0 + t1 * t1 + t2 * t2))
    t4 = 1.0 / t3
    t5 = np.where(t3 != 0.0, t2 / t3, 0.0)
    t6 = np.where(t3 != 0.0, t1 / t3, 0.0)
    t7 = np.where(t3 != 0.0, np.where(t3 != 0.0, t4 * t4, 0.0), 0.0) + t5 * t5 + t6 * t6
    t8 = np.sqrt(t7)
    t9 = t4 / t8
    t10 = l1 + q1
    t11 = l3 * (c2 * c3 - s3 * s2)
    t12 = t10 + c2 * l2 + t11 - t10
    t13 = t5 / t8
    t14 = t6 / t8
    t15 = t12 * t13 + t11 * t14
    t16 = np.where(t8 != 0.0, np.where(t3 != 0.0, np.where(t8 != 0.0, -(t9 * t15), 0.0), 0.0), 0.0)
    t17 = t12 - np.where(t8 != 0.0, np.where(t8 != 0.0, t13 * t15, 0.0), 0.0)
    t18 = t11 - np.where(t8 != 0.0, np.where(t8 != 0.0, t14 * t15, 0.0), 0.0)
    t19 = np.sqrt((t16 * t16 + t17 * t17 + t18 * t18))
    t20 = t16 / t19
    t21 = t17 / t19
    t22 = t18 / t19
    t23 = np.where(t3 != 0.0, -(t9 * t20), 0.0) - t13 * t21 - t14 * t22
    t24 = np.where(t19 != 0.0, -t20, 0.0) - np.where(t8 != 0.0, np.where(t3 != 0.0, np.where(t19 != 0.0, np.where(t8 != 0.0, t9 * t23, 0.0), 0.0), 0.0), 0.0)
    t25 = np.where(t19 != 0.0, t21, 0.0) - np.where(t8 != 0.0, np.where(t19 != 0.0, np.where(t8 != 0.0, -(t13 * t23), 0.0), 0.0), 0.0)
    t26 = np.where(t19 != 0.0, t22, 0.0) - np.where(t8 != 0.0, np.where(t19 != 0.0, np.where(t8 != 0.0, -(t14 * t23), 0.0), 0.0), 0.0)
    t27 = np.sqrt((t24 * t24 + t25 * t25 + t26 * t26))
    t28 = t24 / t27
    t29 = 1.0 - np.where(t8 != 0.0, np.where(t3 != 0.0, np.where(t8 != 0.0, np.where(t3 != 0.0, t9 * t9, 0.0), 0.0), 0.0), 0.0) - np.where(t27 != 0.0, np.where(t27 != 0.0, t28 * t28, 0.0), 0.0)
    t30 = t25 / t27
    t31 = np.where(t8 != 0.0, np.where(t8 != 0.0, np.where(t3 != 0.0, -(t9 * t13), 0.0), 0.0), 0.0) + np.where(t27 != 0.0, np.where(t27 != 0.0, t28 * t30, 0.0), 0.0)
    t32 = -t31
    t33 = t26 / t27
    t34 = np.where(t8 != 0.0, np.where(t8 != 0.0, np.where(t3 != 0.0, -(t9 * t14), 0.0), 0.0), 0.0) + np.where(t27 != 0.0, np.where(t27 != 0.0, t28 * t33, 0.0), 0.0)
    t35 = -t34
    t36 = 1.0 - np.where(t8 != 0.0, np.where(t8 != 0.0, t13 * t13, 0.0), 0.0) - np.where(t27 != 0.0, np.where(t27 != 0.0, t30 * t30, 0.0), 0.0)
    t37 = np.where(t8 != 0.0, np.where(t8 != 0.0, t13 * t14, 0.0), 0.0) + np.where(t27 != 0.0, np.where(t27 != 0.0, t30 * t33, 0.0), 0.0)
    t38 = -t37
    t39 = 1.0 - np.where(t8 != 0.0, np.where(t8 != 0.0, t14 * t14, 0.0), 0.0) - np.where(t27 != 0.0, np.where(t27 != 0.0, t33 * t33, 0.0), 0.0)

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
