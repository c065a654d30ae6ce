"""How deep the floors of an operation are cut, by FreeCAD's depths and their own heights.

Left as it is, FinalDepth is OpFinalDepth, the lowest of the base geometry, and each floor is cut
down to itself. Set lower, it takes the lowest floors with it, and higher ones stay what they are;
set higher, none is cut deeper than that. An outline has no floor: it is cut to its own plane as
long as FinalDepth is not set and stock is above it, else to FinalDepth.
"""

from evenload.geometry.floor import SAME_HEIGHT


def depth_of(op, z, is_face):
    """z in mm down to which an operation cuts what lies at a height z: a face, or an outline that
    was drawn there.
    """
    start, final = op.StartDepth.Value, op.FinalDepth.Value
    lowest = op.OpFinalDepth.Value
    if is_face:
        return final if z <= lowest + SAME_HEIGHT else max(z, final)
    is_drawn_to = abs(final - lowest) <= SAME_HEIGHT and final <= z < start - SAME_HEIGHT
    return z if is_drawn_to else final
