// Operations on values: fixtures, goods, openings, look, shell, relations, overrides, shelves.
#include <algorithm>
#include <map>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

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

using ShelvesByKey = std::map<ShelfKey, StockedShelf>;

ShelvesByKey shelves_of(const Plan& plan) {
  ShelvesByKey shelves;
  for (const StockedShelf& shelf : plan.planogram.value_or(std::vector<StockedShelf>{}))
    shelves[key_of(shelf)] = shelf;
  return shelves;
}

void set_shelves(PlanChange& task, const ShelvesByKey& shelves) {
  task.paths.emplace_back("/planogram");
  task.plan.planogram.reset();
  if (shelves.empty()) return;
  task.plan.planogram.emplace();
  for (const auto& [key, shelf] : shelves)
    task.plan.planogram->push_back(shelf);
}

// Of one pack; 0 for a product that is not there, which is found where the outcome is validated.
int width_mm(const catalog::Catalog& catalog, const ShelfBlock& block) {
  const catalog::Product* product = catalog.product(block.sku);
  return product == nullptr ? 0 : product->size_mm[0];
}

// The block that a field of the patch names.
Result<ShelfBlock*> named_block(const PlanChange& task,
                                ShelvesByKey& shelves,
                                std::string_view field,
                                const BlockPlace& place) {
  const std::string at = task.at(field);
  const auto shelf = shelves.find(key_of(place));
  if (shelf == shelves.end())
    return Error{"plan.unknown_reference",
                 at,
                 fmt::format("the plan does not say what stands on shelf {} of \"{}\", {}; a store "
                             "does (marketgen edit), and stock_shelves says it",
                             place.shelf,
                             place.fixture,
                             name_of(place.side))};
  std::vector<ShelfBlock>& blocks = shelf->second.blocks;
  if (place.position > static_cast<int>(blocks.size()))
    return Error{"plan.unknown_reference",
                 at + "/position",
                 fmt::format("the shelf has {} blocks; count them from the left", blocks.size())};
  ShelfBlock& block = blocks[static_cast<std::size_t>(place.position) - 1];
  if (place.sku && *place.sku != block.sku)
    return Error{
        "plan.unknown_reference",
        at + "/sku",
        fmt::format(
            "\"{}\" stands there, and not \"{}\"; look at the shelf again", block.sku, *place.sku)};
  return &block;
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

Result<void> change(PlanChange& task, const SetTime& patch) {
  task.plan.time = patch.time;
  task.paths.emplace_back("/time");
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
  ShelvesByKey shelves = shelves_of(task.plan);
  for (std::size_t i = 0; i < patch.shelves.size(); ++i) {
    const ShelfChange& shelf = patch.shelves[i];
    if (shelf.blocks) {
      shelves[key_of(shelf)] = {shelf.fixture, shelf.side, shelf.shelf, *shelf.blocks};
    } else if (shelves.erase(key_of(shelf)) == 0) {
      task.where += "/shelves/" + std::to_string(i);
      return nothing_to_take_back(task, "shelf in its planogram");
    }
  }
  set_shelves(task, shelves);
  return {};
}

// What goes with a block depends on the shelf it comes to stand on: as many above and behind one
// another as have room there. Places from the left go with the shelf; where the two are not as
// wide, its blocks are spread.
Result<void> change(PlanChange& task, const SwapBlocks& patch) {
  ShelvesByKey shelves = shelves_of(task.plan);
  MARKETGEN_TRY(ShelfBlock* const a, named_block(task, shelves, "a", patch.a));
  MARKETGEN_TRY(ShelfBlock* const b, named_block(task, shelves, "b", patch.b));
  if (a == b) return Error{"plan.bad_value", task.at("b"), "is the block of a; name another one"};
  std::swap(*a, *b);
  std::swap(a->x_mm, b->x_mm);
  b->facings = patch.a.facings.value_or(b->facings);
  a->facings = patch.b.facings.value_or(a->facings);
  const bool spread =
      a->facings != b->facings || width_mm(task.catalog, *a) != width_mm(task.catalog, *b);
  for (const BlockPlace* place : {&patch.a, &patch.b}) {
    if (!spread) break;
    for (ShelfBlock& block : shelves.at(key_of(*place)).blocks)
      block.x_mm.reset();
  }
  if (key_of(patch.a) != key_of(patch.b)) {
    for (ShelfBlock* block : {a, b}) {
      block->facings_high.reset();
      block->facings_deep.reset();
    }
  }
  set_shelves(task, shelves);
  return {};
}

}  // namespace marketgen::plan
