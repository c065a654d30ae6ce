// Laws of the trochoidal patterns: that of constant engagement, the circular one, the cycloid.
#include "strategy/trochoid/trochoid_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "cutting/engagement.h"
#include "strategy/moves/move_ends.h"
#include "strategy/reach/links.h"
#include "strategy/trochoid/circular_trochoid.h"
#include "strategy/trochoid/slot_pattern.h"

namespace evenload {
namespace {

constexpr TrochoidKind kKinds[] = {TrochoidKind::kConstantEngagement, TrochoidKind::kCircular,
                                   TrochoidKind::kCycloid};

// Tool 6 mm; `width` in its diameters.
TrochoidParams slot(double width, double degrees, double curvature = 0) {
  TrochoidParams params;
  params.width = 6 * width;
  params.engagement = degrees * kDegree;
  params.curvature = curvature;
  params.turn_radius = 1;
  return params;
}

// rad: the most that a circle meets which is `step` mm ahead of the one before, by the cosine
// theorem: from the place outside, on the line through its own centre, to where the tool's circle
// crosses the border that the circle before has left.
double peak_of_circle(const TrochoidParams& params, double step) {
  const double room = half_room(params), r = params.tool_radius, border = 0.5 * params.width;
  double peak = 0;
  for (double turned = -kPi / 2; turned <= kPi / 2; turned += 1e-4) {
    const Vec2 from_before = Vec2{step, 0} + room * unit(turned);
    const double d = norm(from_before);
    const double cosine = (border * border - d * d - r * r) / (2 * d * r);
    if (std::abs(cosine) > 1) continue;
    peak = std::max(peak, angle_of(from_before) + std::acos(cosine) - turned);
  }
  return peak;
}

TEST(TrochoidPattern, OfCirclesHasTheStepOfTheClosedForm) {
  for (const double width : {1.25, 1.5, 2.0, 3.0})
    for (const double degrees : {30.0, 60.0, 90.0}) {
      const TrochoidParams params = slot(width, degrees);
      const auto pattern = circular_pattern(params);
      ASSERT_TRUE(pattern);
      double low = 0, high = 6;
      while (high - low > 1e-6) {
        const double middle = 0.5 * (low + high);
        (peak_of_circle(params, middle) > most_engagement(params) ? high : low) = middle;
      }
      EXPECT_NEAR(pattern->step, low, 0.01 * low) << width << " " << degrees;
    }
}

void expect_joined(const Segment& a, const Segment& b) {
  EXPECT_LT(distance(a.b, b.a), 1e-6);
  // Circles and cycloids are joined by bi-arcs, whose directions are rounded.
  // Posts turn pieces far shorter than their rounding by as much as a quarter of a degree.
  EXPECT_LT(norm(a.tangent(1) - b.tangent(0)), 5e-3);
}

TEST(TrochoidPattern, IsTangentStaysInTheSlotAndKeepsTheLimitOnceItRepeats) {
  for (const TrochoidKind kind : kKinds)
    for (const double width : {1.1, 1.25, 1.5, 2.0, 3.0})
      for (const double degrees : {30.0, 60.0, 90.0, 120.0})
        for (const double curvature : {0.0, 0.03, -0.03}) {
          const TrochoidParams params = slot(width, degrees, curvature);
          const auto pattern = make_pattern(kind, params);
          const std::string name = std::to_string(static_cast<int>(kind)) + " " +
                                   std::to_string(width) + " " + std::to_string(degrees) + " " +
                                   std::to_string(curvature);
          if (!pattern && width < 1.25 && degrees < 60) continue;  // hardly advances
          ASSERT_TRUE(pattern) << name;
          SCOPED_TRACE(name);
          EXPECT_LE(figures_of(*pattern, params).max_engagement, most_engagement(params) + 1e-9);
          std::vector<Segment> period = pattern->cut;
          period.insert(period.end(), pattern->link.begin(), pattern->link.end());
          period.push_back(placed(pattern->cut.front(), place_along(curvature, pattern->step)));
          const Area centres({strip_of(params, 40, 40)});
          for (std::size_t i = 1; i < period.size(); ++i) {
            expect_joined(period[i - 1], period[i]);
            for (const double t : {0.25, 0.5, 0.75, 1.0})
              EXPECT_GT(centres.signed_distance(period[i].point(t)), -1e-3);
          }
        }
}

TEST(TrochoidPattern, OfTinyCirclesHasNoMoveThatRoundingWouldTurn) {
  for (const double curvature : {0.0, 0.03, -0.03}) {
    TrochoidParams params = slot(6.2 / 6, 15, curvature);
    const auto pattern = circular_pattern(params);
    ASSERT_TRUE(pattern);
    EXPECT_LT(pattern->step, 0.02);
    std::vector<Segment> period = pattern->cut;
    period.insert(period.end(), pattern->link.begin(), pattern->link.end());
    period.push_back(placed(pattern->cut.front(), place_along(curvature, pattern->step)));
    for (std::size_t i = 1; i < period.size(); ++i) {
      EXPECT_GT(period[i].length(), 0.02);
      expect_joined(period[i - 1], period[i]);
    }
    EXPECT_LE(figures_of(*pattern, params).max_engagement, most_engagement(params) + 1e-6);
  }
}

TEST(CirclesThrough, TouchThePatternFromBehindAndHoldIt) {
  for (const double curvature : {0.0, 0.03, -0.03})
    for (const double width : {1.25, 1.5, 2.0}) {
      const TrochoidParams params = slot(width, 60, curvature);
      const double h = half_room(params);
      const auto circles = circular_pattern(params), ours = constant_engagement_pattern(params);
      ASSERT_TRUE(circles && ours);
      EXPECT_NEAR(circles_through(*circles, h).last, 0, 1e-6);
      const CirclesThrough through = circles_through(*ours, h);
      EXPECT_LT(through.first, through.last);
      const Vec2 first = place_along(curvature, through.first).p,
                 last = place_along(curvature, through.last).p;
      double nearest = 1e9, furthest = 0;
      for (const Segment& move : ours->cut)
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
          const Vec2 p = move.point(t);
          nearest = std::min(nearest, distance(p, first));
          if (dot(p - last, unit(place_along(curvature, through.last).heading)) > 0)
            furthest = std::max(furthest, distance(p, last));
        }
      EXPECT_GT(nearest, h - 2e-3);
      EXPECT_LT(furthest, h + 2e-3);
    }
}

TEST(TurnsAtCorners, AreArcsThatPostsWriteAsLines) {
  const auto turns = [](double radius, double sweep) {
    return turns_at_corners(
        {Segment::line({-1, 0}, {0, 0}), Segment::arc({0, radius}, radius, -kPi / 2, sweep)});
  };
  EXPECT_FALSE(turns_at_corners({}));
  EXPECT_FALSE(turns_at_corners({Segment::line({0, 0}, {1e-3, 0})}));
  // End points that span less than 0.005 mm^2 with the centre, to either side.
  for (const double side : {1.0, -1.0}) {
    EXPECT_TRUE(turns(0.05, side * 1.2));
    EXPECT_FALSE(turns(0.1, side * 1.2));
    EXPECT_TRUE(turns(0.1, side * 0.5));
    EXPECT_FALSE(turns(0.2, side * 0.5));
    // Longer ones do no harm, unless next to nothing is left of their radius.
    EXPECT_FALSE(turns(0.05, side * 3));
    EXPECT_TRUE(turns(0.005, side * 3));
    // Corners of less than a degree do none either.
    EXPECT_FALSE(turns(0.05, side * 0.01));
  }
}

TEST(TrochoidPattern, RemovesWidthTimesStep) {
  for (const double curvature : {0.0, 0.02, -0.02}) {
    const TrochoidParams params = slot(1.5, 60, curvature);
    const auto pattern = constant_engagement_pattern(params);
    ASSERT_TRUE(pattern);
    const PatternFigures figures = figures_of(*pattern, params);
    // Next to nothing of a cut meets no material.
    EXPECT_GE(figures.area_per_length * figures.cut_length, params.width * pattern->step - 1e-9);
    EXPECT_LE(figures.area_per_length * figures.cut_length, 1.1 * params.width * pattern->step);
    // A cut at the limit everywhere would remove the bound; none removes more.
    EXPECT_LT(figures.area_per_length, 1.01 * side_step(params.engagement, params.tool_radius));
  }
}

// The tightest turns remove most, but would be lines in a program.
TEST(TrochoidPattern, OfSmallToolsTurnsAsWidelyAsPostsNeed) {
  for (const double diameter : {2.0, 3.0})
    for (const double width : {2.0, 3.0}) {
      SCOPED_TRACE(std::to_string(diameter) + " " + std::to_string(width));
      TrochoidParams params = slot(width, 60);
      params.tool_radius = 0.5 * diameter;
      params.width = width * diameter;
      const auto pattern = constant_engagement_pattern(params);
      ASSERT_TRUE(pattern);
      EXPECT_FALSE(turns_at_corners(pattern->cut));
    }
}

TEST(TrochoidPattern, OfConstantEngagementIsFoundByPassesThatSettle) {
  for (const double width : {1.25, 1.5, 2.0, 3.0}) {
    const TrochoidParams params = slot(width, 60);
    const PassSequence sequence = iterate_passes(params, 0.4 * half_room(params), 25);
    ASSERT_GE(sequence.residuals.size(), 2u) << width;
    // Monotonically, but for what the steering's own tolerance moves a pass by.
    const double noise = 0.01 * params.tool_radius;
    for (std::size_t i = 1; i < sequence.residuals.size(); ++i)
      EXPECT_LT(sequence.residuals[i], sequence.residuals[i - 1] + noise) << width << " " << i;
    EXPECT_LT(sequence.residuals.back(), noise) << width;
    EXPECT_LT(sequence.residuals.back(), 0.2 * sequence.residuals.front()) << width;
    EXPECT_GT(sequence.advance, 0) << width;
  }
}

TEST(TrochoidPattern, OfConstantEngagementSettlesWithinThePassesThatAreMade) {
  for (const double width : {1.25, 4.0 / 3, 1.5, 11.0 / 6, 2.0, 3.0})
    for (const double degrees : {60.0, 90.0, 110.0}) {
      SCOPED_TRACE(std::to_string(width) + " " + std::to_string(degrees));
      const TrochoidParams params = slot(width, degrees);
      const auto pattern = constant_engagement_pattern(params);
      ASSERT_TRUE(pattern);
      EXPECT_LT(pattern->residuals.back(), kSettled * params.tool_radius);
    }
}

TEST(TrochoidPattern, OfConstantEngagementIsTheSameWhereverItsPassesBegin) {
  for (const double curvature : {0.0, 1.0 / 40}) {
    const TrochoidParams params = slot(1.5, 60, curvature), other = slot(1.7, 60, curvature);
    TurnSearch like(other);
    ASSERT_TRUE(like.first());
    const auto alone = TurnSearch(params).best(), led = TurnSearch(params, &like).best();
    ASSERT_TRUE(alone && led);
    EXPECT_LT(led->pattern.residuals.size(), alone->pattern.residuals.size());
    EXPECT_NEAR(led->pattern.step, alone->pattern.step, 0.01 * alone->pattern.step);
    EXPECT_NEAR(led->figures.removal, alone->figures.removal, 0.01 * alone->figures.removal);
  }
}

TEST(TrochoidPattern, OfConstantEngagementGoesBackNearlyStraightAcrossTheSlot) {
  for (const double width : {1.1, 1.25, 1.5, 2.0, 3.0}) {
    TrochoidParams params = slot(width, 60);
    params.maximum_feed = 1000;
    const auto pattern = constant_engagement_pattern(params);
    ASSERT_TRUE(pattern);
    EXPECT_LT(length_of(pattern->link), 2 * half_room(params) + 0.5) << width;
    for (const Segment& move : pattern->link)
      if (move.is_arc()) {
        EXPECT_GT(move.radius, 0.07);
      }
  }
}

TEST(TrochoidPattern, OfConstantEngagementTurnsAsWidelyAsIsAskedForWhereThereIsRoom) {
  for (const double width : {1.5, 2.0, 3.0, 4.0}) {
    TrochoidParams params = slot(width, 60);
    params.least_turn = 0.9;
    const auto pattern = constant_engagement_pattern(params);
    ASSERT_TRUE(pattern);
    EXPECT_GE(pattern->turn_radius, std::min(0.9, 0.4 * half_room(params)) - 1e-9) << width;
    for (const Segment& move : pattern->link)
      if (move.is_arc()) {
        EXPECT_GE(move.radius, 0.5 * std::min(0.9, pattern->turn_radius) - 1e-9) << width;
      }
  }
}

// mm^2/min, two passes along the walls in the time.
double removal_with_walls(const TrochoidPattern& pattern, const TrochoidParams& params) {
  return params.width * pattern.step /
         (figures_of(pattern, params).time + 2 * pattern.step / params.feed);
}

TEST(TrochoidPattern, OfConstantEngagementHasLongerStepsAndLessWayThanCircles) {
  // Of a rough prototype whose walls were taken for finished, as is done on both sides here. 0.95
  // of each figure is asked for.
  struct Asked {
    double width, step, area, rate;  // tool diameters, mm, of a cut at the limit, of the circles'
  };
  const double most = 0.95;
  for (const Asked& least : {Asked{1.25, 0.387, 0.84, 1.35}, Asked{1.5, 0.656, 0.89, 1.40},
                             Asked{2.0, 0.983, 0.98, 1.50}, Asked{2.5, 1.144, 1.00, 1.52},
                             Asked{3.0, 1.236, 1.00, 1.53}}) {
    SCOPED_TRACE(least.width);
    TrochoidParams params = slot(least.width, 60);
    params.finish_walls = false;
    const auto ours = constant_engagement_pattern(params), circles = circular_pattern(params);
    ASSERT_TRUE(ours && circles);
    const PatternFigures figures = figures_of(*ours, params), round = figures_of(*circles, params);
    EXPECT_GT(ours->step, most * least.step);
    EXPECT_GT(figures.area_per_length, most * least.area * side_step(params.engagement, 3));
    EXPECT_GT(figures.removal / round.removal, most * least.rate);
    EXPECT_LT((figures.cut_length + figures.link_length) / ours->step,
              (round.cut_length + round.link_length) / circles->step);
  }
}

TEST(TrochoidPattern, OfConstantEngagementThatFinishesItsWallsBeatsCirclesWithTwoPassesAlongThem) {
  for (const double width : {1.25, 1.5, 2.0, 2.5, 3.0}) {
    const TrochoidParams params = slot(width, 60);
    const auto ours = constant_engagement_pattern(params), circles = circular_pattern(params);
    ASSERT_TRUE(ours && circles);
    EXPECT_GT(figures_of(*ours, params).removal / removal_with_walls(*circles, params), 1.49)
        << width;
    // Even with two passes along walls that are finished already.
    EXPECT_GT(removal_with_walls(*ours, params) / removal_with_walls(*circles, params), 1.2)
        << width;
  }
}

TEST(SlotPattern, IsOfCirclesWhereTurnsOfConstantEngagementWouldBeCorners) {
  for (const double width : {6.2, 6.6, 9.0}) {
    SCOPED_TRACE(width);
    TrochoidParams slot;
    slot.width = width;
    slot.maximum_feed = 1000;
    const auto ours = make_pattern(TrochoidKind::kConstantEngagement, slot);
    const auto chosen = slot_pattern(TrochoidKind::kConstantEngagement, slot);
    ASSERT_TRUE(ours && chosen);
    EXPECT_FALSE(has_corners(*chosen));
    const bool cornered = turns_at_corners(ours->cut) || turns_at_corners(ours->link);
    EXPECT_EQ(chosen->kind == TrochoidKind::kCircular, cornered);
    EXPECT_EQ(cornered, width < 6.5);
  }
}

TEST(SlotPattern, LeavesNoMoreBesideAWallThanOnePassTakesAtTheLimit) {
  for (const double width : {1.5, 2.0, 3.0})
    for (const double curvature : {0.0, 0.02}) {
      const TrochoidParams params = slot(width, 60, curvature);
      const auto pattern = slot_pattern(TrochoidKind::kConstantEngagement, params);
      ASSERT_TRUE(pattern);
      EXPECT_LE(pattern->beside, most_beside(params));
      EXPECT_LT(most_beside(params), side_step(params.engagement, params.tool_radius));
      EXPECT_GT(pattern->removal, 0);
    }
  EXPECT_LT(most_beside(slot(3, 60, 0.02)), most_beside(slot(3, 60)));
  EXPECT_EQ(slot_pattern(TrochoidKind::kCircular, slot(2, 60))->beside, 0);
}

void expect_refused(const TrochoidParams& params, const std::string& words) {
  for (const TrochoidKind kind : kKinds) {
    try {
      make_pattern(kind, params);
      ADD_FAILURE() << "not refused: " << words;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
}

TEST(TrochoidPattern, IsRefusedForSlotsThatTheToolDoesNotFit) {
  expect_refused(slot(1, 60), "no wider than the tool");
  expect_refused(slot(2, 60, 0.2), "bends more tightly");
  expect_refused(slot(2, 0), "between 0 and 180");
  expect_refused(slot(2, 180), "between 0 and 180");
  TrochoidParams params = slot(2, 60);
  params.width = std::nan("");
  expect_refused(params, "finite");
  params = slot(2, 60);
  params.maximum_feed = 100;
  expect_refused(params, "maximum feed");
}

}  // namespace
}  // namespace evenload
