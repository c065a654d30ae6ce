// Chip thickness by the exact path of the tooth before: the state-dependent delay.
//
// The tooth before passed the line through the present edge across its way u at the time t - tau,
// (r(t) - r_before(t - tau)).u(t) = 0, and h = (r(t) - r_before(t - tau)).n. Against the velocity
// model h changes by O(fz/R), more where the edge is slow.
// Source: [Bachrathy 2013, thesis 5].
#pragma once

#include "dynamics/orbit.h"

namespace evenload {

// What the exact path adds to the velocity model's h, at an instant within the period; m.
double exact_less_velocity(const OrbitSolver& solver, const Orbit& orbit, int tooth, double time);

// Its largest magnitude while a tooth cuts, over the feed per tooth.
double thickness_deviation(const OrbitSolver& solver, const Orbit& orbit);

// The motion with exact chips at orbit.depth, from that of the velocity model; the exact path is
// taken from the motion before, until nothing changes. Whether that ended.
bool solve_exactly(const OrbitSolver& solver, Orbit& orbit);

}  // namespace evenload
