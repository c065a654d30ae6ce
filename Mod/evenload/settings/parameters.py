"""What the core is given of the settings: keyword arguments in its words and units."""

import math

from evenload.settings.setting import ANGLE, CHOICE, NUMBERS, POINT


def of(obj, settings):
    """{keyword: value} of an operation's settings that have a keyword; mm, rad, mm/min. Those that
    are fitted are only among them where they were set.
    """
    return {
        row.keyword: _to_core(row, row.of(obj))
        for row in settings
        if row.keyword and (not row.fitted or row.name in obj.OwnValues)
    }


def fitted(obj, settings, figures):
    """{name: value} of an operation's fitted settings that were not set, from the core's figures,
    which have their keywords for attributes.
    """
    return {
        row.name: _from_core(row, getattr(figures, row.keyword), getattr(obj, row.name))
        for row in settings
        if row.fitted and row.name not in obj.OwnValues
    }


def _to_core(row, value):
    if row.type == ANGLE:
        return math.radians(value)
    if row.type == CHOICE:
        return value.lower()
    if row.type == NUMBERS:
        return list(value)
    if row.type == POINT:
        return value.x, value.y
    return value


def _from_core(row, value, before):
    if row.type == ANGLE:
        return math.degrees(value)
    if row.type == POINT:
        return (*value, before.z)
    return value
