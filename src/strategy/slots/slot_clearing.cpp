#include "strategy/slots/slot_clearing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "cutting/load_budget.h"
#include "feed/load_profile.h"
#include "geometry/box_tree.h"
#include "strategy/moves/move_ends.h"
#include "strategy/reach/entry.h"
#include "strategy/reach/links.h"
#include "strategy/slots/slot_end.h"
#include "strategy/slots/slot_rooms.h"
#include "strategy/slots/slot_way.h"
#include "strategy/trochoid/slot.h"
#include "strategy/trochoid/trochoid_pattern.h"
#include "support/errors.h"
#include "support/tolerances.h"

namespace evenload {
namespace {

// Fewer periods are not worth a pattern.
constexpr int kFewestPeriods = 4;
// Half rooms: a junction reaches no further.
constexpr double kLongestJunction = 8;
// The same: so far beyond the corner inside where two ways meet both walls of a way are there.
constexpr double kPastCorner = 1.1;
// The same: a little narrower than expected, a helix needs so much more for as many turns.
constexpr double kHelixRoom = 0.01;

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
        report_(report),
        progress_(progress),
        radius_(0.5 * params.tool_diameter),
        turn_radius_(std::max(params.roll_radius, params.minimum_radius)),
        length_before_(report.length),
        centres_({task.centres}),
        plan_(task, params, progress) {}

  RegionResult run() {
    repeat(Use::kSlots);
    if (circles_at_ && patterns_.kind() == TrochoidKind::kConstantEngagement)
      plan_.tell({FindingCode::kCirclesForPattern, shown_place(task_, *circles_at_)});
    if (!is_repeated()) {
      passes_.feed_steps = params_.feed_steps;
      passes_.move_price = params_.move_price;
    }
    clear_region(plan_, task_, passes_, progress_);
    if (!is_repeated() && !progress_.cancelled()) plan_.tell(fallback());
    return plan_.take();
  }

  std::optional<RegionResult> run_where_patterns_serve() {
    repeat(Use::kPockets);
    if (!is_repeated()) return std::nullopt;
    clear_region(plan_, task_, passes_, progress_);
    return plan_.take();
  }

 private:
  // Slots take any pattern that there is; pockets only what serves them better than passes do.
  enum class Use { kSlots, kPockets };

  void repeat(Use use) {
    if (task_.rest) return;
    try {
      find_ways(use);
      if (start(use)) follow_ways();
    } catch (const Cancelled&) {  // what is made is kept
    }
    early_ends_.reset();
  }

  bool is_repeated() const { return report_.length > length_before_; }

  // ---- where no pattern is repeated ----

  Finding fallback() const {
    const Vec2 place = longest_stretch_ ? longest_stretch_->middle.point(0.5)
                                        : task_.centres.outer.vertices()[0].p;
    return {why_none(), shown_place(task_, place), {static_cast<double>(patterns_.kind())}};
  }

  FindingCode why_none() const {
    if (task_.rest) return FindingCode::kNoPatternAfterCuts;
    if (!longest_stretch_)
      return find_slots(centres_, std::numeric_limits<double>::infinity()).empty()
                 ? FindingCode::kNoPatternBetweenWalls
                 : FindingCode::kNoPatternSoWide;
    if (is_too_short_) return FindingCode::kNoPatternSoShort;
    return ways_.empty() ? FindingCode::kNoPatternWithoutRoom : FindingCode::kNoPatternWithoutStart;
  }

  // ---- the ways ----

  void find_ways(Use use) {
    for (const SlotStretch& stretch : find_slots(centres_, (kWidestSlot - 1) * radius_)) {
      if (!longest_stretch_) longest_stretch_ = stretch;
      add_way(stretch, use);
      add_way(stretch.reversed(), use);
    }
    std::stable_sort(ways_.begin(), ways_.end(), comes_first);
    if (task_.has_open_edges && params_.open_side)
      std::stable_sort(
          ways_.begin(), ways_.end(), [&wish = *params_.open_side](const Way& a, const Way& b) {
            return distance(a.stretch.middle.a, wish) < distance(b.stretch.middle.a, wish);
          });
    is_too_short_ = is_too_short_ && ways_.empty();
  }

  // The longest first, of those as long the widest, so that a turned slot is cut the same.
  static bool comes_first(const Way& a, const Way& b) {
    if (std::abs(a.length() - b.length()) > kOnWall) return a.length() > b.length();
    return a.stretch.half_room > b.stretch.half_room + kSameWidth;
  }

  void add_way(const SlotStretch& stretch, Use use) {
    const std::optional<SlotPattern> pattern = patterns_.pattern_of(stretch);
    if (!pattern) return;
    if (use == Use::kPockets &&
        (has_corners(*pattern) || stretch.half_room < kLeastCircle * radius_))
      return;
    const Way way{*pattern, stretch};
    if (way.last() + way.reach.back < kFewestPeriods * way.pattern.step) {
      is_too_short_ = true;
      return;
    }
    ways_.push_back(way);
  }

