#include "strategy/pass_ends.h"

#include "strategy/move_ends.h"

namespace evenload {
namespace {

// mm: a pass that begins with a shorter move, which posts would turn by a degree or more, begins
// earlier by so much.
constexpr double kShortestStart = 0.03;

}  // namespace

void begin_earlier(std::vector<Segment>& way, const GroundBefore& ground, const Area& centres) {
  Segment& first = way.front();
  for (const double length :
       {lacking_length(first), first.length() < kShortestStart ? kShortestStart : 0}) {
    if (length <= 0) continue;
    const Segment longer = begun_before(first, length);
    const Segment lead = longer.part(0, length / longer.length());
    if (!is_free(ground, centres, {lead}, length)) continue;
    first = longer;
    return;
  }
}

void end_later(std::vector<Segment>& way, const GroundBefore& ground, const Area& centres) {
  Segment& last = way.back();
  const double length = lacking_length(last);
  if (length <= 0) return;
  const Segment longer = ended_after(last, length);
  const Segment added = longer.part(1 - length / longer.length(), 1);
  if (is_free(ground, centres, {added}, length)) last = longer;
}

}  // namespace evenload
