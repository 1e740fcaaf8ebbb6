#include "io/scratch_folder.h"

#include <sys/stat.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "base/interrupt.h"
#include "io/destination.h"
#include "io/file.h"
#include "io/part_name.h"

namespace marketgen::io {

Result<ScratchFolder> ScratchFolder::make(const std::string& name) {
  const std::filesystem::path temporary = std::filesystem::temp_directory_path();
  sweep_parts_once(temporary);
  std::filesystem::path folder = part_in(temporary, "marketgen-" + name);
  if (mkdir(folder.c_str(), 0700) != 0)
    return cannot_write(folder, "no folder for temporary files can be made", errno);
  add_leftover(folder);
  return ScratchFolder(std::move(folder));
}

ScratchFolder::ScratchFolder(ScratchFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

ScratchFolder::~ScratchFolder() {
  if (path_.empty()) return;
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  drop_leftover(path_);
}

}  // namespace marketgen::io
