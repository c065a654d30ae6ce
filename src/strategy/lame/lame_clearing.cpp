#include "strategy/lame/lame_clearing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "geometry/lame_curve.h"
#include "strategy/choose/region_clearing.h"
#include "strategy/lame/lame_opening.h"
#include "strategy/pocket/pocket.h"
#include "support/errors.h"
#include "support/tolerances.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

constexpr double kSameArea = 1e-3;  // of areas
constexpr double kSlow = 1.3;       // ideal times
// Along a spiral the load changes all the time, a little; its curve is chosen with blocks at this
// price (lame_opening.cpp), and means gain nothing.
constexpr FeedSteps kSpiralFeedSteps{block_price::kSpiral, 0.2, 1};

void require(bool condition, const char* sentence) {
  if (!condition) throw std::invalid_argument(sentence);
}

void check_course(const std::vector<double>& course, const char* name) {
  bool good = course.empty() || (course.size() >= 2 && course.size() <= kMostCourse &&
                                 course.front() == 0 && course.back() == 1);
  for (std::size_t i = 1; i < course.size(); ++i) good = good && course[i] >= course[i - 1];
  if (!good)
    throw std::invalid_argument(std::string(name) +
                                " must be 2 to 20 values that begin with 0, end with 1 and never "
                                "fall, as 0, 0.1, 0.4, 1.");
}

void check(const LameParams& p) {
  require(!p.segments || (*p.segments >= 3 && *p.segments <= 12),
          "Segments must lie between 3 and 12.");
  for (const std::optional<double>& axis : {p.semi_axis_a, p.semi_axis_b})
    require(!axis || (*axis > 0 && *axis < 1e5),
            "SemiAxisA and SemiAxisB must be positive lengths.");
  for (const std::optional<double>& exponent : {p.exponent_start, p.exponent_end})
    require(!exponent || (*exponent >= kLeastExponent && *exponent <= 1),
            "ExponentStart and ExponentEnd must lie between 0.05 and 1: above 1 the spiral has "
            "corners.");
  require(!p.rotation || std::isfinite(*p.rotation), "Rotation must be finite.");
  require(!p.pitch || (*p.pitch > 0 && std::isfinite(*p.pitch)), "Pitch must be positive.");
  require(!p.centre || (std::isfinite(p.centre->x) && std::isfinite(p.centre->y)),
          "Centre must be finite.");
  require(!p.segments || *p.segments == 4 || !p.semi_axis_a || !p.semi_axis_b ||
              *p.semi_axis_a == *p.semi_axis_b,
          "Semi-axes of two lengths need Segments 4: set both to the same length, or leave one "
          "unset.");
  check_course(p.semi_axis_a_course, "SemiAxisACourse");
  check_course(p.semi_axis_b_course, "SemiAxisBCourse");
  check_course(p.exponent_course, "ExponentCourse");
}

LameFigures mirrored(LameFigures figures) {
  figures.last.centre.x = -figures.last.centre.x;
  figures.last.rotation = kPi - figures.last.rotation;
  return figures;
}

// The wishes as the mirrored work of conventional milling sees them.
LameParams mirrored(LameParams p) {
  if (p.centre) p.centre->x = -p.centre->x;
  // Mirrored at the y axis, the first semi-axis points the other way.
  if (p.rotation) p.rotation = kPi - *p.rotation;
  return p;
}

bool is_straight(const std::vector<double>& course) {
  for (std::size_t i = 0; i < course.size(); ++i)
    if (std::abs(course[i] * static_cast<double>(course.size() - 1) - static_cast<double>(i)) >
        kRounding)
      return false;
  return true;
}

// Where both semi-axes change evenly all the same, no course is set.
LameParams without_straight_courses(LameParams p) {
  if (!is_straight(p.semi_axis_a_course) || !is_straight(p.semi_axis_b_course)) return p;
  p.semi_axis_a_course.clear();
  p.semi_axis_b_course.clear();
  return p;
}

