// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of tiles and interfaces by one vertex of the mesh: the few tiles around it are built
// anew by the code that builds all of them. Frames, faces, folds, truncation planes and interfaces
// are closed forms of some thirty neighbouring vertices, of which one is varied.
#pragma once

#include <functional>
#include <vector>

#include "curveups/design/design.hpp"

namespace curveups {

// Tiles and interfaces around a vertex, numbered as in a mesh of their own.
struct LocalGeometry {
  TileMesh tiles;
  Truncation truncation;
  std::vector<ContactPatch> patches;
};

// The part of a design around one of its vertices.
struct VertexPatch {
  TriangleMesh mesh;          // with the moving vertex at its place in the design
  Edges cuts;                 // vertex pairs of `mesh`
  int moving;                 // the vertex, in `mesh`
  std::vector<int> tiles;     // of the design, ascending
  std::vector<int> changed;   // into `tiles`: those whose shape the vertex changes
  std::vector<int> near;      // into `tiles`: those whose shape or truncation planes it changes
  std::vector<int> contacts;  // numbers in the design, in the order of `mesh`; -1 where the vertex
                              // does not change the interface
  std::vector<int> touched;   // vertices of `mesh` whose truncation planes it changes
  Truncation fixed;           // planes at other vertices of the tiles `near`
  bool remote;                // tiles without a common vertex overlap here
  bool shaped;                // all tiles have back faces: planes and interfaces exist
  double H_body;
};

class VertexPatches {
 public:
  // geometry must outlive this.
  explicit VertexPatches(const DesignGeometry& geometry);

  VertexPatch around(int vertex) const;

 private:
  // Tiles at the vertices of these.
  std::vector<int> tiles_around(const std::vector<int>& tiles) const;

  const DesignGeometry& geometry_;
  std::vector<std::vector<int>> tiles_at_;  // per vertex
  std::vector<int> contact_of_;             // per 3 tile + side
};

// The patch's tiles and interfaces with its vertex at `position`. Tiles at the patch's rim lack
// neighbours and are wrong; none of them is in `changed`, none of their rims' contacts in
// `contacts`.
LocalGeometry local_geometry(const VertexPatch& patch, const Vec3& position);

// Derivatives (one row per entry of what `measure` returns, columns x, y, z) by the patch's vertex,
// by central differences: the functions are closed forms, differentiated to some 1e-8. `measure`
// must not depend on the rim.
Eigen::MatrixXd derivatives_by_vertex(
    const VertexPatch& patch, const std::function<Eigen::VectorXd(const LocalGeometry&)>& measure);

}  // namespace curveups
