#include "episodes/drive_log.h"

#include <fmt/format.h>

#include "io/file.h"
#include "io/gzip.h"
#include "io/json.h"

namespace marketgen::episodes {

std::string pack_drive(const DriveFile& file) {
  return io::gzip(
      fmt::format("{}\n{}", io::write_json_line(file.log), write_episodes(file.episode)));
}

Result<DriveFile> unpack_drive(std::string_view packed, const std::string& source) {
  MARKETGEN_TRY(const std::string text, io::gunzip(packed, source));
  const std::size_t end = text.find('\n');
  const std::string_view head = std::string_view(text).substr(0, end);
  DriveFile file;
  MARKETGEN_TRY(file.log, io::read_json<DriveLog>(head, source + ":1"));
  const std::string_view rest =
      end == std::string::npos ? std::string_view() : std::string_view(text).substr(end + 1);
  MARKETGEN_TRY(file.episode, read_episodes(rest, source));
  const DriveLog& log = file.log;
  if (file.episode.episodes.size() == 1 && log.steps() > 0 &&
      log.actions.size() == log.steps() * log.action_names.size())
    return file;
  return Error{"episode.truncated",
               source,
               fmt::format("{} numbers of {} each and {} episodes; expected whole actions of one "
                           "episode: drive it again",
                           log.actions.size(),
                           log.action_names.size(),
                           file.episode.episodes.size())};
}

Result<DriveFile> read_drive(const std::filesystem::path& file) {
  MARKETGEN_TRY(const std::string packed, io::read_file(file));
  return unpack_drive(packed, file.filename().string());
}

}  // namespace marketgen::episodes
