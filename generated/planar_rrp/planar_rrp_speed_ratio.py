"""speed ratio of planar_rrp, in NumPy.

Made from templates/kernel.py.j2; inputs d547eb0eab673bb17063998f94b24c332a85a1110f2f7694d7941375899f9d24.
787 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 141 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
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
    l1 = parameters[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * l1
    t2 = c1 * c2 - s1 * s2
    t3 = c1 * s2 + c2 * s1
    t4 = t2 * cos_heading3 - t3 * sin_heading3
    t5 = l3 + q3
    t6 = t1 + t2 * l2 + t4 * t5
    t7 = t6 - t1
    t8 = l1 * s1
    t9 = cos_heading3 * t3 + t2 * sin_heading3
    t10 = t8 + l2 * t3 + t5 * t9
    t11 = t10 - t8
    t12 = t7 * tx + t11 * ty
    t13 = tx * t9 - t4 * ty
    t14 = -t13
    t15 = t6 * tx + t10 * ty
    t16 = t5 * t13
    t17 = t3 * tx - t2 * ty
    t18 = l2 * t17
    t19 = t16 + t18
    t20 = t7 * ty - tx * t11
    t21 = t12 * t12 + t20 * t20
    t22 = t4 * tx + t9 * ty
    t23 = t13 * t13 + t22 * t22
    t24 = -2.0 * t22
    t25 = t13 * (t12 + t12) + t22 * (t20 + t20)
    t26 = t5 * (t13 + t13) + l2 * (t17 + t17)
    t27 = t15 + t15
    t28 = t6 * ty - tx * t10
    t29 = t28 + t28
    t30 = t12 * t27 + t20 * t29
    t31 = t13 * t27 + t22 * t29
    t32 = t18 + (t16 + l1 * (s1 * tx - c1 * ty))
    t33 = t15 * t15 + t28 * t28
    t34 = t12 / t13
    t35 = t20 + np.where(t14 != 0.0, -(t22 * t34), 0.0)
    t36 = t35 * t35
    t37 = t15 / t13
    t38 = t28 + np.where(t14 != 0.0, -(t22 * t37), 0.0)
    t39 = (t35 + t35) * t38
    t40 = t38 * t38
    t41 = np.where(t14 != 0.0, -(t24 * t34), 0.0)
    t42 = t19 + t41
    t43 = np.where(t14 != 0.0, -(t24 * t37), 0.0)
    t44 = t41 + (t26 + t43)
    t45 = t32 + t43
    t46 = t44 * (t39 + t39) - t45 * (4.0 * t36) - t42 * (4.0 * t40)
    t47 = t44 * t44 - t45 * (4.0 * t42)

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
    B[..., 0] = t19 + t21 * kappa
    B[..., 1] = kappa * t23
    B[..., 2] = t24 + kappa * t25
    B[..., 3] = t26 + kappa * t30
    B[..., 4] = t24 + kappa * t31
    B[..., 5] = t32 + kappa * t33
    B0[..., 0] = t19
    B0[..., 1] = 0.0
    B0[..., 2] = t24
    B0[..., 3] = t26
    B0[..., 4] = t24
    B0[..., 5] = t32
    B1[..., 0] = t21
    B1[..., 1] = t23
    B1[..., 2] = t25
    B1[..., 3] = t30
    B1[..., 4] = t31
    B1[..., 5] = t33
    a[..., 0] = t36
    a[..., 1] = t39
    a[..., 2] = t40
    b[..., 0] = t42
    b[..., 1] = t44
    b[..., 2] = t45
    C[..., 0] = t46
    D[..., 0] = t47
    discriminant[..., 0] = t47 + kappa * t46
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 141 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
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
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * l1
    t2 = c1 * c2 - s1 * s2
    t3 = c1 * s2 + c2 * s1
    t4 = t2 * cos_heading3 - t3 * sin_heading3
    t5 = l3 + q3
    t6 = t1 + t2 * l2 + t4 * t5
    t7 = l1 * s1
    t8 = cos_heading3 * t3 + t2 * sin_heading3
    t9 = t7 + l2 * t3 + t5 * t8
    t10 = tx * t6 + ty * t9
    t11 = tx * t8 - t4 * ty
    t12 = -t11
    t13 = t6 - t1
    t14 = t9 - t7
    t15 = tx * t13 + ty * t14
    t16 = t5 * t11
    t17 = tx * t3 - t2 * ty
    t18 = l2 * t17
    t19 = t16 + l1 * (tx * s1 - c1 * ty) + t18
    t20 = t6 * ty - tx * t9
    t21 = t10 * t10 + t20 * t20
    t22 = tx * t4 + ty * t8
    t23 = t11 * t11 + t22 * t22
    t24 = -2.0 * t22
    t25 = t10 + t10
    t26 = t20 + t20
    t27 = t11 * t25 + t22 * t26
    t28 = t5 * (t11 + t11) + l2 * (t17 + t17)
    t29 = ty * t13 - tx * t14
    t30 = t15 * t25 + t26 * t29
    t31 = t11 * (t15 + t15) + t22 * (t29 + t29)
    t32 = t16 + t18
    t33 = t15 * t15 + t29 * t29
    t34 = t10 / t11
    t35 = t20 + np.where(t12 != 0.0, -(t22 * t34), 0.0)
    t36 = t35 * t35
    t37 = t15 / t11
    t38 = t29 + np.where(t12 != 0.0, -(t22 * t37), 0.0)
    t39 = (t35 + t35) * t38
    t40 = t38 * t38
    t41 = np.where(t12 != 0.0, -(t24 * t34), 0.0)
    t42 = t19 + t41
    t43 = np.where(t12 != 0.0, -(t24 * t37), 0.0)
    t44 = t41 + (t28 + t43)
    t45 = t32 + t43
    t46 = t44 * (t39 + t39) - t45 * (4.0 * t36) - t42 * (4.0 * t40)
    t47 = t44 * t44 - t45 * (4.0 * t42)

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
    A[..., 2] = -t15
    B[..., 0] = t19 + t21 * kappa
    B[..., 1] = kappa * t23
    B[..., 2] = t24 + kappa * t27
    B[..., 3] = t28 + kappa * t30
    B[..., 4] = t24 + kappa * t31
    B[..., 5] = t32 + kappa * t33
    B0[..., 0] = t19
    B0[..., 1] = 0.0
    B0[..., 2] = t24
    B0[..., 3] = t28
    B0[..., 4] = t24
    B0[..., 5] = t32
    B1[..., 0] = t21
    B1[..., 1] = t23
    B1[..., 2] = t27
    B1[..., 3] = t30
    B1[..., 4] = t31
    B1[..., 5] = t33
    a[..., 0] = t36
    a[..., 1] = t39
    a[..., 2] = t40
    b[..., 0] = t42
    b[..., 1] = t44
    b[..., 2] = t45
    C[..., 0] = t46
    D[..., 0] = t47
    discriminant[..., 0] = t47 + kappa * t46
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 163 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
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
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * l1
    t2 = c1 * c2 - s1 * s2
    t3 = c1 * s2 + c2 * s1
    t4 = t2 * cos_heading3 - t3 * sin_heading3
    t5 = l3 + q3
    t6 = t1 + t2 * l2 + t4 * t5
    t7 = l1 * s1
    t8 = cos_heading3 * t3 + t2 * sin_heading3
    t9 = t7 + l2 * t3 + t5 * t8
    t10 = tx * t6 + ty * t9
    t11 = t6 - t1
    t12 = t9 - t7
    t13 = tx * t11 + ty * t12
    t14 = -t13
    t15 = tx * t8 - t4 * ty
    t16 = t5 * t15
    t17 = tx * t3 - t2 * ty
    t18 = l2 * t17
    t19 = t16 + l1 * (tx * s1 - c1 * ty) + t18
    t20 = t6 * ty - tx * t9
    t21 = t10 * t10 + t20 * t20
    t22 = t16 + t18
    t23 = ty * t11 - tx * t12
    t24 = t13 * t13 + t23 * t23
    t25 = t5 * (t15 + t15) + l2 * (t17 + t17)
    t26 = t10 + t10
    t27 = t20 + t20
    t28 = t13 * t26 + t23 * t27
    t29 = tx * t4 + ty * t8
    t30 = -2.0 * t29
    t31 = t15 * t26 + t27 * t29
    t32 = t15 * (t13 + t13) + t29 * (t23 + t23)
    t33 = t15 * t15 + t29 * t29
    t34 = t10 / t13
    t35 = t20 + np.where(t14 != 0.0, -(t23 * t34), 0.0)
    t36 = t35 * t35
    t37 = t15 / t13
    t38 = t29 + np.where(t14 != 0.0, -(t23 * t37), 0.0)
    t39 = (t35 + t35) * t38
    t40 = t38 * t38
    t41 = np.where(t14 != 0.0, -t34, 0.0)
    t42 = t19 + t22 * (t41 * t41) + np.where(t14 != 0.0, -(t25 * t34), 0.0)
    t43 = t30 - np.where(t14 != 0.0, np.where(t14 != 0.0, -(t34 * (t37 * (t22 + t22))), 0.0), 0.0)
    t44 = t43 + np.where(t14 != 0.0, -(t25 * t37), 0.0) + np.where(t14 != 0.0, -(t30 * t34), 0.0)
    t45 = np.where(t14 != 0.0, -t37, 0.0)
    t46 = t22 * (t45 * t45) + np.where(t14 != 0.0, -(t30 * t37), 0.0)
    t47 = t44 * (t39 + t39) - t46 * (4.0 * t36) - t42 * (4.0 * t40)
    t48 = t44 * t44 - t46 * (4.0 * t42)

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
    A[..., 1] = t14
    A[..., 2] = -t15
    B[..., 0] = t19 + t21 * kappa
    B[..., 1] = t22 + kappa * t24
    B[..., 2] = t25 + kappa * t28
    B[..., 3] = t30 + kappa * t31
    B[..., 4] = t30 + kappa * t32
    B[..., 5] = kappa * t33
    B0[..., 0] = t19
    B0[..., 1] = t22
    B0[..., 2] = t25
    B0[..., 3] = t30
    B0[..., 4] = t30
    B0[..., 5] = 0.0
    B1[..., 0] = t21
    B1[..., 1] = t24
    B1[..., 2] = t28
    B1[..., 3] = t31
    B1[..., 4] = t32
    B1[..., 5] = t33
    a[..., 0] = t36
    a[..., 1] = t39
    a[..., 2] = t40
    b[..., 0] = t42
    b[..., 1] = t44
    b[..., 2] = t46
    C[..., 0] = t47
    D[..., 0] = t48
    discriminant[..., 0] = t48 + kappa * t47
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_rates(q, parameters, tangent, curvature):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 342 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
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
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    sin_heading3 = np.sin(heading3)
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * s2 + c2 * s1
    t2 = c1 * c2 - s2 * s1
    t3 = cos_heading3 * t1 + t2 * sin_heading3
    t4 = cos_heading3 * t2 - t1 * sin_heading3
    t5 = t3 * tx - t4 * ty
    t6 = c1 * l1
    t7 = l3 + q3
    t8 = t6 + t2 * l2 + t4 * t7
    t9 = t8 - t6
    t10 = s1 * l1
    t11 = t10 + t1 * l2 + t3 * t7
    t12 = t11 - t10
    t13 = ty * t9 - tx * t12
    t14 = tx * t9 + ty * t12
    t15 = tx * t4 + t3 * ty
    t16 = t5 * t13 - t14 * t15
    t17 = tx * t8 + ty * t11
    t18 = ty * t8 - tx * t11
    t19 = t15 * t17 - t5 * t18
    t20 = t14 * t18 - t13 * t17
    t21 = np.sqrt((t16 * t16 + t19 * t19 + t20 * t20))
    t22 = t15 + t15
    t23 = t20 / t21
    t24 = t16 / t21
    t25 = t19 / t21
    t26 = t24 + t25
    t27 = t5 * t7
    t28 = t26 * t26
    t29 = np.where(t21 != 0.0, np.where(t21 != 0.0, t22 * t23 * t26, 0.0), 0.0) - np.where(t21 != 0.0, np.where(t21 != 0.0, t27 * t28, 0.0), 0.0)
    t30 = s1 * tx - c1 * ty
    t31 = l1 * t30
    t32 = t1 * tx - t2 * ty
    t33 = l2 * t32
    t34 = t29 - np.where(t21 != 0.0, np.where(t21 != 0.0, t31 * (t24 * t24), 0.0), 0.0) - np.where(t21 != 0.0, np.where(t21 != 0.0, t28 * t33, 0.0), 0.0)
    t35 = np.where(t34 != 0.0, 1.0, 0.0)
    t36 = (np.where(t21 != 0.0, t17 * t25, 0.0) - np.where(t21 != 0.0, t14 * t24, 0.0)) / t21
    t37 = (np.where(t21 != 0.0, t14 * t23, 0.0) - np.where(t21 != 0.0, t5 * t25, 0.0)) / t21
    t38 = (np.where(t21 != 0.0, t5 * t24, 0.0) - np.where(t21 != 0.0, t17 * t23, 0.0)) / t21
    t39 = t37 + t38
    t40 = t5 + t5
    t41 = np.where(t21 != 0.0, np.where(t21 != 0.0, t22 * (t26 * t36 + t23 * t39), 0.0), 0.0) - np.where(t21 != 0.0, np.where(t21 != 0.0, t26 * (t39 * (t7 * t40)), 0.0), 0.0)
    t42 = t41 - np.where(t21 != 0.0, np.where(t21 != 0.0, t24 * (t37 * (l1 * (t30 + t30))), 0.0), 0.0)
    t43 = t42 - np.where(t21 != 0.0, np.where(t21 != 0.0, t26 * (t39 * (l2 * (t32 + t32))), 0.0), 0.0)
    t44 = t35 + np.where((1.0 - t35) != 0.0, 1.0 - np.where(t43 != 0.0, 1.0, 0.0), 0.0)
    t45 = np.where(t21 != 0.0, t37, 0.0)
    t46 = t39 * t39
    t47 = np.where(t21 != 0.0, np.where(t21 != 0.0, t39 * (t22 * t36), 0.0), 0.0) - np.where(t21 != 0.0, np.where(t21 != 0.0, t27 * t46, 0.0), 0.0)
    t48 = t47 - np.where(t21 != 0.0, np.where(t21 != 0.0, t31 * (t37 * t37), 0.0), 0.0) - np.where(t21 != 0.0, np.where(t21 != 0.0, t33 * t46, 0.0), 0.0)
    t49 = t48 - kappa
    t50 = t43 * t43 - t34 * (4.0 * t49)
    t51 = np.sqrt(np.maximum(0.0, t50))
    t52 = -0.5 * t43 - 0.5 * np.copysign(t51, t43)
    t53 = t52 / t34
    t54 = t45 + np.where(t34 != 0.0, np.where(t21 != 0.0, t24 * t53, 0.0), 0.0)
    t55 = np.where(t21 != 0.0, t38, 0.0)
    t56 = t55 + np.where(t34 != 0.0, np.where(t21 != 0.0, t25 * t53, 0.0), 0.0)
    t57 = np.where(t21 != 0.0, t36, 0.0)
    t58 = t57 + np.where(t34 != 0.0, np.where(t21 != 0.0, t23 * t53, 0.0), 0.0)
    t59 = np.where(t51 != 0.0, 1.0, 0.0)
    t60 = 1.0 - t59
    t61 = t59 + np.where(t60 != 0.0, t44, 0.0)
    t62 = np.where(t59 != 0.0, np.where(t52 != 0.0, t49 / t52, 0.0), 0.0) + np.where(t60 != 0.0, np.where(t34 != 0.0, t53, 0.0), 0.0)
    t63 = t37 + t24 * t62
    t64 = t38 + t25 * t62
    t65 = t36 + t23 * t62
    t66 = t54 + t56
    t67 = np.where(t44 != 0.0, t66, 0.0)
    t68 = t67 * t67
    t69 = t54 * t54
    t70 = np.where(t44 != 0.0, np.where(t44 != 0.0, t22 * t58 * t66, 0.0), 0.0) - t27 * t68 - np.where(t44 != 0.0, np.where(t44 != 0.0, t31 * t69, 0.0), 0.0)
    t71 = t70 - t33 * t68
    t72 = t63 + t64
    t73 = np.where(t61 != 0.0, np.where(t21 != 0.0, t72, 0.0), 0.0)
    t74 = t73 * t73
    t75 = np.where(t61 != 0.0, np.where(t21 != 0.0, np.where(t61 != 0.0, np.where(t21 != 0.0, t22 * t65 * t72, 0.0), 0.0), 0.0), 0.0) - t27 * t74
    t76 = t63 * t63
    t77 = t75 - np.where(t61 != 0.0, np.where(t21 != 0.0, np.where(t61 != 0.0, np.where(t21 != 0.0, t31 * t76, 0.0), 0.0), 0.0), 0.0) - t33 * t74
    t78 = t7 * t15
    t79 = l1 * (c1 * tx + s1 * ty)
    t80 = l2 * (t2 * tx + t1 * ty)
    t81 = t68 * t78 + np.where(t44 != 0.0, np.where(t44 != 0.0, t69 * t79, 0.0), 0.0) + t68 * t80
    t82 = -3.0 * t71 * (t81 + np.where(t44 != 0.0, np.where(t44 != 0.0, t66 * (t40 * t58), 0.0), 0.0))
    t83 = t66 * t68
    t84 = t82 + np.where(t44 != 0.0, t78 * t83, 0.0) + np.where(t44 != 0.0, np.where(t44 != 0.0, np.where(t44 != 0.0, t79 * (t54 * t69), 0.0), 0.0), 0.0)
    t85 = 3.0 * t5
    t86 = t84 + np.where(t44 != 0.0, t80 * t83, 0.0) + np.where(t44 != 0.0, t68 * (t58 * t85), 0.0)
    t87 = t74 * t78 + np.where(t61 != 0.0, np.where(t21 != 0.0, np.where(t61 != 0.0, np.where(t21 != 0.0, t76 * t79, 0.0), 0.0), 0.0), 0.0)
    t88 = t87 + t74 * t80 + np.where(t61 != 0.0, np.where(t21 != 0.0, np.where(t61 != 0.0, np.where(t21 != 0.0, t72 * (t40 * t65), 0.0), 0.0), 0.0), 0.0)
    t89 = t72 * t74
    t90 = np.where(t21 != 0.0, np.where(t61 != 0.0, np.where(t21 != 0.0, np.where(t61 != 0.0, np.where(t21 != 0.0, t79 * (t63 * t76), 0.0), 0.0), 0.0), 0.0), 0.0)
    t91 = -3.0 * t77 * t88 + np.where(t61 != 0.0, np.where(t21 != 0.0, t78 * t89, 0.0), 0.0) + np.where(t61 != 0.0, t90, 0.0)
    t92 = t91 + np.where(t61 != 0.0, np.where(t21 != 0.0, t80 * t89, 0.0), 0.0) + np.where(t61 != 0.0, np.where(t21 != 0.0, t74 * (t65 * t85), 0.0), 0.0)

    # results
    rates = np.empty((*leading, 6), real)
    tracked = np.empty((*leading, 2), real)
    tracked_rate = np.empty((*leading, 2), real)
    parabola = np.empty((*leading, 3), real)
    discriminant = np.empty((*leading, 1), real)
    least = np.empty((*leading, 3), real)
    null = np.empty((*leading, 3), real)
    rates[..., 0] = np.where(t44 != 0.0, t54, 0.0)
    rates[..., 1] = np.where(t44 != 0.0, t56, 0.0)
    rates[..., 2] = np.where(t44 != 0.0, t58, 0.0)
    rates[..., 3] = np.where(t61 != 0.0, np.where(t21 != 0.0, t63, 0.0), 0.0)
    rates[..., 4] = np.where(t61 != 0.0, np.where(t21 != 0.0, t64, 0.0), 0.0)
    rates[..., 5] = np.where(t61 != 0.0, np.where(t21 != 0.0, t65, 0.0), 0.0)
    tracked[..., 0] = t71
    tracked[..., 1] = t77
    tracked_rate[..., 0] = -t86
    tracked_rate[..., 1] = -t92
    parabola[..., 0] = t34
    parabola[..., 1] = t43
    parabola[..., 2] = t48
    discriminant[..., 0] = t50
    least[..., 0] = t45
    least[..., 1] = t55
    least[..., 2] = t57
    null[..., 0] = np.where(t21 != 0.0, t24, 0.0)
    null[..., 1] = np.where(t21 != 0.0, t25, 0.0)
    null[..., 2] = np.where(t21 != 0.0, t23, 0.0)
    return rates.reshape(leading + (2, 3)), tracked.reshape(leading + (2,)), tracked_rate.reshape(leading + (2,)), parabola.reshape(leading + (3,)), discriminant.reshape(leading), least.reshape(leading + (3,)), null.reshape(leading + (3,))
