# The four feed controls on the star, and a least load: the time each takes, and what the simulator
# finds of what it holds, as multiples of a straight cut's at the engagement angle and the nominal
# feed.
import math

import evenload
import numpy
import pocket_case
from evenload import _core, materials
from evenload.simulation import HELIX_ANGLE_DEG
from judged_path import LEAST_LOAD

# By name: the control and its least load.
CONTROLS = {
    "constant feed": ("constant feed", 0.0),
    "constant removal rate": ("constant removal rate", 0.0),
    "constant removal rate, evenly": ("constant removal rate", LEAST_LOAD),
    "constant chip thickness": ("constant chip thickness", 0.0),
    "constant force": ("constant force", 0.0),
}
MATERIAL, SPINDLE_SPEED, TEETH = "Star test piece", 6366, 1
WINDOW = 0.1  # mm of path over which a removal rate is a mean
CUT = 3  # kind of a move


def coefficients():
    row = materials.load(MATERIAL)
    return _core.ForceCoefficients(row["ktc"], row["krc"], row["kte"], row["kre"])


def straight_cut(case):
    """(largest force in N, largest chip thickness in mm, removal rate in mm3/min)."""
    radius, angle = case["tool"] / 2, math.radians(case["engagement_deg"])
    feed_per_tooth = case["feed"] / (SPINDLE_SPEED * TEETH)
    model = _core.ForceModel(coefficients(), radius, TEETH, math.radians(HELIX_ANGLE_DEG))
    arc = (-math.pi / 2, angle - math.pi / 2, case["axial_depth"])
    force = model.force([arc], feed_per_tooth, SPINDLE_SPEED).peak_xy
    rate = radius * (1 - math.cos(angle)) * case["axial_depth"] * case["feed"]
    return force, feed_per_tooth * math.sin(min(angle, math.pi / 2)), rate


def well_loaded(run, rate, maximum_feed):
    """Of the length that is cut in material below the maximum feed, the share with at least 0.85
    of the nominal removal rate.
    """
    where = (run.kind == CUT) & (run.engagement_deg > 0) & (run.feed < maximum_feed * (1 - 1e-6))
    length = run.length[where]
    return length[run.removal_rate[where] >= 0.85 * rate].sum() / length.sum()


def figures():
    case = pocket_case.load("star")
    force, chip, rate = straight_cut(case)
    for name, (control, least_load) in CONTROLS.items():
        path = pocket_case.path_of(
            case,
            feed_control=control,
            least_load=least_load,
            force_coefficients=coefficients(),
            teeth=TEETH,
            tool_helix_angle=math.radians(HELIX_ANGLE_DEG),
            spindle_speed=SPINDLE_SPEED,
        )
        run = evenload.simulate(
            path,
            **pocket_case.scene(case),
            cutting={"material": MATERIAL, "spindle_speed": SPINDLE_SPEED},
        )
        prefix = "feed.star.%s." % name.replace(",", "").replace(" ", "_")
        cuts = run.kind == CUT
        yield prefix + "time", path.report.cutting_time, "s"
        yield prefix + "peak_force_ratio", run.force_peak_max / force, ""
        yield prefix + "largest_chip_ratio", numpy.nanmax(run.h_max[cuts]) / chip, ""
        yield prefix + "removal_rate_ratio", run.removal_rate_peak / rate, ""
        yield prefix + "moves", len(path.moves), ""
        if control == "constant removal rate":
            yield prefix + "well_loaded", well_loaded(run, rate, case["max_feed"]), ""
