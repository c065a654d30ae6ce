#include "strategy/passage/passage_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "feed/load_profile.h"
#include "geometry/box_tree.h"
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
    : params_(params),
      centres_({task.centres}),
      ground_(grown(bounds_of({task.centres}), 0.5 * params.tool_diameter),
              0.5 * params.tool_diameter, task.has_open_edges ? &task.material : nullptr) {
  ground_.tell(progress);
  if (task.hole) ground_.add_disc(*task.hole, 0.5 * params.hole_diameter);
}

void PassagePath::append(PlanarRun run) {
  add_descent(run.descent, ground_);
  for (const PlanarMove& move : run.moves) ground_.add(move.segment);
  here_ = {run.descent.at, 0};
  if (!run.moves.empty()) {
    const Segment& last = run.moves.back().segment;
    here_ = {last.b, heading_at(last, 1)};
  }
  runs_.push_back(std::move(run));
}

void PassagePath::begin(const Descent& descent, const Pose& start, bool is_new) {
  if (descent.kind != DescentKind::kPlunge) add_descent(descent, ground_);
  runs_.push_back({descent, {}, is_new});
  here_ = start;
}

void PassagePath::reach(const Pose& to) {
  const bool same_heading =
      may_turn() || std::abs(wrap_signed(to.heading - here_.heading)) < kSameDirection;
  if (distance(here_.p, to.p) < kSame && same_heading) return;
  const double turn = std::min(params_.roll_radius, params_.minimum_radius);
  const std::vector<Segment> link =
      quicker_link({ground_, ground_.size()}, centres_, here_, to, turn, params_);
  if (!link.empty()) {
    add(MoveKind::kLink, link, -1);
    return;
  }
  begin({DescentKind::kPlunge, to.p, {}, 0, {}, true}, to, false);
}

bool PassagePath::leads_on(const std::vector<Segment>& way) const {
  const Segment& first = way.front();
  const double turn = wrap_signed(heading_at(first, 0) - here_.heading);
  return distance(first.a, here_.p) < kSame && (may_turn() || std::abs(turn) < kSameDirection) &&
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
      if (!clear.empty() && leads_on(clear))
        add(MoveKind::kLink, clear, -1);
      else if (!cut || !clear.empty())
        reach({part.segment.a, heading_at(part.segment, 0)});
      clear.clear();
      add(MoveKind::kCut, {part.segment}, passage);
      cut = true;
    }
  passes_ += cut ? 1 : 0;
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
  const int n = std::max(1, static_cast<int>(length / (kLook * ground_.tool_radius())));
  const auto piece = [&](int from, int to) {
    return move.part(static_cast<double>(from) / n, static_cast<double>(to) / n);
  };
  int first = 0;
  for (int i = 0; i < n; ++i) {
    const bool clear = is_free({ground_, ground_.size()}, centres_, {piece(i, i + 1)}, length);
    if (parts.empty() || parts.back().clear != clear) {
      parts.push_back({{}, clear});
      first = i;
    }
    parts.back().segment = piece(first, i + 1);
  }
  return parts;
}

void PassagePath::add(MoveKind kind, const std::vector<Segment>& moves, int passage) {
  std::vector<PlanarMove>& all = runs_.back().moves;
  if (kind == MoveKind::kLink && (all.empty() || all.back().kind != kind)) ++links_;
  for (const Segment& move : moves) {
    PlanarMove planar;
    planar.kind = kind;
    planar.segment = move;
    planar.passage = passage;
    all.push_back(planar);
    ground_.add(move);
  }
  here_ = {moves.back().b, heading_at(moves.back(), 1)};
}

}  // namespace evenload
