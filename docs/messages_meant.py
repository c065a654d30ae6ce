"""What docs/messages.md tells of the sentences that the window shows: their groups, and what each
means where it does not itself say what to do. Sentences are named by how they begin, as the page
shows them.
"""

HEAD = """# Messages

Every sentence of EvenLoad's window, refusals and notes, by what it is about. "…" stands for what it
is filled with: a name, a number, a place. What a sentence itself tells to do stands in the second
column. In the window a setting is called what its panel calls it ("Stock to leave"), here by its
property (StockToLeave). The page has the English sentences.

A **refusal** stands in place of a path: the operation is empty, marked in the tree, and nothing
of it is posted. A **note** stands beside a path that can be used. Where a sentence has a place, the
panel makes it a link to it.
"""

# (title, what it is about, the files of Mod/evenload or rooms of src/ that tell it)
GROUPS = (
    (
        "Tool, tool controller and spindle",
        (
            "Refusals but for those about the spindle's sense and the force. Edit the tool"
            " controller or the tool bit in the job's panel."
        ),
        ("tool.py", "operations/compute.py", "operations/force.py"),
    ),
    (
        "Settings, depths and heights",
        (
            "Refusals: the field is marked in the panel, and OK waits until it is mended. What lies"
            " between depths and stock is told after Apply."
        ),
        (
            *("operations/checks.py", "operations/stock_checks.py", "operations/seen.py"),
            *("settings/", "operations/task.py"),
        ),
    ),
    (
        "Job, models and what comes before",
        (
            "Refusals. The operation depends on its job, and with rest machining on the operations"
            " before it."
        ),
        (
            *("operations/computing.py", "operations/rest.py", "operations/refusal.py"),
            *("operations/base.py", "gui/view3d.py"),
        ),
    ),
    (
        "What is picked: faces, edges, sketches",
        (
            "Refusals where the geometry cannot be machined from above; notes where a part of it is"
            " left out."
        ),
        ("src/occt", "src/geometry", "geometry/"),
    ),
    (
        "What became of the path",
        (
            "Notes about a path that can be used. Those about what was left uncut ask for a second"
            " look."
        ),
        ("findings.py", "operations/by_depth.py"),
    ),
    (
        "The check against models and stock",
        (
            "Each computed path is read back and held against the job's models and stock"
            " ([check.md](check.md)). A path that would gouge, rapid or plunge is refused."
        ),
        ("simulation/proof.py",),
    ),
    (
        "Entries, trochoids and Lamé spirals",
        "Refusals of the operation's own geometry and settings.",
        ("operations/trochoid.py", "refusals.py", "src/strategy"),
    ),
    (
        "Finishing",
        (
            "Refusals, and notes on what the tool does not reach"
            " ([finishing_operation.md](finishing_operation.md))."
        ),
        ("operations/finishing.py", "operations/chip_control.py", "src/surface", "src/feed"),
    ),
    (
        "Finishing Advisor",
        "Why a strategy has no figures ([finishing_advisor.md](finishing_advisor.md)).",
        ("advisor/", "ball_end/", "src/ball_end"),
    ),
    (
        "Show Load, Simulation, Compare, Report",
        (
            "Why a path cannot be simulated, and what its figures leave out"
            " ([simulation_window.md](simulation_window.md))."
        ),
        ("commands.py", "simulation/", "src/simulate"),
    ),
    (
        "Show Surface",
        (
            "Why nothing can be told of the faces, and what the figures leave out"
            " ([surface_simulation.md](surface_simulation.md))."
        ),
        ("surface_simulation/",),
    ),
    (
        "Stability chart",
        (
            "The measured response, the modes, and the verdict"
            " ([stability_chart.md](stability_chart.md))."
        ),
        ("dynamics/", "stability/", "operations/chatter.py", "src/dynamics"),
    ),
    (
        "Optimise",
        (
            "Why candidates fall out, and what the figures stand for"
            " ([optimisation.md](optimisation.md))."
        ),
        ("suggestion/",),
    ),
    (
        "Inspect",
        "Files of points, points that determine nothing, and verdicts ([inspect.md](inspect.md)).",
        ("inspection/", "face_inspection/", "src/inspection"),
    ),
    (
        "Machines, materials, post-processors, installation",
        (
            "Files of your own ([force_and_time.md](force_and_time.md)), the post-processor, and"
            " what EvenLoad itself needs."
        ),
        ("machines.py", "materials.py", "host/posts.py", "compiled.py"),
    ),
)
# Sentences that are put together from several pieces, and some that belong elsewhere.
PLACED = {
    "Checked against the model.": "The check against models and stock",
    "Made from the models themselves": "The check against models and stock",
    "Whether the cut is stable": "Stability chart",
    **dict.fromkeys(
        (
            *("The floors of '", "… mm is deeper", "… rev/min is outside", "The path of the tool"),
            *("No candidate is", "At the least chip", "… chatters", "… nearly chatters"),
        ),
        "Optimise",
    ),
    **dict.fromkeys(
        (
            *("The program has several", "Dwells of", "The stock does not contain"),
            "The depth of … mm is beyond",
        ),
        "Show Load, Simulation, Compare, Report",
    ),
    **dict.fromkeys(
        (
            *("The points lie up to", "A normal looks down", "The retract height"),
            *("The margin must", "The … is …, of … points"),
        ),
        "Inspect",
    ),
    "The region near (…, …): …": "What became of the path",
    **dict.fromkeys(
        (
            *("There is no … on …", "There is no edge on", "… has a coordinate", "… is not closed"),
            *("… encloses no area", "The outline", "An island", "Two islands", "The slot's"),
        ),
        "What is picked: faces, edges, sketches",
    ),
    "Passes between guides": "Finishing",
    "'…' is a mesh": "Finishing",
    "The triangles of": "Finishing",
    "The operation has no base geometry: pick the faces to be": "Finishing",
    "… stands upright": "Finishing",
    "… looks down: pick faces": "Finishing",
    "… is no face: pick the faces that are to": "Finishing",
}
# With these a sentence tells what to do.
VERBS = (
    *("add", "align", "ask", "change", "choose", "clear", "close", "compute", "correct", "create"),
    *("divide", "draw", "drill", "empty", "enlarge", "export", "give", "have", "join"),
    *("keep", "leave", "load", "lower", "make", "measure", "mend", "move", "name", "open", "Pick"),
    *("pick", "put", "raise", "recompute", "remove", "rough", "set", "spread", "state", "take"),
    *("turn", "use", "widen", "write", "build", "check", "see that"),
)
HOLE = "A note: the tool enters elsewhere, by a helix or a ramp. "
FILE = (
    "The file is not of the kind that is asked for. Export it anew from the program that wrote it."
)
RANGE = "A value that cannot be. Enter one within what the sentence says."
BUG = "Not a fault of yours: write to the maintainers with the document."
CHIP = "This strategy has no figures there. Take a smaller stepover or feed, or another tool."
# Families of sentences, by an expression that is looked for in what has no other meaning here.
FAMILIES = (
    (
        (
            r"^(The )?(frequencies|response)|^Dataset|dataset 58|lines of frequency|too few"
            r" lines|value that is no"
        ),
        FILE,
    ),
    (r"^The point …|^Points are rows|^Each (point|row)|headings|measured points, FA", FILE),
    (
        r"machine|material|mode|Modes|key '…'|JSON|must be a list|no file '…'",
        (
            "Correct the file: its keys and units are in [force_and_time.md](force_and_time.md),"
            " for modes in [stability_chart.md](stability_chart.md)."
        ),
    ),
    (
        (
            r"\bmust\b|^The feed direction|not finite|number of points|name of a file|cannot be"
            r" …|two of them|points are too few|^At least"
        ),
        RANGE,
    ),
    (
        r"OpenCASCADE|BREP|no face\.$",
        (
            "The shape is damaged. Repair it (Part, Check Geometry), or draw a sketch of what is to"
            " be cleared."
        ),
    ),
    (
        r"^The points|^The datum",
        (
            "The points or faces do not determine what is asked. Measure more of the feature, or"
            " pick another one."
        ),
    ),
    (r"^The chip reaches|^The feed per tooth is|^No chip|patch", CHIP),
)
