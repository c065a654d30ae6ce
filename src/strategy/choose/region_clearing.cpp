#include "strategy/choose/region_clearing.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/box_tree.h"
#include "strategy/choose/leftover.h"
#include "strategy/choose/pass_choice.h"
#include "strategy/choose/pass_taking.h"
#include "strategy/choose/region_work.h"
#include "strategy/choose/room_entries.h"
#include "strategy/reach/free_place.h"
#include "strategy/reach/links.h"
#include "support/errors.h"

namespace evenload {
namespace {

// Tool radii at link feed: what it costs to leave a front unfinished.
constexpr double kLeavingPrice = 1;

class RegionClearing {
 public:
  RegionClearing(Plan& plan, const RegionTask& task, const ClearingParams& params,
                 Progress& progress)
      : progress_(progress),
        work_(plan, task, params, progress),
        choice_(work_.ground, work_.stages, params, {work_.limits.widest, work_.limits.tightest}),
        passes_(work_),
        entries_(work_, choice_, passes_),
        plan_(plan),
        ground_(work_.ground),
        samples_(work_.samples) {}

  void run() {
    try {
      if (work_.goes_on)
        work_.look_everywhere();
      else
        entries_.enter();
      if (work_.task.rest || !plan_.is_empty()) clear_all();
      if (!progress_.cancelled()) {
        if (!work_.task.is_part) report_uncut();
        passes_.tell_tightest_turn();
      }
    } catch (const Cancelled&) {  // moves are taken into the plan as whole passes
    }
  }

 private:
  void report_uncut() {
    if (!leftover_.prepared()) prepare_leftover();
    const double left = leftover_.area(ground_);
    plan_.leave(left);
    if (left > 0)
      plan_.tell(
          {work_.params.wall_pass ? FindingCode::kLeftUncut : FindingCode::kLeftWithoutWallPass,
           shown_place(work_.task, *leftover_.place()),
           {left}});
  }

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
      if (pass.empty() || !passes_.take_new(pass, turn_radius, before)) {
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
    const bool beside = work_.task.rest && plan_.is_empty() &&
                        has_free_place(ground_, work_.task.material, work_.task.centres);
    if (!beside) return entries_.enter_untouched() || cut_leftover() || enter_touched();
    if (cut_leftover()) return true;
    if (!entries_.enter_untouched()) return false;
    leftover_ = Leftover();
    return true;
  }

  bool enter_touched() { return leftover_.area(ground_) > 0 && entries_.enter_touched(); }

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
      const bool same_front = last_start && distance(*last_start, start.pose.p) < work_.radius;
      const double extra = same_front ? 0 : kLeavingPrice * work_.radius;
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
      quicker_link({ground_, ground_.size()}, work_.around, plan_.here(), candidate.start->pose,
                   work_.link_turn(), work_.params, &cost);
      cost += candidate.extra;
      if (cost >= least) continue;
      least = cost;
      best = candidate.start;
    }
    return *best;
  }

  void prepare_leftover() {
    leftover_.prepare(work_.exact, grown(bounds_of({work_.task.centres}), work_.radius), ground_,
                      &progress_);
  }

  // Material that no wall leads to: approached from the nearest place where the tool has been.
  bool cut_leftover() {
    if (!leftover_.prepared()) prepare_leftover();
    while (const std::optional<Pose> start = next_leftover()) {
      if (!progress_.report(done_)) return true;
      const std::size_t before = ground_.size();
      double turn_radius = 0;
      Pass pass = choice_.from_pose(*start, &turn_radius);
      if (pass.empty() || !passes_.take_new(pass, turn_radius, before)) continue;
      cut_since_asked_ = true;
      return true;
    }
    return false;
  }

  // Places come once, and once more after one of them came to something.
  std::optional<Pose> next_leftover() {
    const std::optional<Pose> start = leftover_.next_start(ground_, work_.exact, plan_.here().p);
    if (start || !cut_since_asked_) return start;
    cut_since_asked_ = false;
    if (!leftover_.ask_again(ground_)) return std::nullopt;
    return leftover_.next_start(ground_, work_.exact, plan_.here().p);
  }

  Progress& progress_;
  RegionWork work_;
  PassChoice choice_;
  PassTaking passes_;
  RoomEntries entries_;
  // The work's.
  Plan& plan_;
  ClearedGround& ground_;
  WallSamples& samples_;
  Leftover leftover_;
  bool cut_since_asked_ = false;  // some of it
  double done_ = 0;               // share of the samples
};

}  // namespace

void clear_region(Plan& plan, const RegionTask& task, const ClearingParams& params,
                  Progress& progress) {
  try {
    RegionClearing(plan, task, params, progress).run();
  } catch (const Cancelled&) {  // before anything more was made
  }
}

RegionResult clear_region(const RegionTask& task, const ClearingParams& params,
                          Progress& progress) {
  Plan plan(task, params, progress);
  clear_region(plan, task, params, progress);
  return plan.take();
}

}  // namespace evenload
