"""Evaluators as NumPy functions: shapes, types, strides, out=, refusals, threads."""

from __future__ import annotations

import copy
import ctypes
import pickle
import threading
from concurrent.futures import ThreadPoolExecutor

import arms_under_test as under
import mpmath
import numpy as np
import pytest
from numpy.lib.stride_tricks import as_strided

import chainrule as cr

ARM = under.ARMS["panda"]
FAMILY = under.ARMS["planar_3r"]
Q = under.random_q(ARM, 70, 1)
JACOBIAN = ARM.jacobian(Q)


def both():
    """A compiled evaluator and the same function in NumPy code, which must behave alike."""
    return [
        pytest.param(ARM.evaluator("jacobian_pose"), id="compiled"),
        pytest.param(under.numpy_evaluators("panda", "kinematics")["jacobian_pose"], id="numpy"),
    ]


# ---- shapes ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("jacobian", both())
@pytest.mark.parametrize("leading", [(), (1,), (7,), (70,), (5, 2, 7), (5, 1, 7), (7, 10)])
def test_leading_axes(jacobian, leading):
    count = int(np.prod(leading))
    q = Q[:count].reshape(*leading, 7)
    found = jacobian(q)
    assert found.shape == (*leading, 6, 7) and found.dtype == np.float64
    assert np.abs(found - JACOBIAN[:count].reshape(*leading, 6, 7)).max() < 1e-14


@pytest.mark.parametrize("jacobian", both())
@pytest.mark.parametrize("shape", [(0, 7), (3, 0, 7), (0, 5, 7)])
def test_no_configurations(jacobian, shape):
    found = jacobian(np.empty(shape))
    assert found.shape == (*shape[:-1], 6, 7)
    assert jacobian(np.empty(shape, np.float32)).dtype == np.float32


def test_scalar_results():
    assert np.ndim(ARM.manipulability(Q[0])) == 0
    assert ARM.manipulability(Q[0]).dtype == np.float64
    assert ARM.manipulability(Q.reshape(7, 10, 7)).shape == (7, 10)
    h, *gradients = ARM.evaluator("manipulability_gradient_pose")(Q)
    assert h.shape == (70,) and [g.shape for g in gradients] == [(70, 7)] * 3


def test_lists_and_tuples():
    assert np.array_equal(ARM.position([0.5] * 7), ARM.position(np.full(7, 0.5)))
    assert np.array_equal(ARM.position(((0.5,) * 7,) * 2), ARM.position(np.full((2, 7), 0.5)))


def test_family_parameters_broadcast():
    """Through evaluator() the lengths of a family are an input like q: a grid of arms in one call."""
    position = FAMILY.evaluator("position")
    q = under.random_q(FAMILY, 5, 2)
    lengths = np.random.default_rng(3).uniform(0.1, 1, (4, 1, 3))
    found = position(q, lengths)
    assert found.shape == (4, 5, 2)
    for i in range(4):
        assert np.array_equal(found[i], cr.planar_3r(*lengths[i, 0]).position(q))
    assert position(q[0], lengths).shape == (4, 1, 2)
    assert position(np.empty((0, 3)), lengths).shape == (4, 0, 2)


def test_family_members_do_not_share_numbers():
    a, b = cr.planar_3r(1.0, 0.5, 0.25), cr.planar_3r(2.0, 1.0, 0.5)
    q = under.random_q(a, 70, 4)
    assert np.array_equal(b.position(q), 2 * a.position(q))
    with pytest.raises(ValueError, match="read-only"):
        a.parameters[0] = 3.0


# ---- types -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("jacobian", both())
@pytest.mark.parametrize("real", [np.float16, np.int8, np.uint16, np.int64, np.bool_])
def test_other_numbers_become_double(jacobian, real):
    q = np.array([[0, 1, 1, 0, 1, 0, 1], [1, 0, 1, 1, 1, 1, 0]]).astype(real)
    found = jacobian(q)
    assert found.dtype == np.float64
    assert np.array_equal(found, jacobian(q.astype(np.float64)))


@pytest.mark.parametrize("jacobian", both())
def test_float_stays_float(jacobian):
    found = jacobian(Q.astype(np.float32))
    assert found.dtype == np.float32
    assert np.abs(found - JACOBIAN).max() < 4e-6


def test_float_family_stays_float():
    """The lengths of a family follow the type of q."""
    for method in (FAMILY.position, FAMILY.jacobian, FAMILY.manipulability, FAMILY.manipulability_gradient):
        assert method(np.zeros((9, 3), np.float32) + np.float32(0.3)).dtype == np.float32
        assert method(np.zeros((9, 3)) + 0.3).dtype == np.float64


def test_other_byte_order():
    assert np.array_equal(ARM.jacobian(Q.astype(">f8")), JACOBIAN)


