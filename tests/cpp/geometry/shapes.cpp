#include "geometry/shapes.h"

#include <algorithm>
#include <cmath>

#include "support/errors.h"

namespace evenload::shapes {

namespace {

double between(std::mt19937& random, double low, double high) {
  // Not std::uniform_real_distribution: its results differ between libraries.
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}
int between(std::mt19937& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

using V = std::vector<Vertex>;
Curve chain(V vertices) { return Curve(std::move(vertices), true); }

Curve gear(std::mt19937& random) {
  const int teeth = between(random, 5, 16);
  const double outer = between(random, 15.0, 40.0), inner = outer * between(random, 0.6, 0.9);
  std::vector<Vec2> points;
  const double pitch = 2 * kPi / teeth;
  for (int i = 0; i < teeth; ++i) {
    points.push_back(inner * unit(pitch * i));
    points.push_back(outer * unit(pitch * (i + 0.1)));
    points.push_back(outer * unit(pitch * (i + 0.4)));
    points.push_back(inner * unit(pitch * (i + 0.5)));
  }
  return filleted(points, between(random, 0.0, 2.0));
}

Curve star(std::mt19937& random) {
  const int tips = between(random, 3, 9);
  const double outer = between(random, 15.0, 40.0);
  std::vector<Vec2> points;
  for (int i = 0; i < 2 * tips; ++i) {
    const double r = i % 2 ? outer * between(random, 0.25, 0.7) : outer * between(random, 0.8, 1.0);
    points.push_back(r * unit(kPi * i / tips));
  }
  return filleted(points, between(random, 0.0, 4.0));
}

Curve comb(std::mt19937& random) {
  const int teeth = between(random, 2, 6);
  const double height = between(random, 15.0, 40.0), base = between(random, 3.0, 12.0);
  std::vector<Vec2> points{{0, 0}};
  double x = 0;
  std::vector<double> xs{0};
  for (int i = 0; i < 2 * teeth - 1; ++i)
    xs.push_back(x += static_cast<double>(between(random, 3, 12)));
  points.push_back({x, 0});
  for (int i = 2 * teeth - 1; i > 0; i -= 2) {
    points.push_back({xs[i], height});
    points.push_back({xs[i - 1], height});
    if (i > 1) {
      points.push_back({xs[i - 1], base});
      points.push_back({xs[i - 2], base});
    }
  }
  return filleted(points, between(random, 0, 1) ? between(random, 0.5, 3.0) : 0.0);
}

// A skyline above a skyline turned over: all sides along the axes, many of them in line.
Curve rectilinear(std::mt19937& random) {
  const int n = between(random, 2, 8);
  std::vector<Vec2> up, down;
  double x = 0;
  for (int i = 0; i < n; ++i) {
    const double width = between(random, 3, 14), top = between(random, 4, 25),
                 bottom = -between(random, 4, 25);
    up.push_back({x, top});
    down.push_back({x, bottom});
    x += width;
    up.push_back({x, top});
    down.push_back({x, bottom});
  }
  std::vector<Vec2> points = down;
  points.insert(points.end(), up.rbegin(), up.rend());
  return polygon(points);
}

// Convex and concave arcs at random, on a rough circle.
Curve scallops(std::mt19937& random) {
  const int n = between(random, 3, 12);
  const double radius = between(random, 12.0, 35.0);
  V vertices;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * (i + between(random, -0.2, 0.2)) / n;
    vertices.push_back(
        {radius * between(random, 0.8, 1.2) * unit(angle), between(random, -0.45, 0.95)});
  }
  return chain(vertices);
}

}  // namespace

Curve polygon(const std::vector<Vec2>& points) {
  V vertices;
  for (const Vec2 p : points) vertices.push_back({p});
  return chain(vertices);
}

Curve rectangle(double x0, double y0, double x1, double y1) {
  return polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

Curve circle(Vec2 centre, double radius) {
  return chain({{centre + Vec2{radius, 0}, 1}, {centre - Vec2{radius, 0}, 1}});
}

Curve slot(Vec2 c, double length, double r) {
  const double h = length / 2;
  return chain({{c + Vec2{-h, -r}}, {c + Vec2{h, -r}, 1}, {c + Vec2{h, r}}, {c + Vec2{-h, r}, 1}});
}

Curve wavy_polygon(std::mt19937& random, Vec2 centre, double radius, int n) {
  double amplitude[5], phase[5];
  for (int k = 0; k < 5; ++k) {
    amplitude[k] = between(random, 0.0, 0.5) / (k + 2);
    phase[k] = between(random, 0.0, 2 * kPi);
  }
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * i / n;
    double r = 1;
    for (int k = 0; k < 5; ++k) r += amplitude[k] * std::cos((k + 1) * angle + phase[k]);
    points.push_back(centre + radius * r * unit(angle));
  }
  return polygon(points);
}

Curve wavy_arcs(std::mt19937& random, Vec2 centre, double radius, int n) {
  // Each arc passes three points of the curve, so that the chain has the tiny tangent breaks of a
  // spline turned into arcs.
  const std::vector<Vertex> fine = wavy_polygon(random, centre, radius, 2 * n).vertices();
  V vertices;
  for (int i = 0; i < n; ++i) {
    const Vec2 a = fine[2 * i].p, m = fine[2 * i + 1].p, b = fine[(2 * i + 2) % (2 * n)].p;
    const double turn = std::atan2(cross(m - a, b - m), dot(m - a, b - m));
    vertices.push_back({a, std::tan(turn / 2)});
  }
  return chain(vertices);
}

Vec2 moved(Vec2 p, double angle, bool mirrored, double scale, Vec2 shift) {
  if (mirrored) p.x = -p.x;
  return scale * rotated(p, angle) + shift;
}

Curve moved(const Curve& curve, double angle, bool mirrored, double scale, Vec2 shift) {
  V vertices = curve.vertices();
  for (Vertex& v : vertices) {
    v.p = moved(v.p, angle, mirrored, scale, shift);
    if (mirrored) v.bulge = -v.bulge;
  }
  return Curve(std::move(vertices), curve.closed());
}

Region moved(const Region& region, double angle, bool mirrored, double scale, Vec2 shift) {
  std::vector<Curve> islands;
  for (const Curve& island : region.islands)
    islands.push_back(moved(island, angle, mirrored, scale, shift));
  return make_region(moved(region.outer, angle, mirrored, scale, shift), islands);
}

Curve filleted(const std::vector<Vec2>& points, double radius) {
  V vertices;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 p = points[i], before = points[(i + n - 1) % n], after = points[(i + 1) % n];
    const Vec2 u = normalized(p - before), v = normalized(after - p);
    const double turn = std::atan2(cross(u, v), dot(u, v));
    const double cut = radius * std::tan(std::abs(turn) / 2);
    if (cut > 0.45 * std::min(distance(p, before), distance(p, after)) || std::abs(turn) < 1e-3) {
      vertices.push_back({p});
      continue;
    }
    vertices.push_back({p - cut * u, std::tan(turn / 4)});
    vertices.push_back({p + cut * v});
  }
  return chain(vertices);
}

