"""speed ratio of planar_rrr, in NumPy.

Made from templates/kernel.py.j2; inputs 3b998527b4c9a9029a23f90031d99fd8f19aed2291aba4fa6524a8d184fbc7e8.
795 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def speed_ratio_terms_1(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading: 160 operations.

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
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    real = np.result_type(q, parameters, tangent, curvature, np.float32)

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
    t36 = t13 / t14
    t37 = t22 + np.where(t15 != 0.0, -(t24 * t36), 0.0)
    t38 = t37 * t37
    t39 = t16 / t14
    t40 = t30 + np.where(t15 != 0.0, -(t24 * t39), 0.0)
    t41 = (t37 + t37) * t40
    t42 = t40 * t40
    t43 = np.where(t15 != 0.0, -t36, 0.0)
    t44 = np.where(t15 != 0.0, -(t26 * t36), 0.0)
    t45 = t21 + t20 * (t43 * t43) + t44
    t46 = t28 - np.where(t15 != 0.0, np.where(t15 != 0.0, -(t36 * (t39 * (t20 + t20))), 0.0), 0.0)
    t47 = np.where(t15 != 0.0, -(t26 * t39), 0.0)
    t48 = t44 + (t46 + t47)
    t49 = np.where(t15 != 0.0, -t39, 0.0)
    t50 = t47 + (t34 + t20 * (t49 * t49))
    t51 = t48 * (t41 + t41) - t50 * (4.0 * t38) - t45 * (4.0 * t42)
    t52 = t48 * t48 - t50 * (4.0 * t45)

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
    a[..., 0] = t38
    a[..., 1] = t41
    a[..., 2] = t42
    b[..., 0] = t45
    b[..., 1] = t48
    b[..., 2] = t50
    C[..., 0] = t51
    D[..., 0] = t52
    discriminant[..., 0] = t52 + kappa * t51
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_terms_2(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading: 160 operations.

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
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    real = np.result_type(q, parameters, tangent, curvature, np.float32)

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
    t36 = t11 / t12
    t37 = t22 + np.where(t13 != 0.0, -(t24 * t36), 0.0)
    t38 = t37 * t37
    t39 = t16 / t12
    t40 = t31 + np.where(t13 != 0.0, -(t24 * t39), 0.0)
    t41 = (t37 + t37) * t40
    t42 = t40 * t40
    t43 = np.where(t13 != 0.0, -t36, 0.0)
    t44 = np.where(t13 != 0.0, -(t26 * t36), 0.0)
    t45 = t21 + t20 * (t43 * t43) + t44
    t46 = t30 - np.where(t13 != 0.0, np.where(t13 != 0.0, -(t36 * (t39 * (t20 + t20))), 0.0), 0.0)
    t47 = np.where(t13 != 0.0, -(t26 * t39), 0.0)
    t48 = t44 + (t46 + t47)
    t49 = np.where(t13 != 0.0, -t39, 0.0)
    t50 = t47 + (t34 + t20 * (t49 * t49))
    t51 = t48 * (t41 + t41) - t50 * (4.0 * t38) - t45 * (4.0 * t42)
    t52 = t48 * t48 - t50 * (4.0 * t45)

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
    a[..., 0] = t38
    a[..., 1] = t41
    a[..., 2] = t42
    b[..., 0] = t45
    b[..., 1] = t48
    b[..., 2] = t50
    C[..., 0] = t51
    D[..., 0] = t52
    discriminant[..., 0] = t52 + kappa * t51
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_terms_3(q, parameters, tangent, curvature):
    """A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading: 166 operations.

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
    leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], tangent.shape[:-1], curvature.shape[:-1])
    real = np.result_type(q, parameters, tangent, curvature, np.float32)

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
    t36 = t11 / t14
    t37 = t22 + np.where(t15 != 0.0, -(t25 * t36), 0.0)
    t38 = t37 * t37
    t39 = t16 / t14
    t40 = t32 + np.where(t15 != 0.0, -(t25 * t39), 0.0)
    t41 = (t37 + t37) * t40
    t42 = t40 * t40
    t43 = np.where(t15 != 0.0, -t36, 0.0)
    t44 = t21 + t24 * (t43 * t43) + np.where(t15 != 0.0, -(t28 * t36), 0.0)
    t45 = t27 - np.where(t15 != 0.0, np.where(t15 != 0.0, -(t36 * (t39 * (t24 + t24))), 0.0), 0.0)
    t46 = t45 + np.where(t15 != 0.0, -(t28 * t39), 0.0) + np.where(t15 != 0.0, -(t27 * t36), 0.0)
    t47 = np.where(t15 != 0.0, -t39, 0.0)
    t48 = t20 + t24 * (t47 * t47) + np.where(t15 != 0.0, -(t27 * t39), 0.0)
    t49 = t46 * (t41 + t41) - t48 * (4.0 * t38) - t44 * (4.0 * t42)
    t50 = t46 * t46 - t48 * (4.0 * t44)

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
    a[..., 0] = t38
    a[..., 1] = t41
    a[..., 2] = t42
    b[..., 0] = t44
    b[..., 1] = t46
    b[..., 2] = t48
    C[..., 0] = t49
    D[..., 0] = t50
    discriminant[..., 0] = t50 + kappa * t49
    return A.reshape(leading + (3,)), B.reshape(leading + (6,)), B0.reshape(leading + (6,)), B1.reshape(leading + (6,)), a.reshape(leading + (3,)), b.reshape(leading + (3,)), C.reshape(leading), D.reshape(leading), discriminant.reshape(leading)


