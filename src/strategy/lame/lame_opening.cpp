#include "strategy/lame/lame_opening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "cutting/engagement.h"
#include "cutting/load_budget.h"
#include "geometry/box_tree.h"
#include "strategy/choose/region_clearing.h"
#include "strategy/lame/lame_pace.h"
#include "strategy/lame/lame_refusals.h"
#include "strategy/lame/lame_shapes.h"
#include "strategy/lame/lame_turns.h"
#include "strategy/reach/entry.h"
#include "support/errors.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

// Shares of the user's tolerance: within the first one arcs follow the spiral, as far as they are
// looked at; the second is as far as its last curve stays from walls, so that no arc touches them.
// Else walls would be clear in places, and be followed from there.
constexpr double kArcShare = 0.73, kWallShare = 0.8;
// Tool radii: the width of the channel of tool centres that is cleared around a ring's island
// before its spiral, and what it is at least.
constexpr double kFirstChannel = 1, kLeastChannel = 0.05;
// Tool radii that a spiral of a set size grows by, at least.
constexpr double kLeastGrowth = 0.1;
// What a spiral leaves takes this much longer than its area at the nominal removal rate, measured.
constexpr double kRestTime = 1.3;
// A pocket of which the closest curve clears less resembles no Lamé curve.
constexpr double kResembling = 0.7;
// Tool radii: of the first circle in a hole no wider than the tool.
constexpr double kTightestCircle = 0.01;
// Of a radius: arcs of a turn are this much tighter than its curve, at most.
constexpr double kRadius = 0.03;
// Tool radii at which the first turn of a spiral from outside passes the stock.
constexpr double kBeside = 1.02;

// mm: the least radius of arcs.
double tightest(const std::vector<Segment>& moves) {
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& move : moves)
    if (move.is_arc()) least = std::min(least, move.radius);
  return least;
}

double area_of(const std::vector<Region>& regions) {
  double sum = 0;
  for (const Region& region : regions) sum += region.area();
  return sum;
}

class Opening {
 public:
  Opening(Plan& plan, const RegionTask& task, const ClearingParams& params, const LameParams& lame,
          Progress& progress)
      : plan_(plan),
        task_(task),
        params_(params),
        lame_(lame),
        progress_(progress),
        radius_(0.5 * params.tool_diameter),
        shapes_(params, lame, kWallShare * params.tolerance),
        pace_(pace_of(params, task.mirrored)) {}

  LameOpening run() {
    made_.reached_area = area_of(offset({task_.centres}, radius_));
    try {
      make();
    } catch (const Cancelled&) {  // what is made is kept
    }
    made_.cleared_area = std::max(made_.cleared_area, made_.spiral_area);
    return made_;
  }

 private:
  void make() {
    if (task_.centres.islands.empty() && !task_.has_open_edges)
      clear_pocket_of_one_wall();
    else if (task_.centres.islands.size() != 1)
      refuse(Refusal::kNotForSpirals);
    else if (task_.has_open_edges)
      clear_stock_around_island();
    else
      clear_ring();
  }

  Vec2 shown(Vec2 p) const { return shown_place(task_, p); }

  [[noreturn]] void refuse(Refusal refusal, std::vector<double> numbers = {}) const {
    throw GeometryError(refusal, shown(task_.centres.outer.vertices().front().p),
                        std::move(numbers));
  }
  [[noreturn]] void refuse_hole(Refusal refusal) const {
    throw GeometryError(refusal, shown(*task_.hole));
  }

  // The stock in which the region's island stands.
  const Region& stock() const {
    const Vec2 p = task_.centres.islands.front().vertices().front().p;
    for (const Region& region : task_.material)
      if (region.outer.contains(p)) return region;
    return task_.material.front();
  }

  double arc_tolerance() const { return kArcShare * params_.tolerance; }

  // Of what is within reach in a pocket, by a spiral that ends in this curve.
  double share_by(const LameCurve& last) const {
    return grown_lame_area(last, radius_) / made_.reached_area;
  }

