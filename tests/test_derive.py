"""The derivations themselves: closed forms proved, singular sets found, the steps' machinery, the lowering."""

from __future__ import annotations

import math
import random
from itertools import combinations, product

import arms_under_test as under
import mpmath
import numpy as np
import pytest
import sympy as sp

import chainrule as cr
from chainrule.derive import catalogue, chain, lower, manipulability, orthogonal_3r, planar, planar_3r
from chainrule.derive.program import GuardedInverse, Input, Output, Program, Steps, closed_form, evaluate, exact, needed
from chainrule.description import Transform

PLANAR = planar.planar_chain("RRR", ("l1", "l2", "l3"))
Q = PLANAR.inputs[0].symbols
L = PLANAR.inputs[1].symbols


def written_out(build, arm, *arguments):
    """The entries of a program's first output with every step substituted back."""
    found = build(arm, *arguments)
    return next(iter(closed_form(found).values()))


# ---- planar 3R: De Luca, exercise 1 ----------------------------------------------------------------------------


def vanishes(expression, angles):
    """Whether a polynomial in sines and cosines is identically zero: reduced by s^2 + c^2 = 1, nothing may be left."""
    expression = sp.expand_trig(expression)
    for k, angle in enumerate(angles):
        s, c = sp.symbols(f"s{k} c{k}")
        expression = expression.subs({sp.sin(angle): s, sp.cos(angle): c})
        expression = sp.rem(sp.expand(expression), s**2 + c**2 - 1, s)
    return sp.expand(expression) == 0


def test_vanishes_can_fail():
    x, y = sp.symbols("x y")
    assert vanishes(sp.sin(x + y) ** 2 + sp.cos(x + y) ** 2 - 1, (x, y))
    assert not vanishes(sp.sin(x + y) ** 2 - sp.cos(x + y) ** 2 - 1, (x, y))


def textbook_jacobian():
    """J of x = l1 c1 + l2 c12 + l3 c123, y likewise, differentiated by SymPy."""
    angles = [sum(Q[: i + 1]) for i in range(3)]
    position = [sum(length * f(angle) for length, angle in zip(L, angles, strict=True)) for f in (sp.cos, sp.sin)]
    return sp.Matrix(position).jacobian(Q)


def test_planar_3r_minors_are_those_of_the_jacobian():
    expected = [textbook_jacobian()[:, list(pair)].det() for pair in combinations(range(3), 2)]
    for build in (planar_3r.minors, lambda arm: under_general(arm)):
        for found, minor in zip(written_out(build, PLANAR), expected, strict=True):
            assert vanishes(found - minor, Q)


def under_general(arm):
    """The minors by the expansion that every arm without a closed form gets."""
    steps = Steps()
    return manipulability.minors_program(steps, arm.inputs, planar.minor_matrix(steps, arm, "position"), "position")


def test_planar_3r_manipulability_is_equation_1():
    """H^2 = (l1 (l2 s2 + l3 s23))^2 + (l3 (l1 s23 + l2 s3))^2 + (l2 l3 s3)^2: equal to det(J J^T), without q1."""
    l1, l2, l3 = L
    s2, s3, s23 = sp.sin(Q[1]), sp.sin(Q[2]), sp.sin(Q[1] + Q[2])
    paper = (l1 * (l2 * s2 + l3 * s23)) ** 2 + (l3 * (l1 * s23 + l2 * s3)) ** 2 + (l2 * l3 * s3) ** 2
    jacobian = textbook_jacobian()
    assert vanishes((jacobian * jacobian.T).det() - paper, Q)
    squares = sum(minor**2 for minor in planar_3r.closed_minors(PLANAR))
    assert vanishes(squares - paper, Q)
    assert Q[0] not in squares.free_symbols
    (found,) = written_out(lambda arm: manipulability.manipulability(planar_3r.minors(arm), "position"), PLANAR)
    assert vanishes(found**2 - paper, Q)


def test_planar_3r_singular_set():
    """Links in line: q2 and q3 each 0 or pi, and nothing else."""
    found = planar_3r.singular_set(PLANAR)
    assert {(pair[Q[1]], pair[Q[2]]) for pair in found} == set(product((0, sp.pi), repeat=2))
    h2 = sum(minor**2 for minor in planar_3r.closed_minors(PLANAR))
    for pair in found:
        assert sp.simplify(h2.subs(pair)) == 0


@pytest.mark.parametrize("lengths", [(1.0, 0.5, 0.25), (0.3, 0.9, 0.7), (1.0, 1.0, 1.0)])
def test_planar_3r_singular_nowhere_else(lengths):
    """On a grid over the torus H is small only beside the four configurations."""
    grid = np.linspace(-np.pi, np.pi, 181)
    q = np.stack(np.broadcast_arrays(0.0, grid[:, None], grid), axis=-1)
    h = cr.planar_3r(*lengths).manipulability(q)
    distance = np.hypot(*(np.abs(np.sin(q[..., k])) for k in (1, 2)))
    assert np.all(h[distance > 0.1] > 1e-3)
    assert h[distance < 1e-12].max() < 1e-15


