"""Whether a 3R arm can change its posture without meeting a singularity, and a point where it does.

A generic 3R arm is cuspidal exactly if its cross-section has a cusp, a point that three postures share (D. H.
Salunkhe, C. Spartalis, J. Capco, D. Chablat, P. Wenger, "Necessary and sufficient condition for a generic 3R serial
manipulator to be cuspidal", Mechanism and Machine Theory 171, 2022). Arms that are not generic are named with the
reason; consecutive axes that are parallel or meet, and the orthogonal arms with r2 = 0, are never cuspidal (P. Wenger,
"Design of cuspidal and noncuspidal manipulators", ICRA 1997).
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.cuspidality.aspects import aspect_of
from chainrule.cuspidality.normal_form import Regional
from chainrule.cuspidality.singular_curves import singular_curves

Array = NDArray[Any]

#: Samples of a singular curve on either side of a cusp, and places along both sides of a grid over the cross-section.
BESIDE, GRID = 60, 64
#: Where floating point decides no place, every so many are decided exactly (no divisor of the two above).
THINNED = 17
#: Postures nearer than this in every joint (rad) are not told apart.
APART = 1e-6


@dataclass(frozen=True)
class Example:
    """A point that an arm can reach in two postures of one aspect.

    Attributes:
        section: (2,) its rho and z in m.
        postures: (2, 3) rad, the two postures, of the arm's own joints.
        sign: of det J in both.
    """

    section: Array
    postures: Array
    sign: int

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {"section": self.section.tolist(), "postures": self.postures.tolist(), "sign": self.sign}


def example(regional: Regional, cusps: Array) -> Example | None:
    """The best of many points for a change of posture: two postures in one aspect, far from singularities.

    Three postures meet in a cusp, and the outer two of them share an aspect beside it: in the wedge, often a thin one,
    between the two branches of the singular curve's image. So points halfway between both branches are tried, and a
    grid over the cross-section. None where no point has two postures in one aspect; also where double precision does
    not tell such postures from singular ones, as of a cuspidal arm with a length of 1e-9 of the others.

    Args:
        regional: the arm.
        cusps: (k, 2) rho and z of its cusps.
    """
    reach = regional.size
    rho, z = np.meshgrid(np.linspace(0.0, reach, GRID + 1)[1:], np.linspace(-reach, reach, GRID))
    places = np.concatenate([np.stack([rho.ravel(), z.ravel()], axis=-1), *_in_wedges(regional, cusps)])
    places = places[places[:, 0] > 0.0]
    points = np.stack([places[:, 0], np.zeros(len(places)), places[:, 1]], axis=-1)
    found = _best(regional, points, exactly=False)  # the best place is far from what floating point leaves open
    return found or (_best(regional, points[::THINNED], exactly=True) if len(cusps) else None)


def _best(regional: Regional, points: Array, *, exactly: bool) -> Example | None:
    """Of ``points`` (k, 3) the one whose two postures in one aspect have the largest least |det J|."""
    theta = regional.section_postures(points, exactly=exactly)
    labels = aspect_of(regional, regional.from_normal(theta))
    size = np.abs(regional.determinant(theta[..., 1], theta[..., 2]))
    best, found = 0.0, None
    for i, j in combinations(range(theta.shape[1]), 2):
        alike = (labels[:, i] == labels[:, j]) & (labels[:, i] >= 0)
        alike &= 2.0 * np.abs(np.sin((theta[:, i] - theta[:, j]) / 2.0)).max(axis=-1) > APART
        least = np.where(alike, np.minimum(size[:, i], size[:, j]), 0.0)
        place = int(least.argmax())
        if least[place] > best:
            best, found = float(least[place]), (place, i, j)
    if found is None:
        return None
    place, i, j = found
    pair = theta[place, [i, j]]
    sign = int(np.sign(regional.determinant(pair[0, 1], pair[0, 2])))
    return Example(points[place, [0, 2]], regional.from_normal(pair), sign)


def _in_wedges(regional: Regional, cusps: Array) -> list[Array]:
    """Points (k, 2) halfway between the branches of singular curves that meet in each cusp."""
    images = [curve.image[:-1] for curve in singular_curves(regional) if not curve.line]
    found = []
    for cusp in np.asarray(cusps, float).reshape(-1, 2):
        nearest = [int(np.hypot(*(image - cusp).T).argmin()) for image in images]
        _, k = min(
            (float(np.hypot(*(image[i] - cusp))), k) for k, (image, i) in enumerate(zip(images, nearest, strict=True))
        )
        steps = np.arange(1, BESIDE + 1)
        before, after = (images[k][(nearest[k] + side * steps) % len(images[k])] for side in (-1, 1))
        found.append((0.5 * (before[:, None] + after[None, :])).reshape(-1, 2))
    return found
