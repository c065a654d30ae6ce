#include "surface/extension.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "surface/contours.h"

namespace evenload {

namespace {

constexpr double kOnePoint = 1e-6;         // mm: corners nearer than this are one
constexpr double kSteepestSkirt = 1;       // rise over run
constexpr double kWedge = 15 * kPi / 180;  // rad between the rays of a skirt round a corner
// Of the extension, and mm: skirts are wider, so that the tool does not come to their edges.
constexpr double kWider = 1.02, kBeyond = 1;
constexpr int kLooks = 16;            // along a skirt's width for picked ground below it
constexpr double kLeastWidth = 1e-3;  // mm: narrower skirts are none

using WeldedPoint = std::array<std::int64_t, 3>;

WeldedPoint welded_at(SpacePoint p) {
  return {std::llround(p.x / kOnePoint), std::llround(p.y / kOnePoint),
          std::llround(p.z / kOnePoint)};
}

struct Side {
  std::size_t facet;
  std::size_t number;  // of its corner where it begins
};

// A skirt's side on the border, with the face to its left.
struct Hem {
  SpacePoint from, to;
  Vec2 out;             // of length 1
  double slope, width;  // rise over run outwards; mm
};

std::vector<Curve> curves_of(const std::vector<Region>& regions) {
  std::vector<Curve> curves;
  for (const Region& region : regions)
    for (const Curve& curve : region.curves()) curves.push_back(curve);
  return curves;
}

class Making {
 public:
  Making(const FacetMesh& part, const std::vector<Region>& picked, double extension)
      : facets_(part.facets()), picked_(curves_of(picked)), extension_(extension) {
    for (std::size_t i = 0; i < facets_.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        WeldedPoint a = welded_at(facets_[i].corners[k]),
                    b = welded_at(facets_[i].corners[(k + 1) % 3]);
        if (b < a) std::swap(a, b);
        sides_[{a, b}].push_back({i, k});
      }
  }

  // Which facets are picked or go on beside those that are.
  const std::vector<bool>& own() {
    is_own_.resize(facets_.size());
    std::vector<std::size_t> waiting;
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      is_own_[i] = facets_[i].is_picked && facets_[i].normal.z > 0;
      if (is_own_[i]) waiting.push_back(i);
    }
    while (!waiting.empty()) {
      const std::size_t i = waiting.back();
      waiting.pop_back();
      for (std::size_t k = 0; k < 3; ++k)
        for (const Side& other : others({i, k})) {
          if (is_own_[other.facet] || !goes_on({i, k}, other) || !is_near({i, k})) continue;
          is_own_[other.facet] = true;
          waiting.push_back(other.facet);
        }
    }
    return is_own_;
  }

  // Triangles, after `own`.
  std::vector<std::array<SpacePoint, 3>> skirts() {
    std::vector<std::array<SpacePoint, 3>> triangles;
    std::vector<Hem> hems;
    for (std::size_t i = 0; i < facets_.size(); ++i)
      for (std::size_t k = 0; k < 3 && is_own_[i]; ++k)
        if (falls_away({i, k}) && is_near({i, k})) hems.push_back(hem_of({i, k}));
    std::map<WeldedPoint, std::vector<std::size_t>> beginning;
    for (std::size_t n = 0; n < hems.size(); ++n) beginning[welded_at(hems[n].from)].push_back(n);
    for (const Hem& hem : hems) {
      if (hem.width < kLeastWidth) continue;
      const SpacePoint from = beyond(hem, hem.from), to = beyond(hem, hem.to);
      triangles.push_back({hem.from, from, to});
      triangles.push_back({hem.from, to, hem.to});
      for (const std::size_t next : beginning[welded_at(hem.to)])
        add_wedge(hem, hems[next], triangles);
    }
    return triangles;
  }

 private:
  std::vector<Side> others(const Side& side) const {
    WeldedPoint a = welded_at(at(side)), b = welded_at(end(side));
    if (b < a) std::swap(a, b);
    std::vector<Side> found;
    for (const Side& each : sides_.at({a, b}))
      if (each.facet != side.facet) found.push_back(each);
    return found;
  }

  SpacePoint at(const Side& side) const { return facets_[side.facet].corners[side.number]; }
  SpacePoint end(const Side& side) const {
    return facets_[side.facet].corners[(side.number + 1) % 3];
  }
  SpacePoint opposite(const Side& side) const {
    return facets_[side.facet].corners[(side.number + 2) % 3];
  }

