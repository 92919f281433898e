// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/layout/cut_suggestions.hpp"
#include "curveups/layout/initial_layout.hpp"
#include "curveups/layout/layout.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

const Edges no_cuts(0, 2);

// A finger: a tube of six-sided rings with a round tip, open below. The tip maps to next to
// nothing.
TriangleMesh finger(int rings, double radius = 14, double L = 7) {
  const int around = 12;
  TriangleMesh mesh;
  mesh.V.resize(1 + around * (rings + 2), 3);
  mesh.V.row(0) << 0, 0, radius;
  for (int r = 0; r < rings + 2; ++r) {
    const double polar = 0.25 * 3.14159265 * std::min(r + 1, 2);
    const double z = r < 2 ? radius * std::cos(polar) : -L * (r - 1);
    for (int k = 0; k < around; ++k) {
      const double a = 2 * 3.14159265 * (k + 0.5 * (r % 2)) / around;
      mesh.V.row(1 + r * around + k) << radius * std::sin(polar) * std::cos(a),
          radius * std::sin(polar) * std::sin(a), z;
    }
  }
  mesh.F.resize(around * (1 + 2 * (rings + 1)), 3);
  int f = 0;
  for (int k = 0; k < around; ++k) mesh.F.row(f++) << 0, 1 + k, 1 + (k + 1) % around;
  for (int r = 0; r + 1 < rings + 2; ++r) {
    for (int k = 0; k < around; ++k) {
      const int n = (k + 1) % around, top = 1 + r * around, low = top + around;
      if (r % 2 == 0) {
        mesh.F.row(f++) << top + k, low + k, top + n;
        mesh.F.row(f++) << top + n, low + k, low + n;
      } else {
        mesh.F.row(f++) << top + k, low + k, low + n;
        mesh.F.row(f++) << top + k, low + n, top + n;
      }
    }
  }
  return mesh;
}

// Every suggested edge is an interior edge that is cut once, and the paths split nothing.
void expect_slits(const TriangleMesh& mesh, const std::vector<CutSuggestion>& cuts) {
  std::set<std::pair<int, int>> seen;
  Edges all(0, 2);
  for (const CutSuggestion& cut : cuts) {
    ASSERT_GT(cut.edges.rows(), 0);
    EXPECT_NEAR(cut.length, length_of(mesh, cut.edges), 1e-12);
    EXPECT_FALSE(cut.reasons.empty());
    for (int e = 0; e < cut.edges.rows(); ++e) {
      EXPECT_TRUE(seen.insert(std::minmax(cut.edges(e, 0), cut.edges(e, 1))).second);
    }
    Edges longer(all.rows() + cut.edges.rows(), 2);
    longer << all, cut.edges;
    all = longer;
  }
  const TileMesh tiles = make_tile_mesh(mesh, all, 3);  // throws where an edge is not interior
  EXPECT_EQ(std::count(tiles.cut.begin(), tiles.cut.end(), 1), all.rows());
  EXPECT_EQ(pieces_of(tiles).size(), 1u);
}

TEST(CutCandidates, TheTipOfAFingerAsksForACutToTheRim) {
  const TriangleMesh mesh = finger(8);
  const TileMesh tiles = make_tile_mesh(mesh, no_cuts, 3);
  const Eigen::VectorXd scale = relative_scale(tiles);
  EXPECT_LT(scale.head(12).maxCoeff(), 0.2);  // the tip's own faces
  const auto found = cut_candidates(tiles, scale, {});
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].reason.kind, "cut.tip");
  const Edges& edges = found[0].edges;
  // From the rim, ring by ring, to the tip.
  EXPECT_GE(edges(0, 0), 1 + 12 * 9);
  EXPECT_LE(edges(edges.rows() - 1, 1), 12);
  EXPECT_GE(edges.rows(), 8);
}

TEST(CutCandidates, AFlatPatchAsksForNone) {
  const TileMesh tiles = make_tile_mesh(test::flat_patch(6), no_cuts, 3);
  const Eigen::VectorXd scale = relative_scale(tiles);
  EXPECT_NEAR(scale_spread(scale), 1, 1e-6);
  EXPECT_TRUE(cut_candidates(tiles, scale, {}).empty());
}

TEST(CutCandidates, AWeakContactIsCutItself) {
  const TriangleMesh mesh = test::flat_patch(6);
  const TileMesh tiles = make_tile_mesh(mesh, no_cuts, 3);
  // The contact whose edge lies nearest to the middle.
  const Contact* middle = nullptr;
  for (const Contact& contact : tiles.contacts) {
    auto distance = [&](const Contact& c) {
      const MeshEdge& e = tiles.topology.edges[c.edge];
      return (mesh.V.row(e.v[0]) + mesh.V.row(e.v[1])).norm();
    };
    if (!middle || distance(contact) < distance(*middle)) middle = &contact;
  }
  const auto found = cut_candidates(tiles, relative_scale(tiles), {middle->tile});
  ASSERT_EQ(found.size(), 1u);
  const TileMesh cut = make_tile_mesh(mesh, found[0].edges, 3);
  EXPECT_TRUE(cut.cut[middle->edge]);
  EXPECT_EQ(pieces_of(cut).size(), 1u);
}

