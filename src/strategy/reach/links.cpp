#include "strategy/reach/links.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cutting/probe.h"
#include "geometry/bi_arc.h"
#include "strategy/moves/move_ends.h"
#include "support/tolerances.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

// mm: material thinner than this may be brushed by a link at its ends.
constexpr double kLinkTolerance = 3e-5;
// mm: links stay this far from what is not cleared, but at their ends.
constexpr double kLinkDistance = 1e-3;
// rad: of one arc of two. Back to back takes half a turn; beyond, three pieces are shorter.
constexpr double kMostTurn = 1.1 * kPi;
// Shares of the tool's radius: between two looks for material, and for the wall.
constexpr double kLinkLook = 0.04;
constexpr double kFirstLooks[] = {0.003, 0.01, 0.02};
// rad: between two looks along an arc; turns as tight as corners need pass a wall and come back
// within less than kLinkLook.
constexpr double kTurnLook = 0.15;
// mm: between two looks an arc cuts no deeper into a straight wall; that is 0.8 degrees of
// engagement for a tool of 6 mm.
constexpr double kMissedDepth = 3e-4;
// Turns that are tried one after the other, while there is no way: as shares of the wished turn
// radius, and the tightest, for gaps of hundredths of a millimetre, in mm. Posts write what is much
// less than half a turn of that as lines.
constexpr double kTighter[] = {0.2, 0.05};
constexpr double kTightest = kLeastArcRadius + kRadiusMargin;
// Every so manieth look for material comes first.
constexpr int kSparseLooks = 8;
// A way along a wall, which is less gentle, counts so many times its length.
constexpr double kGrazingPrice = 1.5;
// Looks for the wall that a straight way cuts into; shares of the turn radius: how far beside it a
// link passes, and the tightest turn there.
constexpr int kRoundLooks = 32;
constexpr double kBerth = 0.3;
constexpr double kTightestRound = 0.5;
// mm: of the ends of a link that leaves a wall slowly.
constexpr double kLongestEnds = 0.4;

double turn_angle(double side, double from, double to) {
  const double angle = wrap_positive(side * (to - from));
  // A turn of just under a full circle is a turn of nothing with a rounding error.
  return angle > 2 * kPi - kSame ? 0 : angle;
}

void push_turn(std::vector<Segment>& moves, Vec2 centre, double radius, double side, double heading,
               double angle) {
  if (angle > 1e-7)
    moves.push_back(Segment::arc(centre, radius, heading - side * kPi / 2, side * angle));
}

// Turn to `side_a`, straight on, turn to `side_b` (+1 left, -1 right). False when there is no such
// path.
bool turn_straight_turn(const Pose& a, const Pose& b, double radius, double side_a, double side_b,
                        std::vector<Segment>& moves) {
  const Vec2 ca = a.p + side_a * radius * left_normal(unit(a.heading));
  const Vec2 cb = b.p + side_b * radius * left_normal(unit(b.heading));
  const Vec2 d = cb - ca;
  const double length = norm(d);
  double heading = 0;
  if (side_a == side_b) {
    heading = length > 1e-9 ? angle_of(d) : a.heading;
  } else {
    if (length < 2 * radius) return false;
    heading = angle_of(d) + side_a * std::asin(2 * radius / length);
  }
  moves.clear();
  push_turn(moves, ca, radius, side_a, a.heading, turn_angle(side_a, a.heading, heading));
  const Vec2 from = ca - side_a * radius * left_normal(unit(heading));
  const Vec2 to = cb - side_b * radius * left_normal(unit(heading));
  if (distance(from, to) > 1e-7) moves.push_back(Segment::line(from, to));
  push_turn(moves, cb, radius, side_b, heading, turn_angle(side_b, heading, b.heading));
  return true;
}

// A bi-arc, or one arc where that leads there. False when there is none that turns no more tightly
// than `tightest` mm.
bool turn_turn(const Pose& a, const Pose& b, double tightest, std::vector<Segment>& moves) {
  const std::optional<BiArc> pair =
      bi_arc({a.p, unit(a.heading)}, {b.p, unit(b.heading)}, kMostTurn);
  if (!pair) return false;
  for (const Segment& s : {pair->first, pair->second})
    if (s.is_arc() && s.radius < tightest) return false;
  const Segment &one = pair->first, &two = pair->second;
  const bool same = one.is_arc() && two.is_arc() && one.sweep * two.sweep > 0 &&
                    distance(one.centre, two.centre) < kSame;
  if (same)
    moves = {Segment::arc(one.centre, one.radius, one.start_angle, one.sweep + two.sweep)};
  else
    moves = {one, two};
  return true;
}

