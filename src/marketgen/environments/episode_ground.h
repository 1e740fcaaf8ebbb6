// What environments run episodes in: one opened store, or the stores of an episodes file.
//
// Any number of environments and threads may share one. What they share beyond that (opened stores,
// renderers) is the arena's.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "catalog/catalog.h"
#include "environments/arena.h"
#include "environments/episode_sampler.h"
#include "store/store.h"

namespace marketgen::environments {

class EpisodeGround {
 public:
  // Episodes are drawn from what the store sells. `catalog`: the rows that it was opened with.
  // Error catalog.missing_data.
  static Result<std::shared_ptr<EpisodeGround>> of_store(
      std::shared_ptr<const store::Store> store, std::shared_ptr<const catalog::Catalog> catalog);
  // Episodes are those of the file. Errors: of read_episode_file, usable_catalog.
  static Result<std::shared_ptr<EpisodeGround>> of_file(const std::filesystem::path& file);

  // Episodes are those of data/benchmark/pool, which need no drawing. Errors: as of_file();
  // episode.other_store when products are not as the pool's episodes have them: its files are to be
  // made anew (tools/refresh_pool).
  static Result<std::shared_ptr<EpisodeGround>> of_pool(episodes::Track track);

  // Those of the file; none of a store.
  const std::vector<episodes::EpisodeSpec>& episodes() const { return file_.episodes; }
  const std::vector<episodes::EpisodeStore>& stores() const { return file_.header.stores; }
  // A file's: rows of what its episodes are about. A store's: of all that it sells.
  const std::vector<catalog::Product>& products() const { return arena_.products(); }
  const std::filesystem::path& data() const { return data_; }
  const catalog::Catalog& catalog() const { return *catalog_; }
  // The catalogue as agents know it, whatever their episode is about: the rows of a file's
  // episodes, the program's and those of the user's own that the stores were made with, sorted by
  // SKU.
  std::vector<catalog::Product> known_products() const;

  // A file's: number `seed` of those of the track, round and round. A store's: drawn from the seed,
  // which takes seconds; kept, for those who come back to their seeds. Errors: episode.impossible
  // for a file without such episodes; those of the samplers. `tools`: a tool set of the track's
  // robot, the first when empty. Tools and split say nothing of a file, whose episodes are drawn.
  Result<episodes::EpisodeSpec> draw(episodes::Track track,
                                     std::uint64_t seed,
                                     const std::string& tools = {},
                                     episodes::Split split = episodes::Split::planned);
  // As many things as an episode may be about, see TrackEntry::items_of(): of the file, and as many
  // as are drawn from stores.
  int max_items(episodes::Track track) const;
  double largest_side_m() const;  // of any of its stores
  // Error episode.other_store: it is of another store.
  Result<void> check(const episodes::EpisodeSpec& spec) const;

  // Where they are run.
  Arena& arena() { return arena_; }
  // Of the program; `world` must outlive it. Errors: those of Arena.
  Result<std::unique_ptr<agent::Policy>> policy(const std::string& name,
                                                const episodes::TrackWorld& world) {
    return arena_.policy(name, world);
  }

 private:
  EpisodeGround(std::filesystem::path data,
                episodes::EpisodeFile file,
                std::shared_ptr<const catalog::Catalog> catalog);
  Result<episodes::EpisodeSpec> pick(episodes::Track track, std::uint64_t seed) const;
  Result<episodes::EpisodeSpec> sample(episodes::Track track,
                                       std::uint64_t seed,
                                       const std::string& tools,
                                       episodes::Split split);
  struct Sampling;
  Result<std::shared_ptr<Sampling>> sampling(episodes::Track track,
                                             const std::string& tools,
                                             episodes::Split split);

  std::filesystem::path data_;
  episodes::EpisodeFile file_;
  std::shared_ptr<const catalog::Catalog> catalog_;
  std::shared_ptr<const store::Store> store_;  // none of a file
  Arena arena_;                                // reads the header and the catalogue above
  std::mutex mutex_;                           // of what was drawn
  std::map<std::tuple<episodes::Track, std::string, episodes::Split, std::uint64_t>,
           episodes::EpisodeSpec>
      drawn_;
};

}  // namespace marketgen::environments
