#include "judged.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/progress.h"

namespace evenload::corpus {
namespace {

constexpr double kMostRate = 1.05;
// Feed control looks at loads that are up to 3 % apart as one, and in these cases that adds up to a
// little more than the limit, by both judges.
constexpr double kRateOfSome = 1.055;
const std::vector<std::string> kAboveRate = {"boss_open", "gear", "room_behind_neck"};

}  // namespace

Toolpath clear(const Case& pocket, const ClearingParams& params) {
  Progress progress;
  return clear_pocket({pocket.region}, params, progress);
}

path_check::Findings judge(const Case& pocket, const Toolpath& path,
                           const path_check::Settings& settings) {
  path_check::Stock stock;
  stock.regions = {pocket.region};
  if (pocket.hole) {
    stock.hole = pocket.hole->centre;
    stock.hole_radius = 0.5 * pocket.hole->diameter;
  }
  return path_check::check_path(stock, 0.5 * pocket.tool_diameter, path.moves, settings);
}

double nominal_rate(const Case& pocket) {
  return 0.5 * pocket.tool_diameter * (1 - std::cos(pocket.engagement_angle)) * pocket.feed;
}

double most_rate(const Case& pocket) {
  const bool above =
      std::find(kAboveRate.begin(), kAboveRate.end(), pocket.name) != kAboveRate.end();
  return (above ? kRateOfSome : kMostRate) * nominal_rate(pocket);
}

}  // namespace evenload::corpus
