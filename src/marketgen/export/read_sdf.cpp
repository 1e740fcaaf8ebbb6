#include <fmt/format.h>

#include <map>

#include "export/exporter.h"
#include "export/fixture_links.h"
#include "export/joint_extras.h"
#include "export/named_solids.h"
#include "export/read_goods.h"
#include "export/read_xml.h"
#include "export/sdf_names.h"

// Reads an SDF export model by model, with tinyxml2.
namespace marketgen::exporters {
namespace {

using tinyxml2::XMLElement;

class SdfReader {
 public:
  explicit SdfReader(XmlFile xml) : xml_(std::move(xml)) {}

  Result<ExportContents> read() {
    contents_.joints.emplace();
    contents_.parts.emplace();
    contents_.free_bodies = 0;
    MARKETGEN_TRY(const XMLElement* world, xml_.child(xml_.root(), "world"));
    for (const XMLElement* row : children(*world, sdf_sku)) {
      MARKETGEN_TRY(const std::string sku, xml_.attribute(*row, "name"));
      MARKETGEN_TRY(mass_kg_[sku], xml_.attribute_number(*row, "mass_kg"));
    }
    for (const XMLElement* model : children(*world, "model")) {
      MARKETGEN_CHECK(read_model(*model));
    }
    contents_.goods = goods_.take();
    return std::move(contents_);
  }

 private:
  Result<Pose> pose_of(const XMLElement& owner) const {
    const XMLElement* pose = owner.FirstChildElement("pose");
    if (pose == nullptr) return Pose{};
    MARKETGEN_TRY(const std::vector<double> numbers, xml_.numbers(*pose, pose->GetText(), 6));
    return pose_from_xyz_rpy(numbers);
  }

  Result<Vec3> child_vector(const XMLElement& parent, const char* name) const {
    MARKETGEN_TRY(const XMLElement* element, xml_.child(parent, name));
    MARKETGEN_TRY(const std::vector<double> n, xml_.numbers(*element, element->GetText(), 3));
    return Vec3{n[0], n[1], n[2]};
  }

  static bool is_static(const XMLElement& model) {
    const XMLElement* element = model.FirstChildElement("static");
    return element != nullptr && element->BoolText();
  }

  // In the frame of the collision's link.
  Result<assets::ContactShape> solid_of(const XMLElement& collision) const {
    MARKETGEN_TRY(const Pose pose, pose_of(collision));
    MARKETGEN_TRY(const XMLElement* geometry, xml_.child(collision, "geometry"));
    if (const XMLElement* box = geometry->FirstChildElement("box")) {
      MARKETGEN_TRY(const Vec3 size, child_vector(*box, "size"));
      return assets::ContactShape{assets::CollisionShape::box, pose, size * 0.5};
    }
    if (const XMLElement* round = geometry->FirstChildElement("cylinder")) {
      MARKETGEN_TRY(const double radius, xml_.child_number(*round, "radius"));
      MARKETGEN_TRY(const double length, xml_.child_number(*round, "length"));
      return assets::ContactShape{assets::CollisionShape::cylinder, pose, {radius, length / 2, 0}};
    }
    MARKETGEN_TRY(const XMLElement* ball, xml_.child(*geometry, "ellipsoid"));
    MARKETGEN_TRY(const Vec3 radii, child_vector(*ball, "radii"));
    return assets::ContactShape{assets::CollisionShape::ellipsoid, pose, radii};
  }

  Result<double> mass_of(const XMLElement& link) const {
    MARKETGEN_TRY(const XMLElement* inertial, xml_.child(link, "inertial"));
    return xml_.child_number(*inertial, "mass");
  }

  Result<void> read_model(const XMLElement& model) {
    MARKETGEN_TRY(const std::string name, xml_.attribute(model, "name"));
    MARKETGEN_TRY(const Pose world, pose_of(model));
    MARKETGEN_TRY(const XMLElement* link, xml_.child(model, "link"));
    MARKETGEN_TRY(const std::string first, xml_.attribute(*link, "name"));
    if (first == sdf_body) return read_fixture(model, name, world);
    const bool is_free = first == sdf_item;
    if (is_static(model) == is_free)
      return xml_.fault(model, is_free ? "a free item is static" : "it is not static");
    contents_.meshes += children(*link, "visual").size();
    if (first == sdf_room) return read_solids(*link, world, "");
    if (!is_free && first != sdf_goods)
      return xml_.fault(*link, "it belongs to no fixture, no goods and no room");
    if (is_free) ++*contents_.free_bodies;
    return read_goods(*link, world, is_free);
  }

