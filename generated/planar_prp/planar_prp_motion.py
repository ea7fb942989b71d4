"""motion of planar_prp, in NumPy.

Made from templates/kernel.py.j2; inputs 7eeb450ee91bebd697b60cf7e0deb29d375406602e39b9b258699015f72d46fc.
232 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def tip_motion(q, parameters, rates, second, third):
    """derivatives of the tip along a joint motion, and the path's speed, curvature, dk/ds and d^2k/ds^2: 232 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading3)
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
    heading1 = parameters[..., 3]
    cos_heading1 = np.cos(heading1)
    l1 = parameters[..., 0]
    q1 = q[..., 0]
    q2 = q[..., 1]
    c2 = np.cos(q2)
    sin_heading1 = np.sin(heading1)
    s2 = np.sin(q2)
    l2 = parameters[..., 1]
    heading3 = parameters[..., 4]
    cos_heading3 = np.cos(heading3)
    sin_heading3 = np.sin(heading3)
    l3 = parameters[..., 2]
    q3 = q[..., 2]
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
    t1 = l1 + q1
    t2 = cos_heading1 * c2 - sin_heading1 * s2
    t3 = cos_heading1 * s2 + c2 * sin_heading1
    t4 = t2 * cos_heading3 - t3 * sin_heading3
    t5 = l3 + q3
    t6 = cos_heading3 * t3 + t2 * sin_heading3
    t7 = l2 * dq2
    t8 = t5 * dq2
    t9 = cos_heading1 * dq1 - t3 * t7 + t4 * dq3 - t6 * t8
    t10 = sin_heading1 * dq1 + t2 * t7 + t4 * t8 + t6 * dq3
    t11 = dq2 * dq2
    t12 = l2 * t11
    t13 = l2 * ddq2
    t14 = ddq3 - t5 * t11
    t15 = cos_heading1 * ddq1 - t2 * t12 - t3 * t13 + t4 * t14
    t16 = t5 * ddq2 + dq3 * (dq2 + dq2)
    t17 = t15 - t6 * t16
    t18 = sin_heading1 * ddq1 + t2 * t13 - t3 * t12 + t4 * t16
    t19 = t18 + t6 * t14
    t20 = l2 * (dq2 * (-3 * ddq2))
    t21 = dq2 * t11
    t22 = l2 * dddq2 - l2 * t21
    t23 = 3 * t5
    t24 = dddq3 - t11 * (3 * dq3) - dq2 * (ddq2 * t23)
    t25 = cos_heading1 * dddq1 + t2 * t20 - t3 * t22 + t4 * t24
    t26 = t5 * dddq2 + dq3 * (3 * ddq2) + dq2 * (3 * ddq3)
    t27 = t26 - t5 * t21
    t28 = t25 - t6 * t27
    t29 = sin_heading1 * dddq1 + t2 * t22 + t3 * t20 + t4 * t27
    t30 = t29 + t6 * t24
    t31 = dq2 * t21
    t32 = ddq2 * ddq2
    t33 = 4 * dddq2
    t34 = l2 * t31 - 3 * l2 * t32 - l2 * (dq2 * t33)
    t35 = t11 * (l2 * (-6 * ddq2))
    t36 = t5 * t31 - t11 * (6 * ddq3) - t23 * t32 - dq3 * (dq2 * (12 * ddq2))
    t37 = t36 - dq2 * (dddq2 * (4 * t5))
    t38 = dq3 * t33 + dq2 * (4 * dddq3) + ddq3 * (6 * ddq2)
    t39 = t38 - t21 * (4 * dq3) - t11 * (ddq2 * (6 * t5))
    t40 = t2 * t34 - t3 * t35 + t4 * t37 - t6 * t39
    t41 = t2 * t35 + t3 * t34 + t4 * t39 + t6 * t37
    t42 = np.sqrt((t9 * t9 + t10 * t10))
    t43 = t9 * t19 - t10 * t17
    t44 = np.where(t42 != 0.0, 1, 0.0)
    t45 = t44 / (t42 + (1 - t44))
    t46 = t45 * t45
    t47 = t9 * t30 - t10 * t28
    t48 = t46 * t46
    t49 = 1.5 * t43
    t50 = t9 + t9
    t51 = t10 + t10
    t52 = t17 * t50 + t19 * t51
    t53 = t46 * t48
    t54 = t9 * t41 + t17 * t30 - t10 * t40 - t19 * t28
    t55 = t48 * (t45 * t54) + t45 * (4.5 * t43) * (t52 * t52) * (t46 * t53)
    t56 = t17 * t17
    t57 = t19 * t19
    t58 = t56 + t56 + (t57 + t57) + t28 * t50 + t30 * t51
    t59 = t55 - t53 * (t45 * (t52 * (3.5 * t47))) - t53 * (t45 * (t49 * t58))

    # results
    derivatives = np.empty((*_leading, 10), _real)
    path = np.empty((*_leading, 4), _real)
    derivatives[..., 0] = cos_heading1 * t1 + t2 * l2 + t4 * t5
    derivatives[..., 1] = t1 * sin_heading1 + l2 * t3 + t5 * t6
    derivatives[..., 2] = t9
    derivatives[..., 3] = t10
    derivatives[..., 4] = t17
    derivatives[..., 5] = t19
    derivatives[..., 6] = t28
    derivatives[..., 7] = t30
    derivatives[..., 8] = t40
    derivatives[..., 9] = t41
    path[..., 0] = t42
    path[..., 1] = t43 * t45 * t46
    path[..., 2] = t47 * t48 - t49 * t52 * t53
    path[..., 3] = t59
    return derivatives.reshape(_leading + (5, 2)), path.reshape(_leading + (4,))
