// The lip of a suction cup: on what it seals, how it holds, when it lets go. Shared by the grasp
// study and the World.
//
// Lip frame: origin in the middle of the lip, Z ahead, out of the cup. A sealed lip is held by
// three points of its edge (MuJoCo's `connect`), which are equalities of the model from the start,
// inactive until it seals. SI units.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>

#include "geometry/pose.h"
#include "physics/mujoco_guard.h"

namespace marketgen::physics {

struct CupShape {
  double radius_m = 0;      // of the lip
  double seal_depth_m = 0;  // how uneven a surface may be for it to seal
};

// How far a face may be from the lip, ahead or behind, when it seals: the bellows give way.
constexpr double bellows_stroke_m = 0.004;

using LipPoints = std::array<int, 3>;  // equalities of a model

// The points of a lip on `body`, to be held to `other` (empty: any, see hold_point). `body` has a
// name.
void add_lip(mjSpec& spec,
             const std::string& body,
             const Pose& body_from_lip,
             double radius_m,
             const std::string& other = {});
LipPoints lip_points(const mjModel& model, const std::string& body);

// What lies under a lip: the geom that each ray meets, sixteen along its edge, from X to Y, and one
// in its middle.
struct UnderLip {
  static constexpr int edge_rays = 16;
  std::array<int, edge_rays + 1> geoms{};
  int at_point(std::size_t point) const;  // under the edge, next to one of the three
};

// Looks along Z for the first of `geoms` under the lip. Nothing when a ray meets none, when the
// face is more uneven than the cup's `seal_depth_m`, or out of the bellows' stroke.
std::optional<UnderLip> look_under_lip(const mjModel& model,
                                       const mjData& data,
                                       const Pose& world_from_lip,
                                       const CupShape& cup,
                                       std::span<const int> geoms);

// Holds one of the points to `body`, at `on_body` in its frame.
void hold_point(mjModel& model, mjData& data, int point, int body, Vec3 on_body);
// Where a point is in the frame of the body that carries the lip.
Vec3 place_of_point(const mjModel& model, int point);
void let_go(mjData& data, const LipPoints& lip);

// How long a sealed lip has been overloaded.
class LipLoad {
 public:
  // After a step. True when the lip lets go: for three steps a third of it had to pull with more
  // than a third of `pull_n`, or what presses it on did not hold it by `friction`. `ahead`: the
  // lip's Z in the world.
  bool breaks(const mjData& data, const LipPoints& lip, Vec3 ahead, double pull_n, double friction);
  int steps() const { return steps_; }

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.steps_);
  }

 private:
  int steps_ = 0;
};

}  // namespace marketgen::physics
