"""Materials: ours by name, the user's from files and dictionaries, and what is refused."""
import json
import math

import pytest
from evenload import compiled, materials


def test_every_material_of_ours_loads_by_its_name_and_says_where_it_is_from():
    assert len(materials.names()) >= 6
    assert len(set(materials.names())) == len(materials.names())
    for name in materials.names():
        row = materials.load(name)
        assert list(row) == ["name", "ktc", "krc", "kte", "kre", "source"]
        assert row["name"] == name
        assert 100 < row["krc"] + row["ktc"] < 6000
        assert 0 < row["krc"] < row["ktc"]
        assert 0 <= row["kte"] < 100 and 0 <= row["kre"] < 100
        assert "[" in row["source"] or "doi" in row["source"], "a source that can be looked up"


def test_a_name_is_found_in_any_case():
    assert materials.load(" al7075-t6") == materials.load("Al7075-T6")


def test_the_star_s_straight_cut_peaks_at_the_99_newtons_measured():
    core = compiled.core()
    row = materials.load("Star test piece")
    coefficients = core.ForceCoefficients(row["ktc"], row["krc"], row["kte"], row["kre"])
    model = core.ForceModel(coefficients, tool_radius=3, teeth=1, helix_angle=math.radians(30))
    climb = (-math.pi / 2, math.radians(60) - math.pi / 2, 3.0)
    force = model.force([climb], feed_per_tooth=0.04, spindle_speed=6366)
    assert force.peak_xy == pytest.approx(99, abs=0.5)
    assert force.mean_power == pytest.approx(force.mean_torque * 6366 * 2 * math.pi / 60)


def test_the_core_takes_every_material():
    core = compiled.core()
    for name in materials.names():
        row = materials.load(name)
        coefficients = core.ForceCoefficients(row["ktc"], row["krc"], row["kte"], row["kre"])
        model = core.ForceModel(coefficients, 3, 2, 0.5)
        assert model.force([(-1, 1, 2)], 0.05, 6000).peak_xy > 0


def test_a_dictionary_is_a_material_without_edge_terms_by_default():
    row = materials.load({"ktc": 2000, "krc": 800})
    assert row == {
        "name": "the user's material",
        "ktc": 2000.0,
        "krc": 800.0,
        "kte": 0.0,
        "kre": 0.0,
        "source": "",
    }
    assert materials.load(row) == row


def test_a_file_holds_one_material_named_as_it_says_or_as_the_file(tmp_path):
    path = tmp_path / "steel.json"
    path.write_text(json.dumps({"ktc": 2000, "krc": 800, "kte": 20, "source": "measured"}))
    assert materials.load(path)["name"] == "steel"
    assert materials.load(str(path))["kte"] == 20
    path.write_text(json.dumps({"name": "S235", "ktc": 2000, "krc": 800}))
    assert materials.load(path)["name"] == "S235"


@pytest.mark.parametrize(
    "given, sentence",
    [
        ("oak", "There is no material 'oak': choose one of 'Star test piece', "),
        ({"krc": 1}, "The material 'the user's material' has no ktc: give it one in N/mm2."),
        ({"ktc": -1, "krc": 1, "name": "a"}, "ktc of the material 'a' must be a number of 0"),
        ({"ktc": "1", "krc": 1, "name": "a"}, "ktc of the material 'a' must be a number of 0"),
        ({"ktc": True, "krc": 1, "name": "a"}, "ktc of the material 'a' must be a number of 0"),
        ({"ktc": math.nan, "krc": 1, "name": "a"}, "ktc of the material 'a' must be a number"),
        ({"ktc": 1, "krc": 1, "kc": 1}, "has the unknown key 'kc': its keys are ktc, "),
        (7, "A material is a name, a JSON file or a dictionary of coefficients, not 7."),
    ],
)
def test_what_is_no_material_is_refused_with_a_sentence(given, sentence):
    with pytest.raises(ValueError) as caught:
        materials.load(given)
    assert sentence in str(caught.value)
    assert str(caught.value).endswith(".")


def test_a_file_that_cannot_be_used_is_named(tmp_path):
    path = tmp_path / "steel.json"
    for text, words in (
        (None, "cannot be read: No such file or directory."),
        ("{", "is no JSON: "),
        ("[1]", "must hold one material, a JSON object."),
    ):
        if text is not None:
            path.write_text(text)
        with pytest.raises(ValueError) as caught:
            materials.load(path)
        assert str(path) in str(caught.value) and words in str(caught.value)
