"""motion of planar_rpr, in NumPy.

Made from templates/kernel.py.j2; inputs ee3a9f911eca78b26c8a152119d91b3c6de3b77a6e7abec428b72d8cc0446481.
274 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def tip_motion(q, parameters, rates, second, third):
    """derivatives of the tip along a joint motion, and the path's speed, curvature, dk/ds and d^2k/ds^2: 274 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading2)
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
    dq2 = rates[..., 1]
    dq1 = rates[..., 0]
    dq3 = rates[..., 2]
    ddq2 = second[..., 1]
    ddq1 = second[..., 0]
    ddq3 = second[..., 2]
    dddq1 = third[..., 0]
    dddq2 = third[..., 1]
    dddq3 = third[..., 2]

    # terms
    t1 = c1 * cos_heading2 - s1 * sin_heading2
    t2 = l2 + q2
    t3 = c1 * sin_heading2 + cos_heading2 * s1
    t4 = t1 * c3 - t3 * s3
    t5 = c3 * t3 + t1 * s3
    t6 = l1 * dq1
    t7 = t2 * dq1
    t8 = dq1 + dq3
    t9 = l3 * t8
    t10 = t1 * dq2 - s1 * t6 - t3 * t7 - t5 * t9
    t11 = c1 * t6 + t1 * t7 + t3 * dq2 + t4 * t9
    t12 = dq1 * dq1
    t13 = ddq2 - t2 * t12
    t14 = l1 * t12
    t15 = l1 * ddq1
    t16 = t2 * ddq1 + dq2 * (dq1 + dq1)
    t17 = t1 * t13 - (c1 * t14 + s1 * t15) - t3 * t16
    t18 = t8 * t8
    t19 = l3 * t18
    t20 = ddq1 + ddq3
    t21 = l3 * t20
    t22 = t17 - t4 * t19 - t5 * t21
    t23 = c1 * t15 - s1 * t14 + t1 * t16 + t3 * t13
    t24 = t23 + t4 * t21 - t5 * t19
    t25 = l1 * (dq1 * (-3 * ddq1))
    t26 = dq1 * t12
    t27 = l1 * dddq1 - l1 * t26
    t28 = 3 * t2
    t29 = dddq2 - t12 * (3 * dq2) - dq1 * (ddq1 * t28)
    t30 = t2 * dddq1 + dq2 * (3 * ddq1) + dq1 * (3 * ddq2)
    t31 = t30 - t2 * t26
    t32 = c1 * t25 - s1 * t27 + t1 * t29 - t3 * t31
    t33 = t20 * (t8 * (-3 * l3))
    t34 = dddq1 + dddq3
    t35 = t8 * t18
    t36 = l3 * t34 - l3 * t35
    t37 = t32 + t4 * t33 - t5 * t36
    t38 = c1 * t27 + s1 * t25 + t1 * t31 + t3 * t29
    t39 = t38 + t4 * t36 + t5 * t33
    t40 = dq1 * t26
    t41 = ddq1 * ddq1
    t42 = 4 * dddq1
    t43 = l1 * t40 - 3 * l1 * t41 - l1 * (dq1 * t42)
    t44 = t12 * (l1 * (-6 * ddq1))
    t45 = t2 * t40 - t12 * (6 * ddq2) - t28 * t41 - dq2 * (dq1 * (12 * ddq1))
    t46 = t45 - dq1 * (dddq1 * (4 * t2))
    t47 = dq2 * t42 + dq1 * (4 * dddq2) + ddq2 * (6 * ddq1)
    t48 = t47 - t26 * (4 * dq2) - t12 * (ddq1 * (6 * t2))
    t49 = c1 * t43 - s1 * t44 + t1 * t46 - t3 * t48
    t50 = l3 * (t8 * t35) - 3 * l3 * (t20 * t20) - t34 * (t8 * (4 * l3))
    t51 = t18 * (t20 * (-6 * l3))
    t52 = t49 + t4 * t50 - t5 * t51
    t53 = c1 * t44 + s1 * t43 + t1 * t48 + t3 * t46
    t54 = t53 + t4 * t51 + t5 * t50
    t55 = np.sqrt((t10 * t10 + t11 * t11))
    t56 = t10 * t24 - t11 * t22
    t57 = np.where(t55 != 0.0, 1, 0.0)
    t58 = t57 / (t55 + (1 - t57))
    t59 = t58 * t58
    t60 = t10 * t39 - t11 * t37
    t61 = t59 * t59
    t62 = 1.5 * t56
    t63 = t10 + t10
    t64 = t11 + t11
    t65 = t22 * t63 + t24 * t64
    t66 = t59 * t61
    t67 = t10 * t54 + t22 * t39 - t11 * t52 - t24 * t37
    t68 = t61 * (t58 * t67) + t58 * (4.5 * t56) * (t65 * t65) * (t59 * t66)
    t69 = t22 * t22
    t70 = t24 * t24
    t71 = t69 + t69 + (t70 + t70) + t37 * t63 + t39 * t64
    t72 = t68 - t66 * (t58 * (t65 * (3.5 * t60))) - t66 * (t58 * (t62 * t71))

    # results
    derivatives = np.empty((*_leading, 10), _real)
    path = np.empty((*_leading, 4), _real)
    derivatives[..., 0] = c1 * l1 + t1 * t2 + t4 * l3
    derivatives[..., 1] = l1 * s1 + t2 * t3 + l3 * t5
    derivatives[..., 2] = t10
    derivatives[..., 3] = t11
    derivatives[..., 4] = t22
    derivatives[..., 5] = t24
    derivatives[..., 6] = t37
    derivatives[..., 7] = t39
    derivatives[..., 8] = t52
    derivatives[..., 9] = t54
    path[..., 0] = t55
    path[..., 1] = t56 * t58 * t59
    path[..., 2] = t60 * t61 - t62 * t65 * t66
    path[..., 3] = t72
    return derivatives.reshape(_leading + (5, 2)), path.reshape(_leading + (4,))
