#include "toolpath/assemble.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "toolpath/helix.h"
#include "toolpath/ramp.h"

namespace evenload {
namespace {

// mm above a level's top to which rapids go down before a descent.
constexpr double kApproach = 0.5;
// Share of a link over which it rises, and sinks, when links are lifted.
constexpr double kLiftShare = 0.25;
// Rise and fall of a lifted link per mm of way: short links are lifted less.
constexpr double kSteepestLift = 0.3;

double helical_length(double dx, double dy, double dz, double sweep, double cx, double cy, double x,
                      double y) {
  const double flat =
      sweep != 0 ? std::abs(sweep) * std::hypot(x - cx, y - cy) : std::hypot(dx, dy);
  return std::hypot(flat, dz);
}

class Assembler {
 public:
  explicit Assembler(const AssemblyParams& params) : params_(params) {}

  std::vector<Move> build(const std::vector<PlanarRun>& runs) {
    std::vector<std::size_t> firsts;  // the first run of each region
    for (std::size_t i = 0; i < runs.size(); ++i)
      if (i == 0 || runs[i].new_region) firsts.push_back(i);
    firsts.push_back(runs.size());
    const std::size_t regions = firsts.size() - 1, levels = params_.levels.size();
    for (std::size_t k = 0; k < regions * levels; ++k) {
      const bool by_depth = params_.order_by == OrderBy::kDepth;
      const std::size_t region = by_depth ? k % regions : k / levels;
      const std::size_t level = by_depth ? k / regions : k % levels;
      const bool comes_from_another = by_depth ? regions > 1 : level == 0;
      if (!moves_.empty() && comes_from_another) rapid_z(params_.clearance_height);
      const double top = level == 0 ? params_.top : params_.levels[level - 1];
      for (std::size_t i = firsts[region]; i < firsts[region + 1]; ++i)
        add_run(runs[i], top, params_.levels[level]);
    }
    if (!moves_.empty()) rapid_z(params_.clearance_height);
    return std::move(moves_);
  }

 private:
  void add_run(const PlanarRun& run, double top, double level) {
    begin(run.descent, top, level);
    for (std::size_t i = 0; i < run.moves.size();) {
      std::size_t end = i;
      while (end < run.moves.size() && run.moves[end].kind == run.moves[i].kind) ++end;
      if (run.moves[i].kind == MoveKind::kLink) {
        link(run.moves, i, end, level, top);
      } else {
        for (std::size_t j = i; j < end; ++j)
          go(run.moves[j].segment, MoveKind::kCut, level, run.moves[j].feed);
      }
      i = end;
    }
    rapid_z(params_.safe_height);
  }

  void rapid_z(double z) {
    Move move = at_;
    move.kind = MoveKind::kRapid;
    move.z = z;
    move.sweep = 0;
    move.feed = 0;
    push(move);
  }
  void rapid_xy(Vec2 p) {
    Move move = at_;
    move.kind = MoveKind::kRapid;
    move.x = p.x;
    move.y = p.y;
    move.sweep = 0;
    move.feed = 0;
    push(move);
  }
  void push(const Move& move) {
    moves_.push_back(move);
    at_ = move;
  }

  void line(Vec2 p, double z, MoveKind kind, double feed) {
    Move move;
    move.kind = kind;
    move.x = p.x;
    move.y = p.y;
    move.z = z;
    move.feed = feed;
    push(move);
  }

  // Along `segment` from the present height to `z`.
  void go(const Segment& segment, MoveKind kind, double z, double feed) {
    if (!segment.is_arc()) {
      line(segment.b, z, kind, feed);
      return;
    }
    const double z0 = at_.z;
    if (params_.arcs) {
      const int parts = std::abs(segment.sweep) > kPi * 1.0001 ? 2 : 1;
      for (int i = 1; i <= parts; ++i) {
        const Vec2 p = i == parts ? segment.b : segment.point(static_cast<double>(i) / parts);
        Move move;
        move.kind = kind;
        move.x = p.x;
        move.y = p.y;
        move.z = z0 + (z - z0) * i / parts;
        move.sweep = segment.sweep / parts;
        move.cx = segment.centre.x;
        move.cy = segment.centre.y;
        move.feed = feed;
        push(move);
      }
      return;
    }
    // A wall, if there is one, lies to the right in climb milling: left turns by chords, right
    // turns by tangents.
    const double ratio = 1 - std::min(0.5, params_.tolerance / segment.radius);
    const int n =
        std::max(1, static_cast<int>(std::ceil(std::abs(segment.sweep) / (2 * std::acos(ratio)))));
    const double half = segment.sweep / n / 2;
    if ((segment.sweep > 0) != params_.wall_on_left) {
      for (int i = 1; i < n; ++i)
        line(segment.point(static_cast<double>(i) / n), z0 + (z - z0) * i / n, kind, feed);
    } else {
      for (int i = 0; i < n; ++i)
        line(segment.centre +
                 segment.radius / std::cos(half) * unit(segment.start_angle + (2 * i + 1) * half),
             z0 + (z - z0) * (i + 0.5) / n, kind, feed);
    }
    line(segment.b, z, kind, feed);
  }

