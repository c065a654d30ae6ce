#include "occt/join.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <numeric>
#include <string>

#include "occt/shape_error.h"

namespace evenload {
namespace {

// Ends nearer than this, in mm, are one point: OpenCASCADE's own precision.
constexpr double kSamePoint = 1e-7;
constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

struct End {
  Vec2 p;
  double z = 0;
  double error = 0;
  std::size_t member = 0;
  std::size_t partner = kNobody;
};

double apart(const End& a, const End& b) {
  return std::hypot(a.p.x - b.p.x, a.p.y - b.p.y, a.z - b.z);
}

std::string place(const End& end) {
  char text[80];
  std::snprintf(text, sizeof text, "(%.3f, %.3f)", end.p.x, end.p.y);
  return text;
}

// End 2i is the start of piece i, end 2i + 1 its other end.
std::vector<End> ends_of(const std::vector<Piece>& pieces) {
  std::vector<End> ends;
  for (const Piece& piece : pieces) {
    ends.push_back({piece.curve.vertices().front().p, piece.z, piece.end_error, piece.member});
    ends.push_back({piece.curve.vertices().back().p, piece.z, piece.end_error, piece.member});
  }
  return ends;
}

enum class Junctions { kRefused, kLeftOpen };

// Marries the single ends that lie within max(gap, their errors) of each other.
void pair_up(std::vector<End>& ends, double gap, bool use_errors, Junctions junctions) {
  std::vector<std::size_t> order;
  double reach = gap;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (ends[i].partner != kNobody) continue;
    order.push_back(i);
    if (use_errors) reach = std::max(reach, ends[i].error);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return ends[a].p.x < ends[b].p.x || (ends[a].p.x == ends[b].p.x && a < b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    End& a = ends[order[i]];
    std::vector<std::size_t> near;
    for (const int step : {-1, 1}) {
      for (std::size_t j = i + step; j < order.size();
           j += step) {  // below 0 it wraps round and ends
        const End& b = ends[order[j]];
        if (std::abs(b.p.x - a.p.x) > reach) break;
        const double limit = use_errors ? std::max({gap, a.error, b.error}) : gap;
        if (apart(a, b) <= limit) near.push_back(order[j]);
      }
    }
    if (near.size() > 1 && junctions == Junctions::kLeftOpen) continue;
    if (near.size() > 1) {
      throw ShapeError(ShapeFault::kBranching, a.member,
                       "More than two edges meet at " + place(a) +
                           ": leave only the outline's own, without doubles.");
    }
    if (near.size() == 1) a.partner = near[0];
  }
}

[[noreturn]] void throw_open(const std::vector<End>& ends, std::size_t lonely) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (i != lonely && ends[i].partner == kNobody)
      nearest = std::min(nearest, apart(ends[i], ends[lonely]));
  }
  char gap[40];
  std::snprintf(gap, sizeof gap, "%.3g mm", nearest);
  throw ShapeError(ShapeFault::kOpen, ends[lonely].member,
                   "The outline is open at " + place(ends[lonely]) + ", the nearest other end is " +
                       gap + " away: close it.");
}

std::vector<Piece> without_points(const std::vector<Piece>& all) {
  std::vector<Piece> pieces;
  for (const Piece& piece : all) {
    if (piece.curve.length() > kSamePoint) pieces.push_back(piece);
  }
  return pieces;
}

std::vector<End> paired_ends(const std::vector<Piece>& pieces, Junctions junctions) {
  std::vector<End> ends = ends_of(pieces);
  pair_up(ends, kSamePoint, false, junctions);
  pair_up(ends, kJoinGap, true, junctions);
  // At a junction an end may have been chosen by one that it did not choose.
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (ends[i].partner != kNobody && ends[ends[i].partner].partner != i) ends[i].partner = kNobody;
  return ends;
}

// The curve that is entered at an end, until it closes or nothing follows.
Loop follow(const std::vector<Piece>& pieces, const std::vector<End>& ends, std::size_t first,
            std::vector<bool>& used) {
  std::vector<Vertex> vertices;
  std::size_t entry = first, last = first;
  do {
    const std::size_t i = entry / 2;
    used[i] = true;
    const Curve along = entry % 2 == 0 ? pieces[i].curve : pieces[i].curve.reversed();
    vertices.insert(vertices.end(), along.vertices().begin(), along.vertices().end() - 1);
    last = entry ^ 1;
    entry = ends[last].partner;
  } while (entry != first && entry != kNobody);
  const bool closed = entry == first;
  if (!closed) vertices.push_back({ends[last].p, 0, false});
  return {Curve(std::move(vertices), closed), pieces[first / 2].z, pieces[first / 2].member};
}

std::vector<Loop> curves_of(const std::vector<Piece>& pieces, const std::vector<End>& ends) {
  std::vector<Loop> curves;
  std::vector<bool> used(pieces.size(), false);
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (ends[i].partner == kNobody && !used[i / 2]) curves.push_back(follow(pieces, ends, i, used));
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (!used[i]) curves.push_back(follow(pieces, ends, 2 * i, used));
  return curves;
}

}  // namespace

std::vector<Loop> join(const std::vector<Piece>& all) {
  const std::vector<Piece> pieces = without_points(all);
  const std::vector<End> ends = paired_ends(pieces, Junctions::kRefused);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (ends[i].partner == kNobody) throw_open(ends, i);
  }
  return curves_of(pieces, ends);
}

std::vector<Loop> join_chains(const std::vector<Piece>& all) {
  const std::vector<Piece> pieces = without_points(all);
  return curves_of(pieces, paired_ends(pieces, Junctions::kLeftOpen));
}

}  // namespace evenload
