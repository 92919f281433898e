// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/actuation/surplus.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "curveups/bodies/anchors.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/geometry/planar_mesh.hpp"

namespace curveups {
namespace {

// As the sheets of a kit have them (stages/sheets.py), mm.
constexpr double ring_margin = 10, tooth_pitch = 15;
// Wider ones would be endless work: mm, and times L.
constexpr double widest_layout = 1e4, most_tiles_across = 1000;
constexpr int anchor_corners = 8;

Vec2 anchor_corner(double radius, int k) {
  const double angle = 2 * M_PI * (k + 0.5) / anchor_corners;
  return radius * Vec2(std::cos(angle), std::sin(angle));
}

// A prism for an anchor's cylinder, from -height / 2 to height / 2.
RigidBody anchor_body(double radius, double height, double modulus) {
  RigidBody out;
  BodySurface top{Vec3::UnitZ(), 0.5 * height, {}}, bottom{-Vec3::UnitZ(), 0.5 * height, {}};
  for (int k = 0; k < anchor_corners; ++k) {
    const Vec2 a = anchor_corner(radius, k), b = anchor_corner(radius, k + 1);
    const double h = 0.5 * height;
    const Vec3 normal(a.x() + b.x(), a.y() + b.y(), 0);
    out.faces.push_back(
        {normal.normalized(),
         normal.normalized().head<2>().dot(a),
         {{a.x(), a.y(), -h}, {b.x(), b.y(), -h}, {b.x(), b.y(), h}, {a.x(), a.y(), h}}});
    top.outline.emplace_back(a.x(), a.y(), h);
    bottom.outline.emplace_back(a.x(), -a.y(), -h);
  }
  out.faces.push_back(std::move(top));
  out.faces.push_back(std::move(bottom));
  for (BodySurface& face : out.faces) face.stiffness = modulus / radius;
  return out;
}

// Where the print has anchors, before it is divided. Bumps and cut corners of tiles are left out:
// they shift an anchor by tenths of a millimetre.
std::vector<Vec2> anchors_of(const TileBodies& bodies) {
  const TileMesh& tiles = bodies.geometry.tiles;
  const std::vector<int> piece = pieces_of_faces(tiles.topology, tiles.cut);
  std::vector<PieceFootprint> pieces;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    if (piece[i] >= static_cast<int>(pieces.size())) pieces.resize(piece[i] + 1);
    std::vector<Vec2> seen;
    for (Side side : {Side::front, Side::back}) {
      for (const Vec2& p : place(bodies.poses, i, tiles.corners(i, side))) seen.push_back(p);
    }
    pieces[piece[i]].tiles.push_back(convex_hull(std::move(seen)));
  }
  join_footprints(pieces, piece, tiles, bodies.poses);
  std::vector<Vec2> out;
  for (const std::vector<Vec2>& one : place_anchors(pieces, bodies.parameters)) {
    out.insert(out.end(), one.begin(), one.end());
  }
  return out;
}

// Edges of pins and of the membrane between them that are sides of one such polygon alone: where
// the surplus begins. As pin corner numbers.
std::vector<std::array<int, 2>> border_of(const MembraneDomain& domain) {
  std::map<std::pair<int, int>, int> sides;
  auto go_round = [&](const std::vector<int>& corners) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      ++sides[std::minmax(corners[k], corners[(k + 1) % corners.size()])];
    }
  };
  for (int i = 0; i < domain.tile_count; ++i) go_round({3 * i, 3 * i + 1, 3 * i + 2});
  for (const MembranePatch& patch : domain.patches) go_round(patch.corners);
  std::vector<std::array<int, 2>> out;
  for (const auto& [side, count] : sides) {
    if (count == 1) out.push_back({side.first, side.second});
  }
  return out;
}

}  // namespace

Surplus::Surplus(const TileBodies& bodies, int first) : first_(first), tau_(bodies.parameters.tau) {
  const Parameters& p = bodies.parameters;
  const TileMesh& tiles = bodies.geometry.tiles;
  Box box;
  auto add = [&](const Vec2& at, double radius) {
    for (double r : {-radius, radius}) box.add(Vec3(at.x() + r, at.y() + r, 0));
  };
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (const Vec2& corner : place(bodies.poses, i, tiles.front[i])) add(corner, 0);
  }
  const double wide = (box.high - box.low).maxCoeff();
  if (!(wide < std::min(widest_layout, most_tiles_across * p.L))) {
    throw InfeasibleDesign("the layout is wider than 10 m or 1000 tiles",
                           "bring tiles that lie far away back to the others");
  }
  std::vector<Vec2> anchors;
  if (p.anchors) anchors = anchors_of(bodies);
  for (const Vec2& centre : anchors) add(centre, p.anchor_radius);
  anchor_count_ = static_cast<int>(anchors.size());
  box_ = (box.high - box.low).head<2>();
  window_ = ((box_.array() + 2 * ring_margin) / tooth_pitch).ceil() * tooth_pitch;
  const double height = p.H_body + 2 * p.H_pin;
  for (const Vec2& centre : anchors) {
    bodies_.push_back(anchor_body(p.anchor_radius, height, p.tile_modulus));
    poses_.push_back({Eigen::Matrix3d::Identity(), Vec3(centre.x(), centre.y(), -0.5 * p.H_body)});
  }
  const Vec2 middle = 0.5 * (box.high + box.low).head<2>();
  for (Side side : {Side::front, Side::back}) {
    sheets_[static_cast<int>(side)] = make_sheet(bodies, side, anchors, middle);
  }
}

