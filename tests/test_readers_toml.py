"""The TOML schema: what it says is what comes out, and whatever else is in a file is refused with its place."""

import math
import os

import pytest

from chainrule import arms
from chainrule.description import Inertia, Orthogonal3R, Planar
from chainrule.errors import DescriptionError, InputError
from chainrule.readers import read
from chainrule.readers import toml as schema
from chainrule.readers.dh import from_dh
from chainrule.readers.families import planar

HEAD = 'chainrule = 1\nname = "t"\nangles = "deg"\n'
ROW = "{kind = 'R', alpha = 90, a = 0.1, d = 0.2, theta = -90}"
DH = f"[dh]\nconvention = 'modified'\nrows = [{ROW}]\n"
PLANAR = "[planar]\nkinds = 'RP'\nlengths = [1, 0.5]\n"
BODY = "mass = 1\ncentre = [0, 0, 0]\nixx = 1\nixy = 0\nixz = 0\niyy = 1\niyz = 0\nizz = 1\n"


def parsed(text):
    return schema.from_toml(text.encode())


def test_dh_in_degrees_is_exact():
    assert parsed(HEAD + DH).geometry == from_dh([("R", math.pi / 2, 0.1, 0.2, -math.pi / 2)]).geometry
    in_radians = HEAD.replace("deg", "rad") + DH.replace("= 90", "= 1.5707963267948966").replace(
        "= -90", "= -1.5707963267948966"
    )
    assert parsed(in_radians).geometry.placements == parsed(HEAD + DH).geometry.placements


@pytest.mark.parametrize("quarter", [-7, -2, -1, 0, 1, 2, 3, 5, 11])
def test_whole_quarter_turns(quarter):
    entries = parsed(HEAD + DH.replace("= 90", f"= {90 * quarter}")).geometry.placements[0].rotation
    assert {x for row in entries for x in row} <= {-1.0, 0.0, 1.0}


def test_planar_headings_are_angles():
    arm = parsed(HEAD + PLANAR + "headings = [0, 30]\n")
    assert arm.geometry == Planar((1.0, 0.5), (0.0, math.radians(30)))
    assert parsed(HEAD + PLANAR) == planar("RP", [1, 0.5], name="t")


def test_orthogonal_3r():
    assert parsed(HEAD + "[orthogonal_3r]\nd2 = 1\nd3 = 2\nd4 = 3\nr2 = 4\n").geometry == Orthogonal3R(
        1.0, 2.0, 3.0, 4.0
    )


def test_tool_by_translation_and_angles_or_by_matrix():
    by_angles = parsed(HEAD + DH + "[tool]\nxyz = [1, 2, 3]\nrpy = [0, 0, 90]\n")
    by_matrix = parsed(HEAD + DH + "[tool]\nmatrix = [[0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]\n")
    assert by_angles.geometry.tool == by_matrix.geometry.tool
    assert by_angles.geometry.tool.translation == (1.0, 2.0, 3.0)


def test_limits_have_the_units_of_their_joint():
    arm = parsed(
        HEAD
        + PLANAR
        + "[[joints]]\nposition = [-180, 90]\nvelocity = 90\nacceleration = 180\ntorque = 5\n"
        + "[[joints]]\nname = 'slide'\nposition = [0, 2]\nvelocity = 90\n"
    )
    turn, slide = arm.joints
    assert (turn.name, slide.name) == ("joint1", "slide")
    assert turn.position == (-math.pi, math.pi / 2)
    assert (turn.velocity, turn.acceleration, turn.torque) == (math.pi / 2, math.pi, 5.0)
    assert (slide.position, slide.velocity, slide.acceleration, slide.torque) == ((0.0, 2.0), 90.0, None, None)


def test_limits_may_be_in_the_other_unit_and_open_on_one_side():
    joints = "[[joints]]\nposition = [-inf, 1.5]\nvelocity = 2\n[[joints]]\nposition = [-inf, inf]\n"
    turn, slide = parsed(HEAD + 'limit_angles = "rad"\n' + PLANAR + joints).joints
    assert (turn.position, turn.velocity, slide.position) == ((-math.inf, 1.5), 2.0, None)


def test_inertia():
    arm = parsed(HEAD + DH + "[[joints]]\n[joints.inertia]\n" + BODY.replace("ixy = 0", "ixy = 0.25"))
    assert arm.inertias == (Inertia(1.0, (0.0, 0.0, 0.0), ((1.0, 0.25, 0.0), (0.25, 1.0, 0.0), (0.0, 0.0, 1.0))),)


