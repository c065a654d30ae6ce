#include "strategy/choose/region_clearing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "feed/load_profile.h"
#include "geometry/box_tree.h"
#include "geometry/medial_axis.h"
#include "strategy/choose/leftover.h"
#include "strategy/choose/made_passes.h"
#include "strategy/choose/pass_choice.h"
#include "strategy/moves/move_checks.h"
#include "strategy/moves/move_ends.h"
#include "strategy/moves/tight_turns.h"
#include "strategy/places/narrow_passages.h"
#include "strategy/reach/border_bits.h"
#include "strategy/reach/entry.h"
#include "strategy/reach/free_place.h"
#include "strategy/reach/links.h"
#include "strategy/steer/steering.h"
#include "strategy/steer/wall_samples.h"
#include "support/errors.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

// No stage turns more tightly than posts can write, kTightestArc, but for this share of the widest
// room's radius: a region that is narrow everywhere is turned in more tightly. The exact border
// clears what is narrower, bit by bit.
constexpr double kTightestInRoom = 0.3;
// Share of the tool's radius: the tightest turn that the walls do not need.
constexpr double kSpareTurn = 0.03;
// mm: a corner is left to the exact border once it is so short that the mean engagement over 0.1 mm
// stays low in it.
constexpr double kShortCorner = 0.055;
// mm per rad of the engagement angle: at small angles less.
constexpr double kShortCornerPerAngle = 0.143;
// mm: of the place of an entry.
constexpr double kEntryTolerance = 1e-3;
// There is a stage that turns as tightly as this share of the entry's radius: a first pass that
// turns less tightly than the entry's circle would run into more material than the limit allows.
constexpr double kFirstTurn = 0.5;
// Rooms less wide than this share of the tool's radius get no entry of their own.
constexpr double kNarrowestRoom = 0.02;
// Tool radii at link feed: what it costs to leave a front unfinished.
constexpr double kLeavingPrice = 1;
// mm: turns end on the walls of narrow places.
constexpr double kOnNarrowWall = 1e-3;
// Share of the tool's radius: so much is kept of a pass's way without contact at both ends.
constexpr double kKeptIdle = 0.03;

// Side steps in the tool's radius: so many passes a place of a wall gets for each of them. Ten
// times what was seen in the finest gaps.
constexpr double kMostPasses = 150;

class RegionClearing {
 public:
  RegionClearing(Plan& plan, const RegionTask& task, const ClearingParams& params,
                 Progress& progress)
      : plan_(plan),
        ground_(plan.ground()),
        task_(task),
        params_(params),
        progress_(progress),
        radius_(0.5 * params.tool_diameter),
        goes_on_(!plan.is_empty()),
        exact_({task.centres}),
        around_(task.around.empty() ? std::vector<Region>{task.centres} : task.around),
        stages_(stages()),
        choice_(ground_, stages_, params, {limits().widest, limits().tightest}),
        samples_(stages_, ground_, most_passes()) {
    ground_.tell(progress);
  }

  void run() {
    try {
      if (goes_on_)
        look_everywhere();
      else
        enter();
      if (task_.rest || !plan_.is_empty()) clear_all();
      if (!progress_.cancelled()) {
        if (!task_.is_part) report_uncut();
        report_tight_turns();
      }
    } catch (const Cancelled&) {  // moves are taken into the plan as whole passes
    }
  }

 private:
  Vec2 shown(Vec2 p) const { return shown_place(task_, p); }

  void report_uncut() {
    if (!leftover_.prepared()) prepare_leftover();
    const double left = leftover_.area(ground_);
    plan_.leave(left);
    if (left > 0)
      plan_.tell({params_.wall_pass ? FindingCode::kLeftUncut : FindingCode::kLeftWithoutWallPass,
                  shown(*leftover_.place()),
                  {left}});
  }

