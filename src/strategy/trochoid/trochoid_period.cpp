#include "strategy/trochoid/trochoid_period.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "cutting/load_budget.h"
#include "feed/feed_control.h"
#include "feed/load_profile.h"
#include "feed/load_share.h"
#include "strategy/moves/move_checks.h"
#include "strategy/moves/move_ends.h"
#include "strategy/places/area.h"
#include "strategy/reach/links.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

// mm between two looks at the load of a period.
constexpr double kPeriodLook = 0.1;
// Steps are found to this share of the tool's radius.
constexpr double kStepShare = 2e-4;
// Shares of half the room: turn radii of links that are tried at either end.
constexpr double kLinkTurns[] = {0.03, 0.05, 0.08, 0.13, 0.2, 0.35, 0.6, 0.9};
// The same where left turns alone do not lead back, beside their halves.
constexpr double kOtherTurns[] = {0.9, 0.6, 0.35};
// Widths of the slot: no such link is longer.
constexpr double kLongestLink = 4;
// Share of the tool's radius: a link turns no more tightly, but as the pattern itself does; and the
// share of the least turn that links may have.
constexpr double kTightestLink = 0.03;
constexpr double kHalfTurn = 0.5;
// mm: of a link's ends, along which it may graze.
constexpr double kLinkEnds = 0.06;
// rad: what is engaged by less cuts nothing.
constexpr double kNoContact = 1 * kPi / 180;
// Rounding.
constexpr double kNoLength = 1e-7;
// While steps are known to one side of the greatest alone: the share of the likely step by which
// the second differs from it, how much further each goes than the one before, and the share of the
// last that the next is at the least.
constexpr double kFirstJump = 0.005;
constexpr double kLongerJump = 4;
constexpr double kSmallerStep = 0.9;
// So many steps are tried at most where the overload is expected, before halving goes on.
constexpr int kMostInProportion = 8;
// Along a move for the circles that it touches, which it does beside walls as a rule.
constexpr int kCircleLooks = 200;
constexpr double kFar = std::numeric_limits<double>::infinity();

void require(bool condition, const char* sentence) {
  if (!condition) throw std::invalid_argument(sentence);
}

// mm along the middle to a place of the strip near the origin.
double along(double curvature, Vec2 p) {
  if (curvature == 0) return p.x;
  const Vec2 v = p - Vec2{0, 1 / curvature};
  return wrap_signed(angle_of(v) + (curvature > 0 ? kPi / 2 : -kPi / 2)) / curvature;
}

// mm along the middle to the place whose circle of `radius` mm reaches `p` with its front half, or
// to the place beside `p` where `p` lies too far aside.
double circle_place(double curvature, Vec2 p, double radius) {
  if (curvature == 0) return p.x - std::sqrt(std::max(0.0, radius * radius - p.y * p.y));
  const double bend = 1 / std::abs(curvature), to_centre = norm(p - Vec2{0, 1 / curvature});
  const double cosine =
      (to_centre * to_centre + bend * bend - radius * radius) / (2 * to_centre * bend);
  return along(curvature, p) - bend * std::acos(std::min(1.0, cosine));
}

// A step that was tried.
struct Tried {
  double step = 0, overload = 0;
};

// The step to be tried between one that keeps the limit and one that does not: where the overload
// would vanish if it grew in proportion, a little towards the end that was not tried last, so that
// both come near.
double step_between(const Tried& kept, const Tried& too_long, bool last_kept, double exact) {
  const double share = kept.overload / (kept.overload - too_long.overload);
  const double step = kept.step + share * (too_long.step - kept.step);
  return std::clamp(step + (last_kept ? 0.5 : -0.5) * exact, kept.step + 0.4 * exact,
                    too_long.step - 0.4 * exact);
}

// min, of a period, its feeds set as those of every path.
double time_of(std::vector<PlanarRun> runs, std::vector<LoadSample> profile,
               const std::vector<Segment>& link, const TrochoidParams& params) {
  for (const Segment& segment : link) {
    profile.push_back({0, runs[0].moves.size(), 0.5, segment.length(), 0, 0, 0, 0});
    PlanarMove move;
    move.kind = MoveKind::kLink;
    move.segment = segment;
    runs[0].moves.push_back(move);
  }
  const FeedParams feeds{params.feed, params.maximum_feed, params.link_feed, kSlotFeedSteps,
                         kMeanLength};
  if (params.maximum_feed > params.feed)
    set_constant_load(runs, profile, feeds);
  else
    set_constant_feed(runs, feeds);
  double time = 0;
  for (const PlanarMove& move : runs[0].moves) time += move.segment.length() / move.feed;
  return time;
}

