"""Sentences as the user reads them, in the user's language.

Refusals and notes are made in English, which documents keep and scripts read. Where one is shown,
the pattern that it was made from is looked for among those that `./run translations` has collected.
The pattern's translation gets what the sentence was filled with, which is translated first where it
is of our own words. What no pattern fits, or has no translation, stays English. Where the user has
chosen inches, values and places are told in these (evenload.units).
"""

import functools
import os
import re

from evenload import translation, units
from evenload.materials import ADDON
from evenload.settings.labels import FREECADS, LABELS, in_text
from evenload.settings.setting import CHOICE
from evenload.settings.table import ALL

PATTERNS = os.path.join(ADDON, "Resources", "translations", "sentences.txt")
NAMES = {**LABELS, **FREECADS}  # of properties: their labels in English
# Translations name a property in brackets, since its name may be one of the language's words.
PROPERTY = re.compile(r"\[(%s)\]" % "|".join(sorted(NAMES, key=len, reverse=True)))

LEAST = 10  # letters of a pattern of its own: what has fewer is taken for part of a sentence only
ALWAYS = "Checked against the model."  # a sentence that each translation has
LIST = "; "  # between parts that a sentence tells one after the other
_QUOTED = "'"  # round what has a name of its own
_CHOICES = {choice for row in ALL if row.type == CHOICE for choice in row.value}
_NAMES = re.compile(r"\b(?:%s)\b" % "|".join(name for name in NAMES if in_text(name)))


def label_of(name):
    """What the user sees a property called."""
    if name in FREECADS:
        return translation.translate_freecads(FREECADS[name])
    return translation.translate(LABELS[name])


def shown(text):
    """Sentences, one in each line, in the user's language and units."""
    told = "\n".join(marked(line) or line for line in text.split("\n"))  # patterns have mm
    return units.in_users_unit(PROPERTY.sub(lambda found: label_of(found[1]), told))


def shown_name(name):
    """What a sentence calls geometry, as 'Face7 of Model', in the user's language."""
    return marked(name, least=1) or name


def marked(sentence, least=LEAST):
    """A sentence in the user's language with its properties in brackets, as '[Entry] ist ...';
    None where there is no translation. least: letters that are to be its pattern's own.
    """
    if translation.translate(ALWAYS) == ALWAYS:
        return None  # the user's language is English, or we do not speak it
    for pattern in _patterns():
        values = pattern.values(sentence) if pattern.length >= least else None
        if values is not None:
            told = translation.translate(pattern.text)
            return None if told == pattern.text else translation.filled(told, values)
    return None


class _Pattern:
    def __init__(self, line):
        self.text, self.length = translation.numbered(line), translation.length(line)
        kinds = translation.WHOLE, translation.ANY
        self._expressions = [translation.expression(line, _literal, kind) for kind in kinds]
        # Names of objects and files stand between quotes: they are the user's.
        self._is_quoted = [
            self.text[at - 1 : at] == _QUOTED
            for at in (found.start() for found in re.finditer(r"%\d", self.text))
        ]

    def values(self, sentence):
        """What a sentence of this pattern was filled with, translated; None for another's."""
        found = next(filter(None, (each.fullmatch(sentence) for each in self._expressions)), None)
        if found is None:
            return None
        return [_part(*each) for each in zip(found.groups(), self._is_quoted)]


@functools.lru_cache(maxsize=None)
def _patterns():
    """All patterns, those with the most words of their own first."""
    with open(PATTERNS, encoding="utf-8") as file:
        lines = file.read().splitlines()
    return [_Pattern(line) for line in sorted(lines, key=translation.length, reverse=True)]


def _literal(text):
    """The expression for a text that names properties, or has their labels in their places."""
    parts, at = [], 0
    for found in _NAMES.finditer(text):
        both = re.escape(found.group()), re.escape(in_text(found.group()))
        parts += [re.escape(text[at : found.start()]), "(?:%s|%s)" % both]
        at = found.end()
    return "".join([*parts, re.escape(text[at:])])


def _part(text, is_quoted):
    """Part of a sentence in the user's language, where it is of our own words."""
    if text in _CHOICES:
        return translation.translate(text)
    if is_quoted or not text:
        return text
    if text in _properties():
        return "[%s]" % _properties()[text]
    several = [marked(each, least=1) for each in text.split(LIST)]
    return LIST.join(several) if all(several) else marked(text, least=1) or text


@functools.lru_cache(maxsize=None)
def _properties():
    """{name or label in sentences: name} of properties."""
    labels = {in_text(name) or name: name for name in NAMES}
    return {**{name: name for name in NAMES}, **labels}
