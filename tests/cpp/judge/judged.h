// Cases of the corpus, cleared and judged.
#pragma once

#include <string>
#include <vector>

#include "judge/corpus.h"
#include "judge/path_check.h"
#include "toolpath/toolpath.h"

namespace evenload::corpus {

Toolpath clear(const Case& pocket, const ClearingParams& params);
// What a path's report says by that code.
std::vector<Finding> findings_of(const Report& report, FindingCode code);
bool tells(const Report& report, FindingCode code);
// With the case's hole, if it has one.
path_check::Findings judge(const Case& pocket, const Toolpath& path,
                           const path_check::Settings& settings = {});

// A pocket as its file says, the path that clears it, and what the judge sees of that path where it
// sees as thin material as the simulator does.
struct Home {
  Case pocket;
  Toolpath path;
  path_check::Findings seen;
};
// Made when first asked for, and kept: however many tests of a process ask, the pocket is cleared
// and judged once.
const Home& at_home(const std::string& name);

// mm^2/min: at the engagement angle and the feed, for one mm of depth.
double nominal_rate(const Case& pocket);
// The most that a path at a constant removal rate may have: 1.05 times the nominal one.
double most_rate(const Case& pocket);

}  // namespace evenload::corpus
