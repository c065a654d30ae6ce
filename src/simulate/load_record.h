// What a simulation returns: the load sample by sample along the path, and what it comes to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cutting/engaged_arc.h"
#include "simulate/rest.h"
#include "toolpath/toolpath.h"

namespace evenload {

// One entry per sample: at the start of each move, seen along it, and then at steps up to its end.
struct LoadRecord {
  std::vector<double> x, y, z;         // mm
  std::vector<std::int32_t> move;      // index among the moves given
  std::vector<std::int8_t> kind;       // MoveKind
  std::vector<double> length;          // mm of path since the sample before; 0 at a move's start
  std::vector<double> time;            // s, at the programmed feeds
  std::vector<double> machine_time;    // s, within the machine's limits; empty without a machine
  std::vector<double> feed;            // mm/min
  std::vector<double> engagement;      // rad, of the leading half circle; of all of it in plunges
  std::vector<double> axial_depth;     // mm, the deepest engaged arc
  std::vector<double> removal_rate;    // mm^3/min
  std::vector<double> removed_volume;  // mm^3 up to here
  std::vector<double> h_max, h_mean;   // mm: largest and mean chip thickness
  std::vector<double> gouge;           // mm into the part
  // Over a revolution; empty without force data. N, N m, W, in the machine's axes.
  std::vector<double> force_peak, force_mean, force_x_peak, force_y_peak;
  std::vector<double> torque_peak, torque_mean, power_mean;
  // The engaged arcs of sample i: arcs[first_arc[i]] to arcs[first_arc[i + 1]].
  std::vector<EngagedArc> arcs;
  std::vector<std::size_t> first_arc;

  std::size_t size() const { return x.size(); }
};

struct Place {
  double x = 0, y = 0, z = 0;  // mm
};

// The worst of something, and where.
struct Worst {
  double value = 0;
  Place at;
};

enum class IncidentKind { kGouge, kFixture, kRapidInMaterial, kPlungeInMaterial };

// Something that must not happen, once for each move that does it.
struct Incident {
  IncidentKind kind = IncidentKind::kGouge;
  Place at;
  std::size_t move = 0;
  double amount = 0;  // mm: deepest, or length of path
};

struct LoadFigures {
  // The worst mean over kLoadWindow of path.
  Worst engagement;        // rad, of cuts
  Worst link_engagement;   // rad, of links
  Worst entry_engagement;  // rad, of entries
  Worst removal_rate;      // mm^3/min, of cuts
  Worst force;             // N: the largest peak of a sample, of cuts and entries
  Worst gouge;             // mm, into the part
  Worst fixture;           // mm, into fixtures
  Worst rapid_in_material, plunge_in_material;  // mm of path in all; where first
  std::vector<Incident> incidents;
  // mm of path; air is the share of the cuts that meets no material.
  double cut_length = 0, air_length = 0, link_length = 0, entry_length = 0, rapid_length = 0;
  double time = 0, machine_time = 0;  // s
  double removed_volume = 0;          // mm^3
  double removed_area = 0;            // mm^2 on which nothing is left above the bottom
  Rest rest;
  std::vector<std::string> notes;
};

// mm of path over which engagement and removal rate are averaged: what is shorter is rounding.
inline constexpr double kLoadWindow = 0.1;

struct Simulation {
  LoadRecord record;
  LoadFigures figures;
  bool cancelled = false;  // the record ends where it was stopped
};

}  // namespace evenload
