#include "dynamics/beam.h"

#include <Eigen/Dense>
#include <cmath>

#include "dynamics/complex.h"
#include "support/demand.h"

namespace evenload {

namespace {

using Transfer = Eigen::Matrix4cd;

constexpr int kLooks = 2000;  // for natural frequencies
constexpr int kBisections = 60;
constexpr double kSlow = 1e-3;      // rad/s: as at rest
constexpr double kShortStep = 0.5;  // norm of what is exponentiated by its series
constexpr int kTerms = 14;

void check(const std::vector<BeamSegment>& segments) {
  demand(!segments.empty(), "The tool needs at least one segment.");
  for (const BeamSegment& s : segments) {
    demand(s.length > 0 && s.diameter > 0 && std::isfinite(s.length + s.diameter),
           "Each segment needs a length and a diameter above 0 mm.");
    demand(s.material.youngs_modulus > 0 && s.material.density > 0,
           "The tool's material needs a modulus and a density above 0.");
    demand(s.material.poisson_ratio >= 0 && s.material.poisson_ratio < 0.5 &&
               s.material.loss_factor >= 0,
           "Poisson's ratio must lie from 0 to 0.5, and the loss factor must not be negative.");
  }
}

// exp(matrix), by its series after halving; the state is scaled so that all entries are alike.
Transfer exponential(Transfer matrix) {
  int halvings = 0;
  for (double size = matrix.cwiseAbs().rowwise().sum().maxCoeff(); size > kShortStep; size *= 0.5)
    ++halvings;
  matrix *= std::ldexp(1.0, -halvings);
  Transfer result = Transfer::Identity(), term = result;
  for (int n = 1; n <= kTerms; ++n) {
    term = (term * matrix / static_cast<double>(n)).eval();
    result += term;
  }
  for (int i = 0; i < halvings; ++i) result = (result * result).eval();
  return result;
}

// From the root's state to the tip's of one segment, z pointing to the tip.
Transfer transfer(const BeamSegment& s, double w) {
  const Complex loss(1, s.material.loss_factor);
  const double nu = s.material.poisson_ratio;
  const double area = M_PI / 4 * s.diameter * s.diameter;
  const double inertia = M_PI / 64 * std::pow(s.diameter, 4);
  const Complex bending = s.material.youngs_modulus * loss * inertia;
  const double kappa = 6 * (1 + nu) / (7 + 6 * nu);
  const Complex shear = kappa * s.material.youngs_modulus * loss / (2 * (1 + nu)) * area;
  // Lengths in units of the segment's, forces in EI/L^2.
  const double length = s.length, force = std::abs(bending) / (length * length);
  Transfer z = Transfer::Zero();
  z(0, 1) = 1;
  z(0, 2) = force / shear;
  z(1, 3) = force * length * length / bending;
  z(2, 0) = -s.material.density * area * w * w * length * length / force;
  z(3, 1) = -s.material.density * inertia * w * w / force;
  z(3, 2) = -1;
  Transfer result = exponential(z);
  const Eigen::Vector4d scale(length, 1, force, force * length);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) result(row, column) *= scale[row] / scale[column];
  return result;
}

Transfer transfer(const std::vector<BeamSegment>& segments, double w) {
  Transfer result = Transfer::Identity();
  for (const BeamSegment& segment : segments) result = (result * transfer(segment, w)).eval();
  return result;
}

// Free-free: the tip is 1, the root 2. At the root the segment's own force is minus that on it.
struct FreeReceptances {
  EndReceptance r11, r12, r21, r22;
};

FreeReceptances free_receptances(const Transfer& t) {
  // (x1, f1) = [[a, b], [c, d]] (x2, -f2), f1 and f2 the forces on the beam's ends.
  const EndReceptance a = t.topLeftCorner<2, 2>(), b = t.topRightCorner<2, 2>();
  const EndReceptance c = t.bottomLeftCorner<2, 2>(), d = t.bottomRightCorner<2, 2>();
  const EndReceptance inverse = c.inverse();
  return {a * inverse, a * inverse * d - b, inverse, inverse * d};
}

}  // namespace

EndReceptance tip_receptance(const std::vector<BeamSegment>& segments,
                             const EndReceptance& holder_and_joint, double w) {
  check(segments);
  // G = R11 - R12 (R22 + S)^-1 R21 = (a S + b)(c S + d)^-1 with forces on the root turned: no free
  // body motion has to be inverted, so that it holds at rest, too.
  const Transfer t = transfer(segments, w);
  const EndReceptance a = t.topLeftCorner<2, 2>(), b = t.topRightCorner<2, 2>();
  const EndReceptance c = t.bottomLeftCorner<2, 2>(), d = t.bottomRightCorner<2, 2>();
  return (a * holder_and_joint + b) * (c * holder_and_joint + d).inverse();
}

EndReceptance root_receptance(const std::vector<BeamSegment>& segments, const EndReceptance& tip,
                              double w) {
  check(segments);
  const FreeReceptances r = free_receptances(transfer(segments, std::max(w, kSlow)));
  return r.r21 * (r.r11 - tip).inverse() * r.r12 - r.r22;
}

std::vector<double> clamped_frequencies(const std::vector<BeamSegment>& segments, double highest) {
  check(segments);
  std::vector<BeamSegment> lossless = segments;
  for (BeamSegment& segment : lossless) segment.material.loss_factor = 0;
  // Clamped at the root, free at the tip: det d = 0.
  const auto f = [&](double w) {
    return transfer(lossless, w).bottomRightCorner<2, 2>().determinant().real();
  };
  std::vector<double> result;
  double before = kSlow, at_before = f(kSlow);
  for (int i = 1; i <= kLooks; ++i) {
    const double here = highest * i / kLooks, at_here = f(here);
    if ((at_before > 0) != (at_here > 0)) {
      double low = before, high = here;
      for (int n = 0; n < kBisections; ++n) {
        const double middle = 0.5 * (low + high);
        ((f(middle) > 0) == (at_before > 0) ? low : high) = middle;
      }
      result.push_back(low);
    }
    before = here;
    at_before = at_here;
  }
  return result;
}

}  // namespace evenload
