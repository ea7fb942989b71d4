"""speed ratio of planar_rpp, in NumPy.

Made from templates/kernel.py.j2; inputs a64aa6058ab7fb874544f2f2beeb62d5d04fb91ade025d6faa026b85e9bf9f5a.
953 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 156 operations.

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
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    _real = np.result_type(q, parameters, tangent, curvature, np.float32)

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
    t27 = np.sqrt((2.0 + t8 * t8 + t9 * t9 + l1 * l1))
    t28 = 1.4210854715202004e-14 * t27
    t29 = 0.5 - 0.5 * np.copysign(1.0, t28 - np.copysign(t7, 1.0))
    t30 = 1.0 - t29
    t31 = t13 * t30 + t15 * t29
    t32 = t3 * t30 + t6 * t29
    t33 = 0.5 - 0.5 * np.copysign(1.0, t28 - np.copysign((-t32), 1.0))
    t34 = t33 / (1.0 - t33 - t32 * t33)
    t35 = t34 * (t3 * t29 + t6 * t30)
    t36 = t13 * t29 + t15 * t30 + t31 * t35
    t37 = t36 * t36
    t38 = t12 * t34
    t39 = t20 + t31 * t38
    t40 = (t36 + t36) * t39
    t41 = t18 * t30 + t23 * t29
    t42 = t18 * t29 + t23 * t30 + t35 * t41
    t43 = t25 + t38 * t41
    t44 = t42 * (t40 + t40) - t43 * (4.0 * t37)
    t45 = t42 * t42

    # results
    A = np.empty((*_leading, 3), _real)
    B = np.empty((*_leading, 6), _real)
    B0 = np.empty((*_leading, 6), _real)
    B1 = np.empty((*_leading, 6), _real)
    a = np.empty((*_leading, 3), _real)
    b = np.empty((*_leading, 3), _real)
    C = np.empty((*_leading, 1), _real)
    D = np.empty((*_leading, 1), _real)
    discriminant = np.empty((*_leading, 1), _real)
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
    a[..., 0] = t37
    a[..., 1] = t40
    a[..., 2] = t39 * t39
    b[..., 0] = 0.0
    b[..., 1] = t42
    b[..., 2] = t43
    C[..., 0] = t44
    D[..., 0] = t45
    discriminant[..., 0] = t45 + kappa * t44
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 173 operations.

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
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    _real = np.result_type(q, parameters, tangent, curvature, np.float32)

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
    t27 = np.sqrt((2.0 + t2 * t2 + t5 * t5 + l1 * l1))
    t28 = 1.4210854715202004e-14 * t27
    t29 = 0.5 - 0.5 * np.copysign(1.0, t28 - np.copysign(t11, 1.0))
    t30 = 1.0 - t29
    t31 = t14 * t30 + t16 * t29
    t32 = t9 * t30 + t10 * t29
    t33 = 0.5 - 0.5 * np.copysign(1.0, t28 - np.copysign((-t32), 1.0))
    t34 = t33 / (1.0 - t33 - t32 * t33)
    t35 = t34 * (t9 * t29 + t10 * t30)
    t36 = t14 * t29 + t16 * t30 + t31 * t35
    t37 = t36 * t36
    t38 = t12 * t34
    t39 = t22 + t31 * t38
    t40 = (t36 + t36) * t39
    t41 = t39 * t39
    t42 = t13 * t30
    t43 = t13 * t29 + t42 * (t35 * t35) + t18 * t35
    t44 = t23 * t29 + t35 * (t38 * (t42 + t42)) + t18 * t38
    t45 = t23 * t30
    t46 = t44 + t35 * t45
    t47 = t42 * (t38 * t38) + t38 * t45
    t48 = t46 * (t40 + t40) - t47 * (4.0 * t37) - t43 * (4.0 * t41)
    t49 = t46 * t46 - t47 * (4.0 * t43)

    # results
    A = np.empty((*_leading, 3), _real)
    B = np.empty((*_leading, 6), _real)
    B0 = np.empty((*_leading, 6), _real)
    B1 = np.empty((*_leading, 6), _real)
    a = np.empty((*_leading, 3), _real)
    b = np.empty((*_leading, 3), _real)
    C = np.empty((*_leading, 1), _real)
    D = np.empty((*_leading, 1), _real)
    discriminant = np.empty((*_leading, 1), _real)
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
    a[..., 0] = t37
    a[..., 1] = t40
    a[..., 2] = t41
    b[..., 0] = t43
    b[..., 1] = t46
    b[..., 2] = t47
    C[..., 0] = t48
    D[..., 0] = t49
    discriminant[..., 0] = t49 + kappa * t48
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 173 operations.

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
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    _real = np.result_type(q, parameters, tangent, curvature, np.float32)

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
    t27 = np.sqrt((2.0 + t2 * t2 + t5 * t5 + l1 * l1))
    t28 = 1.4210854715202004e-14 * t27
    t29 = 0.5 - 0.5 * np.copysign(1.0, t28 - np.copysign(t11, 1.0))
    t30 = 1.0 - t29
    t31 = t14 * t30 + t16 * t29
    t32 = t9 * t30 + t10 * t29
    t33 = 0.5 - 0.5 * np.copysign(1.0, t28 - np.copysign((-t32), 1.0))
    t34 = t33 / (1.0 - t33 - t32 * t33)
    t35 = t34 * (t9 * t29 + t10 * t30)
    t36 = t14 * t29 + t16 * t30 + t31 * t35
    t37 = t36 * t36
    t38 = t12 * t34
    t39 = t22 + t31 * t38
    t40 = (t36 + t36) * t39
    t41 = t39 * t39
    t42 = t13 * t30
    t43 = t13 * t29 + t42 * (t35 * t35) + t18 * t35
    t44 = t23 * t29 + t35 * (t38 * (t42 + t42)) + t18 * t38
    t45 = t23 * t30
    t46 = t44 + t35 * t45
    t47 = t42 * (t38 * t38) + t38 * t45
    t48 = t46 * (t40 + t40) - t47 * (4.0 * t37) - t43 * (4.0 * t41)
    t49 = t46 * t46 - t47 * (4.0 * t43)

    # results
    A = np.empty((*_leading, 3), _real)
    B = np.empty((*_leading, 6), _real)
    B0 = np.empty((*_leading, 6), _real)
    B1 = np.empty((*_leading, 6), _real)
    a = np.empty((*_leading, 3), _real)
    b = np.empty((*_leading, 3), _real)
    C = np.empty((*_leading, 1), _real)
    D = np.empty((*_leading, 1), _real)
    discriminant = np.empty((*_leading, 1), _real)
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
    a[..., 0] = t37
    a[..., 1] = t40
    a[..., 2] = t41
    b[..., 0] = t43
    b[..., 1] = t46
    b[..., 2] = t47
    C[..., 0] = t48
    D[..., 0] = t49
    discriminant[..., 0] = t49 + kappa * t48
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_rates(q, parameters, tangent, curvature, leading):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 451 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
    in   tangent[2] = (tx, ty)
    in   curvature[2] = (kappa, kappa_s)
    in   leading[3] = (leads1, leads2, leads3)
    out  rates[2][3]
    out  ratios[2][2]
    out  tracked[2]
    out  tracked_rate[2]
    out  verdict[5]
    out  parabola[3]
    out  slack (one number)
    out  least[3]
    out  null[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    tangent = np.asarray(tangent)
    curvature = np.asarray(curvature)
    leading = np.asarray(leading)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1], leading.shape[:-1])
    _real = np.result_type(q, parameters, tangent, curvature, leading, np.float32)

    # inputs, sines and cosines
    tx = tangent[..., 0]
    ty = tangent[..., 1]
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
    kappa = curvature[..., 0]
    leads1 = leading[..., 0]
    leads2 = leading[..., 1]
    leads3 = leading[..., 2]
    kappa_s = curvature[..., 1]

    # terms
    t1 = np.maximum(np.copysign(tx, 1.0), np.copysign(ty, 1.0))
    t2 = tx / t1
    t3 = ty / t1
    t4 = np.sqrt((t2 * t2 + t3 * t3))
    t5 = t2 / t4
    t6 = c1 * cos_heading2 - s1 * sin_heading2
    t7 = l2 + q2
    t8 = c1 * sin_heading2 + cos_heading2 * s1
    t9 = t6 * cos_heading3 - t8 * sin_heading3
    t10 = l3 + q3
    t11 = c1 * l1 + t6 * t7 + t9 * t10
    t12 = t3 / t4
    t13 = cos_heading3 * t8 + t6 * sin_heading3
    t14 = l1 * s1 + t7 * t8 + t10 * t13
    t15 = t5 * t11 + t12 * t14
    t16 = t5 * t8 - t6 * t12
    t17 = t5 * t13 - t9 * t12
    t18 = t11 * t12 - t5 * t14
    t19 = t15 * t15 + t16 * t16 + t17 * t17 + t18 * t18
    t20 = t5 * t6 + t8 * t12
    t21 = t5 * t9 + t12 * t13
    t22 = np.sqrt((t19 + t20 * t20 + t21 * t21))
    t23 = 2.0 + t7 * t7 + t10 * t10 + l1 * l1
    t24 = t17 * t20 - t16 * t21
    t25 = t15 * t21 - t17 * t18
    t26 = t16 * t18 - t15 * t20
    t27 = np.sqrt((t24 * t24 + t25 * t25 + t26 * t26))
    t28 = 0.5 * np.copysign(1.0, 1.4210854715202004e-14 * t22 * np.sqrt(t23) - np.copysign(t27, 1.0))
    t29 = 0.5 - t28
    t30 = t29 / (1.0 - t29 + t27 * t29)
    t31 = t26 * t30
    t32 = t25 * t30
    t33 = t30 * (t16 * t31 - t17 * t32)
    t34 = t24 * t30
    t35 = t20 + t20
    t36 = t30 * (t17 * t34 - t15 * t31)
    t37 = t21 + t21
    t38 = t30 * (t15 * t32 - t16 * t34)
    t39 = t7 * t16
    t40 = t33 * t33
    t41 = t33 * t35 * t36 + t33 * t37 * t38 - t39 * t40
    t42 = t10 * t17
    t43 = t5 * s1 - c1 * t12
    t44 = l1 * t43
    t45 = t41 - t40 * t42 - t40 * t44
    t46 = t45 - kappa
    t47 = t23 * (t22 * (1.4210854715202004e-14 * t30))
    t48 = t34 * t34
    t49 = t32 * (t34 * t35) + t31 * (t34 * t37) - t39 * t48
    t50 = t49 - t42 * t48 - t44 * t48
    t51 = np.copysign(t50, 1.0)
    t52 = 0.5 - 0.5 * np.copysign(1.0, t47 - t51)
    t53 = t40 + t36 * t36 + t38 * t38
    t54 = np.sqrt(t53)
    t55 = t47 * (t54 + t54)
    t56 = t35 * (t32 * t33 + t34 * t36) + t37 * (t31 * t33 + t34 * t38)
    t57 = t16 + t16
    t58 = t17 + t17
    t59 = t56 - t34 * (t33 * (t7 * t57)) - t34 * (t33 * (t10 * t58))
    t60 = t59 - t34 * (t33 * (l1 * (t43 + t43)))
    t61 = np.copysign(t60, 1.0)
    t62 = t47 * t53
    t63 = np.copysign(t46, 1.0)
    t64 = (t55 + t55) * t61 + t51 * (4.0 * t62) + 4.0 * t47 * t63
    t65 = t60 * t60 - t50 * (4.0 * t46)
    t66 = np.maximum(0.0, t65)
    t67 = t52 * (0.5 - 0.5 * np.copysign(1.0, t64 - np.copysign(t66, 1.0)))
    t68 = 1.0 - t67
    t69 = t67 * (-0.5 * t60 - 0.5 * np.copysign(np.sqrt(t66), t60))
    t70 = 1.0 - t52
    t71 = 0.5 - 0.5 * np.copysign(1.0, t55 - t61)
    t72 = t70 * t71
    t73 = t52 * t60 / (t70 + t50 * (t52 + t52)) + t46 * t72 / (1.0 - t72 + t60 * t72)
    t74 = t46 * t67 / (t68 + t69) - t68 * t73
    t75 = t29 * (t33 + t34 * t74)
    t76 = t29 * (t36 + t32 * t74)
    t77 = t29 * (t38 + t31 * t74)
    t78 = t29 * t67
    t79 = t69 / (t68 + t50 * t67)
    t80 = t78 * (t33 + t34 * t79)
    t81 = t78 * (t36 + t32 * t79)
    t82 = t78 * (t38 + t31 * t79)
    t83 = t75 * leads1 + t76 * leads2 + t77 * leads3
    t84 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t75, 1.0), np.copysign(t76, 1.0)), np.copysign(t77, 1.0)) - np.copysign(t83, 1.0)
    t85 = 0.5 - 0.5 * np.copysign(1.0, t84)
    t86 = 1.0 - t85
    t87 = t85 / (t86 + t83 * t85)
    t88 = t80 * leads1 + t81 * leads2 + t82 * leads3
    t89 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t80, 1.0), np.copysign(t81, 1.0)), np.copysign(t82, 1.0)) - np.copysign(t88, 1.0)
    t90 = 0.5 - 0.5 * np.copysign(1.0, t89)
    t91 = 1.0 - t90
    t92 = t90 / (t91 + t88 * t90)
    t93 = t75 * t75
    t94 = t76 * (t35 * t75) + t77 * (t37 * t75) - t39 * t93
    t95 = t94 - t42 * t93 - t44 * t93
    t96 = t80 * t80
    t97 = t81 * (t35 * t80) + t82 * (t37 * t80) - t39 * t96
    t98 = t97 - t42 * t96 - t44 * t96
    t99 = t7 * t20
    t100 = t10 * t21
    t101 = l1 * (t5 * c1 + s1 * t12)
    t102 = t93 * t99 + t93 * t100 + t93 * t101 + t76 * (t57 * t75)
    t103 = t75 * t93
    t104 = -3.0 * t95 * (t102 + t77 * (t58 * t75)) + t99 * t103
    t105 = 3.0 * t16
    t106 = t104 + t100 * t103 + t101 * t103 + t93 * (t76 * t105)
    t107 = 3.0 * t17
    t108 = t106 + t93 * (t77 * t107)
    t109 = t96 * t99 + t96 * t100 + t96 * t101 + t81 * (t57 * t80)
    t110 = t80 * t96
    t111 = -3.0 * t98 * (t109 + t82 * (t58 * t80)) + t99 * t110
    t112 = t111 + t100 * t110 + t101 * t110 + t96 * (t81 * t105)
    t113 = t112 + t96 * (t82 * t107)
    t114 = 0.5 - 0.5 * np.copysign(1.0, t64 - np.copysign(np.maximum(0.0, -t65), 1.0))
    t115 = t52 * t114
    t116 = 4.0 + t29 * (t52 * t115 + t70 * (2.0 + t71)) - 4.0 * t29
    t117 = np.copysign((-(t113 + kappa_s)), 1.0) - np.copysign((-(t108 + kappa_s)), 1.0)
    t118 = t70 * (1.0 - t71) * (0.5 + 0.5 * np.copysign(1.0, t62 - t63))

    # results
    rates = np.empty((*_leading, 6), _real)
    ratios = np.empty((*_leading, 4), _real)
    tracked = np.empty((*_leading, 2), _real)
    tracked_rate = np.empty((*_leading, 2), _real)
    verdict = np.empty((*_leading, 5), _real)
    parabola = np.empty((*_leading, 3), _real)
    slack = np.empty((*_leading, 1), _real)
    least = np.empty((*_leading, 3), _real)
    null = np.empty((*_leading, 3), _real)
    rates[..., 0] = t75
    rates[..., 1] = t76
    rates[..., 2] = t77
    rates[..., 3] = t80
    rates[..., 4] = t81
    rates[..., 5] = t82
    ratios[..., 0] = t87 * (t75 + leads1 * (t76 - t75))
    ratios[..., 1] = t87 * (t77 + leads3 * (t76 - t77))
    ratios[..., 2] = t92 * (t80 + leads1 * (t81 - t80))
    ratios[..., 3] = t92 * (t82 + leads3 * (t81 - t82))
    tracked[..., 0] = t95
    tracked[..., 1] = t98
    tracked_rate[..., 0] = -t108
    tracked_rate[..., 1] = -t113
    verdict[..., 0] = t116
    verdict[..., 1] = t29 * (1.0 + t67)
    verdict[..., 2] = t67 * (0.5 * t29) * (1.0 - np.copysign(1.0, t117))
    verdict[..., 3] = t29 * (t72 + t52 * (1.0 - t115) + t118)
    verdict[..., 4] = t78 * t91 + t29 * t86
    parabola[..., 0] = t50
    parabola[..., 1] = t60
    parabola[..., 2] = t45
    slack[..., 0] = t65
    least[..., 0] = t33
    least[..., 1] = t36
    least[..., 2] = t38
    null[..., 0] = t34
    null[..., 1] = t32
    null[..., 2] = t31
    return rates.reshape(_leading + (2, 3)), ratios.reshape(_leading + (2, 2)), tracked.reshape(_leading + (2,)), tracked_rate.reshape(_leading + (2,)), verdict.reshape(_leading + (5,)), parabola.reshape(_leading + (3,)), slack.reshape(_leading), least.reshape(_leading + (3,)), null.reshape(_leading + (3,))