  // Whether the walls are so close together that no wished turn fits. In corners none does, and
  // nobody needs to be told.
  bool is_narrow_at(Vec2 p) {
    if (!narrow_) {
      std::vector<Region> places;
      for (const Passage& passage : find_narrow_places(task_.centres, limits().widest).passages)
        places.push_back(passage.centres);
      narrow_.emplace(places);
    }
    return !narrow_->empty() && narrow_->signed_distance(p) > -kOnNarrowWall;
  }

  void report_tight_turns() {
    if (tightest_ < limits().widest * (1 - 1e-9)) plan_.note_turn(tightest_, shown(tightest_at_));
  }

  StageLimits limits() const {
    const double wish = std::max(params_.roll_radius, params_.minimum_radius);
    const double tightest = std::max(
        kTightestPosted,
        std::min({kTightestArc, kTightestArcShare * radius_, kTightestInRoom * widest().radius}));
    return {std::max(wish, tightest), tightest,
            std::min(kShortCorner, kShortCornerPerAngle * params_.engagement_angle),
            std::max(kSpareTurn * radius_, tightest),
            goes_on_ ? std::numeric_limits<double>::infinity() : kFirstTurn * entry_radius()};
  }

  // mm: of the circle that the tool's centre runs on before the first pass.
  double entry_radius() const {
    return task_.hole ? 0.5 * params_.hole_diameter - radius_ : helix_radius(params_, widest());
  }

  // The largest among the places of the tool's centre.
  const Circle& widest() const {
    if (!widest_) widest_ = largest_circle(task_.centres, kEntryTolerance);
    return *widest_;
  }

  // To one place of a wall: fine gaps need some hundreds at 15 degrees, and more the smaller the
  // side step is.
  int most_passes() const {
    const double side_steps = 1 / (1 - std::cos(std::min(params_.engagement_angle, kPi / 2)));
    return static_cast<int>(std::min(1e9, kMostPasses * std::max(1.0, side_steps)));
  }

  std::vector<Stage> stages() const {
    std::vector<Stage> all = make_stages(task_.centres, limits(), &progress_);
    if (!params_.wall_pass && all.size() > 1) all.pop_back();  // the exact border
    return all;
  }

  void look_everywhere() {
    const Bounds everywhere = bounds_of({task_.centres});
    samples_.update(everywhere.low, everywhere.high);
  }

