// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/layout_figures.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/geometry/conformal_map.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/layout/layout_terms.hpp"

namespace curveups {
namespace {

constexpr double least_scale = 1e-6;

}  // namespace

Eigen::VectorXd relative_scale(const TileMesh& tiles) {
  Eigen::VectorXd out(tiles.tile_count());
  for (const MeshPiece& piece : cut_into_pieces(tiles.mesh, tiles.topology, tiles.cut)) {
    const Eigen::VectorXd scale = conformal_scale(piece.mesh, conformal_map(piece.mesh));
    double sum = 0, area = 0;
    for (std::size_t k = 0; k < piece.faces.size(); ++k) {
      const double s = scale[static_cast<Eigen::Index>(k)], a = tiles.area[piece.faces[k]];
      if (s > 0) sum += a * std::log(s), area += a;
    }
    const double mean = area > 0 ? std::exp(sum / area) : 1.0;
    for (std::size_t k = 0; k < piece.faces.size(); ++k) {
      out[piece.faces[k]] = std::max(least_scale, scale[static_cast<Eigen::Index>(k)] / mean);
    }
  }
  return out;
}

double scale_spread(const Eigen::VectorXd& scale) { return scale.maxCoeff() / scale.minCoeff(); }

Eigen::VectorXd spring_ratios(const DesignGeometry& geometry, const Parameters& parameters,
                              const FlatPoses& poses, const Array6& q) {
  const LayoutModel model = make_layout_model(geometry, parameters);
  const LayoutState state = state_of(model, poses, q);
  const auto spring = make_spring_energy(model);
  Eigen::VectorXd out(spring->element_count());
  LayoutTerm::Value block;
  for (int b = 0; b < spring->element_count(); ++b) {
    spring->at(b, state, false, block);
    out[b] = block.value.head(spring->dimension()).norm();
  }
  return out;
}

LayoutFigures layout_figures(const DesignGeometry& geometry, const Parameters& parameters,
                             const FlatPoses& poses, const Array6& q) {
  LayoutFigures out;
  const TileMesh& tiles = geometry.tiles;
  out.scale_spread = scale_spread(relative_scale(tiles));
  out.area_ratio = flat_area(geometry, flat_corners(tiles, poses)) / tiles.area.sum();
  if (tiles.contacts.empty()) return out;
  const LayoutModel model = make_layout_model(geometry, parameters);
  const LayoutState state = state_of(model, poses, q);
  for (const auto& term : make_energies(model)) out.energy += 2 * term->value(state);
  out.energy /= static_cast<double>(tiles.contacts.size());
  const Eigen::VectorXd springs = spring_ratios(geometry, parameters, poses, q);
  out.spring_mean = springs.mean();
  out.slack_springs = static_cast<int>((springs.array() > 1).count());
  return out;
}

}  // namespace curveups
