// Modes from frequency responses.
#include "dynamics/modal_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace evenload {
namespace {

struct Measured {
  std::vector<double> frequencies;
  std::vector<std::complex<double>> values;
};

Measured measured(const std::vector<Mode>& modes, double noise, double low, double high,
                  unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Measured result;
  for (double f = low; f <= high; f += 1) {
    const double w = 2 * M_PI * f;
    std::complex<double> sum = 0;
    for (const Mode& mode : modes) sum += receptance(mode, w);
    result.frequencies.push_back(w);
    result.values.push_back(sum *
                            (1.0 + noise * std::complex<double>(normal(random), normal(random))));
  }
  return result;
}

const std::vector<Mode> kThree{{0.3, 2 * M_PI * 620, 0.031, 0},
                               {0.08, 2 * M_PI * 940, 0.018, 0},
                               {0.05, 2 * M_PI * 1760, 0.024, 0}};

TEST(ModalFit, GivesModesBackDespiteNoise) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Measured m = measured(kThree, 0.02, 100, 3000, seed);
    const ModalFit fit = fit_modes(m.frequencies, m.values, 3);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(fit.modes[i].frequency / kThree[i].frequency, 1, 1e-3);
      EXPECT_NEAR(fit.modes[i].damping_ratio / kThree[i].damping_ratio, 1, 0.05);
      const auto stiffness = [](const Mode& mode) {
        return mode.mass * mode.frequency * mode.frequency;
      };
      EXPECT_NEAR(stiffness(fit.modes[i]) / stiffness(kThree[i]), 1, 0.03);
    }
    EXPECT_LT(fit.error, 0.04);
    EXPECT_GT(fit.error, 0.01);
  }
}

TEST(ModalFit, OfAPartOfTheBandTellsWhatLiesOutside) {
  const Measured m = measured(kThree, 0, 700, 1250, 1);
  const ModalFit fit = fit_modes(m.frequencies, m.values, 1);
  EXPECT_NEAR(fit.modes[0].frequency / kThree[1].frequency, 1, 2e-3);
  EXPECT_GT(fit.stiffness_above, 0);
  EXPECT_GT(fit.mass_below, 0);
  EXPECT_LT(std::abs(fit.at(m.frequencies[100]) - m.values[100]), 0.05 * std::abs(m.values[100]));
}

TEST(ModalFit, RefusesWhatHasNoModes) {
  const Measured m = measured(kThree, 0, 100, 3000, 1);
  EXPECT_THROW(fit_modes(m.frequencies, m.values, 0), std::invalid_argument);
  EXPECT_THROW(fit_modes({1, 2, 3}, {1, 1, 1}, 1), std::invalid_argument);
  std::vector<std::complex<double>> turned = m.values;
  for (auto& value : turned) value = -value;
  EXPECT_THROW(fit_modes(m.frequencies, turned, 2), std::invalid_argument);
}

}  // namespace
}  // namespace evenload
