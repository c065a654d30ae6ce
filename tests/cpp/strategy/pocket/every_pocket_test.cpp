// The laws of constant-engagement clearing in every pocket of the corpus, by a judge that shares no
// code with it. All tests of a pocket run in one process, which clears it as its file says once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "judge/corpus_laws.h"
#include "judge/narrow_pockets.h"
#include "judge/posted.h"
#include "support/errors.h"

namespace evenload {
namespace {

using corpus::at_home;
using corpus::Case;
using corpus::Home;
using corpus::name_of;
using path_check::Findings;

class EveryPocket : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Pocket, EveryPocket, testing::ValuesIn(corpus::clearable()), name_of);

TEST_P(EveryPocket, IsClearedWithinTheLimits) {
  const Home& home = at_home(GetParam());
  const Case& pocket = home.pocket;
  const Report& report = home.path.report;
  const Findings& found = home.seen;
  const ClearingParams params = pocket.params();
  corpus::expect_within_limits(pocket, home.path, found);
  EXPECT_NEAR(report.max_engagement, found.cut_engagement, 2 * kDegree);
  // A helix clears its disc in less than the ideal time where the engagement angle is small.
  const double disc = kPi * std::pow(0.5 * (params.helix_diameter + params.tool_diameter), 2);
  EXPECT_GE(report.cutting_time, 0.9 * report.ideal_time * (1 - disc / found.reachable_area));
  EXPECT_NEAR(report.cut_length, found.cut_length, 1e-3 * found.cut_length);
  EXPECT_NEAR(report.link_length, found.link_length, 1e-3 * found.link_length + 1e-3);
  EXPECT_LE(report.uncut_area, corpus::kMostLeft * found.reachable_area);
  EXPECT_GE(found.climb_length,
            corpus::kLeastClimb * (found.climb_length + found.conventional_length));
}

TEST_P(EveryPocket, IsCutAtTheNominalRateAndAtFeedsWithinTheirCaps) {
  const Home& home = at_home(GetParam());
  const ClearingParams params = home.pocket.params();
  EXPECT_LE(home.seen.removal_rate, corpus::most_rate(home.pocket))
      << "at " << home.seen.removal_rate_at.x << ", " << home.seen.removal_rate_at.y;
  const std::vector<Move>& moves = home.path.moves;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const Move& move = moves[i];
    if (move.kind == MoveKind::kCut) {
      EXPECT_LE(move.feed, params.maximum_feed);
      EXPECT_GT(move.feed, 0);
    }
    if (move.kind == MoveKind::kLink) {
      EXPECT_EQ(move.feed, params.link_feed);
    }
    if (move.kind == MoveKind::kEntry && move.z < moves[i - 1].z) {
      EXPECT_EQ(move.feed, params.plunge_feed);
    } else if (move.kind == MoveKind::kEntry) {
      EXPECT_GE(move.feed, params.plunge_feed);
      EXPECT_LE(move.feed, params.maximum_feed);
    }
  }
}

TEST_P(EveryPocket, IsClearedTheSameWhenItIsTurnedAndMirrored) {
  const Home& home = at_home(GetParam());
  corpus::expect_same_when_moved(home.pocket, home.path, 17 * kDegree, true, {});
}

TEST_P(EveryPocket, IsCrossedRapidlyAtTheSafeHeightOnly) {
  const Home& home = at_home(GetParam());
  const ClearingParams params = home.pocket.params();
  const std::vector<Move>& moves = home.path.moves;
  EXPECT_EQ(moves.front().kind, MoveKind::kRapid);
  EXPECT_EQ(moves.front().z, params.clearance_height);
  for (std::size_t i = 1; i < moves.size(); ++i) {
    const Move &from = moves[i - 1], &to = moves[i];
    if (to.kind != MoveKind::kRapid || (from.x == to.x && from.y == to.y)) continue;
    EXPECT_GE(std::min(from.z, to.z), params.safe_height);
  }
}

