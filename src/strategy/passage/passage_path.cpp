#include "strategy/passage/passage_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "strategy/moves/move_ends.h"
#include "strategy/reach/links.h"
#include "support/tolerances.h"

namespace evenload {
namespace {

// Share of the tool's radius: no shorter parts of a move are told apart as clear.
constexpr double kLook = 0.5;

double heading_at(const Segment& move, double t) { return angle_of(move.tangent(t)); }

}  // namespace

PassagePath::PassagePath(const RegionTask& task, const ClearingParams& params, Progress& progress)
    : params_(params), centres_({task.centres}), plan_(task, params, progress) {}

void PassagePath::reach(const Pose& to) {
  const bool same_heading =
      may_turn() || std::abs(wrap_signed(to.heading - here().heading)) < kSameDirection;
  if (distance(here().p, to.p) < kSame && same_heading) return;
  const double turn = std::min(params_.roll_radius, params_.minimum_radius);
  if (!plan_.link_to(to, centres_, turn)) plan_.plunge(to, true);
}

bool PassagePath::leads_on(const std::vector<Segment>& way) const {
  const Segment& first = way.front();
  const double turn = wrap_signed(heading_at(first, 0) - here().heading);
  return distance(first.a, here().p) < kSame && (may_turn() || std::abs(turn) < kSameDirection) &&
         length_of(way) <= length_of_retract(distance(first.a, way.back().b), params_);
}

void PassagePath::follow(const std::vector<Segment>& way, int passage) {
  std::vector<Segment> clear;  // of the way, since the last cut
  bool cut = false;
  for (const Segment& move : way)
    for (const Part& part : parts_of(move)) {
      if (part.clear) {
        clear.push_back(part.segment);
        continue;
      }
      if (!clear.empty() && leads_on(clear)) {
        plan_.add(MoveKind::kLink, clear);
      } else if (!cut || !clear.empty()) {
        reach({part.segment.a, heading_at(part.segment, 0)});
      }
      clear.clear();
      plan_.add(MoveKind::kCut, {part.segment}, {passage});
      cut = true;
    }
  if (cut) plan_.count_pass();
}

std::vector<Segment> PassagePath::from_clear_part(const std::vector<Segment>& loop) const {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    double done = 0;
    for (const Part& part : parts_of(loop[i])) {
      if (!part.clear) {
        done += part.segment.length();
        continue;
      }
      const double t = done / loop[i].length();
      std::vector<Segment> result{t > 0 ? loop[i].part(t, 1) : loop[i]};
      for (std::size_t k = 1; k < loop.size(); ++k) result.push_back(loop[(i + k) % loop.size()]);
      if (t > 0) result.push_back(loop[i].part(0, t));
      return result;
    }
  }
  return {};
}

std::vector<PassagePath::Part> PassagePath::parts_of(const Segment& move) const {
  std::vector<Part> parts;
  const double length = move.length();
  if (length < kZeroLength) return parts;
  const int n = std::max(1, static_cast<int>(length / (kLook * plan_.ground().tool_radius())));
  const auto piece = [&](int from, int to) {
    return move.part(static_cast<double>(from) / n, static_cast<double>(to) / n);
  };
  int first = 0;
  for (int i = 0; i < n; ++i) {
    const bool clear =
        is_free({plan_.ground(), plan_.ground().size()}, centres_, {piece(i, i + 1)}, length);
    if (parts.empty() || parts.back().clear != clear) {
      parts.push_back({{}, clear});
      first = i;
    }
    parts.back().segment = piece(first, i + 1);
  }
  return parts;
}

}  // namespace evenload
