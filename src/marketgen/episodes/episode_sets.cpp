#include "episodes/episode_sets.h"

#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.h"
#include "io/file.h"

namespace marketgen::episodes {
namespace fs = std::filesystem;
namespace {

// Without its ending; nothing for what holds no episodes, as the journal of a draw.
std::string name_of_set(const std::string& file) {
  for (const std::string_view ending : {".jsonl.gz", ".jsonl"})
    if (file.ends_with(ending)) return file.substr(0, file.size() - ending.size());
  return "";
}

constexpr char sums_file[] = "SHA256SUMS";

// What the line of a file says; empty when there is none.
std::string sum_of(std::string_view sums, std::string_view name) {
  while (!sums.empty()) {
    const std::size_t end = sums.find('\n');
    const std::string_view line = sums.substr(0, end);
    const std::size_t blank = line.find("  ");
    if (blank != std::string_view::npos && line.substr(blank + 2) == name)
      return std::string(line.substr(0, blank));
    sums.remove_prefix(end == std::string_view::npos ? sums.size() : end + 1);
  }
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

std::string set_of_file(const fs::path& file, const fs::path& data) {
  std::error_code failed;
  for (const auto& [name, of_set] : episode_sets(data))
    if (fs::equivalent(file, of_set, failed)) return name;
  return "";
}

Result<void> check_set_file(const fs::path& folder, const std::string& name) {
  std::error_code failed;
  if (!fs::exists(folder / sums_file, failed)) return {};
  MARKETGEN_TRY(const std::string sums, io::read_file(folder / sums_file));
  MARKETGEN_TRY(const std::string there, io::sha256_of_file(folder / name));
  const std::string said = sum_of(sums, name);
  if (said == there) return {};
  return Error{"episode.changed_set",
               (folder / name).string(),
               fmt::format("{} beside it {}, so that results would not be of the set {}: install "
                           "the program's data again, or give episodes of your own another place",
                           sums_file,
                           said.empty() ? "does not list it" : "has another sum for it",
                           folder.filename().string())};
}

}  // namespace marketgen::episodes
