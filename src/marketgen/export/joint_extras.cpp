#include "export/joint_extras.h"

#include <fmt/format.h>

#include "export/fixture_links.h"
#include "export/xml_text.h"

namespace marketgen::exporters {

std::string_view joint_type(const scene::SceneJoint& joint) {
  switch (joint.kind) {
    case assets::JointKind::belt:
      return "fixed";
    case assets::JointKind::slide:
      return "prismatic";
    case assets::JointKind::hinge:
      break;
  }
  return turns_endlessly(joint) ? "continuous" : "revolute";
}

assets::JointKind joint_kind_of(std::string_view type) {
  return type == "prismatic" ? assets::JointKind::slide : assets::JointKind::hinge;
}

std::string joint_extras(const scene::SceneJoint& joint) {
  if (joint.kind == assets::JointKind::belt)
    return fmt::format("kind=\"belt\" lower=\"{}\" upper=\"{}\"", joint.lower, joint.upper);
  if (joint.gasket <= 0 && joint.hold_open == 0) return "";
  return fmt::format("hold_open_factor=\"{}\" gasket=\"{}\" gasket_reach=\"{}\"",
                     xml_numbers({hold_open_factor(joint)}),
                     joint.gasket,
                     joint.gasket_reach);
}

bool is_belt(const tinyxml2::XMLElement& extras) {
  return extras.Attribute("kind", "belt") != nullptr;
}

Result<void> read_joint_extras(const XmlFile& xml,
                               const tinyxml2::XMLElement& extras,
                               ExportedJoint& joint) {
  if (is_belt(extras)) {
    joint.kind = assets::JointKind::belt;
    MARKETGEN_TRY(joint.lower, xml.attribute_number(extras, "lower"));
    MARKETGEN_TRY(joint.upper, xml.attribute_number(extras, "upper"));
    return {};
  }
  MARKETGEN_TRY(joint.hold_open_factor, xml.attribute_number(extras, "hold_open_factor"));
  MARKETGEN_TRY(joint.gasket, xml.attribute_number(extras, "gasket"));
  MARKETGEN_TRY(joint.gasket_reach, xml.attribute_number(extras, "gasket_reach"));
  return {};
}

}  // namespace marketgen::exporters
