// Files: whole-file reads with a size limit, atomic writes (beside, then renamed), folders made
// whole or not at all.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/result.h"

namespace marketgen::io {

// The file's bytes. Errors: input.not_found, input.too_large, io.cannot_read.
Result<std::string> read_file(const std::filesystem::path& path,
                              std::uint64_t max_bytes = 256U << 20);

// Writes beside `path` and renames, so that a reader sees the old file or the new one, never half.
// How it treats links, devices, modes and missing folders: io/destination.h.
Result<void> write_file(const std::filesystem::path& path, std::string_view bytes);

// A folder under construction: files go to a hidden sibling, `commit` renames it to `path`; without
// commit it is removed, and so are parent folders that were made for it.
class FolderDraft {
 public:
  // Errors: store.exists when `path` exists and is not an empty folder; io.cannot_write.
  static Result<FolderDraft> begin(const std::filesystem::path& path);
  FolderDraft(FolderDraft&&) noexcept;
  FolderDraft& operator=(FolderDraft&&) = delete;
  ~FolderDraft();

  const std::filesystem::path& folder() const { return draft_; }
  Result<void> commit();

 private:
  explicit FolderDraft(std::filesystem::path target);
  Result<void> make(const std::string& shown);
  void make_parents(std::error_code& failed);

  std::filesystem::path target_, draft_;
  std::vector<std::filesystem::path> parents_;  // made on the way to the target, topmost first
};

// A file mapped read-only into memory.
class MappedFile {
 public:
  static Result<MappedFile> open(const std::filesystem::path& path);
  MappedFile(MappedFile&&) noexcept;
  MappedFile& operator=(MappedFile&&) = delete;
  ~MappedFile();
  std::span<const std::byte> bytes() const { return bytes_; }

 private:
  explicit MappedFile(std::span<const std::byte> bytes) : bytes_(bytes) {}
  std::span<const std::byte> bytes_;
};

std::string sha256_hex(std::string_view bytes);  // FIPS 180-4, by OpenSSL
Result<std::string> sha256_of_file(const std::filesystem::path& path);

// $MARKETGEN_CACHE, else $XDG_CACHE_HOME/marketgen, else ~/.cache/marketgen. Made on first write by
// those who use it.
std::filesystem::path cache_folder();
// Where the data rows are: $MARKETGEN_DATA, beside the program, the installation, or the source
// tree. Error: catalog.missing_data.
Result<std::filesystem::path> data_folder();

}  // namespace marketgen::io
