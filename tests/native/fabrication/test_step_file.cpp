// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopAbs_ShapeEnum.hxx>
#include <TopExp_Explorer.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include "curveups/core/errors.hpp"
#include "curveups/fabrication/file_formats.hpp"
#include "curveups/fabrication/occ_solids.hpp"
#include "curveups/fabrication/print_files.hpp"
#include "curveups/fabrication/step_text.hpp"
#include "support/designs.hpp"

namespace curveups {
namespace {

std::string text_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return "";
  std::string utf8(name->Get().LengthOfCString(), '\0');
  Standard_PCharacter at = &utf8[0];
  name->Get().ToUTF8CString(at);
  return utf8;
}

// Parts of the assembly by name, read by another program.
struct ReadPart {
  TopoDS_Shape shape;
  Quantity_Color colour;
};
struct ReadAssembly {
  std::string title;
  std::map<std::string, ReadPart> parts;
};

ReadAssembly read_assembly(const std::string& path) {
  STEPCAFControl_Reader reader;
  reader.SetNameMode(true);
  reader.SetColorMode(true);
  Handle(TDocStd_Document) document = new TDocStd_Document("MDTV-XCAF");
  ReadAssembly out;
  testing::internal::CaptureStdout();  // OpenCASCADE's banner
  const bool read = reader.ReadFile(path.c_str()) == IFSelect_RetDone && reader.Transfer(document);
  testing::internal::GetCapturedStdout();
  if (!read) return out;
  Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  Handle(XCAFDoc_ColorTool) colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
  TDF_LabelSequence roots;
  shapes->GetFreeShapes(roots);
  EXPECT_EQ(roots.Length(), 1);
  out.title = text_of(roots.First());
  TDF_LabelSequence components;
  XCAFDoc_ShapeTool::GetComponents(roots.First(), components);
  for (const TDF_Label& component : components) {
    TDF_Label part;
    XCAFDoc_ShapeTool::GetReferredShape(component, part);
    EXPECT_EQ(text_of(component), text_of(part));
    ReadPart found;
    found.shape = XCAFDoc_ShapeTool::GetShape(component);
    EXPECT_TRUE(
        colours->GetColor(found.shape, XCAFDoc_ColorSurf, found.colour) ||
        colours->GetColor(XCAFDoc_ShapeTool::GetShape(part), XCAFDoc_ColorSurf, found.colour))
        << text_of(part);
    out.parts[text_of(part)] = found;
  }
  return out;
}

GProp_GProps mass_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties;
}
gp_Pnt centre_of_mass(const TopoDS_Shape& shape) { return mass_of(shape).CentreOfMass(); }

class StepFile : public ::testing::Test {
 protected:
  void SetUp() override {
    char folder[] = "/tmp/curveups-step-XXXXXX";
    ASSERT_NE(mkdtemp(folder), nullptr);
    folder_ = folder;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path() const { return (folder_ / "a.step").string(); }

  // Every part by name and colour, valid, with the body's own volume and its solid's place.
  void expect_bodies(const std::vector<const PrintBody*>& bodies, const std::string& title) const {
    const ReadAssembly read = read_assembly(path());
    EXPECT_EQ(read.title, title);
    ASSERT_EQ(read.parts.size(), bodies.size());
    for (const PrintBody* body : bodies) {
      SCOPED_TRACE(body->name);
      const auto found = read.parts.find(body->name);
      ASSERT_NE(found, read.parts.end());
      const TopoDS_Shape& shape = found->second.shape;
      ASSERT_EQ(shape.ShapeType(), TopAbs_SOLID);
      EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
      EXPECT_NEAR(mass_of(shape).Mass(), volume(*body), 1e-9 * volume(*body));
      EXPECT_LT(centre_of_mass(shape).Distance(centre_of_mass(make_solid(*body))), 1e-7);
      Standard_Real r, g, b;
      found->second.colour.Values(r, g, b, Quantity_TOC_sRGB);
      const Colour expected = body_colour(body->kind);
      EXPECT_NEAR(255 * r, expected.red, 0.5);
      EXPECT_NEAR(255 * g, expected.green, 0.5);
      EXPECT_NEAR(255 * b, expected.blue, 0.5);
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

// The entities of a file by number, and those that one leads to.
class Entities {
 public:
  explicit Entities(const std::string& path) {
    std::ifstream file(path);
    for (std::string entity; std::getline(file, entity, ';');) {
      const std::size_t at = entity.find('#');
      if (at == std::string::npos) continue;
      std::string& text = text_[std::stoi(entity.substr(at + 1))];
      for (char c : entity.substr(entity.find('=') + 1)) {
        if (c > ' ' && !(c == '(' && text.empty())) text += c;  // first part of complex ones
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
  const std::string& text(int id) const { return text_.at(id); }
  std::set<int> edges(int id) const {
    if (text_.at(id).rfind("EDGE_CURVE(", 0) == 0) return {id};
    std::set<int> found;
    for (int part : references(id)) found.merge(edges(part));
    return found;
  }

 private:
  std::map<int, std::string> text_;
};

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
  StepText numbers("numbers");
  for (double value : values) numbers.add("X(", value, ")");
  std::istringstream file(numbers.finish());
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
  StepText step("broken");
  EXPECT_THROW(step.add("X(", std::nan(""), ")"), SolverFailure);
}

}  // namespace
}  // namespace curveups
