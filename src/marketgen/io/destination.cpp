#include "io/destination.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>

#include <fmt/format.h>

#include "base/interrupt.h"
#include "io/part_name.h"

namespace marketgen::io {
namespace fs = std::filesystem;
namespace {

constexpr int max_links = 40;  // as Linux follows

// Closes a file descriptor when it goes.
class OpenFile {
 public:
  explicit OpenFile(int fd) : fd_(fd) {}
  ~OpenFile() {
    if (fd_ >= 0) close(fd_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int get() const { return fd_; }
  bool close_now() { return close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

const char* remedy_for(int number) {
  switch (number) {
    case ENOSPC:
    case EDQUOT:
      return "; make room, or name a place on another disk";
    case EACCES:
    case EPERM:
    case EROFS:
      return "; name a place that may be written";
    case ENAMETOOLONG:
      return "; name it shorter";
    case EFBIG:
      return "; raise the limit on file sizes (ulimit -f)";
    default:
      return "";
  }
}

// /proc/N/fd: the names in it are open descriptors, not links to files.
bool holds_descriptors(const fs::path& folder) {
  const std::string text = folder.string();
  return text.starts_with("/proc/") && text.ends_with("/fd");
}

Result<fs::path> absolute_path(const fs::path& path) {
  if (path.empty() || path.native().find('\0') != std::string::npos)
    return Error{"usage.bad_flag",
                 path.string(),
                 "is no name for an output; name a file or folder to write"};
  if (path.is_absolute()) return path;
  std::error_code failed;
  const fs::path here = fs::current_path(failed);
  if (failed || !fs::exists(here, failed))
    return Error{"io.cannot_write",
                 path.string(),
                 "the working folder is gone; change to one that exists, or name a whole path"};
  return here / path;
}

// The last part's link, if it is one that can be followed.
std::optional<fs::path> next_link(const fs::path& path) {
  std::error_code failed;
  if (!fs::is_symlink(fs::symlink_status(path, failed)) || failed) return std::nullopt;
  if (holds_descriptors(fs::canonical(path.parent_path(), failed))) return std::nullopt;
  const fs::path link = fs::read_symlink(path, failed);
  if (failed) return std::nullopt;
  return path.parent_path() / link;
}

// The number of a descriptor of ours that `target` stands for, or -1.
int own_descriptor(const fs::path& target) {
  std::error_code failed;
  if (fs::canonical(target.parent_path(), failed) != fs::path(fmt::format("/proc/{}/fd", getpid())))
    return -1;
  const std::string name = target.filename().string();
  int number = -1;
  const auto [end, bad] = std::from_chars(name.data(), name.data() + name.size(), number);
  return bad == std::errc() && end == name.data() + name.size() ? number : -1;
}

bool is_mounted(const fs::path& target) {
  struct statx info {};
  return statx(AT_FDCWD, target.c_str(), 0, STATX_TYPE, &info) == 0 &&
         (info.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
}

Result<Destination> existing(Destination to, const struct stat& info, MadeFolders& folders) {
  if (S_ISDIR(info.st_mode))
    return Error{"io.cannot_write", to.shown.string(), "is a folder; name a file"};
  if (S_ISSOCK(info.st_mode))
    return Error{"io.cannot_write", to.shown.string(), "is a socket; name a file, device or pipe"};
  if (access(to.target.c_str(), W_OK) != 0)
    return cannot_write(to.shown, "may not be written", errno);
  if (!S_ISREG(info.st_mode)) {
    to.reach = Reach::streamed;
    return to;
  }
  to.mode = info.st_mode & 07777U;
  if (is_mounted(to.target) || folders.probe(to.target) != 0) to.reach = Reach::in_place;
  return to;
}

Result<Destination> not_there_yet(Destination to, MadeFolders& made) {
  const fs::path folder = to.target.parent_path();
  struct stat info {};
  if (stat(folder.c_str(), &info) != 0) {
    if (errno != ENOENT) return cannot_write(to.shown, "cannot be written", errno);
    if (const int fault = made.make(folder); fault != 0)
      return cannot_write(to.shown, "its folder cannot be made", fault);
  } else if (!S_ISDIR(info.st_mode)) {
    return cannot_write(to.shown, "cannot be written", ENOTDIR);
  }
  if (const int fault = made.probe(to.target); fault != 0)
    return cannot_write(to.shown, "cannot be written", fault);
  return to;
}

// Bytes to what is open. False with errno. A reader that takes its time is waited for, and
// interrupts are looked for meanwhile.
bool write_all(int fd, std::string_view bytes) {
  constexpr int look_ms = 100;
  while (!bytes.empty()) {
    const ssize_t written = write(fd, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
      continue;
    }
    if (errno == EAGAIN) {
      pollfd end{fd, POLLOUT, 0};
      poll(&end, 1, look_ms);
      if (!check_interrupt().ok()) return false;
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

// Some file systems have nothing to carry through.
bool is_on_disk(int fd) {
  return fsync(fd) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}

Result<void> write_streamed(const Destination& to, std::string_view bytes) {
  constexpr unsigned look_us = 50'000;
  int fd = -1;
  while (true) {  // a pipe that nobody reads yet is waited for
    fd = open(to.target.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (fd >= 0 || errno != ENXIO) break;
    MARKETGEN_CHECK(check_interrupt());
    usleep(look_us);
  }
  OpenFile file(fd);
  if (fd < 0) return cannot_write(to.shown, "cannot be opened", errno);
  const bool written = write_all(fd, bytes);
  const int fault = errno;
  MARKETGEN_CHECK(check_interrupt());
  if (!written) return cannot_write(to.shown, "cannot be written", fault);
  if (!file.close_now()) return cannot_write(to.shown, "cannot be written", errno);
  return {};
}

Result<void> write_descriptor(const Destination& to, std::string_view bytes) {
  std::fflush(nullptr);  // what was printed before comes first
  if (write_all(to.descriptor, bytes)) return {};
  return cannot_write(to.shown, "cannot be written", errno);
}

Result<void> write_in_place(const Destination& to, std::string_view bytes) {
  OpenFile file(open(to.target.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
  if (file.get() < 0) return cannot_write(to.shown, "cannot be opened", errno);
  if (!write_all(file.get(), bytes) || !is_on_disk(file.get()) || !file.close_now())
    return cannot_write(to.shown, "cannot be written", errno);
  return {};
}

Result<void> replace(const Destination& to, std::string_view bytes, Durable durable) {
  const fs::path part = part_in(to.target.parent_path(), to.target.filename().string());
  MARKETGEN_CHECK(write_new(part, bytes, durable, to.shown));
  if ((to.mode && chmod(part.c_str(), *to.mode) != 0) ||
      rename(part.c_str(), to.target.c_str()) != 0) {
    const int fault = errno;
    unlink(part.c_str());
    return cannot_write(to.shown, "cannot be put in place", fault);
  }
  return {};
}

}  // namespace

Error cannot_write(const fs::path& path, std::string_view what, int number) {
  return {"io.cannot_write",
          path.string(),
          fmt::format("{}: {}{}", what, std::strerror(number), remedy_for(number))};
}

MadeFolders& MadeFolders::operator=(MadeFolders&& other) noexcept {
  if (this != &other) {
    remove();
    made_ = std::exchange(other.made_, {});
    probed_ = std::move(other.probed_);
  }
  return *this;
}

void MadeFolders::remove() {
  std::error_code ignored;
  for (; !made_.empty(); made_.pop_back())
    fs::remove(made_.back(), ignored);  // only when it is empty
}

int MadeFolders::make(const fs::path& folder) {
  std::vector<fs::path> missing;
  std::error_code failed;
  for (fs::path part = folder; part.has_relative_path() && !fs::exists(part, failed);
       part = part.parent_path()) {
    if (part.has_filename()) missing.push_back(part);
  }
  for (; !missing.empty(); missing.pop_back()) {
    if (mkdir(missing.back().c_str(), 0777) == 0)
      made_.push_back(missing.back());
    else if (const int fault = errno; fault != EEXIST || !fs::is_directory(missing.back(), failed))
      return fault;
  }
  return 0;
}

int MadeFolders::probe(const fs::path& target) {
  const fs::path folder = target.parent_path();
  if (probed_.contains(folder)) return 0;
  sweep_parts_once(folder);
  const fs::path part = part_in(folder, target.filename().string());
  const OpenFile file(open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  if (file.get() < 0) return errno;
  unlink(part.c_str());
  probed_.insert(folder);
  return 0;
}

bool is_own_descriptor(const fs::path& followed) {
  return own_descriptor(followed) >= 0;
}

Result<fs::path> followed(const fs::path& path) {
  MARKETGEN_TRY(fs::path target, absolute_path(path));
  for (int links = 0; links < max_links; ++links) {
    const std::optional<fs::path> next = next_link(target);
    if (!next) return target;
    target = *next;
  }
  return cannot_write(path, "cannot be written", ELOOP);
}

Result<Destination> destination_of(const fs::path& path, MadeFolders& made) {
  Destination to{path, {}, Reach::replaced, -1, {}};
  MARKETGEN_TRY(to.target, followed(path));
  const fs::path name = to.target.filename();
  if (name.empty() || name == "." || name == "..")
    return Error{"io.cannot_write", path.string(), "is a folder; name a file"};
  if (const int number = own_descriptor(to.target); number >= 0) {
    to.descriptor = number;
    to.reach = Reach::descriptor;
    const int flags = fcntl(number, F_GETFL);
    if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY)
      return cannot_write(path, "is not open for writing", EBADF);
    return to;
  }
  struct stat info {};
  const bool there = stat(to.target.c_str(), &info) == 0;
  if (!there && errno != ENOENT) return cannot_write(path, "cannot be written", errno);
  MARKETGEN_TRY(Destination probed,
                there ? existing(std::move(to), info, made) : not_there_yet(std::move(to), made));
  std::error_code failed;
  const fs::path folder = fs::canonical(probed.target.parent_path(), failed);
  if (!failed) probed.target = folder / name;  // of one file, however it was named
  return probed;
}

Result<void> write_new(const fs::path& file,
                       std::string_view bytes,
                       Durable durable,
                       const fs::path& shown) {
  add_leftover(file);
  OpenFile made(open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  int fault = made.get() < 0 ? errno : 0;
  if (fault == 0 && !write_all(made.get(), bytes)) fault = errno;
  if (fault == 0 && durable == Durable::begun)  // a hint; carry_through() sees faults
    sync_file_range(made.get(), 0, 0, SYNC_FILE_RANGE_WRITE);
  if (fault == 0 && ((durable == Durable::yes && !is_on_disk(made.get())) || !made.close_now()))
    fault = errno;
  if (fault != 0 && fault != EEXIST) unlink(file.c_str());
  drop_leftover(file);
  if (fault != 0) return cannot_write(shown, "cannot be written", fault);
  return {};
}

Result<void> carry_through(const fs::path& file, const fs::path& shown) {
  const OpenFile written(open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (written.get() < 0 || !is_on_disk(written.get()))
    return cannot_write(shown, "cannot be written", errno);
  return {};
}

Result<void> write_to(const Destination& destination, std::string_view bytes, Durable durable) {
  switch (destination.reach) {
    case Reach::streamed:
      return write_streamed(destination, bytes);
    case Reach::descriptor:
      return write_descriptor(destination, bytes);
    case Reach::in_place:
      return write_in_place(destination, bytes);
    default:
      return replace(destination, bytes, durable);
  }
}

}  // namespace marketgen::io
