// Bits of the exact border: cuts of some hundredths of a millimetre into a front that the tool
// meets head-on, as at the end of a gap where no turn fits (steering_wall.cpp). How the tool gets
// from one to the next, and where its feed changes. Our own.
#pragma once

#include <functional>
#include <vector>

#include "strategy/steer/steering.h"
#include "strategy/task/clearing_params.h"
#include "toolpath/planar.h"

namespace evenload {

struct WayBack {
  bool found = false;
  std::vector<Segment> moves;  // none where the tool stands there already
};

// Back along the cuts that `moves` end with, to where they ran through `to` in its direction. Found
// where they did, within `longest` mm. Law: the way lies on the cuts.
WayBack way_back(const std::vector<PlanarMove>& moves, const Pose& to, double longest);

// The same way, but no line of it leads straight back on the cut that it goes back on: a turn by
// half a circle on the spot is no corner that FreeCAD's dressups can work with. A line becomes an
// arc, which posts can write, or two lines where there are to be no arcs, to the left of the cut.
// Laws: its ends stay where they are; there it turns off the line by kLeastAside or more. It stays
// a line where no such way `is_free`.
std::vector<Segment> beside_cuts(const std::vector<Segment>& back, bool arcs,
                                 const std::function<bool(const std::vector<Segment>&)>& is_free);
inline constexpr double kLeastAside = 0.02;  // rad

// Feeds change within no move as short as a run-up of `length` mm and the bit behind it, which is
// cut slowly where the tool stands in a front. So `way`, along which `pass` is cut, gets two moves
// for them, if that saves params.move_price, by the feeds of a constant removal rate, and both can
// be written; at a constant feed none. Condition: `way` is not empty.
void divide_run_up(std::vector<Segment>& way, double length, const Pass& pass,
                   const ClearingParams& params);

}  // namespace evenload
