// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/outline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <polyclipping/clipper.hpp>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/tolerances.hpp"

namespace curveups {
namespace {

using ClipperLib::Paths;

constexpr double unit = tolerance::snap;  // mm, of Clipper's whole numbers
constexpr double first_step = 0.1;        // mm, of two in which shapes grow
constexpr double least_corner = 1e-4;     // mm: finer ones get lost where files round
constexpr std::size_t most_swept = 2000;  // shapes that are united at once

Paths united(const Paths& paths) {
  checkpoint();
  ClipperLib::Clipper clipper;
  clipper.StrictlySimple(true);
  clipper.AddPaths(paths, ClipperLib::ptSubject, true);
  Paths out;
  clipper.Execute(ClipperLib::ctUnion, out, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return out;
}

std::pair<Vec2, Vec2> box_of(const ClipperLib::Path& path) {
  Vec2 low(1e300, 1e300), high = -low;
  for (const ClipperLib::IntPoint& p : path) {
    low = low.cwiseMin(unit * Vec2(p.X, p.Y));
    high = high.cwiseMax(unit * Vec2(p.X, p.Y));
  }
  return {low, high};
}

// True if a path is a hole no wider than twice the offset. Such holes grow inside out, which takes
// Clipper seconds for a thousand.
bool closes(const ClipperLib::Path& path, double offset) {
  if (ClipperLib::Orientation(path)) return false;
  const auto [low, high] = box_of(path);
  return (high - low).minCoeff() <= 2 * offset;
}

Paths grown(const Paths& paths, ClipperLib::EndType ends, double offset, double deviation) {
  checkpoint();
  // Clipper's last chord of an arc may be twice as long, and lie four times as far inside.
  ClipperLib::ClipperOffset offsetter(2, 0.25 * deviation / unit);
  offsetter.AddPaths(paths, ClipperLib::jtRound, ends);
  Paths out;
  offsetter.Execute(out, offset / unit);
  return out;
}

// The middle of a path's bounding box.
Vec2 middle_of(const ClipperLib::Path& path) {
  const auto [low, high] = box_of(path);
  return 0.5 * (low + high);
}

// Union of paths, each grown by `first`, without the holes that close when it grows by `rest` too.
// Thousands of paths are united in halves first: the time of one sweep grows with the square.
Paths joined(Paths paths, double first, double rest, double deviation) {
  Paths all;
  if (paths.size() <= most_swept) {
    all = grown(paths, ClipperLib::etClosedPolygon, first, deviation);
  } else {
    Vec2 low = middle_of(paths[0]), high = low;
    for (const ClipperLib::Path& path : paths) {
      low = low.cwiseMin(middle_of(path));
      high = high.cwiseMax(middle_of(path));
    }
    const int axis = high.x() - low.x() > high.y() - low.y() ? 0 : 1;
    std::stable_sort(paths.begin(), paths.end(),
                     [&](const ClipperLib::Path& a, const ClipperLib::Path& b) {
                       return middle_of(a)[axis] < middle_of(b)[axis];
                     });
    const auto half = paths.begin() + static_cast<std::ptrdiff_t>(paths.size() / 2);
    all = joined(Paths(paths.begin(), half), first, rest, deviation);
    const Paths other = joined(Paths(half, paths.end()), first, rest, deviation);
    all.insert(all.end(), other.begin(), other.end());
    all = united(all);
  }
  Paths out;
  for (ClipperLib::Path& path : all) {
    if (!closes(path, rest)) out.push_back(std::move(path));
  }
  return out;
}

ClipperLib::Path to_path(const Polygon& polygon) {
  ClipperLib::Path path;
  for (const Vec2& p : polygon) {
    path.emplace_back(std::llround(p.x() / unit), std::llround(p.y() / unit));
  }
  return path;
}

// Loops without corners that single precision loses, the largest first.
std::vector<Polygon> to_loops(Paths paths, double deviation) {
  ClipperLib::CleanPolygons(paths, least_corner / unit);
  std::vector<Polygon> loops;
  for (const ClipperLib::Path& path : united(paths)) {
    Polygon loop;
    for (const ClipperLib::IntPoint& p : path) loop.push_back(unit * Vec2(p.X, p.Y));
    if (area(loop) > -deviation * deviation && area(loop) <= 0) continue;
    loops.push_back(std::move(loop));
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [](const Polygon& a, const Polygon& b) { return area(a) > area(b); });
  return loops;
}

Paths combined(ClipperLib::ClipType how, const Paths& subject, const Paths& other) {
  ClipperLib::Clipper clipper;
  clipper.StrictlySimple(true);
  clipper.AddPaths(subject, ClipperLib::ptSubject, true);
  clipper.AddPaths(other, ClipperLib::ptClip, true);
  Paths out;
  clipper.Execute(how, out, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return out;
}

}  // namespace

std::vector<Polygon> outline_of(const std::vector<OutlineShape>& shapes, double deviation) {
  if (shapes.empty()) throw InvalidInput("an outline of no shapes", "pass a layout with tiles");
  // Shapes with the same offset grow together, first by a little that joins neighbours: thousands
  // of large overlapping arcs take Clipper seconds.
  std::map<double, Paths> polygons, points;
  for (const OutlineShape& shape : shapes) {
    auto& alike = shape.polygon.size() == 1 ? points : polygons;
    alike[shape.offset].push_back(to_path(shape.polygon));
  }
  Paths all;
  const auto add = [&](const Paths& paths, ClipperLib::EndType ends, double offset) {
    const Paths out = grown(paths, ends, offset, deviation);
    all.insert(all.end(), out.begin(), out.end());
  };
  for (const auto& [offset, paths] : polygons) {
    const double first = std::min(first_step, 0.5 * offset);
    add(joined(paths, first, offset - first, deviation), ClipperLib::etClosedPolygon,
        offset - first);
  }
  for (const auto& [offset, paths] : points) add(paths, ClipperLib::etOpenRound, offset);
  return to_loops(united(all), deviation);
}

std::vector<Polygon> outline_without(const std::vector<Polygon>& outline, const Polygon& region,
                                     const std::vector<Polygon>& taken, double apart,
                                     double deviation) {
  Paths left, others;
  for (const Polygon& loop : outline) left.push_back(to_path(loop));
  for (const Polygon& loop : taken) others.push_back(to_path(loop));
  if (!region.empty()) left = combined(ClipperLib::ctIntersection, left, {to_path(region)});
  if (apart > 0) others = grown(others, ClipperLib::etClosedPolygon, apart, deviation);
  left = combined(ClipperLib::ctDifference, left, others);
  // Opening removes needles and necks narrower than two chords, which no printer makes.
  left = grown(left, ClipperLib::etClosedPolygon, -0.5 * deviation, deviation);
  left = grown(left, ClipperLib::etClosedPolygon, 0.5 * deviation, deviation);
  ClipperLib::CleanPolygons(left, 0.1 * deviation / unit);
  std::vector<Polygon> loops;
  for (Polygon& loop : to_loops(std::move(left), deviation)) {
    if (loops.empty() || (area(loop) < 0 && contains(loops[0], loop[0]))) {
      loops.push_back(std::move(loop));
    }
  }
  return loops;
}

}  // namespace curveups
