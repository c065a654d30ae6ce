#include "strategy/slots/slot_end.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "strategy/reach/entry.h"
#include "strategy/slots/slot_rooms.h"
#include "support/both.h"
#include "support/errors.h"

namespace evenload {
namespace {

std::ptrdiff_t descents(const std::vector<PlanarRun>& runs) {
  return std::count_if(runs.begin(), runs.end(), [](const PlanarRun& run) {
    return run.descent.kind != DescentKind::kPlunge;
  });
}

// One run of the periods from the `first` on, the way back before each.
void add_periods(const Way& way, int first, Plan& plan) {
  for (int period = first; period >= 0; --period) {
    const std::vector<Segment> cut = cut_at(way, place_of(way, period));
    if (period < first)
      plan.add(MoveKind::kLink,
               placed(way.pattern.link, pose_on(way.stretch, place_of(way, period + 1))));
    else
      plan.plunge({cut.front().a, 0}, true);
    plan.add(MoveKind::kCut, cut);
  }
}

}  // namespace

std::optional<RegionResult> clear_part(const Plan& plan, const RegionTask& whole,
                                       const Region& part, const ClearingParams& params,
                                       Progress& progress) {
  RegionTask task = whole;
  task.centres = part;
  task.around = {whole.centres};
  task.is_part = true;
  task.stretch_helix = true;
  Plan grown = plan;
  try {
    clear_region(grown, task, params, progress);
  } catch (const GeometryError&) {
    return std::nullopt;
  }
  if (!plan.is_empty() && descents(grown.runs()) > descents(plan.runs())) return std::nullopt;
  return grown.take();
}

std::optional<Region> end_room(const Region& region, const Area& centres, const Way& way,
                               int last_period) {
  if (way.beside <= 0) return std::nullopt;
  const SlotStretch back = way.stretch.reversed();
  // Beyond the stretch a round end is narrower, and a front across it would meet it in corners.
  const double from =
      std::max(0.0, back.middle.length() - place_of(way, last_period) - way.reach.back);
  const std::vector<Segment> front = round_front(back, from);
  std::optional<Region> room = room_behind(region, centres, front);
  return room && is_end(*room, back, front) ? std::move(room) : std::nullopt;
}

std::unique_ptr<EarlyEnd> EarlyEnd::of(const RegionTask& task, const Area& centres, const Way& way,
                                       double from, const ClearingParams& passes) {
  const double reach = way.reach.ahead - way.reach.back + passes.tool_diameter;
  const int settled = static_cast<int>(std::ceil(reach / way.pattern.step)) + 1;
  if (place_of(way, settled) < from) return nullptr;
  std::optional<Region> room = end_room(task.centres, centres, way, 0);
  if (!room) return nullptr;
  return std::unique_ptr<EarlyEnd>(new EarlyEnd(task, way, passes, settled, std::move(*room)));
}

EarlyEnd::EarlyEnd(const RegionTask& task, const Way& way, const ClearingParams& passes,
                   int settled, Region room)
    : task_(task),
      way_(way),
      passes_(passes),
      settled_(settled),
      room_(std::move(room)),
      cut_([this](Progress& progress) { return cut(progress); }),
      result_(cut_.get_future()) {}

void EarlyEnd::clear(Progress& progress) {
  if (!is_begun_.test_and_set()) cut_(progress);
}

void EarlyEnd::clear() {
  Progress progress([this](double) { return is_wanted_.load(); });
  clear(progress);
}

std::optional<RegionResult> EarlyEnd::cut(Progress& progress) {
  if (!is_wanted_) return std::nullopt;
  Plan periods(task_, passes_, progress);
  try {
    add_periods(way_, settled_, periods);
  } catch (const Cancelled&) {
    return std::nullopt;
  }
  std::optional<RegionResult> grown = clear_part(periods, task_, room_, passes_, progress);
  if (grown) grown = since(periods.mark(), std::move(*grown));
  return grown;
}

std::optional<RegionResult> EarlyEnd::cleared(Progress& progress) {
  clear(progress);
  while (result_.wait_for(kPatience) != std::future_status::ready)
    if (!progress.report(1)) drop();  // the periods are made
  return result_.get();
}

EarlyEnds::EarlyEnds(std::vector<std::unique_ptr<EarlyEnd>> ends) : ends_(std::move(ends)) {
  if (ends_.empty()) return;
  clearing_ = std::async(std::launch::async, [this] {
    for (const std::unique_ptr<EarlyEnd>& end : ends_) end->clear();
  });
}

EarlyEnds::~EarlyEnds() {
  for (const std::unique_ptr<EarlyEnd>& end : ends_) end->drop();
}

EarlyEnd* EarlyEnds::of(const Way& way, int first) const {
  const auto end = std::find_if(
      ends_.begin(), ends_.end(),
      [&](const std::unique_ptr<EarlyEnd>& candidate) { return candidate->fits(way, first); });
  return end == ends_.end() ? nullptr : end->get();
}

}  // namespace evenload
