"""evenload.inspection: profiles of parts, patterns, predictions, tables and probing moves."""

import warnings

import numpy
import pytest
from evenload import inspection

pytestmark = pytest.mark.core

SIDE = numpy.linspace(-38, 38, 21)
X, Y = (grid.ravel() for grid in numpy.meshgrid(SIDE, SIDE))


def rotation(vector):
    """The turn about a vector by its length, by Rodrigues' formula."""
    angle = numpy.linalg.norm(vector)
    x, y, z = numpy.asarray(vector) / angle
    cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + numpy.sin(angle) * cross + (1 - numpy.cos(angle)) * cross @ cross


def known_profile(nature, random, width=0.02):
    """(points, width): deviations on a part that no motion makes smaller.

    Contacts press with forces and moments that balance; six rows, shift along x without any.
    """
    part = inspection.test_part(nature)
    feet, normals = part.at(X, Y)
    while True:
        touching = random.permutation(len(feet))[:6]
        arms = feet[touching] / 40
        pressing = numpy.hstack([normals[touching, 1:], numpy.cross(arms, normals[touching])])
        values, vectors = numpy.linalg.svd(pressing.T)[1:]
        balance = vectors[-1] / numpy.abs(vectors[-1]).sum()
        if values[-1] > 0.02 and numpy.abs(balance).min() > 0.02:
            break
    deviations = 0.5 * width * random.uniform(-0.9, 0.9, len(feet))
    deviations[touching] = 0.5 * width * numpy.sign(balance)
    return part, feet + deviations[:, None] * normals, deviations


# ---- profiles ----


@pytest.mark.parametrize("nature", ["CX", "CV"])
def test_a_known_deviation_and_motion_are_recovered(nature):
    random = numpy.random.default_rng(4)
    for _ in range(8):
        part, points, deviations = known_profile(nature, random)
        turn, shift = rotation(0.003 * random.normal(size=3)), 0.1 * random.normal(size=3)
        moved = (points - shift) @ turn  # the motion back is p -> turn p + shift
        found = inspection.profile(moved, part)
        assert found.is_proved
        assert found.width == pytest.approx(0.02, abs=1e-9)
        assert found.turn == pytest.approx(turn, abs=1e-6)
        assert found.shift[1:] == pytest.approx(shift[1:], abs=1e-6)  # x is free of the part
        assert found.deviations == pytest.approx(deviations, abs=1e-6)


def test_multipliers_balance_forces_and_moments_on_the_part():
    part, points, _ = known_profile("CX", numpy.random.default_rng(8))
    found = inspection.profile(points, part)
    _, normals = part(points @ found.turn.T + found.shift)
    places = (points @ found.turn.T + found.shift)[found.contacts]
    normals = normals[found.contacts]
    weights = found.multipliers * found.sides
    assert weights @ normals == pytest.approx(0, abs=1e-9)
    assert weights @ numpy.cross(places, normals) == pytest.approx(0, abs=1e-7)
    assert found.multipliers.sum() == pytest.approx(1)
    assert found.multipliers.min() > 0


def test_without_motion_the_width_is_twice_the_largest_deviation():
    part, points, deviations = known_profile("CV", numpy.random.default_rng(1))
    raised = points + [0, 0, 0.05]
    fixed = inspection.profile(raised, part, datum=((0, 0, 0), (0, 0, 1)))
    assert fixed.width == pytest.approx(2 * numpy.abs(fixed.deviations).max())
    assert fixed.turn == pytest.approx(numpy.eye(3))
    assert fixed.shift == pytest.approx(0)
    only_up = inspection.profile(raised, part, free="tz")
    assert only_up.width < fixed.width
    assert only_up.shift[:2] == pytest.approx(0)
    assert only_up.is_proved
    free = inspection.profile(raised, part)
    assert free.width <= only_up.width + 1e-12


def test_fewer_motions_never_make_a_narrower_zone():
    part, points, _ = known_profile("CX", numpy.random.default_rng(2))
    points = (points - [0.02, -0.03, 0.05]) @ rotation([0.002, -0.001, 0.003])
    widths = []
    for free in (
        (),
        ("tz",),
        ("tz", "rx", "ry"),
        ("ty", "tz", "rx", "ry"),
        inspection.profiles.MOTIONS,
    ):
        found = inspection.profile(points, part, free=free)
        assert found.is_proved, free
        widths.append(found.width)
    assert widths == sorted(widths, reverse=True)


def test_in_a_datum_plane_only_motions_along_it_are_free():
    part, points, _ = known_profile("CX", numpy.random.default_rng(2))
    points = (points - [0, -0.08, 0]) @ rotation([0, 0, 0.002])
    datum = (0, 0, 36.1), (0, 0, 1)
    fixed = inspection.profile(points, part, datum=datum)
    found = inspection.profile(points, part, free=("tx", "ty", "rz"), datum=datum)
    assert found.turn[2] == pytest.approx([0, 0, 1])
    assert found.shift[2] == pytest.approx(0)
    assert found.is_proved
    assert inspection.profile(points, part).width <= found.width < 0.8 * fixed.width


