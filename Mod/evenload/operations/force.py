"""What the feed control Constant force needs besides feeds: the material, the tool's edges, the
spindle's speed.
"""

import math

from evenload import compiled, materials
from evenload.settings.table import CONSTANT_FORCE


def parameters(obj, tool, data):
    """Keyword arguments of the core's generators; none for the other feed controls. Raises
    ValueError for a material that does not exist.
    """
    if obj.FeedControl != CONSTANT_FORCE:
        return {}
    row = materials.load(obj.Material)
    return {
        "force_coefficients": compiled.core().ForceCoefficients(
            row["ktc"], row["krc"], row["kte"], row["kre"]
        ),
        "teeth": tool.teeth,
        "tool_helix_angle": math.radians(tool.helix_angle),
        "spindle_speed": data.spindle_speed,
    }


def notes(obj, tool):
    """Sentences on what had to be assumed of the tool."""
    if obj.FeedControl != CONSTANT_FORCE or not tool.assumed:
        return []
    return [
        "The tool '%s' does not say its %s: the force is that of %s."
        % (tool.name, " and its ".join(tool.assumed), " and ".join(tool.assumed.values()))
    ]
