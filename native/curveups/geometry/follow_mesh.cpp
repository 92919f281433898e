// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/follow_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/disjoint_sets.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/geometry/even_edges.hpp"
#include "curveups/geometry/follow_lines.hpp"
#include "curveups/geometry/line_spacing.hpp"
#include "curveups/geometry/local_edits.hpp"
#include "curveups/geometry/surface_deviation.hpp"
#include "curveups/numerics/sparse_cholesky.hpp"

namespace curveups {
namespace {

constexpr double corner_angle = 40 * 3.14159265358979323846 / 180;
// Distance of the mean edge from L, and of the surface from the tiles, over L; share of new tiles.
constexpr double most_off = 0.15, most_distance = 0.5, most_new = 0.25;
// Edges are relaxed beyond these shares of the mean edge, if they have changed by `changed` beside
// the others; and split or collapsed beyond these.
constexpr double relax_above = 1.3, relax_below = 0.75, changed = 0.1;
constexpr double split_above = 1.4, collapse_below = 0.65;
constexpr int relaxing_rings = 3, relaxing_passes = 24, edit_rounds = 4, projection_rounds = 6;

// Smooths fields on the vertices of a tiling: (diagonal I + graph Laplacian) x = right side, where
// `fixed` vertices keep their values.
class Smoothing {
 public:
  Smoothing(const MeshTopology& topology, const std::vector<char>& fixed, double diagonal)
      : topology_(topology), unknown_(fixed.size(), -1) {
    int count = 0;
    for (std::size_t v = 0; v < fixed.size(); ++v) {
      if (!fixed[v]) unknown_[v] = count++;
    }
    count_ = count;
    std::vector<Eigen::Triplet<double>> entries;
    for (int k = 0; k < count; ++k) entries.emplace_back(k, k, diagonal);
    for (const MeshEdge& edge : topology.edges) {
      const int a = unknown_[edge.v[0]], b = unknown_[edge.v[1]];
      if (a >= 0) entries.emplace_back(a, a, 1);
      if (b >= 0) entries.emplace_back(b, b, 1);
      if (a >= 0 && b >= 0) entries.emplace_back(std::max(a, b), std::min(a, b), -1);
    }
    SparseMatrix lower(count, count);
    lower.setFromTriplets(entries.begin(), entries.end());
    if (count > 0 && !factor_.factorize(lower)) {
      throw SolverFailure("the tiles could not be smoothed", "remesh the surface");
    }
  }

  // right: per vertex. Values of fixed vertices stay.
  void solve(const Points3& right, Points3& values) const {
    if (count_ == 0) return;
    Eigen::MatrixXd b(count_, 3);
    for (Eigen::Index v = 0; v < right.rows(); ++v) {
      if (unknown_[v] >= 0) b.row(unknown_[v]) = right.row(v);
    }
    for (const MeshEdge& edge : topology_.edges) {
      for (int end = 0; end < 2; ++end) {
        const int free = unknown_[edge.v[end]], other = edge.v[1 - end];
        if (free >= 0 && unknown_[other] < 0) b.row(free) += values.row(other);
      }
    }
    const Eigen::MatrixXd x = factor_.solve(b);
    for (Eigen::Index v = 0; v < right.rows(); ++v) {
      if (unknown_[v] >= 0) values.row(v) = x.row(unknown_[v]);
    }
  }

