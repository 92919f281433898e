// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <functional>
#include <optional>
#include <random>
#include <sstream>
#include <utility>

#include "curveups/core/errors.hpp"
#include "curveups/fabrication/occ_solids.hpp"
#include "curveups/fabrication/plane_curves.hpp"
#include "curveups/fabrication/print_model.hpp"
#include "curveups/fabrication/solid_checks.hpp"
#include "support/designs.hpp"
#include "support/soundness.hpp"

namespace curveups {
namespace {

PrintModel sample(const char* bumps) {
  Parameters p;
  p.bumps = bumps;
  return make_print_model(test::sample_design(p));
}

bool valid(const TopoDS_Shape& shape) { return BRepCheck_Analyzer(shape).IsValid(); }

// What check_solids says of a body's solid; "not built" where OpenCASCADE makes none.
std::string reason(const PrintBody& body) {
  try {
    return test::unsound({body});
  } catch (const SolverFailure&) {
    return "not built";
  }
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

TEST(SolidChecks, FindEveryKindOfDamage) {
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
    ASSERT_EQ(reason(body), "");
    for (const auto& [what, damage] : damages) {
      PrintBody damaged = body;
      damage(damaged);
      EXPECT_NE(reason(damaged), "") << what;
    }
  }
}

// At every place of every kind of body, by micrometres and more.
TEST(SolidChecks, CurvesOnPlanesHideNoDamage) {
  std::mt19937 random(7);
  const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random()) % count; };
  int refused = 0, accepted = 0;
  for (const char* bumps : {"bumps", "dimples"}) {
    const PrintModel model = sample(bumps);
    for (int round = 0; round < 150; ++round) {
      PrintBody body = round % 20 == 0   ? model.anchors[below(model.anchors.size())]
                       : round % 50 == 1 ? model.supports[0]
                                         : model.tiles[below(model.tiles.size())];
      const Vec3 shift = Vec3(1, 2, -1) * std::pow(10.0, -9 + static_cast<double>(below(10)));
      PlanarFace& face = body.faces[below(body.faces.size())];
      auto& loop = face.outer.points;
      switch (below(6)) {
        case 0:
          if (!body.points.empty()) body.points[below(body.points.size())] += shift;
          break;
        case 1:
          if (!body.circles.empty()) body.circles[below(body.circles.size())].centre += shift;
          break;
        case 2:
          if (!body.circles.empty()) body.circles[below(body.circles.size())].radius += shift.x();
          break;
        case 3:
          if (!loop.empty()) std::swap(loop[below(loop.size())], loop[below(loop.size())]);
          break;
        case 4:
          face.normal = (face.normal + shift).normalized();
          break;
        default:
          if (!loop.empty()) loop.erase(loop.begin() + static_cast<long>(below(loop.size())));
      }
      std::optional<TopoDS_Shape> solid;
      try {
        solid = make_solid(body);
      } catch (const SolverFailure&) {
        continue;
      }
      const bool sound = valid(*solid);
      ++(sound ? accepted : refused);
      EXPECT_EQ(valid(with_plane_curves(*solid)), sound)
          << bumps << " " << round << " " << body.name;
    }
  }
  EXPECT_GT(refused, 50);
  EXPECT_GT(accepted, 50);
}

TEST(SolidChecks, CurvesOnPlanesHideNoDamageOfShapes) {
  const BRep_Builder builder;
  const PrintModel model = sample("bumps");
  const auto first = [](const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    return TopExp_Explorer(shape, kind).Current();
  };
  const auto refused = [&](const std::function<void(TopoDS_Shape&)>& damage) {
    TopoDS_Shape solid = make_solid(model.tiles[0]);
    damage(solid);
    const bool sound = valid(solid);
    EXPECT_EQ(valid(with_plane_curves(solid)), sound);
    EXPECT_EQ(check_solids({&model.tiles[0]}, {solid}).empty(), sound);
    return !sound;
  };
  EXPECT_FALSE(refused([](TopoDS_Shape&) {}));
  EXPECT_TRUE(refused([&](TopoDS_Shape& solid) {
    const TopoDS_Vertex corner = TopoDS::Vertex(first(solid, TopAbs_VERTEX));
    const gp_Pnt at = BRep_Tool::Pnt(corner).Translated({0, 0, 1e-3});
    builder.UpdateVertex(corner, at, Precision::Confusion());
  })) << "a corner beside its edges";
  EXPECT_TRUE(refused([&](TopoDS_Shape& solid) {
    builder.Range(TopoDS::Edge(first(solid, TopAbs_EDGE)), 0.1, 0.2);
  })) << "an edge shorter than it";
  EXPECT_TRUE(refused([&](TopoDS_Shape& solid) {
    TopoDS_Shape edge = first(solid, TopAbs_EDGE);
    edge.Free(true);
    builder.Remove(edge, first(edge, TopAbs_VERTEX));
  })) << "an edge without an end";
  EXPECT_TRUE(refused([&](TopoDS_Shape& solid) {
    TopoDS_Shape wire;
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
      wire = first(it.Current(), TopAbs_WIRE);
    }
    wire.Free(true);
    builder.Remove(wire, first(wire, TopAbs_EDGE));
  })) << "an open wire";
}

TEST(SolidChecks, LeaveSolidsAsTheyAre) {
  const PrintModel model = sample("bumps");
  const TopoDS_Shape solid = make_solid(model.tiles[0]);
  const auto curves = [](const TopoDS_Shape& shape) {
    int stored = 0, edges = 0;
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
      for (TopExp_Explorer it(face.Current(), TopAbs_EDGE); it.More(); it.Next()) {
        double first, last;
        Standard_Boolean there = false;
        BRep_Tool::CurveOnSurface(TopoDS::Edge(it.Current()), TopoDS::Face(face.Current()), first,
                                  last, &there);
        stored += there;
        ++edges;
      }
    }
    return std::make_pair(stored, edges);
  };
  const auto [before, edges] = curves(solid);
  const auto [made, same_edges] = curves(with_plane_curves(solid));
  EXPECT_LT(before, edges);
  EXPECT_EQ(made, edges);
  EXPECT_EQ(same_edges, edges);
  EXPECT_TRUE(check_solids({&model.tiles[0]}, {solid}).empty());
  EXPECT_EQ(curves(solid).first, before);
}

}  // namespace
}  // namespace curveups
