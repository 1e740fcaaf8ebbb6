#include "robots/urdf.h"

#include <charconv>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <tinyxml2.h>

#include "io/file.h"
#include "robots/rotation.h"

namespace marketgen::robots {
namespace fs = std::filesystem;
namespace {

using tinyxml2::XMLElement;
constexpr std::uint64_t max_urdf_bytes = 16U << 20;

// Numbers split by blanks; nothing when one cannot be read or is not finite.
std::optional<std::vector<double>> numbers_in(std::string_view text) {
  std::vector<double> values;
  const char *at = text.data(), *end = text.data() + text.size();
  while (true) {
    while (at != end && (*at == ' ' || *at == '\t' || *at == '\n' || *at == '\r'))
      ++at;
    if (at == end) return values;
    if (*at == '+') ++at;
    double value = 0;
    const auto [after, failed] = std::from_chars(at, end, value);
    if (failed != std::errc{} || !std::isfinite(value)) return std::nullopt;
    values.push_back(value);
    at = after;
  }
}

class Reader {
 public:
  Reader(const std::string& source, const fs::path& folder) : source_(source), folder_(folder) {}

  Result<UrdfRobot> read(std::string_view text) {
    tinyxml2::XMLDocument document;
    if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
      return Error{"robot.bad_file",
                   fmt::format("{}:{}", source_, document.ErrorLineNum()),
                   fmt::format("the text is not XML: {}", document.ErrorName())};
    const XMLElement* root = document.FirstChildElement("robot");
    if (root == nullptr)
      return Error{"robot.bad_file", source_, "there is no <robot> element; is this a URDF?"};
    RobotParts parts;
    parts.name = root->Attribute("name") != nullptr ? root->Attribute("name") : "robot";
    for (auto* e = root->FirstChildElement("link"); e; e = e->NextSiblingElement("link")) {
      MARKETGEN_TRY(Link link, link_of(*e));
      parts.links.push_back(std::move(link));
    }
    for (auto* e = root->FirstChildElement("joint"); e; e = e->NextSiblingElement("joint")) {
      MARKETGEN_TRY(RobotParts::JointPart joint, joint_of(*e));
      parts.joints.push_back(std::move(joint));
    }
    UrdfRobot result;
    MARKETGEN_TRY(result.robot, make_robot(std::move(parts), source_));
    result.warnings = std::move(warnings_);
    return result;
  }

 private:
  Error fault(const XMLElement& at, const std::string& message) const {
    return {"robot.bad_file", fmt::format("{}:{}", source_, at.GetLineNum()), message};
  }

  // `count` numbers of an attribute; `fallback` when it is absent.
  Result<std::vector<double>> numbers(const XMLElement& e,
                                      const char* name,
                                      std::size_t count,
                                      std::vector<double> fallback) const {
    const char* text = e.Attribute(name);
    if (text == nullptr) return fallback;
    const auto values = numbers_in(text);
    if (!values || values->size() != count)
      return fault(e,
                   fmt::format("<{} {}=\"{}\">: expected {} finite number{}",
                               e.Name(),
                               name,
                               text,
                               count,
                               count == 1 ? "" : "s"));
    return *values;
  }
  Result<double> number(const XMLElement& e, const char* name, double fallback) const {
    MARKETGEN_TRY(const std::vector<double> values, numbers(e, name, 1, {fallback}));
    return values[0];
  }
  Result<double> needed_number(const XMLElement& e, const char* name) const {
    if (e.Attribute(name) == nullptr)
      return fault(e, fmt::format("<{}> has no attribute \"{}\"", e.Name(), name));
    return number(e, name, 0);
  }
  Result<Vec3> vector(const XMLElement& e, const char* name, Vec3 fallback) const {
    MARKETGEN_TRY(const std::vector<double> v,
                  numbers(e, name, 3, {fallback.x, fallback.y, fallback.z}));
    return Vec3{v[0], v[1], v[2]};
  }
  Result<std::string> needed_text(const XMLElement& e, const char* name) const {
    if (e.Attribute(name) == nullptr)
      return fault(e, fmt::format("<{}> has no attribute \"{}\"", e.Name(), name));
    return std::string(e.Attribute(name));
  }

