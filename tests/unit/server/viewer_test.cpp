// Every address of the viewer, of a store that the test makes.
#include "server/viewer.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "io/gzip.h"
#include "io/jpeg.h"
#include "io/png.h"
#include "server/serve.h"
#include "store/open_stores.h"
#include "store/store.h"
#include "support/committed_catalog.h"
#include "support/packed_container.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class ViewedStore : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch = new ScratchFolder;
    setenv("MARKETGEN_CACHE", (scratch->path() / "cache").c_str(), 1);
    store::CreateOptions options;
    options.folder = scratch->path() / "shop";
    options.brief.prompt = "a tiny corner shop with drinks, milk and snacks";
    options.brief.size_mm = {8000, 6000};
    options.seed = 3;
    options.previews = false;
    const auto created = store::create_store(options, committed_catalog());
    if (!created.ok()) fatal(to_string(created.error()).c_str());
    page = scratch->path() / "page";
    fs::create_directories(page / "assets");
    std::ofstream(page / "index.html") << "<!doctype html><title>page</title>";
    std::ofstream(page / "assets/page-1234.js") << "console.log(1)";
    std::ofstream(scratch->path() / "secret.txt") << "secret";
    fs::create_symlink(scratch->path() / "secret.txt", page / "link.txt");
    std::ofstream(page / ".hidden") << "hidden";
    viewer = open().release();
  }
  static void TearDownTestSuite() {
    delete viewer;
    delete scratch;
    viewer = nullptr;
  }
  static std::unique_ptr<server::Viewer> open() {
    auto stores = store::open_stores({(scratch->path() / "shop").string()}, committed_catalog());
    if (!stores.ok()) fatal(to_string(stores.error()).c_str());
    store = stores->stores[0];
    auto opened = server::Viewer::open(std::move(stores).value(), page);
    if (!opened.ok()) fatal(to_string(opened.error()).c_str());
    return std::move(opened).value();
  }

  static web::HttpReply ask(const std::string& path,
                            const std::map<std::string, std::string>& query = {}) {
    web::HttpAsk asked;
    asked.method = "GET";
    asked.path = path;
    asked.query = query;
    return viewer->answer(asked);
  }
  static std::string bytes_of(const web::HttpReply& reply) {
    return reply.body->packed ? *io::gunzip(reply.body->bytes, "body") : reply.body->bytes;
  }
  static std::string bytes(const std::string& path,
                           const std::map<std::string, std::string>& query = {}) {
    const web::HttpReply reply = ask(path, query);
    EXPECT_EQ(reply.status, 200) << path << bytes_of(reply);
    return bytes_of(reply);
  }
  static Json json(const std::string& path, const std::map<std::string, std::string>& query = {}) {
    return Json::parse(bytes(path, query));
  }
  static Json of_store(const std::string& path,
                       const std::map<std::string, std::string>& query = {}) {
    return json("/api/stores/0" + path, query);
  }
  static Container container(const std::string& path,
                             const std::map<std::string, std::string>& query = {}) {
    return container_of(bytes("/api/stores/0" + path, query));
  }
  static void wait_until_ready() {
    bytes("/api/stores/0/meshes.bin");
    for (int looks = 0; looks < 100 && of_store("/state")["state"] == "building"; ++looks)
      usleep(100'000);
  }
  static const scene::Scene& scene() { return store->scene; }

  static inline ScratchFolder* scratch = nullptr;
  static inline fs::path page;
  static inline server::Viewer* viewer = nullptr;
  static inline std::shared_ptr<const store::Store> store;
};

TEST_F(ViewedStore, IsListed) {
  const Json list = json("/api/stores");
  EXPECT_EQ(list["schema"], "market-view/1");
  ASSERT_EQ(list["stores"].size(), 1U);
  EXPECT_EQ(list["stores"][0]["folder"], "shop");
  EXPECT_EQ(list["stores"][0]["scene_hash"], store->manifest.scene_hash);
  EXPECT_EQ(list["stores"][0]["products"], scene().products.size());
}

