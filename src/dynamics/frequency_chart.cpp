#include "dynamics/frequency_chart.h"

#include <cmath>
#include <complex>
#include <map>
#include <stdexcept>

#include "dynamics/mdbm_curves.h"
#include "support/parallel.h"

namespace evenload {

FrequencyChart::FrequencyChart(const FrequencyDomain& domain, MdbmAxis speeds, MdbmAxis depths,
                               double centre, int frequency_cells, int threads)
    : domain_(domain),
      centre_(centre),
      mdbm_({{speeds, depths, {-0.5, 0.5, frequency_cells}},
             2,
             false,
             [domain, centre](const double* at, double* values) {
               const std::complex<double> value =
                   domain.determinant(at[0], at[1], centre + at[2] * domain.base(at[0]));
               // Deep in unstable ground it is huge: planes through a cell's corners would miss.
               values[0] = value.real() / (1 + std::abs(value));
               values[1] = value.imag() / (1 + std::abs(value));
             },
             thread_count(threads)}) {
  check_speed_and_depth(speeds.low, depths.low);
}

FrequencyCurves FrequencyChart::curves() const {
  FrequencyCurves result = evenload::curves(mdbm_);
  for (std::vector<double>& line : result)
    for (std::size_t i = 0; i < line.size(); i += 3)
      line[i + 2] = std::abs(centre_ + line[i + 2] * domain_.base(line[i]));
  return result;
}

FrequencyCurves zeroth_order_lobes(const Milling& milling, const Receptance& receptance,
                                   MdbmAxis speeds, MdbmAxis depths, double lowest, double highest,
                                   int count) {
  check(milling);
  check_speed_and_depth(speeds.low, depths.low);
  FrequencyCurves result;
  std::map<std::pair<int, int>, std::vector<double>> open;  // by eigenvalue and lobe
  for (int i = 0; i <= count; ++i) {
    const double frequency = lowest + (highest - lowest) * i / count;
    std::map<std::pair<int, int>, std::vector<double>> now;
    const std::vector<ZerothOrder> limits = zeroth_order(milling, receptance, frequency);
    for (std::size_t which = 0; which < limits.size(); ++which) {
      const double depth = limits[which].depth;
      if (depth < depths.low || depth > depths.high) continue;
      const double turn = frequency * milling.period_angle();
      const int first = std::max(
          0, static_cast<int>(std::ceil((turn / speeds.high - limits[which].phase) / (2 * M_PI))));
      for (int lobe = first;; ++lobe) {
        const double angle = limits[which].phase + 2 * M_PI * lobe;
        if (!(angle > 0)) continue;
        if (turn / angle < speeds.low) break;
        const std::pair<int, int> key(static_cast<int>(which), lobe);
        std::vector<double> line = open.count(key) ? open[key] : std::vector<double>{};
        line.insert(line.end(), {turn / angle, depth, frequency});
        now[key] = std::move(line);
      }
    }
    for (auto& [key, line] : open)
      if (!now.count(key) && line.size() > 3) result.push_back(line);
    open = std::move(now);
  }
  for (auto& [key, line] : open)
    if (line.size() > 3) result.push_back(line);
  return result;
}

}  // namespace evenload
