#include "feed/mean_load.h"

#include <algorithm>

namespace evenload {
namespace {

// Share of the nominal load: rounding.
constexpr double kRounding = 1e-9;

}  // namespace

MeanLoad::MeanLoad(const LoadSample* samples, std::size_t count, double window)
    : window_(window), until_{0}, sum_{0} {
  for (std::size_t i = 0; i < count; ++i) {
    share_.push_back(samples[i].share);
    until_.push_back(until_.back() + samples[i].length);
    sum_.push_back(sum_.back() + samples[i].share * samples[i].length);
  }
  if (window_ <= 0) return;
  for (const double place : until_) {
    after_.push_back(mean(place, place + window_));
    before_.push_back(mean(place - window_, place));
  }
}

std::size_t MeanLoad::sample_at(double place) const {
  const auto after = std::upper_bound(until_.begin() + 1, until_.end() - 1, place);
  return static_cast<std::size_t>(after - until_.begin()) - 1;
}

double MeanLoad::sum_until(double place) const {
  place = std::clamp(place, 0.0, until_.back());
  const std::size_t i = sample_at(place);
  return sum_[i] + (place - until_[i]) * share_[i];
}

double MeanLoad::mean(double from, double to) const {
  return (sum_until(to) - sum_until(from)) / (to - from);
}

double MeanLoad::share(std::size_t first, std::size_t last, double without_first) const {
  if (window_ <= 0) return std::max(without_first, share_[first]);
  const double end = until_[last];
  if (end - until_[first] <= window_) return (sum_[last] - sum_[first]) / (end - until_[first]);
  const bool is_first_window = end - until_[first + 1] <= window_;
  return std::max(after_[first], is_first_window ? before_[last] : without_first);
}

bool MeanLoad::limit(std::vector<FeedPiece>& pieces, double nominal) const {
  if (window_ <= 0) return false;
  std::vector<std::size_t> piece_of;  // each sample's
  for (std::size_t k = 0; k < pieces.size(); ++k)
    piece_of.resize(piece_of.size() + pieces[k].last - pieces[k].first, k);
  bool lowered = false;
  for (const double place : until_)
    for (const double from : {place, place - window_})
      lowered = limit(pieces, piece_of, from, nominal) || lowered;
  return lowered;
}

// The window from `from` mm on.
bool MeanLoad::limit(std::vector<FeedPiece>& pieces, const std::vector<std::size_t>& piece_of,
                     double from, double nominal) const {
  struct Part {
    FeedPiece* piece;
    double sum;  // of shares times mm
  };
  std::vector<Part> parts;
  double excess = -nominal * window_;
  const double to = std::min(from + window_, until_.back());
  for (std::size_t i = sample_at(from); i < share_.size() && until_[i] < to; ++i) {
    FeedPiece& piece = pieces[piece_of[i]];
    const double sum = share_[i] * (std::min(to, until_[i + 1]) - std::max(from, until_[i]));
    excess += sum * piece.feed;
    if (parts.empty() || parts.back().piece != &piece) parts.push_back({&piece, 0});
    parts.back().sum += sum;
  }
  if (excess <= kRounding * nominal * window_) return false;
  std::sort(parts.begin(), parts.end(),
            [](const Part& a, const Part& b) { return a.piece->feed > b.piece->feed; });
  double sum = 0;  // of the parts that are lowered, all to one feed
  std::size_t lowered = 0;
  double feed = 0;
  for (; excess > 0 && lowered < parts.size(); ++lowered) {
    feed = parts[lowered].piece->feed;
    sum += parts[lowered].sum;
    const double next = lowered + 1 < parts.size() ? parts[lowered + 1].piece->feed : 0;
    const double lower = sum > 0 ? std::max(next, feed - excess / sum) : next;
    excess -= sum * (feed - lower);
    feed = lower;
    if (lower > next) excess = 0;
  }
  for (std::size_t k = 0; k < lowered; ++k) parts[k].piece->feed = feed;
  return true;
}

}  // namespace evenload
