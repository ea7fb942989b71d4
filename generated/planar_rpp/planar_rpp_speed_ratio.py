"""speed ratio of planar_rpp, in NumPy.

Made from templates/kernel.py.j2; inputs bbd55a6dc48654b17d6688ff647e44e7f882e5a77b071d4af5478b7b3f9a656d.
978 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 148 operations.

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
    t18 = -2 * t13
    t19 = t12 + t12
    t20 = ty * t10 - tx * t11
    t21 = t20 + t20
    t22 = t3 * t19 + t13 * t21
    t23 = -2 * t15
    t24 = t6 * t19 + t15 * t21
    t25 = t3 * t8 + t6 * t9 + l1 * (s1 * tx - c1 * ty)
    t26 = t12 * t12 + t20 * t20
    t27 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign(t7, 1))
    t28 = 1 - t27
    t29 = t13 * t28 + t15 * t27
    t30 = t3 * t28 + t6 * t27
    t31 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign((-t30), 1))
    t32 = t31 / (1 - t31 - t30 * t31)
    t33 = t32 * (t3 * t27 + t6 * t28)
    t34 = t13 * t27 + t15 * t28 + t29 * t33
    t35 = t34 * t34
    t36 = t12 * t32
    t37 = t20 + t29 * t36
    t38 = (t34 + t34) * t37
    t39 = t18 * t28 + t23 * t27
    t40 = t18 * t27 + t23 * t28 + t33 * t39
    t41 = t25 + t36 * t39
    t42 = t40 * (t38 + t38) - t41 * (4 * t35)
    t43 = t40 * t40

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
    a[..., 0] = t35
    a[..., 1] = t38
    a[..., 2] = t37 * t37
    b[..., 0] = 0.0
    b[..., 1] = t40
    b[..., 2] = t41
    C[..., 0] = t42
    D[..., 0] = t43
    discriminant[..., 0] = t43 + kappa * t42
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 175 operations.

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
    t18 = -2 * t16
    t19 = t9 + t9
    t20 = t14 + t14
    t21 = t10 * t19 + t16 * t20
    t22 = tx * t1 + t3 * ty
    t23 = -2 * t22
    t24 = t12 * t19 + t20 * t22
    t25 = t10 * (t12 + t12) + t16 * (t22 + t22)
    t26 = t12 * t12 + t22 * t22
    t27 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign(t11, 1))
    t28 = 1 - t27
    t29 = t14 * t28 + t16 * t27
    t30 = 1.4210854715202004e-14 * np.sqrt((t2 * t2 + t5 * t5 + l1 * l1))
    t31 = t9 * t28 + t10 * t27
    t32 = np.copysign(1, 1.4210854715202004e-14 * t27 + t28 * t30 - np.copysign((-t31), 1))
    t33 = 0.5 - 0.5 * t32
    t34 = t33 / (1 - t33 - t31 * t33)
    t35 = t34 * (t9 * t27 + t10 * t28)
    t36 = t14 * t27 + t16 * t28 + t29 * t35
    t37 = t36 * t36
    t38 = t12 * t34
    t39 = t22 + t29 * t38
    t40 = (t36 + t36) * t39
    t41 = t39 * t39
    t42 = t13 * t28
    t43 = t13 * t27 + t42 * (t35 * t35) + t18 * t35
    t44 = t23 * t27 + t35 * (t38 * (t42 + t42)) + t18 * t38
    t45 = t23 * t28
    t46 = t44 + t35 * t45
    t47 = t42 * (t38 * t38) + t38 * t45
    t48 = t46 * (t40 + t40) - t47 * (4 * t37) - t43 * (4 * t41)
    t49 = t46 * t46 - t47 * (4 * t43)

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
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 175 operations.

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
    t18 = -2 * t16
    t19 = t9 + t9
    t20 = t14 + t14
    t21 = t10 * t19 + t16 * t20
    t22 = tx * t4 + ty * t7
    t23 = -2 * t22
    t24 = t12 * t19 + t20 * t22
    t25 = t12 * (t10 + t10) + t22 * (t16 + t16)
    t26 = t12 * t12 + t22 * t22
    t27 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign(t11, 1))
    t28 = 1 - t27
    t29 = t14 * t28 + t16 * t27
    t30 = 1.4210854715202004e-14 * np.sqrt((t2 * t2 + t5 * t5 + l1 * l1))
    t31 = t9 * t28 + t10 * t27
    t32 = np.copysign(1, 1.4210854715202004e-14 * t27 + t28 * t30 - np.copysign((-t31), 1))
    t33 = 0.5 - 0.5 * t32
    t34 = t33 / (1 - t33 - t31 * t33)
    t35 = t34 * (t9 * t27 + t10 * t28)
    t36 = t14 * t27 + t16 * t28 + t29 * t35
    t37 = t36 * t36
    t38 = t12 * t34
    t39 = t22 + t29 * t38
    t40 = (t36 + t36) * t39
    t41 = t39 * t39
    t42 = t13 * t28
    t43 = t13 * t27 + t42 * (t35 * t35) + t18 * t35
    t44 = t23 * t27 + t35 * (t38 * (t42 + t42)) + t18 * t38
    t45 = t23 * t28
    t46 = t44 + t35 * t45
    t47 = t42 * (t38 * t38) + t38 * t45
    t48 = t46 * (t40 + t40) - t47 * (4 * t37) - t43 * (4 * t41)
    t49 = t46 * t46 - t47 * (4 * t43)

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
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 480 operations.

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
    t1 = np.maximum(np.copysign(tx, 1), np.copysign(ty, 1))
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
    t16 = t11 * t12 - t5 * t14
    t17 = np.sqrt((t7 * t7 + t10 * t10 + l1 * l1))
    t18 = t17 + (0.5 + 0.5 * np.copysign(1, 7.888609052210118e-31 - np.copysign(t17, 1)))
    t19 = t18 * t18
    t20 = 1.4210854715202004e-14 * np.sqrt((t15 * t15 + t16 * t16 + (t19 + t19)))
    t21 = 1.7320508075688772 * t18
    t22 = t5 * t13 - t9 * t12
    t23 = t5 * t6 + t8 * t12
    t24 = t5 * t8 - t6 * t12
    t25 = t5 * t9 + t12 * t13
    t26 = t22 * t23 - t24 * t25
    t27 = t26 * t26
    t28 = t15 * t25 - t16 * t22
    t29 = t28 * t28
    t30 = t16 * t24 - t15 * t23
    t31 = t30 * t30
    t32 = np.sqrt((t27 + t29 / t19 + t31 / t19))
    t33 = 0.5 - 0.5 * np.copysign(1, t20 * t21 - np.copysign((t19 * t32), 1))
    t34 = 1 - t33
    t35 = t33 / (t34 + t33 * np.sqrt((t31 + (t27 + t29))))
    t36 = t30 * t35
    t37 = t28 * t35
    t38 = t35 * (t24 * t36 - t22 * t37)
    t39 = t26 * t35
    t40 = t23 + t23
    t41 = t35 * (t22 * t39 - t15 * t36)
    t42 = t25 + t25
    t43 = t35 * (t15 * t37 - t24 * t39)
    t44 = t7 * t24
    t45 = t38 * t38
    t46 = t38 * t40 * t41 + t38 * t42 * t43 - t44 * t45
    t47 = t10 * t22
    t48 = t5 * s1 - c1 * t12
    t49 = l1 * t48
    t50 = t46 - t45 * t47 - t45 * t49
    t51 = t50 - kappa
    t52 = t20 * t33 / t19 * (t21 * t21) / (t34 + t32 * t33)
    t53 = t32 * t35
    t54 = t52 * (t53 * t53)
    t55 = t39 * t39
    t56 = t37 * (t39 * t40) + t36 * (t39 * t42) - t44 * t55
    t57 = t56 - t47 * t55 - t49 * t55
    t58 = np.copysign(t57, 1)
    t59 = 0.5 - 0.5 * np.copysign(1, t54 - t58)
    t60 = t45 + t41 * t41 / t19 + t43 * t43 / t19
    t61 = np.sqrt(t60)
    t62 = t52 * (t53 * (t61 + t61))
    t63 = t40 * (t37 * t38 + t39 * t41) + t42 * (t36 * t38 + t39 * t43)
    t64 = t24 + t24
    t65 = t22 + t22
    t66 = t63 - t39 * (t38 * (t7 * t64)) - t39 * (t38 * (t10 * t65))
    t67 = t66 - t39 * (t38 * (l1 * (t48 + t48)))
    t68 = np.copysign(t67, 1)
    t69 = t52 * t60
    t70 = np.copysign(t51, 1)
    t71 = (t62 + t62) * t68 + t58 * (4 * t69) + 4 * t54 * t70
    t72 = t67 * t67 - t57 * (4 * t51)
    t73 = np.maximum(0.0, t72)
    t74 = t59 * (0.5 - 0.5 * np.copysign(1, t71 - np.copysign(t73, 1)))
    t75 = 1 - t74
    t76 = t74 * (-0.5 * t67 - 0.5 * np.copysign(np.sqrt(t73), t67))
    t77 = 1 - t59
    t78 = 0.5 - 0.5 * np.copysign(1, t62 - t68)
    t79 = t77 * t78
    t80 = t59 * t67 / (t77 + t57 * (t59 + t59)) + t51 * t79 / (1 - t79 + t67 * t79)
    t81 = t51 * t74 / (t75 + t76) - t75 * t80
    t82 = t33 * (t38 + t39 * t81)
    t83 = t33 * (t41 + t37 * t81)
    t84 = t33 * (t43 + t36 * t81)
    t85 = t33 * t74
    t86 = t76 / (t75 + t57 * t74)
    t87 = t85 * (t38 + t39 * t86)
    t88 = t85 * (t41 + t37 * t86)
    t89 = t85 * (t43 + t36 * t86)
    t90 = np.maximum(np.maximum(np.copysign(t82, 1), np.copysign((t83 / t18), 1)), np.copysign((t84 / t18), 1))
    t91 = leads1 + t18 * leads2 + t18 * leads3
    t92 = t82 * leads1 + t83 * leads2 + t84 * leads3
    t93 = 0.5 - 0.5 * np.copysign(1, 9.094947017729282e-13 * t90 * t91 - np.copysign(t92, 1))
    t94 = 1 - t93
    t95 = t93 / (t94 + t92 * t93)
    t96 = 1 - leads1
    t97 = 1 - leads3
    t98 = np.maximum(np.maximum(np.copysign(t87, 1), np.copysign((t88 / t18), 1)), np.copysign((t89 / t18), 1))
    t99 = t87 * leads1 + t88 * leads2 + t89 * leads3
    t100 = 0.5 - 0.5 * np.copysign(1, t91 * (9.094947017729282e-13 * t98) - np.copysign(t99, 1))
    t101 = 1 - t100
    t102 = t100 / (t101 + t99 * t100)
    t103 = t82 * t82
    t104 = t83 * (t40 * t82) + t84 * (t42 * t82) - t44 * t103
    t105 = t104 - t47 * t103 - t49 * t103
    t106 = t87 * t87
    t107 = t88 * (t40 * t87) + t89 * (t42 * t87) - t44 * t106
    t108 = t107 - t47 * t106 - t49 * t106
    t109 = t7 * t23
    t110 = t10 * t25
    t111 = l1 * (t5 * c1 + s1 * t12)
    t112 = t103 * t109 + t103 * t110 + t103 * t111 + t83 * (t64 * t82)
    t113 = t82 * t103
    t114 = -3 * t105 * (t112 + t84 * (t65 * t82)) + t109 * t113
    t115 = 3 * t24
    t116 = t114 + t110 * t113 + t111 * t113 + t103 * (t83 * t115)
    t117 = 3 * t22
    t118 = t116 + t103 * (t84 * t117)
    t119 = t106 * t109 + t106 * t110 + t106 * t111 + t88 * (t64 * t87)
    t120 = t87 * t106
    t121 = -3 * t108 * (t119 + t89 * (t65 * t87)) + t109 * t120
    t122 = t121 + t110 * t120 + t111 * t120 + t106 * (t88 * t115)
    t123 = t122 + t106 * (t89 * t117)
    t124 = 0.5 - 0.5 * np.copysign(1, t71 - np.copysign(np.maximum(0.0, -t72), 1))
    t125 = t59 * t124
    t126 = 4 + t33 * (t59 * t125 + t77 * (2 + t78)) - 4 * t33
    t127 = np.copysign((-(t123 + kappa_s)), 1) - np.copysign((-(t118 + kappa_s)), 1)
    t128 = t77 * (1 - t78) * (0.5 + 0.5 * np.copysign(1, t69 - t70))

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
    rates[..., 0] = t82
    rates[..., 1] = t83
    rates[..., 2] = t84
    rates[..., 3] = t87
    rates[..., 4] = t88
    rates[..., 5] = t89
    ratios[..., 0] = t95 * (t83 * leads1 + t82 * t96)
    ratios[..., 1] = t95 * (t83 * leads3 + t84 * t97)
    ratios[..., 2] = t102 * (t88 * leads1 + t87 * t96)
    ratios[..., 3] = t102 * (t88 * leads3 + t89 * t97)
    tracked[..., 0] = t105
    tracked[..., 1] = t108
    tracked_rate[..., 0] = -t118
    tracked_rate[..., 1] = -t123
    verdict[..., 0] = t126
    verdict[..., 1] = t33 * (1 + t74)
    verdict[..., 2] = t74 * (0.5 * t33) * (1 - np.copysign(1, t127))
    verdict[..., 3] = t33 * (t79 + t59 * (1 - t125) + t128)
    verdict[..., 4] = t85 * t101 + t33 * t94
    parabola[..., 0] = t57
    parabola[..., 1] = t67
    parabola[..., 2] = t50
    slack[..., 0] = t72
    least[..., 0] = t38
    least[..., 1] = t41
    least[..., 2] = t43
    null[..., 0] = t39
    null[..., 1] = t37
    null[..., 2] = t36
    return rates.reshape(_leading + (2, 3)), ratios.reshape(_leading + (2, 2)), tracked.reshape(_leading + (2,)), tracked_rate.reshape(_leading + (2,)), verdict.reshape(_leading + (5,)), parabola.reshape(_leading + (3,)), slack.reshape(_leading), least.reshape(_leading + (3,)), null.reshape(_leading + (3,))
