#include "value_kinds.h"

#include <algorithm>

#include "assets/product_model.h"
#include "base/text.h"
#include "bench/bench.h"
#include "catalog/country.h"
#include "command.h"
#include "episodes/difficulty_rows.h"
#include "episodes/episode_sets.h"
#include "episodes/realism_rows.h"
#include "io/file.h"
#include "llm/provider.h"
#include "robots/grasp_tool.h"
#include "robots/robot_row.h"

namespace marketgen::app {
namespace {

// Values of no known list: what CLI11 calls by the variable's type, and ours.
constexpr std::string_view free_kinds[] = {
    "ADDRESS", "ASSET", "AXIS=SEED", "EPISODE", "FILTER", "FLOAT", "INT",
    "JOINT",   "PART",  "POINT",     "PRODUCT", "REGION", "SCALE", "SECRET",
    "SIZE",    "SKU",   "TEXT",      "TIME",    "UINT",   "URL",   "WORDS"};

template <class Rows, class Id>
std::vector<std::string> ids_in(const Rows& rows, Id id) {
  std::vector<std::string> ids;
  for (const auto& row : rows)
    ids.emplace_back(row.*id);
  return ids;
}

std::vector<std::string> providers_with(std::string_view offline) {
  std::vector<std::string> names;
  if (!offline.empty()) names.emplace_back(offline);
  for (const llm::ProviderRow& provider : llm::providers())
    names.push_back(std::string(provider.name) + ":");
  return names;
}

std::vector<std::string> set_names(const std::filesystem::path& data) {
  std::vector<std::string> names;
  for (const auto& [name, file] : episodes::episode_sets(data))
    names.push_back(name);
  return names;
}

std::vector<ValueKind> kinds_of_paths() {
  return {{"FILE", Paths::files, {}},
          {"OUTPUT", Paths::files, {}},
          {"PATH", Paths::files, {}},
          {"FOLDER", Paths::folders, {}},
          {"STORE", Paths::folders, {}},
          {"RESULTS", Paths::folders, {}}};
}

std::vector<ValueKind> kinds_of_rows(const catalog::Catalog& rows) {
  using namespace catalog;
  return {{"CATEGORY", Paths::none, ids_in(rows.categories, &CategoryRow::id)},
          {"COUNTRY", Paths::none, ids_in(countries(), &Country::id)},
          {"MATERIAL", Paths::none, ids_in(rows.materials, &MaterialRow::id)},
          {"PROFILE", Paths::none, ids_in(rows.profiles, &ProfileRow::id)},
          {"SHAPE", Paths::none, ids_in(assets::archetypes(), &assets::ArchetypeInfo::name)},
          {"STYLE", Paths::none, ids_in(rows.styles, &StyleRow::id)},
          {"ZONE", Paths::none, ids_in(rows.zone_types, &ZoneTypeRow::type)}};
}

std::vector<ValueKind> kinds_of_program() {
  return {
      {"BENCHMARK", Paths::none, ids_in(bench::benchmarks(), &bench::Benchmark::name)},
      // Also one of every zone, which only the store knows.
      {"CAMERA", Paths::none, {"top", "entrance", "aisle", "checkout", "zone:"}},
      {"DIFFICULTY",
       Paths::files,
       {episodes::difficulty_rows.begin(), episodes::difficulty_rows.end()}},
      {"MODEL", Paths::none, providers_with("")},
      {"PLANNER", Paths::none, providers_with("offline")},
      {"REALISM", Paths::files, {episodes::realism_rows.begin(), episodes::realism_rows.end()}}};
}

}  // namespace

Result<std::vector<ValueKind>> value_kinds() {
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const catalog::Catalog rows, load_rows());
  MARKETGEN_TRY(std::vector<std::string> tools, robots::grasp_tool_ids(data));
  MARKETGEN_TRY(std::vector<std::string> robots, robots::robot_ids(data));
  for (std::string& robot : robots)
    robot += "@";
  std::vector<ValueKind> kinds{{"EPISODES", Paths::files, set_names(data)},
                               {"ROBOT", Paths::files, std::move(robots)},
                               {"TOOL", Paths::none, std::move(tools)}};
  for (std::vector<ValueKind>& more :
       std::vector{kinds_of_paths(), kinds_of_rows(rows), kinds_of_program()})
    kinds.insert(kinds.end(), more.begin(), more.end());
  for (const std::string_view name : free_kinds)
    kinds.push_back({std::string(name), Paths::none, {}});
  for (ValueKind& kind : kinds)
    std::ranges::sort(kind.words);
  std::ranges::sort(kinds, {}, &ValueKind::name);
  return kinds;
}

std::vector<std::string> choices_in(std::string_view shown) {
  const std::size_t open = shown.find('{');
  if (open == std::string_view::npos || !shown.ends_with('}')) return {};
  return split(std::string(shown.substr(open + 1, shown.size() - open - 2)), ',');
}

}  // namespace marketgen::app
