// Light kept on disk: pictures are the same with it, and no file can spoil one.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/file.h"
#include "render/render.h"
#include "support/run_program.h"
#include "synthetic_scene.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

class LightCache : public ::testing::Test {
 protected:
  LightCache() : scene_(empty_room(6000, 6000, 3000)) {
    if (const char* before = std::getenv("MARKETGEN_CACHE")) before_ = before;
    use_cache(scratch_.path());
    add_box_fixture(scene_, {3, 3.5F, 0}, {0, 0, 0.4F}, {0.5F, 0.5F, 0.4F});
  }
  ~LightCache() override {
    if (before_)
      use_cache(*before_);
    else
      ::unsetenv("MARKETGEN_CACHE");
  }
  static void use_cache(const fs::path& folder) { ::setenv("MARKETGEN_CACHE", folder.c_str(), 1); }

  enum class Keep { no, yes };
  std::vector<std::uint8_t> pixels(Keep keep = Keep::yes) const {
    const auto renderer =
        render::Renderer::create(scene_, silent_progress(), {.keep_light = keep == Keep::yes});
    EXPECT_TRUE(renderer.ok());
    render::Camera camera;
    camera.from = {3, 1, 1.2};
    camera.at = {3, 3, 0.6};
    camera.width = 80;
    camera.height = 60;
    return (*renderer)->render(camera, {})->color.pixels;
  }
  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    std::error_code none_yet;
    for (const auto& entry : fs::directory_iterator(scratch_.path() / "light", none_yet))
      found.push_back(entry.path());
    return found;
  }

  ScratchFolder scratch_;
  std::optional<std::string> before_;
  scene::Scene scene_;
};

TEST_F(LightCache, PicturesAreTheSameWithoutWithNewAndWithOldLight) {
  const auto without = pixels(Keep::no);
  EXPECT_TRUE(files().empty());
  EXPECT_EQ(pixels(), without);
  ASSERT_EQ(files().size(), 1U);
  const auto written = fs::last_write_time(files()[0]);
  EXPECT_EQ(pixels(), without);
  EXPECT_EQ(fs::last_write_time(files()[0]), written) << "it was baked again";
}

TEST_F(LightCache, AnotherLookAndMovedThingsHaveOtherLight) {
  const auto before = pixels();
  scene_.layout.look.light_kelvin += 2500;
  EXPECT_NE(pixels(), before);
  EXPECT_EQ(files().size(), 2U);
  scene_.fixtures[0].position_m[0] += 0.5F;
  pixels();
  EXPECT_EQ(files().size(), 3U);
}

TEST_F(LightCache, DamagedFilesAreBakedAnew) {
  const auto right = pixels();
  const fs::path file = files().at(0);
  const std::string whole = io::read_file(file).value();
  std::string flipped = whole;
  flipped[whole.size() / 2] ^= 0x10;
  for (const std::string& damaged : {std::string(), whole.substr(0, whole.size() / 2), flipped}) {
    ASSERT_TRUE(io::write_file(file, damaged).ok());
    EXPECT_EQ(pixels(), right);
    EXPECT_EQ(io::read_file(file).value(), whole) << "put right";
  }
}

TEST_F(LightCache, PlacesThatCannotBeWrittenAreNoFault) {
  use_cache("/dev/null/no/such/place");
  EXPECT_EQ(pixels(), pixels(Keep::no));
}

TEST_F(LightCache, TheOldestFilesGo) {
  fs::create_directories(scratch_.path() / "light");
  for (int i = 0; i < 256; ++i) {
    const fs::path file = scratch_.path() / "light" / (std::to_string(i) + ".bin");
    ASSERT_TRUE(io::write_file(file, "x").ok());
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(1000 - i));
  }
  pixels();
  EXPECT_EQ(files().size(), 256U);
  EXPECT_FALSE(fs::exists(scratch_.path() / "light" / "0.bin"));
  EXPECT_TRUE(fs::exists(scratch_.path() / "light" / "1.bin"));
}

}  // namespace
}  // namespace marketgen
