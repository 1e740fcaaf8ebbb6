#include "environments/policy_name.h"

#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/fields.h"
#include "environments/policies.h"

namespace marketgen::environments {
namespace {

constexpr std::array<std::string_view, 3> floors{"highest", "random", "stop"};

constexpr std::string_view with_model = "vlm";

Error bad(const char* flag, std::string why) {
  return {"usage.bad_flag", flag, std::move(why)};
}

// A model's name may have a + in it: its bracket ends it.
std::size_t end_of_name(const std::string& text) {
  const std::size_t bracket = text.rfind(')');
  return std::min(text.size(), text.find('+', bracket == std::string::npos ? 0 : bracket));
}

// "vlm(PROVIDER:MODEL)", or a name alone.
Result<PolicyName> without_truth(const std::string& text) {
  const std::size_t open = text.find('(');
  PolicyName policy{text.substr(0, open)};
  if (std::ranges::find(policies, policy.name) == policies.end())
    return bad(
        "--policy",
        fmt::format(
            "there is no policy \"{}\"; there are: {}", policy.name, fmt::join(policies, ", ")));
  const bool closed = open != std::string::npos && text.ends_with(')');
  if (closed) policy.model = text.substr(open + 1, text.size() - open - 2);
  if (policy.name == with_model && policy.model.empty())
    return bad("--model",
               "vlm needs a model that sees pictures: --policy vlm --model openai:gpt-4o, or "
               "\"vlm(openai:gpt-4o)\" in one");
  if (policy.name != with_model && open != std::string::npos)
    return bad("--policy", fmt::format("\"{}\": of all policies vlm alone has a model", text));
  return policy;
}

Result<void> check_truth(const PolicyName& policy) {
  if (policy.truth.empty()) return {};
  if (policy.name != "classical" && policy.name != with_model)
    return bad("--truth",
               fmt::format("{} has no modules to replace; classical and vlm have", policy.name));
  if (policy.name == with_model && policy.knows(TrueModule::target))
    return bad("--truth", "the target is what the model of vlm chooses: take classical");
  return {};
}

}  // namespace

std::string PolicyName::written() const {
  std::string text = model.empty() ? name : fmt::format("{}({})", name, model);
  for (const TrueModule module : truth)
    text += fmt::format("+{}", name_of(module));
  return text;
}

bool is_floor(std::string_view policy) {
  return std::ranges::find(floors, policy) != floors.end();
}

Result<PolicyName> read_policy_name(const std::string& text) {
  const std::size_t named = end_of_name(text);
  MARKETGEN_TRY(PolicyName policy, without_truth(text.substr(0, named)));
  std::istringstream parts(text.substr(std::min(text.size(), named + 1)));
  for (std::string part; std::getline(parts, part, '+');) {
    const auto module = value_named<TrueModule>(part);
    if (!module)
      return bad("--truth",
                 fmt::format("there is no module \"{}\"; there are: {}",
                             part,
                             fmt::join(names_of(TrueModule{}), ", ")));
    if (!policy.knows(*module)) policy.truth.push_back(*module);
  }
  MARKETGEN_CHECK(check_truth(policy));
  std::ranges::sort(policy.truth);
  return policy;
}

}  // namespace marketgen::environments
