#include "judge/posted.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "toolpath/path_commands.h"

namespace evenload {
namespace {

// One command's move from where the tool is.
Move move_of(const PathCommand& command, MoveKind kind, const Position& at) {
  Move move{command.code == 0 ? MoveKind::kRapid : kind,
            command.x.value_or(at.x),
            command.y.value_or(at.y),
            command.z.value_or(at.z),
            0,
            0,
            0,
            command.feed.value_or(0)};
  if (command.code < 2) return move;
  const Vec2 from{-*command.i, -*command.j}, to{move.x - at.x + from.x, move.y - at.y + from.y};
  const double turned = std::atan2(cross(from, to), dot(from, to));
  move.sweep = command.code == 3 ? wrap_positive(turned) : -wrap_positive(-turned);
  move.cx = at.x + *command.i;
  move.cy = at.y + *command.j;
  return move;
}

}  // namespace

std::vector<Move> posted(const std::vector<Move>& moves) {
  std::vector<Move> result;
  std::optional<Position> at;
  // The first command only rises: anywhere will do, and far away the judge would look all the way.
  const Position above{moves.front().x, moves.front().y, moves.front().z};
  for (auto first = moves.begin(); first != moves.end();) {
    const auto last = std::find_if(first, moves.end(),
                                   [&](const Move& move) { return move.kind != first->kind; });
    for (const PathCommand& command : path_commands({first, last}, at)) {
      result.push_back(move_of(command, first->kind, at.value_or(above)));
      at = {result.back().x, result.back().y, result.back().z};
    }
    first = last;
  }
  return result;
}

}  // namespace evenload
