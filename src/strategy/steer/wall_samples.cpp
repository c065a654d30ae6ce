#include "strategy/steer/wall_samples.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "cutting/probe.h"
#include "geometry/box_tree.h"
#include "support/both.h"
#include "support/tolerances.h"

namespace evenload {
namespace {

// Share of the tool's radius between samples.
constexpr double kSpacing = 0.08;
// A pass that came to nothing so often is not tried again.
constexpr int kTries = 3;
// So many samples back a clear place is looked for.
constexpr std::size_t kLookBack = 8;
// Tool radii: the side of the cells that samples lie in.
constexpr double kCell = 2;
// Fewer are taken sooner than a thread is started.
constexpr double kManySamples = 3000;

Bounds around(Vec2 p, double by) { return {p - Vec2{by, by}, p + Vec2{by, by}}; }

}  // namespace

WallSamples::WallSamples(const std::vector<Stage>& stages, const ClearedGround& ground,
                         int most_passes)
    : stages_(stages), ground_(ground), most_passes_(most_passes) {
  take_samples(kSpacing * ground.tool_radius());
  if (samples_.empty()) return;
  Bounds bounds{samples_.front().p, samples_.front().p};
  for (const Sample& sample : samples_) bounds = joined(bounds, {sample.p, sample.p});
  open_ = shared_ = PointGrid(bounds, kCell * ground.tool_radius());
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    (samples_[i].shared ? shared_ : open_).add(i, samples_[i].p);
    if (is_open(samples_[i])) ++uncleared_;
  }
  order_by_stage();
  for (std::size_t i = 0; i < samples_.size(); ++i) sort_in(i);
}

namespace {

// Places of one wall, by curve and segment; shares of a segment's length.
using Places = std::map<std::pair<std::size_t, std::size_t>, std::vector<double>>;

// Where pieces of `before` that are shorter than `spacing` mm lie on the wall `after`.
Places short_pieces_on(const Area& after, const Area& before, double spacing) {
  Places places;
  for (const Curve& curve : before.curves())
    for (const Segment& piece : curve.segments()) {
      if (piece.length() >= spacing) continue;
      const BoundaryIndex::Hit hit = after.nearest(piece.point(0.5));
      if (hit.distance < kOnWall) places[{hit.curve, hit.segment}].push_back(hit.t);
    }
  return places;
}

// Shares of a segment's length `spacing` mm apart, or less where it bends.
std::vector<double> even_places(const Segment& segment, double spacing) {
  int n = looks_along(segment.length(), spacing);
  if (segment.is_arc()) n = std::max(n, static_cast<int>(std::ceil(std::abs(segment.sweep) / 0.4)));
  std::vector<double> places;
  for (int j = 0; j < n; ++j) places.push_back(static_cast<double>(j) / n);
  return places;
}

}  // namespace

// Those of the stages [first, last).
WallSamples::Taken WallSamples::taken(std::size_t first, std::size_t last, double spacing) const {
  Taken taken;
  for (std::size_t k = first; k < last; ++k) {
    const Area& centres = stages_[k].centres;
    const auto is_shared = [&](Vec2 p) {
      return k > 0 && stages_[k - 1].centres.nearest(p).distance < kOnWall;
    };
    Places shared_pieces;
    if (k > 0) shared_pieces = short_pieces_on(centres, stages_[k - 1].centres, spacing);
    for (std::size_t c = 0; c < centres.curves().size(); ++c) {
      const Curve& curve = centres.curves()[c];
      Track track{k, taken.samples.size(), 0};
      for (std::size_t i = 0; i < curve.segment_count(); ++i) {
        const Segment segment = curve.segment(i);
        std::vector<double> places = even_places(segment, spacing);
        // In rooms hardly larger than the tool what two stages share may lie between the samples.
        const auto pieces = shared_pieces.find({c, i});
        if (pieces != shared_pieces.end() &&
            std::none_of(places.begin(), places.end(),
                         [&](double t) { return is_shared(segment.point(t)); })) {
          places.insert(places.end(), pieces->second.begin(), pieces->second.end());
          std::sort(places.begin(), places.end());
        }
        for (const double t : places) {
          Sample sample;
          sample.place = {c, i, t};
          sample.p = segment.point(t);
          sample.stage = k;
          sample.track = taken.tracks.size();
          sample.shared = is_shared(sample.p);
          taken.samples.push_back(sample);
        }
      }
      track.count = taken.samples.size() - track.first;
      taken.tracks.push_back(track);
    }
  }
  return taken;
}

