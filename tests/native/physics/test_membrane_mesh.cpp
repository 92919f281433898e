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
    const MembraneMesh mesh = make_membrane_mesh(flat.domain, flat.corners, {});
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
    // One component without gaps: edges of one triangle lie on pins or on free outer sides.
    for (const auto& [edge, count] : edges) EXPECT_LE(count, 2);
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
  const MembraneMesh coarse = make_membrane_mesh(flat.domain, flat.corners, {});
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

// Points of each patch's triangles, in their order.
std::vector<std::vector<Vec2>> triangles_by_patch(const Flat& flat, const MembraneMesh& mesh) {
  const Points2 at = vertex_positions(mesh.weights, flat.corners);
  std::vector<std::vector<Vec2>> out(flat.domain.patches.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int v : mesh.triangles[t]) out[mesh.patch[t]].push_back(at.row(v).transpose());
  }
  return out;
}

TEST(MembraneMesh, HalvesSizesAroundChosenTilesOnly) {
  const Flat flat = make_flat(spread_design(hexagon(3, test::cap_height), 1.4, 1.0), Side::front);
  const int chosen = 20;
  MembraneMeshOptions finer;
  finer.halvings.assign(flat.tiles.tile_count(), 0);
  finer.halvings[chosen] = 1;
  const MembraneMesh mesh = make_membrane_mesh(flat.domain, flat.corners, finer);
  const auto before = triangles_by_patch(flat, make_membrane_mesh(flat.domain, flat.corners, {})),
             after = triangles_by_patch(flat, mesh);
  auto at_chosen = [&](const MembranePatch& patch) {
    const std::vector<int> tiles = tiles_of(patch);
    return std::find(tiles.begin(), tiles.end(), chosen) != tiles.end();
  };
  auto has_side = [](const MembranePatch& patch, int a, int b) {
    const std::size_t n = patch.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (patch.corners[i] == a && patch.corners[(i + 1) % n] == b) return true;
    }
    return false;
  };
  double coarse_edge = 0, fine_edge = 0;
  int halved = 0, kept = 0;
  for (std::size_t p = 0; p < after.size(); ++p) {
    const MembranePatch& patch = flat.domain.patches[p];
    if (at_chosen(patch)) {
      ++halved;
      for (std::size_t k = 0; k < after[p].size(); ++k) {
        const std::size_t next = k % 3 == 2 ? k - 2 : k + 1;
        fine_edge = std::max(fine_edge, (after[p][next] - after[p][k]).norm());
      }
      for (std::size_t k = 0; k < before[p].size(); ++k) {
        const std::size_t next = k % 3 == 2 ? k - 2 : k + 1;
        coarse_edge = std::max(coarse_edge, (before[p][next] - before[p][k]).norm());
      }
      EXPECT_GT(after[p].size(), 2 * before[p].size());
      continue;
    }
    bool beside = false;
    for (const MembranePatch& other : flat.domain.patches) {
      if (!at_chosen(other)) continue;
      for (std::size_t i = 0; i < patch.corners.size(); ++i) {
        beside |= has_side(other, patch.corners[(i + 1) % patch.corners.size()], patch.corners[i]);
      }
    }
    if (beside) continue;
    ++kept;
    EXPECT_EQ(after[p], before[p]) << p;
  }
  EXPECT_EQ(halved, 6);  // three contacts and three vertices
  EXPECT_GT(kept, 60);
  EXPECT_LT(fine_edge, 0.7 * coarse_edge);
  // Sides between patches have the same vertices on either side: edges of one triangle lie on pins
  // or on the outer border alone.
  std::map<std::pair<int, int>, int> sides;
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) ++sides[std::minmax(t[k], t[next3(k)])];
  }
  std::map<std::pair<int, int>, int> uses;  // of sides between pin corners
  for (const MembranePatch& patch : flat.domain.patches) {
    for (std::size_t i = 0; i < patch.corners.size(); ++i) {
      ++uses[std::minmax(patch.corners[i], patch.corners[(i + 1) % patch.corners.size()])];
    }
  }
  int between = 0;
  for (const auto& [edge, count] : sides) {
    std::vector<int> corners;  // that both ends are combined of
    for (int v : {edge.first, edge.second}) {
      for (int k = mesh.weights.start[v]; k < mesh.weights.start[v + 1]; ++k) {
        corners.push_back(mesh.weights.corner[k]);
      }
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    const auto side = corners.size() == 2 ? uses.find({corners[0], corners[1]}) : uses.end();
    EXPECT_EQ(count, side == uses.end() ? 2 : side->second);
    between += side != uses.end() && side->second == 2;
  }
  EXPECT_GT(between, 100);
  double area = 0, patches = 0;
  for (const std::vector<Vec2>& points : after) {
    for (std::size_t k = 0; k < points.size(); k += 3) {
      area += 0.5 * wedge(Vec2(points[k + 1] - points[k]), Vec2(points[k + 2] - points[k]));
    }
  }
  for (const MembranePatch& patch : flat.domain.patches)
    patches += polygon_area(patch, flat.corners);
  EXPECT_NEAR(area, patches, 1e-9 * patches);
  finer.halvings.back() = 30;  // more triangles than memory holds
  EXPECT_THROW(make_membrane_mesh(flat.domain, flat.corners, finer), InvalidInput);
}

TEST(MembraneMesh, RefusesLengthsOfAnotherUnitInsteadOfEndlessWork) {
  const Flat flat = make_flat(spread_design(hexagon(2, test::cap_height), 1.4, 1.0), Side::front);
  EXPECT_THROW(make_membrane_mesh(flat.domain, 1000 * flat.corners, {}), InvalidInput);
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
  EXPECT_THROW(make_membrane_mesh(folded.domain, folded.corners, {}), InfeasibleDesign);
}

}  // namespace
}  // namespace curveups
