"""speed ratio of planar_rrp, in NumPy.

Made from templates/kernel.py.j2; inputs 173ca0949bbde67682285f34e19af9c3093a918b86a5a14dfa80425de68df8f3.
1001 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 189 operations.

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
    t24 = -2.0 * t22
    t25 = t13 * (t12 + t12) + t22 * (t20 + t20)
    t26 = t5 * (t13 + t13) + l2 * (t17 + t17)
    t27 = t15 + t15
    t28 = t6 * ty - tx * t10
    t29 = t28 + t28
    t30 = t12 * t27 + t20 * t29
    t31 = t13 * t27 + t22 * t29
    t32 = t18 + (t16 + l1 * (s1 * tx - c1 * ty))
    t33 = t15 * t15 + t28 * t28
    t34 = np.sqrt((1.0 + t5 * t5 + l1 * l1 + l2 * l2))
    t35 = 1.4210854715202004e-14 * t34
    t36 = 0.5 - 0.5 * np.copysign(1.0, t35 - np.copysign(t14, 1.0))
    t37 = 1.0 - t36
    t38 = t20 * t37 + t22 * t36
    t39 = t12 * t37 + t13 * t36
    t40 = 0.5 - 0.5 * np.copysign(1.0, t35 - np.copysign((-t39), 1.0))
    t41 = t40 / (1.0 - t40 - t39 * t40)
    t42 = t41 * (t12 * t36 + t13 * t37)
    t43 = t20 * t36 + t22 * t37 + t38 * t42
    t44 = t43 * t43
    t45 = t15 * t41
    t46 = t28 + t38 * t45
    t47 = (t43 + t43) * t46
    t48 = t46 * t46
    t49 = t19 * t37
    t50 = t19 * t36 + t49 * (t42 * t42) + t24 * t42
    t51 = t24 * t37 + t26 * t36 + t42 * (t45 * (t49 + t49))
    t52 = t24 * t36 + t26 * t37
    t53 = t51 + t24 * t45 + t42 * t52
    t54 = t32 + t49 * (t45 * t45) + t45 * t52
    t55 = t53 * (t47 + t47) - t54 * (4.0 * t44) - t50 * (4.0 * t48)
    t56 = t53 * t53 - t54 * (4.0 * t50)

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
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 189 operations.

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
    t24 = -2.0 * t22
    t25 = t10 + t10
    t26 = t20 + t20
    t27 = t11 * t25 + t22 * t26
    t28 = t5 * (t11 + t11) + l2 * (t17 + t17)
    t29 = ty * t13 - tx * t14
    t30 = t15 * t25 + t26 * t29
    t31 = t11 * (t15 + t15) + t22 * (t29 + t29)
    t32 = t16 + t18
    t33 = t15 * t15 + t29 * t29
    t34 = np.sqrt((1.0 + t5 * t5 + l1 * l1 + l2 * l2))
    t35 = 1.4210854715202004e-14 * t34
    t36 = 0.5 - 0.5 * np.copysign(1.0, t35 - np.copysign(t12, 1.0))
    t37 = 1.0 - t36
    t38 = t20 * t37 + t22 * t36
    t39 = t10 * t37 + t11 * t36
    t40 = 0.5 - 0.5 * np.copysign(1.0, t35 - np.copysign((-t39), 1.0))
    t41 = t40 / (1.0 - t40 - t39 * t40)
    t42 = t41 * (t10 * t36 + t11 * t37)
    t43 = t20 * t36 + t22 * t37 + t38 * t42
    t44 = t43 * t43
    t45 = t15 * t41
    t46 = t29 + t38 * t45
    t47 = (t43 + t43) * t46
    t48 = t46 * t46
    t49 = t19 * t37
    t50 = t19 * t36 + t49 * (t42 * t42) + t24 * t42
    t51 = t24 * t37 + t28 * t36 + t42 * (t45 * (t49 + t49))
    t52 = t24 * t36 + t28 * t37
    t53 = t51 + t24 * t45 + t42 * t52
    t54 = t32 + t49 * (t45 * t45) + t45 * t52
    t55 = t53 * (t47 + t47) - t54 * (4.0 * t44) - t50 * (4.0 * t48)
    t56 = t53 * t53 - t54 * (4.0 * t50)

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
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 186 operations.

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
    t30 = -2.0 * t29
    t31 = t15 * t26 + t27 * t29
    t32 = t15 * (t13 + t13) + t29 * (t23 + t23)
    t33 = t15 * t15 + t29 * t29
    t34 = np.sqrt((1.0 + t5 * t5 + l1 * l1 + l2 * l2))
    t35 = 1.4210854715202004e-14 * t34
    t36 = 0.5 - 0.5 * np.copysign(1.0, t35 - np.copysign(t14, 1.0))
    t37 = 1.0 - t36
    t38 = t20 * t37 + t23 * t36
    t39 = t10 * t37 + t13 * t36
    t40 = 0.5 - 0.5 * np.copysign(1.0, t35 - np.copysign((-t39), 1.0))
    t41 = t40 / (1.0 - t40 - t39 * t40)
    t42 = t41 * (t10 * t36 + t13 * t37)
    t43 = t20 * t36 + t23 * t37 + t38 * t42
    t44 = t43 * t43
    t45 = t15 * t41
    t46 = t29 + t38 * t45
    t47 = (t43 + t43) * t46
    t48 = t46 * t46
    t49 = t19 * t37 + t22 * t36
    t50 = t19 * t36 + t22 * t37 + t49 * (t42 * t42) + t25 * t42
    t51 = t30 + t42 * (t45 * (t49 + t49)) + t25 * t45 + t30 * t42
    t52 = t49 * (t45 * t45) + t30 * t45
    t53 = t51 * (t47 + t47) - t52 * (4.0 * t44) - t50 * (4.0 * t48)
    t54 = t51 * t51 - t52 * (4.0 * t50)

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
    a[..., 0] = t44
    a[..., 1] = t47
    a[..., 2] = t48
    b[..., 0] = t50
    b[..., 1] = t51
    b[..., 2] = t52
    C[..., 0] = t53
    D[..., 0] = t54
    discriminant[..., 0] = t54 + kappa * t53
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_rates(q, parameters, tangent, curvature, leading):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 437 operations.

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
    t1 = np.maximum(np.copysign(tx, 1.0), np.copysign(ty, 1.0))
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
    t20 = t5 * t14 - t9 * t12
    t21 = t11 * t12 - t5 * t15
    t22 = t16 * t16 + t19 * t19 + t20 * t20 + t21 * t21
    t23 = t12 * t17 - t5 * t18
    t24 = t5 * t9 + t12 * t14
    t25 = np.sqrt((t22 + t23 * t23 + t24 * t24))
    t26 = 1.0 + t10 * t10 + l1 * l1 + l2 * l2
    t27 = t20 * t23 - t19 * t24
    t28 = t16 * t24 - t20 * t21
    t29 = t19 * t21 - t16 * t23
    t30 = np.sqrt((t27 * t27 + t28 * t28 + t29 * t29))
    t31 = 0.5 * np.copysign(1.0, 1.4210854715202004e-14 * t25 * np.sqrt(t26) - np.copysign(t30, 1.0))
    t32 = 0.5 - t31
    t33 = t32 / (1.0 - t32 + t30 * t32)
    t34 = t29 * t33
    t35 = t28 * t33
    t36 = t33 * (t19 * t34 - t20 * t35)
    t37 = t27 * t33
    t38 = t24 + t24
    t39 = t33 * (t16 * t35 - t19 * t37)
    t40 = t33 * (t20 * t37 - t16 * t34)
    t41 = t36 + t40
    t42 = t10 * t20
    t43 = t41 * t41
    t44 = t5 * s1 - c1 * t12
    t45 = l1 * t44
    t46 = t36 * t36
    t47 = t5 * t8 - t7 * t12
    t48 = l2 * t47
    t49 = t38 * t39 * t41 - t42 * t43 - t45 * t46 - t43 * t48
    t50 = t49 - kappa
    t51 = t26 * (t25 * (1.4210854715202004e-14 * t33))
    t52 = t35 + t37
    t53 = t52 * t52
    t54 = t34 * t38 * t52 - t42 * t53 - t45 * (t37 * t37)
    t55 = t54 - t48 * t53
    t56 = np.copysign(t55, 1.0)
    t57 = 0.5 - 0.5 * np.copysign(1.0, t51 - t56)
    t58 = t46 + t40 * t40 + t39 * t39
    t59 = np.sqrt(t58)
    t60 = t51 * (t59 + t59)
    t61 = t20 + t20
    t62 = t38 * (t39 * t52 + t34 * t41) - t52 * (t41 * (t10 * t61))
    t63 = t62 - t37 * (t36 * (l1 * (t44 + t44))) - t52 * (t41 * (l2 * (t47 + t47)))
    t64 = np.copysign(t63, 1.0)
    t65 = t51 * t58
    t66 = np.copysign(t50, 1.0)
    t67 = (t60 + t60) * t64 + t56 * (4.0 * t65) + 4.0 * t51 * t66
    t68 = t63 * t63 - t55 * (4.0 * t50)
    t69 = np.maximum(0.0, t68)
    t70 = t57 * (0.5 - 0.5 * np.copysign(1.0, t67 - np.copysign(t69, 1.0)))
    t71 = 1.0 - t70
    t72 = t70 * (-0.5 * t63 - 0.5 * np.copysign(np.sqrt(t69), t63))
    t73 = 1.0 - t57
    t74 = 0.5 - 0.5 * np.copysign(1.0, t60 - t64)
    t75 = t73 * t74
    t76 = t57 * t63 / (t73 + t55 * (t57 + t57)) + t50 * t75 / (1.0 - t75 + t63 * t75)
    t77 = t50 * t70 / (t71 + t72) - t71 * t76
    t78 = t32 * (t36 + t37 * t77)
    t79 = t32 * (t40 + t35 * t77)
    t80 = t32 * (t39 + t34 * t77)
    t81 = t32 * t70
    t82 = t72 / (t71 + t55 * t70)
    t83 = t81 * (t36 + t37 * t82)
    t84 = t81 * (t40 + t35 * t82)
    t85 = t81 * (t39 + t34 * t82)
    t86 = t78 * leads1 + t79 * leads2 + t80 * leads3
    t87 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t78, 1.0), np.copysign(t79, 1.0)), np.copysign(t80, 1.0)) - np.copysign(t86, 1.0)
    t88 = 0.5 - 0.5 * np.copysign(1.0, t87)
    t89 = 1.0 - t88
    t90 = t88 / (t89 + t86 * t88)
    t91 = t83 * leads1 + t84 * leads2 + t85 * leads3
    t92 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t83, 1.0), np.copysign(t84, 1.0)), np.copysign(t85, 1.0)) - np.copysign(t91, 1.0)
    t93 = 0.5 - 0.5 * np.copysign(1.0, t92)
    t94 = 1.0 - t93
    t95 = t93 / (t94 + t91 * t93)
    t96 = t78 + t79
    t97 = t96 * t96
    t98 = t78 * t78
    t99 = t38 * t80 * t96 - t42 * t97 - t45 * t98 - t48 * t97
    t100 = t83 + t84
    t101 = t100 * t100
    t102 = t83 * t83
    t103 = t38 * t85 * t100 - t42 * t101 - t45 * t102 - t48 * t101
    t104 = t10 * t24
    t105 = l1 * (t5 * c1 + s1 * t12)
    t106 = l2 * (t5 * t7 + t8 * t12)
    t107 = t97 * t104 + t98 * t105 + t97 * t106 + t96 * (t61 * t80)
    t108 = t96 * t97
    t109 = -3.0 * t99 * t107 + t104 * t108 + t105 * (t78 * t98)
    t110 = 3.0 * t20
    t111 = t109 + t106 * t108 + t97 * (t80 * t110)
    t112 = t101 * t104 + t102 * t105 + t101 * t106 + t100 * (t61 * t85)
    t113 = t100 * t101
    t114 = -3.0 * t103 * t112 + t104 * t113 + t105 * (t83 * t102)
    t115 = t114 + t106 * t113 + t101 * (t85 * t110)
    t116 = 0.5 - 0.5 * np.copysign(1.0, t67 - np.copysign(np.maximum(0.0, -t68), 1.0))
    t117 = t57 * t116
    t118 = 4.0 + t32 * (t57 * t117 + t73 * (2.0 + t74)) - 4.0 * t32
    t119 = np.copysign((-(t115 + kappa_s)), 1.0) - np.copysign((-(t111 + kappa_s)), 1.0)
    t120 = t73 * (1.0 - t74) * (0.5 + 0.5 * np.copysign(1.0, t65 - t66))

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
    ratios[..., 0] = t90 * (t78 + leads1 * (t79 - t78))
    ratios[..., 1] = t90 * (t80 + leads3 * (t79 - t80))
    ratios[..., 2] = t95 * (t83 + leads1 * (t84 - t83))
    ratios[..., 3] = t95 * (t85 + leads3 * (t84 - t85))
    tracked[..., 0] = t99
    tracked[..., 1] = t103
    tracked_rate[..., 0] = -t111
    tracked_rate[..., 1] = -t115
    verdict[..., 0] = t118
    verdict[..., 1] = t32 * (1.0 + t70)
    verdict[..., 2] = t70 * (0.5 * t32) * (1.0 - np.copysign(1.0, t119))
    verdict[..., 3] = t32 * (t75 + t57 * (1.0 - t117) + t120)
    verdict[..., 4] = t81 * t94 + t32 * t89
    parabola[..., 0] = t55
    parabola[..., 1] = t63
    parabola[..., 2] = t49
    slack[..., 0] = t68
    least[..., 0] = t36
    least[..., 1] = t40
    least[..., 2] = t39
    null[..., 0] = t37
    null[..., 1] = t35
    null[..., 2] = t34
    return rates.reshape(_leading + (2, 3)), ratios.reshape(_leading + (2, 2)), tracked.reshape(_leading + (2,)), tracked_rate.reshape(_leading + (2,)), verdict.reshape(_leading + (5,)), parabola.reshape(_leading + (3,)), slack.reshape(_leading), least.reshape(_leading + (3,)), null.reshape(_leading + (3,))