TEST_F(ViewedStore, IsSummedUp) {
  const Json summary = of_store("");
  EXPECT_EQ(summary["counts"]["products"], scene().products.size());
  EXPECT_EQ(summary["fixtures"].size(), scene().fixtures.size());
  EXPECT_EQ(summary["joints"].size(), scene().joints.size());
  EXPECT_EQ(summary["skus"].size(), scene().catalog.size());
  EXPECT_EQ(summary["zones"].size(), scene().layout.zones.size());
  EXPECT_EQ(summary["bounds"]["high_m"][0], 8.0);
  EXPECT_FALSE(summary["openings"].empty());
  std::set<std::string> cameras;
  for (const Json& camera : summary["cameras"])
    cameras.insert(camera["name"]);
  EXPECT_TRUE(cameras.contains("top") && cameras.contains("aisle"));
  std::size_t products = 0;
  for (const Json& sku : summary["skus"])
    products += sku["products"].get<std::size_t>();
  EXPECT_EQ(products, scene().products.size());
}

// The list's figures are those of the cards.
TEST_F(ViewedStore, SaysOfEachSkuHowHeavyItIsAndHowWellItIsGrasped) {
  const Json skus = of_store("")["skus"];
  std::set<std::uint32_t> seen;
  std::set<double> rates;
  for (std::uint32_t row = 0; row < scene().products.size(); ++row) {
    const std::uint32_t sku = scene().products[row].sku;
    if (!seen.insert(sku).second) continue;
    const Json card = of_store("/products/" + std::to_string(row));
    EXPECT_EQ(skus[sku]["mass_kg"], card["mass_kg"]);
    double best = -1;
    for (const Json& grasp : card["grasps"])
      best = std::max(
          best,
          grasp["tries"] == 0 ? 0.0 : grasp["held"].get<double>() / grasp["tries"].get<double>());
    EXPECT_EQ(skus[sku]["pick_rate"], best) << card["sku"];
    rates.insert(best);
  }
  EXPECT_GT(rates.size(), 2U);
}

TEST_F(ViewedStore, HasItsGoodsWhereTheSceneHasThem) {
  const Container goods = container("/goods.bin");
  ASSERT_EQ(goods.rows("position"), scene().products.size());
  const auto positions = goods.numbers<float>("position");
  const auto rotations = goods.numbers<std::int16_t>("rotation");
  const auto skus = goods.numbers<std::uint16_t>("sku");
  const auto fixtures = goods.numbers<std::uint16_t>("fixture");
  for (std::size_t i = 0; i < scene().products.size(); ++i) {
    const scene::SceneProduct& item = scene().products[i];
    EXPECT_EQ(positions[3 * i + 2], item.position_m[2]);
    EXPECT_EQ(skus[i], item.sku);
    EXPECT_NEAR(rotations[4 * i + 3] / 32767.0, item.rotation_wxyz[0], 1e-4);
    if (item.facing < scene().facings.size()) {
      EXPECT_EQ(fixtures[i], scene().shelves[scene().facings[item.facing].shelf].fixture);
    }
  }
}

TEST_F(ViewedStore, HasLightOnEveryProduct) {
  const Container light = container("/goods-light.bin");
  ASSERT_EQ(light.rows("light"), scene().products.size());
  const auto bytes = light.numbers<std::uint8_t>("light");
  std::size_t dark = 0;
  for (std::size_t i = 0; i < scene().products.size(); ++i) {
    int sum = 0;
    for (std::size_t k = 0; k < 18; ++k)
      sum += bytes[18 * i + k];
    if (sum == 0) ++dark;
  }
  EXPECT_EQ(dark, 0U);
}

