#include "strategy/pocket/pocket.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cutting/engagement.h"
#include "cutting/load_budget.h"
#include "feed/feed_limit.h"
#include "feed/following_profile.h"
#include "feed/load_profile.h"
#include "geometry/fine_corners.h"
#include "geometry/medial_axis.h"
#include "geometry/sharp_tips.h"
#include "strategy/moves/move_checks.h"
#include "strategy/passage/passage_clearing.h"
#include "strategy/passage/passage_report.h"
#include "strategy/places/allowed_ground.h"
#include "strategy/pocket/feeds.h"
#include "strategy/reach/entry.h"
#include "strategy/reach/entry_feeds.h"
#include "strategy/task/mirror.h"
#include "support/errors.h"
#include "toolpath/helix.h"
#include "toolpath/ramp.h"

namespace evenload {
namespace {

// mm of path between two looks at the load where it does not change, from kEvenAngle on; below, in
// proportion: where the front has a cusp, a degree more for a tenth of a millimetre is met, which
// is a larger part of a smaller angle.
constexpr double kLoadSpacing = 0.3;
constexpr double kEvenAngle = kPi / 3;
// Of the tolerance: what round walls drawn as many lines may be cut short by, for arcs.
constexpr double kFineShare = 0.4;

void require(bool condition, const char* sentence) {
  if (!condition) throw std::invalid_argument(sentence);
}

void check(const ClearingParams& p) {
  // Comparisons written so that NaN fails them.
  for (const double number :
       {p.tool_diameter,  p.engagement_angle, p.feed,           p.plunge_feed,
        p.link_feed,      p.maximum_feed,     p.rapid_feed,     p.roll_radius,
        p.minimum_radius, p.helix_angle,      p.helix_diameter, p.hole_diameter,
        p.stock_to_leave, p.tolerance,        p.link_lift,      p.top,
        p.safe_height,    p.clearance_height, p.spindle_speed,  p.most_blocks_per_metre})
    require(std::isfinite(number), "Every parameter must be a finite number.");
  for (const double level : p.levels)
    require(std::isfinite(level), "Every level must be a finite number.");
  if (p.open_side)
    require(std::isfinite(p.open_side->x) && std::isfinite(p.open_side->y),
            "The place near the open side must be finite numbers.");
  if (p.entry_point)
    require(std::isfinite(p.entry_point->x) && std::isfinite(p.entry_point->y),
            "The entry point must be finite.");
  require(p.tool_diameter > 0 && p.tool_diameter < 1e4, "The tool's diameter must be positive.");
  require(p.engagement_angle > 0 && p.engagement_angle < kPi,
          "The engagement angle must lie between 0 and 180 degrees.");
  require(p.feed > 0, "The feed must be positive: set the tool controller's horizontal feed.");
  require(p.plunge_feed > 0,
          "The plunge feed must be positive: set the tool controller's vertical feed.");
  require(p.link_feed > 0, "The link feed must be positive.");
  require(p.rapid_feed > 0, "The rapid feed must be positive.");
  require(p.maximum_feed >= p.feed, "The maximum feed must not be below the feed.");
  require(p.least_load >= 0 && p.least_load <= kMostLeastLoad,
          "The least load must lie between 0 and 0.95 of the nominal one.");
  require(p.most_blocks_per_metre >= 0, "The most blocks per metre must not be negative.");
  require(p.roll_radius > 0, "The roll radius must be positive.");
  require(p.minimum_radius > 0, "The minimum radius must be positive.");
  require(p.helix_angle > 0 && p.helix_angle < kPi / 2,
          "The helix angle must lie between 0 and 90 degrees.");
  require(p.helix_diameter > 0, "The helix diameter must be positive.");
  require(p.stock_to_leave >= 0, "The stock to leave must not be negative.");
  require(p.tolerance > 0, "The tolerance must be positive.");
  require(p.link_lift >= 0, "The link lift must not be negative.");
  require(!p.levels.empty(), "There must be at least one level.");
  double above = p.top;
  for (const double level : p.levels) {
    require(level < above, "The levels must descend from the top.");
    above = level;
  }
  require(p.safe_height >= p.top, "The safe height must not lie below the start depth.");
  require(p.clearance_height >= p.safe_height,
          "The clearance height must not lie below the safe height.");
  if (p.entry == EntryKind::kPredrilledHole) {
    require(p.entry_point.has_value(), "A pre-drilled hole needs its centre: set EntryPoint.");
    require(
        p.hole_diameter >= p.tool_diameter,
        "The pre-drilled hole is smaller than the tool: set HoleDiameter to at least the tool's "
        "diameter, or choose another entry.");
  }
}

// mm: a tool this much wider than the one asked for would just fit; rounded down to what can be
// printed.
double largest_fitting_tool(const std::vector<Region>& regions, const ClearingParams& params) {
  double widest = 0;  // of one region: what two of them share with their borders is not open
  for (const Region& region : regions) widest = std::max(widest, largest_tool({region}));
  const double width = widest - 2 * (params.stock_to_leave + kWallGap);
  return std::floor(width * 1000) / 1000;
}

// What is to be cleared, climb milling.
struct Work {
  std::vector<Region> regions;
  ClearingParams params;
};

std::vector<Region> places_of_tool(const std::vector<Region>& allowed,
                                   const ClearingParams& params) {
  return without_fine_corners(
      shrunk_to_tips(allowed, 0.5 * params.tool_diameter + params.stock_to_leave, kWallGap),
      kFineShare * params.tolerance);
}

// Connected places of the tool's centre that are cleared from one entry.
struct Part {
  Region centres;
  DividedRegion narrow;  // without passages unless they are to be cut at a reduced feed
  int first_passage = 0;
};

// What is to be cleared of the regions of tool centres; their narrow passages are added to
// `passages`.
std::vector<Part> parts_of(const std::vector<Region>& centres, const ClearingParams& params,
                           std::vector<PassageReport>& passages, Progress& progress) {
  std::vector<Part> parts;
  for (const Region& region : centres) {
    if (!progress.report(0)) break;
    const int first = static_cast<int>(passages.size());
    DividedRegion narrow;
    if (!params.stock || params.narrow_passages == NarrowPassages::kSkip)
      narrow = divide(region, params);
    for (PassageReport& report : reports_of(narrow, params)) passages.push_back(std::move(report));
    if (params.narrow_passages == NarrowPassages::kSkip)
      for (const Region& room : narrow.places.rooms) parts.push_back({room, {}, first});
    else
      parts.push_back({region, std::move(narrow), first});
  }
  return parts;
}

RegionResult clear_part(const RegionClearer& clearer, const Part& part, const RegionTask& task,
                        const ClearingParams& params, Progress& progress) {
  if (part.narrow.places.passages.empty()) return clearer(task, params, progress);
  return clear_with_passages(task, part.narrow.places, part.narrow.axes, part.first_passage, params,
                             progress);
}

// The part from which a pre-drilled hole is entered.
std::optional<Vec2> hole_place(const std::vector<Part>& parts, Vec2 hole, std::size_t* which) {
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i].centres.contains(hole)) {
      *which = i;
      return hole;
    }
  return std::nullopt;
}

