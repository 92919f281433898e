// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/membrane_solution.hpp"

#include "curveups/core/parallel.hpp"

namespace curveups {

Wrenches membrane_wrenches(const MembraneMesh& mesh, const MembraneState& state,
                           const Points3& centres) {
  Wrenches out = Wrenches::Zero(centres.rows(), 6);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const int tile = mesh.pin[v];
    if (tile < 0) continue;
    const Vec3 force = -state.gradient.row(v), arm = state.x.row(v) - centres.row(tile);
    out.row(tile).head<3>() += force.transpose();
    out.row(tile).tail<3>() += arm.cross(force).transpose();
  }
  return out;
}

Wrenches extrapolated_wrenches(const MembraneSolution& m, const Points3& centres) {
  return extrapolate(membrane_wrenches(m.fine.mesh, m.fine.state, centres),
                     membrane_wrenches(m.coarse.mesh, m.coarse.state, centres));
}

SolverFailure no_equilibrium(Side side) {
  return SolverFailure(std::string("the ") + side_name(side) + " membrane found no equilibrium",
                       "use the tension-field model");
}

double membrane_mesh_size(const Parameters& parameters) {
  return parameters.mesh_size * parameters.L;
}

MembraneMaterial membrane_material(const Parameters& p, Side side) {
  MembraneMaterial material;
  material.shear_modulus = side == Side::front ? p.shear_modulus_front : p.shear_modulus_back;
  material.thickness = side == Side::front ? p.thickness_front : p.thickness_back;
  material.model = &density_model(p.membrane_model);
  return material;
}

MembraneEquilibrium membrane_equilibrium(const SolvedMembrane& membrane,
                                         const Parameters& parameters, Side side) {
  return MembraneEquilibrium(membrane.mesh, membrane.flat(), parameters.tau,
                             membrane_material(parameters, side));
}

namespace {

MembraneSolution solve_membrane(const DesignGeometry& geometry, const FlatPoses& poses,
                                const Array6& q, const Parameters& parameters, Side side,
                                const Progress& progress) {
  const std::string what = std::string(side_name(side)) + " membrane";
  MembraneSolution out;
  out.domain = make_membrane_domain(geometry.tiles, side);
  SolvedMembrane &coarse = out.coarse, &fine = out.fine;
  coarse.flat_corners = fine.flat_corners = flat_pin_corners(geometry.tiles, poses, q, side);
  coarse.actuated_corners = fine.actuated_corners =
      actuated_pin_corners(geometry.tiles, q, side, parameters.H_pin);
  coarse.mesh =
      make_membrane_mesh(out.domain, coarse.flat_corners, membrane_mesh_size(parameters), progress);
  coarse.state =
      membrane_equilibrium(coarse, parameters, side)
          .solve(vertex_positions(coarse.mesh.weights, coarse.actuated_corners), progress, what);
  if (!keep_going(progress, what)) throw Cancelled();
  fine.mesh = refine_mesh(coarse.mesh);
  MembraneEquilibrium equilibrium = membrane_equilibrium(fine, parameters, side);
  const Points3 glued = vertex_positions(fine.mesh.weights, fine.actuated_corners);
  fine.state = equilibrium.solve(prolong(fine.mesh, coarse.state.x, glued), progress, what);
  if (!keep_going(progress, what)) throw Cancelled();
  out.stretch = equilibrium.energy().stretches(fine.state.x);
  return out;
}

}  // namespace

std::array<MembraneSolution, 2> solve_membranes(const DesignGeometry& geometry,
                                                const FlatPoses& poses, const Array6& q,
                                                const Parameters& parameters,
                                                const Progress& progress) {
  const Progress serial = one_at_a_time(progress);
  std::array<MembraneSolution, 2> out;
  parallel_for(2, [&](int s) {
    out[s] = solve_membrane(geometry, poses, q, parameters, static_cast<Side>(s), serial);
  });
  return out;
}

bool move_pins(SolvedMembrane& m, MembraneEquilibrium& equilibrium, const Points3& actuated_corners,
               const Progress& progress) {
  Points3 start = vertex_positions(m.mesh.weights, actuated_corners);
  start += m.state.x - vertex_positions(m.mesh.weights, m.actuated_corners);
  m.actuated_corners = actuated_corners;
  m.state = equilibrium.solve(start, progress);
  // Rounding alone may keep a membrane from the last digits of its tolerance.
  return m.state.solve.residual < 1e-6;
}

bool move_pins(MembraneSolution& solution, const Points3& corners, const Parameters& parameters) {
  bool at_rest = true;
  for (SolvedMembrane* m : {&solution.coarse, &solution.fine}) {
    MembraneEquilibrium equilibrium = membrane_equilibrium(*m, parameters, solution.domain.side);
    at_rest = move_pins(*m, equilibrium, corners) && at_rest;
    if (m == &solution.fine) solution.stretch = equilibrium.energy().stretches(m->state.x);
  }
  return at_rest;
}

}  // namespace curveups
