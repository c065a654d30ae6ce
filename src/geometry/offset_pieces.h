// The first half of offset(): every boundary piece moved by d, with arcs around corners. Internal
// to offset.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/boundary_index.h"
#include "geometry/curve.h"

namespace evenload {

// Lengths that tell what is the same from what is not.
struct OffsetTolerances {
  // Of the result, mm; gaps shorter than this are closed without an arc.
  double whole = 0;
  // Points nearer than this are one point, mm: half of `whole`, so that what passes through a gap
  // closed without an arc still meets one of its ends.
  double same = 0;
  // Points may lie this much too near the boundary and still count as on the offset, mm.
  double depth = 0;
  // Points no deeper than this are on the offset beyond doubt, mm.
  double sure = 0;
};

// Points that pieces share, under numbers that can be merged.
class OffsetNodes {
 public:
  std::uint32_t add(Vec2 p);
  std::uint32_t find(std::uint32_t node) const;
  void merge(std::uint32_t a, std::uint32_t b);
  Vec2 at(std::uint32_t node) const { return points_[find(node)]; }
  std::size_t size() const { return points_.size(); }
  // Merges all nodes with points nearer than `reach` to each other.
  void merge_near(double reach);

 private:
  std::vector<Vec2> points_;
  mutable std::vector<std::uint32_t> parents_;
};

struct OffsetPiece {
  Segment segment;
  std::uint32_t from = 0, to = 0;  // nodes
  bool doubtful_side = false;  // an arc at a cusp, which may lie on the wrong side of the boundary
};

// The moved pieces of closed curves, right of travel for d > 0; some may be too near the boundary,
// wholly or in parts, but nothing of the true offset is missing. Neighbours that meet are cut where
// they meet already.
std::vector<OffsetPiece> offset_pieces(const std::vector<Curve>& curves,
                                       const BoundaryIndex& boundary, double d,
                                       const OffsetTolerances& tolerances, OffsetNodes& nodes);

}  // namespace evenload
