// The surface that a tool with a rounded end leaves, as heights over a part: dexels along z.
//
// 1. The part is looked at in the middle of each cell: its height and how it leans. Over it stands
//    an even layer of stock. 2. Each piece of the path lowers what it sweeps, by swept_cutter's
//    laws, so that heights are exact in the middles however far these are apart. 3. Where two
//    neighbouring cells are cut by different passes a cusp stands between them; its ridge is found
//    on the way from middle to middle by both passes' undersides, and not looked for among cells:
//    cells as coarse as a third of the stepover tell it.
// Laws: figures are across the part's surface, a height over it times the z of its normal; same
// input, same bytes, on any number of threads; a cell takes 40 bytes here, and as many again in
// what Python gets of it.
#pragma once

#include <cstdint>
#include <vector>

#include "simulate/height_map.h"
#include "support/progress.h"
#include "surface/cutter.h"
#include "toolpath/toolpath.h"

namespace evenload {

struct SurfaceMapParams {
  Cutter cutter;
  Vec2 first;                   // the middle of the first cell, mm
  double spacing = 0;           // mm between middles
  int columns = 0, rows = 0;    // along x and y
  double stock = 0;             // mm that stands on the part before, across its surface
  double teeth_per_minute = 0;  // 0: the tool cuts all along, without the marks of its teeth
  int threads = 0;              // 0: as many as there are cores
};

// Rows of cells along x, one after the other.
struct SurfaceMap {
  std::vector<double> part;     // mm: z of the part; kNoMaterial where there is none
  std::vector<float> lean;      // z of the part's normal, which is of length 1
  std::vector<bool> is_picked;  // whether what lies on top there is to be machined
  // mm that stands on the part; negative: cut into it, by no more than the way sideways out of it.
  // The stock where nothing has cut.
  std::vector<double> above;
  std::vector<std::int32_t> move;  // that has cut what is there in the end; -1: none
  std::vector<double> along;       // mm of path up to that place
  // mm by which the highest cusp beside the middle stands out from both passes; NaN without a cusp
  // there, and where nothing is picked
  std::vector<double> cusp;
};

// picked: for each triangle of the map whether it is to be machined. Throws std::invalid_argument
// for a tool, cells or a path that cannot be, Cancelled where it was stopped.
SurfaceMap map_surface(const HeightMap& part, const std::vector<bool>& picked,
                       const std::vector<Move>& moves, const SurfaceMapParams& params,
                       Progress& progress);

inline constexpr double kMostCells = 6e6;

}  // namespace evenload
