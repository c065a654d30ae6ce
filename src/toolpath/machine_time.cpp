#include "toolpath/machine_time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "geometry/vec2.h"

namespace evenload {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// rad. Below it moves are one line: coordinates of 1000 mm and moves of 0.01 mm leave rounding of
// this size in a direction.
constexpr double kCollinear = 1e-9;
// rad. Below it a joint is tangent: G-code of three decimals turns a tangent by so much on moves of
// 1 mm.
constexpr double kTangent = 1e-3;
// Of a speed: speeds that differ by less are one.
constexpr double kSameSpeed = 1e-9;

struct Vec3 {
  double x = 0, y = 0, z = 0;
};
Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
double norm(Vec3 a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }

// A move that has a length, or several that are planned as one.
struct Piece {
  std::size_t first = 0, last = 0;  // indices of moves
  double length = 0;                // mm
  double cap = 0;                   // mm/s
  double accel = 0;                 // mm/s^2
  double joint = 0;                 // mm/s, largest speed where it begins
  double line_length = 0;           // mm of the line it belongs to, its own length for arcs
  Vec3 begin, end;                  // directions, of length 1
  bool line = true;
};

void check(const MachineProfile& profile) {
  const auto positive = [](double value) { return value > 0; };
  const auto not_negative = [](double value) { return value >= 0; };
  for (int axis = 0; axis < 3; ++axis) {
    if (!positive(profile.max_feed[axis]))
      throw std::invalid_argument("The machine's largest feed must be above 0 on every axis.");
    if (!positive(profile.max_accel[axis]))
      throw std::invalid_argument("The machine's acceleration must be above 0 on every axis.");
  }
  if (!not_negative(profile.max_jerk) || !not_negative(profile.centripetal_accel) ||
      !not_negative(profile.junction_deviation) || !not_negative(profile.block_rate) ||
      profile.look_ahead < 0)
    throw std::invalid_argument(
        "The machine's jerk, centripetal acceleration, junction deviation, block rate and "
        "look-ahead must be 0 or more.");
  if (!positive(profile.rapid_feed) || std::isinf(profile.rapid_feed))
    throw std::invalid_argument("The machine's rapid feed must be above 0 and finite.");
}

double feed_of(const Move& move, double rapid_feed, std::size_t index) {
  if (move.feed > 0 && std::isfinite(move.feed)) return move.feed;
  if (move.kind == MoveKind::kRapid && move.feed == 0) return rapid_feed;
  throw std::invalid_argument("Move " + std::to_string(index) +
                              " has no feed above 0 mm/min: give it one.");
}

double length_of(const Move& from, const Move& to, std::size_t index) {
  for (const double value : {from.x, from.y, from.z, to.x, to.y, to.z, to.sweep, to.cx, to.cy})
    if (!std::isfinite(value))
      throw std::invalid_argument("Move " + std::to_string(index) +
                                  " has a coordinate that is not finite: correct it.");
  const double rise = to.z - from.z;
  const double flat = to.sweep != 0 ? std::abs(to.sweep) * std::hypot(to.x - to.cx, to.y - to.cy)
                                    : std::hypot(to.x - from.x, to.y - from.y);
  return std::hypot(flat, rise);
}

// The largest of |cos| over the angles from `from` on, `sweep` >= 0 further.
double largest_cosine(double from, double sweep) {
  const double to_axis = std::ceil(from / kPi) * kPi - from;
  if (sweep >= to_axis) return 1;
  return std::max(std::abs(std::cos(from)), std::abs(std::cos(from + sweep)));
}

// The share of the speed that each axis may have to take somewhere within the move.
std::array<double, 3> worst_direction(const Move& from, const Move& to, double length) {
  const double rise = std::abs(to.z - from.z) / length;
  if (to.sweep == 0)
    return {std::abs(to.x - from.x) / length, std::abs(to.y - from.y) / length, rise};
  const double radius = std::hypot(to.x - to.cx, to.y - to.cy);
  const double flat = std::abs(to.sweep) * radius / length;
  const double begin = std::atan2(from.y - to.cy, from.x - to.cx) + kPi / 2;
  const double least = to.sweep > 0 ? begin : begin + to.sweep;
  return {flat * largest_cosine(least, std::abs(to.sweep)),
          flat * largest_cosine(least - kPi / 2, std::abs(to.sweep)), rise};
}

Vec3 direction(const Move& from, const Move& to, double length, bool at_end) {
  if (to.sweep == 0)
    return {(to.x - from.x) / length, (to.y - from.y) / length, (to.z - from.z) / length};
  const Move& at = at_end ? to : from;
  const Vec2 out{at.x - to.cx, at.y - to.cy};
  const double flat = std::abs(to.sweep) * std::hypot(to.x - to.cx, to.y - to.cy) / length;
  const double away = norm(out);
  if (!(away > 0)) return {0, 0, (to.z - from.z) / length};
  const Vec2 along = left_normal(out) * ((to.sweep > 0 ? flat : -flat) / away);
  return {along.x, along.y, (to.z - from.z) / length};
}

double turn_between(Vec3 a, Vec3 b) { return 2 * std::atan2(norm(b - a), norm(b + a)); }

// mm/s, the largest at the joint of two pieces.
double joint_speed(const Piece& before, const Piece& after, const MachineProfile& profile) {
  double speed = std::min(before.cap, after.cap);
  const double turn = turn_between(before.end, after.begin);
  if (turn <= kCollinear) return speed;
  if (profile.centripetal_accel > 0) {
    const double half = std::min(before.line_length, after.line_length) / 2;
    const double radius = half / std::tan(turn / 2);
    speed = std::min(speed, std::sqrt(std::max(0.0, profile.centripetal_accel * radius)));
  }
  if (turn <= kTangent) return speed;
  const Vec3 change = after.begin - before.end;
  const double size = norm(change);
  const double parts[3] = {std::abs(change.x) / size, std::abs(change.y) / size,
                           std::abs(change.z) / size};
  double accel = kInfinity;
  for (int axis = 0; axis < 3; ++axis)
    if (parts[axis] > 0) accel = std::min(accel, profile.max_accel[axis] / parts[axis]);
  const double half = std::cos(turn / 2), quarter = std::sin(turn / 4);
  // 1 - cos(tau / 2) = 2 sin^2(tau / 4)
  const double deviation = profile.junction_deviation;
  const double squared = deviation > 0 ? accel * deviation * half / (2 * quarter * quarter) : 0;
  return std::min(speed, std::sqrt(std::max(0.0, squared)));
}

// ---- one change of speed ----

double ramp_time(double from, double to, double accel, double jerk) {
  const double change = std::abs(to - from);
  if (change == 0) return 0;
  if (jerk == 0) return change / accel;
  if (change * jerk <= accel * accel) return 2 * std::sqrt(change / jerk);
  return change / accel + accel / jerk;
}

double ramp_length(double from, double to, double accel, double jerk) {
  const double time = ramp_time(from, to, accel, jerk);
  return time > 0 ? (from + to) / 2 * time : 0;
}

// mm/s, the largest that can be reached from `from` within `length`.
double reachable(double from, double length, double accel, double jerk) {
  if (std::isinf(accel) && (jerk == 0 || std::isinf(jerk))) return kInfinity;
  if (jerk == 0) return std::sqrt(from * from + 2 * accel * length);
  // Without a stretch at full acceleration: (2 v + x^2) x = L sqrt(j), x^2 the change of speed.
  const double x = [&] {
    const double q = length * std::sqrt(jerk), p = 2 * from;
    if (p < 1e-12 * std::cbrt(q) * std::cbrt(q)) return std::cbrt(q);
    const double k = std::sqrt(p / 3);
    return 2 * k * std::sinh(std::asinh(q / (2 * k * k * k)) / 3);
  }();
  if (x * x * jerk <= accel * accel) return from + x * x;
  // With one: (2 v + d) (d / a + a / j) = 2 L, d the change of speed.
  const double rise = accel * accel / jerk, b = 2 * from + rise;
  const double c = 2 * from * rise - 2 * accel * length;
  return from + (-2 * c) / (b + std::sqrt(b * b - 4 * c));
}

// mm/s, the largest on a length between two speeds, at most `cap`.
double peak_speed(double length, double entry, double exit, double cap, double accel, double jerk) {
  const double least = std::max(entry, exit);
  if (cap <= least) return least;
  const auto needed = [&](double peak) {
    return ramp_length(entry, peak, accel, jerk) + ramp_length(peak, exit, accel, jerk);
  };
  if (needed(cap) <= length) return cap;
  if (jerk == 0) {
    const double squared = accel * length + (entry * entry + exit * exit) / 2;
    return std::clamp(std::sqrt(squared), least, cap);
  }
  if (entry == exit) return std::clamp(reachable(entry, length / 2, accel, jerk), least, cap);
  // needed() rises with the peak: false position with halved weights (Illinois).
  double low = least, high = cap, at_low = needed(low) - length, at_high = needed(high) - length;
  if (at_low >= 0) return least;
  for (int i = 0; i < 100 && high - low > 1e-14 * high; ++i) {
    double middle = high - at_high * (high - low) / (at_high - at_low);
    if (!(middle > low && middle < high)) middle = (low + high) / 2;
    const double at = needed(middle) - length;
    if (at == 0) return middle;
    if (at < 0) {
      low = middle;
      at_low = at;
      at_high /= 2;
    } else {
      high = middle;
      at_high = at;
      at_low /= 2;
    }
  }
  return low;
}

// s after which a change of speed from `from` up to `to` has covered `s` mm.
double rising_time(double s, double from, double to, double accel, double jerk) {
  if (s <= 0) return 0;
  const double all = ramp_time(from, to, accel, jerk);
  if (jerk == 0) return std::min(all, 2 * s / (from + std::sqrt(from * from + 2 * accel * s)));
  const double change = to - from;
  const double rise = change * jerk <= accel * accel ? std::sqrt(change / jerk) : accel / jerk;
  const double full = rise * jerk;  // acceleration reached
  const double length = (from + to) / 2 * all;
  const auto covered = [&](double t) {
    if (t <= rise) return from * t + jerk * t * t * t / 6;
    if (t <= all - rise) {
      const double u = t - rise, v = from + full * rise / 2;
      return from * rise + jerk * rise * rise * rise / 6 + v * u + full * u * u / 2;
    }
    const double u = all - t;
    return length - (to * u - jerk * u * u * u / 6);
  };
  double low = 0, high = all;
  if (s >= length) return all;
  while (high - low > 1e-15 * all) {
    const double middle = (low + high) / 2;
    if (middle <= low || middle >= high) break;
    (covered(middle) < s ? low : high) = middle;
  }
  return (low + high) / 2;
}

double total_time(const SpeedProfile& p) {
  const double up = ramp_length(p.entry, p.peak, p.accel, p.jerk);
  const double down = ramp_length(p.peak, p.exit, p.accel, p.jerk);
  const double cruise = std::max(0.0, p.length - up - down);
  return ramp_time(p.entry, p.peak, p.accel, p.jerk) + ramp_time(p.peak, p.exit, p.accel, p.jerk) +
         (cruise > 0 ? cruise / p.peak : 0);
}

// s from the profile's begin at `s` mm.
double profile_time(const SpeedProfile& p, double s) {
  const double up = ramp_length(p.entry, p.peak, p.accel, p.jerk);
  const double down = ramp_length(p.peak, p.exit, p.accel, p.jerk);
  if (s <= 0) return 0;
  if (s >= p.length) return total_time(p);
  if (s < up) return rising_time(s, p.entry, p.peak, p.accel, p.jerk);
  if (s <= p.length - down) return ramp_time(p.entry, p.peak, p.accel, p.jerk) + (s - up) / p.peak;
  return total_time(p) - rising_time(p.length - s, p.exit, p.peak, p.accel, p.jerk);
}

// mm/s at `time` s from the begin of a change of speed.
double rising_speed(double time, double from, double to, double accel, double jerk) {
  const double all = ramp_time(from, to, accel, jerk);
  if (jerk == 0) return std::min(to, from + accel * time);
  const double change = to - from;
  const double rise = change * jerk <= accel * accel ? std::sqrt(change / jerk) : accel / jerk;
  if (time <= rise) return from + jerk * time * time / 2;
  if (time >= all - rise) return to - jerk * (all - time) * (all - time) / 2;
  return from + jerk * rise * (time - rise / 2);
}

double profile_speed(const SpeedProfile& p, double s) {
  const double up = ramp_length(p.entry, p.peak, p.accel, p.jerk);
  const double down = ramp_length(p.peak, p.exit, p.accel, p.jerk);
  if (s <= 0) return p.entry;
  if (s >= p.length) return p.exit;
  if (s < up)
    return rising_speed(rising_time(s, p.entry, p.peak, p.accel, p.jerk), p.entry, p.peak, p.accel,
                        p.jerk);
  if (s <= p.length - down) return p.peak;
  return rising_speed(rising_time(p.length - s, p.exit, p.peak, p.accel, p.jerk), p.exit, p.peak,
                      p.accel, p.jerk);
}

// ---- planning ----

std::vector<Piece> pieces_of(const std::vector<Move>& moves, const MachineProfile& profile) {
  std::vector<Piece> pieces;
  pieces.reserve(moves.size());
  for (std::size_t i = 1; i < moves.size(); ++i) {
    const Move &from = moves[i - 1], &to = moves[i];
    const double length = length_of(from, to, i);
    const double feed = feed_of(to, profile.rapid_feed, i);
    if (!(length > 0)) continue;
    Piece piece;
    piece.first = piece.last = i;
    piece.length = piece.line_length = length;
    piece.line = to.sweep == 0;
    piece.begin = direction(from, to, length, false);
    piece.end = piece.line ? piece.begin : direction(from, to, length, true);
    piece.cap = feed / 60;
    piece.accel = kInfinity;
    const std::array<double, 3> share = worst_direction(from, to, length);
    for (int axis = 0; axis < 3; ++axis) {
      if (!(share[axis] > 0)) continue;
      piece.cap = std::min(piece.cap, profile.max_feed[axis] / 60 / share[axis]);
      piece.accel = std::min(piece.accel, profile.max_accel[axis] / share[axis]);
    }
    if (to.sweep != 0 && profile.centripetal_accel > 0) {
      const double radius = std::hypot(to.x - to.cx, to.y - to.cy);
      const double flat = std::abs(to.sweep) * radius / length;
      if (flat > 0)
        piece.cap = std::min(piece.cap, std::sqrt(profile.centripetal_accel * radius) / flat);
    }
    if (profile.block_rate > 0) piece.cap = std::min(piece.cap, length * profile.block_rate);
    pieces.push_back(piece);
  }
  return pieces;
}

bool same(double a, double b) { return a == b || std::abs(a - b) <= kSameSpeed * std::max(a, b); }

// Gives collinear lines the length of the line they are.
void measure_lines(std::vector<Piece>& pieces) {
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= pieces.size(); ++i) {
    if (i < pieces.size() && pieces[i].line && pieces[i - 1].line &&
        turn_between(pieces[i - 1].end, pieces[i].begin) <= kCollinear)
      continue;
    double length = 0;
    for (std::size_t k = begin; k < i; ++k) length += pieces[k].length;
    for (std::size_t k = begin; k < i; ++k) pieces[k].line_length = length;
    begin = i;
  }
}

