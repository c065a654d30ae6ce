#include "strategy/choose/made_passes.h"

#include <gtest/gtest.h>

namespace evenload {
namespace {

Pass pass_to(Vec2 end, double area) {
  Pass pass;
  pass.moves = {Segment::line({0, 0}, {1, 0}), Segment::line({1, 0}, end)};
  pass.cut_area = area;
  return pass;
}

TEST(MadePasses, HoldThoseThatWereAddedAndNoOthers) {
  MadePasses made;
  EXPECT_FALSE(made.contains(pass_to({2, 1}, 0.3)));
  made.add(pass_to({2, 1}, 0.3));
  EXPECT_TRUE(made.contains(pass_to({2, 1}, 0.3)));
  EXPECT_TRUE(made.contains(pass_to({2, 1 + 1e-9}, 0.3 - 1e-9)));
  EXPECT_FALSE(made.contains(pass_to({2, 1.0001}, 0.3)));
  EXPECT_FALSE(made.contains(pass_to({2, 1}, 0.2999)));
  Pass detour = pass_to({2, 1}, 0.3);
  detour.moves[0] = Segment::line({0, 0}, {1, 0.1});
  detour.moves[1] = Segment::line({1, 0.1}, {2, 1});
  EXPECT_FALSE(made.contains(detour));  // of another length
}

}  // namespace
}  // namespace evenload
