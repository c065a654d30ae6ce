#include "feed/feed_control.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "feed/load_profile.h"
#include "judge/numbers.h"

namespace evenload {
namespace {

// A few tangent moves, cuts and links.
std::vector<PlanarRun> random_runs(std::mt19937& random) {
  std::vector<PlanarRun> runs;
  for (int r = 0; r < 2; ++r) {
    PlanarRun run;
    Vec2 p{uniform(random, -10, 10), uniform(random, -10, 10)};
    run.descent.at = p;
    double heading = uniform(random, -kPi, kPi);
    for (int i = 0; i < 25; ++i) {
      const MoveKind kind = random() % 5 ? MoveKind::kCut : MoveKind::kLink;
      if (random() % 2) {
        run.moves.push_back({kind, Segment::line(p, p + uniform(random, 0.05, 6) * unit(heading))});
      } else {
        const double side = random() % 2 ? 1 : -1, radius = uniform(random, 0.2, 8);
        const double sweep = uniform(random, 0.02, 2);
        run.moves.push_back({kind, Segment::arc(p + side * radius * left_normal(unit(heading)),
                                                radius, heading - side * kPi / 2, side * sweep)});
        heading += side * sweep;
      }
      p = run.moves.back().segment.b;
    }
    runs.push_back(run);
  }
  return runs;
}

// Loads that wander, in pieces of about half a millimetre.
std::vector<LoadSample> random_profile(std::mt19937& random, const std::vector<PlanarRun>& runs) {
  std::vector<LoadSample> profile;
  double share = 1;
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (std::size_t m = 0; m < runs[r].moves.size(); ++m) {
      const double length = runs[r].moves[m].segment.length();
      const int n = runs[r].moves[m].kind == MoveKind::kCut
                        ? std::max(1, static_cast<int>(length / uniform(random, 0.05, 0.6)))
                        : 1;
      for (int i = 0; i < n; ++i) {
        share = std::clamp(share + uniform(random, -0.4, 0.4), 0.0, 2.0);
        if (random() % 40 == 0) share = 0;
        LoadSample sample{r, m, (i + 0.5) / n, length / n, 0, 0, 0, 0};
        sample.share = share;
        profile.push_back(sample);
      }
    }
  return profile;
}

TEST(FeedControl, GivesEveryCutTheFeedAndEveryLinkItsOwnWhenConstant) {
  std::mt19937 random(1);
  std::vector<PlanarRun> runs = random_runs(random);
  set_constant_feed(runs, {});
  for (const PlanarRun& run : runs)
    for (const PlanarMove& move : run.moves)
      EXPECT_EQ(move.feed, move.kind == MoveKind::kLink ? 1500 : 255);
}

TEST(FeedControl, NeverExceedsTheLoadAndCoversEveryMoveExactly) {
  std::mt19937 random(2);
  for (int round = 0; round < 30; ++round) {
    const std::vector<PlanarRun> before = random_runs(random);
    const std::vector<LoadSample> profile = random_profile(random, before);
    std::vector<PlanarRun> after = before;
    const FeedParams params;
    const std::vector<double> feeds = set_constant_load(after, profile, params);
    ASSERT_EQ(feeds.size(), profile.size());
    ASSERT_EQ(after.size(), before.size());
    std::size_t sample = 0;
    for (std::size_t r = 0; r < before.size(); ++r) {
      EXPECT_EQ(after[r].descent.at, before[r].descent.at);
      std::size_t k = 0;
      for (std::size_t m = 0; m < before[r].moves.size(); ++m) {
        const PlanarMove& whole = before[r].moves[m];
        // The pieces of this move, one after the other.
        double done = 0;
        Vec2 at = whole.segment.a;
        while (done < whole.segment.length() - 1e-6) {
          ASSERT_LT(k, after[r].moves.size());
          const PlanarMove& piece = after[r].moves[k++];
          ASSERT_EQ(piece.kind, whole.kind);
          EXPECT_LE(distance(piece.segment.a, at), 1e-7);
          EXPECT_LE(whole.segment.distance_to(piece.segment.point(0.5)), 1e-7);
          EXPECT_GT(piece.segment.length(), 0);
          if (whole.kind == MoveKind::kLink) {
            EXPECT_EQ(piece.feed, params.link_feed);
          } else {
            EXPECT_LE(piece.feed, params.maximum_feed);
            EXPECT_GT(piece.feed, 0);
          }
          const double until = done + piece.segment.length();
          for (; sample < profile.size() && profile[sample].run == r && profile[sample].move == m &&
                 profile[sample].t * whole.segment.length() < until;
               ++sample)
            if (whole.kind == MoveKind::kCut) {
              EXPECT_LE(piece.feed * profile[sample].share, params.feed * (1 + 1e-12));
              EXPECT_EQ(piece.feed, feeds[sample]);
            }
          done = until;
          at = piece.segment.b;
        }
        EXPECT_NEAR(done, whole.segment.length(), 1e-6);
        EXPECT_LE(distance(at, whole.segment.b), 1e-7);
      }
      EXPECT_EQ(k, after[r].moves.size());
    }
    EXPECT_EQ(sample, profile.size());
  }
}

// mm, share times feed: of the cuts one after the other, from link to link.
struct LoadedWay {
  std::vector<double> until{0}, load;

