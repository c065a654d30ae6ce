// Which stretches of the walls are cleared: the one-dimensional picture of where material is left.
//
// Every front between cleared ground and material ends on walls. So along each wall, in the
// direction of climb milling, cleared and uncleared stretches alternate, and each change from
// cleared to uncleared is where a pass can start. Samples are taken along the walls of every stage;
// what a stage shares with the one before is sampled once, but for the first sample behind each
// stretch of its own. Our own; the source orders its passes by the medial axis [Jacsó 2021, hybrid
// path].
//
// A look costs as much as there is uncleared near it, and a list of starts as much as it has
// entries, however long the walls are: only samples that have changed are looked at again.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "cutting/cleared_ground.h"
#include "geometry/point_grid.h"
#include "strategy/steer/stage.h"
#include "strategy/steer/steering.h"

namespace evenload {

struct PassStart {
  std::size_t stage = 0;
  WallPlace place;         // the last cleared sample
  Pose pose;               // there
  std::size_t sample = 0;  // the first uncleared sample
  bool corner = false;     // later stages have walls of their own nearby
};

class WallSamples {
 public:
  // Both references must outlive this object. `most_passes`: to one sample, see note_pass().
  WallSamples(const std::vector<Stage>& stages, const ClearedGround& ground, int most_passes);

  // Looks again at the samples that moves in the box from `low` to `high` may have cleared.
  void update(Vec2 low, Vec2 high);
  // Every place where a pass can start now; those of later stages only where no earlier stage has
  // work left nearby. Where all that could start have to wait for work that cannot, it is the
  // earliest of them that are nearby. Condition: the ground holds all that it held before.
  std::vector<PassStart> starts();
  // Known to be: those shared with the stage before are looked at where a start needs them.
  bool is_clear(std::size_t sample) const { return samples_[sample].clear; }
  // Says that a pass to `sample` came to nothing; after a few times it is not offered again until
  // its surroundings change, and the next stage takes its place.
  void give_up(std::size_t sample);
  // Says that a pass to `sample` was cut. Where the sample stays all the same, after so many of
  // them it is not offered again, whatever changes, and the next stage takes its place: clearing
  // ends.
  void note_pass(std::size_t sample);
  std::size_t uncleared_count() const { return uncleared_; }

 private:
  struct Sample {
    WallPlace place;
    Vec2 p;
    std::size_t stage = 0;
    Vec2 witness;  // a point of the tool's circle that is not cleared
    bool has_witness = false;
    bool shared = false;  // belongs to the stage before as well
    bool clear = false;
    bool corner = false;  // later stages have samples of their own nearby
    int failures = 0, passes = 0;
    std::size_t track = 0;
    int blockers = 0;                // uncleared samples of earlier stages nearby: they come first
    std::vector<std::size_t> later;  // the samples that this one is one of those for
  };
  struct Track {
    std::size_t stage = 0;
    std::size_t first = 0, count = 0;  // in samples_
  };
  struct Taken {
    std::vector<Sample> samples;
    std::vector<Track> tracks;
  };
  static bool is_open(const Sample& sample) { return !sample.clear && !sample.shared; }
  static bool blocks(const Sample& sample);
  bool is_spent(const Sample& sample) const { return sample.passes >= most_passes_; }
  void hand_over(const Sample& failed);
  Taken taken(std::size_t first, std::size_t last, double spacing) const;
  void take_samples(double spacing);
  void append(Taken taken);
  void own_first_shared(const Track& track);
  void order_by_stage();
  std::vector<PassStart> starts(const std::set<std::size_t>& from);
  std::vector<PassStart> earliest(const std::vector<PassStart>& starts) const;
  const Sample* last_clear_before(std::size_t index);
  std::size_t neighbour(std::size_t index, std::size_t back) const;
  void look(Sample& sample);
  // Everything that depends on a sample's marks follows from them here.
  template <typename Edit>
  void change(std::size_t index, Edit edit);
  void sort_in(std::size_t index);

  const std::vector<Stage>& stages_;
  const ClearedGround& ground_;
  int most_passes_;
  std::vector<Sample> samples_;
  std::vector<Track> tracks_;
  PointGrid open_, shared_;              // samples that are not cleared
  std::size_t uncleared_ = 0;            // of the open samples
  std::set<std::size_t> edges_;          // open, not given up, and not right after an open one
  std::set<std::size_t> edges_in_turn_;  // those of them that wait for no earlier stage
  mutable std::vector<AngularInterval> scratch_;
};

}  // namespace evenload
