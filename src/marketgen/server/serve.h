// Stores in a browser: `marketgen view`, and what a notebook shows.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"
#include "server/drive.h"
#include "server/maker.h"
#include "store/open_stores.h"

namespace marketgen::server {

struct ServeOptions {
  std::vector<std::string> results;  // folders of evaluations
  std::string episodes;              // file of those that are driven; empty: they are drawn
  std::string drives = "drives";     // where logs of drives are kept
  std::string host = "127.0.0.1";
  int port = 0;               // 0: any free one
  std::string token;          // needed for a host other than loopback
  bool read_only = false;     // nothing is edited, made or driven
  std::string make_in = ".";  // where stores are kept that a page has made
  OfferedPlanner planner;     // for stores that are made, beside the offline one
  bool embed = false;  // pages of this machine, as a notebook's, may show it in a frame; no edits
  bool watch = false;  // pages look on at an episode in the first store that a program steps
};

class ViewServer {
 public:
  // Answers until it is destroyed. Errors: usage.bad_flag (a host without a token, a host that is
  // no numeric address), usage.unavailable (no page), server.cannot_listen; those of Viewer::open.
  static Result<std::unique_ptr<ViewServer>> start(const ServeOptions& options,
                                                   store::OpenedStores stores);
  ViewServer(const ViewServer&) = delete;
  ViewServer& operator=(const ViewServer&) = delete;
  ~ViewServer();

  // With the token; without a store, of the list of episodes that the results have.
  const std::string& address() const { return address_; }
  Drive& watched();  // precondition: ServeOptions::watch

 private:
  struct Parts;
  ViewServer(std::unique_ptr<Parts> parts, std::string address);
  std::unique_ptr<Parts> parts_;
  std::string address_;
};

// `marketgen view`: calls `opened` with the address once it answers, then serves until it is
// interrupted, its orderly end. `folders`: of stores, and of evaluations, which are results.
// Errors: of ViewServer::start, open_stores; internal.interrupted.
Result<void> serve(const ServeOptions& options,
                   const std::vector<std::string>& folders,
                   catalog::Catalog rows,
                   const std::function<void(const std::string&)>& opened);

}  // namespace marketgen::server
