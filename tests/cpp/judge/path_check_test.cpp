// Known answers for the judge of paths.
#include "judge/path_check.h"

#include <gtest/gtest.h>

#include "geometry/shapes.h"
#include "judge/numbers.h"

namespace evenload {
namespace {

using path_check::check_path;
using path_check::Findings;
using path_check::Stock;
using shapes::circle;
using shapes::rectangle;

constexpr double kFloor = -2;

class Path {
 public:
  explicit Path(Vec2 start) {
    to(MoveKind::kRapid, start, 10);
    to(MoveKind::kRapid, start, kFloor);
  }
  Path& to(MoveKind kind, Vec2 p, double z = kFloor) {
    Move move;
    move.kind = kind;
    move.x = p.x;
    move.y = p.y;
    move.z = z;
    move.feed = kind == MoveKind::kRapid ? 0 : 100;
    moves.push_back(move);
    return *this;
  }
  Path& cut(Vec2 p) { return to(MoveKind::kCut, p); }
  Path& link(Vec2 p) { return to(MoveKind::kLink, p); }
  Path& arc(Vec2 centre, double sweep, MoveKind kind = MoveKind::kCut) {
    const Vec2 from{moves.back().x, moves.back().y};
    to(kind, centre + rotated(from - centre, sweep));
    moves.back().sweep = sweep;
    moves.back().cx = centre.x;
    moves.back().cy = centre.y;
    return *this;
  }
  Findings check(Stock stock) const { return check_path(stock, kRadius, moves); }

