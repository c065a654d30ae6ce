"""The check of a computed path, under its name for macros: `evenload.proof` is the module
`evenload.simulation.proof`.
"""

import sys

from evenload.simulation import proof

sys.modules[__name__] = proof
