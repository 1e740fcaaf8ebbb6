// What stands in the pictures of a store without being in its scene: robots, tools, tables,
// people.
//
// An actor is a set of rigid bodies. Renderer::set_actors() takes their meshes once;
// Renderer::move_actor() moves them from frame to frame. The store's own geometry, BVH and stored
// light stay as they were built. Actors cast shadows, are mirrored and lit and throw light back,
// but the light stored in the air (what rays see at second hand) is that of the store without them.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/mesh.h"
#include "geometry/pose.h"

namespace marketgen::render {

struct ActorSurface {
  Vec3f color{0.8F, 0.8F, 0.8F};  // linear RGB, 0..1
  float roughness = 0.5F;         // 0 mirror, 1 chalk
  float metallic = 0;             // 0 dielectric, 1 metal
  float scatter_m = 0;            // how far light wanders below the surface; 0: not at all
};

struct ActorBody {
  std::string name;                    // "link3"
  Mesh mesh;                           // body frame, metres; may be empty
  std::vector<ActorSurface> surfaces;  // of mesh.surfaces
  Pose world_from_body;                // store frame
};

struct Actor {
  std::string name;  // "panda"
  std::vector<ActorBody> bodies;
  std::string category = "actor";  // in pictures of categories
};

// Error render.bad_actor, at "<actor>/<body>": lists of different lengths, an index without a row,
// a number that is not finite or not from 0 to 1, a rotation that is no unit quaternion.
Result<void> check_actor(const Actor& actor);
Result<void> check_body_pose(const Pose& world_from_body, const std::string& where);

}  // namespace marketgen::render
