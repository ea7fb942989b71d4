"""Speed ratios: what the spare joint of a planar arm is good for when the tip follows a path.

With three joints in constant ratio the tip leaves along a tangent T on a path whose curvature can be chosen too
(Ambike, Schmiedeler and Stanisic, equations (3) to (9)). The formulas are derived and proved in
:mod:`chainrule.derive.speed_ratio`; here their generated functions answer for one configuration or for many.

Signed curvature: a left turn is positive. Rates are those of a tip speed of 1 m/s, so that time is the path length.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from enum import IntEnum
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.description import Planar
from chainrule.errors import InputError, shown
from chainrule.tables import Cell, Column, Table, joint_unit

Array = NDArray[Any]
Leading = int | Literal["auto"]


class Status(IntEnum):
    """What became of the desired curvature."""

    EXACT = 0
    NEAREST = 1
    FIXED = 2
    ONE_AT_INFINITY = 3
    SINGULAR = 4


#: What each status means.
REASONS: dict[Status, str] = {
    Status.EXACT: "the curvature is met exactly, by two solutions, or by one where both are the same",
    Status.NEAREST: "the discriminant is negative: the nearest reachable curvature, -D/C, is tracked",
    Status.FIXED: "nothing the spare joint does changes the curvature (C = D = 0): the pseudoinverse's rates are given",
    Status.ONE_AT_INFINITY: "one solution meets the curvature (C = 0); in the other the tip stands still",
    Status.SINGULAR: "the Jacobian has lost rank: the rates along the tangent do not exist, or are not one family",
}

#: A joint that makes less than this part of the fastest joint's rate counts as standing still.
STANDSTILL = 2.0**-40

#: So many configurations are solved at once that what is not kept of them stays in the processor's cache.
BLOCK = 4096

_OTHERS = np.array([[1, 2], [0, 2], [0, 1]])
_ONE = np.eye(3)  # row k says that joint k + 1 leads
_SOLUTION = np.dtype((np.void, 7 * 8))  # a solution's rates, ratios, curvature and its rate
_NOTHING = np.full(7, np.nan).view(_SOLUTION)[0]
_FAMILY = ("parabola", "least", "null")
_TERMS = ("A", "B", "B0", "B1", "a", "b", "C", "D", "discriminant")


@dataclass(frozen=True, eq=False)
class SpeedRatios:
    """Joint rates in constant ratio that follow a tangent and a curvature.

    For one configuration, arrays hold the k solutions that exist: 2, 1 (one solution, or the best possible) or 0. With
    leading axes (...) they always hold 2, and what does not exist is nan; ``count`` says how many there are. Lengths
    are in m, so curvatures are in 1/m and their rates in 1/m^2; a joint's rate is in rad or m for each m of path.

    Attributes:
        q: (..., 3) the configurations.
        direction: (..., 2) the direction of motion as it was given.
        desired: (...,) the curvature asked for; left turns are positive.
        desired_rate: (...,) its rate of change asked for, dk/ds.
        status: (...,) :class:`Status`; :data:`REASONS` says what each means.
        count: (...,) number of solutions.
        exact: (...,) whether the desired curvature is met.
        leading: (...,) the leading joint, from 1. Another one than asked for where that one stands still.
        rates: (..., k, 3) the solutions at unit tip speed, the one nearer to the pseudoinverse's first.
        ratios: (..., k, 2) rates of the other two joints, in their order, divided by the leading joint's.
        curvatures: (..., k) the curvature of the path that each solution makes at constant rates.
        curvature_rates: (..., k) the rate of change dk/ds of that curvature.
        chosen: (...,) which solution to use (from 0; -1 if there is none): the one whose dk/ds is nearer to the
            desired one.
    """

    q: Array
    direction: Array
    desired: Any
    desired_rate: Any
    status: Any
    count: Any
    exact: Any
    leading: Any
    rates: Array
    ratios: Array
    curvatures: Array
    curvature_rates: Array
    chosen: Any
    asked: Leading = field(repr=False)
    arm: Arm = field(repr=False)

    @cached_property
    def tangent(self) -> Array:
        """(..., 2) the unit tangents."""
        slim = self.direction / np.abs(self.direction).max(axis=-1, keepdims=True)
        unit: Array = slim / np.sqrt((slim**2).sum(axis=-1, keepdims=True))
        return unit

    @property
    def parabola(self) -> Array:
        """(..., 3) p2, p1, p0: at the rates ``pseudoinverse + z null`` the curvature is p2 z^2 + p1 z + p0."""
        return self._family["parabola"]

    @property
    def pseudoinverse(self) -> Array:
        """(..., 3) J^+ T, the smallest rates that follow the tangent."""
        return self._family["least"]

    @property
    def null(self) -> Array:
        """(..., 3) unit rates that do not move the tip."""
        return self._family["null"]

    @cached_property
    def _family(self) -> dict[str, Array]:
        """All rates that follow the tangent, nan where they are not one family.

        Found again, as most who ask for many solutions do not ask for them.
        """
        evaluate = self.arm.evaluator("speed_ratio_rates")
        results = evaluate(self.q, self.arm.parameters, self.direction, self._wanted, _ONE[0])
        found = {name: result for (name, _), result in zip(evaluate.outputs, results, strict=True) if name in _FAMILY}
        for result in found.values():
            result[np.asarray(self.status) == Status.SINGULAR] = np.nan
        return found

    @property
    def _wanted(self) -> Array:
        """(..., 2) the desired curvature and its rate."""
        return np.stack(np.broadcast_arrays(self.desired, self.desired_rate), axis=-1)

    # ---- the paper's quantities ----------------------------------------------------------------------------------

    @cached_property
    def terms(self) -> dict[str, Array]:
        """A, B, B0, B1, a, b, C, D and the discriminant of (5) to (9) by name, for the leading joint of each."""
        leads, shape = np.asarray(self.leading), np.shape(self.status)
        wanted = self._wanted
        found: list[Array] = []
        for joint in np.unique(leads).tolist() or [1]:
            evaluate = self.arm.evaluator(f"speed_ratio_terms_{joint}")
            results = evaluate(self.q, self.arm.parameters, self.tangent, wanted)
            if (leads == joint).all():
                return dict(zip(_TERMS, results, strict=True))
            whole = [np.broadcast_to(r, shape + own) for r, (_, own) in zip(results, evaluate.outputs, strict=True)]
            found = found or [np.array(result) for result in whole]
            for kept, result in zip(found, whole, strict=True):
                kept[leads == joint] = result[leads == joint]
        return dict(zip(_TERMS, found, strict=True))

    @property
    def A(self) -> Array:
        """(..., 3) coefficients of (5), A1 n_i + A2 n_j + A3 = 0: the tip moves along T."""
        return self.terms["A"]

    @property
    def B(self) -> Array:
        """(..., 6) coefficients of (6), of n_i^2, n_j^2, n_i n_j, n_i, n_j and 1: its path has the curvature."""
        return self.terms["B"]

    @property
    def B0(self) -> Array:
        """(..., 6) the part of B without the curvature: B = B0 + kappa B1."""
        return self.terms["B0"]

    @property
    def B1(self) -> Array:
        """(..., 6) the part of B that multiplies the curvature."""
        return self.terms["B1"]

    @property
    def a(self) -> Array:
        """(..., 3) the part of (7), of n_i^2, n_i and 1, that multiplies the curvature: a square, a2^2 = 4 a1 a3.

        From (6) by putting n_j = -(A1 n_i + A3) / A2 into it, as the paper's numbers are (not multiplied by A2^2).
        Where A2 = 0, (7) is a polynomial in n_j instead.
        """
        return self.terms["a"]

    @property
    def b(self) -> Array:
        """(..., 3) the part of (7) without the curvature."""
        return self.terms["b"]

    @property
    def C(self) -> Array:
        """(...,) 2 a2 b2 - 4 a1 b3 - 4 b1 a3, of (9)."""
        return self.terms["C"]

    @property
    def D(self) -> Array:
        """(...,) b2^2 - 4 b1 b3, of (9)."""
        return self.terms["D"]

    @property
    def discriminant(self) -> Array:
        """(...,) kappa C + D, (9): negative where the desired curvature cannot be met."""
        return self.terms["discriminant"]

    # ---- what follows --------------------------------------------------------------------------------------------

    @property
    def curvature(self) -> Any:
        """(...,) the curvature that the chosen solution tracks; nan where there is none."""
        return _scalar(self._of_chosen(self.curvatures))

    @property
    def chosen_rates(self) -> Array:
        """(..., 3) the chosen solution, at unit tip speed; nan where there is none."""
        found: Array = self._of_chosen(self.rates)
        return found

    @property
    def chosen_ratios(self) -> Array:
        """(..., 2) the chosen solution's ratios; nan where there is none."""
        found: Array = self._of_chosen(self.ratios)
        return found

    @property
    def pseudoinverse_ratios(self) -> Array:
        """(..., 2) the pseudoinverse's rates of the other joints divided by the leading joint's; inf if that is 0."""
        return _divided(self.pseudoinverse, np.asarray(self.leading))

    @property
    def pseudoinverse_curvature(self) -> Any:
        """(...,) the curvature that the pseudoinverse's rates track, p0."""
        return _scalar(self.parabola[..., 2])

    @property
    def reachable(self) -> Array:
        """(..., 2) the least and the greatest curvature that constant rates can track along the tangent.

        One end is -D/C and the other infinite; both are infinite where C = 0, and one number where D = 0 too; nan at a
        singular configuration. What is asked for does not matter.
        """
        p2, p1, p0 = np.moveaxis(self.parabola, -1, 0)
        status = np.asarray(self.status)
        bent = (status == Status.EXACT) | (status == Status.NEAREST)
        with np.errstate(all="ignore"):
            end = np.where(bent, p0 - p1 * p1 / (4.0 * p2), np.inf)
        fixed = status == Status.FIXED
        low = np.where(fixed, p0, np.where(bent & (p2 > 0.0), end, -np.inf))
        high = np.where(fixed, p0, np.where(bent & (p2 < 0.0), end, np.inf))
        found: Array = np.stack([low, high], axis=-1)
        found[status == Status.SINGULAR] = np.nan
        return found

    @property
    def others(self) -> tuple[int, int]:
        """The joints (from 1) that :attr:`ratios` are of; for one configuration.

        Raises:
            InputError: with leading axes, where they may differ.
        """
        self._only_one("others")
        i, j = _OTHERS[int(self.leading) - 1] + 1
        return int(i), int(j)

    @property
    def reason(self) -> str:
        """In words what was found and why; for many configurations how many of each status there are."""
        if np.ndim(self.status) == 0:
            return self.explain()
        counts = ((int(np.sum(self.status == s)), s.name.lower().replace("_", " ")) for s in Status)
        return f"{np.size(self.status)} configurations: " + ", ".join(f"{k} {name}" for k, name in counts if k)

    def explain(self, *index: int) -> str:
        """In words what was found at one configuration and why.

        Args:
            index: its place along the leading axes; none for a single configuration.
        """
        if len(index) != np.ndim(self.status):
            raise InputError(f"explain: {len(index)} indices given; {np.ndim(self.status)} are accepted")
        return " ".join(_sentences(self, index))

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers, lists and words; what is not finite is None."""
        single = np.ndim(self.status) == 0
        named = np.vectorize(lambda code: Status(code).name.lower(), otypes=[object])
        found: dict[str, Any] = {
            "arm": self.arm.name,
            "status": named(self.status).tolist() if not single else self.status.name.lower(),
            "reason": self.reason,
        }
        keys = (
            *("q", "tangent", "desired", "desired_rate", "exact", "count", "leading", "chosen", "curvature"),
            *("ratios", "rates", "curvatures", "curvature_rates", "reachable", "parabola", "null"),
            *("pseudoinverse", "pseudoinverse_ratios", "pseudoinverse_curvature"),
            *_TERMS,
        )
        return found | {key: _plain(getattr(self, key)) for key in keys}

    def _only_one(self, what: str) -> None:
        if np.ndim(self.status):
            raise InputError(f"{what}: there are {np.shape(self.status)} configurations here; it is for a single one")

    def _of_chosen(self, values: Array) -> Any:
        """The entry of the chosen solution, or nan."""
        axis = np.ndim(self.status)
        if axis == 0:
            return values[self.chosen] if self.count else np.full(values.shape[1:], np.nan)[()]
        place = np.maximum(self.chosen, 0).reshape(self.chosen.shape + (1,) * (values.ndim - axis))
        return np.take_along_axis(values, place, axis=axis).squeeze(axis)


def speed_ratios(
    arm: Arm,
    q: Any,
    tangent: Any,
    curvature: Any,
    curvature_rate: Any = 0.0,
    leading: Leading = 1,
) -> SpeedRatios:
    """Joint rates in constant ratio with which the tip follows a tangent and a curvature, or comes nearest to it.

    The rates that follow the unit tangent T at unit speed are x = J^+ T + z n, and the path's curvature is a parabola
    in z. It meets the desired curvature twice, or its vertex -D/C comes nearest: the discriminant kappa C + D is
    linear in kappa, so that everything on one side of -D/C is reachable, and nothing on the other (Ambike, (5) to (9),
    here for signed curvature: a left turn is positive). Of two solutions that one is chosen whose dk/ds is nearer to
    the desired one. Singular configurations are refused by :attr:`Status.SINGULAR`, with no solution.

    Computed in double precision. All arguments broadcast over leading axes.

    Args:
        arm: a planar arm with three joints, any of them revolute or prismatic.
        q: (..., 3) rad or m.
        tangent: (..., 2) the direction of motion, of any length but zero.
        curvature: (...,) the desired curvature, 1/m.
        curvature_rate: (...,) its desired rate of change along the path, 1/m^2.
        leading: the joint (from 1) that the ratios are taken to, or ``"auto"`` for the one that moves most. Where it
            stands still, the ratios to it are infinite, and the joint that moves most leads instead.

    Raises:
        InputError: an arm that is not planar or has not three joints, wrong shapes, numbers that are not finite, a
            tangent of length zero, or numbers so large that the rates overflow.

    Example:
        >>> import numpy as np
        >>> from chainrule import load
        >>> q = np.radians([-14.0, -10.0, -205.0])  # example 1 of the paper: a right turn
        >>> found = speed_ratios(load("ambike_3r"), q, tangent=[2, 1], curvature=-1.0)
        >>> found.ratios.round(4)
        array([[-0.0343,  3.0319],
               [-6.0402, -3.7154]])
        >>> found.curvature_rates.round(4), found.chosen
        (array([0.4205, 0.0991]), 1)
    """
    check_arm(arm)
    asked = _leading(leading)
    q, direction, wanted, shape = _inputs(q, tangent, curvature, curvature_rate)
    first = 1 if asked == "auto" else asked
    solutions, verdict = _solved(arm, q, direction, wanted, first, shape)
    rates, ratios = solutions[..., :3], solutions[..., 3:5]
    status, count, chosen = verdict[..., 0], verdict[..., 1], verdict[..., 2]
    leads = np.full(shape, first, np.int8)
    again = np.ones(shape, bool) if asked == "auto" else verdict[..., 4] != 0
    if again.any():
        leads[again] = _busiest(rates[again], count[again], chosen[again])
        ratios[again] = _divided(rates[again], leads[again][..., None])
    found = SpeedRatios(
        arm=arm,
        asked=asked,
        q=q,
        direction=direction,
        desired=wanted[..., 0],
        desired_rate=wanted[..., 1],
        status=status,
        count=count,
        exact=verdict[..., 3].view(bool),
        leading=leads,
        rates=rates,
        ratios=ratios,
        curvatures=solutions[..., 5],
        curvature_rates=solutions[..., 6],
        chosen=chosen,
    )
    return found if shape else _trimmed(found)


def _solved(
    arm: Arm, q: Array, direction: Array, wanted: Array, first: int, shape: tuple[int, ...]
) -> tuple[Array, Array]:
    """Both solutions (..., 2, 7) = rates, ratios, curvature and its rate, and the verdict (..., 5) as small integers.

    What does not exist is nan, and chosen -1 where nothing does.

    Raises:
        InputError: what is given, or what comes out, is not finite.
    """
    solutions, verdict = np.empty((*shape, 2, 7)), np.empty((*shape, 5), np.int8)
    evaluate = arm.evaluator("speed_ratio_rates")
    each = max(1, BLOCK // max(1, math.prod(shape[1:])))
    if not shape or shape[0] <= each:
        blocks: list[Any] = [...]
        given: tuple[Array, ...] = (q, direction, wanted)
        room = shape
    else:
        blocks = [slice(start, start + each) for start in range(0, shape[0], each)]
        given = tuple(np.broadcast_to(array, shape + array.shape[-1:]) for array in (q, direction, wanted))
        room = (each, *shape[1:])
    unkept = [np.empty(room + own) for _, own in evaluate.outputs[4:]]
    for block in blocks:
        part = solutions[block]
        spare = [array[: len(part)] for array in unkept] if shape else unkept
        kept = (part[..., :3], part[..., 3:5], part[..., 5], part[..., 6])
        configurations, directions, curvatures = (array[block] for array in given)
        evaluate(configurations, arm.parameters, directions, curvatures, _ONE[first - 1], out=(*kept, *spare))
        if not np.isfinite(part[..., 6]).all():
            raise _unusable(q, direction, wanted)
        verdict[block] = spare[0]
        _struck_out(part, verdict[block])
    return solutions, verdict


def _struck_out(solutions: Array, verdict: Array) -> None:
    """Makes nan of the solutions that do not exist, each in one piece."""
    whole, count = solutions.view(_SOLUTION)[..., 0], verdict[..., 1]
    whole[..., 1][count < 2] = _NOTHING
    if not count.all():
        none = count == 0
        whole[..., 0][none] = _NOTHING
        verdict[none, 2] = -1


def table(found: SpeedRatios) -> Table:
    """The solutions of one configuration and the pseudoinverse's rates, side by side.

    Raises:
        InputError: with leading axes.

    Example:
        >>> from chainrule import load
        >>> found = speed_ratios(load("ambike_3r"), [-0.2, -0.2, 2.7], tangent=[2, 1], curvature=-1.0)
        >>> [row[0] for row in table(found).rows]
        ['chosen', 'other solution', 'pseudoinverse']
    """
    i, j = found.others
    rows: list[tuple[Cell, ...]] = []
    order = sorted(range(found.count), key=lambda k: k != found.chosen)
    for k in order:
        word = "chosen" if k == found.chosen else "other solution"
        numbers = (*found.ratios[k], *found.rates[k], found.curvatures[k], found.curvature_rates[k])
        rows.append((word, *map(float, numbers)))
    if found.count:
        last = (*found.pseudoinverse_ratios, *found.pseudoinverse, found.pseudoinverse_curvature)
        rows.append(("pseudoinverse", *map(float, last), None))
    units = [f"{joint_unit(kind)}/m" for kind in found.arm.kinds]
    columns = (
        Column("solution", "rates"),
        *(Column(f"n{k}", f"n{k} = q{k}′/q{found.leading}′") for k in (i, j)),
        *(Column(f"rate{k + 1}", f"q{k + 1}′", unit) for k, unit in enumerate(units)),
        Column("curvature", "curvature", "1/m"),
        Column("curvature_rate", "its change", "1/m²"),
    )
    return Table("Joint rates in constant ratio, at a tip speed of 1 m/s", columns, tuple(rows))


def _trimmed(found: SpeedRatios) -> SpeedRatios:
    """A single configuration's result: plain numbers, and the solutions that exist."""
    k = int(found.count)
    return replace(
        found,
        desired=float(found.desired),
        desired_rate=float(found.desired_rate),
        status=Status(int(found.status)),
        count=k,
        exact=bool(found.exact),
        leading=int(found.leading),
        chosen=int(found.chosen),
        rates=found.rates[:k],
        ratios=found.ratios[:k],
        curvatures=found.curvatures[:k],
        curvature_rates=found.curvature_rates[:k],
    )


