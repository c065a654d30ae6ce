// The method: headings along arcs are a function of the way that is straight between their joints.
// The joints are where the row has them but for the one that goes; then joints and headings are
// moved, each by itself and in ever smaller steps, as long as that is better. The heading at the
// last joint follows from the others: the row's end stays where it is.

#include "strategy/row_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace evenload {
namespace {

// What is left to other passes costs their blocks as well: so much of its area besides.
constexpr double kAreaWorth = 0.3;
// rad: of any arc.
constexpr double kMostArc = 0.9 * kPi;
// rad: where what is met would change by more the model means nothing.
constexpr double kMostLess = 0.25;
// mm, and for turns that are too tight mm^2: by what a rad, or a mm of way at a rad, over the limit
// counts.
constexpr double kOverPrice = 100, kTightPrice = 30;
// The first step of a joint as a share of the row, and of a heading in rad; the last as a share of
// the first.
constexpr double kJointStep = 0.15, kTurnStep = 0.03, kLastStep = 0.13;
constexpr int kMostRounds = 10;

class Unused {
 public:
  explicit Unused(double least_width) : least_(least_width), widest_(least_width) {}
  void add(double width, double length) {
    area_ += width * length;
    widest_ = std::max(widest_, width);
  }
  void end_move(double along) {
    sum_ += widest_ * (along - begin_);
    begin_ = along;
    widest_ = least_;
  }
  double value() const { return sum_ - (1 + kAreaWorth) * area_; }

 private:
  double least_, widest_;
  double begin_ = 0, sum_ = 0, area_ = 0;
};

// The joints of arcs, the row's beginning and end among them.
struct Headings {
  std::array<RowPlace, kMostArcs + 1> joints;
  std::size_t last = 0;  // the row's end
  double price = std::numeric_limits<double>::infinity();
};

double curvature(const RowPlace& from, const RowPlace& to) {
  return (to.turned - from.turned) / (to.along - from.along);
}

class Fit {
 public:
  Fit(const Row& row, const RowLimits& limits)
      : row_(row),
        limits_(limits),
        width_slope_(limits.tool_radius * std::sin(limits.engagement)),
        per_width_slope_(1 / width_slope_) {}

  // The best arcs found, one fewer than the row's moves or as many; nothing where there is no room
  // for them.
  std::optional<Headings> best(bool one_fewer) const {
    Headings best, second;
    for (std::size_t k = 0; one_fewer && k + 1 < row_.joints.size(); ++k) {
      const Headings headings = without(k);
      if (headings.price < best.price)
        second = std::exchange(best, headings);
      else if (headings.price < second.price)
        second = headings;
    }
    if (!one_fewer) best = without(row_.joints.size());
    for (Headings* start : {&best, &second})
      if (!std::isinf(start->price)) improve(*start);
    if (second.price < best.price) best = second;
    if (std::isinf(best.price)) return std::nullopt;
    return best;
  }

 private:
  Headings without(std::size_t joint) const {
    Headings headings;
    for (std::size_t k = 0; k < row_.joints.size(); ++k)
      if (k != joint) headings.joints[++headings.last] = row_.joints[k];
    close(headings);
    return headings;
  }

  // The last joint's heading, and the price of it all.
  void close(Headings& headings) const {
    auto& j = headings.joints;
    const std::size_t n = headings.last;
    double twice_aside = j[n].turned * (j[n].along - j[n - 1].along);
    for (std::size_t k = 1; k + 1 < n; ++k)
      twice_aside += j[k].turned * (j[k + 1].along - j[k - 1].along);
    j[n - 1].turned = (2 * j[n].aside - twice_aside) / (j[n].along - j[n - 2].along);
    headings.price = price_of(headings);
  }

