#include "environments/episode_ground.h"

#include <algorithm>

#include <fmt/format.h>

#include "assets/usable_catalog.h"
#include "catalog/catalog.h"
#include "environments/environment_entry.h"
#include "episodes/track_entry.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::environments {
namespace {

constexpr std::size_t max_kept_episodes = 1000;

}  // namespace

// Samplers of the store, and of all stores.
struct EpisodeGround::Sampling {
  std::unique_ptr<EpisodeSampler> all;
  std::unique_ptr<StoreSampler> of_store;
};

EpisodeGround::EpisodeGround(std::filesystem::path data,
                             episodes::EpisodeFile file,
                             std::shared_ptr<const catalog::Catalog> catalog)
    : data_(std::move(data)),
      file_(std::move(file)),
      catalog_(std::move(catalog)),
      arena_(data_, file_.header, *catalog_) {}

Result<std::shared_ptr<EpisodeGround>> EpisodeGround::of_store(
    std::shared_ptr<const store::Store> store, std::shared_ptr<const catalog::Catalog> catalog) {
  MARKETGEN_TRY(std::filesystem::path data, io::data_folder());
  episodes::EpisodeFile file;
  file.header.stores = {store_row(*store)};
  file.header.products = episodes::store_stock(store->scene);
  std::shared_ptr<EpisodeGround> ground(
      new EpisodeGround(std::move(data), std::move(file), std::move(catalog)));
  ground->arena_.offer(store);
  ground->store_ = std::move(store);
  return ground;
}

Result<std::shared_ptr<EpisodeGround>> EpisodeGround::of_file(const std::filesystem::path& file) {
  MARKETGEN_TRY(std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(episodes::EpisodeFile read, episodes::read_episode_file(file));
  MARKETGEN_TRY(catalog::Catalog catalog, assets::usable_catalog());
  return std::shared_ptr<EpisodeGround>(
      new EpisodeGround(std::move(data),
                        std::move(read),
                        std::make_shared<const catalog::Catalog>(std::move(catalog))));
}

Result<std::shared_ptr<EpisodeGround>> EpisodeGround::of_pool(episodes::Track track) {
  MARKETGEN_TRY(std::filesystem::path data, io::data_folder());
  const std::filesystem::path name =
      std::filesystem::path("benchmark") / "pool" / fmt::format("{}.jsonl", name_of(track));
  MARKETGEN_TRY(episodes::EpisodeFile read, episodes::read_episode_file(data / name));
  MARKETGEN_TRY(catalog::Catalog catalog, catalog::load_catalog(data, {}));
  for (const catalog::Product& product : read.header.products) {
    const auto row = std::ranges::find(catalog.products, product.sku, &catalog::Product::sku);
    if (row != catalog.products.end() &&
        catalog::line_without_contents(*row) == catalog::line_without_contents(product))
      continue;
    return Error{"episode.other_store",
                 name.string(),
                 fmt::format("the product \"{}\" is no longer as the pool's episodes have it: make "
                             "the pool anew with tools/refresh_pool, or give a store or a file of "
                             "episodes of your own",
                             product.sku)};
  }
  return std::shared_ptr<EpisodeGround>(
      new EpisodeGround(std::move(data),
                        std::move(read),
                        std::make_shared<const catalog::Catalog>(std::move(catalog))));
}

int EpisodeGround::max_items(episodes::Track track) const {
  const episodes::TrackEntry& entry = episodes::entry_of(track);
  int most = entry.max_items();
  for (const episodes::EpisodeSpec& spec : file_.episodes)
    if (spec.track == track) most = std::max(most, entry.items_of(spec));
  return most;
}

double EpisodeGround::largest_side_m() const {
  int max_mm = 0;
  for (const episodes::EpisodeStore& store : file_.header.stores)
    max_mm = std::max({max_mm, store.plan.shell.width_mm, store.plan.shell.depth_mm});
  return max_mm * 1e-3;
}

std::vector<catalog::Product> EpisodeGround::known_products() const {
  std::map<std::string, catalog::Product> rows;
  if (!store_)  // as the episodes have them, whatever the program's say today
    for (const catalog::Product& row : products())
      rows.emplace(row.sku, row);
  for (const catalog::Product& row : catalog_->products)
    rows.emplace(row.sku, row);
  for (const episodes::EpisodeStore& store : file_.header.stores)
    for (const catalog::Product& row : store.own.value_or(std::vector<catalog::Product>{}))
      rows.emplace(row.sku, row);
  std::vector<catalog::Product> known;
  for (auto& [sku, row] : rows)
    known.push_back(std::move(row));
  return known;
}

Result<void> EpisodeGround::check(const episodes::EpisodeSpec& spec) const {
  Result<void> last = Error{"episode.other_store", spec.id, "there is no store"};
  for (const episodes::EpisodeStore& store : file_.header.stores) {
    last = episodes::check_store(spec, store.scene_hash, store.plan_hash);
    if (last.ok()) break;
  }
  return last;
}

Result<episodes::EpisodeSpec> EpisodeGround::pick(episodes::Track track, std::uint64_t seed) const {
  std::vector<const episodes::EpisodeSpec*> of_track;
  for (const episodes::EpisodeSpec& spec : file_.episodes)
    if (spec.track == track) of_track.push_back(&spec);
  if (of_track.empty())
    return Error{"episode.impossible",
                 "episodes",
                 fmt::format("the file has no episodes of the track {}", name_of(track))};
  return *of_track[seed % of_track.size()];
}

Result<std::shared_ptr<EpisodeGround::Sampling>> EpisodeGround::sampling(episodes::Track track,
                                                                         const std::string& tools,
                                                                         episodes::Split split) {
  const std::string key = fmt::format("{} {} {}", name_of(track), tools, name_of(split));
  return arena_.shared().get<Sampling>(key, [&]() -> Result<std::shared_ptr<Sampling>> {
    const episodes::EpisodeStore& row = file_.header.stores.front();
    auto made = std::make_shared<Sampling>();
    MARKETGEN_TRY(made->all, environment_entry_of(track).sampler(arena_, tools, {split}));
    MARKETGEN_TRY(made->of_store, made->all->of_store({row.name, row.scene_hash, row.plan_hash}));
    return made;
  });
}

Result<episodes::EpisodeSpec> EpisodeGround::sample(episodes::Track track,
                                                    std::uint64_t seed,
                                                    const std::string& tools,
                                                    episodes::Split split) {
  MARKETGEN_TRY(const auto drawing, sampling(track, tools, split));
  auto spec = drawing->of_store->sample(Seed(seed), 0);
  MARKETGEN_CHECK(drawing->all->keep());
  return spec;
}

Result<episodes::EpisodeSpec> EpisodeGround::draw(episodes::Track track,
                                                  std::uint64_t seed,
                                                  const std::string& tools,
                                                  episodes::Split split) {
  if (!store_) return pick(track, seed);
  const std::tuple key{track, tools, split, seed};
  {
    const std::scoped_lock lock(mutex_);
    if (const auto kept = drawn_.find(key); kept != drawn_.end()) return kept->second;
  }
  MARKETGEN_TRY(episodes::EpisodeSpec spec, sample(track, seed, tools, split));
  const std::scoped_lock lock(mutex_);
  if (drawn_.size() >= max_kept_episodes) drawn_.clear();
  drawn_.try_emplace(key, spec);
  return spec;
}

}  // namespace marketgen::environments
