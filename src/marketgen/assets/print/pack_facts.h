// What the small print of a pack says: ingredients, nutrition, directions, claims, dates. Invented,
// but of the right kind and the same for the same row.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "assets/print/pack_art.h"

namespace marketgen::assets {

struct PackFacts {
  bool food = true;
  std::string contents;    // "Ingredients: …"
  std::string directions;  // storage or use
  std::vector<std::pair<std::string, std::string>>
      nutrition;  // name, amount per 100 g or ml; empty for non-food
  std::string nutrition_head;
  std::string best_before;  // "Best before 14.08.2027", "Use by 06.03.2026"; empty without a date
  std::string lot;
};

PackFacts pack_facts(const PackArt& art);

// A short claim that fits the goods: "No added sugar".
std::string claim_of(const PackArt& art, Stream& draw);

}  // namespace marketgen::assets
