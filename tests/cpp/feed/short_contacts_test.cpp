// Contacts hardly longer than what the load is held over as a mean.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "feed/feed_control.h"

namespace evenload {
namespace {

constexpr double kSample = 0.01;  // mm
constexpr int kSamples = 100;

// A way of 1 mm in which the load rises to 1.4 in a fifth of `contact` mm, and falls in two fifths.
std::vector<LoadSample> with_contact(double contact) {
  std::vector<LoadSample> profile;
  for (int i = 0; i < kSamples; ++i) {
    const double at = (kSample * (i + 0.5) - 0.35) / contact;
    const double share = std::clamp(std::min(5 * at, 2.5 * (1 - at)), 0.0, 1.0);
    profile.push_back({0, 0, (i + 0.5) / kSamples, kSample, 0, 0, 0, 1.4 * share});
  }
  return profile;
}

// Share times feed of each sample, over the nominal.
std::vector<double> held(const std::vector<LoadSample>& profile) {
  FeedParams params;
  params.maximum_feed = 1000;
  params.mean_length = 0.1;
  std::vector<PlanarRun> runs(1);
  runs[0].moves.push_back({MoveKind::kCut, Segment::line({0, 0}, {1, 0})});
  std::vector<double> rates = set_constant_load(runs, profile, params);
  for (std::size_t i = 0; i < rates.size(); ++i) rates[i] *= profile[i].share / params.feed;
  return rates;
}

// The worst mean over pieces of `length` mm, and so many that they are 0.1 mm, each looked at in
// its middle alone; the first begins anywhere.
double worst_by_few_looks(const std::vector<double>& rates, double length) {
  const int pieces = static_cast<int>(std::ceil(0.1 / length - 1e-9));
  double worst = 0;
  for (double first = 0; first + pieces * length < 1; first += 0.5 * kSample) {
    double sum = 0;
    for (int i = 0; i < pieces; ++i)
      sum += rates[static_cast<std::size_t>((first + (i + 0.5) * length) / kSample)];
    worst = std::max(worst, sum / pieces);
  }
  return worst;
}

TEST(ShortContacts, AreHeldHoweverFewLooksSeeThem) {
  double worst = 0;
  for (const double contact : {0.04, 0.08, 0.12, 0.16, 0.2, 0.25})
    for (const double length : {0.05, 0.075, 0.1})
      worst = std::max(worst, worst_by_few_looks(held(with_contact(contact)), length));
  EXPECT_LE(worst, 1 + 1e-9);
  EXPECT_GT(worst, 0.95);
}

// Longer ones are held as means, in which a sample may be a little above.
TEST(ShortContacts, AreThoseOfLessThanThreeMeans) {
  const auto peak = [](double contact) {
    const std::vector<double> rates = held(with_contact(contact));
    return *std::max_element(rates.begin(), rates.end());
  };
  EXPECT_LE(peak(0.27), 1 + 1e-9);
  EXPECT_GT(peak(0.4), 1.001);
}

}  // namespace
}  // namespace evenload
