// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/follow_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace curveups {
namespace {

// A tile's edge on a crease bends by at least this part of the crease's angle: tiles flatten it.
constexpr double crease_share = 0.75;
constexpr int trial_shifts = 96;  // shifts of a closed line without corners

// A line of the tiling or of the surface: its vertices and their points.
struct Line {
  std::vector<int> vertices;
  Course course;
};

Line line_of(const FeatureLine& line, const Points3& V) {
  std::vector<int> vertices = line.vertices;
  const bool closed = line.closed || (vertices.size() > 2 && vertices.front() == vertices.back());
  if (closed && vertices.front() == vertices.back()) vertices.pop_back();
  std::vector<Vec3> points;
  for (int v : vertices) points.emplace_back(V.row(v));
  return {std::move(vertices), Course(std::move(points), closed)};
}

double mean_distance(const Course& from, const Course& to) {
  double sum = 0;
  for (const Vec3& p : from.points) sum += (to.closest(p) - p).norm();
  return sum / static_cast<double>(from.points.size());
}

// Line of `to` for each of `from`, the nearest pairs first; empty where they do not correspond.
std::vector<int> nearest_lines(const std::vector<Line>& from, const std::vector<Line>& to) {
  if (from.size() != to.size()) return {};
  struct Pair {
    double distance;
    int from, to;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (std::size_t j = 0; j < to.size(); ++j) {
      if (from[i].course.closed != to[j].course.closed) continue;
      const double distance =
          mean_distance(from[i].course, to[j].course) + mean_distance(to[j].course, from[i].course);
      pairs.push_back({distance, static_cast<int>(i), static_cast<int>(j)});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  std::vector<int> match(from.size(), -1);
  std::vector<char> taken(to.size(), 0);
  std::size_t count = 0;
  for (const Pair& pair : pairs) {
    if (match[pair.from] >= 0 || taken[pair.to]) continue;
    match[pair.from] = pair.to;
    taken[pair.to] = 1;
    ++count;
  }
  return count == from.size() ? match : std::vector<int>();
}

// Indices of points of a closed line that are corners.
std::vector<int> corners_of(const Line& line, double angle, const std::vector<char>& is_corner) {
  const std::vector<Vec3>& p = line.course.points;
  const std::size_t count = p.size();
  std::vector<int> corners;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 in = p[i] - p[(i + count - 1) % count], out = p[(i + 1) % count] - p[i];
    if (is_corner[line.vertices[i]] || turn(in, out) > angle) {
      corners.push_back(static_cast<int>(i));
    }
  }
  return corners;
}

// Arc of `to` for each point of a closed line without corners: by the shift and, where they may
// differ, the direction with the least squared distances.
std::vector<double> by_best_shift(const Course& from, const Course& to, bool may_turn) {
  const std::size_t count = from.points.size();
  const double scale = to.length() / from.length();
  double best = std::numeric_limits<double>::infinity(), shift = 0, direction = 1;
  const auto attempt = [&](double offset, double sign) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      sum += (to.at(offset + sign * scale * from.arc[i]) - from.points[i]).squaredNorm();
    }
    if (sum < best) {
      best = sum;
      shift = offset;
      direction = sign;
    }
  };
  for (int k = 0; k < trial_shifts; ++k) {
    attempt(k * to.length() / trial_shifts, 1);
    if (may_turn) attempt(k * to.length() / trial_shifts, -1);
  }
  for (double step = to.length() / trial_shifts / 2; step > 1e-9 * to.length(); step /= 2) {
    const double middle = shift;
    attempt(middle - step, direction);
    attempt(middle + step, direction);
  }
  std::vector<double> out;
  for (double arc : from.arc) out.push_back(shift + direction * scale * arc);
  out.resize(count);
  return out;
}

// Point of `from` for each corner of `to`, both in order around a closed line: its own corners
// where there are as many, else the nearest points. Empty where these are out of order.
std::vector<int> points_at_corners(const Course& from, const std::vector<int>& own,
                                   const Course& to, const std::vector<int>& corners) {
  const int count = static_cast<int>(corners.size());
  std::vector<int> match(count);
  if (own.size() == corners.size()) {
    double best = std::numeric_limits<double>::infinity();
    int shift = 0;
    for (int k = 0; k < count; ++k) {
      double sum = 0;
      for (int j = 0; j < count; ++j) {
        sum += (from.points[own[(j + k) % count]] - to.points[corners[j]]).squaredNorm();
      }
      if (sum < best) {
        best = sum;
        shift = k;
      }
    }
    for (int j = 0; j < count; ++j) match[j] = own[(j + shift) % count];
    return match;
  }
  for (int j = 0; j < count; ++j) {
    const Vec3& corner = to.points[corners[j]];
    match[j] = static_cast<int>(std::min_element(from.points.begin(), from.points.end(),
                                                 [&](const Vec3& a, const Vec3& b) {
                                                   return (a - corner).squaredNorm() <
                                                          (b - corner).squaredNorm();
                                                 }) -
                                from.points.begin());
  }
  int falls = 0;  // once around, the numbers fall once
  for (int j = 0; j < count; ++j) {
    if (count > 1 && match[j] == match[(j + 1) % count]) return {};
    falls += match[(j + 1) % count] <= match[j];
  }
  return falls == 1 ? match : std::vector<int>();
}

