#include "strategy/turn_demands.h"

#include <algorithm>
#include <cmath>
#include <deque>

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

  // rad, over all of a way that is shorter.
  double of_all() const { return length_ > 0 ? sum_ / length_ : 0; }

  // The highest mean, rad, that ends on the move from its share `from` on; 0 where there is none.
  // The ground: before the move.
  double look_along(const Segment& move, double from) {
    const double length = (1 - from) * move.length();
    const int n = std::max(1, static_cast<int>(std::lround(length / kEngagementSpacing)));
    double most = 0;
    for (int i = 0; i < n; ++i) {
      const double t = from + (1 - from) * (i + 0.5) / n;
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
      if (length_ >= kMeanLength - kRounding) most = std::max(most, of_all());
    }
    return most;
  }

 private:
  struct Look {
    double met, length;  // rad, mm
  };
  const ClearedGround& ground_;
  std::deque<Look> looks_;
  double sum_ = 0, length_ = 0;
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
                    const TurnDemands& demands) {
  if (!demands.ground) return false;
  MeanLooks looks(*demands.ground);
  double until_way = length_of(before);  // mm
  for (const Segment& move : before) {
    const double length = move.length(), left_out = until_way - kMeanLength;
    if (left_out < length) looks.look_along(move, std::max(0.0, left_out / length));
    demands.ground->add(move);
    until_way -= length;
  }
  double most = 0;
  for (const Segment& move : way) {
    most = std::max(most, looks.look_along(move, 0));
    demands.ground->add(move);
  }
  if (most == 0) most = looks.of_all();
  for (std::size_t i = 0; i < before.size() + way.size(); ++i) demands.ground->remove_last();
  return most > demands.engagement + kSmoothOverload;
}

}  // namespace evenload
