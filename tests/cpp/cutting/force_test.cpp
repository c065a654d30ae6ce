#include "cutting/force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "geometry/vec2.h"
#include "judge/numbers.h"

namespace evenload {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const ForceCoefficients kAluminium{600.46, 180.96, 17.9, 20.42};
const ForceCoefficients kNoEdge{600, 200, 0, 0};

CuttingForce force_of(const ForceModel& model, const std::vector<EngagedArc>& arcs,
                      double feed_per_tooth, double spindle_speed = 6000, double feed_angle = 0) {
  return model.force(arcs.data(), arcs.size(), feed_per_tooth, spindle_speed, feed_angle);
}

// The arc of a climb cut (material on the right) or a conventional one at engagement `angle`.
EngagedArc climb(double angle, double depth) { return {-kPi / 2, -kPi / 2 + angle, depth}; }
EngagedArc conventional(double angle, double depth) { return {kPi / 2 - angle, kPi / 2, depth}; }
EngagedArc slot(double depth) { return {-kPi / 2, kPi / 2, depth}; }

struct Sum {
  double x = 0, y = 0, torque = 0;
};

// The force at one position of the tool, tooth by tooth and slice by slice: no closed form in it.
Sum brute_force(const ForceCoefficients& k, double radius, int teeth, double helix,
                const std::vector<EngagedArc>& arcs, double f_z, double tip) {
  Sum sum;
  for (const EngagedArc& arc : arcs) {
    for (int tooth = -3 * teeth; tooth <= 3 * teeth; ++tooth) {
      const double own = tip + 2 * kPi * tooth / teeth;
      const double lag = std::tan(helix) / radius;
      double bottom = 0, top = arc.depth;
      if (lag > 0) {
        bottom = std::max(bottom, (arc.low - own) / lag);
        top = std::min(top, (arc.high - own) / lag);
      } else if (own < arc.low || own > arc.high) {
        continue;
      }
      if (top <= bottom) continue;
      constexpr int kSlices = 60;
      const double dz = (top - bottom) / kSlices;
      for (int i = 0; i < kSlices; ++i) {
        const double a = own + lag * (bottom + (i + 0.5) * dz);
        const double h = f_z * std::cos(a);
        const double tangential = (k.ktc * h + k.kte) * dz, radial = (k.krc * h + k.kre) * dz;
        sum.x += tangential * std::sin(a) + radial * std::cos(a);
        sum.y += -tangential * std::cos(a) + radial * std::sin(a);
        sum.torque += tangential * radius * 1e-3;
      }
    }
  }
  return sum;
}

CuttingForce brute_revolution(const ForceCoefficients& k, double radius, int teeth, double helix,
                              const std::vector<EngagedArc>& arcs, double f_z, int positions) {
  CuttingForce result;
  const auto look = [&](double tip, double share) {
    const Sum sum = brute_force(k, radius, teeth, helix, arcs, f_z, tip);
    const double xy = std::hypot(sum.x, sum.y);
    result.peak_x = std::max(result.peak_x, std::abs(sum.x));
    result.peak_y = std::max(result.peak_y, std::abs(sum.y));
    result.peak_xy = std::max(result.peak_xy, xy);
    result.peak_torque = std::max(result.peak_torque, sum.torque);
    result.mean_x += share * sum.x;
    result.mean_y += share * sum.y;
    result.mean_xy += share * xy;
    result.mean_torque += share * sum.torque;
  };
  for (int i = 0; i < positions; ++i)
    look((i + 0.5) / positions * 2 * kPi / teeth, 1.0 / positions);
  for (const EngagedArc& arc : arcs)  // just beside where a tooth enters or leaves: for the peaks
    for (const double lag : {0.0, std::tan(helix) / radius * arc.depth})
      for (const double end : {arc.low, arc.high})
        for (const double side : {-1e-7, 1e-7})
          look(std::remainder(end - lag + side, 2 * kPi / teeth), 0);
  return result;
}

void expect_near(const CuttingForce& a, const CuttingForce& b, double share) {
  const double force = share * std::max({a.peak_xy, b.peak_xy, 1e-9});
  const double torque = share * std::max({a.peak_torque, b.peak_torque, 1e-9});
  EXPECT_NEAR(a.peak_x, b.peak_x, force);
  EXPECT_NEAR(a.peak_y, b.peak_y, force);
  EXPECT_NEAR(a.peak_xy, b.peak_xy, force);
  EXPECT_NEAR(a.mean_x, b.mean_x, force);
  EXPECT_NEAR(a.mean_y, b.mean_y, force);
  EXPECT_NEAR(a.mean_xy, b.mean_xy, force);
  EXPECT_NEAR(a.peak_torque, b.peak_torque, torque);
  EXPECT_NEAR(a.mean_torque, b.mean_torque, torque);
}

EngagedArc random_arc(std::mt19937& random) {
  const double a = uniform(random, -kPi / 2, kPi / 2), b = uniform(random, -kPi / 2, kPi / 2);
  return {std::min(a, b), std::max(a, b), uniform(random, 0.05, 12)};
}

TEST(CuttingForce, IsNothingWithoutEngagement) {
  const ForceModel model(kAluminium, 3, 2, 30 * kDegree);
  for (const std::vector<EngagedArc>& arcs : std::vector<std::vector<EngagedArc>>{
           {}, {{0.3, 0.3, 5}}, {{-1, 1, 0}}, {{0.3, 0.3, 5}, {-1, 1, 0}}}) {
    const CuttingForce f = force_of(model, arcs, 0.05);
    for (const double value : {f.peak_x, f.peak_y, f.peak_xy, f.mean_x, f.mean_y, f.mean_xy,
                               f.peak_torque, f.mean_torque, f.mean_power})
      EXPECT_EQ(value, 0);
  }
}

TEST(CuttingForce, OfOneStraightToothIsTheClosedFormOfTheStraightCut) {
  // Climb: the chip is thickest where the tooth enters, h = f_z sin(theta), and thins out. The
  // peak of xy and torque is there.
  const double theta = 60 * kDegree, depth = 3, f_z = 0.04;
  const ForceModel model(kAluminium, 3, 1, 0);
  const CuttingForce f = force_of(model, {climb(theta, depth)}, f_z);
  const double h = f_z * std::sin(theta);
  const double tangential = (kAluminium.ktc * h + kAluminium.kte) * depth;
  const double radial = (kAluminium.krc * h + kAluminium.kre) * depth;
  EXPECT_NEAR(f.peak_xy, std::hypot(tangential, radial), 1e-9);
  EXPECT_NEAR(f.peak_torque, tangential * 3e-3, 1e-12);
}

TEST(CuttingForce, OfTheStarsStraightCutIsTheMeasured99Newtons) {
  // One tooth of 6 mm, 3 mm deep, 60 degrees climb, 0.04 mm per tooth [Jacsó 2021]; the
  // coefficients are those of "Star test piece" in Resources/materials.json, which this cut
  // calibrates.
  const ForceModel model({1169.3, 389.8, 0, 0}, 3, 1, 30 * kDegree);
  EXPECT_NEAR(force_of(model, {climb(60 * kDegree, 3)}, 0.04, 6366).peak_xy, 99, 0.5);
}

TEST(CuttingForce, AveragesToTheClosedFormsOfMilling) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    const EngagedArc arc = random_arc(random);
    const int teeth = 1 + static_cast<int>(uniform(random, 0, 6));
    const double radius = uniform(random, 1, 10), f_z = uniform(random, 0.01, 0.2);
    const ForceModel model(kAluminium, radius, teeth, uniform(random, 0, 1));
    const CuttingForce f = force_of(model, {arc}, f_z);
    // Immersion phi is counted from the feed's left normal the way the tool turns, as in the
    // textbooks: h = f_z sin(phi).
    const double entry = kPi / 2 - arc.high, exit = kPi / 2 - arc.low;
    const auto [ktc, krc, kte, kre] = kAluminium;
    const double scale = teeth * arc.depth / (2 * kPi);
    const auto x_integral = [&, ktc = ktc, krc = krc, kte = kte, kre = kre](double phi) {
      return f_z * (-ktc * std::cos(2 * phi) / 4 + krc * (2 * phi - std::sin(2 * phi)) / 4) +
             kte * std::sin(phi) - kre * std::cos(phi);
    };
    const auto y_integral = [&, ktc = ktc, krc = krc, kte = kte, kre = kre](double phi) {
      return f_z * (-ktc * (2 * phi - std::sin(2 * phi)) / 4 - krc * std::cos(2 * phi) / 4) +
             kte * std::cos(phi) + kre * std::sin(phi);
    };
    const double size = scale * (ktc * f_z + kte + kre);
    EXPECT_NEAR(f.mean_x, scale * (x_integral(exit) - x_integral(entry)), 1e-12 * size);
    EXPECT_NEAR(f.mean_y, scale * (y_integral(exit) - y_integral(entry)), 1e-12 * size);
    EXPECT_NEAR(f.mean_torque,
                scale * radius * 1e-3 *
                    (ktc * f_z * (std::cos(entry) - std::cos(exit)) + kte * (exit - entry)),
                1e-12 * size * radius);
  }
}

