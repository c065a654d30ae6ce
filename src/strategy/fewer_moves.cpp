#include "strategy/fewer_moves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "cutting/engagement.h"
#include "geometry/bi_arc.h"
#include "strategy/links.h"
#include "strategy/move_checks.h"
#include "strategy/short_moves.h"

namespace evenload {
namespace {

// Moves in a row that a bi-arc replaces.
constexpr std::size_t kFewest = 3, kMost = 5;
// How many times as far along the first tangent as along the last the joints lie that are tried.
constexpr double kRatios[] = {0.22, 0.35, 0.6, 1, 1.6, 2.8, 4.5};
// The best is then taken so many times greater and smaller.
constexpr double kFinerRatios[] = {1.25, 1.12};
// Shares of the tool's radius: the longest row, and what lies between two looks, along moves whose
// time alone matters as well.
constexpr double kLongestRow = 4;
constexpr double kLook = 0.03;
constexpr double kOldLook = 0.2;
constexpr int kFewestLooks = 4;
// Share of the tool's radius: moves along the border that are as short, remainders before a pass
// leaves its wall, may be replaced.
constexpr double kShortOnBorder = 0.05;
// mm: material thinner than this is not seen.
constexpr double kThin = 1e-6;
// Of unit vectors along moves that are tangent to each other.
constexpr double kSameDirection = 1e-6;
// rad: of either arc.
constexpr double kMostArc = 0.9 * kPi;
// What a turn may be tighter by, for rounding.
constexpr double kAsTight = 1.001;
// Into how many parts a new move is divided by the places where it is compared with the old ones;
// rad: by how much more or less than they it may be expected to meet.
constexpr int kChangeLooks = 4;
constexpr double kMostMore = 0.08;
constexpr double kMostLess = 0.15;

// What the tool meets along a move.
struct Met {
  double time = 0;  // s
  double area = 0;  // mm^2
};

class FewerMoves {
 public:
  FewerMoves(const std::vector<Segment>& moves, const Stretch& stretch, const Area& centres,
             ClearedGround& ground, const ClearingParams& params, double overload)
      : moves_(moves),
        stretch_(stretch),
        centres_(centres),
        ground_(ground),
        params_(params),
        radius_(ground.tool_radius()),
        full_width_(side_step(params.engagement_angle, radius_)),
        limit_(params.engagement_angle + overload) {
    const auto left = static_cast<std::ptrdiff_t>(first_left_behind(moves));
    comes_back_ = left > 0;
    if (comes_back_)
      stretch_.from = std::max(stretch_.from, length_of({moves.begin(), moves.begin() + left}));
  }

