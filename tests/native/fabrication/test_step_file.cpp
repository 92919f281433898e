// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <set>

#include "curveups/core/errors.hpp"
#include "curveups/fabrication/file_formats.hpp"
#include "curveups/fabrication/print_files.hpp"
#include "curveups/fabrication/step_text.hpp"
#include "support/designs.hpp"

namespace curveups {
namespace {

// The entities of a file by number, and those that one leads to.
class Entities {
 public:
  explicit Entities(const std::string& path) {
    std::ifstream file(path);
    for (std::string entity; std::getline(file, entity, ';');) {
      const std::size_t at = entity.find('#');
      if (at == std::string::npos) continue;
      std::string& text = text_[std::stoi(entity.substr(at + 1))];
      bool quoted = false;
      for (char c : entity.substr(entity.find('=') + 1)) {
        if ((c > ' ' || quoted) && !(c == '(' && text.empty()))
          text += c;  // first part of complex ones
        quoted = quoted != (c == '\'');
      }
    }
  }
  std::vector<int> named(const std::string& keyword) const {
    std::vector<int> found;
    for (const auto& [id, text] : text_) {
      if (text.rfind(keyword + "(", 0) == 0) found.push_back(id);
    }
    return found;
  }
  std::vector<int> references(int id) const {
    std::vector<int> found;
    const std::string& text = text_.at(id);
    for (std::size_t at = 0; (at = text.find('#', at)) != std::string::npos; ++at) {
      found.push_back(std::stoi(text.substr(at + 1)));
    }
    return found;
  }
  // Contexts of the two representations of a relation with a transformation.
  std::set<int> contexts(int relation) const {
    const std::vector<int> related = references(relation);
    return {references(related[0]).back(), references(related[1]).back()};
  }
  // Quoted strings of an entity, with their quotes.
  std::vector<std::string> strings(int id) const {
    std::vector<std::string> found;
    const std::string& text = text_.at(id);
    for (std::size_t at = 0; (at = text.find('\'', at)) != std::string::npos;) {
      const std::size_t begin = at++;
      while (text[at] != '\'' || text[at + 1] == '\'') at += text[at] == '\'' ? 2 : 1;
      found.push_back(text.substr(begin, ++at - begin));
    }
    return found;
  }
  // Red, green and blue of the colour that an entity leads to.
  std::vector<double> colour(int id) const {
    const std::string& text = text_.at(id);
    if (text.rfind("COLOUR_RGB(", 0) != 0) return colour(references(id).at(0));
    std::istringstream numbers(text.substr(text.find(',')));
    std::vector<double> found(3);
    char comma;
    for (double& value : found) numbers >> comma >> value;
    return found;
  }
  std::set<int> edges(int id) const {
    if (text_.at(id).rfind("EDGE_CURVE(", 0) == 0) return {id};
    std::set<int> found;
    for (int part : references(id)) found.merge(edges(part));
    return found;
  }

 private:
  std::map<int, std::string> text_;
};

class StepFile : public ::testing::Test {
 protected:
  void SetUp() override {
    char folder[] = "/tmp/curveups-step-XXXXXX";
    ASSERT_NE(mkdtemp(folder), nullptr);
    folder_ = folder;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path() const { return (folder_ / "a.step").string(); }

  // Every body as a product and a coloured solid of its name, in their order, below the title.
  void expect_bodies(const std::vector<const PrintBody*>& bodies, const std::string& title) const {
    const Entities entities(path());
    std::vector<std::string> names{step_string(title)}, products, solids;
    for (const PrintBody* body : bodies) names.push_back(step_string(body->name));
    for (int id : entities.named("PRODUCT")) products.push_back(entities.strings(id).at(1));
    EXPECT_EQ(products, names);
    const std::vector<int> styled = entities.named("STYLED_ITEM");
    ASSERT_EQ(styled.size(), bodies.size());
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      SCOPED_TRACE(bodies[k]->name);
      const std::vector<int> parts = entities.references(styled[k]);
      EXPECT_EQ(entities.strings(parts.back()).at(0), names[k + 1]);
      const Colour c = body_colour(bodies[k]->kind);
      const std::vector<double> colour{c.red / 255.0, c.green / 255.0, c.blue / 255.0};
      EXPECT_EQ(entities.colour(parts.front()), colour);
    }
  }

