"""A planar arm as the joints that move and the rigid links between them, from the base or from the tip."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass, replace
from typing import Literal

from chainrule.boundary_pieces import TURN, Values
from chainrule.description import Description, Planar
from chainrule.errors import InputError
from chainrule.regions import Region, point
from chainrule.sweeping import Slide, Turn, sweep

#: A rigid motion z -> rotation z + shift.
Move = tuple[complex, complex]
REST: Move = (1.0 + 0j, 0j)

#: Distances between joints shorter than this share of the size, and ranges below it, count as zero: what they add to
#: the workspace is so thin that its edges could not be told apart safely.
TINY = 1e-9

#: Sizes of arms, m: beyond them the fourth power of a length leaves the range of numbers.
SMALLEST, LARGEST = 1e-60, 1e60


def then(first: Move, second: Move) -> Move:
    """The motion that applies ``second`` in the frame that ``first`` leads to."""
    return first[0] * second[0], first[1] + first[0] * second[1]


def back(move: Move) -> Move:
    """The inverse motion."""
    rotation = move[0].conjugate()
    return rotation, -rotation * move[1]


@dataclass(frozen=True)
class Moving:
    """A joint that moves: a turn about the origin of its frame, or a slide along its x axis.

    Attributes:
        kind: R or P.
        lower, upper: rad or m; a joint that turns freely has a range of one turn.
        index: its place in the arm, from 0.
        sign: -1 where the chain is seen from the tip, so that the arm's joint value is sign times ours.
    """

    kind: Literal["R", "P"]
    lower: float
    upper: float
    index: int
    sign: float = 1.0

    @property
    def free(self) -> bool:
        """Whether it turns all the way round."""
        return self.kind == "R" and self.upper - self.lower >= TURN - 1e-12 - 1e-15 * abs(self.lower)

    def at(self, value: float) -> Move:
        """The motion at a value."""
        return (cmath.rect(1.0, value), 0j) if self.kind == "R" else (1.0 + 0j, complex(value))


@dataclass(frozen=True)
class Chain:
    """links[0], joints[0], links[1], ..., joints[-1], links[-1], from the base to the tip.

    Attributes:
        joints: those that move.
        links: the rigid motions before, between and after them.
        values: (n,) of all the arm's joints; those that do not move have their value.
        size: a length that no distance in the chain exceeds, m.
    """

    joints: tuple[Moving, ...]
    links: tuple[Move, ...]
    values: Values
    size: float

    @property
    def turns(self) -> bool:
        """Whether the first joint that moves turns freely: then everything is symmetric about it."""
        return bool(self.joints) and self.joints[0].free


def chain(arm: Description) -> Chain:
    """The chain of a planar arm within its limits.

    A revolute joint with no limits, with one only, or with a range of a full turn or more turns freely.

    Raises:
        InputError: an arm in space; a prismatic joint without two finite limits; an arm of no sensible size.
    """
    geometry = arm.geometry
    if not isinstance(geometry, Planar):
        raise InputError(
            f"{arm.name}: the exact workspace is known for planar arms only (joints R or P that move in one plane)"
        )
    joints: list[Moving] = []
    links: list[Move] = [REST]
    values = [0.0] * arm.n
    size = math.fsum(abs(length) for length in geometry.lengths) + math.fsum(
        max(map(abs, joint.position)) for joint in arm.joints if joint.kind == "P" and joint.position is not None
    )
    for i, kind in enumerate(arm.kinds):
        lower, upper = arm.joints[i].position or (-math.inf, math.inf)
        if kind == "P":
            if not (math.isfinite(lower) and math.isfinite(upper)):
                raise InputError(
                    f"{arm.name}, joint {i + 1}: a prismatic joint without limits makes the workspace unbounded; "
                    "two finite position limits are accepted"
                )
            links[-1] = then(links[-1], (cmath.rect(1.0, geometry.headings[i]), 0j))
        elif upper - lower >= TURN - 1e-12:
            if lower <= -math.pi and upper >= math.pi:
                lower = -math.pi
            elif not math.isfinite(lower):
                lower = upper - TURN
            upper = lower + TURN
        joint = Moving("R" if kind == "R" else "P", lower, upper, i)
        values[i] = 0.5 * (lower + upper) if lower < upper else lower
        if upper - lower > TINY * (1.0 if kind == "R" else size):
            joints.append(joint)
            links.append(REST)
        else:
            links[-1] = then(links[-1], joint.at(values[i]))
        links[-1] = then(links[-1], (1.0 + 0j, complex(geometry.lengths[i])))
    if size > 0.0 and not SMALLEST <= size <= LARGEST:
        raise InputError(
            f"{arm.name}: its lengths and strokes add up to {size:g} m; {SMALLEST:g} to {LARGEST:g} m are accepted"
        )
    links[1:] = [(rotation, shift if abs(shift) > TINY * size else 0j) for rotation, shift in links[1:]]
    return Chain(tuple(joints), tuple(links), tuple(values), size)


def from_tip(whole: Chain) -> Chain:
    """The same chain from its tip to its base: where the base is, seen from the tip."""
    joints = tuple(replace(j, lower=-j.upper, upper=-j.lower, sign=-j.sign) for j in reversed(whole.joints))
    return replace(whole, joints=joints, links=tuple(back(link) for link in reversed(whole.links)))


def after_first(whole: Chain) -> Chain:
    """The chain without what comes before the first moving joint, and without that joint."""
    return replace(whole, joints=whole.joints[1:], links=whole.links[1:])


def reached(whole: Chain) -> Region:
    """Where the end of a chain can be, seen from its beginning: each joint sweeps what the joints after it reach.

    The numbers carried along on the boundary are the joint values of a posture there.
    """
    region = point(0j, whole.values).moved(*whole.links[-1])
    for joint, link in zip(reversed(whole.joints), reversed(whole.links[:-1]), strict=True):
        motion = Turn if joint.kind == "R" else Slide
        values = (joint.sign * joint.lower, joint.sign * joint.upper)
        region = sweep(region, motion, joint.lower, joint.upper, joint.index, values, whole.size).moved(*link)
    return region


def merged(whole: Chain) -> Chain:
    """The chain with neighbours on one axis, or sliding along one line, as one joint: their motions add up."""
    joints: list[Moving] = []
    links: list[Move] = [whole.links[0]]
    for joint, link in zip(whole.joints, whole.links[1:], strict=True):
        before = joints[-1] if joints else None
        rotation, shift = links[-1]
        if before is not None and before.kind == joint.kind == "R" and abs(shift) <= 1e-12 * whole.size:
            lower, upper = before.lower + joint.lower, before.upper + joint.upper
            joints[-1] = replace(before, lower=lower, upper=min(upper, lower + TURN))
            links[-1] = then((rotation, 0j), link)
        elif before is not None and before.kind == joint.kind == "P" and abs(rotation.imag) <= 1e-12:
            low, high = (joint.lower, joint.upper) if rotation.real > 0 else (-joint.upper, -joint.lower)
            joints[-1] = replace(before, lower=before.lower + low, upper=before.upper + high)
            links[-1] = then(links[-1], link)
        else:
            joints.append(joint)
            links.append(link)
    return replace(whole, joints=tuple(joints), links=tuple(links))
