#include "simulate/engaged_arcs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace evenload {
namespace {

// mm: points of a border this near to the circle may be the tool's own work, or rounding.
constexpr double kOutside = 4e-6;
// mm: heights that differ by less are one; G-code has three decimals.
constexpr double kThinnest = 1e-5;
// Spacings around a change in which the old border is looked for.
constexpr double kReach = 2.5;
// Points of a border this near, in spacings, do not tell its direction.
constexpr double kApart = 0.2;
// Share of the gap between two dexels by which the border may miss it.
constexpr double kSlack = 0.3;

// Where a dexel meets the circle.
struct Look {
  double angle = 0;  // rad
  double depth = 0;  // mm of material above the tip
};

class Finder {
 public:
  Finder(const DexelStock& stock, const ToolCircle& tool, double low, double high)
      : stock_(stock),
        tool_(tool),
        radius_(tool.radius),
        tip_(std::max(tool.z, stock.bottom())),
        low_(tool.feed_angle + low),
        high_(tool.feed_angle + high) {}

  void find(std::vector<EngagedArc>& arcs) {
    arcs.clear();
    // Quarters of the circle about multiples of pi / 2.
    const int first = static_cast<int>(std::floor((low_ + kPi / 4) / (kPi / 2)));
    for (int quarter = first; (quarter - 0.5) * kPi / 2 < high_; ++quarter) look_at(quarter, arcs);
    end(high_, arcs);
    for (EngagedArc& arc : arcs) {
      arc.low -= tool_.feed_angle;
      arc.high -= tool_.feed_angle;
    }
  }

 private:
  void look_at(int quarter, std::vector<EngagedArc>& arcs) {
    const double from = std::max(low_, (quarter - 0.5) * kPi / 2);
    const double to = std::min(high_, (quarter + 0.5) * kPi / 2);
    if (!(from < to)) return;
    const int side = ((quarter % 4) + 4) % 4;  // right, top, left, bottom
    const bool by_rows = side % 2 == 0;
    const Vec2 c = tool_.centre;
    const double across = by_rows ? c.y : c.x, along = by_rows ? c.x : c.y;
    // How far across the dexels lie from the centre at both ends.
    const double begin = radius_ * (by_rows ? std::sin(from) : std::cos(from));
    const double stop = radius_ * (by_rows ? std::sin(to) : std::cos(to));
    const bool rising = begin < stop;
    const double lowest = across + std::min(begin, stop), highest = across + std::max(begin, stop);
    const int low = by_rows ? stock_.row_from(lowest) : stock_.column_from(lowest);
    const int high = by_rows ? stock_.row_from(highest) : stock_.column_from(highest);  // excluded
    const int count = by_rows ? stock_.row_count() : stock_.column_count();
    const double outwards = side < 2 ? 1 : -1;
    for (int k = low; k < high; ++k) {
      const int index = rising ? k : high - 1 - (k - low);
      const double d = (by_rows ? stock_.row_y(index) : stock_.column_x(index)) - across;
      const double reach = std::sqrt((radius_ - d) * (radius_ + d));
      double depth = 0;
      if (index >= 0 && index < count) {
        const DexelRow& dexel = by_rows ? stock_.row(index) : stock_.column(index);
        depth = std::max(0.0, dexel.top_at(along + outwards * reach) - tip_);
        if (depth < kThinnest) depth = 0;
      }
      take(depth, side, d, quarter, arcs);
    }
  }

  // The angle of a dexel at distance d from the centre, on a side of the circle.
  double angle_at(int side, double d, int quarter) const {
    const double turn = std::asin(std::clamp(d / radius_, -1.0, 1.0));
    return quarter * kPi / 2 + (side == 0 || side == 3 ? turn : -turn);
  }

  void take(double depth, int side, double d, int quarter, std::vector<EngagedArc>& arcs) {
    const bool same = has_last_ && std::abs(depth - last_.depth) <=
                                       ((depth > 0) == (last_.depth > 0) ? stock_.resolution() : 0);
    if (same && !(depth > 0)) {
      last_side_ = side, last_d_ = d, last_quarter_ = quarter;
      return;
    }
    const Look now{angle_at(side, d, quarter), depth};
    if (!has_last_) {
      has_last_ = true;
      if (depth > 0) begin(low_);
    } else if (same) {
      add(now);
    } else {
      if (!(last_.depth > 0)) last_.angle = angle_at(last_side_, last_d_, last_quarter_);
      const double at = change_between(last_, now);
      end(at, arcs);
      if (depth > 0) begin(at);
    }
    if (depth > 0) add(now);
    last_ = now;
    last_side_ = side, last_d_ = d, last_quarter_ = quarter;
  }

  void begin(double angle) {
    open_ = true;
    arc_ = {angle, angle, 0};
    sum_ = 0;
    looks_ = 0;
  }

