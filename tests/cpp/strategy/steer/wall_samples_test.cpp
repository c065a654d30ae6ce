#include "strategy/steer/wall_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <vector>

#include "geometry/shapes.h"
#include "judge/numbers.h"

namespace evenload {
namespace {

using shapes::rectangle;

constexpr int kMostPasses = 50;

// The same laws as those of WallSamples, but every question goes through all the samples.
class ScannedWalls {
 public:
  ScannedWalls(const std::vector<Stage>& stages, const ClearedGround& ground)
      : stages_(stages), ground_(ground), radius_(ground.tool_radius()) {
    for (std::size_t k = 0; k < stages.size(); ++k)
      for (std::size_t c = 0; c < stages[k].centres.curves().size(); ++c) add_track(k, c);
    for (Mark& mark : marks_) {
      if (mark.shared || mark.stage == 0) continue;
      for (Mark& earlier : marks_)
        if (!earlier.shared && earlier.stage < mark.stage &&
            distance(mark.p, earlier.p) < radius_) {
          mark.earlier.push_back(earlier.index);
          earlier.corner = true;
        }
    }
  }

  void update(Vec2 low, Vec2 high) {
    const double reach = 2 * radius_;
    for (Mark& mark : marks_)
      if (is_open(mark) && mark.p.x >= low.x - reach && mark.p.x <= high.x + reach &&
          mark.p.y >= low.y - reach && mark.p.y <= high.y + reach)
        look(mark);
  }

  void give_up(std::size_t index) {
    if (++marks_[index].failures < 3) return;
    for (Mark& mark : marks_)
      if (mark.shared && mark.stage == marks_[index].stage + 1 &&
          distance(mark.p, marks_[index].p) < 0.08 * radius_) {
        mark.shared = false;
        look(mark);
      }
  }

  std::vector<PassStart> starts() const {
    const std::vector<PassStart> in_turn = starts(true);
    if (!in_turn.empty()) return in_turn;
    // Stage by stage: those near one of an earlier stage that stays do not.
    std::vector<PassStart> all = starts(false), result;
    for (std::size_t stage = 0; stage < stages_.size(); ++stage)
      std::copy_if(all.begin(), all.end(), std::back_inserter(result), [&](const PassStart& start) {
        return start.stage == stage &&
               std::all_of(result.begin(), result.end(), [&](const PassStart& kept) {
                 return kept.stage == stage || distance(kept.pose.p, start.pose.p) >= radius_;
               });
      });
    return result;
  }

  bool is_clear(std::size_t index) const { return marks_[index].clear; }
  bool is_shared(std::size_t index) const { return marks_[index].shared; }
  std::size_t size() const { return marks_.size(); }
  std::size_t uncleared_count() const {
    return static_cast<std::size_t>(std::count_if(marks_.begin(), marks_.end(), is_open));
  }

 private:
  struct Mark {
    std::size_t index = 0, stage = 0, first = 0;  // first: of its curve
    WallPlace place;
    Vec2 p;
    Vec2 witness;  // held material at the last look
    bool looked_at = false, shared = false, clear = false, corner = false;
    int failures = 0;
    std::vector<std::size_t> earlier;
  };
  static bool is_open(const Mark& mark) { return !mark.clear && !mark.shared; }

  void add_track(std::size_t stage, std::size_t c) {
    const Curve& curve = stages_[stage].centres.curves()[c];
    const std::size_t first = marks_.size();
    for (std::size_t i = 0; i < curve.segment_count(); ++i) {
      const Segment wall = curve.segment(i);
      double n = std::max(1.0, std::ceil(wall.length() / (0.08 * radius_)));
      if (wall.is_arc()) n = std::max(n, std::ceil(std::abs(wall.sweep) / 0.4));
      for (int j = 0; j < n; ++j) {
        Mark mark;
        mark.index = marks_.size();
        mark.stage = stage;
        mark.first = first;
        mark.place = {c, i, j / n};
        mark.p = wall.point(mark.place.t);
        mark.shared = stage > 0 && stages_[stage - 1].centres.nearest(mark.p).distance < 1e-4;
        marks_.push_back(mark);
      }
    }
    counts_.resize(marks_.size(), marks_.size() - first);
    // Where a stretch of its own ends the first mark behind it is the stage's own, too.
    const std::vector<Mark> before(marks_.begin() + static_cast<std::ptrdiff_t>(first),
                                   marks_.end());
    for (std::size_t i = 0; i < before.size(); ++i)
      if (!before[(i + before.size() - 1) % before.size()].shared) marks_[first + i].shared = false;
  }

  void look(Mark& mark) {
    if (mark.looked_at && !ground_.is_cleared_since(mark.witness, 0)) return;
    mark.failures = 0;
    std::vector<AngularInterval> left;
    ground_.uncovered(mark.p, 0, 2 * kPi, left);
    mark.clear = left.empty();
    if (mark.clear) return;
    const AngularInterval widest = *std::max_element(
        left.begin(), left.end(), [](auto a, auto b) { return a.width() < b.width(); });
    mark.witness = mark.p + (radius_ - kCoverTolerance) * unit(0.5 * (widest.low + widest.high));
    mark.looked_at = true;
  }

