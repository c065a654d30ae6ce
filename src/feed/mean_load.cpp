#include "feed/mean_load.h"

#include <algorithm>

namespace evenload {
namespace {

// Share of the nominal load: rounding.
constexpr double kNoWeight = 1e-9;
// Of the nominal load: what is less does not lengthen a contact.
constexpr double kInContact = 0.05;
// Windows: shorter contacts are short.
constexpr double kShortContact = 3;

// Whether each sample is in a contact shorter than `shortest` mm.
std::vector<char> in_short_contacts(const LoadSample* samples, std::size_t count, double shortest) {
  std::vector<char> result(count, false);
  for (std::size_t first = 0; first < count; ++first) {
    std::size_t last = first;
    double length = 0;
    for (; last < count && samples[last].share > kInContact; ++last) length += samples[last].length;
    std::fill(result.begin() + static_cast<std::ptrdiff_t>(first),
              result.begin() + static_cast<std::ptrdiff_t>(last), length < shortest);
    first = last;
  }
  return result;
}

}  // namespace

MeanLoad::MeanLoad(const LoadSample* samples, std::size_t count, double window)
    : window_(window),
      until_{0},
      sum_{0},
      in_short_contact_(in_short_contacts(samples, count, kShortContact * window)) {
  for (std::size_t i = 0; i < count; ++i) {
    share_.push_back(samples[i].share);
    until_.push_back(until_.back() + samples[i].length);
    sum_.push_back(sum_.back() + samples[i].share * samples[i].length);
  }
  if (window_ <= 0 || count == 0) return;
  const auto sum_until = [&](std::size_t sample, double place) {
    return sum_[sample] + (place - until_[sample]) * share_[sample];
  };
  for (std::size_t i = 0, ahead = 0, behind = 0; i <= count; ++i) {
    const double place = until_[i];
    const double to = std::min(place + window_, until_.back()),
                 from = std::max(0.0, place - window_);
    while (ahead + 1 < count && until_[ahead + 1] < to) ++ahead;
    while (behind + 1 < count && until_[behind + 1] <= from) ++behind;
    after_.push_back((sum_until(ahead, to) - sum_[i]) / window_);
    before_.push_back((sum_[i] - sum_until(behind, from)) / window_);
    latest_.push_back(behind);
  }
}

std::size_t MeanLoad::sample_at(double place) const {
  const auto after = std::upper_bound(until_.begin() + 1, until_.end() - 1, place);
  return static_cast<std::size_t>(after - until_.begin()) - 1;
}

bool MeanLoad::limit(std::vector<FeedPiece>& pieces, double nominal) const {
  if (window_ <= 0) return false;
  std::vector<std::size_t> piece_of;  // each sample's
  for (std::size_t k = 0; k < pieces.size(); ++k)
    piece_of.resize(piece_of.size() + pieces[k].last - pieces[k].first, k);
  // A window begins or ends at each place; `ahead` and `behind` are the samples that its other end
  // is in. Those within a piece are held already.
  const std::size_t n = share_.size();
  bool lowered = false;
  for (std::size_t i = 0, ahead = 0, behind = 0; i <= n; ++i) {
    const double place = until_[i];
    while (ahead + 1 < n && until_[ahead + 1] < place + window_) ++ahead;
    while (behind + 1 < n && until_[behind + 1] <= place - window_) ++behind;
    if (i < n && piece_of[i] != piece_of[ahead])
      lowered = limit(pieces, piece_of, place, nominal) || lowered;
    if (i > 0 && piece_of[i - 1] != piece_of[behind])
      lowered = limit(pieces, piece_of, place - window_, nominal) || lowered;
  }
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
  if (excess <= kNoWeight * nominal * window_) return false;
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
