"""The rows of the settings that single kinds of operations have, in the order of their panels."""

from evenload.settings.setting import (
    ANGLE,
    BOOL,
    CHOICE,
    INTEGER,
    LENGTH,
    LINKS,
    NOT_NEGATIVE,
    NUMBER,
    NUMBERS,
    POINT,
    POSITIVE,
    Setting,
)
from evenload.settings.shared import CONSTANT_CHIP

# For operations that can work on what others left.
REST_MACHINING = Setting(
    "UseRestMachining",
    BOOL,
    False,
    "Clears only what the job's earlier operations leave",
    label="Rest machining",
    box="Cut",
    is_first=True,
    page="clears only what the job's earlier operations leave "
    "([rest_machining.md](rest_machining.md))",
)

OF_ADAPTIVE = (REST_MACHINING,)

OF_TROCHOID = (
    Setting(
        "Pattern",
        CHOICE,
        ["Constant engagement", "Circular", "Cycloid"],
        "The trochoid's shape; the circular and the cycloid one reach the engagement angle "
        "only for a moment of each turn",
        label="Pattern",
        box="Slot",
        keyword="pattern",
        page="or Circular, Cycloid: the usual trochoids, which reach the engagement angle for a "
        "moment of each turn only ([compared](trochoid.md))",
    ),
    Setting(
        "SlotWidth",
        LENGTH,
        0.0,
        "Width of the slot round a sketch or edges, which are its centreline once this is set; "
        "faces have their own",
        label="Slot width",
        box="Slot",
        is_first=True,
        unset="from the face",
        default="unset",
        page="of the slots round sketches and edges; an open one needs it",
    ),
)

OF_LAME_SPIRAL = (
    Setting(
        "Segments",
        INTEGER,
        None,
        "Sides of the curve: 3 for a triangle, 4 for a square or a rectangle; fitted unless "
        "it is set",
        label="Segments",
        box="Spiral",
        keyword="segments",
        fitted=True,
        page="sides of the curve: 4 for squares and rectangles, 3 for triangles",
    ),
    Setting(
        "SemiAxisA",
        LENGTH,
        None,
        "First semi-axis of the spiral's last turn, of the tool's centre; fitted unless it is set",
        label="Semi-axis A",
        box="Spiral",
        keyword="semi_axis_a",
        fitted=True,
        page="first semi-axis of the curve in which the spiral ends, on which the tool's centre "
        "runs",
    ),
    Setting(
        "SemiAxisB",
        LENGTH,
        None,
        "Second semi-axis of the spiral's last turn, of the tool's centre; fitted unless it "
        "is set",
        label="Semi-axis B",
        box="Spiral",
        keyword="semi_axis_b",
        fitted=True,
        page="the second",
    ),
    Setting(
        "ExponentStart",
        NUMBER,
        None,
        "Exponent of the first turn: 1 is an ellipse; fitted unless it is set",
        label="First exponent",
        box="Spiral",
        keyword="exponent_start",
        fitted=True,
        page="of the first turn: 1 is an ellipse, towards 0 the corners grow sharper",
    ),
    Setting(
        "ExponentEnd",
        NUMBER,
        None,
        "Exponent of the last turn: towards 0 corners grow sharper; fitted unless it is set",
        label="Last exponent",
        box="Spiral",
        keyword="exponent_end",
        fitted=True,
        page="of the last turn",
    ),
    Setting(
        "Rotation",
        ANGLE,
        None,
        "Of the first semi-axis against the X axis; fitted unless it is set",
        label="Rotation",
        box="Spiral",
        keyword="rotation",
        fitted=True,
        page="of the first semi-axis against the X axis",
    ),
    Setting(
        "Pitch",
        LENGTH,
        None,
        "The largest step of a turn; fitted to the engagement angle unless it is set, and "
        "smaller where that demands it",
        label="Pitch",
        box="Spiral",
        keyword="pitch",
        fitted=True,
        page="the largest step from turn to turn, of the larger change of the semi-axes; smaller "
        "where the engagement angle demands it, and Report says so",
    ),
    Setting(
        "Centre",
        POINT,
        None,
        "Centre of the spiral; fitted unless it is set",
        label="Centre",
        box="Spiral",
        keyword="centre",
        fitted=True,
        page="of the spiral",
    ),
    Setting(
        "SemiAxisACourse",
        NUMBERS,
        [],
        "How the first semi-axis comes from the first turn to the last: 2 to 20 shares of its "
        "change, from 0 to 1, at even steps, as 0; 0.1; 0.4; 1; evenly where it is empty",
        label="Course of A",
        box="Spiral",
        unset="evenly",
        keyword="semi_axis_a_course",
        page="how the first semi-axis comes from the first turn to the last: 2 to 20 shares of "
        "the change, from 0 to 1, never falling, at even steps of the way; empty: evenly",
    ),
    Setting(
        "SemiAxisBCourse",
        NUMBERS,
        [],
        "The same of the second semi-axis",
        label="Course of B",
        box="Spiral",
        unset="evenly",
        keyword="semi_axis_b_course",
        page="the same of the second",
    ),
    Setting(
        "ExponentCourse",
        NUMBERS,
        [],
        "The same of the exponent; evenly or late, as is quicker, where it is empty",
        label="Course of exponent",
        box="Spiral",
        unset="as is quicker",
        keyword="exponent_course",
        page="the same of the exponent; empty: evenly or late, as is quicker",
    ),
    Setting(
        "Rest",
        CHOICE,
        ["Clear", "Leave"],
        "What the spiral does not reach: cleared at constant engagement, or left",
        label="Rest",
        box="Spiral",
        keyword="rest",
        page="what the spiral does not reach is cleared at constant engagement; or Leave: then "
        "WallPass is ignored, there is no last pass along the walls",
    ),
)

