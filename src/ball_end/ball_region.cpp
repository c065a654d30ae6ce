#include "ball_end/ball_region.h"

#include <algorithm>
#include <cmath>

namespace evenload {

namespace {

constexpr double kAngle = 1e-8;      // rad; 5e-8 mm on a ball of 10 mm
constexpr double kDepth = 1e-10;     // mm
constexpr double kFirstStep = 0.01;  // rad
constexpr int kBounds = 8;           // more than there are
constexpr int kMostSteps = 80;
constexpr double kProbe = 1e-6;   // rad, to see whether material lies ahead
constexpr double kChange = 1e-5;  // rad, of the place where another bound takes over
constexpr int kLooks = 12;        // on each side of the point of contact
constexpr double kGolden = 0.381966011250105;

}  // namespace

Material::Depth Material::depth(const Eigen::Vector3d& point) const {
  Depth least{allowance - surface->distance(point), 0};
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const double depth = passes[i].distance(point) - ball_radius;
    if (depth < least.depth) least = {depth, static_cast<int>(i) + 1};
  }
  return least;
}

Material::Depth BallRegion::depth(double a, const Eigen::Vector3d& across) const {
  return material_->depth(centre_ + material_->ball_radius *
                                        (std::sin(a) * frame_->feed + std::cos(a) * across));
}

// From a place out of material, the first that is found within on the way to the deepest; `from`
// where there is none.
double BallRegion::climb(double from, double step, const Eigen::Vector3d& across) const {
  double before = depth(from, across).depth;
  if (depth(from + kProbe, across).depth <= before) return from;
  double low = from, middle = from;
  // Until it falls again.
  double next = from + step;
  for (; next < kPi / 2; step *= 2, next += step) {
    const double found = depth(next, across).depth;
    if (found > 0) return next;
    if (found < before) break;
    low = middle;
    middle = next;
    before = found;
  }
  double high = std::min(next, kPi / 2);
  double x1 = low + kGolden * (high - low), x2 = high - kGolden * (high - low);
  double f1 = depth(x1, across).depth, f2 = depth(x2, across).depth;
  while (high - low > kProbe) {
    if (f1 > 0) return x1;
    if (f2 > 0) return x2;
    if (f1 > f2) {
      high = x2, x2 = x1, f2 = f1;
      x1 = low + kGolden * (high - low);
      f1 = depth(x1, across).depth;
    } else {
      low = x1, x1 = x2, f1 = f2;
      x2 = high - kGolden * (high - low);
      f2 = depth(x2, across).depth;
    }
  }
  return from;
}

// By the Illinois rule; `fi` and `fo` are the depths at the ends.
double BallRegion::root(double inside, double fi, double outside, double fo,
                        const Eigen::Vector3d& across) const {
  int side = 0;
  for (int i = 0; i < kMostSteps && std::abs(outside - inside) > kAngle; ++i) {
    const double x = inside + (outside - inside) * fi / (fi - fo);
    const double f = depth(x, across).depth;
    if (std::abs(f) < kDepth) return x;
    if (f > 0) {
      inside = x, fi = f;
      if (side == 1) fo /= 2;
      side = 1;
    } else {
      outside = x, fo = f;
      if (side == -1) fi /= 2;
      side = -1;
    }
  }
  return 0.5 * (inside + outside);
}

// Where material ends ahead of `inside`; from the end that was found last on.
double BallRegion::end_ahead(double inside, double fi, const Eigen::Vector3d& across) const {
  double step = kFirstStep, outside = last_end_ > inside ? last_end_ : inside + step;
  while (true) {
    outside = std::min(outside, kPi / 2);
    const double f = depth(outside, across).depth;
    if (f <= 0) {
      // The end may be much nearer.
      while (outside - inside > 2 * step) {
        const double nearer = depth(outside - step, across).depth;
        if (nearer > 0) return root(outside - step, nearer, outside, f, across);
        outside -= step;
        step *= 4;
      }
      return root(inside, fi, outside, depth(outside, across).depth, across);
    }
    inside = outside, fi = f;
    if (inside >= kPi / 2) return inside;
    outside += step;
    step *= 2;
  }
}

Interval BallRegion::interval(double b) const {
  const Eigen::Vector3d across = std::cos(b) * frame_->down + std::sin(b) * frame_->side;
  Interval found{least_, least_, 0};
  double inside = least_, fi = depth(least_, across).depth;
  if (fi <= 0) {
    inside = climb(least_, kFirstStep, across);
    if (inside == least_) return {};
    const double fo = fi;
    fi = depth(inside, across).depth;
    found.low = root(inside, fi, least_, fo, across);
    found.state = 1 + depth(found.low, across).bound;
  }
  found.high = last_end_ = end_ahead(inside, fi, across);
  found.state = kBounds * found.state + depth(found.high, across).bound;
  return found;
}

std::vector<double> state_changes(const std::function<int(double)>& state, double reach) {
  // Looks lie close to each other around the point of contact, where narrow material is.
  std::vector<double> changes;
  double before = -reach;
  int old = state(before);
  for (int i = 1 - kLooks; i <= kLooks; ++i) {
    const double share = static_cast<double>(i) / kLooks, b = reach * share * std::abs(share);
    const int now = state(b);
    double low = before;
    int at_low = old;
    // More than one change may lie between two looks.
    while (at_low != now && b - low > kChange) {
      double from = low, to = b;
      while (to - from > kChange) {
        const double middle = 0.5 * (from + to);
        (state(middle) == at_low ? from : to) = middle;
      }
      changes.push_back(0.5 * (from + to));
      low = to;
      at_low = state(to);
    }
    before = b;
    old = now;
  }
  return changes;
}

std::array<Node, kNodes> nodes_between(double from, double to) {
  static constexpr double kX[kNodes / 2] = {0.1488743389816312, 0.4333953941292472,
                                            0.6794095682990244, 0.8650633666889845,
                                            0.9739065285171717};
  static constexpr double kW[kNodes / 2] = {0.2955242247147529, 0.2692667193099963,
                                            0.2190863625159820, 0.1494513491505806,
                                            0.0666713443086881};
  static const auto unit = [] {
    // b = sin(pi x/2) makes roots at both ends smooth.
    std::array<Node, kNodes> result;
    for (std::size_t i = 0; i < kNodes / 2; ++i) {
      const double b = std::sin(kPi / 2 * kX[i]);
      const double weight = kPi / 2 * std::cos(kPi / 2 * kX[i]) * kW[i];
      result[kNodes / 2 - 1 - i] = {-b, weight};
      result[kNodes / 2 + i] = {b, weight};
    }
    return result;
  }();
  std::array<Node, kNodes> result;
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  for (std::size_t i = 0; i < kNodes; ++i)
    result[i] = {middle + half * unit[i].b, half * unit[i].weight};
  return result;
}

}  // namespace evenload
