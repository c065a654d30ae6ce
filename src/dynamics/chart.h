// The stability chart: where in the plane of spindle speed and depth rho is 1.
//
// Multi-dimensional bisection of rho - 1, level by level, so that a first picture is there soon.
// Laws: those of Mdbm; every point of a curve has rho = 1 within the chart's tolerance.
#pragma once

#include <vector>

#include "dynamics/mdbm.h"
#include "dynamics/stability.h"

namespace evenload {

// Accuracy of rho in charts: its error shifts a boundary by far less than a cell.
inline constexpr double kChartAccuracy = 1e-3;

class StabilityChart {
 public:
  struct Curve {
    std::vector<double> speeds, depths;       // rad/s, m
    std::vector<BoundaryKind> kinds;          // of each point
    std::vector<double> chatter_frequencies;  // rad/s
  };

  // speeds in rad/s, depths in m. Throws std::invalid_argument as check(), for speeds that are not
  // above 0 and for negative depths. threads: 0 = as many as the machine has.
  StabilityChart(const Milling& milling, MdbmAxis speeds, MdbmAxis depths, int threads);

  void begin(Progress& progress, int every = 1) { mdbm_.begin(progress, every); }
  void halve(Progress& progress) { mdbm_.halve(progress); }
  const Mdbm& mdbm() const { return mdbm_; }
  std::vector<Curve> curves(Progress& progress) const;

 private:
  Milling milling_;
  int threads_;
  Mdbm mdbm_;
};

// rho for each pair of a speed in rad/s and a depth in m.
std::vector<double> spectral_radii(const Milling& milling, const std::vector<double>& speeds,
                                   const std::vector<double>& depths, double accuracy, int threads,
                                   Progress& progress);

}  // namespace evenload
