// Episodes as they are drawn, a line each, beside the file that they will become: what was finished
// when a draw was broken off need not be drawn again.
#pragma once
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "episodes/episode_spec.h"

namespace marketgen {

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
  // `draw`: a hash of everything that decides the episodes. Goes on with the file when there is one
  // and `resume` says so, else begins anew. Errors: usage.bad_flag when the file is of another
  // draw; io.*; those of read_json.
  static Result<std::unique_ptr<EpisodeJournal>> begin(const std::filesystem::path& file,
                                                       const std::string& draw,
                                                       bool resume);

  // By number: those that were there when it began.
  const std::map<int, DrawnEpisode>& before() const { return before_; }
  std::size_t count() const;  // those that are there now
  // Errors: io.cannot_write.
  Result<void> keep(DrawnEpisode drawn);
  // The episodes have come to their own place, or never will: takes the file away.
  void remove();
  const std::filesystem::path& file() const { return file_; }

 private:
  EpisodeJournal() = default;
  Result<void> read(const std::string& draw);

  std::filesystem::path file_;
  std::map<int, DrawnEpisode> before_;
  mutable std::mutex mutex_;
  std::ofstream lines_;
  std::size_t count_ = 0;
};

}  // namespace marketgen
