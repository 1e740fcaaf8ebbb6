#include "export/fixture_links.h"

#include <fmt/format.h>

#include <map>

#include "scene/articulation.h"

namespace marketgen::exporters {

std::vector<FixtureLink> fixture_links(const scene::Scene& scene,
                                       std::uint32_t fixture,
                                       bool still_fixtures) {
  const scene::SceneFixture& row = scene.fixtures[fixture];
  std::vector<FixtureLink> links(1);
  std::map<int, std::size_t> link_of;
  for (std::uint32_t j = 0; !still_fixtures && j < row.joint_count; ++j) {
    const auto joint = static_cast<int>(row.first_joint + j);
    link_of[joint] = links.size();
    links.push_back({joint, scene::fixture_from_joint(scene.joints[row.first_joint + j]), {}});
  }
  for (std::uint32_t p = row.first_part; p < row.first_part + row.part_count; ++p) {
    const auto found = link_of.find(scene.parts[p].joint);
    links[found == link_of.end() ? 0 : found->second].parts.push_back(p);
  }
  return links;
}

const scene::SceneJoint& joint_of(const scene::Scene& scene, const FixtureLink& link) {
  return scene.joints[static_cast<std::size_t>(link.joint)];
}

bool moves(const scene::Scene& scene, const FixtureLink& link) {
  return link.joint >= 0 && joint_of(scene, link).kind != assets::JointKind::belt;
}

std::string part_name(const scene::Scene& scene, std::uint32_t part) {
  const scene::ScenePart& row = scene.parts[part];
  return fmt::format("{}-{}", name_of(row.unit), part - scene.fixtures[row.fixture].first_part);
}

std::string part_id(const scene::Scene& scene, std::uint32_t part) {
  return scene.layout.fixtures[scene.parts[part].fixture].id + "/" + part_name(scene, part);
}

double hold_open_factor(const scene::SceneJoint& joint) {
  if (joint.hold_open == 0) return 0;
  const double reach = double(joint.hold_open) - double(joint.spring_rest);
  return -double(joint.stiffness) / (reach * reach);
}

bool turns_endlessly(const scene::SceneJoint& joint) {
  return joint.upper - joint.lower > endless_hinge_rad;
}

}  // namespace marketgen::exporters
