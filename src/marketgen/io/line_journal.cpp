#include "io/line_journal.h"

#include <sstream>

#include <fmt/format.h>

#include "base/interrupt.h"
#include "io/destination.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::io {
namespace {

struct JournalHead {
  std::string schema = "market-drawing/1", draw;
  static constexpr auto fields =
      field_list(field("schema", &JournalHead::schema, "schema tag", constant("market-drawing/1")),
                 field("draw", &JournalHead::draw, "what decides the lines", required()));
};

}  // namespace

Result<std::optional<std::filesystem::path>> LineJournal::place_beside(
    const std::filesystem::path& output) {
  MARKETGEN_TRY(std::filesystem::path file, followed(output));
  if (is_own_descriptor(file)) return std::optional<std::filesystem::path>();
  std::error_code failed;
  if (std::filesystem::exists(file, failed) && !std::filesystem::is_regular_file(file, failed))
    return std::optional<std::filesystem::path>();
  file += ".unfinished";
  return std::optional(std::move(file));
}

// Only whole lines: the last one may have been cut off with the process.
Result<void> LineJournal::read(const std::string& work) {
  std::error_code failed;
  if (!std::filesystem::exists(file_, failed)) return {};
  MARKETGEN_TRY(const std::string text, read_file(file_));
  std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
  std::string line;
  if (!std::getline(lines, line)) return {};
  MARKETGEN_TRY(const JournalHead head, read_json<JournalHead>(line, file_.string()));
  if (head.draw != work)
    return Error{"usage.bad_flag",
                 "--resume",
                 fmt::format("{} is of other inputs, other flags or another version: go on as it "
                             "was begun, or leave the flag out",
                             file_.string())};
  while (std::getline(lines, line))
    before_.push_back(line);
  return {};
}

Result<std::unique_ptr<LineJournal>> LineJournal::begin(const std::filesystem::path& file,
                                                        const std::string& work,
                                                        bool resume) {
  std::unique_ptr<LineJournal> journal(new LineJournal);
  journal->file_ = file;
  if (resume) MARKETGEN_CHECK(journal->read(work));
  std::string text = write_json_line(JournalHead{.draw = work}) + "\n";
  for (const std::string& line : journal->before_)
    text += line + "\n";
  MARKETGEN_CHECK(write_file(file, text));
  journal->lines_.open(file, std::ios::app);
  journal->count_ = journal->before_.size();
  return journal;
}

std::size_t LineJournal::count() const {
  const std::scoped_lock lock(mutex_);
  return count_;
}

Result<void> LineJournal::keep(const std::string& line) {
  const std::scoped_lock lock(mutex_);
  lines_ << line << "\n" << std::flush;
  if (!lines_)
    return Error{"io.cannot_write", file_.string(), "cannot be written: is the disk full?"};
  ++count_;
  return {};
}

void LineJournal::remove() {
  const std::scoped_lock lock(mutex_);
  lines_.close();
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

Error interrupted_with(const LineJournal& journal,
                       const std::string& output,
                       std::size_t all,
                       std::string_view pieces) {
  return {interrupted_error().code,
          output,
          fmt::format("interrupted; {} of {} {} are kept in {}: go on with --resume",
                      journal.count(),
                      all,
                      pieces,
                      journal.file().string())};
}

}  // namespace marketgen::io
