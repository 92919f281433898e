// SPDX-License-Identifier: LGPL-2.1-or-later
// Virtual scan: the front surface of a piece whose tiles have moved, beside another surface.
#pragma once

#include "curveups/contact/rigid_body.hpp"
#include "curveups/design/tile_mesh.hpp"
#include "curveups/geometry/closest_points.hpp"

namespace curveups {

// Distances of a scanned surface from the designed one, mm.
struct VirtualScan {
  double mean = 0, rms = 0, p95 = 0;  // over samples of the scanned surface (scan_distances)
  double largest = 0;                 // over all its points (surface_deviation.hpp)
  double hausdorff = 0;               // larger of both directions' largest
};

// Rigid motion of one set of points that is the least-squares fit to the other (W. Kabsch, 1976).
RigidMotion best_fit(const Points3& from, const Points3& to);

// Front triangles, three vertices of their own a tile, after the rigid motion of each piece that
// fits it best to its design. centres: origins of the tiles' bodies.
TriangleMesh fitted_surface(const TileMesh& tiles, const Points3& centres, const Poses& poses);

// Distances of seven samples of every triangle, one triangle after another: corners, midpoints of
// edges, middle.
Eigen::VectorXd scan_distances(const TriangleMesh& mesh, const ClosestPoints& surface);

// Mean of each triangle's distances.
Eigen::VectorXd triangle_means(const Eigen::VectorXd& distances);

// distances: scan_distances of `scanned` from `designed`.
VirtualScan describe_scan(Eigen::VectorXd distances, const TriangleMesh& scanned,
                          const TriangleMesh& designed);

}  // namespace curveups