TEST(CuttingForce, OfASlotPushesTheWorkpieceForwardsAndToTheRight) {
  // The chip's tangential part works across the feed, its radial part along it.
  const ForceModel model(kNoEdge, 4, 2, 0.6);
  const CuttingForce f = force_of(model, {slot(4)}, 0.1);
  EXPECT_NEAR(f.mean_x, 2 * 4 * 200 * 0.1 / 4, 1e-9);
  EXPECT_NEAR(f.mean_y, -2 * 4 * 600 * 0.1 / 4, 1e-9);
}

TEST(CuttingForce, OfClimbAndConventionalCutsAddsUpToThatOfTheSlot) {
  const ForceModel model(kAluminium, 4, 3, 0.5);
  const CuttingForce right = force_of(model, {climb(kPi / 2, 3)}, 0.1);
  const CuttingForce left = force_of(model, {conventional(kPi / 2, 3)}, 0.1);
  const CuttingForce both = force_of(model, {slot(3)}, 0.1);
  EXPECT_NEAR(right.mean_x + left.mean_x, both.mean_x, 1e-9);
  EXPECT_NEAR(right.mean_y + left.mean_y, both.mean_y, 1e-9);
  EXPECT_NEAR(right.mean_torque, left.mean_torque, 1e-12);
  EXPECT_NEAR(right.mean_torque + left.mean_torque, both.mean_torque, 1e-12);
}

