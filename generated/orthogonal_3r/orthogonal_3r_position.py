"""manipulability (position) of orthogonal_3r, in NumPy.

Made from templates/kernel.py.j2; inputs acb2265402e52b72edd2dd46636047fbec5ba872b074bc2fa364e334504a1dbe.
87 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def manipulability_position(q, parameters):
    """manipulability H = sqrt(det(J J^T)) of the position Jacobian: 18 operations.

    in   q[3]
    in   parameters[4] = (d2, d3, d4, r2)
    out  manipulability (one number)
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    d4 = parameters[..., 2]
    d3 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    r2 = parameters[..., 3]
    d2 = parameters[..., 0]
    s3 = np.sin(q3)

    # terms
    t1 = d3 + d4 * c3
    t2 = c3 * c2 * r2 - d2 * s3 - s3 * (d3 * c2)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    manipulability[..., 0] = np.sqrt((d4 * d4 * (t1 * t1) * (t2 * t2)))
    return manipulability.reshape(_leading)


def manipulability_gradient_position(q, parameters):
    """H and the gradients of H, 1/H and H^(-1/2), through the determinant of the position Jacobian, factored: 54 operations.

    in   q[3]
    in   parameters[4] = (d2, d3, d4, r2)
    out  manipulability (one number)
    out  gradient[3]
    out  inverse_gradient[3]
    out  inverse_root_gradient[3]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    d4 = parameters[..., 2]
    d3 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    r2 = parameters[..., 3]
    d2 = parameters[..., 0]
    s3 = np.sin(q3)
    s2 = np.sin(q2)

    # terms
    t1 = d4 * (d3 + d4 * c3)
    t2 = d3 * c2
    t3 = c3 * c2 * r2 - d2 * s3 - s3 * t2
    t4 = t1 * t3
    t5 = np.abs(t4)
    t6 = t4 / t5
    t7 = t1 * t6
    t8 = r2 * t7
    t9 = s2 * (c3 * t8 - d3 * (s3 * t7))
    t10 = c3 * (t2 * t7 + d2 * t7) + s3 * (c2 * t8 + d4 * (d4 * (t3 * t6)))
    t11 = 1 / t5
    t12 = t11 * t11
    t13 = -0.5 / t5 * np.sqrt(t11)

    # results
    manipulability = np.empty((*_leading, 1), _real)
    gradient = np.empty((*_leading, 3), _real)
    inverse_gradient = np.empty((*_leading, 3), _real)
    inverse_root_gradient = np.empty((*_leading, 3), _real)
    manipulability[..., 0] = t5
    gradient[..., 0] = 0.0
    gradient[..., 1] = np.where(t5 != 0.0, -t9, 0.0)
    gradient[..., 2] = np.where(t5 != 0.0, -t10, 0.0)
    inverse_gradient[..., 0] = 0.0
    inverse_gradient[..., 1] = np.where(t5 != 0.0, t9 * t12, 0.0)
    inverse_gradient[..., 2] = np.where(t5 != 0.0, t10 * t12, 0.0)
    inverse_root_gradient[..., 0] = 0.0
    inverse_root_gradient[..., 1] = np.where(t5 != 0.0, -(t9 * t13), 0.0)
    inverse_root_gradient[..., 2] = np.where(t5 != 0.0, -(t10 * t13), 0.0)
    return manipulability.reshape(_leading), gradient.reshape(_leading + (3,)), inverse_gradient.reshape(_leading + (3,)), inverse_root_gradient.reshape(_leading + (3,))


def minors_position(q, parameters):
    """determinant of the position Jacobian, factored: 15 operations.

    in   q[3]
    in   parameters[4] = (d2, d3, d4, r2)
    out  minors[1]
    """
    q = np.asarray(q)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(q.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(q, parameters, np.float32)

    # inputs, sines and cosines
    d4 = parameters[..., 2]
    d3 = parameters[..., 1]
    q3 = q[..., 2]
    c3 = np.cos(q3)
    q2 = q[..., 1]
    c2 = np.cos(q2)
    r2 = parameters[..., 3]
    d2 = parameters[..., 0]
    s3 = np.sin(q3)

    # terms
    t1 = c3 * c2 * r2 - d2 * s3 - s3 * (d3 * c2)

    # results
    minors = np.empty((*_leading, 1), _real)
    minors[..., 0] = -(d4 * (d3 + d4 * c3) * t1)
    return minors.reshape(_leading + (1,))
