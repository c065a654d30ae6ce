"""What comes out: heights over the part, cusps, gouges, and their figures."""

from functools import cached_property

import numpy

from evenload.surface_simulation import chips, rough, rough_map
from evenload.surface_simulation.rough import CUT_OFF

WISH_BAND = 0.1  # of the wished cusp height, to both sides
MOST_SPREADS = 64  # cells, by which cusps are spread to what lies between them
LEAST_GOUGE = 1e-3  # mm: less is rounding
ROUGH_SHARE = 0.05  # of the mean cusp, by which triangles may leave the part without a word on it

__all__ = ["CUT_OFF", "SurfaceSimulation"]


class SurfaceSimulation:
    """The surface that an operation leaves, on cells along x and y; lengths in mm, areas in mm² of
    the surface itself, heights across it.

    x, y: the cells' middles; resolution: between them. Arrays of rows along x, one for each y, not
    a number where no picked face lies on top: part: z of the part; above: what stands on the part,
    below 0 where it is cut into, `stock` where no pass has come; cusp: by how much the nearest cusp
    stands out from the passes beside it; gouge, rest: `above` where it is below and above 0. Where
    the part lies on top at all: gouge_anywhere. mean_cusp, cusp_95, max_cusp: along all ridges,
    None without any; wish_share: the share of what has cusps that has the wished ones within 10 %;
    gouge_mm, gouge_at: the deepest, anywhere on the parts, and where; covered_area,
    uncovered_area: of the faces. notes: sentences on what could not be taken as it is.
    """

    def __init__(self, question, first, resolution, found, notes):
        self.question, self.resolution, self.notes = question, float(resolution), list(notes)
        self.label, self.stock, self.wish = question.label, question.stock, question.wish or None
        self.deflection = question.triangles.deflection
        rows, columns = found["part"].shape
        self.x = first[0] + self.resolution * numpy.arange(columns)
        self.y = first[1] + self.resolution * numpy.arange(rows)
        self.is_picked, self._found = found["is_picked"], found
        self.is_covered = self.is_picked & (found["move"] >= 0)
        self.part = numpy.where(self.is_picked, found["part"], numpy.nan)
        self.above = numpy.where(self.is_picked, found["above"], numpy.nan)
        self.ridges = found["cusp"]
        if not self.is_picked.any():
            raise ValueError(
                "None of the picked faces lies on top: others of the models hide them."
            )
        if self.mean_cusp is not None and self.deflection > ROUGH_SHARE * self.mean_cusp:
            self.notes.append(
                "The triangles leave the part by up to %.5f mm, and cusps are told no better than "
                "that: a finer tolerance takes longer." % self.deflection
            )

    # ---- arrays ----

    @property
    def rest(self):
        return numpy.maximum(self.above, 0.0)

    @property
    def gouge(self):
        return numpy.maximum(-self.above, 0.0)

    @cached_property
    def gouge_anywhere(self):
        is_part = numpy.isfinite(self._found["part"])
        return numpy.where(is_part, numpy.maximum(-self._found["above"], 0.0), numpy.nan)

    @cached_property
    def cusp(self):
        found = numpy.where(self.is_covered, self.ridges, numpy.nan)
        for _ in range(MOST_SPREADS):
            empty = numpy.isnan(found) & self.is_covered
            spread = numpy.where(empty, _highest_beside(found), found)
            if (numpy.isnan(spread) == numpy.isnan(found)).all():
                break
            found = spread
        return found

    @cached_property
    def areas(self):
        """mm² of the surface in each cell."""
        return self.resolution**2 / numpy.maximum(self._found["lean"], 1e-6)

    def z_at(self, row, column):
        """mm: of whatever part lies on top in a cell; -infinity where there is none."""
        return float(self._found["part"][row, column])

    # ---- figures ----

    @cached_property
    def _heights(self):
        return self.ridges[numpy.isfinite(self.ridges)]

    @property
    def mean_cusp(self):
        return float(self._heights.mean()) if len(self._heights) else None

    @property
    def cusp_95(self):
        return float(numpy.percentile(self._heights, 95)) if len(self._heights) else None

    @property
    def max_cusp(self):
        return float(self._heights.max()) if len(self._heights) else None

    @cached_property
    def wish_share(self):
        known = numpy.isfinite(self.cusp)
        if self.wish is None or not known.any():
            return None
        is_wished = known & (numpy.abs(self.cusp - self.wish) <= WISH_BAND * self.wish)
        return float(self.areas[is_wished].sum() / self.areas[known].sum())

    @property
    def gouge_mm(self):
        return float(numpy.nanmax(self.gouge_anywhere))

    @property
    def gouge_at(self):
        if not self.gouge_mm > LEAST_GOUGE:
            return None
        row, column = numpy.unravel_index(numpy.nanargmax(self.gouge_anywhere), self.part.shape)
        return float(self.x[column]), float(self.y[row]), self.z_at(row, column)

    @property
    def covered_area(self):
        return float(self.areas[self.is_covered].sum())

    @property
    def uncovered_area(self):
        return float(self.areas[self.is_picked & ~self.is_covered].sum())

    def figures(self):
        """{name with its unit: value} for reports; None where there is none."""
        return {
            "mean_cusp_mm": self.mean_cusp,
            "cusp_95_mm": self.cusp_95,
            "max_cusp_mm": self.max_cusp,
            "wish_share": self.wish_share,
            "gouge_mm": self.gouge_mm,
            "covered_area_mm2": self.covered_area,
            "uncovered_area_mm2": self.uncovered_area,
        }

    # ---- what is asked for apart ----

    def roughness(self, at=None, size=CUT_OFF):
        """The rough.Patch around a place (x, y) of the faces, None: their middle, with the marks of
        single teeth where the spindle speed is known; size: mm, of its sides.
        """
        return rough.patch(self, at, size)

    @cached_property
    def roughness_map(self):
        """The rough_map.RoughnessMap: R_z of patches all over what was cut. Raises ValueError with
        a sentence where there are none.
        """
        return rough_map.all_over(self)

    @cached_property
    def chips(self):
        """The chips.Chips along the path of an EvenLoad Finishing with a ball end. Raises
        ValueError with a sentence where there are none.
        """
        return chips.along(self.question)

    def picture(self, path, what="cusp"):
        """Draws "cusp", "gouge", "rest", "roughness", "h_m", "tip share", "rz_along" or
        "rz_across" into a PNG or SVG file.

        Raises ValueError with a sentence for another word, and where there is no such thing.
        """
        # Here, for it needs matplotlib.
        from evenload.surface_simulation import picture

        picture.save(self, path, what)


def _highest_beside(values):
    """For each cell the highest of its four neighbours; not a number where these have none."""
    framed = numpy.pad(values, 1, constant_values=numpy.nan)
    sides = framed[:-2, 1:-1], framed[2:, 1:-1], framed[1:-1, :-2], framed[1:-1, 2:]
    return numpy.fmax(numpy.fmax(*sides[:2]), numpy.fmax(*sides[2:]))
