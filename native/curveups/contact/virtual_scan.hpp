// SPDX-License-Identifier: LGPL-2.1-or-later
// The virtual scan: the front surface that a piece has once its tiles have moved, beside another.
#pragma once

#include "curveups/contact/rigid_body.hpp"
#include "curveups/design/tile_mesh.hpp"
#include "curveups/geometry/closest_points.hpp"

namespace curveups {

// Distances of a scanned surface from the designed one, mm.
struct VirtualScan {
  double mean = 0, rms = 0, p95 = 0;  // of samples of the scanned surface
  double largest = 0;                 // of all its points, by samples
  double hausdorff = 0;               // the larger of both directions' largest, likewise
};

// The rigid motion of one set of points to where it is nearest to the other (W. Kabsch, 1976).
RigidMotion best_fit(const Points3& from, const Points3& to);

// The front triangles, three vertices of their own a tile, after the rigid motion of each piece
// that fits it best to where it was designed. centres: where the tiles' bodies have their origins.
TriangleMesh fitted_surface(const TileMesh& tiles, const Points3& centres, const Poses& poses);

// Of corners, edge midpoints and middle of every triangle: as many rows each.
Eigen::VectorXd scan_distances(const TriangleMesh& mesh, const ClosestPoints& surface);

// Of each triangle the mean of its own.
Eigen::VectorXd triangle_means(const Eigen::VectorXd& distances);

// distances: scan_distances of `scanned`. designed: what they are the distances from.
VirtualScan describe_scan(Eigen::VectorXd distances, const TriangleMesh& scanned,
                          const TriangleMesh& designed);

}  // namespace curveups
