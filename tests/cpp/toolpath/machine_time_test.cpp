#include "toolpath/machine_time.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <stdexcept>

#include "geometry/vec2.h"
#include "judge/numbers.h"

namespace evenload {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

MachineProfile unlimited() {
  MachineProfile profile;
  for (int axis = 0; axis < 3; ++axis) profile.max_feed[axis] = profile.max_accel[axis] = kInfinity;
  profile.junction_deviation = kInfinity;
  profile.rapid_feed = 5000;
  return profile;
}

// The same limits on every axis; corners are full stops.
MachineProfile plain(double accel, double jerk = 0) {
  MachineProfile profile = unlimited();
  for (double& limit : profile.max_accel) limit = accel;
  profile.junction_deviation = 0;
  profile.max_jerk = jerk;
  return profile;
}

Move line(double x, double y, double feed, double z = 0) {
  return {MoveKind::kCut, x, y, z, 0, 0, 0, feed};
}
Move rapid(double x, double y, double z = 0) { return {MoveKind::kRapid, x, y, z}; }

// An arc about (cx, cy) from `from` on.
Move arc(const Move& from, double cx, double cy, double sweep, double feed, double rise = 0) {
  const Vec2 end = Vec2{cx, cy} + rotated(Vec2{from.x - cx, from.y - cy}, sweep);
  return {MoveKind::kCut, end.x, end.y, from.z + rise, sweep, cx, cy, feed};
}

double total(const std::vector<MoveTime>& times) {
  return times.back().start + times.back().duration;
}
double total(const std::vector<Move>& moves, const MachineProfile& profile) {
  return total(machine_time(moves, profile));
}

std::vector<Move> random_path(std::mt19937& random, int count) {
  std::vector<Move> moves{rapid(0, 0, 5)};
  for (int i = 0; i < count; ++i) {
    const Move& at = moves.back();
    const double feed = uniform(random, 100, 3000);
    switch (random() % 6) {
      case 0:
        moves.push_back(rapid(uniform(random, -50, 50), uniform(random, -50, 50), 5));
        break;
      case 1:
        moves.push_back(arc(at, at.x + uniform(random, -5, 5), at.y + uniform(random, 0.1, 5),
                            uniform(random, -6, 6), feed, uniform(random, -1, 1)));
        break;
      case 2:
        moves.push_back(at);  // no length
        moves.back().kind = MoveKind::kCut;
        moves.back().sweep = 0;
        moves.back().feed = feed;
        break;
      default: {
        const double size = std::pow(10, uniform(random, -2, 1.5));
        moves.push_back(line(at.x + uniform(random, -size, size),
                             at.y + uniform(random, -size, size), feed,
                             at.z + uniform(random, -0.1, 0.1) * size));
      }
    }
  }
  return moves;
}

MachineProfile random_profile(std::mt19937& random, bool jerk) {
  MachineProfile profile;
  for (int axis = 0; axis < 3; ++axis) {
    profile.max_feed[axis] = uniform(random, 500, 6000);
    profile.max_accel[axis] = uniform(random, 100, 5000);
  }
  profile.centripetal_accel = uniform(random, 50, 2000);
  profile.junction_deviation = uniform(random, 0.001, 0.05);
  profile.block_rate = uniform(random, 200, 2000);
  profile.look_ahead = 1 + static_cast<int>(uniform(random, 0, 50));
  profile.rapid_feed = uniform(random, 2000, 20000);
  if (jerk) profile.max_jerk = std::pow(10, uniform(random, 3, 6));
  return profile;
}

TEST(MachineTime, IsTheProgrammedTimeWithoutLimits) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const std::vector<Move> moves = random_path(random, 200);
    const double programmed = programmed_time(moves, 5000);
    EXPECT_NEAR(total(moves, unlimited()), programmed, 1e-9 * programmed);
    MachineProfile huge = unlimited();  // the same with numbers
    for (int axis = 0; axis < 3; ++axis) huge.max_feed[axis] = huge.max_accel[axis] = 1e15;
    huge.centripetal_accel = huge.junction_deviation = huge.block_rate = 1e15;
    EXPECT_NEAR(total(moves, huge), programmed, 1e-9 * programmed);
    huge.max_jerk = 1e30;
    EXPECT_NEAR(total(moves, huge), programmed, 1e-9 * programmed);
  }
}

