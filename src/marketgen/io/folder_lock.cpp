#include "io/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/interrupt.h"

namespace marketgen::io {
namespace {

constexpr int max_looks = 100;  // at a file that others make and remove
constexpr int wait_pause_us = 20'000;

Error lock_fault(const std::filesystem::path& file) {
  return {"io.cannot_write", file.string(), std::strerror(errno)};
}

Error held_by_another(const std::filesystem::path& folder, int descriptor) {
  std::array<char, 32> text{};
  const ssize_t got = pread(descriptor, text.data(), text.size() - 1, 0);
  const std::string owner(text.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
  return {"io.in_use",
          folder.string(),
          fmt::format("process {} writes there: wait until it has ended, or name another folder",
                      owner.empty() ? "?" : owner)};
}

// Whether the locked file is still the one of that name: its owner removes it when it goes.
bool is_named(int descriptor, const std::filesystem::path& file) {
  struct stat ours {
  }, named{};
  return fstat(descriptor, &ours) == 0 && stat(file.c_str(), &named) == 0 &&
         ours.st_ino == named.st_ino && ours.st_dev == named.st_dev;
}

}  // namespace

Result<FolderLock> FolderLock::take(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / ".lock";
  for (int look = 0; look < max_looks; ++look) {
    FolderLock lock(file, open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
    if (lock.descriptor_ < 0) return lock_fault(file);
    if (flock(lock.descriptor_, LOCK_EX | LOCK_NB) != 0) {
      const Error fault =
          errno == EWOULDBLOCK ? held_by_another(folder, lock.descriptor_) : lock_fault(file);
      close(std::exchange(lock.descriptor_, -1));  // the file is not ours to remove
      return fault;
    }
    if (!is_named(lock.descriptor_, file)) {
      close(std::exchange(lock.descriptor_, -1));
      continue;
    }
    const std::string owner = std::to_string(getpid());
    if (ftruncate(lock.descriptor_, 0) != 0 ||
        pwrite(lock.descriptor_, owner.data(), owner.size(), 0) < 0)
      return lock_fault(file);
    add_leftover(file);
    return lock;
  }
  return Error{"io.in_use", folder.string(), "other processes come and go there: try again"};
}

Result<FolderLock> FolderLock::wait_for(const std::filesystem::path& folder, double limit_s) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(limit_s);
  while (true) {
    Result<FolderLock> lock = take(folder);
    const bool in_use = !lock.ok() && lock.error().code == "io.in_use";
    if (!in_use || std::chrono::steady_clock::now() > until) return lock;
    MARKETGEN_CHECK(check_interrupt());
    usleep(wait_pause_us);
  }
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

FolderLock::~FolderLock() {
  if (descriptor_ < 0) return;
  drop_leftover(file_);
  unlink(file_.c_str());
  close(descriptor_);
}

}  // namespace marketgen::io
