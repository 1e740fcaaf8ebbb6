#include "evaluation/goals_table.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/build_info.h"
#include "base/interrupt.h"
#include "base/parallel.h"
#include "environments/environment_entry.h"
#include "episodes/track_entry.h"

namespace marketgen::evaluation {
namespace {

using Groups = std::map<std::string, GoalGroup>;

using Chances = std::vector<episodes::GoalChance>;

struct StoreOffer {
  const store::Store* store = nullptr;
  std::vector<catalog::Product> stock = {};
  std::vector<Chances> chances = {};  // variant by variant, of each of the stock
};

Result<std::vector<GoalVariant>> variants_in(const std::filesystem::path& data) {
  std::vector<GoalVariant> variants;
  for (const episodes::Track track : episodes::all_tracks) {
    MARKETGEN_TRY(const episodes::TrackRobot row, episodes::entry_of(track).robot(data));
    if (row.tools.empty()) variants.push_back({track});
    for (const std::string& tools : row.tools) {
      variants.push_back({track, tools});
      const auto own = episodes::entry_of(track).own_fields();
      if (std::ranges::find(own, "doors") != own.end())
        variants.push_back({track, tools, episodes::Doors::hinged});
    }
  }
  return variants;
}

Result<Chances> chances_in(const StoreOffer& offer, environments::EpisodeSampler& sampler) {
  const std::vector<catalog::Product>& stock = offer.stock;
  const episodes::EpisodeStore row = environments::store_row(*offer.store);
  const auto of_store = sampler.of_store({row.name, row.scene_hash, row.plan_hash});
  if (!of_store.ok() && of_store.error().code == "episode.impossible")
    return Chances(stock.size(), {"impossible"});
  if (!of_store.ok()) return of_store.error();
  const auto found = parallel_map(stock.size(), [&](std::size_t i) {
    return std::make_shared<Result<episodes::GoalChance>>((*of_store)->goal_chance(stock[i]));
  });
  Chances chances;
  for (const auto& chance : found) {
    if (!chance->ok()) return chance->error();
    chances.push_back(chance->value());
  }
  return chances;
}

Result<void> add_chances(std::vector<StoreOffer>& offers, environments::EpisodeSampler& sampler) {
  for (StoreOffer& offer : offers) {
    MARKETGEN_TRY(Chances found, chances_in(offer, sampler));
    offer.chances.push_back(std::move(found));
  }
  return {};
}

// Whether it is taken off one of these fixtures.
bool is_taken_off(const episodes::GoalChance& chance, const std::set<std::uint32_t>& fixtures) {
  if (!chance.why_not.empty()) return false;
  return !chance.fixtures || std::ranges::any_of(fixtures, [&](std::uint32_t fixture) {
    return chance.fixtures->contains(fixture);
  });
}

// Adds up the stores.
class GoalCount {
 public:
  explicit GoalCount(std::vector<GoalVariant> variants) : variants_(std::move(variants)) {
    all_ = begun("");
    reasons_.resize(variants_.size());
  }

  void add(const StoreOffer& offer) {
    for (std::size_t i = 0; i < offer.stock.size(); ++i) {
      std::vector<bool> may;
      for (std::size_t variant = 0; variant < variants_.size(); ++variant) {
        const std::string& why_not = offer.chances[variant][i].why_not;
        may.push_back(why_not.empty());
        if (!why_not.empty()) ++reasons_[variant][why_not];
      }
      count(may, all_);
      count(may, group(categories_, offer.stock[i].category));
      count(may, group(shapes_, offer.stock[i].archetype));
    }
    add_fixtures(offer);
  }

  GoalsTable table() && {
    GoalsTable table;
    table.version = std::string(program_version);
    table.all = all_;
    table.categories = listed(categories_);
    table.shapes = listed(shapes_);
    table.fixtures = listed(fixtures_);
    for (std::size_t variant = 0; variant < variants_.size(); ++variant) {
      for (const auto& [why, products] : reasons_[variant])
        variants_[variant].left_out.push_back({why, products});
      std::ranges::stable_sort(
          variants_[variant].left_out, std::greater<>{}, &episodes::EpisodeExclusion::products);
    }
    table.variants = std::move(variants_);
    return table;
  }

 private:
  GoalGroup begun(const std::string& name) const {
    return {name, 0, std::vector<int>(variants_.size()), 0};
  }

  GoalGroup& group(Groups& groups, const std::string& name) const {
    return groups.try_emplace(name, begun(name)).first->second;
  }

  static void count(const std::vector<bool>& may, GoalGroup& group) {
    ++group.on_offer;
    for (std::size_t variant = 0; variant < may.size(); ++variant)
      if (may[variant]) ++group.goals[variant];
    if (std::ranges::find(may, true) != may.end()) ++group.any;
  }

