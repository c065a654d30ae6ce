#include "feed/feed_division.h"

#include <algorithm>
#include <limits>

#include "toolpath/machinable.h"

namespace evenload {
namespace {

// mm: no feed changes within a move nearer to its ends than this; what is rounded to a post's
// 0.001 mm turns shorter arcs by more than a degree.
constexpr double kShortestPart = 0.1;
// mm: the same, and the least length of a piece, where a least load is asked for.
constexpr double kShortestEven = 0.02;
constexpr double kRounding = 1e-9;  // s
// s/mm: what a piece costs more in which the load falls below the least that is asked for; so much
// that blocks are spent wherever they mend it.
constexpr double kUnevenPrice = 10;
// A piece of one feed holds at most this many samples: bounds the search.
constexpr std::size_t kLongestPiece = 400;
// Samples of a step of progress: each is looked at together with those of a piece.
constexpr std::size_t kSamplesOfStep = 256;

// Whether a part of a move this long can be posted as what it is.
bool can_be_part(const Segment& move, double length, double shortest) {
  return length >= shortest &&
         !(move.is_arc() && becomes_corners(move.radius, length / move.radius));
}

// What pieces cost besides their blocks.
class PieceCost {
 public:
  explicit PieceCost(const FeedParams& params)
      : per_share_(60 / params.feed),
        least_time_(60 / params.maximum_feed),
        least_load_(params.least_load) {}

  // s: of `length` mm with shares from `least_share` to `share`.
  double operator()(double length, double share, double least_share) const {
    const double time = share * per_share_;
    if (time <= least_time_) return length * least_time_;
    return length * (least_share < least_load_ * share ? time + kUnevenPrice : time);
  }

 private:
  double per_share_, least_time_;  // s/mm: under a load of share 1, and at the highest feed
  double least_load_;
};

// The best division of samples into pieces of one feed, by dynamic programming: from sample to
// sample those places are carried along where the last piece may begin. A piece costs no less than
// its parts do without the prices of their blocks (for means, next to always). So where a piece up
// to here that began at one place costs as much as the best pieces up to here, it is better from
// here on to begin another one here: that place is dropped as soon as the other can be a piece, and
// will be from then on.
class Division {
 public:
  Division(const CutSamples& cut, const MeanLoad& load, const std::vector<char>& may_change,
           const FeedParams& params, Progress* progress)
      : runs_(cut.runs),
        samples_(cut.profile.data() + cut.first),
        first_(cut.first),
        count_(cut.last - cut.first),
        load_(load),
        params_(params),
        cost_of_(params),
        shortest_(params.least_load > 0 ? kShortestEven : params.steps.shortest),
        may_change_(may_change),
        best_(count_ + 1) {
    best_[0].cost = 0;
    for (std::size_t end = 1; end <= count_; ++end) {
      if (progress && end % kSamplesOfStep == 0) progress->step();
      if (end == 1 || may_change_[end - 2]) starts_.push_back({end - 1, best_[end - 1].cost});
      lengthen_to(end);
      if (!may_change_[end - 1]) continue;
      find_best(end);
      drop_beaten(end);
    }
  }

