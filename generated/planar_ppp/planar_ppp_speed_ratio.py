"""speed ratio of planar_ppp, in NumPy.

Made from templates/kernel.py.j2; inputs 077ed24b7b00614cbeb26790e0b2a8d1b444c23f22efce5117bb0b59b0edce6f.
321 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 81 operations.

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
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    real = np.result_type(q, parameters, tangent, curvature, np.float32)

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
    t20 = t9 + np.where(t7 != 0.0, -(t11 * (t3 / t6)), 0.0)
    t21 = t15 + np.where(t7 != 0.0, -(t11 * (t8 / t6)), 0.0)

    # results
    A = np.empty((*leading, 3), real)
    B = np.empty((*leading, 6), real)
    B0 = np.empty((*leading, 6), real)
    B1 = np.empty((*leading, 6), real)
    a = np.empty((*leading, 3), real)
    b = np.empty((*leading, 3), real)
    C = np.empty((*leading, 1), real)
    D = np.empty((*leading, 1), real)
    discriminant = np.empty((*leading, 1), real)
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
    a[..., 0] = t20 * t20
    a[..., 1] = (t20 + t20) * t21
    a[..., 2] = t21 * t21
    b[..., 0] = 0.0
    b[..., 1] = 0.0
    b[..., 2] = 0.0
    C[..., 0] = 0.0
    D[..., 0] = 0.0
    discriminant[..., 0] = 0.0
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 81 operations.

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
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    real = np.result_type(q, parameters, tangent, curvature, np.float32)

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
    t20 = t9 + np.where(t7 != 0.0, -(t11 * (t1 / t6)), 0.0)
    t21 = t16 + np.where(t7 != 0.0, -(t11 * (t8 / t6)), 0.0)

    # results
    A = np.empty((*leading, 3), real)
    B = np.empty((*leading, 6), real)
    B0 = np.empty((*leading, 6), real)
    B1 = np.empty((*leading, 6), real)
    a = np.empty((*leading, 3), real)
    b = np.empty((*leading, 3), real)
    C = np.empty((*leading, 1), real)
    D = np.empty((*leading, 1), real)
    discriminant = np.empty((*leading, 1), real)
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
    a[..., 0] = t20 * t20
    a[..., 1] = (t20 + t20) * t21
    a[..., 2] = t21 * t21
    b[..., 0] = 0.0
    b[..., 1] = 0.0
    b[..., 2] = 0.0
    C[..., 0] = 0.0
    D[..., 0] = 0.0
    discriminant[..., 0] = 0.0
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 81 operations.

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
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    real = np.result_type(q, parameters, tangent, curvature, np.float32)

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
    t20 = t9 + np.where(t5 != 0.0, -(t11 * (t1 / t4)), 0.0)
    t21 = t16 + np.where(t5 != 0.0, -(t11 * (t8 / t4)), 0.0)

    # results
    A = np.empty((*leading, 3), real)
    B = np.empty((*leading, 6), real)
    B0 = np.empty((*leading, 6), real)
    B1 = np.empty((*leading, 6), real)
    a = np.empty((*leading, 3), real)
    b = np.empty((*leading, 3), real)
    C = np.empty((*leading, 1), real)
    D = np.empty((*leading, 1), real)
    discriminant = np.empty((*leading, 1), real)
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
    a[..., 0] = t20 * t20
    a[..., 1] = (t20 + t20) * t21
    a[..., 2] = t21 * t21
    b[..., 0] = 0.0
    b[..., 1] = 0.0
    b[..., 2] = 0.0
    C[..., 0] = 0.0
    D[..., 0] = 0.0
    discriminant[..., 0] = 0.0
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_rates(q, parameters, tangent, curvature):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 78 operations.

    in   q[3]
    in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
    in   tangent[2] = (tx, ty)
    in   curvature[2] = (kappa, kappa_s)
    out  rates[2][3]
    out  tracked[2]
    out  tracked_rate[2]
    out  parabola[3]
    out  discriminant (one number)
    out  least[3]
    out  null[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    tangent = np.asarray(tangent)
    curvature = np.asarray(curvature)
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    real = np.result_type(q, parameters, tangent, curvature, np.float32)

    # inputs, sines and cosines
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

    # terms
    t1 = cos_heading1 * sin_heading2 + cos_heading2 * sin_heading1
    t2 = cos_heading1 * cos_heading2 - sin_heading2 * sin_heading1
    t3 = cos_heading3 * t1 + t2 * sin_heading3
    t4 = cos_heading3 * t2 - t1 * sin_heading3
    t5 = t3 * tx - t4 * ty
    t6 = t2 * tx + t1 * ty
    t7 = t1 * tx - t2 * ty
    t8 = tx * t4 + t3 * ty
    t9 = t5 * t6 - t7 * t8
    t10 = sin_heading1 * tx - cos_heading1 * ty
    t11 = cos_heading1 * tx + sin_heading1 * ty
    t12 = t8 * t10 - t5 * t11
    t13 = t7 * t11 - t6 * t10
    t14 = np.sqrt((t9 * t9 + t12 * t12 + t13 * t13))
    t15 = t13 / t14
    t16 = t12 / t14
    t17 = np.where(t14 != 0.0, (np.where(t14 != 0.0, t7 * t15, 0.0) - np.where(t14 != 0.0, t5 * t16, 0.0)) / t14, 0.0)
    t18 = t9 / t14
    t19 = np.where(t14 != 0.0, (np.where(t14 != 0.0, t5 * t18, 0.0) - np.where(t14 != 0.0, t10 * t15, 0.0)) / t14, 0.0)
    t20 = np.where(t14 != 0.0, (np.where(t14 != 0.0, t10 * t16, 0.0) - np.where(t14 != 0.0, t7 * t18, 0.0)) / t14, 0.0)

    # results
    rates = np.empty((*leading, 6), real)
    tracked = np.empty((*leading, 2), real)
    tracked_rate = np.empty((*leading, 2), real)
    parabola = np.empty((*leading, 3), real)
    discriminant = np.empty((*leading, 1), real)
    least = np.empty((*leading, 3), real)
    null = np.empty((*leading, 3), real)
    rates[..., 0] = t17
    rates[..., 1] = t19
    rates[..., 2] = t20
    rates[..., 3] = t17
    rates[..., 4] = t19
    rates[..., 5] = t20
    tracked[..., 0] = 0.0
    tracked[..., 1] = 0.0
    tracked_rate[..., 0] = 0.0
    tracked_rate[..., 1] = 0.0
    parabola[..., 0] = 0.0
    parabola[..., 1] = 0.0
    parabola[..., 2] = 0.0
    discriminant[..., 0] = 0.0
    least[..., 0] = t17
    least[..., 1] = t19
    least[..., 2] = t20
    null[..., 0] = np.where(t14 != 0.0, t18, 0.0)
    null[..., 1] = np.where(t14 != 0.0, t16, 0.0)
    null[..., 2] = np.where(t14 != 0.0, t15, 0.0)
    return rates.reshape(leading + (2, 3)), tracked.reshape(leading + (2,)), tracked_rate.reshape(leading + (2,)), parabola.reshape(leading + (3,)), discriminant.reshape(leading), least.reshape(leading + (3,)), null.reshape(leading + (3,))
