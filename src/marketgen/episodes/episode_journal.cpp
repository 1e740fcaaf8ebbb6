#include "episodes/episode_journal.h"

#include <sstream>

#include <fmt/format.h>

#include "io/file.h"
#include "io/json.h"

namespace marketgen {
namespace {

struct JournalHead {
  std::string schema = "market-drawing/1", draw;
  static constexpr auto fields =
      field_list(field("schema", &JournalHead::schema, "schema tag", constant("market-drawing/1")),
                 field("draw", &JournalHead::draw, "what decides the episodes", required()));
};

}  // namespace

// Only whole lines: the last one may have been cut off with the process.
Result<void> EpisodeJournal::read(const std::string& draw) {
  std::error_code failed;
  if (!std::filesystem::exists(file_, failed)) return {};
  MARKETGEN_TRY(const std::string text, read_file(file_));
  std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
  std::string line;
  if (!std::getline(lines, line)) return {};
  MARKETGEN_TRY(const JournalHead head, read_json<JournalHead>(line, file_.string()));
  if (head.draw != draw)
    return Error{"usage.bad_flag",
                 "--resume",
                 fmt::format("{} was drawn from other stores, with other flags or by another "
                             "version: go on as it was begun, or leave the flag out",
                             file_.string())};
  while (std::getline(lines, line)) {
    MARKETGEN_TRY(DrawnEpisode drawn, read_json<DrawnEpisode>(line, file_.string()));
    before_[drawn.number] = std::move(drawn);
  }
  return {};
}

Result<std::unique_ptr<EpisodeJournal>> EpisodeJournal::begin(const std::filesystem::path& file,
                                                              const std::string& draw,
                                                              bool resume) {
  std::unique_ptr<EpisodeJournal> journal(new EpisodeJournal);
  journal->file_ = file;
  if (resume) MARKETGEN_CHECK(journal->read(draw));
  std::string text = write_json_line(JournalHead{.draw = draw}) + "\n";
  for (const auto& [number, drawn] : journal->before_)
    text += write_json_line(drawn) + "\n";
  MARKETGEN_CHECK(write_file(file, text));
  journal->lines_.open(file, std::ios::app);
  journal->count_ = journal->before_.size();
  return journal;
}

std::size_t EpisodeJournal::count() const {
  const std::scoped_lock lock(mutex_);
  return count_;
}

Result<void> EpisodeJournal::keep(DrawnEpisode drawn) {
  const std::scoped_lock lock(mutex_);
  lines_ << write_json_line(drawn) << "\n" << std::flush;
  if (!lines_)
    return Error{"io.cannot_write", file_.string(), "cannot be written: is the disk full?"};
  ++count_;
  return {};
}

void EpisodeJournal::remove() {
  const std::scoped_lock lock(mutex_);
  lines_.close();
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

}  // namespace marketgen
