// Shapes for the geometry tests: named pockets, and random ones from a seed.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "geometry/region.h"

namespace evenload::shapes {

struct Named {
  std::string name;
  Region region;
};

Curve polygon(const std::vector<Vec2>& points);
Curve rectangle(double x0, double y0, double x1, double y1);
Curve circle(Vec2 centre, double radius);
// A slot with round ends, `length` between the centres of the ends.
Curve slot(Vec2 centre, double length, double radius);
// A polygon, every corner rounded with `radius` where its sides are long enough.
Curve filleted(const std::vector<Vec2>& points, double radius);
// As arcs, nearly tangent to each other.
Curve ellipse(double a, double b);

std::vector<Named> pockets();
// Blobs, polygons, stars, gears, combs, rings, rectilinear shapes, chains of tiny arcs, with
// islands; about 20 to 100 mm across.
std::vector<Named> random_regions(unsigned seed, int count);

// The smooth closed curve r(angle) = radius * (1 + sum of waves) as a chain of `n` lines, or of
// tangent arcs.
Curve wavy_polygon(std::mt19937& random, Vec2 centre, double radius, int n);
Curve wavy_arcs(std::mt19937& random, Vec2 centre, double radius, int n);

Vec2 moved(Vec2 p, double angle, bool mirrored, double scale, Vec2 shift);
Curve moved(const Curve& curve, double angle, bool mirrored, double scale, Vec2 shift);
// Turned, mirrored first if so wanted, scaled and shifted; normalised again.
Region moved(const Region& region, double angle, bool mirrored, double scale, Vec2 shift);

}  // namespace evenload::shapes
