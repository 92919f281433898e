// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/core/errors.hpp"
#include "curveups/design/design_file.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

Design sample() {
  Design design;
  design.name = "d\"ome";
  design.parameters.H_body = 2.7;
  design.parameters.support = "breakaway";
  design.mesh = test::dome(3);
  const TileMesh tiles = make_tile_mesh(design.mesh, Edges(0, 2), 2.7);
  FlatPoses poses(tiles.tile_count(), 3);
  for (int i = 0; i < tiles.tile_count(); ++i) poses.row(i) << 1.1 * i, 0.3 * i, 0.7 * i;
  design.T = flat_corners(tiles, poses);
  design.q.setRandom(tiles.tile_count(), 6);
  const MeshEdge& edge = tiles.topology.edges[tiles.contacts[3].edge];
  design.cuts.resize(1, 2);
  design.cuts << edge.v[0], edge.v[1];
  return design;
}

TEST(DesignFile, RoundTripsBitForBit) {
  Design design = sample();
  design.target = test::saddle(3);
  const std::string text = write_design(design);
  const Design read = read_design(text);
  EXPECT_EQ(read.name, design.name);
  EXPECT_EQ(read.mesh.V, design.mesh.V);
  EXPECT_EQ(read.mesh.F, design.mesh.F);
  EXPECT_EQ(read.T, design.T);
  EXPECT_EQ(read.q, design.q);
  EXPECT_EQ(read.cuts, design.cuts);
  ASSERT_TRUE(read.target.has_value());
  EXPECT_EQ(read.target->V, design.target->V);
  EXPECT_EQ(read.parameters.H_body, 2.7);
  EXPECT_EQ(read.parameters.support, "breakaway");
  EXPECT_EQ(write_design(read), text);
}

// Replaces the first occurrence of a text.
std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(DesignFile, NamesTheFieldThatIsBroken) {
  const std::string text = write_design(sample());
  const std::string first_face = "\"F\": [[0,1,4]";
  const std::vector<std::pair<std::string, std::string>> broken = {
      {text.substr(0, text.size() / 2), "not JSON"},
      {"[1, 2]", "not a JSON object"},
      {with(text, "curveups-design", "something"), "\"format\""},
      {with(text, "\"version\": 1", "\"version\": 2"), "\"version\""},
      {with(text, "\"q\":", "\"p\":"), "\"q\""},
      {with(text, first_face, "\"F\": [[0,1,99]"), "\"F\"[0]"},
      {with(text, first_face, "\"F\": [[0,1,-4]"), "\"F\"[0]"},
      {with(text, first_face, "\"F\": [[0,1.5,4]"), "\"F\"[0]"},
      {with(text, first_face, "\"F\": [[0,1]"), "\"F\"[0]"},
      {with(text, "\"T\": [[[", "\"T\": [[[[1,2],"), "\"T\"[0]"},
      {with(text, "\"V\": [[", "\"V\": [[null,"), "\"V\"[0]"},
      {with(text, "\"V\": [[", "\"V\": [[1e400,"), "JSON"},
      {with(text, "\"cuts\": [[", "\"cuts\": [[77,"), "\"cuts\""},
      {with(text, "\"H_body\":2.7", "\"H_body\":-2"), "H_body"},
      {with(text, "\"H_body\":2.7", "\"H_bodi\":2"), "H_bodi"},
      {with(text, "\"H_body\":2.7", "\"H_body\":[2]"), "H_body"},
      {with(text, "\"p_max\":3", "\"p_max\":0.1"), "p_min"},
  };
  for (const auto& [bad, name] : broken) {
    try {
      read_design(bad);
      ADD_FAILURE() << "accepted a file broken at " << name;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos)
          << error.what() << " does not name " << name;
      EXPECT_FALSE(error.remedy().empty());
    }
  }
}

TEST(DesignFile, RefusesTilesThatAreNotCongruent) {
  Design design = sample();
  design.T(2, 0) += 0.01;
  EXPECT_THROW(read_design(write_design(design)), InvalidInput);
  // Turned over: congruent, but clockwise.
  design = sample();
  for (int c : {1, 3, 5}) design.T(2, c) *= -1;
  EXPECT_THROW(read_design(write_design(design)), InvalidInput);
}

TEST(DesignFile, RefusesCoordinatesInAnotherUnitThanL) {
  for (const double factor : {1000.0, 0.001}) {
    Design design = sample();
    design.mesh.V *= factor;
    design.T *= factor;
    try {
      read_design(write_design(design));
      ADD_FAILURE() << "accepted coordinates times " << factor;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find("parameter L"), std::string::npos) << error.what();
    }
  }
}

TEST(DesignArrays, RefusesWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (Array6 Design::*member : {&Design::T, &Design::q}) {
    Design design = sample();
    (design.*member)(1, 2) = nan;
    EXPECT_THROW(require_fitting_arrays(design), InvalidInput);
  }
  Design design = sample();
  design.mesh.V(0, 0) = nan;
  EXPECT_THROW(require_fitting_arrays(design), InvalidInput);
  EXPECT_NO_THROW(require_fitting_arrays(sample()));
}

}  // namespace
}  // namespace curveups
