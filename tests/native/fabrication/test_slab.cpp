// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <set>

#include "curveups/core/errors.hpp"
#include "curveups/fabrication/slab.hpp"
#include "support/designs.hpp"
#include "support/soundness.hpp"

namespace curveups {
namespace {

using test::expect_sound;
using test::unsound;
using test::watertight;

double polygon_area(const PrintBody& body, const PlanarFace& face) {
  double sum = 0;
  const std::vector<int>& loop = face.outer.points;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    sum +=
        0.5 * face.normal.z() *
        wedge(body.points[loop[k]].head<2>(), body.points[loop[(k + 1) % loop.size()]].head<2>());
  }
  return sum;
}

// Walls of the outer loop, which are the slab's first faces.
double outline_area(const PrintBody& slab) {
  double sum = 0;
  for (const PlanarFace& wall : slab.faces) {
    const int a = wall.outer.points[0], b = wall.outer.points[1];
    sum += 0.5 * wedge(slab.points[a].head<2>(), slab.points[b].head<2>());
    if (b == slab.faces[0].outer.points[0]) break;
  }
  return sum;
}

// Top and bottom in triangles, but for rings around bores, which have a hole; every edge of the
// body between two faces, there and back.
void expect_divided(const PrintBody& slab, std::size_t bores) {
  std::set<std::pair<int, int>> edges;
  std::size_t rings = 0, parts = 0;
  double top = 0;
  for (const PlanarFace& face : slab.faces) {
    for (int i : face.outer.points) top = std::max(top, slab.points[i].z());
  }
  for (const PlanarFace& face : slab.faces) {
    auto add_edges = [&](const BodyLoop& loop) {
      for (std::size_t k = 0; k < loop.points.size(); ++k) {
        const int a = loop.points[k], b = loop.points[(k + 1) % loop.points.size()];
        EXPECT_TRUE(edges.insert({a, b}).second);
      }
    };
    add_edges(face.outer);
    for (const BodyLoop& loop : face.inner) add_edges(loop);
    const double z = slab.points[face.outer.points[0]].z();
    const bool lid = face.normal.z() > 0.5 && z == top, bottom = face.normal.z() < -0.5 && z == 0;
    if (!lid && !bottom) continue;
    ++parts;
    if (!face.inner.empty()) {
      ++rings;
      ASSERT_EQ(face.inner.size(), 1u);
      EXPECT_GE(face.inner[0].circle, 0);
      continue;
    }
    const std::vector<int>& loop = face.outer.points;
    EXPECT_EQ(loop.size(), 3u);
  }
  for (const auto& [a, b] : edges) EXPECT_TRUE(edges.count({b, a}));
  EXPECT_EQ(rings, 2 * bores);
  EXPECT_GT(parts, rings);
  EXPECT_EQ(unsound({slab}), "");
  EXPECT_TRUE(watertight(mesh_body(slab, {0.02, true})));
}

TEST(Slab, IsItsBoxLessWhatItSurrounds) {
  for (const auto& [H_pin, drop] : {std::array{1.0, 0.3}, std::array{0.4, 0.2}}) {
    Parameters p;
    p.H_pin = H_pin;
    SCOPED_TRACE(H_pin);
    const PrintModel model = make_print_model(test::sample_design(p));
    EXPECT_EQ(unsound(model.supports), "");
    ASSERT_EQ(model.supports.size(), 1u);
    const PrintBody& slab = model.supports[0];
    const double top = 2 * p.H_pin + p.H_body - drop;
    double removed = model.anchors.size() * M_PI * p.anchor_radius * p.anchor_radius * top;
    for (const PrintBody& tile : model.tiles) {
      double front_pin = 0, front = 0;
      for (const PlanarFace& face : tile.faces) {
        if (face.role == FaceRole::front_pin && face.normal.z() > 0.5) {
          front_pin = polygon_area(tile, face);
        }
        if (face.role == FaceRole::front) front = polygon_area(tile, face);
      }
      removed += volume(tile) - front_pin * p.H_pin + front * (top - p.H_pin - p.H_body);
    }
    const double outline = outline_area(slab);
    EXPECT_NEAR(volume(slab), outline * top - removed, 1e-6 * outline);
  }
}

TEST(Slab, HasATopAndABottomOfTriangles) {
  const PrintModel model = make_print_model(test::sample_design());
  expect_divided(model.supports[0], model.anchors.size());
}

TEST(Slab, AroundOneTile) {
  test::SampleOptions o;
  o.rows = o.columns = 1;
  o.keep = [](const Vec2& centre) { return centre.x() < 0; };
  for (bool anchors : {true, false}) {
    Parameters p;
    p.anchors = anchors;
    const PrintModel model = make_print_model(test::sample_design(p, o));
    ASSERT_EQ(model.tiles.size(), 1u);
    EXPECT_EQ(model.anchors.empty(), !anchors);
    expect_divided(model.supports[0], model.anchors.size());
  }
}

TEST(Slab, AroundARingOfTilesIsOpenInside) {
  test::SampleOptions o;
  o.rows = 8;
  o.columns = 8;
  o.keep = [](const Vec2& centre) { return centre.norm() > 18; };
  Parameters p;
  p.anchors = false;
  const PrintModel model = make_print_model(test::sample_design(p, o));
  const PrintBody& slab = model.supports[0];
  expect_divided(slab, 0);
  expect_sound(model);
  // No face covers the middle, which the outline encloses.
  for (const Vec3& q : slab.points) EXPECT_GT(q.head<2>().norm(), 10);
  double top = 0;
  for (const PlanarFace& face : slab.faces) {
    if (face.normal.z() < -0.5 && slab.points[face.outer.points[0]].z() == 0) {
      top += polygon_area(slab, face);
    }
  }
  double feet = 0;
  for (const PrintBody& tile : model.tiles) {
    for (const PlanarFace& face : tile.faces) {
      if (face.role == FaceRole::foot) feet += polygon_area(tile, face);
    }
  }
  EXPECT_LT(top, outline_area(slab) - feet - M_PI * 100);
}

TEST(Slab, LeavesAThousandthBetweenBores) {
  const double gap = 1e-3, r = 3;
  const std::vector<Polygon> outline{
      {{-r - gap, -r - gap}, {3 * r + 2 * gap, -r - gap}, {3 * r + 2 * gap, 9}, {-r - gap, 9}}};
  const PrintBody slab = make_slab(outline, {}, {{0, 0}, {2 * r + gap, 0}}, r, 4);
  const double exact = 4 * ((4 * r + 3 * gap) * (9 + r + gap) - 2 * M_PI * r * r);
  EXPECT_NEAR(volume(slab), exact, 1e-9 * exact);
  EXPECT_EQ(unsound({slab}), "");
  EXPECT_TRUE(watertight(mesh_body(slab, {1e-5, true})));
  EXPECT_THROW(make_slab(outline, {}, {{0, 0}, {2 * r - gap, 0}}, r, 4), TopologyError);
}

TEST(Slab, IsLeftOutWhereBodiesRunIntoOneAnother) {
  Design design = test::sample_design();
  design.T.row(0) = design.T.row(1);
  const PrintModel model = make_print_model(design);
  EXPECT_TRUE(model.supports.empty());
  EXPECT_EQ(model.loose_tiles.size(), model.tiles.size());
  EXPECT_EQ(model.loose_anchors, static_cast<int>(model.anchors.size()));
  EXPECT_EQ(unsound(model.tiles), "");
}

}  // namespace
}  // namespace curveups
