#include "strategy/places/narrow_passages.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "strategy/places/area.h"
#include "support/errors.h"

namespace evenload {
namespace {

// Of the disc's radius: no corner of 60 degrees or more is deeper.
constexpr double kCornerDepth = 1.01;
// mm along the border: ends this near are one place; above the tolerance of offsets.
constexpr double kSameEnd = 3e-6;
// A disc that just fits somewhere leaves ends without an order: another one near it does not. After
// so many of these, much smaller ones are tried.
constexpr double kOtherRadius = 0.003;
constexpr int kRadiiNearby = 5;

// A place on the region's border.
struct Place {
  std::size_t curve = 0, segment = 0;
  double t = 0;
};

// Neighbouring arcs of the opened border off the walls.
struct Mouth {
  std::size_t room = 0;
  std::vector<Segment> arcs;
  Place from, to;               // where the room's border leaves the wall, and where it comes back
  std::vector<Segment> corner;  // the wall in its place, where only a corner lies behind it
};

// One end of a mouth, on the region's border.
struct End {
  Place place;
  double along = 0;  // mm from the curve's start
  std::size_t mouth = 0;
  bool is_from = false;  // beyond it the wall belongs to a patch
};

struct Loop {
  std::vector<PassageBorder> pieces;
  std::vector<std::size_t> mouths;
};

Curve curve_of(const std::vector<PassageBorder>& pieces) {
  std::vector<Vertex> vertices;
  vertices.reserve(pieces.size());
  for (const PassageBorder& piece : pieces)
    vertices.push_back({piece.segment.a, piece.segment.bulge(), piece.segment.open});
  return Curve(std::move(vertices), true);
}

// Away from corners, where rooms leave the wall by a little without a mouth.
Vec2 middle_of_longest(const Curve& curve) {
  const std::vector<Segment> all = curve.segments();
  return std::max_element(
             all.begin(), all.end(),
             [](const Segment& a, const Segment& b) { return a.length() < b.length(); })
      ->point(0.5);
}

class Division {
 public:
  Division(const Region& region, double radius, double corner_depth)
      : curves_(region.curves()),
        walls_({region}),
        corner_depth_(corner_depth),
        opened_(offset(offset({region}, -radius), radius)),
        rooms_(opened_) {}

  // Empty where the mouths' ends have no clear order.
  std::optional<NarrowPlaces> divide() {
    find_mouths();
    std::optional<std::vector<Loop>> loops = find_loops();
    if (!loops) return std::nullopt;
    NarrowPlaces places;
    for (const std::vector<Loop>& patch : patches(std::move(*loops))) {
      if (is_corner(patch))
        fill_corner(patch.front());
      else
        places.passages.push_back(passage_of(patch));
    }
    for (std::size_t i = 0; i < opened_.size(); ++i) places.rooms.push_back(room(i));
    return places;
  }

 private:
  Place place_of(Vec2 p) const {
    const BoundaryIndex::Hit hit = walls_.nearest(p);
    return {hit.curve, hit.segment, hit.t};
  }

  bool is_off_walls(const Segment& segment) const {
    return walls_.nearest(segment.point(0.5)).distance > kShallow;
  }

  void find_mouths() {
    for (std::size_t room = 0; room < opened_.size(); ++room)
      for (const Curve& curve : opened_[room].curves()) {
        const std::vector<Segment> all = curve.segments();
        const std::size_t n = all.size();
        for (std::size_t i = 0; i < n; ++i) {
          if (!is_off_walls(all[i]) || is_off_walls(all[(i + n - 1) % n])) continue;
          Mouth mouth;
          mouth.room = room;
          for (std::size_t k = i; is_off_walls(all[k % n]); ++k) mouth.arcs.push_back(all[k % n]);
          mouth.from = place_of(mouth.arcs.front().a);
          mouth.to = place_of(mouth.arcs.back().b);
          mouths_.push_back(std::move(mouth));
        }
      }
  }

