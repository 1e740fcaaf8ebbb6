#include "episodes/training_set.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/hash.h"
#include "catalog/look_alike.h"
#include "io/json.h"

namespace marketgen::episodes {
namespace {

// Walls, zones and fixtures: the plan without its name, its look and where its values came from.
std::string layout_of(plan::Plan plan) {
  plan.name.clear();
  plan.look = {};
  plan.provenance.clear();
  return io::write_json(plan);
}

std::string look_of(const plan::Plan& plan) {
  return io::write_json(plan.look);
}

Error seen(const EpisodeStore& store,
           std::string_view what,
           const std::string& as,
           const char* remedy) {
  return Error{"episode.seen",
               store.name,
               fmt::format("its {} is that of the training store \"{}\": {}", what, as, remedy)};
}

}  // namespace

TrainingSet TrainingSet::of(const std::vector<EpisodeFile>& files, std::vector<Unseen> unseen) {
  TrainingSet set;
  set.unseen_ = std::move(unseen);
  set.any_ = !files.empty();
  for (const EpisodeFile& file : files) {
    std::set<std::string> shown;
    for (const EpisodeSpec& spec : file.episodes)
      shown.merge(skus_of(spec));
    for (const catalog::Product& row : file.header.products)
      if (shown.contains(row.sku)) set.products_.emplace(row.sku, row);
    for (const EpisodeStore& store : file.header.stores) {
      set.layouts_.emplace(layout_of(store.plan), store.name);
      set.looks_.emplace(look_of(store.plan), store.name);
    }
  }
  return set;
}

Result<TrainingSet> TrainingSet::read(const std::vector<std::filesystem::path>& files,
                                      std::vector<Unseen> unseen) {
  std::vector<EpisodeFile> read;
  for (const std::filesystem::path& file : files) {
    MARKETGEN_TRY(EpisodeFile episodes, read_episode_file(file));
    read.push_back(std::move(episodes));
  }
  return of(read, std::move(unseen));
}

bool TrainingSet::asks_for(Unseen kind) const {
  return std::ranges::find(unseen_, kind) != unseen_.end();
}

bool TrainingSet::has(const catalog::Product& product) const {
  if (!asks_for(Unseen::products)) return false;
  return products_.contains(product.sku) || std::ranges::any_of(products_, [&](const auto& known) {
           return catalog::are_look_alikes(product, known.second);
         });
}

Result<void> TrainingSet::check_store(const EpisodeStore& store) const {
  const auto layout = layouts_.find(layout_of(store.plan));
  if (asks_for(Unseen::layouts) && layout != layouts_.end())
    return seen(store, "layout", layout->second, "make a store with another seed or other words");
  const auto look = looks_.find(look_of(store.plan));
  if (asks_for(Unseen::looks) && look != looks_.end())
    return seen(store,
                "look",
                look->second,
                "ask for another style, other materials or another light, or leave looks out of "
                "--unseen");
  return {};
}

std::optional<UnseenRow> TrainingSet::row() const {
  if (!any_) return std::nullopt;
  Hasher hasher;
  for (const auto& [sku, product] : products_)
    hasher.add(sku);
  for (const auto& [layout, store] : layouts_)
    hasher.add(layout);
  for (const auto& [look, store] : looks_)
    hasher.add(look);
  return UnseenRow{unseen_, hasher.hex()};
}

}  // namespace marketgen::episodes
