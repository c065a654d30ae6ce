"""How operations refuse: one line in FreeCAD's report view, and nothing that passes for a path."""

import gc
import os
import re
import sys
import traceback

import pytest
from conftest import errors_in, freecad, reopened
from evenload import host
from evenload.operations import adaptive, lame_spiral, trochoid
from evenload.operations.refusal import Refusal

REFUSED = """
import os, sys
import FreeCAD
sys.path.insert(0, %r)
from conftest import Bench
from models import SQUARE, block_with, face_of

bench = Bench(FreeCAD.newDocument(), block_with(face_of(SQUARE)))
op = bench.operation(EngagementAngle=200)
bench.doc.recompute()
print("valid:", op.isValid())
"""


def test_a_refusal_is_one_line(tmp_path):
    script = tmp_path / "refused.py"
    script.write_text(REFUSED % os.path.dirname(os.path.abspath(__file__)))
    _, log = freecad(str(script))
    assert "valid: False" in log and "Traceback" not in log
    sentence = "Engagement angle is 200 degrees: it must lie between 0 and 180 degrees."
    said = [line for line in log.splitlines() if "Engagement angle" in line]
    # FreeCAD 1.0 says it once more, after the operation's label.
    assert said[0] == "<class 'EvenLoad.Refusal'>: " + sentence
    assert said[1:] in ([], ["Operation: " + sentence])


@pytest.mark.parametrize("before", [None, 7])
def test_tracebacks_are_left_out_only_until_freecad_has_printed_the_refusal(square, before):
    if before is not None:
        sys.tracebacklimit = before
    try:
        op = square.operation(EngagementAngle=200)
        square.refused(op)
        assert getattr(sys, "tracebacklimit", None) == before
        with pytest.raises(Refusal) as caught:
            op.Proxy.execute(op)
        assert sys.tracebacklimit == 0
        assert "Traceback" not in "".join(traceback.format_exception_only(caught.value))
        del caught
        gc.collect()
        assert getattr(sys, "tracebacklimit", None) == before
    finally:
        if hasattr(sys, "tracebacklimit"):
            del sys.tracebacklimit


def test_of_several_refusals_any_may_go_first():
    before = getattr(sys, "tracebacklimit", None)
    first, second = Refusal("One."), Refusal("Two.")
    del first
    assert sys.tracebacklimit == 0
    del second
    assert getattr(sys, "tracebacklimit", None) == before


@pytest.mark.parametrize("module", [adaptive, trochoid, lame_spiral])
def test_freecads_stand_in_for_an_operation_holds_what_its_editors_take(module):
    operation = host.cam().setup_sheet._RegisteredOps[module.NAME]
    prototype = operation.prototype(module.NAME)
    names = operation.properties()
    assert len(names) >= 10
    for name in names:
        prop = prototype.getProperty(name)
        kind, value = prop.typeString(), prop.getValue()
        assert prop.displayString() is not None
        if kind in ("Angle", "Length"):
            assert value.getUserPreferred()[0] == prop.displayString()
            assert value.Unit.Type == kind
        elif kind == "Enumeration":
            assert value == prop.getEnumValues()[0]
        else:
            assert kind == "Bool" and isinstance(value, bool)


def cancelled_at_once(bench, kind):
    op = bench.operation(kind=kind)
    op.Proxy.progress = lambda share: False
    op.touch()
    bench.doc.recompute()
    return op


@pytest.mark.parametrize("kind", ["adaptive", "lame_spiral"])
def test_a_cancelled_operation_is_invalid_and_all_of_it_uncut(square, kind, tmp_path):
    op = cancelled_at_once(square, kind)

    def check(op):
        assert not op.isValid() and op.Report.startswith("Cancelled")
        assert op.getStatusString() == op.Report and op.CuttingTime == 0
        assert op.Path.toGCode().strip() == "(Cancelled: nothing is cut here)"
        # 900 mm2, but for what a tool of 6 mm leaves in the corners; at the most the stock, 50 by
        # 50 mm, where it is stopped before the floor is known.
        assert 900 - (4 - 3.14159) * 9 - 0.1 < op.UncutArea.Value < 2500.1

    check(op)
    name, job = op.Name, square.job.Name
    with reopened(square.doc, tmp_path / "job.FCStd") as again:
        check(again.getObject(name))
        text = host.post(again.getObject(job), "linuxcnc", "--no-show-editor")
        assert "(Cancelled: nothing is cut here)" in text
        assert not [line for line in text.splitlines() if re.match("G[123] ", line)]
        op = again.getObject(name)
        again.recompute()  # it was saved as one that is still to be computed
        assert op.isValid() and op.UncutArea.Value == 0 and len(op.Path.Commands) > 10


def test_rest_machining_after_a_cancelled_operation_is_emptied(square):
    first = square.done(square.operation(StockToLeave=2.0))
    second = square.done(square.operation(UseRestMachining=True))
    first.Proxy.progress = lambda share: False
    first.touch()
    square.doc.recompute()
    assert not first.isValid() and second.Path.Commands == []
    assert first.Label in second.Report


@pytest.mark.parametrize("properties", [{"UseRestMachining": True}, {"StartDepth": -1.5}])
def test_cancel_is_asked_for_while_what_was_cut_before_is_looked_at(square, properties):
    square.done(square.operation())
    op = square.operation(**properties, StepDown=1.0)
    shares = []

    def stop_at_the_first(share):
        shares.append(share)
        return False

    def no_path(*_):
        raise AssertionError("it was cancelled before")

    op.Proxy.progress, op.Proxy.generate = stop_at_the_first, no_path
    op.touch()
    square.doc.recompute()
    assert shares == [0.0] and op.Report.startswith("Cancelled")
    assert not op.isValid() and op.UncutArea.Value > 800


def test_errors_of_the_report_view_are_seen_but_for_those_that_were_provoked():
    last = ["12:00:00  The session ends.", True]
    lines = [["12:00:00  Done", False], ["12:00:00  <class 'E'>: Too wide.", True], last]
    assert errors_in(lines, []) == [lines[1][0]]
    assert errors_in(lines, ["Too wide."]) == []
    assert errors_in([["Traceback (most recent call last):", False], last], ["Too wide."]) != []
    with pytest.raises(AssertionError):
        errors_in(lines[:1], [])
