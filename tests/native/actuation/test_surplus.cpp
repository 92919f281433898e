// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "curveups/actuation/actuated_design.hpp"
#include "curveups/actuation/surplus.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/physics/membrane_figures.hpp"
#include "support/designs.hpp"

namespace curveups::test {
namespace {

Design dome(double curvature = 0.02) {
  Parameters parameters;
  parameters.mesh_size = 2;
  parameters.bumps = "none";
  parameters.friction_coefficient = 0.3;
  parameters.thickness_back = 0.4;  // the sides differ
  SampleOptions o;
  o.rows = 2;
  o.columns = 3;
  o.kx = o.ky = curvature;
  return sample_design(parameters, o);
}

// The piece as the layout has it, with its surplus.
struct FlatWorld {
  TileBodies bodies;
  TileWorld world;
  Surplus surplus;
  int first;  // body of the surplus

  FlatWorld(const Design& design, std::array<bool, 2> held)
      : bodies(make_tile_bodies(design)),
        world(made(bodies, design)),
        surplus(bodies, static_cast<int>(world.world->bodies().size())),
        first(static_cast<int>(world.world->bodies().size())) {
    Poses poses = piece_poses(bodies, flat_tiles(bodies), world.world->poses());
    poses.insert(poses.end(), surplus.flat().begin(), surplus.flat().end());
    surplus.add_to(*world.world, held);
    world.world->set_poses(poses);
  }

