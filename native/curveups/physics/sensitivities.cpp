// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/sensitivities.hpp"

#include <algorithm>

#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

// Derivatives by the pin corners of one side.
struct CornerGradient {
  Points2 flat;
  Points3 actuated;
};

// z: virtual motions of the tiles (BalanceSystem::expand). Returns the derivatives of -z^T b.
std::vector<CornerGradient> corner_gradients(const SolvedMembrane& membrane,
                                             const MembraneEquilibrium& equilibrium,
                                             const Points3& centres, double lever,
                                             const std::vector<Array6>& motions) {
  const MembraneMesh& mesh = membrane.mesh;
  const Points3 &x = membrane.state.x, &force = membrane.state.gradient;
  std::vector<Points3> displacement(motions.size(), Points3::Zero(x.rows(), 3));
  for (std::size_t k = 0; k < motions.size(); ++k) {
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      const int tile = mesh.pin[v];
      if (tile < 0) continue;
      const Vec3 shift = motions[k].row(tile).head<3>(),
                 turn = motions[k].row(tile).tail<3>() / lever,
                 arm = (x.row(v) - centres.row(tile)).transpose();
      displacement[k].row(v) = (shift + turn.cross(arm)).transpose();
    }
  }
  equilibrium.respond(x, displacement);
  std::vector<Points3> by_position;
  std::vector<Points2> by_flat;
  equilibrium.energy().second_derivatives(x, displacement, by_position, &by_flat);
  std::vector<CornerGradient> out;
  for (std::size_t k = 0; k < motions.size(); ++k) {
    CornerGradient gradient{Points2::Zero(membrane.flat_corners.rows(), 2),
                            Points3::Zero(membrane.flat_corners.rows(), 3)};
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      Vec3 actuated = Vec3::Zero();
      if (mesh.pin[v] >= 0) {
        const Vec3 turn = motions[k].row(mesh.pin[v]).tail<3>() / lever, pull = force.row(v);
        // The arm about the tile's centre changes with the vertex.
        actuated = by_position[k].row(v).transpose() + pull.cross(turn);
      }
      for (int c = mesh.weights.start[v]; c < mesh.weights.start[v + 1]; ++c) {
        const double weight = mesh.weights.weight[c];
        gradient.flat.row(mesh.weights.corner[c]) += weight * by_flat[k].row(v);
        gradient.actuated.row(mesh.weights.corner[c]) += weight * actuated.transpose();
      }
    }
    out.push_back(std::move(gradient));
  }
  return out;
}

// Chain rule from pin corners to poses and insets.
void add_side(const DesignForces& forces, Side side, const CornerGradient& corner,
              ForceGradient& out) {
  const TileMesh& tiles = forces.geometry().tiles;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const PlaneRotation turn(forces.poses()(i, 2));
    const Vec2 origin = forces.poses().row(i).head<2>();
    const std::array<Vec2, 3>& face = tiles.corners(i, side);
    for (int t = 0; t < 3; ++t) {
      const int c = pin_corner_index(i, t);
      const Vec2 flat = corner.flat.row(c);
      const Vec2 arm = forces.membrane(side).flat_corners.row(c).transpose() - origin;
      out.by_pose.row(i) += Vec3(flat.x(), flat.y(), left_of(arm).dot(flat)).transpose();
      // Corner t moves along edge t by q[t - 1] and back along edge t - 1 by q[t] (inset_triangle).
      const Vec2 along = (face[next3(t)] - face[t]).normalized(),
                 back = (face[prev3(t)] - face[t]).normalized();
      const double sine = wedge(along, back);
      const Vec3 space = corner.actuated.row(c);
      const Eigen::Matrix3d& R = tiles.frame[i].R;
      auto along_local = [&](const Vec2& d) {
        return (flat.dot(turn * d) + space.dot(R.leftCols<2>() * d)) / sine;
      };
      out.by_inset(i, inset_index(side, prev3(t))) += along_local(along);
      out.by_inset(i, inset_index(side, t)) += along_local(back);
    }
  }
}

// Derivatives by everything that vertices change: pin corners, contact points and their normals.
struct PlaceGradient {
  std::array<CornerGradient, 2> pins;
  Points3 point, normal;
};

