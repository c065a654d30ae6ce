#include "geometry/sharp_tips.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/box_tree.h"
#include "geometry/intersect.h"

namespace evenload {
namespace {

// mm: what is to be had at a tip must be more.
constexpr double kWorthIt = 0.02;
// Share of the lines at a tip that it may be lengthened by.
constexpr double kMostOfLine = 0.25;
constexpr double kOwn = 1e-6;  // mm: of a tip, what meets its axis there is the tip itself

struct Tip {
  Vec2 axis;           // unit vector, from the tip on
  double missing = 0;  // mm: to where it would be as near as the gap to where its walls meet
};

bool is_wall(const Segment& piece) { return !piece.is_arc() && !piece.open; }

std::optional<Tip> tip_between(const Segment& in, const Segment& out, double gap) {
  if (!is_wall(in) || !is_wall(out)) return std::nullopt;
  const Vec2 u = in.tangent(1), v = out.tangent(0);
  if (cross(u, v) <= 0 || dot(u, v) >= 0) return std::nullopt;
  const double sine = 0.5 * norm(u + v);  // of half the angle between them
  const double missing = gap / sine - gap;
  const double most = kMostOfLine * std::min(in.length(), out.length());
  if (missing <= kWorthIt || missing >= most) return std::nullopt;
  return Tip{normalized(u - v), missing};
}

// The border of regions, to be met by lines.
class Border {
 public:
  explicit Border(const std::vector<Region>& regions) {
    std::vector<Bounds> boxes;
    for (const Region& region : regions)
      for (const Curve& curve : region.curves())
        for (const Segment& piece : curve.segments()) {
          pieces_.push_back(piece);
          boxes.push_back(piece.bounds());
        }
    tree_ = BoxTree(boxes);
  }

  bool contains(Vec2 q) const {
    int winding = 0;
    for (const Segment& piece : pieces_) winding += winding_of(piece, q);
    return winding != 0;
  }

  // mm along `line` to where it meets the border first beyond `from` mm; infinity where it does
  // not.
  double first_met(const Segment& line, double from) const {
    double first = std::numeric_limits<double>::infinity();
    tree_.visit(grown(line.bounds(), kTouch), [&](std::size_t i) {
      for (const Meeting& meeting : meetings(line, pieces_[i], kTouch)) {
        const double at = distance(line.a, meeting.p);
        if (at > from) first = std::min(first, at);
      }
    });
    return first;
  }

  bool is_met(const Segment& line) const {
    return first_met(line, -1) < std::numeric_limits<double>::infinity();
  }

 private:
  std::vector<Segment> pieces_;
  BoxTree tree_;
};

class Tips {
 public:
  Tips(const std::vector<Region>& regions, const std::vector<Region>& shrunk, double distance,
       double gap)
      : regions_(regions), shrunk_(shrunk), distance_(distance), gap_(gap) {}

  void lengthen(Curve& curve) {
    const std::vector<Segment> pieces = curve.segments();
    std::vector<Vertex> vertices = curve.vertices();
    bool changed = false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Segment& before = pieces[(i + pieces.size() - 1) % pieces.size()];
      const std::optional<Tip> tip = tip_between(before, pieces[i], gap_);
      if (!tip) continue;
      const double more = length_at(before, pieces[i], *tip);
      vertices[i].p = vertices[i].p + more * tip->axis;
      changed |= more > 0;
    }
    if (changed) curve = Curve(std::move(vertices), true);
  }

 private:
  // mm: how far the tip between two pieces may be lengthened. 0 where its room goes on without the
  // gap, leads to another one, or is too narrow for the lengthened sides.
  double length_at(const Segment& before, const Segment& after, const Tip& tip) {
    if (!borders_) borders_.emplace(Borders{Border(offset(regions_, -distance_)), Border(shrunk_)});
    const Vec2 p = after.a;
    const Segment axis = Segment::line(p, p + (tip.missing + 2 * gap_) * tip.axis);
    if (borders_->whole.contains(axis.b)) return 0;
    const double end = borders_->whole.first_met(axis, 0);
    const double length = std::min(tip.missing, end - gap_);
    if (length <= kWorthIt || borders_->shrunk.first_met(axis, kOwn) < end) return 0;
    const Vec2 lengthened = p + length * tip.axis;
    const bool is_free = !borders_->whole.is_met(Segment::line(before.a, lengthened)) &&
                         !borders_->whole.is_met(Segment::line(lengthened, after.b));
    return is_free ? length : 0;
  }

  struct Borders {
    Border whole, shrunk;  // without the gap and with it
  };

  const std::vector<Region>&regions_, &shrunk_;
  double distance_, gap_;           // mm
  std::optional<Borders> borders_;  // few regions have tips that ask for them
};

}  // namespace

std::vector<Region> shrunk_to_tips(const std::vector<Region>& regions, double distance,
                                   double gap) {
  const std::vector<Region> shrunk = offset(regions, -(distance + gap));
  std::vector<Region> result = shrunk;
  Tips tips(regions, shrunk, distance, gap);
  for (Region& region : result) {
    tips.lengthen(region.outer);
    for (Curve& island : region.islands) tips.lengthen(island);
  }
  return result;
}

}  // namespace evenload
