#include "strategy/choose/room_entries.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "strategy/moves/move_ends.h"
#include "strategy/reach/entry.h"
#include "strategy/reach/links.h"
#include "support/errors.h"

namespace evenload {
namespace {

// Rooms less wide than this share of the tool's radius get no entry of their own.
constexpr double kNarrowestRoom = 0.02;

}  // namespace

void RoomEntries::enter() {
  if (work_.task.rest) {  // every pass comes down over cleared ground by itself
    work_.look_everywhere();
    plan_.stand({work_.widest.centre, 0});
    return;
  }
  const bool hole_first = work_.task.hole && params_.entry == EntryKind::kPredrilledHole;
  const bool outside = work_.task.has_open_edges && params_.entry == EntryKind::kAutomatic;
  if (outside && !hole_first) {
    work_.look_everywhere();
    if (enter_from_outside()) return;
  }
  if (work_.task.hole) {
    const Plan::Mark above = plan_.mark();
    enter_hole();
    if (plan_.made().passes > 0 || work_.samples.uncleared_count() == 0) return;
    if (hole_first)
      throw GeometryError(Refusal::kHoleTooTight, shown_place(work_.task, *work_.task.hole));
    plan_.roll_back(above);
    plan_.tell({FindingCode::kHoleTooTight});
  }
  if (params_.entry == EntryKind::kPredrilledHole) {
    work_.look_everywhere();
    enter_from_before();
    return;
  }
  const std::optional<Pose> start = descend_in(work_.widest);
  if (!start)
    throw GeometryError(Refusal::kNoRoomToDescend, shown_place(work_.task, work_.widest.centre));
  work_.look_everywhere();
  cut_from(*start);
}

void RoomEntries::enter_from_before() {
  const std::vector<PassStart> starts = work_.samples.starts();
  if (!starts.empty()) plan_.plunge(starts.front().pose, true);
}

bool RoomEntries::enter_from_outside() {
  const std::vector<PassStart> starts = work_.samples.starts();
  const std::optional<Vec2>& wish = params_.open_side;
  const auto off = [&wish](const Pose& pose) { return wish ? distance(pose.p, *wish) : 0; };
  const auto first = std::min_element(
      starts.begin(), starts.end(),
      [&](const PassStart& a, const PassStart& b) { return off(a.pose) < off(b.pose); });
  std::optional<Pose> start;
  if (wish || starts.empty())
    start = start_outside(work_.exact, work_.task.material, ground_, wish);
  if (first != starts.end() && (!start || off(first->pose) <= off(*start))) {
    plan_.plunge(first->pose, false);
    return true;
  }
  if (!start) return false;
  plan_.plunge(*start, false);
  cut_from(*start);
  return true;
}

void RoomEntries::enter_hole() {
  const double room = 0.5 * params_.hole_diameter - work_.radius;
  work_.look_everywhere();
  plan_.plunge({*work_.task.hole, 0}, false);
  const Pose start{*work_.task.hole + Vec2{room, 0}, kPi / 2};
  // From the centre to the rim by half a turn, which ends along the rim.
  std::vector<Segment> way;
  if (room > 1e-6)
    way.push_back(Segment::arc(*work_.task.hole + Vec2{room / 2, 0}, room / 2, kPi, kPi));
  if (is_free({ground_, ground_.size()}, work_.exact, way, length_of(way))) {
    plan_.add(MoveKind::kLink, way);
    plan_.stand(start);
    cut_from(start);
  }
}

std::optional<Pose> RoomEntries::descend_in(const Circle& room) {
  std::optional<Entry> entry = descend_within(work_.exact, room, params_);
  if (!entry) return std::nullopt;
  if (params_.entry == EntryKind::kHelix && entry->descent.kind == DescentKind::kRamp)
    plan_.tell({FindingCode::kRampForHelix});
  if (params_.entry == EntryKind::kRamp && choice_.leads_nowhere(*entry))
    if (std::optional<Entry> helix = helix_within(work_.exact, room, params_)) {
      entry = std::move(helix);
      plan_.tell({FindingCode::kHelixForRamp});
    }
  // Who asks for a helix shall have the one that was asked for, where it fits.
  const bool may_stretch = work_.task.stretch_helix || params_.entry != EntryKind::kHelix ||
                           is_shrunk(entry->descent, params_);
  if (may_stretch && !work_.task.round_helix) stretch_helix(*entry, work_.exact, params_);
  fill_narrow_room(*entry, room, params_);
  if (ground_.size() > 0 || work_.task.rest || work_.task.has_open_edges)
    entry->descent.new_area = area_cut_by(entry->descent, ground_);
  plan_.come_down(entry->descent);
  return entry->start;
}

bool RoomEntries::enter_untouched() { return enter_next(untouched_, false); }

bool RoomEntries::enter_next(NextRoom& next, bool touched_too) {
  if (params_.entry == EntryKind::kPredrilledHole) return false;
  for (; next.stage < work_.stages.size(); ++next.stage, next.room = 0)
    for (; next.room < work_.stages[next.stage].rooms.size(); ++next.room)
      if (enter_room(work_.stages[next.stage].rooms[next.room], touched_too)) return true;
  return false;
}

bool RoomEntries::enter_room(const Region& room, bool touched_too) {
  if (!touched_too && has_cleared_wall(room)) return false;
  const Circle circle = largest_circle(room, kEntryTolerance);
  const bool reached =
      touched_too ? ground_.is_clear(circle.centre) : ground_.is_cleared_point(circle.centre);
  // Where nothing is cut yet there is no other way to begin, however narrow the room is.
  const bool is_narrow = !plan_.is_empty() && circle.radius < kNarrowestRoom * work_.radius;
  if (is_narrow || reached) return false;
  const std::optional<Pose> start = descend_in(circle);
  if (!start) return false;
  work_.look_again(plan_.runs().back().descent);
  cut_from(*start);
  return true;
}

bool RoomEntries::has_cleared_wall(const Region& room) const {
  for (const Curve& curve : room.curves())
    for (const Segment& segment : curve.segments())
      if (ground_.is_clear(segment.a) || ground_.is_clear(segment.point(0.5))) return true;
  return false;
}

void RoomEntries::cut_from(const Pose& start) {
  double turn_radius = 0;
  Pass pass = choice_.from_entry(start, &turn_radius);
  if (!pass.empty()) passes_.take_from_here(std::move(pass), turn_radius);
}

}  // namespace evenload
