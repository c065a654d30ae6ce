"""The live preview in FreeCAD's GUI (see gui_preview_session.py), and what it is made of."""

import math

import FreeCAD
import pytest
from conftest import in_gui
from evenload import planar
from finishing_parts import lofted
from models import DEPTH
from test_finishing import finish


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What gui_preview_session.py reports."""
    return in_gui("gui_preview_session.py", tmp_path_factory.mktemp("preview"))


def test_nothing_is_computed_as_a_panel_opens_whose_path_is_there(session):
    assert session["follows"]["opened"] == [None, []]


def test_each_change_restarts_the_preview_and_the_last_one_is_shown(session):
    seen = session["follows"]
    assert set(seen["states"]) == {"computing"}
    assert seen["computed"][-1] == 70 and sorted(seen["computed"]) == seen["computed"]
    first, time, engagement, *_ = seen["status"].splitlines()
    assert first == "\u25cf Preview: Apply checks and stores the path"
    assert time.startswith("Time 0:0") and engagement.startswith("Engagement up to 7")


def test_it_shows_beside_the_operation_whose_own_path_stays_and_is_hidden(session):
    seen = session["follows"]
    assert seen["path_kept"] and seen["colours"] == 4
    assert seen["nodes"] == [["PickStyle", "Separator"], ["DrawStyle"]]


def test_the_last_valid_path_stays_greyed_until_the_new_one_is_there(session):
    state, colours, status = session["follows"]["grey"]
    assert state == "computing" and colours == 1
    assert status.startswith("\u25cf Changed: computing the path\nTime 0:0")
    status, nodes, colours = session["follows"]["refused"]
    assert status.startswith("\u2716 Start Depth (0 mm) does not lie above Final Depth (5 mm)")
    assert nodes == session["follows"]["nodes"] and colours == 1


def test_cancel_leaves_the_document_as_it_was(session):
    for name in ("follows", "applied"):
        assert session[name]["same"], name
    assert session["follows"]["left"] == [] and session["follows"]["state"] == ["Up-to-date"]


def test_arrows_and_keys_are_followed_at_once_and_what_is_typed_when_it_is_done(session):
    seen = session["stepped"]
    changes = [
        [step[k] for step in seen[name]] for k, name in enumerate(("angle", "share", "left"))
    ]
    assert changes[0] == [46, 47, 46, 46]  # by a degree at the arrow and the keys
    assert changes[1][0] < changes[1][1] > changes[1][2] == changes[1][3]  # it has no arrows
    assert changes[2] == [0.05, 0.1, 0.05, 0.05]
    assert seen["state"] == "computing"


def test_ok_and_cancel_are_for_the_panel_s_own_document(session):
    taken, left = session["elsewhere"]["True"], session["elsewhere"]["False"]
    assert taken == left == [63, ["Up-to-date"], True, True, True]


def test_what_cancel_cannot_take_back_after_an_undo_is_computed_anew(session):
    assert session["undone"] == {"is computed": True, "angle": 47, "is its path": True}


def test_apply_takes_what_the_preview_shows_and_computes_what_it_does_not(session):
    seen = session["applied"]
    shown, not_shown, at_ok = seen["runs"]
    assert shown == at_ok == 1 and not_shown > 0
    assert seen["valid"] == [[True, "\u2714 Valid, checked against the model"]] * 2
    assert seen["nodes"] == [] and seen["widgets"] == [[], []]
    assert seen["ok"] == [45, True, []]
    assert seen["same_path"]


def test_without_live_preview_nothing_is_computed_until_apply(session):
    state, nodes, status, is_on_again = session["switched"]
    assert state is None and nodes == [] and not is_on_again
    assert status == "\u25cf Changed: Apply computes the path"


def test_the_memory_stays_level(session):
    _, before, _, after = session["memory"]
    assert after - before < 3  # MB, in 30 previews


def test_cancel_comes_at_any_moment_of_what_takes_long(session):
    assert len(session["large"]["kept"]) >= 4 and all(session["large"]["kept"])
    assert session["large"]["applied"]


def test_what_is_taken_away_meanwhile_is_one_sentence_and_nothing_is_lost(session):
    seen = session["taken_away"]
    # The sentence; whether OK leaves the panel open and tells it; what is there after Cancel.
    assert seen["base"] == ["The job 'Job' has no model: add one to it.", *[True] * 5]
    told = "The operation has no tool: choose a tool controller for it."
    assert seen["tool"] == [told, *[True] * 5]
    assert seen["closed"] == [False, True]
    assert seen["two"] == [True, [], True, 45]


def previewed(op):
    """The task of an operation as its panel's preview has it, and its Computation."""
    task = op.Proxy.preview(op)
    return task, task.run(None)


