#include "strategy/passage/passage_clearing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/box_tree.h"
#include "strategy/choose/leftover.h"
#include "strategy/choose/region_clearing.h"
#include "strategy/moves/move_checks.h"
#include "strategy/passage/passage_middle.h"
#include "strategy/passage/passage_path.h"
#include "strategy/passage/passage_walls.h"
#include "strategy/reach/entry.h"
#include "support/tolerances.h"

namespace evenload {
namespace {

// rad: the way from a hole to the middle turns by no more.
constexpr double kMostTurn = 0.9 * kPi;

// The widest place of a passage's middle; an end, from which one way leads on, where that is as
// wide.
std::size_t widest_point(const PassageAxis& axis) {
  const auto is_end = [&](std::size_t i) { return axis.points[i].next.size() == 1; };
  std::size_t best = 0;
  for (std::size_t i = 1; i < axis.points.size(); ++i) {
    const double wider = axis.points[i].radius - axis.points[best].radius;
    if (wider > kAxisTolerance || (wider > -kAxisTolerance && is_end(i) && !is_end(best))) best = i;
  }
  return best;
}

class PassageClearing {
 public:
  PassageClearing(const RegionTask& task, const NarrowPlaces& places,
                  const std::vector<PassageAxis>& axes, int first_number,
                  const ClearingParams& params, Progress& progress)
      : task_(task),
        places_(places),
        axes_(axes),
        first_number_(first_number),
        params_(params),
        progress_(progress),
        path_(task, params, progress),
        plan_(path_.plan()),
        room_done_(places.rooms.size(), 0),
        passage_done_(places.passages.size(), 0) {}

  RegionResult run() {
    try {
      begin();
      while (!progress_.cancelled()) {
        const std::size_t passage = next_passage();
        if (passage == kNoIndex) break;
        cut_passage(passage);
      }
    } catch (const Cancelled&) {  // what is made is kept
    }
    return plan_.take();
  }

 private:
  // ---- order ----

  void begin() {
    if (places_.rooms.empty()) return;
    std::size_t first = kNoIndex;
    double nearest = 0;  // mm, of its open side to the place that is wished
    for (std::size_t i = 0; i < places_.rooms.size(); ++i) {
      const Region& room = places_.rooms[i];
      if (task_.hole) {
        if (room.contains(*task_.hole)) first = i;
      } else if (task_.has_open_edges && params_.entry == EntryKind::kAutomatic) {
        const std::optional<Pose> start =
            start_outside(Area({room}), task_.material, plan_.ground(), params_.open_side);
        const double off = start && params_.open_side ? distance(start->p, *params_.open_side) : 0;
        if (!start || (first != kNoIndex && off >= nearest)) continue;
        first = i;
        nearest = off;
      }
    }
    if (first == kNoIndex && task_.hole) return;  // the hole is in a passage
    if (first == kNoIndex)
      for (std::size_t i = 0; i < places_.rooms.size(); ++i)
        if (first == kNoIndex || places_.rooms[i].area() > places_.rooms[first].area()) first = i;
    clear_room(first);
  }

  // A passage that opens into a room that is done; the first of all at the beginning.
  std::size_t next_passage() const {
    const bool at_start = plan_.is_empty();
    for (std::size_t k = 0; k < passage_done_.size(); ++k) {
      if (passage_done_[k]) continue;
      const std::vector<std::size_t>& rooms = places_.passages[k].rooms;
      if (at_start ? !task_.hole || places_.passages[k].centres.contains(*task_.hole)
                   : std::any_of(rooms.begin(), rooms.end(),
                                 [&](std::size_t room) { return room_done_[room]; }))
        return k;
    }
    return kNoIndex;
  }

  void clear_room(std::size_t index) {
    const Region& room = places_.rooms[index];
    RegionTask task = task_;
    task.centres = room;
    if (task.hole && !room.contains(*task.hole)) task.hole.reset();
    task.around = {task_.centres};
    task.round_helix = !places_.passages.empty() && places_.passages.front().by_ramp;
    task.follow = nullptr;  // what it is told of begins with the first room
    const double done = share_done(), all = task_.centres.area();
    room_done_[index] = 1;
    Progress share([&](double part) {
      return progress_.report(done + part * std::min(1 - done, room.area() / all));
    });
    Plan by_itself(task, params_, share);
    by_itself.know(plan_.runs());
    clear_region(by_itself, task, params_, share);
    plan_.append(by_itself.take());
  }

  double share_done() const {
    double area = 0;
    for (std::size_t i = 0; i < room_done_.size(); ++i)
      if (room_done_[i]) area += places_.rooms[i].area();
    for (std::size_t k = 0; k < passage_done_.size(); ++k)
      if (passage_done_[k]) area += places_.passages[k].centres.area();
    return std::min(1.0, area / task_.centres.area());
  }

  // ---- one passage ----

  // The middle, then the rooms behind it, which leave its mouths clear, then the walls. Rooms that
  // are begun from their mouths need the walls' cut first.
  void cut_passage(std::size_t k) {
    const int number = first_number_ + static_cast<int>(k);
    const PassageAxis& axis = axes_[k];
    passage_done_[k] = 1;
    if (places_.passages[k].by_ramp) {
      clear_rooms_beside(k);
      if (!progress_.cancelled()) ramp_through(places_.passages[k]);
      return;
    }
    const std::size_t root = axis.points.empty() ? kNoIndex : come_to(axis, k);
    if (root != kNoIndex) follow_middle(axis, root, number, path_, progress_);
    const bool walls_first = params_.entry == EntryKind::kPredrilledHole;
    if (!walls_first) clear_rooms_beside(k);
    if (root != kNoIndex && !progress_.cancelled())
      follow_walls(places_.passages[k], axis, number, params_, path_);
    if (walls_first) clear_rooms_beside(k);
  }

