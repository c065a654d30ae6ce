// What is left within the tool's reach, found on a grid of points, and where to approach it. A
// point that was cleared or asked for is not looked at again.
#pragma once

#include <optional>
#include <vector>

#include "cutting/cleared_ground.h"
#include "geometry/point_grid.h"
#include "strategy/places/area.h"
#include "strategy/steer/steering.h"
#include "support/progress.h"

namespace evenload {

class Leftover {
 public:
  bool prepared() const { return prepared_; }
  // Finds the points within reach of `centres` that hold material. Makes steps of `progress`.
  void prepare(const Area& centres, const Bounds& bounds, const ClearedGround& ground,
               Progress* progress = nullptr);
  // A pose that touches, on its right, leftover material not yet asked for; nearest to `from`
  // first. Each place is offered from one side, and from others as long as it stays.
  std::optional<Pose> next_start(const ClearedGround& ground, const Area& centres, Vec2 from);
  // Every place that is still left will be offered once more: what a pass left of a piece may be
  // reached from another side. False, and nothing is changed, where that has been done kMostInVain
  // times without a point cleared since. Condition: prepared().
  bool ask_again(const ClearedGround& ground);
  static constexpr int kMostInVain = 100;  // passes at small angles take layers between the points
  // mm^2 that are still left. Condition: prepared().
  double area(const ClearedGround& ground);
  // The first point of what area() found; empty when there was nothing.
  std::optional<Vec2> place() const { return place_; }

 private:
  std::optional<Vec2> nearest_left(const ClearedGround& ground, Vec2 from);
  std::vector<std::size_t> left(const ClearedGround& ground) const;
  void offer(const std::vector<std::size_t>& left, const ClearedGround& ground);
  void look_within(Vec2 p, double side, const Area& centres, const ClearedGround& ground);

  std::vector<Vec2> points_;
  std::vector<double> areas_;  // mm^2 that each of them stands for
  Bounds bounds_;
  PointGrid to_ask_;  // those of the points that may be left and were not asked for
  std::size_t left_when_asked_ = 0;
  int asked_in_vain_ = 0;
  std::optional<Vec2> place_;
  double cell_ = 0;            // mm, the side of the largest square that a point stands for
  std::optional<Vec2> asked_;  // the place last asked for
  int next_side_ = 0;          // of it
  bool prepared_ = false;
};

}  // namespace evenload