  // The mean over `length` mm; nothing is met beyond the ends.
  double mean(double from, double length) const {
    double sum = 0;
    for (std::size_t i = 0; i < load.size(); ++i)
      sum +=
          load[i] * std::max(0.0, std::min(until[i + 1], from + length) - std::max(until[i], from));
    return sum / length;
  }
};

std::vector<LoadedWay> loaded_ways(const std::vector<PlanarRun>& runs,
                                   const std::vector<LoadSample>& profile,
                                   const std::vector<double>& feeds) {
  std::vector<LoadedWay> ways(1);
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const LoadSample& sample = profile[i];
    const bool is_cut = runs[sample.run].moves[sample.move].kind == MoveKind::kCut;
    if (!is_cut || (i > 0 && profile[i - 1].run != sample.run)) ways.emplace_back();
    if (!is_cut) continue;
    ways.back().until.push_back(ways.back().until.back() + sample.length);
    ways.back().load.push_back(sample.share * feeds[i]);
  }
  return ways;
}

TEST(FeedControl, HoldsNoMeanAboveTheLoadWhereOnlyMeansCount) {
  std::mt19937 random(12);
  for (const double length : {0.1, 0.35, 1.0}) {
    double worst = 0;
    for (int round = 0; round < 10; ++round) {
      const std::vector<PlanarRun> before = random_runs(random);
      const std::vector<LoadSample> profile = random_profile(random, before);
      std::vector<PlanarRun> after = before;
      FeedParams params;
      params.steps = {0.002, 0.1, std::numeric_limits<double>::infinity()};
      params.mean_length = length;
      const std::vector<double> feeds = set_constant_load(after, profile, params);
      for (const LoadedWay& way : loaded_ways(before, profile, feeds))
        for (double from = -length; from < way.until.back(); from += 0.03)
          worst = std::max(worst, way.mean(from, length) / params.feed);
    }
    EXPECT_LE(worst, 1 + 1e-6) << length;
    EXPECT_GT(worst, 0.99) << length;
  }
}

TEST(FeedControl, HoldsNoSampleFarAboveTheLoadWhereMeansCount) {
  std::mt19937 random(14);
  double worst = 0;
  for (int round = 0; round < 10; ++round) {
    std::vector<PlanarRun> runs = random_runs(random);
    const std::vector<LoadSample> profile = random_profile(random, runs);
    FeedParams params;
    params.mean_length = 1;
    const std::vector<double> feeds = set_constant_load(runs, profile, params);
    for (std::size_t i = 0; i < profile.size(); ++i)
      if (feeds[i] != params.link_feed)
        worst = std::max(worst, profile[i].share * feeds[i] / params.feed);
  }
  EXPECT_LE(worst, FeedSteps().most_peak + 1e-9);
  EXPECT_GT(worst, FeedSteps().most_peak - 0.01);
}

double seconds(const std::vector<PlanarRun>& runs) {
  double time = 0;
  for (const PlanarRun& run : runs)
    for (const PlanarMove& move : run.moves) time += move.segment.length() / move.feed * 60;
  return time;
}

TEST(FeedControl, IsFasterWhereOnlyMeansCount) {
  // Grains harder and softer, four in a tenth of a millimetre.
  std::vector<LoadSample> profile;
  for (int i = 0; i < 40; ++i)
    profile.push_back({0, 0, (i + 0.5) / 40, 0.025, 0, 0, 0, i % 2 ? 1.0 : 0.8});
  FeedParams params;
  PlanarRun run;
  run.moves = {{MoveKind::kCut, Segment::line({0, 0}, {1, 0})}};
  std::vector<PlanarRun> peaks = {run}, means = {run};
  set_constant_load(peaks, profile, params);
  params.mean_length = 0.1;
  set_constant_load(means, profile, params);
  EXPECT_NEAR(seconds(means), 0.9 * seconds(peaks), 1e-6);
}

TEST(FeedControl, HoldsEverySampleWhereTheLoadJumps) {
  // The end of a bit in a corner, so short that its mean would allow the highest feed.
  std::vector<PlanarRun> runs(1);
  runs[0].moves.push_back({MoveKind::kCut, Segment::line({0, 0}, {0.23, 0})});
  runs[0].moves.push_back({MoveKind::kCut, Segment::line({0.23, 0}, {0.23, 0.4})});
  std::vector<LoadSample> profile;
  for (int i = 0; i < 23; ++i) {
    LoadSample sample{0, 0, (i + 0.5) / 23, 0.01, 0, 0, 0, 0};
    sample.share = i < 22 ? 0 : 2;
    profile.push_back(sample);
  }
  profile.push_back({0, 1, 0.5, 0.4, 0, 0, 0, 0});
  FeedParams params;
  params.maximum_feed = 1000;
  params.mean_length = 0.1;
  const std::vector<double> feeds = set_constant_load(runs, profile, params);
  EXPECT_LE(feeds[22], params.feed / 2);
  EXPECT_EQ(feeds.back(), params.maximum_feed);
}

TEST(FeedControl, IsNoSlowerByMeansThanWithEverySampleHeld) {
  // A change of feed where a move ends has a price of half a millisecond.
  constexpr double kPricePerMove = 0.0005;
  std::mt19937 random(13);
  for (const double length : {0.1, 0.35})
    for (int round = 0; round < 10; ++round) {
      const std::vector<PlanarRun> runs = random_runs(random);
      const std::vector<LoadSample> profile = random_profile(random, runs);
      FeedParams params;
      std::vector<PlanarRun> peaks = runs, means = runs;
      set_constant_load(peaks, profile, params);
      params.mean_length = length;
      set_constant_load(means, profile, params);
      const auto blocks = [](const std::vector<PlanarRun>& counted) {
        return static_cast<double>(counted[0].moves.size() + counted[1].moves.size());
      };
      EXPECT_LT(seconds(means) + params.steps.price * blocks(means),
                seconds(peaks) + params.steps.price * blocks(peaks) + 50 * kPricePerMove);
    }
}

TEST(FeedControl, IsTheFasterTheFinerItsSteps) {
  std::mt19937 random(7);
  double coarse_time = 0, fine_time = 0;
  for (int round = 0; round < 10; ++round) {
    const std::vector<PlanarRun> runs = random_runs(random);
    const std::vector<LoadSample> profile = random_profile(random, runs);
    FeedParams params;
    const auto time_with = [&](const FeedSteps& steps) {
      std::vector<PlanarRun> timed = runs;
      params.steps = steps;
      set_constant_load(timed, profile, params);
      return seconds(timed);
    };
    coarse_time += time_with({0.043, 0.2});
    fine_time += time_with({0.002, 0.1});
  }
  EXPECT_LT(fine_time, 0.99 * coarse_time);
}

// s: the least that the moves of one cut, lines, can take, with the prices of changes of feed; by
// trying all that a piece of one feed may be.
double least_cost(const std::vector<LoadSample>& samples, const FeedParams& params) {
  constexpr double kPricePerMove = 0.0005, kShortestPart = 0.1;
  const std::size_t n = samples.size();
  const auto ends = [&](std::size_t i) {
    return i == 0 || i == n || samples[i].move != samples[i - 1].move;
  };
  const auto may_change = [&](std::size_t i) {
    if (ends(i)) return true;
    double before = 0, after = 0;
    for (std::size_t k = i; k-- > 0 && samples[k].move == samples[i].move;)
      before += samples[k].length;
    for (std::size_t k = i; k < n && samples[k].move == samples[i].move; ++k)
      after += samples[k].length;
    return std::min(before, after) >= kShortestPart;
  };
  std::vector<double> cost(n + 1, 1e9);
  cost[0] = 0;
  for (std::size_t to = 1; to <= n; ++to) {
    if (!may_change(to)) continue;
    double share = 0, length = 0;
    for (std::size_t from = to; from-- > 0;) {
      share = std::max(share, samples[from].share);
      length += samples[from].length;
      if (length < params.steps.shortest && !(ends(from) && ends(to))) continue;
      cost[to] = std::min(cost[to], cost[from] + length / allowed_feed(share, params) * 60 +
                                        (ends(to) ? kPricePerMove : params.steps.price));
    }
  }
  return cost[n];
}

TEST(FeedControl, DividesMovesSoThatTimeAndBlocksTogetherAreLeast) {
  constexpr double kPricePerMove = 0.0005;
  std::mt19937 random(29);
  int divided = 0;
  for (int round = 0; round < 1500; ++round) {
    // One cut, straight on, in moves of any length, or most of them below what a piece may be; the
    // load climbs, stays and falls.
    const bool has_tiny = round % 10 > 0;
    std::vector<PlanarRun> runs(1);
    std::vector<LoadSample> profile;
    double x = 0, share = 0.2;
    for (std::size_t m = 0; m < (has_tiny ? 30U : 6U); ++m) {
      const bool is_tiny = has_tiny && random() % 10 > 0;
      const double length =
          is_tiny ? uniform(random, 0.005, 0.02) : uniform(random, 0.2, has_tiny ? 1 : 4);
      const double slope = uniform(random, -1, 1) / std::min(1.0, length);
      const bool is_even = random() % 3 == 0;
      const int count = 1 + static_cast<int>(length / uniform(random, 0.02, 0.1));
      runs[0].moves.push_back({MoveKind::kCut, Segment::line({x, 0}, {x + length, 0})});
      x += length;
      for (int i = 0; i < count; ++i) {
        if (!is_even) share = std::clamp(share + slope * length / count, 0.05, 1.1);
        LoadSample sample{0, m, (i + 0.5) / count, length / count, 0, 0, 0, 0};
        sample.share = share;
        profile.push_back(sample);
      }
    }
    const FeedParams params;
    const double least = least_cost(profile, params);
    const std::vector<double> feeds = set_constant_load(runs, profile, params);
    double cost = kPricePerMove;
    for (std::size_t i = 0; i < feeds.size(); ++i) {
      cost += profile[i].length / feeds[i] * 60;
      if (i + 1 == feeds.size() || std::abs(feeds[i + 1] - feeds[i]) < 1e-9 * feeds[i]) continue;
      const bool is_within = profile[i].move == profile[i + 1].move;
      cost += is_within ? params.steps.price : kPricePerMove;
      divided += is_within;
    }
    EXPECT_LE(cost, least + 1e-6) << round;
  }
  EXPECT_GT(divided, 100);
}

TEST(FeedControl, IsNoSlowerThanOneFeedForEachMove) {
  // A change of feed where a move ends has a price of half a millisecond.
  constexpr double kPricePerMove = 0.0005;
  std::mt19937 random(3);
  for (int round = 0; round < 10; ++round) {
    std::vector<PlanarRun> runs = random_runs(random);
    const std::vector<LoadSample> profile = random_profile(random, runs);
    const FeedParams params;
    double worst_share_time = 0;
    for (std::size_t r = 0; r < runs.size(); ++r)
      for (std::size_t m = 0; m < runs[r].moves.size(); ++m) {
        const PlanarMove& move = runs[r].moves[m];
        double share = 1e-9;
        for (const LoadSample& sample : profile)
          if (sample.run == r && sample.move == m) share = std::max(share, sample.share);
        const double feed = move.kind == MoveKind::kLink
                                ? params.link_feed
                                : std::min(params.maximum_feed, params.feed / share);
        worst_share_time += move.segment.length() / feed * 60 + kPricePerMove;
      }
    set_constant_load(runs, profile, params);
    EXPECT_LE(seconds(runs), worst_share_time);
  }
}

// Of the length that is cut below the maximum feed, how much has at least this share of the nominal
// load.
double evenly_loaded(const std::vector<LoadSample>& profile, const std::vector<PlanarRun>& runs,
                     const std::vector<double>& feeds, const FeedParams& params, double share) {
  double whole = 0, even = 0;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const LoadSample& sample = profile[i];
    if (runs[sample.run].moves[sample.move].kind != MoveKind::kCut) continue;
    if (feeds[i] >= params.maximum_feed * (1 - 1e-9)) continue;
    whole += sample.length;
    if (sample.share * feeds[i] >= share * params.feed * (1 - 1e-9)) even += sample.length;
  }
  return even / whole;
}