def check_arm(arm: Arm) -> None:
    """Refuse what is not a planar arm with three joints.

    Raises:
        InputError: naming what is accepted.
    """
    if not isinstance(arm, Arm):
        raise InputError(f"speed_ratios: {shown(arm)} is not an arm; a planar arm with three joints is accepted")
    if not isinstance(arm.description.geometry, Planar):
        raise InputError(f"speed_ratios: {arm.name} is not planar; planar arms with three joints are accepted")
    if arm.n != 3:
        instead = {2: "; for two joints see second_order_ratios", 4: "; for four joints see speed_ratios_4"}
        raise InputError(
            f"speed_ratios: {arm.name} has {arm.n} joint{'s' if arm.n > 1 else ''}; planar arms with three joints are "
            f"accepted{instead.get(arm.n, '')}"
        )


def _leading(leading: Any) -> Leading:
    if isinstance(leading, str) and leading == "auto":
        return "auto"
    if isinstance(leading, bool) or not isinstance(leading, int | np.integer) or leading not in (1, 2, 3):
        raise InputError(f"leading: {shown(leading)}; 1, 2, 3 or 'auto' are accepted")
    return int(leading)


def _inputs(q: Any, tangent: Any, curvature: Any, rate: Any) -> tuple[Array, Array, Array, tuple[int, ...]]:
    """Copies of q and the directions, the desired curvatures with their rates (..., 2), and the leading axes of all.

    That they are finite is looked at once the results are there, but for the curvatures' rates: what else is not a
    number leaves none.
    """
    configurations, direction = np.array(_real("q", q, 3)), np.array(_real("tangent", tangent, 2))
    wanted = (_real("curvature", curvature), _real("curvature_rate", rate))
    try:
        bend = np.empty((*_common(wanted[0].shape, wanted[1].shape), 2))
        bend[..., 0], bend[..., 1] = wanted
        shape = _common(configurations.shape[:-1], direction.shape[:-1], bend.shape[:-1])
    except ValueError:
        shapes = (configurations.shape[:-1], direction.shape[:-1], wanted[0].shape, wanted[1].shape)
        raise InputError(
            f"speed_ratios: the leading axes of q, tangent, curvature and curvature_rate, {shapes}, do not broadcast"
        ) from None
    if not np.isfinite(wanted[1]).all():
        raise _unusable(configurations, direction, bend)
    return configurations, direction, bend, shape


