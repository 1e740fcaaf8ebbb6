// Where one output goes: parsed and probed before any work is done for it.
//
// A path that a person names may be an ordinary file, a link to one, a device, a pipe, an open
// descriptor (/dev/stdout, /dev/fd/63) or a file that is mounted. Ordinary files are replaced
// whole: written beside and renamed, with the mode that the old one had, or by the umask; a link
// keeps pointing at its file. All others are written to as they are.
#pragma once
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace marketgen::io {

// Folders on the way to outputs. Those that were made for them are removed again, as far as they
// are empty, unless they are kept.
class MadeFolders {
 public:
  MadeFolders() = default;
  MadeFolders(MadeFolders&& other) noexcept : made_(std::exchange(other.made_, {})) {}
  MadeFolders& operator=(MadeFolders&& other) noexcept;
  ~MadeFolders() { remove(); }
  // `folder` and all that is missing above it. 0, or the errno of what could not be made.
  int make(const std::filesystem::path& folder);
  // 0 when a file can be made in the folder of `target`, else the errno of trying. Where one could
  // be made it is not tried again.
  int probe(const std::filesystem::path& target);
  void keep() { made_.clear(); }
  std::vector<std::filesystem::path> release() { return std::exchange(made_, {}); }

 private:
  void remove();
  std::vector<std::filesystem::path> made_;  // topmost first
  std::set<std::filesystem::path> probed_;
};

enum class Reach {
  replaced,    // an ordinary file, or none yet: written beside, then renamed
  in_place,    // a file that is mounted or in a folder that cannot be written: overwritten
  streamed,    // a device or pipe: written to
  descriptor,  // one that this process has open: written to
};

struct Destination {
  std::filesystem::path shown;   // as it was named
  std::filesystem::path target;  // absolute, links followed
  Reach reach = Reach::replaced;
  int descriptor = -1;
  std::optional<mode_t> mode;  // of the file that is replaced
};

// `path` with the links in its last part followed: absolute. Errors: usage.bad_flag for none at
// all; io.cannot_write when the working folder is gone or links lead in a circle.
Result<std::filesystem::path> followed(const std::filesystem::path& path);

// Whether what followed() gave stands for a descriptor that this process has open: it may be a
// file, but has no place to put another beside it.
bool is_own_descriptor(const std::filesystem::path& followed);

// Parses and probes `path`; folders above it that are missing are made, and given to `made`.
// Errors: as followed(); io.cannot_write for what is a folder, write-protected, or in a folder in
// which nothing can be made.
Result<Destination> destination_of(const std::filesystem::path& path, MadeFolders& made);

// Whether a file is on the disk when its writer returns; on the way there, for carry_through(), so
// that many are written side by side; or when the system sees fit: what can be made anew does not
// wait.
enum class Durable { no, begun, yes };

// Puts the bytes there. Errors: io.cannot_write, also when the disk is full or the reader gone.
Result<void> write_to(const Destination& destination,
                      std::string_view bytes,
                      Durable durable = Durable::yes);

// Makes a file that must not be there yet and writes it. On an error nothing is left, and it is at
// `shown`.
Result<void> write_new(const std::filesystem::path& file,
                       std::string_view bytes,
                       Durable durable,
                       const std::filesystem::path& shown);

// Waits until what was written to `file` is on the disk. Error: io.cannot_write at `shown`.
Result<void> carry_through(const std::filesystem::path& file, const std::filesystem::path& shown);

// io.cannot_write at `path`: what failed, why by errno, and what to do about it.
Error cannot_write(const std::filesystem::path& path, std::string_view what, int number);

}  // namespace marketgen::io
