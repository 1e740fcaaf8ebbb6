#include "io/installation.h"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <system_error>

namespace marketgen::io {
namespace fs = std::filesystem;
namespace {

// The checkout this was built from; empty in a wheel, which has everything inside. Only this file
// knows it: all others compile to the same in any folder.
constexpr const char* source_folder = MARKETGEN_SOURCE_FOLDER;

}  // namespace

fs::path own_folder() {
  Dl_info info{};
  link_map* loaded = nullptr;
  const bool found = dladdr1(reinterpret_cast<const void*>(&own_folder),
                             &info,
                             reinterpret_cast<void**>(&loaded),
                             RTLD_DL_LINKMAP) != 0;
  std::error_code failed;
  // The program itself has no name among the loaded objects; in Python that would be Python's.
  if (!found || loaded->l_name == nullptr || *loaded->l_name == '\0')
    return fs::read_symlink("/proc/self/exe", failed).parent_path();
  return fs::weakly_canonical(loaded->l_name, failed).parent_path();
}

std::vector<fs::path> share_folders() {
  const fs::path own = own_folder();
  std::vector<fs::path> folders = {
      own / "../share/marketgen", own / "share/marketgen", own, source_folder};
  std::erase_if(folders, [](const fs::path& folder) { return folder.empty(); });
  std::ranges::transform(folders, folders.begin(), &fs::path::lexically_normal);
  return folders;
}

std::vector<fs::path> site_packages() {
  std::vector<fs::path> folders;
  const fs::path own = own_folder();
  for (fs::path folder = own; folder.has_relative_path(); folder = folder.parent_path()) {
    if (folder.filename() == "site-packages" || folder.filename() == "dist-packages")
      folders.push_back(folder);
  }
  if (*source_folder == '\0') return folders;
  std::error_code none;
  for (const fs::directory_entry& python :
       fs::directory_iterator(fs::path(source_folder) / ".venv/lib", none)) {
    if (python.path().filename().string().starts_with("python"))
      folders.push_back(python.path() / "site-packages");
  }
  return folders;
}

fs::path python_of(const fs::path& package_folder) {
  const fs::path version = package_folder.parent_path();  // lib/python3.12
  const fs::path programs = version.parent_path().parent_path() / "bin";
  std::error_code failed;
  for (const fs::path& name : {version.filename(), fs::path("python3")}) {
    if (fs::exists(programs / name, failed)) return programs / name;
  }
  return {};
}

}  // namespace marketgen::io