# ---- orthogonal 3R: Baili, Wenger and Chablat ------------------------------------------------------------------


def test_orthogonal_determinant_is_equation_1():
    arm = orthogonal_3r.orthogonal_chain()
    d2, d3, d4, r2 = arm.inputs[1].symbols
    (c2, c3), (s2, s3) = (tuple(f(q) for q in arm.q[1:]) for f in (sp.cos, sp.sin))
    paper = (d3 + c3 * d4) * (s3 * d2 + c2 * (s3 * d3 - c3 * r2))
    entries = written_out(chain.jacobian, arm, "position")
    determinant = sp.Matrix(3, 3, entries).det()
    assert vanishes(determinant - d4 * paper, arm.q) or vanishes(determinant + d4 * paper, arm.q)
    assert vanishes(orthogonal_3r.determinant() - determinant, arm.q)
    assert s2 not in orthogonal_3r.determinant().atoms(sp.sin)
    factors = orthogonal_3r.determinant().as_ordered_factors()
    assert len([f for f in factors if not f.is_number]) == 3  # it is printed factored


def test_orthogonal_family_is_its_table():
    """The family's closed chain and the modified table of the paper give one arm."""
    d2, d3, d4, r2 = 1.0, 2.0, 1.5, 0.75
    rows = [("R", 0, 0, 0, 0), ("R", -np.pi / 2, d2, r2, 0), ("R", np.pi / 2, d3, 0, 0)]
    table, family = cr.Arm.from_dh(rows, tool=(d4, 0, 0), name="table3r"), cr.orthogonal_3r(d2, d3, d4, r2)
    q = under.random_q(family, 20, 1)
    for task in ("position", "pose"):
        for a, b in zip(table.kinematics(q, task=task), family.kinematics(q, task=task), strict=True):
            assert np.abs(a - b).max() < 4e-15


# ---- chains ----------------------------------------------------------------------------------------------------


def test_modified_and_standard_tables_agree():
    """A standard table is the modified one whose alpha and a moved one row on, with what is left as a tool."""
    rng = random.Random(3)
    rows = [
        (rng.choice("RP"), rng.uniform(-2, 2), *(rng.uniform(-0.5, 0.5) for _ in range(2)), rng.uniform(-2, 2))
        for _ in range(5)
    ]
    shifted = [
        (kind, *(rows[i - 1][1:3] if i else (0.0, 0.0)), d, theta) for i, (kind, _, _, d, theta) in enumerate(rows)
    ]
    last = Transform.rot_x(rows[-1][1]) @ Transform.shift(rows[-1][2], 0, 0)
    standard = cr.Arm.from_dh(rows, convention="standard")
    modified = cr.Arm.from_dh(shifted, tool=last)
    q = [rng.uniform(-2, 2) for _ in range(5)]
    for task in ("position", "pose"):
        a, b = (
            evaluate(chain.kinematics(catalogue.symbolic(arm.description.model), task), {"q": q})
            for arm in (standard, modified)
        )
        for name in a:
            assert max(abs(x - y) for x, y in zip(a[name], b[name], strict=True)) < 1e-15


@pytest.mark.parametrize("k", range(7))
def test_minors_do_not_depend_on_the_frame(k):
    """Seen from any link the minors of the pose Jacobian are those of the base frame."""
    arm = catalogue.symbolic(under.ARMS["panda"].description.model)
    q = [0.3, -0.7, 1.1, -1.9, 0.4, 2.1, -0.6]
    steps = Steps()
    matrix = chain._matrix_from(steps, arm, "pose", k)
    entries = Output("m", (6, 7), tuple(e for row in matrix for e in row))
    found = evaluate(Program("", "", arm.inputs, tuple(steps.steps), (entries,)), {"q": q})["m"]
    with mpmath.workdps(40):
        here = under.minors_of(mpmath.matrix(6, 7) + mpmath.matrix([found[i * 7 : i * 7 + 7] for i in range(6)]))
        base = under.minors_of(under.task_jacobian(under.ARMS["panda"].description, "pose", q))
        assert max(abs(x - y) for x, y in zip(here, base, strict=True)) < 1e-16  # the description's twists are rounded


