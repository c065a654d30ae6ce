#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "corpus.h"
#include "geometry_shapes.h"
#include "path_check.h"
#include "strategy/constant_engagement.h"
#include "strategy/tight_turns.h"
#include "toolpath/small_arc.h"

namespace evenload {
namespace {

using shapes::rectangle;

constexpr double kToolRadius = 3;
constexpr double kTheta = kPi / 3;

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

const Region& room() {
  static const Region all = make_region(rectangle(-50, -50, 50, 50));
  return all;
}

ClearedGround cleared_ground() {
  ClearedGround ground({{-60, -60}, {60, 60}}, kToolRadius, nullptr);
  ground.add_disc({0, 0}, 60);
  return ground;
}

// A line, a turn of `radius` by `sweep`, a line.
std::vector<Segment> turn(double heading, double radius, double sweep) {
  const Vec2 start = -2.0 * unit(heading);
  const Segment first = Segment::line(start, {0, 0});
  const double side = sweep > 0 ? 1 : -1;
  const Segment arc = Segment::arc(side * radius * left_normal(unit(heading)), radius,
                                   heading - side * kPi / 2, sweep);
  return {first, arc, Segment::line(arc.b, arc.b + 2.0 * arc.tangent(1))};
}

std::vector<Segment> widened(const std::vector<Segment>& moves, ClearedGround& ground,
                             double widening = 0.004) {
  return without_tight_turns(moves, Area({room()}), ground, kTheta, widening);
}

bool has_corners(const std::vector<Segment>& moves) {
  return std::any_of(moves.begin(), moves.end(), [](const Segment& move) {
    return move.is_arc() && becomes_corners(move.radius, move.sweep);
  });
}

TEST(TightTurns, BecomeTangentArcsThatStayArcs) {
  std::mt19937 random(11);
  ClearedGround ground = cleared_ground();
  for (int round = 0; round < 300; ++round) {
    const double sweep = uniform(random, 0.05, 0.7) * (round % 2 ? 1 : -1);
    const std::vector<Segment> moves =
        turn(uniform(random, -kPi, kPi), uniform(random, 0.06, 0.07), sweep);
    ASSERT_TRUE(has_corners(moves));
    const std::vector<Segment> wide = widened(moves, ground);
    ASSERT_EQ(wide.size(), 3u);
    EXPECT_FALSE(has_corners(wide)) << wide[1].radius << ", " << wide[1].sweep;
    EXPECT_LE(distance(wide.front().a, moves.front().a), 1e-12);
    EXPECT_LE(distance(wide.back().b, moves.back().b), 1e-12);
    for (std::size_t i = 1; i < wide.size(); ++i) {
      EXPECT_LE(distance(wide[i - 1].b, wide[i].a), 1e-9);
      EXPECT_LE(norm(wide[i - 1].tangent(1) - wide[i].tangent(0)), 1e-5);
    }
    // The tightest that will do: a little less would become corners.
    EXPECT_LE(wide[1].radius * wide[1].radius * std::sin(std::abs(sweep)), 2 * kLeastSpan);
  }
}

TEST(TightTurns, StayWhereAWiderArcWouldLeaveThemTooFar) {
  ClearedGround ground = cleared_ground();
  const std::vector<Segment> moves = turn(0.3, 0.02, 1.4);
  const std::vector<Segment> same = widened(moves, ground);
  ASSERT_EQ(same.size(), moves.size());
  EXPECT_EQ(same[1].radius, moves[1].radius);
  EXPECT_FALSE(has_corners(widened(moves, ground, 0.05)));
}

TEST(TightTurns, StayWhereAWiderArcWouldMeetMoreThanTheLimit) {
  ClearedGround untouched({{-60, -60}, {60, 60}}, kToolRadius, nullptr);
  const std::vector<Segment> moves = turn(0, 0.065, 0.5);
  EXPECT_EQ(widened(moves, untouched)[1].radius, moves[1].radius);
  EXPECT_EQ(untouched.size(), 0u);
  ClearedGround cleared = cleared_ground();
  EXPECT_GT(widened(moves, cleared)[1].radius, moves[1].radius);
}

TEST(TightTurns, LeaveLessWhereTheEngagementIsSmall) {
  EXPECT_EQ(most_widening(2 * kTheta, kToolRadius, 0.005), 0.004);
  EXPECT_EQ(most_widening(2 * kTheta, kToolRadius, 0.001), 0.001);
  for (const double theta : {0.1, 0.2, 0.4}) {
    // The tool meets what is left, of this thickness at the most, on an arc this long.
    const double met = std::acos(1 - most_widening(theta, kToolRadius, 0.005) / kToolRadius);
    EXPECT_NEAR(met, 0.04 * theta, 1e-3 * theta);
  }
}

TEST(TightTurns, OfTheBorderItselfStay) {
  // Its corner is an arc of 0.065 mm.
  const Curve corner({{{-10, -10}, 0},
                      {{10, -10}, 0},
                      {{10, 9.935}, std::tan(kPi / 8)},
                      {{9.935, 10}, 0},
                      {{-10, 10}, 0}},
                     true);
  const Area place({make_region(corner)});
  ClearedGround ground = cleared_ground();
  const std::vector<Segment> moves{corner.segment(1), corner.segment(2), corner.segment(3)};
  ASSERT_TRUE(has_corners(moves));
  EXPECT_TRUE(has_corners(without_tight_turns(moves, place, ground, kTheta, 0.05)));
}

TEST(TightTurns, AreNotInTheCornersOfAStage) {
  const Region exact = make_region(rectangle(-10, -10, 10, 10));
  const std::vector<Region> tight = offset(offset({exact}, -0.05), 0.05);
  ASSERT_TRUE(has_corners(tight.front().outer.segments()));
  const std::vector<Region> wide = without_tight_corners(tight, Area({exact}));
  EXPECT_FALSE(has_corners(wide.front().outer.segments()));
  EXPECT_EQ(wide.front().outer.segment_count(), 9u);  // the longest piece is two
  const Area before(tight);
  for (const Segment& piece : wide.front().outer.segments())
    for (const double t : {0.0, 0.3, 0.7}) EXPECT_GE(before.signed_distance(piece.point(t)), -1e-6);
  // 0.0735 mm is the least radius of a quarter turn.
  EXPECT_NEAR(wide.front().area(), exact.area() - 0.0735 * 0.0735 * (4 - kPi), 1e-3);
}

// As commands.py writes it: ends on its grid, lines in place of arcs that become corners.
std::vector<Move> posted(const std::vector<Move>& moves) {
  constexpr double kGrid = 1e-4;
  const auto rounded = [](double value) { return std::round(value / kGrid) * kGrid; };
  std::vector<Move> result;
  Vec2 at;
  for (Move move : moves) {
    const Vec2 end{move.x, move.y}, centre{move.cx, move.cy};
    const double radius = distance(end, centre);
    const int lines = move.sweep != 0 && becomes_corners(radius, move.sweep)
                          ? static_cast<int>(std::ceil(std::abs(move.sweep) /
                                                       (2 * std::acos(1 - 0.004 / radius))))
                          : 0;
    for (int i = 1; i < lines; ++i) {
      Move line = move;
      const double angle = angle_of(end - centre) - move.sweep * (lines - i) / lines;
      line.x = rounded(centre.x + radius * std::cos(angle));
      line.y = rounded(centre.y + radius * std::sin(angle));
      line.sweep = 0;
      result.push_back(line);
      at = {line.x, line.y};
    }
    move.x = rounded(end.x);
    move.y = rounded(end.y);
    const Vec2 chord = Vec2{move.x, move.y} - at;
    if (lines > 0 || norm(chord) < 0.005) move.sweep = 0;
    if (move.sweep != 0) {
      const Vec2 middle = at + 0.5 * chord + 0.5 / std::tan(0.5 * move.sweep) * left_normal(chord);
      move.cx = middle.x;
      move.cy = middle.y;
    }
    result.push_back(move);
    at = {move.x, move.y};
  }
  return result;
}

// Corners of the tool's place that the exact border runs into: those of the walls that are concave.
int sharp_corners(const Region& region) {
  int count = 0;
  for (const Curve& curve : region.curves())
    for (std::size_t i = 0; i < curve.segment_count(); ++i) {
      const Vec2 before = curve.segment((i + curve.segment_count() - 1) % curve.segment_count())
                              .tangent(1),
                 after = curve.segment(i).tangent(0);
      if (std::atan2(cross(before, after), dot(before, after)) > 0.02) ++count;
    }
  return count;
}

class APostedPocket : public testing::TestWithParam<std::string> {};

TEST_P(APostedPocket, TurnsByMoreThanADegreeAtSharpCornersOnly) {
  const corpus::Case pocket = corpus::load(GetParam());
  Progress progress;
  const Toolpath path = clear_pocket({pocket.region}, pocket.params(), progress);
  path_check::Stock stock;
  stock.regions = {pocket.region};
  if (pocket.hole) {
    stock.hole = pocket.hole->centre;
    stock.hole_radius = 0.5 * pocket.hole->diameter;
  }
  const path_check::Findings found =
      check_path(stock, 0.5 * pocket.tool_diameter, posted(path.moves));
  EXPECT_LE(found.kinks, sharp_corners(pocket.region))
      << "the worst by " << found.worst_kink * 180 / kPi << " degrees at " << found.worst_kink_at.x
      << ", " << found.worst_kink_at.y;
}

INSTANTIATE_TEST_SUITE_P(Corpus, APostedPocket,
                         testing::Values("comb", "corridor_beside_island", "far_away", "inch_slot",
                                         "lame_hex50", "large_engagement", "lshape",
                                         "neck_too_narrow", "ring", "slot875", "slot9", "square60",
                                         "star", "two_rooms", "two_rooms_closed"),
                         [](const auto& pocket) { return pocket.param; });

}  // namespace
}  // namespace evenload
