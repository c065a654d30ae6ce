// A region with fast answers to "inside, and how far from the border?".
#pragma once

#include <vector>

#include "geometry/boundary_index.h"
#include "geometry/region.h"

namespace evenload {

class Area {
 public:
  Area() : index_(std::vector<Curve>{}) {}
  explicit Area(const std::vector<Region>& regions);

  bool empty() const { return index_.empty(); }
  const std::vector<Curve>& curves() const { return curves_; }
  BoundaryIndex::Hit nearest(Vec2 q) const { return index_.nearest(q); }
  Segment segment_at(const BoundaryIndex::Hit& hit) const {
    return segments_[hit.curve][hit.segment];
  }
  // mm to the border, positive inside. Condition: not empty().
  double signed_distance(Vec2 q) const;
  double signed_distance(Vec2 q, const BoundaryIndex::Hit& hit) const;
  // 1/mm: of the border where it bends most towards the inside, as round islands; infinite at a
  // corner that sticks in.
  double inward_curvature() const { return inward_curvature_; }

 private:
  std::vector<Curve> curves_;
  std::vector<std::vector<Segment>> segments_;
  BoundaryIndex index_;
  double inward_curvature_ = 0;
};

}  // namespace evenload
