#include "cutting/cleared_ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/shapes.h"
#include "judge/numbers.h"

namespace evenload {
namespace {

const Bounds kField{{-30, -30}, {30, 30}};

struct Swept {
  Segment move;
  double radius = 0;
};

Swept random_move(std::mt19937& random) {
  const Vec2 a{uniform(random, -10, 10), uniform(random, -10, 10)};
  switch (random() % 4) {
    case 0:
      return {Segment::line(a, {uniform(random, -10, 10), uniform(random, -10, 10)}), kRadius};
    case 1:
      return {Segment::line(a, a), uniform(random, 0.5, 6)};
    default: {
      const double radius = random() % 2 ? uniform(random, 0.01, 3) : uniform(random, 3, 12);
      const double sweep = uniform(random, 0.1, 6.2) * (random() % 2 ? 1 : -1);
      return {Segment::arc(a, radius, uniform(random, -kPi, kPi), sweep), kRadius};
    }
  }
}

// Distance to many points of the move, each of them on it.
double sampled_distance(const Segment& move, Vec2 q) {
  if (move.length() == 0) return distance(move.a, q);
  double best = 1e9, at = 0;
  const int n = 400;
  for (int i = 0; i <= n; ++i) {
    const double d = distance(move.point(static_cast<double>(i) / n), q);
    if (d < best) {
      best = d;
      at = static_cast<double>(i) / n;
    }
  }
  double low = std::max(0.0, at - 1.0 / n), high = std::min(1.0, at + 1.0 / n);
  for (int i = 0; i < 60; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (distance(move.point(a), q) < distance(move.point(b), q) ? high : low) =
        distance(move.point(a), q) < distance(move.point(b), q) ? b : a;
  }
  return std::min(best, distance(move.point(0.5 * (low + high)), q));
}

double depth_of_material(const std::vector<Swept>& moves, Vec2 q) {
  double depth = 1e9;
  for (const Swept& s : moves) depth = std::min(depth, sampled_distance(s.move, q) - s.radius);
  return depth;
}

bool in_any(const std::vector<AngularInterval>& arcs, double angle) {
  for (const AngularInterval& arc : arcs)
    if (angle >= arc.low && angle <= arc.high) return true;
  return false;
}

TEST(ClearedGround, UncoversTheArcsThatSamplingFinds) {
  std::mt19937 random(11);
  for (int round = 0; round < 60; ++round) {
    ClearedGround ground(kField, kRadius, nullptr);
    std::vector<Swept> moves;
    const int count = 1 + static_cast<int>(random() % 6);
    for (int i = 0; i < count; ++i) {
      moves.push_back(random_move(random));
      ground.add(moves.back().move, moves.back().radius);
    }
    for (int look = 0; look < 4; ++look) {
      const Vec2 p{uniform(random, -9, 9), uniform(random, -9, 9)};
      const double low = uniform(random, -7, 7), width = look ? uniform(random, 0.1, 2 * kPi) : kPi;
      std::vector<AngularInterval> arcs;
      ground.uncovered(p, low, low + width, arcs);
      double last = low;
      for (const AngularInterval& arc : arcs) {
        EXPECT_GE(arc.low, last - 1e-9) << "in order and inside";
        EXPECT_GE(arc.high, arc.low);
        last = arc.high;
      }
      EXPECT_LE(last, low + width + 1e-9);
      for (int k = 0; k < 120; ++k) {
        const double angle = low + (k + 0.5) / 120 * width;
        const double depth =
            depth_of_material(moves, p + (kRadius - kCoverTolerance) * unit(angle));
        if (std::abs(depth) < 1e-6) continue;
        EXPECT_EQ(in_any(arcs, angle), depth > 0)
            << "round " << round << " angle " << angle << " depth " << depth;
      }
    }
  }
}

// Passes side by side, as in a slot, some of them taken back: most of the history is buried.
TEST(ClearedGround, UncoversTheSameHoweverMuchIsBuried) {
  std::mt19937 random(13);
  ClearedGround ground(kField, kRadius, nullptr);
  std::vector<Segment> moves;
  Vec2 at{-8, 0};
  for (int i = 0; i < 1200; ++i) {
    const Vec2 to = at + Vec2{uniform(random, -0.19, 0.2), uniform(random, -0.3, 0.3)};
    moves.push_back(Segment::line(at, to));
    ground.add(moves.back());
    at = to;
    for (int back = random() % 7 ? 0 : static_cast<int>(random() % 5); back > 0; --back) {
      at = moves.back().a;
      moves.pop_back();
      ground.remove_last();
      if (moves.empty()) break;
    }
    if (i % 100 || moves.empty()) continue;
    ASSERT_EQ(ground.size(), moves.size());
    for (int look = 0; look < 40; ++look) {
      const Vec2 p = at + Vec2{uniform(random, -2, 2), uniform(random, -2, 2)};
      const std::size_t last = moves.size() - static_cast<std::size_t>(random() % 2);
      std::vector<AngularInterval> arcs;
      ground.uncovered(p, 0, 2 * kPi, arcs, kCoverTolerance, last);
      for (int k = 0; k < 200; ++k) {
        const double angle = (k + 0.5) / 200 * 2 * kPi;
        const Vec2 q = p + (kRadius - kCoverTolerance) * unit(angle);
        double depth = 1e9;
        for (std::size_t m = 0; m < last; ++m)
          depth = std::min(depth, moves[m].distance_to(q) - kRadius);
        if (std::abs(depth) < 1e-6) continue;
        ASSERT_EQ(in_any(arcs, angle), depth > 0) << "angle " << angle << " depth " << depth;
      }
    }
  }
}

// Clears five random moves.
std::vector<Swept> clear_at_random(ClearedGround& ground, std::mt19937& random) {
  std::vector<Swept> moves;
  for (int i = 0; i < 5; ++i) {
    moves.push_back(random_move(random));
    ground.add(moves.back().move, moves.back().radius);
  }
  return moves;
}

TEST(ClearedGround, KnowsWhichPointsAreCleared) {
  std::mt19937 random(12);
  ClearedGround ground(kField, kRadius, nullptr);
  const std::vector<Swept> moves = clear_at_random(ground, random);
  const std::vector<Swept> oldest(moves.begin(), moves.begin() + 3);
  const std::vector<Swept> newest(moves.begin() + 3, moves.end());
  for (int i = 0; i < 2000; ++i) {
    const Vec2 q{uniform(random, -15, 15), uniform(random, -15, 15)};
    const double depth = depth_of_material(moves, q);
    if (std::abs(depth) > 1e-4) {
      EXPECT_EQ(ground.is_cleared_point(q), depth < 0);
    }
    const double since = depth_of_material(newest, q);
    if (depth_of_material(oldest, q) > 1e-4 && std::abs(since) > 1e-4) {
      EXPECT_EQ(ground.is_cleared_since(q, 3), since < 0);
    }
  }
}

TEST(ClearedGround, GivesTheEngagementAtAStraightWall) {
  for (const double step : {0.01, 0.2, 1.0, 1.5, 3.0, 5.0, 5.99}) {
    ClearedGround ground(kField, kRadius, nullptr);
    // The wall lies at y = -3; the tool goes to the right, `step` deep into it.
    ground.add(Segment::line({-25, 0}, {25, 0}));
    ground.add(Segment::line({-25, 2}, {25, 2}));
    ground.add(Segment::line({-25, 5}, {25, 5}));
    std::vector<AngularInterval> arcs;
    ground.uncovered({0, -step}, -kPi / 2, kPi / 2, arcs, 0);
    ASSERT_EQ(arcs.size(), 1u) << step;
    EXPECT_NEAR(arcs[0].low, -kPi / 2, 1e-9);
    EXPECT_NEAR(arcs[0].width(), std::acos(1 - step / kRadius), 1e-7) << step;
  }
}

TEST(ClearedGround, LooksBackToBeforeAnyMove) {
  ClearedGround ground(kField, kRadius, nullptr);
  ground.add_disc({0, 0}, 2);
  ground.add(Segment::line({-10, 0}, {10, 0}));
  std::vector<AngularInterval> now, before;
  ground.uncovered({5, 0}, 0, 2 * kPi, now);
  ground.uncovered({5, 0}, 0, 2 * kPi, before, kCoverTolerance, 1);
  EXPECT_TRUE(now.empty());
  double width = 0;
  for (const AngularInterval& arc : before) width += arc.width();
  EXPECT_NEAR(width, 2 * kPi, 1e-9);
}

TEST(ClearedGround, IsAsItWasAfterTheNewestMoveIsTakenBack) {
  std::mt19937 random(13);
  for (int round = 0; round < 40; ++round) {
    ClearedGround ground(kField, kRadius, nullptr);
    for (int i = 0; i < 4; ++i) {
      const Swept s = random_move(random);
      ground.add(s.move, s.radius);
    }
    std::vector<Vec2> places;
    std::vector<std::vector<AngularInterval>> before;
    for (int i = 0; i < 30; ++i) {
      places.push_back({uniform(random, -12, 12), uniform(random, -12, 12)});
      before.emplace_back();
      ground.uncovered(places.back(), 0, 2 * kPi, before.back());
    }
    for (int i = 0; i < 3; ++i) {
      const Swept s = random_move(random);
      ground.add(s.move, s.radius);
    }
    for (int i = 0; i < 3; ++i) ground.remove_last();
    EXPECT_EQ(ground.size(), 4u);
    for (std::size_t i = 0; i < places.size(); ++i) {
      std::vector<AngularInterval> after;
      ground.uncovered(places[i], 0, 2 * kPi, after);
      ASSERT_EQ(after.size(), before[i].size());
      for (std::size_t k = 0; k < after.size(); ++k) {
        EXPECT_EQ(after[k].low, before[i][k].low);
        EXPECT_EQ(after[k].high, before[i][k].high);
      }
    }
  }
}

// To the last bit, as they were before the move numbered `last`.
void expect_same_looks(const ClearedGround& a, const ClearedGround& b, std::size_t last,
                       std::mt19937& random) {
  ASSERT_EQ(a.size(), b.size());
  std::vector<AngularInterval> arcs, others;
  for (int look = 0; look < 60; ++look) {
    const Vec2 p{uniform(random, -12, 12), uniform(random, -12, 12)};
    a.uncovered(p, 0, 2 * kPi, arcs, kCoverTolerance, last);
    b.uncovered(p, 0, 2 * kPi, others, kCoverTolerance, last);
    ASSERT_EQ(arcs.size(), others.size());
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      EXPECT_EQ(arcs[i].low, others[i].low);
      EXPECT_EQ(arcs[i].high, others[i].high);
    }
    const std::size_t first = random() % a.size();
    EXPECT_EQ(a.is_cleared_since(p, first), b.is_cleared_since(p, first));
  }
}

TEST(ClearedGround, UncoversTheSameWhetherAMoveIsAddedWholeOrExtended) {
  std::mt19937 random(31);
  for (int round = 0; round < 40; ++round) {
    ClearedGround whole(kField, kRadius, nullptr), extended(kField, kRadius, nullptr);
    for (int i = 0; i < 3; ++i) {
      const Segment move = random_move(random).move;
      whole.add(move);
      const int parts = 1 + static_cast<int>(random() % 6);
      for (int k = 0; k < parts; ++k) {
        const double from = static_cast<double>(k) / parts, to = (k + 1.0) / parts;
        if (k == 0)
          extended.add(k + 1 < parts ? move.part(0, to) : move);
        else
          extended.extend_last(k + 1 < parts ? move.part(0, to) : move, move.part(from, to));
      }
      expect_same_looks(whole, extended, whole.size(), random);
    }
    for (int i = 0; i < 2; ++i) {
      whole.remove_last();
      extended.remove_last();
      expect_same_looks(whole, extended, whole.size(), random);
    }
  }
}

TEST(ClearedGround, UncoversTheSameWhereExtendedMovesHideEachOther) {
  std::mt19937 random(37);
  ClearedGround whole(kField, kRadius, nullptr), extended(kField, kRadius, nullptr);
  // A fan, of which each line sweeps nearly all that the ones before did.
  for (int i = 0; i < 100; ++i) {
    const Segment move = Segment::line({-6, 0}, {6, 0.02 * i});
    whole.add(move);
    extended.add(move.part(0, 0.3));
    extended.extend_last(move.part(0, 0.8), move.part(0.3, 0.8));
    extended.extend_last(move, move.part(0.8, 1));
  }
  expect_same_looks(whole, extended, 100, random);
  expect_same_looks(whole, extended, 50, random);
  for (int i = 0; i < 60; ++i) {
    whole.remove_last();
    extended.remove_last();
  }
  expect_same_looks(whole, extended, 40, random);
  expect_same_looks(whole, extended, 35, random);
}

TEST(ClearedGround, SettledUncoversTheSameAndMovesThatAreTriedCanBeTakenBack) {
  std::mt19937 random(23);
  ClearedGround settled(kField, kRadius, nullptr), plain(kField, kRadius, nullptr);
  std::vector<AngularInterval> a, b;
  const auto expect_same = [&](std::size_t last) {
    for (int look = 0; look < 40; ++look) {
      const Vec2 p{uniform(random, -12, 12), uniform(random, -12, 12)};
      settled.uncovered(p, 0, 2 * kPi, a, kCoverTolerance, last);
      plain.uncovered(p, 0, 2 * kPi, b, kCoverTolerance, last);
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(a[i].low, b[i].low, 1e-9);
        EXPECT_NEAR(a[i].high, b[i].high, 1e-9);
      }
    }
  };
  for (int pass = 0; pass < 30; ++pass) {
    const std::size_t first = settled.size();
    // A fan of lines that hide each other, nearly, so that lists get long.
    for (int i = 0; i < 12; ++i) {
      const Segment move = Segment::line({-6, -0.01 * pass}, {6, 0.02 * i - 0.01 * pass});
      settled.add(move);
      plain.add(move);
    }
    settled.settle(first);
    for (int i = 0; i < 20; ++i) settled.add(random_move(random).move);
    for (int i = 0; i < 20; ++i) settled.remove_last();
    expect_same(settled.size());
    expect_same(settled.size() / 2);
  }
}

