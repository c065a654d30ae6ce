#include "strategy/region_clearing.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>

#include "geometry/box_tree.h"
#include "geometry/medial_axis.h"
#include "strategy/free_place.h"
#include "strategy/leftover.h"
#include "strategy/links.h"
#include "strategy/steering.h"
#include "strategy/wall_samples.h"
#include "support/errors.h"

namespace evenload {
namespace {

// Left turns are never tighter than this share of the tool's radius, but at the exact border's
// corners.
constexpr double kTightestTurn = 0.001;
// mm: a corner is left to the exact border once it is so short that the mean engagement over 0.1 mm
// stays low in it.
constexpr double kShortCorner = 0.05;
// A helix narrower than this share of the tool's radius rubs; a ramp takes its place.
constexpr double kNarrowestHelix = 0.02;
// mm: of the place of an entry.
constexpr double kEntryTolerance = 1e-3;
// mm: a place of one stage's wall this near to another's is the same place.
constexpr double kSamePlace = 1e-4;
// There is a stage that turns as tightly as this share of the entry's radius: a first pass that
// turns less tightly than the entry's circle would run into more material than the limit allows.
constexpr double kFirstTurn = 0.5;
// A helix stays this share of its room away from the walls.
constexpr double kHelixRoom = 0.98;
// Directions in which room for a ramp is looked for.
constexpr int kRampDirections = 180;
// A ramp is no longer than this many tool diameters.
constexpr double kLongestRamp = 1.5;
// s: what the stops of a retract, two of them at corners in the air, cost beyond its length;
// staying down is gentler.
constexpr double kRetractPrice = 0.3;
// A pass that removes less than this share of the tool's radius squared is little progress.
constexpr double kLeastCut = 1e-4;

class RegionClearing {
 public:
  RegionClearing(const RegionTask& task, const ClearingParams& params, Progress& progress)
      : task_(task),
        params_(params),
        progress_(progress),
        radius_(0.5 * params.tool_diameter),
        exact_({task.centres}),
        widest_(largest_circle(task.centres, kEntryTolerance)),
        ground_(grown(bounds_of({task.centres}), radius_), radius_,
                task.has_open_edges || task.rest ? &task.material : nullptr),
        stages_(stages()),
        samples_(stages_, ground_) {}

  RegionResult run() {
    enter();
    clear_all();
    if (!progress_.cancelled()) report();
    return std::move(result_);
  }

 private:
  Vec2 shown(Vec2 p) const { return {task_.mirrored ? -p.x : p.x, p.y}; }

  void report() {
    result_.uncut_area = leftover_.area(ground_);
    if (result_.uncut_area > 0) {
      const Vec2 at = shown(*leftover_.place());
      std::ostringstream note;
      note << std::fixed << std::setprecision(2) << "Left uncut: " << result_.uncut_area
           << " mm² near (" << at.x << ", " << at.y << "), "
           << (params_.wall_pass
                   ? "where the tool has too little room to turn within the engagement limit."
                   : "for the turned-off WallPass, or where the tool has too little room to turn.");
      result_.notes.push_back(note.str());
    }
    const double wish = limits().widest;
    if (tightest_ < wish * (1 - 1e-9)) {
      std::ostringstream note;
      note << std::fixed << std::setprecision(3) << "Turned more tightly than the wished " << wish
           << " mm in corners and narrow places, down to " << tightest_ << " mm near ("
           << std::setprecision(2) << shown(tightest_at_).x << ", " << tightest_at_.y << ").";
      result_.notes.push_back(note.str());
    }
  }

  StageLimits limits() const {
    const double wish = std::max(params_.roll_radius, params_.minimum_radius);
    const double tightest = kTightestTurn * 0.5 * params_.tool_diameter;
    return {std::max(wish, tightest), tightest, kShortCorner, kFirstTurn * entry_radius()};
  }

  // mm: of the circle that the tool's centre runs on before the first pass.
  double entry_radius() const {
    return task_.hole ? 0.5 * params_.hole_diameter - radius_ : helix_radius(widest_);
  }

