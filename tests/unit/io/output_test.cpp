// Where outputs go: links, devices, pipes, modes, what dead processes left, several at once.
// Devices are copies in a folder of the test's: a program at fault as root would replace the
// machine's own.
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <thread>

#include "io/file.h"
#include "io/output.h"
#include "io/part_name.h"

namespace marketgen {
namespace {
namespace fs = std::filesystem;

class Destinations : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("marketgen-output-test-" + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path file(const std::string& name) const { return folder_ / name; }
  fs::path holding(const std::string& name, const std::string& text) const {
    std::ofstream(file(name)) << text;
    return file(name);
  }
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
      all.push_back(entry.path().lexically_relative(folder_).string());
    std::ranges::sort(all);
    return all;
  }
  static std::string text_of(const fs::path& path) { return io::read_file(path).value(); }
  static mode_t mode_of(const fs::path& path) {
    struct stat info {};
    lstat(path.c_str(), &info);
    return info.st_mode;
  }
  fs::path folder_;
};

TEST_F(Destinations, NoNameIsAnErrorAtOnce) {
  EXPECT_EQ(io::write_file("", "x").error().code, "usage.bad_flag");
  EXPECT_EQ(io::FolderDraft::begin("").error().code, "usage.bad_flag");
  EXPECT_EQ(io::write_file(fs::path(std::string("a\0b", 3)), "x").error().code, "usage.bad_flag");
  io::Outputs outputs;
  EXPECT_EQ(outputs.add_folder("").error().code, "usage.bad_flag");
}

TEST_F(Destinations, AWorkingFolderThatIsGone) {
  const fs::path here = file("gone");
  fs::create_directory(here);
  const pid_t child = fork();
  if (child == 0) {
    if (chdir(here.c_str()) != 0) _exit(1);
    fs::remove(here);
    const bool refused = io::write_file("a", "x").error().code == "io.cannot_write" &&
                         io::FolderDraft::begin("shop").error().code == "io.cannot_write";
    _exit(refused ? 7 : 8);
  }
  int state = 0;
  waitpid(child, &state, 0);
  EXPECT_EQ(WEXITSTATUS(state), 7);
}

TEST_F(Destinations, MissingFoldersAreMadeAndGoAgainWithAFailure) {
  ASSERT_TRUE(io::write_file(file("a/b/c"), "x").ok());
  EXPECT_EQ(text_of(file("a/b/c")), "x");
  {
    io::Outputs outputs;
    ASSERT_TRUE(outputs.add({{"-o", file("d/e/f")}}).ok());
    EXPECT_TRUE(fs::exists(file("d/e")));
  }
  EXPECT_FALSE(fs::exists(file("d")));
}

TEST_F(Destinations, ModesAreKeptAndNewOnesFollowTheUmask) {
  const mode_t before = umask(027);
  ASSERT_TRUE(io::write_file(file("new"), "x").ok());
  umask(before);
  EXPECT_EQ(mode_of(file("new")) & 0777U, 0640U);
  chmod(holding("secret", "old").c_str(), 0600);
  ASSERT_TRUE(io::write_file(file("secret"), "new").ok());
  EXPECT_EQ(mode_of(file("secret")) & 0777U, 0600U);
  EXPECT_EQ(text_of(file("secret")), "new");
}

TEST_F(Destinations, LinksKeepPointingAtTheirFile) {
  holding("target", "old");
  fs::create_symlink("target", file("link"));
  fs::create_symlink("link", file("link2"));
  ASSERT_TRUE(io::write_file(file("link2"), "new").ok());
  EXPECT_TRUE(fs::is_symlink(file("link")) && fs::is_symlink(file("link2")));
  EXPECT_EQ(text_of(file("target")), "new");
  fs::create_symlink("not-there-yet", file("ahead"));
  ASSERT_TRUE(io::write_file(file("ahead"), "x").ok());
  EXPECT_EQ(text_of(file("not-there-yet")), "x");
  fs::create_symlink("b", file("a"));
  fs::create_symlink("a", file("b"));
  EXPECT_EQ(io::write_file(file("a"), "x").error().code, "io.cannot_write");
}

TEST_F(Destinations, DevicesAreWrittenNotReplaced) {
  if (mknod(file("null").c_str(), S_IFCHR | 0666U, makedev(1, 3)) != 0 ||
      mknod(file("full").c_str(), S_IFCHR | 0666U, makedev(1, 7)) != 0)
    GTEST_SKIP() << "devices can be made by root only";
  EXPECT_TRUE(io::write_file(file("null"), "x").ok());
  const auto full = io::write_file(file("full"), "x");
  ASSERT_FALSE(full.ok());
  EXPECT_EQ(full.error().code, "io.cannot_write");
  EXPECT_EQ(full.error().where, file("full").string());
  EXPECT_TRUE(S_ISCHR(mode_of(file("null"))) && S_ISCHR(mode_of(file("full"))));
  EXPECT_EQ(names().size(), 2U);
}

TEST_F(Destinations, PipesAreWrittenTo) {
  ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = text_of(file("pipe")); });
  const std::string much(300'000, 'x');  // more than a pipe holds
  EXPECT_TRUE(io::write_file(file("pipe"), much).ok());
  reader.join();
  EXPECT_EQ(got, much);
  EXPECT_TRUE(S_ISFIFO(mode_of(file("pipe"))));
}

