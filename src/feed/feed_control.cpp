#include "feed/feed_control.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "feed/mean_load.h"
#include "toolpath/small_arc.h"

namespace evenload {
namespace {

// s: what a change of feed must save where a move ends anyway. It costs no block; but feeds that
// hardly differ shall be one.
constexpr double kChangePrice = 0.0005;
// mm: no feed changes within a move nearer to its ends than this; what is rounded to a post's
// 0.001 mm turns shorter arcs by more than a degree.
constexpr double kShortestPart = 0.1;
// mm: the same, and the least length of a piece, where a least load is asked for.
constexpr double kShortestEven = 0.02;
// s
constexpr double kRounding = 1e-9;
constexpr double kSameFeed = 1e-9;  // share of a feed
// Share of a block's price: a gain below it is no reason to look for another division.
constexpr double kLittle = 0.25;
// Share of the nominal load: samples beside each other that differ more stand at a jump.
constexpr double kJump = 1;
// s/mm: what a piece costs more in which the load falls below the least that is asked for; so much
// that blocks are spent wherever they mend it.
constexpr double kUnevenPrice = 10;
// A piece of one feed holds at most this many samples: bounds the search.
constexpr std::size_t kLongestPiece = 400;

// Whether a part of a move this long can be posted as what it is.
bool can_be_part(const Segment& move, double length, double shortest) {
  return length >= shortest &&
         !(move.is_arc() && becomes_corners(move.radius, length / move.radius));
}

// Whether the feed may change after each of the samples [first, last): where a move ends, and so
// far from its ends that no move below `shortest` mm and no tight turn is split off.
std::vector<char> places_for_change(const std::vector<PlanarRun>& runs,
                                    const std::vector<LoadSample>& profile, std::size_t first,
                                    std::size_t last, double shortest) {
  std::vector<char> allowed(last - first, 1);
  for (std::size_t begin = first; begin < last;) {
    std::size_t end = begin;
    double left = 0, done = 0;  // mm of the move
    for (; end < last && profile[end].move == profile[begin].move; ++end)
      left += profile[end].length;
    const std::size_t last_of_move = end - 1;
    const Segment& move = runs[profile[begin].run].moves[profile[begin].move].segment;
    for (std::size_t k = begin; k < last_of_move; ++k) {
      done += profile[k].length;
      left -= profile[k].length;
      allowed[k - first] = can_be_part(move, done, shortest) && can_be_part(move, left, shortest);
    }
    begin = end;
  }
  return allowed;
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
  // Samples [first, last), `load` is theirs.
  Division(const std::vector<PlanarRun>& runs, const std::vector<LoadSample>& profile,
           std::size_t first, std::size_t last, const MeanLoad& load, const FeedParams& params)
      : runs_(runs),
        samples_(profile.data() + first),
        first_(first),
        count_(last - first),
        load_(load),
        params_(params),
        cost_of_(params),
        shortest_(params.least_load > 0 ? kShortestEven : params.steps.shortest),
        may_change_(places_for_change(runs, profile, first, last,
                                      params.least_load > 0 ? kShortestEven : kShortestPart)),
        best_(count_ + 1) {
    best_[0].cost = 0;
    for (std::size_t end = 1; end <= count_; ++end) {
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
    double cost = 0;                       // s: of the pieces before
    double mean = 0, peak = 0, share = 0;  // share: what its feed follows from
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
    for (Start& start : starts_) {
      start.mean = load_.share(start.at, end, start.mean);
      start.peak = std::max(start.peak, samples_[end - 1].share);
      start.share = std::max(start.mean, start.peak / params_.steps.most_peak);
      start.least_share = std::min(start.least_share, samples_[end - 1].share);
    }
  }

  // Of places that are as good the last is taken.
  void find_best(std::size_t end) {
    Best& best = best_[end];
    const double price = move_ends(end) ? kChangePrice : params_.steps.price;
    for (auto start = starts_.rbegin(); start != starts_.rend(); ++start) {
      start->own = cost_of_(load_.length(start->at, end), start->share, start->least_share);
      const double cost = start->cost + start->own + price;
      if (cost < best.cost && can_be_piece(start->at, end))
        best = {cost, start->at, allowed_feed(start->share, params_)};
    }
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
  std::vector<char> may_change_;
  std::vector<Best> best_;  // for each number of samples
  std::vector<Start> starts_;
};

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

// Feeds by means are found as if each piece were alone, and lowered where one is too fast beside
// another. Where that costs more than means gain, or the load jumps, every sample is held.
std::vector<FeedPiece> pieces_of(const std::vector<PlanarRun>& runs,
                                 const std::vector<LoadSample>& profile, std::size_t first,
                                 std::size_t last, const FeedParams& params) {
  const auto divided = [&](const MeanLoad& load) {
    return Division(runs, profile, first, last, load, params).pieces();
  };
  const LoadSample* samples = profile.data() + first;
  const auto held = [&] { return divided(MeanLoad(samples, last - first, 0)); };
  if (has_jump(samples, last - first)) return held();
  const MeanLoad means(samples, last - first, params.mean_length);
  std::vector<FeedPiece> pieces = divided(means);
  const double least = cost_of(pieces, profile, params);  // of samples that are held, too
  if (!means.limit(pieces, params.feed)) return pieces;
  pieces = joined(pieces);
  if (cost_of(pieces, profile, params) - least < kLittle * params.steps.price) return pieces;
  std::vector<FeedPiece> each_held = held();
  const bool is_dearer = cost_of(pieces, profile, params) > cost_of(each_held, profile, params);
  return is_dearer ? each_held : pieces;
}

}  // namespace

double allowed_feed(double share, const FeedParams& params) {
  return share * params.maximum_feed <= params.feed ? params.maximum_feed : params.feed / share;
}

void set_constant_feed(std::vector<PlanarRun>& runs, const FeedParams& params) {
  for (PlanarRun& run : runs)
    for (PlanarMove& move : run.moves)
      move.feed = move.kind == MoveKind::kLink ? params.link_feed : params.feed;
}

std::vector<double> set_constant_load(std::vector<PlanarRun>& runs,
                                      const std::vector<LoadSample>& profile,
                                      const FeedParams& params) {
  const auto is_cut = [&](const LoadSample& s) {
    return runs[s.run].moves[s.move].kind == MoveKind::kCut;
  };
  std::vector<double> feeds(profile.size(), params.link_feed);
  std::vector<PlanarRun> result;
  for (const PlanarRun& run : runs) result.push_back({run.descent, {}, run.new_region});
  std::size_t i = 0;
  while (i < profile.size()) {
    const std::size_t run = profile[i].run;
    if (!is_cut(profile[i])) {
      PlanarMove link = runs[run].moves[profile[i].move];
      link.feed = params.link_feed;
      result[run].moves.push_back(link);
      const std::size_t move = profile[i].move;
      while (i < profile.size() && profile[i].run == run && profile[i].move == move) ++i;
      continue;
    }
    std::size_t end = i;
    while (end < profile.size() && profile[end].run == run && is_cut(profile[end])) ++end;
    for (const FeedPiece& piece : pieces_of(runs, profile, i, end, params)) {
      std::fill_n(feeds.data() + piece.first, piece.last - piece.first, piece.feed);
      // The piece's samples, move by move.
      std::size_t a = piece.first;
      while (a < piece.last) {
        std::size_t b = a;
        while (b < piece.last && profile[b].move == profile[a].move) ++b;
        PlanarMove part = runs[run].moves[profile[a].move];
        const double length = part.segment.length();
        const double t0 = std::max(0.0, profile[a].t - 0.5 * profile[a].length / length);
        const double t1 = std::min(1.0, profile[b - 1].t + 0.5 * profile[b - 1].length / length);
        const bool whole = t0 < 1e-9 && t1 > 1 - 1e-9;
        if (!whole) part.segment = part.segment.part(t0, t1);
        part.feed = piece.feed;
        result[run].moves.push_back(part);
        a = b;
      }
    }
    i = end;
  }
  runs = std::move(result);
  return feeds;
}

}  // namespace evenload
