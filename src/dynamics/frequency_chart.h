// Stability charts in the frequency domain: for measured responses, and beside those of chart.h.
//
// Every depth at which a vibration neither grows nor dies is on a curve, also within unstable
// ground: the chart is their lower envelope, and islands.
#pragma once

#include <vector>

#include "dynamics/frequency_domain.h"
#include "dynamics/mdbm.h"

namespace evenload {

// Points (speed in rad/s, depth in m, chatter frequency in rad/s), curve by curve.
using FrequencyCurves = std::vector<std::vector<double>>;

// By bisection in speed, depth and frequency, the last within one base around `centre`, in rad/s.
// Throws std::invalid_argument as FrequencyDomain() and Mdbm().
class FrequencyChart {
 public:
  FrequencyChart(const FrequencyDomain& domain, MdbmAxis speeds, MdbmAxis depths, double centre,
                 int frequency_cells, int threads);
  void begin(Progress& progress) { mdbm_.begin(progress); }
  void halve(Progress& progress) { mdbm_.halve(progress); }
  const Mdbm& mdbm() const { return mdbm_; }
  FrequencyCurves curves() const;

 private:
  FrequencyDomain domain_;
  double centre_;
  Mdbm mdbm_;
};

// The lobes of the zeroth order within a box, from `count` chatter frequencies between `lowest` and
// `highest`, rad/s. Condition: even pitch.
FrequencyCurves zeroth_order_lobes(const Milling& milling, const Receptance& receptance,
                                   MdbmAxis speeds, MdbmAxis depths, double lowest, double highest,
                                   int count);

}  // namespace evenload
