"""speed ratio of planar_prp, in NumPy.

Made from templates/kernel.py.j2; inputs a4f105eb3213dd7eee3af29d429db018dced739b6068ddbe7f702dc6c93cd313.
906 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 166 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
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
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = l1 + q1
    t2 = cos_heading1 * t1
    t3 = cos_heading1 * c2 - sin_heading1 * s2
    t4 = cos_heading1 * s2 + c2 * sin_heading1
    t5 = t3 * cos_heading3 - t4 * sin_heading3
    t6 = l3 + q3
    t7 = t2 + t3 * l2 + t5 * t6 - t2
    t8 = t1 * sin_heading1
    t9 = cos_heading3 * t4 + t3 * sin_heading3
    t10 = t8 + l2 * t4 + t6 * t9 - t8
    t11 = t7 * tx + t10 * ty
    t12 = tx * t9 - t5 * ty
    t13 = -t12
    t14 = sin_heading1 * tx - cos_heading1 * ty
    t15 = t6 * t12 + l2 * (t4 * tx - t3 * ty)
    t16 = t7 * ty - tx * t10
    t17 = t11 * t11 + t16 * t16
    t18 = t5 * tx + t9 * ty
    t19 = t12 * t12 + t18 * t18
    t20 = -2 * t18
    t21 = t12 * (t11 + t11) + t18 * (t16 + t16)
    t22 = t14 + t14
    t23 = cos_heading1 * tx + sin_heading1 * ty
    t24 = t23 + t23
    t25 = t11 * t22 + t16 * t24
    t26 = t12 * t22 + t18 * t24
    t27 = t14 * t14 + t23 * t23
    t28 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign(t13, 1))
    t29 = 1 - t28
    t30 = t16 * t29 + t18 * t28
    t31 = 1.4210854715202004e-14 * np.sqrt((t1 * t1 + t6 * t6 + l2 * l2))
    t32 = t11 * t29 + t12 * t28
    t33 = np.copysign(1, 1.4210854715202004e-14 * t28 + t29 * t31 - np.copysign((-t32), 1))
    t34 = 0.5 - 0.5 * t33
    t35 = t34 / (1 - t34 - t32 * t34)
    t36 = t35 * (t11 * t28 + t12 * t29)
    t37 = t16 * t28 + t18 * t29 + t30 * t36
    t38 = t37 * t37
    t39 = t14 * t35
    t40 = t23 + t30 * t39
    t41 = (t37 + t37) * t40
    t42 = t40 * t40
    t43 = t15 * t29
    t44 = t15 * t28 + t43 * (t36 * t36) + t20 * t36
    t45 = t36 * (t39 * (t43 + t43)) + t20 * t39
    t46 = t43 * (t39 * t39)
    t47 = t45 * (t41 + t41) - t46 * (4 * t38) - t44 * (4 * t42)
    t48 = t45 * t45 - t46 * (4 * t44)

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
    A[..., 0] = -t11
    A[..., 1] = t13
    A[..., 2] = -t14
    B[..., 0] = t15 + t17 * kappa
    B[..., 1] = kappa * t19
    B[..., 2] = t20 + kappa * t21
    B[..., 3] = kappa * t25
    B[..., 4] = kappa * t26
    B[..., 5] = kappa * t27
    B0[..., 0] = t15
    B0[..., 1] = 0.0
    B0[..., 2] = t20
    B0[..., 3] = 0.0
    B0[..., 4] = 0.0
    B0[..., 5] = 0.0
    B1[..., 0] = t17
    B1[..., 1] = t19
    B1[..., 2] = t21
    B1[..., 3] = t25
    B1[..., 4] = t26
    B1[..., 5] = t27
    a[..., 0] = t38
    a[..., 1] = t41
    a[..., 2] = t42
    b[..., 0] = t44
    b[..., 1] = t45
    b[..., 2] = t46
    C[..., 0] = t47
    D[..., 0] = t48
    discriminant[..., 0] = t48 + kappa * t47
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 142 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
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
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    q2 = q[..., 1]
    s2 = np.sin(q2)
    c2 = np.cos(q2)
    sin_heading3 = np.sin(heading3)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    kappa = curvature[..., 0]

    # terms
    t1 = sin_heading1 * tx - cos_heading1 * ty
    t2 = cos_heading1 * s2 + sin_heading1 * c2
    t3 = cos_heading1 * c2 - sin_heading1 * s2
    t4 = cos_heading3 * t2 + t3 * sin_heading3
    t5 = cos_heading3 * t3 - t2 * sin_heading3
    t6 = tx * t4 - ty * t5
    t7 = -t6
    t8 = l1 + q1
    t9 = cos_heading1 * t8
    t10 = l3 + q3
    t11 = t9 + t3 * l2 + t5 * t10 - t9
    t12 = sin_heading1 * t8
    t13 = t12 + t2 * l2 + t4 * t10 - t12
    t14 = tx * t11 + ty * t13
    t15 = tx * cos_heading1 + sin_heading1 * ty
    t16 = t1 * t1 + t15 * t15
    t17 = tx * t5 + ty * t4
    t18 = t6 * t6 + t17 * t17
    t19 = t1 + t1
    t20 = t15 + t15
    t21 = t6 * t19 + t17 * t20
    t22 = ty * t11 - tx * t13
    t23 = t14 * t19 + t20 * t22
    t24 = -2 * t17
    t25 = t6 * (t14 + t14) + t17 * (t22 + t22)
    t26 = t6 * t10 + l2 * (tx * t2 - ty * t3)
    t27 = t14 * t14 + t22 * t22
    t28 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign(t7, 1))
    t29 = 1 - t28
    t30 = t15 * t29 + t17 * t28
    t31 = t1 * t29 + t6 * t28
    t32 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign((-t31), 1))
    t33 = t32 / (1 - t32 - t31 * t32)
    t34 = t33 * (t1 * t28 + t6 * t29)
    t35 = t15 * t28 + t17 * t29 + t30 * t34
    t36 = t35 * t35
    t37 = t14 * t33
    t38 = t22 + t30 * t37
    t39 = (t35 + t35) * t38
    t40 = t24 * t28
    t41 = t24 * t29 + t34 * t40
    t42 = t26 + t37 * t40
    t43 = t41 * (t39 + t39) - t42 * (4 * t36)
    t44 = t41 * t41

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
    A[..., 1] = t7
    A[..., 2] = -t14
    B[..., 0] = t16 * kappa
    B[..., 1] = kappa * t18
    B[..., 2] = kappa * t21
    B[..., 3] = kappa * t23
    B[..., 4] = t24 + kappa * t25
    B[..., 5] = t26 + kappa * t27
    B0[..., 0] = 0.0
    B0[..., 1] = 0.0
    B0[..., 2] = 0.0
    B0[..., 3] = 0.0
    B0[..., 4] = t24
    B0[..., 5] = t26
    B1[..., 0] = t16
    B1[..., 1] = t18
    B1[..., 2] = t21
    B1[..., 3] = t23
    B1[..., 4] = t25
    B1[..., 5] = t27
    a[..., 0] = t36
    a[..., 1] = t39
    a[..., 2] = t38 * t38
    b[..., 0] = 0.0
    b[..., 1] = t41
    b[..., 2] = t42
    C[..., 0] = t43
    D[..., 0] = t44
    discriminant[..., 0] = t44 + kappa * t43
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 170 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
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
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    kappa = curvature[..., 0]

    # terms
    t1 = sin_heading1 * tx - cos_heading1 * ty
    t2 = l1 + q1
    t3 = cos_heading1 * t2
    t4 = cos_heading1 * c2 - sin_heading1 * s2
    t5 = cos_heading1 * s2 + sin_heading1 * c2
    t6 = t4 * cos_heading3 - t5 * sin_heading3
    t7 = l3 + q3
    t8 = t3 + t4 * l2 + t6 * t7 - t3
    t9 = sin_heading1 * t2
    t10 = cos_heading3 * t5 + t4 * sin_heading3
    t11 = t9 + l2 * t5 + t7 * t10 - t9
    t12 = tx * t8 + ty * t11
    t13 = -t12
    t14 = tx * t10 - ty * t6
    t15 = tx * cos_heading1 + sin_heading1 * ty
    t16 = t1 * t1 + t15 * t15
    t17 = t7 * t14 + l2 * (tx * t5 - ty * t4)
    t18 = ty * t8 - tx * t11
    t19 = t12 * t12 + t18 * t18
    t20 = t1 + t1
    t21 = t15 + t15
    t22 = t12 * t20 + t18 * t21
    t23 = tx * t6 + ty * t10
    t24 = t14 * t20 + t21 * t23
    t25 = -2 * t23
    t26 = t14 * (t12 + t12) + t23 * (t18 + t18)
    t27 = t14 * t14 + t23 * t23
    t28 = 1.4210854715202004e-14 * np.sqrt((t2 * t2 + t7 * t7 + l2 * l2))
    t29 = 0.5 - 0.5 * np.copysign(1, t28 - np.copysign(t13, 1))
    t30 = 1 - t29
    t31 = t15 * t30 + t18 * t29
    t32 = t1 * t30 + t12 * t29
    t33 = 1.4210854715202004e-14 + t28 * t29 - 1.4210854715202004e-14 * t29 - np.copysign((-t32), 1)
    t34 = 0.5 - 0.5 * np.copysign(1, t33)
    t35 = t34 / (1 - t34 - t32 * t34)
    t36 = t35 * (t1 * t29 + t12 * t30)
    t37 = t15 * t29 + t18 * t30 + t31 * t36
    t38 = t37 * t37
    t39 = t14 * t35
    t40 = t23 + t31 * t39
    t41 = (t37 + t37) * t40
    t42 = t40 * t40
    t43 = t17 * t29
    t44 = t17 * t30 + t43 * (t36 * t36)
    t45 = t25 * t29
    t46 = t25 * t30 + t36 * (t39 * (t43 + t43)) + t36 * t45
    t47 = t43 * (t39 * t39) + t39 * t45
    t48 = t46 * (t41 + t41) - t47 * (4 * t38) - t44 * (4 * t42)
    t49 = t46 * t46 - t47 * (4 * t44)

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
    A[..., 1] = t13
    A[..., 2] = -t14
    B[..., 0] = t16 * kappa
    B[..., 1] = t17 + kappa * t19
    B[..., 2] = kappa * t22
    B[..., 3] = kappa * t24
    B[..., 4] = t25 + kappa * t26
    B[..., 5] = kappa * t27
    B0[..., 0] = 0.0
    B0[..., 1] = t17
    B0[..., 2] = 0.0
    B0[..., 3] = 0.0
    B0[..., 4] = t25
    B0[..., 5] = 0.0
    B1[..., 0] = t16
    B1[..., 1] = t19
    B1[..., 2] = t22
    B1[..., 3] = t24
    B1[..., 4] = t26
    B1[..., 5] = t27
    a[..., 0] = t38
    a[..., 1] = t41
    a[..., 2] = t42
    b[..., 0] = t44
    b[..., 1] = t46
    b[..., 2] = t47
    C[..., 0] = t48
    D[..., 0] = t49
    discriminant[..., 0] = t49 + kappa * t48
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_rates(q, parameters, tangent, curvature, leading):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 428 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
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
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]
    leads2 = leading[..., 1]
    leads1 = leading[..., 0]
    leads3 = leading[..., 2]
    kappa_s = curvature[..., 1]

    # terms
    t1 = l1 + q1
    t2 = cos_heading1 * t1
    t3 = cos_heading1 * c2 - sin_heading1 * s2
    t4 = cos_heading1 * s2 + c2 * sin_heading1
    t5 = t3 * cos_heading3 - t4 * sin_heading3
    t6 = l3 + q3
    t7 = t2 + t3 * l2 + t5 * t6 - t2
    t8 = np.maximum(np.copysign(tx, 1), np.copysign(ty, 1))
    t9 = tx / t8
    t10 = ty / t8
    t11 = np.sqrt((t9 * t9 + t10 * t10))
    t12 = t9 / t11
    t13 = t1 * sin_heading1
    t14 = cos_heading3 * t4 + t3 * sin_heading3
    t15 = t13 + l2 * t4 + t6 * t14 - t13
    t16 = t10 / t11
    t17 = t7 * t12 + t15 * t16
    t18 = t7 * t16 - t12 * t15
    t19 = np.sqrt((t1 * t1 + t6 * t6 + l2 * l2))
    t20 = t19 + (0.5 + 0.5 * np.copysign(1, 7.888609052210118e-31 - np.copysign(t19, 1)))
    t21 = t20 * t20
    t22 = 1.4210854715202004e-14 * np.sqrt((t17 * t17 + t18 * t18 + (t21 + t21)))
    t23 = 1.7320508075688772 * t20
    t24 = sin_heading1 * t12 - cos_heading1 * t16
    t25 = t5 * t12 + t14 * t16
    t26 = t12 * t14 - t5 * t16
    t27 = cos_heading1 * t12 + sin_heading1 * t16
    t28 = t24 * t25 - t26 * t27
    t29 = t28 * t28
    t30 = t18 * t26 - t17 * t25
    t31 = t30 * t30
    t32 = t17 * t27 - t18 * t24
    t33 = t32 * t32
    t34 = np.sqrt((t29 + t31 / t21 + t33 / t21))
    t35 = 0.5 - 0.5 * np.copysign(1, t22 * t23 - np.copysign((t21 * t34), 1))
    t36 = 1 - t35
    t37 = t35 / (t36 + t35 * np.sqrt((t33 + (t29 + t31))))
    t38 = t32 * t37
    t39 = t28 * t37
    t40 = t37 * (t17 * t38 - t26 * t39)
    t41 = t30 * t37
    t42 = t25 + t25
    t43 = t37 * (t26 * t41 - t24 * t38)
    t44 = t37 * (t24 * t39 - t17 * t41)
    t45 = t6 * t26
    t46 = t43 * t43
    t47 = t4 * t12 - t3 * t16
    t48 = l2 * t47
    t49 = t42 * t43 * t44 - t45 * t46 - t46 * t48
    t50 = t49 - kappa
    t51 = t22 * t35 / t21 * (t23 * t23) / (t36 + t34 * t35)
    t52 = t34 * t37
    t53 = t51 * (t52 * t52)
    t54 = t39 * t39
    t55 = t38 * (t39 * t42) - t45 * t54 - t48 * t54
    t56 = np.copysign(t55, 1)
    t57 = 0.5 - 0.5 * np.copysign(1, t53 - t56)
    t58 = t46 + t40 * t40 / t21 + t44 * t44 / t21
    t59 = np.sqrt(t58)
    t60 = t51 * (t52 * (t59 + t59))
    t61 = t26 + t26
    t62 = t42 * (t38 * t43 + t39 * t44) - t39 * (t43 * (t6 * t61))
    t63 = t62 - t39 * (t43 * (l2 * (t47 + t47)))
    t64 = np.copysign(t63, 1)
    t65 = t51 * t58
    t66 = np.copysign(t50, 1)
    t67 = (t60 + t60) * t64 + t56 * (4 * t65) + 4 * t53 * t66
    t68 = t63 * t63 - t55 * (4 * t50)
    t69 = np.maximum(0.0, t68)
    t70 = t57 * (0.5 - 0.5 * np.copysign(1, t67 - np.copysign(t69, 1)))
    t71 = 1 - t70
    t72 = t70 * (-0.5 * t63 - 0.5 * np.copysign(np.sqrt(t69), t63))
    t73 = 1 - t57
    t74 = 0.5 - 0.5 * np.copysign(1, t60 - t64)
    t75 = t73 * t74
    t76 = t57 * t63 / (t73 + t55 * (t57 + t57)) + t50 * t75 / (1 - t75 + t63 * t75)
    t77 = t50 * t70 / (t71 + t72) - t71 * t76
    t78 = t35 * (t40 + t41 * t77)
    t79 = t35 * (t43 + t39 * t77)
    t80 = t35 * (t44 + t38 * t77)
    t81 = t35 * t70
    t82 = t72 / (t71 + t55 * t70)
    t83 = t81 * (t40 + t41 * t82)
    t84 = t81 * (t43 + t39 * t82)
    t85 = t81 * (t44 + t38 * t82)
    t86 = np.maximum(np.maximum(np.copysign(t79, 1), np.copysign((t78 / t20), 1)), np.copysign((t80 / t20), 1))
    t87 = leads2 + t20 * leads1 + t20 * leads3
    t88 = t78 * leads1 + t79 * leads2 + t80 * leads3
    t89 = 0.5 - 0.5 * np.copysign(1, 9.094947017729282e-13 * t86 * t87 - np.copysign(t88, 1))
    t90 = 1 - t89
    t91 = t89 / (t90 + t88 * t89)
    t92 = 1 - leads1
    t93 = 1 - leads3
    t94 = np.maximum(np.maximum(np.copysign(t84, 1), np.copysign((t83 / t20), 1)), np.copysign((t85 / t20), 1))
    t95 = t83 * leads1 + t84 * leads2 + t85 * leads3
    t96 = 0.5 - 0.5 * np.copysign(1, t87 * (9.094947017729282e-13 * t94) - np.copysign(t95, 1))
    t97 = 1 - t96
    t98 = t96 / (t97 + t95 * t96)
    t99 = t79 * t79
    t100 = t80 * (t42 * t79) - t45 * t99 - t48 * t99
    t101 = t84 * t84
    t102 = t85 * (t42 * t84) - t45 * t101 - t48 * t101
    t103 = t6 * t25
    t104 = l2 * (t3 * t12 + t4 * t16)
    t105 = -3 * t100 * (t99 * t103 + t99 * t104 + t80 * (t61 * t79))
    t106 = t79 * t99
    t107 = 3 * t26
    t108 = t105 + t103 * t106 + t104 * t106 + t99 * (t80 * t107)
    t109 = -3 * t102 * (t101 * t103 + t101 * t104 + t85 * (t61 * t84))
    t110 = t84 * t101
    t111 = t109 + t103 * t110 + t104 * t110 + t101 * (t85 * t107)
    t112 = 0.5 - 0.5 * np.copysign(1, t67 - np.copysign(np.maximum(0.0, -t68), 1))
    t113 = t57 * t112
    t114 = 4 + t35 * (t57 * t113 + t73 * (2 + t74)) - 4 * t35
    t115 = np.copysign((-(t111 + kappa_s)), 1) - np.copysign((-(t108 + kappa_s)), 1)
    t116 = t73 * (1 - t74) * (0.5 + 0.5 * np.copysign(1, t65 - t66))

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
    rates[..., 0] = t78
    rates[..., 1] = t79
    rates[..., 2] = t80
    rates[..., 3] = t83
    rates[..., 4] = t84
    rates[..., 5] = t85
    ratios[..., 0] = t91 * (t79 * leads1 + t78 * t92)
    ratios[..., 1] = t91 * (t79 * leads3 + t80 * t93)
    ratios[..., 2] = t98 * (t84 * leads1 + t83 * t92)
    ratios[..., 3] = t98 * (t84 * leads3 + t85 * t93)
    tracked[..., 0] = t100
    tracked[..., 1] = t102
    tracked_rate[..., 0] = -t108
    tracked_rate[..., 1] = -t111
    verdict[..., 0] = t114
    verdict[..., 1] = t35 * (1 + t70)
    verdict[..., 2] = t70 * (0.5 * t35) * (1 - np.copysign(1, t115))
    verdict[..., 3] = t35 * (t75 + t57 * (1 - t113) + t116)
    verdict[..., 4] = t81 * t97 + t35 * t90
    parabola[..., 0] = t55
    parabola[..., 1] = t63
    parabola[..., 2] = t49
    slack[..., 0] = t68
    least[..., 0] = t40
    least[..., 1] = t43
    least[..., 2] = t44
    null[..., 0] = t41
    null[..., 1] = t39
    null[..., 2] = t38
    return rates.reshape(_leading + (2, 3)), ratios.reshape(_leading + (2, 2)), tracked.reshape(_leading + (2,)), tracked_rate.reshape(_leading + (2,)), verdict.reshape(_leading + (5,)), parabola.reshape(_leading + (3,)), slack.reshape(_leading), least.reshape(_leading + (3,)), null.reshape(_leading + (3,))