  const Mark* last_clear_before(const Mark& mark) const {
    const std::size_t count = counts_[mark.index];
    for (std::size_t back = 1; back <= std::min<std::size_t>(8, count - 1); ++back) {
      const Mark& before = marks_[mark.first + (mark.index - mark.first + count - back) % count];
      if (before.clear || (before.shared && ground_.is_clear(before.p))) return &before;
      if (!before.shared) return nullptr;
    }
    return nullptr;
  }

  std::vector<PassStart> starts(bool in_turn) const {
    std::vector<PassStart> found;
    for (const Mark& mark : marks_) {
      if (!is_open(mark) || mark.failures >= 3) continue;
      const bool waits =
          std::any_of(mark.earlier.begin(), mark.earlier.end(),
                      [this](std::size_t i) { return !marks_[i].clear && marks_[i].failures < 3; });
      if (in_turn && waits) continue;
      const Mark* before = last_clear_before(mark);
      if (!before) continue;
      const Segment wall =
          stages_[mark.stage].centres.curves()[before->place.curve].segment(before->place.segment);
      found.push_back({mark.stage,
                       before->place,
                       {before->p, angle_of(wall.tangent(before->place.t))},
                       mark.index,
                       mark.corner});
    }
    return found;
  }

  const std::vector<Stage>& stages_;
  const ClearedGround& ground_;
  double radius_;
  std::vector<Mark> marks_;
  std::vector<std::size_t> counts_;  // by mark: how many its curve has
};

void expect_same(WallSamples& samples, const ScannedWalls& scanned) {
  ASSERT_EQ(samples.uncleared_count(), scanned.uncleared_count());
  for (std::size_t i = 0; i < scanned.size(); ++i)
    if (!scanned.is_shared(i)) {  // those are looked at where a start needs them
      ASSERT_EQ(samples.is_clear(i), scanned.is_clear(i)) << "sample " << i;
    }
  const std::vector<PassStart> found = samples.starts(), expected = scanned.starts();
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i].sample, expected[i].sample) << "start " << i;
    ASSERT_EQ(found[i].stage, expected[i].stage);
    ASSERT_EQ(found[i].corner, expected[i].corner);
    ASSERT_EQ(found[i].place.curve, expected[i].place.curve);
    ASSERT_EQ(found[i].place.segment, expected[i].place.segment);
    ASSERT_EQ(found[i].place.t, expected[i].place.t);
    ASSERT_EQ(found[i].pose.p.x, expected[i].pose.p.x);
    ASSERT_EQ(found[i].pose.p.y, expected[i].pose.p.y);
    ASSERT_EQ(found[i].pose.heading, expected[i].pose.heading);
  }
}

// What a history has come to; a test that meets none of these tests nothing.
struct Met {
  int starts = 0, given_up = 0, taken_over = 0, offered_again = 0;
};

// Moves and failed starts by chance, mostly where starts are, as a clearing has them.
class History {
 public:
  History(const Region& centres, unsigned seed)
      : random_(seed),
        stages_(make_stages(centres, {0.9, 0.03})),
        bounds_(bounds_of({centres})),
        ground_(bounds_, kRadius, nullptr),
        samples_(stages_, ground_, kMostPasses),
        scanned_(stages_, ground_) {}

  void run(int steps, Met& met) {
    for (int step = 0; step < steps && !::testing::Test::HasFatalFailure(); ++step) {
      SCOPED_TRACE(step);
      const std::vector<PassStart> starts = scanned_.starts();
      met.starts += starts.empty() ? 0 : 1;
      if (starts.empty() || chance(4)) {
        cut(somewhere(), somewhere());
      } else if (chance(4)) {
        cut_along_a_wall();
      } else {
        const PassStart& start = starts[random_() % starts.size()];
        if (chance(3))
          fail(start.sample, met);
        else
          cut(start.pose.p, start.pose.p + length() * unit(start.pose.heading + 0.2 * length()));
      }
      expect_same(samples_, scanned_);
      for (const std::size_t sample : failed_)
        for (const PassStart& start : scanned_.starts())
          met.offered_again += start.sample == sample;
    }
  }

 private:
  bool chance(unsigned of) { return random_() % of == 0; }
  double length() { return 0.01 * static_cast<double>(random_() % 600); }
  Vec2 somewhere() {
    const auto share = [this] { return 0.001 * static_cast<double>(random_() % 1001); };
    const Vec2 size = bounds_.high - bounds_.low;
    return bounds_.low + Vec2{share() * size.x, share() * size.y};
  }

  void cut(Vec2 from, Vec2 to) {
    ground_.add(Segment::line(from, to));
    const Vec2 low{std::min(from.x, to.x), std::min(from.y, to.y)};
    const Vec2 high{std::max(from.x, to.x), std::max(from.y, to.y)};
    samples_.update(low, high);
    scanned_.update(low, high);
  }

