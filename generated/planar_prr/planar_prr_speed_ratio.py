"""speed ratio of planar_prr, in NumPy.

Made from templates/kernel.py.j2; inputs 0ecbae4c3f69ec4121195092879b867f33f31a1d40fc11afb9278dc265ead913.
900 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 172 operations.

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
    t31 = np.sqrt((1.0 + t1 * t1 + l2 * l2 + l3 * l3))
    t32 = 1.4210854715202004e-14 * t31
    t33 = 0.5 - 0.5 * np.copysign(1.0, t32 - np.copysign(t14, 1.0))
    t34 = 1.0 - t33
    t35 = t19 * t34 + t21 * t33
    t36 = t12 * t34 + t13 * t33
    t37 = 0.5 - 0.5 * np.copysign(1.0, t32 - np.copysign((-t36), 1.0))
    t38 = t37 / (1.0 - t37 - t36 * t37)
    t39 = t38 * (t12 * t33 + t13 * t34)
    t40 = t19 * t33 + t21 * t34 + t35 * t39
    t41 = t40 * t40
    t42 = t15 * t38
    t43 = t26 + t35 * t42
    t44 = (t40 + t40) * t43
    t45 = t43 * t43
    t46 = t18 * t34 + t17 * t33
    t47 = t18 * t33 + t17 * t34 + t46 * (t39 * t39) + t23 * t39
    t48 = t39 * (t42 * (t46 + t46)) + t23 * t42
    t49 = t46 * (t42 * t42)
    t50 = t48 * (t44 + t44) - t49 * (4.0 * t41) - t47 * (4.0 * t45)
    t51 = t48 * t48 - t49 * (4.0 * t47)

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
    a[..., 0] = t41
    a[..., 1] = t44
    a[..., 2] = t45
    b[..., 0] = t47
    b[..., 1] = t48
    b[..., 2] = t49
    C[..., 0] = t50
    D[..., 0] = t51
    discriminant[..., 0] = t51 + kappa * t50
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 172 operations.

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
    t31 = np.sqrt((1.0 + t10 * t10 + l2 * l2 + l3 * l3))
    t32 = 1.4210854715202004e-14 * t31
    t33 = 0.5 - 0.5 * np.copysign(1.0, t32 - np.copysign(t9, 1.0))
    t34 = 1.0 - t33
    t35 = t16 * t34 + t20 * t33
    t36 = t1 * t34 + t8 * t33
    t37 = 0.5 - 0.5 * np.copysign(1.0, t32 - np.copysign((-t36), 1.0))
    t38 = t37 / (1.0 - t37 - t36 * t37)
    t39 = t38 * (t1 * t33 + t8 * t34)
    t40 = t16 * t33 + t20 * t34 + t35 * t39
    t41 = t40 * t40
    t42 = t15 * t38
    t43 = t25 + t35 * t42
    t44 = (t40 + t40) * t43
    t45 = t43 * t43
    t46 = t19 * t33
    t47 = t19 * t34 + t46 * (t39 * t39)
    t48 = t27 * t33
    t49 = t27 * t34 + t39 * (t42 * (t46 + t46)) + t39 * t48
    t50 = t29 + t46 * (t42 * t42) + t42 * t48
    t51 = t49 * (t44 + t44) - t50 * (4.0 * t41) - t47 * (4.0 * t45)
    t52 = t49 * t49 - t50 * (4.0 * t47)

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
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 172 operations.

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
    t31 = np.sqrt((1.0 + t2 * t2 + l2 * l2 + l3 * l3))
    t32 = 1.4210854715202004e-14 * t31
    t33 = 0.5 - 0.5 * np.copysign(1.0, t32 - np.copysign(t14, 1.0))
    t34 = 1.0 - t33
    t35 = t16 * t34 + t21 * t33
    t36 = t1 * t34 + t13 * t33
    t37 = 0.5 - 0.5 * np.copysign(1.0, t32 - np.copysign((-t36), 1.0))
    t38 = t37 / (1.0 - t37 - t36 * t37)
    t39 = t38 * (t1 * t33 + t13 * t34)
    t40 = t16 * t33 + t21 * t34 + t35 * t39
    t41 = t40 * t40
    t42 = t15 * t38
    t43 = t26 + t35 * t42
    t44 = (t40 + t40) * t43
    t45 = t43 * t43
    t46 = t20 * t33
    t47 = t20 * t34 + t46 * (t39 * t39)
    t48 = t28 * t33
    t49 = t28 * t34 + t39 * (t42 * (t46 + t46)) + t39 * t48
    t50 = t19 + t46 * (t42 * t42) + t42 * t48
    t51 = t49 * (t44 + t44) - t50 * (4.0 * t41) - t47 * (4.0 * t45)
    t52 = t49 * t49 - t50 * (4.0 * t47)

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
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 384 operations.

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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
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
    t12 = t10 * c3 - t11 * s3
    t13 = t12 * l3
    t14 = t9 + t10 * l2 + t13 - t9
    t15 = sin_heading1 * t8
    t16 = c3 * t11 + t10 * s3
    t17 = l3 * t16
    t18 = t15 + l2 * t11 + t17 - t15
    t19 = t5 * t14 + t6 * t18
    t20 = t5 * t13 + t6 * t17
    t21 = t5 * cos_heading1 + sin_heading1 * t6
    t22 = t7 * t7 + t19 * t19 + t20 * t20 + t21 * t21
    t23 = t6 * t14 - t5 * t18
    t24 = t6 * t13 - t5 * t17
    t25 = np.sqrt((t22 + t23 * t23 + t24 * t24))
    t26 = 1.0 + t8 * t8 + l2 * l2 + l3 * l3
    t27 = t20 * t23 - t19 * t24
    t28 = t7 * t24 - t20 * t21
    t29 = t19 * t21 - t7 * t23
    t30 = np.sqrt((t27 * t27 + t28 * t28 + t29 * t29))
    t31 = 0.5 * np.copysign(1.0, 1.4210854715202004e-14 * t25 * np.sqrt(t26) - np.copysign(t30, 1.0))
    t32 = 0.5 - t31
    t33 = t32 / (1.0 - t32 + t30 * t32)
    t34 = t29 * t33
    t35 = t28 * t33
    t36 = t33 * (t19 * t34 - t20 * t35)
    t37 = t27 * t33
    t38 = t26 * (t25 * (1.4210854715202004e-14 * t33))
    t39 = t5 * t11 - t6 * t10
    t40 = l2 * t39
    t41 = t5 * t16 - t6 * t12
    t42 = l3 * t41
    t43 = t34 + t35
    t44 = t40 * (t35 * t35) + t42 * (t43 * t43)
    t45 = -t44
    t46 = np.copysign(t45, 1.0)
    t47 = 0.5 - 0.5 * np.copysign(1.0, t38 - t46)
    t48 = t33 * (t20 * t37 - t7 * t34)
    t49 = t48 * t48
    t50 = t33 * (t7 * t35 - t19 * t37)
    t51 = t36 * t36 + t49 + t50 * t50
    t52 = np.sqrt(t51)
    t53 = t38 * (t52 + t52)
    t54 = t48 + t50
    t55 = t35 * (t48 * (l2 * (-2.0 * t39))) - t43 * (l3 * (t41 + t41) * t54)
    t56 = np.copysign(t55, 1.0)
    t57 = t38 * t51
    t58 = t40 * t49 + t42 * (t54 * t54)
    t59 = t58 + kappa
    t60 = np.copysign((-t59), 1.0)
    t61 = (t53 + t53) * t56 + t46 * (4.0 * t57) + 4.0 * t38 * t60
    t62 = t55 * t55 - t44 * (4.0 * t59)
    t63 = np.maximum(0.0, t62)
    t64 = t47 * (0.5 - 0.5 * np.copysign(1.0, t61 - np.copysign(t63, 1.0)))
    t65 = 1.0 - t64
    t66 = 0.5 - 0.5 * np.copysign(1.0, t53 - t56)
    t67 = 1.0 - t47
    t68 = t66 * t67
    t69 = t59 * t68 / (1.0 - t68 + t55 * t68) - t47 * t55 / (t67 - t44 * (t47 + t47))
    t70 = t64 * (-0.5 * t55 - 0.5 * np.copysign(np.sqrt(t63), t55))
    t71 = t65 * t69 - t59 * t64 / (t65 + t70)
    t72 = t32 * (t36 + t37 * t71)
    t73 = t32 * (t48 + t35 * t71)
    t74 = t32 * (t50 + t34 * t71)
    t75 = t32 * t64
    t76 = t70 / (t65 - t44 * t64)
    t77 = t75 * (t36 + t37 * t76)
    t78 = t75 * (t48 + t35 * t76)
    t79 = t75 * (t50 + t34 * t76)
    t80 = t72 * leads1 + t73 * leads2 + t74 * leads3
    t81 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t72, 1.0), np.copysign(t73, 1.0)), np.copysign(t74, 1.0)) - np.copysign(t80, 1.0)
    t82 = 0.5 - 0.5 * np.copysign(1.0, t81)
    t83 = 1.0 - t82
    t84 = t82 / (t83 + t80 * t82)
    t85 = t77 * leads1 + t78 * leads2 + t79 * leads3
    t86 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t77, 1.0), np.copysign(t78, 1.0)), np.copysign(t79, 1.0)) - np.copysign(t85, 1.0)
    t87 = 0.5 - 0.5 * np.copysign(1.0, t86)
    t88 = 1.0 - t87
    t89 = t87 / (t88 + t85 * t87)
    t90 = t73 * t73
    t91 = t73 + t74
    t92 = t91 * t91
    t93 = t40 * t90 + t42 * t92
    t94 = t78 * t78
    t95 = t78 + t79
    t96 = t95 * t95
    t97 = t40 * t94 + t42 * t96
    t98 = l2 * (t5 * t10 + t6 * t11)
    t99 = l3 * (t5 * t12 + t6 * t16)
    t100 = -3.0 * t93 * (t90 * t98 + t92 * t99) - t98 * (t73 * t90)
    t101 = t100 - t99 * (t91 * t92)
    t102 = -3.0 * t97 * (t94 * t98 + t96 * t99) - t98 * (t78 * t94)
    t103 = t102 - t99 * (t95 * t96)
    t104 = 0.5 - 0.5 * np.copysign(1.0, t61 - np.copysign(np.maximum(0.0, -t62), 1.0))
    t105 = t47 * t104
    t106 = 4.0 + t32 * (t47 * t105 + t67 * (2.0 + t66)) - 4.0 * t32
    t107 = 1.0 - np.copysign(1.0, np.copysign((t103 - kappa_s), 1.0) - np.copysign((t101 - kappa_s), 1.0))
    t108 = t67 * (1.0 - t66) * (0.5 + 0.5 * np.copysign(1.0, t57 - t60))

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
    ratios[..., 0] = t84 * (t72 + leads1 * (t73 - t72))
    ratios[..., 1] = t84 * (t74 + leads3 * (t73 - t74))
    ratios[..., 2] = t89 * (t77 + leads1 * (t78 - t77))
    ratios[..., 3] = t89 * (t79 + leads3 * (t78 - t79))
    tracked[..., 0] = -t93
    tracked[..., 1] = -t97
    tracked_rate[..., 0] = t101
    tracked_rate[..., 1] = t103
    verdict[..., 0] = t106
    verdict[..., 1] = t32 * (1.0 + t64)
    verdict[..., 2] = t64 * (0.5 * t32) * t107
    verdict[..., 3] = t32 * (t68 + t47 * (1.0 - t105) + t108)
    verdict[..., 4] = t75 * t88 + t32 * t83
    parabola[..., 0] = t45
    parabola[..., 1] = t55
    parabola[..., 2] = -t58
    slack[..., 0] = t62
    least[..., 0] = t36
    least[..., 1] = t48
    least[..., 2] = t50
    null[..., 0] = t37
    null[..., 1] = t35
    null[..., 2] = t34
    return rates.reshape(_leading + (2, 3)), ratios.reshape(_leading + (2, 2)), tracked.reshape(_leading + (2,)), tracked_rate.reshape(_leading + (2,)), verdict.reshape(_leading + (5,)), parabola.reshape(_leading + (3,)), slack.reshape(_leading), least.reshape(_leading + (3,)), null.reshape(_leading + (3,))
