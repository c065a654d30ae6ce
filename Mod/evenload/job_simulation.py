"""The simulation of an operation in its job, under its name for macros: `evenload.job_simulation`
is the module `evenload.simulation.job`.
"""

import sys

from evenload.simulation import job

sys.modules[__name__] = job
