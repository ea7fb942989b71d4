"""rest to rest of motion, in NumPy.

Made from templates/kernel.py.j2; inputs 71046b4df1d46617806e256601539406ec872670a5c40f2ec7ca65610b5bc45d.
56 operations. Do not edit: change the derivation and regenerate.

SI units and radians. Inputs have their own axes last; leading axes broadcast. Results keep the inputs' precision.
"""

import numpy as np


def rest_to_rest(move):
    """peak speed, ramp, cruise and duration of the fastest move from rest to rest: 11 operations.

    in   move[3] = (distance, velocity, acceleration)
    out  profile[4]
    """
    move = np.asarray(move)
    _leading = np.broadcast_shapes(move.shape[:-1])
    _real = np.result_type(move, np.float32)

    # inputs, sines and cosines
    velocity = move[..., 1]
    acceleration = move[..., 2]
    distance = move[..., 0]

    # terms
    t1 = np.minimum(velocity, np.sqrt(acceleration) * np.sqrt(distance))
    t2 = t1 / acceleration
    t3 = np.maximum(0.0, distance / velocity - velocity / acceleration)

    # results
    profile = np.empty((*_leading, 4), _real)
    profile[..., 0] = t1
    profile[..., 1] = t2
    profile[..., 2] = t3
    profile[..., 3] = t3 + (t2 + t2)
    return profile.reshape(_leading + (4,))


def rest_to_rest_in(move):
    """peak speed, ramp and cruise of a move from rest to rest in a given time, with the acceleration given: 19 operations.

    in   move[3] = (distance, acceleration, duration)
    out  profile[4]
    """
    move = np.asarray(move)
    _leading = np.broadcast_shapes(move.shape[:-1])
    _real = np.result_type(move, np.float32)

    # inputs, sines and cosines
    distance = move[..., 0]
    duration = move[..., 2]
    acceleration = move[..., 1]

    # terms
    t1 = np.sqrt(distance)
    t2 = (t1 + t1) / np.sqrt(acceleration)
    t3 = np.sqrt(np.maximum(0.0, duration - t2)) * np.sqrt((duration + t2))
    t4 = 0.5 * duration + 0.5 * t3
    t5 = np.where(t4 != 0.0, 1, 0.0)
    t6 = distance * (t5 / (t4 + (1 - t5)))

    # results
    profile = np.empty((*_leading, 4), _real)
    profile[..., 0] = t6
    profile[..., 1] = t6 / acceleration
    profile[..., 2] = t3
    profile[..., 3] = duration
    return profile.reshape(_leading + (4,))


def rest_to_rest_state(instant):
    """distance and speed at a time of a move from rest to rest: 26 operations.

    in   instant[4] = (peak, ramp, cruise, time)
    out  state[2]
    """
    instant = np.asarray(instant)
    _leading = np.broadcast_shapes(instant.shape[:-1])
    _real = np.result_type(instant, np.float32)

    # inputs, sines and cosines
    ramp = instant[..., 1]
    time = instant[..., 3]
    cruise = instant[..., 2]
    peak = instant[..., 0]

    # terms
    t1 = np.maximum(0.0, np.minimum(ramp, time - cruise - ramp))
    t2 = np.where(ramp != 0.0, 1, 0.0)
    t3 = peak * (t2 / (ramp + (1 - t2)))
    t4 = t1 * (peak - 0.5 * t1 * t3) + peak * np.maximum(0.0, np.minimum(cruise, time - ramp))
    t5 = np.maximum(0.0, np.minimum(ramp, time))

    # results
    state = np.empty((*_leading, 2), _real)
    state[..., 0] = t4 + t5 * (0.5 * (t3 * t5))
    state[..., 1] = t3 * (t5 - t1)
    return state.reshape(_leading + (2,))
