#include "geometry/point_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "geometry/box_tree.h"

namespace evenload {
namespace {

// Whole numbers, so that many points are equally far from a place.
std::vector<Vec2> scattered(std::mt19937& random, int count, unsigned width, unsigned height) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i)
    points.push_back(
        {static_cast<double>(random() % width), static_cast<double>(random() % height)});
  return points;
}

PointGrid grid_of(const std::vector<Vec2>& points, const Bounds& bounds, double cell) {
  PointGrid grid(bounds, cell);
  for (std::size_t i = 0; i < points.size(); ++i) grid.add(i, points[i]);
  return grid;
}

TEST(PointGrid, FindsTheNearestOfThePointsThatAreLeftAndOfSeveralTheFirst) {
  std::mt19937 random(3);
  for (const auto& [width, height] : {std::pair{40u, 40u}, {300u, 1u}, {9u, 200u}}) {
    SCOPED_TRACE(width);
    const std::vector<Vec2> points = scattered(random, 200, width, height);
    const Bounds bounds{{0, 0}, {width - 1.0, height - 1.0}};
    PointGrid grid = grid_of(points, bounds, 2.5);
    std::set<std::size_t> left;
    for (std::size_t i = 0; i < points.size(); ++i) left.insert(i);
    while (!left.empty()) {
      // Beside the grid as well.
      const Vec2 q{static_cast<double>(random() % (2 * width)) - 0.5 * width,
                   static_cast<double>(random() % (2 * height)) - 0.5 * height};
      const auto expected = std::min_element(left.begin(), left.end(), [&](auto a, auto b) {
        return squared_norm(points[a] - q) < squared_norm(points[b] - q);
      });
      ASSERT_EQ(grid.nearest(q), *expected);
      const std::size_t item = *expected;
      grid.drop_if({points[item], points[item]}, [item](std::size_t i) { return i == item; });
      left.erase(expected);
      ASSERT_EQ(grid.size(), left.size());
    }
    EXPECT_EQ(grid.nearest({0, 0}), std::nullopt);
  }
}

TEST(PointGrid, VisitsEveryPointInABoxOnceAndFewOthers) {
  std::mt19937 random(5);
  const std::vector<Vec2> points = scattered(random, 2000, 100, 100);
  const double cell = 4;
  const PointGrid grid = grid_of(points, {{0, 0}, {99, 99}}, cell);
  for (int round = 0; round < 50; ++round) {
    const Vec2 low = scattered(random, 1, 110, 110).front() - Vec2{10, 10};
    const Bounds range{low, low + scattered(random, 1, 30, 30).front()};
    std::multiset<std::size_t> visited;
    grid.visit(range, [&](std::size_t i) { visited.insert(i); });
    // A range beside the grid meets the cells along its border.
    const bool within =
        range.low.x >= 0 && range.low.y >= 0 && range.high.x <= 99 && range.high.y <= 99;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Bounds at{points[i], points[i]};
      if (overlap(range, at)) {
        ASSERT_EQ(visited.count(i), 1);
      } else if (within && !overlap(grown(range, cell), at)) {
        ASSERT_EQ(visited.count(i), 0);
      }
    }
  }
}

TEST(PointGrid, HoldsPointsOfSparseWorkInFewCells) {
  // 10 m x 10 m in cells of 1 mm would be 10^8.
  const Bounds bounds{{0, 0}, {1e4, 1e4}};
  PointGrid grid(bounds, 1);
  grid.add(7, {0, 0});
  grid.add(8, {1e4, 1e4});
  EXPECT_EQ(grid.nearest({9e3, 9e3}), 8u);
  int visited = 0;
  grid.visit({{0, 0}, {30, 30}}, [&](std::size_t) { ++visited; });
  EXPECT_EQ(visited, 1);
}

TEST(PointGrid, RefusesCellsWithoutWidth) {
  EXPECT_THROW(PointGrid({{0, 0}, {1, 1}}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace evenload
