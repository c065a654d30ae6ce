"""Frequency responses of the tool's tip: from files, from modes, and modes fitted to them."""

import math

import numpy

from evenload.dynamics import frf_files
from evenload.dynamics.modes import Mode, core

AXES = ("xx", "yy", "xy")
DIRECTIONS = {"xx": 0.0, "yy": 90.0}
GAP = 4.0  # a step between lines so many times its neighbours'
LINES_IN_PEAK = 5
COHERENT = 0.9
DRIFT_BELOW = 50.0  # Hz, where the integration of acceleration drifts
SAMPLED_STEP, SAMPLED_TO = 0.5, 2.5  # Hz, and of the highest frequency, for responses of modes


class Frf:
    """A frequency response: displacement by force, m/N, at frequencies in Hz.

    frequencies: rising, Hz. xx: response along x to a force along x, yy: y to y, xy: x to y;
    complex arrays of the same length, or None. coherence: array or None. notes: sentences on what
    is doubtful about it. Machine axes. Raises ValueError for frequencies that do not rise, values
    that are no numbers, lengths that differ. Between lines a cubic; below the first line its real
    part, above the last one 1/frequency^2.
    """

    def __init__(self, frequencies, xx=None, yy=None, xy=None, coherence=None, notes=()):
        self.frequencies = numpy.atleast_1d(numpy.asarray(frequencies, dtype=float))
        self.coherence, self.notes = coherence, list(notes)
        if not numpy.isfinite(self.frequencies).all() or (self.frequencies < 0).any():
            raise ValueError("The frequencies of the response must be numbers from 0 on.")
        if (numpy.diff(self.frequencies) <= 0).any():
            raise ValueError("The frequencies of the response must rise from line to line.")
        if xx is None and yy is None:
            raise ValueError("The response needs values of at least one axis, xx or yy.")
        for axis, values in zip(AXES, (xx, yy, xy)):
            setattr(self, axis, self._values(values))

    def _values(self, values):
        if values is None:
            return None
        values = numpy.atleast_1d(numpy.asarray(values, dtype=complex))
        if values.shape != self.frequencies.shape:
            raise ValueError("The response needs one value for each frequency.")
        if not numpy.isfinite(values).all():
            raise ValueError("The response has a value that is no number.")
        return values

    @classmethod
    def read(cls, path, unit=None, axis=None, frequency_unit=None, form=None):
        """The Frf of a file with one response: text with columns, or universal file 58 (ASCII).

        unit: m/N, mm/N, um/N, uin/lbf, (m/s)/N, (m/s2)/N or g/N; None: the file names it. axis:
        "xx", "yy" or "xy"; None: what the universal file says, else "xx". frequency_unit: "Hz" or
        "rad/s"; None: what the header says, else Hz. form: "real-imaginary" or "magnitude-phase"
        (degrees); None: what the header or the numbers tell. Accelerance and mobility are
        integrated. Raises ValueError, in a sentence, for files without a unit or response, gaps,
        too few lines.
        """
        data = frf_files.read(path, unit, frequency_unit, form)
        axis = axis or data.axis or "xx"
        if axis not in AXES:
            raise ValueError('The axis of a response is "xx", "yy" or "xy", not %r.' % (axis,))
        values = {"xx": None, "yy": None, "xy": None, axis: data.values}
        if axis == "xy":
            values["xx"] = numpy.zeros_like(data.values)
        frf = cls(data.frequencies, **values, coherence=data.coherence, notes=data.notes)
        frf.check()
        frf.notes += _doubts(data.frequencies, data.values, data.coherence, data.is_acceleration)
        return frf

    @classmethod
    def joined(cls, x, y, xy=None):
        """One Frf of those along x and y, and across, on the lines of the first."""
        f = x.frequencies
        own = y.xx if y.yy is None else y.yy
        yy = cls(y.frequencies, own).at(f)
        across = None if xy is None else cls(xy.frequencies, xy.xy).at(f)
        return cls(f, x.xx, yy, across, x.coherence, x.notes + y.notes)

    @classmethod
    def of_modes(cls, modes, frequencies=None):
        """The response that modes add up to; frequencies in Hz, by default each half up to 2.5
        times the highest.
        """
        modes = list(modes)
        receptance = core().Receptance.of_modes([mode.in_si() for mode in modes])
        if frequencies is None:
            highest = SAMPLED_TO * max(mode.frequency for mode in modes)
            frequencies = numpy.arange(SAMPLED_STEP, highest, SAMPLED_STEP)
        angular = 2 * math.pi * numpy.atleast_1d(numpy.asarray(frequencies, dtype=float))
        rows = numpy.array(receptance.at(angular.tolist())).reshape(-1, 4)
        return cls(frequencies, rows[:, 0], rows[:, 3], rows[:, 1])

    def check(self):
        """Raises ValueError where there are too few lines, or a gap between two."""
        if len(self.frequencies) < 4:
            raise ValueError("The response has too few lines: at least four are needed.")
        steps = numpy.diff(self.frequencies)
        beside = numpy.maximum(
            numpy.concatenate([steps[1:2], steps[:-1]]),
            numpy.concatenate([steps[1:], steps[-2:-1]]),
        )
        gaps = numpy.flatnonzero(steps > GAP * beside)
        if len(gaps):
            raise ValueError(
                "The response has a gap between %g and %g Hz: measure it again, or cut it there."
                % (self.frequencies[gaps[0]], self.frequencies[gaps[0] + 1])
            )

    @property
    def strongest(self):
        """Hz of the line with the largest response."""
        size = sum(abs(values) for values in (self.xx, self.yy) if values is not None)
        return float(self.frequencies[int(numpy.argmax(size))])

    def at(self, frequency, axis="xx"):
        """m/N at a frequency in Hz, a number or an array."""
        wanted = numpy.asarray(frequency, dtype=float)
        values = getattr(self, axis)
        if values is None:
            return numpy.zeros(wanted.shape, dtype=complex)
        if len(self.frequencies) < 4:
            near = numpy.argmin(abs(self.frequencies[:, None] - wanted.ravel()), axis=0)
            if not numpy.allclose(self.frequencies[near], wanted.ravel()):
                raise ValueError("The response has too few lines to look between them.")
            found = values[near]
        else:
            column = {"xx": 0, "xy": 1, "yy": 3}[axis]
            rows = self.receptance().at((2 * math.pi * wanted).ravel().tolist())
            found = numpy.array(rows).reshape(-1, 4)[:, column]
        return found.reshape(wanted.shape)[()]

    def receptance(self):
        """The core's Receptance."""
        self.check()
        lists = [
            [] if values is None else values.tolist() for values in (self.xx, self.yy, self.xy)
        ]
        return core().Receptance.of_lines((2 * math.pi * self.frequencies).tolist(), *lists)

    def fit(self, modes=1, lowest=None, highest=None):
        """The ModalFit: so many modes for each axis, fitted to the lines between two frequencies.

        Modes of xx lie along x, those of yy along y. Raises ValueError where lines are too few, or
        a mode comes out with a mass that is not above 0.
        """
        self.check()
        low = 0.0 if lowest is None else lowest
        high = math.inf if highest is None else highest
        kept = (self.frequencies >= max(low, 1e-9)) & (self.frequencies <= high)
        result = ModalFit()
        for axis in ("xx", "yy"):
            values = getattr(self, axis)
            if values is None or not abs(values).any():
                continue
            rows, error, drawn = core().fit_modes(
                (2 * math.pi * self.frequencies[kept]).tolist(), values[kept].tolist(), int(modes)
            )
            result += [
                Mode(mass, angular / (2 * math.pi), damping, DIRECTIONS[axis])
                for mass, angular, damping in rows
            ]
            result.error[axis] = error
            result.lines[axis] = (self.frequencies[kept], values[kept], numpy.array(drawn))
        return result


