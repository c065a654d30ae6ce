#include "simulate/load_walk.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace evenload {
namespace {

// mm: a layer this thin on the tool's side is what rounding and tolerances leave, no contact.
constexpr double kGraze = 0.005;
// Times kGraze: no rounding leaves so much.
constexpr double kThickerThanGraze = 10;
// mm: G-code has three decimals; a gouge of less is no incident.
constexpr double kRounding = 0.001;
// mm off the tool's circle where stock is asked for: above rounding, far below what counts.
constexpr double kSkin = 1e-6;
// rad: from one sample to the next, where steps can be made shorter; and the share of the step down
// to which they are.
constexpr double kLargestChange = 5 * kPi / 180;
constexpr double kFinest = 0.13;
// Of the tool's radius: longer steps would pass by what the tool meets.
constexpr double kLongestStep = 0.5;
// Steps of one piece of a move: 200 m at the usual step; no real move is so long.
constexpr double kMostSteps = 2e6;
// Samples between two reports of progress, at the least.
constexpr std::size_t kReportEvery = 1024;
// Fall per length: flatter moves down are cuts, not entries.
constexpr double kEntrySlope = 0.0087;  // half a degree
// Level per length: steeper moves down are plunges.
constexpr double kPlungeShare = 0.15;
// Shares of a move this near are one.
constexpr double kSameShare = 1e-9;
// rad: moves that turn by less go on in one direction.
constexpr double kSameDirection = 1e-9;
// mm: a move this near to an entry's way repeats it; G-code's rounding is far less.
constexpr double kRetraced = 0.01;
// mm: level and vertical are so but for rounding.
constexpr double kLevel = 1e-9;

double engagement_of(const std::vector<EngagedArc>& arcs) {
  double sum = 0;
  for (const EngagedArc& arc : arcs) sum += arc.high - arc.low;
  return sum;
}

}  // namespace

LoadWalk::LoadWalk(DexelStock& stock, const SimulationParams& params, Simulation& result,
                   Progress& progress)
    : stock_(stock),
      params_(params),
      result_(result),
      progress_(progress),
      radius_(0.5 * params.tool_diameter),
      step_(std::min(params.step, kLongestStep * radius_)),
      next_report_(kReportEvery),
      part_(params.part, radius_, stock.top()),
      fixtures_(params.fixtures, radius_, stock.top()) {
  if (params.force && params.spindle_speed > 0)
    force_.emplace(params.force->coefficients, radius_, params.teeth, params.force->helix_angle);
}

bool LoadWalk::add(const Move& from, const Move& to, std::size_t number, double from_share,
                   double to_share) {
  now_ = {};
  now_.move = to;
  now_.number = number;
  now_.first_sample = result_.record.size();
  now_.feed = to.kind == MoveKind::kRapid && !(to.feed > 0) ? params_.rapid_feed : to.feed;
  const std::vector<MovePiece> pieces = pieces_of(from, to);
  double level = 0;
  for (const MovePiece& piece : pieces) level += piece.path.length();
  const double length = std::hypot(level, to.z - from.z);
  if (!(length > 0)) return true;
  now_.vertical = level <= kLevel;
  now_.level_share = now_.vertical ? 0 : level / length;
  now_.plunges = to.z < from.z && now_.level_share < kPlungeShare;
  bool goes_on = true;
  for (std::size_t k = 0; goes_on && k < pieces.size(); ++k)
    goes_on = walk(pieces[k], from_share + (to_share - from_share) * static_cast<double>(k) /
                                               static_cast<double>(pieces.size()));
  finish_move(from, pieces);
  return goes_on;
}

int LoadWalk::steps_of(const MovePiece& piece) const {
  const double rise = std::abs(piece.z1 - piece.z0);
  const double length = std::hypot(piece.path.length(), rise);
  if (std::min(piece.z0, piece.z1) >= stock_.top() ||
      !overlap(grown(piece.path.bounds(), radius_), stock_.bounds()))
    return 1;
  // A slope is cut as steps of a height that the dexels' resolution hides.
  const double steps =
      std::ceil(std::max(length / step_, now_.vertical ? 0 : rise / stock_.resolution()) - 1e-9);
  if (steps > kMostSteps)
    throw std::invalid_argument("Move " + std::to_string(now_.number) + " is " +
                                std::to_string(length) +
                                " mm long, too long to be simulated: mend its end.");
  return std::max(1, static_cast<int>(steps));
}

