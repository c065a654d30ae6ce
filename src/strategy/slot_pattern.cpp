#include "strategy/slot_pattern.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cutting/engagement.h"
#include "strategy/circular_trochoid.h"
#include "strategy/trochoid_pattern.h"

namespace evenload {
namespace {

// Share of the side step at the limit that is left beside a wall at most: the scallops of the
// pattern come on top.
constexpr double kMostBeside = 0.9;
// Shares of half the room that are tried, the last the most.
constexpr double kOfRoom[] = {1.0 / 3, 0.5};

// min for a mm of the slot: the pattern, and the passes along both walls.
double time_per_length(const PatternFigures& figures, const TrochoidPattern& pattern,
                       const TrochoidParams& slot, double beside) {
  if (beside <= 0) return figures.time / pattern.step;
  const double nominal = side_step(slot.engagement, slot.tool_radius);
  const double feed = std::min(slot.maximum_feed, slot.feed * nominal / beside);
  return figures.time / pattern.step + 2 / feed;
}

}  // namespace

std::optional<TrochoidPattern> make_pattern(TrochoidKind kind, const TrochoidParams& params) {
  switch (kind) {
    case TrochoidKind::kConstantEngagement:
      return constant_engagement_pattern(params);
    case TrochoidKind::kCircular:
      return circular_pattern(params);
    case TrochoidKind::kCycloid:
      return cycloid_pattern(params);
  }
  return std::nullopt;
}

double most_beside(const TrochoidParams& slot) {
  double limit = side_step(slot.engagement, slot.tool_radius);
  if (slot.curvature != 0) {  // the wall outside is concave
    const double wall = 1 / std::abs(slot.curvature) + 0.5 * slot.width;
    limit = side_step_on_contour(slot.engagement, slot.tool_radius, wall, Contour::kConcave);
  }
  return std::min(kMostBeside * limit, kOfRoom[1] * half_room(slot));
}

std::optional<SlotPattern> slot_pattern(TrochoidKind kind, const TrochoidParams& slot) {
  std::optional<TrochoidPattern> whole = make_pattern(kind, slot);
  if (!whole) return std::nullopt;
  SlotPattern best;
  best.front = whole->cut;
  if (kind != TrochoidKind::kConstantEngagement)  // loops cut on beyond the left wall
    best.front = {Segment::arc({}, half_room(slot), -kPi / 2, kPi)};
  TrochoidPattern front;
  front.cut = best.front;
  front.curvature = slot.curvature;
  best.front_ahead = reach_of(front).ahead;
  double least = time_per_length(figures_of(*whole, slot), *whole, slot, 0);
  best.pattern = std::move(*whole);
  if (kind == TrochoidKind::kConstantEngagement)
    for (const double share : kOfRoom) {
      const double beside = std::min(most_beside(slot), share * half_room(slot));
      if (beside <= best.beside) break;
      TrochoidParams narrow = slot;
      narrow.finish_walls = false;
      narrow.width -= 2 * beside;
      std::optional<TrochoidPattern> pattern = make_pattern(kind, narrow);
      if (!pattern) break;
      const double time = time_per_length(figures_of(*pattern, narrow), *pattern, slot, beside);
      if (time >= least) break;
      least = time;
      best.pattern = std::move(*pattern);
      best.beside = beside;
    }
  best.reach = reach_of(best.pattern);
  best.removal = slot.width / least;
  return best;
}

}  // namespace evenload
