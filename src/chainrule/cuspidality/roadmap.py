"""A roadmap of an arm's nonsingular joint space: many configurations, joined where the straight way keeps det J's sign.

A probabilistic roadmap (L. E. Kavraki, P. Svestka, J.-C. Latombe and M. H. Overmars 1996) with det J = 0 as the obstacle.
Only the joints that det J depends on are sampled: the first and the last joint of an arm have no part in it. Angles without
limits live on a circle, so every distance is the shorter way round. Its components tell which parts of the joint space
are surely joined (as far as samples along the edges can see); two parts that it leaves apart may still be joined.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chainrule.arm import Arm
from chainrule.goals import wrapped

Array = NDArray[Any]

#: Configurations in the roadmap, neighbours of each, and the points looked at along an edge.
NODES, NEIGHBOURS, PLACES = 12_000, 14, 24
#: Neighbours that a posture asked about is joined to.
REACH = 40
#: Edges keep |det J| above this share of its median.
MARGIN = 1e-2


@dataclass(frozen=True)
class JointSpace:
    """Where the joints may be, and the part of them that det J depends on.

    Attributes:
        arm: the arm.
        lower: (6,) rad; of joints that turn freely -pi.
        upper: (6,) rad; of joints that turn freely pi.
        free: (6,) whether an angle and the same angle plus a turn are one.
        used: the joints that det J depends on.
        scale: the median of |det J|.
    """

    arm: Arm
    lower: Array
    upper: Array
    free: Array
    used: tuple[int, ...]
    scale: float

    def way(self, a: Array, b: Array) -> Array:
        """The displacement (..., 6) from configurations a to b: the shorter way round for joints that turn freely."""
        return np.where(self.free, wrapped(b - a), b - a)

    def determinant(self, q: Array) -> Array:
        """det J (...)."""
        found: Array = self.arm.minors(q, task="pose")[..., 0]
        return found

    def least(self, a: Array, b: Array, places: int = PLACES) -> Array:
        """The least det J times its sign at a (k,) on the straight ways from a to b (k, 6), by samples."""
        share = np.linspace(0.0, 1.0, places)[:, None]
        found = self.determinant(a[:, None] + share * self.way(a, b)[:, None])
        least: Array = (found * np.sign(found[:, :1])).min(axis=-1)
        return least


@dataclass(frozen=True)
class Roadmap:
    """Configurations and the edges between them.

    Attributes:
        space: the joint space.
        q: (m, 6) rad; joints that det J does not depend on at the middle of their range.
        sign: (m,) of det J.
        edges: (e, 2) which configurations are joined.
        lengths: (e,) their lengths, weighted with how small |det J| is on them.
        component: (m,) which are joined by some way.
    """

    space: JointSpace
    q: Array
    sign: Array
    edges: Array
    lengths: Array
    component: Array

    def connect(self, postures: Array) -> tuple[Array, Array, Array]:
        """Edges (e, 2) from postures (k, 6), counted on from m, to the roadmap and between them; their lengths.

        Third, the roadmap's component of each posture, -1 where it could not be joined.
        """
        m, k = len(self.q), len(postures)
        used, sign = list(self.space.used), np.sign(self.space.determinant(postures))
        edges = [np.array([(m + i, m + j) for i in range(k) for j in range(i) if sign[i] == sign[j]]).reshape(-1, 2)]
        for s in (-1.0, 1.0):
            nodes, asked = np.flatnonzero(self.sign == s), np.flatnonzero(sign == s)
            if len(nodes) and len(asked):
                near = (
                    _tree(self.space, self.q[nodes])
                    .query(_on_circle(self.space, postures[asked])[:, used], min(REACH, len(nodes)))[1]
                    .reshape(len(asked), -1)
                )
                edges.append(np.stack([np.repeat(m + asked, near.shape[1]), nodes[near].ravel()], axis=-1))
        pairs = np.concatenate(edges).astype(int)
        every = np.concatenate([self.q, postures])
        pairs, lengths = _open(self.space, every, pairs)
        component = np.full(k, -1)
        inner = pairs[:, 1] < m
        component[pairs[inner, 0] - m] = self.component[pairs[inner, 1]]
        return pairs, lengths, component

    def ways(self, postures: Array, pairs: Sequence[tuple[int, int]], extra: tuple[Array, Array]) -> list[Array]:
        """The shortest ways between pairs of postures: (p, 6) each, unwrapped from the first posture on.

        ``extra`` are the edges and lengths that :meth:`connect` found. Pairs that are not joined have none.
        """
        from scipy.sparse import csr_array
        from scipy.sparse.csgraph import dijkstra

        m, every = len(self.q), np.concatenate([self.q, postures])
        edges = np.concatenate([self.edges, extra[0]])
        lengths = np.concatenate([self.lengths, extra[1]])
        graph = csr_array((lengths, edges.T), shape=(len(every), len(every)))
        starts = sorted({i for i, _ in pairs})
        _, before = dijkstra(graph, directed=False, indices=[m + i for i in starts], return_predecessors=True)
        found = []
        for i, j in pairs:
            row, at, nodes = before[starts.index(i)], m + j, [m + j]
            while at != m + i and row[at] >= 0:
                at = int(row[at])
                nodes.append(at)
            if at == m + i:
                found.append(self._unwrapped(every[nodes[::-1]]))
        return found

    def _unwrapped(self, q: Array) -> Array:
        """Via points with the joints that det J does not depend on moved evenly from the start to the goal."""
        steps = self.space.way(q[:-1], q[1:])
        idle = [j for j in range(q.shape[1]) if j not in self.space.used]
        length = np.linalg.norm(steps[:, list(self.space.used)], axis=-1) + 1e-12
        share = length / length.sum()
        steps[:, idle] = share[:, None] * self.space.way(q[0], q[-1])[idle]
        return np.concatenate([q[:1], q[0] + np.cumsum(steps, axis=0)])


def roadmap(space: JointSpace, seed: int = 0, nodes: int = NODES) -> Roadmap:
    """The roadmap of ``nodes`` random configurations, the same for the same seed."""
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import connected_components

    rng, used = np.random.default_rng(seed), list(space.used)
    q = np.tile(0.5 * (space.lower + space.upper), (nodes, 1))
    q[:, used] = rng.uniform(space.lower[used], space.upper[used], (nodes, len(used)))
    det = space.determinant(q)
    q, sign = q[np.abs(det) > MARGIN * space.scale], np.sign(det[np.abs(det) > MARGIN * space.scale])
    pairs = []
    for s in (-1.0, 1.0):
        part = np.flatnonzero(sign == s)
        if len(part) > 1:
            near = _tree(space, q[part]).query(_on_circle(space, q[part])[:, used], min(NEIGHBOURS + 1, len(part)))[1]
            pairs.append(np.stack([np.repeat(part, near.shape[1] - 1), part[near[:, 1:]].ravel()], axis=-1))
    candidates = np.concatenate(pairs) if pairs else np.empty((0, 2), int)
    edges, lengths = _open(space, q, np.unique(np.sort(candidates, axis=1), axis=0))
    graph = csr_array((lengths, edges.T), shape=(len(q), len(q)))
    return Roadmap(space, q, sign, edges, lengths, connected_components(graph, directed=False)[1])


def _open(space: JointSpace, q: Array, pairs: Array) -> tuple[Array, Array]:
    """Those of the pairs (e, 2) whose straight way keeps the sign of det J, and their weighted lengths."""
    if not len(pairs):
        return pairs, np.empty(0)
    least = space.least(q[pairs[:, 0]], q[pairs[:, 1]]) / space.scale
    kept = least > MARGIN
    ends = q[pairs[kept]][:, :, list(space.used)]
    step = np.where(space.free[list(space.used)], wrapped(ends[:, 1] - ends[:, 0]), ends[:, 1] - ends[:, 0])
    return pairs[kept], np.linalg.norm(step, axis=-1) * (1.0 + 0.2 / np.minimum(least[kept], 1.0)) + 1e-9


def _on_circle(space: JointSpace, q: Array) -> Array:
    """Free angles in [0, 2 pi), as the tree wants them."""
    return np.where(space.free, np.remainder(q, 2.0 * math.pi) % (2.0 * math.pi), q)


def _tree(space: JointSpace, q: Array) -> Any:
    from scipy.spatial import cKDTree

    used = list(space.used)
    return cKDTree(_on_circle(space, q)[:, used], boxsize=np.where(space.free[used], 2.0 * math.pi, 0.0))
