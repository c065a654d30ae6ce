#include "strategy/fewer_moves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "cutting/engagement.h"
#include "strategy/links.h"
#include "strategy/move_checks.h"
#include "strategy/row_bi_arc.h"
#include "strategy/row_fit.h"
#include "strategy/short_moves.h"
#include "toolpath/small_arc.h"

namespace evenload {
namespace {

// Moves in a row that are replaced by arcs, one fewer.
constexpr std::size_t kFewest = 3, kMost = kMostArcs + 1;
// How often arcs that turn out to meet too much are made better by what they were found to meet.
constexpr int kTries = 2;
// rad: beyond the limit, they are not.
constexpr double kHopeless = 0.04;
// Shares of the tool's radius: the longest row, and what lies between two looks, along the moves
// that there are as well.
constexpr double kLongestRow = 4;
constexpr double kLook = 0.03;
constexpr double kOldLook = 0.06;
constexpr double kQuickLook = 0.2;
// s: what a turn costs that posts write as lines with corners.
constexpr double kCornerPrice = 0.04;
constexpr int kFewestLooks = 4;
// Share of the tool's radius: moves along the border that are as short, remainders before a pass
// leaves its wall, may be replaced.
constexpr double kShortOnBorder = 0.05;
// mm: material thinner than this is not seen.
constexpr double kThin = 1e-6;
// rad: less than this is thin stuff on either side.
constexpr double kLeastLeaning = kPi / 180;
// Of unit vectors along moves that are tangent to each other.
constexpr double kSameDirection = 1e-6;
// Share of the tool's radius: thinner rests might be left for good, where no wall leads to them and
// they are hardly seen.
constexpr double kSliver = 0.1;
// Every so manieth look is for those.
constexpr int kBesideEvery = 2;
// What a turn may be tighter by, for rounding.
constexpr double kAsTight = 1.001;

class FewerMoves {
 public:
  FewerMoves(const std::vector<Segment>& moves, const Stretch& stretch, const Area& centres,
             ClearedGround& ground, const ClearingParams& params, double overload, Rows rows)
      : moves_(moves),
        stretch_(stretch),
        centres_(centres),
        ground_(ground),
        params_(params),
        rows_(rows),
        radius_(ground.tool_radius()),
        full_width_(side_step(params.engagement_angle, radius_)),
        limits_{params.engagement_angle + overload,
                params.engagement_angle,
                radius_,
                full_width_ * params.feed / params.maximum_feed,
                kShortest,
                kAsTight * tightest()} {
    const auto left = static_cast<std::ptrdiff_t>(first_left_behind(moves));
    comes_back_ = left > 0;
    if (comes_back_)
      stretch_.from = std::max(stretch_.from, length_of({moves.begin(), moves.begin() + left}));
  }

