"""What reports share that are one HTML file, with their pictures in it, made to be printed."""

import base64
import html
import io

from evenload.translation import language

STYLE = """
body { font: 10pt/1.4 sans-serif; color: #202124; max-width: 180mm; margin: 10mm auto; }
h1 { font-size: 16pt; margin: 0 0 2mm; } h2 { font-size: 12pt; margin: 6mm 0 2mm; }
img { width: 100%; max-width: 150mm; display: block; break-inside: avoid; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { text-align: right; padding: 0.6mm 2mm; border-bottom: 0.2mm solid #dadce0; }
th:first-child, td:first-child { text-align: left; }
thead { display: table-header-group; } tr { break-inside: avoid; }
.facts td:last-child { text-align: left; width: 75%; }
.verdict { font-size: 13pt; font-weight: bold; padding: 2mm 3mm; border: 0.5mm solid; }
.good { color: #137333; } .bad { color: #b3261e; } .open { color: #7a4f00; }
tr.bad td { font-weight: bold; }
@page { margin: 15mm; } @media print { body { margin: 0; max-width: none; } }
"""


def page(title, parts):
    """The text of a page of parts in HTML, in the user's language as its texts, under its title.

    The same parts give the same bytes: a browser prints the day itself.
    """
    return (
        '<!DOCTYPE html>\n<html lang="%s"><head><meta charset="utf-8"><title>%s</title>'
        "<style>%s</style></head>\n<body>%s</body></html>\n"
        % (
            *(html.escape(language()), html.escape(title), STYLE),
            "\n".join(["<h1>%s</h1>" % html.escape(title), *parts]),
        )
    )


def write(text, path):
    """Writes a page. Raises OSError."""
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def heading(text):
    """What stands over a section."""
    return "<h2>%s</h2>" % html.escape(text)


def verdict(kind, text):
    """A line that stands out; kind: good, bad or open."""
    return '<p class="verdict %s">%s</p>' % (kind, html.escape(text))


def sentences(texts):
    return "".join("<p>%s</p>" % html.escape(each) for each in texts)


def picture(draw, words):
    """What draw(file) draws into a file; words: what is told where it cannot be seen."""
    data = io.BytesIO()
    draw(data)
    code = base64.b64encode(data.getvalue()).decode("ascii")
    return '<img alt="%s" src="data:image/png;base64,%s">' % (html.escape(words), code)


def facts(rows):
    """A table of (name, value)."""
    cells = "".join("<tr><td>%s</td><td>%s</td></tr>" % tuple(map(html.escape, r)) for r in rows)
    return '<table class="facts">%s</table>' % cells


def table(head, rows, bad=()):
    """A table of texts; bad: the numbers of rows that stand out."""
    lines = ["<tr>%s</tr>" % "".join("<th>%s</th>" % html.escape(each) for each in head)]
    body = [
        "<tr%s>%s</tr>"
        % (
            ' class="bad"' if number in bad else "",
            "".join("<td>%s</td>" % html.escape(each) for each in row),
        )
        for number, row in enumerate(rows)
    ]
    return "<table><thead>%s</thead><tbody>%s</tbody></table>" % (lines[0], "\n".join(body))
