// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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

ActuatedDesign rise(Design design, double friction, bool answers = false) {
  design.parameters.mesh_size = 2;
  design.parameters.bumps = "none";
  design.parameters.friction_coefficient = friction;
  ActuationOptions options;
  options.answers = answers;
  return actuate_design(design, options, {});
}

Vec3 normal_of(const Points3& corners, int tile) {
  const Vec3 a = corners.row(3 * tile), b = corners.row(3 * tile + 1),
             c = corners.row(3 * tile + 2);
  return (b - a).cross(c - a).normalized();
}

TEST(ActuatedDesign, AStripOfTenTilesClosesToItsFolds) {
  const double radius = 30, turn = 0.3;
  const ActuatedDesign found = rise(strip(10, radius, turn), 0);
  ASSERT_TRUE(found.end.at_rest);
  EXPECT_TRUE(found.end.open_contacts.empty());
  // Neighbours of an antiprism's wall: their normals, by the chord of half a turn.
  const Vec3 a(radius * std::sin(0.0), 0, radius),
      b(radius * std::sin(turn), 0, radius * std::cos(turn)),
      c(radius * std::sin(turn / 2), 6, radius * std::cos(turn / 2)),
      d(radius * std::sin(1.5 * turn), 6, radius * std::cos(1.5 * turn));
  const double fold =
      std::acos((b - a).cross(c - a).normalized().dot((c - d).cross(b - d).normalized()));
  for (int i = 0; i + 1 < 10; ++i) {
    EXPECT_NEAR(std::acos(normal_of(found.corners, i).dot(normal_of(found.corners, i + 1))), fold,
                0.005)
        << i;
  }
}

TEST(ActuatedDesign, ARingOfTilesClosesToItsPyramid) {
  const double height = 2;
  const ActuatedDesign found = rise(pyramid(height), 0);
  ASSERT_TRUE(found.end.at_rest);
  EXPECT_TRUE(*found.arrives) << found.end.shortfall;
  const double slope = std::atan(height / (7 * std::cos(pi / 6)));
  Vec3 axis = Vec3::Zero();
  for (int i = 0; i < 6; ++i) axis += normal_of(found.corners, i) / 6;
  // Without friction, neighbours may lean by turns: their walls stay closed. The mean may not.
  double mean = 0;
  for (int i = 0; i < 6; ++i) {
    const double own = std::acos(normal_of(found.corners, i).dot(axis.normalized()));
    EXPECT_NEAR(own, slope, 0.01);
    mean += own / 6;
  }
  EXPECT_NEAR(mean, slope, 0.002);
}

TEST(ActuatedDesign, EnergyFallsAndFrictionTakes) {
  for (double friction : {0.0, 0.3}) {
    const ActuatedDesign found = rise(dome(friction), friction);
    ASSERT_GT(found.path.frames.size(), 10u);
    EXPECT_LE(found.path.largest_rise, 1e-9 * found.path.frames[0].energy);
    // Between steps contact points move.
    EXPECT_LT(found.path.found_anew, 0.05 * found.path.frames[0].energy);
    for (std::size_t k = 1; k < found.path.frames.size(); ++k) {
      const PathFrame &before = found.path.frames[k - 1], &now = found.path.frames[k];
      EXPECT_LT(now.energy, before.energy + 1e-3 * found.path.frames[0].energy);
      EXPECT_GE(now.friction, before.friction);
      EXPECT_LT(now.stretch, 1.0001 * found.path.frames[0].stretch);
    }
    EXPECT_EQ(found.path.frames.back().friction > 0, friction > 0);
    // Drag and friction together take what is lost.
    EXPECT_LE(found.path.frames.back().friction,
              found.path.frames[0].energy - found.path.frames.back().energy);
  }
}

