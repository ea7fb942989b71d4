"""speed ratio of planar_ppr, in NumPy.

Made from templates/kernel.py.j2; inputs 883b0d10b24e51ade779c493fe6fdfbd084630363fb9348b4604ad8f596d9455.
553 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 121 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
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
    heading2 = parameters[..., 4]
    sin_heading2 = np.sin(heading2)
    cos_heading2 = np.cos(heading2)
    sin_heading1 = np.sin(heading1)
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    kappa = curvature[..., 0]

    # terms
    t1 = cos_heading1 * sin_heading2 + cos_heading2 * sin_heading1
    t2 = cos_heading1 * cos_heading2 - sin_heading2 * sin_heading1
    t3 = t1 * tx - t2 * ty
    t4 = t2 * c3 - t1 * s3
    t5 = t4 * l3
    t6 = t1 * c3 + t2 * s3
    t7 = l3 * t6
    t8 = tx * t5 + ty * t7
    t9 = -t8
    t10 = sin_heading1 * tx - cos_heading1 * ty
    t11 = tx * t2 + t1 * ty
    t12 = t3 * t3 + t11 * t11
    t13 = l3 * (tx * t6 - ty * t4)
    t14 = ty * t5 - tx * t7
    t15 = t8 * t8 + t14 * t14
    t16 = t8 * (t3 + t3) + t14 * (t11 + t11)
    t17 = t10 + t10
    t18 = cos_heading1 * tx + sin_heading1 * ty
    t19 = t18 + t18
    t20 = t3 * t17 + t11 * t19
    t21 = t8 * t17 + t14 * t19
    t22 = t10 * t10 + t18 * t18
    t23 = t3 / t8
    t24 = t11 + np.where(t9 != 0.0, -(t14 * t23), 0.0)
    t25 = t24 * t24
    t26 = t10 / t8
    t27 = t18 + np.where(t9 != 0.0, -(t14 * t26), 0.0)
    t28 = (t24 + t24) * t27
    t29 = t27 * t27
    t30 = np.where(t9 != 0.0, -t23, 0.0)
    t31 = t13 * (t30 * t30)
    t32 = t23 * (t26 * (t13 + t13))
    t33 = np.where(t9 != 0.0, np.where(t9 != 0.0, -t32, 0.0), 0.0)
    t34 = np.where(t9 != 0.0, -t26, 0.0)
    t35 = t13 * (t34 * t34)
    t36 = np.where(t9 != 0.0, np.where(t9 != 0.0, -(t32 * (t28 + t28)), 0.0), 0.0) + t35 * (4.0 * t25)
    t37 = t36 + t31 * (4.0 * t29)
    t38 = t33 * t33 - t35 * (4.0 * t31)

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
    A[..., 1] = t9
    A[..., 2] = -t10
    B[..., 0] = t12 * kappa
    B[..., 1] = t13 + kappa * t15
    B[..., 2] = kappa * t16
    B[..., 3] = kappa * t20
    B[..., 4] = kappa * t21
    B[..., 5] = kappa * t22
    B0[..., 0] = 0.0
    B0[..., 1] = t13
    B0[..., 2] = 0.0
    B0[..., 3] = 0.0
    B0[..., 4] = 0.0
    B0[..., 5] = 0.0
    B1[..., 0] = t12
    B1[..., 1] = t15
    B1[..., 2] = t16
    B1[..., 3] = t20
    B1[..., 4] = t21
    B1[..., 5] = t22
    a[..., 0] = t25
    a[..., 1] = t28
    a[..., 2] = t29
    b[..., 0] = t31
    b[..., 1] = -t33
    b[..., 2] = t35
    C[..., 0] = -t37
    D[..., 0] = t38
    discriminant[..., 0] = t38 - kappa * t37
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 121 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    heading2 = parameters[..., 4]
    cos_heading2 = np.cos(heading2)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    kappa = curvature[..., 0]

    # terms
    t1 = sin_heading1 * tx - cos_heading1 * ty
    t2 = cos_heading1 * cos_heading2 - sin_heading1 * sin_heading2
    t3 = cos_heading1 * sin_heading2 + sin_heading1 * cos_heading2
    t4 = c3 * t2 - t3 * s3
    t5 = t4 * l3
    t6 = c3 * t3 + t2 * s3
    t7 = l3 * t6
    t8 = tx * t5 + ty * t7
    t9 = -t8
    t10 = tx * t3 - ty * t2
    t11 = tx * cos_heading1 + sin_heading1 * ty
    t12 = t1 * t1 + t11 * t11
    t13 = l3 * (tx * t6 - ty * t4)
    t14 = ty * t5 - tx * t7
    t15 = t8 * t8 + t14 * t14
    t16 = t1 + t1
    t17 = t11 + t11
    t18 = t8 * t16 + t14 * t17
    t19 = tx * t2 + ty * t3
    t20 = t10 * t16 + t17 * t19
    t21 = t8 * (t10 + t10) + t14 * (t19 + t19)
    t22 = t10 * t10 + t19 * t19
    t23 = t1 / t8
    t24 = t11 + np.where(t9 != 0.0, -(t14 * t23), 0.0)
    t25 = t24 * t24
    t26 = t10 / t8
    t27 = t19 + np.where(t9 != 0.0, -(t14 * t26), 0.0)
    t28 = (t24 + t24) * t27
    t29 = t27 * t27
    t30 = np.where(t9 != 0.0, -t23, 0.0)
    t31 = t13 * (t30 * t30)
    t32 = t23 * (t26 * (t13 + t13))
    t33 = np.where(t9 != 0.0, np.where(t9 != 0.0, -t32, 0.0), 0.0)
    t34 = np.where(t9 != 0.0, -t26, 0.0)
    t35 = t13 * (t34 * t34)
    t36 = np.where(t9 != 0.0, np.where(t9 != 0.0, -(t32 * (t28 + t28)), 0.0), 0.0) + t35 * (4.0 * t25)
    t37 = t36 + t31 * (4.0 * t29)
    t38 = t33 * t33 - t35 * (4.0 * t31)

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
    A[..., 1] = t9
    A[..., 2] = -t10
    B[..., 0] = t12 * kappa
    B[..., 1] = t13 + kappa * t15
    B[..., 2] = kappa * t18
    B[..., 3] = kappa * t20
    B[..., 4] = kappa * t21
    B[..., 5] = kappa * t22
    B0[..., 0] = 0.0
    B0[..., 1] = t13
    B0[..., 2] = 0.0
    B0[..., 3] = 0.0
    B0[..., 4] = 0.0
    B0[..., 5] = 0.0
    B1[..., 0] = t12
    B1[..., 1] = t15
    B1[..., 2] = t18
    B1[..., 3] = t20
    B1[..., 4] = t21
    B1[..., 5] = t22
    a[..., 0] = t25
    a[..., 1] = t28
    a[..., 2] = t29
    b[..., 0] = t31
    b[..., 1] = -t33
    b[..., 2] = t35
    C[..., 0] = -t37
    D[..., 0] = t38
    discriminant[..., 0] = t38 - kappa * t37
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 91 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
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
    heading2 = parameters[..., 4]
    sin_heading2 = np.sin(heading2)
    cos_heading2 = np.cos(heading2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    kappa = curvature[..., 0]

    # terms
    t1 = sin_heading1 * tx - cos_heading1 * ty
    t2 = cos_heading1 * sin_heading2 + sin_heading1 * cos_heading2
    t3 = cos_heading1 * cos_heading2 - sin_heading1 * sin_heading2
    t4 = tx * t2 - ty * t3
    t5 = -t4
    t6 = t3 * c3 - t2 * s3
    t7 = t6 * l3
    t8 = t2 * c3 + t3 * s3
    t9 = l3 * t8
    t10 = tx * t7 + ty * t9
    t11 = tx * cos_heading1 + sin_heading1 * ty
    t12 = t1 * t1 + t11 * t11
    t13 = tx * t3 + ty * t2
    t14 = t4 * t4 + t13 * t13
    t15 = t1 + t1
    t16 = t11 + t11
    t17 = t4 * t15 + t13 * t16
    t18 = ty * t7 - tx * t9
    t19 = t10 * t15 + t16 * t18
    t20 = t10 * (t4 + t4) + t18 * (t13 + t13)
    t21 = l3 * (tx * t8 - ty * t6)
    t22 = t10 * t10 + t18 * t18
    t23 = t11 + np.where(t5 != 0.0, -(t13 * (t1 / t4)), 0.0)
    t24 = t23 * t23
    t25 = t18 + np.where(t5 != 0.0, -(t13 * (t10 / t4)), 0.0)
    t26 = t24 * (-4.0 * t21)

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
    A[..., 1] = t5
    A[..., 2] = -t10
    B[..., 0] = t12 * kappa
    B[..., 1] = kappa * t14
    B[..., 2] = kappa * t17
    B[..., 3] = kappa * t19
    B[..., 4] = kappa * t20
    B[..., 5] = t21 + kappa * t22
    B0[..., 0] = 0.0
    B0[..., 1] = 0.0
    B0[..., 2] = 0.0
    B0[..., 3] = 0.0
    B0[..., 4] = 0.0
    B0[..., 5] = t21
    B1[..., 0] = t12
    B1[..., 1] = t14
    B1[..., 2] = t17
    B1[..., 3] = t19
    B1[..., 4] = t20
    B1[..., 5] = t22
    a[..., 0] = t24
    a[..., 1] = (t23 + t23) * t25
    a[..., 2] = t25 * t25
    b[..., 0] = 0.0
    b[..., 1] = 0.0
    b[..., 2] = t21
    C[..., 0] = t26
    D[..., 0] = 0.0
    discriminant[..., 0] = kappa * t26
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_rates(q, parameters, tangent, curvature):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 220 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    heading2 = parameters[..., 4]
    cos_heading2 = np.cos(heading2)
    sin_heading1 = np.sin(heading1)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = cos_heading1 * cos_heading2 - sin_heading1 * sin_heading2
    t2 = cos_heading1 * sin_heading2 + cos_heading2 * sin_heading1
    t3 = c3 * t1 - t2 * s3
    t4 = t3 * l3
    t5 = c3 * t2 + t1 * s3
    t6 = l3 * t5
    t7 = t4 * tx + t6 * ty
    t8 = t1 * tx + t2 * ty
    t9 = t2 * tx - t1 * ty
    t10 = t4 * ty - tx * t6
    t11 = t7 * t8 - t9 * t10
    t12 = sin_heading1 * tx - cos_heading1 * ty
    t13 = cos_heading1 * tx + sin_heading1 * ty
    t14 = t10 * t12 - t7 * t13
    t15 = t9 * t13 - t8 * t12
    t16 = np.sqrt((t11 * t11 + t14 * t14 + t15 * t15))
    t17 = tx * t5 - t3 * ty
    t18 = l3 * t17
    t19 = t15 / t16
    t20 = t18 * (t19 * t19)
    t21 = np.where(t16 != 0.0, np.where(t16 != 0.0, t20, 0.0), 0.0)
    t22 = -t21
    t23 = np.where(t22 != 0.0, 1.0, 0.0)
    t24 = t14 / t16
    t25 = t11 / t16
    t26 = (np.where(t16 != 0.0, t12 * t24, 0.0) - np.where(t16 != 0.0, t9 * t25, 0.0)) / t16
    t27 = t19 * (l3 * (-2.0 * t17) * t26)
    t28 = np.where(t16 != 0.0, np.where(t16 != 0.0, t27, 0.0), 0.0)
    t29 = t23 + np.where((1.0 - t23) != 0.0, 1.0 - np.where(t28 != 0.0, 1.0, 0.0), 0.0)
    t30 = (np.where(t16 != 0.0, t9 * t19, 0.0) - np.where(t16 != 0.0, t7 * t24, 0.0)) / t16
    t31 = np.where(t16 != 0.0, t30, 0.0)
    t32 = np.where(t16 != 0.0, np.where(t16 != 0.0, t18 * (t26 * t26), 0.0), 0.0)
    t33 = t32 + kappa
    t34 = np.where(t16 != 0.0, np.where(t16 != 0.0, np.where(t16 != 0.0, np.where(t16 != 0.0, t27 * t27, 0.0), 0.0), 0.0), 0.0) - np.where(t16 != 0.0, np.where(t16 != 0.0, t20 * (4.0 * t33), 0.0), 0.0)
    t35 = np.sqrt(np.maximum(0.0, t34))
    t36 = np.where(t16 != 0.0, np.where(t16 != 0.0, -0.5 * t27, 0.0), 0.0) - 0.5 * np.copysign(t35, t28)
    t37 = t36 / t21
    t38 = (np.where(t16 != 0.0, t7 * t25, 0.0) - np.where(t16 != 0.0, t12 * t19, 0.0)) / t16
    t39 = np.where(t16 != 0.0, t38, 0.0)
    t40 = np.where(t16 != 0.0, t26, 0.0)
    t41 = t40 + np.where(t22 != 0.0, np.where(t16 != 0.0, -(t19 * t37), 0.0), 0.0)
    t42 = np.where(t35 != 0.0, 1.0, 0.0)
    t43 = 1.0 - t42
    t44 = t42 + np.where(t43 != 0.0, t29, 0.0)
    t45 = np.where(t42 != 0.0, np.where(t36 != 0.0, -(t33 / t36), 0.0), 0.0) + np.where(t43 != 0.0, np.where(t22 != 0.0, -t37, 0.0), 0.0)
    t46 = t26 + t19 * t45
    t47 = t41 * t41
    t48 = t18 * t47
    t49 = t46 * t46
    t50 = t18 * t49
    t51 = t3 * tx + t5 * ty
    t52 = 3.0 * t51
    t53 = np.where(t29 != 0.0, -np.where(t29 != 0.0, np.where(t29 != 0.0, t47 * (l3 * (t48 * t52)), 0.0), 0.0), 0.0)
    t54 = l3 * t51
    t55 = np.where(t29 != 0.0, t53, 0.0) - np.where(t29 != 0.0, np.where(t29 != 0.0, np.where(t29 != 0.0, t54 * (t41 * t47), 0.0), 0.0), 0.0)
    t56 = np.where(t44 != 0.0, np.where(t16 != 0.0, np.where(t44 != 0.0, np.where(t16 != 0.0, t49 * (l3 * (t50 * t52)), 0.0), 0.0), 0.0), 0.0)
    t57 = np.where(t16 != 0.0, np.where(t44 != 0.0, np.where(t16 != 0.0, np.where(t44 != 0.0, np.where(t16 != 0.0, t54 * (t46 * t49), 0.0), 0.0), 0.0), 0.0), 0.0)
    t58 = np.where(t44 != 0.0, np.where(t16 != 0.0, np.where(t44 != 0.0, np.where(t16 != 0.0, -t56, 0.0), 0.0), 0.0), 0.0) - np.where(t44 != 0.0, t57, 0.0)

    # results
    rates = np.empty((*leading, 6), real)
    tracked = np.empty((*leading, 2), real)
    tracked_rate = np.empty((*leading, 2), real)
    parabola = np.empty((*leading, 3), real)
    discriminant = np.empty((*leading, 1), real)
    least = np.empty((*leading, 3), real)
    null = np.empty((*leading, 3), real)
    rates[..., 0] = np.where(t29 != 0.0, t31 + np.where(t22 != 0.0, np.where(t16 != 0.0, -(t25 * t37), 0.0), 0.0), 0.0)
    rates[..., 1] = np.where(t29 != 0.0, t39 + np.where(t22 != 0.0, np.where(t16 != 0.0, -(t24 * t37), 0.0), 0.0), 0.0)
    rates[..., 2] = np.where(t29 != 0.0, t41, 0.0)
    rates[..., 3] = np.where(t44 != 0.0, np.where(t16 != 0.0, t30 + t25 * t45, 0.0), 0.0)
    rates[..., 4] = np.where(t44 != 0.0, np.where(t16 != 0.0, t38 + t24 * t45, 0.0), 0.0)
    rates[..., 5] = np.where(t44 != 0.0, np.where(t16 != 0.0, t46, 0.0), 0.0)
    tracked[..., 0] = -np.where(t29 != 0.0, np.where(t29 != 0.0, t48, 0.0), 0.0)
    tracked[..., 1] = -np.where(t44 != 0.0, np.where(t16 != 0.0, np.where(t44 != 0.0, np.where(t16 != 0.0, t50, 0.0), 0.0), 0.0), 0.0)
    tracked_rate[..., 0] = t55
    tracked_rate[..., 1] = t58
    parabola[..., 0] = t22
    parabola[..., 1] = t28
    parabola[..., 2] = -t32
    discriminant[..., 0] = t34
    least[..., 0] = t31
    least[..., 1] = t39
    least[..., 2] = t40
    null[..., 0] = np.where(t16 != 0.0, t25, 0.0)
    null[..., 1] = np.where(t16 != 0.0, t24, 0.0)
    null[..., 2] = np.where(t16 != 0.0, t19, 0.0)
    return rates.reshape(leading + (2, 3)), tracked.reshape(leading + (2,)), tracked_rate.reshape(leading + (2,)), parabola.reshape(leading + (3,)), discriminant.reshape(leading), least.reshape(leading + (3,)), null.reshape(leading + (3,))
