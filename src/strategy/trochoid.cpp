#include "strategy/trochoid.h"

#include <optional>
#include <utility>

#include "strategy/abridged.h"
#include "strategy/pattern_cache.h"
#include "strategy/slot.h"
#include "strategy/slot_abridging.h"
#include "strategy/slot_unabridging.h"

namespace evenload {
namespace {

// So often is less taken out of slots, where something was found to be done there only once.
constexpr int kMostAttempts = 3;

// What is left of long slots, but for pieces that were found not to be worth it.
std::optional<Abridged> abridged_slots(const std::vector<Region>& regions,
                                       const std::vector<Region>& centres,
                                       const ClearingParams& params, PatternCache& patterns,
                                       std::vector<SlotPiece>& spared, SlotsDone& done) {
  Abridged abridged;
  abridged.entry_point = params.entry_point;
  const double radius = 0.5 * params.tool_diameter;
  done.cuts = cuts_of(
      regions, find_slots(Area(centres), (kWidestSlot - 1) * radius), spared, params,
      [&](const SlotStretch& stretch) { return patterns.pattern_of(stretch); },
      abridged.entry_point);
  if (done.cuts.empty()) return std::nullopt;
  abridged.regions = done.cuts.back().ground;
  abridged.whole_place = WholePlaces(done.cuts);
  abridged.unabridge = [&done, &spared, params](std::vector<PlanarRun>& runs,
                                                const RemovedByPeriod& removed) {
    return unabridge(runs, removed, done.cuts, done.repeated, params, spared);
  };
  return abridged;
}

}  // namespace

std::optional<TrochoidalPath> clear_abridged_slots(const std::vector<Region>& regions,
                                                   PatternCache& patterns,
                                                   const SlotClearer& clear_slots,
                                                   const ClearingParams& params,
                                                   Progress& progress) {
  std::vector<SlotPiece> spared;
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    SlotsDone done;
    const RegionClearer clearer = [&](const RegionTask& task, const ClearingParams& checked,
                                      Progress& share) {
      return clear_slots(task, checked, patterns, done, share);
    };
    const Abridge abridge = [&](const std::vector<Region>& whole,
                                const std::vector<Region>& centres, const ClearingParams& checked) {
      return abridged_slots(whole, centres, checked, patterns, spared, done);
    };
    const std::size_t known = spared.size();
    if (std::optional<Toolpath> path =
            clear_abridged_by(clearer, abridge, regions, params, progress))
      return TrochoidalPath{std::move(*path), done.report};
    if (spared.size() == known) break;
  }
  return std::nullopt;
}

TrochoidalPath clear_whole_slots(const std::vector<Region>& regions, PatternCache& patterns,
                                 const ClearingParams& params, Progress& progress) {
  SlotsDone done;
  const RegionClearer clearer = [&](const RegionTask& task, const ClearingParams& checked,
                                    Progress& share) {
    return clear_slots_of(task, checked, patterns, done, share);
  };
  Toolpath path = clear_by(clearer, regions, params, progress);
  return {std::move(path), done.report};
}

TrochoidalPath clear_slot(const std::vector<Region>& regions, TrochoidKind kind,
                          const ClearingParams& params, Progress& progress) {
  PatternCache patterns(kind, params, &progress);
  std::optional<TrochoidalPath> path =
      clear_abridged_slots(regions, patterns, clear_slots_of, params, progress);
  return path ? std::move(*path) : clear_whole_slots(regions, patterns, params, progress);
}

}  // namespace evenload
