// A running grasp trial: the simulation, the tool's motion, and what is read from it.
#pragma once
#include <array>
#include <vector>

#include "grasping/grasp_scene.h"

namespace marketgen::grasping {

// Greatest of what is watched after every step.
struct GraspWatch {
  double slip_m = 0, turned_rad = 0;    // since mark(), at most
  double neighbour_n = 0, still_n = 0;  // mean over 10 ms, since the start
  std::array<double, 2> pad_n{};        // now, on the product
};

class GraspHold {
 public:
  // Errors: those of grasp_scene and make_data.
  static Result<GraspHold> start(const GraspTrial& trial);

  // ---- Commands. Errors: physics.failed. ----

  Result<void> wait(double seconds);
  // Where the tool begins; not before it is out of the way.
  void put_tool(const Pose& world_from_tool);
  // From rest to rest (minimum jerk: Flash and Hogan 1985), keeping its orientation.
  Result<void> move_tool(Vec3 by, double seconds);
  // To and fro along a unit vector, twice, beginning and ending gently.
  Result<void> shake_tool(Vec3 axis, double amplitude_m, double seconds);
  void open_fingers(double opening_m);                   // held there
  Result<void> squeeze(double force_n, double seconds);  // from 0 up to it; then it stays
  Result<void> release(double seconds);
  // Seals the cup if the face under it is even enough and near.
  bool seal();
  bool sealed() const { return sealed_; }

  // Turns the target about its origin, which is where it stands, and stops it.
  void lean_product(Vec3 axis, double angle_rad);

  // From here on slip is counted.
  void mark();

  // ---- State ----

  // world_from_product; of a soft pack, as its base has it.
  Pose product(std::size_t index = 0) const;
  // The same of the target as one of its parts has it, 0 the base: where the whole pack would be
  // if it were straight. Of a rigid one, as product().
  Pose part(int index) const;
  int part_near(Vec3 point) const;                // of the target, product frame
  Pose held() const { return part(held_part_); }  // the part that the tool holds, since mark()
  std::size_t products() const { return scene_.products.size(); }
  double speed(std::size_t index = 0) const;  // m/s
  const GraspWatch& watch() const { return watch_; }

 private:
  GraspHold(const GraspTrial& trial, GraspScene scene, physics::MujocoData data);

  Result<void> step(Vec3 next_position);
  void look();
  void look_at_contacts();
  void look_at_slip();
  void look_at_lip();
  Pose tool() const { return {position_, rotation_}; }

  const GraspTrial* trial_;
  GraspScene scene_;
  physics::MujocoData data_;
  Vec3 position_{};  // of the tool
  Quaternion rotation_{};
  Vec3 base_offset_{};
  double finger_force_n_ = 0;  // positive apart
  double held_open_m_ = -1;    // the fingers are held at this opening; -1: they are free
  bool sealed_ = false, marked_ = false;
  int held_part_ = 0;
  std::array<double, physics::SoftPack::part_count> part_n_{};  // of both pads, now
  physics::LipLoad lip_load_;
  Pose tool_from_product_;           // at mark(), as the held part has it
  std::vector<Vec3> slip_points_;    // tool frame
  std::vector<double> neighbour_n_;  // of each product, smoothed
  double still_n_ = 0;
  GraspWatch watch_;
};

}  // namespace marketgen::grasping
