#include "strategy/lame_opening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>

#include "feed/load_profile.h"
#include "geometry/box_tree.h"
#include "strategy/entry.h"
#include "strategy/lame_fit.h"
#include "strategy/lame_turns.h"
#include "strategy/links.h"
#include "support/errors.h"

namespace evenload {
namespace {

// Share of the user's tolerance within which arcs follow the spiral; it stays this far from walls.
constexpr double kArcShare = 0.8;
// Arcs turn this share more tightly than the curve that they follow.
constexpr double kArcRadius = 1.03;
// The spiral is no longer than this times its width: a longer one cuts with its ends only.
constexpr double kLongest = 2;
constexpr const char* kKinds =
    "A Lamé spiral clears pockets without islands, or with one island and an outline that is all "
    "wall or all open: take the operation Adaptive.";
// Tool radii: the spiral's corners are no tighter, although the minimum radius may be: around
// tighter ones most of each turn would be idle, and what is left in the corners is little.
constexpr double kCornerRadius = 1.2;
// Tool radii: what is cleared before a spiral that cannot begin with a helix or a hole, as the
// radius of a disc of tool centres, and as the width of a channel of them around a ring's island.
constexpr double kFirstDisc = 1, kFirstChannel = 1;
constexpr double kLeastChannel = 0.05;
// Tool radii: of the first circle in a hole no wider than the tool.
constexpr double kTightestCircle = 0.01;
// Share of the engagement angle.
constexpr double kBesideSpiral = 0.993;
// rad: a spiral that exceeds the engagement angle by more is none.
constexpr double kMostOver = 1 * kPi / 180;
// Tool radii at which the first turn of a spiral from outside passes the stock.
constexpr double kBeside = 1.02;
// Between the shapes of two spirals the circle that joins them has this share of its radius to
// spare, at least; otherwise one goes over into the other without it.
constexpr double kCircleRoom = 0.05;
// Such circles are tried, as shares of that room.
constexpr std::array<double, 3> kCircles = {0.15, 0.45, 0.75};

double area_of(const std::vector<Region>& regions) {
  double sum = 0;
  for (const Region& region : regions) sum += region.area();
  return sum;
}

// A circle with the curve's segments and rotation.
LameCurve circle_for(const LameCurve& curve, Vec2 centre, double radius) {
  LameCurve circle = curve;
  circle.centre = centre;
  circle.a = circle.b = radius;
  circle.exponent = 1;
  return circle;
}

std::string percent(double share) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << 100 * share;
  return text.str();
}

class Opening {
 public:
  Opening(const RegionTask& task, const ClearingParams& params, const LameParams& lame,
          Progress& progress)
      : task_(task),
        params_(params),
        lame_(lame),
        progress_(progress),
        radius_(0.5 * params.tool_diameter),
        ground_(grown(bounds_of({task.centres}), radius_), radius_,
                task.has_open_edges ? &task.material : nullptr) {}

  LameOpening run() {
    made_.reached_area = area_of(offset({task_.centres}, radius_));
    if (task_.centres.islands.empty() && !task_.has_open_edges)
      clear_pocket_of_one_wall();
    else if (task_.centres.islands.size() != 1)
      refuse(kKinds);
    else if (task_.has_open_edges)
      clear_stock_around_island();
    else
      clear_ring();
    made_.cleared_area = std::max(made_.cleared_area, made_.spiral_area);
    return std::move(made_);
  }

 private:
  Vec2 shown(Vec2 p) const { return {task_.mirrored ? -p.x : p.x, p.y}; }

  [[noreturn]] void refuse(const std::string& sentence) const {
    throw GeometryError(GeometryErrorCode::kNoLameCurve,
                        shown(task_.centres.outer.vertices().front().p), sentence);
  }

  // The stock in which the region's island stands.
  const Region& stock() const {
    const Vec2 p = task_.centres.islands.front().vertices().front().p;
    for (const Region& region : task_.material)
      if (region.outer.contains(p)) return region;
    return task_.material.front();
  }

  double arc_tolerance() const { return kArcShare * params_.tolerance; }

  LameFitTask fit_task(LameSide side) const {
    LameFitTask fit;
    fit.side = side;
    fit.least_radius = kArcRadius * std::max(params_.minimum_radius, kCornerRadius * radius_);
    fit.margin = arc_tolerance();
    fit.wishes = {lame_.centre,      lame_.segments,     lame_.semi_axis_a,
                  lame_.semi_axis_b, lame_.exponent_end, lame_.rotation};
    return fit;
  }

  bool has_wished_size() const { return lame_.semi_axis_a || lame_.semi_axis_b; }

