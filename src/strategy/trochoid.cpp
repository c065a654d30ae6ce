#include "strategy/trochoid.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "feed/load_profile.h"
#include "geometry/box_tree.h"
#include "strategy/circular_trochoid.h"
#include "strategy/links.h"
#include "strategy/slot.h"
#include "strategy/trochoid_pattern.h"
#include "support/errors.h"

namespace evenload {
namespace {

// Fewer periods are not worth a pattern.
constexpr int kFewestPeriods = 4;
// Steps between two places that are tried for a first period: how much of a step may be lost.
constexpr double kTrySpacing = 0.25;
// Share of the tool's radius: between two looks along a cut that shall be clear.
constexpr double kLook = 0.1;
constexpr double kOnWall = 1e-4;    // mm
constexpr double kSameArea = 1e-6;  // mm^2
// mm and 1/mm: of half rooms and curvatures.
constexpr double kAlike = 1e-9;

// A stretch with the pattern that fits it, in the direction of its middle.
// A stretch with the pattern that fits it, in the direction of its middle.
struct Way {
  SlotStretch stretch;
  TrochoidPattern pattern;
  PatternFigures figures;
  PeriodReach reach;
  double last() const { return stretch.middle.length() - reach.ahead; }  // place of a period, mm
};

class SlotClearing {
 public:
  SlotClearing(TrochoidKind kind, const RegionTask& task, const ClearingParams& params,
               TrochoidReport& report, Progress& progress)
      : kind_(kind),
        task_(task),
        params_(params),
        report_(report),
        progress_(progress),
        radius_(0.5 * params.tool_diameter),
        turn_radius_(std::max(params.roll_radius, params.minimum_radius)),
        centres_({task.centres}),
        ground_(grown(bounds_of({task.centres}), radius_), radius_,
                task.has_open_edges ? &task.material : nullptr) {
    if (task.hole) ground_.add_disc(*task.hole, 0.5 * params.hole_diameter);
  }

  RegionResult run() {
    if (task_.rest || !task_.before.empty()) return clear_region(task_, params_, progress_);
    find_ways();
    if (start()) follow_ways();
    RegionTask rest = task_;
    rest.opening = std::move(opening_);
    return clear_region(rest, params_, progress_);
  }

 private:
  // ---- the ways ----

  void find_ways() {
    for (const SlotStretch& stretch : find_slots(centres_, (kWidestSlot - 1) * radius_)) {
      add_way(stretch);
      add_way(stretch.reversed());
    }
  }

  void add_way(const SlotStretch& stretch) {
    TrochoidParams params;
    params.tool_radius = radius_;
    params.width = 2 * (radius_ + stretch.half_room);
    params.curvature = stretch.middle.curvature();
    params.engagement = params_.engagement_angle;
    params.turn_radius = turn_radius_;
    params.feed = params_.feed;
    params.link_feed = params_.link_feed;
    if (std::abs(params.curvature) * 0.5 * params.width >= 1) return;
    std::optional<Way> way = with_pattern(params);
    if (!way) return;
    way->stretch = stretch;
    if (way->last() + way->reach.back < kFewestPeriods * way->pattern.step) return;
    ways_.push_back(std::move(*way));
  }

  // Stretches of one width and curvature share a pattern.
  std::optional<Way> with_pattern(const TrochoidParams& params) const {
    for (const Way& way : ways_)
      if (std::abs(way.stretch.half_room - half_room(params)) < kAlike &&
          std::abs(way.pattern.curvature - params.curvature) < kAlike)
        return way;
    std::optional<TrochoidPattern> pattern = make_pattern(kind_, params);
    if (!pattern) return std::nullopt;
    Way way;
    way.figures = figures_of(*pattern, params);
    way.reach = reach_of(*pattern);
    way.pattern = std::move(*pattern);
    return way;
  }

  std::vector<Segment> cut_at(const Way& way, double s) const {
    return placed(way.pattern.cut, pose_on(way.stretch, s));
  }

  // ---- the start ----

  // Makes ground in which a way can begin. False where there is none.
  bool start() {
    if (ways_.empty()) return false;
    if (task_.hole) return clear_room_about_hole();
    if (params_.entry == EntryKind::kPredrilledHole) return false;
    if (task_.has_open_edges && params_.entry == EntryKind::kAutomatic)
      for (const Way& way : ways_)
        if (first_free(way)) return true;
    return clear_smallest_end();
  }

  // The smallest end of one of the longest ways.
  bool clear_smallest_end() {
    std::optional<Region> best;
    for (const Way& way : ways_) {
      if (way.stretch.middle.length() < ways_.front().stretch.middle.length() - kSameWall) break;
      std::optional<Region> room = end_room(way, first_place(way));
      if (!room) room = room_between(way, first_place(way));
      if (room && (!best || room->area() < best->area() - kSameArea)) best = std::move(room);
    }
    return best && clear_room(*best);
  }

