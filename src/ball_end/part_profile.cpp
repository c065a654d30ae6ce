#include "ball_end/part_profile.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace evenload {

namespace {

constexpr double kPlaneHalf = 1e4;  // mm, more than any part has

Vec2 normal_of(double lean) { return {std::sin(lean), std::cos(lean)}; }
Vec2 tangent_of(double lean) { return {std::cos(lean), -std::sin(lean)}; }

}  // namespace

PartProfile plane_profile() { return {{-kPlaneHalf, 0}, 0, {{2 * kPlaneHalf, 0}}}; }

PartProfile cylinder_profile(double radius) {
  const double lean = radius > 0 ? -kSteepest : kSteepest;
  return {radius * normal_of(lean), lean, {{2 * kSteepest * std::abs(radius), 1 / radius}}};
}

PartProfile test_part_profile(bool is_convex) {
  constexpr double kDome = 45, kFillet = 10, kFlat = 10, kHalf = 40;
  const double lean = std::asin((kHalf - kFlat) / (kDome + kFillet));
  const double sign = is_convex ? 1 : -1;
  const double flat = (kDome + kFillet) * std::cos(lean) - kFillet;  // its z, if convex
  const ProfilePiece fillet{kFillet * lean, -sign / kFillet};
  return {{-kHalf, sign * flat},
          0,
          {{kFlat, 0}, fillet, {2 * kDome * lean, sign / kDome}, fillet, {kFlat, 0}}};
}

ExtrudedSurface::ExtrudedSurface(const PartProfile& profile, double ball_radius, Steps steps)
    : steps_(steps), ball_radius_(ball_radius) {
  Vec2 part = profile.start;
  double lean = profile.lean, q = 0;
  for (const ProfilePiece& piece : profile.pieces) {
    const double k = piece.curvature, stretch = 1 + k * ball_radius;
    if (!(stretch > 0))
      throw std::invalid_argument(
          "The ball does not fit into the concave surface: take a tool whose radius is smaller.");
    const Vec2 n = normal_of(lean), tangent = tangent_of(lean), centre = part + ball_radius * n;
    if (steps == Steps::kPlan) q = centre.x;
    pieces_.push_back(
        {k, k / stretch, lean, q, part, centre, tangent, k != 0 ? part - n / k : Vec2{}});
    const double next = lean + k * piece.length;
    if (k != 0)
      part = pieces_.back().middle + normal_of(next) / k;
    else
      part += piece.length * tangent;
    lean = next;
    q += steps == Steps::kSurface ? piece.length : stretch * piece.length;
  }
  const Vec2 end = part + ball_radius * normal_of(lean);
  highest_ = end.x;
  if (steps == Steps::kPlan) q = end.x;
  // Straight on beyond both ends; the piece before the first begins at the same place.
  const Piece& first = pieces_.front();
  if (first.curvature != 0) {
    Piece before = first;
    before.curvature = before.centre_curvature = 0;
    pieces_.insert(pieces_.begin(), before);
  }
  if (pieces_.back().curvature != 0)
    pieces_.push_back({0, 0, lean, q, part, end, tangent_of(lean), {}});
}

const ExtrudedSurface::Piece& ExtrudedSurface::piece_at(double q) const {
  std::size_t i = 0;
  while (i + 1 < pieces_.size() && pieces_[i + 1].q <= q) ++i;
  return pieces_[i];
}

Vec2 ExtrudedSurface::normal_at(const Piece& piece, double q) const {
  if (piece.curvature == 0) return {-piece.tangent.y, piece.tangent.x};
  if (steps_ == Steps::kPlan) {
    const double sine = (q - piece.middle.x) * piece.centre_curvature;
    return {sine, std::sqrt(1 - sine * sine)};
  }
  const double k = steps_ == Steps::kCentre ? piece.centre_curvature : piece.curvature;
  return normal_of(piece.lean + k * (q - piece.q));
}

double ExtrudedSurface::step_coordinate(double y) const {
  if (steps_ == Steps::kPlan) return y;
  std::size_t i = 0;
  while (i + 1 < pieces_.size() && pieces_[i + 1].centre.x <= y) ++i;
  const Piece& piece = pieces_[i];
  // Along the centres; the part's own length is shorter on convex, longer on concave arcs.
  const double k = piece.centre_curvature;
  const double along = piece.curvature == 0
                           ? (y - piece.centre.x) / std::cos(piece.lean)
                           : (std::asin((y - piece.middle.x) * k) - piece.lean) / k;
  const double stretch = 1 + piece.curvature * ball_radius_;
  return piece.q + (steps_ == Steps::kSurface ? along / stretch : along);
}

PathPoint ExtrudedSurface::centre(Vec2 at, Vec2 along) const {
  const Piece& piece = piece_at(at.y);
  const Vec2 n = normal_at(piece, at.y), tangent{n.y, -n.x};
  // How fast the centre moves along its curve, and turns with it, as q grows.
  const double speed = steps_ == Steps::kPlan      ? 1 / n.y
                       : steps_ == Steps::kSurface ? 1 + piece.curvature * ball_radius_
                                                   : 1.0;
  const double k = piece.centre_curvature;
  Vec2 c;
  if (piece.curvature != 0) {
    c = piece.middle + n / k;
  } else {
    const double length = speed * (at.y - piece.q);
    c = piece.centre + length * piece.tangent;
  }
  const Vec2 first = speed * tangent;
  // In plan the ordinate grows evenly: only z is bent.
  const Vec2 second =
      steps_ == Steps::kPlan ? Vec2{0, -k * speed * speed * speed} : -k * speed * speed * n;
  const double b = along.y;
  return {{at.x, c.x, c.y},
          {along.x, b * first.x, b * first.y},
          {0, b * b * second.x, b * b * second.y}};
}

double ExtrudedSurface::distance(const Eigen::Vector3d& point) const {
  const Vec2 p{point.y(), point.z()};
  // Pieces meet in common normals: a point belongs to the last piece that begins before it.
  std::size_t i = pieces_.size() - 1;
  while (i > 0 && dot(p - pieces_[i].part, pieces_[i].tangent) < 0) --i;
  const Piece& piece = pieces_[i];
  const double k = piece.curvature;
  if (k == 0) return cross(piece.tangent, p - piece.part);
  return k > 0 ? norm(p - piece.middle) - 1 / k : -1 / k - norm(p - piece.middle);
}

Eigen::Vector3d ExtrudedSurface::normal(Vec2 at) const {
  const Vec2 n = normal_at(piece_at(at.y), at.y);
  return {0, n.x, n.y};
}

}  // namespace evenload
