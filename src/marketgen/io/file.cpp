#include "io/file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>
#include <openssl/evp.h>

#include "base/interrupt.h"
#include "base/text.h"
#include "io/destination.h"
#include "io/installation.h"
#include "io/part_name.h"

namespace marketgen::io {
namespace fs = std::filesystem;
namespace {

// Closes a file descriptor when it goes.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }

 private:
  int fd_;
};

Error cannot(std::string code, const fs::path& path, std::string_view what) {
  return {std::move(code), path.string(), fmt::format("{}: {}", what, std::strerror(errno))};
}

Error larger_than(std::uint64_t max_bytes, const fs::path& path) {
  return {
      "input.too_large",
      path.string(),
      fmt::format("is larger than {} bytes", with_thousands(static_cast<std::int64_t>(max_bytes)))};
}

Error cannot_open(const fs::path& path) {
  if (errno == ENOENT || errno == ENOTDIR)
    return {"input.not_found", path.string(), "there is no such file"};
  return cannot("io.cannot_read", path, "cannot be opened");
}

// Where what becomes `target` is written: beside it; inside a folder that is there already, which
// keeps its mode, its mount and whoever works in it.
fs::path draft_of(const fs::path& target) {
  std::error_code failed;
  const bool there = fs::is_directory(target, failed);
  return part_in(there ? target : target.parent_path(), target.filename().string());
}

// Everything in `draft` into `folder`, the manifest last: a folder without it is no store.
Result<void> move_up(const fs::path& draft, const fs::path& folder) {
  constexpr std::string_view manifest = "store.json";
  std::vector<fs::path> names;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(draft, failed))
    names.push_back(entry.path().filename());
  std::ranges::sort(
      names, {}, [&](const fs::path& name) { return std::pair(name == manifest, name.string()); });
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (rename((draft / names[i]).c_str(), (folder / names[i]).c_str()) == 0) continue;
    const int fault = errno;
    for (std::size_t k = 0; k < i; ++k)
      fs::rename(folder / names[k], draft / names[k], failed);
    return cannot_write(folder, "cannot be put in place", fault);
  }
  fs::remove(draft, failed);
  return {};
}

}  // namespace

Result<std::string> read_file(const fs::path& path, std::uint64_t max_bytes) {
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) return cannot_open(path);
  struct stat info {};
  if (fstat(file.get(), &info) != 0) return cannot("io.cannot_read", path, "cannot be examined");
  if (S_ISDIR(info.st_mode))
    return Error{"io.cannot_read", path.string(), "is a folder; a file was expected"};
  if (S_ISREG(info.st_mode) && static_cast<std::uint64_t>(info.st_size) > max_bytes)
    return larger_than(max_bytes, path);
  std::string bytes;
  char block[1 << 16];
  while (true) {  // not by st_size: pipes have none
    const ssize_t got = read(file.get(), block, sizeof block);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return cannot("io.cannot_read", path, "cannot be read");
    if (got == 0) return bytes;
    bytes.append(block, static_cast<std::size_t>(got));
    if (bytes.size() > max_bytes) return larger_than(max_bytes, path);
  }
}

Result<void> write_file(const fs::path& path, std::string_view bytes) {
  MadeFolders made;
  MARKETGEN_TRY(const Destination to, destination_of(path, made));
  MARKETGEN_CHECK(write_to(to, bytes));
  made.keep();
  return {};
}

FolderDraft::FolderDraft(fs::path target) : target_(std::move(target)) {}
FolderDraft::FolderDraft(FolderDraft&& other) noexcept
    : target_(std::move(other.target_)),
      draft_(std::exchange(other.draft_, {})),
      parents_(std::exchange(other.parents_, {})) {}

FolderDraft::~FolderDraft() {
  std::error_code ignored;
  if (!draft_.empty()) {
    fs::remove_all(draft_, ignored);
    drop_leftover(draft_);
  }
  for (; !parents_.empty(); parents_.pop_back())
    fs::remove(parents_.back(), ignored);  // only when it is empty
}

