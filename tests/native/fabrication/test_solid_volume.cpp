// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <GProp_GProps.hxx>
#include <map>
#include <string>

#include "curveups/fabrication/solid_volume.hpp"

namespace curveups {
namespace {

constexpr double pi = 3.14159265358979323846;

double integrated(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-12);
  return properties.Mass();
}

const gp_Ax2 oblique({1, -2, 3}, {0.3, -0.5, 0.8});

std::map<std::string, TopoDS_Shape> shapes() {
  return {
      {"box", BRepPrimAPI_MakeBox(oblique, 1, 2, 3).Shape()},
      {"sphere", BRepPrimAPI_MakeSphere(oblique, 2).Shape()},
      {"cap of a sphere", BRepPrimAPI_MakeSphere(oblique, 2, 0.4, 0.5 * pi).Shape()},
      {"belt of a sphere", BRepPrimAPI_MakeSphere(oblique, 2, -0.3, 0.9).Shape()},
      {"slice of a sphere", BRepPrimAPI_MakeSphere(oblique, 2, -0.3, 0.9, 1.0).Shape()},
      {"almost all of a belt",
       BRepPrimAPI_MakeSphere(oblique, 2, -0.3, 0.9, 2 * pi - 1e-3).Shape()},
      {"cylinder", BRepPrimAPI_MakeCylinder(oblique, 2, 5).Shape()},
      {"slice of a cylinder", BRepPrimAPI_MakeCylinder(oblique, 2, 5, 2.0).Shape()},
      {"cone", BRepPrimAPI_MakeCone(oblique, 2, 1, 5).Shape()},
  };
}

TEST(SolidVolume, IsWhatIsIntegrated) {
  gp_Trsf mirror, move;
  mirror.SetMirror(gp_Ax2({0.5, 0, 1}, {1, 1, 0}));
  move.SetTranslation({7, 8, -9});
  for (const auto& [name, shape] : shapes()) {
    const double exact = integrated(shape);
    ASSERT_GT(exact, 0) << name;
    EXPECT_NEAR(solid_volume(shape), exact, 1e-9 * exact) << name;
    EXPECT_NEAR(solid_volume(shape.Reversed()), -exact, 1e-9 * exact) << name;
    EXPECT_NEAR(solid_volume(shape.Moved(move)), exact, 1e-9 * exact) << name;
    const TopoDS_Shape mirrored = BRepBuilderAPI_Transform(shape, mirror, true).Shape();
    EXPECT_NEAR(solid_volume(mirrored), integrated(mirrored), 1e-9 * exact) << name;
  }
}

TEST(SolidVolume, OfBeltsIsExact) {
  EXPECT_NEAR(solid_volume(shapes().at("sphere")), 4 * pi * 8 / 3, 1e-12);
  EXPECT_NEAR(solid_volume(shapes().at("cylinder")), pi * 4 * 5, 1e-12);
}

}  // namespace
}  // namespace curveups
