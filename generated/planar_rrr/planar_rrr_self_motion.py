"""self motion of planar_rrr, in NumPy.

Made from templates/kernel.py.j2; inputs 2d6e0728d7e0471aa1f34711d97efcdc8ee46c6069e2bce80c53b394abd5f280.
1479 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def self_motion_gaps_position(reach, sums, parameters):
    """differences a - b, b - c, c - d of the sorted roots, and whether b is A and c is B: 19 operations.

    in   reach[1] = (r)
    in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
    in   parameters[3] = (l1, l2, l3)
    out  gaps[3]
    out  pattern[2]
    """
    reach = np.asarray(reach)
    sums = np.asarray(sums)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(reach.shape[:-1], sums.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(reach, sums, parameters, np.float32)

    # inputs, sines and cosines
    m1 = sums[..., 1]
    p0 = sums[..., 4]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    m0 = sums[..., 0]
    p1 = sums[..., 5]
    p2 = sums[..., 6]
    p3 = sums[..., 7]
    l3 = parameters[..., 2]
    r = reach[..., 0]
    m2 = sums[..., 2]
    m3 = sums[..., 3]

    # terms
    t1 = m1 * p0
    t2 = np.minimum(np.minimum(np.minimum((4 * l1 * l2), m0 * p1), p2 * p3), 4 * l3 * r)
    t3 = -(m2 * m3)

    # results
    gaps = np.empty((*_leading, 3), _real)
    pattern = np.empty((*_leading, 2), _real)
    gaps[..., 0] = np.copysign(t1, 1)
    gaps[..., 1] = t2
    gaps[..., 2] = np.copysign(t3, 1)
    pattern[..., 0] = np.where(np.maximum(0.0, -t1) != 0.0, 1, 0.0)
    pattern[..., 1] = np.where(np.maximum(0.0, t3) != 0.0, 1, 0.0)
    return gaps.reshape(_leading + (3,)), pattern.reshape(_leading + (2,))


def self_motion_speed_position(node, reach, sums, parameters):
    """ds/d theta of the self-motion, theta uniform in the elliptic parameter: 279 operations.

    in   node[2] = (ct, st)
    in   reach[1] = (r)
    in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
    in   parameters[3] = (l1, l2, l3)
    out  speed (one number)
    """
    node = np.asarray(node)
    reach = np.asarray(reach)
    sums = np.asarray(sums)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(node.shape[:-1], reach.shape[:-1], sums.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(node, reach, sums, parameters, np.float32)

    # inputs, sines and cosines
    m2 = sums[..., 2]
    m3 = sums[..., 3]
    ct = node[..., 0]
    m1 = sums[..., 1]
    p0 = sums[..., 4]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    m0 = sums[..., 0]
    p1 = sums[..., 5]
    p2 = sums[..., 6]
    p3 = sums[..., 7]
    l3 = parameters[..., 2]
    r = reach[..., 0]
    st = node[..., 1]

    # terms
    t1 = -(m2 * m3)
    t2 = np.maximum(0.0, t1)
    t3 = m1 * p0
    t4 = np.copysign(t3, 1)
    t5 = np.copysign(t1, 1)
    t6 = np.sqrt((t4 * t5))
    t7 = np.minimum(np.minimum(np.minimum((4 * l1 * l2), m0 * p1), p2 * p3), 4 * l3 * r)
    t8 = np.maximum(0.0, t7)
    t9 = t4 + t8
    t10 = np.sqrt((t9 * (t5 + t8)))
    t11 = np.sqrt((t6 * t10))
    t12 = 0.5 * t6 + 0.5 * t10
    t13 = np.sqrt((t11 * t12))
    t14 = 0.5 * t11 + 0.5 * t12
    t15 = np.sqrt((t13 * t14))
    t16 = 0.5 * t13 + 0.5 * t14
    t17 = np.sqrt((t15 * t16))
    t18 = 0.5 * t15 + 0.5 * t16
    t19 = np.sqrt((t17 * t18))
    t20 = 0.5 * t17 + 0.5 * t18
    t21 = np.sqrt((t19 * t20))
    t22 = 0.5 * t19 + 0.5 * t20
    t23 = np.sqrt((t21 * t22))
    t24 = 0.5 * t21 + 0.5 * t22
    t25 = np.sqrt((t23 * t24))
    t26 = 0.5 * t23 + 0.5 * t24
    t27 = 0.5 * t25 + 0.5 * t26
    t28 = ct * t27
    t29 = ct * t28
    t30 = st * st
    t31 = t29 + t26 * t30
    t32 = np.where(t31 != 0.0, 1, 0.0)
    t33 = t28 * ((t29 + t25 * t30) * (t32 / (t31 + (1 - t32))))
    t34 = np.where(t26 != 0.0, 1, 0.0)
    t35 = t28 * (t28 * (t34 / (t26 + (1 - t34))))
    t36 = t35 + t24 * t30
    t37 = np.where(t36 != 0.0, 1, 0.0)
    t38 = t33 * ((t35 + t23 * t30) * (t37 / (t36 + (1 - t37))))
    t39 = np.where(t24 != 0.0, 1, 0.0)
    t40 = t33 * (t33 * (t39 / (t24 + (1 - t39))))
    t41 = t40 + t22 * t30
    t42 = np.where(t41 != 0.0, 1, 0.0)
    t43 = t38 * ((t40 + t21 * t30) * (t42 / (t41 + (1 - t42))))
    t44 = np.where(t22 != 0.0, 1, 0.0)
    t45 = t38 * (t38 * (t44 / (t22 + (1 - t44))))
    t46 = t45 + t20 * t30
    t47 = np.where(t46 != 0.0, 1, 0.0)
    t48 = t43 * ((t45 + t19 * t30) * (t47 / (t46 + (1 - t47))))
    t49 = np.where(t20 != 0.0, 1, 0.0)
    t50 = t43 * (t43 * (t49 / (t20 + (1 - t49))))
    t51 = t50 + t18 * t30
    t52 = np.where(t51 != 0.0, 1, 0.0)
    t53 = t48 * ((t50 + t17 * t30) * (t52 / (t51 + (1 - t52))))
    t54 = np.where(t18 != 0.0, 1, 0.0)
    t55 = t48 * (t48 * (t54 / (t18 + (1 - t54))))
    t56 = t55 + t16 * t30
    t57 = np.where(t56 != 0.0, 1, 0.0)
    t58 = t53 * ((t55 + t15 * t30) * (t57 / (t56 + (1 - t57))))
    t59 = np.where(t16 != 0.0, 1, 0.0)
    t60 = t53 * (t53 * (t59 / (t16 + (1 - t59))))
    t61 = t60 + t14 * t30
    t62 = np.where(t61 != 0.0, 1, 0.0)
    t63 = t58 * ((t60 + t13 * t30) * (t62 / (t61 + (1 - t62))))
    t64 = np.where(t14 != 0.0, 1, 0.0)
    t65 = t58 * (t58 * (t64 / (t14 + (1 - t64))))
    t66 = t65 + t12 * t30
    t67 = np.where(t66 != 0.0, 1, 0.0)
    t68 = t63 * ((t65 + t11 * t30) * (t67 / (t66 + (1 - t67))))
    t69 = np.where(t10 != 0.0, 1, 0.0)
    t70 = t68 * (t69 / (t10 + (1 - t69))) * np.sqrt(t9)
    t71 = st * np.sqrt(t4)
    t72 = np.sqrt((t70 * t70 + t71 * t71))
    t73 = np.where(t72 != 0.0, 1, 0.0)
    t74 = t73 / (t72 + (1 - t73))
    t75 = np.sqrt(t8)
    t76 = t70 * t74 * t75
    t77 = 1 - np.where(t2 != 0.0, 1, 0.0)
    t78 = np.sqrt((t5 + t76 * t76))
    t79 = np.where(t2 != 0.0, t76, 0.0) + t77 * t78
    t80 = t79 * t79
    t81 = l1 - l2
    t82 = t80 + t81 * t81
    t83 = np.where(t82 != 0.0, 1, 0.0)
    t84 = t83 / (t82 + (1 - t83))
    t85 = np.where(t2 != 0.0, t78, 0.0) + t76 * t77
    t86 = np.maximum(0.0, -t3)
    t87 = 1 - np.where(t86 != 0.0, 1, 0.0)
    t88 = t75 * (t71 * t74)
    t89 = np.sqrt((t4 + t88 * t88))
    t90 = 0.5 * (t85 * (t87 * t88 + np.where(t86 != 0.0, t89, 0.0)))
    t91 = 0.5 * t80
    t92 = 0.5 * (t79 * (t87 * t89 + np.where(t86 != 0.0, t88, 0.0)))
    t93 = t92 * (l3 * (r - l3) - 0.5 * (t85 * t85))
    t94 = t84 * (t90 * (t91 + l2 * (l2 - l1)) - t93)
    t95 = t92 + t84 * (t93 + t90 * (t91 + l1 * t81))
    t96 = np.where(t27 != 0.0, 1, 0.0)
    t97 = np.sqrt((t94 * t94 + t90 * t90 + t95 * t95)) * (4 * (t96 / (t27 + (1 - t96))))

    # results
    speed = np.empty((*_leading, 1), _real)
    speed[..., 0] = t97
    return speed.reshape(_leading)


def self_motion_turn_position(node, reach, sums, parameters):
    """cosine and sine of phi at a point theta of the elliptic parameter: 208 operations.

    in   node[2] = (ct, st)
    in   reach[1] = (r)
    in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
    in   parameters[3] = (l1, l2, l3)
    out  phi[2]
    """
    node = np.asarray(node)
    reach = np.asarray(reach)
    sums = np.asarray(sums)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(node.shape[:-1], reach.shape[:-1], sums.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(node, reach, sums, parameters, np.float32)

    # inputs, sines and cosines
    ct = node[..., 0]
    m1 = sums[..., 1]
    p0 = sums[..., 4]
    m2 = sums[..., 2]
    m3 = sums[..., 3]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    m0 = sums[..., 0]
    p1 = sums[..., 5]
    p2 = sums[..., 6]
    p3 = sums[..., 7]
    l3 = parameters[..., 2]
    r = reach[..., 0]
    st = node[..., 1]

    # terms
    t1 = np.copysign((m1 * p0), 1)
    t2 = np.copysign((-(m2 * m3)), 1)
    t3 = np.sqrt((t1 * t2))
    t4 = np.minimum(np.minimum(np.minimum((4 * l1 * l2), m0 * p1), p2 * p3), 4 * l3 * r)
    t5 = np.maximum(0.0, t4)
    t6 = t1 + t5
    t7 = np.sqrt((t6 * (t2 + t5)))
    t8 = np.sqrt((t3 * t7))
    t9 = 0.5 * t3 + 0.5 * t7
    t10 = np.sqrt((t8 * t9))
    t11 = 0.5 * t8 + 0.5 * t9
    t12 = np.sqrt((t10 * t11))
    t13 = 0.5 * t10 + 0.5 * t11
    t14 = np.sqrt((t12 * t13))
    t15 = 0.5 * t12 + 0.5 * t13
    t16 = np.sqrt((t14 * t15))
    t17 = 0.5 * t14 + 0.5 * t15
    t18 = np.sqrt((t16 * t17))
    t19 = 0.5 * t16 + 0.5 * t17
    t20 = np.sqrt((t18 * t19))
    t21 = 0.5 * t18 + 0.5 * t19
    t22 = np.sqrt((t20 * t21))
    t23 = 0.5 * t20 + 0.5 * t21
    t24 = ct * (0.5 * t22 + 0.5 * t23)
    t25 = ct * t24
    t26 = st * st
    t27 = t25 + t23 * t26
    t28 = np.where(t27 != 0.0, 1, 0.0)
    t29 = t24 * ((t25 + t22 * t26) * (t28 / (t27 + (1 - t28))))
    t30 = np.where(t23 != 0.0, 1, 0.0)
    t31 = t24 * (t24 * (t30 / (t23 + (1 - t30))))
    t32 = t31 + t21 * t26
    t33 = np.where(t32 != 0.0, 1, 0.0)
    t34 = t29 * ((t31 + t20 * t26) * (t33 / (t32 + (1 - t33))))
    t35 = np.where(t21 != 0.0, 1, 0.0)
    t36 = t29 * (t29 * (t35 / (t21 + (1 - t35))))
    t37 = t36 + t19 * t26
    t38 = np.where(t37 != 0.0, 1, 0.0)
    t39 = t34 * ((t36 + t18 * t26) * (t38 / (t37 + (1 - t38))))
    t40 = np.where(t19 != 0.0, 1, 0.0)
    t41 = t34 * (t34 * (t40 / (t19 + (1 - t40))))
    t42 = t41 + t17 * t26
    t43 = np.where(t42 != 0.0, 1, 0.0)
    t44 = t39 * ((t41 + t16 * t26) * (t43 / (t42 + (1 - t43))))
    t45 = np.where(t17 != 0.0, 1, 0.0)
    t46 = t39 * (t39 * (t45 / (t17 + (1 - t45))))
    t47 = t46 + t15 * t26
    t48 = np.where(t47 != 0.0, 1, 0.0)
    t49 = t44 * ((t46 + t14 * t26) * (t48 / (t47 + (1 - t48))))
    t50 = np.where(t15 != 0.0, 1, 0.0)
    t51 = t44 * (t44 * (t50 / (t15 + (1 - t50))))
    t52 = t51 + t13 * t26
    t53 = np.where(t52 != 0.0, 1, 0.0)
    t54 = t49 * ((t51 + t12 * t26) * (t53 / (t52 + (1 - t53))))
    t55 = np.where(t13 != 0.0, 1, 0.0)
    t56 = t49 * (t49 * (t55 / (t13 + (1 - t55))))
    t57 = t56 + t11 * t26
    t58 = np.where(t57 != 0.0, 1, 0.0)
    t59 = t54 * ((t56 + t10 * t26) * (t58 / (t57 + (1 - t58))))
    t60 = np.where(t11 != 0.0, 1, 0.0)
    t61 = t54 * (t54 * (t60 / (t11 + (1 - t60))))
    t62 = t61 + t9 * t26
    t63 = np.where(t62 != 0.0, 1, 0.0)
    t64 = t59 * ((t61 + t8 * t26) * (t63 / (t62 + (1 - t63))))
    t65 = np.where(t7 != 0.0, 1, 0.0)
    t66 = t64 * (t65 / (t7 + (1 - t65))) * np.sqrt(t6)
    t67 = st * np.sqrt(t1)
    t68 = np.sqrt((t66 * t66 + t67 * t67))
    t69 = np.where(t68 != 0.0, 1, 0.0)
    t70 = t69 / (t68 + (1 - t69))

    # results
    phi = np.empty((*_leading, 2), _real)
    phi[..., 0] = t66 * t70
    phi[..., 1] = t67 * t70
    return phi.reshape(_leading + (2,))


def self_motion_point_position(turn, reach, sums, parameters):
    """joint values, their rates dq/dw, H and ds/d phi at a point phi of the self-motion: 110 operations.

    in   turn[2] = (cp, sp)
    in   reach[1] = (r)
    in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
    in   parameters[3] = (l1, l2, l3)
    out  q[3]
    out  rates[3]
    out  manipulability (one number)
    out  speed (one number)
    """
    turn = np.asarray(turn)
    reach = np.asarray(reach)
    sums = np.asarray(sums)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(turn.shape[:-1], reach.shape[:-1], sums.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(turn, reach, sums, parameters, np.float32)

    # inputs, sines and cosines
    m2 = sums[..., 2]
    m3 = sums[..., 3]
    cp = turn[..., 0]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    m0 = sums[..., 0]
    p1 = sums[..., 5]
    p2 = sums[..., 6]
    p3 = sums[..., 7]
    l3 = parameters[..., 2]
    r = reach[..., 0]
    m1 = sums[..., 1]
    p0 = sums[..., 4]
    sp = turn[..., 1]

    # terms
    t1 = -(m2 * m3)
    t2 = np.maximum(0.0, t1)
    t3 = np.minimum(np.minimum(np.minimum((4 * l1 * l2), m0 * p1), p2 * p3), 4 * l3 * r)
    t4 = np.sqrt(np.maximum(0.0, t3))
    t5 = cp * t4
    t6 = 1 - np.where(t2 != 0.0, 1, 0.0)
    t7 = np.sqrt((np.copysign(t1, 1) + t5 * t5))
    t8 = np.where(t2 != 0.0, t5, 0.0) + t6 * t7
    t9 = t8 * t8
    t10 = l1 - l2
    t11 = t9 + t10 * t10
    t12 = np.where(t11 != 0.0, 1, 0.0)
    t13 = t12 / (t11 + (1 - t12))
    t14 = m1 * p0
    t15 = np.maximum(0.0, -t14)
    t16 = 1 - np.where(t15 != 0.0, 1, 0.0)
    t17 = t4 * sp
    t18 = np.sqrt((np.copysign(t14, 1) + t17 * t17))
    t19 = 0.5 * (t8 * (t16 * t18 + np.where(t15 != 0.0, t17, 0.0)))
    t20 = np.where(t2 != 0.0, t7, 0.0) + t5 * t6
    t21 = 0.5 * (t20 * t20)
    t22 = r - l3
    t23 = t21 + r * t22
    t24 = 0.5 * (t20 * (t16 * t17 + np.where(t15 != 0.0, t18, 0.0)))
    t25 = 0.5 * t9
    t26 = t25 + l1 * t10
    t27 = t24 * t26
    t28 = t13 * (t19 * t23 + t27)
    t29 = t19 * t24
    t30 = t25 + l2 * (l2 - l1)
    t31 = l3 * t22 - t21
    t32 = t19 * t31
    t33 = t13 * (t24 * t30 - t32)
    t34 = t19 + t13 * (t27 + t32)
    t35 = np.sqrt((t33 * t33 + t24 * t24 + t34 * t34))
    t36 = t7 * t18
    t37 = np.where(t36 != 0.0, 1, 0.0)

    # results
    q = np.empty((*_leading, 3), _real)
    rates = np.empty((*_leading, 3), _real)
    manipulability = np.empty((*_leading, 1), _real)
    speed = np.empty((*_leading, 1), _real)
    q[..., 0] = -np.arctan2(np.where(t28 != 0.0, t28, 0.0), t13 * (t23 * t26 - t29))
    q[..., 1] = np.arctan2(np.where(t19 != 0.0, t19, 0.0), t25 - l1 * l2)
    q[..., 2] = np.arctan2(np.where(t33 != 0.0, t33, 0.0), t13 * (t29 + t30 * t31))
    rates[..., 0] = -t33
    rates[..., 1] = t24
    rates[..., 2] = -t34
    manipulability[..., 0] = t35
    speed[..., 0] = 4 * t35 * (t37 / (t36 + (1 - t37)))
    return q.reshape(_leading + (3,)), rates.reshape(_leading + (3,)), manipulability.reshape(_leading), speed.reshape(_leading)


def self_motion_phase_position(halves, reach, sums, parameters):
    """sqrt(x - c) and sqrt(b - x), with the signs of cos phi and sin phi, of a configuration: 40 operations.

    in   halves[2] = (h1, h2)
    in   reach[1] = (r)
    in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
    in   parameters[3] = (l1, l2, l3)
    out  phase[2]
    """
    halves = np.asarray(halves)
    reach = np.asarray(reach)
    sums = np.asarray(sums)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(halves.shape[:-1], reach.shape[:-1], sums.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(halves, reach, sums, parameters, np.float32)

    # inputs, sines and cosines
    l3 = parameters[..., 2]
    r = reach[..., 0]
    h2 = halves[..., 1]
    sin_h2 = np.sin(h2)
    m2 = sums[..., 2]
    m3 = sums[..., 3]
    m1 = sums[..., 1]
    p0 = sums[..., 4]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    h1 = halves[..., 0]
    cos_h1 = np.cos(h1)
    sin_h1 = np.sin(h1)
    cos_h2 = np.cos(h2)

    # terms
    t1 = np.sqrt(np.maximum(0.0, 4 * l3 * r))
    t2 = t1 * sin_h2
    t3 = np.maximum(0.0, -(m2 * m3))
    t4 = 1 - np.where(t3 != 0.0, 1, 0.0)
    t5 = np.maximum(0.0, -(m1 * p0))
    t6 = np.sqrt(np.maximum(0.0, 4 * l1 * l2))
    t7 = t6 * cos_h1
    t8 = 1 - np.where(t5 != 0.0, 1, 0.0)
    t9 = t6 * sin_h1
    t10 = t2 * t4 + np.where(t3 != 0.0, np.where(t5 != 0.0, t7, 0.0) + t8 * np.copysign(t7, t9), 0.0)
    t11 = t1 * cos_h2
    t12 = t8 * (np.where(t3 != 0.0, np.copysign(t11, t2), 0.0) + t4 * t11) + np.where(t5 != 0.0, t9, 0.0)

    # results
    phase = np.empty((*_leading, 2), _real)
    phase[..., 0] = t10
    phase[..., 1] = t12
    return phase.reshape(_leading + (2,))


def self_motion_extremes_position(reach, sums, parameters):
    """least and greatest absolute angle of each joint along the self-motion: 79 operations.

    in   reach[1] = (r)
    in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
    in   parameters[3] = (l1, l2, l3)
    out  extremes[3][2]
    """
    reach = np.asarray(reach)
    sums = np.asarray(sums)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(reach.shape[:-1], sums.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(reach, sums, parameters, np.float32)

    # inputs, sines and cosines
    m1 = sums[..., 1]
    m2 = sums[..., 2]
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    m0 = sums[..., 0]
    p3 = sums[..., 7]
    p1 = sums[..., 5]
    p2 = sums[..., 6]
    l1 = parameters[..., 0]
    r = reach[..., 0]
    m3 = sums[..., 3]
    p0 = sums[..., 4]

    # terms
    t1 = -(m1 * m2)
    t2 = np.maximum(0.0, t1)
    t3 = np.copysign(t1, 1)
    t4 = np.where(t2 != 0.0, t3, 0.0)
    t5 = 4 * l1
    t6 = np.minimum(np.minimum(np.minimum((4 * l2 * l3), m0 * p3), p1 * p2), t5 * r)
    t7 = np.maximum(0.0, t6)
    t8 = m3 * p0
    t9 = np.maximum(0.0, -t8)
    t10 = np.copysign(t8, 1)
    t11 = np.where(t9 != 0.0, t10, 0.0)
    t12 = np.arctan2(np.sqrt(t4), np.sqrt((t7 + t11)))
    t13 = np.arctan2(np.sqrt((t4 + t7)), np.sqrt(t11))
    t14 = m1 * p0
    t15 = np.copysign(t14, 1) * (1 - np.where(np.maximum(0.0, -t14) != 0.0, 1, 0.0))
    t16 = np.minimum(np.minimum(np.minimum((l2 * t5), m0 * p1), p3 * p2), r * (4 * l3))
    t17 = np.maximum(0.0, t16)
    t18 = -(m2 * m3)
    t19 = np.copysign(t18, 1) * (1 - np.where(np.maximum(0.0, t18) != 0.0, 1, 0.0))
    t20 = np.arctan2(np.sqrt(t15), np.sqrt((t17 + t19)))
    t21 = np.arctan2(np.sqrt((t15 + t17)), np.sqrt(t19))
    t22 = t10 * (1 - np.where(t9 != 0.0, 1, 0.0))
    t23 = t3 * (1 - np.where(t2 != 0.0, 1, 0.0))
    t24 = np.arctan2(np.sqrt(t22), np.sqrt((t7 + t23)))
    t25 = np.arctan2(np.sqrt((t7 + t22)), np.sqrt(t23))

    # results
    extremes = np.empty((*_leading, 6), _real)
    extremes[..., 0] = t12 + t12
    extremes[..., 1] = t13 + t13
    extremes[..., 2] = t20 + t20
    extremes[..., 3] = t21 + t21
    extremes[..., 4] = t24 + t24
    extremes[..., 5] = t25 + t25
    return extremes.reshape(_leading + (3, 2))


def self_motion_stops_position(stops, reach, parameters):
    """both configurations in which each joint has a given value, and the radicands, negative where there are none: 87 operations.

    in   stops[3] = (v1, v2, v3)
    in   reach[1] = (r)
    in   parameters[3] = (l1, l2, l3)
    out  q[6][3]
    out  radicands[3]
    """
    stops = np.asarray(stops)
    reach = np.asarray(reach)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(stops.shape[:-1], reach.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(stops, reach, parameters, np.float32)

    # inputs, sines and cosines
    v1 = stops[..., 0]
    l1 = parameters[..., 0]
    sin_v1 = np.sin(v1)
    r = reach[..., 0]
    cos_v1 = np.cos(v1)
    l2 = parameters[..., 1]
    l3 = parameters[..., 2]
    v2 = stops[..., 1]
    cos_v2 = np.cos(v2)
    sin_v2 = np.sin(v2)
    v3 = stops[..., 2]
    cos_v3 = np.cos(v3)
    sin_v3 = np.sin(v3)

    # terms
    t1 = l1 * sin_v1
    t2 = -t1
    t3 = r - l1 * cos_v1
    t4 = np.arctan2(np.where(t2 != 0.0, t2, 0.0), t3)
    t5 = l2 * l2
    t6 = l3 * l3
    t7 = t3 * t3 + t1 * t1 - t5 - t6
    t8 = 4 * t5 * t6 - t7 * t7
    t9 = np.sqrt(np.maximum(0.0, t8))
    t10 = np.arctan2(t9, t7 + (t5 + t5))
    t11 = np.arctan2(t9, t7)
    t12 = l1 + l2 * cos_v2
    t13 = l2 * sin_v2
    t14 = t12 * t12 + t13 * t13
    t15 = r * r
    t16 = t15 - t14 - t6
    t17 = t6 * (4 * t14) - t16 * t16
    t18 = np.sqrt(np.maximum(0.0, t17))
    t19 = np.arctan2(t18, t16 + (t14 + t14))
    t20 = np.arctan2(np.where(t13 != 0.0, t13, 0.0), t12)
    t21 = np.arctan2(t18, t16)
    t22 = l2 + l3 * cos_v3
    t23 = l3 * sin_v3
    t24 = t22 * t22 + t23 * t23
    t25 = l1 * l1
    t26 = t15 - t24 - t25
    t27 = 4 * t24 * t25 - t26 * t26
    t28 = np.sqrt(np.maximum(0.0, t27))
    t29 = np.arctan2(t28, t26 + (t25 + t25))
    t30 = np.arctan2(t28, t26)
    t31 = np.arctan2(np.where(t23 != 0.0, t23, 0.0), t22)

    # results
    q = np.empty((*_leading, 18), _real)
    radicands = np.empty((*_leading, 3), _real)
    q[..., 0] = v1
    q[..., 1] = t4 - t10 - v1
    q[..., 2] = t11
    q[..., 3] = v1
    q[..., 4] = t4 + t10 - v1
    q[..., 5] = -t11
    q[..., 6] = -(t19 + t20)
    q[..., 7] = v2
    q[..., 8] = t20 + t21 - v2
    q[..., 9] = t19 - t20
    q[..., 10] = v2
    q[..., 11] = t20 - t21 - v2
    q[..., 12] = -t29
    q[..., 13] = t30 - t31
    q[..., 14] = v3
    q[..., 15] = t29
    q[..., 16] = -(t30 + t31)
    q[..., 17] = v3
    radicands[..., 0] = t8
    radicands[..., 1] = t17
    radicands[..., 2] = t27
    return q.reshape(_leading + (6, 3)), radicands.reshape(_leading + (3,))


def self_motion_gaps_x_alpha(reach, sums, parameters):
    """differences a - b, b - c, c - d of the sorted roots, and whether b is A and c is B: 12 operations.

    in   reach[1] = (r)
    in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
    in   parameters[3] = (l1, l2, l3)
    out  gaps[3]
    out  pattern[2]
    """
    reach = np.asarray(reach)
    sums = np.asarray(sums)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(reach.shape[:-1], sums.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(reach, sums, parameters, np.float32)

    # inputs, sines and cosines
    m2 = sums[..., 2]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    m0 = sums[..., 0]
    p0 = sums[..., 4]
    m3 = sums[..., 3]

    # terms

    # results
    gaps = np.empty((*_leading, 3), _real)
    pattern = np.empty((*_leading, 2), _real)
    gaps[..., 0] = np.copysign(m2, 1)
    gaps[..., 1] = np.minimum(np.minimum(np.minimum((l1 + l1), l2 + l2), m0), p0)
    gaps[..., 2] = np.copysign(m3, 1)
    pattern[..., 0] = np.where(np.maximum(0.0, -m2) != 0.0, 1, 0.0)
    pattern[..., 1] = np.where(np.maximum(0.0, m3) != 0.0, 1, 0.0)
    return gaps.reshape(_leading + (3,)), pattern.reshape(_leading + (2,))


def self_motion_speed_x_alpha(node, reach, sums, parameters):
    """ds/d theta of the self-motion, theta uniform in the elliptic parameter: 244 operations.

    in   node[2] = (ct, st)
    in   reach[1] = (r)
    in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
    in   parameters[3] = (l1, l2, l3)
    out  speed (one number)
    """
    node = np.asarray(node)
    reach = np.asarray(reach)
    sums = np.asarray(sums)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(node.shape[:-1], reach.shape[:-1], sums.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(node, reach, sums, parameters, np.float32)

    # inputs, sines and cosines
    m3 = sums[..., 3]
    ct = node[..., 0]
    m2 = sums[..., 2]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    m0 = sums[..., 0]
    p0 = sums[..., 4]
    st = node[..., 1]

    # terms
    t1 = np.maximum(0.0, m3)
    t2 = np.copysign(m2, 1)
    t3 = np.copysign(m3, 1)
    t4 = np.sqrt((t2 * t3))
    t5 = np.maximum(0.0, np.minimum(np.minimum(np.minimum((l1 + l1), l2 + l2), m0), p0))
    t6 = t2 + t5
    t7 = np.sqrt((t6 * (t3 + t5)))
    t8 = np.sqrt((t4 * t7))
    t9 = 0.5 * t4 + 0.5 * t7
    t10 = np.sqrt((t8 * t9))
    t11 = 0.5 * t8 + 0.5 * t9
    t12 = np.sqrt((t10 * t11))
    t13 = 0.5 * t10 + 0.5 * t11
    t14 = np.sqrt((t12 * t13))
    t15 = 0.5 * t12 + 0.5 * t13
    t16 = np.sqrt((t14 * t15))
    t17 = 0.5 * t14 + 0.5 * t15
    t18 = np.sqrt((t16 * t17))
    t19 = 0.5 * t16 + 0.5 * t17
    t20 = np.sqrt((t18 * t19))
    t21 = 0.5 * t18 + 0.5 * t19
    t22 = np.sqrt((t20 * t21))
    t23 = 0.5 * t20 + 0.5 * t21
    t24 = 0.5 * t22 + 0.5 * t23
    t25 = ct * t24
    t26 = ct * t25
    t27 = st * st
    t28 = t26 + t23 * t27
    t29 = np.where(t28 != 0.0, 1, 0.0)
    t30 = t25 * ((t26 + t22 * t27) * (t29 / (t28 + (1 - t29))))
    t31 = np.where(t23 != 0.0, 1, 0.0)
    t32 = t25 * (t25 * (t31 / (t23 + (1 - t31))))
    t33 = t32 + t21 * t27
    t34 = np.where(t33 != 0.0, 1, 0.0)
    t35 = t30 * ((t32 + t20 * t27) * (t34 / (t33 + (1 - t34))))
    t36 = np.where(t21 != 0.0, 1, 0.0)
    t37 = t30 * (t30 * (t36 / (t21 + (1 - t36))))
    t38 = t37 + t19 * t27
    t39 = np.where(t38 != 0.0, 1, 0.0)
    t40 = t35 * ((t37 + t18 * t27) * (t39 / (t38 + (1 - t39))))
    t41 = np.where(t19 != 0.0, 1, 0.0)
    t42 = t35 * (t35 * (t41 / (t19 + (1 - t41))))
    t43 = t42 + t17 * t27
    t44 = np.where(t43 != 0.0, 1, 0.0)
    t45 = t40 * ((t42 + t16 * t27) * (t44 / (t43 + (1 - t44))))
    t46 = np.where(t17 != 0.0, 1, 0.0)
    t47 = t40 * (t40 * (t46 / (t17 + (1 - t46))))
    t48 = t47 + t15 * t27
    t49 = np.where(t48 != 0.0, 1, 0.0)
    t50 = t45 * ((t47 + t14 * t27) * (t49 / (t48 + (1 - t49))))
    t51 = np.where(t15 != 0.0, 1, 0.0)
    t52 = t45 * (t45 * (t51 / (t15 + (1 - t51))))
    t53 = t52 + t13 * t27
    t54 = np.where(t53 != 0.0, 1, 0.0)
    t55 = t50 * ((t52 + t12 * t27) * (t54 / (t53 + (1 - t54))))
    t56 = np.where(t13 != 0.0, 1, 0.0)
    t57 = t50 * (t50 * (t56 / (t13 + (1 - t56))))
    t58 = t57 + t11 * t27
    t59 = np.where(t58 != 0.0, 1, 0.0)
    t60 = t55 * ((t57 + t10 * t27) * (t59 / (t58 + (1 - t59))))
    t61 = np.where(t11 != 0.0, 1, 0.0)
    t62 = t55 * (t55 * (t61 / (t11 + (1 - t61))))
    t63 = t62 + t9 * t27
    t64 = np.where(t63 != 0.0, 1, 0.0)
    t65 = t60 * ((t62 + t8 * t27) * (t64 / (t63 + (1 - t64))))
    t66 = np.where(t7 != 0.0, 1, 0.0)
    t67 = t65 * (t66 / (t7 + (1 - t66))) * np.sqrt(t6)
    t68 = st * np.sqrt(t2)
    t69 = np.sqrt((t67 * t67 + t68 * t68))
    t70 = np.where(t69 != 0.0, 1, 0.0)
    t71 = t70 / (t69 + (1 - t70))
    t72 = np.sqrt(t5)
    t73 = t67 * t71 * t72
    t74 = 1 - np.where(t1 != 0.0, 1, 0.0)
    t75 = np.sqrt((t3 + t73 * t73))
    t76 = np.maximum(0.0, -m2)
    t77 = 1 - np.where(t76 != 0.0, 1, 0.0)
    t78 = t72 * (t68 * t71)
    t79 = np.sqrt((t2 + t78 * t78))
    t80 = (np.where(t1 != 0.0, t73, 0.0) + t74 * t75) * (t77 * t79 + np.where(t76 != 0.0, t78, 0.0))
    t81 = (np.where(t1 != 0.0, t75, 0.0) + t73 * t74) * (t77 * t78 + np.where(t76 != 0.0, t79, 0.0))
    t82 = t80 + t81
    t83 = np.where(t24 != 0.0, 1, 0.0)
    t84 = t83 / (t24 + (1 - t83))
    t85 = np.sqrt((t82 * t82 + t80 * t80 + t81 * t81)) * (t84 + t84)

    # results
    speed = np.empty((*_leading, 1), _real)
    speed[..., 0] = t85
    return speed.reshape(_leading)


def self_motion_turn_x_alpha(node, reach, sums, parameters):
    """cosine and sine of phi at a point theta of the elliptic parameter: 201 operations.

    in   node[2] = (ct, st)
    in   reach[1] = (r)
    in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
    in   parameters[3] = (l1, l2, l3)
    out  phi[2]
    """
    node = np.asarray(node)
    reach = np.asarray(reach)
    sums = np.asarray(sums)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(node.shape[:-1], reach.shape[:-1], sums.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(node, reach, sums, parameters, np.float32)

    # inputs, sines and cosines
    ct = node[..., 0]
    m2 = sums[..., 2]
    m3 = sums[..., 3]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    m0 = sums[..., 0]
    p0 = sums[..., 4]
    st = node[..., 1]

    # terms
    t1 = np.copysign(m2, 1)
    t2 = np.copysign(m3, 1)
    t3 = np.sqrt((t1 * t2))
    t4 = np.maximum(0.0, np.minimum(np.minimum(np.minimum((l1 + l1), l2 + l2), m0), p0))
    t5 = t1 + t4
    t6 = np.sqrt((t5 * (t2 + t4)))
    t7 = np.sqrt((t3 * t6))
    t8 = 0.5 * t3 + 0.5 * t6
    t9 = np.sqrt((t7 * t8))
    t10 = 0.5 * t7 + 0.5 * t8
    t11 = np.sqrt((t9 * t10))
    t12 = 0.5 * t9 + 0.5 * t10
    t13 = np.sqrt((t11 * t12))
    t14 = 0.5 * t11 + 0.5 * t12
    t15 = np.sqrt((t13 * t14))
    t16 = 0.5 * t13 + 0.5 * t14
    t17 = np.sqrt((t15 * t16))
    t18 = 0.5 * t15 + 0.5 * t16
    t19 = np.sqrt((t17 * t18))
    t20 = 0.5 * t17 + 0.5 * t18
    t21 = np.sqrt((t19 * t20))
    t22 = 0.5 * t19 + 0.5 * t20
    t23 = ct * (0.5 * t21 + 0.5 * t22)
    t24 = ct * t23
    t25 = st * st
    t26 = t24 + t22 * t25
    t27 = np.where(t26 != 0.0, 1, 0.0)
    t28 = t23 * ((t24 + t21 * t25) * (t27 / (t26 + (1 - t27))))
    t29 = np.where(t22 != 0.0, 1, 0.0)
    t30 = t23 * (t23 * (t29 / (t22 + (1 - t29))))
    t31 = t30 + t20 * t25
    t32 = np.where(t31 != 0.0, 1, 0.0)
    t33 = t28 * ((t30 + t19 * t25) * (t32 / (t31 + (1 - t32))))
    t34 = np.where(t20 != 0.0, 1, 0.0)
    t35 = t28 * (t28 * (t34 / (t20 + (1 - t34))))
    t36 = t35 + t18 * t25
    t37 = np.where(t36 != 0.0, 1, 0.0)
    t38 = t33 * ((t35 + t17 * t25) * (t37 / (t36 + (1 - t37))))
    t39 = np.where(t18 != 0.0, 1, 0.0)
    t40 = t33 * (t33 * (t39 / (t18 + (1 - t39))))
    t41 = t40 + t16 * t25
    t42 = np.where(t41 != 0.0, 1, 0.0)
    t43 = t38 * ((t40 + t15 * t25) * (t42 / (t41 + (1 - t42))))
    t44 = np.where(t16 != 0.0, 1, 0.0)
    t45 = t38 * (t38 * (t44 / (t16 + (1 - t44))))
    t46 = t45 + t14 * t25
    t47 = np.where(t46 != 0.0, 1, 0.0)
    t48 = t43 * ((t45 + t13 * t25) * (t47 / (t46 + (1 - t47))))
    t49 = np.where(t14 != 0.0, 1, 0.0)
    t50 = t43 * (t43 * (t49 / (t14 + (1 - t49))))
    t51 = t50 + t12 * t25
    t52 = np.where(t51 != 0.0, 1, 0.0)
    t53 = t48 * ((t50 + t11 * t25) * (t52 / (t51 + (1 - t52))))
    t54 = np.where(t12 != 0.0, 1, 0.0)
    t55 = t48 * (t48 * (t54 / (t12 + (1 - t54))))
    t56 = t55 + t10 * t25
    t57 = np.where(t56 != 0.0, 1, 0.0)
    t58 = t53 * ((t55 + t9 * t25) * (t57 / (t56 + (1 - t57))))
    t59 = np.where(t10 != 0.0, 1, 0.0)
    t60 = t53 * (t53 * (t59 / (t10 + (1 - t59))))
    t61 = t60 + t8 * t25
    t62 = np.where(t61 != 0.0, 1, 0.0)
    t63 = t58 * ((t60 + t7 * t25) * (t62 / (t61 + (1 - t62))))
    t64 = np.where(t6 != 0.0, 1, 0.0)
    t65 = t63 * (t64 / (t6 + (1 - t64))) * np.sqrt(t5)
    t66 = st * np.sqrt(t1)
    t67 = np.sqrt((t65 * t65 + t66 * t66))
    t68 = np.where(t67 != 0.0, 1, 0.0)
    t69 = t68 / (t67 + (1 - t68))

    # results
    phi = np.empty((*_leading, 2), _real)
    phi[..., 0] = t65 * t69
    phi[..., 1] = t66 * t69
    return phi.reshape(_leading + (2,))


def self_motion_point_x_alpha(turn, reach, sums, parameters):
    """joint values, their rates dq/dw, H and ds/d phi at a point phi of the self-motion: 70 operations.

    in   turn[2] = (cp, sp)
    in   reach[1] = (r)
    in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
    in   parameters[3] = (l1, l2, l3)
    out  q[3]
    out  rates[3]
    out  manipulability (one number)
    out  speed (one number)
    """
    turn = np.asarray(turn)
    reach = np.asarray(reach)
    sums = np.asarray(sums)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(turn.shape[:-1], reach.shape[:-1], sums.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(turn, reach, sums, parameters, np.float32)

    # inputs, sines and cosines
    m3 = sums[..., 3]
    cp = turn[..., 0]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    m0 = sums[..., 0]
    p0 = sums[..., 4]
    m2 = sums[..., 2]
    sp = turn[..., 1]

    # terms
    t1 = np.maximum(0.0, m3)
    t2 = np.sqrt(np.maximum(0.0, np.minimum(np.minimum(np.minimum((l1 + l1), l2 + l2), m0), p0)))
    t3 = cp * t2
    t4 = 1 - np.where(t1 != 0.0, 1, 0.0)
    t5 = np.sqrt((np.copysign(m3, 1) + t3 * t3))
    t6 = np.where(t1 != 0.0, t3, 0.0) + t4 * t5
    t7 = np.maximum(0.0, -m2)
    t8 = 1 - np.where(t7 != 0.0, 1, 0.0)
    t9 = t2 * sp
    t10 = np.sqrt((np.copysign(m2, 1) + t9 * t9))
    t11 = t6 * (t8 * t10 + np.where(t7 != 0.0, t9, 0.0))
    t12 = t6 * t6 - l1
    t13 = t8 * t9 + np.where(t7 != 0.0, t10, 0.0)
    t14 = (np.where(t1 != 0.0, t5, 0.0) + t3 * t4) * t13
    t15 = t13 * t13 - l2
    t16 = t12 * t14 - t11 * t15
    t17 = t11 + t14
    t18 = np.sqrt((t17 * t17 + t11 * t11 + t14 * t14))
    t19 = t5 * t10
    t20 = np.where(t19 != 0.0, 1, 0.0)

    # results
    q = np.empty((*_leading, 3), _real)
    rates = np.empty((*_leading, 3), _real)
    manipulability = np.empty((*_leading, 1), _real)
    speed = np.empty((*_leading, 1), _real)
    q[..., 0] = np.arctan2(np.where(t11 != 0.0, t11, 0.0), t12)
    q[..., 1] = np.arctan2(np.where(t16 != 0.0, t16, 0.0), t12 * t15 + t11 * t14)
    q[..., 2] = -np.arctan2(np.where(t14 != 0.0, t14, 0.0), t15)
    rates[..., 0] = t14
    rates[..., 1] = -t17
    rates[..., 2] = t11
    manipulability[..., 0] = t18
    speed[..., 0] = (t18 + t18) * (t20 / (t19 + (1 - t20)))
    return q.reshape(_leading + (3,)), rates.reshape(_leading + (3,)), manipulability.reshape(_leading), speed.reshape(_leading)


def self_motion_phase_x_alpha(halves, reach, sums, parameters):
    """sqrt(x - c) and sqrt(b - x), with the signs of cos phi and sin phi, of a configuration: 35 operations.

    in   halves[2] = (h1, h2)
    in   reach[1] = (r)
    in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
    in   parameters[3] = (l1, l2, l3)
    out  phase[2]
    """
    halves = np.asarray(halves)
    reach = np.asarray(reach)
    sums = np.asarray(sums)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(halves.shape[:-1], reach.shape[:-1], sums.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(halves, reach, sums, parameters, np.float32)

    # inputs, sines and cosines
    l2 = parameters[..., 1]
    h2 = halves[..., 1]
    sin_h2 = np.sin(h2)
    m3 = sums[..., 3]
    m2 = sums[..., 2]
    l1 = parameters[..., 0]
    h1 = halves[..., 0]
    cos_h1 = np.cos(h1)
    sin_h1 = np.sin(h1)
    cos_h2 = np.cos(h2)

    # terms
    t1 = np.sqrt(np.maximum(0.0, l2 + l2))
    t2 = t1 * sin_h2
    t3 = np.maximum(0.0, m3)
    t4 = 1 - np.where(t3 != 0.0, 1, 0.0)
    t5 = np.maximum(0.0, -m2)
    t6 = np.sqrt(np.maximum(0.0, l1 + l1))
    t7 = t6 * cos_h1
    t8 = 1 - np.where(t5 != 0.0, 1, 0.0)
    t9 = t6 * sin_h1
    t10 = t2 * t4 + np.where(t3 != 0.0, np.where(t5 != 0.0, t7, 0.0) + t8 * np.copysign(t7, t9), 0.0)
    t11 = t1 * cos_h2
    t12 = t8 * (np.where(t3 != 0.0, np.copysign(t11, t2), 0.0) + t4 * t11) + np.where(t5 != 0.0, t9, 0.0)

    # results
    phase = np.empty((*_leading, 2), _real)
    phase[..., 0] = t10
    phase[..., 1] = t12
    return phase.reshape(_leading + (2,))


def self_motion_extremes_x_alpha(reach, sums, parameters):
    """least and greatest absolute angle of each joint along the self-motion: 48 operations.

    in   reach[1] = (r)
    in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
    in   parameters[3] = (l1, l2, l3)
    out  extremes[3][2]
    """
    reach = np.asarray(reach)
    sums = np.asarray(sums)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(reach.shape[:-1], sums.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(reach, sums, parameters, np.float32)

    # inputs, sines and cosines
    m2 = sums[..., 2]
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    m0 = sums[..., 0]
    p0 = sums[..., 4]
    m3 = sums[..., 3]
    p2 = sums[..., 6]

    # terms
    t1 = np.copysign(m2, 1)
    t2 = np.maximum(0.0, -m2)
    t3 = t1 * (1 - np.where(t2 != 0.0, 1, 0.0))
    t4 = np.maximum(0.0, np.minimum(np.minimum(np.minimum((l1 + l1), l2 + l2), m0), p0))
    t5 = np.copysign(m3, 1)
    t6 = np.maximum(0.0, m3)
    t7 = t5 * (1 - np.where(t6 != 0.0, 1, 0.0))
    t8 = np.arctan2(np.sqrt(t3), np.sqrt((t4 + t7)))
    t9 = np.arctan2(np.sqrt((t3 + t4)), np.sqrt(t7))
    t10 = np.arctan2(np.sqrt(np.maximum(0.0, m0 * p0)), np.sqrt(np.maximum(0.0, -(m2 * p2))))
    t11 = np.where(t6 != 0.0, t5, 0.0)
    t12 = np.where(t2 != 0.0, t1, 0.0)
    t13 = np.arctan2(np.sqrt(t11), np.sqrt((t4 + t12)))
    t14 = np.arctan2(np.sqrt((t4 + t11)), np.sqrt(t12))

    # results
    extremes = np.empty((*_leading, 6), _real)
    extremes[..., 0] = t8 + t8
    extremes[..., 1] = t9 + t9
    extremes[..., 2] = 0.0
    extremes[..., 3] = t10 + t10
    extremes[..., 4] = t13 + t13
    extremes[..., 5] = t14 + t14
    return extremes.reshape(_leading + (3, 2))


def self_motion_stops_x_alpha(stops, reach, parameters):
    """both configurations in which each joint has a given value, and the radicands, negative where there are none: 47 operations.

    in   stops[3] = (v1, v2, v3)
    in   reach[1] = (r)
    in   parameters[3] = (l1, l2, l3)
    out  q[6][3]
    out  radicands[3]
    """
    stops = np.asarray(stops)
    reach = np.asarray(reach)
    parameters = np.asarray(parameters)
    _leading = np.broadcast_shapes(stops.shape[:-1], reach.shape[:-1], parameters.shape[:-1])
    _real = np.result_type(stops, reach, parameters, np.float32)

    # inputs, sines and cosines
    v1 = stops[..., 0]
    r = reach[..., 0]
    cos_v1 = np.cos(v1)
    l1 = parameters[..., 0]
    l2 = parameters[..., 1]
    v2 = stops[..., 1]
    cos_v2 = np.cos(v2)
    sin_v2 = np.sin(v2)
    v3 = stops[..., 2]
    cos_v3 = np.cos(v3)

    # terms
    t1 = r - cos_v1 * l1
    t2 = (t1 + l2) * (l2 - t1)
    t3 = np.arctan2(np.sqrt(np.maximum(0.0, t2)), t1)
    t4 = l1 + l2 * cos_v2
    t5 = l2 * sin_v2
    t6 = t4 * t4 + t5 * t5 - r * r
    t7 = np.arctan2(np.sqrt(np.maximum(0.0, t6)), r)
    t8 = np.arctan2(np.where(t5 != 0.0, t5, 0.0), t4)
    t9 = t7 + t8
    t10 = r - l2 * cos_v3
    t11 = (l1 + t10) * (l1 - t10)
    t12 = np.arctan2(np.sqrt(np.maximum(0.0, t11)), t10)

    # results
    q = np.empty((*_leading, 18), _real)
    radicands = np.empty((*_leading, 3), _real)
    q[..., 0] = v1
    q[..., 1] = t3 - v1
    q[..., 2] = -t3
    q[..., 3] = v1
    q[..., 4] = -(v1 + t3)
    q[..., 5] = t3
    q[..., 6] = t7 - t8
    q[..., 7] = v2
    q[..., 8] = t8 - t7 - v2
    q[..., 9] = -t9
    q[..., 10] = v2
    q[..., 11] = t9 - v2
    q[..., 12] = t12
    q[..., 13] = -(v3 + t12)
    q[..., 14] = v3
    q[..., 15] = -t12
    q[..., 16] = t12 - v3
    q[..., 17] = v3
    radicands[..., 0] = t2
    radicands[..., 1] = t6
    radicands[..., 2] = t11
    return q.reshape(_leading + (6, 3)), radicands.reshape(_leading + (3,))
