// The one gate for outputs: what a command will write is named and probed before any work, and put
// in place together at the end.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "io/destination.h"

namespace marketgen::io {

class Outputs {
 public:
  using Writer = std::function<Result<void>(const std::filesystem::path&)>;

  Outputs() = default;
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;
  // Removes what was not committed, and the folders that were made for it.
  ~Outputs();

  // Files that will be written, each with the flag that names it; those without a path were not
  // asked for. Folders above them that are missing are made. Errors: usage.bad_flag when two flags
  // name the same file; those of destination_of().
  Result<void> add(const std::vector<std::pair<std::string, std::filesystem::path>>& files);
  // A folder for outputs, which may have others already; made when it is missing. Files in it that
  // are written by put() are part of the same commit. Errors: as destination_of().
  Result<void> add_folder(const std::filesystem::path& folder);

  // Has `write` write one of the files, beside its place; devices and pipes at once. Files in added
  // folders need not be added.
  Result<void> put(const std::filesystem::path& file, const Writer& write);
  Result<void> put(const std::filesystem::path& file, std::string_view bytes);

  // Puts all in place, or none: when one cannot be, the old ones come back. Errors:
  // io.cannot_write.
  Result<void> commit();

 private:
  struct Draft {
    Destination to;
    std::filesystem::path part;  // empty until it is written
    bool on_disk = false;        // its bytes are
    bool swapped = false;        // `part` holds the old file
  };
  Result<Draft*> draft_of(const std::filesystem::path& file);
  static void begin_part(Draft& draft);
  Result<void> carry_all_through();
  Result<void> put_in_place(Draft& draft);
  static void take_back(Draft& draft);

  void add_draft(Destination to);

  std::vector<Draft> drafts_;
  std::map<std::filesystem::path, std::size_t> by_shown_;  // where in drafts_; the first of a name
  MadeFolders made_;
};

}  // namespace marketgen::io