def test_reading_for_a_preview_touches_nothing_and_knows_depths_before_they_are_set(square):
    op = square.done(square.operation())
    square.doc.recompute()
    op.setExpression("FinalDepth", "OpFinalDepth + 1 mm")
    op.touch()
    changed = []

    class Observer:
        def slotChangedObject(self, obj, prop):
            changed.append((obj.Name, prop))

    observer = Observer()
    FreeCAD.addDocumentObserver(observer)
    try:
        task, done = previewed(op)
    finally:
        FreeCAD.removeDocumentObserver(observer)
    assert changed == []
    assert op.FinalDepth.Value == -DEPTH and task.settings.FinalDepth.Value == 1 - DEPTH
    assert min(move[3] for move in done.toolpath.moves) == pytest.approx(1 - DEPTH)


@pytest.mark.parametrize(
    "name, expression, wanted",
    [
        ("SideStep", "OpToolDiameter / 4", (60, 1.5)),
        ("EngagementAngle", "OpToolDiameter / 6 mm * 90 deg", (90, 3.0)),
    ],
)
def test_a_preview_has_angle_and_side_step_follow_each_others_expression(
    square, name, expression, wanted
):
    op = square.done(square.operation(EngagementAngle=35))
    op.setExpression(name, expression)
    task, done = previewed(op)
    seen = task.settings.EngagementAngle.Value, task.settings.SideStep.Value
    assert seen == pytest.approx(wanted)
    assert op.EngagementAngle.Value == pytest.approx(35)  # until it is recomputed
    square.done(op)
    assert task.is_same(op.Proxy.read(op))


def test_an_expression_that_fails_is_one_sentence(square):
    op = square.operation()
    op.setExpression("StepDown", "Nothing.x + 1 mm")
    with pytest.raises(ValueError, match="The expression of StepDown, .* mend it.$"):
        op.Proxy.preview(op)
    op.setExpression("StepDown", None)


def test_rest_machining_is_previewed_without_touching_the_operations_before(square):
    first = square.done(square.operation(StockToLeave=2.0))
    op = square.operation(UseRestMachining=True)
    op.EarlierOperations = []
    task, done = previewed(op)
    assert op.EarlierOperations == [] and first.State == ["Up-to-date"]
    whole = square.done(square.operation()).RemovedVolume.Value
    assert 0 < done.toolpath.report.removed_volume < whole / 2
    assert not task.is_same(task)  # what was cut before may have changed
    first.touch()
    with pytest.raises(ValueError, match="is not up to date"):
        op.Proxy.preview(op)


@pytest.mark.parametrize("kind", ["adaptive", "trochoid", "lame_spiral"])
def test_a_recompute_takes_what_was_computed_only_for_what_is_set_now(square, kind):
    op = square.operation(kind=kind)
    square.done(op)
    path = op.Path.toGCode()
    op.Proxy.known = task, done = previewed(op)
    assert task.is_same(op.Proxy.preview(op))
    square.done(op)
    assert op.Proxy.last is done and op.Path.toGCode() == path
    for name, value in (("EngagementAngle", 50), ("FinalDepth", -2.0), ("CutMode", "Conventional")):
        op.Proxy.known = task, done = previewed(op)
        square.set(op, **{name: value})
        assert not task.is_same(op.Proxy.preview(op)), name
        square.done(op)
        assert op.Proxy.last is not done and op.Proxy.known is None, name


def test_finishing_is_previewed_as_it_is_computed(bench):
    on, op = finish(bench, lofted())
    on.done(op)
    _, done = previewed(op)
    assert done.toolpath.moves == op.Proxy.last.toolpath.moves
    values = op.Proxy.result_values(done)
    assert values["CuttingTime"] == op.CuttingTime > 0
    assert values["PathLength"] == op.PathLength.Value


@pytest.mark.core
def test_a_path_is_drawn_through_its_ends_and_near_its_arcs():
    quarter, whole = math.pi / 2, -2 * math.pi
    moves = [
        (planar.RAPID, 0, 0, 5, 0, 0, 0, 0),
        (planar.CUT, 10, 0, 5, 0, 0, 0, 100),
        (planar.CUT, 0, 10, 1, quarter, 0, 0, 100),
        (planar.ENTRY, 0, 10, 0, whole, 0, 8, 100),
    ]
    points, kinds = planar.drawn(moves)
    assert list(points[0]) == [0, 0, 5] and list(points[-1]) == [0, 10, 0]
    for move in moves:
        assert list(move[1:4]) in points.tolist()
    for kind, centre, radius in ((planar.CUT, (0, 0), 10), (planar.ENTRY, (0, 8), 2)):
        own = [p for p, k in zip(points.tolist(), kinds) if k == kind and p[2] < 5]
        middles = [[(a + b) / 2 for a, b in zip(p, q)] for p, q in zip(own, own[1:])]
        for x, y, _ in own:
            assert math.dist((x, y), centre) == pytest.approx(radius)
        assert min(math.dist(p[:2], centre) for p in middles) > radius - 0.0201
        heights = [p[2] for p in own]
        assert heights == sorted(heights, reverse=True)
    assert planar.drawn([])[0].shape == (0, 3)
