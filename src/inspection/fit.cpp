#include "inspection/fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "inspection/least_squares.h"
#include "inspection/smallest_peak.h"
#include "inspection/starts.h"
#include "inspection/whitening.h"

namespace evenload {

namespace {

constexpr double kFlat = 1e-7;  // a curvature below this is none, beside the size of the points
// Other optima may be narrower where least squares leave this much of the points' size, and from
// starts whose sum of squares is up to this many times the least.
constexpr double kRoomForOthers = 0.05;
constexpr double kWorthATry = 9;
constexpr std::size_t kMostTries = 4;
constexpr int kQuickSteps = 30;
constexpr double kBalanced = 1e-6;  // of the sum of squares' slope, beside its terms

const char* degenerate(Kind kind) {
  switch (kind) {
    case Kind::kPlanarLine:
    case Kind::kLine:
      return "The points all lie in one place: a line needs two places at least.";
    case Kind::kPlane:
      return "The points lie on one line: a plane needs points beside it.";
    case Kind::kCircle:
      return "The points lie on one line, or in two places: a circle needs three places off a "
             "line.";
    case Kind::kSphere:
      return "The points lie in one plane or on one circle: a sphere needs points beside it.";
    case Kind::kCylinder:
      break;
  }
  return "The points do not determine a cylinder: measure it at two heights and all around, or "
         "over as much of it as there is.";
}

Eigen::Index fewest(Kind kind) {
  return kind == Kind::kLine ? 2 : freedom_of(kind);  // each point of a line in space tells two
}

void check(Kind kind, const Points& points) {
  if (points.cols() < fewest(kind))
    throw std::invalid_argument("The points are too few: this feature needs " +
                                std::to_string(fewest(kind)) + " at least.");
  if (!points.allFinite())
    throw std::invalid_argument("A point has a coordinate that is not a number: leave it out.");
}

using Placed = std::unique_ptr<Deviations>;

const Frame& frame_in(const Deviations& at) {
  return static_cast<const FeatureDeviations&>(at).frame();
}

// What is found from each start, the best first. Many points are thinned out by `starts` alone.
std::vector<LeastSquares> minima(Kind kind, const Points& points) {
  // Principal axes are the lines of least squares. No step can better them, and distances from a
  // line have a kink that such steps do not know.
  const int steps = kind == Kind::kLine ? 0 : kQuickSteps;
  std::vector<LeastSquares> found;
  for (const Frame& start : starts(kind, points)) {
    LeastSquares each =
        least_squares(std::make_unique<FeatureDeviations>(kind, points, start), steps);
    if (std::isfinite(each.sum)) found.push_back(std::move(each));
  }
  if (found.empty()) throw std::invalid_argument(degenerate(kind));
  std::sort(found.begin(), found.end(),
            [](const LeastSquares& a, const LeastSquares& b) { return a.sum < b.sum; });
  return found;
}

// As `minima`, where many points are first thinned out.
std::vector<LeastSquares> minima_of_many(Kind kind, const Points& points) {
  constexpr Eigen::Index kMany = 600;
  if (points.cols() <= kMany || !is_bent(kind)) {
    std::vector<LeastSquares> found = minima(kind, points);
    if (is_bent(kind)) found.front() = least_squares(std::move(found.front().at));
    return found;
  }
  const Eigen::Index stride = points.cols() / (kMany / 2);
  Points few(3, points.cols() / stride);
  for (Eigen::Index i = 0; i < few.cols(); ++i) few.col(i) = points.col(i * stride);
  std::vector<LeastSquares> found;
  double least = 0;
  for (const LeastSquares& each : minima(kind, few)) {
    if (!found.empty() && (each.sum > kWorthATry * least || found.size() >= kMostTries)) break;
    if (!found.empty() && each.sum <= least * (1 + 1e-6)) continue;  // the same again
    if (found.empty()) least = each.sum;
    found.push_back(
        least_squares(std::make_unique<FeatureDeviations>(kind, points, frame_in(*each.at))));
  }
  std::sort(found.begin(), found.end(),
            [](const LeastSquares& a, const LeastSquares& b) { return a.sum < b.sum; });
  return found;
}

// The narrowest line in space near a start.
Optimum narrowest_line(const LeastSquares& at, const Points& points) {
  const Frame& frame = frame_in(*at.at);
  const double usual = at.rows.values.maxCoeff();
  Optimum found = smallest_peak(
      std::make_unique<FeatureDeviations>(Kind::kLine, points, frame, usual), kRounding);
  found.values = FeatureDeviations(Kind::kLine, points, frame_in(*found.at)).rows().values;
  found.peak = found.values.maxCoeff();
  return found;
}

// The same feature, in the middle of its zone.
Placed centred(const LeastSquares& at) {
  const auto& feature = static_cast<const FeatureDeviations&>(*at.at);
  const double middle = 0.5 * (at.rows.values.maxCoeff() + at.rows.values.minCoeff());
  return std::make_unique<FeatureDeviations>(feature.parallel(middle));
}

Optimum minimum_zone(Kind kind, const Points& points, const std::vector<LeastSquares>& from) {
  const auto zone_from = [&](const LeastSquares& at) {
    return kind == Kind::kLine ? narrowest_line(at, points) : smallest_peak(centred(at), kRounding);
  };
  Optimum best = zone_from(from.front());
  const bool has_room = is_bent(kind) || best.peak > kRoomForOthers;
  for (std::size_t i = 1; i < std::min(from.size(), kMostTries); ++i) {
    const double share = from[i].sum / std::max(from.front().sum, kRounding * kRounding);
    if (!has_room || (is_bent(kind) && (share > kWorthATry || share <= 1 + 1e-6))) continue;
    Optimum other = zone_from(from[i]);
    if (other.peak < best.peak - kRounding) best = std::move(other);
  }
  return best;
}

// Where the scaled points lie in the caller's frame.
struct Home {
  Eigen::Vector3d middle;
  double size;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
};

int sign_of(const Eigen::Vector3d& direction) {
  Eigen::Index largest;
  direction.cwiseAbs().maxCoeff(&largest);
  return direction[largest] < 0 ? -1 : 1;
}

// Frame, deviations and contacts in the caller's words and units.
FittedFeature told(Kind kind, Frame frame, Eigen::VectorXd values, const Certificate& proof,
                   const Home& home) {
  FittedFeature result;
  const Eigen::Vector3d axis = frame.axes.col(0);
  Eigen::Vector3d normal = frame.axes.col(1), point = frame.origin;
  int outwards = 1;
  switch (kind) {
    case Kind::kPlanarLine: {
      const Eigen::Vector3d along = frame.axes.col(1).cross(Eigen::Vector3d::UnitZ());
      outwards = sign_of(along);
      result.direction = outwards * along;
      point = normal.dot(point) * normal;
      break;
    }
    case Kind::kLine:
      result.direction = sign_of(axis) * axis;
      point -= axis.dot(point) * axis;
      break;
    case Kind::kPlane:
      outwards = sign_of(home.turn * normal);
      result.direction = outwards * normal;
      point = normal.dot(point) * normal;
      break;
    default:
      outwards = frame.curvature < 0 ? -1 : 1;
      point -= normal / frame.curvature;
      result.radius = home.size / std::abs(frame.curvature);
      if (kind == Kind::kSphere) break;
      if (kind == Kind::kCylinder) point -= axis.dot(point) * axis;
      result.direction = home.turn * axis;
      result.direction *= sign_of(result.direction);
      break;
  }
  result.point = home.middle + home.size * (home.turn * point);
  result.deviations = (outwards * home.size) * values;
  result.contacts = proof.contacts;
  for (Contact& each : result.contacts) each.side *= outwards;
  result.imbalance = proof.imbalance;
  result.is_proved = proof.is_proved;
  result.zone = kind == Kind::kLine ? 2 * result.deviations.maxCoeff()
                                    : result.deviations.maxCoeff() - result.deviations.minCoeff();
  return result;
}

}  // namespace

FittedFeature fit(Kind kind, Method method, const Points& points, bool is_spatial) {
  check(kind, points);
  Home home{points.rowwise().mean(), 0};
  Points scaled = points.colwise() - home.middle;
  home.size = scaled.colwise().norm().maxCoeff();
  if (!(home.size > 0)) throw std::invalid_argument(degenerate(kind));
  scaled /= home.size;
  if (kind == Kind::kCircle && is_spatial) {
    const Eigen::Matrix3d axes = principal_axes(scaled).axes;
    home.turn << axes.col(2), axes.col(1), axes.col(2).cross(axes.col(1));
    scaled = (home.turn.transpose() * scaled).eval();
    scaled.row(2).setZero();
  }
  std::vector<LeastSquares> found = minima_of_many(kind, scaled);
  const LeastSquares& best = found.front();
  // Points that lie on a line in space to the last digit tell no direction away from it.
  const bool is_loose =
      kind != Kind::kLine && whitening(best.rows.gradients).cols() < freedom_of(kind);
  if (is_loose || (is_bent(kind) && !(std::abs(frame_in(*best.at).curvature) > kFlat)))
    throw std::invalid_argument(degenerate(kind));
  if (method == Method::kLeastSquares) {
    Certificate balance;
    balance.imbalance = best.imbalance;
    const double exact = kRounding * kRounding * static_cast<double>(points.cols());
    balance.is_proved = best.imbalance < kBalanced || best.sum <= exact;
    return told(kind, frame_in(*best.at), best.rows.values, balance, home);
  }
  const Optimum optimum = minimum_zone(kind, scaled, found);
  return told(kind, frame_in(*optimum.at), optimum.values, optimum.certificate, home);
}

}  // namespace evenload
