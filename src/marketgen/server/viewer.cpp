#include "server/viewer.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/build_info.h"
#include "base/interrupt.h"
#include "base/parallel.h"
#include "catalog/user_products.h"
#include "environments/travelling_stores.h"
#include "export/label_picture.h"
#include "io/json.h"
#include "io/png.h"
#include "server/answering.h"
#include "server/drive.h"
#include "server/editor.h"
#include "server/page_files.h"
#include "server/store_summary.h"
#include "server/view_files.h"

namespace marketgen::server {
namespace {

constexpr std::array label_heights_px{64, 128, 256, 512, 1024};
constexpr int min_tag_px = 32, max_tag_px = 192, usual_tag_px = 96, usual_label_px = 512;
constexpr std::uint64_t usual_hits = 50, max_hits = 500;
constexpr std::size_t max_places = 10000;

Result<web::HttpReply> png_reply(const Result<Image>& image) {
  if (!image.ok()) return image.error();
  MARKETGEN_TRY(std::string bytes, io::encode_png(*image));
  return reply_with({"", "image/png", std::move(bytes)});
}

Error no_drive(const web::HttpAsk& ask) {
  return {"server.refused",
          ask.path,
          "robots are not driven here: name the store's folder, and start `marketgen view` without "
          "--read-only"};
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
  PageRights rights;
  std::shared_ptr<const store::Store> store;
  web::HttpReply summary, goods;
  std::once_flag begun;
  std::unique_ptr<ViewBuild> build;
  std::unique_ptr<Editor> editor;
  std::unique_ptr<Drive> drive;  // of stores that were there from the start
  bool is_place = false;         // of an episode, and no store
};

// Begins it where nobody has asked yet: stores that an edit has saved may never be looked at.
ViewBuild& Viewer::build_of(Opened& store) {
  std::call_once(store.begun,
                 [&] { store.build = std::make_unique<ViewBuild>(store.store, building_); });
  return *store.build;
}

Viewer::Viewer(store::OpenedStores stores, std::filesystem::path page, ViewerOptions options)
    : catalog_(std::move(stores.catalog)),
      rows_(std::make_shared<const catalog::Catalog>(std::move(stores.rows))),
      options_(std::move(options)),
      page_(std::move(page)),
      drawing_(thread_count()) {}

Viewer::~Viewer() = default;

Result<std::unique_ptr<Viewer>> Viewer::open(store::OpenedStores stores,
                                             std::filesystem::path page,
                                             const ViewerOptions& options) {
  MARKETGEN_TRY(ReplayRuns runs, ReplayRuns::read(options.results));
  const std::size_t given = stores.stores.size();
  std::set<std::string> elsewhere = runs.scenes_without(stores.stores);
  MARKETGEN_TRY(stores,
                environments::with_travelling_stores(
                    std::move(stores), std::move(elsewhere), options.episodes));
  std::vector<std::shared_ptr<const store::Store>> opened = std::move(stores.stores);
  std::unique_ptr<Viewer> viewer(new Viewer(std::move(stores), std::move(page), options));
  MARKETGEN_TRY(viewer->search_, StoreSearch::open(viewer->catalog_));
  MARKETGEN_TRY(viewer->grasps_, read_grasp_facts());
  MARKETGEN_TRY(viewer->replays_, Replays::open(std::move(runs), opened, viewer->catalog_));
  for (std::size_t i = 0; i < opened.size(); ++i)
    viewer->add(std::move(opened[i]), viewer->rights_in(i < given));
  if (options.may_edit) MARKETGEN_CHECK(viewer->offer_drives());
  if (options.watch) {
    DriveGround ground = viewer->ground_of(*viewer->stores_.front());
    ground.watched = true;
    viewer->stores_.front()->drive = std::make_unique<Drive>(std::move(ground));
  }
  for (std::size_t i = 0; i < given; ++i)  // others may be seen in their episodes' places alone
    viewer->build_of(*viewer->stores_[i]);
  if (options.may_edit)
    viewer->maker_ = std::make_unique<Maker>(
        viewer->rows_,
        std::filesystem::absolute(options.make_in).lexically_normal(),
        [made = viewer.get()](const std::filesystem::path& folder) {
          return made->add_saved(folder, *made->rows_);
        },
        options.planner);
  return viewer;
}

std::unique_ptr<Viewer::Opened> Viewer::made(int number,
                                             std::shared_ptr<const store::Store> store,
                                             const PageRights& rights) {
  auto opened = std::make_unique<Opened>();
  opened->number = number;
  opened->rights = rights;
  opened->summary =
      web::json_reply(io::write_json_line(summary_of(number, *store, grasps_, *rows_, rights)));
  ViewFile goods = goods_table(store->scene);
  opened->goods = {.body = web::make_body(goods.type, std::move(goods.bytes))};
  opened->store = std::move(store);
  return opened;
}

std::shared_ptr<const catalog::Catalog> Viewer::rows_of(const store::Store& store) const {
  const auto& own = store.manifest.own;
  return own ? std::make_shared<const catalog::Catalog>(catalog::with_own_products(*rows_, *own))
             : rows_;
}

// Each store has a drive of its own: robots of several may be driven at once.
Result<void> Viewer::offer_drives() {
  std::shared_ptr<environments::EpisodeGround> file;
  bool is_of_one = options_.episodes.empty();
  if (!is_of_one) {
    MARKETGEN_TRY(file, environments::EpisodeGround::of_file(options_.episodes));
  }
  for (const std::unique_ptr<Opened>& opened : stores_) {
    if (!opened->rights.drive) continue;
    DriveGround ground = ground_of(*opened);
    ground.file = file;
    opened->drive = std::make_unique<Drive>(std::move(ground));
    is_of_one = is_of_one || opened->drive->offers_episodes();
    if (file != nullptr) file->arena().offer(opened->store);
  }
  if (is_of_one) return {};
  return Error{"episode.other_store",
               options_.episodes,
               "none of its episodes is of a store that is shown: name that store's folder, or "
               "leave --episodes out"};
}

DriveGround Viewer::ground_of(const Opened& opened) {
  const auto place = [this, number = static_cast<std::size_t>(opened.number)](
                         const episodes::RecordedPlace& where) {
    return replays_->number_of(number, where);
  };
  return {opened.store, rows_of(*opened.store), &catalog_, nullptr, options_.drives, place};
}

Drive& Viewer::watched() {
  return *stores_.front()->drive;
}

void Viewer::stop_driving() {
  for (const std::unique_ptr<Opened>& opened : stores_)
    if (opened->drive) opened->drive->stop();
}

// One of no folder is not edited, which saves beside it; and driven in for its own episodes alone,
// since what it sells may be of another catalogue.
PageRights Viewer::rights_in(bool has_folder) const {
  const bool may = options_.may_edit;
  return {may && has_folder, may && (has_folder || !options_.episodes.empty())};
}

int Viewer::add(std::shared_ptr<const store::Store> store, const PageRights& rights) {
  const std::unique_lock lock(listing_);
  auto opened = made(static_cast<int>(stores_.size()), std::move(store), rights);
  const auto rows = rows_of(*opened->store);
  if (rights.edit)
    opened->editor = std::make_unique<Editor>(
        opened->store, rows, grasps_, [this, rows](const std::filesystem::path& folder) {
          return add_saved(folder, *rows);
        });
  stores_.push_back(std::move(opened));
  return stores_.back()->number;
}

Result<int> Viewer::add_saved(const std::filesystem::path& folder, const catalog::Catalog& rows) {
  MARKETGEN_TRY(store::Store store, store::open_store(folder, rows));
  return add(std::make_shared<const store::Store>(std::move(store)), {options_.may_edit, false});
}

web::HttpReply Viewer::answer(const web::HttpAsk& ask) {
  const Result<web::HttpReply> reply = until_interrupted([&] { return reply_to(ask); });
  return reply.ok() ? *reply : web::error_reply(web::status_of(reply.error()), reply.error());
}

web::HttpReply Viewer::list() const {
  const std::shared_lock lock(listing_);
  StoreList list{.program = program_version, .stores = {}};
  for (const std::unique_ptr<Opened>& opened : stores_)
    list.stores.push_back(line_of(opened->number, *opened->store));
  return web::json_reply(io::write_json_line(list));
}

// None ever goes away.
Result<Viewer::Opened*> Viewer::opened(const web::HttpAsk& ask, const std::string& number) const {
  const std::shared_lock lock(listing_);
  MARKETGEN_TRY(const std::uint32_t row, row_of(ask, number, stores_.size()));
  return stores_[row].get();
}

Result<web::HttpReply> Viewer::reply_to(const web::HttpAsk& ask) {
  const Words words = web::parts_of(ask.path);
  if (words.empty() || words[0] != "api") return page_file(page_, ask.path);
  if (words.size() < 2) return no_address(ask);
  if (words[1] == "make") return of_make(ask, Words(words.begin() + 2, words.end()));
  if (words[1] != "stores") return no_address(ask);
  if (words.size() == 2) return list();
  MARKETGEN_TRY(Opened* const store, opened(ask, words[2]));
  return of_store(*store, ask, Words(words.begin() + 3, words.end()));
}

Result<web::HttpReply> Viewer::of_store(Opened& store,
                                        const web::HttpAsk& ask,
                                        const Words& words) {
  if (words.empty()) return store.summary;
  const std::string& what = words[0];
  if (what == "edit") return of_edit(store, ask, Words(words.begin() + 1, words.end()));
  if (what == "drive") return of_drive(store, ask, Words(words.begin() + 1, words.end()));
  if (what == "runs" || what == "places") return of_replay(store, ask, words);
  if (words.size() == 1 && what != "search" && what != "blocks") {
    if (what == "goods.bin") return store.goods;
    if (what == "state") return state(store);
    MARKETGEN_TRY(const ViewBuild::Body body, build_of(store).file(what));
    return web::HttpReply{.body = body};
  }
  if (what != "textures" || words.size() > 2) return of_scene(store.store->scene, ask, words);
  MARKETGEN_TRY(const ViewBuild::Body body, build_of(store).file(what + "/" + words[1]));
  return web::HttpReply{.body = body};
}

Result<web::HttpReply> Viewer::of_scene(const scene::Scene& scene,
                                        const web::HttpAsk& ask,
                                        const Words& words) {
  const std::string& what = words[0];
  if (what == "skus" && words.size() > 1) return of_sku(scene, ask, words);
  if (what == "search" && words.size() == 1) return search(scene, ask);
  if (what == "blocks" && words.size() == 1) return blocks(scene, ask);
  if (words.size() != 2) return no_address(ask);
  if (what == "products") {
    MARKETGEN_TRY(const std::uint32_t row, row_of(ask, words[1], scene.products.size()));
    return web::json_reply(
        io::write_json_line(product_card(scene, row, grasps_, catalog_.frictions)));
  }
  if (what == "fixtures") {
    MARKETGEN_TRY(const std::uint32_t row, row_of(ask, words[1], scene.fixtures.size()));
    return web::json_reply(io::write_json_line(fixture_card(scene, row)));
  }
  return what == "tags" ? tag(scene, ask, words[1]) : no_address(ask);
}

Result<web::HttpReply> Viewer::of_make(const web::HttpAsk& ask, const Words& words) {
  if (!maker_)
    return Error{"server.refused",
                 ask.path,
                 "stores are not made here: start `marketgen view` without --read-only"};
  if (ask.method != "POST") return maker_->get(ask, words);
  Result<web::HttpReply> reply = maker_->post(words.size() == 1 ? words[0] : "", ask);
  if (reply.ok()) return reply;
  const int status = is_refused_keeping(reply.error()) ? 200 : web::status_of(reply.error());
  return web::error_reply(status, reply.error());
}

// Reads show the store as the edit has it now.
Result<web::HttpReply> Viewer::of_edit(Opened& store, const web::HttpAsk& ask, const Words& words) {
  if (!store.editor)
    return Error{"server.refused",
                 ask.path,
                 "it is not edited here: name the store's folder, and start `marketgen view` "
                 "without --read-only"};
  if (ask.method == "POST") {
    Result<web::HttpReply> reply = store.editor->post(words.size() == 1 ? words[0] : "", ask);
    if (reply.ok()) return reply;
    const int status = is_refused_edit(reply.error()) ? 200 : web::status_of(reply.error());
    return web::error_reply(status, reply.error());
  }
  if (words.empty()) return store.editor->status();
  const EditSession::Now now = store.editor->now();
  return of_scene(now ? now->store.scene : store.store->scene, ask, words);
}

Result<web::HttpReply> Viewer::of_drive(Opened& store,
                                        const web::HttpAsk& ask,
                                        const Words& words) {
  if (!store.drive) return no_drive(ask);
  if (ask.method != "POST") return store.drive->get(ask, words);
  return words == Words{"begin"} ? store.drive->begin(ask) : no_address(ask);
}

Result<std::unique_ptr<SocketPeer>> Viewer::socket(const web::HttpAsk& ask) {
  const Words words = web::parts_of(ask.path);
  if (words.size() != 5 || words[0] != "api" || words[1] != "stores" || words[3] != "drive" ||
      words[4] != "socket")
    return no_address(ask);
  MARKETGEN_TRY(Opened* const store, opened(ask, words[2]));
  if (!store->drive) return no_drive(ask);
  return store->drive->peer();
}

Result<web::HttpReply> Viewer::of_replay(Opened& store,
                                         const web::HttpAsk& ask,
                                         const Words& words) {
  if (store.is_place) return no_address(ask);
  const auto number = static_cast<std::size_t>(store.number);
  if (words[0] == "runs")
    return replays_->answer(number, ask, Words(words.begin() + 1, words.end()));
  if (words.size() < 2) return no_address(ask);
  MARKETGEN_TRY(const std::uint32_t row, row_of(ask, words[1], max_places));
  std::shared_ptr<const store::Store> place = replays_->place(number, row);
  if (place == nullptr) return no_address(ask);
  Opened* opened_place = nullptr;
  {
    const std::scoped_lock lock(opening_);
    std::unique_ptr<Opened>& kept = places_[row];
    if (kept == nullptr) {
      kept = made(store.number, std::move(place), {});
      kept->is_place = true;
    }
    opened_place = kept.get();
  }
  return of_store(*opened_place, ask, Words(words.begin() + 2, words.end()));
}

Result<web::HttpReply> Viewer::of_sku(const scene::Scene& scene,
                                      const web::HttpAsk& ask,
                                      const Words& words) {
  MARKETGEN_TRY(const std::uint32_t sku, row_of(ask, words[1], scene.catalog.size()));
  if (words.size() != 3) return no_address(ask);
  if (words[2] == "label.png") return label(scene, sku, ask);
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

Result<web::HttpReply> Viewer::label(const scene::Scene& scene,
                                     std::uint32_t sku,
                                     const web::HttpAsk& ask) {
  MARKETGEN_TRY(
      const std::uint64_t px,
      number_in(ask, "px", usual_label_px, label_heights_px.front(), label_heights_px.back()));
  if (std::ranges::find(label_heights_px, static_cast<int>(px)) == label_heights_px.end())
    return Error{"server.bad_request", "px", "is not 64, 128, 256, 512 or 1024"};
  const Turn turn(drawing_);
  return png_reply(exporters::exported_label(scene.catalog[sku], static_cast<int>(px)));
}

Result<web::HttpReply> Viewer::tag(const scene::Scene& scene,
                                   const web::HttpAsk& ask,
                                   const std::string& name) {
  constexpr std::string_view ending = ".png";
  if (!name.ends_with(ending)) return no_address(ask);
  const std::string_view row = std::string_view(name).substr(0, name.size() - ending.size());
  MARKETGEN_TRY(const std::uint32_t sku, row_of(ask, row, scene.catalog.size()));
  MARKETGEN_TRY(const std::uint64_t promotion, number_in(ask, "promotion", 0, 0, 1));
  MARKETGEN_TRY(const std::uint64_t px, number_in(ask, "px", usual_tag_px, min_tag_px, max_tag_px));
  const Turn turn(drawing_);
  return png_reply(
      exporters::exported_price_tag(scene.catalog[sku], promotion != 0, static_cast<int>(px)));
}

Result<web::HttpReply> Viewer::search(const scene::Scene& scene, const web::HttpAsk& ask) {
  const auto words = ask.query.find("q");
  if (words == ask.query.end() || words->second.empty())
    return Error{"server.bad_request", "q", "say what to look for: search?q=oat milk"};
  MARKETGEN_TRY(const std::uint64_t hits, number_in(ask, "max", usual_hits, 1, max_hits));
  MARKETGEN_TRY(const SearchAnswer answer,
                search_->find(scene, words->second, static_cast<std::size_t>(hits)));
  return web::json_reply(io::write_json_line(answer));
}

Result<web::HttpReply> Viewer::blocks(const scene::Scene& scene, const web::HttpAsk& ask) {
  const auto run = ask.query.find("run");
  if (run == ask.query.end())
    return Error{"server.bad_request", "run", "say of which line: blocks?run=snacks/run-1"};
  return web::json_reply(io::write_json_line(blocks_of_run(scene, run->second)));
}

Result<web::HttpReply> Viewer::state(Opened& store) {
  const ViewBuild& build = build_of(store);
  const std::optional<Error> error = build.error();
  if (!error) return web::json_reply(io::write_json_line(build.status()));
  return web::error_reply(500, *error);
}

}  // namespace marketgen::server