def speed_ratio_rates(q, parameters, tangent, curvature):
    """joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates: 309 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
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
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q1 = q[..., 0]
    c1 = np.cos(q1)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    s1 = np.sin(q1)
    s2 = np.sin(q2)
    s3 = np.sin(q3)
    l3 = parameters[..., 2]
    tx = tangent[..., 0]
    ty = tangent[..., 1]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    kappa = curvature[..., 0]

    # terms
    t1 = c1 * c2 - s1 * s2
    t2 = c1 * s2 + c2 * s1
    t3 = c3 * t1 - t2 * s3
    t4 = t3 * l3
    t5 = c3 * t2 + t1 * s3
    t6 = l3 * t5
    t7 = t4 * tx + t6 * ty
    t8 = c1 * l1
    t9 = t4 + (t8 + t1 * l2)
    t10 = t9 - t8
    t11 = s1 * l1
    t12 = t6 + (t11 + t2 * l2)
    t13 = t12 - t11
    t14 = ty * t10 - tx * t13
    t15 = tx * t10 + ty * t13
    t16 = t4 * ty - tx * t6
    t17 = t7 * t14 - t15 * t16
    t18 = tx * t9 + ty * t12
    t19 = ty * t9 - tx * t12
    t20 = t16 * t18 - t7 * t19
    t21 = t15 * t19 - t14 * t18
    t22 = np.sqrt((t17 * t17 + t20 * t20 + t21 * t21))
    t23 = s1 * tx - c1 * ty
    t24 = l1 * t23
    t25 = t17 / t22
    t26 = t2 * tx - t1 * ty
    t27 = l2 * t26
    t28 = t20 / t22
    t29 = t25 + t28
    t30 = tx * t5 - t3 * ty
    t31 = l3 * t30
    t32 = t21 / t22
    t33 = t29 + t32
    t34 = t24 * (t25 * t25) + t27 * (t29 * t29) + t31 * (t33 * t33)
    t35 = np.where(t22 != 0.0, np.where(t22 != 0.0, t34, 0.0), 0.0)
    t36 = -t35
    t37 = np.where(t36 != 0.0, 1.0, 0.0)
    t38 = (np.where(t22 != 0.0, t15 * t32, 0.0) - np.where(t22 != 0.0, t7 * t28, 0.0)) / t22
    t39 = (np.where(t22 != 0.0, t7 * t25, 0.0) - np.where(t22 != 0.0, t18 * t32, 0.0)) / t22
    t40 = t38 + t39
    t41 = np.where(t22 != 0.0, np.where(t22 != 0.0, t25 * (l1 * (-2.0 * t23) * t38), 0.0), 0.0) - np.where(t22 != 0.0, np.where(t22 != 0.0, t29 * (l2 * (t26 + t26) * t40), 0.0), 0.0)
    t42 = (np.where(t22 != 0.0, t18 * t28, 0.0) - np.where(t22 != 0.0, t15 * t25, 0.0)) / t22
    t43 = t40 + t42
    t44 = t41 - np.where(t22 != 0.0, np.where(t22 != 0.0, t33 * (l3 * (t30 + t30) * t43), 0.0), 0.0)
    t45 = t37 + np.where((1.0 - t37) != 0.0, 1.0 - np.where(t44 != 0.0, 1.0, 0.0), 0.0)
    t46 = np.where(t22 != 0.0, t38, 0.0)
    t47 = t24 * (t38 * t38) + t27 * (t40 * t40) + t31 * (t43 * t43)
    t48 = np.where(t22 != 0.0, np.where(t22 != 0.0, t47, 0.0), 0.0)
    t49 = t48 + kappa
    t50 = t44 * t44 - np.where(t22 != 0.0, np.where(t22 != 0.0, t34 * (4.0 * t49), 0.0), 0.0)
    t51 = np.sqrt(np.maximum(0.0, t50))
    t52 = -0.5 * t44 - 0.5 * np.copysign(t51, t44)
    t53 = t52 / t35
    t54 = t46 + np.where(t36 != 0.0, np.where(t22 != 0.0, -(t25 * t53), 0.0), 0.0)
    t55 = np.where(t22 != 0.0, t39, 0.0)
    t56 = t55 + np.where(t36 != 0.0, np.where(t22 != 0.0, -(t28 * t53), 0.0), 0.0)
    t57 = np.where(t22 != 0.0, t42, 0.0)
    t58 = t57 + np.where(t36 != 0.0, np.where(t22 != 0.0, -(t32 * t53), 0.0), 0.0)
    t59 = np.where(t51 != 0.0, 1.0, 0.0)
    t60 = 1.0 - t59
    t61 = t59 + np.where(t60 != 0.0, t45, 0.0)
    t62 = np.where(t59 != 0.0, np.where(t52 != 0.0, -(t49 / t52), 0.0), 0.0) + np.where(t60 != 0.0, np.where(t36 != 0.0, -t53, 0.0), 0.0)
    t63 = t38 + t25 * t62
    t64 = t39 + t28 * t62
    t65 = t42 + t32 * t62
    t66 = t54 * t54
    t67 = t54 + t56
    t68 = np.where(t45 != 0.0, t67, 0.0)
    t69 = t68 * t68
    t70 = t58 + t67
    t71 = np.where(t45 != 0.0, t70, 0.0)
    t72 = t71 * t71
    t73 = np.where(t45 != 0.0, np.where(t45 != 0.0, t24 * t66, 0.0), 0.0) + t27 * t69 + t31 * t72
    t74 = t63 * t63
    t75 = t63 + t64
    t76 = np.where(t61 != 0.0, np.where(t22 != 0.0, t75, 0.0), 0.0)
    t77 = t76 * t76
    t78 = np.where(t61 != 0.0, np.where(t22 != 0.0, np.where(t61 != 0.0, np.where(t22 != 0.0, t24 * t74, 0.0), 0.0), 0.0), 0.0) + t27 * t77
    t79 = t65 + t75
    t80 = np.where(t61 != 0.0, np.where(t22 != 0.0, t79, 0.0), 0.0)
    t81 = t80 * t80
    t82 = t78 + t31 * t81
    t83 = l1 * (c1 * tx + s1 * ty)
    t84 = l2 * (t1 * tx + t2 * ty)
    t85 = l3 * (t3 * tx + t5 * ty)
    t86 = np.where(t45 != 0.0, np.where(t45 != 0.0, t66 * t83, 0.0), 0.0) + t69 * t84 + t72 * t85
    t87 = -3.0 * t73 * t86 - np.where(t45 != 0.0, np.where(t45 != 0.0, np.where(t45 != 0.0, t83 * (t54 * t66), 0.0), 0.0), 0.0)
    t88 = t87 - np.where(t45 != 0.0, t84 * (t67 * t69), 0.0) - np.where(t45 != 0.0, t85 * (t70 * t72), 0.0)
    t89 = np.where(t61 != 0.0, np.where(t22 != 0.0, np.where(t61 != 0.0, np.where(t22 != 0.0, t74 * t83, 0.0), 0.0), 0.0), 0.0) + t77 * t84
    t90 = np.where(t22 != 0.0, np.where(t61 != 0.0, np.where(t22 != 0.0, np.where(t61 != 0.0, np.where(t22 != 0.0, t83 * (t63 * t74), 0.0), 0.0), 0.0), 0.0), 0.0)
    t91 = -3.0 * t82 * (t89 + t81 * t85) - np.where(t61 != 0.0, t90, 0.0) - np.where(t61 != 0.0, np.where(t22 != 0.0, t84 * (t75 * t77), 0.0), 0.0)

    # results
    rates = np.empty((*leading, 6), real)
    tracked = np.empty((*leading, 2), real)
    tracked_rate = np.empty((*leading, 2), real)
    parabola = np.empty((*leading, 3), real)
    discriminant = np.empty((*leading, 1), real)
    least = np.empty((*leading, 3), real)
    null = np.empty((*leading, 3), real)
    rates[..., 0] = np.where(t45 != 0.0, t54, 0.0)
    rates[..., 1] = np.where(t45 != 0.0, t56, 0.0)
    rates[..., 2] = np.where(t45 != 0.0, t58, 0.0)
    rates[..., 3] = np.where(t61 != 0.0, np.where(t22 != 0.0, t63, 0.0), 0.0)
    rates[..., 4] = np.where(t61 != 0.0, np.where(t22 != 0.0, t64, 0.0), 0.0)
    rates[..., 5] = np.where(t61 != 0.0, np.where(t22 != 0.0, t65, 0.0), 0.0)
    tracked[..., 0] = -t73
    tracked[..., 1] = -t82
    tracked_rate[..., 0] = t88
    tracked_rate[..., 1] = t91 - np.where(t61 != 0.0, np.where(t22 != 0.0, t85 * (t79 * t81), 0.0), 0.0)
    parabola[..., 0] = t36
    parabola[..., 1] = t44
    parabola[..., 2] = -t48
    discriminant[..., 0] = t50
    least[..., 0] = t46
    least[..., 1] = t55
    least[..., 2] = t57
    null[..., 0] = np.where(t22 != 0.0, t25, 0.0)
    null[..., 1] = np.where(t22 != 0.0, t28, 0.0)
    null[..., 2] = np.where(t22 != 0.0, t32, 0.0)
    return rates.reshape(leading + (2, 3)), tracked.reshape(leading + (2,)), tracked_rate.reshape(leading + (2,)), parabola.reshape(leading + (3,)), discriminant.reshape(leading), least.reshape(leading + (3,)), null.reshape(leading + (3,))
