// The method: the largest circle of the flattened region stands on a vertex of its Voronoi diagram.
// The best vertices are moved uphill, by exact distances to the pieces around, until they stand
// still; of equals the first is taken.

#include <algorithm>
#include <array>
#include <stdexcept>

#include "geometry/boundary_index.h"
#include "geometry/medial_axis.h"
#include "geometry/voronoi.h"

namespace evenload {

namespace {

constexpr std::size_t kClimbs = 64;  // starts far apart that are tried; more hills of one height,
                                     // within the tolerance, are rare
constexpr double kEqual =
    1e-7;  // mm: radii and coordinates nearer than this are equal; rounding reaches 1e-9
constexpr double kFinest =
    1e-5;  // of the extent: flattening finer than this costs time and climbing makes up for it

constexpr double kGain = 1e-12;  // mm: what rounding may feign

struct Slope {
  double height = 0;  // mm, the distance to one piece
  Vec2 up;            // unit vector away from it
};

// The step, no longer than `reach` along x and y, that raises the least of the slopes most. With
// few slopes it is found by trying all corners of the linear programme.
Vec2 best_step(const std::vector<Slope>& slopes, double reach) {
  const auto lowest = [&](Vec2 step) {
    double least = slopes[0].height + dot(slopes[0].up, step);
    for (const Slope& s : slopes) least = std::min(least, s.height + dot(s.up, step));
    return least;
  };
  Vec2 best;
  double best_height = lowest(best);
  const auto offer = [&](Vec2 step) {
    if (!(std::max(std::abs(step.x), std::abs(step.y)) <= reach * (1 + 1e-12))) return;
    const double height = lowest(step);
    if (height > best_height + kGain) {
      best_height = height;
      best = step;
    }
  };
  const std::size_t n = slopes.size();
  // Short steps come first: on a ridge of one height others along it are as good.
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      // Steps at which i and k stay level: step . across = rise.
      const Vec2 across = slopes[i].up - slopes[k].up;
      const double rise = slopes[k].height - slopes[i].height;
      if (squared_norm(across) == 0) continue;
      offer(rise / squared_norm(across) * across);
      for (std::size_t j = 0; j < k; ++j) {
        const Vec2 other = slopes[i].up - slopes[j].up;
        const double other_rise = slopes[j].height - slopes[i].height;
        const double determinant = cross(across, other);
        if (std::abs(determinant) > 1e-14)
          offer({(rise * other.y - other_rise * across.y) / determinant,
                 (across.x * other_rise - other.x * rise) / determinant});
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    offer(reach * slopes[i].up);
    for (std::size_t k = 0; k < i; ++k) {
      const Vec2 across = slopes[i].up - slopes[k].up;
      const double rise = slopes[k].height - slopes[i].height;
      for (const double side : {-reach, reach}) {
        if (across.y != 0) offer({side, (rise - across.x * side) / across.y});
        if (across.x != 0) offer({(rise - across.y * side) / across.x, side});
      }
    }
  }
  for (const double x : {-reach, reach})
    for (const double y : {-reach, reach}) offer({x, y});
  return best;
}

class Climber {
 public:
  Climber(const Region& region, const BoundaryIndex& boundary) : boundary_(boundary) {
    for (const Curve& curve : region.curves())
      for (const Segment& s : curve.segments()) pieces_.push_back(s);
  }

  // `reach`: how far the top may lie, mm.
  Circle climb(Vec2 start, double reach) const {
    Circle here{start, boundary_.nearest(start).distance};
    std::vector<const Segment*> near;
    for (const Segment& s : pieces_)
      if (s.distance_to(start) <= here.radius + 8 * reach) near.push_back(&s);
    std::vector<Slope> slopes;
    for (double step = reach; step > 1e-12 * (1 + here.radius);) {
      slopes.clear();
      for (const Segment* s : near) add_slope(slopes, *s, here, step);
      if (slopes.empty()) break;
      const Vec2 to = here.centre + best_step(slopes, step);
      const double radius = boundary_.contains(to) ? boundary_.nearest(to).distance : 0.0;
      if (radius > here.radius + kGain)
        here = {to, radius};
      else
        step *= 0.25;
    }
    return here;
  }

