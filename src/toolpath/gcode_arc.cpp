#include "toolpath/gcode_arc.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "toolpath/gcode.h"

namespace evenload {
namespace {

// mm by which the two radii may differ, whatever they are: LinuxCNC's and grbl's figure. Three
// decimals in mm and four in inches stay below it. The same for an R below half the chord.
constexpr double kRadiusSlack = 0.005;
// Share of the radius that they may differ by beyond that, likewise.
constexpr double kRelativeRadiusSlack = 1e-3;
// mm that they may never differ by, likewise.
constexpr double kLargestRadiusSlack = 0.5;
// rad: a sweep below it is a full turn whose end was rounded, LinuxCNC's and grbl's view too.
constexpr double kCircleFuzz = 1e-6;
// mm: a thousandth of the last digit that any post writes.
constexpr double kNoLength = 1e-7;
// Share of half a turn that a piece may have beyond it: rounding must not make two of one.
constexpr double kHalfTurnSlack = 1e-9;

std::string millimetres(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4f mm", value);
  return text;
}

[[noreturn]] void fail_on_zero_radius(int line) {
  throw GCodeError(line, "the arc's radius is zero: give its centre by I, J, K or its R.");
}

}  // namespace

double GCodeArc::length() const { return std::abs(sweep) * (from_radius + to_radius) / 2; }

Vec2 GCodeArc::point(double t) const {
  if (t <= 0) return start;
  if (t >= 1) return end;
  const double radius = from_radius + (to_radius - from_radius) * t;
  return centre + radius * unit(angle_of(start - centre) + sweep * t);
}

GCodeArc arc_by_centre(Vec2 start, Vec2 end, Vec2 centre, bool counter_clockwise, int turns,
                       int line) {
  GCodeArc arc{start, end, centre, distance(start, centre), distance(end, centre), 0};
  const double off = std::abs(arc.from_radius - arc.to_radius);
  if (std::min(arc.from_radius, arc.to_radius) < kNoLength) fail_on_zero_radius(line);
  if (off > kLargestRadiusSlack ||
      (off > kRadiusSlack && off > kRelativeRadiusSlack * arc.from_radius))
    throw GCodeError(line, "the arc's centre is " + millimetres(arc.from_radius) +
                               " from its start but " + millimetres(arc.to_radius) +
                               " from its end: check I, J, K and G90.1 or G91.1.");
  const double turned = angle_of(end - centre) - angle_of(start - centre);
  double sweep = wrap_positive(counter_clockwise ? turned : -turned);
  if (sweep < kCircleFuzz) sweep += 2 * kPi;
  sweep += 2 * kPi * (turns - 1);
  arc.sweep = counter_clockwise ? sweep : -sweep;
  return arc;
}

GCodeArc arc_by_radius(Vec2 start, Vec2 end, double radius, bool counter_clockwise, int turns,
                       int line) {
  const double half = distance(start, end) / 2;
  const double size = std::abs(radius);
  if (size < kNoLength) fail_on_zero_radius(line);
  if (half < kNoLength)
    throw GCodeError(line, "an arc that ends where it starts has no centre by R: give I, J or K.");
  if (half > size + kRadiusSlack)
    throw GCodeError(line, "the arc's ends are " + millimetres(2 * half) +
                               " apart, too far for R of " + millimetres(size) + ".");
  const double r = std::max(size, half);
  const double minor = 2 * std::asin(std::min(1.0, half / r));
  double sweep = radius > 0 ? minor : 2 * kPi - minor;
  // The centre lies to the left of the chord when a short arc turns left or a long one right.
  const double side = (radius > 0) == counter_clockwise ? 1 : -1;
  const double height = std::sqrt(std::max(0.0, (r - half) * (r + half)));
  const Vec2 centre = 0.5 * (start + end) + side * height * left_normal((end - start) / (2 * half));
  sweep += 2 * kPi * (turns - 1);
  return {start, end, centre, r, r, counter_clockwise ? sweep : -sweep};
}

std::vector<ArcPiece> pieces_of(const GCodeArc& arc) {
  const int n =
      std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / kPi * (1 - kHalfTurnSlack))));
  const double sweep = arc.sweep / n;
  std::vector<ArcPiece> pieces;
  Vec2 from = arc.start;
  for (int i = 1; i <= n; ++i) {
    const double share = static_cast<double>(i) / n;
    const Vec2 to = i == n ? arc.end : arc.point(share);
    // The ends and the sweep are kept; they leave one centre, on the chord's bisector. A chord of
    // rounding alone (two ends that nearly meet after a whole turn) never comes here: the turn is
    // split.
    const Vec2 chord = to - from;
    const Vec2 centre = 0.5 * (from + to) + 0.5 / std::tan(sweep / 2) * left_normal(chord);
    pieces.push_back({to, centre, sweep, share});
    from = to;
  }
  return pieces;
}

double chords_of(const GCodeArc& arc, double tolerance) {
  const double radius = std::max(arc.from_radius, arc.to_radius);
  const double half_angle = 2 * std::asin(std::sqrt(std::min(1.0, tolerance / radius / 2)));
  // At least two a quarter turn, so that small circles stay round.
  return std::ceil(std::abs(arc.sweep) / std::min(2 * half_angle, kPi / 4));
}

}  // namespace evenload
