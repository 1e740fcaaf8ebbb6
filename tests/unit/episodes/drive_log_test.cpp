// Logs of drives: what is read is what was written, and what is broken is refused with its place.
#include "episodes/drive_log.h"

#include <gtest/gtest.h>

#include "io/gzip.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

episodes::DriveFile drive_of_pool() {
  episodes::DriveFile file;
  file.log.program = "1";
  file.log.control_mode = "pd_ee_delta_pose";
  file.log.realism = "ideal";
  file.log.action_names = {"drive", "stop"};
  file.log.actions = {0.5, -1, 1.0 / 1024, 1};
  file.log.over = true;
  file.log.state_hash = "00ff";
  auto pool = episodes::read_episode_file("pool/checkout");
  if (!pool.ok()) fatal(to_string(pool.error()).c_str());
  file.episode = std::move(pool).value();
  file.episode.header.episodes = 1;
  file.episode.episodes.resize(1);
  return file;
}

TEST(DriveLog, IsReadAsItWasWritten) {
  const episodes::DriveFile file = drive_of_pool();
  const auto read = episodes::unpack_drive(episodes::pack_drive(file), "log");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->log.actions, file.log.actions);
  EXPECT_EQ(read->log.steps(), 2U);
  EXPECT_EQ(read->log.state_hash, "00ff");
  EXPECT_TRUE(read->log.over);
  EXPECT_EQ(episodes::write_episodes(read->episode), episodes::write_episodes(file.episode));
}

std::string code_of(const episodes::DriveFile& file) {
  const auto read = episodes::unpack_drive(episodes::pack_drive(file), "log");
  return read.ok() ? "ok" : read.error().code;
}

TEST(DriveLog, RefusesWhatIsNotWhole) {
  episodes::DriveFile cut = drive_of_pool();
  cut.log.actions.pop_back();
  EXPECT_EQ(code_of(cut), "episode.truncated");
  episodes::DriveFile empty = drive_of_pool();
  empty.log.actions.clear();
  EXPECT_EQ(code_of(empty), "episode.truncated");
  episodes::DriveFile two = drive_of_pool();
  two.episode.header.episodes = 2;
  EXPECT_EQ(code_of(two), "episode.truncated");
  episodes::DriveFile far = drive_of_pool();
  far.log.actions.front() = 1.5;
  EXPECT_EQ(code_of(far).substr(0, 5), "json.");
  const std::string packed = episodes::pack_drive(drive_of_pool());
  EXPECT_EQ(episodes::unpack_drive(packed.substr(0, packed.size() / 2), "log").error().code,
            "input.malformed");
  EXPECT_FALSE(episodes::unpack_drive(io::gzip("{}\n"), "log").ok());
  EXPECT_FALSE(episodes::unpack_drive(io::gzip(""), "log").ok());
}

}  // namespace
}  // namespace marketgen