  LameCurve fitted(const Curve& outline, LameFitTask fit) const {
    std::optional<LameCurve> curve = fit_lame_curve(outline, fit);
    if (curve && !has_wished_size() && fit.side == LameSide::kInside &&
        std::max(curve->a, curve->b) > kLongest * std::min(curve->a, curve->b)) {
      const bool along_a = curve->a > curve->b;
      (along_a ? fit.wishes.semi_axis_a : fit.wishes.semi_axis_b) =
          kLongest * std::min(curve->a, curve->b);
      fit.wishes.segments = 4;
      fit.wishes.rotation = curve->rotation;
      fit.wishes.centre = curve->centre;
      if (const std::optional<LameCurve> shorter = fit_lame_curve(outline, fit)) curve = shorter;
    }
    if (curve) return *curve;
    const LameWishes& w = fit.wishes;
    if (w.centre && !outline.contains(*w.centre))
      refuse("Centre lies outside the pocket: move it inside, or leave it unset.");
    if (w.centre || w.segments || w.semi_axis_a || w.semi_axis_b || w.exponent || w.rotation)
      refuse(
          "With the set properties no Lamé curve keeps clear of the walls: leave some of them "
          "unset, or take the operation Adaptive.");
    refuse("No Lamé curve resembles this pocket: take the operation Adaptive.");
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
    return turns;
  }

  void clear_pocket_of_one_wall() {
    const LameCurve last = fitted(task_.centres.outer, fit_task(LameSide::kInside));
    made_.spiral_area = grown_lame_area(last, radius_);
    check_share(made_.spiral_area / made_.reached_area);
    Circle first{task_.hole.value_or(last.centre), 0};
    const double room = least_lame_radius(last);
    if (task_.hole) {
      first.radius = enter_hole();
    } else if (params_.entry == EntryKind::kPredrilledHole) {
      throw GeometryError(GeometryErrorCode::kEntryOutside, shown(last.centre),
                          "The pre-drilled hole lies outside this pocket: choose the entry "
                          "'Automatic', or another hole.");
    } else {
      first.radius = helix_radius(params_, {first.centre, room});
      if (params_.entry == EntryKind::kRamp) first.radius = clear_disc(first.centre, room);
    }
    LameCurve circle = circle_for(last, first.centre, first.radius);
    circle.exponent = lame_.exponent_start.value_or(1);
    // A first curve that is no circle touches the entry's circle from inside, at its corners.
    circle.a = circle.b = first.radius / std::pow(2, (1 - circle.exponent) / 2);
    const double start = last.rotation + kPi / last.segments;
    if (made_.result.runs.empty()) {
      begin_run({DescentKind::kHelix,
                 first.centre + first.radius * unit(start),
                 first.centre,
                 first.radius,
                 {},
                 false});
    }
    cut(best_of({{{{circle, last}}}}, false), start, false);
  }

  void check_share(double share) const {
    if (share < kLeastShare && !has_wished_size())
      refuse("No Lamé curve resembles this pocket: the largest spiral inside would clear " +
             percent(share) + " % of it; take the operation Adaptive.");
  }

  void begin_run(const Descent& descent) {
    made_.result.runs.push_back({descent, {}, made_.result.runs.empty()});
    add_descent(descent, ground_);
  }

  void add_moves(MoveKind kind, const std::vector<Segment>& moves) {
    for (const Segment& move : moves) {
      made_.result.runs.back().moves.push_back({kind, move});
      ground_.add(move);
    }
  }

  // Returns the radius of the circle that the tool's centre can run on in the hole.
  double enter_hole() {
    ground_.add_disc(*task_.hole, 0.5 * params_.hole_diameter);
    begin_run({DescentKind::kPlunge, *task_.hole, {}, 0, {}, false});
    // A hole no wider than the tool leaves no room to turn: the first circle is a small cut, then.
    return std::max(0.5 * params_.hole_diameter - radius_, kTightestCircle * radius_);
  }

  // Clears a disc at constant engagement, with an entry of its own; returns the radius of what the
  // tool's centre has cleared.
  double clear_disc(Vec2 centre, double room) {
    const double disc = std::min(kFirstDisc * radius_, room);
    const Vertex side{centre + Vec2{disc, 0}, 1}, other{centre - Vec2{disc, 0}, 1};
    clear_first(make_region(Curve({side, other}, true)));
    return disc;
  }