  void add_fixtures(const StoreOffer& offer) {
    const scene::Scene& scene = offer.store->scene;
    std::map<std::string, std::map<std::string, std::set<std::uint32_t>>> kinds;  // by SKU
    for (const scene::SceneProduct& item : scene.products) {
      const std::uint32_t fixture = scene.shelves[scene.facings[item.facing].shelf].fixture;
      kinds[scene.catalog[item.sku].sku][scene.layout.fixtures[fixture].kind].insert(fixture);
    }
    for (std::size_t i = 0; i < offer.stock.size(); ++i) {
      for (const auto& [kind, fixtures] : kinds[offer.stock[i].sku]) {
        std::vector<bool> may;
        for (const Chances& of_variant : offer.chances)
          may.push_back(is_taken_off(of_variant[i], fixtures));
        count(may, group(fixtures_, kind));
      }
    }
  }

  static std::vector<GoalGroup> listed(const Groups& groups) {
    std::vector<GoalGroup> list;
    for (const auto& [name, group] : groups)
      list.push_back(group);
    return list;
  }

  std::vector<GoalVariant> variants_;
  GoalGroup all_;
  Groups categories_, shapes_, fixtures_;
  std::vector<std::map<std::string, int>> reasons_;  // by variant
};

std::string called(const GoalVariant& variant) {
  std::string text(name_of(variant.track));
  if (!variant.tools.empty()) text += " " + variant.tools;
  return variant.doors ? text + " doors" : text;
}

std::string share_text(int number, int of) {
  return fmt::format("{} ({:.0f})", number, of == 0 ? 0.0 : 100.0 * number / of);
}

std::vector<std::string> cells(const std::string& kind, const GoalGroup& group) {
  std::vector<std::string> row{kind, group.name, std::to_string(group.on_offer)};
  for (const int goals : group.goals)
    row.push_back(share_text(goals, group.on_offer));
  row.push_back(share_text(group.any, group.on_offer));
  return row;
}

std::string with_goals(const std::string& kinds, const std::vector<GoalGroup>& groups) {
  const auto some = static_cast<int>(
      std::ranges::count_if(groups, [](const GoalGroup& group) { return group.any > 0; }));
  return fmt::format("{} with a goal in some variant: {} of {}.", kinds, some, groups.size());
}

}  // namespace

Result<GoalsTable> goals_table(const store::OpenedStores& opened,
                               const std::filesystem::path& data) {
  const episodes::EpisodeHeader header;
  environments::Arena arena(data, header, opened.catalog);
  std::vector<StoreOffer> offers;
  for (const auto& store : opened.stores) {
    arena.offer(store);
    offers.push_back({store.get(), episodes::store_stock(store->scene)});
  }
  MARKETGEN_TRY(std::vector<GoalVariant> variants, variants_in(data));
  for (const GoalVariant& variant : variants) {
    const auto& entry = environments::environment_entry_of(variant.track);
    episodes::DrawRules rules;
    rules.doors = variant.doors.value_or(episodes::Doors::none);
    MARKETGEN_TRY(const auto sampler, entry.sampler(arena, variant.tools, rules));
    const Result<void> added = until_interrupted([&] { return add_chances(offers, *sampler); });
    const NoForcedEnd keeping;  // what was studied until then
    MARKETGEN_CHECK(sampler->keep());
    if (!added.ok()) return added.error();
  }
  GoalCount count(std::move(variants));
  for (const StoreOffer& offer : offers)
    count.add(offer);
  GoalsTable table = std::move(count).table();
  for (const StoreOffer& offer : offers)
    table.stores.push_back(offer.store->manifest.name);
  return table;
}

TextTable text_of(const GoalsTable& table) {
  TextTable text{{"by", "name", "on offer"}, {}, {}};
  for (const GoalVariant& variant : table.variants)
    text.columns.push_back(called(variant) + " (%)");
  text.columns.emplace_back("any (%)");
  text.rows.push_back(cells("all", table.all));
  for (const GoalGroup& group : table.categories)
    text.rows.push_back(cells("category", group));
  for (const GoalGroup& group : table.shapes)
    text.rows.push_back(cells("shape", group));
  for (const GoalGroup& group : table.fixtures)
    text.rows.push_back(cells("fixture", group));
  text.notes.push_back(with_goals("Categories", table.categories));
  text.notes.push_back(with_goals("Shapes", table.shapes));
  text.notes.push_back(with_goals("Kinds of fixtures", table.fixtures));
  for (const GoalVariant& variant : table.variants) {
    std::vector<std::string> reasons;
    for (const episodes::EpisodeExclusion& reason : variant.left_out)
      reasons.push_back(fmt::format("{} {}", reason.reason, reason.products));
    text.notes.push_back(fmt::format("Not for {}: {}.", called(variant), fmt::join(reasons, ", ")));
  }
  text.notes.push_back(fmt::format("{} stores, version {}; products counted store by store.",
                                   table.stores.size(),
                                   table.version));
  return text;
}

}  // namespace marketgen::evaluation
