#include "server/serve.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>
#include <utility>

#include <arpa/inet.h>
#include <fmt/format.h>
#include <malloc.h>

#include "base/interrupt.h"
#include "evaluation/run_record.h"
#include "planners/make_planner.h"
#include "server/http_server.h"
#include "server/page_files.h"
#include "server/viewer.h"

namespace marketgen::server {
namespace {

constexpr std::chrono::milliseconds between_looks{50};
constexpr std::size_t min_token_bytes = 16;
constexpr int max_heaps = 2;  // every thread that answers would keep what it has used in its own

// Only numeric addresses: what a name stands for, others may change.
Result<bool> is_loopback(const std::string& host) {
  in_addr four{};
  in6_addr six{};
  if (inet_pton(AF_INET, host.c_str(), &four) == 1) return ntohl(four.s_addr) >> 24 == 127;
  if (inet_pton(AF_INET6, host.c_str(), &six) == 1) return IN6_IS_ADDR_LOOPBACK(&six) != 0;
  return Error{"usage.bad_flag", "--host", "\"" + host + "\" is no numeric address, as 127.0.0.1"};
}

Result<void> check_host(const ServeOptions& options) {
  MARKETGEN_TRY(const bool loopback, is_loopback(options.host));
  if (!loopback && options.token.size() < min_token_bytes)
    return Error{
        "usage.bad_flag",
        "--token",
        fmt::format("whoever reaches {} could read the stores: give a secret of {} letters "
                    "or more, as `openssl rand -hex 16` makes",
                    options.host,
                    min_token_bytes)};
  return {};
}

Result<void> check_is_folder(const std::string& flag, const std::string& folder) {
  std::error_code failed;
  if (!std::filesystem::exists(folder, failed) || std::filesystem::is_directory(folder, failed))
    return {};
  return Error{"usage.bad_flag", flag, "\"" + folder + "\" is a file: name a folder, new or not"};
}

Result<void> check_folders(const ServeOptions& options) {
  MARKETGEN_CHECK(check_is_folder("--make-in", options.make_in));
  return check_is_folder("--drives", options.drives);
}

// Folders of stores, and of results, which have another file at their top.
struct NamedFolders {
  std::vector<std::string> stores, results;
};

NamedFolders told_apart(const std::vector<std::string>& folders) {
  NamedFolders named;
  std::error_code failed;
  for (const std::string& folder : folders) {
    const bool is_run = std::filesystem::exists(evaluation::record_path(folder), failed);
    (is_run ? named.results : named.stores).push_back(folder);
  }
  return named;
}

// What opens: where results alone were named, the list of their episodes.
std::string first_page(const ServeOptions& options, bool has_stores) {
  const bool list = !has_stores && !options.results.empty();
  std::string page = list ? "?store=0&replay=" : "";
  if (!options.token.empty()) page += (list ? "&token=" : "?token=") + options.token;
  return page;
}

}  // namespace

// The server goes first: its threads ask the viewer. Before it, who sends through it.
struct ViewServer::Parts {
  ~Parts() {
    if (viewer) viewer->stop_driving();
  }
  std::unique_ptr<Viewer> viewer;
  std::unique_ptr<HttpServer> server;
};

ViewServer::ViewServer(std::unique_ptr<Parts> parts, std::string address)
    : parts_(std::move(parts)), address_(std::move(address)) {}
ViewServer::~ViewServer() = default;

Drive& ViewServer::watched() {
  return parts_->viewer->watched();
}

Result<std::unique_ptr<ViewServer>> ViewServer::start(const ServeOptions& options,
                                                      store::OpenedStores stores) {
  MARKETGEN_CHECK(check_host(options));
  MARKETGEN_CHECK(check_folders(options));
  MARKETGEN_TRY(const std::filesystem::path page, page_folder());
  const bool may_edit = !options.read_only && !options.embed;
  const bool has_stores = !stores.stores.empty();
  auto parts = std::make_unique<Parts>();
  MARKETGEN_TRY(parts->viewer,
                Viewer::open(std::move(stores),
                             page,
                             {.may_edit = may_edit,
                              .make_in = options.make_in,
                              .planner = options.planner,
                              .results = options.results,
                              .episodes = options.episodes,
                              .drives = options.drives,
                              .watch = options.watch}));
  HttpServerOptions http;
  http.host = options.host;
  http.port = options.port;
  http.token = options.token;
  http.embed = options.embed;
  http.limits.may_write = may_edit;
  MARKETGEN_TRY(
      parts->server,
      HttpServer::start(
          http,
          [&viewer = *parts->viewer](const web::HttpAsk& ask) { return viewer.answer(ask); },
          [&viewer = *parts->viewer](const web::HttpAsk& ask) { return viewer.socket(ask); }));
  std::string address = parts->server->address() + first_page(options, has_stores);
  return std::unique_ptr<ViewServer>(new ViewServer(std::move(parts), std::move(address)));
}

Result<void> serve(const ServeOptions& options,
                   const std::vector<std::string>& folders,
                   catalog::Catalog rows,
                   const std::function<void(const std::string&)>& opened) {
  MARKETGEN_CHECK(check_host(options));
  MARKETGEN_CHECK(check_folders(options));
  MARKETGEN_CHECK(planners::open_planner_model(options.planner.name, options.planner.access));
  if (const auto page = page_folder(); !page.ok()) return page.error();  // before any work
  mallopt(M_ARENA_MAX, max_heaps);
  const NamedFolders named = told_apart(folders);
  ServeOptions shown = options;
  shown.results.insert(shown.results.end(), named.results.begin(), named.results.end());
  MARKETGEN_TRY(store::OpenedStores stores, store::open_stores(named.stores, std::move(rows)));
  MARKETGEN_TRY(const std::unique_ptr<ViewServer> server,
                ViewServer::start(shown, std::move(stores)));
  opened(server->address());
  while (check_interrupt().ok())
    std::this_thread::sleep_for(between_looks);
  return {};
}

}  // namespace marketgen::server