@pytest.mark.parametrize(("m", "n"), [(1, 1), (2, 4), (3, 5), (4, 4), (5, 6), (6, 8)])
def test_maximal_minors_of_any_matrix(m, n):
    """Against mpmath's determinants, for matrices of integers with many zeros."""
    rng = random.Random(m * 10 + n)
    for _ in range(5):
        symbols = sp.symbols(f"a:{m * n}")
        numbers = [rng.choice((0, 0, 1, -2, 3, 7)) for _ in symbols]
        steps = Steps()
        matrix = [[symbols[i * n + j] if numbers[i * n + j] else sp.Integer(0) for j in range(n)] for i in range(m)]
        minors = manipulability.maximal_minors(steps, matrix)
        program = Program(
            "",
            "",
            (Input("a", (m * n,), symbols),),
            tuple(steps.steps),
            (Output("minors", (len(minors),), tuple(minors)),),
        )
        found = evaluate(program, {"a": numbers})["minors"]
        expected = under.minors_of(mpmath.matrix(m, n) + mpmath.matrix([numbers[i * n : i * n + n] for i in range(m)]))
        assert len(found) == math.comb(n, m)
        assert all(abs(x - y) < 1e-9 for x, y in zip(found, expected, strict=True))


def test_how_many_submatrices():
    """A 6 x 8 Jacobian has 28 minors and 246 sub-minors; a 6 x 10 too many."""
    assert manipulability.submatrices(6, 8) == 246
    assert manipulability.by_minors(6, 9) and not manipulability.by_minors(6, 10)


# ---- steps -----------------------------------------------------------------------------------------------------


def test_steps_name_each_thing_once():
    x, y = sp.symbols("x y", real=True)
    steps = Steps()
    first = steps.let("a", x * y)
    assert steps.let("b", x * y) == first
    assert steps.let("a", x + y) != first
    assert steps.let("c", x) == x and steps.let("c", -x) == -x and steps.let("c", sp.Integer(3)) == 3
    assert [step.expression for step in steps.steps] == [x * y, x + y]


def test_needed_keeps_what_outputs_read():
    x = sp.Symbol("x", real=True)
    steps = Steps()
    a = steps.let("a", x**2)
    steps.let("b", x**3)
    c = steps.let("c", a + 1)
    program = needed(Program("", "", (Input("q", (1,), (x,)),), tuple(steps.steps), (Output("o", (), (c,)),)))
    assert [str(step.symbol) for step in program.steps] == ["a", "c"]
    assert closed_form(program) == {"o": [x**2 + 1]}


@pytest.mark.parametrize("number", [0.1, -2.5, 1e-300, 0.0, 123456.789])
def test_exact_is_the_double_itself(number):
    assert float(exact(number)) == number
    assert exact(number).q & (exact(number).q - 1) == 0  # a power of two


def operations_program(expressions):
    x, y = sp.symbols("q1 q2", real=True)
    return Program("f", "f", (Input("q", (2,), (x, y)),), (), (Output("o", (len(expressions),), tuple(expressions)),))


def test_every_operation_lowers_to_what_it_means():
    """Each construct a step may contain, evaluated from the lowered list in plain Python."""
    x, y = sp.symbols("q1 q2", real=True)
    expressions = [
        x + y,
        x - y,
        -x - y,
        x * y,
        -x * y,
        x / y,
        x**2,
        x**3,
        y**-2,
        sp.sqrt(x**2 + 1),
        sp.sin(x),
        sp.cos(y),
        3 * x - 2,
        x * y - sp.Rational(1, 3),
        GuardedInverse(x),
        GuardedInverse(x - x + y),
        sp.Integer(7),
    ]
    program = operations_program(expressions)
    kernel = lower.lower(catalogue.Function("f", program))
    for q in ([0.3, -1.7], [0.0, 2.0], [-5.0, 0.25]):
        exact_values = evaluate(program, {"q": q})["o"]
        for found, expected in zip(run(kernel, q), exact_values, strict=True):
            assert found == pytest.approx(float(expected), rel=1e-15, abs=1e-15)


def run(kernel, q):
    """A lowered function, one operation after the other."""
    ops = {
        "add": lambda a, b: a + b,
        "sub": lambda a, b: a - b,
        "mul": lambda a, b: a * b,
        "div": lambda a, b: a / b,
        "neg": lambda a: -a,
        "inv": lambda a: 1 / a if a else math.inf,
        "sqrt": math.sqrt,
        "sin": math.sin,
        "cos": math.cos,
        "abs": abs,
        "where": lambda a, b: b if a != 0 else 0.0,
    }
    values = []

    def operand(a):
        return a if isinstance(a, float) else values[a]

    for value in kernel.values:
        values.append(q[value.args[1]] if value.op == "input" else ops[value.op](*map(operand, value.args)))
    return [operand(entry) for entry in kernel.results[0]]


def test_unknown_functions_are_refused():
    x = sp.Symbol("q1", real=True)
    with pytest.raises(cr.GenerationError, match="may not contain"):
        lower.lower(catalogue.Function("f", operations_program([sp.atan(x)])))
    with pytest.raises(TypeError, match="may not contain"):
        evaluate(operations_program([sp.atan(x)]), {"q": [1, 2]})


