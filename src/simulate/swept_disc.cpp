#include "simulate/swept_disc.h"

#include <algorithm>
#include <cmath>

namespace evenload {
namespace {

// mm: intervals this near are one; rounding at the seams between discs and sectors is far smaller.
constexpr double kSeam = 1e-9;

// Half of the chord that a row at distance `d` from the centre cuts from a circle; negative where
// it misses.
double half_chord(double radius, double d) {
  const double square = (radius - d) * (radius + d);
  return square >= 0 ? std::sqrt(square) : -1;
}

// Widens [low, high] by where the line from a to b crosses the row.
void widen(Vec2 a, Vec2 b, double y, double& low, double& high) {
  if ((a.y < y) == (b.y < y)) return;
  const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
  low = std::min(low, x);
  high = std::max(high, x);
}

}  // namespace

SweptDisc::SweptDisc(const Segment& path, double radius) : path_(path), radius_(radius) {
  if (path.is_arc()) {
    first_ = unit(path.start_angle);
    last_ = unit(path.start_angle + path.sweep);
    if (path.sweep < 0) std::swap(first_, last_);
  } else if (path.a != path.b) {
    side_ = radius * left_normal(normalized(path.b - path.a));
  }
}

Bounds SweptDisc::bounds() const {
  const Bounds box = path_.bounds();
  return {{box.low.x - radius_, box.low.y - radius_}, {box.high.x + radius_, box.high.y + radius_}};
}

int SweptDisc::on_row(double y, Interval (&out)[kMostIntervals]) const {
  return path_.is_arc() ? arc_on_row(y, out) : line_on_row(y, out);
}

int SweptDisc::line_on_row(double y, Interval (&out)[kMostIntervals]) const {
  double low = 1e300, high = -1e300;
  for (const Vec2 end : {path_.a, path_.b}) {
    const double half = half_chord(radius_, y - end.y);
    if (half < 0) continue;
    low = std::min(low, end.x - half);
    high = std::max(high, end.x + half);
  }
  widen(path_.a + side_, path_.b + side_, y, low, high);
  widen(path_.a - side_, path_.b - side_, y, low, high);
  if (!(high > low)) return 0;
  out[0] = {low, high};
  return 1;
}

int SweptDisc::arc_on_row(double y, Interval (&out)[kMostIntervals]) const {
  int count = 0;
  const auto add = [&](double low, double high) {
    if (high > low) out[count++] = {low, high};
  };
  for (const Vec2 end : {path_.a, path_.b}) {
    const double half = half_chord(radius_, y - end.y);
    if (half > 0) add(end.x - half, end.x + half);
  }
  // The sector of the ring: within its outer circle, between its ends' rays, outside its inner one.
  const double dy = y - path_.centre.y, outer = half_chord(path_.radius + radius_, dy);
  if (outer > 0) {
    double low = -outer, high = outer;  // about the centre
    // cross(first, q) >= 0 and cross(q, last) >= 0
    const auto clip = [&](double slope, double limit) {  // slope x <= limit
      if (slope > 0)
        high = std::min(high, limit / slope);
      else if (slope < 0)
        low = std::max(low, limit / slope);
      else if (limit < 0)
        high = low - 1;
    };
    clip(first_.y, first_.x * dy);
    clip(-last_.y, -last_.x * dy);
    const double x = path_.centre.x;
    const double inner = path_.radius > radius_ ? half_chord(path_.radius - radius_, dy) : -1;
    if (inner > 0) {
      add(x + low, x + std::min(high, -inner));
      add(x + std::max(low, inner), x + high);
    } else {
      add(x + low, x + high);
    }
  }
  std::sort(out, out + count, [](const Interval& a, const Interval& b) { return a.low < b.low; });
  int joined = 0;
  for (int i = 1; i < count; ++i) {
    if (out[i].low <= out[joined].high + kSeam)
      out[joined].high = std::max(out[joined].high, out[i].high);
    else
      out[++joined] = out[i];
  }
  return count == 0 ? 0 : joined + 1;
}

Segment mirrored(const Segment& path) {
  const auto swap = [](Vec2 p) { return Vec2{p.y, p.x}; };
  Segment result = path;
  result.a = swap(path.a);
  result.b = swap(path.b);
  result.centre = swap(path.centre);
  result.sweep = -path.sweep;
  result.start_angle = kPi / 2 - path.start_angle;
  return result;
}

}  // namespace evenload
