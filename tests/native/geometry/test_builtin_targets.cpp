// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <map>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/builtin_targets.hpp"
#include "curveups/geometry/conformal_map.hpp"
#include "curveups/geometry/mesh_checks.hpp"

namespace curveups {
namespace {

TEST(BuiltinTargets, AllAreSoundSurfacesOfTheSizeOfAHand) {
  const std::map<std::string, double> area = {{"half-sphere", 144.76}, {"hyperboloid", 128}};
  EXPECT_EQ(builtin_targets().size(), 9u);
  for (const BuiltinTarget& target : builtin_targets()) {
    SCOPED_TRACE(target.name);
    EXPECT_FALSE(target.meaning.empty());
    const TriangleMesh mesh = builtin_target(target.name, 0.02);
    EXPECT_TRUE(check_mesh(mesh, 7, false).empty());
    const double cm2 = surface_area(mesh) / 100;
    EXPECT_GT(cm2, 100);
    EXPECT_LT(cm2, 450);
    if (area.count(target.name) != 0) {
      EXPECT_NEAR(cm2, area.at(target.name), 3);
    }
    const auto loops = boundary_loops(build_topology(mesh.F));
    EXPECT_EQ(loops.size(), target.name == "mask" ? 3u : 1u);
    EXPECT_GT(conformal_scale(mesh, conformal_map(mesh)).minCoeff(), 0);
  }
}

TEST(BuiltinTargets, HalfSphereIsExact) {
  const TriangleMesh mesh = builtin_target("half-sphere");
  const MeshTopology topology = build_topology(mesh.F);
  for (int v = 0; v < mesh.V.rows(); ++v) EXPECT_NEAR(mesh.V.row(v).norm(), 48, 1e-9);
  for (const MeshEdge& edge : topology.edges) {
    if (edge.boundary()) {
      EXPECT_NEAR(mesh.V(edge.v[0], 2), 0, 1e-9);
    }
  }
  for (int f = 0; f < mesh.F.rows(); ++f) {
    const Vec3 a = mesh.V.row(mesh.F(f, 0)), b = mesh.V.row(mesh.F(f, 1)),
               c = mesh.V.row(mesh.F(f, 2));
    const Vec3 centroid = (a + b + c) / 3;
    EXPECT_LT(48 - centroid.norm(), 0.0035);
    EXPECT_GT(centroid.dot(face_area_vector(mesh, f)), 0);  // fronts outward
  }
}

TEST(BuiltinTargets, CylinderPatchIsDevelopable) {
  const TriangleMesh mesh = builtin_target("cylinder-patch", 0.01);
  const Eigen::VectorXd scale = conformal_scale(mesh, conformal_map(mesh));
  EXPECT_NEAR(scale.minCoeff(), 1, 1e-3);
  EXPECT_NEAR(scale.maxCoeff(), 1, 1e-3);
}

TEST(BuiltinTargets, RefusesUnknownNamesAndTolerances) {
  EXPECT_THROW(builtin_target("teapot"), InvalidInput);
  EXPECT_THROW(builtin_target("disc", 0), InvalidInput);
  EXPECT_THROW(builtin_target("disc", std::nan("")), InvalidInput);
}

}  // namespace
}  // namespace curveups