void leave_rest(const LameOpening& opening, Plan& plan) {
  const double left = std::max(0.0, opening.reached_area - opening.cleared_area);
  plan.leave(left);
  plan.tell({FindingCode::kLeftBesideSpiral, {}, {left}});
}

// mm^2 that the tool reaches at all.
double reached_area(const std::vector<Region>& regions, const ClearingParams& clearing) {
  double sum = 0;
  for (const Region& region :
       reachable_ground(regions, clearing.tool_diameter, clearing.stock_to_leave))
    sum += region.area();
  return sum;
}

// Regions with narrow passages are cleared without an opening: `reached` mm^2 is of the others, and
// becomes that of all.
void tell_missing_spirals(const std::vector<Region>& regions, const ClearingParams& clearing,
                          double& reached, LameToolpath& result) {
  const bool left = clearing.entry == EntryKind::kPredrilledHole && regions.size() > 1;
  const bool open = std::any_of(regions.begin(), regions.end(), [](const Region& region) {
    const std::vector<Vertex>& v = region.outer.vertices();
    return std::any_of(v.begin(), v.end(), [](const Vertex& x) { return x.open; });
  });
  if (!open && !left) {
    const double all = reached_area(regions, clearing);
    if (result.figures && all < reached * (1 + kSameArea)) return;
    reached = std::max(reached, all);
  } else if (result.figures) {
    return;
  }
  result.report.findings.push_back(
      {result.figures ? FindingCode::kRegionWithoutSpiral : FindingCode::kNoSpiral});
}

// Of several regions the one that is refused is named.
LameOpening opening_of(Plan& plan, const RegionTask& task, const ClearingParams& clearing,
                       const LameParams& params, bool of_several, Progress& progress) {
  try {
    return lame_opening(plan, task, clearing, params, progress);
  } catch (const GeometryError& error) {
    throw GeometryError(error.refusal(), error.where(), error.numbers(), of_several);
  }
}

}  // namespace

LameToolpath clear_with_lame_spiral(const std::vector<Region>& regions,
                                    const ClearingParams& clearing, const LameParams& params,
                                    Progress& progress) {
  check(params);
  require(!clearing.stock,
          "A Lamé spiral cannot clear what earlier operations left: turn UseRestMachining off, or "
          "take the operation Adaptive.");
  const bool mirror = clearing.cut_mode == CutMode::kConventional;
  const LameParams seen = without_straight_courses(mirror ? mirrored(params) : params);
  LameToolpath result;
  double by_spirals = 0, reached = 0, most = 0;
  const auto clearer = [&](const RegionTask& task, const ClearingParams& checked, Progress& watch) {
    Plan plan(task, checked, watch);
    const LameOpening opening = opening_of(plan, task, checked, seen, regions.size() > 1, watch);
    by_spirals += opening.spiral_area;
    reached += opening.reached_area;
    if (opening.figures && opening.spiral_area > most) {
      most = opening.spiral_area;
      result.figures = mirror ? mirrored(*opening.figures) : *opening.figures;
    }
    if (params.rest == LameRest::kLeave) {
      leave_rest(opening, plan);
      return plan.take();
    }
    if (!watch.report(kFirstHalf)) return plan.take();
    Progress half([&](double done) { return watch.report(kFirstHalf + (1 - kFirstHalf) * done); });
    clear_region(plan, task, beside_spiral(checked), half);
    return plan.take();
  };
  ClearingParams finer = clearing;
  finer.feed_steps = kSpiralFeedSteps;
  static_cast<Toolpath&>(result) = clear_by(clearer, regions, finer, progress);
  if (!progress.cancelled() && clearing.narrow_passages != NarrowPassages::kSkip)
    tell_missing_spirals(regions, clearing, reached, result);
  if (clearing.feed_control == FeedControl::kConstantFeed &&
      result.report.termination == Termination::kComplete &&
      result.report.cutting_time > kSlow * result.report.ideal_time)
    result.report.findings.push_back({FindingCode::kSlowSpiral});
  result.cleared_share = reached > 0 ? by_spirals / reached : 0;
  return result;
}

}  // namespace evenload
