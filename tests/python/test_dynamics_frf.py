"""Tap tests: files, fitted modes, tools in holders."""

import math

import numpy
import pytest
from dynamics_cases import REFERENCE
from evenload.dynamics import Frf, Mode, beams, couple

MODES = [Mode(0.3, 620, 0.031), Mode(0.08, 940, 0.018), Mode(0.05, 1760, 0.024)]
LINES = numpy.arange(100.0, 3000.0, 1.0)


def measured(noise=0.0, seed=1):
    frf = Frf.of_modes(MODES, LINES)
    random = numpy.random.default_rng(seed)
    frf.xx = frf.xx * (
        1 + noise * (random.normal(size=LINES.size) + 1j * random.normal(size=LINES.size))
    )
    return frf


def write(folder, rows, header="", separator=",", comma=False, name="tap.csv"):
    lines = [separator.join("%.9e" % number for number in row) for row in rows]
    text = header + "\n".join(lines) + "\n"
    path = folder / name
    path.write_text(text.replace(".", ",") if comma else text)
    return path


# ---- text files ----


def test_columns_are_read_whatever_separates_them(tmp_path):
    values = measured().xx
    rows = list(zip(LINES, 1e6 * values.real, 1e6 * values.imag))
    for separator, comma in ((",", False), (";", False), (";", True), ("\t", True), (" ", False)):
        header = "Tap test of spindle 3\nfrequency (Hz)%sreal (um/N)%simag (um/N)\n" % (
            separator,
            separator,
        )
        path = write(tmp_path, rows, header, separator, comma)
        frf = Frf.read(path)
        assert frf.frequencies == pytest.approx(LINES)
        assert frf.xx == pytest.approx(values, rel=1e-6)
        assert frf.notes == []


def test_magnitude_phase_and_coherence_are_read(tmp_path):
    values = measured().xx
    rows = zip(LINES, abs(values), numpy.degrees(numpy.angle(values)), 0.99 + 0 * LINES)
    path = write(tmp_path, rows, "frequency, magnitude (m/N), phase (deg), coherence\n")
    frf = Frf.read(path, axis="yy")
    assert frf.yy == pytest.approx(values, rel=1e-6) and frf.xx is None
    assert frf.coherence == pytest.approx(0.99)


def test_accelerance_and_mobility_are_integrated(tmp_path):
    values = measured().xx
    angular = 2 * math.pi * LINES
    for unit, factor in (
        ("g/N", -(angular**2) / 9.80665),
        ("(m/s2)/N", -(angular**2)),
        ("m/s^2/N", -(angular**2)),
        ("(m/s)/N", 1j * angular),
        ("mm/N", 1e3),
        ("uin/lbf", 4.4482216152605 / 25.4e-9),
    ):
        there = values * factor
        path = write(tmp_path, zip(LINES, there.real, there.imag))
        assert Frf.read(path, unit=unit).xx == pytest.approx(values, rel=1e-6)


def test_frequencies_in_rad_per_second_are_told_by_the_header(tmp_path):
    values = measured().xx
    rows = list(zip(2 * math.pi * LINES, values.real, values.imag))
    path = write(tmp_path, rows, "omega (rad/s), real (m/N), imag\n")
    assert Frf.read(path).frequencies == pytest.approx(LINES)
    path = write(tmp_path, rows)
    assert Frf.read(path, "m/N", frequency_unit="rad/s").frequencies == pytest.approx(LINES)


def universal(values, kind, even, double=False):
    """Dataset 58 of an accelerance along x."""
    number = (lambda n: "%20.11E" % n) if double else (lambda n: "%13.5E" % n)
    numbers = []
    for frequency, value in zip(LINES, values):
        numbers += ([] if even else [frequency]) + [value.real, value.imag]
    per_line = (4 if even else 3) if double else 6
    body = [
        "".join(number(n) for n in numbers[i : i + per_line])
        for i in range(0, len(numbers), per_line)
    ]
    head = [
        "    -1",
        "    58",
        *("text",) * 5,
        "    4         1    1         0       tool         1   1       tool         1   1",
        "%10d%10d%10d%13.5E%13.5E%13.5E" % (6 if double else 5, len(LINES), even, 100, 1, 0),
        "        18    0    0    0            Frequency                   Hz",
        "%10d    0    0    0         Response                 NONE" % kind,
        "        13    0    0    0                Force                    N",
        "         0    0    0    0                 NONE                 NONE",
    ]
    return "\n".join([*head, *body, "    -1", ""])


@pytest.mark.parametrize("even", [1, 0])
@pytest.mark.parametrize("double", [False, True])
def test_universal_files_are_read(tmp_path, even, double):
    values = measured().xx
    path = tmp_path / "tap.unv"
    for kind, factor in ((8, 1), (11, 2j * math.pi * LINES), (12, -((2 * math.pi * LINES) ** 2))):
        path.write_text(universal(values * factor, kind, even, double))
        frf = Frf.read(path)
        assert frf.frequencies == pytest.approx(LINES, rel=1e-5)
        assert abs(frf.xx - values).max() < 1e-5 * abs(values).max()


@pytest.mark.parametrize(
    "change, words",
    [
        (lambda rows: rows[:3], "too few lines"),
        (lambda rows: rows[::-1], "do not rise"),
        (lambda rows: rows[:50] + rows[90:], "gap between 149 and 190 Hz"),
        (lambda rows: rows[:5] + [(rows[5][0], math.nan, 0.0)] + rows[6:], "no number"),
        (lambda rows: [], "no lines of frequency"),
    ],
)
def test_files_that_cannot_be_used_are_refused(tmp_path, change, words):
    values = measured().xx
    rows = [tuple(row) for row in zip(LINES, values.real, values.imag)]
    with pytest.raises(ValueError, match=words) as refusal:
        Frf.read(write(tmp_path, change(rows)), unit="m/N")
    assert str(refusal.value).endswith(".")


