// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/divide_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <string>
#include <tuple>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/sort_unique.hpp"
#include "curveups/geometry/cut_graph.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/geometry/edge_paths.hpp"

namespace curveups {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int rounds = 16;         // moves of the middles, which converge within ten
constexpr double hold_back = 0.5;  // weight of the difference of radii, a round

struct Step {
  int face;
  double length;  // mm, between the faces' centroids
};

// Nearest source of each face.
struct Nearest {
  std::vector<int> source;  // place of each among the sources
  std::vector<double> distance;
};

// Regions of about the same area with short borders, each connected by edges. Faces belong to the
// nearest middle: distances along the surface from middles that start as far from one another as
// can be and move to the face deepest inside of their region (S. P. Lloyd, "Least squares
// quantization in PCM", 1982). An additive weight holds larger regions back. Then teeth are taken
// off: a face goes to the region that it shares two sides with. Of all rounds the one with the
// shortest border counts, weighed with the largest area over the mean. Regions do not reach across
// cuts.
class Regions {
 public:
  Regions(const TriangleMesh& mesh, const MeshTopology& topology, const std::vector<char>& cut)
      : topology_(topology),
        cut_(cut),
        steps_(mesh.F.rows()),
        length_(edge_lengths(mesh, topology)) {
    const int count = static_cast<int>(mesh.F.rows());
    std::vector<Vec3> middle;
    for (int f = 0; f < count; ++f) {
      area_.push_back(face_area_vector(mesh, f).norm());
      middle.push_back(
          (mesh.V.row(mesh.F(f, 0)) + mesh.V.row(mesh.F(f, 1)) + mesh.V.row(mesh.F(f, 2))) / 3);
    }
    // Steps to all faces that share a vertex of the mesh that is open along the cuts: paths across
    // edges alone would zigzag.
    const TriangleMesh open = cut_open(mesh, topology, cut).mesh;
    std::vector<std::vector<int>> around(open.V.rows());
    for (int f = 0; f < count; ++f) {
      for (int t = 0; t < 3; ++t) around[open.F(f, t)].push_back(f);
    }
    for (int f = 0; f < count; ++f) {
      std::vector<int> near;
      for (int t = 0; t < 3; ++t) {
        const std::vector<int>& more = around[open.F(f, t)];
        near.insert(near.end(), more.begin(), more.end());
      }
      sort_unique(near);
      for (int g : near) {
        if (g != f) steps_[f].push_back({g, (middle[g] - middle[f]).norm()});
      }
    }
    component_ = parts_of(std::vector<int>(count, 0));
  }

  // Region of each face, from 0. count: at least that of the mesh's components under the cuts.
  std::vector<int> divide(int count) const {
    std::vector<int> seeds(1, farthest({0}));
    while (static_cast<int>(seeds.size()) < count) seeds.push_back(farthest(seeds));
    std::vector<double> behind(count, 0);
    std::vector<int> best;
    double least = infinite;
    for (int round = 0; round < rounds; ++round) {
      checkpoint();
      const std::vector<int> region = grow(seeds, behind);
      const std::vector<double> radius = radii(region, count), mean = means(radius, seeds);
      double largest = 1;
      for (int k = 0; k < count; ++k) largest = std::max(largest, radius[k] / mean[k]);
      const double cost = border(region) * largest * largest;
      if (cost < least) {
        least = cost;
        best = region;
      }
      deepest(region, seeds);
      for (int k = 0; k < count; ++k) behind[k] += hold_back * (radius[k] - mean[k]);
      const double first = *std::min_element(behind.begin(), behind.end());
      for (double& start : behind) start -= first;
    }
    return best;
  }

 private:
  bool joined(const MeshEdge& edge, std::size_t e) const {
    return !edge.boundary() && (cut_.empty() || !cut_[e]);
  }

  // Connected parts of regions.
  std::vector<int> parts_of(const std::vector<int>& region) const {
    std::vector<char> same(topology_.edges.size());
    for (std::size_t e = 0; e < same.size(); ++e) {
      const MeshEdge& edge = topology_.edges[e];
      same[e] = joined(edge, e) && region[edge.face[0]] == region[edge.face[1]];
    }
    return face_components(topology_, same);
  }

  // behind: head start of other sources over each source, mm. A source keeps its own face.
  Nearest nearest(const std::vector<int>& sources, const std::vector<double>& behind) const {
    using Entry = std::tuple<double, int, int>;  // distance, source, face
    Nearest out{std::vector<int>(steps_.size(), -1), std::vector<double>(steps_.size(), infinite)};
    std::vector<char> fixed(steps_.size(), 0);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (std::size_t k = 0; k < sources.size(); ++k) {
      if (fixed[sources[k]]) continue;
      fixed[sources[k]] = 1;
      out.source[sources[k]] = static_cast<int>(k);
      out.distance[sources[k]] = behind.empty() ? 0 : behind[k];
      queue.emplace(out.distance[sources[k]], static_cast<int>(k), sources[k]);
    }
    while (!queue.empty()) {
      const auto [distance, source, face] = queue.top();
      queue.pop();
      if (distance > out.distance[face] || source != out.source[face]) continue;
      for (const Step& step : steps_[face]) {
        const double reached = distance + step.length;
        if (fixed[step.face] || reached >= out.distance[step.face]) continue;
        out.distance[step.face] = reached;
        out.source[step.face] = source;
        queue.emplace(reached, source, step.face);
      }
    }
    return out;
  }

