#include "surface/ordering.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "surface/lead.h"

namespace evenload {

namespace {

constexpr double kNowhere = 1e-6;  // mm: no move is as short

class PathMaker {
 public:
  PathMaker(const Ground& ground, const FinishParams& params) : ground_(ground), params_(params) {}

  void cut(const std::vector<Waypoint>& points) {
    for (std::size_t i = 1; i < points.size(); ++i) feed_to(points[i], MoveKind::kCut);
    ++path_.report.passes;
  }

  // Along the surface, in a straight line in plan. None is needed where a turn of a spiral begins.
  void link_to(const SpacePoint& end) {
    if (!(distance(at_, end) > kNowhere)) return;
    const Vec2 way = plan(end) - plan(at_);
    const double length = norm(way);
    if (length > kNowhere) {
      const PlanLine line{plan(at_), way / length};
      std::vector<DropSample> samples =
          samples_along(ground_, line, 0, length, params_.tolerance, Sampled::kLink);
      samples.front().z = at_.z;
      samples.back().z = end.z;
      const std::vector<Waypoint> points =
          lines_of(line, samples, params_.tolerance, LineEnds::kFixed);
      for (std::size_t i = 1; i + 1 < points.size(); ++i) feed_to(points[i], MoveKind::kLink);
    }
    feed_to({end}, MoveKind::kLink);
    ++path_.report.links;
  }

  // Over the part, and by an arc to where a pass begins.
  void come_down(const std::vector<Waypoint>& pass) {
    std::vector<SpacePoint> arc = lead_arc(ground_, pass, params_);
    std::reverse(arc.begin(), arc.end());
    arc.push_back(pass.front());
    fly_to(arc.front());
    for (std::size_t i = 1; i < arc.size(); ++i) feed_to({arc[i]}, MoveKind::kEntry);
  }

  // By an arc from where a pass ends.
  void leave(const std::vector<Waypoint>& pass) {
    for (const SpacePoint& p : lead_arc(ground_, turned_round(pass), params_))
      feed_to({p}, MoveKind::kLink);
  }

  Toolpath finished() {
    rapid_to({at_.x, at_.y, params_.clearance_height});
    return std::move(path_);
  }

  const SpacePoint& at() const { return at_; }

 private:
  // Over the part, and down by the plunge feed from where material may stand.
  void fly_to(const SpacePoint& end) {
    if (path_.moves.empty()) {
      rapid_to({end.x, end.y, params_.clearance_height});
    } else {
      rapid_to({at_.x, at_.y, params_.safe_height});
      rapid_to({end.x, end.y, params_.safe_height});
      ++path_.report.retracts;
    }
    rapid_to({end.x, end.y, std::max(params_.top, end.z)});
    if (at_.z > end.z) feed_to({end}, MoveKind::kEntry);
  }

  // Downwards no faster than the tool may plunge.
  double feed_on(const SpacePoint& end, double length) const {
    const double down = at_.z - end.z;
    if (down * params_.feed <= params_.plunge_feed * length) return params_.feed;
    return params_.plunge_feed * length / down;
  }

  void feed_to(const Waypoint& end, MoveKind kind) {
    const double length = way_length(at_, end);
    if (!(length > kNowhere)) return;
    const double feed = feed_on(end, length);
    add(end, kind, feed, kSecondsPerMinute * length / feed);
    (kind == MoveKind::kCut ? path_.report.cut_length : path_.report.link_length) += length;
  }

  void rapid_to(const SpacePoint& end) {
    const double length = path_.moves.empty() ? 0 : distance(at_, end);
    if (!path_.moves.empty() && !(length > kNowhere)) return;
    add({end}, MoveKind::kRapid, 0, kSecondsPerMinute * length / params_.rapid_feed);
  }

  void add(const Waypoint& end, MoveKind kind, double feed, double seconds) {
    const Vec2 centre = end.sweep == 0 ? Vec2{} : centre_of(at_, end);
    path_.moves.push_back({kind, end.x, end.y, end.z, end.sweep, centre.x, centre.y, feed});
    path_.report.cutting_time += seconds;
    at_ = end;
  }

  const Ground& ground_;
  const FinishParams& params_;
  Toolpath path_;
  SpacePoint at_;
};

class Ordering {
 public:
  Ordering(std::vector<PassPart> parts, const FinishParams& params)
      : parts_(std::move(parts)), is_left_(parts_.size(), true), params_(params) {}

