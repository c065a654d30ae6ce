// The method: headings along arcs are a function of the way that is straight between their joints.
// The joints are where the row has them but for those that go; then joints and headings are moved,
// each by itself and in ever smaller steps, as long as that is better. The heading at the last
// joint follows from the others: the row's end stays where it is.

#include "strategy/row_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

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
constexpr double kJointStep = 0.15, kTurnStep = 0.03, kLastStep = 0.07;
constexpr int kMostRounds = 16;
// So many of the ways to leave out joints are made better.
constexpr std::size_t kStarts = 2;

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
  std::vector<RowPlace> joints;
  double price = std::numeric_limits<double>::infinity();
};

// 1/mm, of the arc from joint `k` on.
double curvature(const std::vector<RowPlace>& joints, std::size_t k) {
  return (joints[k + 1].turned - joints[k].turned) / (joints[k + 1].along - joints[k].along);
}

class Fit {
 public:
  Fit(const Row& row, const RowLimits& limits)
      : row_(row),
        limits_(limits),
        width_slope_(limits.tool_radius * std::sin(limits.engagement)) {}

  // The best arcs found; nothing where there is no room for so many.
  std::optional<Headings> best(std::size_t count) const {
    std::vector<Headings> starts;
    const std::size_t inner = row_.joints.size() - 1, gone = inner + 1 - count;
    if (gone == 0) starts.push_back(without(inner + 1, inner + 1));
    for (std::size_t k = 0; gone > 0 && k < inner; ++k)
      for (std::size_t l = gone == 1 ? k : k + 1; l < (gone == 1 ? k + 1 : inner); ++l)
        starts.push_back(without(k, l));
    const auto is_better = [](const Headings& a, const Headings& b) { return a.price < b.price; };
    std::stable_sort(starts.begin(), starts.end(), is_better);
    if (starts.size() > kStarts) starts.resize(kStarts);
    for (Headings& start : starts) improve(start);
    const auto least = std::min_element(starts.begin(), starts.end(), is_better);
    if (least == starts.end() || std::isinf(least->price)) return std::nullopt;
    return *least;
  }

 private:
  Headings without(std::size_t one, std::size_t other) const {
    Headings headings;
    headings.joints.push_back({});
    for (std::size_t k = 0; k < row_.joints.size(); ++k)
      if (k != one && k != other) headings.joints.push_back(row_.joints[k]);
    close(headings);
    return headings;
  }

  // The last joint's heading, and the price of it all.
  void close(Headings& headings) const {
    std::vector<RowPlace>& j = headings.joints;
    const std::size_t n = j.size() - 1;
    double twice_aside = j[n].turned * (j[n].along - j[n - 1].along);
    for (std::size_t k = 1; k + 1 < n; ++k)
      twice_aside += j[k].turned * (j[k + 1].along - j[k - 1].along);
    j[n - 1].turned = (2 * j[n].aside - twice_aside) / (j[n].along - j[n - 2].along);
    headings.price = price_of(j);
  }

  double price_of(const std::vector<RowPlace>& joints) const {
    double price = 0;
    for (std::size_t k = 0; k + 1 < joints.size(); ++k) {
      const double length = joints[k + 1].along - joints[k].along;
      const double turn = std::abs(joints[k + 1].turned - joints[k].turned);
      if (length < limits_.shortest || turn > kMostArc)
        return std::numeric_limits<double>::infinity();
      price += kTightPrice * std::max(0.0, turn - limits_.most_curvature * length);
    }
    Unused unused(limits_.least_width);
    double until = 0, aside = 0;
    std::size_t k = 0;
    for (const RowLook& look : row_.looks) {
      for (; k + 2 < joints.size() && joints[k + 1].along < look.along; ++k) {
        unused.end_move(joints[k + 1].along);
        aside += 0.5 * (joints[k + 1].along - joints[k].along) *
                 (joints[k].turned + joints[k + 1].turned);
      }
      const double on = look.along - joints[k].along, bend = 0.5 * curvature(joints, k) * on;
      const double turned_left = joints[k].turned + 2 * bend - look.turned;
      const double left = aside + on * (joints[k].turned + bend) - look.aside;
      const double more = -turned_left - left / width_slope_;
      const double length = 2 * (look.along - until);
      until += length;
      price +=
          kOverPrice * length *
          (std::max(0.0, look.met + more - limits_.most_met) + std::max(0.0, -more - kMostLess));
      unused.add(std::max(0.0, look.width + width_slope_ * more), length);
    }
    unused.end_move(joints.back().along);
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
    for (std::size_t k = 1; k + 1 < best.joints.size(); ++k)
      for (const double side : {1.0, -1.0}) {
        const double by = side * step * kJointStep * row_.joints.back().along;
        Headings next = best;
        next.joints[k].turned += curvature(best.joints, by > 0 ? k : k - 1) * by;
        next.joints[k].along += by;
        if (take(std::move(next))) break;
      }
    for (std::size_t k = 1; k + 2 < best.joints.size(); ++k)
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
};

// All but the last two as the joints have them, these as a bi-arc to the row's end.
std::vector<Segment> arcs_of(const Row& row, const std::vector<RowPlace>& joints) {
  std::vector<Segment> moves;
  PlanePoint here = row.from;
  const std::size_t last = joints.size() - 1;
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
  const std::optional<Headings> best = Fit(row, limits).best(count);
  if (!best) return {};
  *unused = best->price;
  return arcs_of(row, best->joints);
}

}  // namespace evenload
