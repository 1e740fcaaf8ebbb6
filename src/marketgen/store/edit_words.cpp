#include "store/edit_words.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <variant>

#include "io/file.h"
#include "layout/makes.h"
#include "store/edit.h"

namespace marketgen::store {
namespace {

constexpr std::string_view source = "--say";

plan::Wall entrance_of(const plan::Plan& plan) {
  const auto door =
      std::ranges::find(plan.shell.openings, plan::OpeningKind::entrance, &plan::Opening::kind);
  return door == plan.shell.openings.end() ? plan::Wall::south : door->wall;
}

std::map<std::string, int> modules_of(const plan::Plan& plan, const layout::Layout& layout) {
  std::map<std::string, int> modules;
  for (const layout::Fixture& fixture : layout.fixtures) {
    const plan::Zone* zone = plan::find_zone(plan, fixture.zone);
    if (zone != nullptr && layout::counts_as(layout, fixture, zone->fixture.kind))
      ++modules[zone->id];
  }
  return modules;
}

// What the wishes so far have made of the store.
struct Progressed {
  plan::PatchSet patches;
  plan::Plan plan;
  std::map<std::string, int> modules;
};

plan::PatchSet with(plan::PatchSet patches, const intake::Way& way) {
  patches.patches.insert(patches.patches.end(), way.begin(), way.end());
  return patches;
}

void advance(Progressed& now, plan::PatchSet patches, Replanned then) {
  now.modules = modules_of(then.plan, then.layout);
  now.plan = std::move(then.plan);
  now.patches = std::move(patches);
}

bool try_way(const Store& store,
             const intake::Way& way,
             const catalog::Catalog& catalog,
             Progressed& now) {
  plan::PatchSet patches = with(now.patches, way);
  Result<Replanned> then = replan(store, patches, std::string(source), catalog);
  if (!then.ok() || !then->offences.empty()) return false;
  advance(now, std::move(patches), std::move(then).value());
  return true;
}

// What was said before about places, as far as these offences come of it: a later word counts more.
// Nothing when something else is broken, too.
intake::Way without_broken_relations(const plan::Plan& plan,
                                     const std::vector<layout::Violation>& offences) {
  intake::Way way;
  for (const layout::Violation& offence : offences) {
    if (offence.code != "RELATION_BROKEN") return {};
    for (const plan::Relation& relation : plan.relations) {
      if (relation.strength != plan::Strength::must || relation.a != offence.where ||
          offence.message.find(relation.b) == std::string::npos)
        continue;
      plan::Patch patch;
      patch.set_relation = {
          relation.kind, relation.a, relation.b, relation.c, relation.strength, true};
      way.push_back(patch);
    }
  }
  return way;
}

// Takes the first way that keeps the hard rules. The error of the gentlest one when none does.
Result<void> take_way(const Store& store,
                      const intake::EditWish& wish,
                      const std::vector<intake::Way>& ways,
                      const catalog::Catalog& catalog,
                      Progressed& now) {
  std::optional<Error> refused;
  std::vector<intake::Way> overruling;  // with earlier words taken back
  for (const intake::Way& way : ways) {
    plan::PatchSet patches = with(now.patches, way);
    Result<Replanned> then = replan(store, patches, std::string(source), catalog);
    if (then.ok() && then->offences.empty()) {
      advance(now, std::move(patches), std::move(then).value());
      return {};
    }
    if (!refused) refused = then.ok() ? error_of(then->offences.front()) : then.error();
    if (!then.ok()) continue;
    intake::Way overruled = without_broken_relations(then->plan, then->offences);
    if (overruled.empty()) continue;
    std::ranges::copy(way, std::back_inserter(overruled));
    overruling.push_back(std::move(overruled));
  }
  for (const intake::Way& way : overruling) {
    if (try_way(store, way, catalog, now)) return {};
  }
  if (!refused) return {};
  refused->message = "\"" + wish.text + "\": " + refused->message;
  return *refused;
}

Error nothing_understood() {
  return {"brief.not_understood",
          std::string(source),
          "not one word of it asks for a change; say it as in \"swap dairy and bakery\", \"add two "
          "self-checkouts\", \"make the bakery 20 % larger\" (docs/editing.md has the words)"};
}

bool speaks_of(const intake::EditWish& wish, const std::string& zone_type) {
  return std::visit(
      [&](const auto& what) { return what.subject == zone_type || what.object == zone_type; },
      wish.what);
}

// "Snacks" in "6-tier shelves in the snacks" says where, and asks for nothing itself.
bool says_where(const intake::EditWish& wish, const std::vector<intake::EditWish>& all) {
  const auto* named = std::get_if<plan::Requirement>(&wish.what);
  if (named == nullptr || named->kind != plan::RequirementKind::zone_present) return false;
  return std::ranges::any_of(all, [&](const intake::EditWish& other) {
    return &other != &wish && speaks_of(other, named->subject);
  });
}

}  // namespace

Result<SaidPatches> patches_of_words(const Store& store,
                                     std::string_view words,
                                     const catalog::Catalog& catalog) {
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const intake::Language language, intake::Language::load_for_edits(data));
  MARKETGEN_TRY(intake::EditWords understood,
                intake::understand_edit(words, language, catalog, entrance_of(store.plan)));
  SaidPatches said;
  said.unparsed = std::move(understood.unparsed);
  said.conflicts = std::move(understood.conflicts);
  Progressed now{{}, store.plan, modules_of(store.plan, store.scene.layout)};
  for (const intake::EditWish& wish : understood.wishes) {
    const Result<std::vector<intake::Way>> ways =
        intake::ways_to(wish, {now.plan, catalog, now.modules});
    if (!ways.ok() && ways.error().code == "usage.unavailable") {
      said.unparsed.push_back({wish.text, wish.span});
      continue;
    }
    if (!ways.ok()) return ways.error();
    if (ways->front().empty()) {
      if (!says_where(wish, understood.wishes)) said.so_already.push_back(wish.text);
      continue;
    }
    MARKETGEN_CHECK(take_way(store, wish, *ways, catalog, now));
  }
  said.patches = std::move(now.patches);
  if (said.patches.patches.empty() && said.so_already.empty()) return nothing_understood();
  return said;
}

}  // namespace marketgen::store
