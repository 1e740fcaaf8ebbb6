// The viewer of stores: every address of its server and what it answers. docs/viewer.md lists them.
//
// What sessions add later (editing, driving, over websockets) gets a folder and addresses of its
// own below /api/stores/N/; the answers here stay read-only.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <semaphore>
#include <string>
#include <vector>

#include "base/result.h"
#include "server/cards.h"
#include "server/http_message.h"
#include "server/replays.h"
#include "server/store_search.h"
#include "server/view_build.h"
#include "store/open_stores.h"

namespace marketgen::server {

class Viewer {
 public:
  // Begins to build what the page draws. `results`: folders of evaluations in these stores. Errors:
  // those of StoreSearch::open, read_grasp_facts() and Replays::open.
  static Result<std::unique_ptr<Viewer>> open(store::OpenedStores stores,
                                              std::filesystem::path page,
                                              const std::vector<std::string>& results = {});
  ~Viewer();

  // Thread-safe.
  HttpReply answer(const HttpAsk& ask);

 private:
  struct Opened;
  using Words = std::vector<std::string>;
  Viewer(catalog::Catalog catalog, std::filesystem::path page);

  std::unique_ptr<Opened> opened(int number, std::shared_ptr<const store::Store> store);
  Result<HttpReply> reply_to(const HttpAsk& ask);
  Result<HttpReply> of_store(Opened& store, const HttpAsk& ask, const Words& words);
  Result<HttpReply> of_replay(Opened& store, const HttpAsk& ask, const Words& words);
  Result<HttpReply> of_sku(Opened& store, const HttpAsk& ask, const Words& words);
  Result<HttpReply> search(const Opened& store, const HttpAsk& ask);
  Result<HttpReply> tag(const Opened& store, const HttpAsk& ask, const std::string& name);
  Result<HttpReply> label(const Opened& store, std::uint32_t sku, const HttpAsk& ask);
  static Result<HttpReply> state(const Opened& store);

  catalog::Catalog catalog_;
  std::filesystem::path page_;
  std::unique_ptr<StoreSearch> search_;
  GraspFacts grasps_;
  std::mutex building_;
  std::counting_semaphore<> drawing_;  // labels and meshes at a time
  std::unique_ptr<Replays> replays_;
  std::vector<std::unique_ptr<Opened>> stores_;
  std::mutex opening_;
  std::map<std::uint32_t, std::unique_ptr<Opened>> places_;  // by number, once they are asked for
};

}  // namespace marketgen::server
