"""A program that probes points in the mill: G38.2 through one of FreeCAD's post-processors."""

from dataclasses import dataclass

import FreeCAD

from evenload import host, inspection


@dataclass(frozen=True)
class Probe:
    """diameter of the ball, clearance before the surface, overshoot behind it, mm; rapid_feed of
    the way to the clearance and back, feed while probing, mm/min.
    """

    diameter: float = 2.0
    clearance: float = 3.0
    overshoot: float = 2.0
    rapid_feed: float = 1000.0
    feed: float = 60.0


def probing_program(faces, samples, probe, processor="linuxcnc", arguments="--no-show-editor"):
    """The G-code text that measures Samples of PickedFaces by a Probe, in the model's coordinates.

    The probe travels above the whole objects. processor, arguments: as of host.post.
    Z words tell the centre of the ball, so that the tool's length is that to the centre; the
    spindle stands still. evenload.inspection.probing_moves has what is not looked at, and raises
    ValueError, in a sentence, for what cannot be probed from above.
    """
    if not probe.diameter > 0:
        raise ValueError("The probe's diameter must be above 0, not %r." % (probe.diameter,))
    radius = 0.5 * probe.diameter
    centres = inspection.compensated(samples.points, -samples.normals, radius)
    starts = centres + probe.clearance * samples.normals
    top = max(faces.whole.BoundBox.ZMax + radius, float(starts[:, 2].max())) + probe.clearance
    moves = inspection.probing_moves(
        *(samples.points, samples.normals, radius, probe.clearance, probe.overshoot, top),
        *(probe.rapid_feed, probe.feed),
    )
    return _posted(faces.whole, list(map(_line, moves)), probe, processor, arguments)


def _line(move):
    """A line for FreeCAD, whose feeds are mm/s."""
    name, words = move
    shown = {word: value / 60 if word == "F" else value for word, value in words.items()}
    return " ".join([name, *("%s%.6f" % each for each in shown.items())])


def _posted(shape, lines, probe, processor, arguments):
    """The program of a job of its own, in a document that nobody sees."""
    before = FreeCAD.ActiveDocument
    doc = FreeCAD.newDocument("Probing", "Probing", True)
    try:
        part = doc.addObject("Part::Feature", "Part")
        part.Shape = shape
        doc.recompute()
        job, controller = host.create_job(doc, [part], probe.diameter, probe.feed, 1.0, 1)
        # FreeCAD 1.1 cannot make its own shape of a probe at every diameter.
        controller.Label = "Probe"
        controller.SpindleDir, controller.SpindleSpeed = "None", 0.0
        operation = host.freecads("Custom", "Probing", job, controller)
        operation.Gcode = lines
        doc.recompute()
        return host.post(job, processor, arguments)
    finally:
        host.finish_views()
        FreeCAD.closeDocument(doc.Name)
        if before is not None:
            FreeCAD.setActiveDocument(before.Name)