void WallSamples::take_samples(double spacing) {
  const std::size_t all = stages_.size();
  double length = 0;
  for (const Stage& stage : stages_)
    for (const Curve& curve : stage.centres.curves()) length += curve.length();
  if (all < 2 || length < kManySamples * spacing) {
    append(taken(0, all, spacing));
  } else {
    auto [before, after] = both([&] { return taken(0, all / 2, spacing); },
                                [&] { return taken(all / 2, all, spacing); });
    append(std::move(before));
    append(std::move(after));
  }
  for (const Track& track : tracks_) own_first_shared(track);
}

void WallSamples::append(Taken taken) {
  const std::size_t samples = samples_.size(), tracks = tracks_.size();
  for (Sample& sample : taken.samples) sample.track += tracks;
  for (Track& track : taken.tracks) track.first += samples;
  if (samples_.empty())
    samples_ = std::move(taken.samples);
  else
    samples_.insert(samples_.end(), std::make_move_iterator(taken.samples.begin()),
                    std::make_move_iterator(taken.samples.end()));
  tracks_.insert(tracks_.end(), taken.tracks.begin(), taken.tracks.end());
}

// Where a stage's own stretch of wall ends, the first sample that it shares with the stage before
// is its own as well. In a gap that widens the wall of the stage before begins further on than any
// sample of the stretch lies, and nothing else would lead there.
void WallSamples::own_first_shared(const Track& track) {
  std::vector<std::size_t> first;
  for (std::size_t i = track.first; i < track.first + track.count; ++i)
    if (samples_[i].shared && !samples_[neighbour(i, 1)].shared) first.push_back(i);
  for (const std::size_t i : first) samples_[i].shared = false;
}

// What lies within a tool's radius in an earlier stage is cut first.
void WallSamples::order_by_stage() {
  const double near = ground_.tool_radius();
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    Sample& sample = samples_[i];
    if (sample.shared || sample.stage == 0) continue;
    open_.visit(around(sample.p, near), [&](std::size_t other) {
      Sample& earlier = samples_[other];
      if (earlier.stage >= sample.stage || distance(earlier.p, sample.p) >= near) return;
      earlier.later.push_back(i);
      earlier.corner = true;
      ++sample.blockers;
    });
  }
}

bool WallSamples::blocks(const Sample& sample) { return !sample.clear && sample.failures < kTries; }

// The sample of the same track that comes `back` before this one.
std::size_t WallSamples::neighbour(std::size_t index, std::size_t back) const {
  const Track& track = tracks_[samples_[index].track];
  return track.first + (index - track.first + track.count - back % track.count) % track.count;
}

// Where the sample belongs among the edges.
void WallSamples::sort_in(std::size_t index) {
  const Sample& sample = samples_[index];
  const bool is_edge = is_open(sample) && blocks(sample) && !is_open(samples_[neighbour(index, 1)]);
  const auto put = [index](std::set<std::size_t>& set, bool into) {
    if (into)
      set.insert(index);
    else
      set.erase(index);
  };
  put(edges_, is_edge);
  put(edges_in_turn_, is_edge && sample.blockers == 0);
}

template <typename Edit>
void WallSamples::change(std::size_t index, Edit edit) {
  Sample& sample = samples_[index];
  const bool was_open = is_open(sample), blocked = blocks(sample);
  edit(sample);
  if (is_open(sample) != was_open) {
    uncleared_ = was_open ? uncleared_ - 1 : uncleared_ + 1;
    const Track& track = tracks_[sample.track];
    sort_in(neighbour(index, track.count - 1));
  }
  if (blocks(sample) != blocked)
    for (const std::size_t later : sample.later) {
      int& blockers = samples_[later].blockers;
      const bool waited = blockers > 0;
      blockers += blocked ? -1 : 1;
      if (waited != (blockers > 0)) sort_in(later);
    }
  sort_in(index);
}

