// Driving a differential base along a floor path: turn in place at a corner, drive straight to the
// next, stop for whoever walks in the way, go on when the way is free.
//
// The point that follows the path is the middle between the wheels, about which the base turns. The
// base counts as round. The follower is stepped at a fixed rate and looks at the obstacles of that
// moment; it keeps the speed, turn rate and accelerations of the robot's row at every step, and
// never drives so fast that it could not stop within them. Metres, radians, seconds; world frame.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "geometry/vector.h"
#include "navigation/visibility_graph.h"
#include "robots/robot.h"

namespace marketgen::motion {

struct BaseLimits {
  double speed = 0, acceleration = 0;           // of the middle between the wheels
  double turn_rate = 0, turn_acceleration = 0;  // about it
  double wheel_track = 0, wheel_radius = 0;
};
// From the drive of the robot's row and the acceleration of its joint "base_yaw". Errors:
// motion.bad_limits when it has no drive or a limit is missing.
Result<BaseLimits> base_limits(const robots::Robot& robot);

// Somebody on the floor. How fast they can come nearer is added to what the base keeps clear.
struct MovingDisc {
  Vec2 position;
  double radius = 0, speed = 0;
};

struct BaseState {
  Vec2 position;
  double heading = 0;  // about Z from X
  double speed = 0, turn_rate = 0;
};
struct WheelRates {
  double left = 0, right = 0;  // rad/s
};

struct BaseOptions {
  double base_radius = 0.4;  // m
  double margin = 0.10;      // kept between the base and a disc, m
  double reaction_s = 0.1;   // until a stop begins
};

class BaseFollower {
 public:
  // Starts at rest on the path's first point. `end_heading`: turned to at the end. Errors:
  // motion.bad_configuration (no point, or a heading that is not finite), motion.bad_limits.
  static Result<BaseFollower> make(const navigation::FloorPath& path,
                                   double heading,
                                   std::optional<double> end_heading,
                                   const BaseLimits& limits,
                                   const BaseOptions& options = {});

  // Moves on by `dt` > 0 seconds. For a disc that is not finite, which may be anywhere, it stops.
  const BaseState& step(double dt, std::span<const MovingDisc> discs = {});

  const BaseState& state() const { return state_; }
  WheelRates wheels() const;
  bool done() const { return next_ >= legs_.size(); }
  bool waits() const { return waits_; }  // a disc kept it from going on in the last step

 private:
  struct Leg {  // a turn in place to `heading`, or a straight way along it
    bool turns = false;
    double heading = 0, length = 0;
    Vec2 from;
  };
  void turn(const Leg& leg, double dt);
  void drive(const Leg& leg, double dt, std::span<const MovingDisc> discs);
  double room_ahead(const Leg& leg, std::span<const MovingDisc> discs) const;

  BaseLimits limits_;
  BaseOptions options_;
  std::vector<Leg> legs_;
  std::size_t next_ = 0;
  double driven_ = 0;  // of the current leg, m
  double left_ = 0;    // of the current turn, rad, signed
  bool turning_ = false;
  bool waits_ = false;
  BaseState state_;
};

}  // namespace marketgen::motion
