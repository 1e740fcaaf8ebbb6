// The servers of a policy's parts.
#pragma once
#include <memory>
#include <optional>

#include "environments/arena.h"
#include "environments/policy_name.h"
#include "perception/part_server.h"

namespace marketgen::environments {

struct PartServers {
  std::shared_ptr<perception::PartServer> masks, grasps;  // null: the program's own part

  // Nothing of a policy whose parts are all the program's own.
  std::optional<agent::PartsUse> use() const;
};

// Errors: those of Arena::part_client.
Result<PartServers> part_servers(const PolicyName& name, Arena& arena);

}  // namespace marketgen::environments