def test_inertia_in_the_plane():
    arm = parsed(HEAD + PLANAR + "[[joints]]\n[[joints]]\n[joints.inertia]\n" + BODY)
    assert arm.inertias == (None, Inertia(1.0, (0.0, 0.0, 0.0), ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))))


def test_byte_order_mark_and_windows_line_ends():
    assert schema.from_toml(b"\xef\xbb\xbf" + (HEAD + DH).replace("\n", "\r\n").encode()).kinds == "R"


BAD = {
    "empty": ("", "key 'chainrule': missing"),
    "another version": (HEAD.replace("= 1", "= 2") + DH, "key 'chainrule': 2; the schema's version is accepted"),
    "a true version": (HEAD.replace("= 1", "= true") + DH, "key 'chainrule': True"),
    "no name": (HEAD.replace('name = "t"\n', "") + DH, "key 'name': missing"),
    "a bad name": (HEAD.replace('"t"', "'q; system(\"x\")'") + DH, "arm: the name"),
    "a number for a name": (HEAD.replace('"t"', "7") + DH, "key 'name': 7; a text"),
    "no angles": (HEAD.replace('angles = "deg"\n', "") + DH, "key 'angles': missing; 'deg' or 'rad'"),
    "grads": (HEAD.replace("deg", "grad") + DH, "key 'angles': 'grad'; 'deg' or 'rad'"),
    "a list for angles": (HEAD.replace('"deg"', "[1]") + DH, "key 'angles': [1]; 'deg' or 'rad'"),
    "unknown key": (HEAD + "convension = 1\n" + DH, "the file: unknown key 'convension'; accepted are chainrule"),
    "no geometry": (HEAD, "no geometry; exactly one of"),
    "two geometries": (HEAD + DH + PLANAR, "both [dh] and [planar]"),
    "unknown key in dh": (HEAD + DH + "rowz = 1\n", "[dh]: unknown key 'rowz'; accepted are convention, rows"),
    "no convention": (HEAD + DH.replace("convention = 'modified'\n", ""), "[dh]: the key 'convention' is missing"),
    "bad convention": (HEAD + DH.replace("modified", "khalil"), "convention 'khalil'"),
    "no rows": (HEAD + "[dh]\nconvention = 'modified'\n", "[dh]: the key 'rows' is missing"),
    "zero rows": (HEAD + "[dh]\nconvention = 'modified'\nrows = []\n", "0 rows; between 1 and 256"),
    "rows of numbers": (HEAD + "[dh]\nconvention = 'modified'\nrows = [1]\n", "[dh] row 1: 1; a table"),
    "rows as text": (HEAD + "[dh]\nconvention = 'modified'\nrows = 'x'\n", "[dh] rows: 'x'; a list"),
    "short row": (HEAD + DH.replace(", theta = -90", ""), "[dh] row 1: the key 'theta' is missing"),
    "long row": (HEAD + DH.replace("theta", "thta = 1, theta"), "[dh] row 1: unknown key 'thta'"),
    "unknown kind": (HEAD + DH.replace("'R'", "'Q'"), "row 1, column 'kind': 'Q'"),
    "text for alpha": (HEAD + DH.replace("= 90", "= '90'"), "[dh] row 1, column 'alpha': '90' is not a number"),
    "nan": (HEAD + DH.replace("0.2", "nan"), "row 1, column 'd': nan is not finite"),
    "inf": (HEAD + DH.replace("0.1", "-inf"), "row 1, column 'a': -inf is not finite"),
    "huge": (HEAD + DH.replace("0.1", "1e999"), "row 1, column 'a': inf is not finite"),
    "huge integer": (HEAD + DH.replace("0.1", "1" + "0" * 400), "row 1, column 'a'"),
    "longer integer": (HEAD + DH.replace("0.1", "1" + "0" * 5000), "a number too long to read"),
    "tool with planar": (HEAD + PLANAR + "[tool]\nxyz = [1, 2, 3]\n", "[tool]: accepted with [dh] only"),
    "tool of two": (HEAD + DH + "[tool]\nxyz = [1, 2]\n", "[tool] xyz: [1, 2]; three numbers"),
    "tool twice": (HEAD + DH + "[tool]\nxyz = [1, 2, 3]\nmatrix = []\n", "[tool]: either matrix or xyz and rpy"),
    "tool matrix": (HEAD + DH + "[tool]\nmatrix = [[1, 0], [0, 1]]\n", "[tool] matrix: [[1, 0], [0, 1]]; a 4 x 4"),
    "tool not a table": (HEAD.replace("angles", "tool = 3\nangles") + DH, "[tool]: 3; a table"),
    "unknown key in tool": (HEAD + DH + "[tool]\nquat = [1]\n", "[tool]: unknown key 'quat'"),
    "planar without lengths": (HEAD + "[planar]\nkinds = 'RR'\n", "[planar]: the key 'lengths' is missing"),
    "planar of two lengths": (HEAD + PLANAR.replace("RP", "RPR"), "lengths: [1, 0.5]; 3 numbers"),
    "heading of an R": (HEAD + PLANAR + "headings = [30, 0]\n", "headings, joint 1"),
    "kinds as a list": (HEAD + PLANAR.replace("'RP'", "['R']"), "[planar] key 'kinds': ['R']; a text"),
    "orthogonal without r2": (HEAD + "[orthogonal_3r]\nd2 = 1\nd3 = 1\nd4 = 1\n", "the key 'r2' is missing"),
    "too few joints": (HEAD + PLANAR + "[[joints]]\nvelocity = 1\n", "[[joints]]: 1 tables for 2 joints"),
    "joints not tables": (HEAD.replace("angles", "joints = [1]\nangles") + DH, "joint 1: 1; a table"),
    "joints not a list": (HEAD.replace("angles", "joints = 1\nangles") + DH, "[[joints]]: 1; a list"),
    "unknown limit": (
        HEAD + DH + "[[joints]]\nspeed = 1\n",
        "joint 1: unknown key 'speed'; accepted are name, position",
    ),
    "limits upside down": (HEAD + DH + "[[joints]]\nposition = [1, -1]\n", "the lower must not exceed the upper"),
    "limits of one": (HEAD + DH + "[[joints]]\nposition = [1]\n", "position limit of joint 1: "),
    "limit not a list": (HEAD + DH + "[[joints]]\nposition = 3\n", "joint 1, position: 3; a list"),
    "nan limit": (HEAD + DH + "[[joints]]\nposition = [nan, 1]\n", "joint 1, position: nan is not finite"),
    "negative velocity": (HEAD + DH + "[[joints]]\nvelocity = -1\n", "velocity limit"),
    "infinite torque": (HEAD + DH + "[[joints]]\ntorque = inf\n", "joint 1, torque: inf is not finite"),
    "joint name": (HEAD + DH + "[[joints]]\nname = '../../x'\n", "joint 1: the name '../../x' is not accepted"),
    "joint name twice": (
        HEAD + PLANAR + "[[joints]]\nname = 'a'\n[[joints]]\nname = 'a'\n",
        "joint 2: the name 'a' is used twice",
    ),
    "inertia without mass": (
        HEAD + DH + "[[joints]]\n[joints.inertia]\n" + BODY.replace("mass = 1\n", ""),
        "joint 1, inertia: the key 'mass' is missing",
    ),
    "negative mass": (
        HEAD + DH + "[[joints]]\n[joints.inertia]\n" + BODY.replace("mass = 1", "mass = -1"),
        "mass -1.0 kg",
    ),
    "inertia of no body": (
        HEAD + DH + "[[joints]]\n[joints.inertia]\n" + BODY.replace("ixy = 0", "ixy = 3"),
        "not that of a body",
    ),
    "unknown inertia": (
        HEAD + DH + "[[joints]]\n[joints.inertia]\nIxx = 1\n" + BODY,
        "joint 1, inertia: unknown key 'Ixx'",
    ),
    "not TOML": (HEAD + "[dh\n", "not TOML: "),
    "a key twice": (HEAD + 'name = "u"\n' + DH, "not TOML: Cannot overwrite a value (at line 4"),
    "nested deep": (HEAD + "x = " + "[" * 100_000 + "]" * 100_000, "nested too deeply"),
    "a key of many parts": (HEAD + "a." * 50_000 + "a = 1", "dotted keys nested too deeply"),
    "a key of many quoted parts": (HEAD + '"\\"". ' * 20_000 + "a = 1", "dotted keys nested too deeply"),
    "nul": (HEAD + "x = '\0'\n", "not TOML: "),
}


