"""speed ratio of planar_ppr, in NumPy.

Made from templates/kernel.py.j2; inputs a08dc414f36d9222eab60f32f0bb2b11193752e23147baa2c567396cd00b468b.
758 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 146 operations.

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
    t25 = np.sqrt((2.0 + t23 * t23 + t24 * t24 + l3 * l3))
    t26 = 1.4210854715202004e-14 * t25
    t27 = 0.5 - 0.5 * np.copysign(1.0, t26 - np.copysign(t9, 1.0))
    t28 = 1.0 - t27
    t29 = t11 * t28 + t14 * t27
    t30 = t3 * t28 + t8 * t27
    t31 = 0.5 - 0.5 * np.copysign(1.0, t26 - np.copysign((-t30), 1.0))
    t32 = t31 / (1.0 - t31 - t30 * t31)
    t33 = t32 * (t3 * t27 + t8 * t28)
    t34 = t11 * t27 + t14 * t28 + t29 * t33
    t35 = t34 * t34
    t36 = t10 * t32
    t37 = t18 + t29 * t36
    t38 = (t34 + t34) * t37
    t39 = t37 * t37
    t40 = t13 * t27
    t41 = t13 * t28 + t40 * (t33 * t33)
    t42 = t33 * (t36 * (t40 + t40))
    t43 = t40 * (t36 * t36)
    t44 = t42 * (t38 + t38) - t43 * (4.0 * t35) - t41 * (4.0 * t39)
    t45 = t42 * t42 - t43 * (4.0 * t41)

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
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 146 operations.

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
    t25 = np.sqrt((2.0 + t23 * t23 + t24 * t24 + l3 * l3))
    t26 = 1.4210854715202004e-14 * t25
    t27 = 0.5 - 0.5 * np.copysign(1.0, t26 - np.copysign(t9, 1.0))
    t28 = 1.0 - t27
    t29 = t11 * t28 + t14 * t27
    t30 = t1 * t28 + t8 * t27
    t31 = 0.5 - 0.5 * np.copysign(1.0, t26 - np.copysign((-t30), 1.0))
    t32 = t31 / (1.0 - t31 - t30 * t31)
    t33 = t32 * (t1 * t27 + t8 * t28)
    t34 = t11 * t27 + t14 * t28 + t29 * t33
    t35 = t34 * t34
    t36 = t10 * t32
    t37 = t19 + t29 * t36
    t38 = (t34 + t34) * t37
    t39 = t37 * t37
    t40 = t13 * t27
    t41 = t13 * t28 + t40 * (t33 * t33)
    t42 = t33 * (t36 * (t40 + t40))
    t43 = t40 * (t36 * t36)
    t44 = t42 * (t38 + t38) - t43 * (4.0 * t35) - t41 * (4.0 * t39)
    t45 = t42 * t42 - t43 * (4.0 * t41)

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
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 125 operations.

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
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]

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
    t23 = l1 + q1
    t24 = l2 + q2
    t25 = np.sqrt((2.0 + t23 * t23 + t24 * t24 + l3 * l3))
    t26 = 1.4210854715202004e-14 * t25
    t27 = 0.5 - 0.5 * np.copysign(1.0, t26 - np.copysign(t5, 1.0))
    t28 = 1.0 - t27
    t29 = t11 * t28 + t13 * t27
    t30 = t1 * t28 + t4 * t27
    t31 = 0.5 - 0.5 * np.copysign(1.0, t26 - np.copysign((-t30), 1.0))
    t32 = t31 / (1.0 - t31 - t30 * t31)
    t33 = t11 * t27 + t13 * t28 + t29 * (t32 * (t1 * t27 + t4 * t28))
    t34 = t33 * t33
    t35 = t18 + t29 * (t10 * t32)
    t36 = t34 * (-4.0 * t21)

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
    a[..., 0] = t34
    a[..., 1] = (t33 + t33) * t35
    a[..., 2] = t35 * t35
    b[..., 0] = 0.0
    b[..., 1] = 0.0
    b[..., 2] = t21
    C[..., 0] = t36
    D[..., 0] = 0.0
    discriminant[..., 0] = kappa * t36
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_rates(q, parameters, tangent, curvature, leading):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 341 operations.

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
    heading1 = parameters[..., 3]
    sin_heading1 = np.sin(heading1)
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    cos_heading1 = np.cos(heading1)
    heading2 = parameters[..., 4]
    sin_heading2 = np.sin(heading2)
    cos_heading2 = np.cos(heading2)
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
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
    t6 = t3 / t4
    t7 = sin_heading1 * t5 - cos_heading1 * t6
    t8 = cos_heading1 * sin_heading2 + sin_heading1 * cos_heading2
    t9 = cos_heading1 * cos_heading2 - sin_heading1 * sin_heading2
    t10 = t5 * t8 - t6 * t9
    t11 = t9 * c3 - t8 * s3
    t12 = t11 * l3
    t13 = t8 * c3 + t9 * s3
    t14 = l3 * t13
    t15 = t5 * t12 + t6 * t14
    t16 = t5 * cos_heading1 + sin_heading1 * t6
    t17 = t7 * t7 + t10 * t10 + t15 * t15 + t16 * t16
    t18 = t5 * t9 + t6 * t8
    t19 = t6 * t12 - t5 * t14
    t20 = np.sqrt((t17 + t18 * t18 + t19 * t19))
    t21 = l1 + q1
    t22 = l2 + q2
    t23 = 2.0 + t21 * t21 + t22 * t22 + l3 * l3
    t24 = t15 * t18 - t10 * t19
    t25 = t7 * t19 - t15 * t16
    t26 = t10 * t16 - t7 * t18
    t27 = np.sqrt((t24 * t24 + t25 * t25 + t26 * t26))
    t28 = 0.5 * np.copysign(1.0, 1.4210854715202004e-14 * t20 * np.sqrt(t23) - np.copysign(t27, 1.0))
    t29 = 0.5 - t28
    t30 = t29 / (1.0 - t29 + t27 * t29)
    t31 = t26 * t30
    t32 = t25 * t30
    t33 = t30 * (t10 * t31 - t15 * t32)
    t34 = t24 * t30
    t35 = t23 * (t20 * (1.4210854715202004e-14 * t30))
    t36 = t5 * t13 - t6 * t11
    t37 = l3 * t36
    t38 = t37 * (t31 * t31)
    t39 = -t38
    t40 = np.copysign(t39, 1.0)
    t41 = 0.5 - 0.5 * np.copysign(1.0, t35 - t40)
    t42 = t30 * (t15 * t34 - t7 * t31)
    t43 = t30 * (t7 * t32 - t10 * t34)
    t44 = t43 * t43
    t45 = t33 * t33 + t42 * t42 + t44
    t46 = np.sqrt(t45)
    t47 = t35 * (t46 + t46)
    t48 = t31 * (t43 * (l3 * (-2.0 * t36)))
    t49 = np.copysign(t48, 1.0)
    t50 = t35 * t45
    t51 = t37 * t44
    t52 = t51 + kappa
    t53 = np.copysign((-t52), 1.0)
    t54 = (t47 + t47) * t49 + t40 * (4.0 * t50) + 4.0 * t35 * t53
    t55 = t48 * t48 - t38 * (4.0 * t52)
    t56 = np.maximum(0.0, t55)
    t57 = t41 * (0.5 - 0.5 * np.copysign(1.0, t54 - np.copysign(t56, 1.0)))
    t58 = 1.0 - t57
    t59 = 0.5 - 0.5 * np.copysign(1.0, t47 - t49)
    t60 = 1.0 - t41
    t61 = t59 * t60
    t62 = t52 * t61 / (1.0 - t61 + t48 * t61) - t41 * t48 / (t60 - t38 * (t41 + t41))
    t63 = t57 * (-0.5 * t48 - 0.5 * np.copysign(np.sqrt(t56), t48))
    t64 = t58 * t62 - t52 * t57 / (t58 + t63)
    t65 = t29 * (t33 + t34 * t64)
    t66 = t29 * (t42 + t32 * t64)
    t67 = t29 * (t43 + t31 * t64)
    t68 = t29 * t57
    t69 = t63 / (t58 - t38 * t57)
    t70 = t68 * (t33 + t34 * t69)
    t71 = t68 * (t42 + t32 * t69)
    t72 = t68 * (t43 + t31 * t69)
    t73 = t65 * leads1 + t66 * leads2 + t67 * leads3
    t74 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t65, 1.0), np.copysign(t66, 1.0)), np.copysign(t67, 1.0)) - np.copysign(t73, 1.0)
    t75 = 0.5 - 0.5 * np.copysign(1.0, t74)
    t76 = 1.0 - t75
    t77 = t75 / (t76 + t73 * t75)
    t78 = t70 * leads1 + t71 * leads2 + t72 * leads3
    t79 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t70, 1.0), np.copysign(t71, 1.0)), np.copysign(t72, 1.0)) - np.copysign(t78, 1.0)
    t80 = 0.5 - 0.5 * np.copysign(1.0, t79)
    t81 = 1.0 - t80
    t82 = t80 / (t81 + t78 * t80)
    t83 = t67 * t67
    t84 = t37 * t83
    t85 = t72 * t72
    t86 = t37 * t85
    t87 = t5 * t11 + t6 * t13
    t88 = 3.0 * t87
    t89 = l3 * t87
    t90 = t83 * (l3 * (t84 * t88)) + t89 * (t67 * t83)
    t91 = t85 * (l3 * (t86 * t88)) + t89 * (t72 * t85)
    t92 = 0.5 - 0.5 * np.copysign(1.0, t54 - np.copysign(np.maximum(0.0, -t55), 1.0))
    t93 = t41 * t92
    t94 = 4.0 + t29 * (t41 * t93 + t60 * (2.0 + t59)) - 4.0 * t29
    t95 = np.copysign((-(t91 + kappa_s)), 1.0) - np.copysign((-(t90 + kappa_s)), 1.0)
    t96 = t60 * (1.0 - t59) * (0.5 + 0.5 * np.copysign(1.0, t50 - t53))

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
    rates[..., 0] = t65
    rates[..., 1] = t66
    rates[..., 2] = t67
    rates[..., 3] = t70
    rates[..., 4] = t71
    rates[..., 5] = t72
    ratios[..., 0] = t77 * (t65 + leads1 * (t66 - t65))
    ratios[..., 1] = t77 * (t67 + leads3 * (t66 - t67))
    ratios[..., 2] = t82 * (t70 + leads1 * (t71 - t70))
    ratios[..., 3] = t82 * (t72 + leads3 * (t71 - t72))
    tracked[..., 0] = -t84
    tracked[..., 1] = -t86
    tracked_rate[..., 0] = -t90
    tracked_rate[..., 1] = -t91
    verdict[..., 0] = t94
    verdict[..., 1] = t29 * (1.0 + t57)
    verdict[..., 2] = t57 * (0.5 * t29) * (1.0 - np.copysign(1.0, t95))
    verdict[..., 3] = t29 * (t61 + t41 * (1.0 - t93) + t96)
    verdict[..., 4] = t68 * t81 + t29 * t76
    parabola[..., 0] = t39
    parabola[..., 1] = t48
    parabola[..., 2] = -t51
    slack[..., 0] = t55
    least[..., 0] = t33
    least[..., 1] = t42
    least[..., 2] = t43
    null[..., 0] = t34
    null[..., 1] = t32
    null[..., 2] = t31
    return rates.reshape(_leading + (2, 3)), ratios.reshape(_leading + (2, 2)), tracked.reshape(_leading + (2,)), tracked_rate.reshape(_leading + (2,)), verdict.reshape(_leading + (5,)), parabola.reshape(_leading + (3,)), slack.reshape(_leading), least.reshape(_leading + (3,)), null.reshape(_leading + (3,))
