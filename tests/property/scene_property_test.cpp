// Scenes of random shops: every field comes back from the file, whatever is damaged is refused or
// can be used, and what a query finds between two bounds is what lies there.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "io/file.h"
#include "io/json.h"
#include "layout/layout.h"
#include "scene/query.h"
#include "scene/scene_file.h"
#include "support/number_of_cases.h"
#include "support/random_plan.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

Stream scene_stream(const char* name, std::size_t number) {
  return Seed(22).child(name, number).stream();
}

std::size_t any_row(Stream& draw, std::size_t rows) {
  return static_cast<std::size_t>(draw.integer(0, static_cast<int>(rows) - 1));
}

// One that lies within 900 m: large, tiny, of either sign, or one of the awkward ones.
float any_length(Stream& draw) {
  constexpr std::array awkward{0.0F,
                               -0.0F,
                               std::numeric_limits<float>::denorm_min(),
                               -std::numeric_limits<float>::min(),
                               0.1F,
                               1.0F / 3};
  if (draw.chance(0.2)) return awkward[any_row(draw, awkward.size())];
  const double size = std::exp(draw.uniform(-20, 6.8));
  return static_cast<float>(draw.chance(0.5) ? size : -size);
}

// What no generated shop says: values of all sizes in many of its rows.
void disturb(scene::Scene& scene, Stream& draw) {
  scene.seed = draw.bits();
  for (int k = 0; k < 200; ++k) {
    scene::SceneProduct& product = scene.products[any_row(draw, scene.products.size())];
    for (float& coordinate : product.position_m)
      coordinate = any_length(draw);
    for (float& part : product.rotation_wxyz)
      part = static_cast<float>(draw.uniform(-1, 1));
    product.flags = static_cast<std::uint32_t>(draw.bits());
    scene::ScenePart& part = scene.parts[any_row(draw, scene.parts.size())];
    for (float& coordinate : part.position_m)
      coordinate = any_length(draw);
    for (float& half : part.half_size_m)
      half = std::abs(any_length(draw));
    part.roughness = any_length(draw), part.metallic = any_length(draw);
    scene::Facing& facing = scene.facings[any_row(draw, scene.facings.size())];
    facing.x_m = any_length(draw);
    facing.stack = static_cast<std::uint16_t>(draw.integer(0, 65535));
    scene::PriceLabel& label = scene.price_labels[any_row(draw, scene.price_labels.size())];
    label.price_cents = static_cast<std::uint32_t>(draw.bits());
    label.x_m = any_length(draw);
    scene::SceneShelf& shelf = scene.shelves[any_row(draw, scene.shelves.size())];
    shelf.level = draw.integer(-1'000'000, 1'000'000);
    shelf.clearance_m = std::abs(any_length(draw));
    if (scene.joints.empty()) continue;
    scene::SceneJoint& joint = scene.joints[any_row(draw, scene.joints.size())];
    joint.friction = std::abs(any_length(draw)), joint.damping = std::abs(any_length(draw));
  }
}

// A small shop with goods; nothing where the plan has no layout.
std::optional<scene::Scene> random_scene(std::size_t number) {
  plan::Plan plan = RandomPlan(number).make();
  const Result<layout::Layout> layout =
      layout::make_layout(plan, committed_catalog(), Seed(number));
  if (!layout.ok()) return std::nullopt;
  auto scene = scene::build_scene(*layout, plan, committed_catalog(), Seed(number));
  if (!scene.ok() || scene->products.empty() || scene->price_labels.empty()) return std::nullopt;
  if (scene->products.size() > 30'000) return std::nullopt;  // proves no more and takes longer
  return std::move(scene).value();
}

std::span<const std::byte> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::byte*>(text.data()), text.size()};
}

// By their bytes: a field that the list of fields forgets is missing here.
template <class Row>
void expect_same_rows(const std::vector<Row>& a, const std::vector<Row>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(Row)), 0);
}

