#include "strategy/trochoid/trochoid_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "cutting/engagement.h"
#include "geometry/intersect.h"
#include "strategy/moves/move_ends.h"
#include "strategy/reach/links.h"
#include "strategy/steer/stage.h"
#include "support/both.h"
#include "support/tolerances.h"

namespace evenload {
namespace {

constexpr int kMostPasses = 30;
// Passes at most that are looked at together.
constexpr std::size_t kMostAlternating = 6;
// Turn radii that are tried, as multiples of the tightest, up to kWidestTurn and the wish; the
// likely one serves best in most slots.
constexpr double kTurns[] = {1, 2, 4, 10};
constexpr double kLikelyTurn = 2;
// Shares of half the room: no turn is wider than the first; there is room for turns up to the
// second.
constexpr double kWidestTurn = 0.8;
constexpr double kRoomyTurn = 0.4;
// Share of the best removal rate before: beyond a radius that comes to less no others are tried.
constexpr double kWorthMore = 1.002;
// Share of a removal rate: others that differ by less are the same.
constexpr double kSameRate = 0.005;
// Share of the tool's radius: no turn is tighter for the sake of the removal rate.
constexpr double kTightestTurn = 0.025;
// Share of the tool's radius: so far before the end of the last pass on the wall the next begins.
constexpr double kRunUp = 0.1;
// Places at which the advance of a front is looked at.
constexpr int kFrontLooks = 16;
// Lines side by side that clear the ground behind the first front.
constexpr int kLinesBehind = 8;
// Share of a full circle that a bent strip may take.
constexpr double kMostOfSweep = 0.75;
// Of the settled advance: what the step is likely to be, since a little of a pass meets more than
// the rest; what it is so at the least; and the most that it may become.
constexpr double kLikelyStep = 0.98;
constexpr double kSureStep = 0.97;
constexpr double kStepRoom = 1.05;

using Front = std::array<double, kFrontLooks>;

// Steers pass after pass along a strip.
class Passes {
 public:
  Passes(const TrochoidParams& params, double turn_radius, Steps steps, const SlotFront& front)
      : params_(params),
        room_(half_room(params)),
        back_(4 * params.tool_radius + 2 * room_),
        ahead_(length_ahead()),
        stage_(stage(turn_radius)),
        ground_(grown_bounds(), params.tool_radius, nullptr),
        steering_(ground_, stage_, most_engagement(params), turn_radius, steps) {
    if (params.progress) ground_.tell(*params.progress);
    clear_behind(front);
    note_wall(front.way);
  }

  bool can_turn() const { return !stage_.turns.empty(); }

  // The next pass, without what it has of idle way; empty at the strip's end.
  std::vector<Segment> next() {
    if (at_ > ahead_ - 2 * (params_.tool_radius + room_)) return {};
    const BoundaryIndex::Hit hit =
        stage_.centres.nearest(on_wall(at_ - kRunUp * params_.tool_radius));
    Pass pass = steering_.from_wall({hit.curve, hit.segment, hit.t});
    if (pass.empty()) return {};
    note_wall(pass.moves);
    std::vector<Segment> moves = joined(pass.moves);
    drop_first(moves, pass.idle_before);
    drop_last(moves, pass.idle_after);
    return moves;
  }

  Front front_of(const std::vector<Segment>& pass) const {
    Front front;
    for (int i = 0; i < kFrontLooks; ++i) {
      const Segment level = along_strip(room_ * ((2 * i + 1.0) / kFrontLooks - 1), -back_, ahead_);
      front[i] = -std::numeric_limits<double>::infinity();
      for (const Segment& move : pass)
        for (const Meeting& meeting : meetings(move, level, 1e-9))
          front[i] = std::max(front[i], along(meeting.p));
    }
    return front;
  }

  // Whether a move runs beside the middle, `aside` mm to the left.
  bool lies_aside(const Segment& move, double aside) const {
    for (const double t : {0.0, 0.5, 1.0})
      if (std::abs(offset_of(move.point(t)) - aside) > kSame) return false;
    return true;
  }

  // mm along the middle.
  double along(Vec2 p) const {
    if (params_.curvature == 0) return p.x;
    const double side = params_.curvature > 0 ? 1 : -1;
    const double turned = side * (angle_of(p - centre()) + side * kPi / 2);
    const double first = -back_ * std::abs(params_.curvature);
    return (wrap_positive(turned - first) + first) / std::abs(params_.curvature);
  }

