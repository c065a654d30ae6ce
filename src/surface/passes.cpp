#include "surface/passes.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "support/parallel.h"

namespace evenload {

namespace {

// Of the tolerance. Into the part a path goes by a tenth of it at the most: lines by so much, the
// samples' chords, which are off by a quarter of kChordShare beside a sharp edge, by the rest.
constexpr double kBelow = 0.05;
constexpr double kAbove = 0.95;
constexpr double kStraight = 0.01;  // of it, by which points that are left out lie off the lines

}  // namespace

LineBounds line_bounds(double tolerance) { return {kBelow * tolerance, kAbove * tolerance}; }

std::vector<Waypoint> lines_of(const PlanLine& line, const std::vector<DropSample>& samples,
                               double tolerance, LineEnds ends) {
  std::vector<Vec2> curve;
  curve.reserve(samples.size());
  for (const DropSample& sample : samples) curve.push_back({sample.s, sample.z});
  const LineBounds bounds = line_bounds(tolerance);
  std::vector<Waypoint> points;
  double before = curve.front().x;
  for (const Vec2 corner : fewest_lines(without_straight_ones(curve, kStraight * tolerance),
                                        bounds.below, bounds.above, ends)) {
    const Vec2 p = line.at(corner.x);
    points.push_back({{p.x, p.y, corner.y}, line.bend * (corner.x - before)});
    before = corner.x;
  }
  return points;
}

std::vector<PassPart> parallel_passes(const Ground& ground, const PassFrame& frame,
                                      const std::vector<double>& ordinates,
                                      const FinishParams& params, Progress& progress) {
  std::vector<std::vector<PassPart>> rows(ordinates.size());
  parallel_for(
      ordinates.size(), thread_count(params.threads),
      [&](std::size_t row) {
        const PlanLine line = frame.line(ordinates[row]);
        const std::vector<DropSample> samples =
            samples_along(ground, line, frame.begin, frame.end, params.tolerance);
        for (const std::vector<DropSample>& part : parts_at_work(ground, line, samples))
          rows[row].push_back({row, lines_of(line, part, params.tolerance)});
      },
      progress);
  std::vector<PassPart> parts;
  for (std::vector<PassPart>& row : rows)
    std::move(row.begin(), row.end(), std::back_inserter(parts));
  return parts;
}

}  // namespace evenload