  Result<Pose> origin_of(const XMLElement& e) const {
    const XMLElement* origin = e.FirstChildElement("origin");
    if (origin == nullptr) return Pose{};
    MARKETGEN_TRY(const Vec3 xyz, vector(*origin, "xyz", {}));
    MARKETGEN_TRY(const Vec3 rpy, vector(*origin, "rpy", {}));
    return Pose{xyz, rotation_from_rpy(rpy)};
  }

  Result<Link> link_of(const XMLElement& e) {
    Link link;
    MARKETGEN_TRY(link.name, needed_text(e, "name"));
    if (const XMLElement* inertial = e.FirstChildElement("inertial"))
      MARKETGEN_CHECK(read_inertial(*inertial, link));
    for (auto* v = e.FirstChildElement("visual"); v; v = v->NextSiblingElement("visual")) {
      MARKETGEN_TRY(const BodyShape shape, shape_of(*v));
      link.look.push_back(shape);
    }
    for (auto* c = e.FirstChildElement("collision"); c; c = c->NextSiblingElement("collision")) {
      MARKETGEN_TRY(const BodyShape shape, shape_of(*c));
      add_capsules(link, shape);
    }
    return link;
  }

  Result<void> read_inertial(const XMLElement& e, Link& link) const {
    const XMLElement *mass = e.FirstChildElement("mass"), *inertia = e.FirstChildElement("inertia");
    if (mass == nullptr)
      return fault(e, "the <inertial> of link \"" + link.name + "\" has no <mass>");
    MARKETGEN_TRY(link.mass, needed_number(*mass, "value"));
    if (inertia == nullptr)
      return fault(e, "the <inertial> of link \"" + link.name + "\" has no <inertia>");
    MARKETGEN_TRY(const Pose origin, origin_of(e));
    Inertia i;
    MARKETGEN_TRY(i.xx, needed_number(*inertia, "ixx"));
    MARKETGEN_TRY(i.yy, needed_number(*inertia, "iyy"));
    MARKETGEN_TRY(i.zz, needed_number(*inertia, "izz"));
    MARKETGEN_TRY(i.xy, number(*inertia, "ixy", 0));
    MARKETGEN_TRY(i.xz, number(*inertia, "ixz", 0));
    MARKETGEN_TRY(i.yz, number(*inertia, "iyz", 0));
    link.center_of_mass = origin.position;
    link.inertia = turned(i, origin.rotation);
    return {};
  }

  // R I R^T.
  static Inertia turned(const Inertia& i, const Quaternion& rotation) {
    const auto tensor = [&](Vec3 v) {
      return Vec3{i.xx * v.x + i.xy * v.y + i.xz * v.z,
                  i.xy * v.x + i.yy * v.y + i.yz * v.z,
                  i.xz * v.x + i.yz * v.y + i.zz * v.z};
    };
    const Quaternion back = inverse(rotation);
    const Vec3 x = rotate(back, {1, 0, 0}), y = rotate(back, {0, 1, 0}),
               z = rotate(back, {0, 0, 1});
    return {dot(x, tensor(x)),
            dot(y, tensor(y)),
            dot(z, tensor(z)),
            dot(x, tensor(y)),
            dot(x, tensor(z)),
            dot(y, tensor(z))};
  }

