"""FreeCAD's jobs, their tools and their stock."""

import FreeCAD

from evenload.host.versions import ASSETS, cam
from evenload.host.window import show_job


def create_job(doc, models, tool_diameter, feed, spindle_speed, flutes):
    """A job with one flat end mill. Returns (job, tool controller).

    models: list of document objects; tool_diameter mm; feed mm/min, horizontal and vertical;
    spindle_speed rev/min; flutes: number of teeth. The stock is the models' bounding box.
    """
    for name, value in (
        ("tool_diameter", tool_diameter),
        ("feed", feed),
        ("spindle_speed", spindle_speed),
    ):
        if not value > 0:
            raise ValueError("%s must be positive, not %r." % (name, value))
    if not models:
        raise ValueError("A job needs at least one model.")
    FreeCAD.setActiveDocument(doc.Name)
    job = cam().job.Create("Job", list(models))
    if FreeCAD.GuiUp:
        show_job(job)
    controller = job.Tools.Group[0] if job.Tools.Group else cam().controller.Create()
    if not job.Tools.Group:
        job.Proxy.addToolController(controller)
    controller.Label = "TC: Default Tool"  # FreeCAD 1.1 calls it a 5mm Endmill, whatever it holds
    replaced = controller.Tool
    controller.Tool = create_tool("endmill", {"Diameter": tool_diameter, "Flutes": int(flutes)})
    if getattr(replaced, "Document", None) is doc:
        _remove_tool(replaced)
    controller.SpindleSpeed = float(spindle_speed)
    controller.HorizFeed = controller.VertFeed = "%.9g mm/min" % feed
    set_rapid_feed(controller, 5000.0)
    set_stock_margin(job, 0.0)
    doc.recompute()
    return job, controller


def finish_views():
    """With a GUI, has FreeCAD do at once what it does to a new job's views by and by: before the
    job's document is closed, or it looks for objects that are no more.
    """
    if FreeCAD.GuiUp:
        from draftutils.todo import ToDo

        ToDo.doTasks()


def create_tool(shape, properties):
    """A tool bit of one of FreeCAD's shapes ('endmill', 'bullnose', ...) in the active document.

    properties: {name: value}; lengths in mm. Raises ValueError for a shape or a property that
    FreeCAD does not have.
    """
    make = _tool_of_asset if ASSETS else _tool_of_file
    tool = make(shape, properties)
    if FreeCAD.GuiUp:
        tool.ViewObject.Visibility = False
    return tool


def _tool_of_file(shape, properties):
    file = shape + ".fcstd"
    if cam().bit.findToolShape(file) is None:
        raise _no_such_shape(shape)
    attributes = {"shape": file, "name": shape, "parameter": properties, "attribute": {}}
    tool = cam().bit.Factory.CreateFromAttrs(attributes, "Tool")
    unknown = [name for name in properties if not hasattr(tool, name)]
    if unknown:
        _remove_tool(tool)
        raise _no_such_property(shape, unknown[0])
    return tool


def _tool_of_asset(shape, properties):
    from Path.Tool.camassets import cam_assets
    from Path.Tool.shape import ToolBitShape

    doc = FreeCAD.ActiveDocument  # reading a shape opens a document of its own
    asset = cam_assets.get_or_none(ToolBitShape.resolve_name(shape))
    if asset is None:
        raise _no_such_shape(shape)
    # FreeCAD itself would give the tool any other property too.
    for name in properties:
        if name not in asset.get_parameters():
            raise _no_such_property(shape, name)
    attributes = {"name": shape, "parameter": properties}
    return cam().bit.ToolBit.from_shape(asset, attributes).attach_to_doc(doc)


def _no_such_shape(shape):
    return ValueError("FreeCAD has no tool shape '%s': 'endmill' is one." % shape)


def _no_such_property(shape, name):
    return ValueError("A tool of the shape '%s' has no %s." % (shape, name))


def _remove_tool(tool):
    """Takes a tool bit out of its document, with the body by which FreeCAD 1.1 shows it."""
    doc, body = tool.Document, getattr(tool, "BitBody", None) if ASSETS else None
    if body is not None:
        tool.BitBody = None
        body.removeObjectsFromDocument()
        doc.removeObject(body.Name)
    doc.removeObject(tool.Name)


def set_corner_radius(tool, radius):
    """Gives a bull-nosed tool bit the radius of its corner, in mm. Raises ValueError for a bit that
    has no corner, and for a radius that its diameter has no room for.
    """
    most = tool.Diameter.Value / 2
    if not (hasattr(tool, "CornerRadius") or hasattr(tool, "FlatRadius")):
        raise ValueError("the tool has no rounded corner: only a bullnose has one.")
    if not 0 < radius <= most:
        raise ValueError(
            "a corner radius of %g mm does not fit: it must be more than 0, and at most the %g mm "
            "of the tool's radius." % (radius, most)
        )
    if hasattr(tool, "CornerRadius"):  # since FreeCAD 1.1
        tool.CornerRadius = radius
    else:
        tool.FlatRadius = most - radius  # of the flat in the middle of the bottom


def set_rapid_feed(controller, feed):
    """Sets a tool controller's rapid feeds, in mm/min; at first they follow the SetupSheet."""
    for name in ("HorizRapid", "VertRapid"):
        controller.setExpression(name, None)
        setattr(controller, name, "%.9g mm/min" % feed)


def set_stock_margin(job, margin):
    """Makes the job's stock the models' bounding box, larger by `margin` mm to all sides."""
    before = job.Stock
    extra = FreeCAD.Vector(margin, margin, margin)
    job.Stock = cam().stock.CreateFromBase(job, neg=extra, pos=extra)
    if before is not None and not before.InList:
        job.Document.removeObject(before.Name)
    if FreeCAD.GuiUp:
        job.Stock.ViewObject.Visibility = False
