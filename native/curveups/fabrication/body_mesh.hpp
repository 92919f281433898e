// SPDX-License-Identifier: LGPL-2.1-or-later
// Watertight triangle meshes of bodies.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "curveups/bodies/print_body.hpp"

namespace curveups {

struct BodyMesh {
  std::string name;
  BodyKind kind = BodyKind::tile;
  int piece = 0;
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise seen from outside
};

struct MeshingOptions {
  double deviation = 0.02;  // mm, of chords and facets from circles and spheres
  bool caps = true;         // false: flat walls instead of bumps and hollows
};

// Faces share their points: every edge belongs to two triangles, in opposite directions.
BodyMesh mesh_body(const PrintBody& body, const MeshingOptions& options);

// Meshes all bodies in parallel. Throws Cancelled.
std::vector<BodyMesh> mesh_bodies(const std::vector<const PrintBody*>& bodies,
                                  const MeshingOptions& options);

}  // namespace curveups