// False when cancelled.
bool LoadWalk::walk(const MovePiece& piece, double share) {
  const int steps = steps_of(piece);
  check_gouge(piece);
  const Segment& path = piece.path;
  const double length = std::hypot(path.length(), piece.z1 - piece.z0);
  const auto direction = [&](double t) {
    return now_.vertical ? last_feed_angle_ : angle_of(path.tangent(t));
  };
  // The pieces of one arc go on smoothly.
  if (result_.record.size() == now_.first_sample) {
    touch_at_start(path.a, piece.z0, direction(0));
    sample(path.a, piece.z0, direction(0), 0);
  }
  double at = 0;
  while (at < 1) {
    // Where the load changes fast, the steps get shorter: contact may last for hundredths of a mm.
    double to = at + 1.0 / steps < 1 - kSameShare ? at + 1.0 / steps : 1;
    double z = piece.z0 + to * (piece.z1 - piece.z0);
    Segment step;
    while (true) {
      step = (at == 0 && to == 1) || now_.vertical ? path : path.part(at, to);
      touch_at_end(step, z, direction(to));
      const double change = engagement_of(arcs_) - result_.record.engagement.back();
      if (std::abs(change) <= kLargestChange || (to - at) * length <= kFinest * step_) break;
      to = 0.5 * (at + to);
      z = piece.z0 + to * (piece.z1 - piece.z0);
    }
    const double z_before = piece.z0 + at * (piece.z1 - piece.z0), stretch = (to - at) * length;
    time_ += 60 * stretch / now_.feed;
    sample(step.b, z, direction(to), stretch);
    const Removal removal = cut(step, z_before, z);
    removed_ += removal.volume;
    result_.record.removed_volume.back() = removed_;
    result_.figures.removed_area += removal.area;
    check_contact(step.b, z_before, z, stretch, removal);
    at = to;
    if (result_.record.size() >= next_report_) {
      next_report_ = result_.record.size() + kReportEvery;
      if (!progress_.report(share)) return false;
    }
  }
  return true;
}

Removal LoadWalk::cut(const Segment& path, double z0, double z1) {
  Removal total;
  if (!now_.vertical) total += stock_.cut(path, radius_, std::max(z0, z1));
  if (z1 < z0) total += stock_.cut(Segment::line(path.b, path.b), radius_, z1);
  return total;
}

void LoadWalk::check_gouge(const MovePiece& piece) {
  const auto check = [&](const PartGauge& gauge, Worst& worst, IncidentKind kind) {
    if (gauge.empty()) return false;
    const Gouge found = gauge.deepest(piece.path, piece.z0, piece.z1, step_);
    if (!(found.depth > 0)) return false;
    const Vec2 p = now_.vertical ? piece.path.a : piece.path.point(found.t);
    const Place at{p.x, p.y, piece.z0 + found.t * (piece.z1 - piece.z0)};
    if (found.depth > worst.value) worst = {found.depth, at};
    if (found.depth > kRounding) {
      std::vector<Incident>& incidents = result_.figures.incidents;
      if (incidents.empty() || incidents.back().move != now_.number ||
          incidents.back().kind != kind)
        incidents.push_back({kind, at, now_.number, found.depth});
      else if (found.depth > incidents.back().amount)
        incidents.back() = {kind, at, now_.number, found.depth};
    }
    return true;
  };
  now_.gouging = check(part_, result_.figures.gouge, IncidentKind::kGouge);
  check(fixtures_, result_.figures.fixture, IncidentKind::kFixture);
}

// Rapids and plunges must not meet material.
void LoadWalk::check_contact(Vec2 p, double z0, double z1, double length, const Removal& removal) {
  if (now_.move.kind != MoveKind::kRapid && !now_.plunges) return;
  const double grazed = now_.plunges || now_.vertical
                            ? 2 * kPi * radius_ * kGraze * std::abs(z1 - z0)
                            : kGraze * length * std::max(0.0, stock_.top() - std::min(z0, z1));
  if (!(removal.volume > grazed)) return;
  if (now_.in_material == 0) now_.met = {p.x, p.y, z1};
  now_.in_material += length;
}

