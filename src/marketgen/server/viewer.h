// The viewer of stores: every address of its server and what it answers. docs/viewer.md lists them.
//
// What writes has addresses of its own below /api/stores/N/edit (editor.h) and /api/make (maker.h);
// the other answers only read.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <semaphore>
#include <shared_mutex>
#include <string>
#include <vector>

#include "base/result.h"
#include "server/cards.h"
#include "server/drive.h"
#include "server/maker.h"
#include "server/replays.h"
#include "server/store_search.h"
#include "server/store_summary.h"
#include "server/view_build.h"
#include "server/web_socket.h"
#include "store/open_stores.h"
#include "web/http_message.h"

namespace marketgen::server {

struct ViewerOptions {
  bool may_edit = true;                     // and make, and drive
  std::filesystem::path make_in = ".";      // where stores are kept that a page has made
  OfferedPlanner planner = {};              // beside the offline one
  std::vector<std::string> results = {};    // folders of evaluations in the stores
  std::string episodes = {};                // file of those that are driven; empty: they are drawn
  std::filesystem::path drives = "drives";  // where logs of drives are kept
  bool watch = false;  // pages look on at an episode in the first store that a program steps
};

class Viewer {
 public:
  // Begins to build what the page draws. Behind the stores are those that travel with the episodes
  // of the results (environments/travelling_stores.h). Errors: those of ReplayRuns::read,
  // with_travelling_stores, StoreSearch::open, read_grasp_facts(), Replays::open and
  // EpisodeGround::of_file; episode.other_store, none of the stores has an episode of the file.
  static Result<std::unique_ptr<Viewer>> open(store::OpenedStores stores,
                                              std::filesystem::path page,
                                              const ViewerOptions& options = {});
  ~Viewer();

  // Thread-safe.
  web::HttpReply answer(const web::HttpAsk& ask);
  // Of /api/stores/N/drive/socket. Errors: server.not_found, server.refused. Thread-safe.
  Result<std::unique_ptr<SocketPeer>> socket(const web::HttpAsk& ask);
  // Precondition: ViewerOptions::watch.
  Drive& watched();
  // Before who carries the sockets goes.
  void stop_driving();

 private:
  struct Opened;
  using Words = std::vector<std::string>;
  Viewer(store::OpenedStores stores, std::filesystem::path page, ViewerOptions options);

  std::unique_ptr<Opened> made(int number,
                               std::shared_ptr<const store::Store> store,
                               const PageRights& rights);
  Result<web::HttpReply> reply_to(const web::HttpAsk& ask);
  web::HttpReply list() const;
  Result<Opened*> opened(const web::HttpAsk& ask, const std::string& number) const;
  Result<web::HttpReply> of_store(Opened& store, const web::HttpAsk& ask, const Words& words);
  // What does not wait for a build: search, cards, shapes and labels.
  Result<web::HttpReply> of_scene(const scene::Scene& scene,
                                  const web::HttpAsk& ask,
                                  const Words& words);
  Result<web::HttpReply> of_make(const web::HttpAsk& ask, const Words& words);
  Result<web::HttpReply> of_edit(Opened& store, const web::HttpAsk& ask, const Words& words);
  Result<web::HttpReply> of_drive(Opened& store, const web::HttpAsk& ask, const Words& words);
  Result<void> offer_drives();
  DriveGround ground_of(const Opened& opened);
  // With its own products.
  std::shared_ptr<const catalog::Catalog> rows_of(const store::Store& store) const;
  Result<web::HttpReply> of_replay(Opened& store, const web::HttpAsk& ask, const Words& words);
  Result<web::HttpReply> of_sku(const scene::Scene& scene,
                                const web::HttpAsk& ask,
                                const Words& words);
  Result<web::HttpReply> search(const scene::Scene& scene, const web::HttpAsk& ask);
  static Result<web::HttpReply> blocks(const scene::Scene& scene, const web::HttpAsk& ask);
  Result<web::HttpReply> tag(const scene::Scene& scene,
                             const web::HttpAsk& ask,
                             const std::string& name);
  Result<web::HttpReply> label(const scene::Scene& scene,
                               std::uint32_t sku,
                               const web::HttpAsk& ask);
  Result<web::HttpReply> state(Opened& store);
  ViewBuild& build_of(Opened& store);
  // A store that takes part from now on; its number.
  int add(std::shared_ptr<const store::Store> store, const PageRights& rights);
  PageRights rights_in(bool has_folder) const;
  Result<int> add_saved(const std::filesystem::path& folder, const catalog::Catalog& rows);

  catalog::Catalog catalog_;
  std::shared_ptr<const catalog::Catalog> rows_;  // without the stores' own goods
  ViewerOptions options_;
  std::filesystem::path page_;
  std::unique_ptr<StoreSearch> search_;
  GraspFacts grasps_;
  std::mutex building_;
  std::counting_semaphore<> drawing_;  // labels and meshes at a time
  std::unique_ptr<Replays> replays_;
  mutable std::shared_mutex listing_;  // of stores_, which grows when an edit is saved
  std::vector<std::unique_ptr<Opened>> stores_;
  std::mutex opening_;
  std::map<std::uint32_t, std::unique_ptr<Opened>> places_;  // by number, once they are asked for
  std::unique_ptr<Maker> maker_;  // goes first: what it keeps is added to stores_
};

}  // namespace marketgen::server
