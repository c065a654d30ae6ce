"""Writes docs/messages.md, every sentence that the window may show; ./run messages-page starts it.

    PYTHONPATH=Mod python3 docs/messages_page.py

The sentences come from the code, as the translations collect them, so that none is missed; what
they mean stands in messages_meant.py. tests/python/test_messages.py fails where the page is stale.
Needs neither FreeCAD nor the compiled modules.
"""

import re
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parent
ROOT = DOCS.parent
sys.path.insert(0, str(ROOT / "translations"))
import collect  # noqa: E402
from joined import SENTENCES_OF_SEVERAL_PIECES, SENTENCES_OF_THE_CORE  # noqa: E402
from messages_explained import MEANT  # noqa: E402
from messages_meant import FAMILIES, GROUPS, HEAD, PLACED, VERBS  # noqa: E402

# What a sentence is filled with.
FILLED = re.compile(r"%#?[-+]?[\d.*]*[a-z]|\{(?:place|\d[^}]*)\}")
REMEDY = re.compile(r"(?:: |; |\. |, )((?:%s)\b.*)\.$" % "|".join(VERBS))
COLUMNS = "| message | what it means, what to do |\n|---|---|\n"


def shown(pattern):
    """A pattern as a reader knows it: with dots in place of what it is filled with."""
    text = FILLED.sub("\u2026", pattern.replace("{place}", "near (\u2026)")).replace("%%", "%")
    return ("\u2026 " if text[0].islower() else "") + text.strip()


def is_sentence(pattern):
    """Whether a pattern ends as a sentence, or with another one; others are parts of some."""
    return pattern.endswith((".", ": %s"))


def divided(text):
    """(what a sentence states, what it tells to do itself, '' where it tells nothing)"""
    found = REMEDY.search(text)
    if not found:
        return text, ""
    return text[: found.start()] + ".", found[1][0].upper() + found[1][1:] + "."


def meant(text):
    """What is to be done about a sentence, and what it means."""
    told = [divided(text)[1]]
    told += [told for begin, told in MEANT.items() if text.startswith(begin)]
    family = (told for looked_for, told in FAMILIES if re.search(looked_for, text))
    return " ".join(filter(None, told)).strip() or next(family, "")


def sentences():
    """{title of a group: its sentences as they are shown}"""
    found = {title: [] for title, _, _ in GROUPS}
    for pattern, source in _sources():
        if is_sentence(pattern):
            title = _group_of(pattern, source)
            if shown(pattern) not in found[title]:
                found[title].append(shown(pattern))
    return found


def _sources():
    """(pattern, the file or the room of src/ that tells it) of all patterns."""
    told = {path for name in collect.TELLING for path in collect.PACKAGE.glob(name)}
    for path in sorted(told):
        for pattern in collect._told_in(path):
            yield pattern, str(path.relative_to(collect.PACKAGE))
    rooms = {
        str(path.relative_to(ROOT).parent.as_posix()): _texts(path.parent)
        for path in sorted(ROOT.glob("src/**/*.cpp"))
    }
    for pattern in SENTENCES_OF_THE_CORE:
        pieces = [piece.strip(" .,") for piece in re.split(r"%[a-z]|\(|\)| near |: ", pattern)]
        longest = max(pieces, key=len)
        yield pattern, next(room for room, text in rooms.items() if longest in text)
    for pattern in SENTENCES_OF_SEVERAL_PIECES:
        yield pattern, ""


def _texts(folder):
    """The sources of a folder, with texts over several lines as one."""
    sources = (path.read_text(encoding="utf-8") for path in sorted(folder.glob("*.cpp")))
    return " ".join(re.sub(r'"\s*"', "", source) for source in sources)


def _group_of(pattern, source):
    for begin, title in PLACED.items():
        if shown(pattern).startswith(begin):
            return title
    return next(title for title, _, files in GROUPS if any(source.startswith(f) for f in files))


def _cell(text):
    return divided(text)[0].replace("|", r"\|")


def page():
    """The text of the page."""
    parts = [HEAD]
    for title, about, _ in GROUPS:
        rows = "".join("| %s | %s |\n" % (_cell(each), meant(each)) for each in sentences()[title])
        parts.append("## %s\n\n%s\n\n%s%s" % (title, about, COLUMNS, rows))
    return "\n".join(parts)


if __name__ == "__main__":
    (DOCS / "messages.md").write_text(page(), encoding="utf-8")