  double along(const Place& place) const {
    double length = 0;
    for (std::size_t i = 0; i < place.segment; ++i)
      length += curves_[place.curve].segment(i).length();
    return length + place.t * curves_[place.curve].segment(place.segment).length();
  }

  // The ends on every curve of the border, in its sense. At one place a patch ends before the next
  // begins.
  std::vector<std::vector<End>> ends() const {
    std::vector<std::vector<End>> result(curves_.size());
    for (std::size_t m = 0; m < mouths_.size(); ++m)
      for (const bool is_from : {true, false}) {
        const Place& place = is_from ? mouths_[m].from : mouths_[m].to;
        result[place.curve].push_back({place, along(place), m, is_from});
      }
    for (std::vector<End>& list : result) {
      std::stable_sort(list.begin(), list.end(),
                       [](const End& a, const End& b) { return a.along < b.along; });
      for (std::size_t i = 1; i < list.size(); ++i)
        if (list[i - 1].is_from && !list[i].is_from && list[i].along - list[i - 1].along < kSameEnd)
          std::swap(list[i - 1], list[i]);
    }
    return result;
  }

  // The border from one place on to another, in its sense.
  std::vector<Segment> stretch(const Place& from, const Place& to) const {
    const Curve& curve = curves_[from.curve];
    const std::size_t n = curve.segment_count();
    std::vector<Segment> pieces;
    const auto add = [&](std::size_t i, double t0, double t1) {
      const Segment whole = curve.segment(i);
      if ((t1 - t0) * whole.length() > kZeroLength) pieces.push_back(whole.part(t0, t1));
    };
    if (from.segment == to.segment && from.t < to.t) {
      add(from.segment, from.t, to.t);
      return pieces;
    }
    add(from.segment, from.t, 1);
    for (std::size_t i = (from.segment + 1) % n; i != to.segment; i = (i + 1) % n) add(i, 0, 1);
    add(to.segment, 0, to.t);
    return pieces;
  }

  // The borders of all patches: along walls from mouth to mouth, and back over the mouths; walls
  // that no room touches are loops of their own.
  std::optional<std::vector<Loop>> find_loops() const {
    const std::vector<std::vector<End>> all = ends();
    std::vector<const End*> next(mouths_.size(), nullptr);  // where the wall behind `from` ends
    std::vector<Loop> loops;
    for (std::size_t c = 0; c < all.size(); ++c) {
      const std::vector<End>& list = all[c];
      for (std::size_t i = 0; i < list.size(); ++i) {
        const End& after = list[(i + 1) % list.size()];
        if (list[i].is_from == after.is_from) return std::nullopt;
        if (list[i].is_from) next[list[i].mouth] = &after;
      }
      const Vec2 wall = middle_of_longest(curves_[c]);
      if (!list.empty() || (!rooms_.empty() && rooms_.signed_distance(wall) > -kShallow)) continue;
      Loop loop;
      for (const Segment& s : curves_[c].segments()) loop.pieces.push_back({s, false});
      loops.push_back(std::move(loop));
    }
    std::vector<char> done(mouths_.size(), 0);
    for (std::size_t first = 0; first < mouths_.size(); ++first) {
      if (done[first]) continue;
      Loop loop;
      for (std::size_t m = first; !done[m];) {
        const End& end = *next[m];
        done[m] = 1;
        for (const Segment& s : stretch(mouths_[m].from, end.place))
          loop.pieces.push_back({s, false});
        m = end.mouth;
        const std::vector<Segment>& arcs = mouths_[m].arcs;
        for (auto arc = arcs.rbegin(); arc != arcs.rend(); ++arc)
          loop.pieces.push_back({arc->reversed(), true});
        loop.mouths.push_back(m);
      }
      loops.push_back(std::move(loop));
    }
    return loops;
  }

