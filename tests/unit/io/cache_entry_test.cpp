// Entries of the cache: back as they were, or not at all; whatever is wrong with one is named,
// once.
#include "io/cache_entry.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/file.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kind = "things/1";

class CacheEntry : public testing::Test {
 protected:
  void keep() { ASSERT_TRUE(io::keep_entry(file_, kind, content_).ok()); }
  std::string kept() const { return io::kept_entry(file_, kind).value_or("nothing"); }

  // Nothing of it is used, it is taken away, and made anew it is as good as ever.
  void expect_healed(const std::string& damage) {
    EXPECT_EQ(kept(), "nothing") << damage;
    EXPECT_FALSE(fs::exists(fs::symlink_status(file_))) << damage;
    keep();
    EXPECT_EQ(kept(), content_) << damage;
  }

  ScratchFolder scratch_;
  fs::path file_ = scratch_.path() / "things" / "a";
  std::string content_ = std::string("twelve bytes") + '\0' + "and a zero";
};

TEST_F(CacheEntry, ComesBackAsItWas) {
  EXPECT_EQ(kept(), "nothing");
  keep();
  EXPECT_EQ(kept(), content_);
  content_ = "";
  keep();
  EXPECT_EQ(kept(), "");
  EXPECT_TRUE(contents_of(file_).starts_with(content_)) << "other programs read the content";
}

TEST_F(CacheEntry, NoBitCanBeTurnedAndNoByteBeMissing) {
  keep();
  const std::string whole = contents_of(file_);
  testing::internal::CaptureStderr();
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string turned = whole;
    turned[bit / 8] = static_cast<char>(turned[bit / 8] ^ (1 << bit % 8));
    ASSERT_TRUE(io::write_file(file_, turned).ok());
    expect_healed("bit " + std::to_string(bit));
  }
  for (std::size_t length = 0; length < whole.size(); ++length) {
    ASSERT_TRUE(io::write_file(file_, whole.substr(0, length)).ok());
    expect_healed("length " + std::to_string(length));
  }
  for (const std::string& other : {whole + '\0', whole + whole, std::string(whole.size(), '\0')}) {
    ASSERT_TRUE(io::write_file(file_, other).ok());
    expect_healed("another file");
  }
  testing::internal::GetCapturedStderr();
}

TEST_F(CacheEntry, WhatIsNoFileIsNotWaitedFor) {
  keep();
  fs::remove(file_);
  fs::create_directory(file_);
  expect_healed("an empty folder");
  fs::remove(file_);
  ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
  expect_healed("a pipe that nobody writes into");
  fs::remove(file_);
  fs::create_symlink(file_, file_);
  expect_healed("a link to itself");
  // What somebody put into a folder of that name is not ours to remove; it costs time only.
  fs::remove(file_);
  fs::create_directories(file_ / "with something in it");
  EXPECT_EQ(kept(), "nothing");
  EXPECT_FALSE(io::keep_entry(file_, kind, content_).ok());
  EXPECT_TRUE(fs::exists(file_ / "with something in it"));
}

TEST_F(CacheEntry, OneThatMayNotBeReadIsMadeAnew) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read anything";
  keep();
  fs::permissions(file_, fs::perms::none);
  expect_healed("without rights");
}

TEST_F(CacheEntry, AnotherKindOrVersionIsNotUsed) {
  keep();
  EXPECT_FALSE(io::kept_entry(file_, "things/2").has_value());
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(CacheEntry, ItIsNamedOnce) {
  testing::internal::CaptureStderr();
  for (int i = 0; i < 3; ++i) {
    keep();
    ASSERT_TRUE(io::write_file(file_, "nonsense").ok());
    EXPECT_EQ(kept(), "nothing");
  }
  const std::string said = testing::internal::GetCapturedStderr();
  const std::size_t first = said.find(file_.string());
  EXPECT_NE(first, std::string::npos) << said;
  EXPECT_EQ(said.find(file_.string(), first + 1), std::string::npos) << said;
}

TEST_F(CacheEntry, AFolderThatCannotBeWrittenIsSaidOnce) {
  testing::internal::CaptureStderr();
  for (const char* name : {"a", "b"})
    EXPECT_FALSE(io::keep_entry("/proc/no-such-folder/" + std::string(name), kind, content_).ok());
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("/proc/no-such-folder"), std::string::npos) << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

}  // namespace
}  // namespace marketgen
