// The addresses of recorded episodes, below those of the store in which they happened:
// /api/stores/N/runs and /api/stores/N/places (docs/viewer.md).
#pragma once
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"
#include "server/replay_episode.h"
#include "server/replay_runs.h"
#include "store/store.h"
#include "web/http_message.h"

namespace marketgen::server {

// Thread-safe.
class Replays {
 public:
  // `catalog` outlives it. Errors: those of ReplayRuns::check_shown_in.
  static Result<std::unique_ptr<Replays>> open(
      ReplayRuns runs,
      std::vector<std::shared_ptr<const store::Store>> stores,
      const catalog::Catalog& catalog);

  // What is below /runs of a store. `words`: the path's parts behind it.
  Result<web::HttpReply> answer(std::size_t store,
                                const web::HttpAsk& ask,
                                const std::vector<std::string>& words);

  // The place below /places of a store, which is added where it is new; -1: the store itself.
  // Precondition: the store is one of those it was opened with.
  int number_of(std::size_t store, const episodes::RecordedPlace& place);
  // A place of the store, as a store of its own; known once one of its episodes was asked for.
  // Null: there is none of that number.
  std::shared_ptr<const store::Store> place(std::size_t store, std::uint64_t number);

 private:
  struct Place {
    std::size_t store = 0;
    std::string id;
    std::shared_ptr<const store::Store> made;
  };
  using Key = std::pair<std::size_t, std::size_t>;  // run, episode
  Replays(ReplayRuns runs,
          std::vector<std::shared_ptr<const store::Store>> stores,
          const catalog::Catalog& catalog)
      : runs_(std::move(runs)), stores_(std::move(stores)), catalog_(catalog) {}

  Result<std::shared_ptr<ReplayEpisode>> episode(std::size_t store, const Key& key);
  Result<web::HttpReply> of_episode(std::size_t store,
                                    const web::HttpAsk& ask,
                                    const Key& key,
                                    const std::vector<std::string>& words);
  Result<web::HttpReply> summary(std::size_t store, const ReplayEpisode& episode);
  Result<web::HttpReply> picture(const std::shared_ptr<ReplayEpisode>& episode,
                                 const web::HttpAsk& ask);
  static Result<web::HttpReply> poses(const ReplayEpisode& episode, const web::HttpAsk& ask);

  ReplayRuns runs_;
  std::vector<std::shared_ptr<const store::Store>> stores_;
  const catalog::Catalog& catalog_;
  std::mutex mutex_;                                                  // of all below
  std::list<std::pair<Key, std::shared_ptr<ReplayEpisode>>> opened_;  // newest first
  std::vector<Place> places_;

  // Who took the last picture: a renderer is large, and one episode is looked at at a time.
  std::mutex taking_;
  std::shared_ptr<ReplayEpisode> taken_of_;
  std::unique_ptr<episodes::RecordedView> taker_;  // reads taken_of_
};

}  // namespace marketgen::server
