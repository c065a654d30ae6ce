#include "strategy/choose/pass_choice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cutting/engagement.h"
#include "feed/load_profile.h"
#include "strategy/moves/move_ends.h"
#include "strategy/steer/gap_pass.h"
#include "support/tolerances.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

// Share of the tool's radius: mm of cutting that take as long as what a pass costs besides.
constexpr double kPassPrice = 0.3;
// mm: no pass turns more tightly in a corner where a stage that does not can enter; nor so tightly
// that its turns, most of them by more than this share of the engagement angle, are posted as
// lines.
constexpr double kTightInCorner = 0.1;
constexpr double kTurnShare = 0.5;
// A pass that removes less than this share of the tool's radius squared is little progress.
constexpr double kLeastCut = 1e-4;
// Passes into one corner between two searches for the best stage.
constexpr int kTryEvery = 4;
// The step of that search, in stages.
constexpr std::size_t kStagesAtOnce = 3;

// Shares of the tool's radius: between two looks back along a gap's wall for a place where the tool
// is clear, and the furthest of them.
constexpr double kBackLook = 0.02;
constexpr double kFurthestBack = 0.3;

// `length` mm before a place of a closed border.
WallPlace before(const Curve& border, WallPlace place, double length) {
  for (;;) {
    const double whole = border.segment(place.segment).length(), done = place.t * whole;
    if (done >= length || whole <= 0) break;
    length -= done;
    place.segment = (place.segment + border.segment_count() - 1) % border.segment_count();
    place.t = 1;
  }
  place.t -= length / border.segment(place.segment).length();
  return place;
}

double tightest_in_corner(double engagement) {
  const double span = std::sin(std::min(kTurnShare * engagement, kPi / 2));
  return std::max(kTightInCorner, std::sqrt((kLeastSpan + kSpanMargin) / span));
}

// Tries the stages from `start` on and before `end`, a few at a time, uphill from `first`.
template <typename Value>
void climb_stages(std::size_t start, std::size_t first, std::size_t end, double middle,
                  Value value_of) {
  double last = middle;
  for (std::size_t k = first + kStagesAtOnce; k < end; k += kStagesAtOnce) {
    const double value = value_of(k);
    if (value < last) break;
    last = value;
  }
  if (last > middle) return;
  for (std::size_t k = first; k >= start + kStagesAtOnce;) {
    k -= kStagesAtOnce;
    const double value = value_of(k);
    if (value < last) break;
    last = value;
  }
}

}  // namespace

bool is_progress(const Pass& pass, double tool_radius) {
  return !pass.empty() && pass.cut_area > kLeastCut * tool_radius * tool_radius;
}

PassChoice::PassChoice(ClearedGround& ground, const std::vector<Stage>& stages,
                       const ClearingParams& params, const TurnLimits& limits)
    : ground_(ground),
      stages_(stages),
      params_(params),
      limits_(limits),
      radius_(ground.tool_radius()),
      since_tried_(kTryEvery) {}

// Right turns shrink with the stage's left turns.
Steering PassChoice::steering_on(const Stage& stage) {
  const double share = std::min(1.0, stage.turn_radius / limits_.widest);
  return Steering(ground_, stage, params_.engagement_angle,
                  std::max(params_.minimum_radius * share, limits_.tightest));
}

Steering PassChoice::steering_at(std::size_t k) { return steering_on(stages_[k]); }

std::size_t PassChoice::widest_stage_at(const Pose& pose) const {
  for (std::size_t k = 0; k < stages_.size(); ++k) {
    if (stages_[k].turn_radius <= 0) break;
    const Vec2 q = pose.p + stages_[k].turn_radius * left_normal(unit(pose.heading));
    if (stages_[k].turns.signed_distance(q) > -1e-6) return k;
  }
  return stages_.size();
}

Pass PassChoice::from_pose(const Pose& start, double* turn_radius) {
  for (std::size_t k = widest_stage_at(start); k < stages_.size(); ++k) {
    if (stages_[k].turn_radius <= 0) break;
    Pass pass = steering_at(k).from_pose(start);
    *turn_radius = stages_[k].turn_radius;
    if (!pass.empty()) return pass;
  }
  return {};
}

