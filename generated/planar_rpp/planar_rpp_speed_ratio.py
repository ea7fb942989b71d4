"""speed ratio of planar_rpp, in NumPy.

Made from templates/kernel.py.j2; inputs 37a9d34c3513d50104afd9ba3daf43879d34843c4ba606f40b9de0de367ab58a.
722 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 122 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
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
    q1 = q[..., 0]
    c1 = np.cos(q1)
    heading2 = parameters[..., 3]
    sin_heading2 = np.sin(heading2)
    cos_heading2 = np.cos(heading2)
    s1 = np.sin(q1)
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * sin_heading2 + cos_heading2 * s1
    t2 = c1 * cos_heading2 - sin_heading2 * s1
    t3 = t1 * tx - t2 * ty
    t4 = t1 * cos_heading3 + t2 * sin_heading3
    t5 = t2 * cos_heading3 - t1 * sin_heading3
    t6 = tx * t4 - ty * t5
    t7 = -t6
    t8 = l2 + q2
    t9 = l3 + q3
    t10 = c1 * l1 + t2 * t8 + t5 * t9
    t11 = s1 * l1 + t1 * t8 + t4 * t9
    t12 = tx * t10 + ty * t11
    t13 = tx * t2 + t1 * ty
    t14 = t3 * t3 + t13 * t13
    t15 = tx * t5 + ty * t4
    t16 = t6 * t6 + t15 * t15
    t17 = t6 * (t3 + t3) + t15 * (t13 + t13)
    t18 = -2.0 * t13
    t19 = t12 + t12
    t20 = ty * t10 - tx * t11
    t21 = t20 + t20
    t22 = t3 * t19 + t13 * t21
    t23 = -2.0 * t15
    t24 = t6 * t19 + t15 * t21
    t25 = t3 * t8 + t6 * t9 + l1 * (s1 * tx - c1 * ty)
    t26 = t12 * t12 + t20 * t20
    t27 = t3 / t6
    t28 = t13 + np.where(t7 != 0.0, -(t15 * t27), 0.0)
    t29 = t28 * t28
    t30 = t12 / t6
    t31 = t20 + np.where(t7 != 0.0, -(t15 * t30), 0.0)
    t32 = (t28 + t28) * t31
    t33 = t18 + np.where(t7 != 0.0, -(t23 * t27), 0.0)
    t34 = t25 + np.where(t7 != 0.0, -(t23 * t30), 0.0)
    t35 = t33 * (t32 + t32) - t34 * (4.0 * t29)
    t36 = t33 * t33

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
    A[..., 0] = -t3
    A[..., 1] = t7
    A[..., 2] = -t12
    B[..., 0] = t14 * kappa
    B[..., 1] = kappa * t16
    B[..., 2] = kappa * t17
    B[..., 3] = t18 + kappa * t22
    B[..., 4] = t23 + kappa * t24
    B[..., 5] = t25 + kappa * t26
    B0[..., 0] = 0.0
    B0[..., 1] = 0.0
    B0[..., 2] = 0.0
    B0[..., 3] = t18
    B0[..., 4] = t23
    B0[..., 5] = t25
    B1[..., 0] = t14
    B1[..., 1] = t16
    B1[..., 2] = t17
    B1[..., 3] = t22
    B1[..., 4] = t24
    B1[..., 5] = t26
    a[..., 0] = t29
    a[..., 1] = t32
    a[..., 2] = t31 * t31
    b[..., 0] = 0.0
    b[..., 1] = t33
    b[..., 2] = t34
    C[..., 0] = t35
    D[..., 0] = t36
    discriminant[..., 0] = t36 + kappa * t35
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 122 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
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
    tx = tangent[..., 0]
    q1 = q[..., 0]
    c1 = np.cos(q1)
    l1 = parameters[..., 0]
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    s1 = np.sin(q1)
    sin_heading2 = np.sin(heading2)
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = l2 + q2
    t3 = c1 * sin_heading2 + cos_heading2 * s1
    t4 = t1 * cos_heading3 - t3 * sin_heading3
    t5 = l3 + q3
    t6 = c1 * l1 + t1 * t2 + t4 * t5
    t7 = cos_heading3 * t3 + t1 * sin_heading3
    t8 = l1 * s1 + t2 * t3 + t5 * t7
    t9 = tx * t6 + ty * t8
    t10 = tx * t7 - t4 * ty
    t11 = -t10
    t12 = tx * t3 - t1 * ty
    t13 = t2 * t12 + t5 * t10 + l1 * (tx * s1 - c1 * ty)
    t14 = t6 * ty - tx * t8
    t15 = t9 * t9 + t14 * t14
    t16 = tx * t4 + ty * t7
    t17 = t10 * t10 + t16 * t16
    t18 = -2.0 * t16
    t19 = t9 + t9
    t20 = t14 + t14
    t21 = t10 * t19 + t16 * t20
    t22 = tx * t1 + t3 * ty
    t23 = -2.0 * t22
    t24 = t12 * t19 + t20 * t22
    t25 = t10 * (t12 + t12) + t16 * (t22 + t22)
    t26 = t12 * t12 + t22 * t22
    t27 = t9 / t10
    t28 = t14 + np.where(t11 != 0.0, -(t16 * t27), 0.0)
    t29 = t12 / t10
    t30 = t22 + np.where(t11 != 0.0, -(t16 * t29), 0.0)
    t31 = (t28 + t28) * t30
    t32 = t30 * t30
    t33 = t13 + np.where(t11 != 0.0, -(t18 * t27), 0.0)
    t34 = t23 + np.where(t11 != 0.0, -(t18 * t29), 0.0)
    t35 = t34 * (t31 + t31) - t33 * (4.0 * t32)
    t36 = t34 * t34

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
    A[..., 0] = -t9
    A[..., 1] = t11
    A[..., 2] = -t12
    B[..., 0] = t13 + t15 * kappa
    B[..., 1] = kappa * t17
    B[..., 2] = t18 + kappa * t21
    B[..., 3] = t23 + kappa * t24
    B[..., 4] = kappa * t25
    B[..., 5] = kappa * t26
    B0[..., 0] = t13
    B0[..., 1] = 0.0
    B0[..., 2] = t18
    B0[..., 3] = t23
    B0[..., 4] = 0.0
    B0[..., 5] = 0.0
    B1[..., 0] = t15
    B1[..., 1] = t17
    B1[..., 2] = t21
    B1[..., 3] = t24
    B1[..., 4] = t25
    B1[..., 5] = t26
    a[..., 0] = t28 * t28
    a[..., 1] = t31
    a[..., 2] = t32
    b[..., 0] = t33
    b[..., 1] = t34
    b[..., 2] = 0.0
    C[..., 0] = t35
    D[..., 0] = t36
    discriminant[..., 0] = t36 + kappa * t35
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 122 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
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
    tx = tangent[..., 0]
    q1 = q[..., 0]
    c1 = np.cos(q1)
    l1 = parameters[..., 0]
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    s1 = np.sin(q1)
    sin_heading2 = np.sin(heading2)
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = l2 + q2
    t3 = c1 * sin_heading2 + cos_heading2 * s1
    t4 = t1 * cos_heading3 - t3 * sin_heading3
    t5 = l3 + q3
    t6 = c1 * l1 + t1 * t2 + t4 * t5
    t7 = cos_heading3 * t3 + t1 * sin_heading3
    t8 = l1 * s1 + t2 * t3 + t5 * t7
    t9 = tx * t6 + ty * t8
    t10 = tx * t3 - t1 * ty
    t11 = -t10
    t12 = tx * t7 - t4 * ty
    t13 = t2 * t10 + t5 * t12 + l1 * (tx * s1 - c1 * ty)
    t14 = t6 * ty - tx * t8
    t15 = t9 * t9 + t14 * t14
    t16 = tx * t1 + t3 * ty
    t17 = t10 * t10 + t16 * t16
    t18 = -2.0 * t16
    t19 = t9 + t9
    t20 = t14 + t14
    t21 = t10 * t19 + t16 * t20
    t22 = tx * t4 + ty * t7
    t23 = -2.0 * t22
    t24 = t12 * t19 + t20 * t22
    t25 = t12 * (t10 + t10) + t22 * (t16 + t16)
    t26 = t12 * t12 + t22 * t22
    t27 = t9 / t10
    t28 = t14 + np.where(t11 != 0.0, -(t16 * t27), 0.0)
    t29 = t12 / t10
    t30 = t22 + np.where(t11 != 0.0, -(t16 * t29), 0.0)
    t31 = (t28 + t28) * t30
    t32 = t30 * t30
    t33 = t13 + np.where(t11 != 0.0, -(t18 * t27), 0.0)
    t34 = t23 + np.where(t11 != 0.0, -(t18 * t29), 0.0)
    t35 = t34 * (t31 + t31) - t33 * (4.0 * t32)
    t36 = t34 * t34

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
    A[..., 0] = -t9
    A[..., 1] = t11
    A[..., 2] = -t12
    B[..., 0] = t13 + t15 * kappa
    B[..., 1] = kappa * t17
    B[..., 2] = t18 + kappa * t21
    B[..., 3] = t23 + kappa * t24
    B[..., 4] = kappa * t25
    B[..., 5] = kappa * t26
    B0[..., 0] = t13
    B0[..., 1] = 0.0
    B0[..., 2] = t18
    B0[..., 3] = t23
    B0[..., 4] = 0.0
    B0[..., 5] = 0.0
    B1[..., 0] = t15
    B1[..., 1] = t17
    B1[..., 2] = t21
    B1[..., 3] = t24
    B1[..., 4] = t25
    B1[..., 5] = t26
    a[..., 0] = t28 * t28
    a[..., 1] = t31
    a[..., 2] = t32
    b[..., 0] = t33
    b[..., 1] = t34
    b[..., 2] = 0.0
    C[..., 0] = t35
    D[..., 0] = t36
    discriminant[..., 0] = t36 + kappa * t35
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_rates(q, parameters, tangent, curvature):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 356 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
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
    q1 = q[..., 0]
    c1 = np.cos(q1)
    heading2 = parameters[..., 3]
    sin_heading2 = np.sin(heading2)
    cos_heading2 = np.cos(heading2)
    s1 = np.sin(q1)
    sin_heading3 = np.sin(heading3)
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * sin_heading2 + cos_heading2 * s1
    t2 = c1 * cos_heading2 - sin_heading2 * s1
    t3 = cos_heading3 * t1 + t2 * sin_heading3
    t4 = cos_heading3 * t2 - t1 * sin_heading3
    t5 = t3 * tx - t4 * ty
    t6 = t2 * tx + t1 * ty
    t7 = t1 * tx - t2 * ty
    t8 = tx * t4 + t3 * ty
    t9 = t5 * t6 - t7 * t8
    t10 = l2 + q2
    t11 = l3 + q3
    t12 = c1 * l1 + t2 * t10 + t4 * t11
    t13 = s1 * l1 + t1 * t10 + t3 * t11
    t14 = tx * t12 + ty * t13
    t15 = ty * t12 - tx * t13
    t16 = t8 * t14 - t5 * t15
    t17 = t7 * t15 - t6 * t14
    t18 = np.sqrt((t9 * t9 + t16 * t16 + t17 * t17))
    t19 = t6 + t6
    t20 = t9 / t18
    t21 = t16 / t18
    t22 = t8 + t8
    t23 = t17 / t18
    t24 = np.where(t18 != 0.0, np.where(t18 != 0.0, t19 * t20 * t21 + t20 * t22 * t23, 0.0), 0.0)
    t25 = t7 * t10
    t26 = t20 * t20
    t27 = t5 * t11
    t28 = t24 - np.where(t18 != 0.0, np.where(t18 != 0.0, t25 * t26, 0.0), 0.0) - np.where(t18 != 0.0, np.where(t18 != 0.0, t26 * t27, 0.0), 0.0)
    t29 = s1 * tx - c1 * ty
    t30 = l1 * t29
    t31 = t28 - np.where(t18 != 0.0, np.where(t18 != 0.0, t26 * t30, 0.0), 0.0)
    t32 = np.where(t31 != 0.0, 1.0, 0.0)
    t33 = (np.where(t18 != 0.0, t7 * t23, 0.0) - np.where(t18 != 0.0, t5 * t21, 0.0)) / t18
    t34 = (np.where(t18 != 0.0, t5 * t20, 0.0) - np.where(t18 != 0.0, t14 * t23, 0.0)) / t18
    t35 = (np.where(t18 != 0.0, t14 * t21, 0.0) - np.where(t18 != 0.0, t7 * t20, 0.0)) / t18
    t36 = t19 * (t21 * t33 + t20 * t34) + t22 * (t23 * t33 + t20 * t35)
    t37 = t7 + t7
    t38 = np.where(t18 != 0.0, np.where(t18 != 0.0, t36, 0.0), 0.0) - np.where(t18 != 0.0, np.where(t18 != 0.0, t20 * (t33 * (t10 * t37)), 0.0), 0.0)
    t39 = t5 + t5
    t40 = t38 - np.where(t18 != 0.0, np.where(t18 != 0.0, t20 * (t33 * (t11 * t39)), 0.0), 0.0) - np.where(t18 != 0.0, np.where(t18 != 0.0, t20 * (t33 * (l1 * (t29 + t29))), 0.0), 0.0)
    t41 = t32 + np.where((1.0 - t32) != 0.0, 1.0 - np.where(t40 != 0.0, 1.0, 0.0), 0.0)
    t42 = np.where(t18 != 0.0, t33, 0.0)
    t43 = np.where(t18 != 0.0, np.where(t18 != 0.0, t34 * (t19 * t33) + t35 * (t22 * t33), 0.0), 0.0)
    t44 = t33 * t33
    t45 = t43 - np.where(t18 != 0.0, np.where(t18 != 0.0, t25 * t44, 0.0), 0.0) - np.where(t18 != 0.0, np.where(t18 != 0.0, t27 * t44, 0.0), 0.0)
    t46 = t45 - np.where(t18 != 0.0, np.where(t18 != 0.0, t30 * t44, 0.0), 0.0)
    t47 = t46 - kappa
    t48 = t40 * t40 - t31 * (4.0 * t47)
    t49 = np.sqrt(np.maximum(0.0, t48))
    t50 = -0.5 * t40 - 0.5 * np.copysign(t49, t40)
    t51 = t50 / t31
    t52 = t42 + np.where(t31 != 0.0, np.where(t18 != 0.0, t20 * t51, 0.0), 0.0)
    t53 = np.where(t18 != 0.0, t34, 0.0)
    t54 = t53 + np.where(t31 != 0.0, np.where(t18 != 0.0, t21 * t51, 0.0), 0.0)
    t55 = np.where(t18 != 0.0, t35, 0.0)
    t56 = t55 + np.where(t31 != 0.0, np.where(t18 != 0.0, t23 * t51, 0.0), 0.0)
    t57 = np.where(t49 != 0.0, 1.0, 0.0)
    t58 = 1.0 - t57
    t59 = t57 + np.where(t58 != 0.0, t41, 0.0)
    t60 = np.where(t57 != 0.0, np.where(t50 != 0.0, t47 / t50, 0.0), 0.0) + np.where(t58 != 0.0, np.where(t31 != 0.0, t51, 0.0), 0.0)
    t61 = t33 + t20 * t60
    t62 = t34 + t21 * t60
    t63 = t35 + t23 * t60
    t64 = np.where(t41 != 0.0, np.where(t41 != 0.0, t54 * (t19 * t52) + t56 * (t22 * t52), 0.0), 0.0)
    t65 = t52 * t52
    t66 = t64 - np.where(t41 != 0.0, np.where(t41 != 0.0, t25 * t65, 0.0), 0.0) - np.where(t41 != 0.0, np.where(t41 != 0.0, t27 * t65, 0.0), 0.0)
    t67 = t66 - np.where(t41 != 0.0, np.where(t41 != 0.0, t30 * t65, 0.0), 0.0)
    t68 = np.where(t59 != 0.0, np.where(t18 != 0.0, t62 * (t19 * t61) + t63 * (t22 * t61), 0.0), 0.0)
    t69 = t61 * t61
    t70 = np.where(t59 != 0.0, np.where(t18 != 0.0, t68, 0.0), 0.0) - np.where(t59 != 0.0, np.where(t18 != 0.0, np.where(t59 != 0.0, np.where(t18 != 0.0, t25 * t69, 0.0), 0.0), 0.0), 0.0)
    t71 = t70 - np.where(t59 != 0.0, np.where(t18 != 0.0, np.where(t59 != 0.0, np.where(t18 != 0.0, t27 * t69, 0.0), 0.0), 0.0), 0.0) - np.where(t59 != 0.0, np.where(t18 != 0.0, np.where(t59 != 0.0, np.where(t18 != 0.0, t30 * t69, 0.0), 0.0), 0.0), 0.0)
    t72 = t6 * t10
    t73 = t8 * t11
    t74 = l1 * (c1 * tx + s1 * ty)
    t75 = t65 * t72 + t65 * t73 + t65 * t74 + t54 * (t37 * t52)
    t76 = t52 * t65
    t77 = -3.0 * t67 * (t75 + t56 * (t39 * t52)) + np.where(t41 != 0.0, t72 * t76, 0.0)
    t78 = 3.0 * t7
    t79 = t77 + np.where(t41 != 0.0, t73 * t76, 0.0) + np.where(t41 != 0.0, t74 * t76, 0.0) + np.where(t41 != 0.0, t65 * (t54 * t78), 0.0)
    t80 = 3.0 * t5
    t81 = -np.where(t41 != 0.0, np.where(t41 != 0.0, t79 + np.where(t41 != 0.0, t65 * (t56 * t80), 0.0), 0.0), 0.0)
    t82 = t69 * t72 + t69 * t73 + t69 * t74 + t62 * (t37 * t61)
    t83 = t61 * t69
    t84 = -3.0 * t71 * (t82 + t63 * (t39 * t61)) + np.where(t59 != 0.0, np.where(t18 != 0.0, t72 * t83, 0.0), 0.0)
    t85 = t84 + np.where(t59 != 0.0, np.where(t18 != 0.0, t73 * t83, 0.0), 0.0) + np.where(t59 != 0.0, np.where(t18 != 0.0, t74 * t83, 0.0), 0.0)
    t86 = t85 + np.where(t59 != 0.0, np.where(t18 != 0.0, t69 * (t62 * t78), 0.0), 0.0) + np.where(t59 != 0.0, np.where(t18 != 0.0, t69 * (t63 * t80), 0.0), 0.0)

    # results
    rates = np.empty((*leading, 6), real)
    tracked = np.empty((*leading, 2), real)
    tracked_rate = np.empty((*leading, 2), real)
    parabola = np.empty((*leading, 3), real)
    discriminant = np.empty((*leading, 1), real)
    least = np.empty((*leading, 3), real)
    null = np.empty((*leading, 3), real)
    rates[..., 0] = np.where(t41 != 0.0, t52, 0.0)
    rates[..., 1] = np.where(t41 != 0.0, t54, 0.0)
    rates[..., 2] = np.where(t41 != 0.0, t56, 0.0)
    rates[..., 3] = np.where(t59 != 0.0, np.where(t18 != 0.0, t61, 0.0), 0.0)
    rates[..., 4] = np.where(t59 != 0.0, np.where(t18 != 0.0, t62, 0.0), 0.0)
    rates[..., 5] = np.where(t59 != 0.0, np.where(t18 != 0.0, t63, 0.0), 0.0)
    tracked[..., 0] = t67
    tracked[..., 1] = t71
    tracked_rate[..., 0] = t81
    tracked_rate[..., 1] = -np.where(t59 != 0.0, np.where(t18 != 0.0, np.where(t59 != 0.0, np.where(t18 != 0.0, t86, 0.0), 0.0), 0.0), 0.0)
    parabola[..., 0] = t31
    parabola[..., 1] = t40
    parabola[..., 2] = t46
    discriminant[..., 0] = t48
    least[..., 0] = t42
    least[..., 1] = t53
    least[..., 2] = t55
    null[..., 0] = np.where(t18 != 0.0, t20, 0.0)
    null[..., 1] = np.where(t18 != 0.0, t21, 0.0)
    null[..., 2] = np.where(t18 != 0.0, t23, 0.0)
    return rates.reshape(leading + (2, 3)), tracked.reshape(leading + (2,)), tracked_rate.reshape(leading + (2,)), parabola.reshape(leading + (3,)), discriminant.reshape(leading), least.reshape(leading + (3,)), null.reshape(leading + (3,))
