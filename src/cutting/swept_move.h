// A move with the ground that a disc swept along it clears: how far points are from the move, and
// which arcs of a circle lie on that ground. A move along a line sweeps a capsule, along an arc a
// bent capsule; their borders cross a circle in a few angles with closed forms.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "geometry/curve.h"
#include "geometry/vec2.h"

namespace evenload {

// Angles [low, high], rad, counter-clockwise, not wrapped.
struct AngularInterval {
  double low = 0, high = 0;
  double width() const { return high - low; }
};

// Removes the arc [low, high], given in any turn, from a set in order that lies within
// [base, base + 2 pi]. With the same `base` what is left does not depend on the order of the cuts,
// not even in its last bit.
void cut_wrapped(std::vector<AngularInterval>& set, double base, double low, double high);

// A question about the circle of `radius` about `p`.
struct CircleLook {
  Vec2 p;
  double radius = 0;
  double base = 0;       // rad: its arcs lie within a turn from here
  std::size_t last = 0;  // moves from this one on do not count
};

// The border of swept ground as it is seen from a point.
struct BorderView {
  double beyond = 0;    // mm from the border to the point; negative for a point on the ground
  double distance = 0;  // mm from the move to the point
  Vec2 away;            // unit vector from the move's nearest point to the point
  double bulge = 0;     // mm: how far the move reaches from its nearest point in that direction
};

// mm: far above rounding.
inline constexpr double kHidingMargin = 1e-6;

// True only when, within `reach` of the point that both are seen from, the one move clears all that
// the other does, and kHidingMargin more. Distances from a move grow no faster than those from its
// nearest point, and no slower than those from the straight line that bounds it.
inline bool hides(const BorderView& hiding, const BorderView& hidden, double reach);

class SweptMove {
 public:
  // `swept_radius` mm: of the disc.
  SweptMove(const Segment& move, double swept_radius);

  const Segment& segment() const { return segment_; }
  double swept_radius() const { return swept_radius_; }
  // From `x` to the nearest point of the move.
  double distance(Vec2 x) const;
  // Whether `x` lies within less than `reach` mm, > 0.
  bool is_within(Vec2 x, double reach) const;
  Vec2 nearest(Vec2 x) const;
  BorderView seen_from(Vec2 x) const;
  // Takes what the move covers of the circle from its arcs in `set`; false where that is nothing.
  bool subtract(const CircleLook& look, std::vector<AngularInterval>& set) const;

 private:
  // Whether the nearest point of an arc's whole circle to the place `v` from its centre is on it.
  bool is_beside(Vec2 v, double margin) const {
    const bool after_first = cross(first_, v) >= -margin, before_last = cross(v, last_) >= -margin;
    return reflex_ ? after_first || before_last : after_first && before_last;
  }

  Segment segment_;
  double swept_radius_;
  Vec2 direction_;       // lines
  double length_ = 0;    // lines
  Vec2 first_, last_;    // arcs: unit vectors from the centre to the ends, counter-clockwise
  bool reflex_ = false;  // arcs: the sector is wider than half a turn
};

inline bool hides(const BorderView& hiding, const BorderView& hidden, double reach) {
  const double spare = hidden.beyond - hidden.bulge - hiding.beyond - kHidingMargin;
  return spare > 0 &&
         reach * reach / (2 * hiding.distance) + reach * norm(hiding.away - hidden.away) <= spare;
}

inline double SweptMove::distance(Vec2 x) const {
  const Segment& s = segment_;
  if (!s.is_arc()) {
    const Vec2 v = x - s.a;
    const double along = dot(v, direction_);
    if (along <= 0) return norm(v);
    if (along >= length_) return evenload::distance(x, s.b);
    return std::abs(cross(direction_, v));
  }
  const Vec2 v = x - s.centre;
  if (is_beside(v, 0)) return std::abs(norm(v) - s.radius);
  return std::sqrt(std::min(squared_norm(x - s.a), squared_norm(x - s.b)));
}

// Squares in place of square roots: of all that the search for engagement does this is done most.
inline bool SweptMove::is_within(Vec2 x, double reach) const {
  const Segment& s = segment_;
  const double square = reach * reach;
  if (!s.is_arc()) {
    const Vec2 v = x - s.a;
    const double along = dot(v, direction_);
    if (along <= 0) return squared_norm(v) < square;
    if (along >= length_) return squared_norm(x - s.b) < square;
    return std::abs(cross(direction_, v)) < reach;
  }
  const Vec2 v = x - s.centre;
  if (!is_beside(v, 0)) return squared_norm(x - s.a) < square || squared_norm(x - s.b) < square;
  const double from_centre = squared_norm(v), outside = s.radius + reach;
  if (from_centre >= outside * outside) return false;
  const double inside = s.radius - reach;
  return inside <= 0 || from_centre > inside * inside;
}

}  // namespace evenload
