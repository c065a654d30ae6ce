"""The model of a job: its document, the object to machine, and what is to be cleared of it."""

import os

import FreeCAD
import Part

from evenload import host
from evenload.words import listed

MOST_NAMES = 10  # of objects to choose from, in a sentence


def opened(path, wanted):
    """(document, object to machine) of a FreeCAD document or a STEP, IGES or BREP file."""
    if not os.path.isfile(path):
        raise ValueError("There is no model file %s: mend the key 'model'." % path)
    extension = os.path.splitext(path)[1].lower()
    try:
        if extension == ".fcstd":
            doc = FreeCAD.openDocument(path, True)
        else:
            shape = Part.read(path)
            doc = FreeCAD.newDocument("Batch")
            doc.addObject("Part::Feature", "Model").Shape = shape
            doc.recompute()
    except Exception as error:
        raise ValueError(
            "The model %s cannot be read (%s): save it anew as FCStd, STEP, IGES or BREP."
            % (path, host.text_of(error))
        ) from None
    solids = [o for o in doc.Objects if getattr(o, "Shape", None) and o.Shape.Solids]
    if wanted:
        found = [o for o in doc.Objects if wanted in (o.Name, o.Label)]
        if not found:
            raise ValueError(
                "There is no object '%s' in %s: it has %s."
                % (wanted, path, listed([o.Name for o in doc.Objects], most=MOST_NAMES))
            )
        return doc, found[0]
    tops = [o for o in solids if not any(parent in solids for parent in o.InList)]
    if len(tops) != 1:
        names = listed([o.Name for o in tops], most=MOST_NAMES)
        raise ValueError(
            "The model %s has %d solid objects: name one with the key 'object'%s."
            % (path, len(tops), ", of " + names if tops else "")
        )
    return doc, tops[0]


def base_of(doc, model, in_job, names, number):
    """Base geometry from names: 'Face7' of the model, 'Sketch' or 'Body.Face7' of the document."""
    base = []
    for name in names:
        if not isinstance(name, str):
            raise ValueError("Job %d, base: %r is no name." % (number, name))
        owner, _, element = name.rpartition(".")
        if not owner and not _has(in_job, element):
            owner, element = element, ""
        if not owner:
            base.append((in_job, element))
            continue
        found = [o for o in doc.Objects if owner in (o.Name, o.Label)]
        if not found or (element and not _has(found[0], element)):
            raise ValueError(
                "Job %d, base: there is no '%s': name faces or edges of %s, as 'Face1', or "
                "sketches." % (number, name, model.Name)
            )
        base.append((in_job if found[0] is model and element else found[0], element))
    return base


def _has(obj, element):
    try:
        return bool(obj.Shape.getElement(element))
    except Exception:
        return False
