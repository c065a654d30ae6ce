#include "geometry/curve_looks.h"

#include <algorithm>
#include <cmath>

namespace evenload {
namespace {

// Looks along each arc, nearly.
constexpr double kLooks = 5;
// An arc leaves a curve whose curvature changes by c per mm^2 by c length^3 / kGain mm, where arcs
// as long come before and after it.
constexpr double kGain = 125;
// A look is taken again, nearer, where it lies so much farther than it should, at this share of the
// step; and steps grow by no more than this.
constexpr double kTooFar = 1.5, kNearer = 0.6, kGrow = 1.4;
// Shares of the largest step of the parameter: the closest looks, and the one that tells the
// curvature at the beginning.
constexpr double kClosest = 1e-4, kBeside = 1e-3;
// Arcs are as short as the curve demands so near to them, as a share of their length.
constexpr double kNear = 0.25;
constexpr double kNoTurn = 1e-6;  // rad: the length of such arcs is that of their chords

double turn_between(const PlanePoint& a, const PlanePoint& b) {
  return std::atan2(cross(a.direction, b.direction), dot(a.direction, b.direction));
}

// mm: of an arc between the two.
double length_between(const PlanePoint& a, const PlanePoint& b, double turn) {
  const double half = 0.5 * turn, chord = distance(a.p, b.p);
  return std::abs(half) > kNoTurn ? chord * half / std::sin(half) : chord;
}

double bend_between(const PlanePoint& a, const PlanePoint& b) {
  const double turn = turn_between(a, b);
  return turn / length_between(a, b, turn);
}

}  // namespace

double arcs_per_mm(double change, double tolerance) {
  return std::cbrt(change / (kGain * tolerance));
}

CurveLooks::CurveLooks(const CurvePlace& place, double end, double most_step, double tolerance) {
  const PlanePoint begin = place(0);
  looks_.push_back({0, begin});
  const double farthest = most_step / 3, least = kClosest * most_step;
  double step = 0.5 * farthest, last_length = 0;  // of the parameter; mm
  double bend = bend_between(begin, place(std::min(end, kBeside * most_step)));
  while (back().u < end) {
    const double to = end - (back().u + step) < least ? end : back().u + step;
    const PlanePoint at = place(to);
    const double turn = turn_between(back().at, at), length = length_between(back().at, at, turn);
    const double change = std::abs(turn / length - bend) / (0.5 * (length + last_length));
    const double looks = kLooks * arcs_per_mm(change, tolerance) * length;  // that should be here
    if (looks > kTooFar && step > least) {
      step *= kNearer;
      continue;
    }
    add(to, at);
    bend = turn / length;
    last_length = length;
    step = std::min(farthest, step / std::clamp(looks, 1 / kGrow, 1 / kNearer));
  }
}

void CurveLooks::add(double u, const PlanePoint& at) {
  looks_.push_back(between(looks_.size() - 1, u, at));
}

double CurveLooks::u_at(double along, std::size_t i) const {
  const CurveLook &low = looks_[i], &high = looks_[i + 1];
  return low.u + (high.u - low.u) * (along - low.along) / (high.along - low.along);
}

CurveLook CurveLooks::between(std::size_t i, double u, const PlanePoint& at) const {
  const CurveLook& before = looks_[i];
  CurveLook here{u, at};
  const double turn = turn_between(before.at, at);
  here.along = before.along + length_between(before.at, at, turn);
  here.heading = before.heading + turn;
  here.sum = sum_at(i, here);
  return here;
}

// The mean heading of a short way is that of its chord.
double CurveLooks::sum_at(std::size_t i, const CurveLook& to) const {
  const CurveLook& from = looks_[i];
  const Vec2 chord = to.at.p - from.at.p;
  const double aside = std::atan2(cross(from.at.direction, chord), dot(from.at.direction, chord));
  return from.sum + (to.along - from.along) * (from.heading + aside);
}

ArcDemand::ArcDemand(const CurveLooks& looks, double most_step, double tolerance) : looks_(looks) {
  const std::size_t n = looks.size() - 1;
  const auto curvature = [&](std::size_t i) {
    const CurveLook &low = looks[i == 0 ? 0 : i - 1], &high = looks[std::min(n, i + 1)];
    return (high.heading - low.heading) / (high.along - low.along);
  };
  std::vector<double> per_mm(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double change = std::abs(curvature(i + 1) - curvature(i));
    per_mm[i] = arcs_per_mm(change / (looks[i + 1].along - looks[i].along), tolerance);
  }
  arcs_.push_back(0);
  for (std::size_t i = 0; i < n; ++i) {
    const double middle = 0.5 * (looks[i].along + looks[i + 1].along);
    double most = per_mm[i];
    for (std::size_t j = i + 1; j < n && (looks[j].along - middle) * most < kNear; ++j)
      most = std::max(most, per_mm[j]);
    for (std::size_t j = i; j-- > 0 && (middle - looks[j + 1].along) * most < kNear;)
      most = std::max(most, per_mm[j]);
    const double least = (looks[i + 1].u - looks[i].u) / most_step;
    arcs_.push_back(arcs_.back() + std::max(least, most * (looks[i + 1].along - looks[i].along)));
  }
}

double ArcDemand::at(std::size_t i, const CurveLook& on) const {
  const double length = looks_[i + 1].along - looks_[i].along;
  return arcs_[i] + (arcs_[i + 1] - arcs_[i]) * (on.along - looks_[i].along) / length;
}

double ArcDemand::along(double arcs, std::size_t& look) const {
  while (look + 2 < arcs_.size() && arcs_[look + 1] <= arcs) ++look;
  const double share = (arcs - arcs_[look]) / (arcs_[look + 1] - arcs_[look]);
  return looks_[look].along + share * (looks_[look + 1].along - looks_[look].along);
}

}  // namespace evenload