Pass PassChoice::from_entry(const Pose& start, double* turn_radius) {
  Pass widest;  // of those that end in the material
  double radius_of_widest = 0;
  for (std::size_t k = widest_stage_at(start); k < stages_.size(); ++k) {
    if (stages_[k].turn_radius <= 0) break;
    Pass pass = steering_at(k).from_pose(start);
    if (pass.empty()) continue;
    *turn_radius = stages_[k].turn_radius;
    if (pass.idle_after > 0) return pass;
    take_back(ground_, pass);
    if (!widest.empty()) continue;
    widest = std::move(pass);
    radius_of_widest = stages_[k].turn_radius;
  }
  *turn_radius = radius_of_widest;
  for (const Segment& move : widest.moves) ground_.add(move);
  return widest;
}

bool PassChoice::leads_nowhere(const Entry& entry) {
  const std::size_t before = ground_.size();
  add_descent(entry.descent, ground_);
  double turn_radius = 0;
  const Pass pass = from_entry(entry.start, &turn_radius);
  while (ground_.size() > before) ground_.remove_last();
  return !pass.empty() && !is_progress(pass, radius_);
}

// mm^2 per mm of cutting at the nominal feed: what a pass removes, by the time that it takes.
double PassChoice::worth(const Pass& pass) const {
  const double full = pass.cut_area / side_step(params_.engagement_angle, radius_);
  const double thin = std::max(0.0, length_of(pass.moves) - full);
  return pass.cut_area / (full + thin * params_.feed / params_.maximum_feed + kPassPrice * radius_);
}

// The pass into a corner that is worth most: the more tightly it turns the sooner it is at its
// full engagement, and the less it is stopped by the walls. Stages are tried from the one that
// was best last, uphill.
Pass PassChoice::best_corner_pass(const PassStart& start, double* turn_radius) {
  Pass best = latest_wall_pass(start, turn_radius);
  take_back(ground_, best);
  double most = best.empty() ? 0 : worth(best);
  const auto value_of = [&](std::size_t k) {
    const BoundaryIndex::Hit hit = stages_[k].centres.nearest(start.pose.p);
    if (hit.distance > kOnWall) return 0.0;
    Pass pass = steering_at(k).from_wall({hit.curve, hit.segment, hit.t});
    take_back(ground_, pass);
    const double value = pass.empty() ? 0 : worth(pass);
    if (value > most) {
      most = value;
      best = std::move(pass);
      *turn_radius = stages_[k].turn_radius;
      best_in_corner_ = k;
    }
    return value;
  };
  std::size_t end = stages_.size() - 1;  // the exact border cannot be steered at
  const double tightest = tightest_in_corner(params_.engagement_angle);
  while (end > start.stage + 1 && stages_[end - 1].turn_radius < tightest) --end;
  if (start.stage < end) {
    const std::size_t first = std::clamp(best_in_corner_, start.stage, end - 1);
    // From pass to pass in a corner the best stage hardly changes.
    const bool same = distance(start.pose.p, tried_at_) < radius_ && ++since_tried_ < kTryEvery;
    const double middle = value_of(first);
    if (!same || middle == 0) {
      since_tried_ = 0;
      climb_stages(start.stage, first, end, middle, value_of);
    }
    tried_at_ = start.pose.p;
  }
  for (const Segment& move : best.moves) ground_.add(move);
  return best;
}