def _common(*shapes: tuple[int, ...]) -> tuple[int, ...]:
    """The shape that all broadcast to; mostly those that are not () are the same."""
    unlike = set(shapes) - {()}
    return unlike.pop() if len(unlike) == 1 else np.broadcast_shapes(*unlike)


def _unusable(q: Array, direction: Array, wanted: Array) -> InputError:
    """Why there are results that are not numbers."""
    named = {"q": q, "tangent": direction, "curvature": wanted[..., 0], "curvature_rate": wanted[..., 1]}
    for name, values in named.items():
        if not np.isfinite(values).all():
            return InputError(f"{name}{_first(~np.isfinite(values))}: not a finite number; finite numbers are accepted")
    still = (direction == 0.0).all(axis=-1)
    if still.any():
        return InputError(f"tangent{_first(still)}: the vector's length is 0; any other length is accepted")
    return InputError("speed_ratios: numbers overflow; lengths, joint values and curvatures nearer to 1 are accepted")


def _first(mask: Array) -> str:
    """The first place where a mask is true, as it is written after a name."""
    index = ", ".join(str(int(i)) for i in np.argwhere(mask)[0])
    return f"[{index}]" if index else ""


def _real(name: str, value: Any, last: int | None = None) -> Array:
    """An array of doubles; with ``last``, of vectors of that many entries."""
    accepted = f"(..., {last}) real numbers are" if last else "a real number, or an array of them, is"
    try:
        array = np.asarray(value)
    except ValueError:
        raise InputError(f"{name}: a ragged nested sequence was given; {accepted} accepted") from None
    if array.dtype.kind not in "fiu":
        raise InputError(f"{name}: {shown(value)} is not numbers; {accepted} accepted")
    if last is not None and (array.ndim == 0 or array.shape[-1] != last):
        raise InputError(f"{name} has shape {array.shape}; {accepted} accepted")
    found: Array = array.astype(np.float64, copy=False)
    return found


