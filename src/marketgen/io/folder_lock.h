// A folder that one run has to itself: two that write the same files would lose one another's.
#pragma once
#include <filesystem>

#include "base/result.h"

namespace marketgen::io {

// Held while it lives. The operating system lets go of it when the process ends, however it does:
// what a dead one left behind hinders nobody. Its file, FOLDER/.lock, goes with it.
class FolderLock {
 public:
  // Errors: io.in_use with the number of the process that has it, which may be this one;
  // io.cannot_write.
  static Result<FolderLock> take(const std::filesystem::path& folder);
  // The same, but waits so long for another to let go of it; internal.interrupted.
  static Result<FolderLock> wait_for(const std::filesystem::path& folder, double limit_s);
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  FolderLock(std::filesystem::path file, int descriptor)
      : file_(std::move(file)), descriptor_(descriptor) {}

  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace marketgen::io
