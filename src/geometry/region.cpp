#include "geometry/region.h"

#include <algorithm>
#include <optional>

#include "geometry/box_tree.h"
#include "geometry/intersect.h"
#include "support/errors.h"

namespace evenload {

namespace {

// number: of a curve, as refusals count them.
void check_finite(const Curve& curve, int number) {
  Vec2 last;
  for (const Vertex& v : curve.vertices()) {
    if (!std::isfinite(v.p.x) || !std::isfinite(v.p.y) || !std::isfinite(v.bulge))
      throw GeometryError(Refusal::kCurveNotFinite, last, {1.0 * number});
    last = v.p;
  }
}

Curve without_zero_lengths(const Curve& curve) {
  std::vector<Vertex> kept;
  const std::vector<Vertex>& all = curve.vertices();
  for (const Vertex& v : all) {
    // Where the piece between is short, its start stands for both ends, and what follows starts
    // there.
    if (!kept.empty() &&
        Segment::from_bulge(kept.back().p, v.p, kept.back().bulge).length() <= kZeroLength) {
      kept.back().bulge = v.bulge;
      kept.back().open = v.open;
    } else {
      kept.push_back(v);
    }
  }
  while (kept.size() > 1 &&
         Segment::from_bulge(kept.back().p, kept.front().p, kept.back().bulge).length() <=
             kZeroLength)
    kept.pop_back();
  return Curve(std::move(kept), true);
}

Curve closed(const Curve& curve, int number) {
  if (curve.closed()) return curve;
  if (curve.vertices().size() < 2) return Curve(curve.vertices(), true);
  const Vec2 first = curve.vertices().front().p, last = curve.vertices().back().p;
  if (distance(first, last) > kClosingGap)
    throw GeometryError(Refusal::kCurveNotClosed, last, {1.0 * number, first.x, first.y});
  const std::vector<Vertex>& all = curve.vertices();
  return Curve(std::vector<Vertex>(all.begin(), all.end() - 1), true);
}

Curve normalised(const Curve& given, int number) {
  check_finite(given, number);
  Curve curve = without_zero_lengths(closed(given, number));
  const double area = curve.segment_count() < 2 ? 0.0 : curve.signed_area();
  if (std::abs(area) <= kZeroLength * curve.length())
    throw GeometryError(Refusal::kCurveWithoutArea, given.empty() ? Vec2{} : given.vertices()[0].p,
                        {1.0 * number});
  return (area > 0) == (number == 0) ? curve : curve.reversed();
}

struct Piece {
  Segment segment;
  std::size_t curve = 0, index = 0;
};

// A point where the two pieces meet and should not.
std::optional<Vec2> bad_meeting(const Piece& first, const Piece& second, std::size_t count) {
  const Segment& a = first.segment;
  const Segment& b = second.segment;
  const bool follows = first.curve == second.curve && (first.index + 1) % count == second.index;
  const bool leads = first.curve == second.curve && (second.index + 1) % count == first.index;
  // Neighbours share an end: there they may meet, and tangent ones seem to for a little way.
  const auto shared = [&](Vec2 p) {
    const double reach = kClosingGap;
    return (follows && distance(p, a.b) <= reach) || (leads && distance(p, a.a) <= reach);
  };
  for (const Meeting& m : meetings(a, b, kTouch))
    if (!shared(m.p)) return m.p;
  // Ends on the other piece: touches, and common stretches.
  for (const Vec2 p : {a.a, a.b})
    if (!shared(p) && b.distance_to(p) <= kTouch) return p;
  for (const Vec2 p : {b.a, b.b})
    if (!shared(p) && a.distance_to(p) <= kTouch) return p;
  return std::nullopt;
}

[[noreturn]] void refuse_crossing(Vec2 where, std::size_t one, std::size_t other) {
  const double first = 1.0 * one, second = 1.0 * other;
  if (one == 0 && other == 0) throw GeometryError(Refusal::kOutlineCrossesItself, where);
  if (one == other) throw GeometryError(Refusal::kIslandCrossesItself, where, {first});
  if (one == 0) throw GeometryError(Refusal::kOutlineCrossesIsland, where, {second});
  throw GeometryError(Refusal::kIslandsCross, where, {first, second});
}

void check_crossings(const std::vector<Curve>& curves) {
  std::vector<Piece> pieces;
  std::vector<Bounds> boxes;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (std::size_t i = 0; i < curves[c].segment_count(); ++i) {
      pieces.push_back({curves[c].segment(i), c, i});
      boxes.push_back(pieces.back().segment.bounds());
    }
  }
  const BoxTree tree(boxes);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    tree.visit(grown(boxes[i], kTouch), [&](std::size_t k) {
      if (k <= i) return;
      const std::optional<Vec2> where =
          bad_meeting(pieces[i], pieces[k], curves[pieces[i].curve].segment_count());
      if (where) refuse_crossing(*where, pieces[i].curve, pieces[k].curve);
    });
  }
}

}  // namespace

double Region::area() const {
  double sum = outer.signed_area();
  for (const Curve& island : islands) sum += island.signed_area();
  return sum;
}

bool Region::contains(Vec2 q) const {
  if (!outer.contains(q)) return false;
  return std::none_of(islands.begin(), islands.end(),
                      [q](const Curve& island) { return island.contains(q); });
}

std::vector<Curve> Region::curves() const {
  std::vector<Curve> all{outer};
  all.insert(all.end(), islands.begin(), islands.end());
  return all;
}

Region make_region(const Curve& outer, const std::vector<Curve>& islands) {
  Region region;
  region.outer = normalised(outer, 0);
  int number = 0;
  for (const Curve& island : islands) region.islands.push_back(normalised(island, ++number));
  check_crossings(region.curves());
  // Nothing crosses, so one point tells where a whole curve lies.
  for (std::size_t i = 0; i < region.islands.size(); ++i) {
    const Vec2 p = region.islands[i].vertices()[0].p;
    if (!region.outer.contains(p))
      throw GeometryError(Refusal::kIslandOutsideOutline, p, {i + 1.0});
    for (std::size_t k = 0; k < region.islands.size(); ++k)
      if (k != i && region.islands[k].contains(p))
        throw GeometryError(Refusal::kIslandInsideAnother, p, {i + 1.0, k + 1.0});
  }
  return region;
}

Bounds bounds_of(const std::vector<Region>& regions) {
  Bounds box{};
  bool any = false;
  for (const Region& region : regions) {
    for (std::size_t i = 0; i < region.outer.segment_count(); ++i) {
      const Bounds piece = region.outer.segment(i).bounds();
      box = any ? joined(box, piece) : piece;
      any = true;
    }
  }
  return box;
}

}  // namespace evenload
