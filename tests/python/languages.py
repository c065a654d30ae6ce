"""The translations, as the tests read them: without Qt."""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "translations"))
FILES = {
    path.stem.split("_")[1]: path for path in (ROOT / "Resources" / "translations").glob("*.ts")
}


def translations(language):
    """{(context, text): its translation, None where it is not finished} of a language."""
    found = {}
    for context in ElementTree.parse(FILES[language]).iter("context"):
        for message in context.iter("message"):
            told = message.find("translation")
            is_done = told.get("type") is None and told.text
            found[context.findtext("name"), message.findtext("source")] = (
                told.text if is_done else None
            )
    return found


def translator(language):
    """What FreeCAD.Qt.translate is where FreeCAD has that language."""
    known = translations(language)
    return lambda context, text: known.get((context, text)) or text
