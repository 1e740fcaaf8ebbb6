#include <algorithm>
#include <map>
#include <numbers>

#include "base/hash.h"
#include "export/fixture_links.h"
#include "export/material_pictures.h"
#include "export/part_mesh.h"
#include "export/usd_layers.h"
#include "export/usd_solids.h"
#include "physics/goods/contact_shape.h"
#include "scene/articulation.h"

namespace marketgen::exporters {
namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr std::size_t module_hash_letters = 12;

// Writes each distinct body as an asset of its own.
class ModuleWriter {
 public:
  explicit ModuleWriter(UsdParts& parts) : parts_(parts) {
    out_.append(usd_head("Modules"));
    out_.open("def Xform \"Modules\"", {"kind = \"group\""});
  }

  // A reference to the body's asset.
  Result<std::string> add(const FixtureLink& body) {
    const std::string name = "module_" + hash_of(body).substr(0, module_hash_letters);
    if (known_.insert(name).second) MARKETGEN_CHECK(write(body, name));
    return fmt::format("@./modules.usda@</Modules/{}>", name);
  }

  std::string take() {
    out_.close();
    return out_.take();
  }

 private:
  // Of the parts without the rows of their fixture and joint.
  std::string hash_of(const FixtureLink& body) const {
    Hasher hash;
    for (const std::uint32_t row : body.parts) {
      scene::ScenePart part = parts_.scene.parts[row];
      part.fixture = 0;
      part.joint = -1;
      hash.add_bytes(std::as_bytes(std::span(&part, 1)));
    }
    const Pose& p = body.fixture_from_link;
    for (const double v : {p.position.x,
                           p.position.y,
                           p.position.z,
                           p.rotation.w,
                           p.rotation.x,
                           p.rotation.y,
                           p.rotation.z})
      hash.add_rounded(v, 1e-7);
    return hash.hex();
  }

  Result<void> write(const FixtureLink& body, const std::string& name) {
    const std::string path = "/Modules/" + name;
    const Pose body_from_fixture = inverse(body.fixture_from_link);
    UsdLooks looks(parts_.pictures);
    Mesh mesh;
    std::vector<int> by_surface;
    std::vector<std::uint32_t> pieces;
    for (const std::uint32_t row : body.parts) {
      pieces.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      MARKETGEN_CHECK(add_to(mesh, by_surface, looks, parts_.scene.parts[row], body_from_fixture));
    }
    std::vector<bool> textured;
    for (const int look : by_surface)
      textured.push_back(looks.textured(look));
    const UsdShape shape = parts_.geometry.add("module", usd_meshes(mesh, textured, pieces));
    out_.open(fmt::format("def Xform \"{}\"", name), {"kind = \"subcomponent\""});
    write_usd_pose(out_, {});
    out_.open("def Xform \"look\"", {"prepend references = " + shape.reference});
    UsdLooks::write_bindings(out_, path, shape, by_surface);
    out_.close();
    looks.write(out_, path, physics::still_friction);
    UsdNames names;
    for (const std::uint32_t row : body.parts) {
      const scene::ScenePart& part = parts_.scene.parts[row];
      write_usd_collider(out_,
                         parts_.geometry,
                         names.of(name_of(part.unit)),
                         body_from_fixture * physics::contact_shape_of(part),
                         UsdContact{usd_contact_material(path)});
    }
    out_.close();
    return {};
  }

  Result<void> add_to(Mesh& mesh,
                      std::vector<int>& by_surface,
                      UsdLooks& looks,
                      const scene::ScenePart& part,
                      const Pose& body_from_fixture) {
    int look = -1;
    double repeat_m = 1;
    if (part.material < 0)
      look = looks.add(part_surface(part));
    else {
      const catalog::MaterialRow& row =
          parts_.scene.materials[static_cast<std::size_t>(part.material)];
      MARKETGEN_TRY(look, looks.add_tiled(row.id));
      repeat_m = material_repeat_m(parts_.scene, row.id);
    }
    const auto known = std::ranges::find(by_surface, look);
    const auto surface = static_cast<std::uint16_t>(known - by_surface.begin());
    if (known == by_surface.end()) by_surface.push_back(look);
    add_part(mesh, part, body_from_fixture * scene::fixture_from_part(part), surface, repeat_m);
    return {};
  }