  // A face of a component without a source is infinitely far, so each gets one before any has two.
  int farthest(const std::vector<int>& from) const {
    const std::vector<double> distance = nearest(from, {}).distance;
    return static_cast<int>(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }

  std::vector<int> grow(const std::vector<int>& seeds, const std::vector<double>& behind) const {
    std::vector<int> region = nearest(seeds, behind).source;
    take_off_teeth(region);
    join_fragments(region);
    return region;
  }

  void take_off_teeth(std::vector<int>& region) const {
    for (bool changed = true; changed;) {  // every change makes the borders an edge shorter
      changed = false;
      for (std::size_t f = 0; f < region.size(); ++f) {
        std::array<int, 3> beside{};
        for (int t = 0; t < 3; ++t) {
          const int e = topology_.edge_of(static_cast<Eigen::Index>(f), t);
          const int g = topology_.neighbour(static_cast<Eigen::Index>(f), t);
          beside[t] = joined(topology_.edges[e], e) ? region[g] : -1;
        }
        for (int t = 0; t < 3; ++t) {
          if (beside[t] < 0 || beside[t] == region[f] || beside[t] != beside[next3(t)]) continue;
          region[f] = beside[t];
          changed = true;
          break;
        }
      }
    }
  }

  // Joins parts of a region but for its largest to the region with which they share most border.
  void join_fragments(std::vector<int>& region) const {
    for (;;) {
      const std::vector<int> part = parts_of(region);
      const int count = 1 + *std::max_element(part.begin(), part.end());
      std::vector<double> area(count, 0);
      std::vector<int> of(count), largest(region.size(), -1);
      for (std::size_t f = 0; f < region.size(); ++f) {
        area[part[f]] += area_[f];
        of[part[f]] = region[f];
      }
      for (int p = 0; p < count; ++p) {
        int& known = largest[of[p]];
        if (known < 0 || area[p] > area[known]) known = p;
      }
      std::map<int, std::map<int, double>> beside;  // mm of border by fragment and region
      for (std::size_t e = 0; e < topology_.edges.size(); ++e) {
        const MeshEdge& edge = topology_.edges[e];
        if (!joined(edge, e)) continue;
        for (int side = 0; side < 2; ++side) {
          const int own = part[edge.face[side]], other = region[edge.face[1 - side]];
          if (largest[of[own]] != own && other != of[own]) beside[own][other] += length_[e];
        }
      }
      if (beside.empty()) return;
      const auto& [fragment, regions] = *beside.begin();
      const int to = std::max_element(regions.begin(), regions.end(), [](auto& a, auto& b) {
                       return a.second < b.second;
                     })->first;
      for (std::size_t f = 0; f < region.size(); ++f) {
        if (part[f] == fragment) region[f] = to;
      }
    }
  }

  // Radii of discs with the regions' areas.
  std::vector<double> radii(const std::vector<int>& region, int count) const {
    std::vector<double> out(count, 0);
    for (std::size_t f = 0; f < region.size(); ++f) out[region[f]] += area_[f];
    for (double& radius : out) radius = std::sqrt(radius / M_PI);
    return out;
  }

  // Mean radius in the component of each region.
  std::vector<double> means(const std::vector<double>& radius,
                            const std::vector<int>& seeds) const {
    std::map<int, std::pair<double, int>> sums;
    for (std::size_t k = 0; k < seeds.size(); ++k) {
      auto& [sum, count] = sums[component_[seeds[k]]];
      sum += radius[k];
      ++count;
    }
    std::vector<double> out;
    for (int seed : seeds) {
      const auto& [sum, count] = sums[component_[seed]];
      out.push_back(sum / count);
    }
    return out;
  }

  double border(const std::vector<int>& region) const {
    double sum = 0;
    for (std::size_t e = 0; e < topology_.edges.size(); ++e) {
      const MeshEdge& edge = topology_.edges[e];
      if (joined(edge, e) && region[edge.face[0]] != region[edge.face[1]]) sum += length_[e];
    }
    return sum;
  }

  // Moves the seed of each region to the face farthest from its border; of equals the lowest.
  void deepest(const std::vector<int>& region, std::vector<int>& seeds) const {
    std::vector<int> rim;
    for (std::size_t f = 0; f < region.size(); ++f) {
      for (int t = 0; t < 3; ++t) {
        const int e = topology_.edge_of(static_cast<Eigen::Index>(f), t);
        const int g = topology_.neighbour(static_cast<Eigen::Index>(f), t);
        if (joined(topology_.edges[e], e) && region[g] == region[f]) continue;
        rim.push_back(static_cast<int>(f));
        break;
      }
    }
    if (rim.empty()) return;  // a closed surface in one piece
    const std::vector<double> depth = nearest(rim, {}).distance;
    std::vector<int> middle(seeds.size(), -1);
    for (std::size_t f = 0; f < region.size(); ++f) {
      int& best = middle[region[f]];
      if (best < 0 || (depth[f] < infinite && depth[f] > depth[best])) best = static_cast<int>(f);
    }
    for (std::size_t k = 0; k < seeds.size(); ++k) {
      if (middle[k] >= 0) seeds[k] = middle[k];
    }
  }

  const MeshTopology& topology_;
  const std::vector<char>& cut_;
  std::vector<std::vector<Step>> steps_;
  std::vector<double> area_;
  std::vector<double> length_;  // lengths of edges
  std::vector<int> component_;
};

using Pair = std::array<int, 2>;
using Pairs = std::set<Pair>;  // vertices of edges, the lower first

Pair pair_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

std::vector<char> either(const std::vector<char>& a, const std::vector<char>& b) {
  std::vector<char> out = a;
  for (std::size_t e = 0; e < b.size(); ++e) out[e] = out[e] || b[e];
  return out;
}

// Adds shortest paths inside of a piece that join its loops along borders to one.
void join_loops(const MeshPiece& piece, const Pairs& borders, Pairs& slits) {
  const int count = static_cast<int>(piece.mesh.V.rows());
  const MeshTopology topology = build_topology(piece.mesh.F);
  std::vector<std::vector<int>> loops;
  for (std::vector<int>& loop : boundary_loops(topology)) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int a = loop[k], b = loop[(k + 1) % loop.size()];
      if (!borders.count(pair_of(piece.original[a], piece.original[b]))) continue;
      loops.push_back(std::move(loop));
      break;
    }
  }
  if (loops.size() < 2) return;
  std::vector<double> length = edge_lengths(piece.mesh, topology);
  for (std::size_t e = 0; e < length.size(); ++e) {
    if (topology.edges[e].boundary()) length[e] = infinite;
  }
  std::vector<int> joined = loops.front();
  loops.erase(loops.begin());
  while (!loops.empty()) {
    const PathTree tree = shortest_paths(topology, length, count, joined);
    std::size_t nearest = 0;
    int end = loops.front().front();
    for (std::size_t l = 0; l < loops.size(); ++l) {
      for (int v : loops[l]) {
        if (!(tree.distance[v] < tree.distance[end])) continue;
        nearest = l;
        end = v;
      }
    }
    const std::vector<int> path = tree.path_to(end);
    for (std::size_t k = 1; k < path.size(); ++k) {
      slits.insert(pair_of(piece.original[path[k - 1]], piece.original[path[k]]));
    }
    joined.insert(joined.end(), path.begin(), path.end());
    joined.insert(joined.end(), loops[nearest].begin(), loops[nearest].end());
    loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(nearest));
  }
}

}  // namespace

