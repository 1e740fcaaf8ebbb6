#include "server/viewer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/build_info.h"
#include "base/interrupt.h"
#include "base/parallel.h"
#include "export/label_picture.h"
#include "io/json.h"
#include "io/png.h"
#include "server/page_files.h"
#include "server/store_summary.h"
#include "server/view_files.h"

namespace marketgen::server {
namespace {

constexpr std::array label_heights_px{64, 128, 256, 512, 1024};
constexpr int min_tag_px = 32, max_tag_px = 192, usual_tag_px = 96, usual_label_px = 512;
constexpr std::uint64_t usual_hits = 50, max_hits = 500;

Error no_address(const HttpAsk& ask) {
  return {"server.not_found", ask.path, "there is nothing at this address; see docs/viewer.md"};
}

// All of the text, without a sign.
std::optional<std::uint64_t> whole(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

Result<std::uint32_t> row_of(const HttpAsk& ask, std::string_view text, std::size_t rows) {
  const std::optional<std::uint64_t> row = whole(text);
  if (row && *row < rows) return static_cast<std::uint32_t>(*row);
  return Error{"server.not_found", ask.path, fmt::format("rows go from 0 to {} here", rows - 1)};
}

// A number in the query; `usual` when it is not there.
Result<std::uint64_t> number_in(const HttpAsk& ask,
                                const std::string& name,
                                std::uint64_t usual,
                                std::uint64_t low,
                                std::uint64_t high) {
  const auto given = ask.query.find(name);
  if (given == ask.query.end()) return usual;
  const std::optional<std::uint64_t> value = whole(given->second);
  if (value && *value >= low && *value <= high) return *value;
  return Error{
      "server.bad_request", name, fmt::format("is not a whole number from {} to {}", low, high)};
}

Result<HttpReply> reply_with(ViewFile file) {
  return HttpReply{.body = make_body(std::move(file.type), std::move(file.bytes))};
}

Result<HttpReply> png_reply(const Result<Image>& image) {
  if (!image.ok()) return image.error();
  MARKETGEN_TRY(std::string bytes, io::encode_png(*image));
  return reply_with({"", "image/png", std::move(bytes)});
}

// Among those who draw.
class Turn {
 public:
  explicit Turn(std::counting_semaphore<>& turns) : turns_(turns) { turns_.acquire(); }
  ~Turn() { turns_.release(); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  std::counting_semaphore<>& turns_;
};

}  // namespace

struct Viewer::Opened {
  int number = 0;
  std::shared_ptr<const store::Store> store;
  HttpReply summary, goods;
  std::unique_ptr<ViewBuild> build;
};

Viewer::Viewer(store::OpenedStores stores, std::filesystem::path page)
    : catalog_(std::move(stores.catalog)), page_(std::move(page)), drawing_(thread_count()) {
  for (std::shared_ptr<const store::Store>& store : stores.stores) {
    auto opened = std::make_unique<Opened>();
    opened->number = static_cast<int>(stores_.size());
    opened->store = std::move(store);
    stores_.push_back(std::move(opened));
  }
}

Viewer::~Viewer() = default;

Result<std::unique_ptr<Viewer>> Viewer::open(store::OpenedStores stores,
                                             std::filesystem::path page) {
  std::unique_ptr<Viewer> viewer(new Viewer(std::move(stores), std::move(page)));
  MARKETGEN_TRY(viewer->search_, StoreSearch::open(viewer->catalog_));
  MARKETGEN_TRY(viewer->grasps_, read_grasp_facts());
  for (const std::unique_ptr<Opened>& opened : viewer->stores_) {
    const store::Store& store = *opened->store;
    opened->summary = json_reply(io::write_json_line(
        summary_of(opened->number, store, viewer->grasps_, viewer->catalog_.frictions)));
    ViewFile goods = goods_table(store.scene);
    opened->goods = {.body = make_body(goods.type, std::move(goods.bytes))};
    opened->build = std::make_unique<ViewBuild>(opened->store, viewer->building_);
  }
  return viewer;
}

HttpReply Viewer::answer(const HttpAsk& ask) {
  const Result<HttpReply> reply = until_interrupted([&] { return reply_to(ask); });
  return reply.ok() ? *reply : error_reply(status_of(reply.error()), reply.error());
}

Result<HttpReply> Viewer::reply_to(const HttpAsk& ask) {
  const Words words = parts_of(ask.path);
  if (words.empty() || words[0] != "api") return page_file(page_, ask.path);
  if (words.size() < 2 || words[1] != "stores") return no_address(ask);
  if (words.size() == 2) {
    StoreList list{.program = program_version, .stores = {}};
    for (const std::unique_ptr<Opened>& opened : stores_)
      list.stores.push_back(line_of(opened->number, *opened->store));
    return json_reply(io::write_json_line(list));
  }
  MARKETGEN_TRY(const std::uint32_t number, row_of(ask, words[2], stores_.size()));
  return of_store(*stores_[number], ask, Words(words.begin() + 3, words.end()));
}

Result<HttpReply> Viewer::of_store(Opened& store, const HttpAsk& ask, const Words& words) {
  const scene::Scene& scene = store.store->scene;
  if (words.empty()) return store.summary;
  const std::string& what = words[0];
  if (words.size() == 1) {
    if (what == "goods.bin") return store.goods;
    if (what == "state") return state(store);
    if (what == "search") return search(store, ask);
    MARKETGEN_TRY(const ViewBuild::Body body, store.build->file(what));
    return HttpReply{.body = body};
  }
  if (what == "skus") return of_sku(store, ask, words);
  if (words.size() > 2) return no_address(ask);
  if (what == "products") {
    MARKETGEN_TRY(const std::uint32_t row, row_of(ask, words[1], scene.products.size()));
    return json_reply(io::write_json_line(product_card(scene, row, grasps_, catalog_.frictions)));
  }
  if (what == "fixtures") {
    MARKETGEN_TRY(const std::uint32_t row, row_of(ask, words[1], scene.fixtures.size()));
    return json_reply(io::write_json_line(fixture_card(scene, row)));
  }
  if (what == "tags") return tag(store, ask, words[1]);
  if (what != "textures") return no_address(ask);
  MARKETGEN_TRY(const ViewBuild::Body body, store.build->file(what + "/" + words[1]));
  return HttpReply{.body = body};
}

Result<HttpReply> Viewer::of_sku(Opened& store, const HttpAsk& ask, const Words& words) {
  const scene::Scene& scene = store.store->scene;
  MARKETGEN_TRY(const std::uint32_t sku, row_of(ask, words[1], scene.catalog.size()));
  if (words.size() != 3) return no_address(ask);
  if (words[2] == "label.png") return label(store, sku, ask);
  if (words[2] != "mesh.bin") return no_address(ask);
  const auto given = ask.query.find("detail");
  const auto detail =
      value_named<assets::Detail>(given == ask.query.end() ? "near" : given->second);
  if (!detail) return Error{"server.bad_request", "detail", "is not near, middle or far"};
  const Turn turn(drawing_);
  Result<ViewFile> mesh = product_mesh(scene, sku, *detail);
  if (!mesh.ok()) return mesh.error();
  return reply_with(std::move(mesh).value());
}

Result<HttpReply> Viewer::label(const Opened& store, std::uint32_t sku, const HttpAsk& ask) {
  MARKETGEN_TRY(
      const std::uint64_t px,
      number_in(ask, "px", usual_label_px, label_heights_px.front(), label_heights_px.back()));
  if (std::ranges::find(label_heights_px, static_cast<int>(px)) == label_heights_px.end())
    return Error{"server.bad_request", "px", "is not 64, 128, 256, 512 or 1024"};
  const Turn turn(drawing_);
  return png_reply(
      exporters::exported_label(store.store->scene.catalog[sku], static_cast<int>(px)));
}

Result<HttpReply> Viewer::tag(const Opened& store, const HttpAsk& ask, const std::string& name) {
  constexpr std::string_view ending = ".png";
  if (!name.ends_with(ending)) return no_address(ask);
  const std::string_view row = std::string_view(name).substr(0, name.size() - ending.size());
  MARKETGEN_TRY(const std::uint32_t sku, row_of(ask, row, store.store->scene.catalog.size()));
  MARKETGEN_TRY(const std::uint64_t promotion, number_in(ask, "promotion", 0, 0, 1));
  MARKETGEN_TRY(const std::uint64_t px, number_in(ask, "px", usual_tag_px, min_tag_px, max_tag_px));
  const Turn turn(drawing_);
  return png_reply(exporters::exported_price_tag(
      store.store->scene.catalog[sku], promotion != 0, static_cast<int>(px)));
}

Result<HttpReply> Viewer::search(const Opened& store, const HttpAsk& ask) {
  const auto words = ask.query.find("q");
  if (words == ask.query.end() || words->second.empty())
    return Error{"server.bad_request", "q", "say what to look for: search?q=oat milk"};
  MARKETGEN_TRY(const std::uint64_t hits, number_in(ask, "max", usual_hits, 1, max_hits));
  MARKETGEN_TRY(const SearchAnswer answer,
                search_->find(store.store->scene, words->second, static_cast<std::size_t>(hits)));
  return json_reply(io::write_json_line(answer));
}

Result<HttpReply> Viewer::state(const Opened& store) {
  const std::optional<Error> error = store.build->error();
  if (!error) return json_reply(io::write_json_line(store.build->status()));
  return error_reply(500, *error);
}

}  // namespace marketgen::server