  std::vector<Segment> made() {
    const std::size_t before = ground_.size();
    for (std::size_t i = 0; i < moves_.size(); ++i) {
      while (replace_row(i)) looked_.resize(std::min(looked_.size(), i));
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

  // 1/mm, of the pass off the border.
  double tightest() const {
    double most = 0;
    for (const Segment& move : moves_)
      if (!follows_border(move, centres_)) most = std::max(most, std::abs(move.curvature()));
    return most;
  }

  // 1/mm, of the moves [first, last].
  double tightest_in(std::size_t first, std::size_t last) const {
    double most = 0;
    for (std::size_t k = first; k <= last; ++k)
      most = std::max(most, std::abs(moves_[k].curvature()));
    return kAsTight * most;
  }

  // What the tool meets along a move, by the way and the turn from its beginning on.
  struct Looked {
    std::vector<RowLook> looks;
    bool is_beside_nothing = false;
  };

  Looked look_along(const Segment& move, double look, double most_met) {
    Looked looked;
    const double length = move.length(), bend = 0.5 * move.sweep;
    const int n = std::max(kFewestLooks, static_cast<int>(std::ceil(length / (look * radius_))));
    for (int i = 0; i < n; ++i) {
      const double t = (i + 0.5) / n, heading = angle_of(move.tangent(t));
      ground_.uncovered(move.point(t), heading - kPi / 2, heading + kPi / 2, arcs_, kThin);
      looked.looks.push_back({{t * length, 2 * bend * t, t * length * bend * t}});
      RowLook& here = looked.looks.back();
      double left = 0;  // by how much more of it
      for (const AngularInterval& arc : arcs_) {
        here.met += arc.width();
        left += std::cos(arc.low - heading) - std::cos(arc.high - heading);
        here.width += radius_ * (std::sin(arc.high - heading) - std::sin(arc.low - heading));
      }
      here.leans_left = left > 0 && here.met > kLeastLeaning;
      if (here.met > most_met) break;
      if (look == kOldLook && i % kBesideEvery == 0 && !arcs_.empty())
        looked.is_beside_nothing =
            looked.is_beside_nothing || is_nothing_beside(move.point(t), heading);
    }
    return looked;
  }

  // True where the cut takes all but a sliver of what lies to its right.
  bool is_nothing_beside(Vec2 p, double heading) const {
    return ground_.is_cleared_point(p - (1 + kSliver) * radius_ * left_normal(unit(heading)));
  }

  const Looked& looked_at(std::size_t k) {
    for (std::size_t i = looked_.size(); i <= k; ++i)
      looked_.push_back(
          look_along(moves_[i], rows_ == Rows::kFitted ? kOldLook : kQuickLook, 2 * kPi));
    return looked_[k];
  }

  static void append(const Segment& move, const Looked& looked, Row& row) {
    const RowPlace begin = row.joints.empty() ? RowPlace() : row.joints.back();
    const auto on = [&](const RowPlace& place) -> RowPlace {
      return {begin.along + place.along, begin.turned + place.turned,
              begin.aside + begin.turned * place.along + place.aside};
    };
    for (const RowLook& look : looked.looks)
      row.looks.push_back({on(look), look.met, look.width, look.leans_left});
    const double length = move.length();
    row.joints.push_back(on({length, move.sweep, 0.5 * length * move.sweep}));
  }

  // What is met along moves in place of a row; as far as no more is met than `most` rad.
  Row row_along(const std::vector<Segment>& way, const Row& old, double most) {
    Row row{old.from, old.to, {}, {}};
    for (const Segment& move : way) {
      append(move, look_along(move, kLook, most), row);
      if (row.looks.back().met > most) break;
    }
    return row;
  }

  static double most_met(const Row& row) {
    double most = 0;
    for (const RowLook& look : row.looks) most = std::max(most, look.met);
    return most;
  }

  static bool leans_left(const Row& row) {
    return std::any_of(row.looks.begin(), row.looks.end(),
                       [](const RowLook& look) { return look.leans_left; });
  }

  // True where a row meets too much, or lies on the wrong side of what is thin.
  bool is_worse(const Row& made, const Row& old) const {
    return most_met(made) > limits_.most_met || (leans_left(made) && !leans_left(old));
  }

  // Where a tighter arc begins what is met has a peak, narrower than what lies between two looks.
  bool joints_hold(const std::vector<Segment>& way) {
    return std::all_of(way.begin(), way.end() - 1, [&](const Segment& move) {
      const double heading = angle_of(move.tangent(1));
      return engagement_ahead(ground_, move.b, heading, kThin, arcs_) <= limits_.most_met;
    });
  }

  bool may_be(const std::vector<Segment>& way) const {
    return std::all_of(way.begin(), way.end(), [&](const Segment& move) {
      return move.length() >= kShortest && std::abs(move.curvature()) <= limits_.most_curvature &&
             is_inside(move, centres_, kOnBorder);
    });
  }

  // s: of a way's blocks, and of the corners that posts make of its tight turns.
  double price_of(const std::vector<Segment>& way) const {
    return params_.move_price * static_cast<double>(way.size()) +
           kCornerPrice * static_cast<double>(corners_of(way));
  }

  static std::ptrdiff_t corners_of(const std::vector<Segment>& way) {
    return std::count_if(way.begin(), way.end(), is_tight);
  }

  // A row, what it meets, and what is saved by another way.
  struct Given {
    std::size_t first = 0, last = 0;
    std::vector<Segment> moves;
    Row met;
    double price = 0, unused = 0;  // s, mm^2
  };

  double gain_of(const Given& row, double unused, const std::vector<Segment>& way) const {
    return row.price - price_of(way) + (row.unused - unused) / (full_width_ * params_.feed) * 60;
  }

  void try_row(std::size_t first, std::size_t last, Best& best) {
    Given row{first,
              last,
              {moves_.begin() + static_cast<std::ptrdiff_t>(first),
               moves_.begin() + static_cast<std::ptrdiff_t>(last) + 1},
              {{moves_[first].a, moves_[first].tangent(0)},
               {moves_[last].b, moves_[last].tangent(1)},
               {},
               {}},
              0,
              0};
    for (std::size_t k = first; k <= last; ++k) {
      if (looked_at(k).is_beside_nothing) return;
      append(moves_[k], looked_[k], row.met);
    }
    row.price = price_of(row.moves);
    row.unused = unused_area(row.met, limits_.least_width);
    if (rows_ == Rows::kFitted) try_fitted(row, best);
    // Fitted arcs keep the turns of the row's ends, tight ones as well.
    if (rows_ == Rows::kQuick || corners_of(row.moves) > 0) try_likely(row, best);
  }

  void try_likely(const Given& row, Best& best) {
    std::vector<Segment> way = likely_bi_arc(
        row.moves,
        {limits_.engagement, radius_, limits_.shortest, tightest_in(row.first, row.last)});
    if (way.empty() || !may_be(way)) return;
    const Row made = row_along(way, row.met, limits_.most_met);
    if (is_worse(made, row.met)) return;
    const double gain = gain_of(row, unused_area(made, limits_.least_width), way);
    if (gain > best.gain && joints_hold(way)) best = {std::move(way), gain, row.moves.size()};
  }

  void try_fitted(const Given& row, Best& best) {
    Row known = row.met;
    for (int i = 0; i < kTries; ++i) {
      double unused = 0;
      std::vector<Segment> way = fit_row(known, row.moves.size() - 1, limits_, &unused);
      if (way.empty() || gain_of(row, unused, way) <= best.gain || !may_be(way)) return;
      known = row_along(way, row.met, limits_.most_met + kHopeless);
      const double most = most_met(known);
      if (most > limits_.most_met + kHopeless) return;
      if (most > limits_.most_met) continue;
      if (leans_left(known) && !leans_left(row.met)) return;
      const double gain = gain_of(row, unused_area(known, limits_.least_width), way);
      if (gain > best.gain && joints_hold(way)) best = {std::move(way), gain, row.moves.size()};
      return;
    }
  }

  std::vector<Segment> moves_;
  Stretch stretch_;
  const Area& centres_;
  ClearedGround& ground_;
  const ClearingParams& params_;
  Rows rows_;
  bool comes_back_ = false;
  double radius_;
  double full_width_;  // mm, of a straight cut at the engagement angle
  RowLimits limits_;
  double done_ = 0;             // mm of the moves before the row
  std::vector<Looked> looked_;  // the first of moves_
  std::vector<AngularInterval> arcs_;
};

}  // namespace

std::vector<Segment> with_fewer_moves(const std::vector<Segment>& moves, const Stretch& stretch,
                                      const Area& centres, ClearedGround& ground,
                                      const ClearingParams& params, double overload, Rows rows) {
  return FewerMoves(moves, stretch, centres, ground, params, overload, rows).made();
}

}  // namespace evenload
