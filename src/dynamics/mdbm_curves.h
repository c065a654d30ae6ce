// The one-dimensional set that a bisection found, as connected curves.
//
// Each cell is cut into simplices, alike in all cells, and the equations are taken as linear in
// each: the set crosses its facets in points that neighbours share, and polylines follow without a
// gap. Closed curves end where they begin.
// Tolerance: the distance from a smooth set falls by 4 with each halving.
#pragma once

#include <vector>

#include "dynamics/mdbm.h"

namespace evenload {

// Polylines, of `axes` numbers for each point. Condition: one equation fewer than axes.
std::vector<std::vector<double>> curves(const Mdbm& mdbm);

}  // namespace evenload
