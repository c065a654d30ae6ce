#include "feed/load_share.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "cutting/engagement.h"
#include "judge/numbers.h"

namespace evenload {
namespace {

using Arcs = std::vector<AngularInterval>;

// What a look at these arcs says, but for the share.
Load load_of(const Arcs& arcs) {
  Load load;
  for (const AngularInterval& arc : arcs) {
    load.engagement += arc.width();
    load.width += kRadius * (std::sin(arc.high) - std::sin(arc.low));
    // In small steps: the largest cosine without a thought.
    for (int i = 0; i <= 1000; ++i)
      load.chip = std::max(load.chip, std::cos(arc.low + i / 1000.0 * arc.width()));
  }
  return load;
}

double share_of(const LoadShare& share, const Arcs& arcs) { return share(load_of(arcs), arcs); }

Arcs straight(double angle) { return {{-kPi / 2, angle - kPi / 2}}; }

// One arc, or two.
Arcs random_arcs(std::mt19937& random) {
  const double a = uniform(random, -kPi / 2, kPi / 2), b = uniform(random, a, kPi / 2);
  if (random() % 3) return {{a, b}};
  const double c = uniform(random, b, kPi / 2), d = uniform(random, c, kPi / 2);
  return {{a, b}, {c, d}};
}

// The third has edges that take a good part of the force.
const ForceCoefficients kMaterials[] = {
    {1169.3, 389.8, 0, 0}, {600, 200, 0, 0}, {243.77, 113.5, 7.53, 7.83}};

double peak(const ForceTask& task, const Arcs& arcs, double feed, double depth) {
  const ForceModel model(task.coefficients, kRadius, task.teeth, task.helix_angle);
  std::vector<EngagedArc> engaged;
  for (const AngularInterval& arc : arcs)
    engaged.push_back(task.mirrored ? EngagedArc{-arc.high, -arc.low, depth}
                                    : EngagedArc{arc.low, arc.high, depth});
  return model
      .force(engaged.data(), engaged.size(), feed / (task.teeth * task.spindle_speed),
             task.spindle_speed)
      .peak_xy;
}

TEST(LoadShare, OfAStraightCutAtTheEngagementAngleIsOne) {
  for (double angle = 15 * kDegree; angle < 170 * kDegree; angle += 5 * kDegree) {
    EXPECT_NEAR(share_of(removal_rate_share(angle, kRadius), straight(angle)),
                1 / rate_margin(angle), 1e-12);
    EXPECT_NEAR(share_of(chip_thickness_share(angle), straight(angle)), 1, 1e-9);
    ForceTask task;
    task.coefficients = kMaterials[2];
    EXPECT_NEAR(share_of(force_share(angle, kRadius, task), straight(angle)), 1,
                10 * kForceTolerance);
  }
}

// Law: were the engagement larger by 0.3 degrees, the rate would be at its limit; the nominal feed
// is allowed in any case.
TEST(LoadShare, KeepsTheRateAtItsLimitWithALittleMoreEngagement) {
  for (double angle = 5 * kDegree; angle < 170 * kDegree; angle += 5 * kDegree) {
    const double feed = 1 / share_of(removal_rate_share(angle, kRadius), straight(angle));
    const double rate =
        feed * side_step(angle + 0.3 * kDegree, kRadius) / side_step(angle, kRadius);
    EXPECT_GE(feed, 1);
    if (feed > 1) {
      EXPECT_NEAR(rate, kMostRate, 1e-9);
    }
  }
}

TEST(LoadShare, AllowsNoChipThickerThanNominal) {
  std::mt19937 random(11);
  for (int i = 0; i < 2000; ++i) {
    const double angle = uniform(random, 0.1, 3);
    const Arcs arcs = random_arcs(random);
    const double nominal = angle < kPi / 2 ? std::sin(angle) : 1;
    const double share = share_of(chip_thickness_share(angle), arcs);
    EXPECT_LE(load_of(arcs).chip / share, nominal * (1 + 1e-9));
    // Nor is more held back than kArcDoubt asks for.
    const double most = std::sin(std::min(kPi / 2, std::asin(load_of(arcs).chip) + kArcDoubt));
    EXPECT_LE(share, std::max(load_of(arcs).chip / nominal, most / nominal) * (1 + 1e-5));
  }
}

TEST(LoadShare, AllowsNoForceAboveNominalWhateverTheEdgesTake) {
  std::mt19937 random(12);
  int held = 0, capped = 0;
  for (int i = 0; i < 600; ++i) {
    ForceTask task;
    task.coefficients = kMaterials[i % 3];
    task.teeth = 1 + i % 4;
    task.helix_angle = i % 5 ? uniform(random, 0, 0.8) : 0;
    task.depths = {3.0, 1.2};
    task.mirrored = i % 2;
    const double angle = uniform(random, 0.2, 2.5);
    const LoadShare share = force_share(angle, kRadius, task);
    const Arcs arcs = random_arcs(random);
    const double found = share_of(share, arcs);
    ASSERT_GE(found, task.feed / task.maximum_feed);
    if (found >= 1 / kLeastForceFeed) {
      ++capped;
      continue;
    }
    for (const double depth : task.depths)
      EXPECT_LE(peak(task, arcs, task.feed / found, depth),
                peak(task, straight(angle), task.feed, depth) * (1 + 1e-9));
    held += found > task.feed / task.maximum_feed;
  }
  EXPECT_GT(held, 100);
  EXPECT_GT(capped, 0);
}

TEST(LoadShare, OfALongForceArcComesNearToTheNominalForce) {
  // Arcs of about the nominal size: their doubt costs little.
  for (const ForceCoefficients& material : kMaterials) {
    ForceTask task;
    task.coefficients = material;
    task.teeth = 2;
    const LoadShare share = force_share(60 * kDegree, kRadius, task);
    for (double angle = 50; angle <= 90; angle += 5) {
      const double feed = task.feed / share_of(share, straight(angle * kDegree));
      const double nominal = peak(task, straight(60 * kDegree), task.feed, 3);
      if (feed < 0.999 * task.maximum_feed) {
        EXPECT_GT(peak(task, straight(angle * kDegree), feed, 3), 0.98 * nominal) << angle;
      }
    }
  }
}

TEST(LoadShare, IsLargerWhereAnArcIsShortThanTheArcAloneWouldHaveIt) {
  const LoadShare share = chip_thickness_share(60 * kDegree);
  EXPECT_GT(share_of(share, straight(10 * kDegree)),
            1.1 * std::sin(10 * kDegree) / std::sin(60 * kDegree));
  EXPECT_LT(share_of(share, straight(50 * kDegree)),
            1.02 * std::sin(50 * kDegree) / std::sin(60 * kDegree));
}

TEST(LoadShare, RefusesAForceThatCannotBeKnown) {
  ForceTask task;
  task.coefficients = kMaterials[0];
  for (const auto& spoil : std::vector<void (*)(ForceTask&)>{
           [](ForceTask& t) { t.spindle_speed = 0; }, [](ForceTask& t) { t.teeth = 0; },
           [](ForceTask& t) { t.coefficients = {}; }, [](ForceTask& t) { t.helix_angle = 2; },
           [](ForceTask& t) { t.coefficients.ktc = -1; }}) {
    ForceTask spoiled = task;
    spoil(spoiled);
    EXPECT_THROW(force_share(1, kRadius, spoiled), std::invalid_argument);
  }
  EXPECT_NO_THROW(force_share(1, kRadius, task));
}

}  // namespace
}  // namespace evenload
