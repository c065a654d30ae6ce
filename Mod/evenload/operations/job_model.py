"""Which model of its job a selected face or edge belongs to.

A click on a PartDesign body selects its last feature, but what stands on the machine is the job's
model, a clone of the body that may have been moved: base geometry must be the model's.
"""

import FreeCAD

SAME = 1e-6  # mm, and of areas as a share: shapes that a file has rounded are the same


def of(job, base, sub):
    """(model, name) of the element of the job's models that `sub` of `base` is; (base, sub) where
    it belongs to none. sub: 'Face3', 'Edge12', or '' for a whole object.
    """
    originals = [(model, job.Proxy.baseObject(job, model)) for model in job.Model.Group]
    owner, placement = base, FreeCAD.Placement()
    while owner is not None:
        for model, original in originals:
            if owner is base and base in (model, original):
                return model, sub
            if owner in (model, original):
                name = _same_element(base, sub, placement, owner)
                if name:
                    return model, name
        owner = owner.getParentGeoFeatureGroup()
        if owner is not None:
            placement = owner.Placement.multiply(placement)
    return base, sub


def _same_element(base, sub, placement, owner):
    """The name of the owner's face or edge that lies where `sub` of `base` lies: not every feature
    of a body numbers them as the body does. None where there is no such element, or no single one.
    """
    kind = sub.rstrip("0123456789")
    mine, theirs = _elements(base, kind), _elements(owner, kind)
    number = int(sub[len(kind) :] or 0)
    if not 0 < number <= len(mine):
        return None
    size, centre = _place(mine[number - 1])
    centre = placement.multVec(centre)

    def is_same(element):
        other, there = _place(element)
        return abs(other - size) <= SAME * size and (there - centre).Length <= SAME

    if number <= len(theirs) and is_same(theirs[number - 1]):
        return sub
    found = [k for k, element in enumerate(theirs, 1) if is_same(element)]
    return "%s%d" % (kind, found[0]) if len(found) == 1 else None


def _elements(obj, kind):
    shape = getattr(obj, "Shape", None)
    if shape is None or shape.isNull():
        return []
    return {"Face": shape.Faces, "Edge": shape.Edges}.get(kind, [])


def _place(element):
    """(size, centre) of a face or edge."""
    return getattr(element, "Area", 0) or element.Length, element.CenterOfMass
