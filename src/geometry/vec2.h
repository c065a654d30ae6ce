// Points and vectors of the plane, mm.
#pragma once

#include <cmath>

namespace evenload {

inline constexpr double kPi = 3.14159265358979323846, kDegree = kPi / 180;

struct Vec2 {
  double x = 0, y = 0;
};

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
inline Vec2 operator*(double k, Vec2 a) { return {k * a.x, k * a.y}; }
inline Vec2 operator*(Vec2 a, double k) { return {k * a.x, k * a.y}; }
inline Vec2 operator/(Vec2 a, double k) { return {a.x / k, a.y / k}; }
inline Vec2& operator+=(Vec2& a, Vec2 b) { return a = a + b; }
inline bool operator==(Vec2 a, Vec2 b) { return a.x == b.x && a.y == b.y; }
inline bool operator!=(Vec2 a, Vec2 b) { return !(a == b); }

inline double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline double squared_norm(Vec2 a) { return dot(a, a); }
inline double norm(Vec2 a) { return std::sqrt(dot(a, a)); }
inline double distance(Vec2 a, Vec2 b) { return norm(a - b); }
inline Vec2 normalized(Vec2 a) { return a / norm(a); }
inline Vec2 left_normal(Vec2 a) { return {-a.y, a.x}; }  // turned by +90 degrees
inline Vec2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }
inline double angle_of(Vec2 a) { return std::atan2(a.y, a.x); }
inline Vec2 rotated(Vec2 a, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}

// The angle brought into [0, 2 pi).
inline double wrap_positive(double angle) {
  if (angle < -2 * kPi || angle >= 4 * kPi) angle = std::fmod(angle, 2 * kPi);
  if (angle < 0) angle += 2 * kPi;
  if (angle >= 2 * kPi) angle -= 2 * kPi;
  return angle < 2 * kPi ? angle : 0.0;
}
// The angle brought into [-pi, pi).
inline double wrap_signed(double angle) { return wrap_positive(angle + kPi) - kPi; }

}  // namespace evenload