def test_a_part_known_at_its_nominal_points_alone_gives_the_same_width_nearly():
    part, points, _ = known_profile("CX", numpy.random.default_rng(6))
    nominal, normals = part.at(X, Y)
    found = inspection.profile(points, inspection.AtPoints(nominal, normals))
    assert found.is_proved
    assert found.width == pytest.approx(0.02, rel=1e-3)


@pytest.mark.parametrize("nature, sign", [("CX", 1), ("CV", -1)])
def test_the_test_part_is_as_high_as_its_arcs_make_it(nature, sign):
    part = inspection.test_part(nature)
    points, normals = part.at([0, 0, 0, 0], [0, 24, 12, 39])
    assert points[:, 2] == pytest.approx(
        [
            45 * sign,
            sign * (45**2 - 24**2) ** 0.5,
            sign * (45**2 - 144) ** 0.5,
            sign * 36.098,
        ],
        abs=1e-3,
    )
    lean = numpy.degrees(numpy.arctan2(normals[:, 1], normals[:, 2]))
    assert lean == pytest.approx([0, sign * 32.23, sign * 15.47, 0], abs=0.01)
    feet, again = part(points + 2 * normals)
    assert feet == pytest.approx(points)
    assert again == pytest.approx(normals)
    assert part.piece(points).tolist() == [2, 2, 2, 4]


def test_what_cannot_be_inspected_is_refused_in_a_sentence():
    part, points, _ = known_profile("CX", numpy.random.default_rng(6))
    for arguments, more, words in (
        ((points + 40, part), {}, "align"),
        ((points, part), {"free": ("tw",)}, "motions"),
        ((points, part), {"free": ("tz",), "datum": ((0, 0, 0), (0, 0, 1))}, "datum"),
        ((points, part), {"datum": 5}, "datum"),
        (([], part), {}, "rows|no points"),
        ((points[:, :2], part), {}, "rows"),
        ((points * numpy.nan, part), {}, "not a number"),
        ((points, inspection.AtPoints(points[:9], points[:9])), {}, "nominal"),
    ):
        with pytest.raises(ValueError, match=words) as error:
            inspection.profile(*arguments, **more)
        assert str(error.value).endswith(".")


# ---- patterns and predictions ----


def test_halton_zaremba_gives_the_source_s_digits():
    found = inspection.halton_zaremba(36)
    assert found[35] == pytest.approx([35 / 36, 0.5625])
    assert found[0] == pytest.approx([0, 0.328125])
    assert found[1, 1] == 0.828125
    assert inspection.halton_zaremba(37, 6)[36, 1] == 0.4375
    for n, digits in ((16, 4), (25, 5), (49, 6), (64, 6), (100, 7), (121, 7)):
        assert (inspection.halton_zaremba(n) == inspection.halton_zaremba(n, digits)).all()
        assert len(numpy.unique(inspection.halton_zaremba(n)[:, 1])) == n
    assert found.min() >= 0 and found.max() < 1


def test_a_matrix_is_square_or_refused():
    found = inspection.matrix(9)
    assert found[:4].tolist() == [[0, 0], [1 / 3, 0], [2 / 3, 0], [0, 1 / 3]]
    for call, words in (
        (lambda: inspection.matrix(10), "9 or 16"),
        (lambda: inspection.matrix(0), "above 0"),
        (lambda: inspection.halton_zaremba(2.5), "whole"),
        (lambda: inspection.halton_zaremba(36, 5), "6 to 52"),
    ):
        with pytest.raises(ValueError, match=words):
            call()


@pytest.mark.parametrize(
    "nature, direction, wanted",
    [("CX", 0, 8.17), ("CX", 90, 21.20), ("CV", 0, 31.43), ("CV", 90, 44.47)],
)
def test_predictions_are_the_source_s(nature, direction, wanted):
    assert 1e3 * inspection.predict("Cyl", nature, direction, 3) == pytest.approx(wanted, abs=0.006)


def test_predictions_warn_beyond_their_range():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert inspection.predict("SPE_AR", "CX", 0, 0) == pytest.approx(0.0018)
        with pytest.raises(inspection.OutsideRange):
            inspection.predict("SPE", "CV", 91, 3)
    for arguments in (("SP", "CX", 0, 3), ("SPE", "CC", 0, 3), ("SPE", "CX", 0, float("nan"))):
        with pytest.raises(ValueError):
            inspection.predict(*arguments)


CUT = dict(
    stepover=0.15,
    feed_per_tooth=0.08,
    depth=0.3,
    tool_radius=5.0,
    face_radius=45.0,
    spindle_speed=5100.0,
)


def test_a_prediction_tells_all_errors_of_the_source_s_parts():
    found = inspection.prediction("CX", 90, 3, inspection.Cut(**CUT))
    for name, error in found.errors.items():
        assert error == inspection.predict(name, "CX", 90, 3)
    assert list(found.errors) == ["Cyl", "SPE", "SPE_A", "SPE_AR"]
    assert found.warnings() == [] and len(found.sentences()) == 4
    assert found.sentences()[0] == "Predicted cylindricity: 0.0212 mm."
    assert found.sentences("inch")[0] == "Predicted cylindricity: 0.000835 in."


