// The floor of a slot that is given by its middle and its width.
#pragma once

#include "geometry/region.h"

namespace evenload {

// How a slot ends.
enum class SlotEnds {
  kRound,   // half the width beyond the middle's ends
  kSquare,  // at the middle's ends
  kOpen,    // likewise, and these are edges of the stock
};

// The slot of `width` mm about a chain of lines and arcs; corners of the chain are rounded outside.
// A closed chain gives a ring. Laws: every point of the sides lies half the width from the chain.
// Throws std::invalid_argument for a width that is not positive, GeometryError for a chain of no
// length, one that crosses itself or comes nearer to itself than the width, and one that bends more
// tightly than half the width.
Region slot_around(const Curve& middle, double width, SlotEnds ends);

}  // namespace evenload
