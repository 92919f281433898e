// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "curveups/actuation/actuated_design.hpp"
#include "curveups/bodies/convex_distance.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "support/designs.hpp"

namespace curveups::test {
namespace {

constexpr double pi = 3.14159265358979323846;

Parameters plain(double friction) {
  Parameters parameters;
  parameters.mesh_size = 2;
  parameters.bumps = "none";
  parameters.friction_coefficient = friction;
  return parameters;
}

Design dome(double friction) {
  SampleOptions o;
  o.rows = 2;
  o.columns = 3;
  o.kx = o.ky = 0.02;
  return sample_design(plain(friction), o);
}

// Tiles in a row between two circles of this radius about the y axis, `fold` apart: a strip of an
// antiprism's wall, laid out with gaps.
Design strip(int count, double radius, double turn) {
  TriangleMesh mesh{Points3(count + 2, 3), Triangles(count, 3)};
  for (int v = 0; v < count + 2; ++v) {
    const double angle = 0.5 * turn * (v - 0.5 * (count + 1));
    mesh.V.row(v) << radius * std::sin(angle), v % 2 ? 6.0 : 0.0, radius * std::cos(angle);
  }
  for (int i = 0; i < count; ++i) {
    if (i % 2) {
      mesh.F.row(i) << i, i + 1, i + 2;
    } else {
      mesh.F.row(i) << i, i + 2, i + 1;
    }
  }
  return spread_design(mesh, 1.35, 0.6);
}

// Six tiles round a vertex that stands `height` above the others.
Design pyramid(double height) {
  TriangleMesh mesh{Points3(7, 3), Triangles(6, 3)};
  mesh.V.row(0) << 0, 0, height;
  for (int k = 0; k < 6; ++k) {
    mesh.V.row(k + 1) << 7 * std::cos(k * pi / 3), 7 * std::sin(k * pi / 3), 0;
    mesh.F.row(k) << 0, k + 1, (k + 1) % 6 + 1;
  }
  return spread_design(mesh, 1.4, 0.6);
}

ActuatedDesign actuate(Design design, double friction, const PathOptions& options = {}) {
  design.parameters.mesh_size = 2;
  design.parameters.bumps = "none";
  design.parameters.friction_coefficient = friction;
  return actuate_design(design, options, {});
}

// Front normals of the tiles where a load case ends.
std::vector<Vec3> normals_at(const Design& design, const RestState& state) {
  const int count = static_cast<int>(design.mesh.F.rows());
  const auto motions = frame_motions(state.tiles, count);
  std::vector<Vec3> out;
  for (int i = 0; i < count; ++i) {
    const Vec3 a = design.mesh.V.row(design.mesh.F(i, 0)),
               b = design.mesh.V.row(design.mesh.F(i, 1)),
               c = design.mesh.V.row(design.mesh.F(i, 2));
    out.push_back(motions[i].R * (b - a).cross(c - a).normalized());
  }
  return out;
}

TEST(ActuatedDesign, AStripOfTenTilesClosesToItsFolds) {
  const double radius = 30, turn = 0.3;
  const Design design = strip(10, radius, turn);
  const ActuatedDesign piece = actuate(design, 0);
  ASSERT_TRUE(piece.released->at_rest);
  EXPECT_TRUE(piece.released->open_contacts.empty());
  // Neighbours of an antiprism's wall: their normals, by the chord of half a turn.
  const Vec3 a(radius * std::sin(0.0), 0, radius),
      b(radius * std::sin(turn), 0, radius * std::cos(turn)),
      c(radius * std::sin(turn / 2), 6, radius * std::cos(turn / 2)),
      d(radius * std::sin(1.5 * turn), 6, radius * std::cos(1.5 * turn));
  const double fold =
      std::acos((b - a).cross(c - a).normalized().dot((c - d).cross(b - d).normalized()));
  for (const RestState& state : {*piece.relaxed, *piece.released}) {
    ASSERT_TRUE(state.at_rest);
    const std::vector<Vec3> normals = normals_at(design, state);
    for (int i = 0; i + 1 < 10; ++i) {
      EXPECT_NEAR(std::acos(normals[i].dot(normals[i + 1])), fold, 0.005) << i;
    }
  }
  EXPECT_TRUE(piece.relaxed->open_contacts.empty());
  EXPECT_LE(piece.relaxed->element_change, 0.05);
}

TEST(ActuatedDesign, ARingOfTilesClosesToItsPyramid) {
  const double height = 2;
  const Design design = pyramid(height);
  const ActuatedDesign piece = actuate(design, 0);
  ASSERT_TRUE(piece.released->at_rest);
  EXPECT_TRUE(piece.released->open_contacts.empty());
  const double slope = std::atan(height / (7 * std::cos(pi / 6)));
  const std::vector<Vec3> normals = normals_at(design, *piece.released);
  Vec3 axis = Vec3::Zero();
  for (const Vec3& normal : normals) axis += normal / 6;
  // Without friction, neighbours may lean by turns: their walls stay closed. The mean may not.
  double mean = 0;
  for (const Vec3& normal : normals) {
    const double own = std::acos(normal.dot(axis.normalized()));
    EXPECT_NEAR(own, slope, 0.01);
    mean += own / 6;
  }
  EXPECT_NEAR(mean, slope, 0.002);
}

TEST(ActuatedDesign, EnergyFallsAndFrictionTakes) {
  for (double friction : {0.0, 0.3}) {
    const ActuatedDesign piece = actuate(dome(friction), friction);
    const std::vector<PathFrame>& frames = piece.frames;
    const int end = piece.released->last_frame;
    ASSERT_GT(end, 10);
    for (int k = 1; k <= end; ++k) {
      EXPECT_LT(frames[k].energy, frames[k - 1].energy + 1e-3 * frames[0].energy);
      EXPECT_GE(frames[k].friction, frames[k - 1].friction);
      EXPECT_LT(frames[k].stretch, 1.0001 * frames[0].stretch);
    }
    EXPECT_EQ(frames[end].friction > 0, friction > 0);
    // Drag and friction together take what is lost.
    EXPECT_LE(frames[end].friction, frames[0].energy - frames[end].energy);
  }
}

TEST(ActuatedDesign, NoTilePassesThroughAnother) {
  const Design design = dome(0.3);
  const ActuatedDesign piece = actuate(design, 0.3);
  const TileBodies bodies = make_tile_bodies(design);
  const TileMesh& tiles = bodies.geometry.tiles;
  double tile = 0, largest = 0;
  for (const PathFrame& frame : piece.frames) {
    std::vector<ConvexBody> placed;
    const auto motions = frame_motions(frame.tiles, tiles.tile_count());
    for (int i = 0; i < tiles.tile_count(); ++i) {
      placed.push_back(moved(moved(bodies.bumps.body[i], tiles.frame[i]), motions[i]));
    }
    for (int i = 0; i < tiles.tile_count(); ++i) {
      tile = common_volume(placed[i], placed[i]);
      for (int j = i + 1; j < tiles.tile_count(); ++j) {
        largest = std::max(largest, common_volume(placed[i], placed[j]) / tile);
      }
    }
  }
  ASSERT_GT(tile, 0);
  // Walls are springs: one that is 0.06 mm deep in another shares 2 % of its tile with it.
  EXPECT_LT(largest, 0.02);
}

TEST(ActuatedDesign, ShakenAndPressedItComesNearerToItsShape) {
  const ActuatedDesign piece = actuate(dome(0.6), 0.6);
  ASSERT_TRUE(piece.released && piece.shaken && piece.pressed);
  ASSERT_TRUE(piece.released->at_rest && piece.shaken->at_rest && piece.pressed->at_rest);
  EXPECT_GE(piece.shaken->taps, 2);
  EXPECT_LT(piece.shaken->energy, piece.released->energy);
  EXPECT_LT(piece.shaken->scan.mean, piece.released->scan.mean);
  EXPECT_GT(piece.pressed->force, 0);
  EXPECT_LT(piece.pressed->scan.mean, piece.shaken->scan.mean);
  EXPECT_LE(piece.pressed->open_contacts.size(), piece.shaken->open_contacts.size());
  // Frames of the load cases follow one another in time.
  ASSERT_EQ(piece.pressed->last_frame + 1, static_cast<int>(piece.frames.size()));
  for (std::size_t k = 1; k < piece.frames.size(); ++k) {
    EXPECT_GE(piece.frames[k].load, piece.frames[k - 1].load);
    EXPECT_GT(piece.frames[k].time, piece.frames[k - 1].time);
  }
  EXPECT_EQ(piece.frames[piece.released->last_frame + 1].load, LoadCase::shaken);
  EXPECT_EQ(piece.frames[piece.shaken->last_frame + 1].load, LoadCase::pressed);
}

TEST(ActuatedDesign, WeightHasNoPartInThePath) {
  const ActuatedDesign light = actuate(dome(0.3), 0.3);
  Design heavy = dome(0.3);
  heavy.parameters.gravity = "resting";
  heavy.parameters.density = 8;
  const ActuatedDesign resting = actuate(heavy, 0.3);
  ASSERT_EQ(resting.frames.size(), light.frames.size());
  EXPECT_EQ(resting.frames.back().tiles, light.frames.back().tiles);
}

TEST(ActuatedDesign, IsTheSameWithAnyNumberOfThreads) {
  std::vector<ActuatedDesign> pieces;
  for (int threads : {1, 2, 4}) {
    set_thread_count(threads);
    pieces.push_back(actuate(dome(0.3), 0.3));
  }
  set_thread_count(1);
  ASSERT_GT(pieces[0].frames.size(), 5u);
  for (const ActuatedDesign& other : pieces) {
    ASSERT_EQ(other.frames.size(), pieces[0].frames.size());
    for (std::size_t k = 0; k < other.frames.size(); ++k) {
      EXPECT_EQ(other.frames[k].tiles, pieces[0].frames[k].tiles);
    }
  }
}

TEST(ActuatedDesign, StoppedItKeepsThePathSoFar) {
  for (const std::string last : {"releasing", "shaking", "pressing"}) {
    const ActuatedDesign piece = actuate_design(
        dome(0.3), {},
        [&](const std::string& what, double fraction) { return what != last || !(fraction > 0); });
    EXPECT_TRUE(piece.stopped);
    EXPECT_TRUE(piece.relaxed);
    EXPECT_GE(piece.frames.size(), 1u);
    EXPECT_EQ(piece.released.has_value(), last != "releasing");
    EXPECT_EQ(piece.shaken.has_value(), last == "pressing");
    EXPECT_FALSE(piece.pressed);
  }
}

TEST(ActuatedDesign, StoppedBeforeItHasRelaxedItHasNoAnswer) {
  EXPECT_THROW(actuate_design(dome(0.3), {},
                              [](const std::string& what, double) { return what != "relaxing"; }),
               Cancelled);
}

TEST(ActuatedDesign, RelaxedItStoresLessThanAnywhereNear) {
  const Design design = dome(0.5);
  const TileBodies bodies = make_tile_bodies(design);
  const SolvedDesign solved = solve_design(bodies.geometry, design, {});
  TileWorld world = make_tile_world(bodies, solved);
  const double at_target = world.world->energy();
  Path path(bodies, world, design.mesh, 0.5, {});
  const RestState state = path.relax(nullptr);
  ASSERT_TRUE(state.at_rest);
  EXPECT_LT(state.energy, at_target);
  const Poses rest = world.world->poses();
  for (int seed = 0; seed < 8; ++seed) {
    std::srand(seed);
    for (double size : {1e-3, 1e-2}) {
      world.world->set_poses(moved(rest, size * Motions::Random(rest.size(), 6), 3));
      EXPECT_GT(world.world->energy(), state.energy);
    }
  }
}

TEST(ActuatedDesign, DistancesAreToTheWantedTarget) {
  Design design = strip(10, 30, 0.3);
  design.target = design.mesh;
  design.target->V *= 1.05;
  const ActuatedDesign piece = actuate(design, 0.3);
  EXPECT_GT(piece.relaxed->scan.mean, 0.2);
}

TEST(ActuatedDesign, ItsSpreadHoldsRelaxedAndShaken) {
  const ActuatedDesign piece = actuate(dome(0.3), 0.3);
  ASSERT_TRUE(piece.spread);
  for (double mean : {piece.relaxed->scan.mean, piece.shaken->scan.mean}) {
    EXPECT_LE((*piece.spread)[0], mean);
    EXPECT_GE((*piece.spread)[1], mean);
  }
}

TEST(ActuatedDesign, SaysWhatDidNotComeToRest) {
  PathOptions options;
  options.max_steps = 3;
  const ActuatedDesign piece = actuate(dome(0.3), 0.3, options);
  EXPECT_FALSE(piece.stopped);
  EXPECT_FALSE(piece.released->at_rest);
  EXPECT_EQ(piece.released->steps, 3);
}

TEST(ActuatedDesign, KeepsFramesEvenlyAlongAPathWithoutRoomForAll) {
  PathOptions options;
  options.most_frames = 6;
  const ActuatedDesign piece = actuate(dome(0.3), 0.3, options);
  const int count = piece.released->last_frame + 1;
  const double whole = piece.frames[count - 1].moved;
  EXPECT_GT(piece.released->steps, 2 * options.most_frames);
  EXPECT_GE(count, options.most_frames / 2);
  EXPECT_LE(count, 2 * options.most_frames);
  for (int k = 1; k < count; ++k) {
    EXPECT_LT(piece.frames[k].moved - piece.frames[k - 1].moved, 3 * whole / (count - 1));
  }
}

}  // namespace
}  // namespace curveups::test