  void look_again(const std::vector<Segment>& moves) {
    Vec2 low = plan_.here().p, high = low;
    for (const Segment& move : moves)
      for (int i = 0; i <= 4; ++i) {
        const Vec2 p = move.point(i / 4.0);
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    samples_.update(low, high);
  }

  void look_again(const Descent& descent) {
    Bounds box{descent.at, descent.at};
    if (descent.kind == DescentKind::kHelix) {
      const Vec2 opposite = 2 * descent.centre - descent.at;
      box = joined(box, {opposite, opposite});
    }
    for (const Vec2 p : descent.ramp_by) box = joined(box, {p, p});
    samples_.update(box.low, box.high);
  }

  // Comes down, and cuts the first pass, a spiral, as far as it goes.
  void enter() {
    if (task_.rest) {  // every pass comes down over cleared ground by itself
      look_everywhere();
      plan_.stand({widest().centre, 0});
      return;
    }
    const bool hole_first = task_.hole && params_.entry == EntryKind::kPredrilledHole;
    const bool outside = task_.has_open_edges && params_.entry == EntryKind::kAutomatic;
    if (outside && !hole_first) {
      look_everywhere();
      if (enter_from_outside()) return;
    }
    if (task_.hole) {
      const Plan::Mark above = plan_.mark();
      enter_hole();
      if (plan_.made().passes > 0 || !leftover_to_cut()) return;
      if (hole_first) throw GeometryError(Refusal::kHoleTooTight, shown(*task_.hole));
      plan_.roll_back(above);
      plan_.tell({FindingCode::kHoleTooTight});
    }
    if (params_.entry == EntryKind::kPredrilledHole) {
      look_everywhere();
      enter_from_before();
      return;
    }
    const std::optional<Pose> start = descend_in(widest());
    if (!start) throw GeometryError(Refusal::kNoRoomToDescend, shown(widest().centre));
    look_everywhere();
    cut_from(*start);
  }

  // Where a wall leads from ground that was cut before into the material.
  void enter_from_before() {
    const std::vector<PassStart> starts = samples_.starts();
    if (!starts.empty()) plan_.plunge(starts.front().pose, true);
  }

  // Over an open edge: where a wall leads into the material, or straight at it; of both what is
  // nearer to the place that is wished. False when the tool finds no room outside.
  bool enter_from_outside() {
    const std::vector<PassStart> starts = samples_.starts();
    const std::optional<Vec2>& wish = params_.open_side;
    const auto off = [&wish](const Pose& pose) { return wish ? distance(pose.p, *wish) : 0; };
    const auto first = std::min_element(
        starts.begin(), starts.end(),
        [&](const PassStart& a, const PassStart& b) { return off(a.pose) < off(b.pose); });
    std::optional<Pose> start;
    if (wish || starts.empty()) start = start_outside(exact_, task_.material, ground_, wish);
    if (first != starts.end() && (!start || off(first->pose) <= off(*start))) {
      plan_.plunge(first->pose, false);
      return true;
    }
    if (!start) return false;
    plan_.plunge(*start, false);
    cut_from(*start);
    return true;
  }

  bool leftover_to_cut() const { return samples_.uncleared_count() > 0; }

  void enter_hole() {
    const double room = 0.5 * params_.hole_diameter - radius_;
    look_everywhere();
    plan_.plunge({*task_.hole, 0}, false);
    const Pose start{*task_.hole + Vec2{room, 0}, kPi / 2};
    // From the centre to the rim by half a turn, which ends along the rim.
    std::vector<Segment> way;
    if (room > 1e-6)
      way.push_back(Segment::arc(*task_.hole + Vec2{room / 2, 0}, room / 2, kPi, kPi));
    if (is_free({ground_, ground_.size()}, exact_, way, length_of(way))) {
      plan_.add(MoveKind::kLink, way);
      plan_.stand(start);
      cut_from(start);
    }
  }

  // By a helix, or a ramp where none fits. Returns the pose from which the first pass, a spiral,
  // starts; nothing where there is not even room for a ramp.
  std::optional<Pose> descend_in(const Circle& room) {
    std::optional<Entry> entry = descend_within(exact_, room, params_);
    if (!entry) return std::nullopt;
    if (params_.entry == EntryKind::kHelix && entry->descent.kind == DescentKind::kRamp)
      plan_.tell({FindingCode::kRampForHelix});
    if (params_.entry == EntryKind::kRamp && choice_.leads_nowhere(*entry))
      if (std::optional<Entry> helix = helix_within(exact_, room, params_)) {
        entry = std::move(helix);
        plan_.tell({FindingCode::kHelixForRamp});
      }
    // Who asks for a helix shall have the one that was asked for, where it fits.
    const bool may_stretch = task_.stretch_helix || params_.entry != EntryKind::kHelix ||
                             is_shrunk(entry->descent, params_);
    if (may_stretch && !task_.round_helix) stretch_helix(*entry, exact_, params_);
    fill_narrow_room(*entry, room, params_);
    if (ground_.size() > 0 || task_.rest || task_.has_open_edges)
      entry->descent.new_area = area_cut_by(entry->descent, ground_);
    plan_.come_down(entry->descent);
    return entry->start;
  }

  // A pass from the free pose where the tool came down.
  bool cut_from(const Pose& start) {
    double turn_radius = 0;
    Pass pass = choice_.from_entry(start, &turn_radius);
    if (pass.empty()) return false;
    pass.moves = smooth(pass);
    return take(std::move(pass), turn_radius);
  }

  // Joins the moves of the newest pass, here and in the ground. Returns the way to be posted, with
  // wider turns; what these leave is too little to come back for.
  std::vector<Segment> smooth(Pass& pass) {
    take_back(ground_, pass);
    pass.moves = joined(pass.moves);
    const double most = most_widening(params_.engagement_angle, radius_, params_.tolerance);
    std::vector<Segment> way =
        without_tight_turns(pass.moves, {exact_, around_}, ground_, params_.engagement_angle, most);
    // What the wider turns left is met by the next turn of a pass that comes back to them.
    if (first_left_behind(way) > 0) pass.idle_after = idle_end_of(way, pass.idle_after, ground_);
    for (const Segment& move : pass.moves) ground_.add(move);
    return way;
  }

  // Goes to where the pass meets material, and takes it into the result. `before`: the size of the
  // ground before the pass. False when it cuts next to nothing.
  bool go_and_take(Pass pass, double turn_radius, std::size_t before) {
    std::vector<Segment> way = smooth(pass);
    const double from_contact = length_of(pass.moves) - pass.idle_before;
    // Nearest to the material, or where nothing is near.
    std::vector<Segment> shorter = way;
    drop_first(shorter, pass.idle_before - kKeptIdle * radius_);
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

  // The same, but false, and nothing is made, where just this pass has been made before.
  bool go_and_take_new(const Pass& pass, double turn_radius, std::size_t before) {
    if (made_.contains(pass)) {
      take_back(ground_, pass);
      return false;
    }
    if (!go_and_take(pass, turn_radius, before)) return false;
    made_.add(pass);
    return true;
  }

  static Pose start_of(const std::vector<Segment>& way) {
    return {way.front().a, angle_of(way.front().tangent(0))};
  }

  // Where the tightest turn of a pass ends.
  static Vec2 sharpest_place(const std::vector<Segment>& moves) {
    const auto sharpest =
        std::max_element(moves.begin(), moves.end(), [](const Segment& a, const Segment& b) {
          return std::abs(a.curvature()) < std::abs(b.curvature());
        });
    return sharpest->b;
  }

  // Takes a pass that begins where the tool stands into the result. False when it cuts next to
  // nothing.
  bool take(Pass pass, double turn_radius) {
    ground_.settle(settled_);
    settled_ = ground_.size();
    look_again(pass.moves);
    // What lies at the ends of the way is cleared, but for less than counts as contact.
    drop_last(pass.moves, pass.idle_after - kKeptIdle * radius_);
    plan_.post(MoveKind::kCut, pass.moves);
    if (task_.follow && !task_.is_part && !goes_on_) task_.follow(plan_.runs());
    if (turn_radius > 0 && turn_radius < std::min(tightest_, limits().widest * (1 - 1e-9)))
      if (const Vec2 at = sharpest_place(pass.moves); is_narrow_at(at)) {
        tightest_ = turn_radius;
        tightest_at_ = at;
      }
    plan_.count_pass();
    return is_progress(pass, radius_);
  }

  bool link_to(const Pose& to, std::size_t before) {
    return plan_.link_to(to, around_, link_turn(), before);
  }

  // Back along the cuts since the last link: the only links that turn about at their ends. False
  // where these did not run through `to`, or where to go up and down is quicker.
  bool back_to(const Pose& to) {
    if (plan_.is_empty()) return false;
    const double longest = length_of_retract(distance(plan_.here().p, to.p), params_);
    const WayBack back = way_back(plan_.runs().back().moves, to, longest);
    if (!back.found) return false;
    const auto free = [&](const std::vector<Segment>& way) {
      return is_free({ground_, ground_.size()}, exact_, way, length_of(way));
    };
    plan_.add(MoveKind::kLink, beside_cuts(back.moves, params_.arcs, free));
    plan_.stand(to);
    if (!back.moves.empty()) plan_.count_link();
    return true;
  }

  // Up, and down where the ground is clear. Between what earlier operations left the tool comes
  // down off the wall, where there is such a place, so that no edge brushes it. False when it
  // cannot come down there.
  bool come_down_at(const Pose& to) {
    const bool is_free = is_free_disc(ground_, task_.material, to.p);
    std::optional<Segment> way;
    if (task_.rest || !is_free)
      way = way_from_beside(ground_, task_.material, exact_, to, link_turn());
    if (!way && !is_free) return false;
    plan_.plunge({way ? way->a : to.p, to.heading}, true);
    if (way) plan_.add(MoveKind::kLink, {*way});
    plan_.stand(to);
    return true;
  }

  double link_turn() const { return stages_.size() > 1 ? stages_.front().turn_radius : radius_; }

  void clear_all() {
    const double all = static_cast<double>(std::max<std::size_t>(1, samples_.uncleared_count()));
    std::optional<Vec2> last_start;
    while (!progress_.cancelled()) {
      const std::vector<PassStart> starts = samples_.starts();
      if (starts.empty()) {
        if (!cut_off_walls()) return;
        progress_.report(done_);
        continue;
      }
      const PassStart start = choose(starts, last_start);
      const std::size_t before = ground_.size();
      double turn_radius = 0;
      Pass pass = choice_.from_wall(start, &turn_radius);
      if (pass.empty() || !go_and_take_new(pass, turn_radius, before)) {
        // A pass that came to next to nothing may be cut all the same.
        if (ground_.size() > before) samples_.note_pass(start.sample);
        if (!samples_.is_clear(start.sample)) samples_.give_up(start.sample);
        progress_.report(done_);
        continue;
      }
      samples_.note_pass(start.sample);
      last_start = start.pose.p;
      // Samples that a failed start brings in must not turn progress back.
      done_ = std::max(done_, 1 - static_cast<double>(samples_.uncleared_count()) / all);
      progress_.report(done_);
    }
  }

  // Where no wall leads into the material. The first entry beside what earlier cuts left comes
  // before one into it.
  bool cut_off_walls() {
    const bool beside =
        task_.rest && plan_.is_empty() && has_free_place(ground_, task_.material, task_.centres);
    if (!beside) return enter_untouched() || cut_leftover() || enter_touched();
    if (cut_leftover()) return true;
    if (!enter_untouched()) return false;
    leftover_ = Leftover();
    return true;
  }

  // Comes down anew in a room that no pass has reached, because the way there is too narrow to be
  // cut within the limit. A room that needs no entry never needs one later.
  bool enter_untouched() { return enter_next(untouched_, false); }

  // The same where passes got no further than the room's mouth, and nothing else will do.
  bool enter_touched() { return leftover_.area(ground_) > 0 && enter_next(touched_, true); }

  // Rooms are looked at once, stage by stage.
  struct NextRoom {
    std::size_t stage = 0, room = 0;
  };
  bool enter_next(NextRoom& next, bool touched_too) {
    if (params_.entry == EntryKind::kPredrilledHole) return false;
    for (; next.stage < stages_.size(); ++next.stage, next.room = 0)
      for (; next.room < stages_[next.stage].rooms.size(); ++next.room)
        if (enter_room(stages_[next.stage].rooms[next.room], touched_too)) return true;
    return false;
  }

  // False when the room needs no entry, or is too narrow for one.
  bool enter_room(const Region& room, bool touched_too) {
    if (!touched_too && has_cleared_wall(room)) return false;
    const Circle circle = largest_circle(room, kEntryTolerance);
    const bool reached =
        touched_too ? ground_.is_clear(circle.centre) : ground_.is_cleared_point(circle.centre);
    // Where nothing is cut yet there is no other way to begin, however narrow the room is.
    const bool is_narrow = !plan_.is_empty() && circle.radius < kNarrowestRoom * radius_;
    if (is_narrow || reached) return false;
    const std::optional<Pose> start = descend_in(circle);
    if (!start) return false;
    look_again(plan_.runs().back().descent);
    cut_from(*start);
    return true;
  }

  bool has_cleared_wall(const Region& room) const {
    for (const Curve& curve : room.curves())
      for (const Segment& segment : curve.segments())
        if (ground_.is_clear(segment.a) || ground_.is_clear(segment.point(0.5))) return true;
    return false;
  }

  // The start that is reached soonest. The front that the last pass was cut from has an advantage:
  // to leave it means to come back.
  PassStart choose(const std::vector<PassStart>& starts, std::optional<Vec2> last_start) const {
    struct Candidate {
      const PassStart* start;
      double extra;  // mm at link feed: the price besides the way to it
      double least;  // mm at link feed: with the shortest way that may be
    };
    std::vector<Candidate> candidates;
    for (const PassStart& start : starts) {
      const bool same_front = last_start && distance(*last_start, start.pose.p) < radius_;
      const double extra = same_front ? 0 : kLeavingPrice * radius_;
      candidates.push_back({&start, extra, distance(plan_.here().p, start.pose.p) + extra});
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.least < b.least; });
    const PassStart* best = candidates.front().start;
    if (plan_.is_empty()) return *best;
    double least = std::numeric_limits<double>::infinity();
    for (const Candidate& candidate : candidates) {
      if (candidate.least >= least) break;
      double cost = 0;
      quicker_link({ground_, ground_.size()}, around_, plan_.here(), candidate.start->pose,
                   link_turn(), params_, &cost);
      cost += candidate.extra;
      if (cost >= least) continue;
      least = cost;
      best = candidate.start;
    }
    return *best;
  }

  void prepare_leftover() {
    leftover_.prepare(exact_, grown(bounds_of({task_.centres}), radius_), ground_, &progress_);
  }

  // Material that no wall leads to: approached from the nearest place where the tool has been.
  bool cut_leftover() {
    if (!leftover_.prepared()) prepare_leftover();
    while (const std::optional<Pose> start = next_leftover()) {
      if (!progress_.report(done_)) return true;
      const std::size_t before = ground_.size();
      double turn_radius = 0;
      Pass pass = choice_.from_pose(*start, &turn_radius);
      if (pass.empty() || !go_and_take_new(pass, turn_radius, before)) continue;
      cut_since_asked_ = true;
      return true;
    }
    return false;
  }

  // Places come once, and once more after one of them came to something.
  std::optional<Pose> next_leftover() {
    const std::optional<Pose> start = leftover_.next_start(ground_, exact_, plan_.here().p);
    if (start || !cut_since_asked_) return start;
    cut_since_asked_ = false;
    if (!leftover_.ask_again(ground_)) return std::nullopt;
    return leftover_.next_start(ground_, exact_, plan_.here().p);
  }

  Plan& plan_;
  ClearedGround& ground_;  // the plan's
  const RegionTask& task_;
  const ClearingParams& params_;
  Progress& progress_;
  double radius_;
  bool goes_on_;  // from what was made before
  Area exact_, around_;
  mutable std::optional<Circle> widest_;
  std::size_t settled_ = 0;  // moves of the ground that stay
  std::vector<Stage> stages_;
  PassChoice choice_;
  WallSamples samples_;
  Leftover leftover_;
  bool cut_since_asked_ = false;  // some of it
  MadePasses made_;
  double done_ = 0;               // share of the samples
  NextRoom untouched_, touched_;  // the first rooms that may need an entry
  std::optional<Area> narrow_;    // where no wished turn fits
  double tightest_ = std::numeric_limits<double>::infinity();  // mm, the tightest turn made there
  Vec2 tightest_at_;
};

}  // namespace

void clear_region(Plan& plan, const RegionTask& task, const ClearingParams& params,
                  Progress& progress) {
  try {
    RegionClearing(plan, task, params, progress).run();
  } catch (const Cancelled&) {  // before anything was made
  }
}

RegionResult clear_region(const RegionTask& task, const ClearingParams& params,
                          Progress& progress) {
  Plan plan(task, params, progress);
  clear_region(plan, task, params, progress);
  return plan.take();
}

}  // namespace evenload