TEST(MachineTime, IsNeverShorterThanTheProgrammedTimeMoveByMove) {
  std::mt19937 random(2);
  for (int i = 0; i < 100; ++i) {
    const std::vector<Move> moves = random_path(random, 100);
    const MachineProfile profile = random_profile(random, i % 2);
    const std::vector<MoveTime> times = machine_time(moves, profile);
    ASSERT_EQ(times.size(), moves.size());
    for (std::size_t k = 1; k < moves.size(); ++k) {
      const double own = programmed_time({moves[k - 1], moves[k]}, profile.rapid_feed);
      EXPECT_GE(times[k].duration, own * (1 - 1e-9));
      EXPECT_NEAR(times[k].start, times[k - 1].start + times[k - 1].duration,
                  1e-9 * (1 + times[k].start));
      EXPECT_LE(times[k].entry, times[k].peak * (1 + 1e-9));
      EXPECT_LE(times[k].exit, times[k].peak * (1 + 1e-9));
    }
    EXPECT_EQ(times.back().exit * times.back().length, 0);
  }
}

TEST(MachineTime, OfOneLongLineIsLengthOverSpeedPlusSpeedOverAcceleration) {
  const std::vector<Move> moves{rapid(0, 0), line(200, 0, 6000)};
  const std::vector<MoveTime> times = machine_time(moves, plain(500));
  EXPECT_NEAR(total(times), 200.0 / 100 + 100.0 / 500, 1e-12);
  EXPECT_EQ(times[1].entry, 0);
  EXPECT_NEAR(times[1].peak, 100, 1e-12);
  EXPECT_EQ(times[1].exit, 0);
}

TEST(MachineTime, OfOneShortLineIsThatOfATriangle) {
  const std::vector<MoveTime> times = machine_time({rapid(0, 0), line(5, 0, 60000)}, plain(500));
  EXPECT_NEAR(times[1].peak, 50, 1e-9);  // sqrt(a L)
  EXPECT_NEAR(total(times), 2 * std::sqrt(5.0 / 500), 1e-12);
}

TEST(MachineTime, WithAJerkLimitIsThatOfAnSCurve) {
  // Full acceleration reached: a / j more than the trapezoid.
  EXPECT_NEAR(total({rapid(0, 0), line(200, 0, 6000)}, plain(500, 5000)),
              200.0 / 100 + 100.0 / 500 + 500.0 / 5000, 1e-12);
  // Speed reached, full acceleration not: each change of speed takes 2 sqrt(v / j).
  EXPECT_NEAR(total({rapid(0, 0), line(200, 0, 600)}, plain(500, 5000)),
              200.0 / 10 + 2 * std::sqrt(10.0 / 5000), 1e-12);
  // Neither: four equal pieces of jerk, L = 2 j t^3.
  EXPECT_NEAR(total({rapid(0, 0), line(0.08, 0, 6000)}, plain(500, 5000)),
              4 * std::cbrt(0.08 / (2 * 5000)), 1e-12);
  // Full acceleration, but not the speed: v^2 / a + v a / j = L.
  const double v = (-50 + std::sqrt(50.0 * 50 + 4 * 500 * 20)) / 2;
  const std::vector<MoveTime> times =
      machine_time({rapid(0, 0), line(20, 0, 60000)}, plain(500, 5000));
  EXPECT_NEAR(times[1].peak, v, 1e-9);
  EXPECT_NEAR(total(times), 2 * (v / 500 + 0.1), 1e-9);
}