Curve ellipse(double a, double b) {
  constexpr int kPieces = 120;
  const auto place = [&](int i) {
    const double t = 2 * kPi * i / kPieces;
    return Vec2{a * std::cos(t), b * std::sin(t)};
  };
  const auto heading = [&](int i) {
    const double t = 2 * kPi * i / kPieces;
    return angle_of({-a * std::sin(t), b * std::cos(t)});
  };
  std::vector<Vertex> vertices;
  for (int i = 0; i < kPieces; ++i)
    vertices.push_back({place(i), std::tan(wrap_signed(heading(i + 1) - heading(i)) / 4)});
  return Curve(std::move(vertices), true);
}

std::vector<Named> pockets() {
  const Curve hexagon = chain({{{23.989637028918157, -1.75}, 0.26794919243112264},
                               {{23.989637028918157, 1.75}},
                               {{13.510362971081848, 19.900635094610966}, 0.26794919243112264},
                               {{10.479274057836314, 21.650635094610966}},
                               {{-10.479274057836305, 21.65063509461097}, 0.26794919243112264},
                               {{-13.51036297108184, 19.90063509461097}},
                               {{-23.989637028918153, 1.7500000000000024}, 0.26794919243112264},
                               {{-23.989637028918157, -1.749999999999997}},
                               {{-13.510362971081856, -19.90063509461096}, 0.26794919243112264},
                               {{-10.47927405783632, -21.65063509461096}},
                               {{10.479274057836314, -21.650635094610966}, 0.26794919243112275},
                               {{13.510362971081848, -19.900635094610966}}});
  const double q = 0.41421356237309503;
  const Curve square35 = chain({{{-17.5, -14}, q},
                                {{-14, -17.5}},
                                {{14, -17.5}, q},
                                {{17.5, -14}},
                                {{17.5, 14}, q},
                                {{14, 17.5}},
                                {{-14, 17.5}, q},
                                {{-17.5, 14}}});
  const double tip = 0.6216258085253141, foot = -0.2468481091593279;
  const Curve star5 = chain({{{2.8695554452784684, 18.10808257379923}, tip},
                             {{-2.869555445278466, 18.10808257379923}},
                             {{-6.797957263002007, 10.148271084947396}, foot},
                             {{-7.5508950231666825, 9.601229781246657}},
                             {{-16.335068530530265, 8.324814655951128}, tip},
                             {{-18.108551328314693, 2.8665958457464775}},
                             {{-11.752263665771135, -3.329253323701394}, foot},
                             {{-11.464667032801446, -4.214384746339242}},
                             {{-12.96518300570497, -12.963064166378174}, tip},
                             {{-8.322144762642072, -16.33642890911866}},
                             {{-0.46534112719498866, -12.205862796153415}, foot},
                             {{0.4653411271949841, -12.205862796153415}},
                             {{8.322144762642067, -16.336428909118663}, tip},
                             {{12.965183005704965, -12.963064166378178}},
                             {{11.464667032801444, -4.214384746339245}, foot},
                             {{11.752263665771133, -3.329253323701398}},
                             {{18.108551328314697, 2.8665958457464704}, tip},
                             {{16.335068530530265, 8.324814655951123}},
                             {{7.550895023166687, 9.601229781246655}, foot},
                             {{6.7979572630020115, 10.148271084947392}}});
  const auto rooms = [](double low, double high) {
    return polygon({{0, 0},
                    {30, 0},
                    {30, low},
                    {45, low},
                    {45, 0},
                    {75, 0},
                    {75, 30},
                    {45, 30},
                    {45, high},
                    {30, high},
                    {30, 30},
                    {0, 30}});
  };
  return {
      {"boss_open", make_region(rectangle(-5, -5, 65, 65), {rectangle(20, 20, 40, 40)})},
      {"circle12", make_region(circle({0, 0}, 6))},
      {"comb", make_region(polygon({{0, 0},
                                    {90, 0},
                                    {90, 40},
                                    {80, 40},
                                    {80, 10},
                                    {60, 10},
                                    {60, 40},
                                    {50, 40},
                                    {50, 10},
                                    {40, 10},
                                    {40, 40},
                                    {30, 40},
                                    {30, 10},
                                    {10, 10},
                                    {10, 40},
                                    {0, 40}}))},
      {"inch_slot", make_region(rectangle(0, 0, 50.8, 10.16))},
      {"lame_hex50", make_region(hexagon)},
      {"lame_square35", make_region(square35)},
      {"lshape", make_region(polygon({{0, 0}, {80, 0}, {80, 30}, {30, 30}, {30, 80}, {0, 80}}))},
      {"ring", make_region(circle({0, 0}, 30), {circle({0, 0}, 18)})},
      {"slot875", make_region(slot({0, 0}, 16.25, 4.375))},
      {"slot9", make_region(rectangle(0, 0, 100, 9))},
      {"square60", make_region(rectangle(0, 0, 60, 60))},
      {"square_island", make_region(rectangle(0, 0, 60, 60), {rectangle(20, 20, 40, 40)})},
      {"star", make_region(star5)},
      {"too_small", make_region(rectangle(0, 0, 5, 20))},
      {"two_rooms", make_region(rooms(11, 19))},
      {"two_rooms_closed", make_region(rooms(12.5, 17.5))},
  };
}