TEST(FeedControl, HoldsALeastLoadWhereverMovesCanBeDivided) {
  std::mt19937 random(11);
  for (int round = 0; round < 10; ++round) {
    const std::vector<PlanarRun> before = random_runs(random);
    const std::vector<LoadSample> profile = random_profile(random, before);
    FeedParams params;
    std::vector<PlanarRun> coarse = before;
    const double usual =
        evenly_loaded(profile, before, set_constant_load(coarse, profile, params), params, 0.9);
    const auto pieces = [](const std::vector<PlanarRun>& runs) {
      std::size_t count = 0;
      for (const PlanarRun& run : runs) count += run.moves.size();
      return count;
    };
    std::size_t fewest = pieces(coarse);
    double slowest = seconds(coarse);
    for (const double least : {0.5, 0.7, 0.9}) {
      params.least_load = least;
      std::vector<PlanarRun> runs = before;
      const std::vector<double> feeds = set_constant_load(runs, profile, params);
      EXPECT_GE(evenly_loaded(profile, before, feeds, params, least), 0.97) << least;
      EXPECT_GE(pieces(runs), fewest);
      EXPECT_LE(seconds(runs), slowest * 1.001);
      fewest = pieces(runs);
      slowest = seconds(runs);
    }
    EXPECT_LT(usual, 0.95);
  }
}