TEST(ClearedGround, IsNotChangedByWhatIsAddedToACopy) {
  std::vector<Vertex> corners = shapes::rectangle(-12, -12, 12, 12).vertices();
  for (Vertex& corner : corners) corner.open = true;
  const std::vector<Region> stock{make_region(Curve(corners, true))};
  ClearedGround ground(kField, kRadius, &stock);
  ground.add(Segment::line({-6, 0}, {0, 0}));
  ClearedGround copy = ground;
  copy.add(Segment::line({0, 0}, {6, 0}));
  EXPECT_EQ(ground.size(), 1U);
  EXPECT_FALSE(ground.is_cleared_point({6, 0}));
  EXPECT_TRUE(copy.is_cleared_point({6, 0}));
  EXPECT_TRUE(copy.is_cleared_point({-6, 0}));
  // Both know the edges of the stock.
  EXPECT_TRUE(ground.is_cleared_point({13, 0}));
  EXPECT_TRUE(copy.is_cleared_point({13, 0}));
}

TEST(ClearedGround, IsClearExactlyWhereNothingIsUncovered) {
  std::mt19937 random(14);
  ClearedGround ground(kField, kRadius, nullptr);
  for (int i = 0; i < 12; ++i) {
    const Swept s = random_move(random);
    ground.add(s.move, s.radius);
  }
  int clear = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec2 p{uniform(random, -12, 12), uniform(random, -12, 12)};
    std::vector<AngularInterval> arcs;
    ground.uncovered(p, 0, 2 * kPi, arcs);
    EXPECT_EQ(ground.is_clear(p), arcs.empty());
    clear += arcs.empty() ? 1 : 0;
  }
  EXPECT_GT(clear, 30);
}