// Makes one of neighbours that only an acceleration starting anew would tell apart.
std::vector<Piece> joined(const std::vector<Piece>& pieces) {
  std::vector<Piece> result;
  result.reserve(pieces.size());
  for (const Piece& piece : pieces) {
    if (!result.empty() && same(result.back().cap, piece.cap) &&
        (piece.joint >= piece.cap || same(piece.joint, piece.cap))) {
      Piece& before = result.back();
      before.last = piece.last;
      before.length += piece.length;
      before.accel = std::min(before.accel, piece.accel);
      before.end = piece.end;
    } else {
      result.push_back(piece);
    }
  }
  return result;
}

// The speed at which each piece begins; one more, 0, at the end.
std::vector<double> planned_speeds(const std::vector<Piece>& pieces,
                                   const MachineProfile& profile) {
  const std::size_t n = pieces.size();
  const double jerk = profile.max_jerk;
  std::vector<double> speed(n + 1, 0);
  for (std::size_t i = n; i-- > 1;)
    speed[i] =
        std::min(pieces[i].joint, reachable(speed[i + 1], pieces[i].length, pieces[i].accel, jerk));
  if (profile.look_ahead > 0) {
    // While piece i - 1 is cut the planner knows the pieces to i + ahead - 1 and stops after them.
    const std::size_t ahead = static_cast<std::size_t>(profile.look_ahead) - 1;
    std::vector<double> limit(n + 1, 0);
    for (std::size_t i = 1; i < n; ++i) {
      double at = 0;
      for (std::size_t k = std::min(n, i + ahead); k-- > i && at < speed[i];)
        at = std::min(speed[k], reachable(at, pieces[k].length, pieces[k].accel, jerk));
      limit[i] = std::min(at, speed[i]);
    }
    // With a jerk limit a higher speed at the end may take more length to brake to.
    for (std::size_t i = n; i-- > 1;)
      speed[i] =
          std::min(limit[i], reachable(speed[i + 1], pieces[i].length, pieces[i].accel, jerk));
  }
  for (std::size_t i = 0; i + 1 < n; ++i)
    speed[i + 1] =
        std::min(speed[i + 1], reachable(speed[i], pieces[i].length, pieces[i].accel, jerk));
  return speed;
}

}  // namespace

