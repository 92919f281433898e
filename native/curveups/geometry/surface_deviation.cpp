// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/surface_deviation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/geometry/closest_points.hpp"
#include "curveups/geometry/height_bound.hpp"

namespace curveups {
namespace {

// A point with a face of the surface: the nearest one, or one that is near enough.
struct Probe {
  Vec3 at;
  double distance;
  int nearest;
};

Probe probe(const ClosestPoints& surface, const Vec3& at) {
  const ClosestPoint there = surface(at);
  return {at, there.distance, there.face};
}

using Cell = std::vector<Probe>;  // the corners of a convex polygon

// Of all points of the cell, by the face for which it is least. The distance from a convex set, as
// a face is one, is largest at a corner; and from a corner to any other point the distance grows by
// no more than the way there.
struct Bound {
  double value = 1e300;
  int face = -1;   // to which it is the distance
  int corner = 0;  // that is farthest from it
};

Bound upper_bound(const Cell& cell, const ClosestPoints& surface) {
  Bound least;
  const int count = static_cast<int>(cell.size());
  for (int k = 0; k < count; ++k) {
    Bound own{0, cell[k].nearest, k};
    double way = 0;
    for (int l = 0; l < count; ++l) {
      const double there = cell[l].nearest == own.face
                               ? cell[l].distance
                               : surface.distance_to_face(cell[l].at, own.face);
      if (there > own.value) own = {there, own.face, l};
      way = std::max(way, (cell[l].at - cell[k].at).norm());
    }
    own.value = std::min(own.value, cell[k].distance + way);
    if (own.value < least.value) least = own;
  }
  return least;
}

// Divides the cell where it passes from what is nearest to the bound's face to what is nearest to
// its corner's, so that each part has a bound without slack; in the middle where that is at its
// rim.
std::array<Cell, 2> divide(const Cell& cell, const Bound& bound, double enough,
                           const ClosestPoints& surface) {
  const int count = static_cast<int>(cell.size()), other = cell[bound.corner].nearest;
  const auto excess = [&](const Vec3& at) {
    return surface.distance_to_face(at, bound.face) - surface.distance_to_face(at, other);
  };
  const auto after = [&](int k) { return k + 1 == count ? 0 : k + 1; };
  std::vector<double> of(count);
  for (int k = 0; k < count; ++k) of[k] = excess(cell[k].at);
  std::vector<std::pair<int, double>> crossing;  // an edge and a place on it
  bool inside = false;
  for (int k = 0; k < count; ++k) {
    if ((of[k] > 0) == (of[after(k)] > 0)) continue;
    // All but linear along an edge.
    double low = 0, high = 1, at_low = of[k], at_high = of[after(k)], t = 0.5;
    for (int round = 0; round < 3; ++round) {
      t = std::clamp(low + (high - low) * at_low / (at_low - at_high), 0.9 * low + 0.1 * high,
                     0.1 * low + 0.9 * high);
      const double value = excess((1 - t) * cell[k].at + t * cell[after(k)].at);
      const bool first = (value > 0) == (of[k] > 0);
      (first ? low : high) = t;
      (first ? at_low : at_high) = value;
    }
    crossing.push_back({k, t});
    inside = inside || (t > 0.01 && t < 0.99);
  }
  if (crossing.size() != 2 || !inside) {
    int longest = 0;
    for (int k = 1; k < count; ++k) {
      const auto length = [&](int e) { return (cell[after(e)].at - cell[e].at).norm(); };
      if (length(k) > length(longest)) longest = k;
    }
    crossing = {{longest, 0.5}, {(longest + count / 2) % count, count == 3 ? 1.0 : 0.5}};
    if (crossing[0].first > crossing[1].first) std::swap(crossing[0], crossing[1]);
  }
  std::array<Probe, 2> cut;
  for (int c = 0; c < 2; ++c) {
    const auto [k, t] = crossing[c];
    const Vec3 at = (1 - t) * cell[k].at + t * cell[after(k)].at;
    const double here = surface.distance_to_face(at, bound.face),
                 there = surface.distance_to_face(at, other);
    // What is no farther than is known needs no search.
    if (std::min(here, there) > enough) {
      cut[c] = probe(surface, at);
    } else {
      cut[c] = here < there ? Probe{at, here, bound.face} : Probe{at, there, other};
    }
  }
  std::array<Cell, 2> parts = {Cell{cut[0]}, Cell{cut[1]}};
  for (int k = crossing[0].first + 1; k <= crossing[1].first; ++k) parts[0].push_back(cell[k]);
  parts[0].push_back(cut[1]);
  for (int k = crossing[1].first + 1; k <= crossing[0].first + count; ++k) {
    parts[1].push_back(cell[k % count]);
  }
  parts[1].push_back(cut[0]);
  return parts;
}

// Divides the cell until no part can hold a point that is farther than `known.low` by more than the
// tolerance.
void search(Cell whole, const ClosestPoints& surface, LargestDistance& known) {
  std::vector<Cell> open = {std::move(whole)};
  while (!open.empty()) {
    const Cell cell = std::move(open.back());
    open.pop_back();
    for (const Probe& corner : cell) known.low = std::max(known.low, corner.distance);
    const Bound bound = upper_bound(cell, surface);
    if (bound.value <= known.low + distance_tolerance) {
      known.high = std::max(known.high, bound.value);
      continue;
    }
    checkpoint();
    for (Cell& part : divide(cell, bound, known.low, surface)) open.push_back(std::move(part));
  }
}

Vec3 centroid(const TriangleMesh& mesh, int f) {
  return (mesh.V.row(mesh.F(f, 0)) + mesh.V.row(mesh.F(f, 1)) + mesh.V.row(mesh.F(f, 2))) / 3;
}

// A mesh with the probes that everything begins with.
struct Probed {
  const TriangleMesh& mesh;
  const ClosestPoints& surface;
  std::vector<Probe> corners;  // of its vertices; those without a face have none
  std::vector<Probe> middles;  // of its faces
  double largest = 0;
};

constexpr int stretch = 256;  // of faces, whatever the threads

Probed probed(const TriangleMesh& mesh, const ClosestPoints& surface) {
  const int faces = static_cast<int>(mesh.F.rows()), stretches = (faces + stretch - 1) / stretch;
  Probed out{mesh, surface, std::vector<Probe>(mesh.V.rows()), std::vector<Probe>(faces)};
  std::vector<int> first(mesh.V.rows(), -1);  // the first face of a vertex, which asks for it
  for (int f = faces - 1; f >= 0; --f) {
    for (int t = 0; t < 3; ++t) first[mesh.F(f, t)] = f;
  }
  std::vector<double> largest(stretches, 0);
  parallel_ranges(stretches, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      checkpoint();
      const auto ask = [&](const Vec3& at, Probe& answer) {
        answer = probe(surface, at);
        largest[k] = std::max(largest[k], answer.distance);
      };
      for (int f = k * stretch; f < std::min(faces, (k + 1) * stretch); ++f) {
        for (int t = 0; t < 3; ++t) {
          const int v = mesh.F(f, t);
          if (first[v] == f) ask(mesh.V.row(v), out.corners[v]);
        }
        ask(centroid(mesh, f), out.middles[f]);
      }
    }
  });
  for (double one : largest) out.largest = std::max(out.largest, one);
  return out;
}

