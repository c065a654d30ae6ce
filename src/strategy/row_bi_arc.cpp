#include "strategy/row_bi_arc.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/bi_arc.h"

namespace evenload {
namespace {

// How many times as far along the first tangent as along the last the joints lie that are tried.
constexpr double kRatios[] = {0.22, 0.35, 0.6, 1, 1.6, 2.8, 4.5};
// The best is then taken so many times greater and smaller.
constexpr double kFinerRatios[] = {1.25, 1.12};
// rad: of either arc.
constexpr double kMostArc = 0.9 * kPi;
// Into how many parts a new arc is divided by the places where it is compared with the row; rad: by
// how much more or less than along the row may be expected to be met.
constexpr int kChangeLooks = 4;
constexpr double kMostMore = 0.08;
constexpr double kMostLess = 0.15;

class LikelyBiArc {
 public:
  LikelyBiArc(const std::vector<Segment>& row, const BiArcLimits& limits)
      : row_(row), limits_(limits) {}

  std::vector<Segment> best() {
    for (const double ratio : kRatios) change_less(ratio);
    if (way_.empty()) return {};
    for (const double finer : kFinerRatios) {
      const double middle = ratio_;
      change_less(middle * finer);
      change_less(middle / finer);
    }
    return std::move(way_);
  }

 private:
  // Takes the bi-arc of `ratio` where that changes less than the best one so far.
  void change_less(double ratio) {
    const std::optional<BiArc> pair =
        bi_arc({row_.front().a, row_.front().tangent(0)}, {row_.back().b, row_.back().tangent(1)},
               kMostArc, ratio);
    if (!pair) return;
    double change = 0;
    for (const Segment& arc : {pair->first, pair->second}) {
      if (arc.length() < limits_.shortest || std::abs(arc.curvature()) > limits_.most_curvature)
        return;
      for (int i = 1; i < kChangeLooks; ++i) {
        change = std::max(change, change_at(arc, static_cast<double>(i) / kChangeLooks));
        if (change >= change_) return;
      }
    }
    way_ = {pair->first, pair->second};
    ratio_ = ratio;
    change_ = change;
  }

  // By how much what is met at `at` of a new arc is expected to change, as a share of what it may.
  // To turn right and to be further to the right both mean to meet more.
  double change_at(const Segment& arc, double at) const {
    const Vec2 p = arc.point(at);
    const Segment* old = &row_.front();
    double least = old->distance_to(p);
    for (const Segment& move : row_) {
      const double distance = move.distance_to(p);
      if (distance >= least) continue;
      least = distance;
      old = &move;
    }
    const double t = old->nearest(p);
    const Vec2 along = old->tangent(t), now = arc.tangent(at);
    const double left = cross(along, p - old->point(t));
    const double turned_left = std::atan2(cross(along, now), dot(along, now));
    const double more = -turned_left - left / (limits_.tool_radius * std::sin(limits_.engagement));
    return more > 0 ? more / kMostMore : -more / kMostLess;
  }

  const std::vector<Segment>& row_;
  const BiArcLimits& limits_;
  std::vector<Segment> way_;
  double ratio_ = 1, change_ = 1;
};

}  // namespace

std::vector<Segment> likely_bi_arc(const std::vector<Segment>& row, const BiArcLimits& limits) {
  return LikelyBiArc(row, limits).best();
}

}  // namespace evenload
