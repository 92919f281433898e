// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "curveups/bodies/convex_distance.hpp"
#include "curveups/bodies/joint_holes.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/design/print_constants.hpp"
#include "curveups/fabrication/print_model.hpp"
#include "curveups/geometry/convex_polygon.hpp"
#include "support/designs.hpp"
#include "support/soundness.hpp"

namespace curveups {
namespace {

using test::expect_sound;

// Two halves of a patch, parted along four edges up its middle.
test::SampleOptions halves(double kx, double ky) {
  test::SampleOptions o;
  o.rows = o.columns = 4;
  o.kx = kx;
  o.ky = ky;
  o.cuts.resize(4, 2);
  o.cuts << 2, 7, 7, 12, 12, 17, 17, 22;
  o.piece_offset = 40;
  return o;
}

Parameters sewn() {
  Parameters p;
  p.joint = "holes";
  return p;
}

// Circles of the bore at some heights, in the tile's frame.
std::vector<Vec3> surface(const JointHole& hole, double radius, double H_body) {
  std::vector<Vec3> points;
  for (int level = 0; level <= 4; ++level) {
    for (int k = 0; k < 720; ++k) {
      const double angle = 2 * M_PI * k / 720;
      points.emplace_back(hole.axis.x() + radius * std::cos(angle),
                          hole.axis.y() + radius * std::sin(angle), -H_body * level / 4);
    }
  }
  return points;
}

class JointHolesOf : public ::testing::TestWithParam<std::array<double, 2>> {};

TEST_P(JointHolesOf, PiecesAreSoundAndLackTheHolesVolume) {
  for (const char* bumps : {"bumps", "dimples", "none"}) {
    for (const char* support : {"soluble", "breakaway", "none"}) {
      SCOPED_TRACE(std::string(bumps) + " " + support);
      Parameters p = sewn();
      p.bumps = bumps;
      p.support = support;
      test::SampleOptions o = halves(GetParam()[0], GetParam()[1]);
      o.rows = 2;
      o.cuts.conservativeResize(2, Eigen::NoChange);
      const Design design = test::sample_design(p, o);
      const PrintModel model = make_print_model(design);
      expect_sound(model);
      EXPECT_EQ(test::unsound(model.actuated), "");
      EXPECT_TRUE(model.joints.closed.empty());
      Design closed = design;
      closed.parameters.joint = "none";
      const PrintModel without = make_print_model(closed);
      EXPECT_TRUE(without.joints.joints.empty());
      std::size_t holes = 0;
      for (std::size_t i = 0; i < model.tiles.size(); ++i) {
        const std::size_t own = model.joints.of_tile[i].size();
        const double less = own * 0.25 * M_PI * joint_hole * joint_hole * p.H_body;
        EXPECT_NEAR(volume(model.tiles[i]), volume(without.tiles[i]) - less, 1e-9);
        EXPECT_NEAR(volume(model.actuated[i]), volume(without.actuated[i]) - less, 1e-9);
        EXPECT_EQ(without.tiles[i].cylinders.size(), 0u);
        EXPECT_EQ(model.tiles[i].cylinders.size(), own);
        holes += own;
      }
      EXPECT_EQ(holes, 4u);
      // Holes above the slab stay open, and the slab is the same.
      EXPECT_EQ(model.volume("support"), without.volume("support"));
    }
  }
}

TEST_P(JointHolesOf, ThePartnersOfAnEdgeCorrespond) {
  const PrintModel model =
      make_print_model(test::sample_design(sewn(), halves(GetParam()[0], GetParam()[1])));
  const TileMesh& tiles = model.geometry.tiles;
  ASSERT_EQ(model.joints.joints.size(), 4u);
  for (int k = 0; k < 4; ++k) {
    const Joint& joint = model.joints.joints[k];
    EXPECT_NE(model.piece_of_tile[joint.tile[0]], model.piece_of_tile[joint.tile[1]]);
    const MeshEdge& edge = tiles.topology.edges[joint.edge];
    const Vec3 a = tiles.mesh.V.row(edge.v[0]), b = tiles.mesh.V.row(edge.v[1]);
    std::array<Vec3, 2> mouth;
    for (int s = 0; s < 2; ++s) {
      std::vector<Vec2> axes;
      for (const JointHole& hole : model.joints.of_tile[joint.tile[s]]) {
        if (hole.joint == k) axes.push_back(hole.axis);
      }
      ASSERT_EQ(axes.size(), 1u);
      mouth[s] = tiles.frame[joint.tile[s]](Vec3(axes[0].x(), axes[0].y(), 0));
    }
    // Mirror images in the plane that bisects the fold: the thread is square to the edge.
    EXPECT_NEAR((mouth[1] - mouth[0]).dot(b - a), 0, 1e-9);
    EXPECT_NEAR((mouth[0] - a).norm(), (mouth[1] - a).norm(), 1e-9);
    // In its middle where nothing is in the way.
    EXPECT_NEAR((mouth[0] - a).norm(), (mouth[0] - b).norm(), 0.5);
  }
}

TEST_P(JointHolesOf, HolesKeepTheirDistances) {
  for (const char* bumps : {"bumps", "dimples"}) {
    Parameters p = sewn();
    p.bumps = bumps;
    const PrintModel model =
        make_print_model(test::sample_design(p, halves(GetParam()[0], GetParam()[1])));
    const TileMesh& tiles = model.geometry.tiles;
    for (int i = 0; i < tiles.tile_count(); ++i) {
      for (const JointHole& hole : model.joints.of_tile[i]) {
        double nearest_wall = 1e300;
        for (const Vec3& point : surface(hole, model.joints.radius, p.H_body)) {
          for (const BodyFace& face : model.bumps.body[i].faces) {
            if (face.tag == body_tag::front || face.tag == body_tag::back) continue;
            nearest_wall = std::min(nearest_wall, -face.plane.distance(point));
          }
          for (const WallCap& cap : model.bumps.of_tile[i]) {
            if (cap.bump) continue;
            const CapSphere sphere = cap_sphere(cap.centre, cap.axis, cap.radius, cap.height);
            EXPECT_GE((point - sphere.centre).norm() - sphere.radius, p.p_floor - 1e-5);
          }
        }
        // To the border's wall it is p_floor, to all others more.
        EXPECT_NEAR(nearest_wall, p.p_floor, 1e-4);
        EXPECT_GE(nearest_wall, p.p_floor - 2e-6);
        for (Side side : {Side::front, Side::back}) {
          const auto pin = pin_corners(tiles, i, side, model.q.row(i).data());
          EXPECT_GE(distance(Polygon(pin.begin(), pin.end()), hole.axis),
                    model.joints.radius + p.p_floor);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(FlatDomeSaddleBowl, JointHolesOf,
                         ::testing::Values(std::array<double, 2>{0, 0},
                                           std::array<double, 2>{0.01, 0.01},
                                           std::array<double, 2>{0.01, -0.01},
                                           std::array<double, 2>{-0.01, -0.01}));

TEST(JointHoles, LongEdgesHaveTwo) {
  Parameters p = sewn();
  p.L = 14;
  p.p_max = 6;
  const PrintModel model = make_print_model(test::sample_design(p, halves(0.004, 0.004)));
  EXPECT_TRUE(model.joints.closed.empty());
  for (const Joint& joint : model.joints.joints) {
    for (int s = 0; s < 2; ++s) {
      const auto& own = model.joints.of_tile[joint.tile[s]];
      ASSERT_EQ(own.size(), 2u);
      const double length = model.geometry.tiles.length(joint.tile[s], joint.side[s]);
      EXPECT_NEAR((own[0].axis - own[1].axis).norm(), 0.5 * length, 0.1);
    }
  }
  expect_sound(model);
}

TEST(JointHoles, PrintedFrontDownTheyAreThereAsWell) {
  Parameters p = sewn();
  p.support = "breakaway";
  p.orientation = "front-down";
  const PrintModel model = make_print_model(test::sample_design(p, halves(0.01, 0.01)));
  EXPECT_EQ(model.tiles[model.joints.joints[0].tile[0]].cylinders.size(), 1u);
  expect_sound(model);
}

TEST(JointHoles, SlitsAndTheTargetsOwnBorderHaveNone) {
  test::SampleOptions o = halves(0.01, 0.01);
  o.cuts.conservativeResize(3, Eigen::NoChange);  // the last edge holds it together
  o.piece_offset = 0;
  const PrintModel model = make_print_model(test::sample_design(sewn(), o));
  EXPECT_EQ(model.piece_count, 1);
  EXPECT_TRUE(model.joints.joints.empty());
  for (const PrintBody& tile : model.tiles) EXPECT_TRUE(tile.cylinders.empty());
}

TEST(JointHoles, PinsThatLeaveNoRoomCloseThem) {
  // Laid out without: pins reach to p_min from the border.
  Design design = test::sample_design({}, halves(0.01, 0.01));
  design.parameters.joint = "holes";
  const PrintModel model = make_print_model(design);
  EXPECT_EQ(model.joints.closed, (std::vector<int>{0, 1, 2, 3}));
  for (const PrintBody& tile : model.tiles) EXPECT_TRUE(tile.cylinders.empty());
}

TEST(JointHoles, PinsMakeRoomAsFarAsTheirAreaLetsThem) {
  const test::SampleOptions o = halves(0.01, 0.01);
  auto bounds = [&](const Parameters& p) {
    const Design design = test::sample_design({}, o);
    return make_geometry(design.mesh, design.cuts, p);
  };
  Parameters wide = sewn(), plain;
  for (Parameters* p : {&wide, &plain}) p->A_pin_floor = p->A_pin_min = 8;
  const DesignGeometry with = bounds(wide), without = bounds(plain);
  const std::vector<Joint> joints = find_joints(with.tiles);
  int limited = 0;
  for (int i = 0; i < with.tiles.tile_count(); ++i) {
    for (int k = 0; k < 6; ++k) {
      const Side side = k < 3 ? Side::front : Side::back;
      const bool at_joint = std::any_of(joints.begin(), joints.end(), [&](const Joint& joint) {
        return (joint.tile[0] == i && joint.side[0] == k % 3) ||
               (joint.tile[1] == i && joint.side[1] == k % 3);
      });
      const double lower = with.pin_bounds.lower(i, k), before = without.pin_bounds.lower(i, k);
      EXPECT_LT(lower, with.pin_bounds.upper(i, k));
      if (!at_joint) {
        EXPECT_EQ(lower, before);
        EXPECT_EQ(with.pin_bounds.upper(i, k), without.pin_bounds.upper(i, k));
        continue;
      }
      ++limited;
      EXPECT_GT(lower, before);
      EXPECT_LT(lower, joint_inset(with.tiles, wide, i, side, k % 3));
      EXPECT_GE(pin_area(with.tiles, i, side, with.pin_bounds.lower.row(i).data()),
                wide.A_pin_floor);
    }
  }
  EXPECT_EQ(limited, 16);
  EXPECT_TRUE(with.pin_bounds.small.empty());
  EXPECT_EQ(with.pin_bounds.relaxed.size(), without.pin_bounds.relaxed.size());
}

TEST(JointHoles, WallsThatCannotBeAreRefused) {
  Parameters p = sewn();
  p.p_floor = 0.05;
  EXPECT_THROW(check_parameters(p), InvalidInput);
  p.joint = "none";
  EXPECT_NO_THROW(check_parameters(p));
  p = sewn();
  p.support = "breakaway";
  p.p_floor = 0.2;  // as deep as bridges enter
  EXPECT_THROW(check_parameters(p), InvalidInput);
  p.p_floor = 0.21;
  EXPECT_NO_THROW(check_parameters(p));
}

}  // namespace
}  // namespace curveups