  // The loops patch by patch, the outer one first.
  static std::vector<std::vector<Loop>> patches(std::vector<Loop> loops) {
    std::vector<std::vector<Loop>> result;
    const auto is_outer = [](const Loop& loop) { return curve_of(loop.pieces).signed_area() > 0; };
    std::stable_partition(loops.begin(), loops.end(), is_outer);
    for (Loop& loop : loops) {
      if (is_outer(loop)) {
        result.push_back({std::move(loop)});
        continue;
      }
      // The smallest patch around it.
      std::vector<Loop>* around = nullptr;
      double least = 0;
      for (std::vector<Loop>& patch : result) {
        const Curve outer = curve_of(patch.front().pieces);
        if (!outer.contains(loop.pieces.front().segment.point(0.5))) continue;
        if (around && outer.signed_area() >= least) continue;
        around = &patch;
        least = outer.signed_area();
      }
      EVENLOAD_ASSERT(around != nullptr);
      around->push_back(std::move(loop));
    }
    return result;
  }

  bool is_corner(const std::vector<Loop>& patch) const {
    if (patch.size() > 1 || patch.front().mouths.size() != 1) return false;
    double deepest = 0;
    for (const PassageBorder& piece : patch.front().pieces)
      for (const double t : {0.0, 0.5})
        deepest = std::max(deepest, -rooms_.signed_distance(piece.segment.point(t)));
    return deepest <= corner_depth_;
  }

  void fill_corner(const Loop& loop) {
    for (const PassageBorder& piece : loop.pieces)
      if (!piece.is_mouth) mouths_[loop.mouths.front()].corner.push_back(piece.segment);
  }

  Passage passage_of(const std::vector<Loop>& patch) const {
    Passage passage;
    for (const Loop& loop : patch) {
      passage.loops.push_back(loop.pieces);
      for (const std::size_t m : loop.mouths) passage.rooms.push_back(mouths_[m].room);
      if (passage.centres.outer.empty())
        passage.centres.outer = curve_of(loop.pieces);
      else
        passage.centres.islands.push_back(curve_of(loop.pieces));
    }
    return passage;
  }

  // The opened region with its corners filled.
  Region room(std::size_t index) const {
    const auto filled = [&](const Curve& curve) {
      std::vector<PassageBorder> pieces;
      for (const Segment& s : curve.segments()) {
        const Mouth* mouth = corner_at(index, s);
        if (!mouth)
          pieces.push_back({s, false});
        else if (mouth->arcs.front().a == s.a)
          for (const Segment& wall : mouth->corner) pieces.push_back({wall, false});
      }
      return curve_of(pieces);
    };
    Region result{filled(opened_[index].outer), {}};
    for (const Curve& island : opened_[index].islands) result.islands.push_back(filled(island));
    return result;
  }

  // The mouth of a corner that the piece of a room's border belongs to.
  const Mouth* corner_at(std::size_t room, const Segment& s) const {
    for (const Mouth& mouth : mouths_) {
      if (mouth.room != room || mouth.corner.empty()) continue;
      for (const Segment& arc : mouth.arcs)
        if (arc.a == s.a && arc.b == s.b) return &mouth;
    }
    return nullptr;
  }

  std::vector<Curve> curves_;
  Area walls_;
  double corner_depth_;  // mm
  std::vector<Region> opened_;
  Area rooms_;
  std::vector<Mouth> mouths_;
};

}  // namespace

NarrowPlaces find_narrow_places(const Region& centres, double radius, double corner_depth) {
  EVENLOAD_ASSERT(radius > 0);
  double smaller = radius;
  for (int i = 0; smaller > kShallow; ++i) {
    if (std::optional<NarrowPlaces> places = Division(centres, smaller, corner_depth).divide())
      return std::move(*places);
    smaller *= i < kRadiiNearby ? 1 - kOtherRadius : 0.5;
  }
  return {{centres}, {}};
}

NarrowPlaces find_narrow_places(const Region& centres, double radius) {
  return find_narrow_places(centres, radius, kCornerDepth * radius);
}

}  // namespace evenload
