"""The report of a job's simulations."""

import base64
import re

import pytest
from evenload.pictures.job_report import MOST_INCIDENTS, Reported, report_of
from evenload.pictures.load_rows import Run
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
