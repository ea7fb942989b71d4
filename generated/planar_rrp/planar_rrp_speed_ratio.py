"""speed ratio of planar_rrp, in NumPy.

Made from templates/kernel.py.j2; inputs a77b81486db828bd284f5cfb02e8762176718d8c276020b386ffce3094ac9a5c.
1030 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 191 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
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
    l1 = parameters[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * l1
    t2 = c1 * c2 - s1 * s2
    t3 = c1 * s2 + c2 * s1
    t4 = t2 * cos_heading3 - t3 * sin_heading3
    t5 = l3 + q3
    t6 = t1 + t2 * l2 + t4 * t5
    t7 = t6 - t1
    t8 = l1 * s1
    t9 = cos_heading3 * t3 + t2 * sin_heading3
    t10 = t8 + l2 * t3 + t5 * t9
    t11 = t10 - t8
    t12 = t7 * tx + t11 * ty
    t13 = tx * t9 - t4 * ty
    t14 = -t13
    t15 = t6 * tx + t10 * ty
    t16 = t5 * t13
    t17 = t3 * tx - t2 * ty
    t18 = l2 * t17
    t19 = t16 + t18
    t20 = t7 * ty - tx * t11
    t21 = t12 * t12 + t20 * t20
    t22 = t4 * tx + t9 * ty
    t23 = t13 * t13 + t22 * t22
    t24 = -2 * t22
    t25 = t13 * (t12 + t12) + t22 * (t20 + t20)
    t26 = t5 * (t13 + t13) + l2 * (t17 + t17)
    t27 = t15 + t15
    t28 = t6 * ty - tx * t10
    t29 = t28 + t28
    t30 = t12 * t27 + t20 * t29
    t31 = t13 * t27 + t22 * t29
    t32 = t18 + (t16 + l1 * (s1 * tx - c1 * ty))
    t33 = t15 * t15 + t28 * t28
    t34 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign(t14, 1))
    t35 = 1 - t34
    t36 = t20 * t35 + t22 * t34
    t37 = 1.4210854715202004e-14 * np.sqrt((t5 * t5 + l1 * l1 + l2 * l2))
    t38 = t12 * t35 + t13 * t34
    t39 = np.copysign(1, 1.4210854715202004e-14 * t34 + t35 * t37 - np.copysign((-t38), 1))
    t40 = 0.5 - 0.5 * t39
    t41 = t40 / (1 - t40 - t38 * t40)
    t42 = t41 * (t12 * t34 + t13 * t35)
    t43 = t20 * t34 + t22 * t35 + t36 * t42
    t44 = t43 * t43
    t45 = t15 * t41
    t46 = t28 + t36 * t45
    t47 = (t43 + t43) * t46
    t48 = t46 * t46
    t49 = t19 * t35
    t50 = t19 * t34 + t49 * (t42 * t42) + t24 * t42
    t51 = t24 * t35 + t26 * t34 + t42 * (t45 * (t49 + t49))
    t52 = t24 * t34 + t26 * t35
    t53 = t51 + t24 * t45 + t42 * t52
    t54 = t32 + t49 * (t45 * t45) + t45 * t52
    t55 = t53 * (t47 + t47) - t54 * (4 * t44) - t50 * (4 * t48)
    t56 = t53 * t53 - t54 * (4 * t50)

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
    B[..., 0] = t19 + t21 * kappa
    B[..., 1] = kappa * t23
    B[..., 2] = t24 + kappa * t25
    B[..., 3] = t26 + kappa * t30
    B[..., 4] = t24 + kappa * t31
    B[..., 5] = t32 + kappa * t33
    B0[..., 0] = t19
    B0[..., 1] = 0.0
    B0[..., 2] = t24
    B0[..., 3] = t26
    B0[..., 4] = t24
    B0[..., 5] = t32
    B1[..., 0] = t21
    B1[..., 1] = t23
    B1[..., 2] = t25
    B1[..., 3] = t30
    B1[..., 4] = t31
    B1[..., 5] = t33
    a[..., 0] = t44
    a[..., 1] = t47
    a[..., 2] = t48
    b[..., 0] = t50
    b[..., 1] = t53
    b[..., 2] = t54
    C[..., 0] = t55
    D[..., 0] = t56
    discriminant[..., 0] = t56 + kappa * t55
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 191 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
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
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * l1
    t2 = c1 * c2 - s1 * s2
    t3 = c1 * s2 + c2 * s1
    t4 = t2 * cos_heading3 - t3 * sin_heading3
    t5 = l3 + q3
    t6 = t1 + t2 * l2 + t4 * t5
    t7 = l1 * s1
    t8 = cos_heading3 * t3 + t2 * sin_heading3
    t9 = t7 + l2 * t3 + t5 * t8
    t10 = tx * t6 + ty * t9
    t11 = tx * t8 - t4 * ty
    t12 = -t11
    t13 = t6 - t1
    t14 = t9 - t7
    t15 = tx * t13 + ty * t14
    t16 = t5 * t11
    t17 = tx * t3 - t2 * ty
    t18 = l2 * t17
    t19 = t16 + l1 * (tx * s1 - c1 * ty) + t18
    t20 = t6 * ty - tx * t9
    t21 = t10 * t10 + t20 * t20
    t22 = tx * t4 + ty * t8
    t23 = t11 * t11 + t22 * t22
    t24 = -2 * t22
    t25 = t10 + t10
    t26 = t20 + t20
    t27 = t11 * t25 + t22 * t26
    t28 = t5 * (t11 + t11) + l2 * (t17 + t17)
    t29 = ty * t13 - tx * t14
    t30 = t15 * t25 + t26 * t29
    t31 = t11 * (t15 + t15) + t22 * (t29 + t29)
    t32 = t16 + t18
    t33 = t15 * t15 + t29 * t29
    t34 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign(t12, 1))
    t35 = 1 - t34
    t36 = t20 * t35 + t22 * t34
    t37 = 1.4210854715202004e-14 * np.sqrt((t5 * t5 + l1 * l1 + l2 * l2))
    t38 = t10 * t35 + t11 * t34
    t39 = np.copysign(1, 1.4210854715202004e-14 * t34 + t35 * t37 - np.copysign((-t38), 1))
    t40 = 0.5 - 0.5 * t39
    t41 = t40 / (1 - t40 - t38 * t40)
    t42 = t41 * (t10 * t34 + t11 * t35)
    t43 = t20 * t34 + t22 * t35 + t36 * t42
    t44 = t43 * t43
    t45 = t15 * t41
    t46 = t29 + t36 * t45
    t47 = (t43 + t43) * t46
    t48 = t46 * t46
    t49 = t19 * t35
    t50 = t19 * t34 + t49 * (t42 * t42) + t24 * t42
    t51 = t24 * t35 + t28 * t34 + t42 * (t45 * (t49 + t49))
    t52 = t24 * t34 + t28 * t35
    t53 = t51 + t24 * t45 + t42 * t52
    t54 = t32 + t49 * (t45 * t45) + t45 * t52
    t55 = t53 * (t47 + t47) - t54 * (4 * t44) - t50 * (4 * t48)
    t56 = t53 * t53 - t54 * (4 * t50)

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
    A[..., 2] = -t15
    B[..., 0] = t19 + t21 * kappa
    B[..., 1] = kappa * t23
    B[..., 2] = t24 + kappa * t27
    B[..., 3] = t28 + kappa * t30
    B[..., 4] = t24 + kappa * t31
    B[..., 5] = t32 + kappa * t33
    B0[..., 0] = t19
    B0[..., 1] = 0.0
    B0[..., 2] = t24
    B0[..., 3] = t28
    B0[..., 4] = t24
    B0[..., 5] = t32
    B1[..., 0] = t21
    B1[..., 1] = t23
    B1[..., 2] = t27
    B1[..., 3] = t30
    B1[..., 4] = t31
    B1[..., 5] = t33
    a[..., 0] = t44
    a[..., 1] = t47
    a[..., 2] = t48
    b[..., 0] = t50
    b[..., 1] = t53
    b[..., 2] = t54
    C[..., 0] = t55
    D[..., 0] = t56
    discriminant[..., 0] = t56 + kappa * t55
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 185 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
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
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * l1
    t2 = c1 * c2 - s1 * s2
    t3 = c1 * s2 + c2 * s1
    t4 = t2 * cos_heading3 - t3 * sin_heading3
    t5 = l3 + q3
    t6 = t1 + t2 * l2 + t4 * t5
    t7 = l1 * s1
    t8 = cos_heading3 * t3 + t2 * sin_heading3
    t9 = t7 + l2 * t3 + t5 * t8
    t10 = tx * t6 + ty * t9
    t11 = t6 - t1
    t12 = t9 - t7
    t13 = tx * t11 + ty * t12
    t14 = -t13
    t15 = tx * t8 - t4 * ty
    t16 = t5 * t15
    t17 = tx * t3 - t2 * ty
    t18 = l2 * t17
    t19 = t16 + l1 * (tx * s1 - c1 * ty) + t18
    t20 = t6 * ty - tx * t9
    t21 = t10 * t10 + t20 * t20
    t22 = t16 + t18
    t23 = ty * t11 - tx * t12
    t24 = t13 * t13 + t23 * t23
    t25 = t5 * (t15 + t15) + l2 * (t17 + t17)
    t26 = t10 + t10
    t27 = t20 + t20
    t28 = t13 * t26 + t23 * t27
    t29 = tx * t4 + ty * t8
    t30 = -2 * t29
    t31 = t15 * t26 + t27 * t29
    t32 = t15 * (t13 + t13) + t29 * (t23 + t23)
    t33 = t15 * t15 + t29 * t29
    t34 = 1.4210854715202004e-14 * np.sqrt((t5 * t5 + l1 * l1 + l2 * l2))
    t35 = 0.5 - 0.5 * np.copysign(1, t34 - np.copysign(t14, 1))
    t36 = 1 - t35
    t37 = t20 * t36 + t23 * t35
    t38 = t10 * t36 + t13 * t35
    t39 = 0.5 - 0.5 * np.copysign(1, t34 - np.copysign((-t38), 1))
    t40 = t39 / (1 - t39 - t38 * t39)
    t41 = t40 * (t10 * t35 + t13 * t36)
    t42 = t20 * t35 + t23 * t36 + t37 * t41
    t43 = t42 * t42
    t44 = t15 * t40
    t45 = t29 + t37 * t44
    t46 = (t42 + t42) * t45
    t47 = t45 * t45
    t48 = t19 * t36 + t22 * t35
    t49 = t19 * t35 + t22 * t36 + t48 * (t41 * t41) + t25 * t41
    t50 = t30 + t41 * (t44 * (t48 + t48)) + t25 * t44 + t30 * t41
    t51 = t48 * (t44 * t44) + t30 * t44
    t52 = t50 * (t46 + t46) - t51 * (4 * t43) - t49 * (4 * t47)
    t53 = t50 * t50 - t51 * (4 * t49)

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
    A[..., 1] = t14
    A[..., 2] = -t15
    B[..., 0] = t19 + t21 * kappa
    B[..., 1] = t22 + kappa * t24
    B[..., 2] = t25 + kappa * t28
    B[..., 3] = t30 + kappa * t31
    B[..., 4] = t30 + kappa * t32
    B[..., 5] = kappa * t33
    B0[..., 0] = t19
    B0[..., 1] = t22
    B0[..., 2] = t25
    B0[..., 3] = t30
    B0[..., 4] = t30
    B0[..., 5] = 0.0
    B1[..., 0] = t21
    B1[..., 1] = t24
    B1[..., 2] = t28
    B1[..., 3] = t31
    B1[..., 4] = t32
    B1[..., 5] = t33
    a[..., 0] = t43
    a[..., 1] = t46
    a[..., 2] = t47
    b[..., 0] = t49
    b[..., 1] = t50
    b[..., 2] = t51
    C[..., 0] = t52
    D[..., 0] = t53
    discriminant[..., 0] = t53 + kappa * t52
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_rates(q, parameters, tangent, curvature, leading):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 463 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
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
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 3]
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
    t6 = c1 * l1
    t7 = c1 * c2 - s1 * s2
    t8 = c1 * s2 + c2 * s1
    t9 = t7 * cos_heading3 - t8 * sin_heading3
    t10 = l3 + q3
    t11 = t6 + t7 * l2 + t9 * t10
    t12 = t3 / t4
    t13 = l1 * s1
    t14 = cos_heading3 * t8 + t7 * sin_heading3
    t15 = t13 + l2 * t8 + t10 * t14
    t16 = t5 * t11 + t12 * t15
    t17 = t11 - t6
    t18 = t15 - t13
    t19 = t5 * t17 + t12 * t18
    t20 = t11 * t12 - t5 * t15
    t21 = t12 * t17 - t5 * t18
    t22 = t16 * t16 + t19 * t19 + t20 * t20 + t21 * t21
    t23 = np.sqrt((t10 * t10 + l1 * l1 + l2 * l2))
    t24 = t23 + (0.5 + 0.5 * np.copysign(1, 7.888609052210118e-31 - np.copysign(t23, 1)))
    t25 = t24 * t24
    t26 = 1.4210854715202004e-14 * np.sqrt((t22 + t25))
    t27 = 1.4142135623730951 * t24
    t28 = t5 * t14 - t9 * t12
    t29 = t5 * t9 + t12 * t14
    t30 = t21 * t28 - t19 * t29
    t31 = t16 * t29 - t20 * t28
    t32 = t30 * t30 + t31 * t31
    t33 = t19 * t20 - t16 * t21
    t34 = t33 * t33
    t35 = np.sqrt((t32 + t34 / t25))
    t36 = 0.5 - 0.5 * np.copysign(1, t26 * t27 - np.copysign((t24 * t35), 1))
    t37 = 1 - t36
    t38 = t36 / (t37 + t36 * np.sqrt((t32 + t34)))
    t39 = t33 * t38
    t40 = t31 * t38
    t41 = t38 * (t19 * t39 - t28 * t40)
    t42 = t30 * t38
    t43 = t29 + t29
    t44 = t38 * (t16 * t40 - t19 * t42)
    t45 = t38 * (t28 * t42 - t16 * t39)
    t46 = t41 + t45
    t47 = t10 * t28
    t48 = t46 * t46
    t49 = t5 * s1 - c1 * t12
    t50 = l1 * t49
    t51 = t41 * t41
    t52 = t5 * t8 - t7 * t12
    t53 = l2 * t52
    t54 = t43 * t44 * t46 - t47 * t48 - t50 * t51 - t48 * t53
    t55 = t54 - kappa
    t56 = t26 * t36 / t24 * (t27 * t27) / (t37 + t35 * t36)
    t57 = t35 * t38
    t58 = t56 * (t57 * t57)
    t59 = t40 + t42
    t60 = t59 * t59
    t61 = t39 * t43 * t59 - t47 * t60 - t50 * (t42 * t42)
    t62 = t61 - t53 * t60
    t63 = np.copysign(t62, 1)
    t64 = 0.5 - 0.5 * np.copysign(1, t58 - t63)
    t65 = t51 + t45 * t45 + t44 * t44 / t25
    t66 = np.sqrt(t65)
    t67 = t56 * (t57 * (t66 + t66))
    t68 = t28 + t28
    t69 = t43 * (t44 * t59 + t39 * t46) - t59 * (t46 * (t10 * t68))
    t70 = t69 - t42 * (t41 * (l1 * (t49 + t49))) - t59 * (t46 * (l2 * (t52 + t52)))
    t71 = np.copysign(t70, 1)
    t72 = t56 * t65
    t73 = np.copysign(t55, 1)
    t74 = (t67 + t67) * t71 + t63 * (4 * t72) + 4 * t58 * t73
    t75 = t70 * t70 - t62 * (4 * t55)
    t76 = np.maximum(0.0, t75)
    t77 = t64 * (0.5 - 0.5 * np.copysign(1, t74 - np.copysign(t76, 1)))
    t78 = 1 - t77
    t79 = t77 * (-0.5 * t70 - 0.5 * np.copysign(np.sqrt(t76), t70))
    t80 = 1 - t64
    t81 = 0.5 - 0.5 * np.copysign(1, t67 - t71)
    t82 = t80 * t81
    t83 = t64 * t70 / (t80 + t62 * (t64 + t64)) + t55 * t82 / (1 - t82 + t70 * t82)
    t84 = t55 * t77 / (t78 + t79) - t78 * t83
    t85 = t36 * (t41 + t42 * t84)
    t86 = t36 * (t45 + t40 * t84)
    t87 = t36 * (t44 + t39 * t84)
    t88 = t36 * t77
    t89 = t79 / (t78 + t62 * t77)
    t90 = t88 * (t41 + t42 * t89)
    t91 = t88 * (t45 + t40 * t89)
    t92 = t88 * (t44 + t39 * t89)
    t93 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t85, 1), np.copysign(t86, 1)), np.copysign((t87 / t24), 1))
    t94 = leads1 + leads2 + t24 * leads3
    t95 = t85 * leads1 + t86 * leads2 + t87 * leads3
    t96 = 0.5 - 0.5 * np.copysign(1, t93 * t94 - np.copysign(t95, 1))
    t97 = 1 - t96
    t98 = t96 / (t97 + t95 * t96)
    t99 = 1 - leads1
    t100 = 1 - leads3
    t101 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t90, 1), np.copysign(t91, 1)), np.copysign((t92 / t24), 1))
    t102 = t90 * leads1 + t91 * leads2 + t92 * leads3
    t103 = 0.5 - 0.5 * np.copysign(1, t94 * t101 - np.copysign(t102, 1))
    t104 = 1 - t103
    t105 = t103 / (t104 + t102 * t103)
    t106 = t85 + t86
    t107 = t106 * t106
    t108 = t85 * t85
    t109 = t43 * t87 * t106 - t47 * t107 - t50 * t108 - t53 * t107
    t110 = t90 + t91
    t111 = t110 * t110
    t112 = t90 * t90
    t113 = t43 * t92 * t110 - t47 * t111 - t50 * t112 - t53 * t111
    t114 = t10 * t29
    t115 = l1 * (t5 * c1 + s1 * t12)
    t116 = l2 * (t5 * t7 + t8 * t12)
    t117 = t107 * t114 + t108 * t115 + t107 * t116 + t106 * (t68 * t87)
    t118 = t106 * t107
    t119 = -3 * t109 * t117 + t114 * t118 + t115 * (t85 * t108)
    t120 = 3 * t28
    t121 = t119 + t116 * t118 + t107 * (t87 * t120)
    t122 = t111 * t114 + t112 * t115 + t111 * t116 + t110 * (t68 * t92)
    t123 = t110 * t111
    t124 = -3 * t113 * t122 + t114 * t123 + t115 * (t90 * t112)
    t125 = t124 + t116 * t123 + t111 * (t92 * t120)
    t126 = 0.5 - 0.5 * np.copysign(1, t74 - np.copysign(np.maximum(0.0, -t75), 1))
    t127 = t64 * t126
    t128 = 4 + t36 * (t64 * t127 + t80 * (2 + t81)) - 4 * t36
    t129 = np.copysign((-(t125 + kappa_s)), 1) - np.copysign((-(t121 + kappa_s)), 1)
    t130 = t80 * (1 - t81) * (0.5 + 0.5 * np.copysign(1, t72 - t73))

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
    rates[..., 0] = t85
    rates[..., 1] = t86
    rates[..., 2] = t87
    rates[..., 3] = t90
    rates[..., 4] = t91
    rates[..., 5] = t92
    ratios[..., 0] = t98 * (t86 * leads1 + t85 * t99)
    ratios[..., 1] = t98 * (t86 * leads3 + t87 * t100)
    ratios[..., 2] = t105 * (t91 * leads1 + t90 * t99)
    ratios[..., 3] = t105 * (t91 * leads3 + t92 * t100)
    tracked[..., 0] = t109
    tracked[..., 1] = t113
    tracked_rate[..., 0] = -t121
    tracked_rate[..., 1] = -t125
    verdict[..., 0] = t128
    verdict[..., 1] = t36 * (1 + t77)
    verdict[..., 2] = t77 * (0.5 * t36) * (1 - np.copysign(1, t129))
    verdict[..., 3] = t36 * (t82 + t64 * (1 - t127) + t130)
    verdict[..., 4] = t88 * t104 + t36 * t97
    parabola[..., 0] = t62
    parabola[..., 1] = t70
    parabola[..., 2] = t54
    slack[..., 0] = t75
    least[..., 0] = t41
    least[..., 1] = t45
    least[..., 2] = t44
    null[..., 0] = t42
    null[..., 1] = t40
    null[..., 2] = t39
    return rates.reshape(_leading + (2, 3)), ratios.reshape(_leading + (2, 2)), tracked.reshape(_leading + (2,)), tracked_rate.reshape(_leading + (2,)), verdict.reshape(_leading + (5,)), parabola.reshape(_leading + (3,)), slack.reshape(_leading), least.reshape(_leading + (3,)), null.reshape(_leading + (3,))
