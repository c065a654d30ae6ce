// Dexels: rows, swept discs and stock against what they must hold at every point.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "simulate/dexel_stock.h"
#include "simulate/paths.h"

namespace evenload {
namespace {

using namespace simulate_paths;  // NOLINT: the helpers of these tests

using Piece = DexelRow::Piece;

void expect_well_formed(const DexelRow& row) {
  const std::vector<Piece>& pieces = row.pieces();
  if (pieces.empty()) return;
  EXPECT_NE(pieces.front().top, kNoMaterial);
  EXPECT_EQ(pieces.back().top, kNoMaterial);
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    EXPECT_LT(pieces[i].x, pieces[i + 1].x);
    EXPECT_NE(pieces[i].top, pieces[i + 1].top);
  }
}

TEST(DexelRow, HoldsTheLowestOfAllCutsAtEveryPoint) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1, 11), depth(-4, 1);
  for (int round = 0; round < 200; ++round) {
    DexelRow row;
    row.raise(0, 4, 0);
    row.raise(3, 10, 0.5);
    std::vector<double> points;
    for (int i = 0; i < 300; ++i) points.push_back(place(random));
    std::vector<double> heights;
    for (const double x : points)
      heights.push_back(x < 0 || x >= 10 ? kNoMaterial : x < 3 ? 0 : 0.5);
    RowRemoval removal;
    std::vector<Piece> scratch;
    for (int cut = 0; cut < 30; ++cut) {
      double low = place(random), high = place(random);
      if (low > high) std::swap(low, high);
      const double z = depth(random);
      row.cut(low, high, z, -3, {0, 0.1}, removal, scratch);
      expect_well_formed(row);
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i] < low || points[i] >= high) continue;
        if (heights[i] > z) heights[i] = z > -3 ? z : kNoMaterial;
      }
    }
    double left = 0;
    for (std::size_t i = 0; i + 1 < row.pieces().size(); ++i)
      if (row.pieces()[i].top != kNoMaterial)
        left += (row.pieces()[i + 1].x - row.pieces()[i].x) * (row.pieces()[i].top + 3);
    EXPECT_NEAR(removal.area + left, 3 * 3 + 7 * 3.5, 1e-6);
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_EQ(row.top_at(points[i]), heights[i]) << "at " << points[i];
  }
}

TEST(DexelRow, IsCutTwiceAsIfCutOnce) {
  DexelRow row;
  row.raise(0, 10, 0);
  RowRemoval first, second;
  std::vector<Piece> scratch;
  row.cut(2, 5, -1, -3, {0, 0.1}, first, scratch);
  row.cut(2, 5, -1, -3, {0, 0.1}, second, scratch);
  EXPECT_NEAR(first.area, 3, 1e-12);
  EXPECT_NEAR(first.node_height, 30, 1e-9);
  EXPECT_EQ(second.area, 0);
}

TEST(DexelRow, IsEmptyWhenAllIsCut) {
  DexelRow row;
  row.raise(0, 10, 0);
  RowRemoval removal;
  std::vector<Piece> scratch;
  row.cut(4, 6, -5, -3, {0, 0.1}, removal, scratch);
  row.cut(-1, 4, -3, -3, {0, 0.1}, removal, scratch);
  row.cut(6, 12, -3, -3, {0, 0.1}, removal, scratch);
  EXPECT_TRUE(row.empty());
  EXPECT_NEAR(removal.through, 10, 1e-12);
}

bool on_intervals(const SweptDisc& swept, Vec2 p) {
  SweptDisc::Interval intervals[SweptDisc::kMostIntervals];
  const int count = swept.on_row(p.y, intervals);
  for (int i = 0; i < count; ++i)
    if (p.x >= intervals[i].low && p.x <= intervals[i].high) return true;
  return false;
}

