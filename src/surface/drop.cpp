#include "surface/drop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "support/parallel.h"

namespace evenload {

namespace {

// mm beyond a triangle's edges that still belong to it, so that nothing falls through between two.
constexpr double kSeam = 1e-9;
constexpr int kMostSteps = 60;       // bisection alone would have a double's precision by then
constexpr int kDeepest = 64;         // of the tree, whose depth is the logarithm of its size
constexpr std::size_t kAtOnce = 64;  // places that one task looks at
constexpr std::size_t kMany = 64;    // facets: the tree finds sooner what counts at one place

bool is_over(const Facet& facet, Vec2 at) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 from = plan(facet.corners[k]), side = plan(facet.corners[(k + 1) % 3]) - from;
    if (cross(side, at - from) < -kSeam * (std::abs(side.x) + std::abs(side.y))) return false;
  }
  return true;
}

// Where the tool touches a facet's plane, which is not upright, and how high its tip is then.
struct PlaneContact {
  SpacePoint point;
  double tip;
};

PlaneContact touch_plane(const Facet& facet, const Cutter& cutter, Vec2 at) {
  const SpacePoint n = facet.normal;
  const Vec2 across = plan(n);
  const double lean = norm(across);
  Vec2 touched = at;
  // A level face is touched below the axis; with the disc's other points by its border.
  if (lean > 1e-12) touched = at - (cutter.flat() / lean + cutter.corner) * across;
  const SpacePoint from = facet.corners[0];
  const double z = from.z - dot(across, touched - plan(from)) / n.z;
  return {{touched.x, touched.y, z}, z - cutter.corner * (1 - n.z)};
}

// Where along an edge that passes the axis at a distance, and rises by `slope` > 0, the tool
// touches: mm from the place next to the axis.
double touched_along(const Cutter& cutter, double aside, double slope) {
  const double corner = cutter.corner, flat = cutter.flat(), radius = cutter.radius;
  if (corner == 0) return std::sqrt(std::max(0.0, (radius - aside) * (radius + aside)));
  if (flat == 0)
    return slope *
           std::sqrt(std::max(0.0, (radius - aside) * (radius + aside)) / (1 + slope * slope));
  // The angle a of the corner's circle, 0 at the tip: sin a s = slope d cos a, where d = flat +
  // corner sin a is the distance from the axis and s that along the edge. The left side grows with
  // a, the right one falls against it.
  double low = aside > flat ? std::asin(std::min(1.0, (aside - flat) / corner)) : 0;
  double high = 0.5 * kPi, angle = 0.5 * (low + high);
  double along = 0;
  for (int i = 0; i < kMostSteps; ++i) {
    const double sine = std::sin(angle), cosine = std::cos(angle);
    const double d = flat + corner * sine;
    along = std::sqrt(std::max(0.0, (d - aside) * (d + aside)));
    const double value = sine * along - slope * d * cosine;
    (value > 0 ? high : low) = angle;
    const double growth = cosine * along +
                          (along > 0 ? sine * d * corner * cosine / along : HUGE_VAL) +
                          slope * (d * sine - corner * cosine * cosine);
    double next = angle - value / growth;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - angle) < 1e-15) break;
    angle = next;
  }
  return along;
}

SpacePoint normal_at(const Cutter& cutter, Vec2 from_axis, double distance) {
  const double beyond = distance - cutter.flat();
  if (!(beyond > 0) || cutter.corner == 0) return {0, 0, 1};
  const double sine = std::min(1.0, beyond / cutter.corner);
  const Vec2 inwards = -from_axis / distance;
  return {sine * inwards.x, sine * inwards.y, std::sqrt(1 - sine * sine)};
}

