// How the goals of a run ended, by a name of their goods: category, shape or another.
#pragma once
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "episodes/episode_result.h"
#include "evaluation/store_bootstrap.h"

namespace marketgen::evaluation {

// What was in place at the end, before wrong items and void episodes are taken off.
struct GoodsRow {
  int asked = 0, reached = 0;
  std::set<std::string> skus;
  std::vector<ScoredEpisode> scores = {};  // one a goal
};

using NameOfGoods = std::function<std::string(const catalog::Product&)>;

// By name. Goods that the catalogue lacks are "unknown"; episodes that could not be run are left
// out.
std::map<std::string, GoodsRow> goods_rows(const std::vector<episodes::EpisodeResult>& results,
                                           const catalog::Catalog& catalog,
                                           const NameOfGoods& name);

}  // namespace marketgen::evaluation
