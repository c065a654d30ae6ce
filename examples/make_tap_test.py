"""Makes examples/tap_x.csv and tap_y.csv: tap tests as a laboratory exports them.

    PYTHONPATH=Mod python3 examples/make_tap_test.py

They are synthetic: the response of the modes below, with noise of 2 % of its peak, not measured on
a machine. A slender end mill of 6 mm, 30 mm out of its holder, on a bench mill.
"""

import os

import numpy
from evenload.dynamics import Frf, Mode

MODES = {
    "x": [Mode.from_stiffness(3.1, 812, 0.021), Mode.from_stiffness(14.0, 1730, 0.018)],
    "y": [Mode.from_stiffness(3.6, 871, 0.024), Mode.from_stiffness(16.0, 1810, 0.017)],
}
FREQUENCIES = numpy.arange(200.0, 2600.0, 2.0)  # Hz
NOISE = 0.02  # of the peak, in the real and in the imaginary part
HEADER = "frequency [Hz],real [um/N],imag [um/N],coherence"


def main():
    folder = os.path.dirname(os.path.abspath(__file__))
    for seed, (axis, modes) in enumerate(MODES.items()):
        values = 1e6 * Frf.of_modes(modes, FREQUENCIES).xx
        real, imaginary = numpy.random.default_rng(seed).normal(size=(2, len(values)))
        noise = NOISE * abs(values).max()
        coherence = 1 / (1 + (0.1 * noise / abs(values)) ** 2)
        values = values + noise * (real + 1j * imaginary)
        rows = zip(FREQUENCIES, values.real, values.imag, coherence)
        with open(os.path.join(folder, "tap_%s.csv" % axis), "w", encoding="utf-8") as file:
            file.write(HEADER + "\n")
            file.writelines("%.0f,%.5f,%.5f,%.4f\n" % row for row in rows)


if __name__ == "__main__":
    main()
