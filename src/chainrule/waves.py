r"""H^2 as a finite sum of waves, with coefficients known to 60 digits and more.

    S(x) = H^2 = sum_k A_k cos(k . x) + B_k sin(k . x),   k integer vectors,   x the angles of the revolute joints

Every maximal minor is a trigonometric polynomial in each joint angle, of degree 1 for planar arms and 2 for spatial
ones: turning joint j moves the columns before it as diag(R, 1) acts on a planar twist (v_x, v_y; w), and as
diag(R, 1, R, 1) on a spatial one, R a rotation of the plane; products of different eigenvalues of these (which is what
minors are made of) hold exp(i q) at most once and at most twice. So as many values as a polynomial has coefficients
determine it: the generated function is evaluated there in ball arithmetic, and the coefficients follow by a discrete
Fourier transform in balls. Squares and sums of the minors (Cauchy-Binet) are then taken of the coefficients.

A minor of a planar arm is affine in each slide of a prismatic joint, so S is convex in it: over a range, S is largest
at one of its two ends.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.balls import Minors, above

Array = NDArray[Any]
Spectrum = dict[tuple[int, ...], Any]

#: No more values of the minors than this are taken, and no more products of their coefficients.
MOST_SAMPLES, MOST_PRODUCTS = 40_000, 300_000

#: Share of the sum of all amplitudes that is not worth a wave of its own: it becomes part of the error.
NEGLIGIBLE = 1e-18


@dataclass(frozen=True)
class Waves:
    """S / scale as a sum of waves in doubles, and how far that is from the truth.

    Attributes:
        back: (a, joints) integers: the joint angles are x @ back.
        frequencies: (t, a) the vectors k.
        cosine, sine: (t,) the coefficients A_k and B_k.
        constant: the mean.
        steepest: the largest |k|_1 of all waves, also of those left out: derivatives of errors grow by no more.
        error: |S / scale - sum of waves| is no larger, whatever x: what was left out, and all rounding.
        scale: S in these units, a ball of radius zero.
        folded: the part of the error that is waves left out.
        whole: whether nothing was left out but rounding, so that coordinates without waves do not matter at all.
    """

    back: Array
    frequencies: Array
    cosine: Array
    sine: Array
    constant: float
    steepest: float
    error: float
    folded: float
    scale: Any
    whole: bool

    @property
    def size(self) -> int:
        """Number of coordinates."""
        return int(self.frequencies.shape[1])

    @property
    def amplitude(self) -> Array:
        """(t,) the waves' amplitudes."""
        found: Array = np.hypot(self.cosine, self.sine)
        return found

    def expanded(self, x: Array) -> tuple[Array, Array, Array]:
        """Value (m,), gradient (m, a) and Hessian (m, a, a) of the sum of waves at x (m, a)."""
        k, a = self.frequencies, self.size
        turn = x @ k.T
        c, s = np.cos(turn), np.sin(turn)
        waves = c * self.cosine + s * self.sine
        pairs = (k[:, :, None] * k[:, None, :]).reshape(len(k), a * a)
        gradient = (c * self.sine - s * self.cosine) @ k
        return waves.sum(axis=1) + self.constant, gradient, -(waves @ pairs).reshape(len(x), a, a)


def spectra(minors: Minors, posture: Array, joints: Sequence[int], degree: int) -> list[Spectrum] | None:
    """The Fourier coefficients (complex balls) of every minor in some angles, the other joints at ``posture``.

    None where that would take too many values.

    Args:
        minors: maps balls (k, n) to balls (k, number of minors).
        posture: (n,) balls.
        joints: revolute joints, from 0.
        degree: of the minors in each of these angles.
    """
    from flint import acb, arb

    a, points = len(joints), 2 * degree + 1
    if points**a * minors(posture[None, :]).shape[1] > MOST_SAMPLES:
        return None
    angles = [2 * arb.pi() * m / points for m in range(points)]
    q = np.tile(posture, (points**a, 1))
    for row, choice in enumerate(product(range(points), repeat=a)):
        for joint, m in zip(joints, choice, strict=True):
            q[row, joint] = angles[m]
    values = minors(q)
    transform = np.empty((points, points), object)
    for f, m in product(range(points), repeat=2):
        turn = angles[((f - degree) * m) % points]
        transform[f, m] = acb(turn.cos(), -turn.sin()) / points
    found = []
    for column in values.T:
        tensor = column.reshape((points,) * a)
        for axis in range(a):
            tensor = np.moveaxis(np.tensordot(transform, tensor, axes=(1, axis)), 0, axis)
        found.append(
            {k: acb(tensor[tuple(f + degree for f in k)]) for k in product(range(-degree, degree + 1), repeat=a)}
        )
    return found


@dataclass(frozen=True)
class Square:
    """The coefficients of the sum of squares, for k = 0 and one of each pair k, -k.

    Attributes:
        spectrum: the coefficients, complex balls.
        left: bound on the waves left out, a ball.
        folded: the part of the error that is waves left out.
        whole: whether those may all be zero.
    """

    spectrum: Spectrum
    left: Any
    whole: bool


