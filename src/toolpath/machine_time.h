// How long a path takes on a machine that cannot change its speed at once.
//
// Every move has a speed it may not pass: its feed, the feed limit of each axis in the worst
// direction within the move, on arcs F <= sqrt(centripetal_accel R), and its length times the block
// rate. At a joint that turns by the angle tau the speed is at most
//   sqrt(a junction_deviation c / (1 - c)),  c = cos(tau / 2),
// grbl's rule: a tool with the acceleration a, which the axes leave in the direction of the turn,
// would round the corner and miss it by the deviation. Joints of lines and short arcs are also no
// faster than the circle that rounds them off within half of the shorter neighbour. Between these
// limits the speed changes as fast as the axes allow in the worst direction within the move,
// planned over all moves ahead, or over the look-ahead at whose end the tool must be able to stop.
// The tool stands still before the first move and after the last.
//
// Without a jerk limit the speed over time is a trapezoid. With one the acceleration rises and
// falls at the jerk and is 0 at the ends of a move; moves that join without a limit and share one
// speed are one. Acceleration along and across an arc are limited each for itself.
//
// Laws: never shorter than the programmed time, equal to it without limits; one line takes
// L / v + v / a, or 2 sqrt(L / a) where it is too short to reach v, with a jerk limit a / j more;
// without a jerk limit, raising another limit never makes the path slower; a line cut into
// collinear moves takes as long as before, with full look-ahead and no block rate. Tolerance: the
// equations of motion are solved to rounding, 1e-9 of a move's duration. Source: junction deviation
// as in grbl 1.1, planner.c.
#pragma once

#include <string>
#include <vector>

#include "toolpath/toolpath.h"

namespace evenload {

// Axes in the order x, y, z. Every limit but the rapid feed may be infinite.
struct MachineProfile {
  std::string name;
  double max_feed[3] = {0, 0, 0};   // mm/min, > 0
  double max_accel[3] = {0, 0, 0};  // mm/s^2, > 0
  double max_jerk = 0;              // mm/s^3 along the path, 0 = not limited
  double centripetal_accel = 0;     // mm/s^2, 0 = not limited
  double junction_deviation = 0;    // mm, 0 = every corner is a full stop
  double block_rate = 0;            // blocks per s, 0 = not limited
  int look_ahead = 0;               // blocks that are planned at once, 0 = all
  double rapid_feed = 0;            // mm/min, > 0: of rapid moves whose feed is 0
};

// The speed over a length that begins at `entry`, reaches `peak` and ends at `exit`, mm/s.
struct SpeedProfile {
  double length = 0;  // mm
  double entry = 0, peak = 0, exit = 0;
  double accel = 0, jerk = 0;  // mm/s^2, mm/s^3; jerk 0 = not limited
};

struct MoveTime {
  double start = 0, duration = 0;        // s
  double entry = 0, peak = 0, exit = 0;  // mm/s: at its ends, and the largest
  // The move is the part of `profile` that begins `offset` mm after the profile's begin and takes
  // `offset_time` s from there.
  SpeedProfile profile;
  double offset = 0, offset_time = 0;
  double length = 0;  // mm
};

// One per move. moves[0] is where the tool starts: whatever it is, it takes no time, and neither do
// moves of no length. Throws std::invalid_argument for a profile out of the ranges above, a
// coordinate that is not finite and a move without a feed that is no rapid, with its index.
std::vector<MoveTime> machine_time(const std::vector<Move>& moves, const MachineProfile& profile);

// s since the move's start at `s` mm along it, 0 <= s <= length; outside it the nearer end.
double time_at(const MoveTime& move, double s);

// s of all moves at their programmed feeds, rapids without a feed at `rapid_feed` mm/min.
double programmed_time(const std::vector<Move>& moves, double rapid_feed);

}  // namespace evenload
