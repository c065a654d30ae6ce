"""What single messages mean, by how they begin (see messages_meant.py)."""

from messages_meant import BUG, HOLE

MEANT = {
    # Show Surface.
    "'…' cuts the faces nowhere": "See that the path comes down to the picked faces.",
    "Chips are told along": "Choose another measure, or an EvenLoad Finishing with a ball end.",
    "None of the picked faces lies on top": "Pick faces that a tool from above can touch.",
    "The triangles leave the part by": "A note: lower Tolerance where cusps that small count.",
    "The models have no surface that looks up": "Give the job a model with faces, not a mesh.",
    "The path of '…' lies beside the models": "Look at the job's models: nothing lies below it.",
    "Cells of … mm are coarse": "A note: lower `resolution` in a script.",
    "'…' is not active": "An operation that is switched off in the job has no path.",
    "'…' has a ball end mill, whose loads": "Show Load and Simulation know upright edges alone.",
    # What became of the path.
    "Left uncut: … mm² near (…), where": (
        "A note: a corner or passage is narrower than a turn at this engagement. Take a smaller"
        " tool, a larger EngagementAngle or a smaller RollRadius, or clear it by an operation of"
        " its own."
    ),
    "Left uncut: … mm² near (…), for": "A note: turn WallPass on, or leave it to a later cut.",
    "Left uncut: … mm² that the spiral": "A note: set Rest to another choice to have it cleared.",
    "The pocket … was skipped": (
        "A note: the other pockets are cut. Take a smaller tool for this one."
    ),
    "The region near (…), which does": "A note: a part of the pocket that the hole is not in.",
    "The region near (…, …): …": "The sentence after the place says why this part has no path.",
    "Nothing was left": "A note of rest machining: this operation can be taken out.",
    "Cancelled before everything was cut.": "Incomplete: compute it again.",
    "Cancelled before everything was cut: there": (
        "It was stopped, and a part of a path is not "
        "posted. Press Apply, or recompute the document."
    ),
    "The region near (…) does not hold": HOLE + "Drill this region, too, if it shall not.",
    "The pre-drilled hole near (…) lies": HOLE + "Move the hole out of the passage.",
    "The pre-drilled hole near (…) is too": HOLE + "Move it away from the wall.",
    "The pre-drilled hole is too tight to start from: it": HOLE + "Drill it wider.",
    "The pre-drilled hole was not used: a spiral around an island begins": HOLE,
    "The pre-drilled hole was not used: a spiral around an island in": "A note: no hole is needed.",
    "The open edges": (
        "A note: the path keeps off these sides as from walls. Make the stock larger, "
        "or pick what is to be cleared further out."
    ),
    "No helix fits": "A note: see that your tool cuts at its centre.",
    "No cut leads on": "A note: choose the entry 'Helix' to have it always so.",
    "Entry is a helix": "A note, nothing is to be done.",
    "HelixDiameter … mm was taken": "A note: the entry is narrower than was set.",
    "Chips get up to": "A note: the feed rises where the engagement is low, too far for the tooth.",
    "No feed down to": "A note: the force is above the limit at this place.",
    "What earlier operations left in narrow": "A note, nothing is to be done.",
    "Pitch is smaller": "A note: raise EngagementAngle for the set Pitch.",
    "The spiral turns more": "A note: the machine slows down in such turns.",
    "ExponentCourse changes": "A note: set ExponentStart and ExponentEnd apart, or leave it empty.",
    "No spiral was made": "A note: the whole pocket is cut as by Adaptive.",
    "A region has no spiral": "A note: this region is cut as by Adaptive.",
    "At a constant feed": "A note: the path is right, but another is faster.",
    "The slot near": "A note, nothing is to be done.",
    "After … passes": (
        "A note, nothing is to be done: the engagement is kept, at a little more time."
    ),
    "… the largest tool": (
        "What follows a pocket that no path was made for: take that tool, or leave less stock."
    ),
    "The tool of … mm does not": "The sentence goes on with the largest tool that fits.",
    "Turned more tightly": (
        "A note: the machine slows down there. Lower RollRadius, or take a smaller tool."
    ),
    "Skipped…": (
        "A note: NarrowPassages is 'Skip and report', or the tool does not fit. Clear it "
        "with a smaller tool."
    ),
    "Cut at reduced feed…": (
        "A note: no room for trochoids; the feed falls so that the removal rate "
        "stays ([narrow_passages.md](narrow_passages.md))."
    ),
    "The spiral clears only": (
        "A note: the rest is cleared pass by pass. For such pockets Adaptive may be quicker."
    ),
    "No trochoid was repeated": "A note: the path is right, each pass is steered by itself.",
    "…: cut down to": "A note: the depth of one of several floors.",
    # The check.
    "Checked against the model.": "The path was read back, and no fault was found.",
    "Made from the models themselves": "A finishing path, whose place the models decide.",
    "Feeds of the cuts": "A note of the feed control: nothing is to be done.",
    "Not checked": "Turn Check on, unless you know why it is off.",
    "The path cuts": "Refused: the tool would go into the part.",
    "The path has a rapid": "Refused: the tool would crash at rapid speed.",
    "The path plunges": "Refused: the tool would go straight down into material.",
    "The path of '…' cannot be checked": (
        "The sentence after it says why. Mend that, or turn Check "
        "off and simulate the path yourself."
    ),
    # Settings and depths.
    "SideStep is … mm: it": "Set EngagementAngle between 0 and 180 degrees; SideStep follows.",
    "MaximumFeed is": "Raise MaximumFeed, or lower the controller's feed.",
    "StepDown is … mm: it must": "Enter a depth above 0.",
    "CuspHeight is": "Enter a smaller height, or take a tool with a larger radius.",
    "… is …: it …": "The field is marked. Enter a value within what the sentence says.",
    "FinalDepth lies … mm below the underside": (
        "A note: the tool cuts through, into what the part "
        "stands on. Raise FinalDepth where that shall not be."
    ),
    "FinalDepth lies … mm below …": (
        "A note: set FinalDepth back to the floor's own depth where that is not meant."
    ),
    "FinalDepth lies … mm above …": "A note: the floor is left as thick.",
    "StartDepth (… mm) does not lie above the underside": (
        "Raise StartDepth into the stock, or move the stock."
    ),
    "The spindle of '…' turns": "A note: the path is mirrored, so that climb stays climb.",
    "The tool '…' does not say its …: the force": (
        "A note: set it in the tool bit for better figures."
    ),
    "The tool '…' does not tell its number of teeth": (
        "A note: set Flutes in the tool bit; chips of two teeth are half as thick."
    ),
    "SlotWidth was not used": "A note: it counts for centrelines alone.",
    "EvenLoad failed": BUG,
    "The expression of": "Look at the property in the property editor.",
    "Whether the cut is stable": "The sentence after it says why.",
    # What is picked.
    "… lies partly under the model, near (…, …): what": (
        "A note: an overhang stands above a part of the face. Machine it from another side."
    ),
    "… stands upright": "Take it out of the base geometry.",
    "…: it is not cleared there, for": (
        "A note: two of the picked faces have different depths there."
    ),
    "…: it is not cleared, for the ground": "A note: draw what is to be cleared as a sketch.",
    "…: it is cleared to the edge": "A note: stock stands beyond an open side, and goes, too.",
    "…: it is cleared no further": "A note: pick what lies further out as well, if it is to go.",
    "…: it is cleared up to": "A note: what stays further out is another operation's.",
    # Simulation.
    "… turns the work": "A rotary axis: no path with one is simulated.",
    "'…' is left out": "A note: what this operation before cut counts as still there.",
    "The tool controller has no spindle speed: there": "Set it for chip thickness and force.",
    "The spindle turns counter-clockwise": "A note: climb and conventional are exchanged in it.",
    "The tool '…' is simulated": "A note: its corner radius is left out.",
    "'…' works on": "A note: gouges into that object are not found.",
    "The stock '…' cannot be read": "Choose another stock in the job's panel.",
    "The path has more than … levels": (
        "A note: gouges are not looked for; raise StepDown for that."
    ),
    "What must stay": "A note: gouges are not looked for. The sentence after it says why.",
    "The program has several": "A note: forces and chips are those at that speed.",
    "Dwells of": "A note, nothing is to be done.",
    "The depth of … mm is beyond": "A note: the shank would rub. Take a longer tool.",
    "The stock's top": "Set the job's stock so that it has a height.",
    # Stability.
    "The cut is unstable": "What stands after it says what to lower, and where to turn.",
    "The cut is stable": "The verdict, at the depth and speed that are set.",
    "The spindle can do none": "Choose other speeds for the chart, or another machine.",
    "'…' has no level cut": "Its path has only entries and ramps: choose another operation.",
    "The tool '…' does not say its …: stab": "A note: set it in the tool bit.",
    "'…' cuts nothing": "Raise StartDepth or lower FinalDepth.",
    "The imaginary part": "Turn the sensor's sign in the file, or name another unit.",
    "The response has too few lines to look": "Measure with a finer resolution.",
    "The frequency response has": "Ask for fewer modes, or measure with a finer resolution.",
    "… does not say what its columns are": "A note: check that it is so, or give headings.",
    "The tool controller '…' has no modes": "A tap test tells how the tool vibrates.",
    # Optimise.
    "All figures are": "A note: what the suggestion's figures stand for.",
    "… mm is deeper": "Lower the step down, or take a longer tool.",
    "… rev/min is outside": "Choose a speed within these limits, or correct them.",
    "At the least chip": (
        "Even the smallest chip is too much: raise the limit that is named, or lower "
        "engagement angle or step down."
    ),
    "… chatters": "The candidate falls out: a smaller depth or another speed may do.",
    "… nearly chatters": "The candidate falls out, for it has too little margin.",
    "No candidate is": "Raise the limit that is named first.",
    # Inspect.
    "It keeps": "The verdict: in tolerance.",
    "It exceeds": "The verdict: out of tolerance.",
    "The … is …, of": (
        "The result of the evaluation: the form error, in the unit that is preferred."
    ),
    "No zone near by": "The proof that no narrower zone was missed.",
    "Points nearer to other": "A note: they belong to faces that are not inspected.",
    "Predicted": "What the source's regression expects of this cut.",
    "Outside of what": "A note: the prediction is no more than a guess there.",
    "A normal looks down": "Pick faces that look up, or turn the part.",
    "… cannot be read": "Open another file, or see that this one may be read.",
    "The file is empty": "Open a file with these headings and rows.",
    # The advisor.
    "The tool touches the faces nowhere": "Pick faces that are larger than the tool's contact.",
    "… of … places along": "A note: the figures are of the other places.",
    "The stock on the faces is … mm: it": "Enter what the cut before leaves.",
    "The path of this strategy": "Take another strategy or a smaller stepover.",
    # Posts.
    "There is no post-processor": "Choose one of those in the job's panel, page Output.",
    "The post-processor '…' refuses": "Correct the job's arguments of the post-processor.",
    "This FreeCAD has": "The sentence after it says how to have one that fits.",
    "EvenLoad's compiled modules are missing": "The sentence after it says what to do.",
    "… build EvenLoad": "EvenLoad's compiled modules are for another Python or OpenCASCADE.",
    "The file '…' of the … cannot be read": "See that it is there and may be read.",
    "EvenLoad's module": "Install EvenLoad anew. " + BUG,
}
