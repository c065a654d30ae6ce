// The milling process: what is refused.
#include "dynamics/milling.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "dynamics/cases.h"
#include "dynamics/stability.h"

namespace evenload {
namespace {

using namespace dynamics_cases;

TEST(Milling, RefusesWhatCannotBe) {
  const auto sentence = [](auto change) {
    Milling m = slot();
    change(m);
    try {
      spectral_radius(m, 100, 1e-3, 1e-3);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(sentence([](Milling& m) { m.modes.clear(); }).find("no mode"), std::string::npos);
  EXPECT_NE(sentence([](Milling& m) { m.modes[0].mass = -1; }).find("mass"), std::string::npos);
  EXPECT_NE(sentence([](Milling& m) { m.modes[0].damping_ratio = -1; }).find("damping"),
            std::string::npos);
  EXPECT_NE(sentence([](Milling& m) { m.engagement = 0; }).find("immersion"), std::string::npos);
  EXPECT_NE(sentence([](Milling& m) { m.teeth = 0; }).find("tooth"), std::string::npos);
  EXPECT_NE(sentence([](Milling& m) { m.tooth_angles = {1, 2}; }).find("sum"), std::string::npos);
  EXPECT_THROW(spectral_radius(slot(), 0, 1e-3, 1e-3), std::invalid_argument);
  EXPECT_THROW(spectral_radius(slot(), 100, -1e-3, 1e-3), std::invalid_argument);
  EXPECT_THROW(spectral_radius(slot(), 100, 1e-3, 0), std::invalid_argument);
}

}  // namespace
}  // namespace evenload
