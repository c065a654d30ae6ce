#include "strategy/task/turn_report.h"

namespace evenload {

void TightTurns::add(const TightTurns& more) {
  rooms += more.rooms;
  if (more.radius >= radius) return;
  radius = more.radius;
  at = more.at;
}

std::optional<Finding> finding_of(const TightTurns& turns, double wish) {
  if (turns.rooms == 0) return std::nullopt;
  return Finding{
      FindingCode::kTightTurns, turns.at, {turns.radius, wish, static_cast<double>(turns.rooms)}};
}

}  // namespace evenload
