// The ground that the tool has cleared: the union of discs swept along moves, exact, without cells
// or polygons.
//
// The question a steering method asks is not "what is the boundary?" but "which part of the tool's
// circle at P touches material?". It is answered by subtracting from the circle, one after the
// other, the arcs that earlier moves cleared. A move along a line or arc sweeps a capsule or a bent
// capsule; its border crosses a circle in a few angles with closed forms. No arrangement of curves
// is built, so there is none that could become inconsistent.
//
// Moves are kept in a uniform grid of buckets. Tolerance: kCoverTolerance.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/boundary_index.h"
#include "geometry/region.h"

namespace evenload {

// mm: material thinner than this does not count as material; above the tolerance of offsets.
inline constexpr double kCoverTolerance = 2e-5;

// Angles [low, high], rad, counter-clockwise, not wrapped.
struct AngularInterval {
  double low = 0, high = 0;
  double width() const { return high - low; }
};

class ClearedGround {
 public:
  // `bounds`: where the tool's centre may be. `tool_radius` mm.
  // `material`: where there is stock at all; nullptr: everywhere that the tool can touch.
  ClearedGround(const Bounds& bounds, double tool_radius, const std::vector<Region>* material);

  double tool_radius() const { return tool_radius_; }

  void add(const Segment& move) { add(move, tool_radius_); }
  void add(const Segment& move, double swept_radius);
  void add_disc(Vec2 centre, double radius) { add(Segment::line(centre, centre), radius); }
  // Takes back the newest move.
  void remove_last();
  std::size_t size() const { return primitives_.size(); }

  // The arcs of the tool's circle about `p` within [low, high] (high - low <= 2 pi) that touch
  // material, in order. `shrink` mm: the circle's radius is the tool's less this.
  void uncovered(Vec2 p, double low, double high, std::vector<AngularInterval>& out,
                 double shrink = kCoverTolerance) const {
    uncovered(p, low, high, out, shrink, primitives_.size());
  }
  // The same, as it was before the move numbered `last`.
  void uncovered(Vec2 p, double low, double high, std::vector<AngularInterval>& out, double shrink,
                 std::size_t last) const;
  // True when the whole circle about `p` is free of material.
  bool is_clear(Vec2 p, double shrink = kCoverTolerance) const;
  // True when the point `x` holds no material.
  bool is_cleared_point(Vec2 x) const;
  // True when the move numbered `first` or a later one cleared `x`.
  bool is_cleared_since(Vec2 x, std::size_t first) const;

 private:
  struct Primitive {
    Segment segment;
    Vec2 direction;       // lines
    double length = 0;    // lines
    double radius = 0;    // mm, swept
    Vec2 first, last;     // arcs: unit vectors from the centre to the ends, counter-clockwise
    bool reflex = false;  // arcs: the sector is wider than half a turn
  };
  struct Disc {
    Vec2 centre;
    double radius = 0;
  };
  // Takes what the move covers from the circle's arcs in `set`. False when they stay as they were.
  bool subtract(const Primitive& primitive, Vec2 p, double radius,
                std::vector<AngularInterval>& set) const;
  double distance(const Primitive& primitive, Vec2 x) const;
  void remove_outside_material(Vec2 p, double radius, std::vector<AngularInterval>& set) const;
  const std::vector<std::int32_t>& bucket(Vec2 p) const;
  template <typename Visit>
  void visit_buckets(const Primitive& primitive, Visit visit);

  double tool_radius_;
  double cell_;
  Vec2 origin_;
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<std::int32_t>> buckets_;
  std::vector<std::int32_t> nothing_;
  std::vector<Primitive> primitives_;
  std::vector<Disc> discs_;  // that hold what each move sweeps
  std::vector<Segment> material_edges_;
  std::vector<Region> material_;
  bool limited_ = false;
};

}  // namespace evenload
