"""The 3D view: its scene, and flying to a place."""

import FreeCADGui
from pivy import coin

WIDTHS = 12.0  # tool diameters that are seen around a place


def fly_to(place, tool_diameter):
    """Moves the active view's camera until a place, (x, y, z) in mm, is in its middle, and as near
    as lets some tool diameters around it be seen. It looks the same way as before. False without a
    3D view.
    """
    view = _view()
    if view is None:
        return False
    camera = view.getCameraNode()
    extent = WIDTHS * tool_diameter
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
    view = FreeCADGui.getDocument(document.Name).activeView()
    if not hasattr(view, "getSceneGraph"):
        raise ValueError("The document '%s' has no 3D view: open one." % document.Label)
    return view


def _view():
    document = FreeCADGui.activeDocument()
    view = document.activeView() if document is not None else None
    return view if hasattr(view, "getCameraNode") else None
