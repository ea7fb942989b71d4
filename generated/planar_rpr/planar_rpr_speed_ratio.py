"""speed ratio of planar_rpr, in NumPy.

Made from templates/kernel.py.j2; inputs 178ae5954533afec5527ca5b7b5103ff22ac829c78aa719ec532041a398937a9.
1003 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 181 operations.

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
    t21 = -2 * t14
    t22 = t13 + t13
    t23 = ty * t11 - tx * t12
    t24 = t23 + t23
    t25 = t3 * t22 + t14 * t24
    t26 = l3 * (t16 + t16)
    t27 = t8 * t22 + t18 * t24
    t28 = t17 + (t3 * t10 + l1 * (s1 * tx - c1 * ty))
    t29 = t13 * t13 + t23 * t23
    t30 = 1.4210854715202004e-14 * np.sqrt((t10 * t10 + l1 * l1 + l3 * l3))
    t31 = 0.5 - 0.5 * np.copysign(1, t30 - np.copysign(t9, 1))
    t32 = 1 - t31
    t33 = t14 * t32 + t18 * t31
    t34 = t3 * t32 + t8 * t31
    t35 = 1.4210854715202004e-14 + t30 * t31 - 1.4210854715202004e-14 * t31 - np.copysign((-t34), 1)
    t36 = 0.5 - 0.5 * np.copysign(1, t35)
    t37 = t36 / (1 - t36 - t34 * t36)
    t38 = t37 * (t3 * t31 + t8 * t32)
    t39 = t14 * t31 + t18 * t32 + t33 * t38
    t40 = t39 * t39
    t41 = t13 * t37
    t42 = t23 + t33 * t41
    t43 = (t39 + t39) * t42
    t44 = t42 * t42
    t45 = t17 * t31
    t46 = t17 * t32 + t45 * (t38 * t38)
    t47 = t21 * t31 + t26 * t32 + t38 * (t41 * (t45 + t45))
    t48 = t21 * t32 + t26 * t31
    t49 = t47 + t38 * t48
    t50 = t28 + t45 * (t41 * t41) + t41 * t48
    t51 = t49 * (t43 + t43) - t50 * (4 * t40) - t46 * (4 * t44)
    t52 = t49 * t49 - t50 * (4 * t46)

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
    a[..., 0] = t40
    a[..., 1] = t43
    a[..., 2] = t44
    b[..., 0] = t46
    b[..., 1] = t49
    b[..., 2] = t50
    C[..., 0] = t51
    D[..., 0] = t52
    discriminant[..., 0] = t52 + kappa * t51
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 180 operations.

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
    t26 = -2 * t25
    t27 = t13 * t22 + t23 * t25
    t28 = t11 * (t13 + t13) + t19 * (t25 + t25)
    t29 = t13 * t13 + t25 * t25
    t30 = 1.4210854715202004e-14 * np.sqrt((t2 * t2 + l1 * l1 + l3 * l3))
    t31 = 0.5 - 0.5 * np.copysign(1, t30 - np.copysign(t12, 1))
    t32 = 1 - t31
    t33 = t17 * t32 + t19 * t31
    t34 = t10 * t32 + t11 * t31
    t35 = 0.5 - 0.5 * np.copysign(1, t30 - np.copysign((-t34), 1))
    t36 = t35 / (1 - t35 - t34 * t35)
    t37 = t36 * (t10 * t31 + t11 * t32)
    t38 = t17 * t31 + t19 * t32 + t33 * t37
    t39 = t38 * t38
    t40 = t13 * t36
    t41 = t25 + t33 * t40
    t42 = (t38 + t38) * t41
    t43 = t41 * t41
    t44 = t16 * t32 + t15 * t31
    t45 = t16 * t31 + t15 * t32 + t44 * (t37 * t37) + t21 * t37
    t46 = t26 * t31 + t37 * (t40 * (t44 + t44)) + t21 * t40
    t47 = t26 * t32
    t48 = t46 + t37 * t47
    t49 = t44 * (t40 * t40) + t40 * t47
    t50 = t48 * (t42 + t42) - t49 * (4 * t39) - t45 * (4 * t43)
    t51 = t48 * t48 - t49 * (4 * t45)

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
    a[..., 0] = t39
    a[..., 1] = t42
    a[..., 2] = t43
    b[..., 0] = t45
    b[..., 1] = t48
    b[..., 2] = t49
    C[..., 0] = t50
    D[..., 0] = t51
    discriminant[..., 0] = t51 + kappa * t50
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 180 operations.

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
    t21 = -2 * t19
    t22 = t10 + t10
    t23 = t17 + t17
    t24 = t11 * t22 + t19 * t23
    t25 = l3 * (t14 + t14)
    t26 = t5 * ty - tx * t8
    t27 = t13 * t22 + t23 * t26
    t28 = t13 * (t11 + t11) + t26 * (t19 + t19)
    t29 = t13 * t13 + t26 * t26
    t30 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign(t12, 1))
    t31 = 1 - t30
    t32 = t17 * t31 + t19 * t30
    t33 = 1.4210854715202004e-14 * np.sqrt((t2 * t2 + l1 * l1 + l3 * l3))
    t34 = t10 * t31 + t11 * t30
    t35 = np.copysign(1, 1.4210854715202004e-14 * t30 + t31 * t33 - np.copysign((-t34), 1))
    t36 = 0.5 - 0.5 * t35
    t37 = t36 / (1 - t36 - t34 * t36)
    t38 = t37 * (t10 * t30 + t11 * t31)
    t39 = t17 * t30 + t19 * t31 + t32 * t38
    t40 = t39 * t39
    t41 = t13 * t37
    t42 = t26 + t32 * t41
    t43 = (t39 + t39) * t42
    t44 = t42 * t42
    t45 = t16 * t31
    t46 = t16 * t30 + t45 * (t38 * t38) + t21 * t38
    t47 = t25 * t30 + t38 * (t41 * (t45 + t45)) + t21 * t41
    t48 = t25 * t31
    t49 = t47 + t38 * t48
    t50 = t15 + t45 * (t41 * t41) + t41 * t48
    t51 = t49 * (t43 + t43) - t50 * (4 * t40) - t46 * (4 * t44)
    t52 = t49 * t49 - t50 * (4 * t46)

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
    a[..., 0] = t40
    a[..., 1] = t43
    a[..., 2] = t44
    b[..., 0] = t46
    b[..., 1] = t49
    b[..., 2] = t50
    C[..., 0] = t51
    D[..., 0] = t52
    discriminant[..., 0] = t52 + kappa * t51
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_rates(q, parameters, tangent, curvature, leading):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 462 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    kappa = curvature[..., 0]
    leads1 = leading[..., 0]
    leads3 = leading[..., 2]
    leads2 = leading[..., 1]
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
    t9 = t6 * c3 - t8 * s3
    t10 = t9 * l3
    t11 = c1 * l1 + t6 * t7 + t10
    t12 = t3 / t4
    t13 = c3 * t8 + t6 * s3
    t14 = l3 * t13
    t15 = l1 * s1 + t7 * t8 + t14
    t16 = t5 * t11 + t12 * t15
    t17 = t5 * t10 + t12 * t14
    t18 = t11 * t12 - t5 * t15
    t19 = t10 * t12 - t5 * t14
    t20 = t16 * t16 + t17 * t17 + t18 * t18 + t19 * t19
    t21 = np.sqrt((t7 * t7 + l1 * l1 + l3 * l3))
    t22 = t21 + (0.5 + 0.5 * np.copysign(1, 7.888609052210118e-31 - np.copysign(t21, 1)))
    t23 = t22 * t22
    t24 = 1.4210854715202004e-14 * np.sqrt((t20 + t23))
    t25 = 1.4142135623730951 * t22
    t26 = t5 * t6 + t8 * t12
    t27 = t5 * t8 - t6 * t12
    t28 = t17 * t26 - t19 * t27
    t29 = t28 * t28
    t30 = t18 * t27 - t16 * t26
    t31 = t30 * t30
    t32 = t16 * t19 - t17 * t18
    t33 = t32 * t32
    t34 = np.sqrt((t29 + t31 + t33 / t23))
    t35 = 0.5 - 0.5 * np.copysign(1, t24 * t25 - np.copysign((t22 * t34), 1))
    t36 = 1 - t35
    t37 = t35 / (t36 + t35 * np.sqrt((t31 + (t29 + t33))))
    t38 = t30 * t37
    t39 = t32 * t37
    t40 = t37 * (t27 * t38 - t17 * t39)
    t41 = t28 * t37
    t42 = t26 + t26
    t43 = t37 * (t17 * t41 - t16 * t38)
    t44 = t7 * t27
    t45 = t40 * t40
    t46 = t5 * s1 - c1 * t12
    t47 = l1 * t46
    t48 = t5 * t13 - t9 * t12
    t49 = l3 * t48
    t50 = t37 * (t16 * t39 - t27 * t41)
    t51 = t40 + t50
    t52 = t40 * t42 * t43 - t44 * t45 - t45 * t47 - t49 * (t51 * t51)
    t53 = t52 - kappa
    t54 = t24 * t35 / t22 * (t25 * t25) / (t36 + t34 * t35)
    t55 = t34 * t37
    t56 = t54 * (t55 * t55)
    t57 = t41 * t41
    t58 = t38 + t41
    t59 = t39 * (t41 * t42) - t44 * t57 - t47 * t57 - t49 * (t58 * t58)
    t60 = np.copysign(t59, 1)
    t61 = 0.5 - 0.5 * np.copysign(1, t56 - t60)
    t62 = t45 + t50 * t50 + t43 * t43 / t23
    t63 = np.sqrt(t62)
    t64 = t54 * (t55 * (t63 + t63))
    t65 = t27 + t27
    t66 = t42 * (t39 * t40 + t41 * t43) - t41 * (t40 * (t7 * t65))
    t67 = t66 - t41 * (t40 * (l1 * (t46 + t46))) - t58 * (t51 * (l3 * (t48 + t48)))
    t68 = np.copysign(t67, 1)
    t69 = t54 * t62
    t70 = np.copysign(t53, 1)
    t71 = (t64 + t64) * t68 + t60 * (4 * t69) + 4 * t56 * t70
    t72 = t67 * t67 - t59 * (4 * t53)
    t73 = np.maximum(0.0, t72)
    t74 = t61 * (0.5 - 0.5 * np.copysign(1, t71 - np.copysign(t73, 1)))
    t75 = 1 - t74
    t76 = t74 * (-0.5 * t67 - 0.5 * np.copysign(np.sqrt(t73), t67))
    t77 = 1 - t61
    t78 = 0.5 - 0.5 * np.copysign(1, t64 - t68)
    t79 = t77 * t78
    t80 = t61 * t67 / (t77 + t59 * (t61 + t61)) + t53 * t79 / (1 - t79 + t67 * t79)
    t81 = t53 * t74 / (t75 + t76) - t75 * t80
    t82 = t35 * (t40 + t41 * t81)
    t83 = t35 * (t43 + t39 * t81)
    t84 = t35 * (t50 + t38 * t81)
    t85 = t35 * t74
    t86 = t76 / (t75 + t59 * t74)
    t87 = t85 * (t40 + t41 * t86)
    t88 = t85 * (t43 + t39 * t86)
    t89 = t85 * (t50 + t38 * t86)
    t90 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t82, 1), np.copysign(t84, 1)), np.copysign((t83 / t22), 1))
    t91 = leads1 + leads3 + t22 * leads2
    t92 = t82 * leads1 + t83 * leads2 + t84 * leads3
    t93 = 0.5 - 0.5 * np.copysign(1, t90 * t91 - np.copysign(t92, 1))
    t94 = 1 - t93
    t95 = t93 / (t94 + t92 * t93)
    t96 = 1 - leads1
    t97 = 1 - leads3
    t98 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t87, 1), np.copysign(t89, 1)), np.copysign((t88 / t22), 1))
    t99 = t87 * leads1 + t88 * leads2 + t89 * leads3
    t100 = 0.5 - 0.5 * np.copysign(1, t91 * t98 - np.copysign(t99, 1))
    t101 = 1 - t100
    t102 = t100 / (t101 + t99 * t100)
    t103 = t82 * t82
    t104 = t82 + t84
    t105 = t104 * t104
    t106 = t83 * (t42 * t82) - t44 * t103 - t47 * t103 - t49 * t105
    t107 = t87 * t87
    t108 = t87 + t89
    t109 = t108 * t108
    t110 = t88 * (t42 * t87) - t44 * t107 - t47 * t107 - t49 * t109
    t111 = t7 * t26
    t112 = l1 * (t5 * c1 + s1 * t12)
    t113 = l3 * (t5 * t9 + t12 * t13)
    t114 = t103 * t111 + t103 * t112 + t105 * t113 + t83 * (t65 * t82)
    t115 = t82 * t103
    t116 = -3 * t106 * t114 + t111 * t115 + t112 * t115 + t113 * (t104 * t105)
    t117 = 3 * t27
    t118 = t116 + t103 * (t83 * t117)
    t119 = t107 * t111 + t107 * t112 + t109 * t113 + t88 * (t65 * t87)
    t120 = t87 * t107
    t121 = -3 * t110 * t119 + t111 * t120 + t112 * t120 + t113 * (t108 * t109)
    t122 = t121 + t107 * (t88 * t117)
    t123 = 0.5 - 0.5 * np.copysign(1, t71 - np.copysign(np.maximum(0.0, -t72), 1))
    t124 = t61 * t123
    t125 = 4 + t35 * (t61 * t124 + t77 * (2 + t78)) - 4 * t35
    t126 = np.copysign((-(t122 + kappa_s)), 1) - np.copysign((-(t118 + kappa_s)), 1)
    t127 = t77 * (1 - t78) * (0.5 + 0.5 * np.copysign(1, t69 - t70))

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
    tracked[..., 0] = t106
    tracked[..., 1] = t110
    tracked_rate[..., 0] = -t118
    tracked_rate[..., 1] = -t122
    verdict[..., 0] = t125
    verdict[..., 1] = t35 * (1 + t74)
    verdict[..., 2] = t74 * (0.5 * t35) * (1 - np.copysign(1, t126))
    verdict[..., 3] = t35 * (t79 + t61 * (1 - t124) + t127)
    verdict[..., 4] = t85 * t101 + t35 * t94
    parabola[..., 0] = t59
    parabola[..., 1] = t67
    parabola[..., 2] = t52
    slack[..., 0] = t72
    least[..., 0] = t40
    least[..., 1] = t43
    least[..., 2] = t50
    null[..., 0] = t41
    null[..., 1] = t39
    null[..., 2] = t38
    return rates.reshape(_leading + (2, 3)), ratios.reshape(_leading + (2, 2)), tracked.reshape(_leading + (2,)), tracked_rate.reshape(_leading + (2,)), verdict.reshape(_leading + (5,)), parabola.reshape(_leading + (3,)), slack.reshape(_leading), least.reshape(_leading + (3,)), null.reshape(_leading + (3,))