Surplus::Sheet Surplus::make_sheet(const TileBodies& bodies, Side side,
                                   const std::vector<Vec2>& anchors, const Vec2& middle) {
  const Parameters& p = bodies.parameters;
  const TileMesh& tiles = bodies.geometry.tiles;
  const double z = side == Side::front ? p.H_pin : -p.H_body - p.H_pin, length = p.L;
  const double up = (side == Side::front ? 0.5 : -0.5) * (p.H_body + 2 * p.H_pin);
  Sheet out;
  out.material = membrane_material(p, side);
  std::vector<Vec2> at;
  auto push = [&](int body, const Vec3& own, const Vec2& flat) {
    out.points.push_back({body, own});
    at.push_back(flat);
  };
  auto push_node = [&](const Vec2& flat) {
    push(first_ + static_cast<int>(bodies_.size()), Vec3::Zero(), flat);
    bodies_.emplace_back();
    poses_.push_back({Eigen::Matrix3d::Identity(), Vec3(flat.x(), flat.y(), z)});
  };

  const Points3 centres = tile_centres(tiles);
  const Points3 corners = actuated_pin_corners(tiles, bodies.q, side, p.H_pin);
  const Points2 flat = flat_pin_corners(tiles, bodies.poses, bodies.q, side);
  std::vector<Vec2> holes;
  for (int c = 0; c < flat.rows(); ++c) {
    push(c / 3, (corners.row(c) - centres.row(c / 3)).transpose(), flat.row(c).transpose());
    if (c % 3 == 2) holes.push_back((at[c - 2] + at[c - 1] + at[c]) / 3);
  }
  std::vector<std::array<int, 2>> edges = border_of(make_membrane_domain(tiles, side));
  auto close = [&](int begin) {
    const int end = static_cast<int>(at.size());
    for (int k = begin; k < end; ++k) edges.push_back({k, k + 1 < end ? k + 1 : begin});
  };
  for (std::size_t k = 0; k < anchors.size(); ++k) {
    const int begin = static_cast<int>(at.size());
    for (int c = 0; c < anchor_corners; ++c) {
      const Vec2 own = anchor_corner(p.anchor_radius, c);
      push(first_ + static_cast<int>(k), Vec3(own.x(), own.y(), up), anchors[k] + own);
    }
    close(begin);
    holes.push_back(anchors[k]);
  }
  out.rim = static_cast<int>(bodies_.size());
  const int begin = static_cast<int>(at.size());
  const std::array<Vec2, 4> turn = {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)};
  for (int k = 0; k < 4; ++k) {
    const Vec2 from = middle + 0.5 * window_.cwiseProduct(turn[k]),
               to = middle + 0.5 * window_.cwiseProduct(turn[(k + 1) % 4]);
    const int parts = static_cast<int>(std::ceil((to - from).norm() / length));
    for (int j = 0; j < parts; ++j) push_node(from + (to - from) * j / parts);
  }
  close(begin);
  out.rim_end = static_cast<int>(bodies_.size());
  PlanarMesh mesh;
  try {
    mesh = mesh_region(at, edges, holes, [&](const Vec2&) { return length; });
  } catch (const InvalidInput&) {
    throw InfeasibleDesign(std::string("the ") + (side == Side::front ? "front" : "back") +
                               " membrane folds over itself at the layout's border",
                           "lay tiles out without overlap");
  }
  for (std::size_t v = at.size(); v < mesh.points.size(); ++v) push_node(mesh.points[v]);
  out.triangles = std::move(mesh.triangles);
  out.flat.resize(static_cast<Eigen::Index>(at.size()), 2);
  for (std::size_t v = 0; v < at.size(); ++v) out.flat.row(v) = at[v].transpose();
  return out;
}

void Surplus::add_to(ContactWorld& world, std::array<bool, 2> held) const {
  std::vector<RigidBody> bodies = bodies_;
  for (int s = 0; s < 2; ++s) {
    const Sheet& sheet = sheets_[s];
    for (int k = sheet.rim; k < sheet.rim_end; ++k) bodies[k].fixed = held[s];
    world.add(std::make_unique<ReducedMembrane>(sheet.points, sheet.flat, sheet.triangles, tau_,
                                                sheet.material));
  }
  world.append(bodies, poses_);
}

}  // namespace curveups
