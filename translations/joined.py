"""Sentences that no single text of Mod/evenload holds.

Those of the core, which C++ puts together from pieces, and those of Python that are joined from
several. tests/python/test_translations.py holds both against the sources.
"""

# What C++ tells of geometry, settings and paths that come from the window. A list of files: a new
# sentence in one of these is looked for below.
FILES_OF_THE_CORE = (
    *("src/occt/regions.cpp", "src/occt/join.cpp", "src/occt/edge_curve.cpp"),
    *("src/occt/triangles.cpp", "src/geometry/slot_around.cpp", "src/feed/load_share.cpp"),
    *("src/strategy/lame/lame_clearing.cpp", "src/strategy/lame/lame_pitch.cpp"),
    *("src/surface/contours.cpp", "src/surface/spacing.cpp", "src/dynamics/modal_fit.cpp"),
    *("src/surface/finish.cpp", "src/surface/guides.cpp", "src/surface/spiral.cpp"),
    "src/surface/contours_by_cusp.cpp",
    *("src/ball_end/bent_surface.cpp", "src/ball_end/chip.cpp"),
    *("src/simulate/dexel_stock.cpp", "src/inspection/fit.cpp"),
)
SENTENCES_OF_THE_CORE = (
    # src/occt
    "The shape is no readable BREP text.",
    "The face is not flat: pick a flat face that is parallel to XY.",
    "The face is tilted by %g degrees: pick one that is parallel to XY.",
    "The face has no boundary: pick a finite one.",
    "An edge climbs by %g mm: pick edges and sketches that are parallel to XY.",
    "Two outlines cross or touch: keep them apart, or draw what they enclose together as one.",
    "There is neither a face nor an edge to work on: pick a face or a sketch.",
    "The tolerance must be above 0 mm.",
    "OpenCASCADE could not work on the shape: %s.",
    "OpenCASCADE could not triangulate the shape: %s.",
    "The shape has no face.",
    "The deflection and the angle must be positive.",
    "More than two edges meet at (%g, %g): leave only the outline's own, without doubles.",
    "The outline is open at (%g, %g), the nearest other end is %g mm away: close it.",
    "An edge has no end: pick edges of finite length.",
    # src/geometry
    "The slot's width must be positive: set SlotWidth.",
    # src/strategy
    "Segments must lie between 3 and 12.",
    "SemiAxisA and SemiAxisB must be positive lengths.",
    "ExponentStart and ExponentEnd must lie between 0.05 and 1: above 1 the spiral has corners.",
    "Rotation must be finite.",
    "Pitch must be positive.",
    "Centre must be finite.",
    "Semi-axes of two lengths need Segments 4: set both to the same length, or leave one unset.",
    "%s must be 2 to 20 values that begin with 0, end with 1 and never fall, as 0, 0.1, 0.4, 1.",
    "A Lamé spiral cannot clear what earlier operations left: turn UseRestMachining off, or take "
    "the operation Adaptive.",
    "The spiral would take more than 2000 turns: raise EngagementAngle or Pitch, make courses more "
    "even, or take the operation Adaptive.",
    # src/surface: finish, guides, spiral, contours_by_cusp
    "A number for finishing is not finite.",
    "The tool's radius must be positive.",
    "The corner's radius must lie between 0 and the tool's radius.",
    "The stepover must be positive and no more than the tool's diameter.",
    "The cusp height must not be negative.",
    "A flat end mill leaves steps, not cusps: set a stepover, or take a ball end mill.",
    "The cusp height makes too many passes: raise it.",
    "The cusp height must be no more than the radius of the tool's ball or corner.",
    "The allowance must not be negative.",
    "The extension must not be negative.",
    "The lead radius must not be negative.",
    "The clearance of fixtures must not be negative.",
    "The fixtures leave the tool none of the picked faces: move them, or lower FixtureClearance.",
    "Passes between guides need two of them.",
    "The tolerance must be positive.",
    "Feeds must be positive.",
    "The safe height must not lie below the top, nor the clearance height below it.",
    "The stepover makes too many passes: raise it.",
    "The tool touches none of the picked faces: take a smaller one, or lower FinalDepth.",
    "A guide has no length: pick another edge.",
    "The guides cross each other: pick two that lie side by side.",
    # src/ball_end
    "A patch needs two curvatures in 1/mm, a slope from 0 to below 90 degrees and the direction "
    "in which it leans.",
    "The ball does not fit into the concave surface: take a tool whose radius is smaller.",
    "Steps on a patch are measured on the centre or on the surface, not in plan.",
    "No chip: earlier passes left no stock where the tool stands.",
    "The chip reaches beyond the lower half of the ball: the surface is too steep for a ball-end "
    "tool along its axis.",
    "The feed per tooth is too large beside the stepover: the tooth before does not bound the "
    "chip, which has no mean thickness by its face.",
    "The tool's diameter must be above 0 mm.",
    "The feed per tooth must lie above 0 mm and below the tool's radius.",
    "The stepover must lie above 0 mm and below the tool's diameter.",
    "The axial depth, the stock's allowance, must lie above 0 mm and below the tool's radius.",
    "The feed direction must be a number of degrees.",
    # src/feed, src/surface, src/simulate, src/dynamics, src/inspection
    "A constant force needs a material that resists: give it a force coefficient above 0.",
    "A constant force needs the spindle's speed: set that of the tool controller.",
    "None of the picked faces can be seen from above: pick others, or turn the model.",
    "The stock would need too many dexels: choose a coarser resolution.",
    "The resolution is coarser than the stock is wide: choose a finer one.",
    "The stock has no region: give it one.",
    "The stock has no upper side: give it one.",
    "The stock's top and bottom must be numbers, in mm.",
    "The resolution must be positive, in mm.",
    "The stock's top must lie above its bottom.",
    "At least one mode must be fitted.",
    "The frequency response has too few lines for so many modes.",
    "A mode was found whose mass is not above 0: ask for fewer modes, or turn the sign of the "
    "response.",
    "The points are too few: this feature needs %d at least.",
    "A point has a coordinate that is not a number: leave it out.",
    "The points all lie in one place: a line needs two places at least.",
    "The points lie on one line: a plane needs points beside it.",
    "The points lie on one line, or in two places: a circle needs three places off a line.",
    "The points lie in one plane or on one circle: a sphere needs points beside it.",
    "The points do not determine a cylinder: measure it at two heights and all around, or over as "
    "much of it as there is.",
)

