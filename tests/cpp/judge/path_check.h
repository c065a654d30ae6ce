// A judge of finished paths that knows nothing of how they were made.
//
// It reads the moves of a toolpath's lowest level, in order, and measures what a machine would meet
// there. A point is cleared once it lies within the tool's radius of an earlier move; the
// engagement at a position is the share of the tool's leading half circle that is not cleared,
// found by looking at points of that half circle one by one. Shares no code with src/strategy,
// src/cutting or src/feed.
#pragma once

#include <optional>
#include <vector>

#include "geometry/region.h"
#include "toolpath/toolpath.h"

namespace evenload::path_check {

// What is milled. Walls: all boundary curves, but an outer one that is marked open all round,
// outside which there is neither wall nor material.
struct Stock {
  std::vector<Region> regions;
  std::optional<Vec2> hole;  // its centre: ground without material
  double hole_radius = 0;    // mm
  double top = 0;            // mm: z
};

struct Settings {
  double thinnest =
      1e-4;            // mm: material thinner than this is what rounding of the output may leave
  double step = 0.02;  // mm of path between two looks
  double angle = 0.5 * kPi / 180;  // rad between two points of the half circle
  double window = 0.1;             // mm of path over which maxima are means
  double cell = 0.15;              // mm, of the grid that looks for what was left
};

// mm: how far behind a wall the tool's centre is told from deeper.
inline constexpr double kDeepest = 0.5;

struct Findings {
  // Over the area within the tool's reach that held material.
  double reachable_area = 0;  // mm^2
  double left_area = 0;       // mm^2
  double left_share = 0;      // of reachable_area
  Vec2 left_at;
  // Over all moves below the stock's top, entries and links too.
  double gouge =
      0;  // mm: how deep the tool is in a wall at worst, up to kDeepest more than its radius
  Vec2 gouge_at;
  // rad: worst mean over the window.
  double cut_engagement = 0;
  Vec2 cut_engagement_at;
  double mean_cut_engagement = 0;  // rad, over all cuts
  double link_engagement = 0;
  Vec2 link_engagement_at;
  // mm^2/min: worst mean over the window of width times feed.
  double removal_rate = 0;
  Vec2 removal_rate_at;
  double cut_length = 0, link_length = 0;  // mm
  double climb_length = 0;         // mm of cuts with more material on the right than on the left
  double conventional_length = 0;  // mm, the other way round
  double removed_area = 0;         // mm^2, by cuts and links
  int bad_plunges = 0;             // straight down into material, or rapids through it
  Vec2 bad_plunge_at;
  double arc_mismatch = 0;   // mm: how far an arc's end is from where its centre and sweep lead to
  double largest_sweep = 0;  // rad
  int kinks = 0;             // direction changes above one degree with material on both sides
  double worst_kink = 0;     // rad
  Vec2 worst_kink_at;
};

Findings check_path(const Stock& stock, double tool_radius, const std::vector<Move>& moves,
                    const Settings& settings = {});

}  // namespace evenload::path_check
