#include "geometry/offset_graph.h"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/box_tree.h"
#include "geometry/intersect.h"

namespace evenload {

namespace {

struct Cut {
  double t = 0;
  std::uint32_t node = 0;
};

struct Edge {
  std::uint32_t piece = 0;
  double t0 = 0, t1 = 1;
  std::uint32_t from = 0, to = 0;
  double length = 0;
  bool sure = false;  // on the offset beyond doubt
  bool gone = false;
};

class Graph {
 public:
  Graph(const std::vector<OffsetPiece>& pieces, OffsetNodes& nodes, const BoundaryIndex& boundary,
        double d, const OffsetTolerances& tolerances)
      : pieces_(pieces),
        nodes_(nodes),
        boundary_(boundary),
        d_(d),
        tolerances_(tolerances),
        cuts_(pieces.size()) {}

  OffsetLoops loops() {
    cut_where_pieces_meet();
    nodes_.merge_near(tolerances_.same);
    keep_true_parts();
    drop_coincident();
    index_by_node();
    drop_dead_ends();
    return chain();
  }

 private:
  void cut_where_pieces_meet();
  void note_meeting(std::uint32_t a, double ta, std::uint32_t b, double tb, Vec2 p);
  void keep_true_parts();
  void keep_if_true(std::uint32_t piece, const Cut& from, const Cut& to);
  void drop_coincident();
  void index_by_node();
  void drop_dead_ends();
  void drop(std::uint32_t edge);
  OffsetLoops chain();
  std::uint32_t next_edge(std::uint32_t edge) const;
  bool on_right_side(const std::vector<std::uint32_t>& loop) const;
  Curve curve_of(const std::vector<std::uint32_t>& loop) const;

  const std::vector<OffsetPiece>& pieces_;
  OffsetNodes& nodes_;
  const BoundaryIndex& boundary_;
  const double d_;
  const OffsetTolerances& tolerances_;
  std::vector<std::vector<Cut>> cuts_;
  std::vector<Edge> edges_;
  std::vector<std::vector<std::uint32_t>> leaving_, arriving_;  // edges, by node
};

void Graph::note_meeting(std::uint32_t a, double ta, std::uint32_t b, double tb, Vec2 p) {
  const auto at_end = [&](std::uint32_t piece, double t) -> const std::uint32_t* {
    const OffsetPiece& s = pieces_[piece];
    const double length = s.segment.length();
    if (t * length <= tolerances_.same) return &s.from;
    if ((1 - t) * length <= tolerances_.same) return &s.to;
    return nullptr;
  };
  const std::uint32_t* end_a = at_end(a, ta);
  const std::uint32_t* end_b = at_end(b, tb);
  if (end_a != nullptr && end_b != nullptr) {
    nodes_.merge(*end_a, *end_b);
    return;
  }
  const std::uint32_t node = end_a != nullptr ? *end_a : end_b != nullptr ? *end_b : nodes_.add(p);
  if (end_a == nullptr) cuts_[a].push_back({ta, node});
  if (end_b == nullptr) cuts_[b].push_back({tb, node});
}

void Graph::cut_where_pieces_meet() {
  std::vector<Bounds> boxes;
  boxes.reserve(pieces_.size());
  for (const OffsetPiece& piece : pieces_) boxes.push_back(piece.segment.bounds());
  const BoxTree tree(boxes);
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    const Segment& a = pieces_[i].segment;
    tree.visit(grown(boxes[i], tolerances_.same), [&](std::uint32_t k) {
      if (k <= i) return;
      const Segment& b = pieces_[k].segment;
      for (const Meeting& m : meetings(a, b, kTouch)) note_meeting(i, m.ta, k, m.tb, m.p);
      // An end on the other piece counts even where rounding keeps the two from meeting; so do the
      // ends of common stretches.
      for (const double ta : {0.0, 1.0}) {
        const Vec2 p = ta == 0 ? a.a : a.b;
        if (squared_distance(boxes[k], p) > tolerances_.same * tolerances_.same) continue;
        const double tb = b.nearest(p);
        if (distance(b.point(tb), p) <= tolerances_.same) note_meeting(i, ta, k, tb, p);
      }
      for (const double tb : {0.0, 1.0}) {
        const Vec2 p = tb == 0 ? b.a : b.b;
        if (squared_distance(boxes[i], p) > tolerances_.same * tolerances_.same) continue;
        const double ta = a.nearest(p);
        if (distance(a.point(ta), p) <= tolerances_.same) note_meeting(i, ta, k, tb, p);
      }
    });
  }
}

void Graph::keep_true_parts() {
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    std::vector<Cut>& cuts = cuts_[i];
    std::sort(cuts.begin(), cuts.end(),
              [](const Cut& x, const Cut& y) { return x.t != y.t ? x.t < y.t : x.node < y.node; });
    Cut last{0, pieces_[i].from};
    for (const Cut& cut : cuts) {
      if (nodes_.find(cut.node) == nodes_.find(last.node)) continue;
      keep_if_true(i, last, cut);
      last = cut;
    }
    keep_if_true(i, last, {1, pieces_[i].to});
  }
}