TEST(SweptDisc, HoldsExactlyThePointsWithinTheRadiusOfThePath) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit_share(0, 1), place(-12, 12);
  for (int round = 0; round < 400; ++round) {
    const double radius = 0.2 + 4 * unit_share(random);
    const Segment path =
        round % 2 == 0
            ? Segment::line({place(random) / 2, place(random) / 2},
                            {place(random) / 2, round % 8 == 0 ? 0.0 : place(random) / 2})
            : Segment::arc({place(random) / 4, place(random) / 4}, 0.1 + 6 * unit_share(random),
                           10 * unit_share(random),
                           (round % 4 == 1 ? 1 : -1) * (0.05 + 3 * unit_share(random)));
    const SweptDisc rows(path, radius), columns(mirrored(path), radius);
    for (int i = 0; i < 300; ++i) {
      const Vec2 p{place(random), place(random)};
      const double distance = path.distance_to(p);
      if (std::abs(distance - radius) < 1e-6) continue;
      EXPECT_EQ(on_intervals(rows, p), distance < radius) << round;
      EXPECT_EQ(on_intervals(columns, {p.y, p.x}), distance < radius) << round;
    }
  }
}

TEST(DexelStock, HasTheAreaOfItsRegion) {
  const Region rect = rectangle(0.0123, -0.0077, 60.031, 41.017);
  EXPECT_NEAR(DexelStock({{rect, 0}}, -3, 0.05).area(), rect.area(), 0.0026);
  const Region ring = make_region(circle(20).outer, {circle(7.3, {2, 1}).outer});
  EXPECT_NEAR(DexelStock({{ring, 0}}, -3, 0.05).area(), ring.area(), 1e-4 * ring.area());
  EXPECT_NEAR(DexelStock({{ring, 0}}, -3, 0.05).volume(), 3 * ring.area(), 3e-4 * ring.area());
}

TEST(DexelStock, LosesTheSweptVolumeAndNoMoreWhenCutAgain) {
  DexelStock stock({{rectangle(-30, -30, 30, 30), 0}}, -3, 0.05);
  const Segment path = Segment::arc({}, 12, 0.3, 5);
  const double before = stock.volume();
  const Removal first = stock.cut(path, 3, -2);
  const double swept = 5 * 12 * 6 + kPi * 9;
  EXPECT_NEAR(first.volume, 2 * swept, 5e-4 * 2 * swept);
  EXPECT_NEAR(before - stock.volume(), first.volume, 1e-6 * before);
  EXPECT_EQ(first.area, 0);
  const Removal again = stock.cut(path, 3, -2);
  EXPECT_LT(again.volume, 1e-6);
  const Removal through = stock.cut(path, 3, -3);
  EXPECT_NEAR(through.area, swept, 5e-4 * swept);
  EXPECT_NEAR(stock.height_at({0, 0}), 0, 0);
}

TEST(DexelStock, TellsWhatItLacksOfAPart) {
  const Region ell = make_region(
      Curve({{{0, 0}}, {{30, 0}}, {{30, 10}}, {{10, 10}}, {{10, 20}}, {{0, 20}}}, true));
  const DexelStock stock({{ell, 0}}, -3, 0.05);
  EXPECT_NEAR(stock.area_lacking({{ell, 0}}), 0, 1e-9);
  EXPECT_NEAR(stock.area_lacking({{rectangle(1, 1, 9, 19), -1}}), 0, 1e-9);
  EXPECT_NEAR(stock.area_lacking({{rectangle(20, 12, 28, 18), 0}}), 48, 0.01);
  EXPECT_NEAR(stock.area_lacking({{rectangle(0, 0, 20, 20), 0}}), 100, 0.01);
  EXPECT_NEAR(stock.area_lacking({{rectangle(0, 0, 10, 10), 1}}), 100, 0.01);
}

TEST(DexelStock, RefusesWhatCannotBe) {
  const Region square = rectangle(0, 0, 10, 10);
  EXPECT_THROW(DexelStock({}, -3, 0.05), std::invalid_argument);
  EXPECT_THROW(DexelStock({{square, 0}}, -3, 0), std::invalid_argument);
  EXPECT_THROW(DexelStock({{square, 0}}, 0, 0.05), std::invalid_argument);
  EXPECT_THROW(DexelStock({{square, std::nan("")}}, -3, 0.05), std::invalid_argument);
  EXPECT_THROW(DexelStock({{square, 0}}, -3, 1e-9), std::invalid_argument);
  EXPECT_THROW(DexelStock({{square, 0}}, -3, 10.1), std::invalid_argument);
}

}  // namespace
}  // namespace evenload
