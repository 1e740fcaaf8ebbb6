#include <cstring>
#include <nlohmann/json.hpp>

#include "base/progress.h"
#include "bench/bench.h"
#include "bench/sample_store.h"
#include "io/gzip.h"
#include "server/cards.h"
#include "server/editor.h"
#include "web/http_message.h"

namespace marketgen::bench {
namespace {

using Json = nlohmann::json;

// A page that edits, without a socket between it and the server.
class Page {
 public:
  // `grasps` must outlive it.
  Page(std::shared_ptr<const store::Store> store,
       const catalog::Catalog& catalog,
       const server::GraspFacts& grasps)
      : editor_(std::move(store),
                std::make_shared<const catalog::Catalog>(catalog),
                grasps,
                [](const std::filesystem::path&) -> Result<int> { return 0; }) {}

  Result<web::HttpReply> post(const std::string& verb, Json body = Json::object()) {
    body["token"] = token_;
    web::HttpAsk ask;
    ask.method = "POST";
    ask.body = body.dump();
    return editor_.post(verb, ask);
  }
  // The head of what it is given.
  Result<Json> begin() {
    MARKETGEN_TRY(const web::HttpReply reply, post("begin"));
    MARKETGEN_TRY(const std::string bytes,
                  reply.body->packed ? io::gunzip(reply.body->bytes, "begin")
                                     : Result<std::string>(reply.body->bytes));
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + 4, sizeof length);
    Json head = Json::parse(bytes.substr(8, length));
    token_ = head["token"];
    return head;
  }

 private:
  server::Editor editor_;
  std::string token_;
};

Json border(const Json& cut, double by) {
  return {{"patches",
           {{{"set_ratio", {{"node", cut["node"]}, {"ratio", cut["ratio"].get<double>() + by}}}}}}};
}

// The first border that can be moved: cuts come with the whole floor's first, so that much changes.
Result<Json> movable(Page& page, const Json& cuts) {
  constexpr double by = -0.02;
  for (const Json& cut : cuts) {
    const auto done = page.post("patches", border(cut, by));
    if (!done.ok()) continue;
    MARKETGEN_CHECK(page.post("undo"));
    return border(cut, by);
  }
  return Error{"internal.bug", "bench edit", "no border of the store can be moved"};
}

Json place(const server::RunBlock& block) {
  return {{"fixture", block.fixture},
          {"side", name_of(block.side)},
          {"shelf", block.shelf},
          {"position", block.position}};
}

// The first two blocks of the store's first line that may change places, from shelf to shelf.
Result<Json> swappable(Page& page, const scene::Scene& scene) {
  const scene::SceneShelf& shelf = scene.shelves[scene.facings.front().shelf];
  const std::vector<server::RunBlock> blocks =
      server::blocks_of_run(scene, scene.layout.fixtures[shelf.fixture].run).blocks;
  for (const server::RunBlock& one : blocks) {
    for (const server::RunBlock& other : blocks) {
      if (other.shelf <= one.shelf) continue;
      const Json swap = {
          {"patches", {{{"swap_blocks", {{"a", place(one)}, {"b", place(other)}}}}}}};
      if (page.post("preview", swap).ok()) return swap;
    }
  }
  return Error{"internal.bug", "bench edit", "no two blocks of the first line can be swapped"};
}

// Medians of what a page waits for; seconds and kilobytes.
struct Waits {
  double preview_s = 0, change_s = 0, undo_s = 0, sent_kb = 0;
};

Result<Waits> waits_of(Page& page, const Json& patches, int runs) {
  std::vector<double> preview, change, undo, sent;
  for (int run = 0; run <= runs; ++run) {
    const double look = median_seconds(1, [&] { (void)page.post("preview", patches).ok(); });
    const double start = monotonic_seconds();
    MARKETGEN_TRY(const web::HttpReply changed, page.post("patches", patches));
    const double done = monotonic_seconds();
    MARKETGEN_CHECK(page.post("undo"));
    const double back = monotonic_seconds();
    if (run == 0) continue;  // not counted
    preview.push_back(look);
    change.push_back(done - start);
    undo.push_back(back - done);
    sent.push_back(static_cast<double>(changed.body->bytes.size()) / 1e3);
  }
  return Waits{median(preview), median(change), median(undo), median(sent)};
}

}  // namespace

Figures run_edit(const catalog::Catalog& catalog) {
  const ScratchFolder scratch;
  const store::CreateOptions options = neighbourhood_store(scratch / "store", false);
  MARKETGEN_CHECK(store::create_store(options, catalog));
  MARKETGEN_TRY(store::Store opened, store::open_store(options.folder, catalog));
  const auto products = static_cast<double>(opened.scene.products.size());
  MARKETGEN_TRY(const server::GraspFacts grasps, server::read_grasp_facts());
  const auto shared = std::make_shared<const store::Store>(std::move(opened));
  Page page(shared, catalog, grasps);
  MARKETGEN_TRY(const Json head, page.begin());
  MARKETGEN_TRY(const Json patches, movable(page, head["cuts"]));

  MARKETGEN_TRY(const Json swap, swappable(page, shared->scene));
  constexpr int runs = 9;
  MARKETGEN_TRY(const Waits border, waits_of(page, patches, runs));
  MARKETGEN_TRY(const Waits block, waits_of(page, swap, runs));
  const std::string machine = machine_name();
  const auto figure = [&](const char* name, double value, const char* unit, int n) {
    return Figure{name, value, unit, n, std::nullopt, std::nullopt, machine};
  };
  return std::vector<Figure>{figure("edit_products", products, "items", 1),
                             figure("edit_preview_s", border.preview_s, "s", runs),
                             figure("edit_border_s", border.change_s, "s", runs),
                             figure("edit_border_sent_kb", border.sent_kb, "kB", runs),
                             figure("edit_undo_s", border.undo_s, "s", runs),
                             figure("edit_swap_preview_s", block.preview_s, "s", runs),
                             figure("edit_swap_s", block.change_s, "s", runs),
                             figure("edit_swap_sent_kb", block.sent_kb, "kB", runs)};
}

}  // namespace marketgen::bench
