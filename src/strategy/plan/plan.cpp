#include "strategy/plan/plan.h"

#include <cmath>
#include <iterator>
#include <utility>

#include "feed/load_profile.h"
#include "geometry/box_tree.h"
#include "strategy/reach/links.h"

namespace evenload {
namespace {

// mm and rad: the tool stands there already.
constexpr double kSamePlace = 1e-9, kSameWay = 1e-6;

}  // namespace

Plan::Plan(const RegionTask& task, const ClearingParams& params, Progress& progress)
    : params_(&params),
      ground_(grown(bounds_of({task.centres}), 0.5 * params.tool_diameter),
              0.5 * params.tool_diameter,
              task.has_open_edges || task.rest ? &task.material : nullptr) {
  ground_.tell(progress);
  if (task.hole) ground_.add_disc(*task.hole, 0.5 * params.hole_diameter);
}

void Plan::come_down(const Descent& descent, const Pose& here) {
  add_descent(descent, ground_);
  made_.runs.push_back({descent, {}, is_empty()});
  here_ = here;
}

void Plan::plunge(const Pose& to, bool again) {
  come_down({DescentKind::kPlunge, to.p, {}, 0, {}, again}, to);
}

void Plan::add(MoveKind kind, const std::vector<Segment>& moves, const PlanarMove& like) {
  for (const Segment& segment : moves) {
    PlanarMove move = like;
    move.kind = kind;
    move.segment = segment;
    made_.runs.back().moves.push_back(move);
    if (kind == MoveKind::kCut) ground_.add(segment);
  }
  if (!moves.empty()) stand_at_end();
}

void Plan::post(MoveKind kind, const std::vector<Segment>& moves) {
  for (const Segment& move : moves) made_.runs.back().moves.push_back({kind, move, 0});
  if (!moves.empty()) stand_at_end();
}

bool Plan::link_to(const Pose& to, const Area& around, double turn_radius, std::size_t before) {
  if (is_empty()) return false;
  if (distance(here_.p, to.p) < kSamePlace &&
      std::abs(wrap_signed(to.heading - here_.heading)) < kSameWay)
    return true;
  const std::vector<Segment> link =
      quicker_link({ground_, before}, around, here_, to, turn_radius, *params_);
  if (link.empty()) return false;
  add(MoveKind::kLink, link);
  count_link();
  return true;
}

void Plan::know(const std::vector<PlanarRun>& runs) {
  for (const PlanarRun& run : runs) clear(run);
}

void Plan::append(RegionResult room) {
  for (PlanarRun& run : room.runs) {
    clear(run);
    run.new_region = is_empty();
    made_.runs.push_back(std::move(run));
  }
  if (!is_empty()) stand_at_end();
  count(room);
}

void Plan::go_on_by(RegionResult end) {
  for (const PlanarMove& move : end.runs.front().moves) add(move.kind, {move.segment});
  end.runs.erase(end.runs.begin());
  if (made_.tight_turns.rooms > 0) end.tight_turns.rooms = 0;  // the same region's
  append(std::move(end));
}

void Plan::adopt(RegionResult grown) {
  const Mark old = mark();
  for (std::size_t i = old.runs > 0 ? old.runs - 1 : 0; i < grown.runs.size(); ++i) {
    PlanarRun run = grown.runs[i];
    if (i < old.runs) {
      run.descent = {};
      run.moves.erase(run.moves.begin(), std::next(run.moves.begin(), old.moves));
    }
    clear(run);
  }
  made_ = std::move(grown);
  if (!is_empty()) stand_at_end();
}

void Plan::note_turn(double radius, Vec2 shown_at) {
  made_.tight_turns.add({made_.tight_turns.rooms > 0 ? 0 : 1, radius, shown_at});
}

Plan::Mark Plan::mark() const {
  return {runs().size(),  is_empty() ? 0 : runs().back().moves.size(),
          ground_.size(), made_.passes,
          made_.links,    here_};
}

void Plan::roll_back(const Mark& mark) {
  made_.runs.resize(mark.runs);
  if (!is_empty()) made_.runs.back().moves.resize(mark.moves);
  while (ground_.size() > mark.ground) ground_.remove_last();
  made_.passes = mark.passes;
  made_.links = mark.links;
  here_ = mark.here;
}

void Plan::clear(const PlanarRun& run) {
  add_descent(run.descent, ground_);
  for (const PlanarMove& move : run.moves)
    if (move.kind == MoveKind::kCut) ground_.add(move.segment);
}

void Plan::stand_at_end() {
  const PlanarRun& run = runs().back();
  here_ = {run.descent.at, 0};
  if (run.moves.empty()) return;
  const Segment& last = run.moves.back().segment;
  here_ = {last.b, angle_of(last.tangent(1))};
}

void Plan::count(const RegionResult& more) {
  made_.uncut_area += more.uncut_area;
  made_.passes += more.passes;
  made_.links += more.links;
  made_.tight_turns.add(more.tight_turns);
  made_.findings.insert(made_.findings.end(), more.findings.begin(), more.findings.end());
}

RegionResult since(const Plan::Mark& mark, RegionResult made) {
  std::vector<PlanarRun>& runs = made.runs;
  runs.erase(runs.begin(), std::next(runs.begin(), mark.runs > 0 ? mark.runs - 1 : 0));
  if (mark.runs > 0) {
    std::vector<PlanarMove>& moves = runs.front().moves;
    moves.erase(moves.begin(), std::next(moves.begin(), mark.moves));
  }
  made.passes -= mark.passes;
  made.links -= mark.links;
  return made;
}

}  // namespace evenload