EVEN_CUSPS = "Constant cusp height"
PARALLEL = ["Zig-zag", "One way"]  # strategies with passes side by side
CONTOURS = ["Contours inwards", "Contours outwards"]
SPIRALS = ["Spiral inwards", "Spiral outwards"]
BETWEEN_GUIDES = ["Between guides", "One way between guides"]

OF_FINISHING = (
    Setting(
        "Strategy",
        CHOICE,
        [*PARALLEL, *CONTOURS, *SPIRALS, *BETWEEN_GUIDES],
        "Parallel passes to and fro, or all in one direction with a way back over the part; passes "
        "along the outline of the faces, or a spiral round their middle, from the outside or from "
        "the inside on; or passes between two picked edges, from the shape of one to the other's, "
        "to and fro or all in one direction",
        label="Strategy",
        box="Passes",
        is_first=True,
        keyword="pattern",
        page="parallel passes to and fro, joined along the surface; or One way: all in the same "
        "direction, so that each cuts as CutMode says, with a way back over the part; or Contours "
        "inwards, Contours outwards: along the faces' outline as it is seen from above, from the "
        "border or from the middle on; or Spiral inwards, Spiral outwards: one spiral round the "
        "middle of the faces, for round ones; or Between guides: to and fro, from one of two "
        "edges, chains of edges or sketches picked beside the faces to the other; or One way "
        "between guides: the same as One way",
    ),
    Setting(
        "PassAngle",
        ANGLE,
        0.0,
        "Direction of the passes against the X axis, seen from above",
        label="Direction",
        box="Passes",
        is_first=True,
        keyword="angle",
        when=("Strategy", PARALLEL),
        page="of parallel passes against the X axis, seen from above",
    ),
    Setting(
        "Spacing",
        CHOICE,
        ["Constant stepover", EVEN_CUSPS],
        "What is the same between all passes: their distance seen from above, or the height of "
        "what stands between them",
        label="Spacing",
        box="Passes",
        is_first=True,
        page="passes at even distances, seen from above; or Constant cusp height: as far apart as "
        "the surface's slope and curvature allow ([how](finishing.md#2-spacing_by_cusp)), along "
        "contours and spirals at each place of them, between guides by as many passes as keep it "
        "all between them",
    ),
    Setting(
        "Stepover",
        LENGTH,
        None,
        "Distance of neighbouring passes seen from above; the same as the cusp height on a level "
        "face: setting one sets the other",
        label="Stepover",
        box="Passes",
        is_first=True,
        keyword="stepover",
        range=POSITIVE,
        follows=lambda diameter, feed, rapid: 0.05 * diameter,
        default="0.05 × tool",
        page="distance of neighbouring passes, seen from above",
    ),
    Setting(
        "CuspHeight",
        LENGTH,
        None,
        "Height of what a ball or a rounded corner leaves between two passes of a level face: "
        "setting it sets the stepover; 0 for a flat end mill, which leaves steps",
        label="Cusp height",
        box="Passes",
        is_first=True,
        range=NOT_NEGATIVE,
        is_fine=True,
        default="follows",
        page="what the ball or the rounded corner leaves between two passes of a level face, "
        "r − √(r² − (Stepover/2)²); setting one sets the other. 0 for a flat end mill",
    ),
    Setting(
        "Boundary",
        CHOICE,
        ["Tool contact", "Tool centre"],
        "What has to lie on the picked faces while the tool cuts: the point where it touches, or "
        "its axis seen from above",
        label="Stays on the faces",
        box="Passes",
        is_first=True,
        keyword="boundary",
        page="what stays on the picked faces: the point where the tool touches; or Tool centre: "
        "its axis, seen from above",
    ),
    Setting(
        "Extension",
        LENGTH,
        0.0,
        "How far passes go on beyond the border of the faces, seen from above: along what goes on "
        "there or falls away, not up what rises",
        label="Extension",
        box="Passes",
        keyword="extension",
        range=NOT_NEGATIVE,
        unset="none",
        page="how far passes go on beyond the border of the faces, seen from above "
        "([where](finishing.md#3-extension))",
    ),
    Setting(
        "Allowance",
        LENGTH,
        0.0,
        "What stays on the whole part, measured across its surface",
        label="Allowance",
        box="Passes",
        keyword="allowance",
        range=NOT_NEGATIVE,
        page="what stays on the whole part, across its surface",
    ),
    Setting(
        "Fixtures",
        LINKS,
        [],
        "Clamps, vices and other objects that the tool keeps off, as from above: what lies below "
        "them is not cut. The button takes what is selected",
        label="Fixtures",
        box="Passes",
        default="none",
        page="clamps, vices and other objects with a shape that the tool keeps off, as from above: "
        "what lies below them is not cut; in job files a list of their names",
    ),
    Setting(
        "FixtureClearance",
        LENGTH,
        1.0,
        "How far the tool stays off the fixtures, all around",
        label="Fixture clearance",
        box="Passes",
        range=NOT_NEGATIVE,
        needs="Fixtures",
        page="how far the tool stays off the fixtures, all around, links and ways over them too",
    ),
    Setting(
        "LeadRadius",
        LENGTH,
        None,
        "Radius of the upright arcs by which the tool comes into a pass from the air, and leaves "
        "one; smaller where the part is in the way; at first 0.1 of the tool's diameter",
        label="Lead radius",
        box="Passes",
        keyword="lead_radius",
        range=NOT_NEGATIVE,
        unset="none",
        follows=lambda diameter, feed, rapid: 0.1 * diameter,
        default="0.1 × tool",
        page="of the upright arcs by which the tool comes into a pass from the air and leaves one, "
        "tangentially; down to an eighth of it, or none, where the part is in the way; 0: straight "
        "down and up",
    ),
    Setting(
        "StockOnFaces",
        LENGTH,
        None,
        "What the cut before has left above the surface that is made, across it: the feed "
        "control's chips are of that; at first 0.03 of the tool's diameter",
        label="Stock on the faces",
        box="Feeds",
        range=POSITIVE,
        follows=lambda diameter, feed, rapid: 0.03 * diameter,
        when=("FeedControl", [CONSTANT_CHIP]),
        default="0.03 × tool",
        page="what the cut before has left above the surface that is made, across it; only "
        "Constant chip thickness asks for it",
    ),
)
