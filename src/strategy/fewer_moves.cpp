#include "strategy/fewer_moves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "cutting/engagement.h"
#include "geometry/bi_arc.h"
#include "strategy/move_checks.h"
#include "strategy/short_moves.h"

namespace evenload {
namespace {

// s: what one block less may cost.
constexpr double kBlockPrice = 0.023;
// Moves in a row that a bi-arc replaces.
constexpr std::size_t kFewest = 3, kMost = 5;
// How many times as far along the first tangent as along the last the joints lie that are tried.
constexpr double kRatios[] = {0.35, 1, 2.8};
// Shares of the tool's radius: the longest row, and what lies between two looks, along moves whose
// time alone matters as well.
constexpr double kLongestRow = 4;
constexpr double kLook = 0.05;
constexpr double kOldLook = 0.12;
constexpr int kFewestLooks = 4;
// mm: material thinner than this is not seen.
constexpr double kThin = 1e-6;
// Of unit vectors along moves that are tangent to each other.
constexpr double kSameDirection = 1e-6;
// rad: a pass that turns by more may come back to where it was.
constexpr double kMostTurn = 1.75 * kPi;
// rad: of either arc.
constexpr double kMostArc = 0.9 * kPi;
// What a turn may be tighter by, for rounding.
constexpr double kAsTight = 1.001;
// rad: by how much more or less than the old moves a new one may be expected to meet.
constexpr double kMostMore = 0.04;
constexpr double kMostLess = 0.1;

// What the tool meets along a move.
struct Met {
  double time = 0;  // s
  double area = 0;  // mm^2
};

class FewerMoves {
 public:
  FewerMoves(const std::vector<Segment>& moves, const Stretch& stretch, const Area& centres,
             const ClearedGround& ground, const ClearingParams& params)
      : moves_(moves),
        stretch_(stretch),
        centres_(centres),
        ground_(ground),
        params_(params),
        radius_(ground.tool_radius()),
        full_width_(side_step(params.engagement_angle, radius_)) {}

  std::vector<Segment> made() {
    for (std::size_t i = 0; i < moves_.size(); ++i) {
      while (replace_row(i)) met_.resize(std::min(met_.size(), i));
      done_ += moves_[i].length();
    }
    return std::move(moves_);
  }

 private:
  struct Best {
    std::vector<Segment> way;
    double gain = 0;  // s
    std::size_t row = 0;
  };

  // Replaces the best row that begins with the move `i`, if there is one.
  bool replace_row(std::size_t i) {
    if (done_ < stretch_.from || !can_go(i)) return false;
    Best best;
    double length = moves_[i].length();
    for (std::size_t j = i + 1; j < std::min(moves_.size(), i + kMost); ++j) {
      length += moves_[j].length();
      if (length > kLongestRow * radius_ || done_ + length > stretch_.to || !can_go(j) ||
          !is_tangent(moves_[j - 1], moves_[j], kSameDirection))
        break;
      if (j + 1 - i >= kFewest) try_row(i, j, best);
    }
    if (best.way.empty()) return false;
    const auto first = moves_.begin() + static_cast<std::ptrdiff_t>(i);
    moves_.erase(first, first + static_cast<std::ptrdiff_t>(best.row));
    moves_.insert(moves_.begin() + static_cast<std::ptrdiff_t>(i), best.way.begin(),
                  best.way.end());
    return true;
  }

  bool can_go(std::size_t k) const { return !follows_border(moves_[k], centres_); }

