"""speed ratio of planar_ppp, in NumPy.

Made from templates/kernel.py.j2; inputs df049e074bcd02dce6a06cbe1225be143cb57a2068819aec7771ed4fe6dfd91c.
587 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 116 operations.

    in   q[3]
    in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
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
    heading3 = parameters[..., 5]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    kappa = curvature[..., 0]
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = cos_heading1 * sin_heading2 + cos_heading2 * sin_heading1
    t2 = cos_heading1 * cos_heading2 - sin_heading2 * sin_heading1
    t3 = t1 * tx - t2 * ty
    t4 = t1 * cos_heading3 + t2 * sin_heading3
    t5 = t2 * cos_heading3 - t1 * sin_heading3
    t6 = tx * t4 - ty * t5
    t7 = -t6
    t8 = sin_heading1 * tx - cos_heading1 * ty
    t9 = tx * t2 + t1 * ty
    t10 = t3 * t3 + t9 * t9
    t11 = tx * t5 + ty * t4
    t12 = t6 * t6 + t11 * t11
    t13 = t6 * (t3 + t3) + t11 * (t9 + t9)
    t14 = t8 + t8
    t15 = cos_heading1 * tx + sin_heading1 * ty
    t16 = t15 + t15
    t17 = t3 * t14 + t9 * t16
    t18 = t6 * t14 + t11 * t16
    t19 = t8 * t8 + t15 * t15
    t20 = l1 + q1
    t21 = l2 + q2
    t22 = l3 + q3
    t23 = np.sqrt((3.0 + t20 * t20 + t21 * t21 + t22 * t22))
    t24 = 1.4210854715202004e-14 * t23
    t25 = 0.5 - 0.5 * np.copysign(1.0, t24 - np.copysign(t7, 1.0))
    t26 = 1.0 - t25
    t27 = t9 * t26 + t11 * t25
    t28 = t3 * t26 + t6 * t25
    t29 = 0.5 - 0.5 * np.copysign(1.0, t24 - np.copysign((-t28), 1.0))
    t30 = t29 / (1.0 - t29 - t28 * t29)
    t31 = t9 * t25 + t11 * t26 + t27 * (t30 * (t3 * t25 + t6 * t26))
    t32 = t15 + t27 * (t8 * t30)

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
    A[..., 2] = -t8
    B[..., 0] = t10 * kappa
    B[..., 1] = kappa * t12
    B[..., 2] = kappa * t13
    B[..., 3] = kappa * t17
    B[..., 4] = kappa * t18
    B[..., 5] = kappa * t19
    B0[..., 0] = 0.0
    B0[..., 1] = 0.0
    B0[..., 2] = 0.0
    B0[..., 3] = 0.0
    B0[..., 4] = 0.0
    B0[..., 5] = 0.0
    B1[..., 0] = t10
    B1[..., 1] = t12
    B1[..., 2] = t13
    B1[..., 3] = t17
    B1[..., 4] = t18
    B1[..., 5] = t19
    a[..., 0] = t31 * t31
    a[..., 1] = (t31 + t31) * t32
    a[..., 2] = t32 * t32
    b[..., 0] = 0.0
    b[..., 1] = 0.0
    b[..., 2] = 0.0
    C[..., 0] = 0.0
    D[..., 0] = 0.0
    discriminant[..., 0] = 0.0
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 116 operations.

    in   q[3]
    in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
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
    heading3 = parameters[..., 5]
    cos_heading3 = np.cos(heading3)
    heading2 = parameters[..., 4]
    sin_heading2 = np.sin(heading2)
    cos_heading2 = np.cos(heading2)
    sin_heading3 = np.sin(heading3)
    kappa = curvature[..., 0]
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = sin_heading1 * tx - cos_heading1 * ty
    t2 = cos_heading1 * sin_heading2 + sin_heading1 * cos_heading2
    t3 = cos_heading1 * cos_heading2 - sin_heading1 * sin_heading2
    t4 = cos_heading3 * t2 + t3 * sin_heading3
    t5 = cos_heading3 * t3 - t2 * sin_heading3
    t6 = tx * t4 - ty * t5
    t7 = -t6
    t8 = tx * t2 - ty * t3
    t9 = tx * cos_heading1 + sin_heading1 * ty
    t10 = t1 * t1 + t9 * t9
    t11 = tx * t5 + ty * t4
    t12 = t6 * t6 + t11 * t11
    t13 = t1 + t1
    t14 = t9 + t9
    t15 = t6 * t13 + t11 * t14
    t16 = tx * t3 + ty * t2
    t17 = t8 * t13 + t14 * t16
    t18 = t6 * (t8 + t8) + t11 * (t16 + t16)
    t19 = t8 * t8 + t16 * t16
    t20 = l1 + q1
    t21 = l2 + q2
    t22 = l3 + q3
    t23 = np.sqrt((3.0 + t20 * t20 + t21 * t21 + t22 * t22))
    t24 = 1.4210854715202004e-14 * t23
    t25 = 0.5 - 0.5 * np.copysign(1.0, t24 - np.copysign(t7, 1.0))
    t26 = 1.0 - t25
    t27 = t9 * t26 + t11 * t25
    t28 = t1 * t26 + t6 * t25
    t29 = 0.5 - 0.5 * np.copysign(1.0, t24 - np.copysign((-t28), 1.0))
    t30 = t29 / (1.0 - t29 - t28 * t29)
    t31 = t9 * t25 + t11 * t26 + t27 * (t30 * (t1 * t25 + t6 * t26))
    t32 = t16 + t27 * (t8 * t30)

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
    A[..., 2] = -t8
    B[..., 0] = t10 * kappa
    B[..., 1] = kappa * t12
    B[..., 2] = kappa * t15
    B[..., 3] = kappa * t17
    B[..., 4] = kappa * t18
    B[..., 5] = kappa * t19
    B0[..., 0] = 0.0
    B0[..., 1] = 0.0
    B0[..., 2] = 0.0
    B0[..., 3] = 0.0
    B0[..., 4] = 0.0
    B0[..., 5] = 0.0
    B1[..., 0] = t10
    B1[..., 1] = t12
    B1[..., 2] = t15
    B1[..., 3] = t17
    B1[..., 4] = t18
    B1[..., 5] = t19
    a[..., 0] = t31 * t31
    a[..., 1] = (t31 + t31) * t32
    a[..., 2] = t32 * t32
    b[..., 0] = 0.0
    b[..., 1] = 0.0
    b[..., 2] = 0.0
    C[..., 0] = 0.0
    D[..., 0] = 0.0
    discriminant[..., 0] = 0.0
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 116 operations.

    in   q[3]
    in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
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
    heading3 = parameters[..., 5]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    kappa = curvature[..., 0]
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]

    # terms
    t1 = sin_heading1 * tx - cos_heading1 * ty
    t2 = cos_heading1 * sin_heading2 + sin_heading1 * cos_heading2
    t3 = cos_heading1 * cos_heading2 - sin_heading1 * sin_heading2
    t4 = tx * t2 - ty * t3
    t5 = -t4
    t6 = t2 * cos_heading3 + t3 * sin_heading3
    t7 = t3 * cos_heading3 - t2 * sin_heading3
    t8 = tx * t6 - ty * t7
    t9 = tx * cos_heading1 + sin_heading1 * ty
    t10 = t1 * t1 + t9 * t9
    t11 = tx * t3 + ty * t2
    t12 = t4 * t4 + t11 * t11
    t13 = t1 + t1
    t14 = t9 + t9
    t15 = t4 * t13 + t11 * t14
    t16 = tx * t7 + ty * t6
    t17 = t8 * t13 + t14 * t16
    t18 = t8 * (t4 + t4) + t16 * (t11 + t11)
    t19 = t8 * t8 + t16 * t16
    t20 = l1 + q1
    t21 = l2 + q2
    t22 = l3 + q3
    t23 = np.sqrt((3.0 + t20 * t20 + t21 * t21 + t22 * t22))
    t24 = 1.4210854715202004e-14 * t23
    t25 = 0.5 - 0.5 * np.copysign(1.0, t24 - np.copysign(t5, 1.0))
    t26 = 1.0 - t25
    t27 = t9 * t26 + t11 * t25
    t28 = t1 * t26 + t4 * t25
    t29 = 0.5 - 0.5 * np.copysign(1.0, t24 - np.copysign((-t28), 1.0))
    t30 = t29 / (1.0 - t29 - t28 * t29)
    t31 = t9 * t25 + t11 * t26 + t27 * (t30 * (t1 * t25 + t4 * t26))
    t32 = t16 + t27 * (t8 * t30)

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
    A[..., 2] = -t8
    B[..., 0] = t10 * kappa
    B[..., 1] = kappa * t12
    B[..., 2] = kappa * t15
    B[..., 3] = kappa * t17
    B[..., 4] = kappa * t18
    B[..., 5] = kappa * t19
    B0[..., 0] = 0.0
    B0[..., 1] = 0.0
    B0[..., 2] = 0.0
    B0[..., 3] = 0.0
    B0[..., 4] = 0.0
    B0[..., 5] = 0.0
    B1[..., 0] = t10
    B1[..., 1] = t12
    B1[..., 2] = t15
    B1[..., 3] = t17
    B1[..., 4] = t18
    B1[..., 5] = t19
    a[..., 0] = t31 * t31
    a[..., 1] = (t31 + t31) * t32
    a[..., 2] = t32 * t32
    b[..., 0] = 0.0
    b[..., 1] = 0.0
    b[..., 2] = 0.0
    C[..., 0] = 0.0
    D[..., 0] = 0.0
    discriminant[..., 0] = 0.0
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_rates(q, parameters, tangent, curvature, leading):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 239 operations.

    in   q[3]
    in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
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
    heading3 = parameters[..., 5]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    kappa = curvature[..., 0]
    leads1 = leading[..., 0]
    leads2 = leading[..., 1]
    leads3 = leading[..., 2]

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
    t11 = t8 * cos_heading3 + t9 * sin_heading3
    t12 = t9 * cos_heading3 - t8 * sin_heading3
    t13 = t5 * t11 - t6 * t12
    t14 = t5 * cos_heading1 + sin_heading1 * t6
    t15 = t7 * t7 + t10 * t10 + t13 * t13 + t14 * t14
    t16 = t5 * t9 + t6 * t8
    t17 = t5 * t12 + t6 * t11
    t18 = np.sqrt((t15 + t16 * t16 + t17 * t17))
    t19 = l1 + q1
    t20 = l2 + q2
    t21 = l3 + q3
    t22 = 3.0 + t19 * t19 + t20 * t20 + t21 * t21
    t23 = t13 * t16 - t10 * t17
    t24 = t7 * t17 - t13 * t14
    t25 = t10 * t14 - t7 * t16
    t26 = np.sqrt((t23 * t23 + t24 * t24 + t25 * t25))
    t27 = 0.5 * np.copysign(1.0, 1.4210854715202004e-14 * t18 * np.sqrt(t22) - np.copysign(t26, 1.0))
    t28 = 0.5 - t27
    t29 = t28 / (1.0 - t28 + t26 * t28)
    t30 = t25 * t29
    t31 = t24 * t29
    t32 = t29 * (t10 * t30 - t13 * t31)
    t33 = t23 * t29
    t34 = t29 * (t13 * t33 - t7 * t30)
    t35 = t29 * (t7 * t31 - t10 * t33)
    t36 = t32 * t32 + t34 * t34 + t35 * t35
    t37 = np.sqrt(t36)
    t38 = t22 * (t18 * (1.4210854715202004e-14 * t29))
    t39 = 0.5 - 0.5 * np.copysign(1.0, (t37 + t37) * t38)
    t40 = 0.5 - 0.5 * np.copysign(1.0, t38)
    t41 = 1.0 - t40
    t42 = t39 * t41
    t43 = np.copysign((-kappa), 1.0)
    t44 = t40 * (0.5 - 0.5 * np.copysign(1.0, 4.0 * t38 * t43))
    t45 = 1.0 - t44
    t46 = kappa * t42 / (1.0 - t42) * t45 - kappa * t44 / t45
    t47 = t28 * (t32 + t33 * t46)
    t48 = t28 * (t34 + t31 * t46)
    t49 = t28 * (t35 + t30 * t46)
    t50 = t28 * t44
    t51 = t32 * t50
    t52 = t34 * t50
    t53 = t35 * t50
    t54 = t47 * leads1 + t48 * leads2 + t49 * leads3
    t55 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t47, 1.0), np.copysign(t48, 1.0)), np.copysign(t49, 1.0)) - np.copysign(t54, 1.0)
    t56 = 0.5 - 0.5 * np.copysign(1.0, t55)
    t57 = 1.0 - t56
    t58 = t56 / (t57 + t54 * t56)
    t59 = t51 * leads1 + t52 * leads2 + t53 * leads3
    t60 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t51, 1.0), np.copysign(t52, 1.0)), np.copysign(t53, 1.0)) - np.copysign(t59, 1.0)
    t61 = 0.5 - 0.5 * np.copysign(1.0, t60)
    t62 = 1.0 - t61
    t63 = t61 / (t62 + t59 * t61)
    t64 = 4.0 + t28 * (t40 * t44 + t41 * (2.0 + t39)) - 4.0 * t28
    t65 = t41 * (1.0 - t39) * (0.5 + 0.5 * np.copysign(1.0, t36 * t38 - t43))

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
    rates[..., 0] = t47
    rates[..., 1] = t48
    rates[..., 2] = t49
    rates[..., 3] = t51
    rates[..., 4] = t52
    rates[..., 5] = t53
    ratios[..., 0] = t58 * (t47 + leads1 * (t48 - t47))
    ratios[..., 1] = t58 * (t49 + leads3 * (t48 - t49))
    ratios[..., 2] = t63 * (t51 + leads1 * (t52 - t51))
    ratios[..., 3] = t63 * (t53 + leads3 * (t52 - t53))
    tracked[..., 0] = 0.0
    tracked[..., 1] = 0.0
    tracked_rate[..., 0] = 0.0
    tracked_rate[..., 1] = 0.0
    verdict[..., 0] = t64
    verdict[..., 1] = t28 * (1.0 + t44)
    verdict[..., 2] = 0.0
    verdict[..., 3] = t28 * (t42 + t40 * t45 + t65)
    verdict[..., 4] = t50 * t62 + t28 * t57
    parabola[..., 0] = 0.0
    parabola[..., 1] = 0.0
    parabola[..., 2] = 0.0
    slack[..., 0] = 0.0
    least[..., 0] = t32
    least[..., 1] = t34
    least[..., 2] = t35
    null[..., 0] = t33
    null[..., 1] = t31
    null[..., 2] = t30
    return rates.reshape(_leading + (2, 3)), ratios.reshape(_leading + (2, 2)), tracked.reshape(_leading + (2,)), tracked_rate.reshape(_leading + (2,)), verdict.reshape(_leading + (5,)), parabola.reshape(_leading + (3,)), slack.reshape(_leading), least.reshape(_leading + (3,)), null.reshape(_leading + (3,))
