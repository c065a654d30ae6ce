"""Clicks into the 3D view, and which place of a path they are on."""

import numpy
from pivy import coin

from evenload.planar import RAPID

REACH = 12  # pixels from a click to the path, at the most
SAME = 1.0  # pixels: of places that are so near to each other the foremost is meant


class Clicks:
    """`root` is what goes into a scene: clicked((x, y), (width, height)) is called for each press
    of the left button, in pixels from the lower left.
    """

    def __init__(self, clicked):
        self._clicked = clicked
        self.root = coin.SoEventCallback()
        self.root.addEventCallback(coin.SoMouseButtonEvent.getClassTypeId(), self._told)

    def _told(self, _, node):
        # Some of FreeCAD's navigation styles keep the release of a button for themselves.
        event = node.getEvent()
        is_press = event.getState() == coin.SoButtonEvent.DOWN
        if is_press and event.getButton() == coin.SoMouseButtonEvent.BUTTON1:
            size = node.getAction().getViewportRegion().getViewportSizePixels()
            at = event.getPosition()
            # By their parts: what getValue gives differs between versions of pivy.
            self._clicked((at[0], at[1]), (size[0], size[1]))


def pixels_of(camera, size, places):
    """(n x 2 pixels from the lower left, depths) of places, n x 3 in mm, as a camera sees them in a
    view of (width, height) pixels.
    """
    width, height = size
    aspect = width / height
    volume = camera.getViewVolume(aspect)
    if aspect < 1:  # as Coin does it: the narrower side shows what the camera asks for
        volume.scale(1 / aspect)
    matrix = numpy.array(volume.getMatrix().getValue(), float).reshape(4, 4)
    seen = numpy.column_stack([places, numpy.ones(len(places))]) @ matrix
    seen = seen[:, :3] / seen[:, 3:]
    return 0.5 * (seen[:, :2] + 1) * (width, height), seen[:, 2]


def sample_at(camera, size, pixel, simulation):
    """The number of the sample of a Simulation that a click at a pixel is on, None where none is
    within REACH; rapids count only where nothing else does.
    """
    places = numpy.stack([simulation.x, simulation.y, simulation.z], axis=1)
    pixels, depths = pixels_of(camera, size, places)
    away = numpy.hypot(*(pixels - pixel).T)
    near = away <= REACH
    if (near & (simulation.kind != RAPID)).any():
        near &= simulation.kind != RAPID
    if not near.any():
        return None
    near &= away <= away[near].min() + SAME
    foremost = near & (depths <= depths[near].min() + 1e-9)
    return int(numpy.argmin(numpy.where(foremost, away, numpy.inf)))
