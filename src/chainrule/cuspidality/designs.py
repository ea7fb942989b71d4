"""The face: what a user asks of a 3R arm.

:class:`Regional3R` speaks of any arm of three revolute joints that positions a point, or of the part of a six-joint arm
before its spherical wrist. :class:`Orthogonal3R` is an arm of the family of Baili, Wenger and Chablat that answers the
same questions, with everything an :class:`~chainrule.Arm` has.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm, checked_arm
from chainrule.cuspidality.exact import rational
from chainrule.cuspidality.normal_form import Regional
from chainrule.description import Description, with_limits
from chainrule.description import Orthogonal3R as Lengths
from chainrule.errors import InputError, shown
from chainrule.readers import families

if TYPE_CHECKING:
    from chainrule.cuspidality.aspects import Aspect
    from chainrule.cuspidality.cuspidal import Example
    from chainrule.cuspidality.domains import Domain
    from chainrule.cuspidality.feasible import FeasiblePostures
    from chainrule.cuspidality.posture_change import PostureChange
    from chainrule.cuspidality.singular_curves import SingularCurve

Array = NDArray[Any]


class FreeJointWarning(UserWarning):
    """A joint is free at the point asked for: its angle in the answer stands for every angle."""


@dataclass(frozen=True)
class ExactRegional(Regional):
    """A normal form of the orthogonal family whose lengths are kept as fractions, not as the doubles next to them.

    Attributes:
        lengths: (d2, d3, d4, r2) of the normal form.
    """

    lengths: tuple[Fraction, ...] = ()

    @classmethod
    def of_lengths(cls, description: Description, lengths: tuple[Fraction, ...]) -> ExactRegional:
        """From the description of an orthogonal arm and its lengths."""
        rounded = Regional.of(description)
        nearby = rounded.orthogonal
        assert nearby is not None
        own = tuple(abs(exact) if near >= 0.0 else -abs(exact) for exact, near in zip(lengths, nearby, strict=True))
        return cls(rounded.parameters, rounded.signs, rounded.offsets, rounded.frame, rounded.name, own)

    @cached_property
    def rationals(self) -> Array:
        """The parameters as ``fmpq``."""
        d2, d3, d4, r2 = (rational(length) for length in self.lengths)
        zero, one = rational(0), rational(1)
        return np.array([zero, -one, zero, one, d2, d3, d4, r2, zero], object)


class Regional3R:
    """What is known of a 3R arm that positions a point: cusps, nodes, postures, aspects and the way between postures.

    Make one with :func:`regional_3r` from any arm of three revolute joints, or of six with a spherical wrist;
    :func:`orthogonal_3r` makes arms that answer the same questions.

    Angles are the arm's own joints, in rad. (rho, z) are the distance from the first joint's axis and the height along
    it, in m, in the frame of the normal form (:attr:`regional`; for an orthogonal arm that is the base, turned upside
    down where lengths of negative sign need it). Joint limits play no part.
    """

    def __init__(self, arm: Arm, regional: Regional) -> None:
        self._arm, self._normal_form = arm, regional

    @property
    def arm(self) -> Arm:
        """The arm it was made from."""
        return self._arm

    @property
    def name(self) -> str:
        """The arm's name."""
        return self.arm.name

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.name}>"

    @property
    def regional(self) -> Regional:
        """The arm's normal form, which the answers are computed from."""
        return self._normal_form

    @property
    def nongeneric(self) -> tuple[str, ...]:
        """Why the arm is not generic, in words (parallel or intersecting axes, ...); empty for a generic arm."""
        return self.regional.nongeneric

    @cached_property
    def cuspidal(self) -> bool | None:
        """Whether the arm can change its posture without meeting a singularity.

        A generic arm can exactly if it has a cusp (Salunkhe et al. 2022); those named in :attr:`nongeneric` cannot.
        None where cusps are just about to appear (four equal roots, two cusps in one): the theorem is silent there.
        """
        from chainrule.cuspidality.cusps import certified_cusps

        found = certified_cusps(self.regional)
        if found.cusps:
            return True
        return None if found.events and not self.nongeneric else False

    @property
    def exact(self) -> bool:
        """Whether the lengths are kept as the fractions they were given as."""
        return isinstance(self.regional, ExactRegional)

    def cusps(self) -> Array:
        """The points of the cross-section that three postures share: (k, 2) of rho and z in m."""
        from chainrule.cuspidality.cusps import cusps

        return cusps(self.regional)

    def nodes(self) -> Array:
        """Where the image of the singular curves crosses itself: (k, 2) of rho and z in m."""
        from chainrule.cuspidality.nodes import nodes

        return nodes(self.regional)

    def singular_curves(self, points: int = 400) -> tuple[SingularCurve, ...]:
        """The closed curves det J = 0 in (theta2, theta3) with their images in the cross-section.

        See :func:`chainrule.cuspidality.singular_curves.singular_curves`.
        """
        from chainrule.cuspidality.singular_curves import singular_curves

        return singular_curves(self.regional, points)

    def aspects(self) -> tuple[Aspect, ...]:
        """The connected components of the joint space without singularities.

        See :mod:`chainrule.cuspidality.aspects`.
        """
        from chainrule.cuspidality.aspects import aspects

        return aspects(self.regional)

    def aspect_of(self, q: Any) -> Array:
        """The label of the aspect of configurations ``q`` (..., 3); -1 where they are singular to within rounding.

        Raises:
            InputError: ``q`` is not (..., 3).
        """
        from chainrule.cuspidality.aspects import aspect_of

        return aspect_of(self.regional, q)

    def same_aspect(self, a: Any, b: Any) -> Array:
        """Whether configurations ``a`` and ``b`` (..., 3) can be joined without meeting a singularity."""
        from chainrule.cuspidality.aspects import same_aspect

        return same_aspect(self.regional, a, b)

    def example(self) -> Example | None:
        """A point with two postures in one aspect, far from singularities; None for an arm that is not cuspidal."""
        from chainrule.cuspidality.cuspidal import example

        return example(self.regional, self.cusps())

    def posture_change(self, a: Any = None, b: Any = None) -> PostureChange:
        """A smooth joint path from ``a`` to ``b`` (3,) without a singularity, with a proof; or why there is none.

        A change of posture where both reach one point (:attr:`PostureChange.same_point`); any two configurations of
        one aspect can be joined. Without ``a`` and ``b`` the postures of :meth:`example` are taken.

        Raises:
            InputError: only one of the two is given, or none where the arm is not cuspidal.

        Example:
            >>> change = orthogonal_3r(1.0, 2.0, 1.5, 1.0).posture_change()
            >>> change.exists, change.certified, change.smallest_determinant > 1.0
            (True, True, True)
            >>> bool((change.sample(0.0) == change.start).all())
            True
        """
        from chainrule.cuspidality.posture_change import posture_change

        if a is None and b is None:
            found = self.example()
            if found is None:
                why = "the arm is not cuspidal"
                if self.cuspidal:
                    why = "the arm is cuspidal, but double precision does not tell them from singular ones"
                raise InputError(f"no point was found with two postures in one aspect: {why}; give a and b")
            a, b = found.postures
        elif a is None or b is None:
            raise InputError("a and b: both configurations, or none of them, are accepted")
        return posture_change(self.regional, a, b)

    def feasible_postures(self, path: Any) -> FeasiblePostures:
        """Which postures can follow a path to its end without a jump, and what stops the others.

        Args:
            path: corners (k, 3) of a polyline in m, or a function of s in [0, 1] that maps (...,) to (..., 3).

        Example:
            >>> found = orthogonal_3r(1.0, 2.0, 1.5, 1.0).feasible_postures([[2.0, 0.0, 0.5], [4.0, 0.0, 0.5]])
            >>> found.feasible, found.postures[1].reason
            ((0, 3), 'it meets a singularity (det J = 0), where it merges with start posture 2')
        """
        from chainrule.cuspidality.feasible import feasible_postures

        return feasible_postures(self.regional, path)

    def postures(self, x: Any, y: Any, z: Any) -> Array:
        """Every posture that reaches the point (x, y, z) m of the base frame: (k, 3) rad, by rising third joint.

        Angles are in (-pi, pi].
        None is lost, see :func:`chainrule.cuspidality.postures.postures`, which takes any number of points at once and
        says which joints are free.

        Raises:
            InputError: the point is not three finite numbers.

        Warns:
            FreeJointWarning: a joint is free at the point; one of its angles stands for all.
        """
        from chainrule.cuspidality.postures import postures

        found = postures(self.regional, _point(x, y, z))
        if found.free.any():
            joints = " and ".join(f"joint {i + 1}" for i in np.flatnonzero(found.free))
            warnings.warn(f"{joints} can have any angle at this point", FreeJointWarning, 2)
        rows: Array = found.q[: int(found.count)] if found.count >= 0 else found.q[np.isfinite(found.q[:, 0])]
        return rows

    def section(self, points: Any) -> Array:
        """(rho, z) (..., 2) of points (..., 3) of the base frame, as the other answers count them, in m."""
        from chainrule.inputs import real_array

        given = real_array(points, "points")
        if given.shape[-1:] != (3,):
            raise InputError(f"points: an array of shape {given.shape}; (..., 3) is accepted")
        found = self.regional.point_to_normal(given)
        return np.stack([np.hypot(found[..., 0], found[..., 1]), found[..., 2]], axis=-1)

    def number_of_postures(self, rho: Any, z: Any) -> Array:
        """How many postures reach points (rho, z) of the cross-section: 0 to 4, of the shape they broadcast to.

        See :func:`chainrule.cuspidality.postures.number_of_postures`: points near a singular curve are decided exactly.
        """
        from chainrule.cuspidality.postures import number_of_postures

        return number_of_postures(self.regional, rho, z)

    def words(self) -> list[str]:
        """What else there is to say about the arm, one sentence each."""
        return [f"Not generic: {reason}." for reason in self.nongeneric]

    def to_dict(self) -> dict[str, Any]:
        """Plain values of everything that belongs to the design: cusps, nodes and aspects."""
        return {
            "name": self.regional.name,
            "parameters": list(self.regional.parameters),
            "cuspidal": self.cuspidal,
            "nongeneric": list(self.nongeneric),
            "exact": self.exact,
            "cusps": np.asarray(self.cusps()).tolist(),
            "nodes": np.asarray(self.nodes()).tolist(),
            "aspects": [aspect.to_dict() for aspect in self.aspects()],
        }


