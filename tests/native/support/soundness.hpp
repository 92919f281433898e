// SPDX-License-Identifier: LGPL-2.1-or-later
// What tests demand of every body of a print.
#pragma once

#include <gtest/gtest.h>

#include <map>

#include "curveups/bodies/body_checks.hpp"
#include "curveups/bodies/clearance.hpp"
#include "curveups/fabrication/body_mesh.hpp"
#include "curveups/fabrication/print_model.hpp"

namespace curveups::test {

inline std::string unsound(const std::vector<PrintBody>& bodies) {
  std::string text;
  for (const PrintBody& body : bodies) {
    const std::string reason = unsoundness(body);
    if (!reason.empty()) text += body.name + " " + reason + "; ";
  }
  return text;
}

inline double volume(const BodyMesh& mesh) {
  double sum = 0;
  const Vec3 o = mesh.points[0];
  for (const auto& t : mesh.triangles) {
    sum += (mesh.points[t[0]] - o).cross(mesh.points[t[1]] - o).dot(mesh.points[t[2]] - o);
  }
  return sum / 6;
}

// Every edge twice, in opposite directions.
inline bool watertight(const BodyMesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end() || back->second != 1) return false;
  }
  return !edges.empty();
}

inline void expect_sound(const PrintModel& model) {
  EXPECT_EQ(unsound(model.tiles), "");
  EXPECT_EQ(unsound(model.supports), "");
  EXPECT_EQ(unsound(model.anchors), "");
  for (const auto* bodies : {&model.tiles, &model.supports, &model.anchors}) {
    for (const PrintBody& body : *bodies) {
      const BodyMesh fine = mesh_body(body, {0.002, true});
      EXPECT_TRUE(watertight(fine)) << body.name;
      EXPECT_NEAR(volume(fine), volume(body), 5e-3 * volume(body)) << body.name;
      EXPECT_TRUE(watertight(mesh_body(body, {0.02, false}))) << body.name;
    }
  }
  EXPECT_LE(max_overlap_actuated(model).value, 1e-6);
  EXPECT_GT(min_clearance_flat(model).value, 0.05);
}

}  // namespace curveups::test
