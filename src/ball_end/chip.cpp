#include "ball_end/chip.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ball_end/ball_region.h"
#include "support/demand.h"

namespace evenload {

namespace {

constexpr double kLookBeyond = 1.1;  // of the stock's reach on the ball
constexpr double kInside = 1e-5;     // rad, within a piece, where its bounds hold
constexpr double kHardly = 1.5;      // of where the tooth before ceases to bound the thickest place
// Chips hardly longer than the way shrink along it to nothing: then it is cut into parts.
constexpr double kShort = 3;
constexpr int kParts = 6;
constexpr int kThirds = 24;    // leave 1e-4 of an interval, at whose peak thickness is flat
constexpr int kHalvings = 26;  // 1e-9 mm
// Two Gauss nodes along the way from tooth to tooth: what the ball sweeps is nearly a parabola of
// it.
constexpr double kWays[] = {0.2113248654051871, 0.7886751345948129};

class ChipWork {
 public:
  ChipWork(const WorkedSurface& surface, Vec2 at, const ChipCase& task) : task_(task) {
    const Vec2 along = unit(task.feed_direction), left = left_normal(along);
    centre_ = surface.centre(at, along).at;
    const Eigen::Vector3d way =
        centre_ - surface.centre(at - task.feed_per_tooth * along, along).at;
    way_ = way.norm();
    const Eigen::Vector3d normal = surface.normal(at);
    frame_.feed = way / way_;
    frame_.down = -(normal - normal.dot(frame_.feed) * frame_.feed).normalized();
    frame_.side = frame_.feed.cross(frame_.down);
    material_ = {&surface, task.ball_radius, task.allowance, {}};
    if (task.uncut == Uncut::kRight || task.uncut == Uncut::kStrip)
      material_.passes.emplace_back(surface, at + task.stepover * left, along);
    if (task.uncut == Uncut::kLeft || task.uncut == Uncut::kStrip)
      material_.passes.emplace_back(surface, at - task.stepover * left, along);
    reach_ = stock_reach();
  }

  Chip chip() {
    Chip result;
    take_tool_face(result);
    take_previous_face(result);
    take_volume(result);
    return result;
  }

 private:
  // How far from the point of contact the stock is cut, as an angle across the feed.
  double stock_reach() const {
    const Material stock{material_.surface, task_.ball_radius, task_.allowance, {}};
    const BallRegion region(stock, frame_, centre_, -angle_of_half(way_));
    double reach = std::acos(1 - task_.allowance / task_.ball_radius);
    while (reach < kPi &&
           !(region.interval(reach).is_empty() && region.interval(-reach).is_empty()))
      reach *= kLookBeyond;
    // The ball's other places on its way reach a little farther.
    return std::min(kLookBeyond * reach, kPi);
  }

  // On the ball, between the middle of a way and its end.
  double angle_of_half(double way) const { return std::asin(way / (2 * task_.ball_radius)); }

  // Of the tool's axis, downwards: its components along the feed and across it.
  double axis_along() const { return -frame_.feed.z(); }
  double axis_across(double b) const {
    return -(std::cos(b) * frame_.down.z() + std::sin(b) * frame_.side.z());
  }

  template <typename Visit>
  void visit(const std::vector<double>& changes, const Visit& at) const {
    for (std::size_t i = 0; i + 1 < changes.size(); ++i) {
      if (changes[i + 1] - changes[i] < 4 * kInside) continue;
      for (const Node& node : nodes_between(changes[i], changes[i + 1])) at(node);
    }
  }

  // The largest value of a function of b over the material, at a change, at `also` or between
  // nodes.
  template <typename Function>
  double largest(const std::vector<double>& changes, double also, const Function& of) const {
    if (changes.empty()) return of(also);
    double best = also, value = of(also);
    const auto look = [&](double b) {
      const double found = of(b);
      if (found > value) value = found, best = b;
    };
    visit(changes, [&](const Node& node) { look(node.b); });
    for (const double b : changes) look(b - kInside), look(b + kInside);
    for (double step = (changes.back() - changes.front()) / kNodes; step > kInside; step /= 2) {
      const double at = best;
      look(at - step);
      look(at + step);
    }
    return value;
  }

