#include "catalog/kept_file.h"

#include <algorithm>

#include <fmt/format.h>

#include "io/cache_entry.h"
#include "io/file.h"

namespace marketgen::catalog {
namespace fs = std::filesystem;
namespace {

bool is_content_name(const KeptKind& kind, std::string_view name) {
  constexpr std::size_t digits = 64;  // SHA-256
  return name.size() > digits && std::ranges::count(kind.endings, name.substr(digits)) > 0 &&
         name.substr(0, digits).find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

Result<fs::path> kept_file(const KeptName& name, const fs::path& folder) {
  if (is_content_name(*name.kind, name.name)) return folder / name.kind->folder / name.name;
  return Error{std::string(name.kind->fault),
               name.where,
               fmt::format("is not the name of a kept {}; load the catalogue that the product "
                           "comes from",
                           name.kind->what)};
}

std::string content_name(std::string_view bytes, std::string_view ending) {
  return io::sha256_hex(bytes).append(ending);
}

Result<void> write_into(const fs::path& file, std::string_view bytes) {
  std::error_code failed;
  fs::create_directories(file.parent_path(), failed);
  if (failed) return Error{"io.cannot_write", file.parent_path().string(), failed.message()};
  return io::write_file(file, bytes);
}

// Whether the file is there and is what its name says; one that is not is taken away.
bool holds(const fs::path& file) {
  std::error_code failed;
  const fs::file_status status = fs::symlink_status(file, failed);
  if (!fs::exists(status)) return false;
  if (fs::is_regular_file(status)) {
    const auto digest = io::sha256_of_file(file);
    if (digest.ok() && *digest + file.extension().string() == file.filename()) return true;
  }
  io::drop_entry(file, "was changed");
  return false;
}

// Copies what `from` has and `to` lacks.
Result<void> copy_kept(const KeptName& name, const fs::path& from, const fs::path& to) {
  MARKETGEN_TRY(const fs::path source, kept_file(name, from));
  MARKETGEN_TRY(const fs::path target, kept_file(name, to));
  if (holds(target)) return {};
  MARKETGEN_TRY(const std::string bytes, io::read_file(source, name.kind->max_bytes));
  if (content_name(bytes, source.extension().string()) != name.name)
    return Error{std::string(name.kind->fault),
                 source.string(),
                 "was changed after it was made; restore it"};
  return write_into(target, bytes);
}

}  // namespace

Result<std::string> keep_bytes(const KeptKind& kind,
                               std::string_view bytes,
                               std::string_view ending) {
  std::string name = content_name(bytes, ending);
  const fs::path file = io::cache_folder() / kind.folder / name;
  if (!holds(file)) MARKETGEN_CHECK(write_into(file, bytes));
  return name;
}

bool is_kept(const KeptName& name) {
  const Result<fs::path> file = kept_file(name, io::cache_folder());
  return file.ok() && holds(*file);
}

bool is_saved(const KeptName& name, const fs::path& store) {
  const Result<fs::path> file = kept_file(name, store);
  std::error_code failed;
  return file.ok() && fs::is_regular_file(*file, failed);
}

Result<std::string> kept_bytes(const KeptName& name) {
  MARKETGEN_TRY(const fs::path file, kept_file(name, io::cache_folder()));
  Result<std::string> bytes = io::read_file(file, name.kind->max_bytes);
  const bool whole = bytes.ok() && content_name(*bytes, file.extension().string()) == name.name;
  if (whole) return bytes;
  if (bytes.ok()) io::drop_entry(file, "was changed");
  return Error{bytes.ok() ? "input.not_found" : bytes.error().code,
               name.where,
               fmt::format("its {} {} cannot be read; open its store, or load its catalogue, again",
                           name.kind->what,
                           file.string())};
}

Result<void> save_kept(const KeptName& name, const fs::path& store) {
  return copy_kept(name, io::cache_folder(), store);
}

Result<void> restore_kept(const KeptName& name, const fs::path& store) {
  return copy_kept(name, store, io::cache_folder());
}

}  // namespace marketgen::catalog
