// The method: what lies aside of a curve by e(s) mm after s mm has the curvature k + e'' there,
// next to nothing else. Tangent arcs have a curvature that is constant piece by piece; so e plus
// the curve's curvature integrated twice is a parabola on each piece, with a continuous slope, and
// to seek arcs near the curve is to fit a quadratic spline by least squares. Pairs of arcs that
// begin and end where the curve itself does, in its directions, would leave it by three times as
// much.

#include "geometry/tangent_arcs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace evenload {
namespace {

// Looks at the curve along each arc, and along those of the first pairs.
constexpr int kLooks = 6, kFirstLooks = 3;
// Of the tolerance: between the looks it may be a little more.
constexpr double kSafety = 0.9;
// An arc leaves a curve whose curvature changes by c per mm^2 by c length^3 / kGain mm, where arcs
// as long come before and after it.
constexpr double kGain = 125;
// Arcs are as short as the curve demands so near to them, as a share of their length.
constexpr double kNear = 0.5;
// Rounds in which arcs are made shorter where they leave the curve by too much, by a little more
// than is thought to do, and by how much at most; in the first of them they are made longer where
// they leave it by less than a share of that, carefully.
constexpr int kRounds = 16, kLongerRounds = 4;
constexpr double kMore = 1.02, kMuchMore = 1.05, kShortest = 1.5;
constexpr double kLittle = 0.8, kLongest = 0.85, kLongerPower = 0.3;
// The first pairs, along the curve: shares of the step before.
constexpr double kShrink = 0.7, kGrow = 1.3;
// Of the curve's parameter: shorter pieces are taken as they are.
constexpr double kLeastStep = 1e-4;
// Tolerances: of a pair that does not exist.
constexpr double kHopeless = 1e9;
// Ends are kept to so many times as well as places between them.
constexpr double kEndWeight = 1e6;

using Place = std::function<PlanePoint(double)>;

double deviation(const BiArc& pair, const std::vector<PlanePoint>& looks, std::size_t first,
                 std::size_t last) {
  double worst = 0;
  for (std::size_t i = first; i < last; ++i)
    worst = std::max(
        worst, std::min(pair.first.distance_to(looks[i].p), pair.second.distance_to(looks[i].p)));
  return worst;
}

// Pairs of arcs that begin and end on the curve, in its directions, one after the other.
TangentArcs pairs_on(const Place& place, double end, double most_step, double tolerance) {
  TangentArcs arcs;
  double from = 0, step = 0.5 * most_step;
  PlanePoint here = place(0);
  while (from < end) {
    const double to = end - (from + step) < kLeastStep ? end : from + step;
    const PlanePoint there = place(to);
    const std::optional<BiArc> pair = bi_arc(here, there, kPi);
    std::vector<PlanePoint> looks;
    for (int i = 1; i < kLooks; ++i) looks.push_back(place(from + i * (to - from) / kLooks));
    if (step > kLeastStep && (!pair || deviation(*pair, looks, 0, looks.size()) > tolerance)) {
      step *= kShrink;
      continue;
    }
    arcs.moves.push_back(pair ? pair->first : Segment::line(here.p, there.p));
    arcs.until.push_back(pair ? 0.5 * (from + to) : to);
    if (pair) {
      arcs.moves.push_back(pair->second);
      arcs.until.push_back(to);
    }
    here = there;
    from = to;
    step = std::min(most_step, step * kGrow);
  }
  return arcs;
}

double turn_between(const PlanePoint& a, const PlanePoint& b) {
  return std::atan2(cross(a.direction, b.direction), dot(a.direction, b.direction));
}

// How many arcs there are to be, per parameter, on small pieces of the curve.
struct Density {
  std::vector<double> ends;  // of the pieces, the curve's beginning among them
  std::vector<double> arcs;
};

// `until`: where arcs end that are near the curve, which tells how closely to look.
Density first_density(const Place& place, const std::vector<double>& until, double most_step,
                      double allowed) {
  Density density{{0}, {}};
  std::vector<double> along{0}, curvature;
  PlanePoint last = place(0);
  for (const double to : until)
    for (int i = kFirstLooks - 1; i >= 0; --i) {
      const double share = 1.0 / (i + 1), from = density.ends.back();
      density.ends.push_back(i == 0 ? to : from + share * (to - from));
      const PlanePoint here = place(density.ends.back());
      along.push_back(along.back() + distance(here.p, last.p));
      curvature.push_back(turn_between(last, here) / distance(here.p, last.p));
      last = here;
    }
  const std::size_t n = curvature.size();
  const auto middle = [&](std::size_t i) { return 0.5 * (along[i] + along[i + 1]); };
  std::vector<double> per_mm(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t low = i == 0 ? 0 : i - 1, high = std::min(n - 1, i + 1);
    const double change = std::abs(curvature[high] - curvature[low]) / (middle(high) - middle(low));
    per_mm[i] = std::max(std::cbrt(change / (kGain * allowed)), 1e-9);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double reach = kNear / per_mm[i];
    double most = per_mm[i];
    for (std::size_t j = i + 1; j < n && along[j] < middle(i) + reach; ++j)
      most = std::max(most, per_mm[j]);
    for (std::size_t j = i; j-- > 0 && along[j + 1] > middle(i) - reach;)
      most = std::max(most, per_mm[j]);
    const double step = density.ends[i + 1] - density.ends[i];
    density.arcs.push_back(std::max(2 / most_step, most * (along[i + 1] - along[i]) / step));
  }
  return density;
}

// Joints for an even number of arcs, as close as the density has it.
std::vector<double> joints_of(const Density& density) {
  std::vector<double> until{0};
  for (std::size_t i = 0; i < density.arcs.size(); ++i)
    until.push_back(until.back() + density.arcs[i] * (density.ends[i + 1] - density.ends[i]));
  const auto count = 2 * static_cast<std::size_t>(std::max(1.0, std::ceil(0.5 * until.back())));
  std::vector<double> joints{density.ends.front()};
  std::size_t i = 0;
  for (std::size_t k = 1; k < count; ++k) {
    const double wanted = until.back() * static_cast<double>(k) / static_cast<double>(count);
    while (i + 1 < density.arcs.size() && until[i + 1] < wanted) ++i;
    joints.push_back(density.ends[i] + (wanted - until[i]) / density.arcs[i]);
  }
  joints.push_back(density.ends.back());
  return joints;
}

// Makes arcs between `from` and `to`, which leave the curve by `off` times what is allowed,
// shorter, or, in the first rounds, longer. `piece`: not behind `from`; moves on.
void correct(double from, double to, double off, int round, std::size_t& piece, Density& density) {
  const bool is_first = round < kLongerRounds;
  double factor = 1;
  if (off > 1)
    factor = std::min((is_first ? kMore : kMuchMore) * std::cbrt(off), kShortest);
  else if (is_first)
    factor = std::clamp(std::pow(off / kLittle, kLongerPower), kLongest, 1.0);
  while (piece + 1 < density.arcs.size() && density.ends[piece + 1] <= from) ++piece;
  for (std::size_t i = piece; i < density.arcs.size() && density.ends[i] < to; ++i)
    density.arcs[i] *= factor;
}

// Symmetric equations with two bands beside the diagonal, solved in place.
struct Band {
  std::vector<std::array<double, 3>> rows;  // of row i: columns i, i + 1, i + 2
  std::vector<double> right;
  void solve() {
    const std::size_t n = rows.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 1; k < 3 && i + k < n; ++k) {
        const double factor = rows[i][k] / rows[i][0];
        for (std::size_t c = k; c < 3; ++c) rows[i + k][c - k] -= factor * rows[i][c];
        right[i + k] -= factor * right[i];
      }
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t k = 1; k < 3 && i + k < n; ++k) right[i] -= rows[i][k] * right[i + k];
      right[i] /= rows[i][0];
    }
  }
};

