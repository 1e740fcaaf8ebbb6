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

namespace marketgen {

class EpisodeGround {
 public:
  // Episodes are drawn from what the store sells. `catalog`: the rows that it was opened with.
  // Error catalog.missing_data.
  static Result<std::shared_ptr<EpisodeGround>> of_store(std::shared_ptr<const Store> store,
                                                         std::shared_ptr<const Catalog> catalog);
  // Episodes are those of the file. Errors: of read_episode_file, usable_catalog.
  static Result<std::shared_ptr<EpisodeGround>> of_file(const std::filesystem::path& file);

  // Episodes are those of data/benchmark/pool, which need no drawing. Errors: as of_file();
  // episode.other_store when products are not as the pool's episodes have them: its files are to be
  // made anew (tools/refresh_pool).
  static Result<std::shared_ptr<EpisodeGround>> of_pool(Track track);

  // Those of the file; none of a store.
  const std::vector<EpisodeSpec>& episodes() const { return file_.episodes; }
  const std::vector<EpisodeStore>& stores() const { return file_.header.stores; }
  // A file's: rows of what its episodes are about. A store's: of all that it sells.
  const std::vector<Product>& products() const { return file_.header.products; }
  const std::filesystem::path& data() const { return data_; }
  const Catalog& catalog() const { return *catalog_; }
  // The catalogue as agents know it, whatever their episode is about: the program's rows and those
  // of the user's own that the stores were made with, sorted by SKU.
  std::vector<Product> known_products() const;

  // A file's: number `seed` of those of the track, round and round. A store's: drawn from the seed,
  // which takes seconds; kept, for those who come back to their seeds. Errors: episode.impossible
  // for a file without such episodes; those of the samplers. `tools`: a tool set of the track's
  // robot, the first when empty.
  Result<EpisodeSpec> draw(Track track, std::uint64_t seed, const std::string& tools = {});
  // As many things as an episode may be about, see TrackEntry::items_of(): of the file, and as many
  // as are drawn from stores.
  int max_items(Track track) const;
  double largest_side_m() const;  // of any of its stores
  // Error episode.other_store: it is of another store.
  Result<void> check(const EpisodeSpec& spec) const;

  // Where they are run.
  Arena& arena() { return arena_; }
  // Of the program; `world` must outlive it. Errors: those of Arena.
  Result<std::unique_ptr<Policy>> policy(const std::string& name, const TrackWorld& world) {
    return arena_.policy(name, world);
  }

 private:
  EpisodeGround(std::filesystem::path data,
                EpisodeFile file,
                std::shared_ptr<const Catalog> catalog);
  Result<EpisodeSpec> pick(Track track, std::uint64_t seed) const;
  Result<EpisodeSpec> sample(Track track, std::uint64_t seed, const std::string& tools);
  struct Sampling;
  Result<std::shared_ptr<Sampling>> sampling(Track track, const std::string& tools);

  std::filesystem::path data_;
  EpisodeFile file_;
  std::shared_ptr<const Catalog> catalog_;
  std::shared_ptr<const Store> store_;  // none of a file
  Arena arena_;                         // reads the header and the catalogue above
  std::mutex mutex_;                    // of what was drawn
  std::map<std::tuple<Track, std::string, std::uint64_t>, EpisodeSpec> drawn_;
};

}  // namespace marketgen
