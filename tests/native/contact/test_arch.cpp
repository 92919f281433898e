// SPDX-License-Identifier: LGPL-2.1-or-later
// A semicircular arch of stones beside a thrust-line program on the same joints (J. Heyman, The
// stone skeleton, 1966): which thrusts at the crown leave, at every joint, the resultant within the
// joint and within friction?
#include <cmath>

#include "contact/blocks.hpp"
#include "curveups/geometry/convex_polygon.hpp"

namespace curveups::test {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double radius = 100, depth = 20;

// Joint k of so many stones (even: there is a joint at the crown) from the right springing, k = 0
// to `stones`.
Vec2 on_joint(int stones, int k, double r) {
  const double angle = pi * k / stones;
  return {r * std::cos(angle), r * std::sin(angle)};
}

std::vector<Vec2> stone(int stones, int k, double thickness) {
  const double inner = radius - thickness / 2, outer = radius + thickness / 2;
  return {on_joint(stones, k, inner), on_joint(stones, k, outer), on_joint(stones, k + 1, outer),
          on_joint(stones, k + 1, inner)};
}

// True if a thrust exists: intersect the half-planes in which the crown's thrust H and moment M may
// lie.
bool thrust_line_exists(int stones, double thickness, double friction) {
  const double most = 1e3;
  Polygon region = {{0, -most}, {most, -most}, {most, most}, {0, most}};
  double weight = 0;
  Vec2 moment = Vec2::Zero();  // first moments of weights
  for (int k = stones / 2; k >= 0; --k) {
    // Loads on the part between the crown and joint k: weights, and the crown's H (to the right)
    // with M.
    const double angle = pi * k / stones;
    const Vec2 centre = on_joint(stones, k, radius);
    const Vec2 tangent(std::sin(angle), -std::cos(angle));  // into the next stone below
    const Vec2 outward(std::cos(angle), std::sin(angle));
    const double w_arm = moment.x() - weight * centre.x();  // sum w (x - centre.x)
    // Normal and shear are linear in H, the moment about the centre linear in H and M.
    auto keep = [&](double h, double m, double constant) {  // h H + m M + constant >= 0
      const Vec2 normal(-h, -m);
      if (normal.norm() > 0 && !region.empty()) {
        region = clip(region, normal / normal.norm(), constant / normal.norm());
      }
    };
    const double n_h = tangent.x(), n_0 = weight * -tangent.y();
    const double t_h = outward.x(), t_0 = weight * -outward.y();
    const double m_h = radius - centre.y(), m_0 = w_arm;
    for (double sign : {1.0, -1.0}) {
      keep(thickness / 2 * n_h + sign * m_h, sign, thickness / 2 * n_0 + sign * m_0);
      keep(friction * n_h + sign * t_h, 0, friction * n_0 + sign * t_0);
    }
    if (k > 0) {
      const ConvexBody body = prism(stone(stones, k - 1, thickness), depth);
      const double w = volume(body) * 1e-4;
      weight += w;
      moment += w * Vec2(centroid(body).x(), centroid(body).z());
    }
  }
  return region.size() >= 3;
}

bool arch_stands(int stones, double thickness, double friction) {
  Scene scene;
  const double inner = radius - thickness / 2, outer = radius + thickness / 2;
  for (double side : {1.0, -1.0}) {
    scene.add(box(outer - inner + 40, 2 * depth, 10, {side * radius, -5}), true);
  }
  for (int k = 0; k < stones; ++k) {
    const ConvexBody shape = prism(stone(stones, k, thickness), depth);
    const int body = scene.add(shape, false);
    scene.load(body, {0, 0, -1e-4 * volume(shape)});
  }
  auto world = scene.world(friction);
  const Poses start = world->poses();
  const auto falls = [&] {
    double most = 0;
    for (std::size_t i = 0; i < start.size(); ++i) {
      most = std::max(most, (world->poses()[i].t - start[i].t).norm());
    }
    return most > 3;
  };
  const bool at_rest = world->settle(100, [&](const StepReport&) { return falls(); }).at_rest;
  EXPECT_NE(at_rest, falls());
  return at_rest;
}

// The least value that `stands`, by halving.
double least(double low, double high, const std::function<bool(double)>& stands) {
  EXPECT_FALSE(stands(low));
  EXPECT_TRUE(stands(high));
  for (int k = 0; k < 40; ++k) {
    const double middle = 0.5 * (low + high);
    (stands(middle) ? high : low) = middle;
  }
  return high;
}

double least_thickness(int stones, double friction) {
  return least(5, 30, [&](double t) { return thrust_line_exists(stones, t, friction); });
}

class ArchOf : public testing::TestWithParam<int> {};

TEST_P(ArchOf, StonesIsAsThickAsTheThrustLineAsks) {
  const int stones = GetParam();
  const double friction = 0.8, thickness = least_thickness(stones, friction);
  EXPECT_TRUE(arch_stands(stones, 1.01 * thickness, friction));
  EXPECT_FALSE(arch_stands(stones, 0.99 * thickness, friction));
}

TEST_P(ArchOf, StonesNeedsTheFrictionOfTheThrustLine) {
  const int stones = GetParam();
  const double thickness = 25;
  const double friction =
      least(0.1, 0.8, [&](double mu) { return thrust_line_exists(stones, thickness, mu); });
  EXPECT_NEAR(friction, 0.31, 0.05);
  EXPECT_TRUE(arch_stands(stones, thickness, 1.01 * friction));
  EXPECT_FALSE(arch_stands(stones, thickness, 0.99 * friction));
}

INSTANTIATE_TEST_SUITE_P(Stones, ArchOf, testing::Values(8, 12, 20));

// J. Ochsendorf, 2006, after Milankovitch; hinges at few joints ask less.
TEST(Arch, OfManyStonesHasTheThicknessOfTheLiterature) {
  EXPECT_NEAR(least_thickness(400, 0.8) / radius, 0.1075, 0.0005);
  double before = 0;
  for (int stones : {8, 12, 20, 60}) {
    EXPECT_GT(least_thickness(stones, 0.8), before) << stones;
    before = least_thickness(stones, 0.8);
  }
}

}  // namespace
}  // namespace curveups::test
