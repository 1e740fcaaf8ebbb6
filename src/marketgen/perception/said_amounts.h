// Amounts in what people say.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/net_content.h"

namespace marketgen::perception {

struct SaidWords {
  std::vector<std::string> words;  // lower case, singular, without the amounts
  std::vector<catalog::NetContent> amounts;
  std::optional<double> count;  // that the text begins with: how many are wanted
};

// "two", "12", "1.5", lower case; empty for what is no number above 0.
std::optional<double> said_number(std::string_view word);

// Runs of letters and of numbers, lower case and singular: "1.5% Fat" is "1.5" and "fat".
std::vector<std::string> plain_words(std::string_view text);

// Takes a text apart. Amounts of mass and volume, also of several packs ("6 x 330 ml", "six times
// half a litre", "a kilo"), and numbers of things that `counted` names ("twenty bags"). A number
// with which it begins says how many are wanted, unless a measure follows ("500 g of pasta").
SaidWords said_words(std::string_view text, const std::vector<std::string>& counted);

}  // namespace marketgen::perception
