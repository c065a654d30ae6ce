#include "strategy/passage/passage_walls.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/bi_arc.h"
#include "strategy/moves/move_checks.h"
#include "support/tolerances.h"

namespace evenload {
namespace {

// Of the wall's length: where a tool's radius is more, the wall has one feed.
constexpr double kShortWall = 0.3;
// mm: a wall this much further than the nearest one is touched as well.
constexpr double kTouched = 1e-3;
// mm: arcs that are posted as such, with three decimals, turn no more tightly.
constexpr double kTightestRoll = 0.1;
// Times the distance from the middle to the wall: how far along the wall the tool rolls onto it.
constexpr double kRollLengths[] = {1, 2, 4, 8, 16, 32};
// rad: of one arc of two.
constexpr double kMostWallTurn = 0.6 * kPi;

// In corners the tool meets more than between them: the ends get feeds of their own.
void add_with_ends(std::vector<Segment>& moves, const Segment& wall, double tool_radius) {
  const double share = tool_radius / wall.length();
  if (share > kShortWall) {
    moves.push_back(wall);
    return;
  }
  moves.push_back(wall.part(0, share));
  moves.push_back(wall.part(share, 1 - share));
  moves.push_back(wall.part(1 - share, 1));
}

// Onto a wall, from where the tool stands or may come down.
struct Roll {
  Pose from;
  std::vector<Segment> arcs;
  double radius = 0;  // mm, of the tighter one
  double length = 0;  // mm
  std::size_t piece = 0;
  double t = 0;  // where on the piece it ends
};

class Walls {
 public:
  Walls(const PassageAxis& axis, int number, const ClearingParams& params, PassagePath& path)
      : axis_(axis), number_(number), params_(params), path_(path) {}

  void follow(const std::vector<PassageBorder>& loop) {
    const std::size_t n = loop.size();
    std::size_t first = 0;  // after a mouth that is clear
    while (first < n && !is_clear_mouth(loop[(first + n - 1) % n])) ++first;
    if (first == n) {
      follow_closed(loop);
      return;
    }
    std::vector<Segment> way;
    for (std::size_t i = 0; i < n; ++i) {
      const PassageBorder& piece = loop[(first + i) % n];
      if (is_clear_mouth(piece)) {
        path_.follow(way, number_);
        way.clear();
      } else {
        add(way, piece);
      }
    }
  }

 private:
  bool is_clear_mouth(const PassageBorder& piece) const {
    return piece.is_mouth && path_.is_clear(piece.segment.b);
  }

  // Straight across mouths.
  void add(std::vector<Segment>& way, const PassageBorder& piece) const {
    if (piece.is_mouth)
      way.push_back(Segment::line(piece.segment.a, piece.segment.b));
    else
      add_with_ends(way, piece.segment, 0.5 * params_.tool_diameter);
  }

  void follow_closed(const std::vector<PassageBorder>& loop) {
    std::vector<Segment> walls;
    for (const PassageBorder& piece : loop) add(walls, piece);
    const std::vector<Segment> from_clear = path_.from_clear_part(walls);
    if (!from_clear.empty())
      path_.follow(from_clear, number_);
    else if (const std::optional<Roll> roll = best_roll(walls))
      follow_from(*roll, walls);
    else
      follow_straight(walls);
  }

  void follow_from(const Roll& roll, const std::vector<Segment>& walls) {
    if (distance(roll.from.p, path_.here().p) > 0 || roll.from.heading != path_.here().heading)
      path_.reach(roll.from);
    std::vector<Segment> way = roll.arcs;
    add_round(way, walls, roll.piece, roll.t);
    path_.follow(way, number_);
  }

