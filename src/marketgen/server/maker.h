// The addresses below /api/make: a page describes a store, compares what comes of it with several
// seeds, and keeps one as a folder.
//
// What is made is what `marketgen generate` makes of the same words, pictures and seed. One brief
// at a time: a new one takes the place of the one before. Nothing is written before one is kept,
// but for dropped files while they are read.
#pragma once
#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"
#include "planners/make_planner.h"
#include "server/dropped_brief.h"
#include "server/make_documents.h"
#include "server/show_saved.h"
#include "store/made_store.h"
#include "web/http_message.h"

namespace marketgen::server {

// A language model that pages may let plan: none but that which the server was started with, since
// it costs whose key it is.
struct OfferedPlanner {
  std::string name = "offline";
  planners::PlannerAccess access;
};

class Maker {
 public:
  // `folder`: in which stores are kept.
  Maker(std::shared_ptr<const catalog::Catalog> catalog,
        std::filesystem::path folder,
        ShowSaved show,
        OfferedPlanner planner = {});
  ~Maker();  // waits for the stage that is under way
  Maker(const Maker&) = delete;
  Maker& operator=(const Maker&) = delete;

  // `words`: the address after /api/make. Errors: server.not_found, server.bad_request, json.* of
  // the body, those of store::save_made. Thread-safe.
  Result<web::HttpReply> get(const web::HttpAsk& ask, const std::vector<std::string>& words);
  Result<web::HttpReply> post(const std::string& verb, const web::HttpAsk& ask);

 private:
  struct Try {
    TryLine line;
    std::shared_ptr<const store::MadeStore> made;
    std::shared_ptr<const catalog::Catalog> catalog;  // of which it was made
    std::shared_ptr<const web::HttpBody> picture;
  };
  struct Batch {
    int number = 0;
    TryAsk ask;
    std::shared_ptr<std::atomic<bool>> given_up = std::make_shared<std::atomic<bool>>(false);
    std::vector<std::string> warnings;
    std::optional<SaidError> error;
    std::vector<Try> tries;
  };

  Result<web::HttpReply> begin(const web::HttpAsk& ask);
  Result<web::HttpReply> keep(const web::HttpAsk& ask);
  Result<web::HttpReply> picture(const web::HttpAsk& ask, const std::string& name);
  web::HttpReply options() const;
  web::HttpReply state();
  std::string free_name(const std::string& name, std::uint64_t seed) const;

  void work();  // of the thread
  void make(int batch, const TryAsk& ask);
  void make_one(int batch, std::size_t row, const AskedStore& asked, std::uint64_t seed);
  Result<void> check(const TryAsk& ask) const;
  std::vector<std::string> planners() const;
  TriedStore described(const store::MadeStore& made) const;
  // What `change` does to the batch, unless another has taken its place: false then.
  template <class Change>
  bool note(int batch, const Change& change);
  // One that is ready.
  Result<Try> made(const web::HttpAsk& ask, int batch, std::uint64_t seed);

  std::shared_ptr<const catalog::Catalog> catalog_;
  std::filesystem::path folder_;
  ShowSaved show_;
  OfferedPlanner planner_;
  std::mutex drawing_, mutex_;  // mutex_: of what follows
  std::condition_variable called_;
  Batch batch_;
  bool waiting_ = false, ends_ = false;
  std::thread worker_;
};

// Whether it says why a store is not kept where a person wants it: an answer like others, as
// is_refused_edit().
bool is_refused_keeping(const Error& error);

}  // namespace marketgen::server