  // Whether the ground goes on over a side, bent by little.
  bool goes_on(const Side& mine, const Side& other) const {
    const Facet &a = facets_[mine.facet], &b = facets_[other.facet];
    if (!(b.normal.z > 0) || dot(a.normal, b.normal) < std::cos(kGoesOn)) return false;
    const Vec2 along = plan(end(mine) - at(mine));
    return cross(along, plan(opposite(other) - at(mine))) < 0;
  }

  // Whether the ground ends at a side, or falls away there.
  bool falls_away(const Side& mine) const {
    for (const Side& other : others(mine)) {
      if (is_own_[other.facet]) return false;
      if (dot(facets_[mine.facet].normal, opposite(other) - at(mine)) > kOnePoint) return false;
    }
    return norm(plan(end(mine) - at(mine))) > kOnePoint;
  }

  bool is_near(const Side& side) const {
    for (int k = 0; k <= kLooks; ++k) {
      const SpacePoint p = at(side) + (static_cast<double>(k) / kLooks) * (end(side) - at(side));
      if (picked_.contains(plan(p)) || picked_.nearest(plan(p)).distance < extension_) return true;
    }
    return false;
  }

  Hem hem_of(const Side& side) const {
    const SpacePoint from = at(side), to = end(side), n = facets_[side.facet].normal;
    const Vec2 out = -left_normal(normalized(plan(to - from)));
    const double slope = std::clamp(-dot(plan(n), out) / n.z, -kSteepestSkirt, kSteepestSkirt);
    Hem hem{from, to, out, slope, kWider * extension_ + kBeyond};
    // A skirt over picked ground would keep the tool from it.
    const double step = hem.width / kLooks;
    for (int k = 1; k * step <= hem.width; ++k)
      for (const double share : {0.02, 0.5, 0.98})
        if (picked_.contains(plan(from + share * (to - from)) + (k * step) * out))
          hem.width = std::min(hem.width, (k - 1) * step);
    return hem;
  }

  static SpacePoint beyond(const Hem& hem, SpacePoint p) {
    return {p.x + hem.width * hem.out.x, p.y + hem.width * hem.out.y, p.z + hem.slope * hem.width};
  }

  // Between two skirts that part at a corner.
  static void add_wedge(const Hem& one, const Hem& other,
                        std::vector<std::array<SpacePoint, 3>>& triangles) {
    const double turn = std::atan2(cross(one.out, other.out), dot(one.out, other.out));
    if (!(turn > 0) || other.width < kLeastWidth) return;
    const int rays = std::max(1, static_cast<int>(std::ceil(turn / kWedge)));
    SpacePoint before = beyond(one, one.to);
    for (int k = 1; k <= rays; ++k) {
      const double share = static_cast<double>(k) / rays;
      const Hem between{one.to, one.to, rotated(one.out, share * turn),
                        one.slope + share * (other.slope - one.slope),
                        one.width + share * (other.width - one.width)};
      const SpacePoint next = k < rays ? beyond(between, one.to) : beyond(other, other.from);
      triangles.push_back({one.to, before, next});
      before = next;
    }
  }

  const std::vector<Facet>& facets_;
  BoundaryIndex picked_;
  double extension_;
  std::map<std::pair<WeldedPoint, WeldedPoint>, std::vector<Side>> sides_;
  std::vector<bool> is_own_;
};

FacetMesh mesh_of(const std::vector<std::array<SpacePoint, 3>>& triangles,
                  const std::vector<bool>& picked) {
  std::vector<SpacePoint> points;
  std::vector<FacetMesh::Triangle> numbers;
  for (const auto& triangle : triangles) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), triangle.begin(), triangle.end());
    numbers.push_back({first, first + 1, first + 2});
  }
  return FacetMesh(points, numbers, picked);
}

}  // namespace

Extension::Extension(const FacetMesh& part, double extension)
    : width_(extension),
      regions_(covered_by_picked(part)),
      limit_({}),
      ground_({}, {}, {}),
      own_({}, {}, {}) {
  Making making(part, regions_, extension);
  const std::vector<bool>& is_own = making.own();
  std::vector<std::array<SpacePoint, 3>> all, own;
  std::vector<bool> picked;
  for (std::size_t i = 0; i < part.facets().size(); ++i) {
    all.push_back(part.facets()[i].corners);
    picked.push_back(part.facets()[i].is_picked);
    if (is_own[i]) own.push_back(part.facets()[i].corners);
  }
  for (const auto& skirt : making.skirts()) {
    all.push_back(skirt);
    picked.push_back(false);
    own.push_back(skirt);
  }
  ground_ = mesh_of(all, picked);
  own_ = mesh_of(own, std::vector<bool>(own.size(), true));
  regions_ = offset(regions_, extension);
  limit_ = BoundaryIndex(curves_of(regions_));
}

}  // namespace evenload