  // ---- the start ----

  // Makes ground in which a way can begin. False where there is none.
  bool start(Use use) {
    if (ways_.empty()) return false;
    if (task_.has_open_edges && params_.entry == EntryKind::kAutomatic) {
      if (begins_outside()) return true;
      if (use == Use::kPockets) return false;  // passes find the open side
    }
    if (task_.hole) return clear_room_about_hole();
    if (params_.entry == EntryKind::kPredrilledHole) return false;
    return clear_first_room(Place::kBegin) || clear_first_room(Place::kPastJunction);
  }

  // Where along a way its first room ends.
  enum class Place { kBegin, kPastJunction };

  // Of the longest ways that have one.
  bool clear_first_room(Place place) {
    for (std::size_t first = 0, last = 0; first < ways_.size(); first = last) {
      const double length = ways_[first].length();
      while (last < ways_.size() && ways_[last].length() > length - kOnWall) ++last;
      if (clear_smallest_end(first, last, place)) return true;
    }
    return false;
  }

  // Whether the way that is followed first begins beside the stock.
  bool begins_outside() const {
    for (const Way& way : ways_) {
      const std::optional<int> first = first_to_cut(way, plan_.ground());
      if (!first) continue;
      const Vec2 p = cut_at(way, place_of(way, *first)).front().a;
      return std::none_of(task_.material.begin(), task_.material.end(),
                          [&](const Region& region) { return region.contains(p); });
    }
    return false;
  }

  // Of the ways [first, last), which are equally long: an end of the slot if there is one.
  bool clear_smallest_end(std::size_t first, std::size_t last, Place place) {
    std::optional<StartRoom> best;
    const Way* way = nullptr;  // that begins there
    for (std::size_t i = first; i < last; ++i) {
      if (first_place(ways_[i]) > ways_[i].last()) {
        is_too_short_ = true;
        continue;
      }
      std::optional<StartRoom> room = place == Place::kBegin
                                          ? start_room_of(ways_[i], first_place(ways_[i]))
                                          : room_past_junction(ways_[i]);
      if (!room) continue;
      const bool is_better =
          !best || (room->is_end != best->is_end ? room->is_end
                                                 : room->room.area() < best->room.area() - kSame);
      if (!is_better) continue;
      best = std::move(room);
      way = &ways_[i];
    }
    if (!best) return false;
    begin_ends(*way);
    return clear_room(best->room);
  }

  // Where a way begins in a junction, as the sides of a frame do in its corners: as soon as it has
  // both walls.
  std::optional<StartRoom> room_past_junction(const Way& way) const {
    const double first = first_place(way),
                 furthest = std::min(way.last(), first + kLongestJunction * way.stretch.half_room);
    std::optional<StartRoom> room;
    for (double s = first; !room && s < furthest; s += kMiddleLook * radius_)
      room = start_room_of(way, s);
    return room;
  }

  // On another core: of all ways but the one that ends where `followed_first` begins. Those of ways
  // that are not followed are cleared in vain.
  void begin_ends(const Way& followed_first) {
    std::vector<std::unique_ptr<EarlyEnd>> ends;
    for (const Way& way : ways_) {
      const bool is_start = is_reverse(way.stretch.middle, followed_first.stretch.middle);
      if (is_start || first_place(way) > way.last()) continue;
      if (auto end = EarlyEnd::of(task_, centres_, way, first_place(way), passes_))
        ends.push_back(std::move(end));
    }
    early_ends_ = std::make_unique<EarlyEnds>(std::move(ends));
  }

  static bool is_reverse(const Segment& a, const Segment& b) {
    return distance(a.a, b.b) < kOnWall && distance(a.b, b.a) < kOnWall;
  }

  bool clear_room_about_hole() {
    for (const Way& way : ways_) {
      const Segment& middle = way.stretch.middle;
      if (middle.distance_to(*task_.hole) > way.stretch.half_room) continue;
      const double at = middle.nearest(*task_.hole) * middle.length();
      // The way back has it nearer.
      if (at > 0.5 * way.length() + kOnWall) continue;
      const std::optional<StartRoom> start = start_room_of(way, std::max(first_place(way), at));
      return start && start->room.contains(*task_.hole) && clear_room(start->room);
    }
    return false;
  }

  // The first place of a period that leaves room behind its front for a helix as wide as the slot.
  double first_place(const Way& way) const {
    const double h = way.stretch.half_room, helix = helix_radius(params_, {{}, h});
    const double stretch = task_.hole ? 0 : wished_stretch(helix, params_) + kHelixRoom * h;
    return std::max(-way.reach.back, stretch - way.circle_behind);
  }

