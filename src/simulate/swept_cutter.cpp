#include "simulate/swept_cutter.h"

#include <algorithm>

#include "simulate/move_pieces.h"

namespace evenload {
namespace {

constexpr double kAtRim = 1e-12;      // of the radius: what is at the rim but for that is reached
constexpr int kMostSecants = 60;      // halving alone would have a double's precision by then
constexpr double kUprightRun = 1e-9;  // mm in plan: what is shorter stands upright

// mm along a line that rises by `slope` > 0, from the place next to `at` backwards, to where a
// tool with a flat and a rounded corner is lowest over `at`, `aside` mm off the line.
double behind(const Cutter& cutter, double aside, double slope) {
  const double reach = std::sqrt(std::max(0.0, (cutter.radius - aside) * (cutter.radius + aside)));
  if (cutter.corner == 0) return reach;
  if (cutter.flat() == 0) return slope * reach / std::sqrt(1 + slope * slope);
  // The rise's slope along the line less that of the line, times what is positive: it grows.
  const auto excess = [&](double s) {
    const double d = std::hypot(aside, s), beyond = std::max(0.0, d - cutter.flat());
    const double height =
        std::sqrt(std::max(0.0, (cutter.corner - beyond) * (cutter.corner + beyond)));
    return beyond * s - slope * d * height;
  };
  double low = std::sqrt(std::max(0.0, (cutter.flat() - aside) * (cutter.flat() + aside)));
  double high = reach, at_low = excess(low), at_high = excess(high);
  int side = 0;
  for (int i = 0; i < kMostSecants && high - low > kAlongShare * cutter.radius; ++i) {
    if (!(at_low < 0 && at_high > 0)) break;
    const double s = (low * at_high - high * at_low) / (at_high - at_low);
    const double value = excess(s);
    // An end that stays twice weighs half (Illinois), or the other would crawl.
    if (value < 0) {
      low = s, at_low = value;
      if (side < 0) at_high *= 0.5;
      side = -1;
    } else {
      high = s, at_high = value;
      if (side > 0) at_low *= 0.5;
      side = 1;
    }
  }
  return at_low < 0 ? high : low;
}

// The underside of the tool whose tip stands at a share of a piece.
Underside at_share(const Cutter& cutter, const CutterRun& run, double share, Vec2 at) {
  const double d = distance(run.path.point(share), at);
  if (d > cutter.radius * (1 + kAtRim)) return {};
  return {run.z0 + share * (run.z1 - run.z0) + cutter.rise(std::min(d, cutter.radius)),
          share * run.length};
}

// Of teeth, the lower one of those on both sides of a share.
Underside by_teeth(const Cutter& cutter, const CutterRun& run, double share, Vec2 at) {
  if (run.first > run.length) return {};
  const double last = std::floor((run.length - run.first) / run.pitch);
  const double before =
      std::clamp(std::floor((share * run.length - run.first) / run.pitch), 0.0, last);
  const auto tooth = [&](double k) {
    return at_share(cutter, run, (run.first + k * run.pitch) / run.length, at);
  };
  const Underside a = tooth(before), b = tooth(std::min(last, before + 1));
  return b.z < a.z ? b : a;
}

// The share of a line at which the tool is lowest over `at`; negative where it does not reach it.
double lowest_on_line(const Cutter& cutter, const CutterRun& run, Vec2 at) {
  const Vec2 way = run.path.b - run.path.a;
  const double length = norm(way);
  if (length < kUprightRun) {
    if (distance(run.path.a, at) > cutter.radius) return -1;
    return run.z1 < run.z0 ? 1 : 0;
  }
  const Vec2 u = way / length, from = at - run.path.a;
  const double aside = std::abs(cross(u, from)), next = dot(u, from);
  if (aside >= cutter.radius) return -1;
  const double reach = std::sqrt((cutter.radius - aside) * (cutter.radius + aside));
  const double low = std::max(0.0, next - reach), high = std::min(length, next + reach);
  if (low > high) return -1;
  const double slope = (run.z1 - run.z0) / length;
  double wanted = next;
  if (slope != 0) {
    const double back = behind(cutter, aside, std::abs(slope));
    wanted -= slope > 0 ? back : -back;
  }
  return std::clamp(wanted, low, high) / length;
}

// Pieces of a helix as lines on its inner side.
void add_lines(const MovePiece& piece, std::vector<MovePiece>& into) {
  const double bent = 2 * std::acos(1 - std::min(1.0, kSagitta / piece.path.radius));
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(piece.path.sweep) / bent)));
  for (int k = 0; k < count; ++k) {
    const double t0 = static_cast<double>(k) / count, t1 = static_cast<double>(k + 1) / count;
    into.push_back({Segment::line(piece.path.point(t0), piece.path.point(t1)),
                    piece.z0 + t0 * (piece.z1 - piece.z0), piece.z0 + t1 * (piece.z1 - piece.z0)});
  }
}

std::vector<MovePiece> lines_and_level_arcs(const Move& from, const Move& to) {
  std::vector<MovePiece> pieces;
  for (const MovePiece& piece : pieces_of(from, to)) {
    if (piece.path.is_arc() && piece.z0 != piece.z1)
      add_lines(piece, pieces);
    else
      pieces.push_back(piece);
  }
  return pieces;
}

}  // namespace

Underside underside(const Cutter& cutter, const CutterRun& run, Vec2 at) {
  const double share = run.path.is_arc() ? run.path.nearest(at) : lowest_on_line(cutter, run, at);
  if (share < 0) return {};
  return run.pitch > 0 ? by_teeth(cutter, run, share, at) : at_share(cutter, run, share, at);
}

std::vector<CutterRun> cutter_runs(const std::vector<Move>& moves, double teeth_per_minute) {
  std::vector<CutterRun> runs;
  double begin = 0, teeth = 0;  // mm, and teeth that have passed, a share of one with them
  for (std::size_t i = 1; i < moves.size(); ++i) {
    const Move& to = moves[i];
    for (const MovePiece& piece : lines_and_level_arcs(moves[i - 1], to)) {
      CutterRun run{piece.path, piece.z0, piece.z1, begin, 0, 0, 0, static_cast<std::int32_t>(i)};
      const double in_plan = piece.path.length();
      run.length = std::hypot(in_plan, piece.z1 - piece.z0);
      if (teeth_per_minute > 0 && to.kind != MoveKind::kRapid && in_plan > kUprightRun) {
        run.pitch = to.feed / teeth_per_minute;
        run.first = (std::ceil(teeth) - teeth) * run.pitch;
        teeth += run.length / run.pitch;
      }
      begin += run.length;
      runs.push_back(run);
    }
  }
  return runs;
}

}  // namespace evenload
