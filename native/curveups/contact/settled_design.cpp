// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/settled_design.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/geometry/closest_points.hpp"

namespace curveups {
namespace {

// The settled front surface as triangles of its own per tile.
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

// Moves it rigidly to where its corners are nearest to the design's (W. Kabsch, 1976).
RigidMotion best_fit(const Points3& from, const Points3& to) {
  const Eigen::RowVector3d a = from.colwise().mean(), b = to.colwise().mean();
  const Eigen::Matrix3d product = (from.rowwise() - a).transpose() * (to.rowwise() - b);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
  mirror(2, 2) = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0 ? -1 : 1;
  const Eigen::Matrix3d R = svd.matrixV() * mirror * svd.matrixU().transpose();
  return {R, b.transpose() - R * a.transpose()};
}

// Corners, edge midpoints and middle of a tile.
constexpr int samples = 7;
Vec3 sample(const TriangleMesh& mesh, int tile, int k) {
  Vec3 a = mesh.V.row(mesh.F(tile, 0)), b = mesh.V.row(mesh.F(tile, 1)),
       c = mesh.V.row(mesh.F(tile, 2));
  switch (k) {
    case 0:
      return a;
    case 1:
      return b;
    case 2:
      return c;
    case 3:
      return 0.5 * (a + b);
    case 4:
      return 0.5 * (b + c);
    case 5:
      return 0.5 * (c + a);
    default:
      return (a + b + c) / 3;
  }
}

Eigen::VectorXd sample_distances(const TriangleMesh& mesh, const ClosestPoints& surface) {
  const int count = static_cast<int>(mesh.F.rows());
  Points3 points(samples * count, 3);
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < samples; ++k) {
      points.row(samples * i + k) = sample(mesh, i, k).transpose();
    }
  }
  return distances(points, surface);
}

class Settling {
 public:
  Settling(const Design& design, const TileBodies& bodies, const SolvedDesign& solved,
           const SettleOptions& options)
      : options_(options),
        tiles_(bodies.geometry.tiles),
        centres_(tile_centres(tiles_)),
        surface_(design.mesh),
        at_start_(settled_mesh(tiles_, centres_, start_poses())),
        built_(make_tile_world(bodies, solved, options.tile_modulus)) {
    const Parameters& p = design.parameters;
    out_.friction_coefficient = p.friction_coefficient;
    out_.hold_tolerance = options.hold_tolerance > 0 ? options.hold_tolerance : 0.01 * p.L;
  }

  SettledDesign run() {
    ContactWorld& world = *built_.world;
    world.set_friction(std::numeric_limits<double>::infinity());
    const bool still = settle().at_rest;
    stuck_.emplace(fitted());
    world.set_friction(out_.friction_coefficient);
    out_.converged = settle().at_rest && still;
    describe(world.forces());
    out_.holds = holds();
    if (options_.find_holding_friction && out_.holds) {
      out_.holding_friction = holding_friction();
    }
    return std::move(out_);
  }

 private:
  Poses start_poses() const {
    Poses poses(tiles_.tile_count());
    for (int i = 0; i < tiles_.tile_count(); ++i) poses[i].t = centres_.row(i).transpose();
    return poses;
  }

  // Until it is at rest, or is known not to hold.
  StepReport settle() {
    ContactWorld& world = *built_.world;
    return world.settle(options_.max_steps, [&](const StepReport& step) {
      out_.steps += !step.at_rest;
      out_.iterations += step.iterations;
      out_.factorizations += step.factorizations;
      checkpoint("settle", std::min(0.95, out_.steps / 10.0));
      return has_left() || !step.converged || out_.iterations > options_.max_iterations;
    });
  }

  // Tiles have moved by more than the tolerance in the mean, and the surface as well.
  bool has_left() const {
    if (!stuck_) return false;
    double moved = 0;
    for (int i = 0; i < tiles_.tile_count(); ++i) {
      moved += (built_.world->poses()[i].t - centres_.row(i).transpose()).norm();
    }
    return moved > out_.hold_tolerance * tiles_.tile_count() && drift() > out_.hold_tolerance;
  }

