// Steering: one pass of the tool at constant engagement [Jacsó 2021, Theses II and III].
//
// The material lies to the right of the feed (climb milling with a clockwise spindle; conventional
// milling is its mirror image). Thesis II makes the direction of feed a function of place: the
// vector from the tool's centre P to the point C where the tool's circle leaves the material,
// turned counter-clockwise by pi/2 - theta. A step here is an arc, tangent to the last one, whose
// curvature is solved for so that the engagement at its end is theta again. The chord of an arc
// points along the mean of its end directions, so this is an implicit rule of second order on
// Thesis II's field, of the trapezoid's kind, in place of Thesis III's explicit one; the steps are
// the output, and no fitting follows.
//
// Two things bend the path: it never turns left more tightly than the stage's turn radius, and it
// never touches a wall. Both are one condition on the centre Q of the left turn that the tool could
// make at once. Q stays where a full turn fits; when Q meets the border of that place the tool
// turns about Q until it runs along the wall (roll-out) and follows the wall; where following it
// would exceed theta the tool leaves the wall by a left turn begun just early enough (roll-in).
//
// Free steps are in steering_free.cpp, the following of walls in steering_wall.cpp.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cutting/cleared_ground.h"
#include "cutting/probe.h"
#include "strategy/moves/pass.h"
#include "strategy/steer/stage.h"

namespace evenload {

// How long the steps are.
enum class Steps {
  kFew,    // as long as the time that is lost where less than the limit is met allows
  kExact,  // so short that hardly less is met: for passes that are repeated
};

class Steering {
 public:
  // `engagement` rad: the limit and target. `right_radius` mm: of the tightest right turn, towards
  // the material. Both references must outlive this object.
  Steering(ClearedGround& ground, const Stage& stage, double engagement, double right_radius,
           Steps steps = Steps::kFew);
  // Right turns as tight as left ones.
  Steering(ClearedGround& ground, const Stage& stage, double engagement)
      : Steering(ground, stage, engagement, stage.turn_radius) {}

  // A pass that starts at a place of the wall, where the tool is clear of material, and follows the
  // wall into the material. Moves are added to the ground as they are made. Empty when no material
  // is met, or when none can be entered within the limit.
  Pass from_wall(const WallPlace& start);
  // The same from a free pose that just touches material on its right.
  Pass from_pose(const Pose& start);
  // From the wall, but never leaves it: empty where that would exceed the limit, or meet more
  // material on the left than on the right for longer than a touch.
  Pass along_wall(const WallPlace& start);
  // Along the exact border, where nothing else will do: as far as the limit allows, and no further.
  Pass bit_by_bit(const WallPlace& start);

 private:
  enum class Mode { kWall, kFree, kEnd };
  enum class TurnPart { kFirstPeak, kWayOut };
  struct Contact {
    double total = 0;  // rad engaged in the leading half circle
    double steer =
        0;  // rad from the right to the far end of the main engaged arc, or total if that is more
    Vec2 edge;                // that far end, on the border of what is cleared
    bool leans_left = false;  // more of it lies left of the feed than right of it
    bool on_right = false;    // the main engaged arc begins at the right of the feed
  };
  struct WallLook {
    double t = 0;  // share of the wall's piece
    Contact contact;
  };

  // A free step from where the tool stands.
  struct Step {
    Segment move;
    Contact end;
    double curvature = 0;    // 1/mm
    double excess = 0;       // rad engaged at its end beyond what was aimed at
    double above = 0;        // rad engaged at its end beyond the limit
    bool held_back = false;  // a shorter step could turn enough
  };
  // At a place of a step.
  struct Look {
    double t = 0;  // share of the step
    Contact contact;
  };
  struct Error {
    double share = 0;    // of what is allowed
    bool rises = false;  // the engagement, on the way
  };

  Contact contact(const Pose& pose) const;
  double target_of(double length) const;
  Step solve(double length) const;
  static bool is_steady(const Step& step);
  static double growth_after(const Error& error);
  double slack_of(double length) const;
  Error error_of(const Step& step, const Contact& first, double enough) const;
  std::optional<Step> try_step(const Contact& first, Error* error);
  Step longer_than(const Step& step, const Contact& first, Error* error) const;
  Pose pose() const;
  void append(const Segment& move);
  void cut_back(double length);
  bool is_smooth_between(const Contact& a, const Contact& b, bool apart = false) const;
  bool changes_between(const Contact& a, const Contact& b) const;
  bool may_peak_between(const Contact& a, const Contact& b) const;
  double peak_of_left_turn(const Pose& from, TurnPart part, double* angle) const;
  void go_to_wall(const WallPlace& place);
  void step_on_wall();
  void step_free();
  bool roll_in(TurnPart part);
  void escape();
  void give_up();
  void roll_out();
  void overload();
  std::optional<double> peak_before(const Segment& wall, const WallLook& last) const;
  std::optional<double> cusp_between(const Segment& wall, const WallLook& first,
                                     const WallLook& second) const;
  bool near_corner(double step) const;
  bool over_mean(double total, double step) const;
  double clear_ahead(WallPlace place) const;
  WallPlace run_up(const WallPlace& start) const;
  double reach_of(const Segment& move) const;
  double met_before(double length) const;
  bool was_met_for(double length) const;
  void note_contact(double total, double length);
  double contact_until(const Segment& move) const;
  void make_step(const Segment& move, double total);
  bool has_cut() const { return !met_.empty(); }
  double idle() const { return has_cut() ? travelled_ - met_.back().until : travelled_; }
  void reset(const Pose& start);
  Pass run();

  ClearedGround& ground_;
  const Stage& stage_;
  double theta_;
  double radius_;
  double turn_;
  double right_radius_;
  Steps steps_;
  Pass pass_;
  Pose start_;
  Mode mode_ = Mode::kEnd;
  bool may_leave_wall_ = true;
  bool bit_by_bit_ = false;
  WallPlace wall_;
  double rough_until_ = 0;           // mm along the wall's piece: short of a cusp of the front
  double on_left_ = 0;               // mm, the last on the wall, with more material on the left
  std::optional<Contact> met_here_;  // on the wall
  double travelled_ = 0;             // mm
  // What was met on the way, so that it can be forgotten when the path is cut back.
  struct Met {
    double until = 0;   // mm travelled
    double length = 0;  // mm
    double from = 0;    // rad engaged at the beginning
    double total = 0;   // rad engaged at the end
  };
  std::vector<Met> met_;
  double step_ = 0;            // mm, adaptive
  double curvature_ = 0;       // of the last free step
  std::size_t free_from_ = 0;  // moves of the pass before the free steps
  bool rises_ = false;         // the engagement, on its way
  double trouble_at_ = -1;     // mm travelled where the furthest overload was met
  int troubles_ = 0;
  mutable Probe probe_{ground_};
};

}  // namespace evenload
