#include <utf8proc.h>

#include <algorithm>

#include <fmt/format.h>

#include "base/text.h"
#include "catalog/country.h"
#include "intake/brief.h"
#include "intake/drawn_shell.h"
#include "intake/photos_file.h"
#include "intake/plan_zones.h"
#include "intake/store_size.h"
#include "io/json.h"
#include "plan/store_time.h"

namespace marketgen::intake {
namespace {

constexpr std::size_t longest_prompt_bytes = 20'000;

// Index of the first byte that is not part of a UTF-8 character; size() when there is none.
std::size_t first_bad_byte(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    utf8proc_int32_t code = 0;
    const auto* bytes = reinterpret_cast<const utf8proc_uint8_t*>(text.data()) + at;
    const auto length =
        utf8proc_iterate(bytes, static_cast<utf8proc_ssize_t>(text.size() - at), &code);
    if (length <= 0) return at;
    at += static_cast<std::size_t>(length);
  }
  return at;
}

Result<void> check_prompt(const std::string& prompt) {
  if (prompt.size() > longest_prompt_bytes) {
    return Error{"brief.too_long",
                 "prompt",
                 "the prompt has " + with_thousands(static_cast<std::int64_t>(prompt.size())) +
                     " bytes; at most " + with_thousands(longest_prompt_bytes) + " are read"};
  }
  if (const std::size_t bad = first_bad_byte(prompt); bad < prompt.size()) {
    return Error{"input.not_utf8",
                 "prompt:byte " + std::to_string(bad),
                 "the prompt is not UTF-8 text from this byte on; save it as UTF-8"};
  }
  const bool blank = prompt.find_first_not_of(" \t\r\n\v\f") == std::string::npos;
  if (!blank) return {};
  return Error{"brief.empty",
               "prompt",
               "there is nothing to plan from; describe the store, as in \"a 24 x 15 m supermarket "
               "with a bakery and five checkouts\""};
}

template <class Row>
Result<void> check_known(const std::vector<Row>& rows,
                         std::string_view what,
                         const std::optional<std::string>& name,
                         std::string where) {
  if (!name) return {};
  std::vector<std::string_view> known;
  for (const Row& row : rows) {
    if (row.id == *name) return {};
    known.push_back(row.id);
  }
  return catalog::unknown_name("catalog.unknown_kind", std::move(where), what, *name, known);
}

Result<void> check_brief(const Brief& brief, const catalog::Catalog& catalog) {
  const bool drawn =
      brief.floor_plan || !brief.image_files.empty() || brief.zones || !brief.photos.empty();
  if (!drawn || !brief.prompt.empty()) MARKETGEN_CHECK(check_prompt(brief.prompt));
  if (brief.size_mm) {
    MARKETGEN_CHECK(check_store_size((*brief.size_mm)[0], (*brief.size_mm)[1], "--size"));
  }
  MARKETGEN_CHECK(check_known(catalog.profiles, "profile", brief.profile, "--profile"));
  if (brief.country)
    MARKETGEN_CHECK(catalog::check_country(*brief.country, "catalog.unknown_kind", "--country"));
  if (brief.time) MARKETGEN_CHECK(plan::parse_store_time(*brief.time, "brief.bad_time", "--time"));
  return check_known(catalog.styles, "style", brief.style, "--style");
}

// Boards as high as their goods. How many there are is left to the goods, too, where nobody asked
// for more or fewer than gondolas usually have.
void fit_shelves(plan::Plan& plan) {
  plan.shelves = plan::ShelfPitch::fitted;
  for (std::size_t i = 0; i < plan.zones.size(); ++i) {
    plan::FixtureSpec& fixture = plan.zones[i].fixture;
    const std::string path = fmt::format("/zones/{}/fixture/levels", i);
    const bool said =
        std::ranges::find(plan.provenance, path, &plan::Provenance::path) != plan.provenance.end();
    if (!said && fixture.height_mm && fixture.levels == gondola_levels(*fixture.height_mm))
      fixture.levels.reset();
  }
}

}  // namespace

Result<Planned> plan_from_brief(const Brief& brief,
                                const catalog::Catalog& catalog,
                                const Planner& planner,
                                Seed seed,
                                const Concessions& concessions) {
  MARKETGEN_CHECK(check_brief(brief, catalog));
  MARKETGEN_TRY(const Drawn drawn, with_drawing(brief, catalog));
  MARKETGEN_TRY(Planned planned, planner.plan(drawn.brief, catalog, seed, concessions));
  planned.trace.insert(planned.trace.begin(), drawn.warnings.begin(), drawn.warnings.end());
  if (!planned.plan.shelves) fit_shelves(planned.plan);
  if (!planned.plan.outfit) planned.plan.outfit = plan::Outfit::full;
  planned.drawn = drawn.brief.zones;
  if (const auto& photos = drawn.brief.photos; !photos.empty()) {
    PhotosFile file;
    file.photos = photos;
    if (!planned.seen.empty()) file.seen = planned.seen;
    planned.files.push_back({"photos.json", io::write_json(file)});
  }
  MARKETGEN_CHECK(plan::validate_plan(planned.plan, "plan", catalog));
  return planned;
}

}  // namespace marketgen::intake