  std::vector<double> changes_of(const BallRegion& region) const {
    return state_changes([&](double b) { return region.interval(b).state; }, reach_);
  }

  // Of a region between its changes, on the unit sphere.
  double area_of(const BallRegion& region, const std::vector<double>& changes) const {
    double area = 0;
    visit(changes, [&](const Node& node) {
      const Interval found = region.interval(node.b);
      if (!found.is_empty()) area += node.weight * (std::sin(found.high) - std::sin(found.low));
    });
    return area;
  }

  void take_tool_face(Chip& result) const {
    const BallRegion region(material_, frame_, centre_, -angle_of_half(way_));
    const std::vector<double> changes = changes_of(region);
    const double area = area_of(region, changes);
    // Of the angle from the tool's axis, along the interval at b: its least or its largest cosine.
    const auto cosine = [&](double b, bool is_least) {
      const Interval found = region.interval(b);
      if (found.is_empty()) return -2.0;
      const double along = axis_along(), across = axis_across(b);
      const auto at = [&](double a) { return std::sin(a) * along + std::cos(a) * across; };
      if (is_least) return -std::min(at(found.low), at(found.high));
      return at(std::clamp(std::atan2(along, across), found.low, found.high));
    };
    const double tip = std::atan2(-frame_.side.z(), -frame_.down.z());
    const auto angle = [&](double value) { return std::acos(std::clamp(value, -1.0, 1.0)); };
    result.edge_from = angle(largest(changes, tip, [&](double b) { return cosine(b, false); }));
    result.edge_to = angle(-largest(changes, tip, [&](double b) { return cosine(b, true); }));
    demand(area > 0, "No chip: earlier passes left no stock where the tool stands.");
    demand(result.edge_to < kPi / 2,
           "The chip reaches beyond the lower half of the ball: the surface is too steep for a "
           "ball-end tool along its axis.");
    result.tool_face = task_.ball_radius * task_.ball_radius * area;
  }

  void take_previous_face(Chip& result) {
    const double r = task_.ball_radius;
    const Eigen::Vector3d before = centre_ - way_ * frame_.feed;
    const BallRegion region(material_, frame_, before, angle_of_half(way_));
    const std::vector<double> changes = changes_of(region);
    const double area = area_of(region, changes);
    // The chip is thickest at the foremost place of this face.
    const double foremost = largest(changes, 0, [&](double b) { return region.interval(b).high; });
    demand(
        area > 0,
        "The feed per tooth is too large beside the stepover: the tooth before does not bound the "
        "chip, which has no mean thickness by its face.");
    result.previous_face = r * r * area;
    result.max_thickness = r - std::sqrt(r * r - 2 * r * way_ * std::sin(foremost) + way_ * way_);
    if (std::sin(foremost) < kShort * way_ / r) parts_ = kParts;
    if (std::sin(foremost) < kHardly * way_ / r)
      result.max_thickness = std::max(result.max_thickness, thickest_ray());
  }

  // Where the tooth before hardly bounds the chip it may be thickest elsewhere: of all rays.
  double thickest_ray() const {
    const BallRegion region(material_, frame_, centre_, -angle_of_half(way_));
    const auto along_b = [&](double b) {
      const Interval found = region.interval(b);
      if (found.is_empty()) return 0.0;
      double low = found.low, high = found.high;
      for (int i = 0; i < kThirds; ++i) {
        const double third = (high - low) / 3;
        if (ray_thickness(b, low + third) < ray_thickness(b, high - third))
          low += third;
        else
          high -= third;
      }
      return ray_thickness(b, 0.5 * (low + high));
    };
    return largest(changes_of(region), 0, along_b);
  }

