#include "layout/overrides.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/text.h"
#include "layout/module_spec.h"

namespace marketgen::layout {
namespace {

std::string pointer(std::size_t index, std::string_view field) {
  return "/overrides/" + std::to_string(index) + "/" + std::string(field);
}

Error unknown_reference(std::size_t index,
                        std::string_view field,
                        std::string_view what,
                        const std::string& name,
                        const std::vector<std::string_view>& known) {
  return {"plan.unknown_reference",
          pointer(index, field),
          "there is no " + std::string(what) + " \"" + name + "\"" + did_you_mean(name, known)};
}

Result<int> whole_number(const plan::Override& change, std::size_t index, const IntRange& range) {
  int number = 0;
  const char* end = change.value.data() + change.value.size();
  const auto [stop, fault] = std::from_chars(change.value.data(), end, number);
  if (fault != std::errc{} || stop != end || number < range[0] || number > range[1]) {
    return Error{"plan.bad_value",
                 pointer(index, "value"),
                 "\"" + change.value + "\" is not a whole number from " + std::to_string(range[0]) +
                     " to " + std::to_string(range[1]) +
                     ", which this kind of fixture allows for " + change.field_name};
  }
  return number;
}

// Levels spread over the height again.
void respace(Fixture& fixture) {
  const int room = fixture.height_mm - fixture.base_mm;
  fixture.spacing_mm =
      fixture.levels <= 1
          ? std::clamp(room, 0, max_spacing_mm)
          : std::min(room / fixture.levels, (room - min_top_gap_mm) / (fixture.levels - 1));
}

Result<void> change_kind(Fixture& fixture,
                         const plan::Override& change,
                         std::size_t index,
                         const catalog::Catalog& catalog) {
  const catalog::FixtureKind* kind = catalog.fixture_kind(change.value);
  if (kind == nullptr) {
    std::vector<std::string_view> known;
    for (const catalog::FixtureKind& row : catalog.fixture_kinds)
      known.push_back(row.kind);
    return unknown_reference(index, "value", "fixture kind", change.value, known);
  }
  const bool fits =
      fixture.depth_mm >= kind->depth_range_mm[0] && fixture.depth_mm <= kind->depth_range_mm[1];
  if (!fits) {
    return Error{"plan.bad_value",
                 pointer(index, "value"),
                 "a " + kind->name + " is " + std::to_string(kind->depth_range_mm[0]) + " to " +
                     std::to_string(kind->depth_range_mm[1]) + " mm deep; \"" + fixture.id +
                     "\" is " + std::to_string(fixture.depth_mm) + " mm deep"};
  }
  fixture.kind = kind->kind;
  fixture.height_mm =
      std::clamp(fixture.height_mm, kind->height_range_mm[0], kind->height_range_mm[1]);
  fixture.levels = kind->levels;
  fixture.base_mm = kind->base_mm;
  fixture.sides = kind->double_sided ? fixture.sides : 1;
  fixture.material = kind->material;
  fixture.color = kind->color;
  respace(fixture);
  return {};
}

Result<void> change_material(Fixture& fixture,
                             const plan::Override& change,
                             std::size_t index,
                             const catalog::Catalog& catalog) {
  const catalog::MaterialRow* material = catalog.material(change.value);
  if (material == nullptr) {
    std::vector<std::string_view> known;
    for (const catalog::MaterialRow& row : catalog.materials)
      known.push_back(row.id);
    return unknown_reference(index, "value", "material", change.value, known);
  }
  fixture.material = material->id;
  fixture.color = material->color;
  return {};
}

Result<void> apply(Fixture& fixture,
                   const plan::Override& change,
                   std::size_t index,
                   const catalog::Catalog& catalog) {
  const catalog::FixtureKind* kind = catalog.fixture_kind(fixture.kind);
  if (change.field_name == "kind") return change_kind(fixture, change, index, catalog);
  if (change.field_name == "material") return change_material(fixture, change, index, catalog);
  if (change.field_name == "color") {
    fixture.color = change.value;
    return {};
  }
  if (kind != nullptr && change.field_name == "levels") {
    MARKETGEN_TRY(fixture.levels, whole_number(change, index, kind->level_range));
    respace(fixture);
    return {};
  }
  if (kind != nullptr && change.field_name == "height_mm") {
    MARKETGEN_TRY(fixture.height_mm, whole_number(change, index, kind->height_range_mm));
    respace(fixture);
    return {};
  }
  return Error{"plan.bad_value",
               pointer(index, "field"),
               "\"" + change.field_name +
                   "\" cannot be overridden; levels, height_mm, color, material and kind can"};
}

// The kind's generator knows what it can build.
Result<void> check_buildable(const Fixture& fixture,
                             const plan::Look& look,
                             std::size_t index,
                             const catalog::Catalog& catalog) {
  const catalog::FixtureKind* kind = catalog.fixture_kind(fixture.kind);
  if (kind == nullptr) return {};
  const auto model = assets::make_fixture_model(fixture_shape(fixture, *kind, look), catalog);
  if (model.ok() || model.error().code != "assets.bad_row") return {};
  return Error{"plan.bad_value", pointer(index, "value"), model.error().message};
}

}  // namespace

Result<void> apply_overrides(std::vector<Fixture>& fixtures,
                             const plan::Plan& plan,
                             const catalog::Catalog& catalog) {
  for (std::size_t i = 0; i < plan.overrides.size(); ++i) {
    const plan::Override& change = plan.overrides[i];
    const auto fixture = std::ranges::find(fixtures, change.fixture, &Fixture::id);
    if (fixture == fixtures.end()) {
      std::vector<std::string_view> known;
      for (const Fixture& f : fixtures)
        known.push_back(f.id);
      return unknown_reference(i, "fixture", "fixture", change.fixture, known);
    }
    MARKETGEN_CHECK(apply(*fixture, change, i, catalog));
    MARKETGEN_CHECK(check_buildable(*fixture, plan.look, i, catalog));
  }
  return {};
}

}  // namespace marketgen::layout