TEST(FeedControl, SplitsNoTinyPieceOffAMove) {
  std::mt19937 random(4);
  int split = 0;
  for (int round = 0; round < 30; ++round) {
    const std::vector<PlanarRun> before = random_runs(random);
    std::vector<PlanarRun> after = before;
    set_constant_load(after, random_profile(random, before), {});
    for (std::size_t r = 0; r < before.size(); ++r) {
      std::size_t k = 0;
      for (const PlanarMove& whole : before[r].moves) {
        std::size_t pieces = 0;
        double shortest = whole.segment.length();
        for (double done = 0; done < whole.segment.length() - 1e-6; ++pieces) {
          const double length = after[r].moves[k++].segment.length();
          shortest = std::min(shortest, length);
          done += length;
        }
        if (pieces < 2) continue;
        ++split;
        EXPECT_GE(shortest, 0.1 - 1e-9);
      }
    }
  }
  EXPECT_GT(split, 100);
}

// Prices asked for before must not show in what a price between them gives; nor must the second
// thread, which many samples are divided by.
TEST(FeedControl, GivesAtEveryPriceWhatItGivesAlone) {
  std::mt19937 random(12);
  for (int round = 0; round < 20; ++round) {
    std::vector<PlanarRun> before = random_runs(random);
    while (round >= 17 && before.size() < 30)
      for (PlanarRun& run : random_runs(random)) before.push_back(std::move(run));
    const std::vector<LoadSample> profile = random_profile(random, before);
    EXPECT_EQ(profile.size() > 2500, round >= 17);
    FeedParams params;
    ConstantLoad load(before, profile, params);
    for (const double price : {0.006, 0.1, 0.02, 0.05, 0.03, 0.025, 0.0061, 0.2}) {
      const FeedsAlong found = load.at(price);
      params.steps.price = price;
      std::vector<PlanarRun> alone = before;
      EXPECT_EQ(found.feeds, set_constant_load(alone, profile, params)) << price;
      for (std::size_t r = 0; r < alone.size(); ++r) EXPECT_EQ(found.runs[r].moves, alone[r].moves);
    }
  }
}

