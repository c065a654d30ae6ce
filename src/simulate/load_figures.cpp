#include "simulate/load_figures.h"

#include <algorithm>
#include <vector>

namespace evenload {
namespace {

// A mean over the last kLoadWindow mm of a path on which a value runs straight between samples.
class WindowMean {
 public:
  void restart() {
    first_ = 0;
    lengths_.clear();
    sums_.clear();
    length_ = sum_ = 0;
  }
  // Adds a piece of path and returns the mean up to its end. A path shorter than the window is
  // taken as if it went on without load.
  double add(double length, double mean) {
    lengths_.push_back(length);
    sums_.push_back(length * mean);
    length_ += length;
    sum_ += length * mean;
    while (first_ + 1 < lengths_.size() && length_ - lengths_[first_] >= kLoadWindow) {
      length_ -= lengths_[first_];
      sum_ -= sums_[first_];
      ++first_;
    }
    if (length_ <= kLoadWindow) return sum_ / kLoadWindow;
    const double out = (length_ - kLoadWindow) / lengths_[first_];  // share of the oldest piece
    return (sum_ - out * sums_[first_]) / kLoadWindow;
  }

 private:
  std::size_t first_ = 0;
  std::vector<double> lengths_, sums_;
  double length_ = 0, sum_ = 0;
};

void keep_worst(Worst& worst, double value, const Place& at) {
  if (value > worst.value) worst = {value, at};
}

}  // namespace

void add_up_record(const LoadRecord& record, LoadFigures& figures) {
  WindowMean engagement, rate;
  for (std::size_t i = 0; i < record.size(); ++i) {
    const auto kind = static_cast<MoveKind>(record.kind[i]);
    const Place at{record.x[i], record.y[i], record.z[i]};
    if (i > 0 && record.kind[i] != record.kind[i - 1]) {
      engagement.restart();
      rate.restart();
    }
    if (!record.force_peak.empty() && (kind == MoveKind::kCut || kind == MoveKind::kEntry))
      keep_worst(figures.force, record.force_peak[i], at);
    const double length = record.length[i];
    if (!(length > 0)) continue;
    switch (kind) {
      case MoveKind::kRapid:
        figures.rapid_length += length;
        continue;
      case MoveKind::kEntry:
        figures.entry_length += length;
        break;
      case MoveKind::kLink:
        figures.link_length += length;
        break;
      case MoveKind::kCut:
        figures.cut_length += length;
        break;
    }
    // Straight down there is no side that is engaged: what stands under the tool is a plunge's.
    const bool is_upright = record.x[i] == record.x[i - 1] && record.y[i] == record.y[i - 1];
    const double mean = is_upright && kind == MoveKind::kLink
                            ? 0
                            : 0.5 * (record.engagement[i - 1] + record.engagement[i]);
    const double worst = engagement.add(length, mean);
    if (kind != MoveKind::kCut) {
      keep_worst(kind == MoveKind::kLink ? figures.link_engagement : figures.entry_engagement,
                 worst, at);
      continue;
    }
    if (mean == 0) figures.air_length += length;
    keep_worst(figures.engagement, worst, at);
    keep_worst(figures.removal_rate,
               rate.add(length, 0.5 * (record.removal_rate[i - 1] + record.removal_rate[i])), at);
  }
  if (record.size() > 0) figures.time = record.time.back();
  if (!record.machine_time.empty()) figures.machine_time = record.machine_time.back();
}

}  // namespace evenload
