"""Where our icons, translations and documentation lie."""

import os

ADDON = os.path.dirname(
    os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
)
ICONS = os.path.join(ADDON, "Resources", "icons")
LANGUAGES = os.path.join(ADDON, "Resources", "translations")
DOCS = os.path.join(ADDON, "docs")