def test_sine_of_a_sum_is_refused():
    """Sines are vectorised over inputs: a derivation that takes them of something else is told how to write it."""
    from chainrule.derive import emit

    x, y = sp.symbols("q1 q2", real=True)
    kernel = lower.lower(catalogue.Function("f", operations_program([sp.sin(x + y)])))
    with pytest.raises(cr.GenerationError, match="addition theorem"):
        emit.unit("u", "u", "u", [kernel], "0" * 64)


def test_a_constant_is_not_the_number_of_a_value():
    """In Python 6.0 == 6, with the same hash: six times x and the value number 6 times x are two values."""
    numbering = lower._Numbering()
    entries = [numbering.add("input", 0, k) for k in range(8)]
    for k in entries:
        assert numbering.add("mul", float(k), entries[7]) != numbering.add("mul", k, entries[7])


@pytest.mark.parametrize(("given", "result", "said"), [("x", "x", "share a name"), ("q", "count", "'count'")])
def test_names_that_would_clash_are_refused(given, result, said):
    x = sp.Symbol("x1", real=True)
    program = Program("f", "f", (Input(given, (1,), (x,)),), (), (Output(result, (1,), (2 * x,)),))
    with pytest.raises(cr.GenerationError, match=said) as caught:
        lower.lower(catalogue.Function("f", program))
    under.one_line(caught.value)


def test_steps_have_names_of_their_own():
    """Also where a name that is asked for looks like another one with its suffix."""
    x, steps = sp.Symbol("x1", real=True), Steps()
    named = [steps.let(name, x + k) for k, name in enumerate(("a", "a", "a_1", "a", "a_2"), 1)]
    assert len(set(named)) == 5
    assert Steps(steps.steps).let("a", x + 9) not in named


def test_operations_are_counted():
    x, y = sp.symbols("q1 q2", real=True)
    kernel = lower.lower(catalogue.Function("f", operations_program([sp.sin(x) * y + 1])))
    assert kernel.operations == 3


def test_catalogue_is_what_the_manifest_lists():
    """Every function of the catalogue is generated, of the groups made on first use the shipped ones, nothing else."""
    for name in ("planar_3r", "orthogonal_3r_fig2a", "panda", "puma560"):
        model = under.ARMS[name].description.model
        units = {unit for unit, record in under.MANIFEST["units"].items() if record["model"] == model.name}
        shipped = ("redundancy_pose", "dynamics") if name == "panda" else ()
        assert units == {f"{model.name}_{group}" for group in (*catalogue.groups(model), *shipped)}
        for group in (*catalogue.groups(model), *shipped):
            recorded = under.MANIFEST["units"][f"{model.name}_{group}"]["functions"]
            assert set(recorded) == {function.name for function in catalogue.functions(model, group)}
            for function in recorded:
                assert recorded[function]["operations"] == under.kernel(name, group, function).operations


@pytest.mark.parametrize("lengths", [(0.4, 0.3, 0.5, 0.2), (1.0, 2.0, 1.5, 1.0)])
def test_the_test_program_of_an_orthogonal_arm_passes(tmp_path, lengths):
    """A margin, which counts what rounding can do, may be off by 1, however small it is."""
    from subprocess import run
    from sys import executable

    import chainrule as cr

    cr.generate(cr.orthogonal_3r(*lengths), tmp_path, targets=["python"])
    done = run([executable, "test_orthogonal_3r.py"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
    assert "number_of_postures" in done.stdout


def test_the_c_program_of_a_design_on_a_surface_passes(tmp_path, c_compiler):
    """Its topology is 0, undecided, in double; the float version, which cannot know that, is not held against it."""
    from subprocess import run

    import chainrule as cr

    arm = cr.orthogonal_3r(0.1, 1.0, 1.0, 0.01)
    assert arm.surfaces == ("E2",)
    cr.generate(arm, tmp_path, targets=["c"])
    sources = ["orthogonal_3r.c", "orthogonal_3r_step.c", "orthogonal_3r_float.c", "test_orthogonal_3r.c"]
    run([*c_compiler, "-std=c99", "-O0", *sources, "-o", "checked", "-lm"], cwd=tmp_path, check=True)
    done = run([tmp_path / "checked"], capture_output=True, text=True, check=False)
    assert done.stdout.splitlines()[-1] == "pass", done.stdout


def test_a_unit_that_follows_curves_depends_on_the_shared_header() -> None:
    """Its compiled code is that of the header: a library made from an older one has another digest."""
    units = under.MANIFEST["units"]
    for name, unit in units.items():
        follows = "_continuation_" in name
        assert ("templates/continuation.h.j2" in unit["inputs"]) == follows, name
