#include "judge/narrow_pockets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace evenload::narrow_pockets {

namespace {

int told(const Toolpath& path, FindingCode code) {
  return static_cast<int>(corpus::findings_of(path.report, code).size());
}

}  // namespace

Case pocket_of(std::vector<Vertex> outer, std::vector<Curve> islands) {
  Case pocket = corpus::load("slot62");
  pocket.region = make_region(Curve(std::move(outer), true), std::move(islands));
  return pocket;
}

Case slot(double width, double angle) {
  const double h = width / 2;
  return corpus::moved(pocket_of({{{-20, -h}}, {{20, -h}}, {{20, h}}, {{-20, h}}}), angle, false,
                       {});
}

Case two_rooms(double width) {
  const double h = width / 2;
  return pocket_of({{{0, -9}},
                    {{20, -9}},
                    {{20, -h}},
                    {{32, -h}},
                    {{32, -9}},
                    {{52, -9}},
                    {{52, 9}},
                    {{32, 9}},
                    {{32, h}},
                    {{20, h}},
                    {{20, 9}},
                    {{0, 9}}});
}

Case ring(double width) {
  const double inner = 20 - width / 2, outer = 20 + width / 2;
  return pocket_of({{{outer, 0}, 1}, {{-outer, 0}, 1}},
                   {Curve({{{inner, 0}, 1}, {{-inner, 0}, 1}}, true)});
}

Case dead_end(double width) {
  return pocket_of({{{0, 0}},
                    {{25, 0}},
                    {{25, 10}},
                    {{45, 10}},
                    {{45, 10 + width}},
                    {{25, 10 + width}},
                    {{25, 25}},
                    {{0, 25}}});
}

Toolpath clear(const Case& pocket, NarrowPassages choice, FeedControl control) {
  ClearingParams params = pocket.params();
  params.narrow_passages = choice;
  params.feed_control = control;
  return corpus::clear(pocket, params);
}

path_check::Findings expect_cleared(const Case& pocket, const Toolpath& path) {
  const path_check::Findings found = corpus::judge(pocket, path);
  EXPECT_EQ(path.report.termination, Termination::kComplete);
  EXPECT_LE(found.gouge, 0.005);
  EXPECT_LE(found.left_share, 0.0005);
  EXPECT_LE(found.link_engagement, 1 * kDegree);
  EXPECT_EQ(found.bad_plunges, 0);
  return found;
}

int entries(const Toolpath& path) {
  int count = 0;
  for (std::size_t i = 1; i < path.moves.size(); ++i)
    count += path.moves[i].kind == MoveKind::kEntry && path.moves[i - 1].kind != MoveKind::kEntry;
  return count;
}

int skipped(const Toolpath& path) {
  return told(path, FindingCode::kPassageSkipped) +
         told(path, FindingCode::kPassageSkippedTooNarrow);
}

int reduced(const Toolpath& path) {
  return told(path, FindingCode::kPassageReduced) +
         told(path, FindingCode::kPassageReducedTooNarrow);
}

Case cross(double width) {
  const double h = width / 2;
  return pocket_of({{{-20, -h}},
                    {{-h, -h}},
                    {{-h, -15}},
                    {{h, -15}},
                    {{h, -h}},
                    {{20, -h}},
                    {{20, h}},
                    {{h, h}},
                    {{h, 15}},
                    {{-h, 15}},
                    {{-h, h}},
                    {{-20, h}}});
}

Case open_slot(double width) {
  return pocket_of({{{0, 0}}, {{40, 0}, 0, true}, {{40, width}}, {{0, width}}});
}

}  // namespace evenload::narrow_pockets
