"""The import arrows of Mod/evenload go one way, and no import hides inside a function."""

import ast
from pathlib import Path

import pytest

pytestmark = pytest.mark.core

PACKAGE = Path(__file__).resolve().parents[2] / "Mod" / "evenload"

# What each room may import besides itself. The ground is what lies in no folder and knows nothing
# of operations: tools, materials, Path commands, the compiled modules.
ARROWS = {
    "host": set(),
    "ground": set(),
    "settings": {"ground"},
    "geometry": {"ground"},
    "simulation": {"host", "ground", "settings", "geometry"},
    "pictures": {"ground", "settings", "simulation"},
    "optimisation": {"ground", "simulation", "dynamics"},
    "dynamics": {"ground", "pictures"},
    "ball_end": {"host", "ground"},
    "inspection": {"ground"},
    "face_inspection": {"host", "ground", "settings", "geometry", "inspection", "pictures"},
    "stability": {"host", "ground", "simulation", "dynamics", "pictures"},
    "suggestion": {"host", "ground", "simulation", "stability", "optimisation"},
    "operations": {
        *("host", "ground", "settings", "geometry", "simulation", "stability", "ball_end"),
    },
    "advisor": {
        *("host", "ground", "settings", "geometry", "operations", "ball_end", "face_inspection"),
    },
    "surface_simulation": {
        *("host", "ground", "settings", "geometry", "operations", "simulation", "pictures"),
        "advisor",
    },
    "job_files": {
        *("host", "ground", "settings", "operations", "simulation", "stability", "pictures"),
        *("inspection", "face_inspection"),
    },
    "gui": {
        "host",
        "ground",
        "settings",
        "operations",
        "simulation",
        "stability",
        "dynamics",
        "pictures",
        "inspection",
        "face_inspection",
        "advisor",
        "surface_simulation",
        "optimisation",
        "suggestion",
    },
}
GROUND = {
    *("commands", "compiled", "machines", "materials"),
    *("findings", "planar", "refusals", "tool", "translation", "units", "waiting"),
    *("window", "words"),
}
# What people name in macros and on the command line; nothing in the package imports these.
DOORS = {"__init__", "batch", "job_simulation", "job_stability", "proof", "simulation_pictures"}
# Imports inside of functions, which the comment beside them gives the reason of.
LATE = {
    ("__init__", "evenload.optimisation"),  # or all of it would be loaded with FreeCAD
    ("__init__", "evenload.simulation"),
    ("dynamics.charts", "evenload.dynamics.pictures"),  # needs matplotlib
    ("gui.__init__", "evenload.gui.fields"),  # FreeCAD's start needs none of these
    ("gui.__init__", "evenload.gui.preferences_page"),
    ("gui.__init__", "evenload.gui.progress"),
    ("gui.__init__", "evenload.gui.views"),
    ("job_files.inspection", "evenload.face_inspection.html_report"),  # needs matplotlib
    ("job_files.inspection", "evenload.face_inspection.picture"),
    ("job_files.job", "evenload.pictures.finishing_picture"),  # needs matplotlib
    ("job_files.job", "evenload.pictures.path_picture"),
    ("job_files.job", "evenload.pictures.simulation_pictures"),
    ("job_files.job", "evenload.stability.picture"),
    ("simulation.__init__", "evenload.simulation.job"),  # needs FreeCAD
    ("surface_simulation.result", "evenload.surface_simulation.picture"),  # needs matplotlib
}
# Rooms and modules that run without FreeCAD, and what they must not import therefore.
WITHOUT_FREECAD = {
    *(
        "dynamics",
        *("ball_end.__init__", "ball_end.chip_feeds", "ball_end.chips", "ball_end.loads"),
        *("ball_end.places", "ball_end.relief", "ball_end.thickness"),
        *("ball_end.regressions", "ball_end.sections", "ball_end.source", "ball_end.surfaces"),
        "inspection",
        "pictures.figure",
        "optimisation",
        "simulation.run",
        "simulation.inputs",
        "simulation.means",
        "simulation.result",
        "simulation.taking",
        "simulation.walls",
        "stability.choice",
        "stability.cut",
        "stability.field",
        "stability.picture",
        "suggestion.search",
    ),
    *("settings.labels", "settings.notes", "settings.own", "settings.pages", "settings.sentences"),
    *("settings.parameters", "gui.load_colours"),
    *("settings.ranges", "settings.results", "settings.setting", "settings.shared"),
    "settings.table",
}
FREECADS = {"FreeCAD", "FreeCADGui", "Part", "Path", "PySide"}


