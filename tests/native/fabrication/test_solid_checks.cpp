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
#include "curveups/fabrication/print_model.hpp"
#include "curveups/fabrication/print_solids.hpp"
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

// Answer of check_solids for a body's solid; "not built" where OpenCASCADE makes none.
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

TEST(SolidChecks, FindDamageOfShapes) {
  const BRep_Builder builder;
  const PrintModel model = sample("bumps");
  const auto first = [](const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    return TopExp_Explorer(shape, kind).Current();
  };
  const auto refused = [&](const std::function<void(TopoDS_Shape&)>& damage) {
    TopoDS_Shape solid = make_solid(model.tiles[0]);
    damage(solid);
    const bool sound = valid(solid);
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

TEST(SolidReasons, NameSomeUnsoundBodiesAndCountTheOthers) {
  EXPECT_TRUE(solid_reasons({}).empty());
  const std::vector<Finding> reasons = solid_reasons({{"T00001", "open", 0},
                                                      {"T00002", "open", 1},
                                                      {"T00004", "open", 3},
                                                      {"Support P1", "open"}});
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_EQ(reasons[0].kind, "unsound.many");
  EXPECT_EQ(reasons[0].tiles, (std::vector<int>{0, 1, 3}));
  const auto named = std::get<std::vector<Finding>>(reasons[0].figures.at("solids"));
  ASSERT_EQ(named.size(), 3u);
  EXPECT_EQ(std::get<std::string>(named[2].figures.at("body")), "T00004");
  EXPECT_EQ(std::get<int>(reasons[0].figures.at("more")), 1);
}

}  // namespace
}  // namespace curveups
