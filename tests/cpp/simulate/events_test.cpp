// What must not happen is found where it happens; what is left is found where it stands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "simulate/paths.h"

namespace evenload {
namespace {

using namespace simulate_paths;  // NOLINT: the helpers of these tests

const Region kBlock = rectangle(-10, -10, 50, 40);
const Region kPocket = rectangle(0, 0, 40, 30);

std::vector<Prism> block_with_pocket() { return {{make_region(kBlock.outer, {kPocket.outer}), 0}}; }

// A raster that clears the pocket with a tool of 6 mm, and a pass along its walls `inset` mm less
// than the radius from them. `missing`: the row that is left out.
std::vector<Move> clearing(double inset = 0, int missing = -1) {
  std::vector<Move> moves{move_to(MoveKind::kRapid, 3, 3, 5), move_to(MoveKind::kEntry, 3, 3, -3)};
  for (int row = 0; row <= 12; ++row) {
    const double y = 3 + 2 * row;
    if (missing >= 0 && std::abs(row - missing) <= 1) continue;
    if (missing >= 0 && row == missing + 2)  // round the rib, not through it
      moves.push_back(line_to({row % 2 ? 37.0 : 3.0, y - 8}));
    moves.push_back(line_to({row % 2 ? 37.0 : 3.0, y}));
    moves.push_back(line_to({row % 2 ? 3.0 : 37.0, y}));
  }
  const double low = 3 - inset, high_x = 37 + inset, high_y = 27 + inset;
  for (const Vec2 p : {Vec2{37, 27}, Vec2{3, 27}, Vec2{low, low}, Vec2{high_x, low},
                       Vec2{high_x, high_y}, Vec2{low, high_y}, Vec2{low, low}})
    moves.push_back(line_to(p));
  moves.push_back(move_to(MoveKind::kRapid, low, low, 5));
  return moves;
}

SimulationParams params_with_part() {
  SimulationParams params = params_for(3);
  params.part = block_with_pocket();
  return params;
}

std::size_t count_of(const Simulation& run, IncidentKind kind) {
  std::size_t count = 0;
  for (const Incident& incident : run.figures.incidents) count += incident.kind == kind;
  return count;
}

TEST(FullPocket, IsRemovedToFiveTenThousandths) {
  const Simulation done = run(clearing(), {kBlock}, params_with_part());
  const double cleared = kPocket.area() - (4 - kPi) * 9;
  EXPECT_NEAR(done.figures.removed_area, cleared, 5e-4 * cleared);
  EXPECT_NEAR(done.figures.removed_volume, 3 * cleared, 5e-4 * 3 * cleared);
  EXPECT_LE(done.figures.gouge.value, 1e-9);
  EXPECT_EQ(done.figures.rest.area, 0);
  EXPECT_NEAR(done.figures.rest.unreachable_area, (4 - kPi) * 9, 0.1);
}

TEST(Gouge, OfFiveHundredthsIsFoundWithItsPlace) {
  std::vector<Move> moves = clearing();
  moves.insert(moves.end() - 1, {line_to({20, 3}), line_to({20.01, 2.95}), line_to({20.02, 3})});
  const Simulation done = run(moves, {kBlock}, params_with_part());
  EXPECT_NEAR(done.figures.gouge.value, 0.05, 1e-6);
  EXPECT_NEAR(done.figures.gouge.at.x, 20.01, 1e-6);
  EXPECT_NEAR(done.figures.gouge.at.y, 2.95, 1e-6);
  EXPECT_EQ(count_of(done, IncidentKind::kGouge), 2u);  // into the wall, and out of it
  double sampled = 0;
  for (const double g : done.record.gouge) sampled = std::max(sampled, g);
  EXPECT_NEAR(sampled, 0.05, 1e-6);
}

TEST(Gouge, OfAFastMoveBetweenTwoSamplesIsFound) {
  // The wall's corner reaches into a long move, far from both of its ends.
  SimulationParams params = params_for(3);
  params.part = {{rectangle(19.99, -10, 20.01, 0), 0}};
  params.step = 40;
  const Simulation done = run({line_to({0, 2.95}), line_to({40, 2.95})}, {kBlock}, params);
  EXPECT_NEAR(done.figures.gouge.value, 0.05, 1e-4);
}

TEST(Gouge, IntoTheFloorIsNoDeeperThanTheFloorIsThick) {
  SimulationParams params = params_with_part();
  params.part.push_back({kPocket, -2.9});
  const Simulation done = run(clearing(), {kBlock}, params);
  EXPECT_NEAR(done.figures.gouge.value, 0.1, 1e-6);
}

TEST(Fixture, IsNotTouchedUnnoticedByARapidAboveTheStock) {
  SimulationParams params = params_for(3);
  params.fixtures = {{rectangle(60, -10, 80, 40), 20}};
  std::vector<Move> moves = clearing();
  moves.push_back(move_to(MoveKind::kRapid, 70, 10, 5));
  const Simulation done = run(moves, {kBlock}, params);
  EXPECT_GT(done.figures.fixture.value, 5);
  EXPECT_EQ(count_of(done, IncidentKind::kFixture), 1u);
  EXPECT_EQ(done.figures.gouge.value, 0);
}

TEST(Rapid, ThroughMaterialIsFoundWithItsLengthAndPlace) {
  std::vector<Move> moves = clearing(0, 6);
  // Straight across the rib.
  moves.insert(moves.end() - 1, {line_to({20, 5}), move_to(MoveKind::kRapid, 20, 25, -3),
                                 line_to({20, 27}), move_to(MoveKind::kRapid, 20, 27, 5)});
  const Simulation done = run(moves, {kBlock}, params_with_part());
  ASSERT_EQ(count_of(done, IncidentKind::kRapidInMaterial), 1u);
  EXPECT_NEAR(done.figures.rapid_in_material.at.x, 20, 1e-9);
  EXPECT_GT(done.figures.rapid_in_material.value, 1);
  EXPECT_LT(done.figures.rapid_in_material.value, 6);
  EXPECT_EQ(count_of(run(clearing(), {kBlock}, params_with_part()), IncidentKind::kRapidInMaterial),
            0u);
}

TEST(Plunge, IntoMaterialIsFoundAndIntoAHoleIsNone) {
  const std::vector<Move> moves{move_to(MoveKind::kRapid, 20, 15, 5),
                                move_to(MoveKind::kEntry, 20, 15, -3),
                                move_to(MoveKind::kRapid, 20, 15, 5)};
  const Simulation done = run(moves, {kBlock}, params_with_part());
  ASSERT_EQ(count_of(done, IncidentKind::kPlungeInMaterial), 1u);
  EXPECT_NEAR(done.figures.plunge_in_material.value, 3, 0.11);
  EXPECT_NEAR(done.figures.plunge_in_material.at.x, 20, 1e-9);
  EXPECT_NEAR(done.figures.removed_volume, 27 * kPi, 0.01 * 27 * kPi);

  DexelStock drilled({{kBlock, 0}}, -kDepth, kFine);
  drilled.cut(Segment::line({20, 15}, {20, 15}), 3, -kDepth);
  Progress progress;
  const Simulation in_hole = simulate(moves, drilled, params_with_part(), progress);
  EXPECT_EQ(in_hole.figures.incidents.size(), 0u);
}

TEST(Rest, OfOneSquareMillimetreIsFoundWithItsPlace) {
  // All but a post of 1 mm^2 is cut away beforehand.
  Region around = make_region(kPocket.outer, {rectangle(9.5, 9.5, 10.5, 10.5).outer});
  DexelStock left(
      {{make_region(kBlock.outer, {around.outer}), 0}, {rectangle(9.5, 9.5, 10.5, 10.5), 0}},
      -kDepth, kFine);
  Progress progress;
  const Simulation done =
      simulate({line_to({30, 20}), line_to({35, 20})}, left, params_with_part(), progress);
  ASSERT_EQ(done.figures.rest.patches.size(), 1u);
  EXPECT_NEAR(done.figures.rest.area, 1, 0.06);
  EXPECT_NEAR(done.figures.rest.patches[0].at.x, 10, 0.05);
  EXPECT_NEAR(done.figures.rest.patches[0].at.y, 10, 0.5);
  EXPECT_NEAR(done.figures.rest.patches[0].depth, 3, 1e-9);
  ASSERT_EQ(done.figures.rest.outlines.size(), 1u);
}

TEST(Rest, OfMissingRowsIsTheRibBetweenThem) {
  const Simulation done = run(clearing(0, 6), {kBlock}, params_with_part());
  ASSERT_EQ(done.figures.rest.patches.size(), 1u);
  // 2 mm wide between the passes along the walls, whose round tool widens it at both ends.
  EXPECT_NEAR(done.figures.rest.area, 2 * 28, 0.1 * 2 * 28);
  EXPECT_NEAR(done.figures.rest.patches[0].at.y, 15, 1.01);
}

TEST(Rest, OnAFloorThatWasNotReachedIsAsDeepAsWhatStands) {
  DexelStock deep({{kBlock, 0}}, -4, kFine);
  Progress progress;
  const Simulation floor = simulate(clearing(), deep, params_with_part(), progress);
  EXPECT_NEAR(floor.figures.rest.area, kPocket.area() - (4 - kPi) * 9, 10);
  EXPECT_NEAR(floor.figures.rest.depth, 1, 1e-9);
}

TEST(SeveralDepths, AreEachCutAtTheirOwnDepth) {
  std::vector<Move> moves{move_to(MoveKind::kRapid, -20, 15, 5),
                          move_to(MoveKind::kRapid, -20, 15, -1),
                          line_to({60, 15}, -1),
                          move_to(MoveKind::kRapid, 60, 15, 5),
                          move_to(MoveKind::kRapid, -20, 15, 5),
                          move_to(MoveKind::kRapid, -20, 15, -3),
                          line_to({60, 15}, -3)};
  const Simulation done = run(moves, {kBlock}, params_for(3));
  double first = 0, second = 0;
  for (std::size_t i = 0; i < done.record.size(); ++i) {
    if (done.record.move[i] == 2) first = std::max(first, done.record.axial_depth[i]);
    if (done.record.move[i] == 6) second = std::max(second, done.record.axial_depth[i]);
  }
  EXPECT_NEAR(first, 1, 1e-9);
  EXPECT_NEAR(second, 2, 1e-9);
  EXPECT_NEAR(done.figures.removed_volume, 3 * 60 * 6, 1);
}

TEST(Ramp, RemovesItsWedge) {
  // From z = 0 to -3 over 40 mm. Where the tool is w = sqrt(r^2 - y^2) long to either side, the
  // flat tip reaches each depth w earlier than its centre, and ends 2 w long at full depth.
  const std::vector<Move> moves{move_to(MoveKind::kRapid, 0, 15, 0),
                                move_to(MoveKind::kEntry, 40, 15, -3)};
  const Simulation done = run(moves, {kBlock}, params_for(3));
  const double wedge = 0.5 * 3 * 40 * 6 + 2 * 3 * 0.5 * kPi * 9;
  EXPECT_NEAR(done.figures.removed_volume, wedge, 0.005 * wedge);
}

TEST(Kinds, OfGcodeAreToldFromWhatTheMovesDo) {
  SimulationParams params = params_with_part();
  params.infer_kinds = true;
  std::vector<Move> moves = clearing();
  for (Move& m : moves)
    if (m.kind != MoveKind::kRapid) m.kind = MoveKind::kCut;
  moves.insert(moves.end() - 1, {line_to({20, 15}), line_to({10, 15})});
  moves[moves.size() - 2].feed = 2 * kFeed;
  const Simulation done = run(moves, {kBlock}, params);
  const auto kind_of = [&](std::size_t move) {
    for (std::size_t i = 0; i < done.record.size(); ++i)
      if (static_cast<std::size_t>(done.record.move[i]) == move)
        return static_cast<MoveKind>(done.record.kind[i]);
    return MoveKind::kRapid;
  };
  EXPECT_EQ(kind_of(1), MoveKind::kEntry);
  EXPECT_EQ(kind_of(3), MoveKind::kCut);
  EXPECT_EQ(kind_of(moves.size() - 3), MoveKind::kCut);  // of air
  EXPECT_EQ(kind_of(moves.size() - 2), MoveKind::kLink);
  EXPECT_GT(done.figures.air_length, 20);
  EXPECT_EQ(kind_of(moves.size() - 1), MoveKind::kRapid);
}

TEST(Kinds, OfTheLevelEndOfAHelixIsAnEntry) {
  SimulationParams params = params_for(3);
  params.infer_kinds = true;
  const Vec2 centre{20, 15};
  std::vector<Move> moves{move_to(MoveKind::kRapid, 22, 15, 0)};
  for (int turn = 1; turn <= 6; ++turn)
    moves.push_back(arc_to({22, 15}, centre, 2 * kPi, -0.5 * turn));
  moves.push_back(arc_to({22, 15}, centre, 2 * kPi));
  moves.push_back(line_to({30, 15}));
  const Simulation done = run(moves, {kBlock}, params);
  for (std::size_t i = 0; i < done.record.size(); ++i)
    EXPECT_EQ(static_cast<MoveKind>(done.record.kind[i]),
              done.record.move[i] == 8 ? MoveKind::kCut : MoveKind::kEntry);
  EXPECT_EQ(done.figures.incidents.size(), 0u);
}

void expect_refused(std::vector<Move> moves, SimulationParams params, const std::string& word) {
  try {
    run(moves, {kBlock}, params);
    ADD_FAILURE() << "not refused: " << word;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

TEST(Simulate, RefusesWhatCannotBeWithTheMovesNumber) {
  SimulationParams params = params_for(3);
  params.tool_diameter = 0;
  expect_refused(clearing(), params, "diameter");
  expect_refused({}, params_for(3), "no moves");
  std::vector<Move> moves = clearing();
  moves[4].x = std::nan("");
  expect_refused(moves, params_for(3), "Move 4");
  moves = clearing();
  moves[5].feed = 0;
  expect_refused(moves, params_for(3), "Move 5");
  expect_refused({line_to({0, 0}), arc_to({10, 0}, {4, 0}, kPi)}, params_for(3), "Move 1");
  params = params_for(3);
  params.part = {{rectangle(-20, 0, 5, 5), 0}};
  expect_refused(clearing(), params, "does not contain the part");
  params.part = {{rectangle(-5, -5, 5, 5), std::nan("")}};
  expect_refused(clearing(), params, "part's top");
  std::swap(params.part, params.fixtures);
  expect_refused(clearing(), params, "fixture's top");
  params = params_for(3);
  params.step = -1;
  expect_refused(clearing(), params, "step");
}

TEST(Simulate, RefusesTopsThatAreNoNumbersAndArcsThatDoNotLeadToTheirEnds) {
  SimulationParams params = params_with_part();
  params.part[0].top = std::nan("");
  expect_refused(clearing(), params, "top");
  params = params_for(3);
  params.fixtures = {{rectangle(60, 0, 70, 10), std::nan("")}};
  expect_refused(clearing(), params, "top");
  expect_refused({line_to({10, 0}), arc_to({10, 0}, {0, 0}, kPi / 2)}, params_for(3), "sweep");
  expect_refused({line_to({10, 0}), arc_to({0, 10}, {0, 0}, -kPi / 2)}, params_for(3), "sweep");
  expect_refused({line_to({10, 0}), arc_to({0, 10}, {0, 0}, kPi)}, params_for(3), "sweep");
  expect_refused({line_to({0, 0}), line_to({9e12, 0})}, params_for(3), "Move 1");
}

TEST(Simulate, StopsWithinALongMove) {
  int asked = 0;
  Progress progress([&asked](double) { return ++asked < 2; });
  DexelStock stock({{kBlock, 0}}, -kDepth, 0.2);
  const Simulation done = simulate({line_to({5, 0}), arc_to({5, 0}, {0, 0}, 400 * kPi)}, stock,
                                   params_for(3), progress);
  EXPECT_TRUE(done.cancelled);
  EXPECT_LT(done.figures.cut_length, 1000);
}

TEST(LongSteps, NeitherMissTheLoadNorTheRest) {
  SimulationParams params = params_for(3);
  params.step = 1000;
  const Simulation done = run({line_to({-20, 15}), line_to({60, 15})}, {kBlock}, params);
  EXPECT_NEAR(done.figures.engagement.value, kPi, 1e-9);
  EXPECT_NEAR(done.figures.removed_volume, 60 * 6 * 3, 1);
  EXPECT_EQ(done.figures.rest.patches.size(), 2u);
}

TEST(TipBelowTheStock, CutsNoMoreThanThereIs) {
  const Simulation deep =
      run({line_to({-20, 15}, -5), line_to({60, 15}, -5)}, {kBlock}, params_for(3));
  EXPECT_NEAR(deep.figures.removal_rate.value, kDepth * 6 * kFeed, 0.005 * kDepth * 6 * kFeed);
  EXPECT_NEAR(*std::max_element(deep.record.axial_depth.begin(), deep.record.axial_depth.end()),
              kDepth, 1e-9);
}

TEST(Gouge, IsAsDeepInAPartOfTwoHalvesAsInTheWhole) {
  SimulationParams whole = params_for(3), halves = params_for(3);
  whole.part = {{rectangle(0, 0, 40, 20), 0}};
  halves.part = {{rectangle(0, 0, 20, 20), 0}, {rectangle(20, 0, 40, 20), 0}};
  const std::vector<Move> moves{line_to({20, 30}), line_to({20, 12})};
  const Simulation one = run(moves, {kBlock}, whole), two = run(moves, {kBlock}, halves);
  EXPECT_NEAR(one.figures.gouge.value, 11, 1e-6);
  EXPECT_NEAR(two.figures.gouge.value, 11, 1e-4);
}

TEST(Slope, OfACutIsNoEntryUnlessItIsSteep) {
  SimulationParams params = params_for(3);
  params.infer_kinds = true;
  const Simulation flat =
      run({line_to({-20, 15}, -2), line_to({60, 15}, -2.001)}, {kBlock}, params);
  EXPECT_NEAR(flat.figures.engagement.value, kPi, 1e-9);
  EXPECT_EQ(flat.figures.entry_length, 0);
  const Simulation ramp = run({line_to({0, 15}, 0), line_to({40, 15}, -3)}, {kBlock}, params);
  EXPECT_EQ(ramp.figures.cut_length, 0);
  EXPECT_NEAR(ramp.figures.entry_engagement.value, kPi, 1e-9);
}

TEST(Slope, HasTheRemovalRateOfItsSideAndItsTip) {
  // A steady ramp through full material: what is removed per length is the same at every place.
  const double fall = 0.05, depth0 = 1;
  for (const double turn : {0.0, 30.0}) {
    const Vec2 from = rotated({5, 0}, turn * kDegree), to = rotated({35, 0}, turn * kDegree);
    std::vector<Move> moves{line_to(from, -depth0), line_to(to, -depth0 - 30 * fall)};
    const Simulation done =
        run(moves, {turned(rectangle(-10, -10, 50, 10), turn * kDegree)}, params_for(3));
    const LoadRecord& record = done.record;
    const double along = std::hypot(1, fall);
    for (std::size_t i = record.size() / 2; i < record.size(); ++i) {
      const double depth = -record.z[i];
      // Ahead of the tool the stock stands at full height; under its tip lies a step's fall.
      const double expected = kFeed / along * (6 * depth + fall * kPi * 9);
      EXPECT_NEAR(record.removal_rate[i], expected, 0.01 * expected) << i << " at " << turn;
    }
  }
}

TEST(Plunge, ThatLeansALittleIsFoundToo) {
  const std::vector<Move> moves{move_to(MoveKind::kRapid, 20, 15, 5), line_to({20.001, 15}, -3)};
  const Simulation done = run(moves, {kBlock}, params_with_part());
  EXPECT_EQ(count_of(done, IncidentKind::kPlungeInMaterial), 1u);
  EXPECT_EQ(done.figures.cut_length, 0);
}

TEST(Simulate, StopsWhenItIsCancelledAndSaysSo) {
  std::vector<Move> moves = clearing();
  while (moves.size() < 2000) moves.insert(moves.end() - 1, {line_to({10, 10}), line_to({20, 10})});
  int asked = 0;
  Progress progress([&asked](double) { return ++asked < 3; });
  DexelStock stock({{kBlock, 0}}, -kDepth, 0.2);
  const Simulation done = simulate(moves, stock, params_for(3), progress);
  EXPECT_TRUE(done.cancelled);
  EXPECT_LT(done.record.move.back(), 300);
  EXPECT_EQ(done.record.first_arc.size(), done.record.size() + 1);
}

TEST(Simulate, IsTheSameOnTurnedAndShiftedPaths) {
  const Simulation original = run(clearing(), {kBlock}, params_for(3));
  std::vector<Move> moves = clearing();
  const Vec2 shift{1234.5, -987.6};
  for (Move& m : moves) {
    const Vec2 p = rotated({m.x, m.y}, 0.3) + shift;
    m.x = p.x;
    m.y = p.y;
  }
  Region block = turned(kBlock, 0.3);
  std::vector<Vertex> vertices = block.outer.vertices();
  for (Vertex& v : vertices) v.p += shift;
  const Simulation again = run(moves, {make_region(Curve(vertices, true))}, params_for(3));
  ASSERT_EQ(again.record.size(), original.record.size());
  double sum = 0;
  for (std::size_t i = 0; i < again.record.size(); ++i)
    sum += std::abs(again.record.engagement[i] - original.record.engagement[i]);
  EXPECT_LE(sum / static_cast<double>(again.record.size()), 0.1 * kDegree);
  EXPECT_NEAR(again.figures.engagement.value, original.figures.engagement.value, 1 * kDegree);
  EXPECT_NEAR(again.figures.removed_volume, original.figures.removed_volume,
              1e-4 * original.figures.removed_volume);
}

}  // namespace
}  // namespace evenload