def _point(x: Any, y: Any, z: Any) -> Array:
    from chainrule.inputs import real_array

    found = real_array([x, y, z], "the point (x, y, z)")
    if found.shape != (3,):
        raise InputError(f"the point (x, y, z): arrays of shape {found.shape[1:]}; three numbers are accepted")
    return found


class Orthogonal3R(Arm, Regional3R):
    """An orthogonal 3R arm: alpha_2 = -90 deg, alpha_3 = 90 deg, r_3 = 0. Make one with :func:`orthogonal_3r`."""

    def __init__(self, description: Description, lengths: tuple[Fraction, ...] | None = None) -> None:
        Arm.__init__(self, description)
        exact = None if lengths is None else ExactRegional.of_lengths(description, lengths)
        Regional3R.__init__(self, self, exact or Regional.of(description))
        self._lengths = lengths

    @property
    def lengths(self) -> tuple[Any, ...]:
        """(d2, d3, d4, r2) in m: as fractions where the arm was made with ``exact=True``, else as floats."""
        geometry = self.description.geometry
        assert isinstance(geometry, Lengths)
        return self._lengths or (geometry.d2, geometry.d3, geometry.d4, geometry.r2)

    @property
    def domain(self) -> int | None:
        """The domain of the design space, 1 to 5; None on a surface between two (see :attr:`surfaces`), or for r2 = 0.

        The domains have 0, 4, 2, 4, 0 cusps (Baili, Wenger and Chablat 2004, section III, with its corrections).
        """
        return self._place.number

    @property
    def surfaces(self) -> tuple[str, ...]:
        """The separating surfaces that the design lies on, such as ``("C1",)``; empty inside a domain.

        Floats count at their binary value; lengths of ``exact=True`` as they were given.
        """
        return self._place.surfaces

    @property
    def topology(self) -> tuple[int, int] | None:
        """(number of cusps, number of nodes) of the cross-section; None on a surface that changes one, or for r2 = 0.

        One of the nine topologies: 0/0, 4/2, 4/0, 4/2, 2/1, 2/3, 4/4, 0/0, 0/2, of which :attr:`topology_number` says
        which (the pairs 0/0 and 4/2 occur twice).
        """
        place = self._place
        return None if place.topology is None or place.nodes is None else (place.cusps, place.nodes)

    @property
    def topology_number(self) -> int | None:
        """1 to 9, in the order of :attr:`topology`."""
        return self._place.topology

    @cached_property
    def _place(self) -> Domain:
        from chainrule.cuspidality.domains import exact_domain

        return exact_domain(*self.regional.rationals[4:8])

    def words(self) -> list[str]:
        """What else there is to say about the arm, one sentence each."""
        return [f"In the design space: {self._place.words}.", *super().words()]

    def to_dict(self) -> dict[str, Any]:
        """Plain values of everything that belongs to the design: its domain, cusps, nodes and aspects."""
        place = {"design": self._place.to_dict(), "lengths": [str(length) for length in self.lengths]}
        return {**super().to_dict(), **place}

    def with_limits(self, **limits: Any) -> Orthogonal3R:
        """A copy with other joint limits, as :meth:`chainrule.Arm.with_limits`; the answers do not depend on them."""
        return Orthogonal3R(with_limits(self.description, **limits), self._lengths)

    def __reduce__(self) -> Any:
        return Orthogonal3R, (self.description, self._lengths)


