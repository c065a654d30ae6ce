#include "inspection/starts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "support/solvers.h"

namespace evenload {

namespace {

constexpr int kDirections = 96;   // over a half sphere, about 15 degrees apart
constexpr std::size_t kAxes = 6;  // of these the best circles are tried
constexpr Eigen::Index kSample = 300;

// Evenly spread over the half sphere, along a spiral of the golden section.
Eigen::Vector3d direction(int i) {
  const double z = (i + 0.5) / kDirections, round = std::sqrt(1 - z * z);
  const double turn = i * (3 - std::sqrt(5.0)) * M_PI;
  return {round * std::cos(turn), round * std::sin(turn), z};
}

// |p|^2 = 2 p.c + e by least squares, in the first `size` coordinates; c, and the mean square of
// what is left over (2 R)^2, about that of the distances.
struct Algebraic {
  Eigen::Vector3d centre;
  double radius, left;
};

Algebraic algebraic(const Points& points, int size) {
  const Eigen::Index count = points.cols();
  Eigen::MatrixXd matrix(count, size + 1);
  matrix << 2 * points.topRows(size).transpose(), Eigen::VectorXd::Ones(count);
  const Eigen::VectorXd squares = points.topRows(size).colwise().squaredNorm().transpose();
  const Eigen::VectorXd found =
      least_squares(matrix.transpose() * matrix, matrix.transpose() * squares);
  Algebraic result{Eigen::Vector3d::Zero(), 0, 0};
  result.centre.head(size) = found.head(size);
  const double square = found[size] + found.head(size).squaredNorm();
  result.radius = std::sqrt(std::max(square, 1e-12));
  result.left = (matrix * found - squares).squaredNorm() /
                (4 * result.radius * result.radius * static_cast<double>(count));
  return result;
}

// The frame on a circle, sphere or cylinder about `centre`, where its surface is nearest to the
// points' middle, the origin.
Frame frame_about(const Eigen::Vector3d& centre, double radius, const Eigen::Vector3d& axis) {
  const Eigen::Vector3d normal = centre.norm() > 1e-9 * radius ? -centre : axis.unitOrthogonal();
  Frame frame = frame_of(Eigen::Vector3d::Zero(), axis, normal, 1 / radius);
  frame.origin = centre + radius * frame.axes.col(1);
  return frame;
}

Points sample_of(const Points& points) {
  const Eigen::Index stride = std::max<Eigen::Index>(1, points.cols() / kSample);
  Points result(3, (points.cols() + stride - 1) / stride);
  for (Eigen::Index i = 0; i < result.cols(); ++i) result.col(i) = points.col(i * stride);
  return result;
}

// z = c + x^2 a + 2 x y b + y^2 d + ... over the plane through the points: (a, b; b, d) in the
// frame of the first two columns of `base`, whose third is the plane's normal.
Eigen::Matrix2d paraboloid(const Points& points, const Eigen::Matrix3d& base) {
  const Points local = base.transpose() * points;
  const Eigen::VectorXd x = local.row(0), y = local.row(1);
  Eigen::MatrixXd matrix(points.cols(), 6);
  matrix << Eigen::VectorXd::Ones(points.cols()), x, y, x.cwiseProduct(x), 2 * x.cwiseProduct(y),
      y.cwiseProduct(y);
  const Eigen::VectorXd found = least_squares(matrix, local.row(2).transpose());
  Eigen::Matrix2d bend;
  bend << found[3], found[4], found[4], found[5];
  return bend;
}

// Frames at the points' middle, bent as the paraboloid is; for a cylinder, along either of its
// principal directions.
void add_patches(Kind kind, const Points& points, std::vector<Frame>& into) {
  const Principal principal = principal_axes(points);
  Eigen::Matrix3d base;
  base << principal.axes.col(2), principal.axes.col(1), principal.axes.col(0);
  const Eigen::Matrix2d bend = paraboloid(points, base);
  const Axes bends = axes_of(bend);
  for (int k = 0; k < 2; ++k) {
    // Outwards is where the surface falls away to both sides.
    const double curvature = kind == Kind::kSphere ? -bend.trace() : -2 * bends.values[k];
    const Eigen::Vector3d axis = base.leftCols<2>() * bends.vectors.col(1 - k);
    into.push_back(frame_of(Eigen::Vector3d::Zero(), axis, base.col(2), curvature));
    if (kind == Kind::kSphere) return;
  }
}

void add_cylinders(const Points& points, std::vector<Frame>& into) {
  const Principal principal = principal_axes(points);
  std::vector<std::pair<double, Frame>> found;
  for (int i = -3; i < kDirections; ++i) {
    const Eigen::Vector3d axis = i < 0 ? Eigen::Vector3d(principal.axes.col(i + 3)) : direction(i);
    Eigen::Matrix3d base;
    base.col(0) = axis.unitOrthogonal();
    base.col(1) = axis.cross(base.col(0));
    base.col(2) = axis;
    const Algebraic circle = algebraic(base.transpose() * points, 2);
    found.emplace_back(circle.left, frame_about(base * circle.centre, circle.radius, axis));
  }
  const auto end = found.begin() + static_cast<std::ptrdiff_t>(std::min(kAxes, found.size()));
  std::partial_sort(found.begin(), end, found.end(),
                    [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto each = found.begin(); each != end; ++each) into.push_back(each->second);
}

}  // namespace

Principal principal_axes(const Points& points) {
  const Axes found = axes_of(points * points.transpose() / static_cast<double>(points.cols()));
  return {found.vectors, found.values.cwiseMax(0).cwiseSqrt()};
}

std::vector<Frame> starts(Kind kind, const Points& points) {
  const Principal principal = principal_axes(points);
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero(), z = Eigen::Vector3d::UnitZ();
  const Eigen::Matrix3d& axes = principal.axes;
  std::vector<Frame> result;
  const Points sample = sample_of(points);
  switch (kind) {
    case Kind::kPlanarLine:
      for (const Eigen::Vector3d& normal :
           {Eigen::Vector3d(z.cross(axes.col(2))), Eigen::Vector3d(axes.col(2))})
        result.push_back(frame_of(zero, z, normal, 0));
      break;
    case Kind::kLine:
      for (const int k : {2, 1, 0}) result.push_back(frame_of(zero, axes.col(k), axes.col(k), 0));
      break;
    case Kind::kPlane:
      for (const int k : {0, 1, 2})
        result.push_back(frame_of(zero, axes.col((k + 1) % 3), axes.col(k), 0));
      break;
    case Kind::kCircle: {
      const Algebraic circle = algebraic(sample, 2);
      result.push_back(frame_about(circle.centre, circle.radius, z));
      Eigen::Matrix3d base;
      base << axes.col(2), z, z.cross(axes.col(2));
      result.push_back(frame_of(zero, z, base.col(2), -2 * paraboloid(sample, base)(0, 0)));
      break;
    }
    case Kind::kSphere: {
      const Algebraic sphere = algebraic(sample, 3);
      result.push_back(frame_about(sphere.centre, sphere.radius, sphere.centre.unitOrthogonal()));
      add_patches(kind, sample, result);
      break;
    }
    case Kind::kCylinder:
      add_patches(kind, sample, result);
      add_cylinders(sample, result);
      break;
  }
  return result;
}

}  // namespace evenload