  // Clears a region of tool centres at constant engagement, as the way to the spiral.
  void clear_first(const Region& centres) {
    RegionTask first = task_;
    first.centres = centres;
    first.around = {task_.centres};
    if (first.hole && !centres.contains(*first.hole)) {
      if (params_.entry == EntryKind::kPredrilledHole)
        throw GeometryError(GeometryErrorCode::kEntryOutside, shown(*first.hole),
                            "A Lamé spiral around an island begins beside its wall: drill the "
                            "hole there, or choose the entry 'Automatic'.");
      first.hole.reset();
    }
    Progress half([&](double done) { return progress_.report(kFirstHalf * done); });
    made_.result = clear_region(first, beside_spiral(params_), half);
    made_.result.uncut_area = 0;  // of the first region only: told of at the end
    for (const PlanarRun& run : made_.result.runs) {
      add_descent(run.descent, ground_);
      for (const PlanarMove& move : run.moves) ground_.add(move.segment);
    }
  }

  // The spiral through a growth, from where the tool is.
  void cut(const PlannedGrowth& growth, double start, bool inwards) {
    const LameTurns turns = turns_of(growth, turn_task(inwards), start, arc_tolerance(), ground_);
    if (turns.engagement > params_.engagement_angle + kMostOver) refuse_load();
    go_to({turns.moves.front().a, angle_of(turns.moves.front().tangent(0))});
    add_moves(MoveKind::kCut, turns.moves);
    ++made_.result.passes;
    made_.figures = {growth.growth.stages.back().to, growth.growth.stages.front().from.exponent,
                     turns.largest_pitch};
    if (lame_.pitch && turns.smallest_pitch < *lame_.pitch * (1 - 1e-6)) {
      std::ostringstream note;
      note << std::fixed << std::setprecision(3) << "Pitch is smaller than set in some turns, down "
           << "to " << turns.smallest_pitch << " mm: the engagement angle allows no more there.";
      made_.result.notes.push_back(note.str());
    }
  }

  [[noreturn]] void refuse_load() const {
    if (task_.hole)
      throw GeometryError(GeometryErrorCode::kEntryOutside, shown(*task_.hole),
                          "The pre-drilled hole is too tight to start a spiral from: drill it "
                          "wider, or choose the entry 'Helix'.");
    refuse(
        "No Lamé spiral keeps to the engagement angle in this pocket: take the operation "
        "Adaptive.");
  }

  // To the spiral's start: over cleared ground, or down beside it.
  void go_to(const Pose& start) {
    const PlanarRun* last = made_.result.runs.empty() ? nullptr : &made_.result.runs.back();
    if (last && last->moves.empty() && distance(last->descent.at, start.p) < 1e-9) return;
    if (last && last->moves.empty()) {  // in the hole: by half a turn that ends along its rim
      const Vec2 from = last->descent.at, middle = 0.5 * (from + start.p);
      const bool cuts = 0.5 * params_.hole_diameter - radius_ < distance(from, start.p) - 1e-9;
      add_moves(cuts ? MoveKind::kCut : MoveKind::kLink,
                {Segment::arc(middle, distance(middle, from), angle_of(from - middle), kPi)});
      return;
    }
    if (last) {
      const Segment& end = last->moves.back().segment;
      const std::vector<Segment> link =
          quicker_link({ground_, ground_.size()}, Area({task_.centres}),
                       {end.b, angle_of(end.tangent(1))}, start, radius_, params_);
      if (!link.empty()) {
        add_moves(MoveKind::kLink, link);
        ++made_.result.links;
        return;
      }
    }
    begin_run({DescentKind::kPlunge, start.p, {}, 0, {}, last != nullptr});
  }

  void clear_stock_around_island();
  void clear_ring();
  LameCurve around_island(const LameFitTask& task) const;
  static std::vector<LameGrowth> joined(const LameCurve& from, const LameCurve& to);
  static std::optional<LameCurve> alike_curve(const Curve& outline, LameFitTask task,
                                              const LameCurve& other);
  PlannedGrowth best_of(const std::vector<LameGrowth>& growths, bool inwards) const;
  LameCurve within_channel(LameCurve first, const LameCurve& last) const;
  double kept_area() const;

