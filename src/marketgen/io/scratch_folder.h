// A folder for files that are needed only while the program works with them.
#pragma once
#include <filesystem>
#include <string>

#include "base/result.h"

namespace marketgen::io {

// Only this user may look into it. It goes with its owner, with an interrupted program, and, where
// that was killed, with the next one that makes one.
class ScratchFolder {
 public:
  // `name` is told in the folder's own. Error: io.cannot_write.
  static Result<ScratchFolder> make(const std::string& name);
  ScratchFolder(ScratchFolder&& other) noexcept;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  explicit ScratchFolder(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;  // empty: moved from
};

}  // namespace marketgen::io
