// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/design/contacts.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

const Edges no_cuts(0, 2);

TEST(Contacts, HingeOfTwoTilesTouchesInAFullRectangle) {
  const TileMesh tiles = make_tile_mesh(test::hinge(0.5), no_cuts, 3);
  const auto patches = compute_contact_patches(tiles, truncate_at_vertices(tiles));
  ASSERT_EQ(patches.size(), 1u);
  const ContactPatch& patch = patches[0];
  EXPECT_EQ(patch.point_count, 4);
  // Symmetry makes the interface the plane x = 0.
  EXPECT_NEAR(std::abs(patch.normal.x()), 1, 1e-12);
  const Vec3 from = tiles.frame[tiles.contacts[0].tile[0]](Vec3(1, 1, 0)),
             to = tiles.frame[tiles.contacts[0].tile[1]](Vec3(1, 1, 0));
  EXPECT_GT(patch.normal.dot(to - from), 0);
  for (const Vec3& p : patch.point) EXPECT_NEAR(p.x(), 0, 1e-12);
  EXPECT_NEAR(patch.point[2].z(), -3 / std::cos(0.25), 1e-12);
  // The other walls are upright on each tile: the back edge, 3 tan(0.25) further in, is shorter by
  // what corners of 60 degrees take at both ends.
  EXPECT_NEAR((patch.point[2] - patch.point[3]).norm(), 7 - 6 * std::tan(0.25) / std::sqrt(3.0),
              1e-9);
}

// The closed form against the truncated bodies' own walls.
TEST(Contacts, PatchesAreWhatBothWallsHaveInCommon) {
  for (const TriangleMesh& mesh : {test::dome(6), test::saddle(6), test::ripples(6)}) {
    const TileMesh tiles = make_tile_mesh(mesh, no_cuts, 3);
    const Truncation truncation = truncate_at_vertices(tiles);
    const auto patches = compute_contact_patches(tiles, truncation);
    for (std::size_t k = 0; k < patches.size(); ++k) {
      const Contact& contact = tiles.contacts[k];
      for (int s = 0; s < 2; ++s) {
        const int tile = contact.tile[s];
        const ConvexBody body = tile_body(tiles, truncation, tile);
        for (const Vec3& p : patches[k].polygon) {
          for (const BodyFace& face : body.faces) {
            EXPECT_LE(face.plane.distance(tiles.frame[tile].to_own(p)), 2e-5);
          }
        }
      }
      // Nothing more is common: stepping outwards from each side midpoint leaves one of the two.
      const auto& polygon = patches[k].polygon;
      Vec3 middle = Vec3::Zero();
      for (const Vec3& p : polygon) middle += p / static_cast<double>(polygon.size());
      for (std::size_t c = 0; c < polygon.size(); ++c) {
        const Vec3 side = 0.5 * (polygon[c] + polygon[(c + 1) % polygon.size()]);
        const Vec3 direction = (polygon[(c + 1) % polygon.size()] - polygon[c]).normalized();
        const Vec3 out = direction.cross(patches[k].normal).normalized();
        EXPECT_GT(out.dot(side - middle), 0) << "counter-clockwise seen from tile[1]";
        const Vec3 p = side + 1e-3 * out;
        bool left = false;
        for (int s = 0; s < 2; ++s) {
          const int tile = contact.tile[s];
          for (const BodyFace& face : tile_body(tiles, truncation, tile).faces) {
            left |= face.plane.distance(tiles.frame[tile].to_own(p)) > 1e-4;
          }
        }
        EXPECT_TRUE(left);
      }
    }
  }
}

TEST(Contacts, ClippingMovesContactPointsToTheNewCorners) {
  const TileMesh tiles = make_tile_mesh(test::hinge(0), no_cuts, 3);
  ContactPatch patch = compute_contact_patches(tiles, truncate_at_vertices(tiles))[0];
  // Takes off the lower 1 mm of the start's end, obliquely.
  const Vec3 normal =
      (Vec3(0, -1, 0) * (patch.point[1] - patch.point[0]).normalized().y() + Vec3(0, 0, -1))
          .normalized();
  const Vec3 through = patch.point[3] + Vec3(0, 0, 1);
  ContactPatch clipped = patch;
  clip_patch(clipped, {normal, normal.dot(through)});
  EXPECT_EQ(clipped.point_count, 4);
  EXPECT_EQ(clipped.polygon.size(), 5u);
  EXPECT_LT((clipped.point[2] - patch.point[2]).norm(), 1e-9);
  EXPECT_NEAR((clipped.point[3] - patch.point[3]).norm(), 1, 1e-9);
  clip_patch(patch, {-Vec3::UnitZ(), 0.1});
  EXPECT_EQ(patch.point_count, 2);
}

}  // namespace
}  // namespace curveups
