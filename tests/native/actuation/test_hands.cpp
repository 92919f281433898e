// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <set>

#include "curveups/actuation/actuated_design.hpp"
#include "curveups/actuation/hands.hpp"
#include "support/designs.hpp"

namespace curveups::test {
namespace {

Design dome(double friction, double tolerance) {
  Parameters parameters;
  parameters.mesh_size = 2;
  parameters.bumps = "none";
  parameters.friction_coefficient = friction;
  parameters.hold_tolerance = tolerance;
  SampleOptions o;
  o.rows = 4;
  o.columns = 4;
  o.kx = o.ky = 0.02;
  return sample_design(parameters, o);
}

ActuatedDesign jammed(double friction, double tolerance) {
  ActuatedDesign found = actuate_design(dome(friction, tolerance), nullptr, {}, {});
  EXPECT_TRUE(found.hands);
  if (found.hands) {
    EXPECT_EQ(found.arrives, false);
    EXPECT_EQ(found.hand_frames.size(), found.hands->frames.size());
  }
  return found;
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

TEST(Hands, ShakingFreesWhatFrictionHolds) {
  const ActuatedDesign found = jammed(0.4, 0.05);
  const Hands& hands = *found.hands;
  EXPECT_GT(hands.taps, 0);
  EXPECT_TRUE(hands.shaken.at_rest);
  EXPECT_LT(hands.shaken.energy, found.end.energy);
  EXPECT_LT(hands.shaken.shortfall, 0.3 * found.end.shortfall);
  EXPECT_GT(hands.frames.back().friction, found.path.frames.back().friction);
  EXPECT_EQ(hands.frames[hands.shaking_frames - 1].hands, 0);
  // A contact may stay open by rounding; then touches are tried.
  EXPECT_LE(hands.shaken.shortfall, found.tolerance);
  EXPECT_NE(hands.reached, Homecoming::none);
  EXPECT_EQ(hands.tried == 0, hands.shaken.open_contacts.empty());
  expect_to_go_on(found);
}

TEST(Hands, TouchesBringHomeWhatShakingDoesNot) {
  const double tolerance = 0.05;
  const ActuatedDesign found = jammed(0.2, tolerance);
  const Hands& hands = *found.hands;
  ASSERT_FALSE(hands.shaken.open_contacts.empty());
  ASSERT_FALSE(hands.touches.empty());
  EXPECT_EQ(hands.reached, Homecoming::home);
  EXPECT_TRUE(hands.end.open_contacts.empty());
  EXPECT_TRUE(hands.end.at_rest);
  EXPECT_LE(hands.end.shortfall, tolerance);
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
  const ActuatedDesign found = jammed(0.2, 1e-4);
  const Hands& hands = *found.hands;
  EXPECT_EQ(hands.reached, Homecoming::none);
  EXPECT_TRUE(hands.touches.empty());
  EXPECT_EQ(hands.tried, 3);
  EXPECT_LE(hands.end.shortfall, hands.shaken.shortfall);
}

TEST(Hands, StoppedTheyLeaveThePathAndItsAnswers) {
  const ActuatedDesign found =
      actuate_design(dome(0.4, 0.05), nullptr, {},
                     [](const std::string& what, double) { return what != "shaking"; });
  EXPECT_TRUE(found.path.stopped);
  EXPECT_EQ(found.arrives, false);
  EXPECT_TRUE(found.trap);
  EXPECT_FALSE(found.hands);
  EXPECT_TRUE(found.hand_frames.empty());
}

}  // namespace
}  // namespace curveups::test
