"""Pictures of a simulation, under its name for macros: `evenload.simulation_pictures` is the module
`evenload.pictures.simulation_pictures`.
"""

import sys

from evenload.pictures import simulation_pictures

sys.modules[__name__] = simulation_pictures