TEST(CutCandidates, AHoleIsJoinedToTheRim) {
  TriangleMesh mesh = test::flat_patch(8);
  Triangles rest(mesh.F.rows() - 1, 3);
  const int gone = static_cast<int>(mesh.F.rows()) / 2 + 8;
  rest << mesh.F.topRows(gone), mesh.F.bottomRows(mesh.F.rows() - gone - 1);
  mesh.F = rest;
  const TileMesh tiles = make_tile_mesh(mesh, no_cuts, 3);
  const auto found = cut_candidates(tiles, relative_scale(tiles), {});
  const auto hole = std::find_if(found.begin(), found.end(),
                                 [](const CutCandidate& c) { return c.reason.kind == "cut.hole"; });
  ASSERT_NE(hole, found.end());
  const TileMesh cut = make_tile_mesh(mesh, hole->edges, 3);
  const auto pieces = cut_into_pieces(cut.mesh, cut.topology, cut.cut);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(boundary_loops(build_topology(pieces[0].mesh.F)).size(), 1u);
}

TEST(CutSuggestions, RelieveAFingerAsPredicted) {
  const Parameters p;
  const TriangleMesh mesh = finger(6);
  CutSuggestionOptions options;
  options.most = 2;
  const CutSuggestions found = suggest_cuts(mesh, no_cuts, p, options, {});
  EXPECT_FALSE(found.solve.stopped());
  ASSERT_GE(found.cuts.size(), 1u);
  ASSERT_LE(found.cuts.size(), 2u);
  expect_slits(mesh, found.cuts);
  const CutSuggestion& first = found.cuts[0];
  ASSERT_TRUE(first.after.has_value());
  // A full solve agrees with the prediction up to the accuracy of a draft.
  const DesignGeometry geometry = make_geometry(mesh, first.edges, p);
  const LayoutResult full = solve_layout(geometry, p, {});
  EXPECT_TRUE(full.solve.converged());
  const LayoutFigures figures = layout_figures(geometry, p, full.poses, full.q);
  EXPECT_NEAR(first.after->scale_spread, figures.scale_spread, 1e-9);
  EXPECT_NEAR(first.after->energy, figures.energy, 0.25 * figures.energy);
  EXPECT_NEAR(first.after->area_ratio, figures.area_ratio, 0.1 * figures.area_ratio);
  // And it is worth it.
  const DesignGeometry uncut = make_geometry(mesh, no_cuts, p);
  const Eigen::VectorXd before = relative_scale(uncut.tiles);
  EXPECT_LT(figures.scale_spread, 0.5 * scale_spread(before));
}

TEST(CutSuggestions, OpenAClosedSurfaceFirst) {
  const TriangleMesh mesh = test::sphere(4, 20);
  Parameters p;
  CutSuggestionOptions options;
  options.most = 3;
  const CutSuggestions found = suggest_cuts(mesh, no_cuts, p, options, {});
  ASSERT_GE(found.cuts.size(), 2u);
  EXPECT_EQ(found.cuts[0].reasons[0].kind, "cut.opens");
  EXPECT_FALSE(found.cuts[0].before.has_value());
  expect_slits(mesh, found.cuts);
  for (std::size_t k = 1; k < found.cuts.size(); ++k) {
    ASSERT_TRUE(found.cuts[k].before && found.cuts[k].after);
    EXPECT_EQ(found.cuts[k].before->energy, found.cuts[k - 1].after->energy);
    EXPECT_LT(found.cuts[k].after->energy, 0.97 * found.cuts[k].before->energy);
  }
  // The first ones of a longer list are the shorter list.
  options.most = 1;
  const CutSuggestions one = suggest_cuts(mesh, no_cuts, p, options, {});
  ASSERT_EQ(one.cuts.size(), 1u);
  EXPECT_EQ(one.cuts[0].edges, found.cuts[0].edges);
}

TEST(CutSuggestions, FindNothingWhereNothingHelps) {
  const Parameters p;
  CutSuggestionOptions options;
  options.most = 3;
  EXPECT_TRUE(suggest_cuts(test::flat_patch(5), no_cuts, p, options, {}).cuts.empty());
  options.most = 0;
  EXPECT_TRUE(suggest_cuts(finger(6), no_cuts, p, options, {}).cuts.empty());
}

}  // namespace
}  // namespace curveups