# ---- strides ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("jacobian", both())
@pytest.mark.parametrize(
    "strided",
    [
        lambda q: np.asfortranarray(q),
        lambda q: q[::-1][::-1],
        lambda q: np.ascontiguousarray(q[::-1])[::-1],
        lambda q: np.ascontiguousarray(q[:, ::-1])[:, ::-1],
        lambda q: np.repeat(q, 3, axis=0)[::3],
        lambda q: np.repeat(q, 2, axis=1)[:, ::2],
        lambda q: np.ascontiguousarray(q.T).T,
        lambda q: np.pad(q, ((2, 1), (3, 5)))[2:-1, 3:-5],
        lambda q: np.stack([q, q], axis=-1)[..., 1],
        lambda q: np.frombuffer(b"x" + q.tobytes(), np.uint8)[1:].view(np.float64).reshape(q.shape),
    ],
    ids=[
        "fortran",
        "twice",
        "backwards",
        "columns backwards",
        "rows apart",
        "columns apart",
        "transposed",
        "window",
        "interleaved",
        "unaligned",
    ],
)
def test_any_strides(jacobian, strided):
    q = strided(Q)
    assert np.array_equal(q, Q)
    assert np.array_equal(jacobian(q), jacobian(Q))


def test_repeated_by_stride_zero():
    q = as_strided(Q[5], (70, 7), (0, 8))
    assert np.array_equal(ARM.jacobian(q), np.broadcast_to(ARM.jacobian(np.tile(Q[5], (70, 1)))[0], (70, 6, 7)))


# ---- out= ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("jacobian", both())
@pytest.mark.parametrize(
    "target",
    [
        lambda: np.empty((70, 6, 7)),
        lambda: np.asfortranarray(np.empty((70, 6, 7))),
        lambda: np.empty((7, 6, 70)).T,
        lambda: np.empty((70, 7, 6)).swapaxes(1, 2),
        lambda: np.empty((70, 6, 7))[::-1],
        lambda: np.empty((70, 12, 14))[:, ::2, ::-2],
    ],
    ids=["plain", "fortran", "transposed", "axes swapped", "backwards", "apart"],
)
def test_out(jacobian, target):
    out = target()
    assert jacobian(Q, out=out) is out
    assert np.array_equal(out, jacobian(Q))


def test_out_of_a_method():
    out = np.empty((70, 7))
    for criterion in ("H", "1/H", "H^(-1/2)"):
        assert ARM.manipulability_gradient(Q, criterion=criterion, out=out) is out
        assert np.array_equal(out, ARM.manipulability_gradient(Q, criterion=criterion))
    pose, jacobian = np.empty((70, 4, 4)), np.empty((70, 6, 7))
    found = ARM.kinematics(Q, out=(pose, jacobian))
    assert found[0] is pose and found[1] is jacobian
    h = np.empty(70)
    assert ARM.manipulability(Q, out=h) is h


def test_float_into_double_and_back():
    """NumPy's rule for universal functions: out may be wider; a narrower one is refused."""
    wide = np.empty((70, 6, 7))
    ARM.jacobian(Q.astype(np.float32), out=wide)
    assert np.abs(wide - JACOBIAN).max() < 4e-6
    narrow = np.empty((70, 6, 7), np.float32)
    ARM.jacobian(Q, out=narrow)
    assert np.abs(narrow - JACOBIAN).max() < 1e-6


def read_only():
    out = np.empty((70, 6, 7))
    out.flags.writeable = False
    return out


@pytest.mark.parametrize("jacobian", both())
@pytest.mark.parametrize(
    "out",
    [
        np.empty((70, 7, 6)),
        np.empty((69, 6, 7)),
        np.empty((2, 6, 7)),
        np.empty(70),
        np.empty((70, 6, 7), int),
        read_only(),
        [[0.0]],
        "out",
        (np.empty((70, 6, 7)),) * 2,
    ],
    ids=["transposed", "too short", "wrong", "flat", "integers", "read-only", "list", "text", "two"],
)
def test_wrong_out_is_refused(jacobian, out):
    with pytest.raises(cr.InputError, match="out does not fit") as caught:
        jacobian(Q, out=out)
    assert "(70, 6, 7)" in under.one_line(caught.value)


def test_out_may_overlap_the_input():
    """As with any universal function the result is as if the input had been copied first."""
    q = Q.copy()
    expected = ARM.null_vector(q)
    ARM.null_vector(q, out=q)
    assert np.array_equal(q, expected)
    whole = np.zeros((71, 7))
    whole[:70] = Q
    ARM.null_vector(whole[:70], out=whole[1:])
    assert np.array_equal(whole[1:], expected)


