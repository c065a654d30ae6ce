#include "strategy/choose/leftover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "geometry/shapes.h"
#include "judge/numbers.h"

namespace evenload {
namespace {

using shapes::rectangle;

const Bounds kEverywhere{{0, 0}, {60, 30}};

// A floor of 60 mm x 30 mm, cleared but for two squares of 2 mm.
class TwoPosts : public ::testing::Test {
 protected:
  TwoPosts() {
    for (const double y : {3.0, 6.0, 9.0, 11.0, 19.0, 21.0, 24.0, 27.0}) clear({3, y}, {57, y});
    for (const double x : {3.0, 57.0}) clear({x, 3}, {x, 27});
    for (const double y : {13.0, 15.0, 17.0}) {
      clear({3, y}, {6, y});
      clear({14, y}, {46, y});
      clear({54, y}, {57, y});
    }
    leftover_.prepare(centres_, kEverywhere, ground_);
  }

  void clear(Vec2 from, Vec2 to) { ground_.add(Segment::line(from, to)); }

  // The post that the pose touches: its circle meets material when the tool moves a little towards
  // it, and none before.
  Vec2 post_beside(const Pose& pose) const {
    EXPECT_TRUE(ground_.is_clear(pose.p));
    EXPECT_GE(centres_.signed_distance(pose.p), -1e-9);
    const Vec2 right = -left_normal(unit(pose.heading));
    EXPECT_FALSE(ground_.is_clear(pose.p + 0.05 * right));
    const Vec2 post = pose.p.x < 30 ? left_ : right_;
    EXPECT_LT(distance(pose.p + kRadius * right, post), 3);
    return post;
  }

  const Vec2 left_{10, 15}, right_{50, 15};
  const Area centres_{{make_region(rectangle(3, 3, 57, 27))}};
  ClearedGround ground_{kEverywhere, kRadius, nullptr};
  Leftover leftover_;
};

TEST_F(TwoPosts, AreMeasuredAndNamed) {
  // By points 0.2 mm apart.
  EXPECT_NEAR(leftover_.area(ground_), 8, 1.6);
  ASSERT_TRUE(leftover_.place());
  EXPECT_FALSE(ground_.is_cleared_point(*leftover_.place()));
}

TEST_F(TwoPosts, AreOfferedNearestFirstAndEachPlaceFromEverySide) {
  const std::optional<Pose> first = leftover_.next_start(ground_, centres_, {55, 15});
  ASSERT_TRUE(first);
  EXPECT_EQ(post_beside(*first), right_);
  // What came to nothing from one side may do from another.
  const std::optional<Pose> second = leftover_.next_start(ground_, centres_, {5, 15});
  ASSERT_TRUE(second);
  EXPECT_EQ(post_beside(*second), right_);
  EXPECT_GT(std::abs(wrap_signed(second->heading - first->heading)), kPi / 4);
  int left = 0, more = 0;
  while (const std::optional<Pose> pose = leftover_.next_start(ground_, centres_, {5, 15})) {
    left += post_beside(*pose) == left_;
    ASSERT_LT(++more, 60);
  }
  EXPECT_GE(left, 6);
}

TEST_F(TwoPosts, AreNotOfferedAfterTheyWereCut) {
  clear({45, 15}, {55, 15});
  const std::optional<Pose> pose = leftover_.next_start(ground_, centres_, {55, 15});
  ASSERT_TRUE(pose);
  EXPECT_EQ(post_beside(*pose), left_);
  clear({5, 15}, {15, 15});
  EXPECT_FALSE(leftover_.next_start(ground_, centres_, {55, 15}));
  EXPECT_EQ(leftover_.area(ground_), 0);
  EXPECT_FALSE(leftover_.place());
}

TEST_F(TwoPosts, AreOfferedAgainWhereTheyAreStillLeft) {
  while (leftover_.next_start(ground_, centres_, {30, 15})) {
  }
  clear({45, 15}, {55, 15});
  EXPECT_TRUE(leftover_.ask_again(ground_));
  const std::optional<Pose> pose = leftover_.next_start(ground_, centres_, {55, 15});
  ASSERT_TRUE(pose);
  EXPECT_EQ(post_beside(*pose), left_);
}

TEST_F(TwoPosts, AreNotOfferedForEverWhereNothingOfThemIsCleared) {
  clear({45, 15}, {55, 15});
  EXPECT_TRUE(leftover_.ask_again(ground_));
  for (int i = 0; i < Leftover::kMostInVain; ++i) EXPECT_TRUE(leftover_.ask_again(ground_));
  while (leftover_.next_start(ground_, centres_, {30, 15})) {
  }
  EXPECT_FALSE(leftover_.ask_again(ground_));
  EXPECT_FALSE(leftover_.next_start(ground_, centres_, {30, 15}));
  clear({5, 14.5}, {8, 14.5});  // a part of the other post
  EXPECT_TRUE(leftover_.ask_again(ground_));
}

// Between two passes, and between the points of the coarse grid, whatever its place.
TEST(Leftover, FindsSlivers) {
  for (const double width : {0.1, 0.06})
    for (int i = 0; i < 20; ++i) {
      SCOPED_TRACE(i);
      const double middle = 15 + 0.2 * i / 20;
      ClearedGround ground(kEverywhere, kRadius, nullptr);
      for (const double x : {3.0, 20.0}) ground.add(Segment::line({x, 3}, {x, 27}));
      for (double y = 3; y <= 27; y += 0.5)
        if (std::abs(y - middle) > kRadius + 0.5) ground.add(Segment::line({3, y}, {20, y}));
      for (const double side : {-1.0, 1.0}) {
        const double y = middle + side * (kRadius + 0.5 * width);
        ground.add(Segment::line({3, y}, {20, y}));
      }
      const Area centres({make_region(rectangle(3, 3, 20, 27))});
      Leftover leftover;
      leftover.prepare(centres, {{0, 0}, {23, 30}}, ground);
      // Of the strip 11 mm are beyond the passes along the walls. By squares of 0.2 mm and less.
      EXPECT_GT(leftover.area(ground), 0.4 * 11 * width);
      EXPECT_LT(leftover.area(ground), 11 * (width + 0.2));
      const std::optional<Pose> start = leftover.next_start(ground, centres, {10, 10});
      ASSERT_TRUE(start);
      EXPECT_LT(std::abs(std::abs(start->p.y - middle) - kRadius), width);
    }
}

TEST(Leftover, IsNothingWhereAllIsCleared) {
  ClearedGround ground(kEverywhere, kRadius, nullptr);
  for (double y = 3; y <= 27; y += 1.5) ground.add(Segment::line({3, y}, {57, y}));
  ground.add(Segment::line({3, 3}, {3, 27}));
  ground.add(Segment::line({57, 3}, {57, 27}));
  Leftover leftover;
  leftover.prepare(Area({make_region(rectangle(3, 3, 57, 27))}), kEverywhere, ground);
  EXPECT_EQ(leftover.area(ground), 0);
}

}  // namespace
}  // namespace evenload