def test_an_unknown_unit_is_asked_for(tmp_path):
    values = measured().xx
    path = write(tmp_path, zip(LINES, values.real, values.imag))
    with pytest.raises(ValueError, match="unit of tap.csv is unknown: name it"):
        Frf.read(path)
    with pytest.raises(ValueError, match="unit is one of"):
        Frf.read(path, unit="furlong/N")


def test_what_is_doubtful_is_noted(tmp_path):
    values = measured().xx
    path = write(tmp_path, zip(LINES, -values.real, -values.imag), "real (m/N) imag\n")
    assert "imaginary part is positive" in Frf.read(path).notes[0]
    coherence = numpy.where(abs(LINES - 940) < 5, 0.5, 1)
    rows = zip(LINES, values.real, values.imag, coherence)
    assert "coherence" in Frf.read(write(tmp_path, rows, "real (m/N) imag\n")).notes[0]
    coarse = list(zip(LINES, values.real, values.imag))[::20]
    assert "finer resolution" in Frf.read(write(tmp_path, coarse, "real (m/N) imag\n")).notes[0]


# ---- fitted modes ----


def test_modes_are_found_in_noise():
    fitted = measured(0.02).fit(modes=3)
    for found, mode in zip(fitted, MODES):
        assert found.frequency == pytest.approx(mode.frequency, rel=1e-3)
        assert found.damping_ratio == pytest.approx(mode.damping_ratio, rel=0.05)
        assert found.stiffness == pytest.approx(mode.stiffness, rel=0.03)
    assert 0.01 < fitted.error["xx"] < 0.04
    frequencies, given, drawn = fitted.lines["xx"]
    assert len(frequencies) == len(given) == len(drawn) == len(LINES)


def test_modes_along_y_are_told_by_their_direction():
    x = Frf.of_modes(MODES, LINES)
    y = Frf(LINES, yy=Frf.of_modes([Mode(0.2, 800, 0.02)], LINES).xx)
    both = Frf.joined(x, y).fit(modes=1, lowest=700, highest=1200)
    assert [mode.direction for mode in both] == [0, 90]
    assert both[1].frequency == pytest.approx(800, rel=1e-4)


def test_a_response_of_modes_is_theirs_between_its_lines():
    frf = Frf.of_modes(MODES, LINES)
    between = LINES[400:1200] + 0.5
    assert abs(frf.at(between) - Frf.of_modes(MODES, between).xx).max() < 1e-3 * abs(frf.xx).max()
    with pytest.raises(ValueError, match="rise"):
        Frf([1, 3, 2, 4], [1, 1, 1, 1])
    with pytest.raises(ValueError, match="no number"):
        Frf([1, 2, 3, 4], [1, 1, math.nan, 1])


# ---- slender tools ----

SLENDER = REFERENCE["slender_tool"]
CARBIDE = (580, 14450, 0.22)


def test_frequencies_of_slender_tools_are_the_reference_s():
    steel = (205, 7850, 0.29)
    for segments, key in (
        ([(60, 10)], "timoshenko"),
        ([(60, 10), (80, 40, steel)], "stepped"),
        ([(20, 8), (40, 10)], "fluted"),
    ):
        found = beams.clamped_frequencies(segments, CARBIDE)[:3]
        assert found == pytest.approx(SLENDER[key], rel=1e-5)


def test_tips_of_tools_in_holders_are_the_reference_s():
    holder = [Mode.from_stiffness(20, 900, 0.03)]
    tool, material = [(60, 10)], (*CARBIDE, 0.003)
    for joint, name in ((None, "modal"), ((50, 2e4), "joint")):
        tip = couple(holder, tool, material, joint=joint, frequencies=[1000, 2300])
        for frequency in (1000, 2300):
            expected = complex(*SLENDER["%s_%dHz" % (name, frequency)])
            assert abs(1e6 * tip.at(frequency) - expected) < 1e-4 * abs(expected)
    fine = couple(holder, tool, material, frequencies=numpy.arange(100, 3000, 0.25))
    peaks = [f for f in (845.8521, 2512.405)]
    for peak, size in zip(peaks, SLENDER["modal_peak_magnitudes"]):
        near = abs(fine.frequencies - peak) < 50
        assert 1e6 * abs(fine.xx[near]).max() == pytest.approx(size, rel=0.01)
    sampled = couple(Frf.of_modes(holder), tool, material)
    assert abs(sampled.at(1000) / tip_at(holder, tool, material, 1000) - 1) < 1e-4


def tip_at(holder, tool, material, frequency):
    return couple(holder, tool, material, frequencies=[frequency]).at(frequency)


def test_a_rigid_holder_leaves_the_tool_s_own_flexibility():
    tip = couple(None, [(60, 10)], CARBIDE, frequencies=[1e-3])
    assert 1e6 * tip.xx[0].real == pytest.approx(SLENDER["static"], rel=1e-6)
    with pytest.raises(ValueError, match="material is"):
        couple(None, [(60, 10)], "wood")
    with pytest.raises(ValueError, match="length and a diameter"):
        couple(None, [(0, 10)], "carbide", frequencies=[100])
