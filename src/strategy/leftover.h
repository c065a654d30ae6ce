// What is left within the tool's reach, found on a grid of points, and where to approach it.
#pragma once

#include <optional>
#include <vector>

#include "cutting/cleared_ground.h"
#include "strategy/area.h"
#include "strategy/steering.h"

namespace evenload {

class Leftover {
 public:
  bool prepared() const { return prepared_; }
  // Finds the points within reach of `centres` that hold material.
  void prepare(const Area& centres, const Bounds& bounds, const ClearedGround& ground);
  // A pose that touches, on its right, leftover material not yet asked for; nearest to `from`
  // first. Each place is offered once.
  std::optional<Pose> next_start(const ClearedGround& ground, const Area& centres, Vec2 from);
  // mm^2 that are still left. Condition: prepared().
  double area(const ClearedGround& ground);
  // One point of what area() found; empty when there was nothing.
  std::optional<Vec2> place() const {
    return points_.empty() ? std::nullopt : std::optional<Vec2>(points_.front().p);
  }

 private:
  void drop_cleared(const ClearedGround& ground);

  struct Point {
    Vec2 p;
    bool asked = false;
  };
  std::vector<Point> points_;
  double cell_ = 0;
  bool prepared_ = false;
};

}  // namespace evenload
