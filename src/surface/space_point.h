// Points and vectors of space, mm.
#pragma once

#include <cmath>

#include "geometry/vec2.h"

namespace evenload {

struct SpacePoint {
  double x = 0, y = 0, z = 0;
};

inline SpacePoint operator+(SpacePoint a, SpacePoint b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline SpacePoint operator-(SpacePoint a, SpacePoint b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline SpacePoint operator*(double k, SpacePoint a) { return {k * a.x, k * a.y, k * a.z}; }
inline double dot(SpacePoint a, SpacePoint b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline SpacePoint cross(SpacePoint a, SpacePoint b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(SpacePoint a) { return std::sqrt(dot(a, a)); }
inline double distance(SpacePoint a, SpacePoint b) { return norm(a - b); }
inline Vec2 plan(SpacePoint a) { return {a.x, a.y}; }

}  // namespace evenload