TEST(ActuatedDesign, NoTilePassesThroughAnother) {
  const Design design = dome(0.3);
  const ActuatedDesign found = rise(design, 0.3);
  const TileBodies bodies = make_tile_bodies(design);
  const TileMesh& tiles = bodies.geometry.tiles;
  double tile = 0, largest = 0;
  for (const FrameRows& rows : found.frames) {
    std::vector<ConvexBody> placed;
    const auto motions = frame_motions(rows, tiles.tile_count());
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
  EXPECT_LT(found.path.deepest, 0.06);
  EXPECT_LT(largest, 0.02);
}

TEST(ActuatedDesign, FromTheTargetAtFrictionItStays) {
  const Design design = dome(0.5);
  ActuationOptions options;
  options.start = FrameRows::Zero(design.T.rows(), 7);
  options.start->col(3).setOnes();
  const ActuatedDesign found = actuate_design(design, options, {});
  ASSERT_TRUE(found.arrives);
  EXPECT_TRUE(*found.arrives) << found.end.shortfall;
  EXPECT_NEAR(found.end.energy, found.from_target.energy, 1e-6 * found.end.energy);
  EXPECT_FALSE(found.trap);
  EXPECT_TRUE(found.sampled.empty());
}

// The lowest corner of all tiles in a frame, mm.
double lowest(const TileBodies& bodies, const FrameRows& rows) {
  const TileMesh& tiles = bodies.geometry.tiles;
  const auto motions = frame_motions(rows, tiles.tile_count());
  double out = std::numeric_limits<double>::infinity();
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int c = 0; c < 3; ++c) {
      for (Side side : {Side::front, Side::back}) {
        const Vec2& p = tiles.corners(i, side)[c];
        const Vec3 corner(p.x(), p.y(), side == Side::front ? 0 : -tiles.H_body);
        out = std::min(out, motions[i](tiles.frame[i](corner)).z());
      }
    }
  }
  return out;
}

TEST(ActuatedDesign, ARestingPieceIsOnItsTableAllTheWay) {
  Design design = dome(0.3);
  design.parameters.gravity = "resting";
  design.parameters.density = 8;
  ActuationOptions options;
  options.answers = false;
  const ActuatedDesign found = actuate_design(design, options, {});
  ASSERT_TRUE(found.end.at_rest);
  const TileBodies bodies = make_tile_bodies(design);
  FrameRows still = FrameRows::Zero(design.T.rows(), 7);
  still.col(3).setOnes();
  const double table = lowest(bodies, still);
  // Corners are cut off where tiles would meet: the piece stands a little higher than this.
  for (const FrameRows& rows : found.frames) EXPECT_NEAR(lowest(bodies, rows), table, 0.3);
  EXPECT_NEAR(lowest(bodies, found.frames.back()), table, 0.05);
}

TEST(ActuatedDesign, AnswersAreThoseOfThePathsThatTheyName) {
  const double own = 0.4;
  const ActuatedDesign found = rise(dome(own), own, true);
  ASSERT_GE(found.sampled.size(), 2u);
  EXPECT_EQ(found.sampled.front().friction_coefficient, 0);
  EXPECT_EQ(found.sampled.back().friction_coefficient, own);
  EXPECT_EQ(found.sampled.back().energy, found.end.energy);
  double reach = -1;
  for (const PathEnd& end : found.sampled) {
    if (end.at_rest && found.has_arrived(end)) reach = end.friction_coefficient;
  }
  EXPECT_EQ(found.reach_friction.value_or(-1), reach);
  // Between the two are samples where friction may be what keeps it from arriving.
  const bool may_arrive =
      found.sampled.front().open_contacts.empty() || !found.sampled.front().at_rest;
  EXPECT_EQ(found.sampled.size(), may_arrive && !found.has_arrived(found.end) ? 5u : 2u);
  ASSERT_TRUE(found.arrives);
  EXPECT_EQ(*found.arrives, found.has_arrived(found.end));
  const PathEnd &a = found.sampled.front(), &b = found.frictionless_from_target;
  ASSERT_TRUE(a.at_rest && b.at_rest && found.from_target.at_rest);
  EXPECT_LT(found.from_target.shortfall, 1e-9);
  ASSERT_TRUE(found.trap);
  if (!*found.trap) {
    EXPECT_NEAR(a.energy, b.energy, 1e-3 * b.energy);
    EXPECT_LE(found.trap_distance, found.tolerance);
  }
}