Result<FolderDraft> FolderDraft::begin(const fs::path& path) {
  MARKETGEN_TRY(fs::path target, followed(path));
  target = target.lexically_normal();
  if (!target.has_filename()) target = target.parent_path();
  std::error_code failed;
  if (fs::is_directory(target, failed)) sweep_parts(target);
  if (fs::exists(target, failed) &&
      !(fs::is_directory(target, failed) && fs::is_empty(target, failed))) {
    return Error{"store.exists", path.string(), "exists already; name another folder or remove it"};
  }
  FolderDraft draft(std::move(target));
  MARKETGEN_CHECK(draft.make(path.string()));
  return draft;
}

void FolderDraft::make_parents(std::error_code& failed) {
  MadeFolders made;
  failed.assign(made.make(target_.parent_path()), std::generic_category());
  parents_ = made.release();
}

Result<void> FolderDraft::make(const std::string& shown) {
  std::error_code failed;
  make_parents(failed);
  if (failed) return cannot_write(shown, "its parent folder cannot be made", failed.value());
  sweep_parts_once(target_.parent_path());
  const fs::path draft = draft_of(target_);
  if (mkdir(draft.c_str(), 0777) != 0) return cannot_write(shown, "cannot be made", errno);
  add_leftover(draft);
  draft_ = draft;
  return {};
}

Result<void> FolderDraft::commit() {
  const NoForcedEnd together;
  if (draft_.parent_path() == target_) {
    MARKETGEN_CHECK(move_up(draft_, target_));
  } else if (rename(draft_.c_str(), target_.c_str()) != 0) {
    return cannot_write(target_, "cannot be put in place", errno);
  }
  drop_leftover(draft_);
  draft_.clear();
  parents_.clear();
  return {};
}

MappedFile::MappedFile(MappedFile&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
}

Result<MappedFile> MappedFile::open(const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) return cannot_open(path);
  struct stat info {};
  if (fstat(file.get(), &info) != 0) return cannot("io.cannot_read", path, "cannot be examined");
  if (!S_ISREG(info.st_mode))
    return Error{"io.cannot_read", path.string(), "is not a regular file"};
  const auto size = static_cast<std::size_t>(info.st_size);
  if (size == 0) return MappedFile({});
  void* start = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.get(), 0);
  if (start == MAP_FAILED) return cannot("io.cannot_read", path, "cannot be mapped");
  return MappedFile({static_cast<const std::byte*>(start), size});
}

std::string sha256_hex(std::string_view bytes) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned length = 0;
  EVP_Digest(bytes.data(), bytes.size(), digest, &length, EVP_sha256(), nullptr);
  std::string hex;
  for (unsigned i = 0; i < length; ++i)
    hex += fmt::format("{:02x}", digest[i]);
  return hex;
}

Result<std::string> sha256_of_file(const fs::path& path) {
  MARKETGEN_TRY(const MappedFile file, MappedFile::open(path));
  return sha256_hex({reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size()});
}

fs::path cache_folder() {
  if (const char* named = std::getenv("MARKETGEN_CACHE"); named != nullptr && *named != '\0')
    return named;
  if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg != nullptr && *xdg != '\0')
    return fs::path(xdg) / "marketgen";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return fs::path(home) / ".cache/marketgen";
  return fs::temp_directory_path() / "marketgen-cache";
}

Result<fs::path> data_folder() {
  std::vector<fs::path> places;
  if (const char* named = std::getenv("MARKETGEN_DATA"); named != nullptr && *named != '\0') {
    places.emplace_back(named);
  } else {
    places = share_folders();
    for (fs::path& place : places)
      place /= "data";
  }
  for (const fs::path& place : places) {
    std::error_code failed;
    if (fs::exists(place / "categories.json", failed)) return place.lexically_normal();
  }
  return Error{
      "catalog.missing_data",
      places.front().string(),
      "the data rows are not there; set MARKETGEN_DATA to the data folder of the installation"};
}

}  // namespace marketgen::io
