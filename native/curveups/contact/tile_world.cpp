// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/tile_world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "curveups/bodies/convex_distance.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/design/print_constants.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/physics/membrane_solution.hpp"

namespace curveups {
namespace {

constexpr double poisson_ratio = 0.35;  // printed polymers

// Secant stiffness of a sphere of radius R against a plane (Hertz) under this force, N / mm.
double sphere_stiffness(double R, double force) {
  const double both = tile_modulus / (2 * (1 - poisson_ratio * poisson_ratio));
  return std::pow(4.0 / 3 * both * std::sqrt(R), 2.0 / 3) * std::cbrt(force);
}

// Contact of each wall of each tile, or -1.
std::vector<std::array<int, 3>> contacts_of_walls(const TileMesh& tiles) {
  std::vector<std::array<int, 3>> out(tiles.tile_count(), {-1, -1, -1});
  for (std::size_t k = 0; k < tiles.contacts.size(); ++k) {
    const Contact& contact = tiles.contacts[k];
    for (int s = 0; s < 2; ++s) out[contact.tile[s]][contact.side[s]] = static_cast<int>(k);
  }
  return out;
}

// Wrenches of a reduced membrane on the tiles.
Wrenches pull_of(const ReducedMembrane& membrane, const Poses& poses, int tile_count) {
  Motions gradient = Motions::Zero(poses.size(), 6);
  membrane.derivatives(poses, 1, gradient, nullptr);
  return -gradient.topRows(tile_count);
}

BalanceSystem balance_of(std::vector<ContactPoint> interface, const Poses& tiles, double L) {
  Points3 centres(tiles.size(), 3);
  for (std::size_t i = 0; i < tiles.size(); ++i) centres.row(i) = tiles[i].t.transpose();
  return BalanceSystem(std::move(interface), centres, L, {});
}

// Least forces between neighbours, at the corners of interfaces, that exert these wrenches on all
// tiles.
std::vector<PairLoad> shared_out(const Wrenches& wrenches, const Poses& tiles,
                                 BalanceSystem& system) {
  const ContactForces forces = solve_contact_forces(system, wrenches);
  std::vector<PairLoad> loads;
  for (int p = 0; p < system.point_count(); ++p) {
    const ContactPoint& point = system.points()[p];
    const RigidMotion &one = tiles[point.tile[0]], &other = tiles[point.tile[1]];
    loads.push_back({point.tile, other.to_own(point.position),
                     -(one.R.transpose() * (system.basis(p) * forces.force.row(p).transpose()))});
  }
  return loads;
}

class Builder {
 public:
  Builder(const TileBodies& bodies, const SolvedDesign& solved, const std::array<double, 2>& pull)
      : bodies_(bodies),
        solved_(solved),
        pull_(pull),
        tiles_(bodies.geometry.tiles),
        count_(tiles_.tile_count()),
        centres_(tile_centres(tiles_)) {
    options_.least_unit = force_scale(solved);
    options_.lever = 0.4 * bodies.parameters.L;
    Pace& pace = options_.pace;
    pace.step_limit = bodies.parameters.L / 7;
    pace.first_weight = 1e-4;  // bodies that settle start beside their rest
    pace.search.reach = std::max(0.5, 1.5 * bodies.parameters.bump_height);
    pace.search.face_margin = 0.001;  // contacts keep their faces and friction
  }

  TileWorld run() {
    add_tiles();
    add_nodes();
    settle_nodes();
    TileWorld out;
    out.tile_count = count_;
    out.L = bodies_.parameters.L;
    out.interface = interface_points(tiles_, bodies_.geometry.patches);
    const Poses tiles(poses_.begin(), poses_.begin() + count_);
    BalanceSystem system = balance_of(out.interface, tiles, out.L);
    std::vector<std::unique_ptr<MotionEnergy>> energies;
    for (int s = 0; s < 2; ++s) {
      out.domain[s] = domain_[s];
      out.pins[s] = own_corners(s);
      auto reduced = membrane(static_cast<Side>(s));
      const Wrenches elements = pull_[s] * extrapolated_wrenches(solved_.membranes[s], centres_);
      auto corrections = std::make_unique<PairLoads>(
          shared_out(elements - pull_of(*reduced, poses_, count_), tiles, system));
      out.membranes[s] = reduced.get();
      out.corrections[s] = corrections.get();
      energies.push_back(std::move(reduced));
      energies.push_back(std::move(corrections));
    }
    energies.push_back(std::make_unique<PointLoads>(weights()));
    add_ground();
    for (int held : held_tiles(bodies_.geometry, bodies_.parameters)) list_[held].fixed = true;
    out.start = poses_;
    out.world = std::make_unique<ContactWorld>(std::move(list_), std::move(poses_), options_);
    for (auto& energy : energies) out.world->add(std::move(energy));
    return out;
  }