// Indices within the vertices, batches cover every index once, textures are there and as large as
// said, nothing lies far outside the room, and every fixture is drawn.
TEST_F(ViewedStore, HasARoom) {
  const Container room = container("/room.bin");
  const std::size_t vertices = room.rows("position");
  for (const char* section : {"normal", "uv", "color", "light", "finish", "owner"})
    EXPECT_EQ(room.rows(section), vertices) << section;
  const auto indices = room.numbers<std::uint32_t>("index");
  for (const std::uint32_t index : indices)
    ASSERT_LT(index, vertices);
  std::size_t next = 0;
  std::set<std::string> layers;
  for (const Json& batch : room.head["batches"]) {
    EXPECT_EQ(batch["first_index"], next);
    next += batch["index_count"].get<std::size_t>();
    layers.insert(batch["layer"]);
    EXPECT_LT(batch["texture"], static_cast<int>(room.head["textures"].size()));
  }
  EXPECT_EQ(next, indices.size());
  EXPECT_EQ(layers, (std::set<std::string>{"ceiling", "glass", "solid"}));
  EXPECT_LT(room.head["batches"].size(), 120U);
  const auto positions = room.numbers<float>("position");
  for (std::size_t i = 0; i < vertices; ++i) {
    EXPECT_GT(positions[3 * i], -2);
    EXPECT_LT(positions[3 * i], 10);
  }
  std::set<std::uint16_t> fixtures;
  const auto owners = room.numbers<std::uint16_t>("owner");
  for (std::size_t i = 0; i < vertices; ++i)
    if (owners[2 * i] != 65535) fixtures.insert(owners[2 * i]);
  EXPECT_EQ(fixtures.size(), scene().fixtures.size());
  for (const Json& texture : room.head["textures"]) {
    const auto image = io::decode_jpeg(bytes("/api/stores/0/" + texture["path"].get<std::string>()),
                                       texture["path"]);
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->width, texture["width"]);
    EXPECT_EQ(image->height, texture["height"]);
  }
}

// The floor in the middle of the room is lit about as a white sheet is, the inside of shelves less.
TEST_F(ViewedStore, HasALitFloor) {
  const Container room = container("/room.bin");
  const auto positions = room.numbers<float>("position");
  const auto normals = room.numbers<std::int8_t>("normal");
  const auto light = room.numbers<std::uint8_t>("light");
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < room.rows("position"); ++i) {
    if (positions[3 * i + 2] != 0 || normals[4 * i + 2] != 127) continue;
    const double byte = light[4 * i + 1];
    sum += byte / 255 * byte / 255 * 4;
    ++count;
  }
  ASSERT_GT(count, 20);
  EXPECT_GT(sum / count, 0.2);
  EXPECT_LT(sum / count, 3);
}

TEST_F(ViewedStore, HasAMeshAndALabelOfEverySku) {
  const Container meshes = container("/meshes.bin");
  ASSERT_EQ(meshes.rows("range"), scene().catalog.size());
  ASSERT_EQ(meshes.rows("tile"), scene().catalog.size());
  const auto ranges = meshes.numbers<std::uint32_t>("range");
  const auto tiles = meshes.numbers<float>("tile");
  const auto indices = meshes.numbers<std::uint32_t>("index");
  const std::size_t pages = meshes.head["pages"].size();
  std::vector<bool> stands(scene().catalog.size());
  for (const scene::SceneProduct& item : scene().products)
    stands[item.sku] = true;
  for (std::size_t sku = 0; sku < scene().catalog.size(); ++sku) {
    const std::uint32_t* range = &ranges[6 * sku];
    EXPECT_EQ(range[1] > 0, stands[sku]) << scene().catalog[sku].sku;
    for (std::uint32_t i = range[2]; i < range[2] + range[3] + range[4]; ++i) {
      ASSERT_GE(indices[i], range[0]);
      ASSERT_LT(indices[i], range[0] + range[1]);
    }
    EXPECT_LT(tiles[5 * sku], static_cast<float>(pages));
    if (tiles[5 * sku] >= 0) {
      EXPECT_LT(tiles[5 * sku + 1], tiles[5 * sku + 3]);
    }
  }
  for (std::size_t p = 0; p < pages; ++p) {
    const auto image =
        io::decode_jpeg(bytes("/api/stores/0/goods-" + std::to_string(p) + ".jpg"), "page");
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->width, meshes.head["pages"][p]["width"]);
  }
  EXPECT_EQ(ask("/api/stores/0/goods-" + std::to_string(pages) + ".jpg").status, 404);
}