// Subtract from `by_point` the derivative by the points' places of the work of forces as the tiles
// on either side turn. forces: world, one row per point.
void subtract_work(const BalanceSystem& system, const Points3& forces, const Array6& motion,
                   Points3& by_point) {
  for (int p = 0; p < system.point_count(); ++p) {
    const ContactPoint& point = system.points()[p];
    Vec3 turns = Vec3::Zero();
    for (int end = 0; end < 2; ++end) {
      const Vec3 turn = motion.row(point.tile[end]).tail<3>() / system.lever();
      turns += (end == 0 ? -1.0 : 1.0) * turn;
    }
    by_point.row(p) -= Vec3(forces.row(p)).cross(turns).transpose();
  }
}

// Forces in the points' bases (three a point) as vectors in the world.
Points3 in_world(const BalanceSystem& system, const double* forces) {
  Points3 out(system.point_count(), 3);
  for (int p = 0; p < system.point_count(); ++p) {
    out.row(p) = (system.basis(p) * Eigen::Map<const Vec3>(forces + 3 * p)).transpose();
  }
  return out;
}

// First point of each contact, with one more at the end.
std::vector<int> first_points(const BalanceSystem& system, std::size_t contacts) {
  std::vector<int> first(contacts + 1, 0);
  for (const ContactPoint& point : system.points()) ++first[point.contact + 1];
  for (std::size_t k = 0; k < contacts; ++k) first[k + 1] += first[k];
  return first;
}

// Interface of a patch with its points among those of the balance.
struct PatchContact {
  int patch, first, count;
};

// Places of pins, points and normals around a vertex, weighted by the derivatives of each function
// by them.
Eigen::VectorXd weighted_places(const DesignForces& forces, const VertexPatch& patch,
                                const std::vector<PatchContact>& contacts,
                                const std::vector<PlaceGradient>& gradients,
                                const LocalGeometry& local) {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(gradients.size()));
  const auto add = [&](const auto& term) {
    for (std::size_t f = 0; f < gradients.size(); ++f) {
      out(static_cast<Eigen::Index>(f)) += term(gradients[f]);
    }
  };
  for (int k : patch.changed) {
    const int tile = patch.tiles[k];
    const Vec2 origin = forces.poses().row(tile).head<2>();
    const PlaneRotation turn(forces.poses()(tile, 2));
    for (int s : {0, 1}) {
      const Side side = static_cast<Side>(s);
      const double level = pin_top_level(local.tiles, side, forces.parameters().H_pin);
      const std::array<Vec2, 3> pin =
          pin_corners(local.tiles, k, side, forces.insets().row(tile).data());
      for (int t = 0; t < 3; ++t) {
        const int c = pin_corner_index(tile, t);
        const Vec2 flat = origin + turn * pin[t];
        const Vec3 actuated = local.tiles.frame[k](Vec3(pin[t].x(), pin[t].y(), level));
        add([&](const PlaceGradient& g) {
          return g.pins[s].flat.row(c).dot(flat) + g.pins[s].actuated.row(c).dot(actuated);
        });
      }
    }
  }
  for (const PatchContact& contact : contacts) {
    const ContactPatch& interface = local.patches[contact.patch];
    for (int l = 0; l < contact.count; ++l) {
      const int p = contact.first + l;
      add([&](const PlaceGradient& g) {
        return g.point.row(p).dot(interface.point[l]) + g.normal.row(p).dot(interface.normal);
      });
    }
  }
  return out;
}

void add_vertices(const DesignForces& forces, const std::vector<PlaceGradient>& gradients,
                  const std::vector<VertexPatch>& vertices, std::vector<ForceGradient>& out) {
  const std::vector<int> first =
      first_points(forces.system(), forces.geometry().tiles.contacts.size());
  parallel_for(static_cast<int>(vertices.size()), [&](int v) {
    const VertexPatch& patch = vertices[v];
    const LocalGeometry here = local_geometry(patch, patch.mesh.V.row(patch.moving));
    std::vector<PatchContact> contacts;
    for (std::size_t k = 0; k < patch.contacts.size(); ++k) {
      const int contact = patch.contacts[k];
      if (contact < 0) continue;
      const int count = first[contact + 1] - first[contact];
      // Otherwise at a kink, where a point comes or goes.
      if (here.patches[k].point_count == count) {
        contacts.push_back({static_cast<int>(k), first[contact], count});
      }
    }
    const Eigen::MatrixXd by_vertex = derivatives_by_vertex(patch, [&](const LocalGeometry& local) {
      return weighted_places(forces, patch, contacts, gradients, local);
    });
    for (std::size_t f = 0; f < gradients.size(); ++f) out[f].by_vertex.row(v) = by_vertex.row(f);
  });
}

