#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>

#include "io/file.h"
#include "io/png.h"

namespace marketgen {
namespace {
namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("marketgen-file-test-" + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  fs::path folder_;
};

TEST_F(Files, WriteReplacesAndLeavesNothingBeside) {
  ASSERT_TRUE(io::write_file(folder_ / "a", "one").ok());
  ASSERT_TRUE(io::write_file(folder_ / "a", "two").ok());
  EXPECT_EQ(io::read_file(folder_ / "a").value(), "two");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(Files, ErrorsNameTheFile) {
  EXPECT_EQ(io::read_file(folder_ / "none").error().code, "input.not_found");
  EXPECT_EQ(io::read_file(folder_).error().code, "io.cannot_read");
  std::ofstream(folder_ / "file") << "x";
  EXPECT_EQ(io::write_file(folder_ / "file" / "a", "x").error().code, "io.cannot_write");
  EXPECT_EQ(io::write_file(folder_, "x").error().code, "io.cannot_write");
  ASSERT_TRUE(io::write_file(folder_ / "big", std::string(100, 'x')).ok());
  EXPECT_EQ(io::read_file(folder_ / "big", 99).error().code, "input.too_large");
}

TEST_F(Files, AFolderDraftAppearsWholeOrNotAtAll) {
  {
    auto draft = io::FolderDraft::begin(folder_ / "store");
    ASSERT_TRUE(draft.ok());
    ASSERT_TRUE(io::write_file(draft->folder() / "x", "1").ok());
    EXPECT_FALSE(fs::exists(folder_ / "store"));
  }
  EXPECT_EQ(entries(), 0U);  // dropped without commit
  auto draft = io::FolderDraft::begin(folder_ / "store");
  ASSERT_TRUE(io::write_file(draft->folder() / "x", "1").ok());
  ASSERT_TRUE(draft->commit().ok());
  EXPECT_EQ(io::read_file(folder_ / "store" / "x").value(), "1");
  EXPECT_EQ(io::FolderDraft::begin(folder_ / "store").error().code, "store.exists");
}

TEST_F(Files, AFolderDraftTakesTheParentsItMadeWithIt) {
  { ASSERT_TRUE(io::FolderDraft::begin(folder_ / "2026/november/store").ok()); }
  EXPECT_EQ(entries(), 0U);
  fs::create_directory(folder_ / "2026");
  { ASSERT_TRUE(io::FolderDraft::begin(folder_ / "2026/november/store").ok()); }
  EXPECT_EQ(entries(), 1U);  // was there before
  EXPECT_TRUE(fs::is_empty(folder_ / "2026"));
  ASSERT_TRUE(io::FolderDraft::begin(folder_ / "2026/november/store")->commit().ok());
  EXPECT_TRUE(fs::exists(folder_ / "2026/november/store"));
}

TEST_F(Files, Sha256MatchesFips180) {  // FIPS 180-4 example: "abc"
  EXPECT_EQ(io::sha256_hex("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  ASSERT_TRUE(io::write_file(folder_ / "abc", "abc").ok());
  EXPECT_EQ(io::sha256_of_file(folder_ / "abc").value(), io::sha256_hex("abc"));
}

TEST_F(Files, PngKeepsEveryPixel) {
  Image image(7, 3, 4);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<std::uint8_t>(i * 37);
  ASSERT_TRUE(io::write_png(folder_ / "a.png", image).ok());
  const auto back = io::read_png(folder_ / "a.png");
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back->width, 7);
  EXPECT_EQ(back->pixels, image.pixels);
}

TEST_F(Files, DamagedPngIsAnError) {
  ASSERT_TRUE(io::write_file(folder_ / "a.png", "not a picture").ok());
  EXPECT_EQ(io::read_png(folder_ / "a.png").error().code, "image.bad_file");
}

}  // namespace
}  // namespace marketgen