// By JSON, whose writer knows nothing of the file's tables.
void expect_same_fields(const scene::Scene& a, const scene::Scene& b, std::size_t number) {
  const std::string before = io::write_json(a), after = io::write_json(b);
  if (before == after) return;
  const std::size_t at =
      static_cast<std::size_t>(std::ranges::mismatch(before, after).in1 - before.begin());
  ADD_FAILURE() << "scene " << number << ": ..." << before.substr(at > 80 ? at - 80 : 0, 160);
}

TEST(SceneProperty, EveryFieldComesBackFromTheFile) {
  const ScratchFolder scratch;
  const std::size_t scenes = number_of_cases("MARKETGEN_PROPERTY_SCENES", 12);
  std::size_t made = 0;
  for (std::size_t i = 0; i < scenes; ++i) {
    std::optional<scene::Scene> scene = random_scene(i);
    if (!scene) continue;
    ++made;
    Stream draw = scene_stream("disturbed", i);
    disturb(*scene, draw);
    const std::string bytes = scene::encode_scene(*scene);
    const auto decoded = scene::decode_scene(bytes_of(bytes), "scene.bin");
    ASSERT_TRUE(decoded.ok()) << i << ": " << to_string(decoded.error());
    expect_same_fields(*scene, *decoded, i);
    expect_same_rows(scene->products, decoded->products);
    expect_same_rows(scene->facings, decoded->facings);
    expect_same_rows(scene->price_labels, decoded->price_labels);
    EXPECT_EQ(scene::encode_scene(*decoded), bytes) << i;
    ASSERT_TRUE(io::write_file(scratch.path() / "scene.bin", bytes).ok());
    const auto opened = scene::open_scene(scratch.path() / "scene.bin");
    ASSERT_TRUE(opened.ok()) << i << ": " << to_string(opened.error());
    EXPECT_EQ(scene::encode_scene(*opened), bytes) << i;
  }
  EXPECT_GE(2 * made, scenes);
}

// ---- Damage ----

// Flips of single bits, words with the numbers at which offsets and counts break, pieces copied
// over others, and ends cut off.
std::string damaged(const std::string& good, Stream& draw) {
  std::string bytes = good;
  const auto size = static_cast<int>(good.size());
  for (int damages = draw.integer(1, 3); damages > 0; --damages) {
    const auto at = static_cast<std::size_t>(draw.integer(0, size - 65));
    switch (draw.integer(0, 3)) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << draw.integer(0, 7)));
        break;
      case 1: {
        constexpr std::array<std::string_view, 4> words{
            {{"\0\0\0\0", 4}, {"\xff\xff\xff\xff", 4}, {"\xff\xff\xff\x7f", 4}, {"\0\0\0\x80", 4}}};
        bytes.replace(at / 4 * 4, 4, words[any_row(draw, words.size())]);
        break;
      }
      case 2: {
        const auto from = static_cast<std::size_t>(draw.integer(0, size - 65));
        bytes.replace(at, 64, good, from, 64);
        break;
      }
      default:
        break;
    }
  }
  // The head holds the offsets of all tables: a third of all damage goes there.
  if (draw.chance(0.3)) {
    const auto at = any_row(draw, 400);
    bytes[at] = static_cast<char>(draw.integer(0, 255));
  }
  if (draw.chance(0.15)) bytes.resize(any_row(draw, bytes.size()));
  return bytes;
}

// What was read can be used.
void expect_usable(const scene::Scene& scene) {
  for (const char* table : {"products", "fixtures", "zones", "prices", "materials", "planogram"}) {
    const auto rows = scene::query_scene(scene, table, "");
    ASSERT_TRUE(rows.ok()) << table;
    EXPECT_FALSE(scene::to_csv(*rows).empty());
  }
  const std::string again = scene::encode_scene(scene);
  const auto copy = scene::decode_scene(bytes_of(again), "scene.bin");
  ASSERT_TRUE(copy.ok()) << to_string(copy.error());
  EXPECT_EQ(scene::encode_scene(*copy), again);
  EXPECT_EQ(scene::scene_hash(*copy), scene::scene_hash(scene));
}