  bool clear_room_about_hole() {
    for (const Way& way : ways_) {
      const Segment& middle = way.stretch.middle;
      if (middle.distance_to(*task_.hole) > way.stretch.half_room) continue;
      const double at = middle.nearest(*task_.hole) * middle.length();
      if (at > 0.5 * middle.length() + kSameWall) continue;  // the way back has it nearer
      std::optional<Region> room;
      if (at < 2 * way.stretch.half_room) {
        const double s = std::max(first_place(way), at - way.reach.back);
        room = end_room(way, s);
      } else {
        room = room_between(way, at - way.reach.back);
      }
      return room && room->contains(*task_.hole) && clear_room(*room);
    }
    return false;
  }

  // The first place of a period that leaves room behind its front for a helix as wide as the slot.
  double first_place(const Way& way) const {
    return std::max(-way.reach.back, 2 * way.stretch.half_room - way.reach.ahead);
  }

  std::optional<WallPlace> place_on_wall(Vec2 p) const {
    const BoundaryIndex::Hit hit = centres_.nearest(p);
    if (hit.distance > kOnWall) return std::nullopt;
    return WallPlace{hit.curve, hit.segment, hit.t};
  }

  // All that lies behind the front of a period at `s`, down to the end of the slot.
  std::optional<Region> end_room(const Way& way, double s) const {
    std::vector<Segment> border = cut_at(way, s);
    const std::optional<WallPlace> left = place_on_wall(border.back().b),
                                   right = place_on_wall(border.front().a);
    if (!left || !right || left->curve != 0 || right->curve != 0) return std::nullopt;
    for (const Segment& piece : border_between(task_.centres.outer, *left, *right))
      border.push_back(piece);
    return closed_room(border);
  }

  // The same down to half a circle between the walls, h before the period.
  std::optional<Region> room_between(const Way& way, double s) const {
    std::vector<Segment> border = cut_at(way, s);
    const double h = way.stretch.half_room;
    const Pose back = pose_on(way.stretch, s + way.reach.back - h);
    const Vec2 aside = h * left_normal(unit(back.heading));
    const std::optional<WallPlace> left = place_on_wall(border.back().b),
                                   left_back = place_on_wall(back.p + aside),
                                   right_back = place_on_wall(back.p - aside),
                                   right = place_on_wall(border.front().a);
    if (!left || !left_back || !right_back || !right || left->curve != left_back->curve ||
        right->curve != right_back->curve)
      return std::nullopt;
    const std::vector<Curve>& curves = centres_.curves();
    for (const Segment& piece : border_between(curves[left->curve], *left, *left_back))
      border.push_back(piece);
    border.push_back(Segment::arc(back.p, h, back.heading + kPi / 2, kPi));
    for (const Segment& piece : border_between(curves[right->curve], *right_back, *right))
      border.push_back(piece);
    return closed_room(border);
  }

  // Nothing where the border closes around something that is not a room.
  std::optional<Region> closed_room(const std::vector<Segment>& border) const {
    std::vector<Vertex> vertices;
    for (const Segment& piece : border) vertices.push_back({piece.a, piece.bulge(), piece.open});
    const Curve outer(std::move(vertices), true);
    if (outer.signed_area() <= 0) return std::nullopt;
    for (const Curve& island : task_.centres.islands)
      if (outer.contains(island.vertices().front().p)) return std::nullopt;
    try {
      return make_region(outer);
    } catch (const GeometryError&) {
      return std::nullopt;  // walls that come too near to each other behind the front
    }
  }

  // False where the tool finds no way in; then the whole region may still have one.
  bool clear_room(const Region& room) {
    RegionTask task = task_;
    task.centres = room;
    task.around = {task_.centres};
    try {
      RegionResult cleared = clear_region(task, params_, progress_);
      for (PlanarRun& run : cleared.runs) append(std::move(run));
      opening_.passes += cleared.passes;
      opening_.links += cleared.links;
      opening_.tight_turns.add(cleared.tight_turns);
      return !opening_.runs.empty();
    } catch (const GeometryError&) {
      return false;
    }
  }

  // ---- the way ----

  // The last place of the first stretch of places at which a whole period would cut nothing; none
  // where there is no such place, or nothing to be cut beyond it.
  std::optional<double> first_free(const Way& way) const {
    std::optional<double> last;
    for (double s = first_place(way); s <= way.last(); s += kTrySpacing * way.pattern.step) {
      const bool is_free = is_clear(cut_at(way, s));
      if (!is_free && last) return last;
      if (is_free) last = s;
    }
    return std::nullopt;
  }

