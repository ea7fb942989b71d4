"""The tests' own reference is itself checked: against differences of poses and against a paper's determinant."""

import mpmath
import pytest
from reference import distance, jacobian, pose

from chainrule import arms
from chainrule.readers import read
from chainrule.readers.dh import from_dh
from chainrule.readers.families import orthogonal_3r, planar

PLANAR = planar("RPPR", [1.0, 0.5, 0.25, 0.3], [0.0, 0.7, -0.2, 0.0])
MIXED = from_dh(
    [("R", 0.3, 0.1, 0.2, 0.4), ("P", -0.5, 0.2, 0.1, 1.1), ("R", 1.2, -0.3, 0.4, -0.6)], tool=(0.1, 0.2, 0.3)
)


@pytest.mark.parametrize("arm", [PLANAR, MIXED, *map(read, map(arms.path, arms.names()))], ids=lambda arm: arm.name)
def test_jacobian_is_the_derivative_of_the_pose(arm):
    q = [mpmath.mpf(1) / (k + 2) * (-1) ** k for k in range(arm.n)]
    step = mpmath.mpf(10) ** -15
    with mpmath.workdps(50):
        found, frame = jacobian(arm, q, 50), pose(arm, q, 50)
        for i in range(arm.n):
            ahead, behind = list(q), list(q)
            ahead[i] += step
            behind[i] -= step
            rate = (pose(arm, ahead, 50) - pose(arm, behind, 50)) / (2 * step)
            spin = rate[: frame.rows - 1, : frame.rows - 1] * frame[: frame.rows - 1, : frame.rows - 1].T
            if frame.rows == 3:
                expected = [rate[0, 2], rate[1, 2], spin[1, 0]]
            else:
                expected = [*(rate[k, 3] for k in range(3)), spin[2, 1], spin[0, 2], spin[1, 0]]
            # A twist that is no quarter turn is orthonormal to rounding only, and so is what follows from it.
            assert distance(found[:, i], mpmath.matrix(expected)) < 1e-15


def test_determinant_of_the_orthogonal_arm():
    # Baili, Wenger and Chablat 2004, equation (1), with the factor d4 that it leaves out.
    d2, d3, d4, r2 = 1.0, 2.0, 1.5, 0.75
    arm = orthogonal_3r(d2, d3, d4, r2)
    for q in ((0.1, 0.2, 0.3), (-1.0, 2.0, -3.0), (2.5, -0.4, 1.7)):
        with mpmath.workdps(40):
            (c2, s2), (c3, s3) = ((mpmath.cos(angle), mpmath.sin(angle)) for angle in map(mpmath.mpf, q[1:]))
            expected = d4 * (d3 + c3 * d4) * (s3 * d2 + c2 * (s3 * d3 - c3 * r2))
            assert s2 != 0
            assert abs(abs(mpmath.det(jacobian(arm, q)[:3, :])) - abs(expected)) < 1e-35


def test_zero_pose_of_the_planar_arm():
    assert (
        distance(pose(planar("RRR", [1.0, 0.5, 0.25]), [0, 0, 0]), mpmath.matrix([[1, 0, 1.75], [0, 1, 0], [0, 0, 1]]))
        == 0
    )
