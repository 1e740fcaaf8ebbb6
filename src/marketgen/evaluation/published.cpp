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
  for (std::size_t i = 0; i < published.policies.size(); ++i)
    MARKETGEN_CHECK(episodes::check_source_keys(
        published.sources, published.policies[i].source, file, fmt::format("/policies/{}", i)));
  return published;
}

}  // namespace marketgen::evaluation
