#include "surface/spacing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "surface/cusp.h"

namespace evenload {

namespace {

constexpr int kStations = 96;   // along a strip, at which cusps are looked at, at the most
constexpr double kApart = 0.5;  // mm between stations, at the least

class CuspSpacing {
 public:
  CuspSpacing(const Ground& ground, const PassFrame& frame, double cusp_height, double deflection)
      : ground_(ground), frame_(frame), rule_(ground, cusp_height, deflection) {
    const double length = frame.end - frame.begin;
    stations_ = std::clamp(static_cast<int>(std::ceil(length / kApart)), 2, kStations);
    pitch_ = length / stations_;
  }

  double level() const { return rule_.level(); }

  // How far the pass after the one at `v` may be; `guess`: what it was last.
  double step_after(double v, double guess) const {
    return rule_.widest(guess, [&](double width) { return highest(v, width); });
  }

 private:
  std::vector<DropSample> row(double v) const {
    std::vector<DropSample> samples;
    for (int i = 0; i <= stations_; ++i)
      samples.push_back(sample_at(ground_, frame_.line(v), frame_.begin + i * pitch_,
                                  samples.empty() ? kNoFacet : samples.back().facet));
    return samples;
  }

  // The highest cusp of the strip of a width from `v` on.
  double highest(double v, double width) const {
    const double covered = frame_.last - frame_.first;
    const double wide = rule_.strip_for(width, covered);
    double middle = v + 0.5 * width;
    // The ground beyond the picked faces tells nothing.
    if (wide < covered)
      middle = std::clamp(middle, frame_.first + 0.5 * wide, frame_.last - 0.5 * wide);
    const std::vector<DropSample> m = row(middle), a = row(middle - 0.5 * wide),
                                  b = row(middle + 0.5 * wide);
    double result = CuspRule::kNothing;
    for (std::size_t k = 0; k < m.size(); ++k)
      if (m[k].is_at_work)
        result =
            std::max(result, rule_.height(width, wide, a[k].z, m[k].z, b[k].z, slope_at(m, k)));
    return result;
  }

  // Along the feed, at a station of a row.
  double slope_at(const std::vector<DropSample>& row, std::size_t k) const {
    const std::size_t before = k > 0 && row[k - 1].is_at_work ? k - 1 : k;
    const std::size_t after = k + 1 < row.size() && row[k + 1].is_at_work ? k + 1 : k;
    if (before == after) return 0;
    return (row[after].z - row[before].z) / (pitch_ * static_cast<double>(after - before));
  }

  const Ground& ground_;
  const PassFrame& frame_;
  CuspRule rule_;
  int stations_ = 0;
  double pitch_ = 0;
};

}  // namespace

PassFrame pass_frame(const Ground& ground, double angle) {
  PassFrame frame{
      unit(angle), left_normal(unit(angle)), HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL, 0, 0};
  for (const Facet& facet : ground.mesh->facets()) {
    if (!facet.is_picked || facet.normal.z == 0) continue;
    for (const SpacePoint& p : facet.corners) {
      const double s = dot(plan(p), frame.along), v = dot(plan(p), frame.across);
      frame.begin = std::min(frame.begin, s);
      frame.end = std::max(frame.end, s);
      frame.first = std::min(frame.first, v);
      frame.last = std::max(frame.last, v);
    }
  }
  if (!(frame.begin < frame.end))
    throw std::invalid_argument(
        "None of the picked faces can be seen from above: pick others, or turn the model.");
  const double extension = ground.extension ? ground.extension->width() : 0;
  frame.begin -= extension;
  frame.end += extension;
  frame.first -= extension;
  frame.last += extension;
  // A contact lies within the tool's radius of its axis.
  const double reach = ground.by_contact ? ground.cutter.radius + ground.allowance : 0;
  frame.begin -= reach;
  frame.end += reach;
  frame.first_pass = frame.first - reach;
  frame.last_pass = frame.last + reach;
  return frame;
}

std::vector<double> even_spacing(const PassFrame& frame, double stepover) {
  const double width = frame.last - frame.first;
  const double count = std::max(1.0, std::ceil(width / stepover - 1e-9));
  const double step = width / count;
  const double beyond = std::floor((frame.first - frame.first_pass) / step + 0.5);
  std::vector<double> ordinates;
  for (double k = -beyond; k < count + beyond; ++k)
    ordinates.push_back(frame.first + (k + 0.5) * step);
  return ordinates;
}

std::vector<double> spacing_by_cusp(const Ground& ground, const PassFrame& frame,
                                    double cusp_height, double deflection, Progress& progress) {
  const CuspSpacing spacing(ground, frame, cusp_height, deflection);
  double step = spacing.step_after(frame.first, spacing.level());
  // Beyond the borders the ground is that of the borders, see CuspSpacing.
  std::vector<double> ordinates;
  const double before = std::floor((frame.first - frame.first_pass) / step + 0.5);
  for (double k = before; k > 0; --k) ordinates.push_back(frame.first - (k - 0.5) * step);
  double v = frame.first + 0.5 * step;
  while (v < frame.last) {
    progress.step();
    ordinates.push_back(v);
    step = spacing.step_after(v, step);
    v += step;
  }
  const double last = frame.last - 0.5 * step;  // the border is half a strip off
  if (ordinates.empty() || ordinates.back() < last) ordinates.push_back(last);
  for (v = frame.last + 0.5 * step; v < frame.last_pass; v += step) ordinates.push_back(v);
  return ordinates;
}

}  // namespace evenload
