// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/fabrication/file_formats.hpp"
#include "curveups/fabrication/step_text.hpp"

namespace curveups {
namespace {

constexpr std::size_t bodies_at_once = 64;  // between two calls of the progress sink

// Products of an assembly, around the solids.
class Products {
 public:
  Products(StepText& step, const std::string& title) : step_(step), title_(title) {
    const StepId application =
        step_.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
    step_.add("APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,",
              application, ")");
    product_context_ = step_.add("PRODUCT_CONTEXT('',", application, ",'mechanical')");
    definition_context_ =
        step_.add("PRODUCT_DEFINITION_CONTEXT('part definition',", application, ",'design')");
    add_units();
    part_space_ = add_space("parts");
    part_frame_ = add_frame();
    // Identity transformation of all parts, between two spaces as the schema's rule WR1 requires.
    const StepId space = add_space("assembly"), frame = add_frame();
    stay_ = step_.add("ITEM_DEFINED_TRANSFORMATION('','',", part_frame_, ",", frame, ")");
    const std::string name = step_string(title);
    root_shape_ = step_.add("SHAPE_REPRESENTATION(", name, ",(", frame, "),", space, ")");
    root_ = add_product(name, name, root_shape_);
  }

  void add_part(const PrintBody& body) {
    const StepId solid = add_solid(body);
    const std::string name = step_string(body.name);
    const StepId shape = step_.add("ADVANCED_BREP_SHAPE_REPRESENTATION(", name, ",(", part_frame_,
                                   ",", solid, "),", part_space_, ")");
    const StepId part = add_product(step_string(title_ + "/" + body.name), name, shape);
    const StepId usage =
        step_.add("NEXT_ASSEMBLY_USAGE_OCCURRENCE('", std::to_string(styled_.size()), "',", name,
                  ",'',", root_, ",", part, ",$)");
    const StepId placed =
        step_.add("PRODUCT_DEFINITION_SHAPE('Placement','Placement of an item',", usage, ")");
    const StepId relation =
        step_.add("(REPRESENTATION_RELATIONSHIP('','',", shape, ",", root_shape_,
                  ")REPRESENTATION_RELATIONSHIP_WITH_"
                  "TRANSFORMATION(",
                  stay_, ")SHAPE_REPRESENTATION_RELATIONSHIP())");
    step_.add("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(", relation, ",", placed, ")");
  }

  // A solid with its colour.
  StepId add_solid(const PrintBody& body) {
    const StepId solid = add_step_solid(step_, body);
    styled_.push_back(step_.add("STYLED_ITEM('color',(", style(body.kind), "),", solid, ")"));
    return solid;
  }

  void finish() {
    step_.add("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,", products_, ")");
    step_.add("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',", styled_, ",",
              part_space_, ")");
  }

 private:
  void add_units() {
    const StepId length = step_.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
    const StepId angle = step_.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    const StepId solid = step_.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    units_ = {length, angle, solid};
    // Distance of corners from the planes that meet there.
    accuracy_ = step_.add("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(", tolerance::snap, "),",
                          length, ",'distance_accuracy_value','confusion accuracy')");
  }

  StepId add_space(const char* name) {
    return step_.add("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((",
                     accuracy_, "))GLOBAL_UNIT_ASSIGNED_CONTEXT(", units_,
                     ")REPRESENTATION_CONTEXT('", name, "','3D'))");
  }

  StepId add_frame() {
    const StepId origin = step_.add("CARTESIAN_POINT('',(0.,0.,0.))");
    const StepId z = step_.add("DIRECTION('',(0.,0.,1.))");
    const StepId x = step_.add("DIRECTION('',(1.,0.,0.))");
    return step_.add("AXIS2_PLACEMENT_3D('',", origin, ",", z, ",", x, ")");
  }

  // A product of that shape; id and name are STEP strings. Returns its definition.
  StepId add_product(const std::string& id, const std::string& name, StepId shape) {
    products_.push_back(step_.add("PRODUCT(", id, ",", name, ",'',(", product_context_, "))"));
    const StepId version = step_.add("PRODUCT_DEFINITION_FORMATION('','',", products_.back(), ")");
    const StepId definition =
        step_.add("PRODUCT_DEFINITION('design','',", version, ",", definition_context_, ")");
    const StepId of_shape = step_.add("PRODUCT_DEFINITION_SHAPE('','',", definition, ")");
    step_.add("SHAPE_DEFINITION_REPRESENTATION(", of_shape, ",", shape, ")");
    return definition;
  }

  StepId style(BodyKind kind) {
    StepId& assignment = style_[static_cast<int>(kind)];
    if (assignment != StepId{}) return assignment;
    const Colour c = body_colour(kind);
    const StepId colour =
        step_.add("COLOUR_RGB('',", c.red / 255.0, ",", c.green / 255.0, ",", c.blue / 255.0, ")");
    const StepId fill_colour = step_.add("FILL_AREA_STYLE_COLOUR('',", colour, ")");
    const StepId fill = step_.add("FILL_AREA_STYLE('',(", fill_colour, "))");
    const StepId area = step_.add("SURFACE_STYLE_FILL_AREA(", fill, ")");
    const StepId side = step_.add("SURFACE_SIDE_STYLE('',(", area, "))");
    const StepId usage = step_.add("SURFACE_STYLE_USAGE(.BOTH.,", side, ")");
    return assignment = step_.add("PRESENTATION_STYLE_ASSIGNMENT((", usage, "))");
  }

  StepText& step_;
  const std::string& title_;
  StepId product_context_{}, definition_context_{}, accuracy_{}, part_space_{}, part_frame_{};
  StepId stay_{}, root_shape_{}, root_{};
  std::array<StepId, 3> style_{};
  std::vector<StepId> units_, products_, styled_;
};

}  // namespace

void write_step(const std::vector<const PrintBody*>& bodies, const std::string& title,
                const std::string& path) {
  StepText step(title, path);
  Products products(step, title);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (k % bodies_at_once == 0) {
      checkpoint("writing STEP", static_cast<double>(k) / bodies.size());
    }
    products.add_part(*bodies[k]);
  }
  checkpoint("writing STEP", 1);
  products.finish();
  step.finish();
}

}  // namespace curveups
