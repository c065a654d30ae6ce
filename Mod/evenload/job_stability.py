"""The stability of an operation in its job, under its name for macros: `evenload.job_stability` is
the module `evenload.stability.operation`.
"""

import sys

from evenload.stability import operation

sys.modules[__name__] = operation
