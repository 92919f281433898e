// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/membrane_solution.hpp"

#include "curveups/core/errors.hpp"

namespace curveups {

MembraneMeshOptions membrane_mesh_options(const Parameters& parameters) {
  MembraneMeshOptions options;
  options.largest = parameters.mesh_size * parameters.L;
  options.at_corner = 0.5 * options.largest;
  options.growth = 0.8;
  return options;
}

MembraneMaterial membrane_material(const Parameters& p, Side side) {
  MembraneMaterial material;
  material.shear_modulus = side == Side::front ? p.shear_modulus_front : p.shear_modulus_back;
  material.thickness = side == Side::front ? p.thickness_front : p.thickness_back;
  material.model =
      p.membrane_model == "neo-hookean" ? MembraneModel::neo_hookean : MembraneModel::tension_field;
  return material;
}

MembraneSolution solve_membrane(const DesignGeometry& geometry, const FlatPoses& poses,
                                const Array6& q, const Parameters& parameters, Side side,
                                const Progress& progress) {
  const TileMesh& tiles = geometry.tiles;
  const std::string what = side == Side::front ? "front membrane" : "back membrane";
  const MembraneMaterial material = membrane_material(parameters, side);
  const EquilibriumOptions options;
  MembraneSolution out;
  out.domain = make_membrane_domain(tiles, side);
  const Points2 flat_corners = flat_pin_corners(tiles, poses, q, side);
  out.pin_corners = actuated_pin_corners(tiles, q, side, parameters.H_pin);
  const MembraneMesh coarse =
      make_membrane_mesh(out.domain, flat_corners, membrane_mesh_options(parameters), progress);
  Points3 coarse_x;
  {
    MembraneEquilibrium equilibrium(coarse, vertex_positions(coarse.weights, flat_corners),
                                    parameters.tau, material);
    const MembraneState state = equilibrium.solve(
        equilibrium.energy().harmonic(vertex_positions(coarse.weights, out.pin_corners)), options,
        progress, what);
    if (!keep_going(progress, what)) throw Cancelled();
    out.coarse_iterations = state.iterations;
    out.coarse_converged = state.converged;
    out.coarse_forces = pin_corner_forces(coarse, state, tiles.tile_count());
    coarse_x = state.x;
  }
  out.mesh = refine_mesh(coarse);
  out.flat = vertex_positions(out.mesh.weights, flat_corners);
  out.equilibrium =
      std::make_unique<MembraneEquilibrium>(out.mesh, out.flat, parameters.tau, material);
  const Points3 glued = vertex_positions(out.mesh.weights, out.pin_corners);
  out.state = out.equilibrium->solve(prolong(out.mesh, coarse_x, glued), options, progress, what);
  if (!keep_going(progress, what)) throw Cancelled();
  out.forces = pin_corner_forces(out.mesh, out.state, tiles.tile_count());
  out.stretch = out.equilibrium->energy().stretches(out.state.x);
  return out;
}

}  // namespace curveups
