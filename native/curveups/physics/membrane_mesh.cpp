// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/membrane_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <unordered_map>

#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/geometry/planar_mesh.hpp"
#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {
namespace {

constexpr double most_triangles = 5e6;  // limit for a membrane; 20,000 tiles have some 800,000

// Size field h(r) = min(largest, at_corner + growth r) along a line from a pin corner, the number
// of edges of that size in a length, I(r) = integral of dr / h, and its inverse.
class Grading {
 public:
  explicit Grading(double largest) : h_(largest), c_(0.5 * largest), bend_((h_ - c_) / growth) {}
  double size(double r) const { return std::min(h_, c_ + growth * r); }
  double edges(double r) const {
    const double graded = std::log1p(growth * std::min(r, bend_) / c_) / growth;
    return graded + std::max(0.0, r - bend_) / h_;
  }
  double reach(double edges_from_corner) const {
    const double graded = edges(bend_);
    if (edges_from_corner <= graded) return std::expm1(growth * edges_from_corner) * c_ / growth;
    return bend_ + (edges_from_corner - graded) * h_;
  }
  // Points between two pin corners at distance `length`, as fractions of it.
  std::vector<double> fractions(double length) const {
    const double total = 2 * edges(0.5 * length);
    const int parts = std::max(1, static_cast<int>(std::ceil(total - 0.25)));
    std::vector<double> out;
    for (int k = 1; k < parts; ++k) {
      const double t = total * k / parts;
      out.push_back(t <= 0.5 * total ? reach(t) / length : 1 - reach(total - t) / length);
    }
    return out;
  }

 private:
  static constexpr double growth = 0.8;
  double h_, c_, bend_;
};

// Mean-value coordinates of a point strictly inside a simple polygon.
std::vector<double> mean_value_coordinates(const std::vector<Vec2>& polygon, const Vec2& p) {
  const int n = static_cast<int>(polygon.size());
  std::vector<double> half_tangent(n), weight(n);
  for (int i = 0; i < n; ++i) {
    const Vec2 a = polygon[i] - p, b = polygon[(i + 1) % n] - p;
    // tan(angle / 2) = sin / (1 + cos), without dividing by the lengths.
    half_tangent[i] = wedge(a, b) / (a.norm() * b.norm() + a.dot(b));
  }
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    weight[i] = (half_tangent[(i + n - 1) % n] + half_tangent[i]) / (polygon[i] - p).norm();
    sum += weight[i];
  }
  for (double& w : weight) w /= sum;
  return weight;
}

void push_vertex(MembraneMesh& mesh, const std::vector<int>& corners,
                 const std::vector<double>& weights, int pin) {
  mesh.weights.corner.insert(mesh.weights.corner.end(), corners.begin(), corners.end());
  mesh.weights.weight.insert(mesh.weights.weight.end(), weights.begin(), weights.end());
  mesh.weights.start.push_back(static_cast<int>(mesh.weights.corner.size()));
  mesh.pin.push_back(pin);
}

// Vertices at pin corners and along the patches' sides, each shared by the patches on it.
struct SharedVertices {
  std::vector<int> at_corner;  // vertex by pin corner, -1 where no patch uses it
  std::unordered_map<std::uint64_t, std::vector<int>> on_side;  // from the lower pin corner
};

SharedVertices make_shared_vertices(const MembraneDomain& domain, const Points2& flat,
                                    const Grading& grading, MembraneMesh& mesh) {
  SharedVertices shared;
  shared.at_corner.assign(3 * domain.tile_count, -1);
  for (const MembranePatch& patch : domain.patches) {
    for (int corner : patch.corners) shared.at_corner[corner] = 0;
  }
  for (std::size_t c = 0; c < shared.at_corner.size(); ++c) {
    if (shared.at_corner[c] < 0) continue;
    shared.at_corner[c] = mesh.vertex_count();
    push_vertex(mesh, {static_cast<int>(c)}, {1.0}, static_cast<int>(c) / 3);
  }
  shared.on_side.reserve(4 * domain.patches.size());
  for (const MembranePatch& patch : domain.patches) {
    for (std::size_t i = 0; i < patch.corners.size(); ++i) {
      const int a = patch.corners[i], b = patch.corners[(i + 1) % patch.corners.size()];
      const auto [it, fresh] = shared.on_side.emplace(edge_key(a, b), std::vector<int>());
      if (!fresh) continue;
      const int low = std::min(a, b), high = std::max(a, b);
      const double length = (flat.row(low) - flat.row(high)).norm();
      for (double t : grading.fractions(length)) {
        it->second.push_back(mesh.vertex_count());
        const bool glued = low / 3 == high / 3;
        push_vertex(mesh, {low, high}, {1 - t, t}, glued ? low / 3 : -1);
      }
    }
  }
  return shared;
}

std::vector<Vec2> outline(const MembranePatch& patch, const Points2& flat) {
  std::vector<Vec2> points;
  for (int corner : patch.corners) points.push_back(flat.row(corner).transpose());
  return points;
}

void check_patches(const MembraneDomain& domain, const Points2& flat) {
  const std::string side = side_name(domain.side);
  for (const MembranePatch& patch : domain.patches) {
    if (is_simple_polygon(outline(patch, flat))) continue;
    const std::vector<int> tiles = tiles_of(patch);
    throw InfeasibleDesign("the " + side + " membrane between " + tile_names(tiles) +
                               " folds over itself in the layout",
                           "lay these tiles out without overlap", tiles);
  }
}