TEST(ClearedGround, IsClearAlongEveryMoveThatClearedIt) {
  std::mt19937 random(15);
  for (int i = 0; i < 300; ++i) {
    ClearedGround ground(kField, kRadius, nullptr);
    Swept s = random_move(random);
    s.radius = kRadius;
    ground.add(s.move, s.radius);
    for (int k = 0; k <= 20; ++k)
      EXPECT_TRUE(ground.is_clear(s.move.length() > 0 ? s.move.point(k / 20.0) : s.move.a)) << i;
  }
}

TEST(ClearedGround, KnowsWhereNothingIsLeftAroundAPoint) {
  std::mt19937 random(13);
  ClearedGround ground(kField, kRadius, nullptr);
  const std::vector<Swept> moves = clear_at_random(ground, random);
  int all = 0, seen = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec2 q{uniform(random, -15, 15), uniform(random, -15, 15)};
    const double margin = uniform(random, 0, 0.2);
    const bool is_cleared = depth_of_material(moves, q) < -margin;  // by one move
    if (ground.is_cleared_around(q, margin)) {
      EXPECT_LT(depth_of_material(moves, q), -margin + 1e-9);
      ++seen;
    }
    all += is_cleared;
  }
  EXPECT_GT(seen, 0.8 * all);
  std::vector<Vertex> v = shapes::rectangle(-10, -10, 10, 10).vertices();
  for (Vertex& x : v) x.open = true;
  const std::vector<Region> stock = {make_region(Curve(v, true))};
  const ClearedGround untouched(kField, kRadius, &stock);
  EXPECT_TRUE(untouched.is_cleared_around({11, 0}, 0.99));
  EXPECT_FALSE(untouched.is_cleared_around({11, 0}, 1.01));
  EXPECT_FALSE(untouched.is_cleared_around({9, 0}, 0));
}

