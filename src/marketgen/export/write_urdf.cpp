#include <fmt/format.h>

#include <map>

#include "base/text.h"
#include "export/body_inertia.h"
#include "export/exporter.h"
#include "export/fixture_links.h"
#include "export/joint_extras.h"
#include "export/material_pictures.h"
#include "export/model_files.h"
#include "export/named_solids.h"
#include "export/obj_text.h"
#include "export/urdf_names.h"
#include "export/xml_text.h"
#include "physics/goods/standing_goods.h"
#include "scene/articulation.h"
#include "scene/placements.h"

// The store as one tree: the room, fixtures fixed to it, doors and lids on their joints, every item
// fixed to the fixture that it stands in.
namespace marketgen::exporters {
namespace {

// URDF wants both said; no drive of the store moves a joint, so these are beyond what a hand does.
constexpr double joint_effort = 1000, joint_speed = 100;

std::string origin(const Pose& pose) {
  return fmt::format(
      "<origin xyz=\"{}\" rpy=\"{}\"/>", xml_vector(pose.position), xml_rpy(pose.rotation));
}

std::string inertial(const BodyInertia& body) {
  const auto number = [&](std::size_t i) { return xml_numbers({body.moments_kg_m2[i]}); };
  return fmt::format(
      "<inertial><origin xyz=\"{}\"/><mass value=\"{}\"/><inertia ixx=\"{}\" iyy=\"{}\" "
      "izz=\"{}\" ixy=\"{}\" ixz=\"{}\" iyz=\"{}\"/></inertial>",
      xml_vector(body.center),
      xml_numbers({body.mass_kg}),
      number(0),
      number(1),
      number(2),
      number(3),
      number(4),
      number(5));
}

class UrdfWriter {
 public:
  UrdfWriter(const scene::Scene& scene, const ExportOptions& options)
      : scene_(scene), options_(options), beside_(escaped_markup(options.beside)) {}

  Result<ExportFiles> write() {
    if (options_.free_region_m)
      return Error{"usage.bad_flag",
                   "--free-region",
                   "URDF is one tree and has no free bodies; take --format mjcf, sdf or usd"};
    MARKETGEN_TRY(files_, ModelFiles::make(scene_));
    for (const catalog::Product& product : scene_.catalog) {
      MARKETGEN_TRY(goods_.emplace_back(), physics::standing_goods(product));
    }
    out_.line(0, "<?xml version=\"1.0\"?>");
    out_.line(0, "<robot name=\"{}\">", escaped_markup(scene_.layout.name));
    // MuJoCo would take the folders off the meshes' names, refuse flat ones, which have no volume,
    // and make one body of all that stands.
    out_.line(1,
              "<mujoco><compiler strippath=\"false\" discardvisual=\"true\" "
              "fusestatic=\"false\"/></mujoco>");
    write_materials();
    write_room();
    for (std::uint32_t f = 0; f < scene_.fixtures.size(); ++f) {
      if (scene_.fixtures[f].part_count > 0) write_fixture(f);
    }
    for (std::uint32_t row = 0; row < scene_.products.size(); ++row)
      write_item(row);
    out_.line(0, "</robot>");
    return ExportFiles{out_.take(), files_.take()};
  }

 private:
  static std::string color_of(const scene::ScenePart& part) {
    return xml_color({part.color[0], part.color[1], part.color[2]},
                     part.kind == assets::SurfaceKind::glass ? double(glass_alpha) : 1.0);
  }

  void write_materials() {
    for (const scene::ScenePart& part : scene_.parts)
      colors_.try_emplace(color_of(part), fmt::format("color-{}", colors_.size()));
    for (const auto& [color, name] : colors_)
      out_.line(1, "<material name=\"{}\"><color rgba=\"{}\"/></material>", name, color);
  }

  std::string geometry(const assets::ContactShape& shape) {
    const Vec3& s = shape.size;
    if (shape.shape == assets::CollisionShape::box)
      return fmt::format("<geometry><box size=\"{}\"/></geometry>", xml_vector(s * 2));
    if (shape.shape == assets::CollisionShape::cylinder)
      return fmt::format("<geometry><cylinder radius=\"{}\" length=\"{}\"/></geometry>",
                         xml_numbers({s.x}),
                         xml_numbers({2 * s.y}));
    files_.add(urdf_ball_file, obj_text(hull_mesh(ellipsoid_points({1, 1, 1}))));
    return mesh(urdf_ball_file, fmt::format(" scale=\"{}\"", xml_vector(s)));
  }

  std::string mesh(std::string_view file, std::string_view scale = {}) const {
    return fmt::format("<geometry><mesh filename=\"{}/{}\"{}/></geometry>", beside_, file, scale);
  }

  std::string collision(std::string_view name, const assets::ContactShape& shape) {
    return fmt::format(
        "<collision name=\"{}\">{}{}</collision>", name, origin(shape.pose), geometry(shape));
  }

  void write_room() {
    out_.line(1, "<link name=\"{}\">", urdf_room);
    for (const ModelFiles::RoomMesh& surface : files_.room())
      out_.line(2, "<visual name=\"{}\">{}</visual>", surface.surface, mesh(surface.file));
    for (const NamedSolid& solid : room_solids(scene_.layout.shell))
      out_.line(2, "{}", collision(solid.name, solid.shape));
    out_.line(1, "</link>");
  }

  void write_mount(std::string_view link, std::string_view parent, const Pose& pose) {
    out_.line(1,
              "<joint name=\"{0}{1}\" type=\"fixed\"><parent link=\"{2}\"/><child "
              "link=\"{0}\"/>{3}</joint>",
              link,
              urdf_mount,
              parent,
              origin(pose));
  }

