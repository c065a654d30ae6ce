// From a record of loads to its figures.
#pragma once

#include "simulate/load_record.h"

namespace evenload {

// Lengths, times and the worst means over kLoadWindow of path.
void add_up_record(const LoadRecord& record, LoadFigures& figures);

}  // namespace evenload