@pytest.mark.parametrize("case", BAD)
def test_refusals(case, tmp_path):
    text, said = BAD[case]
    file = tmp_path / "arm.toml"
    file.write_text(text)
    with pytest.raises(DescriptionError) as caught:
        read(file)
    message = str(caught.value)
    assert message.startswith(f"{file}: ") and said in message
    assert "\n" not in message and len(message) < len(str(file)) + 300


def test_bytes_that_are_not_text(tmp_path):
    file = tmp_path / "arm.toml"
    file.write_bytes(b'chainrule = 1\nname = "\xff"\n')
    with pytest.raises(DescriptionError, match="line 2: not UTF-8 text"):
        read(file)


def test_files_that_cannot_be_read(tmp_path):
    (tmp_path / "folder.toml").mkdir()
    (tmp_path / "large.toml").write_bytes(b"#" * (schema.MAX_BYTES + 1))
    os.mkfifo(tmp_path / "pipe.toml")
    for name, said in (
        ("none.toml", "there is no such file"),
        ("folder.toml", "this is a folder"),
        ("large.toml", "larger than 256 KiB"),
        ("pipe.toml", "not a regular file"),
        ("nul\0.toml", "cannot be read"),
        ("new\nline.toml", "there is no such file"),
    ):
        with pytest.raises(DescriptionError) as caught:
            read(tmp_path / name)
        assert said in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("name", "options", "said"),
    [
        ("arm.json", {}, "the suffix '.json' is not known; .toml and .urdf are accepted"),
        ("arm", {}, "the suffix '' is not known"),
        ("arm.urdf.xacro", {}, "a xacro must be expanded to a .urdf first"),
        ("arm.toml", {"tip": "hand"}, "tip and base are accepted for a .urdf only"),
    ],
)
def test_the_suffix_decides(name, options, said):
    with pytest.raises(DescriptionError) as caught:
        read(name, **options)
    assert said in str(caught.value)


