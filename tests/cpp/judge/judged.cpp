#include "judge/judged.h"

#include <cmath>
#include <map>
#include <utility>

#include "strategy/pocket/constant_engagement.h"
#include "support/progress.h"

namespace evenload::corpus {
namespace {

constexpr double kMostRate = 1.052;  // as the feed control's 1.05, and what its samples miss
constexpr double kThinnest = 1e-6;   // mm, that the simulator sees

}  // namespace

std::vector<Finding> findings_of(const Report& report, FindingCode code) {
  std::vector<Finding> result;
  for (const Finding& finding : report.findings)
    if (finding.code == code) result.push_back(finding);
  return result;
}

bool tells(const Report& report, FindingCode code) { return !findings_of(report, code).empty(); }

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

const Home& at_home(const std::string& name) {
  static std::map<std::string, Home> homes;
  const auto known = homes.find(name);
  if (known != homes.end()) return known->second;
  Home home{load(name), {}, {}};
  home.path = clear(home.pocket, home.pocket.params());
  path_check::Settings settings;
  settings.thinnest = kThinnest;
  home.seen = judge(home.pocket, home.path, settings);
  return homes.emplace(name, std::move(home)).first->second;
}

double nominal_rate(const Case& pocket) {
  return 0.5 * pocket.tool_diameter * (1 - std::cos(pocket.engagement_angle)) * pocket.feed;
}

double most_rate(const Case& pocket) { return kMostRate * nominal_rate(pocket); }

}  // namespace evenload::corpus
