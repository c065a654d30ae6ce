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

void Plan::add(MoveKind kind, const std::vector<Segment>& moves, MoveTags tags) {
  for (const Segment& segment : moves) {
    if (kind == MoveKind::kCut) ground_.add(segment);  // first, since it may throw Cancelled
    PlanarMove move;
    move.kind = kind;
    move.segment = segment;
    move.passage = tags.passage;
    move.in_pattern = tags.in_pattern;
    go(move);
  }
}

void Plan::add_steered(const std::vector<Segment>& moves) {
  for (const Segment& segment : moves) {
    PlanarMove move;
    move.segment = segment;
    go(move);
  }
}

// Links that follow each other count as one.
void Plan::go(const PlanarMove& move) {
  std::vector<PlanarMove>& moves = made_.runs.back().moves;
  if (move.kind == MoveKind::kLink && (moves.empty() || moves.back().kind != MoveKind::kLink))
    ++made_.links;
  moves.push_back(move);
  stand_at_end();
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
  return true;
}

void Plan::know(const std::vector<PlanarRun>& runs) {
  for (const PlanarRun& run : runs) clear(run);
}

void Plan::append(RegionResult room) {
  count(room);
  const std::size_t first = runs().size();
  for (PlanarRun& run : room.runs) {
    run.new_region = is_empty();
    made_.runs.push_back(std::move(run));
  }
  if (!is_empty()) stand_at_end();
  for (std::size_t i = first; i < runs().size(); ++i) clear(runs()[i]);  // may throw Cancelled
}

void Plan::go_on_by(RegionResult end) {
  for (const PlanarMove& move : end.runs.front().moves) {
    if (move.kind == MoveKind::kCut) ground_.add(move.segment);
    made_.runs.back().moves.push_back(move);
    stand_at_end();
  }
  end.runs.erase(end.runs.begin());
  if (made_.tight_turns.rooms > 0) end.tight_turns.rooms = 0;  // the same region's
  append(std::move(end));
}

void Plan::adopt(RegionResult grown) {
  const Mark old = mark();
  made_ = std::move(grown);
  if (is_empty()) return;
  stand_at_end();
  if (old.runs > 0) clear(runs()[old.runs - 1].moves, old.moves);
  for (std::size_t i = old.runs; i < runs().size(); ++i) clear(runs()[i]);  // may throw Cancelled
}

void Plan::note_turn(double radius, Vec2 shown_at) {
  made_.tight_turns.add({made_.tight_turns.rooms > 0 ? 0 : 1, radius, shown_at});
}

Plan::Mark Plan::mark() const {
  return {runs().size(),  is_empty() ? 0 : runs().back().moves.size(),
          ground_.size(), made_.passes,
          made_.links,    made_.findings.size(),
          here_};
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
  clear(run.moves, 0);
}

void Plan::clear(const std::vector<PlanarMove>& moves, std::size_t from) {
  for (std::size_t i = from; i < moves.size(); ++i)
    if (moves[i].kind == MoveKind::kCut) ground_.add(moves[i].segment);
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
  made.findings.erase(made.findings.begin(),
                      std::next(made.findings.begin(), static_cast<std::ptrdiff_t>(mark.findings)));
  return made;
}

}  // namespace evenload
