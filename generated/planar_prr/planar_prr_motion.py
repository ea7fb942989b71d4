"""motion of planar_prr, in NumPy.

Made from templates/kernel.py.j2; inputs 3ba599d5b18781c5deed40d4b80666fc484cf95312cb60aaabb89a9bcc40aa47.
203 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def tip_motion(q, parameters, rates, second, third):
    """derivatives of the tip along a joint motion, and the path's speed, curvature, dk/ds and d^2k/ds^2: 203 operations.

    in   q[3]
    in   parameters[4] = (l1, l2, l3, heading1)
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
    t1 = l1 + q1
    t2 = cos_heading1 * c2 - sin_heading1 * s2
    t3 = cos_heading1 * s2 + c2 * sin_heading1
    t4 = t2 * c3 - t3 * s3
    t5 = c3 * t3 + t2 * s3
    t6 = l2 * dq2
    t7 = dq2 + dq3
    t8 = l3 * t7
    t9 = cos_heading1 * dq1 - t3 * t6 - t5 * t8
    t10 = sin_heading1 * dq1 + t2 * t6 + t4 * t8
    t11 = dq2 * dq2
    t12 = l2 * t11
    t13 = l2 * ddq2
    t14 = t7 * t7
    t15 = l3 * t14
    t16 = cos_heading1 * ddq1 - t2 * t12 - t3 * t13 - t4 * t15
    t17 = ddq2 + ddq3
    t18 = l3 * t17
    t19 = t16 - t5 * t18
    t20 = sin_heading1 * ddq1 + t2 * t13 - t3 * t12 + t4 * t18
    t21 = t20 - t5 * t15
    t22 = l2 * (dq2 * (-3 * ddq2))
    t23 = dq2 * t11
    t24 = l2 * dddq2 - l2 * t23
    t25 = t17 * (t7 * (-3 * l3))
    t26 = cos_heading1 * dddq1 + t2 * t22 - t3 * t24 + t4 * t25
    t27 = dddq2 + dddq3
    t28 = t7 * t14
    t29 = l3 * t27 - l3 * t28
    t30 = t26 - t5 * t29
    t31 = sin_heading1 * dddq1 + t2 * t24 + t3 * t22 + t4 * t29
    t32 = t31 + t5 * t25
    t33 = l2 * (dq2 * t23) - 3 * l2 * (ddq2 * ddq2) - l2 * (dq2 * (4 * dddq2))
    t34 = t11 * (l2 * (-6 * ddq2))
    t35 = l3 * (t7 * t28) - 3 * l3 * (t17 * t17) - t27 * (t7 * (4 * l3))
    t36 = t14 * (t17 * (-6 * l3))
    t37 = t2 * t33 - t3 * t34 + t4 * t35 - t5 * t36
    t38 = t2 * t34 + t3 * t33 + t4 * t36 + t5 * t35
    t39 = np.sqrt((t9 * t9 + t10 * t10))
    t40 = t9 * t21 - t10 * t19
    t41 = np.where(t39 != 0.0, 1, 0.0)
    t42 = t41 / (t39 + (1 - t41))
    t43 = t42 * t42
    t44 = t9 * t32 - t10 * t30
    t45 = t43 * t43
    t46 = 1.5 * t40
    t47 = t9 + t9
    t48 = t10 + t10
    t49 = t19 * t47 + t21 * t48
    t50 = t43 * t45
    t51 = t9 * t38 + t19 * t32 - t10 * t37 - t21 * t30
    t52 = t45 * (t42 * t51) + t42 * (4.5 * t40) * (t49 * t49) * (t43 * t50)
    t53 = t19 * t19
    t54 = t21 * t21
    t55 = t53 + t53 + (t54 + t54) + t30 * t47 + t32 * t48
    t56 = t52 - t50 * (t42 * (t49 * (3.5 * t44))) - t50 * (t42 * (t46 * t55))

    # results
    derivatives = np.empty((*_leading, 10), _real)
    path = np.empty((*_leading, 4), _real)
    derivatives[..., 0] = cos_heading1 * t1 + t2 * l2 + t4 * l3
    derivatives[..., 1] = t1 * sin_heading1 + l2 * t3 + l3 * t5
    derivatives[..., 2] = t9
    derivatives[..., 3] = t10
    derivatives[..., 4] = t19
    derivatives[..., 5] = t21
    derivatives[..., 6] = t30
    derivatives[..., 7] = t32
    derivatives[..., 8] = t37
    derivatives[..., 9] = t38
    path[..., 0] = t39
    path[..., 1] = t40 * t42 * t43
    path[..., 2] = t44 * t45 - t46 * t49 * t50
    path[..., 3] = t56
    return derivatives.reshape(_leading + (5, 2)), path.reshape(_leading + (4,))
