#include "geometry/slot_around.h"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "geometry/intersect.h"
#include "support/errors.h"

namespace evenload {
namespace {

// rad: chains that turn by less at a joint are smooth there.
constexpr double kSmooth = 1e-6;

std::vector<Segment> pieces_of(const Curve& middle) {
  std::vector<Segment> pieces;
  for (const Vertex& v : middle.vertices())
    if (!std::isfinite(v.p.x) || !std::isfinite(v.p.y) || !std::isfinite(v.bulge))
      throw GeometryError(Refusal::kMiddleNotFinite, {});
  for (const Segment& piece : middle.segments())
    if (piece.length() > kZeroLength) pieces.push_back(piece);
  if (pieces.empty())
    throw GeometryError(Refusal::kMiddleWithoutLength,
                        middle.empty() ? Vec2{} : middle.vertices().front().p);
  return pieces;
}

void refuse_crossings(const std::vector<Segment>& pieces, bool closed) {
  const std::size_t n = pieces.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (const Meeting& meeting : meetings(pieces[i], pieces[j], kTouch)) {
        const bool at_joint = j == i + 1 && distance(meeting.p, pieces[i].b) < kClosingGap;
        const bool at_closing =
            closed && i == 0 && j == n - 1 && distance(meeting.p, pieces[i].a) < kClosingGap;
        if (!at_joint && !at_closing) throw GeometryError(Refusal::kMiddleCrossesItself, meeting.p);
      }
}

[[noreturn]] void refuse_bend(Vec2 where) {
  throw GeometryError(Refusal::kMiddleBendsTooTightly, where);
}

Segment right_of(const Segment& piece, double half) {
  const auto moved = [&](double t) {
    return piece.point(t) - half * left_normal(piece.tangent(t));
  };
  if (!piece.is_arc()) return Segment::line(moved(0), moved(1));
  const double radius = piece.radius + (piece.sweep > 0 ? half : -half);
  if (radius <= kClosingGap) refuse_bend(piece.point(0.5));
  return Segment::arc(piece.centre, radius, piece.start_angle, piece.sweep);
}

// Joins a side's last piece to the next one: by an arc about the joint where the chain turns away,
// where they cross where it turns towards this side.
void join(std::vector<Segment>& side, Segment& next, Vec2 joint, double half) {
  Segment& last = side.back();
  const double turn = wrap_signed(angle_of(next.tangent(0)) - angle_of(last.tangent(1)));
  if (std::abs(turn) < kSmooth) return;
  if (turn > 0) {
    side.push_back(Segment::arc(joint, half, angle_of(last.b - joint), turn));
    return;
  }
  std::optional<Meeting> first;
  for (const Meeting& meeting : meetings(last, next, kTouch))
    if (!first || meeting.ta > first->ta) first = meeting;
  if (!first || first->ta < kTouch || first->tb > 1 - kTouch) refuse_bend(joint);
  last = last.part(0, first->ta);
  next = next.part(first->tb, 1);
}

// What lies `half` mm to the right of the chain.
std::vector<Segment> right_side(const std::vector<Segment>& pieces, double half, bool closed) {
  std::vector<Segment> side;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Segment next = right_of(pieces[i], half);
    if (i > 0) join(side, next, pieces[i].a, half);
    side.push_back(next);
  }
  if (closed) {
    Segment first = side.front();
    join(side, first, pieces.front().a, half);
    side.front() = first;
  }
  return side;
}

std::vector<Segment> reversed(const std::vector<Segment>& pieces) {
  std::vector<Segment> back;
  for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece)
    back.push_back(piece->reversed());
  return back;
}

void push(const std::vector<Segment>& side, std::vector<Vertex>& vertices) {
  for (const Segment& piece : side) vertices.push_back({piece.a, piece.bulge()});
}

Region ring(const std::vector<Segment>& one_side, const std::vector<Segment>& other_side) {
  std::vector<Vertex> one, other;
  push(one_side, one);
  push(other_side, other);
  Curve outer(std::move(one), true), island(std::move(other), true);
  if (std::abs(outer.signed_area()) < std::abs(island.signed_area())) std::swap(outer, island);
  return make_region(outer, {island});
}

}  // namespace

Region slot_around(const Curve& middle, double width, SlotEnds ends) {
  if (!std::isfinite(width) || width <= 0)
    throw std::invalid_argument("The slot's width must be positive: set SlotWidth.");
  const std::vector<Segment> pieces = pieces_of(middle);
  refuse_crossings(pieces, middle.closed());
  const double half = 0.5 * width;
  const std::vector<Segment> right = right_side(pieces, half, middle.closed()),
                             left = right_side(reversed(pieces), half, middle.closed());
  try {
    if (middle.closed()) return ring(right, left);
    std::vector<Vertex> vertices;
    const double cap = ends == SlotEnds::kRound ? 1 : 0;
    for (const std::vector<Segment>* side : {&right, &left}) {
      push(*side, vertices);
      vertices.push_back({side->back().b, cap, ends == SlotEnds::kOpen});
    }
    return make_region(Curve(std::move(vertices), true));
  } catch (const GeometryError& error) {
    throw GeometryError(Refusal::kSlotSidesMeet, error.where());
  }
}

}  // namespace evenload
