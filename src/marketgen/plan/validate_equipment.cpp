#include <algorithm>

#include "base/fields.h"
#include "plan/validation.h"

namespace marketgen::plan {
namespace {

bool is_door(const Opening& opening) {
  return opening.kind != OpeningKind::window;
}

// Doors by their ids and kinds.
std::vector<std::string_view> doors_of(const Plan& plan) {
  std::vector<std::string_view> doors;
  for (const Opening& opening : plan.shell.openings) {
    if (!is_door(opening)) continue;
    doors.push_back(opening.id);
    doors.push_back(name_of(opening.kind));
  }
  return doors;
}

Result<void> check_kind(const PlanCheck& check, const EquipmentSpec& spec, std::string where) {
  MARKETGEN_CHECK(check_name(
      check.catalog.fixture_kinds, &catalog::FixtureKind::kind, "fixture kind", spec.kind, where));
  const catalog::FixtureKind* kind = check.catalog.fixture_kind(spec.kind);
  if (kind->role == catalog::FixtureRole::equipment && kind->mount == catalog::FixtureMount::floor)
    return {};
  // Without tills: nobody misses one (rule CHECKOUT_MISSING).
  if (kind->role == catalog::FixtureRole::checkout && spec.count == 0) return {};
  return Error{"plan.bad_value",
               std::move(where),
               "\"" + spec.kind +
                   "\" is no equipment that stands on the floor; what holds goods and takes money "
                   "belongs to a zone"};
}

}  // namespace

Result<void> check_equipment(const PlanCheck& check) {
  if (!check.plan.equipment) return {};
  const std::vector<EquipmentSpec>& all = *check.plan.equipment;
  const std::vector<std::string_view> doors = doors_of(check.plan);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto at = [&](std::string_view field) {
      return check.at(element_pointer("equipment", i, field));
    };
    MARKETGEN_CHECK(check_kind(check, all[i], at("kind")));
    const bool known = !all[i].at || std::ranges::find(doors, *all[i].at) != doors.end();
    if (!known)
      return catalog::unknown_name("plan.unknown_reference", at("at"), "door", *all[i].at, doors);
    const auto same = [&](const EquipmentSpec& other) {
      return other.kind == all[i].kind && other.at == all[i].at;
    };
    if (std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(i), same)) {
      return Error{"plan.bad_value",
                   at("kind"),
                   "\"" + all[i].kind + "\" is named twice for the same door; add the counts"};
    }
  }
  return {};
}

}  // namespace marketgen::plan
