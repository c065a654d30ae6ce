#include "judged.h"

#include <cmath>

#include "support/progress.h"

namespace evenload::corpus {
namespace {

constexpr double kMostRate = 1.05;

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

double most_rate(const Case& pocket) { return kMostRate * nominal_rate(pocket); }

}  // namespace evenload::corpus
