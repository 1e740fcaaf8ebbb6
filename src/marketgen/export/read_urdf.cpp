#include <fmt/format.h>

#include <cmath>
#include <map>

#include "export/exporter.h"
#include "export/fixture_links.h"
#include "export/joint_extras.h"
#include "export/named_solids.h"
#include "export/read_goods.h"
#include "export/read_xml.h"
#include "export/urdf_names.h"

// Reads a URDF export by walking its tree from the root, with tinyxml2.
namespace marketgen::exporters {
namespace {

using tinyxml2::XMLElement;

class UrdfReader {
 public:
  explicit UrdfReader(XmlFile xml) : xml_(std::move(xml)) {}

  Result<ExportContents> read() {
    contents_.joints.emplace();
    contents_.parts.emplace();
    contents_.free_bodies = 0;
    MARKETGEN_CHECK(index());
    std::vector<Open> open{{std::string(urdf_room), "", Pose{}}};
    std::size_t walked = 0;
    for (; !open.empty(); ++walked) {
      const Open at = open.back();
      open.pop_back();
      MARKETGEN_CHECK(read_link(at));
      for (const XMLElement* joint : carried_by_[at.link]) {
        MARKETGEN_TRY(const Pose parent_from_child, origin_of(*joint));
        MARKETGEN_TRY(const std::string child, end_of(*joint, "child"));
        const Pose pose = at.pose * parent_from_child;
        MARKETGEN_CHECK(read_joint(*joint, child, pose));
        open.push_back({child, child.ends_with(urdf_link) ? at.fixture : child, pose});
      }
    }
    if (walked != links_.size())
      return xml_.fault(xml_.root(),
                        fmt::format("{} links do not hang on the room", links_.size() - walked));
    contents_.goods = goods_.take();
    return std::move(contents_);
  }

 private:
  // A link on the way down, and the fixture that it is part of: what a joint moves is its parent's.
  struct Open {
    std::string link, fixture;
    Pose pose;  // store frame
  };

  Result<std::string> end_of(const XMLElement& joint, const char* which) const {
    MARKETGEN_TRY(const XMLElement* element, xml_.child(joint, which));
    return xml_.attribute(*element, "link");
  }

  Result<void> index() {
    for (const XMLElement* link : children(xml_.root(), "link")) {
      MARKETGEN_TRY(std::string name, xml_.attribute(*link, "name"));
      if (!links_.emplace(name, link).second)
        return xml_.fault(*link, "link \"" + name + "\" occurs twice");
    }
    std::map<std::string, int> parents;
    for (const XMLElement* joint : children(xml_.root(), "joint")) {
      MARKETGEN_TRY(const std::string parent, end_of(*joint, "parent"));
      MARKETGEN_TRY(const std::string child, end_of(*joint, "child"));
      if (++parents[child] > 1) return xml_.fault(*joint, "link \"" + child + "\" has two parents");
      carried_by_[parent].push_back(joint);
    }
    for (const XMLElement* more : children(xml_.root(), "gazebo")) {
      MARKETGEN_TRY(const std::string of, xml_.attribute(*more, "reference"));
      gazebo_.emplace(of, more);
    }
    for (const XMLElement* more : children(xml_.root(), "marketgen")) {
      MARKETGEN_TRY(const std::string of, xml_.attribute(*more, "joint"));
      own_.emplace(of, more);
    }
    return {};
  }

  Result<Pose> origin_of(const XMLElement& owner) const {
    const XMLElement* origin = owner.FirstChildElement("origin");
    if (origin == nullptr) return Pose{};
    const char* turn = origin->Attribute("rpy");
    MARKETGEN_TRY(std::vector<double> numbers, xml_.numbers(*origin, origin->Attribute("xyz"), 3));
    MARKETGEN_TRY(const std::vector<double> rpy,
                  xml_.numbers(*origin, turn == nullptr ? "0 0 0" : turn, 3));
    numbers.insert(numbers.end(), rpy.begin(), rpy.end());
    return pose_from_xyz_rpy(numbers);
  }

  // A mesh is a ball, scaled to half axes.
  Result<assets::ContactShape> solid_of(const XMLElement& collision) const {
    MARKETGEN_TRY(const Pose pose, origin_of(collision));
    MARKETGEN_TRY(const XMLElement* geometry, xml_.child(collision, "geometry"));
    if (const XMLElement* box = geometry->FirstChildElement("box")) {
      MARKETGEN_TRY(const auto size, xml_.numbers(*box, box->Attribute("size"), 3));
      return assets::ContactShape{
          assets::CollisionShape::box, pose, {size[0] / 2, size[1] / 2, size[2] / 2}};
    }
    if (const XMLElement* round = geometry->FirstChildElement("cylinder")) {
      MARKETGEN_TRY(const double radius, xml_.attribute_number(*round, "radius"));
      MARKETGEN_TRY(const double length, xml_.attribute_number(*round, "length"));
      return assets::ContactShape{assets::CollisionShape::cylinder, pose, {radius, length / 2, 0}};
    }
    MARKETGEN_TRY(const XMLElement* mesh, xml_.child(*geometry, "mesh"));
    MARKETGEN_TRY(const auto size, xml_.numbers(*mesh, mesh->Attribute("scale"), 3));
    return assets::ContactShape{
        assets::CollisionShape::ellipsoid, pose, {size[0], size[1], size[2]}};
  }