TEST(MachineTime, StopsAtTheCornersOfASquareOnlyWithoutDeviation) {
  const std::vector<Move> square{rapid(0, 0), line(20, 0, 3000), line(20, 20, 3000),
                                 line(0, 20, 3000), line(0, 0, 3000)};
  MachineProfile profile = plain(500);
  EXPECT_NEAR(total(square, profile), 4 * (20.0 / 50 + 50.0 / 500), 1e-12);
  // With it, by grbl's rule: the turn of 90 degrees takes the acceleration along the diagonal,
  // which both axes share.
  profile.junction_deviation = 0.02;
  const double half = std::sqrt(0.5), accel = 500 / half;
  const double corner = std::sqrt(accel * 0.02 * half / (1 - half));
  const std::vector<MoveTime> times = machine_time(square, profile);
  EXPECT_NEAR(times[1].exit, corner, 1e-9);
  EXPECT_NEAR(times[2].entry, corner, 1e-9);
  EXPECT_NEAR(times[4].exit, 0, 1e-9);
  const double side = (20 - (50 * 50 - corner * corner) / 500) / 50 + 2 * (50 - corner) / 500;
  EXPECT_NEAR(times[2].duration, side, 1e-9);
  EXPECT_NEAR(times[3].duration, side, 1e-9);
}

TEST(MachineTime, StopsWhereThePathTurnsBack) {
  MachineProfile profile = plain(500);
  profile.junction_deviation = 0.05;
  const std::vector<MoveTime> times =
      machine_time({rapid(0, 0), line(20, 0, 3000), line(0, 0, 3000)}, profile);
  EXPECT_NEAR(times[1].exit, 0, 1e-6);
}

TEST(MachineTime, PassesTangentJointsAtFullSpeed) {
  const Move start = rapid(0, 0), first = line(20, 0, 3000);
  const Move round = arc(first, 20, 10, kPi, 3000);
  const std::vector<MoveTime> times =
      machine_time({start, first, round, line(0, 20, 3000)}, plain(500));
  EXPECT_NEAR(times[1].exit, 50, 1e-9);
  EXPECT_NEAR(times[2].entry, 50, 1e-9);
  EXPECT_NEAR(times[2].exit, 50, 1e-9);
  EXPECT_NEAR(times[2].duration, kPi * 10 / 50, 1e-9);
}

TEST(MachineTime, HoldsTheCentripetalAccelerationOnCircles) {
  MachineProfile profile = unlimited();
  profile.centripetal_accel = 400;
  const Move start = rapid(4, 0);
  const std::vector<MoveTime> times =
      machine_time({start, arc(start, 0, 0, 2 * kPi, 6000)}, profile);
  EXPECT_NEAR(times[1].peak, 40, 1e-9);  // sqrt(400 * 4)
  EXPECT_NEAR(times[1].duration, 2 * kPi * 4 / 40, 1e-9);
  // On a helix it is the speed in the plane that counts.
  const double rise = 2 * kPi * 4;  // 45 degrees
  const std::vector<MoveTime> helix =
      machine_time({start, arc(start, 0, 0, 2 * kPi, 6000, rise)}, profile);
  EXPECT_NEAR(helix[1].peak, 40 * std::sqrt(2.0), 1e-9);
}

TEST(MachineTime, GoesRoundACircleOfLinesNoFasterThanRoundTheCircle) {
  MachineProfile profile = unlimited();
  profile.centripetal_accel = 400;
  std::vector<Move> moves{rapid(4, 0)};
  for (int i = 1; i <= 360; ++i)
    moves.push_back(line(4 * std::cos(i * kPi / 180), 4 * std::sin(i * kPi / 180), 6000));
  const std::vector<MoveTime> times = machine_time(moves, profile);
  EXPECT_NEAR(times[100].exit, 40, 0.01);
}

