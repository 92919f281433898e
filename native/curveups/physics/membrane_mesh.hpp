// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangulation of a membrane's domain. Every mesh vertex is a fixed affine combination of the pin
// corners of its patch (mean-value coordinates: K. Hormann, M. Floater, "Mean value coordinates for
// arbitrary planar polygons", ACM TOG 25 (4), 2006): flat positions and, on the pins, actuated ones
// are linear in the pin corners, so that the mesh follows them smoothly with its topology
// unchanged.
#pragma once

#include <array>
#include <vector>

#include "curveups/core/progress.hpp"
#include "curveups/physics/membrane_domain.hpp"

namespace curveups {

// Weighted pin corners of one vertex: [start[v], start[v + 1]) of corner and weight.
struct CornerWeights {
  std::vector<int> start = {0};
  std::vector<int> corner;
  std::vector<double> weight;
  int count() const { return static_cast<int>(start.size()) - 1; }
};

struct MembraneMesh {
  CornerWeights weights;  // per vertex; they sum to 1
  std::vector<int> pin;   // per vertex: the tile to whose pin it is glued, or -1
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise in the flat plane
  std::vector<int> patch;                     // per triangle, into the domain's patches
  std::vector<std::array<int, 2>> parents;    // after refine_mesh: of the vertices it added
  int vertex_count() const { return weights.count(); }
};

// Mesh with edges of `largest` mm at most, half of it at pin corners, where the stress is singular.
// Does not depend on the number of threads. flat: flat_pin_corners. Throws InfeasibleDesign, naming
// the tiles, where a patch folds over in the layout; InvalidInput for a size that would give
// millions of triangles; Cancelled.
MembraneMesh make_membrane_mesh(const MembraneDomain& domain, const Points2& flat, double largest,
                                const Progress& progress = {});

// Divide every triangle into four at the midpoints of its edges: the spaces are nested. The old
// vertices come first, the new ones follow with their parents.
MembraneMesh refine_mesh(const MembraneMesh& mesh);

// weights times corners: flat positions (2 columns) or actuated ones (3), which glued vertices have
// and from which free ones start.
template <class Points>
Points vertex_positions(const CornerWeights& weights, const Points& corners) {
  Points out = Points::Zero(weights.count(), corners.cols());
  for (int v = 0; v < weights.count(); ++v) {
    for (int k = weights.start[v]; k < weights.start[v + 1]; ++k) {
      out.row(v) += weights.weight[k] * corners.row(weights.corner[k]);
    }
  }
  return out;
}

}  // namespace curveups
