"""Where our icons and translations lie."""

import os

ADDON = os.path.dirname(
    os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
)
ICONS = os.path.join(ADDON, "Resources", "icons")
LANGUAGES = os.path.join(ADDON, "Resources", "translations")
