"""speed ratio of planar_prr, in NumPy.

Made from templates/kernel.py.j2; inputs cdac75dd2f7762b18f7bf272d172dc8347846594e3466cd9495c045c994a6745.
698 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 145 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = l1 + q1
    t2 = cos_heading1 * t1
    t3 = cos_heading1 * c2 - sin_heading1 * s2
    t4 = cos_heading1 * s2 + c2 * sin_heading1
    t5 = t3 * c3 - t4 * s3
    t6 = t5 * l3
    t7 = t2 + t3 * l2 + t6 - t2
    t8 = t1 * sin_heading1
    t9 = c3 * t4 + t3 * s3
    t10 = l3 * t9
    t11 = t8 + l2 * t4 + t10 - t8
    t12 = t7 * tx + t11 * ty
    t13 = t6 * tx + t10 * ty
    t14 = -t13
    t15 = sin_heading1 * tx - cos_heading1 * ty
    t16 = tx * t9 - t5 * ty
    t17 = l3 * t16
    t18 = l2 * (t4 * tx - t3 * ty) + t17
    t19 = t7 * ty - tx * t11
    t20 = t12 * t12 + t19 * t19
    t21 = t6 * ty - tx * t10
    t22 = t13 * t13 + t21 * t21
    t23 = l3 * (t16 + t16)
    t24 = t13 * (t12 + t12) + t21 * (t19 + t19)
    t25 = t15 + t15
    t26 = cos_heading1 * tx + sin_heading1 * ty
    t27 = t26 + t26
    t28 = t12 * t25 + t19 * t27
    t29 = t13 * t25 + t21 * t27
    t30 = t15 * t15 + t26 * t26
    t31 = t12 / t13
    t32 = t19 + np.where(t14 != 0.0, -(t21 * t31), 0.0)
    t33 = t32 * t32
    t34 = t15 / t13
    t35 = t26 + np.where(t14 != 0.0, -(t21 * t34), 0.0)
    t36 = (t32 + t32) * t35
    t37 = t35 * t35
    t38 = np.where(t14 != 0.0, -t31, 0.0)
    t39 = t18 + t17 * (t38 * t38) + np.where(t14 != 0.0, -(t23 * t31), 0.0)
    t40 = np.where(t14 != 0.0, -(t23 * t34), 0.0) - np.where(t14 != 0.0, np.where(t14 != 0.0, -(t31 * (t34 * (t17 + t17))), 0.0), 0.0)
    t41 = np.where(t14 != 0.0, -t34, 0.0)
    t42 = t17 * (t41 * t41)
    t43 = t40 * (t36 + t36) - t42 * (4.0 * t33) - t39 * (4.0 * t37)
    t44 = t40 * t40 - t42 * (4.0 * t39)

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
    A[..., 0] = -t12
    A[..., 1] = t14
    A[..., 2] = -t15
    B[..., 0] = t18 + t20 * kappa
    B[..., 1] = t17 + kappa * t22
    B[..., 2] = t23 + kappa * t24
    B[..., 3] = kappa * t28
    B[..., 4] = kappa * t29
    B[..., 5] = kappa * t30
    B0[..., 0] = t18
    B0[..., 1] = t17
    B0[..., 2] = t23
    B0[..., 3] = 0.0
    B0[..., 4] = 0.0
    B0[..., 5] = 0.0
    B1[..., 0] = t20
    B1[..., 1] = t22
    B1[..., 2] = t24
    B1[..., 3] = t28
    B1[..., 4] = t29
    B1[..., 5] = t30
    a[..., 0] = t33
    a[..., 1] = t36
    a[..., 2] = t37
    b[..., 0] = t39
    b[..., 1] = t40
    b[..., 2] = t42
    C[..., 0] = t43
    D[..., 0] = t44
    discriminant[..., 0] = t44 + kappa * t43
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 145 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
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
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = sin_heading1 * tx - cos_heading1 * ty
    t2 = cos_heading1 * c2 - sin_heading1 * s2
    t3 = cos_heading1 * s2 + sin_heading1 * c2
    t4 = c3 * t2 - t3 * s3
    t5 = t4 * l3
    t6 = c3 * t3 + t2 * s3
    t7 = l3 * t6
    t8 = tx * t5 + ty * t7
    t9 = -t8
    t10 = l1 + q1
    t11 = cos_heading1 * t10
    t12 = t5 + (t11 + t2 * l2) - t11
    t13 = sin_heading1 * t10
    t14 = t7 + (t13 + t3 * l2) - t13
    t15 = tx * t12 + ty * t14
    t16 = tx * cos_heading1 + sin_heading1 * ty
    t17 = t1 * t1 + t16 * t16
    t18 = tx * t6 - ty * t4
    t19 = l3 * t18
    t20 = ty * t5 - tx * t7
    t21 = t8 * t8 + t20 * t20
    t22 = t1 + t1
    t23 = t16 + t16
    t24 = t8 * t22 + t20 * t23
    t25 = ty * t12 - tx * t14
    t26 = t15 * t22 + t23 * t25
    t27 = l3 * (t18 + t18)
    t28 = t8 * (t15 + t15) + t20 * (t25 + t25)
    t29 = t19 + l2 * (tx * t3 - ty * t2)
    t30 = t15 * t15 + t25 * t25
    t31 = t1 / t8
    t32 = t16 + np.where(t9 != 0.0, -(t20 * t31), 0.0)
    t33 = t32 * t32
    t34 = t15 / t8
    t35 = t25 + np.where(t9 != 0.0, -(t20 * t34), 0.0)
    t36 = (t32 + t32) * t35
    t37 = t35 * t35
    t38 = np.where(t9 != 0.0, -t31, 0.0)
    t39 = t19 * (t38 * t38)
    t40 = np.where(t9 != 0.0, -(t27 * t31), 0.0) - np.where(t9 != 0.0, np.where(t9 != 0.0, -(t31 * (t34 * (t19 + t19))), 0.0), 0.0)
    t41 = np.where(t9 != 0.0, -t34, 0.0)
    t42 = t29 + t19 * (t41 * t41) + np.where(t9 != 0.0, -(t27 * t34), 0.0)
    t43 = t40 * (t36 + t36) - t42 * (4.0 * t33) - t39 * (4.0 * t37)
    t44 = t40 * t40 - t42 * (4.0 * t39)

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
    A[..., 2] = -t15
    B[..., 0] = t17 * kappa
    B[..., 1] = t19 + kappa * t21
    B[..., 2] = kappa * t24
    B[..., 3] = kappa * t26
    B[..., 4] = t27 + kappa * t28
    B[..., 5] = t29 + kappa * t30
    B0[..., 0] = 0.0
    B0[..., 1] = t19
    B0[..., 2] = 0.0
    B0[..., 3] = 0.0
    B0[..., 4] = t27
    B0[..., 5] = t29
    B1[..., 0] = t17
    B1[..., 1] = t21
    B1[..., 2] = t24
    B1[..., 3] = t26
    B1[..., 4] = t28
    B1[..., 5] = t30
    a[..., 0] = t33
    a[..., 1] = t36
    a[..., 2] = t37
    b[..., 0] = t39
    b[..., 1] = t40
    b[..., 2] = t42
    C[..., 0] = t43
    D[..., 0] = t44
    discriminant[..., 0] = t44 + kappa * t43
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 145 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    kappa = curvature[..., 0]

    # terms
    t1 = sin_heading1 * tx - cos_heading1 * ty
    t2 = l1 + q1
    t3 = cos_heading1 * t2
    t4 = cos_heading1 * c2 - sin_heading1 * s2
    t5 = cos_heading1 * s2 + sin_heading1 * c2
    t6 = t4 * c3 - t5 * s3
    t7 = t6 * l3
    t8 = t3 + t4 * l2 + t7 - t3
    t9 = sin_heading1 * t2
    t10 = c3 * t5 + t4 * s3
    t11 = l3 * t10
    t12 = t9 + l2 * t5 + t11 - t9
    t13 = tx * t8 + ty * t12
    t14 = -t13
    t15 = tx * t7 + ty * t11
    t16 = tx * cos_heading1 + sin_heading1 * ty
    t17 = t1 * t1 + t16 * t16
    t18 = tx * t10 - ty * t6
    t19 = l3 * t18
    t20 = l2 * (tx * t5 - ty * t4) + t19
    t21 = ty * t8 - tx * t12
    t22 = t13 * t13 + t21 * t21
    t23 = t1 + t1
    t24 = t16 + t16
    t25 = t13 * t23 + t21 * t24
    t26 = ty * t7 - tx * t11
    t27 = t15 * t23 + t24 * t26
    t28 = l3 * (t18 + t18)
    t29 = t15 * (t13 + t13) + t26 * (t21 + t21)
    t30 = t15 * t15 + t26 * t26
    t31 = t1 / t13
    t32 = t16 + np.where(t14 != 0.0, -(t21 * t31), 0.0)
    t33 = t32 * t32
    t34 = t15 / t13
    t35 = t26 + np.where(t14 != 0.0, -(t21 * t34), 0.0)
    t36 = (t32 + t32) * t35
    t37 = t35 * t35
    t38 = np.where(t14 != 0.0, -t31, 0.0)
    t39 = t20 * (t38 * t38)
    t40 = np.where(t14 != 0.0, -(t28 * t31), 0.0) - np.where(t14 != 0.0, np.where(t14 != 0.0, -(t31 * (t34 * (t20 + t20))), 0.0), 0.0)
    t41 = np.where(t14 != 0.0, -t34, 0.0)
    t42 = t19 + t20 * (t41 * t41) + np.where(t14 != 0.0, -(t28 * t34), 0.0)
    t43 = t40 * (t36 + t36) - t42 * (4.0 * t33) - t39 * (4.0 * t37)
    t44 = t40 * t40 - t42 * (4.0 * t39)

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
    A[..., 1] = t14
    A[..., 2] = -t15
    B[..., 0] = t17 * kappa
    B[..., 1] = t20 + kappa * t22
    B[..., 2] = kappa * t25
    B[..., 3] = kappa * t27
    B[..., 4] = t28 + kappa * t29
    B[..., 5] = t19 + kappa * t30
    B0[..., 0] = 0.0
    B0[..., 1] = t20
    B0[..., 2] = 0.0
    B0[..., 3] = 0.0
    B0[..., 4] = t28
    B0[..., 5] = t19
    B1[..., 0] = t17
    B1[..., 1] = t22
    B1[..., 2] = t25
    B1[..., 3] = t27
    B1[..., 4] = t29
    B1[..., 5] = t30
    a[..., 0] = t33
    a[..., 1] = t36
    a[..., 2] = t37
    b[..., 0] = t39
    b[..., 1] = t40
    b[..., 2] = t42
    C[..., 0] = t43
    D[..., 0] = t44
    discriminant[..., 0] = t44 + kappa * t43
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_rates(q, parameters, tangent, curvature):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 263 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
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
    q2 = q[..., 1]
    c2 = np.cos(q2)
    sin_heading1 = np.sin(heading1)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = cos_heading1 * c2 - sin_heading1 * s2
    t2 = cos_heading1 * s2 + c2 * sin_heading1
    t3 = c3 * t1 - t2 * s3
    t4 = t3 * l3
    t5 = c3 * t2 + t1 * s3
    t6 = l3 * t5
    t7 = t4 * tx + t6 * ty
    t8 = l1 + q1
    t9 = cos_heading1 * t8
    t10 = t4 + (t9 + t1 * l2) - t9
    t11 = sin_heading1 * t8
    t12 = t6 + (t11 + t2 * l2) - t11
    t13 = ty * t10 - tx * t12
    t14 = tx * t10 + ty * t12
    t15 = t4 * ty - tx * t6
    t16 = t7 * t13 - t14 * t15
    t17 = sin_heading1 * tx - cos_heading1 * ty
    t18 = cos_heading1 * tx + sin_heading1 * ty
    t19 = t15 * t17 - t7 * t18
    t20 = t14 * t18 - t13 * t17
    t21 = np.sqrt((t16 * t16 + t19 * t19 + t20 * t20))
    t22 = t2 * tx - t1 * ty
    t23 = l2 * t22
    t24 = t19 / t21
    t25 = tx * t5 - t3 * ty
    t26 = l3 * t25
    t27 = t20 / t21
    t28 = t24 + t27
    t29 = t23 * (t24 * t24) + t26 * (t28 * t28)
    t30 = np.where(t21 != 0.0, np.where(t21 != 0.0, t29, 0.0), 0.0)
    t31 = -t30
    t32 = np.where(t31 != 0.0, 1.0, 0.0)
    t33 = t16 / t21
    t34 = (np.where(t21 != 0.0, t7 * t33, 0.0) - np.where(t21 != 0.0, t17 * t27, 0.0)) / t21
    t35 = (np.where(t21 != 0.0, t17 * t24, 0.0) - np.where(t21 != 0.0, t14 * t33, 0.0)) / t21
    t36 = t34 + t35
    t37 = np.where(t21 != 0.0, np.where(t21 != 0.0, t24 * (l2 * (-2.0 * t22) * t34), 0.0), 0.0) - np.where(t21 != 0.0, np.where(t21 != 0.0, t28 * (l3 * (t25 + t25) * t36), 0.0), 0.0)
    t38 = t32 + np.where((1.0 - t32) != 0.0, 1.0 - np.where(t37 != 0.0, 1.0, 0.0), 0.0)
    t39 = (np.where(t21 != 0.0, t14 * t27, 0.0) - np.where(t21 != 0.0, t7 * t24, 0.0)) / t21
    t40 = np.where(t21 != 0.0, t39, 0.0)
    t41 = np.where(t21 != 0.0, np.where(t21 != 0.0, t23 * (t34 * t34) + t26 * (t36 * t36), 0.0), 0.0)
    t42 = t41 + kappa
    t43 = t37 * t37 - np.where(t21 != 0.0, np.where(t21 != 0.0, t29 * (4.0 * t42), 0.0), 0.0)
    t44 = np.sqrt(np.maximum(0.0, t43))
    t45 = -0.5 * t37 - 0.5 * np.copysign(t44, t37)
    t46 = t45 / t30
    t47 = np.where(t21 != 0.0, t34, 0.0)
    t48 = t47 + np.where(t31 != 0.0, np.where(t21 != 0.0, -(t24 * t46), 0.0), 0.0)
    t49 = np.where(t21 != 0.0, t35, 0.0)
    t50 = t49 + np.where(t31 != 0.0, np.where(t21 != 0.0, -(t27 * t46), 0.0), 0.0)
    t51 = np.where(t44 != 0.0, 1.0, 0.0)
    t52 = 1.0 - t51
    t53 = t51 + np.where(t52 != 0.0, t38, 0.0)
    t54 = np.where(t51 != 0.0, np.where(t45 != 0.0, -(t42 / t45), 0.0), 0.0) + np.where(t52 != 0.0, np.where(t31 != 0.0, -t46, 0.0), 0.0)
    t55 = t34 + t24 * t54
    t56 = t35 + t27 * t54
    t57 = t48 * t48
    t58 = t48 + t50
    t59 = np.where(t38 != 0.0, t58, 0.0)
    t60 = t59 * t59
    t61 = np.where(t38 != 0.0, np.where(t38 != 0.0, t23 * t57, 0.0), 0.0) + t26 * t60
    t62 = t55 * t55
    t63 = t55 + t56
    t64 = np.where(t53 != 0.0, np.where(t21 != 0.0, t63, 0.0), 0.0)
    t65 = t64 * t64
    t66 = np.where(t53 != 0.0, np.where(t21 != 0.0, np.where(t53 != 0.0, np.where(t21 != 0.0, t23 * t62, 0.0), 0.0), 0.0), 0.0) + t26 * t65
    t67 = l2 * (t1 * tx + t2 * ty)
    t68 = l3 * (t3 * tx + t5 * ty)
    t69 = -3.0 * t61 * (np.where(t38 != 0.0, np.where(t38 != 0.0, t57 * t67, 0.0), 0.0) + t60 * t68)
    t70 = t69 - np.where(t38 != 0.0, np.where(t38 != 0.0, np.where(t38 != 0.0, t67 * (t48 * t57), 0.0), 0.0), 0.0) - np.where(t38 != 0.0, t68 * (t58 * t60), 0.0)
    t71 = np.where(t53 != 0.0, np.where(t21 != 0.0, np.where(t53 != 0.0, np.where(t21 != 0.0, t62 * t67, 0.0), 0.0), 0.0), 0.0) + t65 * t68
    t72 = np.where(t21 != 0.0, np.where(t53 != 0.0, np.where(t21 != 0.0, np.where(t53 != 0.0, np.where(t21 != 0.0, t67 * (t55 * t62), 0.0), 0.0), 0.0), 0.0), 0.0)
    t73 = -3.0 * t66 * t71 - np.where(t53 != 0.0, t72, 0.0) - np.where(t53 != 0.0, np.where(t21 != 0.0, t68 * (t63 * t65), 0.0), 0.0)

    # results
    rates = np.empty((*leading, 6), real)
    tracked = np.empty((*leading, 2), real)
    tracked_rate = np.empty((*leading, 2), real)
    parabola = np.empty((*leading, 3), real)
    discriminant = np.empty((*leading, 1), real)
    least = np.empty((*leading, 3), real)
    null = np.empty((*leading, 3), real)
    rates[..., 0] = np.where(t38 != 0.0, t40 + np.where(t31 != 0.0, np.where(t21 != 0.0, -(t33 * t46), 0.0), 0.0), 0.0)
    rates[..., 1] = np.where(t38 != 0.0, t48, 0.0)
    rates[..., 2] = np.where(t38 != 0.0, t50, 0.0)
    rates[..., 3] = np.where(t53 != 0.0, np.where(t21 != 0.0, t39 + t33 * t54, 0.0), 0.0)
    rates[..., 4] = np.where(t53 != 0.0, np.where(t21 != 0.0, t55, 0.0), 0.0)
    rates[..., 5] = np.where(t53 != 0.0, np.where(t21 != 0.0, t56, 0.0), 0.0)
    tracked[..., 0] = -t61
    tracked[..., 1] = -t66
    tracked_rate[..., 0] = t70
    tracked_rate[..., 1] = t73
    parabola[..., 0] = t31
    parabola[..., 1] = t37
    parabola[..., 2] = -t41
    discriminant[..., 0] = t43
    least[..., 0] = t40
    least[..., 1] = t47
    least[..., 2] = t49
    null[..., 0] = np.where(t21 != 0.0, t33, 0.0)
    null[..., 1] = np.where(t21 != 0.0, t24, 0.0)
    null[..., 2] = np.where(t21 != 0.0, t27, 0.0)
    return rates.reshape(leading + (2, 3)), tracked.reshape(leading + (2,)), tracked_rate.reshape(leading + (2,)), parabola.reshape(leading + (3,)), discriminant.reshape(leading), least.reshape(leading + (3,)), null.reshape(leading + (3,))
