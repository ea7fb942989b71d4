"""speed ratio of planar_rpr, in NumPy.

Made from templates/kernel.py.j2; inputs 26402a5c086827a4f2c23e03d47e7e810f8318c3788ba24934559a3a0ecd9a5e.
785 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 148 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * sin_heading2 + cos_heading2 * s1
    t2 = c1 * cos_heading2 - sin_heading2 * s1
    t3 = t1 * tx - t2 * ty
    t4 = t2 * c3 - t1 * s3
    t5 = t4 * l3
    t6 = t1 * c3 + t2 * s3
    t7 = l3 * t6
    t8 = tx * t5 + ty * t7
    t9 = -t8
    t10 = l2 + q2
    t11 = t5 + (c1 * l1 + t2 * t10)
    t12 = t7 + (s1 * l1 + t1 * t10)
    t13 = tx * t11 + ty * t12
    t14 = tx * t2 + t1 * ty
    t15 = t3 * t3 + t14 * t14
    t16 = tx * t6 - ty * t4
    t17 = l3 * t16
    t18 = ty * t5 - tx * t7
    t19 = t8 * t8 + t18 * t18
    t20 = t8 * (t3 + t3) + t18 * (t14 + t14)
    t21 = -2.0 * t14
    t22 = t13 + t13
    t23 = ty * t11 - tx * t12
    t24 = t23 + t23
    t25 = t3 * t22 + t14 * t24
    t26 = l3 * (t16 + t16)
    t27 = t8 * t22 + t18 * t24
    t28 = t17 + (t3 * t10 + l1 * (s1 * tx - c1 * ty))
    t29 = t13 * t13 + t23 * t23
    t30 = t3 / t8
    t31 = t14 + np.where(t9 != 0.0, -(t18 * t30), 0.0)
    t32 = t31 * t31
    t33 = t13 / t8
    t34 = t23 + np.where(t9 != 0.0, -(t18 * t33), 0.0)
    t35 = (t31 + t31) * t34
    t36 = t34 * t34
    t37 = np.where(t9 != 0.0, -t30, 0.0)
    t38 = t17 * (t37 * t37)
    t39 = t21 - np.where(t9 != 0.0, np.where(t9 != 0.0, -(t30 * (t33 * (t17 + t17))), 0.0), 0.0)
    t40 = t39 + np.where(t9 != 0.0, -(t26 * t30), 0.0)
    t41 = np.where(t9 != 0.0, -t33, 0.0)
    t42 = t28 + t17 * (t41 * t41) + np.where(t9 != 0.0, -(t26 * t33), 0.0)
    t43 = t40 * (t35 + t35) - t42 * (4.0 * t32) - t38 * (4.0 * t36)
    t44 = t40 * t40 - t42 * (4.0 * t38)

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
    A[..., 2] = -t13
    B[..., 0] = t15 * kappa
    B[..., 1] = t17 + kappa * t19
    B[..., 2] = kappa * t20
    B[..., 3] = t21 + kappa * t25
    B[..., 4] = t26 + kappa * t27
    B[..., 5] = t28 + kappa * t29
    B0[..., 0] = 0.0
    B0[..., 1] = t17
    B0[..., 2] = 0.0
    B0[..., 3] = t21
    B0[..., 4] = t26
    B0[..., 5] = t28
    B1[..., 0] = t15
    B1[..., 1] = t19
    B1[..., 2] = t20
    B1[..., 3] = t25
    B1[..., 4] = t27
    B1[..., 5] = t29
    a[..., 0] = t32
    a[..., 1] = t35
    a[..., 2] = t36
    b[..., 0] = t38
    b[..., 1] = t40
    b[..., 2] = t42
    C[..., 0] = t43
    D[..., 0] = t44
    discriminant[..., 0] = t44 + kappa * t43
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 148 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = l2 + q2
    t3 = c1 * sin_heading2 + cos_heading2 * s1
    t4 = t1 * c3 - t3 * s3
    t5 = t4 * l3
    t6 = c1 * l1 + t1 * t2 + t5
    t7 = c3 * t3 + t1 * s3
    t8 = l3 * t7
    t9 = l1 * s1 + t2 * t3 + t8
    t10 = tx * t6 + ty * t9
    t11 = tx * t5 + ty * t8
    t12 = -t11
    t13 = tx * t3 - t1 * ty
    t14 = tx * t7 - t4 * ty
    t15 = l3 * t14
    t16 = t2 * t13 + l1 * (tx * s1 - c1 * ty) + t15
    t17 = t6 * ty - tx * t9
    t18 = t10 * t10 + t17 * t17
    t19 = t5 * ty - tx * t8
    t20 = t11 * t11 + t19 * t19
    t21 = l3 * (t14 + t14)
    t22 = t10 + t10
    t23 = t17 + t17
    t24 = t11 * t22 + t19 * t23
    t25 = tx * t1 + t3 * ty
    t26 = -2.0 * t25
    t27 = t13 * t22 + t23 * t25
    t28 = t11 * (t13 + t13) + t19 * (t25 + t25)
    t29 = t13 * t13 + t25 * t25
    t30 = t10 / t11
    t31 = t17 + np.where(t12 != 0.0, -(t19 * t30), 0.0)
    t32 = t31 * t31
    t33 = t13 / t11
    t34 = t25 + np.where(t12 != 0.0, -(t19 * t33), 0.0)
    t35 = (t31 + t31) * t34
    t36 = t34 * t34
    t37 = np.where(t12 != 0.0, -t30, 0.0)
    t38 = t16 + t15 * (t37 * t37) + np.where(t12 != 0.0, -(t21 * t30), 0.0)
    t39 = t26 - np.where(t12 != 0.0, np.where(t12 != 0.0, -(t30 * (t33 * (t15 + t15))), 0.0), 0.0)
    t40 = t39 + np.where(t12 != 0.0, -(t21 * t33), 0.0)
    t41 = np.where(t12 != 0.0, -t33, 0.0)
    t42 = t15 * (t41 * t41)
    t43 = t40 * (t35 + t35) - t42 * (4.0 * t32) - t38 * (4.0 * t36)
    t44 = t40 * t40 - t42 * (4.0 * t38)

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
    A[..., 0] = -t10
    A[..., 1] = t12
    A[..., 2] = -t13
    B[..., 0] = t16 + t18 * kappa
    B[..., 1] = t15 + kappa * t20
    B[..., 2] = t21 + kappa * t24
    B[..., 3] = t26 + kappa * t27
    B[..., 4] = kappa * t28
    B[..., 5] = kappa * t29
    B0[..., 0] = t16
    B0[..., 1] = t15
    B0[..., 2] = t21
    B0[..., 3] = t26
    B0[..., 4] = 0.0
    B0[..., 5] = 0.0
    B1[..., 0] = t18
    B1[..., 1] = t20
    B1[..., 2] = t24
    B1[..., 3] = t27
    B1[..., 4] = t28
    B1[..., 5] = t29
    a[..., 0] = t32
    a[..., 1] = t35
    a[..., 2] = t36
    b[..., 0] = t38
    b[..., 1] = t40
    b[..., 2] = t42
    C[..., 0] = t43
    D[..., 0] = t44
    discriminant[..., 0] = t44 + kappa * t43
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 131 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = l2 + q2
    t3 = c1 * sin_heading2 + cos_heading2 * s1
    t4 = t1 * c3 - t3 * s3
    t5 = t4 * l3
    t6 = c1 * l1 + t1 * t2 + t5
    t7 = c3 * t3 + t1 * s3
    t8 = l3 * t7
    t9 = l1 * s1 + t2 * t3 + t8
    t10 = tx * t6 + ty * t9
    t11 = tx * t3 - t1 * ty
    t12 = -t11
    t13 = tx * t5 + ty * t8
    t14 = tx * t7 - t4 * ty
    t15 = l3 * t14
    t16 = t2 * t11 + l1 * (tx * s1 - c1 * ty) + t15
    t17 = t6 * ty - tx * t9
    t18 = t10 * t10 + t17 * t17
    t19 = tx * t1 + t3 * ty
    t20 = t11 * t11 + t19 * t19
    t21 = -2.0 * t19
    t22 = t10 + t10
    t23 = t17 + t17
    t24 = t11 * t22 + t19 * t23
    t25 = l3 * (t14 + t14)
    t26 = t5 * ty - tx * t8
    t27 = t13 * t22 + t23 * t26
    t28 = t13 * (t11 + t11) + t26 * (t19 + t19)
    t29 = t13 * t13 + t26 * t26
    t30 = t10 / t11
    t31 = t17 + np.where(t12 != 0.0, -(t19 * t30), 0.0)
    t32 = t31 * t31
    t33 = t13 / t11
    t34 = t26 + np.where(t12 != 0.0, -(t19 * t33), 0.0)
    t35 = (t31 + t31) * t34
    t36 = t34 * t34
    t37 = t16 + np.where(t12 != 0.0, -(t21 * t30), 0.0)
    t38 = t25 + np.where(t12 != 0.0, -(t21 * t33), 0.0)
    t39 = 4.0 * t15
    t40 = t38 * (t35 + t35) - t32 * t39 - t37 * (4.0 * t36)
    t41 = t38 * t38 - t37 * t39

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
    A[..., 0] = -t10
    A[..., 1] = t12
    A[..., 2] = -t13
    B[..., 0] = t16 + t18 * kappa
    B[..., 1] = kappa * t20
    B[..., 2] = t21 + kappa * t24
    B[..., 3] = t25 + kappa * t27
    B[..., 4] = kappa * t28
    B[..., 5] = t15 + kappa * t29
    B0[..., 0] = t16
    B0[..., 1] = 0.0
    B0[..., 2] = t21
    B0[..., 3] = t25
    B0[..., 4] = 0.0
    B0[..., 5] = t15
    B1[..., 0] = t18
    B1[..., 1] = t20
    B1[..., 2] = t24
    B1[..., 3] = t27
    B1[..., 4] = t28
    B1[..., 5] = t29
    a[..., 0] = t32
    a[..., 1] = t35
    a[..., 2] = t36
    b[..., 0] = t37
    b[..., 1] = t38
    b[..., 2] = t15
    C[..., 0] = t40
    D[..., 0] = t41
    discriminant[..., 0] = t41 + kappa * t40
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_rates(q, parameters, tangent, curvature):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 358 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
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
    q1 = q[..., 0]
    c1 = np.cos(q1)
    heading2 = parameters[..., 3]
    cos_heading2 = np.cos(heading2)
    s1 = np.sin(q1)
    sin_heading2 = np.sin(heading2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = c1 * sin_heading2 + cos_heading2 * s1
    t3 = c3 * t1 - t2 * s3
    t4 = t3 * l3
    t5 = c3 * t2 + t1 * s3
    t6 = l3 * t5
    t7 = t4 * tx + t6 * ty
    t8 = t1 * tx + t2 * ty
    t9 = t2 * tx - t1 * ty
    t10 = t4 * ty - tx * t6
    t11 = t7 * t8 - t9 * t10
    t12 = l2 + q2
    t13 = t4 + (c1 * l1 + t1 * t12)
    t14 = t6 + (s1 * l1 + t2 * t12)
    t15 = tx * t13 + ty * t14
    t16 = ty * t13 - tx * t14
    t17 = t10 * t15 - t7 * t16
    t18 = t9 * t16 - t8 * t15
    t19 = np.sqrt((t11 * t11 + t17 * t17 + t18 * t18))
    t20 = t8 + t8
    t21 = t11 / t19
    t22 = t17 / t19
    t23 = t9 * t12
    t24 = t21 * t21
    t25 = np.where(t19 != 0.0, np.where(t19 != 0.0, t20 * t21 * t22, 0.0), 0.0) - np.where(t19 != 0.0, np.where(t19 != 0.0, t23 * t24, 0.0), 0.0)
    t26 = s1 * tx - c1 * ty
    t27 = l1 * t26
    t28 = tx * t5 - t3 * ty
    t29 = l3 * t28
    t30 = t18 / t19
    t31 = t21 + t30
    t32 = t25 - np.where(t19 != 0.0, np.where(t19 != 0.0, t24 * t27, 0.0), 0.0) - np.where(t19 != 0.0, np.where(t19 != 0.0, t29 * (t31 * t31), 0.0), 0.0)
    t33 = np.where(t32 != 0.0, 1.0, 0.0)
    t34 = (np.where(t19 != 0.0, t9 * t30, 0.0) - np.where(t19 != 0.0, t7 * t22, 0.0)) / t19
    t35 = (np.where(t19 != 0.0, t7 * t21, 0.0) - np.where(t19 != 0.0, t15 * t30, 0.0)) / t19
    t36 = t9 + t9
    t37 = np.where(t19 != 0.0, np.where(t19 != 0.0, t20 * (t22 * t34 + t21 * t35), 0.0), 0.0) - np.where(t19 != 0.0, np.where(t19 != 0.0, t21 * (t34 * (t12 * t36)), 0.0), 0.0)
    t38 = t37 - np.where(t19 != 0.0, np.where(t19 != 0.0, t21 * (t34 * (l1 * (t26 + t26))), 0.0), 0.0)
    t39 = (np.where(t19 != 0.0, t15 * t22, 0.0) - np.where(t19 != 0.0, t9 * t21, 0.0)) / t19
    t40 = t34 + t39
    t41 = t38 - np.where(t19 != 0.0, np.where(t19 != 0.0, t31 * (l3 * (t28 + t28) * t40), 0.0), 0.0)
    t42 = t33 + np.where((1.0 - t33) != 0.0, 1.0 - np.where(t41 != 0.0, 1.0, 0.0), 0.0)
    t43 = np.where(t19 != 0.0, t34, 0.0)
    t44 = t34 * t34
    t45 = np.where(t19 != 0.0, np.where(t19 != 0.0, t35 * (t20 * t34), 0.0), 0.0) - np.where(t19 != 0.0, np.where(t19 != 0.0, t23 * t44, 0.0), 0.0)
    t46 = t45 - np.where(t19 != 0.0, np.where(t19 != 0.0, t27 * t44, 0.0), 0.0) - np.where(t19 != 0.0, np.where(t19 != 0.0, t29 * (t40 * t40), 0.0), 0.0)
    t47 = t46 - kappa
    t48 = t41 * t41 - t32 * (4.0 * t47)
    t49 = np.sqrt(np.maximum(0.0, t48))
    t50 = -0.5 * t41 - 0.5 * np.copysign(t49, t41)
    t51 = t50 / t32
    t52 = t43 + np.where(t32 != 0.0, np.where(t19 != 0.0, t21 * t51, 0.0), 0.0)
    t53 = np.where(t19 != 0.0, t35, 0.0)
    t54 = t53 + np.where(t32 != 0.0, np.where(t19 != 0.0, t22 * t51, 0.0), 0.0)
    t55 = np.where(t19 != 0.0, t39, 0.0)
    t56 = t55 + np.where(t32 != 0.0, np.where(t19 != 0.0, t30 * t51, 0.0), 0.0)
    t57 = np.where(t49 != 0.0, 1.0, 0.0)
    t58 = 1.0 - t57
    t59 = t57 + np.where(t58 != 0.0, t42, 0.0)
    t60 = np.where(t57 != 0.0, np.where(t50 != 0.0, t47 / t50, 0.0), 0.0) + np.where(t58 != 0.0, np.where(t32 != 0.0, t51, 0.0), 0.0)
    t61 = t34 + t21 * t60
    t62 = t35 + t22 * t60
    t63 = t39 + t30 * t60
    t64 = t52 * t52
    t65 = np.where(t42 != 0.0, np.where(t42 != 0.0, t54 * (t20 * t52), 0.0), 0.0) - np.where(t42 != 0.0, np.where(t42 != 0.0, t23 * t64, 0.0), 0.0)
    t66 = t52 + t56
    t67 = np.where(t42 != 0.0, t66, 0.0)
    t68 = t67 * t67
    t69 = t65 - np.where(t42 != 0.0, np.where(t42 != 0.0, t27 * t64, 0.0), 0.0) - t29 * t68
    t70 = t61 * t61
    t71 = np.where(t59 != 0.0, np.where(t19 != 0.0, np.where(t59 != 0.0, np.where(t19 != 0.0, t62 * (t20 * t61), 0.0), 0.0), 0.0), 0.0) - np.where(t59 != 0.0, np.where(t19 != 0.0, np.where(t59 != 0.0, np.where(t19 != 0.0, t23 * t70, 0.0), 0.0), 0.0), 0.0)
    t72 = t61 + t63
    t73 = np.where(t59 != 0.0, np.where(t19 != 0.0, t72, 0.0), 0.0)
    t74 = t73 * t73
    t75 = t71 - np.where(t59 != 0.0, np.where(t19 != 0.0, np.where(t59 != 0.0, np.where(t19 != 0.0, t27 * t70, 0.0), 0.0), 0.0), 0.0) - t29 * t74
    t76 = t8 * t12
    t77 = l1 * (c1 * tx + s1 * ty)
    t78 = l3 * (t3 * tx + t5 * ty)
    t79 = np.where(t42 != 0.0, np.where(t42 != 0.0, t64 * t76 + t64 * t77, 0.0), 0.0) + t68 * t78
    t80 = -3.0 * t69 * (t79 + np.where(t42 != 0.0, np.where(t42 != 0.0, t54 * (t36 * t52), 0.0), 0.0))
    t81 = t52 * t64
    t82 = t80 + np.where(t42 != 0.0, np.where(t42 != 0.0, np.where(t42 != 0.0, t76 * t81, 0.0), 0.0), 0.0) + np.where(t42 != 0.0, np.where(t42 != 0.0, np.where(t42 != 0.0, t77 * t81, 0.0), 0.0), 0.0)
    t83 = 3.0 * t9
    t84 = t82 + np.where(t42 != 0.0, t78 * (t66 * t68), 0.0) + np.where(t42 != 0.0, np.where(t42 != 0.0, np.where(t42 != 0.0, t64 * (t54 * t83), 0.0), 0.0), 0.0)
    t85 = np.where(t59 != 0.0, np.where(t19 != 0.0, np.where(t59 != 0.0, np.where(t19 != 0.0, t70 * t76 + t70 * t77, 0.0), 0.0), 0.0), 0.0)
    t86 = t85 + t74 * t78 + np.where(t59 != 0.0, np.where(t19 != 0.0, np.where(t59 != 0.0, np.where(t19 != 0.0, t62 * (t36 * t61), 0.0), 0.0), 0.0), 0.0)
    t87 = t61 * t70
    t88 = np.where(t59 != 0.0, np.where(t19 != 0.0, np.where(t59 != 0.0, np.where(t19 != 0.0, np.where(t59 != 0.0, np.where(t19 != 0.0, t76 * t87, 0.0), 0.0), 0.0), 0.0), 0.0), 0.0)
    t89 = np.where(t59 != 0.0, np.where(t19 != 0.0, np.where(t59 != 0.0, np.where(t19 != 0.0, np.where(t59 != 0.0, np.where(t19 != 0.0, t77 * t87, 0.0), 0.0), 0.0), 0.0), 0.0), 0.0)
    t90 = -3.0 * t75 * t86 + t88 + t89 + np.where(t59 != 0.0, np.where(t19 != 0.0, t78 * (t72 * t74), 0.0), 0.0)
    t91 = np.where(t19 != 0.0, np.where(t59 != 0.0, np.where(t19 != 0.0, np.where(t59 != 0.0, np.where(t19 != 0.0, t70 * (t62 * t83), 0.0), 0.0), 0.0), 0.0), 0.0)

    # results
    rates = np.empty((*leading, 6), real)
    tracked = np.empty((*leading, 2), real)
    tracked_rate = np.empty((*leading, 2), real)
    parabola = np.empty((*leading, 3), real)
    discriminant = np.empty((*leading, 1), real)
    least = np.empty((*leading, 3), real)
    null = np.empty((*leading, 3), real)
    rates[..., 0] = np.where(t42 != 0.0, t52, 0.0)
    rates[..., 1] = np.where(t42 != 0.0, t54, 0.0)
    rates[..., 2] = np.where(t42 != 0.0, t56, 0.0)
    rates[..., 3] = np.where(t59 != 0.0, np.where(t19 != 0.0, t61, 0.0), 0.0)
    rates[..., 4] = np.where(t59 != 0.0, np.where(t19 != 0.0, t62, 0.0), 0.0)
    rates[..., 5] = np.where(t59 != 0.0, np.where(t19 != 0.0, t63, 0.0), 0.0)
    tracked[..., 0] = t69
    tracked[..., 1] = t75
    tracked_rate[..., 0] = -t84
    tracked_rate[..., 1] = -(t90 + np.where(t59 != 0.0, t91, 0.0))
    parabola[..., 0] = t32
    parabola[..., 1] = t41
    parabola[..., 2] = t46
    discriminant[..., 0] = t48
    least[..., 0] = t43
    least[..., 1] = t53
    least[..., 2] = t55
    null[..., 0] = np.where(t19 != 0.0, t21, 0.0)
    null[..., 1] = np.where(t19 != 0.0, t22, 0.0)
    null[..., 2] = np.where(t19 != 0.0, t30, 0.0)
    return rates.reshape(leading + (2, 3)), tracked.reshape(leading + (2,)), tracked_rate.reshape(leading + (2,)), parabola.reshape(leading + (3,)), discriminant.reshape(leading), least.reshape(leading + (3,)), null.reshape(leading + (3,))
