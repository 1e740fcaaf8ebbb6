#include "episodes/episode_sets.h"

#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.h"

namespace marketgen::episodes {
namespace fs = std::filesystem;
namespace {

// Without its ending; nothing for what holds no episodes, as the journal of a draw.
std::string name_of_set(const std::string& file) {
  for (const std::string_view ending : {".jsonl.gz", ".jsonl"})
    if (file.ends_with(ending)) return file.substr(0, file.size() - ending.size());
  return "";
}

}  // namespace

std::map<std::string, fs::path> episode_sets(const fs::path& data) {
  std::map<std::string, fs::path> sets;
  std::error_code failed;
  for (const auto& folder : fs::directory_iterator(data / "benchmark", failed)) {
    if (!folder.is_directory()) continue;
    for (const auto& entry : fs::directory_iterator(folder.path(), failed)) {
      const std::string name = name_of_set(entry.path().filename().string());
      if (!name.empty()) sets[folder.path().filename() / name] = entry.path();
    }
  }
  return sets;
}

Result<fs::path> find_episode_file(const fs::path& named, const fs::path& data) {
  std::error_code failed;
  if (fs::exists(named, failed)) return named;
  const auto sets = episode_sets(data);
  if (const auto set = sets.find(named.string()); set != sets.end()) return set->second;
  std::vector<std::string_view> names;
  for (const auto& [name, file] : sets)
    names.push_back(name);
  return Error{"input.not_found",
               named.string(),
               fmt::format("there is no such file, nor a set of episodes of that name{}; the sets "
                           "are: {}",
                           did_you_mean(named.string(), names),
                           fmt::join(names, ", "))};
}

}  // namespace marketgen::episodes
