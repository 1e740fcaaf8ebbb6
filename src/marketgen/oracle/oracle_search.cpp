#include "oracle/oracle_search.h"

namespace marketgen::oracle {
namespace {

OracleSearch plain() {
  OracleSearch search;
  search.rehearses = false;
  return search;
}

OracleSearch thorough() {
  OracleSearch search;
  search.other_order = true;
  search.max_grasps = 72;
  search.max_plans = 16;
  search.max_place_searches = 36;
  search.max_rehearsals = 20;
  search.max_rehearsals_of_item = 6;
  search.max_item_tries = 5;
  search.max_unreached = 4;
  search.max_rehearsals_here = 8;
  search.max_items_looked_at = 10;
  return search;
}

}  // namespace

std::optional<OracleSearch> oracle_search(std::string_view policy) {
  if (policy == "oracle") return OracleSearch{};
  if (policy == "oracle-plain") return plain();
  if (policy == "oracle-thorough") return thorough();
  return std::nullopt;
}

}  // namespace marketgen::oracle
