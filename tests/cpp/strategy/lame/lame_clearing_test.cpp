// Pockets cleared with Lamé spirals, by a judge that shares no code with them.
#include "strategy/lame/lame_clearing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/lame_curve.h"
#include "geometry/shapes.h"
#include "judge/judged.h"
#include "strategy/lame/lame_opening.h"
#include "strategy/lame/lame_shapes.h"
#include "support/errors.h"

namespace evenload {
namespace {

using corpus::Case;
using corpus::tells;
using path_check::Findings;

LameToolpath spiral(const Case& pocket, const ClearingParams& params, const LameParams& lame = {}) {
  Progress watch;
  return clear_with_lame_spiral({pocket.region}, params, lame, watch);
}

void expect_within_limits(const Case& pocket, const Toolpath& path, const Findings& found) {
  EXPECT_EQ(path.report.termination, Termination::kComplete);
  EXPECT_LE(found.cut_engagement, pocket.engagement_angle + 1 * kDegree);
  EXPECT_LE(found.gouge, 0.005);
  EXPECT_LE(found.left_share, 0.0005);
  EXPECT_LE(found.link_engagement, 1 * kDegree);
  EXPECT_EQ(found.bad_plunges, 0);
  EXPECT_LE(found.arc_mismatch, 5e-6);
  EXPECT_LE(found.removal_rate, corpus::most_rate(pocket));
  EXPECT_GE(found.climb_length, 0.995 * (found.climb_length + found.conventional_length));
  EXPECT_LE(found.kinks, 6);  // sharp corners, and a few that rounding makes
}

// The first cuts of a path after which it links or rises for the first time.
std::vector<Move> first_cuts(const Toolpath& path) {
  std::vector<Move> cuts;
  for (const Move& move : path.moves) {
    if (move.kind == MoveKind::kCut) cuts.push_back(move);
    if (move.kind != MoveKind::kCut && !cuts.empty()) break;
  }
  return cuts;
}

// Why the spiral is refused; nothing where it is made.
std::optional<GeometryError> error_of(const std::vector<Region>& regions,
                                      const ClearingParams& params, const LameParams& lame = {}) {
  Progress watch;
  try {
    clear_with_lame_spiral(regions, params, lame, watch);
  } catch (const GeometryError& error) {
    return error;
  }
  return {};
}

std::optional<Refusal> refusal(const std::vector<Region>& regions, const ClearingParams& params,
                               const LameParams& lame = {}) {
  const std::optional<GeometryError> error = error_of(regions, params, lame);
  return error ? std::optional(error->refusal()) : std::nullopt;
}

Curve box(double x, double y, double width, double height) {
  return Curve({{{x, y}}, {{x + width, y}}, {{x + width, y + height}}, {{x, y + height}}}, true);
}

Curve circle(Vec2 centre, double radius, bool clockwise = false) {
  const Curve curve({{centre + Vec2{radius, 0}, 1}, {centre - Vec2{radius, 0}, 1}}, true);
  return clockwise ? curve.reversed() : curve;
}

Region ring(double outer, double inner) {
  return make_region(circle({}, outer), {circle({}, inner, true)});
}

class EveryLamePocket : public testing::TestWithParam<std::string> {};

TEST_P(EveryLamePocket, IsClearedWithinTheLimitsAndTheTime) {
  const Case pocket = corpus::load(GetParam());
  const LameToolpath path = spiral(pocket, pocket.params());
  expect_within_limits(pocket, path, corpus::judge(pocket, path));
  EXPECT_LE(path.report.cutting_time, 1.2 * path.report.ideal_time);
  EXPECT_GT(path.cleared_share, 0.6);
  EXPECT_LE(path.cleared_share, 1);
}

INSTANTIATE_TEST_SUITE_P(Corpus, EveryLamePocket,
                         testing::Values("lame_square35", "lame_hex50", "lame_square_island",
                                         "lame_hex_island", "square60", "boss_open",
                                         "square_island"),
                         [](const auto& each) { return each.param; });

std::vector<Vec2> corners(int count, double radius) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) points.push_back(radius * unit(0.2 + 2 * kPi * i / count));
  return points;
}

