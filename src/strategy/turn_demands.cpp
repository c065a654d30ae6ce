#include "strategy/turn_demands.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "strategy/links.h"
#include "strategy/move_checks.h"
#include "toolpath/small_arc.h"

namespace evenload {
namespace {

// mm: no rest of a move is shorter; rounded to 0.0001 mm it would be turned by half a degree.
constexpr double kShortestRest = 0.01;
// mm of path between two looks at the engagement.
constexpr double kEngagementSpacing = 0.005;
// mm: material thinner than this is not seen.
constexpr double kThin = 1e-6;
constexpr double kRounding = 1e-9;  // mm

// Means of the engagement over kMeanLength mm of a way that is looked at move by move.
class MeanLooks {
 public:
  explicit MeanLooks(const ClearedGround& ground) : ground_(ground) {}

  // rad: the highest mean so far that ends on moves that count; over all where that is shorter.
  double most() const { return most_ ? *most_ : length_ > 0 ? sum_ / length_ : 0; }

  // The ground: before the move, of which the shares from `from` to `to` are looked at.
  void look_along(const Segment& move, double from, double to, bool counts) {
    const double length = (to - from) * move.length();
    const int n = std::max(1, static_cast<int>(std::lround(length / kEngagementSpacing)));
    for (int i = 0; i < n; ++i) {
      const double t = from + (to - from) * (i + 0.5) / n;
      const double right = angle_of(move.tangent(t)) - kPi / 2;
      ground_.uncovered(move.point(t), right, right + kPi, pieces_, kThin, ground_.size());
      double met = 0;
      for (const AngularInterval& piece : pieces_) met += piece.width();
      looks_.push_back({met, length / n});
      sum_ += met * length / n;
      length_ += length / n;
      while (length_ - looks_.front().length >= kMeanLength - kRounding) {
        sum_ -= looks_.front().met * looks_.front().length;
        length_ -= looks_.front().length;
        looks_.pop_front();
      }
      if (counts && length_ >= kMeanLength - kRounding)
        most_ = std::max(most_.value_or(0), sum_ / length_);
    }
  }

 private:
  struct Look {
    double met, length;  // rad, mm
  };
  const ClearedGround& ground_;
  std::deque<Look> looks_;
  double sum_ = 0, length_ = 0;
  std::optional<double> most_;
  std::vector<AngularInterval> pieces_;
};

}  // namespace

bool can_stay(const Segment& move, double from, double to) {
  const double share = to - from;
  return share * move.length() >= kShortestRest &&
         !(move.is_arc() && becomes_corners(move.radius, share * move.sweep));
}

bool may_give_way(const Segment& move, const TurnDemands& demands) {
  return move.is_arc() && std::abs(move.sweep) >= demands.least_turn &&
         !follows_border(move, demands.exact);
}

std::vector<Segment> parts_between(const std::vector<Segment>& moves, const MoveCut& from,
                                   const MoveCut& to) {
  std::vector<Segment> parts;
  for (std::size_t k = from.move; k <= to.move && k < moves.size(); ++k) {
    const double t0 = k == from.move ? from.t : 0, t1 = k == to.move ? to.t : 1;
    if (t1 > t0) parts.push_back(moves[k].part(t0, t1));
  }
  return parts;
}

std::vector<Segment> replaced(const std::vector<Segment>& moves, const MoveCut& from,
                              const MoveCut& to, const std::vector<Segment>& way) {
  std::vector<Segment> result = parts_between(moves, {0, 0}, from);
  result.insert(result.end(), way.begin(), way.end());
  const std::vector<Segment> after = parts_between(moves, to, {moves.size(), 0});
  result.insert(result.end(), after.begin(), after.end());
  return result;
}

bool is_near(const std::vector<Segment>& way, const std::vector<Segment>& old,
             const TurnDemands& demands) {
  const auto is_near_to = [&](const Segment& move, Vec2 p) {
    const double t = move.nearest(p);
    const Vec2 off = p - move.point(t);
    const bool is_left = cross(move.tangent(t), off) > 0;
    return norm(off) <= (is_left ? demands.deepening : demands.widening);
  };
  return std::all_of(old.begin(), old.end(), [&](const Segment& move) {
    for (int i = 0; i <= kMoveLooks; ++i) {
      const Vec2 p = move.point(static_cast<double>(i) / kMoveLooks);
      if (std::none_of(way.begin(), way.end(), [&](const Segment& s) { return is_near_to(s, p); }))
        return false;
    }
    return true;
  });
}

bool meets_too_much(const std::vector<Segment>& before, const std::vector<Segment>& way,
                    const std::vector<Segment>& after, const TurnDemands& demands) {
  if (!demands.ground) return false;
  ClearedGround& ground = *demands.ground;
  const std::size_t known = ground.size();
  MeanLooks looks(ground);
  double until_way = length_of(before);  // mm
  for (const Segment& move : before) {
    const double length = move.length(), left_out = until_way - kMeanLength;
    if (left_out < length) looks.look_along(move, std::max(0.0, left_out / length), 1, false);
    ground.add(move);
    until_way -= length;
  }
  for (const Segment& move : way) {
    looks.look_along(move, 0, 1, true);
    ground.add(move);
  }
  double left = kMeanLength;  // mm
  for (auto move = after.begin(); move != after.end() && left > 0; ++move) {
    looks.look_along(*move, 0, std::min(1.0, left / move->length()), true);
    ground.add(*move);
    left -= move->length();
  }
  while (ground.size() > known) ground.remove_last();
  return looks.most() > demands.engagement + kSmoothOverload;
}

}  // namespace evenload
