// The method: from each vertex the farthest point is sought, by doubling and then halving the
// stride, that one piece reaches within the tolerance. The arcs through two given points are a
// family in the bulge; the signed distance of any point from the arc falls as the bulge grows, so
// that every side of the polyline leaves an interval of bulges, and their intersection is what
// fits.

#include "geometry/arc_fit.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace evenload {

namespace {

constexpr double kMostBulge = 1;   // half a circle: longer arcs are ill-conditioned by their ends
constexpr double kStraight = 0.1;  // share of the tolerance within which a line is preferred
constexpr double kSafety = 1 - 1e-6;  // of the tolerance, so that rounding does not exceed it

// The arcs from a to b by their bulge, in a frame with the chord along x, its middle at the origin,
// and y towards where arcs of positive bulge lie.
class Family {
 public:
  Family(Vec2 a, Vec2 b)
      : middle_(0.5 * (a + b)), along_(normalized(b - a)), half_(0.5 * distance(a, b)) {}

  double half() const { return half_; }
  Vec2 local(Vec2 q) const {
    const Vec2 d = q - middle_;
    return {dot(d, along_), cross(d, along_)};
  }

  struct Range {
    double low, high;
  };
  // Least and greatest signed distance from the arc, positive towards +y, over the side from p to
  // q.
  Range distances(Vec2 p, Vec2 q, double bulge) const {
    if (std::abs(bulge) < 1e-12) return {std::min(p.y, q.y), std::max(p.y, q.y)};
    const double centre = -half_ * (1 - bulge * bulge) / (2 * bulge);
    const double fp = signed_distance(p, centre, bulge), fq = signed_distance(q, centre, bulge);
    Range range{std::min(fp, fq), std::max(fp, fq)};
    // Where the side comes nearest to the centre the distance goes further still.
    const Vec2 d = q - p;
    const double t = dot(Vec2{0, centre} - p, d);
    if (t > 0 && t < squared_norm(d)) {
      const double f = signed_distance(p + t / squared_norm(d) * d, centre, bulge);
      range = {std::min(range.low, f), std::max(range.high, f)};
    }
    return range;
  }

 private:
  double signed_distance(Vec2 q, double centre, double bulge) const {
    const double power = q.x * q.x + q.y * q.y - half_ * half_ - 2 * q.y * centre;
    const double distances = std::hypot(q.x, q.y - centre) + std::hypot(half_, centre);
    return bulge > 0 ? power / distances : -power / distances;
  }

  Vec2 middle_, along_;
  double half_;
};

struct Interval {
  double low, high;
};

// The bulge at which `too_far` turns from true to false, or the other way round, between the two.
template <typename Test>
double boundary_between(double bad, double good, double resolution, Test&& too_far) {
  while (std::abs(good - bad) > resolution) {
    const double middle = 0.5 * (bad + good);
    (too_far(middle) ? bad : good) = middle;
  }
  return good;
}

class Fitter {
 public:
  Fitter(const std::vector<Vec2>& points, double tolerance)
      : points_(points), tolerance_(kSafety * tolerance) {}

  // One piece for the points `first` to `last`, if there is any. `heading`: where the piece before
  // ends.
  std::optional<Segment> fit(std::size_t first, std::size_t last,
                             std::optional<Vec2> heading) const {
    const Vec2 a = points_[first], b = points_[last];
    if (last == first + 1) return Segment::line(a, b);
    if (a == b) return std::nullopt;
    const Family family(a, b);
    const std::optional<Interval> bulges = fitting_bulges(family, first, last);
    if (!bulges) return std::nullopt;
    if (straight(family, first, last)) return Segment::line(a, b);
    std::vector<double> wishes{0.5 * (bulges->low + bulges->high)};
    if (heading) {
      // An arc starts at half its included angle to the right of its chord.
      const double aside = std::atan2(cross(*heading, b - a), dot(*heading, b - a));
      const double wish = std::tan(std::clamp(aside / 2, -kPi / 4, kPi / 4));
      wishes.insert(wishes.begin(), std::clamp(wish, bulges->low, bulges->high));
    }
    for (const double bulge : wishes) {
      const Segment s = Segment::from_bulge(a, b, bulge);
      if (follows(family, s, first, last)) return s;
    }
    return std::nullopt;
  }