  bool is_clear(const std::vector<Segment>& moves) const {
    for (const Segment& move : moves) {
      const int n = static_cast<int>(std::ceil(move.length() / (kLook * radius_)));
      for (int i = 0; i <= n; ++i)
        if (!ground_.is_clear(move.point(static_cast<double>(i) / n), params_.tolerance))
          return false;
    }
    return true;
  }

  void follow_ways() {
    for (bool found = true; found && !progress_.cancelled();) {
      found = false;
      for (const Way& way : ways_) {
        const std::optional<double> free = first_free(way);
        if (!free || *free + way.pattern.step > way.last()) continue;
        follow(way, *free + way.pattern.step);
        found = true;
        break;
      }
    }
  }

  void follow(const Way& way, double from) {
    const double step = way.pattern.step, begin = from;
    double s = from;
    for (; s <= way.last() && !progress_.cancelled(); s += step) {
      const std::vector<Segment> cut = cut_at(way, s);
      const bool is_first = s == begin;
      // Once as much is cut as a period reaches, the ground is what the pattern left.
      const bool is_sure = s - begin > way.reach.ahead - way.reach.back + 2 * radius_;
      if (is_first)
        go_to({cut.front().a, angle_of(cut.front().tangent(0))});
      else
        link_back(placed(way.pattern.link, pose_on(way.stretch, s - step)), is_sure,
                  {cut.front().a, angle_of(cut.front().tangent(0))});
      add(MoveKind::kCut, cut);
      ++opening_.passes;
      progress_.report(std::min(1.0, s / way.stretch.middle.length()));
    }
    note(way, s - begin);
  }

  void link_back(const std::vector<Segment>& link, bool is_sure, const Pose& to) {
    if (!is_sure && !is_free({ground_, ground_.size()}, centres_, link, length_of(link))) {
      go_to(to);
      return;
    }
    add(MoveKind::kLink, link);
    ++opening_.links;
  }

  void go_to(const Pose& to) {
    if (opening_.runs.empty()) {
      append({{DescentKind::kPlunge, to.p, {}, 0, {}, false}, {}, true});
      return;
    }
    const std::vector<Segment> link =
        quicker_link({ground_, ground_.size()}, centres_, here_, to, turn_radius_, params_);
    if (link.empty()) {
      append({{DescentKind::kPlunge, to.p, {}, 0, {}, true}, {}, false});
      return;
    }
    add(MoveKind::kLink, link);
    ++opening_.links;
  }

  void append(PlanarRun run) {
    add_descent(run.descent, ground_);
    for (const PlanarMove& move : run.moves) ground_.add(move.segment);
    here_ = {run.descent.at, 0};
    if (!run.moves.empty()) {
      const Segment& last = run.moves.back().segment;
      here_ = {last.b, angle_of(last.tangent(1))};
    }
    opening_.runs.push_back(std::move(run));
  }

  void add(MoveKind kind, const std::vector<Segment>& moves) {
    for (const Segment& move : moves) {
      PlanarMove planar;
      planar.kind = kind;
      planar.segment = move;
      opening_.runs.back().moves.push_back(planar);
      ground_.add(move);
    }
    here_ = {moves.back().b, angle_of(moves.back().tangent(1))};
  }

  void note(const Way& way, double length) {
    report_.length += length;
    if (length <= longest_) return;
    longest_ = length;
    report_.step = way.pattern.step;
    report_.iterations =
        way.pattern.residuals.empty() ? 0 : static_cast<int>(way.pattern.residuals.size()) + 1;
    report_.residual = way.pattern.residuals.empty() ? 0 : way.pattern.residuals.back();
    report_.removal_rate = way.figures.removal * (params_.top - params_.levels.front());
  }

  TrochoidKind kind_;
  const RegionTask& task_;
  const ClearingParams& params_;
  TrochoidReport& report_;
  Progress& progress_;
  double radius_, turn_radius_;
  Area centres_;
  ClearedGround ground_;
  std::vector<Way> ways_;  // the longest first, both directions of each
  RegionResult opening_;
  Pose here_;
  double longest_ = 0;  // mm that were followed at once
};

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

TrochoidalPath clear_slot(const std::vector<Region>& regions, TrochoidKind kind,
                          const ClearingParams& params, Progress& progress) {
  TrochoidalPath result;
  const RegionClearer clearer = [&](const RegionTask& task, const ClearingParams& checked,
                                    Progress& share) {
    return SlotClearing(kind, task, checked, result.report, share).run();
  };
  result.path = clear_by(clearer, regions, params, progress);
  return result;
}

}  // namespace evenload
