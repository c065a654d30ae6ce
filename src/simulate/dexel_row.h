// One dexel row: the height of the stock over a line of the plane, constant between floating-point
// ends.
//
// Stock that is milled from above with flat tools is a height over the plane. A row keeps it as
// pieces, each from its own x to the next piece's; the last piece only ends the row. Nothing lies
// outside of them. Laws: neighbouring pieces differ in height; the row neither begins nor ends with
// a piece without material; cutting twice is cutting once.
// Source: the dexels of [Jacsó 2021, simulation], with a height in each.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace evenload {

// Height where there is no material.
inline constexpr double kNoMaterial = -std::numeric_limits<double>::infinity();

// mm along a row: shorter pieces are not kept; rounding alone makes them.
inline constexpr double kShortestPiece = 1e-8;

// What a cut took from a row.
struct RowRemoval {
  double area = 0;           // mm^2 in the row's plane: length times height
  double through = 0;        // mm: where material was, and none is left
  double node_height = 0;    // mm: height taken at the row's nodes, summed
  double through_nodes = 0;  // nodes where none is left
};

// Equally spaced places on a row: first, first + spacing, ...
struct RowNodes {
  double first = 0, spacing = 1;  // mm
  // How many of them lie in [low, high).
  double count(double low, double high) const;
};

class DexelRow {
 public:
  struct Piece {
    double x = 0;              // mm, where it begins
    double top = kNoMaterial;  // mm
  };

  const std::vector<Piece>& pieces() const { return pieces_; }
  bool empty() const { return pieces_.empty(); }

  // Height at x; kNoMaterial where there is none.
  double top_at(double x) const;
  // Fills [low, high) up to `top` where it is lower.
  void raise(double low, double high, double top);
  // Lowers [low, high) to `z` where it is higher; nothing stays of what would not rise above
  // `bottom`. `scratch` is working memory.
  void cut(double low, double high, double z, double bottom, const RowNodes& nodes,
           RowRemoval& removal, std::vector<Piece>& scratch);

 private:
  std::vector<Piece> pieces_;
};

// The pieces that begin within [low, high] and change whether there is material above `z`: calls
// visit(x).
template <typename Visit>
void visit_borders(const DexelRow& row, double z, double low, double high, Visit&& visit) {
  const std::vector<DexelRow::Piece>& pieces = row.pieces();
  auto piece = std::lower_bound(pieces.begin(), pieces.end(), low,
                                [](const DexelRow::Piece& p, double x) { return p.x < x; });
  bool before = piece != pieces.begin() && std::prev(piece)->top > z;
  for (; piece != pieces.end() && piece->x <= high; ++piece) {
    const bool now = piece->top > z;
    if (now != before) visit(piece->x);
    before = now;
  }
}

}  // namespace evenload
