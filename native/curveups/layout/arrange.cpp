// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/arrange.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "curveups/geometry/convex_polygon.hpp"
#include "curveups/layout/initial_layout.hpp"

namespace curveups {
namespace {

struct Rectangle {
  double angle = 0;                              // turn of the piece
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();  // of the turned piece
};

Rectangle bounds_at(const std::vector<Vec2>& hull, double angle) {
  const PlaneRotation turn(angle);
  Rectangle r{angle, turn * hull[0], turn * hull[0]};
  for (const Vec2& p : hull) {
    const Vec2 q = turn * p;
    r.low = r.low.cwiseMin(q);
    r.high = r.high.cwiseMax(q);
  }
  return r;
}

// Smallest rectangle, which has a side on an edge of the hull.
Rectangle smallest_rectangle(const std::vector<Vec2>& hull) {
  Rectangle best;
  double least = -1;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Vec2 edge = hull[(k + 1) % hull.size()] - hull[k];
    Rectangle r = bounds_at(hull, -std::atan2(edge.y(), edge.x()));
    const Vec2 size = r.high - r.low;
    // Among equals the first: the order of the hull does not depend on rounding.
    if (least >= 0 && size.prod() >= least * (1 - 1e-9)) continue;
    least = size.prod();
    best = r;
  }
  if ((best.high - best.low).x() < (best.high - best.low).y()) {
    best = bounds_at(hull, best.angle + 0.5 * M_PI);
  }
  return best;
}

}  // namespace

FlatPoses arrange_pieces(const TileMesh& tiles, const FlatPoses& poses, double margin) {
  const std::vector<std::vector<int>> pieces = pieces_of(tiles);
  std::vector<Rectangle> rectangles;
  double area = 0, widest = 0;
  for (const std::vector<int>& piece : pieces) {
    std::vector<Vec2> points;
    for (int i : piece) {
      for (Side side : {Side::front, Side::back}) {
        for (const Vec2& p : place(poses, i, tiles.corners(i, side))) points.push_back(p);
      }
    }
    rectangles.push_back(smallest_rectangle(convex_hull(std::move(points))));
    const Vec2 size = rectangles.back().high - rectangles.back().low + Vec2::Constant(2 * margin);
    area += size.prod();
    widest = std::max(widest, size.x());
  }
  // Shelves, highest pieces first.
  std::vector<std::size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  auto height = [&](std::size_t k) { return (rectangles[k].high - rectangles[k].low).y(); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return height(a) > height(b); });
  const double row_width = std::max(widest, 1.2 * std::sqrt(area));
  FlatPoses out(poses.rows(), 3);
  Vec2 cursor = Vec2::Zero(), high = Vec2::Zero();
  double row_height = 0;
  for (std::size_t k : order) {
    const Rectangle& r = rectangles[k];
    const Vec2 size = r.high - r.low + Vec2::Constant(2 * margin);
    if (cursor.x() > 0 && cursor.x() + size.x() > row_width) {
      cursor = Vec2(0, cursor.y() + row_height);
      row_height = 0;
    }
    const Vec2 shift = cursor + Vec2::Constant(margin) - r.low;
    const PlaneRotation turn(r.angle);
    for (int i : pieces[k]) {
      const Vec2 origin = turn * Vec2(poses(i, 0), poses(i, 1)) + shift;
      out.row(i) << origin.x(), origin.y(), poses(i, 2) + r.angle;
    }
    cursor.x() += size.x();
    row_height = std::max(row_height, size.y());
    high = high.cwiseMax(Vec2(cursor.x(), cursor.y() + row_height));
  }
  out.col(0).array() -= 0.5 * high.x();
  out.col(1).array() -= 0.5 * high.y();
  for (int i = 0; i < out.rows(); ++i) out(i, 2) = std::remainder(out(i, 2), 2 * M_PI);
  return out;
}

}  // namespace curveups
