"""The core's map of a surface, of what was read from the document."""

from evenload import compiled, waiting


def mapped(question, first, spacing, cells, teeth_per_minute=0.0):
    """The core's arrays by name. first: the first cell's middle; cells: along x and y."""
    core = compiled.core()
    asked = waiting.asked()
    try:
        return core.surface_map(
            question.height_map,
            question.triangles.picked,
            question.moves,
            tool_diameter=question.tool.diameter,
            corner_radius=question.tool.end_radius,
            first=tuple(map(float, first)),
            spacing=float(spacing),
            cells=tuple(map(int, cells)),
            stock=question.stock,
            teeth_per_minute=teeth_per_minute,
            progress=asked,
        )
    except core.dynamics.Cancelled:
        raise waiting.Stopped() from None
