// Stores that several benchmarks use.
#pragma once
#include <filesystem>

#include "base/result.h"
#include "catalog/catalog.h"
#include "store/store.h"

namespace marketgen::bench {

// A folder under the system's temporary folder that is removed at the end.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

// The 24 x 15 m store of the README, the 40 x 25 m one, and a hypermarket with a million products.
store::CreateOptions neighbourhood_store(const std::filesystem::path& folder, bool previews);
store::CreateOptions large_store(const std::filesystem::path& folder);
store::CreateOptions hypermarket(const std::filesystem::path& folder);

}  // namespace marketgen::bench