// Refuses endless work: lengths of the layout in another unit than L, or a tile far away from its
// neighbours.
void require_few_triangles(const MembraneDomain& domain, const Points2& flat, double largest) {
  double triangles = 0;
  for (const MembranePatch& patch : domain.patches) {
    const std::vector<Vec2> points = outline(patch, flat);
    double area = 0, round = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 &a = points[i], &b = points[(i + 1) % points.size()];
      area += 0.5 * wedge(a - points[0], b - points[0]);
      round += (b - a).norm();
    }
    triangles += area / (std::sqrt(3.0) / 4 * largest * largest) + round / largest;
  }
  if (triangles < most_triangles) return;
  throw InvalidInput("a membrane would need about " +
                         std::to_string(static_cast<long long>(std::min(triangles, 1e18))) +
                         " triangles of " + std::to_string(largest) + " mm",
                     "check the layout's lengths against L");
}

// Mesh of one patch: its boundary from the shared vertices, then the points inside.
struct MeshedPatch {
  std::vector<int> boundary;  // mesh vertices
  PlanarMesh mesh;
  std::vector<std::vector<double>> inner_weights;
};

MeshedPatch mesh_patch(const MembranePatch& patch, const Points2& flat,
                       const SharedVertices& shared, const Points2& positions,
                       const Grading& grading) {
  MeshedPatch out;
  const std::vector<Vec2> corners = outline(patch, flat);
  std::vector<Vec2> boundary;
  auto push = [&](int vertex) {
    out.boundary.push_back(vertex);
    boundary.push_back(positions.row(vertex).transpose());
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const int a = patch.corners[i], b = patch.corners[(i + 1) % corners.size()];
    push(shared.at_corner[a]);
    const std::vector<int>& between = shared.on_side.at(edge_key(a, b));
    if (a < b) {
      for (auto v = between.begin(); v != between.end(); ++v) push(*v);
    } else {
      for (auto v = between.rbegin(); v != between.rend(); ++v) push(*v);
    }
  }
  out.mesh = mesh_polygon(boundary, [&](const Vec2& p) {
    double nearest = (corners[0] - p).squaredNorm();
    for (const Vec2& corner : corners) nearest = std::min(nearest, (corner - p).squaredNorm());
    return grading.size(std::sqrt(nearest));
  });
  for (std::size_t v = boundary.size(); v < out.mesh.points.size(); ++v) {
    out.inner_weights.push_back(mean_value_coordinates(corners, out.mesh.points[v]));
  }
  return out;
}

}  // namespace

MembraneMesh make_membrane_mesh(const MembraneDomain& domain, const Points2& flat, double largest,
                                const Progress& progress) {
  check_patches(domain, flat);
  require_few_triangles(domain, flat, largest);
  const Grading grading(largest);
  if (!keep_going(progress, "meshing membranes")) throw Cancelled();
  MembraneMesh mesh;
  const SharedVertices shared = make_shared_vertices(domain, flat, grading, mesh);
  std::vector<MeshedPatch> patches(domain.patches.size());
  const Points2 positions = vertex_positions(mesh.weights, flat);
  parallel_for(static_cast<int>(patches.size()), [&](int p) {
    patches[p] = mesh_patch(domain.patches[p], flat, shared, positions, grading);
  });
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const MeshedPatch& patch = patches[p];
    const int first = mesh.vertex_count(), boundary = static_cast<int>(patch.boundary.size());
    for (const std::vector<double>& weights : patch.inner_weights) {
      push_vertex(mesh, domain.patches[p].corners, weights, -1);
    }
    for (const std::array<int, 3>& t : patch.mesh.triangles) {
      std::array<int, 3> global{};
      for (int c = 0; c < 3; ++c) {
        global[c] = t[c] < boundary ? patch.boundary[t[c]] : first + t[c] - boundary;
      }
      mesh.triangles.push_back(global);
      mesh.patch.push_back(static_cast<int>(p));
    }
  }
  return mesh;
}

MembraneMesh refine_mesh(const MembraneMesh& mesh) {
  MembraneMesh fine;
  fine.weights = mesh.weights;
  fine.pin = mesh.pin;
  fine.triangles.reserve(4 * mesh.triangles.size());
  fine.patch.reserve(4 * mesh.triangles.size());
  std::unordered_map<std::uint64_t, int> middle;
  middle.reserve(2 * mesh.triangles.size());
  auto midpoint = [&](int a, int b) {
    const auto [it, fresh] = middle.emplace(edge_key(a, b), fine.vertex_count());
    if (!fresh) return it->second;
    std::vector<int> corners;
    std::vector<double> weights;
    for (int v : {a, b}) {
      for (int k = mesh.weights.start[v]; k < mesh.weights.start[v + 1]; ++k) {
        const int corner = mesh.weights.corner[k];
        const auto known = std::find(corners.begin(), corners.end(), corner);
        if (known == corners.end()) {
          corners.push_back(corner);
          weights.push_back(0.5 * mesh.weights.weight[k]);
        } else {
          weights[known - corners.begin()] += 0.5 * mesh.weights.weight[k];
        }
      }
    }
    // Two vertices of one pin are joined along its edge only.
    const int pin = mesh.pin[a] == mesh.pin[b] ? mesh.pin[a] : -1;
    push_vertex(fine, corners, weights, pin);
    fine.parents.push_back({a, b});
    return it->second;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    const int ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    fine.triangles.push_back({a, ab, ca});
    fine.triangles.push_back({ab, b, bc});
    fine.triangles.push_back({ca, bc, c});
    fine.triangles.push_back({ab, bc, ca});
    fine.patch.insert(fine.patch.end(), 4, mesh.patch[t]);
  }
  return fine;
}

}  // namespace curveups
