"""speed ratio of planar_prr, in NumPy.

Made from templates/kernel.py.j2; inputs 562e9d44e5303a69a8651f2168682fabcb3eaf445dd30ac37a12729f5d947a4c.
932 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 171 operations.

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
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    _real = np.result_type(q, parameters, tangent, curvature, np.float32)

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
    t31 = 1.4210854715202004e-14 * np.sqrt((t1 * t1 + l2 * l2 + l3 * l3))
    t32 = 0.5 - 0.5 * np.copysign(1, t31 - np.copysign(t14, 1))
    t33 = 1 - t32
    t34 = t19 * t33 + t21 * t32
    t35 = t12 * t33 + t13 * t32
    t36 = 0.5 - 0.5 * np.copysign(1, t31 - np.copysign((-t35), 1))
    t37 = t36 / (1 - t36 - t35 * t36)
    t38 = t37 * (t12 * t32 + t13 * t33)
    t39 = t19 * t32 + t21 * t33 + t34 * t38
    t40 = t39 * t39
    t41 = t15 * t37
    t42 = t26 + t34 * t41
    t43 = (t39 + t39) * t42
    t44 = t42 * t42
    t45 = t18 * t33 + t17 * t32
    t46 = t18 * t32 + t17 * t33 + t45 * (t38 * t38) + t23 * t38
    t47 = t38 * (t41 * (t45 + t45)) + t23 * t41
    t48 = t45 * (t41 * t41)
    t49 = t47 * (t43 + t43) - t48 * (4 * t40) - t46 * (4 * t44)
    t50 = t47 * t47 - t48 * (4 * t46)

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
    a[..., 0] = t40
    a[..., 1] = t43
    a[..., 2] = t44
    b[..., 0] = t46
    b[..., 1] = t47
    b[..., 2] = t48
    C[..., 0] = t49
    D[..., 0] = t50
    discriminant[..., 0] = t50 + kappa * t49
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 175 operations.

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
    t31 = 1.4210854715202004e-14 * np.sqrt((t10 * t10 + l2 * l2 + l3 * l3))
    t32 = 0.5 - 0.5 * np.copysign(1, t31 - np.copysign(t9, 1))
    t33 = 1 - t32
    t34 = t16 * t33 + t20 * t32
    t35 = t1 * t33 + t8 * t32
    t36 = 1.4210854715202004e-14 + t31 * t32 - 1.4210854715202004e-14 * t32 - np.copysign((-t35), 1)
    t37 = 0.5 - 0.5 * np.copysign(1, t36)
    t38 = t37 / (1 - t37 - t35 * t37)
    t39 = t38 * (t1 * t32 + t8 * t33)
    t40 = t16 * t32 + t20 * t33 + t34 * t39
    t41 = t40 * t40
    t42 = t15 * t38
    t43 = t25 + t34 * t42
    t44 = (t40 + t40) * t43
    t45 = t43 * t43
    t46 = t19 * t32
    t47 = t19 * t33 + t46 * (t39 * t39)
    t48 = t27 * t32
    t49 = t27 * t33 + t39 * (t42 * (t46 + t46)) + t39 * t48
    t50 = t29 + t46 * (t42 * t42) + t42 * t48
    t51 = t49 * (t44 + t44) - t50 * (4 * t41) - t47 * (4 * t45)
    t52 = t49 * t49 - t50 * (4 * t47)

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
    a[..., 0] = t41
    a[..., 1] = t44
    a[..., 2] = t45
    b[..., 0] = t47
    b[..., 1] = t49
    b[..., 2] = t50
    C[..., 0] = t51
    D[..., 0] = t52
    discriminant[..., 0] = t52 + kappa * t51
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 175 operations.

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
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    _real = np.result_type(q, parameters, tangent, curvature, np.float32)

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
    t31 = 1.4210854715202004e-14 * np.sqrt((t2 * t2 + l2 * l2 + l3 * l3))
    t32 = 0.5 - 0.5 * np.copysign(1, t31 - np.copysign(t14, 1))
    t33 = 1 - t32
    t34 = t16 * t33 + t21 * t32
    t35 = t1 * t33 + t13 * t32
    t36 = 1.4210854715202004e-14 + t31 * t32 - 1.4210854715202004e-14 * t32 - np.copysign((-t35), 1)
    t37 = 0.5 - 0.5 * np.copysign(1, t36)
    t38 = t37 / (1 - t37 - t35 * t37)
    t39 = t38 * (t1 * t32 + t13 * t33)
    t40 = t16 * t32 + t21 * t33 + t34 * t39
    t41 = t40 * t40
    t42 = t15 * t38
    t43 = t26 + t34 * t42
    t44 = (t40 + t40) * t43
    t45 = t43 * t43
    t46 = t20 * t32
    t47 = t20 * t33 + t46 * (t39 * t39)
    t48 = t28 * t32
    t49 = t28 * t33 + t39 * (t42 * (t46 + t46)) + t39 * t48
    t50 = t19 + t46 * (t42 * t42) + t42 * t48
    t51 = t49 * (t44 + t44) - t50 * (4 * t41) - t47 * (4 * t45)
    t52 = t49 * t49 - t50 * (4 * t47)

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
    a[..., 0] = t41
    a[..., 1] = t44
    a[..., 2] = t45
    b[..., 0] = t47
    b[..., 1] = t49
    b[..., 2] = t50
    C[..., 0] = t51
    D[..., 0] = t52
    discriminant[..., 0] = t52 + kappa * t51
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_rates(q, parameters, tangent, curvature, leading):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 411 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
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
    leads2 = leading[..., 1]
    leads3 = leading[..., 2]
    leads1 = leading[..., 0]
    kappa_s = curvature[..., 1]

    # terms
    t1 = l1 + q1
    t2 = cos_heading1 * t1
    t3 = cos_heading1 * c2 - sin_heading1 * s2
    t4 = cos_heading1 * s2 + c2 * sin_heading1
    t5 = t3 * c3 - t4 * s3
    t6 = t5 * l3
    t7 = t2 + t3 * l2 + t6 - t2
    t8 = np.maximum(np.copysign(tx, 1), np.copysign(ty, 1))
    t9 = tx / t8
    t10 = ty / t8
    t11 = np.sqrt((t9 * t9 + t10 * t10))
    t12 = t9 / t11
    t13 = t1 * sin_heading1
    t14 = c3 * t4 + t3 * s3
    t15 = l3 * t14
    t16 = t13 + l2 * t4 + t15 - t13
    t17 = t10 / t11
    t18 = t7 * t12 + t16 * t17
    t19 = t6 * t12 + t15 * t17
    t20 = t7 * t17 - t12 * t16
    t21 = t6 * t17 - t12 * t15
    t22 = t18 * t18 + t19 * t19 + t20 * t20 + t21 * t21
    t23 = np.sqrt((t1 * t1 + l2 * l2 + l3 * l3))
    t24 = t23 + (0.5 + 0.5 * np.copysign(1, 7.888609052210118e-31 - np.copysign(t23, 1)))
    t25 = t24 * t24
    t26 = 1.4210854715202004e-14 * np.sqrt((t22 + t25))
    t27 = 1.4142135623730951 * t24
    t28 = sin_heading1 * t12 - cos_heading1 * t17
    t29 = cos_heading1 * t12 + sin_heading1 * t17
    t30 = t21 * t28 - t19 * t29
    t31 = t30 * t30
    t32 = t18 * t29 - t20 * t28
    t33 = t32 * t32
    t34 = t19 * t20 - t18 * t21
    t35 = t34 * t34
    t36 = np.sqrt((t31 + t33 + t35 / t25))
    t37 = 0.5 - 0.5 * np.copysign(1, t26 * t27 - np.copysign((t24 * t36), 1))
    t38 = 1 - t37
    t39 = t37 / (t38 + t37 * np.sqrt((t33 + (t31 + t35))))
    t40 = t32 * t39
    t41 = t30 * t39
    t42 = t39 * (t18 * t40 - t19 * t41)
    t43 = t34 * t39
    t44 = t26 * t37 / t24 * (t27 * t27) / (t38 + t36 * t37)
    t45 = t36 * t39
    t46 = t44 * (t45 * t45)
    t47 = t4 * t12 - t3 * t17
    t48 = l2 * t47
    t49 = t12 * t14 - t5 * t17
    t50 = l3 * t49
    t51 = t40 + t41
    t52 = t48 * (t41 * t41) + t50 * (t51 * t51)
    t53 = -t52
    t54 = np.copysign(t53, 1)
    t55 = 0.5 - 0.5 * np.copysign(1, t46 - t54)
    t56 = t39 * (t19 * t43 - t28 * t40)
    t57 = t56 * t56
    t58 = t39 * (t28 * t41 - t18 * t43)
    t59 = t57 + t58 * t58 + t42 * t42 / t25
    t60 = np.sqrt(t59)
    t61 = t44 * (t45 * (t60 + t60))
    t62 = t56 + t58
    t63 = t41 * (t56 * (l2 * (-2 * t47))) - t51 * (l3 * (t49 + t49) * t62)
    t64 = np.copysign(t63, 1)
    t65 = t44 * t59
    t66 = t48 * t57 + t50 * (t62 * t62)
    t67 = t66 + kappa
    t68 = np.copysign((-t67), 1)
    t69 = (t61 + t61) * t64 + t54 * (4 * t65) + 4 * t46 * t68
    t70 = t63 * t63 - t52 * (4 * t67)
    t71 = np.maximum(0.0, t70)
    t72 = t55 * (0.5 - 0.5 * np.copysign(1, t69 - np.copysign(t71, 1)))
    t73 = 1 - t72
    t74 = 0.5 - 0.5 * np.copysign(1, t61 - t64)
    t75 = 1 - t55
    t76 = t74 * t75
    t77 = t67 * t76 / (1 - t76 + t63 * t76) - t55 * t63 / (t75 - t52 * (t55 + t55))
    t78 = t72 * (-0.5 * t63 - 0.5 * np.copysign(np.sqrt(t71), t63))
    t79 = t73 * t77 - t67 * t72 / (t73 + t78)
    t80 = t37 * (t42 + t43 * t79)
    t81 = t37 * (t56 + t41 * t79)
    t82 = t37 * (t58 + t40 * t79)
    t83 = t37 * t72
    t84 = t78 / (t73 - t52 * t72)
    t85 = t83 * (t42 + t43 * t84)
    t86 = t83 * (t56 + t41 * t84)
    t87 = t83 * (t58 + t40 * t84)
    t88 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t81, 1), np.copysign(t82, 1)), np.copysign((t80 / t24), 1))
    t89 = leads2 + leads3 + t24 * leads1
    t90 = t80 * leads1 + t81 * leads2 + t82 * leads3
    t91 = 0.5 - 0.5 * np.copysign(1, t88 * t89 - np.copysign(t90, 1))
    t92 = 1 - t91
    t93 = t91 / (t92 + t90 * t91)
    t94 = 1 - leads1
    t95 = 1 - leads3
    t96 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t86, 1), np.copysign(t87, 1)), np.copysign((t85 / t24), 1))
    t97 = t85 * leads1 + t86 * leads2 + t87 * leads3
    t98 = 0.5 - 0.5 * np.copysign(1, t89 * t96 - np.copysign(t97, 1))
    t99 = 1 - t98
    t100 = t98 / (t99 + t97 * t98)
    t101 = t81 * t81
    t102 = t81 + t82
    t103 = t102 * t102
    t104 = t48 * t101 + t50 * t103
    t105 = t86 * t86
    t106 = t86 + t87
    t107 = t106 * t106
    t108 = t48 * t105 + t50 * t107
    t109 = l2 * (t3 * t12 + t4 * t17)
    t110 = l3 * (t5 * t12 + t14 * t17)
    t111 = -3 * t104 * (t101 * t109 + t103 * t110) - t109 * (t81 * t101)
    t112 = t111 - t110 * (t102 * t103)
    t113 = -3 * t108 * (t105 * t109 + t107 * t110) - t109 * (t86 * t105)
    t114 = t113 - t110 * (t106 * t107)
    t115 = 0.5 - 0.5 * np.copysign(1, t69 - np.copysign(np.maximum(0.0, -t70), 1))
    t116 = t55 * t115
    t117 = 4 + t37 * (t55 * t116 + t75 * (2 + t74)) - 4 * t37
    t118 = 1 - np.copysign(1, np.copysign((t114 - kappa_s), 1) - np.copysign((t112 - kappa_s), 1))
    t119 = t75 * (1 - t74) * (0.5 + 0.5 * np.copysign(1, t65 - t68))

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
    rates[..., 0] = t80
    rates[..., 1] = t81
    rates[..., 2] = t82
    rates[..., 3] = t85
    rates[..., 4] = t86
    rates[..., 5] = t87
    ratios[..., 0] = t93 * (t81 * leads1 + t80 * t94)
    ratios[..., 1] = t93 * (t81 * leads3 + t82 * t95)
    ratios[..., 2] = t100 * (t86 * leads1 + t85 * t94)
    ratios[..., 3] = t100 * (t86 * leads3 + t87 * t95)
    tracked[..., 0] = -t104
    tracked[..., 1] = -t108
    tracked_rate[..., 0] = t112
    tracked_rate[..., 1] = t114
    verdict[..., 0] = t117
    verdict[..., 1] = t37 * (1 + t72)
    verdict[..., 2] = t72 * (0.5 * t37) * t118
    verdict[..., 3] = t37 * (t76 + t55 * (1 - t116) + t119)
    verdict[..., 4] = t83 * t99 + t37 * t92
    parabola[..., 0] = t53
    parabola[..., 1] = t63
    parabola[..., 2] = -t66
    slack[..., 0] = t70
    least[..., 0] = t42
    least[..., 1] = t56
    least[..., 2] = t58
    null[..., 0] = t43
    null[..., 1] = t41
    null[..., 2] = t40
    return rates.reshape(_leading + (2, 3)), ratios.reshape(_leading + (2, 2)), tracked.reshape(_leading + (2,)), tracked_rate.reshape(_leading + (2,)), verdict.reshape(_leading + (5,)), parabola.reshape(_leading + (3,)), slack.reshape(_leading), least.reshape(_leading + (3,)), null.reshape(_leading + (3,))