TEST(CuttingForce, IsWhatThinSlicesAddUpTo) {
  std::mt19937 random(2);
  for (int i = 0; i < 150; ++i) {
    std::vector<EngagedArc> arcs{random_arc(random)};
    if (i % 3 == 0) {  // a second one beside it, of another depth
      const double low = arcs[0].low, high = arcs[0].high, middle = (low + high) / 2;
      arcs[0].high = middle - 0.3 * (middle - low);
      arcs.push_back({middle, high, uniform(random, 0.05, 12)});
    }
    const int teeth = 1 + static_cast<int>(uniform(random, 0, 5));
    const double radius = uniform(random, 1, 10);
    const double helix = i % 5 == 0 ? 0 : uniform(random, 0.02, 1);
    const double f_z = uniform(random, 0.005, 0.2);
    const ForceCoefficients& k = i % 2 ? kAluminium : kNoEdge;
    SCOPED_TRACE(i);
    const CuttingForce f = force_of(ForceModel(k, radius, teeth, helix), arcs, f_z);
    const CuttingForce brute = brute_revolution(k, radius, teeth, helix, arcs, f_z, 4000);
    expect_near(f, brute, kPeakShare);
    EXPECT_GT(f.peak_xy, brute.peak_xy * (1 - kPeakShare));
    EXPECT_GT(f.peak_torque, brute.peak_torque * (1 - kPeakShare));
    EXPECT_GE(f.peak_xy, f.mean_xy * (1 - 1e-9));
    EXPECT_GE(f.peak_torque, f.mean_torque * (1 - 1e-9));
  }
}

