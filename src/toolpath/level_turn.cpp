#include "toolpath/level_turn.h"

#include <algorithm>
#include <cmath>

#include "toolpath/helix.h"

namespace evenload {
namespace {

// From piece to piece the feed rises by no more than this share.
constexpr double kLevelStep = 0.2;
// mm: no piece is shorter, unless the turn is.
constexpr double kShortestTurn = 0.2;

}  // namespace

std::vector<LevelPiece> level_pieces(const Descent& helix, double depth, double steepness,
                                     double tool_radius, const LevelTurnFeeds& feeds) {
  const double length = 2 * half_turn_length(helix);
  // mm^3/min over mm^2: the feed is this over the layer's thickness.
  const double whole = feeds.rate * depth / (2 * tool_radius);
  const double highest = std::max(feeds.plunge, feeds.highest);
  const double first =
      std::clamp(whole / std::min(depth, steepness * length), feeds.plunge, highest);
  const int steps = static_cast<int>(std::ceil(std::log(highest / first) / std::log1p(kLevelStep)));
  const auto feed = [&](int step) {
    return first * std::pow(highest / first, static_cast<double>(step) / std::max(1, steps));
  };
  std::vector<LevelPiece> pieces;
  double from = 0;
  int lowest = 0;  // step of the feed that the present piece begins with
  for (int i = 0; i < steps; ++i) {
    const double end = length - whole / (steepness * feed(i + 1));
    if (std::min(end - from, length - end) < kShortestTurn) continue;
    pieces.push_back({end, feed(lowest)});
    from = end;
    lowest = i + 1;
  }
  pieces.push_back({length, feed(lowest)});
  return pieces;
}

double duration(const std::vector<LevelPiece>& pieces) {
  double minutes = 0, from = 0;
  for (const LevelPiece& piece : pieces) {
    minutes += (piece.end - from) / piece.feed;
    from = piece.end;
  }
  return minutes;
}

}  // namespace evenload
