#include "feed/feed_control.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "feed/feed_division.h"
#include "support/both.h"

namespace evenload {
namespace {

// Share of a block's price: a gain below it is no reason to look for another division.
constexpr double kLittle = 0.25;
// Share of the nominal load: samples beside each other that differ more stand at a jump.
constexpr double kJump = 1;
// Fewer are divided sooner than a thread is started.
constexpr std::size_t kManySamples = 2000;
constexpr double kSameFeed = 1e-9;  // share of a feed

// s, a price for every change of feed in it.
double cost_of(const std::vector<FeedPiece>& pieces, const std::vector<LoadSample>& profile,
               const FeedParams& params) {
  double cost = 0;
  for (const FeedPiece& piece : pieces) {
    const bool ends_move = piece.last == pieces.back().last ||
                           profile[piece.last].move != profile[piece.last - 1].move;
    cost += ends_move ? kChangePrice : params.steps.price;
    for (std::size_t i = piece.first; i < piece.last; ++i)
      cost += profile[i].length / piece.feed * 60;
  }
  return cost;
}

// Those beside each other at one feed as one.
std::vector<FeedPiece> joined(const std::vector<FeedPiece>& pieces) {
  std::vector<FeedPiece> result;
  for (const FeedPiece& piece : pieces)
    if (!result.empty() && std::abs(result.back().feed - piece.feed) < kSameFeed * piece.feed)
      result.back() = {result.back().first, piece.last, std::min(result.back().feed, piece.feed)};
    else
      result.push_back(piece);
  return result;
}

// True where the load jumps, as beyond a corner that is cut bit by bit: over so short a way that a
// mean depends on where looks are taken.
bool has_jump(const LoadSample* samples, std::size_t count) {
  return std::adjacent_find(samples, samples + count, [](const LoadSample& a, const LoadSample& b) {
           return std::abs(a.share - b.share) > kJump;
         }) != samples + count;
}

}  // namespace

// A cut from link to link.
class ConstantLoad::Stretch {
 public:
  Stretch(const CutSamples& cut, const FeedParams& params, Progress* progress)
      : cut_(cut),
        progress_(progress),
        may_change_(places_for_change(cut, params)),
        jumps_(has_jump(samples(), count())),
        means_(samples(), count(), jumps_ ? 0 : params.mean_length) {}

  std::size_t last() const { return cut_.last; }

  // What is best at two prices is best at all between; where means are held, which is not quite the
  // best, nearly always.
  const std::vector<FeedPiece>& pieces(const FeedParams& params) {
    const double price = params.steps.price;
    const auto next = known_.lower_bound(price);
    if (next != known_.end() && next->first == price) return next->second;
    if (next != known_.begin() && next != known_.end() && next->second == std::prev(next)->second)
      return next->second;
    return known_.emplace_hint(next, price, divided(params))->second;
  }

 private:
  const LoadSample* samples() const { return cut_.profile.data() + cut_.first; }
  std::size_t count() const { return cut_.last - cut_.first; }

  // Feeds by means are found as if each piece were alone, and lowered where one is too fast beside
  // another. Where that costs more than means gain, or the load jumps, every sample is held.
  std::vector<FeedPiece> divided(const FeedParams& params) {
    std::vector<FeedPiece> pieces = best_division(cut_, means_, may_change_, params, progress_);
    if (jumps_) return pieces;
    const double least = cost_of(pieces, cut_.profile, params);  // of samples that are held, too
    if (!means_.limit(pieces, params.feed)) return pieces;
    pieces = joined(pieces);
    const double cost = cost_of(pieces, cut_.profile, params);
    if (cost - least < kLittle * params.steps.price) return pieces;
    if (!peaks_) peaks_.emplace(samples(), count(), 0);
    std::vector<FeedPiece> held = best_division(cut_, *peaks_, may_change_, params, progress_);
    return cost > cost_of(held, cut_.profile, params) ? held : pieces;
  }

