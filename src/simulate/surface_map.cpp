#include "simulate/surface_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "geometry/box_tree.h"
#include "simulate/cusps.h"
#include "simulate/swept_cutter.h"
#include "support/parallel.h"

namespace evenload {
namespace {

constexpr int kTile = 64;   // cells a side, of which a thread takes care at once
constexpr int kBlock = 16;  // of these, within which it is asked once whether a piece matters
// Spacings of path between the places by which two neighbouring cells were cut, from which on they
// were cut by different passes: along one pass they are hardly further apart than the cells.
constexpr double kSamePass = 4;
constexpr double kCuttingShare = 0.7;  // of the time, about
constexpr int kWayHalvings = 12;       // of the way sideways out of the part
constexpr int kWays = 8;               // directions in which it is looked for
constexpr double kNoGouge = 1e-3;      // mm: what is cut less deep has no other way out
class Mapper {
 public:
  Mapper(const HeightMap& part, const std::vector<bool>& picked, const std::vector<Move>& moves,
         const SurfaceMapParams& params)
      : part_(part),
        picked_(picked),
        params_(params),
        runs_(cutter_runs(moves, params.teeth_per_minute)),
        cusps_(part, params.cutter, runs_) {
    std::vector<Bounds> boxes;
    for (const CutterRun& run : runs_)
      boxes.push_back(grown(run.path.bounds(), params.cutter.radius));
    tree_ = BoxTree(boxes);
    const std::size_t cells = count();
    map_.part.assign(cells, kNoMaterial);
    map_.lean.assign(cells, 0);
    picked_cells_.assign(cells, 0);
    height_.assign(cells, HUGE_VAL);
    run_.assign(cells, -1);
    map_.along.assign(cells, 0);
    map_.above.assign(cells, 0);
    map_.cusp.assign(cells, std::numeric_limits<double>::quiet_NaN());
  }

  SurfaceMap map(Progress& progress) {
    const int threads = thread_count(params_.threads);
    const auto across = static_cast<std::size_t>((params_.columns + kTile - 1) / kTile);
    const auto tiles = across * static_cast<std::size_t>((params_.rows + kTile - 1) / kTile);
    Progress cutting([&](double share) { return progress.report(kCuttingShare * share); });
    parallel_for(
        tiles, threads,
        [&](std::size_t tile) {
          cut_tile(static_cast<int>(tile % across) * kTile, static_cast<int>(tile / across) * kTile,
                   cutting);
        },
        cutting);
    Progress comparing(
        [&](double share) { return progress.report(kCuttingShare + (1 - kCuttingShare) * share); });
    parallel_for(
        static_cast<std::size_t>(params_.rows), threads,
        [&](std::size_t row) { compare_row(static_cast<int>(row)); }, comparing);
    map_.is_picked.assign(picked_cells_.begin(), picked_cells_.end());
    map_.move.resize(count());
    for (std::size_t i = 0; i < count(); ++i)
      map_.move[i] = run_[i] < 0 ? -1 : runs_[static_cast<std::size_t>(run_[i])].move;
    return std::move(map_);
  }

 private:
  std::size_t count() const {
    return static_cast<std::size_t>(params_.columns) * static_cast<std::size_t>(params_.rows);
  }
  std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(params_.columns) +
           static_cast<std::size_t>(column);
  }
  Vec2 middle(int column, int row) const {
    return params_.first +
           params_.spacing * Vec2{static_cast<double>(column), static_cast<double>(row)};
  }

  void look_at_part(int column, int row) {
    const std::size_t i = cell(column, row);
    const std::optional<Top> top = part_.highest_at(middle(column, row));
    if (!top) return;
    map_.part[i] = top->z;
    map_.lean[i] = static_cast<float>(top->normal.z);
    picked_cells_[i] = picked_[top->triangle];
    height_[i] = top->z + params_.stock / top->normal.z;
  }