TEST(ActuatedDesign, WedgedTilesAreNoNeighbours) {
  const Design design = dome(0.4);
  const ActuatedDesign found = rise(design, 0.4);
  const TileBodies bodies = make_tile_bodies(design);
  for (const Contact& contact : bodies.geometry.tiles.contacts) {
    for (const std::array<int, 2>& pair : found.end.wedged) EXPECT_NE(pair, contact.tile);
  }
}

TEST(ActuatedDesign, IsTheSameWithAnyNumberOfThreads) {
  std::vector<ActuatedDesign> found;
  for (int threads : {1, 2, 4}) {
    set_thread_count(threads);
    found.push_back(rise(dome(0.3), 0.3));
  }
  set_thread_count(1);
  ASSERT_GT(found[0].frames.size(), 5u);
  for (const ActuatedDesign& other : found) {
    ASSERT_EQ(other.frames.size(), found[0].frames.size());
    for (std::size_t k = 0; k < other.frames.size(); ++k) {
      EXPECT_EQ(other.frames[k], found[0].frames[k]);
    }
  }
}

TEST(ActuatedDesign, StoppedItKeepsThePathSoFar) {
  ActuationOptions options;
  bool moving = false;
  const ActuatedDesign found =
      actuate_design(dome(0.3), options, [&](const std::string& what, double fraction) {
        moving = moving || (what == "actuate" && fraction > 0);
        return !moving;
      });
  EXPECT_TRUE(found.path.stopped);
  EXPECT_GE(found.frames.size(), 1u);
  EXPECT_FALSE(found.arrives);
  EXPECT_FALSE(found.trap);
  EXPECT_TRUE(found.sampled.empty());
}

// Stopped when it has reported so often that tiles move.
ActuatedDesign stopped_path(const Design& design, const ActuationOptions& options, int reports) {
  return actuate_design(design, options, [&](const std::string& what, double fraction) {
    reports -= what == "actuate" && fraction > 0;
    return reports > 0;
  });
}

TEST(ActuatedDesign, APathGoesOnAsItWouldHave) {
  for (double friction : {0.05, 0.3}) {
    const Design design = dome(friction);
    ActuationOptions whole;
    whole.answers = false;
    const ActuatedDesign expected = actuate_design(design, whole, {});
    ASSERT_TRUE(expected.end.at_rest);
    for (int reports : {1, 5, 11}) {
      const ActuatedDesign first = stopped_path(design, whole, reports);
      ASSERT_TRUE(first.path.stopped);
      ASSERT_LT(first.path.steps, expected.path.steps);
      ActuationOptions rest = whole;
      rest.start = first.frames.back();
      rest.memory = first.path.frames.back().memory;
      const ActuatedDesign found = actuate_design(design, rest, {});
      EXPECT_EQ(found.frames.back(), expected.frames.back()) << reports;
      EXPECT_EQ(found.end.energy, expected.end.energy);
      EXPECT_EQ(found.end.open_contacts, expected.end.open_contacts);
      EXPECT_EQ(found.path.steps + first.path.steps, expected.path.steps);
    }
  }
}

TEST(ActuatedDesign, APathGoesOnFromAnyFrameThatItCameBy) {
  const Design design = dome(0.6);
  ActuationOptions options;
  options.answers = false;
  const ActuatedDesign whole = actuate_design(design, options, {});
  const int steps = whole.path.steps;
  ASSERT_EQ(static_cast<int>(whole.frames.size()), steps + 1);  // all of them
  for (int k = 0; k < steps; k += std::max(1, steps / 6)) {
    options.start = whole.frames[k];
    options.memory = whole.path.frames[k].memory;
    const ActuatedDesign found = actuate_design(design, options, {});
    EXPECT_EQ(found.path.steps, steps - k);
    EXPECT_EQ(found.frames.back(), whole.frames.back()) << k;
    EXPECT_EQ(found.end.energy, whole.end.energy);
    // With another friction as well, it begins where the other came by.
    const ActuatedDesign slippery = actuate_design(dome(0.1), options, {});
    EXPECT_EQ(slippery.frames.front(), whole.frames[k]);
    if (2 * k < steps) {
      EXPECT_LT(slippery.path.frames.back().friction, found.path.frames.back().friction);
    }
  }
}

