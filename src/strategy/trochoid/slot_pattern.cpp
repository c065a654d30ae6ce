#include "strategy/trochoid/slot_pattern.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "cutting/engagement.h"
#include "strategy/trochoid/circular_trochoid.h"
#include "strategy/trochoid/trochoid_pattern.h"
#include "support/both.h"

namespace evenload {
namespace {

// Share of the side step at the limit that is left beside a wall at most: the scallops of the
// pattern come on top.
constexpr double kMostBeside = 0.9;
// Share of half the room: a helix that clears what lies behind a front is as wide at the most.
constexpr double kCircleBehind = 0.99;
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

namespace {

// A pattern that leaves so much beside either wall.
struct Width {
  double beside = 0;  // mm
  TurnSearch search;
  double time(const TurnSearch::Found& found, const TrochoidParams& slot) const {
    return time_per_length(found.figures, found.pattern, slot, beside);
  }
};

// As wide as the slot, and narrower, the wider first.
std::vector<double> all_beside(const TrochoidParams& slot) {
  std::vector<double> all{0};
  for (const double share : kOfRoom) {
    const double beside = std::min(most_beside(slot), share * half_room(slot));
    if (beside > all.back()) all.push_back(beside);
  }
  return all;
}

TrochoidParams narrowed(const TrochoidParams& slot, double beside) {
  TrochoidParams narrow = slot;
  narrow.width -= 2 * beside;
  narrow.finish_walls = beside <= 0;
  return narrow;
}

// A width with the first of its patterns; nothing where none of them serves.
struct Candidate {
  Width width;
  double time = 0;  // min for a mm of the slot
};

std::optional<Candidate> candidate(const TrochoidParams& slot, double beside,
                                   const TurnSearch* like) {
  Candidate result{{beside, TurnSearch(narrowed(slot, beside), like)}, 0};
  const TurnSearch::Found* found = result.width.search.first();
  if (!found) return std::nullopt;
  result.time = result.width.time(*found, slot);
  return result;
}

// But for the front and what follows from that.
std::optional<SlotPattern> constant_engagement(const TrochoidParams& slot) {
  const std::vector<double> beside = all_beside(slot);
  std::optional<Candidate> best = candidate(slot, 0, nullptr);
  if (!best) return std::nullopt;
  SlotPattern result;
  result.front = best->width.search.first()->pattern.cut;
  const TurnSearch whole = best->width.search;
  std::vector<std::optional<Candidate>> narrower(beside.size() - 1);
  if (narrower.size() == 2)
    std::tie(narrower[0], narrower[1]) =
        both([&] { return candidate(slot, beside[1], &whole); },
             [&] { return candidate(slot, beside[2], &whole); }, slot.progress);
  else if (narrower.size() == 1)
    narrower[0] = candidate(slot, beside[1], &whole);
  // The narrower the pattern the more time the walls take: once it pays no longer, it does not
  // again.
  for (std::optional<Candidate>& next : narrower) {
    if (!next || next->time >= best->time) break;
    best = std::move(next);
  }
  const std::optional<TurnSearch::Found> found = best->width.search.best();
  result.pattern = found->pattern;
  result.beside = best->width.beside;
  result.removal = slot.width / best->width.time(*found, slot);
  if (result.beside <= 0) result.front = found->pattern.cut;
  return result;
}

std::optional<SlotPattern> loops(TrochoidKind kind, TrochoidParams slot) {
  slot.finish_walls = true;
  std::optional<TrochoidPattern> pattern = make_pattern(kind, slot);
  if (!pattern) return std::nullopt;
  SlotPattern result;
  result.kind = kind;
  result.front = {Segment::arc({}, half_room(slot), -kPi / 2, kPi)};  // they go on beyond it
  result.removal = slot.width / time_per_length(figures_of(*pattern, slot), *pattern, slot, 0);
  result.pattern = std::move(*pattern);
  return result;
}

}  // namespace

bool has_corners(const SlotPattern& pattern) {
  return turns_at_corners(pattern.pattern.cut) || turns_at_corners(pattern.pattern.link);
}

std::optional<SlotPattern> slot_pattern(TrochoidKind kind, const TrochoidParams& slot) {
  std::optional<SlotPattern> result =
      kind == TrochoidKind::kConstantEngagement ? constant_engagement(slot) : loops(kind, slot);
  if (!result) return std::nullopt;
  if (kind == TrochoidKind::kConstantEngagement && has_corners(*result) &&
      half_room(slot) > kLeastCircle * slot.tool_radius) {
    std::optional<SlotPattern> circles = loops(TrochoidKind::kCircular, slot);
    if (circles && !has_corners(*circles)) result = std::move(circles);
  }
  TrochoidPattern front;
  front.cut = result->front;
  front.curvature = slot.curvature;
  result->front_ahead = reach_of(front).ahead;
  result->reach = reach_of(result->pattern);
  result->circle_behind = circles_through(front, kCircleBehind * half_room(slot)).first;
  result->circle_ahead = circles_through(result->pattern, half_room(slot)).last;
  return result;
}

}  // namespace evenload