  // Between rooms that are clear; the way round the border leaves nothing.
  void ramp_through(const Passage& neck) {
    Descent ramp = ramp_along(neck.centres.outer, params_);
    if (ramp.ramp_by.empty()) return;  // some 0.0001 mm: no more than passes leave in corners
    Leftover left;
    left.prepare(Area({neck.centres}),
                 grown(bounds_of({neck.centres}), 0.5 * params_.tool_diameter), plan_.ground());
    ramp.new_area = left.area(plan_.ground());
    plan_.come_down(ramp, {ramp.at, angle_of(ramp.ramp_by.front() - ramp.at)});
  }

  void clear_rooms_beside(std::size_t k) {
    progress_.report(share_done());
    for (const std::size_t room : places_.passages[k].rooms)
      if (!room_done_[room] && !progress_.cancelled()) clear_room(room);
  }

  // Brings the tool to a point of the middle where it may begin.
  std::size_t come_to(const PassageAxis& axis, std::size_t k) {
    if (!plan_.is_empty()) {
      const std::size_t mouth = nearest_mouth(axis);
      if (mouth != kNoIndex) {
        path_.reach(pose_at(axis, mouth, axis.points[mouth].next.front()));
        return mouth;
      }
    }
    if (task_.hole && places_.passages[k].centres.contains(*task_.hole)) {
      plan_.plunge({*task_.hole, 0}, false);
      return go_from_hole(axis, first_number_ + static_cast<int>(k));
    }
    if (const std::size_t outside = place_outside(axis);
        outside != kNoIndex && task_.has_open_edges && params_.entry == EntryKind::kAutomatic) {
      plan_.plunge({axis.points[outside].p, 0}, false);
      return outside;
    }
    if (params_.entry == EntryKind::kPredrilledHole) return kNoIndex;
    return descend(axis);
  }

  // A ramp along the passage: a helix as narrow as this would be a plunge.
  std::size_t descend(const PassageAxis& axis) {
    const std::size_t widest = widest_point(axis);
    ClearingParams params = params_;
    params.entry = EntryKind::kRamp;
    const Vec2 at = axis.points[widest].p;
    const std::optional<Entry> entry =
        descend_within(path_.centres(), {at, axis.points[widest].radius}, params);
    if (!entry) return kNoIndex;
    plan_.come_down(entry->descent, entry->start);
    const bool is_done = entry->descent.ramp_by.size() > 1;  // round the border
    return is_done ? kNoIndex : widest;
  }

  std::size_t nearest_mouth(const PassageAxis& axis) const {
    std::size_t best = kNoIndex;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < axis.points.size(); ++i) {
      const double d = distance(axis.points[i].p, path_.here().p);
      if (!axis.points[i].is_mouth || d >= nearest || !path_.is_clear(axis.points[i].p)) continue;
      best = i;
      nearest = d;
    }
    return best;
  }

  // The last place of the middle before the material; any clear one where there is no such place.
  std::size_t place_outside(const PassageAxis& axis) const {
    std::size_t any = kNoIndex;
    for (std::size_t i = 0; i < axis.points.size(); ++i) {
      if (!path_.is_clear(axis.points[i].p)) continue;
      any = i;
      for (const std::size_t next : axis.points[i].next)
        if (!path_.is_clear(axis.points[next].p)) return i;
    }
    return any;
  }

  // From a hole's centre by one arc that ends along the middle; straight where none has room.
  std::size_t go_from_hole(const PassageAxis& axis, int number) {
    const Vec2 hole = path_.here().p;
    std::size_t best = kNoIndex, nearest = 0;
    Segment way;
    for (std::size_t i = 0; i < axis.points.size(); ++i) {
      const Vec2 to = axis.points[i].p - hole;
      if (norm(to) < norm(axis.points[nearest].p - hole)) nearest = i;
      for (const std::size_t next : axis.points[i].next) {
        const double turn =
            2 * wrap_signed(pose_at(axis, i, next).heading - (norm(to) > 0 ? angle_of(to) : 0));
        const Segment arc = Segment::from_bulge(hole, axis.points[i].p, std::tan(turn / 4));
        if (norm(to) < kZeroLength || std::abs(turn) > kMostTurn || !stays_inside(arc)) continue;
        if (best != kNoIndex && arc.length() >= way.length()) continue;
        best = i;
        way = arc;
      }
    }
    if (norm(axis.points[nearest].p - hole) < kZeroLength) return nearest;
    if (best == kNoIndex) {
      way = Segment::line(hole, axis.points[nearest].p);
      if (!stays_inside(way)) return kNoIndex;
      best = nearest;
    }
    path_.follow({way}, number);
    return best;
  }

  bool stays_inside(const Segment& move) const {
    return is_inside(move, path_.centres(), kZeroLength);
  }

  const RegionTask& task_;
  const NarrowPlaces& places_;
  const std::vector<PassageAxis>& axes_;
  int first_number_;
  const ClearingParams& params_;
  Progress& progress_;
  PassagePath path_;
  Plan& plan_;  // the path's
  std::vector<char> room_done_, passage_done_;
};

}  // namespace

RegionResult clear_with_passages(const RegionTask& task, const NarrowPlaces& places,
                                 const std::vector<PassageAxis>& axes, int first_number,
                                 const ClearingParams& params, Progress& progress) {
  return PassageClearing(task, places, axes, first_number, params, progress).run();
}

}  // namespace evenload
