"""docs/ as HTML (docs/html_pages.py), which F1 and What's This open: complete, and no link of it is
dead.
"""

import html.parser
import re
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
sys.path.insert(0, str(DOCS))
import html_pages  # noqa: E402

PAGES = sorted(path.stem for path in DOCS.glob("*.md"))
TO_READ = (
    *("README", "first_pocket", "which_operation", "controllers", "window", "load_view", "inspect"),
    *("simulation_window", "finishing_advisor", "installing", "properties"),
)
COMMANDS = (ROOT / "Mod" / "evenload" / "gui" / "command.py").read_text()
PAGES_OF_COMMANDS = re.findall(r'page="(\w+)"', COMMANDS)


class Read(html.parser.HTMLParser):
    """What a page holds: texts outside of code, anchors, links, pictures. All tags must match."""

    def __init__(self, text):
        super().__init__()
        self.open, self.texts, self.anchors, self.links, self.pictures = [], [], [], [], []
        self.feed(text)
        assert self.open == [], self.open

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        if tag not in ("img", "meta"):
            self.open.append(tag)
        if "id" in found:
            self.anchors.append(found["id"])
        if "href" in found:
            self.links.append(found["href"])
        if tag == "img":
            self.pictures.append(found["src"])

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if not {"code", "pre", "style"} & set(self.open):
            self.texts.append(data)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("html")
    html_pages.write(folder)
    return folder


@pytest.fixture(scope="module")
def pages(folder):
    return {path.stem: Read(path.read_text(encoding="utf-8")) for path in folder.glob("*.html")}


def test_every_page_is_there(pages):
    assert sorted(pages) == PAGES


@pytest.mark.parametrize("name", PAGES)
def test_nothing_of_markdown_is_left(pages, name):
    for text in pages[name].texts:
        assert not re.search(r"\*\*|\]\(|\x00|^ *#+ |^\||```|`", text), text


@pytest.mark.parametrize("name", PAGES)
def test_links_and_pictures_lead_somewhere(pages, folder, name):
    for picture in pages[name].pictures:
        assert (folder / picture).is_file(), picture
    for link in pages[name].links:
        if "://" in link:
            continue
        target, _, anchor = link.partition("#")
        page = target.removesuffix(".html") or name
        if page in pages:
            assert not anchor or anchor in pages[page].anchors, link
        else:
            assert (DOCS / target).exists() and not anchor, link


@pytest.mark.parametrize("name", PAGES_OF_COMMANDS)
def test_the_page_of_a_command_is_there(pages, name):
    assert name in pages


def test_every_command_has_a_page_and_no_two_the_same_keys():
    names = re.findall(r'^    "(EvenLoad_\w+)": ', COMMANDS, re.MULTILINE)
    keys = re.findall(r'keys="(\w, \w)"', COMMANDS)
    assert len(names) == len(PAGES_OF_COMMANDS) == len(set(keys)) > 10


def test_installing_brings_the_pages():
    rules = (ROOT / "cmake" / "python_modules.cmake").read_text()
    assert re.search(r"install\(CODE .*docs/html_pages\.py", rules, re.DOTALL)


MARKDOWN = """# One *thing*

A `x*y*z` and **bold [link](a.md#b)** with <tags> & 2 * 3 * 4.

- first
  goes on
  - inner
- second

1. one

   more
2. two

| a | b |
|---|---|
| 1 \\| 2 | ![p](p.png) |

    code *here*
```
fence
```
"""


def test_markdown_becomes_what_it_means():
    made = html_pages.converted(MARKDOWN)
    for part in (
        '<h1 id="one-thing">One <i>thing</i></h1>',
        "<code>x*y*z</code>",
        '<b>bold <a href="a.html#b">link</a></b> with &lt;tags&gt; &amp; 2 * 3 * 4.',
        "<li>first\ngoes on\n<ul>\n<li>inner</li>\n</ul></li>\n<li>second</li>",
        "<li>one\n<p>more</p></li>\n<li>two</li>\n</ol>",
        '<td>1 | 2</td><td><img src="p.png" alt="p"></td>',
        "<pre>code *here*</pre>\n<pre>fence</pre>",
    ):
        assert part in made, made


def test_the_page_of_the_window_tells_the_keys_of_all_commands():
    names = re.findall(r'"(EvenLoad [\wé ]+)",\n', COMMANDS)
    keys = re.findall(r'keys="(\w, \w)"', COMMANDS)
    pages = (DOCS / "window.md").read_text()
    for name, told, page in zip(names, keys, PAGES_OF_COMMANDS):
        assert re.search(r"^\| %s \| %s \|.*\(%s\.md" % (name, told, page), pages, re.MULTILINE)
    assert len(names) == len(keys)


def test_the_index_names_every_page():
    index = (DOCS / "README.md").read_text()
    named = set(re.findall(r"\((\w+)\.md\)", index))
    assert named == set(PAGES) - {"README"}


def test_the_readme_is_short_and_begins_with_the_coloured_path():
    readme = (ROOT / "README.md").read_text()
    assert len(readme.splitlines()) <= 95
    assert re.search(r"!\[.*?\]\((.*?)\)", readme)[1] == "docs/window_load.png"
    for target in re.findall(r"\]\(([^)#]*)[^)]*\)", readme):
        assert (ROOT / target).exists(), target


def test_figures_of_operations_are_those_of_their_pages():
    page = (DOCS / "which_operation.md").read_text()
    source = (DOCS / "lame_spiral.md").read_text()
    rows = re.findall(r"^\| (\w+ (?:pocket|island), \d+ mm) \| (.*) \|$", page, re.MULTILINE)
    assert len(rows) == 4
    for geometry, told in rows:
        block = source[source.index("| %s | spiral |" % geometry) :]
        adaptive, _, spiral, theirs = told.split(" | ")
        for path, figure in (
            ("spiral", spiral),
            ("constant engagement", adaptive),
            ("FreeCAD's Adaptive", theirs),
        ):
            assert re.search(r"\| %s \| \d+ \| (\S+) \|" % path, block)[1] == figure
    for text in re.findall(r"1\.1\d", page[page.index("closed slot") : page.index("The pockets")]):
        assert text in (DOCS / "trochoid.md").read_text()


@pytest.mark.parametrize("name", TO_READ)
def test_no_paragraph_of_what_is_read_first_is_long(name):
    text = re.sub(r"^```.*?^```", "", (DOCS / (name + ".md")).read_text(), flags=re.M | re.S)
    for paragraph in re.split(r"\n\n|\n(?=[-|#\d])", text):
        assert len(paragraph.split()) <= 120, paragraph
