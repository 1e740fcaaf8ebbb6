// Episodes as they are drawn, in a journal (io/line_journal.h) beside the file that they will
// become.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "episodes/episode_spec.h"
#include "io/line_journal.h"

namespace marketgen::episodes {

// A product that was looked at while an episode was drawn: why no task asks for it, or nothing.
struct ConsideredProduct {
  std::string sku, why;
  static constexpr auto fields =
      field_list(field("sku", &ConsideredProduct::sku, "product", identifier()),
                 field("why", &ConsideredProduct::why, "why it is left out; empty: it is not"));
};

struct DrawnEpisode {
  int number = 0;
  EpisodeSpec episode;
  std::vector<ConsideredProduct> considered;
  static constexpr auto fields =
      field_list(field("number", &DrawnEpisode::number, "in its file, from 0", range(0, 1e6)),
                 field("episode", &DrawnEpisode::episode, "as it will stand there", required()),
                 field("considered", &DrawnEpisode::considered, "so far, in its store"));
};

// Any number of threads may keep episodes at once.
class EpisodeJournal {
 public:
  // As LineJournal::begin. Errors: its own; those of read_json.
  static Result<std::unique_ptr<EpisodeJournal>> begin(const std::filesystem::path& file,
                                                       const std::string& draw,
                                                       bool resume);

  // By number: those that were there when it began.
  const std::map<int, DrawnEpisode>& before() const { return before_; }
  // Errors: io.cannot_write.
  Result<void> keep(const DrawnEpisode& drawn);
  io::LineJournal& lines() { return *lines_; }

 private:
  EpisodeJournal() = default;

  std::unique_ptr<io::LineJournal> lines_;
  std::map<int, DrawnEpisode> before_;
};

}  // namespace marketgen::episodes
