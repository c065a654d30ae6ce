"""Texts in the user's language.

All texts are written in English, and so scripts, documents and plain Python have them. In FreeCAD's
window they are shown in the language that FreeCAD has, where there is a translation for it:
docs/languages.md tells how.
"""

import re

CONTEXT = "EvenLoad"  # of our texts, in Qt's files of translations
FREECADS = "Form"  # that of FreeCAD's own pages of an operation

# Where a pattern is filled in: by Python's % or by format().
_PLACES = re.compile(r"%%|%[-+ #0]*\d*(?:\.\d+)?(?P<kind>[a-z])|\{\w*(?::(?P<form>[^}]+))?\}")
_NUMBERED = re.compile(r"%(\d)")
# Texts in places, the shortest: with all of what they have in parentheses, or any.
WHOLE, ANY = r"((?:\([^()]*\)|[^()])*?)", "(.*?)"
_NUMBER = r"(-?\d+(?:\.\d+)?(?:e[+-]?\d+)?|-?inf|nan)"
_KINDS_OF_TEXT = ("s", "r")


def english(context, text):
    """The translator where there is no window."""
    return text


translator = english  # callable(context, text); evenload.gui.start() puts Qt's here


def translate(text):
    """A text of ours in the user's language."""
    return translator(CONTEXT, text)


def translate_freecads(text):
    """What FreeCAD's own pages of an operation call something; as we do where FreeCAD is silent."""
    told = translator(FREECADS, text)
    return told if told != text else translate(text)


def language():
    """The language of translated texts as HTML's `lang` has it, such as 'de'. It is itself a text
    of the translations: where there are none, texts are English.
    """
    return translate("en")


def with_capital(text):
    """A text as a cell or a line begins with it. Not capitalize(): other languages have capitals
    within it, too.
    """
    return text[:1].upper() + text[1:]


def numbered(pattern):
    """A pattern as translators have it: %1, %2, ... where it is filled in, in their order."""
    return _divided(pattern)[0]


def filled(text, values):
    """A numbered text with its values, which another language may have in another order."""
    return _NUMBERED.sub(lambda place: values[int(place[1]) - 1], text)


def expression(pattern, literal=re.escape, text=WHOLE):
    """A regular expression for what a pattern becomes, with a group for each of its places.

    literal: callable(text between places) -> the expression for it; text: that for a text in a
    place.
    """
    return re.compile("".join(_divided(pattern, literal, text)[1]), re.DOTALL)


def length(pattern):
    """The number of letters of a pattern that are the same whatever it is filled with."""
    return len(_PLACES.sub("", pattern))


def _divided(pattern, literal=re.escape, group=WHOLE):
    """(the numbered text, the parts of the expression)"""
    text, parts, at, number = "", [], 0, 0
    for place in _PLACES.finditer(pattern):
        before = pattern[at : place.start()]
        at = place.end()
        if place.group() == "%%":
            text, parts = text + before + "%", [*parts, literal(before + "%")]
            continue
        number += 1
        text += "%s%%%d" % (before, number)
        is_text = place["kind"] in _KINDS_OF_TEXT or not (place["kind"] or place["form"])
        parts += [literal(before), group if is_text else _NUMBER]
    return text + pattern[at:], [*parts, literal(pattern[at:])]
