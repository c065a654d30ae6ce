// A tree of boxes over numbered items: which items lie near a box, or nearest to a point. Built
// once, then only read.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/curve.h"

namespace evenload {

inline Bounds grown(Bounds box, double by) {
  return {{box.low.x - by, box.low.y - by}, {box.high.x + by, box.high.y + by}};
}
inline Bounds joined(Bounds a, Bounds b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}
inline bool overlap(Bounds a, Bounds b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}
inline double squared_distance(Bounds box, Vec2 q) {
  const double dx = std::max({box.low.x - q.x, q.x - box.high.x, 0.0});
  const double dy = std::max({box.low.y - q.y, q.y - box.high.y, 0.0});
  return dx * dx + dy * dy;
}

class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<Bounds>& boxes);

  // Calls visit(item) for every item whose box overlaps `range`.
  template <typename Visit>
  void visit(Bounds range, Visit&& visit) const {
    if (nodes_.empty()) return;
    std::array<std::uint32_t, kDepth> stack;
    std::size_t height = 0;
    stack[height++] = 0;
    while (height > 0) {
      const Node& node = nodes_[stack[--height]];
      if (!overlap(node.box, range)) continue;
      if (node.count == 0) {
        stack[height++] = node.first;
        stack[height++] = node.first + 1;
        continue;
      }
      for (std::uint32_t k = 0; k < node.count; ++k)
        if (overlap(boxes_[node.first + k], range)) visit(items_[node.first + k]);
    }
  }

  // Lowers `best` (a squared distance) to the least that squared_distance_of(item, q) answers, and
  // sets `item` to its item; leaves both where nothing is below `best`.
  template <typename SquaredDistanceOf>
  void nearest(Vec2 q, double& best, std::size_t& item,
               SquaredDistanceOf&& squared_distance_of) const {
    if (nodes_.empty()) return;
    struct Waiting {
      std::uint32_t node;
      double squared_distance;
    };
    std::array<Waiting, kDepth> stack;
    std::size_t height = 0;
    stack[height++] = {0, squared_distance(nodes_[0].box, q)};
    while (height > 0) {
      const Waiting top = stack[--height];
      if (top.squared_distance >= best) continue;
      const Node& node = nodes_[top.node];
      if (node.count == 0) {
        Waiting near{node.first, squared_distance(nodes_[node.first].box, q)};
        Waiting far{node.first + 1, squared_distance(nodes_[node.first + 1].box, q)};
        if (far.squared_distance < near.squared_distance) std::swap(near, far);
        if (far.squared_distance < best) stack[height++] = far;
        if (near.squared_distance < best) stack[height++] = near;
        continue;
      }
      for (std::uint32_t k = 0; k < node.count; ++k) {
        if (squared_distance(boxes_[node.first + k], q) >= best) continue;
        const double d = squared_distance_of(items_[node.first + k]);
        if (d < best) {
          best = d;
          item = items_[node.first + k];
        }
      }
    }
  }

 private:
  static constexpr std::size_t kDepth =
      128;  // halving: two waiting nodes a level, 2^63 items at most
  static constexpr std::uint32_t kLeaf = 4;
  struct Node {
    Bounds box;
    std::uint32_t first = 0;  // of its items, or its first child; the second child follows
    std::uint32_t count = 0;  // of its items; 0: has children
  };
  std::vector<Node> nodes_;
  std::vector<Bounds> boxes_;  // in the order of items_
  std::vector<std::uint32_t> items_;
};

}  // namespace evenload
