// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/line_spacing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

#include "curveups/core/sort_unique.hpp"

namespace curveups {
namespace {

using Neighbours = std::map<int, std::vector<int>>;  // vertices along the lines, ascending

Neighbours neighbours_of(const Edges& edges) {
  Neighbours next;
  for (int e = 0; e < edges.rows(); ++e) {
    next[edges(e, 0)].push_back(edges(e, 1));
    next[edges(e, 1)].push_back(edges(e, 0));
  }
  for (auto& [vertex, list] : next) sort_unique(list);
  return next;
}

// Point to be inserted into the edge after a vertex of a line, or that vertex itself.
struct Mark {
  int at;        // place of the vertex in the line
  double share;  // of the edge, 0 at its start
};

// Share of an edge within which its ends replace a point.
constexpr double snap_share = 1e-6;

// Corners at which the line turns as seen from `reach` away.
std::vector<int> wide_corners(const Course& line, const std::vector<int>& corners,
                              double corner_angle, double reach) {
  reach = std::min(reach, line.length() / 8);
  const auto between = [&](double s, double t) {
    const double d = std::abs(s - t);
    return line.closed ? std::min(d, line.length() - d) : d;
  };
  std::vector<double> turns;
  for (int i : corners) {
    const double s = line.arc[i];
    const Vec3 here = line.at(s);
    turns.push_back(turn(here - line.at(s - reach), line.at(s + reach) - here));
  }
  const int count = static_cast<int>(corners.size());
  std::vector<int> out;
  for (int k = 0; k < count; ++k) {
    bool sharpest = turns[k] > corner_angle;
    for (int step : {1, -1}) {
      for (int away = 1; away < count && sharpest; ++away) {
        const int j = ((k + step * away) % count + count) % count;
        if (between(line.arc[corners[k]], line.arc[corners[j]]) > reach) break;
        sharpest = turns[j] < turns[k] || (turns[j] == turns[k] && k < j);
      }
    }
    if (sharpest) out.push_back(corners[k]);
  }
  return out;
}

// is_corner: vertices that stay whatever the turn.
std::vector<Mark> marks_of_line(const Points3& V, const FeatureLine& whole, double length,
                                double corner_angle, double reach,
                                const std::vector<char>& is_corner) {
  const std::vector<int>& line = whole.vertices;
  const int count = static_cast<int>(line.size());
  const int edges = whole.closed ? count : count - 1;
  std::vector<Vec3> points;
  for (int v : line) points.emplace_back(V.row(v));
  const Course course(std::move(points), whole.closed);
  const std::vector<double>& arc = course.arc;
  std::vector<int> corners, kept;
  for (int i = 0; i < count; ++i) {
    const Vec3 in = V.row(line[i]) - V.row(line[(i + count - 1) % count]);
    const Vec3 out = V.row(line[(i + 1) % count]) - V.row(line[i]);
    if ((!whole.closed && (i == 0 || i == count - 1)) || is_corner[line[i]]) {
      kept.push_back(i);
    } else if (turn(in, out) > corner_angle) {
      corners.push_back(i);
    }
  }
  if (reach > 0) corners = wide_corners(course, corners, corner_angle, reach);
  corners.insert(corners.end(), kept.begin(), kept.end());
  std::sort(corners.begin(), corners.end());
  const bool smooth = corners.empty();
  if (smooth) corners.push_back(0);
  const int stretches = static_cast<int>(corners.size()) - (whole.closed ? 0 : 1);
  const bool loop = whole.closed || line.front() == line.back();
  const int least = !loop || stretches >= 3 ? 1 : stretches == 2 ? 2 : 3;
  std::vector<Mark> marks;
  for (int s = 0; s < stretches; ++s) {
    const bool wraps = s + 1 == static_cast<int>(corners.size());
    const double from = arc[corners[s]];
    const double to = wraps ? arc[corners[0]] + arc.back() : arc[corners[s + 1]];
    const int parts = std::max(least, static_cast<int>(std::lround((to - from) / length)));
    marks.push_back({corners[s], 0});
    for (int k = 1; k < parts; ++k) {
      double at = from + (to - from) * k / parts;
      if (at >= arc.back()) at -= arc.back();
      int i = static_cast<int>(std::upper_bound(arc.begin(), arc.end(), at) - arc.begin()) - 1;
      i = std::clamp(i, 0, edges - 1);
      const double edge = arc[i + 1] - arc[i];
      const double share = edge > 0 ? (at - arc[i]) / edge : 0;
      if (share > 1 - snap_share) {
        marks.push_back({(i + 1) % count, 0});
      } else {
        marks.push_back({i, share < snap_share ? 0 : share});
      }
    }
  }
  if (!whole.closed) marks.push_back({count - 1, 0});
  return marks;
}

}  // namespace

double turn(const Vec3& in, const Vec3& out) {
  return std::atan2(in.cross(out).norm(), in.dot(out));
}

Course::Course(std::vector<Vec3> line, bool is_closed)
    : points(std::move(line)), closed(is_closed), arc(1, 0.0) {
  const std::size_t edges = closed ? points.size() : points.size() - 1;
  for (std::size_t i = 0; i < edges; ++i) {
    arc.push_back(arc.back() + (points[(i + 1) % points.size()] - points[i]).norm());
  }
}

Vec3 Course::at(double s) const {
  s = closed ? s - length() * std::floor(s / length()) : std::clamp(s, 0.0, length());
  const auto last = static_cast<int>(arc.size()) - 2;
  const int i = std::clamp(
      static_cast<int>(std::upper_bound(arc.begin(), arc.end(), s) - arc.begin()) - 1, 0, last);
  const Vec3 &a = points[i], &b = points[(i + 1) % points.size()];
  const double edge = arc[i + 1] - arc[i];
  return a + (edge > 0 ? (s - arc[i]) / edge : 0.0) * (b - a);
}

Vec3 Course::closest(const Vec3& p) const {
  Vec3 best = points[0];
  for (std::size_t i = 0; i + 1 < arc.size(); ++i) {
    const Vec3 &a = points[i], &b = points[(i + 1) % points.size()];
    const Vec3 d = b - a;
    const double size = d.squaredNorm();
    const Vec3 q = a + (size > 0 ? std::clamp((p - a).dot(d) / size, 0.0, 1.0) : 0.0) * d;
    if ((q - p).squaredNorm() < (best - p).squaredNorm()) best = q;
  }
  return best;
}

Edges crease_edges(const TriangleMesh& mesh, const MeshTopology& topology, double angle,
                   double least) {
  std::vector<std::array<int, 2>> sharp;
  for (const MeshEdge& edge : topology.edges) {
    if (edge.boundary()) continue;
    const Vec3 a = face_area_vector(mesh, edge.face[0]), b = face_area_vector(mesh, edge.face[1]);
    if (!(a.norm() > 0) || !(b.norm() > 0)) continue;
    if (std::atan2(a.cross(b).norm(), a.dot(b)) <= angle) continue;
    sharp.push_back({std::min(edge.v[0], edge.v[1]), std::max(edge.v[0], edge.v[1])});
  }
  std::sort(sharp.begin(), sharp.end());
  const Neighbours next = neighbours_of(rows_of(sharp));
  std::set<int> noise, seen;  // vertices of sets that are too short
  for (const auto& entry : next) {
    if (!seen.insert(entry.first).second) continue;
    std::vector<int> part(1, entry.first);
    double length = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      for (int v : next.at(part[i])) {
        length += 0.5 * (mesh.V.row(v) - mesh.V.row(part[i])).norm();
        if (seen.insert(v).second) part.push_back(v);
      }
    }
    if (length < least) noise.insert(part.begin(), part.end());
  }
  sharp.erase(std::remove_if(sharp.begin(), sharp.end(),
                             [&](const auto& pair) { return noise.count(pair[0]) != 0; }),
              sharp.end());
  return rows_of(sharp);
}