  Result<BodyShape> shape_of(const XMLElement& e) {
    const XMLElement* geometry = e.FirstChildElement("geometry");
    const XMLElement* solid = geometry != nullptr ? geometry->FirstChildElement() : nullptr;
    if (solid == nullptr) return fault(e, fmt::format("<{}> has no <geometry>", e.Name()));
    BodyShape shape;
    MARKETGEN_TRY(shape.link_from_shape, origin_of(e));
    const std::string_view kind = solid->Name();
    if (kind == "box") {
      MARKETGEN_TRY(shape.size, vector(*solid, "size", {}));
      if (!(shape.size.x > 0 && shape.size.y > 0 && shape.size.z > 0))
        return fault(*solid, "a box needs three sizes above 0");
    } else if (kind == "cylinder") {
      shape.kind = ShapeKind::tube;
      MARKETGEN_TRY(shape.radius, needed_number(*solid, "radius"));
      MARKETGEN_TRY(shape.length, needed_number(*solid, "length"));
      if (!(shape.radius > 0 && shape.length > 0))
        return fault(*solid, "a cylinder needs a radius and a length above 0");
      shape.radius_end = shape.radius;
      shape.link_from_shape = shape.link_from_shape * Pose{{0, 0, -shape.length / 2}, {}};
    } else if (kind == "sphere") {
      shape.kind = ShapeKind::ball;
      MARKETGEN_TRY(shape.radius, needed_number(*solid, "radius"));
      if (!(shape.radius > 0)) return fault(*solid, "a sphere needs a radius above 0");
    } else if (kind == "mesh") {
      shape.kind = ShapeKind::mesh;
      MARKETGEN_TRY(shape.mesh_file, needed_text(*solid, "filename"));
      MARKETGEN_TRY(shape.size, vector(*solid, "scale", {1, 1, 1}));
      find_mesh(*solid, shape);
    } else {
      return fault(*solid,
                   fmt::format("<{}> is no shape; expected box, cylinder, sphere or mesh", kind));
    }
    MARKETGEN_TRY(shape.color, color_of(e, shape.color));
    return shape;
  }

  Result<std::string> color_of(const XMLElement& e, const std::string& fallback) const {
    const XMLElement* material = e.FirstChildElement("material");
    const XMLElement* color = material != nullptr ? material->FirstChildElement("color") : nullptr;
    if (color == nullptr) return fallback;
    MARKETGEN_TRY(const std::vector<double> rgba, numbers(*color, "rgba", 4, {0.8, 0.8, 0.8, 1}));
    const auto byte = [](double v) {
      return static_cast<int>(std::lround(std::fmin(std::fmax(v, 0), 1) * 255));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(rgba[0]), byte(rgba[1]), byte(rgba[2]));
  }

  void find_mesh(const XMLElement& e, BodyShape& shape) {
    std::string name = shape.mesh_file;
    for (const std::string_view scheme : {"package://", "file://"}) {
      if (name.rfind(scheme, 0) == 0) name = name.substr(scheme.size());
    }
    std::vector<fs::path> names{name};
    if (shape.mesh_file.rfind("package://", 0) == 0 && name.find('/') != std::string::npos)
      names.emplace_back(name.substr(name.find('/') + 1));
    std::error_code ignored;
    for (fs::path at = fs::absolute(folder_, ignored);; at = at.parent_path()) {
      for (const fs::path& each : names) {
        if (!fs::is_regular_file(at / each, ignored)) continue;
        shape.mesh_file = (at / each).string();
        return;
      }
      if (at == at.parent_path()) break;
    }
    warnings_.push_back(fmt::format(
        "{}:{}: the mesh \"{}\" was not found", source_, e.GetLineNum(), shape.mesh_file));
  }

  void add_capsules(Link& link, const BodyShape& shape) {
    const Pose& at = shape.link_from_shape;
    if (shape.kind == ShapeKind::mesh) {
      warnings_.push_back("link \"" + link.name +
                          "\": a collision mesh is not used; give boxes, "
                          "cylinders or spheres");
    } else if (shape.kind == ShapeKind::ball) {
      link.capsules.push_back({at.position, at.position, shape.radius});
    } else if (shape.kind == ShapeKind::tube) {
      link.capsules.push_back({at.position, at * Vec3{0, 0, shape.length}, shape.radius});
    } else {
      link.capsules.push_back(around_box(at, shape.size));
    }
  }

