// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/physics/margin.hpp"
#include "support/designs.hpp"

namespace curveups::test {
namespace {

Margin margin_of(Parameters parameters) {
  const Design design = sample_design(parameters);
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  return find_margin(solve_design(geometry, design, {}), geometry, {});
}

TEST(Margin, SaysWhichMembraneIsTooStrongAtWhichFriction) {
  Parameters parameters;
  parameters.mesh_size = 2;
  parameters.friction_coefficient = 1;
  parameters.margin = "require";
  parameters.margin_friction = 1;
  parameters.margin_mismatch = 0;
  const Margin met = margin_of(parameters);
  EXPECT_EQ(met.met, std::optional<bool>(true));
  EXPECT_FALSE(met.failure[0] || met.failure[1]);

  parameters.margin_friction = 0.01;
  const Margin failed = margin_of(parameters);
  EXPECT_EQ(failed.met, std::optional<bool>(false));
  for (int s = 0; s < 2; ++s) {
    ASSERT_TRUE(failed.failure[s]);
    EXPECT_EQ(std::get<std::string>(failed.failure[s]->figures.at("side")),
              s == 0 ? "front" : "back");
    EXPECT_EQ(std::get<double>(failed.failure[s]->figures.at("mu")), 0.01);
    EXPECT_FALSE(failed.failure[s]->tiles.empty());
  }

  parameters.margin = "off";
  EXPECT_FALSE(margin_of(parameters).met.has_value());
}

// A membrane that is stronger by its thickness pulls as the margin says that it does.
TEST(Margin, AgreesWithADesignOfAThickerMembrane) {
  Parameters parameters;
  parameters.mesh_size = 2;
  parameters.margin_friction = 0.3;
  parameters.f_min_ratio = 1;  // fails, and names its least force
  std::array<double, 2> floor;
  for (const bool thick : {false, true}) {
    parameters.margin_mismatch = thick ? 0 : 50;
    if (thick) parameters.thickness_front *= 1.5;
    floor[thick] = std::get<double>(margin_of(parameters).failure[0].value().figures.at("least"));
  }
  EXPECT_GT(std::abs(floor[0]), 0.01);
  EXPECT_NEAR(floor[0], floor[1], 2e-3 * std::abs(floor[0]) + 2e-4);
}

}  // namespace
}  // namespace curveups::test
