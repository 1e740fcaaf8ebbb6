// Watches a running In-Aisle Item Collection, step by step: who touches what and how hard, what was
// taken, what fell.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "episodes/push_ledger.h"
#include "physics/world/robot_actor.h"
#include "physics/world/world.h"

namespace marketgen::episodes {

class AisleWatch {
 public:
  AisleWatch() = default;
  // After the world was made with the robot in it. The basket's geoms are named "basket/...".
  AisleWatch(const physics::World& world, const robots::Robot& robot);

  // After every step. `base`: velocity of the robot's base in the store frame, and its turn rate
  // about `axle`.
  struct BaseMotion {
    Vec3 axle, velocity_m_s;
    double turn_rad_s = 0;
  };
  // `sealed`: the product on which each tool has sealed.
  void look(physics::World& world,
            const BaseMotion& base,
            std::span<const std::optional<std::uint32_t>> sealed = {});

  // A product that a finger, a cup or the basket has touched.
  struct Item {
    int touched_by = -1;  // tool, in the last step: a finger or a cup
    int held_by = -1;     // tool: both its fingers, or sealed on it
    bool met = true;      // something other than a tool
    bool was_held = false;
    double speed_m_s = 0;  // against the base
    double rested_s = 0, impact_m_s = 0;

    template <class Archive, class Self>
    static void bytes(Archive& archive, Self& self) {
      archive(self.touched_by, self.held_by, self.met, self.was_held);
      archive(self.speed_m_s, self.rested_s, self.impact_m_s);
    }
  };
  const std::map<std::uint32_t, Item>& items() const { return items_; }
  bool is_held(std::uint32_t product) const;

  SideEffects effects() const;

  // What it has seen; what the geoms are it knows from the world.
  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.items_, self.pushes_, self.toppled_, self.dropped_, self.displaced_);
    archive(self.base_collisions_, self.base_touches_);
  }

 private:
  enum class Part { body, base, basket, finger };
  struct GeomRole {
    Part part = Part::body;
    int tool = -1, finger = -1;  // finger: 0 and 1, a cup is the only one
  };
  static GeomRole role_of(const robots::Robot& robot, std::string_view link);
  struct Touches {
    std::map<std::uint32_t, std::set<std::pair<int, int>>> fingers;  // product: tool, finger
    std::set<std::uint32_t> met, basket;
    std::map<std::uint64_t, double> force_n;
    bool base_hit = false;
  };
  Touches touches(const physics::World& world) const;
  bool lies_in_basket(std::uint32_t geom, std::uint32_t product) const;
  void add_push(const physics::WorldContact& contact, Touches& seen) const;
  void find_holder(Item& item, const std::set<std::pair<int, int>>& fingers, int sealed_by) const;
  void follow_item(std::uint32_t product,
                   Item& item,
                   const physics::World& world,
                   const BaseMotion& base);
  void follow_events(physics::World& world);

  std::vector<GeomRole> roles_;  // by geom
  std::map<std::uint32_t, Item> items_;
  PushLedger pushes_;
  std::set<std::uint32_t> toppled_, dropped_, displaced_;
  int base_collisions_ = 0;
  bool base_touches_ = false;
};

}  // namespace marketgen::episodes
