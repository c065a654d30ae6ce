// A smooth curve as it is looked at once, to be followed by arcs: where it is, how it heads, and
// how many tangent arcs it demands.
//
// Law: looks lie so closely that an arc that leaves the curve by the tolerance has about five of
// them, and that their cubic interpolation is next to the curve.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "geometry/bi_arc.h"

namespace evenload {

// place(u), 0 <= u <= end: the curve's points with the directions of its travel.
using CurvePlace = std::function<PlanePoint(double)>;

struct CurveLook {
  double u = 0;
  PlanePoint at;
  double along = 0;    // mm from the curve's beginning
  double heading = 0;  // rad turned since there
  double sum = 0;      // mm: the heading's integral along the way
};

class CurveLooks {
 public:
  // No two are farther apart than a third of `most_step`.
  CurveLooks(const CurvePlace& place, double end, double most_step, double tolerance);

  std::size_t size() const { return looks_.size(); }
  const CurveLook& operator[](std::size_t i) const { return looks_[i]; }
  const CurveLook& back() const { return looks_.back(); }

  // The parameter so far along, nearly; after the look `i` and before the next.
  double u_at(double along, std::size_t i) const;
  // A place after the look `i` and before the next.
  CurveLook between(std::size_t i, double u, const PlanePoint& at) const;

 private:
  void add(double u, const PlanePoint& at);
  double sum_at(std::size_t i, const CurveLook& to) const;

  std::vector<CurveLook> looks_;
};

// How many arcs the curve demands from its beginning on, each of no more than `most_step`.
class ArcDemand {
 public:
  ArcDemand(const CurveLooks& looks, double most_step, double tolerance);

  double all() const { return arcs_.back(); }
  // Up to a place after the look `i` and before the next.
  double at(std::size_t i, const CurveLook& on) const;
  // mm along the curve where so many are demanded; `look`: one before there, moved on to the last.
  double along(double arcs, std::size_t& look) const;

 private:
  const CurveLooks& looks_;
  std::vector<double> arcs_;  // up to each look
};

// Arcs per mm that a curve demands whose curvature changes by so much, 1/mm^2, were it to change
// like that for long.
double arcs_per_mm(double change, double tolerance);

}  // namespace evenload
