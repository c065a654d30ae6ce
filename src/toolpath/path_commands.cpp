#include "toolpath/path_commands.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

#include "geometry/vec2.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

// Of a mm. On a grid of 0.001 mm, which posts write unless told otherwise, moves of some hundredths
// of a mm would be turned by degrees, and the engagement with them.
constexpr int kDecimals = 4;
constexpr double kGrid = 1e-4;
// Of a mm, for heights.
constexpr int kHeightDecimals = 6;
// mm: shorter ones are left out, posts would repeat a position.
constexpr double kShortestLine = 0.0005;
// mm, rad: a move with a shorter chord between two that turn by less from the one to the other is
// made a part of the next one. On its own it would be turned by degrees when its ends are rounded.
constexpr double kTinyMove = 0.006;
constexpr double kUnseenCorner = 0.0175;
// Of a line that it is made a part of.
constexpr double kShareOfLine = 0.25;
// mm: arcs with a shorter chord become lines. Their ends must not coincide after a post rounds
// them, which would make full circles of them; inch posts round to 0.0001 in, and their roundings
// at both ends add up to 0.0036 mm.
constexpr double kShortestArc = 0.005;
// mm: flatter arcs become lines; at 50 mm of length they bend by 0.03 um.
constexpr double kLargestRadius = 1e4;
// mm: a centre on the grid is found for every arc within twice this. Controllers refuse arcs whose
// radii at start and end differ by more than about 0.005 mm; rounding to 0.001 mm adds up to 0.003.
constexpr double kRadiusMismatch = 0.00005;
// rad: by which rounding may change a sweep; only the tiniest arcs get there.
constexpr double kMostTurnChange = 0.5;

double on_grid(double value) { return rounded(value, kDecimals) + 0.0; }  // no negative zeros
double height(double value) { return rounded(value, kHeightDecimals); }

// A move along a circle or helix.
struct Circle {
  Vec2 centre;
  double radius, start_angle, start_z, end_z, sweep;

  Position at(double share) const {
    const double angle = start_angle + share * sweep;
    return {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle),
            start_z + share * (end_z - start_z)};
  }
};

// The best place for a centre among the points of the grid about `near`. Moving the centre along
// the chord makes the radii differ, moving it across bends the arc: both count.
Vec2 best_on_grid(Vec2 near, Vec2 exact, Vec2 chord, double length, double sweep) {
  const double bend = 1.0 - std::cos(std::min(0.5 * std::abs(sweep), kPi));
  double least = std::numeric_limits<double>::infinity();
  Vec2 best = near;
  for (const double a : {-kGrid, 0.0, kGrid})
    for (const double b : {-kGrid, 0.0, kGrid}) {
      const Vec2 c{near.x + a, near.y + b};
      const double mismatch =
          std::abs(std::hypot(c.x, c.y) - std::hypot(chord.x - c.x, chord.y - c.y));
      const double across =
          std::abs((c.x - exact.x) * -chord.y + (c.y - exact.y) * chord.x) / length;
      const double cost = mismatch + 0.5 * bend * across;
      if (cost < least) {
        least = cost;
        best = c;
      }
    }
  return {on_grid(best.x), on_grid(best.y)};
}

// (I, J) on the grid for an arc over the chord; nothing where none turns that way.
std::optional<Vec2> centre_for(Vec2 chord, double length, double sweep) {
  const double aside = 0.5 / std::tan(0.5 * sweep);  // to the left of the chord, in chords
  const Vec2 exact{0.5 * chord.x - aside * chord.y, 0.5 * chord.y + aside * chord.x};
  if (std::hypot(exact.x, exact.y) > kLargestRadius) return std::nullopt;
  Vec2 c{on_grid(exact.x), on_grid(exact.y)};
  if (std::abs(std::hypot(c.x, c.y) - std::hypot(chord.x - c.x, chord.y - c.y)) > kRadiusMismatch)
    c = best_on_grid(c, exact, chord, length, sweep);
  // On the grid the arc must still turn the same way by about the same angle.
  double turned = std::atan2(-c.x * (chord.y - c.y) + c.y * (chord.x - c.x),
                             -c.x * (chord.x - c.x) - c.y * (chord.y - c.y));
  turned = sweep > 0 ? wrap_positive(turned) : -wrap_positive(-turned);
  if (!(std::abs(turned - sweep) < kMostTurnChange)) return std::nullopt;
  return c;
}

// Collects commands; remembers where the rounded path is, so that no command repeats a position.
class Writer {
 public:
  explicit Writer(const std::optional<Position>& start) : known_(start.has_value()) {
    if (start) at_ = *start;
  }

  std::vector<PathCommand> commands;

