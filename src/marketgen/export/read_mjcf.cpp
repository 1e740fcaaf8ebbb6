#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/text.h"
#include "export/exporter.h"
#include "export/mjcf_robot.h"
#include "export/read_goods.h"
#include "io/file.h"
#include "physics/goods/contact_shape.h"
#include "physics/mujoco_guard.h"

// Reads an MJCF export with MuJoCo's own compiler.
namespace marketgen::exporters {
namespace {

std::string name_of_geom(const mjModel& model, int geom) {
  const char* name = mj_id2name(&model, mjOBJ_GEOM, geom);
  return name == nullptr ? "" : name;
}

Pose pose_of_geom(const mjData& data, int geom) {
  mjtNum q[4];
  mju_mat2Quat(q, data.geom_xmat + 9 * geom);
  const mjtNum* p = data.geom_xpos + 3 * geom;
  return {{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}};
}

// Of the geom's bounding box in the store frame.
void include_geom(Bounds3& bounds, const mjModel& model, const mjData& data, int geom) {
  const Pose pose = pose_of_geom(data, geom);
  const mjtNum* box = model.geom_aabb + 6 * geom;  // centre and half extents in the geom's frame
  const assets::ContactShape around{assets::CollisionShape::box,
                                    pose * Pose{{box[0], box[1], box[2]}, {}},
                                    {box[3], box[4], box[5]}};
  include_solid(bounds, around);
}

Vec3 vector_at(const mjtNum* numbers, int row) {
  return {numbers[3 * row], numbers[3 * row + 1], numbers[3 * row + 2]};
}

ExportedJoint joint_of(const mjModel& model, const mjData& data, int joint) {
  const int dof = model.jnt_dofadr[joint];
  ExportedJoint read;
  read.name = mj_id2name(&model, mjOBJ_JOINT, joint);
  read.kind =
      model.jnt_type[joint] == mjJNT_HINGE ? assets::JointKind::hinge : assets::JointKind::slide;
  read.at = vector_at(data.xanchor, joint);
  read.axis = vector_at(data.xaxis, joint);
  read.lower = model.jnt_range[2 * joint];
  read.upper = model.jnt_range[2 * joint + 1];
  read.friction = model.dof_frictionloss[dof];
  read.damping = model.dof_damping[dof];
  read.stiffness = model.jnt_stiffness[joint];
  read.spring_rest = model.qpos_spring[model.jnt_qposadr[joint]];
  read.hold_open_factor = model.jnt_stiffnesspoly[mjNPOLY * joint + 1];
  read.mass_kg = model.body_mass[model.jnt_bodyid[joint]];
  const int gasket = mj_name2id(&model, mjOBJ_NUMERIC, (read.name + "/gasket").c_str());
  if (gasket >= 0 && model.numeric_size[gasket] == 2) {
    const mjtNum* numbers = model.numeric_data + model.numeric_adr[gasket];
    read.gasket = numbers[0];
    read.gasket_reach = numbers[1];
  }
  return read;
}

// A belt is a custom numeric with the name of a body.
std::optional<ExportedJoint> belt_of(const mjModel& model, const mjData& data, int numeric) {
  constexpr int belt_numbers = 5;  // direction, least and greatest speed
  const char* name = mj_id2name(&model, mjOBJ_NUMERIC, numeric);
  const int body = name == nullptr ? -1 : mj_name2id(&model, mjOBJ_BODY, name);
  if (body < 0 || model.numeric_size[numeric] != belt_numbers) return std::nullopt;
  const mjtNum* numbers = model.numeric_data + model.numeric_adr[numeric];
  ExportedJoint read;
  read.name = name;
  read.kind = assets::JointKind::belt;
  read.at = vector_at(data.xpos, body);
  read.axis = vector_at(numbers, 0);
  read.lower = numbers[3];
  read.upper = numbers[4];
  read.mass_kg = model.body_mass[body];
  return read;
}

std::vector<std::string> robots_in(const mjModel& model) {
  const int text = mj_name2id(&model, mjOBJ_TEXT, mjcf_robots_text);
  if (text < 0) return {};
  return split(model.text_data + model.text_adr[text], ' ');
}

std::vector<bool> bodies_of(const mjModel& model, const std::vector<std::string>& robots) {
  std::vector<bool> theirs(static_cast<std::size_t>(model.nbody), false);
  for (int body = 1; body < model.nbody; ++body) {
    const char* name = mj_id2name(&model, mjOBJ_BODY, body);
    theirs[static_cast<std::size_t>(body)] =
        name != nullptr && std::ranges::any_of(robots, [&](const std::string& prefix) {
          return std::string_view(name).starts_with(prefix);
        });
  }
  return theirs;
}

// Of fixtures.
std::vector<ExportedJoint> joints_of(const mjModel& model,
                                     const mjData& data,
                                     const std::vector<bool>& of_robots) {
  std::vector<ExportedJoint> joints;
  for (int joint = 0; joint < model.njnt; ++joint) {
    const bool robots = of_robots[static_cast<std::size_t>(model.jnt_bodyid[joint])];
    if (model.jnt_type[joint] != mjJNT_FREE && !robots)
      joints.push_back(joint_of(model, data, joint));
  }
  for (int numeric = 0; numeric < model.nnumeric; ++numeric) {
    if (auto belt = belt_of(model, data, numeric)) joints.push_back(*std::move(belt));
  }
  return joints;
}

// Where the product frame lies that the geom belongs to.
class ProductFrames {
 public:
  static Result<ProductFrames> of(const std::vector<catalog::Product>& catalog) {
    ProductFrames frames;
    for (const catalog::Product& product : catalog) {
      MARKETGEN_TRY(const assets::CollisionPrimitive primitive, assets::collision_of(product));
      frames.shape_from_product_.emplace(product.sku,
                                         inverse(assets::contact_shape_of(primitive).pose));
    }
    return frames;
  }