std::vector<Vec2> box_corners(double width, double height) {
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

struct Shape {
  const char* name;
  Curve outline;
  int segments;
};

// For a tool of 6 mm: corners that it enters and corners that it does not.
std::vector<Shape> other_shapes() {
  return {{"ellipse", shapes::ellipse(35, 22), 4},
          {"slot", shapes::slot({5, 5}, 30, 15), 4},
          {"rectangle", shapes::rectangle(0, 0, 60, 40), 4},
          {"rectangle_with_tight_corners", shapes::filleted(box_corners(60, 40), 2), 4},
          {"rectangle_with_wide_corners", shapes::filleted(box_corners(60, 40), 8), 4},
          {"square_with_tight_corners", shapes::filleted(box_corners(40, 40), 2), 4},
          {"square_with_wide_corners", shapes::filleted(box_corners(40, 40), 6), 4},
          {"triangle", shapes::polygon(corners(3, 40)), 3},
          {"triangle_with_wide_corners", shapes::filleted(corners(3, 40), 6), 3},
          {"hexagon", shapes::polygon(corners(6, 25)), 6},
          {"hexagon_with_tight_corners", shapes::filleted(corners(6, 25), 2), 6},
          {"hexagon_with_wide_corners", shapes::filleted(corners(6, 25), 8), 6},
          {"octagon", shapes::polygon(corners(8, 30)), 8},
          {"octagon_with_wide_corners", shapes::filleted(corners(8, 30), 8), 8}};
}

class EveryOtherLameShape : public testing::TestWithParam<int> {};

TEST_P(EveryOtherLameShape, IsClearedWithinTheLimitsAndTheTime) {
  const Shape shape = other_shapes()[static_cast<std::size_t>(GetParam())];
  Case pocket = corpus::load("square60");
  pocket.region = make_region(shape.outline);
  const LameToolpath path = spiral(pocket, pocket.params());
  expect_within_limits(pocket, path, corpus::judge(pocket, path));
  EXPECT_EQ(path.figures->last.segments, shape.segments);
  EXPECT_LE(path.report.cutting_time, 1.1 * path.report.ideal_time);
  EXPECT_GT(path.cleared_share, shape.segments == 3 ? 0.74 : 0.93);
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryOtherLameShape,
                         testing::Range(0, static_cast<int>(other_shapes().size())),
                         [](const auto& each) {
                           return other_shapes()[static_cast<std::size_t>(each.param)].name;
                         });

TEST(LameClearing, IsTheSameForPocketsThatAreTurnedShiftedAndMirrored) {
  const Case original = corpus::load("lame_square35");
  const double time = spiral(original, original.params()).report.cutting_time;
  for (const bool mirrored : {false, true}) {
    const Case pocket = corpus::moved(original, 0.4, mirrored, {200, -30});
    ClearingParams params = pocket.params();
    params.cut_mode = mirrored ? CutMode::kConventional : CutMode::kClimb;
    const LameToolpath path = spiral(pocket, params);
    const Findings found = corpus::judge(pocket, path);
    EXPECT_LE(found.cut_engagement, pocket.engagement_angle + 1 * kDegree);
    EXPECT_LE(found.gouge, 0.005);
    EXPECT_LE(found.left_share, 0.0005);
    EXPECT_NEAR(path.report.cutting_time, time, 0.03 * time);
    const double wrong = mirrored ? found.climb_length : found.conventional_length;
    EXPECT_LE(wrong, 0.005 * (found.climb_length + found.conventional_length));
  }
}

// mm, of the cuts that begin further than `from` mm from the origin.
double tightest_turn(const std::vector<Move>& moves, double from) {
  double tightest = std::numeric_limits<double>::infinity();
  double x = 0, y = 0;
  for (const Move& move : moves) {
    if (move.kind == MoveKind::kCut && move.sweep != 0 && std::hypot(x, y) > from)
      tightest = std::min(tightest, std::hypot(move.x - move.cx, move.y - move.cy));
    x = move.x;
    y = move.y;
  }
  return tightest;
}

class EverySpiral : public testing::TestWithParam<std::string> {};

TEST_P(EverySpiral, HasNoLinksAndNoTurnTighterThanTheMinimumRadius) {
  const Case pocket = corpus::load(GetParam());
  for (const double radius : {0.5, 0.9, 2.0}) {
    ClearingParams params = pocket.params();
    params.minimum_radius = radius;
    LameParams lame;
    lame.rest = LameRest::kLeave;
    const LameToolpath path = spiral(pocket, params, lame);
    EXPECT_EQ(path.report.links, 0);
    EXPECT_EQ(path.report.retracts, 0);
    EXPECT_EQ(path.report.passes, 1);
    EXPECT_GE(tightest_turn(path.moves, 0), radius);
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, EverySpiral,
                         testing::Values("lame_square35", "lame_hex50", "lame_square_island",
                                         "lame_hex_island", "square60", "boss_open"),
                         [](const auto& each) { return each.param; });

TEST(LameClearing, ASpiralKeepsALargeMinimumRadiusInItsOuterTurns) {
  const Case pocket = corpus::load("lame_hex50");
  ClearingParams params = pocket.params();
  params.minimum_radius = 8;
  LameParams lame;
  lame.rest = LameRest::kLeave;
  // The first turns are as tight as the entry.
  EXPECT_GE(tightest_turn(spiral(pocket, params, lame).moves, 12), 8);
}

TEST(LameClearing, LeavesTheRestWhereThatIsWished) {
  const Case pocket = corpus::load("lame_hex50");
  LameParams lame;
  lame.rest = LameRest::kLeave;
  const LameToolpath path = spiral(pocket, pocket.params(), lame);
  const Findings found = corpus::judge(pocket, path);
  EXPECT_EQ(path.report.termination, Termination::kIncomplete);
  EXPECT_NEAR(found.left_share, 1 - path.cleared_share, 0.002);
  EXPECT_NEAR(path.report.uncut_area, found.left_area, 0.05 * found.left_area);
  ASSERT_FALSE(path.report.findings.empty());
  EXPECT_EQ(path.report.findings.front().code, FindingCode::kLeftBesideSpiral);
}

TEST(LameClearing, OfARingLeavesWhatNeitherChannelNorSpiralReach) {
  const Case pocket = corpus::load("square_island");
  LameParams lame;
  lame.rest = LameRest::kLeave;
  const LameToolpath path = spiral(pocket, pocket.params(), lame);
  const Findings found = corpus::judge(pocket, path);
  EXPECT_NEAR(path.report.uncut_area, found.left_area, 0.01 * found.reachable_area);
  EXPECT_LT(path.cleared_share, 1 - found.left_share);  // the channel is no part of it
}

TEST(LameClearing, CanBeCancelledAtAnyTimeAndItsProgressNeverTurnsBack) {
  for (const char* name : {"lame_hex50", "square_island", "lame_hex_island"}) {
    const Case pocket = corpus::load(name);
    double before = 0;
    Progress all([&](double done) {
      EXPECT_GE(done, before - 1e-9);
      EXPECT_LE(done, 1 + 1e-9);
      before = done;
      return true;
    });
    clear_with_lame_spiral({pocket.region}, pocket.params(), {}, all);
    for (const double at : {0.0, 0.5 * before, before}) {
      Progress some([&](double done) { return done < at; });
      const LameToolpath path = clear_with_lame_spiral({pocket.region}, pocket.params(), {}, some);
      EXPECT_EQ(path.report.termination, Termination::kCancelled) << name;
    }
  }
}

TEST(LameClearing, KeepsWhatIsSet) {
  const Case pocket = corpus::load("square60");
  LameParams lame;
  lame.segments = 6;
  lame.semi_axis_a = 20;
  lame.exponent_end = 0.8;
  lame.rotation = 0.3;
  lame.centre = Vec2{31, 29};
  lame.rest = LameRest::kLeave;
  const LameToolpath path = spiral(pocket, pocket.params(), lame);
  const LameCurve last{{31, 29}, 20, 20, 0.8, 6, 0.3};
  std::vector<Move> cuts = first_cuts(path);
  ASSERT_GT(cuts.size(), 20U);
  // In the end it turns off the curve.
  for (std::size_t i = cuts.size() - 14; i < cuts.size() - 4; ++i) {
    const Vec2 d = Vec2{cuts[i].x, cuts[i].y} - last.centre;
    EXPECT_NEAR(norm(d), lame_radius(last, angle_of(d)).r, 0.006);
  }
  // The exponent with which it starts: in the helix's circle fits a smaller curve.
  lame.exponent_start = 0.5;
  EXPECT_NE(first_cuts(spiral(pocket, pocket.params(), lame)).size(), cuts.size());
}

std::vector<Vec2> ends_of(const Toolpath& path) {
  std::vector<Vec2> ends;
  for (const Move& move : path.moves) ends.push_back({move.x, move.y});
  return ends;
}

using Course = std::vector<double>;

TEST(LameClearing, WithCoursesKeepsTheLimitsOnAnotherPath) {
  Case rectangle = corpus::load("square60");
  rectangle.region = make_region(box(0, 0, 60, 40));
  for (const Case& pocket : {corpus::load("lame_square35"), rectangle}) {
    const LameToolpath plain = spiral(pocket, pocket.params());
    for (const auto course : {&LameParams::semi_axis_a_course, &LameParams::semi_axis_b_course,
                              &LameParams::exponent_course})
      for (const Course& values : {Course{0, 0.1, 0.4, 1}, Course{0, 0.9, 0.9, 1, 1}}) {
        LameParams lame;
        lame.*course = values;
        const LameToolpath path = spiral(pocket, pocket.params(), lame);
        expect_within_limits(pocket, path, corpus::judge(pocket, path));
        EXPECT_NE(ends_of(path), ends_of(plain));
        EXPECT_NEAR(path.cleared_share, plain.cleared_share, 0.002);  // the same last curve
      }
  }
}

TEST(LameClearing, WithStraightCoursesOfItsSemiAxesIsTheOneWithout) {
  for (const char* name : {"lame_square35", "lame_square_island"}) {
    const Case pocket = corpus::load(name);
    LameParams lame;
    lame.semi_axis_a_course = {0, 0.5, 1};
    EXPECT_EQ(ends_of(spiral(pocket, pocket.params(), lame)),
              ends_of(spiral(pocket, pocket.params())));
  }
}

TEST(LameClearing, WithCoursesGoesAroundIslandsAndThroughRingsWithoutACircle) {
  for (const char* name : {"lame_square_island", "lame_hex_island", "square_island", "boss_open"}) {
    const Case pocket = corpus::load(name);
    const LameToolpath plain = spiral(pocket, pocket.params());
    for (const auto course : {&LameParams::semi_axis_b_course, &LameParams::exponent_course}) {
      LameParams lame;
      lame.*course = {0, 0.2, 0.5, 1};
      const LameToolpath path = spiral(pocket, pocket.params(), lame);
      expect_within_limits(pocket, path, corpus::judge(pocket, path));
      EXPECT_NE(ends_of(path), ends_of(plain));
    }
  }
}

// The turn of a rectangle at `turn` rad with courses of its axes that differ, and its mirror image.
TEST(LameClearing, CoursesHoldForTheSameAxisWhereTheWorkIsMirrored) {
  for (const double turn : {0.35, -0.35, 0.8, 1.4}) {
    Case pocket = corpus::load("square60");
    const Curve upright = box(-25, -15, 50, 30);
    std::vector<Vertex> vertices = upright.vertices();
    for (Vertex& v : vertices) v.p = rotated(v.p, turn);
    pocket.region = make_region(Curve(vertices, true));
    ClearingParams params = pocket.params();
    LameParams lame;
    lame.semi_axis_a_course = {0, 0.1, 0.4, 1};
    const LameToolpath climb = spiral(pocket, params, lame);
    params.cut_mode = CutMode::kConventional;
    const LameToolpath conventional = spiral(pocket, params, lame);
    EXPECT_NEAR(climb.figures->last.a, conventional.figures->last.a, 0.02) << turn;
    EXPECT_GT(climb.figures->last.a, climb.figures->last.b) << turn;
    EXPECT_NEAR(std::sin(climb.figures->last.rotation - turn), 0, 1e-3) << turn;
    EXPECT_NEAR(std::sin(conventional.figures->last.rotation - turn), 0, 1e-3) << turn;
    EXPECT_NEAR(climb.report.cutting_time, conventional.report.cutting_time,
                0.01 * climb.report.cutting_time)
        << turn;
    EXPECT_LE(corpus::judge(pocket, conventional).cut_engagement,
              pocket.engagement_angle + 1 * kDegree);
  }
}

TEST(LameClearing, OfOtherThanFourSegmentsHasOneCourseForBothAxes) {
  const Case pocket = corpus::load("lame_hex50");
  LameParams a, b, both, two;
  a.semi_axis_a_course = b.semi_axis_b_course = two.semi_axis_a_course = {0, 0.2, 0.5, 1};
  both.semi_axis_a_course = both.semi_axis_b_course = a.semi_axis_a_course;
  two.semi_axis_b_course = {0, 0.8, 1};
  const std::vector<Vec2> ends = ends_of(spiral(pocket, pocket.params(), a));
  EXPECT_EQ(ends, ends_of(spiral(pocket, pocket.params(), b)));
  EXPECT_EQ(ends, ends_of(spiral(pocket, pocket.params(), both)));
  EXPECT_EQ(refusal({pocket.region}, pocket.params(), two), Refusal::kTwoCourses);
}

TEST(LameClearing, NamesTheCoursesThatLeadNowhereOrChangeNothing) {
  const Case island = corpus::load("lame_square_island"), pocket = corpus::load("lame_square35");
  LameParams lame;
  lame.semi_axis_a_course = lame.semi_axis_b_course = {0, 0.5, 1, 1};
  EXPECT_EQ(refusal({island.region}, island.params(), lame), Refusal::kNoGrowthByCourses);
  lame.semi_axis_a_course = lame.semi_axis_b_course = Course(kMostCourse, 1);  // all at once
  lame.semi_axis_a_course[0] = lame.semi_axis_b_course[0] = 0;
  EXPECT_EQ(refusal({pocket.region}, pocket.params(), lame), Refusal::kNoLoadByCourses);
  lame = {};
  lame.exponent_course = {0, 0.2, 1};
  EXPECT_FALSE(tells(spiral(pocket, pocket.params(), lame).report, FindingCode::kIdleCourse));
  lame.exponent_end = 1;
  EXPECT_TRUE(tells(spiral(pocket, pocket.params(), lame).report, FindingCode::kIdleCourse));
}

TEST(LameClearing, TellsOfTurnsThatASetExponentOrCourseMakesTooTight) {
  const Case pocket = corpus::load("square60");
  ClearingParams params = pocket.params();
  params.minimum_radius = 0.9;
  const auto told = [&](const LameParams& lame) {
    return tells(spiral(pocket, params, lame).report, FindingCode::kTightSpiral);
  };
  LameParams lame;
  EXPECT_FALSE(told(lame));
  lame.exponent_end = 0.05;
  EXPECT_FALSE(told(lame));
  lame.exponent_course = {0, 1, 1};
  EXPECT_TRUE(told(lame));
  lame.exponent_end = 0.3;
  EXPECT_FALSE(told(lame));
}

TEST(LameClearing, ASmallerPitchMakesMoreTurnsAndALargerOneIsToldOf) {
  const Case pocket = corpus::load("lame_hex50");
  const LameToolpath fitted = spiral(pocket, pocket.params());
  LameParams lame;
  lame.pitch = 0.4;
  const LameToolpath fine = spiral(pocket, pocket.params(), lame);
  EXPECT_GT(fine.report.cut_length, 1.5 * fitted.report.cut_length);
  lame.pitch = 3;
  const LameToolpath coarse = spiral(pocket, pocket.params(), lame);
  EXPECT_NEAR(coarse.report.cut_length, fitted.report.cut_length, 0.01 * fitted.report.cut_length);
  EXPECT_TRUE(tells(coarse.report, FindingCode::kSmallPitch));
}

TEST(LameClearing, BeginsInAHole) {
  Case pocket = corpus::load("lame_hex50");
  ClearingParams params = pocket.params();
  for (const Vec2 place : {Vec2{0, 0}, Vec2{6, -3}})
    for (const double diameter : {8.0, 11.0}) {
      pocket.hole = corpus::Hole{place, diameter};
      params = pocket.params();
      const LameToolpath path = spiral(pocket, params);
      expect_within_limits(pocket, path, corpus::judge(pocket, path));
      EXPECT_LE(path.report.cutting_time, 1.2 * path.report.ideal_time);
    }
}

TEST(LameClearing, BeginsWithAHelixInPlaceOfARampAndSaysSo) {
  const Case pocket = corpus::load("lame_square35");
  ClearingParams params = pocket.params();
  const LameToolpath helix = spiral(pocket, params);
  params.entry = EntryKind::kRamp;
  const LameToolpath path = spiral(pocket, params);
  EXPECT_EQ(path.report.retracts, helix.report.retracts);
  EXPECT_TRUE(tells(path.report, FindingCode::kHelixForSpiral));
  EXPECT_FALSE(tells(helix.report, FindingCode::kHelixForSpiral));
}

TEST(LameClearing, SaysSoWhereNoSpiralIsMade) {
  ClearingParams params = corpus::load("lame_square35").params();
  params.narrow_passages = NarrowPassages::kReducedFeed;
  // Two rooms and a passage of hardly more than the tool's width between them.
  const Curve outline({{{0, 0}},
                       {{40, 0}},
                       {{40, 17}},
                       {{50, 17}},
                       {{50, 0}},
                       {{90, 0}},
                       {{90, 40}},
                       {{50, 40}},
                       {{50, 23.4}},
                       {{40, 23.4}},
                       {{40, 40}},
                       {{0, 40}}},
                      true);
  Progress watch;
  const LameToolpath none = clear_with_lame_spiral({make_region(outline)}, params, {}, watch);
  EXPECT_FALSE(none.figures);
  EXPECT_EQ(none.cleared_share, 0);
  EXPECT_TRUE(tells(none.report, FindingCode::kNoSpiral));
  const Region square = make_region(box(0, 60, 40, 40));
  const LameToolpath one =
      clear_with_lame_spiral({make_region(outline), square}, params, {}, watch);
  ASSERT_TRUE(one.figures);
  EXPECT_LT(one.cleared_share, 0.4);  // of both
  EXPECT_TRUE(tells(one.report, FindingCode::kRegionWithoutSpiral));
}

TEST(LameClearing, RefusesRingsThatAreMostlyChannel) {
  const ClearingParams params = corpus::load("lame_square35").params();
  for (const double width : {7.0, 8.0, 10.0}) {
    const std::optional<GeometryError> error = error_of({ring(20 + width, 20)}, params);
    ASSERT_TRUE(error) << width;
    EXPECT_EQ(error->code(), GeometryErrorCode::kNoLameCurve) << width;
  }
  EXPECT_EQ(refusal({ring(38, 20)}, params), std::nullopt);
  Progress progress;
  const LameToolpath narrow = clear_with_lame_spiral({ring(30, 18)}, params, {}, progress);
  EXPECT_LT(narrow.cleared_share, kLeastShare);
  EXPECT_EQ(narrow.report.uncut_area, 0);
  EXPECT_TRUE(tells(narrow.report, FindingCode::kSpiralAfterChannel));
}

TEST(LameClearing, NamesThePlaceOfARefusedRegion) {
  const ClearingParams params = corpus::load("lame_square35").params();
  const Region square = make_region(box(0, 0, 40, 40)), slot = make_region(box(100, 0, 90, 9));
  EXPECT_FALSE(error_of({slot}, params)->is_of_several());
  const std::optional<GeometryError> of_two = error_of({square, slot}, params);
  EXPECT_TRUE(of_two->is_of_several());
  EXPECT_GE(of_two->where().x, 100);
}

TEST(LameClearing, KeepsTheFirstExponentOfRingsAndIslands) {
  for (const char* name : {"square_island", "boss_open"}) {
    const Case pocket = corpus::load(name);
    LameParams lame;
    lame.exponent_start = 0.7;
    const LameToolpath path = spiral(pocket, pocket.params(), lame);
    ASSERT_TRUE(path.figures) << name;
    EXPECT_EQ(path.figures->exponent_start, 0.7) << name;
    EXPECT_LE(corpus::judge(pocket, path).cut_engagement, pocket.engagement_angle + 1 * kDegree);
  }
}

TEST(LameClearing, TellsOfAHoleThatIsNotUsedAndRefusesOneThatMustBe) {
  ClearingParams params = corpus::load("lame_square35").params();
  params.entry_point = Vec2{35, 0};
  params.hole_diameter = 8;
  Progress watch;
  params.entry = EntryKind::kAutomatic;
  EXPECT_TRUE(tells(clear_with_lame_spiral({ring(42, 20)}, params, {}, watch).report,
                    FindingCode::kHoleBesideIsland));
  Case island = corpus::load("lame_square_island");
  island.hole = corpus::Hole{{20, 20}, 8};
  params = island.params();
  params.entry = EntryKind::kPredrilledHole;
  EXPECT_EQ(refusal({island.region}, params), Refusal::kHoleAtIsland);
  params.entry = EntryKind::kAutomatic;
  EXPECT_TRUE(tells(clear_with_lame_spiral({island.region}, params, {}, watch).report,
                    FindingCode::kHoleInOpenStock));
}

TEST(LameClearing, AtAConstantFeedEndsRounderWhereThatIsQuicker) {
  const Case pocket = corpus::load("lame_square35");
  ClearingParams params = pocket.params();
  const LameToolpath even = spiral(pocket, params);
  params.feed_control = FeedControl::kConstantFeed;
  const LameToolpath path = spiral(pocket, params);
  const Findings found = corpus::judge(pocket, path);
  EXPECT_EQ(path.report.termination, Termination::kComplete);
  EXPECT_LE(found.cut_engagement, pocket.engagement_angle + 1 * kDegree);
  EXPECT_LE(found.gouge, 0.005);
  EXPECT_GT(path.figures->last.exponent, even.figures->last.exponent + 0.1);
  EXPECT_LE(path.report.cutting_time, 1.3 * path.report.ideal_time);
  EXPECT_FALSE(tells(path.report, FindingCode::kSlowSpiral));
  LameParams lame;
  lame.exponent_end = even.figures->last.exponent;  // what is set is kept, slow as it is
  const LameToolpath slow = spiral(pocket, params, lame);
  EXPECT_EQ(slow.figures->last.exponent, *lame.exponent_end);
  EXPECT_GT(slow.report.cutting_time, 1.2 * path.report.cutting_time);
  EXPECT_TRUE(tells(slow.report, FindingCode::kSlowSpiral));
}

TEST(LameClearing, AtAConstantFeedEndsRounderAroundIslandsAndInRingsToo) {
  for (const char* name : {"lame_hex_island", "square_island"}) {
    const Case pocket = corpus::load(name);
    ClearingParams params = pocket.params();
    const LameToolpath even = spiral(pocket, params);
    params.feed_control = FeedControl::kConstantFeed;
    const LameToolpath path = spiral(pocket, params);
    const Findings found = corpus::judge(pocket, path);
    EXPECT_EQ(path.report.termination, Termination::kComplete) << name;
    EXPECT_LE(found.cut_engagement, pocket.engagement_angle + 1 * kDegree) << name;
    EXPECT_LE(found.gouge, 0.005) << name;
    EXPECT_LE(found.left_share, 0.0005) << name;
    EXPECT_GT(path.figures->last.exponent, even.figures->last.exponent + 0.1) << name;
    LameParams lame;
    lame.exponent_end = even.figures->last.exponent;
    EXPECT_GT(spiral(pocket, params, lame).report.cutting_time, 1.04 * path.report.cutting_time)
        << name;
  }
}

TEST(LameClearing, EndsRounderWhereChipsOrForcesAreHeldButNotWhereTheRemovalRateIs) {
  const Case pocket = corpus::load("lame_square35");
  ClearingParams params = pocket.params();
  const double closest = spiral(pocket, params).figures->last.exponent;
  for (const FeedControl control :
       {FeedControl::kConstantChipThickness, FeedControl::kConstantForce}) {
    params.feed_control = control;
    params.force_coefficients = {796, 169, 28, 31};
    params.teeth = 1;
    params.spindle_speed = 6366;
    const LameToolpath path = spiral(pocket, params);
    EXPECT_LE(corpus::judge(pocket, path).cut_engagement, pocket.engagement_angle + 1 * kDegree);
    EXPECT_GT(path.figures->last.exponent, closest + 0.1);
    LameParams lame;
    lame.exponent_end = closest;
    EXPECT_GT(spiral(pocket, params, lame).report.cutting_time, 1.04 * path.report.cutting_time);
  }
}

TEST(LameClearing, OfALongRingEndsRounderAtAConstantRemovalRateToo) {
  // Along its narrow sides the turns to the closest curve would hardly cut.
  const ClearingParams params = corpus::load("lame_square35").params();
  const std::vector<Region> regions = {make_region(box(-60, -35, 120, 70), {circle({}, 14, true)})};
  const auto cleared = [&](const LameParams& lame) {
    Progress progress;
    return clear_with_lame_spiral(regions, params, lame, progress);
  };
  LameParams left;
  left.rest = LameRest::kLeave;
  const LameToolpath path = cleared({});
  LameParams closest;
  closest.exponent_end = cleared(left).figures->last.exponent;
  EXPECT_GT(path.figures->last.exponent, *closest.exponent_end + 0.1);
  EXPECT_LT(path.report.cutting_time, 0.98 * cleared(closest).report.cutting_time);
  // The rounder one is no longer than twice its width either.
  const auto [shorter, longer] = std::minmax(path.figures->last.a, path.figures->last.b);
  EXPECT_LE(longer, kLongest * shorter * 1.001);
}

TEST(LameClearing, OfAPocketThatNoCurveResemblesEndsRounderAndHasFewBlocks) {
  const Case pocket = corpus::load("star");
  const LameToolpath path = spiral(pocket, pocket.params());
  expect_within_limits(pocket, path, corpus::judge(pocket, path));
  const double length = path.report.cut_length + path.report.link_length;  // mm
  EXPECT_LE(static_cast<double>(path.moves.size()), 1.1 * length);
  EXPECT_LE(path.report.cutting_time, 1.2 * path.report.ideal_time);
  LameParams left;
  left.rest = LameRest::kLeave;
  LameParams closest;
  closest.exponent_end = spiral(pocket, pocket.params(), left).figures->last.exponent;
  EXPECT_GT(path.figures->last.exponent, *closest.exponent_end + 0.1);
  const LameToolpath close = spiral(pocket, pocket.params(), closest);
  EXPECT_LT(path.report.cutting_time, close.report.cutting_time);
  EXPECT_LT(path.moves.size(), 0.9 * static_cast<double>(close.moves.size()));
}

TEST(LameClearing, TheRestIsClearedAtASlightlySmallerAngle) {
  const auto less_by = [](double degrees) {
    ClearingParams params;
    params.engagement_angle = degrees * kDegree;
    return degrees - beside_spiral(params).engagement_angle / kDegree;
  };
  EXPECT_NEAR(less_by(100), 0.7, 1e-9);
  EXPECT_NEAR(less_by(60), 0.42, 1e-9);
  EXPECT_NEAR(less_by(15), 0.42, 1e-9);  // an excess is a larger part of a small angle
  EXPECT_NEAR(less_by(5), 0.15, 1e-9);
}

// Then a rounder curve would only leave more.
TEST(LameClearing, EndsNoRounderWhereTheRestIsLeft) {
  const Case pocket = corpus::load("lame_square35");
  ClearingParams params = pocket.params();
  params.feed_control = FeedControl::kConstantFeed;
  LameParams lame;
  lame.rest = LameRest::kLeave;
  EXPECT_GT(spiral(pocket, params, lame).cleared_share, 0.95);
}

TEST(LameClearing, NamesTheSetValueThatSpoilsTheSpiral) {
  const Region square = make_region(box(-17.5, -17.5, 35, 35));
  const ClearingParams params = corpus::load("lame_square35").params();
  LameParams lame;
  lame.centre = Vec2{8, 5};
  const std::optional<GeometryError> off_middle = error_of({square}, params, lame);
  ASSERT_TRUE(off_middle);
  EXPECT_EQ(off_middle->refusal(), Refusal::kSpiralTooSmallAtCentre);
  ASSERT_EQ(off_middle->numbers().size(), 1U);
  EXPECT_GT(off_middle->numbers()[0], 0);
  EXPECT_LT(off_middle->numbers()[0], kLeastShare);
  lame = {};
  lame.semi_axis_a = 0.1;
  EXPECT_EQ(refusal({square}, params, lame), Refusal::kSetSizeTooSmall);
  lame.semi_axis_a = lame.semi_axis_b = 5;
  Progress watch;
  EXPECT_TRUE(tells(clear_with_lame_spiral({square}, params, lame, watch).report,
                    FindingCode::kSpiralOfSetSize));
  ClearingParams off = params;
  off.entry = EntryKind::kPredrilledHole;
  off.entry_point = Vec2{13.5, 13.5};
  off.hole_diameter = 7;
  EXPECT_EQ(refusal({square}, off), Refusal::kHoleOffMiddle);
}

TEST(LameClearing, TellsWhyThereIsNoSpiral) {
  using enum Refusal;
  const ClearingParams params = corpus::load("lame_square35").params();
  const Region square = make_region(box(-17.5, -17.5, 35, 35)),
               slot = make_region(box(-60, -6, 120, 12)),
               two_islands = make_region(box(-40, -20, 80, 40),
                                         {circle({-20, 0}, 4, true), circle({20, 0}, 4, true)});
  LameParams beside, too_long, turned;
  beside.centre = Vec2{100, 0};
  too_long.semi_axis_a = 30;
  turned.rotation = 1;
  EXPECT_EQ(refusal({square}, params, beside), kCentreOutside);
  EXPECT_EQ(refusal({square}, params, too_long), kNoCurveAsSet);
  EXPECT_EQ(refusal({slot}, params), kSpiralTooSmall);
  EXPECT_EQ(refusal({slot}, params, turned), kSpiralTooSmallAsSet);
  EXPECT_EQ(refusal({two_islands}, params), kNotForSpirals);
  ClearingParams hole = params;
  hole.entry = EntryKind::kPredrilledHole;
  hole.entry_point = Vec2{35, 0};
  hole.hole_diameter = 8;
  EXPECT_EQ(refusal({ring(42, 20)}, hole), kHoleBesideChannel);
}

TEST(LameClearing, RefusesAHoleThatIsTooTightToTurnIn) {
  Case pocket = corpus::load("lame_hex50");
  pocket.hole = corpus::Hole{{0, 0}, 6};
  const std::optional<GeometryError> error = error_of({pocket.region}, pocket.params());
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code(), GeometryErrorCode::kEntryOutside);
  EXPECT_EQ(error->refusal(), Refusal::kHoleTooTightForSpiral);
}

TEST(LameClearing, RefusesPocketsThatNoCurveResembles) {
  for (const char* name : {"lshape", "comb", "slot9", "two_rooms"}) {
    const Case pocket = corpus::load(name);
    const std::optional<GeometryError> error = error_of({pocket.region}, pocket.params());
    ASSERT_TRUE(error) << name;
    EXPECT_EQ(error->code(), GeometryErrorCode::kNoLameCurve) << name;
  }
}

TEST(LameClearing, RefusesParametersOutOfRange) {
  const Case pocket = corpus::load("lame_hex50");
  const auto refused = [&](auto set) {
    LameParams lame;
    set(lame);
    EXPECT_THROW(spiral(pocket, pocket.params(), lame), std::invalid_argument);
  };
  refused([](LameParams& p) { p.segments = 2; });
  refused([](LameParams& p) { p.segments = 13; });
  refused([](LameParams& p) { p.semi_axis_a = 0; });
  refused([](LameParams& p) { p.semi_axis_b = NAN; });
  refused([](LameParams& p) { p.exponent_start = 1.1; });
  refused([](LameParams& p) { p.exponent_end = 0.01; });
  refused([](LameParams& p) { p.rotation = INFINITY; });
  refused([](LameParams& p) { p.pitch = 0; });
  refused([](LameParams& p) { p.centre = Vec2{NAN, 0}; });
  for (const auto course : {&LameParams::semi_axis_a_course, &LameParams::semi_axis_b_course,
                            &LameParams::exponent_course})
    for (const Course& values : {Course{1}, Course{0.1, 1}, Course{0, 0.9}, Course{0, 0.6, 0.5, 1},
                                 Course{0, NAN, 1}, Course{0, 1.5, 1}, Course(kMostCourse + 1)})
      refused([&](LameParams& p) { p.*course = values; });
  refused([](LameParams& p) {
    p.segments = 6;
    p.semi_axis_a = 10;
    p.semi_axis_b = 11;
  });
  ClearingParams rest = pocket.params();
  rest.stock = std::vector<Region>{pocket.region};
  EXPECT_THROW(spiral(pocket, rest), std::invalid_argument);
  LameParams too_long;
  too_long.semi_axis_a = 30;
  too_long.segments = 4;
  too_long.centre = Vec2{0, 0};
  EXPECT_THROW(spiral(pocket, pocket.params(), too_long), GeometryError);
}

}  // namespace
}  // namespace evenload
