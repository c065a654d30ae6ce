"""The report of a job's simulations."""

import base64
import dataclasses
import html
import re

import pytest
from evenload import translation
from evenload.pictures import simulation_pictures
from evenload.pictures.job_report import MOST_INCIDENTS, Reported, report_of
from evenload.pictures.load_rows import Run
from languages import translations, translator
from matplotlib.text import Text
from simulated_paths import GOUGED, STAR, line_at, simulated


def reported(name, part, **options):
    run = Run(name, simulated(line_at(1.5), part=part, **options))
    return Reported(name, "Mill <1>, \u00d8 6 mm", run, part=part, limits={"engagement_deg": 60.0})


@pytest.fixture(scope="module")
def gouging():
    return reported("Rough & <ready>", [GOUGED], cutting=STAR, machine="linuxcnc_mill")


def test_it_is_one_file_with_pictures_of_each_operation(gouging):
    text = report_of("Job 1", [gouging], "linuxcnc_mill", "Star test piece")
    assert "Simulation of Job 1" in text and "Rough &amp; &lt;ready&gt;" in text
    assert "Mill &lt;1&gt;" in text
    assert not re.search(r"(src|href)=\"(?!data:)|https?:|<script", text)
    pictures = re.findall(r"base64,([^\"]+)", text)
    assert len(pictures) == 3
    assert all(base64.b64decode(each).startswith(b"\x89PNG") for each in pictures)
    assert text.count("<tr") == text.count("</tr>")


def test_incidents_stand_out_and_are_listed(gouging):
    text = report_of("Job 1", [gouging])
    count = len(gouging.run.simulation.incidents)
    assert 0 < count < MOST_INCIDENTS
    assert '<p class="verdict bad">Incidents: %d, see below.' % count in text
    assert text.count("<td>Gouge</td>") == count and "<td>0.050</td>" in text
    assert text.count('<tr class="bad">') == count + 1  # and the operation's row


def test_times_are_the_sums_of_the_operations(gouging):
    found = gouging.run.simulation
    text = report_of("Job 1", [gouging, gouging], "linuxcnc_mill")
    seconds = [
        int(h) * 3600 + int(m) * 60 + int(s) for h, m, s in re.findall(r"(\d):(\d\d):(\d\d)", text)
    ]
    assert seconds[:2] == [
        pytest.approx(2 * found.time_total_s, abs=1),
        pytest.approx(2 * found.machine_time_total_s, abs=1),
    ]
    assert found.machine_time_total_s > found.time_total_s


def test_what_was_not_simulated_is_told():
    without = Reported("Carve", notes=["The tool 'Ball' is a ball end mill."])
    text = report_of("Job 1", [reported("Slot", [(-30, -30, 30, -1.5)]), without])
    assert '<p class="verdict open">Not simulated: Carve.' in text
    assert "is a ball end mill" in text and "No incidents." in text


def test_a_job_without_faults_says_so():
    text = report_of("Job 1", [reported("Slot", [(-30, -30, 30, -1.5)])])
    assert '<p class="verdict good">No gouge' in text


def test_where_the_part_is_not_known_nothing_is_promised():
    text = report_of("Job 1", [reported("Carve", None)])
    assert '<p class="verdict open">No incidents; what must stay is not known for Carve.' in text


# ---- languages ----

NOTE = "The tool 'Ball' is simulated with sharp corners."
VERDICTS = {
    "de": "Nicht simuliert: A, B, C und 1 weitere.",
    "hu": "Nincs szimulálva: A, B, C és 1 további.",
}


def texts_of(page):
    """What a reader of the page sees of words, its pictures' too."""
    found = re.findall(r'>([^<>]+)<|alt="([^"]*)"', page.split("</style>")[1])
    return {html.unescape(text or alt) for text, alt in found if (text or alt).strip()}


def texts_in(language, monkeypatch, reported):
    if language != "en":
        monkeypatch.setattr(translation, "translator", translator(language))
    return texts_of(report_of("Job 1", reported, "linuxcnc_mill", "Star test piece"))


def test_without_a_window_it_is_in_english(gouging):
    page = report_of("Job 1", [gouging], "linuxcnc_mill", "Star test piece")
    assert page.startswith('<!DOCTYPE html>\n<html lang="en"><head>')
    assert {
        *("Simulation of Job 1", "Time at the programmed feeds", "Material of the forces"),
        *("Operations", "Removal rate, cm\u00b3/min", "Incident", "Amount, mm", "Gouge"),
        "Engagement along Rough & <ready>",
    } <= texts_of(page)


@pytest.mark.parametrize("language", ["de", "hu"])
def test_in_the_window_it_is_in_the_users_language(gouging, language, monkeypatch):
    of_users = re.compile(
        r"Operation|Rough & <ready>|Mill <1>.*|Star test piece|[\d:]+, linuxcnc_mill"
    )
    english = texts_in("en", monkeypatch, [gouging])
    told = texts_in(language, monkeypatch, [gouging])
    same = {each for each in told & english if re.search("[a-z]{3}", each)}
    assert [each for each in same if not of_users.fullmatch(each)] == []
    known = translations(language)
    own = known[translation.CONTEXT, "Simulation of %s"] % "Job 1"
    assert {own, known[translation.CONTEXT, "Gouge"]} <= told
    page = report_of("Job 1", [gouging])
    assert '<html lang="%s">' % language in page


@pytest.mark.parametrize("language", ["de", "hu"])
def test_notes_and_lists_are_in_the_users_language(language, monkeypatch):
    without = [Reported(name, notes=[NOTE]) for name in "ABCD"]
    assert NOTE in texts_in("en", monkeypatch, without)
    told = texts_in(language, monkeypatch, without)
    assert VERDICTS[language] in told and NOTE not in told
    assert any("\u201eBall" in each for each in told)


def test_each_kind_of_incident_has_its_words(gouging, monkeypatch):
    monkeypatch.setattr(translation, "translator", translator("de"))
    found = gouging.run.simulation
    kinds = "gouge", "fixture", "rapid in material", "plunge in material"
    incidents = [(kind, *found.incidents[0][1:]) for kind in kinds]
    run = Run("Slot", dataclasses.replace(found, incidents=incidents))
    told = texts_of(report_of("Job 1", [Reported("Slot", "Mill", run)]))
    words = {"Konturverletzung", "Spannmittel", "Eilgang in Material", "Senkrecht in Material"}
    assert words <= told


def texts_drawn(figure):
    found = (each.get_text() for each in figure.findobj(Text))
    return {text for text in found if re.search("[a-z]{3}", text)}


@pytest.mark.parametrize("language", ["de", "hu"])
def test_its_pictures_are_in_the_users_language(gouging, language, monkeypatch):
    found = gouging.run.simulation

    def drawn():
        return (
            texts_drawn(simulation_pictures.path(found, None, [gouging.part[0]], (0, 0, 8)))
            | texts_drawn(simulation_pictures.rest(found, None, (), gouging.part))
            | texts_drawn(
                simulation_pictures.sheet(found, None, (), gouging.part, None, 60, 1e3, 9)
            )
        )

    english = drawn()
    assert {"engagement angle, degrees", "hole", "part", "Rest and incidents"} <= english
    monkeypatch.setattr(translation, "translator", translator(language))
    assert drawn() & english <= {"Simulation"}
