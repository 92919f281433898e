// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <map>

#include "curveups/core/errors.hpp"
#include "curveups/physics/membrane_mesh.hpp"
#include "support/designs.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

using test::hexagon;
using test::spread_design;

constexpr double size = 2.8;  // mm

struct Flat {
  Design design;
  TileMesh tiles;
  MembraneDomain domain;
  Points2 corners;
};

Flat make_flat(Design design, Side side) {
  Flat out;
  out.tiles = make_tile_mesh(design.mesh, design.cuts, design.parameters.H_body);
  out.domain = make_membrane_domain(out.tiles, side);
  out.corners = flat_pin_corners(out.tiles, fit_poses(out.tiles, design.T), design.q, side);
  out.design = std::move(design);
  return out;
}

double polygon_area(const MembranePatch& patch, const Points2& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < patch.corners.size(); ++i) {
    const Vec2 a = corners.row(patch.corners[i]),
               b = corners.row(patch.corners[(i + 1) % patch.corners.size()]);
    sum += 0.5 * wedge(a, b);
  }
  return sum;
}

TEST(MembraneDomain, BridgesContactsAndClosesUncutInteriorVertices) {
  Design design = spread_design(hexagon(3, test::cap_height), 1.4, 1.0);
  const Flat whole = make_flat(design, Side::front);
  // 37 vertices, 18 of them on the boundary; 54 tiles, 72 interior edges.
  EXPECT_EQ(whole.tiles.tile_count(), 54);
  EXPECT_EQ(whole.domain.patches.size(), 72u + 19u);
  for (const MembranePatch& patch : whole.domain.patches) {
    EXPECT_GT(polygon_area(patch, whole.corners), 0);
    EXPECT_EQ(patch.corners.size(), patch.contact >= 0 ? 4u : 6u);
  }
  // A cut opens its two vertices and its contact.
  const MeshEdge& edge = whole.tiles.topology.edges[whole.tiles.contacts[30].edge];
  design.cuts.resize(1, 2);
  design.cuts << edge.v[0], edge.v[1];
  const Flat cut = make_flat(design, Side::front);
  int opened = 0;
  for (const MembranePatch& patch : whole.domain.patches) {
    opened += patch.vertex == edge.v[0] || patch.vertex == edge.v[1];
  }
  EXPECT_EQ(cut.domain.patches.size(), whole.domain.patches.size() - 1 - opened);
}

TEST(MembraneMesh, FillsEveryPatchOnBothSidesAndSharesItsSides) {
  const Design design = spread_design(hexagon(3, test::saddle_height), 1.5, 1.0);
  for (Side side : {Side::front, Side::back}) {
    const Flat flat = make_flat(design, side);
    const MembraneMesh mesh = make_membrane_mesh(flat.domain, flat.corners, size);
    const Points2 x = vertex_positions(mesh.weights, flat.corners);
    std::vector<double> area(flat.domain.patches.size(), 0);
    std::map<std::pair<int, int>, int> edges;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto [a, b, c] = mesh.triangles[t];
      const double part =
          0.5 * wedge((x.row(b) - x.row(a)).transpose(), (x.row(c) - x.row(a)).transpose());
      EXPECT_GT(part, 0);
      area[mesh.patch[t]] += part;
      for (const auto& [u, v] : {std::pair(a, b), {b, c}, {c, a}}) ++edges[std::minmax(u, v)];
    }
    for (std::size_t p = 0; p < area.size(); ++p) {
      EXPECT_NEAR(area[p], polygon_area(flat.domain.patches[p], flat.corners), 1e-9);
    }
    // Component without gaps: edges of one triangle lie on pins or on free outer sides.
    for (const auto& [edge, count] : edges) {
      EXPECT_LE(count, 2);
      EXPECT_LE((x.row(edge.first) - x.row(edge.second)).norm(), 1.3 * size);
    }
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      double sum = 0;
      for (int k = mesh.weights.start[v]; k < mesh.weights.start[v + 1]; ++k) {
        sum += mesh.weights.weight[k];
        EXPECT_TRUE(mesh.pin[v] < 0 || mesh.weights.corner[k] / 3 == mesh.pin[v]);
      }
      EXPECT_NEAR(sum, 1, 1e-12);
    }
  }
}

TEST(MembraneMesh, RefinementIsNestedAndKeepsAreaAndPins) {
  const Flat flat = make_flat(spread_design(hexagon(2, test::cap_height), 1.4, 1.0), Side::back);
  const MembraneMesh coarse = make_membrane_mesh(flat.domain, flat.corners, size);
  const MembraneMesh fine = refine_mesh(coarse);
  EXPECT_EQ(fine.triangles.size(), 4 * coarse.triangles.size());
  const Points2 x = vertex_positions(coarse.weights, flat.corners),
                y = vertex_positions(fine.weights, flat.corners);
  EXPECT_LT((x - y.topRows(x.rows())).cwiseAbs().maxCoeff(), 1e-12);
  for (std::size_t k = 0; k < fine.parents.size(); ++k) {
    const auto [a, b] = fine.parents[k];
    EXPECT_LT((y.row(x.rows() + k) - 0.5 * (x.row(a) + x.row(b))).norm(), 1e-12);
    const int pin = fine.pin[x.rows() + k];
    EXPECT_EQ(pin >= 0, coarse.pin[a] >= 0 && coarse.pin[a] == coarse.pin[b]);
  }
}

TEST(MembraneMesh, RefusesLengthsOfAnotherUnitInsteadOfEndlessWork) {
  const Flat flat = make_flat(spread_design(hexagon(2, test::cap_height), 1.4, 1.0), Side::front);
  EXPECT_THROW(make_membrane_mesh(flat.domain, 1000 * flat.corners, size), InvalidInput);
}

TEST(MembraneMesh, NamesTilesThatCannotBe) {
  Design design = spread_design(hexagon(2, test::cap_height), 1.4, 1.0);
  design.q.row(5).setConstant(4);
  try {
    make_flat(design, Side::front);
    FAIL();
  } catch (const InfeasibleDesign& error) {
    EXPECT_EQ(error.tiles(), std::vector<int>{5});
    EXPECT_NE(std::string(error.what()).find("T00006"), std::string::npos);
  }
  const Flat folded = make_flat(spread_design(hexagon(2, test::cap_height), 0.6, 0.2), Side::front);
  EXPECT_THROW(make_membrane_mesh(folded.domain, folded.corners, size), InfeasibleDesign);
}

}  // namespace
}  // namespace curveups
