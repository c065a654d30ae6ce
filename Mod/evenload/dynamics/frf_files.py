"""Files of frequency responses: text with columns, and universal file dataset 58 in ASCII."""

import math
import os
import re
from dataclasses import dataclass, field

import numpy

FORMS = ("real-imaginary", "magnitude-phase")
G = 9.80665  # m/s2
POUND, INCH = 4.4482216152605, 0.0254
# unit: (to SI, how often the displacement is derived)
UNITS = {
    "m/N": (1.0, 0),
    "mm/N": (1e-3, 0),
    "um/N": (1e-6, 0),
    "in/lbf": (INCH / POUND, 0),
    "uin/lbf": (1e-6 * INCH / POUND, 0),
    "(m/s)/N": (1.0, 1),
    "(mm/s)/N": (1e-3, 1),
    "(m/s2)/N": (1.0, 2),
    "(mm/s2)/N": (1e-3, 2),
    "g/N": (G, 2),
    "g/lbf": (G / POUND, 2),
}
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[EeDd][-+]?\d+)?"
COMMA_NUMBER = r"[-+]?(?:\d+,?\d*|,\d+)(?:[EeDd][-+]?\d+)?"
NOT_A_NUMBER = r"[-+]?(?:nan|inf|infinity)"


@dataclass
class Response:
    """frequencies in Hz; values in m/N."""

    frequencies: numpy.ndarray
    values: numpy.ndarray
    coherence: object = None
    axis: object = None
    is_acceleration: bool = False
    notes: list = field(default_factory=list)


def read(path, unit, frequency_unit, form):
    """The Response in a file; see Frf.read()."""
    name = os.path.basename(os.fspath(path))
    with open(path, "rb") as file:
        text = file.read().decode("utf-8-sig", errors="replace")
    if unit is not None:
        unit = _known_unit(unit)
    if frequency_unit not in (None, "Hz", "rad/s"):
        raise ValueError('The unit of frequencies is "Hz" or "rad/s", not %r.' % (frequency_unit,))
    if form not in (None, *FORMS):
        raise ValueError("The form is %s, not %r." % (" or ".join(FORMS), form))
    lines = text.splitlines()
    if any(line.strip() == "-1" for line in lines[:3]):
        return _universal(lines, name, unit)
    return _columns(lines, name, unit, frequency_unit, form)


def _known_unit(unit):
    plain = _plain(unit)
    for known in UNITS:
        if plain in (_plain(known), _plain(known).replace("(", "").replace(")", "")):
            return known
    raise ValueError("The unit is one of %s, not %r." % (", ".join(UNITS), unit))


def _plain(text):
    """Without blanks, carets and Greek: as the keys of UNITS are written, in small letters."""
    for old, new in (("\u00b5", "u"), ("\u03bc", "u"), ("\u00b2", "2"), ("^", ""), (" ", "")):
        text = text.replace(old, new)
    return text.replace("**", "").lower()


def _to_receptance(frequencies, values, unit, name):
    factor, derived = UNITS[unit]
    values = factor * values
    if derived:
        kept = frequencies > 0
        frequencies, values = frequencies[kept], values[kept]
        values = values / (2j * math.pi * frequencies) ** derived
    if len(frequencies) < 4:
        raise ValueError("%s has too few lines: at least four are needed." % name)
    return frequencies, values


# ---- text with columns ----


def _columns(lines, name, unit, frequency_unit, form):
    rows, header = [], []
    for line in lines:
        row = _numbers(line)
        if row is not None and len(row) >= 3:
            rows.append(row)
        elif not rows:
            header.append(line)
    if not rows:
        raise ValueError(
            "%s has no lines of frequency, real and imaginary part, or magnitude and phase." % name
        )
    width = min(len(row) for row in rows)
    table = numpy.array([row[:width] for row in rows])
    if not numpy.isfinite(table[:, :3]).all():
        raise ValueError("%s has a value that is no number." % name)
    words = " ".join(header)
    unit = unit or _unit_in(words)
    if unit is None:
        raise ValueError(
            "The unit of %s is unknown: name it, as unit='m/N'; there are %s."
            % (name, ", ".join(UNITS))
        )
    frequencies = table[:, 0]
    if frequency_unit == "rad/s" or (frequency_unit is None and "rad/s" in _plain(words)):
        frequencies = frequencies / (2 * math.pi)
    notes = []
    form = form or _form_in(words)
    if form is None:
        form = FORMS[1] if (table[:, 1] >= 0).all() and abs(table[:, 2]).max() > 4 else FORMS[0]
        notes.append("%s does not say what its columns are: taken as %s." % (name, form))
    if form == FORMS[0]:
        values = table[:, 1] + 1j * table[:, 2]
    else:
        values = table[:, 1] * numpy.exp(1j * numpy.radians(table[:, 2]))
    coherence = table[:, 3] if width > 3 else None
    if coherence is not None and ((coherence < 0) | (coherence > 1.000001)).any():
        coherence = None
    if (numpy.diff(frequencies) <= 0).any():
        raise ValueError("The frequencies of %s do not rise from line to line." % name)
    if coherence is not None and UNITS[unit][1]:
        coherence = coherence[frequencies > 0]
    frequencies, values = _to_receptance(frequencies, values, unit, name)
    return Response(frequencies, values, coherence, None, UNITS[unit][1] == 2, notes)


