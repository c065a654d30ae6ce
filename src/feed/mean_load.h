// Loads as means along a path: where the load changes within a tenth of a millimetre, a feed that
// keeps its mean is faster than one that keeps its peak, and as much is removed in a time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "feed/load_profile.h"

namespace evenload {

// Samples [first, last) at one feed.
struct FeedPiece {
  std::size_t first = 0, last = 0;
  double feed = 0;  // mm/min
  bool operator==(const FeedPiece&) const = default;
};

// Samples one after the other; beyond the first and the last nothing is met.
class MeanLoad {
 public:
  // Means over `window` mm; 0: each sample is looked at by itself.
  MeanLoad(const LoadSample* samples, std::size_t count, double window);

  // mm: of the samples [first, last).
  double length(std::size_t first, std::size_t last) const { return until_[last] - until_[first]; }

  // Whether a sample is in a contact so short, of less than three windows, that who looks at a few
  // places of a window may see no more of it than its peak.
  bool is_in_short_contact(std::size_t sample) const { return in_short_contact_[sample]; }

  // What the samples [first, last) have in common at one feed: the greatest mean over a window that
  // they hold, or over all of them where they hold none. `without_last`: the same of the samples
  // [first, last - 1).
  double share(std::size_t first, std::size_t last, double without_last) const {
    const double whole = length(first, last);
    if (window_ <= 0 || whole <= 0) return std::max(without_last, share_[last - 1]);
    if (whole <= window_) return (sum_[last] - sum_[first]) / whole;
    double greatest = before_[last];
    if (length(first, last - 1) > window_) greatest = std::max(greatest, without_last);
    // Windows that the last sample has made room for.
    for (std::size_t i = std::max(first, latest_[last]); length(i, last - 1) <= window_; --i) {
      greatest = std::max(greatest, after_[i]);
      if (i == first) break;
    }
    return greatest;
  }

  // Lowers feeds, those of the fastest pieces first, where the mean of share times feed over a
  // window is above `nominal`. Condition: `pieces` hold the samples in their order, without gaps.
  // False where there is no such window.
  bool limit(std::vector<FeedPiece>& pieces, double nominal) const;

 private:
  std::size_t sample_at(double place) const;
  bool limit(std::vector<FeedPiece>& pieces, const std::vector<std::size_t>& piece_of, double from,
             double nominal) const;

  double window_;
  std::vector<double> share_;
  std::vector<double> until_;  // mm, to the start of each sample, and to the end of the last
  std::vector<double> sum_;    // of shares times mm, likewise
  std::vector<double> after_, before_;  // means over the windows after and before these places
  std::vector<std::size_t> latest_;     // the last place a window and more before each
  std::vector<char> in_short_contact_;
};

}  // namespace evenload