  // Wider than the tool's radius a helix would leave a post in its middle.
  double helix_radius(const Circle& room) const {
    return std::min({0.5 * params_.helix_diameter, kHelixRoom * room.radius, 0.98 * radius_});
  }

  std::vector<Stage> stages() const {
    std::vector<Stage> all = make_stages(task_.centres, limits());
    if (!params_.wall_pass && all.size() > 1) all.pop_back();  // the exact border
    return all;
  }

  // Right turns shrink with the stage's left turns.
  Steering steering_at(std::size_t k) {
    const double share = std::min(1.0, stages_[k].turn_radius / limits().widest);
    return Steering(ground_, stages_[k], params_.engagement_angle,
                    std::max(params_.minimum_radius * share, kTightestTurn * radius_));
  }

  std::size_t widest_stage_at(const Pose& pose) const {
    for (std::size_t k = 0; k < stages_.size(); ++k) {
      if (stages_[k].turn_radius <= 0) break;
      const Vec2 q = pose.p + stages_[k].turn_radius * left_normal(unit(pose.heading));
      if (stages_[k].turns.signed_distance(q) > -1e-6) return k;
    }
    return stages_.size();
  }

  void begin_run(const Descent& descent) {
    result_.runs.push_back({descent, {}, result_.runs.empty()});
    here_ = {descent.at, 0};
  }

  void add_moves(MoveKind kind, const std::vector<Segment>& moves) {
    for (const Segment& move : moves) result_.runs.back().moves.push_back({kind, move, 0});
    if (!moves.empty()) here_ = {moves.back().b, angle_of(moves.back().tangent(1))};
  }