TEST_F(ViewedStore, GivesNearMeshesAndLabelsOneByOne) {
  const std::string sku = "/api/stores/0/skus/" + std::to_string(scene().products[0].sku);
  const Container near = container_of(bytes(sku + "/mesh.bin"));
  const Container far = container_of(bytes(sku + "/mesh.bin", {{"detail", "far"}}));
  EXPECT_EQ(near.rows("range"), 1U);
  EXPECT_GE(near.rows("index"), far.rows("index"));
  const auto label = io::decode_png(bytes(sku + "/label.png", {{"px", "128"}}), "label");
  ASSERT_TRUE(label.ok());
  EXPECT_LE(label->height, 128);
  const auto tag =
      io::decode_png(bytes("/api/stores/0/tags/0.png", {{"promotion", "1"}, {"px", "64"}}), "tag");
  ASSERT_TRUE(tag.ok());
  EXPECT_EQ(tag->height, 64);
  EXPECT_EQ(ask(sku + "/label.png", {{"px", "100"}}).status, 400);
  EXPECT_EQ(ask(sku + "/label.png", {{"px", "99999"}}).status, 400);
  EXPECT_EQ(ask(sku + "/mesh.bin", {{"detail", "huge"}}).status, 400);
}

TEST_F(ViewedStore, FindsGoods) {
  const Json answer = of_store("/search", {{"q", "milk"}, {"max", "5"}});
  EXPECT_EQ(answer["query"], "milk");
  ASSERT_FALSE(answer["hits"].empty());
  EXPECT_LE(answer["hits"].size(), 5U);
  double before = 1e9;
  for (const Json& hit : answer["hits"]) {
    EXPECT_LE(hit["score"], before);
    before = hit["score"];
    ASSERT_FALSE(hit["products"].empty());
    for (const std::size_t row : hit["products"])
      EXPECT_EQ(scene().catalog[scene().products[row].sku].sku, hit["sku"]);
  }
  EXPECT_TRUE(of_store("/search", {{"q", "zzzzqqq"}})["hits"].empty());
  EXPECT_EQ(ask("/api/stores/0/search").status, 400);
  EXPECT_EQ(ask("/api/stores/0/search", {{"q", ""}}).status, 400);
  EXPECT_EQ(ask("/api/stores/0/search", {{"q", "milk"}, {"max", "-1"}}).status, 400);
}

TEST_F(ViewedStore, HasACardOfEveryProduct) {
  const Json card = of_store("/products/0");
  const scene::SceneProduct& item = scene().products[0];
  const catalog::Product& product = scene().catalog[item.sku];
  EXPECT_EQ(card["sku"], product.sku);
  EXPECT_EQ(card["id"], scene::product_id(scene(), 0));
  EXPECT_EQ(card["ean"], product.ean);
  EXPECT_NEAR(card["mass_kg"], product.mass_kg, 1e-9);
  EXPECT_GE(card["items_in_store"], 1);
  EXPECT_GE(card["facings_in_store"], 1);
  EXPECT_EQ(card["facing"]["products"], scene().facings[item.facing].product_count);
  std::size_t with_grasps = 0;
  for (std::size_t row = 0; row < scene().products.size(); row += 40)
    with_grasps += of_store("/products/" + std::to_string(row))["grasps"].empty() ? 0 : 1;
  EXPECT_GT(with_grasps, 0U);
}

TEST_F(ViewedStore, HasACardOfEveryFixture) {
  std::size_t products = 0;
  for (std::size_t row = 0; row < scene().fixtures.size(); ++row) {
    const Json card = of_store("/fixtures/" + std::to_string(row));
    EXPECT_EQ(card["id"], scene().layout.fixtures[row].id);
    EXPECT_EQ(card["shelves"].size(), scene().fixtures[row].shelf_count);
    products += card["products"].get<std::size_t>();
  }
  EXPECT_LE(products, scene().products.size());
  EXPECT_GT(products, scene().products.size() / 2);
}

