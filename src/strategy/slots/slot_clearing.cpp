#include "strategy/slots/slot_clearing.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "cutting/load_budget.h"
#include "strategy/moves/move_ends.h"
#include "strategy/reach/links.h"
#include "strategy/slots/pattern_notes.h"
#include "strategy/slots/slot_end.h"
#include "strategy/slots/slot_junctions.h"
#include "strategy/slots/slot_rooms.h"
#include "strategy/slots/slot_start.h"
#include "strategy/slots/slot_way.h"
#include "strategy/slots/slot_ways.h"
#include "support/errors.h"
#include "support/tolerances.h"

namespace evenload {
namespace {

constexpr MoveTags kInPattern{-1, true};

ClearingParams for_passes(ClearingParams params) {
  params.engagement_angle -= load_budget::spared_beside_patterns(params.engagement_angle);
  params.feed_steps = kSlotFeedSteps;
  params.move_price = kSlotFeedSteps.price;
  return params;
}

class SlotClearing {
 public:
  // `passes`: where no pattern is repeated.
  SlotClearing(const RegionTask& task, const ClearingParams& params, const ClearingParams& passes,
               PatternCache& patterns, TrochoidReport& report, Progress& progress)
      : task_(task),
        params_(params),
        passes_(passes),
        patterns_(patterns),
        progress_(progress),
        radius_(0.5 * params.tool_diameter),
        turn_radius_(std::max(params.roll_radius, params.minimum_radius)),
        centres_({task.centres}),
        plan_(task, params, progress),
        found_(task, params, centres_, patterns),
        ways_(found_.ways),
        start_(task, params, centres_, found_),
        notes_(task, params, plan_, report) {}

  RegionResult run() {
    repeat(Use::kSlots);
    if (notes_.circles_at() && patterns_.kind() == TrochoidKind::kConstantEngagement)
      plan_.tell({FindingCode::kCirclesForPattern, shown_place(task_, *notes_.circles_at())});
    if (!is_repeated()) {
      passes_.feed_steps = params_.feed_steps;
      passes_.move_price = params_.move_price;
    }
    clear_region(plan_, task_, passes_, progress_);
    if (!is_repeated() && !progress_.cancelled()) plan_.tell(found_.why_none());
    return plan_.take();
  }

  std::optional<RegionResult> run_where_patterns_serve() {
    repeat(Use::kPockets);
    if (!is_repeated()) return std::nullopt;
    clear_region(plan_, task_, passes_, progress_);
    return plan_.take();
  }

 private:
  using Use = SlotWays::Use;

  void repeat(Use use) {
    if (task_.rest) return;
    try {
      found_.find(use);
      if (begin(use)) follow_ways();
    } catch (const Cancelled&) {  // what is made is kept
    }
    early_ends_.reset();
  }

  bool is_repeated() const { return notes_.is_repeated(); }

  // ---- the start ----

  // Makes ground in which a way can begin. False where there is none.
  bool begin(Use use) {
    if (ways_.empty()) return false;
    if (task_.has_open_edges && params_.entry == EntryKind::kAutomatic) {
      if (start_.is_outside(plan_.ground())) return true;
      if (use == Use::kPockets) return false;  // passes find the open side
    }
    if (task_.hole) {
      const std::optional<Region> room = start_.about_hole();
      return room && clear_room(*room);
    }
    if (params_.entry == EntryKind::kPredrilledHole) return false;
    return clear_first_room(SlotStart::Place::kBegin) ||
           clear_first_room(SlotStart::Place::kPastJunction);
  }

  // Of the longest ways that have one.
  bool clear_first_room(SlotStart::Place place) {
    for (std::size_t first = 0, last = 0; first < ways_.size(); first = last) {
      const double length = ways_[first].length();
      while (last < ways_.size() && ways_[last].length() > length - kOnWall) ++last;
      const std::optional<WayBegin> begin = start_.smallest_end(first, last, place);
      if (!begin) continue;
      begin_ends(*begin->way);
      if (clear_room(begin->start.room)) return true;
    }
    return false;
  }

  // On another core: of all ways but the one that ends where `followed_first` begins. Those of ways
  // that are not followed are cleared in vain.
  void begin_ends(const Way& followed_first) {
    std::vector<std::unique_ptr<EarlyEnd>> ends;
    for (const Way& way : ways_) {
      const bool is_start = is_reverse(way.stretch.middle, followed_first.stretch.middle);
      if (is_start || start_.first_place(way) > way.last()) continue;
      if (auto end = EarlyEnd::of(task_, centres_, way, start_.first_place(way), passes_))
        ends.push_back(std::move(end));
    }
    early_ends_ = std::make_unique<EarlyEnds>(std::move(ends));
  }

  static bool is_reverse(const Segment& a, const Segment& b) {
    return distance(a.a, b.b) < kOnWall && distance(a.b, b.a) < kOnWall;
  }