  double price_of(const Headings& headings) const {
    double price = 0, until = 0, aside = 0;
    Unused unused(limits_.least_width);
    auto look = row_.looks.begin();
    for (std::size_t k = 0; k < headings.last; ++k) {
      const RowPlace &from = headings.joints[k], &to = headings.joints[k + 1];
      const double length = to.along - from.along, turn = std::abs(to.turned - from.turned);
      if (length < limits_.shortest || turn > kMostArc)
        return std::numeric_limits<double>::infinity();
      price += kTightPrice * std::max(0.0, turn - limits_.most_curvature * length);
      const double half_curvature = 0.5 * curvature(from, to);
      const bool is_last = k + 1 == headings.last;
      for (; look != row_.looks.end() && (is_last || look->along <= to.along); ++look) {
        const double on = look->along - from.along, bend = half_curvature * on;
        const double turned_left = from.turned + 2 * bend - look->turned;
        const double left = aside + on * (from.turned + bend) - look->aside;
        const double more = -turned_left - left * per_width_slope_;
        const double part = 2 * (look->along - until);
        until += part;
        price +=
            kOverPrice * part *
            (std::max(0.0, look->met + more - limits_.most_met) + std::max(0.0, -more - kMostLess));
        unused.add(std::max(0.0, look->width + width_slope_ * more), part);
      }
      unused.end_move(to.along);
      aside += 0.5 * length * (from.turned + to.turned);
    }
    return price + unused.value();
  }

  void improve(Headings& best) const {
    double step = 1;
    for (int round = 0; round < kMostRounds && step > kLastStep; ++round)
      if (!improve_by(step, best)) step *= 0.5;
  }

  bool improve_by(double step, Headings& best) const {
    const double old = best.price;
    const auto take = [&](Headings&& next) {
      close(next);
      if (next.price >= best.price) return false;
      best = std::move(next);
      return true;
    };
    for (std::size_t k = 1; k < best.last; ++k)
      for (const double side : {1.0, -1.0}) {
        const double by = side * step * kJointStep * row_.joints.back().along;
        Headings next = best;
        const std::size_t piece = by > 0 ? k : k - 1;
        next.joints[k].turned += curvature(best.joints[piece], best.joints[piece + 1]) * by;
        next.joints[k].along += by;
        if (take(std::move(next))) break;
      }
    for (std::size_t k = 1; k + 1 < best.last; ++k)
      for (const double side : {1.0, -1.0}) {
        Headings next = best;
        next.joints[k].turned += side * step * kTurnStep;
        if (take(std::move(next))) break;
      }
    return best.price < old;
  }

  const Row& row_;
  const RowLimits& limits_;
  double width_slope_;  // mm per rad of engagement, and mm aside per rad
  double per_width_slope_;
};

// All but the last two as the joints have them, these as a bi-arc to the row's end.
std::vector<Segment> arcs_of(const Row& row, const Headings& headings) {
  const auto& joints = headings.joints;
  std::vector<Segment> moves;
  PlanePoint here = row.from;
  const std::size_t last = headings.last;
  for (std::size_t k = 0; k + 2 < last; ++k) {
    const double half = 0.5 * (joints[k + 1].turned - joints[k].turned);
    const double length = joints[k + 1].along - joints[k].along;
    const double chord = std::abs(half) < 1e-9 ? length : length * std::sin(half) / half;
    const Vec2 end = here.p + chord * unit(angle_of(here.direction) + half);
    moves.push_back(Segment::from_bulge(here.p, end, std::tan(0.5 * half)));
    here = {end, moves.back().tangent(1)};
  }
  const double ratio = (joints[last - 1].along - joints[last - 2].along) /
                       (joints[last].along - joints[last - 1].along);
  const std::optional<BiArc> pair = bi_arc(here, row.to, kMostArc, ratio);
  if (!pair) return {};
  moves.insert(moves.end(), {pair->first, pair->second});
  return moves;
}

}  // namespace

double unused_area(const Row& row, double least_width) {
  Unused unused(least_width);
  double until = 0;
  std::size_t k = 0;
  for (const RowLook& look : row.looks) {
    for (; k + 1 < row.joints.size() && row.joints[k].along < look.along; ++k)
      unused.end_move(row.joints[k].along);
    const double length = 2 * (look.along - until);
    until += length;
    unused.add(look.width, length);
  }
  unused.end_move(row.joints.back().along);
  return unused.value();
}

std::vector<Segment> fit_row(const Row& row, std::size_t count, const RowLimits& limits,
                             double* unused) {
  const std::optional<Headings> best = Fit(row, limits).best(count < row.joints.size());
  if (!best) return {};
  *unused = best->price;
  return arcs_of(row, *best);
}

}  // namespace evenload
