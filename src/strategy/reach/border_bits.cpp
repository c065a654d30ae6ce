#include "strategy/reach/border_bits.h"

#include <cmath>
#include <utility>

#include "cutting/engagement.h"
#include "feed/feed_control.h"
#include "strategy/moves/move_ends.h"
#include "strategy/reach/links.h"
#include "support/tolerances.h"
#include "toolpath/machinable.h"

namespace evenload {
namespace {

// mm: of a move that is divided.
constexpr double kShortestPart = 0.006;
// rad: by how much ways back turn off the cut. The first that serves: the more, the clearer posted
// programs show it, rounded to 0.001 mm.
constexpr double kAsides[] = {0.1, 0.05, kLeastAside};

// The way along a line, turned off it by `aside` rad at both ends.
std::vector<Segment> beside(const Segment& line, double aside, bool arcs) {
  if (arcs) return {Segment::from_bulge(line.a, line.b, std::tan(0.5 * aside))};
  const Vec2 along = line.b - line.a;
  const Vec2 middle = line.point(0.5) - 0.5 * std::tan(aside) * left_normal(along);
  return {Segment::line(line.a, middle), Segment::line(middle, line.b)};
}

}  // namespace

WayBack way_back(const std::vector<PlanarMove>& moves, const Pose& to, double longest) {
  std::vector<Segment> back;
  double length = 0;
  for (auto move = moves.rbegin(); move != moves.rend() && move->kind == MoveKind::kCut; ++move) {
    const Segment& cut = move->segment;
    const double t = cut.nearest(to.p);
    const bool is_there =
        distance(cut.point(t), to.p) < kSame && dot(cut.tangent(t), unit(to.heading)) > 1 - kSame;
    const double kept = is_there ? t : 0;
    if (kept < 1) back.push_back(cut.part(kept, 1).reversed());
    length += (1 - kept) * cut.length();
    if (length > longest) return {};
    if (is_there) return {true, joined(back)};
  }
  return {};
}

std::vector<Segment> beside_cuts(const std::vector<Segment>& back, bool arcs,
                                 const std::function<bool(const std::vector<Segment>&)>& is_free) {
  std::vector<Segment> result;
  for (const Segment& move : back) {
    std::vector<Segment> way{move};
    for (const bool by_arc : {true, false})
      for (const double aside : kAsides) {
        // Posts that write no arcs make lines of those, too.
        if ((move.is_arc() && arcs) || way.front() != move || (by_arc && !arcs)) continue;
        std::vector<Segment> other = beside(Segment::line(move.a, move.b), aside, by_arc);
        if (!is_tight(other.front()) && is_free(other)) way = std::move(other);
      }
    result.insert(result.end(), way.begin(), way.end());
  }
  return result;
}

void divide_run_up(std::vector<Segment>& way, double length, const Pass& pass,
                   const ClearingParams& params) {
  const Segment first = way.front();
  const double cut = length_of(way) - length - pass.idle_after;
  if (length < kShortestPart || first.length() - length < kShortestPart || cut <= 0 ||
      params.feed_control == FeedControl::kConstantFeed)
    return;
  FeedParams feeds;
  feeds.feed = params.feed;
  feeds.maximum_feed = params.maximum_feed;
  const double width = pass.cut_area / cut;
  const double nominal = side_step(params.engagement_angle, 0.5 * params.tool_diameter);
  const double feed = allowed_feed(width / nominal, feeds);
  const double saved = 60 * length * (1 / feed - 1 / params.maximum_feed);  // s
  if (saved < params.move_price) return;
  const double t = length / first.length();
  const Segment run_up = first.part(0, t), bit = first.part(t, 1);
  if (is_tight(run_up) || is_tight(bit)) return;
  way.front() = bit;
  way.insert(way.begin(), run_up);
}

}  // namespace evenload