  double ray_thickness(double b, double a) const {
    const double r = task_.ball_radius, ahead = -way_ * std::sin(a);
    const Eigen::Vector3d ray =
        std::sin(a) * frame_.feed +
        std::cos(a) * (std::cos(b) * frame_.down + std::sin(b) * frame_.side);
    double inner = ahead + std::sqrt(ahead * ahead + r * r - way_ * way_), outer = r;
    if (material_.depth(centre_ + inner * ray).depth > 0) return r - inner;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (inner + outer);
      (material_.depth(centre_ + middle * ray).depth > 0 ? outer : inner) = middle;
    }
    return r - outer;
  }

  // Where the local diameter, seen from the tool's place, is that of the tip; `behind`: how far the
  // ball is from there.
  Interval tip(double b, double behind) const {
    const double r = task_.ball_radius, along = axis_along(), across = axis_across(b);
    const double size = std::hypot(along, across), middle = std::atan2(along, across);
    const double cosine = std::sqrt(1 - kTip * kTip);
    double ends[2] = {middle, middle};
    for (int side = 0; side < 2; ++side)
      for (int i = 0; i < 5; ++i) {
        const double away =
            std::sqrt(r * r - 2 * r * behind * std::sin(ends[side]) + behind * behind);
        const double share = (cosine * away + behind * along) / (r * size);
        if (share >= 1) return {};
        ends[side] = middle + (side ? 1 : -1) * std::acos(share);
      }
    return {ends[0], ends[1], 0};
  }

  void take_volume(Chip& result) const {
    const double r = task_.ball_radius;
    double volume = 0, at_tip = 0;
    for (int i = 0; i < 2 * parts_; ++i) {
      const double behind = (1 - (i / 2 + kWays[i % 2]) / parts_) * way_;
      const BallRegion region(material_, frame_, centre_ - behind * frame_.feed,
                              angle_of_half(behind));
      const auto common = [&](double b, const Interval& found) {
        Interval of_tip = tip(b, behind);
        if (found.is_empty() || of_tip.is_empty()) return Interval{};
        of_tip.state = (of_tip.low > found.low ? 1 : 0) + (of_tip.high < found.high ? 2 : 0);
        of_tip.low = std::max(of_tip.low, found.low);
        of_tip.high = std::min(of_tip.high, found.high);
        return of_tip.high > of_tip.low ? of_tip : Interval{};
      };
      const std::vector<double> changes = state_changes(
          [&](double b) {
            const Interval found = region.interval(b);
            return 8 * found.state + common(b, found).state;
          },
          reach_);
      const double weight = way_ * r * r / (2 * parts_);
      visit(changes, [&](const Node& node) {
        const Interval found = region.interval(node.b);
        if (found.is_empty()) return;
        const auto flux = [&](const Interval& in) {
          const double low = std::sin(in.low), high = std::sin(in.high);
          return weight * node.weight * 0.5 * (high * high - low * low);
        };
        volume += flux(found);
        const Interval near = common(node.b, found);
        if (!near.is_empty()) at_tip += flux(near);
      });
    }
    result.volume = volume;
    result.tip_share = at_tip / volume;
  }

  ChipCase task_;
  Material material_;
  FeedFrame frame_;
  Eigen::Vector3d centre_;
  double way_ = 0, reach_ = 0;
  int parts_ = 1;  // of the way, with nodes of their own
};

}  // namespace

void check(const ChipCase& task) {
  demand(std::isfinite(task.ball_radius) && task.ball_radius > 0,
         "The tool's diameter must be above 0 mm.");
  demand(task.feed_per_tooth > 0 && task.feed_per_tooth < task.ball_radius,
         "The feed per tooth must lie above 0 mm and below the tool's radius.");
  demand(task.uncut == Uncut::kSlot || (task.stepover > 0 && task.stepover < 2 * task.ball_radius),
         "The stepover must lie above 0 mm and below the tool's diameter.");
  demand(
      task.allowance > 0 && task.allowance < task.ball_radius,
      "The axial depth, the stock's allowance, must lie above 0 mm and below the tool's radius.");
  demand(std::isfinite(task.feed_direction), "The feed direction must be a number of degrees.");
}

Chip chip(const WorkedSurface& surface, Vec2 at, const ChipCase& task) {
  check(task);
  return ChipWork(surface, at, task).chip();
}

}  // namespace evenload