// The curve looked at, and the spline fitted to it.
class Fit {
 public:
  Fit(const Place& place, const std::vector<double>& joints) : joints_(joints) {
    looks_.push_back(place(joints.front()));
    for (std::size_t k = 0; k + 1 < joints.size(); ++k)
      for (int i = 1; i <= kLooks; ++i)
        looks_.push_back(place(joints[k] + i * (joints[k + 1] - joints[k]) / kLooks));
    integrate();
    fit();
  }

  // Where the arcs `k` and those before it meet, on the fitted spline.
  PlanePoint joint(std::size_t k) const {
    const PlanePoint& on = looks_[k * kLooks];
    if (k == 0 || k + 1 == joints_.size()) return on;
    const double aside = value(k) - sum_[k * kLooks], tilt = slope(k) - heading_[k * kLooks];
    return {on.p + aside * left_normal(on.direction),
            normalized(on.direction + tilt * left_normal(on.direction))};
  }
  // The pair of arcs from the joint `k` on.
  std::optional<BiArc> pair(std::size_t k) const {
    const double first = along(k + 1) - along(k), second = along(k + 2) - along(k + 1);
    return bi_arc(joint(k), joint(k + 2), kPi, first / second);
  }
  double off(std::size_t k, const BiArc& pair) const {
    return deviation(pair, looks_, k * kLooks + 1, (k + 2) * kLooks);
  }

 private:
  // Way, heading, and the heading's integral along the way, at every look.
  void integrate() {
    const std::size_t n = looks_.size();
    along_.assign(n, 0);
    heading_.assign(n, 0);
    sum_.assign(n, 0);
    std::vector<double> turn(n, 0), length(n, 0), curvature(n, 0);
    for (std::size_t i = 1; i < n; ++i) {
      turn[i] = turn_between(looks_[i - 1], looks_[i]);
      const double half = 0.5 * turn[i], chord = distance(looks_[i - 1].p, looks_[i].p);
      length[i] = std::abs(half) > 1e-6 ? chord * half / std::sin(half) : chord;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t low = i == 0 ? 1 : i, high = i + 1 == n ? i : i + 1;
      curvature[i] = (turn[low] + turn[high]) / (length[low] + length[high]);
    }
    for (std::size_t i = 1; i < n; ++i) {
      along_[i] = along_[i - 1] + length[i];
      heading_[i] = heading_[i - 1] + turn[i];
      sum_[i] = sum_[i - 1] + 0.5 * length[i] * (heading_[i - 1] + heading_[i]) -
                length[i] * length[i] * (curvature[i] - curvature[i - 1]) / 12;
    }
  }

