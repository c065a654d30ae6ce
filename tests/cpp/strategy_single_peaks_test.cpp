// What a cut meets at single places, which means over 0.1 mm may hide.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "corpus.h"
#include "cutting/cleared_ground.h"
#include "geometry/box_tree.h"
#include "strategy/moves/move_checks.h"
#include "strategy/pocket/constant_engagement.h"

namespace evenload {
namespace {

constexpr double kLook = 0.005;  // mm, between two looks
constexpr double kThin = 1e-6;   // mm: thinner material is not seen

Segment flat(const Move& before, const Move& move) {
  const Vec2 from{before.x, before.y}, to{move.x, move.y};
  if (move.sweep == 0) return Segment::line(from, to);
  const Vec2 centre{move.cx, move.cy};
  return Segment::arc(centre, distance(centre, from), angle_of(from - centre), move.sweep);
}

// rad: the most that a cut meets where it turns to the right.
double most_in_right_turns(const corpus::Case& pocket, const Toolpath& path) {
  const double radius = 0.5 * pocket.tool_diameter;
  ClearedGround ground(bounds_of({pocket.region}), radius, nullptr);
  std::vector<AngularInterval> arcs;
  double most = 0;
  for (std::size_t i = 1; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    if (move.kind == MoveKind::kRapid) continue;
    const Segment way = flat(path.moves[i - 1], move);
    if (way.length() < kThin) continue;
    const bool is_right_turn = move.kind == MoveKind::kCut && move.sweep < 0;
    const int looks = is_right_turn ? static_cast<int>(std::ceil(way.length() / kLook)) : 0;
    for (int k = 0; k < looks; ++k) {
      const double t = (k + 0.5) / looks, heading = angle_of(way.tangent(t));
      most = std::max(most, engagement_ahead(ground, way.point(t), heading, kThin, arcs));
    }
    ground.add(way);
  }
  return most;
}

TEST(SinglePeaks, AreSeenWhereTheRightSideComesFreeInARightTurn) {
  const corpus::Case pocket = corpus::load("peak_in_a_right_turn");
  Progress progress;
  const Toolpath path = clear_pocket({pocket.region}, pocket.params(), progress);
  EXPECT_LT(most_in_right_turns(pocket, path), pocket.engagement_angle + 2 * kPi / 180);
}

}  // namespace
}  // namespace evenload
