// What a policy has seen that was trained on files of episodes, so that tasks can be drawn which
// test it on what it has not seen.
#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/product.h"
#include "episodes/episode_spec.h"

namespace marketgen::episodes {

// EpisodeExclusion::reason of products that the training set has.
constexpr std::string_view seen_in_training = "seen_in_training";

// Immutable; without files nothing was seen.
class TrainingSet {
 public:
  TrainingSet() = default;
  // Of all the files' episodes: products are those that are goals or lie in baskets, layouts and
  // looks those of the stores. Nothing but what is in `unseen` counts as seen.
  static TrainingSet of(const std::vector<EpisodeFile>& files, std::vector<Unseen> unseen);
  // Errors: those of read_episode_file.
  static Result<TrainingSet> read(const std::vector<std::filesystem::path>& files,
                                  std::vector<Unseen> unseen);

  // This product, or one that is easily taken for it (catalog/look_alike.h).
  bool has(const catalog::Product& product) const;
  // Error episode.seen: the store has a layout, or a look, of the training stores; which.
  Result<void> check_store(const EpisodeStore& store) const;
  // For the header of what is drawn; none without files.
  std::optional<UnseenRow> row() const;

 private:
  bool asks_for(Unseen kind) const;
  std::vector<Unseen> unseen_;
  std::map<std::string, catalog::Product> products_;    // by SKU
  std::map<std::string, std::string> layouts_, looks_;  // a store's name by what its plan says
  bool any_ = false;
};

}  // namespace marketgen::episodes
