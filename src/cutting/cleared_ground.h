// The ground that the tool has cleared: the union of discs swept along moves, exact, without
// polygons; cells only find the moves that matter.
//
// The question a steering method asks is not "what is the boundary?" but "which part of the tool's
// circle at P touches material?". It is answered by subtracting from the circle, one after the
// other, the arcs that earlier moves cleared. A move along a line or arc sweeps a capsule or a bent
// capsule; its border crosses a circle in a few angles with closed forms. No arrangement of curves
// is built, so there is none that could become inconsistent.
//
// Which moves matter is told by a grid of small cells. A cell knows the moves that sweep a part of
// it, or the one that sweeps all of it, after which it takes no more. So a look costs as much as
// there are borders of swept ground near the circle, however long the history is. Tolerance:
// kCoverTolerance.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "cutting/swept_move.h"
#include "geometry/boundary_index.h"
#include "geometry/box_tree.h"
#include "geometry/region.h"
#include "support/progress.h"

namespace evenload {

// mm: material thinner than this does not count as material; above the tolerance of offsets.
inline constexpr double kCoverTolerance = 2e-5;
// A look takes some microseconds.
inline constexpr std::uint32_t kLooksOfStep = 256;

// rad: moves that turn by more between two places which are apart did not cut the front from one to
// the other; it is what their loops left.
inline constexpr double kMostTurnOfFront = kPi / 2;

class ClearedGround {
 public:
  // `bounds`: where the tool's centre may be. `tool_radius` mm.
  // `material`: where there is stock at all; nullptr: everywhere that the tool can touch. The
  // pieces of its border that are marked open are edges of the stock; the tool cannot pass the
  // others.
  ClearedGround(const Bounds& bounds, double tool_radius, const std::vector<Region>* material);

  double tool_radius() const { return tool_radius_; }

  // From now on every kLooksOfStep looks at circles, and moves that are added or taken back, are a
  // step of `progress`, which must outlive this and its copies: nearly all work that takes long
  // consists of them. Where one throws Cancelled the ground is as it was before.
  void tell(Progress& progress) { progress_ = &progress; }

  void add(const Segment& move) { add(move, tool_radius_); }
  void add(const Segment& move, double swept_radius);
  void add_disc(Vec2 centre, double radius) { add(Segment::line(centre, centre), radius); }
  // Takes back the newest move. Condition: it was added since the last settle().
  void remove_last();
  // The newest move becomes `longer`, which goes on from its end by `more`. The same as to take it
  // back and to add the longer one, at the price of what is new. Condition: as remove_last().
  void extend_last(const Segment& longer, const Segment& more);
  // The moves made so far stay: long lists about those from `first` on are thinned for good. Moves
  // that are only tried then need not thin them over and over.
  void settle(std::size_t first);
  std::size_t size() const { return moves_.size(); }

  // The arcs of the tool's circle about `p` within [low, high] (high - low <= 2 pi) that touch
  // material, in order. `shrink` mm: the circle's radius is the tool's less this.
  void uncovered(Vec2 p, double low, double high, std::vector<AngularInterval>& out,
                 double shrink = kCoverTolerance) const {
    uncovered(p, low, high, out, shrink, moves_.size());
  }
  // The same, as it was before the move numbered `last`.
  void uncovered(Vec2 p, double low, double high, std::vector<AngularInterval>& out, double shrink,
                 std::size_t last) const;
  // True when the whole circle about `p` is free of material.
  bool is_clear(Vec2 p, double shrink = kCoverTolerance) const;
  // True when the point `x` holds no material.
  bool is_cleared_point(Vec2 x) const;
  // True only when no point within `margin` mm of `x` holds material. Not always then: several
  // moves together may have cleared them, or one that is not kept here, for others hide it.
  bool is_cleared_around(Vec2 x, double margin) const;
  // True when no cusp of the border of the cleared ground is known of between two places on it: one
  // move swept both sides, or moves that are tangent to each other, none of which turns towards the
  // border more tightly than the disc is round, or one edge of the stock ends there. A newer move
  // that bit the border between them is not looked for, nor whether the moves lead away from the
  // border and back to it, as the loops of a trochoid do: places near each other hardly hide that;
  // for others, moves that turn by more than `most_turn` rad between them do not count. As it was
  // before the move numbered `last`: the disc at the end of a move borders on all of a circle about
  // that end.
  bool is_smooth_between(Vec2 a, Vec2 b, std::size_t last,
                         double most_turn = std::numeric_limits<double>::infinity()) const;
  bool is_smooth_between(Vec2 a, Vec2 b) const { return is_smooth_between(a, b, moves_.size()); }
  // True when `x`, which held material before the move numbered `first`, was cleared since.
  bool is_cleared_since(Vec2 x, std::size_t first) const;

