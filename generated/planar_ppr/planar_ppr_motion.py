"""motion of planar_ppr, in NumPy.

Made from templates/kernel.py.j2; inputs 18b1241e3541d21e565a17924e6723715e4f0ff2f740f05ea3a4f07b096ae92a.
161 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def tip_motion(q, parameters, rates, second, third):
    """derivatives of the tip along a joint motion, and the path's speed, curvature, dk/ds and d^2k/ds^2: 161 operations.

    in   q[3]
    in   parameters[5] = (l1, l2, l3, heading1, heading2)
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
    t2 = cos_heading1 * cos_heading2 - sin_heading1 * sin_heading2
    t3 = l2 + q2
    t4 = cos_heading1 * sin_heading2 + cos_heading2 * sin_heading1
    t5 = t2 * c3 - t4 * s3
    t6 = c3 * t4 + t2 * s3
    t7 = l3 * dq3
    t8 = cos_heading1 * dq1 + t2 * dq2 - t6 * t7
    t9 = sin_heading1 * dq1 + t4 * dq2 + t5 * t7
    t10 = dq3 * dq3
    t11 = l3 * t10
    t12 = l3 * ddq3
    t13 = cos_heading1 * ddq1 + t2 * ddq2 - t5 * t11 - t6 * t12
    t14 = sin_heading1 * ddq1 + t4 * ddq2 + t5 * t12 - t6 * t11
    t15 = l3 * (dq3 * (-3 * ddq3))
    t16 = dq3 * t10
    t17 = l3 * dddq3 - l3 * t16
    t18 = cos_heading1 * dddq1 + t2 * dddq2 + t5 * t15 - t6 * t17
    t19 = sin_heading1 * dddq1 + t4 * dddq2 + t5 * t17 + t6 * t15
    t20 = l3 * (dq3 * t16) - 3 * l3 * (ddq3 * ddq3) - l3 * (dq3 * (4 * dddq3))
    t21 = t10 * (l3 * (-6 * ddq3))
    t22 = t5 * t20 - t6 * t21
    t23 = t5 * t21 + t6 * t20
    t24 = np.sqrt((t8 * t8 + t9 * t9))
    t25 = t8 * t14 - t9 * t13
    t26 = np.where(t24 != 0.0, 1, 0.0)
    t27 = t26 / (t24 + (1 - t26))
    t28 = t27 * t27
    t29 = t8 * t19 - t9 * t18
    t30 = t28 * t28
    t31 = 1.5 * t25
    t32 = t8 + t8
    t33 = t9 + t9
    t34 = t13 * t32 + t14 * t33
    t35 = t28 * t30
    t36 = t8 * t23 + t13 * t19 - t9 * t22 - t14 * t18
    t37 = t30 * (t27 * t36) + t27 * (4.5 * t25) * (t34 * t34) * (t28 * t35)
    t38 = t13 * t13
    t39 = t14 * t14
    t40 = t38 + t38 + (t39 + t39) + t18 * t32 + t19 * t33
    t41 = t37 - t35 * (t27 * (t34 * (3.5 * t29))) - t35 * (t27 * (t31 * t40))

    # results
    derivatives = np.empty((*_leading, 10), _real)
    path = np.empty((*_leading, 4), _real)
    derivatives[..., 0] = cos_heading1 * t1 + t2 * t3 + t5 * l3
    derivatives[..., 1] = t1 * sin_heading1 + t3 * t4 + l3 * t6
    derivatives[..., 2] = t8
    derivatives[..., 3] = t9
    derivatives[..., 4] = t13
    derivatives[..., 5] = t14
    derivatives[..., 6] = t18
    derivatives[..., 7] = t19
    derivatives[..., 8] = t22
    derivatives[..., 9] = t23
    path[..., 0] = t24
    path[..., 1] = t25 * t27 * t28
    path[..., 2] = t29 * t30 - t31 * t34 * t35
    path[..., 3] = t41
    return derivatives.reshape(_leading + (5, 2)), path.reshape(_leading + (4,))
