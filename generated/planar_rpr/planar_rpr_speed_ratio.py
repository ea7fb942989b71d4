"""speed ratio of planar_rpr, in NumPy.

Made from templates/kernel.py.j2; inputs bbc93cc24ca5f7ea8535b0696d2b52e296d373a77665ecec87f30b1b05620c23.
972 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 178 operations.

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
    t21 = -2.0 * t14
    t22 = t13 + t13
    t23 = ty * t11 - tx * t12
    t24 = t23 + t23
    t25 = t3 * t22 + t14 * t24
    t26 = l3 * (t16 + t16)
    t27 = t8 * t22 + t18 * t24
    t28 = t17 + (t3 * t10 + l1 * (s1 * tx - c1 * ty))
    t29 = t13 * t13 + t23 * t23
    t30 = np.sqrt((1.0 + t10 * t10 + l1 * l1 + l3 * l3))
    t31 = 1.4210854715202004e-14 * t30
    t32 = 0.5 - 0.5 * np.copysign(1.0, t31 - np.copysign(t9, 1.0))
    t33 = 1.0 - t32
    t34 = t14 * t33 + t18 * t32
    t35 = t3 * t33 + t8 * t32
    t36 = 0.5 - 0.5 * np.copysign(1.0, t31 - np.copysign((-t35), 1.0))
    t37 = t36 / (1.0 - t36 - t35 * t36)
    t38 = t37 * (t3 * t32 + t8 * t33)
    t39 = t14 * t32 + t18 * t33 + t34 * t38
    t40 = t39 * t39
    t41 = t13 * t37
    t42 = t23 + t34 * t41
    t43 = (t39 + t39) * t42
    t44 = t42 * t42
    t45 = t17 * t32
    t46 = t17 * t33 + t45 * (t38 * t38)
    t47 = t21 * t32 + t26 * t33 + t38 * (t41 * (t45 + t45))
    t48 = t21 * t33 + t26 * t32
    t49 = t47 + t38 * t48
    t50 = t28 + t45 * (t41 * t41) + t41 * t48
    t51 = t49 * (t43 + t43) - t50 * (4.0 * t40) - t46 * (4.0 * t44)
    t52 = t49 * t49 - t50 * (4.0 * t46)

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
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 181 operations.

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
    t26 = -2.0 * t25
    t27 = t13 * t22 + t23 * t25
    t28 = t11 * (t13 + t13) + t19 * (t25 + t25)
    t29 = t13 * t13 + t25 * t25
    t30 = np.sqrt((1.0 + t2 * t2 + l1 * l1 + l3 * l3))
    t31 = 1.4210854715202004e-14 * t30
    t32 = 0.5 - 0.5 * np.copysign(1.0, t31 - np.copysign(t12, 1.0))
    t33 = 1.0 - t32
    t34 = t17 * t33 + t19 * t32
    t35 = t10 * t33 + t11 * t32
    t36 = 0.5 - 0.5 * np.copysign(1.0, t31 - np.copysign((-t35), 1.0))
    t37 = t36 / (1.0 - t36 - t35 * t36)
    t38 = t37 * (t10 * t32 + t11 * t33)
    t39 = t17 * t32 + t19 * t33 + t34 * t38
    t40 = t39 * t39
    t41 = t13 * t37
    t42 = t25 + t34 * t41
    t43 = (t39 + t39) * t42
    t44 = t42 * t42
    t45 = t16 * t33 + t15 * t32
    t46 = t16 * t32 + t15 * t33 + t45 * (t38 * t38) + t21 * t38
    t47 = t26 * t32 + t38 * (t41 * (t45 + t45)) + t21 * t41
    t48 = t26 * t33
    t49 = t47 + t38 * t48
    t50 = t45 * (t41 * t41) + t41 * t48
    t51 = t49 * (t43 + t43) - t50 * (4.0 * t40) - t46 * (4.0 * t44)
    t52 = t49 * t49 - t50 * (4.0 * t46)

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


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 178 operations.

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
    t21 = -2.0 * t19
    t22 = t10 + t10
    t23 = t17 + t17
    t24 = t11 * t22 + t19 * t23
    t25 = l3 * (t14 + t14)
    t26 = t5 * ty - tx * t8
    t27 = t13 * t22 + t23 * t26
    t28 = t13 * (t11 + t11) + t26 * (t19 + t19)
    t29 = t13 * t13 + t26 * t26
    t30 = np.sqrt((1.0 + t2 * t2 + l1 * l1 + l3 * l3))
    t31 = 1.4210854715202004e-14 * t30
    t32 = 0.5 - 0.5 * np.copysign(1.0, t31 - np.copysign(t12, 1.0))
    t33 = 1.0 - t32
    t34 = t17 * t33 + t19 * t32
    t35 = t10 * t33 + t11 * t32
    t36 = 0.5 - 0.5 * np.copysign(1.0, t31 - np.copysign((-t35), 1.0))
    t37 = t36 / (1.0 - t36 - t35 * t36)
    t38 = t37 * (t10 * t32 + t11 * t33)
    t39 = t17 * t32 + t19 * t33 + t34 * t38
    t40 = t39 * t39
    t41 = t13 * t37
    t42 = t26 + t34 * t41
    t43 = (t39 + t39) * t42
    t44 = t42 * t42
    t45 = t16 * t33
    t46 = t16 * t32 + t45 * (t38 * t38) + t21 * t38
    t47 = t25 * t32 + t38 * (t41 * (t45 + t45)) + t21 * t41
    t48 = t25 * t33
    t49 = t47 + t38 * t48
    t50 = t15 + t45 * (t41 * t41) + t41 * t48
    t51 = t49 * (t43 + t43) - t50 * (4.0 * t40) - t46 * (4.0 * t44)
    t52 = t49 * t49 - t50 * (4.0 * t46)

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
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 435 operations.

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
    leads2 = leading[..., 1]
    leads3 = leading[..., 2]
    kappa_s = curvature[..., 1]

    # terms
    t1 = np.maximum(np.copysign(tx, 1.0), np.copysign(ty, 1.0))
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
    t17 = t5 * t8 - t6 * t12
    t18 = t5 * t10 + t12 * t14
    t19 = t11 * t12 - t5 * t15
    t20 = t16 * t16 + t17 * t17 + t18 * t18 + t19 * t19
    t21 = t5 * t6 + t8 * t12
    t22 = t10 * t12 - t5 * t14
    t23 = np.sqrt((t20 + t21 * t21 + t22 * t22))
    t24 = 1.0 + t7 * t7 + l1 * l1 + l3 * l3
    t25 = t18 * t21 - t17 * t22
    t26 = t16 * t22 - t18 * t19
    t27 = t17 * t19 - t16 * t21
    t28 = np.sqrt((t25 * t25 + t26 * t26 + t27 * t27))
    t29 = 0.5 * np.copysign(1.0, 1.4210854715202004e-14 * t23 * np.sqrt(t24) - np.copysign(t28, 1.0))
    t30 = 0.5 - t29
    t31 = t30 / (1.0 - t30 + t28 * t30)
    t32 = t27 * t31
    t33 = t26 * t31
    t34 = t31 * (t17 * t32 - t18 * t33)
    t35 = t25 * t31
    t36 = t21 + t21
    t37 = t31 * (t18 * t35 - t16 * t32)
    t38 = t7 * t17
    t39 = t34 * t34
    t40 = t5 * s1 - c1 * t12
    t41 = l1 * t40
    t42 = t5 * t13 - t9 * t12
    t43 = l3 * t42
    t44 = t31 * (t16 * t33 - t17 * t35)
    t45 = t34 + t44
    t46 = t34 * t36 * t37 - t38 * t39 - t39 * t41 - t43 * (t45 * t45)
    t47 = t46 - kappa
    t48 = t24 * (t23 * (1.4210854715202004e-14 * t31))
    t49 = t35 * t35
    t50 = t32 + t35
    t51 = t33 * (t35 * t36) - t38 * t49 - t41 * t49 - t43 * (t50 * t50)
    t52 = np.copysign(t51, 1.0)
    t53 = 0.5 - 0.5 * np.copysign(1.0, t48 - t52)
    t54 = t39 + t37 * t37 + t44 * t44
    t55 = np.sqrt(t54)
    t56 = t48 * (t55 + t55)
    t57 = t17 + t17
    t58 = t36 * (t33 * t34 + t35 * t37) - t35 * (t34 * (t7 * t57))
    t59 = t58 - t35 * (t34 * (l1 * (t40 + t40))) - t50 * (t45 * (l3 * (t42 + t42)))
    t60 = np.copysign(t59, 1.0)
    t61 = t48 * t54
    t62 = np.copysign(t47, 1.0)
    t63 = (t56 + t56) * t60 + t52 * (4.0 * t61) + 4.0 * t48 * t62
    t64 = t59 * t59 - t51 * (4.0 * t47)
    t65 = np.maximum(0.0, t64)
    t66 = t53 * (0.5 - 0.5 * np.copysign(1.0, t63 - np.copysign(t65, 1.0)))
    t67 = 1.0 - t66
    t68 = t66 * (-0.5 * t59 - 0.5 * np.copysign(np.sqrt(t65), t59))
    t69 = 1.0 - t53
    t70 = 0.5 - 0.5 * np.copysign(1.0, t56 - t60)
    t71 = t69 * t70
    t72 = t53 * t59 / (t69 + t51 * (t53 + t53)) + t47 * t71 / (1.0 - t71 + t59 * t71)
    t73 = t47 * t66 / (t67 + t68) - t67 * t72
    t74 = t30 * (t34 + t35 * t73)
    t75 = t30 * (t37 + t33 * t73)
    t76 = t30 * (t44 + t32 * t73)
    t77 = t30 * t66
    t78 = t68 / (t67 + t51 * t66)
    t79 = t77 * (t34 + t35 * t78)
    t80 = t77 * (t37 + t33 * t78)
    t81 = t77 * (t44 + t32 * t78)
    t82 = t74 * leads1 + t75 * leads2 + t76 * leads3
    t83 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t74, 1.0), np.copysign(t75, 1.0)), np.copysign(t76, 1.0)) - np.copysign(t82, 1.0)
    t84 = 0.5 - 0.5 * np.copysign(1.0, t83)
    t85 = 1.0 - t84
    t86 = t84 / (t85 + t82 * t84)
    t87 = t79 * leads1 + t80 * leads2 + t81 * leads3
    t88 = 9.094947017729282e-13 * np.maximum(np.maximum(np.copysign(t79, 1.0), np.copysign(t80, 1.0)), np.copysign(t81, 1.0)) - np.copysign(t87, 1.0)
    t89 = 0.5 - 0.5 * np.copysign(1.0, t88)
    t90 = 1.0 - t89
    t91 = t89 / (t90 + t87 * t89)
    t92 = t74 * t74
    t93 = t74 + t76
    t94 = t93 * t93
    t95 = t75 * (t36 * t74) - t38 * t92 - t41 * t92 - t43 * t94
    t96 = t79 * t79
    t97 = t79 + t81
    t98 = t97 * t97
    t99 = t80 * (t36 * t79) - t38 * t96 - t41 * t96 - t43 * t98
    t100 = t7 * t21
    t101 = l1 * (t5 * c1 + s1 * t12)
    t102 = l3 * (t5 * t9 + t12 * t13)
    t103 = t92 * t100 + t92 * t101 + t94 * t102 + t75 * (t57 * t74)
    t104 = t74 * t92
    t105 = -3.0 * t95 * t103 + t100 * t104 + t101 * t104 + t102 * (t93 * t94)
    t106 = 3.0 * t17
    t107 = t105 + t92 * (t75 * t106)
    t108 = t96 * t100 + t96 * t101 + t98 * t102 + t80 * (t57 * t79)
    t109 = t79 * t96
    t110 = -3.0 * t99 * t108 + t100 * t109 + t101 * t109 + t102 * (t97 * t98)
    t111 = t110 + t96 * (t80 * t106)
    t112 = 0.5 - 0.5 * np.copysign(1.0, t63 - np.copysign(np.maximum(0.0, -t64), 1.0))
    t113 = t53 * t112
    t114 = 4.0 + t30 * (t53 * t113 + t69 * (2.0 + t70)) - 4.0 * t30
    t115 = np.copysign((-(t111 + kappa_s)), 1.0) - np.copysign((-(t107 + kappa_s)), 1.0)
    t116 = t69 * (1.0 - t70) * (0.5 + 0.5 * np.copysign(1.0, t61 - t62))

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
    rates[..., 0] = t74
    rates[..., 1] = t75
    rates[..., 2] = t76
    rates[..., 3] = t79
    rates[..., 4] = t80
    rates[..., 5] = t81
    ratios[..., 0] = t86 * (t74 + leads1 * (t75 - t74))
    ratios[..., 1] = t86 * (t76 + leads3 * (t75 - t76))
    ratios[..., 2] = t91 * (t79 + leads1 * (t80 - t79))
    ratios[..., 3] = t91 * (t81 + leads3 * (t80 - t81))
    tracked[..., 0] = t95
    tracked[..., 1] = t99
    tracked_rate[..., 0] = -t107
    tracked_rate[..., 1] = -t111
    verdict[..., 0] = t114
    verdict[..., 1] = t30 * (1.0 + t66)
    verdict[..., 2] = t66 * (0.5 * t30) * (1.0 - np.copysign(1.0, t115))
    verdict[..., 3] = t30 * (t71 + t53 * (1.0 - t113) + t116)
    verdict[..., 4] = t77 * t90 + t30 * t85
    parabola[..., 0] = t51
    parabola[..., 1] = t59
    parabola[..., 2] = t46
    slack[..., 0] = t64
    least[..., 0] = t34
    least[..., 1] = t37
    least[..., 2] = t44
    null[..., 0] = t35
    null[..., 1] = t33
    null[..., 2] = t32
    return rates.reshape(_leading + (2, 3)), ratios.reshape(_leading + (2, 2)), tracked.reshape(_leading + (2,)), tracked_rate.reshape(_leading + (2,)), verdict.reshape(_leading + (5,)), parabola.reshape(_leading + (3,)), slack.reshape(_leading), least.reshape(_leading + (3,)), null.reshape(_leading + (3,))
