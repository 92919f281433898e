// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/ring.hpp"

#include <algorithm>
#include <tuple>

#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

constexpr double largest = 1e4;  // mm

void require_part(const RingPart& part) {
  if (part.outline.size() < 3 || (!part.window.empty() && part.window.size() < 3)) {
    throw InvalidInput("a part of a ring has less than three corners", "give it an outline");
  }
  for (const Polygon* points : {&part.outline, &part.window, &part.teeth, &part.holes}) {
    for (const Vec2& p : *points) {
      if (!(p.cwiseAbs().maxCoeff() <= largest)) {
        throw InvalidInput("a ring has a point that is not finite or beyond 10 m",
                           "give places in mm");
      }
    }
  }
}

PrintBody make_part(const RingPart& part, double thickness, double radius, double height) {
  PrintBody body;
  PlanarFace below, above;
  below.normal = -Vec3::UnitZ();
  above.normal = Vec3::UnitZ();
  std::tie(below.outer, above.outer) = add_walls(body, part.outline, thickness);
  if (!part.window.empty()) {
    auto [low, high] = add_walls(body, {part.window.rbegin(), part.window.rend()}, thickness);
    below.inner.push_back(std::move(low));
    above.inner.push_back(std::move(high));
  }
  const auto add_circles = [&](const Vec2& p, double low, double high) {
    const int first = static_cast<int>(body.circles.size());
    for (const double z : {low, high}) {
      body.circles.push_back({Vec3(p.x(), p.y(), z), Vec3::UnitZ(), radius});
    }
    return first;
  };
  for (const Vec2& tooth : part.teeth) {
    const int foot = add_circles(tooth, thickness, thickness + height - radius);
    above.inner.push_back({{}, foot});
    body.cylinders.push_back({foot, foot + 1, true});
    body.caps.push_back({foot + 1, Vec3::UnitZ(), radius, true});
  }
  for (const Vec2& hole : part.holes) {
    const int foot = add_circles(hole, 0, thickness);
    below.inner.push_back({{}, foot});
    above.inner.push_back({{}, foot + 1});
    body.cylinders.push_back({foot, foot + 1, false});
  }
  body.faces.push_back(std::move(below));
  body.faces.push_back(std::move(above));
  return body;
}

}  // namespace

PrintModel make_ring(const std::string& name, const std::vector<RingPart>& parts, double thickness,
                     double tooth_radius, double tooth_height) {
  if (!(thickness > 0 && tooth_radius > 0 && tooth_height > tooth_radius &&
        std::max(thickness, tooth_height) <= largest)) {
    throw InvalidInput("a ring's sizes make no teeth", "give teeth that are higher than wide");
  }
  if (parts.empty()) throw InvalidInput("a ring has no part", "give its outline");
  PrintModel model;
  model.name = name;
  model.piece_count = 1;
  for (const RingPart& part : parts) {
    require_part(part);
    model.tiles.push_back(make_part(part, thickness, tooth_radius, tooth_height));
    model.tiles.back().name = "Ring P" + std::to_string(model.tiles.size());
    model.box.extend(bounding_box(model.tiles.back()));
  }
  return model;
}

}  // namespace curveups
