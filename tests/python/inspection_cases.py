"""Points whose minimum zone is known by construction, and a check of certificates by itself.

Places on a feature are told by what a contact presses with: force along its normal, moment, and,
where the feature has a radius, 1 for that. Random places, one more than there are degrees of
freedom, have one combination of these that vanishes; its signs say which bound of the zone each
touches, and its sizes are the multipliers. All other points lie within.
"""

import numpy

KINDS = ("planar line", "line", "plane", "circle", "sphere", "cylinder")
CONTACTS = dict(zip(KINDS, (3, 5, 4, 4, 5, 6)))
LEAST_MULTIPLIER = 0.01
WITHIN = 0.93  # of the zone, for points that touch nothing


def unit(vectors):
    return vectors / numpy.linalg.norm(vectors, axis=-1, keepdims=True)


def places(kind, random, count, span):
    """(feet, normals, pressing): on a feature of size about 1, over an arc of `span` degrees."""
    zero, one = numpy.zeros(count), numpy.ones(count)
    along = random.uniform(-1, 1, count)
    half = numpy.radians(span) / 2
    turn = random.uniform(-half, half, count)
    round_ = numpy.stack([numpy.cos(turn), numpy.sin(turn), zero], axis=1)
    if kind == "planar line":
        return along[:, None] * [1.0, 0, 0], one[:, None] * [0.0, 1, 0], [one, along]
    if kind == "plane":
        feet = numpy.stack([along, random.uniform(-1, 1, count), zero], axis=1)
        return feet, one[:, None] * [0.0, 0, 1], [one, feet[:, 0], feet[:, 1]]
    if kind == "circle":
        return round_, round_, [one, round_[:, 0], round_[:, 1]]
    if kind == "sphere":
        height = random.uniform(numpy.cos(half), 1, count)
        ring = numpy.sqrt(1 - height**2)
        turn = random.uniform(-numpy.pi, numpy.pi, count)
        feet = numpy.stack([ring * numpy.cos(turn), ring * numpy.sin(turn), height], axis=1)
        return feet, feet, [one, *feet.T]
    across = [round_[:, 0], round_[:, 1], along * round_[:, 0], along * round_[:, 1]]
    axis = along[:, None] * [0.0, 0, 1]
    if kind == "line":
        return axis, round_, across
    return round_ + axis, round_, [one, *across]


def moved(points, random, scale, far):
    """(points turned, mirrored or not, scaled and shifted; the turn with its mirror)"""
    turn = numpy.linalg.qr(random.normal(size=(3, 3)))[0]
    return scale * points @ turn.T + far * random.uniform(-1, 1, 3), turn


def moved_in_plane(points, random, scale, far):
    angle = random.uniform(-numpy.pi, numpy.pi)
    turn = numpy.array(
        [[numpy.cos(angle), -numpy.sin(angle)], [numpy.sin(angle), numpy.cos(angle)]]
    )
    turn[0] *= random.choice([-1, 1])
    return scale * points[:, :2] @ turn.T + far * random.uniform(-1, 1, 2), turn


def known(kind, random, width, count=60, span=360.0, scale=1.0, far=0.0, repeats=0):
    """(points, zone): `width` is the zone's share of the feature's size, radius or half length."""
    contacts = CONTACTS[kind]
    while True:
        touching = places(kind, random, contacts, span)
        matrix = numpy.array(touching[2])
        values, vectors = numpy.linalg.svd(matrix)[1:]
        balance = vectors[-1] / numpy.abs(vectors[-1]).sum()
        if kind == "line" and balance.sum() < 0:
            balance = -balance
        is_flat = values[-1] < 1e-3 * values[0] * (1 if span > 90 else 1e-2)
        if is_flat or numpy.abs(balance).min() < LEAST_MULTIPLIER:
            continue
        if kind != "line" or balance.min() > 0:
            break
    others = places(kind, random, count - contacts, span)
    feet, normals = (numpy.concatenate([touching[i], others[i]]) for i in range(2))
    heights = 0.5 * width * random.uniform(-WITHIN, WITHIN, count)
    if kind == "line":
        heights = abs(heights)
    heights[:contacts] = 0.5 * width * numpy.sign(balance)
    points = feet + heights[:, None] * normals
    points = numpy.concatenate([points, points[:repeats]])
    points = points[random.permutation(len(points))]
    is_planar = kind == "planar line" or (kind == "circle" and random.random() < 0.5)
    carried, _ = (moved_in_plane if is_planar else moved)(points, random, scale, far)
    return carried, width * scale


def imbalance(found, points):
    """What the multipliers of a Fit leave of forces, moments and radius; 0 where it is optimal.

    It knows nothing but the feature, the points and the multipliers.
    """
    touching = numpy.asarray(points, dtype=float)[found.contacts]
    if touching.shape[1] == 2:
        touching = numpy.column_stack([touching, numpy.zeros(len(touching))])
    point = numpy.append(found.point, 0.0)[:3]
    arms = touching - point
    size = numpy.abs(numpy.asarray(points) - found.point).max()
    weights = found.multipliers * found.sides
    if found.kind == "plane" or (found.kind == "line" and len(found.point) == 2):
        normal = found.direction
        if found.kind == "line":
            normal = numpy.array([-found.direction[1], found.direction[0], 0])
        normals = numpy.tile(normal, (len(arms), 1))
    else:
        radial = arms
        if found.kind in ("cylinder", "line"):
            radial = arms - numpy.outer(arms @ found.direction, found.direction)
        elif found.direction is not None:  # a circle in space
            # which lies in the plane that its points were projected on
            radial = arms = arms - numpy.outer(arms @ found.direction, found.direction)
        normals = unit(radial)
    parts = [weights @ normals, weights @ numpy.cross(arms, normals) / size]
    if not (found.kind == "line" and len(found.point) == 3):
        parts.append([weights.sum()])
    return float(numpy.abs(numpy.concatenate(parts)).max())