  double along(std::size_t k) const { return along_[k * kLooks]; }
  // Of quadratic B-splines, whose knots are the joints, the ends thrice: on the piece k the values
  // of the three that are not zero, from the k-th on.
  double knot(std::ptrdiff_t k) const {
    const auto last = static_cast<std::ptrdiff_t>(joints_.size()) - 1;
    return along(static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(k, 0, last)));
  }
  std::array<double, 3> basis(std::size_t piece, double s) const {
    const auto k = static_cast<std::ptrdiff_t>(piece);
    const double t0 = knot(k - 1), t1 = knot(k), t2 = knot(k + 1), t3 = knot(k + 2);
    const double low = (t2 - s) / (t2 - t1), high = (s - t1) / (t2 - t1);
    const double a = (t2 - s) / (t2 - t0), b = (s - t1) / (t3 - t1);
    return {low * a, low * (1 - a) + high * (1 - b), high * b};
  }
  std::array<double, 3> slopes(std::size_t piece, double s) const {
    const auto k = static_cast<std::ptrdiff_t>(piece);
    const double t0 = knot(k - 1), t1 = knot(k), t2 = knot(k + 1), t3 = knot(k + 2);
    const double low = 2 * (t2 - s) / (t2 - t1), high = 2 * (s - t1) / (t2 - t1);
    return {-low / (t2 - t0), low / (t2 - t0) - high / (t3 - t1), high / (t3 - t1)};
  }

  void add(std::size_t piece, const std::array<double, 3>& values, double wanted, double weight,
           Band& band) const {
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = a; b < 3; ++b)
        band.rows[piece + a][b - a] += weight * values[a] * values[b];
      band.right[piece + a] += weight * values[a] * wanted;
    }
  }

  void fit() {
    const std::size_t pieces = joints_.size() - 1;
    Band band{std::vector<std::array<double, 3>>(pieces + 2, {0, 0, 0}),
              std::vector<double>(pieces + 2, 0)};
    for (std::size_t k = 0; k < pieces; ++k)
      for (int i = 0; i < kLooks; ++i) {
        const std::size_t at = k * kLooks + static_cast<std::size_t>(i);
        add(k, basis(k, along_[at]), sum_[at], at == 0 ? kEndWeight : 1, band);
      }
    const double end = along_.back();
    add(pieces - 1, basis(pieces - 1, end), sum_.back(), kEndWeight, band);
    add(0, slopes(0, 0), heading_.front(), kEndWeight, band);
    add(pieces - 1, slopes(pieces - 1, end), heading_.back(), kEndWeight, band);
    band.solve();
    spline_ = std::move(band.right);
  }

  double value(std::size_t k) const { return dot3(basis(k, along(k)), k); }
  double slope(std::size_t k) const { return dot3(slopes(k, along(k)), k); }
  double dot3(const std::array<double, 3>& values, std::size_t k) const {
    return values[0] * spline_[k] + values[1] * spline_[k + 1] + values[2] * spline_[k + 2];
  }

  const std::vector<double>& joints_;
  std::vector<PlanePoint> looks_;
  std::vector<double> along_, heading_, sum_;  // mm, rad, mm
  std::vector<double> spline_;
};

}  // namespace

TangentArcs tangent_arcs(const Place& place, double end, double most_step, double tolerance) {
  const double allowed = kSafety * tolerance;
  TangentArcs best = pairs_on(place, end, most_step, allowed);
  Density density = first_density(place, best.until, most_step, allowed);
  bool good = false;
  for (int round = 0; round < kRounds && !good; ++round) {
    const std::vector<double> joints = joints_of(density);
    if (joints.size() > best.moves.size()) break;
    const Fit fit(place, joints);
    TangentArcs arcs;
    good = true;
    std::size_t piece = 0;
    for (std::size_t k = 0; k + 2 < joints.size(); k += 2) {
      const std::optional<BiArc> pair = fit.pair(k);
      const double off = pair ? fit.off(k, *pair) / allowed : kHopeless;
      good = good && off <= 1;
      correct(joints[k], joints[k + 2], off, round, piece, density);
      if (!good) continue;
      arcs.moves.insert(arcs.moves.end(), {pair->first, pair->second});
      arcs.until.insert(arcs.until.end(), {joints[k + 1], joints[k + 2]});
    }
    if (good) best = std::move(arcs);
  }
  return best;
}

}  // namespace evenload