# ---- refusals --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("jacobian", both())
@pytest.mark.parametrize(
    "q",
    [
        np.zeros(6),
        np.zeros((7, 6)),
        np.zeros((70, 8)),
        0.0,
        [],
        None,
        "0.1",
        ["a"] * 7,
        [1j] * 7,
        [None] * 7,
        [object()] * 7,
        [[0.0] * 7, [0.0] * 6],
        np.zeros(7, "M8[s]"),
        {"q": 1},
    ],
    ids=[
        "short",
        "columns",
        "long",
        "number",
        "empty",
        "none",
        "text",
        "texts",
        "complex",
        "nones",
        "objects",
        "ragged",
        "dates",
        "dict",
    ],
)
def test_wrong_input_is_refused_in_one_line(jacobian, q):
    with pytest.raises(cr.InputError, match="jacobian_pose: ") as caught:
        jacobian(q)
    assert "accepted" in under.one_line(caught.value)


def test_wrong_number_of_inputs():
    for evaluator, given in (
        (FAMILY.evaluator("position"), [np.zeros(3)]),
        (ARM.evaluator("position"), [Q, Q]),
        (ARM.evaluator("position"), []),
    ):
        with pytest.raises(cr.InputError, match="it takes") as caught:
            evaluator(*given)
        under.one_line(caught.value)


def test_leading_axes_that_do_not_fit():
    with pytest.raises(cr.InputError, match="broadcast") as caught:
        FAMILY.evaluator("position")(np.zeros((4, 3)), np.zeros((5, 3)))
    under.one_line(caught.value)


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: ARM.jacobian(Q, task="x_alpha"), "position, pose are accepted"),
        (lambda: FAMILY.jacobian([0, 0, 0], task="orientation"), "position, x_alpha, pose are accepted"),
        (lambda: ARM.manipulability_gradient(Q, criterion="w"), "H, 1/H"),
        (lambda: under.ARMS["puma560"].null_vector(np.zeros(6)), "one joint more"),
        (lambda: under.ARMS["puma560"].null_projector(np.zeros(6)), "no null space"),
        (lambda: under.ARMS["planar_3r"].null_projector(np.zeros(3), task="pose"), "no null space"),
        (lambda: under.ARMS["orthogonal_3r_fig2a"].manipulability(np.zeros(3), task="pose"), "6 rows for 3 joints"),
        (lambda: ARM.evaluator("dance"), "it has "),
    ],
)
def test_questions_without_an_answer(call, said):
    with pytest.raises(cr.InputError) as caught:
        call()
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


# ---- numbers without meaning, and large ones -------------------------------------------------------------------


@pytest.mark.parametrize("jacobian", both())
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("real", [np.float64, np.float32])
def test_not_finite_stays_with_its_own(jacobian, bad, real):
    """Inside a tile, at its edges and in the rest; nothing warns."""
    q = Q.astype(real)
    clean = jacobian(q)
    for place in (0, 5, 31, 63, 64, 69):
        q[place, 2] = bad
    found = jacobian(q)
    touched = np.isin(np.arange(70), (0, 5, 31, 63, 64, 69))
    assert np.array_equal(found[~touched], clean[~touched])
    assert np.all(np.isnan(found[touched][:, :, 0]).any(axis=1))


@pytest.mark.parametrize("size", [1e3, 1e6, 1e15, 1e300])
def test_large_angles(size):
    """An angle is its double's exact value, however many turns: still 1e-15 of the largest entry."""
    q = np.random.default_rng(7).uniform(-size, size, (70, 7))
    found = ARM.pose(q)
    for k in (0, 40, 69):
        with mpmath.workdps(400):
            exact = under.reference.pose(ARM.description, [float(x) for x in q[k]], 400)
        assert np.abs(found[k] - np.array(exact.tolist(), float)).max() < 1e-15


def test_whole_turns_make_no_difference():
    q = Q.copy()
    turned = q + 2 * np.pi * np.random.default_rng(8).integers(-3, 4, q.shape)
    assert np.abs(ARM.jacobian(turned) - ARM.jacobian(q)).max() < 1e-13


