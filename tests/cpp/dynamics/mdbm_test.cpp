// Bisection in several dimensions: known sets, their components, and how few points it looks at.
#include "dynamics/mdbm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <stdexcept>

#include "dynamics/cases.h"
#include "dynamics/mdbm_curves.h"
#include "dynamics/stability.h"

namespace evenload {
namespace {

using Function = std::function<void(const double*, double*)>;

Mdbm found(const std::vector<MdbmAxis>& axes, int halvings, const Function& function,
           int equations = 1, int threads = 1, bool has_constraint = false) {
  Mdbm mdbm({axes, equations, has_constraint, function, threads});
  Progress progress;
  mdbm.begin(progress);
  for (int i = 0; i < halvings; ++i) mdbm.halve(progress);
  return mdbm;
}

int component_count(const Mdbm& mdbm) {
  const std::vector<int> numbers = mdbm.components();
  return static_cast<int>(std::set<int>(numbers.begin(), numbers.end()).size());
}

void print(const char* name, const Mdbm& mdbm, double dimension = 1) {
  std::printf("%-20s %6lld evaluations, %.0f by brute force, E %.3f, %d components, %zu cells\n",
              name, static_cast<long long>(mdbm.evaluations().back()), mdbm.brute_force(),
              efficiency(mdbm, dimension), component_count(mdbm), mdbm.cells().size());
}

double length_of(const std::vector<std::vector<double>>& lines, int axes) {
  double sum = 0;
  for (const std::vector<double>& line : lines)
    for (std::size_t i = static_cast<std::size_t>(axes); i < line.size();
         i += static_cast<std::size_t>(axes)) {
      double square = 0;
      for (int a = 0; a < axes; ++a) {
        const double d = line[i + static_cast<std::size_t>(a)] -
                         line[i - static_cast<std::size_t>(axes) + static_cast<std::size_t>(a)];
        square += d * d;
      }
      sum += std::sqrt(square);
    }
  return sum;
}

void circle(const double* x, double* f) { *f = x[0] * x[0] + x[1] * x[1] - 1; }

double largest_error(const Mdbm& mdbm) {
  const std::vector<double> points = mdbm.points();
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); i += 2)
    largest = std::max(largest, std::abs(std::hypot(points[i], points[i + 1]) - 1));
  return largest;
}

const std::vector<MdbmAxis> kSquare{{-2, 2, 4}, {-2, 2, 4}};

TEST(Mdbm, FindsACircleWithFewEvaluations) {
  const Mdbm mdbm = found(kSquare, 8, circle);
  print("circle", mdbm);
  const std::int64_t reference[] = {25, 69, 145, 285, 553, 1077, 2113, 4173, 8281};
  for (std::size_t i = 0; i < 9; ++i) EXPECT_LE(mdbm.evaluations()[i], reference[i] * 5 / 4) << i;
  EXPECT_EQ(component_count(mdbm), 1);
  EXPECT_GE(efficiency(mdbm, 1), 3);
  EXPECT_LT(largest_error(mdbm), 3.9e-6);
  const auto lines = curves(mdbm);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0][0], lines[0][lines[0].size() - 2]);
  EXPECT_NEAR(length_of(lines, 2), 2 * M_PI, 1e-4);
}

TEST(Mdbm, HalvesTheCellsAndQuartersTheError) {
  double before = 0;
  for (int halvings = 3; halvings <= 7; ++halvings) {
    const double error = largest_error(found(kSquare, halvings, circle));
    if (before > 0) {
      EXPECT_NEAR(before / error, 4, 0.3);
    }
    before = error;
  }
}

