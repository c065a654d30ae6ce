#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry_shapes.h"
#include "strategy/short_moves.h"
#include "toolpath/small_arc.h"

namespace evenload {
namespace {

using shapes::rectangle;

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

Area room() { return Area({make_region(rectangle(-50, -50, 50, 50))}); }

// The move that goes on from `p` and `heading`, which become those of its end.
Segment next_move(Vec2* p, double* heading, double curvature, double length) {
  const Segment move =
      curvature == 0
          ? Segment::line(*p, *p + length * unit(*heading))
          : Segment::arc(*p + left_normal(unit(*heading)) / curvature, 1 / std::abs(curvature),
                         *heading - (curvature > 0 ? kPi / 2 : -kPi / 2), curvature * length);
  *p = move.b;
  *heading += curvature * length;
  return move;
}

// Tangent moves, of which every third is tiny and bends nearly as the one before it.
std::vector<Segment> with_remainders(std::mt19937& random) {
  Vec2 p{0, 0};
  double heading = uniform(random, -kPi, kPi);
  double curvature = 0;
  std::vector<Segment> moves;
  for (int i = 0; i < 12; ++i) {
    const bool is_tiny = i % 3 == 1;
    const double length = is_tiny ? uniform(random, 0.005, 0.09) : uniform(random, 0.5, 2);
    curvature = is_tiny ? curvature + uniform(random, -0.1, 0.1) : uniform(random, -0.4, 0.4);
    moves.push_back(next_move(&p, &heading, curvature, length));
  }
  return moves;
}

std::size_t short_ones(const std::vector<Segment>& moves) {
  std::size_t count = 0;
  for (const Segment& move : moves) count += move.length() < kShortest;
  return count;
}

double distance_from(Vec2 p, const std::vector<Segment>& moves) {
  double nearest = 1e9;
  for (const Segment& move : moves) nearest = std::min(nearest, move.distance_to(p));
  return nearest;
}

// Along the wall, off it by `turn` rad and back, and along it again.
std::vector<Segment> off_and_back(double turn) {
  Vec2 p{-10, -50};
  double heading = 0;
  std::vector<Segment> moves{next_move(&p, &heading, 0, 10)};
  for (const double curvature : {1.0, -1.0, -1.0, 1.0})
    moves.push_back(next_move(&p, &heading, curvature, turn));
  moves.push_back(next_move(&p, &heading, 0, 10));
  return moves;
}

TEST(ShortMoves, LeaveOutTinyWaysOffAWallAndBack) {
  const std::vector<Segment> straight = without_short_moves(off_and_back(0.001), room());
  // There and back is aside by the square of the turn, which no post tells from the wall.
  ASSERT_EQ(straight.size(), 1u);
  EXPECT_EQ(straight[0].a, off_and_back(0.001).front().a);
  EXPECT_EQ(straight[0].b, off_and_back(0.001).back().b);
  EXPECT_GT(without_short_moves(off_and_back(0.02), room()).size(), 1u);
}

TEST(ShortMoves, LeaveOutTinyWaysOffARoundWallAndBack) {
  const Area round({make_region(shapes::circle({0, 0}, 20))});
  const auto on = [](double from, double sweep) { return Segment::arc({0, 0}, 20, from, sweep); };
  const Segment a = on(0, 0.5), b = on(0.5001, 0.5);
  const Vec2 middle = 0.5 * (a.b + b.a) + 1e-6 * normalized(-1.0 * a.b);
  const std::vector<Segment> made =
      without_short_moves({a, Segment::line(a.b, middle), Segment::line(middle, b.a), b}, round);
  ASSERT_EQ(made.size(), 1u);
  EXPECT_NEAR(made[0].sweep, 1.0001, 1e-9);
}

TEST(ShortMoves, AreTakenUpByTheirNeighboursWithoutCorners) {
  std::mt19937 random(7);
  std::size_t before = 0, after = 0;
  for (int round = 0; round < 200; ++round) {
    const std::vector<Segment> moves = with_remainders(random);
    const std::vector<Segment> smooth = without_short_moves(moves, room());
    before += short_ones(moves);
    after += short_ones(smooth);
    ASSERT_LE(smooth.size(), moves.size());
    EXPECT_LE(distance(smooth.front().a, moves.front().a), 1e-9);
    EXPECT_LE(distance(smooth.back().b, moves.back().b), 1e-9);
    for (std::size_t i = 1; i < smooth.size(); ++i) {
      EXPECT_LE(distance(smooth[i - 1].b, smooth[i].a), 1e-9);
      EXPECT_LE(norm(smooth[i - 1].tangent(1) - smooth[i].tangent(0)), 5e-3);
    }
    for (const Segment& move : smooth)
      for (int k = 0; k <= 20; ++k)
        EXPECT_LE(distance_from(move.point(k / 20.0), moves), 1.05 * kSmoothing);
  }
  EXPECT_LT(after, before / 5);
}

TEST(ShortMoves, OfTheSameCircleBecomeOneArcWithIt) {
  Vec2 p{0, 0};
  double heading = 0.3;
  const std::vector<Segment> moves{next_move(&p, &heading, 0.5, 1.5),
                                   next_move(&p, &heading, 0.5, 0.04)};
  const std::vector<Segment> smooth = without_short_moves(moves, room());
  ASSERT_EQ(smooth.size(), 1U);
  EXPECT_NEAR(smooth[0].length(), 1.54, 1e-9);
  EXPECT_NEAR(smooth[0].radius, 2, 1e-9);
}

TEST(ShortMoves, OfMicrometresAreTakenUpByShortMovesToo) {
  Vec2 p{0, 0};
  double heading = 0.3;
  const std::vector<Segment> moves{
      next_move(&p, &heading, 0, 2), next_move(&p, &heading, -0.15, 0.15),
      next_move(&p, &heading, 6, 0.0028), next_move(&p, &heading, 0, 2)};
  const std::vector<Segment> smooth = without_short_moves(moves, room());
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    EXPECT_GE(smooth[i].length(), 0.05);
    if (i > 0) {
      EXPECT_LE(norm(smooth[i - 1].tangent(1) - smooth[i].tangent(0)), 5e-3);
    }
    for (int k = 0; k <= 20; ++k)
      EXPECT_LE(distance_from(smooth[i].point(k / 20.0), moves), 1.05 * kSmoothing);
  }
}

TEST(ShortMoves, StayWhereTheyMakeACornerOrATightTurn) {
  Vec2 p{0, 0};
  double heading = 0;
  std::vector<Segment> corner{next_move(&p, &heading, 0, 1)};
  heading = 1;
  corner.push_back(next_move(&p, &heading, 0, 0.05));
  EXPECT_EQ(without_short_moves(corner, room()).size(), 2U);
  p = {0, 0};
  heading = 0;
  const std::vector<Segment> turn{next_move(&p, &heading, 0, 1), next_move(&p, &heading, 20, 0.05),
                                  next_move(&p, &heading, 0, 1)};
  const std::vector<Segment> same = without_short_moves(turn, room());
  ASSERT_EQ(same.size(), 3U);
  EXPECT_EQ(same[1].length(), turn[1].length());
}

TEST(ShortMoves, AlongAWallAndBesideItNeverLeaveIt) {
  // Along the lower wall, then off it by a left turn that begins with a tiny move.
  const Area centres({make_region(rectangle(-50, 0, 50, 50))});
  Vec2 p{0, 0};
  double heading = 0;
  const std::vector<Segment> moves{next_move(&p, &heading, 0, 1), next_move(&p, &heading, 0, 0.05),
                                   next_move(&p, &heading, 0.2, 0.05),
                                   next_move(&p, &heading, 0.3, 1)};
  const std::vector<Segment> smooth = without_short_moves(moves, centres);
  EXPECT_EQ(smooth[0].b, moves[0].b);
  EXPECT_EQ(smooth[1].b, moves[1].b);
  for (const Segment& move : smooth)
    for (int k = 0; k <= 20; ++k) EXPECT_GE(centres.signed_distance(move.point(k / 20.0)), -1e-6);
}

// A wall that turns left by arcs of these curvatures, 1/mm, and lengths, mm, and the way along it.
TEST(ShortMoves, OfAWallThatPostsWouldWriteAsLinesAreTakenUpByTheWallBesideThem) {
  using Pieces = std::vector<std::pair<double, double>>;
  for (const Pieces& pieces :
       {Pieces{{1 / 0.38, 0.0374}, {1 / 0.1495, 0.0079}, {1 / 0.15, 0.0632}},
        Pieces{{1 / 0.35, 0.0459}, {1 / 0.307, 0.0162}, {1 / 0.152, 0.114}}}) {
    Vec2 p{0, 0};
    double heading = 0;
    std::vector<Segment> way{next_move(&p, &heading, 0, 1)};
    for (const auto& [curvature, length] : pieces)
      way.push_back(next_move(&p, &heading, curvature, length));
    way.push_back(next_move(&p, &heading, 0, 1));
    std::vector<Vertex> outline;
    for (const Segment& s : way) outline.push_back({s.a, s.bulge(), false});
    outline.push_back({p, 0, false});
    outline.push_back({{-3, 3}, 0, false});
    outline.push_back({{-3, 0}, 0, false});
    const Area centres({make_region(Curve(outline, true))});
    ASSERT_TRUE(is_tight(way[2]));
    const std::vector<Segment> smooth = without_short_moves(way, centres);
    EXPECT_EQ(smooth.back().b, way.back().b);
    for (std::size_t i = 0; i < smooth.size(); ++i) {
      EXPECT_FALSE(is_tight(smooth[i]));
      if (i > 0) {
        EXPECT_LE(norm(smooth[i - 1].tangent(1) - smooth[i].tangent(0)), 5e-3);
      }
      for (int k = 0; k <= 20; ++k) {
        EXPECT_LE(distance_from(smooth[i].point(k / 20.0), way), 5.1e-5);
        EXPECT_GE(centres.signed_distance(smooth[i].point(k / 20.0)), -5.1e-5);
      }
    }
  }
}

// Walls of many tiny arcs, as offsets have them where a drawing has short lines: there is an end to
// what gives way to what.
TEST(ShortMoves, OfWallsOfTinyArcsComeToAnEnd) {
  std::mt19937 random(21);
  int fewer_tight = 0;
  for (int round = 0; round < 300; ++round) {
    Vec2 p{0, 0};
    double heading = 0;
    std::vector<Segment> way{next_move(&p, &heading, 0, 1)};
    while (heading < 0.6 * kPi) {
      const double radius = uniform(random, 0.02, 0.4);
      way.push_back(next_move(&p, &heading, 1 / radius, uniform(random, 0.05, 0.4) * radius));
    }
    way.push_back(next_move(&p, &heading, 0, 1));
    std::vector<Vertex> outline;
    for (const Segment& s : way) outline.push_back({s.a, s.bulge(), false});
    outline.push_back({p, 0, false});
    outline.push_back({{-20, p.y + 20}, 0, false});
    outline.push_back({{-20, 0}, 0, false});
    const Area centres({make_region(Curve(outline, true))});
    const std::vector<Segment> smooth = without_short_moves(way, centres);
    EXPECT_EQ(smooth.back().b, way.back().b);
    const auto tight = [](const std::vector<Segment>& moves) {
      return std::count_if(moves.begin(), moves.end(), is_tight);
    };
    EXPECT_LE(tight(smooth), tight(way));
    fewer_tight += tight(smooth) < tight(way);
    for (const Segment& move : smooth)
      for (int k = 0; k <= 20; ++k) {
        EXPECT_LE(distance_from(move.point(k / 20.0), way), 1.05 * kSmoothing);
        EXPECT_GE(centres.signed_distance(move.point(k / 20.0)), -1.1e-4);
      }
  }
  EXPECT_GT(fewer_tight, 30);
}

// Where the room ends there is no wall: a way along that border loses what the wall would keep.
TEST(ShortMoves, GiveWayAlongABorderThatIsNoWall) {
  for (const bool at_start : {true, false}) {
    Vec2 p{0, 0};
    double heading = 0;
    std::vector<Segment> way{next_move(&p, &heading, 0, 1)};
    if (at_start) way.push_back(next_move(&p, &heading, 1 / 0.135, 0.0024));
    way.push_back(next_move(&p, &heading, 1 / 0.3, 0.34));
    if (!at_start) way.push_back(next_move(&p, &heading, 1 / 0.135, 0.0024));
    way.push_back(next_move(&p, &heading, 0, 1));
    std::vector<Vertex> outline;
    for (const Segment& s : way) outline.push_back({s.a, s.bulge(), false});
    for (const Vec2 corner : {p, Vec2{-20, p.y + 20}, Vec2{-20, 0}})
      outline.push_back({corner, 0, false});
    const Area centres({make_region(Curve(outline, true))});
    const auto shortest = [](const std::vector<Segment>& moves) {
      double least = 1e9;
      for (const Segment& move : moves) least = std::min(least, move.length());
      return least;
    };
    EXPECT_NEAR(shortest(without_short_moves(way, centres)), 0.0024, 1e-9);
    const std::vector<Segment> smooth = without_short_moves(way, centres, room());
    EXPECT_GT(shortest(smooth), 0.02);
    EXPECT_EQ(std::count_if(smooth.begin(), smooth.end(), is_tight), 0);
    for (const Segment& move : smooth)
      for (int k = 0; k <= 20; ++k)
        EXPECT_LE(distance_from(move.point(k / 20.0), way), 1.05 * kSmoothing);
    for (std::size_t i = 1; i < smooth.size(); ++i)
      EXPECT_LT(norm(smooth[i].tangent(0) - smooth[i - 1].tangent(1)), 1e-3);
    // No further than the walls.
    const Area wall({make_region(Curve(outline, true))});
    EXPECT_EQ(without_short_moves(way, room(), wall), without_short_moves(way, centres));
  }
}

}  // namespace
}  // namespace evenload