def _busiest(rates: Array, count: Array, chosen: Array) -> Array:
    """The joint (from 1) whose smaller share in the solutions is greatest; if all stand still in one, the chosen's."""
    with np.errstate(invalid="ignore"):  # of a solution that does not exist
        share = np.abs(rates) / np.abs(rates).max(axis=-1, keepdims=True)
    share[(count[..., None] <= np.arange(2))] = np.inf
    both = share.min(axis=-2)
    place = np.maximum(chosen, 0)[..., None, None]
    alone = np.take_along_axis(share, place, axis=-2).squeeze(-2)
    usable = (both.max(axis=-1) > STANDSTILL)[..., None]
    found: Array = (np.where(usable, both, alone).argmax(axis=-1) + 1).astype(np.int8)
    return found


def _divided(rates: Array, leads: Array) -> Array:
    """Rates (..., 3) of the other joints divided by those of the leading joints (...,)."""
    leads = np.broadcast_to(leads, rates.shape[:-1])
    top = np.take_along_axis(rates, _OTHERS[leads - 1], axis=-1)
    with np.errstate(all="ignore"):
        found: Array = top / np.take_along_axis(rates, leads[..., None] - 1, axis=-1)
    return found


def _scalar(value: Any) -> Any:
    """A float where there is one number only."""
    return value if np.ndim(value) else float(value)


