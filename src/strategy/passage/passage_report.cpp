#include "strategy/passage/passage_report.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/box_tree.h"
#include "geometry/medial_axis.h"
#include "strategy/choose/leftover.h"
#include "strategy/places/area.h"
#include "strategy/reach/entry.h"
#include "strategy/task/mirror.h"
#include "toolpath/helix.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

// mm: a passage whose free width is twice the minimum radius to within this is not narrow.
constexpr double kJustWide = 0.002;
// Share of the tool's radius: a region in which nothing has more room, half of the free width, and
// of which the whole tool must cut a part anyway, is all cut so.
constexpr double kStroke = 0.1;
// Of the widest free width, or of the tool's radius where that is tiny: between points of a
// passage's middle.
constexpr double kAxisSpacing = 0.125;
// Ground that no pass has cleared at the engagement angle, over the area of a circle with the
// tool's diameter for its radius: for all entries of a region together.
constexpr double kMostTogether = 1.95;
// mm: of the place of an entry.
constexpr double kEntryTolerance = 1e-3;

Curve without_cusps(const std::vector<PassageBorder>& loop) {
  std::vector<Vertex> vertices;
  vertices.reserve(loop.size());
  for (const PassageBorder& piece : loop)
    vertices.push_back({piece.segment.a, piece.is_mouth ? 0 : piece.segment.bulge()});
  return Curve(std::move(vertices), true);
}

// mm^2 within the tool's reach from the passage that still hold material.
double left_in(const PassageReport& passage, const ClearedGround& ground) {
  Leftover leftover;
  leftover.prepare(Area({passage.centres}),
                   grown(bounds_of({passage.centres}), ground.tool_radius()), ground);
  return leftover.area(ground);
}

// mm^2 that the helices of all rooms clear, if each room has one, and the ramps between them.
double cleared_by_entries(const NarrowPlaces& places, const ClearingParams& params) {
  const double diameter = params.tool_diameter;
  double area = 0;
  // From both mouths the tool reaches into a neck by its radius, but for the corners.
  for (const Passage& neck : places.passages)
    area += diameter * std::max(0.0, 0.5 * neck.centres.outer.length() - diameter) +
            (1 - kPi / 4) * diameter * diameter;
  for (const Region& room : places.rooms) {
    Descent helix;
    helix.radius = helix_radius(params, largest_circle(room, kEntryTolerance));
    area += cleared_area(helix, 0.5 * diameter);
  }
  return area;
}

// The necks that are narrower than `radius` allows to turn in, if each can be cleared by a ramp,
// and the rooms that they join, if the entries of these clear no more than one may.
std::optional<DividedRegion> short_necks(const Region& centres, double radius,
                                         const ClearingParams& params) {
  const double tool_radius = 0.5 * params.tool_diameter;
  DividedRegion region{find_narrow_places(centres, radius, tool_radius), {}};
  if (region.places.rooms.empty() && !region.places.passages.empty()) return std::nullopt;
  for (Passage& passage : region.places.passages) {
    const bool is_neck = passage.rooms.size() > 1 && passage.centres.islands.empty();
    if (!is_neck || passage.centres.outer.length() > 2 * kLongestRamp * params.tool_diameter)
      return std::nullopt;
    passage.by_ramp = true;
  }
  const double most = kMostTogether * kPi * params.tool_diameter * params.tool_diameter;
  if (!region.places.passages.empty() && cleared_by_entries(region.places, params) > most)
    return std::nullopt;
  region.axes = passage_axes(centres, region.places, tool_radius * kAxisSpacing);
  return region;
}

DividedRegion without_room_for_trochoids(const Region& centres, const ClearingParams& params) {
  const double tool_radius = 0.5 * params.tool_diameter;
  const double posted = std::sqrt(kLeastSpan / std::sin(params.engagement_angle / 3));
  const double tightest = std::min({kTightestArc, posted, kTightestArcShare * tool_radius});
  if (params.entry != EntryKind::kPredrilledHole)
    if (std::optional<DividedRegion> necks = short_necks(centres, tightest, params)) return *necks;
  // Corners, however sharp, are the wall pass's.
  const auto with_radius = [&](double radius) {
    DividedRegion region{find_narrow_places(centres, radius, tool_radius), {}};
    region.axes = passage_axes(centres, region.places, tool_radius * kAxisSpacing);
    return region;
  };
  DividedRegion region = with_radius(tightest_trochoid(tool_radius));
  const bool is_long =
      std::any_of(region.axes.begin(), region.axes.end(),
                  [&](const PassageAxis& axis) { return axis.length() > tool_radius; });
  if (is_long && !region.places.rooms.empty()) {
    DividedRegion stroke =
        with_radius(std::max(kStroke * tool_radius, tightest_trochoid(tool_radius)));
    if (stroke.places.rooms.empty()) return stroke;
  }
  return is_long || region.places.rooms.empty() ? region : DividedRegion{{{centres}, {}}, {}};
}

}  // namespace

