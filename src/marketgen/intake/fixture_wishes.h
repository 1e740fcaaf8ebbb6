// What the words want of the fixtures of a zone, kind by kind, and of the equipment at the doors.
#pragma once
#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "catalog/catalog.h"
#include "intake/understanding.h"

namespace marketgen::intake {

struct KindWish {
  const catalog::FixtureKind* kind = nullptr;
  std::optional<int> count;  // so many; nothing when the words leave it open
  int least = 0;             // no fewer: what the floor is measured for
  std::optional<int> runs;   // straight lines
  int sides = 0;             // of the lines: 1 or 2 when the words say so
};

// A number of one kind was not said: what "with coolers" stands for beside other fixtures.
constexpr int some_beside = 3;

// A requirement for no more than none of something.
bool asks_for_none(const plan::Requirement& wish);

// The kinds that the zone type is to have, in the order of the words; those that are refused are
// missing.
std::vector<KindWish> kind_wishes(const Understanding& found,
                                  const catalog::Catalog& catalog,
                                  std::string_view zone_type);

// Gives counted fixtures of no zone of their own, or of one that was refused, a zone to stand in:
// dump bins the offers, counters of a shop of meat alone its meat. Their wishes keep what is
// counted where (second_object).
void house_fixtures(Understanding& found, const catalog::Catalog& catalog);

// The kind is not to be anywhere, or not in that zone.
bool is_refused(const Understanding& found,
                const catalog::FixtureKind& kind,
                std::string_view zone_type);

// Kinds that many zones have, and what keeps the same goods where none is left.
constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kinds_of_many_zones = {
    {{"gondola", "wall_unit"}, {"multideck", "glass_door_cooler"}}};

// Lines of a kind that are counted in the store as a whole; null when they are not.
const plan::Requirement* runs_of_store(const Understanding& found, std::string_view kind);

// So many modules of such a kind, and no more, in the store as a whole; null when that is not said.
const plan::Requirement* count_of_store(const Understanding& found, std::string_view kind);

// Neither lanes nor machines: shoppers go to a desk.
bool wants_no_tills(const Understanding& found);

// What is to stand at the doors otherwise than usual.
std::vector<plan::EquipmentSpec> equipment_of(const Understanding& found,
                                              const catalog::Catalog& catalog);

}  // namespace marketgen::intake