@pytest.mark.parametrize("count", [1000, 4099, 100_001])
def test_large_batches(count):
    q = np.tile(Q, (count // 70 + 1, 1))[:count]
    found = ARM.position(q)
    assert np.abs(found - np.tile(ARM.position(Q), (count // 70 + 1, 1))[:count]).max() < 1e-15


# ---- bind, copies, threads -------------------------------------------------------------------------------------


@pytest.mark.parametrize("real", [np.float64, np.float32])
def test_bind(real):
    q, jacobian = np.zeros(7, real), np.empty((6, 7), real)
    evaluate = ARM.evaluator("jacobian_pose").bind(q, jacobian)
    for k in range(3):
        q[:] = Q[k]
        assert evaluate() is None
        assert np.array_equal(jacobian, ARM.jacobian(q[None])[0])


def test_bind_strided_and_several():
    gradient = ARM.evaluator("manipulability_gradient_pose")
    store = np.zeros((7, 4))
    q, outputs = store[:, 1], [np.empty(()), np.empty((3, 7))[1], np.empty(7)[::-1], np.empty(14)[::2]]
    evaluate = gradient.bind(q, *outputs)
    q[:] = Q[1]
    evaluate()
    for found, expected in zip(outputs, gradient(Q[1]), strict=True):
        assert np.array_equal(found, expected)


def test_bind_in_numpy_code():
    q, jacobian = np.array(Q[2]), np.empty((6, 7))
    evaluate = under.numpy_evaluators("panda", "kinematics")["jacobian_pose"].bind(q, jacobian)
    assert evaluate() is None
    assert np.abs(jacobian - JACOBIAN[2]).max() < 1e-15


def test_bind_keeps_its_arrays():
    q, jacobian = np.array(Q[3]), np.empty((6, 7))
    evaluate = ARM.evaluator("jacobian_pose").bind(q, jacobian)
    del q
    evaluate()
    assert np.abs(jacobian - JACOBIAN[3]).max() < 1e-15
    with pytest.raises(TypeError):
        evaluate(1)


@pytest.mark.parametrize(
    "arrays",
    [
        (np.zeros(7),),
        (np.zeros(6), np.zeros((6, 7))),
        (np.zeros(7), np.zeros((7, 6))),
        ([0.0] * 7, np.zeros((6, 7))),
        (np.zeros(7), np.zeros((6, 7), np.float32)),
        (np.zeros(7, int), np.zeros((6, 7), int)),
        (np.zeros(7), np.broadcast_to(np.zeros(7), (6, 7))),
    ],
    ids=["one", "short", "transposed", "list", "mixed", "integers", "read-only"],
)
def test_bind_refuses(arrays):
    with pytest.raises(cr.InputError, match="jacobian_pose: ") as caught:
        ARM.evaluator("jacobian_pose").bind(*arrays)
    under.one_line(caught.value)


@pytest.mark.parametrize(
    "again", [copy.copy, copy.deepcopy, lambda arm: pickle.loads(pickle.dumps(arm))], ids=["copy", "deepcopy", "pickle"]
)
@pytest.mark.parametrize("arm", [ARM, FAMILY], ids=lambda arm: arm.name)
def test_copies(arm, again):
    q = under.random_q(arm, 3, 9)
    expected = arm.jacobian(q)  # evaluators are loaded
    twin = again(arm)
    assert twin.description == arm.description
    assert np.array_equal(twin.jacobian(q), expected)


def test_with_limits_is_another_arm():
    narrow = ARM.with_limits(velocity=[1.0] * 7)
    assert np.array_equal(narrow.limits.velocity, np.ones(7)) and ARM.limits.velocity[0] != 1.0
    assert np.array_equal(narrow.pose(Q), ARM.pose(Q))


def test_threads_give_the_same_results():
    fresh = cr.load("panda")  # nothing of it is loaded yet: the threads race for that too
    chunks = [under.random_q(ARM, 500, seed) for seed in range(24)]
    with ThreadPoolExecutor(8) as pool:
        found = list(pool.map(lambda q: (fresh.jacobian(q), fresh.manipulability_gradient(q)), chunks))
    for q, (jacobian, gradient) in zip(chunks, found, strict=True):
        assert np.array_equal(jacobian, ARM.jacobian(q))
        assert np.array_equal(gradient, ARM.manipulability_gradient(q))


def test_the_gil_is_released(tmp_path):
    """While one thread is inside a kernel another runs Python: a kernel that waits for a flag only Python sets."""
    from chainrule import _gufunc

    flag = (ctypes.c_int * 1)()

    @ctypes.CFUNCTYPE(None, ctypes.c_ssize_t, ctypes.c_void_p, ctypes.c_void_p)
    def waits(count, args, steps):  # takes the GIL when called: it must have been released, or this hangs
        entered.set()
        assert released.wait(60)
        flag[0] = 1

    entered, released = threading.Event(), threading.Event()
    address = ctypes.cast(waits, ctypes.c_void_p).value
    function = _gufunc.make("waits", "waits", "(1)->(1)", 1, 1, address, address, waits)
    thread = threading.Thread(target=function, args=(np.zeros((4, 1)),))
    thread.start()
    assert entered.wait(60)  # the other thread is inside the kernel, and this one runs
    released.set()
    thread.join(60)
    assert flag[0] == 1 and not thread.is_alive()


def test_a_deleted_arm_leaves_its_functions_usable():
    function = cr.load("panda").evaluator("position").function
    assert np.array_equal(function(Q), ARM.position(Q))
    assert function.signature == "(7)->(3)"
    assert "position" in function.__doc__
