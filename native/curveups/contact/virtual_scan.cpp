// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/virtual_scan.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/geometry/surface_deviation.hpp"

namespace curveups {
namespace {

TriangleMesh settled_mesh(const TileMesh& tiles, const Points3& centres, const Poses& poses) {
  TriangleMesh mesh{Points3(3 * tiles.tile_count(), 3), Triangles(tiles.tile_count(), 3)};
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const Vec3 corner = tiles.mesh.V.row(tiles.mesh.F(i, c)) - centres.row(i);
      mesh.V.row(3 * i + c) = poses[i](corner).transpose();
      mesh.F(i, c) = 3 * i + c;
    }
  }
  return mesh;
}

constexpr int scan_samples = 7;

}  // namespace

RigidMotion best_fit(const Points3& from, const Points3& to) {
  const Eigen::RowVector3d a = from.colwise().mean(), b = to.colwise().mean();
  const Eigen::Matrix3d product = (from.rowwise() - a).transpose() * (to.rowwise() - b);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
  mirror(2, 2) = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0 ? -1 : 1;
  const Eigen::Matrix3d R = svd.matrixV() * mirror * svd.matrixU().transpose();
  return {R, b.transpose() - R * a.transpose()};
}

Eigen::VectorXd scan_distances(const TriangleMesh& mesh, const ClosestPoints& surface) {
  const int count = static_cast<int>(mesh.F.rows());
  Points3 points(scan_samples * count, 3);
  for (int i = 0; i < count; ++i) {
    const Vec3 a = mesh.V.row(mesh.F(i, 0)), b = mesh.V.row(mesh.F(i, 1)),
               c = mesh.V.row(mesh.F(i, 2));
    const std::array<Vec3, scan_samples> samples = {
        a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a), (a + b + c) / 3};
    for (int k = 0; k < scan_samples; ++k) points.row(scan_samples * i + k) = samples[k];
  }
  return distances(points, surface);
}

Eigen::VectorXd triangle_means(const Eigen::VectorXd& distances) {
  Eigen::VectorXd out(distances.size() / scan_samples);
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    out(i) = distances.segment<scan_samples>(scan_samples * i).mean();
  }
  return out;
}

TriangleMesh fitted_surface(const TileMesh& tiles, const Points3& centres, const Poses& poses) {
  TriangleMesh mesh = settled_mesh(tiles, centres, poses), designed = mesh;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int c = 0; c < 3; ++c) designed.V.row(3 * i + c) = tiles.mesh.V.row(tiles.mesh.F(i, c));
  }
  for (const std::vector<int>& piece : pieces_of(tiles)) {
    std::vector<int> own;
    for (int i : piece) own.insert(own.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    const Points3 from = mesh.V(own, Eigen::all), to = designed.V(own, Eigen::all);
    const RigidMotion fit = best_fit(from, to);
    for (int v : own) mesh.V.row(v) = fit(mesh.V.row(v).transpose()).transpose();
  }
  return mesh;
}

VirtualScan describe_scan(Eigen::VectorXd far, const TriangleMesh& scanned,
                          const TriangleMesh& designed) {
  VirtualScan scan;
  scan.mean = far.mean();
  scan.rms = std::sqrt(far.squaredNorm() / static_cast<double>(far.size()));
  std::sort(far.begin(), far.end());
  scan.p95 = far(static_cast<Eigen::Index>(0.95 * static_cast<double>(far.size() - 1)));
  scan.largest = std::max(far(far.size() - 1), largest_distance(scanned, designed));
  scan.hausdorff = std::max(scan.largest, largest_distance(designed, scanned));
  return scan;
}

}  // namespace curveups