TEST(CuttingForce, HasPeaksWithinTheirShareAlsoOfShallowAndNarrowCuts) {
  // The hardest cases: pieces of the revolution in which the force goes from nothing to nothing.
  std::mt19937 random(3);
  for (int i = 0; i < 60; ++i) {
    const double width = std::pow(10, uniform(random, -3, -1));
    const double depth = std::pow(10, uniform(random, -2, 1));
    const std::vector<EngagedArc> arcs{i % 2 ? climb(width, depth) : conventional(width, depth)};
    const double helix = uniform(random, 0.1, 0.9);
    const CuttingForce f = force_of(ForceModel(kNoEdge, 3, 2, helix), arcs, 0.05);
    CuttingForce brute;  // over the angles at which something is engaged, and no others
    const double from = arcs[0].low - std::tan(helix) / 3 * depth, to = arcs[0].high;
    for (int j = 0; j <= 3000; ++j) {
      const Sum sum = brute_force(kNoEdge, 3, 2, helix, arcs, 0.05, from + (to - from) * j / 3000);
      brute.peak_xy = std::max(brute.peak_xy, std::hypot(sum.x, sum.y));
      brute.peak_torque = std::max(brute.peak_torque, sum.torque);
    }
    EXPECT_NEAR(f.peak_xy, brute.peak_xy, kPeakShare * brute.peak_xy);
    EXPECT_NEAR(f.peak_torque, brute.peak_torque, kPeakShare * brute.peak_torque);
  }
}

TEST(CuttingForce, HasMeanPowerEqualToMeanTorqueTimesAngularSpeed) {
  std::mt19937 random(4);
  for (int i = 0; i < 100; ++i) {
    const double speed = uniform(random, 0, 30000);
    const CuttingForce f =
        force_of(ForceModel(kAluminium, 3, 2, 0.5), {random_arc(random)}, 0.05, speed);
    EXPECT_NEAR(f.mean_power, f.mean_torque * speed * 2 * kPi / 60, 1e-9 * (1 + f.mean_power));
  }
}

TEST(CuttingForce, SpendsThePowerOfTheSpecificForceTimesTheRemovalRate) {
  // Without edge terms the work per volume is ktc, whatever is engaged and however.
  std::mt19937 random(5);
  for (int i = 0; i < 100; ++i) {
    const double theta = uniform(random, 0.1, kPi), depth = uniform(random, 0.1, 10);
    const double radius = uniform(random, 1, 8), f_z = uniform(random, 0.01, 0.1);
    const int teeth = 1 + static_cast<int>(uniform(random, 0, 4));
    const CuttingForce f =
        force_of(ForceModel(kNoEdge, radius, teeth, 0.6), {climb(theta, depth)}, f_z, 6000);
    const double rate = radius * (1 - std::cos(theta)) * depth * f_z * teeth * 6000 / 60;  // mm^3/s
    EXPECT_NEAR(f.mean_power, 600 * rate * 1e-3, 1e-9 * f.mean_power);
  }
}

TEST(CuttingForce, DoublesWithTheDepthOfStraightFlutes) {
  std::mt19937 random(6);
  const ForceModel model(kAluminium, 3, 3, 0);
  for (int i = 0; i < 100; ++i) {
    const EngagedArc arc = random_arc(random);
    const CuttingForce once = force_of(model, {arc}, 0.05);
    const CuttingForce twice = force_of(model, {{arc.low, arc.high, 2 * arc.depth}}, 0.05);
    EXPECT_NEAR(twice.peak_xy, 2 * once.peak_xy, 1e-9 * twice.peak_xy);
    EXPECT_NEAR(twice.mean_xy, 2 * once.mean_xy, 1e-9 * twice.peak_xy);
    EXPECT_NEAR(twice.peak_torque, 2 * once.peak_torque, 1e-9 * twice.peak_torque);
  }
}

TEST(CuttingForce, IsConstantWhereTheDepthIsAMultipleOfPitchOverTeeth) {
  std::mt19937 random(7);
  for (int teeth = 1; teeth <= 4; ++teeth) {
    for (int multiple = 1; multiple <= 3; ++multiple) {
      const double radius = 4, helix = 35 * kDegree;
      const double pitch = 2 * kPi * radius / std::tan(helix);
      EngagedArc arc = random_arc(random);
      arc.depth = multiple * pitch / teeth;
      const CuttingForce f = force_of(ForceModel(kAluminium, radius, teeth, helix), {arc}, 0.05);
      EXPECT_NEAR(f.peak_xy, std::hypot(f.mean_x, f.mean_y), 1e-9 * f.peak_xy);
      EXPECT_NEAR(f.mean_xy, f.peak_xy, 1e-9 * f.peak_xy);
      EXPECT_NEAR(f.peak_torque, f.mean_torque, 1e-9 * f.peak_torque);
    }
  }
}