# What Python puts together, and words that stand in sentences.
SENTENCES_OF_SEVERAL_PIECES = (
    "Checked against the model.",
    "Made from the models themselves: the path keeps off all of the job's.",
    "The %s is %s, of %d points, at a radius of %s.",
    *("straightness", "flatness", "roundness", "sphericity", "cylindricity"),
    # What a prediction's cut differs in.
    *("stepover %.4g, not %.4g %s", "feed per tooth %.4g, not %.4g %s"),
    *("depth %.4g, not %.4g %s", "tool radius %.4g, not %.4g %s", "face radius %.4g, not %.4g %s"),
    "There is no %s on %s: pick the geometry anew.",
    "There is no edge on %s: pick the geometry anew.",
    "Passes between guides need two of them beside the faces: pick two edges, or two chains. What "
    "is picked makes %d lines.",
    # What evenload.optimise tells the dock Optimise; the rest of it tells of arguments of scripts.
    "The floors of '%s' lie at several depths: make an operation for each depth, and optimise one "
    "by one.",
    "%.3g mm is deeper than the cutting length of %s, %g mm.",
    "%.5g rev/min is outside of what %s and the machine can do, %.5g to %.5g rev/min.",
    "The path of the tool of %g mm touches no material: check the region and the hole.",
    "No candidate is within the limits: %s refuses most, %d of %d, as in: %s",
    "At the least chip of %g mm %s of the tool of %g mm at %g°, %.3g mm deep, is above %s.",
    "%s chatters %.3g mm deep at %.5g rev/min and %g°, where the feed is at %g° to X.",
    "%s nearly chatters %.3g mm deep at %.5g rev/min and %g°, where the feed is at %g° to X.",
    *("the tool's diameter", "the tools' cutting length", "the spindle speed", "the force"),
    *("the tools' chip thickness", "the torque", "the power", "the machine's feed"),
    *("the area left", "chatter"),
    # Names of geometry, of which evenload.words makes lists.
    *("Face%s of %s", "Edge%s of %s", "%d edges of %s", "%d edges"),
    *("%s and Face%s of %s", "%s and Edge%s of %s", "%s and %d more", "%s and %d others"),
    *("number of teeth and its helix angle", "1 tooth and a helix of %g degrees"),
    "lower the step down below %.3g mm or turn the spindle at %.0f rev/min",
    *("climb", "conventional", "horizontal", "vertical", "depth", "of the type %s"),
    *(" degrees", "%g degrees", ", shares of the nominal load"),
    "The program has several spindle speeds: the lowest, %g rev/min, was taken.",
    "Dwells of %g s count in the total times only, not in those of the samples.",
    "The stock does not contain the part: %.3g mm2 of it lie outside; enlarge the stock.",
    "The depth of %g mm is beyond the tool's flutes, %g mm.",
    "The points lie up to %.3g mm from the part: align them with it first.",
    "A normal looks down: a probe from above cannot reach its point.",
    "The retract height must be at least %.3f mm, above every approach.",
    "The margin must lie from 0 to below 1.",
)
