#include "strategy/task/turn_report.h"

#include <iomanip>
#include <sstream>

namespace evenload {

void TightTurns::add(const TightTurns& more) {
  rooms += more.rooms;
  if (more.radius >= radius) return;
  radius = more.radius;
  at = more.at;
}

std::optional<std::string> tight_turns_note(const TightTurns& turns, double wish) {
  if (turns.rooms == 0) return std::nullopt;
  std::ostringstream note;
  note << std::fixed << std::setprecision(3) << "Turned more tightly than the wished " << wish
       << " mm in narrow places";
  if (turns.rooms > 1) note << " of " << turns.rooms << " rooms";
  note << ", down to " << turns.radius << " mm near (" << std::setprecision(2) << turns.at.x << ", "
       << turns.at.y << ").";
  return note.str();
}

}  // namespace evenload
