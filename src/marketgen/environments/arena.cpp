#include "environments/arena.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/complete_contents.h"
#include "catalog/user_products.h"
#include "environments/environment_entry.h"
#include "environments/policy_name.h"
#include "environments/track_policies.h"
#include "episodes/episode_origin.h"
#include "episodes/frozen_store.h"
#include "oracle/oracle_search.h"
#include "policy/floor_policies.h"

namespace marketgen::environments {
namespace {

constexpr int max_part_attempts = 2;
// Forty masks of a whole picture as rows of booleans; what is recorded can be read again.
constexpr std::size_t max_part_answer_bytes = std::size_t{240} << 20;

}  // namespace

episodes::EpisodeStore store_row(const store::Store& store) {
  const store::Manifest& m = store.manifest;
  return {m.name, m.scene_hash, episodes::plan_hash(store.plan), m.seed, store.plan, {}, m.own, {}};
}

Arena::Arena(const std::filesystem::path& data,
             const episodes::EpisodeHeader& header,
             const catalog::Catalog& catalog)
    : data_(data), header_(header), catalog_(catalog), products_(header.products) {
  catalog::complete_contents(products_, catalog);
}

void Arena::offer(std::shared_ptr<const store::Store> store) {
  const std::scoped_lock lock(mutex_);
  offered_[store->manifest.scene_hash] = std::move(store);
}

Result<std::shared_ptr<const scene::Scene>> Arena::scene(const std::string& scene_hash) {
  {
    const std::scoped_lock lock(mutex_);
    if (const auto offered = offered_.find(scene_hash); offered != offered_.end())
      return std::shared_ptr<const scene::Scene>(offered->second, &offered->second->scene);
  }
  const auto row =
      std::ranges::find(header_.stores, scene_hash, &episodes::EpisodeStore::scene_hash);
  if (row == header_.stores.end())
    return Error{"episode.other_store", scene_hash, "the header has no store of this scene"};
  if (row->scene) return episodes::open_frozen_scene(*row, catalog_);
  MARKETGEN_TRY(scene::Scene scene,
                row->own
                    ? store::scene_of_plan(
                          row->plan, catalog::with_own_products(catalog_, *row->own), row->seed)
                    : store::scene_of_plan(row->plan, catalog_, row->seed));
  if (const std::string made = marketgen::scene::scene_hash(scene); made != scene_hash)
    return Error{
        "episode.other_store",
        row->name,
        fmt::format("its plan gives scene {}, the episodes are of {}: another catalogue or "
                    "version of marketgen drew them; draw them again",
                    made,
                    scene_hash)};
  return std::shared_ptr<const scene::Scene>(std::make_shared<scene::Scene>(std::move(scene)));
}

Result<std::shared_ptr<const std::vector<catalog::Product>>> Arena::stock(
    const std::string& scene_hash) {
  using Stock = const std::vector<catalog::Product>;
  return shared_.get<Stock>(scene_hash, [&]() -> Result<std::shared_ptr<Stock>> {
    MARKETGEN_TRY(const auto made, scene(scene_hash));
    return std::make_shared<Stock>(episodes::store_stock(*made));
  });
}

Result<std::shared_ptr<const llm::LanguageModel>> Arena::model(const std::string& name) {
  using Model = const llm::LanguageModel;
  return shared_.get<Model>(name, [&]() -> Result<std::shared_ptr<Model>> {
    llm::ModelChoice choice = access_;
    choice.model = name;
    MARKETGEN_TRY(llm::LanguageModel opened, llm::open_language_model(choice));
    return std::make_shared<Model>(std::move(opened));
  });
}

Result<std::shared_ptr<const net::HttpClient>> Arena::part_client() {
  using Client = const net::HttpClient;
  return shared_.get<Client>("parts", [&]() -> Result<std::shared_ptr<Client>> {
    net::HttpOptions options{access_.limits, access_.record, access_.replay};
    options.limits.attempts = max_part_attempts;
    options.limits.answer_bytes = max_part_answer_bytes;
    MARKETGEN_TRY(net::HttpClient opened, net::HttpClient::open(options));
    return std::make_shared<Client>(std::move(opened));
  });
}

Result<std::unique_ptr<episodes::TrackWorld>> Arena::open(
    const episodes::EpisodeSpec& spec,
    const std::optional<episodes::Perturbation>& perturbation,
    const episodes::Realism& realism) {
  return environment_entry_of(spec.track).open(*this, spec, perturbation, realism);
}

Result<std::unique_ptr<agent::Policy>> Arena::policy(const std::string& name,
                                                     const episodes::TrackWorld& world) {
  MARKETGEN_TRY(const PolicyName asked, read_policy_name(name));
  // vlm and hybrid move as classical does: where others say nothing, the same comes of it.
  const bool asks_others = !asked.model.empty() || asked.has_servers();
  const std::string moves_as = asks_others ? "classical" : asked.name;
  const Seed seed = Seed(world.spec().seed).child(moves_as);
  if (asked.name == "random")
    return std::unique_ptr<agent::Policy>(
        std::make_unique<policy::RandomPolicy>(seed, world.robot().drive.has_value()));
  if (asked.name == "stop")
    return std::unique_ptr<agent::Policy>(std::make_unique<policy::StopPolicy>());
  return std::visit(
      [&](const auto* of_track) {
        if (const auto search = oracle::oracle_search(asked.name))
          return make_oracle(*this, *of_track, *search, seed);
        if (asked.name == "highest") return make_highest(*this, *of_track, seed);
        return make_classical(*this, *of_track, asked, seed);
      },
      world.any());
}

}  // namespace marketgen::environments
