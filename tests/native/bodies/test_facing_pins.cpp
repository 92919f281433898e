// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "curveups/bodies/facing_pins.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

// Two flat patches of as many tiles, the second `apart` above the first, which it faces with its
// back, or turned over with its front.
TriangleMesh storeys(double apart, bool turned = false) {
  const TriangleMesh one = test::flat_patch(3, 7);
  TriangleMesh both;
  const Eigen::Index v = one.V.rows(), f = one.F.rows();
  both.V.resize(2 * v, 3);
  both.V << one.V, one.V;
  both.V.bottomRows(v).col(2).array() += apart;
  both.F.resize(2 * f, 3);
  both.F << one.F, (one.F.array() + static_cast<int>(v)).matrix();
  if (turned) both.F.bottomRows(f).col(1).swap(both.F.bottomRows(f).col(2));
  return both;
}

int meeting(const TriangleMesh& mesh, const Parameters& p) {
  const auto pairs = facing_pins(make_geometry(mesh, Edges(0, 2), p), p.H_pin);
  const int half = static_cast<int>(mesh.F.rows()) / 2;
  for (const auto& [a, b] : pairs) {
    EXPECT_LT(a, half);
    EXPECT_GE(b, half);
  }
  return static_cast<int>(pairs.size());
}

TEST(FacingPins, MeetWhereStoreysAreLowerThanBodyAndBothPins) {
  Parameters p;
  p.H_body = 3;
  p.H_pin = 1;
  const int tiles = static_cast<int>(test::flat_patch(3, 7).F.rows());
  EXPECT_EQ(meeting(storeys(5.001), p), 0);
  EXPECT_GE(meeting(storeys(4.999), p), tiles);  // pin above pin, tile for tile
  EXPECT_GE(meeting(storeys(3.5), p), tiles);    // pins in bodies
  p.H_pin = 0.25;
  EXPECT_EQ(meeting(storeys(3.501), p), 0);
}

TEST(FacingPins, FrontsThatFaceOneAnotherMeetAboveThem) {
  Parameters p;
  EXPECT_EQ(meeting(storeys(2 * p.H_pin + 0.001, true), p), 0);
  EXPECT_GT(meeting(storeys(2 * p.H_pin - 0.001, true), p), 0);
}

TEST(FacingPins, PinsThatPlanesKeepApartDoNotMeet) {
  Parameters p;
  p.H_pin = 2;
  // A narrow valley, whose slopes' pins planes part.
  const TriangleMesh valley = test::lifted_patch(
      6, 7, [](double x, double) { return 0.9 * std::max(0.0, std::abs(x) - 3.5); });
  const DesignGeometry geometry = make_geometry(valley, Edges(0, 2), p);
  std::size_t planes = 0;
  for (const auto& of_tile : geometry.truncation.front_pins) planes += of_tile.size();
  ASSERT_GT(planes, 0u);
  EXPECT_TRUE(facing_pins(geometry, p.H_pin).empty());
}

TEST(FacingPins, NeighboursAndSmoothSheetsHaveNone) {
  Parameters p;
  for (const TriangleMesh& mesh :
       {test::flat_patch(), test::dome(), test::saddle(), test::ripples()}) {
    EXPECT_TRUE(facing_pins(make_geometry(mesh, Edges(0, 2), p), p.H_pin).empty());
  }
}

}  // namespace
}  // namespace curveups