TEST(MachineTime, HoldsTheLimitsOfEachAxis) {
  MachineProfile profile = unlimited();
  profile.max_feed[0] = 600;
  profile.max_feed[1] = 1200;
  profile.max_feed[2] = 300;
  const auto peak = [&](const Move& to) {
    return machine_time({rapid(0, 0), to}, profile)[1].peak * 60;
  };
  EXPECT_NEAR(peak(line(10, 0, 6000)), 600, 1e-9);
  EXPECT_NEAR(peak(line(0, -10, 6000)), 1200, 1e-9);
  EXPECT_NEAR(peak(line(0, 0, 6000, 4)), 300, 1e-9);
  EXPECT_NEAR(peak(line(3, 4, 6000)), 1000, 1e-9);
  EXPECT_NEAR(peak(line(30, 40, 500)), 500, 1e-9);
  // An arc from 30 to 60 degrees moves fastest in x at its end, in y at its begin.
  profile.max_feed[1] = 1000;
  const Move start = rapid(4 * std::cos(kPi / 6), 4 * std::sin(kPi / 6));
  const auto arc_peak = [&](double sweep) {
    return machine_time({start, arc(start, 0, 0, sweep, 60000)}, profile)[1].peak * 60;
  };
  EXPECT_NEAR(arc_peak(kPi / 6), 600 / std::sin(kPi / 3), 1e-9);
  EXPECT_NEAR(arc_peak(kPi / 2), 600, 1e-9);  // over the top, where it goes along x
  EXPECT_NEAR(arc_peak(-kPi / 12), 1000 / std::cos(kPi / 12), 1e-9);
  EXPECT_NEAR(arc_peak(-kPi / 3), 1000, 1e-9);
}

TEST(MachineTime, AcceleratesAsTheWeakestAxisInTheDirectionAllows) {
  MachineProfile profile = plain(500);
  profile.max_accel[1] = 100;
  EXPECT_NEAR(total({rapid(0, 0), line(200, 0, 6000)}, profile), 2 + 0.2, 1e-12);
  EXPECT_NEAR(total({rapid(0, 0), line(0, 200, 6000)}, profile), 2 + 1, 1e-12);
  EXPECT_NEAR(total({rapid(0, 0), line(120, 160, 6000)}, profile), 2 + 100 / 125.0, 1e-12);
}

TEST(MachineTime, GivesEveryBlockTheTimeTheControllerNeeds) {
  std::vector<Move> moves{rapid(0, 0)};
  for (int i = 1; i <= 100; ++i) moves.push_back(line(0.01 * i, 0, 6000));
  MachineProfile profile = unlimited();
  profile.block_rate = 500;
  EXPECT_NEAR(total(moves, profile), 100 / 500.0, 1e-9);
  for (const MoveTime& time : machine_time(moves, profile))
    if (time.length > 0) {
      EXPECT_GE(time.duration, (1 - 1e-9) / 500);
    }
}

TEST(MachineTime, IsNoOtherForALineCutIntoPieces) {
  std::mt19937 random(3);
  for (int i = 0; i < 60; ++i) {
    MachineProfile profile = random_profile(random, i % 2);
    profile.look_ahead = 0;
    profile.block_rate = 0;
    // With the jerk limit a line's neighbours may be planned as one with it: one line alone.
    std::vector<Move> whole{rapid(0, 0)}, cut{rapid(0, 0)};
    const int lines = i % 2 ? 1 : 4;
    for (int k = 0; k < lines; ++k) {
      const Move from = whole.back();
      const Move to = line(from.x + uniform(random, -30, 30), from.y + uniform(random, -30, 30),
                           uniform(random, 100, 6000), from.z + uniform(random, -3, 3));
      whole.push_back(to);
      const int pieces = 2 + static_cast<int>(uniform(random, 0, 40));
      for (int n = 1; n <= pieces; ++n) {
        const double share = std::pow(static_cast<double>(n) / pieces, 1.5);
        cut.push_back(line(from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
                           to.feed, from.z + share * (to.z - from.z)));
      }
    }
    const double time = total(whole, profile);
    EXPECT_NEAR(total(cut, profile), time, 1e-8 * time);
  }
}

TEST(MachineTime, FallsAsAnyLimitIsRaised) {
  std::mt19937 random(4);
  for (int i = 0; i < 40; ++i) {
    const std::vector<Move> moves = random_path(random, 60);
    const MachineProfile profile = random_profile(random, false);
    const double time = total(moves, profile);
    const auto raised = [&](auto change) {
      MachineProfile other = profile;
      change(other);
      return total(moves, other);
    };
    const double most = time * (1 + 1e-9);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(raised([&](MachineProfile& p) { p.max_feed[axis] *= 1.3; }), most);
      EXPECT_LE(raised([&](MachineProfile& p) { p.max_accel[axis] *= 1.3; }), most);
    }
    EXPECT_LE(raised([](MachineProfile& p) { p.centripetal_accel *= 1.3; }), most);
    EXPECT_LE(raised([](MachineProfile& p) { p.junction_deviation *= 1.3; }), most);
    EXPECT_LE(raised([](MachineProfile& p) { p.block_rate *= 1.3; }), most);
    EXPECT_LE(raised([](MachineProfile& p) { p.look_ahead += 1; }), most);
    EXPECT_LE(raised([](MachineProfile& p) { p.look_ahead = 0; }), most);
    EXPECT_LE(raised([](MachineProfile& p) { p.rapid_feed *= 1.3; }), most);
    EXPECT_GE(raised([](MachineProfile& p) { p.max_jerk = 1e4; }), time * (1 - 1e-9));
    EXPECT_LT(raised([](MachineProfile& p) {
                for (double& accel : p.max_accel) accel *= 3;
              }),
              time);
  }
}

