// A drop cutter as it is usually written, for bench_finishing.py to be measured beside: a ball over
// triangles on one core, one place after the other, without a tree, hints or knowledge of which
// edges matter. As in OpenCamLib each triangle near the ball is asked for a contact with its face
// and, where there is none, with its corners and edges, unless it lies below what was found so far;
// near are those in the square cells, as wide as the ball's radius, that the ball reaches.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

struct Point {
  double x, y, z;
};

struct Triangle {
  Point corners[3];
  Point normal;  // upwards, of length 1
  double top;
};

class PlainDropCutter {
 public:
  PlainDropCutter(const double* corners, std::size_t count, double radius) : radius_(radius) {
    double high_x = -HUGE_VAL, high_y = -HUGE_VAL;
    for (std::size_t i = 0; i < count; ++i) {
      triangles_.push_back(triangle(corners + 9 * i));
      for (const Point& p : triangles_.back().corners) {
        low_x_ = std::min(low_x_, p.x), high_x = std::max(high_x, p.x);
        low_y_ = std::min(low_y_, p.y), high_y = std::max(high_y, p.y);
      }
    }
    columns_ = cell(high_x, low_x_) + 1, rows_ = cell(high_y, low_y_) + 1;
    cells_.resize(static_cast<std::size_t>(columns_) * rows_);
    for (std::size_t i = 0; i < count; ++i) add(i);
    asked_.assign(count, 0);
  }

  double drop(double x, double y, double floor) {
    double z = floor;
    ++place_;
    const int x0 = std::max(0, cell(x - radius_, low_x_));
    const int x1 = std::min(columns_ - 1, cell(x + radius_, low_x_));
    const int y0 = std::max(0, cell(y - radius_, low_y_));
    const int y1 = std::min(rows_ - 1, cell(y + radius_, low_y_));
    for (int row = y0; row <= y1; ++row)
      for (int column = x0; column <= x1; ++column)
        for (const std::size_t i : cells_[static_cast<std::size_t>(row) * columns_ + column]) {
          if (asked_[i] == place_) continue;  // lies in several cells
          asked_[i] = place_;
          if (triangles_[i].top > z) touch(triangles_[i], x, y, z);
        }
    return z;
  }

 private:
  static Triangle triangle(const double* c) {
    Triangle t{{{c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {c[6], c[7], c[8]}}, {}, 0};
    const Point &a = t.corners[0], &b = t.corners[1], &d = t.corners[2];
    Point n{(b.y - a.y) * (d.z - a.z) - (b.z - a.z) * (d.y - a.y),
            (b.z - a.z) * (d.x - a.x) - (b.x - a.x) * (d.z - a.z),
            (b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x)};
    const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z) * (n.z < 0 ? -1 : 1);
    t.normal = {n.x / length, n.y / length, n.z / length};
    t.top = std::max({a.z, b.z, d.z});
    return t;
  }

  int cell(double at, double low) const {
    return static_cast<int>(std::floor((at - low) / radius_));
  }

  void add(std::size_t i) {
    const Point* p = triangles_[i].corners;
    const auto [x0, x1] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [y0, y1] = std::minmax({p[0].y, p[1].y, p[2].y});
    for (int row = cell(y0, low_y_); row <= cell(y1, low_y_); ++row)
      for (int column = cell(x0, low_x_); column <= cell(x1, low_x_); ++column)
        cells_[static_cast<std::size_t>(row) * columns_ + column].push_back(i);
  }

  void touch(const Triangle& t, double x, double y, double& z) const {
    if (touches_face(t, x, y, z)) return;
    for (int k = 0; k < 3; ++k) {
      touch_corner(t.corners[k], x, y, z);
      touch_edge(t.corners[k], t.corners[(k + 1) % 3], x, y, z);
    }
  }

  bool touches_face(const Triangle& t, double x, double y, double& z) const {
    const Point n = t.normal;
    if (!(n.z > 1e-6)) return false;
    const double tx = x - radius_ * n.x, ty = y - radius_ * n.y;
    int left = 0, right = 0;
    for (int k = 0; k < 3; ++k) {
      const Point &a = t.corners[k], &b = t.corners[(k + 1) % 3];
      const double side = (b.x - a.x) * (ty - a.y) - (b.y - a.y) * (tx - a.x);
      left += side >= 0, right += side <= 0;
    }
    if (left < 3 && right < 3) return false;
    const Point& a = t.corners[0];
    const double at = a.z - (n.x * (tx - a.x) + n.y * (ty - a.y)) / n.z;
    z = std::max(z, at + radius_ * n.z - radius_);
    return true;
  }

  void touch_corner(const Point& p, double x, double y, double& z) const {
    const double square = (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y);
    if (square > radius_ * radius_) return;
    z = std::max(z, p.z + std::sqrt(radius_ * radius_ - square) - radius_);
  }

  void touch_edge(const Point& a, const Point& b, double x, double y, double& z) const {
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
    if (!(length > 1e-9)) return;
    const double ux = dx / length, uy = dy / length;
    const double aside = ux * (y - a.y) - uy * (x - a.x), next = ux * (x - a.x) + uy * (y - a.y);
    if (std::abs(aside) > radius_) return;
    // In the upright plane of the edge the ball is a disc, which rolls down a line.
    const double disc = std::sqrt(radius_ * radius_ - aside * aside), slope = (b.z - a.z) / length;
    const double along = next + disc * slope / std::sqrt(1 + slope * slope);
    if (along < 0 || along > length) return;
    const double centre = a.z + slope * next + disc * std::sqrt(1 + slope * slope);
    z = std::max(z, centre - radius_);
  }

  double radius_, low_x_ = HUGE_VAL, low_y_ = HUGE_VAL;
  int columns_ = 0, rows_ = 0;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<std::size_t>> cells_;
  std::vector<std::size_t> asked_;
  std::size_t place_ = 0;
};

}  // namespace

// corners: nine numbers for each of `triangles`; at: two for each of `places`; heights: one each,
// which are set.
extern "C" void plain_drop(const double* corners, std::size_t triangles, double radius,
                           const double* at, std::size_t places, double floor, double* heights) {
  PlainDropCutter cutter(corners, triangles, radius);
  for (std::size_t i = 0; i < places; ++i)
    heights[i] = cutter.drop(at[2 * i], at[2 * i + 1], floor);
}