def square(found: Sequence[Spectrum]) -> Square | None:
    """The sum of the squares of the minors (Cauchy-Binet).

    None where it would take too many products.
    """
    from flint import acb, arb

    kept, left, whole = [], arb(0), True
    for spectrum in found:
        sizes = {k: value.abs_upper() for k, value in spectrum.items()}
        total = sum(sizes.values(), arb(0))
        small = {k for k, size in sizes.items() if size <= total * arb(2) ** -150}
        dropped = sum((sizes[k] for k in small), arb(0))
        whole = whole and all(_perhaps_zero(spectrum[k]) for k in small)
        left += 2 * total * dropped + dropped * dropped
        kept.append([(k, value) for k, value in spectrum.items() if k not in small])
    if sum(len(part) ** 2 for part in kept) > MOST_PRODUCTS:
        return None
    total_spectrum: Spectrum = {}
    for part in kept:
        for (k, one), (f, other) in product(part, repeat=2):
            key = tuple(i + j for i, j in zip(k, f, strict=True))
            if key >= tuple(-i for i in key):
                total_spectrum[key] = total_spectrum.get(key, acb(0)) + one * other
    return Square(total_spectrum, left, whole)


def _perhaps_zero(value: Any) -> bool:
    return bool(value.real.contains(0) and value.imag.contains(0))


def waves(found: Square, size: int, scale: Any, farthest: float, headings: bool) -> Waves:
    """The sum of waves of a spectrum, in units of ``scale``.

    Args:
        found: as :func:`square` gives it.
        size: number of angles.
        scale: the unit, a ball of radius zero, positive.
        farthest: the waves are evaluated where no |x_i| exceeds this.
        headings: whether x may be the sums of the angles up to each joint (headings of the links) where that decouples
            the coordinates better; only where all of them turn freely.
    """
    from flint import arb

    zero = (0,) * size
    named = [(k, 2 * value / scale) for k, value in found.spectrum.items() if k != zero]
    rough = sorted(named, key=lambda wave: float(abs(wave[1]).mid()))
    folded, error, kept = above(abs(found.left) / scale), 0.0, []
    whole = found.whole
    for k, value in rough:
        weight = above(abs(value))
        if weight == 0.0 or weight <= NEGLIGIBLE / max(1, len(rough)):
            folded += weight
            whole = whole and _perhaps_zero(value)
        else:
            error += above(value.real.rad() + value.imag.rad())
            kept.append((k, value))
    mean = found.spectrum[zero].real / scale if zero in found.spectrum else arb(0)
    error += above(mean.rad())
    vectors = np.array([wave[0] for wave in kept], float).reshape(len(kept), size)
    # A_k cos + B_k sin = Re(c exp(i k.x)) with c = A - i B
    cosine = np.array([float(value.real) for _, value in kept])
    sine = np.array([-float(value.imag) for _, value in kept])
    back = np.eye(size)
    steepest = max((float(np.abs(wave).sum()) for wave, _ in rough), default=1.0)
    if headings:  # x_i = q_1 + ... + q_i, so q_i = x_i - x_(i-1)
        differences = np.eye(size) - np.eye(size, k=-1)
        moved, weight = vectors @ differences, np.hypot(cosine, sine)
        if weight @ np.abs(moved).sum(axis=1) ** 2 < weight @ np.abs(vectors).sum(axis=1) ** 2:
            back, vectors, steepest = differences.T, moved, 2 * steepest
    used = (vectors != 0).any(axis=0)
    vectors = vectors[:, used]
    constant = float(mean)
    total = float(np.hypot(cosine, sine).sum()) + abs(constant)
    # Rounding of one evaluation, relative to the sum of the amplitudes: the coefficients (1 unit), k.x (a + 1 units of
    # |k|_1 |x|), sine and cosine (NumPy's tests allow 4 units; 16 are granted), their products and the sum (t + 4);
    # and of Taylor's polynomial along eigenvectors, relative to (1 + |k|_1 |d|)^2 of those amplitudes (2 a^3). What
    # ``square`` left out, 2^-150 of all, is far below, also where its waves are twice as steep as those kept.
    steps = (
        32
        + len(vectors)
        + 2 * vectors.shape[1] ** 3
        + (vectors.shape[1] + 1) * farthest * (float(np.abs(vectors).sum(axis=1).max()) if vectors.size else 0.0)
    )
    folded *= 1 + 1e-9
    error = folded + error * (1 + 1e-9) + total * steps * 2.0**-52
    return Waves(back[used], vectors, cosine, sine, constant, steepest, error, folded, scale, whole)


def unit_of(found: Sequence[Square]) -> Any:
    """A ball of radius zero near the sum of the amplitudes: the unit in which S is of size 1; 1 where S is zero."""
    from flint import arb

    total = max((sum((abs(value).mid() for value in s.spectrum.values()), arb(0)) for s in found), default=arb(0))
    return total.mid() if total.mid() > 0 else arb(1)
