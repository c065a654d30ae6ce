#include "surface/ground.h"

#include <algorithm>
#include <cmath>

namespace evenload {

namespace {

// mm between a sample and the chord of two others, in the line's upright plane.
double off_chord(const DropSample& a, const DropSample& b, const DropSample& p) {
  const Vec2 chord{b.s - a.s, b.z - a.z};
  return std::abs(cross(chord, Vec2{p.s - a.s, p.z - a.z})) / norm(chord);
}

// The sample at work next to the border between one that is and one that is not.
DropSample border_between(const Ground& ground, const PlanLine& line, DropSample at_work,
                          DropSample beyond) {
  while (std::abs(at_work.s - beyond.s) > kBorder) {
    const DropSample middle = sample_at(ground, line, 0.5 * (at_work.s + beyond.s), at_work.facet);
    (middle.is_at_work ? at_work : beyond) = middle;
  }
  return at_work;
}

constexpr int kTogether = 4;            // pieces of a line whose ground is looked for at once
constexpr double kRounding = 1 + 1e-9;  // of their lengths
constexpr double kSameHeight = 1e-6;    // mm: the tool stands on what it stands on alone

// Whether the tool is to cut where it touches so.
bool is_at_work_at(const Ground& ground, Vec2 at, const ToolContact& contact) {
  if (!ground.extension)
    return ground.by_contact ? contact.touches && contact.is_within
                             : is_under_picked(*ground.mesh, at);
  if (!ground.by_contact && is_under_picked(*ground.mesh, at)) return true;
  const ToolContact own = drop(ground.extension->own(), ground.cutter.grown(ground.allowance), at,
                               ground.floor - ground.allowance);
  return own.touches && contact.z < own.z + kSameHeight &&
         ground.extension->reaches(ground.by_contact ? plan(own.point) : at);
}

// The sample where the tool touches the part so.
DropSample sample_of(const Ground& ground, double s, Vec2 at, const ToolContact& contact) {
  const double z = contact.z + ground.allowance;
  if (ground.fixtures) {
    const double clearance = ground.fixture_clearance;
    const ToolContact over =
        drop(*ground.fixtures, ground.cutter.grown(clearance), at, ground.floor - clearance);
    if (over.touches && over.z + clearance > z)
      return {s, over.z + clearance, false, true, contact.facet};
  }
  return {s, z, is_at_work_at(ground, at, contact), false, contact.facet};
}

// Of a stretch of a line around `middle`, mm along it, `half` to both sides.
class Sampling {
 public:
  Sampling(const Ground& ground, const PlanLine& line, double middle, double half, double tolerance,
           Sampled sampled)
      : ground_(ground),
        line_(line),
        window_(*ground.mesh, ground.cutter.grown(ground.allowance), line.at(middle), half,
                ground.floor - ground.allowance),
        near_(kChordShare * tolerance),
        shortest_(kJumpShare * tolerance),
        sampled_(sampled) {}

  DropSample at(double s, const DropSample& beside) const {
    const Vec2 place = line_.at(s);
    return sample_of(ground_, s, place, window_.drop(place, beside.facet));
  }

  // Adds the samples after `a`, up to `b`.
  void add(const DropSample& a, const DropSample& middle, const DropSample& b,
           std::vector<DropSample>& samples) const {
    const DropSample first = at(0.5 * (a.s + middle.s), a);
    const DropSample second = at(0.5 * (middle.s + b.s), middle);
    const bool matters = does_matter(a) || does_matter(first) || does_matter(middle) ||
                         does_matter(second) || does_matter(b);
    const double off =
        std::max({off_chord(a, b, first), off_chord(a, b, middle), off_chord(a, b, second)});
    if (!matters || off <= near_ || b.s - a.s <= shortest_) {
      samples.insert(samples.end(), {first, middle, second, b});
      return;
    }
    add(a, first, middle, samples);
    add(middle, second, b, samples);
  }

 private:
  bool does_matter(const DropSample& sample) const {
    return sampled_ == Sampled::kLink || sample.is_at_work || sample.is_kept_off;
  }

  const Ground& ground_;
  const PlanLine& line_;
  DropWindow window_;
  double near_, shortest_;
  Sampled sampled_;
};

}  // namespace

Vec2 PlanLine::at(double s) const {
  if (bend == 0) return from + s * along;
  const double half = 0.5 * bend * s;
  return from + (2 * std::sin(half) / bend) *
                    (std::cos(half) * along + std::sin(half) * left_normal(along));
}

DropSample sample_at(const Ground& ground, const PlanLine& line, double s, std::uint32_t beside) {
  const Vec2 at = line.at(s);
  return sample_of(ground, s, at,
                   drop(*ground.mesh, ground.cutter.grown(ground.allowance), at,
                        ground.floor - ground.allowance, beside));
}

double spacing_of(const Cutter& cutter, double tolerance) {
  const double bump = 2 * std::sqrt(2 * cutter.corner * tolerance) + 2 * cutter.flat();
  return std::min(0.5 * cutter.radius, bump);
}

std::vector<DropSample> samples_along(const Ground& ground, const PlanLine& line, double begin,
                                      double end, double tolerance, Sampled sampled) {
  // Each piece has four quarters; a bump is as high as the square of its width.
  const double spacing = 4 * std::sqrt(kBumpShare) * spacing_of(ground.cutter, tolerance);
  const int pieces = std::max(1, static_cast<int>(std::ceil((end - begin) / spacing)));
  const double length = (end - begin) / pieces;
  std::vector<DropSample> samples{sample_at(ground, line, begin)};
  for (int next = 0; next < pieces;) {
    const int first = next, count = std::min(kTogether, pieces - first);
    const double half = 0.5 * count * length;
    const Sampling sampling(ground, line, begin + first * length + half, half * kRounding,
                            tolerance, sampled);
    for (; next < first + count; ++next) {
      const DropSample a = samples.back();
      const DropSample b = sampling.at(begin + (end - begin) * (next + 1) / pieces, a);
      sampling.add(a, sampling.at(0.5 * (a.s + b.s), b), b, samples);
    }
  }
  return samples;
}

std::vector<std::vector<DropSample>> parts_at_work(const Ground& ground, const PlanLine& line,
                                                   const std::vector<DropSample>& samples) {
  std::vector<std::vector<DropSample>> parts;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!samples[i].is_at_work) continue;
    std::vector<DropSample> part;
    if (i > 0) part.push_back(border_between(ground, line, samples[i], samples[i - 1]));
    for (; i < samples.size() && samples[i].is_at_work; ++i)
      if (part.empty() || samples[i].s > part.back().s) part.push_back(samples[i]);
    if (i < samples.size()) {
      const DropSample last = border_between(ground, line, samples[i - 1], samples[i]);
      if (last.s > part.back().s) part.push_back(last);
    }
    if (part.size() > 1) parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace evenload