// `work`: mirrored for conventional milling.
Toolpath clear(const RegionClearer& clearer, const Work& work, Progress& progress) {
  const std::vector<Region>& regions = work.regions;
  ClearingParams params = work.params;
  const bool mirror = params.cut_mode == CutMode::kConventional;
  const LoadShare share_of_nominal = load_share(params, mirror);  // refuses before the work
  const auto shown = [mirror](Vec2 p) { return mirror ? mirrored(p) : p; };

  const double radius = 0.5 * params.tool_diameter;
  Toolpath path;
  const std::vector<Region> allowed =
      allowed_ground(regions, params.tool_diameter, shown, path.report.findings);
  progress.report(0);
  const std::vector<Region> centres = places_of_tool(allowed, params);
  if (centres.empty())
    throw GeometryError(Refusal::kToolFitsNowhere, {},
                        {params.tool_diameter, largest_fitting_tool(regions, params)});

  if (regions.size() > 1)
    for (const Region& region : allowed)
      if (offset({region}, -(radius + params.stock_to_leave + kWallGap)).empty()) {
        const Bounds box = bounds_of({region});
        path.report.findings.push_back(
            {FindingCode::kPocketSkipped,
             shown(0.5 * (box.low + box.high)),
             {params.tool_diameter, largest_fitting_tool({region}, params)}});
        path.report.termination = Termination::kIncomplete;
      }

  const bool rest = params.stock.has_value();
  if (rest && params.narrow_passages == NarrowPassages::kReducedFeed) {
    params.narrow_passages = NarrowPassages::kTrochoid;
    path.report.findings.push_back({FindingCode::kRestByTrochoids});
  }
  std::vector<PassageReport> passages;
  const std::vector<Part> parts = parts_of(centres, params, passages, progress);
  std::size_t hole_region = parts.size();
  std::optional<Vec2> hole;
  if (!rest && (params.entry == EntryKind::kPredrilledHole ||
                (params.entry == EntryKind::kAutomatic && params.entry_point &&
                 params.hole_diameter >= params.tool_diameter))) {
    hole = hole_place(parts, *params.entry_point, &hole_region);
    const bool skipped = is_in_passage(*params.entry_point, passages);
    if (!hole && params.entry == EntryKind::kAutomatic)
      path.report.findings.push_back(
          {skipped ? FindingCode::kHoleInSkippedPassage : FindingCode::kHoleTooNearWall,
           shown(*params.entry_point)});
    if (!hole && params.entry == EntryKind::kPredrilledHole)
      throw GeometryError(skipped ? Refusal::kHoleInSkippedPassage : Refusal::kHoleOutOfReach,
                          shown(*params.entry_point));
  }

  if (rest && params.stock->empty()) return path;

  const bool open = has_open_edges(regions);
  if (rest) params.stock = bared(mirror ? mirrored(*params.stock) : *params.stock);
  const std::vector<Region>& material = rest ? *params.stock : regions;
  const int levels = static_cast<int>(params.levels.size());
  const Bounds bounds = bounds_of(centres);
  ClearedGround ground({bounds.low - Vec2{radius, radius}, bounds.high + Vec2{radius, radius}},
                       radius, open || rest ? &material : nullptr);
  if (hole) ground.add_disc(*hole, 0.5 * params.hole_diameter);
  FollowingProfile following(
      ground, kLoadSpacing * std::min(1.0, params.engagement_angle / kEvenAngle), share_of_nominal);
  TightTurns tight_turns;
  std::vector<PlanarRun> runs;
  for (std::size_t i = 0; i < parts.size() && !progress.cancelled(); ++i) {
    const Region& region = parts[i].centres;
    if (!rest && params.entry == EntryKind::kPredrilledHole && i != hole_region) {
      path.report.findings.push_back(
          {FindingCode::kRegionWithoutHole, shown(region.outer.vertices().front().p)});
      path.report.termination = Termination::kIncomplete;
      for (const Region& reached : offset({region}, radius))
        path.report.uncut_area += reached.area();
      continue;
    }
    if (hole && i != hole_region)
      path.report.findings.push_back(
          {FindingCode::kRegionWithOwnEntry, shown(region.outer.vertices().front().p)});
    RegionTask task;
    task.centres = region;
    task.material = material;
    task.has_open_edges = open;
    task.rest = rest;
    if (i == hole_region) task.hole = hole;
    task.mirrored = mirror;
    task.follow = [&following, first = runs.size()](const std::vector<PlanarRun>& made) {
      following.follow(made, first);
    };
    Progress share([&](double done) {
      return progress.report((static_cast<double>(i) + done) / static_cast<double>(parts.size()));
    });
    RegionResult result = clear_part(clearer, parts[i], task, params, share);
    path.report.uncut_area += result.uncut_area;
    path.report.passes += result.passes * levels;
    path.report.links += result.links * levels;
    tight_turns.add(result.tight_turns);
    for (Finding& found : result.findings) path.report.findings.push_back(std::move(found));
    for (PlanarRun& run : result.runs) runs.push_back(std::move(run));
  }

  if (const std::optional<Finding> tight =
          finding_of(tight_turns, std::max(params.roll_radius, params.minimum_radius)))
    path.report.findings.push_back(*tight);

  // Who cancels does not want to wait for feeds: constant ones, then.
  std::vector<LoadSample> profile;
  try {
    if (!progress.cancelled()) profile = following.finish(runs, progress);
  } catch (const Cancelled&) {
  }
  if (progress.cancelled()) following.stop();
  path.report.max_engagement = worst_engagement(runs, profile, kMeanLength);
  double removed = 0;
  for (const LoadSample& sample : profile) removed += sample.width * sample.length;

  const double width = side_step(params.engagement_angle, radius);
  // Constant removal rate keeps the limits of passages by itself, and more finely.
  if (params.feed_control != FeedControl::kConstantRemovalRate)
    find_feed_limits(runs, profile, params.feed, width);
  note_engagement(runs, profile, passages);
  try {
    set_feeds(runs, profile, params, shown, path.report, progress);
  } catch (const Cancelled&) {
    set_feeds(runs, {}, params, shown, path.report, progress);
  }
  apply_feed_limits(runs);
  note_feeds(runs, passages);
  if (!progress.cancelled()) tell(passages, ground, mirror, path.report);
  if (const std::optional<Finding> narrowed = narrowed_helix(runs, params))
    path.report.findings.push_back(*narrowed);

  const double depth = params.top - params.levels.back();
  for (const PlanarRun& run : runs) {
    if (run.descent.kind == DescentKind::kHelix)
      removed += run.descent.new_area.value_or(cleared_area(run.descent, radius));
    if (run.descent.kind == DescentKind::kRamp)
      removed += run.descent.new_area.value_or(ramp_area(run.descent, radius));
    for (const PlanarMove& move : run.moves)
      (move.kind == MoveKind::kLink ? path.report.link_length : path.report.cut_length) +=
          move.segment.length() * levels;
  }
  path.report.removed_volume = removed * depth;
  path.report.ideal_time =
      levels * removed / (side_step(params.engagement_angle, radius) * params.feed) * 60;

  if (mirror)
    for (PlanarRun& run : runs) mirror_run(run);
  AssemblyParams assembly;
  assembly.top = params.top;
  assembly.levels = params.levels;
  assembly.safe_height = params.safe_height;
  assembly.clearance_height = params.clearance_height;
  assembly.entry = entry_feeds(params);
  assembly.rapid_feed = params.rapid_feed;
  assembly.link_feed = params.link_feed;
  assembly.helix_angle = params.helix_angle;
  assembly.link_lift = params.link_lift;
  assembly.tool_radius = radius;
  assembly.tolerance = params.tolerance;
  assembly.arcs = params.arcs;
  assembly.wall_on_left = mirror;
  assembly.order_by = params.order_by;
  path.moves = assemble(runs, assembly);
  path.report.cutting_time = duration(path.moves, params.rapid_feed);
  path.report.retracts = std::max(0, static_cast<int>(runs.size() * params.levels.size()) - 1);
  if (path.report.uncut_area > 0) path.report.termination = Termination::kIncomplete;
  if (progress.cancelled()) {
    path.report.termination = Termination::kCancelled;
    path.report.findings.push_back({FindingCode::kCancelled});
  }
  return path;
}