def orthogonal_3r(d2: Any, d3: Any, d4: Any, r2: Any, *, exact: bool = False) -> Orthogonal3R:
    """The orthogonal 3R arm (alpha_2 = -90 deg, alpha_3 = 90 deg, r_3 = 0) with lengths in m.

    It is an :class:`~chainrule.Arm` that also knows its cusps, nodes, aspects and postures (:class:`Regional3R`).

    Args:
        d2: length in m, of either sign, as the others.
        d3: length in m.
        d4: length in m.
        r2: offset in m.
        exact: whether to keep the lengths as they are given: integers, fractions, ``Decimal`` or decimal text such as
            ``"0.1"``. Whatever is decided about the design (its domain, whether it lies on a surface, its cusps, nodes
            and aspects) is then decided for these numbers, else for the doubles next to them.

    Raises:
        InputError: a length that is not a finite number, or text without ``exact``.

    Source: M. Baili, P. Wenger, D. Chablat, "Kinematic analysis of a family of 3R manipulators", Problems of Mechanics
    15 (2004).

    Example:
        >>> arm = orthogonal_3r(1.0, 2.0, 1.5, 1.0)
        >>> arm.position([0.5, 0.5, 0.5]).round(3)
        array([ 2.607,  3.383, -1.59 ])
        >>> arm.domain, arm.topology, arm.cuspidal
        (2, (4, 0), True)
        >>> orthogonal_3r(1, 3, "3.75", 3, exact=True).surfaces
        ('C2',)
    """
    if not exact:
        return Orthogonal3R(families.orthogonal_3r(d2, d3, d4, r2))
    found = [rational(value, name) for value, name in zip((d2, d3, d4, r2), ("d2", "d3", "d4", "r2"), strict=True)]
    lengths = tuple(Fraction(int(value.p), int(value.q)) for value in found)
    for name, length in zip(("d2", "d3", "d4", "r2"), lengths, strict=True):
        try:
            lost = float(length) == 0.0 != length
        except OverflowError:
            lost = True
        if lost:
            raise InputError(f"{name}: {shown(length)} is beyond the range of double precision")
    return Orthogonal3R(families.orthogonal_3r(*(float(length) for length in lengths)), lengths)


