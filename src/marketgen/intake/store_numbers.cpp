#include "intake/store_numbers.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace marketgen::intake {
namespace {

// A number of one kind that is said of the store as a whole.
struct StoreNumber {
  const catalog::FixtureKind* kind = nullptr;
  const catalog::FixtureKind* instead = nullptr;  // in zones for which none is left
  int number = 0;
  bool runs = false;  // straight lines, else modules
  int sides = 0;      // of the lines
};

KindWish part_of(const StoreNumber& said, int number) {
  KindWish wish{said.kind, std::nullopt, 0, std::nullopt, said.sides};
  if (said.runs)
    wish.runs = number;
  else
    wish.count = wish.least = number;
  return wish;
}

// By their floors; at least one each where there are so many.
void share_among_zones(StoreProgram& program, const StoreNumber& said) {
  std::vector<ProgramZone*> open;
  int left = said.number;
  double floor_m2 = 0;
  for (ProgramZone& zone : program.zones) {
    if (zone.kind != said.kind) continue;
    if (const std::optional<int> own = said.runs ? zone.main.runs : zone.main.count) {
      left -= *own;
      continue;
    }
    if (!said.runs && zone.main.runs) continue;  // its lines are counted
    open.push_back(&zone);
    floor_m2 += zone.target_m2;
  }
  std::ranges::stable_sort(open, std::greater<>(), [](ProgramZone* z) { return z->target_m2; });
  for (std::size_t i = 0; i < open.size(); ++i) {
    ProgramZone& zone = *open[i];
    const auto others = static_cast<int>(open.size() - i) - 1;
    const double share = floor_m2 > 0 ? zone.target_m2 / floor_m2 : 1;
    const int fair = i + 1 == open.size() ? left : static_cast<int>(std::lround(left * share));
    const int number =
        std::clamp(fair, std::min(1, left), std::max(std::min(1, left), left - others));
    floor_m2 -= zone.target_m2;
    left -= std::max(0, number);
    if (number > 0) {
      zone.main = part_of(said, number);
      if (!said.runs) zone.count = number;
      continue;
    }
    zone.kind = said.instead;
    zone.stance = stance_of(*zone.type, zone.kind);
  }
}

}  // namespace

void share_numbers_of_store(StoreProgram& program,
                            const Understanding& found,
                            const catalog::Catalog& catalog) {
  for (const auto& [name, instead] : kinds_of_many_zones) {
    StoreNumber said{catalog.fixture_kind(name), catalog.fixture_kind(instead)};
    if (said.kind == nullptr || said.instead == nullptr) continue;
    if (const plan::Requirement* runs = runs_of_store(found, name)) {
      said.runs = true;
      said.number = static_cast<int>(runs->value);
      said.sides = static_cast<int>(runs->second_value);
      share_among_zones(program, said);
    } else if (const plan::Requirement* count = count_of_store(found, name)) {
      said.number = static_cast<int>(count->value);
      share_among_zones(program, said);
    }
  }
}

}  // namespace marketgen::intake
