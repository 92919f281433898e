// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/refinement/judgement.hpp"
#include "support/designs.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

using namespace test;

// Judgement of a dome's contact points, with one normal force for all but the first.
struct Judged {
  Design design = spread_design(hexagon(2, cap_height), 1.35, 1.2);
  DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  std::vector<ContactPoint> points = interface_points(geometry.tiles, geometry.patches);

  Judgement with(double first, double floor) const {
    Eigen::VectorXd normal = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(points.size()));
    normal(0) = first;
    return judge(normal, floor, 0.1);
  }
};

TEST(Judgement, AValidPlaceIsBetterThanOneThatIsNotHoweverLittleThatLacks) {
  const Judged of;
  const Judgement valid = of.with(0.12, 0.11);  // short of the goals, but above f_min
  ASSERT_TRUE(valid.valid());
  Judgement touching = of.with(1, 1);
  touching.depth = 0.001;
  ASSERT_FALSE(touching.valid());
  EXPECT_LT(touching.missing + touching.depth, valid.missing + valid.depth);
  EXPECT_TRUE(valid.better_than(touching));
  EXPECT_FALSE(touching.better_than(valid));
  EXPECT_TRUE(of.with(1, 1).better_than(valid));
  EXPECT_TRUE(of.with(0.05, 1).better_than(of.with(0.04, 1)));
}

TEST(Judgement, WhatIsShortIsNamed) {
  const Judged of;
  const auto explain = [&](const Judgement& judgement,
                           const std::vector<std::array<int, 2>>& critical) {
    return weak_contacts(of.points, judgement, critical);
  };
  const std::vector<BlockedContact> weak = explain(of.with(0.05, 0.05), {});
  ASSERT_EQ(weak.size(), 1u);
  EXPECT_EQ(weak[0].tiles, of.points[0].tile);
  EXPECT_EQ(weak[0].reason.kind, "weak_contact");
  EXPECT_EQ(weak[0].reason.tiles, tiles_of({of.points[0].tile}));
  // No point is weak: the contacts that hold the floor down.
  const std::vector<std::array<int, 2>> critical = {of.points[7].tile};
  const Judgement floor = of.with(1, 0.05);
  ASSERT_FALSE(floor.valid());
  const std::vector<BlockedContact> low = explain(floor, critical);
  ASSERT_EQ(low.size(), 1u);
  EXPECT_EQ(low[0].tiles, of.points[7].tile);
  EXPECT_EQ(low[0].reason.kind, "weak_contact.friction");
  EXPECT_NEAR(std::get<double>(low[0].reason.figures.at("share")), floor.floor, 1e-12);
  EXPECT_TRUE(explain(of.with(1, 1), critical).empty());
}

}  // namespace
}  // namespace curveups
