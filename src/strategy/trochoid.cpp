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
  abridged.unabridge = [&done, &spared, radius](std::vector<PlanarRun>& runs) {
    return unabridge(runs, done.cuts, done.repeated, radius, spared);
  };
  return abridged;
}

}  // namespace

TrochoidalPath clear_slot(const std::vector<Region>& regions, TrochoidKind kind,
                          const ClearingParams& params, Progress& progress) {
  std::optional<PatternCache> patterns;
  SlotsDone done;
  const RegionClearer clearer = [&](const RegionTask& task, const ClearingParams& checked,
                                    Progress& share) {
    if (!patterns) patterns.emplace(kind, checked);
    return clear_slots_of(task, checked, *patterns, done, share);
  };
  std::vector<SlotPiece> spared;
  const Abridge abridge = [&](const std::vector<Region>& whole, const std::vector<Region>& centres,
                              const ClearingParams& checked) {
    if (!patterns) patterns.emplace(kind, checked);
    return abridged_slots(whole, centres, checked, *patterns, spared, done);
  };
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    const std::size_t known = spared.size();
    if (std::optional<Toolpath> path =
            clear_abridged_by(clearer, abridge, regions, params, progress))
      return {std::move(*path), done.report};
    done = {};
    if (spared.size() == known) break;
  }
  Toolpath path = clear_by(clearer, regions, params, progress);
  return {std::move(path), done.report};
}

}  // namespace evenload
