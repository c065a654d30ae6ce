#include "strategy/lame/lame_turns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cutting/engagement.h"
#include "cutting/load_budget.h"
#include "cutting/probe.h"
#include "support/tolerances.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

constexpr int kBands = 24;                      // of the growth that are corrected by themselves
constexpr int kBandsOfPiece = 3;                // the same to each piece of its courses, at least
constexpr int kMostRounds = 6;                  // of corrections
constexpr int kMostRoundsOfCourses = 12;        // where courses may be steep
constexpr int kWideningRounds = 1;              // of them may widen steps, too
constexpr double kWiden = 1.15, kNarrow = 0.6;  // a correction is no larger than these
constexpr double kCoarse = 3;                   // so much more coarsely the first round looks

constexpr double kLook = 0.4;            // tool radii between two looks, at most
constexpr double kSure = 0.06;           // the same where the stock may have corners
constexpr double kClosest = 0.01;        // and at least
constexpr double kJump = 1 * kPi / 180;  // rad from one to the next: closer ones, then

// rad: what the tool meets was cut no longer ago than the first, and no later than the second.
constexpr double kLongestAgo = 2.5 * kPi, kLatestAgo = 1.5 * kPi;
// Tolerances by which a spiral turns off its last curve: arcs of two turns on it leave so little
// that the tool would stop in a cut of a degree.
constexpr double kOff = 4;

struct Look {
  double share;       // of the growth
  double engagement;  // rad
};

// Looks along the arcs of a spiral, each in what those before it have cleared.
class Looks {
 public:
  // `sure`: tool radii between looks where the stock may have corners, at most.
  Looks(const LameSpiral& spiral, const LameArcs& arcs, const TurnTask& task, double sure,
        const ClearedGround& before)
      : ground_(before),
        closer_from_(0.5 * task.engagement),
        aim_(task.engagement - load_budget::kSpiralAim),
        sure_(sure),
        from_outside_(task.inwards) {
    // Where one arc goes over into the next it meets what the one before met there.
    double turned = 0, last = engaged(arcs.moves.front(), 0);
    for (std::size_t i = 0; i < arcs.moves.size(); ++i) {
      const Segment& move = arcs.moves[i];
      const auto share = [&](double t) {
        return spiral.share.value(turned + t * (arcs.turned[i] - turned));
      };
      smooth_.push_back(is_smooth(turned, arcs.turned[i]));
      is_whole_ = true;
      const int count = looks_along(move.length(), kLook * ground_.tool_radius());
      for (int k = 1; k <= count; ++k) {
        const double from = static_cast<double>(k - 1) / count, to = static_cast<double>(k) / count;
        const double here = engaged(move, to);
        found_.push_back({share(to), std::max(here, between(move, from, last, to, here))});
        last = here;
      }
      ground_.add(move);
      turned = arcs.turned[i];
      if (!is_whole_) partly_.push_back(turned);
    }
    // From outside, arcs tighter than the tool leave cusps.
    const auto is_tight = [&](const Segment& move) {
      return move.is_arc() && move.radius <= ground_.tool_radius();
    };
    if (from_outside_ && std::any_of(arcs.moves.begin(), arcs.moves.end(), is_tight))
      smooth_.assign(smooth_.size(), false);
  }

  Looks(const Looks&) = delete;  // probe_ looks at this one's ground

  const std::vector<Look>& found() const { return found_; }

 private:
  bool is_smooth(double from, double to) const {
    const auto bad = std::lower_bound(partly_.begin(), partly_.end(), from - kLongestAgo);
    return from >= kLongestAgo && (bad == partly_.end() || *bad > to - kLatestAgo);
  }

  double engaged(const Segment& move, double t) {
    const double heading = angle_of(move.tangent(t));
    const std::vector<AngularInterval>& arcs = probe_.arcs(move.point(t), heading, kCoverTolerance);
    is_whole_ = is_whole_ && !arcs.empty() && arcs.front().low < heading - kPi / 2 + kSame;
    double sum = 0;
    for (const AngularInterval& part : arcs) sum += part.width();
    return sum;
  }

  // The most between two looks: closer ones where a peak may hide there, since it changes fast or
  // edges of the stock are met.
  double between(const Segment& move, double from, double e_from, double to, double e_to) {
    const double most = std::max(e_from, e_to), change = std::abs(e_to - e_from);
    const double length = (to - from) * move.length() / ground_.tool_radius();
    const double sure = from_outside_ && !smooth_.back() ? sure_ : kLook;
    const bool even = length <= sure && change < kJump;
    // A peak between them stands no higher above both than they differ.
    const bool low = most < closer_from_ || (length <= sure && most + change < aim_);
    if (low || even || length < kClosest) return most;
    const double middle = 0.5 * (from + to), here = engaged(move, middle);
    return std::max(
        {here, between(move, from, e_from, middle, here), between(move, middle, here, to, e_to)});
  }