TEST(SceneProperty, DamagedFilesAreRefusedOrCanBeUsed) {
  const std::set<std::string> codes{"scene.corrupt", "scene.truncated", "scene.wrong_version"};
  const std::size_t rounds = number_of_cases("MARKETGEN_PROPERTY_DAMAGES", 600);
  std::size_t scenes = 0;
  std::map<std::string, std::size_t> refused;
  for (std::size_t i = 0; scenes < 3 && i < 60; ++i) {
    const std::optional<scene::Scene> scene = random_scene(100 + i);
    if (!scene || scene->products.size() > 6000) continue;
    ++scenes;
    const std::string good = scene::encode_scene(*scene);
    for (std::size_t round = 0; round < rounds / 3; ++round) {
      SCOPED_TRACE(fmt::format("scene {} round {}", 100 + i, round));
      Stream draw = scene_stream("damage", 10'000 * i + round);
      const auto decoded = scene::decode_scene(bytes_of(damaged(good, draw)), "scene.bin");
      if (decoded.ok()) {
        if (round % 8 == 0) expect_usable(*decoded);
        continue;
      }
      EXPECT_TRUE(codes.contains(decoded.error().code)) << decoded.error().code;
      ++refused[decoded.error().code];
    }
  }
  EXPECT_EQ(scenes, 3U);
  for (const std::string& code : codes)
    EXPECT_GT(refused[code], 0U) << code;
  EXPECT_GT(4 * refused["scene.corrupt"], rounds);
}

// ---- Queries between bounds ----

// What the table's cells are rounded to: nothing is asked of goods that lie so near to a bound.
constexpr double cell_m = 1e-4;

TEST(SceneProperty, QueriesFindWhatLiesBetweenTheirBounds) {
  std::size_t asked = 0, found = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const std::optional<scene::Scene> scene = random_scene(200 + i);
    if (!scene) continue;
    Stream draw = scene_stream("bounds", i);
    for (int k = 0; k < 6; ++k) {
      SCOPED_TRACE(fmt::format("scene {} box {}", 200 + i, k));
      ++asked;
      std::array<double, 3> low{}, high{};
      const auto& around = scene->products[any_row(draw, scene->products.size())].position_m;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = static_cast<double>(around[axis]) - std::exp(draw.uniform(-6, 2));
        high[axis] = static_cast<double>(around[axis]) + std::exp(draw.uniform(-6, 2));
      }
      const auto table =
          scene::query_scene(*scene,
                             "products",
                             fmt::format("x_m>={},x_m<{},y_m>{},y_m<={},z_m>={},z_m<={}",
                                         low[0],
                                         high[0],
                                         low[1],
                                         high[1],
                                         low[2],
                                         high[2]));
      ASSERT_TRUE(table.ok()) << to_string(table.error());
      std::set<std::string> ids;
      for (const std::vector<std::string>& row : table->rows)
        EXPECT_TRUE(ids.insert(row[0]).second);
      std::size_t inside = 0;
      for (std::uint32_t p = 0; p < scene->products.size(); ++p) {
        double depth = HUGE_VAL;  // how far inside of the box, negative outside
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double at = scene->products[p].position_m[axis];
          depth = std::min({depth, at - low[axis], high[axis] - at});
        }
        const bool listed = ids.contains(scene::product_id(*scene, p));
        inside += listed ? 1 : 0;
        if (std::abs(depth) < cell_m) continue;
        EXPECT_EQ(listed, depth > 0) << scene::product_id(*scene, p) << " by " << depth << " m";
      }
      EXPECT_EQ(inside, ids.size());
      found += inside;
    }
  }
  EXPECT_GE(asked, 24U);
  EXPECT_GT(found, asked);
}

}  // namespace
}  // namespace marketgen