TEST(MachineTime, PlansNoFurtherThanItLooksAhead) {
  std::vector<Move> moves{rapid(0, 0)};
  for (int i = 1; i <= 50; ++i) moves.push_back(line(i, 0, 6000));
  MachineProfile profile = plain(500);
  profile.look_ahead = 1;  // stops after every block
  EXPECT_NEAR(total(moves, profile), 50 * 2 * std::sqrt(1.0 / 500), 1e-9);
  profile.look_ahead = 4;  // must be able to stop within the three blocks that follow
  const std::vector<MoveTime> times = machine_time(moves, profile);
  EXPECT_NEAR(times[25].exit, std::sqrt(2 * 500 * 3.0), 1e-9);
  profile.look_ahead = 0;
  EXPECT_NEAR(machine_time(moves, profile)[25].exit, 100, 1e-9);
}

// What it takes to change from each profile's entry to its exit speed fits into its length.
void expect_changes_fit(const std::vector<MoveTime>& times) {
  for (const MoveTime& time : times) {
    if (time.length == 0) continue;
    const SpeedProfile& p = time.profile;
    const double change = std::abs(p.entry - p.exit);
    const double needed = p.jerk == 0 ? change / p.accel
                          : change * p.jerk <= p.accel * p.accel
                              ? 2 * std::sqrt(change / p.jerk)
                              : change / p.accel + p.accel / p.jerk;
    EXPECT_LE((p.entry + p.exit) / 2 * needed, p.length * (1 + 1e-9) + 1e-12);
  }
}

TEST(MachineTime, NeverBreaksALimitOfAccelerationBetweenMoves) {
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i)
    expect_changes_fit(machine_time(random_path(random, 100), random_profile(random, i % 2)));
}

TEST(MachineTime, BrakesInTimeAlsoWhereALowerSpeedAtTheEndWouldBeReachedSooner) {
  // With a jerk limit more length is needed to brake to a quarter of a speed than to standstill.
  MachineProfile profile = plain(1e6, 1000);
  profile.look_ahead = 2;
  expect_changes_fit(machine_time(
      {rapid(0, 0), line(5, 0, 6000), line(6, 0, 6000), line(6.125, 0, 6000), line(11, 0, 6000)},
      profile));
}

TEST(MachineTime, AlongAMoveRisesFromNothingToItsDuration) {
  std::mt19937 random(6);
  for (int i = 0; i < 40; ++i) {
    const std::vector<Move> moves = random_path(random, 60);
    for (const MoveTime& time : machine_time(moves, random_profile(random, i % 2))) {
      EXPECT_EQ(time_at(time, 0), 0);
      EXPECT_EQ(time_at(time, time.length), time.duration);
      EXPECT_EQ(time_at(time, time.length + 1), time.duration);
      EXPECT_EQ(time_at(time, -1), 0);
      double last = 0;
      for (int k = 1; k < 50; ++k) {
        const double at = time_at(time, time.length * k / 50);
        if (time.length > 0) {
          EXPECT_GT(at, last);
        }
        // No faster than the peak.
        EXPECT_GE((at - last) * time.peak, time.length / 50 * (1 - 1e-7));
        last = at;
      }
      EXPECT_LE(last, time.duration);
    }
  }
}