  ClearedGround ground_;  // a copy, which is sooner thrown away than taken back move by move
  double closer_from_;    // rad
  double aim_;            // rad
  double sure_;           // tool radii
  bool from_outside_;
  bool is_whole_ = true;        // the engagement with the tool's side, along the arc looked at
  std::vector<double> partly_;  // rad turned: arcs where it is not
  // Of each arc: whether it meets only what was cut with the tool's side, so that no corner of the
  // cleared ground is at an edge of the stock.
  std::vector<bool> smooth_;
  std::vector<Look> found_;
  Probe probe_{ground_};
};

int bands_of(const LameGrowth& growth) {
  return std::max(kBands, kBandsOfPiece * static_cast<int>(growth.courses().pieces()));
}

// The steps times what the looks within a turn of them ask for.
MonotoneSpline corrected(const MonotoneSpline& steps, const std::vector<Look>& looks,
                         const TurnTask& task, double most, int bands) {
  const double aim =
      1 - std::cos(std::max(0.5 * task.engagement, task.engagement - load_budget::kSpiralAim));
  std::vector<double> shares, factors(bands + 1, most), values;
  for (const Look& look : looks) {
    const double factor =
        std::clamp(aim / std::max(1e-9, 1 - std::cos(look.engagement)), kNarrow, most);
    const double reach = steps.value(look.share) + 1.0 / bands;
    const int low = std::max(0, static_cast<int>(std::ceil((look.share - reach) * bands)));
    const int high =
        std::min(bands, static_cast<int>(std::floor((look.share + 1.0 / bands) * bands)));
    for (int i = low; i <= high; ++i) factors[i] = std::min(factors[i], factor);
  }
  for (int i = 0; i <= bands; ++i) {
    shares.push_back(static_cast<double>(i) / bands);
    values.push_back(steps.value(shares.back()) * factors[i]);
  }
  return MonotoneSpline(std::move(shares), std::move(values));
}

MonotoneSpline limited(const MonotoneSpline& steps, const LameGrowth& growth, double pitch) {
  const int bands = bands_of(growth);
  std::vector<double> shares, values;
  for (int i = 0; i <= bands; ++i) {
    shares.push_back(static_cast<double>(i) / bands);
    values.push_back(std::min(growth.step_of(shares.back(), pitch), steps.value(shares.back())));
  }
  return MonotoneSpline(std::move(shares), std::move(values));
}

struct Range {
  double least = std::numeric_limits<double>::infinity(), most = 0;  // mm
};

// Of the pitch.
Range range_of(const MonotoneSpline& steps, const LameGrowth& growth) {
  const int bands = bands_of(growth);
  Range range;
  for (int i = 0; i <= bands; ++i) {
    const double share = static_cast<double>(i) / bands;
    const double pitch = growth.change(share, steps.value(share));
    range.least = std::min(range.least, pitch);
    range.most = std::max(range.most, pitch);
  }
  return range;
}

}  // namespace

LameTurns turns_of(const PlannedGrowth& planned, const TurnTask& task, double start,
                   double tolerance, const ClearedGround& ground) {
  const LameGrowth& growth = planned.growth;
  MonotoneSpline steps = planned.steps;
  LameTurns best;
  const int rounds = growth.courses().any() ? kMostRoundsOfCourses : kMostRounds;
  for (int round = 0; round < rounds; ++round) {
    if (task.pitch) steps = limited(steps, growth, *task.pitch);
    LameSpiral spiral = spiral_of(growth, steps, start, task.inwards, kOff * tolerance, task.pitch);
    // The first arcs are never cut.
    const double coarse = round == 0 ? kCoarse : 1;
    LameArcs arcs = arcs_of(spiral, coarse * tolerance);
    const Looks looks(spiral, arcs, task, coarse * kSure, ground);
    double most = 0;
    for (const Look& look : looks.found()) most = std::max(most, look.engagement);
    const bool good = most <= task.engagement + load_budget::kSpiral;
    if (round <= kWideningRounds || good || most < best.engagement) {
      const Range range = range_of(steps, growth);
      best = {std::move(spiral), std::move(arcs.moves), most, range.least, range.most};
    }
    if (good && round >= kWideningRounds) break;
    steps = corrected(steps, looks.found(), task, round < kWideningRounds ? kWiden : 1,
                      bands_of(growth));
  }
  return best;
}

}  // namespace evenload