void touch_edge(const Facet& facet, std::size_t side, const Cutter& cutter, Vec2 at,
                ToolContact& best) {
  std::size_t lower = side, upper = (side + 1) % 3;
  if (facet.corners[lower].z > facet.corners[upper].z) std::swap(lower, upper);
  const SpacePoint from = facet.corners[lower], to = facet.corners[upper];
  if (to.z <= best.z) return;
  const Vec2 run = plan(to - from), start = plan(from) - at;
  const double length = norm(run);
  SpacePoint touched = to;
  bool is_within = facet.is_corner_within[upper];
  if (length > 1e-12) {
    const Vec2 u = run / length;
    const double next = -dot(start, u);  // of the place next to the axis, from the lower end
    const double aside = std::abs(cross(u, start));
    if (aside > cutter.radius) return;
    const double reach =
        std::sqrt(std::max(0.0, (cutter.radius - aside) * (cutter.radius + aside)));
    const double low = std::max(0.0, next - reach), high = std::min(length, next + reach);
    if (low > high) return;
    const double slope = (to.z - from.z) / length;
    const double wanted = next + (slope > 0 ? touched_along(cutter, aside, slope) : 0);
    const double along = std::clamp(wanted, low, high);
    const Vec2 p = plan(from) + along * u;
    touched = {p.x, p.y, from.z + slope * along};
    if (along < length)
      is_within = along > 0 ? facet.is_within[side] : facet.is_corner_within[lower];
  }
  const Vec2 from_axis = plan(touched) - at;
  const double distance = norm(from_axis);
  // A flat tool touches a rising edge with its very rim, which rounding must not take off it.
  if (distance > cutter.radius + kSeam) return;
  const double tip = touched.z - cutter.rise(std::min(distance, cutter.radius));
  // Where a level face and its border are touched at once, it is the face that counts.
  if (tip > best.z + (best.is_within ? kSeam : 0))
    best = {tip, true, is_within, touched, normal_at(cutter, from_axis, distance)};
}

// What lies no higher changes nothing: a face counts before the border of one beside it at the same
// height.
double least_that_counts(const ToolContact& best) {
  return best.is_within ? best.z : best.z - kSeam;
}

void touch_facet(const FacetMesh& mesh, std::uint32_t number, const Cutter& cutter, Vec2 at,
                 ToolContact& best) {
  const Facet& facet = mesh.facets()[number];
  if (facet.top <= least_that_counts(best)) return;
  const double before = best.z;
  if (facet.normal.z != 0) {
    const PlaneContact contact = touch_plane(facet, cutter, at);
    const double least = facet.is_picked ? least_that_counts(best) : best.z;
    const bool is_on_it = contact.tip > least && is_over(facet, plan(contact.point));
    if (is_on_it) {
      const double tip = std::max(contact.tip, best.z);
      best = {tip, true, facet.is_picked, contact.point, facet.normal, number};
    }
    // The edges of a face lift the tool no higher than its plane does.
    if (facet.normal.z > 0 && (is_on_it || contact.tip < best.z - kSeam)) return;
  }
  for (std::size_t k = 0; k < 3; ++k)
    if (facet.is_touchable[k]) touch_edge(facet, k, cutter, at, best);
  if (best.z > before) best.facet = number;
}

// A tool as low as it may be. What lies just as low is touched, too, whatever rounding says.
ToolContact untouched(double floor) {
  ToolContact result;
  result.z = floor - kSeam;
  return result;
}

// A leaf of one facet.
FacetNode leaf_of(const FacetMesh& mesh, std::uint32_t number) {
  const Facet& facet = mesh.facets()[number];
  const auto& [a, b, c] = facet.corners;
  return {std::min({a.x, b.x, c.x}),
          std::min({a.y, b.y, c.y}),
          std::max({a.x, b.x, c.x}),
          std::max({a.y, b.y, c.y}),
          facet.top,
          number,
          1};
}

// The highest that the tip could be lifted, over a place no farther than `half` from `middle` along
// x and y, by what lies in a box; any number that is not above `least` where that cannot be.
double highest_by(const FacetNode& box, const Cutter& cutter, Vec2 middle, double half,
                  double least) {
  if (!(box.top > least)) return -HUGE_VAL;
  const double dx = std::max(std::max(box.x0 - middle.x, middle.x - box.x1) - half, 0.0);
  const double dy = std::max(std::max(box.y0 - middle.y, middle.y - box.y1) - half, 0.0);
  const double squared = dx * dx + dy * dy;
  if (squared > cutter.radius * cutter.radius) return -HUGE_VAL;
  return box.top - cutter.rise(std::sqrt(squared));
}

// Calls look(leaf, highest) for the facets, each as a leaf, that may lift the tip above least()
// over a place no farther than `half` from `middle`, what may lift it more mostly before what may
// not, as long as it answers true.
template <typename Least, typename Look>
void each_above(const FacetMesh& mesh, const Cutter& cutter, Vec2 middle, double half,
                const Least& least, const Look& look) {
  const std::vector<FacetNode>& nodes = mesh.nodes();
  if (nodes.empty()) return;
  struct Waiting {
    std::uint32_t node;
    double highest;
  };
  const auto waiting = [&](std::uint32_t number) -> Waiting {
    return {number, highest_by(nodes[number], cutter, middle, half, least())};
  };
  std::array<Waiting, 2 * kDeepest> stack;
  std::size_t size = 0;
  stack[size++] = waiting(0);
  while (size > 0) {
    const Waiting next = stack[--size];
    if (!(next.highest > least())) continue;
    const FacetNode& node = nodes[next.node];
    if (node.count == 0) {
      Waiting lower = waiting(next.node + 1), higher = waiting(node.first);
      if (lower.highest > higher.highest) std::swap(lower, higher);
      stack[size++] = lower;  // what may be higher is looked at before
      stack[size++] = higher;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const FacetNode leaf = leaf_of(mesh, i);
      const double highest = highest_by(leaf, cutter, middle, half, least());
      if (highest > least() && !look(leaf, highest)) return;
    }
  }
}

}  // namespace

