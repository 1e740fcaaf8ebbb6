#include "server/view_build.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <regex>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <malloc.h>

#include "base/call_interrupt.h"
#include "base/hash.h"
#include "base/interrupt.h"
#include "io/cache_entry.h"
#include "io/file.h"
#include "server/view_fingerprint.h"

namespace marketgen::server {
namespace {

constexpr std::string_view entry_kind = "view/1";
constexpr const char* index_name = "index";
constexpr std::chrono::milliseconds look_again{100};
// Of mip levels: what probes meet is blurred over 0.2 m, and a texel of the fourth level is at most
// 3 cm.
constexpr int levels_unseen = 3;

// Over the bytes that the store is drawn from, and the program that draws it.
std::string key_of(const store::Store& store) {
  Hasher hash;
  hash.add(view_fingerprint);
  for (const store::FileDigest& file : store.manifest.files) {
    if (file.path == "scene.bin") hash.add(file.sha256);
  }
  return hash.add(store.manifest.scene_hash).add(store.manifest.look_hash).hex();
}

// Whether a build makes files of such a name: nobody waits for others.
bool may_come(const std::string& name) {
  static const std::regex names(
      "(room|goods-light|meshes)\\.bin|(goods-|textures/)[0-9]{1,4}\\.jpg");
  return std::regex_match(name, names);
}

// A file's name without folders, for the disk.
std::string flat(std::string name) {
  std::ranges::replace(name, '/', '_');
  return name;
}

}  // namespace

// Progress of the renderer and of goods, for who asks how far it is.
class ViewBuild::Reports : public Progress {
 public:
  explicit Reports(ViewBuild& build) : build_(build) {}
  void begin(std::string_view stage, std::size_t steps) override {
    const std::scoped_lock lock(build_.mutex_);
    build_.status_.stage = stage;
    std::tie(build_.steps_, build_.done_) = std::pair(std::max<std::size_t>(steps, 1), 0);
  }
  void advance(std::size_t steps) override {
    const std::scoped_lock lock(build_.mutex_);
    build_.done_ += steps;
  }
  void end() override {}

 private:
  ViewBuild& build_;
};

ViewBuild::ViewBuild(std::shared_ptr<const store::Store> store, std::mutex& alone)
    : store_(std::move(store)),
      kept_in_(io::cache_folder() / "view" / key_of(*store_)),
      reports_(std::make_unique<Reports>(*this)),
      thread_([this, &alone] { run(alone); }) {}

ViewBuild::~ViewBuild() {
  stop_ = true;
  thread_.join();
}

void ViewBuild::run(std::mutex& alone) {
  const CallInterrupt breaks_off(&stop_);
  const std::scoped_lock lock(alone);
  finish(until_interrupted([&] { return build(); }));
  malloc_trim(0);
}

Result<void> ViewBuild::build() {
  MARKETGEN_CHECK(check_interrupt());
  if (take_kept()) return {};
  malloc_trim(0);  // what opening the store took
  MARKETGEN_CHECK(make_room());
  malloc_trim(0);  // the renderer's world is gone: its memory goes back
  MARKETGEN_CHECK(make_goods());
  keep();
  return {};
}

void ViewBuild::finish(const Result<void>& done) {
  const std::scoped_lock lock(mutex_);
  status_ = {done.ok() ? BuildState::ready : BuildState::failed, "", 1};
  steps_ = done_ = 1;
  if (!done.ok()) error_ = done.error();
  changed_.notify_all();
}

void ViewBuild::add(const std::string& name, const Body& body) {
  const std::scoped_lock lock(mutex_);
  files_[name] = body;
  changed_.notify_all();
}

void ViewBuild::add_all(std::vector<ViewFile> files) {
  for (ViewFile& file : files)
    add(file.name, web::make_body(file.type, std::move(file.bytes)));
}

Result<void> ViewBuild::make_room() {
  MARKETGEN_TRY(const std::unique_ptr<render::raytrace::LitWorld> lit,
                render::raytrace::light_world(store_->scene,
                                              {},
                                              *reports_,
                                              {.print = render::PrintDetail::distant,
                                               .goods = assets::Detail::far,
                                               .coarser = levels_unseen},
                                              true));
  MARKETGEN_CHECK(check_interrupt());
  reports_->begin("room", 1);
  render::raytrace::drop_bvhs(*lit->world);  // all light is stored by now
  malloc_trim(0);
  MARKETGEN_TRY(std::vector<ViewFile> files, room_files(*lit, store_->scene));
  files.push_back(goods_light(*lit, store_->scene));
  add_all(std::move(files));
  return {};
}

Result<void> ViewBuild::make_goods() {
  MARKETGEN_TRY(std::vector<ViewFile> files, goods_meshes(store_->scene, *reports_));
  add_all(std::move(files));
  return {};
}

bool ViewBuild::take_kept() {
  const std::optional<std::string> index = io::kept_entry(kept_in_ / index_name, entry_kind);
  if (!index) return false;
  std::map<std::string, Body> files;
  std::istringstream lines(*index);
  for (std::string name, type; lines >> name >> type;) {
    std::optional<std::string> bytes = io::kept_entry(kept_in_ / flat(name), entry_kind);
    if (!bytes) return false;
    files[name] = web::made_body(type, *std::move(bytes));
  }
  for (const auto& [name, body] : files)
    add(name, body);
  return true;
}

// The index last: without it nothing is taken.
void ViewBuild::keep() const {
  const std::scoped_lock lock(mutex_);
  std::string index;
  for (const auto& [name, body] : files_) {
    index += fmt::format("{} {}\n", name, body->type);
    if (!io::keep_entry(kept_in_ / flat(name), entry_kind, body->bytes).ok()) return;
  }
  // keep_entry() has said what could not be written; it costs the time to make it again.
  static_cast<void>(io::keep_entry(kept_in_ / index_name, entry_kind, index));
}

Result<ViewBuild::Body> ViewBuild::file(const std::string& name) {
  std::unique_lock lock(mutex_);
  while (true) {
    const auto found = files_.find(name);
    if (found != files_.end()) return found->second;
    if (error_) return *error_;
    if (status_.state != BuildState::building || !may_come(name))
      return Error{"server.not_found", name, "the store has no such file"};
    if (stop_) return interrupted_error();
    MARKETGEN_CHECK(check_interrupt());
    changed_.wait_for(lock, look_again);
  }
}

BuildStatus ViewBuild::status() const {
  const std::scoped_lock lock(mutex_);
  BuildStatus status = status_;
  if (status.state == BuildState::building)
    status.share = std::min(1.0, static_cast<double>(done_) / static_cast<double>(steps_));
  return status;
}

std::optional<Error> ViewBuild::error() const {
  const std::scoped_lock lock(mutex_);
  return error_;
}

}  // namespace marketgen::server
