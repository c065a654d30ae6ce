// The part of a ball's surface that lies in material, as an area between curves.
//
// Places on the ball are told by the direction of feed, t, as the pole: u = sin a t + cos a (cos b
// down + sin b side), with `down` across the feed towards the part. The teeth before bound the
// region by a circle a = const, so that for each b material is an interval of a, and areas and
// volumes are integrals over b alone, of smooth functions between the places where another bound
// takes over. These places are found first.
// Tolerance: 1e-6 of an area. Condition: for each b the places in material are one interval of a,
// as they are on the lower half of a ball that works a surface which it fits.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "ball_end/swept_pass.h"

namespace evenload {

struct FeedFrame {
  Eigen::Vector3d feed, down, side;  // orthonormal
};

// What is left for the tooth: the stock less earlier passes.
struct Material {
  const WorkedSurface* surface;
  double ball_radius, allowance;
  std::vector<SweptPass> passes;

  // > 0 within; the smallest of the distances, in mm, to what bounds it, and which that is: 0 the
  // stock's surface, from 1 on the passes.
  struct Depth {
    double depth;
    int bound;
  };
  Depth depth(const Eigen::Vector3d& point) const;
};

// An interval of a in material; `state` tells what bounds it, and is another where that changes.
struct Interval {
  static constexpr int kEmpty = -1;
  double low = 0, high = 0;
  int state = kEmpty;

  bool is_empty() const { return state == kEmpty; }
};

class BallRegion {
 public:
  // On the ball around `centre`, where a > `least`.
  BallRegion(const Material& material, const FeedFrame& frame, const Eigen::Vector3d& centre,
             double least)
      : material_(&material), frame_(&frame), centre_(centre), least_(least) {}

  Interval interval(double b) const;

 private:
  Material::Depth depth(double a, const Eigen::Vector3d& across) const;
  double climb(double from, double step, const Eigen::Vector3d& across) const;
  double root(double inside, double fi, double outside, double fo,
              const Eigen::Vector3d& across) const;
  double end_ahead(double inside, double fi, const Eigen::Vector3d& across) const;

  const Material* material_;
  const FeedFrame* frame_;
  Eigen::Vector3d centre_;
  double least_;
  mutable double last_end_ = 0;  // where the next one is looked for first
};

// Ends of smooth pieces: b where `state(b)` changes, in order, the ends of the material among them.
// Looks for them as far as `reach` on both sides of 0, the point of contact.
std::vector<double> state_changes(const std::function<int(double)>& state, double reach);

// Nodes and weights of the integral over b between two changes, where functions may begin as roots.
struct Node {
  double b, weight;
};
inline constexpr int kNodes = 10;
std::array<Node, kNodes> nodes_between(double from, double to);

}  // namespace evenload