  static TileWorld made(const TileBodies& bodies, const Design& design) {
    TileWorld out = make_tile_world(bodies, solve_design(bodies.geometry, design, {}),
                                    design.parameters.tile_modulus);
    for (PairLoads* corrections : out.corrections) corrections->loads.clear();
    return out;
  }
};

TEST(Surplus, OnBothRingsNothingPullsAnywhereAndNothingRises) {
  for (bool anchors : {true, false}) {
    Design design = dome();
    design.parameters.anchors = anchors;
    FlatWorld flat(design, {true, true});
    EXPECT_EQ(flat.surplus.anchor_count() > 0, anchors);
    const double tension = surplus_tension(design.parameters)[0];
    const Motions forces = flat.world.world->given_forces();
    ASSERT_EQ(forces.rows(), static_cast<Eigen::Index>(flat.world.world->bodies().size()));
    for (Eigen::Index i = 0; i < forces.rows(); ++i) {
      if (flat.world.world->bodies()[i].fixed) continue;
      EXPECT_LT(forces.row(i).norm(), 1e-9 * tension * design.parameters.L) << i;
    }
    const ActuationPath path = follow_path(flat.bodies, flat.world, {});
    EXPECT_TRUE(path.at_rest);
    EXPECT_EQ(path.steps, 0);
  }
}

TEST(Surplus, ARingHoldsTheTensionOfASheetThatIsStretchedAlike) {
  Design design = dome();
  design.parameters.tau = 1.7;
  const FlatWorld flat(design, {true, true});
  const Motions forces = flat.world.world->given_forces();
  const Poses& poses = flat.world.world->poses();
  const Vec2 window = flat.surplus.window();
  for (int s = 0; s < 2; ++s) {
    const double level =
        s == 0 ? design.parameters.H_pin : -design.parameters.H_body - design.parameters.H_pin;
    double right = 0;
    for (const RigidMotion& pose : poses) right = std::max(right, pose.t.x());
    double pull = 0;
    for (Eigen::Index i = flat.first; i < forces.rows(); ++i) {
      if (std::abs(poses[i].t.z() - level) < 1e-9 && std::abs(poses[i].t.x() - right) < 1e-9) {
        pull -= forces(i, 0);
      }
    }
    const double expected = surplus_tension(design.parameters)[s] * window.y();
    EXPECT_NEAR(pull, expected, 1e-3 * expected);  // the regularization is 2e-4 of the density
  }
}

TEST(Surplus, AFreeSheetPullsTheAnchorsInAndForcesSumToNothing) {
  FlatWorld flat(dome(), {false, true});
  const Motions forces = flat.world.world->given_forces();
  EXPECT_LT(forces.leftCols<3>().colwise().sum().norm(), 1e-9);
  ASSERT_FALSE(follow_path(flat.bodies, flat.world, {}).frames.empty());
  const Poses& poses = flat.world.world->poses();
  const Motions end = flat.world.world->given_forces();
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vec3 f = end.row(i).head<3>(), m = end.row(i).tail<3>();
    force += f;
    torque += m + poses[i].t.cross(f);
  }
  EXPECT_LT(force.norm(), 1e-9);
  EXPECT_LT(torque.norm(), 1e-7);  // arms of some 100 mm
  Vec3 middle = Vec3::Zero();
  for (int k = 0; k < flat.surplus.anchor_count(); ++k) {
    middle += flat.surplus.flat()[k].t / flat.surplus.anchor_count();
  }
  for (int k = 0; k < flat.surplus.anchor_count(); ++k) {
    EXPECT_LT((poses[flat.first + k].t - middle).head<2>().norm(),
              (flat.surplus.flat()[k].t - middle).head<2>().norm());
  }
}

ActuatedDesign released(const std::string& how, const Design& design = dome()) {
  ActuationOptions options;
  options.answers = false;
  options.release = how;
  return actuate_design(design, options, {});
}

TEST(Surplus, EveryReleaseEndsCutOutWithItsEnergyAccounted) {
  const std::vector<std::string> names[] = {{"both off", "cut out"},
                                            {"front off", "both off", "cut out"},
                                            {"back off", "both off", "cut out"}};
  int which = 0;
  for (const std::string how : {"together", "front-first", "back-first"}) {
    SCOPED_TRACE(how);
    const ActuatedDesign found = released(how);
    const std::vector<PathFrame>& frames = found.path.frames;
    ASSERT_EQ(found.phases.size(), names[which].size());
    const double start = frames[0].energy;
    EXPECT_LE(found.path.largest_rise, 1e-9 * start);
    EXPECT_GT(start, found.phases.front().end.energy);
    int steps = 0;
    for (std::size_t p = 0; p < found.phases.size(); ++p) {
      const PathPhase& phase = found.phases[p];
      EXPECT_EQ(phase.name, names[which][p]);
      EXPECT_TRUE(phase.end.at_rest);
      steps += phase.end.steps;
      const int begin = phase.first_frame;
      const int end = p + 1 < found.phases.size() ? found.phases[p + 1].first_frame
                                                  : static_cast<int>(frames.size());
      ASSERT_LT(begin + 1, end);
      EXPECT_EQ(frames[end - 1].energy, phase.end.energy);
      for (int k = begin + 1; k < end; ++k) {
        EXPECT_LT(frames[k].energy, frames[k - 1].energy + 1e-3 * start);
        EXPECT_GE(frames[k].friction, frames[k - 1].friction);
        EXPECT_GT(frames[k].time, frames[k - 1].time);
      }
      if (p == 0) continue;
      // Hands move nothing: they take off what the surplus stores, and that alone.
      EXPECT_EQ(found.frames[begin], found.frames[begin - 1]);
      EXPECT_DOUBLE_EQ(phase.removed, frames[begin - 1].energy - frames[begin].energy);
      if (phase.name == "cut out") {
        EXPECT_GT(phase.removed, 0.01 * start);
      } else {
        EXPECT_NEAR(phase.removed, 0, 1e-9 * start);
      }
    }
    EXPECT_EQ(steps, found.path.steps);
    EXPECT_EQ(found.end.energy, found.phases.back().end.energy);
    // The piece that is cut out stays where its path ended.
    ActuationOptions rest;
    rest.answers = false;
    rest.start = found.frames.back();
    rest.memory = found.path.frames.back().memory;
    EXPECT_EQ(actuate_design(dome(), rest, {}).path.steps, 0);
    ++which;
  }
}

// Mean, over contacts, of by how much neighbours' normals lean away from one another.
double bulge(const Design& design, const FrameRows& rows) {
  const TileBodies bodies = make_tile_bodies(design);
  const TileMesh& tiles = bodies.geometry.tiles;
  const Points3 centres = tile_centres(tiles);
  const auto motions = frame_motions(rows, tiles.tile_count());
  double sum = 0;
  for (const Contact& contact : tiles.contacts) {
    const auto [a, b] = contact.tile;
    const Vec3 way =
        motions[b](centres.row(b).transpose()) - motions[a](centres.row(a).transpose());
    sum += (motions[b].R * tiles.normal(b) - motions[a].R * tiles.normal(a)).dot(way.normalized());
  }
  return sum / static_cast<double>(tiles.contacts.size());
}

TEST(Surplus, ThePieceBendsAwayFromTheRingThatStillHolds) {
  const Design design = dome(0);
  for (const auto& [how, sign] : {std::pair("front-first", -1.0), std::pair("back-first", 1.0)}) {
    const ActuatedDesign found = released(how, design);
    ASSERT_EQ(found.phases.size(), 3u);
    const double bent = bulge(design, found.frames[found.phases[1].first_frame - 1]);
    EXPECT_GT(sign * bent, 0.01) << how;  // towards the sheet that is free to contract
  }
}

TEST(Surplus, APieceThatIsCutOutAtOnceHasOnePhaseAndNoSurplus) {
  const ActuatedDesign found = released("cut");
  EXPECT_FALSE(found.surplus);
  ASSERT_EQ(found.phases.size(), 1u);
  EXPECT_EQ(found.phases[0].removed, 0);
  EXPECT_LT(found.path.frames[0].energy, released("together").path.frames[0].energy);
}

TEST(Surplus, AReleaseIsTheSameWithAnyNumberOfThreads) {
  std::vector<ActuatedDesign> found;
  for (int threads : {1, 2}) {
    set_thread_count(threads);
    found.push_back(released("back-first"));
  }
  set_thread_count(1);
  ASSERT_EQ(found[0].frames.size(), found[1].frames.size());
  for (std::size_t k = 0; k < found[0].frames.size(); ++k) {
    EXPECT_EQ(found[0].frames[k], found[1].frames[k]);
  }
}

TEST(Surplus, StoppedOnItsRingsItKeepsThePathSoFarWithoutMemory) {
  ActuationOptions options;
  options.release = "back-first";
  int reports = 3;
  const ActuatedDesign found =
      actuate_design(dome(), options, [&](const std::string& what, double fraction) {
        EXPECT_LE(fraction, 1);
        reports -= what == "actuate" && fraction > 0;
        return reports > 0;
      });
  EXPECT_TRUE(found.path.stopped);
  ASSERT_EQ(found.phases.size(), 1u);
  EXPECT_EQ(found.phases[0].name, "back off");
  EXPECT_FALSE(found.phases[0].end.at_rest);
  EXPECT_GT(found.frames.size(), 1u);
  EXPECT_EQ(found.path.frames.back().memory.size(), 0);
  EXPECT_FALSE(found.arrives);
}

TEST(Surplus, RefusesWhatAReleaseCannotBe) {
  EXPECT_THROW(released("sideways"), InvalidInput);
  Design design = dome();
  design.parameters.gravity = "resting";
  EXPECT_THROW(released("together", design), InvalidInput);
  design = dome();
  ActuationOptions options;
  options.release = "together";
  options.start = FrameRows::Zero(design.T.rows(), 7);
  options.start->col(3).setOnes();
  EXPECT_THROW(actuate_design(design, options, {}), InvalidInput);
  design.T.row(0).array() += 1e5;  // and its tile with it
  EXPECT_THROW(released("together", design), InfeasibleDesign);
}

}  // namespace
}  // namespace curveups::test