class ModalFit(list):
    """Modes that were fitted to a response.

    error: by axis, root mean square of what is left over that of the response. lines: by axis,
    (frequencies in Hz, measured, fitted), m/N.
    """

    def __init__(self, modes=()):
        super().__init__(modes)
        self.error, self.lines = {}, {}


def _doubts(frequencies, values, coherence, is_acceleration):
    """Sentences on what is doubtful about a response to a force at the same place."""
    notes = []
    peak = int(numpy.argmax(abs(values)))
    if values[peak].imag > 0:
        notes.append(
            "The imaginary part is positive at the peak at %g Hz: the sign, or the unit, is wrong."
            % frequencies[peak]
        )
    within = abs(values) >= abs(values[peak]) / math.sqrt(2)
    first = last = peak
    while first > 0 and within[first - 1]:
        first -= 1
    while last + 1 < len(values) and within[last + 1]:
        last += 1
    if last - first + 1 < LINES_IN_PEAK:
        notes.append(
            "The peak at %g Hz is %d lines wide: measure with a finer resolution."
            % (frequencies[peak], last - first + 1)
        )
    if coherence is not None and coherence[first : last + 1].min() < COHERENT:
        notes.append(
            "The coherence around %g Hz falls to %.2f: measure it again."
            % (frequencies[peak], coherence[first : last + 1].min())
        )
    if is_acceleration and frequencies[0] < DRIFT_BELOW:
        notes.append(
            "Below %g Hz the integration of the acceleration drifts: leave these lines out."
            % DRIFT_BELOW
        )
    return notes
