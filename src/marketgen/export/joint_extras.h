// Joints in the words of URDF and SDF, and attributes of ours for what these two have no words for.
#pragma once
#include <string>
#include <string_view>

#include "base/result.h"
#include "export/exporter.h"
#include "export/read_xml.h"
#include "scene/scene.h"

namespace marketgen::exporters {

// "revolute", "continuous", "prismatic"; a belt stands still ("fixed").
std::string_view joint_type(const scene::SceneJoint& joint);
// Of a joint that moves.
assets::JointKind joint_kind_of(std::string_view type);

// `kind="belt" lower upper` in m/s along the link's Z; or hold_open_factor, gasket and gasket_reach
// (mjcf_fixtures.h); empty when there is nothing to say.
std::string joint_extras(const scene::SceneJoint& joint);
bool is_belt(const tinyxml2::XMLElement& extras);
Result<void> read_joint_extras(const XmlFile& xml,
                               const tinyxml2::XMLElement& extras,
                               ExportedJoint& joint);

}  // namespace marketgen::exporters
