"""motion of planar_rrp, in NumPy.

Made from templates/kernel.py.j2; inputs 5c95cf2c8c379e817760f14d4bee6dcee70998a13bb45c272c84b9df31621ce7.
272 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def tip_motion(q, parameters, rates, second, third):
    """derivatives of the tip along a joint motion, and the path's speed, curvature, dk/ds and d^2k/ds^2: 272 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading3)
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
    heading3 = parameters[..., 3]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]
    dq3 = rates[..., 2]
    dq1 = rates[..., 0]
    dq2 = rates[..., 1]
    ddq3 = second[..., 2]
    ddq1 = second[..., 0]
    ddq2 = second[..., 1]
    dddq1 = third[..., 0]
    dddq2 = third[..., 1]
    dddq3 = third[..., 2]

    # terms
    t1 = c1 * c2 - s1 * s2
    t2 = c1 * s2 + c2 * s1
    t3 = t1 * cos_heading3 - t2 * sin_heading3
    t4 = l3 + q3
    t5 = cos_heading3 * t2 + t1 * sin_heading3
    t6 = l1 * dq1
    t7 = dq1 + dq2
    t8 = l2 * t7
    t9 = t4 * t7
    t10 = t3 * dq3 - (s1 * t6 + t2 * t8) - t5 * t9
    t11 = c1 * t6 + t1 * t8 + t3 * t9 + t5 * dq3
    t12 = t7 * t7
    t13 = ddq3 - t4 * t12
    t14 = dq1 * dq1
    t15 = l1 * t14
    t16 = l1 * ddq1
    t17 = l2 * t12
    t18 = ddq1 + ddq2
    t19 = l2 * t18
    t20 = c1 * t15 + s1 * t16 + t1 * t17 + t2 * t19
    t21 = t4 * t18 + t7 * (dq3 + dq3)
    t22 = t3 * t13 - t20 - t5 * t21
    t23 = c1 * t16 - s1 * t15 + t1 * t19 - t2 * t17
    t24 = t23 + t3 * t21 + t5 * t13
    t25 = l1 * (dq1 * (-3 * ddq1))
    t26 = dq1 * t14
    t27 = l1 * dddq1 - l1 * t26
    t28 = t18 * (t7 * (-3 * l2))
    t29 = dddq1 + dddq2
    t30 = t7 * t12
    t31 = l2 * t29 - l2 * t30
    t32 = c1 * t25 - s1 * t27 + t1 * t28 - t2 * t31
    t33 = 3 * dq3
    t34 = 3 * t4
    t35 = dddq3 - t12 * t33 - t18 * (t7 * t34)
    t36 = t4 * t29 + t7 * (3 * ddq3) + t18 * t33 - t4 * t30
    t37 = t32 + t3 * t35 - t5 * t36
    t38 = c1 * t27 + s1 * t25 + t1 * t31 + t2 * t28
    t39 = t38 + t3 * t36 + t5 * t35
    t40 = l1 * (dq1 * t26) - 3 * l1 * (ddq1 * ddq1) - l1 * (dq1 * (4 * dddq1))
    t41 = t14 * (l1 * (-6 * ddq1))
    t42 = t7 * t30
    t43 = t18 * t18
    t44 = l2 * t42 - 3 * l2 * t43 - t29 * (t7 * (4 * l2))
    t45 = t12 * (t18 * (-6 * l2))
    t46 = c1 * t40 - s1 * t41 + t1 * t44 - t2 * t45
    t47 = 6 * ddq3
    t48 = t4 * t42 - t12 * t47 - t34 * t43 - t18 * (t7 * (12 * dq3))
    t49 = t48 - t29 * (t7 * (4 * t4))
    t50 = 4 * dq3
    t51 = t7 * (4 * dddq3) + t29 * t50 + t18 * t47 - t30 * t50
    t52 = t51 - t12 * (t18 * (6 * t4))
    t53 = t46 + t3 * t49 - t5 * t52
    t54 = c1 * t41 + s1 * t40 + t1 * t45 + t2 * t44
    t55 = t54 + t3 * t52 + t5 * t49
    t56 = np.sqrt((t10 * t10 + t11 * t11))
    t57 = t10 * t24 - t11 * t22
    t58 = np.where(t56 != 0.0, 1, 0.0)
    t59 = t58 / (t56 + (1 - t58))
    t60 = t59 * t59
    t61 = t10 * t39 - t11 * t37
    t62 = t60 * t60
    t63 = 1.5 * t57
    t64 = t10 + t10
    t65 = t11 + t11
    t66 = t22 * t64 + t24 * t65
    t67 = t60 * t62
    t68 = t10 * t55 + t22 * t39 - t11 * t53 - t24 * t37
    t69 = t62 * (t59 * t68) + t59 * (4.5 * t57) * (t66 * t66) * (t60 * t67)
    t70 = t22 * t22
    t71 = t24 * t24
    t72 = t70 + t70 + (t71 + t71) + t37 * t64 + t39 * t65
    t73 = t69 - t67 * (t59 * (t66 * (3.5 * t61))) - t67 * (t59 * (t63 * t72))

    # results
    derivatives = np.empty((*_leading, 10), _real)
    path = np.empty((*_leading, 4), _real)
    derivatives[..., 0] = c1 * l1 + t1 * l2 + t3 * t4
    derivatives[..., 1] = l1 * s1 + l2 * t2 + t4 * t5
    derivatives[..., 2] = t10
    derivatives[..., 3] = t11
    derivatives[..., 4] = t22
    derivatives[..., 5] = t24
    derivatives[..., 6] = t37
    derivatives[..., 7] = t39
    derivatives[..., 8] = t53
    derivatives[..., 9] = t55
    path[..., 0] = t56
    path[..., 1] = t57 * t59 * t60
    path[..., 2] = t61 * t62 - t63 * t66 * t67
    path[..., 3] = t73
    return derivatives.reshape(_leading + (5, 2)), path.reshape(_leading + (4,))
