"""motion of planar_rrr, in NumPy.

Made from templates/kernel.py.j2; inputs aceb1af2692c82620993cc4855a155afd8de8aa3c47ff78eaeabf64df580c14e.
248 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def tip_motion(q, parameters, rates, second, third):
    """derivatives of the tip along a joint motion, and the path's speed, curvature, dk/ds and d^2k/ds^2: 248 operations.

    in   q[3]
    in   parameters[3] = (l1, l2, l3)
    in   rates[3] = (dq1, dq2, dq3)
    in   second[3] = (ddq1, ddq2, ddq3)
    in   third[3] = (dddq1, dddq2, dddq3)
    out  derivatives[5][2]
    out  path[4]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    rates = np.asarray(rates)
    second = np.asarray(second)
    third = np.asarray(third)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1], rates.shape[:-1], second.shape[:-1], third.shape[:-1])
    _real = np.result_type(q, parameters, rates, second, third, np.float32)

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
    dq1 = rates[..., 0]
    dq2 = rates[..., 1]
    dq3 = rates[..., 2]
    ddq1 = second[..., 0]
    ddq2 = second[..., 1]
    ddq3 = second[..., 2]
    dddq1 = third[..., 0]
    dddq2 = third[..., 1]
    dddq3 = third[..., 2]

    # terms
    t1 = c1 * c2 - s1 * s2
    t2 = c1 * s2 + c2 * s1
    t3 = t1 * c3 - t2 * s3
    t4 = c3 * t2 + t1 * s3
    t5 = l1 * dq1
    t6 = dq1 + dq2
    t7 = l2 * t6
    t8 = t6 + dq3
    t9 = l3 * t8
    t10 = s1 * t5 + t2 * t7 + t4 * t9
    t11 = -t10
    t12 = c1 * t5 + t1 * t7 + t3 * t9
    t13 = dq1 * dq1
    t14 = l1 * t13
    t15 = l1 * ddq1
    t16 = t6 * t6
    t17 = l2 * t16
    t18 = ddq1 + ddq2
    t19 = l2 * t18
    t20 = c1 * t14 + s1 * t15 + t1 * t17 + t2 * t19
    t21 = t8 * t8
    t22 = l3 * t21
    t23 = t18 + ddq3
    t24 = l3 * t23
    t25 = t20 + t3 * t22 + t4 * t24
    t26 = c1 * t15 - s1 * t14 + t1 * t19 - t2 * t17
    t27 = t26 + t3 * t24 - t4 * t22
    t28 = l1 * (dq1 * (-3 * ddq1))
    t29 = dq1 * t13
    t30 = l1 * dddq1 - l1 * t29
    t31 = t18 * (t6 * (-3 * l2))
    t32 = dddq1 + dddq2
    t33 = t6 * t16
    t34 = l2 * t32 - l2 * t33
    t35 = c1 * t28 - s1 * t30 + t1 * t31 - t2 * t34
    t36 = t23 * (t8 * (-3 * l3))
    t37 = t32 + dddq3
    t38 = t8 * t21
    t39 = l3 * t37 - l3 * t38
    t40 = t35 + t3 * t36 - t4 * t39
    t41 = c1 * t30 + s1 * t28 + t1 * t34 + t2 * t31
    t42 = t41 + t3 * t39 + t4 * t36
    t43 = l1 * (dq1 * t29) - 3 * l1 * (ddq1 * ddq1) - l1 * (dq1 * (4 * dddq1))
    t44 = t13 * (l1 * (-6 * ddq1))
    t45 = l2 * (t6 * t33) - 3 * l2 * (t18 * t18) - t32 * (t6 * (4 * l2))
    t46 = t16 * (t18 * (-6 * l2))
    t47 = c1 * t43 - s1 * t44 + t1 * t45 - t2 * t46
    t48 = l3 * (t8 * t38) - 3 * l3 * (t23 * t23) - t37 * (t8 * (4 * l3))
    t49 = t21 * (t23 * (-6 * l3))
    t50 = t47 + t3 * t48 - t4 * t49
    t51 = c1 * t44 + s1 * t43 + t1 * t46 + t2 * t45
    t52 = t51 + t3 * t49 + t4 * t48
    t53 = np.sqrt((t10 * t10 + t12 * t12))
    t54 = t12 * t25 - t10 * t27
    t55 = np.where(t53 != 0.0, 1, 0.0)
    t56 = t55 / (t53 + (1 - t55))
    t57 = t56 * t56
    t58 = t10 * t42 + t12 * t40
    t59 = t57 * t57
    t60 = 1.5 * t54
    t61 = t12 + t12
    t62 = t11 - t10
    t63 = t27 * t61 - t25 * t62
    t64 = t57 * t59
    t65 = t10 * t52 + t25 * t42 + t12 * t50 + t27 * t40
    t66 = t56 * (4.5 * t54) * (t63 * t63) * (t57 * t64) - t59 * (t56 * t65)
    t67 = t25 * t25
    t68 = t27 * t27
    t69 = t67 + t67 + (t68 + t68) + t40 * t62 + t42 * t61
    t70 = t66 + t64 * (t56 * (t63 * (3.5 * t58))) - t64 * (t56 * (t60 * t69))

    # results
    derivatives = np.empty((*_leading, 10), _real)
    path = np.empty((*_leading, 4), _real)
    derivatives[..., 0] = c1 * l1 + t1 * l2 + t3 * l3
    derivatives[..., 1] = l1 * s1 + l2 * t2 + l3 * t4
    derivatives[..., 2] = t11
    derivatives[..., 3] = t12
    derivatives[..., 4] = -t25
    derivatives[..., 5] = t27
    derivatives[..., 6] = t40
    derivatives[..., 7] = t42
    derivatives[..., 8] = t50
    derivatives[..., 9] = t52
    path[..., 0] = t53
    path[..., 1] = t54 * t56 * t57
    path[..., 2] = -(t58 * t59 + t60 * t63 * t64)
    path[..., 3] = t70
    return derivatives.reshape(_leading + (5, 2)), path.reshape(_leading + (4,))