TEST(MachineTime, AlongAMoveFollowsTheEquationOfMotion) {
  const MoveTime trapezoid = machine_time({rapid(0, 0), line(200, 0, 6000)}, plain(500))[1];
  EXPECT_NEAR(time_at(trapezoid, 2.5), 0.1, 1e-12);  // a t^2 / 2
  EXPECT_NEAR(time_at(trapezoid, 10), 0.2, 1e-12);
  EXPECT_NEAR(time_at(trapezoid, 110), 1.2, 1e-12);
  EXPECT_NEAR(time_at(trapezoid, 197.5), 2.1, 1e-12);
  const MoveTime curve = machine_time({rapid(0, 0), line(200, 0, 6000)}, plain(500, 5000))[1];
  EXPECT_NEAR(time_at(curve, 5000 * 0.001 / 6), 0.1, 1e-9);  // j t^3 / 6
  EXPECT_NEAR(time_at(curve, 100), curve.duration / 2, 1e-9);
  EXPECT_NEAR(time_at(curve, 200 - 5000 * 0.001 / 6), curve.duration - 0.1, 1e-9);
}

TEST(MachineTime, TakesNoTimeWhereNothingMoves) {
  const std::vector<MoveTime> times = machine_time(
      {line(7, 7, 0), line(7, 7, 100), line(17, 7, 600), line(17, 7, 100)}, plain(1e9));
  EXPECT_EQ(times[0].duration, 0);
  EXPECT_EQ(times[1].duration, 0);
  EXPECT_NEAR(times[2].duration, 1, 1e-6);
  EXPECT_EQ(times[3].duration, 0);
  EXPECT_NEAR(times[3].start, 1, 1e-6);
  EXPECT_TRUE(machine_time({}, plain(500)).empty());
}

TEST(MachineTime, RefusesWhatIsNoMachineAndNoPath) {
  const std::vector<Move> moves{rapid(0, 0), line(10, 0, 600)};
  const auto refused = [&](auto change) {
    MachineProfile profile = plain(500);
    change(profile);
    EXPECT_THROW(machine_time(moves, profile), std::invalid_argument);
  };
  refused([](MachineProfile& p) { p.max_feed[1] = 0; });
  refused([](MachineProfile& p) { p.max_accel[2] = -1; });
  refused([](MachineProfile& p) { p.max_accel[2] = kNan; });
  refused([](MachineProfile& p) { p.max_jerk = -1; });
  refused([](MachineProfile& p) { p.centripetal_accel = kNan; });
  refused([](MachineProfile& p) { p.junction_deviation = -1; });
  refused([](MachineProfile& p) { p.block_rate = -1; });
  refused([](MachineProfile& p) { p.look_ahead = -1; });
  refused([](MachineProfile& p) { p.rapid_feed = 0; });
  try {
    machine_time({rapid(0, 0), line(1, 0, 600), line(2, 0, 0)}, plain(500));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "Move 2 has no feed above 0 mm/min: give it one.");
  }
  EXPECT_THROW(machine_time({rapid(0, 0), line(kNan, 0, 600)}, plain(500)), std::invalid_argument);
  EXPECT_THROW(programmed_time(moves, 0), std::invalid_argument);
}

TEST(MachineTime, PlansAHundredThousandMovesInATenthOfASecond) {
  std::vector<Move> moves{rapid(0, 0)};
  for (int i = 1; i <= 100000; ++i) {
    const double angle = i * 0.01, radius = 10 + i * 1e-3;
    moves.push_back(line(radius * std::cos(angle), radius * std::sin(angle), 1000 + i % 7));
  }
  for (const double jerk : {0.0, 50000.0}) {
    MachineProfile profile = plain(500, jerk);
    profile.junction_deviation = 0.01;
    profile.centripetal_accel = 500;
    double best = 1e9;
    for (int run = 0; run < 3; ++run) {
      const auto start = std::chrono::steady_clock::now();
      EXPECT_GT(total(moves, profile), programmed_time(moves, 5000) * 0.999);
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
      best = std::min(best, taken.count());
    }
    std::printf("100000 moves, jerk %g: %.3f s\n", jerk, best);
    EXPECT_LT(best, 1);  // ten times what an optimised build takes, for builds with sanitizers
  }
}

}  // namespace
}  // namespace evenload
