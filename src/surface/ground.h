// The part as one tool meets it: how high its tip runs, and where it is at work.
#pragma once

#include <vector>

#include "surface/drop.h"
#include "surface/extension.h"

namespace evenload {

struct Ground {
  const FacetMesh* mesh = nullptr;
  Cutter cutter;         // as it is
  double allowance = 0;  // mm, >= 0: stays on the part, all around
  double floor = 0;      // mm: the tip never goes lower
  // What has to lie on the picked faces: where the tool touches, or its axis.
  bool by_contact = true;
  // Where passes go on beyond the picked faces; `mesh` is its ground then.
  const Extension* extension = nullptr;
  // What the tool keeps off besides, by a clearance, mm, all around; where that lifts it, it is not
  // at work.
  const FacetMesh* fixtures = nullptr;
  double fixture_clearance = 0;
};

// A place on a line in plan.
struct DropSample {
  double s = 0;                    // mm along the line
  double z = 0;                    // mm, of the tip
  bool is_at_work = false;         // whether the tool is to cut here
  bool is_kept_off = false;        // whether a fixture keeps it up
  std::uint32_t facet = kNoFacet;  // that it touches
};

// A straight line or an arc in plan.
struct PlanLine {
  Vec2 from;        // s = 0
  Vec2 along;       // of length 1: where it goes there
  double bend = 0;  // 1/mm, positive: turns left
  Vec2 at(double s) const;
};

// `beside`: a facet that is touched not far from there.
DropSample sample_at(const Ground& ground, const PlanLine& line, double s,
                     std::uint32_t beside = kNoFacet);

// Samples between two places of a line, so near to each other that a chord between two is as far
// from the tool's true height as kChordShare of `tolerance` at the most, distances taken in the
// upright plane of the line, an arc's unrolled. Where the height jumps, beside an upright wall, two
// samples are nearer than kJumpShare of it. A bump that is missed between two stands out by
// kBumpShare of it. Of a pass, places where the tool is not at work, nor kept up by a fixture, are
// left out in the end, and sampled no finer than that takes; a link goes over all of them.
enum class Sampled { kPass, kLink };
std::vector<DropSample> samples_along(const Ground& ground, const PlanLine& line, double begin,
                                      double end, double tolerance,
                                      Sampled sampled = Sampled::kPass);
// Chords that a sample in their middle shows to be this far off are halved; the four quarters of
// those which are not leave a round ground by a sixteenth of it, and a sharp one by a quarter.
inline constexpr double kChordShare = 0.15;
inline constexpr double kJumpShare = 0.05;
inline constexpr double kBumpShare = 0.05;

// mm: how wide a bump that stands out by `tolerance` makes the tool's path at the least.
double spacing_of(const Cutter& cutter, double tolerance);

// The parts of the samples along which the tool is at work, each at least two samples, ends found
// to kBorder.
std::vector<std::vector<DropSample>> parts_at_work(const Ground& ground, const PlanLine& line,
                                                   const std::vector<DropSample>& samples);
inline constexpr double kBorder = 1e-4;  // mm, a tenth of what posts write

}  // namespace evenload
