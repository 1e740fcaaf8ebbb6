// What a page draws a store with, made beside the server's work and kept on disk.
//
// The room comes first, then the light on goods, then their meshes. Who asks for a file that is not
// there yet waits for it. Entries (io/cache_entry.h) lie under $MARKETGEN_CACHE/view, by the
// store's bytes and the sources that make them.
#pragma once
#include <atomic>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "base/fields.h"
#include "base/progress.h"
#include "base/result.h"
#include "server/view_files.h"
#include "store/store.h"
#include "web/http_message.h"

namespace marketgen::server {

enum class BuildState { building, ready, failed };
constexpr std::array<std::string_view, 3> names_of(BuildState) {
  return {"building", "ready", "failed"};
}

struct BuildStatus {
  BuildState state = BuildState::building;
  std::string stage;
  double share = 0;  // of the stage, 0..1
  static constexpr auto fields =
      field_list(field("state", &BuildStatus::state, "building, ready or failed"),
                 field("stage", &BuildStatus::stage, "what is being done"),
                 field("share", &BuildStatus::share, "of it, 0..1"));
};

class ViewBuild {
 public:
  using Body = std::shared_ptr<const web::HttpBody>;

  // Begins at once. `alone` is held while it works, so that several stores come one after another.
  ViewBuild(std::shared_ptr<const store::Store> store, std::mutex& alone);
  ViewBuild(const ViewBuild&) = delete;
  ViewBuild& operator=(const ViewBuild&) = delete;
  // Breaks off what is not finished.
  ~ViewBuild();

  // Waits for it. Errors: server.not_found; what the build failed with; internal.interrupted.
  Result<Body> file(const std::string& name);
  BuildStatus status() const;
  std::optional<Error> error() const;

 private:
  class Reports;
  void run(std::mutex& alone);
  Result<void> build();
  bool take_kept();
  void add(const std::string& name, const Body& body);
  void add_all(std::vector<ViewFile> files);
  Result<void> make_room();
  Result<void> make_goods();
  void keep() const;
  void finish(const Result<void>& done);

  std::shared_ptr<const store::Store> store_;
  std::filesystem::path kept_in_;
  std::atomic<bool> stop_ = false;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, Body> files_;
  BuildStatus status_;
  std::size_t steps_ = 1, done_ = 0;
  std::optional<Error> error_;
  std::unique_ptr<Reports> reports_;
  std::thread thread_;
};

}  // namespace marketgen::server