// Where means are held, which is not quite the best, a price between two may give what those give;
// no mean is above its limit, and it costs next to nothing.
TEST(FeedControl, HoldsMeansAtEveryPrice) {
  std::mt19937 random(13);
  for (int round = 0; round < 20; ++round) {
    const std::vector<PlanarRun> before = random_runs(random);
    const std::vector<LoadSample> profile = random_profile(random, before);
    FeedParams params;
    params.mean_length = 0.1;
    ConstantLoad load(before, profile, params);
    for (const double price : {0.006, 0.1, 0.02, 0.05, 0.03, 0.025}) {
      const FeedsAlong found = load.at(price);
      params.steps.price = price;
      std::vector<PlanarRun> alone = before;
      set_constant_load(alone, profile, params);
      const auto cost = [&](const std::vector<PlanarRun>& runs) {
        double sum = seconds(runs);
        for (const PlanarRun& run : runs) sum += price * static_cast<double>(run.moves.size());
        return sum;
      };
      EXPECT_LE(cost(found.runs), 1.01 * cost(alone)) << price;
      for (std::size_t i = 0; i < profile.size(); ++i)
        if (before[profile[i].run].moves[profile[i].move].kind == MoveKind::kCut) {
          EXPECT_LE(profile[i].share * found.feeds[i],
                    params.steps.most_peak * params.feed * (1 + 1e-9));
        }
    }
  }
}

