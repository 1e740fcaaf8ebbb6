#include "environments/policy_name.h"

#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/fields.h"

namespace marketgen::environments {
namespace {

constexpr std::array<std::string_view, 7> policies{
    "classical", "highest", "oracle", "oracle-plain", "oracle-thorough", "random", "stop"};
constexpr std::array<std::string_view, 3> floors{"highest", "random", "stop"};

}  // namespace

std::string PolicyName::written() const {
  std::string text = name;
  for (const TrueModule module : truth)
    text += fmt::format("+{}", name_of(module));
  return text;
}

bool is_floor(std::string_view policy) {
  return std::ranges::find(floors, policy) != floors.end();
}

Result<PolicyName> read_policy_name(const std::string& text) {
  std::istringstream parts(text);
  PolicyName policy;
  std::getline(parts, policy.name, '+');
  if (std::ranges::find(policies, policy.name) == policies.end())
    return Error{
        "usage.bad_flag",
        "--policy",
        fmt::format(
            "there is no policy \"{}\"; there are: {}", policy.name, fmt::join(policies, ", "))};
  for (std::string part; std::getline(parts, part, '+');) {
    const auto module = value_named<TrueModule>(part);
    if (!module)
      return Error{"usage.bad_flag",
                   "--truth",
                   fmt::format("there is no module \"{}\"; there are: {}",
                               part,
                               fmt::join(names_of(TrueModule{}), ", "))};
    if (!policy.knows(*module)) policy.truth.push_back(*module);
  }
  if (!policy.truth.empty() && policy.name != "classical")
    return Error{"usage.bad_flag",
                 "--truth",
                 fmt::format("{} has no modules to replace; classical has", policy.name)};
  std::ranges::sort(policy.truth);
  return policy;
}

}  // namespace marketgen::environments
