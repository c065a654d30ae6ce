#include "geometry/bi_arc.h"

#include <cmath>

namespace evenload {
namespace {

// Share of the distance between the ends: where the sum of the tangents along it is less, no joint
// lies as far along both.
constexpr double kLeastReach = 1e-9;

enum class TangentAt { kStart, kEnd };

std::optional<Segment> tangent_arc(Vec2 a, Vec2 b, Vec2 direction, TangentAt where,
                                   double most_turn) {
  const Vec2 chord = b - a;
  double half_turn = std::atan2(cross(direction, chord), dot(direction, chord));
  if (where == TangentAt::kEnd) half_turn = -half_turn;
  if (!(std::abs(2 * half_turn) <= most_turn)) return std::nullopt;
  return Segment::from_bulge(a, b, std::tan(half_turn / 2));
}

}  // namespace

std::optional<BiArc> bi_arc(const PlanePoint& from, const PlanePoint& to, double most_turn,
                            double ratio) {
  const Vec2 v = to.p - from.p;
  const double along = dot(v, ratio * from.direction + to.direction);
  const double apart = 2 * ratio * (1 - dot(from.direction, to.direction));
  const double denominator = along + std::sqrt(along * along + apart * squared_norm(v));
  if (!(denominator > kLeastReach * norm(v))) return std::nullopt;
  const double reach = squared_norm(v) / denominator;
  const double share = 1 / (1 + ratio);
  const Vec2 joint = share * (from.p + ratio * reach * from.direction) +
                     (1 - share) * (to.p - reach * to.direction);
  const auto first = tangent_arc(from.p, joint, from.direction, TangentAt::kStart, most_turn);
  const auto second = tangent_arc(joint, to.p, to.direction, TangentAt::kEnd, most_turn);
  if (!first || !second) return std::nullopt;
  return BiArc{*first, *second};
}

}  // namespace evenload