@pytest.mark.parametrize("name", arms.names())
def test_embedded_arms(name):
    arm = read(arms.path(name))
    assert arm.name == name
    assert len(arm.source) > 20 and "\n" not in arm.source


def test_the_embedded_arms_are_these():
    papers = {"planar_3r", "lenarcic_3r", "ambike_3r", "orthogonal_3r_fig2a", "orthogonal_3r_fig2b", "sanchez_8r"}
    assert set(arms.names()) == papers | {"panda", "iiwa14", "crx10ial", "jaco2", "gofa5", "ur5e", "puma560"}


@pytest.mark.parametrize("name", ["../arms/panda", "panda.toml", "", "PANDA", "/etc/passwd", "*"])
def test_a_name_never_leads_out_of_the_folder(name):
    with pytest.raises(InputError, match="there is no embedded arm"):
        arms.path(name)


def test_quarter_turns_of_the_embedded_arms_are_exact():
    for name in set(arms.names()) - {"jaco2"}:  # jaco2 has twists of 60 degrees
        geometry = read(arms.path(name)).geometry
        for placement in getattr(geometry, "placements", ()):
            assert {x for row in placement.rotation for x in row} <= {-1.0, 0.0, 1.0}, name


def test_assumed_links_of_the_8r_arm_are_the_stated_cylinders():
    arm = read(arms.path("sanchez_8r"))
    masses, lengths = (3, 2.5, 2, 1.5, 1.2, 1, 0.6, 0.4), (0.1, 0.25, 0.2, 0.06, 0.2, 0.2, 0.06, 0.125)
    for inertia, mass, length, axis in zip(arm.inertias, masses, lengths, "zxzzxxzz", strict=True):
        assert inertia.mass == mass
        for i, letter in enumerate("xyz"):
            expected = mass * 0.03**2 / 2 if letter == axis else mass * (3 * 0.03**2 + length**2) / 12
            assert inertia.tensor[i][i] == pytest.approx(expected, rel=1e-14)
    assert "assumed" in arm.source


def test_puma_against_robotics_toolbox():
    np = pytest.importorskip("numpy")
    models = pytest.importorskip("roboticstoolbox").models
    from reference import pose

    arm, peer = read(arms.path("puma560")), models.DH.Puma560()
    rng = np.random.default_rng(1)
    for q in rng.uniform(-3, 3, (20, 6)):
        expected = np.array(peer.fkine(q))
        expected[2, 3] -= 26.45 * 0.0254  # its base is the mounting plate, ours the shoulder
        found = pose(arm, q, 20)
        assert max(abs(found[i, j] - expected[i, j]) for i in range(4) for j in range(4)) < 1e-14