  std::filesystem::path folder_;
};

TEST_F(StepFile, HoldsStitchingHolesAsCylinders) {
  Parameters p;
  p.joint = "holes";
  test::SampleOptions o;
  o.rows = 2;
  o.columns = 4;
  o.cuts.resize(2, 2);
  o.cuts << 2, 7, 7, 12;
  o.piece_offset = 40;
  const PrintModel model = make_print_model(test::sample_design(p, o));
  ASSERT_TRUE(model.joints.closed.empty());
  for (const char* kind : {"tiles", "actuated"}) {
    write_step(model, kind, path());
    expect_bodies(model.bodies(kind), std::string("sample-") + kind);
    std::ifstream in(path());
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find("CYLINDRICAL_SURFACE", at)) != text.npos; ++at)
      ++found;
    EXPECT_EQ(found, 4u);  // two edges, a hole on either side
  }
}

TEST_F(StepFile, HoldsEveryBodyByNameAndColourWithItsVolume) {
  for (const char* bumps : {"bumps", "dimples"}) {
    for (const char* support : {"soluble", "breakaway"}) {
      Parameters p;
      p.bumps = bumps;
      p.support = support;
      test::SampleOptions o;
      o.rows = o.columns = 2;
      const PrintModel model = make_print_model(test::sample_design(p, o));
      for (const char* kind : {"tiles", "support", "anchors", "print", "actuated"}) {
        SCOPED_TRACE(std::string(bumps) + " " + support + " " + kind);
        testing::internal::CaptureStdout();
        write_step(model, kind, path());
        EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
        expect_bodies(model.bodies(kind), std::string("sample-") + kind);
      }
    }
  }
}

// Shells that readers close as they go, and frames in two contexts, as the schema asks for (WR1).
TEST_F(StepFile, HasFacesThatJoinThoseBeforeAndPlacesBetweenTwoContexts) {
  const PrintModel model = make_print_model(test::sample_design());
  write_step(model, "print", path());
  const Entities entities(path());
  const std::vector<int> shells = entities.named("CLOSED_SHELL");
  EXPECT_EQ(shells.size(), model.bodies("print").size());
  for (int shell : shells) {
    std::set<int> there;
    for (int face : entities.references(shell)) {
      std::set<int> edges = entities.edges(face);
      EXPECT_TRUE(there.empty() || std::any_of(edges.begin(), edges.end(),
                                               [&](int edge) { return there.count(edge) > 0; }));
      there.merge(edges);
    }
  }
  const std::vector<int> relations = entities.named("REPRESENTATION_RELATIONSHIP");
  EXPECT_EQ(relations.size(), model.bodies("print").size());
  for (int relation : relations) EXPECT_EQ(entities.contexts(relation).size(), 2u);
}

TEST_F(StepFile, KeepsNamesThatStepMustEncode) {
  PrintBody body = make_print_model(test::sample_design()).tiles[0];
  body.name = u8"L'\u00e9cran \\ \u5c4b\u6839 'a'";
  write_step({&body}, u8"Fl\u00e4che", path());
  expect_bodies({&body}, u8"Fl\u00e4che");
}

TEST(StepText, EncodesStringsAsTheStandardSays) {
  EXPECT_EQ(step_string("T00001"), "'T00001'");
  EXPECT_EQ(step_string("it's \\"), "'it''s \\\\'");
  EXPECT_EQ(step_string(u8"\u00e9"), "'\\X2\\00E9\\X0\\'");
  EXPECT_EQ(step_string(u8"\U0001F600"), "'\\X4\\0001F600\\X0\\'");
  EXPECT_EQ(step_string("a\nb"), "'ab'");
}

TEST_F(StepFile, WritesNumbersThatReadBackTheSame) {
  const double values[] = {0,
                           1,
                           -2.5,
                           1e-5,
                           3.0e21,
                           0.1,
                           1.0 / 3,
                           -1e-300,
                           123456.0,
                           5e-324,
                           std::numeric_limits<double>::max()};
  StepText numbers("numbers", path());
  for (double value : values) numbers.add("X(", value, ")");
  numbers.finish();
  std::ifstream file(path());
  std::size_t found = 0;
  for (std::string line; std::getline(file, line);) {
    const std::size_t at = line.find("=X(");
    if (at == std::string::npos) continue;
    const std::string number = line.substr(at + 3, line.size() - at - 5);
    EXPECT_EQ(std::strtod(number.c_str(), nullptr), values[found++]) << number;
    // A digit, the point that marks a real number, and a capital exponent.
    EXPECT_NE(number.find('.'), std::string::npos) << number;
    EXPECT_EQ(number.find('e'), std::string::npos) << number;
  }
  EXPECT_EQ(found, std::size(values));
}

TEST_F(StepFile, RefusesNumbersThatAreNotFiniteAndLeavesNoFile) {
  {
    StepText step("broken", path());
    EXPECT_THROW(step.add("X(", std::nan(""), ")"), SolverFailure);
  }
  EXPECT_FALSE(std::filesystem::exists(path()));
}

}  // namespace
}  // namespace curveups
