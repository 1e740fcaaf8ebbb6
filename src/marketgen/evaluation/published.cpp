#include "evaluation/published.h"

#include <fmt/format.h>

#include "episodes/source_keys.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::evaluation {

Result<Published> load_published(const std::filesystem::path& data) {
  constexpr char file[] = "published.json";
  MARKETGEN_TRY(const std::string text, io::read_file(data / "benchmark" / file, 1U << 20));
  MARKETGEN_TRY(Published published, io::read_json<Published>(text, file));
  const auto check_sources = [&](const auto& rows, std::string_view list) -> Result<void> {
    for (std::size_t i = 0; i < rows.size(); ++i)
      MARKETGEN_CHECK(episodes::check_source_keys(
          published.sources, rows[i].source, file, fmt::format("/{}/{}", list, i)));
    return {};
  };
  MARKETGEN_CHECK(check_sources(published.policies, "policies"));
  MARKETGEN_CHECK(check_sources(published.shapes, "shapes"));
  MARKETGEN_CHECK(check_sources(published.generators, "generators"));
  return published;
}

}  // namespace marketgen::evaluation
