#include "intake/fixture_wishes.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace marketgen::intake {
namespace {

using Kind = plan::RequirementKind;

// Fewest and most that the words allow.
struct Bounds {
  int low = 0, high = std::numeric_limits<int>::max();

  void take(const plan::Requirement& wish) {
    const auto value = static_cast<int>(wish.value);
    if (wish.comparison != plan::Comparison::at_most) low = std::max(low, value);
    if (wish.comparison != plan::Comparison::at_least) high = std::min(high, value);
  }
  bool open() const { return high == std::numeric_limits<int>::max(); }
  // Halfway of "six to eight"; the most of "no more than four".
  int planned() const { return open() ? low : (low > 0 ? (low + high + 1) / 2 : high); }
};

struct SaidKind {
  KindWish wish;
  Bounds count, runs;
  bool counted = false, in_runs = false;
};

KindWish settled(const SaidKind& said) {
  KindWish wish = said.wish;
  constexpr int several =
      2;  // "at least eight" is met by eight; a kind that is only named is not counted
  if (said.counted && (!said.count.open() || said.count.low >= several))
    wish.count = said.count.planned();
  wish.least = said.counted ? said.count.planned() : 0;
  if (said.in_runs) wish.runs = std::max(1, said.runs.planned());
  if (wish.count && wish.runs) wish.count = std::max(*wish.count, *wish.runs);
  return wish;
}

// Of the store's doors, not of a zone.
bool stands_at_doors(const catalog::FixtureKind& kind, const plan::Requirement& wish) {
  return kind.role == catalog::FixtureRole::equipment && wish.object.empty() &&
         kind.generator != "pillar";
}

}  // namespace

bool asks_for_none(const plan::Requirement& wish) {
  return wish.comparison != plan::Comparison::at_least && wish.value <= 0;
}

std::vector<KindWish> kind_wishes(const Understanding& found,
                                  const catalog::Catalog& catalog,
                                  std::string_view zone_type) {
  std::vector<SaidKind> all;
  for (const plan::Requirement& wish : found.requirements) {
    const bool of_store = wish.kind == Kind::run_count && wish.second_object.empty() &&
                          runs_of_store(found, wish.subject) != nullptr;
    const bool number_of_store = wish.kind == Kind::fixture_count && wish.second_object.empty() &&
                                 count_of_store(found, wish.subject) != nullptr;
    const bool of_fixtures = wish.kind == Kind::fixture_count || wish.kind == Kind::run_count;
    if (!of_fixtures || of_store || wish.object != zone_type || asks_for_none(wish)) continue;
    const catalog::FixtureKind* kind = catalog.fixture_kind(wish.subject);
    if (kind == nullptr) continue;
    auto said =
        std::ranges::find_if(all, [&](const SaidKind& one) { return one.wish.kind == kind; });
    if (said == all.end()) {
      all.emplace_back().wish.kind = kind;
      said = std::prev(all.end());
    }
    if (number_of_store) continue;  // the zone has its part of it
    const bool runs = wish.kind == Kind::run_count;
    (runs ? said->runs : said->count).take(wish);
    (runs ? said->in_runs : said->counted) = true;
    if (runs) said->wish.sides = static_cast<int>(wish.second_value);
  }
  std::vector<KindWish> wishes;
  for (const SaidKind& said : all)
    wishes.push_back(settled(said));
  return wishes;
}

namespace {

// Where kinds stand that belong to no goods, when the words name no better place.
constexpr std::pair<std::string_view, std::string_view> usual_homes[] = {
    {"bin", "promo"}, {"pallet", "promo"}, {"promo_stack", "promo"}, {"peg_wall", "personal_care"}};

bool is_wanted(const Understanding& found, std::string_view zone) {
  return std::ranges::any_of(found.requirements, [&](const plan::Requirement& wish) {
    return wish.kind == Kind::zone_present && wish.subject == zone;
  });
}

bool holds_goods_like(const catalog::ZoneTypeRow& zone,
                      const catalog::FixtureKind& kind,
                      const catalog::Catalog& catalog) {
  const catalog::FixtureKind* usual = catalog.fixture_kind(zone.fixture);
  return usual != nullptr && usual->role == catalog::FixtureRole::shelving &&
         usual->temperature == kind.temperature;
}

// The zone that the words name and whose goods the kind keeps; else the kind's usual one.
std::string_view home_of(const Understanding& found,
                         const catalog::FixtureKind& kind,
                         const catalog::Catalog& catalog) {
  const auto usual = std::ranges::find(
      usual_homes, kind.kind, &std::pair<std::string_view, std::string_view>::first);
  const bool has_usual = usual != std::end(usual_homes);
  const auto refused = [&](std::string_view zone) {
    return found.find(Kind::zone_absent, zone) != nullptr;
  };
  if (has_usual && !refused(usual->second)) return usual->second;
  for (const catalog::ZoneTypeRow& zone : catalog.zone_types)
    if (is_wanted(found, zone.type) && !refused(zone.type) && holds_goods_like(zone, kind, catalog))
      return zone.type;
  return "";
}

}  // namespace

