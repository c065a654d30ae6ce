#include "python/clearing_params.h"

#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <optional>
#include <tuple>

namespace py = pybind11;

namespace evenload {

const char* const kClearingArguments =
    "Keyword arguments; mm, rad, mm/min, rev/min. Required: tool_diameter, engagement_angle, feed, "
    "plunge_feed, link_feed, maximum_feed, levels, safe_height, clearance_height. Others: cut_mode "
    "('climb', 'conventional'), feed_control ('constant feed', 'constant removal rate', 'constant "
    "chip thickness', 'constant force'), least_load, most_blocks_per_metre, rapid_feed, "
    "roll_radius, minimum_radius, entry ('automatic', 'helix', 'ramp', 'predrilled hole'), "
    "helix_angle, helix_diameter, entry_point "
    "(x, y), open_side (x, y), hole_diameter, stock_to_leave, wall_pass, tolerance, arcs, "
    "link_lift, top, order_by "
    "('region', 'depth'), narrow_passages ('trochoid with smaller radius', 'cut at reduced feed', "
    "'skip and report'), force_coefficients, teeth, tool_helix_angle, spindle_speed, progress: "
    "called with the share that is done, False cancels.";

namespace {

void place(Keywords& keywords, const char* name, std::optional<Vec2>& value) {
  std::optional<std::tuple<double, double>> given;
  keywords.optional(name, given);
  if (given) value = Vec2{std::get<0>(*given), std::get<1>(*given)};
}

}  // namespace

void Keywords::refuse_others() const {
  if (left_.empty()) return;
  const py::handle name = left_.begin()->first;
  throw py::type_error(function_ + "() knows no argument '" + py::str(name).cast<std::string>() +
                       "'.");
}

std::string Keywords::unknown_choice(const std::string& name, const std::string& word,
                                     const std::vector<std::string>& known) {
  std::string list;
  for (const std::string& one : known) list += (list.empty() ? "" : ", ") + ("'" + one + "'");
  return name + " must be one of " + list + ", not '" + word + "'.";
}

ClearingCall clearing_call(Keywords& keywords) {
  ClearingCall call;
  ClearingParams& p = call.params;
  keywords.required("tool_diameter", p.tool_diameter);
  keywords.required("engagement_angle", p.engagement_angle);
  keywords.choice("cut_mode",
                  {{"climb", CutMode::kClimb}, {"conventional", CutMode::kConventional}},
                  p.cut_mode);
  keywords.choice("feed_control",
                  {{"constant feed", FeedControl::kConstantFeed},
                   {"constant removal rate", FeedControl::kConstantRemovalRate},
                   {"constant chip thickness", FeedControl::kConstantChipThickness},
                   {"constant force", FeedControl::kConstantForce}},
                  p.feed_control);
  keywords.required("feed", p.feed);
  keywords.required("plunge_feed", p.plunge_feed);
  keywords.required("link_feed", p.link_feed);
  keywords.required("maximum_feed", p.maximum_feed);
  keywords.optional("least_load", p.least_load);
  keywords.optional("most_blocks_per_metre", p.most_blocks_per_metre);
  keywords.optional("rapid_feed", p.rapid_feed);
  keywords.optional("roll_radius", p.roll_radius);
  keywords.optional("minimum_radius", p.minimum_radius);
  keywords.choice("entry",
                  {{"automatic", EntryKind::kAutomatic},
                   {"helix", EntryKind::kHelix},
                   {"ramp", EntryKind::kRamp},
                   {"predrilled hole", EntryKind::kPredrilledHole}},
                  p.entry);
  keywords.optional("helix_angle", p.helix_angle);
  keywords.optional("helix_diameter", p.helix_diameter);
  place(keywords, "entry_point", p.entry_point);
  place(keywords, "open_side", p.open_side);
  keywords.optional("hole_diameter", p.hole_diameter);
  keywords.optional("stock_to_leave", p.stock_to_leave);
  keywords.optional("wall_pass", p.wall_pass);
  keywords.optional("tolerance", p.tolerance);
  keywords.optional("arcs", p.arcs);
  keywords.optional("link_lift", p.link_lift);
  keywords.optional("top", p.top);
  keywords.required("levels", p.levels);
  keywords.required("safe_height", p.safe_height);
  keywords.required("clearance_height", p.clearance_height);
  keywords.choice("order_by", {{"region", OrderBy::kRegion}, {"depth", OrderBy::kDepth}},
                  p.order_by);
  keywords.choice("narrow_passages",
                  {{"trochoid with smaller radius", NarrowPassages::kTrochoid},
                   {"cut at reduced feed", NarrowPassages::kReducedFeed},
                   {"skip and report", NarrowPassages::kSkip}},
                  p.narrow_passages);
  keywords.optional("force_coefficients", p.force_coefficients);
  keywords.optional("teeth", p.teeth);
  keywords.optional("tool_helix_angle", p.tool_helix_angle);
  keywords.optional("spindle_speed", p.spindle_speed);
  keywords.optional("progress", call.progress);
  return call;
}

Progress progress_of(const std::function<bool(double)>& function) {
  if (!function) return Progress();
  return Progress([&function](double share) {
    const py::gil_scoped_acquire lock;
    return function(share);
  });
}

}  // namespace evenload
