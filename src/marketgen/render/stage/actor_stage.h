// The actors in a World: which of its meshes, instances and materials are theirs.
//
// They lie behind the store's own rows and have a BVH of their own, so that a large store's is
// never touched: every ray meets one, then the other.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "render/stage/actor.h"
#include "render/stage/world.h"

namespace marketgen::render::raytrace {

// An instance of the store that stands elsewhere now.
struct Displaced {
  std::uint32_t instance = 0;  // row in World::instances
  std::int32_t shelf = -1;     // that it stands on now, a row of the scene; -1: none
  Placement world_from_mesh;
};

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

  // These instances stand elsewhere from now on, all others of the store where the scene has them.
  // Quick when they are the same rows as before. Error: io.out_of_memory. Rows are distinct.
  Result<void> displace(std::vector<Displaced> rows);

  // Before rays are traced: what move() and displace() have said counts from now on.
  void settle();

 private:
  struct Member {
    std::string name;
    std::vector<std::int32_t> instances;  // of each body; -1: it has no mesh
  };
  void clear();
  void add_displaced();
  void hide_displaced();
  Result<void> commit();
  void put(std::size_t instance, const Placement& place);
  std::int32_t add_body(const ActorBody& body, std::uint32_t id);

  World& world_;
  std::uint32_t first_id_;
  std::vector<Member> members_;
  std::vector<Displaced> displaced_;
  std::size_t first_displaced_ = 0;  // row of displaced_[0]'s copy
  std::vector<std::size_t> put_;     // instances that stand elsewhere than their BVH has them
};

}  // namespace marketgen::render::raytrace