  // Null for a SKU that the scene does not have.
  const Pose* shape_from_product(const std::string& sku) const {
    const auto found = shape_from_product_.find(sku);
    return found == shape_from_product_.end() ? nullptr : &found->second;
  }

 private:
  std::map<std::string, Pose> shape_from_product_;
};

// A look stands where the product before it stands, with that product's mesh and picture.
constexpr std::string_view look_prefix = "look/";
constexpr double look_tolerance_m = 1e-4;

bool is_look(const std::string& material) {
  return material.starts_with(look_prefix);
}

// MuJoCo moves a mesh to its own middle; the geom then stands there.
Pose pose_of_look(const mjModel& model, const mjData& data, int geom) {
  const int mesh = model.geom_dataid[geom];
  const mjtNum* p = model.mesh_pos + 3 * mesh;
  const mjtNum* q = model.mesh_quat + 4 * mesh;
  return pose_of_geom(data, geom) * inverse(Pose{{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}});
}

Result<void> check_look(const ExportContents& contents,
                        const std::string& material,
                        const Pose& pose,
                        const std::string& where) {
  if (contents.products.empty() ||
      contents.products.back().sku != material.substr(look_prefix.size()) ||
      !(length(contents.products.back().position - pose.position) <= look_tolerance_m))
    return Error{"export.mismatch",
                 where,
                 "a mesh of " + material + " stands by itself; export the store again"};
  return {};
}

// Products carry their SKU as material; fixture parts are "<fixture>/<unit>-<n>" in group 1.
Result<ExportContents> contents_of(const mjModel& model,
                                   const mjData& data,
                                   const ProductFrames& frames,
                                   const std::string& where) {
  const std::vector<std::string> robots = robots_in(model);
  const std::vector<bool> of_robots = bodies_of(model, robots);
  ExportContents contents;
  contents.meshes = static_cast<std::uint64_t>(model.ngeom);
  contents.free_bodies = contents.looks = 0;
  contents.robots = robots.size();
  contents.joints = joints_of(model, data, of_robots);
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (model.geom_type[geom] == mjGEOM_PLANE ||
        of_robots[static_cast<std::size_t>(model.geom_bodyid[geom])])
      continue;
    const std::string name = name_of_geom(model, geom);
    const int material = model.geom_matid[geom];
    const std::string sku = material < 0 ? "" : mj_id2name(&model, mjOBJ_MATERIAL, material);
    if (is_look(sku)) {
      MARKETGEN_CHECK(check_look(contents, sku, pose_of_look(model, data, geom), where));
      ++*contents.looks;
      continue;
    }
    include_geom(contents.bounds, model, data, geom);
    if (material >= 0) {
      const int body = model.geom_bodyid[geom];
      const bool free = model.body_jntnum[body] > 0;
      if (free && geom > model.body_geomadr[body]) continue;  // another piece of the same
      const Pose* frame = frames.shape_from_product(sku);
      const Pose standing = pose_of_geom(data, geom) * (frame != nullptr ? *frame : Pose{});
      contents.products.push_back(
          {name, sku, free ? vector_at(data.xpos, body) : standing.position});
      if (free) ++*contents.free_bodies;
    } else if (model.geom_group[geom] == 1) {
      contents.fixtures.insert(name.substr(0, name.rfind('/')));
    }
  }
  return contents;
}

}  // namespace

Result<ExportContents> read_mjcf(const std::filesystem::path& file,
                                 const std::vector<catalog::Product>& catalog) {
  MARKETGEN_CHECK(io::read_file(file));  // MuJoCo's own words for one that is not there help nobody
  MARKETGEN_TRY(const ProductFrames frames, ProductFrames::of(catalog));
  physics::route_mujoco_messages();
  char fault[1000] = "";
  const physics::MujocoSpec spec(mj_parseXML(file.c_str(), nullptr, fault, sizeof fault),
                                 mj_deleteSpec);
  if (spec == nullptr)
    return Error{"export.mismatch", file.string(), std::string("MuJoCo cannot read it: ") + fault};
  physics::MujocoModel model(mj_compile(spec.get(), nullptr), mj_deleteModel);
  if (model == nullptr) {
    return Error{"export.mismatch",
                 file.string(),
                 std::string("MuJoCo cannot compile it: ") + mjs_getError(spec.get())};
  }
  MARKETGEN_TRY(const physics::MujocoData data, physics::make_data(*model, file.string()));
  MARKETGEN_CHECK(physics::guarded(file.string(), [&] { mj_kinematics(model.get(), data.get()); }));
  return contents_of(*model, *data, frames, file.string());
}

}  // namespace marketgen::exporters