  const RegionTask& task_;
  const ClearingParams& params_;
  const LameParams& lame_;
  Progress& progress_;
  double radius_;
  ClearedGround ground_;
  LameOpening made_;
};

// From the edge of the stock inwards.
void Opening::clear_stock_around_island() {
  const std::vector<Vertex>& outline = stock().outer.vertices();
  if (!std::all_of(outline.begin(), outline.end(), [](const Vertex& v) { return v.open; }))
    refuse(kKinds);
  const LameCurve last = around_island(fit_task(LameSide::kAround));
  Region around = stock();
  around.islands.clear();
  const Curve outside = offset({around}, kBeside * radius_).front().outer;
  LameFitTask outer = fit_task(LameSide::kAround);
  outer.wishes = {};
  const LameCurve first = fitted(outside, outer);

  const double area = stock().outer.signed_area(), inside = grown_lame_area(last, -radius_);
  made_.reached_area = area - kept_area();
  made_.spiral_area = area - inside;
  check_share(made_.spiral_area / made_.reached_area);
  check_share(made_.spiral_area / (grown_lame_area(first, -radius_) - inside));

  std::vector<LameGrowth> growths = joined(first, last);
  if (const std::optional<LameCurve> alike = alike_curve(outside, outer, last))
    growths.push_back({{{*alike, last}}});
  const PlannedGrowth growth = best_of(growths, true);
  const LameCurve& from = growth.growth.stages.front().from;
  cut(growth, from.rotation + kPi / from.segments, true);
}

// From a channel along the island's wall outwards: that wall is the shorter one, and a channel is
// dear.
void Opening::clear_ring() {
  LameFitTask around = fit_task(LameSide::kAround);
  around.wishes = {};
  const LameCurve last = fitted(task_.centres.outer, fit_task(LameSide::kInside));
  const LameCurve beside = around_island(around);
  const double outside = grown_lame_area(last, radius_);
  check_share((outside - grown_lame_area(beside, -radius_)) / made_.reached_area);

  std::vector<LameGrowth> growths = joined(within_channel(beside, last), last);
  if (const std::optional<LameCurve> alike =
          alike_curve(task_.centres.islands.front().reversed(), around, last))
    growths.push_back({{{within_channel(*alike, last), last}}});
  const PlannedGrowth growth = best_of(growths, false);
  const LameCurve& first = growth.growth.stages.front().from;
  clear_first({closed_arcs_of(first, arc_tolerance()), task_.centres.islands});
  if (progress_.cancelled() || made_.result.runs.empty()) return;
  made_.spiral_area = outside - grown_lame_area(first, radius_);
  made_.cleared_area = outside - kept_area();
  const PlanarRun& run = made_.result.runs.back();
  const Vec2 here = run.moves.empty() ? run.descent.at : run.moves.back().segment.b;
  cut(growth, angle_of(here - first.centre), false);
}

PlannedGrowth Opening::best_of(const std::vector<LameGrowth>& growths, bool inwards) const {
  const std::optional<PlannedGrowth> best = best_growth(growths, turn_task(inwards));
  if (!best)
    refuse(
        "No Lamé spiral leads from one outline of this pocket to the other: take the operation "
        "Adaptive.");
  return *best;
}

// The curve for an outline with another one's segments and rotation: it goes over into that one
// without a circle.
std::optional<LameCurve> Opening::alike_curve(const Curve& outline, LameFitTask task,
                                              const LameCurve& other) {
  task.wishes.segments = other.segments;
  task.wishes.rotation = other.rotation;
  return fit_lame_curve(outline, task);
}

LameCurve Opening::around_island(const LameFitTask& task) const {
  return fitted(task_.centres.islands.front().reversed(), task);
}

// From one curve through a circle between them to the other, the circle being smaller or larger.
std::vector<LameGrowth> Opening::joined(const LameCurve& from, const LameCurve& to) {
  const bool inwards = from.a > to.a;
  const LameCurve &inner = inwards ? to : from, &outer = inwards ? from : to;
  const double apart = distance(from.centre, to.centre);
  const double low = largest_lame_radius(inner), high = least_lame_radius(outer) - apart;
  std::vector<LameGrowth> growths;
  if (high - low < kCircleRoom * high) return growths;
  for (const double share : kCircles) {
    const double radius = low + share * (high - low);
    growths.push_back({{{from, circle_for(from, inner.centre, radius), 1, LameJoint::kAtEnd},
                        {circle_for(to, inner.centre, radius), to, 1, LameJoint::kAtBegin}}});
  }
  return growths;
}

// The first curve of a ring, as far from the island's wall as a channel is cleared for it.
LameCurve Opening::within_channel(LameCurve first, const LameCurve& last) const {
  const double room =
      least_lame_radius(last) - distance(first.centre, last.centre) - largest_lame_radius(first);
  const double width = std::min(kFirstChannel * radius_, 0.5 * room);
  if (width < kLeastChannel * radius_)
    refuse(
        "Between the walls there is too little room for a Lamé spiral: take the operation "
        "Adaptive.");
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
  params.engagement_angle *= kBesideSpiral;
  return params;
}

LameOpening lame_opening(const RegionTask& task, const ClearingParams& params,
                         const LameParams& lame, Progress& progress) {
  return Opening(task, params, lame, progress).run();
}

}  // namespace evenload