TEST(CuttingForce, OfArcsSideBySideIsThatOfOneArc) {
  std::mt19937 random(8);
  for (int i = 0; i < 200; ++i) {
    const EngagedArc arc = random_arc(random);
    const double cut = uniform(random, arc.low, arc.high);
    const int teeth = 1 + i % 4;
    const ForceModel model(kAluminium, 3, teeth, i % 5 == 0 ? 0 : uniform(random, 0.05, 0.8));
    const CuttingForce whole = force_of(model, {arc}, 0.05);
    const CuttingForce parts =
        force_of(model, {{arc.low, cut, arc.depth}, {cut, arc.high, arc.depth}}, 0.05);
    EXPECT_NEAR(parts.mean_x, whole.mean_x, 1e-9 * whole.peak_xy);
    EXPECT_NEAR(parts.mean_y, whole.mean_y, 1e-9 * whole.peak_xy);
    EXPECT_NEAR(parts.mean_torque, whole.mean_torque, 1e-9 * whole.peak_torque);
    expect_near(parts, whole, kPeakShare);
  }
}

TEST(CuttingForce, CountsNoToothTwiceWhereOneLeavesAsTheNextEnters) {
  // Straight flutes half a turn apart in a slot: one tooth is engaged at any time.
  const CuttingForce f = force_of(ForceModel(kAluminium, 3, 2, 0), {slot(3)}, 0.05);
  EXPECT_NEAR(f.peak_torque, 3e-3 * 3 * (kAluminium.ktc * 0.05 + kAluminium.kte), 1e-12);
  // and four of them in a quarter turn likewise.
  const CuttingForce quarter = force_of(ForceModel(kAluminium, 3, 4, 0), {climb(kPi / 2, 3)}, 0.05);
  EXPECT_NEAR(quarter.peak_torque, 3e-3 * 3 * (kAluminium.ktc * 0.05 + kAluminium.kte), 1e-12);
}

TEST(CuttingForce, CountsNoToothTwiceWhereverAnArcIsAsWideAsThePitchOfTheTeeth) {
  std::mt19937 random(10);
  for (int i = 0; i < 500; ++i) {
    const int teeth = 3 + i % 5;
    const double pitch = 2 * kPi / teeth;
    const double low = uniform(random, -kPi / 2, kPi / 2 - pitch);  // and what rounding adds
    const CuttingForce f =
        force_of(ForceModel(kAluminium, 3, teeth, 0), {{low, low + pitch + 1e-12, 3}}, 0.05);
    const double one = 3e-3 * 3 * (kAluminium.ktc * 0.05 + kAluminium.kte);
    EXPECT_LE(f.peak_torque, one * (1 + 1e-12));
  }
}

TEST(CuttingForce, HasStraightFlutesAsTheLimitOfAVanishingHelix) {
  std::mt19937 random(9);
  for (int i = 0; i < 50; ++i) {
    const EngagedArc arc = random_arc(random);
    const CuttingForce straight = force_of(ForceModel(kAluminium, 3, 2, 0), {arc}, 0.05);
    for (const double helix : {1e-10, 1e-9, 1e-8, 1e-7, 1e-6}) {
      const CuttingForce f = force_of(ForceModel(kAluminium, 3, 2, helix), {arc}, 0.05);
      EXPECT_NEAR(f.peak_xy, straight.peak_xy, 1e-4 * straight.peak_xy);
      EXPECT_NEAR(f.mean_xy, straight.mean_xy, 1e-4 * straight.peak_xy);
      EXPECT_NEAR(f.peak_torque, straight.peak_torque, 1e-4 * straight.peak_torque);
    }
  }
}

