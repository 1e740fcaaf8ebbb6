// Where episodes of a file are run: opens each one's world and puts a policy into it.
//
// Stores of in-aisle episodes are made again from the plans in the file's header, once each, and
// shared. Thread-safe; every world is one thread's.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "agent/policy.h"
#include "catalog/catalog.h"
#include "episodes/aisle_store.h"
#include "episodes/episode_spec.h"
#include "episodes/track_world.h"
#include "perception/look_library.h"
#include "store/store.h"

namespace marketgen {

class Arena {
 public:
  // All of them must outlive the arena.
  Arena(const std::filesystem::path& data, const EpisodeHeader& header, const Catalog& catalog)
      : data_(data), header_(header), catalog_(catalog) {}

  // Reset to the episode. Errors: those of CheckoutWorld and AisleWorld; episode.other_store when
  // the header's plan does not give the store that the episode was drawn from.
  Result<std::unique_ptr<TrackWorld>> open(const EpisodeSpec& spec);

  // `world` must outlive it. Error usage.bad_flag: there is no such policy for the episode's track.
  Result<std::unique_ptr<Policy>> policy(const std::string& name, const TrackWorld& world);

  // From now on this store is taken as it is, and not made again from its plan.
  void offer(std::shared_ptr<const Store> store);

  // What the store sells, sorted by SKU: what an agent in it knows of, whatever an episode is
  // about. Errors: as open().
  Result<std::shared_ptr<const std::vector<Product>>> stock(const std::string& scene_hash);

  // The store of in-aisle episodes. Errors: as open().
  Result<std::shared_ptr<const AisleStore>> aisle_store(const std::string& scene_hash,
                                                        const std::string& tools);

 private:
  Result<Scene> scene_of(const std::string& scene_hash) const;

  std::filesystem::path data_;
  const EpisodeHeader& header_;
  const Catalog& catalog_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const Store>> offered_;  // by scene hash
  std::map<std::pair<std::string, std::string>, std::shared_ptr<const AisleStore>>
      stores_;  // by scene hash and tool set
  std::map<std::string, std::shared_ptr<const std::vector<Product>>> stocks_;  // by scene hash
  LookLibrary looks_;
};

}  // namespace marketgen
