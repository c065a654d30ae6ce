#include "feed/load_profile.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cutting/probe.h"
#include "support/both.h"
#include "support/tolerances.h"
#include "toolpath/machinable.h"
#include "toolpath/ramp.h"

namespace evenload {
namespace {

// Samples whose engagements, and whose widths and shares in proportion to the larger, differ less
// than this are alike.
constexpr double kLikeEngagement = 2 * kPi / 180;
constexpr double kLikeWidth = 0.01;
constexpr double kLikeShare = 0.01;
// Share of the tool's radius: widths below are too little to be told apart.
constexpr double kThinWidth = 0.02;
// Shares below allow ten times the nominal feed, more than any maximum feed in use.
constexpr double kSmallShare = 0.1;
// mm: between looks that differ more no two are further apart, unless the front is smooth,
constexpr double kCoarseLook = 0.1;
// and none nearer, but on moves so short that a fifth of them is less.
constexpr double kFinestLook = 0.02;
// Of unit vectors along the path at a joint: what is met there is hidden by the move before, whose
// end clears all of the tool's circle, and next to that before it.
constexpr double kRunsOn = 0.02;
// Share of the tool's radius: in tighter turns passes lie so close to each other that rounding to
// kPosted mm moves the places where their circles cross by degrees. So what is shared there is what
// a tool larger by that would meet, of the same pieces of material, each end further by no more
// than kMostDoubt rad.
constexpr double kTightTurn = 0.06;
constexpr double kPosted = 1.5e-4;
constexpr double kMostDoubt = 3 * kPi / 180;
// Of the square of half the turn from one line to the next, where lines are posted for an arc: what
// is met along a line rises from so much less to so much more, and what is removed grows with its
// square.
constexpr double kLineShare = 1.0 / 3;
// mm of cuts: less is not worth a second core;
constexpr double kWorthHalving = 100;
// and the share of them that one of the two looks at: the other has the ground to make as well.
constexpr double kFirstHalf = 0.58;

}  // namespace

void add_descent(const Descent& descent, ClearedGround& ground) {
  if (descent.kind == DescentKind::kHelix)
    ground.add(Segment::line(descent.centre - descent.stretch, descent.centre + descent.stretch),
               descent.radius + ground.tool_radius());
  else if (descent.kind == DescentKind::kRamp)
    for (const Segment& line : ramp_round(descent)) ground.add(line);
}

namespace {

// mm
double like_width(const Load& a, const Load& b, double radius) {
  return kLikeWidth * std::max({a.width, b.width, kThinWidth * radius});
}

double like_share(const Load& a, const Load& b) {
  return kLikeShare * std::max({a.share, b.share, kSmallShare});
}

bool alike(const Load& a, const Load& b, double radius) {
  return std::abs(a.engagement - b.engagement) < kLikeEngagement &&
         std::abs(a.width - b.width) < like_width(a, b, radius) &&
         std::abs(a.share - b.share) < like_share(a, b);
}

Load mean(const Load& a, const Load& b) {
  return {0.5 * (a.engagement + b.engagement), 0.5 * (a.width + b.width), 0.5 * (a.chip + b.chip),
          0.5 * (a.share + b.share)};
}

// The parabola through the loads at 0, 1/2 and 1, never below zero.
Load between(const Load& at0, const Load& middle, const Load& at1, double t) {
  const double a = (1 - t) * (1 - 2 * t), b = 4 * t * (1 - t), c = t * (2 * t - 1);
  const auto along = [&](double Load::*what) {
    return std::max(0.0, a * at0.*what + b * middle.*what + c * at1.*what);
  };
  return {along(&Load::engagement), along(&Load::width), along(&Load::chip), along(&Load::share)};
}

// rad: between the lines that are posted for an arc that is too tight; 0 for other moves.
double turn_of_lines(const Segment& move) {
  return is_tight(move) ? std::abs(move.sweep) / lines_in_place_of(move.radius, move.sweep) : 0;
}

// Looks along one move, finer where the load bends.
class MoveProfile {
 public:
  MoveProfile(const ClearedGround& ground, const PlanarMove& move, const LoadSample& where,
              const LoadShare& share, std::vector<LoadSample>& out)
      : ground_(ground),
        segment_(move.segment),
        length_(move.segment.length()),
        line_turn_(turn_of_lines(move.segment)),
        where_(where),
        share_(share),
        out_(out) {}