TEST_F(ViewedStore, NamesTheBlocksOfALineOfShelves) {
  const scene::Facing& first = scene().facings.front();
  const scene::SceneShelf& shelf = scene().shelves[first.shelf];
  const layout::Fixture& fixture = scene().layout.fixtures[shelf.fixture];
  const Json block = of_store("/blocks", {{"run", fixture.run}})["blocks"][0];
  EXPECT_EQ(block["facing"], 0);
  EXPECT_EQ(block["fixture"], fixture.id);
  EXPECT_EQ(block["shelf"], shelf.level + 1);
  EXPECT_EQ(block["position"], 1);
  EXPECT_EQ(block["sku"], scene().catalog[first.sku].sku);
  EXPECT_EQ(block["products"], first.product_count);
  EXPECT_TRUE(of_store("/blocks", {{"run", "nowhere/run-1"}})["blocks"].empty());
  EXPECT_EQ(ask("/api/stores/0/blocks").status, 400);
}

TEST_F(ViewedStore, SaysWhatIsNotThere) {
  for (const char* path : {"/api",
                           "/api/",
                           "/api/nothing",
                           "/api/stores/1",
                           "/api/stores/-1",
                           "/api/stores/0x0",
                           "/api/stores/99999999999999999999",
                           "/api/stores/0/nothing",
                           "/api/stores/0/index",
                           "/api/stores/0/products",
                           "/api/stores/0/products/99999999",
                           "/api/stores/0/products/0/more",
                           "/api/stores/0/fixtures/x",
                           "/api/stores/0/skus/0",
                           "/api/stores/0/skus/0/nothing",
                           "/api/stores/0/skus/99999/label.png",
                           "/api/stores/0/tags/0.gif",
                           "/api/stores/0/textures/999.jpg",
                           "/api/stores/0/store.json"}) {
    const web::HttpReply reply = ask(path);
    EXPECT_EQ(reply.status, 404) << path;
    EXPECT_EQ(Json::parse(bytes_of(reply))["error"]["code"], "server.not_found") << path;
  }
}

TEST_F(ViewedStore, IsReadyAtLast) {
  wait_until_ready();
  EXPECT_EQ(of_store("/state")["state"], "ready");
}

// A second viewer takes what the first has kept: the same bytes.
TEST_F(ViewedStore, IsBuiltOnce) {
  wait_until_ready();
  const std::string etag = ask("/api/stores/0/room.bin").body->etag;
  const std::unique_ptr<server::Viewer> second = open();
  web::HttpAsk asked;
  asked.path = "/api/stores/0/room.bin";
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_EQ(second->answer(asked).body->etag, etag);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(1));
}

TEST_F(ViewedStore, ServesThePageAndNothingBeside) {
  const web::HttpReply first = ask("/");
  EXPECT_EQ(bytes_of(first), "<!doctype html><title>page</title>");
  EXPECT_EQ(first.body->type, "text/html; charset=utf-8");
  EXPECT_FALSE(first.lasting);
  EXPECT_TRUE(ask("/assets/page-1234.js").lasting);
  EXPECT_EQ(ask("/assets/page-1234.js").body->type, "text/javascript; charset=utf-8");
  for (const char* path : {"/link.txt", "/.hidden", "/assets", "/nothing.js", "/../secret.txt"})
    EXPECT_EQ(ask(path).status, 404) << path;
}

TEST(Serving, RefusesBeforeAnyWork) {
  const auto code = [](const server::ServeOptions& options) {
    const auto served =
        server::serve(options, {"/nowhere"}, committed_catalog(), [](const std::string&) {});
    return served.ok() ? std::string("ok") : served.error().code;
  };
  server::ServeOptions options;
  options.host = "0.0.0.0";
  EXPECT_EQ(code(options), "usage.bad_flag");
  options.token = "short";
  EXPECT_EQ(code(options), "usage.bad_flag");
  options.host = "localhost.example";
  EXPECT_EQ(code(options), "usage.bad_flag");
  options.host = "127.0.0.1";
  setenv("MARKETGEN_VIEWER", "/nowhere", 1);
  EXPECT_EQ(code(options), "usage.unavailable");
  unsetenv("MARKETGEN_VIEWER");
}

}  // namespace
}  // namespace marketgen
