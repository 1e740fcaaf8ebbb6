#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "base/gravity.h"
#include "base/text.h"
#include "export/body_inertia.h"
#include "export/exporter.h"
#include "export/fixture_links.h"
#include "export/joint_extras.h"
#include "export/material_pictures.h"
#include "export/model_files.h"
#include "export/named_solids.h"
#include "export/sdf_names.h"
#include "export/xml_text.h"
#include "physics/goods/standing_goods.h"
#include "scene/placements.h"

// The store as one world: a model for the room, for every fixture, for what stands in a fixture,
// and for every item that is free. libsdformat takes 2.6 ms for a model and 0.5 ms for a visual
// with a collision, which is why standing goods share a link.
namespace marketgen::exporters {
namespace {

constexpr std::string_view static_model = "<static>true</static>";

// Empty for a frame that is its owner's.
std::string sdf_pose(const Pose& pose) {
  const std::string numbers = xml_vector(pose.position) + " " + xml_rpy(pose.rotation);
  return numbers == "0 0 0 0 0 0" ? "" : fmt::format("<pose>{}</pose>", numbers);
}

std::string sdf_inertial(const BodyInertia& body) {
  constexpr std::array names{"ixx", "iyy", "izz", "ixy", "ixz", "iyz"};
  std::string moments;
  for (std::size_t i = 0; i < names.size(); ++i)
    moments += fmt::format("<{0}>{1}</{0}>", names[i], xml_numbers({body.moments_kg_m2[i]}));
  return fmt::format("<inertial>{}<mass>{}</mass><inertia>{}</inertia></inertial>",
                     sdf_pose({body.center, {}}),
                     xml_numbers({body.mass_kg}),
                     moments);
}

std::string sdf_geometry(const assets::ContactShape& shape) {
  const Vec3& s = shape.size;
  switch (shape.shape) {
    case assets::CollisionShape::box:
      return fmt::format("<geometry><box><size>{}</size></box></geometry>", xml_vector(s * 2));
    case assets::CollisionShape::cylinder:
      return fmt::format(
          "<geometry><cylinder><radius>{}</radius><length>{}</length></cylinder></geometry>",
          xml_numbers({s.x}),
          xml_numbers({2 * s.y}));
    case assets::CollisionShape::ellipsoid:
      break;
  }
  return fmt::format("<geometry><ellipsoid><radii>{}</radii></ellipsoid></geometry>",
                     xml_vector(s));
}

std::string sdf_collision(std::string_view name,
                          const assets::ContactShape& shape,
                          std::string_view surface = {}) {
  return fmt::format("<collision name=\"{}\">{}{}{}</collision>",
                     name,
                     sdf_pose(shape.pose),
                     sdf_geometry(shape),
                     surface);
}

std::string sdf_friction(double sliding) {
  return fmt::format(
      "<surface><friction><ode><mu>{0}</mu><mu2>{0}</mu2></ode></friction></surface>",
      xml_numbers({sliding}));
}

std::string sdf_material(const scene::ScenePart& part) {
  const std::string color = xml_color({part.color[0], part.color[1], part.color[2]}, 1);
  return fmt::format("<material><ambient>{0}</ambient><diffuse>{0}</diffuse></material>{1}",
                     color,
                     part.kind == assets::SurfaceKind::glass
                         ? fmt::format("<transparency>{}</transparency>", 1 - glass_alpha)
                         : "");
}

class SdfWriter {
 public:
  SdfWriter(const scene::Scene& scene, const ExportOptions& options)
      : scene_(scene),
        options_(options),
        free_(products_in_free_region(scene, options)),
        beside_(escaped_markup(options.beside)) {}

  Result<ExportFiles> write() {
    MARKETGEN_TRY(files_, ModelFiles::make(scene_));
    for (const catalog::Product& product : scene_.catalog) {
      MARKETGEN_TRY(goods_.emplace_back(), physics::standing_goods(product));
    }
    out_.line(0, "<?xml version=\"1.0\"?>");
    out_.line(0, "<sdf version=\"1.9\" xmlns:marketgen=\"urn:marketgen\">");
    out_.line(0, "<world name=\"{}\">", sdf_world);
    write_world();
    write_room();
    for (std::uint32_t f = 0; f < scene_.fixtures.size(); ++f) {
      if (scene_.fixtures[f].part_count > 0) write_fixture(f);
    }
    write_standing();
    for (std::uint32_t row = 0; row < scene_.products.size(); ++row) {
      if (free_[row]) write_free(row);
    }
    out_.line(0, "</world>");
    out_.line(0, "</sdf>");
    return ExportFiles{out_.take(), files_.take()};
  }

