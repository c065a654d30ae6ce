// Cases of the corpus, cleared and judged.
#pragma once

#include "corpus.h"
#include "path_check.h"
#include "toolpath/toolpath.h"

namespace evenload::corpus {

Toolpath clear(const Case& pocket, const ClearingParams& params);
// With the case's hole, if it has one.
path_check::Findings judge(const Case& pocket, const Toolpath& path,
                           const path_check::Settings& settings = {});
// mm^2/min: at the engagement angle and the feed, for one mm of depth.
double nominal_rate(const Case& pocket);
// The most that a path at a constant removal rate may have: 1.05 times the nominal one.
double most_rate(const Case& pocket);

}  // namespace evenload::corpus