ToolContact drop(const FacetMesh& mesh, const Cutter& cutter, Vec2 at, double floor,
                 std::uint32_t first) {
  ToolContact best = untouched(floor);
  if (first != kNoFacet) touch_facet(mesh, first, cutter, at, best);
  each_above(
      mesh, cutter, at, 0, [&] { return least_that_counts(best); },
      [&](const FacetNode& leaf, double) {
        touch_facet(mesh, leaf.first, cutter, at, best);
        return true;
      });
  best.z = std::max(best.z, floor);
  return best;
}

DropWindow::DropWindow(const FacetMesh& mesh, const Cutter& cutter, Vec2 middle, double half,
                       double floor)
    : mesh_(mesh), cutter_(cutter), floor_(floor) {
  // Where the tool reaches from all of the window what it touches in the middle, it is nowhere
  // lower than that allows.
  const ToolContact contact = evenload::drop(mesh, cutter, middle, floor);
  double least = floor - kSeam;
  if (contact.touches) {
    const Vec2 from = plan(contact.point) - middle;
    const double farthest = std::hypot(std::abs(from.x) + half, std::abs(from.y) + half);
    // Less a little, for what touches at just that height must be found, too.
    if (farthest <= cutter.radius)
      least = std::max(least, contact.point.z - cutter.rise(farthest) - kSeam);
  }
  each_above(
      mesh, cutter, middle, half, [&] { return least; },
      [&](const FacetNode& leaf, double highest) {
        above_.emplace_back(highest, leaf);
        return above_.size() <= kMany;
      });
  is_worth_it_ = above_.size() <= kMany;
  if (!is_worth_it_) return;
  std::sort(above_.begin(), above_.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second.first < b.second.first;
  });
}

ToolContact DropWindow::drop(Vec2 at, std::uint32_t first) const {
  if (!is_worth_it_) return evenload::drop(mesh_, cutter_, at, floor_, first);
  ToolContact best = untouched(floor_);
  if (first != kNoFacet) touch_facet(mesh_, first, cutter_, at, best);
  for (const auto& [highest, leaf] : above_) {
    const double least = least_that_counts(best);
    if (!(highest > least)) break;
    if (highest_by(leaf, cutter_, at, 0, least) > least)
      touch_facet(mesh_, leaf.first, cutter_, at, best);
  }
  best.z = std::max(best.z, floor_);
  return best;
}

std::vector<ToolContact> drop_all(const FacetMesh& mesh, const Cutter& cutter,
                                  const std::vector<Vec2>& places, double floor, int threads,
                                  Progress& progress) {
  std::vector<ToolContact> result(places.size());
  const std::size_t tasks = (places.size() + kAtOnce - 1) / kAtOnce;
  parallel_for(
      tasks, thread_count(threads),
      [&](std::size_t task) {
        const std::size_t end = std::min(places.size(), (task + 1) * kAtOnce);
        std::uint32_t last = kNoFacet;
        for (std::size_t i = task * kAtOnce; i < end; ++i) {
          result[i] = drop(mesh, cutter, places[i], floor, last);
          last = result[i].facet;
        }
      },
      progress);
  return result;
}

bool is_under_picked(const FacetMesh& mesh, Vec2 at) {
  const std::vector<FacetNode>& nodes = mesh.nodes();
  if (nodes.empty()) return false;
  std::array<std::uint32_t, 2 * kDeepest> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const std::uint32_t number = stack[--size];
    const FacetNode& node = nodes[number];
    if (at.x < node.x0 || at.x > node.x1 || at.y < node.y0 || at.y > node.y1) continue;
    if (node.count == 0) {
      stack[size++] = number + 1;
      stack[size++] = node.first;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Facet& facet = mesh.facets()[i];
      if (facet.is_picked && facet.normal.z > 0 && is_over(facet, at)) return true;
    }
  }
  return false;
}

}  // namespace evenload