  std::vector<LameCurve> last_curves(const Curve& outline, LameSide side) const {
    const std::optional<LameCurve> last = shapes_.last(outline, side);
    if (!last) refuse(no_curve(outline, shapes_.last_wishes()));
    check_courses(*last);
    // A constant removal rate makes good for uneven turns, but not for those between a ring's
    // curves, some of which hardly cut along its narrow sides; and where even the closest curve
    // leaves much, it costs more to come close than it clears.
    const bool inside = side == LameSide::kInside, ring = inside && !task_.centres.islands.empty();
    const bool resembles = !inside || share_by(*last) >= kResembling;
    if (params_.feed_control == FeedControl::kConstantRemovalRate && !ring && resembles)
      return {*last};
    return shapes_.with_rounder_ones(*last, outline, side);
  }
  LameCurve first_curve(const Curve& outline) const {
    const std::optional<LameCurve> first = shapes_.first(outline);
    if (!first) refuse(no_curve(outline, shapes_.first_wishes()));
    return *first;
  }

  TurnTask turn_task(bool inwards) const {
    TurnTask turns;
    turns.tool_radius = radius_;
    turns.engagement = params_.engagement_angle;
    turns.inwards = inwards;
    turns.pitch = lame_.pitch;
    turns.feed = params_.feed;
    turns.maximum_feed =
        params_.feed_control == FeedControl::kConstantFeed ? params_.feed : params_.maximum_feed;
    turns.pace = pace_;
    turns.tolerance = arc_tolerance();
    turns.block_price = block_price::kSpiral;
    turns.progress = &progress_;
    return turns;
  }

  void check_courses(const LameCurve& last) const {
    if (last.segments != 4 && !lame_.semi_axis_a_course.empty() &&
        !lame_.semi_axis_b_course.empty() && lame_.semi_axis_a_course != lame_.semi_axis_b_course)
      refuse(Refusal::kTwoCourses);
  }

  // From one curve to another, with what courses are set.
  LameGrowth one_stage(const LameCurve& from, const LameCurve& to) const {
    LameCourses courses{course_through(lame_.semi_axis_a_course),
                        course_through(lame_.semi_axis_b_course),
                        course_through(lame_.exponent_course)};
    if (to.segments != 4 && !courses.a) courses.a = courses.b;
    if (to.segments != 4) courses.b = courses.a;
    return {{{from, to, 1, LameJoint::kNone, std::move(courses)}}};
  }

  // From the entry's circle to a last curve.
  LameGrowth growth_from(const Circle& first, const LameCurve& last) const {
    LameCurve circle = lame_circle(last, first.centre, first.radius);
    circle.exponent = lame_.exponent_start.value_or(1);
    // A first curve that is no circle touches the entry's circle from inside, at its corners.
    circle.a = circle.b = first.radius / std::pow(2, (1 - circle.exponent) / 2);
    return one_stage(circle, last);
  }

  // The growth to one of the last curves with which spiral and rest take the least time.
  // growths_to(last): those to be compared; left_by(last): mm^2 of the rest.
  template <typename GrowthsTo, typename LeftBy>
  PlannedGrowth quickest(const std::vector<LameCurve>& lasts, bool inwards, GrowthsTo growths_to,
                         LeftBy left_by) const {
    const double rate = side_step(params_.engagement_angle, radius_) * params_.feed / 60;
    const TurnTask turns = turn_task(inwards);
    std::optional<PlannedGrowth> best;
    double least = std::numeric_limits<double>::infinity();
    for (const LameCurve& last : lasts) {
      std::optional<PlannedGrowth> growth = best_growth(growths_to(last), turns);
      if (!growth) continue;
      const double time =
          time_of(growth->growth, growth->steps, turns) + kRestTime * left_by(last) / rate;
      if (time >= least) continue;
      least = time;
      best = std::move(growth);
    }
    if (!best) refuse_growth();
    return *best;
  }

  // Of what is within reach, by the spiral.
  void check_share(double share) {
    if (share >= kLeastShare) return;
    if (!shapes_.has_wished_size()) refuse(too_small(lame_), {share});
    tell(FindingCode::kSpiralOfSetSize, share);
  }

