// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/convex_body.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "curveups/core/tolerances.hpp"

namespace curveups {
namespace {

Plane plane_through(const std::vector<Vec3>& points, const std::vector<int>& loop) {
  Vec3 normal = Vec3::Zero(), middle = Vec3::Zero();
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec3& a = points[loop[k]];
    const Vec3& b = points[loop[(k + 1) % loop.size()]];
    normal += (a - points[loop[0]]).cross(b - points[loop[0]]);
    middle += a;
  }
  normal.normalize();
  return {normal, normal.dot(middle) / static_cast<double>(loop.size())};
}

// Drops the points that no face uses.
void compact(ConvexBody& body) {
  std::vector<int> index(body.points.size(), -1);
  std::vector<Vec3> points;
  for (BodyFace& face : body.faces) {
    for (int& p : face.loop) {
      if (index[p] < 0) {
        index[p] = static_cast<int>(points.size());
        points.push_back(body.points[p]);
      }
      p = index[p];
    }
  }
  body.points = std::move(points);
}

}  // namespace

ConvexBody make_frustum(const std::array<Vec2, 3>& top, double z_top,
                        const std::array<Vec2, 3>& bottom, double z_bottom) {
  ConvexBody body;
  for (const Vec2& p : top) body.points.emplace_back(p.x(), p.y(), z_top);
  for (const Vec2& p : bottom) body.points.emplace_back(p.x(), p.y(), z_bottom);
  body.faces.push_back({{0, 1, 2}, body_tag::front, {Vec3::UnitZ(), z_top}});
  body.faces.push_back({{5, 4, 3}, body_tag::back, {-Vec3::UnitZ(), -z_bottom}});
  for (int t = 0; t < 3; ++t) {
    const int u = next3(t);
    std::vector<int> loop = {t, t + 3, u + 3, u};
    const Plane plane = plane_through(body.points, loop);
    body.faces.push_back({std::move(loop), body_tag::wall + t, plane});
  }
  return body;
}

bool clip(ConvexBody& body, const Plane& plane, int tag) {
  const std::size_t count = body.points.size();
  std::vector<int> place(count);  // -1 kept, 0 on the plane, 1 beyond it
  bool beyond = false, kept = false;
  for (std::size_t p = 0; p < count; ++p) {
    const double d = plane.distance(body.points[p]);
    place[p] = d > tolerance::snap ? 1 : d < -tolerance::snap ? -1 : 0;
    beyond |= place[p] > 0;
    kept |= place[p] < 0;
  }
  if (!beyond) return false;
  if (!kept) {
    body = {};
    return true;
  }
  std::map<std::pair<int, int>, int> crossings;
  auto crossing = [&](int a, int b) {
    const auto key = std::minmax(a, b);
    const auto known = crossings.find(key);
    if (known != crossings.end()) return known->second;
    const Vec3 p = body.points[key.first], q = body.points[key.second];
    const double dp = plane.distance(p), dq = plane.distance(q);
    body.points.push_back(p + (dp / (dp - dq)) * (q - p));
    place.push_back(0);
    return crossings[key] = static_cast<int>(body.points.size()) - 1;
  };
  std::vector<BodyFace> faces;
  std::map<int, int> rim;  // edges of the new face
  for (BodyFace& face : body.faces) {
    std::vector<int> loop;
    bool inside = false;
    const std::size_t n = face.loop.size();
    for (std::size_t k = 0; k < n; ++k) {
      const int a = face.loop[k], b = face.loop[(k + 1) % n];
      if (place[a] <= 0) loop.push_back(a);
      inside |= place[a] < 0;
      if (place[a] * place[b] < 0) loop.push_back(crossing(a, b));
    }
    if (!inside || loop.size() < 3) continue;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int a = loop[k], b = loop[(k + 1) % loop.size()];
      if (place[a] == 0 && place[b] == 0) rim[b] = a;
    }
    face.loop = std::move(loop);
    faces.push_back(std::move(face));
  }
  BodyFace cap{{}, tag, plane};
  if (!rim.empty()) {
    const int start = rim.begin()->first;
    int p = start;
    do {
      cap.loop.push_back(p);
      const auto it = rim.find(p);
      if (it == rim.end()) break;
      p = it->second;
    } while (p != start && cap.loop.size() <= rim.size());
  }
  if (cap.loop.size() >= 3) faces.push_back(std::move(cap));
  body.faces = std::move(faces);
  compact(body);
  return true;
}

namespace {

struct Moments {
  double volume = 0;
  Vec3 centroid = Vec3::Zero();
};

Moments moments(const ConvexBody& body) {
  if (body.faces.empty()) return {};
  double six = 0;
  Vec3 sum = Vec3::Zero();
  const Vec3 origin = body.points[0];
  for (const BodyFace& face : body.faces) {
    const Vec3 a = body.points[face.loop[0]] - origin;
    for (std::size_t k = 1; k + 1 < face.loop.size(); ++k) {
      const Vec3 b = body.points[face.loop[k]] - origin, c = body.points[face.loop[k + 1]] - origin;
      const double part = a.dot(b.cross(c));
      six += part;
      sum += part * 0.25 * (a + b + c);
    }
  }
  return {six / 6, origin + sum / six};
}

}  // namespace

double volume(const ConvexBody& body) { return moments(body).volume; }

Vec3 centroid(const ConvexBody& body) { return moments(body).centroid; }

}  // namespace curveups
