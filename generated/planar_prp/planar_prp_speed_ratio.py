"""speed ratio of planar_prp, in NumPy.

Made from templates/kernel.py.j2; inputs 5e782a4dbb776283d7e332c2a3d14067fc8f8cd7fa1ffed7a08f5e0fd70323a9.
672 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 123 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    in   tangent[2] = (tx, ty)
    in   curvature[2] = (kappa, kappa_s)
    out  A[3]
    out  B[6]
    out  B0[6]
    out  B1[6]
    out  a[3]
    out  b[3]
    out  C (one number)
    out  D (one number)
    out  discriminant (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    tangent = np.asarray(tangent)
    curvature = np.asarray(curvature)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    real = np.result_type(q, parameters, tangent, curvature, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    sin_heading1 = np.sin(heading1)
    s2 = np.sin(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = l1 + q1
    t2 = cos_heading1 * t1
    t3 = cos_heading1 * c2 - sin_heading1 * s2
    t4 = cos_heading1 * s2 + c2 * sin_heading1
    t5 = t3 * cos_heading3 - t4 * sin_heading3
    t6 = l3 + q3
    t7 = t2 + t3 * l2 + t5 * t6 - t2
    t8 = t1 * sin_heading1
    t9 = cos_heading3 * t4 + t3 * sin_heading3
    t10 = t8 + l2 * t4 + t6 * t9 - t8
    t11 = t7 * tx + t10 * ty
    t12 = tx * t9 - t5 * ty
    t13 = -t12
    t14 = sin_heading1 * tx - cos_heading1 * ty
    t15 = t6 * t12 + l2 * (t4 * tx - t3 * ty)
    t16 = t7 * ty - tx * t10
    t17 = t11 * t11 + t16 * t16
    t18 = t5 * tx + t9 * ty
    t19 = t12 * t12 + t18 * t18
    t20 = -2.0 * t18
    t21 = t12 * (t11 + t11) + t18 * (t16 + t16)
    t22 = t14 + t14
    t23 = cos_heading1 * tx + sin_heading1 * ty
    t24 = t23 + t23
    t25 = t11 * t22 + t16 * t24
    t26 = t12 * t22 + t18 * t24
    t27 = t14 * t14 + t23 * t23
    t28 = t11 / t12
    t29 = t16 + np.where(t13 != 0.0, -(t18 * t28), 0.0)
    t30 = t14 / t12
    t31 = t23 + np.where(t13 != 0.0, -(t18 * t30), 0.0)
    t32 = (t29 + t29) * t31
    t33 = t31 * t31
    t34 = t15 + np.where(t13 != 0.0, -(t20 * t28), 0.0)
    t35 = t20 * t30
    t36 = np.where(t13 != 0.0, -(t35 * (t32 + t32)), 0.0) - t34 * (4.0 * t33)
    t37 = np.where(t13 != 0.0, np.where(t13 != 0.0, t35 * t35, 0.0), 0.0)

    # results
    A = np.empty((*leading, 3), real)
    B = np.empty((*leading, 6), real)
    B0 = np.empty((*leading, 6), real)
    B1 = np.empty((*leading, 6), real)
    a = np.empty((*leading, 3), real)
    b = np.empty((*leading, 3), real)
    C = np.empty((*leading, 1), real)
    D = np.empty((*leading, 1), real)
    discriminant = np.empty((*leading, 1), real)
    A[..., 0] = -t11
    A[..., 1] = t13
    A[..., 2] = -t14
    B[..., 0] = t15 + t17 * kappa
    B[..., 1] = kappa * t19
    B[..., 2] = t20 + kappa * t21
    B[..., 3] = kappa * t25
    B[..., 4] = kappa * t26
    B[..., 5] = kappa * t27
    B0[..., 0] = t15
    B0[..., 1] = 0.0
    B0[..., 2] = t20
    B0[..., 3] = 0.0
    B0[..., 4] = 0.0
    B0[..., 5] = 0.0
    B1[..., 0] = t17
    B1[..., 1] = t19
    B1[..., 2] = t21
    B1[..., 3] = t25
    B1[..., 4] = t26
    B1[..., 5] = t27
    a[..., 0] = t29 * t29
    a[..., 1] = t32
    a[..., 2] = t33
    b[..., 0] = t34
    b[..., 1] = np.where(t13 != 0.0, -t35, 0.0)
    b[..., 2] = 0.0
    C[..., 0] = t36
    D[..., 0] = t37
    discriminant[..., 0] = t37 + kappa * t36
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 123 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    in   tangent[2] = (tx, ty)
    in   curvature[2] = (kappa, kappa_s)
    out  A[3]
    out  B[6]
    out  B0[6]
    out  B1[6]
    out  a[3]
    out  b[3]
    out  C (one number)
    out  D (one number)
    out  discriminant (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    tangent = np.asarray(tangent)
    curvature = np.asarray(curvature)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    real = np.result_type(q, parameters, tangent, curvature, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    sin_heading1 = np.sin(heading1)
    tx = tangent[..., 0]
    cos_heading1 = np.cos(heading1)
    ty = tangent[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    sin_heading3 = np.sin(heading3)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    kappa = curvature[..., 0]

    # terms
    t1 = sin_heading1 * tx - cos_heading1 * ty
    t2 = cos_heading1 * s2 + sin_heading1 * c2
    t3 = cos_heading1 * c2 - sin_heading1 * s2
    t4 = cos_heading3 * t2 + t3 * sin_heading3
    t5 = cos_heading3 * t3 - t2 * sin_heading3
    t6 = tx * t4 - ty * t5
    t7 = -t6
    t8 = l1 + q1
    t9 = cos_heading1 * t8
    t10 = l3 + q3
    t11 = t9 + t3 * l2 + t5 * t10 - t9
    t12 = sin_heading1 * t8
    t13 = t12 + t2 * l2 + t4 * t10 - t12
    t14 = tx * t11 + ty * t13
    t15 = tx * cos_heading1 + sin_heading1 * ty
    t16 = t1 * t1 + t15 * t15
    t17 = tx * t5 + ty * t4
    t18 = t6 * t6 + t17 * t17
    t19 = t1 + t1
    t20 = t15 + t15
    t21 = t6 * t19 + t17 * t20
    t22 = ty * t11 - tx * t13
    t23 = t14 * t19 + t20 * t22
    t24 = -2.0 * t17
    t25 = t6 * (t14 + t14) + t17 * (t22 + t22)
    t26 = t6 * t10 + l2 * (tx * t2 - ty * t3)
    t27 = t14 * t14 + t22 * t22
    t28 = t1 / t6
    t29 = t15 + np.where(t7 != 0.0, -(t17 * t28), 0.0)
    t30 = t29 * t29
    t31 = t14 / t6
    t32 = t22 + np.where(t7 != 0.0, -(t17 * t31), 0.0)
    t33 = (t29 + t29) * t32
    t34 = t24 * t28
    t35 = t26 + np.where(t7 != 0.0, -(t24 * t31), 0.0)
    t36 = np.where(t7 != 0.0, -(t34 * (t33 + t33)), 0.0) - t35 * (4.0 * t30)
    t37 = np.where(t7 != 0.0, np.where(t7 != 0.0, t34 * t34, 0.0), 0.0)

    # results
    A = np.empty((*leading, 3), real)
    B = np.empty((*leading, 6), real)
    B0 = np.empty((*leading, 6), real)
    B1 = np.empty((*leading, 6), real)
    a = np.empty((*leading, 3), real)
    b = np.empty((*leading, 3), real)
    C = np.empty((*leading, 1), real)
    D = np.empty((*leading, 1), real)
    discriminant = np.empty((*leading, 1), real)
    A[..., 0] = -t1
    A[..., 1] = t7
    A[..., 2] = -t14
    B[..., 0] = t16 * kappa
    B[..., 1] = kappa * t18
    B[..., 2] = kappa * t21
    B[..., 3] = kappa * t23
    B[..., 4] = t24 + kappa * t25
    B[..., 5] = t26 + kappa * t27
    B0[..., 0] = 0.0
    B0[..., 1] = 0.0
    B0[..., 2] = 0.0
    B0[..., 3] = 0.0
    B0[..., 4] = t24
    B0[..., 5] = t26
    B1[..., 0] = t16
    B1[..., 1] = t18
    B1[..., 2] = t21
    B1[..., 3] = t23
    B1[..., 4] = t25
    B1[..., 5] = t27
    a[..., 0] = t30
    a[..., 1] = t33
    a[..., 2] = t32 * t32
    b[..., 0] = 0.0
    b[..., 1] = np.where(t7 != 0.0, -t34, 0.0)
    b[..., 2] = t35
    C[..., 0] = t36
    D[..., 0] = t37
    discriminant[..., 0] = t37 + kappa * t36
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 140 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    in   tangent[2] = (tx, ty)
    in   curvature[2] = (kappa, kappa_s)
    out  A[3]
    out  B[6]
    out  B0[6]
    out  B1[6]
    out  a[3]
    out  b[3]
    out  C (one number)
    out  D (one number)
    out  discriminant (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    tangent = np.asarray(tangent)
    curvature = np.asarray(curvature)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    real = np.result_type(q, parameters, tangent, curvature, np.float32)

    # inputs, sines and cosines
    heading1 = parameters[..., 3]
    sin_heading1 = np.sin(heading1)
    tx = tangent[..., 0]
    cos_heading1 = np.cos(heading1)
    ty = tangent[..., 1]
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s2 = np.sin(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    kappa = curvature[..., 0]

    # terms
    t1 = sin_heading1 * tx - cos_heading1 * ty
    t2 = l1 + q1
    t3 = cos_heading1 * t2
    t4 = cos_heading1 * c2 - sin_heading1 * s2
    t5 = cos_heading1 * s2 + sin_heading1 * c2
    t6 = t4 * cos_heading3 - t5 * sin_heading3
    t7 = l3 + q3
    t8 = t3 + t4 * l2 + t6 * t7 - t3
    t9 = sin_heading1 * t2
    t10 = cos_heading3 * t5 + t4 * sin_heading3
    t11 = t9 + l2 * t5 + t7 * t10 - t9
    t12 = tx * t8 + ty * t11
    t13 = -t12
    t14 = tx * t10 - ty * t6
    t15 = tx * cos_heading1 + sin_heading1 * ty
    t16 = t1 * t1 + t15 * t15
    t17 = t7 * t14 + l2 * (tx * t5 - ty * t4)
    t18 = ty * t8 - tx * t11
    t19 = t12 * t12 + t18 * t18
    t20 = t1 + t1
    t21 = t15 + t15
    t22 = t12 * t20 + t18 * t21
    t23 = tx * t6 + ty * t10
    t24 = t14 * t20 + t21 * t23
    t25 = -2.0 * t23
    t26 = t14 * (t12 + t12) + t23 * (t18 + t18)
    t27 = t14 * t14 + t23 * t23
    t28 = t1 / t12
    t29 = t15 + np.where(t13 != 0.0, -(t18 * t28), 0.0)
    t30 = t29 * t29
    t31 = t14 / t12
    t32 = t23 + np.where(t13 != 0.0, -(t18 * t31), 0.0)
    t33 = (t29 + t29) * t32
    t34 = t32 * t32
    t35 = np.where(t13 != 0.0, -t28, 0.0)
    t36 = t17 * (t35 * t35)
    t37 = np.where(t13 != 0.0, -(t25 * t28), 0.0) - np.where(t13 != 0.0, np.where(t13 != 0.0, -(t28 * (t31 * (t17 + t17))), 0.0), 0.0)
    t38 = np.where(t13 != 0.0, -t31, 0.0)
    t39 = t17 * (t38 * t38) + np.where(t13 != 0.0, -(t25 * t31), 0.0)
    t40 = t37 * (t33 + t33) - t39 * (4.0 * t30) - t36 * (4.0 * t34)
    t41 = t37 * t37 - t39 * (4.0 * t36)

    # results
    A = np.empty((*leading, 3), real)
    B = np.empty((*leading, 6), real)
    B0 = np.empty((*leading, 6), real)
    B1 = np.empty((*leading, 6), real)
    a = np.empty((*leading, 3), real)
    b = np.empty((*leading, 3), real)
    C = np.empty((*leading, 1), real)
    D = np.empty((*leading, 1), real)
    discriminant = np.empty((*leading, 1), real)
    A[..., 0] = -t1
    A[..., 1] = t13
    A[..., 2] = -t14
    B[..., 0] = t16 * kappa
    B[..., 1] = t17 + kappa * t19
    B[..., 2] = kappa * t22
    B[..., 3] = kappa * t24
    B[..., 4] = t25 + kappa * t26
    B[..., 5] = kappa * t27
    B0[..., 0] = 0.0
    B0[..., 1] = t17
    B0[..., 2] = 0.0
    B0[..., 3] = 0.0
    B0[..., 4] = t25
    B0[..., 5] = 0.0
    B1[..., 0] = t16
    B1[..., 1] = t19
    B1[..., 2] = t22
    B1[..., 3] = t24
    B1[..., 4] = t26
    B1[..., 5] = t27
    a[..., 0] = t30
    a[..., 1] = t33
    a[..., 2] = t34
    b[..., 0] = t36
    b[..., 1] = t37
    b[..., 2] = t39
    C[..., 0] = t40
    D[..., 0] = t41
    discriminant[..., 0] = t41 + kappa * t40
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_rates(q, parameters, tangent, curvature):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 286 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
    in   tangent[2] = (tx, ty)
    in   curvature[2] = (kappa, kappa_s)
    out  rates[2][3]
    out  tracked[2]
    out  tracked_rate[2]
    out  parabola[3]
    out  discriminant (one number)
    out  least[3]
    out  null[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    tangent = np.asarray(tangent)
    curvature = np.asarray(curvature)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    real = np.result_type(q, parameters, tangent, curvature, np.float32)

    # inputs, sines and cosines
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    sin_heading1 = np.sin(heading1)
    sin_heading3 = np.sin(heading3)
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    kappa = curvature[..., 0]

    # terms
    t1 = cos_heading1 * s2 + c2 * sin_heading1
    t2 = cos_heading1 * c2 - s2 * sin_heading1
    t3 = cos_heading3 * t1 + t2 * sin_heading3
    t4 = cos_heading3 * t2 - t1 * sin_heading3
    t5 = t3 * tx - t4 * ty
    t6 = l1 + q1
    t7 = cos_heading1 * t6
    t8 = l3 + q3
    t9 = t7 + t2 * l2 + t4 * t8 - t7
    t10 = sin_heading1 * t6
    t11 = t10 + t1 * l2 + t3 * t8 - t10
    t12 = ty * t9 - tx * t11
    t13 = tx * t9 + ty * t11
    t14 = tx * t4 + t3 * ty
    t15 = t5 * t12 - t13 * t14
    t16 = sin_heading1 * tx - cos_heading1 * ty
    t17 = cos_heading1 * tx + sin_heading1 * ty
    t18 = t14 * t16 - t5 * t17
    t19 = t13 * t17 - t12 * t16
    t20 = np.sqrt((t15 * t15 + t18 * t18 + t19 * t19))
    t21 = t14 + t14
    t22 = t18 / t20
    t23 = t19 / t20
    t24 = t5 * t8
    t25 = t22 * t22
    t26 = np.where(t20 != 0.0, np.where(t20 != 0.0, t21 * t22 * t23, 0.0), 0.0) - np.where(t20 != 0.0, np.where(t20 != 0.0, t24 * t25, 0.0), 0.0)
    t27 = t1 * tx - t2 * ty
    t28 = l2 * t27
    t29 = t26 - np.where(t20 != 0.0, np.where(t20 != 0.0, t25 * t28, 0.0), 0.0)
    t30 = np.where(t29 != 0.0, 1.0, 0.0)
    t31 = t15 / t20
    t32 = (np.where(t20 != 0.0, t5 * t31, 0.0) - np.where(t20 != 0.0, t16 * t23, 0.0)) / t20
    t33 = (np.where(t20 != 0.0, t16 * t22, 0.0) - np.where(t20 != 0.0, t13 * t31, 0.0)) / t20
    t34 = t5 + t5
    t35 = np.where(t20 != 0.0, np.where(t20 != 0.0, t21 * (t23 * t32 + t22 * t33), 0.0), 0.0) - np.where(t20 != 0.0, np.where(t20 != 0.0, t22 * (t32 * (t8 * t34)), 0.0), 0.0)
    t36 = t35 - np.where(t20 != 0.0, np.where(t20 != 0.0, t22 * (t32 * (l2 * (t27 + t27))), 0.0), 0.0)
    t37 = t30 + np.where((1.0 - t30) != 0.0, 1.0 - np.where(t36 != 0.0, 1.0, 0.0), 0.0)
    t38 = (np.where(t20 != 0.0, t13 * t23, 0.0) - np.where(t20 != 0.0, t5 * t22, 0.0)) / t20
    t39 = np.where(t20 != 0.0, t38, 0.0)
    t40 = t32 * t32
    t41 = np.where(t20 != 0.0, np.where(t20 != 0.0, t33 * (t21 * t32), 0.0), 0.0) - np.where(t20 != 0.0, np.where(t20 != 0.0, t24 * t40, 0.0), 0.0)
    t42 = t41 - np.where(t20 != 0.0, np.where(t20 != 0.0, t28 * t40, 0.0), 0.0)
    t43 = t42 - kappa
    t44 = t36 * t36 - t29 * (4.0 * t43)
    t45 = np.sqrt(np.maximum(0.0, t44))
    t46 = -0.5 * t36 - 0.5 * np.copysign(t45, t36)
    t47 = t46 / t29
    t48 = np.where(t20 != 0.0, t32, 0.0)
    t49 = t48 + np.where(t29 != 0.0, np.where(t20 != 0.0, t22 * t47, 0.0), 0.0)
    t50 = np.where(t20 != 0.0, t33, 0.0)
    t51 = t50 + np.where(t29 != 0.0, np.where(t20 != 0.0, t23 * t47, 0.0), 0.0)
    t52 = np.where(t45 != 0.0, 1.0, 0.0)
    t53 = 1.0 - t52
    t54 = t52 + np.where(t53 != 0.0, t37, 0.0)
    t55 = np.where(t52 != 0.0, np.where(t46 != 0.0, t43 / t46, 0.0), 0.0) + np.where(t53 != 0.0, np.where(t29 != 0.0, t47, 0.0), 0.0)
    t56 = t32 + t22 * t55
    t57 = t33 + t23 * t55
    t58 = t49 * t49
    t59 = np.where(t37 != 0.0, np.where(t37 != 0.0, t51 * (t21 * t49), 0.0), 0.0) - np.where(t37 != 0.0, np.where(t37 != 0.0, t24 * t58, 0.0), 0.0)
    t60 = t59 - np.where(t37 != 0.0, np.where(t37 != 0.0, t28 * t58, 0.0), 0.0)
    t61 = t56 * t56
    t62 = np.where(t54 != 0.0, np.where(t20 != 0.0, np.where(t54 != 0.0, np.where(t20 != 0.0, t57 * (t21 * t56), 0.0), 0.0), 0.0), 0.0) - np.where(t54 != 0.0, np.where(t20 != 0.0, np.where(t54 != 0.0, np.where(t20 != 0.0, t24 * t61, 0.0), 0.0), 0.0), 0.0)
    t63 = t62 - np.where(t54 != 0.0, np.where(t20 != 0.0, np.where(t54 != 0.0, np.where(t20 != 0.0, t28 * t61, 0.0), 0.0), 0.0), 0.0)
    t64 = t8 * t14
    t65 = l2 * (t2 * tx + t1 * ty)
    t66 = -3.0 * t60 * (t58 * t64 + t58 * t65 + t51 * (t34 * t49))
    t67 = t49 * t58
    t68 = 3.0 * t5
    t69 = t66 + np.where(t37 != 0.0, t64 * t67, 0.0) + np.where(t37 != 0.0, t65 * t67, 0.0) + np.where(t37 != 0.0, t58 * (t51 * t68), 0.0)
    t70 = -3.0 * t63 * (t61 * t64 + t61 * t65 + t57 * (t34 * t56))
    t71 = t56 * t61
    t72 = t70 + np.where(t54 != 0.0, np.where(t20 != 0.0, t64 * t71, 0.0), 0.0) + np.where(t54 != 0.0, np.where(t20 != 0.0, t65 * t71, 0.0), 0.0)
    t73 = np.where(t54 != 0.0, np.where(t20 != 0.0, t72 + np.where(t54 != 0.0, np.where(t20 != 0.0, t61 * (t57 * t68), 0.0), 0.0), 0.0), 0.0)

    # results
    rates = np.empty((*leading, 6), real)
    tracked = np.empty((*leading, 2), real)
    tracked_rate = np.empty((*leading, 2), real)
    parabola = np.empty((*leading, 3), real)
    discriminant = np.empty((*leading, 1), real)
    least = np.empty((*leading, 3), real)
    null = np.empty((*leading, 3), real)
    rates[..., 0] = np.where(t37 != 0.0, t39 + np.where(t29 != 0.0, np.where(t20 != 0.0, t31 * t47, 0.0), 0.0), 0.0)
    rates[..., 1] = np.where(t37 != 0.0, t49, 0.0)
    rates[..., 2] = np.where(t37 != 0.0, t51, 0.0)
    rates[..., 3] = np.where(t54 != 0.0, np.where(t20 != 0.0, t38 + t31 * t55, 0.0), 0.0)
    rates[..., 4] = np.where(t54 != 0.0, np.where(t20 != 0.0, t56, 0.0), 0.0)
    rates[..., 5] = np.where(t54 != 0.0, np.where(t20 != 0.0, t57, 0.0), 0.0)
    tracked[..., 0] = t60
    tracked[..., 1] = t63
    tracked_rate[..., 0] = -np.where(t37 != 0.0, np.where(t37 != 0.0, t69, 0.0), 0.0)
    tracked_rate[..., 1] = -np.where(t54 != 0.0, np.where(t20 != 0.0, t73, 0.0), 0.0)
    parabola[..., 0] = t29
    parabola[..., 1] = t36
    parabola[..., 2] = t42
    discriminant[..., 0] = t44
    least[..., 0] = t39
    least[..., 1] = t48
    least[..., 2] = t50
    null[..., 0] = np.where(t20 != 0.0, t31, 0.0)
    null[..., 1] = np.where(t20 != 0.0, t22, 0.0)
    null[..., 2] = np.where(t20 != 0.0, t23, 0.0)
    return rates.reshape(leading + (2, 3)), tracked.reshape(leading + (2,)), tracked_rate.reshape(leading + (2,)), parabola.reshape(leading + (3,)), discriminant.reshape(leading), least.reshape(leading + (3,)), null.reshape(leading + (3,))