  // `fixture` is empty for the room.
  Result<void> read_solids(const XMLElement& link, const Pose& world, const std::string& fixture) {
    for (const XMLElement* collision : children(link, "collision")) {
      MARKETGEN_TRY(const std::string name, xml_.attribute(*collision, "name"));
      if (fixture.empty() && name == floor_solid) continue;
      MARKETGEN_TRY(const assets::ContactShape solid, solid_of(*collision));
      const assets::ContactShape placed = world * solid;
      include_solid(contents_.bounds, placed);
      if (!fixture.empty()) contents_.parts->emplace(fmt::format("{}/{}", fixture, name), placed);
    }
    return {};
  }

  Result<void> read_fixture(const XMLElement& model, const std::string& name, const Pose& world) {
    if (!contents_.fixtures.insert(name).second)
      return xml_.fault(model, "model \"" + name + "\" occurs twice");
    std::map<std::string, std::pair<const XMLElement*, Pose>> links;  // with their world pose
    for (const XMLElement* link : children(model, "link")) {
      MARKETGEN_TRY(const std::string called, xml_.attribute(*link, "name"));
      MARKETGEN_TRY(const Pose pose, pose_of(*link));
      contents_.meshes += children(*link, "visual").size();
      MARKETGEN_CHECK(read_solids(*link, world * pose, name));
      if (!links.emplace(called, std::pair(link, world * pose)).second)
        return xml_.fault(*link, "link \"" + called + "\" occurs twice");
    }
    const bool still = is_static(model);
    bool mounted = still;
    for (const XMLElement* joint : children(model, "joint")) {
      MARKETGEN_TRY(const XMLElement* parent, xml_.child(*joint, "parent"));
      MARKETGEN_TRY(const XMLElement* child, xml_.child(*joint, "child"));
      const std::string from = text_of(*parent), to = text_of(*child);
      const auto moved = links.find(to);
      if (moved == links.end()) return xml_.fault(*child, "there is no link \"" + to + "\"");
      if (from == "world") {
        mounted = mounted || joint->Attribute("type", "fixed") != nullptr;
        continue;
      }
      if (still && joint->Attribute("type", "fixed") == nullptr)
        return xml_.fault(*joint, "nothing moves in a static model");
      if (!links.contains(from)) return xml_.fault(*parent, "there is no link \"" + from + "\"");
      MARKETGEN_CHECK(read_joint(*joint, name, *moved->second.first, moved->second.second));
    }
    if (!mounted) return xml_.fault(model, "\"" + name + "\" is not fixed to the world");
    return {};
  }

  static std::string text_of(const XMLElement& element) {
    const char* text = element.GetText();
    return text == nullptr ? "" : text;
  }

  Result<void> read_joint(const XMLElement& element,
                          const std::string& fixture,
                          const XMLElement& link,
                          const Pose& world) {
    ExportedJoint joint;
    MARKETGEN_TRY(const std::string type, xml_.attribute(element, "type"));
    MARKETGEN_TRY(const std::string name, xml_.attribute(element, "name"));
    joint.name = fixture + "/" + name;
    joint.kind = joint_kind_of(type);
    joint.at = world.position;
    joint.axis = rotate(world.rotation, {0, 0, 1});
    MARKETGEN_TRY(joint.mass_kg, mass_of(link));
    const XMLElement* extras = element.FirstChildElement(sdf_joint);
    if (extras != nullptr) MARKETGEN_CHECK(read_joint_extras(xml_, *extras, joint));
    if ((type == "fixed") != (joint.kind == assets::JointKind::belt))
      return xml_.fault(element, "what is fixed is a belt, and only that");
    if (type != "fixed") MARKETGEN_CHECK(read_motion(element, type, joint));
    contents_.joints->push_back(std::move(joint));
    return {};
  }