  // Along the longest side, through the corners of the other two.
  static Capsule around_box(const Pose& at, Vec3 size) {
    Vec3 along{size.x / 2, 0, 0};
    double radius = std::hypot(size.y, size.z) / 2;
    if (size.y >= size.x && size.y >= size.z) {
      along = {0, size.y / 2, 0};
      radius = std::hypot(size.x, size.z) / 2;
    } else if (size.z >= size.x && size.z >= size.y) {
      along = {0, 0, size.z / 2};
      radius = std::hypot(size.x, size.y) / 2;
    }
    return {at * -along, at * along, radius};
  }

  Result<RobotParts::JointPart> joint_of(const XMLElement& e) const {
    RobotParts::JointPart part;
    Joint& joint = part.joint;
    MARKETGEN_TRY(joint.name, needed_text(e, "name"));
    MARKETGEN_TRY(const std::string kind, needed_text(e, "type"));
    const auto known = value_named<JointType>(kind);
    if (!known)
      return fault(e,
                   "joint \"" + joint.name + "\": the type \"" + kind +
                       "\" is not supported; expected fixed, revolute, continuous or prismatic");
    joint.kind = *known;
    MARKETGEN_TRY(joint.parent_from_joint, origin_of(e));
    MARKETGEN_TRY(part.parent, end_of(e, "parent"));
    MARKETGEN_TRY(part.child, end_of(e, "child"));
    joint.axis = {1, 0, 0};  // URDF's default
    if (const XMLElement* axis = e.FirstChildElement("axis")) {
      MARKETGEN_TRY(joint.axis, vector(*axis, "xyz", {1, 0, 0}));
    }
    MARKETGEN_CHECK(read_limits(e, joint));
    if (const XMLElement* dynamics = e.FirstChildElement("dynamics")) {
      MARKETGEN_TRY(joint.damping, number(*dynamics, "damping", 0));
    }
    if (const XMLElement* mimic = e.FirstChildElement("mimic")) {
      MARKETGEN_TRY(part.follows, needed_text(*mimic, "joint"));
      MARKETGEN_TRY(joint.follow_ratio, number(*mimic, "multiplier", 1));
      MARKETGEN_TRY(joint.follow_offset, number(*mimic, "offset", 0));
    }
    return part;
  }

  Result<std::string> end_of(const XMLElement& e, const char* which) const {
    const XMLElement* end = e.FirstChildElement(which);
    if (end == nullptr) return fault(e, fmt::format("the joint has no <{}>", which));
    return needed_text(*end, "link");
  }

  Result<void> read_limits(const XMLElement& e, Joint& joint) const {
    const XMLElement* limit = e.FirstChildElement("limit");
    const bool bounded = joint.kind == JointType::revolute || joint.kind == JointType::prismatic;
    if (limit == nullptr) {
      if (!bounded) return {};
      return fault(e,
                   "joint \"" + joint.name +
                       "\" has no <limit>; expected lower, upper, effort and "
                       "velocity, or type=\"continuous\"");
    }
    if (bounded) {
      MARKETGEN_TRY(joint.lower, number(*limit, "lower", 0));
      MARKETGEN_TRY(joint.upper, number(*limit, "upper", 0));
    }
    MARKETGEN_TRY(const double effort, number(*limit, "effort", 0));
    MARKETGEN_TRY(const double velocity, number(*limit, "velocity", 0));
    if (effort != 0) joint.effort = effort;
    if (velocity != 0) joint.velocity = velocity;
    return {};
  }

  const std::string& source_;
  const fs::path& folder_;
  std::vector<std::string> warnings_;
};

}  // namespace

Result<UrdfRobot> read_urdf(std::string_view text,
                            const std::string& source,
                            const fs::path& folder) {
  return Reader(source, folder).read(text);
}

Result<UrdfRobot> read_urdf_file(const fs::path& file) {
  MARKETGEN_TRY(const std::string text, io::read_file(file, max_urdf_bytes));
  return read_urdf(text, file.filename().string(), file.parent_path());
}

}  // namespace marketgen::robots
