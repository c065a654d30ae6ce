#include "strategy/passage_clearing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "feed/load_profile.h"
#include "geometry/arc_fit.h"
#include "geometry/box_tree.h"
#include "strategy/entry.h"
#include "strategy/links.h"

namespace evenload {
namespace {

// mm: by which arcs in place of the middle's points leave them.
constexpr double kFit = kAxisTolerance;
// Share of the tool's radius: no shorter parts of a move are told apart as free.
constexpr double kLook = 0.5;
// Of the wall's length: where a tool's radius is more, the wall has one feed.
constexpr double kShortWall = 0.3;
// mm: a wall this much further than the nearest one is touched as well.
constexpr double kTouched = 1e-3;
constexpr std::size_t kNone = ~std::size_t{0};

std::vector<Segment> reversed(const std::vector<Segment>& moves) {
  std::vector<Segment> result;
  for (auto move = moves.rbegin(); move != moves.rend(); ++move) result.push_back(move->reversed());
  return result;
}

// The widest place of a passage's middle.
std::size_t widest_point(const PassageAxis& axis) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < axis.points.size(); ++i)
    if (axis.points[i].radius > axis.points[best].radius + 1e-9) best = i;
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
        centres_({task.centres}),
        ground_(grown(bounds_of({task.centres}), 0.5 * params.tool_diameter),
                0.5 * params.tool_diameter, task.has_open_edges ? &task.material : nullptr),
        room_done_(places.rooms.size(), 0),
        passage_done_(places.passages.size(), 0) {
    if (task.hole) ground_.add_disc(*task.hole, 0.5 * params.hole_diameter);
  }

  RegionResult run() {
    begin();
    while (!progress_.cancelled()) {
      const std::size_t passage = next_passage();
      if (passage == kNone) break;
      cut_passage(passage);
    }
    return std::move(result_);
  }

 private:
  // ---- order ----

  void begin() {
    if (places_.rooms.empty()) return;
    std::size_t first = kNone;
    for (std::size_t i = 0; i < places_.rooms.size(); ++i) {
      const Region& room = places_.rooms[i];
      if (task_.hole) {
        if (room.contains(*task_.hole)) first = i;
      } else if (task_.has_open_edges && params_.entry == EntryKind::kAutomatic &&
                 start_outside(Area({room}), task_.material, ground_)) {
        first = i;
        break;
      }
    }
    if (first == kNone && task_.hole) return;  // the hole is in a passage
    if (first == kNone)
      for (std::size_t i = 0; i < places_.rooms.size(); ++i)
        if (first == kNone || places_.rooms[i].area() > places_.rooms[first].area()) first = i;
    clear_room(first);
  }

  // A passage that opens into a room that is done; the first of all at the beginning.
  std::size_t next_passage() const {
    const bool at_start = result_.runs.empty();
    for (std::size_t k = 0; k < passage_done_.size(); ++k) {
      if (passage_done_[k]) continue;
      const std::vector<std::size_t>& rooms = places_.passages[k].rooms;
      if (at_start ? !task_.hole || places_.passages[k].centres.contains(*task_.hole)
                   : std::any_of(rooms.begin(), rooms.end(),
                                 [&](std::size_t room) { return room_done_[room]; }))
        return k;
    }
    return kNone;
  }

