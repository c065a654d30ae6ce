#include "surface/contours_by_cusp.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/united.h"
#include "support/demand.h"
#include "support/parallel.h"
#include "surface/stepped.h"

namespace evenload {

namespace {

constexpr double kUnevenness = 0.2;  // mm by which steps may grow per mm along a row
constexpr double kLost = 0.52;       // of a step: further from both rows is too far
constexpr double kShare = 0.005;     // of the step, by which outlines may be simplified
constexpr double kSliver = 1e-3;     // of the step's square: smaller pieces are none

class Rows {
 public:
  Rows(const StepBeside& beside, int threads, Progress& progress)
      : beside_(beside),
        threads_(thread_count(threads)),
        progress_(progress),
        asking_(part_of(progress)) {}

  CuspRows run(const std::vector<Region>& regions) {
    std::vector<Patch> inner = begin(regions);
    while (!inner.empty()) {
      demand(static_cast<double>(result_.rows.size()) < kMostPasses,
             "The cusp height makes too many passes: raise it.");
      progress_.step();
      const std::vector<Patch> left = std::move(inner);
      inner = cut(left, bands(row_, 1, 1, progress_));
      take(inner, cut(left, bands(row_, kLost, 1, progress_)));
    }
    return std::move(result_);
  }

  std::vector<std::vector<Polyline>> border(const std::vector<Region>& regions) {
    begin(regions);
    return std::move(result_.rows);
  }

 private:
  // The outermost row; returns what it encloses.
  std::vector<Patch> begin(const std::vector<Region>& regions) {
    const std::vector<Patch> left = reachable(patches_of(regions));
    row_ = stepped(left);
    const std::vector<Patch> inner = cut(left, bands(row_, 0.5, 1, progress_));
    // The border is no row: what lies within half a step of it need not be near it.
    take(inner, left);
    return inner;
  }

  // Goes on to the row round `inner`; `off`: what the row before does not cover.
  void take(const std::vector<Patch>& inner, const std::vector<Patch>& off) {
    std::vector<Stepped> next = stepped(inner);
    const std::vector<Patch> lost = far_from(off, inner, outwards(next, row_, progress_));
    row_ = std::move(next);
    add(row_, lost);
  }

  std::vector<Patch> patches_of(const std::vector<Region>& regions) const {
    std::vector<Patch> patches;
    for (const Region& region : regions) {
      Patch patch{region.outer.flattened(kChords), {}};
      for (const Curve& island : region.islands) patch.holes.push_back(island.flattened(kChords));
      patches.push_back(std::move(patch));
    }
    return patches;
  }

  double tolerance() const { return std::min(kChords, kShare * beside_.level()); }

  std::vector<Patch> cut(const std::vector<Patch>& patches,
                         const std::vector<Patch>& others) const {
    progress_.step();
    std::vector<Patch> found = cut_from(patches, others, tolerance());
    const double least = kSliver * beside_.level() * beside_.level();
    found.erase(std::remove_if(found.begin(), found.end(),
                               [&](const Patch& patch) {
                                 return Curve(vertices_of(patch.outline), true).signed_area() <
                                        least;
                               }),
                found.end());
    return found;
  }

  static std::vector<Vertex> vertices_of(const std::vector<Vec2>& outline) {
    std::vector<Vertex> vertices;
    for (const Vec2 p : outline) vertices.push_back({p});
    return vertices;
  }

  // The steps of all outlines of patches.
  std::vector<Stepped> stepped(const std::vector<Patch>& patches) {
    std::vector<Stepped> rows = outlines_of(patches);
    for (Stepped& row : rows) find_steps(row);
    return rows;
  }

  // What is found at the middles of sides, of short ones at one of some; `otherwise` where there is
  // nothing. find: of the place and the direction inwards.
  template <typename Find>
  std::vector<double> at_sides(const std::vector<Vec2>& corners, Find&& find, double otherwise) {
    const std::size_t count = corners.size();
    std::vector<std::size_t> asked;
    double since = HUGE_VAL;
    for (std::size_t i = 0; i < count; ++i) {
      const double length = norm(corners[(i + 1) % count] - corners[i]);
      since += length;
      if (since < kStationsApart && length < 0.5 * kStationsApart) continue;
      asked.push_back(i);
      since = 0.5 * length;
    }
    std::vector<std::optional<double>> found(asked.size());
    parallel_for(
        asked.size(), threads_,
        [&](std::size_t k) {
          const Vec2 from = corners[asked[k]], to = corners[(asked[k] + 1) % count];
          found[k] = find(0.5 * (from + to), left_normal(normalized(to - from)));
        },
        asking_);
    std::vector<double> sides(count, otherwise);
    for (std::size_t k = 0; k < asked.size(); ++k)
      for (std::size_t i = asked[k]; i < (k + 1 < asked.size() ? asked[k + 1] : count); ++i)
        sides[i] = found[k].value_or(otherwise);
    return sides;
  }

