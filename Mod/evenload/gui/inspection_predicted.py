"""The tab of the dock Inspect for predictions: what the source's regressions say of the faces."""

import FreeCAD

from evenload import face_inspection, inspection
from evenload import tool as tools
from evenload.gui import colours
from evenload.gui.inspection_labels import tell, telling, unit
from evenload.gui.inspection_rows import OWN
from evenload.operations.finishing import Finishing
from evenload.settings.sentences import shown
from evenload.settings.table import PARALLEL

_translate = FreeCAD.Qt.translate

NOT_ROUND = "None of the faces is a cylinder: the prediction is for the one that is told here."
UNASKED = "Tell Rz, or choose a finishing operation, whose cusps tell the least Rz."


def cut_of(operation):
    """({name of the dock's value: value}, sentences on what was assumed) of a finishing operation,
    lengths in mm. Raises ValueError, in a sentence, for a tool controller that tells no feed per
    tooth.
    """
    controller = operation.ToolController
    tool, data = tools.read(controller, takes_balls=True)
    if not data.spindle_speed > 0:
        raise ValueError(
            _translate(
                "EvenLoad", "The spindle speed of '%s' is 0: set it, for the feed per tooth."
            )
            % controller.Label
        )
    assumed = [shown(sentence) for sentence in tools.on_teeth(tool)]
    values = {
        "stepover": operation.Stepover.Value,
        "feed": data.feed / (tool.teeth * data.spindle_speed),
        "tool": tools.end_radius(controller),
        "roughness": operation.CuspHeight.Value,
        "speed": data.spindle_speed,
        "passes": operation.Strategy,
    }
    return values, assumed


class Predicting:
    """What an InspectionView does with predictions. It has `document`, `faces` and `dock`;
    `prediction` is the Prediction, None where there is none.
    """

    def __init__(self):
        self.prediction = None
        self._source, self._filled = OWN, {}  # the operation that was read, and its values
        self._assumed = []  # sentences on that

    def offer_operations(self):
        """Lists the finishing operations of the document."""
        rows = [
            (obj.Label, obj.Name)
            for obj in self.document.Objects
            if isinstance(getattr(obj, "Proxy", None), Finishing)
        ]
        self.dock.offer_operations(rows)

    def show_round_face(self):
        """Shows what the faces themselves tell: how they are bent."""
        bent = face_inspection.round_face(self.faces)
        if bent is not None:
            _show(self.dock.cutting, {"nature": bent.nature, "face": bent.radius})
        self.predict()

    def predict(self):
        """Predicts by the dock's values; first these are those of an operation that was chosen."""
        self.prediction = None
        cutting = self.dock.cutting
        with telling(self.dock.predicted):
            self._follow_source(cutting)
            told = _values(cutting)
            if not told["roughness"] > 0:
                tell(self.dock.predicted, _translate("EvenLoad", UNASKED))
                return
            self.prediction = _prediction(told)
            self._tell_prediction()

    def _follow_source(self, cutting):
        """Fills in an operation's values where it was chosen anew; where one of them is no longer
        its, they are the user's own.
        """
        chosen, before = cutting.source.currentData(), self._source
        self._source = OWN  # unless all of it can be read
        if chosen == OWN:
            self._assumed = []
            return
        if chosen == before:
            if {name: _values(cutting)[name] for name in self._filled} != self._filled:
                cutting.show_values(source=OWN)
                self._assumed = []
            else:
                self._source = chosen
            return
        operation = self.document.getObject(chosen)
        if operation is None:
            raise ValueError("The operation is no longer there: choose another one.")
        values, self._assumed = cut_of(operation)
        bent = face_inspection.round_face(self.faces)
        if bent is not None and operation.Strategy in PARALLEL:
            values["direction"] = round(bent.feed_direction(operation.PassAngle.Value), 1)
        roughness = _values(cutting)["roughness"]
        if roughness not in (0, self._filled.get("roughness")):
            del values["roughness"]  # the user's own
        _show(cutting, values)
        self._source = chosen
        self._filled = {name: _values(cutting)[name] for name in values}

    def _tell_prediction(self):
        told = self.prediction.sentences(unit()) + self._assumed
        is_guess = bool(self.prediction.warnings() or self._assumed)
        if face_inspection.round_face(self.faces) is None:
            told.append(_translate("EvenLoad", NOT_ROUND))
            is_guess = True
        tell(self.dock.predicted, "\n".join(told), colours.CAUTION if is_guess else None)


def _values(cutting):
    """{name: value} of the dock's rows, lengths in mm."""
    lengths = ("roughness", "stepover", "feed", "depth", "tool", "face")
    values = {name: getattr(cutting, name).mm() for name in lengths}
    values.update((name, getattr(cutting, name).value()) for name in ("direction", "speed"))
    values.update((name, getattr(cutting, name).currentData()) for name in ("nature", "passes"))
    return values


def _show(cutting, values):
    """Shows values, as _values() has them, and tells nobody."""
    for name, value in values.items():
        field = getattr(cutting, name)
        if hasattr(field, "set_mm"):
            blocked = field.blockSignals(True)
            field.set_mm(value)
            field.blockSignals(blocked)
        else:
            cutting.show_values(**{name: value})


def _prediction(told):
    cut = inspection.Cut(
        *(told["stepover"], told["feed"], told["depth"], told["tool"], told["face"]),
        *(told["speed"], told["passes"]),
    )
    return inspection.prediction(told["nature"], told["direction"], 1000 * told["roughness"], cut)
