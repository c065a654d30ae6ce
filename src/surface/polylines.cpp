#include "surface/polylines.h"

#include <iterator>
#include <utility>

#include "support/parallel.h"

namespace evenload {

namespace {

bool is_same(SpacePoint a, SpacePoint b) { return distance(a, b) < kSamePlace; }

// The pieces that are cut along one line.
std::vector<PassPart> along(const Ground& ground, const Polyline& polyline, std::size_t row,
                            double tolerance) {
  std::vector<PassPart> parts;
  const std::vector<Vec2>& corners = polyline.corners;
  const std::size_t lines = corners.size() - (polyline.is_closed ? 0 : 1);
  for (std::size_t i = 0; i < lines; ++i) {
    const Vec2 from = corners[i], way = corners[(i + 1) % corners.size()] - from;
    const double length = norm(way);
    if (!(length > kSamePlace)) continue;
    const PlanLine line{from, way / length};
    const std::vector<DropSample> samples = samples_along(ground, line, 0, length, tolerance);
    for (const std::vector<DropSample>& part : parts_at_work(ground, line, samples)) {
      std::vector<SpacePoint> points = lines_of(line, part, tolerance, LineEnds::kFixed);
      if (!parts.empty() && is_same(parts.back().points.back(), points.front()))
        parts.back().points.insert(parts.back().points.end(), points.begin() + 1, points.end());
      else
        parts.push_back({row, std::move(points)});
    }
  }
  if (!polyline.is_closed || parts.empty() ||
      !is_same(parts.back().points.back(), parts.front().points.front()))
    return parts;
  if (parts.size() == 1) {
    parts.front().is_closed = true;
    return parts;
  }
  // The last one goes on where the polygon begins.
  std::vector<SpacePoint>& last = parts.back().points;
  last.insert(last.end(), parts.front().points.begin() + 1, parts.front().points.end());
  parts.front().points = std::move(last);
  parts.pop_back();
  return parts;
}

}  // namespace

std::vector<PassPart> passes_along(const Ground& ground,
                                   const std::vector<std::vector<Polyline>>& rows,
                                   const FinishParams& params, Progress& progress) {
  std::vector<std::vector<PassPart>> found(rows.size());
  parallel_for(
      rows.size(), thread_count(params.threads),
      [&](std::size_t row) {
        for (const Polyline& polyline : rows[row]) {
          std::vector<PassPart> parts = along(ground, polyline, row, params.tolerance);
          std::move(parts.begin(), parts.end(), std::back_inserter(found[row]));
        }
      },
      progress);
  std::vector<PassPart> parts;
  for (std::vector<PassPart>& row : found)
    std::move(row.begin(), row.end(), std::back_inserter(parts));
  return parts;
}

}  // namespace evenload