// Whether the move so far met more than rounding leaves: a thin layer as long as the tool is wide,
// or a thicker one all along a short move.
bool LoadWalk::cuts() const {
  return now_.plunged || now_.area > kGraze * 2 * radius_ ||
         now_.area > kThickerThanGraze * kGraze * now_.length;
}

bool LoadWalk::seen_before(Vec2 p, double z, double feed_angle) const {
  const LoadRecord& record = result_.record;
  return record.size() > 0 && !now_.vertical && !last_vertical_ && record.x.back() == p.x &&
         record.y.back() == p.y && record.z.back() == z &&
         std::abs(wrap_signed(feed_angle - last_feed_angle_)) < kSameDirection;
}

void LoadWalk::touch_at_start(Vec2 p, double z, double feed_angle) {
  if (seen_before(p, z, feed_angle)) return;
  arcs_.clear();
  if (z < stock_.top() && !now_.vertical)
    find_engaged_arcs(stock_, {p, radius_ + kSkin, z, feed_angle}, -kPi / 2, kPi / 2, arcs_);
}

// What this step is about to cut on the circle where it ends: where the tool was before, it meets
// nothing, although its circle coincides with what it left.
void LoadWalk::touch_at_end(const Segment& path, double z, double feed_angle) {
  arcs_.clear();
  if (z >= stock_.top()) return;
  double low = -kPi / 2, high = kPi / 2;
  if (now_.vertical) {
    low = -kPi;
    high = kPi;
  } else if (path.is_arc() && path.radius < radius_) {
    // In so tight a turn the step sweeps, on its inner side, a part of the circle itself.
    const double swept = 0.5 * path.length() * (1 / path.radius - 1 / radius_);
    (path.sweep > 0 ? high : low) -= std::copysign(std::min(swept, kPi / 2), path.sweep);
  }
  find_engaged_arcs(stock_, {path.b, radius_ - kSkin, z, feed_angle}, low, high, arcs_);
}

void LoadWalk::sample(Vec2 p, double z, double feed_angle, double length) {
  LoadRecord& record = result_.record;
  last_feed_angle_ = feed_angle;
  last_vertical_ = now_.vertical;
  record.x.push_back(p.x);
  record.y.push_back(p.y);
  record.z.push_back(z);
  record.move.push_back(static_cast<std::int32_t>(now_.number));
  record.kind.push_back(static_cast<std::int8_t>(now_.move.kind));
  record.length.push_back(length);
  record.time.push_back(time_);
  record.feed.push_back(now_.feed);
  record.removed_volume.push_back(removed_);
  record.gouge.push_back(now_.gouging ? part_.depth(p, z) : 0);
  append_load(p, z, feed_angle, length);
}

void LoadWalk::append_load(Vec2 p, double z, double feed_angle, double length) {
  LoadRecord& record = result_.record;
  const double engagement = engagement_of(arcs_);
  double deepest = 0, face = 0;  // face: mm^2 of material across the feed
  double width = 0;
  for (const EngagedArc& arc : arcs_) {
    deepest = std::max(deepest, arc.depth);
    const double across = radius_ * (std::sin(arc.high) - std::sin(arc.low));
    width += across;
    face += arc.depth * across;
  }
  now_.length += length;
  now_.area += width * length;
  now_.plunged = now_.plunged || (now_.vertical && engagement > 0);
  record.engagement.push_back(engagement);
  record.axial_depth.push_back(deepest);
  // The side of the tool moves on over the level share of the feed, its tip down over the rest.
  const double before = record.size() > 1 ? record.z[record.size() - 2] : z;
  double rate = now_.level_share * face;
  if (length > 0 && z < before)
    rate += (before - z) / length * stock_.area_above({p.x, p.y}, radius_, z);
  record.removal_rate.push_back(now_.feed * rate);
  record.first_arc.push_back(record.arcs.size());
  record.arcs.insert(record.arcs.end(), arcs_.begin(), arcs_.end());
  append_chips();
  if (force_) append_force(feed_angle);
}

void LoadWalk::append_chips() {
  LoadRecord& record = result_.record;
  double largest = 0, mean = 0, angle = 0;
  if (params_.spindle_speed > 0 && !now_.vertical) {
    const double feed_per_tooth =
        now_.level_share * now_.feed / (params_.spindle_speed * params_.teeth);
    for (const EngagedArc& arc : arcs_) {
      const double steepest = std::clamp(0.0, arc.low, arc.high);
      largest = std::max(largest, feed_per_tooth * std::cos(steepest));
      mean += feed_per_tooth * (std::sin(arc.high) - std::sin(arc.low));
      angle += arc.high - arc.low;
    }
  }
  record.h_max.push_back(largest);
  record.h_mean.push_back(angle > 0 ? mean / angle : 0);
}