  // False where the tool finds no way in.
  bool clear_room(const Region& room) {
    std::optional<RegionResult> cleared = clear_part(plan_, task_, room, passes_, progress_);
    if (!cleared) return false;
    plan_.adopt(std::move(*cleared));
    return !plan_.is_empty();
  }

  // ---- the way ----

  void follow_ways() {
    while (!progress_.cancelled() && (follow_one() || clear_next_room())) continue;
  }

  // The first way that can begin in cleared ground. False where none can.
  bool follow_one() {
    for (const Way& way : ways_) {
      const std::optional<int> first = first_to_cut(way, plan_.ground());
      if (!first) continue;
      const int last = follow(way, *first);
      if (!progress_.cancelled()) clear_end(way, *first, last);
      return true;
    }
    return false;
  }

  // Where a junction is cleared, but not so far that a way could go on from it: up to that way's
  // front. Every way once.
  bool clear_next_room() {
    for (Way& way : ways_) {
      const std::optional<double> edge = edge_of_material(way, plan_.ground());
      if (way.has_next_room || !edge) continue;
      const double s = std::max(-way.reach.back, *edge - way.reach.ahead + radius_);
      if (way.last() - s < kFewestPeriods * way.pattern.step) continue;
      way.has_next_room = true;
      const std::vector<Segment> front = placed(way.front, pose_on(way.stretch, s));
      std::optional<Region> room = room_behind(task_.centres, centres_, front);
      if (!room || !is_mostly_clear(way, *room, ways_, plan_.ground()))
        room = corner_behind(front, ways_, task_.centres, centres_, radius_);
      if (room && is_mostly_clear(way, *room, ways_, plan_.ground()) && clear_room(*room))
        return true;
    }
    return false;
  }

  // The end of the slot beyond the last period, so that the walls are left to passes from there.
  void clear_end(const Way& way, int first, int last) {
    EarlyEnd* const early = early_ends_ && last == 0 ? early_ends_->of(way, first) : nullptr;
    if (early) {
      if (std::optional<RegionResult> end = early->cleared(progress_))
        plan_.go_on_by(std::move(*end));
      return;
    }
    const std::optional<Region> room = end_room(task_.centres, centres_, way, last);
    if (room) clear_room(*room);
  }

  // Repeats the pattern from the period `first` on; returns the last one.
  int follow(const Way& way, int first) {
    const double begin = place_of(way, first);
    int period = first;
    for (; period >= 0 && !progress_.cancelled(); --period) {
      const double s = place_of(way, period);
      if (period < first && !has_work(way, plan_.ground(), s)) break;
      const std::vector<Segment> cut = cut_at(way, s);
      // Once as much is cut as a period reaches, the ground is what the pattern left.
      const bool is_sure = s - begin > way.reach.ahead - way.reach.back + 2 * radius_;
      if (period == first)
        go_to({cut.front().a, angle_of(cut.front().tangent(0))});
      else
        link_back(placed(way.pattern.link, pose_on(way.stretch, place_of(way, period + 1))),
                  is_sure, {cut.front().a, angle_of(cut.front().tangent(0))});
      plan_.add(MoveKind::kCut, cut, kInPattern);
      plan_.count_pass();
      progress_.report(std::min(1.0, s / way.stretch.middle.length()));
    }
    const double end = place_of(way, period);
    notes_.repeated(way, end - begin, cut_at(way, begin));
    return period + 1;
  }

  void link_back(const std::vector<Segment>& link, bool is_sure, const Pose& to) {
    if (!is_sure &&
        !is_free({plan_.ground(), plan_.ground().size()}, centres_, link, length_of(link))) {
      go_to(to);
      return;
    }
    plan_.add(MoveKind::kLink, link, kInPattern);
  }

  void go_to(const Pose& to) {
    if (!plan_.link_to(to, centres_, turn_radius_)) plan_.plunge(to, !plan_.is_empty());
  }

  const RegionTask& task_;
  const ClearingParams& params_;
  ClearingParams passes_;
  PatternCache& patterns_;
  Progress& progress_;
  double radius_, turn_radius_;
  Area centres_;
  Plan plan_;
  SlotWays found_;
  std::vector<Way>& ways_;  // those found
  SlotStart start_;
  PatternNotes notes_;
  std::unique_ptr<EarlyEnds> early_ends_;
};

}  // namespace

RegionResult clear_slots_of(const RegionTask& task, const ClearingParams& params,
                            PatternCache& patterns, TrochoidReport& report, Progress& progress) {
  return SlotClearing(task, params, for_passes(params), patterns, report, progress).run();
}

std::optional<RegionResult> clear_where_patterns_serve(const RegionTask& task,
                                                       const ClearingParams& params,
                                                       PatternCache& patterns,
                                                       TrochoidReport& report, Progress& progress) {
  return SlotClearing(task, params, params, patterns, report, progress).run_where_patterns_serve();
}

}  // namespace evenload