DividedRegion divide(const Region& centres, const ClearingParams& params) {
  if (params.narrow_passages == NarrowPassages::kTrochoid)
    return without_room_for_trochoids(centres, params);
  double radius = params.minimum_radius - 0.5 * kJustWide;
  if (params.narrow_passages == NarrowPassages::kReducedFeed)
    radius = std::min(radius, kWidestPassage * 0.5 * params.tool_diameter);
  if (radius <= 0) return {{{centres}, {}}, {}};
  DividedRegion region{find_narrow_places(centres, radius), {}};
  region.axes = passage_axes(centres, region.places, 2 * radius * kAxisSpacing);
  return region;
}

std::vector<PassageReport> reports_of(const DividedRegion& region, const ClearingParams& params) {
  std::vector<PassageReport> reports;
  for (std::size_t k = 0; k < region.places.passages.size(); ++k) {
    const PassageAxis& axis = region.axes[k];
    PassageReport report;
    for (const std::vector<PassageBorder>& loop : region.places.passages[k].loops)
      if (report.centres.outer.empty())
        report.centres.outer = without_cusps(loop);
      else
        report.centres.islands.push_back(without_cusps(loop));
    report.at = axis.points.empty() ? report.centres.outer.vertices().front().p
                                    : axis.points[axis.points.size() / 2].p;
    report.width = params.tool_diameter + 2 * (params.stock_to_leave + kWallGap) + axis.narrowest();
    report.no_turns = params.narrow_passages == NarrowPassages::kTrochoid;
    reports.push_back(std::move(report));
  }
  return reports;
}

bool is_in_passage(Vec2 p, const std::vector<PassageReport>& passages) {
  return std::any_of(passages.begin(), passages.end(),
                     [&](const PassageReport& passage) { return passage.centres.contains(p); });
}

void note_engagement(const std::vector<PlanarRun>& runs, const std::vector<LoadSample>& profile,
                     std::vector<PassageReport>& passages) {
  for (const LoadSample& sample : profile) {
    const int passage = runs[sample.run].moves[sample.move].passage;
    if (passage < 0) continue;
    double& most = passages[static_cast<std::size_t>(passage)].engagement;
    most = std::max(most, sample.engagement);
  }
}

void note_feeds(const std::vector<PlanarRun>& runs, std::vector<PassageReport>& passages) {
  for (const PlanarRun& run : runs)
    for (const PlanarMove& move : run.moves) {
      if (move.passage < 0) continue;
      double& lowest = passages[static_cast<std::size_t>(move.passage)].feed;
      lowest = lowest > 0 ? std::min(lowest, move.feed) : move.feed;
    }
}

void tell(const std::vector<PassageReport>& passages, const ClearedGround& ground, bool mirror,
          Report& report) {
  for (const PassageReport& passage : passages) {
    const double left = left_in(passage, ground);
    if (left == 0 && passage.feed == 0) continue;  // the tool has reached it from a room
    const bool is_cut = passage.feed > 0;
    const FindingCode code =
        passage.no_turns ? (is_cut ? FindingCode::kPassageReducedTooNarrow
                                   : FindingCode::kPassageSkippedTooNarrow)
                         : (is_cut ? FindingCode::kPassageReduced : FindingCode::kPassageSkipped);
    Finding finding{code, mirror ? mirrored(passage.at) : passage.at, {passage.width, left}};
    if (is_cut) finding.numbers.insert(finding.numbers.end(), {passage.engagement, passage.feed});
    report.findings.push_back(std::move(finding));
    report.uncut_area += left;
  }
}

}  // namespace evenload
