# Run by freecadcmd: prints what a compiled module must agree with, one marked line per answer.
import os
import sys
import sysconfig

import Part

answers = {
    "suffix": sysconfig.get_config_var("EXT_SUFFIX"),
    "python": "%s/bin/python%d.%d" % ((sys.base_prefix,) + sys.version_info[:2]),
    "occt": Part.OCC_VERSION,
}
for name, value in answers.items():
    print("EVENLOAD %s=%s" % (name, value))
sys.stdout.flush()
os._exit(0)
