"""motion of planar_ppp, in NumPy.

Made from templates/kernel.py.j2; inputs bd6aef8f0310a9f6c4cf51fc1aff8c0a4f966eeaea47ad70a09726da0e955413.
120 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def tip_motion(q, parameters, rates, second, third):
    """derivatives of the tip along a joint motion, and the path's speed, curvature, dk/ds and d^2k/ds^2: 120 operations.

    in   q[3]
    in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
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
    heading2 = parameters[..., 4]
    cos_heading2 = np.cos(heading2)
    sin_heading1 = np.sin(heading1)
    sin_heading2 = np.sin(heading2)
    l2 = parameters[..., 1]
    q2 = q[..., 1]
    heading3 = parameters[..., 5]
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
    t2 = cos_heading1 * cos_heading2 - sin_heading1 * sin_heading2
    t3 = l2 + q2
    t4 = cos_heading1 * sin_heading2 + cos_heading2 * sin_heading1
    t5 = t2 * cos_heading3 - t4 * sin_heading3
    t6 = l3 + q3
    t7 = cos_heading3 * t4 + t2 * sin_heading3
    t8 = cos_heading1 * dq1 + t2 * dq2 + t5 * dq3
    t9 = sin_heading1 * dq1 + t4 * dq2 + t7 * dq3
    t10 = cos_heading1 * ddq1 + t2 * ddq2 + t5 * ddq3
    t11 = sin_heading1 * ddq1 + t4 * ddq2 + t7 * ddq3
    t12 = cos_heading1 * dddq1 + t2 * dddq2 + t5 * dddq3
    t13 = sin_heading1 * dddq1 + t4 * dddq2 + t7 * dddq3
    t14 = np.sqrt((t8 * t8 + t9 * t9))
    t15 = t8 * t11 - t9 * t10
    t16 = np.where(t14 != 0.0, 1, 0.0)
    t17 = t16 / (t14 + (1 - t16))
    t18 = t17 * t17
    t19 = t8 * t13 - t9 * t12
    t20 = t18 * t18
    t21 = 1.5 * t15
    t22 = t8 + t8
    t23 = t9 + t9
    t24 = t10 * t22 + t11 * t23
    t25 = t18 * t20
    t26 = t20 * (t17 * (t10 * t13 - t11 * t12)) + t17 * (4.5 * t15) * (t24 * t24) * (t18 * t25)
    t27 = t10 * t10
    t28 = t11 * t11
    t29 = t27 + t27 + (t28 + t28) + t12 * t22 + t13 * t23
    t30 = t26 - t25 * (t17 * (t24 * (3.5 * t19))) - t25 * (t17 * (t21 * t29))

    # results
    derivatives = np.empty((*_leading, 10), _real)
    path = np.empty((*_leading, 4), _real)
    derivatives[..., 0] = cos_heading1 * t1 + t2 * t3 + t5 * t6
    derivatives[..., 1] = t1 * sin_heading1 + t3 * t4 + t6 * t7
    derivatives[..., 2] = t8
    derivatives[..., 3] = t9
    derivatives[..., 4] = t10
    derivatives[..., 5] = t11
    derivatives[..., 6] = t12
    derivatives[..., 7] = t13
    derivatives[..., 8] = 0.0
    derivatives[..., 9] = 0.0
    path[..., 0] = t14
    path[..., 1] = t15 * t17 * t18
    path[..., 2] = t19 * t20 - t21 * t24 * t25
    path[..., 3] = t30
    return derivatives.reshape(_leading + (5, 2)), path.reshape(_leading + (4,))