def _numbers(line):
    """The numbers of a line of nothing else, whatever separates them; None for other lines."""
    line = line.strip()
    for separator in (";", "\t", ",", None):
        if separator is not None and separator not in line:
            continue
        words = [word.strip() for word in line.split(separator)]
        if words and not words[-1]:
            words.pop()
        for pattern, is_comma in ((NUMBER, False), (COMMA_NUMBER, True)):
            if is_comma and separator == ",":
                continue
            if words and all(re.fullmatch(pattern + "|" + NOT_A_NUMBER, w, re.I) for w in words):
                return [
                    float(re.sub("[dD]", "e", w.replace(",", ".")) if _is_digit(w) else w)
                    for w in words
                ]
    return None


def _is_digit(word):
    return any(letter.isdigit() for letter in word)


def _unit_in(words):
    plain = _plain(words)
    # The longest first: mm/N holds m/N.
    for known in sorted(UNITS, key=len, reverse=True):
        spelt = _plain(known)
        for spelling in {spelt, spelt.replace("(", "").replace(")", "")}:
            if re.search(r"(?<![a-z0-9/])" + re.escape(spelling) + r"(?![a-z0-9])", plain):
                return known
    return None


def _form_in(words):
    plain = words.lower()
    if "phase" in plain:
        return FORMS[1]
    return FORMS[0] if "imag" in plain or re.search(r"\bim\b", plain) else None


# ---- universal file, dataset 58 ----

KINDS = {8: ("m", "m/N"), 11: ("m/s", "(m/s)/N"), 12: ("m/s2", "(m/s2)/N")}
AXES = {(1, 1): "xx", (2, 2): "yy", (1, 2): "xy", (2, 1): "xy"}


def _universal(lines, name, unit):
    for start, line in enumerate(lines[:-1]):
        if line.strip() == "-1" and lines[start + 1].split()[:1] == ["58"]:
            try:
                return _dataset(lines[start + 2 :], name, unit)
            except (IndexError, KeyError):
                raise ValueError(
                    "Dataset 58 of %s is incomplete or of another kind." % name
                ) from None
    raise ValueError("%s has no dataset 58, a function at nodal degrees of freedom." % name)


def _dataset(lines, name, unit):
    # Five lines of text, then fixed fields.
    if int(lines[5][:5]) != 4:
        raise ValueError("Dataset 58 of %s is no frequency response function." % name)
    kind, count, is_even = (int(lines[6][10 * i : 10 * i + 10]) for i in range(3))
    first, step = (float(lines[6][30 + 13 * i : 43 + 13 * i]) for i in range(2))
    abscissa, numerator, denominator = (int(lines[7 + i][:10]) for i in range(3))
    if abscissa not in (0, 18) or denominator not in (0, 13):
        raise ValueError("Dataset 58 of %s is no response to a force over frequency." % name)
    if kind not in (5, 6):
        raise ValueError("Dataset 58 of %s is not complex." % name)
    unit = unit or (KINDS[numerator][1] if numerator in KINDS else None)
    if unit is None:
        raise ValueError(
            "The unit of %s is unknown: name it, as unit='m/N'; there are %s."
            % (name, ", ".join(UNITS))
        )
    wanted = count * (2 if is_even else 3)
    numbers = []
    for line in lines[11:]:
        if line.strip() == "-1":
            break
        numbers += [float(re.sub("[dD]", "e", word)) for word in re.findall(NUMBER, line)]
    if len(numbers) < wanted:
        raise ValueError("Dataset 58 of %s ends too early." % name)
    table = numpy.array(numbers[:wanted]).reshape(count, -1)
    frequencies = first + step * numpy.arange(count) if is_even else table[:, 0]
    values = table[:, -2] + 1j * table[:, -1]
    frequencies, values = _to_receptance(frequencies, values, unit, name)
    return Response(frequencies, values, None, _axis(lines[5]), UNITS[unit][1] == 2)


def _axis(line):
    """Of the response's and the force's directions, 1 for x and 2 for y."""
    fields = line.split()
    try:
        return AXES.get((abs(int(line[51:55])), abs(int(line[76:80]))))
    except ValueError:
        return AXES.get((abs(int(fields[-4])), abs(int(fields[-1])))) if len(fields) > 4 else None
