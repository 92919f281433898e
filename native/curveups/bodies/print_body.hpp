// SPDX-License-Identifier: LGPL-2.1-or-later
// Closed bodies of a print: planar faces with holes, spherical caps (bumps and dimples) and
// cylinder walls.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "curveups/core/types.hpp"
#include "curveups/design/convex_body.hpp"
#include "curveups/design/flat_layout.hpp"
#include "curveups/design/tile_mesh.hpp"
#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {

// Motion of row `tile` of the poses, with the tile's front face at height z.
RigidMotion flat_motion(const FlatPoses& poses, int tile, double z);

// A circle that a planar face shares with a cap or a cylinder wall.
struct BodyCircle {
  Vec3 centre;
  Vec3 axis;  // unit; which of the two normals does not matter
  double radius;
};

// A closed boundary of a planar face: a polygon of point indices, or one whole circle.
struct BodyLoop {
  std::vector<int> points;
  int circle = -1;
};

// Role of a tile's face. foot: end of the back pin, on which the print stands.
enum class FaceRole { front, back, wall, cut, front_pin, back_pin, foot, plain };

// outer runs counter-clockwise and inner ones clockwise about the outward normal.
struct PlanarFace {
  Vec3 normal;  // unit, out of the material
  BodyLoop outer;
  std::vector<BodyLoop> inner;
  FaceRole role = FaceRole::plain;
};

// The part of a sphere on the side of `axis` of its base circle, at most a hemisphere.
struct SphericalCap {
  int circle;
  Vec3 axis;  // unit, from the base's centre to the apex
  double height;
  bool bump;  // material inside the cap; a dimple otherwise
};

// The cylinder wall between two circles.
struct CylinderWall {
  int bottom, top;
  bool outward;  // material inside the cylinder; a bore otherwise
};

enum class BodyKind { tile, support, anchor };

// Colour of bodies in STEP and 3MF, sRGB, 0 to 255: tiles blue, support sand, anchors brick.
struct Colour {
  unsigned char red, green, blue;
};
inline Colour body_colour(BodyKind kind) {
  constexpr Colour colours[] = {{58, 110, 165}, {222, 203, 164}, {190, 92, 67}};
  return colours[static_cast<int>(kind)];
}

struct PrintBody {
  std::string name;
  BodyKind kind = BodyKind::tile;
  int piece = 0;
  int tile = -1;  // row of F; -1: support or anchor
  std::vector<Vec3> points;
  std::vector<BodyCircle> circles;
  std::vector<PlanarFace> faces;
  std::vector<SphericalCap> caps;
  std::vector<CylinderWall> cylinders;
};

double sphere_radius(double base_radius, double height);

// Area without holes, mm2.
double face_area(const PrintBody& body, const PlanarFace& face);

// Exact volume by the divergence theorem, mm3.
double volume(const PrintBody& body);

void move(PrintBody& body, const RigidMotion& motion);

// Smallest box, caps included.
Eigen::AlignedBox3d bounding_box(const PrintBody& body);

// Adds points at height z; returns their loop.
std::vector<int> add_points(PrintBody& body, const Polygon& polygon, double z);

// Adds the lateral faces of the prism over the loop of points `base` (counter-clockwise about
// `offset`); returns its top loop.
std::vector<int> extrude(PrintBody& body, const std::vector<int>& base, const Vec3& offset,
                         FaceRole role);

// Adds the walls from z = 0 to `height` around a polygon: material is inside of a counter-clockwise
// one and outside of a clockwise one. Returns the loops of the faces below and above.
std::pair<BodyLoop, BodyLoop> add_walls(PrintBody& body, const Polygon& polygon, double height);

}  // namespace curveups