// What FreeCAD's dressups take for corners between lines: none is a turn by half a circle.
TEST_P(EveryPocket, HasNoLineThatLeadsStraightBackOnTheOneBefore) {
  if (GetParam() == "tip_of_micrometres") return;  // half a micrometre is no room beside a cut
  const std::vector<Move>& moves = at_home(GetParam()).path.moves;
  std::optional<Vec2> last;  // the direction of the line before
  for (std::size_t i = 1; i < moves.size(); ++i) {
    const Vec2 way = Vec2{moves[i].x, moves[i].y} - Vec2{moves[i - 1].x, moves[i - 1].y};
    const bool is_line = moves[i].sweep == 0 && moves[i].kind != MoveKind::kRapid &&
                         moves[i].kind != MoveKind::kEntry && norm(way) > 1e-6;
    if (is_line && last) {
      const double turn = std::abs(wrap_signed(angle_of(way) - angle_of(*last)));
      EXPECT_LT(turn, kPi - 0.01) << "at " << moves[i - 1].x << ", " << moves[i - 1].y;
    }
    last = is_line ? std::optional(way) : std::nullopt;
  }
}

// Where no passage is cut at a reduced feed, that choice changes nothing: the path is the one at
// home, whose bytes come again.
TEST_P(EveryPocket, IsClearedByTheSameBytesAgainAndWithinTheLimitsAtAReducedFeed) {
  const Home& home = at_home(GetParam());
  ClearingParams params = home.pocket.params();
  params.narrow_passages = NarrowPassages::kReducedFeed;
  const Toolpath path = corpus::clear(home.pocket, params);
  if (narrow_pockets::reduced(path) == 0) {
    corpus::expect_same_bytes(home.path, path);
    return;
  }
  EXPECT_LE(narrow_pockets::expect_cleared(home.pocket, path).removal_rate,
            corpus::most_rate(home.pocket));
  corpus::expect_same_bytes(home.path, corpus::clear(home.pocket, home.pocket.params()));
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

// Posts round to micrometres, which turns moves of some hundredths of a millimetre by a degree: a
// few in a pocket are worth no mechanism.
constexpr int kMostKinks = 5;
// mm: whether there is material where a move begins is seen in few looks.
constexpr double kStepForKinks = 0.1;

TEST_P(EveryPocket, IsPostedWithHardlyATurnOfMoreThanADegreeButAtSharpCorners) {
  Home home = at_home(GetParam());
  home.path.moves = posted(home.path.moves);
  path_check::Settings settings;
  settings.step = kStepForKinks;
  const Findings found = corpus::judge(home.pocket, home.path, settings);
  EXPECT_LE(found.kinks, sharp_corners(home.pocket.region) + kMostKinks)
      << "the worst by " << found.worst_kink / kDegree << " degrees at " << found.worst_kink_at.x
      << ", " << found.worst_kink_at.y;
}

class ATooSmallPocket : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Pocket, ATooSmallPocket, testing::Values("too_small"), name_of);

TEST_P(ATooSmallPocket, NamesTheLargestToolThatFits) {
  const Case pocket = corpus::load(GetParam());
  try {
    corpus::clear(pocket, pocket.params());
    FAIL() << "no error";
  } catch (const GeometryError& error) {
    EXPECT_EQ(error.code(), GeometryErrorCode::kToolTooLarge);
    EXPECT_EQ(error.refusal(), Refusal::kToolFitsNowhere);
    ASSERT_EQ(error.numbers().size(), 2U);
    EXPECT_EQ(error.numbers()[0], pocket.tool_diameter);
    EXPECT_NEAR(error.numbers()[1], 5, 0.01);
  }
}

TEST(Corpus, HoldsTheCasesThatWereWrittenForIt) { EXPECT_GE(corpus::names().size(), 25u); }

}  // namespace
}  // namespace evenload
