// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "curveups/core/errors.hpp"
#include "curveups/design/parameters.hpp"

namespace curveups {
namespace {

TEST(Parameters, EveryRowIsCompleteAndItsDefaultInRange) {
  std::set<std::string_view> names;
  Parameters p;
  for (const ParameterInfo& info : parameter_table()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_FALSE(info.meaning.empty());
    EXPECT_FALSE(info.group.empty());
    EXPECT_NO_THROW(set_parameter(p, info.name, get_parameter(p, info.name))) << info.name;
  }
  EXPECT_NO_THROW(check_parameters(p));
}

TEST(Parameters, SwitchesOfStagesHaveShortNames) {
  Parameters p;
  set_parameter(p, "verify", false);
  set_parameter(p, "repair", false);
  set_parameter(p, "settle", false);
  EXPECT_FALSE(p.run_verification || p.run_repair || p.run_settling);
  EXPECT_FALSE(std::get<bool>(get_parameter(p, "verify")));
  for (const ParameterInfo& info : parameter_table()) {
    EXPECT_EQ(find_parameter(info.name), &info) << "an alias hides " << info.name;
  }
}

TEST(Parameters, ListsOfTilesAreReadAsReportsNameThem) {
  EXPECT_EQ(listed_tiles("T00012, T00001,T00012 T2493"), (std::vector<int>{0, 11, 2492}));
  EXPECT_TRUE(listed_tiles("").empty());
  Parameters p;
  for (const char* wrong : {"12", "T0", "T", "T1x", "T-3", "T99999999999", "t5"}) {
    EXPECT_THROW(set_parameter(p, "held_tiles", std::string(wrong)), InvalidInput) << wrong;
  }
  EXPECT_THROW(set_parameter(p, "held_tiles", 3.0), InvalidInput);
  EXPECT_EQ(p.held_tiles, "");
}

TEST(Parameters, TextsAreReadAsValues) {
  Parameters p;
  set_parameter(p, "H_body", std::string("2.5"));
  set_parameter(p, "flip", std::string("on"));
  set_parameter(p, "support", std::string("none"));
  EXPECT_EQ(p.H_body, 2.5);
  EXPECT_TRUE(p.flip);
  EXPECT_EQ(p.support, "none");
}

TEST(Parameters, RefusalsNameTheParameterAndLeaveAllAsItWas) {
  Parameters p;
  const std::vector<std::pair<std::string, ParameterValue>> bad = {
      {"H_body", -1.0},       {"H_body", std::string("3mm")},   {"H_body", std::nan("")},
      {"H_body", true},       {"support", std::string("glue")}, {"flip", std::string("2")},
      {"L", std::string("")}, {"L", std::string("inf")},        {"tau", 1e300},
      {"support", 1.0}};
  for (const auto& [name, value] : bad) {
    try {
      set_parameter(p, name, value);
      ADD_FAILURE() << name;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
      EXPECT_FALSE(error.remedy().empty());
    }
  }
  EXPECT_EQ(p.H_body, Parameters().H_body);
}

TEST(Parameters, ContradictionsAreRefused) {
  auto contradicts = [](const char* name, const ParameterValue& value) {
    Parameters p;
    set_parameter(p, name, value);
    EXPECT_THROW(check_parameters(p), InvalidInput) << name;
  };
  contradicts("p_min", 3.5);
  contradicts("A_pin_floor", 5.0);
  contradicts("bump_height", 1.2);
  contradicts("orientation", std::string("front-down"));
}

}  // namespace
}  // namespace curveups
