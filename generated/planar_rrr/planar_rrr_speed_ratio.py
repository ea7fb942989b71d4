"""speed ratio of planar_rrr, in NumPy.

Made from templates/kernel.py.j2; inputs 33801b8f126a5fb56d19b040dbb61deaa21de905138b4b32ca17c173b8225e70.
999 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 194 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * l1
    t2 = c1 * c2 - s1 * s2
    t3 = c1 * s2 + c2 * s1
    t4 = t2 * c3 - t3 * s3
    t5 = t4 * l3
    t6 = t1 + t2 * l2 + t5
    t7 = t6 - t1
    t8 = l1 * s1
    t9 = c3 * t3 + t2 * s3
    t10 = l3 * t9
    t11 = t8 + l2 * t3 + t10
    t12 = t11 - t8
    t13 = t7 * tx + t12 * ty
    t14 = t5 * tx + t10 * ty
    t15 = -t14
    t16 = t6 * tx + t11 * ty
    t17 = t3 * tx - t2 * ty
    t18 = l2 * t17
    t19 = tx * t9 - t4 * ty
    t20 = l3 * t19
    t21 = t18 + t20
    t22 = t7 * ty - tx * t12
    t23 = t13 * t13 + t22 * t22
    t24 = t5 * ty - tx * t10
    t25 = t14 * t14 + t24 * t24
    t26 = l3 * (t19 + t19)
    t27 = t14 * (t13 + t13) + t24 * (t22 + t22)
    t28 = t26 + l2 * (t17 + t17)
    t29 = t16 + t16
    t30 = t6 * ty - tx * t11
    t31 = t30 + t30
    t32 = t13 * t29 + t22 * t31
    t33 = t14 * t29 + t24 * t31
    t34 = t20 + (t18 + l1 * (s1 * tx - c1 * ty))
    t35 = t16 * t16 + t30 * t30
    t36 = 1.4210854715202004e-14 * np.sqrt((l1 * l1 + l2 * l2 + l3 * l3))
    t37 = 0.5 - 0.5 * np.copysign(1, t36 - np.copysign(t15, 1))
    t38 = 1 - t37
    t39 = t22 * t38 + t24 * t37
    t40 = t13 * t38 + t14 * t37
    t41 = 0.5 - 0.5 * np.copysign(1, t36 - np.copysign((-t40), 1))
    t42 = t41 / (1 - t41 - t40 * t41)
    t43 = t42 * (t13 * t37 + t14 * t38)
    t44 = t22 * t37 + t24 * t38 + t39 * t43
    t45 = t44 * t44
    t46 = t16 * t42
    t47 = t30 + t39 * t46
    t48 = (t44 + t44) * t47
    t49 = t47 * t47
    t50 = t21 * t38 + t20 * t37
    t51 = t21 * t37 + t20 * t38 + t50 * (t43 * t43) + t26 * t43
    t52 = t26 * t38 + t28 * t37 + t43 * (t46 * (t50 + t50))
    t53 = t26 * t37 + t28 * t38
    t54 = t52 + t26 * t46 + t43 * t53
    t55 = t34 + t50 * (t46 * t46) + t46 * t53
    t56 = t54 * (t48 + t48) - t55 * (4 * t45) - t51 * (4 * t49)
    t57 = t54 * t54 - t55 * (4 * t51)

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
    A[..., 0] = -t13
    A[..., 1] = t15
    A[..., 2] = -t16
    B[..., 0] = t21 + t23 * kappa
    B[..., 1] = t20 + kappa * t25
    B[..., 2] = t26 + kappa * t27
    B[..., 3] = t28 + kappa * t32
    B[..., 4] = t26 + kappa * t33
    B[..., 5] = t34 + kappa * t35
    B0[..., 0] = t21
    B0[..., 1] = t20
    B0[..., 2] = t26
    B0[..., 3] = t28
    B0[..., 4] = t26
    B0[..., 5] = t34
    B1[..., 0] = t23
    B1[..., 1] = t25
    B1[..., 2] = t27
    B1[..., 3] = t32
    B1[..., 4] = t33
    B1[..., 5] = t35
    a[..., 0] = t45
    a[..., 1] = t48
    a[..., 2] = t49
    b[..., 0] = t51
    b[..., 1] = t54
    b[..., 2] = t55
    C[..., 0] = t56
    D[..., 0] = t57
    discriminant[..., 0] = t57 + kappa * t56
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 194 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * l1
    t2 = c1 * c2 - s1 * s2
    t3 = c1 * s2 + c2 * s1
    t4 = t2 * c3 - t3 * s3
    t5 = t4 * l3
    t6 = t1 + t2 * l2 + t5
    t7 = l1 * s1
    t8 = c3 * t3 + t2 * s3
    t9 = l3 * t8
    t10 = t7 + l2 * t3 + t9
    t11 = tx * t6 + ty * t10
    t12 = tx * t5 + ty * t9
    t13 = -t12
    t14 = t6 - t1
    t15 = t10 - t7
    t16 = tx * t14 + ty * t15
    t17 = tx * t3 - t2 * ty
    t18 = l2 * t17
    t19 = tx * t8 - t4 * ty
    t20 = l3 * t19
    t21 = l1 * (tx * s1 - c1 * ty) + t18 + t20
    t22 = t6 * ty - tx * t10
    t23 = t11 * t11 + t22 * t22
    t24 = t5 * ty - tx * t9
    t25 = t12 * t12 + t24 * t24
    t26 = l3 * (t19 + t19)
    t27 = t11 + t11
    t28 = t22 + t22
    t29 = t12 * t27 + t24 * t28
    t30 = t26 + l2 * (t17 + t17)
    t31 = ty * t14 - tx * t15
    t32 = t16 * t27 + t28 * t31
    t33 = t12 * (t16 + t16) + t24 * (t31 + t31)
    t34 = t18 + t20
    t35 = t16 * t16 + t31 * t31
    t36 = 1.4210854715202004e-14 * np.sqrt((l1 * l1 + l2 * l2 + l3 * l3))
    t37 = 0.5 - 0.5 * np.copysign(1, t36 - np.copysign(t13, 1))
    t38 = 1 - t37
    t39 = t22 * t38 + t24 * t37
    t40 = t11 * t38 + t12 * t37
    t41 = 0.5 - 0.5 * np.copysign(1, t36 - np.copysign((-t40), 1))
    t42 = t41 / (1 - t41 - t40 * t41)
    t43 = t42 * (t11 * t37 + t12 * t38)
    t44 = t22 * t37 + t24 * t38 + t39 * t43
    t45 = t44 * t44
    t46 = t16 * t42
    t47 = t31 + t39 * t46
    t48 = (t44 + t44) * t47
    t49 = t47 * t47
    t50 = t21 * t38 + t20 * t37
    t51 = t21 * t37 + t20 * t38 + t50 * (t43 * t43) + t26 * t43
    t52 = t26 * t38 + t30 * t37 + t43 * (t46 * (t50 + t50))
    t53 = t26 * t37 + t30 * t38
    t54 = t52 + t26 * t46 + t43 * t53
    t55 = t34 + t50 * (t46 * t46) + t46 * t53
    t56 = t54 * (t48 + t48) - t55 * (4 * t45) - t51 * (4 * t49)
    t57 = t54 * t54 - t55 * (4 * t51)

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
    A[..., 2] = -t16
    B[..., 0] = t21 + t23 * kappa
    B[..., 1] = t20 + kappa * t25
    B[..., 2] = t26 + kappa * t29
    B[..., 3] = t30 + kappa * t32
    B[..., 4] = t26 + kappa * t33
    B[..., 5] = t34 + kappa * t35
    B0[..., 0] = t21
    B0[..., 1] = t20
    B0[..., 2] = t26
    B0[..., 3] = t30
    B0[..., 4] = t26
    B0[..., 5] = t34
    B1[..., 0] = t23
    B1[..., 1] = t25
    B1[..., 2] = t29
    B1[..., 3] = t32
    B1[..., 4] = t33
    B1[..., 5] = t35
    a[..., 0] = t45
    a[..., 1] = t48
    a[..., 2] = t49
    b[..., 0] = t51
    b[..., 1] = t54
    b[..., 2] = t55
    C[..., 0] = t56
    D[..., 0] = t57
    discriminant[..., 0] = t57 + kappa * t56
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 188 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * l1
    t2 = c1 * c2 - s1 * s2
    t3 = c1 * s2 + c2 * s1
    t4 = t2 * c3 - t3 * s3
    t5 = t4 * l3
    t6 = t1 + t2 * l2 + t5
    t7 = l1 * s1
    t8 = c3 * t3 + t2 * s3
    t9 = l3 * t8
    t10 = t7 + l2 * t3 + t9
    t11 = tx * t6 + ty * t10
    t12 = t6 - t1
    t13 = t10 - t7
    t14 = tx * t12 + ty * t13
    t15 = -t14
    t16 = tx * t5 + ty * t9
    t17 = tx * t3 - t2 * ty
    t18 = l2 * t17
    t19 = tx * t8 - t4 * ty
    t20 = l3 * t19
    t21 = l1 * (tx * s1 - c1 * ty) + t18 + t20
    t22 = t6 * ty - tx * t10
    t23 = t11 * t11 + t22 * t22
    t24 = t18 + t20
    t25 = ty * t12 - tx * t13
    t26 = t14 * t14 + t25 * t25
    t27 = l3 * (t19 + t19)
    t28 = l2 * (t17 + t17) + t27
    t29 = t11 + t11
    t30 = t22 + t22
    t31 = t14 * t29 + t25 * t30
    t32 = t5 * ty - tx * t9
    t33 = t16 * t29 + t30 * t32
    t34 = t16 * (t14 + t14) + t32 * (t25 + t25)
    t35 = t16 * t16 + t32 * t32
    t36 = 1.4210854715202004e-14 * np.sqrt((l1 * l1 + l2 * l2 + l3 * l3))
    t37 = 0.5 - 0.5 * np.copysign(1, t36 - np.copysign(t15, 1))
    t38 = 1 - t37
    t39 = t22 * t38 + t25 * t37
    t40 = t11 * t38 + t14 * t37
    t41 = 0.5 - 0.5 * np.copysign(1, t36 - np.copysign((-t40), 1))
    t42 = t41 / (1 - t41 - t40 * t41)
    t43 = t42 * (t11 * t37 + t14 * t38)
    t44 = t22 * t37 + t25 * t38 + t39 * t43
    t45 = t44 * t44
    t46 = t16 * t42
    t47 = t32 + t39 * t46
    t48 = (t44 + t44) * t47
    t49 = t47 * t47
    t50 = t21 * t38 + t24 * t37
    t51 = t21 * t37 + t24 * t38 + t50 * (t43 * t43) + t28 * t43
    t52 = t27 + t43 * (t46 * (t50 + t50)) + t28 * t46 + t27 * t43
    t53 = t20 + t50 * (t46 * t46) + t27 * t46
    t54 = t52 * (t48 + t48) - t53 * (4 * t45) - t51 * (4 * t49)
    t55 = t52 * t52 - t53 * (4 * t51)

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
    A[..., 1] = t15
    A[..., 2] = -t16
    B[..., 0] = t21 + t23 * kappa
    B[..., 1] = t24 + kappa * t26
    B[..., 2] = t28 + kappa * t31
    B[..., 3] = t27 + kappa * t33
    B[..., 4] = t27 + kappa * t34
    B[..., 5] = t20 + kappa * t35
    B0[..., 0] = t21
    B0[..., 1] = t24
    B0[..., 2] = t28
    B0[..., 3] = t27
    B0[..., 4] = t27
    B0[..., 5] = t20
    B1[..., 0] = t23
    B1[..., 1] = t26
    B1[..., 2] = t31
    B1[..., 3] = t33
    B1[..., 4] = t34
    B1[..., 5] = t35
    a[..., 0] = t45
    a[..., 1] = t48
    a[..., 2] = t49
    b[..., 0] = t51
    b[..., 1] = t52
    b[..., 2] = t53
    C[..., 0] = t54
    D[..., 0] = t55
    discriminant[..., 0] = t55 + kappa * t54
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_rates(q, parameters, tangent, curvature, leading):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 423 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
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
    t1 = np.maximum(np.copysign(tx, 1), np.copysign(ty, 1))
    t2 = tx / t1
    t3 = ty / t1
    t4 = np.sqrt((t2 * t2 + t3 * t3))
    t5 = t2 / t4
    t6 = c1 * l1
    t7 = c1 * c2 - s1 * s2
    t8 = c1 * s2 + c2 * s1
    t9 = t7 * c3 - t8 * s3
    t10 = t9 * l3
    t11 = t6 + t7 * l2 + t10
    t12 = t3 / t4
    t13 = l1 * s1
    t14 = c3 * t8 + t7 * s3
    t15 = l3 * t14
    t16 = t13 + l2 * t8 + t15
    t17 = t5 * t11 + t12 * t16
    t18 = t11 - t6
    t19 = t16 - t13
    t20 = t5 * t18 + t12 * t19
    t21 = t5 * t10 + t12 * t15
    t22 = t11 * t12 - t5 * t16
    t23 = t17 * t17 + t20 * t20 + t21 * t21 + t22 * t22
    t24 = t12 * t18 - t5 * t19
    t25 = t10 * t12 - t5 * t15
    t26 = np.sqrt((t23 + t24 * t24 + t25 * t25))
    t27 = l1 * l1 + l2 * l2 + l3 * l3
    t28 = t21 * t24 - t20 * t25
    t29 = t17 * t25 - t21 * t22
    t30 = t20 * t22 - t17 * t24
    t31 = np.sqrt((t28 * t28 + t29 * t29 + t30 * t30))
    t32 = 0.5 * np.copysign(1, 1.4210854715202004e-14 * t26 * np.sqrt(t27) - np.copysign(t31, 1))
    t33 = 0.5 - t32
    t34 = t33 / (1 - t33 + t31 * t33)
    t35 = t30 * t34
    t36 = t29 * t34
    t37 = t34 * (t20 * t35 - t21 * t36)
    t38 = t28 * t34
    t39 = t27 * (t26 * (1.4210854715202004e-14 * t34))
    t40 = t5 * s1 - c1 * t12
    t41 = l1 * t40
    t42 = t5 * t8 - t7 * t12
    t43 = l2 * t42
    t44 = t36 + t38
    t45 = t5 * t14 - t9 * t12
    t46 = l3 * t45
    t47 = t35 + t44
    t48 = t41 * (t38 * t38) + t43 * (t44 * t44) + t46 * (t47 * t47)
    t49 = -t48
    t50 = np.copysign(t49, 1)
    t51 = 0.5 - 0.5 * np.copysign(1, t39 - t50)
    t52 = t37 * t37
    t53 = t34 * (t21 * t38 - t17 * t35)
    t54 = t34 * (t17 * t36 - t20 * t38)
    t55 = t52 + t53 * t53 + t54 * t54
    t56 = np.sqrt(t55)
    t57 = t39 * (t56 + t56)
    t58 = t37 + t53
    t59 = t38 * (t37 * (l1 * (-2 * t40))) - t44 * (l2 * (t42 + t42) * t58)
    t60 = t54 + t58
    t61 = t59 - t47 * (l3 * (t45 + t45) * t60)
    t62 = np.copysign(t61, 1)
    t63 = t39 * t55
    t64 = t41 * t52 + t43 * (t58 * t58) + t46 * (t60 * t60)
    t65 = t64 + kappa
    t66 = np.copysign((-t65), 1)
    t67 = (t57 + t57) * t62 + t50 * (4 * t63) + 4 * t39 * t66
    t68 = t61 * t61 - t48 * (4 * t65)
    t69 = np.maximum(0.0, t68)
    t70 = t51 * (0.5 - 0.5 * np.copysign(1, t67 - np.copysign(t69, 1)))
    t71 = 1 - t70
    t72 = 0.5 - 0.5 * np.copysign(1, t57 - t62)
    t73 = 1 - t51
    t74 = t72 * t73
    t75 = t65 * t74 / (1 - t74 + t61 * t74) - t51 * t61 / (t73 - t48 * (t51 + t51))
    t76 = t70 * (-0.5 * t61 - 0.5 * np.copysign(np.sqrt(t69), t61))
    t77 = t71 * t75 - t65 * t70 / (t71 + t76)
    t78 = t33 * (t37 + t38 * t77)
    t79 = t33 * (t53 + t36 * t77)
    t80 = t33 * (t54 + t35 * t77)
    t81 = t33 * t70
    t82 = t76 / (t71 - t48 * t70)
    t83 = t81 * (t37 + t38 * t82)
    t84 = t81 * (t53 + t36 * t82)
    t85 = t81 * (t54 + t35 * t82)
    t86 = t78 * leads1 + t79 * leads2 + t80 * leads3
    t87 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t78, 1), np.copysign(t79, 1)), np.copysign(t80, 1)) - np.copysign(t86, 1)
    t88 = 0.5 - 0.5 * np.copysign(1, t87)
    t89 = 1 - t88
    t90 = t88 / (t89 + t86 * t88)
    t91 = 1 - leads1
    t92 = 1 - leads3
    t93 = t83 * leads1 + t84 * leads2 + t85 * leads3
    t94 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t83, 1), np.copysign(t84, 1)), np.copysign(t85, 1)) - np.copysign(t93, 1)
    t95 = 0.5 - 0.5 * np.copysign(1, t94)
    t96 = 1 - t95
    t97 = t95 / (t96 + t93 * t95)
    t98 = t78 * t78
    t99 = t78 + t79
    t100 = t99 * t99
    t101 = t80 + t99
    t102 = t101 * t101
    t103 = t41 * t98 + t43 * t100 + t46 * t102
    t104 = t83 * t83
    t105 = t83 + t84
    t106 = t105 * t105
    t107 = t85 + t105
    t108 = t107 * t107
    t109 = t41 * t104 + t43 * t106 + t46 * t108
    t110 = l1 * (t5 * c1 + s1 * t12)
    t111 = l2 * (t5 * t7 + t8 * t12)
    t112 = l3 * (t5 * t9 + t12 * t14)
    t113 = -3 * t103 * (t98 * t110 + t100 * t111 + t102 * t112)
    t114 = t113 - t110 * (t78 * t98) - t111 * (t99 * t100) - t112 * (t101 * t102)
    t115 = -3 * t109 * (t104 * t110 + t106 * t111 + t108 * t112)
    t116 = t115 - t110 * (t83 * t104) - t111 * (t105 * t106) - t112 * (t107 * t108)
    t117 = 0.5 - 0.5 * np.copysign(1, t67 - np.copysign(np.maximum(0.0, -t68), 1))
    t118 = t51 * t117
    t119 = 4 + t33 * (t51 * t118 + t73 * (2 + t72)) - 4 * t33
    t120 = 1 - np.copysign(1, np.copysign((t116 - kappa_s), 1) - np.copysign((t114 - kappa_s), 1))
    t121 = t73 * (1 - t72) * (0.5 + 0.5 * np.copysign(1, t63 - t66))

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
    ratios[..., 0] = t90 * (t79 * leads1 + t78 * t91)
    ratios[..., 1] = t90 * (t79 * leads3 + t80 * t92)
    ratios[..., 2] = t97 * (t84 * leads1 + t83 * t91)
    ratios[..., 3] = t97 * (t84 * leads3 + t85 * t92)
    tracked[..., 0] = -t103
    tracked[..., 1] = -t109
    tracked_rate[..., 0] = t114
    tracked_rate[..., 1] = t116
    verdict[..., 0] = t119
    verdict[..., 1] = t33 * (1 + t70)
    verdict[..., 2] = t70 * (0.5 * t33) * t120
    verdict[..., 3] = t33 * (t74 + t51 * (1 - t118) + t121)
    verdict[..., 4] = t81 * t96 + t33 * t89
    parabola[..., 0] = t49
    parabola[..., 1] = t61
    parabola[..., 2] = -t64
    slack[..., 0] = t68
    least[..., 0] = t37
    least[..., 1] = t53
    least[..., 2] = t54
    null[..., 0] = t38
    null[..., 1] = t36
    null[..., 2] = t35
    return rates.reshape(_leading + (2, 3)), ratios.reshape(_leading + (2, 2)), tracked.reshape(_leading + (2,)), tracked_rate.reshape(_leading + (2,)), verdict.reshape(_leading + (5,)), parabola.reshape(_leading + (3,)), slack.reshape(_leading), least.reshape(_leading + (3,)), null.reshape(_leading + (3,))
