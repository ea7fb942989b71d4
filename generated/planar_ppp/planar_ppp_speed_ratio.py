"""speed ratio of planar_ppp, in NumPy.

Made from templates/kernel.py.j2; inputs ed99f203c53e369bbff1ddfeafc564f17a2be190cc8c2e4f9796913b98fb7552.
583 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 105 operations.

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
    t20 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign(t7, 1))
    t21 = 1 - t20
    t22 = t9 * t21 + t11 * t20
    t23 = t3 * t21 + t6 * t20
    t24 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign((-t23), 1))
    t25 = t24 / (1 - t24 - t23 * t24)
    t26 = t9 * t20 + t11 * t21 + t22 * (t25 * (t3 * t20 + t6 * t21))
    t27 = t15 + t22 * (t8 * t25)

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
    a[..., 0] = t26 * t26
    a[..., 1] = (t26 + t26) * t27
    a[..., 2] = t27 * t27
    b[..., 0] = 0.0
    b[..., 1] = 0.0
    b[..., 2] = 0.0
    C[..., 0] = 0.0
    D[..., 0] = 0.0
    discriminant[..., 0] = 0.0
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 105 operations.

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
    t20 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign(t7, 1))
    t21 = 1 - t20
    t22 = t9 * t21 + t11 * t20
    t23 = t1 * t21 + t6 * t20
    t24 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign((-t23), 1))
    t25 = t24 / (1 - t24 - t23 * t24)
    t26 = t9 * t20 + t11 * t21 + t22 * (t25 * (t1 * t20 + t6 * t21))
    t27 = t16 + t22 * (t8 * t25)

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
    a[..., 0] = t26 * t26
    a[..., 1] = (t26 + t26) * t27
    a[..., 2] = t27 * t27
    b[..., 0] = 0.0
    b[..., 1] = 0.0
    b[..., 2] = 0.0
    C[..., 0] = 0.0
    D[..., 0] = 0.0
    discriminant[..., 0] = 0.0
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 105 operations.

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
    t20 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign(t5, 1))
    t21 = 1 - t20
    t22 = t9 * t21 + t11 * t20
    t23 = t1 * t21 + t4 * t20
    t24 = 0.5 - 0.5 * np.copysign(1, 1.4210854715202004e-14 - np.copysign((-t23), 1))
    t25 = t24 / (1 - t24 - t23 * t24)
    t26 = t9 * t20 + t11 * t21 + t22 * (t25 * (t1 * t20 + t4 * t21))
    t27 = t16 + t22 * (t8 * t25)

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
    a[..., 0] = t26 * t26
    a[..., 1] = (t26 + t26) * t27
    a[..., 2] = t27 * t27
    b[..., 0] = 0.0
    b[..., 1] = 0.0
    b[..., 2] = 0.0
    C[..., 0] = 0.0
    D[..., 0] = 0.0
    discriminant[..., 0] = 0.0
    return A.reshape(_leading + (3,)), B.reshape(_leading + (6,)), B0.reshape(_leading + (6,)), B1.reshape(_leading + (6,)), a.reshape(_leading + (3,)), b.reshape(_leading + (3,)), C.reshape(_leading), D.reshape(_leading), discriminant.reshape(_leading)


def speed_ratio_rates(q, parameters, tangent, curvature, leading):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 268 operations.

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
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    heading3 = parameters[..., 5]
    cos_heading3 = np.cos(heading3)
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    heading2 = parameters[..., 4]
    sin_heading2 = np.sin(heading2)
    cos_heading2 = np.cos(heading2)
    sin_heading1 = np.sin(heading1)
    sin_heading3 = np.sin(heading3)
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    kappa = curvature[..., 0]
    leads1 = leading[..., 0]
    leads2 = leading[..., 1]
    leads3 = leading[..., 2]

    # terms
    t1 = l1 + q1
    t2 = l2 + q2
    t3 = l3 + q3
    t4 = np.sqrt((t1 * t1 + t2 * t2 + t3 * t3))
    t5 = t4 + (0.5 + 0.5 * np.copysign(1, 7.888609052210118e-31 - np.copysign(t4, 1)))
    t6 = 2.4613922385709617e-14 * t5
    t7 = t5 + t5
    t8 = cos_heading1 * sin_heading2 + cos_heading2 * sin_heading1
    t9 = cos_heading1 * cos_heading2 - sin_heading2 * sin_heading1
    t10 = cos_heading3 * t8 + t9 * sin_heading3
    t11 = np.maximum(np.copysign(tx, 1), np.copysign(ty, 1))
    t12 = tx / t11
    t13 = ty / t11
    t14 = np.sqrt((t12 * t12 + t13 * t13))
    t15 = t12 / t14
    t16 = cos_heading3 * t9 - t8 * sin_heading3
    t17 = t13 / t14
    t18 = t10 * t15 - t16 * t17
    t19 = t9 * t15 + t8 * t17
    t20 = t8 * t15 - t9 * t17
    t21 = t15 * t16 + t10 * t17
    t22 = t18 * t19 - t20 * t21
    t23 = t22 * t22
    t24 = t5 * t5
    t25 = sin_heading1 * t15 - cos_heading1 * t17
    t26 = cos_heading1 * t15 + sin_heading1 * t17
    t27 = t21 * t25 - t18 * t26
    t28 = t27 * t27
    t29 = t20 * t26 - t19 * t25
    t30 = t29 * t29
    t31 = np.sqrt((t23 / t24 + t28 / t24 + t30 / t24))
    t32 = t5 * t24
    t33 = 0.5 - 0.5 * np.copysign(1, t6 * t7 - np.copysign((t31 * t32), 1))
    t34 = 1 - t33
    t35 = t33 / (t34 + t33 * np.sqrt((t30 + (t23 + t28))))
    t36 = t29 * t35
    t37 = t27 * t35
    t38 = t35 * (t20 * t36 - t18 * t37)
    t39 = t22 * t35
    t40 = t35 * (t18 * t39 - t25 * t36)
    t41 = t35 * (t25 * t37 - t20 * t39)
    t42 = t38 * t38 / t24 + t40 * t40 / t24 + t41 * t41 / t24
    t43 = np.sqrt(t42)
    t44 = t31 * t35
    t45 = t6 * t33 / t32 * (t7 * t7) / (t34 + t31 * t33)
    t46 = 0.5 - 0.5 * np.copysign(1, (t43 + t43) * t44 * t45)
    t47 = t45 * (t44 * t44)
    t48 = 0.5 - 0.5 * np.copysign(1, t47)
    t49 = 1 - t48
    t50 = t46 * t49
    t51 = np.copysign((-kappa), 1)
    t52 = t48 * (0.5 - 0.5 * np.copysign(1, 4 * t47 * t51))
    t53 = 1 - t52
    t54 = kappa * t50 / (1 - t50) * t53 - kappa * t52 / t53
    t55 = t33 * (t38 + t39 * t54)
    t56 = t33 * (t40 + t37 * t54)
    t57 = t33 * (t41 + t36 * t54)
    t58 = t33 * t52
    t59 = t38 * t58
    t60 = t40 * t58
    t61 = t41 * t58
    t62 = np.maximum(np.maximum(np.copysign((t55 / t5), 1), np.copysign((t56 / t5), 1)), np.copysign((t57 / t5), 1))
    t63 = t5 * leads1 + t5 * leads2 + t5 * leads3
    t64 = t55 * leads1 + t56 * leads2 + t57 * leads3
    t65 = 0.5 - 0.5 * np.copysign(1, 9.094947017729282e-13 * t62 * t63 - np.copysign(t64, 1))
    t66 = 1 - t65
    t67 = t65 / (t66 + t64 * t65)
    t68 = 1 - leads1
    t69 = 1 - leads3
    t70 = np.maximum(np.maximum(np.copysign((t59 / t5), 1), np.copysign((t60 / t5), 1)), np.copysign((t61 / t5), 1))
    t71 = t59 * leads1 + t60 * leads2 + t61 * leads3
    t72 = 0.5 - 0.5 * np.copysign(1, t63 * (9.094947017729282e-13 * t70) - np.copysign(t71, 1))
    t73 = 1 - t72
    t74 = t72 / (t73 + t71 * t72)
    t75 = 4 + t33 * (t48 * t52 + t49 * (2 + t46)) - 4 * t33
    t76 = t49 * (1 - t46) * (0.5 + 0.5 * np.copysign(1, t42 * t45 - t51))

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
    rates[..., 0] = t55
    rates[..., 1] = t56
    rates[..., 2] = t57
    rates[..., 3] = t59
    rates[..., 4] = t60
    rates[..., 5] = t61
    ratios[..., 0] = t67 * (t56 * leads1 + t55 * t68)
    ratios[..., 1] = t67 * (t56 * leads3 + t57 * t69)
    ratios[..., 2] = t74 * (t60 * leads1 + t59 * t68)
    ratios[..., 3] = t74 * (t60 * leads3 + t61 * t69)
    tracked[..., 0] = 0.0
    tracked[..., 1] = 0.0
    tracked_rate[..., 0] = 0.0
    tracked_rate[..., 1] = 0.0
    verdict[..., 0] = t75
    verdict[..., 1] = t33 * (1 + t52)
    verdict[..., 2] = 0.0
    verdict[..., 3] = t33 * (t50 + t48 * t53 + t76)
    verdict[..., 4] = t58 * t73 + t33 * t66
    parabola[..., 0] = 0.0
    parabola[..., 1] = 0.0
    parabola[..., 2] = 0.0
    slack[..., 0] = 0.0
    least[..., 0] = t38
    least[..., 1] = t40
    least[..., 2] = t41
    null[..., 0] = t39
    null[..., 1] = t37
    null[..., 2] = t36
    return rates.reshape(_leading + (2, 3)), ratios.reshape(_leading + (2, 2)), tracked.reshape(_leading + (2,)), tracked_rate.reshape(_leading + (2,)), verdict.reshape(_leading + (5,)), parabola.reshape(_leading + (3,)), slack.reshape(_leading), least.reshape(_leading + (3,)), null.reshape(_leading + (3,))