  // Returns the radius of the circle that the tool's centre can run on in the hole.
  double enter_hole() {
    plan_.plunge({*task_.hole, 0}, false);
    // A hole no wider than the tool leaves no room to turn: the first circle is a small cut, then.
    return std::max(0.5 * params_.hole_diameter - radius_, kTightestCircle * radius_);
  }

  void tell(FindingCode code) { plan_.tell({code}); }
  void tell(FindingCode code, double number) { plan_.tell({code, {}, {number}}); }

  // Clears a region of tool centres at constant engagement, as the way to the spiral.
  void clear_first(const Region& centres) {
    RegionTask first = task_;
    first.centres = centres;
    first.around = {task_.centres};
    if (first.hole && !centres.contains(*first.hole)) {
      if (params_.entry == EntryKind::kPredrilledHole) refuse_hole(Refusal::kHoleBesideChannel);
      first.hole.reset();
      tell(FindingCode::kHoleBesideIsland);
    }
    Progress half([&](double done) { return progress_.report(kFirstHalf * done); });
    RegionResult cleared = clear_region(first, beside_spiral(params_), half);
    cleared.uncut_area = 0;  // of the first region only: told of at the end
    plan_.append(std::move(cleared));
  }

  // The spiral through a growth, from where the tool is.
  void cut(const PlannedGrowth& growth, double start, bool inwards) {
    const LameTurns turns =
        turns_of(growth, turn_task(inwards), start, arc_tolerance(), plan_.ground());
    if (turns.engagement > params_.engagement_angle + load_budget::kSpiralMost) refuse_load();
    go_to({turns.moves.front().a, angle_of(turns.moves.front().tangent(0))});
    plan_.add(MoveKind::kCut, turns.moves);
    plan_.count_pass();
    made_.figures = LameFigures{growth.growth.stages.back().to,
                                growth.growth.stages.front().from.exponent, turns.largest_pitch};
    if (!lame_.exponent_course.empty() &&
        growth.growth.stages.front().from.exponent == growth.growth.stages.back().to.exponent)
      tell(FindingCode::kIdleCourse);
    if (const double radius = tightest(turns.moves); radius < (1 - kRadius) * wished_radius(growth))
      tell(FindingCode::kTightSpiral, radius);
    if (lame_.pitch && turns.smallest_pitch < *lame_.pitch * (1 - 1e-6))
      tell(FindingCode::kSmallPitch, turns.smallest_pitch);
  }

  // mm: what the turns' arcs must have, unless the first curve is tighter itself, as an entry may
  // be. Fitted exponents see to it.
  double wished_radius(const PlannedGrowth& growth) const {
    return std::min(params_.minimum_radius,
                    least_curvature_radius(growth.growth.stages.front().from));
  }

  [[noreturn]] void refuse_load() const {
    if (task_.hole) refuse_hole(Refusal::kHoleTooTightForSpiral);
    refuse(lame_.has_courses() ? Refusal::kNoLoadByCourses : Refusal::kNoLoad);
  }

  // To the spiral's start: over cleared ground, or down beside it.
  void go_to(const Pose& start) {
    const bool came_down = !plan_.is_empty() && plan_.may_turn();
    const Vec2 from = plan_.here().p;
    if (came_down && distance(from, start.p) < 1e-9) return;
    if (came_down) {  // in the hole: by half a turn that ends along its rim
      const Vec2 middle = 0.5 * (from + start.p);
      const bool cuts = 0.5 * params_.hole_diameter - radius_ < distance(from, start.p) - 1e-9;
      plan_.add(cuts ? MoveKind::kCut : MoveKind::kLink,
                {Segment::arc(middle, distance(middle, from), angle_of(from - middle), kPi)});
      return;
    }
    if (!plan_.link_to(start, Area({task_.centres}), radius_))
      plan_.plunge(start, !plan_.is_empty());
  }

  void clear_pocket_of_one_wall();
  void clear_stock_around_island();
  void clear_ring();
  [[noreturn]] void refuse_growth() const;
  std::optional<LameCurve> within_channel(LameCurve first, const LameCurve& last) const;
  double kept_area() const;

  Plan& plan_;
  const RegionTask& task_;
  const ClearingParams& params_;
  const LameParams& lame_;
  Progress& progress_;
  double radius_;
  LameShapes shapes_;
  std::optional<MonotoneSpline> pace_;
  LameOpening made_;
};

