#include "export/mjcf_fixtures.h"

#include <algorithm>
#include <vector>

#include "export/fixture_links.h"
#include "scene/articulation.h"

namespace marketgen::exporters {
namespace {

constexpr int body_depth = 2;  // indentation of what lies in the world body

class FixtureWriter {
 public:
  FixtureWriter(XmlText& out, const scene::Scene& scene) : out_(out), scene_(scene) {
    parts_on_.resize(scene.joints.size());
    children_.resize(scene.joints.size());
    for (std::uint32_t row = 0; row < scene.parts.size(); ++row) {
      if (const std::int32_t joint = scene.parts[row].joint; joint >= 0)
        parts_on_[static_cast<std::size_t>(joint)].push_back(row);
    }
    for (std::uint32_t row = 0; row < scene.joints.size(); ++row) {
      if (const std::int32_t parent = scene.joints[row].parent; parent >= 0)
        children_[static_cast<std::size_t>(parent)].push_back(row);
    }
  }

  // A geom of the world.
  void write_still(std::uint32_t row) {
    const Pose world = scene::world_from_fixture(scene_, scene_.parts[row].fixture);
    write_part(body_depth, row, world, "");
  }

  // A body on the world with all that it carries.
  void write_moving(std::uint32_t joint) {
    write_body(body_depth, joint, scene::world_from_fixture(scene_, scene_.joints[joint].fixture));
  }

 private:
  void write_part(int depth,
                  std::uint32_t row,
                  const Pose& owner_from_fixture,
                  const std::string& mass) {
    const scene::ScenePart& part = scene_.parts[row];
    const assets::ContactShape shape = owner_from_fixture * physics::contact_shape_of(part);
    const double alpha = part.kind == assets::SurfaceKind::glass ? mjcf_glass_alpha : 1.0;
    out_.line(depth,
              "<geom name=\"{}/{}\" class=\"fixture\"{}{} size=\"{}\"{} rgba=\"{}\"/>",
              scene_.layout.fixtures[part.fixture].id,
              part_name(scene_, row),
              shape.shape == assets::CollisionShape::cylinder ? " type=\"cylinder\"" : "",
              mjcf_pose(shape.pose),
              mjcf_size(shape),
              mass,
              xml_color({part.color[0], part.color[1], part.color[2]}, alpha));
  }

  // The body's frame is the joint's.
  void write_body(int depth, std::uint32_t row, const Pose& owner_from_fixture) {
    const scene::SceneJoint& joint = scene_.joints[row];
    const Pose frame = scene::fixture_from_joint(joint);
    out_.line(depth,
              "<body name=\"{}\"{}>",
              scene::joint_id(scene_, joint),
              mjcf_pose(owner_from_fixture * frame));
    if (joint.kind != assets::JointKind::belt) write_joint(depth + 1, joint);
    const Pose body_from_fixture = inverse(frame);
    const std::vector<double> masses = scene::masses_of(scene_, joint, parts_on_[row]);
    for (std::size_t i = 0; i < masses.size(); ++i) {
      const auto mass = static_cast<float>(masses[i]);
      write_part(
          depth + 1, parts_on_[row][i], body_from_fixture, fmt::format(" mass=\"{}\"", mass));
    }
    for (const std::uint32_t child : children_[row])
      write_body(depth + 1, child, body_from_fixture);
    out_.line(depth, "</body>");
  }

  void write_joint(int depth, const scene::SceneJoint& joint) {
    // MuJoCo before 3.7 knows no springs but straight ones: others only where a door stays open.
    const double bend = hold_open_factor(joint);
    const std::string bent = bend == 0 ? "" : fmt::format(" 0 {}", static_cast<float>(bend));
    const std::string spring =
        joint.stiffness == 0
            ? ""
            : fmt::format(
                  " stiffness=\"{}{}\" springref=\"{}\"", joint.stiffness, bent, joint.spring_rest);
    out_.line(depth,
              "<joint name=\"{}\" type=\"{}\" axis=\"0 0 1\" range=\"{} {}\" frictionloss=\"{}\" "
              "damping=\"{}\"{}/>",
              scene::joint_id(scene_, joint),
              name_of(joint.kind),  // MuJoCo's names are ours
              joint.lower,
              joint.upper,
              joint.friction,
              joint.damping,
              spring);
  }

  XmlText& out_;
  const scene::Scene& scene_;
  std::vector<std::vector<std::uint32_t>> parts_on_, children_;  // by joint
};

bool needs_numbers(const scene::SceneJoint& joint) {
  return joint.kind == assets::JointKind::belt || joint.gasket > 0;
}

}  // namespace

void write_mjcf_fixtures(XmlText& out, const scene::Scene& scene, const ExportOptions& options) {
  FixtureWriter writer(out, scene);
  for (std::uint32_t row = 0; row < scene.parts.size(); ++row) {
    if (options.still_fixtures || scene.parts[row].joint < 0) writer.write_still(row);
  }
  if (options.still_fixtures) return;
  for (std::uint32_t row = 0; row < scene.joints.size(); ++row) {
    if (scene.joints[row].parent < 0) writer.write_moving(row);
  }
}

void write_mjcf_joint_numbers(XmlText& out,
                              const scene::Scene& scene,
                              const ExportOptions& options) {
  if (options.still_fixtures || std::ranges::none_of(scene.joints, needs_numbers)) return;
  out.line(1, "<custom>");
  for (const scene::SceneJoint& joint : scene.joints) {
    if (joint.gasket > 0)
      out.line(2,
               "<numeric name=\"{}/gasket\" data=\"{} {}\"/>",
               scene::joint_id(scene, joint),
               joint.gasket,
               joint.gasket_reach);
    if (joint.kind != assets::JointKind::belt) continue;
    const Pose world =
        scene::world_from_fixture(scene, joint.fixture) * scene::fixture_from_joint(joint);
    out.line(2,
             "<numeric name=\"{}\" data=\"{} {} {}\"/>",
             scene::joint_id(scene, joint),
             xml_vector(rotate(world.rotation, {0, 0, 1})),
             joint.lower,
             joint.upper);
  }
  out.line(1, "</custom>");
}

}  // namespace marketgen::exporters
