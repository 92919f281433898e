// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <set>

#include "curveups/bodies/clearance.hpp"
#include "curveups/bodies/convex_distance.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/design/print_constants.hpp"
#include "curveups/fabrication/body_mesh.hpp"
#include "curveups/fabrication/print_model.hpp"
#include "curveups/fabrication/supports.hpp"
#include "curveups/geometry/convex_polygon.hpp"
#include "support/designs.hpp"
#include "support/soundness.hpp"

namespace curveups {
namespace {

using test::expect_sound;

class Shapes : public ::testing::TestWithParam<std::array<double, 2>> {};

TEST_P(Shapes, AreSoundWithEveryKindOfBumpAndSupport) {
  for (const char* bumps : {"bumps", "dimples", "none"}) {
    for (const char* support : {"soluble", "breakaway", "none"}) {
      Parameters p;
      p.bumps = bumps;
      p.support = support;
      test::SampleOptions o;
      o.rows = 3;
      o.columns = 4;
      o.kx = GetParam()[0];
      o.ky = GetParam()[1];
      SCOPED_TRACE(std::string(bumps) + " " + support);
      const PrintModel model = make_print_model(test::sample_design(p, o));
      expect_sound(model);
      // Hollows need more room than bumps: where walls lean sharply three may not fit.
      const std::size_t contacts = model.geometry.tiles.contacts.size();
      const std::size_t most = p.bumps == "dimples" ? contacts / 10 : 0;
      EXPECT_LE(model.bumps.bare.size(), most);
      EXPECT_TRUE(model.loose_tiles.empty());
      EXPECT_EQ(model.loose_anchors, 0);
      EXPECT_GE(model.anchors.size(), 8u);
      EXPECT_NEAR(model.box.min().z(), 0, 1e-12);
      EXPECT_NEAR(model.box.max().z(), 2 * p.H_pin + p.H_body, 1e-12);
      EXPECT_NEAR((model.box.min() + model.box.max()).head<2>().norm(), 0, 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(FlatDomeSaddleBowl, Shapes,
                         ::testing::Values(std::array<double, 2>{0, 0},
                                           std::array<double, 2>{0.015, 0.015},
                                           std::array<double, 2>{0.015, -0.015},
                                           std::array<double, 2>{-0.015, -0.015}));

TEST(Bumps, InterleaveAndTouchTheFacingWallOnly) {
  const PrintModel model = make_print_model(test::sample_design());
  const TileMesh& tiles = model.geometry.tiles;
  std::vector<std::array<std::vector<CapSphere>, 2>> caps(tiles.contacts.size());
  std::vector<std::vector<Vec3>> centres(tiles.contacts.size());
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const RigidMotion motion = tiles.frame[i];
    for (const WallCap& cap : model.bumps.of_tile[i]) {
      const Contact& contact = tiles.contacts[cap.contact];
      const int s = contact.tile[0] == i ? 0 : 1;
      caps[cap.contact][s].push_back(
          cap_sphere(motion(cap.centre), motion.R * cap.axis, cap.radius, cap.height));
      centres[cap.contact].push_back(motion(cap.centre));
      // The apex reaches the wall that faces it, and nothing more.
      const int other = contact.tile[1 - s];
      const ConvexBody facing = moved(model.bumps.body[other], tiles.frame[other]);
      EXPECT_NEAR(distance(caps[cap.contact][s].back(), facing), 0, 1e-9);
    }
  }
  for (std::size_t k = 0; k < caps.size(); ++k) {
    EXPECT_GE(caps[k][0].size() + caps[k][1].size(), 3u);
    EXPECT_FALSE(caps[k][0].empty() || caps[k][1].empty());
    for (const CapSphere& a : caps[k][0]) {
      for (const CapSphere& b : caps[k][1]) EXPECT_GT(distance(a, b), 0.05);
    }
    const Vec3 spread = (centres[k][1] - centres[k][0]).cross(centres[k][2] - centres[k][0]);
    EXPECT_GT(spread.norm(), 0.5);
  }
}

// Points on a hollow, from its rim to its bottom.
std::vector<Vec3> sample_hollow(const WallCap& cap) {
  const double R = sphere_radius(cap.radius, cap.height);
  const Vec3 centre = cap.centre - (R - cap.height) * cap.axis;
  const Vec3 u = cap.axis.unitOrthogonal(), v = cap.axis.cross(u);
  const double rim = std::asin(cap.radius / R);
  std::vector<Vec3> points;
  for (int i = 0; i <= 8; ++i) {
    for (int j = 0; j < 24; ++j) {
      const double a = rim * i / 8, b = 2 * M_PI * j / 24;
      points.push_back(centre + R * (std::cos(a) * cap.axis +
                                     std::sin(a) * (std::cos(b) * u + std::sin(b) * v)));
    }
  }
  return points;
}

TEST(Dimples, LeaveMaterialToOtherFacesAndToOneAnother) {
  for (double k : {0.0, 0.02, -0.02}) {
    SCOPED_TRACE(k);
    Parameters p;
    p.bumps = "dimples";
    test::SampleOptions o;
    o.kx = o.ky = k;
    const PrintModel model = make_print_model(test::sample_design(p, o));
    EXPECT_TRUE(model.bumps.bare.empty());
    double least = 1e300;
    for (std::size_t i = 0; i < model.tiles.size(); ++i) {
      SCOPED_TRACE(i);
      std::vector<std::pair<int, std::vector<Vec3>>> hollows;
      for (const WallCap& cap : model.bumps.of_tile[i]) {
        if (!cap.bump) hollows.emplace_back(cap.wall, sample_hollow(cap));
      }
      for (const auto& [wall, points] : hollows) {
        double to_faces = 1e300, to_others = 1e300;
        for (const Vec3& q : points) {
          for (const BodyFace& face : model.bumps.body[i].faces) {
            if (face.tag == body_tag::wall + wall) continue;
            to_faces = std::min(to_faces, -face.plane.distance(q));
          }
          for (const auto& [other, theirs] : hollows) {
            if (&theirs == &points) continue;
            for (const Vec3& r : theirs) to_others = std::min(to_others, (q - r).norm());
          }
        }
        EXPECT_GT(to_faces, p.p_floor - 1e-6);
        EXPECT_GT(to_others, p.p_floor - 1e-6);
        least = std::min({least, to_faces, to_others});
      }
    }
    // Reported volumes are those of the solids, up to the distance of points on a hollow.
    double said = 1e300;
    for (const ThinFeature& thin : model.thin) {
      if (thin.what == "material beside a dimple") said = std::min(said, thin.size);
    }
    EXPECT_GT(said, p.p_floor - 1e-6);
    EXPECT_LT(said, least + 1e-6);
    EXPECT_GT(said, least - 0.02);
  }
}

Polygon seen_from_above(const PrintBody& body) {
  std::vector<Vec2> points;
  for (const Vec3& q : body.points) points.push_back(q.head<2>());
  return convex_hull(points);
}

TEST(Bridges, BreakWhereEveryPrinterStillPrints) {
  const auto neck = [](const Parameters& q) { return bridges().narrowest(q).size; };
  Parameters p;
  EXPECT_NEAR(neck(p), 0.4, 1e-12);  // the coarsest printer's smallest feature
  p.H_body = 0.9;                    // the bridge is as thin as the body allows
  EXPECT_NEAR(neck(p), 0.3, 1e-12);
  p = {};
  p.support = "breakaway";
  const PrintModel model = make_print_model(test::sample_design(p));
  for (const PrintBody& bridge : model.supports) {
    // From the notches' tips to the upper side.
    double tip = 0, high = 0;
    for (const Vec3& q : bridge.points) high = std::max(high, q.z());
    for (const Vec3& q : bridge.points) {
      if (q.z() < high - 1e-9) tip = std::max(tip, q.z());
    }
    EXPECT_NEAR(high - tip, neck(p), 1e-9) << bridge.name;
  }
}

// To the two bodies that it joins a bridge reaches; the layout's gap is between it and all others.
TEST(Bridges, KeepTheLayoutsGapFromThirdTiles) {
  for (const char* bumps : {"bumps", "dimples", "none"}) {
    SCOPED_TRACE(bumps);
    Parameters p;
    p.support = "breakaway";
    p.bumps = bumps;
    test::SampleOptions o;
    o.rows = 6;
    o.columns = 8;
    const PrintModel model = make_print_model(test::sample_design(p, o));
    EXPECT_TRUE(model.loose_tiles.empty());
    std::vector<ConvexBody> tiles;
    for (std::size_t i = 0; i < model.tiles.size(); ++i) {
      tiles.push_back(moved(model.bumps.body[i], model.flat[i]));
    }
    for (const PrintBody& bridge : model.supports) {
      const Eigen::AlignedBox3d box = bounding_box(bridge);
      const std::size_t n = bridge.points.size() / 2;  // on either of its upright sides
      std::vector<Vec2> outline;
      for (std::size_t k : {std::size_t{0}, n - 3, 2 * n - 3, n}) {
        outline.push_back(bridge.points[k].head<2>());
      }
      std::vector<double> gaps;
      for (const ConvexBody& tile : tiles) {
        double gap = 1e300;
        for (int k : {0, 2}) {
          const std::array<Vec2, 3> half = {outline[k], outline[k + 1], outline[(k + 2) % 4]};
          gap = std::min(gap, distance(make_prism(half, box.min().z(), box.max().z()), tile));
        }
        if (gap > 1e-9) gaps.push_back(gap);
      }
      EXPECT_GE(gaps.size(), tiles.size() - 2) << bridge.name;
      EXPECT_GE(*std::min_element(gaps.begin(), gaps.end()), p.d_gap_min - 1e-9) << bridge.name;
    }
  }
}

TEST(Bridges, NeverMeet) {
  test::SampleOptions o;
  o.rows = 6;
  o.columns = 8;
  Parameters p;
  p.support = "breakaway";
  const PrintModel model = make_print_model(test::sample_design(p, o));
  EXPECT_TRUE(model.loose_tiles.empty());
  EXPECT_EQ(model.loose_anchors, 0);
  for (std::size_t i = 0; i < model.supports.size(); ++i) {
    const Polygon a = seen_from_above(model.supports[i]);
    for (std::size_t j = 0; j < i; ++j) {
      const Polygon b = seen_from_above(model.supports[j]);
      double gap = intersection(a, b).size() >= 3 ? 0 : 1e300;
      for (const Vec2& q : a) gap = std::min(gap, distance(b, q));
      for (const Vec2& q : b) gap = std::min(gap, distance(a, q));
      EXPECT_GT(gap, 0.3 - 1e-9) << model.supports[i].name << ", " << model.supports[j].name;
    }
  }
}

// Prints weigh what is said, whichever file a slicer gets.
TEST(Meshes, OfCylindersHaveTheirVolume) {
  for (double deviation : {0.1, 0.02, 0.001}) {
    Parameters p;
    const PrintModel model = make_print_model(test::sample_design(p));
    ASSERT_FALSE(model.anchors.empty());
    for (const PrintBody& anchor : model.anchors) {
      const BodyMesh mesh = mesh_body(anchor, {deviation, true});
      EXPECT_NEAR(test::volume(mesh), volume(anchor), 1e-9 * volume(anchor));
      double corner = 0;
      for (const Vec3& q : mesh.points) {
        corner = std::max(corner, (q - anchor.circles[0].centre).head<2>().norm());
      }
      const double chord = corner * std::cos(2 * M_PI / mesh.points.size());
      EXPECT_LE(corner - p.anchor_radius, deviation);
      EXPECT_LE(p.anchor_radius - chord, deviation);
    }
  }
}

TEST(Bumps, NeverRecessBoundaryWallsAndLeaveTooSmallInterfacesBare) {
  Parameters p;
  p.bump_height = 1.1;
  const PrintModel model = make_print_model(test::sample_design(p));
  EXPECT_FALSE(model.bumps.bare.empty());
  for (const BareInterface& bare : model.bumps.bare) {
    const Contact& contact = model.geometry.tiles.contacts[bare.contact];
    for (int s = 0; s < 2; ++s) {
      EXPECT_EQ(model.bumps.recess(contact.tile[s], contact.side[s]), p.xy_compensation);
    }
  }
  const PrintModel standard = make_print_model(test::sample_design());
  const TileMesh& tiles = standard.geometry.tiles;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int t = 0; t < 3; ++t) {
      EXPECT_EQ(standard.bumps.recess(i, t), tiles.topology.neighbour(i, t) < 0 ? 0 : 0.125);
    }
  }
}

TEST(Anchors, MeetNothing) {
  test::SampleOptions o;
  o.rows = 6;
  o.columns = 8;
  Parameters p;
  const PrintModel model = make_print_model(test::sample_design(p, o));
  for (const PrintBody& a : model.anchors) {
    const Vec2 c = a.circles[0].centre.head<2>();
    for (const PrintBody& b : model.anchors) {
      if (&a == &b) continue;
      EXPECT_GT((b.circles[0].centre.head<2>() - c).norm(), 2 * p.anchor_radius + 0.4);
    }
    double nearest = 1e300;
    for (const PrintBody& tile : model.tiles) {
      for (const Vec3& q : tile.points) nearest = std::min(nearest, (q.head<2>() - c).norm());
    }
    EXPECT_GT(nearest, p.anchor_radius + anchor_distance - 1e-6);
    EXPECT_LT(nearest, p.anchor_radius + anchor_distance + p.L);
    EXPECT_DOUBLE_EQ(a.circles[1].centre.z(), 2 * p.H_pin + p.H_body);
  }
}

TEST(Orientation, FrontDownIsTheSamePrintTurnedOver) {
  Parameters p;
  p.support = "breakaway";
  const PrintModel up = make_print_model(test::sample_design(p));
  p.orientation = "front-down";
  const PrintModel down = make_print_model(test::sample_design(p));
  const std::vector<const PrintBody*> a = up.bodies("print"), b = down.bodies("print");
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(volume(*a[i]), volume(*b[i]), 1e-9 * volume(*a[i]));
    for (std::size_t k = 0; k < a[i]->points.size(); ++k) {
      const Vec3 &q = a[i]->points[k], &r = b[i]->points[k];
      EXPECT_LT((Vec3(q.x(), -q.y(), 5 - q.z()) - r).norm(), 1e-9);
    }
  }
  for (std::size_t i = 0; i < up.flat.size(); ++i) {  // proper motions, to the bodies' places
    EXPECT_NEAR(down.flat[i].R.determinant(), 1, 1e-12);
    EXPECT_NEAR(down.flat[i](Vec3::Zero()).z(), 5 - up.flat[i](Vec3::Zero()).z(), 1e-12);
  }
}

TEST(Pieces, HaveTheirOwnSlabsAndAnchorsOrAreRefused) {
  test::SampleOptions o;
  o.rows = 2;
  o.columns = 4;
  // A straight cut up the middle: columns of vertices 2, 7, 12.
  o.cuts.resize(2, 2);
  o.cuts << 2, 7, 7, 12;
  o.piece_offset = 40;
  const PrintModel model = make_print_model(test::sample_design({}, o));
  ASSERT_EQ(model.piece_count, 2);
  ASSERT_EQ(model.supports.size(), 2u);
  EXPECT_EQ(model.supports[1].name, "Support P2");
  expect_sound(model);
  o.piece_offset = 2;
  EXPECT_THROW(make_print_model(test::sample_design({}, o)), InfeasibleDesign);
}

TEST(PrintModel, NamesTilesWhosePinsTurnInsideOut) {
  Design design = test::sample_design();
  design.q.row(7).setConstant(4.0);
  try {
    make_print_model(design);
    FAIL();
  } catch (const InfeasibleDesign& error) {
    EXPECT_EQ(error.tiles(), std::vector<int>{7});
  }
}

TEST(PrintModelOf, SomeTilesAreTheseAtTheirPlaces) {
  const PrintModel all = make_print_model(test::sample_design());
  const PrintModel some = only_tiles(all, {7, 2, 7});
  ASSERT_EQ(some.bodies("print").size(), 2u);
  EXPECT_EQ(some.tiles[0].name, "T00003");
  EXPECT_EQ(some.tiles[1].points, all.tiles[7].points);
  EXPECT_NEAR(some.volume("print"), volume(all.tiles[2]) + volume(all.tiles[7]), 1e-9);
  EXPECT_LT((some.box.max() - some.box.min()).norm(), (all.box.max() - all.box.min()).norm());
}

}  // namespace
}  // namespace curveups
