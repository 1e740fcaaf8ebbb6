#include "render/stage/actor.h"

#include <algorithm>
#include <cmath>

namespace marketgen::render {
namespace {

constexpr double unit_slack = 1e-6;

Error bad_actor(const std::string& where, const std::string& message) {
  return {"render.bad_actor", where, message};
}

template <class V>
bool finite_vector(const V& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_share(float x) {
  return x >= 0 && x <= 1;  // false for NaN
}

Result<void> check_mesh(const Mesh& mesh, std::size_t surfaces, const std::string& where) {
  const std::size_t vertices = mesh.positions.size();
  if (mesh.normals.size() != vertices || mesh.uvs.size() != vertices)
    return bad_actor(where, "expected a normal and a texture coordinate for every vertex");
  if (mesh.surfaces.size() != mesh.triangles.size())
    return bad_actor(where, "expected a surface for every triangle");
  const auto outside = [&](const auto& triangle) {
    return std::any_of(
        triangle.begin(), triangle.end(), [&](std::uint32_t corner) { return corner >= vertices; });
  };
  if (std::any_of(mesh.triangles.begin(), mesh.triangles.end(), outside))
    return bad_actor(where, "a triangle names a vertex that does not exist");
  if (std::any_of(mesh.surfaces.begin(), mesh.surfaces.end(), [&](std::uint16_t surface) {
        return surface >= surfaces;
      }))
    return bad_actor(where, "a triangle names a surface that does not exist");
  const auto finite = [](Vec3f v) { return finite_vector(v); };
  if (!std::all_of(mesh.positions.begin(), mesh.positions.end(), finite) ||
      !std::all_of(mesh.normals.begin(), mesh.normals.end(), finite))
    return bad_actor(where, "a vertex is not finite");
  return {};
}

}  // namespace

Result<void> check_body_pose(const Pose& world_from_body, const std::string& where) {
  const Quaternion& q = world_from_body.rotation;
  const double norm = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  if (!finite_vector(world_from_body.position) || !(std::abs(norm - 1) < unit_slack))
    return bad_actor(where, "expected a finite position and a unit quaternion");
  return {};
}

Result<void> check_actor(const Actor& actor) {
  for (const ActorBody& body : actor.bodies) {
    const std::string where = actor.name + "/" + body.name;
    MARKETGEN_CHECK(check_mesh(body.mesh, body.surfaces.size(), where));
    for (const ActorSurface& s : body.surfaces) {
      if (!is_share(s.color.x) || !is_share(s.color.y) || !is_share(s.color.z) ||
          !is_share(s.roughness) || !is_share(s.metallic))
        return bad_actor(where, "expected colour, roughness and metallic from 0 to 1");
      if (!is_share(s.scatter_m))
        return bad_actor(where, "expected light to wander 0 to 1 m below the surface");
    }
    MARKETGEN_CHECK(check_body_pose(body.world_from_body, where));
  }
  return {};
}

}  // namespace marketgen::render
