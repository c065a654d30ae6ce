"""The worst means over a little of the path, which stand beside each other in reports."""

import dataclasses

import numpy
import pytest
from evenload.pictures.job_report import Reported, report_of
from evenload.pictures.load_rows import Run
from evenload.planar import CUT, ENTRY
from evenload.simulation.means import WINDOW, worst_force, worst_in_cuts
from simulated_paths import BELOW, STAR, climb, line_at, middle, simulated

PLATEAU, SPIKE = 300.0, 5340.0  # N


@pytest.fixture(scope="module")
def spiked():
    """A cut at an even force but for one sample, after an entry at a larger one."""
    run = simulated(climb(60), BELOW, cutting=STAR, step=0.02)
    kind, force = run.kind.copy(), numpy.full(len(run.x), PLATEAU)
    kind[middle(run) - 500 : middle(run) - 400] = ENTRY
    force[kind == ENTRY] = 3 * PLATEAU
    force[middle(run)] = SPIKE
    return dataclasses.replace(run, kind=kind, force_peak=force, force_peak_max=SPIKE)


def test_a_single_sample_counts_by_its_length(spiked):
    length = spiked.length[middle(spiked)]
    assert 0 < length < WINDOW
    expected = PLATEAU + (SPIKE - PLATEAU) * length / WINDOW
    assert worst_force(spiked) == pytest.approx(expected)


def test_what_an_entry_meets_is_no_cuts(spiked):
    force = numpy.where(spiked.force_peak == SPIKE, PLATEAU, spiked.force_peak)
    assert force.max() == 3 * PLATEAU
    assert worst_in_cuts(spiked, force) == pytest.approx(PLATEAU)


def test_it_is_the_mean_that_the_simulators_own_worst_values_are():
    run = simulated(climb(60), BELOW, step=0.02)
    for values, worst in (
        (run.engagement_deg, run.max_engagement_deg),
        (run.removal_rate, run.removal_rate_peak),
    ):
        assert worst_in_cuts(run, values) == pytest.approx(worst, rel=0.02)


def test_without_cuts_or_a_material_there_is_none(spiked):
    assert worst_force(simulated(line_at(0))) is None
    rapids = dataclasses.replace(spiked, kind=numpy.full(len(spiked.x), CUT - 3))
    assert worst_force(rapids) == 0


def test_the_report_tells_it_beside_the_other_worst_means(spiked):
    text = report_of("Job", [Reported("Slot", "Mill", Run("Slot", spiked))])
    assert "<td>%.0f</td>" % worst_force(spiked) in text
    assert "<td>%.0f</td>" % SPIKE not in text