SurfaceDivision divide_surface(const TriangleMesh& mesh, const MeshTopology& topology,
                               const std::vector<char>& cut, int count) {
  const int faces = static_cast<int>(mesh.F.rows());
  if (count < 1 || (count > 1 && count > faces / least_faces_of_piece)) {
    throw InvalidInput(
        std::to_string(faces) + " tiles are too few for " + std::to_string(count) + " pieces",
        "ask for fewer pieces, or lower L");
  }
  SurfaceDivision out;
  out.piece = pieces_of_faces(topology, cut);
  Pairs borders, slits;
  if (1 + *std::max_element(out.piece.begin(), out.piece.end()) < count) {
    const std::vector<int> region = Regions(mesh, topology, cut).divide(count);
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
      const MeshEdge& edge = topology.edges[e];
      if (edge.boundary() || (!cut.empty() && cut[e])) continue;
      if (region[edge.face[0]] != region[edge.face[1]]) {
        borders.insert(pair_of(edge.v[0], edge.v[1]));
      }
    }
  }
  out.borders = rows_of(borders);
  std::vector<char> all = either(mark_cuts(topology, out.borders), cut);
  out.piece = pieces_of_faces(topology, all);
  for (const MeshPiece& piece : cut_into_pieces(mesh, topology, all)) {
    join_loops(piece, borders, slits);
  }
  all = either(all, mark_cuts(topology, rows_of(slits)));
  const Edges opening = opening_cuts(mesh, topology, all);
  for (Eigen::Index e = 0; e < opening.rows(); ++e) {
    slits.insert(pair_of(opening(e, 0), opening(e, 1)));
  }
  out.slits = rows_of(slits);
  return out;
}

}  // namespace curveups