  void cut_tile(int column, int row, Progress& progress) {
    const int end_column = std::min(params_.columns, column + kTile);
    const int end_row = std::min(params_.rows, row + kTile);
    for (int j = row; j < end_row; ++j)
      for (int i = column; i < end_column; ++i) look_at_part(i, j);
    // In the path's order, so that of two pieces as low the first has cut.
    std::vector<std::uint32_t> near;
    tree_.visit({middle(column, row), middle(end_column - 1, end_row - 1)},
                [&](std::uint32_t item) { near.push_back(item); });
    std::sort(near.begin(), near.end());
    for (int j = row; j < end_row; j += kBlock)
      for (int i = column; i < end_column; i += kBlock) {
        cut_block(i, j, std::min(end_column, i + kBlock), std::min(end_row, j + kBlock), near);
        if (progress.cancelled()) throw Cancelled();
      }
  }

  void cut_block(int column, int row, int end_column, int end_row,
                 const std::vector<std::uint32_t>& near) {
    const Vec2 low = middle(column, row), high = middle(end_column - 1, end_row - 1);
    const Vec2 centre = 0.5 * (low + high);
    const double half = 0.5 * distance(low, high), radius = params_.cutter.radius;
    double top = highest_in(column, row, end_column, end_row);
    if (top == -HUGE_VAL) return;  // no part
    for (const std::uint32_t number : near) {
      const CutterRun& run = runs_[number];
      const double off = std::max(0.0, run.path.distance_to(centre) - half);
      if (off > radius || lowest_near(run, centre, half) + params_.cutter.rise(off) >= top)
        continue;
      bool has_cut = false;
      for (int j = row; j < end_row; ++j)
        for (int i = column; i < end_column; ++i) {
          const std::size_t k = cell(i, j);
          if (map_.part[k] == kNoMaterial) continue;
          const Underside below = underside(params_.cutter, run, middle(i, j));
          if (!(below.z < height_[k])) continue;
          height_[k] = below.z;
          run_[k] = static_cast<std::int32_t>(number);
          map_.along[k] = run.begin + below.along;
          has_cut = true;
        }
      if (has_cut) top = highest_in(column, row, end_column, end_row);
    }
  }

  // The lowest that the tip is while the tool may reach a circle.
  double lowest_near(const CutterRun& run, Vec2 centre, double half) const {
    const double in_plan = run.path.length();
    if (run.z0 == run.z1 || run.path.is_arc() || in_plan == 0) return std::min(run.z0, run.z1);
    const double next = dot(centre - run.path.a, run.path.b - run.path.a) / (in_plan * in_plan);
    const double reach = (params_.cutter.radius + half) / in_plan;
    const double t0 = std::clamp(next - reach, 0.0, 1.0), t1 = std::clamp(next + reach, 0.0, 1.0);
    return run.z0 + (run.z1 > run.z0 ? t0 : t1) * (run.z1 - run.z0);
  }

  double highest_in(int column, int row, int end_column, int end_row) const {
    double top = -HUGE_VAL;
    for (int j = row; j < end_row; ++j)
      for (int i = column; i < end_column; ++i)
        if (map_.part[cell(i, j)] != kNoMaterial) top = std::max(top, height_[cell(i, j)]);
    return top;
  }

  void compare_row(int row) {
    for (int column = 0; column < params_.columns; ++column) {
      const std::size_t i = cell(column, row);
      if (map_.part[i] == kNoMaterial) continue;
      // Exactly the stock where nothing has cut.
      const double off = static_cast<double>(map_.lean[i]) * (height_[i] - map_.part[i]);
      map_.above[i] = run_[i] < 0 ? params_.stock : off;
      if (off < -kNoGouge) map_.above[i] = -gouge(middle(column, row), height_[i], -off);
      if (!picked_cells_[i]) continue;
      // Each cell looks to all sides, so that no other writes what is its own.
      for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
        look_for_cusp(column, row, dx, dy);
    }
  }