// Arc of `to` for each point of a closed line, by shares between the corners.
std::vector<double> between_corners(const Course& from, const std::vector<int>& at,
                                    const Course& to, const std::vector<int>& corners) {
  const int points = static_cast<int>(from.points.size()), count = static_cast<int>(at.size());
  std::vector<double> out(points);
  for (int j = 0; j < count; ++j) {
    const int next = (j + 1) % count;
    const double start = from.arc[at[j]], begin = to.arc[corners[j]];
    double end = from.arc[at[next]], stop = to.arc[corners[next]];
    if (at[next] <= at[j]) end += from.length();
    if (corners[next] <= corners[j]) stop += to.length();
    const int steps = at[next] > at[j] ? at[next] - at[j] : at[next] - at[j] + points;
    for (int k = 0; k < steps; ++k) {
      const int i = (at[j] + k) % points;
      const double arc = from.arc[i] + (i < at[j] ? from.length() : 0.0);
      out[i] = begin + (arc - start) / (end - start) * (stop - begin);
    }
  }
  return out;
}

void lay(LineMap& map, const Line& from, const std::vector<double>& arcs, int course) {
  for (std::size_t i = 0; i < from.vertices.size(); ++i) {
    const int v = from.vertices[i];
    if (map.course[v] >= 0) continue;  // ends of creases lie on a border, or on an earlier crease
    map.course[v] = course;
    map.place.row(v) = map.courses[course].at(arcs[i]);
  }
}

std::vector<Line> borders_of(const MeshTopology& topology, const Points3& V) {
  std::vector<Line> lines;
  for (std::vector<int>& loop : boundary_loops(topology)) {
    lines.push_back(line_of({std::move(loop), true}, V));
  }
  return lines;
}

std::vector<Line> creases_of(const Edges& edges, const std::vector<char>& on_boundary,
                             const Points3& V) {
  std::vector<Line> lines;
  for (const FeatureLine& line : feature_lines(edges, on_boundary))
    lines.push_back(line_of(line, V));
  return lines;
}

std::vector<char> ends_of(const std::vector<Line>& creases, Eigen::Index count) {
  std::vector<char> is_end(count, 0);
  for (const Line& line : creases) {
    if (line.course.closed) continue;
    is_end[line.vertices.front()] = is_end[line.vertices.back()] = 1;
  }
  return is_end;
}

}  // namespace

LineMap map_lines(const TriangleMesh& tiles, const Points3& guess, const TriangleMesh& surface,
                  const Edges& features, double crease_angle, double corner_angle) {
  const MeshTopology own = build_topology(tiles.F);
  const MeshTopology other = build_topology(surface.F);
  LineMap map;
  map.course.assign(tiles.V.rows(), -1);
  map.knot.assign(tiles.V.rows(), 0);
  map.place = guess;
  std::vector<Line> old_creases, creases;
  if (features.rows() > 0) {
    const Edges sharp = crease_edges(tiles, own, crease_share * crease_angle, 0);
    old_creases = creases_of(sharp, boundary_vertices(own, tiles.V.rows()), guess);
    creases = creases_of(features, boundary_vertices(other, surface.V.rows()), surface.V);
    for (int e = 0; e < sharp.rows(); ++e) map.features.push_back({sharp(e, 0), sharp(e, 1)});
  }
  const std::vector<char> old_ends = ends_of(old_creases, tiles.V.rows());
  const std::vector<char> ends = ends_of(creases, surface.V.rows());

  const std::vector<Line> old_borders = borders_of(own, guess);
  std::vector<Line> borders = borders_of(other, surface.V);
  const std::vector<int> border = nearest_lines(old_borders, borders);
  if (border.size() != borders.size()) {
    map.obstacle = LineObstacle::borders;
    return map;
  }
  for (const Line& line : borders) map.courses.push_back(line.course);
  for (std::size_t i = 0; i < old_borders.size(); ++i) {
    const Line &from = old_borders[i], &to = borders[border[i]];
    const std::vector<int> corners = corners_of(to, corner_angle, ends);
    if (corners.empty()) {
      lay(map, from, by_best_shift(from.course, to.course, false), border[i]);
      continue;
    }
    const std::vector<int> at = points_at_corners(
        from.course, corners_of(from, corner_angle, old_ends), to.course, corners);
    if (at.empty()) {
      map.obstacle = LineObstacle::corners;
      return map;
    }
    lay(map, from, between_corners(from.course, at, to.course, corners), border[i]);
    for (int k : at) map.knot[from.vertices[k]] = 1;
  }

  const std::vector<int> crease = nearest_lines(old_creases, creases);
  if (crease.size() != creases.size()) {
    map.obstacle = LineObstacle::creases;
    return map;
  }
  const int first = map.borders = static_cast<int>(map.courses.size());
  for (const Line& line : creases) map.courses.push_back(line.course);
  for (std::size_t i = 0; i < old_creases.size(); ++i) {
    const Line& from = old_creases[i];
    const Course& to = creases[crease[i]].course;
    if (to.closed) {
      lay(map, from, by_best_shift(from.course, to, true), first + crease[i]);
      continue;
    }
    const Vec3 &a = from.course.points.front(), &b = from.course.points.back();
    const Vec3 &c = to.points.front(), &d = to.points.back();
    const bool turned = (a - d).norm() + (b - c).norm() < (a - c).norm() + (b - d).norm();
    std::vector<double> arcs;
    for (double arc : from.course.arc) {
      const double share = arc / from.course.length();
      arcs.push_back((turned ? 1 - share : share) * to.length());
    }
    lay(map, from, arcs, first + crease[i]);
    map.knot[from.vertices.front()] = map.knot[from.vertices.back()] = 1;
  }
  return map;
}

}  // namespace curveups
