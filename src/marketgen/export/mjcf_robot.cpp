#include "export/mjcf_robot.h"

#include <map>

#include <fmt/format.h>

#include "assets/print/color.h"
#include "export/mjcf_text.h"
#include "export/obj_text.h"
#include "physics/mujoco_guard.h"
#include "physics/world/robot_actor.h"
#include "robots/link_parts.h"

namespace marketgen::exporters {
namespace {

// Files that MuJoCo finds while it compiles, though they are not on the disk yet.
class FilesInMemory {
 public:
  FilesInMemory() { mj_defaultVFS(&files_); }
  ~FilesInMemory() { mj_deleteVFS(&files_); }
  FilesInMemory(const FilesInMemory&) = delete;
  FilesInMemory& operator=(const FilesInMemory&) = delete;

  void add(const BesideFile& file) {
    mj_addBufferVFS(
        &files_, file.name.c_str(), file.bytes.data(), static_cast<int>(file.bytes.size()));
  }
  const mjVFS* get() const { return &files_; }

 private:
  mjVFS files_{};
};

// One visible mesh for each finish of each link.
Result<void> add_looks(mjSpec& spec, const robots::PlacedRobot& placed, MjcfRobot& made) {
  for (const robots::Link& link : placed.robot.links) {
    MARKETGEN_TRY(const std::vector<robots::LinkPart> parts, robots::link_parts(link));
    mjsBody* body = mjs_findBody(&spec, link.name.c_str());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].mesh.triangles.empty()) continue;
      const std::string name = fmt::format("{}-{}-{}", made.name, link.name, i);
      MARKETGEN_TRY(const Vec3f color, assets::linear_from_hex(parts[i].color));
      made.files.push_back({name + ".obj", obj_text(parts[i].mesh)});
      mjsMesh* mesh = mjs_addMesh(&spec, nullptr);
      mjs_setName(mesh->element, name.c_str());
      mjs_setString(mesh->file, (name + ".obj").c_str());
      mesh->inertia = mjMESH_INERTIA_SHELL;
      mjsGeom* geom = mjs_addGeom(body, nullptr);
      geom->type = mjGEOM_MESH;
      mjs_setString(geom->meshname, name.c_str());
      geom->contype = geom->conaffinity = 0;
      geom->mass = 0;
      geom->group = group_product;
      const float rgba[3] = {color.x, color.y, color.z};
      for (int c = 0; c < 3; ++c)
        geom->rgba[c] = static_cast<float>(srgb_from_linear(rgba[c]));
      geom->rgba[3] = 1;
    }
  }
  return {};
}

Result<std::string> text_of(mjSpec& spec, const MjcfRobot& made) {
  FilesInMemory files;
  for (const BesideFile& file : made.files)
    files.add(file);
  const physics::MujocoModel model(mj_compile(&spec, files.get()), mj_deleteModel);
  if (model == nullptr) return Error{"physics.failed", made.name, mjs_getError(&spec)};
  char fault[500] = "";
  std::string text(1 << 16, '\0');
  // A text that does not fit says how long it is.
  int missing =
      mj_saveXMLString(&spec, text.data(), static_cast<int>(text.size()), fault, sizeof fault);
  if (missing > 0) {
    text.assign(static_cast<std::size_t>(missing) + 1, '\0');
    missing =
        mj_saveXMLString(&spec, text.data(), static_cast<int>(text.size()), fault, sizeof fault);
  }
  if (missing != 0) return Error{"physics.failed", made.name, fault};
  text.resize(text.find('\0'));
  return text;
}

Result<MjcfRobot> mjcf_robot(const robots::PlacedRobot& placed, const std::string& name) {
  MjcfRobot made{name, name + "/", placed.robot.links.front().name, placed.world_from_base, {}, {}};
  const physics::MujocoSpec spec(mj_makeSpec(), mj_deleteSpec);
  mjs_setString(spec->modelname, name.c_str());
  spec->compiler.degree = false;
  physics::RobotActorOptions options;
  options.state = placed.q;
  MARKETGEN_CHECK(physics::add_robot(*spec, placed.robot, options));
  for (mjsElement* e = mjs_firstElement(spec.get(), mjOBJ_GEOM); e != nullptr;
       e = mjs_nextElement(spec.get(), e))
    mjs_asGeom(e)->group = group_solid;
  MARKETGEN_CHECK(add_looks(*spec, placed, made));
  MARKETGEN_TRY(std::string text, text_of(*spec, made));
  made.files.push_back({name + ".xml", std::move(text)});
  for (const robots::Joint& joint : placed.robot.joints) {  // in the order of add_robot()'s drives
    if (joint.dof >= 0 && joint.follows < 0)
      made.start.push_back(robots::is_on_wheels(placed.robot, joint.dof)
                               ? 0
                               : placed.q[static_cast<std::size_t>(joint.dof)]);
  }
  return made;
}

}  // namespace

Result<std::vector<MjcfRobot>> mjcf_robots(const std::vector<robots::PlacedRobot>& robots) {
  std::vector<MjcfRobot> made;
  std::map<std::string, int> count;
  for (const robots::PlacedRobot& placed : robots) {
    const int number = ++count[placed.robot.name];
    const std::string name =
        number == 1 ? placed.robot.name : fmt::format("{}-{}", placed.robot.name, number);
    MARKETGEN_TRY(MjcfRobot robot, mjcf_robot(placed, name));
    made.push_back(std::move(robot));
  }
  return made;
}

}  // namespace marketgen::exporters