@pytest.mark.parametrize(
    "name, value, words",
    [
        ("stepover", 0.3, "stepover 0.3, not 0.15 mm."),
        ("feed_per_tooth", 0.12, "feed per tooth 0.12, not 0.08 mm."),
        ("depth", 0.2, "depth 0.2, not 0.3 mm."),
        ("tool_radius", 3.0, "tool radius 3, not 5 mm."),
        ("face_radius", 8.0, "face radius 8, not 45 mm."),
        ("spindle_speed", 8000.0, "spindle speed 8000 rev/min, not 5100."),
        ("passes", "One way", "passes One way, not Zig-zag."),
    ],
)
def test_a_prediction_warns_of_each_value_beyond_the_source_s(name, value, words):
    found = inspection.prediction("CV", 0, 3, inspection.Cut(**{**CUT, name: value}))
    (warning,) = found.warnings()
    assert warning == "Outside of what the source measured, a guess: " + words
    assert found.sentences()[-1] == warning
    # The source rounds its own feeds by 1 %.
    assert (
        name == "passes"
        or not inspection.prediction(
            "CV", 0, 3, inspection.Cut(**{**CUT, name: 1.012 * CUT[name]})
        ).warnings()
    )


def test_a_prediction_of_several_differences_tells_them_in_one_sentence_and_unit():
    cut = inspection.Cut(**{**CUT, "stepover": 0.254, "tool_radius": 2.54})
    (warning,) = inspection.prediction("CX", 0, 3, cut).warnings("inch")
    assert warning.endswith("stepover 0.01, not 0.005906 in; tool radius 0.1, not 0.1969 in.")
    for arguments in (("CX", 91, 3), ("CX", -1, 3), ("CC", 0, 3), ("CX", 0, -1)):
        with pytest.raises(ValueError):
            inspection.prediction(*arguments, cut)


# ---- tables and probing ----

POINTS = numpy.array([[1.5, -2.25, 30], [40, 0.125, 36]])
NORMALS = numpy.array([[0, 0.6, 0.8], [0, 0, 1.0]])


@pytest.mark.parametrize("unit, scale", [("mm", 1), ("inch", 25.4)])
def test_tables_come_back_in_mm(tmp_path, unit, scale):
    inspection.write_csv(tmp_path / "p.csv", POINTS, NORMALS, unit)
    points, normals = inspection.read_csv(tmp_path / "p.csv")
    assert points == pytest.approx(scale * POINTS, rel=1e-15)
    assert normals == pytest.approx(NORMALS)


@pytest.mark.parametrize(
    "text, words",
    [
        ("", "empty"),
        ("x,y,z,i,j,k\n1,2,3,0,0,1\n", "mm or inch"),
        ("x [mm],y [inch],z [mm],i,j,k\n", "different units"),
        ("x [mm],y [mm],z [mm],i,j,k\n1,2,3\n", "six numbers"),
        ("a,b\n", "headings"),
    ],
)
def test_a_csv_that_is_unclear_is_refused(tmp_path, text, words):
    (tmp_path / "p.csv").write_text(text)
    with pytest.raises(ValueError, match=words):
        inspection.read_csv(tmp_path / "p.csv")


def test_writing_asks_for_the_unit(tmp_path):
    with pytest.raises(ValueError, match="state which"):
        inspection.write_csv(tmp_path / "p.csv", POINTS, NORMALS, None)


def test_the_probe_s_radius_is_taken_off_along_normals():
    found = inspection.compensated(POINTS + 1.5 * NORMALS, 2 * NORMALS, 1.5)
    assert found == pytest.approx(POINTS)
    with pytest.raises(ValueError, match="radius"):
        inspection.compensated(POINTS, NORMALS, -1)


def test_probing_moves_meet_the_surface_on_their_way():
    settings = dict(
        probe_radius=1.5,
        clearance=3,
        overshoot=1,
        retract_height=60,
        rapid_feed=2000,
        probe_feed=100,
    )
    moves = inspection.probing_moves(POINTS, NORMALS, **settings)
    assert [name for name, _ in moves[:6]] == ["G0", "G0", "G1", "G38.2", "G1", "G0"]
    start, end = (numpy.array([moves[i][1][axis] for axis in "XYZ"]) for i in (2, 3))
    assert start == pytest.approx(POINTS[0] + 4.5 * NORMALS[0])
    assert end == pytest.approx(POINTS[0] + 0.5 * NORMALS[0])
    assert moves[3][1]["F"] == 100 and moves[4][1]["Z"] == start[2]
    for change, words in (
        ({"retract_height": 30}, "retract height"),
        ({"clearance": 0}, "clearance"),
        ({"probe_feed": float("nan")}, "probe feed"),
    ):
        with pytest.raises(ValueError, match=words):
            inspection.probing_moves(POINTS, NORMALS, **{**settings, **change})
    with pytest.raises(ValueError, match="looks down"):
        inspection.probing_moves(POINTS, -NORMALS, **settings)