// An arc that leads from a pose onto a circle. `radius`: of the circle, negative where it turns to
// the right. False where there is none.
bool turn_onto(const Pose& from, Vec2 centre, double radius, Pose& on, Segment& arc) {
  const Vec2 to_left = left_normal(unit(from.heading)), apart = from.p - centre;
  const double denominator = 2 * (dot(apart, to_left) + radius);
  if (std::abs(denominator) < kSame) return false;
  // The centres are as far apart as the radii differ.
  const double own = (radius * radius - squared_norm(apart)) / denominator;
  if (std::abs(radius - own) < kSame || std::abs(own) < kSame) return false;
  const Vec2 own_centre = from.p + own * to_left;
  const Vec2 left = 1 / (radius - own) * (centre - own_centre);  // of the place where they meet
  on = {centre - radius * left, angle_of(left) - kPi / 2};
  const double side = own > 0 ? 1 : -1, turn = turn_angle(side, from.heading, on.heading);
  arc = Segment::arc(own_centre, std::abs(own), from.heading - side * kPi / 2, side * turn);
  return true;
}

// One arc for the two that meet at `beside`, both on the same side: their mean, and those that lead
// onto it and off it. False where they would turn too far or too tightly.
bool turn_on_past(const Pose& from, const Pose& beside, const Pose& to, double curvature,
                  double tightest, std::vector<Segment>& moves) {
  const double radius = 1 / curvature, side = radius > 0 ? 1 : -1;
  const Vec2 centre = beside.p + radius * left_normal(unit(beside.heading));
  Pose begin, end;
  Segment first, last;
  // The last one is sought from its end on.
  if (!turn_onto(from, centre, radius, begin, first) ||
      !turn_onto({to.p, to.heading + kPi}, centre, -radius, end, last))
    return false;
  end.heading -= kPi;
  const double before = turn_angle(side, begin.heading, beside.heading),
               after = turn_angle(side, beside.heading, end.heading);
  moves = {first,
           Segment::arc(centre, std::abs(radius), begin.heading - side * kPi / 2,
                        side * (before + after)),
           last.reversed()};
  return std::all_of(moves.begin(), moves.end(), [&](const Segment& move) {
    return move.radius >= tightest && std::abs(move.sweep) <= kMostTurn;
  });
}

// mm: of an arc that cuts `depth` mm into a straight wall, so much before its deepest place and
// behind it has contact ahead of the tool.
double contact_length(double radius, double depth, double tool_radius) {
  const double before = std::sqrt(2 * depth * radius);
  return before * (1 + 1 / std::sqrt(1 + tool_radius / radius));
}

// True where none of the `n` parts of the move begins or ends beyond a wall.
bool is_off_walls(const Segment& move, int n, const Area& centres) {
  const double length = move.length();
  double wall_free = 0;  // mm along the move that is known to be inside
  for (int i = 0; i <= n; ++i) {
    const double t = static_cast<double>(i) / n;
    if (t * length < wall_free) continue;
    const double inside = centres.signed_distance(move.point(t));
    if (inside < -kSame) return false;
    wall_free = t * length + inside;
  }
  return true;
}

}  // namespace

bool is_free(const GroundBefore& before, const Area& centres, const std::vector<Segment>& moves,
             double ends) {
  if (moves.empty()) return true;
  const ClearedGround& ground = before.ground;
  const double look = kLinkLook * ground.tool_radius(), whole = length_of(moves);
  Probe probe(ground);
  // Where the tool stands, the end of the way that it came hides what lies ahead: the first looks
  // are nearby.
  for (const double share : kFirstLooks) {
    const double t = std::min(1.0, share * ground.tool_radius() / moves.front().length());
    if (probe.touches(moves.front(), t, kLinkTolerance, before.last)) return false;
  }
  const double depth = kMissedDepth + (ends < whole ? kLinkDistance : 0);  // that can be missed
  const auto looks_along = [&](const Segment& move) {
    double looks = move.length() / look;
    if (move.is_arc())
      looks = std::max({looks, std::abs(move.sweep) / kTurnLook,
                        move.length() / contact_length(move.radius, depth, ground.tool_radius())});
    return std::max(1, static_cast<int>(std::ceil(looks)));
  };
  for (const Segment& move : moves)
    if (!is_off_walls(move, looks_along(move), centres)) return false;
  double done = 0;
  const auto touches = [&](const Segment& move, double t) {
    const double at = done + t * move.length();
    const bool at_end = at < ends || at > whole - ends;
    return probe.touches(move, t, at_end ? kLinkTolerance : -kLinkDistance, before.last);
  };
  // Far apart first: most of what is in the way is found by those few.
  for (const bool sparse : {true, false}) {
    done = 0;
    for (const Segment& move : moves) {
      const int n = looks_along(move);
      for (int i = 0; i <= n; ++i)
        if ((i % kSparseLooks == 0) == sparse && touches(move, static_cast<double>(i) / n))
          return false;
      done += move.length();
    }
  }
  return true;
}

