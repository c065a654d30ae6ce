#include "strategy/choose/leftover.h"

#include <algorithm>
#include <cmath>

namespace evenload {
namespace {

// Share of the tool's radius between the points.
constexpr double kSpacing = 1.0 / 15;
// The grid is not made of more points than this.
constexpr double kMaximumPoints = 4e7;
// Tool radii: the side of the cells that the points lie in; asked for are half a radius at once.
constexpr double kCell = 0.5;
// mm: points nearer than this to the edge of the tool's reach are not looked for.
constexpr double kEdge = 0.01;
// Shares of the tool's radius. Where passes meet, slivers may lie between the points: there they
// come as near to each other as the first; not along walls, nearer than the second to the edge of
// the tool's reach, where samples of the walls see what is left.
constexpr double kFinest = 1.0 / 60, kBesideWalls = 0.05;

// A place is approached from every side; where one came to nothing, from the next so many further.
constexpr int kSides = 24, kSidesApart = 4;

// The pose `outwards` of `x` where the tool just touches the surroundings of that on its right.
std::optional<Pose> touching(const ClearedGround& ground, const Area& centres, Vec2 x,
                             Vec2 outwards) {
  const double radius = ground.tool_radius(), far = 2.5 * radius;
  const auto usable = [&](double d) {
    const Vec2 p = x + d * outwards;
    return centres.signed_distance(p) >= 0 && ground.is_clear(p);
  };
  double touch = radius;
  while (touch < far && !usable(touch)) touch += 0.1 * radius;
  if (touch >= far) return std::nullopt;
  double near = touch - 0.1 * radius;
  for (int k = 0; k < 20; ++k) {
    const double middle = 0.5 * (near + touch);
    (usable(middle) ? touch : near) = middle;
  }
  return Pose{x + touch * outwards, angle_of(-outwards) + kPi / 2};
}

Bounds around(Vec2 p, double by) { return {p - Vec2{by, by}, p + Vec2{by, by}}; }

}  // namespace

void Leftover::prepare(const Area& centres, const Bounds& bounds, const ClearedGround& ground,
                       Progress* progress) {
  const double radius = ground.tool_radius();
  const double width = bounds.high.x - bounds.low.x, height = bounds.high.y - bounds.low.y;
  cell_ = std::max(kSpacing * radius, std::sqrt(width * height / kMaximumPoints));
  const int columns = static_cast<int>(std::ceil(width / cell_));
  const int rows = static_cast<int>(std::ceil(height / cell_));
  for (int j = 0; j < rows; ++j) {
    if (progress) progress->step();
    for (int i = 0; i < columns; ++i)
      look_within(bounds.low + Vec2{(i + 0.5) * cell_, (j + 0.5) * cell_}, cell_, centres, ground);
  }
  bounds_ = bounds;
  prepared_ = true;
  offer(left(ground), ground);
}

// Takes the middle of a square if that is left, or else looks at its quarters where they may be.
void Leftover::look_within(Vec2 p, double side, const Area& centres, const ClearedGround& ground) {
  const double radius = ground.tool_radius(), half_diagonal = std::sqrt(0.5) * side;
  if (ground.is_cleared_around(p, half_diagonal)) return;
  const double reach = radius + centres.signed_distance(p);  // mm from the edge of the reach
  if (reach < kEdge) return;
  if (!ground.is_cleared_point(p)) {
    points_.push_back(p);
    areas_.push_back(side * side);
    return;
  }
  if (0.5 * side < kFinest * radius * (1 - 1e-9) || reach < kBesideWalls * radius + half_diagonal)
    return;
  for (const double x : {-0.25, 0.25})
    for (const double y : {-0.25, 0.25})
      look_within(p + Vec2{x * side, y * side}, 0.5 * side, centres, ground);
}

// The points that hold material.
std::vector<std::size_t> Leftover::left(const ClearedGround& ground) const {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (!ground.is_cleared_point(points_[i])) result.push_back(i);
  return result;
}

void Leftover::offer(const std::vector<std::size_t>& left, const ClearedGround& ground) {
  left_when_asked_ = left.size();
  to_ask_ = PointGrid(bounds_, kCell * ground.tool_radius());
  for (const std::size_t i : left) to_ask_.add(i, points_[i]);
}

bool Leftover::ask_again(const ClearedGround& ground) {
  const std::vector<std::size_t> still = left(ground);
  asked_in_vain_ = still.size() < left_when_asked_ ? 0 : asked_in_vain_ + 1;
  if (asked_in_vain_ > kMostInVain) return false;
  offer(still, ground);
  return true;
}

double Leftover::area(const ClearedGround& ground) {
  double area = 0;
  place_.reset();
  for (const std::size_t i : left(ground)) {
    if (!place_) place_ = points_[i];
    area += areas_[i];
  }
  return area;
}

std::optional<Vec2> Leftover::nearest_left(const ClearedGround& ground, Vec2 from) {
  while (const std::optional<std::size_t> item = to_ask_.nearest(from)) {
    const Vec2 p = points_[*item];
    if (!ground.is_cleared_point(p)) return p;
    // What lies beside it is likely to be cleared as well.
    to_ask_.drop_if(around(p, 0),
                    [&](std::size_t i) { return ground.is_cleared_point(points_[i]); });
  }
  return std::nullopt;
}

std::optional<Pose> Leftover::next_start(const ClearedGround& ground, const Area& centres,
                                         Vec2 from) {
  for (;;) {
    while (asked_ && next_side_ < kSides && !ground.is_cleared_point(*asked_)) {
      const std::optional<Pose> start =
          touching(ground, centres, *asked_, unit(2 * kPi * next_side_ / kSides));
      next_side_ += start ? kSidesApart : 1;
      if (start) return start;
    }
    const std::optional<Vec2> nearest = nearest_left(ground, from);
    if (!nearest) return std::nullopt;
    asked_ = nearest;
    next_side_ = 0;
    // Neighbours belong to the same piece.
    const double radius = ground.tool_radius();
    to_ask_.drop_if(around(*nearest, 0.5 * radius),
                    [&](std::size_t i) { return distance(points_[i], *nearest) < 0.5 * radius; });
  }
}

}  // namespace evenload
