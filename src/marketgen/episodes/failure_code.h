// Why an episode failed, as one code.
#pragma once
#include <array>
#include <string_view>

namespace marketgen::episodes {

// What kept the agent from its goals, as far as it can be told.
enum class FailureCode {
  none,
  not_found,
  no_grasp,
  no_ik,
  no_path,
  missed,
  wrong_item,
  slipped,
  dropped,
  collision,
  timeout,
  policy_error,  // it threw, hung, or told what is no action
  not_run,       // the episode itself could not be run
  unknown        // nobody can say
};
constexpr std::array<std::string_view, 14> names_of(FailureCode) {
  return {"None",
          "NotFound",
          "NoGrasp",
          "NoIK",
          "NoPath",
          "Missed",
          "WrongItem",
          "Slipped",
          "Dropped",
          "Collision",
          "Timeout",
          "PolicyError",
          "NotRun",
          "Unknown"};
}

}  // namespace marketgen::episodes
