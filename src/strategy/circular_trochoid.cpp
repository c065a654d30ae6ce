#include "strategy/circular_trochoid.h"

#include <cmath>
#include <utility>

#include "cutting/engagement.h"
#include "geometry/bi_arc.h"
#include "support/errors.h"

namespace evenload {
namespace {

// Bi-arcs that stand for half a loop of a cycloid: their error falls with the cube of their length.
constexpr int kHalfLoopPieces = 6;
// rad
constexpr double kMostTurn = kPi;

// Where a loop is after a turn by `angle` from the right wall, its centre `s` mm along the middle.
Vec2 on_loop(const TrochoidParams& params, double s, double angle) {
  const Pose at = place_along(params.curvature, s);
  return at.p + half_room(params) * unit(at.heading + angle - kPi / 2);
}

TrochoidPattern circles(const TrochoidParams& params, double step) {
  const double radius = half_room(params), start = -kPi / 2;
  TrochoidPattern pattern;
  pattern.step = step;
  pattern.curvature = params.curvature;
  pattern.turn_radius = radius;
  const Pose before = place_along(params.curvature, -step);
  // Along the right wall from the circle before, which touched it there.
  const Vec2 from = before.p - radius * left_normal(unit(before.heading));
  pattern.cut.push_back(
      Segment::from_bulge(from, {0, -radius}, std::tan(params.curvature * step / 4)));
  pattern.cut.push_back(Segment::arc({}, radius, start, kPi));
  pattern.link.push_back(Segment::arc({}, radius, start + kPi, kPi));
  return pattern;
}

// Half a loop of the cycloid, begun `angle` rad after the right wall.
std::vector<Segment> half_loop(const TrochoidParams& params, double step, double angle) {
  const auto s_at = [&](double turned) { return step * turned / (2 * kPi); };
  const auto point = [&](double turned) { return on_loop(params, s_at(turned), turned); };
  const auto direction = [&](double turned) {
    const Pose at = place_along(params.curvature, s_at(turned));
    const double speed = step / (2 * kPi), whole = at.heading + turned - kPi / 2;
    return normalized(speed * unit(at.heading) + half_room(params) *
                                                     (1 + params.curvature * speed) *
                                                     left_normal(unit(whole)));
  };
  std::vector<Segment> moves;
  for (int i = 0; i < kHalfLoopPieces; ++i) {
    const double a = angle + kPi * i / kHalfLoopPieces, b = angle + kPi * (i + 1) / kHalfLoopPieces;
    const std::optional<BiArc> pair =
        bi_arc({point(a), direction(a)}, {point(b), direction(b)}, kMostTurn);
    EVENLOAD_ASSERT(pair.has_value());
    moves.push_back(pair->first);
    moves.push_back(pair->second);
  }
  return moves;
}

TrochoidPattern cycloid(const TrochoidParams& params, double step) {
  TrochoidPattern pattern;
  pattern.step = step;
  pattern.curvature = params.curvature;
  pattern.turn_radius = half_room(params);
  pattern.cut = half_loop(params, step, 0);
  pattern.link = half_loop(params, step, kPi);
  return pattern;
}

// A loop removes no more at once than a straight cut with a side step as large as its step.
double most_step(const TrochoidParams& params) {
  return 2 * side_step(params.engagement, params.tool_radius);
}

}  // namespace

std::optional<TrochoidPattern> circular_pattern(const TrochoidParams& params) {
  check(params);
  return with_greatest_step([&](double step) { return circles(params, step); }, params,
                            most_step(params));
}

std::optional<TrochoidPattern> cycloid_pattern(const TrochoidParams& params) {
  check(params);
  return with_greatest_step([&](double step) { return cycloid(params, step); }, params,
                            most_step(params));
}

}  // namespace evenload
