"""Brings Resources/translations up to date; ./run translations starts it.

    PYTHONPATH=Mod python3 translations/update.py FOLDER

What is to be translated is collected anew (collect.py). Qt's lupdate takes it into the files of all
languages, EvenLoad_LANGUAGE.ts, where translations of texts that are there still stay, and those of
others go; lrelease makes of each the .qm that FreeCAD loads. FOLDER gets what is made on the way.
docs/languages.md tells how to translate.
"""

import subprocess
import sys
from pathlib import Path

import collect

RESOURCES = Path(__file__).resolve().parents[1] / "Resources" / "translations"


def listed():
    """The texts as lupdate reads them: a C++ file, the same for the same texts."""
    lines = [
        'QT_TRANSLATE_NOOP("%s", "%s")\n' % (context, _quoted(text))
        for context, text, _ in sorted(collect.texts())
    ]
    return "".join(lines)


def _quoted(text):
    return text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")


def update(folder):
    """Writes all files; returns whether each text has a translation in each language."""
    patterns = "".join(line + "\n" for line in sorted(collect.patterns()))
    (RESOURCES / "sentences.txt").write_text(patterns, encoding="utf-8")
    source = Path(folder) / "texts.cpp"
    source.write_text(listed(), encoding="utf-8")
    files = [str(path) for path in sorted(RESOURCES.glob("*.ts"))]
    options = "-no-obsolete", "-locations", "none", "-source-language", "en"
    _qt("lupdate", *options, str(source), "-ts", *files)
    is_complete = True
    for file in files:
        told = _qt("lrelease", "-nounfinished", file)
        is_complete = is_complete and "0 unfinished" in told and "untranslated" not in told
        print(told.strip())
    return is_complete


def _qt(program, *arguments):
    done = subprocess.run(
        [program, *arguments],
        check=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    return done.stdout


if __name__ == "__main__":
    sys.exit(not update(sys.argv[1]))
