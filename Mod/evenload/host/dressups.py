"""FreeCAD's dressups of operations."""

import importlib

import FreeCAD

from evenload.host.versions import CAM, MOVED, cam

# By the names of FreeCAD's commands: the modules of 0.20 and those that followed. Since 1.0 the
# command Dogbone makes what is called DogboneII.
_MODULES = {
    "AxisMap": ("AxisMap", "Gui.AxisMap"),
    "Boundary": ("PathBoundary", "Boundary"),
    "Dogbone": ("Dogbone", "Gui.DogboneII" if CAM else "Gui.Dogbone"),
    "LeadInOut": ("LeadInOut", "Gui.LeadInOut"),
    "RampEntry": ("RampEntry", "Gui.RampEntry"),
    "Tags": ("HoldingTags", "Tags"),
    "ZCorrect": ("ZCorrect", "Gui.ZCorrect"),
}
DRESSUPS = tuple(_MODULES)


def dressup(name):
    """FreeCAD's module of a dressup, one of DRESSUPS."""
    old, new = _MODULES[name]
    return importlib.import_module(
        "Path.Dressup." + new if MOVED else "PathScripts.PathDressup" + old
    )


def dressed(name, operation):
    """A new dressup of an operation, or of another dressup, in its place in the job; name: one of
    DRESSUPS. It is as FreeCAD's command makes it before its panel is filled in, but without a view
    provider. FreeCAD's own Create, where a dressup has one, may leave the operation in the job, and
    both are posted then.
    """
    module, doc = dressup(name), operation.Document
    job = cam().utils.findParentJob(operation)
    before = list(job.Operations.Group)
    FreeCAD.setActiveDocument(doc.Name)
    if hasattr(module, "Create"):
        made = module.Create(operation)
    else:
        made = doc.addObject("Path::FeaturePython", name + "Dressup")
        proxy = module.ObjectDressup(made)
        made.Base = operation
        if name == "AxisMap":
            made.Radius = 45  # mm, as the command has it
        if hasattr(proxy, "setup"):
            proxy.setup(made)
    job.Operations.Group = [made if each == operation else each for each in before]
    return made
