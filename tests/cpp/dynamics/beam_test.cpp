// Slender tools: Timoshenko beams, and receptance coupling.
#include "dynamics/beam.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "dynamics/cases.h"

namespace evenload {
namespace {

using dynamics_cases::hertz;

BeamMaterial carbide(double loss = 0) { return {580e9, 14450, 0.22, loss}; }
BeamMaterial steel() { return {205e9, 7850, 0.29, 0}; }
BeamSegment tool(double length = 0.06, double diameter = 0.01, double loss = 0) {
  return {length, diameter, carbide(loss)};
}
EndReceptance modal_holder(double w) {
  EndReceptance result = EndReceptance::Zero();
  const double wn = hertz(900);
  result(0, 0) = wn * wn / 2e7 / std::complex<double>(wn * wn - w * w, 2 * 0.03 * wn * w);
  return result;
}

void expect_near(std::complex<double> value, double real, double imaginary) {
  const double size = std::hypot(real, imaginary);
  EXPECT_NEAR(1e6 * value.real(), real, 1e-4 * size);
  EXPECT_NEAR(1e6 * value.imag(), imaginary, 1e-4 * size);
}

TEST(Beam, HasTheFrequenciesOfTheReference) {
  const auto frequencies = clamped_frequencies({tool()}, hertz(40000));
  ASSERT_EQ(frequencies.size(), 3U);
  for (const auto& [i, expected] : {std::pair{0, 2425.522}, {1, 14023.32}, {2, 35451.61}})
    EXPECT_NEAR(frequencies[static_cast<std::size_t>(i)] / hertz(expected), 1, 1e-6);
  const auto stepped = clamped_frequencies({tool(), {0.08, 0.04, steel()}}, hertz(14000));
  ASSERT_EQ(stepped.size(), 3U);
  for (const auto& [i, expected] : {std::pair{0, 2102.029}, {1, 4163.624}, {2, 13182.15}})
    EXPECT_NEAR(stepped[static_cast<std::size_t>(i)] / hertz(expected), 1, 1e-6);
  const auto fluted = clamped_frequencies({tool(0.02, 0.008), tool(0.04)}, hertz(34000));
  ASSERT_EQ(fluted.size(), 3U);
  for (const auto& [i, expected] : {std::pair{0, 2869.553}, {1, 14073.84}, {2, 33094.56}})
    EXPECT_NEAR(fluted[static_cast<std::size_t>(i)] / hertz(expected), 1, 1e-6);
}

TEST(Beam, OfALongThinToolHasEulersFrequencies) {
  const double length = 1, diameter = 0.01, area = M_PI / 4 * 1e-4, inertia = M_PI / 64 * 1e-8;
  const auto found = clamped_frequencies({tool(length, diameter)}, hertz(200));
  const double bends[] = {1.875104, 4.694091, 7.854757};
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(found[i] / (bends[i] * bends[i] * std::sqrt(580e9 * inertia / (14450 * area))), 1,
                2e-3);
}

TEST(Beam, AtRestBendsAndShears) {
  const double inertia = M_PI / 64 * 1e-8, area = M_PI / 4 * 1e-4, l = 0.06;
  const double kappa = 6 * 1.22 / (7 + 6 * 0.22), shear = kappa * 580e9 / 2.44 * area;
  const double expected = l * l * l / (3 * 580e9 * inertia) + l / shear;
  const auto g = tip_receptance({tool()}, EndReceptance::Zero(), 0);
  EXPECT_NEAR(g(0, 0).real() / expected, 1, 1e-9);
  EXPECT_NEAR(1e6 * g(0, 0).real(), 0.2565446, 1e-6);
}

TEST(Beam, IsSymmetricAndTwoHalvesAreTheWhole) {
  for (const double f : {100.0, 1500.0, 9000.0}) {
    const EndReceptance whole =
        tip_receptance({tool(0.06, 0.01, 0.004)}, modal_holder(hertz(f)), hertz(f));
    EXPECT_LT(std::abs(whole(0, 1) - whole(1, 0)), 1e-9 * std::abs(whole(0, 1)));
    const EndReceptance halves = tip_receptance({tool(0.03, 0.01, 0.004), tool(0.03, 0.01, 0.004)},
                                                modal_holder(hertz(f)), hertz(f));
    EXPECT_LT((whole - halves).norm(), 1e-9 * whole.norm());
    const EndReceptance inner =
        tip_receptance({tool(0.03, 0.01, 0.004)}, modal_holder(hertz(f)), hertz(f));
    const EndReceptance outer = tip_receptance({tool(0.03, 0.01, 0.004)}, inner, hertz(f));
    EXPECT_LT((whole - outer).norm(), 1e-9 * whole.norm());
  }
}

TEST(Beam, OnAHolderHasTheReceptancesOfTheReference) {
  const auto at = [](const std::vector<BeamSegment>& segments, const EndReceptance& root,
                     double f) { return tip_receptance(segments, root, hertz(f))(0, 0); };
  BeamSegment holder{0.08, 0.04, steel()};
  holder.material.loss_factor = 0.004;
  expect_near(at({tool(0.06, 0.01, 0.004), holder}, EndReceptance::Zero(), 1500), 0.5651688,
              -0.004491174);
  const std::vector<BeamSegment> lossy{tool(0.06, 0.01, 0.003)};
  expect_near(at(lossy, modal_holder(hertz(1000)), 1000), 0.09027234, -0.03826342);
  expect_near(at(lossy, modal_holder(hertz(2300)), 2300), 1.388002, -0.04187201);
  EndReceptance joint = EndReceptance::Zero();
  joint(0, 0) = 1 / 5e7;
  joint(1, 1) = 1 / 2e4;
  expect_near(at(lossy, modal_holder(hertz(1000)) + joint, 1000), 0.3059893, -0.06420946);
  expect_near(at(lossy, modal_holder(hertz(2300)) + joint, 2300), -0.4902881, -0.002198298);
}

TEST(Beam, TellsTheHolderFromATipThatWasMeasured) {
  const double w = hertz(1400);
  const std::vector<BeamSegment> blank{tool(0.04, 0.012, 0.003)};
  EndReceptance holder = modal_holder(w);
  holder(1, 1) = {3e-6, -1e-7};
  const EndReceptance found = root_receptance(blank, tip_receptance(blank, holder, w), w);
  EXPECT_LT((found - holder).norm(), 1e-6 * holder.norm());
}

TEST(Beam, RefusesSegmentsThatAreNone) {
  EXPECT_THROW(tip_receptance({}, EndReceptance::Zero(), 1), std::invalid_argument);
  EXPECT_THROW(tip_receptance({tool(0)}, EndReceptance::Zero(), 1), std::invalid_argument);
}

}  // namespace
}  // namespace evenload