  void add(const Look& look) {
    sum_ += look.depth;
    ++looks_;
    last_.depth = look.depth;
  }

  void end(double angle, std::vector<EngagedArc>& arcs) {
    if (!open_) return;
    open_ = false;
    arc_.high = angle;
    arc_.depth = looks_ > 0 ? sum_ / looks_ : 0;
    if (arc_.high > arc_.low) arcs.push_back(arc_);
  }

  // The angle between two looks where the stock's border crosses the circle.
  double change_between(const Look& a, const Look& b) {
    if ((a.depth > 0) == (b.depth > 0)) return 0.5 * (a.angle + b.angle);
    collect_border(a.angle, b.angle);
    const double middle = 0.5 * (a.angle + b.angle);
    if (border_count_ == 0) return middle;
    // Nearest to the gap first.
    const Vec2 gap = tool_.centre + radius_ * unit(middle);
    const auto nearer = [&](Vec2 p, Vec2 q) {
      return squared_norm(p - gap) < squared_norm(q - gap);
    };
    std::sort(border_.begin(), border_.begin() + border_count_, nearer);
    const Vec2 nearest = border_[0];
    const double slack = kSlack * (b.angle - a.angle);
    for (int i = 1; i < border_count_; ++i) {
      const Vec2 way = nearest - border_[static_cast<std::size_t>(i)];
      const double length = norm(way);
      if (length < kApart * stock_.resolution() || length > kReach * stock_.resolution()) continue;
      for (const Vec2 direction : {way, -way}) {
        const double angle = meet_circle(nearest, direction / length, middle);
        if (angle > a.angle - slack && angle < b.angle + slack)
          return std::clamp(angle, a.angle, b.angle);
      }
    }
    const double towards = middle + wrap_signed(angle_of(nearest - tool_.centre) - middle);
    return std::clamp(towards, a.angle, b.angle);
  }

  // The angle, next to `near`, at which a ray from outside first meets the circle; far from it
  // where it does not.
  double meet_circle(Vec2 from, Vec2 direction, double near) const {
    const Vec2 to_centre = tool_.centre - from;
    const double along = dot(to_centre, direction), off = cross(to_centre, direction);
    const double square = (radius_ - off) * (radius_ + off);
    if (along < 0 || square < 0) return near + kPi;
    const Vec2 at = from + (along - std::sqrt(square)) * direction;
    return near + wrap_signed(angle_of(at - tool_.centre) - near);
  }

  // Where rows and columns near the gap meet the stock's border outside of the circle.
  void collect_border(double from, double to) {
    border_count_ = 0;
    const Vec2 a = tool_.centre + radius_ * unit(from), b = tool_.centre + radius_ * unit(to);
    const double reach = kReach * stock_.resolution();
    const Vec2 low{std::min(a.x, b.x) - reach, std::min(a.y, b.y) - reach};
    const Vec2 high{std::max(a.x, b.x) + reach, std::max(a.y, b.y) + reach};
    const double outside = (radius_ + kOutside) * (radius_ + kOutside);
    const auto keep = [&](Vec2 p) {
      if (border_count_ < kMostBorder && squared_norm(p - tool_.centre) > outside)
        border_[static_cast<std::size_t>(border_count_++)] = p;
    };
    const int last_row = std::min(stock_.row_count(), stock_.row_from(high.y));
    for (int j = std::max(0, stock_.row_from(low.y)); j < last_row; ++j)
      visit_borders(stock_.row(j), tip_ + kThinnest, low.x, high.x, [&](double x) {
        keep({x, stock_.row_y(j)});
      });
    const int last_column = std::min(stock_.column_count(), stock_.column_from(high.x));
    for (int i = std::max(0, stock_.column_from(low.x)); i < last_column; ++i)
      visit_borders(stock_.column(i), tip_ + kThinnest, low.y, high.y, [&](double y) {
        keep({stock_.column_x(i), y});
      });
  }

  static constexpr int kMostBorder = 64;  // about sixteen where there is one border

  const DexelStock& stock_;
  const ToolCircle& tool_;
  double radius_;
  double tip_;         // mm: the lowest that can touch
  double low_, high_;  // rad
  bool has_last_ = false, open_ = false;
  Look last_;
  int last_side_ = 0, last_quarter_ = 0;
  double last_d_ = 0;
  EngagedArc arc_;
  double sum_ = 0;
  int looks_ = 0;
  std::array<Vec2, kMostBorder> border_;
  int border_count_ = 0;
};

}  // namespace

void find_engaged_arcs(const DexelStock& stock, const ToolCircle& tool, double low, double high,
                       std::vector<EngagedArc>& arcs) {
  Finder(stock, tool, low, high).find(arcs);
  // Sums of angles round.
  for (EngagedArc& arc : arcs) {
    arc.low = std::max(arc.low, low);
    arc.high = std::min(arc.high, high);
  }
}

}  // namespace evenload