  void try_row(std::size_t first, std::size_t last, Best& best) {
    const Segment &a = moves_[first], &b = moves_[last];
    double tightest = 0;
    for (std::size_t k = first; k <= last; ++k)
      tightest = std::max(tightest, std::abs(moves_[k].curvature()));
    for (const double ratio : kRatios) {
      const std::optional<BiArc> pair =
          bi_arc({a.a, a.tangent(0)}, {b.b, b.tangent(1)}, kMostArc, ratio);
      if (!pair) continue;
      std::vector<Segment> way{pair->first, pair->second};
      const bool serves = std::all_of(way.begin(), way.end(), [&](const Segment& move) {
        return move.length() >= kShortest && std::abs(move.curvature()) <= kAsTight * tightest &&
               is_promising(move, first, last) && is_inside(move, centres_, kOnBorder);
      });
      if (!serves) continue;
      const double limit = params_.engagement_angle + kSmoothOverload;
      const std::optional<Met> met_first = look_along(way[0], kLook, limit);
      if (!met_first) continue;
      const std::optional<Met> met_second = look_along(way[1], kLook, limit);
      if (!met_second) continue;
      const std::size_t row = last - first + 1;
      double gain = kBlockPrice * static_cast<double>(row - way.size());
      for (std::size_t k = first; k <= last; ++k) gain += loss_of(met_along(k));
      gain -= loss_of(*met_first) + loss_of(*met_second);
      if (gain > best.gain) best = {std::move(way), gain, row};
    }
  }

  // By how much longer a move takes than what it removes must.
  double loss_of(const Met& met) const {
    return met.time - met.area / (full_width_ * params_.feed) * 60;
  }

  const Met& met_along(std::size_t k) {
    for (std::size_t i = met_.size(); i <= k; ++i)
      met_.push_back(*look_along(moves_[i], kOldLook, std::numeric_limits<double>::infinity()));
    return met_[k];
  }

  // Looks at a move until more than `limit` rad is met; nothing then.
  std::optional<Met> look_along(const Segment& move, double look, double limit) {
    const double length = move.length();
    const int n = std::max(kFewestLooks, static_cast<int>(std::ceil(length / (look * radius_))));
    double widest = 0, sum = 0;
    for (int i = 0; i < n; ++i) {
      const double t = (i + 0.5) / n, heading = angle_of(move.tangent(t));
      ground_.uncovered(move.point(t), heading - kPi / 2, heading + kPi / 2, arcs_, kThin);
      double engaged = 0, width = 0;
      for (const AngularInterval& arc : arcs_) {
        engaged += arc.width();
        width += radius_ * (std::sin(arc.high - heading) - std::sin(arc.low - heading));
      }
      if (engaged > limit) return std::nullopt;
      sum += width;
      widest = std::max(widest, width);
    }
    const double feed = widest * params_.maximum_feed <= full_width_ * params_.feed
                            ? params_.maximum_feed
                            : full_width_ * params_.feed / widest;
    return Met{length / feed * 60, sum / n * length};
  }

  // What is expected without a look at the ground: in the middle of a new move hardly more is met,
  // and not much less, than on the old ones. To turn right and to be further to the right both mean
  // to meet more.
  bool is_promising(const Segment& move, std::size_t first, std::size_t last) const {
    const Vec2 p = move.point(0.5);
    const auto begin = moves_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = moves_.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    const auto old = std::min_element(begin, end, [&](const Segment& a, const Segment& b) {
      return a.distance_to(p) < b.distance_to(p);
    });
    const double t = old->nearest(p);
    const Vec2 along = old->tangent(t), now = move.tangent(0.5);
    const double left = cross(along, p - old->point(t));
    const double turned_left = std::atan2(cross(along, now), dot(along, now));
    const double more = -turned_left - left / (radius_ * std::sin(params_.engagement_angle));
    return -kMostLess <= more && more <= kMostMore;
  }

  std::vector<Segment> moves_;
  Stretch stretch_;
  const Area& centres_;
  const ClearedGround& ground_;
  const ClearingParams& params_;
  double radius_;
  double full_width_;     // mm, of a straight cut at the limit
  double done_ = 0;       // mm of the moves before the row
  std::vector<Met> met_;  // along the first of moves_
  std::vector<AngularInterval> arcs_;
};

}  // namespace

std::vector<Segment> with_fewer_moves(const std::vector<Segment>& moves, const Stretch& stretch,
                                      const Area& centres, const ClearedGround& ground,
                                      const ClearingParams& params) {
  double turn = 0;
  for (const Segment& move : moves) turn += move.sweep;
  if (std::abs(turn) > kMostTurn) return moves;
  return FewerMoves(moves, stretch, centres, ground, params).made();
}

}  // namespace evenload