  std::optional<StartRoom> start_room_of(const Way& way, double s) const {
    return start_room(task_.centres, centres_, way.stretch, s,
                      placed(way.front, pose_on(way.stretch, s)));
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
      if (!room || !is_mostly_clear(way, *room)) room = corner_behind(front);
      if (room && is_mostly_clear(way, *room) && clear_room(*room)) return true;
    }
    return false;
  }

  // Between a front and the last place of another way that has walls on both sides: the smallest
  // such room.
  std::optional<Region> corner_behind(const std::vector<Segment>& front) const {
    std::optional<Region> best;
    for (const Way& other : ways_) {
      // The tool goes round the corner between the two ways by its radius.
      const double s =
          other.stretch.middle.length() - kPastCorner * other.stretch.half_room - radius_;
      if (s < 0) continue;
      std::optional<Region> room = room_between(task_.centres, centres_, other.stretch, s, front);
      if (room && (!best || room->area() < best->area())) best = std::move(room);
    }
    return best;
  }

  // Whether nothing but a junction is left of a room behind a way: along the middles.
  bool is_mostly_clear(const Way& way, const Region& room) const {
    const double look = kMiddleLook * radius_;
    double left = 0;
    for (const Way& other : ways_)
      for (double s = 0; s <= other.stretch.middle.length(); s += look) {
        const Vec2 p = pose_on(other.stretch, s).p;
        if (!plan_.ground().is_cleared_point(p) && room.contains(p))
          left += 0.5 * look;  // either way
      }
    return left < way.reach.ahead - way.reach.back + 2 * radius_ +
                      kLongestJunction * way.stretch.half_room;
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
      plan_.add(MoveKind::kCut, cut, in_pattern());
      plan_.count_pass();
      progress_.report(std::min(1.0, s / way.stretch.middle.length()));
    }
    const double end = place_of(way, period);
    note(way, end - begin);
    note_turns(cut_at(way, begin));
    return period + 1;
  }

  void link_back(const std::vector<Segment>& link, bool is_sure, const Pose& to) {
    if (!is_sure &&
        !is_free({plan_.ground(), plan_.ground().size()}, centres_, link, length_of(link))) {
      go_to(to);
      return;
    }
    plan_.add(MoveKind::kLink, link, in_pattern());
    plan_.count_link();
  }

  void go_to(const Pose& to) {
    if (!plan_.link_to(to, centres_, turn_radius_)) plan_.plunge(to, !plan_.is_empty());
  }

  static PlanarMove in_pattern() {
    PlanarMove move;
    move.in_pattern = true;
    return move;
  }

  void note(const Way& way, double length) {
    report_.length += length;
    note_residual(way);
    if (way.kind == TrochoidKind::kCircular && !circles_at_)
      circles_at_ = way.stretch.middle.point(0.5);
    if (length <= report_.longest) return;
    report_.longest = length;
    report_.step = way.pattern.step;
    report_.iterations = iterations(way);
    report_.residual = iterations(way) == 0 ? 0 : way.pattern.residuals.back();
    report_.removal_rate = way.removal * (params_.top - params_.levels.front());
  }

  static int iterations(const Way& way) {
    return way.pattern.residuals.empty() ? 0 : static_cast<int>(way.pattern.residuals.size()) + 1;
  }

  void note_turns(const std::vector<Segment>& cut) {
    const auto sharpest =
        std::max_element(cut.begin(), cut.end(), [](const Segment& a, const Segment& b) {
          return std::abs(a.curvature()) < std::abs(b.curvature());
        });
    const double radius = 1 / std::abs(sharpest->curvature());
    if (radius >= turn_radius_ * (1 - 1e-9)) return;
    plan_.note_turn(radius, shown_place(task_, sharpest->b));
  }

  // Once for all ways of one pattern.
  void note_residual(const Way& way) {
    if (iterations(way) == 0 || way.pattern.residuals.back() < kSettled * radius_) return;
    const Finding finding{FindingCode::kAdvanceUnsettled,
                          {},
                          {static_cast<double>(iterations(way)), way.pattern.residuals.back()}};
    const std::vector<Finding>& told = plan_.made().findings;
    if (std::find(told.begin(), told.end(), finding) == told.end()) plan_.tell(finding);
  }

  const RegionTask& task_;
  const ClearingParams& params_;
  ClearingParams passes_;
  PatternCache& patterns_;
  TrochoidReport& report_;
  Progress& progress_;
  double radius_, turn_radius_;
  double length_before_;  // mm, of the report
  Area centres_;
  Plan plan_;
  std::vector<Way> ways_;  // the longest first, both directions of each
  std::unique_ptr<EarlyEnds> early_ends_;
  std::optional<SlotStretch> longest_stretch_;
  bool is_too_short_ = false;       // a stretch with a pattern, and no other one serves
  std::optional<Vec2> circles_at_;  // of the first way along which circles are repeated
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