namespace {

struct Candidate {
  std::vector<Segment> moves;
  double cost = 0;  // mm
};

// `radii` mm: of turns, the tightest last.
std::vector<Candidate> candidates(const Pose& from, const Pose& to,
                                  const std::vector<double>& radii, double longest) {
  std::vector<Candidate> result;
  const auto offer = [&](Candidate candidate) {
    const double length = length_of(candidate.moves);
    candidate.cost = length + block_price::kLink * static_cast<double>(candidate.moves.size());
    if (length <= longest) result.push_back(std::move(candidate));
  };
  for (const double radius : radii)
    for (const double side_a : {1.0, -1.0})
      for (const double side_b : {1.0, -1.0}) {
        Candidate candidate;
        if (!turn_straight_turn(from, to, radius, side_a, side_b, candidate.moves)) continue;
        offer(std::move(candidate));
      }
  Candidate candidate;
  if (turn_turn(from, to, radii.back(), candidate.moves)) offer(std::move(candidate));
  std::stable_sort(result.begin(), result.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  return result;
}

// mm: so far from an end a turn has left a wall that it began along.
double ends_of(double turn_radius) { return std::sqrt(4 * kLinkDistance * turn_radius); }

// By way of a place beside the wall that the straight way cuts deepest into, which is a corner or
// an island: three arcs and two bi-arcs, as far as there are such. Empty where nothing is cut into,
// or the arcs would be tighter than `tightest` mm.
std::vector<std::vector<Segment>> ways_round(const Area& centres, const Pose& from, const Pose& to,
                                             double berth, double tightest) {
  const Vec2 straight = to.p - from.p;
  BoundaryIndex::Hit deepest;
  double depth = 0;
  for (int i = 1; i < kRoundLooks; ++i) {
    const Vec2 p = from.p + static_cast<double>(i) / kRoundLooks * straight;
    const BoundaryIndex::Hit hit = centres.nearest(p);
    const double outside = -centres.signed_distance(p, hit);
    if (outside <= depth) continue;
    depth = outside;
    deepest = hit;
  }
  if (depth <= berth) return {};
  const Vec2 wall = centres.segment_at(deepest).tangent(deepest.t);
  const double side = dot(wall, straight) < 0 ? -1 : 1;  // walls run with the ground on their left
  const Pose beside{deepest.point + berth * left_normal(wall), angle_of(side * wall)};
  std::vector<Segment> moves, rest;
  if (!turn_turn(from, beside, tightest, moves) || !turn_turn(beside, to, tightest, rest))
    return {};
  const double before = moves.back().curvature(), after = rest.front().curvature();
  moves.insert(moves.end(), rest.begin(), rest.end());
  std::vector<Segment> three;
  if (before * after > 0 && turn_on_past(from, beside, to, 0.5 * (before + after), tightest, three))
    return {std::move(three), std::move(moves)};
  return {std::move(moves)};
}

}  // namespace

std::vector<Segment> shortest_link(const GroundBefore& ground, const Area& centres,
                                   const Pose& from, const Pose& to, double turn_radius,
                                   double longest, LinkSpace space) {
  std::vector<std::vector<double>> tries{{turn_radius, 0.5 * turn_radius}};
  for (const double share : kTighter) tries.push_back({share * turn_radius});
  if (tries.back().back() > kTightest) tries.push_back({kTightest});
  for (const std::vector<double>& radii : tries) {
    for (const Candidate& candidate : candidates(from, to, radii, longest)) {
      const double ends = space == LinkSpace::kClear ? ends_of(turn_radius) : longest;
      if (is_free(ground, centres, candidate.moves, ends)) return candidate.moves;
    }
  }
  for (std::vector<Segment>& round :
       ways_round(centres, from, to, kBerth * turn_radius, kTightestRound * turn_radius)) {
    if (length_of(round) > longest) continue;
    const double widest = 1 / std::max(1e-9, std::min(std::abs(round.front().curvature()),
                                                      std::abs(round.back().curvature())));
    const double ends =
        space == LinkSpace::kClear ? std::min(ends_of(widest), kLongestEnds) : longest;
    if (is_free(ground, centres, round, ends)) return std::move(round);
  }
  return {};
}

double length_of_retract(double gap, const ClearingParams& params) {
  const double rise = params.safe_height - 0.5 * (params.levels.front() + params.levels.back());
  return ((2 * rise + gap) / params.rapid_feed + kRetractPrice / 60) * params.link_feed;
}

std::vector<Segment> quicker_link(const GroundBefore& ground, const Area& centres, const Pose& from,
                                  const Pose& to, double turn_radius, const ClearingParams& params,
                                  double* price) {
  const double longest = length_of_retract(distance(from.p, to.p), params);
  double factor = 1;
  std::vector<Segment> link = shortest_link(ground, centres, from, to, turn_radius, longest);
  if (link.empty()) {
    factor = kGrazingPrice;
    link = shortest_link(ground, centres, from, to, turn_radius, longest / factor,
                         LinkSpace::kGrazing);
  }
  if (price) *price = link.empty() ? longest : factor * length_of(link);
  return link;
}

}  // namespace evenload