TEST(FeedControl, LeavesAMoveWholeWhereSplittingItSavesLittle) {
  // An arc of 10 mm; on its last twentieth the feed could be 1.04, 2 times as high.
  for (const auto& [share, pieces] : {std::pair{1 / 1.04, 1}, std::pair{0.5, 2}}) {
    PlanarRun run;
    run.moves = {{MoveKind::kCut, Segment::arc({0, 0}, 5, 0, 2)}};
    std::vector<PlanarRun> runs = {run};
    std::vector<LoadSample> profile;
    for (int i = 0; i < 20; ++i)
      profile.push_back({0, 0, (i + 0.5) / 20, 0.5, 0, 0, 0, i < 19 ? 1.0 : share});
    set_constant_load(runs, profile, {});
    EXPECT_EQ(runs[0].moves.size(), pieces);
  }
}

TEST(LoadProfile, SeesTheSideStepAlongAStraightWall) {
  ClearedGround ground({{-40, -40}, {40, 40}}, kRadius, nullptr);
  ground.add(Segment::line({-30, 0}, {30, 0}));
  PlanarRun run;
  run.descent.at = {-20, -1.5};
  run.descent.over_cleared_ground = true;
  run.moves = {{MoveKind::kCut, Segment::line({-20, -1.5}, {20, -1.5})}};
  const std::vector<PlanarRun> runs = {run};
  const std::vector<LoadSample> profile = load_profile(runs, ground, 0.5);
  double length = 0, area = 0;
  for (const LoadSample& sample : profile) {
    EXPECT_LE(sample.length, kSmoothSpacing * 0.5 + 1e-9);
    EXPECT_NEAR(sample.engagement, kPi / 3, 0.01);
    EXPECT_NEAR(sample.width, 1.5, 0.01);
    EXPECT_NEAR(sample.chip, std::sin(kPi / 3), 0.005);
    EXPECT_EQ(sample.share, 0);
    length += sample.length;
    area += sample.width * sample.length;
  }
  EXPECT_NEAR(length, 40, 1e-9);
  EXPECT_NEAR(area, 60, 0.2);
  EXPECT_NEAR(worst_engagement(runs, profile, 0.1), kPi / 3, 0.01);
}

