// scene.bin and the hashes: what is written comes back, what is damaged is refused.
#include "scene/scene_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <set>

#include "base/seed.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {

scene::Scene scene_file_sample() {
  HandMadeScene made;
  made.stock();
  made.scene.materials.push_back({});
  made.scene.materials.back().id = "plaster-white";
  return std::move(made.scene);
}

std::span<const std::byte> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::byte*>(text.data()), text.size()};
}

std::string code_of(const std::string& bytes) {
  const auto decoded = scene::decode_scene(bytes_of(bytes), "shop/scene.bin");
  return decoded.ok() ? "ok" : decoded.error().code;
}

TEST(SceneFile, DecodesToTheSameBytes) {
  const std::string bytes = scene::encode_scene(scene_file_sample());
  const auto decoded = scene::decode_scene(bytes_of(bytes), "scene.bin");
  ASSERT_TRUE(decoded.ok()) << to_string(decoded.error());
  EXPECT_EQ(scene::encode_scene(*decoded), bytes);
  EXPECT_EQ(decoded->layout.name, "Corner & Co <test>");
  EXPECT_EQ(decoded->products.size(), 8U);
  EXPECT_EQ(decoded->price_labels[1].promotion, 1U);
  EXPECT_EQ(decoded->layout.shell.openings[2].kind, plan::OpeningKind::service);
}

TEST(SceneFile, TruncatedAnywhere) {
  const std::string bytes = scene::encode_scene(scene_file_sample());
  for (std::size_t size = 0; size < bytes.size(); size += 61)
    EXPECT_EQ(code_of(bytes.substr(0, size)), "scene.truncated") << size;
  EXPECT_EQ(code_of(bytes.substr(0, bytes.size() - 1)), "scene.truncated");
  const auto decoded = scene::decode_scene(bytes_of(bytes.substr(0, 100)), "shop/scene.bin");
  EXPECT_EQ(decoded.error().where, "shop/scene.bin");
  EXPECT_NE(decoded.error().message.find("100 bytes, header says"), std::string::npos)
      << decoded.error().message;
}

TEST(SceneFile, LongerThanItSays) {
  EXPECT_EQ(code_of(scene::encode_scene(scene_file_sample()) + "x"), "scene.corrupt");
}

TEST(SceneFile, OtherVersionAndOtherFile) {
  std::string bytes = scene::encode_scene(scene_file_sample());
  ASSERT_EQ(bytes.substr(8, 4), scene::scene_file_identifier);
  bytes[11] = '9';
  EXPECT_EQ(code_of(bytes), "scene.wrong_version");
  bytes.replace(8, 4, "PNG!");
  EXPECT_EQ(code_of(bytes), "scene.corrupt");
}

TEST(SceneFile, FlippedBytesNeverGetFurtherThanAnError) {  // and never into undefined behaviour:
                                                           // the sanitizer build runs this too
  const std::string good = scene::encode_scene(scene_file_sample());
  const std::set<std::string> expected = {
      "ok", "scene.corrupt", "scene.truncated", "scene.wrong_version"};
  Stream draw(11);
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string bytes = good;
    for (int flips = draw.integer(1, 4); flips > 0; --flips) {
      bytes[static_cast<std::size_t>(draw.integer(0, static_cast<int>(bytes.size()) - 1))] =
          static_cast<char>(draw.integer(0, 255));
    }
    const std::string code = code_of(bytes);
    EXPECT_TRUE(expected.contains(code)) << code;
    refused += code == "ok" ? 0 : 1;
  }
  EXPECT_GT(refused, 300);
}

struct Damage {
  const char* name;
  std::function<void(scene::Scene&)> apply;
};