  // `at_start`: what is met there, where it is known; it is hidden by the move before, so that it
  // is looked for a little further on otherwise. Returns what is met at the end.
  LoadAtPlace cover(double spacing, const LoadAtPlace* at_start) {
    const std::size_t last = ground_.size() - (at_start ? 1 : 0);
    LoadAtPlace before = at_start ? *at_start : met_at(std::min(0.1, 0.5 * kFinestLook / length_));
    const int n = looks_along(length_, kSmoothSpacing * spacing);
    for (int k = 0; k < n; ++k) {
      const double t0 = static_cast<double>(k) / n, t1 = static_cast<double>(k + 1) / n;
      const LoadAtPlace after = met_at(t1);
      if (before.edge && after.edge &&
          ground_.is_smooth_between(*before.edge, *after.edge, last, kMostTurnOfFront))
        cover(t0, before.load, t1, after.load, k == 0, true);
      else
        cover_closely(t0, before.load, t1, after.load, spacing);
      before = after;
    }
    return before;
  }

 private:
  void cover_closely(double t0, const Load& at0, double t1, const Load& at1, double spacing) {
    const int n = looks_along((t1 - t0) * length_, spacing);
    Load before = at0;
    for (int k = 0; k < n; ++k) {
      const double from = t0 + (t1 - t0) * k / n, to = t0 + (t1 - t0) * (k + 1) / n;
      const Load after = k + 1 < n ? load_at(to) : at1;
      cover(from, before, to, after, from == 0, false);
      before = after;
    }
  }

  // Asks what is met at `t`, as engaged_; returns the heading there.
  double look(double t) {
    const double heading = angle_of(segment_.tangent(t));
    engaged_ = probe_.arcs(segment_.point(t), heading, kThin);
    return heading;
  }

  LoadAtPlace met_at(double t) {
    const double heading = look(t);
    LoadAtPlace met;
    if (engaged_.size() == 1 && engaged_.front().low < heading - kPi / 2 + kSame)
      met.edge = segment_.point(t) + (ground_.tool_radius() - kThin) * unit(engaged_.front().high);
    met.load = load_of(t, heading);
    return met;
  }

  Load load_at(double t) { return load_of(t, look(t)); }

  // Of what was met at `t`: engaged_, which become angles from the heading.
  Load load_of(double t, double heading) {
    Load load;
    for (AngularInterval& arc : engaged_) {
      arc = {arc.low - heading, arc.high - heading};
      load.engagement += arc.width();
      load.width += ground_.tool_radius() * (std::sin(arc.high) - std::sin(arc.low));
      const bool holds_front = arc.low <= 0 && arc.high >= 0;
      load.chip =
          std::max(load.chip, holds_front ? 1.0 : std::max(std::cos(arc.low), std::cos(arc.high)));
    }
    if (!share_ || engaged_.empty()) return load;
    Load posted = load;
    if (segment_.is_arc() && segment_.radius < kTightTurn * ground_.tool_radius())
      widen(segment_.point(t), heading, posted);
    load.share = share_(posted, engaged_);
    return load;
  }