std::vector<MoveTime> machine_time(const std::vector<Move>& moves, const MachineProfile& profile) {
  check(profile);
  std::vector<MoveTime> times(moves.size());
  std::vector<Piece> pieces = pieces_of(moves, profile);
  measure_lines(pieces);
  std::vector<double> lengths(moves.size(), 0.0);
  for (const Piece& piece : pieces) lengths[piece.first] = piece.length;
  for (std::size_t i = 1; i < pieces.size(); ++i)
    pieces[i].joint = joint_speed(pieces[i - 1], pieces[i], profile);
  if (profile.max_jerk > 0 && profile.look_ahead == 0) pieces = joined(pieces);
  const std::vector<double> speed = planned_speeds(pieces, profile);
  double now = 0;
  std::size_t next = 0;  // the move to be filled in
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const Piece& piece = pieces[p];
    SpeedProfile part{piece.length, speed[p], 0, speed[p + 1], piece.accel, profile.max_jerk};
    part.peak = peak_speed(piece.length, part.entry, part.exit, piece.cap, piece.accel, part.jerk);
    for (; next < piece.first; ++next) times[next].start = now;
    const double begin = now, all = total_time(part);
    const double up = ramp_length(part.entry, part.peak, part.accel, part.jerk);
    const double down = ramp_length(part.peak, part.exit, part.accel, part.jerk);
    double offset = 0, offset_time = 0, entry = part.entry;
    for (; next <= piece.last; ++next) {
      MoveTime& time = times[next];
      time.start = begin + offset_time;
      if (lengths[next] == 0) continue;
      time.length = lengths[next];
      time.profile = part;
      time.offset = offset;
      time.offset_time = offset_time;
      const double end = offset + time.length;
      const bool last = next == piece.last;
      const double end_time = last ? all : profile_time(part, end);
      time.duration = end_time - offset_time;
      time.entry = entry;
      time.exit = last ? part.exit : profile_speed(part, end);
      const bool has_peak = end >= up && offset <= piece.length - down;
      time.peak = has_peak ? part.peak : std::max(time.entry, time.exit);
      offset = end;
      offset_time = end_time;
      entry = time.exit;
    }
    now = begin + all;
  }
  for (; next < moves.size(); ++next) times[next].start = now;
  return times;
}

double time_at(const MoveTime& move, double s) {
  if (!(s > 0)) return 0;
  if (s >= move.length) return move.duration;
  const double time = profile_time(move.profile, move.offset + s) - move.offset_time;
  return std::clamp(time, 0.0, move.duration);
}

double programmed_time(const std::vector<Move>& moves, double rapid_feed) {
  if (!(rapid_feed > 0)) throw std::invalid_argument("The rapid feed must be above 0 mm/min.");
  double seconds = 0;
  for (std::size_t i = 1; i < moves.size(); ++i)
    seconds += 60 * length_of(moves[i - 1], moves[i], i) / feed_of(moves[i], rapid_feed, i);
  return seconds;
}

}  // namespace evenload