  std::vector<Segment> made() {
    const std::size_t before = ground_.size();
    for (std::size_t i = 0; i < moves_.size(); ++i) {
      while (replace_row(i)) met_.resize(std::min(met_.size(), i));
      done_ += moves_[i].length();
      if (comes_back_) ground_.add(moves_[i]);
    }
    while (ground_.size() > before) ground_.remove_last();
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
    if (done_ < stretch_.from || !may_begin(i)) return false;
    Best best;
    double length = moves_[i].length();
    for (std::size_t j = i + 1; j < std::min(moves_.size(), i + kMost); ++j) {
      length += moves_[j].length();
      if (length > kLongestRow * radius_ || done_ + length > stretch_.to ||
          follows_border(moves_[j], centres_) ||
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

  // A pass may leave its wall a little earlier, but must not come to it later.
  bool may_begin(std::size_t k) const {
    return moves_[k].length() < kShortOnBorder * radius_ || !follows_border(moves_[k], centres_);
  }

  struct Candidate {
    std::vector<Segment> way;
    double ratio = 1;
    double change = 1;  // of what it meets, as a share of what may be
  };

  // Takes the bi-arc of `ratio` in place of the row where that changes less than `best` does.
  void change_less(std::size_t first, std::size_t last, double ratio, double tightest,
                   Candidate& best) const {
    const Segment &a = moves_[first], &b = moves_[last];
    const std::optional<BiArc> pair =
        bi_arc({a.a, a.tangent(0)}, {b.b, b.tangent(1)}, kMostArc, ratio);
    if (!pair) return;
    double change = 0;
    for (const Segment& move : {pair->first, pair->second}) {
      if (move.length() < kShortest || std::abs(move.curvature()) > kAsTight * tightest) return;
      for (int i = 1; i < kChangeLooks; ++i) {
        change =
            std::max(change, change_at(move, static_cast<double>(i) / kChangeLooks, first, last));
        if (change >= best.change) return;
      }
    }
    best = {{pair->first, pair->second}, ratio, change};
  }

  // The bi-arc in place of the row that changes least, as far as is known without a look at the
  // ground; empty where all change too much.
  std::vector<Segment> likeliest(std::size_t first, std::size_t last) const {
    double tightest = 0;
    for (std::size_t k = first; k <= last; ++k)
      tightest = std::max(tightest, std::abs(moves_[k].curvature()));
    Candidate best;
    for (const double ratio : kRatios) change_less(first, last, ratio, tightest, best);
    if (best.way.empty()) return {};
    for (const double finer : kFinerRatios) {
      const double middle = best.ratio;
      change_less(first, last, middle * finer, tightest, best);
      change_less(first, last, middle / finer, tightest, best);
    }
    return std::move(best.way);
  }

  void try_row(std::size_t first, std::size_t last, Best& best) {
    const std::size_t row = last - first + 1;
    double gain = params_.feed_steps.price * static_cast<double>(row - 2);
    for (std::size_t k = first; k <= last; ++k) gain += loss_of(met_along(k));
    if (gain <= best.gain) return;
    std::vector<Segment> way = likeliest(first, last);
    for (const Segment& move : way) {
      if (!is_inside(move, centres_, kOnBorder)) return;
      const std::optional<Met> met = look_along(move, kLook, limit_);
      if (!met) return;
      gain -= loss_of(*met);
    }
    if (!way.empty() && gain > best.gain) best = {std::move(way), gain, row};
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

  // By how much what is met at `at` of a new move is expected to change, without a look at the
  // ground. To turn right and to be further to the right both mean to meet more.
  double change_at(const Segment& move, double at, std::size_t first, std::size_t last) const {
    const Vec2 p = move.point(at);
    const Segment* old = &moves_[first];
    double least = old->distance_to(p);
    for (std::size_t k = first + 1; k <= last; ++k) {
      const double distance = moves_[k].distance_to(p);
      if (distance >= least) continue;
      least = distance;
      old = &moves_[k];
    }
    const double t = old->nearest(p);
    const Vec2 along = old->tangent(t), now = move.tangent(at);
    const double left = cross(along, p - old->point(t));
    const double turned_left = std::atan2(cross(along, now), dot(along, now));
    const double more = -turned_left - left / (radius_ * std::sin(params_.engagement_angle));
    return more > 0 ? more / kMostMore : -more / kMostLess;
  }

  std::vector<Segment> moves_;
  Stretch stretch_;
  const Area& centres_;
  ClearedGround& ground_;
  const ClearingParams& params_;
  bool comes_back_ = false;
  double radius_;
  double full_width_;     // mm, of a straight cut at the engagement angle
  double limit_;          // rad
  double done_ = 0;       // mm of the moves before the row
  std::vector<Met> met_;  // along the first of moves_
  std::vector<AngularInterval> arcs_;
};

}  // namespace

std::vector<Segment> with_fewer_moves(const std::vector<Segment>& moves, const Stretch& stretch,
                                      const Area& centres, ClearedGround& ground,
                                      const ClearingParams& params, double overload) {
  return FewerMoves(moves, stretch, centres, ground, params, overload).made();
}

}  // namespace evenload
