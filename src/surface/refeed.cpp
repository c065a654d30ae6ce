#include "surface/refeed.h"

#include "support/demand.h"
#include "surface/waypoint.h"

namespace evenload {

namespace {

Waypoint end_of(const Move& move) { return {{move.x, move.y, move.z}, move.sweep}; }

}  // namespace

Toolpath with_feeds(const Toolpath& path, const std::vector<FedPiece>& pieces, double plunge_feed) {
  Toolpath result;
  result.report = path.report;
  std::size_t next = 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    if (next == pieces.size() || pieces[next].move != i) {
      result.moves.push_back(move);
      continue;
    }
    demand(i > 0 && move.kind != MoveKind::kRapid && move.feed > 0,
           "Feeds are those of moves that have one.");
    const Move& before = path.moves[i - 1];
    const SpacePoint start{before.x, before.y, before.z};
    const double length = way_length(start, end_of(move)), down = start.z - move.z;
    double seconds = -kSecondsPerMinute * length / move.feed, from = 0;
    for (; next < pieces.size() && pieces[next].move == i; ++next) {
      const FedPiece& piece = pieces[next];
      demand(piece.until > from && piece.until <= 1 && piece.feed > 0,
             "Pieces of a move follow each other and have positive feeds.");
      const SpacePoint end =
          piece.until < 1 ? place_on(start, end_of(move), piece.until) : SpacePoint(end_of(move));
      Move part = move;
      part.x = end.x, part.y = end.y, part.z = end.z;
      part.sweep = (piece.until - from) * move.sweep;
      part.feed =
          down * piece.feed > plunge_feed * length ? plunge_feed * length / down : piece.feed;
      seconds += kSecondsPerMinute * (piece.until - from) * length / part.feed;
      result.moves.push_back(part);
      from = piece.until;
    }
    demand(from == 1, "The last piece of a move ends where the move does.");
    result.report.cutting_time += seconds;
  }
  demand(next == pieces.size(), "Pieces are in the order of their moves.");
  return result;
}

}  // namespace evenload
