// What a person drove: market-drive/1, and the file that holds it with its episode.
//
// JSON Lines packed with gzip: a market-drive/1, then an episodes file with that one episode. With
// the program's own data nothing else is needed to execute its actions again.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "episodes/episode_spec.h"

namespace marketgen::episodes {

struct DriveLog {
  std::string schema = "market-drive/1";
  std::string program, control_mode, realism;
  std::vector<std::string> action_names;
  std::vector<double> actions;
  bool over = false, success = false;
  std::string state_hash;

  static constexpr auto fields =
      field_list(field("schema", &DriveLog::schema, "schema tag", constant("market-drive/1")),
                 field("program", &DriveLog::program, "version that it was driven with"),
                 field("control_mode", &DriveLog::control_mode, "what an action is", required()),
                 field("realism", &DriveLog::realism, "what stood between world and robot"),
                 field("action_names",
                       &DriveLog::action_names,
                       "of each number of an action",
                       required(),
                       at_most_items(100)),
                 field("actions",
                       &DriveLog::actions,
                       "so many numbers a control step, one step after another; each is one of "
                       "float32",
                       required(),
                       range(-1, 1),
                       at_most_items(10'000'000)),
                 field("over", &DriveLog::over, "the driver said that it was done, or time ended"),
                 field("success", &DriveLog::success, "all goals were met then"),
                 field("state_hash",
                       &DriveLog::state_hash,
                       "of the physics after the last action; when it was over, after the "
                       "judgement",
                       required()));

  std::size_t steps() const {
    return action_names.empty() ? 0 : actions.size() / action_names.size();
  }
};

struct DriveFile {
  DriveLog log;
  EpisodeFile episode;  // one
};

std::string pack_drive(const DriveFile& file);
// Errors: those of gunzip, read_json at "SOURCE:1" and read_episodes; episode.truncated when there
// is not one episode, no action, or not a whole number of them.
Result<DriveFile> unpack_drive(std::string_view packed, const std::string& source);
Result<DriveFile> read_drive(const std::filesystem::path& file);

}  // namespace marketgen::episodes
