"""motion of planar_rpp, in NumPy.

Made from templates/kernel.py.j2; inputs 77d54a7f81bd9c4c3c0edff9dda5a2475adf10a1ab0a56b8cd7a88c3ea5d968d.
298 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def tip_motion(q, parameters, rates, second, third):
    """derivatives of the tip along a joint motion, and the path's speed, curvature, dk/ds and d^2k/ds^2: 298 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading2, heading3)
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
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]
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
    t4 = t1 * cos_heading3 - t3 * sin_heading3
    t5 = l3 + q3
    t6 = cos_heading3 * t3 + t1 * sin_heading3
    t7 = l1 * dq1
    t8 = t2 * dq1
    t9 = t1 * dq2 - s1 * t7 - t3 * t8 + t4 * dq3
    t10 = t5 * dq1
    t11 = t9 - t6 * t10
    t12 = c1 * t7 + t1 * t8 + t3 * dq2 + t4 * t10
    t13 = t12 + t6 * dq3
    t14 = dq1 * dq1
    t15 = ddq2 - t2 * t14
    t16 = l1 * t14
    t17 = l1 * ddq1
    t18 = dq1 + dq1
    t19 = t2 * ddq1 + dq2 * t18
    t20 = t1 * t15 - (c1 * t16 + s1 * t17) - t3 * t19
    t21 = ddq3 - t5 * t14
    t22 = t5 * ddq1 + dq3 * t18
    t23 = t20 + t4 * t21 - t6 * t22
    t24 = c1 * t17 - s1 * t16 + t1 * t19 + t3 * t15
    t25 = t24 + t4 * t22 + t6 * t21
    t26 = l1 * (dq1 * (-3 * ddq1))
    t27 = dq1 * t14
    t28 = l1 * dddq1 - l1 * t27
    t29 = 3 * t2
    t30 = dddq2 - t14 * (3 * dq2) - dq1 * (ddq1 * t29)
    t31 = 3 * ddq1
    t32 = t2 * dddq1 + dq2 * t31 + dq1 * (3 * ddq2) - t2 * t27
    t33 = c1 * t26 - s1 * t28 + t1 * t30 - t3 * t32
    t34 = 3 * t5
    t35 = dddq3 - t14 * (3 * dq3) - dq1 * (ddq1 * t34)
    t36 = t5 * dddq1 + dq3 * t31 + dq1 * (3 * ddq3) - t5 * t27
    t37 = t33 + t4 * t35 - t6 * t36
    t38 = c1 * t28 + s1 * t26 + t1 * t32 + t3 * t30
    t39 = t38 + t4 * t36 + t6 * t35
    t40 = dq1 * t27
    t41 = ddq1 * ddq1
    t42 = 4 * dddq1
    t43 = l1 * t40 - 3 * l1 * t41 - l1 * (dq1 * t42)
    t44 = t14 * (l1 * (-6 * ddq1))
    t45 = dq1 * (12 * ddq1)
    t46 = t2 * t40 - t14 * (6 * ddq2) - t29 * t41 - dq2 * t45
    t47 = t46 - dq1 * (dddq1 * (4 * t2))
    t48 = 6 * ddq1
    t49 = dq2 * t42 + dq1 * (4 * dddq2) + ddq2 * t48 - t27 * (4 * dq2)
    t50 = t49 - t14 * (ddq1 * (6 * t2))
    t51 = c1 * t43 - s1 * t44 + t1 * t47 - t3 * t50
    t52 = t5 * t40 - t14 * (6 * ddq3) - t34 * t41 - dq3 * t45
    t53 = t52 - dq1 * (dddq1 * (4 * t5))
    t54 = dq3 * t42 + dq1 * (4 * dddq3) + ddq3 * t48 - t27 * (4 * dq3)
    t55 = t54 - t14 * (ddq1 * (6 * t5))
    t56 = t51 + t4 * t53 - t6 * t55
    t57 = c1 * t44 + s1 * t43 + t1 * t50 + t3 * t47
    t58 = t57 + t4 * t55 + t6 * t53
    t59 = np.sqrt((t11 * t11 + t13 * t13))
    t60 = t11 * t25 - t13 * t23
    t61 = np.where(t59 != 0.0, 1, 0.0)
    t62 = t61 / (t59 + (1 - t61))
    t63 = t62 * t62
    t64 = t11 * t39 - t13 * t37
    t65 = t63 * t63
    t66 = 1.5 * t60
    t67 = t11 + t11
    t68 = t13 + t13
    t69 = t23 * t67 + t25 * t68
    t70 = t63 * t65
    t71 = t11 * t58 + t23 * t39 - t13 * t56 - t25 * t37
    t72 = t65 * (t62 * t71) + t62 * (4.5 * t60) * (t69 * t69) * (t63 * t70)
    t73 = t23 * t23
    t74 = t25 * t25
    t75 = t73 + t73 + (t74 + t74) + t37 * t67 + t39 * t68
    t76 = t72 - t70 * (t62 * (t69 * (3.5 * t64))) - t70 * (t62 * (t66 * t75))

    # results
    derivatives = np.empty((*_leading, 10), _real)
    path = np.empty((*_leading, 4), _real)
    derivatives[..., 0] = c1 * l1 + t1 * t2 + t4 * t5
    derivatives[..., 1] = l1 * s1 + t2 * t3 + t5 * t6
    derivatives[..., 2] = t11
    derivatives[..., 3] = t13
    derivatives[..., 4] = t23
    derivatives[..., 5] = t25
    derivatives[..., 6] = t37
    derivatives[..., 7] = t39
    derivatives[..., 8] = t56
    derivatives[..., 9] = t58
    path[..., 0] = t59
    path[..., 1] = t60 * t62 * t63
    path[..., 2] = t64 * t65 - t66 * t69 * t70
    path[..., 3] = t76
    return derivatives.reshape(_leading + (5, 2)), path.reshape(_leading + (4,))