TEST(CuttingForce, TurnsWithTheFeed) {
  const ForceModel model(kAluminium, 3, 2, 0.5);
  const std::vector<EngagedArc> arcs{climb(1.2, 4)};
  const CuttingForce f = force_of(model, arcs, 0.05);
  const CuttingForce left = force_of(model, arcs, 0.05, 6000, kPi / 2);
  EXPECT_NEAR(left.mean_x, -f.mean_y, 1e-9);
  EXPECT_NEAR(left.mean_y, f.mean_x, 1e-9);
  EXPECT_NEAR(left.peak_x, f.peak_y, 1e-9);
  EXPECT_NEAR(left.peak_y, f.peak_x, 1e-9);
  const CuttingForce turned = force_of(model, arcs, 0.05, 6000, 0.7);
  EXPECT_NEAR(turned.mean_x, std::cos(0.7) * f.mean_x - std::sin(0.7) * f.mean_y, 1e-9);
  EXPECT_NEAR(turned.peak_xy, f.peak_xy, 1e-9);
  EXPECT_NEAR(turned.mean_xy, f.mean_xy, 1e-9);
}

TEST(CuttingForce, RefusesWhatIsNoToolAndNoCut) {
  const auto model = [](double radius, int teeth, double helix, ForceCoefficients k = kAluminium) {
    return ForceModel(k, radius, teeth, helix);
  };
  EXPECT_THROW(model(0, 2, 0.5), std::invalid_argument);
  EXPECT_THROW(model(kNan, 2, 0.5), std::invalid_argument);
  EXPECT_THROW(model(3, 0, 0.5), std::invalid_argument);
  EXPECT_THROW(model(3, 2, -0.1), std::invalid_argument);
  EXPECT_THROW(model(3, 2, kPi / 2), std::invalid_argument);
  EXPECT_THROW(model(3, 2, kNan), std::invalid_argument);
  EXPECT_THROW(model(3, 2, 0.5, {-1, 0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(model(3, 2, 0.5, {600, 200, kNan, 0}), std::invalid_argument);
  const ForceModel good = model(3, 2, 0.5);
  EXPECT_THROW(force_of(good, {{1, -1, 3}}, 0.05), std::invalid_argument);
  EXPECT_THROW(force_of(good, {{-2, 0, 3}}, 0.05), std::invalid_argument);
  EXPECT_THROW(force_of(good, {{0, 2, 3}}, 0.05), std::invalid_argument);
  EXPECT_THROW(force_of(good, {{0, 1, -3}}, 0.05), std::invalid_argument);
  EXPECT_THROW(force_of(good, {{0, kNan, 3}}, 0.05), std::invalid_argument);
  EXPECT_THROW(force_of(good, {{0, 1, 3}}, -0.05), std::invalid_argument);
  EXPECT_THROW(force_of(good, {{0, 1, 3}}, 0.05, -1), std::invalid_argument);
  EXPECT_THROW(force_of(good, {{0, 1, 3}}, 0.05, 6000, kNan), std::invalid_argument);
}

TEST(CuttingForce, TakesFewMicroseconds) {
  const ForceModel star(kAluminium, 3, 1, 30 * kDegree), four(kAluminium, 3, 4, 30 * kDegree);
  const auto seconds = [](const ForceModel& model, const EngagedArc& arc) {
    double best = 1e9, sum = 0;
    for (int run = 0; run < 5; ++run) {
      const auto start = std::chrono::steady_clock::now();
      for (int i = 0; i < 2000; ++i) sum += model.force(&arc, 1, 0.04 + 1e-6 * i, 6366).peak_xy;
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
      best = std::min(best, taken.count() / 2000);
    }
    EXPECT_GT(sum, 0);
    return best;
  };
  const double one = seconds(star, climb(kPi / 3, 3)), deep = seconds(four, slot(12));
  std::printf("one tooth, 60 degrees: %.2f us; four teeth, slot: %.2f us\n", 1e6 * one, 1e6 * deep);
  // Ten times what an optimised build takes, for builds with sanitizers.
  EXPECT_LT(one, 25e-6);
  EXPECT_LT(deep, 50e-6);
}

}  // namespace
}  // namespace evenload
