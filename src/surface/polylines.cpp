#include "surface/polylines.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "geometry/arc_fit.h"
#include "support/parallel.h"

namespace evenload {

namespace {

constexpr double kJoined = 1e-6;               // mm: ends of pieces that are as near are one place
constexpr double kStraightOn = 0.5 * kChords;  // mm: corners that lie as near to a line are none
constexpr std::size_t kLeastLines = 4;         // in whose place an arc is worth it
// mm: of arcs that any control reads, and that no rounding of their centres makes others.
constexpr double kLeastRadius = 0.25, kLargestRadius = 1000;

bool is_same(SpacePoint a, SpacePoint b) { return distance(a, b) < kJoined; }

// A line or an arc of a way in plan.
struct Piece {
  PlanLine line;
  double length;  // mm
};

bool is_worth_an_arc(const Segment& segment, std::size_t lines) {
  return segment.is_arc() && lines >= kLeastLines && segment.radius >= kLeastRadius &&
         segment.radius <= kLargestRadius;
}

void add_line(Vec2 from, Vec2 to, std::vector<Piece>& pieces) {
  const double length = norm(to - from);
  if (length > kSamePlace) pieces.push_back({{from, (to - from) / length}, length});
}

// mm from a place to the line between two others, its ends included.
double off_line(Vec2 place, Vec2 from, Vec2 to) {
  const Vec2 way = to - from;
  const double square = squared_norm(way);
  const double share = square > 0 ? std::clamp(dot(place - from, way) / square, 0.0, 1.0) : 0;
  return norm(place - (from + share * way));
}

// Adds lines from one corner to a later one, without those between that lie within kStraightOn of
// the lines [Douglas, Peucker 1973]: each corner of a pass is a move, also where the ground is
// plane.
void add_lines(const std::vector<Vec2>& corners, std::size_t first, std::size_t last,
               std::vector<Piece>& pieces) {
  std::vector<std::size_t> ends{last};  // of lines that are still to come, the nearest one's last
  for (std::size_t from = first; !ends.empty();) {
    const std::size_t to = ends.back();
    double farthest = kStraightOn;
    std::size_t aside = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double off = off_line(corners[i], corners[from], corners[to]);
      if (off <= farthest) continue;
      farthest = off;
      aside = i;
    }
    if (aside != from) {
      ends.push_back(aside);
      continue;
    }
    add_line(corners[from], corners[to], pieces);
    from = to;
    ends.pop_back();
  }
}

// The pieces of a polyline, with `arcs` in place of many short lines.
std::vector<Piece> pieces_of(const Polyline& polyline, bool arcs) {
  std::vector<Vec2> corners;
  for (const Vec2 corner : polyline.corners)
    if (corners.empty() || norm(corner - corners.back()) > kSamePlace) corners.push_back(corner);
  if (polyline.is_closed && corners.size() > 1 &&
      norm(corners.front() - corners.back()) > kSamePlace)
    corners.push_back(corners.front());
  std::vector<Piece> pieces;
  if (corners.size() < 2) return pieces;
  std::size_t at = 0, since = 0;  // `since`: the corner to which there are pieces
  const std::vector<Segment> segments =
      arcs ? fit_arcs(corners, kChords).segments() : std::vector<Segment>{};
  for (const Segment& segment : segments) {
    const std::size_t begin = at++;
    while (at + 1 < corners.size() && corners[at] != segment.b) ++at;
    if (!is_worth_an_arc(segment, at - begin)) continue;
    add_lines(corners, since, begin, pieces);
    pieces.push_back({{segment.a, segment.tangent(0), segment.curvature()}, segment.length()});
    since = at;
  }
  add_lines(corners, since, corners.size() - 1, pieces);
  return pieces;
}

// The pieces that are cut along one line.
std::vector<PassPart> along(const Ground& ground, const Polyline& polyline, std::size_t row,
                            const FinishParams& params) {
  const double tolerance = params.tolerance;
  std::vector<PassPart> parts;
  for (const auto& [line, length] : pieces_of(polyline, params.arcs)) {
    const std::vector<DropSample> samples = samples_along(ground, line, 0, length, tolerance);
    for (const std::vector<DropSample>& part : parts_at_work(ground, line, samples)) {
      std::vector<Waypoint> points = lines_of(line, part, tolerance, LineEnds::kFixed);
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
  std::vector<Waypoint>& last = parts.back().points;
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
          std::vector<PassPart> parts = along(ground, polyline, row, params);
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