TEST(Mdbm, FindsSmallCirclesWhereTheCellsAreNarrowEnough) {
  const auto two = [](const double* x, double* f) {
    *f = (x[0] * x[0] + x[1] * x[1] - 1) *
         (std::pow(x[0] - 1.37, 2) + std::pow(x[1] - 1.41, 2) - 0.07 * 0.07);
  };
  const Mdbm fine = found({{-2, 2, 41}, {-2, 2, 41}}, 5, two);
  print("two circles", fine);
  EXPECT_EQ(component_count(fine), 2);
  EXPECT_LE(fine.evaluations().back(), 12721 * 5 / 4);
  EXPECT_EQ(component_count(found({{-2, 2, 8}, {-2, 2, 8}}, 6, two)), 1);
}

TEST(Mdbm, FindsTheCurvesInWhichTwoToriMeet) {
  const auto tori = [](const double* x, double* f) {
    f[0] = std::pow(std::hypot(x[0], x[1]) - 1, 2) + x[2] * x[2] - 0.16;
    f[1] = std::pow(std::hypot(x[1], x[2]) - 1, 2) + std::pow(x[0] - 0.9, 2) - 0.16;
  };
  const Mdbm mdbm = found(std::vector<MdbmAxis>(3, {-2, 2.03, 12}), 5, tori, 2);
  print("tori", mdbm);
  EXPECT_EQ(component_count(mdbm), 2);
  EXPECT_LE(mdbm.evaluations().back(), 20106 * 5 / 4);
  EXPECT_GE(efficiency(mdbm, 1), 1.5);
  const auto lines = curves(mdbm);
  std::printf("%zu curves of length %.6f\n", lines.size(), length_of(lines, 3));
  EXPECT_EQ(lines.size(), 2U);
  EXPECT_NEAR(length_of(lines, 3) / 7.651769, 1, 1e-3);
}

TEST(Mdbm, FollowsACurveThatIsNowhereSmooth) {
  const auto weierstrass = [](const double* x, double* f) {
    *f = x[1];
    for (int k = 0; k < 24; ++k) *f -= std::pow(0.5, k) * std::cos(std::pow(3, k) * M_PI * x[0]);
  };
  const Mdbm mdbm = found({{0, 2, 20}, {-2.5, 2.5, 20}}, 6, weierstrass);
  print("Weierstrass", mdbm, 1.36907);
  EXPECT_EQ(component_count(mdbm), 1);
  EXPECT_LE(mdbm.evaluations().back(), 35825 * 5 / 4);
  EXPECT_GE(efficiency(mdbm, 1.36907), 3);
}

TEST(Mdbm, FindsTheIslandsOfAChart) {
  using namespace dynamics_cases;
  const Milling m = islands();
  const auto boundary = [&](const double* x, double* f) {
    *f = spectral_radius(m, rpm(x[0]), 1e-3 * x[1], 1e-3) - 1;
  };
  const Mdbm mdbm = found({{9000, 22000, 26}, {0.3, 5, 19}}, 2, boundary);
  print("islands", mdbm);
  EXPECT_EQ(component_count(mdbm), 4);
  EXPECT_LE(mdbm.evaluations().back(), 1213 * 5 / 4);
  const Mdbm threaded = found({{9000, 22000, 26}, {0.3, 5, 19}}, 2, boundary, 1, 3);
  EXPECT_EQ(threaded.points(), mdbm.points());
  EXPECT_EQ(threaded.evaluations(), mdbm.evaluations());
}

TEST(Mdbm, KnowsNeitherTheOrderOfTheAxesNorFactors) {
  const std::vector<MdbmAxis> axes{{-1.9, 2, 5}, {-2, 2.1, 7}};
  const auto ellipse = [](double x, double y) { return x * x + 2 * y * y + 0.3 * x * y - 1; };
  const Mdbm straight =
      found(axes, 4, [&](const double* x, double* f) { *f = ellipse(x[0], x[1]); });
  const Mdbm turned = found({axes[1], axes[0]}, 4,
                            [&](const double* x, double* f) { *f = -7 * ellipse(x[1], x[0]); });
  EXPECT_EQ(straight.evaluations(), turned.evaluations());
  ASSERT_EQ(straight.cells().size(), turned.cells().size());
  const auto sorted = [](const Mdbm& mdbm, int first) {
    std::vector<std::pair<double, double>> result;
    const std::vector<double> p = mdbm.points();
    for (std::size_t i = 0; i < p.size(); i += 2)
      result.emplace_back(p[i + static_cast<std::size_t>(first)],
                          p[i + 1 - static_cast<std::size_t>(first)]);
    std::sort(result.begin(), result.end());
    return result;
  };
  const auto a = sorted(straight, 0), b = sorted(turned, 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(a[i].first, b[i].first, 1e-12);
    EXPECT_NEAR(a[i].second, b[i].second, 1e-12);
  }
}

