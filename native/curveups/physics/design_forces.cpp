// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/design_forces.hpp"

#include <utility>

#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

constexpr std::array<Side, 2> sides = {Side::front, Side::back};

}  // namespace

DesignForces::DesignForces(const DesignGeometry& geometry, const Parameters& parameters,
                           const FlatPoses& poses, const Array6& q, const Progress& progress)
    : parameters_(parameters), poses_(poses), q_(q) {
  take_geometry(geometry);
  for (Side side : sides) {
    SolvedMembrane& membrane = membranes_[static_cast<int>(side)];
    membrane.flat_corners = flat_pin_corners(geometry.tiles, poses, q, side);
    membrane.mesh =
        make_membrane_mesh(make_membrane_domain(geometry.tiles, side), membrane.flat_corners,
                           membrane_mesh_options(parameters), progress);
  }
  solve_membranes(true, progress);
}

DesignForces::DesignForces(const DesignGeometry& geometry, const Parameters& parameters,
                           std::array<SolvedMembrane, 2> solved, const FlatPoses& poses,
                           const Array6& q)
    : parameters_(parameters), poses_(poses), q_(q), membranes_(std::move(solved)) {
  take_geometry(geometry);
  solve_contacts();
}

void DesignForces::take_geometry(const DesignGeometry& geometry) {
  geometry_ = &geometry;
  system_.emplace(make_balance_system(geometry, parameters_));
}

void DesignForces::move(const FlatPoses& poses, const Array6& q, const Progress& progress) {
  poses_ = poses;
  q_ = q;
  solve_membranes(false, progress);
}

void DesignForces::move(const DesignGeometry& geometry, const FlatPoses& poses, const Array6& q,
                        const Progress& progress) {
  take_geometry(geometry);
  move(poses, q, progress);
}

void DesignForces::solve_membranes(bool fresh, const Progress& progress) {
  const TileMesh& tiles = geometry_->tiles;
  auto solve = [&](Side side, const Progress& sink) {
    SolvedMembrane& m = membranes_[static_cast<int>(side)];
    m.flat_corners = flat_pin_corners(tiles, poses_, q_, side);
    const Points3 actuated = actuated_pin_corners(tiles, q_, side, parameters_.H_pin);
    const Points2 flat = vertex_positions(m.mesh.weights, m.flat_corners);
    if (fresh) {
      m.actuated_corners = actuated;
      m.equilibrium = std::make_unique<MembraneEquilibrium>(m.mesh, flat, parameters_.tau,
                                                            membrane_material(parameters_, side));
      m.state = m.equilibrium->solve(
          m.equilibrium->energy().harmonic(vertex_positions(m.mesh.weights, actuated)),
          EquilibriumOptions{}, sink);
    } else {
      m.equilibrium->set_rest(flat, parameters_.tau);
      move_pins(m, actuated, EquilibriumOptions{}, sink);
    }
  };
  // The progress sink is called from one thread only; the other membrane ends by itself.
  bool going = true;
  parallel_tasks({[&] {
                    solve(Side::front, [&](const std::string& what, double fraction) {
                      return going = going && keep_going(progress, what, fraction);
                    });
                  },
                  [&] { solve(Side::back, {}); }});
  if (!going) throw Cancelled();
  solve_contacts();
}

void DesignForces::solve_contacts() {
  loads_ = weights(*geometry_, poses_, q_, parameters_);
  loads_ += carry(*geometry_, loads_, parameters_).table;
  for (Side side : sides) {
    const SolvedMembrane& m = membrane(side);
    // Rounding alone may keep a membrane from the last digits of its tolerance.
    if (!(m.state.solve.residual < 1e-6)) {
      throw SolverFailure(std::string("the ") + (side == Side::front ? "front" : "back") +
                              " membrane found no equilibrium",
                          "use the tension-field model");
    }
    add_wrenches(pin_corner_forces(m.mesh, m.state, geometry_->tiles.tile_count()),
                 m.actuated_corners, system_->centres(), loads_);
  }
  forces_ = solve_contact_forces(*system_, loads_);
}

}  // namespace curveups