  bool knows_place() const { return known_; }

  // Up before across before down: a rapid never cuts a corner.
  void rapid(const Move& move) {
    const double x = on_grid(move.x), y = on_grid(move.y), z = height(move.z);
    if (!known_) {
      commands.push_back({});
      commands.back().z = at_.z = z;
    }
    if (z > at_.z) rapid_z(z);
    if (!known_ || x != at_.x || y != at_.y) {
      commands.push_back({});
      commands.back().x = at_.x = x;
      commands.back().y = at_.y = y;
    }
    known_ = true;
    if (z < at_.z) rapid_z(z);
  }

  // Whether the next moves belong to an entry: all of a ramp descends, its shortest lines as well.
  void set_entering(bool enters) { enters_ = enters; }

  void line(const Position& exact, double feed) {
    const Position to{on_grid(exact.x), on_grid(exact.y), height(exact.z)};
    const bool is_short = std::hypot(to.x - at_.x, to.y - at_.y) < kShortestLine;
    if (is_short || !enters_) lower_to(to.z);
    if (!is_short || std::abs(to.z - at_.z) >= kShortestLine) go(1, to, std::nullopt, feed);
  }

  // An arc, or a helix when z changes. It may go round more than once.
  void arc(const Move& move) {
    const int pieces = pieces_of_arc(move.sweep);
    const Circle circle{{move.cx, move.cy},
                        std::hypot(move.x - move.cx, move.y - move.cy),
                        std::atan2(move.y - move.cy, move.x - move.cx) - move.sweep,
                        at_.z,
                        move.z,
                        move.sweep};
    for (int i = 1; i <= pieces; ++i) {
      const Position to = i < pieces ? circle.at(static_cast<double>(i) / pieces)
                                     : Position{move.x, move.y, move.z};
      piece(to, move.sweep / pieces, circle, static_cast<double>(i - 1) / pieces, move.feed);
    }
  }

 private:
  void rapid_z(double z) {
    if (std::abs(z - at_.z) < kShortestLine) return;
    commands.push_back({});
    commands.back().z = at_.z = z;
  }

  // A descent too short to be written belongs to the feed move before: left out, it would be
  // missing from all that follows. No move takes more than that.
  void lower_to(double z) {
    const double deeper = at_.z - z;
    if (deeper <= 0 || commands.empty() || commands.back().code == 0 ||
        lowered_ + deeper >= kShortestLine)
      return;
    commands.back().z = at_.z = z;
    lowered_ += deeper;
  }

  // Feed moves name all three axes: FreeCAD's dressups look for them.
  void go(int code, Position to, const std::optional<Vec2>& centre, double feed) {
    if (!enters_) lower_to(to.z);
    if (to.z > at_.z && to.z - at_.z < kShortestLine) to.z = at_.z;
    PathCommand command{code, to.x, to.y, to.z, std::nullopt, std::nullopt, feed};
    if (centre) {
      command.i = centre->x;
      command.j = centre->y;
    }
    commands.push_back(command);
    lowered_ = 0;
    at_ = to;
  }

  // An arc of less than half a turn, which starts at a share of a circle.
  void piece(const Position& exact, double sweep, const Circle& circle, double share, double feed) {
    const double radius = circle.radius;
    if (radius < kLeastArcRadius || radius > kLargestRadius) {
      line(exact, feed);
      return;
    }
    if (spans_next_to_nothing(radius, sweep, kLeastSpan, kSpanlessSweep)) {
      const int lines = lines_of_arc(radius, sweep);
      for (int k = 1; k < lines; ++k)
        line(circle.at(share + static_cast<double>(k) / lines * sweep / circle.sweep), feed);
      line(exact, feed);
      return;
    }
    const Position to{on_grid(exact.x), on_grid(exact.y), height(exact.z)};
    const Vec2 chord{to.x - at_.x, to.y - at_.y};
    const double length = std::hypot(chord.x, chord.y);
    std::optional<Vec2> centre;
    if (length >= kShortestArc) centre = centre_for(chord, length, sweep);
    if (centre)
      go(sweep > 0 ? 3 : 2, to, centre, feed);
    else
      line(to, feed);
  }

  Position at_;
  bool known_;
  bool enters_ = false;
  double lowered_ = 0;  // mm, of the last command
};

// Direction of travel, where a move from `start` begins or ends.
Vec2 direction_at(const Position& start, const Move& move, bool at_end) {
  if (move.sweep == 0) return {move.x - start.x, move.y - start.y};
  const Vec2 out = at_end ? Vec2{move.x - move.cx, move.y - move.cy}
                          : Vec2{start.x - move.cx, start.y - move.cy};
  return move.sweep > 0 ? Vec2{-out.y, out.x} : Vec2{out.y, -out.x};
}

