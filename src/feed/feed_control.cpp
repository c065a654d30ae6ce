#include "feed/feed_control.h"

#include <algorithm>
#include <cmath>
#include <deque>
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

// The best division of samples [first, last) into pieces of one feed. `load` is theirs.
std::vector<FeedPiece> divide(const std::vector<PlanarRun>& runs,
                              const std::vector<LoadSample>& profile, std::size_t first,
                              std::size_t last, const MeanLoad& load, const FeedParams& params) {
  const std::size_t n = last - first;
  std::vector<double> cost(n + 1, std::numeric_limits<double>::infinity()), feed(n + 1, 0);
  std::vector<std::size_t> from(n + 1, 0);
  const bool is_even = params.least_load > 0;
  const auto move_at = [&](std::size_t i) { return profile[first + i].move; };
  const auto segment_at = [&](std::size_t i) -> const Segment& {
    return runs[profile[first + i].run].moves[move_at(i)].segment;
  };
  const std::vector<char> may_change =
      places_for_change(runs, profile, first, last, is_even ? kShortestEven : kShortestPart);
  std::vector<double> allowed(n);
  for (std::size_t i = 0; i < n; ++i) allowed[i] = allowed_feed(load.share(i, i + 1, 0), params);
  // The least time up to a sample, were every sample a piece of its own.
  std::vector<double> least(n + 1, 0);
  for (std::size_t i = 0; i < n; ++i)
    least[i + 1] = least[i] + profile[first + i].length / allowed[i] * 60;
  cost[0] = 0;
  const double shortest = is_even ? kShortestEven : params.steps.shortest;
  const PieceCost cost_of(params);
  // What the places where the piece may begin cost beyond that least time: those that are the least
  // from themselves on, in order.
  std::deque<std::size_t> cheapest;
  const auto beyond_least = [&](std::size_t i) { return cost[i] - least[i]; };
  for (std::size_t j = 1; j <= n; ++j) {
    while (!cheapest.empty() && beyond_least(cheapest.back()) >= beyond_least(j - 1))
      cheapest.pop_back();
    cheapest.push_back(j - 1);
    if (cheapest.front() + kLongestPiece < j) cheapest.pop_front();
    if (!may_change[j - 1]) continue;
    const double spent = beyond_least(cheapest.front());
    double share = 0, length = 0, least_share = std::numeric_limits<double>::infinity();
    const bool move_ends = j == n || move_at(j) != move_at(j - 1);
    const double price = move_ends ? kChangePrice : params.steps.price;
    for (std::size_t i = j; i-- > 0 && j - i <= kLongestPiece;) {
      share = load.share(i, j, share);
      length += profile[first + i].length;
      const bool move_begins = i == 0 || move_at(i) != move_at(i - 1);
      least_share = std::min(least_share, profile[first + i].share);
      if (length < shortest && !(move_begins && move_ends)) continue;
      const double own = cost_of(length, share, least_share);
      // What a piece loses grows with its length, but for means, next to always.
      if (least[i] + spent + own + price >= cost[j] + kRounding) break;
      const double total = cost[i] + own + price;
      if (total >= cost[j]) continue;
      const bool is_within = !move_begins && !move_ends && move_at(i) == move_at(j - 1);
      if (is_within && !can_be_part(segment_at(i), length, shortest)) continue;
      cost[j] = total;
      feed[j] = allowed_feed(share, params);
      from[j] = i;
    }
  }
  std::vector<FeedPiece> pieces;
  for (std::size_t j = n; j > 0; j = from[j])
    pieces.push_back({first + from[j], first + j, feed[j]});
  std::reverse(pieces.begin(), pieces.end());
  return pieces;
}

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
    return divide(runs, profile, first, last, load, params);
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