 private:
  // Lines beside each other up to the front's passes, as many as a pass may reach back to.
  void clear_behind(const SlotFront& front) {
    double back = 0, ahead = 0;  // mm along the middle
    for (const Segment& move : front.way) {
      back = std::min(back, along(move.b));
      ahead = std::max(ahead, along(move.b));
    }
    const double reach = ahead - back + 2 * params_.tool_radius;
    const int before = front.step > 0 ? static_cast<int>(std::ceil(reach / front.step)) : 0;
    for (int i = 0; i <= kLinesBehind; ++i) {
      const double aside = room_ * (2.0 * i / kLinesBehind - 1);
      ground_.add(along_strip(aside, -back_, back - before * front.step));
    }
    for (int k = before; k >= 0; --k)
      for (const Segment& move : placed(front.way, place_along(params_.curvature, -k * front.step)))
        ground_.add(move);
  }

  // How far a pass has followed the right wall.
  void note_wall(const std::vector<Segment>& pass) {
    for (const Segment& move : pass) {
      if (!lies_aside(move, -room_)) break;
      at_ = along(move.b);
    }
  }

  Vec2 centre() const { return {0, 1 / params_.curvature}; }

  double offset_of(Vec2 p) const {
    if (params_.curvature == 0) return p.y;
    const double side = params_.curvature > 0 ? 1 : -1;
    return side * (1 / std::abs(params_.curvature) - norm(p - centre()));
  }

  double length_ahead() const {
    const double wish = kMostPasses * side_step(params_.engagement, params_.tool_radius) +
                        4 * (params_.tool_radius + room_);
    if (params_.curvature == 0) return wish;
    return std::min(wish, kMostOfSweep * 2 * kPi / std::abs(params_.curvature) - back_);
  }

  Stage stage(double turn_radius) const {
    Stage result;
    if (ahead_ <= 0) return result;
    const Region strip = strip_of(params_, back_, ahead_);
    result.turn_radius = turn_radius;
    result.rooms = {strip};
    result.centres = Area({strip});
    result.turns = Area(offset({strip}, -turn_radius));
    return result;
  }

  Bounds grown_bounds() const {
    const double r = params_.tool_radius;
    const Bounds box = bounds_of(stage_.rooms);
    return {box.low - Vec2{r, r}, box.high + Vec2{r, r}};
  }

  Segment along_strip(double aside, double from, double to) const {
    const Pose a = place_along(params_.curvature, from), b = place_along(params_.curvature, to);
    return Segment::from_bulge(a.p + aside * left_normal(unit(a.heading)),
                               b.p + aside * left_normal(unit(b.heading)),
                               std::tan(params_.curvature * (to - from) / 4));
  }

  Vec2 on_wall(double s) const {
    const Pose at = place_along(params_.curvature, s);
    return at.p - room_ * left_normal(unit(at.heading));
  }