  void cut_along_a_wall() {
    const Stage& stage = stages_[random_() % stages_.size()];
    const Curve& wall = stage.centres.curves()[random_() % stage.centres.curves().size()];
    const std::size_t first = random_() % wall.segment_count();
    for (std::size_t i = 0; i < 1 + random_() % 8; ++i) {
      const Segment piece = wall.segment((first + i) % wall.segment_count());
      ground_.add(piece);
      const Bounds box = piece.bounds();
      samples_.update(box.low, box.high);
      scanned_.update(box.low, box.high);
    }
  }

  void fail(std::size_t sample, Met& met) {
    std::vector<bool> shared(scanned_.size());
    for (std::size_t i = 0; i < shared.size(); ++i) shared[i] = scanned_.is_shared(i);
    for (int i = 0; i < 3; ++i) {
      samples_.give_up(sample);
      scanned_.give_up(sample);
    }
    failed_.push_back(sample);
    ++met.given_up;
    for (std::size_t i = 0; i < shared.size(); ++i)
      met.taken_over += shared[i] && !scanned_.is_shared(i);
  }

  std::mt19937 random_;
  std::vector<Stage> stages_;
  Bounds bounds_;
  ClearedGround ground_;
  WallSamples samples_;
  ScannedWalls scanned_;
  std::vector<std::size_t> failed_;
};

TEST(WallSamples, AreAsAFullScanWouldFindThemAfterAnyHistory) {
  Met met;
  unsigned seed = 0;
  for (const shapes::Named& shape : shapes::random_regions(11, 16)) {
    SCOPED_TRACE(shape.name);
    History(shape.region, ++seed).run(40, met);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(met.starts, 300);
  EXPECT_GT(met.given_up, 50);
  EXPECT_GT(met.taken_over, 50);
  EXPECT_GT(met.offered_again, 0);
}

// The left 20 mm of a channel of 60 mm, cleared up to a straight front.
class ChannelWalls : public ::testing::Test {
 protected:
  void clear_the_left() {
    for (const double y : {0.0, 2.0, 4.0}) ground_.add(Segment::line({-10, y}, {20, y}));
    samples_.update({-10, 0}, {20, 4});
  }

  bool is_offered(std::size_t sample) {
    const std::vector<PassStart> starts = samples_.starts();
    return std::any_of(starts.begin(), starts.end(),
                       [&](const PassStart& start) { return start.sample == sample; });
  }

  // Small holes along the front side of the tool's circle there, until one takes what was seen.
  bool is_offered_after_holes_before(const PassStart& start) {
    for (double angle = -kPi / 2; angle < kPi / 2; angle += 0.1) {
      const Vec2 hole = start.pose.p + Vec2{0.08 * kRadius, 0} + kRadius * unit(angle);
      ground_.add_disc(hole, 0.2);
      samples_.update(hole, hole);
      if (is_offered(start.sample)) return true;
    }
    return false;
  }

  const std::vector<Stage> stages_ = make_stages(make_region(rectangle(0, 0, 60, 4)), {});
  ClearedGround ground_{{{-10, 0}, {60, 4}}, kRadius, nullptr};
  WallSamples samples_{stages_, ground_, kMostPasses};
};

TEST_F(ChannelWalls, OfferAStartWhereTheClearedPartOfAWallEnds) {
  const std::size_t all = samples_.uncleared_count();
  EXPECT_TRUE(samples_.starts().empty());
  clear_the_left();
  EXPECT_LT(samples_.uncleared_count(), all);
  const std::vector<PassStart> starts = samples_.starts();
  // The other wall leads out of the material.
  ASSERT_EQ(starts.size(), 1);
  EXPECT_NEAR(starts[0].pose.p.x, 20, 0.08 * kRadius);
  EXPECT_NEAR(starts[0].pose.p.y, 0, 1e-9);
  EXPECT_NEAR(starts[0].pose.heading, 0, 1e-9);
  EXPECT_FALSE(samples_.is_clear(starts[0].sample));
}

TEST_F(ChannelWalls, OfferAStartThatCameToNothingAgainOnceItsSurroundingsHaveChanged) {
  clear_the_left();
  const PassStart start = samples_.starts().front();
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(is_offered(start.sample)) << "after " << i << " attempts";
    samples_.give_up(start.sample);
  }
  EXPECT_FALSE(is_offered(start.sample));
  EXPECT_TRUE(is_offered_after_holes_before(start));
}

TEST_F(ChannelWalls, OfferNoStartForEverThatStaysWhateverPassesComeToSomething) {
  clear_the_left();
  const PassStart start = samples_.starts().front();
  for (int i = 1; i < kMostPasses; ++i) samples_.note_pass(start.sample);
  EXPECT_TRUE(is_offered(start.sample));
  samples_.note_pass(start.sample);
  EXPECT_FALSE(is_offered(start.sample));
  EXPECT_FALSE(is_offered_after_holes_before(start));
}

}  // namespace
}  // namespace evenload
