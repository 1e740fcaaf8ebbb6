#include "io/part_name.h"

#include <unistd.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <mutex>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/hash.h"
#include "base/text.h"

namespace marketgen::io {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view mark = "~mg-", ending = "~part";
constexpr std::size_t longest_kept_name = 100;  // of 255 bytes that a name may have
constexpr std::size_t longest_kept_extension = 16;

// Process numbers mean something on one machine and in one container only.
const std::string& machine() {
  static const std::string tag = [] {
    std::array<char, 256> host{};
    gethostname(host.data(), host.size() - 1);
    std::error_code failed;
    const std::string space = fs::read_symlink("/proc/self/ns/pid", failed).string();
    return fmt::format("{:08x}", static_cast<std::uint32_t>(hash64(host.data() + space)));
  }();
  return tag;
}

// When a process was started, in clock ticks since the machine was: field 22 of its stat, which
// follows the name in brackets. None when there is no such process.
std::optional<std::string> start_of(long pid) {
  std::ifstream file(fmt::format("/proc/{}/stat", pid));
  std::string text;
  if (!std::getline(file, text)) return std::nullopt;
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return std::nullopt;
  std::istringstream fields(text.substr(name_end + 1));
  constexpr int start_after_name = 20;
  std::string field;
  for (int i = 0; i < start_after_name; ++i)
    fields >> field;
  return field;
}

// Whether `name` is of a process of this machine that is no more.
bool is_of_the_dead(std::string_view name) {
  const std::size_t at = name.rfind(mark), end_at = name.rfind(ending);
  if (at == std::string_view::npos || end_at == std::string_view::npos || end_at < at) return false;
  const std::string_view words = name.substr(at + mark.size(), end_at - at - mark.size());
  const std::vector<std::string> parts = split(words, '-');  // machine, process, start, number
  if (parts.size() != 4 || parts[0] != machine()) return false;
  long pid = 0;
  const auto [end, failed] =
      std::from_chars(parts[1].data(), parts[1].data() + parts[1].size(), pid);
  if (failed != std::errc() || end != parts[1].data() + parts[1].size() || pid <= 0) return false;
  const std::optional<std::string> start = start_of(pid);
  return !start || *start != parts[2];
}

}  // namespace

fs::path part_in(const fs::path& folder, const std::string& name) {
  static const std::string start = start_of(getpid()).value_or("0");
  static thread_local std::random_device random;  // names only: nothing that is kept depends on it
  const std::string extension = fs::path(name).extension().string();
  return folder / fmt::format(".{}{}{}-{}-{}-{:08x}{}{}",
                              name.size() > longest_kept_name ? "" : name,
                              mark,
                              machine(),
                              getpid(),
                              start,
                              random(),
                              ending,
                              extension.size() > longest_kept_extension ? "" : extension);
}

void sweep_parts(const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::path> dead;
  for (auto entry = fs::directory_iterator(folder, failed);
       !failed && entry != fs::directory_iterator();
       entry.increment(failed)) {
    if (is_of_the_dead(entry->path().filename().string())) dead.push_back(entry->path());
  }
  for (const fs::path& part : dead)
    fs::remove_all(part, failed);
}

void sweep_parts_once(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> swept;
  {
    const std::scoped_lock lock(mutex);
    if (!swept.insert(folder).second) return;
  }
  sweep_parts(folder);
}

}  // namespace marketgen::io
