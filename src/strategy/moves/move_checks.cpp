#include "strategy/moves/move_checks.h"

#include <algorithm>
#include <cmath>

#include "cutting/probe.h"
#include "support/tolerances.h"

namespace evenload {
namespace {

// mm between two looks for contact.
constexpr double kContactLook = 0.02;
// mm between two looks at the border, where one between them might see the move beyond it.
constexpr double kFinestLook = 0.02;

// Whether no place of a move lies outside the centres by more than the tolerance, told from few.
class InsideCheck {
 public:
  InsideCheck(const Segment& move, const Area& centres, double tolerance)
      : move_(move),
        centres_(centres),
        tolerance_(tolerance),
        length_(move.length()),
        bend_(std::abs(move.curvature()) + centres.inward_curvature()) {}

  bool passes() const {
    const Look first = look_at(0), last = look_at(1);
    return !is_outside(first) && !is_outside(last) && passes_between(first, last);
  }

 private:
  struct Look {
    double t = 0;
    std::size_t curve = 0, piece = 0;  // of the border, the nearest
    double inside = 0;                 // mm; negative: outside
  };

  Look look_at(double t) const {
    const Vec2 p = move_.point(t);
    const BoundaryIndex::Hit hit = centres_.nearest(p);
    return {t, hit.curve, hit.segment, centres_.signed_distance(p, hit)};
  }

  bool is_outside(const Look& look) const { return look.inside < -tolerance_; }

  // Between two looks the distance falls by no more than the way between them, and below the chord
  // by what the move and the border bend towards each other.
  bool passes_between(const Look& a, const Look& b) const {
    const double way = (b.t - a.t) * length_;
    const double least = std::max(0.5 * (a.inside + b.inside - way),
                                  std::min(a.inside, b.inside) - bend_ * way * way / 8);
    if (least >= -tolerance_ || way <= kFinestLook) return true;
    const Look middle = look_at(0.5 * (a.t + b.t));
    if (is_outside(middle)) return false;
    if (is_on(a, middle) && is_on(b, middle)) return true;  // and so all of the move between
    return passes_between(a, middle) && passes_between(middle, b);
  }

  // Whether both lie on one piece of the border.
  static bool is_on(const Look& a, const Look& b) {
    return std::max(std::abs(a.inside), std::abs(b.inside)) < kSame && a.curve == b.curve &&
           a.piece == b.piece;
  }

  const Segment& move_;
  const Area& centres_;
  double tolerance_, length_;
  double bend_;  // 1/mm
};

}  // namespace

bool is_tangent(const Segment& a, const Segment& b, double difference) {
  return norm(a.tangent(1) - b.tangent(0)) < difference;
}

bool follows_border(const Segment& move, const Area& centres) {
  for (const double t : {0.25, 0.5, 0.75})
    if (std::abs(centres.signed_distance(move.point(t))) > kSame) return false;
  return true;
}

bool is_inside(const Segment& move, const Area& centres, double tolerance) {
  return InsideCheck(move, centres, tolerance).passes();
}

std::size_t first_left_behind(const std::vector<Segment>& moves) {
  double turn = 0;
  std::size_t first = moves.size();
  for (; first > 0; --first) {
    turn += moves[first - 1].sweep;
    if (std::abs(turn) > kComesBack) break;
  }
  return first;
}

double idle_end_of(const std::vector<Segment>& moves, double most, ClearedGround& ground) {
  const std::size_t before = ground.size();
  for (const Segment& move : moves) ground.add(move);
  Probe probe(ground);
  double idle = 0, behind = 0;
  bool touches = false;
  for (std::size_t i = moves.size(); i-- > 0 && !touches && behind < most;) {
    const Segment& move = moves[i];
    const double length = move.length();
    const int looks = looks_along(length, kContactLook);
    for (int k = looks; k >= 0 && !touches; --k) {
      const double t = static_cast<double>(k) / looks;
      touches = probe.touches(move, t, kCoverTolerance, before + i);
      if (!touches) idle = behind + (1 - t) * length;
    }
    behind += length;
  }
  while (ground.size() > before) ground.remove_last();
  return std::min(idle, most);
}

}  // namespace evenload