def regional_3r(arm: Arm) -> Regional3R:
    """What is known of an arm that positions a point with three revolute joints.

    An arm of three revolute joints in space with any twists and offsets, its point the tool's origin; or an arm with
    six revolute joints and a spherical wrist, its point the wrist's centre.

    Raises:
        InputError: any other arm.

    Example:
        >>> arm = Arm.from_dh([("R", 0.0, 0.0, 0.0, 0.0), ("R", 1.2, 1.0, 0.3, 0.0), ("R", -0.9, 1.5, 0.2, 0.0)],
        ...                   tool=(1.2, 0.0, 0.0), name="twisted")
        >>> design = regional_3r(arm)
        >>> len(design.aspects()), design.cuspidal
        (2, True)
    """
    checked_arm(arm)
    if isinstance(arm, Orthogonal3R):
        return arm
    if isinstance(arm.description.geometry, Lengths):
        return Orthogonal3R(arm.description)
    if arm.n == 6 and arm.kinds == "RRRRRR":
        from chainrule.cuspidality.wrists import wrist

        found = wrist(arm)
        if found.regional is None:
            raise InputError(f"{arm.name}: {found.words}; a spherical wrist, or three joints, are accepted")
        return Regional3R(arm, Regional.of(found.regional))
    if arm.n != 3:
        raise InputError(
            f"{arm.name}: {arm.n} joints; three revolute ones, or six with a spherical wrist, are accepted"
        )
    return Regional3R(arm, Regional.of(arm))