  const TrochoidParams& params_;
  double room_, back_, ahead_;
  Stage stage_;
  ClearedGround ground_;
  Steering steering_;
  double at_ = 0;  // mm along the middle where the last pass left the wall
};

double mean_of(const Front& front) {
  double sum = 0;
  for (const double s : front) sum += s;
  return sum / kFrontLooks;
}

// Goes on with the last turn until the tool is clear of the scallop between this period's place on
// the left wall and the one's before.
void turn_off_wall(std::vector<Segment>& cut, double step, const TrochoidParams& params) {
  Segment& last = cut.back();
  if (!last.is_arc() || last.sweep <= 0) return;
  const double scallop = step * step / (8 * params.tool_radius);
  const double more = std::acos(std::max(0.0, 1 - scallop / last.radius));
  last = Segment::arc(last.centre, last.radius, last.start_angle, last.sweep + more);
}

// The cut alone, without what follows the left wall where that is left to a pass of its own, begun
// at the origin's place along the middle.
TrochoidPattern pattern_of(const PassSequence& sequence, const Passes& passes,
                           const TrochoidParams& params) {
  TrochoidPattern pattern;
  pattern.curvature = params.curvature;
  pattern.residuals = sequence.residuals;
  std::vector<Segment> cut = sequence.passes.back();
  while (!params.finish_walls && cut.size() > 1 && passes.lies_aside(cut.back(), half_room(params)))
    cut.pop_back();
  if (!params.finish_walls) turn_off_wall(cut, sequence.advance, params);
  const Pose back = place_along(params.curvature, -passes.along(cut.front().a));
  pattern.cut = placed(cut, back);
  return pattern;
}

// mm: by how much the advance differs from place to place, of the last pass or, where that is less,
// in the mean of a few: once settled, passes go on to alternate within the steering's tolerance.
// Condition: two fronts at least.
double residual_of(const std::vector<Front>& fronts) {
  double residual = std::numeric_limits<double>::infinity();
  const std::size_t most = std::min<std::size_t>(kMostAlternating, fronts.size() - 1);
  for (std::size_t k = 1; k <= most; ++k) {
    const Front &now = fronts.back(), &before = fronts[fronts.size() - 1 - k];
    double least = std::numeric_limits<double>::infinity(), furthest = -least;
    for (int i = 0; i < kFrontLooks; ++i) {
      least = std::min(least, now[i] - before[i]);
      furthest = std::max(furthest, now[i] - before[i]);
    }
    residual = std::min(residual, (furthest - least) / static_cast<double>(k));
  }
  return residual;
}

PassSequence iterate(Passes& passes, const TrochoidParams& params, int most) {
  PassSequence result;
  std::vector<Front> fronts;
  const auto is_settled = [&] {
    return !result.residuals.empty() && result.residuals.back() < kSettled * params.tool_radius;
  };
  for (int k = 0; k < most && !is_settled(); ++k) {
    std::vector<Segment> pass = passes.next();
    if (pass.empty()) break;
    fronts.push_back(passes.front_of(pass));
    // One that ends on its way across leaves a front to the next that has yet to be taken.
    if (!std::isfinite(mean_of(fronts.back()))) {
      fronts.pop_back();
      continue;
    }
    if (!result.passes.empty()) {
      result.residuals.push_back(residual_of(fronts));
      result.advance = mean_of(fronts.back()) - mean_of(fronts.end()[-2]);
    }
    result.passes.push_back(std::move(pass));
  }
  return result;
}

SlotFront round_front(const TrochoidParams& params) {
  return {{Segment::arc({}, half_room(params), -kPi / 2, kPi)}, 0};
}

// The same shape, as wide as another slot.
SlotFront scaled(const SlotFront& front, double scale) {
  SlotFront result;
  for (const Segment& move : front.way)
    result.way.push_back(move.is_arc() ? Segment::arc(scale * move.centre, scale * move.radius,
                                                      move.start_angle, move.sweep)
                                       : Segment::line(scale * move.a, scale * move.b));
  result.step = scale * front.step;
  return result;
}

// The same with the greatest step, and the link back; nothing where there is none.
std::optional<RepeatedPattern> finished(const TrochoidPattern& shape, const TrochoidParams& params,
                                        const StepGuess& guess) {
  std::optional<RepeatedPattern> pattern = with_greatest_step(
      [&](double step) {
        TrochoidPattern repeated = shape;
        repeated.step = step;
        repeated.link.clear();
        return repeated;
      },
      params, guess);
  return pattern && pattern->link_back() ? std::move(pattern) : std::nullopt;
}

struct SettledPattern {
  RepeatedPattern pattern;
  SlotFront front;  // that it leaves
  StepGuess guess;  // of its greatest step
};

// From `front` on. Patterns with the step that they are sure to keep can be told apart; where that
// does not keep the limit, with the greatest one.
std::optional<SettledPattern> settled_pattern(const TrochoidParams& params, double turn_radius,
                                              Steps steps, const SlotFront& front) {
  Passes passes(params, turn_radius, steps, front);
  if (!passes.can_turn()) return std::nullopt;
  const PassSequence sequence = iterate(passes, params, kMostPasses);
  if (sequence.residuals.empty() || sequence.advance <= 0) return std::nullopt;
  const std::vector<Segment>& last = sequence.passes.back();
  const SlotFront left{placed(last, place_along(params.curvature, -passes.along(last.front().a))),
                       sequence.advance};
  const StepGuess guess{kLikelyStep * sequence.advance, kStepRoom * sequence.advance};
  TrochoidPattern shape = pattern_of(sequence, passes, params);
  shape.turn_radius = turn_radius;
  shape.step = kSureStep * sequence.advance;
  RepeatedPattern sure(shape, params);
  if (sure.keeps_limit() && sure.link_back()) return SettledPattern{std::move(sure), left, guess};
  std::optional<RepeatedPattern> pattern = finished(shape, params, guess);
  if (!pattern) return std::nullopt;
  return SettledPattern{std::move(*pattern), left, guess};
}

}  // namespace

PassSequence iterate_passes(const TrochoidParams& params, double turn_radius, int most) {
  check(params);
  Passes passes(params, turn_radius, Steps::kExact, round_front(params));
  return passes.can_turn() ? iterate(passes, params, most) : PassSequence{};
}

TurnSearch::TurnSearch(const TrochoidParams& params, const TurnSearch* like) : params_(params) {
  check(params);
  start_ = round_front(params);
  if (like && like->start_.step > 0)
    start_ = scaled(like->start_, half_room(params) / half_room(like->params_));
  const double least = std::min(kTightestTurn * params.tool_radius, 0.5 * half_room(params));
  const double roomy = std::min(kRoomyTurn * half_room(params), params.least_turn);
  for (const double times : kTurns) {
    const double radius = std::max(
        roomy, std::min({times * least, kWidestTurn * half_room(params), params.turn_radius}));
    if (radii_.empty() || radius > radii_.back()) radii_.push_back(radius);
    if (times <= kLikelyTurn) first_ = radii_.size() - 1;
  }
}

std::optional<TurnSearch::Settled> TurnSearch::settle(double radius, const SlotFront& start) const {
  // With next to no room to turn, steps come out as few or not at all.
  std::optional<SettledPattern> settled = settled_pattern(params_, radius, Steps::kExact, start);
  if (!settled) settled = settled_pattern(params_, radius, Steps::kFew, start);
  if (!settled) return std::nullopt;
  const TrochoidPattern& pattern = settled->pattern.pattern();
  return Settled{{pattern, settled->pattern.figures(), evenload::turns_at_corners(pattern.cut),
                  settled->guess},
                 settled->front};
}

const TurnSearch::Found* TurnSearch::take(std::size_t i, std::optional<Settled> settled) {
  std::optional<Found>& found = tried_[i];
  if (!settled) return nullptr;
  start_ = std::move(settled->front);
  found = std::move(settled->found);
  return &*found;
}

const TurnSearch::Found* TurnSearch::with_radius(std::size_t i) {
  const auto known = tried_.find(i);
  if (known != tried_.end()) return known->second ? &*known->second : nullptr;
  return take(i, settle(radii_[i], start_));
}

// The radii next to the first, of which one is always asked for, and mostly the other.
void TurnSearch::try_beside(std::size_t i) {
  if (i == 0 || i + 1 == radii_.size() || tried_.count(i - 1) || tried_.count(i + 1)) return;
  auto [above, below] = both([&] { return settle(radii_[i + 1], start_); },
                             [&] { return settle(radii_[i - 1], start_); }, params_.progress);
  take(i + 1, std::move(above));
  take(i - 1, std::move(below));
}

bool TurnSearch::is_better(const Found& a, const Found& b) {
  if (a.turns_at_corners != b.turns_at_corners) return b.turns_at_corners;
  // Of those about as fast the one that cuts least: edges last by the way that they cut.
  if (std::abs(a.figures.removal - b.figures.removal) < kSameRate * b.figures.removal)
    return a.figures.area_per_length > b.figures.area_per_length;
  return a.figures.removal > b.figures.removal;
}

const TurnSearch::Found* TurnSearch::first() {
  if (const Found* found = with_radius(first_)) return found;
  // Tighter turns fit more narrow rooms.
  for (std::size_t i = 0; i < radii_.size(); ++i)
    if (const Found* found = with_radius(i)) {
      first_ = i;
      return found;
    }
  return nullptr;
}

std::optional<TurnSearch::Found> TurnSearch::best() {
  const Found* const found = likely_best();
  if (!found) return std::nullopt;
  Found best = *found;
  if (const auto pattern = finished(best.pattern, params_, best.guess)) {
    best.pattern = pattern->pattern();
    best.figures = pattern->figures();
  }
  return best;
}

const TurnSearch::Found* TurnSearch::likely_best() {
  const Found* const start = first();
  const Found* best = start;
  if (best) try_beside(first_);
  // The removal rate rises to the best radius and falls beyond it.
  const auto go_to = [&](std::size_t i) {
    const Found* found = with_radius(i);
    if (!found) return false;
    const double most = best->figures.removal;
    if (is_better(*found, *best)) best = found;
    return found->figures.removal >= kWorthMore * most;
  };
  for (std::size_t i = first_; best && i-- > 0 && go_to(i);) continue;
  if (best && (best == start || best->turns_at_corners))
    for (std::size_t i = first_ + 1; i < radii_.size(); ++i)
      if (!go_to(i) && !best->turns_at_corners) break;
  return best;
}

std::optional<TrochoidPattern> constant_engagement_pattern(const TrochoidParams& params) {
  const std::optional<TurnSearch::Found> best = TurnSearch(params).best();
  return best ? std::optional(best->pattern) : std::nullopt;
}

}  // namespace evenload