Work work_of(const std::vector<Region>& regions, const ClearingParams& params) {
  check(params);
  if (params.cut_mode == CutMode::kClimb) return {regions, params};
  Work work{mirrored(regions), params};
  if (params.entry_point) work.params.entry_point = mirrored(*params.entry_point);
  if (params.open_side) work.params.open_side = mirrored(*params.open_side);
  return work;
}

}  // namespace

std::vector<Region> reachable_ground(const std::vector<Region>& regions, double tool_diameter,
                                     double stock_to_leave) {
  require(tool_diameter > 0 && std::isfinite(tool_diameter),
          "The tool's diameter must be positive.");
  require(stock_to_leave >= 0 && std::isfinite(stock_to_leave),
          "The stock to leave must not be negative.");
  const double radius = 0.5 * tool_diameter;
  std::vector<Finding> untold;
  const auto as_it_is = [](Vec2 p) { return p; };
  const std::vector<Region> allowed = allowed_ground(regions, tool_diameter, as_it_is, untold);
  return offset(shrunk_to_tips(allowed, radius + stock_to_leave, kWallGap), radius);
}

Toolpath clear_by(const RegionClearer& clearer, const std::vector<Region>& regions,
                  const ClearingParams& params, Progress& progress) {
  return clear(clearer, work_of(regions, params), progress);
}

}  // namespace evenload
