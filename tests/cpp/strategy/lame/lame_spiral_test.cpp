#include "strategy/lame/lame_spiral.h"

#include "cutting/engagement.h"
#include "cutting/load_budget.h"
#include "strategy/lame/lame_pitch.h"
#include "strategy/lame/lame_turns.h"

namespace evenload {
namespace {

LameCurve curve_of(double a, double b, double exponent, int segments = 4, double rotation = 0) {
  return {{0, 0}, a, b, exponent, segments, rotation};
}

// From a circle of 2.7 mm to a shape.
LameGrowth growth_to(const LameCurve& last) {
  LameCurve circle = last;
  circle.a = circle.b = 2.7;
  circle.exponent = 1;
  return {{{circle, last}}};
}

double off(const LameSpiral& spiral, const std::vector<Segment>& moves) {
  double worst = 0;
  for (double turned = 0; turned <= spiral.end; turned += 0.01) {
    double least = 1e9;
    for (const Segment& move : moves)
      least = std::min(least, move.distance_to(spiral.place(turned).p));
    worst = std::max(worst, least);
  }
  return worst;
}

double worst_corner(const std::vector<Segment>& moves) {
  double worst = 0;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    EXPECT_LE(distance(moves[i].a, moves[i - 1].b), 1e-9);
    worst = std::max(worst, norm(moves[i].tangent(0) - moves[i - 1].tangent(1)));
  }
  return worst;
}

TEST(LameSpiral, ThatGrowsEvenlyIsTheSourcesFormula) {
  // a and b grow by p per rad, n runs from 1 to 0.4 [Tancsa 2023, eqs. 6 and 7].
  const double end = 6 * kPi, p = 0.2;
  const LameCurve first = curve_of(3, 2, 1), last = curve_of(3 + p * end, 2 + p * end, 0.4);
  const LameSpiral spiral{{{{first, last}}}, MonotoneSpline({0, end}, {0, 1}), 0, false, end};
  for (double phi = 0.013; phi < end; phi += 0.1) {
    const double a = 3 + p * phi, b = 2 + p * phi, n = 1 - 0.6 * phi / end, t = std::tan(phi);
    const double r =
        a * std::pow(std::pow(t * t * a * a / (b * b), 1 / n) + 1, -n / 2) * std::sqrt(t * t + 1);
    EXPECT_NEAR(norm(spiral.place(phi).p), r, 1e-9 * r);
  }
}

TEST(LameSpiral, ThatDoesNotGrowIsTheClosedCurve) {
  const LameCurve curve = curve_of(9, 5, 0.4, 4, 0.3);
  const Curve closed = closed_arcs_of(curve, 0.001);
  EXPECT_NEAR(closed.signed_area(), lame_area(curve), 0.03);
  for (const Segment& piece : closed.segments())
    for (const double t : {0.0, 0.3, 0.7})
      EXPECT_NEAR(norm(piece.point(t)), lame_radius(curve, angle_of(piece.point(t))).r, 0.0015);
}

TEST(LameSpiral, HeadsWhereItGoes) {
  const LameGrowth growth = growth_to({{3, 1}, 20, 12, 0.3, 4, 0.2});
  for (const bool clockwise : {false, true}) {
    const LameSpiral spiral{growth, MonotoneSpline({0, 10, 40}, {0, 0.4, 1}), 1, clockwise, 40};
    for (double turned = 0.05; turned < 39.9; turned += 0.37) {
      const Vec2 along = spiral.place(turned + 1e-6).p - spiral.place(turned - 1e-6).p;
      EXPECT_LE(norm(normalized(along) - spiral.place(turned).direction), 1e-5) << turned;
    }
  }
}

TEST(LameSpiral, WithStraightCoursesIsTheOneWithout) {
  const LameGrowth plain = growth_to({{3, 1}, 20, 12, 0.3, 4, 0.2});
  LameGrowth straight = plain;
  for (const auto course : {&LameCourses::a, &LameCourses::b, &LameCourses::exponent})
    straight.stages[0].courses.*course = course_through({0, 0.25, 0.5, 0.75, 1});
  const MonotoneSpline share({0, 10, 40}, {0, 0.4, 1});
  const LameSpiral one{plain, share, 1, false, 40}, other{straight, share, 1, false, 40};
  for (double turned = 0; turned <= 40; turned += 0.37) {
    EXPECT_LE(distance(one.place(turned).p, other.place(turned).p), 1e-12);
    EXPECT_LE(norm(one.place(turned).direction - other.place(turned).direction), 1e-12);
  }
  for (const double share_of : {-0.1, 0.0, 0.3, 1.0}) {
    EXPECT_NEAR(straight.change(share_of, 0.1), plain.change(share_of, 0.1), 1e-12);
    EXPECT_NEAR(straight.step_of(share_of, 1.3), plain.step_of(share_of, 1.3), 1e-9);
  }
}

TEST(LameSpiral, FollowsItsCourses) {
  LameGrowth growth = growth_to(curve_of(22.7, 12.7, 0.4));
  growth.stages[0].courses = {course_through({0, 0.1, 0.4, 1}), course_through({0, 0.7, 1}),
                              course_through({0, 0, 1})};
  EXPECT_EQ(growth.courses().pieces(), 3U);
  EXPECT_NEAR(growth.at(1.0 / 3).a, 2.7 + 0.1 * 20, 1e-12);
  EXPECT_NEAR(growth.at(2.0 / 3).a, 2.7 + 0.4 * 20, 1e-12);
  EXPECT_NEAR(growth.at(0.5).b, 2.7 + 0.7 * 10, 1e-12);
  EXPECT_EQ(growth.at(0.3).exponent, 1);
  EXPECT_NEAR(growth.at(1).exponent, 0.4, 1e-12);
  EXPECT_NEAR(growth.at(-0.1).a, 0.7, 1e-12);  // continued backwards, evenly
  // The larger change of the two, and the step that makes it.
  EXPECT_NEAR(growth.change(2.0 / 3, 1.0 / 3), 6, 1e-12);
  EXPECT_NEAR(growth.change(0.5, 0.5), 7, 1e-12);
  for (const double share : {0.0, 0.2, 0.5, 1.0})
    for (const double mm : {0.01, 1.5, 40.0})
      EXPECT_NEAR(growth.change(share, growth.step_of(share, mm)), mm, 1e-9) << share;
  EXPECT_FALSE(course_through({}));
}

// Courses of each kind, steep ones and ones that rest among them.
std::vector<LameCourses> some_courses() {
  const LameCourse late = course_through({0, 0.1, 0.4, 1}), early = course_through({0, 0.8, 1}),
                   resting = course_through({0, 0, 0.6, 0.6, 1, 1});
  return {{late, {}, {}},    {{}, late, {}},       {{}, {}, late},         {{}, {}, resting},
          {late, early, {}}, {resting, {}, early}, {resting, resting, {}}, {early, late, resting}};
}

TEST(LameSpiral, WithCoursesHeadsWhereItGoesAndBecomesTangentArcs) {
  for (const LameCourses& courses : some_courses())
    for (const bool clockwise : {false, true}) {
      LameGrowth growth = growth_to({{3, 1}, 20, 12, 0.3, 4, 0.2});
      growth.stages[0].courses = courses;
      const LameSpiral spiral{growth, MonotoneSpline({0, 10, 60}, {0, 0.3, 1}), 1, clockwise, 60};
      for (double turned = 0.05; turned < 59.9; turned += 0.37) {
        const Vec2 along = spiral.place(turned + 1e-6).p - spiral.place(turned - 1e-6).p;
        EXPECT_LE(norm(normalized(along) - spiral.place(turned).direction), 1e-5) << turned;
      }
      if (clockwise) continue;
      const LameArcs arcs = arcs_of(spiral, 0.004);
      EXPECT_LE(off(spiral, arcs.moves), 1.1 * 0.004);
      EXPECT_LE(worst_corner(arcs.moves), 1e-6);
    }
}

TEST(LameSpiral, BecomesTangentArcsWithinTheTolerance) {
  for (const double tolerance : {0.001, 0.02}) {
    const LameSpiral spiral{growth_to(curve_of(15, 15, 0.2)), MonotoneSpline({0, 60}, {0, 1}), 0,
                            false, 60};
    const LameArcs arcs = arcs_of(spiral, tolerance);
    EXPECT_EQ(arcs.moves.size(), arcs.turned.size());
    EXPECT_LE(off(spiral, arcs.moves), 1.05 * tolerance);
    EXPECT_LE(worst_corner(arcs.moves), 1e-6);
    EXPECT_LT(arcs.moves.size(), tolerance < 0.01 ? 2000U : 800U);  // lines would be far more
  }
  EXPECT_THROW(arcs_of({growth_to(curve_of(5, 5, 1)), MonotoneSpline(0), 0, false, 6}, 0),
               std::invalid_argument);
  EXPECT_THROW(arcs_of({growth_to(curve_of(5, 5, 7)), MonotoneSpline(0), 0, false, 6}, 0.01),
               std::invalid_argument);
}

TEST(LameSpiral, GoesOverFromShapeToShapeWithoutAJumpOfTangentOrCurvature) {
  const LameCurve outer = curve_of(30, 30, 0.3), inner = curve_of(13, 13, 0.6, 6, 0.2);
  LameCurve first_circle = outer, second_circle = inner;
  first_circle.a = first_circle.b = second_circle.a = second_circle.b = 21;
  first_circle.exponent = second_circle.exponent = 1;
  const LameGrowth growth{{{outer, first_circle, 1, LameJoint::kAtEnd},
                           {second_circle, inner, 1, LameJoint::kAtBegin}}};
  const double end = 30 * kPi, join = end * 9 / 17;
  const LameSpiral spiral{growth, MonotoneSpline({0, end}, {0, 1}), 0, true, end};
  EXPECT_NEAR(norm(spiral.place(join).p), 21, 1e-9);
  const auto curvature = [&](double turned) {
    const PlanePoint a = spiral.place(turned - 0.005), b = spiral.place(turned + 0.005);
    return std::asin(cross(a.direction, b.direction)) / distance(a.p, b.p);
  };
  EXPECT_LE(norm(spiral.place(join - 1e-7).direction - spiral.place(join + 1e-7).direction), 1e-6);
  EXPECT_NEAR(curvature(join - 0.01), curvature(join + 0.01), 1e-4);
}

TEST(LamePitch, AroundACircleIsTheSideStepOfItsContour) {
  // Thesis I is for a contour; the tool's way lies a radius within it.
  TurnTask task;
  for (const double engagement : {30.0, 60.0, 90.0}) {
    task.engagement = engagement * kDegree;
    const LameGrowth growth = growth_to(curve_of(40, 40, 1));
    const MonotoneSpline steps = largest_steps(growth, task);
    for (const double share : {0.25, 0.5, 1.0}) {
      const double step = steps.value(share) * growth.length();
      const double before = growth.at(share).a - step;  // mm, the way one turn earlier
      const double contour = before + task.tool_radius;
      EXPECT_NEAR(
          step, side_step_on_contour(task.engagement, task.tool_radius, contour, Contour::kConcave),
          0.03 * step);
    }
  }
}

TEST(LamePitch, NeverExceedsAWish) {
  TurnTask task;
  task.pitch = 0.4;
  const LameGrowth growth = growth_to(curve_of(20, 20, 0.5));
  const MonotoneSpline steps = largest_steps(growth, task);
  for (double share = 0; share <= 1; share += 0.1)
    EXPECT_LE(steps.value(share) * growth.length(), 0.4 + 1e-9);
}

TEST(LamePitch, OfEveryTurnKeepsTheEngagementAndUsesIt) {
  for (const LameCurve& last : {curve_of(14.5, 14.5, 0.25), curve_of(18, 18, 0.68, 6),
                                curve_of(28, 16, 0.4), curve_of(20, 20, 0.1, 3)})
    for (const double degrees : {30.0, 60.0, 90.0}) {
      TurnTask task;
      task.engagement = degrees * kDegree;
      task.maximum_feed = 1000;
      ClearedGround ground({{-60, -60}, {60, 60}}, 3, nullptr);
      ground.add_disc({}, 5.7);
      const std::optional<PlannedGrowth> growth = best_growth({growth_to(last)}, task);
      ASSERT_TRUE(growth);
      const LameTurns turns = turns_of(*growth, task, 0, 0.004, ground);
      EXPECT_EQ(ground.size(), 1U);  // left as it was
      EXPECT_LE(turns.engagement, task.engagement + load_budget::kSpiral);
      EXPECT_GE(turns.engagement, task.engagement - 2 * kDegree);
      EXPECT_LE(worst_corner(turns.moves), 1e-6);
      // It begins along its first circle and ends with a full turn on the last curve, off which it
      // then turns by about four tolerances, so that it stops in no cut.
      EXPECT_NEAR(norm(turns.moves.front().a), 2.7, 1e-6);
      EXPECT_NEAR(cross(normalized(turns.moves.front().a), turns.moves.front().tangent(0)), 1,
                  1e-4);
      const Vec2 end = turns.moves.back().b;
      const double off = lame_radius(last, angle_of(end)).r - norm(end);
      EXPECT_GT(off, 0.008);
      EXPECT_LT(off, 0.05);  // where the exponent changes, too
      for (const Segment& move : turns.moves) ground.add(move);
      ground.remove_last();
      const double heading = angle_of(turns.moves.back().tangent(1));
      std::vector<AngularInterval> engaged;
      ground.uncovered(end, heading - kPi / 2, heading + kPi / 2, engaged);
      EXPECT_TRUE(engaged.empty());
      std::size_t i = turns.moves.size();
      while (wrap_positive(angle_of(end) - angle_of(turns.moves[i - 1].a)) < 0.149) --i;
      double left = lame_length(last) - turns.moves[--i].length() - 0.1;
      for (; left > 0; left -= turns.moves[i].length()) {
        --i;
        const Vec2 p = turns.moves[i].point(0.5);
        EXPECT_NEAR(norm(p), lame_radius(last, angle_of(p)).r, 0.006);
      }
    }
}

TEST(LamePitch, WithAnyCourseKeepsTheEngagementAndTheWish) {
  for (const LameCurve& last : {curve_of(14.5, 14.5, 0.25), curve_of(28, 16, 0.4)})
    for (const LameCourses& courses : some_courses())
      for (const std::optional<double> pitch : {std::optional<double>(), std::optional(0.5)}) {
        TurnTask task;
        task.maximum_feed = 1000;
        task.pitch = pitch;
        ClearedGround ground({{-60, -60}, {60, 60}}, 3, nullptr);
        ground.add_disc({}, 5.7);
        LameGrowth growth = growth_to(last);
        growth.stages[0].courses = courses;
        const std::optional<PlannedGrowth> planned = best_growth({growth}, task);
        ASSERT_TRUE(planned);
        const LameTurns turns = turns_of(*planned, task, 0, 0.004, ground);
        EXPECT_LE(turns.engagement, task.engagement + load_budget::kSpiral);
        EXPECT_LE(worst_corner(turns.moves), 1e-6);
        EXPECT_LE(turns.largest_pitch, pitch.value_or(40) + 1e-9);
        for (double turned = 2 * kPi; pitch && turned <= turns.spiral.end - 0.2; turned += 0.1) {
          const double share = turns.spiral.share.value(turned);
          const double before = turns.spiral.share.value(turned - 2 * kPi);
          EXPECT_LE(growth.change(share, share - before), 1.01 * *pitch) << turned;
        }
        // It ends nearly on its last curve, all courses run through.
        const Vec2 end = turns.moves.back().b;
        EXPECT_NEAR(norm(end), lame_radius(last, angle_of(end)).r, 0.1);
      }
}

TEST(LamePitch, TriesNoOtherRunThanASetCourseOfTheExponent) {
  TurnTask task;
  task.maximum_feed = 1000;
  LameGrowth growth = growth_to(curve_of(30, 30, 0.2));
  EXPECT_EQ(best_growth({growth}, task)->growth.stages[0].run, 2.5);
  growth.stages[0].courses.exponent = course_through({0, 1});
  EXPECT_EQ(best_growth({growth}, task)->growth.stages[0].run, 1);
}

TEST(LamePitch, CountsBlocksInTheTime) {
  TurnTask task;
  task.maximum_feed = 1000;
  const auto more_for_dear_ones = [&](const LameCurve& last) {
    const LameGrowth growth = growth_to(last);
    const MonotoneSpline steps = largest_steps(growth, task);
    task.block_price = 1e-4;
    const double cheap = time_of(growth, steps, task);
    task.block_price = 0.02;
    return time_of(growth, steps, task) - cheap;
  };
  // Some six arcs on each turn of a circle; those of a square are closer, and its feed changes.
  EXPECT_NEAR(more_for_dear_ones(curve_of(20, 20, 1)), 15 * 6 * 0.02, 0.8);
  EXPECT_GT(more_for_dear_ones(curve_of(20, 20, 0.3)), 15 * 30 * 0.02);
}

TEST(LamePitch, ChoosesTheGrowthThatTakesLeastTime) {
  TurnTask task;
  task.maximum_feed = 1000;
  LameGrowth slow = growth_to(curve_of(30, 30, 0.2)), fast = slow;
  slow.stages[0].from.a = slow.stages[0].from.b = 1;  // more to cut
  const std::optional<PlannedGrowth> best = best_growth({slow, fast}, task);
  ASSERT_TRUE(best);
  EXPECT_EQ(best->growth.stages[0].from.a, 2.7);
  // Curves that would cut into the island are none to choose from.
  LameGrowth crossing{{{curve_of(40, 40, 1), curve_of(25, 25, 1)}}};
  crossing.stages.push_back({curve_of(25, 25, 1), curve_of(24, 13, 0.1)});
  crossing.stages[1].run = 8;
  task.inwards = true;
  EXPECT_FALSE(best_growth({crossing}, task));
}

}  // namespace
}  // namespace evenload