std::vector<FeatureLine> feature_lines(const Edges& edges, const std::vector<char>& is_end) {
  const Neighbours next = neighbours_of(edges);
  const auto ends = [&](int v) { return is_end[v] || next.at(v).size() != 2; };
  std::set<std::array<int, 2>> done;
  std::vector<FeatureLine> lines;
  const auto follow = [&](int from, int to) {
    if (done.count({std::min(from, to), std::max(from, to)})) return;
    FeatureLine line{{from}, false};
    const int start = from;
    for (;;) {
      done.insert({std::min(from, to), std::max(from, to)});
      if (to == start && !ends(to)) {
        line.closed = true;
        break;
      }
      line.vertices.push_back(to);
      if (ends(to)) break;
      const std::vector<int>& both = next.at(to);
      const int on = both[0] == from ? both[1] : both[0];
      from = to;
      to = on;
    }
    lines.push_back(std::move(line));
  };
  for (const auto& [v, list] : next) {
    if (!ends(v)) continue;
    for (int to : list) follow(v, to);
  }
  for (const auto& [v, list] : next) follow(v, list.front());  // closed lines
  return lines;
}

IsotropicMesh space_lines(const TriangleMesh& mesh, const Edges& features, double length,
                          double corner_angle, double reach) {
  const MeshTopology topology = build_topology(mesh.F);
  std::vector<Vec3> points(mesh.V.rows());
  for (int v = 0; v < mesh.V.rows(); ++v) points[v] = mesh.V.row(v);
  const std::vector<char> on_boundary = boundary_vertices(topology, mesh.V.rows());
  std::vector<char> fixed(points.size(), 0);
  std::vector<char> is_corner(points.size(), 0);   // boundary loops end features there
  std::map<std::array<int, 2>, int> edge_between;  // on lines
  for (int e = 0; e < features.rows(); ++e) {
    edge_between[{std::min(features(e, 0), features(e, 1)),
                  std::max(features(e, 0), features(e, 1))}] = -1;
    is_corner[features(e, 0)] = is_corner[features(e, 1)] = 1;
  }
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const MeshEdge& edge = topology.edges[e];
    const std::array<int, 2> pair{std::min(edge.v[0], edge.v[1]), std::max(edge.v[0], edge.v[1])};
    if (edge.boundary()) {
      edge_between[pair] = static_cast<int>(e);
    } else if (features.rows() > 0) {
      const auto it = edge_between.find(pair);
      if (it != edge_between.end()) it->second = static_cast<int>(e);
    }
  }
  std::vector<std::array<int, 2>> inner;  // features that are edges, but not of the boundary
  for (const auto& [pair, e] : edge_between) {
    if (e >= 0 && !topology.edges[e].boundary()) inner.push_back(pair);
  }

  std::unordered_map<int, std::vector<std::pair<double, int>>> inserted;  // from an edge's v[0]
  const auto space = [&](const FeatureLine& line, const std::vector<char>& corner) {
    for (const Mark& mark : marks_of_line(mesh.V, line, length, corner_angle, reach, corner)) {
      const int v = line.vertices[mark.at];
      if (mark.share == 0) {
        fixed[v] = 1;
        continue;
      }
      const int w = line.vertices[(mark.at + 1) % line.vertices.size()];
      const int e = edge_between.at({std::min(v, w), std::max(v, w)});
      const Vec3 a = mesh.V.row(v), b = mesh.V.row(w);
      inserted[e].emplace_back(topology.edges[e].v[0] == v ? mark.share : 1 - mark.share,
                               static_cast<int>(points.size()));
      points.push_back((1 - mark.share) * a + mark.share * b);
      fixed.push_back(1);
    }
  };
  for (std::vector<int>& loop : boundary_loops(topology)) space({std::move(loop), true}, is_corner);
  for (const FeatureLine& line : feature_lines(rows_of(inner), on_boundary)) {
    space(line, std::vector<char>(points.size(), 0));
  }
  for (auto& [edge, list] : inserted) std::sort(list.begin(), list.end());

  std::vector<std::array<int, 3>> faces;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    int base_side = -1;  // a side with inserted vertices
    for (int t = 0; t < 3; ++t) {
      if (inserted.count(topology.edge_of(f, t)) != 0) base_side = t;
    }
    if (base_side < 0) {
      faces.push_back({mesh.F(f, 0), mesh.F(f, 1), mesh.F(f, 2)});
      continue;
    }
    // Divide side by side: the fan of that side from the opposite corner, then, in the fan's
    // outer triangles, the fans of the other two sides.
    const auto side = [&](int t) {
      std::vector<int> chain(1, mesh.F(f, t));
      const auto it = inserted.find(topology.edge_of(f, t));
      if (it != inserted.end()) {
        for (const auto& entry : it->second) chain.push_back(entry.second);
        if (topology.edges[it->first].v[0] != chain[0]) {
          std::reverse(chain.begin() + 1, chain.end());
        }
      }
      chain.push_back(mesh.F(f, next3(t)));
      return chain;
    };
    const std::vector<int> base = side(base_side), right = side(next3(base_side)),
                           left = side(prev3(base_side));
    const int top = mesh.F(f, prev3(base_side));
    for (std::size_t k = 1; k + 2 < base.size(); ++k) faces.push_back({base[k], base[k + 1], top});
    for (std::size_t k = 0; k + 1 < right.size(); ++k) {
      faces.push_back({right[k], right[k + 1], base[base.size() - 2]});
    }
    for (std::size_t k = 0; k + 1 < left.size(); ++k) {
      faces.push_back({left[k], left[k + 1], base[1]});
    }
  }
  IsotropicMesh out;
  out.fixed = std::move(fixed);
  for (const std::array<int, 2>& pair : inner) {
    const auto it = inserted.find(edge_between.at(pair));
    std::vector<int> chain(1, topology.edges[edge_between.at(pair)].v[0]);
    if (it != inserted.end()) {
      for (const auto& entry : it->second) chain.push_back(entry.second);
    }
    chain.push_back(topology.edges[edge_between.at(pair)].v[1]);
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
      out.features.push_back({chain[k], chain[k + 1]});
    }
  }
  out.mesh.V.resize(points.size(), 3);
  for (std::size_t v = 0; v < points.size(); ++v) out.mesh.V.row(v) = points[v];
  out.mesh.F.resize(faces.size(), 3);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    out.mesh.F.row(f) << faces[f][0], faces[f][1], faces[f][2];
  }
  return out;
}

}  // namespace curveups