void LoadWalk::append_force(double feed_angle) {
  LoadRecord& record = result_.record;
  CuttingForce force;
  if (!now_.vertical && !arcs_.empty())
    force = force_->force(arcs_.data(), arcs_.size(),
                          now_.level_share * now_.feed / (params_.spindle_speed * params_.teeth),
                          params_.spindle_speed, feed_angle);
  record.force_peak.push_back(force.peak_xy);
  record.force_mean.push_back(force.mean_xy);
  record.force_x_peak.push_back(force.peak_x);
  record.force_y_peak.push_back(force.peak_y);
  record.torque_peak.push_back(force.peak_torque);
  record.torque_mean.push_back(force.mean_torque);
  record.power_mean.push_back(force.mean_power);
}

// G-code does not tell what a move is for. Going down it enters, and also where it goes once more
// along the way it came down, as the level end of a helix; through material it cuts. What meets
// nothing is a link if it rises, or if it is faster than all that cut; else it cuts air.
MoveKind LoadWalk::inferred_kind(const Move& from, const std::vector<MovePiece>& pieces) {
  const auto retraced = [&](Vec2 p) {
    return std::any_of(entry_.begin(), entry_.end(),
                       [&](const Segment& way) { return way.distance_to(p) < kRetraced; });
  };
  const auto goes_along_entry = [&](const MovePiece& piece) {
    return retraced(piece.path.point(0)) && retraced(piece.path.point(0.5)) &&
           retraced(piece.path.point(1));
  };
  double length = 0;
  for (const MovePiece& piece : pieces) length += piece.path.length();
  const bool descends = from.z - now_.move.z > kEntrySlope * length;
  if (descends && length == 0 && !cuts()) return MoveKind::kLink;  // down where all is cleared
  if (descends) {
    for (const MovePiece& piece : pieces) entry_.push_back(piece.path);
    return MoveKind::kEntry;
  }
  if (cuts() && std::all_of(pieces.begin(), pieces.end(), goes_along_entry))
    return MoveKind::kEntry;
  entry_.clear();
  if (cuts()) {
    fastest_cut_ = std::max(fastest_cut_, now_.feed);
    return MoveKind::kCut;
  }
  if (now_.move.z > from.z + kLevel) return MoveKind::kLink;
  idle_.push_back({now_.first_sample, result_.record.size(), now_.feed});
  return MoveKind::kCut;
}

void LoadWalk::finish_move(const Move& from, const std::vector<MovePiece>& pieces) {
  if (now_.move.kind == MoveKind::kRapid) {
    entry_.clear();
  } else if (params_.infer_kinds || (now_.plunges && now_.move.kind == MoveKind::kCut)) {
    const MoveKind kind = params_.infer_kinds ? inferred_kind(from, pieces) : MoveKind::kEntry;
    std::fill(result_.record.kind.begin() + static_cast<std::ptrdiff_t>(now_.first_sample),
              result_.record.kind.end(), static_cast<std::int8_t>(kind));
  }
  if (!(now_.in_material > 0)) return;
  const bool rapid = now_.move.kind == MoveKind::kRapid;
  Worst& sum = rapid ? result_.figures.rapid_in_material : result_.figures.plunge_in_material;
  if (sum.value == 0) sum.at = now_.met;
  sum.value += now_.in_material;
  result_.figures.incidents.push_back(
      {rapid ? IncidentKind::kRapidInMaterial : IncidentKind::kPlungeInMaterial, now_.met,
       now_.number, now_.in_material});
}

void LoadWalk::finish() {
  for (const Idle& idle : idle_) {
    if (idle.feed > fastest_cut_)
      std::fill(result_.record.kind.begin() + static_cast<std::ptrdiff_t>(idle.first),
                result_.record.kind.begin() + static_cast<std::ptrdiff_t>(idle.end),
                static_cast<std::int8_t>(MoveKind::kLink));
  }
  result_.record.first_arc.push_back(result_.record.arcs.size());
  result_.figures.removed_volume = removed_;
}

}  // namespace evenload
