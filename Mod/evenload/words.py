"""Names of things in sentences: few of many, and none too long."""

from evenload import units

MOST_NAMES = 3  # in a sentence
LONGEST_LABEL = 40  # characters of an object's label in a sentence


def name_of(parts):
    """Such as 'Face7, Face9 of Model' or '200 edges of Outline': at most MOST_NAMES of a kind. In
    quotes where it reads like a length, so that it stays as the user wrote it.

    parts: of (label of an object, sub-element or '').
    """
    names = {}
    for label, element in parts:
        names.setdefault(label, []).append(element)
    named = [
        "%s of %s" % (_elements(found), _whole(label)) if any(found) else _whole(label)
        for label, found in names.items()
    ]
    return listed(named, " and ", "others")


def _elements(names):
    names = [name for name in names if name]
    if len(names) > MOST_NAMES and all(name.startswith("Edge") for name in names):
        return "%d edges" % len(names)
    return listed(names)


def listed(names, between=", ", rest="more", most=MOST_NAMES):
    """At most so many names, and how many there are besides: 'Face3, Face5, Face9 and 4 more'."""
    names = list(dict.fromkeys(names))
    beyond = " and %d %s" % (len(names) - most, rest) if len(names) > most else ""
    return between.join(names[:most]) + beyond


def shortened(label):
    """A label that leaves room for what is said of it."""
    return label if len(label) <= LONGEST_LABEL else label[: LONGEST_LABEL - 1] + "\u2026"


def _whole(label):
    """A label, shortened and as one word: 'Plate 10 mm' is no length."""
    label = shortened(label)
    return "'%s'" % label if units.tells_values(label) else label


def ends_of(label, most):
    """A label of at most so many characters, at least 3, without its middle where it is longer:
    copies of an operation differ at their ends.
    """
    if len(label) <= most:
        return label
    end = (most - 1) // 2
    return label[: most - 1 - end] + "\u2026" + label[-end:]


def in_order(parts):
    """Parts by label and number: Face9 before Face10."""
    return sorted(parts, key=lambda part: (part[0], len(part[1]), part[1]))


def clock(seconds):
    """A time as h:mm:ss, as 0:02:54."""
    whole = round(seconds)
    return "%d:%02d:%02d" % (whole // 3600, whole // 60 % 60, whole % 60)