 private:
  std::optional<Interval> fitting_bulges(const Family& family, std::size_t first,
                                         std::size_t last) const {
    Interval bulges{-kMostBulge, kMostBulge};
    const double resolution = 1e-3 * std::min(1.0, tolerance_ / family.half());
    Vec2 p = family.local(points_[first]);
    for (std::size_t i = first + 1; i <= last; ++i) {
      const Vec2 q = family.local(points_[i]);
      if (std::abs(q.x) > family.half() + tolerance_) return std::nullopt;
      const auto above = [&](double bulge) {
        return family.distances(p, q, bulge).high > tolerance_;
      };
      const auto below = [&](double bulge) {
        return family.distances(p, q, bulge).low < -tolerance_;
      };
      if (above(bulges.high) || below(bulges.low)) return std::nullopt;
      if (above(bulges.low))
        bulges.low = boundary_between(bulges.low, bulges.high, resolution, above);
      if (below(bulges.high))
        bulges.high = boundary_between(bulges.high, bulges.low, resolution, below);
      if (bulges.low > bulges.high) return std::nullopt;
      p = q;
    }
    return bulges;
  }

  bool straight(const Family& family, std::size_t first, std::size_t last) const {
    double reached = -family.half();
    for (std::size_t i = first + 1; i < last; ++i) {
      const Vec2 q = family.local(points_[i]);
      if (std::abs(q.y) > kStraight * tolerance_ || q.x < reached) return false;
      reached = q.x;
    }
    return reached <= family.half();
  }

  // Whether the piece passes all sides within the tolerance, in their order; the intervals alone do
  // not make sure of that where the polyline goes back. Sides that stay that near a circle not much
  // smaller than the tolerance keep off its centre, so that every point of the arc is the nearest
  // to some point of a side, and thus near the polyline too.
  bool follows(const Family& family, const Segment& s, std::size_t first, std::size_t last) const {
    if (s.is_arc() && s.radius < 2 * tolerance_) return false;
    const double length = s.length(), bulge = s.bulge();
    double reached = 0;
    Vec2 p = family.local(points_[first]);
    for (std::size_t i = first + 1; i <= last; ++i) {
      const Vec2 q = family.local(points_[i]);
      const Family::Range off = family.distances(p, q, bulge);
      if (off.low < -tolerance_ || off.high > tolerance_) return false;
      const double t = s.nearest(points_[i]);
      if (distance(s.point(t), points_[i]) > tolerance_ || t * length < reached - tolerance_)
        return false;
      reached = std::max(reached, t * length);
      p = q;
    }
    return true;
  }

  const std::vector<Vec2>& points_;
  double tolerance_;
};

}  // namespace

Curve fit_arcs(const std::vector<Vec2>& points, double tolerance) {
  if (points.size() < 2) throw std::invalid_argument("Fitting arcs takes at least two points.");
  if (!(tolerance > 0)) throw std::invalid_argument("Fitting arcs takes a tolerance above 0.");
  std::vector<Vec2> apart{points[0]};
  for (const Vec2 p : points)
    if (p != apart.back()) apart.push_back(p);
  if (apart.size() == 1) return Curve({{points[0]}, {points[0]}}, false);

  const Fitter fitter(apart, tolerance);
  std::vector<Vertex> vertices;
  std::optional<Vec2> heading;
  for (std::size_t first = 0; first + 1 < apart.size();) {
    std::size_t good = first + 1, bad = apart.size();
    Segment piece = *fitter.fit(first, good, heading);
    for (std::size_t stride = 2; good < bad - 1;) {
      const std::size_t last = std::min(first + stride, apart.size() - 1);
      const std::optional<Segment> longer = fitter.fit(first, last, heading);
      if (longer) {
        good = last;
        piece = *longer;
        stride *= 2;
      } else {
        bad = last;
        break;
      }
    }
    while (bad - good > 1) {
      const std::size_t middle = good + (bad - good) / 2;
      const std::optional<Segment> longer = fitter.fit(first, middle, heading);
      if (longer) {
        good = middle;
        piece = *longer;
      } else {
        bad = middle;
      }
    }
    vertices.push_back({piece.a, piece.bulge()});
    heading = piece.tangent(1);
    first = good;
  }
  vertices.push_back({apart.back()});
  return Curve(std::move(vertices), false);
}

}  // namespace evenload
