#include "simulate/simulate.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "simulate/load_figures.h"
#include "simulate/load_walk.h"

namespace evenload {
namespace {

// mm by which a part may reach out of its stock: rounding of drawings.
constexpr double kOutOfStock = 0.001;
// mm by which an arc's sweep may miss its end, and per mm of the arc: sweeps are computed from
// rounded coordinates.
constexpr double kSweepMismatch = 0.005;
// Share of the progress that is done when the moves are.
constexpr double kWalkShare = 0.95;

void require(bool holds, const std::string& sentence) {
  if (!holds) throw std::invalid_argument(sentence);
}

void check_params(const SimulationParams& params, const DexelStock& stock) {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
  require(positive(params.tool_diameter), "The tool's diameter must be positive, in mm.");
  require(params.teeth >= 1, "The tool must have at least one tooth.");
  require(std::isfinite(params.spindle_speed) && params.spindle_speed >= 0,
          "The spindle speed must not be negative, in rev/min.");
  require(positive(params.rapid_feed), "The rapid feed must be positive, in mm/min.");
  require(positive(params.step), "The step must be positive, in mm.");
  require(!params.force || params.spindle_speed > 0,
          "The force needs a spindle speed, in rev/min: give it with the cutting data.");
  require(stock.resolution() <= 0.5 * params.tool_diameter,
          "The resolution is coarser than the tool's radius: choose a finer one.");
  for (const Prism& prism : params.fixtures)
    require(std::isfinite(prism.top), "The fixture's top must be a number, in mm.");
  for (const Prism& prism : params.part) {
    require(std::isfinite(prism.top), "The part's top must be a number, in mm.");
    const Bounds box = bounds_of({prism.region}), around = stock.bounds();
    const double out =
        std::max({around.low.x - box.low.x, around.low.y - box.low.y, box.high.x - around.high.x,
                  box.high.y - around.high.y, prism.top - stock.top()});
    require(out <= kOutOfStock, "The stock does not contain the part: it reaches out by " +
                                    std::to_string(out) + " mm; enlarge the stock.");
  }
}

void check_moves(const std::vector<Move>& moves) {
  require(moves.size() > 1, "The path has no moves.");
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const Move& m = moves[i];
    const std::string name = "Move " + std::to_string(i);
    require(std::isfinite(m.x + m.y + m.z + m.sweep + m.cx + m.cy + m.feed),
            name + " has a number that is not finite.");
    if (i == 0) continue;
    require(m.kind == MoveKind::kRapid || m.feed > 0,
            name + " has no feed: give it one in mm/min.");
    if (m.sweep == 0) continue;
    const Vec2 centre{m.cx, m.cy};
    const double begin = distance({moves[i - 1].x, moves[i - 1].y}, centre);
    const double end = distance({m.x, m.y}, centre), off = std::abs(begin - end);
    require(begin > 0 && end > 0, name + " is an arc without radius.");
    const Vec2 turned = centre + rotated(Vec2{moves[i - 1].x, moves[i - 1].y} - centre, m.sweep);
    require(off <= kRadiusMismatch || off <= kRadiusMismatchShare * std::min(begin, end),
            name + " is an arc that starts " + std::to_string(begin) +
                " mm from its centre and ends " + std::to_string(end) +
                " mm from it: mend its centre.");
    require(distance(turned, {m.x, m.y}) <=
                off + kSweepMismatch * std::max(1.0, std::abs(m.sweep) * begin),
            name + " is an arc whose sweep does not lead to its end: mend one of them.");
  }
}

// The machine's time at every sample.
void append_machine_time(const std::vector<Move>& moves, const MachineProfile& machine,
                         LoadRecord& record) {
  const std::vector<MoveTime> times = machine_time(moves, machine);
  double s = 0;
  for (std::size_t i = 0; i < record.size(); ++i) {
    if (i > 0 && record.move[i] != record.move[i - 1]) s = 0;
    s += record.length[i];
    const MoveTime& move = times[static_cast<std::size_t>(record.move[i])];
    record.machine_time.push_back(move.start + time_at(move, s));
  }
}

}  // namespace

Simulation simulate(const std::vector<Move>& moves, DexelStock& stock,
                    const SimulationParams& params, Progress& progress) {
  check_params(params, stock);
  check_moves(moves);
  Simulation result;
  LoadWalk walk(stock, params, result, progress);
  const auto share_of = [&](std::size_t i) {
    return kWalkShare * static_cast<double>(i) / static_cast<double>(moves.size());
  };
  for (std::size_t i = 1; i < moves.size() && !result.cancelled; ++i)
    result.cancelled = !walk.add(moves[i - 1], moves[i], i, share_of(i), share_of(i + 1));
  walk.finish();
  if (params.machine) append_machine_time(moves, *params.machine, result.record);
  add_up_record(result.record, result.figures);
  if (params.find_rest && !result.cancelled)
    result.figures.rest = find_rest(stock, params.part, 0.5 * params.tool_diameter);
  progress.report(1);
  return result;
}

}  // namespace evenload