// Left turn, straight on, left turn, by radii of their own. Empty where there is no such way.
std::vector<Segment> left_turns(const Pose& from, const Pose& to, double first, double second) {
  const Vec2 one = from.p + first * left_normal(unit(from.heading)),
             two = to.p + second * left_normal(unit(to.heading)), d = two - one;
  if (norm(d) <= std::abs(second - first)) return {};
  const double heading = angle_of(d) - std::asin((second - first) / norm(d));
  const double turned = wrap_positive(heading - from.heading),
               left = wrap_positive(to.heading - heading);
  if (turned + left > 2 * kPi - kNoLength) return {};
  std::vector<Segment> moves;
  if (turned > kNoLength) moves.push_back(Segment::arc(one, first, from.heading - kPi / 2, turned));
  const Vec2 a = one - first * left_normal(unit(heading)),
             b = two - second * left_normal(unit(heading));
  if (distance(a, b) > kNoLength) moves.push_back(Segment::line(a, b));
  if (left > kNoLength) moves.push_back(Segment::arc(two, second, heading - kPi / 2, left));
  return moves;
}

}  // namespace

double most_engagement(const TrochoidParams& params) {
  return params.engagement + load_budget::pattern(params.engagement);
}

double half_room(const TrochoidParams& params) { return 0.5 * params.width - params.tool_radius; }

void check(const TrochoidParams& p) {
  for (const double number : {p.tool_radius, p.width, p.curvature, p.engagement, p.turn_radius,
                              p.feed, p.maximum_feed, p.link_feed})
    require(std::isfinite(number), "Every parameter of a trochoid must be a finite number.");
  require(p.tool_radius > 0, "The tool's diameter must be positive.");
  require(p.width > 2 * p.tool_radius,
          "The slot is no wider than the tool: take a smaller tool, or a wider slot.");
  require(p.engagement > 0 && p.engagement < kPi,
          "The engagement angle must lie between 0 and 180 degrees.");
  require(p.turn_radius > 0, "The roll radius must be positive.");
  require(p.feed > 0 && p.link_feed > 0, "Feeds must be positive.");
  require(p.maximum_feed >= p.feed, "The maximum feed must not be below the feed.");
  require(std::abs(p.curvature) * 0.5 * p.width < 1,
          "The slot bends more tightly than half its width: make it narrower, or bend it less.");
}

Pose place_along(double curvature, double s) {
  if (curvature == 0) return {{s, 0}, 0};
  const double turned = s * curvature;
  return {Vec2{std::sin(turned), 1 - std::cos(turned)} / curvature, turned};
}

Segment placed(const Segment& move, const Pose& at) {
  const auto there = [&](Vec2 p) { return at.p + rotated(p, at.heading); };
  if (!move.is_arc()) return Segment::line(there(move.a), there(move.b));
  return Segment::arc(there(move.centre), move.radius, move.start_angle + at.heading, move.sweep);
}

std::vector<Segment> placed(const std::vector<Segment>& moves, const Pose& at) {
  std::vector<Segment> result;
  result.reserve(moves.size());
  for (const Segment& move : moves) result.push_back(placed(move, at));
  return result;
}

Region strip_of(const TrochoidParams& params, double back, double ahead) {
  const double h = half_room(params), sweep = params.curvature * (back + ahead);
  const double bulge = std::tan(sweep / 4);
  const auto corner = [&](double s, double aside) {
    const Pose at = place_along(params.curvature, s);
    return at.p + aside * left_normal(unit(at.heading));
  };
  return make_region(Curve({{corner(-back, -h), bulge},
                            {corner(ahead, -h), 0},
                            {corner(ahead, h), -bulge},
                            {corner(-back, h), 0}},
                           true));
}

PeriodReach reach_of(const TrochoidPattern& pattern) {
  PeriodReach reach{kFar, -kFar};
  for (const Segment& move : pattern.cut)
    for (int i = 0; i <= kMoveLooks; ++i) {
      const double s = along(pattern.curvature, move.point(static_cast<double>(i) / kMoveLooks));
      reach.back = std::min(reach.back, s);
      reach.ahead = std::max(reach.ahead, s);
    }
  return reach;
}

CirclesThrough circles_through(const TrochoidPattern& pattern, double radius) {
  CirclesThrough through{kFar, -kFar};
  for (const Segment& move : pattern.cut)
    for (int i = 0; i <= kCircleLooks; ++i) {
      const Vec2 p = move.point(static_cast<double>(i) / kCircleLooks);
      const double place = circle_place(pattern.curvature, p, radius);
      if (place < along(pattern.curvature, p)) through.first = std::min(through.first, place);
      through.last = std::max(through.last, place);
    }
  return through;
}

bool turns_at_corners(const std::vector<Segment>& moves) {
  return std::any_of(moves.begin(), moves.end(), is_tight);
}

RepeatedPattern::RepeatedPattern(TrochoidPattern pattern, const TrochoidParams& params)
    : pattern_(std::move(pattern)),
      params_(params),
      reach_(reach_of(pattern_)),
      periods_(static_cast<int>(
          std::ceil((reach_.ahead - reach_.back + 2 * params.tool_radius) / pattern_.step))),
      ground_(bounds(), params.tool_radius, nullptr),
      runs_(1) {
  if (params.progress) ground_.tell(*params.progress);
  for (int k = periods_; k > 0; --k) {
    const Pose at = place_along(pattern_.curvature, -k * pattern_.step);
    for (const Segment& move : placed(pattern_.cut, at)) ground_.add(move);
    for (const Segment& move : placed(pattern_.link, at)) ground_.add(move);
  }
  for (const Segment& move : pattern_.cut) {
    PlanarMove planar;
    planar.segment = move;
    runs_[0].moves.push_back(planar);
  }
  profile_ =
      load_profile(runs_, ground_, kPeriodLook,
                   removal_rate_share(params.engagement, params.tool_radius), params.progress);
}

