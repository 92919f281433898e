// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "curveups/actuation/actuated_design.hpp"
#include "curveups/actuation/hands.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "support/designs.hpp"

namespace curveups::test {
namespace {

struct DomeOptions {
  double friction, tolerance, curvature = 0.02;
  int rows = 4, columns = 4;
  double mesh_size = 2;
};

Design dome(const DomeOptions& options) {
  Parameters parameters;
  parameters.mesh_size = options.mesh_size;
  parameters.bumps = "none";
  parameters.friction_coefficient = options.friction;
  parameters.hold_tolerance = options.tolerance;
  SampleOptions o;
  o.rows = options.rows;
  o.columns = options.columns;
  o.kx = o.ky = options.curvature;
  return sample_design(parameters, o);
}

ActuatedDesign jammed(const Design& design, const ChosenTouch& touch = {}) {
  ActuationOptions options;
  options.touch = touch;
  ActuatedDesign found = actuate_design(design, options, {});
  EXPECT_TRUE(found.hands);
  if (found.hands) {
    EXPECT_EQ(found.arrives, false);
    EXPECT_EQ(found.hand_frames.size(), found.hands->frames.size());
  }
  return found;
}

// A dome of 18 tiles that comes home by touches and not by shaking alone: where one jams depends on
// rounding, most come home by shaking and nothing brings some home. Its membranes have enough
// elements for several threads.
Design find_dome_that_takes_touches(double tolerance) {
  for (double friction : {0.3, 0.5, 0.35, 0.45, 0.25, 0.4, 0.2}) {
    for (double curvature : {0.02, 0.025, 0.03, 0.018, 0.022, 0.015}) {
      Design design = dome({friction, tolerance, curvature, 3, 3, 1});
      const ActuatedDesign found = actuate_design(design, {}, {});
      if (!found.hands || found.hands->shaken.open_contacts.empty()) continue;
      if (!found.hands->touches.empty() && found.hands->reached == Homecoming::home) return design;
    }
  }
  ADD_FAILURE() << "no dome comes home by touches";
  return dome({0.2, tolerance});
}

constexpr double touch_tolerance = 0.05;

const Design& dome_that_takes_touches() {
  static const Design design = find_dome_that_takes_touches(touch_tolerance);
  return design;
}

// Time, friction and work go on from the path's end; what is stored less the work of hands falls.
void expect_to_go_on(const ActuatedDesign& found) {
  const PathFrame* before = &found.path.frames.back();
  const double whole = found.path.frames.front().energy;
  for (const PathFrame& now : found.hands->frames) {
    EXPECT_GT(now.time, before->time);
    EXPECT_GE(now.friction, before->friction);
    // Contact points are found anew between steps.
    EXPECT_LT(now.energy - now.hands, before->energy - before->hands + 2e-3 * whole);
    before = &now;
  }
  EXPECT_LE(found.hands->largest_rise, 1e-9 * whole);
}

// Bit by bit, but for what was tried on the way.
void expect_same_answer(const ActuatedDesign& found, const ActuatedDesign& other) {
  EXPECT_EQ(found.hand_frames, other.hand_frames);
  const Hands &a = *found.hands, &b = *other.hands;
  EXPECT_EQ(a.taps, b.taps);
  EXPECT_EQ(a.shaking_frames, b.shaking_frames);
  EXPECT_EQ(a.reached, b.reached);
  EXPECT_EQ(a.end.energy, b.end.energy);
  EXPECT_EQ(a.end.shortfall, b.end.shortfall);
  EXPECT_EQ(a.end.open_contacts, b.end.open_contacts);
  ASSERT_EQ(a.frames.size(), b.frames.size());
  for (std::size_t k = 0; k < a.frames.size(); ++k) EXPECT_EQ(a.frames[k].hands, b.frames[k].hands);
  ASSERT_EQ(a.touches.size(), b.touches.size());
  for (std::size_t k = 0; k < a.touches.size(); ++k) {
    EXPECT_EQ(a.touches[k].tiles, b.touches[k].tiles);
    EXPECT_EQ(a.touches[k].direction, b.touches[k].direction);
    EXPECT_EQ(a.touches[k].force, b.touches[k].force);
  }
}

// As pieces of twelve tiles snap, the limits of friction rise by much within a step.
TEST(Hands, StoreNoMoreInAStepThanTheyGive) {
  int by_hand = 0;
  for (const DomeOptions& options : std::vector<DomeOptions>{{0.35, 0.05, 0.022, 3, 2, 1},
                                                             {0.35, 0.05, 0.03, 2, 3, 1},
                                                             {0.3, 0.05, 0.02, 3, 2, 1},
                                                             {0.5, 0.05, 0.025, 2, 3, 1},
                                                             {0.5, 0.05, 0.03, 2, 3, 1}}) {
    const ActuatedDesign found = actuate_design(dome(options), {}, {});
    if (found.hands) {
      expect_to_go_on(found);
      ++by_hand;
    }
    EXPECT_LE(found.path.largest_rise, 1e-9 * found.path.frames[0].energy);
  }
  EXPECT_GT(by_hand, 0);
}

TEST(Hands, ShakingFreesWhatFrictionHolds) {
  const ActuatedDesign found = jammed(dome({0.4, 0.08, 0.03}));
  const Hands& hands = *found.hands;
  EXPECT_GT(hands.taps, 0);
  EXPECT_TRUE(hands.shaken.at_rest);
  EXPECT_LT(hands.shaken.energy, found.end.energy);
  EXPECT_LT(hands.shaken.shortfall, 0.5 * found.end.shortfall);
  EXPECT_GT(hands.frames.back().friction, found.path.frames.back().friction);
  EXPECT_EQ(hands.frames[hands.shaking_frames - 1].hands, 0);
  // A contact may stay open by rounding; then touches are tried.
  EXPECT_LE(hands.shaken.shortfall, found.tolerance);
  EXPECT_NE(hands.reached, Homecoming::none);
  EXPECT_EQ(hands.tried == 0, hands.shaken.open_contacts.empty());
  expect_to_go_on(found);
}

TEST(Hands, TouchesBringHomeWhatShakingDoesNot) {
  const ActuatedDesign found = jammed(dome_that_takes_touches());
  const Hands& hands = *found.hands;
  ASSERT_FALSE(hands.shaken.open_contacts.empty());
  ASSERT_FALSE(hands.touches.empty());
  EXPECT_EQ(hands.reached, Homecoming::home);
  EXPECT_TRUE(hands.end.open_contacts.empty());
  EXPECT_TRUE(hands.end.at_rest);
  EXPECT_LE(hands.end.shortfall, touch_tolerance);
  EXPECT_GE(hands.tried, 2);
  std::set<int> tiles;
  for (const HandTouch& touch : hands.touches) {
    EXPECT_NEAR(touch.direction.norm(), 1, 1e-12);
    EXPECT_LE(std::abs(touch.outward), 1 + 1e-12);
    EXPECT_GT(touch.force, 0);
    EXPECT_LE(touch.force, hands.largest_force);
    for (int tile : touch.tiles) {
      EXPECT_TRUE(tiles.insert(tile).second) << tile;
      EXPECT_TRUE(tile >= 0 && tile < found.frames.front().rows());
    }
  }
  // The frames end where the touches do.
  EXPECT_NEAR(hands.frames.back().energy, hands.end.energy, 1e-9 * hands.end.energy);
  EXPECT_NE(hands.frames.back().hands, 0);
  expect_to_go_on(found);
}

TEST(Hands, SayWhenNothingDoes) {
  const ActuatedDesign found = jammed(dome({0.2, 1e-4}));
  const Hands& hands = *found.hands;
  EXPECT_EQ(hands.reached, Homecoming::none);
  EXPECT_TRUE(hands.touches.empty());
  EXPECT_GE(hands.tried, 3);  // two forces may be the same round number
  EXPECT_LE(hands.tried, 4);
  EXPECT_LE(hands.end.shortfall, hands.shaken.shortfall);
}

TEST(Hands, PressTheTilesThatAreChosenAsTheSearchDoes) {
  const Design& design = dome_that_takes_touches();
  const ActuatedDesign searched = jammed(design);
  ASSERT_FALSE(searched.hands->touches.empty());
  ChosenTouch touch{{}, searched.hands->touches.front().force};
  for (const HandTouch& one : searched.hands->touches) {
    touch.tiles.insert(touch.tiles.begin(), one.tiles.begin(), one.tiles.end());
  }
  const ActuatedDesign again = jammed(design, touch);
  EXPECT_EQ(again.hands->tried, 1);
  EXPECT_EQ(again.hands->largest_force, *touch.force);
  expect_same_answer(again, searched);
}

TEST(Hands, PressOneTileThatIsChosen) {
  const ActuatedDesign found = jammed(dome({0.2, 1e-4}), {{7}, std::nullopt});
  const Hands& hands = *found.hands;
  EXPECT_EQ(hands.tried, 1);
  ASSERT_EQ(hands.touches.size(), 1u);
  EXPECT_EQ(hands.touches.front().tiles, std::vector<int>{7});
  // By default a round number that is at most twice the mean force of a contact.
  EXPECT_LE(hands.touches.front().force, 2 * hands.shaken.push);
  EXPECT_GT(hands.touches.front().force, 0.8 * hands.shaken.push);
  EXPECT_GT(hands.frames.size(), static_cast<std::size_t>(hands.shaking_frames));
  EXPECT_NEAR(hands.frames.back().energy, hands.end.energy, 1e-9 * hands.end.energy);
  expect_to_go_on(found);
}

TEST(Hands, RefuseTilesAndForcesThatCanNotBe) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const ChosenTouch& wrong : std::vector<ChosenTouch>{{{-1}, {}},
                                                           {{3}, {}},
                                                           {{0, 1, 0}, {}},
                                                           {{0}, 0.0},
                                                           {{0}, -1.0},
                                                           {{0}, nan},
                                                           {{0}, infinity},
                                                           {{0}, 1e7},
                                                           {{}, 1.0}}) {
    EXPECT_THROW(check_touch(wrong, 3), InvalidInput);
  }
  EXPECT_NO_THROW(check_touch({{0, 2}, 0.5}, 3));
  EXPECT_NO_THROW(check_touch({}, 3));
  try {
    check_touch({{0, 1, 1}, {}}, 3);
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.tiles(), std::vector<int>{1});
  }

  ActuationOptions options;
  options.touch.tiles = {0};
  options.hands = false;
  EXPECT_THROW(actuate_design(dome({0.2, 0.03}), options, {}), InvalidInput);
}

TEST(Hands, AreTheSameWithAnyNumberOfThreads) {
  const Design& design = dome_that_takes_touches();
  const int before = thread_count();
  std::vector<ActuatedDesign> found;
  for (int threads : {1, 2, 4}) {
    set_thread_count(threads);
    found.push_back(jammed(design));
  }
  set_thread_count(before);
  const Hands& one = *found.front().hands;
  EXPECT_GT(one.frames.size(), static_cast<std::size_t>(one.shaking_frames));
  EXPECT_FALSE(one.touches.empty());
  for (const ActuatedDesign& other : found) {
    EXPECT_EQ(other.hands->tried, one.tried);
    expect_same_answer(other, found.front());
  }
}

TEST(Hands, StoppedTheyLeaveThePathAndItsAnswers) {
  const ActuatedDesign found =
      actuate_design(dome({0.4, 0.05}), {},
                     [](const std::string& what, double) { return what != "shaking"; });
  EXPECT_TRUE(found.path.stopped);
  EXPECT_EQ(found.arrives, false);
  EXPECT_TRUE(found.trap);
  EXPECT_FALSE(found.hands);
  EXPECT_TRUE(found.hand_frames.empty());
}

}  // namespace
}  // namespace curveups::test