  Result<void> read_motion(const XMLElement& element,
                           const std::string& type,
                           ExportedJoint& joint) const {
    MARKETGEN_TRY(const XMLElement* axis, xml_.child(element, "axis"));
    MARKETGEN_TRY(const Vec3 along, child_vector(*axis, "xyz"));
    if (length(along - Vec3{0, 0, 1}) > 0) return xml_.fault(*axis, "it is not Z");
    MARKETGEN_TRY(const XMLElement* limit, xml_.child(*axis, "limit"));
    if (type == "continuous") {
      joint.lower = no_lower_limit;
      joint.upper = no_upper_limit;
    } else {
      MARKETGEN_TRY(joint.lower, xml_.child_number(*limit, "lower"));
      MARKETGEN_TRY(joint.upper, xml_.child_number(*limit, "upper"));
    }
    MARKETGEN_TRY(const XMLElement* dynamics, xml_.child(*axis, "dynamics"));
    MARKETGEN_TRY(joint.damping, xml_.child_number(*dynamics, "damping"));
    MARKETGEN_TRY(joint.friction, xml_.child_number(*dynamics, "friction"));
    MARKETGEN_TRY(joint.stiffness, xml_.child_number(*dynamics, "spring_stiffness"));
    MARKETGEN_TRY(joint.spring_rest, xml_.child_number(*dynamics, "spring_reference"));
    return {};
  }

  // Every visual is an item; its solid is the collision of its name.
  Result<void> read_goods(const XMLElement& link, const Pose& world, bool is_free) {
    std::map<std::string, const XMLElement*> collisions;
    for (const XMLElement* collision : children(link, "collision")) {
      MARKETGEN_TRY(const std::string name, xml_.attribute(*collision, "name"));
      if (!collisions.emplace(name, collision).second)
        return xml_.fault(*collision, "collision \"" + name + "\" occurs twice");
    }
    const std::vector<const XMLElement*> visuals = children(link, "visual");
    if (visuals.size() != collisions.size())
      return xml_.fault(link,
                        fmt::format("{} looks and {} solids", visuals.size(), collisions.size()));
    for (const XMLElement* visual : visuals) {
      MARKETGEN_TRY(std::string id, xml_.attribute(*visual, "name"));
      if (!id.ends_with(sdf_look)) return xml_.fault(*visual, "\"" + id + "\" is no item's look");
      id.resize(id.size() - sdf_look.size());
      const auto collision = collisions.find(id);
      if (collision == collisions.end()) return xml_.fault(*visual, "\"" + id + "\" has no solid");
      MARKETGEN_CHECK(read_item(*visual, *collision->second, id, world, is_free ? &link : nullptr));
    }
    return {};
  }

  // `free_link` has the mass of a free item; null for one that stands.
  Result<void> read_item(const XMLElement& visual,
                         const XMLElement& collision,
                         const std::string& id,
                         const Pose& world,
                         const XMLElement* free_link) {
    MARKETGEN_TRY(const std::string sku, sku_of(visual));
    MARKETGEN_TRY(const Pose link_from_item, pose_of(visual));
    MARKETGEN_TRY(const assets::ContactShape solid, solid_of(collision));
    MARKETGEN_TRY(const double friction, friction_of(collision));
    double mass = 0;
    if (free_link != nullptr) {
      MARKETGEN_TRY(mass, mass_of(*free_link));
    } else if (const auto row = mass_kg_.find(sku); row != mass_kg_.end()) {
      mass = row->second;
    } else {
      return xml_.fault(visual, fmt::format("there is no <{}> of \"{}\"", sdf_sku, sku));
    }
    const Pose placed = world * link_from_item;
    contents_.products.push_back({id, sku, placed.position, placed.rotation});
    goods_.add({sku, mass, friction, inverse(link_from_item) * solid});
    return {};
  }

  Result<std::string> sku_of(const XMLElement& visual) const {
    MARKETGEN_TRY(const XMLElement* geometry, xml_.child(visual, "geometry"));
    MARKETGEN_TRY(const XMLElement* mesh, xml_.child(*geometry, "mesh"));
    MARKETGEN_TRY(const XMLElement* uri, xml_.child(*mesh, "uri"));
    return std::filesystem::path(text_of(*uri)).parent_path().filename().string();
  }

  Result<double> friction_of(const XMLElement& collision) const {
    const XMLElement* at = &collision;
    for (const char* name : {"surface", "friction", "ode"}) {
      MARKETGEN_TRY(at, xml_.child(*at, name));
    }
    return xml_.child_number(*at, "mu");
  }

  XmlFile xml_;
  std::map<std::string, double> mass_kg_;  // by SKU, of what stands
  GoodsReader goods_;
  ExportContents contents_;
};

}  // namespace

Result<ExportContents> read_sdf(const std::filesystem::path& file,
                                const std::vector<catalog::Product>& /*catalog*/) {
  MARKETGEN_TRY(XmlFile xml, XmlFile::read(file, "sdf"));
  return SdfReader(std::move(xml)).read();
}

}  // namespace marketgen::exporters