  // A corner has the least of both its sides, and steps grow along a row as slowly as kUnevenness.
  void find_steps(Stepped& row) {
    const std::size_t count = row.corners.size();
    const double none = -1;
    std::vector<double> sides = at_sides(
        row.corners,
        [&](Vec2 at, Vec2 inwards) { return beside_.from(at, inwards, beside_.level()); }, none);
    for (double& side : sides) {
      if (side != none) tell(side);
      if (side == none) side = beside_.level();
    }
    row.steps.resize(count);
    for (std::size_t i = 0; i < count; ++i)
      row.steps[i] = std::min(sides[i], sides[(i + count - 1) % count]);
    const auto grown = [&](std::size_t i, std::size_t next) {
      return row.steps[i] + kUnevenness * norm(row.corners[next] - row.corners[i]);
    };
    for (std::size_t k = 0; k < 2 * count; ++k) {  // twice round, forwards and backwards
      const std::size_t i = k % count, next = (i + 1) % count;
      row.steps[next] = std::min(row.steps[next], grown(i, next));
    }
    for (std::size_t k = 2 * count; k-- > 0;) {
      const std::size_t i = k % count, next = (i + 1) % count;
      row.steps[i] = std::min(row.steps[i], grown(next, i));
    }
  }

  void tell(double step) {
    result_.largest_stepover = std::max(result_.largest_stepover, step);
    if (result_.least_stepover == 0 || step < result_.least_stepover) result_.least_stepover = step;
  }

  // What of patches is neither in an inner row nor near it.
  std::vector<Patch> far_from(const std::vector<Patch>& patches, const std::vector<Patch>& inner,
                              const std::vector<Stepped>& row) const {
    return cut(cut(patches, bands(row, kLost, -1, progress_)), inner);
  }

  // What the tool's axis may be over while it is at work: it leans outwards from a border that
  // falls, and keeps off one before which a wall stands.
  std::vector<Patch> reachable(const std::vector<Patch>& patches) {
    std::vector<Stepped> beyond = outlines_of(patches), within = beyond;
    for (std::size_t i = 0; i < beyond.size(); ++i) {
      const std::vector<double> sides = at_sides(
          beyond[i].corners,
          [&](Vec2 at, Vec2 inwards) {
            return std::optional(beside_.reach_beyond(at, -inwards, asking_));
          },
          0);
      for (std::size_t k = 0; k < sides.size(); ++k) {
        const double before = sides[(k + sides.size() - 1) % sides.size()];
        beyond[i].steps.push_back(std::max({0.0, before, sides[k]}));
        within[i].steps.push_back(std::max({0.0, -before, -sides[k]}));
      }
    }
    std::vector<Patch> all = bands(beyond, 1, -1, progress_);
    all.insert(all.end(), patches.begin(), patches.end());
    return cut(cut_from(all, {}, tolerance()), bands(within, 1, 1, progress_));
  }

  // A row, with detours to small patches beside it and rows of their own round others.
  void add(const std::vector<Stepped>& row, const std::vector<Patch>& lost) {
    std::vector<Polyline> polylines, others;
    for (const Stepped& each : row) polylines.push_back({each.corners, true});
    for (const Patch& patch : lost)
      for (const std::vector<Vec2>& way : ways_over(patch))
        if (!reached_by_detour(way, polylines))
          others.push_back({way.size() > 1 ? way : patch.outline, true});
    if (!others.empty()) result_.rows.push_back(std::move(others));
    if (!polylines.empty()) result_.rows.push_back(std::move(polylines));
  }

  // A small patch is reached where its middle is, a larger one along its outline and its holes.
  std::vector<std::vector<Vec2>> ways_over(const Patch& patch) const {
    Vec2 middle{};
    for (const Vec2 p : patch.outline)
      middle += (1.0 / static_cast<double>(patch.outline.size())) * p;
    double size = 0;
    for (const Vec2 p : patch.outline) size = std::max(size, norm(p - middle));
    if (size < 0.5 * beside_.level()) return {{middle}};
    std::vector<std::vector<Vec2>> ways = patch.holes;
    ways.push_back(patch.outline);
    return ways;
  }

  // Adds a detour to the nearest corner of a row, if there is one.
  bool reached_by_detour(const std::vector<Vec2>& way, std::vector<Polyline>& polylines) const {
    progress_.step();
    double nearest = 1.5 * beside_.level();
    Polyline* polyline = nullptr;
    std::size_t corner = 0, start = 0;
    for (Polyline& each : polylines)
      for (std::size_t i = 0; i < each.corners.size(); ++i)
        for (std::size_t k = 0; k < way.size(); ++k) {
          const double off = norm(each.corners[i] - way[k]);
          if (off >= nearest) continue;
          nearest = off;
          polyline = &each;
          corner = i;
          start = k;
        }
    if (!polyline) return false;
    std::vector<Vec2> detour(way.begin() + static_cast<std::ptrdiff_t>(start), way.end());
    detour.insert(detour.end(), way.begin(), way.begin() + static_cast<std::ptrdiff_t>(start));
    if (way.size() > 1) detour.push_back(way[start]);
    std::vector<Vec2>& corners = polyline->corners;
    detour.push_back(corners[corner]);
    corners.insert(corners.begin() + static_cast<std::ptrdiff_t>(corner) + 1, detour.begin(),
                   detour.end());
    return true;
  }

  const StepBeside& beside_;
  int threads_;
  Progress& progress_;
  Progress asking_;           // the same for what many threads do, which tells no share
  std::vector<Stepped> row_;  // the last one
  CuspRows result_;
};

}  // namespace

std::vector<std::vector<Polyline>> border_rows(const std::vector<Region>& regions,
                                               const StepBeside& beside, int threads,
                                               Progress& progress) {
  return Rows(beside, threads, progress).border(regions);
}

CuspRows contours_by_cusp(const std::vector<Region>& regions, const StepBeside& beside, int threads,
                          Progress& progress) {
  return Rows(beside, threads, progress).run(regions);
}

}  // namespace evenload