  std::vector<Move> moves;
};

Stock pocket(const Curve& outer, const std::vector<Curve>& islands = {}) {
  Stock stock;
  stock.regions = {make_region(outer, islands)};
  return stock;
}

Stock wide() { return pocket(rectangle(-50, -50, 50, 50)); }

TEST(PathCheck, SeesAFullSlotAsHalfATurn) {
  Stock stock = wide();
  stock.hole = Vec2{};
  stock.hole_radius = kRadius;
  const Findings found = Path({}).cut({20, 0}).check(stock);
  EXPECT_NEAR(found.cut_engagement, kPi, 0.05 * kDegree);
  EXPECT_NEAR(found.cut_length, 20, 1e-9);
  EXPECT_NEAR(found.removed_area, 20 * 2 * kRadius, 0.1);
  EXPECT_NEAR(found.removal_rate, 2 * kRadius * 100, 1);
}

TEST(PathCheck, SeesASideStepAsItsEngagement) {
  for (const double step : {0.2, 1.0, 1.5, 3.0, 4.5, 5.9}) {
    Path path({-20, 0});
    path.link({20, 0}).link({20, 40}).link({-20, 40}).link({-20, -step}).cut({0, -step});
    const Findings found = path.check(wide());
    EXPECT_NEAR(found.cut_engagement, std::acos(1 - step / kRadius), 0.05 * kDegree) << step;
  }
}

TEST(PathCheck, TellsClimbFromConventional) {
  Path path({-20, 0});
  path.link({20, 0}).link({20, 40}).link({-20, 40}).link({-20, -1}).cut({0, -1});
  const Findings climb = path.check(wide());
  EXPECT_GT(climb.climb_length, 19.9);
  EXPECT_EQ(climb.conventional_length, 0);
  for (Move& move : path.moves) move.y = -move.y;
  const Findings conventional = path.check(wide());
  EXPECT_GT(conventional.conventional_length, 19.9);
  EXPECT_EQ(conventional.climb_length, 0);
}

TEST(PathCheck, SeesTheEngagementOfACircleInAHole) {
  // |P + r u| = hole: material from the outside, on the right, to where the circles cross.
  const double hole = 8, turn = 5.8;
  Stock stock = wide();
  stock.hole = Vec2{};
  stock.hole_radius = hole;
  const double cosine = (hole * hole - turn * turn - kRadius * kRadius) / (2 * turn * kRadius);
  const Findings found = Path({turn, 0}).arc({}, kPi).check(stock);
  EXPECT_NEAR(found.cut_engagement, std::acos(cosine), 0.05 * kDegree);
  EXPECT_LE(found.arc_mismatch, 1e-12);
}

TEST(PathCheck, CountsWhatTheSameArcHasAlreadyCleared) {
  // A full turn tighter than the tool meets its own start.
  Stock stock = wide();
  const Findings found = Path({1, 0}).arc({}, 2 * kPi).arc({}, 2 * kPi).check(stock);
  EXPECT_NEAR(found.removed_area, kPi * 16 - kPi * 9, 0.3);
}

TEST(PathCheck, MeasuresWhatWasLeft) {
  const Stock stock = pocket(rectangle(0, 0, 20, 8));
  const Findings low = Path({3, 3}).cut({17, 3}).check(stock);
  const double corners = (4 - kPi) * kRadius * kRadius;
  const double reachable = 160 - corners, cleared = 14 * 6 + kPi * 9;
  EXPECT_NEAR(low.reachable_area, reachable, 0.01 * reachable);
  EXPECT_NEAR(low.left_area, reachable - cleared, 0.01 * reachable);
  const Findings both = Path({3, 3}).cut({17, 3}).cut({17, 5}).cut({3, 5}).cut({3, 3}).check(stock);
  EXPECT_EQ(both.left_area, 0);
}

TEST(PathCheck, FindsASlotNarrowerThanItsGridReachable) {
  const Stock stock = pocket(rectangle(0, 0, 20.01, 6.05));
  const Findings found = Path({3, 20}).check(stock);
  EXPECT_NEAR(found.left_area, 20 * 6 - 7.7, 1.5);
}

TEST(PathCheck, LeavesHolesAndOpenGroundOutOfTheAccount) {
  Stock stock = pocket(circle({0, 0}, 10));
  stock.hole = Vec2{};
  stock.hole_radius = 6;
  EXPECT_NEAR(Path({0, 0}).check(stock).left_area, kPi * (100 - 36), 2);
  std::vector<Vertex> v = rectangle(0, 0, 20, 20).vertices();
  for (Vertex& x : v) x.open = true;
  const Stock boss = pocket(Curve(v, true));
  const Findings outside = Path({-5, -5}).cut({25, -5}).cut({25, 25}).check(boss);
  EXPECT_EQ(outside.cut_engagement, 0);
  EXPECT_EQ(outside.gouge, 0);
  EXPECT_NEAR(outside.left_area, 400, 6);
  const Findings through = Path({-5, 10}).cut({25, 10}).check(boss);
  EXPECT_NEAR(through.cut_engagement, kPi, 0.05 * kDegree);
  EXPECT_EQ(through.bad_plunges, 0);
}

TEST(PathCheck, MeasuresHowDeepTheToolIsInAWall) {
  const Stock stock = pocket(rectangle(0, 0, 40, 40), {circle({20, 20}, 5)});
  EXPECT_EQ(Path({3, 3}).cut({37, 3}).check(stock).gouge, 0);
  EXPECT_NEAR(Path({3, 3}).cut({37, 2.9}).check(stock).gouge, 0.1, 1e-6);
  EXPECT_NEAR(Path({3, 3}).cut({3, -1}).check(stock).gouge, 4, 1e-6);
  EXPECT_NEAR(Path({12.1, 20}).arc({20, 20}, -kPi).check(stock).gouge, 0.1, 2e-5);
  EXPECT_NEAR(Path({10, 20}).cut({15.3, 20}).check(stock).gouge, 3 + 0.3, 1e-4);
  // Entries and links as well.
  EXPECT_NEAR(Path({3, 3}).to(MoveKind::kEntry, {2.8, 3}, -1).check(stock).gouge, 0.2, 1e-6);
  EXPECT_NEAR(Path({3, 3}).link({2.8, 3}).check(stock).gouge, 0.2, 1e-6);
  // But not above the stock.
  EXPECT_EQ(Path({3, 3})
                .to(MoveKind::kRapid, {3, 3}, 5)
                .to(MoveKind::kRapid, {-3, 3}, 5)
                .check(stock)
                .gouge,
            0);
}

TEST(PathCheck, JudgesLinksApartFromCuts) {
  Stock stock = wide();
  stock.hole = Vec2{};
  stock.hole_radius = 10;
  const Findings clean = Path({}).link({7, 0}).link({0, 7}).cut({0, 8}).check(stock);
  EXPECT_EQ(clean.link_engagement, 0);
  EXPECT_GT(clean.cut_engagement, 30 * kDegree);
  const Findings dirty = Path({}).link({8, 0}).check(stock);
  EXPECT_GT(dirty.link_engagement, 30 * kDegree);
  EXPECT_EQ(dirty.cut_engagement, 0);
}

TEST(PathCheck, FindsPlungesAndRapidsIntoMaterial) {
  Stock stock = wide();
  EXPECT_EQ(Path({}).check(stock).bad_plunges, 1);
  stock.hole = Vec2{};
  stock.hole_radius = kRadius;
  EXPECT_EQ(Path({}).check(stock).bad_plunges, 0);
  EXPECT_EQ(Path({0.5, 0}).check(stock).bad_plunges, 1);
  EXPECT_GT(Path({}).to(MoveKind::kRapid, {5, 0}).check(stock).bad_plunges, 0);
}

TEST(PathCheck, TakesSlopingEntriesForClearingNothing) {
  Stock stock = wide();
  Path path({0, 0});
  path.moves.pop_back();
  path.to(MoveKind::kEntry, {10, 0}, kFloor);
  EXPECT_EQ(path.check(stock).left_share, 1);
  path.to(MoveKind::kEntry, {0, 0}, kFloor);
  EXPECT_LT(path.check(stock).left_share, 1);
  EXPECT_EQ(path.check(stock).cut_engagement, 0);
}

TEST(PathCheck, FindsArcsWhoseEndsDisagree) {
  Path path({5, 0});
  path.arc({}, kPi / 2);
  EXPECT_LE(path.check(wide()).arc_mismatch, 1e-12);
  path.moves.back().y += 0.01;
  EXPECT_NEAR(path.check(wide()).arc_mismatch, 0.01, 1e-9);
}

TEST(PathCheck, CountsKinksInMaterialOnly) {
  Stock stock = wide();
  const Findings corner = Path({}).cut({10, 0}).cut({10, 10}).check(stock);
  EXPECT_EQ(corner.kinks, 1);
  EXPECT_NEAR(corner.worst_kink, kPi / 2, 1e-9);
  const Findings smooth = Path({}).cut({10, 0}).arc({10, 5}, kPi / 2).cut({15, 10}).check(stock);
  EXPECT_EQ(smooth.kinks, 0);
  stock.hole = Vec2{};
  stock.hole_radius = 20;
  EXPECT_EQ(Path({}).cut({10, 0}).cut({10, 10}).check(stock).kinks, 0);
}

TEST(PathCheck, ReadsTheLowestLevelOnly) {
  Stock stock = wide();
  stock.hole = Vec2{};
  stock.hole_radius = kRadius;
  Path path({});
  path.moves.back().z = -1;
  path.to(MoveKind::kCut, {10, 0}, -1).to(MoveKind::kRapid, {10, 0}, 5);
  path.to(MoveKind::kRapid, {0, 0}, 5).to(MoveKind::kRapid, {0, 0}, kFloor).cut({5, 0});
  const Findings found = path.check(stock);
  EXPECT_NEAR(found.cut_length, 5, 1e-9);
  EXPECT_EQ(found.bad_plunges, 0);
}

}  // namespace
}  // namespace evenload