def _plain(value: Any) -> Any:
    """Nested lists of plain values, None for what is not finite."""
    array = np.asarray(value)
    if array.ndim:
        return [_plain(part) for part in array]
    return array.item() if array.dtype.kind != "f" or np.isfinite(array) else None


def _sentences(found: SpeedRatios, index: tuple[int, ...]) -> list[str]:
    """What was found at one configuration, sentence by sentence."""
    shape = np.shape(found.status)
    at = {
        name: np.broadcast_to(getattr(found, name), shape + own)[index]
        for name, own in (("desired", ()), ("desired_rate", ()), ("q", (3,)), ("tangent", (2,)))
    }
    status = Status(int(np.asarray(found.status)[index]))
    if status is Status.SINGULAR:
        return _singular(found.arm, at["q"], at["tangent"])
    count, chosen = int(np.asarray(found.count)[index]), int(np.asarray(found.chosen)[index])
    curvatures, changes = found.curvatures[index], found.curvature_rates[index]
    low, high = found.reachable[index]
    desired = f"{at['desired']:.6g}"
    if status is Status.FIXED:
        said = [
            f"Along this tangent the curvature is {curvatures[0]:.6g} whatever the spare joint does (C = D = 0): (7) "
            "is a square, and its double root is the motion in which the tip stands still. The pseudoinverse's rates "
            "are given."
        ]
    elif status is Status.ONE_AT_INFINITY:
        said = [
            f"One solution has the curvature {desired}; in the other, the second root of (7), the tip stands still "
            "(C = 0): along this tangent every curvature is reached, once."
        ]
    elif status is Status.NEAREST:
        side = f"from {low:.6g} up" if np.isfinite(low) else f"up to {high:.6g}"
        said = [
            f"The curvature {desired} cannot be met: along this tangent constant rates reach the curvatures {side}, "
            f"and {curvatures[0]:.6g} (-D/C) is nearest."
        ]
        if curvatures[0] * at["desired"] < 0.0:
            said.append("The path bends to the other side than desired.")
    elif count == 1:
        said = [f"The curvature {desired} is the last that constant rates reach along this tangent: one solution."]
    else:
        first, second = ("first", "second") if chosen == 0 else ("second", "first")
        said = [
            f"Both solutions have the curvature {desired}. The {first} is chosen: its curvature changes by "
            f"{changes[chosen]:.6g} per metre of path, nearer to the desired {at['desired_rate']:.6g} than the "
            f"{second}'s {changes[1 - chosen]:.6g}."
        ]
    leading = int(np.asarray(found.leading)[index])
    if found.asked != "auto" and leading != found.asked:
        said.append(f"Joint {found.asked} stands still in a solution and cannot lead: joint {leading} does.")
    return said


def _singular(arm: Arm, q: Array, tangent: Array) -> list[str]:
    """Why there is no solution: the rank of the Jacobian, and whether the tangent lies in its range."""
    jacobian = np.asarray(arm.jacobian(q, task="position"))
    directions, values, _ = np.linalg.svd(jacobian)
    scale = max(float(np.abs(jacobian).max()), float(np.abs(arm.parameters[:3]).max()), 1e-300)
    rank = int((values > 1e-12 * scale).sum())
    if rank == 0:
        return ["The configuration is singular: the Jacobian is zero, and no joint moves the tip."]
    across = abs(tangent[0] * directions[1, 0] - tangent[1] * directions[0, 0])
    if across > 1e-9:
        x, y = directions[:, 0] * np.copysign(1.0, directions[0, 0])
        return [
            f"The configuration is singular: the Jacobian has rank 1, and the tip can leave only along ({x:.4g}, "
            f"{y:.4g}), not along the tangent."
        ]
    return [
        "The configuration is singular: the Jacobian has rank 1. The tangent is the direction in which the tip can "
        "leave, but (5) leaves both ratios free, and the rates are not one family with one curvature to choose."
    ]