 private:
  const MeshTopology& topology_;
  std::vector<int> unknown_;
  int count_ = 0;
  SparseCholesky factor_;
};

double mean_square_distance(const Points3& V, const ClosestPoints& closest) {
  return distances(V, closest).squaredNorm() / static_cast<double>(V.rows());
}

// Vertices as they are, or by the map of the bounding boxes where that lies nearer.
Points3 first_guess(const TriangleMesh& tiles, const TriangleMesh& surface,
                    const ClosestPoints& closest, double L) {
  const Eigen::RowVector3d low = tiles.V.colwise().minCoeff(), high = tiles.V.colwise().maxCoeff();
  const Eigen::RowVector3d to = surface.V.colwise().minCoeff(),
                           end = surface.V.colwise().maxCoeff();
  Points3 boxed = tiles.V;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = high[axis] - low[axis];
    const double scale = size > L ? (end[axis] - to[axis]) / size : 1.0;
    const double middle = 0.5 * (low[axis] + high[axis]), target = 0.5 * (to[axis] + end[axis]);
    boxed.col(axis) = (boxed.col(axis).array() - middle) * scale + target;
  }
  const auto cost = [&](const Points3& V) {
    return mean_square_distance(V, closest) +
           mean_square_distance(surface.V, ClosestPoints({V, tiles.F}));
  };
  return cost(boxed) < 0.8 * cost(tiles.V) ? boxed : tiles.V;
}

Points3 on_surface(Points3 V, const std::vector<int>& course, const ClosestPoints& closest) {
  parallel_for(static_cast<int>(V.rows()), [&](int v) {
    if (course[v] < 0) V.row(v) = closest(V.row(v)).point;
  });
  return V;
}

// Marks vertices that no edges join to marked ones as well: nothing determines their values.
std::vector<char> with_loose_parts(std::vector<char> fixed, const MeshTopology& topology) {
  DisjointSets parts(fixed.size());
  for (const MeshEdge& edge : topology.edges) parts.unite(edge.v[0], edge.v[1]);
  std::vector<char> held(fixed.size(), 0);
  const int count = static_cast<int>(fixed.size());
  for (int v = 0; v < count; ++v) held[parts.find(v)] |= fixed[v];
  for (int v = 0; v < count; ++v) fixed[v] |= !held[parts.find(v)];
  return fixed;
}

// Places of all vertices on the surface.
Points3 map_vertices(const Points3& guess, const LineMap& lines, const MeshTopology& topology,
                     const ClosestPoints& closest) {
  std::vector<char> fixed;
  for (int course : lines.course) fixed.push_back(course >= 0);
  const Points3 nothing = Points3::Zero(guess.rows(), 3);
  Points3 displacement = lines.place - guess;
  Smoothing(topology, with_loose_parts(fixed, topology), 0).solve(nothing, displacement);
  Points3 V = guess + displacement;
  const double stiffness = 0.3;  // smooths over some two edges
  const Smoothing smoothing(topology, fixed, stiffness);
  for (int round = 0; round < projection_rounds; ++round) {
    checkpoint("following the surface", 0.1 * round);
    const Points3 residual = on_surface(V, lines.course, closest) - V;
    Points3 step = nothing;
    smoothing.solve(stiffness * residual, step);
    V += step;
  }
  return on_surface(V, lines.course, closest);
}

std::string other_topology(const MeshTopology& own, const TriangleMesh& surface) {
  const MeshTopology other = build_topology(surface.F);
  const auto parts = [](const MeshTopology& topology) {
    const std::vector<int> part = face_components(topology, {});
    return part.empty() ? 0 : *std::max_element(part.begin(), part.end()) + 1;
  };
  const auto loops = static_cast<int>(boundary_loops(own).size());
  if (boundary_loops(other).size() != boundary_loops(own).size()) return "borders";
  if (parts(own) != parts(other)) return "parts";
  return handle_count(own, loops) == handle_count(other, loops) ? "" : "parts";
}

double mean_of(const std::vector<double>& lengths) {
  double sum = 0;
  for (double length : lengths) sum += length;
  return sum / static_cast<double>(lengths.size());
}

// Lengths of the old tiling's edges beside the mean, by edge_key.
using OldLengths = std::unordered_map<std::uint64_t, double>;

// Share of the mean edge; change beside the old share, 0 for new edges.
struct EdgeSize {
  double share, change;
  bool off(double above, double below) const {
    return (share > above && (change == 0 || change > 1 + changed)) ||
           (share < below && (change == 0 || change < 1 / (1 + changed)));
  }
};

std::vector<EdgeSize> sizes_of(const LocalEdits& edits, const MeshTopology& topology,
                               const OldLengths& old, double mean) {
  std::vector<EdgeSize> sizes;
  const std::vector<double> lengths = edge_lengths(edits.mesh.mesh, topology);
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    const MeshEdge& edge = topology.edges[e];
    const auto it = old.find(edge_key(edge.v[0], edge.v[1]));  // vertices keep their numbers
    const double share = lengths[e] / mean;
    sizes.push_back({share, it == old.end() ? 0.0 : share / it->second});
  }
  return sizes;
}

// Grows marked vertices by rings of neighbours.
void grow(std::vector<char>& marked, const MeshTopology& topology, int rings) {
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<char> before = marked;
    for (const MeshEdge& edge : topology.edges) {
      if (before[edge.v[0]] || before[edge.v[1]]) marked[edge.v[0]] = marked[edge.v[1]] = 1;
    }
  }
}

// Springs near edges that have become much longer or shorter than others, and unsound faces.
// Returns the faces that are still unsound.
std::vector<int> relax(LocalEdits& edits, const OldLengths& old, double mean,
                       std::vector<char> near, const ClosestPoints& closest) {
  IsotropicMesh& mesh = edits.mesh;
  const MeshTopology topology = build_topology(mesh.mesh.F);
  const std::vector<EdgeSize> sizes = sizes_of(edits, topology, old, mean);
  for (std::size_t e = 0; e < sizes.size(); ++e) {
    const MeshEdge& edge = topology.edges[e];
    if (sizes[e].off(relax_above, relax_below)) near[edge.v[0]] = near[edge.v[1]] = 1;
  }
  mesh.fixed.assign(mesh.mesh.V.rows(), 1);
  for (int f : unsound_faces(even_edges(mesh, mean, 0, closest), mesh.mesh.F)) {
    for (int v : mesh.mesh.F.row(f)) near[v] = 1;
  }
  grow(near, topology, relaxing_rings);
  for (Eigen::Index v = 0; v < mesh.mesh.V.rows(); ++v) {
    mesh.fixed[v] = !near[v] || edits.on_line(static_cast<int>(v));
  }
  return unsound_faces(even_edges(mesh, mean, relaxing_passes, closest, false), mesh.mesh.F);
}

