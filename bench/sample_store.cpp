#include "bench/sample_store.h"

#include <unistd.h>

#include <fmt/format.h>

#include "base/interrupt.h"

namespace marketgen::bench {
namespace fs = std::filesystem;

ScratchFolder::ScratchFolder()
    : folder_(fs::temp_directory_path() / fmt::format("marketgen-bench-{}", getpid())) {
  fs::create_directories(folder_);
  add_leftover(folder_);
}
ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  drop_leftover(folder_);
}

store::CreateOptions neighbourhood_store(const fs::path& folder, bool previews) {
  store::CreateOptions options;
  options.folder = folder;
  options.brief.prompt =
      "A 24 x 15 m neighbourhood supermarket with produce by the entrance, dairy along the back "
      "wall and three checkouts";
  options.seed = 7;
  options.previews = previews;
  return options;
}

store::CreateOptions large_store(const fs::path& folder) {
  store::CreateOptions options = neighbourhood_store(folder, false);
  options.brief.prompt =
      "A 40 x 25 m supermarket with produce by the entrance, dairy along the back wall and six "
      "checkouts";
  return options;
}

store::CreateOptions hypermarket(const fs::path& folder) {
  store::CreateOptions options = neighbourhood_store(folder, false);
  options.brief.prompt = "A 114 x 86 m hypermarket";
  options.seed = 3;
  return options;
}

}  // namespace marketgen::bench
