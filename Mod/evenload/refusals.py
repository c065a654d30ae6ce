"""What the core cannot work on, in words.

A refusal is (kind, where, numbers), as src/support/refusal.h lists them: where is (x, y) in mm. The
core knows no words: whenever it raises its GeometryError, the binding asks `sentence` for the text,
so that str(error) is a sentence for scripts, operations and the window alike; the error's `code`,
`kind`, `where` and `numbers` are for code. Sentences name settings by their properties;
evenload.settings.labels.told puts the panels' labels there, evenload.settings.sentences the user's
language.
"""


def sentence(kind, where, numbers=(), is_one_of_several=False):
    """A refusal as a sentence. is_one_of_several: of several regions the one at `where` is refused.
    Raises KeyError for a kind that there is not.
    """
    said = SENTENCES[kind]
    told = said(*where, *numbers) if callable(said) else said
    return "The region near (%.2f, %.2f): %s" % (*where, told) if is_one_of_several else told


def largest_that_fits(diameter):
    """What a sentence on a tool too large ends with. diameter: mm, 0 where no tool fits."""
    if diameter > 0:
        return "the largest tool that fits has %g mm." % diameter
    return "no tool does, lower StockToLeave."


def _at(said):
    """A sentence with its place."""
    return lambda x, y, *numbers: said % (x, y)


def _of_curve(said):
    """A sentence that begins with the outline or an island, and has all that comes with it."""

    def told(x, y, number, *rest):
        return said % ("An island" if number else "The outline", x, y, *rest)

    return told


def _too_large(x, y, tool, largest):
    said = "The tool of %g mm does not fit into the pocket: %s"
    return said % (tool, largest_that_fits(largest))


def _of_share(said):
    return lambda x, y, share: said % (100 * share)


SENTENCES = {
    # Outlines
    "curve_not_finite": _of_curve(
        "%s has a coordinate that is not a number, after the point near (%g, %g): draw this piece "
        "again."
    ),
    "curve_not_closed": _of_curve(
        "%s is not closed: it ends near (%g, %g): join this end to its start at (%g, %g) in the "
        "sketch."
    ),
    "curve_without_area": _of_curve(
        "%s encloses no area near (%g, %g): draw it as a closed curve of at least two pieces."
    ),
    "outline_crosses_itself": _at(
        "The outline crosses or touches itself near (%g, %g): remove the crossing in the sketch."
    ),
    "island_crosses_itself": _at(
        "An island crosses or touches itself near (%g, %g): remove the crossing in the sketch."
    ),
    "outline_crosses_island": _at(
        "The outline and an island cross or touch near (%g, %g): move them apart in the sketch, or "
        "join them into one curve."
    ),
    "islands_cross": _at(
        "Two islands cross or touch near (%g, %g): move them apart in the sketch, or join them "
        "into one curve."
    ),
    "island_outside_outline": _at(
        "An island lies outside the outline near (%g, %g): move it inside or remove it."
    ),
    "island_inside_another": _at(
        "An island lies inside another island near (%g, %g): remove the inner one, or make it a "
        "pocket of its own."
    ),
    # Middles of slots
    "middle_not_finite": "The slot's middle must have finite coordinates.",
    "middle_without_length": "The slot's middle has no length: draw a line or an arc along the "
    "slot.",
    "middle_crosses_itself": "The slot's middle crosses itself: divide it into slots that do not.",
    "middle_bends_too_tightly": "The slot's middle bends more tightly than half the slot's width: "
    "make the slot narrower, or bend it less.",
    "slot_sides_meet": "The slot's sides meet each other: make the slot narrower, or move the "
    "parts of its middle further apart.",
    # Room for the tool
    "tool_fits_nowhere": _too_large,
    "no_room_to_descend": "The tool has no room to descend in this pocket: drill a hole first and "
    "choose the entry 'Predrilled hole', or take a smaller tool.",
    # Pre-drilled holes
    "hole_out_of_reach": "The pre-drilled hole's centre lies outside the ground that the tool can "
    "reach: move EntryPoint into the pocket, at least a tool's radius from its walls.",
    "hole_in_skipped_passage": "The pre-drilled hole lies in a narrow passage that is skipped: "
    "choose the entry 'Automatic', or another NarrowPassages.",
    "hole_too_tight": "The pre-drilled hole is too tight to start from: drill it wider, or choose "
    "the entry 'Automatic' or 'Helix'.",
    "hole_outside_pocket": "The pre-drilled hole lies outside this pocket: choose the entry "
    "'Automatic', or another hole.",
    "hole_too_tight_for_spiral": "The pre-drilled hole is too tight to start a spiral from: drill "
    "it wider, move EntryPoint towards the middle, or choose the entry 'Helix'.",
    "hole_off_middle": "No Lamé spiral leads from the pre-drilled hole to the pocket's walls: move "
    "EntryPoint towards the middle, or choose the entry 'Helix'.",
    "hole_beside_channel": "A Lamé spiral around an island begins beside its wall: drill the hole "
    "there, or choose the entry 'Automatic'.",
    "hole_at_island": "A Lamé spiral around an island in open stock comes from outside, not from a "
    "hole: choose the entry 'Automatic'.",
    # Lamé spirals
    "not_for_spirals": "A Lamé spiral clears pockets without islands, or with one island and an "
    "outline that is all wall or all open: take the operation Adaptive.",
    "centre_outside": "Centre lies outside the pocket: move it inside, or leave it unset.",
    "no_curve_as_set": "With the set properties no Lamé curve keeps clear of the walls: leave some "
    "of them unset, or take the operation Adaptive.",
    "no_curve": "No Lamé curve resembles this pocket: take the operation Adaptive.",
    "set_size_too_small": "SemiAxisA and SemiAxisB leave no room for a spiral around its entry: "
    "set larger ones, or leave them unset.",
    "spiral_too_small": _of_share(
        "A Lamé spiral would clear only %.0f %% of this pocket: take the operation Adaptive."
    ),
    "spiral_too_small_at_centre": _of_share(
        "With this Centre the largest spiral would clear %.0f %% of this pocket: move Centre "
        "towards the middle, leave it unset, or take the operation Adaptive."
    ),
    "spiral_too_small_as_set": _of_share(
        "With the set Segments, ExponentEnd or Rotation the largest spiral would clear %.0f %% of "
        "this pocket: leave them unset, or take the operation Adaptive."
    ),
    "no_room_for_spiral": "Between the walls there is too little room for a Lamé spiral: take the "
    "operation Adaptive.",
    "no_growth": "No Lamé spiral leads from one outline of this pocket to the other: take the "
    "operation Adaptive.",
    "no_growth_by_courses": "With these courses no Lamé spiral leads from its first turn to its "
    "last: leave SemiAxisACourse, SemiAxisBCourse and ExponentCourse empty, or take the operation "
    "Adaptive.",
    "no_load": "No Lamé spiral keeps to the engagement angle in this pocket: take the operation "
    "Adaptive.",
    "no_load_by_courses": "With these courses no Lamé spiral keeps to the engagement angle: make "
    "SemiAxisACourse, SemiAxisBCourse and ExponentCourse more even, or leave them empty.",
    "two_courses": "Only curves of four segments have two courses: set SemiAxisACourse and "
    "SemiAxisBCourse to the same values, or leave one of them empty.",
}
