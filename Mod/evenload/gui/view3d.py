"""The 3D view: its scene, and flying to a place."""

import FreeCADGui
from pivy import coin

WIDTHS = 12.0  # tool diameters that are seen around a place
LEAST = 10.0  # mm that are seen around it, also without a tool


def fly_to(document, place, tool_diameter):
    """Moves the camera of a document's 3D view until a place, (x, y, z) in mm, is in its middle,
    and as near as lets some tool diameters around it be seen. It looks the same way as before.
    False without a 3D view.
    """
    view = _view(document)
    if view is None:
        return False
    camera = view.getCameraNode()
    extent = max(WIDTHS * tool_diameter, LEAST)
    if camera.isOfType(coin.SoOrthographicCamera.getClassTypeId()):
        camera.height.setValue(min(camera.height.getValue(), extent))
    else:
        camera.focalDistance.setValue(min(camera.focalDistance.getValue(), 2 * extent))
    ahead = camera.orientation.getValue().multVec(coin.SbVec3f(0, 0, -1))
    distance = camera.focalDistance.getValue()
    camera.position.setValue(coin.SbVec3f(*place) - ahead * distance)
    return True


def scene_of(document):
    """The scene of a document's 3D view, where Coin nodes go. Raises ValueError without a view."""
    return view_of(document).getSceneGraph()


def view_of(document):
    """A document's 3D view. Raises ValueError without one."""
    view = _view(document)
    if view is None:
        raise ValueError("The document '%s' has no 3D view: open one." % document.Label)
    return view


def _view(document):
    """The one in front, or another where a spreadsheet or a drawing is; None without."""
    shown = FreeCADGui.getDocument(document.Name)
    views = [shown.activeView(), *shown.mdiViewsOfType("Gui::View3DInventor")]
    return next((view for view in views if hasattr(view, "getSceneGraph")), None)