  // mm to the nearest way out of the part: `depth` across the surface, or sideways.
  double gouge(Vec2 at, double z, double depth) const {
    const auto is_free = [&](double by) {
      for (int k = 0; k < kWays; ++k)
        if (!(part_.top_at(at + by * unit(2 * kPi * k / kWays)) > z)) return true;
      return false;
    };
    if (!is_free(depth)) return depth;
    double low = 0, high = depth;
    for (int k = 0; k < kWayHalvings; ++k)
      (is_free(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    return high;
  }

  void look_for_cusp(int column, int row, int dx, int dy) {
    const int other_column = column + dx, other_row = row + dy;
    if (other_column < 0 || other_column >= params_.columns) return;
    if (other_row < 0 || other_row >= params_.rows) return;
    const std::size_t i = cell(column, row), j = cell(other_column, other_row);
    if (!picked_cells_[j] || run_[i] < 0 || run_[j] < 0 || run_[i] == run_[j]) return;
    const double apart = std::abs(map_.along[i] - map_.along[j]);
    if (apart <= kSamePass * params_.spacing) return;
    const CutPlace mine{middle(column, row), run_[i], map_.along[i]};
    const CutPlace other{middle(other_column, other_row), run_[j], map_.along[j]};
    const std::optional<double> cusp = cusps_.between(mine, other);
    if (cusp && !(map_.cusp[i] >= *cusp)) map_.cusp[i] = *cusp;
  }

  const HeightMap& part_;
  const std::vector<bool>& picked_;
  const SurfaceMapParams& params_;
  const std::vector<CutterRun> runs_;
  const Cusps cusps_;
  BoxTree tree_;
  SurfaceMap map_;
  std::vector<char> picked_cells_;  // not bits, which threads could not write side by side
  std::vector<double> height_;      // mm: z of what stands
  std::vector<std::int32_t> run_;   // which has cut it; -1: none
};

void check(const HeightMap& part, const std::vector<bool>& picked, const std::vector<Move>& moves,
           const SurfaceMapParams& params) {
  const Cutter& cutter = params.cutter;
  if (!(cutter.radius > 0 && std::isfinite(cutter.radius) && cutter.corner >= 0 &&
        cutter.corner <= cutter.radius))
    throw std::invalid_argument(
        "The tool's diameter must be positive, its corner's radius between 0 and half of it.");
  if (picked.size() != part.triangle_count())
    throw std::invalid_argument("For each triangle it must be said whether it is picked.");
  if (part.empty()) throw std::invalid_argument("The part has no surface that looks up.");
  if (!(params.spacing > 0 && std::isfinite(params.spacing)))
    throw std::invalid_argument("The resolution must be positive, in mm.");
  if (!(params.columns > 0 && params.rows > 0 &&
        static_cast<double>(params.columns) * params.rows <= kMostCells))
    throw std::invalid_argument(
        "The map must have between one and six million cells: choose a coarser resolution.");
  if (!(std::isfinite(params.stock) && params.stock > 0))
    throw std::invalid_argument("The stock on the part must be more than 0, in mm.");
  if (moves.size() < 2) throw std::invalid_argument("The path has no moves.");
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const Move& m = moves[i];
    if (!(std::isfinite(m.x) && std::isfinite(m.y) && std::isfinite(m.z) &&
          std::isfinite(m.sweep) && std::isfinite(m.cx) && std::isfinite(m.cy)))
      throw std::invalid_argument("Move " + std::to_string(i) + " is not of numbers.");
    if (i > 0 && params.teeth_per_minute > 0 && m.kind != MoveKind::kRapid && !(m.feed > 0))
      throw std::invalid_argument("Move " + std::to_string(i) + " has no feed.");
  }
}

}  // namespace

SurfaceMap map_surface(const HeightMap& part, const std::vector<bool>& picked,
                       const std::vector<Move>& moves, const SurfaceMapParams& params,
                       Progress& progress) {
  check(part, picked, moves, params);
  return Mapper(part, picked, moves, params).map(progress);
}

}  // namespace evenload