 private:
  void add_tiles() {
    std::vector<char> at_tips;  // interfaces that touch at bumps, not with their walls
    std::size_t tips = 0, interfaces = 0;
    for (const Points3& points : bump_tips(bodies_.bumps, tiles_)) {
      at_tips.push_back(points.rows() > 0);
      tips += points.rows();
      interfaces += points.rows() > 0;
    }
    // Estimate of the force on a tip: an interface has four contact points.
    const double force = tips == 0 ? 1
                                   : force_scale(solved_) * 4 * static_cast<double>(interfaces) /
                                         static_cast<double>(tips);
    const Parameters& p = bodies_.parameters;
    const double R = sphere_radius(0.5 * bump_aspect * p.bump_height, p.bump_height);
    const double tip_stiffness = sphere_stiffness(R, force);
    const std::vector<std::array<int, 3>> contact_of = contacts_of_walls(tiles_);
    const std::vector<int> piece = pieces_of_faces(tiles_.topology, tiles_.cut);
    list_.resize(count_);
    poses_.resize(count_);
    parallel_for(count_, [&](int i) {
      std::array<double, 3> recess = {0, 0, 0};
      for (int t = 0; t < 3; ++t) {
        const int contact = contact_of[i][t];
        if (contact >= 0 && at_tips[contact]) recess[t] = bodies_.bumps.recess(i, t);
      }
      const ConvexBody body = tile_body(tiles_, bodies_.geometry.truncation, i, recess);
      const Vec3 centre = centres_.row(i);
      RigidMotion motion = tiles_.frame[i];
      motion.t -= centre;
      // A wall gives way as a layer of the material does, as deep as the tile's middle.
      const double depth = 2 * tiles_.area(i) / tiles_.length.row(i).sum();
      list_[i] = make_rigid_body(moved(body, motion), Vec3::Zero(), tile_modulus / depth);
      list_[i].piece = piece[i];
      poses_[i].t = centre;
      for (const WallCap& cap : bodies_.bumps.of_tile[i]) {
        if (!cap.bump || !at_tips[cap.contact]) continue;
        for (std::size_t f = 0; f < body.faces.size(); ++f) {
          if (body.faces[f].tag != body_tag::wall + cap.wall) continue;
          list_[i].faces[f].tips.push_back(motion(cap.centre + cap.height * cap.axis));
          list_[i].faces[f].tip_stiffness = tip_stiffness;
        }
      }
    });
  }

  // The free nodes of both membranes.
  void add_nodes() {
    for (int s = 0; s < 2; ++s) {
      domain_[s] = make_membrane_domain(tiles_, static_cast<Side>(s));
      corners_[s] =
          actuated_pin_corners(tiles_, bodies_.q, static_cast<Side>(s), bodies_.parameters.H_pin);
      first_node_[s] = static_cast<int>(poses_.size());
      const Poses nodes = membrane_nodes(domain_[s], corners_[s]);
      poses_.insert(poses_.end(), nodes.begin(), nodes.end());
    }
    list_.resize(poses_.size());
  }

  Points3 own_corners(int s) const {
    Points3 own = corners_[s];
    for (int c = 0; c < own.rows(); ++c) own.row(c) -= centres_.row(c / 3);
    return own;
  }

  std::unique_ptr<ReducedMembrane> membrane(Side side) const {
    const int s = static_cast<int>(side);
    MembraneMaterial material = membrane_material(bodies_.parameters, side);
    material.thickness *= pull_[s];
    return std::make_unique<ReducedMembrane>(
        domain_[s], flat_pin_corners(tiles_, bodies_.poses, bodies_.q, side), own_corners(s),
        bodies_.parameters.tau, material, first_node_[s]);
  }

  // Lets the nodes come to rest while the tiles stand still.
  void settle_nodes() {
    std::vector<RigidBody> still(list_.size());
    for (int i = 0; i < count_; ++i) still[i].fixed = true;
    ContactWorld nodes(std::move(still), poses_, options_);
    for (int s = 0; s < 2; ++s) nodes.add(membrane(static_cast<Side>(s)));
    nodes.settle(40);
    poses_ = nodes.poses();
  }

  std::vector<PointLoad> weights() const {
    std::vector<PointLoad> out;
    const Wrenches weight = curveups::weights(bodies_.geometry, bodies_.q, bodies_.parameters);
    for (int i = 0; i < count_; ++i) {
      const Vec3 force = weight.row(i).head<3>(), torque = weight.row(i).tail<3>();
      if (force.squaredNorm() > 0) {
        out.push_back({i, force.cross(torque) / force.squaredNorm(), force});
      }
    }
    return out;
  }

