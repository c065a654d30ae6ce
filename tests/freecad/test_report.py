"""Tables and pictures: what they are made from, and that they show it."""

import math

import pytest
from models import SQUARE, circle
from evenload import commands
from evenload.job_files import report
from evenload.pictures import path_picture
from simulated import faulty, simulated


def test_figures_name_what_the_operation_reports(square):
    op = square.done(square.operation())
    figures = report.figures(op)
    assert figures["cutting_time_s"] == op.CuttingTime
    assert figures["time_ratio"] == pytest.approx(op.CuttingTime / op.IdealTime)
    assert figures["blocks"] == len(op.Path.Commands)
    assert figures["cut_length_mm"] > 100 and figures["passes"] > 0


def test_passes_links_and_retracts_are_counted_over_all_levels(square):
    depths = {"StartDepth": 0, "StepDown": 1}
    counted = []
    for final in (-1, -3):
        figures = report.figures(square.done(square.operation(FinalDepth=final, **depths)))
        counted.append([figures[key] for key in ("passes", "links", "retracts")])
    (passes, links, retracts), three = counted
    assert three == [3 * passes, 3 * links, 3 * (retracts + 1) - 1]


def test_a_table_has_a_column_per_job_and_a_line_per_failure(square):
    figures = report.figures(square.done(square.operation()))
    done = {"name": "plate", "ok": True, "figures": dict(figures, report="Left: a corner.")}
    bad = {"name": "worse", "ok": False, "error": "No tool.", "figures": {}}
    lines = report.table([done, dict(done, name="other"), bad]).splitlines()
    assert lines[0].split() == ["plate", "other"]
    time = next(line for line in lines if line.startswith("time  "))
    assert time.split()[-1] == "%.1f" % figures["cutting_time_s"]
    assert "plate: Left: a corner." in lines
    assert lines[-1] == "worse FAILED: No tool."


def test_what_a_simulation_has_not_got_is_left_out_and_dashed_in_the_table(square):
    op = square.done(square.operation())
    found = report.simulated(simulated(op))
    assert "simulated_machine_time_s" not in found and found["simulation"] == ""
    own = report.figures(op)
    jobs = [
        {"name": "a", "ok": True, "figures": {**own, **found}},
        {"name": "b", "ok": True, "figures": {**own, **report.simulated(faulty(op))}},
        {"name": "c", "ok": True, "figures": own},
    ]
    lines = report.table(jobs).splitlines()
    on_machine = next(line for line in lines if line.startswith("  time on the machine"))
    assert on_machine.split()[-3:] == ["-", "150.0", "-"]
    assert len({len(line) for line in lines[: len(report.FIGURES) + 1]}) == 1
    assert not any("machine" in line for line in report.table(jobs[::2]).splitlines())


def test_incidents_are_told_with_their_first_places_and_the_largest_rest(square):
    op = square.done(square.operation())
    many = [("rapid in material", float(k), 0.0, -1.0, k, 0, 0.1) for k in range(5)]
    text = report.simulated(faulty(op, incidents=many, notes=["A note."]))["simulation"]
    note, rapids, rests = text.splitlines()
    assert note == "A note."
    assert rapids == (
        "Simulated: rapid in material near (0.000, 0.000, -1.000), (1.000, 0.000, -1.000), "
        "(2.000, 0.000, -1.000) and 2 more."
    )
    assert rests.startswith("Simulated: 2 places left; the largest has 1.00 mm2, 3.000 mm deep")


def test_a_table_of_failures_only_has_no_figures():
    assert report.table([{"name": "a", "ok": False, "error": "No."}]) == "a FAILED: No."


def test_the_picture_of_an_operation(square, tmp_path):
    op = square.operation()
    with pytest.raises(ValueError, match="recompute it first"):
        path_picture.picture(op, str(tmp_path / "none.png"))
    square.done(op)
    path_picture.picture(op, str(tmp_path / "path.svg"))
    assert "engagement angle, degrees" in (tmp_path / "path.svg").read_text()
    path_picture.picture(op, str(tmp_path / "path.png"))
    assert (tmp_path / "path.png").stat().st_size > 20000


def test_an_outline_follows_arcs():
    points = path_picture.outline(circle(3, 4, 5))
    assert points[0] == points[-1] and len(points) > 36
    assert all(math.dist(p, (3, 4)) == pytest.approx(5) for p in points)
    assert path_picture.outline(SQUARE) == [(0, 0), (30, 0), (30, 30), (0, 30), (0, 0)]


def test_moves_and_posted_gcode_give_the_same_samples(square):
    from evenload import host

    op = square.done(square.operation())
    moves = path_picture.samples_of_moves(op.Proxy.last.toolpath.moves)
    text = host.post(square.job, "linuxcnc", "--no-show-editor")
    posted = path_picture.samples_of_gcode(text)
    assert {s[3] for s in posted} == {commands.RAPID, commands.CUT}
    box = [
        [f(s[k] for s in samples) for k in (0, 1) for f in (min, max)]
        for samples in (moves, posted)
    ]
    assert box[0] == pytest.approx(box[1], abs=0.01)


def test_gcode_can_be_drawn_by_feed(tmp_path):
    text = "G21\nG0 X0 Y0\nG1 X10 F100\nG3 X0 Y10 I-10 J0 F200 (turn)\nG2 X0 Y10 I5 J0\n"
    samples = path_picture.samples_of_gcode(text)
    assert samples[0] == (0, 0, 0, commands.RAPID) and samples[1] == (10, 0, 100, commands.CUT)
    assert samples[-1][:2] == pytest.approx((0, 10))
    full = [s for s in samples if s[0] > 5 and s[1] > 9]
    assert full and all(s[2] == 200 for s in samples[2:])
    path = tmp_path / "gcode.png"
    path_picture.draw(str(path), samples, [], None, "G-code", "feed, mm/min")
    assert path.stat().st_size > 5000