void Graph::keep_if_true(std::uint32_t piece, const Cut& from, const Cut& to) {
  const Segment& s = pieces_[piece].segment;
  Edge edge{piece,
            from.t,
            to.t,
            nodes_.find(from.node),
            nodes_.find(to.node),
            (to.t - from.t) * s.length()};
  if (edge.from == edge.to)
    return;  // shorter than the tolerance: pieces turn by half a circle at most
  const double size = std::abs(d_);
  double depth = 0;
  for (const double share : {0.5, 0.2, 0.8}) {
    const Vec2 p = s.point(from.t + share * (to.t - from.t));
    depth = std::max(depth, size - boundary_.distance_below(p, size));
    if (depth > tolerances_.depth) return;
    if (pieces_[piece].doubtful_side && boundary_.contains(p) != (d_ < 0)) return;
  }
  edge.sure = depth <= tolerances_.sure;
  edges_.push_back(edge);
}

// Of parts that run the same way along each other one stays; two that run opposite ways enclose
// nothing, and both go.
void Graph::drop_coincident() {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> between;
  for (std::uint32_t i = 0; i < edges_.size(); ++i)
    between[std::minmax(edges_[i].from, edges_[i].to)].push_back(i);
  const auto middle = [&](const Edge& e) {
    return pieces_[e.piece].segment.point(0.5 * (e.t0 + e.t1));
  };
  for (const auto& [ends, group] : between) {
    for (std::size_t i = 0; i < group.size(); ++i) {
      Edge& e = edges_[group[i]];
      for (std::size_t k = i + 1; k < group.size() && !e.gone; ++k) {
        Edge& other = edges_[group[k]];
        if (other.gone || distance(middle(e), middle(other)) > 2 * tolerances_.same) continue;
        other.gone = true;
        e.gone = e.from != other.from;
        e.sure = e.sure || other.sure;
      }
    }
  }
  edges_.erase(std::remove_if(edges_.begin(), edges_.end(), [](const Edge& e) { return e.gone; }),
               edges_.end());
}

void Graph::index_by_node() {
  leaving_.resize(nodes_.size());
  arriving_.resize(nodes_.size());
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    leaving_[edges_[i].from].push_back(i);
    arriving_[edges_[i].to].push_back(i);
  }
}

void Graph::drop(std::uint32_t edge) {
  Edge& e = edges_[edge];
  e.gone = true;
  std::erase(leaving_[e.from], edge);
  std::erase(arriving_[e.to], edge);
}

void Graph::drop_dead_ends() {
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t i = 0; i < edges_.size(); ++i) waiting.push_back(i);
  while (!waiting.empty()) {
    const std::uint32_t i = waiting.back();
    waiting.pop_back();
    const Edge& e = edges_[i];
    if (e.gone || (!arriving_[e.from].empty() && !leaving_[e.to].empty())) continue;
    drop(i);
    waiting.insert(waiting.end(), arriving_[e.from].begin(), arriving_[e.from].end());
    waiting.insert(waiting.end(), leaving_[e.to].begin(), leaving_[e.to].end());
  }
}

