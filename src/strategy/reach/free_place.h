// Where the tool can come straight down between pieces of material that earlier cuts left.
//
// A circle free of material does not make a free disc: what is left may stand within it. So the
// disc is looked at ring by ring, and no corner of the stock that still stands may lie in it.
#pragma once

#include <optional>
#include <vector>

#include "cutting/cleared_ground.h"
#include "strategy/places/area.h"
#include "strategy/steer/steering.h"

namespace evenload {

// Whether the tool's disc about `p` holds nothing of `stock`, the material of `ground`. A piece
// left within it by cuts that were made since may hide if it is narrower than kRings shares.
bool is_free_disc(const ClearedGround& ground, const std::vector<Region>& stock, Vec2 p);
// Rings in a tool's radius.
inline constexpr int kRings = 40;

// A quarter turn that ends in `to`, over free ground and within `centres`, from a free place off
// the wall, so that no edge brushes the wall on the way down; a tighter one than `turn_radius`
// where that is too wide. Empty when there is none.
std::optional<Segment> way_from_beside(const ClearedGround& ground,
                                       const std::vector<Region>& stock, const Area& centres,
                                       const Pose& to, double turn_radius);

// Whether there is any place in the region where the tool's disc is free; looked for at kLook
// shares of the tool's radius.
bool has_free_place(const ClearedGround& ground, const std::vector<Region>& stock,
                    const Region& centres);
inline constexpr double kLook = 0.5;

}  // namespace evenload
