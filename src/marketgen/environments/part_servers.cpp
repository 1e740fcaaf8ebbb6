#include "environments/part_servers.h"

#include "perception/served_grasps.h"
#include "perception/served_masks.h"

namespace marketgen::environments {

std::optional<agent::PartsUse> PartServers::use() const {
  if (!masks && !grasps) return std::nullopt;
  agent::PartsUse use;
  if (masks) use.masks = masks->use();
  if (grasps) use.grasps = grasps->use();
  return use;
}

Result<PartServers> part_servers(const PolicyName& name, Arena& arena) {
  PartServers servers;
  if (!name.has_servers()) return servers;
  MARKETGEN_TRY(const auto client, arena.part_client());
  if (!name.masks_url.empty())
    servers.masks = std::make_shared<perception::PartServer>(
        name.masks_url, perception::mask_server_path, client);
  if (!name.grasps_url.empty())
    servers.grasps = std::make_shared<perception::PartServer>(
        name.grasps_url, perception::grasp_server_path, client);
  return servers;
}

}  // namespace marketgen::environments