  // The file of the mesh that a link shows; null without one.
  static const char* mesh_of(const XMLElement& link) {
    const XMLElement* e = link.FirstChildElement("visual");
    e = e == nullptr ? nullptr : e->FirstChildElement("geometry");
    e = e == nullptr ? nullptr : e->FirstChildElement("mesh");
    return e == nullptr ? nullptr : e->Attribute("filename");
  }

  Result<double> mass_of(const XMLElement& link) const {
    MARKETGEN_TRY(const XMLElement* inertial, xml_.child(link, "inertial"));
    MARKETGEN_TRY(const XMLElement* mass, xml_.child(*inertial, "mass"));
    return xml_.attribute_number(*mass, "value");
  }

  Result<void> read_link(const Open& at) {
    const auto found = links_.find(at.link);
    if (found == links_.end())
      return xml_.fault(xml_.root(), "there is no link \"" + at.link + "\"");
    const XMLElement& link = *found->second;
    contents_.meshes += children(link, "visual").size();
    const char* mesh = mesh_of(link);
    const bool room = at.link == urdf_room;
    if (!room && mesh != nullptr) return read_item(link, at.link, mesh, at.pose);
    if (!room) contents_.fixtures.insert(at.fixture);
    for (const XMLElement* collision : children(link, "collision")) {
      MARKETGEN_TRY(const std::string part, xml_.attribute(*collision, "name"));
      if (room && part == floor_solid) continue;
      MARKETGEN_TRY(const assets::ContactShape solid, solid_of(*collision));
      const assets::ContactShape placed = at.pose * solid;
      include_solid(contents_.bounds, placed);
      if (!room) contents_.parts->emplace(part, placed);
    }
    return {};
  }

  Result<void> read_item(const XMLElement& link,
                         const std::string& name,
                         const std::filesystem::path& mesh,
                         const Pose& pose) {
    const std::string sku = mesh.parent_path().filename().string();
    MARKETGEN_TRY(const XMLElement* collision, xml_.child(link, "collision"));
    MARKETGEN_TRY(const assets::ContactShape solid, solid_of(*collision));
    MARKETGEN_TRY(const double mass, mass_of(link));
    const auto rubs = gazebo_.find(name);
    if (rubs == gazebo_.end()) return xml_.fault(link, "\"" + name + "\" has no friction");
    MARKETGEN_TRY(const double friction, xml_.child_number(*rubs->second, "mu1"));
    contents_.products.push_back({name, sku, pose.position, pose.rotation});
    goods_.add({sku, mass, friction, solid});
    return {};
  }

  // What moves, and belts; fixed joints only hold what hangs on them.
  Result<void> read_joint(const XMLElement& element, const std::string& child, const Pose& world) {
    MARKETGEN_TRY(const std::string type, xml_.attribute(element, "type"));
    ExportedJoint joint;
    MARKETGEN_TRY(joint.name, xml_.attribute(element, "name"));
    const auto own = own_.find(joint.name);
    const bool belt = own != own_.end() && is_belt(*own->second);
    if (type == "fixed" && !belt) return {};
    joint.kind = joint_kind_of(type);
    joint.at = world.position;
    joint.axis = rotate(world.rotation, {0, 0, 1});
    const auto link = links_.find(child);
    if (link == links_.end()) return xml_.fault(element, "it moves no link");
    MARKETGEN_TRY(joint.mass_kg, mass_of(*link->second));
    if (!belt) MARKETGEN_CHECK(read_motion(element, type, joint));
    if (own != own_.end()) MARKETGEN_CHECK(read_joint_extras(xml_, *own->second, joint));
    contents_.joints->push_back(std::move(joint));
    return {};
  }

  Result<void> read_motion(const XMLElement& element,
                           const std::string& type,
                           ExportedJoint& joint) const {
    MARKETGEN_TRY(const XMLElement* axis, xml_.child(element, "axis"));
    MARKETGEN_TRY(const auto along, xml_.numbers(*axis, axis->Attribute("xyz"), 3));
    if (along != std::vector<double>{0, 0, 1}) return xml_.fault(*axis, "it is not Z");
    MARKETGEN_TRY(const XMLElement* limit, xml_.child(element, "limit"));
    if (type == "continuous") {
      joint.lower = no_lower_limit;
      joint.upper = no_upper_limit;
    } else {
      MARKETGEN_TRY(joint.lower, xml_.attribute_number(*limit, "lower"));
      MARKETGEN_TRY(joint.upper, xml_.attribute_number(*limit, "upper"));
    }
    MARKETGEN_TRY(const XMLElement* dynamics, xml_.child(element, "dynamics"));
    MARKETGEN_TRY(joint.damping, xml_.attribute_number(*dynamics, "damping"));
    MARKETGEN_TRY(joint.friction, xml_.attribute_number(*dynamics, "friction"));
    const auto spring = gazebo_.find(joint.name);
    if (spring == gazebo_.end()) return {};
    MARKETGEN_TRY(joint.stiffness, xml_.child_number(*spring->second, "springStiffness"));
    MARKETGEN_TRY(joint.spring_rest, xml_.child_number(*spring->second, "springReference"));
    return {};
  }

  XmlFile xml_;
  std::map<std::string, const XMLElement*> links_, gazebo_, own_;  // by name
  std::map<std::string, std::vector<const XMLElement*>> carried_by_;
  GoodsReader goods_;
  ExportContents contents_;
};

}  // namespace

Result<ExportContents> read_urdf(const std::filesystem::path& file,
                                 const std::vector<catalog::Product>& /*catalog*/) {
  MARKETGEN_TRY(XmlFile xml, XmlFile::read(file, "robot"));
  return UrdfReader(std::move(xml)).read();
}

}  // namespace marketgen::exporters
