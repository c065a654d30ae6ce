#include "strategy/wall_samples.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace evenload {
namespace {

// Share of the tool's radius between samples.
constexpr double kSpacing = 0.08;
// A pass that came to nothing so often is not tried again.
constexpr int kTries = 3;
// So many samples back a clear place is looked for.
constexpr std::size_t kLookBack = 8;
// mm: samples this near to the border of the stage before are shared with it.
constexpr double kShared = 1e-4;

}  // namespace

WallSamples::WallSamples(const std::vector<Stage>& stages, const ClearedGround& ground)
    : stages_(stages), ground_(ground) {
  const double spacing = kSpacing * ground.tool_radius();
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const std::vector<Curve>& curves = stages[k].centres.curves();
    for (std::size_t c = 0; c < curves.size(); ++c) {
      Track track{k, samples_.size(), 0};
      for (std::size_t i = 0; i < curves[c].segment_count(); ++i) {
        const Segment segment = curves[c].segment(i);
        int n = std::max(1, static_cast<int>(std::ceil(segment.length() / spacing)));
        if (segment.is_arc())
          n = std::max(n, static_cast<int>(std::ceil(std::abs(segment.sweep) / 0.4)));
        for (int j = 0; j < n; ++j) {
          Sample sample;
          sample.place = {c, i, static_cast<double>(j) / n};
          sample.p = segment.point(sample.place.t);
          sample.stage = k;
          sample.shared = k > 0 && stages[k - 1].centres.nearest(sample.p).distance < kShared;
          samples_.push_back(sample);
        }
      }
      track.count = samples_.size() - track.first;
      tracks_.push_back(track);
    }
  }
  // What lies within a tool's radius in an earlier stage is cut first.
  const double near = ground.tool_radius();
  std::unordered_map<long long, std::vector<std::size_t>> cells;
  const auto key = [near](Vec2 p, int dx, int dy) {
    return (static_cast<long long>(std::floor(p.x / near)) + dx) * 1000003LL +
           static_cast<long long>(std::floor(p.y / near)) + dy;
  };
  for (std::size_t i = 0; i < samples_.size(); ++i)
    if (!samples_[i].shared) cells[key(samples_[i].p, 0, 0)].push_back(i);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (samples_[i].shared || samples_[i].stage == 0) continue;
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy) {
        const auto cell = cells.find(key(samples_[i].p, dx, dy));
        if (cell == cells.end()) continue;
        for (const std::size_t other : cell->second)
          if (samples_[other].stage < samples_[i].stage &&
              distance(samples_[other].p, samples_[i].p) < near) {
            samples_[i].earlier.push_back(other);
            samples_[other].corner = true;
          }
      }
  }
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
  const double reach = 2 * ground_.tool_radius();
  for (Sample& sample : samples_) {
    if (sample.clear || sample.shared) continue;
    if (sample.p.x < low.x - reach || sample.p.x > high.x + reach || sample.p.y < low.y - reach ||
        sample.p.y > high.y + reach)
      continue;
    if (sample.has_witness && !ground_.is_cleared_since(sample.witness, 0)) continue;
    sample.failures = 0;
    look(sample);
  }
}

void WallSamples::give_up(std::size_t sample) {
  const Sample& failed = samples_[sample];
  if (++samples_[sample].failures < kTries) return;
  const double near = kSpacing * ground_.tool_radius();
  for (Sample& other : samples_)
    if (other.shared && other.stage == failed.stage + 1 && distance(other.p, failed.p) < near) {
      other.shared = false;
      look(other);
    }
}

bool WallSamples::waits(const Sample& sample) const {
  return std::any_of(sample.earlier.begin(), sample.earlier.end(), [this](std::size_t i) {
    return !samples_[i].clear && samples_[i].failures < kTries;
  });
}

// The last clear sample of the track before its sample `i`, if only samples shared with the stage
// before lie between: their stretch was looked at in that stage, at places a little apart from
// these.
const WallSamples::Sample* WallSamples::last_clear_before(const Track& track, std::size_t i) const {
  for (std::size_t back = 1; back <= std::min(kLookBack, track.count - 1); ++back) {
    const Sample& sample = samples_[track.first + (i + track.count - back) % track.count];
    if (sample.clear) return &sample;
    if (!sample.shared) return nullptr;
    if (ground_.is_clear(sample.p)) return &sample;
  }
  return nullptr;
}

std::vector<PassStart> WallSamples::starts() const {
  std::vector<PassStart> result = starts(true);
  return result.empty() ? starts(false) : result;
}

std::vector<PassStart> WallSamples::starts(bool in_order) const {
  std::vector<PassStart> result;
  for (const Track& track : tracks_) {
    const std::vector<Curve>& curves = stages_[track.stage].centres.curves();
    for (std::size_t i = 0; i < track.count; ++i) {
      const std::size_t index = track.first + i;
      const Sample& sample = samples_[index];
      if (sample.clear || sample.shared || sample.failures >= kTries) continue;
      if (in_order && waits(sample)) continue;
      const Sample* before = last_clear_before(track, i);
      if (!before) continue;
      const Segment wall = curves[before->place.curve].segment(before->place.segment);
      result.push_back({track.stage,
                        before->place,
                        {before->p, angle_of(wall.tangent(before->place.t))},
                        index,
                        sample.corner});
    }
  }
  return result;
}

std::size_t WallSamples::uncleared_count() const {
  return static_cast<std::size_t>(std::count_if(
      samples_.begin(), samples_.end(), [](const Sample& s) { return !s.clear && !s.shared; }));
}

}  // namespace evenload
