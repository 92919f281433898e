// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/step_file.hpp"

#include <malloc.h>

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressScope.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPConstruct.hxx>
#include <STEPConstruct_Styles.hxx>
#include <STEPControl_Controller.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepRepr_RepresentationContext.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_MechanicalDesignGeometricPresentationRepresentation.hxx>
#include <StepVisual_PresentationStyleAssignment.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>
#include <array>
#include <fstream>
#include <mutex>

#include "curveups/core/errors.hpp"
#include "curveups/fabrication/atomic_file.hpp"
#include "curveups/fabrication/palette.hpp"

namespace curveups {
namespace {

// The writer's settings are OpenCASCADE's globals, which the host program has its own values of.
class StaticText {
 public:
  StaticText(const char* name, const char* value) : name_(name) {
    const char* old = Interface_Static::CVal(name);
    old_ = old ? old : "";
    Interface_Static::SetCVal(name, value);
  }
  ~StaticText() { Interface_Static::SetCVal(name_, old_.c_str()); }

 private:
  const char* name_;
  std::string old_;
};

class StaticNumber {
 public:
  StaticNumber(const char* name, int value) : name_(name), old_(Interface_Static::IVal(name)) {
    Interface_Static::SetIVal(name, value);
  }
  ~StaticNumber() { Interface_Static::SetIVal(name_, old_); }

 private:
  const char* name_;
  int old_;
};

// Keeps OpenCASCADE's banner off the standard output, which is the caller's.
class SilentMessenger {
 public:
  SilentMessenger() : printers_(Message::DefaultMessenger()->Printers()) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
  }
  ~SilentMessenger() { Message::DefaultMessenger()->ChangePrinters() = printers_; }

 private:
  Message_SequenceOfPrinters printers_;
};

class Indicator : public Message_ProgressIndicator {
 public:
  explicit Indicator(const Progress& progress) : progress_(progress) {}
  bool stopped() const { return stopped_; }

 protected:
  Standard_Boolean UserBreak() override { return stopped_; }
  void Show(const Message_ProgressScope&, const Standard_Boolean) override {
    if (!stopped_ && !keep_going(progress_, "writing STEP", GetPosition())) stopped_ = true;
  }

