// Operations on values: fixtures, goods, openings, look, shell, relations, overrides, shelves.
#include <algorithm>
#include <map>
#include <type_traits>

#include "plan/patch_change.h"
#include "plan/plan_edit.h"
#include "plan/shelf_key.h"
#include "plan/validation.h"

namespace marketgen::plan {
namespace {

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

// The value into the field of that name; returns whether there is one that takes it.
template <class Owner, class Value>
bool set_field(Owner& owner, std::string_view name, const Value& value) {
  bool is_set = false;
  Owner::fields([&](const auto& field) {
    using Member = std::remove_cvref_t<decltype(owner.*(field.member))>;
    if constexpr (std::is_same_v<Member, Value> || std::is_same_v<Member, std::optional<Value>>) {
      if (field.name != name) return;
      owner.*(field.member) = value;
      is_set = true;
    }
  });
  return is_set;
}

// What the patch says into the owner's fields.
template <class Owner, class Change>
void set_fields(PlanChange& task, Owner& owner, const Change& patch, const std::string& pointer) {
  Change::fields([&](const auto& field) {
    using Member = std::remove_cvref_t<decltype(patch.*(field.member))>;
    if constexpr (IsOptional<Member>::value) {
      const Member& value = patch.*(field.member);
      if (value && set_field(owner, field.name, *value))
        task.paths.push_back(pointer + "/" + std::string(field.name));
    }
  });
}

// Fields as in `usual`, a row that says nothing.
template <class Owner>
Result<void> set_usual(PlanChange& task,
                       Owner& owner,
                       const Owner& usual,
                       const UsualFields& fields,
                       const std::string& pointer) {
  const std::vector<std::string> names = fields.value_or(std::vector<std::string>{});
  for (std::size_t i = 0; i < names.size(); ++i) {
    bool is_set = false;
    std::vector<std::string_view> known;
    Owner::fields([&](const auto& field) {
      known.push_back(field.name);
      if (field.name != names[i]) return;
      owner.*(field.member) = usual.*(field.member);
      is_set = true;
    });
    if (!is_set) {
      return catalog::unknown_name(
          "json.unknown_field", task.at("usual/" + std::to_string(i)), "field", names[i], known);
    }
    task.paths.push_back(pointer + "/" + names[i]);
  }
  return {};
}

Error nothing_to_take_back(const PlanChange& task, std::string_view what) {
  return {"plan.unknown_reference",
          task.where,
          "the plan has no such " + std::string(what) + "; there is nothing to take back"};
}

}  // namespace

Result<void> change(PlanChange& task, const SetFixture& patch) {
  MARKETGEN_TRY(const std::size_t index, named_zone(task, "zone", patch.zone));
  Zone& zone = task.plan.zones[index];
  const std::string pointer = element_pointer("zones", index, "fixture");
  FixtureSpec usual;
  if (const catalog::ZoneTypeRow* type = task.catalog.zone_type(zone.type))
    usual.kind = type->fixture;
  MARKETGEN_CHECK(set_usual(task, zone.fixture, usual, patch.usual, pointer));
  set_fields(task, zone.fixture, patch, pointer);
  return {};
}

Result<void> change(PlanChange& task, const SetStock& patch) {
  MARKETGEN_TRY(const std::size_t index, named_zone(task, "zone", patch.zone));
  StockSpec& stock = task.plan.zones[index].stock;
  const std::string pointer = element_pointer("zones", index, "stock");
  MARKETGEN_CHECK(set_usual(task, stock, StockSpec{}, patch.usual, pointer));
  set_fields(task, stock, patch, pointer);
  return {};
}

Result<void> change(PlanChange& task, const MoveOpening& patch) {
  MARKETGEN_TRY(const std::size_t index, named_opening(task, patch.opening));
  set_fields(
      task, task.plan.shell.openings[index], patch, element_pointer("shell/openings", index));
  return {};
}

Result<void> change(PlanChange& task, const AddOpening& patch) {
  std::vector<Opening>& openings = task.plan.shell.openings;
  if (std::ranges::find(openings, patch.opening.id, &Opening::id) != openings.end()) {
    return Error{"plan.duplicate_id",
                 task.at("opening/id"),
                 "there is an opening \"" + patch.opening.id + "\" already; \"" +
                     unused_id(task.plan, patch.opening.id) + "\" is free"};
  }
  task.paths.push_back(element_pointer("shell/openings", openings.size()));
  openings.push_back(patch.opening);
  return {};
}

Result<void> change(PlanChange& task, const SetLook& patch) {
  MARKETGEN_CHECK(set_usual(task, task.plan.look, Look{}, patch.usual, "/look"));
  set_fields(task, task.plan.look, patch, "/look");
  return {};
}

Result<void> change(PlanChange& task, const SetShell& patch) {
  Shell usual;
  if (const catalog::ProfileRow* profile = task.catalog.profile(task.plan.profile)) {
    usual.ceiling_mm = profile->ceiling_mm;
    usual.width_mm = profile->default_size_mm[0];
    usual.depth_mm = profile->default_size_mm[1];
  }
  usual.openings = task.plan.shell.openings;
  MARKETGEN_CHECK(set_usual(task, task.plan.shell, usual, patch.usual, "/shell"));
  set_fields(task, task.plan.shell, patch, "/shell");
  return {};
}

Result<void> change(PlanChange& task, const SetRelation& patch) {
  std::vector<Relation>& relations = task.plan.relations;
  const auto same = std::ranges::find_if(relations, [&](const Relation& r) {
    return r.kind == patch.kind && r.a == patch.a && r.b == patch.b && r.c == patch.c;
  });
  task.paths.emplace_back("/relations");
  if (patch.drop) {
    if (same == relations.end()) return nothing_to_take_back(task, "relation");
    relations.erase(same);
    return {};
  }
  const Relation relation{patch.kind, patch.a, patch.b, patch.c, patch.strength};
  if (same == relations.end())
    relations.push_back(relation);
  else
    *same = relation;
  return {};
}

Result<void> change(PlanChange& task, const SetOverride& patch) {
  std::vector<Override>& overrides = task.plan.overrides;
  const auto same = std::ranges::find_if(overrides, [&](const Override& o) {
    return o.fixture == patch.fixture && o.field_name == patch.field_name;
  });
  task.paths.emplace_back("/overrides");
  if (!patch.value) {
    if (same == overrides.end()) return nothing_to_take_back(task, "override");
    overrides.erase(same);
    return {};
  }
  const Override pinned{patch.fixture, patch.field_name, *patch.value};
  if (same == overrides.end())
    overrides.push_back(pinned);
  else
    *same = pinned;
  return {};
}

Result<void> change(PlanChange& task, const StockShelves& patch) {
  std::map<ShelfKey, StockedShelf> shelves;
  for (StockedShelf& shelf : task.plan.planogram.value_or(std::vector<StockedShelf>{}))
    shelves[key_of(shelf)] = std::move(shelf);
  for (std::size_t i = 0; i < patch.shelves.size(); ++i) {
    const ShelfChange& shelf = patch.shelves[i];
    if (shelf.blocks) {
      shelves[key_of(shelf)] = {shelf.fixture, shelf.side, shelf.shelf, *shelf.blocks};
    } else if (shelves.erase(key_of(shelf)) == 0) {
      task.where += "/shelves/" + std::to_string(i);
      return nothing_to_take_back(task, "shelf in its planogram");
    }
  }
  task.paths.emplace_back("/planogram");
  task.plan.planogram.reset();
  if (shelves.empty()) return {};
  task.plan.planogram.emplace();
  for (auto& [key, shelf] : shelves)
    task.plan.planogram->push_back(std::move(shelf));
  return {};
}

}  // namespace marketgen::plan