  // From the middle to the wall straight: where not even arcs have room.
  void follow_straight(const std::vector<Segment>& walls) {
    const PassageAxis::Point* from = nullptr;
    std::size_t piece = 0;
    double least = kTouched;
    for (const PassageAxis::Point& point : axis_.points) {
      if (!path_.is_clear(point.p)) continue;
      for (std::size_t i = 0; i < walls.size(); ++i) {
        const double excess = walls[i].distance_to(point.p) - point.radius;
        if (excess >= least) continue;
        from = &point;
        piece = i;
        least = excess;
      }
    }
    if (!from) return;
    const double t = walls[piece].nearest(from->p);
    std::vector<Segment> way{Segment::line(from->p, walls[piece].point(t))};
    path_.reach({from->p, angle_of(way.front().b - from->p)});
    add_round(way, walls, piece, t);
    path_.follow(way, number_);
  }

  static void add_round(std::vector<Segment>& way, const std::vector<Segment>& walls,
                        std::size_t first, double t) {
    if (t < 1) way.push_back(walls[first].part(t, 1));
    for (std::size_t i = 1; i < walls.size(); ++i) way.push_back(walls[(first + i) % walls.size()]);
    if (t > 0) way.push_back(walls[first].part(0, t));
  }

  // ---- rolling onto a wall ----

  // From where the tool stands, else from the place of the middle where the tool turns least
  // tightly.
  std::optional<Roll> best_roll(const std::vector<Segment>& walls) const {
    std::optional<Roll> best;
    if (!path_.may_turn()) offer(path_.here().p, path_.here().heading, walls, best);
    if (best && best->radius >= kTightestRoll) return best;
    best.reset();
    for (const PassageAxis::Point& point : axis_.points)
      if (path_.is_clear(point.p)) offer(point.p, std::nullopt, walls, best);
    if (best && best->radius >= kTightestRoll) return best;
    return std::nullopt;
  }

  // Rolls from `p` onto the nearest walls; without a heading along each of them.
  void offer(Vec2 p, std::optional<double> heading, const std::vector<Segment>& walls,
             std::optional<Roll>& best) const {
    double nearest = walls.front().distance_to(p);
    for (const Segment& wall : walls) nearest = std::min(nearest, wall.distance_to(p));
    for (std::size_t i = 0; i < walls.size(); ++i) {
      if (walls[i].distance_to(p) > nearest + kTouched) continue;
      const double t = walls[i].nearest(p);
      const Pose from{p, heading ? *heading : angle_of(walls[i].tangent(t))};
      for (const double length : kRollLengths) {
        Roll roll;
        roll.from = from;
        roll.piece = i;
        roll.t = t + length * nearest / walls[i].length();
        if (roll.t >= 1 || !find_arcs(roll, walls[i])) continue;
        if (!best || is_better(roll, *best)) best = std::move(roll);
      }
    }
  }

  // No tighter than MinimumRadius where there is room, and short.
  bool is_better(const Roll& a, const Roll& b) const {
    const double ra = std::min(a.radius, params_.minimum_radius);
    const double rb = std::min(b.radius, params_.minimum_radius);
    return ra > rb + 1e-9 || (ra > rb - 1e-9 && a.length < b.length - 1e-9);
  }

  bool find_arcs(Roll& roll, const Segment& wall) const {
    const std::optional<BiArc> pair =
        bi_arc({roll.from.p, unit(roll.from.heading)}, {wall.point(roll.t), wall.tangent(roll.t)},
               kMostWallTurn);
    if (!pair) return false;
    roll.radius = 2 * params_.minimum_radius;
    for (const Segment& arc : {pair->first, pair->second}) {
      if (arc.length() < kZeroLength) continue;
      if (!is_inside(arc, path_.centres(), kSame)) return false;
      if (arc.is_arc()) roll.radius = std::min(roll.radius, arc.radius);
      roll.arcs.push_back(arc);
      roll.length += arc.length();
    }
    return !roll.arcs.empty();
  }

  const PassageAxis& axis_;
  int number_;
  const ClearingParams& params_;
  PassagePath& path_;
};

}  // namespace

void follow_walls(const Passage& passage, const PassageAxis& axis, int number,
                  const ClearingParams& params, PassagePath& path) {
  Walls walls(axis, number, params, path);
  for (const std::vector<PassageBorder>& loop : passage.loops) walls.follow(loop);
}

}  // namespace evenload
