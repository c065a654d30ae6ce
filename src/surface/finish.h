// Finishing: the whole path over the picked faces of a part.
//
//  0. Extension: what passes may go on over beyond the faces, if they shall
//  1. pass_frame: the faces seen along the passes
//  2. even_spacing or spacing_by_cusp: where the passes lie; or contour_rows, spiral_rows,
//     Guides, contours_by_cusp, spiral_by_cusp for those along other lines
//  3. samples_along, parts_at_work: the tool's height along each, where it is to cut
//  4. fewest_lines: the lines of each, over arcs in plan helices
//  5. in_order: which part follows which, links along the surface, and the ways over the part
//
// Laws: the tool cuts into the triangles by a tenth of the tolerance at the most, and leaves the
// allowance by the tolerance at the most; links keep to the same; rapids are at the safe height or
// above, but straight up and down above `top`; same input, same bytes, on any number of threads.
#pragma once

#include "support/progress.h"
#include "surface/facet_mesh.h"
#include "surface/finish_params.h"
#include "toolpath/toolpath.h"

namespace evenload {

struct Finish {
  Toolpath toolpath;
  // mm: of neighbouring passes, in plan; both 0 for a single one.
  double least_stepover = 0, largest_stepover = 0;
};

// deflection: mm by which the triangles leave the part, of which only the distance of passes by
// their cusps takes heed. fixtures: what the tool keeps off besides, may be null; nothing of it may
// stand above the safe height. Throws std::invalid_argument for parameters out of their ranges, and
// where nothing is picked or the tool nowhere touches what is. A cancelled path is empty.
Finish finish_surface(const FacetMesh& mesh, const FinishParams& params, double deflection,
                      Progress& progress, const FacetMesh* fixtures = nullptr);

}  // namespace evenload