// From the entry's circle in the middle, or in the hole, outwards.
void Opening::clear_pocket_of_one_wall() {
  std::vector<LameCurve> lasts = last_curves(task_.centres.outer, LameSide::kInside);
  const LameCurve largest = lasts.front();
  check_share(share_by(largest));
  const auto does_little = [&](const LameCurve& last) { return share_by(last) < kLeastShare; };
  lasts.erase(std::remove_if(lasts.begin() + 1, lasts.end(), does_little), lasts.end());
  Circle first{task_.hole.value_or(largest.centre), 0};
  double room = least_lame_radius(largest);
  for (const LameCurve& last : lasts) room = std::min(room, least_lame_radius(last));
  if (task_.hole) {
    first.radius = enter_hole();
  } else if (params_.entry == EntryKind::kPredrilledHole) {
    throw GeometryError(Refusal::kHoleOutsidePocket, shown(largest.centre));
  } else {
    first.radius = helix_radius(params_, {first.centre, room});
    // Beside a ramp hundreds of short cuts, with a retract for each, would make it a circle.
    if (params_.entry == EntryKind::kRamp) tell(FindingCode::kHelixForSpiral);
  }
  if (shapes_.has_wished_size() &&
      std::min(largest.a, largest.b) - first.radius < kLeastGrowth * radius_)
    refuse(Refusal::kSetSizeTooSmall);
  const PlannedGrowth growth = quickest(
      lasts, false, [&](const LameCurve& last) { return std::vector{growth_from(first, last)}; },
      [&](const LameCurve& last) { return (1 - share_by(last)) * made_.reached_area; });
  const LameCurve& last = growth.growth.stages.back().to;
  made_.spiral_area = grown_lame_area(last, radius_);
  const double start = last.rotation + kPi / last.segments;
  if (plan_.is_empty()) {
    plan_.come_down({DescentKind::kHelix,
                     first.centre + first.radius * unit(start),
                     first.centre,
                     first.radius,
                     {},
                     false});
  }
  cut(growth, start, false);
}

// From the edge of the stock inwards.
void Opening::clear_stock_around_island() {
  const std::vector<Vertex>& outline = stock().outer.vertices();
  if (!std::all_of(outline.begin(), outline.end(), [](const Vertex& v) { return v.open; }))
    refuse(Refusal::kNotForSpirals);
  if (task_.hole && params_.entry == EntryKind::kPredrilledHole)
    refuse_hole(Refusal::kHoleAtIsland);
  if (task_.hole) tell(FindingCode::kHoleInOpenStock);
  const std::vector<LameCurve> lasts =
      last_curves(task_.centres.islands.front().reversed(), LameSide::kAround);
  Region around = stock();
  around.islands.clear();
  const Curve outside = offset({around}, kBeside * radius_).front().outer;
  const LameCurve first = first_curve(outside);
  const double kept = kept_area(), beside = grown_lame_area(first, -radius_);

  const auto growths_to = [&](const LameCurve& last) {
    std::vector<LameGrowth> growths;
    if (!lame_.has_courses()) growths = growths_through_circles(first, last);
    if (const std::optional<LameCurve> alike = shapes_.first_like(last, outside))
      growths.push_back(one_stage(*alike, last));
    return growths;
  };
  const PlannedGrowth growth = quickest(lasts, true, growths_to, [&](const LameCurve& last) {
    return grown_lame_area(last, -radius_) - kept;
  });
  const double area = stock().outer.signed_area();
  const double inside = grown_lame_area(growth.growth.stages.back().to, -radius_);
  made_.reached_area = area - kept;
  made_.spiral_area = area - inside;
  check_share(made_.spiral_area / made_.reached_area);
  check_share(made_.spiral_area / (beside - inside));
  const LameCurve& from = growth.growth.stages.front().from;
  cut(growth, from.rotation + kPi / from.segments, true);
}

