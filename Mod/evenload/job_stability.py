"""The stability of an operation in its job, under its name for macros: `evenload.job_stability` is
the module `evenload.stability.job`.
"""

import sys

from evenload.stability import job

sys.modules[__name__] = job
