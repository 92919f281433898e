// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/membrane_solution.hpp"

#include "curveups/core/parallel.hpp"

namespace curveups {

SolverFailure no_equilibrium(Side side) {
  return SolverFailure(std::string("the ") + (side == Side::front ? "front" : "back") +
                           " membrane found no equilibrium",
                       "use the tension-field model");
}

MembraneMeshOptions membrane_mesh_options(const Parameters& parameters) {
  MembraneMeshOptions options;
  options.largest = parameters.mesh_size * parameters.L;
  options.at_corner = 0.5 * options.largest;
  return options;
}

MembraneMaterial membrane_material(const Parameters& p, Side side) {
  MembraneMaterial material;
  material.shear_modulus = side == Side::front ? p.shear_modulus_front : p.shear_modulus_back;
  material.thickness = side == Side::front ? p.thickness_front : p.thickness_back;
  material.model = &density_model(p.membrane_model);
  return material;
}

MembraneEquilibrium membrane_equilibrium(const MembraneMesh& mesh, const Points2& flat,
                                         const Parameters& parameters, Side side) {
  return MembraneEquilibrium(mesh, flat, parameters.tau, membrane_material(parameters, side));
}

bool move_pins(SolvedMembrane& m, MembraneEquilibrium& equilibrium, const Points3& actuated_corners,
               const Progress& progress) {
  Points3 start = vertex_positions(m.mesh.weights, actuated_corners);
  start += m.state.x - vertex_positions(m.mesh.weights, m.actuated_corners);
  m.actuated_corners = actuated_corners;
  m.state = equilibrium.solve(start, {}, progress);
  // Rounding alone may keep a membrane from the last digits of its tolerance.
  return m.state.solve.residual < 1e-6;
}

namespace {

MembraneSolution solve_membrane(const DesignGeometry& geometry, const FlatPoses& poses,
                                const Array6& q, const Parameters& parameters, Side side,
                                const std::vector<int>& halvings, const Progress& progress) {
  const TileMesh& tiles = geometry.tiles;
  const std::string what = side == Side::front ? "front membrane" : "back membrane";
  const EquilibriumOptions options;
  MembraneSolution out;
  out.domain = make_membrane_domain(tiles, side);
  out.pin_corners = actuated_pin_corners(tiles, q, side, parameters.H_pin);
  SolvedMembrane& coarse = out.coarse;
  coarse.flat_corners = flat_pin_corners(tiles, poses, q, side);
  coarse.actuated_corners = out.pin_corners;
  MembraneMeshOptions sizes = membrane_mesh_options(parameters);
  sizes.halvings = halvings;
  coarse.mesh = make_membrane_mesh(out.domain, coarse.flat_corners, sizes, progress);
  {
    MembraneEquilibrium equilibrium = membrane_equilibrium(
        coarse.mesh, vertex_positions(coarse.mesh.weights, coarse.flat_corners), parameters, side);
    coarse.state = equilibrium.solve(
        equilibrium.energy().harmonic(vertex_positions(coarse.mesh.weights, out.pin_corners)),
        options, progress, what);
  }
  if (!keep_going(progress, what)) throw Cancelled();
  out.coarse_forces = pin_corner_forces(coarse.mesh, coarse.state, tiles.tile_count());

  out.mesh = refine_mesh(coarse.mesh);
  out.flat = vertex_positions(out.mesh.weights, coarse.flat_corners);
  MembraneEquilibrium equilibrium = membrane_equilibrium(out.mesh, out.flat, parameters, side);
  const Points3 glued = vertex_positions(out.mesh.weights, out.pin_corners);
  out.state = equilibrium.solve(prolong(out.mesh, coarse.state.x, glued), options, progress, what);
  if (!keep_going(progress, what)) throw Cancelled();
  out.forces = pin_corner_forces(out.mesh, out.state, tiles.tile_count());
  out.stretch = equilibrium.energy().stretches(out.state.x);
  out.free_vertices = equilibrium.energy().free_count();
  return out;
}

}  // namespace

std::array<MembraneSolution, 2> solve_membranes(const DesignGeometry& geometry,
                                                const FlatPoses& poses, const Array6& q,
                                                const Parameters& parameters,
                                                const Progress& progress,
                                                const std::vector<int>& halvings) {
  const Progress serial = one_at_a_time(progress);
  std::array<MembraneSolution, 2> out;
  auto solve = [&](Side side) {
    const int s = static_cast<int>(side);
    out[s] = solve_membrane(geometry, poses, q, parameters, side, halvings, serial);
  };
  parallel_tasks({[&] { solve(Side::front); }, [&] { solve(Side::back); }});
  return out;
}

bool move_pins(MembraneSolution& solution, const Points3& corners, const Parameters& parameters) {
  const int tiles = solution.domain.tile_count;
  const Side side = solution.domain.side;
  SolvedMembrane& coarse = solution.coarse;
  MembraneEquilibrium rough = membrane_equilibrium(
      coarse.mesh, vertex_positions(coarse.mesh.weights, coarse.flat_corners), parameters, side);
  if (!move_pins(coarse, rough, corners)) return false;
  solution.coarse_forces = pin_corner_forces(coarse.mesh, coarse.state, tiles);
  SolvedMembrane fine{
      std::move(solution.mesh), {}, std::move(solution.pin_corners), std::move(solution.state)};
  MembraneEquilibrium equilibrium =
      membrane_equilibrium(fine.mesh, solution.flat, parameters, side);
  const bool at_rest = move_pins(fine, equilibrium, corners);
  solution.forces = pin_corner_forces(fine.mesh, fine.state, tiles);
  solution.stretch = equilibrium.energy().stretches(fine.state.x);
  solution.mesh = std::move(fine.mesh);
  solution.pin_corners = std::move(fine.actuated_corners);
  solution.state = std::move(fine.state);
  return at_rest;
}

}  // namespace curveups
