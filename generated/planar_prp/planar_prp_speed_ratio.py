"""speed ratio of planar_prp, in NumPy.

Made from templates/kernel.py.j2; inputs d3a9ecff5fea69defe89768dd13ae7dcfaa2e6efa17fd2ca4a0fb1dd59d0fd93.
880 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 164 operations.

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
    t20 = -2.0 * t18
    t21 = t12 * (t11 + t11) + t18 * (t16 + t16)
    t22 = t14 + t14
    t23 = cos_heading1 * tx + sin_heading1 * ty
    t24 = t23 + t23
    t25 = t11 * t22 + t16 * t24
    t26 = t12 * t22 + t18 * t24
    t27 = t14 * t14 + t23 * t23
    t28 = np.sqrt((2.0 + t1 * t1 + t6 * t6 + l2 * l2))
    t29 = 1.4210854715202004e-14 * t28
    t30 = 0.5 - 0.5 * np.copysign(1.0, t29 - np.copysign(t13, 1.0))
    t31 = 1.0 - t30
    t32 = t16 * t31 + t18 * t30
    t33 = t11 * t31 + t12 * t30
    t34 = 0.5 - 0.5 * np.copysign(1.0, t29 - np.copysign((-t33), 1.0))
    t35 = t34 / (1.0 - t34 - t33 * t34)
    t36 = t35 * (t11 * t30 + t12 * t31)
    t37 = t16 * t30 + t18 * t31 + t32 * t36
    t38 = t37 * t37
    t39 = t14 * t35
    t40 = t23 + t32 * t39
    t41 = (t37 + t37) * t40
    t42 = t40 * t40
    t43 = t15 * t31
    t44 = t15 * t30 + t43 * (t36 * t36) + t20 * t36
    t45 = t36 * (t39 * (t43 + t43)) + t20 * t39
    t46 = t43 * (t39 * t39)
    t47 = t45 * (t41 + t41) - t46 * (4.0 * t38) - t44 * (4.0 * t42)
    t48 = t45 * t45 - t46 * (4.0 * t44)

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
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 150 operations.

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
    t24 = -2.0 * t17
    t25 = t6 * (t14 + t14) + t17 * (t22 + t22)
    t26 = t6 * t10 + l2 * (tx * t2 - ty * t3)
    t27 = t14 * t14 + t22 * t22
    t28 = np.sqrt((2.0 + t8 * t8 + t10 * t10 + l2 * l2))
    t29 = 1.4210854715202004e-14 * t28
    t30 = 0.5 - 0.5 * np.copysign(1.0, t29 - np.copysign(t7, 1.0))
    t31 = 1.0 - t30
    t32 = t15 * t31 + t17 * t30
    t33 = t1 * t31 + t6 * t30
    t34 = 0.5 - 0.5 * np.copysign(1.0, t29 - np.copysign((-t33), 1.0))
    t35 = t34 / (1.0 - t34 - t33 * t34)
    t36 = t35 * (t1 * t30 + t6 * t31)
    t37 = t15 * t30 + t17 * t31 + t32 * t36
    t38 = t37 * t37
    t39 = t14 * t35
    t40 = t22 + t32 * t39
    t41 = (t37 + t37) * t40
    t42 = t24 * t30
    t43 = t24 * t31 + t36 * t42
    t44 = t26 + t39 * t42
    t45 = t43 * (t41 + t41) - t44 * (4.0 * t38)
    t46 = t43 * t43

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
    a[..., 0] = t38
    a[..., 1] = t41
    a[..., 2] = t40 * t40
    b[..., 0] = 0.0
    b[..., 1] = t43
    b[..., 2] = t44
    C[..., 0] = t45
    D[..., 0] = t46
    discriminant[..., 0] = t46 + kappa * t45
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 167 operations.

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
    t25 = -2.0 * t23
    t26 = t14 * (t12 + t12) + t23 * (t18 + t18)
    t27 = t14 * t14 + t23 * t23
    t28 = np.sqrt((2.0 + t2 * t2 + t7 * t7 + l2 * l2))
    t29 = 1.4210854715202004e-14 * t28
    t30 = 0.5 - 0.5 * np.copysign(1.0, t29 - np.copysign(t13, 1.0))
    t31 = 1.0 - t30
    t32 = t15 * t31 + t18 * t30
    t33 = t1 * t31 + t12 * t30
    t34 = 0.5 - 0.5 * np.copysign(1.0, t29 - np.copysign((-t33), 1.0))
    t35 = t34 / (1.0 - t34 - t33 * t34)
    t36 = t35 * (t1 * t30 + t12 * t31)
    t37 = t15 * t30 + t18 * t31 + t32 * t36
    t38 = t37 * t37
    t39 = t14 * t35
    t40 = t23 + t32 * t39
    t41 = (t37 + t37) * t40
    t42 = t40 * t40
    t43 = t17 * t30
    t44 = t17 * t31 + t43 * (t36 * t36)
    t45 = t25 * t30
    t46 = t25 * t31 + t36 * (t39 * (t43 + t43)) + t36 * t45
    t47 = t43 * (t39 * t39) + t39 * t45
    t48 = t46 * (t41 + t41) - t47 * (4.0 * t38) - t44 * (4.0 * t42)
    t49 = t46 * t46 - t47 * (4.0 * t44)

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
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 399 operations.

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
    sin_heading1 = np.sin(heading1)
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    cos_heading1 = np.cos(heading1)
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
    t8 = l1 + q1
    t9 = cos_heading1 * t8
    t10 = cos_heading1 * c2 - sin_heading1 * s2
    t11 = cos_heading1 * s2 + sin_heading1 * c2
    t12 = t10 * cos_heading3 - t11 * sin_heading3
    t13 = l3 + q3
    t14 = t9 + t10 * l2 + t12 * t13 - t9
    t15 = sin_heading1 * t8
    t16 = cos_heading3 * t11 + t10 * sin_heading3
    t17 = t15 + l2 * t11 + t13 * t16 - t15
    t18 = t5 * t14 + t6 * t17
    t19 = t5 * t16 - t6 * t12
    t20 = t5 * cos_heading1 + sin_heading1 * t6
    t21 = t7 * t7 + t18 * t18 + t19 * t19 + t20 * t20
    t22 = t6 * t14 - t5 * t17
    t23 = t5 * t12 + t6 * t16
    t24 = np.sqrt((t21 + t22 * t22 + t23 * t23))
    t25 = 2.0 + t8 * t8 + t13 * t13 + l2 * l2
    t26 = t19 * t22 - t18 * t23
    t27 = t7 * t23 - t19 * t20
    t28 = t18 * t20 - t7 * t22
    t29 = np.sqrt((t26 * t26 + t27 * t27 + t28 * t28))
    t30 = 0.5 * np.copysign(1.0, 1.4210854715202004e-14 * t24 * np.sqrt(t25) - np.copysign(t29, 1.0))
    t31 = 0.5 - t30
    t32 = t31 / (1.0 - t31 + t29 * t31)
    t33 = t28 * t32
    t34 = t27 * t32
    t35 = t32 * (t18 * t33 - t19 * t34)
    t36 = t26 * t32
    t37 = t23 + t23
    t38 = t32 * (t19 * t36 - t7 * t33)
    t39 = t32 * (t7 * t34 - t18 * t36)
    t40 = t13 * t19
    t41 = t38 * t38
    t42 = t5 * t11 - t6 * t10
    t43 = l2 * t42
    t44 = t37 * t38 * t39 - t40 * t41 - t41 * t43
    t45 = t44 - kappa
    t46 = t25 * (t24 * (1.4210854715202004e-14 * t32))
    t47 = t34 * t34
    t48 = t33 * (t34 * t37) - t40 * t47 - t43 * t47
    t49 = np.copysign(t48, 1.0)
    t50 = 0.5 - 0.5 * np.copysign(1.0, t46 - t49)
    t51 = t41 + t35 * t35 + t39 * t39
    t52 = np.sqrt(t51)
    t53 = t46 * (t52 + t52)
    t54 = t19 + t19
    t55 = t37 * (t33 * t38 + t34 * t39) - t34 * (t38 * (t13 * t54))
    t56 = t55 - t34 * (t38 * (l2 * (t42 + t42)))
    t57 = np.copysign(t56, 1.0)
    t58 = t46 * t51
    t59 = np.copysign(t45, 1.0)
    t60 = (t53 + t53) * t57 + t49 * (4.0 * t58) + 4.0 * t46 * t59
    t61 = t56 * t56 - t48 * (4.0 * t45)
    t62 = np.maximum(0.0, t61)
    t63 = t50 * (0.5 - 0.5 * np.copysign(1.0, t60 - np.copysign(t62, 1.0)))
    t64 = 1.0 - t63
    t65 = t63 * (-0.5 * t56 - 0.5 * np.copysign(np.sqrt(t62), t56))
    t66 = 1.0 - t50
    t67 = 0.5 - 0.5 * np.copysign(1.0, t53 - t57)
    t68 = t66 * t67
    t69 = t50 * t56 / (t66 + t48 * (t50 + t50)) + t45 * t68 / (1.0 - t68 + t56 * t68)
    t70 = t45 * t63 / (t64 + t65) - t64 * t69
    t71 = t31 * (t35 + t36 * t70)
    t72 = t31 * (t38 + t34 * t70)
    t73 = t31 * (t39 + t33 * t70)
    t74 = t31 * t63
    t75 = t65 / (t64 + t48 * t63)
    t76 = t74 * (t35 + t36 * t75)
    t77 = t74 * (t38 + t34 * t75)
    t78 = t74 * (t39 + t33 * t75)
    t79 = t71 * leads1 + t72 * leads2 + t73 * leads3
    t80 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t71, 1.0), np.copysign(t72, 1.0)), np.copysign(t73, 1.0)) - np.copysign(t79, 1.0)
    t81 = 0.5 - 0.5 * np.copysign(1.0, t80)
    t82 = 1.0 - t81
    t83 = t81 / (t82 + t79 * t81)
    t84 = t76 * leads1 + t77 * leads2 + t78 * leads3
    t85 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t76, 1.0), np.copysign(t77, 1.0)), np.copysign(t78, 1.0)) - np.copysign(t84, 1.0)
    t86 = 0.5 - 0.5 * np.copysign(1.0, t85)
    t87 = 1.0 - t86
    t88 = t86 / (t87 + t84 * t86)
    t89 = t72 * t72
    t90 = t73 * (t37 * t72) - t40 * t89 - t43 * t89
    t91 = t77 * t77
    t92 = t78 * (t37 * t77) - t40 * t91 - t43 * t91
    t93 = t13 * t23
    t94 = l2 * (t5 * t10 + t6 * t11)
    t95 = -3.0 * t90 * (t89 * t93 + t89 * t94 + t73 * (t54 * t72))
    t96 = t72 * t89
    t97 = 3.0 * t19
    t98 = t95 + t93 * t96 + t94 * t96 + t89 * (t73 * t97)
    t99 = -3.0 * t92 * (t91 * t93 + t91 * t94 + t78 * (t54 * t77))
    t100 = t77 * t91
    t101 = t99 + t93 * t100 + t94 * t100 + t91 * (t78 * t97)
    t102 = 0.5 - 0.5 * np.copysign(1.0, t60 - np.copysign(np.maximum(0.0, -t61), 1.0))
    t103 = t50 * t102
    t104 = 4.0 + t31 * (t50 * t103 + t66 * (2.0 + t67)) - 4.0 * t31
    t105 = np.copysign((-(t101 + kappa_s)), 1.0) - np.copysign((-(t98 + kappa_s)), 1.0)
    t106 = t66 * (1.0 - t67) * (0.5 + 0.5 * np.copysign(1.0, t58 - t59))

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
    rates[..., 0] = t71
    rates[..., 1] = t72
    rates[..., 2] = t73
    rates[..., 3] = t76
    rates[..., 4] = t77
    rates[..., 5] = t78
    ratios[..., 0] = t83 * (t71 + leads1 * (t72 - t71))
    ratios[..., 1] = t83 * (t73 + leads3 * (t72 - t73))
    ratios[..., 2] = t88 * (t76 + leads1 * (t77 - t76))
    ratios[..., 3] = t88 * (t78 + leads3 * (t77 - t78))
    tracked[..., 0] = t90
    tracked[..., 1] = t92
    tracked_rate[..., 0] = -t98
    tracked_rate[..., 1] = -t101
    verdict[..., 0] = t104
    verdict[..., 1] = t31 * (1.0 + t63)
    verdict[..., 2] = t63 * (0.5 * t31) * (1.0 - np.copysign(1.0, t105))
    verdict[..., 3] = t31 * (t68 + t50 * (1.0 - t103) + t106)
    verdict[..., 4] = t74 * t87 + t31 * t82
    parabola[..., 0] = t48
    parabola[..., 1] = t56
    parabola[..., 2] = t44
    slack[..., 0] = t61
    least[..., 0] = t35
    least[..., 1] = t38
    least[..., 2] = t39
    null[..., 0] = t36
    null[..., 1] = t34
    null[..., 2] = t33
    return rates.reshape(_leading + (2, 3)), ratios.reshape(_leading + (2, 2)), tracked.reshape(_leading + (2,)), tracked_rate.reshape(_leading + (2,)), verdict.reshape(_leading + (5,)), parabola.reshape(_leading + (3,)), slack.reshape(_leading), least.reshape(_leading + (3,)), null.reshape(_leading + (3,))
