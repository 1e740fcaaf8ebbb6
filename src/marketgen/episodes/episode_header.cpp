#include "episodes/episode_header.h"

#include <string>
#include <string_view>

#include "episodes/episode_sets.h"
#include "episodes/frozen_store.h"
#include "io/file.h"
#include "io/gzip.h"
#include "io/json.h"

namespace marketgen::episodes {
namespace fs = std::filesystem;

Result<EpisodeHeader> read_episode_header(const fs::path& named, const fs::path& data) {
  MARKETGEN_TRY(const fs::path found, find_episode_file(named, data));
  const std::string source = found.filename().string();
  MARKETGEN_TRY(std::string text, io::read_file(found));
  if (io::is_gzip(text)) {
    MARKETGEN_TRY(text, io::gunzip(text, source));
  }
  const std::string_view line = std::string_view(text).substr(0, text.find('\n'));
  MARKETGEN_TRY(EpisodeHeader header, io::read_json<EpisodeHeader>(line, source + ":1"));
  MARKETGEN_CHECK(find_scenes(header, source, found.parent_path()));
  return header;
}

}  // namespace marketgen::episodes