  TriangleMesh fitted() const {
    TriangleMesh mesh = settled_mesh(tiles_, centres_, built_.world->poses());
    const RigidMotion fit = best_fit(mesh.V, at_start_.V);
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
      mesh.V.row(v) = fit(mesh.V.row(v).transpose()).transpose();
    }
    return mesh;
  }

  double drift() const { return sample_distances(fitted(), *stuck_).mean(); }

  std::vector<double> normal_forces(const std::vector<TouchForce>& forces) const {
    std::map<std::array<int, 2>, int> contact_of;
    for (std::size_t k = 0; k < tiles_.contacts.size(); ++k) {
      contact_of[tiles_.contacts[k].tile] = static_cast<int>(k);
    }
    std::vector<double> push(tiles_.contacts.size(), 0);
    for (const TouchForce& force : forces) {
      const auto contact = contact_of.find(force.body);
      if (contact != contact_of.end()) push[contact->second] += force.push;
    }
    return push;
  }

  void describe(const std::vector<TouchForce>& forces) {
    const std::vector<double> push = normal_forces(forces);
    out_.contact_force = Eigen::Map<const Eigen::VectorXd>(push.data(), push.size());
    for (std::size_t k = 0; k < push.size(); ++k) {
      if (push[k] == 0) out_.open_contacts.push_back(tiles_.contacts[k].tile);
    }
    if (!push.empty()) {
      out_.normal_mean = out_.contact_force.mean();
      out_.normal_min = out_.contact_force.minCoeff();
    }
    for (const TouchForce& force : forces) {
      if (force.push > 0) out_.largest_slip = std::max(out_.largest_slip, force.slip);
    }
    out_.drift = drift();
    const TriangleMesh mesh = fitted();
    Eigen::VectorXd far = sample_distances(mesh, surface_);
    const int count = tiles_.tile_count();
    out_.corners = mesh.V;
    out_.deviation.resize(count);
    for (int i = 0; i < count; ++i) out_.deviation(i) = far.segment<samples>(samples * i).mean();
    VirtualScan& scan = out_.scan;
    scan.mean = far.mean();
    scan.rms = std::sqrt(far.squaredNorm() / static_cast<double>(far.size()));
    std::sort(far.begin(), far.end());
    scan.p95 = far(static_cast<Eigen::Index>(0.95 * static_cast<double>(far.size() - 1)));
    scan.largest = far(far.size() - 1);
    scan.hausdorff =
        std::max(scan.largest, sample_distances(at_start_, ClosestPoints(mesh)).maxCoeff());
    out_.poses.resize(count, 7);
    for (int i = 0; i < count; ++i) {
      const RigidMotion& pose = built_.world->poses()[i];
      const Eigen::Quaterniond turn(pose.R);
      out_.poses.row(i) << pose.t.transpose() - centres_.row(i), turn.coeffs().transpose();
    }
  }

  bool holds() const {
    return out_.converged && out_.open_contacts.empty() && out_.drift <= out_.hold_tolerance;
  }

  // Friction falls in steps, and the tiles settle from where they stand: as it happens to a piece.
  double holding_friction() {
    ContactWorld& world = *built_.world;
    double held = out_.friction_coefficient;
    for (double mu = held - options_.friction_step; mu > 0.5 * options_.friction_step;
         mu -= options_.friction_step) {
      world.set_friction(mu);
      if (!settle().at_rest || drift() > out_.hold_tolerance) break;
      const std::vector<double> push = normal_forces(world.forces());
      if (std::any_of(push.begin(), push.end(), [](double n) { return n == 0; })) break;
      held = mu;
    }
    return held;
  }

  const SettleOptions& options_;
  const TileMesh& tiles_;
  Points3 centres_;
  ClosestPoints surface_;
  TriangleMesh at_start_;
  TileWorld built_;
  std::optional<ClosestPoints> stuck_;  // the surface before walls were let go
  SettledDesign out_;
};

}  // namespace

SettledDesign settle_design(const Design& design, SolutionStore* store,
                            const SettleOptions& options, const Progress& progress) {
  if (!std::isfinite(options.hold_tolerance) || options.hold_tolerance < 0) {
    throw InvalidInput("hold_tolerance is no length", "give mm, or 0 for 1 % of L");
  }
  if (!std::isfinite(options.tile_modulus) || !(options.tile_modulus > 0)) {
    throw InvalidInput("tile_modulus is no modulus", "give more than 0 MPa, such as 2000");
  }
  const ProgressScope scope(progress);
  const TileBodies bodies = make_tile_bodies(design);
  SolvedDesign solved = take_or_solve(store, bodies.geometry, design, progress);
  checkpoint("settle", 0);
  SettledDesign out = Settling(design, bodies, solved, options).run();
  if (store) store->put(std::move(solved));
  return out;
}

}  // namespace curveups
