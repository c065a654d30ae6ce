#include "strategy/pocket/rest_levels.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace evenload {
namespace {

bool same(const Curve& a, const Curve& b) {
  return std::equal(
      a.vertices().begin(), a.vertices().end(), b.vertices().begin(), b.vertices().end(),
      [](const Vertex& v, const Vertex& w) { return v.p == w.p && v.bulge == w.bulge; });
}

bool same(const std::vector<Region>& a, const std::vector<Region>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Region& r, const Region& s) {
    const std::vector<Curve> x = r.curves(), y = s.curves();
    return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                      [](const Curve& c, const Curve& d) { return same(c, d); });
  });
}

void add(Toolpath& path, Toolpath&& more) {
  Report& sum = path.report;
  const Report& part = more.report;
  // From the end of the one, at the clearance height, to the start of the other, the same.
  sum.retracts += part.retracts + (path.moves.empty() || more.moves.empty() ? 0 : 1);
  path.moves.insert(path.moves.end(), more.moves.begin(), more.moves.end());
  sum.termination = std::max(sum.termination, part.termination);
  sum.max_engagement = std::max(sum.max_engagement, part.max_engagement);
  sum.uncut_area = std::max(sum.uncut_area, part.uncut_area);
  sum.cutting_time += part.cutting_time;
  sum.ideal_time += part.ideal_time;
  sum.removed_volume += part.removed_volume;
  sum.cut_length += part.cut_length;
  sum.link_length += part.link_length;
  sum.passes += part.passes;
  sum.links += part.links;
  for (const Finding& finding : part.findings)
    if (std::find(sum.findings.begin(), sum.findings.end(), finding) == sum.findings.end())
      sum.findings.push_back(finding);
}

}  // namespace

Toolpath clear_rest(const std::vector<Region>& regions,
                    const std::vector<std::vector<Region>>& stocks, const ClearingParams& params,
                    Progress& progress) {
  const std::vector<double>& levels = params.levels;
  if (stocks.size() != 1 && stocks.size() != levels.size())
    throw std::invalid_argument("The stock must be given once, or once for each level.");
  const auto stock_at = [&](std::size_t k) -> const std::vector<Region>& {
    return stocks[stocks.size() == 1 ? 0 : k];
  };
  Toolpath path;
  const double all = static_cast<double>(levels.size());
  for (std::size_t first = 0; first < levels.size() && !progress.cancelled();) {
    std::size_t last = first + 1;
    while (last < levels.size() && same(stock_at(first), stock_at(last))) ++last;
    ClearingParams part = params;
    part.top = first == 0 ? params.top : levels[first - 1];
    part.levels.assign(levels.begin() + static_cast<std::ptrdiff_t>(first),
                       levels.begin() + static_cast<std::ptrdiff_t>(last));
    part.stock = stock_at(first);
    Progress share([&](double done) {
      const double from = static_cast<double>(first), to = static_cast<double>(last);
      return progress.report((from + done * (to - from)) / all);
    });
    add(path, clear_pocket(regions, part, share));
    first = last;
  }
  if (path.moves.empty() && path.report.termination == Termination::kComplete &&
      !progress.cancelled())
    path.report.findings.push_back({FindingCode::kNothingLeft});
  return path;
}

}  // namespace evenload