def name_of(path):
    return ".".join(path.relative_to(PACKAGE).with_suffix("").parts)


FILES = {name_of(path): path for path in sorted(PACKAGE.rglob("*.py"))}


def room_of(module):
    """The room of a module by its name within the package; None for a door."""
    first = module.split(".")[0]
    if first in DOORS:
        return None
    return "ground" if first in GROUND else first


def resolved(name):
    """The module of ours that 'evenload.x.y' names, where y may be a thing in x; None for others,
    and for the compiled modules.
    """
    parts = name.split(".")
    if parts[0] != "evenload":
        return None
    for size in range(len(parts), 1, -1):
        inner = ".".join(parts[1:size])
        for module in (inner, inner + ".__init__"):
            if module in FILES:
                return module
    return "__init__"


def imports_of(module):
    """[(module of ours or a foreign name, the name as written, whether inside a function)]"""
    tree = ast.parse(FILES[module].read_text())
    inner = {
        id(node)
        for function in ast.walk(tree)
        if isinstance(function, (ast.FunctionDef, ast.Lambda))
        for node in ast.walk(function)
    }
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            assert not node.level, "imports are written from evenload on"
            names = ["%s.%s" % (node.module, alias.name) for alias in node.names]
        else:
            continue
        found += [(resolved(name) or name, name, id(node) in inner) for name in names]
    return found


def module_path(module):
    return "evenload." + module.removesuffix(".__init__")


@pytest.mark.parametrize("module", FILES)
def test_imports_follow_the_arrows(module):
    room = room_of(module)
    assert room is None or room in ARROWS, "a room without an arrow: say what it may import"
    for other, name, _ in imports_of(module):
        if other not in FILES or room is None:
            continue
        assert room_of(other) is not None, "%s is for macros: import where it comes from" % name
        allowed = ARROWS[room] | {room}
        assert room_of(other) in allowed, "%s may not import %s" % (room, name)


def test_the_arrows_have_no_circle():
    done = set()
    while len(done) < len(ARROWS):
        ready = {room for room, sees in ARROWS.items() if room not in done and sees <= done}
        assert ready
        done |= ready


def test_no_modules_import_each_other_in_a_circle():
    sees = {
        module: {o for o, _, _ in imports_of(module) if o in FILES and o != module}
        for module in FILES
    }
    done = set()
    while len(done) < len(sees):
        ready = {m for m in sees if m not in done and sees[m] <= done}
        assert ready, "these import each other: %s" % sorted(set(sees) - done)
        done |= ready


@pytest.mark.parametrize("module", FILES)
def test_no_import_of_ours_hides_in_a_function(module):
    late = {
        (module, module_path(o)) for o, _, inside in imports_of(module) if inside and o in FILES
    }
    assert late <= LATE


def test_every_late_import_is_still_there():
    assert LATE == {
        (module, module_path(other))
        for module in FILES
        for other, _, inside in imports_of(module)
        if inside and other in FILES
    }


@pytest.mark.parametrize("module", [m for m in FILES if room_of(m) != "host"])
def test_only_host_knows_where_freecad_keeps_its_modules(module):
    for name in (name for _, name, _ in imports_of(module)):
        first, _, rest = name.partition(".")
        assert first != "PathScripts" and not (first == "Path" and rest.count(".")), name


@pytest.mark.parametrize("module", FILES)
def test_what_runs_without_freecad_does_not_import_it(module):
    if not {module, module.split(".")[0]} & WITHOUT_FREECAD:
        return
    for other, name, _ in imports_of(module):
        assert name.split(".")[0] not in FREECADS
        if other in FILES and room_of(other) != "ground":
            found = {other, other.split(".")[0], other.removesuffix(".__init__")}
            assert found & (WITHOUT_FREECAD | {"simulation.__init__"}), name


@pytest.mark.parametrize(
    "module, names",
    [
        ("operations.adaptive", {"Adaptive"}),
        ("operations.trochoid", {"Trochoid"}),
        ("operations.lame_spiral", {"LameSpiral"}),
        ("operations.finishing", {"Finishing"}),
        ("gui.views", {"ViewProvider", "TrochoidViewProvider", "LameSpiralViewProvider"}),
        ("gui.views", {"FinishingViewProvider"}),
    ],
)
def test_classes_that_documents_name_stay_where_they_are(module, names):
    tree = ast.parse(FILES[module].read_text())
    assert names <= {node.name for node in tree.body if isinstance(node, ast.ClassDef)}
