// A part that is bent one way: a section of lines and arcs with common tangents, drawn along x.
//
// The section runs towards +y. Its outward normal leans by N from z towards y, n = (sin N, cos N),
// and N grows by the curvature, positive where the part is convex, along the section. Beyond its
// ends the section goes on straight. Conditions: concave arcs are wider than the ball.
// Laws: the tool's places at a joint are the same from both sides; distances are exact.
#pragma once

#include <cstddef>
#include <vector>

#include "ball_end/worked_surface.h"

namespace evenload {

struct ProfilePiece {
  double length = 0;     // mm
  double curvature = 0;  // 1/mm, > 0: convex
};

struct PartProfile {
  Vec2 start;       // (y, z) of the section's first point
  double lean = 0;  // N there, rad
  std::vector<ProfilePiece> pieces;
};

// The plane z = 0.
PartProfile plane_profile();
// A cylinder along x about y = 0, `radius` > 0: its convex upper side; < 0: a concave trough. It
// ends where it leans by kSteepest.
inline constexpr double kSteepest = 85 * kPi / 180;
PartProfile cylinder_profile(double radius);
// The source's test part of 80 mm: R45, fillets R10, flats of 10 mm; CX: a dome, CV: a trough.
// [Varga 2023, 3.1]; its height follows from these, 8.90 mm.
PartProfile test_part_profile(bool is_convex);

class ExtrudedSurface final : public WorkedSurface {
 public:
  // Throws std::invalid_argument where the ball does not fit into a concave arc.
  ExtrudedSurface(const PartProfile& profile, double ball_radius, Steps steps);

  // q of the place whose plan ordinate is `y`.
  double step_coordinate(double y) const;
  // Plan ordinates of the tool between which it touches the section.
  double lowest() const { return pieces_.front().centre.x; }
  double highest() const { return highest_; }

  PathPoint centre(Vec2 at, Vec2 along) const override;
  double distance(const Eigen::Vector3d& point) const override;
  Eigen::Vector3d normal(Vec2 at) const override;

 private:
  struct Piece {
    double curvature, centre_curvature;
    double lean;   // at its beginning
    double q;      // step coordinate at its beginning
    Vec2 part;     // its beginning on the part, (y, z)
    Vec2 centre;   // and of the tool's centre
    Vec2 tangent;  // there
    Vec2 middle;   // of the arc
  };
  const Piece& piece_at(double q) const;
  Vec2 normal_at(const Piece& piece, double q) const;

  Steps steps_;
  double ball_radius_;
  double highest_ = 0;
  std::vector<Piece> pieces_;
};

}  // namespace evenload