  UsdParts& parts_;
  UsdText out_;
  std::set<std::string> known_;
};

class UsdFixtureWriter {
 public:
  explicit UsdFixtureWriter(UsdParts& parts)
      : scene_(parts.scene), still_(parts.options.still_fixtures), modules_(parts) {}

  Result<UsdFixtures> write() {
    out_.append(usd_head("Shop"));
    out_.open("over \"Shop\"");
    out_.open("def Xform \"fixtures\"", {"kind = \"group\""});
    UsdNames names;
    for (std::uint32_t f = 0; f < scene_.fixtures.size(); ++f) {
      if (scene_.fixtures[f].part_count > 0)
        MARKETGEN_CHECK(write_fixture(f, names.of(scene_.layout.fixtures[f].id)));
    }
    out_.close();
    out_.close();
    return UsdFixtures{modules_.take(), out_.take()};
  }

 private:
  Result<void> write_fixture(std::uint32_t fixture, const std::string& name) {
    const layout::Fixture& placed = scene_.layout.fixtures[fixture];
    const std::vector<FixtureLink> bodies = fixture_links(scene_, fixture, still_);
    const bool articulated =
        std::ranges::any_of(bodies, [&](const FixtureLink& body) { return moves(scene_, body); });
    const UsdLabels labels{{"class", placed.kind}, {"zone", placed.zone}};
    const std::string root = articulated
                                 ? "\"PhysicsArticulationRootAPI\"" + usd_label_schemas(labels)
                                 : usd_label_schemas(labels).substr(2);
    const std::string path = "/Shop/fixtures/" + name;
    out_.open(fmt::format("def Xform \"{}\"", name),
              {"prepend apiSchemas = [" + root + "]",
               fmt::format("displayName = {}", usd_quoted(placed.id)),
               "kind = \"component\""});
    write_usd_labels(out_, labels);
    const Pose world_from_fixture = scene::world_from_fixture(scene_, fixture);
    write_usd_pose(out_, world_from_fixture);
    names_ = {};
    body_path_.clear();
    for (const FixtureLink& body : bodies) {
      MARKETGEN_CHECK(write_body(body, path, articulated));
    }
    if (articulated) write_anchor(path, world_from_fixture);
    for (const FixtureLink& body : bodies) {
      if (moves(scene_, body)) write_joint(body);
    }
    out_.close();
    return {};
  }

  Result<void> write_body(const FixtureLink& body, const std::string& path, bool articulated) {
    MARKETGEN_TRY(const std::string reference, modules_.add(body));
    const bool is_base = body.joint < 0;
    const std::string name = names_.of(is_base ? "body" : joint_of(scene_, body).name);
    body_path_[body.joint] = path + "/" + name;
    std::vector<std::string> metadata{"instanceable = true", "prepend references = " + reference};
    if (!is_base)
      metadata.emplace_back("prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"]");
    else if (articulated)
      metadata.emplace_back("prepend apiSchemas = [\"PhysicsRigidBodyAPI\"]");
    if (!is_base)
      metadata.push_back(fmt::format("displayName = {}",
                                     usd_quoted(scene::joint_id(scene_, joint_of(scene_, body)))));
    out_.open(fmt::format("def \"{}\"", name), metadata);
    if (!is_base) {
      const scene::SceneJoint& joint = joint_of(scene_, body);
      if (joint.kind == assets::JointKind::belt) write_belt(joint);
      out_.line("float physics:mass = {}", joint.mass_kg);
    }
    out_.line("quatd xformOp:orient = {}", usd_orient(body.fixture_from_link.rotation));
    out_.line("double3 xformOp:translate = {}", usd_vector(body.fixture_from_link.position));
    out_.close();
    return {};
  }