TEST(LoadProfile, KeepsTheLargestShareOfEveryPiece) {
  // Into the side of a cleared strip at a right angle: from nothing to the whole width.
  ClearedGround ground({{-40, -40}, {40, 40}}, kRadius, nullptr);
  ground.add(Segment::line({-30, 0}, {30, 0}));
  PlanarRun run;
  run.descent.over_cleared_ground = true;
  run.moves = {{MoveKind::kCut, Segment::line({0, 0}, {0, 8})}};
  const LoadShare width = [](const Load& load, const auto&) { return load.width; };
  double area = 0;
  for (const LoadSample& sample : load_profile({run}, ground, 1, width)) {
    // The strip's edge at y = 3 cuts the circle in a chord, then in less than its diameter.
    const auto width_at = [](double y) {
      return y >= kRadius ? 2 * kRadius : 2 * std::sqrt(kRadius * kRadius - std::pow(3 - y, 2));
    };
    const double y = 8 * sample.t;
    EXPECT_GE(sample.share, sample.width - 1e-9);
    EXPECT_NEAR(sample.share, width_at(y + sample.length / 2), 0.03 * 2 * kRadius);
    area += sample.width * sample.length;
  }
  EXPECT_NEAR(area, 6 * 8 - 9 * (2 - kPi / 2), 0.1);
}

TEST(LoadProfile, TellsASmoothFrontByFewLooksAsByMany) {
  // Most of a circle around a smaller one off its middle: a crescent from 0.6 mm to 2.4 mm wide.
  const auto profile_of = [](bool in_a_row, int& looks) {
    ClearedGround ground({{-40, -40}, {40, 40}}, kRadius, nullptr);
    // Cut by one move, or by many that do not follow each other, where a cusp may be between two.
    if (in_a_row) ground.add(Segment::arc({0, 0}, 10, 0, 2 * kPi));
    for (const int first : {0, 1})
      for (int i = first; i < 400 && !in_a_row; i += 2)
        ground.add(Segment::arc({0, 0}, 10, i * kPi / 200, kPi / 200));
    PlanarRun run;
    run.descent.over_cleared_ground = true;
    run.descent.at = {12.4, 0};
    for (int i = 0; i < 20; ++i)
      run.moves.push_back({MoveKind::kCut, Segment::arc({0.9, 0}, 11.5, i * kPi / 12, kPi / 12)});
    const LoadShare width = [&](const Load& load, const auto&) {
      ++looks;
      return load.width;
    };
    return load_profile({run}, ground, 0.3, width);
  };
  const auto at = [](const LoadSample& sample) {
    return static_cast<double>(sample.move) + sample.t;
  };
  int few_looks = 0, many_looks = 0;
  const std::vector<LoadSample> few = profile_of(true, few_looks);
  const std::vector<LoadSample> many = profile_of(false, many_looks);
  EXPECT_LT(few_looks, 0.5 * many_looks);
  double area = 0, length = 0, area_of_many = 0;
  for (const LoadSample& sample : many) area_of_many += sample.width * sample.length;
  std::size_t k = 0;
  for (const LoadSample& sample : few) {
    while (k + 1 < many.size() && at(many[k + 1]) <= at(sample)) ++k;
    EXPECT_NEAR(sample.engagement, many[k].engagement, 0.5 * kPi / 180);
    EXPECT_NEAR(sample.share, many[k].share, 0.02 * many[k].share);
    area += sample.width * sample.length;
    length += sample.length;
  }
  EXPECT_NEAR(length, 20 * kPi / 12 * 11.5, 1e-9);
  EXPECT_NEAR(area, area_of_many, 1e-3 * area);
}

TEST(LoadProfile, SeesAsMuchAreaAsWasRemoved) {
  // A line across untouched ground, entered from a ramp: a capsule less the ramp's.
  ClearedGround ground({{-40, -40}, {40, 40}}, kRadius, nullptr);
  PlanarRun run;
  run.descent.kind = DescentKind::kRamp;
  run.descent.at = {0, 0};
  run.descent.ramp_by = {Vec2{5, 0}};
  run.moves = {{MoveKind::kLink, Segment::line({0, 0}, {5, 0})},
               {MoveKind::kCut, Segment::line({5, 0}, {5, 12})}};
  double area = 0;
  for (const LoadSample& sample : load_profile({run}, ground, 0.5))
    area += sample.width * sample.length;
  // Beyond the ramp's capsule, whose top is y = 3 to the left of x = 5 and its round end to the
  // right.
  const double capsule = 12 * 6 + kPi * 9 / 2;
  const double shared = 3 * 3 + kPi * 9 / 4;
  EXPECT_NEAR(area, capsule - shared, 0.5);
}

}  // namespace
}  // namespace evenload
