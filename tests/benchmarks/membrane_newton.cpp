// SPDX-License-Identifier: LGPL-2.1-or-later
// A front membrane by this project's way (tension field, started on the coarser mesh, factors used
// again) and by plain Newton: the energy of the paper, triangle by triangle projected to positive
// semidefinite, from the harmonic start on the finer mesh, a factorization a step. One thread, the
// same mesh, assembly, factorization and tolerance.
//
//   membrane_newton DESIGN.json ...
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iostream>
#include <sstream>

#include "curveups/core/parallel.hpp"
#include "curveups/design/design_file.hpp"
#include "curveups/physics/membrane_solution.hpp"

namespace curveups {
namespace {

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Outcome {
  Points3 x;
  int steps = 0;
  double residual = 0;  // largest force on a free vertex over the mean of glued ones
};

double residual_of(const MembraneEnergy& energy, const Points3& gradient) {
  double largest = 0, glued = 0;
  int count = 0;
  for (int v = 0; v < gradient.rows(); ++v) {
    const double force = gradient.row(v).norm();
    if (energy.is_free(v)) {
      largest = std::max(largest, force);
    } else {
      glued += force, ++count;
    }
  }
  return largest * count / glued;
}

Outcome plain_newton(const MembraneEnergy& energy, const Points3& glued, double tolerance) {
  Outcome out;
  out.x = energy.harmonic(glued);
  BlockMatrix<3> hessian(energy.pattern());
  Points3 gradient, trial_gradient;
  for (; out.steps < 200; ++out.steps) {
    const double value = energy.gradient(out.x, gradient, &hessian, true);
    out.residual = residual_of(energy, gradient);
    if (out.residual <= tolerance || !hessian.factorize()) break;
    const Eigen::MatrixXd solved =
        hessian.solve(-Eigen::Map<const Eigen::VectorXd>(gradient.data(), gradient.size()));
    const Eigen::Map<const Points3> step(solved.data(), gradient.rows(), 3);
    const double slope = step.cwiseProduct(gradient).sum();
    double length = 1;
    for (; length > 1e-8; length *= 0.5) {
      const double after = energy.gradient(out.x + length * step, trial_gradient);
      if (after <= value + 1e-4 * length * slope + 1e-13 * std::abs(value)) break;
    }
    if (length <= 1e-8) break;
    out.x += length * step;
  }
  return out;
}

void compare(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  const Design design = read_design(text.str());
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  const FlatPoses poses = fit_poses(geometry.tiles, design.T);

  double begun = processor_seconds();
  const MembraneSolution own =
      std::move(solve_membranes(geometry, poses, design.q, design.parameters, {})[0]);
  const double own_seconds = processor_seconds() - begun;

  MembraneMaterial material = membrane_material(design.parameters, Side::front);
  material.model = &density_model("neo-hookean");
  begun = processor_seconds();
  const MembraneEnergy energy(own.mesh, own.flat, design.parameters.tau, material);
  const Outcome plain = plain_newton(energy, vertex_positions(own.mesh.weights, own.pin_corners),
                                     EquilibriumOptions{}.tolerance);
  const double plain_seconds = processor_seconds() - begun;
  std::printf("%-16s %9d %4d + %-3d %7.2f %6d %8.2f %6.1f %9.1e %9.1e\n", design.name.c_str(),
              static_cast<int>(own.mesh.triangles.size()), own.coarse.state.solve.iterations,
              own.state.solve.iterations, own_seconds, plain.steps, plain_seconds,
              plain_seconds / own_seconds, own.state.solve.residual, plain.residual);
  std::fflush(stdout);
}

}  // namespace
}  // namespace curveups

int main(int count, char** values) {
  curveups::set_thread_count(1);
  std::printf("%-16s %9s %10s %7s %6s %8s %6s %9s %9s\n", "design", "triangles", "steps", "s",
              "plain", "s", "ratio", "residual", "plain");
  try {
    for (int k = 1; k < count; ++k) curveups::compare(values[k]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
  return 0;
}