  // Its body stands still and what lies on it is carried along: UsdPhysics has no word for that.
  void write_belt(const scene::SceneJoint& joint) {
    out_.line("custom uniform token marketgen:joint:kind = \"belt\"");
    out_.line("custom float marketgen:joint:max = {}", joint.upper);
    out_.line("custom float marketgen:joint:min = {}", joint.lower);
    out_.line("bool physics:kinematicEnabled = 1");
  }

  // Holds the fixture's body to the floor.
  void write_anchor(const std::string& path, const Pose& world_from_fixture) {
    out_.open("def PhysicsFixedJoint \"anchor\"");
    out_.line("rel physics:body1 = <{}/body>", path);
    write_frames(world_from_fixture, {});
    out_.close();
  }

  void write_frames(const Pose& in_0, const Pose& in_1) {
    out_.line("point3f physics:localPos0 = {}", usd_vector(in_0.position));
    out_.line("point3f physics:localPos1 = {}", usd_vector(in_1.position));
    out_.line("quatf physics:localRot0 = {}", usd_quaternion(in_0.rotation));
    out_.line("quatf physics:localRot1 = {}", usd_quaternion(in_1.rotation));
  }

  // UsdPhysics counts in degrees, a drive's stiffness and damping as well.
  void write_joint(const FixtureLink& body) {
    const scene::SceneJoint& joint = joint_of(scene_, body);
    const bool hinge = joint.kind == assets::JointKind::hinge;
    const double unit = hinge ? degrees : 1;
    const char* drive = hinge ? "angular" : "linear";
    out_.open(fmt::format("def Physics{}Joint \"{}\"",
                          hinge ? "Revolute" : "Prismatic",
                          names_.of("joint/" + joint.name)),
              {fmt::format("prepend apiSchemas = [\"PhysicsDriveAPI:{}\"]", drive),
               fmt::format("displayName = {}", usd_quoted(scene::joint_id(scene_, joint)))});
    out_.line(
        "float drive:{}:physics:damping = {}", drive, static_cast<float>(joint.damping / unit));
    out_.line(
        "float drive:{}:physics:stiffness = {}", drive, static_cast<float>(joint.stiffness / unit));
    out_.line("float drive:{}:physics:targetPosition = {}",
              drive,
              static_cast<float>(joint.spring_rest * unit));
    out_.line("uniform token drive:{}:physics:type = \"force\"", drive);
    out_.line("custom float marketgen:joint:friction = {}", joint.friction);
    out_.line("custom float marketgen:joint:gasket = {}", joint.gasket);
    out_.line("custom float marketgen:joint:gasketReach = {}", joint.gasket_reach);
    out_.line("custom float marketgen:joint:holdOpenFactor = {}",
              static_cast<float>(hold_open_factor(joint)));
    out_.line("uniform token physics:axis = \"Z\"");
    out_.line("rel physics:body0 = <{}>", body_path_.at(joint.parent));
    out_.line("rel physics:body1 = <{}>", body_path_.at(body.joint));
    const Pose fixture_from_parent =
        joint.parent < 0
            ? Pose{}
            : scene::fixture_from_joint(scene_.joints[static_cast<std::size_t>(joint.parent)]);
    write_frames(inverse(fixture_from_parent) * body.fixture_from_link, {});
    if (!hinge || !turns_endlessly(joint)) {  // none said: none there
      out_.line("float physics:lowerLimit = {}", static_cast<float>(joint.lower * unit));
      out_.line("float physics:upperLimit = {}", static_cast<float>(joint.upper * unit));
    }
    out_.close();
  }

  const scene::Scene& scene_;
  bool still_;
  ModuleWriter modules_;
  UsdText out_;
  UsdNames names_;                        // of the open fixture's children
  std::map<int, std::string> body_path_;  // of the open fixture, by joint; -1 its own body
};

}  // namespace

Result<UsdFixtures> usd_fixtures(UsdParts& parts) {
  return UsdFixtureWriter(parts).write();
}

}  // namespace marketgen::exporters
