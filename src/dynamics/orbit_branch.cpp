#include "dynamics/orbit_branch.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "support/solvers.h"

namespace evenload {

namespace {

constexpr double kAccuracy = 1e-6;    // of multipliers
constexpr int kMultipliers = 4;       // that are told
constexpr double kStart = 0.03;       // of the largest depth: there one motion exists
constexpr double kFirstStep = 0.004;  // of the largest depth, along the branch
constexpr double kLongestStep = 0.03;
constexpr double kShortestStep = 1e-6;
constexpr int kMostPoints = 1500;
constexpr int kBranchNewton = 10;
constexpr double kPointConverged = 1e-12;
constexpr double kDepthDifference = 1e-6;  // relative, of the depth
constexpr int kHalvings = 44;

// A place on the branch: the modes' states, and the depth, in m; and the branch's direction there.
struct Place {
  Eigen::VectorXd at, tangent;
};

class Follower {
 public:
  Follower(const OrbitSolver& solver, double largest) : solver_(solver), largest_(largest) {}

  Orbit orbit(const Place& place) const {
    Orbit result = orbit_of(place.at);
    solver_.run(result, {});
    return result;
  }

  std::optional<Place> first(double depth) const {
    Orbit orbit;
    orbit.start = Eigen::VectorXd::Zero(solver_.states());
    orbit.depth = depth;
    if (!solver_.solve(orbit)) return std::nullopt;
    Place place{Eigen::VectorXd(size()), Eigen::VectorXd::Unit(size(), size() - 1)};
    place.at << orbit.start, depth;
    place.tangent = tangent(place.at, place.tangent);
    return place;
  }

  // The place in the plane across `from.tangent` at a distance along it.
  std::optional<Place> along(const Place& from, double distance) const {
    Eigen::VectorXd at = from.at + distance * from.tangent;
    for (int i = 0; i < kBranchNewton; ++i) {
      if (!(at[size() - 1] > 0)) return std::nullopt;
      Eigen::MatrixXd lhs(size(), size());
      Eigen::VectorXd rhs(size());
      rhs << -equation(at, lhs), distance - from.tangent.dot(at - from.at);
      lhs.row(size() - 1) = from.tangent.transpose();
      const Eigen::VectorXd step = solved(lhs, rhs);
      if (!step.allFinite() || step.norm() > largest_) return std::nullopt;
      at += step;
      if (step.norm() < kPointConverged * largest_) return Place{at, tangent(at, from.tangent)};
    }
    return std::nullopt;
  }

  BranchPoint point(const Place& place) const {
    const Orbit found = orbit(place);
    return {found.depth,
            found.amplitude(),
            solver_.multipliers(found, kAccuracy, kMultipliers),
            false,
            false,
            found};
  }

  // Where f changes its sign between `from` and `distance` along the branch.
  template <typename Function>
  std::optional<Place> root(const Place& from, double distance, const Function& f) const {
    double low = 0, high = distance;
    const bool sign = f(from) > 0;
    std::optional<Place> best;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      const std::optional<Place> found = along(from, middle);
      if (!found) return best;
      best = found;
      ((f(*found) > 0) == sign ? low : high) = middle;
    }
    return best;
  }

 private:
  Eigen::Index size() const { return solver_.states() + 1; }
  Orbit orbit_of(const Eigen::VectorXd& at) const {
    Orbit result;
    result.start = at.head(size() - 1);
    result.depth = at[size() - 1];
    return result;
  }
  // end - start, and its derivatives in the upper rows of `lhs`.
  Eigen::VectorXd equation(const Eigen::VectorXd& at, Eigen::MatrixXd& lhs) const {
    Orbit here = orbit_of(at), more = here, less = here;
    const double step = kDepthDifference * here.depth;
    more.depth += step;
    less.depth -= step;
    const OrbitSolver::End end = solver_.run(here, {});
    lhs.setZero(size(), size());
    lhs.topLeftCorner(size() - 1, size() - 1) =
        end.by_start - Eigen::MatrixXd::Identity(size() - 1, size() - 1);
    lhs.topRightCorner(size() - 1, 1) =
        (solver_.run(more, {}).state - solver_.run(less, {}).state) / (2 * step);
    return end.state - here.start;
  }
  Eigen::VectorXd tangent(const Eigen::VectorXd& at, const Eigen::VectorXd& before) const {
    Eigen::MatrixXd lhs;
    equation(at, lhs);
    lhs.row(size() - 1) = before.transpose();
    return solved(lhs, Eigen::VectorXd::Unit(size(), size() - 1)).normalized();
  }

  const OrbitSolver& solver_;
  double largest_;
};

double slope(const Place& place) { return place.tangent[place.tangent.size() - 1]; }
double depth_of(const Place& place) { return place.at[place.at.size() - 1]; }

// What lies between two neighbours of the branch: wanted depths, a fold, a change of stability.
void look_between(const Follower& follower, const Place& from, const Place& to, double distance,
                  const std::vector<double>& wanted, OrbitBranch& branch) {
  std::vector<std::pair<double, BranchPoint>> found;
  const auto add = [&](const std::optional<Place>& place, bool is_fold) {
    if (!place) return;
    BranchPoint point = follower.point(*place);
    point.is_fold = is_fold;
    point.is_wanted = !is_fold;
    found.emplace_back(from.tangent.dot(place->at - from.at), std::move(point));
  };
  const bool turns = slope(from) * slope(to) < 0;
  if (turns) add(follower.root(from, distance, slope), true);
  for (const double depth : wanted) {
    const auto off = [&](const Place& place) { return depth_of(place) - depth; };
    if (off(from) != 0 && (off(from) > 0) != (off(to) > 0))
      add(follower.root(from, distance, off), false);
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [way, point] : found) branch.points.push_back(std::move(point));
}

}  // namespace

OrbitBranch follow_branch(const OrbitSolver& solver, std::vector<double> depths,
                          Progress& progress) {
  std::sort(depths.begin(), depths.end());
  if (depths.empty() || !(depths.front() > 0) || !std::isfinite(depths.back()))
    throw std::invalid_argument("The depths of orbits must be above 0 mm.");
  const double largest = depths.back(), least = std::min(depths.front(), kStart * largest);
  const Follower follower(solver, largest);
  OrbitBranch branch;
  std::optional<Place> here = follower.first(least);
  if (!here) return branch;
  branch.points.push_back(follower.point(*here));
  branch.points.back().is_wanted = least == depths.front();
  double step = kFirstStep * largest;
  while (branch.points.size() < kMostPoints && step > kShortestStep * largest) {
    progress.step();
    const std::optional<Place> next = follower.along(*here, step);
    if (!next || next->tangent.dot(here->tangent) < 0.9) {
      step *= 0.5;
      continue;
    }
    look_between(follower, *here, *next, step, depths, branch);
    const bool is_out = depth_of(*next) > largest || depth_of(*next) < least;
    if (is_out) break;
    BranchPoint point = follower.point(*next);
    const bool was_stable = branch.points.back().radius() < 1;
    if (was_stable != (point.radius() < 1)) {
      const auto margin = [&](const Place& place) { return follower.point(place).radius() - 1; };
      if ((margin(*here) > 0) != (margin(*next) > 0))
        if (const auto place = follower.root(*here, step, margin))
          branch.boundaries.push_back(follower.point(*place));
    }
    branch.points.push_back(std::move(point));
    here = next;
    step = std::min(1.5 * step, kLongestStep * largest);
  }
  return branch;
}

}  // namespace evenload