void WallSamples::look(Sample& sample) {
  ground_.uncovered(sample.p, 0, 2 * kPi, scratch_);
  if (scratch_.empty()) {
    sample.clear = true;
    return;
  }
  const auto widest =
      std::max_element(scratch_.begin(), scratch_.end(),
                       [](const auto& a, const auto& b) { return a.width() < b.width(); });
  sample.witness = sample.p + (ground_.tool_radius() - kCoverTolerance) *
                                  unit(0.5 * (widest->low + widest->high));
  sample.has_witness = true;
}

void WallSamples::update(Vec2 low, Vec2 high) {
  const Bounds reached = grown({low, high}, 2 * ground_.tool_radius());
  open_.drop_if(reached, [&](std::size_t index) {
    const Sample& sample = samples_[index];
    if (!overlap(reached, {sample.p, sample.p})) return false;
    if (sample.has_witness && !ground_.is_cleared_since(sample.witness, 0)) return false;
    change(index, [this](Sample& changed) {
      if (!is_spent(changed)) changed.failures = 0;
      look(changed);
    });
    return sample.clear;
  });
}

void WallSamples::give_up(std::size_t sample) {
  change(sample, [](Sample& failed) { ++failed.failures; });
  if (samples_[sample].failures >= kTries) hand_over(samples_[sample]);
}

// The samples of the next stage that are shared with this one become its own.
void WallSamples::hand_over(const Sample& failed) {
  const double near = kSpacing * ground_.tool_radius();
  shared_.drop_if(around(failed.p, near), [&](std::size_t index) {
    const Sample& other = samples_[index];
    if (other.stage != failed.stage + 1 || distance(other.p, failed.p) >= near) return false;
    change(index, [this](Sample& taken_over) {
      taken_over.shared = false;
      look(taken_over);
    });
    if (!other.clear) open_.add(index, other.p);
    return true;
  });
}

void WallSamples::note_pass(std::size_t sample) {
  if (samples_[sample].clear) return;
  change(sample, [this](Sample& passed) {
    ++passed.passes;
    if (is_spent(passed)) passed.failures = kTries;
  });
  if (is_spent(samples_[sample])) hand_over(samples_[sample]);
}

// The last clear sample of the track before this one, if only samples shared with the stage before
// lie between: their stretch was looked at in that stage, at places a little apart from these.
const WallSamples::Sample* WallSamples::last_clear_before(std::size_t index) {
  const Track& track = tracks_[samples_[index].track];
  for (std::size_t back = 1; back <= std::min(kLookBack, track.count - 1); ++back) {
    Sample& sample = samples_[neighbour(index, back)];
    if (sample.clear) return &sample;
    if (!sample.shared) return nullptr;
    // No update looks at these.
    if (!sample.has_witness || ground_.is_cleared_point(sample.witness)) look(sample);
    if (sample.clear) return &sample;
  }
  return nullptr;
}

std::vector<PassStart> WallSamples::starts() {
  std::vector<PassStart> result = starts(edges_in_turn_);
  return result.empty() ? earliest(starts(edges_)) : result;
}

// Of starts in the order of their stages those that have none of an earlier stage nearby.
std::vector<PassStart> WallSamples::earliest(const std::vector<PassStart>& starts) const {
  std::vector<PassStart> result;
  for (const PassStart& start : starts) {
    const auto comes_first = [&](const PassStart& other) {
      return other.stage < start.stage &&
             distance(other.pose.p, start.pose.p) < ground_.tool_radius();
    };
    if (std::none_of(result.begin(), result.end(), comes_first)) result.push_back(start);
  }
  return result;
}

std::vector<PassStart> WallSamples::starts(const std::set<std::size_t>& from) {
  std::vector<PassStart> result;
  for (const std::size_t index : from) {
    const Sample& sample = samples_[index];
    const Sample* before = last_clear_before(index);
    if (!before) continue;
    const std::vector<Curve>& curves = stages_[sample.stage].centres.curves();
    const Segment wall = curves[before->place.curve].segment(before->place.segment);
    result.push_back({sample.stage,
                      before->place,
                      {before->p, angle_of(wall.tangent(before->place.t))},
                      index,
                      sample.corner});
  }
  return result;
}

}  // namespace evenload
