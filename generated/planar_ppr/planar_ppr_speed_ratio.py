"""speed ratio of planar_ppr, in NumPy.

Made from templates/kernel.py.j2; inputs cbe6ca84f20a33b7564517e79ef72ef22152d24e1262fcbafca631396bd75808.
783 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 149 operations.

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
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    _real = np.result_type(q, parameters, tangent, curvature, np.float32)

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
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]

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
    t23 = l1 + q1
    t24 = l2 + q2
    t25 = 1.4210854715202004e-14 * np.sqrt((t23 * t23 + t24 * t24 + l3 * l3))
    t26 = 0.5 - 0.5 * np.copysign(1, t25 - np.copysign(t9, 1))
    t27 = 1 - t26
    t28 = t11 * t27 + t14 * t26
    t29 = t3 * t27 + t8 * t26
    t30 = 1.4210854715202004e-14 + t25 * t26 - 1.4210854715202004e-14 * t26 - np.copysign((-t29), 1)
    t31 = 0.5 - 0.5 * np.copysign(1, t30)
    t32 = t31 / (1 - t31 - t29 * t31)
    t33 = t32 * (t3 * t26 + t8 * t27)
    t34 = t11 * t26 + t14 * t27 + t28 * t33
    t35 = t34 * t34
    t36 = t10 * t32
    t37 = t18 + t28 * t36
    t38 = (t34 + t34) * t37
    t39 = t37 * t37
    t40 = t13 * t26
    t41 = t13 * t27 + t40 * (t33 * t33)
    t42 = t33 * (t36 * (t40 + t40))
    t43 = t40 * (t36 * t36)
    t44 = t42 * (t38 + t38) - t43 * (4 * t35) - t41 * (4 * t39)
    t45 = t42 * t42 - t43 * (4 * t41)

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
    a[..., 0] = t35
    a[..., 1] = t38
    a[..., 2] = t39
    b[..., 0] = t41
    b[..., 1] = t42
    b[..., 2] = t43
    C[..., 0] = t44
    D[..., 0] = t45
    discriminant[..., 0] = t45 + kappa * t44
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 149 operations.

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
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    _real = np.result_type(q, parameters, tangent, curvature, np.float32)

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
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]

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
    t23 = l1 + q1
    t24 = l2 + q2
    t25 = 1.4210854715202004e-14 * np.sqrt((t23 * t23 + t24 * t24 + l3 * l3))
    t26 = 0.5 - 0.5 * np.copysign(1, t25 - np.copysign(t9, 1))
    t27 = 1 - t26
    t28 = t11 * t27 + t14 * t26
    t29 = t1 * t27 + t8 * t26
    t30 = 1.4210854715202004e-14 + t25 * t26 - 1.4210854715202004e-14 * t26 - np.copysign((-t29), 1)
    t31 = 0.5 - 0.5 * np.copysign(1, t30)
    t32 = t31 / (1 - t31 - t29 * t31)
    t33 = t32 * (t1 * t26 + t8 * t27)
    t34 = t11 * t26 + t14 * t27 + t28 * t33
    t35 = t34 * t34
    t36 = t10 * t32
    t37 = t19 + t28 * t36
    t38 = (t34 + t34) * t37
    t39 = t37 * t37
    t40 = t13 * t26
    t41 = t13 * t27 + t40 * (t33 * t33)
    t42 = t33 * (t36 * (t40 + t40))
    t43 = t40 * (t36 * t36)
    t44 = t42 * (t38 + t38) - t43 * (4 * t35) - t41 * (4 * t39)
    t45 = t42 * t42 - t43 * (4 * t41)

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
    a[..., 0] = t35
    a[..., 1] = t38
    a[..., 2] = t39
    b[..., 0] = t41
    b[..., 1] = t42
    b[..., 2] = t43
    C[..., 0] = t44
    D[..., 0] = t45
    discriminant[..., 0] = t45 + kappa * t44
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 115 operations.

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
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    _real = np.result_type(q, parameters, tangent, curvature, np.float32)

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
    t23 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign(t5, 1))
    t24 = 1 - t23
    t25 = t11 * t24 + t13 * t23
    t26 = t1 * t24 + t4 * t23
    t27 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign((-t26), 1))
    t28 = t27 / (1 - t27 - t26 * t27)
    t29 = t11 * t23 + t13 * t24 + t25 * (t28 * (t1 * t23 + t4 * t24))
    t30 = t29 * t29
    t31 = t18 + t25 * (t10 * t28)
    t32 = t30 * (-4 * t21)

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
    a[..., 0] = t30
    a[..., 1] = (t29 + t29) * t31
    a[..., 2] = t31 * t31
    b[..., 0] = 0.0
    b[..., 1] = 0.0
    b[..., 2] = t21
    C[..., 0] = t32
    D[..., 0] = 0.0
    discriminant[..., 0] = kappa * t32
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_rates(q, parameters, tangent, curvature, leading):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 370 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
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
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    kappa = curvature[..., 0]
    leads3 = leading[..., 2]
    leads1 = leading[..., 0]
    leads2 = leading[..., 1]
    kappa_s = curvature[..., 1]

    # terms
    t1 = cos_heading1 * cos_heading2 - sin_heading1 * sin_heading2
    t2 = cos_heading1 * sin_heading2 + cos_heading2 * sin_heading1
    t3 = c3 * t1 - t2 * s3
    t4 = t3 * l3
    t5 = np.maximum(np.copysign(tx, 1), np.copysign(ty, 1))
    t6 = tx / t5
    t7 = ty / t5
    t8 = np.sqrt((t6 * t6 + t7 * t7))
    t9 = t6 / t8
    t10 = c3 * t2 + t1 * s3
    t11 = l3 * t10
    t12 = t7 / t8
    t13 = t4 * t9 + t11 * t12
    t14 = t4 * t12 - t9 * t11
    t15 = l1 + q1
    t16 = l2 + q2
    t17 = np.sqrt((t15 * t15 + t16 * t16 + l3 * l3))
    t18 = t17 + (0.5 + 0.5 * np.copysign(1, 7.888609052210118e-31 - np.copysign(t17, 1)))
    t19 = t18 * t18
    t20 = 1.4210854715202004e-14 * np.sqrt((t13 * t13 + t14 * t14 + (t19 + t19)))
    t21 = 1.7320508075688772 * t18
    t22 = t2 * t9 - t1 * t12
    t23 = cos_heading1 * t9 + sin_heading1 * t12
    t24 = sin_heading1 * t9 - cos_heading1 * t12
    t25 = t1 * t9 + t2 * t12
    t26 = t22 * t23 - t24 * t25
    t27 = t26 * t26
    t28 = t13 * t25 - t14 * t22
    t29 = t28 * t28
    t30 = t14 * t24 - t13 * t23
    t31 = t30 * t30
    t32 = np.sqrt((t27 + t29 / t19 + t31 / t19))
    t33 = 0.5 - 0.5 * np.copysign(1, t20 * t21 - np.copysign((t19 * t32), 1))
    t34 = 1 - t33
    t35 = t33 / (t34 + t33 * np.sqrt((t27 + (t29 + t31))))
    t36 = t26 * t35
    t37 = t30 * t35
    t38 = t35 * (t22 * t36 - t13 * t37)
    t39 = t28 * t35
    t40 = t20 * t33 / t19 * (t21 * t21) / (t34 + t32 * t33)
    t41 = t32 * t35
    t42 = t40 * (t41 * t41)
    t43 = t9 * t10 - t3 * t12
    t44 = l3 * t43
    t45 = t44 * (t36 * t36)
    t46 = -t45
    t47 = np.copysign(t46, 1)
    t48 = 0.5 - 0.5 * np.copysign(1, t42 - t47)
    t49 = t35 * (t24 * t37 - t22 * t39)
    t50 = t49 * t49
    t51 = t35 * (t13 * t39 - t24 * t36)
    t52 = t50 + t38 * t38 / t19 + t51 * t51 / t19
    t53 = np.sqrt(t52)
    t54 = t40 * (t41 * (t53 + t53))
    t55 = t36 * (t49 * (l3 * (-2 * t43)))
    t56 = np.copysign(t55, 1)
    t57 = t40 * t52
    t58 = t44 * t50
    t59 = t58 + kappa
    t60 = np.copysign((-t59), 1)
    t61 = (t54 + t54) * t56 + t47 * (4 * t57) + 4 * t42 * t60
    t62 = t55 * t55 - t45 * (4 * t59)
    t63 = np.maximum(0.0, t62)
    t64 = t48 * (0.5 - 0.5 * np.copysign(1, t61 - np.copysign(t63, 1)))
    t65 = 1 - t64
    t66 = 0.5 - 0.5 * np.copysign(1, t54 - t56)
    t67 = 1 - t48
    t68 = t66 * t67
    t69 = t59 * t68 / (1 - t68 + t55 * t68) - t48 * t55 / (t67 - t45 * (t48 + t48))
    t70 = t64 * (-0.5 * t55 - 0.5 * np.copysign(np.sqrt(t63), t55))
    t71 = t65 * t69 - t59 * t64 / (t65 + t70)
    t72 = t33 * (t38 + t39 * t71)
    t73 = t33 * (t51 + t37 * t71)
    t74 = t33 * (t49 + t36 * t71)
    t75 = t33 * t64
    t76 = t70 / (t65 - t45 * t64)
    t77 = t75 * (t38 + t39 * t76)
    t78 = t75 * (t51 + t37 * t76)
    t79 = t75 * (t49 + t36 * t76)
    t80 = np.maximum(np.maximum(np.copysign(t74, 1), np.copysign((t72 / t18), 1)), np.copysign((t73 / t18), 1))
    t81 = leads3 + t18 * leads1 + t18 * leads2
    t82 = t72 * leads1 + t73 * leads2 + t74 * leads3
    t83 = 0.5 - 0.5 * np.copysign(1, 9.094947017729282e-13 * t80 * t81 - np.copysign(t82, 1))
    t84 = 1 - t83
    t85 = t83 / (t84 + t82 * t83)
    t86 = 1 - leads1
    t87 = 1 - leads3
    t88 = np.maximum(np.maximum(np.copysign(t79, 1), np.copysign((t77 / t18), 1)), np.copysign((t78 / t18), 1))
    t89 = t77 * leads1 + t78 * leads2 + t79 * leads3
    t90 = 0.5 - 0.5 * np.copysign(1, t81 * (9.094947017729282e-13 * t88) - np.copysign(t89, 1))
    t91 = 1 - t90
    t92 = t90 / (t91 + t89 * t90)
    t93 = t74 * t74
    t94 = t44 * t93
    t95 = t79 * t79
    t96 = t44 * t95
    t97 = t3 * t9 + t10 * t12
    t98 = 3 * t97
    t99 = l3 * t97
    t100 = t93 * (l3 * (t94 * t98)) + t99 * (t74 * t93)
    t101 = t95 * (l3 * (t96 * t98)) + t99 * (t79 * t95)
    t102 = 0.5 - 0.5 * np.copysign(1, t61 - np.copysign(np.maximum(0.0, -t62), 1))
    t103 = t48 * t102
    t104 = 4 + t33 * (t48 * t103 + t67 * (2 + t66)) - 4 * t33
    t105 = np.copysign((-(t101 + kappa_s)), 1) - np.copysign((-(t100 + kappa_s)), 1)
    t106 = t67 * (1 - t66) * (0.5 + 0.5 * np.copysign(1, t57 - t60))

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
    rates[..., 0] = t72
    rates[..., 1] = t73
    rates[..., 2] = t74
    rates[..., 3] = t77
    rates[..., 4] = t78
    rates[..., 5] = t79
    ratios[..., 0] = t85 * (t73 * leads1 + t72 * t86)
    ratios[..., 1] = t85 * (t73 * leads3 + t74 * t87)
    ratios[..., 2] = t92 * (t78 * leads1 + t77 * t86)
    ratios[..., 3] = t92 * (t78 * leads3 + t79 * t87)
    tracked[..., 0] = -t94
    tracked[..., 1] = -t96
    tracked_rate[..., 0] = -t100
    tracked_rate[..., 1] = -t101
    verdict[..., 0] = t104
    verdict[..., 1] = t33 * (1 + t64)
    verdict[..., 2] = t64 * (0.5 * t33) * (1 - np.copysign(1, t105))
    verdict[..., 3] = t33 * (t68 + t48 * (1 - t103) + t106)
    verdict[..., 4] = t75 * t91 + t33 * t84
    parabola[..., 0] = t46
    parabola[..., 1] = t55
    parabola[..., 2] = -t58
    slack[..., 0] = t62
    least[..., 0] = t38
    least[..., 1] = t51
    least[..., 2] = t49
    null[..., 0] = t39
    null[..., 1] = t37
    null[..., 2] = t36
    return rates.reshape(_leading + (2, 3)), ratios.reshape(_leading + (2, 2)), tracked.reshape(_leading + (2,)), tracked_rate.reshape(_leading + (2,)), verdict.reshape(_leading + (5,)), parabola.reshape(_leading + (3,)), slack.reshape(_leading), least.reshape(_leading + (3,)), null.reshape(_leading + (3,))
