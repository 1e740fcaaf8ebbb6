// Where episodes of a file are run: opens each one's world and puts a policy into it.
//
// Stores are made again from the plans in the file's header, once each, and shared. Thread-safe;
// every world is one thread's.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "agent/policy.h"
#include "base/shared_objects.h"
#include "catalog/catalog.h"
#include "episodes/episode_spec.h"
#include "episodes/perturbation.h"
#include "episodes/track_world.h"
#include "llm/language_model.h"
#include "perception/look_library.h"
#include "store/store.h"

namespace marketgen::environments {

// The store as a header of episodes has it; what no task asks for is the sampler's to add.
episodes::EpisodeStore store_row(const store::Store& store);

class Arena {
 public:
  // All of them must outlive the arena.
  Arena(const std::filesystem::path& data,
        const episodes::EpisodeHeader& header,
        const catalog::Catalog& catalog);

  // Reset to the episode. Errors: those of the track's world; episode.other_store when the header's
  // plan does not give the store that the episode was drawn from. With a perturbation the world is
  // a little other than the episode says (episodes/perturbation.h); the realism says what stands
  // between it and its robot.
  Result<std::unique_ptr<episodes::TrackWorld>> open(
      const episodes::EpisodeSpec& spec,
      const std::optional<episodes::Perturbation>& perturbation = {},
      const episodes::Realism& realism = {});

  // How models and servers of policies (`vlm`, `hybrid`) are reached; their names are the
  // policies'. Before policy().
  void reach_models(const llm::ModelChoice& access) { access_ = access; }
  // One connection for all episodes. Errors: those of llm::open_language_model.
  Result<std::shared_ptr<const llm::LanguageModel>> model(const std::string& name);

  // For all servers of parts, in all episodes. Errors: those of net::HttpClient::open.
  Result<std::shared_ptr<const net::HttpClient>> part_client();

  // `world` must outlive it. Errors: usage.bad_flag, there is no such policy; those of what it is
  // made of.
  Result<std::unique_ptr<agent::Policy>> policy(const std::string& name,
                                                const episodes::TrackWorld& world);

  // From now on this store is taken as it is, and not made again from its plan.
  void offer(std::shared_ptr<const store::Store> store);

  // A store as it was stocked. One that was not offered is made at each call. Errors:
  // episode.other_store.
  Result<std::shared_ptr<const scene::Scene>> scene(const std::string& scene_hash);

  // What the store sells, sorted by SKU: what an agent in it knows of, whatever an episode is
  // about. Errors: as scene().
  Result<std::shared_ptr<const std::vector<catalog::Product>>> stock(const std::string& scene_hash);

  const std::filesystem::path& data() const { return data_; }
  const episodes::EpisodeHeader& header() const { return header_; }
  const catalog::Catalog& catalog() const { return catalog_; }
  // The header's rows of goods, and what is seen of them as the catalogue has it now.
  const std::vector<catalog::Product>& products() const { return products_; }
  perception::LookLibrary& looks() { return looks_; }
  SharedObjects& shared() { return shared_; }

 private:
  std::filesystem::path data_;
  const episodes::EpisodeHeader& header_;
  const catalog::Catalog& catalog_;
  std::vector<catalog::Product> products_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const store::Store>> offered_;  // by scene hash
  llm::ModelChoice access_;
  SharedObjects shared_;
  perception::LookLibrary looks_;
};

}  // namespace marketgen::environments
