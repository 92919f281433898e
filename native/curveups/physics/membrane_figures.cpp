// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/membrane_figures.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace curveups {
namespace {

// Area of each triangle of the fine mesh in the flat layout: in proportion to that at rest.
Eigen::VectorXd flat_areas(const MembraneSolution& m) {
  const Points2 flat = m.fine.flat();
  Eigen::VectorXd out(static_cast<Eigen::Index>(m.fine.mesh.triangles.size()));
  for (Eigen::Index t = 0; t < out.size(); ++t) {
    const auto [a, b, c] = m.fine.mesh.triangles[static_cast<std::size_t>(t)];
    const Vec2 p = flat.row(a), q = flat.row(b), r = flat.row(c);
    out(t) = 0.5 * wedge(q - p, r - p);
  }
  return out;
}

}  // namespace

double wrinkled_fraction(const std::array<MembraneSolution, 2>& membranes) {
  double all = 0, wrinkled = 0;
  for (const MembraneSolution& m : membranes) {
    const Eigen::VectorXd area = flat_areas(m);
    all += area.sum();
    for (Eigen::Index t = 0; t < area.size(); ++t) {
      if (m.stretch[t].tension != MembraneTension::taut) wrinkled += area(t);
    }
  }
  return all > 0 ? wrinkled / all : 0.0;
}

std::vector<int> tiles_beside_slack(const MembraneSolution& m) {
  const Eigen::VectorXd area = flat_areas(m);
  std::vector<double> all(m.domain.patches.size(), 0), slack = all;
  for (Eigen::Index t = 0; t < area.size(); ++t) {
    const int patch = m.fine.mesh.patch[t];
    all[patch] += area(t);
    if (m.stretch[t].tension == MembraneTension::slack) slack[patch] += area(t);
  }
  std::set<int> tiles;
  for (std::size_t p = 0; p < all.size(); ++p) {
    if (slack[p] <= 0.1 * all[p]) continue;
    for (int tile : tiles_of(m.domain.patches[p])) tiles.insert(tile);
  }
  return {tiles.begin(), tiles.end()};
}

double stretch_of_all_but(double share, const std::array<MembraneSolution, 2>& membranes) {
  std::vector<std::pair<double, double>> parts;  // stretch, area
  double all = 0;
  for (const MembraneSolution& m : membranes) {
    const Eigen::VectorXd area = flat_areas(m);
    for (Eigen::Index t = 0; t < area.size(); ++t) {
      parts.emplace_back(m.stretch[t].larger, area(t));
    }
    all += area.sum();
  }
  std::sort(parts.begin(), parts.end());
  double above = 0;
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    above += part->second;
    if (above > share * all) return part->first;
  }
  return 0;
}

GlueFigures glue_figures(const TileMesh& tiles, const Array6& q,
                         const std::array<MembraneSolution, 2>& membranes,
                         const Parameters& parameters) {
  GlueFigures out;
  out.limit = parameters.glue_strength;
  std::set<int> overloaded;
  const int count = tiles.tile_count();
  for (Side side : {Side::front, Side::back}) {
    const SolvedMembrane& m = membranes[static_cast<int>(side)].fine;
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
      const GlueLoad load =
          area > 0 ? GlueLoad{i, side, along[i] / area, off[i] / around} : GlueLoad{i, side};
      if (out.shear.tile < 0 || load.shear > out.shear.shear) out.shear = load;
      if (load.peel > out.peel.peel) out.peel = load;
      if (load.shear > out.limit) overloaded.insert(i);
    }
  }
  out.overloaded.assign(overloaded.begin(), overloaded.end());
  return out;
}

std::array<double, 2> surplus_tension(const Parameters& p) {
  const double stretched = 1 - std::pow(p.tau, -6);
  return {p.shear_modulus_front * p.thickness_front * stretched,
          p.shear_modulus_back * p.thickness_back * stretched};
}

}  // namespace curveups