Bounds RepeatedPattern::bounds() const {
  const double r = params_.tool_radius, beside = 0.5 * params_.width;
  if (pattern_.curvature == 0) return {{-behind() - r, -beside}, {ahead() + r, beside}};
  const double out = 1 / std::abs(pattern_.curvature) + beside;
  const Vec2 centre{0, 1 / pattern_.curvature};
  return {centre - Vec2{out, out}, centre + Vec2{out, out}};
}

double RepeatedPattern::overload() const {
  return worst_engagement(runs_, profile_, kMeanLength) - most_engagement(params_);
}

PatternFigures RepeatedPattern::figures() const {
  PatternFigures figures;
  double within = 0, met = 0;
  for (const LoadSample& sample : profile_) {
    if (std::abs(sample.engagement - params_.engagement) <= kBand) within += sample.length;
    if (sample.engagement > kNoContact) met += sample.length;
  }
  figures.cut_length = length_of(pattern_.cut);
  figures.link_length = length_of(pattern_.link);
  figures.area_per_length = params_.width * pattern_.step / met;
  figures.max_engagement = worst_engagement(runs_, profile_, kMeanLength);
  figures.within = within / figures.cut_length;
  figures.time = time_of(runs_, profile_, pattern_.link, params_);
  figures.removal = params_.width * pattern_.step / figures.time;
  return figures;
}

PatternFigures figures_of(const TrochoidPattern& pattern, const TrochoidParams& params) {
  return RepeatedPattern(pattern, params).figures();
}

std::optional<RepeatedPattern> with_greatest_step(
    const std::function<TrochoidPattern(double step)>& of_step, const TrochoidParams& params,
    const StepGuess& guess) {
  const double exact = kStepShare * params.tool_radius;
  std::optional<RepeatedPattern> best;
  Tried low, high{guess.most, 0};
  bool is_high_tried = false;
  double step = guess.likely, jump = kFirstJump * guess.likely;
  for (int tries = 1; step > exact && high.step - low.step > exact; ++tries, jump *= kLongerJump) {
    RepeatedPattern pattern(of_step(step), params);
    const Tried tried{step, pattern.overload()};
    const bool keeps = tried.overload <= 0;
    (keeps ? low : high) = tried;
    if (keeps)
      best = std::move(pattern);
    else
      is_high_tried = true;
    if (!best)
      step = std::max(kSmallerStep * high.step, high.step - jump);
    else if (!is_high_tried)
      step = std::min(guess.most, low.step + jump);
    else if (tries < kMostInProportion && high.overload > low.overload)
      step = step_between(low, high, keeps, exact);
    else
      step = 0.5 * (low.step + high.step);
  }
  return best;
}

bool RepeatedPattern::link_back() {
  pattern_.link = shortest_return();
  return !pattern_.link.empty();
}

std::vector<Segment> RepeatedPattern::shortest_return() const {
  const Area centres({strip_of(params_, behind(), ahead())});
  const Segment &first = pattern_.cut.front(), &last = pattern_.cut.back();
  const Segment next = placed(first, place_along(pattern_.curvature, pattern_.step));
  const Pose from{last.b, angle_of(last.tangent(1))}, to{next.a, angle_of(next.tangent(0))};
  const double h = half_room(params_), turn = pattern_.turn_radius,
               least = std::max(std::min(kTightestLink * params_.tool_radius, turn),
                                kHalfTurn * std::min(params_.least_turn, turn));
  std::vector<std::vector<Segment>> ways;
  for (const double one : kLinkTurns)
    for (const double other : kLinkTurns) {
      if (std::min(one, other) * h < least) continue;
      std::vector<Segment> way = left_turns(from, to, one * h, other * h);
      if (!way.empty()) ways.push_back(std::move(way));
    }
  // Those that posts would turn into corners last.
  std::stable_sort(ways.begin(), ways.end(), [](const auto& a, const auto& b) {
    return std::pair(turns_at_corners(a), length_of(a)) <
           std::pair(turns_at_corners(b), length_of(b));
  });
  for (const std::vector<Segment>& way : ways)
    if (is_free({ground_, ground_.size()}, centres, way, kLinkEnds)) return way;
  // Where the last turn has gone beyond the way back, right turns as well.
  std::vector<Segment> best;
  for (const double share : kOtherTurns) {
    std::vector<Segment> way = shortest_link({ground_, ground_.size()}, centres, from, to,
                                             share * h, kLongestLink * params_.width);
    if (!way.empty() && (best.empty() || length_of(way) < length_of(best))) best = std::move(way);
  }
  return best;
}

}  // namespace evenload