  // Makes the arcs that are met at `p` as long as rounding may make them, and with them the width
  // of `load`.
  void widen(Vec2 p, double heading, Load& load) {
    const std::vector<AngularInterval>& posted = probe_.arcs(p, heading, -kPosted);
    double width = 0;
    for (AngularInterval& arc : engaged_) {
      for (const AngularInterval& larger : posted) {
        const double low = larger.low - heading, high = larger.high - heading;
        if (high < arc.low || low > arc.high) continue;
        arc.low = std::clamp(low, arc.low - kMostDoubt, arc.low);
        arc.high = std::clamp(high, arc.high, arc.high + kMostDoubt);
      }
      const double met = arc.width(), more = kLineShare * line_turn_ * line_turn_ / 4;
      arc.high += std::sqrt(met * met + more) - met;
      width += ground_.tool_radius() * (std::sin(arc.high) - std::sin(arc.low));
    }
    load.width = std::max(load.width, width);
  }

  // `begins`: whether the piece begins the move. There the path's curvature jumps, and the load
  // bends: it may rise and be down again before the middle. `smooth`: the front that is met.
  void cover(double t0, const Load& at0, double t1, const Load& at1, bool begins, bool smooth) {
    const double t = 0.5 * (t0 + t1), piece = (t1 - t0) * length_;
    const Load middle = load_at(t);
    const double radius = ground_.tool_radius();
    const bool flat = alike(at0, middle, radius) && alike(middle, at1, radius);
    const bool straight = (smooth || piece <= kCoarseLook) && alike(mean(at0, at1), middle, radius);
    const auto bends = [&] {
      return begins && piece > kCoarseLook &&
             !alike(load_at(0.5 * (t0 + t)), between(at0, middle, at1, 0.25), radius);
    };
    if (piece > std::min(kFinestLook, 0.2 * length_) && ((!flat && !straight) || bends())) {
      cover(t0, at0, t, middle, begins, smooth);
      cover(t, middle, t1, at1, false, smooth);
      return;
    }
    const double steps = std::max({std::abs(at1.engagement - at0.engagement) / kLikeEngagement,
                                   std::abs(at1.width - at0.width) / like_width(at0, at1, radius),
                                   std::abs(at1.share - at0.share) / like_share(at0, at1)});
    const int n = std::max(1, static_cast<int>(std::min(std::ceil(steps), piece / kFinestLook)));
    for (int k = 0; k < n; ++k) {
      const double s0 = static_cast<double>(k) / n, s1 = static_cast<double>(k + 1) / n;
      const Load a = between(at0, middle, at1, s0), b = between(at0, middle, at1, 0.5 * (s0 + s1)),
                 c = between(at0, middle, at1, s1);
      LoadSample sample = where_;
      sample.t = t0 + 0.5 * (s0 + s1) * (t1 - t0);
      sample.length = piece / n;
      sample.engagement = (a.engagement + 4 * b.engagement + c.engagement) / 6;
      sample.width = (a.width + 4 * b.width + c.width) / 6;
      sample.chip = std::max({a.chip, b.chip, c.chip});
      sample.share = std::max({a.share, b.share, c.share});
      out_.push_back(sample);
    }
  }