// The edge to go on with: one beyond doubt if there is any, then the one that turns most to the
// left.
std::uint32_t Graph::next_edge(std::uint32_t edge) const {
  const std::vector<std::uint32_t>& choices = leaving_[edges_[edge].to];
  if (choices.size() == 1) return choices[0];
  const Vec2 here = nodes_.at(edges_[edge].to);
  // Directions towards points a little way off, so that curvature tells tangent edges apart.
  double reach = edges_[edge].length;
  for (const std::uint32_t i : choices) reach = std::min(reach, edges_[i].length);
  const auto off = [&](const Edge& e, bool at_start) {
    const double dt = 0.5 * reach / e.length * (e.t1 - e.t0);
    return pieces_[e.piece].segment.point(at_start ? e.t0 + dt : e.t1 - dt) - here;
  };
  const Vec2 back = off(edges_[edge], false);
  std::uint32_t best = choices[0];
  double best_angle = 0;
  for (const std::uint32_t i : choices) {
    const Vec2 way = off(edges_[i], true);
    const double angle =
        wrap_positive(std::atan2(cross(way, back), dot(way, back)));  // clockwise from back
    const bool surer = edges_[i].sure && !edges_[best].sure;
    if (i == best || surer || (edges_[i].sure == edges_[best].sure && angle < best_angle)) {
      best = i;
      best_angle = angle;
    }
  }
  return best;
}

bool Graph::on_right_side(const std::vector<std::uint32_t>& loop) const {
  const Edge* longest = &edges_[loop[0]];
  for (const std::uint32_t i : loop)
    if (edges_[i].length > longest->length) longest = &edges_[i];
  const Vec2 p = pieces_[longest->piece].segment.point(0.5 * (longest->t0 + longest->t1));
  return boundary_.contains(p) == (d_ < 0);
}

Curve Graph::curve_of(const std::vector<std::uint32_t>& loop) const {
  const std::size_t n = loop.size();
  const auto continues = [&](std::size_t i) {  // edge i goes on along the piece of the edge before
    const Edge &before = edges_[loop[(i + n - 1) % n]], &e = edges_[loop[i]];
    return before.piece == e.piece && before.t1 <= e.t0;
  };
  std::size_t start = 0;
  while (start + 1 < n && continues(start)) ++start;
  std::vector<Vertex> vertices;
  for (std::size_t k = 0; k < n;) {
    const Edge& first = edges_[loop[(start + k) % n]];
    double t1 = first.t1;
    for (++k; k < n && continues((start + k) % n); ++k) t1 = edges_[loop[(start + k) % n]].t1;
    const Segment& s = pieces_[first.piece].segment;
    vertices.push_back({nodes_.at(first.from), std::tan((t1 - first.t0) * s.sweep / 4), s.open});
  }
  return Curve(std::move(vertices), true);
}

OffsetLoops Graph::chain() {
  OffsetLoops result;
  double total = 0, chained = 0;
  for (const Edge& e : edges_) total += e.sure ? e.length : 0.0;
  constexpr std::uint32_t kNowhere = ~0u;
  std::vector<std::uint32_t> place(nodes_.size(),
                                   kNowhere);  // of the path's edge that leaves the node
  std::vector<std::uint8_t> passed(nodes_.size(), 0);
  std::vector<std::uint32_t> path;
  for (std::uint32_t seed = 0; seed < edges_.size(); ++seed) {
    if (edges_[seed].gone) continue;
    path.push_back(seed);
    place[edges_[seed].from] = 0;
    while (!path.empty()) {
      const std::uint32_t end = edges_[path.back()].to;
      if (place[end] != kNowhere) {
        const std::vector<std::uint32_t> loop(path.begin() + place[end], path.end());
        path.resize(place[end]);
        for (const std::uint32_t i : loop) {
          place[edges_[i].from] = kNowhere;
          chained += edges_[i].sure ? edges_[i].length : 0.0;
          drop(i);
        }
        const Curve curve = curve_of(loop);
        const bool sliver = std::abs(curve.signed_area()) <= tolerances_.whole * curve.length();
        if (sliver || !on_right_side(loop)) continue;
        result.loops.push_back(curve);
        for (const std::uint32_t i : loop) result.touches += passed[edges_[i].from]++ > 0 ? 1 : 0;
      } else if (leaving_[end].empty()) {
        place[edges_[path.back()].from] = kNowhere;
        drop(path.back());
        path.pop_back();
      } else {
        const std::uint32_t next = next_edge(path.back());
        place[end] = static_cast<std::uint32_t>(path.size());
        path.push_back(next);
      }
    }
  }
  result.lost = total - chained;
  return result;
}

}  // namespace

OffsetLoops offset_loops(const std::vector<OffsetPiece>& pieces, OffsetNodes& nodes,
                         const BoundaryIndex& boundary, double d,
                         const OffsetTolerances& tolerances) {
  return Graph(pieces, nodes, boundary, d, tolerances).loops();
}

}  // namespace evenload