// Derivatives of functions that follow loads by -motion . db, and contact points and normals by
// `places`, which is empty without vertices.
std::vector<ForceGradient> gradients_of(const DesignForces& forces,
                                        const std::vector<Array6>& motions,
                                        std::vector<PlaceGradient> places,
                                        const std::vector<VertexPatch>& vertices) {
  const BalanceSystem& system = forces.system();
  const int count = static_cast<int>(motions.size());
  const int tiles = forces.geometry().tiles.tile_count();
  std::vector<ForceGradient> out(count,
                                 {Array3::Zero(tiles, 3), Array6::Zero(tiles, 6),
                                  Points3::Zero(static_cast<Eigen::Index>(vertices.size()), 3)});
  // Displacement fields of this many functions fit into some hundred MB at 300,000 triangles.
  constexpr int batch = 16;
  for (int first = 0; first < count; first += batch) {
    const std::vector<Array6> some(motions.begin() + first,
                                   motions.begin() + std::min(count, first + batch));
    std::array<std::vector<CornerGradient>, 2> corners;
    parallel_for(2, [&](int s) {
      const Side side = static_cast<Side>(s);
      corners[s] = corner_gradients(forces.membrane(side), forces.equilibrium(side),
                                    system.centres(), system.lever(), some);
    });
    for (std::size_t k = 0; k < some.size(); ++k) {
      for (int s : {0, 1}) {
        add_side(forces, static_cast<Side>(s), corners[s][k], out[first + k]);
        if (!places.empty()) places[first + k].pins[s] = std::move(corners[s][k]);
      }
    }
  }
  if (!places.empty()) add_vertices(forces, places, vertices, out);
  return out;
}

}  // namespace

std::vector<ForceGradient> force_gradients(const DesignForces& forces,
                                           const Eigen::MatrixXd& functions,
                                           const std::vector<VertexPatch>& vertices) {
  const BalanceSystem& system = forces.system();
  const int count = static_cast<int>(functions.cols()), points = system.point_count();
  if (count == 0) return {};
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(3 * points, count), right(system.rows(), count);
  for (int k = 0; k < count; ++k) {
    for (int p = 0; p < points; ++p) G(3 * p, k) = functions(p, k);
    right.col(k) = system.apply(G.col(k));
  }
  const Eigen::MatrixXd z = system.solve(right);
  std::vector<Array6> motions;
  for (int k = 0; k < count; ++k) motions.push_back(system.expand(z.col(k)));
  std::vector<PlaceGradient> places;
  if (!vertices.empty()) {
    const Points3 f = in_world(system, forces.contact_forces().force.data());
    const Array6 y = system.expand(system.solve(system.restrict(forces.loads())));
    for (int k = 0; k < count; ++k) {
      const Eigen::VectorXd rest = G.col(k) - system.apply_transposed(z.col(k));
      PlaceGradient place{{}, Points3::Zero(points, 3), functions.col(k).asDiagonal() * f};
      subtract_work(system, f, motions[k], place.point);
      subtract_work(system, in_world(system, rest.data()), y, place.point);
      places.push_back(std::move(place));
    }
  }
  return gradients_of(forces, motions, std::move(places), vertices);
}

std::vector<ForceGradient> load_gradients(const DesignForces& forces,
                                          const std::vector<Array6>& motions) {
  return gradients_of(forces, motions, {}, {});
}

ForceGradient floor_gradient(const DesignForces& forces, const UnilateralResult& unilateral,
                             const std::vector<VertexPatch>& vertices) {
  const BalanceSystem& system = forces.system();
  std::vector<PlaceGradient> places;
  if (!vertices.empty()) {
    PlaceGradient place{{}, Points3::Zero(system.point_count(), 3), unilateral.by_normal};
    subtract_work(system, in_world(system, unilateral.force.data()), unilateral.motion,
                  place.point);
    places.push_back(std::move(place));
  }
  return gradients_of(forces, {unilateral.motion}, std::move(places), vertices).front();
}

}  // namespace curveups