  void look_again(const std::vector<Segment>& moves) {
    Vec2 low = here_.p, high = here_.p;
    for (const Segment& move : moves)
      for (int i = 0; i <= 4; ++i) {
        const Vec2 p = move.point(i / 4.0);
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    samples_.update(low, high);
  }

  // Comes down, and cuts the first pass, a spiral, as far as it goes.
  void enter() {
    const Bounds everywhere = bounds_of({task_.centres});
    if (task_.rest) {  // every pass comes down over cleared ground by itself
      samples_.update(everywhere.low, everywhere.high);
      here_ = {widest_.centre, 0};
      return;
    }
    const bool hole_first = task_.hole && params_.entry == EntryKind::kPredrilledHole;
    const bool outside = task_.has_open_edges && params_.entry == EntryKind::kAutomatic;
    if (outside && !hole_first) {
      samples_.update(everywhere.low, everywhere.high);
      if (enter_from_outside()) return;
    }
    if (task_.hole) {
      enter_hole();
      if (result_.passes == 0 && leftover_to_cut())
        throw GeometryError(GeometryErrorCode::kEntryOutside, shown(*task_.hole),
                            "The pre-drilled hole is too tight to start from: drill it wider, or "
                            "choose the entry 'Automatic' or 'Helix'.");
      return;
    }
    Descent descent;
    const Pose start = choose_entry(widest_, descent);
    samples_.update(everywhere.low, everywhere.high);
    begin_run(descent);
    cut_from(start);
  }

  // Over an open edge: where a wall leads into the material, or straight at it. False when the tool
  // finds no room outside.
  bool enter_from_outside() {
    const std::vector<PassStart> starts = samples_.starts();
    if (!starts.empty()) {
      begin_run({DescentKind::kPlunge, starts.front().pose.p, {}, 0, {}, false});
      here_ = starts.front().pose;
      return true;
    }
    const std::optional<Pose> start = outside_start();
    if (!start) return false;
    begin_run({DescentKind::kPlunge, start->p, {}, 0, {}, false});
    here_ = *start;
    cut_from(*start);
    return true;
  }

  bool leftover_to_cut() const { return samples_.uncleared_count() > 0; }

  void enter_hole() {
    const double hole_radius = 0.5 * params_.hole_diameter, room = hole_radius - radius_;
    ground_.add_disc(*task_.hole, hole_radius);
    const Bounds everywhere = bounds_of({task_.centres});
    samples_.update(everywhere.low, everywhere.high);
    begin_run({DescentKind::kPlunge, *task_.hole, {}, 0, {}, false});
    const Pose start{*task_.hole + Vec2{room, 0}, kPi / 2};
    // From the centre to the rim by half a turn, which ends along the rim.
    std::vector<Segment> way;
    if (room > 1e-6)
      way.push_back(Segment::arc(*task_.hole + Vec2{room / 2, 0}, room / 2, kPi, kPi));
    if (is_free(ground_, exact_, way)) {
      add_moves(MoveKind::kLink, way);
      here_ = start;
      cut_from(start);
    }
  }

  // Helix, or ramp where none fits. Returns the pose from which the spiral starts.
  Pose choose_entry(const Circle& circle, Descent& descent) {
    const bool ramp_wanted = params_.entry == EntryKind::kRamp;
    if (kHelixRoom * circle.radius >= kNarrowestHelix * radius_ && !ramp_wanted) {
      descent.kind = DescentKind::kHelix;
      descent.centre = circle.centre;
      descent.radius = helix_radius(circle);
      descent.at = circle.centre + Vec2{descent.radius, 0};
      ground_.add_disc(circle.centre, descent.radius + radius_);
      return Pose{descent.at, kPi / 2};
    }
    // The ramp begins and ends where there is most room, so that the tool can turn there.
    if (params_.entry == EntryKind::kHelix)
      result_.notes.push_back("No helix fits: the tool comes down along a ramp instead.");
    descent.kind = DescentKind::kRamp;
    descent.at = circle.centre;
    double longest = -1;
    for (int i = 0; i < kRampDirections; ++i) {
      const Vec2 direction = unit(2 * kPi * i / kRampDirections);
      const double length =
          free_length(circle.centre, direction, kLongestRamp * params_.tool_diameter);
      if (length > longest + 1e-9) {
        longest = length;
        descent.ramp_end = circle.centre + length * direction;
      }
    }
    if (longest < 1e-3)
      throw GeometryError(GeometryErrorCode::kToolTooLarge, shown(circle.centre),
                          "The tool has no room to descend in this pocket: drill a hole first and "
                          "choose the entry 'Predrilled hole', or take a smaller tool.");
    ground_.add(Segment::line(descent.at, descent.ramp_end));
    const Vec2 along = normalized(descent.ramp_end - descent.at);
    return Pose{descent.at, angle_of(along)};
  }

  double free_length(Vec2 from, Vec2 direction, double limit) const {
    double length = 0;
    while (length < limit) {
      const double inside = exact_.signed_distance(from + length * direction);
      if (inside < 1e-5) break;
      length += inside;
    }
    return std::min(length, limit);
  }

  // From outside the stock, over an open edge, straight towards the material until the tool touches
  // it.
  std::optional<Pose> outside_start() const {
    const Segment* best = nullptr;
    std::vector<Segment> edges;
    for (const Region& region : task_.material)
      for (const Curve& curve : region.curves())
        for (const Segment& segment : curve.segments())
          if (segment.open) edges.push_back(segment);
    for (const Segment& edge : edges) {
      const Vec2 outwards = -left_normal(edge.tangent(0.5));
      const Vec2 p = edge.point(0.5) + 1.02 * radius_ * outwards;
      if (exact_.signed_distance(p) < 0 || !ground_.is_clear(p)) continue;
      if (!best || edge.length() > best->length() + 1e-9) best = &edge;
    }
    if (!best) return std::nullopt;
    const Vec2 outwards = -left_normal(best->tangent(0.5));
    return Pose{best->point(0.5) + 1.02 * radius_ * outwards, angle_of(-outwards) + kPi / 2};
  }

  // A pass from a free pose with the widest turn that can be made from there.
  bool cut_from(const Pose& start) {
    for (std::size_t k = widest_stage_at(start); k < stages_.size(); ++k) {
      if (stages_[k].turn_radius <= 0) break;
      Pass pass = steering_at(k).from_pose(start);
      if (!pass.empty()) return take(std::move(pass), stages_[k].turn_radius);
    }
    return false;
  }

  // Takes a pass into the result. False when it cuts next to nothing.
  bool take(Pass pass, double turn_radius) {
    if (pass.empty()) return false;
    if (turn_radius > 0 && turn_radius < tightest_) {
      tightest_ = turn_radius;
      tightest_at_ = pass.moves.back().b;
    }
    add_moves(MoveKind::kCut, pass.moves);
    look_again(pass.moves);
    ++result_.passes;
    return pass.cut_area > kLeastCut * radius_ * radius_;
  }

  // Goes to `to` over cleared ground, or up and down where that is quicker or the only way. False
  // when the tool cannot come down there.
  bool go_to(const Pose& to, double turn_radius) {
    if (result_.runs.empty()) return come_down_beside(to);
    const double gap = distance(here_.p, to.p);
    if (gap < 1e-9 && std::abs(wrap_signed(to.heading - here_.heading)) < 1e-6) return true;
    const double rise =
        params_.safe_height - 0.5 * (params_.levels.front() + params_.levels.back());
    const double retract_minutes = (2 * rise + gap) / params_.rapid_feed + kRetractPrice / 60;
    const std::vector<Segment> link =
        shortest_link(ground_, exact_, here_, to, turn_radius > 0 ? turn_radius : link_turn(),
                      retract_minutes * params_.link_feed);
    if (!link.empty()) {
      add_moves(MoveKind::kLink, link);
      ++result_.links;
      return true;
    }
    if (task_.rest) return come_down_beside(to);
    begin_run({DescentKind::kPlunge, to.p, {}, 0, {}, true});
    here_ = to;
    return true;
  }

  // Between what earlier cuts left.
  bool come_down_beside(const Pose& to) {
    const std::optional<Segment> way =
        way_from_beside(ground_, task_.material, exact_, to, link_turn());
    if (!way && !is_free_disc(ground_, task_.material, to.p)) return false;
    begin_run({DescentKind::kPlunge, way ? way->a : to.p, {}, 0, {}, true});
    if (way) add_moves(MoveKind::kLink, {*way});
    here_ = to;
    return true;
  }

  double link_turn() const { return stages_.size() > 1 ? stages_.front().turn_radius : radius_; }

  void clear_all() {
    const double all = static_cast<double>(std::max<std::size_t>(1, samples_.uncleared_count()));
    double done = 0;
    std::optional<Vec2> last_start;
    while (!progress_.cancelled()) {
      const std::vector<PassStart> starts = samples_.starts();
      if (starts.empty()) {
        if (!cut_off_walls()) return;
        continue;
      }
      const PassStart start = choose(starts, last_start);
      const Mark before = mark();
      const bool there = go_to(start.pose, stages_[start.stage].turn_radius);
      const std::size_t first = ground_.size();
      double turn_radius = 0;
      Pass pass = there ? pass_from(start, &turn_radius) : Pass();
      if (!take(std::move(pass), turn_radius)) {
        if (!samples_.is_clear(start.sample)) samples_.give_up(start.sample);
        if (ground_.size() == first) back_to(before);  // no pass: the way to it is not needed
        continue;
      }
      last_start = start.pose.p;
      // Samples that a failed start brings in must not turn progress back.
      done = std::max(done, 1 - static_cast<double>(samples_.uncleared_count()) / all);
      progress_.report(done);
    }
  }

  // The pass from `start` with the widest turn, no wider than its stage's, that can enter there.
  Pass pass_from(const PassStart& start, double* turn_radius) {
    for (std::size_t k = start.stage; k < stages_.size(); ++k) {
      WallPlace place = start.place;
      if (k != start.stage) {
        if (stages_[k].turn_radius <= 0) break;
        const BoundaryIndex::Hit hit = stages_[k].centres.nearest(start.pose.p);
        if (hit.distance > kSamePlace) break;
        place = {hit.curve, hit.segment, hit.t};
      }
      *turn_radius = stages_[k].turn_radius;
      Steering steering = steering_at(k);
      Pass pass = steering.from_wall(place);
      if (!pass.empty()) return pass;
    }
    return {};
  }

  // How far the result has come, to go back to when an attempt comes to nothing.
  struct Mark {
    Pose here;
    std::size_t runs, moves;
    int links, passes;
  };
  Mark mark() const {
    const std::size_t moves = result_.runs.empty() ? 0 : result_.runs.back().moves.size();
    return {here_, result_.runs.size(), moves, result_.links, result_.passes};
  }
  void back_to(const Mark& mark) {
    result_.runs.resize(mark.runs);
    if (!result_.runs.empty()) result_.runs.back().moves.resize(mark.moves);
    result_.links = mark.links;
    here_ = mark.here;
  }

  // Where no wall leads into the material. The first entry beside what earlier cuts left comes
  // before one into it.
  bool cut_off_walls() {
    const bool beside = task_.rest && result_.runs.empty() &&
                        has_free_place(ground_, task_.material, task_.centres);
    if (!beside) return enter_untouched() || cut_leftover();
    if (cut_leftover()) return true;
    if (!enter_untouched()) return false;
    leftover_ = Leftover();
    return true;
  }

  // Comes down anew in a room that no pass has reached, because the way there is too narrow to be
  // cut within the limit.
  bool enter_untouched() {
    if (params_.entry == EntryKind::kPredrilledHole) return false;
    for (const Stage& stage : stages_) {
      for (const Region& room : stage.rooms) {
        const Circle circle = largest_circle(room, kEntryTolerance);
        if (circle.radius < kNarrowestHelix * radius_ || !is_untouched(room, circle.centre))
          continue;
        Descent descent;
        const Pose start = choose_entry(circle, descent);
        begin_run(descent);
        samples_.update(descent.at, descent.at);
        cut_from(start);
        return true;
      }
    }
    return false;
  }

  bool is_untouched(const Region& room, Vec2 centre) const {
    if (ground_.is_cleared_point(centre)) return false;
    for (const Curve& curve : room.curves())
      for (const Segment& segment : curve.segments())
        if (ground_.is_clear(segment.a) || ground_.is_clear(segment.point(0.5))) return false;
    return true;
  }

  PassStart choose(const std::vector<PassStart>& starts, std::optional<Vec2> last_start) const {
    const PassStart* best = nullptr;
    double best_cost = std::numeric_limits<double>::infinity();
    for (const PassStart& start : starts) {
      double cost = distance(here_.p, start.pose.p);
      // The front that the last pass was cut from comes first: one branch is finished before the
      // next.
      if (last_start && distance(*last_start, start.pose.p) < radius_)
        cost = distance(*last_start, start.pose.p) - 2 * radius_;
      if (cost < best_cost) {
        best_cost = cost;
        best = &start;
      }
    }
    return *best;
  }

  // Material that no wall leads to: approached from the nearest place where the tool has been.
  bool cut_leftover() {
    if (!leftover_.prepared())
      leftover_.prepare(exact_, grown(bounds_of({task_.centres}), radius_), ground_);
    while (const std::optional<Pose> start = leftover_.next_start(ground_, exact_, here_.p)) {
      const std::size_t k = widest_stage_at(*start);
      if (k == stages_.size()) continue;
      const Mark before = mark();
      if (!go_to(*start, stages_[k].turn_radius)) continue;
      if (cut_from(*start)) return true;
      if (result_.passes == before.passes) back_to(before);
    }
    return false;
  }

  const RegionTask& task_;
  const ClearingParams& params_;
  Progress& progress_;
  double radius_;
  Area exact_;
  Circle widest_;  // among the places of the tool's centre
  ClearedGround ground_;
  std::vector<Stage> stages_;
  WallSamples samples_;
  Leftover leftover_;
  RegionResult result_;
  Pose here_;
  double tightest_ = std::numeric_limits<double>::infinity();  // mm, the tightest turn made
  Vec2 tightest_at_;
};

}  // namespace

RegionResult clear_region(const RegionTask& task, const ClearingParams& params,
                          Progress& progress) {
  return RegionClearing(task, params, progress).run();
}

}  // namespace evenload