// Splits and collapses edges apart from one another. Returns the vertices around; none: no edits.
std::vector<char> edit(LocalEdits& edits, const OldLengths& old, double mean, double L,
                       const ClosestPoints& closest) {
  const TriangleMesh& mesh = edits.mesh.mesh;
  const MeshTopology topology = build_topology(mesh.F);
  const std::vector<EdgeSize> sizes = sizes_of(edits, topology, old, mean);
  const double above = split_above * std::max(1.0, L / mean),
               below = collapse_below * std::min(1.0, L / mean);
  std::vector<int> order;
  for (std::size_t e = 0; e < sizes.size(); ++e) {
    if (sizes[e].off(above, below)) order.push_back(static_cast<int>(e));
  }
  const auto severity = [&](int e) { return std::abs(std::log(sizes[e].share)); };
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return severity(a) > severity(b); });
  std::vector<char> busy(mesh.V.rows(), 0), near(mesh.V.rows(), 0);
  for (int e : order) {
    const MeshEdge& edge = topology.edges[e];
    std::vector<char> around(busy.size(), 0);
    around[edge.v[0]] = around[edge.v[1]] = 1;
    grow(around, topology, 1);
    bool free = true;
    for (std::size_t v = 0; v < busy.size(); ++v) free = free && !(around[v] && busy[v]);
    if (!free) continue;
    const bool done =
        sizes[e].share > 1 ? edits.split(edge, closest) : edits.collapse(edge, closest);
    if (!done) continue;
    for (std::size_t v = 0; v < busy.size(); ++v) busy[v] |= around[v], near[v] |= around[v];
  }
  edits.drop_collapsed();
  near.resize(edits.mesh.mesh.V.rows(), 1);
  return near;
}

}  // namespace

FollowedMesh follow_mesh(const TriangleMesh& tiles, const TriangleMesh& surface,
                         const FollowOptions& options) {
  if (!(options.L > 0) || !std::isfinite(options.L)) {
    throw InvalidInput("L must be a positive length", "give L in mm");
  }
  const ClosestPoints closest(surface);
  FollowedMesh out;
  const MeshTopology own = build_topology(tiles.F);
  out.obstacle = other_topology(own, surface);
  if (!out.obstacle.empty()) return out;
  checkpoint("following the surface", 0);

  Edges features(0, 2);
  if (options.features) {
    features = *options.features;
  } else if (options.crease_angle < 3.14159) {
    features =
        crease_edges(surface, build_topology(surface.F), options.crease_angle, 2 * options.L);
  }
  const Points3 guess = first_guess(tiles, surface, closest, options.L);
  LineMap lines = map_lines(tiles, guess, surface, features, options.crease_angle, corner_angle);
  if (lines.obstacle != LineObstacle::none) {
    out.obstacle = lines.obstacle == LineObstacle::borders   ? "borders"
                   : lines.obstacle == LineObstacle::corners ? "corners"
                                                             : "creases";
    return out;
  }
  LocalEdits edits({map_vertices(guess, lines, own, closest), tiles.F}, lines);

  const std::vector<double> before = edge_lengths(tiles, own);
  const double mean_before = mean_of(before);
  OldLengths old;
  for (std::size_t e = 0; e < before.size(); ++e) {
    old[edge_key(own.edges[e].v[0], own.edges[e].v[1])] = before[e] / mean_before;
  }
  const double mean = mean_of(edge_lengths(edits.mesh.mesh, own));
  if (std::abs(mean / options.L - 1) > most_off) {
    out.obstacle = "edges";
    return out;
  }
  std::vector<int> unsound = relax(edits, old, mean, std::vector<char>(tiles.V.rows(), 0), closest);
  for (int round = 0; round < edit_rounds; ++round) {
    checkpoint("following the surface", 0.6 + 0.1 * round);
    std::vector<char> near = edit(edits, old, mean, options.L, closest);
    for (int f : unsound) {
      for (int v : edits.mesh.mesh.F.row(f)) near[v] = 1;
    }
    if (std::count(near.begin(), near.end(), 1) == 0) break;
    edits.flip(near);
    unsound = relax(edits, old, mean, near, closest);
  }
  if (!unsound.empty()) {
    out.obstacle = "folded";
    return out;
  }
  edits.finish(tiles.F, out);
  const auto fresh = std::count(out.tile_from.begin(), out.tile_from.end(), -1);
  if (static_cast<double>(fresh) > most_new * static_cast<double>(tiles.F.rows())) {
    out.obstacle = "many";
    return out;
  }
  const std::vector<double> lengths = edge_lengths(out.mesh, build_topology(out.mesh.F));
  out.mean_edge = mean_of(lengths);
  double squares = 0;
  for (double length : lengths) squares += (length - out.mean_edge) * (length - out.mean_edge);
  out.edge_cv = std::sqrt(squares / static_cast<double>(lengths.size())) / out.mean_edge;
  out.chord_error = largest_distance(surface, out.mesh);
  if (out.chord_error > most_distance * options.L) out.obstacle = "far";
  return out;
}

}  // namespace curveups
