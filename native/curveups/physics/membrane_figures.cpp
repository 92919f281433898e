// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/membrane_figures.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace curveups {
namespace {

// Twice the area of a triangle in the flat layout.
double flat_measure(const MembraneSolution& m, std::size_t t) {
  const auto [a, b, c] = m.mesh.triangles[t];
  const Vec2 p = m.flat.row(a), q = m.flat.row(b), r = m.flat.row(c);
  return wedge(q - p, r - p);
}

}  // namespace

MembraneAreas measure_areas(const MembraneSolution& m) {
  MembraneAreas areas;
  areas.patch.assign(m.domain.patches.size(), 0);
  areas.slack_patch = areas.patch;
  for (std::size_t t = 0; t < m.mesh.triangles.size(); ++t) {
    const double part = flat_measure(m, t);
    areas.all += part;
    areas.patch[m.mesh.patch[t]] += part;
    if (m.stretch[t].tension != MembraneTension::taut) areas.wrinkled += part;
    if (m.stretch[t].tension == MembraneTension::slack) {
      areas.slack += part;
      areas.slack_patch[m.mesh.patch[t]] += part;
    }
  }
  return areas;
}

std::vector<int> tiles_beside_slack(const MembraneSolution& m, const MembraneAreas& areas) {
  std::set<int> tiles;
  for (std::size_t p = 0; p < areas.patch.size(); ++p) {
    if (areas.slack_patch[p] <= 0.1 * areas.patch[p]) continue;
    for (int tile : tiles_of(m.domain.patches[p])) tiles.insert(tile);
  }
  return {tiles.begin(), tiles.end()};
}

double stretch_of_all_but(double share, const std::array<MembraneSolution, 2>& membranes) {
  std::vector<std::pair<double, double>> parts;  // stretch, area
  double all = 0;
  for (const MembraneSolution& m : membranes) {
    for (std::size_t t = 0; t < m.mesh.triangles.size(); ++t) {
      parts.emplace_back(m.stretch[t].larger, flat_measure(m, t));
      all += parts.back().second;
    }
  }
  std::sort(parts.begin(), parts.end());
  double above = 0;
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    above += part->second;
    if (above > share * all) return part->first;
  }
  return parts.empty() ? 0.0 : parts.front().first;
}

GlueLoads glue_loads(const TileMesh& tiles, const Array6& q,
                     const std::array<MembraneSolution, 2>& membranes,
                     const Parameters& parameters) {
  GlueLoads out;
  const int count = tiles.tile_count();
  for (Side side : {Side::front, Side::back}) {
    const MembraneSolution& m = membranes[static_cast<int>(side)];
    const double outward = side == Side::front ? 1.0 : -1.0;
    std::vector<double> along(count, 0), off(count, 0);  // N
    for (int v = 0; v < m.mesh.vertex_count(); ++v) {
      const int tile = m.mesh.pin[v];
      if (tile < 0) continue;
      // The membrane pulls where its energy falls.
      const Vec3 pull = -m.state.gradient.row(v).transpose();
      const Vec3 normal = outward * tiles.normal(tile);
      const double lifting = pull.dot(normal);
      along[tile] += (pull - lifting * normal).norm();
      off[tile] += std::max(0.0, lifting);
    }
    for (int i = 0; i < count; ++i) {
      const double area = pin_area(tiles, i, side, q.row(i).data());
      const std::array<Vec2, 3> corner = pin_corners(tiles, i, side, q.row(i).data());
      double around = 0;
      for (int t = 0; t < 3; ++t) around += (corner[next3(t)] - corner[t]).norm();
      GlueLoad load{i, side, 0, 0, parameters.glue_strength};
      if (area > 0) {
        load.shear = along[i] / area;
        load.peel = off[i] / around;
      }
      out[static_cast<int>(side)].push_back(load);
    }
  }
  return out;
}

LargestGlueLoads largest_of(const GlueLoads& loads) {
  LargestGlueLoads out;
  double share = -1;  // a pin even where none carries anything: it has a limit
  for (const std::vector<GlueLoad>& of_side : loads) {
    for (const GlueLoad& load : of_side) {
      if (load.shear / load.limit > share) {
        share = load.shear / load.limit;
        out.shear = load;
      }
      if (load.peel > out.peel.peel) out.peel = load;
    }
  }
  return out;
}

std::vector<int> overloaded_tiles(const GlueLoads& loads) {
  std::set<int> tiles;
  for (const std::vector<GlueLoad>& of_side : loads) {
    for (const GlueLoad& load : of_side) {
      if (load.shear > load.limit) tiles.insert(load.tile);
    }
  }
  return {tiles.begin(), tiles.end()};
}

std::array<double, 2> surplus_tension(const Parameters& parameters) {
  std::array<double, 2> out{};
  for (Side side : {Side::front, Side::back}) {
    MembraneMaterial m = membrane_material(parameters, side);
    m.constants.regularization = 0;  // nothing is slack
    Gradient32 F = Gradient32::Zero();
    F(0, 0) = F(1, 1) = parameters.tau;
    const double by_stretch = m.model->evaluate(F, m.constants, false).gradient[0];
    // Nominal stress times thickness, on an edge that is tau times as long as at rest.
    out[static_cast<int>(side)] = 0.5 * m.shear_modulus * m.thickness * by_stretch / parameters.tau;
  }
  return out;
}

}  // namespace curveups