 private:
  const Progress& progress_;
  bool stopped_ = false;
};

using DocumentHandle = Handle(TDocStd_Document);

DocumentHandle make_document(const std::vector<NamedSolid>& solids, const std::string& title) {
  Handle(TDocStd_Document) document = new TDocStd_Document("MDTV-XCAF");
  Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  shapes->SetAutoNaming(false);
  const TDF_Label root = shapes->NewShape();
  TDataStd_Name::Set(root, TCollection_ExtendedString(title.c_str(), Standard_True));
  for (const NamedSolid& solid : solids) {
    const TDF_Label part = shapes->AddShape(solid.shape, Standard_False);
    TDataStd_Name::Set(part, TCollection_ExtendedString(solid.name.c_str(), Standard_True));
    const TDF_Label place = shapes->AddComponent(root, part, TopLoc_Location());
    TDataStd_Name::Set(place, TCollection_ExtendedString(solid.name.c_str(), Standard_True));
  }
  shapes->UpdateAssemblies();
  return document;
}

// Colours in the order of the solids: the writer's own colour mode goes through them in the order
// of their addresses in memory, which differs from run to run.
void add_colours(const Handle(XSControl_WorkSession) & session,
                 const std::vector<NamedSolid>& solids) {
  STEPConstruct_Styles styles(session);
  std::array<Handle(StepVisual_Colour), 3> colour;
  for (int k = 0; k < 3; ++k) {
    const Colour c = body_colour(static_cast<BodyKind>(k));
    colour[k] = STEPConstruct_Styles::EncodeColor(
        Quantity_Color(c.red / 255.0, c.green / 255.0, c.blue / 255.0, Quantity_TOC_sRGB));
  }
  for (const NamedSolid& solid : solids) {
    const Handle(StepRepr_RepresentationItem) item =
        STEPConstruct::FindEntity(styles.FinderProcess(), solid.shape);
    const Handle(StepRepr_RepresentationContext) context = styles.FindContext(solid.shape);
    if (item.IsNull() || context.IsNull()) {
      throw SolverFailure("OpenCASCADE lost " + solid.name + " on the way to STEP",
                          "report this with the design file");
    }
    styles.ClearStyles();
    const Handle(StepVisual_StyledItem) style = styles.AddStyle(
        item, styles.GetColorPSA(item, colour[static_cast<int>(solid.kind)]), nullptr);
    Handle(StepVisual_MechanicalDesignGeometricPresentationRepresentation) representation;
    styles.CreateMDGPR(context, representation);
    session->Model()->AddWithRefs(style);
    session->Model()->AddWithRefs(representation);
  }
}

// What OpenCASCADE counts through the life of the process, and the date, must not be in the file.
void make_reproducible(const Handle(StepData_StepModel) & model, const std::string& title) {
  APIHeaderSection_MakeHeader header(model);
  auto text = [](const std::string& s) { return new TCollection_HAsciiString(s.c_str()); };
  header.SetName(text(title));
  header.SetTimeStamp(text("1970-01-01T00:00:00"));
  header.SetAuthorValue(1, text(""));
  header.SetOrganizationValue(1, text(""));
  header.SetOriginatingSystem(text("CurveUps"));
  int usage = 0;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(StepRepr_NextAssemblyUsageOccurrence) occurrence =
        Handle(StepRepr_NextAssemblyUsageOccurrence)::DownCast(model->Value(i));
    if (!occurrence.IsNull()) occurrence->SetId(text(std::to_string(++usage)));
  }
}

bool is_complete(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  if (size < 64) return false;
  file.seekg(size - 64);
  std::string end(64, '\0');
  file.read(&end[0], 64);
  return end.find("END-ISO-10303-21;") != std::string::npos;
}

}  // namespace

void write_step(const std::vector<NamedSolid>& solids, const std::string& title,
                const std::string& path, const Progress& progress) {
  static std::mutex one_writer;  // OpenCASCADE's settings are global
  const std::lock_guard<std::mutex> lock(one_writer);
  write_atomically(path, [&](const std::string& temporary) {
    const SilentMessenger silent;
    STEPControl_Controller::Init();
    const StaticText schema("write.step.schema", "AP214IS");
    const StaticText unit("write.step.unit", "MM");
    const StaticNumber curves("write.surfacecurve.mode", 0);
    const StaticNumber assembly("write.step.assembly", 2);
    const Handle(TDocStd_Document) document = make_document(solids, title);
    STEPCAFControl_Writer writer;
    writer.SetColorMode(false);
    writer.SetNameMode(true);
    Handle(Indicator) indicator = new Indicator(progress);
    const bool transferred =
        writer.Transfer(document, STEPControl_AsIs, nullptr, indicator->Start());
    if (indicator->stopped()) throw Cancelled();
    if (!transferred) {
      throw SolverFailure("OpenCASCADE could not turn the solids of " + title + " into STEP",
                          "report this with the design file");
    }
    add_colours(writer.ChangeWriter().WS(), solids);
    make_reproducible(writer.ChangeWriter().Model(), title);
    if (!keep_going(progress, "writing STEP", 1)) throw Cancelled();
    if (writer.Write(temporary.c_str()) != IFSelect_RetDone || !is_complete(temporary)) {
      throw IoError("can't write " + path + ": the file is incomplete",
                    "check that the disk has room");
    }
  });
#ifdef __GLIBC__
  // A writer leaves hundreds of megabytes of small freed blocks behind, which the next one can't
  // use.
  malloc_trim(0);
#endif
}

}  // namespace curveups