TEST(ClearedGround, HoldsMaterialOnlyWhereThereIsStock) {
  std::vector<Vertex> v = shapes::rectangle(-10, -10, 10, 10).vertices();
  for (Vertex& x : v) x.open = true;
  const std::vector<Region> stock = {
      make_region(Curve(v, true), {shapes::rectangle(-4, -4, 4, 4)})};
  const ClearedGround ground(kField, kRadius, &stock);
  std::mt19937 random(16);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 q{uniform(random, -15, 15), uniform(random, -15, 15)};
    if (stock[0].outer.contains(q) && !(std::abs(q.x) <= 4 && std::abs(q.y) <= 4)) {
      EXPECT_FALSE(ground.is_cleared_point(q));
    }
    if (!stock[0].outer.contains(q)) {
      EXPECT_TRUE(ground.is_cleared_point(q));
    }
  }
  EXPECT_TRUE(ground.is_clear({-14, 0}));
  EXPECT_FALSE(ground.is_clear({-12, 0}));
  std::vector<AngularInterval> arcs;
  ground.uncovered({-12, 0}, -kPi, kPi, arcs);
  ASSERT_EQ(arcs.size(), 1u);
  EXPECT_NEAR(arcs[0].width(), 2 * std::acos(2.0 / 3), 1e-4);
}

