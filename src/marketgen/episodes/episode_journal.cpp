#include "episodes/episode_journal.h"

#include "io/json.h"

namespace marketgen::episodes {

Result<std::unique_ptr<EpisodeJournal>> EpisodeJournal::begin(const std::filesystem::path& file,
                                                              const std::string& draw,
                                                              bool resume) {
  std::unique_ptr<EpisodeJournal> journal(new EpisodeJournal);
  MARKETGEN_TRY(journal->lines_, io::LineJournal::begin(file, draw, resume));
  for (const std::string& line : journal->lines_->before()) {
    MARKETGEN_TRY(DrawnEpisode drawn, io::read_json<DrawnEpisode>(line, file.string()));
    journal->before_[drawn.number] = std::move(drawn);
  }
  return journal;
}

Result<void> EpisodeJournal::keep(const DrawnEpisode& drawn) {
  return lines_->keep(io::write_json_line(drawn));
}

}  // namespace marketgen::episodes