void house_fixtures(Understanding& found, const catalog::Catalog& catalog) {
  for (plan::Requirement& wish : found.requirements) {
    const bool counted = wish.kind == Kind::fixture_count || wish.kind == Kind::run_count;
    if (!counted || asks_for_none(wish) || !wish.second_object.empty()) continue;
    const catalog::FixtureKind* kind = catalog.fixture_kind(wish.subject);
    if (kind == nullptr || kind->role != catalog::FixtureRole::shelving) continue;
    const bool homeless = wish.object.empty() && kind->generator != "wall_unit";
    if (!homeless && found.find(Kind::zone_absent, wish.object) == nullptr) continue;
    if (const std::string_view home = home_of(found, *kind, catalog); !home.empty())
      wish.object = home;
  }
}

bool is_refused(const Understanding& found,
                const catalog::FixtureKind& kind,
                std::string_view zone_type) {
  return std::ranges::any_of(found.requirements, [&](const plan::Requirement& wish) {
    const bool here = wish.second_object.empty() || wish.second_object == zone_type;
    return wish.kind == Kind::fixture_count && wish.subject == kind.kind && here &&
           asks_for_none(wish);
  });
}

namespace {

// A number of the kind that is said of no zone.
template <class Suits>
const plan::Requirement* whole_number(const Understanding& found,
                                      Kind number,
                                      std::string_view kind,
                                      const Suits& suits) {
  const auto wish = std::ranges::find_if(found.requirements, [&](const plan::Requirement& one) {
    return one.kind == number && one.subject == kind && one.second_object.empty() &&
           !asks_for_none(one) && suits(one);
  });
  return wish == found.requirements.end() ? nullptr : &*wish;
}

}  // namespace

// Gondolas stand in many zones; other kinds belong to the one that their name implies.
const plan::Requirement* runs_of_store(const Understanding& found, std::string_view kind) {
  if (kind != "gondola") return nullptr;
  return whole_number(found, Kind::run_count, kind, [](const plan::Requirement&) { return true; });
}

const plan::Requirement* count_of_store(const Understanding& found, std::string_view kind) {
  const bool of_many =
      std::ranges::any_of(kinds_of_many_zones, [&](const auto& one) { return one.first == kind; });
  if (!of_many) return nullptr;
  return whole_number(found, Kind::fixture_count, kind, [](const plan::Requirement& wish) {
    return wish.comparison != plan::Comparison::at_least;
  });
}

bool wants_no_tills(const Understanding& found) {
  const auto refused = [&](std::string_view zone, std::string_view kind) {
    const plan::Requirement* count = found.find(Kind::fixture_count, kind);
    return found.find(Kind::zone_absent, zone) != nullptr ||
           (count != nullptr && asks_for_none(*count));
  };
  const plan::Requirement* machines = found.find(Kind::fixture_count, "self_checkout");
  const bool with_machines = found.find(Kind::zone_present, "self_checkout") != nullptr ||
                             (machines != nullptr && !asks_for_none(*machines));
  return refused("checkout", "checkout_lane") && !with_machines;
}

std::vector<plan::EquipmentSpec> equipment_of(const Understanding& found,
                                              const catalog::Catalog& catalog) {
  constexpr int max_equipment = 20;  // of EquipmentSpec::count
  std::vector<plan::EquipmentSpec> equipment;
  if (wants_no_tills(found)) equipment.push_back({"checkout_lane", 0, std::nullopt});
  for (const plan::Requirement& wish : found.requirements) {
    const catalog::FixtureKind* kind =
        wish.kind == Kind::fixture_count ? catalog.fixture_kind(wish.subject) : nullptr;
    if (kind == nullptr || !stands_at_doors(*kind, wish)) continue;
    plan::EquipmentSpec spec;
    spec.kind = wish.subject;
    spec.count = std::clamp(static_cast<int>(wish.value), 0, max_equipment);
    if (!wish.second_object.empty()) spec.at = wish.second_object;
    const auto known = std::ranges::find(equipment, spec.kind, &plan::EquipmentSpec::kind);
    if (known == equipment.end())
      equipment.push_back(std::move(spec));
    else if (wish.comparison != plan::Comparison::at_most)
      known->count = std::max(known->count, spec.count);
  }
  return equipment;
}

}  // namespace marketgen::intake
