#include "strategy/choose/pass_taking.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "strategy/choose/pass_choice.h"
#include "strategy/moves/move_checks.h"
#include "strategy/moves/move_ends.h"
#include "strategy/moves/tight_turns.h"
#include "strategy/places/narrow_passages.h"
#include "strategy/reach/border_bits.h"
#include "strategy/reach/free_place.h"
#include "strategy/reach/links.h"

namespace evenload {
namespace {

// mm: turns end on the walls of narrow places.
constexpr double kOnNarrowWall = 1e-3;
// Share of the tool's radius: so much is kept of a pass's way without contact at both ends.
constexpr double kKeptIdle = 0.03;

Pose start_of(const std::vector<Segment>& way) {
  return {way.front().a, angle_of(way.front().tangent(0))};
}

}  // namespace

bool PassTaking::take_from_here(Pass pass, double turn_radius) {
  pass.moves = smooth(pass);
  return take(std::move(pass), turn_radius);
}

bool PassTaking::take_new(const Pass& pass, double turn_radius, std::size_t before) {
  if (made_.contains(pass)) {
    take_back(ground_, pass);
    return false;
  }
  if (!go_and_take(pass, turn_radius, before)) return false;
  made_.add(pass);
  return true;
}

void PassTaking::tell_tightest_turn() {
  if (tightest_ < work_.limits.widest * (1 - 1e-9))
    plan_.note_turn(tightest_, shown_place(work_.task, tightest_at_));
}

std::vector<Segment> PassTaking::smooth(Pass& pass) {
  take_back(ground_, pass);
  pass.moves = joined(pass.moves);
  const double most = most_widening(params_.engagement_angle, work_.radius, params_.tolerance);
  std::vector<Segment> way = without_tight_turns(pass.moves, {work_.exact, work_.around}, ground_,
                                                 params_.engagement_angle, most);
  // What the wider turns left is met by the next turn of a pass that comes back to them.
  if (first_left_behind(way) > 0) pass.idle_after = idle_end_of(way, pass.idle_after, ground_);
  for (const Segment& move : pass.moves) ground_.add(move);
  return way;
}

bool PassTaking::go_and_take(Pass pass, double turn_radius, std::size_t before) {
  std::vector<Segment> way = smooth(pass);
  const double from_contact = length_of(pass.moves) - pass.idle_before;
  // Nearest to the material, or where nothing is near.
  std::vector<Segment> shorter = way;
  drop_first(shorter, pass.idle_before - kKeptIdle * work_.radius);
  const Pose nearest = start_of(shorter), start = start_of(way);
  const bool is_bit = turn_radius <= 0;  // of the exact border
  if (link_to(nearest, before) || (is_bit && back_to(nearest))) {
    way = std::move(shorter);
  } else if (!link_to(start, before) && !(is_bit && back_to(start))) {
    take_back(ground_, pass);  // the tool comes down before the pass is cut
    if (!come_down_at(start)) return false;
    for (const Segment& move : pass.moves) ground_.add(move);
  }
  if (is_bit) divide_run_up(way, length_of(way) - from_contact, pass, params_);
  pass.moves = std::move(way);
  return take(std::move(pass), turn_radius);
}

bool PassTaking::take(Pass pass, double turn_radius) {
  ground_.settle(settled_);
  settled_ = ground_.size();
  work_.look_again(pass.moves);
  // What lies at the ends of the way is cleared, but for less than counts as contact.
  drop_last(pass.moves, pass.idle_after - kKeptIdle * work_.radius);
  plan_.add_steered(pass.moves);
  if (work_.task.follow && !work_.task.is_part && !work_.goes_on) work_.task.follow(plan_.runs());
  if (turn_radius > 0 && turn_radius < std::min(tightest_, work_.limits.widest * (1 - 1e-9)))
    if (const Vec2 at = sharpest_of(pass.moves).b; is_narrow_at(at)) {
      tightest_ = turn_radius;
      tightest_at_ = at;
    }
  plan_.count_pass();
  return is_progress(pass, work_.radius);
}

bool PassTaking::link_to(const Pose& to, std::size_t before) {
  return plan_.link_to(to, work_.around, work_.link_turn(), before);
}

bool PassTaking::back_to(const Pose& to) {
  if (plan_.is_empty()) return false;
  const double longest = length_of_retract(distance(plan_.here().p, to.p), params_);
  const WayBack back = way_back(plan_.runs().back().moves, to, longest);
  if (!back.found) return false;
  const auto free = [&](const std::vector<Segment>& way) {
    return is_free({ground_, ground_.size()}, work_.exact, way, length_of(way));
  };
  plan_.add(MoveKind::kLink, beside_cuts(back.moves, params_.arcs, free));
  plan_.stand(to);
  return true;
}

bool PassTaking::come_down_at(const Pose& to) {
  const bool is_free = is_free_disc(ground_, work_.task.material, to.p);
  std::optional<Segment> way;
  if (work_.task.rest || !is_free)
    way = way_from_beside(ground_, work_.task.material, work_.exact, to, work_.link_turn());
  if (!way && !is_free) return false;
  plan_.plunge({way ? way->a : to.p, to.heading}, true);
  if (way) plan_.add(MoveKind::kLink, {*way});
  plan_.stand(to);
  return true;
}

bool PassTaking::is_narrow_at(Vec2 p) {
  if (!narrow_) {
    std::vector<Region> places;
    for (const Passage& passage :
         find_narrow_places(work_.task.centres, work_.limits.widest).passages)
      places.push_back(passage.centres);
    narrow_.emplace(places);
  }
  return !narrow_->empty() && narrow_->signed_distance(p) > -kOnNarrowWall;
}

}  // namespace evenload
