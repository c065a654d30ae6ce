"""Where our icons lie."""

import os

ADDON = os.path.dirname(
    os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
)
ICONS = os.path.join(ADDON, "Resources", "icons")