  CutSamples cut_;
  Progress* progress_;
  std::vector<char> may_change_;
  bool jumps_;
  MeanLoad means_;
  std::optional<MeanLoad> peaks_;
  std::map<double, std::vector<FeedPiece>> known_;  // by the price of a block
};

double allowed_feed(double share, const FeedParams& params) {
  return share * params.maximum_feed <= params.feed ? params.maximum_feed : params.feed / share;
}

void set_constant_feed(std::vector<PlanarRun>& runs, const FeedParams& params) {
  for (PlanarRun& run : runs)
    for (PlanarMove& move : run.moves)
      move.feed = move.kind == MoveKind::kLink ? params.link_feed : params.feed;
}

ConstantLoad::ConstantLoad(const std::vector<PlanarRun>& runs,
                           const std::vector<LoadSample>& profile, const FeedParams& params,
                           Progress* progress)
    : runs_(runs), profile_(profile), params_(params), progress_(progress) {
  for (std::size_t i = 0; i < profile.size();) {
    std::size_t end = i;
    const bool cuts = is_cut(i);
    while (end < profile.size() && profile[end].run == profile[i].run && is_cut(end) == cuts) ++end;
    if (progress_) progress_->step();
    if (cuts) stretches_.emplace_back(CutSamples{runs, profile, i, end}, params, progress);
    i = end;
  }
}

ConstantLoad::~ConstantLoad() = default;

bool ConstantLoad::is_cut(std::size_t sample) const {
  const LoadSample& s = profile_[sample];
  return runs_[s.run].moves[s.move].kind == MoveKind::kCut;
}

// All stretches, half of the samples at a time where these are many.
void ConstantLoad::divide() {
  const auto divide_some = [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) stretches_[k].pieces(params_);
    return true;
  };
  const std::size_t all = stretches_.size();
  if (profile_.size() < kManySamples) {
    divide_some(0, all);
    return;
  }
  std::size_t half = 0;
  while (half < all && stretches_[half].last() <= profile_.size() / 2) ++half;
  both([&] { return divide_some(0, half); }, [&] { return divide_some(half, all); }, progress_);
}

FeedsAlong ConstantLoad::at(double price) {
  params_.steps.price = price;
  divide();
  FeedsAlong found;
  found.feeds.assign(profile_.size(), params_.link_feed);
  for (const PlanarRun& run : runs_) found.runs.push_back({run.descent, {}, run.new_region});
  auto stretch = stretches_.begin();
  for (std::size_t i = 0; i < profile_.size();) {
    if (is_cut(i)) {
      if (progress_) progress_->step();
      for (const FeedPiece& piece : stretch->pieces(params_)) add(piece, found);
      i = stretch->last();
      ++stretch;
    } else {
      const std::size_t run = profile_[i].run, move = profile_[i].move;
      PlanarMove link = runs_[run].moves[move];
      link.feed = params_.link_feed;
      found.runs[run].moves.push_back(link);
      while (i < profile_.size() && profile_[i].run == run && profile_[i].move == move) ++i;
    }
  }
  return found;
}

// The piece's samples, move by move.
void ConstantLoad::add(const FeedPiece& piece, FeedsAlong& found) const {
  std::fill_n(found.feeds.data() + piece.first, piece.last - piece.first, piece.feed);
  for (std::size_t a = piece.first; a < piece.last;) {
    std::size_t b = a;
    while (b < piece.last && profile_[b].move == profile_[a].move) ++b;
    PlanarMove part = runs_[profile_[a].run].moves[profile_[a].move];
    const double length = part.segment.length();
    const double t0 = std::max(0.0, profile_[a].t - 0.5 * profile_[a].length / length);
    const double t1 = std::min(1.0, profile_[b - 1].t + 0.5 * profile_[b - 1].length / length);
    const bool whole = t0 < 1e-9 && t1 > 1 - 1e-9;
    if (!whole) part.segment = part.segment.part(t0, t1);
    part.feed = piece.feed;
    found.runs[profile_[a].run].moves.push_back(part);
    a = b;
  }
}

std::vector<double> set_constant_load(std::vector<PlanarRun>& runs,
                                      const std::vector<LoadSample>& profile,
                                      const FeedParams& params, Progress* progress) {
  FeedsAlong found = ConstantLoad(runs, profile, params, progress).at(params.steps.price);
  runs = std::move(found.runs);
  return std::move(found.feeds);
}

}  // namespace evenload
