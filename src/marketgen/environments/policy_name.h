// A policy by its name, as `--policy` and results have it: "oracle"; "classical+masks+target" when
// modules of `classical` know the truth; "vlm(openai:gpt-4o)" when a model chooses its targets;
// "hybrid(target=openai:gpt-4o,masks=http://localhost:5002)" when parts of it run elsewhere.
#pragma once
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace marketgen::environments {

// A module of `classical` in whose place the truth may stand, which shows what that module costs.
// masks: which pixels belong together; in a store, where on a shelf something stands. target: which
// of them is asked for, and how it lies. grasp: where it can be held, past what truly stands there.
// language: which product the words of a goal mean.
enum class TrueModule { masks, target, grasp, language };
constexpr std::array<std::string_view, 4> names_of(TrueModule) {
  return {"masks", "target", "grasp", "language"};
}

struct PolicyName {
  std::string name;
  std::string model = {};  // PROVIDER:MODEL; of `vlm`, which has one, and `hybrid`, which may
  // Servers of masks and of grasps, of `hybrid`; empty: the program's own.
  std::string masks_url = {}, grasps_url = {};
  std::vector<TrueModule> truth = {};  // ascending, each once

  bool has_servers() const { return !masks_url.empty() || !grasps_url.empty(); }
  bool knows(TrueModule module) const { return std::ranges::find(truth, module) != truth.end(); }
  std::string written() const;  // which read_policy_name reads
};

// A policy that knows nothing of what is asked for: what it scores is the floor under every score.
bool is_floor(std::string_view policy);

// Error usage.bad_flag: no such policy, no such module, or a policy that has no modules; `vlm`
// without its model, `hybrid` without any part; the truth in the place of a part that runs
// elsewhere. Error net.bad_url: a server's.
Result<PolicyName> read_policy_name(const std::string& text);

}  // namespace marketgen::environments
