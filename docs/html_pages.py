"""Writes the pages of docs/ as HTML, with their pictures, for F1 and What's This.

    python3 docs/html_pages.py FOLDER

Installing the addon does so. Needs nothing but Python: of Markdown it knows what the pages use, and
tests/python/test_manual.py looks for what it does not.
"""

import html
import re
import shutil
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parent
PAGE = """<!DOCTYPE html>
<html lang="en">
<head><meta charset="utf-8"><title>%s</title>
<style>
body { font: 16px/1.5 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em }
table { border-collapse: collapse } td, th { border: 1px solid #dadce0; padding: 4px 8px }
th { background: #f1f3f4; text-align: left } img { max-width: 100%% }
pre { background: #f1f3f4; padding: 8px; overflow: auto } code { background: #f1f3f4 }
</style></head>
<body>
%s
</body></html>
"""
ITEM = re.compile(r"( *)([-*]|\d+\.) +")
HEADING = re.compile(r"(#{1,6}) +(.*)")
IMAGE, LINK = re.compile(r"!\[([^]]*)\]\(([^)]*)\)"), re.compile(r"\[([^]]*)\]\(([^)]*)\)")
BOLD = re.compile(r"\*\*(.+?)\*\*", re.DOTALL)
ITALIC = re.compile(r"(?<![*\w])\*([^*\s](?:[^*]*[^*\s])?)\*(?![*\w])")
CODE = re.compile(r"`([^`]+)`")
KEPT = "\0%d\0"  # in the place of what is HTML already


def converted(text):
    """A page of Markdown as HTML."""
    title = next(m[2] for m in map(HEADING.match, text.splitlines()) if m)
    return PAGE % (html.escape(title), "\n".join(_blocks(text.splitlines())))


def anchor_of(title):
    """The name of a heading in links, as GitHub has it."""
    bare = CODE.sub(r"\1", LINK.sub(r"\1", title)).replace("*", "")
    return re.sub(r"[^\w\- ]", "", bare.lower()).replace(" ", "-")


# ---- blocks ----


def _blocks(lines):
    """The HTML of lines, block by block."""
    lines = list(lines)
    while lines:
        if not lines[0].strip():
            lines.pop(0)
        elif lines[0].startswith("```"):
            yield _fence(lines)
        elif HEADING.match(lines[0]):
            signs, title = HEADING.match(lines.pop(0)).groups()
            level = len(signs)
            yield '<h%d id="%s">%s</h%d>' % (level, anchor_of(title), inline(title), level)
        elif lines[0].startswith("    "):
            yield _code(_taken(lines, lambda line: line.startswith("    ") or not line.strip()))
        elif lines[0].startswith("|"):
            yield _table(_taken(lines, lambda line: line.startswith("|")))
        elif ITEM.match(lines[0]):
            yield _list(lines)
        else:
            yield "<p>%s</p>" % inline("\n".join(_taken(lines, _is_text)))


def _taken(lines, is_part):
    """Takes the first line and those after it that are part of the same from lines."""
    found = [lines.pop(0)]
    while lines and is_part(lines[0]):
        found.append(lines.pop(0))
    return found


def _is_text(line):
    """Whether a line goes on with a paragraph."""
    ends = line.startswith(("```", "|")) or HEADING.match(line) or ITEM.match(line)
    return bool(line.strip()) and not ends


def _fence(lines):
    lines.pop(0)
    body = []
    while not lines[0].startswith("```"):
        body.append(lines.pop(0))
    lines.pop(0)
    return "<pre>%s</pre>" % html.escape("\n".join(body))


def _code(lines):
    return "<pre>%s</pre>" % html.escape("\n".join(line[4:] for line in lines).rstrip())


def _table(lines):
    head, _, *rows = (_cells(line) for line in lines)
    parts = [_row("th", head), *(_row("td", row) for row in rows)]
    return "<table>\n%s\n</table>" % "\n".join(parts)


def _cells(line):
    return [cell.strip().replace(r"\|", "|") for cell in re.split(r"(?<!\\)\|", line)[1:-1]]


def _row(kind, cells):
    return "<tr>%s</tr>" % "".join("<%s>%s</%s>" % (kind, inline(c), kind) for c in cells)


def _list(lines):
    first = ITEM.match(lines[0])
    kind, depth = ("ol" if first[2][0].isdigit() else "ul"), len(first[1])
    items = []
    while lines and _is_next(lines[0], first):
        inside = len(ITEM.match(lines[0])[0])
        body = [lines.pop(0)[inside:]]
        while lines and _is_inside(lines, depth):
            line = lines.pop(0)
            body.append(line[min(inside, len(line) - len(line.lstrip())) :])
        items.append("<li>%s</li>" % "\n".join(_tight(_blocks(body))))
        while len(lines) > 1 and not lines[0].strip() and _is_next(lines[1], first):
            lines.pop(0)
    return "<%s>\n%s\n</%s>" % (kind, "\n".join(items), kind)


def _is_inside(lines, depth):
    """Whether the first line belongs to an item of a list that stands so far to the right."""
    line = lines[0]
    if not line.strip():
        return len(lines) > 1 and lines[1].startswith(" " * (depth + 2))
    found = ITEM.match(line)
    if found:
        return len(found[1]) > depth
    return line.startswith(" " * (depth + 2)) or _is_text(line)


def _is_next(line, first):
    """Whether a line begins another item of a list, whose first item was matched."""
    found = ITEM.match(line)
    if not found or found[1] != first[1]:
        return False
    return found[2][0].isdigit() == first[2][0].isdigit()


def _tight(blocks):
    """The blocks of an item; a single paragraph without the space around it."""
    found = list(blocks)
    if found and found[0].startswith("<p>"):
        found[0] = found[0][3:-4]
    return found


# ---- what stands in a line ----


def inline(text):
    """The HTML of the text of a block."""
    kept = []

    def keep(made):
        kept.append(made)
        return KEPT % (len(kept) - 1)

    text = CODE.sub(lambda m: keep("<code>%s</code>" % html.escape(m[1])), text)
    text = html.escape(text, quote=False)
    text = IMAGE.sub(lambda m: keep('<img src="%s" alt="%s">' % (m[2], html.escape(m[1]))), text)
    text = LINK.sub(lambda m: keep('<a href="%s">' % _target(m[2])) + m[1] + "</a>", text)
    text = ITALIC.sub(r"<i>\1</i>", BOLD.sub(r"<b>\1</b>", text))
    while kept:  # the last may hold those before
        text = text.replace(KEPT % (len(kept) - 1), kept.pop())
    return text


def _target(link):
    """A page of ours as HTML; all else as it is."""
    return link if "://" in link else re.sub(r"^(\w+)\.md(?=#|$)", r"\1.html", link)


def write(folder):
    """Writes all pages and their pictures."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for page in DOCS.glob("*.md"):
        made = converted(page.read_text(encoding="utf-8"))
        (folder / (page.stem + ".html")).write_text(made, encoding="utf-8")
    for picture in DOCS.glob("*.png"):
        shutil.copy(picture, folder)


if __name__ == "__main__":
    write(sys.argv[1])
