// The walk along a path: cuts the stock step by step and records the load.
#pragma once

#include <optional>
#include <vector>

#include "simulate/engaged_arcs.h"
#include "simulate/move_pieces.h"
#include "simulate/part_gauge.h"
#include "simulate/simulate.h"

namespace evenload {

class LoadWalk {
 public:
  // `result` gets the record and those of the figures that are found on the way.
  LoadWalk(DexelStock& stock, const SimulationParams& params, Simulation& result,
           Progress& progress);

  // Goes from `from` to `to`, the move of that number. `from_share` and `to_share`: the progress at
  // its ends. False when it was cancelled on the way.
  bool add(const Move& from, const Move& to, std::size_t number, double from_share,
           double to_share);
  // Ends the record.
  void finish();

 private:
  // What is known of the move under way.
  struct Now {
    Move move;
    std::size_t number = 0;
    std::size_t first_sample = 0;
    double feed = 0;         // mm/min along the path
    double level_share = 0;  // of the feed's length that is level
    bool vertical = false;   // straight up or down
    bool plunges = false;    // down, so steeply that the tip does the work
    bool gouging = false;    // its present piece touches the part
    double length = 0;       // mm of path so far
    double area = 0;         // mm^2 of material met on the way
    bool plunged = false;    // met material straight below
    double in_material = 0;  // mm of path
    Place met;               // where first
  };

  bool walk(const MovePiece& piece, double share);
  int steps_of(const MovePiece& piece) const;
  Removal cut(const Segment& path, double z0, double z1);
  void check_gouge(const MovePiece& piece);
  void check_contact(Vec2 p, double z0, double z1, double length, const Removal& removal);
  // Finds in `arcs_` what the tool touches when it sets out from `p`, and what it has just cut on
  // its circle when a step of `path` takes it to z; the latter before the step is cut.
  void touch_at_start(Vec2 p, double z, double feed_angle);
  void touch_at_end(const Segment& path, double z, double feed_angle);
  // Appends a sample, before the step of `length` that leads there is cut.
  void sample(Vec2 p, double z, double feed_angle, double length);
  bool cuts() const;
  bool seen_before(Vec2 p, double z, double feed_angle) const;
  void append_load(Vec2 p, double z, double feed_angle, double length);
  void append_chips();
  void append_force(double feed_angle);
  void finish_move(const Move& from, const std::vector<MovePiece>& pieces);
  MoveKind inferred_kind(const Move& from, const std::vector<MovePiece>& pieces);

  DexelStock& stock_;
  const SimulationParams& params_;
  Simulation& result_;
  Progress& progress_;
  double radius_;
  double step_;  // mm, between samples at the most
  std::size_t next_report_;  // of progress: at so many samples
  PartGauge part_, fixtures_;
  std::optional<ForceModel> force_;
  std::vector<EngagedArc> arcs_;
  Now now_;
  double time_ = 0, removed_ = 0;
  double last_feed_angle_ = 0;  // rad, of the sample before
  bool last_vertical_ = false;
  std::vector<Segment> entry_;  // the way of the entry that was just made
  // Of G-code: level moves that met nothing, from sample to sample, and the fastest that cut.
  struct Idle {
    std::size_t first = 0, end = 0;
    double feed = 0;
  };
  std::vector<Idle> idle_;
  double fastest_cut_ = 0;  // mm/min
};

}  // namespace evenload