TEST(ActuatedDesign, MemoriesAreEvenlyAlongAPathThatHasNoRoomForAll) {
  const Design design = dome(0.3);
  ActuationOptions options;
  options.answers = false;
  options.path.most_remembered = 40'000;
  const std::vector<PathFrame> frames = actuate_design(design, options, {}).path.frames;
  const double whole = frames.back().moved;
  Eigen::Index numbers = 0;
  double before = 0, furthest = 0;
  int count = 0;
  for (const PathFrame& frame : frames) {
    if (frame.memory.size() == 0) continue;
    numbers += frame.memory.size();
    furthest = std::max(furthest, frame.moved - before);
    before = frame.moved;
    ++count;
  }
  EXPECT_LE(numbers, 40'000);
  EXPECT_GT(frames.front().memory.size(), 0);
  EXPECT_GT(frames.back().memory.size(), 0);
  EXPECT_GE(count, 4);
  EXPECT_LT(count, static_cast<int>(frames.size()) - 2);
  EXPECT_LT(furthest, 3 * whole / (count - 1));
}

TEST(ActuatedDesign, WhatJammedStaysWhereItIsWithItsMemory) {
  const Design design = dome(0.4);
  ActuationOptions options;
  options.answers = false;
  const ActuatedDesign jammed = actuate_design(design, options, {});
  options.start = jammed.frames.back();
  options.memory = jammed.path.frames.back().memory;
  const ActuatedDesign found = actuate_design(design, options, {});
  EXPECT_EQ(found.path.steps, 0);
  EXPECT_EQ(found.end.energy, jammed.end.energy);
  EXPECT_EQ(found.path.frames.back().memory, jammed.path.frames.back().memory);
  options.memory.reset();
  EXPECT_GT(actuate_design(design, options, {}).path.steps, 0);
}

TEST(ActuatedDesign, RefusesAMemoryThatIsNotOfTheFrame) {
  const Design design = dome(0.3);
  ActuationOptions options;
  options.answers = false;
  options.path.max_steps = 20;
  const ActuatedDesign first = actuate_design(design, options, {});
  const Eigen::VectorXd& whole = first.path.frames.back().memory;
  options.path.max_steps = 1;
  options.start = first.frames.back();
  auto refuses = [&](const Eigen::VectorXd& memory) {
    options.memory = memory;
    EXPECT_THROW(actuate_design(design, options, {}), InvalidInput);
  };
  refuses({});
  refuses(whole.head(whole.size() - 1));
  Eigen::VectorXd longer(whole.size() + 1);
  longer << whole, 0;
  refuses(longer);
  // Counts, indices and places that are none: every number in turn is another, here and there.
  int refused = 0, tried = 0;
  for (Eigen::Index k = 0; k < whole.size(); k += whole.size() / 25) {
    for (double other : {-1.0, 1e9, std::nan(""), 0.5, 1e300}) {
      Eigen::VectorXd memory = whole;
      memory(k) = other;
      options.memory = memory;
      ++tried;
      try {
        actuate_design(design, options, {});
      } catch (const InvalidInput&) {
        ++refused;
      } catch (const SolverFailure&) {
      }
    }
  }
  EXPECT_GT(refused, tried / 3);
  options.start->col(0).array() += 0.01;
  refuses(whole);
  options.start.reset();
  refuses(whole);
}

TEST(ActuatedDesign, WhatDidNotComeToRestHasNoAnswer) {
  ActuationOptions options;
  options.path.max_steps = 3;
  const ActuatedDesign found = actuate_design(dome(0.3), options, {});
  EXPECT_FALSE(found.end.at_rest);
  EXPECT_FALSE(found.arrives);
  EXPECT_FALSE(found.trap);
  EXPECT_FALSE(found.reach_friction);
}

TEST(ActuatedDesign, RefusesHandsThatHoldIt) {
  Design design = dome(0.3);
  design.parameters.gravity = "held";
  EXPECT_THROW(actuate_design(design, {}, {}), InvalidInput);
}

}  // namespace
}  // namespace curveups::test
