// The picture cache: drawn once, read afterwards, and never trusted when damaged.
#include "render/picture_cache.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace marketgen::render::raytrace {
namespace {

class PictureCache : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("marketgen-picture-cache-" + std::to_string(::getpid()));
    std::filesystem::remove_all(folder_);
    setenv("MARKETGEN_CACHE", folder_.c_str(), 1);
  }
  void TearDown() override {
    unsetenv("MARKETGEN_CACHE");
    std::filesystem::remove_all(folder_);
  }

  Image get() {
    const Result<Image> image = cached_picture("four grey pixels", [this]() -> Result<Image> {
      ++drawn_;
      Image fresh(2, 2);
      for (std::size_t i = 0; i < fresh.pixels.size(); ++i)
        fresh.pixels[i] = static_cast<std::uint8_t>(100 + i);
      return fresh;
    });
    EXPECT_TRUE(image.ok());
    return *image;
  }
  std::filesystem::path only_file() const {
    return std::filesystem::directory_iterator(folder_ / "labels")->path();
  }

  std::filesystem::path folder_;
  int drawn_ = 0;
};

TEST_F(PictureCache, DrawsOnce) {
  const Image first = get(), second = get();
  EXPECT_EQ(drawn_, 1);
  EXPECT_EQ(first.pixels, second.pixels);
  EXPECT_EQ(second.width, 2);
}

TEST_F(PictureCache, DamagedFilesAreDrawnAgain) {
  const Image first = get();
  const std::filesystem::path file = only_file();
  const auto whole = std::filesystem::file_size(file);
  std::filesystem::resize_file(file, whole - 1);  // cut short
  EXPECT_EQ(get().pixels, first.pixels);
  EXPECT_EQ(drawn_, 2);
  std::fstream(file, std::ios::in | std::ios::out | std::ios::binary)
      .seekp(static_cast<std::streamoff>(whole) - 1)
      .put('\0');  // one wrong pixel
  EXPECT_EQ(get().pixels, first.pixels);
  EXPECT_EQ(drawn_, 3);
}

TEST_F(PictureCache, PrintKeepsItsBlocksAndBars) {
  int drawn = 0;
  const auto get_print = [&] {
    return cached_print("a print",
                        [&]() -> Result<assets::PrintedPicture> {
                          ++drawn;
                          Image picture(9, 5);
                          for (std::size_t i = 0; i < picture.pixels.size(); ++i)
                            picture.pixels[i] = static_cast<std::uint8_t>(i * 3);
                          const assets::LabelBars bars{
                              0.1F, 0.2F, 0.3F, 0.4F, 0.5F, true, std::string(95, '1')};
                          return assets::PrintedPicture{picture, bars};
                        })
        .value();
  };
  const Print first = get_print(), second = get_print();
  EXPECT_EQ(drawn, 1);
  EXPECT_TRUE(first.drawn);
  EXPECT_FALSE(second.drawn);
  EXPECT_EQ(second.blocks.blocks(), first.blocks.blocks());
  EXPECT_EQ(second.blocks.width(), 9);
  EXPECT_EQ(second.bars->modules, std::string(95, '1'));
  EXPECT_EQ(second.bars->v1, 0.4F);
  EXPECT_TRUE(second.bars->ladder);
  std::filesystem::resize_file(only_file(), std::filesystem::file_size(only_file()) - 8);
  EXPECT_EQ(get_print().blocks.blocks(), first.blocks.blocks());
  EXPECT_EQ(drawn, 2);
}

TEST_F(PictureCache, AFolderThatCannotBeWrittenCostsOnlyTime) {
  setenv("MARKETGEN_CACHE", "/proc/nowhere", 1);
  EXPECT_EQ(get().width, 2);
  EXPECT_EQ(get().width, 2);
  EXPECT_EQ(drawn_, 2);
}

}  // namespace
}  // namespace marketgen::render::raytrace
