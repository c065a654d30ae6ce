// The chip that one tooth of a ball-end tool takes: volume, faces, thickness, the edge that works.
//
// The chip is the tool's ball less the ball of the tooth before, a feed per tooth behind, and less
// what earlier passes swept, within the stock. As the ball moves from one place to the other its
// surface within that material sweeps the chip's volume once:
//   V = integral over the way s of the integral of (t u) R^2 dOmega over the material on the ball,
// t the direction of the way, so that volume and both faces are integrals over regions of balls,
// exact but for their quadrature (ball_region.h). Edge: the angle from the tool's axis, in which
// material meets the ball. Local diameter: D sin of it. Tip: local diameters below kTip D.
// Laws: mirrored surface, feed and uncut side give the same chip; lengths scale; without earlier
// passes a slot. Tolerance: 1e-5 of volume and faces, 1e-6 of the largest thickness.
// Source: [Varga 2023, ch. 4]; the readings of its procedure are in docs/chip_model.md.
#pragma once

#include "ball_end/worked_surface.h"

namespace evenload {

// Where earlier passes left material, looking along the feed: to the right or the left of one that
// lies a stepover away, between two, or all around.
enum class Uncut { kRight, kLeft, kStrip, kSlot };

inline constexpr double kTip = 0.2;  // of the diameter

struct ChipCase {
  double ball_radius, feed_per_tooth, stepover, allowance;  // mm
  double feed_direction;                                    // rad from x, in step coordinates
  Uncut uncut;
};

struct Chip {
  double volume = 0;                  // mm^3
  double tool_face = 0;               // mm^2, on the ball of this tooth
  double previous_face = 0;           // mm^2, left by the tooth before
  double max_thickness = 0;           // mm
  double edge_from = 0, edge_to = 0;  // rad from the tool's axis
  double tip_share = 0;               // of the volume

  double mean_thickness() const { return volume / previous_face; }  // the source's
  double mean_thickness_tool() const { return volume / tool_face; }
};

// Throws std::invalid_argument, in one sentence, for a case that is none.
void check(const ChipCase& task);

// The chip at step coordinates `at`. Throws std::invalid_argument as check(), where nothing is cut,
// and where the chip reaches beyond the lower half of the ball.
Chip chip(const WorkedSurface& surface, Vec2 at, const ChipCase& task);

}  // namespace evenload