TEST(SweptMove, IsWithinAReachAboveItsDistance) {
  std::mt19937 random(72);
  int within = 0;
  for (int round = 0; round < 20000; ++round) {
    const Vec2 x{uniform(random, -15, 15), uniform(random, -15, 15)};
    const Swept s = random_move(random);
    const SweptMove swept(s.move, s.radius);
    const double reach = uniform(random, 0.01, 14), distance = swept.distance(x);
    if (std::abs(distance - reach) < 1e-9) continue;
    EXPECT_EQ(swept.is_within(x, reach), distance < reach) << round;
    within += distance < reach;
  }
  EXPECT_GT(within, 4000);
  EXPECT_LT(within, 16000);
}

TEST(ClearedGround, WhatAMoveHidesTheOtherClearsToo) {
  std::mt19937 random(71);
  int hidden = 0;
  for (int round = 0; round < 60000; ++round) {
    const Vec2 x{uniform(random, -10, 10), uniform(random, -10, 10)};
    const Swept a = random_move(random), b = random_move(random);
    const SweptMove older(a.move, a.radius), newer(b.move, b.radius);
    const double reach = uniform(random, 0.1, 1.5);
    if (!hides(newer.seen_from(x), older.seen_from(x), reach)) continue;
    bool touches = false;
    for (int i = 0; i < 30; ++i) {
      const Vec2 q =
          x + reach * std::sqrt(uniform(random, 0, 1)) * unit(uniform(random, -kPi, kPi));
      if (older.distance(q) > a.radius) continue;
      touches = true;
      EXPECT_LE(newer.distance(q), b.radius) << round;
    }
    hidden += touches;
  }
  EXPECT_GT(hidden, 300);
}