  void write_fixture(std::uint32_t fixture) {
    const std::string& id = scene_.layout.fixtures[fixture].id;
    std::map<int, const FixtureLink*> by_joint;
    const std::vector<FixtureLink> links = fixture_links(scene_, fixture, options_.still_fixtures);
    for (const FixtureLink& link : links) {
      by_joint[link.joint] = &link;
      write_link(link, link.joint < 0 ? id : link_name(joint_of(scene_, link)));
      if (link.joint < 0) {
        write_mount(id, urdf_room, scene::world_from_fixture(scene_, fixture));
        continue;
      }
      const scene::SceneJoint& joint = joint_of(scene_, link);
      const Pose parent_from_link =
          inverse(by_joint.at(joint.parent)->fixture_from_link) * link.fixture_from_link;
      write_joint(joint, parent_from_link);
    }
  }

  std::string link_name(const scene::SceneJoint& joint) const {
    return scene::joint_id(scene_, joint) + std::string(urdf_link);
  }

  void write_link(const FixtureLink& link, const std::string& name) {
    out_.line(1, "<link name=\"{}\">", name);
    if (link.joint >= 0)
      out_.line(2, "{}", inertial(inertia_of(scene_, joint_of(scene_, link), link.parts)));
    const Pose link_from_fixture = inverse(link.fixture_from_link);
    for (const std::uint32_t row : link.parts) {
      const assets::ContactShape shape =
          link_from_fixture * physics::contact_shape_of(scene_.parts[row]);
      const std::string part = part_id(scene_, row);
      out_.line(2,
                "<visual name=\"{}\">{}{}<material name=\"{}\"/></visual>",
                part,
                origin(shape.pose),
                geometry(shape),
                colors_.at(color_of(scene_.parts[row])));
      out_.line(2, "{}", collision(part, shape));
    }
    out_.line(1, "</link>");
  }

  // A belt stands still; what URDF has no words for stands in elements of our own.
  void write_joint(const scene::SceneJoint& joint, const Pose& parent_from_link) {
    const std::string name = scene::joint_id(scene_, joint);
    const std::string_view type = joint_type(joint);
    const std::string parent =
        joint.parent < 0 ? scene_.layout.fixtures[joint.fixture].id
                         : link_name(scene_.joints[static_cast<std::size_t>(joint.parent)]);
    out_.line(1, "<joint name=\"{}\" type=\"{}\">", name, type);
    out_.line(2,
              "<parent link=\"{}\"/><child link=\"{}\"/>{}",
              parent,
              link_name(joint),
              origin(parent_from_link));
    if (type != "fixed") {
      out_.line(2, "<axis xyz=\"0 0 1\"/>");
      out_.line(2,
                "<limit{} effort=\"{}\" velocity=\"{}\"/>",
                type == "continuous"
                    ? ""
                    : fmt::format(" lower=\"{}\" upper=\"{}\"", joint.lower, joint.upper),
                joint_effort,
                joint_speed);
      out_.line(2, "<dynamics damping=\"{}\" friction=\"{}\"/>", joint.damping, joint.friction);
    }
    out_.line(1, "</joint>");
    write_extras(joint, name);
  }

  void write_extras(const scene::SceneJoint& joint, const std::string& name) {
    if (joint.kind != assets::JointKind::belt && joint.stiffness > 0)
      out_.line(1,
                "<gazebo reference=\"{}\"><springReference>{}</springReference>"
                "<springStiffness>{}</springStiffness></gazebo>",
                name,
                joint.spring_rest,
                joint.stiffness);
    if (const std::string extras = joint_extras(joint); !extras.empty())
      out_.line(1, "<marketgen joint=\"{}\" {}/>", name, extras);
  }

  void write_item(std::uint32_t row) {
    const scene::SceneProduct& item = scene_.products[row];
    const physics::StandingGoods& goods = goods_[item.sku];
    const std::string id = scene::product_id(scene_, row);
    out_.line(1, "<link name=\"{}\">", id);
    out_.line(2, "{}", inertial(even_inertia(goods.shape, goods.mass_kg)));
    out_.line(2,
              "<visual>{}</visual>{}",
              mesh(goods_mesh_file(scene_.catalog[item.sku].sku)),
              collision(id, goods.shape));
    out_.line(1, "</link>");
    const Pose world_from_item = scene::world_from_product(item);
    if (item.facing == scene::no_facing)
      write_mount(id, urdf_room, world_from_item);
    else {
      const std::uint32_t fixture = scene_.shelves[scene_.facings[item.facing].shelf].fixture;
      write_mount(id,
                  scene_.layout.fixtures[fixture].id,
                  inverse(scene::world_from_fixture(scene_, fixture)) * world_from_item);
    }
    out_.line(1,
              "<gazebo reference=\"{0}\"><mu1>{1}</mu1><mu2>{1}</mu2></gazebo>",
              id,
              xml_numbers({goods.contact.sliding}));
  }

  const scene::Scene& scene_;
  const ExportOptions& options_;
  std::string beside_;
  ModelFiles files_;
  std::vector<physics::StandingGoods> goods_;  // by SKU
  std::map<std::string, std::string> colors_;  // a material's name by its colour
  XmlText out_;
};

}  // namespace

Result<ExportFiles> write_urdf(const scene::Scene& scene, const ExportOptions& options) {
  return UrdfWriter(scene, options).write();
}

}  // namespace marketgen::exporters
