// The actors in a World: which of its meshes, instances and materials are theirs.
//
// They lie behind the store's own rows and have a BVH of their own, so that the store's is never
// touched: every ray meets one, then the other.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "render/actor.h"
#include "render/world.h"

namespace marketgen::raytrace {

class ActorStage {
 public:
  // `first_id`: Frame::instance of the first actor. The world is committed and outlives this.
  ActorStage(World& world, std::uint32_t first_id) : world_(world), first_id_(first_id) {}

  // Replaces all actors. Errors: render.bad_actor; io.out_of_memory. The actors that were there
  // stay after render.bad_actor.
  Result<void> set(const std::vector<Actor>& actors);
  // Error: render.bad_actor when there is no such actor, or not one valid pose a body. Then nothing
  // has moved.
  Result<void> move(std::size_t actor, std::span<const Pose> world_from_body);

 private:
  struct Member {
    std::string name;
    std::vector<std::int32_t> instances;  // of each body; -1: it has no mesh
  };
  void clear();
  std::int32_t add_body(const ActorBody& body, std::uint32_t id);

  World& world_;
  std::uint32_t first_id_;
  std::vector<Member> members_;
};

}  // namespace marketgen::raytrace
