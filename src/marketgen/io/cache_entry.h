// What is kept between runs under cache_folder(): one file an entry, each with a checksum.
//
// A file is its content, as whatever kind of file that is (SQLite's own programs open a database of
// ours), and a trailer: the kind of the entry, its version in it, and a checksum over both.
// Whatever is cut off, changed, of another kind or version, larger than it may be, no file or
// cannot be read is as if it were not there: it is named on standard error, once, and taken away,
// so that whoever asks makes it anew. Files are put in place whole; any number of processes may
// share the folder.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace marketgen::io {

// The content of the entry; nothing when there is none that can be used. `kind`: "grasps/2".
std::optional<std::string> kept_entry(const std::filesystem::path& file, std::string_view kind);

// Takes away an entry that cannot be used although it is whole, and says so; it is made anew.
void drop_entry(const std::filesystem::path& file, std::string_view why);

// Puts the content in place of what was there. Error: io.cannot_write, which costs time only: it
// has been said, once for each folder.
Result<void> keep_entry(const std::filesystem::path& file,
                        std::string_view kind,
                        std::string_view content);

}  // namespace marketgen::io
