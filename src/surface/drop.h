// How low a tool can go over a place: until it touches the part from above.
//
// Laws: the tool at the height that is told cuts into no triangle, and touches one unless it stands
// on the floor; exact for each triangle, edge and corner, but for rounding; undercuts do not count,
// for a tool from above does not come there. Source of the contacts with faces: the tube's centre
// lies over the contact along the face's normal; along an edge the tip's height is a concave
// function, so that its maximum is found by a safe Newton iteration.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "support/progress.h"
#include "surface/cutter.h"
#include "surface/facet_mesh.h"

namespace evenload {

inline constexpr std::uint32_t kNoFacet = ~std::uint32_t{0};

struct ToolContact {
  double z = 0;  // mm, of the tip
  bool touches = false;
  // Where it touches:
  bool is_within = false;  // on picked faces, off their border
  SpacePoint point;
  SpacePoint normal;  // of length 1, from the part into the tool
  std::uint32_t facet = kNoFacet;
};

// The lowest place of a tool's tip over `at` that is not below `floor`, mm. `first`: a facet that
// may be touched, as one beside it was; it is found sooner then that most others lie too low.
ToolContact drop(const FacetMesh& mesh, const Cutter& cutter, Vec2 at, double floor,
                 std::uint32_t first = kNoFacet);

// Drops at many places beside each other: what of the part can lift the tool anywhere between them
// is looked for once.
class DropWindow {
 public:
  // Of the places no farther than `half`, mm, along x and along y from `middle`.
  DropWindow(const FacetMesh& mesh, const Cutter& cutter, Vec2 middle, double half, double floor);

  // As evenload::drop(), though where it touches two facets at one height it may tell of the other.
  // Condition: `at` is one of the places.
  ToolContact drop(Vec2 at, std::uint32_t first) const;

 private:
  const FacetMesh& mesh_;
  Cutter cutter_;
  double floor_;
  // How high leaves of one facet each may lift the tip over any of the places, the highest first.
  std::vector<std::pair<double, FacetNode>> above_;
  bool is_worth_it_ = true;  // whether these are few
};

// drop() for many places, on `threads` threads, 0: as many as there are cores. Throws Cancelled.
std::vector<ToolContact> drop_all(const FacetMesh& mesh, const Cutter& cutter,
                                  const std::vector<Vec2>& places, double floor, int threads,
                                  Progress& progress);

// Whether picked triangles lie under or over a place.
bool is_under_picked(const FacetMesh& mesh, Vec2 at);

}  // namespace evenload