// Arcs to and fro across a strip, each a little further: most borders come to lie under newer ones.
std::vector<Segment> narrow_passes(int count) {
  std::vector<Segment> moves;
  for (int i = 0; i < count; ++i) {
    const Segment pass = Segment::arc({0.06 * i - 8, 0}, 5, -0.6, 1.2);
    for (int k = 0; k < 5; ++k) moves.push_back(pass.part(k / 5.0, (k + 1) / 5.0));
  }
  return moves;
}

// What is uncovered, to the last bit, when no move is left out.
std::vector<AngularInterval> uncovered_by_all(const std::vector<Segment>& moves, std::size_t last,
                                              Vec2 p, double low) {
  std::vector<AngularInterval> set{{low, low + 2 * kPi}};
  for (std::size_t i = 0; i < last; ++i)
    SweptMove(moves[i], kRadius).subtract({p, kRadius - kCoverTolerance, low, last}, set);
  return set;
}

void expect_same(const std::vector<AngularInterval>& found,
                 const std::vector<AngularInterval>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].low, expected[i].low);
    EXPECT_EQ(found[i].high, expected[i].high);
  }
}

TEST(ClearedGround, LeavesOutOnlyWhatChangesNoBit) {
  std::mt19937 random(72);
  const std::vector<Segment> moves = narrow_passes(90);
  ClearedGround ground(kField, kRadius, nullptr);
  for (const Segment& move : moves) ground.add(move);
  std::vector<AngularInterval> found;
  std::size_t size = moves.size();
  for (int round = 0; round < 400; ++round) {
    for (int taken = 0; round % 20 == 19 && taken < 7; ++taken, --size) ground.remove_last();
    const std::size_t last = random() % 2 ? size : 1 + random() % size;
    const Vec2 p = moves[random() % size].point(uniform(random, 0, 1)) +
                   Vec2{uniform(random, -1, 1), uniform(random, -1, 1)};
    const double low = uniform(random, -kPi, kPi);
    ground.uncovered(p, low, low + 2 * kPi, found, kCoverTolerance, last);
    expect_same(found, uncovered_by_all(moves, last, p, low));
  }
  EXPECT_LT(size, moves.size());
}

TEST(ClearedGround, HasASmoothBorderAlongMovesThatAreTangentToEachOther) {
  ClearedGround ground(kField, kRadius, nullptr);
  const Segment line = Segment::line({-8, 0}, {0, 0});
  const Segment bend = Segment::arc({0, 20}, 20, -kPi / 2, 0.3);
  ground.add(line);
  ground.add(bend);
  const Vec2 on_line{-4, -kRadius}, further{-2, -kRadius};
  const Vec2 on_bend = Vec2{0, 20} + (20 + kRadius) * unit(-kPi / 2 + 0.2);
  EXPECT_TRUE(ground.is_smooth_between(on_line, further));
  EXPECT_TRUE(ground.is_smooth_between(on_line, on_bend));
  EXPECT_TRUE(ground.is_smooth_between(on_bend, on_line));
  // Inside, or in untouched material, there is no border.
  EXPECT_FALSE(ground.is_smooth_between(on_line, {-3, 0}));
  EXPECT_FALSE(ground.is_smooth_between({-4, -10}, {-3, -10}));
}

TEST(ClearedGround, HasNoSmoothBorderWhereSweptGroundsMeetInACusp) {
  ClearedGround ground(kField, kRadius, nullptr);
  const Vec2 on_first{-4, -kRadius};
  ground.add(Segment::line({-8, 0}, {0, 0}));
  ground.add(Segment::line({0, 0}, 8.0 * unit(-0.2)));
  const Vec2 on_second = 4.0 * unit(-0.2) - kRadius * left_normal(unit(-0.2));
  EXPECT_FALSE(ground.is_smooth_between(on_first, on_second));
  ground.remove_last();
  ground.add(Segment::line({8, 0}, {0, 0}));  // in one line, but not one after the other
  EXPECT_FALSE(ground.is_smooth_between(on_first, {4, -kRadius}));
}

