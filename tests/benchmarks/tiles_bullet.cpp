// SPDX-License-Identifier: LGPL-2.1-or-later
// A thousand tiles at rest by friction, without membranes, by this project's contact room and by
// Bullet, a rigid-body engine for games: seconds until forces balance at the penetration that the
// contact room has. One thread, the same bodies, weights, friction and start.
//
//   tiles_bullet [SECONDS]     after which a run of Bullet ends, by default 4
#include <btBulletDynamicsCommon.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>

#include "contact/blocks.hpp"
#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double side = 7, tile_thickness = 3;                // mm
constexpr std::array<double, 3> shares = {1e-1, 1e-2, 1e-3};  // of a tile's weight, left unbalanced
// Centres start nearer to the origin by this share: faces overlap by 0.0014 mm at most. Bullet
// takes faces that just touch for apart, and bodies would fall for some steps first.
constexpr double nearer = 2e-4;
constexpr int more_steps = 20;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Bodies with a weight of 1 N each, and the table last. Gravity is turned instead of the table.
struct Problem {
  std::vector<ConvexBody> shapes;
  Vec3 down = {0, 0, -1};
  double friction = 0.5;

  int tiles() const { return static_cast<int>(shapes.size()) - 1; }
  Vec3 centre(int k) const { return (k < tiles() ? 1 - nearer : 1) * centroid(shapes[k]); }
};

// Layers of triangular tiles with gaps of 0.3 mm, each layer displaced so that its tiles lie on
// several of the layer below. On a table that leans by 20 degrees it slides where friction is less
// than the tangent, 0.364, and else stands.
Problem heap(double friction) {
  Problem out;
  out.friction = friction;
  const double angle = 20 * pi / 180, height = side * std::sqrt(0.75);
  out.down = {std::sin(angle), 0, -std::cos(angle)};
  for (int layer = 0; layer < 6; ++layer) {
    const Vec2 shift(layer % 2 * side / 2, layer % 2 * height / 3);
    for (int k = 0; k < 40 * 40 * 2; ++k) {
      const int row = k / 80 - 20, column = k / 2 % 40 - 20;
      const Vec2 at = shift + Vec2(side * column + (row % 2 != 0) * side / 2, height * row);
      std::array<Vec2, 3> corners = {at, at + Vec2(side, 0), at + Vec2(side / 2, height)};
      if (k % 2) corners = {corners[1], at + Vec2(1.5 * side, height), corners[2]};
      const Vec2 middle = (corners[0] + corners[1] + corners[2]) / 3;
      if (std::abs(middle.x()) > 43 - 5 * layer || std::abs(middle.y()) > 38 - 5 * layer) continue;
      for (Vec2& corner : corners) corner = middle + 0.92 * (corner - middle);
      const double low = layer * tile_thickness;
      out.shapes.push_back(make_frustum(corners, low + tile_thickness, corners, low));
    }
  }
  out.shapes.push_back(test::box(200, 200, 10, {0, -5}));
  return out;
}

// A hundred semicircular arches of ten tiles side by side: they stand where a line of thrust fits
// into their thickness (tests/native/contact/test_arch.cpp), a tenth of the radius or so.
Problem vault(double thickness) {
  constexpr int arches = 100, stones = 10;
  Problem out;
  const double radius = side * stones / pi;
  auto corner = [&](int joint, double out_by) {
    const double angle = pi * joint / stones;
    return Vec2((radius + out_by) * Vec2(std::cos(angle), std::sin(angle)));
  };
  for (int k = 0; k < arches * stones; ++k) {
    const int joint = k % stones;
    const double h = thickness / 2;
    ConvexBody stone = test::prism(
        {corner(joint, -h), corner(joint, h), corner(joint + 1, h), corner(joint + 1, -h)}, side);
    const int arch = k / stones - arches / 2;
    for (Vec3& point : stone.points) point.y() += 8.0 * arch;
    for (BodyFace& face : stone.faces) {
      face.plane.offset = face.plane.normal.dot(stone.points[face.loop[0]]);
    }
    out.shapes.push_back(std::move(stone));
  }
  out.shapes.push_back(test::box(4 * radius, 16.0 * arches, 10, {0, -5}));
  return out;
}

struct Outcome {
  std::array<double, 3> seconds = {-1, -1, -1};  // to each of `shares`, of processor
  double wall = 0, processor = 0, left = 0;      // of the whole run; unbalanced at its end, N
  int steps = 0;
  double largest = 0, mean = 0;  // penetration at the points that penetrate, mm
  double drift = 0;              // how far a body has moved at most, mm
  double beyond_cone = 0;        // friction beyond Coulomb's cone at most, N
  double creep = 0;              // how far a body moves at most in `more_steps` more steps, mm
  bool fell = false;             // a body moved by 1 mm
};

double furthest(const Poses& from, const Poses& to) {
  double out = 0;
  for (std::size_t k = 0; k < from.size(); ++k) out = std::max(out, (to[k].t - from[k].t).norm());
  return out;
}

