// SPDX-License-Identifier: LGPL-2.1-or-later
// How tiles and interfaces change as one vertex of the mesh moves: the few tiles around it are
// built anew, by the same code that builds all of them. For derivatives by vertices: frames, faces,
// folds, truncation planes and interfaces are closed forms of some thirty neighbouring vertices, of
// which one is varied.
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
  TriangleMesh mesh;          // the moving vertex where it is in the design
  Edges cuts;                 // vertex pairs of `mesh`
  int moving;                 // the vertex, in `mesh`
  std::vector<int> tiles;     // of the design, ascending
  std::vector<int> changed;   // into `tiles`: those whose shape the vertex changes
  std::vector<int> near;      // into `tiles`: those whose shape or truncation planes it changes
  std::vector<int> contacts;  // of the design, as `mesh` numbers them; -1 where the vertex does not
                              // change the interface
  std::vector<int> touched;   // of `mesh`: vertices at whose truncation planes it pulls
  Truncation fixed;           // the planes at other vertices of the tiles `near`
  bool remote;                // tiles without a common vertex overlap here
  bool shaped;                // whether all tiles have back faces: planes and interfaces are made
  double H_body;
};

class VertexPatches {
 public:
  // geometry must outlive this.
  explicit VertexPatches(const DesignGeometry& geometry);

  VertexPatch around(int vertex) const;

 private:
  // With all their vertices' tiles.
  std::vector<int> tiles_around(const std::vector<int>& tiles) const;

  const DesignGeometry& geometry_;
  std::vector<std::vector<int>> tiles_at_;  // by vertex
  std::vector<int> contact_of_;             // by 3 tile + side
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
