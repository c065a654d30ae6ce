"""The milling processes of tests/dynamics_reference.json: values of an independent computation."""

import json
from pathlib import Path

from evenload.dynamics import Milling, Mode

REFERENCE = json.loads(
    (Path(__file__).resolve().parents[1] / "dynamics_reference.json").read_text()
)


def modes(name):
    return [
        Mode(mass, frequency, damping, direction)
        for mass, frequency, damping, direction in REFERENCE["cases"][name]["modes"]
    ]


def case(name, **changes):
    """The Milling of a case, in the words and units of evenload.dynamics."""
    row = REFERENCE["cases"][name]
    return Milling(
        **{
            "modes": modes(name),
            "teeth": row["N"],
            "tangential": row["Kt"] / 1e6,
            "normal": row["Kn"] / 1e6,
            "cut_mode": {"up": "conventional", "down": "climb"}[row["cut"]],
            "immersion": row["aD"],
            "diameter": 2e3 * row["R"],
            "helix_pitch": 1e3 * row["pitch"] if row["pitch"] else None,
            "tooth_angles": row["teeth"],
            "feed_direction": row["feed"],
            "process_damping": row["Cpd"],
            "flank_friction": row["mu"],
            **changes,
        }
    )


def helical(cut, immersion=0.1):
    """The tool of 8 mm with a helix of 45 degrees that surfaces are told for."""
    mode = modes("iso_down")
    return Milling(
        mode,
        2,
        600,
        200,
        {"up": "conventional", "down": "climb"}[cut],
        immersion,
        diameter=8,
        helix_angle=45,
    )