  void link(const std::vector<PlanarMove>& moves, std::size_t first, std::size_t last, double level,
            double top) {
    double whole = 0;
    for (std::size_t i = first; i < last; ++i) whole += moves[i].segment.length();
    const double slope = kLiftShare * whole;
    const double lift =
        std::min({params_.link_lift, std::max(0.0, top - level), kSteepestLift * slope});
    if (lift <= 0) {
      for (std::size_t i = first; i < last; ++i)
        go(moves[i].segment, MoveKind::kLink, level, moves[i].feed);
      return;
    }
    const auto height = [&](double s) {
      return level + lift * std::clamp(std::min(s, whole - s) / slope, 0.0, 1.0);
    };
    double done = 0;
    for (std::size_t i = first; i < last; ++i) {
      const Segment& segment = moves[i].segment;
      const double length = segment.length();
      double t0 = 0;
      for (const double stop : {slope, whole - slope, done + length}) {
        const double t1 = std::min(1.0, (stop - done) / length);
        if (t1 <= t0 + 1e-9) continue;
        go(segment.part(t0, t1), MoveKind::kLink, height(done + t1 * length), moves[i].feed);
        t0 = t1;
      }
      done += length;
    }
  }

  void begin(const Descent& descent, double top, double level) {
    const double from = std::min(params_.safe_height, top + kApproach);
    // Air is no reason to go round and round.
    const double contact = std::min(from, top + kAboveMaterial);
    const bool is_helix = descent.kind == DescentKind::kHelix;
    const std::vector<Segment> slope =
        is_helix ? slope_of(descent, contact - level) : std::vector<Segment>{};
    const Vec2 start = is_helix ? slope.front().a : descent.at;
    if (moves_.empty()) {
      Move move;
      move.kind = MoveKind::kRapid;
      move.x = start.x;
      move.y = start.y;
      move.z = params_.clearance_height;
      push(move);
    } else {
      rapid_xy(start);
    }
    if (descent.kind == DescentKind::kPlunge) {
      rapid_z(from);
      if (descent.over_cleared_ground)
        line(start, level, MoveKind::kLink, params_.link_feed);
      else
        line(start, level, MoveKind::kEntry, params_.entry.plunge);
      return;
    }
    rapid_z(from);
    if (contact < from) line(start, contact, MoveKind::kEntry, params_.entry.plunge);
    if (is_helix)
      helix(descent, slope, top, contact, level);
    else
      ramp(descent, contact, level);
  }

  // Half turns, which FreeCAD's dressups follow most exactly, that descend by `depth`.
  std::vector<Segment> slope_of(const Descent& descent, double depth) const {
    const double half = half_turn_length(descent);
    const double half_turns = std::ceil(depth / (std::tan(params_.helix_angle) * half) - 1e-9);
    return way_round(descent, std::max(1.0, half_turns) * half, 0);
  }

  // Down along `slope`, to the place where the first pass begins, and round once more, level, for
  // what the slope left of the floor.
  void helix(const Descent& descent, const std::vector<Segment>& slope, double top, double from,
             double level) {
    double whole = 0, done = 0;
    for (const Segment& segment : slope) whole += segment.length();
    for (const Segment& segment : slope) {
      done += segment.length();
      go(segment, MoveKind::kEntry, level + (1 - done / whole) * (from - level),
         params_.entry.plunge);
    }
    const double turn = 2 * half_turn_length(descent);
    double begin = 0;
    for (const LevelPiece& piece : level_pieces(descent, top - level, (from - level) / whole,
                                                params_.tool_radius, params_.entry)) {
      for (const Segment& segment : way_round(descent, turn - begin, turn - piece.end))
        go(segment, MoveKind::kEntry, level, piece.feed);
      begin = piece.end;
    }
  }

  // Down on the way round, and round once more, level.
  void ramp(const Descent& descent, double from, double level) {
    const std::vector<Segment> round = ramp_round(descent);
    const std::vector<double> shares = ramp_shares(descent, params_.helix_angle);
    const double length = std::accumulate(shares.begin(), shares.end(), 0.0);
    const double rounds =
        std::max(1.0, std::ceil((from - level) / (std::tan(params_.helix_angle) * length)));
    double left = rounds * length;  // mm down to the level
    for (int i = 0; i <= static_cast<int>(rounds); ++i)
      for (std::size_t k = 0; k < round.size(); ++k) {
        left -= shares[k];
        const double z = level + (from - level) * std::max(0.0, left / (rounds * length));
        line(round[k].b, i < static_cast<int>(rounds) ? z : level, MoveKind::kEntry,
             params_.entry.plunge);
      }
  }

  const AssemblyParams& params_;
  std::vector<Move> moves_;
  Move at_;
};

}  // namespace

std::vector<Move> assemble(const std::vector<PlanarRun>& runs, const AssemblyParams& params) {
  return Assembler(params).build(runs);
}

double duration(const std::vector<Move>& moves, double rapid_feed) {
  double minutes = 0;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    const Move &a = moves[i - 1], &b = moves[i];
    const double length =
        helical_length(b.x - a.x, b.y - a.y, b.z - a.z, b.sweep, b.cx, b.cy, b.x, b.y);
    minutes += length / (b.kind == MoveKind::kRapid ? rapid_feed : b.feed);
  }
  return 60 * minutes;
}

}  // namespace evenload