TEST(Mdbm, KeepsToItsConstraint) {
  const auto half = [](const double* x, double* f) {
    circle(x, f);
    f[1] = x[1] - 0.3;
  };
  const Mdbm mdbm = found(kSquare, 6, half, 1, 1, true);
  const std::vector<double> points = mdbm.points();
  for (std::size_t i = 0; i < points.size(); i += 2) EXPECT_GT(points[i + 1], 0.3 - 1e-6);
  const auto lines = curves(mdbm);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(length_of(lines, 2), M_PI - 2 * std::asin(0.3), 1e-3);
  EXPECT_LT(mdbm.evaluations().back(), found(kSquare, 6, circle).evaluations().back());
}

TEST(Mdbm, TellsPolesFromZeros) {
  const auto tangent = [](const double* x, double* f) { *f = std::tan(x[0] + 0.3 * x[1]); };
  const std::vector<double> points = found({{-1, 3, 9}, {0, 1, 5}}, 4, tangent).points();
  EXPECT_GT(points.size(), 100U);
  for (std::size_t i = 0; i < points.size(); i += 2) {
    const double phase = points[i] + 0.3 * points[i + 1];
    EXPECT_NEAR(std::remainder(phase, M_PI), 0, 0.01);
  }
}

TEST(Mdbm, StopsWhereItIsCancelledAndKeepsWhatItHas) {
  Mdbm mdbm({kSquare, 1, false, circle, 2});
  Progress patient;
  mdbm.begin(patient);
  mdbm.halve(patient);
  const std::vector<double> points = mdbm.points();
  Progress cancelled([](double) { return false; });
  EXPECT_THROW(mdbm.halve(cancelled), Cancelled);
  EXPECT_EQ(mdbm.points(), points);
  mdbm.halve(patient);
  EXPECT_EQ(mdbm.points(), found(kSquare, 2, circle).points());
}

TEST(Mdbm, LooksAtEverySecondLineFirstAndThenFindsWhatItWouldHave) {
  Mdbm mdbm({kSquare, 1, false, circle, 2});
  Progress progress;
  mdbm.begin(progress, 2);
  const std::int64_t first = mdbm.evaluations().back();
  EXPECT_FALSE(mdbm.points().empty());
  Progress cancelled([](double) { return false; });
  const std::vector<double> points = mdbm.points();
  EXPECT_THROW(mdbm.begin(cancelled), Cancelled);
  EXPECT_EQ(mdbm.points(), points);
  mdbm.begin(progress);
  const Mdbm at_once = found(kSquare, 0, circle);
  EXPECT_EQ(mdbm.points(), at_once.points());
  EXPECT_EQ(mdbm.evaluations().back(), at_once.evaluations().back());
  EXPECT_LT(2 * first, mdbm.evaluations().back());
  EXPECT_THROW(mdbm.begin(progress, 3), std::invalid_argument);
}

TEST(Mdbm, RefusesBoxesThatAreNone) {
  EXPECT_THROW(found({}, 1, circle), std::invalid_argument);
  EXPECT_THROW(found({{1, 1, 4}, {0, 1, 4}}, 1, circle), std::invalid_argument);
  EXPECT_THROW(found({{0, 1, 0}, {0, 1, 4}}, 1, circle), std::invalid_argument);
  EXPECT_THROW(found({{0, 1, 4}}, 1, circle, 2), std::invalid_argument);
}

}  // namespace
}  // namespace evenload