// The pass along the wall of the latest stage, after the start's own, that can be followed within
// the limit all the way. The earlier the stage the less there is to cut: the last comes first,
// since along walls that little is left of it is the only one to be tried, or in a corner that a
// pass has just been led into that pass's stage and the next to it; then it is found by halving.
Pass PassChoice::latest_wall_pass(const PassStart& start, double* turn_radius) {
  Pass best;
  std::size_t low = start.stage + 1, high = stages_.size();  // of the stages not yet decided
  if (low >= high) return best;
  const bool is_known = followed_at_ && distance(start.pose.p, *followed_at_) < radius_;
  std::size_t k = is_known ? std::clamp(latest_followed_, low, high - 1) : high - 1;
  for (int tries = 1; low < high; ++tries) {
    const BoundaryIndex::Hit hit = stages_[k].centres.nearest(start.pose.p);
    Pass pass;
    if (hit.distance < kOnWall) pass = steering_at(k).along_wall({hit.curve, hit.segment, hit.t});
    if (pass.empty()) {
      high = k;
    } else {
      take_back(ground_, pass);
      best = std::move(pass);
      *turn_radius = stages_[k].turn_radius;
      latest_followed_ = k;
      followed_at_ = start.pose.p;
      low = k + 1;
    }
    const bool was_likely = is_known && tries == 1;
    if (low < high) k = !was_likely ? low + (high - low) / 2 : high == k ? k - 1 : k + 1;
  }
  for (const Segment& move : best.moves) ground_.add(move);
  return best;
}

// The last place of the exact border before the nearest one to `p` where the tool is clear.
std::optional<Pose> PassChoice::clear_before(Vec2 p) const {
  const Area& exact = stages_.back().centres;
  const BoundaryIndex::Hit hit = exact.nearest(p);
  const Curve& border = exact.curves()[hit.curve];
  const double step = kBackLook * radius_;
  WallPlace place{hit.curve, hit.segment, hit.t};
  for (double back = 0; back < kFurthestBack * radius_; back += step) {
    const Segment piece = border.segment(place.segment);
    const Vec2 at = piece.point(place.t);
    if (ground_.is_clear(at)) return Pose{at, angle_of(piece.tangent(place.t))};
    place = before(border, place, step);
  }
  return std::nullopt;
}

// In a gap where passes would turn by several arcs that posts cannot write: along the walls of the
// start's stage, or where these end in arcs of their own along the exact border.
Pass PassChoice::across_gap(const PassStart& start, double* turn_radius) {
  Pass pass = gap_pass(stages_[start.stage].centres, start.pose, ground_, params_.engagement_angle);
  if (pass.empty())
    if (const std::optional<Pose> exact = clear_before(start.pose.p))
      pass = gap_pass(stages_.back().centres, *exact, ground_, params_.engagement_angle);
  if (pass.empty()) return pass;
  *turn_radius = pass.moves.back().radius;  // of one arc, or of the wider of two
  if (pass.moves.size() > 1 && pass.moves[pass.moves.size() - 2].is_arc())
    *turn_radius = std::min(*turn_radius, pass.moves[pass.moves.size() - 2].radius);
  return pass;
}

Pass PassChoice::from_wall(const PassStart& start, double* turn_radius) {
  if (stages_[start.stage].turn_radius < tightest_in_corner(params_.engagement_angle)) {
    Pass pass = across_gap(start, turn_radius);
    if (!pass.empty()) return pass;
  }
  if (start.corner) {
    Pass pass = best_corner_pass(start, turn_radius);
    if (!pass.empty()) return pass;
  }
  for (std::size_t k = start.stage; k < stages_.size(); ++k) {
    WallPlace place = start.place;
    if (k != start.stage) {
      if (stages_[k].turn_radius <= 0) break;
      const BoundaryIndex::Hit hit = stages_[k].centres.nearest(start.pose.p);
      if (hit.distance > kOnWall) break;
      place = {hit.curve, hit.segment, hit.t};
    }
    *turn_radius = stages_[k].turn_radius;
    Steering steering = steering_at(k);
    Pass pass = steering.from_wall(place);
    if (pass.empty() && stages_[k].turn_radius <= 0) pass = steering.bit_by_bit(place);
    if (!pass.empty()) return pass;
  }
  return {};
}

void take_back(ClearedGround& ground, const Pass& pass) {
  for (std::size_t i = 0; i < pass.moves.size(); ++i) ground.remove_last();
}

}  // namespace evenload