  // Adds the table, which only pushes, where the piece rests on one.
  void add_ground() {
    const Parameters& p = bodies_.parameters;
    if (p.gravity != "resting") return;
    const Vec3 up = -gravity_down;
    const Vec3 along = up.unitOrthogonal(), across = up.cross(along);
    double lowest = std::numeric_limits<double>::infinity(), far = 0;
    for (int i = 0; i < count_; ++i) {
      far = std::max(far, 10 * (poses_[i].t - poses_[0].t).norm() + 100);
      for (const BodySurface& face : list_[i].faces) {
        for (const Vec3& corner : face.outline) {
          lowest = std::min(lowest, up.dot(poses_[i](corner)));
        }
      }
    }
    BodySurface top{up, 0, {}};
    for (const auto& [a, b] : {std::pair(-far, -far), {far, -far}, {far, far}, {-far, far}}) {
      top.outline.push_back(a * along + b * across);
    }
    top.stiffness = tile_modulus / p.H_body;
    list_.push_back({{top}, true});
    const Vec3 middle = poses_[0].t;
    poses_.push_back({Eigen::Matrix3d::Identity(), middle + (lowest - up.dot(middle)) * up});
  }

  const TileBodies& bodies_;
  const SolvedDesign& solved_;
  std::array<double, 2> pull_;
  const TileMesh& tiles_;
  int count_;
  Points3 centres_;
  WorldOptions options_;
  std::vector<RigidBody> list_;
  Poses poses_;
  std::array<MembraneDomain, 2> domain_;
  std::array<Points3, 2> corners_;
  std::array<int, 2> first_node_{};
};

}  // namespace

Points3 TileWorld::pin_corners(Side side, const Poses& poses) const {
  Points3 out = pins[static_cast<int>(side)];
  for (int c = 0; c < out.rows(); ++c) {
    out.row(c) = poses[c / 3](out.row(c).transpose()).transpose();
  }
  return out;
}

double TileWorld::solve_elements(SolvedDesign& solved, double tolerance) {
  const Poses& poses = world->poses();
  std::array<char, 2> converged{};
  parallel_for(2, [&](int s) {
    converged[s] = move_pins(solved.membranes[s], pin_corners(static_cast<Side>(s), poses),
                             solved.design.parameters);
  });
  const Poses tiles(poses.begin(), poses.begin() + tile_count);
  std::vector<ContactPoint> now = interface;
  for (ContactPoint& point : now) {
    const Vec3 own = point.position - start[point.tile[1]].t;
    point.position = tiles[point.tile[1]](own);
  }
  BalanceSystem system = balance_of(std::move(now), tiles, L);
  double mean = 0, off = 0;
  std::array<Wrenches, 2> missing;
  for (int s = 0; s < 2; ++s) {
    if (!converged[s]) throw no_equilibrium(static_cast<Side>(s));
    const Wrenches pull = extrapolated_wrenches(solved.membranes[s], system.centres());
    missing[s] = pull - pull_of(*membranes[s], poses, tile_count);
    Motions corrected = Motions::Zero(poses.size(), 6);
    corrections[s]->derivatives(poses, 1, corrected, nullptr);
    Wrenches change = missing[s] + corrected.topRows(tile_count);
    change.rightCols<3>() /= L;
    off = std::max(off, change.rowwise().norm().maxCoeff());
    mean += pull.leftCols<3>().rowwise().norm().mean();
  }
  if (!(mean > 0)) return 0;
  if (off > tolerance * mean) {
    for (int s = 0; s < 2; ++s) {
      corrections[s]->loads = shared_out(missing[s], tiles, system);
    }
  }
  return off / mean;
}

Poses membrane_nodes(const MembraneDomain& domain, const Points3& pin_corners) {
  Poses out;
  for (const MembranePatch& patch : domain.patches) {
    if (patch.vertex < 0) continue;
    RigidMotion node;
    for (int c : patch.corners) {
      node.t += pin_corners.row(c).transpose() / static_cast<double>(patch.corners.size());
    }
    out.push_back(node);
  }
  return out;
}

Eigen::VectorXd contact_pushes(const TileMesh& tiles, const ContactWorld& world) {
  std::map<std::array<int, 2>, double> push;
  for (const TouchForce& touch : world.forces()) push[touch.body] += touch.push;
  Eigen::VectorXd out(static_cast<Eigen::Index>(tiles.contacts.size()));
  for (Eigen::Index k = 0; k < out.size(); ++k) out(k) = push[tiles.contacts[k].tile];
  return out;
}

TileWorld make_tile_world(const TileBodies& bodies, const SolvedDesign& solved,
                          const std::array<double, 2>& pull) {
  return Builder(bodies, solved, pull).run();
}

}  // namespace curveups
