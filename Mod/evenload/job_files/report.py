"""Figures of an operation, its simulation, stability and inspection as dictionary and table."""

import math

# (key, property, unit, decimals) in the table's order
FIGURES = (
    ("engagement_deg", "EngagementAngle", "deg", 1),
    ("max_engagement_deg", "MaxEngagement", "deg", 1),
    ("cutting_time_s", "CuttingTime", "s", 1),
    ("ideal_time_s", "IdealTime", "s", 1),
    ("time_ratio", None, "", 2),
    ("removed_volume_mm3", "RemovedVolume", "mm3", 0),
    ("uncut_area_mm2", "UncutArea", "mm2", 2),
    ("cut_length_mm", None, "mm", 0),
    ("link_length_mm", None, "mm", 0),
    ("least_stepover_mm", "LeastStepover", "mm", 3),
    ("largest_stepover_mm", "LargestStepover", "mm", 3),
    ("passes", "Passes", "", 0),
    ("links", "Links", "", 0),
    ("retracts", "Retracts", "", 0),
    ("blocks", None, "", 0),
)
# (key, attribute of a Simulation, unit, decimals) of the rows that follow where there is one
SIMULATED = (
    ("simulated_engagement_deg", "max_engagement_deg", "deg", 1),
    ("simulated_entry_engagement_deg", "entry_engagement_deg", "deg", 1),
    ("simulated_removal_rate_mm3_min", "removal_rate_peak", "mm3/min", 0),
    ("simulated_removed_volume_mm3", "removed_volume_total", "mm3", 0),
    ("simulated_time_s", "time_total_s", "s", 1),
    ("simulated_machine_time_s", "machine_time_total_s", "s", 1),
    ("simulated_rest_area_mm2", "rest_area", "mm2", 2),
    ("simulated_gouge_mm", "gouge_mm", "mm", 3),
    ("simulated_fixture_mm", "fixture_mm", "mm", 3),
    ("simulated_rapid_in_material_mm", "rapid_in_material_mm", "mm", 2),
    ("simulated_plunge_in_material_mm", "plunge_in_material_mm", "mm", 2),
    ("simulated_air_mm", "air_mm", "mm", 0),
    ("simulated_force_n", "force_peak_max", "N", 0),
)
# (key, attribute of a Verdict, unit, decimals) of those where stability is judged
STABILITY = (
    ("stability_spectral_radius", "spectral_radius", "", 3),
    ("stability_feed_direction_deg", "feed_direction", "deg", 0),
    ("stability_limit_depth_mm", "limit_depth", "mm", 2),
    ("stability_chatter_hz", "chatter_hz", "Hz", 0),
    ("stability_stable_speed_rev_min", "stable_speed", "rev/min", 0),
)
# (key, attribute of an Evaluation, unit, decimals) of those where measured points are evaluated
INSPECTION = (
    ("inspection_zone_mm", "zone", "mm", 4),
    ("inspection_tolerance_mm", "tolerance", "mm", 4),
)
MOST_PLACES = 3  # of incidents that are named one by one
LABELS = {
    "engagement_deg": "engagement, target",
    "max_engagement_deg": "engagement, largest",
    "cutting_time_s": "time",
    "ideal_time_s": "time, ideal",
    "time_ratio": "time / ideal",
    "removed_volume_mm3": "removed volume",
    "uncut_area_mm2": "area left",
    "cut_length_mm": "length of cuts",
    "link_length_mm": "length of links",
    "least_stepover_mm": "stepover, least",
    "largest_stepover_mm": "stepover, largest",
    "passes": "passes",
    "links": "links",
    "retracts": "retracts",
    "blocks": "G-code blocks",
    "simulated_engagement_deg": "simulated: engagement",
    "simulated_entry_engagement_deg": "  entry's engagement",
    "simulated_removal_rate_mm3_min": "  removal rate, largest",
    "simulated_removed_volume_mm3": "  removed volume",
    "simulated_time_s": "  time",
    "simulated_machine_time_s": "  time on the machine",
    "simulated_rest_area_mm2": "  area left",
    "simulated_gouge_mm": "  gouge",
    "simulated_fixture_mm": "  into fixtures",
    "simulated_rapid_in_material_mm": "  rapids in material",
    "simulated_plunge_in_material_mm": "  plunges in material",
    "simulated_air_mm": "  cuts in air",
    "simulated_force_n": "  force, largest",
    "stability_spectral_radius": "stability: largest multiplier",
    "stability_feed_direction_deg": "  worst feed direction",
    "stability_limit_depth_mm": "  depth at the limit",
    "stability_chatter_hz": "  chatter",
    "stability_stable_speed_rev_min": "  nearest stable speed",
    "inspection_zone_mm": "inspection: zone",
    "inspection_tolerance_mm": "  tolerance",
}