 private:
  void write_world() {
    out_.line(1, "<gravity>0 0 {}</gravity>", -standard_gravity);
    out_.line(1, "<scene><ambient>0.6 0.6 0.6 1</ambient><shadows>false</shadows></scene>");
    out_.line(1,
              "<light name=\"lamp\" type=\"directional\"><cast_shadows>false</cast_shadows>"
              "<direction>0.3 0.2 -1</direction><diffuse>0.6 0.6 0.6 1</diffuse></light>");
    std::vector<bool> stands(scene_.catalog.size(), false);
    for (std::uint32_t row = 0; row < scene_.products.size(); ++row) {
      if (!free_[row]) stands[scene_.products[row].sku] = true;
    }
    for (std::size_t sku = 0; sku < stands.size(); ++sku) {
      if (stands[sku])
        out_.line(1,
                  "<{} name=\"{}\" mass_kg=\"{}\"/>",
                  sdf_sku,
                  scene_.catalog[sku].sku,
                  xml_numbers({goods_[sku].mass_kg}));
    }
  }

  std::string visual_of(std::string_view name, std::string_view file, const Pose& pose) const {
    return fmt::format(
        "<visual name=\"{}{}\">{}<geometry><mesh><uri>{}/{}</uri></mesh></geometry></visual>",
        name,
        sdf_look,
        sdf_pose(pose),
        beside_,
        file);
  }

  void write_room() {
    out_.line(1, "<model name=\"{0}\">{1}<link name=\"{0}\">", sdf_room, static_model);
    for (const ModelFiles::RoomMesh& surface : files_.room())
      out_.line(2, "{}", visual_of(surface.surface, surface.file, {}));
    for (const NamedSolid& solid : room_solids(scene_.layout.shell))
      out_.line(2, "{}", sdf_collision(solid.name, solid.shape));
    out_.line(1, "</link></model>");
  }

  void write_fixture(std::uint32_t fixture) {
    const std::vector<FixtureLink> links = fixture_links(scene_, fixture, options_.still_fixtures);
    const bool articulated =
        std::ranges::any_of(links, [&](const FixtureLink& link) { return moves(scene_, link); });
    out_.line(1,
              "<model name=\"{}\">{}{}",
              scene_.layout.fixtures[fixture].id,
              articulated ? "" : static_model,
              sdf_pose(scene::world_from_fixture(scene_, fixture)));
    for (const FixtureLink& link : links)
      write_link(link);
    if (articulated)
      out_.line(2,
                "<joint name=\"{0}{1}\" type=\"fixed\"><parent>world</parent><child>{0}</child>"
                "</joint>",
                sdf_body,
                sdf_mount);
    for (const FixtureLink& link : links) {
      if (link.joint >= 0) write_joint(joint_of(scene_, link));
    }
    out_.line(1, "</model>");
  }

  // Of what this joint moves; of the fixture itself for -1.
  std::string link_name(int joint) const {
    return joint < 0 ? std::string(sdf_body)
                     : scene_.joints[static_cast<std::size_t>(joint)].name + std::string(sdf_link);
  }

  void write_link(const FixtureLink& link) {
    out_.line(2, "<link name=\"{}\">{}", link_name(link.joint), sdf_pose(link.fixture_from_link));
    if (link.joint >= 0)
      out_.line(3, "{}", sdf_inertial(inertia_of(scene_, joint_of(scene_, link), link.parts)));
    const Pose link_from_fixture = inverse(link.fixture_from_link);
    for (const std::uint32_t row : link.parts) {
      const assets::ContactShape shape =
          link_from_fixture * physics::contact_shape_of(scene_.parts[row]);
      const std::string part = part_name(scene_, row);
      out_.line(3,
                "<visual name=\"{}{}\">{}{}{}</visual>",
                part,
                sdf_look,
                sdf_pose(shape.pose),
                sdf_geometry(shape),
                sdf_material(scene_.parts[row]));
      out_.line(3, "{}", sdf_collision(part, shape));
    }
    out_.line(2, "</link>");
  }