  const ClearedGround& ground_;
  const Segment& segment_;
  double length_;
  double line_turn_;  // rad: between the lines that are posted in the move's place; 0 for others
  LoadSample where_;
  const LoadShare& share_;
  std::vector<LoadSample>& out_;
  Probe probe_{ground_};
  std::vector<AngularInterval> engaged_;
};

// True when the tool runs on without a turn: what it meets at the joint is what it met before.
bool runs_on(const PlanarMove& before, const PlanarMove& after) {
  return before.kind == MoveKind::kCut && after.kind == MoveKind::kCut &&
         norm(before.segment.tangent(1) - after.segment.tangent(0)) < kRunsOn;
}

}  // namespace

void LoadProfiler::come_down(const Descent& descent) {
  add_descent(descent, ground_);
  ++runs_;
  moves_ = 0;
  before_.reset();
}

void LoadProfiler::look_along(const PlanarMove& move) {
  const LoadSample where{runs_ - 1, moves_, 0.5, move.segment.length(), 0, 0, 0, 0};
  if (move.kind == MoveKind::kCut) {
    const LoadAtPlace* at_start = before_ && runs_on(*before_, move) ? &met_ : nullptr;
    met_ = MoveProfile(ground_, move, where, share_, profile_).cover(spacing_, at_start);
  } else {
    profile_.push_back(where);
  }
  pass_by(move);
}

void LoadProfiler::pass_by(const PlanarMove& move) {
  ground_.add(move.segment);
  before_ = move;
  ++moves_;
}

namespace {

// A move of the path, by its run.
struct Place {
  std::size_t run = 0, move = 0;
};

bool operator<(Place a, Place b) { return std::pair(a.run, a.move) < std::pair(b.run, b.move); }

// Cuts all moves before `from`, then those before `end`, of which the load is returned.
std::vector<LoadSample> profile_between(const std::vector<PlanarRun>& runs, Place from, Place end,
                                        ClearedGround& ground, double spacing,
                                        const LoadShare& share) {
  LoadProfiler profiler(ground, spacing, share);
  for (std::size_t i = 0; i < runs.size() && Place{i, 0} < end; ++i) {
    profiler.come_down(runs[i].descent);
    for (std::size_t j = 0; j < runs[i].moves.size() && Place{i, j} < end; ++j)
      if (Place{i, j} < from)
        profiler.pass_by(runs[i].moves[j]);
      else
        profiler.look_along(runs[i].moves[j]);
  }
  return profiler.taken();
}

// Where a second core may begin: about half of the way to be cut comes before, and the load there
// follows from no load before. Past the last move where there is no such place, or too little to
// do.
Place second_half(const std::vector<PlanarRun>& runs) {
  const Place past{runs.size(), 0};
  double whole = 0;
  for (const PlanarRun& run : runs)
    for (const PlanarMove& move : run.moves)
      if (move.kind == MoveKind::kCut) whole += move.segment.length();
  if (whole < kWorthHalving) return past;
  double before = 0;
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (std::size_t j = 0; j < runs[i].moves.size(); ++j) {
      const PlanarMove& move = runs[i].moves[j];
      const bool begins_anew = j == 0 || !runs_on(runs[i].moves[j - 1], move);
      if (begins_anew && before > kFirstHalf * whole) return {i, j};
      if (move.kind == MoveKind::kCut) before += move.segment.length();
    }
  return past;
}

}  // namespace

std::vector<LoadSample> load_profile(const std::vector<PlanarRun>& runs, ClearedGround& ground,
                                     double spacing, const LoadShare& share, Progress* progress) {
  const Place past{runs.size(), 0}, half = second_half(runs);
  if (!(half < past)) return profile_between(runs, {}, past, ground, spacing, share);
  ClearedGround first = ground;
  auto [profile, after] =
      both([&] { return profile_between(runs, {}, half, first, spacing, share); },
           [&] { return profile_between(runs, half, past, ground, spacing, share); }, progress);
  profile.insert(profile.end(), after.begin(), after.end());
  return std::move(profile);
}

double worst_engagement(const std::vector<PlanarRun>& runs, const std::vector<LoadSample>& profile,
                        double window) {
  double worst = 0, length = 0, sum = 0;
  std::size_t first = 0;
  const auto cuts = [&](const LoadSample& s) {
    return runs[s.run].moves[s.move].kind == MoveKind::kCut;
  };
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (!cuts(profile[i]) || (i && profile[i].run != profile[i - 1].run)) {
      first = cuts(profile[i]) ? i : i + 1;
      length = sum = 0;
      if (!cuts(profile[i])) continue;
    }
    length += profile[i].length;
    sum += profile[i].engagement * profile[i].length;
    while (first < i && length - profile[first].length >= window) {
      length -= profile[first].length;
      sum -= profile[first].engagement * profile[first].length;
      ++first;
    }
    // The window ends with this sample and begins within the first.
    const double beyond = std::max(0.0, length - window);
    worst = std::max(worst, (sum - beyond * profile[first].engagement) / window);
  }
  return worst;
}

}  // namespace evenload
