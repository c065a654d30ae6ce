"""What Report's sentences are to the user: warnings, or what became of wishes and plain facts; and
which places and fields they name.
"""

import re
from dataclasses import dataclass

from evenload import units
from evenload.settings import sentences
from evenload.settings.labels import FREECADS, LABELS, told

WARNING, WISH, FACT = "warning", "wish", "fact"
CHECKED = "Checked against the model."
KEPT_OFF = "Made from the models themselves: the path keeps off all of the job's."

# How the sentences begin that are no warnings: wishes were met as far as that was possible, and the
# path is as good as any.
_WISHES = (
    "Turned more tightly than the wished",
    "HelixDiameter ",
    "Pitch is smaller than set",
    "The spiral turns more tightly than MinimumRadius",
    "No helix fits: the tool comes down along a ramp",
    "No cut leads on from a ramp",
    "Entry is a helix, not a ramp",
    "SlotWidth was not used",
)
_FACTS = (CHECKED, KEPT_OFF, "The spindle of ", "Feeds of the cuts: ")
_DEPTH_OF = re.compile(r": cut down to -?[0-9.e+-]+ mm\.$")
_STANDING = re.compile(r"^The spindle of .* does not turn")

_NUMBER = r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?"
_PLACE = r"\((?P<x>%s), (?P<y>%s)(?:, (?P<z>%s))?\)" % (_NUMBER, _NUMBER, _NUMBER)
# A label of one word may be a word of the sentence; it is the field's where it begins it.
_BY_LABEL = {label: name for name, label in {**LABELS, **FREECADS}.items()}
_FIELDS = "|".join(
    (r"\b%s\b" if " " in label or not label.isalpha() else r"^%s(?= is\b)") % re.escape(label)
    for label in sorted(_BY_LABEL, key=len, reverse=True)
)
_LINKS = re.compile("%s|(?P<label>%s)" % (_PLACE, _FIELDS))
_MARKS = re.compile(r"%s|\[(?P<name>%s)\]" % (_PLACE, "|".join(sentences.NAMES)))


@dataclass(frozen=True)
class Piece:
    """Part of a sentence."""

    text: str
    place: tuple = None  # (x, y, z) in mm that it names; z may be None
    field: str = None  # the property whose field it names


def kind_of(sentence):
    """WARNING, WISH or FACT: what a sentence of Report is."""
    if sentence.startswith(tuple(map(told, _WISHES))):
        return WISH
    if _STANDING.match(sentence):
        return WARNING
    if sentence.startswith(_FACTS) or _DEPTH_OF.search(sentence):
        return FACT
    return WARNING


def pieces_of(sentence):
    """The Pieces of a sentence, in their order."""
    return _pieces(_LINKS, sentence, sentence)


def shown_pieces(sentence):
    """The same in the user's language and units; places stay in mm."""
    marked = sentences.marked(sentence)
    links, told = (_LINKS, sentence) if marked is None else (_MARKS, marked)
    return _pieces(links, told, units.in_users_unit(told))


def _pieces(links, told, shown):
    """The Pieces of what is shown of a sentence. links: the expression for places and fields; told:
    the same with places in mm.
    """
    places = [_place(found) for found in links.finditer(told) if found["x"]]
    result, at = [], 0
    for found in links.finditer(shown):
        result.append(Piece(shown[at : found.start()]))
        if found["x"]:
            result.append(Piece(found.group(), place=places.pop(0)))
        else:
            result.append(_field(**found.groupdict()))
        at = found.end()
    return [piece for piece in (*result, Piece(shown[at:])) if piece.text]


def _field(label=None, name=None, **_):
    """The Piece of a field, by its English label or by its property."""
    if label:
        return Piece(label, field=_BY_LABEL[label])
    return Piece(sentences.label_of(name), field=name)


def _place(found):
    return float(found["x"]), float(found["y"]), float(found["z"]) if found["z"] else None


def fields_of(sentence):
    """The properties whose fields a sentence names, in its order."""
    return [piece.field for piece in pieces_of(sentence) if piece.field]