// From a channel along the island's wall outwards: that wall is the shorter one, and a channel is
// dear.
void Opening::clear_ring() {
  const std::vector<LameCurve> lasts = last_curves(task_.centres.outer, LameSide::kInside);
  const Curve island = task_.centres.islands.front().reversed();
  const LameCurve beside = first_curve(island);

  // What a spiral clears, and with the channel; of a rounder curve that must do.
  const auto by_spiral_to = [&](const LameGrowth& growth) {
    const LameCurve &first = growth.stages.front().from, &last = growth.stages.back().to;
    return (grown_lame_area(last, radius_) - grown_lame_area(first, radius_)) / made_.reached_area;
  };
  const auto with_channel_to = [&](const LameCurve& last) {
    return (grown_lame_area(last, radius_) - grown_lame_area(beside, -radius_)) /
           made_.reached_area;
  };
  const auto growths_to = [&](const LameCurve& last) {
    std::vector<LameGrowth> growths;
    const bool closest = last == lasts.front();
    if (!closest && with_channel_to(last) < kLeastShare) return growths;
    const std::optional<LameCurve> first = within_channel(beside, last);
    if (!first && closest) refuse(Refusal::kNoRoomForSpiral);
    if (first && !lame_.has_courses()) growths = growths_through_circles(*first, last);
    if (const std::optional<LameCurve> alike = shapes_.first_like(last, island))
      if (const std::optional<LameCurve> from = within_channel(*alike, last))
        growths.push_back(one_stage(*from, last));
    const auto does_little = [&](const LameGrowth& growth) {
      return by_spiral_to(growth) < kLeastRingShare;
    };
    if (!closest)
      growths.erase(std::remove_if(growths.begin(), growths.end(), does_little), growths.end());
    return growths;
  };
  const PlannedGrowth growth = quickest(lasts, false, growths_to, [&](const LameCurve& last) {
    return made_.reached_area + kept_area() - grown_lame_area(last, radius_);
  });
  const LameCurve& first = growth.growth.stages.front().from;
  const double outside = grown_lame_area(growth.growth.stages.back().to, radius_);
  made_.spiral_area = outside - grown_lame_area(first, radius_);
  // A ring resembles its two curves, whatever the channel takes of it.
  check_share(with_channel_to(growth.growth.stages.back().to));
  const double by_spiral = by_spiral_to(growth.growth);
  if (by_spiral < kLeastRingShare) refuse(too_small(lame_), {by_spiral});
  if (by_spiral < kLeastShare) tell(FindingCode::kSpiralAfterChannel, by_spiral);
  clear_first({closed_arcs_of(first, arc_tolerance()), task_.centres.islands});
  if (progress_.cancelled() || plan_.is_empty()) return;
  made_.cleared_area = outside - kept_area();
  cut(growth, angle_of(plan_.here().p - first.centre), false);
}

void Opening::refuse_growth() const {
  if (lame_.has_courses()) refuse(Refusal::kNoGrowthByCourses);
  if (task_.hole && task_.centres.islands.empty()) refuse_hole(Refusal::kHoleOffMiddle);
  refuse(Refusal::kNoGrowth);
}

// The first curve of a ring, as far from the island's wall as a channel is cleared for it; nothing
// where that leaves no room.
std::optional<LameCurve> Opening::within_channel(LameCurve first, const LameCurve& last) const {
  const double room =
      least_lame_radius(last) - distance(first.centre, last.centre) - largest_lame_radius(first);
  const double width = std::min(kFirstChannel * radius_, 0.5 * room);
  if (width < kLeastChannel * radius_) return {};
  first.a += width;
  first.b += width;
  return first;
}

// mm^2 that the island keeps the tool from.
double Opening::kept_area() const {
  return area_of(offset({make_region(task_.centres.islands.front().reversed())}, -radius_));
}

}  // namespace

ClearingParams beside_spiral(ClearingParams params) {
  params.feed_steps = FeedSteps();
  double& angle = params.engagement_angle;
  angle -= load_budget::spared_beside_spiral(angle);
  return params;
}

LameOpening lame_opening(Plan& plan, const RegionTask& task, const ClearingParams& params,
                         const LameParams& lame, Progress& progress) {
  return Opening(plan, task, params, lame, progress).run();
}

}  // namespace evenload
