#include "plan/validation.h"

#include "catalog/country.h"
#include "plan/store_time.h"

namespace marketgen::plan {
namespace {

Result<void> check_material(const PlanCheck& check,
                            const std::string& name,
                            const std::string& pointer) {
  return check_name(
      check.catalog.materials, &catalog::MaterialRow::id, "material", name, check.at(pointer));
}

Result<void> check_look(const PlanCheck& check) {
  const Look& look = check.plan.look;
  MARKETGEN_CHECK(check_material(check, look.floor, "/look/floor"));
  MARKETGEN_CHECK(check_material(check, look.wall, "/look/wall"));
  MARKETGEN_CHECK(check_material(check, look.ceiling, "/look/ceiling"));
  MARKETGEN_CHECK(check_material(check, look.fixture, "/look/fixture"));
  return check_color(look.accent, check.at("/look/accent"));
}

Result<void> check_fixture_names(const PlanCheck& check,
                                 const FixtureSpec& fixture,
                                 const std::string& pointer) {
  const auto at = [&](std::string_view field) {
    return check.at(pointer + "/" + std::string(field));
  };
  if (!fixture.kind.empty()) {  // an open lobby has no fixtures
    MARKETGEN_CHECK(check_name(check.catalog.fixture_kinds,
                               &catalog::FixtureKind::kind,
                               "fixture kind",
                               fixture.kind,
                               at("kind")));
  }
  if (fixture.color) MARKETGEN_CHECK(check_color(*fixture.color, at("color")));
  if (!fixture.material) return {};
  return check_name(check.catalog.materials,
                    &catalog::MaterialRow::id,
                    "material",
                    *fixture.material,
                    at("material"));
}

Result<void> check_zone_names(const PlanCheck& check, std::size_t i) {
  const Zone& zone = check.plan.zones[i];
  MARKETGEN_CHECK(check_name(check.catalog.zone_types,
                             &catalog::ZoneTypeRow::type,
                             "zone type",
                             zone.type,
                             check.at(element_pointer("zones", i, "type"))));
  MARKETGEN_CHECK(check_fixture_names(check, zone.fixture, element_pointer("zones", i, "fixture")));
  for (std::size_t k = 0; zone.also && k < zone.also->size(); ++k) {
    MARKETGEN_CHECK(check_fixture_names(
        check, (*zone.also)[k], element_pointer("zones", i, "also/" + std::to_string(k))));
  }
  for (std::size_t k = 0; k < zone.stock.categories.size(); ++k) {
    MARKETGEN_CHECK(
        check_name(check.catalog.categories,
                   &catalog::CategoryRow::id,
                   "category",
                   zone.stock.categories[k],
                   check.at(element_pointer("zones", i, "stock/categories/" + std::to_string(k)))));
  }
  return {};
}

}  // namespace

Result<void> check_color(std::string_view text, std::string where) {
  bool valid = text.size() == 7 && text[0] == '#';
  for (const char c : text.substr(valid ? 1 : text.size())) {
    valid = valid && ((c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'));
  }
  if (valid) return {};
  return Error{"plan.bad_value",
               std::move(where),
               "\"" + std::string(text) + "\" is not a colour; write #rrggbb, as in #2e7d32"};
}

Result<void> check_names(const PlanCheck& check) {
  MARKETGEN_CHECK(check_name(check.catalog.profiles,
                             &catalog::ProfileRow::id,
                             "profile",
                             check.plan.profile,
                             check.at("/profile")));
  if (check.plan.country)
    MARKETGEN_CHECK(catalog::check_country(
        *check.plan.country, "plan.unknown_reference", check.at("/country")));
  if (check.plan.time)
    MARKETGEN_CHECK(parse_store_time(*check.plan.time, "plan.bad_value", check.at("/time")));
  MARKETGEN_CHECK(check_look(check));
  for (std::size_t i = 0; i < check.plan.zones.size(); ++i) {
    MARKETGEN_CHECK(check_zone_names(check, i));
  }
  return {};
}

}  // namespace marketgen::plan