 private:
  // Lists of moves are linked backwards through `entries_`, the newest first: what was added last
  // is taken back first. Long lists are thinned: moves hidden by a newer one are left out. What was
  // before is kept, for looks at the ground as it was and for moves that are taken back.
  struct Cell {
    std::int32_t covered_by = -1;  // the move that sweeps the whole cell
    std::int32_t newest = -1;      // in entries_
    std::int32_t thinning = -1;    // in thinnings_, the last one
  };
  struct Entry {
    std::int32_t move = 0, before = -1;
    std::int32_t length = 1;  // of the list from here
  };
  struct Thinning {
    std::int32_t move = 0;     // the newest when it was made
    std::int32_t newest = -1;  // the list before it
    std::int32_t length = 0;   // of the list after it
    std::int32_t earlier = -1;
  };
  // How long the lists of all cells were before a move was added.
  struct Mark {
    std::size_t entries = 0, thinnings = 0;
  };
  // The part of the circle that is decided at once.
  struct Window {
    Vec2 middle;
    double low = 0, high = 0;
  };
  // Which moves a look has taken into account.
  struct Seen {
    std::vector<std::uint64_t> moves;  // the last look that did
    std::uint64_t look = 0;
  };
  void subtract_near(const Window& window, const Cell& cell, const CircleLook& look,
                     AngularInterval part, Seen& seen, std::vector<AngularInterval>& set) const;
  void count_look() const {
    if (progress_ && ++looks_ % kLooksOfStep == 0) progress_->step();
  }
  template <typename Continue>
  void look_round(Vec2 p, double low, double high, double shrink, std::size_t last,
                  std::vector<AngularInterval>& set, Continue go_on) const;
  // A place of a move beside which the border of what it swept is.
  struct BorderPlace {
    std::size_t move = 0;
    double t = 0;
    double side = 0;  // 1: on its left, -1: on its right
  };
  // Of the newest move before `last` on whose border `x` is.
  std::optional<BorderPlace> place_bordering(Vec2 x, std::size_t last) const;
  bool runs_on(const BorderPlace& first, const BorderPlace& last, double most_turn) const;
  void remove_outside_material(Vec2 p, double base, double radius,
                               std::vector<AngularInterval>& set) const;
  int windows_in(double angle, double radius) const;
  const Cell& cell_at(Vec2 x) const;
  const Cell& cell_at_grid(Vec2 at) const;
  // Writes down in all cells near `part`, the newest move or a part of it, what that move sweeps.
  void spread(const SweptMove& part);
  void list(Cell& cell, std::int32_t move);
  bool is_long(const Cell& cell, std::int32_t least, double growth) const;
  void thin(Cell& cell, Vec2 centre);
  std::int32_t newest_before(const Cell& cell, std::size_t last) const;
  template <typename Visit>
  void visit_cells(const SweptMove& move, Visit visit);

  double tool_radius_;
  double cell_;
  double cells_per_mm_ = 0;  // 1 / cell_
  double half_window_ = 0;   // mm along the circle
  // Of looks at half a circle, which are most of all.
  int half_circle_windows_ = 0;
  Vec2 half_circle_turn_;  // from one window to the next
  double reach_ = 0;  // mm from a cell's centre: holds every window whose middle is in the cell
  Vec2 origin_;
  int columns_ = 0, rows_ = 0;
  std::vector<Cell> cells_;
  Cell untouched_;
  std::vector<Entry> entries_;
  std::vector<Thinning> thinnings_;
  std::vector<Mark> marks_;  // one for each move
  std::vector<SweptMove> moves_;
  std::size_t settled_ = 0;     // moves that stay
  bool has_long_list_ = false;  // since then
  std::vector<Segment> material_edges_;
  BoxTree edge_boxes_;
  BoundaryIndex material_{std::vector<Curve>{}};
  bool limited_ = false;
  Progress* progress_ = nullptr;
  mutable std::uint32_t looks_ = 0;
};

}  // namespace evenload