  void clear_room(std::size_t index) {
    const Region& room = places_.rooms[index];
    RegionTask task = task_;
    task.centres = room;
    if (task.hole && !room.contains(*task.hole)) task.hole.reset();
    task.around = {task_.centres};
    task.before = result_.runs;
    const double done = share_done(), all = task_.centres.area();
    room_done_[index] = 1;
    Progress share([&](double part) {
      return progress_.report(done + part * std::min(1 - done, room.area() / all));
    });
    RegionResult cleared = clear_region(task, params_, share);
    for (PlanarRun& run : cleared.runs) {
      run.new_region = result_.runs.empty();
      add_descent(run.descent, ground_);
      for (const PlanarMove& move : run.moves) ground_.add(move.segment);
      result_.runs.push_back(std::move(run));
    }
    if (!result_.runs.empty() && !result_.runs.back().moves.empty()) {
      const Segment& last = result_.runs.back().moves.back().segment;
      here_ = {last.b, angle_of(last.tangent(1))};
    }
    result_.uncut_area += cleared.uncut_area;
    result_.passes += cleared.passes;
    result_.links += cleared.links;
    for (std::string& note : cleared.notes) result_.notes.push_back(std::move(note));
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

  void cut_passage(std::size_t k) {
    number_ = first_number_ + static_cast<int>(k);
    const PassageAxis& axis = axes_[k];
    passage_done_[k] = 1;
    const std::size_t root = axis.points.empty() ? kNone : come_to(axis, k);
    if (root != kNone) follow_walls(axis, places_.passages[k], follow_middle(axis, root));
    progress_.report(share_done());
    for (const std::size_t room : places_.passages[k].rooms)
      if (!room_done_[room] && !progress_.cancelled()) clear_room(room);
  }

  // Brings the tool to a point of the middle where it may begin.
  std::size_t come_to(const PassageAxis& axis, std::size_t k) {
    if (!result_.runs.empty()) {
      const std::size_t mouth = nearest_clear(axis, true);
      if (mouth != kNone) {
        link_or_retract(axis, mouth);
        return mouth;
      }
    }
    const bool is_new = result_.runs.empty();
    if (task_.hole && places_.passages[k].centres.contains(*task_.hole)) {
      result_.runs.push_back({{DescentKind::kPlunge, *task_.hole, {}, 0, {}, false}, {}, is_new});
      here_ = {*task_.hole, 0};
      return go_to_nearest(axis);
    }
    if (const std::size_t outside = nearest_clear(axis, false);
        outside != kNone && task_.has_open_edges && params_.entry == EntryKind::kAutomatic) {
      const Vec2 at = axis.points[outside].p;
      result_.runs.push_back({{DescentKind::kPlunge, at, {}, 0, {}, false}, {}, is_new});
      here_ = {at, 0};
      return outside;
    }
    if (params_.entry == EntryKind::kPredrilledHole) return kNone;
    return descend(axis, is_new);
  }

  // A ramp along the passage: a helix as narrow as this would be a plunge.
  std::size_t descend(const PassageAxis& axis, bool is_new) {
    const std::size_t widest = widest_point(axis);
    ClearingParams params = params_;
    params.entry = EntryKind::kRamp;
    const Vec2 at = axis.points[widest].p;
    const std::optional<Entry> entry =
        descend_within(centres_, {at, axis.points[widest].radius}, params);
    if (!entry) return kNone;
    add_descent(entry->descent, ground_);
    result_.runs.push_back({entry->descent, {}, is_new});
    here_ = entry->start;
    return widest;
  }

  std::size_t nearest_clear(const PassageAxis& axis, bool mouths) const {
    std::size_t best = kNone;
    for (std::size_t i = 0; i < axis.points.size(); ++i) {
      if (axis.points[i].is_mouth != mouths && mouths) continue;
      if (best != kNone &&
          squared_norm(axis.points[i].p - here_.p) >= squared_norm(axis.points[best].p - here_.p))
        continue;
      if (ground_.is_clear(axis.points[i].p)) best = i;
    }
    return best;
  }

  // From a hole to the middle, straight.
  std::size_t go_to_nearest(const PassageAxis& axis) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < axis.points.size(); ++i)
      if (squared_norm(axis.points[i].p - here_.p) < squared_norm(axis.points[best].p - here_.p))
        best = i;
    const Vec2 to = axis.points[best].p;
    for (int i = 0; i <= 8; ++i)
      if (centres_.signed_distance(here_.p + (i / 8.0) * (to - here_.p)) < -kZeroLength)
        return kNone;
    go({Segment::line(here_.p, to)});
    return best;
  }

  void link_or_retract(const PassageAxis& axis, std::size_t mouth) {
    const PassageAxis::Point& point = axis.points[mouth];
    const Pose to{point.p, angle_of(axis.points[point.next.front()].p - point.p)};
    const double turn = std::min(params_.roll_radius, params_.minimum_radius);
    const double retract = 2 * (params_.safe_height - params_.levels.back()) / params_.rapid_feed;
    const std::vector<Segment> link = shortest_link({ground_, ground_.size()}, centres_, here_, to,
                                                    turn, retract * params_.link_feed);
    if (!link.empty()) {
      add(MoveKind::kLink, link);
      ++result_.links;
      return;
    }
    retract_to(point.p);
  }

  void retract_to(Vec2 p) {
    result_.runs.push_back({{DescentKind::kPlunge, p, {}, 0, {}, true}, {}, false});
    here_ = {p, 0};
  }

  // ---- moves ----

  void add(MoveKind kind, const std::vector<Segment>& moves) {
    for (const Segment& move : moves) {
      PlanarMove planar;
      planar.kind = kind;
      planar.segment = move;
      if (kind == MoveKind::kCut) planar.passage = number_;
      result_.runs.back().moves.push_back(planar);
      ground_.add(move);
    }
    if (!moves.empty()) here_ = {moves.back().b, angle_of(moves.back().tangent(1))};
  }

  // Every move as a link where it meets nothing, else as a cut.
  void go(const std::vector<Segment>& moves) {
    for (const Segment& move : moves) {
      if (move.length() < kZeroLength) continue;
      const int n = std::max(1, static_cast<int>(move.length() / (kLook * ground_.tool_radius())));
      const auto part = [&](int from, int to) {
        return move.part(static_cast<double>(from) / n, static_cast<double>(to) / n);
      };
      std::vector<char> free;
      free.reserve(static_cast<std::size_t>(n));
      for (int i = 0; i < n; ++i)
        free.push_back(
            is_free({ground_, ground_.size()}, centres_, {part(i, i + 1)}, move.length()) ? 1 : 0);
      for (int first = 0, last = 0; first < n; first = last) {
        const char kind = free[static_cast<std::size_t>(first)];
        while (last < n && free[static_cast<std::size_t>(last)] == kind) ++last;
        add(kind ? MoveKind::kLink : MoveKind::kCut, {part(first, last)});
      }
    }
  }

  // ---- the middle ----

  // A stretch of the middle between forks, ends and the root.
  struct Chain {
    std::size_t to = 0;
    std::vector<Segment> moves;
  };

  // Cuts every branch once, from forks that are reached already, and comes back on what is cut.
  // Returns the point where it ends.
  std::size_t follow_middle(const PassageAxis& axis, std::size_t root) {
    std::vector<std::vector<char>> used(axis.points.size());
    for (std::size_t i = 0; i < axis.points.size(); ++i)
      used[i].assign(axis.points[i].next.size(), 0);
    std::vector<Chain> way;  // from the root to here
    std::size_t at = root;
    while (!progress_.cancelled()) {
      const auto free = std::find(used[at].begin(), used[at].end(), 0);
      if (free != used[at].end()) {
        Chain chain =
            follow(axis, at, static_cast<std::size_t>(free - used[at].begin()), root, used);
        const std::size_t from = at;
        at = chain.to;
        go(chain.moves);
        ++result_.passes;
        chain.to = from;
        way.push_back(std::move(chain));
        continue;
      }
      if (std::none_of(used.begin(), used.end(), [](const std::vector<char>& flags) {
            return std::find(flags.begin(), flags.end(), 0) != flags.end();
          }))
        return at;
      if (way.empty()) return at;
      add(MoveKind::kLink, reversed(way.back().moves));
      at = way.back().to;
      way.pop_back();
    }
    return at;
  }

  static Chain follow(const PassageAxis& axis, std::size_t from, std::size_t branch,
                      std::size_t root, std::vector<std::vector<char>>& used) {
    std::vector<Vec2> points{axis.points[from].p};
    std::size_t at = from, out = branch;
    for (;;) {
      const std::size_t next = axis.points[at].next[out];
      used[at][out] = 1;
      const std::vector<std::size_t>& neighbours = axis.points[next].next;
      for (std::size_t i = 0; i < neighbours.size(); ++i)
        if (neighbours[i] == at && !used[next][i]) {
          used[next][i] = 1;
          break;
        }
      points.push_back(axis.points[next].p);
      at = next;
      if (neighbours.size() != 2 || at == root) break;
      const auto free = std::find(used[at].begin(), used[at].end(), 0);
      if (free == used[at].end()) break;
      out = static_cast<std::size_t>(free - used[at].begin());
    }
    return {at, fit_arcs(points, kFit).segments()};
  }

  // ---- the walls ----

  // Along every loop of the passage's border, mouths straight across. The walls lie to the right.
  void follow_walls(const PassageAxis& axis, const Passage& passage, std::size_t at) {
    for (const std::vector<PassageBorder>& loop : passage.loops) {
      if (progress_.cancelled()) return;
      const std::vector<Segment> moves = straight_over_mouths(loop);
      std::size_t from = at;
      double best = excess(axis, at, moves);
      for (std::size_t i = 0; best > kTouched && i < axis.points.size(); ++i) {
        const double value = excess(axis, i, moves);
        if (value < best) {
          best = value;
          from = i;
        }
      }
      if (from != at) retract_to(axis.points[from].p);
      at = from;
      follow_loop(moves, axis.points[at].p);
      ++result_.passes;
    }
  }

  static std::vector<Segment> straight_over_mouths(const std::vector<PassageBorder>& loop) {
    std::vector<Segment> moves;
    moves.reserve(loop.size());
    for (const PassageBorder& piece : loop)
      moves.push_back(piece.is_mouth ? Segment::line(piece.segment.a, piece.segment.b)
                                     : piece.segment);
    return moves;
  }

  // mm: how much further than the nearest wall the loop is from a point of the middle.
  static double excess(const PassageAxis& axis, std::size_t point,
                       const std::vector<Segment>& loop) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Segment& piece : loop)
      nearest = std::min(nearest, piece.distance_to(axis.points[point].p));
    return nearest - axis.points[point].radius;
  }

  // From `middle` to the nearest place of the loop, all round, and back.
  void follow_loop(const std::vector<Segment>& loop, Vec2 middle) {
    std::size_t first = 0;
    for (std::size_t i = 1; i < loop.size(); ++i)
      if (loop[i].distance_to(middle) < loop[first].distance_to(middle) - 1e-9) first = i;
    const double t = loop[first].nearest(middle);
    const Vec2 start = loop[first].point(t);
    std::vector<Segment> moves{Segment::line(middle, start)};
    if (t < 1) add_with_ends(moves, loop[first].part(t, 1));
    for (std::size_t i = 1; i < loop.size(); ++i)
      add_with_ends(moves, loop[(first + i) % loop.size()]);
    if (t > 0) add_with_ends(moves, loop[first].part(0, t));
    moves.push_back(Segment::line(start, middle));
    go(moves);
  }

  // In corners the tool meets more than between them: the ends get feeds of their own.
  void add_with_ends(std::vector<Segment>& moves, const Segment& wall) const {
    const double share = ground_.tool_radius() / wall.length();
    if (share > kShortWall) {
      moves.push_back(wall);
      return;
    }
    moves.push_back(wall.part(0, share));
    moves.push_back(wall.part(share, 1 - share));
    moves.push_back(wall.part(1 - share, 1));
  }

  const RegionTask& task_;
  const NarrowPlaces& places_;
  const std::vector<PassageAxis>& axes_;
  int first_number_;
  const ClearingParams& params_;
  Progress& progress_;
  Area centres_;
  ClearedGround ground_;
  std::vector<char> room_done_, passage_done_;
  RegionResult result_;
  Pose here_;
  int number_ = 0;
};

}  // namespace

RegionResult clear_with_passages(const RegionTask& task, const NarrowPlaces& places,
                                 const std::vector<PassageAxis>& axes, int first_number,
                                 const ClearingParams& params, Progress& progress) {
  return PassageClearing(task, places, axes, first_number, params, progress).run();
}

}  // namespace evenload
