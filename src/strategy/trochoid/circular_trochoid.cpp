#include "strategy/trochoid/circular_trochoid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cutting/engagement.h"
#include "geometry/bi_arc.h"
#include "support/errors.h"

namespace evenload {
namespace {

// Bi-arcs that stand for either part of a loop of a cycloid: their error falls with the cube of
// their length.
constexpr int kPiecesOfPart = 6;
// Half rooms: a cycloid that advances by more than 2 pi of them has no loops, and by nearly as much
// tiny ones.
constexpr double kMostAdvance = 4;
// Of the angle in which a loop meets material beyond a wall: in bent slots it is a little more.
constexpr double kBeyondRoom = 1.15;
constexpr double kMostBeyond = 0.45 * kPi;  // rad
// rad
constexpr double kMostTurn = kPi;
// mm: rounded, shorter lines would turn aside by up to half a degree.
constexpr double kShortestAdvance = 0.02;

// Where a loop is after a turn by `angle` from the right wall, its centre `s` mm along the middle.
Vec2 on_loop(const TrochoidParams& params, double s, double angle) {
  const Pose at = place_along(params.curvature, s);
  return at.p + half_room(params) * unit(at.heading + angle - kPi / 2);
}

// rad: how far beyond a wall's place a loop still meets material: as long as the tool's centre is
// farther from the centre of the loop before than that loop's radius.
double beyond_wall(const TrochoidParams& params, double step) {
  return std::min(kMostBeyond,
                  kBeyondRoom * std::asin(std::min(1.0, step / (2 * half_room(params)))));
}

TrochoidPattern circles(const TrochoidParams& params, double step) {
  const double radius = half_room(params), start = -kPi / 2;
  const double cut = kPi + beyond_wall(params, step);
  TrochoidPattern pattern;
  pattern.step = step;
  pattern.curvature = params.curvature;
  pattern.turn_radius = radius;
  if (step < kShortestAdvance) {
    // On the way back instead, which leads to where the next circle meets material.
    const double beyond = cut - kPi;
    pattern.cut.push_back(Segment::arc({}, radius, start - beyond, cut + beyond));
    const Pose next = place_along(params.curvature, step);
    const auto on_circle = [&](const Pose& at, double angle) {
      const Vec2 outwards = unit(at.heading + angle);
      return PlanePoint{at.p + radius * outwards, left_normal(outwards)};
    };
    const auto link =
        bi_arc(on_circle({}, start + cut), on_circle(next, start - beyond), kMostTurn);
    EVENLOAD_ASSERT(link.has_value());
    pattern.link = {link->first, link->second};
    return pattern;
  }
  const Pose before = place_along(params.curvature, -step);
  // Along the right wall from the circle before, which touched it there.
  const Vec2 from = before.p - radius * left_normal(unit(before.heading));
  pattern.cut.push_back(
      Segment::from_bulge(from, {0, -radius}, std::tan(params.curvature * step / 4)));
  pattern.cut.push_back(Segment::arc({}, radius, start, cut));
  pattern.link.push_back(Segment::arc({}, radius, start + cut, 2 * kPi - cut));
  return pattern;
}

// The part of a cycloid's loop from `from` to `to` rad after the right wall.
std::vector<Segment> part_of_loop(const TrochoidParams& params, double step, double from,
                                  double to) {
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
  for (int i = 0; i < kPiecesOfPart; ++i) {
    const double a = from + (to - from) * i / kPiecesOfPart,
                 b = from + (to - from) * (i + 1) / kPiecesOfPart;
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
  const double beyond = beyond_wall(params, step);
  pattern.cut = part_of_loop(params, step, -beyond, kPi + beyond);
  pattern.link = part_of_loop(params, step, kPi + beyond, 2 * kPi - beyond);
  return pattern;
}

// A loop removes no more at once than a straight cut with a side step as large as its step; and it
// must be a loop.
StepGuess step_guess(const TrochoidParams& params) {
  const double most = std::min(2 * side_step(params.engagement, params.tool_radius),
                               kMostAdvance * half_room(params));
  return {most, most};
}

std::optional<TrochoidPattern> pattern_of(const std::optional<RepeatedPattern>& repeated) {
  return repeated ? std::optional(repeated->pattern()) : std::nullopt;
}

}  // namespace

std::optional<TrochoidPattern> circular_pattern(const TrochoidParams& params) {
  check(params);
  return pattern_of(with_greatest_step([&](double step) { return circles(params, step); }, params,
                                       step_guess(params)));
}

std::optional<TrochoidPattern> cycloid_pattern(const TrochoidParams& params) {
  check(params);
  return pattern_of(with_greatest_step([&](double step) { return cycloid(params, step); }, params,
                                       step_guess(params)));
}

}  // namespace evenload
