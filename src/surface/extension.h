// What passes may go on over beyond the borders of the picked faces.
//
// Where the part goes on beside a picked face, bent by no more than kGoesOn, passes follow it.
// Where it ends or falls away they go on straight, over skirts that carry on the face's plane;
// where it rises more steeply they end. Law: skirts are added to the part, nothing is taken from
// it, so that the tool keeps off both.
#pragma once

#include "geometry/boundary_index.h"
#include "geometry/region.h"
#include "surface/facet_mesh.h"

namespace evenload {

inline constexpr double kGoesOn = 20 * kPi / 180;  // rad

class Extension {
 public:
  // extension: mm in plan, > 0. Throws std::invalid_argument where nothing picked is seen from
  // above.
  Extension(const FacetMesh& part, double extension);

  const FacetMesh& ground() const { return ground_; }  // the part and the skirts
  const FacetMesh& own() const { return own_; }        // what passes may touch: all of it is picked
  double width() const { return width_; }              // mm, in plan
  bool reaches(Vec2 place) const { return limit_.contains(place); }
  const std::vector<Region>& regions() const { return regions_; }  // that it reaches

 private:
  double width_;
  std::vector<Region> regions_;
  BoundaryIndex limit_;
  FacetMesh ground_, own_;
};

}  // namespace evenload
