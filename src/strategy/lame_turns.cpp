#include "strategy/lame_turns.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cutting/engagement.h"

namespace evenload {
namespace {

constexpr int kBands = 24;                     // of the growth that are corrected by themselves
constexpr int kMostRounds = 6;                 // of corrections
constexpr int kWideningRounds = 2;             // of them may widen steps, too
constexpr double kWiden = 1.1, kNarrow = 0.6;  // a correction is no larger than these
// rad: what is aimed at lies so far below the limit.
constexpr double kAim = 0.2 * kPi / 180;

struct Look {
  double share;       // of the growth
  double engagement;  // rad
};

// Looks along the arcs, each in what those before it have cleared.
std::vector<Look> looks_along(const LameSpiral& spiral, const LameArcs& arcs,
                              ClearedGround& ground) {
  std::vector<Look> looks;
  std::vector<AngularInterval> engaged;
  const std::size_t before = ground.size();
  double turned = 0;
  for (std::size_t i = 0; i < arcs.moves.size(); ++i) {
    const Segment& move = arcs.moves[i];
    for (const double t : {0.5, 1.0}) {
      const double heading = angle_of(move.tangent(t));
      // The arc itself has cleared nothing ahead of its own end.
      if (t == 1) ground.add(move);
      ground.uncovered(move.point(t), heading - kPi / 2, heading + kPi / 2, engaged);
      double sum = 0;
      for (const AngularInterval& part : engaged) sum += part.high - part.low;
      const double share = spiral.share.value(turned + t * (arcs.turned[i] - turned));
      looks.push_back({share, sum});
    }
    turned = arcs.turned[i];
  }
  while (ground.size() > before) ground.remove_last();
  return looks;
}

// The steps times what the looks within a turn of them ask for.
MonotoneSpline corrected(const MonotoneSpline& steps, const std::vector<Look>& looks,
                         const TurnTask& task, double most) {
  const double aim = 1 - std::cos(std::max(0.5 * task.engagement, task.engagement - kAim));
  std::vector<double> shares, factors(kBands + 1, most), values;
  for (const Look& look : looks) {
    const double factor =
        std::clamp(aim / std::max(1e-9, 1 - std::cos(look.engagement)), kNarrow, most);
    const double reach = steps.value(look.share) + 1.0 / kBands;
    const int low = std::max(0, static_cast<int>(std::ceil((look.share - reach) * kBands)));
    const int high =
        std::min(kBands, static_cast<int>(std::floor((look.share + 1.0 / kBands) * kBands)));
    for (int i = low; i <= high; ++i) factors[i] = std::min(factors[i], factor);
  }
  for (int i = 0; i <= kBands; ++i) {
    shares.push_back(static_cast<double>(i) / kBands);
    values.push_back(steps.value(shares.back()) * factors[i]);
  }
  return MonotoneSpline(std::move(shares), std::move(values));
}

MonotoneSpline limited(const MonotoneSpline& steps, double most) {
  std::vector<double> shares, values;
  for (int i = 0; i <= kBands; ++i) {
    shares.push_back(static_cast<double>(i) / kBands);
    values.push_back(std::min(most, steps.value(shares.back())));
  }
  return MonotoneSpline(std::move(shares), std::move(values));
}

struct Range {
  double least = 1, most = 0;
};

Range range_of(const MonotoneSpline& steps) {
  Range range;
  for (int i = 0; i <= kBands; ++i) {
    const double step = steps.value(static_cast<double>(i) / kBands);
    range.least = std::min(range.least, step);
    range.most = std::max(range.most, step);
  }
  return range;
}

}  // namespace

LameTurns turns_of(const LameGrowth& growth, const TurnTask& task, double start, double tolerance,
                   ClearedGround& ground) {
  MonotoneSpline steps = largest_steps(growth, task);
  LameTurns best;
  for (int round = 0; round < kMostRounds; ++round) {
    if (task.pitch) steps = limited(steps, *task.pitch / growth.length());
    LameSpiral spiral = spiral_of(growth, steps, start, task.inwards);
    LameArcs arcs = arcs_of(spiral, tolerance);
    const std::vector<Look> looks = looks_along(spiral, arcs, ground);
    double most = 0;
    for (const Look& look : looks) most = std::max(most, look.engagement);
    const bool good = most <= task.engagement + kTurnTolerance;
    if (round == 0 || good || most < best.engagement) {
      const Range range = range_of(steps);
      best = {std::move(spiral), std::move(arcs.moves), most, range.least * growth.length(),
              range.most * growth.length()};
    }
    if (good && round >= kWideningRounds) break;
    steps = corrected(steps, looks, task, round < kWideningRounds ? kWiden : 1);
  }
  return best;
}

}  // namespace evenload
