#include "simulate/dexel_row.h"

#include <cmath>

namespace evenload {
namespace {

using Piece = DexelRow::Piece;

// Rows of few pieces are searched from the front, which is faster.
constexpr std::size_t kFew = 12;

// The first piece that ends behind x, or the last, which ends the row.
std::size_t piece_at(const std::vector<Piece>& pieces, double x) {
  if (pieces.size() <= kFew) {
    std::size_t i = 0;
    while (i + 1 < pieces.size() && pieces[i + 1].x <= x) ++i;
    return i;
  }
  const auto after = std::upper_bound(pieces.begin(), pieces.end(), x,
                                      [](double value, const Piece& p) { return value < p.x; });
  return after == pieces.begin() ? 0 : static_cast<std::size_t>(after - pieces.begin()) - 1;
}

void append(std::vector<Piece>& pieces, double low, double high, double top) {
  if (high - low <= kShortestPiece) return;
  if (pieces.empty() || pieces.back().top != top) pieces.push_back({low, top});
}

}  // namespace

double RowNodes::count(double low, double high) const {
  return std::ceil((high - first) / spacing) - std::ceil((low - first) / spacing);
}

double DexelRow::top_at(double x) const {
  if (pieces_.empty() || x < pieces_.front().x) return kNoMaterial;
  return pieces_[piece_at(pieces_, x)].top;
}

void DexelRow::raise(double low, double high, double top) {
  if (!(high > low)) return;
  std::vector<Piece> result;
  std::vector<double> ends{low, high};
  for (const Piece& piece : pieces_) ends.push_back(piece.x);
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (ends[i + 1] - ends[i] <= kShortestPiece) continue;
    const double now = top_at(ends[i]);
    const bool within = ends[i] >= low && ends[i] < high;
    const double height = within ? std::max(now, top) : now;
    if (result.empty() ? height != kNoMaterial : result.back().top != height)
      result.push_back({ends[i], height});
  }
  if (!result.empty() && result.back().top != kNoMaterial)
    result.push_back({ends.back(), kNoMaterial});
  pieces_ = std::move(result);
}

void DexelRow::cut(double low, double high, double z, double bottom, const RowNodes& nodes,
                   RowRemoval& removal, std::vector<Piece>& scratch) {
  if (pieces_.empty() || high <= pieces_.front().x || low >= pieces_.back().x) return;
  const double height = z > bottom ? z : kNoMaterial;
  const std::size_t first = piece_at(pieces_, low);
  std::size_t last = first;  // behind the last piece that is touched
  bool higher = false;
  for (; last + 1 < pieces_.size() && pieces_[last].x < high; ++last)
    higher = higher || pieces_[last].top > height;
  if (!higher) return;

  scratch.clear();
  for (std::size_t i = first; i < last; ++i) {
    const double begin = pieces_[i].x, end = pieces_[i + 1].x, top = pieces_[i].top;
    if (!(top > height)) {
      append(scratch, begin, end, top);
      continue;
    }
    const double from = std::max(begin, low), to = std::min(end, high);
    append(scratch, begin, from, top);
    append(scratch, from, to, height);
    append(scratch, to, end, top);
    if (!(to > from)) continue;
    const double taken = top - std::max(height, bottom), count = nodes.count(from, to);
    removal.area += taken * (to - from);
    removal.node_height += taken * count;
    if (height == kNoMaterial) {
      removal.through += to - from;
      removal.through_nodes += count;
    }
  }
  // What lies before and behind may now be as high as what was changed.
  if (!scratch.empty() && first > 0 && pieces_[first - 1].top == scratch.front().top)
    scratch.erase(scratch.begin());
  if (first == 0 && !scratch.empty() && scratch.front().top == kNoMaterial)
    scratch.erase(scratch.begin());
  const double before =
      scratch.empty() ? (first > 0 ? pieces_[first - 1].top : kNoMaterial) : scratch.back().top;
  if (pieces_[last].top == before) ++last;
  const std::size_t old = last - first, now = scratch.size();
  const auto at = pieces_.begin() + static_cast<std::ptrdiff_t>(first);
  if (now > old) {
    std::copy(scratch.begin(), scratch.begin() + static_cast<std::ptrdiff_t>(old), at);
    pieces_.insert(at + static_cast<std::ptrdiff_t>(old),
                   scratch.begin() + static_cast<std::ptrdiff_t>(old), scratch.end());
  } else {
    pieces_.erase(std::copy(scratch.begin(), scratch.end(), at),
                  at + static_cast<std::ptrdiff_t>(old));
  }
}

}  // namespace evenload
