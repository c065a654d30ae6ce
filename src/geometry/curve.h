// Chains of lines and circular arcs.
//
// A chain is stored as in DXF: vertices with bulges, bulge = tan(included angle / 4) of the piece
// that starts at the vertex, positive when it turns counter-clockwise, 0 for a line. A piece turns
// by less than a full circle.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/vec2.h"

namespace evenload {

struct Bounds {
  Vec2 low, high;
};

struct Vertex {
  Vec2 p;
  double bulge = 0;
  bool open = false;  // true: no wall stands along the piece that starts here
};

// One piece of a chain, with its arc's data computed once.
// Laws: point(0) = a, point(1) = b; |point(t) - centre| = radius for arcs; tangent(t) is of unit
// length.
struct Segment {
  Vec2 a, b;
  double sweep = 0;        // rad, signed; 0 = line
  Vec2 centre;             // arcs only
  double radius = 0;       // mm, arcs only
  double start_angle = 0;  // of a - centre, arcs only
  bool open = false;

  static Segment line(Vec2 a, Vec2 b);
  static Segment arc(Vec2 centre, double radius, double start_angle, double sweep);
  static Segment from_bulge(Vec2 a, Vec2 b, double bulge);

  bool is_arc() const { return sweep != 0; }
  double length() const;
  double curvature() const;  // 1/mm, positive = turns left
  double bulge() const;
  Vec2 point(double t) const;    // t in [0, 1], by arc length
  Vec2 tangent(double t) const;  // unit vector in the direction of travel
  Segment reversed() const;
  Segment part(double t0, double t1) const;  // 0 <= t0 < t1 <= 1
  double nearest(Vec2 q) const;              // t of the point nearest to q
  double distance_to(Vec2 q) const;          // mm
  Bounds bounds() const;                     // the smallest box with sides along the axes

  bool operator==(const Segment&) const = default;
};

// Arcs flatter than this bulge, or with less sagitta than kStraightSagitta mm, are read as lines:
// their centre lies so far away that rounding there would outweigh what the arc adds.
inline constexpr double kStraightBulge = 1e-8;
inline constexpr double kStraightSagitta = 1e-9;

// What a piece adds to the winding number around q. Over the pieces of closed chains the sum is
// exact off the chains.
int winding_of(const Segment& s, Vec2 q);

class Curve {
 public:
  Curve() = default;
  Curve(std::vector<Vertex> vertices, bool closed)
      : vertices_(std::move(vertices)), closed_(closed) {}

  const std::vector<Vertex>& vertices() const { return vertices_; }
  bool closed() const { return closed_; }
  bool empty() const { return vertices_.empty(); }
  std::size_t segment_count() const {
    return vertices_.size() < 2 ? 0 : vertices_.size() - (closed_ ? 0 : 1);
  }
  Segment segment(std::size_t i) const;
  std::vector<Segment> segments() const;

  double length() const;
  double signed_area() const;  // mm^2, counter-clockwise positive; closed curves only
  bool contains(
      Vec2 q) const;  // closed curves only, by winding; points on the curve: either answer
  Curve reversed() const;
  // Points along the curve so that chords deviate at most `tolerance` mm. A closed curve's first
  // point is not repeated.
  std::vector<Vec2> flattened(double tolerance) const;

 private:
  std::vector<Vertex> vertices_;
  bool closed_ = true;
};

}  // namespace evenload
