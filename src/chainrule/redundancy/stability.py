"""How large a null-space gain may be for the step: an estimate, from differences of the generated gradient.

Along the self-motion through a configuration the law moves by N g(q), N the projector and g the sum of gain times
gradient. With Z an orthonormal basis of the null space, D = Z^T d(N g)/dq Z says how a small displacement there grows
or dies: at a posture that is optimal for its target D is gain times the criterion's Hessian on the self-motion. An
explicit step of length dt multiplies it by 1 + dt D (Euler), so it dies only while dt |mu| < 2 for the eigenvalues
mu < 0 of D: the gain must stay below 2 / (dt rho), rho the largest -mu of a unit gain.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.redundancy.result import Event
from chainrule.redundancy.step import Law, Stepper

Array = NDArray[Any]

#: The largest dt |mu| at which a decaying mode still decays; dop853 chooses its own steps.
STABLE = {"euler": 2.0, "heun": 2.0, "rk4": 2.785}
#: Displacement of the central differences, rad or m; the gradient itself is exact.
DISPLACED = 1e-6
#: Samples of a run that are looked at, at most.
LOOKED_AT = 400


def decay(stepper: Stepper, q: Array, held: Array) -> Array:
    """The fastest decay rate (k,), 1/s, of a displacement along the self-motion under the law: the largest -mu, or 0.

    Args:
        stepper: of one law.
        q: (k, n).
        held: (k, ...) targets, which play no part but for their shape.

    Example:
        >>> import chainrule as cr
        >>> from chainrule.redundancy.step import Law
        >>> arm = cr.planar_3r(1.0, 0.5, 0.25)
        >>> best = cr.best_posture(arm, [1.0, 0.0]).q[None]
        >>> one, two = (decay(Stepper(arm, Law({"H": k})), best, np.zeros((1, 2))) for k in (1.0, 2.0))
        >>> bool(one > 0.0), bool(abs(two / one - 2.0) < 1e-6)     # proportional to the gain
        (True, True)
    """
    arm, m = stepper.arm, stepper.arm.tasks[stepper.task]
    spare = arm.n - m
    if not spare or not len(q):
        return np.zeros(len(q))
    basis = np.linalg.svd(arm.jacobian(q, task=stepper.task))[2][:, m:]  # (k, spare, n), rows orthonormal
    moved = DISPLACED * basis
    ahead, behind = (stepper(q[:, None] + s * moved, held[:, None], None, 0.0).null_motion for s in (1.0, -1.0))
    change = (ahead - behind) / (2.0 * DISPLACED)
    matrix = change @ np.swapaxes(basis, 1, 2)
    usable = np.isfinite(matrix).all(axis=(1, 2))
    found = np.zeros(len(q))
    found[usable] = np.maximum(-np.linalg.eigvals(matrix[usable]).real.min(axis=1), 0.0)
    return found


def gain_event(stepper: Stepper, integrator: str, dt: float, t: Array, q: Array, held: Array) -> list[Event]:
    """The event "gain too large" at the first sample where the estimate says so; none where it never does."""
    bound = STABLE.get(integrator)
    law = stepper.law
    if bound is None or isinstance(law, tuple) or not any(law.gains.values()):
        return []
    chosen = np.unique(np.linspace(0, len(t) - 1, min(len(t), LOOKED_AT)).astype(int))
    share = dt * decay(stepper, q[chosen], held[chosen]) / bound
    beyond = np.flatnonzero(share > 1.0)
    if not len(beyond):
        return []
    first = int(beyond[0])
    allowed = ", ".join(f"{gain / share[first]:.3g} for {name}" for name, gain in law.gains.items() if gain)
    text = (
        f"estimated bound {bound:g} / (dt rho): {allowed}; given is {share[first]:.3g} times as much for steps of "
        f"{dt:.3g} s (at worst {share.max():.3g} times, at {t[chosen[int(share.argmax())]]:.4g} s)"
    )
    return [Event(float(t[chosen[first]]), "gain too large", text)]


def feedback_event(law: Law, integrator: str, dt: float) -> list[Event]:
    """The event "gain too large" for feedback that the steps do not bear; none where they do."""
    largest, bound = max(law.feedback), STABLE.get(integrator, np.inf)
    if largest * dt <= bound:
        return []
    text = f"feedback of {largest:.4g} 1/s is unstable for steps of {dt:.3g} s; up to {bound / dt:.4g} is stable"
    return [Event(0.0, "gain too large", text)]
