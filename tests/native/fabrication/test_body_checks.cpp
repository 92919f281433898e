// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "curveups/bodies/body_checks.hpp"
#include "curveups/fabrication/print_model.hpp"
#include "support/designs.hpp"

namespace curveups {
namespace {

PrintModel sample(const char* bumps) {
  Parameters p;
  p.bumps = bumps;
  return make_print_model(test::sample_design(p));
}

PlanarFace& holed_face(PrintBody& body) {
  return *std::find_if(body.faces.begin(), body.faces.end(),
                       [](const PlanarFace& face) { return !face.inner.empty(); });
}

using Damage = std::function<void(PrintBody&)>;

const std::vector<std::pair<const char*, Damage>> damages = {
    {"a face is missing", [](PrintBody& b) { b.faces.pop_back(); }},
    {"a face is there twice", [](PrintBody& b) { b.faces.push_back(b.faces.front()); }},
    {"a face is turned over", [](PrintBody& b) { b.faces[0].normal *= -1; }},
    {"a loop runs the other way",
     [](PrintBody& b) {
       auto& loop = b.faces[0].outer.points;
       std::reverse(loop.begin(), loop.end());
     }},
    {"a face crosses itself",
     [](PrintBody& b) {
       auto& loop = holed_face(b).outer.points;
       std::swap(loop[0], loop[1]);
     }},
    {"a corner is off its faces by 1 micrometre",
     [](PrintBody& b) { b.points[b.faces[0].outer.points[0]] += Vec3(5e-4, 5e-4, 5e-4); }},
    {"a corner is far off", [](PrintBody& b) { b.points[0] += Vec3(20, 0, 0); }},
    {"a hole lies beside its face",
     [](PrintBody& b) {
       PlanarFace& face = holed_face(b);
       BodyCircle& hole = b.circles[face.inner[0].circle];
       hole.centre += 50 * face.normal.unitOrthogonal();
     }},
    {"a hole is off its face's plane",
     [](PrintBody& b) {
       PlanarFace& face = holed_face(b);
       b.circles[face.inner[0].circle].centre += 1e-3 * face.normal;
     }},
    {"a hole is larger than its face",
     [](PrintBody& b) {
       PlanarFace& face = holed_face(b);
       b.circles[face.inner[0].circle].radius *= 40;
     }},
    {"two holes overlap",
     [](PrintBody& b) {
       PlanarFace& face = holed_face(b);
       const BodyCircle& one = b.circles[face.inner[0].circle];
       BodyCircle& other = b.circles[face.inner[1].circle];
       other.centre = one.centre + 0.5 * one.radius * face.normal.unitOrthogonal();
     }},
    {"a hole is listed twice",
     [](PrintBody& b) {
       PlanarFace& face = holed_face(b);
       face.inner.push_back(face.inner[0]);
     }},
};

TEST(BodyChecks, FindEveryKindOfDamage) {
  for (const char* bumps : {"bumps", "dimples"}) {
    const PrintModel model = sample(bumps);
    const auto& tiles = model.tiles;
    const auto fit = std::find_if(tiles.begin(), tiles.end(), [](const PrintBody& body) {
      return std::any_of(body.faces.begin(), body.faces.end(),
                         [](const PlanarFace& face) { return face.inner.size() > 1; });
    });
    ASSERT_NE(fit, tiles.end());
    PrintBody body = *fit;
    // Faces with holes first come with two.
    std::stable_partition(body.faces.begin(), body.faces.end(),
                          [](const PlanarFace& face) { return face.inner.size() > 1; });
    ASSERT_EQ(unsoundness(body), "");
    for (const auto& [what, damage] : damages) {
      PrintBody damaged = body;
      damage(damaged);
      EXPECT_NE(unsoundness(damaged), "") << what;
    }
  }
}

TEST(BodyChecks, PassAllBodiesOfEveryKindOfPrint) {
  for (const char* bumps : {"none", "bumps", "dimples"}) {
    for (const char* support : {"breakaway", "soluble"}) {
      for (const char* joint : {"none", "holes"}) {
        Parameters p;
        p.bumps = bumps;
        p.support = support;
        p.joint = joint;
        const PrintModel model = make_print_model(test::sample_design(p));
        for (const PrintBody* body : model.bodies("print")) {
          EXPECT_EQ(unsoundness(*body), "") << body->name << bumps << support << joint;
        }
      }
    }
  }
}

}  // namespace
}  // namespace curveups