 private:
  static void add_slope(std::vector<Slope>& slopes, const Segment& s, const Circle& here,
                        double step) {
    constexpr std::size_t kMost = 12;  // the lowest are kept
    const Vec2 foot = s.point(s.nearest(here.centre));
    const double height = distance(foot, here.centre);
    if (height > here.radius + 3 * step || height == 0) return;
    const Slope slope{height, (here.centre - foot) / height};
    auto place =
        std::upper_bound(slopes.begin(), slopes.end(), slope,
                         [](const Slope& a, const Slope& b) { return a.height < b.height; });
    slopes.insert(place, slope);
    if (slopes.size() > kMost) slopes.pop_back();
  }

  const BoundaryIndex& boundary_;
  std::vector<Segment> pieces_;
};

}  // namespace

Circle largest_circle(const Region& region, double tolerance) {
  if (!(tolerance > 0))
    throw std::invalid_argument("The largest circle needs a tolerance above 0.");
  const BoundaryIndex boundary(region.curves());
  const Bounds box = bounds_of({region});
  const double extent = distance(box.low, box.high);
  const double flattening = std::max(0.25 * tolerance, kFinest * extent);
  const InnerVoronoi voronoi = inner_voronoi(region, boundary, flattening);

  std::vector<Circle> starts;
  double best = 0;
  for (const Vec2 p : voronoi.vertices) {
    starts.push_back({p, boundary.contains(p) ? boundary.nearest(p).distance : 0.0});
    best = std::max(best, starts.back().radius);
  }
  std::erase_if(starts, [&](const Circle& c) { return c.radius < best - 4 * flattening; });
  if (starts.empty()) return {0.5 * (box.low + box.high), 0};
  std::sort(starts.begin(), starts.end(),
            [](const Circle& a, const Circle& b) { return a.radius > b.radius; });

  const Climber climber(region, boundary);
  const double reach = std::min(8 * flattening, best);
  std::vector<Circle> tops;
  std::vector<Vec2> tried;
  for (const Circle& c : starts) {
    const bool known = std::any_of(tried.begin(), tried.end(),
                                   [&](Vec2 p) { return distance(p, c.centre) < 0.05 * best; });
    if (known || tried.size() >= kClimbs) continue;
    tried.push_back(c.centre);
    tops.push_back(climber.climb(c.centre, reach));
  }
  double top = 0;
  for (const Circle& c : tops) top = std::max(top, c.radius);

  // The first of all equal ones, which may stand beside those tried: on a ridge of one height.
  // Nearly equal x count as equal.
  std::sort(starts.begin(), starts.end(), [](const Circle& a, const Circle& b) {
    return a.centre.x != b.centre.x ? a.centre.x < b.centre.x : a.centre.y < b.centre.y;
  });
  double last_x = starts.back().centre.x;
  tried.clear();
  for (const Circle& start : starts) {
    if (start.centre.x > last_x || tried.size() >= kClimbs) break;
    const bool known = std::any_of(tried.begin(), tried.end(),
                                   [&](Vec2 p) { return distance(p, start.centre) < flattening; });
    if (known) continue;
    tried.push_back(start.centre);
    const Circle c = climber.climb(start.centre, reach);
    tops.push_back(c);
    if (c.radius >= top - kEqual) last_x = std::min(last_x, start.centre.x + 10 * kEqual);
  }
  for (const Circle& c : tops) top = std::max(top, c.radius);
  std::erase_if(tops, [&](const Circle& c) { return c.radius < top - kEqual; });
  Circle first = tops[0];
  for (const Circle& c : tops) {
    const double dx = c.centre.x - first.centre.x;
    if (dx < -kEqual || (dx < kEqual && c.centre.y < first.centre.y)) first = c;
  }
  return first;
}

double largest_tool(const std::vector<Region>& regions) {
  constexpr double kTolerance = 1e-4;  // mm: a tenth of what a tool's diameter is known to
  double radius = 0;
  for (const Region& region : regions)
    radius = std::max(radius, largest_circle(region, kTolerance).radius);
  return 2 * radius;
}

}  // namespace evenload
