"""Writes the tables of settings in the pages of the operations; ./run settings-pages starts it.

    PYTHONPATH=Mod python3 docs/settings_pages.py

They come from the rows in Mod/evenload/settings, and tests/python/test_settings.py fails where they
are stale. Needs neither FreeCAD nor the compiled modules.
"""

from pathlib import Path

from evenload.settings import pages

FOLDER = Path(__file__).resolve().parent

for name in pages.PAGES:
    path = FOLDER / name
    before = path.read_text(encoding="utf-8")
    after = pages.renewed(name, before)
    if after != before:
        path.write_text(after, encoding="utf-8")
        print("written: docs/" + name)
