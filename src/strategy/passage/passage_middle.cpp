#include "strategy/passage/passage_middle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/arc_fit.h"
#include "support/tolerances.h"

namespace evenload {
namespace {

// mm: by which arcs in place of the middle's points leave them.
constexpr double kMiddleFit = kAxisTolerance;

using Used = std::vector<std::vector<char>>;  // which ways out of a point are cut

// Straight on where the tool stands there, else the first that is not cut.
std::size_t next_way(const PassageAxis& axis, std::size_t at, const Used& used, const Pose& here) {
  std::size_t best = kNoIndex;
  double least = std::numeric_limits<double>::infinity();
  const bool stands_there = distance(here.p, axis.points[at].p) < kMiddleFit;
  for (std::size_t i = 0; i < used[at].size(); ++i) {
    if (used[at][i]) continue;
    const double heading = pose_at(axis, at, axis.points[at].next[i]).heading;
    const double turn = stands_there ? std::abs(wrap_signed(heading - here.heading)) : 0;
    if (turn >= least) continue;
    best = i;
    least = turn;
  }
  return best;
}

// The stretch of the middle from `*at` on to the next fork, end, or the root; `*at`: that point.
std::vector<Segment> chain(const PassageAxis& axis, std::size_t* at, std::size_t out,
                           std::size_t root, Used& used) {
  std::vector<Vec2> points{axis.points[*at].p};
  for (;;) {
    const std::size_t next = axis.points[*at].next[out];
    used[*at][out] = 1;
    const std::vector<std::size_t>& neighbours = axis.points[next].next;
    for (std::size_t i = 0; i < neighbours.size(); ++i)
      if (neighbours[i] == *at && !used[next][i]) {
        used[next][i] = 1;
        break;
      }
    points.push_back(axis.points[next].p);
    *at = next;
    if (neighbours.size() != 2 || *at == root) break;
    const auto free = std::find(used[*at].begin(), used[*at].end(), 0);
    if (free == used[*at].end()) break;
    out = static_cast<std::size_t>(free - used[*at].begin());
  }
  return fit_arcs(points, kMiddleFit).segments();
}

}  // namespace

Pose pose_at(const PassageAxis& axis, std::size_t point, std::size_t neighbour) {
  return {axis.points[point].p, angle_of(axis.points[neighbour].p - axis.points[point].p)};
}

void follow_middle(const PassageAxis& axis, std::size_t root, int number, PassagePath& path,
                   const Progress& progress) {
  Used used(axis.points.size());
  for (std::size_t i = 0; i < axis.points.size(); ++i)
    used[i].assign(axis.points[i].next.size(), 0);
  std::vector<std::size_t> reached{root};  // points with ways out, the newest last
  while (!reached.empty() && !progress.cancelled()) {
    const std::size_t at = reached.back(), out = next_way(axis, at, used, path.here());
    if (out == kNoIndex) {
      reached.pop_back();
      continue;
    }
    std::size_t end = at;
    path.follow(chain(axis, &end, out, root, used), number);
    reached.push_back(end);
  }
}

}  // namespace evenload
