// Watches a running episode of any track, step by step: who touches what and how hard, what was
// taken, how things come to rest, what fell. A value: copied with the state it belongs to.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "episodes/push_ledger.h"
#include "physics/world/robot_actor.h"
#include "physics/world/world.h"

namespace marketgen::episodes {

class EpisodeWatch {
 public:
  static constexpr std::string_view person_prefix = "person/";

  EpisodeWatch() = default;
  // After the world was made with the robot in it. The basket's geoms are named "basket/...": it is
  // the robot's when they are on one of its links. `loose`: products that lie loose from the start
  // and are watched from then on; others, once they were taken or are in the basket. People are
  // bodies whose names begin with person_prefix.
  EpisodeWatch(const physics::World& world,
               const robots::Robot& robot,
               const std::vector<std::uint32_t>& loose = {});

  // Which joint each part of the scene hangs on, -1 for none: a door that is held by its bar, both
  // fingers of a tool on it, is then held, and not pushed. Without it any touch is a push.
  void know_joints(std::vector<std::int32_t> of_parts) { joints_ = std::move(of_parts); }

  // How things are after a step; store frame.
  struct Moment {
    Vec3 axle, base_velocity_m_s;  // of the robot's base, which turns about the axle
    double turn_rad_s = 0;
    std::span<const std::optional<std::uint32_t>> sealed = {};  // on which each tool has sealed
    Pose world_from_basket;
    // Whether a loose product lies outside of what it was in. What came to rest there stands as it
    // was put; what lies in a heap has no way up.
    std::function<bool(std::uint32_t product)> is_outside = {};
  };
  void look(physics::World& world, const Moment& moment);  // after every step

  struct Item {
    bool loose = false;   // from the start
    int touched_by = -1;  // tool, in the last step: a finger or a cup
    int held_by = -1;     // tool: both its fingers, or sealed on it
    bool met = true;      // something other than a tool
    bool was_held = false;
    double speed_m_s = 0;  // against the base
    double rested_s = 0, impact_m_s = 0;
    std::optional<Quaternion> stood;  // a loose one outside, when it came to rest there

    template <class Archive, class Self>
    static void bytes(Archive& archive, Self& self) {
      archive(self.loose, self.touched_by, self.held_by, self.met, self.was_held);
      archive(self.speed_m_s, self.rested_s, self.impact_m_s, self.stood);
    }
  };
  const std::map<std::uint32_t, Item>& items() const { return items_; }
  bool is_held(std::uint32_t product) const;
  // Whether both fingers of a tool are on what hangs on the joint; never without know_joints().
  bool is_joint_held(const physics::World& world, std::uint32_t joint) const;
  double max_tilt_deg() const { return tilt_deg_; }  // of the basket
  int person_contacts() const { return person_contacts_; }
  double person_hardest_n() const;  // the greatest force on one, mean over 10 ms

  // Counts contacts that still last as ended. Of loose goods `displaced`, and what else needs the
  // track's areas, is the judge's.
  SideEffects effects() const;

  // For recordings; products are rows of the world's scene. What a push was on: a row for products
  // alone; an actor is the basket at a counter, or the robot itself.
  const PushLedger& pushes() const { return pushes_; }
  static physics::ContactSide pushed_by(const Push& push);
  const std::set<std::uint32_t>& toppled() const { return toppled_; }
  const std::set<std::uint32_t>& dropped() const { return dropped_; }
  const std::set<std::uint32_t>& displaced() const { return displaced_; }

  // What it has seen; what the geoms are it knows from the world.
  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.items_, self.pushes_, self.toppled_, self.dropped_, self.displaced_);
    archive(self.base_collisions_, self.base_touches_, self.tilt_deg_);
    archive(self.person_contacts_, self.touched_people_, self.person_pushes_);
  }

 private:
  enum class Part { body, base, basket, finger, person };
  struct GeomRole {
    Part part = Part::body;
    int tool = -1, finger = -1;  // finger: 0 and 1, a cup is the only one
    bool of_robot = true;
    std::uint32_t body = 0;  // MuJoCo's
  };
  static GeomRole role_of(const robots::Robot& robot, std::string_view link);
  struct Touches {
    std::map<std::uint32_t, std::set<std::pair<int, int>>> fingers;  // product: tool, finger
    std::set<std::uint32_t> met, basket;
    std::map<std::uint64_t, double> force_n;
    std::map<std::uint64_t, double> people_n;  // force on them; MuJoCo's bodies
    bool base_hit = false;
  };
  using Fingers = std::set<std::pair<int, int>>;  // tool, finger
  // By joint, the fingers on what hangs on it; and whether a contact is of a finger with what its
  // tool holds so.
  std::map<std::int32_t, Fingers> fingers_on_joints(const physics::World& world) const;
  std::int32_t joint_of(const physics::ContactSide& side) const;
  bool holds_joint(const physics::WorldContact& contact,
                   const std::map<std::int32_t, Fingers>& on_joints) const;
  bool is_robot(const physics::ContactSide& side) const;
  std::uint64_t key_of(const physics::ContactSide& side) const;  // of what is pushed
  Touches touches(const physics::World& world) const;
  bool lies_in_basket(std::uint32_t geom, std::uint32_t product) const;
  void add_push(const physics::WorldContact& contact, Touches& seen) const;
  void find_holder(Item& item, const std::set<std::pair<int, int>>& fingers, int sealed_by) const;
  void follow_item(std::uint32_t product,
                   Item& item,
                   const physics::World& world,
                   const Moment& moment);
  void follow_standing(std::uint32_t product,
                       Item& item,
                       const Quaternion& now,
                       const Moment& moment);
  void follow_events(physics::World& world);
  void look_at_people(const Touches& seen);

  std::vector<GeomRole> roles_;       // by geom
  std::vector<std::int32_t> joints_;  // by part
  std::map<std::uint32_t, Item> items_;
  PushLedger pushes_;
  std::set<std::uint32_t> toppled_, dropped_, displaced_;
  int base_collisions_ = 0;
  bool base_touches_ = false;
  int person_contacts_ = 0;
  PushLedger person_pushes_;
  std::set<std::uint64_t> touched_people_;
  double tilt_deg_ = 0;
};

}  // namespace marketgen::episodes