  std::vector<FeedPiece> pieces() const {
    std::vector<FeedPiece> result;
    for (std::size_t end = count_; end > 0; end = best_[end].from)
      result.push_back({first_ + best_[end].from, first_ + end, best_[end].feed});
    std::reverse(result.begin(), result.end());
    return result;
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  // The best pieces up to a sample: what they cost, and the last of them.
  struct Best {
    double cost = std::numeric_limits<double>::infinity();  // s
    std::size_t from = 0;
    double feed = 0;
  };
  // Where the last piece may begin, and that piece up to the sample that was looked at last.
  struct Start {
    std::size_t at = 0;
    double cost = 0;            // s: of the pieces before
    double mean = 0, peak = 0;  // peak: over what a sample may be
    double share = 0;           // what its feed follows from
    double least_share = std::numeric_limits<double>::infinity();
    double own = 0;                 // s
    std::size_t beaten_by = kNone;  // a later place
  };

  bool move_begins(std::size_t i) const {
    return i == 0 || samples_[i].move != samples_[i - 1].move;
  }
  bool move_ends(std::size_t end) const { return end == count_ || move_begins(end); }

  bool can_be_piece(std::size_t from, std::size_t end) const {
    const double length = load_.length(from, end);
    const bool begins = move_begins(from), ends = move_ends(end);
    if (length < shortest_ && !(begins && ends)) return false;
    if (begins || ends || samples_[from].move != samples_[end - 1].move) return true;
    return can_be_part(runs_[samples_[from].run].moves[samples_[from].move].segment, length,
                       shortest_);
  }

  void lengthen_to(std::size_t end) {
    if (!starts_.empty() && starts_.front().at + kLongestPiece < end)
      starts_.erase(starts_.begin());
    const double most_peak = load_.is_in_short_contact(end - 1) ? 1 : params_.steps.most_peak;
    const double peak = samples_[end - 1].share / most_peak;
    for (Start& start : starts_) {
      start.mean = load_.share(start.at, end, start.mean);
      start.peak = std::max(start.peak, peak);
      start.share = std::max(start.mean, start.peak);
      start.least_share = std::min(start.least_share, samples_[end - 1].share);
    }
  }

  // Of places that are as good the last is taken.
  void find_best(std::size_t end) {
    Best& best = best_[end];
    const double price = move_ends(end) ? kChangePrice : params_.steps.price;
    double share = 0;
    for (Start& start : starts_) {
      start.own = cost_of_(load_.length(start.at, end), start.share, start.least_share);
      const double cost = start.cost + start.own + price;
      if (cost > best.cost || !can_be_piece(start.at, end)) continue;
      best = {cost, start.at, 0};
      share = start.share;
    }
    best.feed = allowed_feed(share, params_);
  }

  void drop_beaten(std::size_t end) {
    for (Start& start : starts_)
      if (start.beaten_by == kNone && start.cost + start.own + kRounding >= best_[end].cost)
        start.beaten_by = end;
    std::erase_if(starts_, [&](const Start& start) {
      return start.beaten_by < end && load_.length(start.beaten_by, end) >= shortest_ &&
             can_be_piece(start.beaten_by, end);
    });
  }

  const std::vector<PlanarRun>& runs_;
  const LoadSample* samples_;
  std::size_t first_, count_;
  const MeanLoad& load_;
  const FeedParams& params_;
  PieceCost cost_of_;
  double shortest_;  // mm
  const std::vector<char>& may_change_;
  std::vector<Best> best_;  // for each number of samples
  std::vector<Start> starts_;
};

}  // namespace

std::vector<char> places_for_change(const CutSamples& cut, const FeedParams& params) {
  const double shortest = params.least_load > 0 ? kShortestEven : kShortestPart;
  std::vector<char> allowed(cut.last - cut.first, 1);
  for (std::size_t begin = cut.first; begin < cut.last;) {
    std::size_t end = begin;
    double left = 0, done = 0;  // mm of the move
    for (; end < cut.last && cut.profile[end].move == cut.profile[begin].move; ++end)
      left += cut.profile[end].length;
    const std::size_t last_of_move = end - 1;
    const Segment& move = cut.runs[cut.profile[begin].run].moves[cut.profile[begin].move].segment;
    for (std::size_t k = begin; k < last_of_move; ++k) {
      done += cut.profile[k].length;
      left -= cut.profile[k].length;
      allowed[k - cut.first] =
          can_be_part(move, done, shortest) && can_be_part(move, left, shortest);
    }
    begin = end;
  }
  return allowed;
}

std::vector<FeedPiece> best_division(const CutSamples& cut, const MeanLoad& load,
                                     const std::vector<char>& may_change, const FeedParams& params,
                                     Progress* progress) {
  return Division(cut, load, may_change, params, progress).pieces();
}

}  // namespace evenload
