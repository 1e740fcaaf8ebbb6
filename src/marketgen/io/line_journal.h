// What long work has finished, a line a piece, beside the file that it will become: when the work
// is broken off, that need not be done again.
#pragma once
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace marketgen::io {

// Any number of threads may keep lines at once.
class LineJournal {
 public:
  // Where the journal of an output lies: OUTPUT.unfinished; none when the output is a device, a
  // pipe or an open descriptor. Errors: those of followed().
  static Result<std::optional<std::filesystem::path>> place_beside(
      const std::filesystem::path& output);

  // `work`: a hash of everything that decides the lines. Goes on with the file when there is one
  // and `resume` says so, else begins anew. Errors: usage.bad_flag when the file is of other work;
  // io.*; json.* when it is no journal.
  static Result<std::unique_ptr<LineJournal>> begin(const std::filesystem::path& file,
                                                    const std::string& work,
                                                    bool resume);

  // Those that were there when it began.
  const std::vector<std::string>& before() const { return before_; }
  std::size_t count() const;  // of those that are there now
  // `line`: without its end. Errors: io.cannot_write.
  Result<void> keep(const std::string& line);
  // The lines have come to their own place, or never will: takes the file away.
  void remove();
  const std::filesystem::path& file() const { return file_; }

 private:
  LineJournal() = default;
  Result<void> read(const std::string& work);

  std::filesystem::path file_;
  std::vector<std::string> before_;
  mutable std::mutex mutex_;
  std::ofstream lines_;
  std::size_t count_ = 0;
};

// Of work that was broken off: the error internal.interrupted at `output`, with how many of `all`
// its `pieces` ("heaps") are kept and how to go on.
Error interrupted_with(const LineJournal& journal,
                       const std::string& output,
                       std::size_t all,
                       std::string_view pieces);

}  // namespace marketgen::io
