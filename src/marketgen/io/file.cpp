#include "io/file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <random>

#include <fmt/format.h>
#include <openssl/evp.h>

#include "base/text.h"
#include "io/installation.h"

namespace marketgen {
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
  bool close_now() { return close(std::exchange(fd_, -1)) == 0; }

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

// A name beside `path` that no other process uses.
fs::path beside(const fs::path& path) {
  fs::path clean = path;
  if (!clean.has_filename()) clean = clean.parent_path();
  static thread_local std::random_device random;  // names only: nothing that is kept depends on it
  return clean.parent_path() /
         fmt::format(".{}.{}-{:08x}.part", clean.filename().string(), getpid(), random());
}

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(fd, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      return false;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
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
  const fs::path part = beside(path);
  {
    Descriptor file(open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
    if (file.get() < 0) return cannot("io.cannot_write", path, "cannot be written");
    if (!write_all(file.get(), bytes) || !file.close_now()) {
      const Error error = cannot("io.cannot_write", path, "cannot be written");
      unlink(part.c_str());
      return error;
    }
  }
  if (rename(part.c_str(), path.c_str()) != 0) {
    const Error error = cannot("io.cannot_write", path, "cannot be replaced");
    unlink(part.c_str());
    return error;
  }
  return {};
}

FolderDraft::FolderDraft(fs::path target) : target_(std::move(target)) {}
FolderDraft::FolderDraft(FolderDraft&& other) noexcept
    : target_(std::move(other.target_)),
      draft_(std::exchange(other.draft_, {})),
      parents_(std::exchange(other.parents_, {})) {}

FolderDraft::~FolderDraft() {
  std::error_code ignored;
  if (!draft_.empty()) fs::remove_all(draft_, ignored);
  for (; !parents_.empty(); parents_.pop_back())
    fs::remove(parents_.back(), ignored);  // only when it is empty
}

Result<FolderDraft> FolderDraft::begin(const fs::path& path) {
  std::error_code failed;
  fs::path target = fs::absolute(path, failed).lexically_normal();
  if (!target.has_filename()) target = target.parent_path();
  if (fs::exists(target, failed) &&
      !(fs::is_directory(target, failed) && fs::is_empty(target, failed))) {
    return Error{"store.exists", path.string(), "exists already; name another folder or remove it"};
  }
  FolderDraft draft(std::move(target));
  MARKETGEN_CHECK(draft.make(path.string()));
  return draft;
}

void FolderDraft::make_parents(std::error_code& failed) {
  std::vector<fs::path> missing;
  fs::path parent = target_.parent_path();
  for (; !fs::exists(parent, failed) && !failed; parent = parent.parent_path())
    missing.push_back(parent);
  for (; !missing.empty() && !failed; missing.pop_back()) {
    if (fs::create_directory(missing.back(), failed)) parents_.push_back(missing.back());
  }
}

Result<void> FolderDraft::make(const std::string& shown) {
  std::error_code failed;
  make_parents(failed);
  if (failed)
    return Error{"io.cannot_write", shown, "its parent folder cannot be made: " + failed.message()};
  const fs::path draft = beside(target_);
  fs::create_directory(draft, failed);
  if (failed) return Error{"io.cannot_write", shown, "cannot be made: " + failed.message()};
  draft_ = draft;
  return {};
}

Result<void> FolderDraft::commit() {
  std::error_code failed;
  if (fs::exists(target_, failed))
    fs::remove(target_, failed);  // an empty folder; fails when it is not
  fs::rename(draft_, target_, failed);
  if (failed)
    return Error{
        "io.cannot_write", target_.string(), "cannot be put in place: " + failed.message()};
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

}  // namespace marketgen
