// The frozen sets that come with the program are whole, open, and are what they are said to be.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <sstream>

#include "environments/episode_ground.h"
#include "episodes/episode_sets.h"
#include "io/file.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

const fs::path shipped_data = fs::path(MARKETGEN_SOURCE_DIR) / "data";
const fs::path v1_folder = shipped_data / "benchmark/v1";
constexpr std::size_t v1_stores = 10;  // of a set; those behind doors have ten of their own

struct FrozenSet {
  const char* name;
  episodes::Track track;
  std::size_t episodes_a_store = 100;
  episodes::Doors doors = episodes::Doors::none;
};
constexpr std::array v1_sets{
    FrozenSet{"checkout", episodes::Track::checkout},
    FrozenSet{"aisle", episodes::Track::aisle},
    FrozenSet{"aisle-suction", episodes::Track::aisle},
    FrozenSet{"aisle-doors", episodes::Track::aisle, 20, episodes::Doors::hinged}};

class FrozenBenchmark : public testing::TestWithParam<FrozenSet> {
 protected:
  void SetUp() override {
    const auto file =
        episodes::find_episode_file(std::string("v1/") + GetParam().name, shipped_data);
    ASSERT_TRUE(file.ok()) << to_string(file.error());
    const auto ground = environments::EpisodeGround::of_file(*file);
    ASSERT_TRUE(ground.ok()) << to_string(ground.error());
    ground_ = *ground;
  }
  std::shared_ptr<environments::EpisodeGround> ground_;
};

TEST_P(FrozenBenchmark, HasAsManyEpisodesOfEachOfItsStores) {
  EXPECT_EQ(ground_->stores().size(), v1_stores);
  std::map<std::string, std::size_t> of_store;
  for (const episodes::EpisodeSpec& spec : ground_->episodes()) {
    ++of_store[spec.scene_hash];
    EXPECT_EQ(spec.track, GetParam().track);
    EXPECT_EQ(spec.doors.value_or(episodes::Doors::none), GetParam().doors) << spec.id;
    for (const episodes::WitnessPick& pick : spec.certificate.witness)
      EXPECT_EQ(pick.door.has_value(), GetParam().doors != episodes::Doors::none) << spec.id;
    EXPECT_FALSE(spec.certificate.witness.empty()) << spec.id;
    EXPECT_EQ(spec.instruction.find(spec.goals.front().sku), std::string::npos) << spec.id;
  }
  for (const episodes::EpisodeStore& store : ground_->stores())
    EXPECT_EQ(of_store[store.scene_hash], GetParam().episodes_a_store) << store.scene_hash;
}

TEST_P(FrozenBenchmark, ItsFirstAndLastEpisodesOpen) {
  for (const episodes::EpisodeSpec* spec :
       {&ground_->episodes().front(), &ground_->episodes().back()}) {
    const auto world = ground_->arena().open(*spec);
    EXPECT_TRUE(world.ok()) << spec->id << ": " << to_string(world.error());
  }
}

// Frozen before rows said what is seen through glass: they are seen as the catalogue has them now.
TEST_P(FrozenBenchmark, ItsJarsShowWhatIsInThem) {
  const auto scene = ground_->arena().scene(ground_->stores().back().scene_hash);
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  int jars = 0;
  for (const catalog::Product& row : (*scene)->catalog) {
    if (row.archetype != "jar") continue;
    EXPECT_TRUE(row.contents.has_value()) << row.sku;
    ++jars;
  }
  EXPECT_GT(jars, 10);
  for (const catalog::Product& row : ground_->products())
    EXPECT_TRUE(row.archetype != "jar" || row.contents) << row.sku;
}

TEST_P(FrozenBenchmark, ItsStoresAreInItsFiles) {
  for (const episodes::EpisodeStore& store : ground_->stores()) {
    ASSERT_TRUE(store.scene) << store.scene_hash;
    EXPECT_EQ(io::sha256_of_file(store.scene->file).value(), store.scene->sha256);
  }
}

TEST(FrozenBenchmarkFolder, SumsAreThoseOfAllItsFiles) {
  std::istringstream sums(io::read_file(v1_folder / "SHA256SUMS").value());
  std::size_t files = 0;
  for (std::string sum, name; sums >> sum >> name; ++files)
    EXPECT_EQ(io::sha256_of_file(v1_folder / name).value(), sum) << name;
  EXPECT_EQ(files, v1_sets.size() + 2 * v1_stores);
}

INSTANTIATE_TEST_SUITE_P(V1, FrozenBenchmark, testing::ValuesIn(v1_sets), [](const auto& set) {
  std::string name = set.param.name;
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace marketgen