  // The part of the next pass to which a link may go; none without one.
  std::optional<std::size_t> linked(std::size_t before, const SpacePoint& at) const {
    const double reach = std::max(kLinkReach * params_.stepover, params_.cutter.radius);
    std::optional<std::size_t> best;
    double nearest = reach;
    for (std::size_t i = before + 1; i < parts_.size() && parts_[i].row <= parts_[before].row + 1;
         ++i) {
      const bool is_next = parts_[i].row > parts_[before].row || is_spiral(params_.pattern);
      if (!is_left_[i] || !is_next) continue;
      const SpacePoint start = place_of(parts_[i], nearest_start(parts_[i], at));
      const double off = norm(plan(start - at));
      if (off > nearest || std::abs(start.z - at.z) > reach) continue;
      nearest = off;
      best = i;
    }
    return best;
  }

  std::optional<std::size_t> first_left() const {
    const auto found = std::find(is_left_.begin(), is_left_.end(), true);
    if (found == is_left_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - is_left_.begin());
  }

  // The points of a part, in the order in which they are cut after a link from `from`, if any.
  const std::vector<Waypoint>& take(std::size_t i, const SpacePoint* from) {
    is_left_[i] = false;
    PassPart& part = parts_[i];
    if (!from) return part.points;
    const Start start = nearest_start(part, *from);
    if (part.is_closed)
      begin_at(part.points, start);
    else if (start.piece > 0)
      part.points = turned_round(part.points);
    return part.points;
  }

 private:
  // Where a part may begin: at the share of a piece, which is numbered as the corner at its end; at
  // the end of the last one backwards.
  struct Start {
    std::size_t piece = 0;
    double share = 0;
  };

  static SpacePoint place_of(const PassPart& part, Start start) {
    if (start.piece == 0) return part.points.front();
    return place_on(part.points[start.piece - 1], part.points[start.piece], start.share);
  }

  Start nearest_start(const PassPart& part, const SpacePoint& at) const {
    std::vector<Start> starts{{}};
    const std::vector<Waypoint>& points = part.points;
    if (part.is_closed)
      for (std::size_t k = 1; k < points.size(); ++k)
        starts.push_back({k, nearest_share(points[k - 1], points[k], plan(at))});
    else if (is_to_and_fro(params_.pattern))
      starts.push_back({points.size() - 1, 1});
    return *std::min_element(starts.begin(), starts.end(), [&](Start a, Start b) {
      return norm(plan(place_of(part, a) - at)) < norm(plan(place_of(part, b) - at));
    });
  }

  // Makes a closed way begin elsewhere.
  static void begin_at(std::vector<Waypoint>& points, Start start) {
    if (start.piece == 0) return;
    const Waypoint end = points[start.piece];
    const SpacePoint at = place_on(points[start.piece - 1], end, start.share);
    const auto piece = static_cast<std::ptrdiff_t>(start.piece);
    if (start.share > 0 && start.share < 1) {
      points[start.piece].sweep = (1 - start.share) * end.sweep;
      points.insert(points.begin() + piece, {at, start.share * end.sweep});
    }
    // What is now the way's beginning; the corner that was it is its end as well.
    const std::ptrdiff_t first = start.share > 0 ? piece : piece - 1;
    points.front().sweep = points.back().sweep;
    points.pop_back();
    std::rotate(points.begin(), points.begin() + first % std::ssize(points), points.end());
    points.push_back(points.front());
    points.front().sweep = 0;
  }

  std::vector<PassPart> parts_;
  std::vector<bool> is_left_;
  const FinishParams& params_;
};

}  // namespace

Toolpath in_order(const Ground& ground, std::vector<PassPart> parts, const FinishParams& params,
                  Progress& progress) {
  // What is not yet cut lies to the left of passes that follow each other, or to the right from the
  // inside outwards. A tool that turns clockwise climbs with it on its right.
  const bool is_on_left = params.pattern != Pattern::kContoursOutwards;
  if (params.is_climb == is_on_left && !is_spiral(params.pattern))  // which turn as they shall
    for (PassPart& part : parts) part.points = turned_round(part.points);
  Ordering order(std::move(parts), params);
  PathMaker maker(ground, params);
  std::optional<std::size_t> next = order.first_left();
  bool is_linked = false;
  while (next) {
    progress.step();
    const SpacePoint at = maker.at();
    const std::vector<Waypoint>& points = order.take(*next, is_linked ? &at : nullptr);
    if (is_linked)
      maker.link_to(points.front());
    else
      maker.come_down(points);
    maker.cut(points);
    std::optional<std::size_t> linked;
    if (!is_one_way(params.pattern)) linked = order.linked(*next, maker.at());
    is_linked = linked.has_value();
    if (!is_linked) maker.leave(points);
    next = is_linked ? linked : order.first_left();
  }
  return maker.finished();
}

}  // namespace evenload
