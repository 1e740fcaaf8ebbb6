// A robot and where it stands, as a person writes it: "realman-rm65@4.2,3.1,90,lift=0.3".
//
//   ROW@X,Y[,HEADING][,KEY=VALUE]...
//
//   ROW           id of a row in data/robots, or the file of one's own: mine/cart.json
//   X,Y           of its base frame in the store frame, metres
//   HEADING       where its X axis looks, degrees: 0 is east, 90 north; 0 when left out
//   z=METRES      height of its base, 0 when left out: the floor
//   posture=NAME  one of the row's; the row's first when left out, else every joint near 0
//   JOINT=VALUE   over the posture's; radians or metres, or degrees as "45deg"
//   SLOT=ROW      another tool: left_tool=suction-cup; mine/hook.json
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "robots/robot_row.h"

namespace marketgen::robots {

// The text taken apart; no name in it has been looked up.
struct RobotSpec {
  struct JointSetting {
    std::string joint;
    double value = 0;
    JointUnit unit = JointUnit::si;
  };
  std::string row;
  Vec3 position;           // of the base frame, store frame, m
  double heading_deg = 0;  // of the base frame's X axis, from east towards north
  std::string posture;     // empty: the row's first
  std::vector<JointSetting> joints;
  RobotTools tools;
};

struct PlacedRobot {
  std::string where;  // how errors name it: the flag and the text
  Robot robot;
  std::vector<double> q;  // within its limits, followers set
  Pose world_from_base;   // store frame
};

// Error: robot.bad_spec, with what is missing, doubled or no number. `where` is in every error.
Result<RobotSpec> parse_robot_spec(std::string_view text, const std::string& where);

// Loads the row and sets its state. Errors, each at `where`: robot.unknown with the nearest row,
// posture, joint or slot; robot.bad_state for a joint outside its limits, one that follows another,
// or degrees of a joint that slides; those of load_robot.
Result<PlacedRobot> place_robot(const std::filesystem::path& data,
                                const RobotSpec& spec,
                                const std::string& where);

}  // namespace marketgen::robots
