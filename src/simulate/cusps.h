// Cusps between two passes of a tool with a rounded end.
//
// Where two neighbouring places were cut by different passes, the ridge between them lies on the
// way from one to the other where both passes' undersides are as low. A cusp is what the ridge
// stands out from what both passes leave where they are lowest, on either side of it: so neither
// an allowance nor a path that runs above the part counts. Exact on planes and cylinders, but for
// kHalvings and the parabolas by which the lowest places are found.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "simulate/height_map.h"
#include "simulate/swept_cutter.h"

namespace evenload {

// A place, the number of the run that has cut it, and mm of path up to there.
struct CutPlace {
  Vec2 at;
  std::int32_t run = 0;
  double along = 0;
};

class Cusps {
 public:
  // Keeps references.
  Cusps(const HeightMap& part, const Cutter& cutter, const std::vector<CutterRun>& runs)
      : part_(part), cutter_(cutter), runs_(runs) {}

  // mm across the part's surface; nothing where there is no part.
  std::optional<double> between(const CutPlace& mine, const CutPlace& other) const;

 private:
  Underside of_pass(std::int32_t run, Vec2 at) const;
  std::optional<double> valley(std::int32_t run, Vec2 from, Vec2 half) const;
  Vec2 tip_of(const CutPlace& place) const;

  const HeightMap& part_;
  const Cutter& cutter_;
  const std::vector<CutterRun>& runs_;
};

}  // namespace evenload
