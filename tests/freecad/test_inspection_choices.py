"""Datum, free motions, units and predictions of the dock Inspect (see
gui_inspection_choices_session.py).
"""

import pytest
from conftest import in_gui

from evenload import inspection

pytestmark = pytest.mark.between

NARROW = 264  # pixels: FreeCAD's own dock at first


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What gui_inspection_choices_session.py reports."""
    return in_gui("gui_inspection_choices_session.py", tmp_path_factory.mktemp("inspection"))


def test_all_motions_are_free_at_first_and_none_where_none_is_ticked(session):
    free, are_shown, told, zone = session["free"]
    assert free == "all" and not are_shown and zone < 0.6 * session["waves"]
    are_shown, told, zone = session["none_ticked"]
    assert are_shown and zone == pytest.approx(session["waves"], abs=1e-9)


def test_the_motions_that_are_ticked_are_free(session):
    free, datum, told, zone = session["ticked"]
    assert free == ["tz", "rx"] and datum == ""
    assert session["free"][3] < zone < session["waves"]
    assert "profile of a surface is %.4f mm" % zone in told


def test_a_datum_is_chosen_among_the_faces_or_picked_in_the_view(session):
    assert session["planes"][0] == "None" and len(session["planes"]) == 3
    assert all(name.endswith("of Dome") for name in session["planes"][1:])
    assert "select a plane face or a datum plane" in session["nothing_picked"]
    shown, free, name, _, zone = session["picked"]
    # With a datum nothing is free at first: its error of position is in the zone.
    assert shown == name.replace("Dome.", "") + " of Dome" and free == []
    assert zone == pytest.approx(session["waves"], abs=1e-9)
    assert session["datum"][1] == pytest.approx([0, 0, -1])


def test_in_a_datum_only_motions_along_it_can_be_free(session):
    enabled, free, _, _, zone = session["in_datum"]
    assert enabled == free == ["tx", "ty", "rz"] and zone <= session["waves"] + 1e-9


def test_a_datum_plane_is_followed_and_given_up_when_it_ends(session):
    shown, point = session["datum_plane"]
    assert shown == "Level" and point == pytest.approx([0, 0, 3])
    assert session["datum_moved"] == pytest.approx([0, 0, 5])
    assert session["datum_gone"] == ["", None]


def test_a_round_face_is_no_datum_and_a_document_may_close_with_one(session):
    assert "The datum is one plane face, not" in session["round_datum"]
    picked, shown = session["closed_with_datum"]
    assert picked.startswith("Dome.Face") and shown == 0


def test_features_have_no_alignment(session):
    assert session["of_feature"] == [False, True]


def test_lengths_are_shown_and_read_in_inches_where_the_user_chose_these(session):
    seen = session["inch"]
    zone = session["waves"] / 25.4
    assert "profile of a surface is %.6f in," % zone in seen["told"]
    assert "keeps the tolerance of 0.001969 in." in seen["told"] and "mm" not in seen["told"]
    assert seen["tolerance"] == "0.001969 in" and seen["same"]
    assert seen["margin"] == seen["ball"] == "0.07874 in"
    assert seen["legend"] == "in" and seen["roughness"].strip() == "µin"
    assert seen["typed"] == pytest.approx(0.0004 * 25.4)
    assert "margin of 10 in leaves nothing" in seen["refused"]
    assert "lies 1.1811 in from the faces" in seen["far"] and "mm" not in seen["far"]


def test_reports_are_in_inches_then_and_files_of_points_in_mm(session):
    text = session["inch_report"]
    assert "0.001539 in" in text and "Deviation, in" in text and " mm" not in text
    assert session["inch_file"] == "x [mm],y [mm],z [mm],i,j,k"


def test_back_in_mm_all_is_as_it_was(session):
    told, margin, tolerance = session["back"]
    assert "exceeds the tolerance of 0.0102 mm" in told and margin == "2.000 mm"
    assert tolerance == pytest.approx(0.01016, abs=1e-12)


def test_a_prediction_is_the_source_s_for_the_user_s_values(session):
    told, nature, radius = session["unasked"]
    assert "Tell Rz" in told and nature == "CX" and radius == pytest.approx(45)
    told, errors = session["own"]
    for name, error in errors.items():
        assert error == pytest.approx(inspection.predict(name, "CX", 0, 3))
    assert "Predicted cylindricity: 0.0082 mm." in told and "guess" not in told
    assert "a guess: stepover 0.3, not 0.15 mm." in session["outside"]


def test_a_finishing_operation_tells_its_values(session):
    seen = session["operation"]
    assert seen["listed"] == ["Own", "Finish"]
    assert seen["values"] == pytest.approx([0.2, 1650 / 5100 / 2, 5])
    direction, speed, roughness = seen["others"]
    assert direction == pytest.approx(67.5) and speed == 5100
    assert roughness == pytest.approx(seen["cusp"])
    assert "stepover 0.2, not 0.15 mm; feed per tooth 0.1618, not 0.08 mm" in seen["told"]
    # A value that the user changes makes them the user's own.
    assert session["edited"] == ""
    told, has_none = session["standing"]
    assert "spindle speed of" in told and has_none


def test_a_prediction_stands_in_the_report(session):
    text = session["report"]
    assert "<h2>Prediction</h2>" in text and "passes at 67.5° to its axis, Rz 3 µm" in text
    assert "Outside of what the source measured" in text and "95.6 %" in text


def test_the_dock_fits_beside_a_narrow_one(session):
    assert session["cut_off"] == []
    assert max(session["needed"]) <= 1.05 * NARROW and max(session["widths"]) >= 400