// On the inner side of a turn tighter than the disc the border is that of the discs at its ends.
TEST(ClearedGround, HasNoSmoothBorderInsideATurnTighterThanTheDiscIsRound) {
  for (const double radius : {0.6 * kRadius, 1.5 * kRadius}) {
    ClearedGround ground(kField, kRadius, nullptr);
    const Segment before = Segment::line({-8, 0}, {0, 0}),
                  turn = Segment::arc({0, -radius}, radius, kPi / 2, -1.0),
                  after = Segment::line(turn.b, turn.b + 6.0 * turn.tangent(1));
    for (const Segment& move : {before, turn, after}) ground.add(move);
    const auto beside = [](const Segment& move, double t, double side) {
      return move.point(t) + side * kRadius * left_normal(move.tangent(t));
    };
    EXPECT_EQ(ground.is_smooth_between(beside(before, 0.2, -1), beside(after, 0.8, -1)),
              radius > kRadius);
    EXPECT_TRUE(ground.is_smooth_between(beside(before, 0.2, 1), beside(after, 0.8, 1)));
    EXPECT_TRUE(ground.is_smooth_between(beside(before, 0.2, 1), beside(turn, 0.5, 1)));
  }
}

TEST(ClearedGround, HasASmoothBorderAsItWasBeforeTheToolCameToItsPlace) {
  ClearedGround ground(kField, kRadius, nullptr);
  ground.add(Segment::line({-8, 0}, {8, 0}));
  const Vec2 tool{0, -1};
  const Vec2 front =
      tool + Vec2{std::sqrt(kRadius * kRadius - (kRadius - 1) * (kRadius - 1)), 1 - kRadius};
  const Vec2 ahead{front.x + 1, -kRadius};
  ASSERT_TRUE(ground.is_smooth_between(front, ahead));
  // The disc where the tool stands borders on all of the tool's circle.
  ground.add(Segment::line({-3, -1}, tool));
  EXPECT_FALSE(ground.is_smooth_between(front, ahead));
  EXPECT_TRUE(ground.is_smooth_between(front, ahead, ground.size() - 1));
}

TEST(ClearedGround, HasASmoothBorderAlongOneEdgeOfTheStockOnly) {
  std::vector<Vertex> v = shapes::rectangle(-10, -10, 10, 10).vertices();
  for (Vertex& x : v) x.open = true;
  const std::vector<Region> stock = {make_region(Curve(v, true))};
  const ClearedGround ground(kField, kRadius, &stock);
  EXPECT_TRUE(ground.is_smooth_between({-4, -10}, {6, -10}));
  EXPECT_FALSE(ground.is_smooth_between({-4, -10}, {10, 3}));
}

TEST(ClearedGround, WhatLoopsLeaveIsNoSmoothFrontForPlacesThatAreApart) {
  // Full turns that go on tangentially, a step to the right each: their fronts meet in scallops.
  constexpr double kTurn = 1, kStep = 0.5;
  ClearedGround ground({{-20, -20}, {20, 20}}, kRadius, nullptr);
  for (int i = 0; i < 4; ++i) {
    const Vec2 centre{kStep * i, 0};
    ground.add(Segment::arc(centre, kTurn, -kPi / 2, 2 * kPi));
    ground.add(Segment::line(centre + Vec2{0, -kTurn}, centre + Vec2{kStep, -kTurn}));
  }
  const Vec2 top{0, kTurn + kRadius}, next = top + Vec2{kStep, 0};
  EXPECT_TRUE(ground.is_smooth_between(top, next));  // tangent all the way
  EXPECT_FALSE(ground.is_smooth_between(top, next, ground.size(), kMostTurnOfFront));
  const Vec2 beside = kStep * Vec2{1, 0} + (kTurn + kRadius) * unit(kPi / 2 - 0.02);
  EXPECT_TRUE(ground.is_smooth_between(next, beside, ground.size(), kMostTurnOfFront));
}

}  // namespace
}  // namespace evenload