def figures(op):
    """What an operation reports: {key: number}, units in the keys, and 'report', its text."""
    result = {}
    for key, prop, _, _ in FIGURES:
        if prop and hasattr(op, prop):  # not every kind of operation has every result
            value = getattr(op, prop)
            result[key] = float(getattr(value, "Value", value))
    if result.get("ideal_time_s", 0) > 0:
        result["time_ratio"] = result["cutting_time_s"] / result["ideal_time_s"]
    last = op.Proxy.last
    if last is not None:
        report = last.toolpath.report
        result["cut_length_mm"], result["link_length_mm"] = report.cut_length, report.link_length
    for key in ("passes", "links", "retracts"):
        result[key] = int(result[key])
    result["blocks"] = len(op.Path.Commands)
    result["report"] = op.Report
    return result


def simulated(simulation):
    """What a Simulation reports: {key: number}, units in the keys, and 'simulation', its notes and
    the places where something is wrong. What it has not got is left out.
    """
    result = {}
    for key, attribute, _, _ in SIMULATED:
        value = getattr(simulation, attribute)
        if value is not None:
            result[key] = float(value)
    result["simulation"] = "\n".join([*simulation.notes, *_incidents(simulation)])
    return result


def stability(verdict):
    """What a Verdict on stability reports: {key: number}, 'stable', and 'stability', its sentences.
    What there is not is left out: a limit beyond what was looked at, a speed that is not needed.
    """
    result = {"stable": verdict.is_stable}
    for key, attribute, _, _ in STABILITY:
        value = getattr(verdict, attribute)
        if value is not None and math.isfinite(value):
            result[key] = float(value)
    result["stability"] = "\n".join([verdict.sentence, *verdict.notes])
    return result


def inspected(evaluation):
    """What an Evaluation reports: {key: number}, 'inspection_verdict', None without a tolerance,
    'inspection_proved', and 'inspection', its sentences.
    """
    result = {
        "inspection_verdict": evaluation.verdict,
        "inspection_proved": bool(evaluation.found.is_proved),
        "inspection": "\n".join(evaluation.sentences),
    }
    for key, attribute, _, _ in INSPECTION:
        value = getattr(evaluation, attribute)
        if value is not None:
            result[key] = float(value)
    return result


def _incidents(simulation):
    """A sentence for each kind of incident, and one for what is left."""
    found = {}
    for what, x, y, z, *_ in simulation.incidents:
        found.setdefault(what, []).append("(%.3f, %.3f, %.3f)" % (x, y, z))
    sentences = []
    for what, places in found.items():
        more = " and %d more" % (len(places) - MOST_PLACES) if len(places) > MOST_PLACES else ""
        named = ", ".join(places[:MOST_PLACES])
        sentences.append("Simulated: %s near %s%s." % (what, named, more))
    if simulation.rests:
        area, x, y, depth = max(simulation.rests)
        sentences.append(
            "Simulated: %d places left; the largest has %.2f mm2, %.3f mm deep, near (%.3f, %.3f)."
            % (len(simulation.rests), area, depth, x, y)
        )
    return sentences


def table(jobs):
    """A table of jobs as in a batch's report: a column of figures each, then what they report."""
    done = [job for job in jobs if job["ok"]]
    lines = []
    if done:
        left = max(len(label) for label in LABELS.values())
        widths = [max(10, len(job["name"])) for job in done]
        every = (*FIGURES, *SIMULATED, *STABILITY, *INSPECTION)
        rows = [row for row in every if any(row[0] in job["figures"] for job in done)]
        wide = max(len(unit) for _, _, unit, _ in rows)
        head = " " * (left + wide + 1)
        lines.append(head + "".join("  " + j["name"].rjust(w) for j, w in zip(done, widths)))
        for key, _, unit, decimals in rows:
            cells = []
            for job, width in zip(done, widths):
                value = job["figures"].get(key)
                cells.append(
                    "  " + ("%.*f" % (decimals, value) if value is not None else "-").rjust(width)
                )
            lines.append(LABELS[key].ljust(left) + " " + unit.ljust(wide) + "".join(cells))
        for job in done:
            for key in ("report", "simulation", "stability", "inspection"):
                text = job["figures"].get(key, "")
                lines += ["%s: %s" % (job["name"], line) for line in text.splitlines()]
    lines += ["%s FAILED: %s" % (job["name"], job["error"]) for job in jobs if not job["ok"]]
    return "\n".join(lines)
