#include "environments/policy_name.h"

#include <map>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/fields.h"
#include "environments/policies.h"
#include "net/http.h"

namespace marketgen::environments {
namespace {

constexpr std::array<std::string_view, 3> floors{"highest", "random", "stop"};

constexpr std::string_view with_model = "vlm", with_parts = "hybrid";

Error bad(const char* flag, std::string why) {
  return {"usage.bad_flag", flag, std::move(why)};
}

// A model's name may have a + in it: its bracket ends it.
std::size_t end_of_name(const std::string& text) {
  const std::size_t bracket = text.rfind(')');
  return std::min(text.size(), text.find('+', bracket == std::string::npos ? 0 : bracket));
}

// "target=PROVIDER:MODEL,masks=URL,grasps=URL", any of them.
Result<void> read_parts(const std::string& text, PolicyName& policy) {
  const std::map<std::string, std::string*> parts{
      {"target", &policy.model}, {"masks", &policy.masks_url}, {"grasps", &policy.grasps_url}};
  std::istringstream list(text);
  for (std::string part; std::getline(list, part, ',');) {
    const std::size_t equals = std::min(part.find('='), part.size());
    const auto known = parts.find(part.substr(0, equals));
    if (known == parts.end() || equals + 1 >= part.size() || !known->second->empty())
      return bad("--policy",
                 fmt::format("\"{}\" is no part of hybrid: it has target=PROVIDER:MODEL, masks=URL "
                             "and grasps=URL, each once",
                             part));
    *known->second = part.substr(equals + 1);
  }
  for (const std::string* url : {&policy.masks_url, &policy.grasps_url}) {
    if (url->empty()) continue;
    MARKETGEN_CHECK(net::origin_of(*url));
  }
  return {};
}

Result<void> check_whole(const PolicyName& policy) {
  if (policy.name == with_model && policy.model.empty())
    return bad("--model",
               "vlm needs a model that sees pictures: --policy vlm --model openai:gpt-4o, or "
               "\"vlm(openai:gpt-4o)\" in one");
  if (policy.name == with_parts && policy.model.empty() && !policy.has_servers())
    return bad("--policy",
               "hybrid needs a part that runs elsewhere: --masks-url, --grasps-url or --model");
  return {};
}

// "vlm(PROVIDER:MODEL)", "hybrid(PART=...)", or a name alone.
Result<PolicyName> without_truth(const std::string& text) {
  const std::size_t open = text.find('(');
  PolicyName policy{text.substr(0, open)};
  if (std::ranges::find(policies, policy.name) == policies.end())
    return bad(
        "--policy",
        fmt::format(
            "there is no policy \"{}\"; there are: {}", policy.name, fmt::join(policies, ", ")));
  const bool closed = open != std::string::npos && text.ends_with(')');
  if (open != std::string::npos && !closed)
    return bad("--policy", fmt::format("\"{}\" has no closing bracket at its end", text));
  const std::string inside = closed ? text.substr(open + 1, text.size() - open - 2) : "";
  if (policy.name == with_model) {
    policy.model = inside;
  } else if (policy.name == with_parts) {
    MARKETGEN_CHECK(read_parts(inside, policy));
  } else if (open != std::string::npos) {
    return bad(
        "--policy",
        fmt::format("\"{}\": of all policies vlm alone has a model, and hybrid parts", text));
  }
  MARKETGEN_CHECK(check_whole(policy));
  return policy;
}

Result<void> check_truth(const PolicyName& policy) {
  if (policy.truth.empty()) return {};
  if (policy.name != "classical" && policy.name != with_model && policy.name != with_parts)
    return bad(
        "--truth",
        fmt::format("{} has no modules to replace; classical, vlm and hybrid have", policy.name));
  if (!policy.model.empty() && policy.knows(TrueModule::target))
    return bad(
        "--truth",
        fmt::format("the target is what the model of {} chooses: take classical", policy.name));
  if ((!policy.masks_url.empty() && policy.knows(TrueModule::masks)) ||
      (!policy.grasps_url.empty() && policy.knows(TrueModule::grasp)))
    return bad("--truth", "a module of hybrid is either the truth's or a server's");
  return {};
}

}  // namespace

std::string PolicyName::written() const {
  std::vector<std::string> parts;
  for (const auto& [part, value] : {std::pair{"target=", &model},
                                    std::pair{"masks=", &masks_url},
                                    std::pair{"grasps=", &grasps_url}})
    if (!value->empty()) parts.push_back((name == with_parts ? part : "") + *value);
  std::string text = parts.empty() ? name : fmt::format("{}({})", name, fmt::join(parts, ","));
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
