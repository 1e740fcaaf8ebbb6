// Requests as tests ask them, of the committed catalogue.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "shopping/check_shopping.h"
#include "shopping/shopping_planner.h"
#include "support/committed_catalog.h"

namespace marketgen {

inline const shopping::ShoppingKnowledge& knowledge() {
  static const shopping::ShoppingKnowledge known = [] {
    auto loaded = shopping::ShoppingKnowledge::load(
        committed_catalog(), std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data");
    if (!loaded.ok()) fatal(to_string(loaded.error()).c_str());
    return std::move(loaded).value();
  }();
  return known;
}

// A store with every `step`th row of the catalogue, from the `first` on.
inline shopping::Assortment every_row(std::size_t step = 1, std::size_t first = 0) {
  shopping::Assortment assortment;
  const std::vector<catalog::Product>& rows = committed_catalog().products;
  for (std::size_t i = first; i < rows.size(); i += step)
    assortment.products.push_back(rows[i]);
  return assortment;
}

inline shopping::ShoppingRequest read(const std::string& words) {
  auto request = shopping::read_request(words, knowledge());
  EXPECT_TRUE(request.ok()) << words << ": " << (request.ok() ? "" : to_string(request.error()));
  return request.ok() ? *request : shopping::ShoppingRequest{};
}

inline shopping::ShoppingPlan planned(const shopping::ShoppingRequest& request,
                                      const shopping::Assortment& assortment) {
  auto plan = shopping::plan_shopping(request, assortment, knowledge());
  EXPECT_TRUE(plan.ok()) << request.words << ": " << (plan.ok() ? "" : to_string(plan.error()));
  return plan.ok() ? *plan : shopping::ShoppingPlan{};
}

// The fault that the checker finds; empty for none.
inline std::string fault(const shopping::ShoppingPlan& plan,
                         const shopping::ShoppingRequest& request,
                         const shopping::Assortment& assortment) {
  const auto checked = shopping::check_shopping(plan, request, assortment, knowledge());
  return checked.ok() ? "" : to_string(checked.error());
}

inline const shopping::ShoppingLine* line_for(const shopping::ShoppingPlan& plan,
                                              const std::string& part) {
  for (const shopping::ShoppingLine& line : plan.lines)
    if (std::ranges::find(line.answers, part) != line.answers.end()) return &line;
  return nullptr;
}

inline const shopping::UnmetPart* unmet_of(const shopping::ShoppingPlan& plan,
                                           const std::string& part) {
  const auto found = std::ranges::find(plan.unmet, part, &shopping::UnmetPart::part);
  return found == plan.unmet.end() ? nullptr : &*found;
}

}  // namespace marketgen