TEST_F(Destinations, OpenDescriptorsAreWrittenWhereTheyStand) {
  const int fd = open(file("log").c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_EQ(write(fd, "one ", 4), 4);
  ASSERT_TRUE(io::write_file("/dev/fd/" + std::to_string(fd), "two").ok());
  ASSERT_EQ(write(fd, " three", 6), 6);
  close(fd);
  EXPECT_EQ(text_of(file("log")), "one two three");
  EXPECT_FALSE(io::write_file("/dev/fd/" + std::to_string(fd), "two").ok());  // closed
}

TEST_F(Destinations, FoldersAreNoFiles) {
  for (const fs::path& path : {folder_, folder_ / "", folder_ / ".", folder_ / "x/"}) {
    const auto written = io::write_file(path, "x");
    ASSERT_FALSE(written.ok()) << path;
    EXPECT_EQ(written.error().code, "io.cannot_write") << path;
  }
}

TEST_F(Destinations, LongNamesCanBeWritten) {
  const std::string longest(255, 'n');
  EXPECT_TRUE(io::write_file(file(longest), "x").ok());
  EXPECT_EQ(io::write_file(file(longest + "n"), "x").error().code, "io.cannot_write");
}

TEST_F(Destinations, AMountedFolderTakesAStore) {
  fs::create_directory(file("disk"));
  if (mount("none", file("disk").c_str(), "tmpfs", 0, "size=256k") != 0)
    GTEST_SKIP() << "only root can mount";
  {
    auto draft = io::FolderDraft::begin(file("disk"));
    ASSERT_TRUE(draft.ok()) << draft.error().message;
    ASSERT_TRUE(io::write_file(draft->folder() / "store.json", "x").ok());
    const auto full = io::write_file(draft->folder() / "big", std::string(1'000'000, 'x'));
    EXPECT_EQ(full.error().code, "io.cannot_write");
    EXPECT_NE(full.error().message.find("make room"), std::string::npos);
    EXPECT_TRUE(draft->commit().ok());
  }
  EXPECT_EQ(names(), (std::vector<std::string>{"disk", "disk/store.json"}));
  umount(file("disk").c_str());
}

TEST_F(Destinations, AnEmptyFolderThatIsThereKeepsItsMode) {
  fs::create_directory(file("shop"));
  chmod(file("shop").c_str(), 0700);
  fs::create_symlink("shop", file("link"));
  {
    auto draft = io::FolderDraft::begin(file("link"));
    ASSERT_TRUE(draft.ok());
    ASSERT_TRUE(io::write_file(draft->folder() / "x", "1").ok());
    ASSERT_TRUE(draft->commit().ok());
  }
  EXPECT_EQ(mode_of(file("shop")) & 0777U, 0700U);
  EXPECT_EQ(names(), (std::vector<std::string>{"link", "shop", "shop/x"}));
}

TEST_F(Destinations, PartsOfTheDeadAreSweptThoseOfTheLivingStay) {
  std::ofstream(io::part_in(folder_, "ours")) << "being written";
  setenv("MARKETGEN_TEST_FOLDER", folder_.c_str(), 1);
  const pid_t child = fork();
  if (child == 0) {
    execl("/proc/self/exe",
          "test_io",
          "--gtest_also_run_disabled_tests",
          "--gtest_filter=LeftByAProcess.*",
          nullptr);
    _exit(1);
  }
  waitpid(child, nullptr, 0);
  EXPECT_EQ(names().size(), 2U);
  std::ofstream(file(".other.123-abcdef01.part")) << "somebody else's";
  io::sweep_parts(folder_);
  const auto left = names();
  ASSERT_EQ(left.size(), 2U);
  EXPECT_TRUE(
      std::ranges::any_of(left, [](const auto& name) { return name.starts_with(".ours"); }));
}

TEST_F(Destinations, SeveralOutputsAreReplacedTogether) {
  holding("one", "old");
  holding("two", "old");
  {
    io::Outputs outputs;
    ASSERT_TRUE(outputs.add({{"-o", file("one")}, {"--two", file("two")}, {"--three", {}}}).ok());
    ASSERT_TRUE(outputs.put(file("one"), "new").ok());
    EXPECT_EQ(text_of(file("one")), "old");
    ASSERT_TRUE(outputs.put(file("two"), "new").ok());
    ASSERT_TRUE(outputs.commit().ok());
    EXPECT_EQ(text_of(file("one")) + text_of(file("two")), "newnew");
  }
  EXPECT_EQ(names(), (std::vector<std::string>{"one", "two"}));
}

TEST_F(Destinations, WhatIsNotCommittedIsNotThere) {
  holding("one", "old");
  {
    io::Outputs outputs;
    ASSERT_TRUE(outputs.add({{"-o", file("one")}, {"--two", file("two")}}).ok());
    ASSERT_TRUE(outputs.put(file("one"), "new").ok());
  }
  EXPECT_EQ(text_of(file("one")), "old");
  EXPECT_EQ(names(), (std::vector<std::string>{"one"}));
}

TEST_F(Destinations, WhatIsPutTwiceIsWhatWasPutLast) {
  {
    io::Outputs outputs;
    ASSERT_TRUE(outputs.add_folder(folder_).ok());
    for (const char* text : {"first, and longer", "last"})
      ASSERT_TRUE(outputs.put(file("one"), text).ok());
    ASSERT_TRUE(outputs.commit().ok());
  }
  EXPECT_EQ(text_of(file("one")), "last");
  EXPECT_EQ(names(), (std::vector<std::string>{"one"}));
}

TEST_F(Destinations, AFullDiskLeavesNoneOfSeveral) {
  fs::create_directory(file("disk"));
  if (mount("none", file("disk").c_str(), "tmpfs", 0, "size=256k") != 0)
    GTEST_SKIP() << "only root can mount";
  {
    io::Outputs outputs;
    ASSERT_TRUE(outputs.add_folder(file("disk")).ok());
    ASSERT_TRUE(outputs.put(file("disk/one"), "fits").ok());
    const auto full = outputs.put(file("disk/two"), std::string(1'000'000, 'x'));
    EXPECT_EQ(full.error().code, "io.cannot_write");
    EXPECT_EQ(full.error().where, file("disk/two"));
    EXPECT_NE(full.error().message.find("make room"), std::string::npos);
  }
  EXPECT_EQ(names(), (std::vector<std::string>{"disk"}));
  umount(file("disk").c_str());
}

TEST_F(Destinations, OneThatCannotBePutInPlaceTakesTheOthersBack) {
  holding("one", "old");
  {
    io::Outputs outputs;
    ASSERT_TRUE(
        outputs.add({{"-o", file("one")}, {"--new", file("new")}, {"--last", file("last")}}).ok());
    for (const char* name : {"one", "new", "last"})
      ASSERT_TRUE(outputs.put(file(name), "fresh").ok());
    fs::create_directories(file("last/in-the-way"));  // since it was probed
    EXPECT_EQ(outputs.commit().error().code, "io.cannot_write");
  }
  EXPECT_EQ(text_of(file("one")), "old");
  EXPECT_FALSE(fs::exists(file("new")));
  EXPECT_EQ(names(), (std::vector<std::string>{"last", "last/in-the-way", "one"}));
}

TEST_F(Destinations, TwoOutputsOfOneNameAreAnError) {
  fs::create_symlink("one", file("link"));
  io::Outputs outputs;
  const auto twice = outputs.add({{"-o", file("one")}, {"--depth", file("link")}});
  ASSERT_FALSE(twice.ok());
  EXPECT_EQ(twice.error().code, "usage.bad_flag");
  EXPECT_EQ(twice.error().where, "--depth");
}

TEST_F(Destinations, ErrorsNameTheFileThatWasAskedFor) {
  io::Outputs outputs;
  ASSERT_TRUE(outputs.add({{"-o", file("one")}}).ok());
  const auto failed = outputs.put(file("one"), [](const fs::path& place) {
    return Error{"io.cannot_write", place.string(), "is the disk full?"};
  });
  EXPECT_EQ(failed.error().where, file("one").string());
}

// Run by a test above, in a process of its own that is gone when its part is looked at.
TEST(LeftByAProcess, DISABLED_LeavesAPart) {
  const char* folder = std::getenv("MARKETGEN_TEST_FOLDER");
  if (folder == nullptr) GTEST_SKIP();
  std::ofstream(io::part_in(folder, "dead")) << "half";
}

}  // namespace
}  // namespace marketgen