const std::vector<Damage>& damages() {
  static const std::vector<Damage> all = {
      {"schema tag", [](scene::Scene& s) { s.schema = "market-scene/2"; }},
      {"fixtures shorter than layout",
       [](scene::Scene& s) {
         s.fixtures.clear(), s.parts.clear(), s.shelves.clear(), s.facings.clear(),
             s.products.clear(), s.price_labels.clear();
       }},
      {"parts of a fixture", [](scene::Scene& s) { s.fixtures[0].part_count = 5; }},
      {"parts that wrap around",
       [](scene::Scene& s) {
         s.fixtures[0].first_part = 0xFFFFFFFF, s.fixtures[0].part_count = 0xFFFFFFFF;
       }},
      {"shelves of a fixture",
       [](scene::Scene& s) { s.fixtures[0].first_shelf = 2, s.fixtures[0].shelf_count = 1; }},
      {"fixture of a part", [](scene::Scene& s) { s.parts[3].fixture = 1; }},
      {"material of a part", [](scene::Scene& s) { s.parts[0].material = 1; }},
      {"fixture of a shelf", [](scene::Scene& s) { s.shelves[1].fixture = 7; }},
      {"shelf of a facing", [](scene::Scene& s) { s.facings[0].shelf = 2; }},
      {"sku of a facing", [](scene::Scene& s) { s.facings[0].sku = 3; }},
      {"products of a facing", [](scene::Scene& s) { s.facings.back().product_count = 2; }},
      {"sku of a product", [](scene::Scene& s) { s.products[0].sku = 3; }},
      {"facing of a product", [](scene::Scene& s) { s.products[0].facing = 8; }},
      {"shelf of a label", [](scene::Scene& s) { s.price_labels[0].shelf = 2; }},
      {"sku of a label", [](scene::Scene& s) { s.price_labels[0].sku = 0xFFFFFFFF; }},
      {"facing of a label", [](scene::Scene& s) { s.price_labels[0].facing = 8; }},
      {"a position that is no number",
       [](scene::Scene& s) {
         s.products[0].position_m[1] = std::numeric_limits<float>::quiet_NaN();
       }},
      {"an infinite shelf",
       [](scene::Scene& s) { s.shelves[0].width_m = std::numeric_limits<float>::infinity(); }},
      {"a room larger than any", [](scene::Scene& s) { s.layout.shell.width_mm = 2'000'000'000; }},
      {"a room with no depth", [](scene::Scene& s) { s.layout.shell.depth_mm = -1; }},
      {"a pack of negative size", [](scene::Scene& s) { s.catalog[1].size_mm[2] = -115; }},
      {"a pack with nothing in it", [](scene::Scene& s) { s.catalog[1].unit_amount = 0; }},
      {"a name that is not UTF-8", [](scene::Scene& s) { s.layout.name = "caf\xE9"; }},
  };
  return all;
}

TEST(SceneFile, EveryDamageIsCorrupt) {
  for (const Damage& damage : damages()) {
    scene::Scene scene = scene_file_sample();
    damage.apply(scene);
    const auto decoded =
        scene::decode_scene(bytes_of(scene::encode_scene(scene)), "shop/scene.bin");
    ASSERT_FALSE(decoded.ok()) << damage.name;
    EXPECT_EQ(decoded.error().code, "scene.corrupt") << damage.name;
    EXPECT_EQ(decoded.error().where, "shop/scene.bin") << damage.name;
  }
}

TEST(SceneFile, ItemsWithoutAFacingAreNoDamage) {
  scene::Scene scene = scene_file_sample();
  scene.products.push_back({1, 0xFFFFFFFF, {1, 1, 0}, {1, 0, 0, 0}, 0});
  EXPECT_EQ(code_of(scene::encode_scene(scene)), "ok");
}

TEST(SceneFile, FileThatIsNotThereOrEmpty) {
  EXPECT_EQ(scene::open_scene("/no/such/scene.bin").error().code, "input.not_found");
  EXPECT_EQ(scene::open_scene("/dev").error().code, "io.cannot_read");
  EXPECT_EQ(code_of(""), "scene.truncated");
}

// ---- Hashes. ----

TEST(SceneHash, StableUnderReEncoding) {
  const scene::Scene scene = scene_file_sample();
  const auto decoded = scene::decode_scene(bytes_of(scene::encode_scene(scene)), "scene.bin");
  ASSERT_TRUE(decoded.ok());
  EXPECT_EQ(scene::scene_hash(*decoded), scene::scene_hash(scene));
  EXPECT_EQ(scene::look_hash(*decoded), scene::look_hash(scene));
  EXPECT_EQ(scene::scene_hash(scene).size(), 32U);
}

TEST(SceneHash, SeesATenthOfAMillimetre) {
  const std::string before = scene::scene_hash(scene_file_sample());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    scene::Scene scene = scene_file_sample();
    scene.products[4].position_m[axis] += 0.0001F;
    EXPECT_NE(scene::scene_hash(scene), before) << axis;
  }
}

TEST(SceneHash, SeesWhatChangesTheScene) {
  const std::vector<Damage> changes = {
      {"turn of an item",
       [](scene::Scene& s) {
         s.products[0].rotation_wxyz = {0.9998F, 0, 0, 0.02F};
       }},
      {"product of an item", [](scene::Scene& s) { s.products[0].sku = 0; }},
      {"one item less",
       [](scene::Scene& s) { s.products.pop_back(), --s.facings.back().product_count; }},
      {"size of a pack", [](scene::Scene& s) { ++s.catalog[1].size_mm[0]; }},
      {"SKU", [](scene::Scene& s) { s.catalog[1].sku = "can-cola-2"; }},
      {"shape of a part", [](scene::Scene& s) { s.parts[0].half_size_m[0] += 0.001F; }},
      {"place of a fixture", [](scene::Scene& s) { s.fixtures[0].position_m[0] += 0.001F; }},
      {"turn of a fixture", [](scene::Scene& s) { s.fixtures[0].quarter_turns = 2; }},
      {"size of the room", [](scene::Scene& s) { ++s.layout.shell.width_mm; }},
  };
  std::set<std::string> hashes = {scene::scene_hash(scene_file_sample())};
  for (const Damage& change : changes) {
    scene::Scene scene = scene_file_sample();
    change.apply(scene);
    EXPECT_TRUE(hashes.insert(scene::scene_hash(scene)).second) << change.name;
  }
}

TEST(SceneHash, LooksAreAHashOfTheirOwn) {
  const std::vector<Damage> changes = {
      {"floor", [](scene::Scene& s) { s.layout.look.floor = "oak"; }},
      {"light", [](scene::Scene& s) { s.layout.look.light_kelvin = 2700; }},
      {"colour of a part", [](scene::Scene& s) { s.parts[0].color[0] = 0.1F; }},
      {"label", [](scene::Scene& s) { s.catalog[1].label.primary = "#00ff00"; }},
      {"material", [](scene::Scene& s) { s.materials[0].color = "#123456"; }},
  };
  const std::string scene_before = scene::scene_hash(scene_file_sample()),
                    look_before = scene::look_hash(scene_file_sample());
  for (const Damage& change : changes) {
    scene::Scene scene = scene_file_sample();
    change.apply(scene);
    EXPECT_EQ(scene::scene_hash(scene), scene_before) << change.name;
    EXPECT_NE(scene::look_hash(scene), look_before) << change.name;
  }
  scene::Scene moved = scene_file_sample();
  moved.products[0].position_m[0] += 0.1F;
  EXPECT_EQ(scene::look_hash(moved), look_before);
}

}  // namespace
}  // namespace marketgen