// By the rule of corners, edges' middles and centroid that is exact up to cubic polynomials.
void integrate(const Probed& of, Deviation& out) {
  const TriangleMesh& mesh = of.mesh;
  const int faces = static_cast<int>(mesh.F.rows());
  Eigen::ArrayX3d sums(faces, 3);  // area, distance, distance squared
  parallel_ranges(faces, [&](int begin, int end) {
    for (int f = begin; f < end; ++f) {
      double first = 0, second = 0;
      const auto add = [&](double weight, double d) {
        first += weight * d;
        second += weight * d * d;
      };
      for (int t = 0; t < 3; ++t) {
        const Probe &here = of.corners[mesh.F(f, t)], &next = of.corners[mesh.F(f, next3(t))];
        add(1.0 / 20, here.distance);
        add(2.0 / 15, of.surface(0.5 * (here.at + next.at)).distance);
      }
      add(9.0 / 20, of.middles[f].distance);
      const double area = face_area_vector(mesh, f).norm();
      sums.row(f) << area, area * first, area * second;
    }
  });
  const Eigen::Array3d total = sums.colwise().sum();
  if (!(total(0) > 0)) return;
  out.mean = total(1) / total(0);
  out.rms = std::sqrt(total(2) / total(0));
}

LargestDistance largest_distance(const Probed& of, const TriangleMesh& surface) {
  const int faces = static_cast<int>(of.mesh.F.rows()), stretches = (faces + stretch - 1) / stretch;
  const HeightBound height_bound(surface);
  LargestDistance out{of.largest, of.largest};
  // Every stretch is searched above what all samples reach, and so in any order.
  std::vector<LargestDistance> found(stretches, out);
  parallel_ranges(stretches, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      checkpoint();
      for (int f = k * stretch; f < std::min(faces, (k + 1) * stretch); ++f) {
        Cell cell;
        for (int t = 0; t < 3; ++t) cell.push_back(of.corners[of.mesh.F(f, t)]);
        const double enough = found[k].low + distance_tolerance;
        double bound = upper_bound(cell, of.surface).value;
        if (bound > enough) {
          bound = height_bound({cell[0].at, cell[1].at, cell[2].at}, of.middles[f].nearest, enough);
        }
        if (bound > enough) {
          search(std::move(cell), of.surface, found[k]);
        } else {
          found[k].high = std::max(found[k].high, bound);
        }
      }
    }
  });
  for (const LargestDistance& one : found) {
    out.low = std::max(out.low, one.low);
    out.high = std::max(out.high, one.high);
  }
  return out;
}

}  // namespace

LargestDistance largest_distance(const TriangleMesh& mesh, const TriangleMesh& surface) {
  const ClosestPoints closest(surface);
  return largest_distance(probed(mesh, closest), surface);
}

Deviation surface_deviation(const TriangleMesh& mesh, const TriangleMesh& target) {
  const ClosestPoints to(target), from(mesh);
  const Probed there = probed(mesh, to), back = probed(target, from);
  Deviation out;
  integrate(there, out);
  out.max = largest_distance(there, target).low;
  out.hausdorff = std::max(out.max, largest_distance(back, mesh).low);
  return out;
}

}  // namespace curveups
