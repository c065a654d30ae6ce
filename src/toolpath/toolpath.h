// What generators return: moves with feeds, and what was and was not done.
#pragma once

#include <vector>

#include "geometry/vec2.h"
#include "toolpath/finding.h"

namespace evenload {

enum class MoveKind { kRapid, kLink, kEntry, kCut };

// A straight move, or an arc about the z axis (a helix when z changes) from the present position.
struct Move {
  MoveKind kind = MoveKind::kCut;
  double x = 0, y = 0, z = 0;  // end, mm
  double sweep = 0;            // rad, signed, counter-clockwise positive; 0 = line
  double cx = 0, cy = 0;       // centre, arcs only, mm
  double feed = 0;             // mm/min; 0 for rapids
};

enum class Termination {
  kComplete,    // everything within reach is cleared
  kIncomplete,  // usable, but something was left: see findings
  kCancelled,   // what existed when the user stopped it
};

struct Report {
  Termination termination = Termination::kComplete;
  double max_engagement = 0;  // rad, worst mean over 0.1 mm of a cutting move
  double cutting_time = 0;    // s: cuts, links, entries and retracts
  double ideal_time = 0;      // s: area / (r (1 - cos theta) feed), all levels
  double removed_volume = 0;  // mm^3
  double uncut_area = 0;      // mm^2, within reach and left, all levels taken once
  // Over all levels:
  double cut_length = 0;   // mm
  double link_length = 0;  // mm
  int passes = 0;
  int links = 0;
  int retracts = 0;
  std::vector<Finding> findings;  // what was not done, where, why
};

struct Toolpath {
  std::vector<Move> moves;  // the first is a rapid to the clearance height above the first entry
  Report report;
};

}  // namespace evenload