  // A joint's frame is that of the link that it moves.
  void write_joint(const scene::SceneJoint& joint) {
    const std::string_view type = joint_type(joint);
    out_.line(2,
              "<joint name=\"{0}\" type=\"{1}\"><parent>{2}</parent><child>{0}{3}</child>",
              joint.name,
              type,
              link_name(joint.parent),
              sdf_link);
    if (type != "fixed") {
      const std::string limits =
          type == "continuous"
              ? ""
              : fmt::format("<lower>{}</lower><upper>{}</upper>", joint.lower, joint.upper);
      out_.line(3,
                "<axis><xyz>0 0 1</xyz><limit>{}</limit><dynamics><damping>{}</damping>"
                "<friction>{}</friction><spring_reference>{}</spring_reference>"
                "<spring_stiffness>{}</spring_stiffness></dynamics></axis>",
                limits,
                joint.damping,
                joint.friction,
                joint.spring_rest,
                joint.stiffness);
    }
    if (const std::string extras = joint_extras(joint); !extras.empty())
      out_.line(3, "<{} {}/>", sdf_joint, extras);
    out_.line(2, "</joint>");
  }

  // One model a fixture, in its frame; goods that stand in none are the room's, in the store frame.
  void write_standing() {
    constexpr std::int64_t of_room = -1;
    std::map<std::int64_t, std::vector<std::uint32_t>> rows_in;
    for (std::uint32_t row = 0; row < scene_.products.size(); ++row) {
      const std::uint32_t facing = scene_.products[row].facing;
      if (free_[row]) continue;
      rows_in[facing == scene::no_facing
                  ? of_room
                  : std::int64_t{scene_.shelves[scene_.facings[facing].shelf].fixture}]
          .push_back(row);
    }
    for (const auto& [owner, rows] : rows_in) {
      const auto fixture = static_cast<std::uint32_t>(owner);
      const bool room = owner == of_room;
      write_standing(room ? sdf_room : std::string_view(scene_.layout.fixtures[fixture].id),
                     room ? Pose{} : scene::world_from_fixture(scene_, fixture),
                     rows);
    }
  }

  void write_standing(std::string_view owner,
                      const Pose& world_from_owner,
                      const std::vector<std::uint32_t>& rows) {
    out_.line(1,
              "<model name=\"{0}/{1}\">{2}{3}<link name=\"{1}\">",
              owner,
              sdf_goods,
              static_model,
              sdf_pose(world_from_owner));
    const Pose owner_from_world = inverse(world_from_owner);
    for (const std::uint32_t row : rows)
      write_item(row, owner_from_world * scene::world_from_product(scene_.products[row]));
    out_.line(1, "</link></model>");
  }

  void write_item(std::uint32_t row, const Pose& link_from_item) {
    const std::uint32_t sku = scene_.products[row].sku;
    const std::string id = scene::product_id(scene_, row);
    out_.line(2, "{}", visual_of(id, goods_mesh_file(scene_.catalog[sku].sku), link_from_item));
    out_.line(
        2,
        "{}",
        sdf_collision(
            id, link_from_item * goods_[sku].shape, sdf_friction(goods_[sku].contact.sliding)));
  }

  void write_free(std::uint32_t row) {
    const scene::SceneProduct& item = scene_.products[row];
    const physics::StandingGoods& goods = goods_[item.sku];
    out_.line(1,
              "<model name=\"{}\">{}<link name=\"{}\">",
              scene::product_id(scene_, row),
              sdf_pose(scene::world_from_product(item)),
              sdf_item);
    out_.line(2, "{}", sdf_inertial(even_inertia(goods.shape, goods.mass_kg)));
    write_item(row, {});
    out_.line(1, "</link>");
    if (hangs_on_peg(scene_, row))
      out_.line(2,
                "<joint name=\"{}\" type=\"ball\"><parent>world</parent><child>{}</child>{}"
                "</joint>",
                sdf_hook,
                sdf_item,
                sdf_pose({{0, 0, scene_.catalog[item.sku].height_m()}, {}}));
    out_.line(1, "</model>");
  }

  const scene::Scene& scene_;
  const ExportOptions& options_;
  std::vector<bool> free_;
  std::string beside_;
  ModelFiles files_;
  std::vector<physics::StandingGoods> goods_;  // by SKU
  XmlText out_;
};

}  // namespace

Result<ExportFiles> write_sdf(const scene::Scene& scene, const ExportOptions& options) {
  return SdfWriter(scene, options).write();
}

}  // namespace marketgen::exporters