// By our own search of contacts, for both.
void measure(const std::vector<RigidBody>& bodies, const Poses& start, const Poses& poses,
             Outcome& out) {
  double sum = 0;
  int count = 0;
  out.largest = 0;
  for (const TouchingPair& pair : find_touching(bodies, poses, {}, {})) {
    for (const Touch& touch : pair.touches) {
      const RigidMotion &at = poses[pair.body[touch.of]], &other = poses[pair.body[1 - touch.of]];
      const double depth = -touch.gap(seen_from(other, at, touch.point));
      out.largest = std::max(out.largest, depth);
      if (depth > 0) sum += depth, ++count;
    }
  }
  out.mean = sum / std::max(count, 1);
  out.drift = furthest(start, poses);
  out.fell = out.drift > 1;
}

test::Scene make_scene(const Problem& problem) {
  test::Scene scene;
  scene.options.search.face_margin = 1e-3;
  scene.options.search.reach = 0.15;  // as near as Bullet looks
  for (int k = 0; k <= problem.tiles(); ++k) {
    scene.add(problem.shapes[k], k == problem.tiles());
    scene.poses[k].t = problem.centre(k);
    if (k < problem.tiles()) scene.load(k, problem.down);
  }
  return scene;
}

Outcome by_contact_room(const Problem& problem, double tolerance, double cone_tolerance) {
  test::Scene scene = make_scene(problem);
  scene.options.tolerance = tolerance;
  scene.options.cone_tolerance = cone_tolerance;
  const auto world = scene.world(problem.friction);
  Outcome out;
  const double wall = wall_seconds(), begun = processor_seconds();
  const StepReport last = world->settle(
      100, [&](const StepReport&) { return furthest(scene.poses, world->poses()) > 1; });
  out.processor = processor_seconds() - begun;
  out.wall = wall_seconds() - wall;
  out.left = last.residual;
  out.steps = world->steps();
  measure(world->bodies(), scene.poses, world->poses(), out);
  for (const TouchForce& force : world->forces()) {
    out.beyond_cone =
        std::max(out.beyond_cone, force.friction.norm() - problem.friction * force.push);
  }
  if (!out.fell) {
    const Poses before = world->poses();
    for (int k = 0; k < more_steps; ++k) world->step();
    out.creep = furthest(before, world->poses());
  }
  return out;
}

struct Setting {
  double steps_a_second;
  int iterations;
};

// Lengths are in tiles, gravity is 10: some 1 / 60 s is the step that Bullet is made for.
class BulletWorld {
 public:
  BulletWorld(const Problem& problem, const Setting& setting)
      : step_(1 / setting.steps_a_second),
        friction_(problem.friction),
        world_(&dispatcher_, &near_, &solver_, &configuration_) {
    world_.setGravity(btVector3(problem.down.x(), problem.down.y(), problem.down.z()) * gravity);
    world_.getDispatchInfo().m_enableSatConvex = true;
    btContactSolverInfo& info = world_.getSolverInfo();
    info.m_numIterations = setting.iterations;
    info.m_splitImpulsePenetrationThreshold = 0;
    info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS |
                         SOLVER_DISABLE_VELOCITY_DEPENDENT_FRICTION_DIRECTION |
                         SOLVER_ENABLE_FRICTION_DIRECTION_CACHING |
                         SOLVER_INTERLEAVE_CONTACT_AND_FRICTION_CONSTRAINTS;
    for (int k = 0; k <= problem.tiles(); ++k) add(problem, k);
  }
  ~BulletWorld() {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;

  // Returns what is left of a tile's weight, in the mean square: how its velocity changes.
  double step() {
    before_.clear();
    for (const auto& body : bodies_) before_.push_back(body->getLinearVelocity());
    const double begun = processor_seconds();
    world_.stepSimulation(step_, 0);
    seconds_ += processor_seconds() - begun;
    double sum = 0;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      sum += (bodies_[k]->getLinearVelocity() - before_[k]).length2();
    }
    return std::sqrt(sum / static_cast<double>(bodies_.size() - 1)) / (gravity * step_);
  }
  double seconds() const { return seconds_; }

  Poses poses() const {
    Poses out(bodies_.size());
    for (std::size_t k = 0; k < out.size(); ++k) {
      const btTransform& at = bodies_[k]->getWorldTransform();
      for (int r = 0; r < 3; ++r) {
        out[k].t[r] = side * at.getOrigin()[r];
        for (int c = 0; c < 3; ++c) out[k].R(r, c) = at.getBasis()[r][c];
      }
    }
    return out;
  }
  double beyond_cone() {
    double out = 0;
    for (int k = 0; k < dispatcher_.getNumManifolds(); ++k) {
      const btPersistentManifold* pair = dispatcher_.getManifoldByIndexInternal(k);
      for (int c = 0; c < pair->getNumContacts(); ++c) {
        const btManifoldPoint& point = pair->getContactPoint(c);
        const double along =
            std::hypot(point.m_appliedImpulseLateral1, point.m_appliedImpulseLateral2);
        out = std::max(out, along - friction_ * point.m_appliedImpulse);
      }
    }
    return out / (gravity * step_);
  }

