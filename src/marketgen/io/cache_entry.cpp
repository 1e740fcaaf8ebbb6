#include "io/cache_entry.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <set>

#include <fmt/format.h>

#include "base/hash.h"
#include "base/progress.h"
#include "io/destination.h"
#include "io/file.h"
#include "io/part_name.h"

namespace marketgen::io {
namespace {

namespace fs = std::filesystem;

constexpr std::array<char, 8> entry_mark{'M', 'G', 'C', 'A', 'C', 'H', 'E', '1'};
constexpr std::uint64_t max_entry_bytes = 1U << 30;

struct EntryTrailer {
  std::uint64_t kind = 0, checksum = 0;  // of the content, with the kind as its seed
  std::array<char, 8> mark = entry_mark;
};

EntryTrailer trailer_of(std::string_view kind, std::string_view content) {
  const std::uint64_t number = hash64(kind);
  return {number, hash64(content, number)};
}

// Whether a remark is made for the first time.
bool is_first(const std::string& remark) {
  static std::mutex mutex;
  static std::set<std::string> made;
  const std::scoped_lock lock(mutex);
  return made.insert(remark).second;
}

// What is wrong with the bytes of a file; empty: nothing.
std::string fault_of(std::string_view bytes, std::string_view kind) {
  EntryTrailer trailer;
  if (bytes.size() < sizeof(trailer)) return "is cut off";
  const std::string_view content = bytes.substr(0, bytes.size() - sizeof(trailer));
  std::memcpy(&trailer, bytes.data() + content.size(), sizeof(trailer));
  if (trailer.mark != entry_mark) return "is cut off, or of another version";
  if (hash64(content, trailer.kind) != trailer.checksum) return "was changed";
  if (trailer.kind != hash64(kind)) return "is of another version";
  return {};
}

// Not made to last: what is lost is made anew.
Result<void> put_entry(const fs::path& file, std::string_view bytes) {
  const fs::path folder = file.parent_path();
  std::error_code failed;
  fs::create_directories(folder, failed);
  sweep_parts_once(folder);
  const fs::path part = part_in(folder, file.filename().string());
  MARKETGEN_CHECK(write_new(part, bytes, Durable::no, file));
  if (rename(part.c_str(), file.c_str()) == 0) return {};
  const int fault = errno;
  fs::remove(part, failed);
  return cannot_write(file, "cannot be put in place", fault);
}

}  // namespace

std::optional<std::string> kept_entry(const fs::path& file, std::string_view kind) {
  std::error_code failed;
  const fs::file_status status = fs::symlink_status(file, failed);
  if (!fs::exists(status)) return std::nullopt;
  if (!fs::is_regular_file(status)) {
    drop_entry(file, "is no file");
    return std::nullopt;
  }
  Result<std::string> bytes = read_file(file, max_entry_bytes);
  if (!bytes.ok()) {
    if (bytes.error().code != "input.not_found") drop_entry(file, bytes.error().message);
    return std::nullopt;  // another process took it away
  }
  if (const std::string fault = fault_of(*bytes, kind); !fault.empty()) {
    drop_entry(file, fault);
    return std::nullopt;
  }
  bytes->resize(bytes->size() - sizeof(EntryTrailer));
  return *std::move(bytes);
}

void drop_entry(const fs::path& file, std::string_view why) {
  std::error_code failed;
  fs::remove(file, failed);  // of a folder only when it is empty: what is in it is nothing of ours
  const std::string remark = fmt::format("{} {}: it is made anew", file.string(), why);
  if (is_first(remark)) log_warning(remark);
}

Result<void> keep_entry(const fs::path& file, std::string_view kind, std::string_view content) {
  const EntryTrailer trailer = trailer_of(kind, content);
  std::string bytes(content);
  bytes.append(reinterpret_cast<const char*>(&trailer), sizeof(trailer));
  const Result<void> written = put_entry(file, bytes);
  if (written.ok()) return {};
  const std::string remark = fmt::format("{} cannot be written ({}): what is made is not kept",
                                         file.parent_path().string(),
                                         written.error().message);
  if (is_first(file.parent_path().string())) log_warning(remark);
  return written;
}

}  // namespace marketgen::io
