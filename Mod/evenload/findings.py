"""What the core found about a path, in words.

A finding is (code, where, numbers), as src/toolpath/finding.h lists them: where is (x, y) in mm or
None. The sentences name settings by their properties; evenload.settings.labels.told puts the
panels' labels there.
"""

import math

from evenload.refusals import largest_that_fits

TROCHOIDS = ("constant engagement", "Circular", "Cycloid")  # the core's TrochoidKind, in its order


def sentences(found):
    """A report's findings as sentences, in their order."""
    return [sentence(*finding) for finding in found]


def sentence(code, where=None, numbers=()):
    """One finding as a sentence. Raises KeyError for a code that there is not."""
    place = "" if where is None else "near (%.2f, %.2f)" % tuple(_unsigned(x) for x in where)
    said = SENTENCES[code]
    return said(place, *numbers) if callable(said) else said.format(*numbers, place=place)


def _unsigned(x):
    """mm; what would be shown as zero has no sign."""
    return 0.0 if abs(x) < 0.005 else x


def _skipped_pocket(place, tool, largest):
    said = "The pocket %s was skipped. The tool of %g mm does not fit into the pocket: %s"
    return said % (place, tool, largest_that_fits(largest))


def _tight_turns(place, radius, wish, rooms):
    places = "narrow places of %d rooms" % rooms if rooms > 1 else "narrow places"
    return "Turned more tightly than the wished %.3f mm in %s, down to %.3f mm %s." % (
        wish,
        places,
        radius,
        place,
    )


def _skipped_passage(why):
    def said(place, width, left):
        return "Skipped%s: the passage %s, %.2f mm wide at its narrowest%s." % (
            why,
            place,
            width,
            _left(left),
        )

    return said


def _reduced_passage(why):
    def said(place, width, left, engaged, feed):
        return (
            "Cut at reduced feed%s: the passage %s, %.2f mm wide at its narrowest, with up to "
            "%.0f° engaged, down to %.1f mm/min%s."
            % (why, place, width, math.degrees(engaged), feed, _left(left))
        )

    return said


def _left(area):
    return "; %.2f mm² stay uncut there" % area if area > 0 else ""


def _small_spiral(why):
    def said(place, share):
        return "The spiral clears only %.0f %% of this pocket%s." % (100 * share, why)

    return said


def _no_pattern(why):
    def said(place, kind):
        unused = ", Pattern %s was not used" % TROCHOIDS[int(kind)] if kind else ""
        return "No trochoid was repeated %s, %s: this region was cleared pass by pass%s." % (
            place,
            why,
            unused,
        )

    return said


TOO_NARROW = ", too narrow for trochoids"
SENTENCES = {
    "left_uncut": "Left uncut: {0:.2f} mm² {place}, where the tool has too little room to turn "
    "within the engagement limit.",
    "left_without_wall_pass": "Left uncut: {0:.2f} mm² {place}, for the turned-off WallPass, or "
    "where the tool has too little room to turn.",
    "left_beside_spiral": "Left uncut: {0:.1f} mm² that the spiral does not reach, for Rest is "
    "'Leave'.",
    "pocket_skipped": _skipped_pocket,
    "region_without_hole": "The region {place}, which does not hold the pre-drilled hole, was "
    "left uncut: choose the entry 'Automatic', or drill it and use an operation of its own.",
    "nothing_left": "Nothing was left to cut: earlier cuts have cleared all that this tool can "
    "reach.",
    "cancelled": "Cancelled before everything was cut.",
    "region_with_own_entry": "The region {place} does not hold the pre-drilled hole: it has an "
    "entry of its own.",
    "hole_in_skipped_passage": "The pre-drilled hole {place} lies in a narrow passage that is "
    "skipped: it was not used.",
    "hole_too_near_wall": "The pre-drilled hole {place} is too near to a wall to come down in: it "
    "was not used.",
    "hole_too_tight": "The pre-drilled hole is too tight to start from: it was not used.",
    "hole_beside_island": "The pre-drilled hole was not used: a spiral around an island begins "
    "beside its wall.",
    "hole_in_open_stock": "The pre-drilled hole was not used: a spiral around an island in open "
    "stock comes from outside.",
    "open_edges_taken_for_walls": "The open edges {place} leave no clear room outside: they were "
    "taken for walls.",
    "ramp_for_helix": "No helix fits: the tool comes down along a ramp instead.",
    "helix_for_ramp": "No cut leads on from a ramp: the tool comes down by a helix instead.",
    "helix_for_spiral": "Entry is a helix, not a ramp: in this pocket the spiral begins as a "
    "circle.",
    "helix_narrowed": "HelixDiameter {0:g} mm was taken as {1:g} mm: a wider helix would leave a "
    "post in its middle.",
    "tight_turns": _tight_turns,
    "thick_chips": "Chips get up to {0:.2f} times as thick as in a straight cut at the engagement "
    "angle, {place}: lower MaximumFeed, or choose another FeedControl, where that is too much.",
    "strong_force": "No feed down to a tenth of the nominal keeps the force at that of a straight "
    "cut at the engagement angle {place}: raise EngagementAngle or HorizFeed, or choose another "
    "FeedControl.",
    "passage_skipped": _skipped_passage(""),
    "passage_skipped_too_narrow": _skipped_passage(TOO_NARROW),
    "passage_reduced": _reduced_passage(""),
    "passage_reduced_too_narrow": _reduced_passage(TOO_NARROW),
    "rest_by_trochoids": "What earlier operations left in narrow passages is cut by trochoids, "
    "not at a reduced feed.",
    "spiral_of_set_size": _small_spiral(", for SemiAxisA or SemiAxisB is set"),
    "spiral_after_channel": _small_spiral(
        ": the channel along its island, from which it begins, takes most of the rest"
    ),
    "small_pitch": "Pitch is smaller than set in some turns, down to {0:.3f} mm: the engagement "
    "angle allows no more there.",
    "tight_spiral": "The spiral turns more tightly than MinimumRadius, down to {0:.3f} mm: raise "
    "ExponentStart or ExponentEnd, or make the courses more even.",
    "idle_course": "ExponentCourse changes nothing: the first and the last exponent are the same.",
    "no_spiral": "No spiral was made: with narrow passages it is cleared at constant engagement; "
    "set NarrowPassages to 'Skip and report' for a spiral.",
    "region_without_spiral": "A region has no spiral: with narrow passages it is cleared at "
    "constant engagement; set NarrowPassages to 'Skip and report' for a spiral.",
    "slow_spiral": "At a constant feed the uneven turns of this spiral are slow: the feed control "
    "'Constant removal rate' or the operation Adaptive is faster.",
    "no_pattern_after_cuts": _no_pattern(
        "where earlier cuts left the material in pieces of any shape"
    ),
    "no_pattern_between_walls": _no_pattern(
        "where no walls stay equally far apart, straight or as arcs about one centre, for as long "
        "as the slot is wide"
    ),
    "no_pattern_so_wide": _no_pattern("where the walls are more than four tool diameters apart"),
    "no_pattern_so_short": _no_pattern("where the slot is too short for a few periods"),
    "no_pattern_without_room": _no_pattern(
        "where the tool has too little room to turn in the slot"
    ),
    "no_pattern_without_start": _no_pattern("where no ground for a first period could be cleared"),
    "circles_for_pattern": "The slot {place} is so little wider than the tool that posts would "
    "write the turns of constant engagement as lines with corners: circles are repeated there.",
    "advance_unsettled": "After {0:.0f} passes the trochoid's advance still differed by {1:.4f} "
    "mm across the slot: the greatest step was taken that keeps the engagement angle.",
}