std::vector<Named> random_regions(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::vector<Named> found;
  for (int attempt = 0; static_cast<int>(found.size()) < count && attempt < 50 * count; ++attempt) {
    Curve outer;
    std::string name;
    switch (attempt % 8) {
      case 0:
        name = "blob";
        outer = wavy_polygon(random, {0, 0}, between(random, 10.0, 40.0), between(random, 8, 60));
        break;
      case 1:
        name = "gear";
        outer = gear(random);
        break;
      case 2:
        name = "star";
        outer = star(random);
        break;
      case 3:
        name = "comb";
        outer = comb(random);
        break;
      case 4:
        name = "rectilinear";
        outer = rectilinear(random);
        break;
      case 5:
        name = "scallops";
        outer = scallops(random);
        break;
      case 6:
        name = "arc chain";
        outer = wavy_arcs(random, {0, 0}, between(random, 10.0, 40.0), between(random, 20, 400));
        break;
      default:
        name = "ring";
        outer = circle({0, 0}, between(random, 15.0, 40.0));
        break;
    }
    const Bounds box = bounds_of({Region{outer, {}}});
    std::vector<Curve> islands;
    for (int k = between(random, 0, 3); k > 0; --k) {
      const Vec2 c{between(random, box.low.x, box.high.x), between(random, box.low.y, box.high.y)};
      const double r = between(random, 1.0, 8.0);
      switch (random() % 3) {
        case 0:
          islands.push_back(circle(c, r));
          break;
        case 1:
          islands.push_back(rectangle(c.x - r, c.y - r, c.x + r, c.y + 2 * r));
          break;
        default:
          islands.push_back(wavy_polygon(random, c, r, 12));
          break;
      }
    }
    // What random islands spoil is tried again with fewer; what crosses itself is left out.
    while (true) {
      try {
        found.push_back({name + " " + std::to_string(attempt) + " of seed " + std::to_string(seed),
                         make_region(outer, islands)});
        break;
      } catch (const GeometryError&) {
        if (islands.empty()) break;
        islands.pop_back();
      }
    }
  }
  return found;
}

}  // namespace evenload::shapes
