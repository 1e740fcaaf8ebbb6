// The frozen sets that come with the program are whole, open, and are what they are said to be.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <optional>
#include <sstream>

#include "environments/episode_ground.h"
#include "episodes/episode_sets.h"
#include "io/file.h"
#include "support/run_program.h"

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
  std::size_t left_out = 0;  // that one of its stores has not
  std::optional<std::string_view> station = {}, difficulty = {};
};
constexpr std::array v1_sets{
    FrozenSet{"checkout", episodes::Track::checkout},
    FrozenSet{"aisle", episodes::Track::aisle},
    FrozenSet{"aisle-suction", episodes::Track::aisle},
    FrozenSet{"checkout-suction", episodes::Track::checkout, 10},
    FrozenSet{"aisle-doors", episodes::Track::aisle, 20, episodes::Doors::hinged},
    FrozenSet{.name = "aisle-hard",
              .track = episodes::Track::aisle,
              .episodes_a_store = 10,
              .left_out = 1,
              .difficulty = "hard"},
    FrozenSet{.name = "checkout-stock",
              .track = episodes::Track::checkout,
              .episodes_a_store = 10,
              .station = "checkout-stock"}};

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
    EXPECT_EQ(spec.station, GetParam().station) << spec.id;
    EXPECT_EQ(spec.difficulty, GetParam().difficulty) << spec.id;
    EXPECT_EQ(spec.doors.value_or(episodes::Doors::none), GetParam().doors) << spec.id;
    for (const episodes::WitnessPick& pick : spec.certificate.witness)
      EXPECT_EQ(pick.door.has_value(), GetParam().doors != episodes::Doors::none) << spec.id;
    EXPECT_FALSE(spec.certificate.witness.empty()) << spec.id;
    EXPECT_EQ(spec.instruction.find(spec.goals.front().sku), std::string::npos) << spec.id;
  }
  std::size_t left_out = 0;
  for (const episodes::EpisodeStore& store : ground_->stores()) {
    ASSERT_LE(of_store[store.scene_hash], GetParam().episodes_a_store) << store.scene_hash;
    left_out += GetParam().episodes_a_store - of_store[store.scene_hash];
  }
  EXPECT_EQ(left_out, GetParam().left_out);
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

// ---- Files that are no longer those of their sums ----

// The program's data, copied, and taken as its own while this lives.
class OwnData {
 public:
  OwnData() {
    fs::copy(shipped_data, folder(), fs::copy_options::recursive);
    const char* before = std::getenv("MARKETGEN_DATA");
    if (before != nullptr) before_ = before;
    setenv("MARKETGEN_DATA", folder().c_str(), 1);
  }
  ~OwnData() {
    if (before_)
      setenv("MARKETGEN_DATA", before_->c_str(), 1);
    else
      unsetenv("MARKETGEN_DATA");
  }
  OwnData(const OwnData&) = delete;
  OwnData& operator=(const OwnData&) = delete;

  fs::path folder() const { return scratch_.path() / "data"; }
  fs::path v1() const { return folder() / "benchmark/v1"; }
  fs::path copied_set() const {
    fs::copy(v1(), scratch_.path() / "mine", fs::copy_options::recursive);
    return scratch_.path() / "mine";
  }

 private:
  ScratchFolder scratch_;
  std::optional<std::string> before_;
};

void flip_a_bit(const fs::path& file) {
  std::string bytes = io::read_file(file).value();
  bytes[bytes.size() / 2] ^= 1;
  ASSERT_TRUE(io::write_file(file, bytes).ok());
}

Error error_of_reading(const fs::path& named) {
  const auto read = episodes::read_episode_file(named);
  return read.ok() ? Error{"none", "", ""} : read.error();
}

TEST(ChangedSet, ASetHasItsNameHoweverItIsNamed) {
  const OwnData data;
  for (const fs::path& named : {fs::path("v1/aisle"), data.v1() / "aisle.jsonl.gz"}) {
    const auto read = episodes::read_episode_file(named);
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_EQ(read->set, "v1/aisle");
  }
  const auto copied = episodes::read_episode_file(data.copied_set() / "aisle.jsonl.gz");
  ASSERT_TRUE(copied.ok()) << to_string(copied.error());
  EXPECT_EQ(copied->set, "") << "a copy is the user's own";
}

TEST(ChangedSet, AChangedFileIsRefusedBeforeItIsRead) {
  const OwnData data;
  flip_a_bit(data.v1() / "aisle.jsonl.gz");
  const Error error = error_of_reading("v1/aisle");
  EXPECT_EQ(error.code, "episode.changed_set") << to_string(error);
  EXPECT_EQ(error.where, (data.v1() / "aisle.jsonl.gz").string());
  EXPECT_NE(error.message.find("install the program's data again"), std::string::npos);
}

TEST(ChangedSet, AChangedSceneIsRefusedBeforeItIsOpened) {
  const OwnData data;
  const auto read = episodes::read_episode_file("v1/aisle");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  const fs::path scene = read->header.stores.back().scene->file;
  const fs::path mine = data.copied_set();
  for (const fs::path& folder : {data.v1(), mine})
    flip_a_bit(folder / "scenes" / scene.filename());
  const Error error = error_of_reading("v1/aisle");
  EXPECT_EQ(error.code, "episode.changed_set") << to_string(error);
  EXPECT_EQ(error.where, (data.v1() / "scenes" / scene.filename()).string());
  EXPECT_EQ(error_of_reading(mine / "aisle.jsonl.gz").code, "none") << "it is the user's own";
}

TEST(ChangedSet, AFileThatIsNotListedIsRefused) {
  const OwnData data;
  ASSERT_TRUE(io::write_file(data.v1() / "SHA256SUMS", "").ok());
  const Error error = error_of_reading("v1/aisle");
  EXPECT_EQ(error.code, "episode.changed_set") << to_string(error);
  EXPECT_NE(error.message.find("does not list it"), std::string::npos) << error.message;
  fs::remove(data.v1() / "SHA256SUMS");
  EXPECT_EQ(error_of_reading("v1/aisle").code, "none");
}

INSTANTIATE_TEST_SUITE_P(V1, FrozenBenchmark, testing::ValuesIn(v1_sets), [](const auto& set) {
  std::string name = set.param.name;
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace marketgen