 private:
  static constexpr double gravity = 10;

  void add(const Problem& problem, int k) {
    const Vec3 middle = centroid(problem.shapes[k]), at = problem.centre(k) / side;
    auto hull = std::make_unique<btConvexHullShape>();
    for (const Vec3& point : problem.shapes[k].points) {
      const Vec3 p = (point - middle) / side;
      hull->addPoint(btVector3(p.x(), p.y(), p.z()), false);
    }
    hull->recalcLocalAabb();
    hull->setMargin(0);
    hull->initializePolyhedralFeatures();
    const double mass = k < problem.tiles() ? 1 : 0;
    btVector3 inertia(0, 0, 0);
    if (mass > 0) hull->calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, hull.get(), inertia);
    info.m_startWorldTransform.setOrigin(btVector3(at.x(), at.y(), at.z()));
    info.m_friction = std::sqrt(problem.friction);  // of a pair: their product
    info.m_restitution = 0;
    auto body = std::make_unique<btRigidBody>(info);
    body->setCollisionFlags(body->getCollisionFlags() | btCollisionObject::CF_HAS_FRICTION_ANCHOR);
    body->setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(body.get());
    hulls_.push_back(std::move(hull));
    bodies_.push_back(std::move(body));
  }

  double step_, friction_, seconds_ = 0;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase near_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btConvexHullShape>> hulls_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<btVector3> before_;
};

// Until forces balance to the last of `shares`, with no more penetration than `own` has.
Outcome by_bullet(const Problem& problem, const Setting& setting, const Outcome& own,
                  double longest) {
  const test::Scene scene = make_scene(problem);
  BulletWorld world(problem, setting);
  Outcome out;
  const double wall = wall_seconds();
  double measuring = 0;
  while (out.seconds.back() < 0 && world.seconds() < longest && !out.fell) {
    out.left = world.step();
    ++out.steps;
    const double begun = wall_seconds();
    measure(scene.bodies, scene.poses, world.poses(), out);
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const bool good = out.left <= shares[k] && out.largest <= own.largest && out.mean <= own.mean;
      if (good && out.seconds[k] < 0) out.seconds[k] = world.seconds();
    }
    measuring += wall_seconds() - begun;
  }
  out.processor = world.seconds();
  out.wall = wall_seconds() - wall - measuring;
  out.beyond_cone = world.beyond_cone();
  const Poses before = world.poses();
  for (int k = 0; k < more_steps && !out.fell; ++k) world.step();
  out.creep = furthest(before, world.poses());
  return out;
}

void print(const std::string& name, const Outcome& out) {
  std::printf("%-24s %5d", name.c_str(), out.steps);
  for (const double seconds : out.seconds) {
    if (seconds < 0) {
      std::printf("      -");
    } else {
      std::printf(" %6.2f", seconds);
    }
  }
  std::printf(" %6.2f %6.2f %8.1e %8.1e %8.1e %8.1e %8.1e %8.1e %s\n", out.processor, out.wall,
              out.left, out.largest, out.mean, out.drift, out.creep, out.beyond_cone,
              out.fell ? "falls" : "stands");
  std::fflush(stdout);
}

void compare(const char* name, const Problem& problem, const Problem& falling, double longest) {
  std::printf("\n%s, %d tiles\n%-24s %5s %6s %6s %6s %6s %6s %8s %8s %8s %8s %8s %8s\n", name,
              problem.tiles(), "", "steps", "10 %", "1 %", "0.1 %", "all s", "wall", "left, N",
              "most, mm", "mean", "drift", "creep", "cone, N");
  const WorldOptions exact;
  Outcome own = by_contact_room(problem, exact.tolerance, exact.cone_tolerance);
  for (std::size_t k = 0; k < shares.size(); ++k) {
    own.seconds[k] = by_contact_room(problem, shares[k], shares[k]).processor;
  }
  print("contact room", own);
  for (const double steps : {60.0, 240.0}) {
    for (const int iterations : {10, 100, 1000}) {
      print("Bullet 1/" + std::to_string(std::lround(steps)) + " s, " + std::to_string(iterations),
            by_bullet(problem, {steps, iterations}, own, longest));
    }
  }
  print("must fall: contact room", by_contact_room(falling, shares.back(), shares.back()));
  print("must fall: Bullet", by_bullet(falling, {240, 100}, own, 10 * longest));
}

}  // namespace
}  // namespace curveups

int main(int count, char** values) {
  curveups::set_thread_count(1);
  const double longest = count > 1 ? std::atof(values[1]) : 4;
  std::printf("Bullet with numbers of %zu bits\n", 8 * sizeof(btScalar));
  try {
    using namespace curveups;
    compare("vault", vault(tile_thickness), vault(1.8), longest);
    compare("heap", heap(0.5), heap(0.3), longest);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
  return 0;
}