Position end_of(const Move& move) { return {move.x, move.y, move.z}; }

// Whether the move numbered `number` is a tiny one in the middle of a smooth level way, which the
// next can begin with.
bool is_tiny(const std::vector<Move>& moves, std::size_t number,
             const std::optional<Position>& start) {
  if (number < 1 || number + 1 >= moves.size() || (number == 1 && !start)) return false;
  const Move &before = moves[number - 1], &move = moves[number], &next = moves[number + 1];
  const Position from = number == 1 ? *start : end_of(moves[number - 2]);
  const bool is_alike = move.kind != MoveKind::kRapid && before.kind == move.kind &&
                        next.kind == move.kind && from.z == move.z && before.z == move.z &&
                        next.z == move.z;
  if (!is_alike || std::abs(move.sweep) > kUnseenCorner) return false;
  const double chord = std::hypot(move.x - before.x, move.y - before.y);
  const double radius = std::hypot(next.x - next.cx, next.y - next.cy);
  const double length = next.sweep != 0 ? std::abs(next.sweep) * radius
                                        : std::hypot(next.x - move.x, next.y - move.y);
  if (chord > kTinyMove || length <= kTinyMove) return false;
  // An arc is turned about its centre; a line about its end, by as large a part of what the tiny
  // move is off as that is of both.
  if (next.sweep != 0 ? chord > 0.5 * kUnseenCorner * radius : chord > kShareOfLine * length)
    return false;
  const Vec2 in = direction_at(from, before, true), out = direction_at(end_of(move), next, false);
  const Vec2 along{move.x - before.x, move.y - before.y};
  const auto turn = [](Vec2 a, Vec2 b) { return std::abs(std::atan2(cross(a, b), dot(a, b))); };
  return turn(in, out) < 0.75 * kUnseenCorner && turn(in, along) < kUnseenCorner;
}

// The move `next` with what lies between it and `from` as its beginning.
Move with_beginning(Move next, const Move& from, const Move& tiny) {
  if (next.sweep == 0) return next;
  const double radius = std::hypot(next.x - next.cx, next.y - next.cy);
  next.sweep += std::copysign(std::hypot(tiny.x - from.x, tiny.y - from.y) / radius, next.sweep);
  return next;
}

void check(const Move& move, std::size_t number, bool place_known) {
  const std::string name = "Move " + std::to_string(number) + " of the toolpath ";
  if (!std::isfinite(move.x + move.y + move.z + move.sweep + move.cx + move.cy + move.feed))
    throw std::invalid_argument(name + "is not finite: compute the toolpath anew.");
  if (move.kind == MoveKind::kRapid) return;
  if (!(move.feed > 0)) throw std::invalid_argument(name + "has no feed: give it one above 0.");
  if (!place_known)
    throw std::invalid_argument(name +
                                "cuts before the tool's place is known: begin with a rapid.");
}

}  // namespace

double rounded(double value, int decimals) {
  static constexpr std::array<double, 16> kPowers{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                  1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const double power = kPowers.at(static_cast<std::size_t>(decimals));
  const double scaled = value * power, whole = std::nearbyint(scaled);
  // Far from the middle between two decimals, a product's rounding cannot lead to the wrong one;
  // and a quotient of two whole numbers is the double next to the decimal.
  constexpr double kMargin = 1e-3, kLargest = 1e12;
  if (std::abs(scaled) < kLargest && std::abs(scaled - whole) < 0.5 - kMargin) return whole / power;
  std::array<char, 400> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, decimals);
  double result = value;
  std::from_chars(text.data(), end.ptr, result);
  return result;
}

std::vector<PathCommand> path_commands(const std::vector<Move>& moves,
                                       const std::optional<Position>& start, double left_out_from) {
  std::size_t count = moves.size();
  while (count > 0 && moves[count - 1].kind == MoveKind::kRapid &&
         moves[count - 1].z >= left_out_from)
    --count;
  Writer writer(start);
  for (std::size_t number = 0; number < count; ++number) {
    Move move = moves[number];
    check(move, number, writer.knows_place());
    if (number + 1 < count && is_tiny(moves, number, start)) {
      check(moves[number + 1], number + 1, writer.knows_place());
      move = with_beginning(moves[number + 1], moves[number - 1], move);
      ++number;
    }
    writer.set_entering(move.kind == MoveKind::kEntry);
    if (move.kind == MoveKind::kRapid)
      writer.rapid(move);
    else if (move.sweep != 0)
      writer.arc(move);
    else
      writer.line({move.x, move.y, move.z}, move.feed);
  }
  return std::move(writer.commands);
}

}  // namespace evenload
