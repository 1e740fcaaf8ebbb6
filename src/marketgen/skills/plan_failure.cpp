#include "skills/plan_failure.h"

namespace marketgen::skills {

bool is_of_planning(const Error& error) {
  return error.code == "robot.unreachable" || error.code.starts_with("motion.") ||
         error.code.starts_with("collect.");
}

std::string_view failure_of_plan(const Error& error) {
  if (error.code == "motion.no_grasp") return "NoGrasp";
  if (error.code == "robot.unreachable") return "NoIK";
  return "NoPath";
}

}  // namespace marketgen::skills
